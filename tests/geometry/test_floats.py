"""Correctly rounded doubles: values, derivatives, κ, τ, roots, knots and control points against mpmath at 200 bits.

``EXACTSPLINE_FLOATS=100000 pytest tests/geometry/test_floats.py`` holds this many values of every question against
mpmath.
"""

import math
import os
import random
from fractions import Fraction

import mpmath
import pytest
from gmpy2 import mpq
from mpmath import libmp, mp

import exactspline as xs
from exactspline import ExactSplineError, example, square_root
from exactspline.errors import FormulaError, NumberError, ShapeError
from exactspline.numbers.exact import Rounding, double, is_float
from exactspline.roots.values import signed_root, value_at
from tests.support.vectors import cross

COUNT = int(os.environ.get("EXACTSPLINE_FLOATS", "300"))
BITS = 200
WAYS = {"nearest": "n", "down": "f", "up": "c"}


def random_curve(chance, dimension, rational, least_degree=2):
    """A curve of one or two segments with doubles, small integers or fractions as data."""
    degree, segments = chance.randint(least_degree, 4), chance.randint(1, 2)
    knots = [0] * (degree + 1) + ["1/2"] * (segments - 1) + [1] * (degree + 1)

    def number():
        return chance.choice(
            [
                lambda: mpq(chance.randint(-9, 9)),
                lambda: xs.from_floats(chance.uniform(-3, 3)),
                lambda: mpq(chance.randint(-99, 99), chance.randint(1, 99)),
            ]
        )()

    points = [[number() for _ in range(dimension)] for _ in range(degree + segments)]
    weights = [mpq(chance.randint(1, 9), chance.randint(1, 9)) for _ in points] if rational else None
    return xs.Nurbs(degree, knots, points, weights)


def at_200_bits(q):
    return mp.mpf(libmp.from_rational(int(q.numerator), int(q.denominator), BITS))


def power_form(points):
    """The coefficients of 1, t, t², … for Bézier points."""
    n = len(points) - 1
    return [
        math.comb(n, k) * sum(((-1) ** (k - j) * math.comb(k, j) * points[j] for j in range(k + 1)), start=mpq(0))
        for k in range(n + 1)
    ]


def series(f, t, order):
    """f and its derivatives at t in 200 bits, by the power form of the segment."""
    i = f.mesh.locate(t) if isinstance(t, mpq) else next(i for i, b in enumerate(f.breakpoints[1:]) if t < b)
    a, b = f.breakpoints[i : i + 2]
    powers = power_form(f.bezier_points[i])
    u = (parameter(t) - at_200_bits(a)) / at_200_bits(b - a)
    rows = [
        sum((at_200_bits(c * math.perm(k, r)) * u ** (k - r) for k, c in enumerate(powers) if k >= r), start=mp.mpf(0))
        for r in range(order + 1)
    ]
    return [row / at_200_bits(b - a) ** r for r, row in enumerate(rows)]


def parameter(t):
    """A parameter in 200 bits; a root from an interval of 80 digits."""
    return at_200_bits(t) if not isinstance(t, xs.Root) else at_200_bits(sum(t.refine(80)) / 2)


def derivatives(curve, t, order):
    """The curve and its derivatives in 200 bits, by Taylor series."""
    w = series(curve.w, t, order)
    rows = []
    for x in curve.p:
        p, found = series(x, t, order), []
        for k in range(order + 1):
            found.append((p[k] - sum(math.comb(k, j) * w[j] * found[k - j] for j in range(1, k + 1))) / w[0])
        rows.append(found)
    return list(zip(*rows, strict=True))


def curvature(curve, t):
    _, v, a = derivatives(curve, t, 2)
    speed = mp.sqrt(sum(x * x for x in v))
    if len(v) == 2:
        return (v[0] * a[1] - v[1] * a[0]) / speed**3
    return mp.sqrt(sum(x * x for x in cross(v, a))) / speed**3


def torsion(curve, t):
    _, v, a, j = derivatives(curve, t, 3)
    bend = cross(v, a)
    return sum(x * y for x, y in zip(bend, j, strict=True)) / sum(x * x for x in bend)


def agrees(found, value, rounding, scale=1):
    """Whether a double is what a number rounds to, None where 200 bits do not tell: too near to a border, or to 0."""
    slack = max(abs(value), abs(mp.mpf(scale))) * mp.mpf(2) ** -150
    ends = {libmp.to_float(x._mpf_, rnd=WAYS[rounding]) for x in (value - slack, value + slack)}
    return None if len(ends) > 1 else found in ends


