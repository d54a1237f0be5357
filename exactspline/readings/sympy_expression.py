"""The sympy reading: a formula becomes an expression of sympy in the functions x(s), y(s), z(s), w(s) of the parameter.

Differentiation and algebra (sparse polynomials over sympy's ground types) are those of sympy and share no code with the
jets of `exactspline.readings.jet`: if both agree, a claim has been decided twice, independently. The second curve of a
pair has the parameter s̄, surfaces have u and v; the coordinates of a point are symbols.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, reduce
from heapq import heapify, heappop, heappush
from itertools import cycle
from math import lcm
from typing import Any, Self, cast

import sympy
from sympy.core.function import AppliedUndef
from sympy.polys.rings import PolyElement, PolyRing

from exactspline.errors import FormulaError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Reading
from exactspline.language.kinds import Kind, Symbol
from exactspline.language.operand import Constant, FieldOperand, Parameter
from exactspline.numbers.exact import rational
from exactspline.one_line import one_line
from exactspline.polynomials.cost import look_at_the_time
from exactspline.polynomials.factors import Factorization, multiplied

PARAMETER: dict[str, sympy.Symbol] = {name: sympy.Symbol(name) for name in Parameter}
FIRST = PARAMETER[Parameter.FIRST]
#: Coordinates of the points at which divisibility of values is tested first, repeated cyclically; arbitrary integers.
POINTS = tuple(tuple(3 + (7 * i * i + 11 * i + 5 * k) % 89 for i in range(89)) for k in (1, 2, 3))


class _SympyExpression(FieldOperand):
    """An expression, with the parameters on which it depends.

    >>> from exactspline.papers import find
    >>> SympyReading().of(find("f0"), 2, polynomial=True).expression
    Derivative(x(s), s)*Derivative(y(s), (s, 2)) - Derivative(x(s), (s, 2))*Derivative(y(s), s)
    """

    __slots__ = ("expression", "parameters")
    degree = provenance = 0

    def __init__(self, expression: sympy.Expr, parameters: frozenset[sympy.Symbol] = frozenset()) -> None:
        self.expression, self.parameters = expression, parameters

    def _made(self, expression: sympy.Expr, parameters: frozenset[sympy.Symbol]) -> Self:
        return type(self)(expression, parameters)

    def constant(self, value: Constant) -> Self:
        """An exact constant."""
        return self._made(_number(value), frozenset())

    def _plus(self, right: Self) -> Self:
        return self._made(self.expression + right.expression, self.parameters | right.parameters)

    def _times(self, right: Self) -> Self:
        return self._made(self.expression * right.expression, self.parameters | right.parameters)

    def reciprocal(self) -> Self:
        """``1 / a``; raises `FormulaError` if a vanishes identically."""
        if self.is_zero:
            raise FormulaError("division by an expression that vanishes identically", remedy="check the formula")
        return self._made(1 / self.expression, self.parameters)

    def scaled(self, constant: Constant) -> Self:
        """The expression times an exact constant."""
        return self._made(self.expression * _number(constant), self.parameters)

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The derivative with respect to its parameter, or the one that is named.

        Raises `FormulaError` for an expression in two parameters if none is named.
        """
        if by is not None:
            return self._made(sympy.diff(self.expression, PARAMETER[by], order), self.parameters)
        if len(self.parameters) > 1:
            raise FormulaError(
                "the derivative of an expression in two parameters", remedy="differentiate operands of one curve"
            )
        if not self.parameters or not order:
            return self if not order else self.constant(0)
        return self._made(sympy.diff(self.expression, next(iter(self.parameters)), order), self.parameters)

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return vanishes(self.expression)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _SympyExpression) and vanishes(self.expression - other.expression)

    __hash__ = None  # type: ignore[assignment]  # not hashable

    @one_line
    def __repr__(self) -> str:
        return str(self.expression)


