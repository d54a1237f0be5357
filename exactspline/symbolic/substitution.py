"""A jet polynomial evaluated on a concrete curve."""

from __future__ import annotations

from typing import Any

from exactspline.exact import mpq
from exactspline.language.arguments import Curve, Pair, T
from exactspline.language.kinds import Symbol
from exactspline.language.operand import CONSTANTS
from exactspline.readings.jet import Jet


def substitute(jet: Jet, curve: Curve[T] | Pair[T]) -> T:
    """A jet polynomial on a concrete curve: the variables replaced by the derivatives of p and w.

    >>> from exactspline.splines.examples import example
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> jets, curve = JetReading(1).argument(CURVE, 2), example("rational_cubic")
    >>> substitute(jets.w.d(1), curve) == curve.w.d(1)
    True
    """
    known = curve.operands()
    terms = [(tuple(map(int, exponents)), mpq(int(c.p), int(c.q))) for exponents, c in jet.polynomial.terms()]
    symbols = jet.ring.symbols
    value = _horner(
        terms,
        0,
        [
            lambda name=name, orders=orders: _derived(known[name], symbols[name], orders)
            for name, orders in jet.ring.variables
        ],
    )
    some = next(known[name] for name in ("w", *known) if name in known)
    return some.constant(value) if isinstance(value, CONSTANTS) else value


def _derived(operand: Any, symbol: Symbol, orders: tuple[int, ...]) -> Any:
    """A derivative of an operand: of several parameters by each in turn."""
    if len(orders) == 1:
        return operand.d(*orders)
    for parameter, order in zip(symbol.parameters, orders, strict=True):
        operand = operand.d(order, by=parameter) if order else operand
    return operand


def _horner(terms: list[tuple[tuple[int, ...], mpq]], i: int, variables: list[Any]) -> Any:
    """The sum of terms by Horner's rule in the i-th variable, the coefficients by the same rule in the ones that
    follow.
    """
    if len(terms) <= 1 and (not terms or not any(terms[0][0][i:])):
        return terms[0][1] if terms else mpq(0)
    groups: dict[int, list[tuple[tuple[int, ...], mpq]]] = {}
    for term in terms:
        groups.setdefault(term[0][i], []).append(term)
    powers = sorted(groups, reverse=True)
    if powers == [0]:
        return _horner(terms, i + 1, variables)
    x, total = variables[i](), None
    for e, lower in zip(powers, [*powers[1:], 0], strict=True):
        inner = _horner(groups[e], i + 1, variables)
        total = inner if total is None else total + inner
        if e > lower:
            power = x ** (e - lower)
            total = power if isinstance(total, CONSTANTS) and total == 1 else power * total
    return total
