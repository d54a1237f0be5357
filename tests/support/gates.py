"""What the laws of the house forbid, each found in a syntax tree: the same function looks at the code and at a planted
violation.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache

from tests.support.import_graph import ROOT, files, nodes

#: Looks for violations in one file: each by its place in the file.
Finder = Callable[[ast.Module], Iterable[str]]


def trees() -> dict[str, ast.Module]:
    """The syntax tree of every file of the package."""
    return {path.relative_to(ROOT).as_posix(): tree for path, tree in files().items()}


def found_in(files: dict[str, ast.Module], finder: Finder, rooms: Iterable[str] = ("",)) -> set[str]:
    """The violations in some rooms: ``file: place``."""
    return {
        f"{name}: {place}"
        for name, tree in files.items()
        if any(name.startswith(room) for room in rooms)
        for place in finder(tree)
    }


@cache
def scopes(tree: ast.Module) -> tuple[tuple[str, ast.AST], ...]:
    """Every node, in the order of the text, with the class and function in which it stands."""
    found, waiting = [], [("", child) for child in ast.iter_child_nodes(tree)][::-1]
    while waiting:
        place, node = waiting.pop()
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            place = f"{place}.{node.name}".lstrip(".")
        found.append((place, node))
        waiting += [(place, child) for child in ast.iter_child_nodes(node)][::-1]
    return tuple(found)


# ---- law 3: no code reads a sentence

#: Attributes that hold what is said to people.
SENTENCES = {
    "computed",
    "meaning",
    "message",
    "note",
    "notes",
    "problem",
    "reason",
    "remark",
    "remedy",
    "statement",
    "words",
}
#: Parameters that hold such a text, by their names; `words` are as often those of a file.
TEXTS = {"message", "note", "problem", "reason", "remark", "remedy"}
#: What looks into a text, by whatever name.
LOOKS = {
    "count",
    "endswith",
    "find",
    "findall",
    "finditer",
    "fullmatch",
    "get",
    "index",
    "len",
    "match",
    "partition",
    "removeprefix",
    "removesuffix",
    "rfind",
    "rindex",
    "rpartition",
    "rsplit",
    "search",
    "split",
    "startswith",
}
#: What also looks into tables and lists: only the first operand, if it is a text for people.
PARTLY = {"get", "len"}
#: Two words, as a sentence has them and a name does not.
TWO_WORDS = re.compile(r"[^\W\d_]{2,} [^\W\d_]{2,}")


#: The parts of a finding: data, which are compared as such; their texts are for people.
FOUND = {"evidence", "factor", "finding", "verdict", "witness"}
#: Functions that say something in words.
WORDED = {"opinion", "worded", "words"}


def is_sentence(node: ast.AST) -> bool:
    """Whether an expression is a text for people: an attribute that holds one, the text of an error or of a part of a
    finding, two words.
    """
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str) and bool(TWO_WORDS.search(node.value))
    if isinstance(node, ast.Attribute):
        return node.attr in SENTENCES
    if isinstance(node, ast.Subscript):
        return isinstance(node.slice, ast.Constant) and node.slice.value in SENTENCES | FOUND
    if isinstance(node, ast.JoinedStr):
        return any(isinstance(each, ast.FormattedValue) and is_found(each.value) for each in node.values)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.args:
        made = node.func.id in ("str", "repr", "format")
        own = is_found(node.args[0]) or ast.unparse(node.args[0]) in ("error", "problem", "failure", "e")
        return node.func.id in WORDED or (made and own)
    return False


def is_found(node: ast.AST) -> bool:
    """Whether an expression is a part of what was found, or its text; a claim states its own factor."""
    of_claim = isinstance(node, ast.Attribute) and ast.unparse(node.value) in ("self", "claim")
    return is_sentence(node) or (isinstance(node, ast.Attribute) and node.attr in FOUND and not of_claim)


def holders(tree: ast.Module) -> dict[str, set[str]]:
    """By function, the variables that hold a text for people: parameters that are called so, and what is assigned from
    such a text, through any number of steps.
    """
    held: dict[str, set[str]] = {}
    assigned = []
    for place, node in scopes(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            given = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
            held.setdefault(place, set()).update({each.arg for each in given} & TEXTS)
        named = [pair for pair in assignments(node) if isinstance(pair[0], ast.Name) and pair[0].id.islower()]
        assigned += [(place, target.id, value) for target, value in named]
    size = -1
    while size != (size := sum(map(len, held.values()))):
        for place, name, value in assigned:
            names = held.setdefault(place, set()) if place else set[str]()
            if is_made_of_sentence(value, names):
                names.add(name)
    return held


def assignments(node: ast.AST) -> Iterator[tuple[ast.expr, ast.expr]]:
    """What a node assigns: each target with its value, or with the sequence that it runs through."""
    if isinstance(node, ast.Assign):
        yield from ((target, node.value) for target in node.targets)
    elif isinstance(node, (ast.AnnAssign, ast.NamedExpr)) and node.value is not None:
        yield node.target, node.value
    elif isinstance(node, (ast.For, ast.comprehension)):
        yield node.target, node.iter


def is_made_of_sentence(node: ast.AST, held: set[str]) -> bool:
    """Whether an expression is a text for people that is not written out there: the text of something, perhaps another
    where that is empty, a part of it, or what a method makes of it (`text.lower()`).
    """
    if isinstance(node, ast.Name):
        return node.id in held
    if isinstance(node, ast.BoolOp):
        return any(is_made_of_sentence(each, held) for each in node.values)
    if isinstance(node, ast.IfExp):
        return is_made_of_sentence(node.body, held) or is_made_of_sentence(node.orelse, held)
    if isinstance(node, ast.Subscript):
        return is_made_of_sentence(node.value, held)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        return is_made_of_sentence(node.func.value, held)
    return not isinstance(node, ast.Constant) and is_sentence(node)


def mentions_sentence(node: ast.AST, held: Iterable[str] = ()) -> bool:
    """Whether a sentence stands in an expression, or a variable that holds one."""
    return any(is_sentence(each) or (isinstance(each, ast.Name) and each.id in held) for each in ast.walk(node))


def decisions_by_sentences(tree: ast.Module) -> Iterator[str]:
    """Where a text for people is searched, cut, compared or looked up."""
    held_in = holders(tree)
    for place, node in scopes(tree):
        held = held_in.get(place, ())
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            operands = [*node.args, *([node.func.value] if isinstance(node.func, ast.Attribute) else [])]
            # text.split() does away with line breaks
            looks = name in LOOKS and (node.args or name != "split")
            if name in PARTLY:
                operands = [each for each in operands[:1] if is_made_of_sentence(each, set(held))]
            if looks and any(mentions_sentence(each, held) for each in operands):
                yield place
        elif isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
            texts = [each for each in sides if isinstance(each, (ast.Constant, ast.JoinedStr))]
            words = any(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in texts)
            pairs = zip(node.ops, node.comparators, strict=True)
            if (
                any(
                    isinstance(op, (ast.In, ast.NotIn, ast.Eq, ast.NotEq)) and is_made_of_sentence(text, set(held))
                    for op, text in pairs
                )
                or any(is_sentence(each) for each in texts)
                or (words and any(mentions_sentence(each, held) for each in sides))
            ):
                yield place
        elif isinstance(node, ast.Subscript) and ast.unparse(node.value) not in ("Annotated", "Literal"):
            # a plain key of a row may have two words
            if not isinstance(node.slice, ast.Constant) and mentions_sentence(node.slice, held):
                yield place
        elif isinstance(node, ast.MatchValue) and is_sentence(node.value):
            yield place
        if reads_what_was_found(node):
            yield place


def reads_what_was_found(node: ast.AST) -> bool:
    """Whether a part of a finding is searched, cut or compared as a text."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        looks = node.func.attr in LOOKS - PLACES - PARTLY and (node.args or node.func.attr != "split")
        return bool(looks) and any(map(is_found, [node.func.value, *node.args]))
    if isinstance(node, ast.Compare):
        sides = [node.left, *node.comparators]
        return any(isinstance(x, ast.Constant) and isinstance(x.value, str) for x in sides) and any(
            map(is_found, sides)
        )
    if isinstance(node, ast.Subscript):
        return isinstance(node.slice, ast.Slice) and is_found(node.value)
    return isinstance(node, ast.Match) and is_found(node.subject) and "MatchValue(value=Constant" in ast.dump(node)