class _AlongCurve(_SympyExpression):
    """An expression on a curve on a surface, whose parameters are functions; `flow` contains their derivatives."""

    __slots__ = ("flow",)

    def __init__(
        self,
        expression: sympy.Expr,
        parameters: frozenset[sympy.Symbol],
        flow: tuple[tuple[sympy.Symbol, sympy.Expr], ...],
    ) -> None:
        super().__init__(expression, parameters)
        self.flow = flow

    def _made(self, expression: sympy.Expr, parameters: frozenset[sympy.Symbol]) -> Self:
        return type(self)(expression, parameters, self.flow)

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The partial derivative with respect to a named surface parameter; otherwise along the curve, by the chain
        rule.
        """
        if by not in (None, Parameter.FIRST):
            return super().d(order, by=by)
        expression = self.expression
        for _ in range(order):
            chained = [pace * sympy.diff(expression, parameter) for parameter, pace in self.flow]
            expression = sympy.diff(expression, FIRST) + sympy.Add(*chained)
        return self._made(expression, self.parameters)


def _number(value: Any) -> sympy.Rational:
    q = rational(value)
    return sympy.Rational(int(q.numerator), int(q.denominator))


class SympyReading(Reading):
    """The argument with functions of sympy as operands.

    >>> from exactspline.language.kinds import PAIR
    >>> c = SympyReading().argument(PAIR, 3)
    >>> (c.first.w * c.second.p[0].d()).expression
    w(s)*Derivative(x̄(s̄), s̄)
    """

    name = "sympy"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument with functions of their parameters, differentiated by the rules of the kind if it has any, and
        with symbols for constants.
        """
        rules, known = kind.rules(dimension), dict[str, _SympyExpression]()
        texts = {symbol.name: symbol.text for symbol in kind.symbols(dimension, polynomial=polynomial)}
        flow = tuple(
            (PARAMETER[parameter], sympy.diff(sympy.Function(texts[name])(FIRST), FIRST))
            for parameter, name in kind.composed.items()
        )

        def operand(symbol: Symbol) -> _SympyExpression:
            if not symbol.parameters:
                return _SympyExpression(sympy.Symbol(symbol.name))  # alpha_1 and alpha1 are printed alike
            parameters = [PARAMETER[name] for name in symbol.parameters]
            function = sympy.Function(symbol.text)
            if symbol.name in rules:
                function = _linked(symbol.text, lambda: cast(_SympyExpression, rules[symbol.name](known)).expression)
            made = function(*parameters), frozenset(parameters)
            return _AlongCurve(*made, flow) if flow else _SympyExpression(*made)

        known |= {symbol.name: operand(symbol) for symbol in kind.symbols(dimension, polynomial=polynomial)}
        one = _SympyExpression(sympy.Integer(1))
        return kind.argument(dimension, lambda symbol: known[symbol.name], one, polynomial=polynomial)


def _linked(name: str, derivative: Callable[[], sympy.Expr]) -> Any:
    """A function of sympy whose derivative is an expression in other functions."""
    return type(name, (AppliedUndef,), {"fdiff": lambda self, argindex=1: derivative()})


@cache
def vanishes(expression: sympy.Expr) -> bool:
    """Whether an expression is identically zero when the functions and all their derivatives are independent.

    Everything is brought to a common denominator and expanded.

    >>> x = sympy.Function("x")(FIRST)
    >>> vanishes((x.diff(FIRST) / x).diff(FIRST) - x.diff(FIRST, 2) / x + (x.diff(FIRST) / x) ** 2)
    True

    Raises `FormulaError` for a denominator that vanishes identically, and for an expression that is not rational.
    """
    return bool(expression == 0) if expression.is_Rational else not Fractions(expression).value(expression).unit


class _Product:
    """``unit · Π baseᵉ`` with exponents of either sign; the bases are primitive polynomials, not necessarily
    irreducible.
    """

    __slots__ = ("powers", "unit")

    def __init__(self, unit: Any, powers: Factorization[PolyElement]) -> None:
        self.unit, self.powers = unit, powers

    def times(self, other: _Product) -> _Product:
        """The product."""
        return _Product(self.unit * other.unit, self.powers * other.powers)

    def to_the(self, exponent: int) -> _Product:
        """A power, possibly negative; raises `FormulaError` for 1/0."""
        if not self.unit and exponent < 0:
            raise FormulaError("division by an expression that vanishes identically", remedy="check the formula")
        return _Product(self.unit**exponent, self.powers**exponent)


