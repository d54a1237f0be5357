"""The approaches to critical curvature on a curve: the cost and the result of each, as a table and as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from exactspline.display.numbers import decimal_milliseconds
from exactspline.display.plot.canvas import (
    BLACK,
    BLUE,
    GREEN,
    MARKS,
    PURPLE,
    VERMILLION,
    axes_for,
    draw_runs,
    legend_below,
)
from exactspline.display.plot.functions import draw_roots
from exactspline.display.tables import Grid
from exactspline.errors import as_items
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves.facts import among, located
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.numbers.exact import iroot, mpq
from exactspline.numbers.intervals import Side
from exactspline.one_line import OneLine
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import control_point_count
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colours and line styles of the forms, in order.
LINES = ((BLACK, "-"), (VERMILLION, "--"), (BLUE, "-."), (GREEN, ":"), (PURPLE, (0, (5, 1, 1, 1, 1, 1))))
#: Samples of every compared graph.
SAMPLES = 400


@dataclass(frozen=True, repr=False)
class ApproachResult(OneLine):
    """The cost and the result of one approach to critical curvature, by the name of its form.

    `extraneous` are roots at which κ′ neither vanishes nor changes its sign by a jump (those of κ that squaring
    adds for a plane curve, and singular points); `missing` are critical points that it does not find.
    """

    name: Variant
    degree: int
    control_points: int
    roots: int
    extraneous: int
    missing: int
    seconds: float


def compare_approaches(curve: Nurbs) -> list[ApproachResult]:
    """All approaches to critical curvature on one curve: squaring, the direct approach, its reduced form, and two more.
    Their results are compared exactly with those of the minimal form.

    >>> from exactspline.interchange.examples import example
    >>> [(str(a.name), a.degree, a.roots, a.extraneous) for a in compare_approaches(example("six_segment_cubic"))]
    [('direct', 6, 6, 0), ('squaring', 24, 8, 2), ('paper', 6, 6, 0), ('lifted', 6, 6, 0), ('minimal', 5, 6, 0)]
    """
    analysis = analyse(curve_of(curve))
    true = [root for root, _ in located(analysis.zero_form(analysis.critical_form).zeros)]
    expected = [f.root for f in analysis.critical_points]
    rows = []
    for variant in construction(analysis.critical_form).all_variants:
        form = analysis.zero_form(analysis.critical_form, variant)
        own = form.zeros.roots
        extraneous = among(own, true).count(False)
        missing = among(expected, [root for root, _ in located(form.zeros)]).count(False)
        rows.append(
            ApproachResult(
                variant, form.form.degree, control_point_count(form.form), len(own), extraneous, missing, form.seconds
            )
        )
    return rows


def approaches_table(curve: Nurbs) -> Grid:
    """The approaches to critical curvature side by side on one curve.

    >>> from exactspline.interchange.examples import example
    >>> approaches_table(example("six_segment_cubic"))["extraneous"]
    ['0', '2', '0', '0', '0']
    """
    rows = [
        (a.name, a.degree, a.control_points, a.roots, a.extraneous, a.missing, decimal_milliseconds(a.seconds))
        for a in compare_approaches(curve)
    ]
    return Grid(["approach", "degree", "control points", "roots", "extraneous", "missing", "ms"], rows, curve.name)


def plot_approaches(
    curve: Nurbs, ax: Axes | None = None, *, name: str = "critical_curvature", forms: Sequence[str] = ()
) -> Axes:
    """The forms in which a zero set can be computed, in one picture: each divided by its largest value and shown by its
    signed cube root.

    In this way their zeros and signs can be compared although their sizes differ by many powers of ten; the legend
    shows the cost of each.

    >>> from exactspline.interchange.examples import example
    >>> ax = plot_approaches(example("ellipse"))
    >>> [text.get_text() for text in ax.get_legend().get_texts()][1]
    'squaring: degree 96, 388 control points'

    Raises `FormulaError` for an unknown construction or form, `ShapeError` for a curve of the wrong dimension,
    otherwise as `plot_function`.
    """
    made, curve = construction(name), curve_of(curve)
    ax = axes_for(ax)
    ax.axhline(0, color=BLACK, linewidth=0.8, zorder=1)
    for i, variant in enumerate(list(as_items(forms, "names of forms")) or made.all_variants):
        solved = analyse(curve).zero_form(name, variant)
        f = solved.form
        color, dashes = LINES[i % len(LINES)]
        label = f"{variant}: degree {f.degree}, {control_point_count(f)} control points"
        draw_runs(ax, _normalized(f), label, color=color, linestyle=dashes, linewidth=1.6, zorder=3 + i)
    draw_roots(ax, solved.zeros, f.domain, *MARKS[0])
    ax.set_xlabel("parameter")
    ax.set_ylabel("∛(value / largest)")
    legend_below(ax, columns=1)
    return ax


def _normalized(f: BSpline) -> list[list[tuple[mpq, mpq]]]:
    """The graph segment by segment, values divided by the largest, and their cube roots (to twelve digits: a
    picture).
    """
    runs = []
    for a, b in pairwise(f.breakpoints):
        count = max(8, SAMPLES // len(f.mesh))
        ts = [a + (b - a) * mpq(k, count) for k in range(count + 1)]
        runs.append([(t, f(t, Side.LEFT if t == b else Side.RIGHT)) for t in ts])
    largest = max((abs(y) for run in runs for _, y in run), default=mpq(0)) or mpq(1)
    return [[(t, _cube_root(y / largest)) for t, y in run] for run in runs]


def _cube_root(y: mpq) -> mpq:
    root = mpq(iroot(int(abs(y) * 10**36), 3)[0], 10**12)
    return -root if y < 0 else root
