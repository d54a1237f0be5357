"""The common points of pairs of segments of plane curves that are certain in doubles, by the optional C extension
(filter.c). Exact arithmetic decides the undecided pairs. Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import c_int, c_void_p
from typing import NamedTuple

from exactspline.programs.accelerator import loaded, surrounds

#: A degree, and the integers of the forms x, y, w.
Segment = tuple[int, Sequence[Sequence[int]]]
#: As in filter.c: the highest degree of a segment, and the numbers of a common point.
HIGHEST, OF_POINT = 5, 7
#: A segment about which nothing is certain.
OPEN = [0] * (3 + 3 * (HIGHEST + 1))
#: This many pairs are decided in one call.
TOGETHER = 64
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
    before: int
    number: int
    other: tuple[float, float]


def certain_pairs(
    first: array[float], second: array[float] | None, pairs: Sequence[tuple[int, int]]
) -> list[list[PairPoint] | None]:
    """The common points of pairs of segments of two tables, or of one, where a pair of a segment with itself has the
    points through which the segment passes twice; None if the points are not certain.

    >>> arch, line = (2, [(0, 2, 2), (0, 8, 0), (1, 2, 1)]), (1, [(0, 3), (1, 1), (1, 1)])
    >>> found = certain_pairs(table_of([arch]), table_of([line]), [(0, 0)])
    >>> found == [None] or [len(points) for points in found] == [2]
    True
    """
    if filter_pairs is None:
        return [None] * len(pairs)
    found: list[list[PairPoint] | None] = []
    for start in range(0, len(pairs), TOGETHER):
        found += _decided(filter_pairs, first, second, pairs[start : start + TOGETHER])
    return found


def _decided(
    function: Callable[..., int], ours: array[float], theirs: array[float] | None, pairs: Sequence[tuple[int, int]]
) -> list[list[PairPoint] | None]:
    """The result of the extension for some pairs of segments of two tables, or of one."""
    count, room = len(pairs), len(pairs) * HIGHEST**2
    indices, open_ = array("i", [i for pair in pairs for i in pair]), array("i", bytes(4 * count))
    points = array("d", bytes(8 * OF_POINT * room))
    one, other, which, left, to = [x and x.buffer_info()[0] for x in (ours, theirs, indices, open_, points)]
    known = function(one, other, which, count, left, to, room)
    own: list[list[PairPoint] | None] = [None if x else [] for x in open_]
    for k in range(0, OF_POINT * known, OF_POINT):
        pair, low, high, before, number, *bounds = points[k : k + OF_POINT]
        if (one_pair := own[int(pair)]) is not None:
            one_pair.append(PairPoint(low, high, int(before), int(number), (bounds[0], bounds[1])))
    return own


def _meets(function: Callable[..., int]) -> bool:
    """Whether the parabola x = 2t, y = 8t(1 − t) and the line x = 3s, y = 3/2 meet at t = 1/4 and 3/4."""
    found = _decided(function, table_of([ARCH]), table_of([LINE]), [(0, 0)])[0] or []
    known = [(-1, 0, 1 / 4, 1 / 6), (1, 1, 3 / 4, 1 / 2)]
    return len(found) == 2 and all(
        (point.before, point.number) == (before, number) and surrounds(*point[:2], t) and surrounds(*point.other, s)
        for point, (before, number, t, s) in zip(found, known, strict=True)
    )


def table_of(segments: Sequence[Segment]) -> array[float]:
    """The numbers of segments for C."""
    return array("d", [x for segment in segments for x in segment_in_doubles(*segment)])


def segment_in_doubles(n: int, forms: Sequence[Sequence[int]]) -> Sequence[float]:
    """The degree of a segment, the middle of its control points in doubles, and the coefficients of its forms relative
    to this middle, each rounded once.
    """
    if not 0 < n <= HIGHEST or len(forms) != 3:
        return OPEN
    *coordinates, weights = forms
    spare = [0] * (HIGHEST - n)
    try:
        points = [[c / w for c, w in zip(x, weights, strict=True)] for x in coordinates]
        middle = [(min(x) + max(x)) / 2 for x in points]
        row = [n, *middle]
        for x, at in zip(coordinates, middle, strict=True):
            p, q = at.as_integer_ratio()
            row += [(c * q - w * p) / q for c, w in zip(x, weights, strict=True)]
            row += spare
        return [*row, *map(float, weights), *spare]
    except (OverflowError, ZeroDivisionError):
        return OPEN


#: The function of the extension; None without the extension.
filter_pairs = loaded("filter_pairs", _meets, *[c_void_p] * 3, c_int, *[c_void_p] * 2, c_int)
