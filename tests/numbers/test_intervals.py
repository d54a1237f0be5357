"""Intervals with rational ends, and the rounding of what is shown."""

from gmpy2 import mpq

from exactspline import Real
from exactspline.numbers.intervals import Interval


def test_decimals_and_doubles_are_rounded_and_intervals_have_a_middle():
    assert Real("-1/3").decimal(4) == "-0.3333"
    assert [Real(t).decimal(0) for t in ("5/2", "-5/2")] == ["3", "-2"]
    assert float(Real("1/3")) == 1 / 3
    assert Interval(mpq(0), mpq(1)).middle == mpq(1, 2)
