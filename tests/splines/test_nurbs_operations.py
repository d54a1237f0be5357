"""What a curve can do: insertion, elevation, parts, reversal, maps; values, derivatives, frames, curvature, torsion."""

from math import factorial

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

import exactspline as xs
from exactspline import curvature, torsion
from exactspline.errors import DomainError, FormulaError, KnotError, ShapeError, WeightError
from exactspline.readings import series_curve
from tests.support.strategies import nurbs

ARC = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2], name="arc")
PARABOLA = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
PLACES = [mpq(k, 9) for k in range(1, 9)]
#: t² = 1/2 on [0, 1].
(HALF,) = xs.zeros(xs.BSpline.bezier([-1, -1, 1]))


@given(nurbs(most=2), st.sampled_from([mpq(1, 3), mpq(5, 8)]), st.integers(1, 2))
def test_the_curve_stays_what_it_is(curve, place, by):
    a, b = curve.domain
    t = a + (b - a) * place
    elevated = curve.elevate_degree(by)
    assert elevated == curve
    assert elevated.degree == curve.degree + by
    assert elevated.polynomial == curve.polynomial
    if t not in curve.breakpoints:
        finer = curve.insert_knot(t, by)
        assert finer == curve
        assert finer.knots.multiplicity(t) == by
    first, second = curve.split(t)
    assert (first.domain, second.domain) == ((a, t), (t, b))
    for x in (a + (t - a) * p for p in PLACES):
        assert first(x) == curve(x)
    for x in (t + (b - t) * p for p in PLACES):
        assert second(x) == curve(x)
    assert curve.restrict(a, b) == curve
    back = curve.reverse()
    assert all(back(a + b - x, "left") == curve(x) for x in (a + (b - a) * p for p in PLACES))
    assert back.reverse() == curve


@given(nurbs(dimension=3), st.lists(st.integers(-3, 3), min_size=16, max_size=16))
def test_a_map_of_the_curve_maps_its_points(curve, entries):
    a, b = curve.domain
    places = [a + (b - a) * p for p in PLACES]
    matrix = [entries[4 * i : 4 * i + 4] for i in range(4)]
    affine, linear = matrix[:3], [row[:3] for row in matrix[:3]]
    for x in places:
        point = curve(x)
        straight = tuple(sum(m * c for m, c in zip(row, point, strict=True)) for row in linear)
        assert curve.transform(linear)(x) == straight
        assert curve.transform(affine)(x) == tuple(c + row[3] for c, row in zip(straight, affine, strict=True))
    assert curve.transform([[1, 0, 0], [0, 1, 0]]).dimension == 2
    projective = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], matrix[3]]
    try:
        image = curve.transform(projective)
    except WeightError:
        return
    for x in places:
        point = curve(x)
        below = sum(m * c for m, c in zip(matrix[3], (*point, 1), strict=True))
        assert image(x) == tuple(c / below for c in point)


def test_a_projective_map_makes_a_circle_of_a_parabola():
    """(x, y) ↦ ((1 − y)/(1 + y), 2x/(1 + y)) takes y = x² to the unit circle."""
    image = PARABOLA.transform([[0, -1, 1], [2, 0, 0], [0, 1, 1]])
    assert not image.polynomial
    assert all(x * x + y * y == 1 for x, y in map(image, PLACES))


def test_what_is_not_a_matrix_or_a_point_is_refused():
    """Before, the errors of Python: "'int' object is not iterable"."""
    for call in (
        lambda: PARABOLA.transform(2),
        lambda: PARABOLA.transform([1, 2]),
        lambda: PARABOLA.transform("12"),
        lambda: PARABOLA.with_point(None),
        lambda: PARABOLA.with_point("12"),
    ):
        with pytest.raises(ShapeError, match="are expected"):
            call()


@pytest.mark.parametrize("matrix", [[[1, 0], [0]], [[1, 0, 0, 0]] * 2, [[1, 2, 3]], [[1, 0, 0]] * 4, []])
def test_a_matrix_of_another_shape_is_refused(matrix):
    with pytest.raises(ShapeError) as caught:
        ARC.transform(matrix)
    assert caught.value.where == "matrix"


