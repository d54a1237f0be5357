"""The fraction reading: quotients of differential polynomials in lowest terms.

The jet reading computes by the naive algorithm; this one computes the function itself and cancels common factors after
every operation. This proves identities between large naive expressions without expanding them.
"""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly
from flint.utils.flint_exceptions import DomainError

from exactspline.errors import VanishingDivisorError
from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant, FieldOperand
from exactspline.numbers.exact import rational, to_fmpq
from exactspline.one_line import one_line
from exactspline.polynomials.factors import bounded_product, greatest_common_divisor
from exactspline.readings.jet import IndeterminateReading, Jet, JetRing, Terms, terms_of

#: Numerators with more terms are long.
LONG = 1000


class JetFraction(FieldOperand):
    """``top / bottom`` without common factors, with monic `bottom`.

    >>> from exactspline.language.kinds import CURVE

    >>> from exactspline.readings.rational_jet import RationalJetReading

    >>> c = RationalJetReading(1).argument(CURVE, 2)
    >>> (c.gamma[0] * c.w).top == c.p[0].top
    True
    """

    __slots__ = ("bottom", "ring", "top")
    degree = provenance = 0

    def __init__(self, ring: JetRing, top: fmpq_mpoly, bottom: fmpq_mpoly) -> None:
        self.ring, self.top, self.bottom = ring, top, bottom

    def __reduce__(self) -> tuple[object, ...]:
        return _fraction, (self.ring, terms_of(self.top), terms_of(self.bottom))

    def constant(self, value: Constant) -> JetFraction:
        """An exact constant."""
        return JetFraction(self.ring, self.ring.number(value).polynomial, self.ring.context.constant(1))

    def _plus(self, right: JetFraction) -> JetFraction:
        if self.bottom.is_one() and right.bottom.is_one():
            return JetFraction(self.ring, self.top + right.top, self.bottom)
        if self.bottom == right.bottom:
            return JetFraction(self.ring, *_without_common(self.top + right.top, self.bottom))
        if self.bottom.is_one() or right.bottom.is_one():
            # has no common factor with the other denominator
            top = bounded_product(self.top, right.bottom) + bounded_product(right.top, self.bottom)
            return JetFraction(self.ring, top, bounded_product(self.bottom, right.bottom))
        shared = _gcd(self.bottom, right.bottom)
        mine, its = self.bottom / shared, right.bottom / shared
        top, rest = _without_common(bounded_product(self.top, its) + bounded_product(right.top, mine), shared)
        return JetFraction(self.ring, top, bounded_product(bounded_product(mine, its), rest))

    def _times(self, right: JetFraction) -> JetFraction:
        if self.bottom.is_one() and right.bottom.is_one():
            return JetFraction(self.ring, bounded_product(self.top, right.top), self.bottom)
        if self is right:
            return JetFraction(self.ring, *(bounded_product(part, part) for part in (self.top, self.bottom)))
        first, below = _without_common(self.top, right.bottom)
        second, beneath = _without_common(right.top, self.bottom)
        return JetFraction(self.ring, bounded_product(first, second), bounded_product(beneath, below))

    def reciprocal(self) -> JetFraction:
        """``1 / a``; raises `VanishingDivisorError` for zero."""
        if not self.top:
            raise VanishingDivisorError(
                "division by an expression that vanishes identically", remedy="check the formula"
            )
        unit = self.top.leading_coefficient()
        return JetFraction(self.ring, self.bottom / unit, self.top / unit)

    def scaled(self, constant: Constant) -> JetFraction:
        """The fraction times an exact constant."""
        factor = to_fmpq(rational(constant))
        return JetFraction(self.ring, self.top * factor, self.bottom if factor else self.ring.context.constant(1))

    def _first_derivative(self, by: str | None) -> JetFraction:
        """The total derivative."""
        top, bottom = Jet(self.ring, self.top), Jet(self.ring, self.bottom)
        if self.bottom.is_one():
            return JetFraction(self.ring, top.d(by=by).polynomial, self.bottom)
        numerator = (top.d(by=by) * bottom - top * bottom.d(by=by)).polynomial
        shared = _gcd(numerator, self.bottom)
        rest = self.bottom / shared
        again = _gcd(numerator / shared, self.bottom)
        return JetFraction(self.ring, numerator / shared / again, bounded_product(rest, self.bottom / again))

    @property
    def is_zero(self) -> bool:
        """Whether it vanishes on every curve."""
        return not self.top

    @property
    def is_long(self) -> bool:
        """Whether products of such values are too long to be multiplied out as they come."""
        return len(self.top) > LONG

    def __eq__(self, other: object) -> bool:
        """Whether both are the same quotient. Values of this reading are in lowest terms, so that equal values have
        equal representations. Different representations are still compared by cross-multiplication, unless their values
        at one point differ.
        """
        if not isinstance(other, JetFraction):
            return False
        if self.bottom == other.bottom:
            return bool(self.top == other.top)
        if self._at_a_point(other.bottom) != other._at_a_point(self.bottom):
            return False
        return bool(bounded_product(self.top, other.bottom) == bounded_product(other.top, self.bottom))

    def _at_a_point(self, factor: fmpq_mpoly) -> fmpq:
        """The numerator times a polynomial, at one point of small integers."""
        point = range(2, 2 + len(self.ring.gens))
        value: fmpq = self.top(*point) * factor(*point)
        return value

    __hash__ = None  # type: ignore[assignment]  # not hashable

    @one_line
    def __repr__(self) -> str:
        return f"({Jet(self.ring, self.top)!r}) / ({Jet(self.ring, self.bottom)!r})"


def _fraction(ring: JetRing, top: Terms, bottom: Terms) -> JetFraction:
    """Unpickles a fraction."""
    return JetFraction(ring, ring.of_terms(top), ring.of_terms(bottom))


def _without_common(top: fmpq_mpoly, bottom: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """Two polynomials divided by their greatest common divisor."""
    if bottom.is_one():
        return top, bottom
    common = _gcd(top, bottom)
    return (top, bottom) if common.is_one() else (top / common, bottom / common)


def _gcd(a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
    """The monic greatest common divisor (of 0 and b: b made monic)."""
    common = b if len(a) >= len(b) and _divides(b, a) else greatest_common_divisor([a, b])
    return common / common.leading_coefficient() if common else common


def _divides(b: fmpq_mpoly, a: fmpq_mpoly) -> bool:
    """Whether b divides a. A negative answer usually follows from the first terms, far cheaper than a gcd."""
    try:
        a / b
    except (DomainError, ZeroDivisionError):
        return False
    return True


class RationalJetReading(IndeterminateReading):
    """The argument with indeterminate operands, whose quotients are in lowest terms."""

    name = "rational jet"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument in which every operand is an indeterminate."""
        ring = JetRing(kind, dimension, self.order, polynomial=polynomial)

        def fraction(x: Jet) -> JetFraction:
            return JetFraction(ring, x.polynomial, ring.context.constant(1))

        one = fraction(ring.number(1))
        return kind.argument(dimension, lambda symbol: fraction(ring[symbol.name]), one, polynomial=polynomial)
