"""``formula conditioning``: the forms of a zero set compared by condition number and errors in double precision."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from exactspline.cli.common import CURVE_HELP, described, loaded, tracked
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Exit, Option

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet

#: The default: a witness for each direction.
WITNESSES = ("conditioning_reduced_worse", "conditioning_reduced_better")


@printing
def conditioning(
    out: Output,
    curve: Annotated[
        list[str] | None, Argument(help=f"{CURVE_HELP} Without any, a witness for each direction.")
    ] = None,
    construction: Annotated[
        str, Option("--construction", metavar="NAME", help="zero_curvature or critical_curvature.")
    ] = "critical_curvature",
    search: Annotated[
        int, Option("--search", metavar="N", min=0, max=10_000, help="Search N random curves of each family too.")
    ] = 0,
    seed: Annotated[
        int, Option("--seed", metavar="N", help="The seed of the search: the same seed gives the same result.")
    ] = 0,
) -> None:
    """Condition numbers of every zero in every form: naive, paper, minimal; and the error of double precision in
    each.
    """
    from exactspline.verification.conditioning.compare import conditioning as compared
    from exactspline.verification.conditioning.search import search_witnesses

    chosen, good = loaded(curve or (() if search else WITNESSES))
    found = tracked([partial(compared, c, construction) for c in chosen], "comparing")
    (tallies,) = tracked([lambda: search_witnesses(seed, search)], "searching") if search else ([],)
    pairs = list(zip(chosen, found, strict=True))
    out.give(
        "conditioning",
        lambda: (
            [{"key": f"{e.curve}: {e.construction}", "what": "curve", "data": _data(e)} for e in found]
            + [
                {"key": f"search: {t.family}, {t.construction}, {t.form}", "what": "search", "data": _tally_data(t)}
                for t in tallies
            ]
        ),
        lambda: [*[_sheet(c, each) for c, each in pairs], *([_search_table(tallies)] if tallies else [])],
        lambda: _print(out, pairs, tallies),
    )
    if not good:
        raise Exit(2)


NUMBERS = ("degree", "condition", "minimal / this", "at most", "double error")


def _sheet(c: Any, each: Any) -> Sheet:
    from exactspline.display.sheet import Sheet

    title = f"{c.name}: {described(c)}; {each.construction}"
    made = Sheet("zero", "form", *NUMBERS, title=title, name=c.name, numbers=NUMBERS, heads=2)
    for row in each.roots:
        for f in row.forms:
            made.add_row(_place(row.root), f.form, *_cells(row, f))
    return made


def _print(out: Output, found: list[tuple[Any, Any]], tallies: list[Any]) -> None:
    from exactspline.display import console

    shown = console.console()
    for c, each in found:
        made = _sheet(c, each)
        if each.roots:
            shown.print(made)
        else:
            console.lines(shown, f"{c.name}: {each.construction} has no zero inside a segment")
        for form, verdict in each.verdicts.items():
            console.lines(shown, f"{form}: {verdict}")
        for form, roots in each.extraneous.items():
            console.lines(shown, f"{form} has extraneous zeros at {', '.join(map(_place, roots))} (not compared)")
        for text in each.left_out:
            console.lines(shown, f"left out: {text}")
        shown.print()
    if tallies:
        shown.print(_search_table(tallies))
    if found and not out.quiet:
        console.legend(shown, ["zero of a form", *NUMBERS])


def _cells(row: Any, f: Any) -> tuple[str, ...]:
    from exactspline.display.console import decimal

    double = f.double.reason if f.double.error is None else decimal(f.double.units, 3)
    growth = "" if f.growth is None else decimal(f.growth[1], 4)
    return str(f.degree), decimal(f.condition[0], 6), decimal(row.ratio(f.form), 4), growth, double


def _place(root: Any) -> str:
    from exactspline.display.console import decimal
    from exactspline.numbers.exact import text

    exact = "" if root.exact is None else text(root.exact)
    return exact if 0 < len(exact) < 12 else decimal(root.refine(12)[0], 8) + "…"


def _search_table(tallies: list[Any]) -> Sheet:
    from exactspline.display import console
    from exactspline.display.sheet import Sheet

    numbers = ("worse", "better", "proved not better", "smallest ratio", "largest ratio")
    columns = ("curves with", "construction", "against", *numbers)
    made = Sheet(*columns, title="Search: the reduced form is … conditioned", name="search", numbers=numbers, heads=3)
    for t in tallies:
        ratios = [console.decimal(extreme[0], 3) for extreme in (t.smallest, t.largest)]
        made.add_row(t.family, t.construction, t.form, t.worse, t.better, t.proved, *ratios)
    return made


def _data(each: Any) -> dict[str, object]:
    return {
        "curve": each.curve,
        "construction": each.construction,
        "zeros": [
            {"low": str(r.root.low), "high": str(r.root.high), "forms": [_form_data(f) for f in r.forms]}
            for r in each.roots
        ],
        "verdicts": each.verdicts,
        "extraneous": {
            form: [[str(end) for end in r.refine(20)] for r in roots] for form, roots in each.extraneous.items()
        },
        "left_out": list(each.left_out),
    }


def _form_data(f: Any) -> dict[str, object]:
    return {
        "form": f.form,
        "degree": f.degree,
        "multiplicity": f.multiplicity,
        "condition": [str(end) for end in f.condition],
        "factor_growth": f.growth and [str(end) for end in f.growth],
        "factor_of_one_sign": f.one_sign,
        "double_error": None if f.double.error is None else str(f.double.error),
        "double_reason": f.double.reason,
    }


def _tally_data(t: Any) -> dict[str, object]:
    from exactspline.interchange.curve_files import curve_data

    counts = {
        key: getattr(t, key)
        for key in ("family", "construction", "form", "worse", "better", "equal", "proved", "contradicted")
    }
    extremes = (("smallest", t.smallest), ("largest", t.largest))
    return counts | {key: {"ratio": str(ratio), "curve": curve_data(curve)} for key, (ratio, curve) in extremes}
