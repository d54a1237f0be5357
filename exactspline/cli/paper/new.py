"""``paper new``: a folder with a small working paper, to be edited."""

from __future__ import annotations

from typing import Annotated

from exactspline.cli.parameters import Argument


def new(folder: Annotated[str, Argument(help="The folder to write; it must not exist, or be empty.")]) -> None:
    """Write a small working paper: formulas.py, claims.toml, curves/ and README.md, with comments, to be edited."""
    from exactspline.display import console
    from exactspline.errors import command_name
    from exactspline.papers.new import write_new_paper

    written = write_new_paper(folder)
    shown = console.console()
    for file in written:
        console.lines(shown, str(file))
    console.lines(shown, f"Now: {command_name()} prove --paper {folder}")
