"""``list surfaces``: the example surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def surfaces(out: Output) -> None:
    """List the named example surfaces."""
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
