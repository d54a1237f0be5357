"""``exactspline curves``: the example curves and surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def curves(
    out: Output,
    surfaces: Annotated[bool, typer.Option("--surfaces", help="List the example surfaces instead.")] = False,
) -> None:
    """List the named example curves, or surfaces."""
    if surfaces:
        _surfaces(out)
        return
    from exactspline.display.sheet import Sheet
    from exactspline.interchange.examples import example, example_names

    found = [example(name) for name in example_names()]
    rows = [
        {
            "key": c.name,
            "name": c.name,
            "degree": c.degree,
            "dimension": c.dimension,
            "polynomial": c.polynomial,
            "segments": c.segments,
            "control_points": len(c.control_points),
            "note": c.note,
        }
        for c in found
    ]

    def sheets() -> list[Sheet]:
        numbers = ("degree", "segments", "points", "dimension")
        made = Sheet("name", "kind", *numbers, "note", numbers=numbers, prose=["note"])
        for c in found:
            kind = "polynomial" if c.polynomial else "rational"
            made.add_row(c.name, kind, c.degree, c.segments, len(c.control_points), c.dimension, c.note)
        return [made]

    out.give("curves", lambda: rows, sheets)


def _surfaces(out: Output) -> None:
    """The example surfaces."""
    from exactspline.display.sheet import Sheet
    from exactspline.interchange.examples import example_surface, example_surface_names

    found = [example_surface(name) for name in example_surface_names()]
    rows = [
        {
            "key": s.name,
            "name": s.name,
            "degree": list(s.degree),
            "dimension": s.dimension,
            "polynomial": s.polynomial,
            "patches": list(s.patches),
            "note": s.note,
        }
        for s in found
    ]

    def sheets() -> list[Sheet]:
        made = Sheet("name", "kind", "degree", "patches", "dimension", "note", numbers=["dimension"], prose=["note"])
        for s in found:
            kind = "polynomial" if s.polynomial else "rational"
            made.add_row(s.name, kind, *(f"{m} × {n}" for m, n in (s.degree, s.patches)), s.dimension, s.note)
        return [made]

    out.give("surfaces", lambda: rows, sheets)
