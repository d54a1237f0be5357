"""Lines of curvature for pictures: traced in floats by steps along the principal directions, evenly spaced.

Source: Jobard and Lefer, Creating evenly-spaced streamlines of arbitrary density, 1997.
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import product
from math import atan2, comb, cos, dist, hypot, inf, sin
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.bivariate.borders import Patch
from exactspline.display.plot.canvas import GREY, library
from exactspline.formulas.surfaces.by_forms import area_of_forms, minimality_of_forms, parabolic_of_forms
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.language.arguments import Operands
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.numbers.once import cached_property
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

    Floats = NDArray[numpy.float64]

#: Lists of tuples of numbers, row by row of a grid.
Rows = list[list[list[float]]]
#: Distance between lines and length of a step, as fractions of the size of the surface; the largest number of steps of
#: a line.
APART, STEP, MOST = 1 / 26, 1 / 400, 1200
#: The smallest number of steps of a line.
LEAST = 12
#: A line ends where it comes nearer to another one than this fraction of their distance.
NEAR = 0.55


class _Lists(NamedTuple):
    us: list[float]
    vs: list[float]
    points: Rows
    directions: tuple[Rows, Rows]


@dataclass
class Samples:
    """A surface on a grid: parameters and points patch by patch, the sign of K, and principal directions over the
    whole rectangle.
    """

    surface: NurbsSurface
    us: list[Floats]
    vs: list[Floats]
    points: dict[Patch, Floats]
    signs: dict[Patch, Floats]
    #: The grid lines of the rectangle, the points on it, and the two principal directions as doubled angles.
    grid: tuple[Floats, Floats]
    whole: Floats
    directions: tuple[Floats, Floats]

    @classmethod
    def of(cls, surface: NurbsSurface, grid: int, least: int) -> Samples:
        """The samples of a surface: about this many in each direction, at least this many per patch."""
        np: Any = library("numpy")
        counts = [max(least, -(-grid // n)) for n in surface.patches]
        ts = [
            [np.linspace(float(a), float(b), count + 1) for a, b in zip(mesh.breaks, mesh.breaks[1:], strict=False)]
            for mesh, count in zip(surface.meshes, counts, strict=True)
        ]
        forms = SurfaceForms(surface)
        jets = {key: [f.partial(*key) for f in (*surface.p, surface.w)] for key in _ORDERS}
        points, signs, derivatives = {}, {}, {}
        for patch in forms.patches:
            at = [np.linspace(0, 1, count + 1) for count in counts]
            values = {key: [_on_grid(f, patch, *at) for f in own] for key, own in jets.items()}
            derivatives[patch] = _quotients(np, values)
            points[patch] = derivatives[patch][0, 0]
            signs[patch] = _on_grid(forms.parabolic, patch, *at)
        rows, columns = surface.patches

        def assembled(which: Any) -> Any:
            """Arrays of the patches joined over the whole rectangle; on common borders the later patch's values."""
            lines = [
                np.concatenate([which((i, j))[:, : None if j == columns - 1 else -1] for j in range(columns)], axis=1)
                for i in range(rows)
            ]
            return np.concatenate([line[: None if i == rows - 1 else -1] for i, line in enumerate(lines)], axis=0)

        whole = {key: assembled(lambda patch, key=key: derivatives[patch][key]) for key in _ORDERS}
        us, vs = (np.concatenate([*[t[:-1] for t in own[:-1]], own[-1]]) for own in ts)
        return cls(surface, ts[0], ts[1], points, signs, (us, vs), whole[0, 0], _principal(np, whole))

    @cached_property
    def _lists(self) -> _Lists:
        """The grid lines, the points and the directions as lists, since single numbers are read faster from lists."""
        us, vs, points, first, second = (each.tolist() for each in (*self.grid, self.whole, *self.directions))
        return _Lists(us, vs, points, (first, second))

    def lifted(self, line: Floats) -> list[list[float]]:
        """Points on the surface for points of the rectangle."""
        return [self.point(u, v) for u, v in line.tolist()]

    def point(self, u: float, v: float) -> list[float]:
        """The point on the surface for a point of the rectangle."""
        return _between(self._lists.points, *self._cell(u, v))

    def _cell(self, u: float, v: float) -> tuple[int, int, float, float]:
        """The grid cell that contains a point, and the point's position in it."""
        us, vs = self._lists.us, self._lists.vs
        i, j = (min(max(bisect(own, t) - 1, 0), len(own) - 2) for t, own in ((u, us), (v, vs)))
        return i, j, (u - us[i]) / (us[i + 1] - us[i]), (v - vs[j]) / (vs[j + 1] - vs[j])

    def direction(self, family: int, u: float, v: float) -> tuple[float, float]:
        """A principal direction in the parameters, of length 1 or zero."""
        x, y = _between(self._lists.directions[family], *self._cell(u, v))
        if x * x + y * y < 1e-4:
            return 0.0, 0.0
        angle = atan2(y, x) / 2
        return cos(angle), sin(angle)

    def velocity(self, u: float, v: float, du: float, dv: float) -> float:
        """The approximate length on the surface of a step of the parameters."""
        e = 1e-3
        us, vs, p, _ = self._lists
        (a, b), (c, d) = ((own[0], own[-1]) for own in (us, vs))
        u, v = min(max(u, a), b - e * (b - a)), min(max(v, c), d - e * (d - c))
        i, j, _, _ = self._cell(u, v)
        along_u, along_v = du / (us[i + 1] - us[i]), dv / (vs[j + 1] - vs[j])
        corners = zip(p[i][j], p[i + 1][j], p[i][j + 1], strict=True)
        return hypot(*((x - o) * along_u + (y - o) * along_v for o, x, y in corners))


_ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))


def _on_grid(f: TensorSpline, patch: Patch, xs: Any, ys: Any) -> Any:
    """The values of a spline on a grid of one patch."""
    np: Any = library("numpy")
    if min(f.degree) < 0:
        return np.zeros((len(xs), len(ys)))
    net = np.array([[float(x) for x in row] for row in f.bezier_net(*patch)])
    left, right = (_bernstein(np, n, ts) for n, ts in zip(f.degree, (xs, ys), strict=True))
    return left @ net @ right.T


def _bernstein(np: Any, n: int, ts: Any) -> Any:
    return np.stack([comb(n, k) * ts**k * (1 - ts) ** (n - k) for k in range(n + 1)], axis=1)


def _quotients(np: Any, values: dict[tuple[int, int], list[Any]]) -> dict[tuple[int, int], Any]:
    """The derivatives of p/w to the second order, by Leibniz' rule."""
    derivatives: dict[tuple[int, int], Any] = {}
    w = {key: own[-1] for key, own in values.items()}
    for i, j in _ORDERS:
        own = np.stack(values[i, j][:-1], axis=-1)
        for (a, b), earlier in derivatives.items():
            if a <= i and b <= j:
                own = own - (comb(i, a) * comb(j, b) * w[i - a, j - b])[..., None] * earlier
        derivatives[i, j] = own / w[0, 0][..., None]
    return derivatives


def _principal(np: Any, s: dict[tuple[int, int], Any]) -> tuple[Any, Any]:
    """The two principal directions as doubled angles of (du, dv); zero where they are not determined."""
    by_u, by_v, *bent = (Vector(*np.moveaxis(s[key], -1, 0)) for key in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)))
    n = cross(by_u, by_v)
    length = np.sqrt(norm2(n))
    n = n.mapped(lambda x: x / np.where(length > 0, length, 1))
    e, f, g, ll, m, k = (dot(a, b) for a, b in ((by_u, by_u), (by_u, by_v), (by_v, by_v), *((b, n) for b in bent)))
    forms = Operands(E=e, F=f, G=g, L=ll, M=m, N=k)
    area = area_of_forms(forms)
    area = np.where(area > 0, area, 1)
    mean, gauss = minimality_of_forms(forms) / (2 * area), parabolic_of_forms(forms) / area
    gap = np.sqrt(np.maximum(mean * mean - gauss, 0))
    families = []
    for kappa in (mean + gap, mean - gap):
        # (L − κE) du + (M − κF) dv = 0 = (M − κF) du + (N − κG) dv: the larger row determines the direction
        first, second, third = ll - kappa * e, m - kappa * f, k - kappa * g
        by_first = np.abs(first) >= np.abs(third)
        du, dv = np.where(by_first, -second, -third), np.where(by_first, first, second)
        angle = 2 * np.arctan2(dv, du)
        sure = (gap > 1e-9 * (np.abs(mean) + gap)) & (length > 0)
        families.append(np.stack([np.cos(angle) * sure, np.sin(angle) * sure], axis=-1))
    return families[0], families[1]


