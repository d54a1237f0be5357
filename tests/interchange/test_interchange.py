"""Files of other programs: known answers, conventions that are easily confused, and what is named as skipped."""

import json
from importlib.resources import files

import jsonschema
import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import ExactSplineError, Nurbs, example, examples, read, write
from exactspline.errors import CurveFileError, NumberError, ShapeError, WeightError
from exactspline.interchange import Limits
from exactspline.interchange.files import encoded
from exactspline.interchange.formats import formats
from exactspline.interchange.records import work
from tests.support.command import invoke
from tests.support.interchange_seeds import (
    ARC,
    BREP,
    CUBIC,
    CURVES,
    DXF,
    G2,
    ITD,
    SPACE,
    STEP,
    SVG,
    dxf,
    iges,
    seeds,
    truetype,
)
from tests.support.strategies import nurbs

WRITERS = [known.name for known in formats() if known.write and known.name != "3dm"]
CARTESIAN_IN_SPACE = ("iges", "3dm")

#: The published schema of a file of curves.
SCHEMA = json.loads(files("exactspline.interchange").joinpath("curve.schema.json").read_text(encoding="utf-8"))


def same(a, b):
    """Equal degree, knots, points and, up to nothing at all, weights."""
    weights = [(1,) * len(c.weights) if c.polynomial else c.weights for c in (a, b)]
    return (a.degree, a.knots, a.control_points, weights[0]) == (b.degree, b.knots, b.control_points, weights[1])


def lifted(curve):
    """A plane curve at z = 0."""
    weights = None if curve.polynomial else curve.weights
    return Nurbs(curve.degree, curve.knots, [(*p, 0) for p in curve.control_points], weights)


def in_dyadics(curve):
    """The curve with its numbers moved to numbers with finite decimals, by an injective map that keeps their order."""

    def near(x):
        return mpq(int(x * 2**200 // 1), 2**200)

    weights = None if curve.polynomial else [near(w) + mpq(1, 2**200) for w in curve.weights]
    return Nurbs(curve.degree, map(near, curve.knots), [map(near, p) for p in curve.control_points], weights)


@pytest.mark.parametrize("name", [n for n in WRITERS if n != "svg"])
@pytest.mark.parametrize("curve", CURVES, ids=lambda c: c.name)
def test_what_is_written_is_read_again(name, curve):
    reading = read(encoded([curve], name)[0])
    assert reading.format == name
    assert not reading.skipped
    found = reading.curves[0].curve
    flat = curve.dimension == 2
    assert same(found, lifted(curve) if flat and name in CARTESIAN_IN_SPACE else curve)


@pytest.mark.parametrize("name", [n for n in WRITERS if n != "svg"])
def test_several_curves_keep_their_order(name):
    plane = [ARC, CUBIC, ARC]
    degrees = [named.curve.degree for named in read(encoded(plane, name)[0]).curves]
    assert degrees == [2, 3, 2]


HOSTILE_NAMES = st.text(
    st.characters(codec="utf-8") | st.sampled_from("\x00\x07\x1b\x7f\x9b\u202e\ufffe'\"<&;]*)("), max_size=12
)


@pytest.mark.parametrize("name", WRITERS)
@given(HOSTILE_NAMES)
def test_whatever_a_curve_is_called_its_file_is_read(name, called):
    segment = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)], name=called)
    [found] = read(encoded([segment], name)[0], name).curves
    assert found.curve.degree == 1


@pytest.mark.parametrize("name", ["json", "g2", "itd", "gismo", "geomdl", "step", "brep"])
@given(nurbs(dimension=3))
def test_any_curve_with_finite_decimals_survives(name, curve):
    curve = in_dyadics(curve)
    [named] = read(encoded([curve], name)[0], name, limits=Limits(digits=5_000, exponent=5_000)).curves
    assert same(named.curve, curve)


