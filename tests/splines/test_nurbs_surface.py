"""NURBS surfaces as values, their files, and what is refused; points and derivatives against a route of their own."""

import copy
import json
import pickle
from importlib import resources

import jsonschema
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import Direction, ExactSplineError, Nurbs, NurbsSurface, example, examples, rational, read, write
from exactspline.errors import (
    CurveFileError,
    DomainError,
    FormulaError,
    KnotError,
    NumberError,
    ShapeError,
    WeightError,
)
from exactspline.interchange import text as written_as_json
from exactspline.numbers.intervals import UNIT as SQUARE_OF_PARAMETERS
from exactspline.polynomials.patch_forms import PatchForm, Sized
from exactspline.splines.surface import DEPTH, zero_at_corners
from tests.support.surface_oracle import jets

UNIT = [0, 0, 1, 1]
SQUARE = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]


def by_definition(surface, u, v):
    """The point ``Σ w P N N / Σ w N N``."""
    return tuple(rational(x.c[0, 0]) for x in jets(surface, u, v))


numbers = st.fractions(min_value=-5, max_value=5, max_denominator=4)


@st.composite
def surfaces(draw):
    """Surfaces with repeated knots, weights of one sign, coincident points now and then."""
    degrees, knots = [], []
    for _ in range(2):
        degree = draw(st.integers(1, 3))
        inner = sorted(draw(st.lists(st.sampled_from([1, 1, 2]), max_size=3)))
        inner = [t for k, t in enumerate(inner) if inner[:k].count(t) < degree]
        knots.append([0] * (degree + 1) + inner + [3] * (degree + 1))
        degrees.append(degree)
    rows, columns = (len(own) - n - 1 for own, n in zip(knots, degrees, strict=True))
    point = st.tuples(numbers, numbers, numbers)
    net = [[draw(point) for _ in range(columns)] for _ in range(rows)]
    if draw(st.booleans()):
        net[0] = [net[0][0]] * columns
    sign = draw(st.sampled_from([1, -1]))
    weights = [[sign * draw(st.integers(1, 4)) for _ in range(columns)] for _ in range(rows)]
    return NurbsSurface(tuple(degrees), *knots, net, weights if draw(st.booleans()) else None)


parameters = st.fractions(min_value=0, max_value=3, max_denominator=6)


@settings(max_examples=12)
@given(surfaces(), parameters, parameters)
def test_points_are_those_of_the_definition(surface, u, v):
    assert surface(u, v) == surface.at(u, v) == by_definition(surface, u, v)


@settings(max_examples=8)
@given(surfaces(), parameters, parameters, st.fractions(min_value="1/7", max_value="20/7", max_denominator=7))
def test_every_representation_is_the_same_function(surface, u, v, t):
    other = surface.insert_knot("u", t).elevate_degree(1, 2).insert_knot("v", t)
    assert surface == other
    assert hash(surface) == hash(other)
    assert other(u, v) == surface(u, v)
    first, second = surface.split("v", t)
    assert (first if v < t else second)(u, v) == surface(u, v)
    assert surface.isocurve("u", v)(u) == surface.isocurve("v", u)(v) == surface(u, v)
    assert surface.transposed()(v, u) == surface(u, v)


@settings(max_examples=8)
@given(surfaces(), st.integers(0, 2), st.integers(0, 2))
def test_partial_derivatives_are_limits_of_the_exact_difference_quotients(surface, i, j):
    # along isocurves the derivative is that of a curve, found by another route
    u, v = rational("1/2"), rational("5/2")
    assert surface.partial(i, 0, u, v) == surface.isocurve("u", v).derivative(i, u)
    assert surface.partial(0, j, u, v) == surface.isocurve("v", u).derivative(j, v)


def test_mixed_derivatives_by_interpolation():
    f = NurbsSurface((1, 1), UNIT, UNIT, SQUARE, [[1, 1], [1, 2]])
    # S = (u + u v, v + u v, 2 u v)/(1 + u v), its mixed derivative by hand at 0
    assert f.partial(1, 1, 0, 0) == (1, 1, 2)
    assert f.partial(0, 0, 1, 1) == (1, 1, 1)


