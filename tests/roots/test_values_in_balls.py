"""Values and signs of splines at irrational numbers, by balls, compared with exact arithmetic with square roots."""

import pickle
import random
from itertools import pairwise

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, example, zeros
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves.values import CurvatureAt, curvature, signed_square, torsion
from exactspline.polynomials.elimination import without_quadratic_zero
from exactspline.reals.real import Real, square_root
from exactspline.roots.values import evaluate, exact_place, segment_of, sign_at, value_at


def hostile_points(chance, n):
    """Bézier points that cancel, vanish at an end, are huge or tiny, or differ by hundreds of digits."""
    kind = chance.randrange(5)
    points = [mpq(chance.randint(-9, 9), chance.randint(1, 9)) for _ in range(n + 1)]
    if kind == 1:
        points = [x * mpq(10) ** chance.choice((-200, 0, 200)) for x in points]
    if kind == 2:
        points = [1 + x * mpq(1, 10**60) for x in points]
    if kind == 3:
        points = [mpq(0)] * (n // 2) + points[n // 2 :]
    if kind == 4:
        points = [x * (-1) ** i * mpq(10) ** 80 for i, x in enumerate(points)]
    return points


def exactly(f, t):
    """The value of a spline of one segment at a quadratic number, by de Casteljau's algorithm."""
    points = [Real(x) for x in f.control_points]
    while len(points) > 1:
        points = [a + (b - a) * t for a, b in pairwise(points)]
    return points[0]


def quadratic_places(chance):
    """√q in (0, 1), as a number and as a root of a spline, isolated in doubles or not."""
    t = BSpline.identity(0, 1)
    q = mpq(chance.randint(1, 10**6 - 1), 10**6 + chance.randint(1, 99))
    place = square_root(q)
    return [] if place.exact is not None else [place, zeros(t * t - q).roots[0]]


@pytest.mark.parametrize("seed", range(6))
def test_values_and_signs_at_square_roots(seed):
    chance = random.Random(seed)
    for _ in range(20):
        n = chance.choice((0, 1, 2, 3, 7))
        top, bottom = (BSpline.bezier(hostile_points(chance, n)) for _ in range(2))
        for place in quadratic_places(chance):
            above, below = exactly(top, place), exactly(bottom, place)
            assert sign_at(top, place) == above.sign
            if not below.sign:
                continue
            value, expected = value_at(top, bottom, place), above / below
            for digits in (0, 12, 40, 300):
                low, high = value.enclosure(digits)
                assert low <= expected <= high
                assert (high - low) * mpq(10) ** digits <= 1
            assert value == expected
            assert value.closed_form == expected.closed_form


def test_a_value_at_a_double_zero_is_zero():
    t = BSpline.identity(0, 2)
    f = t * t - 2
    root = zeros(f).roots[0]
    assert sign_at(f * f, root) == 0
    assert value_at(f * f, t, root).exact == 0


def test_places_next_to_a_knot_and_on_other_meshes():
    """A root so near to a knot that z is huge, and a function with other breakpoints than the root's."""
    t = BSpline.identity(0, 1)
    root = zeros(t * t - (1 - mpq(1, 10**30))).roots[0]
    assert value_at(t * t, t.constant(1), root).exact == 1 - mpq(1, 10**30)
    other = BSpline(1, [0, 0, mpq(1, 3), 2, 2], [0, 1, 0])
    assert segment_of(other, root) == 1
    assert value_at(other, t, root) == (2 - root) * mpq(3, 5) / root
    assert sign_at(t - root.enclosure(40).low, root) == 1


@pytest.mark.parametrize(
    "name",
    [
        "cubic_s",
        "rational_cubic_s",
        "space_quartic",
        "rational_space_cubic",
        "rational_quartic",
        "six_segment_cubic",
        "rational_space_cubic_spline",
    ],
)
def test_curvature_and_torsion_agree_with_rational_places_nearby(name):
    curve = example(name)
    irrational = [found for found in analyse(curve).curvature_extrema if found.root.exact is None]
    assert irrational
    for feature in irrational:
        near = feature.root.enclosure(60).middle
        assert abs(curvature(curve, feature.root) - curvature(curve, near)) < mpq(1, 10**40)
        point = evaluate(curve, feature.root)
        assert all(abs(x - y) < mpq(1, 10**40) for x, y in zip(point, curve(near), strict=True))
        if curve.dimension == 3:
            assert abs(torsion(curve, feature.root) - torsion(curve, near)) < mpq(1, 10**40)


def test_negative_weights_do_not_change_curvature():
    points, weights = [(0, 0), (1, 3), (4, -2), (5, 1)], [1, 2, 3, 1]
    curve = Nurbs(3, [0] * 4 + [1] * 4, points, weights)
    other = Nurbs(3, [0] * 4 + [1] * 4, points, [-w for w in weights])
    t = square_root("1/2")
    assert curvature(curve, t) == curvature(other, t)
    assert curvature(curve, t).sign == curvature(curve, t.enclosure(30).low).sign


@pytest.mark.parametrize("seed", range(3))
def test_no_quadratic_value_is_called_neither(seed):
    """Values in a field of degree 4 or 6 with a quadratic number in it; the polynomial may have other zeros, too."""
    chance = random.Random(seed)
    for _ in range(40):
        a, b, k = chance.randint(-9, 9), chance.choice((2, 3, 5, 7)), chance.choice((2, 3))
        inner = fmpz_poly([a] + [0] * (k - 1) + [1])  # y = xᵏ + a
        m = inner * inner - b  # y = ±√b
        others = fmpz_poly([chance.randint(-9, 9) for _ in range(4)] + [1])
        for modulus in (m, m * others):
            assert not without_quadratic_zero(modulus, inner * 3 + 1, fmpz_poly([5]))
            assert not without_quadratic_zero(modulus, inner, inner + 1)
            assert not without_quadratic_zero(modulus, fmpz_poly([7]), fmpz_poly([2]))
            # square roots of squares of quadratic numbers, of a rational number, and of 0
            for top, bottom in ((inner * 3 + 1, fmpz_poly([5])), (inner, inner + 1), (m, inner + 1)):
                assert not without_quadratic_zero(modulus, top**2, bottom**2, squared=True)
            assert not without_quadratic_zero(modulus, fmpz_poly([chance.randint(1, 99)]), fmpz_poly([2]), squared=True)


def test_square_roots_outside_every_quadratic_field():
    """The fourth root of 3, and the square root of 3 + √2, whose square is quadratic; √(3 + 2√2) is 1 + √2."""
    fourth, root = fmpz_poly([-3, 0, 0, 0, 1]), fmpz_poly([-2, 0, 0, 0, 1])
    one, square = fmpz_poly([1]), fmpz_poly([0, 0, 1])
    assert without_quadratic_zero(fourth, square, one, squared=True)
    assert without_quadratic_zero(root, square + 3, one, squared=True)
    assert not without_quadratic_zero(root, square * 2 + 3, one, squared=True)


def curves_with_features(chance):
    """A curve in the plane or in space, polynomial or rational, of integers or doubles."""
    n, dimension = chance.randint(2, 5), chance.choice((2, 2, 3))
    whole = chance.random() < 0.7
    numbers = [[chance.randint(-9, 9) for _ in range(dimension)] for _ in range(n + 2)]
    points = numbers if whole else [[mpq(x + chance.random()) for x in row] for row in numbers]
    weights = chance.choice((None, [chance.randint(1, 5) for _ in range(n + 2)]))
    return Nurbs(n, [0] * (n + 1) + [1] + [2] * (n + 1), points, weights)


@pytest.mark.parametrize("seed", range(2))
def test_curvature_by_a_ball_is_the_exact_one(seed):
    """Its digits, its closed form, its sign and its pickle; at an inflection it is 0."""
    chance, found = random.Random(seed), 0
    for _ in range(12):
        curve = curves_with_features(chance)
        facts = analyse(curve)
        for feature in (*facts.inflections, *facts.curvature_extrema):
            if feature.root.exact is not None:
                continue
            place = exact_place(feature.root)
            near = curvature(curve, place)
            found += isinstance(near, CurvatureAt)
            exact = near.exactly() if isinstance(near, CurvatureAt) else Real(0)
            assert near.double() == exact.double()
            assert near.sign == exact.sign
            for digits in (5, 18, 40):
                assert near.enclosure(digits).meets(exact.enclosure(digits))
                assert near.around(digits) == exact.around(digits)
            assert near.closed_form == exact.closed_form
            assert near == exact == pickle.loads(pickle.dumps(near))
    assert found > 10


@pytest.mark.parametrize("seed", range(4))
def test_the_square_of_curvature_at_knots(seed):
    """By the ends of a segment: as by the derivatives with respect to the parameter, on both sides of a knot."""
    chance = random.Random(seed)
    for _ in range(20):
        curve = curves_with_features(chance)
        for t, side in ((0, "right"), (1, "left"), (1, "right"), (2, "left")):
            first, second = (curve.derivative(k, t, side) for k in (1, 2))
            square, product = sum(x * x for x in first), sum(x * y for x, y in zip(first, second, strict=True))
            if not square:
                continue
            sign, top, bottom = signed_square(curve, mpq(t), left=side == "left")
            assert mpq(top, bottom) == (square * sum(y * y for y in second) - product**2) / square**3
            turning = first[0] * second[1] - first[1] * second[0]
            assert sign == (1 if curve.dimension == 3 else (turning > 0) - (turning < 0))