@pytest.mark.parametrize("name", [n for n in WRITERS if n not in ("json", "svg")])
def test_a_third_is_refused_or_rounded_when_asked(name):
    third = Nurbs(1, [0, 0, 1, 1], [(0, 0), ("1/3", 1)])
    with pytest.raises(NumberError, match="1/3 has no finite decimal"):
        encoded([third], name)
    data, notes = encoded([third], name, rounding=True)
    assert notes[0] == "1 numbers were rounded to doubles"
    assert read(data).curves[0].curve.control_points[1][0] == mpq("0.3333333333333333")


CONTROL_VECTOR = Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], [(1, 0, 1), (0, 1, 0), (-1, 0, 1)])


@pytest.mark.parametrize("name", ["json", "g2", "itd"])
def test_homogeneous_formats_hold_a_control_vector(name):
    assert same(read(encoded([CONTROL_VECTOR], name)[0]).curves[0].curve, CONTROL_VECTOR)


@pytest.mark.parametrize("name", ["gismo", "geomdl", "step", "brep", "dxf", "iges"])
def test_cartesian_formats_refuse_a_control_vector(name):
    with pytest.raises(WeightError, match="weight zero"):
        encoded([CONTROL_VECTOR], name)


def test_own_files_follow_the_published_schema():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    published = jsonschema.Draft202012Validator(SCHEMA)
    for name in examples("curves"):
        published.validate(json.loads(encoded([example(name)], "json")[0]))
    published.validate(json.loads(encoded([*CURVES, CONTROL_VECTOR], "json")[0]))


@pytest.mark.parametrize("broken", [
    '{"degree": 1, "knots": [0, 0, 1, 1]}',
    '{"degree": 1, "knots": [0, 0, 1, "one"], "control_points": [[0, 0], [1, 1]]}',
    '{"degree": -1, "knots": [0, 0], "control_points": [[0, 0]]}',
    '{"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]], "wieghts": [1, 1]}',
    '{"degree": 1, "knots": [0, 0, 1, "1/0"], "control_points": [[0, 0], [1, 1]]}',
])  # fmt: skip
def test_what_the_reader_refuses_is_refused(broken):
    with pytest.raises(ExactSplineError):
        read(broken.encode())
    if "1/0" not in broken:
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(json.loads(broken), SCHEMA)


