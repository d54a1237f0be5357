"""The picture: the ratio of a peer's time to ours, case by case, and the growth of ours."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill
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
#: The width for a telephone, in inches, and how many letters of the name of a case it holds.
NARROW, LETTERS = 4.4, 48
#: Up to this quotient of the largest and the smallest ratio the axis gets more labels.
SHORT = 500
#: The growth cases that are drawn: the beginning of the case, and the name of its axis.
DEGREES = "g2 by degree: "
AXES = {DEGREES: "degree", "g2 by segments: ": "segments", "g2 by bits: ": "bits of a coordinate"}


def draw(rows: Sequence[Row], path: str, *, narrow: bool = False) -> None:
    """Draw the rows into an SVG or PNG file; `narrow` for a telephone, with the names of the cases above their rows and
    the panels one below the other. Raises `PlotError`.
    """
    compared = [row for row in rows if row.ratio and row.section != "growth" and not row.case.startswith("constr")]
    grown = {begin: [row for row in rows if row.case.startswith(begin)] for begin in AXES}
    drawn = [begin for begin, group in grown.items() if group]
    cases = list(dict.fromkeys(row.case for row in compared))
    if not cases and not drawn:
        raise PlotError("there is no ratio to draw", remedy="measure a section with other libraries, or growth")
    grid, row = ((len(drawn), 1), 0.5) if narrow else ((1, len(drawn)), 1 / 3)
    heights = [height for height in (3 + row * len(cases) if cases else 0, 4 * grid[0] if drawn else 0) if height]
    figure = new_figure(NARROW if narrow else PAGE, sum(heights))
    parts = iter(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
    if cases:
        _ratios(next(parts).subplots(), compared, cases, narrow)
    if drawn:
        for axes, begin in zip(next(parts).subplots(*grid, squeeze=False).flat, drawn, strict=True):
            _growth(axes, grown[begin], begin)
    save(figure, path)


def _ratios(axes: Axes, rows: Sequence[Row], cases: Sequence[str], narrow: bool) -> None:
    for who, (marker, colour) in MARKS.items():
        measured = [row for row in rows if row.peer == who and row.ratio]
        if measured:
            times = [1 / row.ratio for row in measured if row.ratio]
            places = [-cases.index(row.case) for row in measured]
            axes.plot(times, places, marker, color=colour, label=who, markersize=7)
    axes.axvline(1, color=GREY, linewidth=1)
    axes.set_xscale("log")
    _label(axes, [1, *(1 / row.ratio for row in rows if row.ratio)])
    axes.set_yticks([-i for i in range(len(cases))], [""] * len(cases) if narrow else cases)
    for i, case in enumerate(cases if narrow else ()):
        axes.text(0.01, 0.18 - i, fill(case, LETTERS), transform=axes.get_yaxis_transform(), fontsize=8)
    axes.set_ylim(-len(cases) + 0.5, 0.8)
    axes.tick_params(axis="y", labelsize=9)
    axes.grid(axis="y", color=GREY, alpha=1 / 5)
    axes.set_xlabel("time of the other / ours (> 1: exactspline is faster)", fontsize=9 if narrow else None)
    if narrow:
        axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.06), ncols=2)
    else:
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
    axes.legend(fontsize=8, loc="lower right")
