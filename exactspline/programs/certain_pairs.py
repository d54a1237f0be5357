"""The common points of pairs of segments of plane curves that are certain in doubles, by the optional C extension
(filter.c). Exact arithmetic decides the undecided pairs. Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import c_double
from fractions import Fraction
from sys import float_info

from exactspline.numbers.exact import mpq
from exactspline.numbers.extension import loaded
from exactspline.programs.accelerator import surrounds

#: A degree, and the integers of the forms x, y, w.
Segment = tuple[int, Sequence[Sequence[int]]]
#: As in filter.c: the highest degree of a segment, the numbers of a common point, and the room for those of a pair.
HIGHEST, OF_POINT = 12, 6
OF_PAIR = c_double * (OF_POINT * 36)
#: The numbers of two parameters.
OF_PARAMETERS = c_double * 8
#: A box without ends.
EVERYWHERE = (-float_info.max, float_info.max) * 2
#: Two segments whose common points are known.
ARCH: Segment = (2, [(0, 2, 2), (0, 8, 0), (1, 2, 1)])
LINE: Segment = (1, [(0, 6), (3, 3), (2, 2)])


#: A transversal common point of two segments, inside both: the ends of intervals of its parameters; the sign before the
#: zero of Bézout's determinant, and its number among all zeros. The zero, the only one in its interval, belongs to the
#: segment of higher degree (the second one for equal degrees). A point that was found without the determinant has the
#: number −1.
PairPoint = Sequence[float]


def points_of(numbers: Sequence[float]) -> list[PairPoint]:
    """The common points with these numbers."""
    return [numbers[k : k + OF_POINT] for k in range(0, len(numbers), OF_POINT)]


def certain_pair(first: bytes, i: int, second: bytes | None, j: int) -> Sequence[float] | None:
    """The numbers of the common points of two segments of two tables, or of one, where a segment and itself have the
    points through which the segment passes twice; None if the points are not certain.

    >>> found = certain_pair(table_of([ARCH]), 0, table_of([LINE]), 0)
    >>> found is None or len(points_of(found)) == 2
    True
    """
    found = OF_PAIR()
    count = -1 if filter_pair is None else filter_pair(first, i, second, j, found)
    return None if count < 0 else found[: OF_POINT * count]


def closer(first: bytes, i: int, second: bytes, j: int, box: Sequence[float]) -> Sequence[float]:
    """The parameters of the common point of two segments of two precise tables in a box, the ends of the intervals of
    both parameters: for each parameter a double near it, the difference from it, a bound of the error of the
    difference, and the double nearest to the parameter on the curve, or not a number; nothing if it is not certain.
    """
    near = OF_PARAMETERS(*box)
    return near[:] if filter_closer is not None and filter_closer(first, i, second, j, near) else ()


def _meets(function: Callable[..., int]) -> bool:
    """Whether the parabola x = 2t, y = 8t(1 − t) and the line x = 3s, y = 3/2 meet at t = 1/4 and 3/4."""
    found = OF_PAIR()
    return function(table_of([ARCH]), 0, table_of([LINE]), 0, found) == 2 and all(
        surrounds(point[0], point[1], t) and surrounds(point[2], point[3], s) and point[4:] == signs
        for point, t, s, signs in zip(
            points_of(found[:12]), (1 / 4, 3 / 4), (1 / 6, 1 / 2), ([-1, 0], [1, 1]), strict=True
        )
    )


def _closes(function: Callable[..., int]) -> bool:
    """Whether the common point of the line and the parabola at s = 1/6 and t = 1/4 is found to twice the precision."""
    tables = [precise_table_of([segment], [mpq(k), mpq(k + 1)]) for k, segment in enumerate((LINE, ARCH))]
    near = OF_PARAMETERS(1 / 6 - 2**-40, 1 / 6 + 2**-39, 1 / 4 - 2**-40, 1 / 4 + 2**-39)
    return function(tables[0], 0, tables[1], 0, near) == 1 and all(
        abs(Fraction(near[k]) + Fraction(near[k + 1]) - Fraction(1, below)) <= near[k + 2] < 2**-80
        and near[k + 3] == k // 4 + 1 / below
        for k, below in ((0, 6), (4, 4))
    )


def table_of(segments: Sequence[Segment]) -> bytes:
    """The numbers of segments, all of one degree, for C."""
    return array("d", [x for segment in segments for x in segment_in_doubles(*segment)]).tobytes()


def precise_table_of(segments: Sequence[Segment], ends: Sequence[mpq]) -> bytes:
    """The numbers of segments, all of one degree, between these ends for C to twice the precision: the degree, and each
    coefficient as a double near it and the difference from it; doubles near both ends, and the differences from them; a
    zero if a number is too large.
    """
    numbers: list[float] = []
    try:
        for (n, forms), *side in zip(segments, ends[:-1], ends[1:], strict=True):
            numbers.append(n)
            for form in forms:
                numbers += [x for c in form for x in (c, c - int(float(c)))]
            numbers += [*map(float, side), *(float(x - mpq(float(x))) for x in side)]
        return array("d", numbers).tobytes()
    except OverflowError:
        return bytes(8)


def segment_in_doubles(n: int, forms: Sequence[Sequence[int]]) -> Sequence[float]:
    """The degree of a segment, a box around it, the middle of its control points in doubles, and the coefficients of
    its forms relative to this middle, each rounded once: zeros where nothing is certain, and no degree but 0 if C does
    not take segments of this degree.
    """
    if not 0 < n <= HIGHEST or len(forms) != 3:
        return (0,)
    *coordinates, weights = forms
    try:
        points = [[c / w for c, w in zip(x, weights, strict=True)] for x in coordinates]
        ends = [(min(x), max(x)) for x in points]
        middle = [(low + high) / 2 for low, high in ends]
        row = [n, *(EVERYWHERE if min(weights) <= 0 <= max(weights) else sum(ends, ())), *middle]
        for x, at in zip(coordinates, middle, strict=True):
            p, q = at.as_integer_ratio()
            row += [(c * q - w * p) / q for c, w in zip(x, weights, strict=True)]
        return [*row, *map(float, weights)]
    except (OverflowError, ZeroDivisionError):
        return (n, *EVERYWHERE, *[0] * (2 + 3 * (n + 1)))


#: The functions of the extension; None without the extension.
filter_pair, filter_closer = loaded("filter_pair", _meets), loaded("filter_closer", _closes)