@pytest.mark.parametrize("number", ["1e+-9", "1e", "1e20001", "0x1p99999", "1/0", "٣", "", "1 2", "--1", "1e9e9"])
def test_what_is_no_number_or_beyond_the_limits_is_no_coordinate(number):
    data = {"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [number, 1]]}
    with pytest.raises(ExactSplineError):
        read(json.dumps(data).encode(), "json")


def test_homogeneous_and_cartesian_points_are_told_apart():
    """The same half circle, as g2 (w x, w y, w), itd (w, w x, w y) and as Cartesian geomdl."""
    half = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
    g2 = b"100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n1 0 1\n1 1 1\n0 2 2\n"
    itd = b"[OBJECT A [CURVE BSPLINE 3 3 P2 [KV 0 0 0 1 1 1] [1 1 0] [1 1 1] [2 0 2]]]"
    geomdl = (
        b'{"shape": {"type": "curve", "data": {"type": "spline", "degree": 2, "knotvector": [0,0,0,1,1,1], '
        b'"control_points": {"points": [[1,0],[1,1],[0,1]], "weights": [1,1,2]}}}}'
    )
    for data in (g2, itd, geomdl):
        [named] = read(data).curves
        assert same(named.curve, half)
        assert sum(x * x for x in named.curve("1/3")) == 1


def test_g2_steps_over_other_objects():
    reading = read(G2)
    assert [named.curve.degree for named in reading.curves] == [1, 2]
    assert reading.curves[0].curve(1) == (mpq(1, 10), mpq(1, 1000))
    assert [skipped.what for skipped in reading.skipped] == ["point cloud", "circle", "spline surface"]


def test_itd_reads_bezier_and_periodic_curves():
    rational, bezier, periodic = (named.curve for named in read(ITD).curves)
    assert rational.weights == (1, mpq(1, 2), 1)
    assert rational.control_points[1] == (2, mpq(1, 2))
    assert bezier("1/2") == (1, mpq(1, 2))
    assert periodic.closed
    assert all(component.continuity_at(t) >= 1 for component in periodic.p for t in (3, 4, 5))


def test_a_periodic_brep_curve_is_smooth_across_its_seam():
    named = read(BREP).curves[0]
    curve = named.curve
    a, b = curve.domain
    assert (a, b) == (0, 3)
    assert curve.closed
    ends = [[component.d()(t, side) for component in (*curve.p, curve.w)] for t, side in ((a, "right"), (b, "left"))]
    assert ends[0] == ends[1]
    assert "periodic" in named.notes[0]


@pytest.mark.parametrize(
    "knots", ["0 0 1 0 2 0 3 0", "0 0 1 1 2 1 3 0", "0 9 1 1 2 1 3 9", "3 1 2 1 1 1 0 1", "0 1 0 1 0 1 0 1"]
)
def test_a_periodic_brep_curve_with_knots_that_are_none_is_named(knots):
    reading = read(BREP.replace(b"0 1 1 1 2 1 3 1", knots.encode()))
    assert BREP.count(b"0 1 1 1 2 1 3 1") == 1
    assert reading.skipped[0].where == "Curve2ds 1"


def test_brep_circles_are_circles_and_trimmed_curves_are_parts():
    reading = read(BREP)
    circle = reading.curves[1]
    assert "full circle" in circle.notes[0]
    for t in ("1/7", 1, "5/3", 3, "39/10"):
        x, y = circle.curve(t)
        assert (x - 1) ** 2 + (y - 2) ** 2 == mpq(25, 4)
    trimmed = next(named for named in reading.curves if named.curve.source == "Curves 2")
    assert trimmed.curve.name == trimmed.name
    assert trimmed.curve.domain == (mpq(1, 4), mpq(3, 4))
    assert "from 1/4 to 3/4" in trimmed.notes[0]


def test_step_knots_of_the_standard():
    by_kind = {named.name: named.curve for named in read(STEP).curves}
    assert list(by_kind["it's"].knots) == [0, 0, 0, 1, 1, 1]
    assert list(by_kind["#8"].knots) == [0, 0, 1, 2, 2]
    assert list(by_kind["#9"].knots) == [-2, -1, 0, 1, 2, 3]
    assert by_kind["r"].weights == (1, mpq(1, 2), 1)
    assert by_kind["#6"](1) == (1, mpq(1, 2), 0)


def test_iges_arcs_conics_and_matrices():
    spline, arc, conic, line = (named.curve for named in read(iges()).curves)
    assert spline(1) == (2, 0, 1)
    # the matrix turns by a right angle and shifts by 5 along x
    assert arc(arc.domain[0]) == (5, 1, mpq(1, 2))
    assert arc(arc.domain[1]) == (5, -1, mpq(1, 2))
    for t in ("1/3", "4/3"):
        x, y, _ = arc(t)
        assert (x - 5) ** 2 + y**2 == 1
        assert x < 5
    for t in ("1/5", "1/2"):
        x, y, _ = conic(t)
        assert x**2 + 4 * y**2 == 4
        assert x > 0 < y
    assert line("1/2") == (mpq(1, 2), mpq(1, 2), mpq(1, 2))


def test_iges_arc_that_is_no_arc_is_skipped():
    broken = iges().replace(b"-1.,0.; ", b"-1.5,0.;")
    assert "not exactly on the curve" in read(broken).skipped[0].why


def test_dxf_entities():
    line, circle, arc, ellipse, polyline = (named.curve for named in read(DXF).curves)
    assert line(1) == (1, mpq(3, 2))
    assert all(sum((x - c) ** 2 for x, c in zip(circle(t), (1, 2))) == mpq(1, 4) for t in (0, "1/3", "7/2"))
    # seen from below: x runs backwards
    assert [arc(t) for t in arc.domain] == [(0, 2), (0, -2)]
    assert arc("1/2")[0] > 0
    assert ellipse(0) == (2, 1)
    assert ellipse(1) == (mpq(-1, 2), 1)
    assert polyline.closed


def test_a_bulge_is_the_tangent_of_a_quarter_of_the_angle():
    [named] = read(dxf("0 LWPOLYLINE 10 0 20 0 42 1 10 2 20 0 42 0 10 2 20 5")).curves
    below = named.curve(1)
    assert below == (1, -1)
    assert named.curve(named.curve.domain[1], "left") == (2, 5)


@pytest.mark.parametrize(("words", "why"), [
    ("0 ARC 10 0 20 0 40 1 50 0 51 30", "not a multiple of 90"),
    ("0 ELLIPSE 10 0 20 0 11 1 21 0 40 0.5 41 0 42 1.0", "not a multiple of 90"),
    ("0 SPLINE 70 8 71 3 72 8 73 4 10 0 20 0", "8 knots announced, 0 given"),
    ("0 SPLINE 71 3 11 0 21 0", "fit points only"),
    ("0 LWPOLYLINE 90 5 10 0 20 0 10 1 20 0", "5 vertices announced, 2 given"),
    ("0 CIRCLE 10 0 20 0 40 1 210 1 220 1 230 0", "irrational length"),
])  # fmt: skip
def test_what_dxf_cannot_give_exactly_is_named(words, why):
    reading = read(dxf(words))
    assert not reading.curves
    assert why in reading.skipped[0].why


def test_svg_shapes_and_transforms():
    reading = read(SVG)
    names = [named.name for named in reading.curves]
    assert "not drawn" in reading.skipped[-1].why
    assert any(name.startswith("rect") for name in names)
    circle = next(named.curve for named in reading.curves if named.name.startswith("circle"))
    # translated by (1, 2) after being doubled
    assert all((x - 1) ** 2 + (y - 2) ** 2 == 16 for x, y in (circle(t) for t in (0, "1/3", "5/2")))


def svg(data, transform=""):
    return read(f'<svg><path d="{data}" transform="{transform}"/></svg>'.encode(), "svg")


@pytest.mark.parametrize(("data", "same_as"), [
    ("m1 1l1 0h1v1z", "M1 1L2 1L3 1L3 2L1 1"),
    ("M0 0S1 1 2 0S3 -1 4 0", "M0 0C0 0 1 1 2 0C3 -1 3 -1 4 0"),
    ("M0 0Q1 1 2 0T4 0t2 0", "M0 0Q1 1 2 0Q3 -1 4 0Q5 1 6 0"),
    ("M40.5.6L10-20", "M40.5,0.6L10,-20"),
    ("M0 0 1 1 2 0", "M0 0L1 1L2 0"),
    ("M10-20A5.5.3 0 010-.1", "M 10 -20 A 5.5 0.3 0 0 1 0 -0.1"),
    ("M0 0zm70 0L0 1", "M70 0L0 1"),
])  # fmt: skip
def test_svg_path_data_written_in_two_ways(data, same_as):
    assert [c.curve.control_points for c in svg(data).curves] == [c.curve.control_points for c in svg(same_as).curves]


rationals = st.fractions(-20, 20, max_denominator=16).filter(lambda x: (1 << 10) % x.denominator == 0)


@given(rationals, rationals, st.integers(1, 9), st.integers(1, 9), st.booleans(), st.booleans(), st.integers(1, 9))
def test_svg_arcs_lie_on_their_ellipse(x, y, rx, ry, large, sweep, k):
    """A chord from the rightmost point of an ellipse to the rational point at the half angle tan = k/4."""
    t = mpq(k, 4)
    cos, sin = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    start, end = (mpq(x) + rx, mpq(y)), (mpq(x) + rx * cos, mpq(y) + ry * sin)
    from exactspline.interchange.segments import joined_segments
    from exactspline.interchange.svg_paths import elliptic_arc

    segments = elliptic_arc(start, end, (mpq(rx), mpq(ry)), mpq(0), large, sweep)
    degree, knots, points = joined_segments(segments)
    curve = Nurbs.from_homogeneous(degree, knots, points)
    a, b = curve.domain
    assert (curve(a), curve(b)) == (start, end)
    # the small arc in the positive sense is the one around the centre given; the two others are around its mirror image
    own = (mpq(x), mpq(y))
    centre = own if sweep != large else (start[0] + end[0] - own[0], start[1] + end[1] - own[1])
    for i in range(1, 8):
        px, py = curve(a + (b - a) * i / 8)
        assert ((px - centre[0]) / rx) ** 2 + ((py - centre[1]) / ry) ** 2 == 1


@pytest.mark.parametrize("transform", ["rotate(30)", "skewX(20)", "spin(3)", "rotate(1 2)", "matrix(1 2 3)"])
def test_svg_transforms_that_are_not_exact_skip_what_they_move(transform):
    assert not svg("M0 0L1 1", transform).curves


def test_svg_irrational_arcs_are_skipped_and_the_rest_is_read():
    reading = svg("M0 0A3 2 30 0 1 1 1 M5 5L6 6 M0 0A2 2 0 0 1 1 0")
    assert [c.curve.degree for c in reading.curves] == [1]
    assert len(reading.skipped) == 2


def test_svg_data_count_up_to_an_error():
    [named] = svg("M0 0L1 1 2 2 40#90").curves
    assert named.curve.domain == (0, 2)
    assert "read up to there" in named.notes[0]


@pytest.mark.parametrize(
    "curve", [CUBIC, Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])], ids=["cubic", "parabola"]
)
def test_svg_keeps_the_segments(curve):
    data, notes = encoded([curve], "svg")
    assert "no knots" in notes[0]
    [named] = read(data).curves
    assert [part.bezier_points for part in named.curve.p] == [part.bezier_points for part in curve.p]


