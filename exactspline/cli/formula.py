"""Properties of formulas: ``formula degrees``, ``formula reduce``, ``formula conditioning``, ``identity``."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from exactspline.cli.common import also_in_their_planes, loaded
from exactspline.cli.output import Exit, Output, document, print_json, printing, tracked
from exactspline.display.sheet import Sheet
from exactspline.errors import ExactSplineError, FormulaError, ShapeError, nearest

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs
    from exactspline.verification.degree_tables import DegreeRow


# ---- degrees


@printing
def degrees(
    out: Output,
    name: list[str] | None = None,
    curve: list[str] | None = None,
    formulas: bool = False,
    generic: bool = False,
    at: int | None = None,
    certify: bool = False,
    patch: str = "",
    paper: list[str] | None = None,
    trust: bool = False,
    limit: int | None = None,
    as_latex: bool = False,
) -> None:
    """Print the nominal degree (in d), the represented degree, the true degree and the number of control points of
    every construction, in each variant: naive (without cancellation), paper, minimal, ….
    """
    from exactspline.verification.degree_tables import construction_table, formula_table

    if patch:
        _on_patches(out, paper or [], trust, name or [], patch)
        return
    if paper:
        _of_papers(out, paper, trust, name or [], curve, generic, limit)
        return
    if certify:
        _certify(curve)
        return
    if generic or at is not None:
        _generic(out, name or [], at)
        return
    chosen, good = loaded(curve or ["rational_cubic", "rational_space_cubic" if formulas else "six_segment_cubic"])
    make = formula_table if formulas else construction_table
    tables = [(c, tracked(make(c), c.name)) for c in also_in_their_planes(chosen)]
    _check_names(name or [], [row.formula for _, rows in tables for row in rows], elsewhere=_elsewhere(formulas))
    results = [(c, [row for row in rows if _is_one_of(row.formula, name or [])]) for c, rows in tables]
    _give(out, results)
    if not good:
        raise Exit(2)


def _of_papers(
    out: Output,
    paper: list[str],
    trust: bool,
    names: list[str],
    curve: list[str] | None,
    generic: bool,
    limit: int | None,
) -> None:
    """The formulas of papers, for all curves or on curves: those named, those in the folder, or examples."""
    from exactspline.display.formulas import formula_degree_sheet
    from exactspline.papers import named_papers
    from exactspline.verification.degree_tables import formula_degrees, formula_table
    from exactspline.verification.paper_curves import own_curves, refused_curves

    sources = named_papers(paper, trust=trust)
    formulas = [f for source in sources for f in source.formulas.values()]
    _check_names(names, [f.name for f in formulas])
    formulas = [f for f in formulas if _is_one_of(f.name, names)]
    if generic:
        rows = tracked(formula_degrees(formulas, limit), "degrees")
        out.give(
            "formula degrees",
            [{"key": f"{row.formula} ({row.curves})"} | vars(row) for row in rows],
            [formula_degree_sheet(rows)],
        )
        return
    given, good = loaded(curve or [])
    own = [c for source in sources for c in own_curves(source).values()]
    for error in [error for source in sources for error in refused_curves(source).values()]:
        raise error
    chosen = given if curve else own or loaded(["rational_cubic", "rational_space_cubic"])[0]
    tables = [(c, tracked(formula_table(c, formulas, limit), c.name)) for c in also_in_their_planes(chosen)]
    if good and not any(rows for _, rows in tables):
        names_of_curves = ", ".join(c.name for c, _ in tables)
        problem = f"none of these formulas applies to {names_of_curves}"
        raise FormulaError(problem, remedy="ask for all curves with --generic, for surfaces with --patch 3,3")
    _give(out, [(c, rows) for c, rows in tables if rows])
    if not good:
        raise Exit(2)


def _give(out: Output, tables: list[tuple[Nurbs, list[DegreeRow]]]) -> None:
    """The degrees of formulas on curves."""
    from exactspline.display.formulas import degree_sheet
    from exactspline.display.numbers import described

    out.give(
        "degrees",
        [
            {"key": f"{c.name} ({c.dimension}D): {row.formula}, {row.variant}", "curve": c.name} | row.data()
            for c, rows in tables
            for row in rows
        ],
        [degree_sheet(c, rows, f"{c.name}: {described(c)}") for c, rows in tables],
        by="curve",
    )


def _on_patches(out: Output, paper: list[str], trust: bool, names: list[str], patch: str) -> None:
    """The formulas of surfaces on patches of given degrees: counted, proved and attained."""
    from exactspline.display.formulas import patch_sheet
    from exactspline.papers import named_papers
    from exactspline.verification.degree_tables import patch_table

    parts = [part.strip() for part in patch.split(",")]
    if len(parts) != 2 or not all(part.isdecimal() and len(part) < 3 for part in parts):
        raise FormulaError(f"the degrees {patch!r}", where="--patch", remedy="write for example --patch 3,3")
    if not paper:
        raise FormulaError("no paper", where="--patch", remedy="name one with formulas of surfaces: --paper surfaces")
    formulas = [f for source in named_papers(paper, trust=trust) for f in source.formulas.values()]
    _check_names(names, [f.name for f in formulas])
    degrees = int(parts[0]), int(parts[1])
    rows = tracked(patch_table([f for f in formulas if not names or f.name in names], degrees), "degrees")
    out.give(
        "patch degrees",
        [{"key": f"{row.formula} ({row.patches})"} | vars(row) | {"agrees": row.agrees} for row in rows],
        [patch_sheet(rows, degrees)],
    )
    if not all(row.agrees for row in rows):
        raise Exit(1)


def _is_one_of(title: str, names: list[str]) -> bool:
    """Whether a row is selected: all are where no name is given."""
    return not names or any(_plain(title).startswith(_plain(name)) for name in names)


def _plain(name: str) -> str:
    return name.lower().replace("_", " ")


def _check_names(
    names: list[str], known: list[str], elsewhere: Mapping[str, Iterable[str]] = MappingProxyType({})
) -> None:
    """Raise `FormulaError` for a name without a row. The error says which other option shows the name: `elsewhere` maps
    each option to the names that it shows.
    """
    for name in names:
        if not any(_is_one_of(title, [name]) for title in known):
            options = [option for option, titles in elsewhere.items() if any(_is_one_of(x, [name]) for x in titles)]
            remedy = nearest(name, dict.fromkeys(known), listed_by="list formulas")
            raise FormulaError(f"the table has no {name!r}", remedy=f"add {options[0]}" if options else remedy)


def _elsewhere(everything: bool) -> dict[str, Iterable[str]]:
    """The names that other options show: the formulas, unless the table already has `everything`, and the objects that
    exist only in the table for all curves.
    """
    from exactspline.papers import all_formulas
    from exactspline.verification.degree_tables import BISECTORS, GENERATORS

    formulas: dict[str, Iterable[str]] = {} if everything else {"--formulas (on a curve)": all_formulas()}
    return {"--generic, or --at D": [*BISECTORS, *GENERATORS]} | formulas


def _certify(names: list[str] | None) -> None:
    """Certificates of all constructions on the curves, or on the witnesses of the generic curve."""
    from exactspline.geometry.derived.constructions import all_constructions, constructions_for
    from exactspline.verification.degree_tables import WITNESSES
    from exactspline.verification.generic_proof import attained, certificate

    if not names:
        tasks = [
            (name, d, polynomial) for name in all_constructions() for polynomial in (False, True) for d in WITNESSES
        ]
        found = tracked(
            [partial(attained, name, d, polynomial=polynomial) for name, d, polynomial in tasks], "witnesses"
        )
        keys = [f"{name} of a {'polynomial' if p else 'rational'} curve of degree {d}" for name, d, p in tasks]
        print_json(document("witnesses", [{"key": key} | vars(a) for key, a in zip(keys, found, strict=True)]))
        raise Exit(0 if all(a.agrees for a in found) else 1)
    chosen, good = loaded(names)
    rows = []
    for c in chosen:
        for made in constructions_for(c.dimension):
            head: dict[str, object] = {"key": f"{c.name}: {made.name}", "curve": c.name, "construction": made.name}
            try:
                rows.append(head | {"certificate": certificate(made.name, c), "missing": ""})
            except ShapeError as error:
                rows.append(head | {"certificate": None, "missing": str(error)})
    print_json(document("certificates", rows))
    if not good:
        raise Exit(2)


def _generic(out: Output, names: list[str], at: int | None) -> None:
    from exactspline.display.formulas import generic_sheet, sheet_at
    from exactspline.verification.degree_tables import generic_table

    found = {kind: tracked(generic_table(polynomial=kind == "polynomial"), kind) for kind in ("rational", "polynomial")}
    _check_names(names, [row.object for row in found["rational"]], elsewhere=_elsewhere(everything=False))
    kinds = {kind: [row for row in rows if _is_one_of(row.object, names)] for kind, rows in found.items()}
    headed = [({"key": f"{kind}: {row.object}", "curves": kind}, row) for kind, rows in kinds.items() for row in rows]
    if at is not None:
        rows = [head | {"d": at, "object": row.object} | row.at(at) for head, row in headed]
        out.give("degrees at", rows, [sheet_at(kind, rows, at) for kind, rows in kinds.items()], by="curves")
    else:
        rows = [head | vars(row) for head, row in headed]
        out.give("generic", rows, [generic_sheet(kind, rows) for kind, rows in kinds.items()], by="curves")
    if any(row.differ for rows in kinds.values() for row in rows):
        raise Exit(1)


# ---- reduce


@printing
def reduce(
    out: Output,
    name: str = "",
    dimension: int | None = None,
    polynomial: bool = False,
    everything: bool = False,
    trust: bool = False,
    limit: int | None = None,
) -> None:
    """Find the reduction of a formula: the factors with their meaning, the formula that remains, and the naive, nominal
    and true degrees.
    """
    from exactspline.display.formulas import explanations, reduction_rows, reduction_sheet
    from exactspline.language.formula import Formula
    from exactspline.language.kinds import TABLE
    from exactspline.papers import all_formulas
    from exactspline.polynomials.cost import within_seconds
    from exactspline.symbolic.reduction import reduce as reduction

    one = bool(name) and not everything
    chosen = (
        [_guarded(name, lambda: _formula(name, trust))]
        if one
        else [f for f in all_formulas().values() if f.kind is not TABLE and not f.kind.adjoins_roots]
    )
    calls = [
        partial(_guarded, name, partial(reduction, f, dimension=dimension, polynomial=polynomial, parameter=parameter))
        for f in chosen
        for parameter in (f.kind.counted if isinstance(f, Formula) and len(f.kind.counted) > 1 else (None,))
    ]
    with within_seconds(limit):
        found = tracked(calls, "reducing")
    sheet = reduction_sheet(found)
    out.give(
        "reduce", reduction_rows(found), [sheet], lambda: _print(out, sheet, [*explanations(found[0])] if one else [])
    )


def _formula(name: str, trust: bool) -> Any:
    """A formula of the library, of the folder of a paper, of a file, or a function of a module of the user."""
    from exactspline.papers import papers, resolve
    from exactspline.papers.loading import run_module

    place, colon, function = name.rpartition(":")
    is_module = place.replace(".", "").isidentifier() and not place.endswith(".py") and not Path(place).exists()
    if not colon or not is_module or any(place == each.name for each in papers()):
        return resolve(name, trust=trust)
    if not trust:
        raise FormulaError(
            "a module runs unchanged, any Python",
            where=name,
            remedy="add --trust for what you trust; file.py:function is checked before it runs",
        )
    sys.path.insert(0, str(Path.cwd()))
    if not callable(found := getattr(run_module(place), function, None)):
        raise FormulaError(
            f"{place} has no function {function!r}", where=name, remedy="write module:function or file.py:function"
        )
    return found


def _guarded(name: str, call: Any) -> Any:
    """Call code of the user: any exception in it becomes a `FormulaError`, which is printed in one line."""
    try:
        return call()
    except ExactSplineError:
        raise
    except (Exception, SystemExit) as error:
        problem = f"{type(error).__name__}: {' '.join(str(error).split())}"
        raise FormulaError(problem, where=name, remedy="a formula is a function of one curve c") from None


def _print(out: Output, sheet: Sheet, explained: list[str]) -> None:
    from exactspline.display import console

    shown = console.console()
    shown.print(sheet)
    if explained:
        shown.print()
    for line in explained:
        console.lines(shown, line)
    if not out.quiet:
        console.legend(shown, sheet.columns)


# ---- conditioning


#: The default: a curve on which the reduced form is worse conditioned than the others, and one on which it is better.
WITNESSES = ("conditioning_reduced_worse", "conditioning_reduced_better")


@printing
def conditioning(out: Output, curve: list[str] | None = None, construction: str = "critical_curvature") -> None:
    """Print the condition number of every zero of every variant of a construction, and the error of the zero in double
    precision.
    """
    from exactspline.display.formulas import comparison_data, comparison_sheet, print_comparisons
    from exactspline.verification.conditioning import conditioning as compared

    chosen, good = loaded(curve or WITNESSES)
    found = tracked([partial(compared, c, construction) for c in chosen], "comparing")
    pairs = list(zip(chosen, found, strict=True))
    out.give(
        "conditioning",
        [{"key": f"{e.curve}: {e.construction}", "what": "curve", "data": comparison_data(e)} for e in found],
        [comparison_sheet(c, each) for c, each in pairs],
        lambda: print_comparisons(pairs, quiet=out.quiet),
    )
    if not good:
        raise Exit(2)


# ---- identities


@printing
def identity(out: Output, text: str, trust: bool = False, limit: int | None = None) -> None:
    """Decide for all curves an identity between formulas, which may be your own. The exit status is 1 if the identity
    does not hold.
    """
    from exactspline.display import console
    from exactspline.display.evidence import words
    from exactspline.display.numbers import Numbers
    from exactspline.polynomials.cost import within_seconds
    from exactspline.verification.questions import proof_of

    with within_seconds(limit):
        found = proof_of(text, trust=trust)
    cells = (found.left, found.factor, found.right, found.verdict, str(found.quotient or "–"))
    made = Sheet("left", "factor", "right", "verdict", "quotient", rows=[cells])
    said = f"{found}; {words(found.counterexample, Numbers())}" if found.counterexample else str(found)
    out.give("identity", [found.data()], [made], lambda: console.lines(console.console(), said))
    if not found:
        raise Exit(1)