class Fractions:
    """The field generated by the functions and derivatives in an expression, and evaluation of its tree in it."""

    def __init__(self, expression: sympy.Expr) -> None:
        atoms = expression.atoms(sympy.Derivative, AppliedUndef, sympy.Symbol)
        used = sorted((a for a in atoms if a not in PARAMETER.values()), key=sympy.default_sort_key)
        self.ring = PolyRing([f"v{i}" for i in range(len(used))] or ["v0"], sympy.ZZ, sympy.lex)
        self.generators = dict(zip(used, self.ring.gens, strict=False))
        self.known: dict[sympy.Expr, _Product] = {}

    def value(self, e: sympy.Expr) -> _Product:
        """An expression as a product; repeated subexpressions are computed once."""
        look_at_the_time()
        if e not in self.known:
            self.known[e] = self._value(e)
        return self.known[e]

    def _value(self, e: sympy.Expr) -> _Product:
        if e in self.generators:
            return _Product(sympy.QQ(1), Factorization([(self.generators[e], 1)]))
        if e.is_Rational:
            return _Product(sympy.QQ(int(e.p), int(e.q)), Factorization())
        if e.is_Mul:
            return reduce(_Product.times, [self.value(a) for a in e.args])
        if e.is_Pow and e.exp.is_Integer:
            return self.value(e.base).to_the(int(e.exp))
        if e.is_Add:
            return self.sum([self.value(a) for a in e.args])
        raise FormulaError(f"{e} is not a rational expression", remedy="formulas are made of + − · / and derivatives")

    def sum(self, terms: list[_Product]) -> _Product:
        """The sum: common factors are factored out, the rest is expanded."""
        terms = [term for term in terms if term.unit]
        common = reduce(Factorization.shared, [term.powers for term in terms]) if terms else Factorization()
        denominator = lcm(*[int(term.unit.denominator) for term in terms])
        total = self.ring.zero
        for term in terms:
            lifted = self.ring.ground_new(int(term.unit * denominator))
            factors = Factorization(sorted(term.powers.without(common), key=lambda power: len(power[0])))
            total = total + multiplied(factors, lifted)
        if not total:
            return _Product(sympy.QQ(0), Factorization())
        return _Product(sympy.QQ(1, denominator), common).times(self.product(total, [base for base, _ in common.below]))

    def product(self, total: PolyElement, denominators: list[PolyElement]) -> _Product:
        """A polynomial as a product: its content, the variables and the given denominators that divide it, and the
        cofactor.
        """
        content, rest = total.primitive()
        if rest.LC < 0:
            content, rest = -content, -rest
        powers = Factorization[PolyElement]()
        lowest = [min(column) for column in zip(*rest.monoms(), strict=True)]
        if any(lowest):
            rest = self.ring.from_dict(
                {tuple(a - b for a, b in zip(m, lowest, strict=True)): c for m, c in rest.items()}
            )
            powers = Factorization(zip(self.ring.gens, lowest, strict=True))
        for base in denominators:
            while len(base) > 1 and self._may_divide(base, rest):
                quotient = exact_quotient(rest, base)
                if quotient is None:
                    break
                powers = powers * Factorization([(base, 1)])
                rest = quotient
        if rest != self.ring.one:
            powers = powers * Factorization([(rest, 1)])
        return _Product(sympy.QQ(int(content)), powers)

    def _may_divide(self, base: PolyElement, p: PolyElement) -> bool:
        """Whether the value of `base` divides that of p at some integer points: a cheap necessary condition (both are
        primitive).
        """
        for point in POINTS:
            below = _at(base, point)
            if below and _at(p, point) % below:
                return False
        return True


def _at(p: PolyElement, point: tuple[int, ...]) -> int:
    total = 0
    for monomial, c in p.items():
        term = int(c)
        for x, e in zip(cycle(point), monomial, strict=False):
            if e:
                term *= x**e
        total += term
    return total


def exact_quotient(p: PolyElement, q: PolyElement) -> PolyElement | None:
    """The exact quotient, or None if there is none, by division of leading terms taken from a heap."""
    lead, *others = sorted(q.items(), reverse=True)
    remainder, quotient = dict(p), {}
    heap = [tuple(-e for e in monomial) for monomial in remainder]
    heapify(heap)
    while heap:
        look_at_the_time()
        monomial = tuple(-e for e in heappop(heap))
        c = remainder.pop(monomial, 0)
        if not c:
            continue
        step = tuple(a - b for a, b in zip(monomial, lead[0], strict=True))
        if min(step) < 0 or c % lead[1]:
            return None
        quotient[step] = factor = c // lead[1]
        for other, coefficient in others:
            place = tuple(a + b for a, b in zip(step, other, strict=True))
            if place not in remainder:
                heappush(heap, tuple(-e for e in place))
            remainder[place] = remainder.get(place, 0) - factor * coefficient
    return q.ring.from_dict(quotient)
