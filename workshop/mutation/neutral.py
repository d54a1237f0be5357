"""Changes on which no answer depends, by where they stand: in an estimate of the cost of a computation, which decides
what is refused, and in the precision at which a loop begins or by which it grows, since it ends when its answer is
certain; where a few precisions are tried in turn, in all of it.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cache

from workshop.mutation.mutants import Mutant, changes, functions, node_of, parsed

ESTIMATE = "an estimate of the cost: what is refused, not an answer"
PRECISION = "the precision at which a loop begins, or by which it grows until its answer is certain"
#: The functions that take an estimate and do nothing else with it (`exactspline.polynomials.cost`).
TAKEN = frozenset({"check_reach", "affords"})
#: The names of working precisions.
PRECISIONS = frozenset({"bits", "digits", "precision"})


def neutral(mutant: Mutant) -> str | None:
    """Why no answer depends on the change, if its place says it."""
    function = node_of(mutant.file, mutant.function)
    old, (_, _, new) = list(changes(function))[mutant.number]
    if id(old) in _estimates(mutant.file):
        return ESTIMATE
    loops = [node for loop in ast.walk(function) if isinstance(loop, ast.For) for node in ast.walk(loop)]
    is_tried = id(old) in {id(x) for node in loops for x in _working(node)}
    return PRECISION if is_tried or _is_precision(function, old, new) else None


# ---- estimates


@cache
def _estimates(file: str) -> frozenset[int]:
    """The expressions of a file of which only estimates are made."""
    tree = parsed(file)
    named = dict(functions(tree))
    taken, estimating = TAKEN, frozenset[str]()
    while True:
        known = {id(x) for node in named.values() for x in _within(node, taken)}
        known |= {id(x) for name in estimating for x in ast.walk(named[name])}
        more_taken = taken | {node.name for node in named.values() if _only_checks(node, taken)}
        private = [name for name in named if name.startswith("_") and not name.endswith("__")]
        more = frozenset(name for name in private if _only_used(tree, named[name], "." in name, known))
        if (more_taken, more) == (taken, estimating):
            return frozenset(known)
        taken, estimating = more_taken, more


def _within(function: ast.FunctionDef, taken: frozenset[str]) -> Iterator[ast.AST]:
    """The expressions in what is taken as an estimate, and in what is assigned to names that occur only there."""
    statements = [s for s in ast.walk(function) if isinstance(s, (ast.Assign, ast.AugAssign))]
    assigned = [(target, s.value) for s in statements if (target := _target(s))]
    names = {target for target, _ in assigned}
    while True:
        regions = [argument for call in _calls(function, taken) for argument in (*call.args, *call.keywords)]
        regions += [value for target, value in assigned if target in names]
        inside = {id(x) for region in regions for x in ast.walk(region)}
        read = [x for x in ast.walk(function) if isinstance(x, ast.Name) and isinstance(x.ctx, ast.Load)]
        loose = {x.id for x in read if id(x) not in inside}
        if not names & loose:
            break
        names -= loose
    for region in regions:
        yield from ast.walk(region)


def _target(statement: ast.Assign | ast.AugAssign) -> str | None:
    """The local name to which a statement assigns, if it is one name."""
    target = statement.target if isinstance(statement, ast.AugAssign) else statement.targets[0]
    return target.id if isinstance(target, ast.Name) else None


def _calls(tree: ast.AST, names: Iterable[str]) -> Iterator[ast.Call]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in names:
            yield node


def _only_checks(function: ast.FunctionDef, taken: frozenset[str]) -> bool:
    """Whether a function does nothing but hand an estimate on."""
    inside = {id(x) for x in _within(function, taken)}
    calls = {id(call) for call in _calls(function, taken)}

    def is_handed_on(statement: ast.stmt) -> bool:
        value = getattr(statement, "value", None)
        return isinstance(value, ast.Constant) or id(value) in (calls if isinstance(statement, ast.Expr) else inside)

    return bool(calls) and all(map(is_handed_on, function.body))


def _only_used(tree: ast.AST, function: ast.FunctionDef, is_method: bool, known: set[int]) -> bool:
    """Whether a function of one file returns a value, changes nothing else, and is asked for estimates alone."""
    written = [s.targets[0] for s in function.body if isinstance(s, ast.Assign)]
    plain = all(isinstance(s, (ast.Expr, ast.Return, ast.Assign)) for s in function.body)
    plain = plain and all(isinstance(target, (ast.Name, ast.Tuple)) for target in written)
    kind, of = (ast.Attribute, "attr") if is_method else (ast.Name, "id")
    uses = [x for x in ast.walk(tree) if isinstance(x, kind) and getattr(x, of) == function.name]
    return plain and bool(uses) and all(id(x) in known for x in uses)


# ---- precisions


def _is_precision(function: ast.FunctionDef, old: ast.AST, new: ast.expr) -> bool:
    """Whether a constant is changed in the working precision of a loop that still grows."""
    if not isinstance(old, ast.Constant) or not isinstance(new, ast.Constant) or isinstance(old.value, bool):
        return False
    loops = [x for x in ast.walk(function) if isinstance(x, ast.While)]
    grown = {name for loop in loops for s in ast.walk(loop) for name, _ in _named(s)}
    first = [x for s in ast.walk(function) if not isinstance(s, ast.AugAssign) for x in _of_precision(s, grown)]
    steps = [s for loop in loops for s in ast.walk(loop) if isinstance(s, ast.AugAssign)]
    least = {id(x): 1 for x in first} | {
        id(x): 2 if isinstance(s.op, ast.Mult) else 1 for s in steps for x in _of_precision(s, grown)
    }
    least |= {id(x): 1 for loop in loops for s in ast.walk(loop) for x in _working(s)}
    return id(old) in least and isinstance(new.value, int) and new.value >= least[id(old)]


def _named(statement: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """The names of precisions to which a statement assigns, and what."""
    if isinstance(statement, (ast.Assign, ast.AugAssign)):
        target = statement.targets[0] if isinstance(statement, ast.Assign) else statement.target
        pairs = [(target, statement.value)]
        if isinstance(target, ast.Tuple) and isinstance(statement.value, ast.Tuple):
            pairs = list(zip(target.elts, statement.value.elts, strict=False))
        for name, value in pairs:
            if isinstance(name, ast.Name) and name.id in PRECISIONS:
                yield name.id, value


def _of_precision(statement: ast.AST, grown: set[str]) -> Iterator[ast.expr]:
    for name, value in _named(statement):
        if name in grown and isinstance(value, ast.Constant):
            yield value


def _working(node: ast.AST) -> Iterator[ast.AST]:
    """The expressions in a working precision of balls."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "workprec":
        for argument in node.args:
            yield from ast.walk(argument)
