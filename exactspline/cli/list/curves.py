"""``list curves``: the example curves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def curves(out: Output) -> None:
    """List the named example curves."""
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
