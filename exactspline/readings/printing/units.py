"""Formulas without the zeros and ones introduced by adjoined roots: ``0 + M (−1)`` is printed as ``−M``."""

from __future__ import annotations

from collections.abc import Callable

from exactspline.numbers.exact import Number
from exactspline.readings.expression import ATOMS, Expression, Operation


def without_units(n: Expression) -> Expression:
    """A tree with the same value, without sums with 0 and products with 0, 1 or −1, and with the signs of products in
    front; shared nodes stay shared.

    >>> from exactspline.readings.printing.text import print_text
    >>> from exactspline.readings.tree import Node
    >>> x, y = Node(Operation.LEAF, value="x"), Node(Operation.LEAF, value="y")
    >>> print_text((0 + x * (-1)) * (1 + 0 * y) + y * (-1)), print_text(2 * x - 0 * y)
    ('−x − y', '2 x')
    """
    return _Cleaned()(n)


class _Cleaned:
    """The simplified trees, by the nodes from which they are made."""

    def __init__(self) -> None:
        self.made: dict[int, Expression] = {}

    def __call__(self, n: Expression) -> Expression:
        if n.op in ATOMS:
            return n
        simplified = self.made.get(id(n))
        if simplified is None:
            args = tuple(map(self, n.args))
            same = all(a is b for a, b in zip(args, n.args, strict=True))
            simplified = n if same else Expression(n.op, args, n.value, vector=n.is_vector)
            if n.op in _RULES:
                simplified = _RULES[n.op](simplified, *args)
            self.made[id(n)] = simplified
        return simplified


def _is(n: Expression, value: int) -> bool:
    return n.op is Operation.NUMBER and n.value == value


def _is_integer(n: Expression) -> bool:
    return n.op is Operation.NUMBER and n.value == int(n.value)


def _number(value: Number) -> Expression:
    return Expression(Operation.NUMBER, value=value)


def _negative(n: Expression) -> Expression:
    if n.op is Operation.NUMBER:
        return _number(-n.value)
    return n.args[0] if n.op is Operation.NEGATIVE else Expression(Operation.NEGATIVE, (n,), vector=n.is_vector)


def _made(op: Operation, a: Expression, b: Expression) -> Expression:
    return Expression(op, (a, b), vector=a.is_vector or b.is_vector)


def _sum(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return b if _is(a, 0) else a
    if b.op is Operation.PLUS and b.args[0].op is Operation.NEGATIVE:
        return _made(Operation.PLUS, _made(Operation.MINUS, a, b.args[0].args[0]), b.args[1])
    return _made(Operation.MINUS, a, b.args[0]) if b.op is Operation.NEGATIVE else n


def _difference(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return _negative(b) if _is(a, 0) else a
    return n


def _product(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return n if n.is_vector else _number(0)
    for unit, other in ((a, b), (b, a)):
        if _is(unit, 1):
            return other
        if _is(unit, -1):
            return _negative(other)
        if unit.op is Operation.NEGATIVE and other.op is not Operation.NUMBER:
            return _negative(_product(n, unit.args[0], other) if unit is a else _product(n, other, unit.args[0]))
    if _is_integer(b) and a.op is not Operation.NUMBER and not a.is_vector:
        return _in_front(b, a)
    return n if a is n.args[0] and b is n.args[1] else _made(Operation.TIMES, a, b)


def _in_front(factor: Expression, n: Expression) -> Expression:
    """A product with a number in front of its first factor."""
    if n.op is Operation.TIMES:
        return _made(Operation.TIMES, _in_front(factor, n.args[0]), n.args[1])
    return _made(Operation.TIMES, factor, n)


_RULES: dict[Operation, Callable[..., Expression]] = {
    Operation.PLUS: _sum,
    Operation.MINUS: _difference,
    Operation.TIMES: _product,
    Operation.NEGATIVE: lambda n, a: _negative(a) if a.op in (Operation.NUMBER, Operation.NEGATIVE) else n,
}
