"""``python -m docs.bounds_and_edges``: the pictures of how-curved-at-most and how-two-edges-meet in docs/how-to/."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import exactspline as xs

PICTURES = Path(__file__).with_name("pictures")
#: Points along a curve, and lines of constant parameters of a surface.
PARTS, LINES = 200, 9
LIGHT, STRONG, DARK = "#9bb8d3", "#c44e52", "#333333"


def _points(curve: xs.Nurbs, low: Any, high: Any) -> tuple[list[float], list[list[float]]]:
    """Parameters between two, and the coordinates there."""
    steps = [xs.from_floats(float(low) + (float(high) - float(low)) * k / PARTS) for k in range(PARTS + 1)]
    inside = [min(max(t, curve.domain[0]), curve.domain[1]) for t in steps]
    return [*map(float, inside)], [list(map(float, axis)) for axis in zip(*map(curve, inside), strict=True)]


def draw_bounds() -> None:
    """A road, the part that is too curved, and the curvature."""
    import matplotlib.pyplot as plt

    road = xs.Nurbs(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0), (3, 0), (5, 1), (6, 4), (9, 5)])
    bound = xs.rational("3/10")
    _, *parts = xs.ask(road, f"curvature_at_most:{bound}")
    (tightest,) = road.largest_curvature
    place, largest = (float(tightest.values[name]) for name in ("parameter", "curvature"))
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
    places, points = _points(road, *road.domain)
    left.plot(*points, color=DARK)
    kappa = [abs(x) for x in road.floats(places, of="curvature")]
    right.plot(places, kappa, color=DARK, label="|κ|")
    right.axhline(float(bound), color=LIGHT, label="3/10")
    for part in parts:
        low, high = part.values["start"], part.values["end"]
        left.plot(*_points(road, low, high)[1], color=STRONG, linewidth=4, alpha=0.6, label="|κ| > 3/10")
        right.axvspan(float(low), float(high), color=STRONG, alpha=0.2)
    left.plot(*road.floats([place])[0], "o", color=DARK, label="the largest curvature")
    right.plot([place], [largest], "o", color=DARK)
    left.set_aspect("equal", adjustable="datalim")
    right.set_xlabel("parameter")
    for ax in (left, right):
        ax.legend()
    figure.tight_layout()
    figure.savefig(PICTURES / "bounds.png", dpi=110)


def draw_edges() -> None:
    """Two curves at an end, and two surfaces along a border."""
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(10, 4.4))
    ax = figure.add_subplot(1, 2, 1)
    line, arc = xs.Nurbs(1, [0, 0, 1, 1], [(1, -2), (1, 0)]), xs.example("circle").split(1)[0]
    for curve, color, name in ((line, DARK, "line: κ = 0"), (arc, STRONG, "arc: κ = 1")):
        ax.plot(*_points(curve, *curve.domain)[1], color=color, label=name)
    ax.plot([1], [0], "o", color=DARK)
    ax.annotate("gap 0, angle 0,\ncurvature jump 1", (1, 0), (-0.6, -0.9), arrowprops={"arrowstyle": "->"})
    ax.set_aspect("equal", adjustable="datalim")
    ax.legend(loc="upper left")
    space: Any = figure.add_subplot(1, 2, 2, projection="3d")
    flat = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
    twisted = [[(1, 1, 0), (1, 0, 0)], [(2, 1, 1), (2, 0, -1)]]
    for net, color in ((flat, LIGHT), (twisted, "#dd9a9d")):
        for k in range(LINES):
            t = k / (LINES - 1)
            for a, b in ((net[0], net[1]), ((net[0][0], net[1][0]), (net[0][1], net[1][1]))):
                ends = [[p + (q - p) * t for p, q in zip(*side, strict=True)] for side in (a, b)]
                space.plot(*zip(*ends, strict=True), color=color, linewidth=0.9)
    space.plot([1, 1], [0, 1], [0, 0], color=DARK, linewidth=2, label="crease")
    space.plot([1], [0.5], [0], "o", color=STRONG, label="one tangent plane")
    space.set_yticks([0, 1])
    space.view_init(24, -58)
    space.set_box_aspect((2, 1, 2), zoom=1.1)
    space.legend(loc="upper center")
    figure.tight_layout()
    figure.savefig(PICTURES / "edges.png", dpi=110)


def main() -> None:
    """Both pictures."""
    import matplotlib as mpl

    mpl.use("Agg")
    draw_bounds()
    draw_edges()


if __name__ == "__main__":
    main()
