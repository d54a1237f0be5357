"""The parts of the filter in doubles: bounds that hold and are narrow, zeros that are certain where that is easy."""

from fractions import Fraction
from math import comb

import pytest

np = pytest.importorskip("numpy")

from exactspline.polynomials.doubles import (  # noqa: E402  # needs numpy
    SPLIT,
    Bounded,
    Isolated,
    isolated,
    most_changes,
    narrowed,
    ordinates,
    split_in_two,
    values_at,
)

SMALL = 2.0**-50


def rows(*values, error=SMALL):
    found = np.array(values, dtype=float)
    return Bounded(found, np.full_like(found, error))


def exactly(points, t):
    n = len(points) - 1
    return sum(Fraction(float(b)) * comb(n, i) * (1 - t) ** (n - i) * t**i for i, b in enumerate(points))


@pytest.mark.parametrize("degree", [1, 2, 3, 6, 11])
def test_values_are_within_bounds_that_are_narrow(degree):
    points = np.random.default_rng(degree).uniform(-1, 1, (40, degree + 1))
    places = np.random.default_rng(7).uniform(0, 1, 40)
    found, bound = values_at(Bounded(points, np.zeros_like(points)), np.arange(40), places)
    for row, t, value, error in zip(points, places, found, bound, strict=True):
        off = abs(Fraction(float(value)) - exactly(row, Fraction(float(t))))
        assert off <= Fraction(float(error)) <= Fraction(1, 10**13)


def test_values_take_the_rows_that_are_named_and_their_errors():
    given = Bounded(np.array([[1.0, 1.0], [5.0, 7.0]]), np.array([[0.25, 0.5], [0.0, 0.0]]))
    found, bound = values_at(given, np.array([1, 0, 1]), np.array([0.5, 0.0, 1.0]))
    assert found.tolist() == [6, 1, 7]
    assert 0.25 <= bound[1] <= 0.25 + 1e-12
    assert max(bound[0], bound[2]) <= 1e-13


def test_ordinates_are_the_coefficients_over_binomials():
    found = ordinates(np.array([[3.0, -6.0, 5.0]]), np.array([[0.5, 0.5, 0.0]]))
    assert found.values.tolist() == [[3, -3, 5]]
    low, high = np.array([[0.5, 0.25, 0.0]]), np.array([[0.5, 0.25, 0.0]]) + 1e-14
    assert (low <= found.errors).all()
    assert (found.errors <= high).all()
    assert found.errors[0, 2] > 0


@pytest.mark.parametrize(
    ("signs", "most"),
    [
        ((1, 1, 1), 0),
        ((-1, -1), 0),
        ((1, -1, 1), 2),
        ((1, 0, 1), 2),
        ((1, 0, -1), 1),
        ((0, 0), 1),
        ((0, 1), 1),
        ((0,), 0),
        ((-1, 0, 0, -1), 2),
        ((-1, 0, 0, 1), 3),
        ((1, 1, -1, -1, 1), 2),
        ((0, 0, 0, 0), 3),
    ],
)
def test_the_most_changes_that_certain_signs_allow(signs, most):
    assert most_changes(np.array([signs])).tolist() == [most]


def test_halves_are_those_of_the_form():
    points = np.random.default_rng(3).uniform(-1, 1, (5, 5))
    left, right = split_in_two(Bounded(points, np.full_like(points, SMALL)))
    split = Fraction(SPLIT)
    for row in range(5):
        for k in range(9):
            t = Fraction(k, 8)
            for half, place in ((left, t * split), (right, split + t * (1 - split))):
                off = abs(exactly(half.values[row], t) - exactly(points[row], place))
                assert off <= Fraction(float(half.errors[row].max())) <= Fraction(1, 10**13)
    assert left.values[:, 0].tolist() == points[:, 0].tolist()
    assert right.values[:, -1].tolist() == points[:, -1].tolist()


def product(*zeros):
    """The Bézier ordinates of ``Π (t − z)``, and their sign left of the first."""
    n = len(zeros)
    power = [Fraction(1)]
    for z in zeros:
        power = [b - Fraction(z) * a for a, b in zip([*power, 0], [0, *power], strict=True)]
    return [float(sum(power[k] * Fraction(comb(i, k), comb(n, k)) for k in range(i + 1))) for i in range(n + 1)]


@pytest.mark.parametrize("zeros", [(0.3,), (0.1, 0.7), (0.2, 0.5, 0.9), (0.05, 0.35, 0.6, 0.95), (0.3, 2), (-1, 0.8)])
def test_zeros_are_isolated_in_order_with_their_signs(zeros):
    inside = [z for z in zeros if 0 < z < 1]
    given = rows([1.0] * (len(zeros) + 1), product(*zeros))
    found, open_ = isolated(given)
    assert open_.tolist() == [False, False]
    assert found.row.tolist() == [1] * len(inside)
    first = 1 if exactly(given.values[1], Fraction(0)) > 0 else -1
    assert found.before.tolist() == [first * (-1) ** k for k in range(len(inside))]
    for low, z, high in zip(found.low, inside, found.high, strict=True):
        assert low < z < high
    close = narrowed(given, found)
    for low, z, high in zip(close.low, inside, close.high, strict=True):
        assert low < z < high
        assert high - low <= 2.0**-29
    assert close.before.tolist() == found.before.tolist()
    assert close.row.tolist() == found.row.tolist()


def test_what_is_not_certain_is_open():
    found, open_ = isolated(rows([1.0, -1.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 2.0], [1.0, -3.0, 1.0]))
    assert open_.tolist() == [True, False, True, False]
    assert found.row.tolist() == [3, 3]


def test_zeros_for_which_something_holds():
    found = Isolated(np.array([0, 1, 2]), np.array([0.0, 0.1, 0.2]), np.array([0.5, 0.6, 0.7]), np.array([1, -1, 1]))
    some = found.where(np.array([True, False, True]))
    assert (some.row.tolist(), some.low.tolist()) == ([0, 2], [0.0, 0.2])
    assert (some.high.tolist(), some.before.tolist()) == ([0.5, 0.7], [1, 1])


def test_no_zeros_are_narrowed_to_none():
    given = rows([1.0, 2.0])
    found, _ = isolated(given)
    assert len(narrowed(given, found).row) == 0


def test_a_bound_is_not_below_what_the_errors_allow():
    """All coefficients off by one: so is every value."""
    given = Bounded(np.zeros((1, 8)), np.ones((1, 8)))
    for t in (0.0, 0.25, 1.0):
        _, bound = values_at(given, np.array([0]), np.array([t]))
        assert bound[0] >= 1
