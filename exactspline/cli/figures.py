"""``figures``: the figures of the paper as files."""

from __future__ import annotations

from functools import partial
from typing import Annotated

import typer

from exactspline.cli.common import AsJson, print_json, tracked


def figures(
    out: Annotated[str, typer.Option("--out", help="The folder to write into; it is made when it is not there.")],
    figure: Annotated[
        list[int] | None,
        typer.Option("--figure", help="The number of a figure; may be repeated. All of them without it."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Draw the figures of the paper (SVG and PNG, surfaces also as HTML that turns); counts in captions come out of the
    objects.
    """
    from exactspline.display import console
    from exactspline.display.figures import FIGURES, folder, make

    place = folder(out)
    made = tracked([partial(make, number, place) for number in figure or FIGURES], "drawing")
    if as_json:
        print_json([vars(m) for m in made])
        return
    shown = console.console()
    for m in made:
        shown.print(m.caption, markup=False)
        shown.print(f"  {', '.join(m.files)}\n", markup=False, soft_wrap=True)
