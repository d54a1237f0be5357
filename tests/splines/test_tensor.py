"""Splines in two parameters at the edge: jumps, zero forms below degree 0, bad input."""

import pytest
from gmpy2 import mpq

from exactspline import BSpline, TensorSpline
from exactspline.errors import DomainError, FormulaError, NumberError, ReductionError, ShapeError
from exactspline.splines.tensor import lifted
from tests.support.strategies import HUGE, TINY


def test_a_jump_belongs_to_the_right():
    f = TensorSpline((0, 1), [0, 1, 2], [0, 0, 1, 1, 2, 2], [[1, 2, 3, 4], [5, 6, 7, 8]])
    assert f.continuity == ((-1,), (-1,))
    assert [f(s, t) for s, t in ((0, 0), (0, 1), (1, 0), (1, 1), (2, 2), (mpq(1, 2), mpq(1, 2)))] == [
        1,
        3,
        5,
        7,
        8,
        mpq(3, 2),
    ]
    assert (f * f).knots[0].multiplicity(1) == 1
    assert (f * f).knots[1].multiplicity(1) == 3
    assert f.partial(0, 1).control_points == ((1, 1), (1, 1))
    assert f.partial(1, 0).degree == (0, 0)


@pytest.mark.parametrize(
    "f",
    [
        TensorSpline((0, 0), [0, 1], [0, 1], [[4]]),
        TensorSpline((0, 2), [0, 1, 2], [0, 0, 0, 1, 1, 1], [[1, 2, 4], [5, 6, 6]]),
        TensorSpline((1, 0), [0, 0, 1, 1], [0, 1, 2], [[1, 2], [5, 5]]),
        TensorSpline((0, 0), [0, 1], [0, 1], [[4]]).constant(3),
        lifted(BSpline.bezier([1, 2, 4]), (BSpline.bezier([0]).mesh,) * 2, 1),
    ],
    ids=["constant net", "degree 0 in s", "degree 0 in t", "constant", "of t only"],
)
def test_derivatives_beyond_the_degree_are_the_constant_zero(f):
    for i in range(f.degree.s + 4):
        for j in range(f.degree.t + 4):
            zero = f.partial(i, j)
            if i <= f.degree.s and j <= f.degree.t:
                assert zero.degree == (f.degree.s - i, f.degree.t - j)
                continue
            assert zero.degree == (0, 0)
            assert zero.is_zero
            assert zero(0, 0) == zero(1, 1) == zero("1/2", "1/3") == 0
            assert (zero * f).degree == f.degree
            assert (zero * f).is_zero
            assert zero + f == f
            assert zero == f - f
            assert hash(zero) == hash(f - f)
            assert zero.transposed().is_zero
            assert zero.at_t(1).is_zero
            assert zero.at_s(1).is_zero
            assert repr(zero)


def test_a_zero_form_times_a_spline_leaves_the_spline_as_it_is():
    f = lifted(BSpline.bezier([1, 2, 3, 4, 5, 7]), (BSpline.bezier([0]).mesh,) * 2, 0)
    zero = TensorSpline((0, 1), [0, 1], [0, 0, 1, 1], [[1, 2]]).partial(2, 0)
    assert (zero * f).is_zero
    assert f(1, "1/2") == 7
    assert f.at_t("1/2") == f.profile[1]


def test_huge_and_tiny_coordinates():
    f = TensorSpline((1, 1), [0, 0, TINY, TINY], [HUGE, HUGE, HUGE + 1, HUGE + 1], [[HUGE, TINY], [-TINY, HUGE + TINY]])
    assert f(TINY / 2, HUGE + mpq(1, 2)) == (2 * HUGE + TINY) / 4
    assert f.partial(1, 1).control_points == (((2 * HUGE + TINY) / TINY,),)


# ---- what is refused

GOOD = ((1, 2), [0, 0, 1, 1], [0, 0, 0, 1, 1, 1], [[0, 1, 2], [3, 4, 5]])


def test_parameters_outside_and_domains_that_differ():
    f = TensorSpline(*GOOD)
    for place in ((-TINY, 0), (0, 1 + TINY), (2, 2)):
        with pytest.raises(DomainError, match="outside the domain"):
            f(*place)
    with pytest.raises(NumberError):
        f(0, 0.5)
    for at in (f.at_t, f.at_s):
        with pytest.raises(DomainError, match="outside the domain"):
            at(1 + TINY)
    other = TensorSpline((0, 0), [0, 1], [0, 2], [[1]])
    for operation in (lambda x, y: x + y, lambda x, y: x - y, lambda x, y: x * y):
        with pytest.raises(DomainError, match="different domains"):
            operation(f, other)
    assert f != other
    for direction in range(2):
        with pytest.raises(DomainError, match="not inside"):
            f.insert_knot(direction, 1)
    with pytest.raises(DomainError, match="is not part of"):
        f.restrict((0, 1), (0, 2))


def test_what_cannot_be_done():
    f = TensorSpline(*GOOD)
    with pytest.raises(FormulaError, match="name the parameter"):
        f.d()
    with pytest.raises(FormulaError, match="order -1"):
        f.partial(0, -1)
    with pytest.raises(ShapeError, match="direction"):
        f.insert_knot(2, "1/2")
    with pytest.raises(ShapeError, match="elevation by -1"):
        f.elevate_degree(-1, 0)
    with pytest.raises(ReductionError, match="true degree 1"):
        f.reduce_degree(1, 0)
    with pytest.raises(FormulaError, match="truth value"):
        bool(f)


@pytest.mark.parametrize("stranger", [0.5, "1/2", None, [1], 1j, BSpline.bezier([1, 2])], ids=repr)
def test_arithmetic_with_strangers_is_refused(stranger):
    f = TensorSpline(*GOOD)
    for operation in (lambda x: f + x, lambda x: x + f, lambda x: f - x, lambda x: x - f, lambda x: f * x):
        with pytest.raises(TypeError):
            operation(stranger)
