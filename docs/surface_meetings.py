"""``python -m docs.surface_meetings``: the pictures of two pages in docs/how-to/."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import exactspline as xs

PICTURES = Path(__file__).with_name("pictures")
#: Lines of constant parameters, and points along each.
LINES, PARTS = 13, 60
LIGHT, STRONG, DARK = "#9bb8d3", "#c44e52", "#333333"


def _points(surface: xs.NurbsSurface, places: list[tuple[Any, Any]]) -> list[list[float]]:
    """Coordinates of points, in three lists."""
    return [list(map(float, axis)) for axis in zip(*(surface(u, v) for u, v in places), strict=True)]


def _grid(ax: Any, surface: xs.NurbsSurface) -> None:
    """Lines of constant parameters."""
    (a, b), (c, d) = surface.domain
    for k in range(LINES):
        u, v = a + (b - a) * k / (LINES - 1), c + (d - c) * k / (LINES - 1)
        steps = range(PARTS + 1)
        ax.plot(*_points(surface, [(u, c + (d - c) * i / PARTS) for i in steps]), color=LIGHT, linewidth=0.7)
        ax.plot(*_points(surface, [(a + (b - a) * i / PARTS, v) for i in steps]), color=LIGHT, linewidth=0.7)


def _shown(ax: Any) -> None:
    """All of it, as large as it can be, in equal units."""
    ax.legend(loc="upper center")
    sides = [high - low for low, high in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
    ax.set_box_aspect(sides, zoom=1.25)


def _space(figure: Any, place: int, view: tuple[int, int]) -> Any:
    ax = figure.add_subplot(1, 2, place, projection="3d")
    ax.view_init(*view)
    ax.set_axis_off()
    return ax


def draw_nearest() -> None:
    """A surface from two sides, a point, and the nearest point of the surface."""
    import matplotlib.pyplot as plt

    surface, point = xs.example("bicubic"), (1, 2, 3)
    found = surface.nearest(point)
    foot = [float(x) for x in found.feet[0]]
    figure = plt.figure(figsize=(9, 4))
    for place, view in ((1, (18, -60)), (2, (5, 15))):
        ax = _space(figure, place, view)
        _grid(ax, surface)
        ax.plot(*zip(point, foot, strict=True), color=STRONG, linewidth=1.2)
        ax.plot(*([x] for x in point), "o", color=DARK, label="(1, 2, 3)")
        ax.plot(*([x] for x in foot), "o", color=STRONG, label=f"nearest point, {float(found):.6f} away")
        _shown(ax)
    figure.tight_layout()
    figure.savefig(PICTURES / "nearest.png", dpi=110)
    plt.close(figure)


def draw_ray() -> None:
    """A torus with a ray and its hits, and the section of a plane."""
    import matplotlib.pyplot as plt

    torus, start, way = xs.example("torus"), (-5, 0, 0), (1, 0, 0)
    figure = plt.figure(figsize=(9, 4))
    ax = _space(figure, 1, (28, -65))
    _grid(ax, torus)
    ax.plot([start[0], 5], [0, 0], [0, 0], color=DARK, linewidth=1)
    hits = [
        [s + float(hit) * d for s, d in zip(start, way, strict=True)] for hit in torus.ray_intersections((*start, *way))
    ]
    ax.plot(*zip(*hits, strict=True), "o", color=STRONG, label="the ray y = z = 0 from x = −5: four hits")
    _shown(ax)
    ax = _space(figure, 2, (28, -30))
    _grid(ax, torus)
    for k, run in enumerate(torus.plane_section((1, 0, 0, "1/2")).sampled(80)):
        label = "the plane x = 1/2: two closed loops" if k == 0 else None
        ax.plot(*_points(torus, [(min(max(u, 0), 4), min(max(v, 0), 4)) for u, v in run]), color=STRONG, label=label)
    _shown(ax)
    figure.tight_layout()
    figure.savefig(PICTURES / "ray.png", dpi=110)
    plt.close(figure)


def draw() -> None:
    """Both pictures."""
    import matplotlib as mpl

    mpl.use("Agg")
    draw_nearest()
    draw_ray()


if __name__ == "__main__":
    draw()