@pytest.mark.parametrize("weights", [None, "one", "many"])
@pytest.mark.parametrize("ends", [0, 3], ids=["unclamped", "clamped"])
def test_a_short_part_of_a_long_curve_is_the_part_of_its_splines(weights, ends):
    """The splines of the whole are not computed for it."""
    inner = sorted([*range(30), 7, 7, 11, 11, 11, 15])
    knots = [*[0] * ends, *inner, *[29] * ends]
    points = [(k, k * k % 7) for k in range(len(knots) - 4)]
    given = weights and [1 + (k == 20 if weights == "one" else k % 3) for k in range(len(points))]
    for a, b in ((5, 6), ("16/3", "15/2"), (7, 9), (10, 11), (11, "23/2"), (15, 17)):
        curve, whole = (xs.Nurbs(3, knots, points, given) for _ in range(2))
        assert len(whole.p) == 2
        part, same = curve.restrict(a, b), whole.restrict(a, b)
        assert "_splines" not in vars(curve) or (weights == "one")
        assert (part.knots, part.control_points, part.weights) == (same.knots, same.control_points, same.weights)
    with pytest.raises(DomainError, match=r"part of the domain \[.*, 2.\]"):
        xs.Nurbs(3, knots, points, given).restrict(7, 7)


def test_what_cannot_be_done_is_refused():
    with pytest.raises(DomainError):
        ARC.insert_knot(0)
    with pytest.raises(KnotError):
        ARC.insert_knot("1/2", 4)
    with pytest.raises(DomainError):
        ARC.split(1)
    with pytest.raises(DomainError):
        ARC.restrict("1/2", 2)
    with pytest.raises(WeightError):
        PARABOLA.transform([[1, 0, 0], [0, 1, 0], [2, 0, -1]])


@given(nurbs(dimension=3, most=1), st.sampled_from(["left", "right"]))
def test_derivatives_are_those_of_the_taylor_series(curve, side):
    """By Leibniz' rule here, by a division of series there."""
    for t in [*curve.breakpoints[1:-1], sum(curve.domain) / 2]:
        series = series_curve(curve, t, 5, side).gamma
        for order in range(5):
            expected = tuple(x.coefficients[order] * factorial(order) for x in series)
            assert curve.derivative(order, t, side) == expected
    assert curve.tangent(t, side) == curve.derivative(1, t, side)
    assert curve.derivative(0, t, side) == curve(t, side)


def test_derivatives_beyond_the_degree_and_below_zero():
    assert PARABOLA.derivative(3, "1/2") == (0, 0)
    with pytest.raises(FormulaError):
        PARABOLA.derivative(-1, 0)
    with pytest.raises(DomainError):
        PARABOLA.derivative(1, 2)


def dot(a, b):
    return sum((x * y for x, y in zip(a, b, strict=True)), mpq(0))


@given(nurbs(most=0), st.sampled_from(PLACES))
def test_the_frame_in_the_plane(curve, place):
    a, b = curve.domain
    t = a + (b - a) * place
    velocity = curve.tangent(t)
    if not any(velocity):
        with pytest.raises(DomainError):
            curve.unit_tangent(t)
        return
    tangent, normal = curve.unit_tangent(t), curve.normal(t)
    assert sum(x**2 for x in tangent) == sum(x**2 for x in normal) == 1
    assert all((x > 0) == (v > 0) and (x == 0) == (v == 0) for x, v in zip(tangent, velocity, strict=True))
    assert normal == (-tangent[1], tangent[0])
    # κ from its definition, squared, and its sign
    bend = curve.derivative(2, t)
    turning = velocity[0] * bend[1] - velocity[1] * bend[0]
    kappa = curvature(curve, t)
    assert kappa**2 == turning**2 / dot(velocity, velocity) ** 3
    assert (kappa > 0) == (turning > 0)
    assert (kappa == 0) == (turning == 0)


def test_the_frame_in_space():
    """The twisted cubic (t, t², t³): textbook values at 0."""
    curve = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0, 0), ("1/3", 0, 0), ("2/3", "1/3", 0), (1, 1, 1)])
    assert curve.unit_tangent(0) == (1, 0, 0)
    assert curve.normal(0) == (0, 1, 0)
    assert (curvature(curve, 0), torsion(curve, 0)) == (2, 3)
    for t in PLACES:
        kappa, tau = curvature(curve, t), torsion(curve, t)
        assert kappa**2 == 4 * (1 + 9 * t**2 + 9 * t**4) / (1 + 4 * t**2 + 9 * t**4) ** 3
        assert tau == 3 / (1 + 9 * t**2 + 9 * t**4)
        normal = curve.normal(t)
        assert sum(x**2 for x in normal) == 1
        squares = [x * abs(x) for x in curve.tangent(t)]
        assert len(squares) == len(normal) == 3


def test_curvature_on_a_circle_whatever_its_weights():
    for weights in ([1, 1, 2], [-1, -1, -2], [3, 3, 6]):
        arc = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights)
        assert [curvature(arc, t) for t in PLACES] == [1] * 8
        assert curvature(arc.reverse(), "1/3") == -1
        assert curvature(arc, HALF).enclosure(25).high - 1 <= mpq(1, 10**25)
        assert curvature(arc, HALF) == 1


