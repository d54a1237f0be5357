"""Intervals with rational ends, and the rounding of what is shown."""

from gmpy2 import mpq

from exactspline import Real
from exactspline.numbers.intervals import Interval, rounded_outwards


def test_enclosures_are_rounded_outwards_and_say_their_middle():
    low, high = rounded_outwards(Interval(mpq(1, 3), mpq(2, 3)), 2)
    assert (low, high) == (mpq(33, 100), mpq(67, 100))
    assert Real("-1/3").decimal(4) == "-0.3333"
    assert [Real(t).decimal(0) for t in ("5/2", "-5/2")] == ["3", "-2"]
    assert float(Real("1/3")) == 1 / 3
    assert Interval(mpq(0), mpq(1)).middle == mpq(1, 2)
