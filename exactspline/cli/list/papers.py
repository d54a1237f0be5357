"""``list papers``: the papers that come along."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def papers(out: Output) -> None:
    """List the papers whose formulas and claims come along."""
    from exactspline.display.sheet import Sheet
    from exactspline.papers import papers as found
    from exactspline.verification.claims import claims_of

    rows = [
        {"key": p.name, "title": p.title, "formulas": len(p.formulas), "claims": len(claims_of(p))} for p in found()
    ]

    def sheets() -> list[Sheet]:
        made = Sheet("name", "title", "formulas", "claims", numbers=["formulas", "claims"], prose=["title"])
        for row in rows:
            made.add_row(*row.values())
        return [made]

    out.give("papers", lambda: rows, sheets)
