"""Figures for narrow windows: their panels one below the other, so that letters are as large as in wide ones."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from matplotlib.gridspec import GridSpec
from matplotlib.transforms import IdentityTransform

from exactspline.display.plot.canvas import ENTRY, in_words, settle

#: The width of a picture for a telephone, in inches, and its dots per inch: it is shown about this large.
WIDTH, RESOLUTION = 4.4, 80
#: The room beside a panel, and that for a line of a legend.
BESIDE, LINE = 0.8, 0.2
#: Said in the file of such a picture, and the class that it has in a page.
NARROW = "narrow"


def narrowed(figure: Any) -> Any:
    """A copy of a figure that was drawn, as wide as a telephone."""
    copy = pickle.loads(pickle.dumps(figure))
    panels = [(ax, _height(now)) for ax, now in zip(copy.axes, figure.axes, strict=True) if ax.get_subplotspec()]
    heights = [height for _, height in panels]
    copy.set_size_inches(WIDTH, sum(heights) + LINE * sum(len(each.get_texts()) for each in copy.legends))
    below = GridSpec(len(panels), 1, figure=copy, height_ratios=heights)
    for i, (ax, _) in enumerate(panels):
        ax.set_subplotspec(below[i])
        if ax.get_legend():
            _broken(ax, ax.get_legend(), loc="upper center")
    for legend in copy.legends[:]:
        legend.remove()
        _broken(copy, legend, loc="outside lower center")
    return copy


def _broken(owner: Any, legend: Any, loc: str) -> None:
    """Give a legend under a panel or a figure no more columns than there is room for."""
    columns = min(legend._ncols, int(WIDTH / ENTRY))
    labels = [text.get_text() for text in legend.get_texts()]
    if _is_inside(legend):
        owner.legend(
            legend.legend_handles, labels, loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=2, fontsize="small"
        )
    elif columns < legend._ncols:
        made = owner.legend(legend.legend_handles, labels, loc=loc, ncols=columns, fontsize="small", frameon=False)
        if "outside" not in loc:
            made.set_bbox_to_anchor(legend.get_bbox_to_anchor(), IdentityTransform())


def _is_inside(legend: Any) -> bool:
    """Whether a legend stands in a panel, where matplotlib finds room: in a small one it would cover the curve."""
    return bool(legend._loc_real == 0)


def _height(ax: Any) -> float:
    """The height of a panel, with the words around it, that is as wide as a telephone and keeps its shape."""
    whole, inner = (box.size / ax.figure.dpi for box in (ax.get_tightbbox(), ax.get_window_extent()))
    grown = float(inner[1] * (WIDTH - BESIDE) / inner[0])
    legend = ax.get_legend()
    added = 0
    if legend and (_is_inside(legend) or legend._ncols > WIDTH / ENTRY):
        added = len(legend.get_texts()) // (2 if _is_inside(legend) else 4)
    return float(whole[1] - inner[1]) + grown + LINE * added


@contextmanager
def saved(seen: Callable[[Any, Any], None]) -> Iterator[None]:
    """Be notified of each figure that is saved, and where to; not of those that are saved thereupon."""
    plain = Figure.savefig

    def savefig(figure: Figure, target: Any, **options: Any) -> None:
        plain(figure, target, **options)
        Figure.savefig = plain
        seen(figure, target)
        Figure.savefig = savefig

    Figure.savefig = savefig
    yield
    Figure.savefig = plain


def beside(file: Path) -> Path:
    """The file with the same picture for narrow windows."""
    return file.with_name(f"{file.stem}-{NARROW}.png")


def png(figure: Any) -> bytes:
    """Such a picture as a file, which says what is to be seen and for what window it is."""
    settle(figure)
    stream = BytesIO()
    said = {"Description": in_words(figure), "Title": NARROW}
    figure.savefig(stream, format="png", dpi=RESOLUTION, metadata=said)
    return stream.getvalue()
