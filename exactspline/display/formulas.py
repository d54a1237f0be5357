"""Tables and data of formulas: their degrees (an object that vanishes or does not exist is marked by a word, not by a
number), and the results of factoring them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from exactspline.display import console
from exactspline.display.forms import picked, plain
from exactspline.display.numbers import decimal, described
from exactspline.display.sheet import Sheet
from exactspline.language.kinds import PAIR, PLANE_PAIR
from exactspline.language.surface_kind import BOTH
from exactspline.numbers.exact import text
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs
from exactspline.symbolic.reduction import Part, Reduction
from exactspline.verification.conditioning import Conditioning, FormAtRoot, RootConditions
from exactspline.verification.degree_tables import DegreeRow, FormulaDegrees, GenericRow, PatchRow

NOTHING, ZERO = "–", "zero"


def degree_sheet(curve: Nurbs, rows: Iterable[DegreeRow], title: str = "") -> Sheet:
    """The degrees and sizes of constructions or formulas on a curve.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.verification.degree_tables import construction_table
    >>> line = example("straight_line")
    >>> rows = degree_sheet(line, [call() for call in construction_table(line)]).rows
    >>> [row[5] for row in rows if row[0] == "zero_curvature"]
    ['zero', 'zero', 'zero', 'zero']
    """
    numbers = ("nominal", "k, m, j", "degree", "true", "points", "generic")
    columns, cells = ("formula", "variant", *numbers, "meaning"), map(_cells, rows)
    return Sheet(*columns, rows=cells, title=title, name=curve.name, numbers=numbers, prose=["meaning"], heads=2)


def _cells(row: DegreeRow) -> tuple[object, ...]:
    text = row.text
    if row.true is None and row.represented is not None and row.represented >= 0:
        text += "; does not exist on a whole segment, as the minimal form shows"
    counts = (row.nominal, row.grading, _degree(row), _true(row), row.control_points or NOTHING, row.generic)
    return row.formula, row.variant, *counts, text


def formula_degree_sheet(rows: Iterable[FormulaDegrees]) -> Sheet:
    """The proved degrees of formulas on the generic curve of degree d."""
    numbers = ("nominal", "reduced", "in lowest terms")
    columns = ("formula", "curves", "nominal", "cancelled", *numbers[1:])
    cells = [(row.formula, row.curves, row.nominal, row.cancelled, row.reduced, row.lowest) for row in rows]
    return Sheet(*columns, rows=cells, title="Formulas on the generic curve of degree d", numbers=numbers, heads=2)


def patch_sheet(rows: Sequence[PatchRow], degrees: tuple[int, int]) -> Sheet:
    """Formulas of surfaces on patches of one bidegree."""
    numbers = ("nominal", "reduced", "attained")
    title = f"Formulas on patches of degree {degrees[0]} × {degrees[1]}"
    remark = ["unknown because"] if any(row.missing for row in rows) else []
    cells = [
        (row.formula, row.patches, _pair(row.naive), NOTHING, NOTHING, row.missing)
        if row.missing
        else (row.formula, row.patches, _pair(row.naive), _pair(row.true), _pair(row.attained))
        for row in rows
    ]
    columns = ("formula", "patches", *numbers, *remark)
    return Sheet(*columns, rows=cells, title=title, numbers=numbers, prose=remark, heads=2)


def _pair(degrees: tuple[int, int] | None) -> str:
    return ZERO if degrees is None else f"{degrees[0]} × {degrees[1]}"


def _degree(row: DegreeRow) -> str:
    if row.represented is None or (row.represented < 0 and row.true is None):
        return NOTHING
    return ZERO if row.represented < 0 else str(row.represented)


def _true(row: DegreeRow) -> str:
    return NOTHING if row.true is None else ZERO if row.true < 0 else str(row.true)


def generic_sheet(kind: str, rows: Iterable[GenericRow]) -> Sheet:
    """The proved degrees on the generic curve of degree d."""
    numbers = ("naive", "paper", "k", "m", "kd − m", "j", "true")
    cells = [
        (row.object, row.naive, row.paper, row.k, row.m, row.nominal, row.j, row.true, _attained_at(row))
        for row in rows
    ]
    columns, title = ("construction", *numbers, "attained at d"), f"The generic {kind} curve of degree d"
    return Sheet(*columns, rows=cells, title=title, name=kind, numbers=numbers)


def sheet_at(kind: str, rows: Iterable[GenericRow], d: int) -> Sheet:
    """The proved degrees on the generic curve of one degree."""
    numbers = ("naive", "paper", "true")
    title = f"The generic {kind} curve of degree {d}"
    made = Sheet("construction", *numbers, title=title, name=kind, numbers=numbers)
    for row in rows:
        degrees = row.at(d)
        made.add_row(row.object, *(NOTHING if degrees[name] is None else degrees[name] for name in numbers))
    return made


def _attained_at(row: GenericRow) -> str:
    """The degrees d at which a witness attains the true degree, with the degrees at which the object does not exist or
    vanishes, and the degrees at which proof and witness disagree.
    """
    absent = f"; absent at {', '.join(map(str, row.absent))}" if row.absent else ""
    differ = f"; DIFFERS at {', '.join(map(str, row.differ))}" if row.differ else ""
    return ", ".join(map(str, row.attained)) + absent + differ


def reduction_rows(reductions: Iterable[Reduction]) -> list[dict[str, object]]:
    """The reductions as data, one row per part; a ruled surface has two parts."""
    return [
        {"key": f"{_label(r, part, always=True)}", "formula": r.name, "dimension": r.dimension}
        | {"polynomial": r.polynomial}
        | part.data()
        for r in reductions
        for part in r.parts
    ]


def _label(r: Reduction, part: Part, *, always: bool = False) -> str:
    """The label of a row: its formula, with its part and the parameter of its degrees if there are several."""
    words = [f"{r.name} in R{r.dimension}" if always else r.name]
    words += [part.role] if always or len(r.parts) > 1 else []
    words += (
        [f"in {part.parameter}"] if len(r.kind.parameters(r.dimension)) > 1 and r.kind not in (PAIR, PLANE_PAIR) else []
    )
    return ", ".join(words)


def reduction_sheet(reductions: Iterable[Reduction]) -> Sheet:
    """The reductions as a table, one row per part.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.reduction import reduce
    >>> reduction_sheet([reduce(find("g0"))]).rows[0][:2]
    ('g0', '1/2·w⁻⁸')
    """
    numbers = ("naive", "k, m, j", "nominal", "numerator", "in lowest terms")
    cells = [_of_part(_label(r, part), part) for r in reductions for part in r.parts]
    return Sheet("formula", "factors cancelled", "reduced form", *numbers, rows=cells, numbers=numbers)


def _of_part(label: str, part: Part) -> tuple[object, ...]:
    row = part.data()
    grading = f"{row['k']}, {row['m']}, {row['j']}" if row["k"] is not None else "–"
    reduced = part.text + (f", poles at {row['poles']} = 0" if row["poles"] else "")
    degrees = (row["naive"], grading, row["nominal"] or "–", row["true"], row["lowest terms"] or "–")
    return label, row["cancelled"], reduced, *degrees


def _argument(r: Reduction) -> str:
    """The generic argument for which a formula was reduced."""
    if r.kind.counted == BOTH:
        return f"{r.kind.name} of degrees d_u and d_v"
    curve = {2: "plane curve", 3: "space curve"}.get(r.dimension, f"curve in R{r.dimension}")
    return f"{curve} of degree d" if r.kind.counted else f"{r.kind.name} that are functions of degree d_u and d_v"


def explanations(r: Reduction) -> Iterator[str]:
    """The factors, and the exceptional degrees, one sentence each."""
    world = "polynomial" if r.polynomial else "rational"
    yield f"For the {world} {_argument(r)}; verified by multiplication."
    for name, meaning in {p.name: p.meaning for part in r.parts for p in part.powers}.items():
        yield f"{name}: {meaning}"
    for part in r.parts:
        for d, n in part.true.lower if part.true else ():
            degree_text = f"the true degree is {n}" if n >= 0 else "it vanishes on every curve"
            yield f"{part.role}: at d = {d} {degree_text}"


# ---- condition numbers


#: The columns of numbers.
NUMBERS = ("degree", "condition", "minimal / this", "at most", "double error")


def comparison_sheet(c: Nurbs, each: Conditioning) -> Sheet:
    """Every form at every zero of a curve, one per row."""
    title = f"{c.name}: {described(c)}; {each.construction}"
    cells = [(_place(row.root), f.form, *_condition_cells(row, f)) for row in each.roots for f in row.forms]
    return Sheet("zero", "form", *NUMBERS, rows=cells, title=title, name=c.name, numbers=NUMBERS, heads=2)


def print_comparisons(found: Sequence[tuple[Nurbs, Conditioning]], *, quiet: bool) -> None:
    """Print the tables, the comparison of the forms, and the zeros that were not compared."""
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


def _condition_cells(row: RootConditions, f: FormAtRoot) -> tuple[str, ...]:
    assert f.double is not None  # the errors shown are those of a computation in doubles
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
