"""Intervals with rational ends, and boxes of two intervals: subdivision, hulls, rounding, quotients, FLINT's balls,
decimals; and the two sides of a parameter.

The arithmetic of these intervals is exact. Bounds in doubles, for thousands of forms in one operation, are values with
error bounds (`exactspline.programs.doubles`, `exactspline.polynomials.doubles`); the effect of rounding is proved
there.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import takewhile
from math import inf
from typing import NamedTuple

from flint import arb

from exactspline.numbers.exact import mpq, mpz, rational, to_fmpq
from exactspline.one_line import one_line, short_text
from exactspline.words import Word


class Side(Word):
    """The side from which a limit or a one-sided value is taken."""

    LEFT = "left"
    RIGHT = "right"


class Interval(NamedTuple):
    """A closed interval; a number if both ends are equal.

    >>> whole = Interval(mpq(1), mpq(3))
    >>> whole.middle, whole.width, whole.part(Interval(mpq(0), mpq(1, 2)))
    (mpq(2,1), mpq(2,1), Interval(1, 2))
    """

    low: mpq
    high: mpq

    @classmethod
    def point(cls, t: mpq) -> Interval:
        """The interval that consists of one number."""
        return cls(t, t)

    @property
    def width(self) -> mpq:
        """The distance between the ends of the interval."""
        return mpq(self.high - self.low)

    @property
    def middle(self) -> mpq:
        """The midpoint, at most half the width from every number of the interval."""
        return mpq((self.low + self.high) / 2)

    @property
    def halves(self) -> tuple[Interval, Interval]:
        """The two halves of the interval."""
        middle = self.middle
        return Interval(self.low, middle), Interval(middle, self.high)

    def at(self, x: mpq) -> mpq:
        """The number at a local parameter, which is 0 at the lower end and 1 at the upper end."""
        return mpq(self.low + (self.high - self.low) * x)

    def local(self, t: mpq) -> mpq:
        """The local parameter of a number."""
        return mpq((t - self.low) / (self.high - self.low))

    def part(self, local: Interval) -> Interval:
        """The part between two local parameters."""
        return Interval(self.at(local.low), self.at(local.high))

    def grown(self, by: mpq) -> Interval:
        """The interval enlarged by this amount on both sides."""
        return Interval(mpq(self.low - by), mpq(self.high + by))

    def outward(self, unit: mpq) -> Interval:
        """The smallest interval around this one whose ends are multiples of a unit."""
        return Interval(self.low // unit * unit, -(-self.high // unit) * unit)

    def inside(self, outer: Interval) -> Interval:
        """The part of the interval that lies in another interval, which it meets."""
        return Interval(max(self.low, outer.low), min(self.high, outer.high))

    def contains(self, other: Interval) -> bool:
        """Whether the other one is contained in this one."""
        return self.low <= other.low and other.high <= self.high

    def meets(self, other: Interval) -> bool:
        """Whether the two intervals have a number in common."""
        return self.low <= other.high and other.low <= self.high

    def __str__(self) -> str:
        return f"[{short_text(self.low)}, {short_text(self.high)}]"

    @one_line
    def __repr__(self) -> str:
        return f"Interval({short_text(self.low)}, {short_text(self.high)})"


class Box(NamedTuple):
    """A closed rectangle in two parameters; a point if both sides are numbers.

    >>> box = Box(Interval(mpq(1), mpq(3)), Interval(mpq(0), mpq(1)))
    >>> box.at(mpq(1, 2), mpq(1, 3)), str(box), str(Box.point(mpq(0), mpq(1, 2)))
    ((mpq(2,1), mpq(1,3)), 'u in [1, 3], v in [0, 1]', 'u = 0, v = 1/2')
    """

    first: Interval
    second: Interval

    @classmethod
    def point(cls, x: mpq, y: mpq) -> Box:
        """The box that consists of one point."""
        return cls(Interval.point(x), Interval.point(y))

    @property
    def longest(self) -> mpq:
        """The length of the longer side."""
        return max(side.width for side in self)

    @property
    def middle(self) -> tuple[mpq, mpq]:
        """The midpoint of the box."""
        return self.first.middle, self.second.middle

    def halves(self, direction: int) -> tuple[Box, Box]:
        """The two halves of the box, by bisection of a side (direction 0: the first parameter)."""
        low, high = self[direction].halves
        return self.with_side(direction, low), self.with_side(direction, high)

    def with_side(self, direction: int, side: Interval) -> Box:
        """The box with the side in one direction replaced."""
        return Box(self.first, side) if direction else Box(side, self.second)

    def at(self, x: mpq, y: mpq) -> tuple[mpq, mpq]:
        """The point with the given local parameters, which are 0 at the lower ends and 1 at the upper ends."""
        return self.first.at(x), self.second.at(y)

    def part(self, local: Box) -> Box:
        """The part between local parameters."""
        return Box(self.first.part(local.first), self.second.part(local.second))

    def local(self, box: Box) -> Box:
        """A box in local parameters."""
        first, second = (Interval(*map(side_of.local, side)) for side_of, side in zip(self, box, strict=True))
        return Box(first, second)

    def contains(self, other: Box) -> bool:
        """Whether the other one is contained in this one."""
        return self.first.contains(other.first) and self.second.contains(other.second)

    def meets(self, other: Box) -> bool:
        """Whether the two boxes have a point in common."""
        return self.first.meets(other.first) and self.second.meets(other.second)

    def overlaps(self, other: Box) -> bool:
        """Whether the two boxes have inner points in common."""
        return all(a < d and c < b for (a, b), (c, d) in zip(self, other, strict=True))

    def is_inside(self, outer: Box) -> bool:
        """Whether the box is contained in the interior of another box."""
        return all(low < a and b < high for (a, b), (low, high) in zip(self, outer, strict=True))

    @property
    def shortly(self) -> str:
        """The box as text for messages, as a product, with long numbers abbreviated.

        >>> UNIT.shortly
        '[0, 1] × [0, 1]'
        """
        return f"{self.first} × {self.second}"

    def __str__(self) -> str:
        parts = zip("uv", self, strict=True)
        return ", ".join(f"{n} = {short_text(s.low)}" if s.low == s.high else f"{n} in {s}" for n, s in parts)

    @one_line
    def __repr__(self) -> str:
        return f"Box({self.first!r}, {self.second!r})"


#: The unit square.
UNIT = Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1)))


def hull(boxes: Iterable[Box]) -> Box:
    """The smallest box that contains all given boxes."""
    first, second = (
        Interval(min(a for a, _ in intervals), max(b for _, b in intervals)) for intervals in zip(*boxes, strict=True)
    )
    return Box(first, second)


def joined(intervals: Iterable[tuple[mpq, mpq]]) -> list[Interval]:
    """The union of intervals as disjoint intervals in ascending order.

    >>> [str(each) for each in joined([(mpq(2), mpq(3)), (mpq(0), mpq(1)), (mpq(1), mpq(2)), (mpq(5), mpq(6))])]
    ['[0, 3]', '[5, 6]']
    """
    union: list[Interval] = []
    for low, high in sorted(intervals):
        if union and low <= union[-1].high:
            union[-1] = Interval(union[-1].low, max(high, union[-1].high))
        else:
            union.append(Interval(low, high))
    return union


def ball_ends(ball: arb) -> Interval:
    """The ends of a ball, exactly.

    >>> ball_ends(arb("1.5"))
    Interval(3/2, 3/2)
    """
    middle, radius = (_dyadic(*part.man_exp()) for part in (ball.mid(), ball.rad()))
    return Interval(middle - radius, middle + radius)


def double_in(ball: arb) -> float | None:
    """The double to which all numbers of a ball are rounded, at a precision of FLINT above that of doubles; None if
    there is no such double, and for 0.

    >>> double_in(arb(0.5)), double_in(arb(0.5, 1e-9))
    (0.5, None)
    """
    low, high = float(ball.lower()), float(ball.upper())
    return low if low == high and 0 < abs(low) < inf else None


def _dyadic(mantissa: object, exponent: object) -> mpq:
    m, e = int(mantissa), int(exponent)  # type: ignore[call-overload]  # FLINT's integers
    return mpq(m << e) if e >= 0 else mpq(m, 1 << -e)


def ball_around(low: mpq, high: mpq) -> arb:
    """A ball, at FLINT's current precision, that contains an interval.

    >>> ball_around(mpq(1, 2), mpq(1, 2)) == 0.5, 0.7 in ball_around(mpq(1, 2), mpq(3, 4))
    (True, True)
    """
    first = arb(to_fmpq(low))
    return first if low == high else first.union(arb(to_fmpq(high)))


def certain(b: Interval, digits: int) -> str:
    """The decimals in which both ends agree, followed by dots; the two ends if no decimals agree.

    >>> certain(Interval(mpq(1, 3), mpq(3334, 10000)), 6), certain(Interval(mpq(-1, 100), mpq(1, 100)), 2)
    ('0.333…', '-0.01 … 0.01')
    """
    ends = [_truncated(end, digits) for end in b]
    agreed = len(list(takewhile(lambda pair: pair[0] == pair[1], zip(*ends, strict=False))))
    if "." not in ends[0][:agreed]:
        return " … ".join(ends)
    return ends[0] if b.low == b.high == rational(ends[0]) else f"{ends[0][:agreed]}…"


def _truncated(q: mpq, digits: int) -> str:
    """A number with this many digits after the decimal point, truncated towards zero."""
    return shifted(int(abs(q) * mpz(10) ** digits) * (-1 if q < 0 else 1), digits, negative=q < 0)


def shifted(scaled: int, digits: int, *, negative: bool = False) -> str:
    """An integer divided by a power of ten, as a decimal with this many digits after the decimal point.

    >>> shifted(-25, 3), shifted(7, 0)
    ('-0.025', '7')
    """
    # Python does not convert integers of more than 4300 digits
    whole, part = divmod(mpz(abs(scaled)), mpz(10) ** digits)
    decimals = f".{str(part).rjust(digits, '0')}" if digits else ""
    return f"{'-' if negative or scaled < 0 else ''}{whole}{decimals}"
