"""Whether a result of a Boolean operation is right outside of a tube around the paths that were combined.

For every point of the plane that is further than ε from both source paths, and not on the result, it is decided whether
it is inside the result exactly where the operation says so. The plane is divided into squares: those that lie in the
tube are left; in those that no path meets, the winding numbers are constant, and one point decides; all others are
divided. The criterion is that of https://github.com/linebender/kurbo/issues/277.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from exactspline.errors import ShapeError
from exactspline.numbers.exact import mpq
from workshop.boolean.pieces import Box, Piece, Point, Region, is_far, reaching, without_slits

#: Squares smaller than this fraction of ε are not divided; pieces smaller than that fraction are not halved.
SMALLEST, FINE = mpq(1, 64), mpq(1, 4)
#: A point nearer to the result than this fraction of ε is not judged by itself.
FINEST = mpq(1, 1 << 30)
#: With this many squares that are not decided no more are looked at.
MOST = 200


class Operation(StrEnum):
    """What is made of two regions."""

    UNION = "union"
    INTERSECTION = "intersection"
    DIFFERENCE = "difference"
    XOR = "xor"

    def holds(self, first: bool, second: bool) -> bool:
        """Whether a point is in the result that is in these of the regions."""
        return {
            Operation.UNION: first or second,
            Operation.INTERSECTION: first and second,
            Operation.DIFFERENCE: first and not second,
            Operation.XOR: first != second,
        }[self]


@dataclass(frozen=True)
class Judgement:
    """Whether a result is right outside of the tube: None where that is not decided, in these squares.

    ``witness``: a point further than ε from the paths at which it is wrong, and whether it should be inside.
    """

    right: bool | None
    witness: Point | None = None
    inside: bool | None = None
    undecided: tuple[Box, ...] = ()
    squares: int = 0


def judged(first: Region, second: Region, operation: Operation, result: Region, within: mpq) -> Judgement:
    """The judgement on a result.

    >>> a, b = Region.of("M0 0H2V2H0Z"), Region.of("M1 0H3V2H1Z")
    >>> judged(a, b, Operation.UNION, Region.of("M0 0H3V2H0Z"), mpq(1, 8)).right
    True
    >>> wrong = judged(a, b, Operation.UNION, a, mpq(1, 8))
    >>> wrong.right, wrong.inside, 2 < wrong.witness[0] < 3
    (False, True, True)

    Raises `ShapeError` for an ε that is not above 0.
    """
    if within <= 0:
        raise ShapeError(f"a distance of {within}", remedy="give a number above 0")
    sources, squares = (*first.pieces, *second.pieces), 0
    result = Region(tuple(without_slits(result.pieces)), result.rule)
    waiting: deque[tuple[Box, Sequence[Piece], Sequence[Piece]]] = deque()
    if sources or result.pieces:
        waiting.append((_around((*sources, *result.pieces)), sources, result.pieces))
    undecided = list[Box]()
    while waiting and len(undecided) < MOST:
        square, near, own = waiting.popleft()
        squares += 1
        near = reaching(near, square.grown(within), max(square.size, within * FINE))
        if _is_in_tube(square, near, within):
            continue
        own = reaching(own, square, square.size)
        if not own and not any(piece.box.meets(square) for piece in near):
            point = square.centre
            inside = operation.holds(first.contains(point), second.contains(point))
            if result.contains(point) == inside:
                continue
            if is_far(near, point, within):
                return Judgement(False, point, inside, squares=squares)
        if square.size < within * SMALLEST:
            undecided.append(square)
        else:
            waiting += [(quarter, near, own) for quarter in square.quarters]
    return Judgement(None if undecided else True, undecided=tuple(undecided), squares=squares)


def judged_at(
    point: Point, first: Region, second: Region, operation: Operation, result: Region, within: mpq
) -> Judgement | None:
    """The judgement on a result at one point alone: None where it is right there, where the point may be in the tube,
    and where it may be on the result.
    """
    if not is_far((*first.pieces, *second.pieces), point, within) or not is_far(result.pieces, point, within * FINEST):
        return None
    inside = operation.holds(first.contains(point), second.contains(point))
    return None if result.contains(point) == inside else Judgement(False, point, inside)


def _around(pieces: Sequence[Piece]) -> Box:
    """A square that contains all pieces: outside of it nothing is inside."""
    left, low = min(piece.box.left for piece in pieces), min(piece.box.low for piece in pieces)
    right, high = max(piece.box.right for piece in pieces), max(piece.box.high for piece in pieces)
    side = max(right - left, high - low) or mpq(1)
    return Box(left, left + side, low, low + side)


def _is_in_tube(square: Box, near: Sequence[Piece], within: mpq) -> bool:
    """Whether one point of a path is within ε of all points of a square."""
    reach = within * within
    return any(square.greatest(end) <= reach for piece in near for end in (piece.points[0], piece.points[-1]))
