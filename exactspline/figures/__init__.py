"""The figures of the paper, in its layout; every number in a caption is counted on the objects that are drawn."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from exactspline.figures import plane
from exactspline.plot import PlotError, save

Maker = Callable[[], tuple[Any, str]]

#: The figures by number.
FIGURES: dict[int, Maker] = {1: plane.figure_1, 2: plane.figure_2, 3: plane.figure_3}


@dataclass
class Made:
    """A figure that was written: its caption and the files."""

    number: int
    caption: str
    files: list[str] = field(default_factory=list)


def folder(path: str | Path) -> Path:
    """The folder with this path, made if need be; `PlotError` where that cannot be done."""
    place = Path(path)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as reason:
        raise PlotError(f"cannot be made ({reason.strerror})", where=str(path), remedy="name a folder that can be written") from None
    return place


def make(number: int, folder: str | Path) -> Made:
    """Draw one figure and write it as SVG and PNG into a folder.

    Raises `PlotError` for a number that is no figure of the paper, without matplotlib, and where nothing can be written.
    """
    if number not in FIGURES:
        raise PlotError(f"the paper has no Figure {number}", where="figure", remedy=f"figures are {', '.join(map(str, FIGURES))}")
    figure, caption = FIGURES[number]()
    made = Made(number, caption)
    for suffix in ("svg", "png"):
        place = Path(folder) / f"figure{number}.{suffix}"
        save(figure, place)
        made.files.append(str(place))
    return made
