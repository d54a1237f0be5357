"""``conditioning``: the forms of a zero set compared by condition number and by what double precision makes of them."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from exactspline.cli.common import AsJson, described, loaded, print_json, tracked

#: What is shown when nothing is asked for: a witness either way.
WITNESSES = ("conditioning_reduced_worse", "conditioning_reduced_better")


def conditioning(
    curve: Annotated[
        list[str] | None,
        typer.Argument(help="Curve files (JSON) or names of example curves; without any, a witness either way."),
    ] = None,
    construction: Annotated[
        str, typer.Option("--construction", help="zero_curvature or critical_curvature.")
    ] = "critical_curvature",
    as_json: AsJson = False,
    search: Annotated[
        int, typer.Option("--search", min=0, max=10_000, help="Search so many random curves of each family too.")
    ] = 0,
    seed: Annotated[int, typer.Option("--seed", help="What the search begins with: one seed, one result.")] = 0,
) -> None:
    """Condition numbers of every zero in every form: naive, paper, minimal; and the error of double precision in
    each.
    """
    from exactspline.verification.conditioning.compare import conditioning as compared
    from exactspline.verification.conditioning.search import search_witnesses

    chosen, good = loaded(curve or (() if search else WITNESSES))
    found = tracked([lambda c=c: compared(c, construction) for c in chosen], "comparing")
    (tallies,) = tracked([lambda: search_witnesses(seed, search)], "searching") if search else ([],)
    if as_json:
        print_json({"curves": [_data(each) for each in found], "search": [_tally_data(t) for t in tallies]})
    else:
        _print(list(zip(chosen, found, strict=True)), tallies)
    if not good:
        raise typer.Exit(2)


def _print(found: list[tuple[Any, Any]], tallies: list[Any]) -> None:
    from exactspline.display import console

    out = console.console()
    numbers = ("degree", "condition", "minimal / this", "at most", "double error")
    for c, each in found:
        made = console.table(
            "zero", "form", *numbers, title=f"{c.name}: {described(c)}; {each.construction}", right=numbers
        )
        for row in each.roots:
            for f in row.forms:
                made.add_row(_place(row.root) if f is row.forms[0] else "", f.form, *_cells(row, f))
        if each.roots:
            out.print(made)
        else:
            out.print(f"{c.name}: {each.construction} has no zero inside a segment", markup=False)
        for form, verdict in each.verdicts.items():
            out.print(f"{form}: {verdict}", markup=False)
        for form, roots in each.extraneous.items():
            out.print(f"{form} invents {', '.join(map(_place, roots))} (not compared)", markup=False)
        for text in each.left_out:
            out.print(f"left out: {text}", markup=False)
        out.print()
    if found:
        out.print("condition: relative change 2⁻⁵³ of the coefficients moves the zero by that many 2⁻⁵³ of the segment")
        out.print("at most: K of the theorem, condition ≤ K^(1/m) · minimal for a zero of multiplicity m")
        out.print("double error: in units of 2⁻⁵³ of the segment, coefficients rounded, de Casteljau and bisection")
    if tallies:
        out.print(_search_table(tallies))


def _cells(row: Any, f: Any) -> tuple[str, ...]:
    from exactspline.display.console import decimal

    double = f.double.reason if f.double.error is None else decimal(f.double.units, 3)
    growth = "" if f.growth is None else decimal(f.growth[1], 4)
    return str(f.degree), decimal(f.condition[0], 6), decimal(row.ratio(f.form), 4), growth, double


def _place(root: Any) -> str:
    from exactspline.display.console import decimal
    from exactspline.exact import text

    exact = "" if root.exact is None else text(root.exact)
    return exact if 0 < len(exact) < 12 else decimal(root.refine(12)[0], 8) + "…"


def _search_table(tallies: list[Any]) -> Any:
    from exactspline.display import console

    numbers = ("worse", "better", "proved not better", "smallest ratio", "largest ratio")
    made = console.table(
        "curves with",
        "construction",
        "against",
        *numbers,
        title="Search: the reduced form is … conditioned",
        right=numbers,
    )
    for t in tallies:
        ratios = [console.decimal(extreme[0], 3) for extreme in (t.smallest, t.largest)]
        made.add_row(t.family, t.construction, t.form, str(t.worse), str(t.better), str(t.proved), *ratios)
    return made


def _data(each: Any) -> dict[str, Any]:
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


def _form_data(f: Any) -> dict[str, Any]:
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


def _tally_data(t: Any) -> dict[str, Any]:
    from exactspline.splines.curve_files import curve_data

    counts = {
        key: getattr(t, key)
        for key in ("family", "construction", "form", "worse", "better", "equal", "proved", "contradicted")
    }
    extremes = (("smallest", t.smallest), ("largest", t.largest))
    return counts | {key: {"ratio": str(ratio), "curve": curve_data(curve)} for key, (ratio, curve) in extremes}
