"""Mutants: one change in one function, found in its syntax tree, compiled and put in the place of the live function.

A change is a sign, an operand, an order of derivative, an exponent, a constant, a dropped term; in engines also a
comparison, a connective, a condition.
"""

from __future__ import annotations

import ast
import copy
import gc
import inspect
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any

from exactspline.numbers.once import cached_property
from workshop.mutation.coverage_map import meaning

ROOT = Path(__file__).resolve().parents[2]

#: A change of a node: its kind, its description, and the new node.
Change = tuple[str, str, ast.expr]

ARITHMETIC = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult}
COMPARISONS = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
#: Names of one type: each may be replaced by the next.
OPERANDS = [
    ("D1", "D2", "D3", "D21"),
    ("first", "second"),
    ("axis_x", "axis_y", "axis_z"),
    ("p1", "p2"),
    ("w1", "w2"),
    ("v1", "v2"),
    ("speed_squared", "binormal_squared"),
    ("D1_squared", "D1_x_D2_squared"),
    ("projective_lift", "conformal_lift"),
]
SWAPPED = ("cross", "det", "ruled", "generalized_cross")
DROPPED = ("perp", "norm2")


@dataclass(frozen=True)
class Mutant:
    """A change by its place: file, function, position and kind."""

    file: str
    function: str
    kind: str
    line: int
    column: int
    says: str
    number: int

    @property
    def name(self) -> str:
        """The name used in the results."""
        return f"{self.file}:{self.function}:{self.line}:{self.column}: {self.says} [{self.kind}]"

    @cached_property
    def key(self) -> str:
        """A key that identifies the mutant as long as the source of its function does not change, wherever the function
        is.
        """
        return f"{self.file}:{self.function}#{self.number}@{_meaning(self.file, self.function)}"

    @property
    def stable(self) -> str:
        """The name without line and column, which change with every edit above it."""
        return f"{self.file}:{self.function}: {self.says} [{self.kind}]"

    @property
    def module(self) -> str:
        """The module that it changes."""
        return self.file.removesuffix(".py").replace("/", ".").removesuffix(".__init__")

    def code(self) -> CodeType:
        """The changed function, compiled."""
        tree = copy.deepcopy(parsed(self.file))
        node = dict(functions(tree))[self.function]
        change = list(changes(node))[self.number]
        _Replaced(change[0], change[1][2]).visit(node)
        ast.fix_missing_locations(tree)
        return _found(compile(tree, str(ROOT / self.file), "exec"), self.function.split("."))

    def apply(self) -> None:
        """Put it in the place of the live function; `ValueError` where that cannot be done."""
        new = self.code()
        function = live(self.module, self.function)
        old = function.__code__
        function.__code__ = new
        inner = dict(zip(_inner(old), _inner(new), strict=False))
        for made in made_inside():
            if made.__code__ in inner:
                made.__code__ = inner[made.__code__]


class _Replaced(ast.NodeTransformer):
    def __init__(self, old: ast.AST, new: ast.AST) -> None:
        self.old, self.new = old, new

    def visit(self, node: ast.AST) -> Any:
        """The new node for the old one."""
        return ast.copy_location(self.new, node) if node is self.old else self.generic_visit(node)


@cache
def parsed(file: str) -> ast.Module:
    """The syntax tree of a file."""
    return ast.parse((ROOT / file).read_text(encoding="utf-8"))


@cache
def node_of(file: str, function: str) -> ast.FunctionDef:
    """A function in the syntax tree of its file."""
    return dict(functions(parsed(file)))[function]


@cache
def _meaning(file: str, function: str) -> str:
    return meaning(node_of(file, function))


def functions(tree: ast.AST, prefix: str = "") -> Iterator[tuple[str, ast.FunctionDef]]:
    """The functions and methods by qualified name."""
    for child in ast.iter_child_nodes(tree):
        if isinstance(child, ast.ClassDef):
            yield from functions(child, f"{prefix}{child.name}.")
        elif isinstance(child, ast.FunctionDef):
            yield prefix + child.name, child


