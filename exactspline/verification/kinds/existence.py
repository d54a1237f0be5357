"""Claims that a value is not rational."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.language.parts import split
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.verdict import REFUTED, UNDECIDED, Finding

NOT = "not rational"


@claim_kind
class Existence(Claim):
    """The value of ``formula`` is not rational: refuted by the formula itself, a quotient of polynomials in the curve,
    together with the proof of its meaning.
    """

    kind: ClassVar[str] = "existence"

    formula: str = field(metadata=read(formula_name))

    @property
    def claims(self) -> str:
        """Not rational."""
        return NOT

    @property
    def latex(self) -> str:
        """The formula is not rational."""
        return rf"{self.symbol(self.formula)} \;\text{{is not rational}}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The absence of a rational form is refuted by one: a formula without roots that is not the constant zero."""
        formula = self.find(self.formula)
        components = split(formula(jets_for((formula,), dimension, polynomial=polynomial)))[0]
        rational = not all(x.is_zero for x in components)
        told = f"{self.formula} is a quotient of polynomials in the curve"
        return Finding(REFUTED if rational else UNDECIDED, NOT, "rational", witness=told)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The rational form on this curve."""
        value = self.find(self.formula)(argument)
        numerators, denominator = split(value)
        mesh = (numerators[0] if denominator is None else denominator).mesh
        told = f"degree {value.degree} over {len(mesh)} segments"
        return Finding(REFUTED, NOT, f"rational of degree {value.degree}", witness=told)
