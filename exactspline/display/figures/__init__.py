"""The figures of the paper, in its layout; every number in a caption is counted on the drawn objects."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from exactspline.atomic_write import write_text
from exactspline.display.figures.plane import Drawn, figure_1, figure_2, figure_3
from exactspline.display.plot.canvas import PlotError, save
from exactspline.display.plot.in_space import picture

#: The figures by number.
FIGURES: dict[int, Callable[[], Drawn]] = {
    **{1: figure_1, 2: figure_2, 3: figure_3},
    **{n: partial(picture, f"figure {n}") for n in (4, 5, 6)},
}


@dataclass
class Made:
    """A figure written to files: its caption and the files."""

    number: int
    caption: str
    files: list[str] = field(default_factory=list)


def folder(path: str | Path) -> Path:
    """The folder with this path, created if necessary; raises `PlotError` where that is impossible."""
    place = Path(path)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as reason:
        raise PlotError(
            f"cannot be made ({reason.strerror})", where=str(path), remedy="name a folder that can be written"
        ) from None
    return place


def make(number: int, folder: str | Path, drawn: Drawn | None = None, suffixes: Sequence[str] = ("svg", "png")) -> Made:
    """Draw one figure, where it is not given as drawn, and write it into a folder: as SVG and PNG, or one of them, and
    its surfaces as an interactive page.

    Raises `PlotError` for a number that is not a figure of the paper, without matplotlib, and where the files cannot be
    written.
    """
    if number not in FIGURES:
        raise PlotError(
            f"the paper has no Figure {number}", where="figure", remedy=f"figures are {', '.join(map(str, FIGURES))}"
        )
    figure, caption, scenes = drawn or FIGURES[number]()
    made = Made(number, caption)
    for suffix in suffixes:
        place = Path(folder) / f"figure{number}.{suffix}"
        save(figure, place)
        made.files.append(str(place))
    if scenes:
        place = Path(folder) / f"figure{number}.html"
        write_text(place, picture("page", scenes, caption), PlotError)
        made.files.append(str(place))
    return made
