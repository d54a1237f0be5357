"""The visible parts of lines on a surface, for pictures: by a depth buffer."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from math import cos, radians, sin
from typing import TYPE_CHECKING, Any

from exactspline.display.plot.canvas import library

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Floats = NDArray[numpy.float64]

#: Cells of the buffer along the larger side, the most points that each face gives in each direction, and how far behind
#: the nearest point something may be (a part of the size).
CELLS, MOST, TOLERANCE = 160, 24, 0.03


class Visibility:
    """A surface as it is seen by parallel projection.

    >>> import numpy
    >>> wall = numpy.array([[[0.0, y, z] for z in numpy.linspace(0, 1, 30)] for y in numpy.linspace(0, 1, 30)])
    >>> seen = Visibility([wall], elevation=0, azimuth=0)  # from the side of positive x
    >>> seen.of([(0.5, 0.5, 0.5), (-0.5, 0.5, 0.5)])
    [True, False]
    """

    def __init__(self, patches: Iterable[Floats], elevation: float, azimuth: float) -> None:
        self.np: Any = library("numpy")
        e, a = radians(elevation), radians(azimuth)
        view = (cos(e) * cos(a), cos(e) * sin(a), sin(e))
        right, up = (-sin(a), cos(a), 0.0), (-sin(e) * cos(a), -sin(e) * sin(a), cos(e))
        self.frame = self.np.array([right, up, view]).T
        seen_patches = [patch @ self.frame for patch in patches]
        corners = self.np.concatenate([patch.reshape(-1, 3) for patch in seen_patches])
        self.low = corners.min(axis=0)
        extent = corners.max(axis=0) - self.low
        self.size = float(extent.max()) or 1.0
        #: The larger of its width and height as it is seen.
        self.seen = float(extent[:2].max()) or 1.0
        cell = self.size / CELLS
        points = self.np.concatenate([_dense(self.np, patch, cell).reshape(-1, 3) for patch in seen_patches])
        shape = (CELLS + 1, CELLS + 1)
        self.depth = self.np.full(shape, -self.np.inf)
        cells = self._cells(points)
        self.np.maximum.at(self.depth, (cells[:, 0], cells[:, 1]), points[:, 2])

    def _cells(self, points: Any) -> Any:
        cells = ((points[:, :2] - self.low[:2]) / self.size * CELLS).astype(int)
        return cells.clip(0, CELLS)

    def of(self, points: Floats | Sequence[Sequence[float]]) -> list[bool]:
        """Which of the points are seen."""
        seen_points = self.np.asarray(points, dtype=float) @ self.frame
        cells = self._cells(seen_points)
        seen: list[bool] = (seen_points[:, 2] >= self.depth[cells[:, 0], cells[:, 1]] - TOLERANCE * self.size).tolist()
        return seen

    def runs(self, points: Floats | Sequence[Sequence[float]]) -> Iterator[Floats]:
        """The parts of a line that are seen."""
        seen_points: Floats = self.np.asarray(points, dtype=float)
        start = 0
        for seen, run in groupby(self.of(seen_points)):
            count = len(list(run))
            if seen and count > 1:
                yield seen_points[start : start + count]
            start += count


def _dense(np: Any, patch: Any, cell: float) -> Any:
    """A grid of points with more of them between, by straight lines, so that neighbours are in neighbouring cells."""
    for axis in (0, 1):
        own = np.moveaxis(patch, axis, 0)
        steps = own[1:] - own[:-1]
        each = min(MOST, max(1, int(abs(steps).max() / cell * 1.5) + 1))
        parts = [own[:-1] + steps * (k / each) for k in range(each)]
        joined = np.stack(parts, axis=1).reshape(-1, *own.shape[1:])
        patch = np.moveaxis(np.concatenate([joined, own[-1:]]), 0, axis)
    return patch
