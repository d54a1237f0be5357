"""Claims that no Bézier coefficient vanishes, or that all have a sign."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from itertools import pairwise
from typing import ClassVar

from exactspline.errors import ClaimError, FormulaError
from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import CURVE
from exactspline.language.vector import Vector
from exactspline.readings.bernstein_term import BernsteinTermReading, GenericReading, every_coefficient
from exactspline.readings.differential_order import is_polynomial
from exactspline.verification.claim import Claim, formula_name, one_of, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import (
    CoefficientIsZero,
    Fact,
    ForDegrees,
    HasSign,
    On,
    OnlyForDegrees,
    ZeroCoefficient,
)
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED, Finding, sampled, vacuous
from exactspline.verification.vocabulary import ArgumentKind, Curves, Extent, Name, Sign

#: The degrees for which the generic Bézier segment is computed.
GENERIC_DEGREES = range(2, 7)


@claim_kind
class Coefficients(Claim):
    """No Bézier coefficient of ``formula`` on any segment vanishes (for a vector: none is the zero vector), on every
    curve or on the generic Bézier curve; or, on one curve, all have the ``sign``.
    """

    kind: ClassVar[str] = "coefficients"
    value: ClassVar[str] = "none vanishes"

    formula: Name = field(metadata=read(formula_name))
    curves: Curves = field(default=Curves.EVERY, metadata=read(one_of(Curves)))
    sign: Sign | None = field(default=None, metadata=read(one_of(Sign)))

    def validate(self) -> None:
        """Reject formulas without coefficients: quotients, two curves, a point."""
        if self.curve not in (ArgumentKind.CURVE, ArgumentKind.PLANE, ArgumentKind.SPACE):
            raise ClaimError(f"coefficients of {str(self.curve)!r} are not decided", where="curve", remedy="a curve")
        if not all(is_polynomial(self.find(self.formula), n) for n in self.dimensions):
            raise ClaimError(f"{self.formula!r} is a quotient", where="formula", remedy="name a polynomial")
        if self.sign and self.on == Extent.ALL:
            raise ClaimError("signs on all curves", where="sign", remedy='write on = "curve" and example = "NAME"')

    @property
    def claims(self) -> str:
        """The statement about the coefficients."""
        return f"all are {self.sign}" if self.sign else self.value

    @property
    def latex(self) -> str:
        """The formula and the sign of its coefficients."""
        sign = str(self.sign or "≠ 0").replace("≥", r"\ge").replace("≤", r"\le").replace("≠", r"\neq")
        return rf"\text{{every Bernstein coefficient of}}\; {self.symbol(self.formula)} \;\text{{is}}\; {sign}"

    def applies_to(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """A generic claim does not apply to single curves."""
        return self.curves == Curves.EVERY and super().applies_to(dimension, polynomial, surface=surface)

    def for_all(self) -> tuple[Name, Finding]:
        """A claim about every curve can only be refuted, by a single curve; one about the generic curve is decided by
        computation.
        """
        if self.curves == Curves.EVERY:
            return Name("spline"), self.refuted_on_examples()
        return Name("generic"), super().for_all()[1]

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """No Bézier coefficient is the zero polynomial in indeterminate control points and weights: for all degrees
        together, or degree by degree.
        """
        formula = self.find(self.formula)
        if not polynomial and _is_decided(
            lambda: every_coefficient(formula(BernsteinTermReading().argument(CURVE, dimension)))
        ):
            return Finding(PROVED, Fact.NONE_VANISHES_FOR_ANY_DEGREE)
        for d in GENERIC_DEGREES:
            value = formula(GenericReading(d).argument(CURVE, dimension, polynomial=polynomial))
            components = list(value) if isinstance(value, Vector) else [value]
            if all(c.is_zero for c in components):
                return Finding(REFUTED, Fact.ALL_VANISH, witness=CoefficientIsZero(d))
            for i, parts in enumerate(zip(*[c.coefficients for c in components], strict=True)):
                if not any(parts):
                    return Finding(REFUTED, Fact.ONE_VANISHES, witness=CoefficientIsZero(d, i))
        degrees = ForDegrees(GENERIC_DEGREES[0], GENERIC_DEGREES[-1])
        return sampled(Finding(VERIFIED, OnlyForDegrees(degrees)), degrees)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The coefficients, checked segment by segment."""
        value = self.find(self.formula)(argument)
        components = list(value) if isinstance(value, Vector) else [value]
        if all(p.is_zero for p in components):
            return vacuous(Fact.ALL_VANISH)
        if self.sign:
            self.only_component(self.formula, components)
        segments = zip(*[p.bezier_points for p in components], strict=True)
        for ends, columns in zip(pairwise(components[0].breakpoints), segments, strict=True):
            for i, point in enumerate(zip(*columns, strict=True)):
                if not (self.sign.holds(point[0]) if self.sign else any(point)):
                    fact = Fact.NOT_SO if self.sign else Fact.ONE_VANISHES
                    return Finding(REFUTED, fact, witness=ZeroCoefficient(self.formula, i, On(*ends), point[0]))
        return Finding(VERIFIED, HasSign(self.sign) if self.sign else Fact.NONE_VANISHES)


def _is_decided(attempt: Callable[[], object]) -> bool:
    """Whether the evaluation mode of single terms is applicable, as for formulas linear in p and in w."""
    try:
        return attempt() is not None
    except FormulaError:
        return False
