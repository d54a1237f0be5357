"""The formulas of a paper as definitions of Coq, in terms of each other."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from exactspline.errors import FormulaError
from exactspline.extras.coq.terms import Writer, identifier
from exactspline.language.arguments import Callee
from exactspline.language.formula import Formula
from exactspline.language.kinds import CurveKind, FramedKind, HodographKind, ImplicitKind, Kind, PairKind, TableKind
from exactspline.language.surface_kind import FormsKind, SurfaceCurveKind, SurfaceKind
from exactspline.papers import Paper
from exactspline.readings.expression import Operation
from exactspline.readings.tree import Node, Traced


class _Called(NamedTuple):
    """A called formula, and the part of the argument to which it is applied: ``second.``, or the whole argument."""

    formula: Formula
    path: str


class Call(Node):
    """A node of a called formula; its one argument is the tree of the body."""

    __slots__ = ()

    def __init__(self, body: Node, called: _Called) -> None:
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

    def __init__(self, kind: Kind, dimension: int, *, path: str = "", known: dict[_Called, Call] | None = None) -> None:
        super().__init__(kind, dimension, path=path)
        self._known: dict[_Called, Call] = {} if known is None else known

    def __getattr__(self, name: str) -> Node | Traced:
        value = super().__getattr__(name)
        if isinstance(value, Traced):
            return Calling(self._kind.parts[name], self._dimension, path=f"{name}.", known=self._known)
        return value

    def calls(self, formula: Callee) -> Node:
        """A node with the formula; a formula called twice is traced once."""
        assert isinstance(formula, Formula)
        called = _Called(formula, self._path)
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


HEADER = """(** {title}: {about}.

    Written by [exactspline coq]; do not edit. *)
"""


#: The records of the base by the classes of kinds.
_TYPES: dict[type[Kind], str] = {
    PairKind: "pair",
    TableKind: "table",
    CurveKind: "curve",
    FramedKind: "framed",
    HodographKind: "accompanied",
    ImplicitKind: "implicit",
    SurfaceKind: "patch",
    SurfaceCurveKind: "path",
    FormsKind: "accompanied",
}


def type_of(kind: Kind) -> str:
    """The type of the argument of formulas of a kind. Raises `FormulaError` for a kind that is missing in the base."""
    if type(kind) is CurveKind and kind.constants:
        return "accompanied A"
    if written_for(kind):
        return f"{_TYPES[type(kind)]} A"
    raise FormulaError(f"the kind {kind.name!r} has no type in Coq", remedy="add one to the base")


def written_for(kind: Kind) -> bool:
    """Whether formulas of a kind can be written."""
    accompanied = kind.constants and type(kind) is not CurveKind
    return type(kind) in _TYPES and not accompanied and (not isinstance(kind, ImplicitKind) or kind.functions == "f")


class Formulas:
    """Formulas by the papers to which they belong; `file` is the paper whose file is written."""

    def __init__(self, papers: Iterable[Paper]) -> None:
        self.papers = tuple(papers)
        self.owner = {formula: paper for paper in self.papers for formula in paper.formulas.values()}

    def named(self, formula: Formula, inside: Paper | None = None) -> str:
        """The name of a formula, in the file of its paper or elsewhere."""
        own = self.owner[formula]
        return identifier(formula.name) if own is inside else f"{own.name}.{identifier(formula.name)}"

    def definitions(self, paper: Paper) -> str:
        """The file of a paper."""
        needed: dict[Formula, None] = {}
        for formula in paper.formulas.values():
            if written_for(formula.kind):
                self._collect(formula, paper, needed)
        parts = [HEADER.format(title=paper.title, about="its formulas")]
        parts.append("Require Import ZArith List.\nFrom ExactSpline Require Import Base.")
        parts += [f"From ExactSpline.formulas Require {used.name}." for used in paper.uses]
        parts.append("Import ListNotations.\nLocal Open Scope formula_scope.\n")
        parts.append("Section Formulas.\nContext {A : Type} {o : operations A}.\n")
        parts += _constants(needed)
        parts += [self.definition(formula, paper) for formula in needed]
        parts.append("End Formulas.\n")
        return "\n".join(parts)

    def _collect(self, formula: Formula, paper: Paper, needed: dict[Formula, None]) -> None:
        """Collect the formula after those of its paper that it calls."""
        if formula in needed or self.owner[formula] is not paper:
            return
        for dimension in formula.kind.dimensions:
            for called in calls(body(formula, dimension)):
                self._collect(called, paper, needed)
        needed[formula] = None

    def definition(self, formula: Formula, paper: Paper, instead: Node | None = None) -> str:
        """A formula as a definition in the file of its paper, with the tree `instead` if that is given."""
        trees = (
            [instead] if instead is not None else [body(formula, dimension) for dimension in formula.kind.dimensions]
        )
        writer = Writer(lambda each: self.named(each, paper), table=isinstance(formula.kind, TableKind))
        texts = {writer(tree) for tree in trees}
        if len(texts) > 1:
            raise FormulaError(
                f"{formula.name} is another term in every dimension", remedy="write one formula per dimension"
            )
        said = " ".join((formula.__doc__ or "").split())
        name = identifier(formula.name)
        return (
            f"(** {comment(formula.source)}. {comment(said)} *)\n"
            f"Definition {name} (c : {type_of(formula.kind)}) : {_result_type(trees[0])} :=\n  {texts.pop()}.\n"
        )


def _constants(formulas: Iterable[Formula]) -> list[str]:
    """The constants that accompany curves, by their positions.

    Raises `FormulaError` where one name has two positions.
    """
    places: dict[str, int] = {}
    for formula in formulas:
        for i, name in enumerate(formula.kind.constants):
            if places.setdefault(name, i) != i:
                raise FormulaError(f"{name} is another constant elsewhere", remedy="name the same constants before it")
    return [
        f"(** The constant {name}. *)\nDefinition {name}_of (c : accompanied A) : A := component {i} (beside c).\n"
        for name, i in sorted(places.items())
    ]


def comment(text: str) -> str:
    """A text that is safe in a comment, in which Coq interprets quotation marks and comment signs."""
    return text.replace('"', "”").replace("(*", "( *").replace("*)", "* )").replace("``", "`")


def _result_type(tree: Node) -> str:
    """The type of the value of a tree."""
    if surface(tree):
        return "surface A"
    return "list A" if tree.is_vector else "A"


def surface(tree: Node) -> bool:
    """Whether a tree represents a ruled surface."""
    return tree.op is Operation.RULED or (tree.op is Operation.NAMED and surface(tree.args[0]))


def calls(tree: Node) -> list[Formula]:
    """The formulas that a tree calls directly."""
    called: dict[Formula, None] = {}
    seen, todo = set[int](), [tree]
    while todo:
        node = todo.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        if node.op is Operation.NAMED:
            called[node.value.formula] = None
        else:
            todo += node.args
    return list(called)
