"""The tree reading in which every call of a formula is a node: the formulas of a paper in terms of each other."""

from __future__ import annotations

from typing import NamedTuple

from exactspline.language.argument import Callee
from exactspline.language.formula import Formula
from exactspline.language.kinds import Kind
from exactspline.readings.expression import Operation
from exactspline.readings.tree import Node, Traced


class Called(NamedTuple):
    """A called formula, and the part of the argument to which it is applied: ``second.``, or the whole argument."""

    formula: Formula
    path: str


class Call(Node):
    """A node of a called formula; its one argument is the tree of the body."""

    __slots__ = ()

    def __init__(self, body: Node, called: Called) -> None:
        super().__init__(Operation.NAMED, (body,), called, vector=body.is_vector)

    @property
    def generator(self) -> Node:
        """The generator of the called ruled surface."""
        return Node(Operation.GENERATOR, (self,), vector=True)

    @property
    def directrix(self) -> Node:
        """The directrix of the called ruled surface."""
        return Node(Operation.DIRECTRIX, (self,), vector=True)


class Calling(Traced):
    """The argument of the tree reading, in which called formulas become nodes."""

    def __init__(self, kind: Kind, dimension: int, *, path: str = "", known: dict[Called, Call] | None = None) -> None:
        super().__init__(kind, dimension, path=path)
        self._known: dict[Called, Call] = {} if known is None else known

    def __getattr__(self, name: str) -> Node | Traced:
        value = super().__getattr__(name)
        if isinstance(value, Traced):
            return Calling(self._kind.parts[name], self._dimension, path=f"{name}.", known=self._known)
        return value

    def calls(self, formula: Callee) -> Node:
        """A node with the formula; a formula called twice is traced once."""
        assert isinstance(formula, Formula)
        called = Called(formula, self._path)
        if called not in self._known:
            self._known[called] = Call(formula.function(self), called)
        return self._known[called]


def body(formula: Formula, dimension: int) -> Node:
    """The tree of a formula, with the formulas that it calls by name.

    >>> from exactspline.papers import find
    >>> body(find("f1"), 2).args[0].value.formula.name
    'D1'
    """
    tree: Node = formula.function(Calling(formula.kind, dimension))
    return tree
