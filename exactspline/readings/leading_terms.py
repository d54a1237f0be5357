"""The reading at infinity: the leading coefficients in the power basis, for symbolic degree d.

A component of the curve is ``t^d (a_0 + a_1/t + a_2/t² + …)`` with indeterminate a_i, and its k-th derivative has the
coefficients ``(d − i)(d − i − 1)…(d − i − k + 1) a_i``. What a formula returns is known to a few terms of its
expansion; how many of them vanish tells how far the true degree lies below the nominal one, for all d at once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from exactspline.errors import FormulaError
from exactspline.exact import rational, to_fmpq
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import PARAMETERS, Curve
from exactspline.language.kinds import Kind, Symbol, kind_of
from exactspline.language.operand import CONSTANTS, Operand
from exactspline.language.reading import Reading
from exactspline.language.vector import Vector
from exactspline.readings.differential_order import order_of

#: More vanishing terms than any formula of the library has.
MAX_TERMS = 40


class Expansion(Operand):
    """``t^(k d − m) (c_0 + c_1/t + …)``: the polynomial c_i in d and the coefficients of the curve."""

    __slots__ = ("context", "k", "m", "terms")
    provenance = 0

    def __init__(self, context: Any, k: int, m: int, terms: list[fmpq_mpoly]) -> None:
        self.context, self.k, self.m, self.terms = context, k, m, terms

    @property
    def degree(self) -> int:
        """Degree k in the curve."""
        return self.k

    def constant(self, value: Any) -> Expansion:
        """A constant: it expands to itself."""
        zero = self.context.constant(0)
        return Expansion(
            self.context, 0, 0, [self.context.constant(to_fmpq(rational(value))), *[zero] * (len(self.terms) - 1)]
        )

    def __add__(self, other: Any) -> Any:
        if isinstance(other, CONSTANTS):
            other = self.constant(other)
        if not isinstance(other, Expansion):
            return NotImplemented
        if not any(self.terms):
            return other
        if not any(other.terms):
            return self
        if (self.k, self.m) != (other.k, other.m):
            raise FormulaError(
                f"a sum of terms of degree and weight {(self.k, self.m)} and {(other.k, other.m)}",
                remedy="homogeneous formulas of rational curves only",
            )
        return Expansion(self.context, self.k, self.m, [a + b for a, b in zip(self.terms, other.terms, strict=True)])

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if not isinstance(other, Expansion):
            return NotImplemented
        a, b = self.terms, other.terms
        terms = [sum((a[j] * b[i - j] for j in range(i + 1)), self.context.constant(0)) for i in range(len(a))]
        return Expansion(self.context, self.k + other.k, self.m + other.m, terms)

    def scaled(self, constant: Any) -> Expansion:
        """The expansion times an exact constant."""
        q = to_fmpq(rational(constant))
        return Expansion(self.context, self.k, self.m, [q * a for a in self.terms])

    def elevated_to(self, other: Any) -> Expansion:
        """Itself: degree elevation does not change a function."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> Expansion:
        """The derivative, term by term."""
        self.only_parameter(by)
        result, d = self, self.context.gens()[0]
        for _ in range(order):
            terms = [(result.k * d - (result.m + i)) * a for i, a in enumerate(result.terms)]
            result = Expansion(self.context, result.k, result.m + 1, terms)
        return result

    @property
    def drop(self) -> int | None:
        """How many leading terms vanish identically in d; None when all known ones do."""
        return next((i for i, a in enumerate(self.terms) if a), None)

    @property
    def exceptions(self) -> tuple[int, ...]:
        """The degrees d ≥ 1 at which the first remaining term vanishes too."""
        return common_roots(self.terms[self.drop or 0])


def common_roots(polynomial: fmpq_mpoly) -> tuple[int, ...]:
    """The integers d ≥ 1 at which a polynomial in d (its first variable) and others vanishes for all values of the
    others.
    """
    common = fmpq_poly([])
    grouped: dict[tuple[int, ...], dict[int, Any]] = {}
    for exponents, c in polynomial.terms():
        e = tuple(map(int, exponents))
        grouped.setdefault(e[1:], {})[e[0]] = c
    for powers in grouped.values():
        common = common.gcd(fmpq_poly([powers.get(i, 0) for i in range(max(powers) + 1)]))
    return tuple(
        sorted(
            int(-p[0] / p[1])
            for p, _ in common.numer().factor()[1]
            if p.degree() == 1 and p[0] % p[1] == 0 and -p[0] / p[1] >= 1
        )
    )


