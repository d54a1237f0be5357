"""The tree reading: the formula itself as an unsimplified tree, for printing, counting operations, and evaluation in
any other reading.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from operator import add, attrgetter, getitem, mul, neg, pow, sub, truediv
from typing import NamedTuple, cast

from exactspline.errors import FormulaError, as_integer
from exactspline.language.arguments import Argument, Callee
from exactspline.language.formula import Formula, Reading, expect_formula
from exactspline.language.kinds import Kind
from exactspline.language.operand import CONSTANTS, Constant, Operand, OwnVectors
from exactspline.language.rational import level
from exactspline.language.ruled import joined, ruled
from exactspline.language.vector import Vector, cross, det, dot, generalized_cross, join, perp
from exactspline.one_line import one_line
from exactspline.readings.printing import Expression, Operation, print_text

#: Products of vectors whose value is a vector.
VECTOR_PRODUCTS = {Operation.CROSS, Operation.PERP, Operation.GENERALIZED_CROSS, Operation.JOIN}


class Node(Expression, Operand, OwnVectors):
    """A node of an expression tree, with the operations of a reading."""

    __slots__ = ()
    args: tuple[Node, ...]

    def _node(self, other: object) -> Node | None:
        if isinstance(other, Node):
            return other
        return Node(Operation.NUMBER, value=other) if isinstance(other, CONSTANTS) else None

    def _binary(self, op: Operation, other: object) -> Node:
        right = self._node(other)
        return NotImplemented if right is None else Node(op, (self, right), vector=self.is_vector or right.is_vector)

    def __add__(self, other: object) -> Node:
        return self._binary(Operation.PLUS, other)

    def __sub__(self, other: object) -> Node:
        return self._binary(Operation.MINUS, other)

    def __rsub__(self, other: object) -> Node:
        return Node(Operation.NUMBER, value=other)._binary(Operation.MINUS, self)

    def __radd__(self, other: object) -> Node:
        return Node(Operation.NUMBER, value=other)._binary(Operation.PLUS, self)

    def __mul__(self, other: object) -> Node:
        return self._binary(Operation.TIMES, other)

    def __rmul__(self, other: object) -> Node:
        return Node(Operation.NUMBER, value=other)._binary(Operation.TIMES, self)

    def __truediv__(self, other: object) -> Node:
        return self._binary(Operation.OVER, other)

    def __rtruediv__(self, other: object) -> Node:
        return Node(Operation.NUMBER, value=other)._binary(Operation.OVER, self)

    def __neg__(self) -> Node:
        return Node(Operation.NEGATIVE, (self,), vector=self.is_vector)

    def __pow__(self, exponent: int) -> Node:
        return Node(Operation.POWER, (self,), exponent)

    def __getitem__(self, index: int | slice) -> Node:
        return Node(Operation.COMPONENT, (self,), index, vector=isinstance(index, slice))

    def __iter__(self) -> Iterator[Node]:
        raise FormulaError("a formula iterates over a vector", remedy="use v[0], v[1], …")

    def d(self, order: int = 1, *, by: str | None = None) -> Node:
        """The node of a derivative (for order 0 the node itself)."""
        return Node(Operation.DERIVATIVE, (self,), Derivation(order, by), vector=self.is_vector) if order else self

    def scaled(self, constant: Constant) -> Node:
        """The node of the product with a constant."""
        return Node(Operation.TIMES, (self, Node(Operation.NUMBER, value=constant)), vector=self.is_vector)

    def constant(self, value: Constant) -> Node:
        """The node of a constant."""
        return Node(Operation.NUMBER, value=value)

    def dividing(self, numerator: object) -> Node:
        """The node of a quotient with this denominator."""
        left = self._node(numerator)
        return NotImplemented if left is None else Node(Operation.OVER, (left, self), vector=left.is_vector)

    def times_vector(self, vector: object) -> Node:
        """Products with vectors of operands are not implemented: all vectors of this reading are nodes."""
        refused: Node = NotImplemented
        return refused

    def multilinear(self, function: Callable[..., object], vectors: tuple[object, ...]) -> Node:
        """The node of a product of vectors."""
        op = Operation(function.__name__)
        return Node(op, cast("tuple[Node, ...]", vectors), vector=op in VECTOR_PRODUCTS)

    def joining(self, parts: tuple[object, ...]) -> Node:
        """The node of a vector joined from parts."""
        operands = (Node(Operation.NUMBER, value=part) if isinstance(part, CONSTANTS) else part for part in parts)
        return Node(Operation.JOIN, cast("tuple[Node, ...]", tuple(operands)), vector=True)

    def ruled(self, generator: Node) -> Node:
        """The node of a ruled surface with this directrix."""
        return Node(Operation.RULED, (self, generator))

    def levelled(self, height: object) -> tuple[Node, Node]:
        """The nodes of this normal and its height, brought to a common denominator."""
        row = (self, height if isinstance(height, Node) else self.constant(cast(Constant, height)))
        return Node(Operation.LEVEL, row, 0, vector=self.is_vector), Node(Operation.LEVEL, row, 1)

    @property
    def generator(self) -> Node:
        """The generator of a ruled surface."""
        return self.args[1]

    @property
    def directrix(self) -> Node:
        """The directrix of a ruled surface."""
        return self.args[0]

    @one_line
    def __repr__(self) -> str:
        return print_text(self)


class Derivation(NamedTuple):
    """The order of a derivative, and its parameter if it is named."""

    order: int
    by: str | None = None


class _NamedCall(NamedTuple):
    """The symbol of a formula called by another one, and whether it is called on the second of two curves (and has a
    bar).
    """

    symbol: str
    barred: bool


class Traced(Argument):
    """The argument of the tree reading: its operands are leaves, and formulas called on it keep their names.

    The name of a leaf of a part of the argument contains the name of the part: ``second.p``.
    """

    def __init__(self, kind: Kind, dimension: int, *, expand: bool = False, path: str = "") -> None:
        self._kind, self._dimension, self._expand, self._path = kind, dimension, expand, path

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return self._dimension

    def __getattr__(self, name: str) -> Node | Traced:
        if name.startswith("_"):
            raise AttributeError(name)
        names, parts = self._kind.names(self._dimension), self._kind.parts
        if name in parts:
            return Traced(parts[name], self._dimension, expand=self._expand, path=f"{name}.")
        if name not in names:
            raise FormulaError(
                f"a {self._kind.name} has no operand {name!r}", remedy=f"it has {', '.join([*names, *parts])}"
            )
        return Node(Operation.LEAF, value=self._path + name, vector=names[name])

    def calls(self, formula: Callee) -> object:
        """A formula called by another one: a node with its symbol, or its body if it has no symbol or is to be
        expanded.
        """
        body = formula.function(self)
        if self._expand or not formula.symbol:
            return body
        return Node(
            Operation.NAMED,
            (body,),
            _NamedCall(formula.symbol, self._path == "second."),
            vector=isinstance(body, Node) and body.is_vector,
        )


class TreeReading(Reading):
    """The formula itself; formulas that it calls are shown by name, unless `expand` is set."""

    name = "tree"

    def __init__(self, *, expand: bool = False) -> None:
        self.expand = expand

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Traced:
        """The argument whose operands are named leaves."""
        return Traced(kind, dimension, expand=self.expand)


#: Operands that do not depend on how a curve or a surface is written as a quotient: σ and ρ are roots of γ′·γ′ and
#: ‖γ′ × γ″‖².
OF_THE_VALUE = frozenset(("gamma", "S", "axis_x", "axis_y", "axis_z", "point", "sigma", "rho"))


def speaks_of_gamma_alone(formula: Formula, dimension: int) -> bool:
    """Whether a formula contains only γ of each of its curves, without numerators and denominators. Then a statement
    that holds for indeterminate coordinates of γ holds for rational curves.

    >>> from exactspline.papers import find
    >>> speaks_of_gamma_alone(find("torsion"), 3), speaks_of_gamma_alone(find("torsion_reduced"), 3)
    (True, False)
    """
    parts = joined(trace(formula, dimension, expand=True))
    todo = list(parts) if isinstance(parts, Vector) else [parts]
    while todo:
        node = todo.pop()
        if isinstance(node, Node):
            constants = getattr(formula.kind, "constants", ())
            if node.op == "leaf" and str(node.value).rpartition(".")[2] not in OF_THE_VALUE.union(constants):
                return False
            todo += node.args
    return True


def nodes(tree: Node) -> Iterator[Node]:
    """All nodes of a tree, each one once."""
    seen, todo = set[int](), [tree]
    while todo:
        node = todo.pop()
        if id(node) not in seen:
            seen.add(id(node))
            todo += node.args
            yield node


def trace(formula: Formula, dimension: int = 3, *, expand: bool = False) -> Node:
    """Return the expression tree of a formula.

    >>> from exactspline.papers import find
    >>> trace(find("D1"))
    p′ w − p w′
    """
    formula = expect_formula(formula)
    argument = TreeReading(expand=expand).argument(formula.kind, as_integer(dimension, "a dimension", 1))
    return cast(Node, formula.function(argument))


#: The functions for operations that depend only on the values of their arguments.
_CARRIED_OUT: dict[Operation, Callable[..., object]] = {
    Operation.PLUS: add,
    Operation.MINUS: sub,
    Operation.TIMES: mul,
    Operation.OVER: truediv,
    Operation.NEGATIVE: neg,
    Operation.DIRECTRIX: attrgetter("directrix"),
    Operation.GENERATOR: attrgetter("generator"),
    # functions of vectors have the names of their operations
    **{Operation(f.__name__): f for f in (dot, cross, det, perp, generalized_cross, join, ruled)},
}
#: The functions for operations that also depend on the `value` of the node.
_WITH_VALUE: dict[Operation, Callable[..., object]] = {
    Operation.DERIVATIVE: lambda a, derivation: a.d(derivation.order, by=derivation.by),
    Operation.POWER: pow,
    Operation.COMPONENT: getitem,
    Operation.LEVEL: lambda normal, height, which: level(normal, height)[which],
}


def applied(n: Node, args: Sequence[object], c: object) -> object:
    """The value of one node from the values of its arguments, in the reading of the curve `c`."""
    if n.op is Operation.LEAF:
        return attrgetter(n.value)(c)
    if n.op is Operation.NUMBER:
        return n.value
    if n.op is Operation.NAMED:
        return args[0]
    return _WITH_VALUE[n.op](*args, n.value) if n.op in _WITH_VALUE else _CARRIED_OUT[n.op](*args)
