"""Users' formulas, checked before they run.

A file of formulas is code. Before any of it runs, its syntax tree is checked: it may contain functions whose bodies are
expressions of the language (``+ − * / **``, derivatives, the operands of an argument, products of vectors) and calls of
functions defined above them. The checked code is compiled and run without any of Python's built-in names, so that it
can access only the names listed here.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import factorial
from typing import Any

from exactspline.errors import ExactSplineError, FormulaError, counted, nearest, shown
from exactspline.language.complex_numbers import complex_product, complex_quotient, conjugate
from exactspline.language.formula import Formula, formula
from exactspline.language.kinds import CURVE, KINDS, Kind, kind_of
from exactspline.language.operand import Parameter
from exactspline.language.ruled import ruled
from exactspline.language.vector import cross, det, dot, generalized_cross, join, norm2, perp, triple
from exactspline.language.wronskians import wronskian
from exactspline.numbers.exact import rational
from exactspline.papers.symbols import not_a_symbol

#: The names that a file of formulas may import from exactspline and call.
LANGUAGE: dict[str, Callable[..., Any]] = {
    "complex_product": complex_product,
    "complex_quotient": complex_quotient,
    "conjugate": conjugate,
    "cross": cross,
    "det": det,
    "dot": dot,
    "formula": formula,
    "generalized_cross": generalized_cross,
    "join": join,
    "norm2": norm2,
    "perp": perp,
    "rational": rational,
    "ruled": ruled,
    "triple": triple,
    "wronskian": wronskian,
}
#: The modules from which these names may be imported, and the names of each module.
HOMES: dict[str, set[str]] = {
    "exactspline": {"rational"},
    "exactspline.language": LANGUAGE.keys() - {"rational"},
    **{f"exactspline.language.{name}": set(LANGUAGE) for name in ("complex_numbers", "vector", "wronskians")},
}
IMPORT = 'write "from exactspline.language import formula, det, …"'
#: Packages from whose modules formulas may be imported.
ROOMS = ("exactspline.formulas.", "exactspline.papers.")
TRUST = "--trust runs the file unchecked, with all permissions of Python"
#: Limits on the size of a file, the size of a formula with all calls expanded, powers, derivatives, and the degree.
CHARACTERS, WRITTEN_OUT, POWER, ORDER, DEGREE, DIGITS = 200_000, 100_000, 64, 20, 2000, 200
#: The maximal number of rows of a determinant, and of products in its expansion.
LARGE, DETERMINANT = 20, 40_320
#: Functions whose value has the same number of components as one of their arguments.
PAIRS = {"complex_product", "complex_quotient", "conjugate"}
_OPERATORS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.Pow)
_BRANCHES = (ast.If, ast.IfExp, ast.BoolOp, ast.Compare, ast.While, ast.Match, ast.Assert, ast.Try)
_REPEATS = (ast.For, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


@dataclass
class Checked:
    """The functions checked so far: for each its size with all calls expanded, its degree, and the maximal number of
    components of its value if its arguments are scalars.
    """

    file: str
    functions: dict[str, tuple[int, int]] = field(default_factory=dict)
    lengths: dict[str, int] = field(default_factory=dict)
    imported: set[str] = field(default_factory=set)
    attributes: set[str] = field(default_factory=set)
    vectors: dict[str, int] = field(default_factory=dict)
    constants: set[str] = field(default_factory=set)
    parameters: set[Parameter] = field(default_factory=set)

    def refuse(self, node: ast.AST, problem: str, remedy: str = TRUST) -> FormulaError:
        """The error for a construct that is not allowed, with file and line."""
        return FormulaError(problem, where=f"{self.file}, line {getattr(node, 'lineno', 1)}", remedy=remedy)


#: The errors for refused parts of a file, by the name of the formula, or by the line.
Refused = dict[str, ExactSplineError]


def formulas_of(
    text: str, file: str, known: Mapping[str, Formula], *, plain: bool = False, refused: Refused | None = None
) -> dict[str, Formula]:
    """The formulas of a file, checked and then run. `known` are formulas of other papers, by ``module:name``; with
    `plain`, undecorated functions of one argument are formulas of a curve. With `refused`, a formula that is not
    allowed is put into `refused` with its error, and the other formulas are returned.

    >>> text = "@formula('eq. (1)', on='plane')\\ndef f(c): return det(c.p, c.p.d(1))"
    >>> formulas_of(f"from exactspline.language import formula, det\\n{text}", "formulas.py", {})
    {'f': <formula f, eq. (1)>}
    >>> formulas_of("import os", "my.py", {})
    Traceback (most recent call last):
    exactspline.errors.FormulaError: my.py, line 1: import os; write "from exactspline.language import formula, det, …"

    Raises `FormulaError`, with file and line, for anything that is not allowed in a formula.
    """
    with _not_python(file):
        return _run(_parsed(text, file), file, known, plain, refused)


@contextmanager
def _not_python(file: str) -> Iterator[None]:
    """Raise `FormulaError` for text that Python refuses."""
    try:
        yield
    except (
        SyntaxError
    ) as error:  # an error of the parser, or of the compiler, which refuses more: f(a, a), g(by=s, by=s)
        where = f"{file}, line {error.lineno}"
        raise FormulaError(f"not Python:  {error.msg}", where=where, remedy="correct the syntax") from None
    except (RecursionError, MemoryError):
        raise FormulaError("an expression nested too deeply", where=file, remedy="assign its parts to names") from None


def _parsed(text: str, file: str) -> ast.Module:
    if len(text) > CHARACTERS:
        raise FormulaError(counted(len(text), "character"), where=file, remedy=f"at most {CHARACTERS} are read")
    try:
        return ast.parse(text, file)
    except ValueError as error:
        raise FormulaError(f"not Python:  {error}", where=file, remedy="write a text file in UTF-8") from None


def _run(
    tree: ast.Module, file: str, known: Mapping[str, Formula], plain: bool, refused: Refused | None
) -> dict[str, Formula]:
    names, read, body = _checked(tree, file, known, refused)
    space: dict[str, Any] = {"__builtins__": {}, "__name__": file, **names}
    exec(compile(ast.Module([*body], []), file, "exec"), space)  # only code accepted by `_checked`
    defined = {name: space[name] for name in read.functions if name not in names | (refused or {})}
    if plain:
        single = {node.name for node in body if len(node.args.args) == 1}
        defined |= {
            n: Formula(f, file, CURVE, "") for n, f in defined.items() if n in single and not isinstance(f, Formula)
        }
    return {name: f for name, f in defined.items() if isinstance(f, Formula)}


def _checked(
    tree: ast.Module, file: str, known: Mapping[str, Formula], refused: Refused | None
) -> tuple[dict[str, Any], Checked, list[ast.FunctionDef]]:
    """The imports of a file, and its functions; every statement is checked."""
    names: dict[str, Any] = {}
    read, accepted = Checked(file), list[ast.FunctionDef]()
    for i, node in enumerate(tree.body):
        try:
            if isinstance(node, ast.ImportFrom):
                for name, value in _imported(node, read, known):
                    if name in names or name in read.functions:
                        raise read.refuse(node, f"the name {name!r} is taken", "choose another one")
                    names[name] = value
                    read.functions[name] = (1, 2)
                    read.imported.add(name)
            elif isinstance(node, ast.FunctionDef):
                with _not_python(file):
                    _function(node, read)
                accepted.append(node)
            elif not (i == 0 and isinstance(node, ast.Expr) and _is_text(node.value)):
                raise read.refuse(node, _described(node), _instead(node))
        except FormulaError as error:
            if refused is None:
                raise
            refused[getattr(node, "name", f"line {node.lineno}")] = error
    return names, read, accepted


def _imported(node: ast.ImportFrom, read: Checked, known: Mapping[str, Formula]) -> Iterable[tuple[str, Any]]:
    module = node.module or ""
    if node.level or (module not in HOMES and module != "__future__" and not module.startswith(ROOMS)):
        raise read.refuse(node, f"an import from {module or '.'}", IMPORT)
    for alias in node.names:
        as_name = alias.asname or alias.name
        if as_name.startswith("_"):
            raise read.refuse(node, f"the name {as_name!r}", "names begin with a letter")
        if module == "__future__":
            continue
        if module in HOMES:
            if alias.name not in HOMES[module]:
                remedy = IMPORT if alias.name in LANGUAGE else nearest(alias.name, LANGUAGE)
                raise read.refuse(node, f"{alias.name!r} is not a function of the language", remedy)
            if as_name != alias.name:
                raise read.refuse(node, f"another name for {alias.name}", "import it under its own")
            yield as_name, LANGUAGE[alias.name]
        else:
            where = f"{module.removeprefix('exactspline.')}:{alias.name}"
            if where not in known:
                raise read.refuse(node, f"{alias.name!r} is not a formula of {module}", nearest(where, known))
            yield as_name, known[where]


def _function(node: ast.FunctionDef, read: Checked) -> None:
    a = node.args
    if a.posonlyargs or a.kwonlyargs or a.vararg or a.kwarg or a.defaults or any(arg.annotation for arg in a.args):
        raise read.refuse(node, f"the arguments of {node.name}", "write plain names: def f(c)")
    if node.returns is not None:
        raise read.refuse(node, f"an annotation of {node.name}", "leave it out")
    for name in (node.name, *[arg.arg for arg in a.args]):
        if name.startswith("_"):
            raise read.refuse(node, f"the name {name!r}", "names begin with a letter")
    if node.name in read.functions:
        raise read.refuse(node, f"the name {node.name!r} is taken", "choose another one")
    read.attributes, read.constants = _attributes(node, read)
    read.vectors = _vectors(node, read)
    read.parameters = {p for kind in _kinds(node, read) for n in kind.dimensions for p in kind.parameters(n)}
    locals_ = {arg.arg for arg in a.args}
    # the cost is that of the smaller set: a file may have thousands of formulas
    if both := sorted(locals_ & read.functions.keys()):
        raise read.refuse(node, f"the name {both[0]!r} is taken", "choose another one")
    body = _Body(read, dict.fromkeys(locals_, (1, 1)))
    size = body.size(node)
    compile(ast.Module([node], []), read.file, "exec")  # the compiler refuses more than the parser
    read.functions[node.name] = size
    read.lengths[node.name] = body.length


def _attributes(node: ast.FunctionDef, read: Checked) -> tuple[set[str], set[str]]:
    """The attributes of the argument of a function, and its constants, according to its decorator; without a decorator,
    the attributes of any argument without constants.
    """
    kinds = _kinds(node, read)
    if node.decorator_list and "formula" not in read.imported:
        raise read.refuse(node, "the function 'formula' is unknown here", IMPORT)
    attributes = {"generator", "directrix"}
    for kind in kinds:
        for n in kind.dimensions:
            attributes |= {*kind.names(n), *kind.parts}
            for part in kind.parts.values():
                attributes |= set(part.names(n))
    constants = {name for kind in kinds for name in kind.constants}
    return attributes - constants, constants


def _vectors(node: ast.FunctionDef, read: Checked) -> dict[str, int]:
    """The operands of a function that are vectors, with their numbers of components."""
    lengths: dict[str, int] = {}
    for kind in _kinds(node, read):
        for each in (kind, *kind.parts.values()):
            for n in each.dimensions:
                lengths |= {name: max(n, lengths.get(name, 1)) for name, vector in each.names(n).items() if vector}
    return lengths


def _kinds(node: ast.FunctionDef, read: Checked) -> list[Kind]:
    """The kind named by the decorator; without one, all kinds."""
    return [kind_of(_decorated(node, read))] if node.decorator_list else [*KINDS.values()]


def _decorated(node: ast.FunctionDef, read: Checked) -> str:
    """The kind of argument named by ``@formula("source", on="kind", symbol="…")``."""
    call = node.decorator_list[0]
    good = (
        len(node.decorator_list) == 1
        and len(node.args.args) == 1
        and isinstance(call, ast.Call)
        and isinstance(call.func, ast.Name)
        and call.func.id == "formula"
        and len(call.args) == 1
        and _is_text(call.args[0])
        and all(k.arg in ("on", "symbol") and _is_text(k.value) for k in call.keywords)
        and all(_is_plain(each) for each in (*call.args, *[k.value for k in call.keywords]))
    )
    if not good or not isinstance(call, ast.Call):
        raise read.refuse(
            node, f"the decorator of {node.name}", '@formula("place in the source", on="plane") and one argument'
        )
    symbol = next(
        (str(k.value.value) for k in call.keywords if k.arg == "symbol" and isinstance(k.value, ast.Constant)), ""
    )
    if problem := not_a_symbol(symbol):
        raise read.refuse(
            node, f"the symbol {shown(symbol)}: {problem}", r'letters and signs, like symbol=r"\kappa_{1}"'
        )
    kind = next((k.value.value for k in call.keywords if k.arg == "on" and isinstance(k.value, ast.Constant)), "curve")
    try:
        return kind_of(str(kind)).name
    except FormulaError as error:
        raise read.refuse(node, error.problem, error.remedy) from None


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def _is_plain(node: ast.AST) -> bool:
    """Whether a text can safely be printed on a terminal, in HTML, and in LaTeX."""
    return isinstance(node, ast.Constant) and str(node.value).isprintable() and not set("<>$") & set(str(node.value))


class _Body:
    """A traversal of the body of a function. For every expression it returns the size with all calls expanded, and a
    bound on its degree.
    """

    def __init__(self, read: Checked, names: dict[str, tuple[int, int]]) -> None:
        self.read, self.names, self.argument = read, names, next(iter(names), "")
        self.lengths, self.length = dict.fromkeys(names, 1), 1

    def size(self, node: ast.FunctionDef) -> tuple[int, int]:
        """The size and the degree of the value of a function."""
        body = node.body[1:] if isinstance(node.body[0], ast.Expr) and _is_text(node.body[0].value) else node.body
        *steps, last = body or [node]
        if not isinstance(last, ast.Return) or last.value is None:
            raise self.read.refuse(last, f"{node.name} does not end with return", "return an expression")
        for step in steps:
            self.assign(step)
        total, degree = self.expression(last.value)
        self.length = self.components(last.value)
        return sum(n for n, _ in self.names.values()) + total, degree

    def assign(self, node: ast.stmt) -> None:
        """Check ``name = expression``, or an assignment of several names."""
        if not isinstance(node, ast.Assign) or len(node.targets) != 1:
            raise self.read.refuse(node, _described(node), _instead(node))
        target, value = node.targets[0], node.value
        pairs = [(target, value)]
        if isinstance(target, ast.Tuple):
            if not isinstance(value, ast.Tuple) or len(value.elts) != len(target.elts):
                raise self.read.refuse(node, "unpacking a value", "write a, b = v[0], v[1]")
            pairs = list(zip(target.elts, value.elts, strict=True))
        made, lengths = {}, {}
        for name, given in pairs:
            taken = isinstance(name, ast.Name) and (name.id in self.read.functions or name.id == self.argument)
            if not isinstance(name, ast.Name) or name.id.startswith("_") or taken:
                raise self.read.refuse(
                    node, "an assignment to something other than a new name", "write name = expression"
                )
            made[name.id] = self.expression(given)
            lengths[name.id] = self.components(given)
        self.names |= made
        self.lengths |= lengths

    def components(self, node: ast.expr) -> int:
        """An upper bound on the number of components of a value; 1 for a scalar."""
        if isinstance(node, ast.Name):
            return self.lengths.get(node.id, 1)
        if isinstance(node, ast.Attribute):
            return self.read.vectors.get(node.attr, 1)
        if isinstance(node, ast.Subscript):
            return self.components(node.value) if isinstance(node.slice, ast.Slice) else 1
        if isinstance(node, ast.UnaryOp):
            return self.components(node.operand)
        if isinstance(node, ast.BinOp):
            return max(self.components(node.left), self.components(node.right))
        if not isinstance(node, ast.Call):
            return 1
        if isinstance(node.func, ast.Attribute):
            return self.components(node.func.value)
        lengths, name = (
            [self.components(arg) for arg in node.args],
            node.func.id if isinstance(node.func, ast.Name) else "",
        )
        known = {
            "join": sum(lengths),
            "generalized_cross": len(lengths) + 1,
            "cross": 3,
            "perp": 2,
            "ruled": max(lengths, default=1),
        }
        if name in known:
            return known[name]
        return 1 if name in LANGUAGE and name not in PAIRS else self.read.lengths.get(name, 2) * max(lengths, default=1)

    def terms(self, name: str, node: ast.Call) -> int:
        """The number of products in the expansion of a determinant of indeterminates: n! for n rows."""
        if name == "wronskian" and node.args:
            order = next((k.value.value for k in node.keywords if isinstance(k.value, ast.Constant)), 0)
            n = max(self.components(node.args[0]), order if isinstance(order, int) else 0)
        else:
            n = {"det": len(node.args), "triple": 3, "cross": 3, "generalized_cross": len(node.args) + 1}.get(name, 1)
        return factorial(min(n, LARGE))

    def expression(self, node: ast.expr) -> tuple[int, int]:
        """An expression of the language."""
        ways: dict[type[ast.expr], Callable[[Any], tuple[int, int]]] = {
            ast.Name: self._name,
            ast.Constant: self._constant,
            ast.UnaryOp: self._sign,
            ast.BinOp: self._operation,
            ast.Attribute: self._operand,
            ast.Call: self._call,
            ast.Subscript: self._component,
        }
        handled = ways.get(type(node))
        if handled is None:
            raise self.read.refuse(node, _described(node), _instead(node))
        size, degree = handled(node)
        if size > WRITTEN_OUT:
            raise self.read.refuse(
                node, f"more than {WRITTEN_OUT} operations, with all calls expanded", "write it in a shorter form"
            )
        if degree > DEGREE:
            raise self.read.refuse(node, f"a degree of more than {DEGREE}", "lower the powers")
        return size, degree

    def _name(self, node: ast.Name) -> tuple[int, int]:
        if node.id in self.read.functions:
            raise self.read.refuse(node, f"the function {node.id!r} is not called", f"write {node.id}(c)")
        if node.id not in self.names:
            remedy = nearest(node.id, [*self.names, *self.read.functions])
            raise self.read.refuse(node, f"the name {node.id!r} is unknown", remedy)
        return 1, self.names[node.id][1]

    def _constant(self, node: ast.Constant) -> tuple[int, int]:
        if isinstance(node.value, float):
            raise self.read.refuse(node, f"the float {node.value!r}", f'write rational("{node.value!r}")')
        if type(node.value) is not int:
            raise self.read.refuse(node, f"the constant {node.value!r}", 'numbers are integers, or rational("1/2")')
        if abs(node.value) >= 10**DIGITS:
            raise self.read.refuse(node, f"a number of more than {DIGITS} digits", "write it as a product")
        return 1, 1

    def _sign(self, node: ast.UnaryOp) -> tuple[int, int]:
        if not isinstance(node.op, (ast.USub, ast.UAdd)):
            raise self.read.refuse(node, _described(node), _instead(node))
        return self.expression(node.operand)

    def _operation(self, node: ast.BinOp) -> tuple[int, int]:
        if not isinstance(node.op, _OPERATORS):
            raise self.read.refuse(node, f"the operation {type(node.op).__name__}", "the language has + - * / and **")
        (m, a) = self.expression(node.left)
        if isinstance(node.op, ast.Pow):
            n = node.right.value if isinstance(node.right, ast.Constant) else None
            if type(n) is not int or not 1 <= n <= POWER:
                raise self.read.refuse(node, "the exponent of a power", f"write an integer from 1 to {POWER}")
            return m + n, a * n
        (n_, b) = self.expression(node.right)
        if isinstance(node.op, ast.Div) and _is_number(node.left) and _is_number(node.right):
            quotient = ast.unparse(node)
            raise self.read.refuse(
                node, f"{quotient} is a float in Python", f'write rational("{quotient.replace(" ", "")}")'
            )
        return m + n_ + 1, max(a, b) if isinstance(node.op, (ast.Add, ast.Sub)) else a + b

    def _operand(self, node: ast.Attribute) -> tuple[int, int]:
        size = self.expression(node.value)
        is_constant = (
            isinstance(node.value, ast.Name) and node.value.id == self.argument and node.attr in self.read.constants
        )
        if node.attr not in self.read.attributes and not is_constant:
            known = sorted(self.read.attributes | self.read.constants)
            raise self.read.refuse(node, f"the argument has no {node.attr!r}", nearest(node.attr, known))
        return size

    def _call(self, node: ast.Call) -> tuple[int, int]:
        if any(isinstance(arg, ast.Starred) for arg in node.args):
            raise self.read.refuse(node, "a starred argument", "write the arguments separately")
        if isinstance(node.func, ast.Attribute) and node.func.attr == "d":
            return self._derivative(node, node.func.value)
        if not isinstance(node.func, ast.Name):
            raise self.read.refuse(node, f"a call of {ast.unparse(node.func)[:40]}", "call functions by their names")
        name = node.func.id
        if name not in self.read.functions or name in self.names:
            raise self.read.refuse(node, f"the function {name!r} is unknown here", self._above(name))
        if name == "rational":
            return self._rational(node)
        if name == "formula":
            raise self.read.refuse(node, "formula is a decorator", "write @formula above a function")
        if node.keywords and not (name == "wronskian" and [k.arg for k in node.keywords] == ["order"]):
            raise self.read.refuse(node, f"named arguments of {name}", "write the arguments separately")
        if name == "wronskian" and node.keywords and not _is_small(node.keywords[0].value):
            raise self.read.refuse(node, "the order of a Wronskian", "write a small integer")
        arguments = [self.expression(arg) for arg in node.args]
        size, degree = self.read.functions[name]
        products = sum(d for _, d in arguments) or 1
        if (terms := self.terms(name, node)) > DETERMINANT:
            raise self.read.refuse(
                node, f"a {name} of more than {DETERMINANT} products", "at most 8 vectors of 8 components"
            )
        return size + sum(n for n, _ in arguments) + terms, max(degree, 1) * products

    def _above(self, name: str) -> str:
        known = list(self.read.functions)
        return f"functions are defined above those that call them; {nearest(name, known)}" if known else "import it"

    def _rational(self, node: ast.Call) -> tuple[int, int]:
        value = node.args[0].value if len(node.args) == 1 and isinstance(node.args[0], ast.Constant) else None
        good = (isinstance(value, str) and re.fullmatch(r"-?\d{1,99}([/.]\d{1,99})?", value)) or type(value) is int
        if not good or node.keywords or (isinstance(value, str) and re.search(r"/0+$", value)):
            raise self.read.refuse(node, "the argument of rational", 'write rational("1/2") or rational("0.25")')
        return 1, 1

    def _derivative(self, node: ast.Call, value: ast.expr) -> tuple[int, int]:
        size, degree = self.expression(value)
        if len(node.args) > 1 or not all(_is_small(arg) for arg in node.args):
            raise self.read.refuse(node, "the order of a derivative", f"write .d(2), at most .d({ORDER})")
        for k in node.keywords:
            if k.arg != "by" or not (isinstance(k.value, ast.Constant) and k.value.value in self.read.parameters):
                known = " or ".join(f'by="{each}"' for each in sorted(self.read.parameters))
                raise self.read.refuse(node, "the parameter of a derivative", f"write {known}")
        return size + 1, degree + 1

    def _component(self, node: ast.Subscript) -> tuple[int, int]:
        measure, index = self.expression(node.value), node.slice
        bounds = [index] if not isinstance(index, ast.Slice) else [index.lower, index.upper, index.step]
        if not all(each is None or _is_small(each) for each in bounds):
            raise self.read.refuse(node, "the index of a component", "write v[0], v[1], … or v[0:2]")
        return measure


def _is_number(node: ast.expr) -> bool:
    return not any(isinstance(n, (ast.Name, ast.Attribute, ast.Call)) for n in ast.walk(node))


def _is_small(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and type(node.value) is int and 0 <= node.value <= ORDER


def _described(node: ast.AST) -> str:
    """A description of a construct that is not allowed, in the author's terms."""
    if isinstance(node, _BRANCHES):
        return "a formula branches"
    if isinstance(node, _REPEATS):
        return "a formula contains a loop"
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        return ast.unparse(node)
    if isinstance(node, (ast.Expr, ast.expr, ast.Assign)):
        text = " ".join(ast.unparse(node).split())
        return f"{text[:60]}{'…' if len(text) > 60 else ''} is not an expression of the language"
    return f"{type(node).__name__} is not a statement of a formula"


def _instead(node: ast.AST) -> str:
    if isinstance(node, _BRANCHES):
        return "write one expression that is the same for every curve, and cases as separate claims"
    if isinstance(node, _REPEATS):
        return "write the terms separately"
    if isinstance(node, (ast.Import, ast.ImportFrom)):
        return IMPORT
    return f"formulas are made of operands, + - * /, .d(k), det, dot, … and calls of formulas; {TRUST}"
