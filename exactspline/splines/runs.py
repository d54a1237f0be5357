"""Runs of segments: on an open spline from knot to knot, on a closed one also across its seam."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval


def runs(holds: Sequence[bool], joined: Sequence[bool]) -> list[tuple[int, int]]:
    """The maximal runs of segments on which something holds, as ``(first, number)``.

    ``joined[i]`` states that a run may continue from segment i − 1 to segment i; ``joined[0]`` concerns the seam, from
    the last segment to the first (False for an open spline). A run across the seam begins before it; one that closes up
    begins at 0.

    >>> runs([True, True, False, True], [True, True, True, True])
    [(3, 3)]
    >>> runs([True, True, True], [True, False, True])
    [(1, 3)]
    """
    count = len(holds)
    maximal: list[tuple[int, int]] = []
    for i, here in enumerate(holds):
        if here and i and holds[i - 1] and joined[i]:
            first, number = maximal[-1]
            maximal[-1] = first, number + 1
        elif here:
            maximal.append((i, 1))
    if len(maximal) > 1 and joined[0] and holds[0] and holds[-1]:
        first, number = maximal.pop()
        maximal[0] = first, number + maximal[0][1]
        maximal.sort()
    assert all(number <= count for _, number in maximal)
    return maximal


def intervals_of(breaks: Sequence[mpq], first: int, number: int) -> tuple[Interval, ...]:
    """A run of segments as intervals of the domain, in the order of traversal: one, or two where it crosses the seam.

    >>> [str(part) for part in intervals_of([mpq(0), mpq(1), mpq(3)], 1, 2)]
    ['[1, 3]', '[0, 1]']
    """
    beyond = first + number - (len(breaks) - 1)
    if beyond <= 0:
        return (Interval(breaks[first], breaks[first + number]),)
    return Interval(breaks[first], breaks[-1]), Interval(breaks[0], breaks[beyond])
