"""B-splines at the edge: jumps, zero forms below degree 0, bad input."""

from itertools import pairwise

import pytest
from flint import fmpq_poly
from gmpy2 import mpq

from exactspline import BSpline, ExactSplineError, KnotVector
from exactspline.errors import DomainError, KnotError, NumberError
from exactspline.numbers.exact import from_flint, to_fmpq
from tests.support.strategies import JUMP, KINK, TINY


def test_a_jump_has_two_values():
    f = BSpline(1, [0, 0, 1, 1, 2, 2], [0, 3, 5, 7])
    assert (f(1), f(1, "right"), f(1, "left")) == (5, 5, 3)
    assert (f(0, "left"), f(2, "right"), f(2)) == (0, 7, 7)
    assert f.continuity_at(1) == -1
    assert f.d().control_points == (3, 2)
    assert f.d().knots == KnotVector([0, 1, 2])
    assert (f * f)(1, "left") == 9
    assert (f * f).knots.multiplicity(1) == 3
    with pytest.raises(DomainError, match="the side 'above' is unknown; there are left, right"):
        f(1, "above")


@pytest.mark.parametrize(
    "f", [BSpline.bezier([4]), JUMP, BSpline.bezier([1, 2, 3]), KINK], ids=["constant", "jump", "parabola", "kink"]
)
def test_zero_forms_of_negative_degree(f):
    a, b = f.domain
    for k in range(1, 5):
        zero = f.d(f.degree + k)
        assert zero.degree == -k
        assert zero.is_zero
        assert zero.true_degree == -1
        assert (zero.control_points, len(zero.knots)) == ((), 0)
        assert repr(zero)
        assert zero(a) == zero(b) == zero((a + b) / 2) == 0
        assert (zero * f).degree == f.degree - k
        assert (zero * f).is_zero
        assert (zero + f).degree == f.degree
        assert zero + f == f
        assert zero + zero == zero
        assert zero == f - f
        assert hash(zero) == hash(f - f)
        assert zero.reverse().is_zero
        assert zero.restrict(a, (a + b) / 2).is_zero
        assert (zero * zero).degree == -2 * k


def test_no_derivative_of_negative_order():
    with pytest.raises(ExactSplineError):
        BSpline.bezier([1, 2]).d(-1)


# ---- what is refused

GOOD = (2, [0, 0, 0, 1, 1, 1], [0, 1, 2])


def test_parameters_outside_and_domains_that_differ():
    f = BSpline(*GOOD)
    for t in (-TINY, 1 + TINY):
        with pytest.raises(DomainError, match="outside the domain"):
            f(t)
    with pytest.raises(NumberError):
        f(0.5)
    with pytest.raises(DomainError, match="different domains"):
        f + BSpline.bezier([1, 2], 0, 2)
    with pytest.raises(DomainError, match="different domains"):
        f * BSpline.bezier([1, 2], 0, 2)
    for t in (0, 1):
        with pytest.raises(DomainError, match="not inside"):
            f.insert_knot(t)
    with pytest.raises(KnotError):
        f.insert_knot("1/2", 0)
    with pytest.raises(DomainError, match="is not part of"):
        f.restrict(0, 2)
    with pytest.raises(DomainError, match="is not part of"):
        f.restrict("1/2", "1/2")


@pytest.mark.parametrize("stranger", [0.5, "1/2", None, [1], 1j], ids=repr)
def test_arithmetic_with_strangers_is_refused(stranger):
    f = BSpline(*GOOD)
    for operation in (
        lambda x: f + x,
        lambda x: x + f,
        lambda x: f - x,
        lambda x: x - f,
        lambda x: f * x,
        lambda x: f / x,
        lambda x: x / f,
    ):
        with pytest.raises(TypeError):
            operation(stranger)


def test_polynomials_are_those_of_the_parameter():
    """Before: integers of the forms in the Bernstein basis, without their denominators."""
    f = BSpline(3, [0, 0, 0, 0, "1/3", 2, 2, 2, 2], ["1/7", 2, -3, 0, "5/2"])
    assert (f * f).polynomials == tuple(p**2 for p in f.polynomials)
    for (a, b), p in zip(pairwise(f.breakpoints), f.polynomials, strict=True):
        for t in (a, (a + b) / 2):
            assert from_flint(p(to_fmpq(t))) == f(t)
    assert BSpline(1, [0, 0, 1, 2, 2], [0, 0, 1]).polynomials == (0, fmpq_poly([-1, 1]))


def test_polynomials_and_forms_are_equal_piece_by_piece():
    f, g = BSpline(1, [0, 0, 1, 2, 2], [1, 2, 5]), BSpline(1, [0, 0, 1, 2, 2], [1, 2, 4])
    for own, same, other in ((f.numerators, f.numerators, g.numerators), (f.forms, f.forms, g.forms)):
        assert own == same
        assert own == tuple(same)
        assert own != other
        assert own != tuple(own)[:1]
        assert own != (*own, own[0])
        assert own != 2


def test_parameters_are_located_in_the_segment_on_the_side_asked_for():
    mesh = BSpline(1, [0, 0, 1, 2, 4, 4], [0, 1, 2, 3]).mesh
    inside = [(mpq(1, 2), 0), (mpq(3, 2), 1), (mpq(3), 2)]
    for t, i in inside:
        assert mesh.locate(t) == mesh.locate(t, left=True) == i
    assert [mesh.locate(mpq(t)) for t in (0, 1, 2, 4)] == [0, 1, 2, 2]
    assert [mesh.locate(mpq(t), left=True) for t in (0, 1, 2, 4)] == [0, 0, 1, 2]
