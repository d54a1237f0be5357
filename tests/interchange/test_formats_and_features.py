"""The table format × feature of docs/formats.md: every cell is read here, from a file made by this test."""

import json
import math
import re
from itertools import groupby
from pathlib import Path

import pytest
from gmpy2 import mpq

from exactspline import read
from exactspline.extras.cad.iges import formatted
from tests.support.interchange_seeds import GLIF, dxf, truetype

PAGE = Path(__file__).resolve().parents[2] / "docs" / "formats.md"
FEATURES = ("periodic", "one period", "left out", "closed flag", "arc", "approximate", "trimmed", "part",
            "tilted plane", "several contours", "names", "units")  # fmt: skip
E = mpq(1, 10**9)
#: A closed cubic by its four different control points.
FOUR = [(0, 0), (3, 1), (2, 4), (-1, 2)]
UNIFORM = list(range(-3, 8))


def spline(format, degree, knots, points, *, name="", flags=""):
    """A file with one spline in the plane, flagged with the words in `flags`."""
    return WRITERS[format](degree, knots, points, name, flags)


def in_json(degree, knots, points, name, flags):
    return json.dumps({"name": name, "degree": degree, "knots": knots, "control_points": points})


def in_itd(degree, knots, points, name, flags):
    kind = "KVP" if "periodic" in flags else "KV"
    rows = " ".join(f"[{x} {y}]" for x, y in points)
    listed = " ".join(map(str, knots))
    return f"[OBJECT {name or 'o'} [CURVE BSPLINE {len(points)} {degree + 1} E2 [{kind} {listed}] {rows}]]"


def in_geomdl(degree, knots, points, name, flags):
    held = {"degree": degree, "knotvector": knots, "control_points": {"points": points}, "name": name}
    return json.dumps({"shape": {"type": "curve", "data": [held | {"type": "spline"}]}})


def in_gismo(degree, knots, points, name, flags):
    vector = f'<KnotVector degree="{degree}">{" ".join(map(str, knots))}</KnotVector>'
    rows = " ".join(f"{x} {y}" for x, y in points)
    basis = f'<Basis type="BSplineBasis">{vector}</Basis><coefs geoDim="2">{rows}</coefs>'
    return f'<xml><Geometry type="BSpline" id="1" label="{name}">{basis}</Geometry></xml>'


def in_g2(degree, knots, points, name, flags):
    rows = "\n".join(f"{x} {y}" for x, y in points)
    return f"100 1 0 0\n2 0\n{len(points)} {degree + 1}\n{' '.join(map(str, knots))}\n{rows}\n"


def in_brep(degree, knots, points, name, flags):
    pairs = [(t, len(list(same))) for t, same in groupby(knots)]
    rows, listed = ("  ".join(f"{a} {b}" for a, b in each) for each in (points, pairs))
    counts = f"{degree} {len(points)} {len(pairs)}"
    head = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nCurve2ds 1\n"
    return f"{head}7 0 {int('periodic' in flags)}  {counts}  {rows}\n {listed}\nCurves 0\n"


def in_dxf(degree, knots, points, name, flags):
    bits = 8 + 2 * ("periodic" in flags) + ("closed" in flags)
    words = f"0 SPLINE 5 {name or 'A'} 70 {bits} 71 {degree} 72 {len(knots)} 73 {len(points)}"
    words += "".join(f" 40 {t}" for t in knots) + "".join(f" 10 {x} 20 {y}" for x, y in points)
    return dxf(words).decode()


def in_step(degree, knots, points, name, flags):
    pairs = [(t, len(list(same))) for t, same in groupby(knots)]
    poles = "".join(f"#{i}=CARTESIAN_POINT('',({x}.,{y}.,0.));" for i, (x, y) in enumerate(points, 1))
    references = ",".join(f"#{i}" for i in range(1, len(points) + 1))
    values, times = ",".join(f"{t}." for t, _ in pairs), ",".join(str(n) for _, n in pairs)
    told = f"{degree},({references}),.UNSPECIFIED.,.{'T' if 'closed' in flags else 'F'}.,.F."
    return step(f"{poles}#90=B_SPLINE_CURVE_WITH_KNOTS('{name}',{told},({times}),({values}),.UNSPECIFIED.);")


def step(data):
    return f"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"


