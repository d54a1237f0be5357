"""Claims about ruled surfaces: that two are the same, and that a plane curve lies on one."""

from __future__ import annotations

from dataclasses import field, replace
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import Curve, embedded
from exactspline.language.kinds import POINT_IN_SPACE, Kind
from exactspline.language.parts import split
from exactspline.language.ruled import RuledSurface, differences
from exactspline.readings.differential_order import order_of
from exactspline.readings.rational_jet import JetFraction, RationalJetReading
from exactspline.splines.tensor import TensorSpline
from exactspline.symbolic.factorization import Factor, jets_for
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import common_zeros, extra_zero
from exactspline.verification.decision import DirectrixOf, OneRuledSurface, Statement
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import OneSurface, OneSurfaceBut, Rulings
from exactspline.verification.generic_proof import harmful
from exactspline.verification.verdict import REFUTED, VACUOUS, VERIFIED, Finding
from exactspline.verification.vocabulary import ArgumentKind, Name


@claim_kind
class SameSurface(Claim):
    """The ruled surfaces ``left`` and ``right`` are equal: their generators are parallel, and their directrices differ
    by a multiple of these.
    """

    kind: ClassVar[str] = "same surface"
    value: ClassVar[str] = "one surface"
    notation: ClassVar[str] = r"$left \;\text{and}\; $right \;\text{are one surface}"
    sides: ClassVar[tuple[str, ...]] = ("left", "right")
    has_residues: ClassVar[bool] = True

    left: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))

    @property
    def equality(self) -> Statement:
        """The statement that they are equal."""
        return OneRuledSurface(self.find(self.left), self.find(self.right))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The generators are parallel, the directrices differ by a multiple of these; with the relation of the ruling
        parameters ζ (left) and λ (right), and where it fails.
        """
        formulas = self.find(self.left), self.find(self.right)
        c = jets_for(formulas, dimension, polynomial=polynomial)
        a, b = formulas[0](c), formulas[1](c)
        for name, surface in ((self.left, a), (self.right, b)):
            if not isinstance(surface, RuledSurface):
                raise ClaimError(f"{name!r} is not a ruled surface", where=self.key, remedy="name one")
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
        return replace(finding, computed=OneSurface(tuple(bad)), assumptions=tuple(dict.fromkeys([*used, *others])))

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """``G × Ḡ = 0`` and ``(δ − δ̄) × G = 0``, multiplied out on the splines."""
        finding = self.equality.decide(argument, VERIFIED)
        but = self._but(argument) if finding.verdict == VERIFIED else None
        return replace(finding, computed=but) if but else finding

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The vector products with a generator."""
        return [x for product in differences(self.find(self.left)(c), self.find(self.right)(c)) for x in product]

    def _but(self, argument: Handed) -> OneSurfaceBut | None:
        """Where one generator vanishes and the other does not."""
        surfaces = (self.find(self.left)(argument), self.find(self.right)(argument))
        generators = [split(surface.generator)[0] for surface in surfaces]
        if isinstance(generators[0][0], TensorSpline):
            return None
        left, right = map(common_zeros, generators)
        for name, f, g in ((self.left, left, right), (self.right, right, left)):
            if place := extra_zero(f, g):
                return OneSurfaceBut(place, name)
        return None


def _poles(factor: Factor) -> Factor:
    """The denominator of a factor."""
    return Factor(factor.constant, factor.powers.below, factor.ring)


@claim_kind
class IsoCurve(Claim):
    """The plane curve ``left`` is the curve ζ = 0 of the ruled surface ``right`` of the same plane curve in space."""

    kind: ClassVar[str] = "iso-curve"
    value: ClassVar[str] = "the curve ζ = 0"
    notation: ClassVar[str] = r"$left \;\text{is the curve}\; \zeta = 0 \;\text{of}\; $right"
    evaluated_first: ClassVar[bool] = False  # the right side takes the curve in space
    has_residues: ClassVar[bool] = True

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

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The plane curve and the directrix, compared as quotients."""
        return self.equality.decide(argument, VERIFIED)

    def highest_derivative(self, dimension: int) -> int:
        """The right side is a formula in space."""
        return max(order_of(self.find(self.left), dimension), order_of(self.find(self.right), dimension + 1))

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The differences of the coordinates."""
        assert isinstance(c, Curve)
        plane, space = self.find(self.left)(c), self.find(self.right)(embedded(c)).directrix
        return [plane[0] - space[0], plane[1] - space[1], space[2]]