def test_svg_refuses_what_it_cannot_draw():
    for curve in (ARC, SPACE):
        with pytest.raises(ShapeError, match="plane curves of degree 1 to 3"):
            encoded([curve], "svg")


def test_control_points_alone_need_degree_and_knots():
    data = b"1,0,1\n1,1,1\n0,2,2"
    assert "give both" in read(data, "cptw").skipped[0].why
    [named] = read(data, "cptw", degree=2).curves
    assert same(named.curve, ARC)
    [named] = read(data, "cptw", degree=1, knots=[0, 0, "1/3", 1, 1]).curves
    assert named.curve("1/3") == (1, 1)


def test_truetype_runs_have_simple_knots():
    pytest.importorskip("fontTools")
    by_name = {named.name: named.curve for named in read(truetype()).curves}
    a = by_name["a.1"]
    assert list(a.knots) == [0, 0, 0, 1, 1, 2, 3, 3, 4, 4, 4]
    # the implied point of the run is midway between two off-curve points
    assert a(2) == (125, 75)
    assert by_name["ring.1"](0) == (0, 50)
    assert by_name["both.1"](0) == (10, 20)
    assert by_name["both.2"](0) == (0, 25)


def test_a_glyph_by_name_or_character(tmp_path):
    pytest.importorskip("fontTools")
    font = tmp_path / "test.ttf"
    font.write_bytes(truetype())
    assert [named.name for named in read(f"{font}:both").curves] == ["both.1", "both.2"]
    assert [named.name for named in read(font, part="a").curves] == ["a.1"]
    with pytest.raises(CurveFileError, match="there is no glyph called 'nothing'"):
        read(f"{font}:nothing")


