"""Common zeros in two parameters: complete, exact, each once."""

from itertools import product
from random import Random

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import NurbsSurface, analyse
from exactspline.bivariate import common_zeros as solver
from exactspline.bivariate import singular_points
from exactspline.bivariate.common_zeros import Column, Found, common_zeros, multiplicity
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.errors import ReachError
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials import certified_boxes
from exactspline.polynomials.certified_boxes import Isolation
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.two_parameters import S, T, as_form, value_at
from tests.campaigns.common_zeros import FAMILIES, any_polynomial, difference, differs
from tests.support.squares import graph, parameters


def test_all_zeros_are_those_of_elimination_by_another_route():
    cases = product(FAMILIES, ("small integers",), range(12))
    assert [case for case in cases if differs(*case)] == []


def test_the_other_route_notices_a_lost_zero(monkeypatch):
    from tests.campaigns import common_zeros as campaign

    monkeypatch.setattr(campaign, "common_zeros", lambda *given: common_zeros(*given)[1:])
    assert difference(2 * S - 1, 2 * T - 1) == "0 zeros, 1 by the other route"


@pytest.mark.parametrize(
    ("f", "g", "count", "multiplicities"),
    [
        (S, T, 1, [1]),  # a corner
        (2 * S * S - 1, T - 1, 1, [1]),  # irrational on the border
        (2 * S * S - 1, (2 * T * T - 1) ** 2, 1, [2]),
        ((2 * S - 1) * (3 * T - 1), (2 * S - 1) ** 2 - (3 * T - 1) ** 2, 1, [4]),
        (S**2 - T**3, S**3 - T**2, 2, [4, 1]),
        (2 * S * S - 1, (3 * T * T - 1) * (3 * T - 1), 2, [1, 1]),  # two over one root
        (S * S + T * T + 1, S - T, 0, []),
        (2 * S * S - 1, (S + 2) * T - 1, 1, [1]),
        (S - 2, S * T - 1, 0, []),  # only outside
    ],
)
def test_zeros_and_multiplicities(f, g, count, multiplicities):
    zeros = common_zeros([f, g], UNIT)
    assert len(zeros) == count
    assert [multiplicity(zero, f, g) for zero in zeros] == multiplicities


def test_zeros_that_differ_in_the_hundredth_digit_are_two():
    tiny = 10**100
    zeros = common_zeros([(2 * S * S - 1) * (tiny * (2 * S * S - 1) - 1), S - T], UNIT)
    assert len(zeros) == 2
    assert zeros[0].s < zeros[1].s
    assert all(zero.s == zero.t for zero in zeros)


def test_zeros_at_nearly_one_parameter_have_their_own_numbers():
    """Both numbers s are roots of one eliminant, in the box of either zero: found by a mutant that ended in a loop."""
    f, g = 10**9 * (2 * S * S - 1) - (3 * T - 1), (3 * T - 1) * (3 * T - 2)
    one, other = common_zeros([f, g], UNIT)
    assert one.s.minimal_polynomial() == [-1, 0, 2]
    assert other.s.minimal_polynomial() == [-(10**9 + 1), 0, 2 * 10**9]
    assert not one.is_at(other)
    assert one.is_at(one)


def test_more_than_two_polynomials_share_only_their_zeros():
    f, g, h = (2 * S * S - 1) * T, (2 * S * S - 1) * (T - 1), (3 * T - 1) * (S + T)
    (zero,) = common_zeros([f, g, h], UNIT)
    assert zero.t == mpq(1, 3)
    assert zero.is_zero_of(as_form((2 * S * S - 1) * (S - 7 * T) ** 3))
    assert not zero.is_zero_of(as_form(S - 2 * T))


def test_a_polynomial_that_nearly_vanishes_at_a_zero_of_two_others():
    """Four hundred bits do not tell: the numbers are compared with those at which all three vanish."""
    f, g, near = 2 * S * S - 1, S - T, 2**600 * (3 * S + T) * (2 * S * S - 1)
    assert [zero.s.minimal_polynomial() for zero in common_zeros([f, g, near], UNIT)] == [[-1, 0, 2]]
    assert common_zeros([f, g, near + S + T], UNIT) == []


def test_parts_of_a_rectangle():
    side = Interval(mpq(1), mpq(3))
    assert [zero.place for zero in common_zeros([S - T, (S - 3) * (S - 1) * S], Box(side, side))] == [(1, 1), (3, 3)]


def test_the_cost_is_bounded():
    random = Random(5)
    f, g = (any_polynomial(random, 9, 9, 10**9) for _ in range(2))
    with drawing_on(Budget(10**6)), pytest.raises(ReachError):
        common_zeros([f, g], UNIT)


def test_flat_points_at_irrational_crossings_are_umbilics():
    """Three of these five were boxes in which something was undecided."""
    found = analyse(graph(lambda u, v: (u * u * 2 - 1) ** 4 * mpq(1, 9) + (v * v * 2 - 1) ** 4 * mpq(1, 7)))
    assert found.complete
    assert sorted(one.kind for one in found.umbilics) == sorted(["lemon", "star", *["multiple"] * 3])
    crossing = max(found.umbilics, key=lambda one: one.place.box(5).middle)
    assert [x.minimal_polynomial() for x in crossing.place.spot] == [[-1, 0, 2]] * 2


def test_an_irrational_multiple_singular_point_is_one_point():
    """A box was left undecided."""
    u, v = parameters()
    p, q = u * u * 2 - 1, v * v * 2 - 1
    found = analyse(NurbsSurface.from_splines([p * p, q * q, p * q + q * q * q]))
    assert found.complete
    (place,) = found.singular_points
    assert [x.minimal_polynomial() for x in place.spot] == [[-1, 0, 2]] * 2


