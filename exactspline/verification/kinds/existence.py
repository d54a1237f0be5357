"""Claims that a value is not rational."""

from __future__ import annotations

from dataclasses import field, replace
from functools import cache
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.language.formula import Formula
from exactspline.language.kinds import FRAMED, FRAMED_PLANE, FRAMED_SPACE, CurveKind, Kind
from exactspline.language.parts import split
from exactspline.symbolic.factorization import jets_with_roots
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.decision import Equation
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import Fact, NotItsDefinition, RationalForm, RationalOfDegree, Undefined
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, Finding, vacuous
from exactspline.verification.vocabulary import Name


@claim_kind
class Existence(Claim):
    """The function defined by the formula ``definition`` is not rational: refuted where ``formula``, a quotient of
    polynomials in the curve, equals it for all curves. The definition may contain the unit vectors of a frame, which
    are roots.
    """

    kind: ClassVar[str] = "existence"
    value: ClassVar[str] = "not rational"
    notation: ClassVar[str] = r"$definition \;\text{is not rational}"
    evaluated_first: ClassVar[bool] = False  # splines have no roots

    formula: Name = field(metadata=read(formula_name))
    definition: Name = field(metadata=read(formula_name))

    def kind_of_field(self, name: str) -> Kind:
        """A definition may have zeros."""
        own = super().kind_of_field(name)
        if name != "definition" or type(own) is not CurveKind or own.constants:
            return own
        return FRAMED if len(own.dimensions) > 1 else FRAMED_PLANE if own.dimensions == (2,) else FRAMED_SPACE

    def validate(self) -> None:
        """Reject a formula that is its own definition: any formula is a quotient of polynomials."""
        if self.formula == self.definition:
            raise ClaimError(
                f"{self.formula!r} is said to be what it is",
                where="definition",
                remedy="name the formula that defines it",
            )

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The absence of a rational form is refuted by a nonzero one that equals the definition."""
        equation = Equation(self.find(self.formula), self.find(self.definition))
        c = jets_with_roots(equation.formulas, "1", dimension, polynomial=polynomial)
        if all(x.is_zero for x in split(equation.left(c))[0]):
            return vacuous()
        if equation.decide(c).verdict == PROVED:
            return Finding(REFUTED, Fact.RATIONAL, witness=RationalForm(self.formula, self.definition))
        return Finding(UNDECIDED, witness=NotItsDefinition(self.formula, self.definition))

    @property
    def compared(self) -> list[Formula]:
        """Both formulas, each once."""
        return [self.find(self.formula), self.find(self.definition)]

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The rational form on this curve."""
        general = _decided(self, own.curve.dimension, own.curve.polynomial)
        if general.verdict != REFUTED:
            return general
        value = self.find(self.formula)(argument)
        denominator = split(value)[1]
        if denominator is not None and denominator.vanishes_somewhere:
            return vacuous(Undefined(self.formula))
        return replace(general, computed=RationalOfDegree(int(value.degree)))


@cache
def _decided(claim: Existence, dimension: int, polynomial: bool) -> Finding:
    return claim.decide(dimension, polynomial)
