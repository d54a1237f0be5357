"""Filled paths as Bézier pieces that are halved when they are too large, in exact arithmetic."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

from exactspline.errors import CurveFileError, ShapeError
from exactspline.geometry.pairs.winding import FillRule
from exactspline.interchange.records import Limits
from exactspline.interchange.svg_paths import subpaths
from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property

Point = tuple[mpq, mpq]


class Box(NamedTuple):
    """A rectangle with sides parallel to the axes."""

    left: mpq
    right: mpq
    low: mpq
    high: mpq

    def meets(self, other: Box) -> bool:
        """Whether they have a point in common."""
        apart = self.right < other.left or other.right < self.left or self.high < other.low or other.high < self.low
        return not apart

    def grown(self, by: mpq) -> Box:
        """With all points that are at most so far from it in both directions."""
        return Box(self.left - by, self.right + by, self.low - by, self.high + by)

    @property
    def size(self) -> mpq:
        """The longer side."""
        return max(self.right - self.left, self.high - self.low)

    @property
    def centre(self) -> Point:
        """Its middle."""
        return (self.left + self.right) / 2, (self.low + self.high) / 2

    @property
    def quarters(self) -> tuple[Box, Box, Box, Box]:
        """The four parts around its middle."""
        x, y = self.centre
        return (
            Box(self.left, x, self.low, y),
            Box(x, self.right, self.low, y),
            Box(self.left, x, y, self.high),
            Box(x, self.right, y, self.high),
        )

    def least(self, point: Point) -> mpq:
        """The square of the least distance from a point."""
        x, y = point
        dx, dy = max(self.left - x, x - self.right, mpq(0)), max(self.low - y, y - self.high, mpq(0))
        return dx * dx + dy * dy

    def greatest(self, point: Point) -> mpq:
        """The square of the greatest distance from a point."""
        x, y = point
        dx, dy = max(x - self.left, self.right - x), max(y - self.low, self.high - y)
        return dx * dx + dy * dy


class Piece:
    """A Bézier segment, which lies in the box of its control points."""

    def __init__(self, points: tuple[Point, ...]) -> None:
        self.points = points
        xs, ys = [x for x, _ in points], [y for _, y in points]
        self.box = Box(min(xs), max(xs), min(ys), max(ys))
        self.size = self.box.size

    @cached_property
    def halves(self) -> tuple[Piece, Piece]:
        """Its parts before and behind the middle of its parameters, by de Casteljau."""
        row, first, last = self.points, [self.points[0]], [self.points[-1]]
        while len(row) > 1:
            row = tuple([((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in pairwise(row)])
            first.append(row[0])
            last.append(row[-1])
        return Piece(tuple(first)), Piece(tuple(last[::-1]))


def without_slits(pieces: Iterable[Piece]) -> list[Piece]:
    """Pieces with the same winding numbers, without those run through back and forth: curves with the same control
    points in reverse, and parts of lines.

    >>> slit = Region.of("M0 0H2V2H0ZM0 1H1.5H.5Z")
    >>> len(slit.pieces), len(without_slits(slit.pieces))
    (7, 4)
    """
    curves, lines = Counter[tuple[Point, ...]](), dict[tuple[mpq, mpq, mpq], list[tuple[Point, Point]]]()
    for piece in pieces:
        if len(piece.points) == 2:
            (a, b), (c, d) = piece.points
            if (a, b) != (c, d):
                scale = (d - b) or (a - c)
                key = ((d - b) / scale, (a - c) / scale, (a * d - b * c) / scale)
                lines.setdefault(key, []).append(((a, b), (c, d)))
        elif piece.points > piece.points[::-1]:
            curves[piece.points[::-1]] -= 1
        else:
            curves[piece.points] += 1
    for along in lines.values():
        for start, end in pairwise(sorted({point for line in along for point in line})):
            times = sum(first <= start and end <= last for first, last in along)
            times -= sum(last <= start and end <= first for first, last in along)
            curves[start, end] += times
    return [Piece(points if times > 0 else points[::-1]) for points, times in curves.items() for _ in range(abs(times))]


def reaching(pieces: Iterable[Piece], box: Box, size: mpq) -> list[Piece]:
    """The pieces, halved until they are no larger than a size, whose boxes meet a box."""
    found, waiting = list[Piece](), list(pieces)
    while waiting:
        piece = waiting.pop()
        if piece.box.meets(box):
            if piece.size > size:
                waiting += piece.halves
            else:
                found.append(piece)
    return found


#: How often a piece is halved before a point counts as near to it.
DEEPEST = 60


def is_far(pieces: Iterable[Piece], point: Point, within: mpq) -> bool:
    """Whether a point is proved to be further from all pieces than a distance."""
    waiting = [(piece, 0) for piece in pieces]
    square = within * within
    while waiting:
        piece, depth = waiting.pop()
        if piece.box.least(point) > square:
            continue
        ends = (piece.points[0], piece.points[-1])
        if depth > DEEPEST or any((x - point[0]) ** 2 + (y - point[1]) ** 2 <= square for x, y in ends):
            return False
        waiting += [(half, depth + 1) for half in piece.halves]
    return True


@dataclass(frozen=True)
class Region:
    """What closed paths enclose by a fill rule.

    >>> square = Region.of("M0 0H2V2H0Z")
    >>> square.contains((mpq(1), mpq(1))), square.contains((mpq(3), mpq(1))), square.winding((mpq(1), mpq(1)))
    (True, False, 1)
    """

    pieces: tuple[Piece, ...]
    rule: FillRule = FillRule.NONZERO

    @classmethod
    def of(cls, data: str, rule: FillRule = FillRule.NONZERO) -> Region:
        """What path data of SVG enclose; open subpaths are closed by a line.

        Raises `CurveFileError` for data with an error, `ShapeError` for arcs.
        """
        parts, problem = subpaths(data, Limits())
        if problem or any(part.problem for part in parts):
            raise CurveFileError(problem or next(part.problem for part in parts if part.problem), where="path data")
        return cls(tuple(piece for part in parts for piece in _closed(part.segments)), rule)

    def winding(self, point: Point) -> int:
        """How often the paths wind around a point that is on none of them, counterclockwise where y points up.

        A ray to the right is moved down by less than any number: an end on its line is above it.
        """
        x, y = point
        total, waiting = 0, list(self.pieces)
        while waiting:
            piece = waiting.pop()
            left, right, low, high = piece.box
            if high < y or low >= y or right < x:
                continue
            if left > x:
                total += int(piece.points[-1][1] >= y) - int(piece.points[0][1] >= y)
            else:
                waiting += piece.halves
        return total

    def contains(self, point: Point) -> bool:
        """Whether a point that is on none of the paths is inside."""
        winding = self.winding(point)
        return winding % 2 == 1 if self.rule is FillRule.EVEN_ODD else winding != 0


def _closed(segments: Iterable[tuple[tuple[mpq, ...], ...]]) -> Iterator[Piece]:
    """The pieces of a subpath, and the line that closes it where it is open."""
    listed = list(segments)
    if any(point[-1] != 1 for segment in listed for point in segment):
        raise ShapeError("an arc", remedy="write it as Bézier segments")
    for segment in listed:
        yield Piece(tuple([(point[0], point[1]) for point in segment]))
    first, last = listed[0][0], listed[-1][-1]
    if first != last:
        yield Piece(((last[0], last[1]), (first[0], first[1])))