def in_iges(degree, knots, points, name, flags):
    last, closed, periodic = len(points) - 1, int("closed" in flags), int("periodic" in flags)
    values = [last, degree, 1, closed, 1, periodic, *knots, *[1] * len(points)]
    values += [x for point in points for x in (*point, 0)]
    values += [0.25, 0.75] if "trimmed" in flags else [knots[degree], knots[-degree - 1]]
    listed = [*map(str, values[:6]), *(f"{x:.3f}" for x in [*values[6:], 0, 0, 1])]
    return formatted([(126, 0, 0, name, listed)], "t").decode()


WRITERS = {"json": in_json, "g2": in_g2, "itd": in_itd, "geomdl": in_geomdl, "gismo": in_gismo, "iges": in_iges,
           "step": in_step, "brep": in_brep, "dxf": in_dxf}  # fmt: skip


# ---- what is to be seen


def is_smooth_and_closed(curve, domain=(0, 4)):
    """Closed, with equal derivatives up to the second at the seam."""
    assert curve.domain == domain
    for order in (0, 1, 2):
        assert curve.derivative(order, domain[0]) == curve.derivative(order, domain[1], "left")
    # the middle of the third span, by the weights of a uniform cubic
    p = [*FOUR, *FOUR][2:6]
    weights = (mpq(1, 48), mpq(23, 48), mpq(23, 48), mpq(1, 48))
    middle = [sum((w * q[i] for w, q in zip(weights, p, strict=True)), mpq(0)) for i in (0, 1)]
    assert list(curve(mpq(5, 2))[:2]) == middle


def one(data, *, within=None):
    data = data if isinstance(data, bytes) else data.encode()
    reading = read(data, approximate=within)
    assert not reading.skipped, reading.skipped
    assert len(reading.curves) == 1
    return reading.curves[0], reading


def periodic(format):
    if format == "3dm":
        named, _ = one(rhino(uniform_of_rhino))
    else:
        named, _ = one(spline(format, 3, UNIFORM, [*FOUR, *FOUR[:3]], flags="periodic" if format == "dxf" else ""))
    is_smooth_and_closed(named.curve)


def one_period(format):
    flags = "periodic" if format == "brep" else ""
    named, _ = one(spline(format, 3, list(range(5)), FOUR, flags=flags))
    is_smooth_and_closed(named.curve)
    assert any("one period" in note for note in named.notes)


def left_out(format):
    named, _ = one(spline(format, 3, UNIFORM, FOUR, flags="periodic" if format == "itd" else ""))
    is_smooth_and_closed(named.curve)
    assert any("control points are repeated" in note for note in named.notes)


def closed_flag(format):
    clamped = [0, 0, 0, 0, 1, 1, 1, 1]
    named, _ = one(spline(format, 3, clamped, [(0, 0), (1, 1), (2, 1), (3, 4)], flags="closed"))
    assert "flagged closed, but its ends are 5 apart: read as written" in named.notes
    named, _ = one(spline(format, 3, clamped, [(0, 0), (1, 1), (2, 1), (0, 0)], flags="closed"))
    assert not any("closed" in note for note in named.notes)


def names(format):
    if format in NAMED:
        data = NAMED[format]()
        name = read(data if isinstance(data, bytes) else data.encode()).curves[0].name
    else:
        name = one(spline(format, 1, [0, 0, 1, 1], [(0, 0), (1, 1)], name="rib"))[0].name
    assert "rib" in name


NAMED = {
    "svg": lambda: svg('<path id="rib" d="M0 0L1 1"/>'),
    "glif": lambda: GLIF.replace(b'name="a"', b'name="rib"'),
    "3dm": lambda: rhino(uniform_of_rhino),
}


DXF_ARC = "0 ARC 10 1 20 2 40 5 50 {} 51 {}"
PLACED = (
    "#1=CARTESIAN_POINT('',(1.,2.,0.));#2=AXIS2_PLACEMENT_3D('',#1,$,$);#3=CIRCLE('c',#2,5.);"
    "#4=VERTEX_POINT('',#5);#6=VERTEX_POINT('',#7);#8=EDGE_CURVE('e',#4,#6,#3,.T.);"
)
EDGE = PLACED + "#5=CARTESIAN_POINT('',({}));#7=CARTESIAN_POINT('',({}));"


def iges_arc(*numbers):
    return formatted([(100, 0, 0, "", [f"{x:.12f}" for x in numbers])], "t").decode()


