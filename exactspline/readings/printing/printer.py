"""The common part of the LaTeX and text printers: parentheses, products that are squares, and sums."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod

from exactspline.language.operand import Parameter
from exactspline.numbers.exact import Number
from exactspline.readings.expression import ATOMS, Expression, Operation
from exactspline.readings.printing.units import without_units

#: The parameters of surfaces: derivatives by them are written as subscripts.
SUBSCRIPTS = (Parameter.U, Parameter.V)

#: The precedence of operations; arguments of lower precedence are put in parentheses.
SUM, PRODUCT, POWER, ATOM = 1, 2, 3, 4


class Printer(ABC):
    """A traversal of a tree; subclasses define the notation of each node."""

    def __call__(self, node: Expression) -> str:
        """The text of a tree."""
        return self.inner(without_units(node))

    def inner(self, node: Expression) -> str:
        """The text of a part of a tree."""
        return self.show(node)[0]

    def show(self, n: Expression) -> tuple[str, int]:
        """The text of a node and its precedence."""
        if n.op in ATOMS:
            return self.atom(n)
        if n.op is Operation.LEVEL:
            # bringing to a common denominator does not change the value, so that the argument is printed
            return self.show(n.args[n.value])
        if n.op in (Operation.PLUS, Operation.MINUS):
            left, right = n.args
            sign, least = (self.minus, PRODUCT) if n.op is Operation.MINUS else ("+", SUM)
            return f"{self.inner(left)} {sign} {self.at(right, least)}", SUM
        if n.op is Operation.RULED:
            return f"{self.inner(n.args[0])} + {self.ruling}{self.between}{self.at(n.args[1], PRODUCT)}", SUM
        if n.op is Operation.NEGATIVE:
            return f"{self.minus}{self.at(n.args[0], PRODUCT)}", SUM
        if n.op is Operation.TIMES:
            return self.times(n), PRODUCT
        if n.op is Operation.OVER:
            return self.quotient(*n.args)
        if n.op is Operation.POWER:
            return self.power(self.at(n.args[0], ATOM), n.value), POWER
        if n.op is Operation.DERIVATIVE:
            order, by = n.value
            if by in SUBSCRIPTS:
                inner, letters = _letters(n)
                return self.subscripted(self.at(inner, ATOM), letters), ATOM
            base = self.at(n.args[0], ATOM)
            return (self.derivative(base, order), ATOM) if by is None else (self.partial(base, order, by), PRODUCT)
        if n.op is Operation.COMPONENT:
            return self.component(self.at(n.args[0], ATOM), _index_text(n.value)), ATOM
        if n.op is Operation.JOIN:
            return self.parentheses.format(", ".join(map(self.inner, n.args))), ATOM
        return self.product(n)

    def at(self, n: Expression, least: int) -> str:
        """The text of an argument, in parentheses if its precedence is lower than `least`."""
        text, binding = self.show(n)
        return text if binding >= least else self.parentheses.format(text)

    def times(self, n: Expression) -> str:
        """A product, scalars before vectors."""
        a, b = n.args
        if (
            a.is_vector
            and not b.is_vector
            and b.op is not Operation.LEAF
            and not (b.op is Operation.DERIVATIVE and b.args[0].op is Operation.LEAF)
        ):
            a, b = b, a
        return f"{self.at(a, PRODUCT)}{self.between}{self.at(b, POWER)}"

    def product(self, n: Expression) -> tuple[str, int]:
        """A product of vectors."""
        parts = [self.at(a, POWER) for a in n.args]
        if n.op is Operation.DOT and n.args[0] is n.args[1]:
            return self.norm2.format(self.inner(n.args[0])), POWER
        if n.op is Operation.DET:
            return self.bracket.format(self.apart.join(parts)), ATOM
        if n.op is Operation.PERP:
            (turned,) = n.args
            return self.perp(self.at(turned, ATOM)), ATOM
        if n.op is Operation.GENERALIZED_CROSS:
            return self.wedge.format(", ".join(map(self.inner, n.args))), ATOM
        return (f" {self.cross} " if n.op is Operation.CROSS else f" {self.dot} ").join(parts), PRODUCT

    #: Signs: of a difference, between the factors of products of vectors, of scalars, and the parameter of a ruling.
    minus: str
    cross: str
    dot: str
    between: str
    ruling: str
    #: What stands around a part: a sum, a vector of which the squared length is taken, the vectors of a determinant
    #: (and what stands between these), those of a generalized cross product.
    parentheses: str
    norm2: str
    bracket: str
    apart: str
    wedge: str

    @abstractmethod
    def atom(self, n: Expression) -> tuple[str, int]:
        """A leaf, a number or a named formula."""

    @abstractmethod
    def quotient(self, a: Expression, b: Expression) -> tuple[str, int]:
        """A quotient."""

    @abstractmethod
    def power(self, base: str, exponent: int) -> str:
        """A power."""

    @abstractmethod
    def derivative(self, base: str, order: int) -> str:
        """A derivative."""

    @abstractmethod
    def partial(self, base: str, order: int, by: str) -> str:
        """A derivative with respect to a named parameter."""

    @abstractmethod
    def subscripted(self, base: str, letters: str) -> str:
        """A derivative of a surface with respect to parameters in this order."""

    @abstractmethod
    def component(self, base: str, index: str) -> str:
        """A component of a vector."""

    @abstractmethod
    def perp(self, text: str) -> str:
        """A vector rotated by a right angle."""


def _letters(n: Expression) -> tuple[Expression, str]:
    """The innermost operand of nested derivatives, and their parameters in the order of differentiation."""
    letters = ""
    while n.op is Operation.DERIVATIVE and n.value.by in SUBSCRIPTS:
        letters = str(n.value.by) * n.value.order + letters
        n = n.args[0]
    return n, letters


def named_binding(n: Expression) -> int:
    """The precedence of the symbol of a named formula: a symbol that ends in a power needs parentheses before another
    power.
    """
    return POWER if "^" in n.value.symbol else ATOM


def _index_text(index: int | slice) -> str:
    """An index, or the first and last index of a slice.

    >>> _index_text(2), _index_text(slice(1, 4)), _index_text(slice(1, None)), _index_text(slice(None, 2))
    ('2', '1…3', '1…', '0…1')

    A slice that counts from the end or has a step is written as in Python.

    >>> _index_text(slice(None, -1)), _index_text(slice(0, 3, 2))
    (':-1', '0:3:2')
    """
    if not isinstance(index, slice):
        return str(index)
    start, stop = index.start or 0, index.stop
    if index.step in (None, 1) and start >= 0 and (stop is None or stop > 0):
        return f"{start}…" if stop is None else f"{start}…{stop - 1}"
    ends = ["" if end is None else str(end) for end in (index.start, stop)]
    return ":".join(ends if index.step is None else [*ends, str(index.step)])


def number(value: Number) -> tuple[str, int]:
    """A constant; fractions have the precedence of products."""
    text = str(value)
    return text, ATOM if text.isdigit() else PRODUCT


#: The notation of leaves that differs from their name.
LEAVES = {"point": "Q", "axis_x": "e_1", "axis_y": "e_2", "axis_z": "e_3", "pace": "lambda", "cut": "c"}
#: Partial derivatives of the function of an implicit curve or surface, its gradient, and a row of its Hessian.
_PARTIAL = re.compile(r"(gradient_|hessian_|)([fg])([xyz]*)")


def leaf(value: str) -> tuple[str, str, str, bool]:
    """The notation of a leaf: its nabla or nothing, its letter or name, its index, and whether it has a bar, because it
    belongs to the second of two curves.

    >>> leaf("second.p"), leaf("gamma"), leaf("p1"), leaf("lambda_2")
    (('', 'p', '', True), ('', 'gamma', '', False), ('', 'p', '1', False), ('', 'lambda', '2', False))
    >>> leaf("fxy"), leaf("gradient_g"), leaf("hessian_fx")
    (('', 'F', 'xy', False), ('∇', 'G', '', False), ('∇', 'F', 'x', False))
    """
    path, _, name = value.rpartition(".")
    name = LEAVES.get(name, name)
    partial = _PARTIAL.fullmatch(name)
    if partial and (partial[1] or partial[3]):
        return "∇" * bool(partial[1]), partial[2].upper(), partial[3], False
    stem = name.rstrip("0123456789")
    return "", stem.rstrip("_"), name[len(stem) :], path == "second"
