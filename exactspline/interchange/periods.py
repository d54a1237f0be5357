"""Closed curves of which a file lists one period, or leaves out the control points that are repeated; and the part of
a spline that a file uses.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import NamedTuple, TypeVar

from exactspline.numbers.exact import mpq

P = TypeVar("P")


class Whole(NamedTuple):
    """A full knot vector, by how many control points those of a file are to be continued, and what is to be noted."""

    knots: Sequence[mpq]
    more: int = 0
    notes: tuple[str, ...] = ()

    def continued(self, entries: Sequence[P]) -> list[P]:
        """The control points, or the weights, of the whole curve: the first are repeated."""
        return [*entries, *islice(cycle(entries), self.more)]


def whole(degree: int, knots: Sequence[mpq], count: int, periodic: bool = False) -> Whole:
    """The full knot vector of a curve of which a file lists some knots and `count` control points.

    A closed curve may be listed by one period, the first and the last knot e times each: count + e knots. Or its knots
    are all there, and of its control points those that are repeated are left out. What is neither stays as it is.

    >>> whole(3, [mpq(t) for t in range(5)], 4)  # doctest: +ELLIPSIS
    Whole(knots=[mpq(-3,1), ..., mpq(7,1)], more=3, notes=('periodic, listed by one period: ...',))
    >>> knots, more, _ = whole(2, [mpq(t) for t in range(-2, 6)], 3)
    >>> [int(t) for t in knots], more
    ([-2, -1, 0, 1, 2, 3, 4, 5], 2)
    """
    ends, lacking = len(knots) - count, len(knots) - count - degree - 1
    if lacking == 0 and periodic and knots[0] == knots[degree]:
        return Whole(knots, 0, ("flagged periodic, but its knots are clamped: read as written",))
    if count and 1 <= ends <= degree and _are_ends(knots, ends):
        return _unrolled(knots, count, degree + 1 - ends)
    if 1 <= lacking <= degree and (periodic or len({b - a for a, b in zip(knots, knots[count:], strict=False)}) == 1):
        return Whole(knots, lacking, (f"periodic: its first {lacking} control points are repeated",))
    return Whole(knots)


def _are_ends(knots: Sequence[mpq], times: int) -> bool:
    """Whether the first and the last knot are there exactly so often, and differ."""
    ends = [sum(t == end for t in knots) for end in (knots[0], knots[-1])]
    return knots[0] < knots[-1] and ends == [times, times]


def _unrolled(knots: Sequence[mpq], count: int, more: int) -> Whole:
    period, found = knots[-1] - knots[0], list(knots)
    for _ in range(more):
        found = [found[count - 1] - period, *found, found[len(found) - count] + period]
    remark = f"periodic, listed by one period: the knots are continued, {more} control points are repeated"
    return Whole(found, more, (remark,))


def domain(degree: int, knots: Sequence[mpq]) -> tuple[mpq, mpq]:
    """The ends of the domain, 0 and 0 where there are too few knots."""
    return (knots[degree], knots[-degree - 1]) if len(knots) >= 2 * degree + 2 else (mpq(0), mpq(0))


def used(ends: tuple[mpq, mpq], start: mpq, end: mpq) -> tuple[tuple[mpq, mpq] | None, list[str]]:
    """The part of a domain with these ends that an entity uses, None for all of it, and notes on it.

    >>> used((mpq(0), mpq(1)), mpq(1, 4), mpq(2))[0]
    (mpq(1,4), mpq(1,1))
    """
    low, high = max(start, ends[0]), min(end, ends[1])
    if (start, end) == ends or not ends[0] < ends[1]:
        return None, []
    asked = f"the entity uses the parameters from {start} to {end}"
    if not start < end:
        return None, [f"{asked}, which run backwards: the whole spline is read"]
    if not low < high:
        return None, [f"{asked}, which are not in the domain: the whole spline is read"]
    beyond = "" if (low, high) == (start, end) else f", of which only {ends[0]} to {ends[1]} is in the domain"
    return (low, high), [f"{asked}{beyond}"]