def test_equal_weights_are_said_to_be_polynomial():
    [named] = read(b"100 1 0 0\n2 1\n2 2\n0 0 1 1\n0 0 2\n2 4 2\n").curves
    assert named.curve.polynomial
    assert named.curve(1) == (1, 2)
    assert "equal" in named.notes[0]


def test_one_bad_curve_does_not_lose_the_others():
    data = b'{"curves": [{"degree": 1}, {"degree": 1, "knots": [0,0,1,1], "control_points": [[0,0],[1,1]]}]}'
    reading = read(data)
    assert len(reading.curves) == len(reading.skipped) == 1
    assert reading.skipped[0].where == "curve 1"


@pytest.mark.parametrize("name", seeds())
def test_every_format_is_told_by_its_content(name):
    if name != "cptw":
        assert {read(data).format for data in seeds()[name]} == {name}


def test_files_that_are_none(tmp_path):
    with pytest.raises(CurveFileError, match="cannot be read"):
        read(tmp_path / "missing.g2")
    with pytest.raises(CurveFileError, match="not a regular file"):
        read(tmp_path)
    with pytest.raises(CurveFileError, match="not in a known format"):
        read(b"hello")
    with pytest.raises(CurveFileError, match="the formats are"):
        read(b"hello", "word")
    with pytest.raises(CurveFileError, match="at most 1 MB"):
        read(b" " * (2 << 20), limits=Limits(megabytes=1))
    with pytest.raises(CurveFileError, match="can be read but not written"):
        write([ARC], tmp_path / "a.ttf")
    with pytest.raises(CurveFileError, match="no curves to write"):
        write([], tmp_path / "a.g2")
    assert list(tmp_path.iterdir()) == []


