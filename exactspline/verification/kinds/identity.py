"""Claims that a formula is identically another one, or zero."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError
from exactspline.language.argument import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import kind_of
from exactspline.language.parts import split
from exactspline.readings.jet import Jet, polynomial_text
from exactspline.readings.rational_jet import JetFraction
from exactspline.symbolic.factorization import jets_for, jets_with_roots
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_factor import WEIGHTS, factor_of_text, factor_parts
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import printed_factor, where_it_differs
from exactspline.verification.decision import Decision, Outcome, decide_identity
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.notation import factor_latex
from exactspline.verification.verdict import PROVED, REFUTED, VACUOUS, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import ArgumentKind


def stated_factor(claim: Claim, name: str, value: str) -> str:
    """A factor whose names are formulas that apply to the arguments of the claim."""
    for part, _ in factor_parts(value):
        if part in WEIGHTS and claim.curve == ArgumentKind.TABLE:
            raise ClaimError("Table 1 has no denominator w", where=name, remedy="write it into the formulas")
        if part == "W" and not claim.of_pair:
            raise ClaimError("the factor speaks of a second curve", where=name, remedy='the denominator is "w"')
        if part[0].isalpha() and part not in WEIGHTS:
            formula_name(claim, name, part)
    return str(value)


@claim_kind
class Identity(Claim):
    """``left = factor · right``."""

    kind: ClassVar[str] = "identity"
    of_frames: ClassVar[bool] = True
    has_residues: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))
    right: str = field(metadata=read(formula_name))
    factor: str = field(default="1", metadata=read(stated_factor))

    def validate(self) -> None:
        """Refuse a formula compared with itself."""
        if self.left == self.right:
            raise ClaimError("both sides are one formula", where="right", remedy="name another one")

    @property
    def claims(self) -> str:
        """The factor."""
        return self.factor

    @property
    def latex(self) -> str:
        """Left side, factor, right side."""
        return f"{self.symbol(self.left)} = {factor_latex(self.factor, self.find)}{self.symbol(self.right)}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left = factor · right`` as differential polynomials."""
        left, right = self.find(self.left), self.find(self.right)
        if kind_of(self.curve).adjoins_roots:
            return self._over_roots(dimension, polynomial)
        c = jets_for((left, right, *self._factors()), dimension, polynomial=polynomial)
        found = decide_identity(left(c), right(c), factor_of_text(self.factor, c, self.find))
        if found.verdict(PROVED) == VACUOUS:
            return vacuous(self.factor)
        if all(x.is_zero for x in split(right(c))[0]):
            return Finding(REFUTED, self.factor, "not proportional", "", "the right side vanishes, the left does not")
        factor = factor_of(left, right, dimension, polynomial=polynomial)
        if factor is None:
            witness = self.refuted_on_examples().witness or "the jet polynomials are not proportional"
            return Finding(REFUTED, self.factor, "not proportional", "", witness)
        divided = found.outcome is Outcome.NO_FACTOR
        told = "the factor is divided by zero" if divided else f"the exact quotient is {factor}"
        equal = found.outcome is Outcome.EQUAL
        return Finding(found.verdict(PROVED), self.factor, str(factor), str(factor), "" if equal else told)

    def _over_roots(self, dimension: int, polynomial: bool) -> Finding:
        """The same where a quotient is not a product of polynomials: component by component."""
        left, right = self.find(self.left), self.find(self.right)
        formulas = (left, right, *self._factors())
        c = jets_with_roots(formulas, self.factor, dimension, polynomial=polynomial)
        found = decide_identity(left(c), right(c), factor_of_text(self.factor, c, self.find))
        if found.outcome is Outcome.EQUAL:
            return Finding(PROVED, self.factor, self.factor, self.factor)
        if found.verdict(PROVED) == VACUOUS:
            return vacuous(self.factor)
        return Finding(REFUTED, self.factor, *self._difference(found, left(c), right(c)))

    def _difference(self, found: Decision, left: Any, right: Any) -> tuple[str, str, str]:
        """What was computed, no factor, and the witness, where two sides differ."""
        if found.outcome is Outcome.NO_FACTOR:
            return "1/0", "", "the factor is divided by zero"
        if found.outcome is Outcome.UNLIKE:
            told = f"{len(split(left)[0])} components, and {len(split(right)[0])}"
            return told, "", "not as many components"
        return "not identical", "", f"component {found.component + 1} differs"

    def _factors(self) -> list[Any]:
        return [self.find(name) for name, _ in factor_parts(self.factor) if name[0].isalpha() and name not in WEIGHTS]

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """``left · (denominators) = factor · right · (denominators)``, multiplied out on the spline."""
        left, right = (self.find(name)(argument) for name in (self.left, self.right))
        assert isinstance(argument, Evaluated)  # operands of Table 1 have no factors
        found = decide_identity(left, right, factor_of_text(self.factor, argument, self.find))
        factor = printed_factor(self.factor, argument)
        if found.outcome is Outcome.NOTHING:
            return vacuous(self.factor, factor=factor)
        if found.outcome is Outcome.NO_SIDE:
            return vacuous(self.factor, "a side does not exist on all of this curve: 0/0", factor)
        if found.outcome is Outcome.NO_FACTOR:
            return vacuous(self.factor, "the factor does not exist on all of this curve: 1/0", factor)
        if found.outcome is Outcome.UNLIKE:
            return Finding(REFUTED, self.factor, *self._difference(found, left, right))
        if found.outcome is Outcome.DIFFERENT:
            told = f"the sides differ {where_it_differs(found.difference)}"
            return Finding(REFUTED, self.factor, "not identical", factor, told)
        return Finding(VERIFIED, self.factor, factor, factor)

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The left side times the denominator of the factor, less the right one times its numerator."""
        top: Any
        bottom: Any
        top, bottom = factor_of_text(self.factor, c, self.find)
        if bottom.is_zero:
            raise FormulaError("the factor is divided by zero")
        sides = (split(self.find(name)(c))[0] for name in (self.left, self.right))
        return [p * bottom - q * top for p, q in zip(*sides, strict=True)]

    @property
    def compared(self) -> list[Formula]:
        """Both sides, and those in the factor."""
        return [self.find(self.left), self.find(self.right), *self._factors()]


@claim_kind
class Vanishing(Claim):
    """``left`` is identically zero."""

    kind: ClassVar[str] = "vanishing"
    of_frames: ClassVar[bool] = True
    has_residues: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))

    @property
    def claims(self) -> str:
        """Zero."""
        return "0"

    @property
    def latex(self) -> str:
        """The formula is zero."""
        return rf"{self.symbol(self.left)} \equiv 0"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left`` is the zero polynomial."""
        formula = self.find(self.left)
        roots = kind_of(self.curve).adjoins_roots
        jets = jets_with_roots((formula,), "1", dimension, polynomial=polynomial) if roots else None
        components = split(formula(jets or jets_for((formula,), dimension, polynomial=polynomial)))[0]
        rest = next((c for c in components if not c.is_zero), None)
        if rest is None:
            return Finding(PROVED, "0", "0")
        if roots:
            return Finding(REFUTED, "0", "not zero", witness=f"component {components.index(rest) + 1} is not zero")
        witness = self.refuted_on_examples().witness or "the jet polynomial is not zero"
        return Finding(REFUTED, "0", polynomial_text(Jet(rest.ring, rest.top), 3), witness=witness)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """All components are the zero spline."""
        for p in split(self.find(self.left)(argument))[0]:
            if not p.is_zero:
                return Finding(REFUTED, "0", "not zero", witness=f"it differs from 0 {where_it_differs(p)}")
        return Finding(VERIFIED, "0", "0")

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """Its components."""
        return list(split(self.find(self.left)(c))[0])
