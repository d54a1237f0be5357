"""``list formulas``: the constructions and formulas that can be derived of a curve."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def formulas(out: Output) -> None:
    """List what can be derived of a curve: constructions with their variants, and formulas."""
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.constructions import all_constructions
    from exactspline.language.kinds import CURVE, PLANE, SPACE
    from exactspline.papers import all_formulas

    rows = [
        {"key": name, "name": name, "kind": "construction", "curve": c.curve, "variants": list(c.all_variants)}
        for name, c in all_constructions().items()
    ] + [
        {"key": f"formula {name}", "name": name, "kind": "formula", "curve": str(f.curve), "variants": []}
        for name, f in all_formulas().items()
        if f.kind in (CURVE, PLANE, SPACE)
    ]

    def sheets() -> list[Sheet]:
        made = Sheet("name", "what", "of a", "variants", prose=["variants"])
        for row in rows:
            kind = {"plane": "plane curve", "space": "space curve"}.get(str(row["curve"]), "curve")
            made.add_row(row["name"], row["kind"], kind, ", ".join(row["variants"]))
        return [made]

    out.give("derivable", lambda: rows, sheets)