def test_the_work_that_is_estimated_is_knot_insertion():
    assert work(3, [mpq(t) for t in (0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4)], 53) == 3 * 2 * 4**4
    assert work(3, [mpq(t) for t in (0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2)], 53) == 1


def test_what_derive_wrote_is_read_as_inspect_reads_it(tmp_path):
    """Whole, among other curves, and one piece of it alone."""
    written = tmp_path / "evolute.json"
    assert invoke("derive", "evolute", "ellipse", "-o", str(written)).exit_code == 0
    derived = json.loads(written.read_text(encoding="utf-8"))
    several, piece = tmp_path / "several.json", tmp_path / "piece.json"
    several.write_text(json.dumps({"curves": [derived, derived]}), encoding="utf-8")
    piece.write_text(json.dumps(derived["pieces"][0]), encoding="utf-8")
    found = [named.curve for path in (written, several, piece) for named in read(path).curves]
    assert found == [read(str(written)).curve] * 4
    assert found[0].domain == example("ellipse").domain


@pytest.mark.parametrize("number", ["1e1000", "-1e-1000", "0x1p9999", "1" * 5000])
def test_a_long_number_is_read_by_every_door(number):
    """Passed before: read alone, refused among others; and the limits of a call were not those for surfaces."""
    data = {"degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [number, 1]]}
    (alone,) = read(json.dumps(data).encode()).curves
    (listed,) = read(json.dumps([data]).encode()).curves
    assert alone.curve == listed.curve == read(json.dumps(data).encode()).curve
    assert read(("\ufeff" + json.dumps(data)).encode()).curve == alone.curve
    net = [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, number]]]
    surface = {"degree": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "control_points": net}
    assert len(read(json.dumps(surface).encode()).surfaces) == 1
    narrow = Limits(exponent=10, digits=10)
    for each in (data, surface, data | {"kind": "polynomial", "control_points": [[0, 0], [1, 1]], "high": number}):
        reading = read(json.dumps([each]).encode(), limits=narrow)
        assert (len(reading.curves) + len(reading.surfaces), len(reading.skipped)) == (0, 1)
        with pytest.raises(NumberError):
            read(json.dumps(each).encode(), limits=narrow)


@pytest.mark.parametrize(("field", "value"), [("low", "abc"), ("high", True), ("interval", [None, 1])])
def test_the_end_of_a_piece_that_is_no_number_is_named(field, value):
    """Passed before: a message without a place."""
    piece = {"kind": "polynomial", "degree": 1, "knots": [0, 0, 1, 1], "control_points": [[0, 0], [1, 1]], field: value}
    with pytest.raises(ExactSplineError, match=rf"^{field}.*: .*number"):
        read(json.dumps(piece).encode())


def test_files_come_before_examples_of_their_names(tmp_path, monkeypatch):
    """Two doors differed: `inspect circle` read the example, `read("circle")` the file."""
    monkeypatch.chdir(tmp_path)
    assert read("circle").curve == example("circle")
    assert read("enneper").surface.degree == (3, 3)
    (tmp_path / "circle").write_text("no curve", encoding="utf-8")
    with pytest.raises(CurveFileError, match="known format"):
        read("circle")