def parameters(chance, curve, count):
    """Rational ones, doubles, and irrational roots: where a coordinate takes a value."""
    for _ in range(count):
        if chance.random() < 0.5:
            yield chance.choice([mpq(chance.randint(0, 60), 60), chance.random()])
        else:
            x = chance.choice(list(curve.p))
            low, high = sorted((x(0), x(1)))
            level = low + (high - low) * mpq(chance.randint(1, 96), 97)
            yield from [r for r in xs.zeros(x - level) if r.exact is None][:1]


def exact_parameter(t):
    return xs.from_floats(t) if is_float(t) else t


def doubles_of(ours, theirs, curve, t, way):
    return [ours(curve, t).double(way)], [theirs(curve, t)]


QUESTIONS = {
    "point": lambda c, t, way: (c.floats(t, rounding=way), derivatives(c, exact_parameter(t), 0)[0]),
    "first": lambda c, t, way: (c.floats(t, order=1, rounding=way), derivatives(c, exact_parameter(t), 1)[1]),
    "third": lambda c, t, way: (c.floats(t, order=3, rounding=way), derivatives(c, exact_parameter(t), 3)[3]),
    "curvature": lambda c, t, way: doubles_of(xs.curvature, curvature, c, exact_parameter(t), way),
    "curvatures": lambda c, t, way: (c.floats([t], of="curvature", rounding=way), [curvature(c, exact_parameter(t))]),
    "torsion": lambda c, t, way: doubles_of(xs.torsion, torsion, c, exact_parameter(t), way),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_values_are_correctly_rounded(question):
    chance, held, left = random.Random(question), 0, 0
    twisted = question == "torsion"  # of degree 2 every curve is plane: τ = 0, of which no digits tell
    with mp.workprec(BITS + 20):
        while held < COUNT:
            dimension, rational = 3 if twisted else chance.choice((2, 3)), chance.random() < 0.5
            curve = random_curve(chance, dimension, rational, least_degree=3 if twisted else 2)
            for t in parameters(chance, curve, 20 if COUNT < 1000 else 100):
                way = chance.choice(list(WAYS))
                try:
                    found, expected = QUESTIONS[question](curve, t, way)
                except ExactSplineError:  # a singular point
                    continue
                for x, y in zip(found, expected, strict=True):
                    verdict = agrees(x, y, way, scale=1 + max(map(abs, expected)))
                    assert verdict is not False, (curve.control_points, curve.weights, t, way, x, y)
                    held, left = held + (verdict is True), left + (verdict is None)
    assert left < held / 3


def test_roots_are_correctly_rounded():
    chance, held = random.Random(5), 0
    with mp.workprec(BITS + 20):
        while held < COUNT:
            points = [chance.choice([mpq(chance.randint(-9, 9)), xs.from_floats(chance.gauss(0, 1))]) for _ in range(4)]
            for root in xs.zeros(xs.BSpline.bezier(points)):
                if root.exact is not None:
                    continue
                polynomial = [at_200_bits(c) for c in reversed(power_form(points))]
                near = mp.mpf(float(root))
                for _ in range(9):
                    value, slope = mpmath.polyval(polynomial, near, derivative=True)
                    near = near - value / slope if slope else near
                for way in WAYS:
                    assert agrees(xs.floats(root, rounding=way), near, way, scale=abs(near)) is not False, points
                    held += 1


def test_knots_and_control_points_are_correctly_rounded():
    chance, held = random.Random(6), 0
    while held < COUNT:
        curve = random_curve(chance, 2, rational=True)
        numbers = [x for point in curve.control_points for x in point]
        for way, mode in WAYS.items():
            rounded = [y for row in xs.floats(curve.control_points, rounding=way) for y in row]
            for x, found in zip(numbers, rounded, strict=True):
                held += 1
                assert found == libmp.to_float(
                    libmp.from_rational(int(x.numerator), int(x.denominator), 2000), rnd=mode
                )
    assert xs.floats(curve.knots)[-1] == 1.0


@pytest.mark.parametrize("value", [
    mpq(1, 3), mpq(-1, 3), mpq(1, 10**400), mpq(-1, 10**400), mpq(3, 2**1075), mpq(2**53 + 1), -mpq(2**53) - 1, mpq(0)
])  # fmt: skip
def test_down_and_up_are_neighbours_around_the_number(value):
    low, high = double(value, "down"), double(value, "up")
    assert Fraction(low) <= Fraction(int(value.numerator), int(value.denominator)) <= Fraction(high)
    assert low == high or math.nextafter(low, math.inf) == high
    assert double(value) in (low, high)


def test_a_tie_goes_to_the_even_double_and_a_double_to_itself():
    """Rational at an irrational parameter: √2 · √2 at a root, exactly between two doubles."""
    t = xs.BSpline.identity(0, 2)
    (root,) = xs.zeros(t * t - 2)
    tie = mpq(2**53 + 1)
    halfway = value_at((t * t).scaled(tie / 2), t.constant(1), root)
    assert [halfway.double(way) for way in ("nearest", "down", "up")] == [2.0**53, 2.0**53, 2.0**53 + 2]
    assert halfway.closed_form == str(2**53 + 1)
    exactly = value_at(t * t, t.constant(1), root)
    assert {exactly.double(way) for way in Rounding} == {2.0}
    signed = signed_root(-1, value_at(t * t * t * t, t.constant(1), root))
    assert {signed.double(way) for way in Rounding} == {-2.0}
    assert signed == -2
    assert signed < 1
    assert halfway.exact == tie
    assert value_at(t * t - 2, t.constant(1), root).double() == 0.0


def test_beyond_the_largest_double():
    huge, largest = mpq(10) ** 400, float.fromhex("0x1.fffffffffffffp1023")
    assert (double(huge, "down"), double(-huge, "up")) == (largest, -largest)
    for value, way in ((huge, "nearest"), (huge, "up"), (-huge, "down"), (-huge, "nearest")):
        with pytest.raises(OverflowError):
            double(value, way)
    with pytest.raises(OverflowError):
        square_root(huge * huge * 2).double()


def test_what_is_no_way_of_rounding():
    with pytest.raises(NumberError, match="nearest, down, up"):
        double(mpq(1), "towards zero")
    with pytest.raises(ExactSplineError, match="order"):
        xs.example("circle").floats([0], order=-1)


def test_floats_of_numpy_and_lists_in_one_call():
    np = pytest.importorskip("numpy")
    curve = xs.Nurbs.from_floats(2, np.array([0, 0, 0, 1, 1, 1]), np.array([[0, 0], [0.1, 1], [1, 0]]))
    single = xs.Nurbs.from_floats(2, [0, 0, 0, 1, 1, 1], np.array([[0, 0], [0.1, 1], [1, 0]], dtype=np.float32))
    assert curve.control_points[1][0] == xs.from_floats(0.1) != single.control_points[1][0]
    snapped = xs.Nurbs.from_floats(1, [0, 0, 1, 1], [[0.1, 0], [1, 2]], weights=[0.3, 1], snap=True)
    assert snapped.weights[0] == mpq(3, 10)
    ts = np.linspace(0, 1, 5)
    assert curve.floats(ts).shape == (5, 2)
    assert (curve.floats(ts) == curve.floats(list(map(float, ts)))).all()
    with pytest.raises(NumberError):
        xs.Nurbs.from_floats(1, [0, 0, 1, 1], [[float("nan"), 0], [1, 2]])
    with pytest.raises(NumberError):
        curve.floats([float("inf")])


def test_a_user_of_scipy_in_three_lines():
    np = pytest.importorskip("numpy")
    interpolate = pytest.importorskip("scipy.interpolate")
    points = np.array([[0, 0], [1, 2], [2, -2], [3, 0]])
    curve = xs.interchange.from_scipy(interpolate.BSpline(np.array([0.0] * 4 + [1] * 4), points, 3))
    assert xs.floats(xs.analyse(curve).inflections) == [0.5]


@pytest.mark.parametrize("order", [-1, True, 1.0, "1", None])
def test_orders_of_derivatives_are_natural_numbers(order):
    with pytest.raises(FormulaError, match="orders are 0, 1, 2"):
        example("circle").floats([0.5], order=order)


def test_curvatures_of_many_parameters():
    """At a cusp no curvature: NaN; the others are those one by one."""
    cusp, ts = xs.example("cusp"), [0, 0.25, 0.5, "1/3", 1]
    values = cusp.floats(ts, of="curvature").tolist()
    assert [math.isnan(value) for value in values] == [False, False, True, False, False]
    assert [values[i] for i in (0, 1, 3, 4)] == [float(xs.curvature(cusp, t)) for t in (0, "1/4", "1/3", 1)]
    (root,) = xs.zeros(cusp.p[0] * cusp.p[0] - cusp.p[0].constant("1/50")).roots[:1]
    first, second = cusp.floats([root, mpq(1, 2)], of="curvature")
    assert first == float(xs.curvature(cusp, root))
    assert math.isnan(second)
    space = xs.example("twisted_cubic")
    assert space.floats(0.25, of="curvature") == float(xs.curvature(space, "1/4"))
    with pytest.raises(xs.errors.DomainError):
        cusp.floats([0, 2], of="curvature")
    with pytest.raises(xs.errors.ShapeError):
        xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)]).floats([0], of="curvature")


