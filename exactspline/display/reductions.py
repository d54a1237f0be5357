"""What is found when a formula is factored, for people and for programs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from exactspline.display.sheet import Sheet
from exactspline.symbolic.reduction import Reduction


def reduction_rows(found: Iterable[Reduction]) -> list[dict[str, object]]:
    """A row a part (a ruled surface has two), for programs."""
    return [
        {"key": f"{r.name} in R{r.dimension}, {part.role}", "formula": r.name, "dimension": r.dimension}
        | {"polynomial": r.polynomial}
        | part.data()
        for r in found
        for part in r.parts
    ]


def reduction_sheet(found: Iterable[Reduction]) -> Sheet:
    """The same as a table.

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.reduction import reduce
    >>> reduction_sheet([reduce(find("g0"))]).rows[0][:2]
    ('g0', '1/2·w⁻⁸')
    """
    numbers = ("naive", "k, m, j", "nominal", "true", "in lowest terms")
    made = Sheet("formula", "factors cancelled", "reduced form", *numbers, numbers=numbers)
    for r in found:
        for part in r.parts:
            row = part.data()
            label = r.name if len(r.parts) == 1 else f"{r.name}, {part.role}"
            grading = f"{row['k']}, {row['m']}, {row['j']}" if row["k"] is not None else "–"
            reduced = part.text + (f", poles at {row['poles']} = 0" if row["poles"] else "")
            made.add_row(
                label,
                row["cancelled"],
                reduced,
                row["naive"],
                grading,
                row["nominal"] or "–",
                row["true"],
                row["lowest terms"] or "–",
            )
    return made


def explanations(r: Reduction) -> Iterator[str]:
    """Of what the factors are, and where the degree is lower: a sentence each."""
    kind = {2: "plane curve", 3: "space curve"}.get(r.dimension, f"curve in R{r.dimension}")
    yield f"For the {'polynomial' if r.polynomial else 'rational'} {kind} of degree d; verified by multiplication."
    for name, meaning in {p.name: p.meaning for part in r.parts for p in part.powers}.items():
        yield f"{name}: {meaning}"
    for part in r.parts:
        for d, n in part.true.lower if part.true else ():
            told = f"the true degree is {n}" if n >= 0 else "it vanishes on every curve"
            yield f"{part.role}: at d = {d} {told}"