#: Where a thing stands in a list, as well.
PLACES = {"count", "index"}
#: What names a thing: it may be compared, and is not taken apart.
NAMES = {"name", "title", "label", "id", "key"}


def names_taken_apart(tree: ast.Module) -> Iterator[str]:
    """Where a part of a name decides: its beginning, its end, a pattern."""
    for place, node in scopes(tree):
        if (
            isinstance(node, ast.Call)
            and isinstance(node.func, ast.Attribute)
            and node.func.attr in LOOKS - PLACES - PARTLY
        ):
            texts = [node.func.value, *node.args]
            found = {each.attr if isinstance(each, ast.Attribute) else getattr(each, "id", "") for each in texts}
            if found & NAMES:
                yield place


# ---- law 4: a question is an entry

#: What an answer to a question about places looks like.
ANSWERS = {"Places", "SurfacePlaces", "Answer"}
#: Lists that cannot say whether they are "none" or "all".
LISTS = {"list", "tuple", "Sequence", "Iterator", "Iterable", "set", "frozenset"}
FEATURES = {"Feature", "Place", "Root", "Umbilic"}


#: What makes a function an entry of the registry.
ENTRY = {"question", "question_with"}


def marks(node: ast.FunctionDef) -> set[str]:
    """The names of the decorators of a function."""
    return {ast.unparse(mark.func if isinstance(mark, ast.Call) else mark) for mark in node.decorator_list}