def test_sides_at_a_knot():
    curve = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 0), (2, 1), (3, 2), (3, 4)])
    for side in ("left", "right"):
        value = curve.floats(1, of="curvature", side=side)
        assert value == float(xs.curvature(curve, 1, side)) != 0


@pytest.mark.parametrize("name", ["cubic_s", "circle", "twisted_cubic", "rational_space_cubic"])
def test_directions_against_the_derivatives(name):
    """Unit tangents and normals at rational and irrational parameters, against derivatives in 200 bits."""
    curve = xs.example(name)
    (root,) = [r for r in xs.zeros(curve.p[0] * curve.p[0] - curve.w * curve.w / 7) if r.exact is None][:1]
    with mp.workprec(BITS):
        for t in (mpq(1, 7), root):
            _, v, a = derivatives(curve, t, 2)
            along = sum(x * y for x, y in zip(v, a, strict=True)) / sum(x * x for x in v)
            bent = [y - along * x for x, y in zip(v, a, strict=True)] if len(v) == 3 else [-v[1], v[0]]
            for of, vector in (("tangent", v), ("unit_tangent", v), ("normal", bent)):
                size = 1 if of == "tangent" else mp.sqrt(sum(x * x for x in vector))
                for found, x in zip(curve.floats(t, of=of), vector, strict=True):
                    assert agrees(found, x / size, "nearest") is not False


