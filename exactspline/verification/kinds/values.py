"""Claims about values: at a parameter, a limit, a bound or a distance on one curve, as in numerical examples; and that
no Bézier coefficient vanishes, or that all have a sign.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import field, replace
from itertools import pairwise
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError, ReachError
from exactspline.geometry.pairs.distance import distance
from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import CURVE
from exactspline.language.ruled import split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, point_text, text
from exactspline.numbers.intervals import Side
from exactspline.readings.bernstein_term import BernsteinTermReading, GenericReading, every_coefficient
from exactspline.readings.differential_order import is_polynomial
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, claim_kind, example_name, formula_name, number, numbers, one_of, read
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import At, Fact, ZeroAt
from exactspline.verification.kinds.examples import ExampleClaim, checked_interval
from exactspline.verification.kinds.zeros import continued, sign_found
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED, Finding, sampled, undecided, vacuous
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
                return Finding(REFUTED, Fact.ALL_VANISH, witness=say.all_are_zero(d))
            for i, parts in enumerate(zip(*[c.coefficients for c in components], strict=True)):
                if not any(parts):
                    return Finding(REFUTED, Fact.ONE_VANISHES, witness=say.coefficient_is_zero(i, d))
        degrees = say.for_degrees(GENERIC_DEGREES[0], GENERIC_DEGREES[-1])
        return sampled(Finding(VERIFIED, say.none_vanishes(degrees)), degrees)

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
                    witness = say.coefficient_here(i, self.formula, say.somewhere_on(*ends), point[0])
                    return Finding(REFUTED, fact, witness=witness)
        return Finding(VERIFIED, say.of_sign(self.sign) if self.sign else Fact.NONE_VANISHES)


def _is_decided(attempt: Callable[[], object]) -> bool:
    """Whether the evaluation mode of single terms is applicable, as for formulas linear in p and in w."""
    try:
        return attempt() is not None
    except FormulaError:
        return False


#: The sign of a value less its bound.
SIGNS = {"≤": Sign.NONPOSITIVE, "<": Sign.NEGATIVE, "≥": Sign.NONNEGATIVE, ">": Sign.POSITIVE}


def _compared_with(claim: Claim, name: str, value: str) -> tuple[str, mpq]:
    """A relation and a number.

    Raises `ClaimError` for any other text.
    """
    read_as = re.fullmatch(r"\s*(=|≤|<=?|≥|>=?)\s*(\S+)\s*", value)
    if read_as is None:
        raise ClaimError(f"{value!r} is no bound", where=name, remedy='write a relation and a number: "≤ 3/10"')
    return read_as[1].replace("<=", "≤").replace(">=", "≥"), number(claim, name, read_as[2])


def _bound(claim: Claim, name: str, value: str) -> str:
    relation, bound = _compared_with(claim, name, value)
    return f"{relation} {text(bound)}"


@claim_kind
class ValueClaim(ExampleClaim):
    """The value of ``formula`` at the ``parameter`` of the curve ``example`` is ``claimed``, a number or the components
    of a vector: exactly, and at a knot from both sides.
    """

    kind: ClassVar[str] = "at"
    notation: ClassVar[str] = "$formula($parameter) = $claims"

    formula: Name = field(metadata=read(formula_name))
    parameter: mpq = field(metadata=read(number))
    claimed: tuple[mpq, ...] = field(metadata=read(numbers))

    @property
    def claims(self) -> str:
        """The value."""
        return point_text(self.claimed) if self.claimed else "∞"

    def _value(self, formula: Any, side: Side) -> tuple[mpq, ...] | None:
        """The value from a side; None if it does not exist."""
        parts, below = split(formula)
        divisor = mpq(1) if below is None else below(self.parameter, side)
        return tuple(part(self.parameter, side) / divisor for part in parts) if divisor else None

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The values from each side (at an end of the domain there is one), compared with the claimed one."""
        formula = self.find(self.formula)(argument)
        for side in (Side.RIGHT, Side.LEFT):
            value = self._value(formula, side)
            if value is None:
                return vacuous(Fact.NO_VALUE_THERE)
            if value != self.claimed:
                place = At(self.parameter, side == Side.LEFT)
                return Finding(REFUTED, say.equal_to(value), witness=say.equal_there(value, place))
        return Finding(VERIFIED, say.equal_to(self.claimed))


