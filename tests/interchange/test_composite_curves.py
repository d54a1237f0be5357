"""Curves that a file makes of others: joined where the ends of their parts meet, and otherwise read in parts."""

import pytest
from gmpy2 import mpq

from exactspline import read
from exactspline.extras.cad.iges import formatted
from tests.interchange.test_formats_and_features import step

POINTS = "".join(
    f"#{i}=CARTESIAN_POINT('',({x},{y},0.));"
    for i, (x, y) in enumerate([("0.", "0."), ("2.", "2."), ("4.", "0."), ("4.", "2."), ("4.000000001", "2.")], 1)
)
#: A quadratic from (0, 0) to (4, 0) over [2, 5], a line from (4, 2) to (4, 0), and one that begins 10⁻⁹ beside it.
PARTS = POINTS + (
    "#10=B_SPLINE_CURVE_WITH_KNOTS('q',2,(#1,#2,#3),.UNSPECIFIED.,.F.,.F.,(3,3),(2.,5.),.UNSPECIFIED.);"
    "#11=POLYLINE('',(#4,#3));#12=POLYLINE('',(#5,#1));#13=POLYLINE('',(#4,#2));"
)


def composite(*parts):
    """A composite curve of curves with their senses."""
    segments = [f"#{20 + i}=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.{s}.,#{n});" for i, (n, s) in enumerate(parts)]
    listed = ",".join(f"#{20 + i}" for i in range(len(parts)))
    return step(f"{PARTS}{''.join(segments)}#30=COMPOSITE_CURVE('outline',({listed}),.F.);")


def of(text, **options):
    return read(text.encode() if isinstance(text, str) else text, **options)


def test_parts_that_meet_are_one_curve_over_their_parameters_one_after_the_other():
    found = of(composite((10, "T"), (11, "F")))
    named = next(each for each in found.curves if each.name == "outline")
    assert not found.skipped
    # 12 and 13 belong to nothing
    assert [each.name for each in found.curves] == ["#12", "#13", "outline"]
    curve = named.curve
    assert (curve.domain, curve.breakpoints, curve.degree) == ((2, 6), (2, 5, 6), 2)
    assert named.notes == ("made of 2 curves",)
    assert [curve(t) for t in (2, mpq(7, 2), 5, mpq(11, 2))] == [(0, 0, 0), (2, 1, 0), (4, 0, 0), (4, 1, 0)]
    assert curve(6, "left") == (4, 2, 0)


def test_weights_and_degrees_are_brought_together():
    """A quarter of a circle, which is rational, behind a line."""
    more = (
        "#40=DIRECTION('',(0.,0.,1.));#41=DIRECTION('',(1.,0.,0.));#42=AXIS2_PLACEMENT_3D('',#1,#40,#41);"
        "#43=CIRCLE('',#42,4.);#44=TRIMMED_CURVE('',#43,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.570796326794897)),.T.,"
        ".PARAMETER.);#45=POLYLINE('',(#1,#3));#46=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#45);"
        "#47=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#44);#48=COMPOSITE_CURVE('sector',(#46,#47),.F.);"
    )
    curve = next(x.curve for x in of(step(PARTS + more)).curves if x.name == "sector")
    assert curve(mpq(1, 2)) == (2, 0, 0)
    for k in range(9):
        x, y, _ = curve(1 + (curve.domain[1] - 1) * mpq(k, 8), "left" if k == 8 else "right")
        assert x * x + y * y == 16
    assert curve(curve.domain[1], "left") == (0, 4, 0)


def test_ends_that_nearly_meet_are_joined_within_an_error():
    text = composite((10, "T"), (11, "F"), (12, "T"))
    found = of(text)
    [skipped] = found.skipped
    assert not any(each.name == "outline" for each in found.curves)
    assert skipped.what == "COMPOSITE_CURVE"
    assert skipped.where == "#30"
    assert skipped.why == (
        "its parts are read as separate curves: an end 1.00E-9 away from the part before; correct it; "
        "--approximate E takes one within E"
    )
    assert found.complete
    near = of(text, approximate="1e-8")
    named = next(each for each in near.curves if each.name == "outline")
    assert named.notes == ("made of 3 curves", "an end is moved by 1.00E-9 onto the part before")
    assert named.curve(6) == (4, 2, 0)
    assert named.curve.closed
    assert not of(text, approximate="1e-10").complete or of(text, approximate="1e-10").skipped


@pytest.mark.parametrize("parts", [[(10, "T"), (13, "F")], [(10, "T"), (99, "T")], [(10, "T"), (1, "T")], []])
def test_parts_that_do_not_meet_or_are_not_read_stay(parts):
    found = of(composite(*parts))
    assert [(x.what, x.curve) for x in found.skipped] == [("COMPOSITE_CURVE", False)]
    assert {"q", "#11", "#12", "#13"} == {each.name for each in found.curves}
    assert "its parts are read" in found.skipped[0].why


def in_iges(second, matrix=""):
    """Two lines and a curve made of them."""
    entities = [
        (110, 0, 0, "A", ["0.", "0.", "0.", "1.", "0.", "0."]),
        (110, 0, 0, "B", [*second, "0.", "3.", "3.", "0."]),
        (102, 0, 0, "C", ["2", "1", "3"]),
        (124, 0, 0, "", ["1.", "0.", "0.", "5.", "0.", "1.", "0.", "0.", "0.", "0.", "1.", "0."]),
    ]
    text = formatted(entities, "t").decode()
    if matrix:
        head = [line for line in text.splitlines() if line[72] == "D"][4]
        text = text.replace(head, head[:48] + f"{matrix:>8}" + head[56:])
    return text


def test_composite_curves_of_iges():
    [named] = of(in_iges(["1.", "0."])).curves
    assert (named.name, named.notes) == ("C 5", ("made of 2 curves",))
    assert [named.curve(t) for t in (0, 1)] == [(0, 0, 0), (1, 0, 0)]
    assert named.curve(2, "left") == (3, 3, 0)
    for text, why in ((in_iges(["1.", "1."]), "an end 1 away from the part before"),
                      (in_iges(["1.", "0."], "7"), "moved as a whole")):  # fmt: skip
        found = of(text)
        assert [each.name for each in found.curves] == ["A 1", "B 3"]
        assert why in found.skipped[0].why
