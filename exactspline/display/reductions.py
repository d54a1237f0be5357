"""The results of factoring a formula, as tables and as data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from exactspline.display.sheet import Sheet
from exactspline.language.kinds import PAIR, PLANE_PAIR
from exactspline.language.surface_kind import BOTH
from exactspline.symbolic.reduction import Part, Reduction


def reduction_rows(reductions: Iterable[Reduction]) -> list[dict[str, object]]:
    """One row per part (a ruled surface has two), as data."""
    return [
        {"key": f"{_label(r, part, always=True)}", "formula": r.name, "dimension": r.dimension}
        | {"polynomial": r.polynomial}
        | part.data()
        for r in reductions
        for part in r.parts
    ]


def _label(r: Reduction, part: Part, *, always: bool = False) -> str:
    """The label of a row: its formula, and where there are several, its part and the parameter of its degrees."""
    words = [f"{r.name} in R{r.dimension}" if always else r.name]
    words += [part.role] if always or len(r.parts) > 1 else []
    words += (
        [f"in {part.parameter}"] if len(r.kind.parameters(r.dimension)) > 1 and r.kind not in (PAIR, PLANE_PAIR) else []
    )
    return ", ".join(words)


def reduction_sheet(reductions: Iterable[Reduction]) -> Sheet:
    """The same as a table.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.reduction import reduce
    >>> reduction_sheet([reduce(find("g0"))]).rows[0][:2]
    ('g0', '1/2·w⁻⁸')
    """
    numbers = ("naive", "k, m, j", "nominal", "true", "in lowest terms")
    cells = [_cells(_label(r, part), part) for r in reductions for part in r.parts]
    return Sheet("formula", "factors cancelled", "reduced form", *numbers, rows=cells, numbers=numbers)


def _cells(label: str, part: Part) -> tuple[object, ...]:
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
