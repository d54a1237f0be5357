"""Claims of equalities: a formula is identically equal to another formula, or to zero; two ruled surfaces are the same;
a plane curve lies on a ruled surface.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import field, replace
from typing import ClassVar

from exactspline.errors import ClaimError, ExactSplineError, ReachError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import POINT_IN_SPACE, Kind, kind_of
from exactspline.language.ruled import split
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet, RationalJetReading
from exactspline.splines.tensor import TensorSpline
from exactspline.symbolic.factorization import Factor, jets_for, without_denominator
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, TwoSided, claim_kind, formula_name, read
from exactspline.verification.decision import (
    DirectrixOf,
    Equation,
    OneRuledSurface,
    Outcome,
    Statement,
    Zero,
    common_zeros,
    extra_zero,
)
from exactspline.verification.evaluation import Evaluation, evaluation, on_segments
from exactspline.verification.evidence import ExactQuotient, Fact, OnExample, Remainder, Rulings, Said
from exactspline.verification.generic_proof import factor_of, harmful
from exactspline.verification.notation import WEIGHTS, factor_latex, factor_parts
from exactspline.verification.paper_curves import curve_names
from exactspline.verification.verdict import REFUTED, VACUOUS, VERIFIED, Finding
from exactspline.verification.vocabulary import ArgumentKind, Name


def checked_factor(claim: Claim, name: str, value: str) -> str:
    """A factor whose names are formulas that apply to the arguments of the claim."""
    for part, _ in factor_parts(value):
        if part in WEIGHTS and claim.curve == ArgumentKind.TABLE:
            raise ClaimError("Table 1 has no denominator w", where=name, remedy="write it into the formulas")
        if part == "W" and not claim.of_pair:
            raise ClaimError("the factor contains a second curve", where=name, remedy='the denominator is "w"')
        constant = part in kind_of(claim.curve).constants and not claim.source_paper.has(part)
        if part[0].isalpha() and part not in WEIGHTS and not constant:
            formula_name(claim, name, part)
    return str(value)


class _EqualityClaim(Claim):
    """A claim that two values are equal. `equality` compares its sides in any exact evaluation mode."""

    @property
    @abstractmethod
    def equality(self) -> Statement:
        """The statement of the claim."""

    def _decided(self, dimension: int, polynomial: bool) -> Finding:
        """The finding. A claim about γ alone that is too long for numerators and denominator is decided for
        indeterminate coordinates of γ: at a point, the derivatives of γ are as free on rational curves as on polynomial
        ones.
        """
        try:
            return super()._decided(dimension, polynomial)
        except ReachError:
            if polynomial or not without_denominator(self.compared, getattr(self, "factor", "1"), dimension):
                raise
        return super()._decided(dimension, True)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The sides, multiplied out on the splines."""
        return self.equality.decide(argument, VERIFIED)


@claim_kind
class Identity(TwoSided, _EqualityClaim):
    """``left = factor · right``."""

    kind: ClassVar[str] = "identity"
    value: ClassVar[str] = "$factor"
    of_frames: ClassVar[bool] = True

    factor: str = field(default="1", metadata=read(checked_factor))

    @property
    def latex(self) -> str:
        """Left side, factor, right side."""
        return f"{self.symbol(self.left)} = {factor_latex(self.factor, self.find_in_factor)}{self.symbol(self.right)}"

    @property
    def equality(self) -> Equation:
        """The equation."""
        return Equation(self.find(self.left), self.find(self.right), self.factor, self.find_in_factor)

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left = factor · right`` as differential polynomials, with the true quotient; where roots are adjoined, a
        quotient is not a product of polynomials.
        """
        equation = self.equality
        c = jets_for(equation.formulas, dimension, polynomial=polynomial, factor=self.factor)
        finding = equation.decide(c)
        if kind_of(self.curve).adjoins_roots:
            if finding.computed is Fact.NOT_IDENTICAL and (example := self._differs_on(dimension, polynomial)):
                return replace(finding, witness=OnExample(Name(example), finding.witness))
            return finding
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

    def _differs_on(self, dimension: int, polynomial: bool) -> str:
        """The first example curve on which the sides, with roots adjoined, differ; curves on which they do not exist
        are skipped.
        """
        kind = kind_of(self.curve)
        for name in sorted(curve_names(self.source_paper), key=lambda name: name != self.witness):
            curve = self.curve_named(name)
            if curve.dimension == dimension and curve.polynomial == polynomial:
                try:
                    first = next(on_segments(kind, curve, self.highest_derivative(dimension)))
                    differs = self.equality.compare(first.argument).outcome is Outcome.DIFFERENT
                    if differs and not evaluation(curve).failing(self.curve, self.assumes):
                        return name
                except ExactSplineError:
                    continue
        return ""

    @property
    def compared(self) -> list[Formula]:
        """Both sides, and the formulas in the factor."""
        return list(self.equality.formulas)


@claim_kind
class Vanishing(_EqualityClaim):
    """``left`` is identically zero."""

    kind: ClassVar[str] = "vanishing"
    value: ClassVar[str] = "0"
    notation: ClassVar[str] = r"$left \equiv 0"
    of_frames: ClassVar[bool] = True

    left: Name = field(metadata=read(formula_name))

    @property
    def equality(self) -> Zero:
        """The statement that ``left`` vanishes."""
        return Zero(self.find(self.left))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left`` is the zero polynomial."""
        formula = self.find(self.left)
        c = jets_for((formula,), dimension, polynomial=polynomial)
        finding = self.equality.decide(c)
        if finding.verdict != REFUTED or kind_of(self.curve).adjoins_roots:
            return finding
        rest = next(x for x in split(formula(c))[0] if not x.is_zero)
        witness = self.refuted_on_examples().witness or Fact.POLYNOMIAL_NOT_ZERO
        return Finding(REFUTED, Remainder(Jet(rest.ring, rest.top)), witness=witness)


