"""The reading at infinity: leading coefficients in the power basis, for symbolic degree d.

A component of the curve is ``t^d (a_0 + a_1/t + a_2/t² + …)`` with indeterminate a_i, and its k-th derivative has the
coefficients ``(d − i)(d − i − 1)…(d − i − k + 1) a_i``. The value of a formula is known to a few terms of its
expansion; the number of leading terms that vanish is the nominal degree minus the true degree, for all d.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from typing import Any, NamedTuple

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from exactspline.errors import FormulaError
from exactspline.language.arguments import PARAMETERS, Evaluated
from exactspline.language.formula import Formula, Reading, freely_differentiable
from exactspline.language.kinds import Kind, Symbol
from exactspline.language.operand import Constant, Parameter
from exactspline.language.rational import RingOperand
from exactspline.language.vector import Vector
from exactspline.numbers.exact import rational, to_fmpq
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.readings.degree import Degree, parse_degree
from exactspline.readings.differential_order import order_of

#: Limit on the number of terms; an upper bound for the vanishing terms of every formula of the library.
MAX_TERMS = 40


class _Across(NamedTuple):
    """The derivative with respect to the other parameter of a surface, given on the known coefficients."""

    parameter: Parameter
    follows: dict[int, fmpq_mpoly]

    def __call__(self, coefficient: fmpq_mpoly) -> fmpq_mpoly:
        """The derivative of a polynomial in the coefficients."""
        total = coefficient.context().constant(0)
        for i, used in enumerate(coefficient.degrees()):
            if int(used):
                total += coefficient.derivative(i) * self.follows[i] if i else 0
        return total


class _Expansion(RingOperand):
    """A sum of parts ``t^(k d − m) (c_0 + c_1/t + …)``, one for each degree k and weight m; the c_i are polynomials in
    d and the coefficients of the curve, and only a few of them are known. Zero has no parts; a part whose known terms
    all vanish is not necessarily zero.

    >>> from exactspline.language.kinds import CURVE

    >>> from exactspline.readings.leading_terms import LeadingTermsReading

    >>> c = LeadingTermsReading(2).argument(CURVE, 2)
    >>> d1 = c.p.d(1) * c.w - c.p * c.w.d(1)
    >>> sorted((d1[0] + c.w).parts), (c.w * 0).parts
    ([(1, 0), (2, 1)], {})
    """

    __slots__ = ("across", "context", "known", "parts")
    provenance = 0

    def __init__(
        self,
        context: fmpq_mpoly_ctx,
        known: int,
        parts: dict[tuple[int, int], list[fmpq_mpoly]],
        across: _Across | None = None,
    ) -> None:
        self.context, self.known, self.parts, self.across = context, known, parts, across

    def _made(self, parts: dict[tuple[int, int], list[fmpq_mpoly]]) -> _Expansion:
        return _Expansion(self.context, self.known, parts, self.across)

    @property
    def degree(self) -> int:
        """The largest degree k of the parts."""
        return max((k for k, _ in self.parts), default=0)

    def constant(self, value: Constant) -> _Expansion:
        """The expansion of a constant."""
        number = to_fmpq(rational(value))
        if not number:
            return self._made({})
        zero = self.context.constant(0)
        return self._made({(0, 0): [self.context.constant(number), *[zero] * (self.known - 1)]})

    def _plus(self, right: _Expansion) -> _Expansion:
        parts = dict(self.parts)
        for grading, terms in right.parts.items():
            present = parts.get(grading)
            parts[grading] = terms if present is None else [a + b for a, b in zip(present, terms, strict=True)]
        return self._made(parts)

    def _times(self, right: _Expansion) -> _Expansion:
        result, zero = self._made({}), self.context.constant(0)
        for (k, m), a in self.parts.items():
            for (n, o), b in right.parts.items():
                terms = [sum((a[j] * b[i - j] for j in range(i + 1)), zero) for i in range(self.known)]
                result = result + self._made({(k + n, m + o): terms})
        return result

    def scaled(self, constant: Constant) -> _Expansion:
        """The expansion times an exact constant."""
        q = to_fmpq(rational(constant))
        return self._made({grading: [q * a for a in terms] for grading, terms in self.parts.items()} if q else {})

    def _first_derivative(self, by: str | None) -> _Expansion:
        """The derivative, term by term; the derivative of a constant is exactly zero. For the other parameter of a
        surface, the coefficients are differentiated, which are functions of it.
        """
        if self.across is None:
            self.only_parameter(by)
        elif by == self.across.parameter:
            return self._made({g: [self.across(a) for a in terms] for g, terms in self.parts.items() if g[0]})
        elif by is None:
            raise FormulaError("the derivative of a function of two parameters", remedy="name the parameter")
        d = self.context.gens()[0]
        parts = {
            (k, m + 1): [(k * d - (m + i)) * a for i, a in enumerate(terms)]
            for (k, m), terms in self.parts.items()
            if k or m or any(terms[1:])
        }
        return self._made(parts)

    @property
    def leading(self) -> dict[tuple[int, int], tuple[int, fmpq_mpoly]] | None:
        """For every part, the number of leading terms that vanish identically in d, and the first that does not; None
        if all known terms of some part vanish.
        """
        by_grading = {}
        for grading, terms in self.parts.items():
            drop = next((i for i, a in enumerate(terms) if a), None)
            if drop is None:
                return None
            by_grading[grading] = drop, terms[drop]
        return by_grading


def common_roots(polynomial: fmpq_mpoly) -> tuple[int, ...]:
    """The integers d ≥ 1 for which a polynomial in d (its first variable) and other variables vanishes for all values
    of the others.
    """
    if polynomial and polynomial.degrees()[0] == 0:
        return ()
    common = fmpq_poly([])
    grouped: dict[tuple[int, ...], dict[int, Any]] = {}
    for exponents, c in polynomial.terms():
        e = tuple(map(int, exponents))
        grouped.setdefault(e[1:], {})[e[0]] = c
    for powers in grouped.values():
        common = greatest_common_divisor([common, fmpq_poly([powers.get(i, 0) for i in range(max(powers) + 1)])])
        if common.degree() == 0:
            return ()
    return tuple(
        sorted(
            int(-p[0] / p[1])
            for p in factorize(common.numer()).bases
            if p.degree() == 1 and p[0] % p[1] == 0 and -p[0] / p[1] >= 1
        )
    )


class _StillExpansion(_Expansion):
    """The expansion of an operand that does not depend on the parameter that goes to infinity. The operand is a
    constant, and so are its derivatives with respect to its own parameter.
    """

    __slots__ = ("derivatives",)

    derivatives: list[_StillExpansion]

    def d(self, order: int = 1, *, by: str | None = None) -> _StillExpansion:
        """The derivative of the given order, again a constant."""
        return self.derivatives[order]


class LeadingTermsReading(Reading):
    """Leading coefficients as one parameter goes to infinity, to this many terms. Operands that do not depend on this
    parameter, such as the second curve and the point, are constants with derivatives up to `order`; the coefficients of
    a surface are functions of its other parameter.
    """

    name = "infinity"

    def __init__(self, terms: int, order: int = 0, parameter: Parameter = Parameter.FIRST) -> None:
        self.terms, self.order, self.parameter = terms, order, parameter

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument with expansions of the functions of the parameter, and constants for all other operands."""
        symbols = freely_differentiable(kind, self, dimension, polynomial=polynomial)
        if any(len(symbol.parameters) > 1 for symbol in symbols):
            return self._surface(kind, dimension, symbols, polynomial)
        lengths = {s.name: self.terms if s.parameters == PARAMETERS[:1] else self.order + 1 for s in symbols}
        names = [f"{name}{i}" for name, length in lengths.items() for i in range(length)]
        context = fmpq_mpoly_ctx.get(["d", *names], Ordering.degrevlex)
        known = dict(zip(names, context.gens()[1:], strict=True))
        nothing = [context.constant(0)] * (self.terms - 1)

        def operand(symbol: Symbol) -> _Expansion:
            coefficients = [known[f"{symbol.name}{i}"] for i in range(lengths[symbol.name])]
            if symbol.parameters == PARAMETERS[:1]:
                return _Expansion(context, self.terms, {(1, 0): coefficients})
            constants = [_StillExpansion(context, self.terms, {(0, 0): [c, *nothing]}) for c in coefficients]
            if not symbol.parameters:
                constants[1:] = [_StillExpansion(context, self.terms, {}) for _ in coefficients[1:]]
            constants[0].derivatives = constants
            return constants[0]

        one = _Expansion(context, self.terms, {(0, 0): [context.constant(1), *nothing]})
        return kind.argument(dimension, operand, one, polynomial=polynomial)

    def _surface(self, kind: Kind, dimension: int, symbols: tuple[Symbol, ...], polynomial: bool) -> Evaluated:
        """The argument with expansions whose coefficients, with their derivatives, are functions of the other
        parameter.
        """
        (other,) = (p for p in kind.parameters(dimension) if p != self.parameter)
        places = [(s.name, i, n) for s in symbols for i in range(self.terms) for n in range(self.order + 1)]
        context = fmpq_mpoly_ctx.get(["d", *[f"{name}{i}_{n}" for name, i, n in places]], Ordering.degrevlex)
        known = dict(zip(places, context.gens()[1:], strict=True))
        follows = {k: known[name, i, n + 1] for k, (name, i, n) in enumerate(places, start=1) if n < self.order}
        across = _Across(other, follows)

        def operand(symbol: Symbol) -> _Expansion:
            coefficients = [known[symbol.name, i, 0] for i in range(self.terms)]
            return _Expansion(context, self.terms, {(1, 0): coefficients}, across)

        nothing = [context.constant(0)] * (self.terms - 1)
        one = _Expansion(context, self.terms, {(0, 0): [context.constant(1), *nothing]}, across)
        return kind.argument(dimension, operand, one, polynomial=polynomial)