def test_where_there_is_no_curvature():
    cusp = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (0, 0), (0, 1), (1, 1)])
    with pytest.raises(DomainError, match="γ′ = 0"):
        curvature(cusp, 0)
    with pytest.raises(DomainError):
        curvature(cusp, 2)
    with pytest.raises(ShapeError):
        torsion(PARABOLA, "1/2")
    with pytest.raises(ShapeError, match="straight"):
        torsion(xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 2, 3)]), "1/2")
    with pytest.raises(ShapeError):
        curvature(xs.Nurbs(1, [0, 0, 1, 1], [(0,) * 4, (1,) * 4]), 0)
    four = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(0,) * 4, (1,) * 4, (1, 2, 3, 4)])
    with pytest.raises(ShapeError):
        four.normal("1/2")


def test_sides_of_a_knot():
    corner = xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
    assert corner.tangent(1, "left") == (1, 0)
    assert corner.tangent(1) == (0, 1)
    assert corner.unit_tangent(1, "left") == (1, 0)
    arcs = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), (1, 1), (0, 1), (-2, 1), (-2, 3)], [1, 1, 2, 1, 1])
    assert curvature(arcs, 1, side="left") == 1
    assert curvature(arcs, 1) != 1


# ---- at roots


@pytest.mark.parametrize("digits", [0, 5, 40, 300])
def test_a_point_at_a_root(digits):
    x, y = xs.evaluate(PARABOLA, HALF)
    low, high = x.enclosure(digits)
    assert high - low <= mpq(1, 10**digits)
    assert low**2 <= mpq(1, 2) <= high**2
    assert y == mpq(1, 2)
    assert len(x.decimal(digits).partition(".")[2]) == digits
    assert abs(mpq(x.decimal(digits)) - low) <= 2 * mpq(1, 10**digits)


def test_a_point_at_a_rational_root_is_exact():
    (third,) = (r for r in xs.zeros((3 * xs.BSpline.identity(0, 1) - 1) * (xs.BSpline.identity(0, 1) + 1)))
    assert xs.evaluate(PARABOLA, third) == (mpq(1, 3), mpq(1, 9))
    assert xs.evaluate(PARABOLA, "1/3") == (mpq(1, 3), mpq(1, 9))
    assert curvature(PARABOLA, third) == curvature(PARABOLA, "1/3")


def test_curvature_and_torsion_at_a_root_hold_the_closed_forms():
    """κ² and τ of (t, t², t³) and of the parabola where t² = 1/2, as rational numbers or squares of κ."""
    u = mpq(1, 2)
    twisted = xs.Nurbs(3, [0] * 4 + [1] * 4, [(0, 0, 0), ("1/3", 0, 0), ("2/3", "1/3", 0), (1, 1, 1)])
    tau = torsion(twisted, HALF)
    assert tau == 3 / (1 + 9 * u + 9 * u**2)
    assert curvature(twisted, HALF) ** 2 == 4 * (1 + 9 * u + 9 * u**2) / (1 + 4 * u + 9 * u**2) ** 3
    assert curvature(PARABOLA, HALF) ** 2 == 4 / (1 + 4 * u) ** 3
    turned = PARABOLA.reverse().transform([[1, 0], [0, 1]])
    assert -curvature(turned, "1/2") == curvature(PARABOLA, "1/2")


def test_zero_curvature_at_an_irrational_root_is_zero_exactly():
    """y = (t² − 1/2)³ over x = t: κ = 0 where t² = 1/2 and nowhere near."""
    t = xs.BSpline.identity(0, 1)
    u = t * t - mpq(1, 2)
    curve = xs.Nurbs.from_splines([t, u**3])
    assert curvature(curve, HALF) == 0
    space = xs.Nurbs.from_splines([t, u**3, u**4])
    assert curvature(space, HALF) == 0
    flat = xs.Nurbs.from_splines([u, u**2, u**4])
    assert torsion(flat, HALF) == 0, "digits of τ near 0 are not digits"


def test_a_singular_point_at_an_irrational_root_is_named():
    t = xs.BSpline.identity(0, 1)
    u = t * t - mpq(1, 2)
    cusp = xs.Nurbs.from_splines([u**2, u**3])
    with pytest.raises(DomainError, match="γ′ = 0"):
        curvature(cusp, HALF)


def test_a_root_outside_the_domain():
    far = xs.zeros(xs.BSpline.identity(0, 9) ** 2 - 5).roots[0]
    for ask in (xs.evaluate, curvature):
        with pytest.raises(DomainError):
            ask(PARABOLA, far)
