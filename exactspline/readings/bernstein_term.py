"""Two readings of a segment in the scaled Bernstein basis.

The generic reading is one Bézier segment of a given degree whose control points and weights are indeterminates. The
Bézier coefficients of the value of a formula are polynomials in these indeterminates; a coefficient that is not the
zero polynomial vanishes only on special curves.

The monomial reading is a single term of the curve, for symbolic degree d. Numerators are the monomial ``u^(d − a) v^a``
and the denominator is ``u^(d − b) v^b`` with symbolic a and b. A formula that is linear in p and in w returns a few
monomials, whose exponents differ by small integers from those of the product of p and w. Their coefficients are
polynomials in d, a and b: the coefficients of ``p_a w_b`` in every scaled Bernstein coefficient of the result, for all
degrees d.
"""

from __future__ import annotations

from collections import defaultdict
from math import comb

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


class Generic(RingOperand):
    """Scaled Bernstein coefficients ``c_i = C(n, i) b_i``, n+1 of them."""

    __slots__ = ("coefficients", "context")
    provenance = 0

    def __init__(self, context: fmpq_mpoly_ctx, coefficients: list[fmpq_mpoly]) -> None:
        self.context, self.coefficients = context, coefficients

    @property
    def degree(self) -> int:
        """The formal degree."""
        return len(self.coefficients) - 1

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve of this degree."""
        return not any(self.coefficients)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Generic) and self.coefficients == other.coefficients

    __hash__ = None  # type: ignore[assignment]  # not hashable

    def constant(self, value: Constant) -> Generic:
        """A constant of degree 0."""
        return Generic(self.context, [self.context.constant(to_fmpq(rational(value)))])

    def elevated_to(self, other: Generic) -> Generic:
        """The same function, elevated to at least the degree of `other`."""
        by = other.degree - self.degree
        return (
            self
            if by <= 0
            else self * Generic(self.context, [self.context.constant(comb(by, i)) for i in range(by + 1)])
        )

    def _plus(self, right: Generic) -> Generic:
        a, b = self.elevated_to(right), right.elevated_to(self)
        return Generic(self.context, [x + y for x, y in zip(a.coefficients, b.coefficients, strict=True)])

    def _times(self, right: Generic) -> Generic:
        zero = self.context.constant(0)
        product = [zero] * (self.degree + right.degree + 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(right.coefficients):
                product[i + j] += x * y
        return Generic(self.context, product)

    def scaled(self, constant: Constant) -> Generic:
        """The form times an exact constant."""
        q = to_fmpq(rational(constant))
        return Generic(self.context, [q * x for x in self.coefficients])

    def _first_derivative(self, by: str | None) -> Generic:
        """The derivative with respect to the parameter of the segment."""
        self.only_parameter(by)
        c, n = self.coefficients, self.degree
        return Generic(self.context, [(i + 1) * c[i + 1] - (n - i) * c[i] for i in range(n)])


class GenericReading(Reading):
    """One Bézier segment of a given degree, whose control points and weights are indeterminates.

    >>> from exactspline.language.kinds import CURVE
    >>> c = GenericReading(2).argument(CURVE, 2)
    >>> len(c.w.d(1).coefficients), c.w.d(3).is_zero
    (2, True)
    """

    name = "generic"

    def __init__(self, degree: int) -> None:
        self.degree = degree

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument as functions of the only parameter.

        Raises `FormulaError` for a kind with several parameters, or with constants.
        """
        symbols = freely_differentiable(kind, self, dimension, polynomial=polynomial)
        if len({parameter for symbol in symbols for parameter in symbol.parameters}) > 1:
            raise FormulaError(
                f"a generic segment of {kind!r}", remedy="this reading applies to functions of one parameter"
            )
        names = [f"{symbol.name}_{i}" for symbol in symbols for i in range(self.degree + 1)]
        context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        gens, size = context.gens(), self.degree + 1
        functions = {
            symbol.name: Generic(context, [comb(self.degree, i) * gens[k * size + i] for i in range(size)])
            for k, symbol in enumerate(symbols)
        }
        one = Generic(context, [context.constant(1)])
        return kind.argument(dimension, lambda symbol: functions[symbol.name], one, polynomial=polynomial)


class _Monomials(RingOperand):
    """``Σ c_ij u^(U − i) v^(V − j)``: the exponents U and V and the c_ij are polynomials in d, a and b."""

    __slots__ = ("exponents", "terms")
    degree = provenance = 0

    def __init__(self, exponents: tuple[fmpq_mpoly, fmpq_mpoly], terms: dict[tuple[int, int], fmpq_mpoly]) -> None:
        self.exponents, self.terms = exponents, {shift: c for shift, c in terms.items() if c}

    def constant(self, value: Constant) -> _Monomials:
        """An exact constant."""
        zero = self.exponents[0] * 0
        return _Monomials((zero, zero), {(0, 0): zero + to_fmpq(rational(value))})

    def _plus(self, right: _Monomials) -> _Monomials:
        if self.exponents != right.exponents:
            problem = "a sum of terms of different degrees in p or in w"
            raise FormulaError(problem, remedy="this reading requires formulas homogeneous in both")
        terms = self._no_terms() | self.terms
        for shift, c in right.terms.items():
            terms[shift] += c
        return _Monomials(self.exponents, terms)

    def _no_terms(self) -> defaultdict[tuple[int, int], fmpq_mpoly]:
        zero = self.exponents[0] * 0
        return defaultdict(lambda: zero)

    def _times(self, right: _Monomials) -> _Monomials:
        terms = self._no_terms()
        for (i, j), x in self.terms.items():
            for (k, m), y in right.terms.items():
                terms[i + k, j + m] += x * y
        (u, v), (s, t) = self.exponents, right.exponents
        return _Monomials((u + s, v + t), terms)

    def scaled(self, constant: Constant) -> _Monomials:
        """The terms times an exact constant."""
        q = to_fmpq(rational(constant))
        return _Monomials(self.exponents, {shift: c * q for shift, c in self.terms.items()})

    def _first_derivative(self, by: str | None) -> _Monomials:
        """``(∂v − ∂u)``, the derivative with respect to the local parameter, term by term."""
        self.only_parameter(by)
        terms, (u, v) = self._no_terms(), self.exponents
        for (i, j), c in self.terms.items():
            terms[i, j + 1] += c * (v - j)
            terms[i + 1, j] -= c * (u - i)
        return _Monomials(self.exponents, terms)

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
        numerator, denominator = _Monomials((d - a, a), terms), _Monomials((d - b, b), terms)
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
    if not isinstance(c, _Monomials) or set(c.terms) != {(0, 1), (1, 0)}:
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
