"""Expression trees as data: what the tree reading makes and printers walk."""

from __future__ import annotations

from enum import StrEnum
from typing import Any


class Operation(StrEnum):
    """What a node does; products of vectors have the names of their functions."""

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
    #: A directrix with its generator; a normal with its height, brought to one denominator.
    RULED = "ruled"
    LEVEL = "level"
    #: A part of a ruled surface that is called by its name.
    DIRECTRIX = "directrix"
    GENERATOR = "generator"


#: Operations that compute nothing.
ATOMS = (Operation.LEAF, Operation.NUMBER, Operation.NAMED)


class Expression:
    """A node of an expression tree: an operation, its arguments, and a value (a name, a number, …)."""

    __slots__ = ("args", "is_vector", "op", "value")
    args: tuple[Expression, ...]
    is_vector: bool
    #: The name of a leaf, a number, the order of a derivative, …, depending on the operation.
    value: Any

    def __init__(
        self, op: Operation | str, args: tuple[Expression, ...] = (), value: object = None, *, vector: bool = False
    ) -> None:
        self.op, self.args, self.value, self.is_vector = Operation(op), args, value, vector