def test_a_surface_is_a_value():
    sphere = example("sphere")
    assert copy.deepcopy(sphere) is sphere
    assert pickle.loads(pickle.dumps(sphere)) == sphere
    assert len({sphere, sphere.elevate_degree(), example("torus")}) == 2
    with pytest.raises(AttributeError):
        sphere.name = "ball"
    assert sphere != example("ellipsoid")
    assert sphere != "sphere"
    assert NurbsSurface((1, 1), UNIT, UNIT, SQUARE, [[3, 3], [3, 3]]).polynomial
    assert NurbsSurface((1, 1), UNIT, UNIT, SQUARE, [[-3, -3], [-3, -3]]) == NurbsSurface((1, 1), UNIT, UNIT, SQUARE)


def test_images():
    sphere = example("sphere")
    assert sphere.transform([[3, 0, 0], [0, 2, 0], [0, 0, 1]]) == example("ellipsoid")
    moved = sphere.transform([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0]])
    assert moved(0, 1) == (6, 0, 0)
    with pytest.raises(WeightError):
        sphere.transform([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0]])
    with pytest.raises(ShapeError):
        sphere.transform([[1, 0], [0, 1]])


@pytest.mark.parametrize(
    ("name", "equation"),
    [
        ("sphere", lambda x, y, z: x * x + y * y + z * z - 1),
        ("ellipsoid", lambda x, y, z: x * x / 9 + y * y / 4 + z * z - 1),
        ("torus", lambda x, y, z: (x * x + y * y + z * z + 3) ** 2 - 16 * (x * x + y * y)),
        ("cylinder", lambda x, y, z: x * x + y * y - 1),
        ("cone", lambda x, y, z: x * x + y * y - (1 - z / 2) ** 2),
        ("hyperbolic_paraboloid", lambda x, y, z: z - x * y),
        ("monkey_saddle", lambda x, y, z: z - x**3 + 3 * x * y * y),
        # (x² + y² + z² + b² − d²)² = 4 (a x − c d)² + 4 b² y²
        ("cyclide", lambda x, y, z: (x * x + y * y + z * z + 16 - 16) ** 2 - 4 * (5 * x - 12) ** 2 - 64 * y * y),
        ("paraboloid", lambda x, y, z: z - x * x - y * y),
    ],
)
def test_examples_lie_on_their_equations(name, equation):
    surface = example(name)
    (a, b), (c, d) = surface.domain
    for i in range(9):
        for j in range(9):
            assert equation(*surface(a + (b - a) * rational(f"{i}/8"), c + (d - c) * rational(f"{j}/8"))) == 0


# ---- files


@pytest.mark.parametrize("name", examples("surfaces"))
def test_files_round_trip_and_fit_the_schema(name, tmp_path):
    surface = read(name).surface
    path = tmp_path / "s.json"
    write(surface, path)
    again = read(str(path)).surface
    assert (again, again.name, again.note, again.degree) == (surface, surface.name, surface.note, surface.degree)
    schema = json.loads(resources.files("exactspline.interchange").joinpath("surface.schema.json").read_text("utf-8"))
    jsonschema.validate(json.loads(written_as_json(surface)), schema)
    own = resources.files("exactspline.interchange").joinpath("example_surfaces", f"{name}.json").read_text("utf-8")
    jsonschema.validate(json.loads(own), schema)