def _limit(claim: Claim, name: str, value: Any) -> tuple[mpq, ...]:
    """Numbers, or no number for ∞."""
    return () if value == "∞" else numbers(claim, name, value)


@claim_kind
class Limit(ValueClaim):
    """The limit of ``formula`` at the ``parameter`` of the curve ``example`` is ``claimed``, or ∞: common zeros of
    numerator and denominator divided out.
    """

    kind: ClassVar[str] = "limit"
    notation: ClassVar[str] = r"\lim_{t \to $parameter} $formula = $claims"

    claimed: tuple[mpq, ...] = field(metadata=read(_limit))

    def _value(self, formula: Any, side: Side) -> tuple[mpq, ...] | None:
        """The value in lowest terms; no number for ∞."""
        return super()._value(continued(formula), side) or ()


@claim_kind
class Bound(ExampleClaim):
    """On the curve ``example``, or on a closed ``interval`` of its parameters, the value of ``formula`` (of a vector
    its length) satisfies the ``bound``, such as ``"≤ 3/10"``, wherever it exists, or can be continued: where numerator
    and denominator vanish together.
    """

    kind: ClassVar[str] = "bound"
    value: ClassVar[str] = "$bound"
    notation: ClassVar[str] = "$formula $bound"

    formula: Name = field(metadata=read(formula_name))
    bound: str = field(metadata=read(_bound))
    interval: tuple[mpq, ...] = field(default=(), metadata=read(checked_interval))

    def validate(self) -> None:
        """Reject an equation."""
        if self.bound[0] not in SIGNS:
            raise ClaimError("a bound is no equation", where="bound", remedy="claim two bounds, ≤ and ≥")

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The sign of the value less its bound; of a length that of the squares."""
        relation, bound = _compared_with(self, "bound", self.bound)
        parts, below = split(continued(self.find(self.formula)(argument)))
        top, is_length = parts[0], len(parts) > 1
        below = top.constant(1) if below is None else below
        if is_length:
            top, below, bound = sum((x * x for x in parts[1:]), top * top), below * below, bound * abs(bound)
        top, below = (x.restrict(*self.interval or own.curve.domain) for x in (top, below))
        rest = top - below * bound
        if rest.is_zero:
            return Finding(VERIFIED if relation in "≤≥" else REFUTED, Fact.EQUAL_EVERYWHERE)
        found = sign_found(rest, below, SIGNS[relation])
        if found.verdict == VERIFIED:
            return replace(found, computed=Fact.AS_CLAIMED)
        place: Any = found.witness.place if isinstance(found.witness, ZeroAt) else found.witness
        value = bound if isinstance(found.witness, ZeroAt) else top(place.parameter) / below(place.parameter)
        said = say.length_there if is_length else say.equal_there
        return Finding(REFUTED, Fact.NOT_SO, witness=said((value,), place))


@claim_kind
class DistanceClaim(ExampleClaim):
    """The distance of the curves ``example`` and ``other`` (of their nearest points) satisfies the ``bound``, such as
    ``"= 3/2"`` or ``"< 1/100"``.
    """

    kind: ClassVar[str] = "distance"
    value: ClassVar[str] = "$bound"
    notation: ClassVar[str] = r"\text{distance}($example, $other) $bound"

    other: str = field(metadata=read(example_name))
    bound: str = field(metadata=read(_bound))

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The squared distance, which is algebraic, compared with the square of the bound."""
        relation, bound = _compared_with(self, "bound", self.bound)
        found = distance(own.curve, self.curve_named(self.other))
        if found.undecided:
            return undecided(ReachError("; ".join(found.undecided)))
        excess = found.squared - bound * abs(bound)
        holds = SIGNS[relation].holds(excess) if relation in SIGNS else excess == 0
        return Finding(VERIFIED if holds else REFUTED, say.equal_to((found.value,)))