def _between(rows: Rows, i: int, j: int, x: float, y: float) -> list[float]:
    """Bilinear interpolation in a cell."""
    corners = zip(rows[i][j], rows[i + 1][j], rows[i][j + 1], rows[i + 1][j + 1], strict=True)
    return [(a * (1 - x) + b * x) * (1 - y) + (c * (1 - x) + d * x) * y for a, b, c, d in corners]


#: The names of the two families, and their colours.
FAMILIES = {"lines of the larger curvature": GREY, "lines of the smaller curvature": "#ffffff"}


def lines_of_curvature(samples: Samples) -> tuple[list[Floats], list[Floats]]:
    """The lines of both families (of the larger and of the smaller principal curvature, for the normal S_u × S_v) as
    points of the rectangle.
    """
    return _family(samples, 0), _family(samples, 1)


def _family(samples: Samples, family: int) -> list[Floats]:
    """Lines of one family, about equally far apart on the surface."""
    np: Any = library("numpy")
    flat = samples.whole.reshape(-1, 3)
    size = float(np.linalg.norm(flat.max(axis=0) - flat.min(axis=0)))
    us, vs, *_ = samples._lists
    seeds = [(us[i], vs[j]) for j in range(1, len(vs) - 1, 3) for i in range(1, len(us) - 1, 3)]
    # seeds from the middle outwards
    middle = (us[0] + us[-1]) / 2, (vs[0] + vs[-1]) / 2
    seeds.sort(
        key=lambda p: (p[0] - middle[0]) ** 2 / (us[-1] - us[0]) ** 2 + (p[1] - middle[1]) ** 2 / (vs[-1] - vs[0]) ** 2
    )
    near = _Neighbours(size * APART)
    lines = []
    for seed in seeds:
        if near.distance(samples.point(*seed)) < size * APART:
            continue
        first, closed = _half(samples, family, seed, 1.0, near, size)
        second, _ = ([], True) if closed else _half(samples, family, seed, -1.0, near, size)
        line = np.array([*second[::-1], seed, *first])
        if len(line) > LEAST:
            lines.append(line)
            near.add(samples.lifted(line))
    return lines


def _half(
    samples: Samples, family: int, seed: tuple[float, float], sign: float, near: _Neighbours, size: float
) -> tuple[list[tuple[float, float]], bool]:
    """A line from a seed to one side, until it leaves the rectangle, comes near another line, or returns to the seed:
    then it is closed.
    """
    (a, b), (c, d) = ((own[0], own[-1]) for own in samples._lists[:2])
    u, v = seed
    du, dv = samples.direction(family, u, v)
    last = (du * sign, dv * sign)
    points: list[tuple[float, float]] = []
    start = samples.point(u, v)
    for step in range(MOST):
        speed = samples.velocity(u, v, *last)
        length = size * STEP / speed if speed > 0 else 0.0
        length = min(length, (b - a) / 40, (d - c) / 40)
        middle = _turned(samples.direction(family, u + last[0] * length / 2, v + last[1] * length / 2), last)
        u, v = u + middle[0] * length, v + middle[1] * length
        if middle == (0.0, 0.0) or not (a <= u <= b and c <= v <= d):
            break
        points.append((u, v))
        point = samples.point(u, v)
        if step > LEAST and dist(point, start) < size * STEP:
            return [*points, seed], True
        if step % 4 == 3 and near.distance(point) < size * APART * NEAR:
            break
        last = _turned(samples.direction(family, u, v), middle)
        if last == (0.0, 0.0):
            break
    return points, False


def _turned(direction: tuple[float, float], last: tuple[float, float]) -> tuple[float, float]:
    """A direction or its opposite, whichever continues the line."""
    forward = direction[0] * last[0] + direction[1] * last[1] >= 0
    return direction if forward else (-direction[0], -direction[1])


class _Neighbours:
    """Points in space, indexed by cells of one size."""

    def __init__(self, size: float) -> None:
        self.size = size
        self.cells: dict[tuple[int, ...], list[list[float]]] = {}

    def _key(self, point: list[float]) -> tuple[int, ...]:
        return tuple(int(x // self.size) for x in point)

    def add(self, points: Iterable[list[float]]) -> None:
        """Keep points."""
        for point in points:
            self.cells.setdefault(self._key(point), []).append(point)

    def distance(self, point: list[float]) -> float:
        """The distance to the nearest point, if that is within one cell; otherwise infinite."""
        cells = product(*((i - 1, i, i + 1) for i in self._key(point)))
        return min((dist(point, other) for cell in cells for other in self.cells.get(cell, ())), default=inf)