@claim_kind
class SameSurface(TwoSided, _EqualityClaim):
    """The ruled surfaces ``left`` and ``right`` are equal: their generators are parallel, and their directrices differ
    by a multiple of these.
    """

    kind: ClassVar[str] = "same surface"
    value: ClassVar[str] = "one surface"
    notation: ClassVar[str] = r"$left \;\text{and}\; $right \;\text{are one surface}"

    @property
    def equality(self) -> Statement:
        """The statement that the two surfaces are equal."""
        return OneRuledSurface(self.find(self.left), self.find(self.right))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The generators are parallel, and the directrices differ by a multiple of the generators; with the relation of
        the ruling parameters ζ (left) and λ (right), and the places where the relation fails.
        """
        formulas = self.find(self.left), self.find(self.right)
        c = jets_for(formulas, dimension, polynomial=polynomial)
        finding = self.equality.decide(c)
        if finding.verdict == VACUOUS:
            return finding
        if finding.verdict == REFUTED:
            return replace(finding, witness=self.refuted_on_examples().witness or finding.witness)
        rulings = finding.factor
        assert isinstance(rulings, Rulings)
        bad, used = harmful(rulings.scale, self.assumes)
        also, others = ([], ()) if rulings.shift is None else harmful(_poles(rulings.shift), self.assumes)
        bad = list(dict.fromkeys([*bad, *also]))
        found = say.one_surface_except(tuple(bad)) if bad else Fact.ONE_SURFACE
        return replace(finding, computed=found, assumptions=tuple(dict.fromkeys([*used, *others])))

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """``G × Ḡ = 0`` and ``(δ − δ̄) × G = 0``, multiplied out on the splines."""
        finding = super().examine(argument, own)
        but = self._but(argument) if finding.verdict == VERIFIED else None
        return replace(finding, computed=but) if but else finding

    def _but(self, argument: Evaluated) -> Said | None:
        """The places where one generator vanishes and the other does not."""
        surfaces = (self.find(self.left)(argument), self.find(self.right)(argument))
        generators = [split(surface.generator)[0] for surface in surfaces]
        if isinstance(generators[0][0], TensorSpline):
            return None
        left, right = map(common_zeros, generators)
        for name, f, g in ((self.left, left, right), (self.right, right, left)):
            if place := extra_zero(f, g):
                return say.one_surface_but(place, name)
        return None


def _poles(factor: Factor) -> Factor:
    """The denominator of a factor."""
    return Factor(factor.constant, factor.powers.below, factor.ring)


@claim_kind
class IsoCurve(_EqualityClaim):
    """The plane curve ``left`` is the curve ζ = 0 of the ruled surface ``right`` of the same plane curve in space."""

    kind: ClassVar[str] = "iso-curve"
    value: ClassVar[str] = "the curve ζ = 0"
    notation: ClassVar[str] = r"$left \;\text{is the curve}\; \zeta = 0 \;\text{of}\; $right"
    evaluated_first: ClassVar[bool] = False  # the right side takes the curve in space

    left: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))

    def kind_of_field(self, name: str) -> Kind:
        """The right side takes the same curve in space."""
        return POINT_IN_SPACE if name == "right" else super().kind_of_field(name)

    def validate(self) -> None:
        """Reject anything but a plane curve with a point."""
        if self.curve != ArgumentKind.PLANE_POINT:
            raise ClaimError("an iso-curve belongs to a plane curve and a point", where="curve", remedy="plane point")

    @property
    def equality(self) -> Statement:
        """The statement that the plane curve is the directrix."""
        return DirectrixOf(self.find(self.left), self.find(self.right))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """As quotients of differential polynomials."""
        reading = RationalJetReading(self.highest_derivative(dimension))
        c = reading.argument(self.find(self.left).kind, dimension, polynomial=polynomial)
        finding = self.equality.decide(c)
        witness = self.refuted_on_examples().witness if finding.verdict == REFUTED else None
        return replace(finding, witness=witness or finding.witness)

    def highest_derivative(self, dimension: int) -> int:
        """The right side is a formula in space."""
        return max(order_of(self.find(self.left), dimension), order_of(self.find(self.right), dimension + 1))
