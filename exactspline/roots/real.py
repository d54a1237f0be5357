"""Real numbers known exactly without being written down: enclosed as narrowly as wanted, compared with any rational
number, rounded correctly.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
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
    it, at most ``10^−digits`` wide; ``sign_above(t)`` is the sign of the number minus a rational t.

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
            return cls(value, value.enclosed, lambda t: 1 if value > t else -1)
        place = exact_place(value)
        if isinstance(place, Root):
            return cls(None, place.refine, lambda t: int(place > t) - int(place < t))
        return cls(place, lambda digits: (place, place), lambda t: int(place > t) - int(place < t))

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
        positive = sign_at(bottom, root)

        def enclosed(digits: int) -> tuple[mpq, mpq]:
            (found,) = value_at((top,), bottom, root, digits)
            return found.low, found.high

        return cls(None, enclosed, lambda t: positive * sign_at(top - bottom.scaled(t), root))

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

        def bounds(low: mpq, high: mpq, digits: int) -> list[Bounds] | None:
            above, below = values_between(top, low, high), values_between(bottom, low, high)
            if above is None or below is None or below.low <= 0:
                return None
            size = root_of(quotient(above, below), digits + 5)
            return [size if sign > 0 else Bounds(-size.high, -size.low)]

        def enclosed(digits: int) -> tuple[mpq, mpq]:
            (found,) = narrowed(lambda low, high: bounds(low, high, digits), root, digits)
            return found.low, found.high

        def sign_above(t: mpq) -> int:
            return sign if t * sign <= 0 else sign * sign_at(top - bottom.scaled(t * t), root)

        return cls(None, enclosed, sign_above)

    def told(self, digits: int) -> mpq | Surd | Enclosure:
        """The number itself where it is known, otherwise enclosed to so many digits behind the point."""
        return Enclosure(*self.enclosed(digits), digits) if self.exact is None else self.exact

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """The correctly rounded double; raises what `exactspline.exact.double` raises."""
        if self.exact is None or isinstance(self.exact, Surd):
            return double_between(self.enclosed, self.sign_above, rounding)
        return double(self.exact, rounding)

    def doubles(self) -> dict[str, float]:
        """All three correctly rounded doubles by the names of the ways of rounding."""
        return {str(way): self.double(way) for way in Rounding}


def real(value: Number | Surd | Root | Real) -> Real:
    """A number, in whatever way it is known, as a `Real`."""
    return value if isinstance(value, Real) else Real.of(value)
