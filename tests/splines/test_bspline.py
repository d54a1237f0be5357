"""B-splines at the edge: jumps, zero forms below degree 0, bad input."""

import pytest
from gmpy2 import mpq

from exactspline import BSpline, KnotVector
from exactspline.errors import DomainError, ExactSplineError, KnotError, NumberError, ShapeError
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
BAD = {
    "decreasing knots": ((2, [0, 0, 0, 1, "1/2", 1], GOOD[2]), KnotError, "knots[4]"),
    "multiplicity above degree + 1": ((1, [0, 0, 1, 1, 1, 2, 2], [0] * 5), KnotError, "knots[2]"),
    "multiplicity above degree + 1 at the end": ((1, [0, 0, 0, 1, 1], [0] * 3), KnotError, "knots[0]"),
    "empty domain": ((1, [0, 1, 1, 2], [0, 0]), KnotError, "knots"),
    "too few knots": ((2, [0, 0, 1, 1], [0]), KnotError, "knots"),
    "no knots": ((0, [], []), KnotError, "knots"),
    "too few points": ((*GOOD[:2], [0, 1]), ShapeError, "control_points"),
    "too many points": ((*GOOD[:2], [0, 1, 2, 3]), ShapeError, "control_points"),
    "a float knot": ((2, [0, 0, 0.0, 1, 1, 1], GOOD[2]), NumberError, "knots[2]"),
    "a float point": ((*GOOD[:2], [0, 1, 2.5]), NumberError, "control_points[2]"),
    "a point that is none": ((*GOOD[:2], [0, None, 2]), NumberError, "control_points[1]"),
    "negative degree": ((-1, *GOOD[1:]), ShapeError, "degree"),
    "float degree": ((2.0, *GOOD[1:]), ShapeError, "degree"),
    "true degree": ((True, [0, 0, 1, 1], [0, 1]), ShapeError, "degree"),
    "huge degree": ((10**6, *GOOD[1:]), ShapeError, "degree"),
    "degree too long to print": ((10**5000, *GOOD[1:]), ShapeError, "degree"),
}


@pytest.mark.parametrize("what", BAD)
def test_bad_input_names_the_place(what):
    arguments, kind, where = BAD[what]
    with pytest.raises(kind) as caught:
        BSpline(*arguments)
    assert caught.value.where == where
    assert caught.value.remedy


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


def test_polynomials_and_forms_are_equal_piece_by_piece():
    f, g = BSpline(1, [0, 0, 1, 2, 2], [1, 2, 5]), BSpline(1, [0, 0, 1, 2, 2], [1, 2, 4])
    for own, same, other in ((f.polynomials, f.polynomials, g.polynomials), (f.forms, f.forms, g.forms)):
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