def _found(code: CodeType, path: list[str]) -> CodeType:
    """The last code object with that path (a property's setter would come after its getter; there are none)."""
    if not path:
        return code
    inner = [c for c in code.co_consts if isinstance(c, CodeType) and c.co_name == path[0]]
    return _found(inner[-1], path[1:])


def _inner(code: CodeType) -> list[CodeType]:
    """The code objects of the functions defined inside, in order."""
    return [c for c in code.co_consts if isinstance(c, CodeType)]


def live(module: str, function: str) -> FunctionType:
    """The live function, without its decorators."""
    value: Any = sys.modules.get(module) or import_module(module)
    for part in function.split("."):
        value = vars(value)[part]
    if isinstance(value, property):
        value = value.fget
    value = next((f for name in ("function", "compute", "__func__") if (f := getattr(value, name, None))), value)
    value = getattr(value, "func", None) or value
    function_object = inspect.unwrap(value)
    if not isinstance(function_object, FunctionType):
        raise ValueError(f"{module}:{function} is not a function")
    return function_object


@cache
def made_inside() -> list[FunctionType]:
    """The inner functions that were created when modules were imported."""
    inner = [f for f in gc.get_objects() if type(f) is FunctionType and "<locals>" in f.__qualname__]
    return [f for f in inner if str(f.__module__).startswith("exactspline")]


def mutants(file: str) -> list[Mutant]:
    """Every mutant of a file."""
    all_mutants = []
    for name, node in functions(parsed(file)):
        if node.name.startswith("_repr_") or node.name == "__repr__":
            continue
        for i, (old, (kind, says, _)) in enumerate(changes(node)):
            all_mutants.append(Mutant(file, name, kind, old.lineno, old.col_offset, says, i))
    return all_mutants


def changes(function: ast.FunctionDef) -> Iterator[tuple[ast.expr, Change]]:
    """All changes of a function, each with the node that it replaces."""
    for node in _expressions(function):
        for change in _changes(node):
            yield node, change


def _expressions(function: ast.FunctionDef) -> Iterator[ast.expr]:
    """The expressions of the body: without docstrings, annotations, and the arguments of errors."""
    todo: list[ast.AST] = list(reversed(function.body))
    while todo:
        node = todo.pop()
        if isinstance(node, (ast.Raise, ast.Import, ast.ImportFrom, ast.JoinedStr)):
            continue
        if isinstance(node, ast.keyword) and node.arg == "strict":
            continue
        if isinstance(node, ast.expr):
            yield node
        children = [
            child
            for name, field in ast.iter_fields(node)
            if name not in ("annotation", "returns", "decorator_list") and not (name == "right" and _is_power(node))
            for child in (field if isinstance(field, list) else [field])
            if isinstance(child, ast.AST)
        ]
        todo += reversed(children)


def _is_power(node: ast.AST) -> bool:
    """Whether it is a power with a constant exponent, which is changed as a whole."""
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant)


def _changes(node: ast.expr) -> Iterator[Change]:
    for change in _OF.get(type(node), lambda _: iter(()))(node):
        kind, new = change
        yield kind, f"{_short(node)} → {_short(new)}", new


def _short(node: ast.AST) -> str:
    text = " ".join(ast.unparse(node).split())
    return text if len(text) <= 70 else f"{text[:34]} … {text[-33:]}"


def _binary(node: ast.BinOp) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.op, ast.Pow):
        if isinstance(node.right, ast.Constant) and isinstance(node.right.value, int):
            for k in (node.right.value + 1, node.right.value - 1):
                power = node.left if k == 1 else ast.BinOp(node.left, ast.Pow(), ast.Constant(k))
                if k >= 1:
                    yield "exponent", power
        return
    if type(node.op) in ARITHMETIC:
        kind = "sign" if isinstance(node.op, (ast.Add, ast.Sub)) else "operation"
        yield kind, ast.BinOp(node.left, ARITHMETIC[type(node.op)](), node.right)
        yield "dropped", node.left
        if not isinstance(node.op, (ast.Div, ast.FloorDiv)):
            yield "dropped", node.right


