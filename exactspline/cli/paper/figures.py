"""``paper figures``: the figures of the paper as files."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import tell_how_surfaces_are_drawn
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Option
from exactspline.cli.progress import tracked

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def figures(
    out: Output,
    folder: Annotated[
        str, Option("--out", metavar="FOLDER", help="The folder to write into; it is created if necessary.")
    ],
    figure: Annotated[
        list[int] | None,
        Option("--figure", metavar="N", help="The number of a figure; may be repeated. All of them without it."),
    ] = None,
) -> None:
    """Draw the figures of the paper (SVG and PNG, surfaces also as HTML that turns); counts in captions are computed
    from the objects.
    """
    from exactspline.display.figures import FIGURES, make
    from exactspline.display.figures import folder as made_folder
    from exactspline.display.sheet import Sheet

    place = made_folder(folder)
    made = tracked([partial(make, number, place) for number in figure or FIGURES], "drawing")
    if any(file.endswith(".html") for m in made for file in m.files):
        tell_how_surfaces_are_drawn()

    def sheets() -> list[Sheet]:
        sheet = Sheet("figure", "caption", "files", prose=["caption", "files"])
        for number, m in zip(figure or FIGURES, made, strict=True):
            sheet.add_row(number, m.caption, ", ".join(map(str, m.files)))
        return [sheet]

    rows = [{"key": str(n)} | vars(m) for n, m in zip(figure or FIGURES, made, strict=True)]
    out.give("figures", lambda: rows, sheets)