def rhino(curve):
    """An archive with one curve of rhino3dm, in millimetres, called rib."""
    rhino3dm = pytest.importorskip("rhino3dm")
    model, attributes = rhino3dm.File3dm(), rhino3dm.ObjectAttributes()
    model.Settings.ModelUnitSystem, attributes.Name = rhino3dm.UnitSystem.Millimeters, "rib"
    model.Objects.AddCurve(curve(rhino3dm), attributes)
    return bytes(model.Encode3dm()) if hasattr(model, "Encode3dm") else written(model)


def written(model):
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        assert model.Write(f"{folder}/a.3dm", 7)
        return Path(f"{folder}/a.3dm").read_bytes()


def uniform_of_rhino(rhino3dm):
    """The closed cubic, without its first and last knot."""
    made = rhino3dm.NurbsCurve(3, False, 4, 7)
    for i, (x, y) in enumerate([*FOUR, *FOUR[:3]]):
        made.Points[i] = rhino3dm.Point4d(x, y, 0, 1)
    for i, t in enumerate(UNIFORM[1:-1]):
        made.Knots[i] = t
    return made


def rhino_arc(angle):
    def made(rhino3dm):
        return rhino3dm.ArcCurve.CreateFromArc(rhino3dm.Arc(rhino3dm.Point3d(1, 2, 0), 5.0, angle))

    return lambda: rhino(made)


def svg(inside):
    return f'<svg xmlns="http://www.w3.org/2000/svg">{inside}</svg>'


#: A quarter of a circle of radius 5 around (1, 2), from angle 0.
QUARTERS = {
    "dxf": lambda: dxf(DXF_ARC.format(0, 90)),
    "iges": lambda: iges_arc(0, 1, 2, 6, 2, 1, 7),
    "step": lambda: step(EDGE.format("6.,2.,0.", "1.,7.,0.")),
    "3dm": rhino_arc(math.pi / 2),
    "svg": lambda: svg('<path d="M6 2A5 5 0 0 1 1 7"/>'),
    # the full circle: an edge would use a part of it
    "brep": lambda: in_brep_text("2 1 2 0 0 0 1 1 0 0 0 1 0 5"),
}
#: A part of it that ends at 30 degrees, at which both coordinates are irrational.
THIRDS = {
    "dxf": lambda: dxf(DXF_ARC.format(0, 30)),
    "iges": lambda: iges_arc(0, 1, 2, 6, 2, 1 + 5 * math.cos(math.pi / 6), 4.5),
    "step": lambda: step(EDGE.format("6.,2.,0.", f"{1 + 5 * math.cos(math.pi / 6):.12f},4.5,0.")),
    "3dm": rhino_arc(math.pi / 6),
    "brep": lambda: in_brep_text(f"8 0 {math.pi / 6!r}\n2 1 2 0 0 0 1 1 0 0 0 1 0 5"),
}


def in_brep_text(curve):
    """A BRep file with one curve in space."""
    head = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nCurve2ds 0\nCurves 1\n"
    return f"{head}{curve}\nPolygon3D 0\n"


def arc(format):
    named, _ = one(QUARTERS[format]())
    curve = named.curve
    ends = [curve(t) for t in curve.domain]
    assert [(x - 1, y - 2) for x, y, *_ in ends] == [(5, 0), (5, 0) if format == "brep" else (0, 5)]
    for k in range(9):
        x, y, *_ = curve(curve.domain[0] + (curve.domain[1] - curve.domain[0]) * mpq(k, 8))
        assert (x - 1) ** 2 + (y - 2) ** 2 == 25


def approximate(format):
    if format == "svg":
        # its ends stay, and its centre moves
        data = svg('<path d="M0 0A5 5 0 0 1 1 2"/>')
        refused = read(data.encode())
        named, _ = one(data, within=E)
        assert [named.curve(t) for t in named.curve.domain] == [(0, 0), (1, 2)]
    else:
        data = THIRDS[format]()
        refused = read(data if isinstance(data, bytes) else data.encode())
        named, _ = one(data, within=E)
        curve = named.curve
        for k in range(9):
            x, y, *_ = curve(curve.domain[0] + (curve.domain[1] - curve.domain[0]) * mpq(k, 8))
            assert (x - 1) ** 2 + (y - 2) ** 2 == 25
        x, y, *_ = curve(curve.domain[1], "left")
        assert abs(x - 1 - mpq(4.330127018922193)) < 2 * E
        assert abs(y - mpq(9, 2)) < 2 * E
        assert any("moved" in note for note in named.notes)
    assert not refused.curves
    assert not refused.complete
    assert "--approximate E" in refused.skipped[0].why


