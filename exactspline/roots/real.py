"""Exactly known real numbers without a closed form: enclosed as narrowly as needed, compared with any rational
number, rounded correctly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from exactspline.exact import Number, Rounding, double, double_between, mpq
from exactspline.roots.enclosure import (
    Bounds,
    Enclosure,
    exact_place,
    narrowed,
    quotient,
    root_of,
    sign_at,
    value_at,
    values_between,
)
from exactspline.roots.root import Root
from exactspline.splines.surd import Surd

if TYPE_CHECKING:
    from exactspline.splines.bspline import BSpline


@dataclass(frozen=True)
class Real:
    """A real number: `exact` where it is rational or ``a√b`` and known to be; ``enclosed(digits)`` is an interval with
    it, at most ``10^−digits`` wide; ``sign_above(t)`` is the sign of the number minus a rational t. Both are functions
    with names, so that reals can be pickled.

    >>> from exactspline.splines.surd import square_root
    >>> root = Real.of(square_root(mpq(2)))
    >>> root.double("down"), root.double("up"), root.sign_above(mpq(3, 2))
    (1.414213562373095, 1.4142135623730951, -1)
    """

    exact: mpq | Surd | None
    enclosed: Callable[[int], tuple[mpq, mpq]]
    sign_above: Callable[[mpq], int]

    @classmethod
    def of(cls, value: Number | Surd | Root) -> Real:
        """A number that is known in one of these ways."""
        if isinstance(value, Surd):
            return cls(value, value.enclosed, partial(_compared, value))
        place = exact_place(value)
        if isinstance(place, Root):
            return cls(None, place.refine, partial(_compared, place))
        return cls(place, partial(_twice, place), partial(_compared, place))

    @classmethod
    def quotient_at(cls, top: BSpline, bottom: BSpline, root: Root) -> Real:
        """``top/bottom`` at an irrational root at which the denominator is not zero.

        >>> from exactspline import BSpline, zeros
        >>> t = BSpline.identity(0, 2)
        >>> Real.quotient_at(t * t * t, t.constant(1), zeros(t * t - 2).roots[0]).double()
        2.8284271247461903
        """
        if sign_at(top, root) == 0:
            return cls.of(0)
        given = (top, bottom, root)
        return cls(None, partial(_quotient, *given), partial(_quotient_compared, *given, sign_at(bottom, root)))

    @classmethod
    def root_of_quotient_at(cls, sign: int, top: BSpline, bottom: BSpline, root: Root) -> Real:
        """``± √(top/bottom)`` at an irrational root, where top ≥ 0 and bottom > 0.

        >>> from exactspline import BSpline, zeros
        >>> t = BSpline.identity(0, 2)
        >>> Real.root_of_quotient_at(-1, t, t.constant(1), zeros(t * t - 2).roots[0]).double()
        -1.189207115002721
        """
        if sign == 0 or sign_at(top, root) == 0:
            return cls.of(0)
        given = (sign, top, bottom, root)
        return cls(None, partial(_root_of_quotient, *given), partial(_root_compared, *given))

    def told(self, digits: int) -> mpq | Surd | Enclosure:
        """The number itself where it is known, otherwise enclosed to so many digits behind the point."""
        return Enclosure(*self.enclosed(digits), digits) if self.exact is None else self.exact

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """The correctly rounded double; raises what `exactspline.exact.double` raises."""
        if self.exact is None or isinstance(self.exact, Surd):
            return double_between(self.enclosed, self.sign_above, rounding)
        return double(self.exact, rounding)

    def doubles(self) -> dict[str, float]:
        """All three correctly rounded doubles by the names of the rounding modes."""
        return {str(way): self.double(way) for way in Rounding}


def _twice(value: mpq, digits: int) -> tuple[mpq, mpq]:
    return value, value


def _compared(value: mpq | Surd | Root, t: mpq) -> int:
    return int(value > t) - int(value < t)


def _quotient(top: BSpline, bottom: BSpline, root: Root, digits: int) -> tuple[mpq, mpq]:
    (found,) = value_at((top,), bottom, root, digits)
    return found.low, found.high


def _quotient_compared(top: BSpline, bottom: BSpline, root: Root, positive: int, t: mpq) -> int:
    return positive * sign_at(top - bottom.scaled(t), root)


def _root_of_quotient(sign: int, top: BSpline, bottom: BSpline, root: Root, digits: int) -> tuple[mpq, mpq]:
    def bounds(low: mpq, high: mpq) -> list[Bounds] | None:
        above, below = values_between(top, low, high), values_between(bottom, low, high)
        if above is None or below is None or below.low <= 0:
            return None
        size = root_of(quotient(above, below), digits + 5)
        return [size if sign > 0 else Bounds(-size.high, -size.low)]

    (found,) = narrowed(bounds, root, digits)
    return found.low, found.high


def _root_compared(sign: int, top: BSpline, bottom: BSpline, root: Root, t: mpq) -> int:
    return sign if t * sign <= 0 else sign * sign_at(top - bottom.scaled(t * t), root)


def real(value: Number | Surd | Root | Real) -> Real:
    """Any kind of number as a `Real`."""
    return value if isinstance(value, Real) else Real.of(value)