def generic_true_degree(
    formula: Formula, dimension: int, *, polynomial: bool = False, parameter: Parameter = Parameter.FIRST
) -> Degree:
    """The true degree of a polynomial formula on the generic curve for symbolic d, homogeneous or not.

    Leading terms of parts of different degree and weight have no monomials in common, so that they cannot cancel.

    >>> from exactspline.language.formula import formula
    >>> @formula("an example")
    ... def mixed(c):
    ...     return c.p[0].d(1) * c.w - c.p[0] * c.w.d(1) + c.w
    >>> generic_true_degree(mixed, 2)
    max(2d − 2, d)
    """
    order = order_of(formula, dimension)
    leading = _resolved(
        formula,
        lambda terms: LeadingTermsReading(terms, order, parameter).argument(
            formula.kind, dimension, polynomial=polynomial
        ),
        formula.name,
    )
    symbols = formula.kind.symbols(dimension, polynomial=polynomial)
    name = next(symbol.degree_in(parameter) for symbol in symbols if parameter in symbol.parameters)
    degrees = (parse_degree(f"{k}{name}-{m + drop}") for part in leading for (k, m), (drop, _) in part.items())
    return reduce(Degree.max, degrees)


Leading = dict[tuple[int, int], tuple[int, fmpq_mpoly]]


def _resolved(formula: Callable[[Any], Any], curve: Callable[[int], Any], name: str) -> list[Leading]:
    """The leading terms of the components that are not zero, with as many known terms as necessary. If all have the
    same degree and weight, components that require more terms than others have a lower degree and are omitted.
    """
    for terms in range(1, MAX_TERMS):
        result = formula(curve(terms))
        components = list(result) if isinstance(result, Vector) else [result]
        if not all(isinstance(c, _Expansion) for c in components):
            raise FormulaError(f"{name} is a quotient", remedy="pass numerator and denominator separately")
        leading = [c.leading for c in components if c.parts]
        last = [part for part in leading if part is not None]
        gradings = {grading for c in components for grading in c.parts}
        if last and (len(last) == len(leading) or len(gradings) == 1):
            return last
    raise FormulaError(f"the first {MAX_TERMS - 1} terms of {name} vanish", remedy="it may be identically zero")