def names_in(node: ast.AST | None) -> set[str]:
    """The names that stand in an annotation, also in one that is a text."""
    if node is None:
        return set()
    texts = [each.value for each in ast.walk(node) if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    inner = [name for text in texts if text.strip() for name in names_in(ast.parse(text, mode="eval").body)]
    return {each.id for each in ast.walk(node) if isinstance(each, ast.Name)} | set(inner)


def public(tree: ast.Module, *, entries: bool) -> Iterator[tuple[str, ast.FunctionDef]]:
    """Public functions and methods, with or without the entries of the registry."""
    for place, node in scopes(tree):
        private = any(part.startswith("_") for part in place.split("."))
        if isinstance(node, ast.FunctionDef) and not private and (entries or not marks(node) & ENTRY):
            yield place, node


def unregistered(tree: ast.Module) -> Iterator[str]:
    """Public functions whose result is an answer about places, that are not entries of the registry."""
    return (place for place, node in public(tree, entries=False) if names_in(node.returns) & ANSWERS)


def asked_classes(tree: ast.Module) -> Iterator[str]:
    """Classes that have questions."""
    for place, node in scopes(tree):
        if isinstance(node, ast.ClassDef):
            inner = [each for each in node.body if isinstance(each, ast.FunctionDef)]
            if any(marks(each) & ENTRY for each in inner):
                yield place


def lists_of_questions(tree: ast.Module, names: set[str]) -> Iterator[str]:
    """Displays (lists, tuples, sets, dictionaries) that spell out three questions or more, by name or as attributes."""
    for place, node in scopes(tree):
        parts: list[ast.expr | None] = []
        if isinstance(node, (ast.List, ast.Tuple, ast.Set)):
            parts = [*node.elts]
        elif isinstance(node, ast.Dict):
            parts = [*node.keys, *node.values]
        elif isinstance(node, ast.Call):
            parts = [*node.args]
        spelled = {
            inner.value if isinstance(inner, ast.Constant) else inner.attr
            for part in parts
            if part is not None
            for inner in ast.walk(part)
            if isinstance(inner, (ast.Constant, ast.Attribute))
        }
        if len(spelled & names) >= 3:
            yield place


# ---- law 5: a number is a number

#: What a number that is not a polynomial can do.
ORDERED = {"__lt__", "__float__"}
NUMBER = {"__add__", "__sub__", "__mul__", "__float__", "double", "enclosure", "minimal_polynomial", "refine", "sign"}


def numbers(tree: ast.Module) -> Iterator[str]:
    """Classes that are real numbers of their own: with an order or a conversion to float, and arithmetic, enclosures or
    a minimal polynomial; views of the one real type derive from it.
    """
    for place, node in scopes(tree):
        if isinstance(node, ast.ClassDef) and not {"Real"} & {name for base in node.bases for name in names_in(base)}:
            own = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
            assigned = (target for each in node.body if isinstance(each, ast.Assign) for target in each.targets)
            own |= {target.id for target in assigned if isinstance(target, ast.Name)}
            if own & ORDERED and own & NUMBER:
                yield place


def ways_to_a_curvature(tree: ast.Module) -> Iterator[str]:
    """Public functions and methods, no entries of the registry, that are called curvature or torsion."""
    named = re.compile("curvature|torsion|kappa")
    return (place for place, node in public(tree, entries=False) if named.search(node.name))


# ---- law 6: none, all of these, or these


def lists_of_places(tree: ast.Module) -> Iterator[str]:
    """Questions and public functions whose result is a bare list of points: an empty one is both none and all."""
    for place, node in public(tree, entries=True):
        names = names_in(node.returns)
        if names & LISTS and names & FEATURES and not names & ANSWERS:
            yield place


# ---- exact rooms

#: Rooms between input and verdict.
EXACT = (
    "numbers/",
    "formulas/",
    "polynomials/",
    "reals/",
    "language/",
    "papers/",
    "splines/",
    "readings/",
    "interchange/",
    "programs/",
    "symbolic/",
    "questions/",
    "geometry/",
    "bivariate/",
    "roots/",
    "verification/",
    "extras/cad/",
    "extras/coq/",
    "extras/teaching/",
)
ROUNDING = {"double", "float", "round", "complex", "isclose", "allclose", "fsum", "float64", "longdouble"}
ROUNDED_MODULES = {"math", "cmath", "numpy", "random", "decimal"}
EXACT_FUNCTIONS = {"ceil", "comb", "factorial", "floor", "gcd", "isqrt", "lcm", "perm", "prod"}


#: What may be given a type of numbers and rounds nothing.
TYPED = {"cast", "isinstance", "issubclass"}


def handed_on(node: ast.AST) -> bool:
    """Whether a function that rounds is given to another one: `map(float, xs)`."""
    if not isinstance(node, ast.Call) or getattr(node.func, "id", "") in TYPED:
        return False
    given = [*node.args, *(each.value for each in node.keywords)]
    return any(isinstance(each, ast.Name) and each.id in ROUNDING for each in given)


def aliased(node: ast.AST) -> bool:
    """Whether a function that rounds gets another name: `number = float`."""
    return any(isinstance(value, ast.Name) and value.id in ROUNDING for _, value in assignments(node))


def rounding(tree: ast.Module) -> Iterator[str]:
    """Where a number is rounded: `float(x)`, `round`, functions of `math` that are not exact."""
    inexact = {
        alias.asname or alias.name
        for node in nodes(tree)
        if isinstance(node, ast.ImportFrom) and node.module in ROUNDED_MODULES
        for alias in node.names
    } - EXACT_FUNCTIONS
    for place, node in scopes(tree):
        if handed_on(node) or aliased(node):
            yield place or "at the top"
        elif isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            of_math = isinstance(node.func, ast.Attribute) and ast.unparse(node.func.value) in ("math", "cmath")
            by_name = isinstance(node.func, ast.Name) and name in inexact
            if name in ROUNDING or by_name or (of_math and name not in EXACT_FUNCTIONS):
                yield place or "at the top"
        elif isinstance(node, ast.Attribute) and node.attr == "__float__":
            yield place or "at the top"


# ---- no cost without a bound

#: What FLINT does in one call that cannot be interrupted, of a cost that the size of the answer does not show.
COSTLY = {"complex_roots", "discriminant", "factor", "factor_smooth", "factor_squarefree", "gcd", "resultant", "xgcd"}


def unbounded_costs(tree: ast.Module) -> Iterator[str]:
    """Where a polynomial itself is asked for a common divisor, a factorization, a resultant or a discriminant: called,
    or handed on as a function.
    """
    for place, node in scopes(tree):
        found = node.func if isinstance(node, ast.Call) else node
        if not isinstance(found, ast.Attribute) or found.attr not in COSTLY:
            continue
        # an attribute may have such a name, but not of a class of FLINT
        if found is not node or ast.unparse(found.value).startswith(("fmp", "nmod_", "flint.")):
            yield place


# ---- no error is hidden

#: What catches errors of the program itself.
WHOLE = {"BaseException", "Exception"}


def caught_whole(tree: ast.Module) -> Iterator[str]:
    """Where every exception is caught, or suppressed."""
    for place, node in scopes(tree):
        if isinstance(node, ast.ExceptHandler):
            last = node.body[-1]
            raised = isinstance(last, ast.Raise) and last.exc is None
            if not raised and (node.type is None or names_in(node.type) & WHOLE):
                yield place
        elif (
            isinstance(node, ast.Call)
            and getattr(node.func, "id", getattr(node.func, "attr", "")) == "suppress"
            and any(names_in(each) & WHOLE for each in node.args)
        ):
            yield place


# ---- what is imported for the type checker alone


def casts_without_a_type(tree: ast.Module) -> Iterator[str]:
    """Where a name that is imported for the type checker alone is the first argument of `cast`, not as a text."""
    blocks = [node for node in ast.walk(tree) if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"]
    imported = [each for block in blocks for each in block.body if isinstance(each, (ast.Import, ast.ImportFrom))]
    alone = {each.asname or each.name for one in imported for each in one.names}
    for place, node in scopes(tree):
        is_cast = isinstance(node, ast.Call) and ast.unparse(node.func) == "cast"
        if is_cast and {each.id for each in ast.walk(node.args[0]) if isinstance(each, ast.Name)} & alone:
            yield place


# ---- what is private


def foreign_private_names(tree: ast.Module, allowed: Iterable[str]) -> Iterator[str]:
    """Private names that a module asks of another: attributes that none of its classes and functions has or uses of
    itself, and imported names.
    """
    own = set(allowed)
    for node in nodes(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            own.add(node.name)
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in ("self", "cls"):
            own.add(node.attr)
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            own |= {each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)}
    for place, node in scopes(tree):
        asked = [node.attr] if isinstance(node, ast.Attribute) else []
        if isinstance(node, ast.ImportFrom):
            asked = [alias.name for alias in node.names]
        for name in asked:
            if name.startswith("_") and not name.endswith("__") and name not in own:
                yield f"{place}: {name}"


# ---- law 7: what is in the wheel


def reached(graph: dict[str, set[str]], entrances: Iterable[str]) -> set[str]:
    """The modules that can be reached from the entrances; a module brings the packages around it."""
    seen: set[str] = set()
    waiting = list(entrances)
    while waiting:
        name = waiting.pop()
        if name in seen or name not in graph:
            continue
        seen.add(name)
        waiting += graph[name]
        if "." in name:
            waiting.append(name.rpartition(".")[0])
    return seen
