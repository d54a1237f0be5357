"""Winding numbers as sums of angles, in doubles: a second opinion on a witness that shares no code with the judge, and
points worth judging.
"""

from __future__ import annotations

from math import comb
from typing import Any

from workshop.boolean.judge import Judgement, Operation
from workshop.boolean.pieces import Region

#: The chords of a piece, for a witness and where points are sought; points sought in each direction.
CHORDS, FEW, ROWS = 2000, 48, 24


def _chords(region: Region, count: int) -> tuple[Any, Any]:
    """The ends of the chords of all pieces, as complex numbers."""
    import numpy as np

    t = np.linspace(0, 1, count + 1)
    starts, ends = [np.zeros(0, complex)], [np.zeros(0, complex)]
    for piece in region.pieces:
        n = len(piece.points) - 1
        points: Any = sum(
            comb(n, i) * t**i * (1 - t) ** (n - i) * complex(float(x), float(y))
            for i, (x, y) in enumerate(piece.points)
        )
        starts.append(points[:-1])
        ends.append(points[1:])
    return np.concatenate(starts), np.concatenate(ends)


def windings(region: Region, points: Any, count: int = CHORDS) -> Any:
    """The sums of the angles under which chords of the paths are seen from points (complex numbers), divided by 2π and
    rounded.

    >>> windings(Region.of("M0 0H2V2H0Z"), [1 + 1j, 3 + 1j]).tolist()
    [1, 0]
    """
    import numpy as np

    starts, ends = _chords(region, count)
    from_here = np.asarray(points, complex)[:, None]
    with np.errstate(all="ignore"):
        angles = np.angle((ends - from_here) / (starts - from_here))
    return np.rint(np.nansum(angles, axis=1) / (2 * np.pi)).astype(int)


def _inside(region: Region, points: Any, count: int) -> Any:
    numbers = windings(region, points, count)
    return numbers % 2 == 1 if region.rule == "even-odd" else numbers != 0


def _wrong(points: Any, first: Region, second: Region, operation: Operation, result: Region, count: int) -> list[bool]:
    inside = (_inside(region, points, count).tolist() for region in (first, second, result))
    return [operation.holds(a, b) != c for a, b, c in zip(*inside, strict=True)]


def confirms(judgement: Judgement, first: Region, second: Region, operation: Operation, result: Region) -> bool:
    """Whether the sums of angles say the same of a witness: wrong there."""
    assert judgement.witness is not None
    [wrong] = _wrong([complex(*map(float, judgement.witness))], first, second, operation, result, CHORDS)
    return wrong


def suspects(first: Region, second: Region, operation: Operation, result: Region, within: float) -> list[complex]:
    """Points of a grid further than a distance from both paths at which a result seems to be wrong, those furthest from
    the paths first.
    """
    import numpy as np

    boxes = [piece.box for region in (first, second, result) for piece in region.pieces]
    if not boxes:
        return []
    left, low = (float(min(box[k] for box in boxes)) for k in (0, 2))
    right, high = (float(max(box[k] for box in boxes)) for k in (1, 3))
    # between the lines on which corners with integer coordinates lie
    steps = (np.arange(ROWS) + 0.57) / ROWS
    grid = (left + (right - left) * steps[:, None] + 1j * (low + (high - low) * steps[None, :])).ravel()
    ends = np.concatenate([_chords(region, FEW)[0] for region in (first, second)])
    distances = np.abs(grid[:, None] - ends[None, :]).min(axis=1)
    order = np.argsort(-distances)
    grid = grid[order][: int((distances > within).sum())]
    wrong = _wrong(grid, first, second, operation, result, FEW)
    return [complex(point) for point, bad in zip(grid, wrong, strict=True) if bad]


def farthest(first: Region, second: Region, result: Region) -> float:
    """About the largest distance of a point of a result from the paths of which it should consist."""
    import numpy as np

    sources = np.concatenate([_chords(region, CHORDS)[0] for region in (first, second)])
    points = _chords(result, FEW)[0]
    return float(max((np.abs(sources - point).min() for point in points), default=0.0))