def test_surfaces_functions_and_what_is_undefined():
    """A grid is broadcast; where a cone has no tangent plane, and at a cusp, NaN."""
    sphere, ts = xs.example("sphere"), [0.25, 0.5, 0.75]
    grid = sphere.floats([[t] for t in ts], ts)
    assert grid.shape == (3, 3, 3)
    assert grid[0, 1].tolist() == [float(x) for x in sphere("1/4", "1/2")]
    assert sphere.floats(ts, ts, order=(1, 0))[1].tolist() == [float(x) for x in sphere.partial(1, 0, "1/2", "1/2")]
    (told,) = xs.analyse(sphere).curvature(("1/4", "1/2"))
    assert sphere.floats(0.25, 0.5, of="mean_curvature") == float(told.values["H"])
    assert [float(x) for x in sphere.normal("1/4", "1/2")] == sphere.floats(0.25, 0.5, of="normal").tolist()
    cone = xs.NurbsSurface(
        (1, 2), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [[(0, 0, 0)] * 3, [(1, 0, 1), (1, 1, 1), (0, 1, 1)]]
    )
    assert all(map(math.isnan, cone.floats(0, 0.5, of="normal")))
    assert math.isnan(cone.floats(0, 0.5, of="gaussian_curvature"))
    assert all(map(math.isnan, xs.example("cusp").floats(0.5, of="unit_tangent")))
    product = sphere.p[0]
    assert product.floats(0.25, 0.5, order=(0, 1)) == float(product.partial(0, 1)("1/4", "1/2"))
    t = xs.BSpline.identity(0, 2)
    assert (t * t).floats(ts, order=1).tolist() == [0.5, 1.0, 1.5]
    assert (t * t).floats(xs.zeros(t * t - 2), order=0).tolist() == [2.0]


@pytest.mark.parametrize(("call", "says"), [
    (lambda c: c.floats(), "curve.floats"),
    (lambda c: c.floats([0], [1]), "2 rows of parameters"),
    (lambda c: c.floats(0, of="colour"), "the quantity 'colour' is unknown"),
    (lambda c: c.floats(0, of="curvature", order=1), "a derivative of the curvature"),
    (lambda c: c.floats(0, of="mean_curvature"), "mean_curvature of a curve"),
    (lambda c: c.p[0].floats(0, of="normal"), "exactspline.graph"),
    (lambda c: xs.example("torus").floats(0), "us, vs"),
    (lambda c: xs.example("torus").floats(0, 0, order=1), r"order=\(1, 0\)"),
    (lambda c: xs.example("torus").floats(0, 0, of="torsion"), "torsion of a surface"),
    (lambda c: xs.floats([0], [1]), "curve.floats"),
])  # fmt: skip
def test_what_floats_does_not_take(call, says):
    with pytest.raises(xs.ExactSplineError, match=says):
        call(xs.example("cubic_s"))


def test_what_is_asked_of_a_surface_is_used_or_refused():
    """Passed before: the side was not used, and K of a function was its value."""
    function = xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]])
    with pytest.raises(ShapeError, match="of a function"):
        function.floats([0.5], [0.5], of="gaussian_curvature")
    for given in (function, xs.example("torus")):
        with pytest.raises(ShapeError, match="left side"):
            given.floats([0.5], [0.5], side="left")