POLES = "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=CARTESIAN_POINT('',(1.,2.,0.));#3=CARTESIAN_POINT('',(3.,2.,0.));"
CUBIC = POLES + (
    "#4=CARTESIAN_POINT('',(4.,0.,0.));"
    "#10=B_SPLINE_CURVE_WITH_KNOTS('',3,(#1,#2,#3,#4),.UNSPECIFIED.,.F.,.F.,(4,4),(0.,1.),.UNSPECIFIED.);"
)


def trimmed(format):
    if format == "iges":
        data = in_iges(3, [0, 0, 0, 0, 1, 1, 1, 1], [(0, 0), (1, 2), (3, 2), (4, 0)], "", "trimmed")
    elif format == "brep":
        data = in_brep_text("8 0.25 0.75\n7 0 0 3 4 2 0 0 0  1 2 0  3 2 0  4 0 0  0 4 1 4")
    else:
        data = step(
            CUBIC + "#30=TRIMMED_CURVE('',#10,(PARAMETER_VALUE(0.25)),(PARAMETER_VALUE(0.75)),.T.,.PARAMETER.);"
        )
    named, _ = one(data)
    assert named.curve.domain == (mpq(1, 4), mpq(3, 4))
    assert named.curve(mpq(1, 4))[:2] == (mpq("0.90625"), mpq("1.125"))


def part(format):
    if format == "brep":
        edge = "TShapes 1\nEd\n 1e-07 1 1 0\n1  1 0 0.25 0.75\n0\n\n0101000\n*\n"
        named, _ = one(in_brep_text("7 0 0 3 4 2 0 0 0  1 2 0  3 2 0  4 0 0  0 4 1 4") + edge)
        assert named.curve.domain == (mpq(1, 4), mpq(3, 4))
        return
    edge = (
        "#20=CARTESIAN_POINT('',({}));#21=CARTESIAN_POINT('',(3.09375,1.125,0.));#22=VERTEX_POINT('',#20);"
        "#23=VERTEX_POINT('',#21);#30=EDGE_CURVE('seam',#22,#23,#10,.T.);"
    )
    named, _ = one(step(CUBIC + edge.format("0.90625,1.125,0.")))
    assert named.curve.domain == (mpq(1, 4), mpq(3, 4))
    assert not named.notes
    assert (named.name, named.curve.name) == ("seam", "seam")
    # a vertex that is a little off the curve
    off = step(CUBIC + edge.format("0.906250001,1.125,0."))
    named, _ = one(off)
    assert named.curve.domain == (0, 1)
    assert named.notes == ("edges may use only a part of it, or reverse it",)
    named, _ = one(off, within=mpq(1, 10**6))
    assert abs(named.curve.domain[0] - mpq(1, 4)) < mpq(1, 10**8)
    assert named.curve.domain[1] == mpq(3, 4)
    assert any("an end is moved by" in note for note in named.notes)


def tilted_iges():
    circle, matrix = (
        ["0."] * 3 + ["5.", "0."] * 2,
        ["1.", "0.", "0.", "0.", "0.", "0.6", "-0.8", "0.", "0.", "0.8", "0.6", "0."],
    )
    text = formatted([(100, 0, 0, "", circle), (124, 0, 0, "", matrix)], "t").decode()
    head = next(line for line in text.splitlines() if line[72] == "D")
    # field 7 of the first directory line refers to the matrix
    return text.replace(head, head[:48] + f"{3:8}" + head[56:])


#: Quarters of circles of radius 5 in a plane with the normal (0, −4, 3)/5, or turned about the x axis likewise.
TILTED = {
    "dxf": lambda: dxf("0 CIRCLE 10 0 20 0 40 5 210 0 220 -0.8 230 0.6"),
    "step": lambda: step(
        "#1=CARTESIAN_POINT('',(0.,0.,0.));#2=DIRECTION('',(0.,-4.,3.));#3=DIRECTION('',(1.,0.,0.));"
        "#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);#5=CIRCLE('',#4,5.);"
    ),
    "iges": tilted_iges,
    "brep": lambda: in_brep_text("2 0 0 0 0 -0.8 0.6 1 0 0 0 0.6 0.8 5"),
    "3dm": lambda: rhino(tilted_circle),
}


