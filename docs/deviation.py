"""Draw the picture of docs/how-to/how-far-is-this-approximation.md: ``python -m docs.deviation``."""

from __future__ import annotations

from pathlib import Path

import exactspline as xs

PICTURE = Path(__file__).with_name("pictures") / "deviation.png"
CORNERS = [(0, 0), (100, 200), (300, 180), (400, 0)]
#: The number of intervals of the parameter at whose ends the curves and the distances are drawn.
PARTS = 400


def draw() -> None:
    """Draw a cubic and its quadratic pieces; below, the distances of the points of the cubic from the pieces, and the
    proved bounds of the largest distance.
    """
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt
    from fontTools.cu2qu import curve_to_quadratic

    points = curve_to_quadratic(CORNERS, 1.0)
    n = len(points) - 2
    cubic = xs.Nurbs.bezier(CORNERS)
    pieces = xs.Nurbs(2, [0, 0, 0, *range(1, n), n, n, n], xs.from_floats(points))
    found = xs.ask((cubic, pieces), "deviation")[0].values
    figure, (above, below) = plt.subplots(2, 1, figsize=(8, 6), height_ratios=[3, 2])
    for curve, style, label in ((cubic, "-", "cubic"), (pieces, "--", "quadratic pieces")):
        a, b = map(float, curve.domain)
        above.plot(*curve.floats([a + (b - a) * k / PARTS for k in range(PARTS + 1)]).T, style, label=label)
    for curve, name in ((cubic, "at"), (pieces, "nearest")):
        above.plot(*curve.floats([float(found[name])]).T, "ko", markersize=4)
    above.set_aspect("equal", adjustable="datalim")
    above.legend()
    ts = [k / PARTS for k in range(PARTS + 1)]
    below.plot(
        ts, [float(xs.nearest(pieces, cubic(xs.rational(f"{k}/{PARTS}")))[0].distance) for k in range(PARTS + 1)]
    )
    low, high = (float(found[name]) for name in ("low", "high"))
    below.axhspan(low, high, color="tab:red", alpha=0.4, label=f"the largest is between {low:.5f} and {high:.5f}")
    below.set_xlabel("parameter of the cubic")
    below.set_ylabel("distance from the pieces")
    below.legend(loc="upper right", bbox_to_anchor=(1, 0.9))
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    draw()
