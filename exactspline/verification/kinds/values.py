"""Claims about values on one curve, as in numerical examples: a value at a parameter, a limit, a bound, a distance."""

from __future__ import annotations

import re
from dataclasses import field, replace
from typing import Any, ClassVar

from exactspline.errors import ClaimError, ReachError
from exactspline.geometry.pairs.distance import distance
from exactspline.language.arguments import Evaluated
from exactspline.language.ruled import split
from exactspline.numbers.exact import mpq, point_text, text
from exactspline.numbers.intervals import Side
from exactspline.verification.claim import Claim, example_name, formula_name, number, numbers, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import At, Fact, Value, ValueAt, ZeroAt
from exactspline.verification.kinds.examples import ExampleClaim, checked_interval
from exactspline.verification.kinds.zeros import continued, sign_found
from exactspline.verification.verdict import REFUTED, VERIFIED, Finding, undecided, vacuous
from exactspline.verification.vocabulary import Name, Sign

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
                return Finding(REFUTED, Value(value), witness=ValueAt(value, At(self.parameter, side == Side.LEFT)))
        return Finding(VERIFIED, Value(self.claimed))


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
        return Finding(REFUTED, Fact.NOT_SO, witness=ValueAt((value,), place, is_length))


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
        return Finding(VERIFIED if holds else REFUTED, Value((found.value,)))
