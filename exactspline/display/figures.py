"""The figures of a paper: the modules in its folder ``figures`` draw them, and this module writes them to files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from exactspline.atomic_write import write_text
from exactspline.display.plot.anything import picture
from exactspline.display.plot.canvas import PlotError, save
from exactspline.hooks import named
from exactspline.papers import default_papers


class Drawn(NamedTuple):
    """A figure, its caption, and its interactive scenes (none for plane figures)."""

    figure: Any
    caption: str
    scenes: tuple[object, ...] = ()


@cache
def figures() -> dict[int, Callable[[], Drawn]]:
    """The figures of the default papers by number.

    >>> list(figures())
    [1, 2, 3, 4, 5, 6]
    """
    drawing = [source for source in default_papers() if source.folder.joinpath("figures").is_dir()]
    return {n: draw for source in drawing for n, draw in named(f"{source.package}.figures:FIGURES").items()}


@dataclass
class _Made:
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


def make(
    number: int, folder: str | Path, drawn: Drawn | None = None, suffixes: Sequence[str] = ("svg", "png")
) -> _Made:
    """Draw one figure, unless it is given, and write it into a folder: as SVG and PNG, or as one of them, and its
    surfaces as an interactive page.

    Raises `PlotError` for a number that is not a figure of the paper, without matplotlib, and where the files cannot be
    written.
    """
    if number not in figures():
        remedy = f"figures are {', '.join(map(str, figures()))}"
        raise PlotError(f"the paper has no Figure {number}", where="figure", remedy=remedy)
    figure, caption, scenes = drawn or figures()[number]()
    made = _Made(number, caption)
    for suffix in suffixes:
        place = Path(folder) / f"figure{number}.{suffix}"
        save(figure, place)
        made.files.append(str(place))
    if scenes:
        place = Path(folder) / f"figure{number}.html"
        write_text(place, picture("page", scenes, caption), PlotError)
        made.files.append(str(place))
    return made
