"""Formulas written in one line, such as ``2*f1`` or ``det(γ', γ'')``: rewritten as a function, and read by the checker
of files of formulas.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable

from exactspline.errors import ExactSplineError, FormulaError
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, Kind, common_kind, kind_of
from exactspline.papers.formula_check import LANGUAGE, formulas_of
from exactspline.papers.loading import guarded
from exactspline.readings.differential_order import order_of

#: A power; a component; a number; a name, which may have its place (``file.py:f``); primes; a sign.
TOKEN = re.compile(
    r"(?:\^|\*\*)\s*([-−]?)\s*(\d+)|\[\d\]|(\d+(?:\.\d+)?)|((?:[^\s=+*^(),]+:)?[^\W\d]\w*)|([′'’]+)|[·×−@\0]"
)
#: A product without a sign has a sign of its own, which nobody types: it is refused after a division.
SIGNS = {"·": "*", "×": "*", "−": "-", "\0": "@", "@": "?"}
#: A blank between two operands, or a number before one: a product, as in factors.
BESIDE = re.compile(r"(?<=[\w)\]′'’])\s+(?=[\w(])|(?<![\w.])\d+(?:\.\d+)?(?=[^\W\d]|\()(?![^\s=+*^(),]*:)")
#: Other ways to write primes and powers.
OTHERWISE = str.maketrans({"″": "′′", "‴": "′′′", "²": "^2", "³": "^3"})
#: The longest line.
LONGEST = 2000
#: The place of a name.
PLACE = re.compile(r"[^\s=+*^(),]+(?=:)")
OPERANDS = {"γ"} | {name for n in CURVE.dimensions for name in CURVE.names(n)}


def formula_of_line(text: str, named: Callable[[str], Formula]) -> Formula:
    """The formula that a line states; `named` returns the formulas in it. A name alone is that formula.

    >>> from exactspline.papers import find
    >>> formula_of_line("f1", find), formula_of_line("det(γ', γ'')", find).kind.name
    (<formula f1, §4.1, Remark 3.1>, 'plane')

    Raises `FormulaError` for what is no expression of the language of formulas, or exists for no curve.
    """
    used: dict[str, Formula] = {}

    def python(match: re.Match[str]) -> str:
        minus, power, number, name, primes = match.groups()
        if name and name not in LANGUAGE and name not in OPERANDS:
            used[f"f{len(used)}"] = named(name)
            return f"f{len(used) - 1}(c)"
        if name:
            return str(name) if name in LANGUAGE else f"c.{'gamma' if name == 'γ' else name}"
        if power:
            return f"**{minus and '-'}{power}"
        if number:
            return f'rational("{number}")'
        return f".d({len(primes)})" if primes else SIGNS.get(match[0], match[0])

    if len(text := text.strip()) > LONGEST:
        raise FormulaError(f"a line of {len(text)} characters", remedy=f"write more than {LONGEST} in a file")
    code = TOKEN.sub(python, BESIDE.sub("\\g<0>\0 ", text.translate(OTHERWISE)))
    if list(used) == [code.removesuffix("(c)")]:
        return used["f0"]
    if not (used or "c." in code):
        raise FormulaError(f"{text!r} is a number", remedy=f"for f = {text} write f + w = {text} + w")
    return _checked(text, code, used)


def not_looked_up(text: str, *, functions: bool) -> list[str]:
    """The names in a line that have no place and mean operands, or `functions` of the language.

    >>> not_looked_up("a.py:w = det(γ', γ'')/w", functions=True), not_looked_up("det(p, p')", functions=False)
    (['det', 'w', 'γ'], ['p'])
    """
    known = OPERANDS | (LANGUAGE.keys() if functions else set())
    return sorted({match[4] for match in TOKEN.finditer(text)} & known)


def _checked(text: str, code: str, used: dict[str, Formula]) -> Formula:
    """The formula of a line in Python, of the arguments for which it exists."""
    try:
        code = ast.unparse(_in_python(ast.parse(code, mode="eval"), text))
    except (SyntaxError, RecursionError, MemoryError):
        raise FormulaError(f"{text!r} states no formula", remedy="write for example w^-3 * f2") from None
    imports = f"from exactspline.language.vector import {', '.join(LANGUAGE)}\n"
    imports += f"from exactspline.papers.line import {', '.join(used)}\n" * bool(used)
    known, errors = {f"papers.line:{name}": each for name, each in used.items()}, list[ExactSplineError]()
    for kind in _kinds([each.kind for each in used.values()]):
        try:
            file = f'{imports}@formula("", on="{kind.name}")\ndef line(c):\n    return {code}\n'
            made = formulas_of(file, text, known)
            found = guarded(Formula(made["line"].function, text, kind, ""), text)
            for n in kind.dimensions:
                order_of(found, n)
        except ExactSplineError as error:
            errors.append(error)
            continue
        found.name = found.__name__ = text
        found.checked = True
        return found
    raise errors[0]


def _in_python(tree: ast.AST, text: str) -> ast.AST:
    """Powers with negative exponents as quotients, and products without signs as others, except after a division."""
    for node in ast.walk(tree):
        match node:
            case ast.BinOp(ast.BinOp(op=ast.Div(), col_offset=first), ast.MatMult()) if first == node.col_offset:
                signed = BESIDE.sub(r"\g<0>* ", text)
                raise FormulaError(
                    f"an unclear divisor in {text!r}", remedy=f"write {signed}, or parentheses around it"
                )
            case ast.BinOp(op=ast.MatMult()):
                node.op = ast.Mult()
            case ast.BinOp(base, ast.Pow(), ast.UnaryOp(operand=power)):
                node.left, node.op, node.right = ast.Constant(1), ast.Div(), ast.BinOp(base, ast.Pow(), power)
    return tree


def _kinds(given: list[Kind]) -> list[Kind]:
    """The kinds of argument on which formulas of all these kinds are defined, that of both dimensions first."""
    common = common_kind(given)
    one = [re.sub("^curve(?! on)|(?<=framed)$", f" {each}", common.name).strip() for each in ("plane", "space")]
    kinds = [common, *map(kind_of, one)]
    if not (found := [kind for kind in kinds if all(kind.takes(each, n) for each in given for n in kind.dimensions)]):
        names = ", ".join(dict.fromkeys(repr(kind.name) for kind in given))
        raise FormulaError(f"formulas of the kinds {names}", remedy="name formulas of one kind of argument")
    return found