class StillExpansion(Expansion):
    """What does not depend on the parameter that goes to infinity: a constant there, and so are its derivatives by a
    parameter of its own.
    """

    __slots__ = ("derivatives",)

    derivatives: list[StillExpansion]

    def d(self, order: int = 1, *, by: str | None = None) -> StillExpansion:
        """The derivative of that order: another constant."""
        return self.derivatives[order]


class LeadingTermsReading(Reading):
    """Leading coefficients at infinity of the first parameter, to so many terms, with derivatives up to an order of
    what does not depend on it: the second curve and the point stay constant.
    """

    name = "infinity"
    proves = "the true degree on the generic curve, for every d but those named"

    def __init__(self, terms: int, order: int = 0) -> None:
        self.terms, self.order = terms, order

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """Expansions of the functions of s; constants for everything else."""
        symbols = kind.symbols(dimension, polynomial=polynomial)
        lengths = {s.name: self.terms if s.parameter == PARAMETERS[0] else self.order + 1 for s in symbols}
        names = [f"{name}{i}" for name, length in lengths.items() for i in range(length)]
        context = fmpq_mpoly_ctx.get(["d", *names], Ordering.degrevlex)
        known = dict(zip(names, context.gens()[1:], strict=True))
        nothing = [context.constant(0)] * (self.terms - 1)

        def operand(symbol: Symbol) -> Expansion:
            own = [known[f"{symbol.name}{i}"] for i in range(lengths[symbol.name])]
            if symbol.parameter == PARAMETERS[0]:
                return Expansion(context, 1, 0, own)
            constants = [StillExpansion(context, 0, 0, [c, *nothing]) for c in own]
            constants[0].derivatives = constants
            return constants[0]

        one = Expansion(context, 0, 0, [context.constant(1), *nothing])
        return kind.argument(dimension, operand, one, polynomial=polynomial)


def expansion_argument(kind: str, dimension: int, terms: int, order: int, *, polynomial: bool = False) -> Any:
    """What formulas of a kind are handed at infinity of the first parameter."""
    return LeadingTermsReading(terms, order).argument(kind_of(kind), dimension, polynomial=polynomial)


def expansion_curve(dimension: int, terms: int, *, polynomial: bool = False) -> Curve:
    """The generic curve at infinity, to so many terms."""
    curve: Curve = expansion_argument("curve", dimension, terms, 0, polynomial=polynomial)
    return curve


def generic_drop(formula: Any, dimension: int) -> tuple[int, int, int, tuple[int, ...]]:
    """``(k, m, drop, exceptions)``: on the generic rational curve of degree d the formula has true degree ``k d − m −
    drop``.

    Proved for every d ≥ drop (so that the coefficients exist) but the exceptions, where it is lower. A vector has the
    largest degree of its components.

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D1
    >>> generic_drop(D1, 2)
    (2, 1, 1, ())

    Raises `FormulaError` for formulas that are no polynomial of the curve, or not homogeneous.
    """
    order = order_of(formula, dimension)
    return drop_of(formula, lambda terms: expansion_argument(formula.curve, dimension, terms, order), formula.name)


def drop_of(
    formula: Callable[[Any], Any], curve: Callable[[int], Any], name: str
) -> tuple[int, int, int, tuple[int, ...]]:
    """The same for any function of a curve at infinity that is known to as many terms as needed."""
    for terms in range(1, MAX_TERMS):
        result = formula(curve(terms))
        components = list(result) if isinstance(result, Vector) else [result]
        if not all(isinstance(c, Expansion) for c in components):
            raise FormulaError(f"{name} is a quotient", remedy="ask for numerator and denominator one by one")
        found = [c for c in components if c.drop is not None]
        if found:
            best = min(found, key=lambda c: c.drop)
            exceptions = set(best.exceptions).intersection(*[set(c.exceptions) for c in found if c.drop == best.drop])
            return best.k, best.m, best.drop, tuple(sorted(exceptions))
    raise FormulaError(f"{name} vanishes to {MAX_TERMS} terms", remedy="it may be identically zero")