def test_the_net_may_be_called_points_and_hold_directions():
    text = """{"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
               "points": [[[0, 0, 0], [0, 1, 0.25]], [{"vector": [1, 0, 0]}, {"vector": [1, 0, 0]}]]}"""
    with pytest.raises(WeightError, match="u = 1"):
        read(text.encode())
    points = text.replace('{"vector": [1, 0, 0]}]]', "[1, 2, 3]]]").replace('{"vector": [1, 0, 0]}', "[9, 9, 9]")
    strip = read(points.encode()).surface
    assert strip(0, 1) == (0, 1, rational("1/4"))
    quarter = NurbsSurface(
        (2, 1), [0, 0, 0, 1, 1, 1], UNIT, [[(1, 0, 0)] * 2, [Direction(0, 1, 0)] * 2, [(-1, 0, 0)] * 2]
    )
    assert quarter("1/2", "1/3") == (0, 1, 0)
    assert read(written_as_json(quarter).encode()).surface == quarter


BASE = {"degree": [1, 1], "knots": [UNIT, UNIT], "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]}


@pytest.mark.parametrize(
    ("change", "error", "told"),
    [
        ({"degree": 1}, NumberError, "knots\\[0\\]"),
        ({"degree": [1, 1, 1]}, CurveFileError, "degree: has 3 entries"),
        ({"degree": [1, 1.5]}, ShapeError, "degrees\\[1\\]"),
        ({"knots": [UNIT]}, CurveFileError, "knots: has 1 entry"),
        ({"knots": [UNIT, [0, 0, 1]]}, KnotError, "knots_v"),
        ({"knots": [[0, 1, 0, 1], UNIT]}, KnotError, "knots_u\\[2\\]"),
        ({"control_points": [[[0, 0, 0]], [[1, 0, 0]]]}, ShapeError, "control_points\\[0\\]: 1 control point in a row"),
        ({"control_points": [[[0, 0], [0, 1]], [[1, 0, 0], [1, 1, 1]]]}, ShapeError, "control_points\\[1\\]"),
        (
            {"control_points": [[[0, 0, 0], [0, 1, "x"]], [[1, 0, 0], [1, 1, 1]]]},
            NumberError,
            "control_points\\[0\\]\\[1\\]\\[2\\]",
        ),
        ({"control_points": [[[0, 0, 0], {"vector": [1]}]] * 2}, ShapeError, "control_points\\[0\\]\\[1\\]"),
        ({"control_points": [[[0, 0, 0], [0, 1, 0]], 3]}, CurveFileError, "control_points\\[1\\]: is not a list"),
        ({"control_points": "net"}, CurveFileError, "control_points: is not a list"),
        ({"weights": [[1, 1]]}, ShapeError, "1 row of weights for 2"),
        ({"weights": [[1, 1], [1]]}, ShapeError, "weights\\[1\\]"),
        ({"weights": [[1, 1], [1, "w"]]}, NumberError, "weights\\[1\\]\\[1\\]"),
        ({"weights": [[1, 1], [1, 0]]}, WeightError, "u = 1, v = 1"),
        ({"weights": [[1, -1], [1, -1]]}, WeightError, "a zero"),
        ({"colour": 1}, CurveFileError, "'colour' is unknown"),
        ({"points": []}, CurveFileError, "'points' is unknown"),
    ],
)
def test_what_is_wrong_in_a_file_is_told_with_its_place(change, error, told):
    with pytest.raises(error, match=told):
        read(json.dumps(BASE | change).encode())


def test_what_is_no_surface_at_all(tmp_path):
    for text in ("", "[1]", "{", '{"degree": [1, 1]}', '{"degree": [1, 1], "degree": [1, 1]}', "NaN"):
        with pytest.raises(CurveFileError):
            repr(read(text.encode()).surface)
    with pytest.raises(CurveFileError, match="the nearest are"):
        read("elipsoid")
    with pytest.raises(CurveFileError):
        read(str(tmp_path))


# ---- the denominator


def test_a_denominator_that_only_touches_zero_is_refused():
    # w = (u − 1/3)² + (v − 1/3)² on the unit square: its zero is not a dyadic number
    third = rational("1/3")
    line = [third**2, third**2 - third, (1 - third) ** 2]
    net = [[a + b for b in line] for a in line]
    points = [[(i, j, 0) for j in range(3)] for i in range(3)]
    knots = [0, 0, 0, 1, 1, 1]
    with pytest.raises(WeightError) as caught:
        NurbsSurface((2, 2), knots, knots, points, net)
    assert all(low <= third <= high for low, high in caught.value.data["witness"])
    raised = [[w + rational("1/1000") for w in row] for row in net]
    assert NurbsSurface((2, 2), knots, knots, points, raised).w(third, third) == rational("1/1000")


@given(st.lists(st.integers(-3, 9), min_size=9, max_size=9))
def test_no_sampled_zero_of_an_accepted_denominator(weights):
    net = [weights[3 * i : 3 * i + 3] for i in range(3)]
    points = [[(i, j, 0) for j in range(3)] for i in range(3)]
    knots = [0, 0, 0, 1, 1, 1]
    try:
        surface = NurbsSurface((2, 2), knots, knots, points, net)
    except WeightError as error:
        (a, b), (c, d) = error.data["witness"]
        assert 0 <= a <= b <= 1
        assert 0 <= c <= d <= 1
        return
    values = [surface.w(rational(f"{i}/7"), rational(f"{j}/7")) for i in range(8) for j in range(8)]
    assert all(x > 0 for x in values) or all(x < 0 for x in values)


def test_calls_that_are_refused():
    f = NurbsSurface((1, 1), UNIT, UNIT, SQUARE)
    for call, error in (
        (lambda: f(2, 0), DomainError),
        (lambda: f.partial(-1, 0, 0, 0), FormulaError),
        (lambda: f.isocurve("w", 0), FormulaError),
        (lambda: f.isocurve("u", 2), DomainError),
        (lambda: f.insert_knot("u", 0), DomainError),
        (lambda: f.split("u", 1), DomainError),
        (lambda: NurbsSurface(1, UNIT, UNIT, SQUARE), ShapeError),
        (lambda: NurbsSurface((1, 1), UNIT, UNIT, 5), ShapeError),
        (lambda: NurbsSurface((1, 1), UNIT, UNIT, [5, 6]), ShapeError),
        (lambda: NurbsSurface((1, 1), UNIT, UNIT, SQUARE, 5), ShapeError),
        (lambda: NurbsSurface((1, 1), UNIT, UNIT, [[(0.5, 0), (0, 1)]] * 2), NumberError),
    ):
        with pytest.raises(error):
            call()
    assert isinstance(f.isocurve("v", 0), Nurbs)
    assert issubclass(WeightError, ExactSplineError)


def test_a_zero_of_a_weight_lies_in_the_box_that_is_told():
    """Of −1 + 2x, of (2x − 1)(2y − 1) + ε with a corner at 0, and where no corner is negative none is told."""
    for net in ([[-1], [1]], [[1, 1], [-1, 1]], [[3, -1], [1, 1]], [[-1, -1], [-1, 2]]):
        form = PatchForm.of_net(net)
        (a, b), (c, d) = found = zero_at_corners(Sized(SQUARE_OF_PARAMETERS, [form]))
        values = [form.value(x, y) for x in (a, b) for y in (c, d)]
        assert min(values) <= 0 <= max(values), net
        assert found == ((a, a), (c, c)) or (b - a) * (d - c) == mpq(1, 2**DEPTH)
    for net in ([[1, 2], [3, 4]], [[1, -1, 1], [1, -1, 1]]):
        assert zero_at_corners(Sized(SQUARE_OF_PARAMETERS, [PatchForm.of_net(net)])) is None
    for corner in range(4):
        values = [5, 1, 2, 3]
        values[corner] = 0
        place = mpq(corner // 2), mpq(corner % 2)
        box = (mpq(1), mpq(2)), (mpq(3), mpq(5))
        (x, _), (y, _) = zero_at_corners(Sized(box, [PatchForm.of_net([values[:2], values[2:]])]))
        assert (x, y) == (box[0][int(place[0])], box[1][int(place[1])])
