"""Claims of captions: numbers that are counted on one example curve."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import field
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.language.parts import joined, split
from exactspline.roots.zero_set import zeros
from exactspline.splines.lowest_terms import control_point_count
from exactspline.verification.claim import Claim, ExampleClaim, formula_name, only_component, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.verdict import REFUTED, VERIFIED, Finding
from exactspline.verification.vocabulary import Counter, word


def counts(claimed: str) -> list[tuple[int, Counter]]:
    """The numbers of a caption with their units.

    >>> [(n, str(what)) for n, what in counts("degree 96, 388 control points")]
    [(96, 'degree'), (388, 'control points')]

    Raises `ClaimError` when it cannot be read.
    """
    found = []
    for part in (part.strip() for part in claimed.replace("−", "-").split(",")):
        number = re.search(r"-?\d+", part)
        if number is None:
            raise ClaimError(f"the count {part!r} has no number", where="claimed", remedy='write "degree 6"')
        found.append((int(number[0]), word(Counter, part.replace(number[0], "", 1).strip(), "count")))
    return found


def counted(claim: Claim, name: str, value: str) -> str:
    """Numbers with their units."""
    counts(value)
    return str(value)


@claim_kind
class Count(ExampleClaim):
    """The numbers in ``claimed`` are those of ``formula`` on the curve ``example``."""

    kind: ClassVar[str] = "count"
    reading: ClassVar[str] = "spline"

    formula: str = field(metadata=read(formula_name))
    claimed: str = field(metadata=read(counted))

    def validate(self) -> None:
        """Refuse an example of which the claim does not speak."""
        curve = self.curve_named(self.example)
        if curve.dimension not in self.dimensions or curve.polynomial not in self.of.worlds:
            raise ClaimError(
                f"{self.example!r} is not a curve of which the claim speaks", where="example", remedy="name another one"
            )

    @property
    def claims(self) -> str:
        """The numbers."""
        return self.claimed

    @property
    def latex(self) -> str:
        """The formula with the numbers."""
        return rf"{self.symbol(self.formula)}: \;\text{{{self.claimed}}}"

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """Only the claimed numbers are computed."""
        from exactspline.geometry.features import curvature_extrema

        value = self.find(self.formula)(argument)
        value = joined(value)
        numerators = split(value)[0]
        counters: dict[Counter, Callable[[], int]] = {
            Counter.DEGREE: lambda: int(value.degree),
            Counter.CONTROL_POINTS: lambda: control_point_count(value),
            Counter.ROOTS: lambda: len(
                zeros(only_component(self, self.formula, numerators), periodic=own.curve.closed)
            ),
            Counter.EXTREMA: lambda: len(curvature_extrema(own.curve)),
            Counter.NOMINAL_CONTINUITY: lambda: min(min(p.continuity) for p in numerators),
            Counter.TRUE_CONTINUITY: lambda: min(p.continuity_at(t) for p in numerators for t in p.breakpoints[1:-1]),
        }
        found = [(counters[what](), what) for _, what in counts(self.claimed)]
        told = ", ".join(f"degree {n}" if what == Counter.DEGREE else f"{n} {what}" for n, what in found)
        told = told.replace("-", "−")
        if found == counts(self.claimed):
            return Finding(VERIFIED, self.claimed, told)
        return Finding(REFUTED, self.claimed, told, witness=f"on the example curve {self.example}: {told}")