def test_polynomials_of_one_parameter_beside_one_of_both():
    """Passed before: 2s² − 1, its square and a polynomial of both had no zero in common, since a resultant was 1."""
    (zero,) = common_zeros([2 * S * S - 1, (2 * S * S - 1) ** 2, 3 * T - 1 + 2 * S * S - 1], UNIT)
    assert zero.s.minimal_polynomial() == [-1, 0, 2]
    assert zero.t == mpq(1, 3)


def test_boxes_find_what_arithmetic_in_the_field_finds(monkeypatch):
    """Simple zeros over roots of large degree, by Krawczyk's test and by common divisors over their fields."""
    random = Random(7)
    found, sides = 0, Box(*[Interval(mpq(-2), mpq(2))] * 2)
    for _ in range(6):
        f, g = (
            sum((random.randint(-999, 999) * S**i * T**j for i in range(4) for j in range(4)), S * 0) for _ in range(2)
        )
        with monkeypatch.context() as patch:
            patch.setattr(certified_boxes, "PER_SQUARE", 100)
            patch.setattr(Column, "of", lambda *_: pytest.fail("boxes decide here"))
            by_boxes = common_zeros([f, g], sides)
        with monkeypatch.context() as patch:
            patch.setattr(solver, "isolate", lambda *_: Isolation([], [UNIT]))
            by_fields = common_zeros([f, g], sides)
        assert [one.place for one in by_boxes] == [one.place for one in by_fields]
        assert all(len(one.s.minimal_polynomial()) > 10 for one in by_boxes)
        found += len(by_boxes)
    assert found > 3


def test_others_leave_out_zeros():
    zeros = common_zeros([2 * S * S - 1, 3 * T * T - 1], Box(Interval(mpq(-1), mpq(1)), UNIT.second))
    left = common_zeros(
        [2 * S * S - 1, 3 * T * T - 1], Box(Interval(mpq(-1), mpq(1)), UNIT.second), also=[S - 1 - S * T]
    )
    assert (len(zeros), len(left)) == (2, 0)
    (kept,) = common_zeros([2 * S * S - 1, 3 * T * T - 1], UNIT, also=[6 * S * S * T * T - 1])
    assert kept.place == zeros[-1].place


# ---- curves of zeros: their singular points, also degenerate ones and on the border

P, Q, A, B = 2 * S * S - 1, 2 * T * T - 1, 2 * S - 1, 3 * T - 1


@pytest.mark.parametrize(
    ("f", "shape", "undecided_before"),
    [
        (A**3 - B**2, "arc from border to border", True),  # a cusp
        (P**3 - Q**2, "arc from border to border", True),  # at an irrational point
        (B**2 - A**4, "branches that cross", True),  # a tacnode
        ((B - A**2) ** 2 - A**5, "arc from border to border", True),  # a ramphoid cusp
        (A**3 - A * B**2 + B**4, "branches that cross", True),  # three branches
        (P**2 - 3 * Q**2 + P**3, "branches that cross", True),  # a node at an irrational point
        (P**2 + Q**2, "single point", True),
        (A**2 - T**2, "arc from border to border", True),  # a node on the border: two branches inside
        (P**2 - T**2, "arc from border to border", True),  # at an irrational point of it
        (P**2 + T**2, "single point", True),
        (A**2 - T**3, "arc from border to border", True),
        (S**3 - T**2, "arc from border to border", True),  # a cusp at a corner
        ((S - 2 * T) * (2 * S - T), "arc from border to border", True),
        ((S + 2 * T) * (2 * S + T), "single point", True),
    ],
)
def test_degenerate_singular_points_are_resolved(f, shape, undecided_before, monkeypatch):
    curve = ZeroCurve(as_form(f))
    assert curve.complete
    assert shape in {part.shape for part in curve.parts}
    monkeypatch.setattr(singular_points, "zeros_of", lambda *_, **__: Found([], []))
    assert ZeroCurve(as_form(f)).complete is not undecided_before


def test_branches_near_a_singular_point_are_those_of_a_small_circle():
    """Counted by another route: signs on a fine polygon around the point."""
    for f, (x, y) in (
        (A**3 - B**2, (mpq(1, 2), mpq(1, 3))),
        (B**2 - A**4, (mpq(1, 2), mpq(1, 3))),
        (A**3 - A * B**2 + B**4, (mpq(1, 2), mpq(1, 3))),
        ((A**2 - B**3) * (B + A), (mpq(1, 2), mpq(1, 3))),
    ):
        cell = next(one for one in singular_points.singular_cells(as_form(f)) if one.zero.exact == (x, y))
        curve = ZeroCurve(as_form(f))
        ends = [v for a in cell.ends for v, _ in curve._zeros_on(0, a, cell.box.second)]
        r = mpq(1, 1 << 14)
        n = 400
        around = [(r * (2 * mpq(k, n) - 1), -r) for k in range(n)]
        around += [(r, r * (2 * mpq(k, n) - 1)) for k in range(n)]
        square = [*around, *((-a, -b) for a, b in around)]
        signs = [value_at(f, x + a, y + b) > 0 for a, b in square]
        assert len(ends) == sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True))


def test_factors_with_roots_close_together_are_told_apart():
    """Would not end otherwise: both vanish nearly at the point, with as many bits as a first try has."""
    near = mpq(1, 3) + mpq(1, 10**40)
    first, second = (fmpz_poly([-int(x.numerator), int(x.denominator)]) for x in (mpq(2, 3), 2 * near))
    for x, factor in ((mpq(1, 3), first), (near, second)):
        zero = solver.CommonZero.at(UNIT, (x, x))
        assert solver._factor_at(first * second**2, zero, 1) == (factor, 1 if factor == first else 2)
