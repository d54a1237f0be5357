"""Draw the picture of docs/how-to/parts-of-an-offset.md: ``python -m docs.offsets``."""

from __future__ import annotations

from itertools import product
from math import atan2, cos, pi, sin
from pathlib import Path

import exactspline as xs
from exactspline.questions.answers import NamedNumbers

PICTURE = Path(__file__).with_name("pictures") / "offsets.png"
CORNERS = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4), (0, 0)]
DISTANCES = ("-1/2", "1/4", "7/10", "11/10")
#: The number of chords that are drawn for an arc.
PARTS = 40


def points_of(found: NamedNumbers, d: float) -> list[list[tuple[float, float]]]:
    """Return the points of one part of the offset at a distance d: of its lines, or of an arc around a corner."""
    values = {name: float(value) for name, value in found.values.items()}
    if "corner" in values:
        x, y = CORNERS[round(values["corner"])]
        a, b = (atan2(values[f"{end} y"] - y, values[f"{end} x"] - x) for end in ("start", "end"))
        angles = [a + ((b - a) % (2 * pi)) * k / PARTS for k in range(PARTS + 1)]
        return [[(x + abs(d) * cos(t), y + abs(d) * sin(t)) for t in angles]]
    drawn = []
    start, end = values["start"], values["end"]
    runs = [(start, end)] if start < end else [(start, 6), (0, end)]
    for k, (first, last) in product(range(6), runs):
        low, high = max(first, k), min(last, k + 1)
        if low < high:
            (a, b), (p, q) = CORNERS[k], CORNERS[k + 1]
            length = abs(p - a) + abs(q - b)
            normal = -(q - b) / length * d, (p - a) / length * d
            drawn.append([(a + (p - a) * (t - k) + normal[0], b + (q - b) * (t - k) + normal[1]) for t in (low, high)])
    return drawn


def draw() -> None:
    """Draw the outline, and the parts of its offsets."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    outline = xs.Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], CORNERS)
    figure, ax = plt.subplots(figsize=(6, 5.4))
    ax.plot(*zip(*CORNERS, strict=True), "k", label="outline")
    for i, d in enumerate(DISTANCES):
        drawn = [
            line for found in xs.ask(outline, f"offset_parts:{d}") for line in points_of(found, float(xs.rational(d)))
        ]
        for line in drawn:
            ax.plot(*zip(*line, strict=True), color=f"C{i}", label=f"d = {d}" if line is drawn[0] else None)
    ax.set_aspect("equal")
    ax.legend()
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    draw()
