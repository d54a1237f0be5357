"""The smallest pair on which an engine is wrong: fewer segments, smaller integers, a larger step between the paths, as
long as the judge still finds the result wrong.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

from exactspline.numbers.exact import mpq
from workshop.boolean.grading import Graded, Outcome, graded
from workshop.boolean.pairs import Pair
from workshop.grade.runner import Worker

#: The number of smaller pairs tried for one result.
TRIES = 300


def shrunk(worker: Worker, found: Graded, within: mpq, tries: int = TRIES) -> Graded:
    """A result of the same engine and operation with the same outcome, on a pair that is as small as was found."""
    remaining, more = tries, True
    while more:
        more = False
        for pair in islice(smaller(found.pair), remaining):
            remaining -= 1
            tried = next(
                graded(worker, [pair], [found.operation], within, whole=found.outcome is Outcome.UNDECIDED), None
            )
            same = tried is not None and tried.outcome is found.outcome
            if tried is not None and same and (found.outcome is Outcome.WRONG or tried.why == found.why):
                found, more = tried, True
                break
    return found


def smaller(pair: Pair) -> Iterator[Pair]:
    """Pairs without a segment, at a larger distance, or with one coordinate that is nearer to 0; all of a smaller
    size.
    """
    points = pair.points
    if len(points) > 3:
        for i in range(len(points)):
            gone = {(i + k) % len(points) for k in range(3)}
            yield replace(pair, points=tuple(point for k, point in enumerate(points) if k not in gone))
    if pair.exponent > 1:
        for k in sorted({pair.exponent // 2, pair.exponent - 1}):
            yield replace(pair, exponent=k)
    corner = tuple(min(point[axis] for point in points) for axis in range(2))
    if any(corner):
        yield replace(pair, points=tuple((x - corner[0], y - corner[1]) for x, y in points))
    for i, point in enumerate(points):
        for axis, x in enumerate(point):
            for y in sorted({0, x // 2, x - 1} - {x}) if x > 0 else ():
                moved = (y, point[1]) if axis == 0 else (point[0], y)
                yield replace(pair, points=(*points[:i], moved, *points[i + 1 :]))
