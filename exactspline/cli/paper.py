"""Papers: ``paper new``, ``paper figures``."""

from __future__ import annotations

from functools import partial

from exactspline.cli.output import Output, printing, tracked
from exactspline.display.sheet import Sheet


def new(folder: str) -> None:
    """Write a small working paper for you to edit: formulas.py, claims.toml, curves/ and README.md, with comments."""
    from exactspline.display import console
    from exactspline.errors import command_name
    from exactspline.papers.new import write_new_paper

    written = write_new_paper(folder)
    shown = console.console()
    for file in written:
        console.lines(shown, str(file))
    console.lines(shown, f"Now: {command_name()} prove --paper {folder}")


@printing
def figures(out: Output, folder: str, figure: list[int] | None = None) -> None:
    """Draw the figures of the paper of 2007 (SVG and PNG, surfaces also as interactive HTML). The numbers in the
    captions are computed.
    """
    from exactspline.display import figures as drawing

    numbers = figure or list(drawing.figures())
    place = drawing.folder(folder)
    made = tracked([partial(drawing.make, number, place) for number in numbers], "drawing")
    numbered = list(zip(numbers, made, strict=True))
    rows = [{"key": str(n)} | vars(m) for n, m in numbered]
    cells = [(n, m.caption, ", ".join(map(str, m.files))) for n, m in numbered]
    out.give("figures", rows, [Sheet("figure", "caption", "files", rows=cells, prose=["caption", "files"])])