def _unary(node: ast.UnaryOp) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.op, ast.USub) and not isinstance(node.operand, ast.Constant):
        yield "sign", node.operand
    if isinstance(node.op, ast.Not):
        yield "condition", node.operand


def _constant(node: ast.Constant) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.value, bool):
        yield "constant", ast.Constant(not node.value)
    elif isinstance(node.value, int):
        yield "constant", ast.Constant(node.value + 1)
        yield "constant", ast.Constant(node.value - 1)


def _call(node: ast.Call) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.func, ast.Attribute) and node.func.attr == "d":
        order = node.args[0].value if node.args and isinstance(node.args[0], ast.Constant) else None
        if order is None and not node.args:
            yield "order", node.func.value
        if order == 1:
            yield "order", node.func.value
    if isinstance(node.func, ast.Name):
        if node.func.id in SWAPPED and len(node.args) >= 2:
            yield "operand", ast.Call(node.func, [node.args[1], node.args[0], *node.args[2:]], node.keywords)
        if node.func.id in DROPPED and len(node.args) == 1:
            yield "operand", node.args[0]
        swap = {"min": "max", "max": "min", "any": "all", "all": "any"}.get(node.func.id)
        if swap:
            yield "operand", ast.Call(ast.Name(swap, ast.Load()), node.args, node.keywords)


def _compare(node: ast.Compare) -> Iterator[tuple[str, ast.expr]]:
    for i, op in enumerate(node.ops):
        ops = [*node.ops]
        ops[i] = COMPARISONS[type(op)]()
        yield "comparison", ast.Compare(node.left, ops, node.comparators)


def _connective(node: ast.BoolOp) -> Iterator[tuple[str, ast.expr]]:
    yield "connective", ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
    for i in range(len(node.values)):
        rest = node.values[:i] + node.values[i + 1 :]
        yield "dropped", rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)


def _conditional(node: ast.IfExp) -> Iterator[tuple[str, ast.expr]]:
    yield "condition", ast.IfExp(node.test, node.orelse, node.body)


def _successor(name: str) -> str | None:
    for group in OPERANDS:
        if name in group:
            return group[(group.index(name) + 1) % len(group)]
    return None


def _name(node: ast.Name) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.ctx, ast.Load) and (other := _successor(node.id)):
        yield "operand", ast.Name(other, ast.Load())


def _attribute(node: ast.Attribute) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node.ctx, ast.Load) and (other := _successor(node.attr)):
        yield "operand", ast.Attribute(node.value, other, ast.Load())


_OF: dict[type, Callable[[Any], Iterator[tuple[str, ast.expr]]]] = {
    ast.BinOp: _binary,
    ast.UnaryOp: _unary,
    ast.Constant: _constant,
    ast.Call: _call,
    ast.Compare: _compare,
    ast.BoolOp: _connective,
    ast.IfExp: _conditional,
    ast.Name: _name,
    ast.Attribute: _attribute,
}


def drawn(all_mutants: list[Mutant], count: int, seed: int) -> list[Mutant]:
    """This many mutants, drawn as evenly as possible from every module, the same for the same seed.

    Mutants already drawn stay the same when more are drawn, and when other functions are edited, so that a run can be
    continued.
    """
    by_file: dict[str, list[Mutant]] = {}
    for mutant in sorted(all_mutants, key=lambda m: sha256(f"{seed} {m.key}".encode()).digest(), reverse=True):
        by_file.setdefault(mutant.file, []).append(mutant)
    chosen: list[Mutant] = []
    while len(chosen) < count and any(by_file.values()):
        for file in sorted(by_file):
            if by_file[file] and len(chosen) < count:
                chosen.append(by_file[file].pop())
    return chosen
