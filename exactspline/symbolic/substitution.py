"""Evaluation of jet polynomials on concrete curves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import groupby
from math import gcd, lcm
from typing import Any, NamedTuple, cast

from exactspline.language.arguments import Curve, Pair, T
from exactspline.language.kinds import Symbol
from exactspline.language.operand import CONSTANTS
from exactspline.language.surface_kind import Surface
from exactspline.numbers.exact import mpq
from exactspline.readings.jet import Jet


def substitute(jet: Jet, curve: Curve[T] | Pair[T] | Surface[T]) -> T:
    """A jet polynomial on a concrete curve: its variables are replaced by the derivatives of p and w.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> jets, curve = JetReading(1).argument(CURVE, 2), example("rational_cubic")
    >>> substitute(jets.w.d(1), curve) == curve.w.d(1)
    True
    """
    return Substitution(jet).on(curve)


def _derived(operand: Any, symbol: Symbol, orders: tuple[int, ...]) -> Any:
    """A derivative of an operand; for several parameters, with respect to each in turn."""
    if len(orders) == 1:
        return operand.d(*orders)
    for parameter, order in zip(symbol.parameters, orders, strict=True):
        operand = operand.d(order, by=parameter) if order else operand
    return operand


#: A constant times the value of a node, or only a constant if there is no node.
Multiple = tuple[int, int | None]
#: The exponents of a monomial, and its coefficient.
Term = tuple[tuple[int, ...], int]


class _Step(NamedTuple):
    """One step of Horner's rule: an inner value is added, and the sum multiplied by a power of the variable."""

    inner: Multiple
    power: int


class Substitution:
    """Evaluation of a jet polynomial on many curves by Horner's rule, variable by variable; inner values that agree up
    to a constant are computed once.
    """

    def __init__(self, jet: Jet) -> None:
        self.ring = jet.ring
        coefficients = jet.polynomial.coeffs()
        below = lcm(*(int(c.q) for c in coefficients))
        self.unit = mpq(1, below)
        monomials = [tuple(map(int, exponents)) for exponents in jet.polynomial.monoms()]
        numbers = [int(c.p) * (below // int(c.q)) for c in coefficients]
        #: The variable and steps of each inner value, in the order of evaluation.
        self.nodes: list[tuple[int, list[_Step]]] = []
        self._known: dict[tuple[tuple[int, ...], ...], int] = {}
        self.whole = self._value(sorted(zip(monomials, numbers, strict=True), reverse=True), 0)
        self._known.clear()

    def _value(self, terms: Sequence[Term], i: int) -> Multiple:
        """The sum of sorted terms, without the variables before the i-th."""
        if not terms:
            return 0, None
        first = terms[0][0]
        while i < len(first) and first[i] == 0:
            i += 1  # the first term has the largest exponent
        if i == len(first):
            return terms[0][1], None
        numbers = [c for _, c in terms]
        unit = gcd(*numbers) * (1 if numbers[0] > 0 else -1)
        key = (*[e[i:] for e, _ in terms], tuple(numbers) if unit == 1 else tuple([c // unit for c in numbers]))
        if key not in self._known:
            groups = [(e, list(group)) for e, group in groupby(terms, key=lambda term: term[0][i])]
            lower = [*[e for e, _ in groups[1:]], 0]
            steps = []
            for (e, group), next_lower in zip(groups, lower, strict=True):
                constant, node = self._value(group, i + 1)
                steps.append(_Step((constant // unit, node), e - next_lower))
            self._known[key] = len(self.nodes)
            self.nodes.append((i, steps))
        return unit, self._known[key]

    def on(self, curve: Curve[T] | Pair[T] | Surface[T]) -> T:
        """The value on a curve."""
        known = curve.operands()
        symbols = self.ring.symbols
        variables: list[Callable[[], Any]] = [
            partial(_derived, known[name], symbols[name], orders) for name, orders in self.ring.variables
        ]
        value = self._evaluated(variables)
        if not isinstance(value, CONSTANTS):
            return cast(T, self._scaled(value))
        some: Any = next(known[name] for name in ("w", *known) if name in known)
        return cast(T, some.constant(value * self.unit))

    def _scaled(self, value: Any) -> Any:
        return value if self.unit == 1 else value * self.unit

    def _evaluated(self, variables: list[Callable[[], Any]]) -> Any:
        values: list[Any] = []
        powers: dict[tuple[int, int], Any] = {}

        def multiple(of: Multiple) -> Any:
            constant, node = of
            return constant if node is None else values[node] if constant == 1 else values[node] * constant

        for i, steps in self.nodes:
            total: Any = None
            for inner, e in steps:
                total = multiple(inner) if total is None else total + multiple(inner)
                if e:
                    if (i, e) not in powers:
                        powers[i, e] = variables[i]() ** e
                    total = powers[i, e] if isinstance(total, CONSTANTS) and total == 1 else powers[i, e] * total
            values.append(total)
        return multiple(self.whole)
