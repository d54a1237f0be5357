"""Expression trees as data, made by the tree reading and traversed by printers."""

from __future__ import annotations

from enum import StrEnum
from typing import Any


class Operation(StrEnum):
    """The operation of a node; products of vectors have the names of their functions."""

    #: An operand, a constant, and a formula called by its name.
    LEAF = "leaf"
    NUMBER = "number"
    NAMED = "named"
    PLUS = "+"
    MINUS = "-"
    TIMES = "*"
    OVER = "/"
    NEGATIVE = "neg"
    DERIVATIVE = "d"
    POWER = "**"
    COMPONENT = "[]"
    DOT = "dot"
    CROSS = "cross"
    DET = "det"
    PERP = "perp"
    GENERALIZED_CROSS = "generalized_cross"
    JOIN = "join"
    #: A directrix with its generator; a normal with its height, brought to a common denominator.
    RULED = "ruled"
    LEVEL = "level"
    #: A part of a ruled surface that is accessed by name.
    DIRECTRIX = "directrix"
    GENERATOR = "generator"


#: Operations without arithmetic.
ATOMS = (Operation.LEAF, Operation.NUMBER, Operation.NAMED)


class Expression:
    """A node of an expression tree: an operation, its arguments, and a value (a name, a number, …)."""

    __slots__ = ("args", "is_vector", "op", "value")
    args: tuple[Expression, ...]
    is_vector: bool
    #: Depending on the operation: the name of a leaf, a number, the order of a derivative, …
    value: Any

    def __init__(
        self, op: Operation | str, args: tuple[Expression, ...] = (), value: object = None, *, vector: bool = False
    ) -> None:
        self.op, self.args, self.value, self.is_vector = Operation(op), args, value, vector
