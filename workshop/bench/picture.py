"""The picture: the ratio of a peer's time to ours, case by case, and the growth of ours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from exactspline.display.plot.canvas import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PAGE,
    PURPLE,
    SKY,
    VERMILLION,
    PlotError,
    new_figure,
    save,
)
from workshop.bench.row import OURS, Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Marker and colour of each peer.
MARKS = {
    "python-flint inline": ("D", BLUE),
    "python-flint": ("d", SKY),
    "sympy": ("o", VERMILLION),
    "sympy inline": (".", VERMILLION),
    "sympy on FLINT": ("s", ORANGE),
    "sympy on FLINT inline": ("x", ORANGE),
    "PARI": ("^", GREEN),
    "Fraction": ("v", GREY),
    "pynurbs": ("P", PURPLE),
    "Open CASCADE": ("*", "#000000"),
    "geomdl": ("<", PURPLE),
    "scipy": (">", SKY),
}
#: Up to this quotient of the largest and the smallest ratio the axis gets more labels.
SHORT = 500
#: The growth cases that are drawn: the beginning of the case, and the name of its axis.
DEGREES = "g2 by degree: "
AXES = {DEGREES: "degree", "g2 by segments: ": "segments", "g2 by bits: ": "bits of a coordinate"}


def draw(rows: Sequence[Row], path: str) -> None:
    """Draw the rows into an SVG or PNG file. Raises `PlotError`."""
    compared = [row for row in rows if row.ratio and row.section != "growth" and not row.case.startswith("constr")]
    grown = {begin: [row for row in rows if row.case.startswith(begin)] for begin in AXES}
    drawn = [begin for begin, group in grown.items() if group]
    cases = list(dict.fromkeys(row.case for row in compared))
    if not cases and not drawn:
        raise PlotError("there is no ratio to draw", remedy="measure a section with other libraries, or growth")
    heights = [height for height in (3 + len(cases) / 3 if cases else 0, 4 if drawn else 0) if height]
    figure = new_figure(PAGE, sum(heights))
    parts = iter(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
    if cases:
        _ratios(next(parts).subplots(), compared, cases)
    if drawn:
        for axes, begin in zip(next(parts).subplots(1, len(drawn), squeeze=False)[0], drawn, strict=True):
            _growth(axes, grown[begin], begin)
    save(figure, path)


def _ratios(axes: Axes, rows: Sequence[Row], cases: Sequence[str]) -> None:
    for who, (marker, colour) in MARKS.items():
        measured = [row for row in rows if row.peer == who and row.ratio]
        if measured:
            times = [1 / row.ratio for row in measured if row.ratio]
            places = [-cases.index(row.case) for row in measured]
            axes.plot(times, places, marker, color=colour, label=who, markersize=7)
    axes.axvline(1, color=GREY, linewidth=1)
    axes.set_xscale("log")
    _label(axes, [1, *(1 / row.ratio for row in rows if row.ratio)])
    axes.set_yticks([-i for i in range(len(cases))], cases)
    axes.tick_params(axis="y", labelsize=9)
    axes.grid(axis="y", color=GREY, alpha=1 / 5)
    axes.set_xlabel("time of the other / ours (> 1: exactspline is faster)")
    axes.legend(fontsize=9, loc="upper right", bbox_to_anchor=(1, -0.1), ncols=4)


def _label(axes: Axes, ratios: Sequence[float]) -> None:
    """Plain numbers on the axis of ratios: powers of ten, for a small range also twice and five times these."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    steps = (1, 2, 5) if max(ratios) < SHORT * min(ratios) else (1,)
    axes.xaxis.set_major_locator(LogLocator(subs=steps, numticks=20))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())


def _growth(axes: Axes, rows: Sequence[Row], begin: str) -> None:
    for who, (marker, colour) in {OURS: ("o", BLUE), "python-flint inline": ("D", GREY)}.items():
        measured = [(int(row.case.removeprefix(begin)), row.value) for row in rows if row.peer == who and row.value]
        sizes, times = [size for size, _ in measured], [value for _, value in measured]
        axes.plot(sizes, times, marker=marker, color=colour, label=who, markersize=5)
    if begin != DEGREES:
        axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(AXES[begin])
    axes.set_ylabel("g2, ms")
    axes.legend(fontsize=8, loc="upper left")
