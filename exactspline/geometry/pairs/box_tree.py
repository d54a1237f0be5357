"""The segments of a curve, prepared once for all questions about the curve and other curves. The pairs of segments that
may meet are found by boxes around segments in a binary tree, in time linear in the number of pairs whose boxes meet.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from exactspline.geometry.curves.facts import kept_by
from exactspline.numbers.once import cached_property
from exactspline.programs.certain_pairs import precise_table_of, table_of
from exactspline.roots.segment_forms import SegmentForms, SegmentRows, forms_of, segment_rows
from exactspline.splines.nurbs import Nurbs

#: A segment by its forms, or by their integers.
Segment = SegmentForms | SegmentRows
#: An interval of integers in each coordinate; None for everything.
IntegerBox = tuple[tuple[int, int], ...] | None

#: The bits of a coordinate of the boxes.
BITS = 30


class Segments:
    """The segments of a curve as integers, forms, doubles and boxes, each computed once. This data is stored with the
    curve and holds no reference to the curve.
    """

    def __init__(self, curve: Nurbs) -> None:
        self.rows, self.breaks = [segment_rows(curve, i) for i in range(curve.segments)], curve.breakpoints
        self._trees: dict[int, BoxTree] = {}

    @cached_property
    def forms(self) -> list[SegmentForms]:
        """The forms of the segments."""
        return [*map(forms_of, self.rows)]

    @cached_property
    def table(self) -> bytes:
        """The numbers of the segments for the C extension."""
        return table_of(self.rows)

    @cached_property
    def precise(self) -> bytes:
        """The numbers of the segments for the C extension to twice the precision."""
        return precise_table_of(self.rows, self.breaks)

    @cached_property
    def size(self) -> int:
        """Roughly the number of bits before the binary point of the largest coordinate of a starting point."""
        sizes = (x[0].bit_length() - w[0].bit_length() for _, (*p, w) in self.rows for x in p if x[0])
        return max(sizes, default=0)

    def boxes(self, shift: int, margin: int = 0) -> BoxTree:
        """The tree of the boxes of the segments; a tree without a margin is stored."""
        if margin:
            return BoxTree([_box_of(segment, shift, margin) for segment in self.rows])
        if shift not in self._trees:
            self._trees[shift] = BoxTree([_box_of(segment, shift) for segment in self.rows])
        return self._trees[shift]


def segments_of(curve: Nurbs) -> Segments:
    """The segments of a curve, prepared once."""
    return kept_by(curve).once("segments", lambda: Segments(curve))


def shift_for(*curves: Segments) -> int:
    """The power of two that scales coordinates as large as those of the starting points to about `BITS` bits."""
    return max(0, BITS - max(own.size for own in curves))


def _box_of(segment: Segment, shift: int, margin: int = 0) -> IntegerBox:
    """Integers that enclose ``2^shift`` times every coordinate on a segment, by its control points, with a margin on
    each side; None where their weights have different signs.

    >>> from flint import fmpz_poly
    >>> _box_of((1, [fmpz_poly([0, 1]), fmpz_poly([3, 3])]), 2)
    ((0, 2),)
    """
    n, (*coordinates, w) = segment
    weights = [int(w[i]) for i in range(n + 1)]
    if min(weights) <= 0 <= max(weights):
        return None
    box = []
    for f in coordinates:
        quotients = [(int(f[i]) << shift) // weight for i, weight in enumerate(weights)]
        box.append((min(quotients) - margin, max(quotients) + 1 + margin))
    return tuple(box)


class BoxTree:
    """Boxes around segments, and around all of them from one to another.

    >>> from exactspline import example
    >>> segments_of(example("circle")).boxes(4).boxes[0]  # a quarter of the unit circle, in units of 1/16
    ((0, 17), (0, 17))
    """

    def __init__(self, boxes: Sequence[IntegerBox]) -> None:
        self.boxes = boxes
        #: The boxes of the nodes: of the segments from one up to another, excluding the latter.
        self.nodes: dict[tuple[int, int], IntegerBox] = {}
        self._join(0, len(self.boxes))

    def _join(self, first: int, last: int) -> IntegerBox:
        if last == first + 1:
            box = self.boxes[first]
        else:
            middle = (first + last) // 2
            box = _box_of_both(self._join(first, middle), self._join(middle, last))
        self.nodes[first, last] = box
        return box


def _box_of_both(one: IntegerBox, other: IntegerBox) -> IntegerBox:
    """The least box around two."""
    if one is None or other is None:
        return None
    return tuple((min(a, c), max(b, d)) for (a, b), (c, d) in zip(one, other, strict=True))


def _meets(one: IntegerBox, other: IntegerBox) -> bool:
    """Whether two boxes have a point in common.

    >>> _meets(((0, 2),), ((3, 4),)), _meets(((0, 2),), None)
    (False, True)
    """
    if one is None or other is None:
        return True
    for (a, b), (c, d) in zip(one, other, strict=True):  # noqa: SIM110  # a generator is slower
        if a > d or c > b:
            return False
    return True


def pairs_that_may_meet(first: BoxTree, second: BoxTree) -> Iterator[tuple[int, int]]:
    """The pairs of indices of segments whose boxes meet; for a tree and itself each pair once, the smaller index
    first.
    """
    todo = [((0, len(first.boxes)), (0, len(second.boxes)))]
    while todo:
        one, other = todo.pop()
        if (first is second and one[0] >= other[1]) or not _meets(first.nodes[one], second.nodes[other]):
            continue
        sizes = one[1] - one[0], other[1] - other[0]
        if sizes == (1, 1):
            yield one[0], other[0]
        elif sizes[0] >= sizes[1]:
            middle = sum(one) // 2
            todo += [((middle, one[1]), other), ((one[0], middle), other)]
        else:
            middle = sum(other) // 2
            todo += [(one, (middle, other[1])), (one, (other[0], middle))]


#: Two vectors that bound a cone: counterclockwise from the first to the second, by less than a half turn.
Cone = tuple[tuple[int, int], tuple[int, int]]


def legs(segment: Segment) -> list[tuple[int, int]]:
    """Positive multiples of the vectors from one control point of a segment in the plane to the next, without zero
    vectors; the list is empty where weights vanish or have different signs.

    >>> from flint import fmpz_poly
    >>> legs((2, [fmpz_poly([0, 1, 2]), fmpz_poly([0, 1, 1]), fmpz_poly([1, 2, 1])]))
    [(1, 1), (3, 1)]
    """
    n, forms = segment
    x, y, w = ([int(c[k]) for k in range(n + 1)] for c in forms)
    if min(w) <= 0 <= max(w):
        return []
    crossed = ((x[k + 1] * w[k] - x[k] * w[k + 1], y[k + 1] * w[k] - y[k] * w[k + 1]) for k in range(n))
    return [leg for leg in crossed if any(leg)]


def cone_around(vectors: Sequence[tuple[int, int]]) -> Cone | None:
    """The least cone around vectors; None if there are no vectors, or if no open half plane contains all of them. A
    curve with positive weights whose legs lie in a cone is monotone in a direction.

    >>> cone_around([(1, 0), (1, 1), (2, -1)]), cone_around([(1, 0), (0, 1), (-1, 0)])
    (((2, -1), (1, 1)), None)
    """
    if not vectors:
        return None
    first = last = vectors[0]
    for x, y in vectors:
        behind, before = first[0] * y - first[1] * x, x * last[1] - y * last[0]
        if behind > 0 > before:
            last = x, y
        elif behind < 0 < before:
            first = x, y
        elif behind < 0 or before < 0 or (behind == before == 0 and first[0] * x + first[1] * y < 0):
            return None
    return first, last
