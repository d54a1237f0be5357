"""The monomial reading: a single term of the curve in the scaled Bernstein basis, for symbolic degree d.

Numerators are the monomial ``u^(d − a) v^a`` and the denominator is ``u^(d − b) v^b`` with symbolic a and b. A formula
that is linear in p and in w returns a few monomials, whose exponents differ by small integers from those of the product
of p and w. Their coefficients are polynomials in d, a and b: the coefficients of ``p_a w_b`` in every scaled Bernstein
coefficient of the result, for all degrees d.
"""

from __future__ import annotations

from collections import defaultdict

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from exactspline.errors import FormulaError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Reading, freely_differentiable
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant
from exactspline.language.rational import RingOperand
from exactspline.language.ruled import Value
from exactspline.language.vector import Vector
from exactspline.numbers.exact import from_flint, mpq, rational, to_fmpq


class Monomials(RingOperand):
    """``Σ c_ij u^(U − i) v^(V − j)``: the exponents U and V and the c_ij are polynomials in d, a and b."""

    __slots__ = ("exponents", "terms")
    degree = provenance = 0

    def __init__(self, exponents: tuple[fmpq_mpoly, fmpq_mpoly], terms: dict[tuple[int, int], fmpq_mpoly]) -> None:
        self.exponents, self.terms = exponents, {shift: c for shift, c in terms.items() if c}

    def constant(self, value: Constant) -> Monomials:
        """An exact constant."""
        zero = self.exponents[0] * 0
        return Monomials((zero, zero), {(0, 0): zero + to_fmpq(rational(value))})

    def _plus(self, right: Monomials) -> Monomials:
        if self.exponents != right.exponents:
            problem = "a sum of terms of different degrees in p or in w"
            raise FormulaError(problem, remedy="this reading requires formulas homogeneous in both")
        terms = self._no_terms() | self.terms
        for shift, c in right.terms.items():
            terms[shift] += c
        return Monomials(self.exponents, terms)

    def _no_terms(self) -> defaultdict[tuple[int, int], fmpq_mpoly]:
        zero = self.exponents[0] * 0
        return defaultdict(lambda: zero)

    def _times(self, right: Monomials) -> Monomials:
        terms = self._no_terms()
        for (i, j), x in self.terms.items():
            for (k, m), y in right.terms.items():
                terms[i + k, j + m] += x * y
        (u, v), (s, t) = self.exponents, right.exponents
        return Monomials((u + s, v + t), terms)

    def scaled(self, constant: Constant) -> Monomials:
        """The terms times an exact constant."""
        q = to_fmpq(rational(constant))
        return Monomials(self.exponents, {shift: c * q for shift, c in self.terms.items()})

    def _first_derivative(self, by: str | None) -> Monomials:
        """``(∂v − ∂u)``, the derivative with respect to the local parameter, term by term."""
        self.only_parameter(by)
        terms, (u, v) = self._no_terms(), self.exponents
        for (i, j), c in self.terms.items():
            terms[i, j + 1] += c * (v - j)
            terms[i + 1, j] -= c * (u - i)
        return Monomials(self.exponents, terms)

    @property
    def is_zero(self) -> bool:
        """Whether the sum is zero: it has no terms."""
        return not self.terms


class BernsteinTermReading(Reading):
    """One term of the rational curve of degree d.

    >>> from exactspline.language.kinds import CURVE
    >>> c = BernsteinTermReading().argument(CURVE, 2)
    >>> (c.p.d(1)[0] * c.w - c.p[0] * c.w.d(1)).terms
    {(0, 1): a - b, (1, 0): a - b}
    """

    name = "term"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument with one term for all numerators and another one for the denominators."""
        freely_differentiable(kind, self, dimension)
        context = fmpq_mpoly_ctx.get(["d", "a", "b"], Ordering.degrevlex)
        d, a, b = context.gens()
        terms = {(0, 0): context.constant(1)}
        numerator, denominator = Monomials((d - a, a), terms), Monomials((d - b, b), terms)
        one = numerator.constant(1)
        return kind.argument(
            dimension,
            lambda symbol: denominator if symbol.name in ("w", "W") else numerator,
            one,
            polynomial=polynomial,
        )


def every_coefficient(value: Value) -> tuple[mpq, mpq] | None:
    """A proof that no scaled Bernstein coefficient of a vector that is linear in p and in w is identically zero, for
    every degree d ≥ 1, or None.

    The vector has degree 2d − 1. For k = 0 … d − 1, its coefficients 2k and 2k + 1 contain the product ``p_(k+1) w_k``
    with the two factors returned, which are not zero. (For fixed a and b different terms contribute to different
    coefficients, so that nothing cancels.)

    >>> from exactspline.language.kinds import CURVE

    >>> from exactspline.readings.bernstein_term import BernsteinTermReading

    >>> c = BernsteinTermReading().argument(CURVE, 2)
    >>> every_coefficient(c.p.d(1) * c.w - c.p * c.w.d(1)), every_coefficient(c.p.d(1) * c.w.d(1))
    ((mpq(1,1), mpq(1,1)), None)
    """
    c = value[0] if isinstance(value, Vector) else None
    if not isinstance(c, Monomials) or set(c.terms) != {(0, 1), (1, 0)}:
        return None
    u, v = c.exponents
    d, a, b = u.context().gens()
    if (u, v) != (2 * d - a - b, a + b):
        return None
    # at a = k + 1, b = k the exponents of v are 2k and 2k + 1
    even, odd = (c.terms[shift].compose(d, b + 1, b, ctx=u.context()) for shift in ((0, 1), (1, 0)))
    if not all(n.is_constant() and n for n in (even, odd)):
        return None
    first, second = (from_flint(n.leading_coefficient()) for n in (even, odd))
    return first, second