def tilted_circle(rhino3dm):
    plane = rhino3dm.Plane(rhino3dm.Point3d(0, 0, 0), rhino3dm.Vector3d(0, -4, 3))
    circle = rhino3dm.Circle(rhino3dm.Point3d(0, 0, 0), 5.0)
    circle.Plane = plane
    return rhino3dm.ArcCurve.CreateFromCircle(circle)


def tilted_plane(format):
    named, _ = one(TILTED[format]())
    curve = named.curve
    for k in range(9):
        x, y, z = curve(curve.domain[0] + (curve.domain[1] - curve.domain[0]) * mpq(k, 8))
        if format == "3dm":
            # exact for the plane as written, in doubles
            assert abs(x * x + y * y + z * z - 25) < mpq(1, 10**13)
            assert abs(3 * z - 4 * y) < mpq(1, 10**13)
        else:
            assert x * x + y * y + z * z == 25
            assert 3 * z == 4 * y


def vertices(points):
    return "".join(f" 10 {x} 20 {y}" for x, y in points)


SQUARES = {
    "json": lambda: json.dumps({"curves": [json.loads(in_json(1, [0, 0, 1, 2, 2], p, str(p), "")) for p in TWO]}),
    "dxf": lambda: dxf(
        "".join(f"0 LWPOLYLINE 5 {p[0][0]} 70 1{''.join(f' 10 {x} 20 {y}' for x, y in p)} " for p in TWO)
    ),
    "svg": lambda: svg('<path d="M0 0L4 0L0 4ZM1 1L2 1L1 2Z"/>'),
    "glif": lambda: GLIF,
    "font": truetype,
    "step": lambda: step(
        POLES + "#8=POLYLINE('',(#1,#2,#3));#9=POLYLINE('',(#3,#1));#10=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#8);"
        "#11=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#9);#12=COMPOSITE_CURVE('',(#10,#11),.F.);"
        "#13=POLYLINE('',(#2,#3,#1,#2));"
    ),
}
TWO = [[(0, 0), (4, 0), (0, 4)], [(1, 1), (2, 1), (1, 2)]]


def several_contours(format):
    if format in ("font", "glif"):
        pytest.importorskip("fontTools")
    data = SQUARES[format]()
    reading = read(data if isinstance(data, bytes) else data.encode())
    assert len(reading.curves) >= 2
    assert len({named.name for named in reading.curves}) == len(reading.curves)


UNITS = {
    "dxf": lambda: (
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n" + dxf("0 LINE 10 0 20 0 11 1 21 1").decode()
    ),
    "iges": lambda: iges_arc(0, 1, 2, 6, 2, 1, 7),
    "step": lambda: step(
        CUBIC
        + "#50=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#51))REPRESENTATION_CONTEXT('',''));"
        "#51=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));"
    ),
    "3dm": rhino_arc(math.pi / 2),
    "font": truetype,
}


def units(format):
    data = UNITS[format]()
    notes = read(data if isinstance(data, bytes) else data.encode()).notes
    assert any("millimet" in note or "in font units" in note for note in notes)


CHECKS = {"periodic": periodic, "one period": one_period, "left out": left_out, "closed flag": closed_flag, "arc": arc,
          "approximate": approximate, "trimmed": trimmed, "part": part, "tilted plane": tilted_plane,
          "several contours": several_contours, "names": names, "units": units}  # fmt: skip


def cells():
    """The cells of the table in the documentation that say how something is read: format, feature, what is said."""
    text = PAGE.read_text(encoding="utf-8")
    header, _, *rows = re.search(r"(?:^\| *format *\| *periodic.*\n)(?:^\|.*\n)+", text, re.M)[0].splitlines()
    features = [cell.strip() for cell in header.strip("|").split("|")][1:]
    assert features == list(FEATURES)
    for row in rows:
        format, *said = (cell.strip() for cell in row.strip("|").split("|"))
        for feature, words in zip(features, said, strict=True):
            if words != "–":
                yield format.strip("`"), feature, words


@pytest.mark.parametrize(("format", "feature", "words"), list(cells()))
def test_a_cell_of_the_table(format, feature, words):
    assert words in ("exactly", "within E", "with a note", "kept", "each")
    if format == "3dm":
        pytest.importorskip("rhino3dm")
    CHECKS[feature](format)
