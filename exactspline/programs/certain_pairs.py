"""The common points of pairs of segments of plane curves that are certain in doubles, by the optional C extension
(filter.c). Exact arithmetic decides the undecided pairs. Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import c_double
from sys import float_info
from typing import NamedTuple

from exactspline.programs.accelerator import loaded, surrounds

#: A degree, and the integers of the forms x, y, w.
Segment = tuple[int, Sequence[Sequence[int]]]
#: As in filter.c: the highest degree of a segment, the numbers of a common point, and the room for all those of a pair.
HIGHEST, OF_POINT = 5, 6
OF_PAIR = c_double * (OF_POINT * HIGHEST**2)
#: A box without ends.
EVERYWHERE = (-float_info.max, float_info.max) * 2
#: A segment about which nothing is certain.
OPEN = (0, *EVERYWHERE, *[0] * (2 + 3 * (HIGHEST + 1)))
#: Two segments whose common points are known.
ARCH: Segment = (2, [(0, 2, 2), (0, 8, 0), (1, 2, 1)])
LINE: Segment = (1, [(0, 6), (3, 3), (2, 2)])


class PairPoint(NamedTuple):
    """A transversal common point of two segments, inside both: an interval of the parameter of the segment of higher
    degree (of the second segment for equal degrees) in which Bézout's determinant has no other zero, the sign before
    it, its number among all zeros of the determinant, and an interval of the parameter of the other segment.
    """

    low: float
    high: float
    before: float
    number: float
    other_low: float
    other_high: float


def points_of(numbers: Sequence[float]) -> list[PairPoint]:
    """The common points with these numbers."""
    return [PairPoint(*numbers[k : k + OF_POINT]) for k in range(0, len(numbers), OF_POINT)]


def certain_pair(first: bytes, i: int, second: bytes | None, j: int) -> Sequence[float] | None:
    """The numbers of the common points of two segments of two tables, or of one, where a segment and itself have the
    points through which the segment passes twice; None if the points are not certain.

    >>> found = certain_pair(table_of([ARCH]), 0, table_of([LINE]), 0)
    >>> found is None or len(points_of(found)) == 2
    True
    """
    return None if filter_pair is None else _decided(filter_pair, first, i, second, j)


def _decided(
    function: Callable[..., int], first: bytes, i: int, second: bytes | None, j: int
) -> Sequence[float] | None:
    """The result of the extension."""
    found = OF_PAIR()
    count = function(first, i, second, j, found)
    return None if count < 0 else found[: OF_POINT * count]


def _meets(function: Callable[..., int]) -> bool:
    """Whether the parabola x = 2t, y = 8t(1 − t) and the line x = 3s, y = 3/2 meet at t = 1/4 and 3/4."""
    found = points_of(_decided(function, table_of([ARCH]), 0, table_of([LINE]), 0) or [])
    known = [((-1, 0), 1 / 4, 1 / 6), ((1, 1), 3 / 4, 1 / 2)]
    return len(found) == 2 and all(
        point[2:4] == signs and surrounds(*point[:2], t) and surrounds(*point[4:], s)
        for point, (signs, t, s) in zip(found, known, strict=True)
    )


def table_of(segments: Sequence[Segment]) -> bytes:
    """The numbers of segments for C."""
    return array("d", [x for segment in segments for x in segment_in_doubles(*segment)]).tobytes()


def segment_in_doubles(n: int, forms: Sequence[Sequence[int]]) -> Sequence[float]:
    """The degree of a segment, a box around it, the middle of its control points in doubles, and the coefficients of
    its forms relative to this middle, each rounded once.
    """
    if not 0 < n <= HIGHEST or len(forms) != 3:
        return OPEN
    *coordinates, weights = forms
    spare = [0] * (HIGHEST - n)
    try:
        points = [[c / w for c, w in zip(x, weights, strict=True)] for x in coordinates]
        ends = [(min(x), max(x)) for x in points]
        middle = [(low + high) / 2 for low, high in ends]
        row = [n, *(EVERYWHERE if min(weights) <= 0 <= max(weights) else sum(ends, ())), *middle]
        for x, at in zip(coordinates, middle, strict=True):
            p, q = at.as_integer_ratio()
            row += [(c * q - w * p) / q for c, w in zip(x, weights, strict=True)]
            row += spare
        return [*row, *map(float, weights), *spare]
    except (OverflowError, ZeroDivisionError):
        return OPEN


#: The function of the extension; None without the extension.
filter_pair = loaded("filter_pair", _meets)
