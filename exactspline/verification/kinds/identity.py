"""Claims that a formula identically equals another one, or zero."""

from __future__ import annotations

from dataclasses import field, replace
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError
from exactspline.language.argument import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import kind_of
from exactspline.language.parts import split
from exactspline.readings.jet import Jet
from exactspline.readings.rational_jet import JetFraction
from exactspline.symbolic.factorization import jets_for, jets_with_roots
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_factor import WEIGHTS, factor_of_text, factor_parts
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.decision import Equation, Zero
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import ExactQuotient, Fact, Remainder
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.notation import factor_latex
from exactspline.verification.verdict import REFUTED, VACUOUS, VERIFIED, Finding
from exactspline.verification.vocabulary import ArgumentKind, Name


def checked_factor(claim: Claim, name: str, value: str) -> str:
    """A factor whose names are formulas that apply to the arguments of the claim."""
    for part, _ in factor_parts(value):
        if part in WEIGHTS and claim.curve == ArgumentKind.TABLE:
            raise ClaimError("Table 1 has no denominator w", where=name, remedy="write it into the formulas")
        if part == "W" and not claim.of_pair:
            raise ClaimError("the factor contains a second curve", where=name, remedy='the denominator is "w"')
        if part[0].isalpha() and part not in WEIGHTS:
            formula_name(claim, name, part)
    return str(value)


@claim_kind
class Identity(Claim):
    """``left = factor · right``."""

    kind: ClassVar[str] = "identity"
    value: ClassVar[str] = "$factor"
    sides: ClassVar[tuple[str, ...]] = ("left", "right")
    of_frames: ClassVar[bool] = True
    has_residues: ClassVar[bool] = True

    left: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))
    factor: str = field(default="1", metadata=read(checked_factor))

    @property
    def latex(self) -> str:
        """Left side, factor, right side."""
        return f"{self.symbol(self.left)} = {factor_latex(self.factor, self.find)}{self.symbol(self.right)}"

    @property
    def equality(self) -> Equation:
        """The equation."""
        return Equation(self.find(self.left), self.find(self.right), self.factor, self.find)

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left = factor · right`` as differential polynomials, with the true quotient; where roots are adjoined, a
        quotient is not a product of polynomials.
        """
        equation = self.equality
        if kind_of(self.curve).adjoins_roots:
            return equation.decide(jets_with_roots(equation.formulas, self.factor, dimension, polynomial=polynomial))
        c = jets_for(equation.formulas, dimension, polynomial=polynomial)
        finding = equation.decide(c)
        if finding.verdict == VACUOUS:
            return finding
        if all(x.is_zero for x in split(equation.right(c))[0]):
            return Finding(REFUTED, Fact.NOT_PROPORTIONAL, witness=Fact.RIGHT_SIDE_VANISHES)
        factor = factor_of(equation.left, equation.right, dimension, polynomial=polynomial)
        if factor is None:
            witness = self.refuted_on_examples().witness or Fact.POLYNOMIALS_NOT_PROPORTIONAL
            return Finding(REFUTED, Fact.NOT_PROPORTIONAL, witness=witness)
        differ = finding.computed is Fact.NOT_IDENTICAL
        return replace(
            finding, computed=factor, factor=factor, witness=ExactQuotient(factor) if differ else finding.witness
        )

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """``left · (denominators) = factor · right · (denominators)``, multiplied out on the spline."""
        return self.equality.decide(argument, VERIFIED)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The left side times the denominator of the factor, minus the right side times its numerator."""
        top: Any
        bottom: Any
        top, bottom = factor_of_text(self.factor, c, self.find)
        if bottom.is_zero:
            raise FormulaError("the factor is divided by zero")
        sides = (split(self.find(name)(c))[0] for name in (self.left, self.right))
        return [p * bottom - q * top for p, q in zip(*sides, strict=True)]

    @property
    def compared(self) -> list[Formula]:
        """Both sides, and the formulas in the factor."""
        return list(self.equality.formulas)


@claim_kind
class Vanishing(Claim):
    """``left`` is identically zero."""

    kind: ClassVar[str] = "vanishing"
    value: ClassVar[str] = "0"
    notation: ClassVar[str] = r"$left \equiv 0"
    of_frames: ClassVar[bool] = True
    has_residues: ClassVar[bool] = True

    left: Name = field(metadata=read(formula_name))

    @property
    def equality(self) -> Zero:
        """The statement that it vanishes."""
        return Zero(self.find(self.left))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left`` is the zero polynomial."""
        formula = self.find(self.left)
        roots = kind_of(self.curve).adjoins_roots
        jets = jets_with_roots((formula,), "1", dimension, polynomial=polynomial) if roots else None
        c = jets or jets_for((formula,), dimension, polynomial=polynomial)
        finding = self.equality.decide(c)
        if roots or finding.verdict != REFUTED:
            return finding
        rest = next(x for x in split(formula(c))[0] if not x.is_zero)
        witness = self.refuted_on_examples().witness or Fact.POLYNOMIAL_NOT_ZERO
        return Finding(REFUTED, Remainder(Jet(rest.ring, rest.top)), witness=witness)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """All components are the zero spline."""
        return self.equality.decide(argument, VERIFIED)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """Its components."""
        return list(split(self.find(self.left)(c))[0])
