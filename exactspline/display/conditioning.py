"""Forms of a zero set compared by condition number: as tables and as data."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.display import console
from exactspline.display.data import picked, plain
from exactspline.display.described import described
from exactspline.display.numbers import decimal
from exactspline.display.sheet import Sheet
from exactspline.numbers.exact import text
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.conditioning.compare import Conditioning, FormAtRoot, RootConditions

#: The columns of numbers.
NUMBERS = ("degree", "condition", "minimal / this", "at most", "double error")


def comparison_sheet(c: Nurbs, each: Conditioning) -> Sheet:
    """Every form at every zero of a curve, one per row."""
    title = f"{c.name}: {described(c)}; {each.construction}"
    cells = [(_place(row.root), f.form, *_cells(row, f)) for row in each.roots for f in row.forms]
    return Sheet("zero", "form", *NUMBERS, rows=cells, title=title, name=c.name, numbers=NUMBERS, heads=2)


def print_comparisons(found: Sequence[tuple[Nurbs, Conditioning]], *, quiet: bool) -> None:
    """Print the tables, the verdicts and what was not compared."""
    shown = console.console()
    for c, each in found:
        if each.roots:
            shown.print(comparison_sheet(c, each))
        else:
            console.lines(shown, f"{c.name}: {each.construction} has no zero inside a segment")
        for form, verdict in each.verdicts.items():
            console.lines(shown, f"{form}: {verdict}")
        for form, roots in each.extraneous.items():
            console.lines(shown, f"{form} has extraneous zeros at {', '.join(map(_place, roots))} (not compared)")
        for what in each.skipped:
            console.lines(shown, f"skipped: {what}")
        shown.print()
    if found and not quiet:
        console.legend(shown, ["zero of a form", *NUMBERS])


def _cells(row: RootConditions, f: FormAtRoot) -> tuple[str, ...]:
    assert f.double is not None  # what is shown was computed with errors of doubles
    double = f.double.reason if f.double.units is None else decimal(f.double.units, 3)
    growth = "" if f.growth is None else decimal(f.growth[1], 4)
    return str(f.degree), decimal(f.condition[0], 6), decimal(row.ratio(f.form), 4), growth, double


def _place(root: Root) -> str:
    exact = "" if root.exact is None else text(root.exact)
    return exact if 0 < len(exact) < 12 else decimal(root.refine(12)[0], 8) + "…"


def comparison_data(each: Conditioning) -> dict[str, object]:
    """The comparison on a curve as data."""
    return {
        **picked(each, "curve", "construction"),
        "zeros": [picked(r.root, "low", "high") | {"forms": [_form_data(f) for f in r.forms]} for r in each.roots],
        "verdicts": each.verdicts,
        "extraneous": {form: [plain(r.refine(20)) for r in roots] for form, roots in each.extraneous.items()},
        "skipped": list(each.skipped),
    }


def _form_data(f: FormAtRoot) -> dict[str, object]:
    assert f.double is not None
    return {
        **picked(f, "form", "degree", "multiplicity", "condition"),
        "factor_growth": plain(f.growth),
        "factor_of_one_sign": f.one_sign,
        "double_error": None if f.double.error is None else str(f.double.error),
        "double_reason": f.double.reason,
    }
