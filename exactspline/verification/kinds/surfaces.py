"""Claims about ruled surfaces: that two are the same, and that a plane curve lies on one."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import Curve, embedded
from exactspline.language.kinds import POINT_IN_SPACE, Kind
from exactspline.language.parts import split
from exactspline.language.ruled import RuledSurface, differences
from exactspline.readings.differential_order import order_of
from exactspline.readings.rational_jet import JetFraction, RationalJetReading
from exactspline.splines.tensor import TensorSpline
from exactspline.symbolic.factorization import Factor, find_factor, jets_for
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import common_zeros, extra_zero, where_it_differs
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.generic_proof import harmful
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import ArgumentKind

ONE = "one surface"
ZETA = "the curve ζ = 0"


@claim_kind
class SameSurface(Claim):
    """The ruled surfaces ``left`` and ``right`` are one: parallel generators, directrices that differ along them."""

    kind: ClassVar[str] = "same surface"
    has_residues: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))
    right: str = field(metadata=read(formula_name))

    def validate(self) -> None:
        """Refuse a surface compared with itself."""
        if self.left == self.right:
            raise ClaimError("both sides are one formula", where="right", remedy="name another one")

    @property
    def claims(self) -> str:
        """One surface."""
        return ONE

    @property
    def latex(self) -> str:
        """Both names."""
        return rf"{self.symbol(self.left)} \;\text{{and}}\; {self.symbol(self.right)} \;\text{{are one surface}}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The generators are parallel, the directrices differ along them; with the relation of the ruling parameters ζ
        (left) and λ (right), and where it fails.
        """
        formulas = self.find(self.left), self.find(self.right)
        c = jets_for(formulas, dimension, polynomial=polynomial)
        a, b = formulas[0](c), formulas[1](c)
        for name, surface in ((self.left, a), (self.right, b)):
            if not isinstance(surface, RuledSurface):
                raise ClaimError(f"{name!r} is not a ruled surface", where=self.key, remedy="name one")
            if all(x.is_zero for x in split(surface.generator)[0]):
                return vacuous(ONE, f"no surface: the generator of {name} vanishes on every curve")
        offset = b.directrix - a.directrix
        # no generator vanishes: vectors of quotients are parallel exactly if they are proportional
        scale, shift = find_factor(b.generator, a.generator), find_factor(offset, a.generator)
        if scale is None or shift is None:
            witness = self.refuted_on_examples().witness
            told = "the generators are not parallel, or the directrices differ across them"
            return Finding(REFUTED, ONE, "two surfaces", witness=witness or told)
        moved = "" if offset.is_zero else f"{shift} + "
        bad, used = harmful(scale, self.assumes)
        also, others = ([], ()) if offset.is_zero else harmful(_poles(shift), self.assumes)
        bad = list(dict.fromkeys([*bad, *also]))
        where = f", but where {' or '.join(bad)} vanishes" if bad else ""
        factor = f"ζ = {moved}{scale} λ".replace("1 λ", "λ")
        return Finding(PROVED, ONE, ONE + where, factor, assumptions=tuple(dict.fromkeys([*used, *others])))

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """``G × Ḡ = 0`` and ``(δ − δ̄) × G = 0``, multiplied out on the splines."""
        a, b = self.find(self.left)(argument), self.find(self.right)(argument)
        generators = [split(surface.generator)[0] for surface in (a, b)]
        for i in range(len(generators[0][0].polynomials)):
            if any(not any(x.polynomials[i] for x in generator) for generator in generators):
                return vacuous(ONE, "no surface: the generator vanishes")
        for product in differences(a, b):
            for x in split(product)[0]:
                if not x.is_zero:
                    return Finding(REFUTED, ONE, "two surfaces", witness=f"they differ {where_it_differs(x)}")
        return Finding(VERIFIED, ONE, ONE + self._but(generators))

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The vector products with a generator."""
        return [x for product in differences(self.find(self.left)(c), self.find(self.right)(c)) for x in product]

    def _but(self, generators: list[list[Any]]) -> str:
        """Where one generator vanishes and the other does not."""
        if isinstance(generators[0][0], TensorSpline):
            return ""
        left, right = map(common_zeros, generators)
        for name, f, g in ((self.left, left, right), (self.right, right, left)):
            if place := extra_zero(f, g):
                return f", but {place}, where the generator of {name} vanishes"
        return ""


def _poles(factor: Factor) -> Factor:
    """The denominator of a factor."""
    return Factor(factor.constant, factor.powers.below, factor.ring)


@claim_kind
class IsoCurve(Claim):
    """The plane curve ``left`` is the curve ζ = 0 of the ruled surface ``right`` of the same plane curve in space."""

    kind: ClassVar[str] = "iso-curve"
    has_residues: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))
    right: str = field(metadata=read(formula_name))

    def kind_of_field(self, name: str) -> Kind:
        """The right side takes the same curve in space."""
        return POINT_IN_SPACE if name == "right" else super().kind_of_field(name)

    def validate(self) -> None:
        """Refuse anything but a plane curve with a point."""
        if self.curve != ArgumentKind.PLANE_POINT:
            raise ClaimError("an iso-curve is one of a plane curve and a point", where="curve", remedy="plane point")

    @property
    def claims(self) -> str:
        """The curve ζ = 0."""
        return ZETA

    @property
    def latex(self) -> str:
        """Both names."""
        return (
            rf"{self.symbol(self.left)} \;\text{{is the curve}}\; \zeta = 0 \;\text{{of}}\; {self.symbol(self.right)}"
        )

    def missing(self, argument: Handed) -> str:
        """No check beforehand: the right side takes the curve in space."""
        return ""

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """As quotients of differential polynomials."""
        left, right = self.find(self.left), self.find(self.right)
        c: Any = RationalJetReading(self.highest_derivative(dimension)).argument(
            left.kind, dimension, polynomial=polynomial
        )
        plane, space = left(c), right(embedded(c)).directrix
        if all(plane[i].is_zero for i in range(2)):
            return vacuous(ZETA)
        if self._agree(plane, space):
            return Finding(PROVED, ZETA, ZETA)
        return Finding(REFUTED, ZETA, "another curve", witness=self.refuted_on_examples().witness or "not identical")

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The plane curve and the directrix, compared as quotients."""
        assert isinstance(argument, Curve)  # with its point
        plane, space = self.find(self.left)(argument), self.find(self.right)(embedded(argument)).directrix
        below = [denominator for _, denominator in map(split, (plane, space)) if denominator is not None]
        if not all(p for denominator in below for p in denominator.polynomials):
            return vacuous(ZETA, "does not exist here")
        if self._agree(plane, space):
            return Finding(VERIFIED, ZETA, ZETA)
        return Finding(REFUTED, ZETA, "another curve", witness="the two curves differ")

    def highest_derivative(self, dimension: int) -> int:
        """The right side is one in space."""
        return max(order_of(self.find(self.left), dimension), order_of(self.find(self.right), dimension + 1))

    def residues(self, c: Evaluated) -> list[JetFraction]:
        """The differences of the coordinates."""
        assert isinstance(c, Curve)
        plane, space = self.find(self.left)(c), self.find(self.right)(embedded(c)).directrix
        return [plane[0] - space[0], plane[1] - space[1], space[2]]

    def _agree(self, plane: Any, space: Any) -> bool:
        return bool(plane[0] == space[0] and plane[1] == space[1] and space[2].is_zero)
