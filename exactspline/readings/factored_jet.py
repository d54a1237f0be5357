"""The factored reading: differential polynomials kept as products, expanded only when a sum requires it.

The numerator of a naive computation is usually a product of the same few factors; kept separate, they need not be found
again by factorization. Sums factor out the common factors of both sides.
"""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly
from flint.utils.flint_exceptions import DomainError

from exactspline.language.arguments import Evaluated
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant, Operand
from exactspline.language.provenance import DERIVATIVE, DIFFERENCE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, leaf
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import rational, to_fmpq
from exactspline.one_line import one_line
from exactspline.polynomials.factors import Factorization, bounded_product
from exactspline.readings.jet import IndeterminateReading, Jet, JetReading, JetRing

#: Sums with more terms are tested for divisibility by factors met before that are shorter.
LONG = 100
#: Monic polynomials with exponents.
Powers = Factorization[fmpq_mpoly]
ONE = Powers()


class FactoredJet(RingOperand):
    """``unit · Π baseᵉ``; the bases are monic but need not be irreducible.

    >>> from exactspline.language.kinds import CURVE

    >>> from exactspline.readings.factored_jet import FactoredJetReading

    >>> c = FactoredJetReading(1).argument(CURVE, 2)
    >>> print((c.p[0] * c.w * c.w + c.p[1] * c.w).powers)
    w0 x0*w0 + y0
    """

    __slots__ = ("powers", "provenance", "ring", "unit")
    degree = 0

    def __init__(self, ring: JetRing, unit: fmpq, powers: Powers, provenance: Provenance | None = None) -> None:
        self.ring, self.unit, self.powers = ring, unit, powers
        self.provenance = leaf() if provenance is None else provenance

    @classmethod
    def of(cls, jet: Jet) -> FactoredJet:
        """A differential polynomial as one base."""
        return _product(jet.ring, jet.polynomial, ONE, jet.provenance)

    def constant(self, value: Constant) -> FactoredJet:
        """An exact constant."""
        return FactoredJet(self.ring, to_fmpq(rational(value)), ONE, (MULTIPLE, UNIT, rational(value)))

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return bool(self.unit == 0)

    def expanded(self) -> fmpq_mpoly:
        """The expanded polynomial."""
        return multiplied(self.ring, self.powers) * self.unit

    def _times(self, right: FactoredJet) -> FactoredJet:
        provenance = (PRODUCT, self.provenance, right.provenance)
        if self.is_zero or right.is_zero:
            return FactoredJet(self.ring, fmpq(0), ONE, provenance)
        powers = self.powers * right.powers
        _remember(self.ring, powers)
        return FactoredJet(self.ring, self.unit * right.unit, powers, provenance)

    def __add__(self, other: object) -> FactoredJet:
        return self._sum(other, 1, SUM)

    def __sub__(self, other: object) -> FactoredJet:
        return self._sum(other, -1, DIFFERENCE)

    def _sum(self, other: object, sign: int, name: int) -> FactoredJet:
        right = self.coerced(other)
        if right is None:
            refused: FactoredJet = NotImplemented
            return refused
        provenance = (name, self.provenance, right.provenance)
        if self.is_zero or right.is_zero:
            left = self if right.is_zero else right
            return FactoredJet(self.ring, left.unit * (sign if left is right else 1), left.powers, provenance)
        common = self.powers.shared(right.powers)
        a = multiplied(self.ring, self.powers.without(common)) * self.unit
        b = multiplied(self.ring, right.powers.without(common)) * right.unit
        return _product(self.ring, a + sign * b, common, provenance)

    def scaled(self, constant: Constant) -> FactoredJet:
        """The polynomial times an exact constant."""
        unit = self.unit * to_fmpq(rational(constant))
        return FactoredJet(
            self.ring, unit, self.powers if unit else ONE, (MULTIPLE, self.provenance, rational(constant))
        )

    def _first_derivative(self, by: str | None) -> FactoredJet:
        """The total derivative, by the product rule for all factors."""
        ring, total = self.ring, self.ring.context.constant(0)
        for i, (p, e) in enumerate(self.powers):
            others = Powers((q, 1) for j, (q, _) in enumerate(self.powers) if j != i)
            total += e * bounded_product(Jet(ring, p).d(by=by).polynomial, multiplied(ring, others))
        lowered = Powers((p, e - 1) for p, e in self.powers)
        return _product(ring, total * self.unit, lowered, (DERIVATIVE, self.provenance))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, FactoredJet):
            return NotImplemented
        common = self.powers.shared(other.powers)
        left, right = self.powers.without(common), other.powers.without(common)
        return bool(multiplied(self.ring, left) * self.unit == multiplied(self.ring, right) * other.unit)

    __hash__ = None  # type: ignore[assignment]  # not hashable

    @one_line
    def __repr__(self) -> str:
        return repr(Jet(self.ring, self.expanded()))


def _product(ring: JetRing, p: fmpq_mpoly, powers: Powers, provenance: Provenance) -> FactoredJet:
    """A polynomial times powers, made monic and with the variables that divide it factored out."""
    if not p:
        return FactoredJet(ring, fmpq(0), ONE, provenance)
    unit = p.leading_coefficient()
    p = p / unit
    content = p.term_content()
    content = content / content.leading_coefficient()
    variables = Powers((x, int(e)) for x, e in zip(ring.gens, content.degrees(), strict=True))
    rest, divided = p / content, powers * variables
    if len(rest) > LONG:
        for q in ring.repeated:
            times, (rest,) = divided_out([rest], q)
            divided = divided * Powers([(q, times)])
    return FactoredJet(ring, unit, divided * Powers([(rest, 1)]) if rest.total_degree() > 0 else divided, provenance)


def _remember(ring: JetRing, powers: Powers) -> None:
    for p, e in powers:
        if e > 1 and 1 < len(p) < LONG and all(p != q for q in ring.repeated):
            ring.repeated.append(p)


def divided_out(polynomials: list[fmpq_mpoly], q: fmpq_mpoly) -> tuple[int, list[fmpq_mpoly]]:
    """The multiplicity of q as a common factor of polynomials that are not all zero, and the cofactors."""
    times = 0
    while True:
        try:
            polynomials = [p / q for p in polynomials]  # the loop stops at the first remainder
        except DomainError:
            return times, polynomials
        times += 1


def multiplied(ring: JetRing, powers: Powers) -> fmpq_mpoly:
    """The expanded product; short factors are multiplied last.

    Raises `FormulaError` if it is too large.
    """
    result = ring.context.constant(1)
    for base, e in sorted(powers, key=lambda power: -len(power[0])):
        for _ in range(e):
            result = bounded_product(result, base)
    return result


def _factored(operand: Operand) -> FactoredJet:
    assert isinstance(operand, Jet)  # the operands of the jet reading
    return FactoredJet.of(operand)


class FactoredJetReading(IndeterminateReading):
    """The argument with indeterminate operands, whose products stay products."""

    name = "factored jet"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument in which every operand is an indeterminate."""
        return JetReading(self.order).argument(kind, dimension, polynomial=polynomial).mapped(_factored)
