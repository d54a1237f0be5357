"""Winding numbers as sums of angles, in doubles: a second opinion on a witness that shares no code with the judge."""

from __future__ import annotations

from math import atan2, comb, pi

from workshop.boolean.judge import Judgement, Operation
from workshop.boolean.pieces import Region

#: The chords of a piece.
CHORDS = 2000


def winding(region: Region, x: float, y: float) -> int:
    """The sum of the angles under which chords of the paths are seen, divided by 2π and rounded.

    >>> winding(Region.of("M0 0H2V2H0Z"), 1, 1)
    1
    """
    total = 0.0
    for piece in region.pieces:
        points = [(float(a), float(b)) for a, b in piece.points]
        n = len(points) - 1
        before = None
        for k in range(CHORDS + 1):
            t = k / CHORDS
            weights = [comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)]
            dx = sum(w * a for w, (a, _) in zip(weights, points, strict=True)) - x
            dy = sum(w * b for w, (_, b) in zip(weights, points, strict=True)) - y
            if before is not None:
                total += atan2(before[0] * dy - before[1] * dx, before[0] * dx + before[1] * dy)
            before = dx, dy
    return round(total / (2 * pi))


def confirms(judgement: Judgement, first: Region, second: Region, operation: Operation, result: Region) -> bool:
    """Whether the sums of angles say the same of a witness: wrong there."""
    assert judgement.witness is not None
    x, y = map(float, judgement.witness)

    def inside(region: Region) -> bool:
        number = winding(region, x, y)
        return number % 2 == 1 if region.rule == "even-odd" else number != 0

    return operation.holds(inside(first), inside(second)) != inside(result)
