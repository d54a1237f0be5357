"""The formulas of a paper as definitions of Coq, in terms of each other."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cache
from importlib import resources
from typing import NamedTuple, cast

from exactspline.errors import FormulaError
from exactspline.language.arguments import Callee
from exactspline.language.formula import Formula
from exactspline.language.kinds import CurveKind, FramedKind, HodographKind, ImplicitKind, Kind, PairKind, TableKind
from exactspline.language.operand import Constant
from exactspline.language.surface_kind import FormsKind, SurfaceCurveKind, SurfaceKind
from exactspline.numbers.exact import rational, text
from exactspline.papers import Paper
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node, Traced, nodes

# ---- terms


#: The precedence of operations.
SUM, PRODUCT, UNARY, POWER, APPLICATION, ATOM = range(6)
#: The operations between scalars, with their symbols, their precedence, and the precedence that their arguments need.
_INFIX = {
    Operation.PLUS: (SUM, SUM, PRODUCT),
    Operation.MINUS: (SUM, SUM, PRODUCT),
    Operation.TIMES: (PRODUCT, PRODUCT, UNARY),
    Operation.OVER: (PRODUCT, PRODUCT, UNARY),
}
#: The functions for operations on vectors; products of vectors, and the parts of surfaces, have their own names.
_FUNCTIONS = {
    **dict(zip("+-*/", ("vadd", "vsub", "vmul", "vdiv"), strict=True)),
    **{name: name for name in ("dot", "cross", "perp", "ruled", "directrix", "generator")},
    Operation.NEGATIVE: "vneg",
}
_AXES = {"axis_x": 0, "axis_y": 1, "axis_z": 2}
_PARAMETERS = {"s": "s", "s̄": "s_bar", "u": "s", "v": "s_bar"}
#: Operands that are fields of records; the others have separate functions, named with ``_of``.
_FIELDS_OF_ARGUMENTS = {"p", "w", "gamma", "point", "sigma", "rho", "gradient_f"}
_FIELDS_OF_ARGUMENTS |= {f"{x}{i}" for x in "pwv" for i in "12"}
#: The files written by hand that the theorems about papers need, each after those that it requires.
THEORY = ("Base", "Reflection", "Proofs")
#: The reserved words of the language, and the names of variables.
_LANGUAGE = (
    "as at cofix else end exists exists2 fix for forall fun if in let match mod return then using where with Prop Set "
    "Type SProp"
)
_VARIABLES = "K A o c x y z X Y Z W a b e q l s s_bar E N O Q R S"
_DEFINED = re.compile(
    r"^\s*(?:#\[export\] )?(?:Definition|Fixpoint|Lemma|Theorem|Inductive|Record|Class|Instance|Ltac) (\w+)",
    re.MULTILINE,
)
_FIELDS = re.compile(r"^  (\w+) :(?!=)|[{;] (\w+) :(?!=)", re.MULTILINE)


@cache
def _reserved() -> frozenset[str]:
    """Words that formulas cannot have as names: those of the language and of the files written by hand."""
    words = {*_LANGUAGE.split(), *_VARIABLES.split()}
    for name in THEORY:
        text = resources.files(__package__).joinpath("theory", f"{name}.v").read_text(encoding="utf-8")
        words |= set(_DEFINED.findall(text)) | {name for pair in _FIELDS.findall(text) for name in pair if name}
        words |= set(re.findall(r":= (\w+) \{", text))
    return frozenset(words)


def identifier(name: str) -> str:
    """A name as an identifier of Coq: primes and letters are kept, anything else becomes an underscore.

    >>> identifier("C42b-g1-g0"), identifier("at"), identifier("T7′")
    ('C42b_g1_g0', 'at_', "T7'")
    """
    plain = "".join("'" if x == "′" else x if (x.isalnum() and x.isascii()) or x == "_" else "_" for x in name)
    return f"{plain}_" if plain in _reserved() else plain if plain[0].isalpha() else f"n{plain}"


class Writer:
    """Trees as terms; `named` gives the names of formulas of other files."""

    def __init__(self, named: Callable[[Formula], str], argument: str = "c", *, table: bool = False) -> None:
        self.named, self.argument, self.table = named, argument, table

    def __call__(self, node: Node) -> str:
        """The term of a tree."""
        return self.at(node, SUM)

    def at(self, node: Node, least: int) -> str:
        """The term of a tree, in parentheses if it binds less tightly than required."""
        text, binding = self.show(node)
        return text if binding >= least else f"({text})"

    def show(self, node: Node) -> tuple[str, int]:
        """The term and how tightly it binds."""
        if node.op is Operation.LEAF:
            return self.leaf(node.value), APPLICATION
        if node.op is Operation.NUMBER:
            return constant_term(node.value)
        if node.op is Operation.NAMED:
            return f"{self.named(node.value.formula)} {self.part(node.value.path)}", APPLICATION
        if node.op is Operation.LEVEL:
            # a common denominator is a step of the computation that does not change the value
            return self.show(node.args[node.value])
        if node.op in _INFIX and not node.is_vector:
            binding, left, right = _INFIX[node.op]
            return f"{self.at(node.args[0], left)} {node.op} {self.at(node.args[1], right)}", binding
        if node.op is Operation.POWER:
            return f"{self.at(node.args[0], APPLICATION)} ^ {node.value}", POWER
        if node.op is Operation.NEGATIVE and not node.is_vector:
            return f"- {self.at(node.args[0], APPLICATION)}", UNARY
        return self.applied(node), APPLICATION

    def applied(self, node: Node) -> str:
        """An operation written as a function and its arguments."""
        arguments = node.args
        if node.op is Operation.DERIVATIVE:
            return self.derivative(node)
        if node.op is Operation.COMPONENT:
            return self.taken(node)
        if node.op in (Operation.DET, Operation.GENERALIZED_CROSS):
            return f"{node.op} [{'; '.join(map(self, arguments))}]"
        if node.op is Operation.JOIN:
            return f"({' ++ '.join(map(self.joined, arguments))})"
        if node.op not in _FUNCTIONS:
            raise FormulaError(f"the operation {node.op!r} has no equivalent in Coq", remedy="add one to the base")
        if node.op is Operation.TIMES and not arguments[1].is_vector:
            arguments = arguments[::-1]
        return " ".join([_FUNCTIONS[node.op], *[self.at(each, ATOM) for each in arguments]])

    def leaf(self, name: str) -> str:
        """An operand of the argument."""
        path, _, own = name.rpartition(".")
        part = self.part(f"{path}." if path else "")
        if own in _AXES:
            return f"axis {_AXES[own]} (length (p {part}))"
        return f"{own if own in _FIELDS_OF_ARGUMENTS else f'{own}_of'} {part}"

    def part(self, path: str) -> str:
        """The part of the argument named by a path."""
        return f"({path.removesuffix('.')} {self.argument})" if path else self.argument

    def derivative(self, node: Node) -> str:
        """A derivative with respect to the named parameter, or to the one on which the operand depends."""
        order, by = node.value
        parameter = _PARAMETERS[by] if by else self.parameter(node.args[0])
        inner = self.at(node.args[0], ATOM)
        if order == 1:
            return f"{'vder' if node.is_vector else 'der'} {parameter} {inner}"
        return f"{'vders' if node.is_vector else 'ders'} {parameter} {order} {inner}"

    def parameter(self, node: Node) -> str:
        """The parameter of the curve that occurs in a tree.

        Raises `FormulaError` for a tree that depends on two of them.
        """
        parts = {f"{path}." if path else "" for path in (name.rpartition(".")[0] for name in leaves(node))}
        if len(parts) > 1:
            raise FormulaError(
                "a derivative of a value that depends on two parameters", remedy="name the parameter: d(1, by=…)"
            )
        return "s" if self.table else f"(along {self.part(parts.pop() if parts else '')})"

    def taken(self, node: Node) -> str:
        """A component of a vector, or several."""
        index, inner = node.value, self.at(node.args[0], ATOM)
        if isinstance(index, slice):
            return f"components {index.start} {index.stop} {inner}"
        return f"component {index} {inner}"

    def joined(self, node: Node) -> str:
        """A vector; a scalar becomes a vector with one component."""
        return self.at(node, APPLICATION) if node.is_vector else f"[{self(node)}]"


def constant_term(value: Constant) -> tuple[str, int]:
    """A constant; a fraction as a quotient.

    >>> constant_term(3), constant_term(rational("-1/2"))
    (('number 3', 4), ('number (-1) / number 2', 1))
    """
    exact = rational(value)
    top = f"number {integer(int(exact.numerator))}"
    return (top, APPLICATION) if exact.denominator == 1 else (f"{top} / number {text(exact.denominator)}", PRODUCT)


def integer(value: int) -> str:
    """An integer; a negative one is in parentheses."""
    return f"({text(value)})" if value < 0 else text(value)


def sum_of_products(terms: Iterable[tuple[int, Sequence[tuple[str, int]]]], number: str) -> str:
    """A sum of integers times powers, each base with its exponent; `number` is the function symbol for numbers.

    >>> sum_of_products([(-2, [("x", 1), ("y", 3)]), (1, [])], "num")
    'num 0 - num 2 * x * y ^ 3 + num 1'
    """
    texts = []
    for c, powers in terms:
        factors = [base if e == 1 else f"{base} ^ {e}" for base, e in powers]
        if abs(c) != 1 or not factors:
            factors.insert(0, f"{number} {abs(c)}")
        texts.append(("- " if c < 0 else "+ ") + " * ".join(factors))
    text = " ".join(texts) or f"+ {number} 0"
    return text.removeprefix("+ ") if text.startswith("+") else f"{number} 0 {text}"


def leaves(tree: Node) -> set[str]:
    """The operands that occur in a tree, by name."""
    return {node.value for node in nodes(tree) if node.op is Operation.LEAF}


class _Called(NamedTuple):
    """A called formula, and the part of the argument to which it is applied: ``second.``, or the whole argument."""

    formula: Formula
    path: str


class _Call(Node):
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

    def __init__(
        self, kind: Kind, dimension: int, *, path: str = "", known: dict[_Called, _Call] | None = None
    ) -> None:
        super().__init__(kind, dimension, path=path)
        self._known: dict[_Called, _Call] = {} if known is None else known

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
            self._known[called] = _Call(formula.function(self), called)
        return self._known[called]


def body(formula: Formula, dimension: int) -> Node:
    """The tree of a formula, with the formulas that it calls by name.

    >>> from exactspline.papers import find
    >>> body(find("f1"), 2).args[0].value.formula.name
    'D1'
    """
    return cast(Node, formula.function(Calling(formula.kind, dimension)))


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

    Raises `FormulaError` if one name has two positions.
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
