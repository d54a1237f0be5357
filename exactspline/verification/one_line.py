"""Formulas written in one line, such as ``2*f1`` or ``det(γ', γ'')``: rewritten as a function, and read by the checker
of files of formulas.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable

from exactspline.errors import ExactSplineError, FormulaError
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, PLANE, SPACE, common_kind
from exactspline.papers.formula_check import LANGUAGE, formulas_of
from exactspline.papers.loading import guarded
from exactspline.readings.differential_order import order_of

#: A power; a component; a number; a name, which may have its place (``file.py:f``); primes; a sign.
TOKEN = re.compile(
    r"(?:\^|\*\*)\s*([-−]?)\s*(\d+)|\[\d\]|(\d+(?:\.\d+)?)|((?:[^\s=+*^(),]+:)?[^\W\d]\w*)|([′'’]+)|[·×−]"
)
SIGNS = {"·": "*", "×": "*", "−": "-"}
#: A blank between two operands: a product, as in factors.
BESIDE = re.compile(r"(?<=[\w)\]′'’])\s+(?=[\w(])")
#: The longest line.
LONGEST = 2000
OPERANDS = {name for n in CURVE.dimensions for name in CURVE.names(n)}


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
        operand = "gamma" if name == "γ" else name
        if name and name not in LANGUAGE and operand not in OPERANDS:
            used[f"f{len(used)}"] = named(name)
            return f"f{len(used) - 1}(c)"
        if name:
            return str(name) if name in LANGUAGE else f"c.{operand}"
        if power:
            return f"**{minus and '-'}{power}"
        if number:
            return f'rational("{number}")'
        return f".d({len(primes)})" if primes else SIGNS.get(match[0], match[0])

    if len(text := text.strip()) > LONGEST:
        raise FormulaError(f"a line of {len(text)} characters", remedy=f"write more than {LONGEST} in a file")
    code = TOKEN.sub(python, BESIDE.sub(" * ", text))
    if list(used) == [code.removesuffix("(c)")]:
        return used["f0"]
    if not (used or "c." in code):
        raise FormulaError(f"{text!r} is a number", remedy=f"write it with an operand: {text} + 0 * w")
    return _checked(text, code, used)


class _Quotients(ast.NodeTransformer):
    """Powers with negative exponents as quotients."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.BinOp:
        """``x**-2`` is 1/x**2."""
        self.generic_visit(node)
        if not isinstance(node.op, ast.Pow) or not isinstance(node.right, ast.UnaryOp):
            return node
        return ast.BinOp(ast.Constant(1), ast.Div(), ast.BinOp(node.left, ast.Pow(), node.right.operand))


def _checked(text: str, code: str, used: dict[str, Formula]) -> Formula:
    """The formula of a line in Python, of a curve in the dimensions in which it exists."""
    try:
        code = ast.unparse(_Quotients().visit(ast.parse(code, mode="eval")))
    except (SyntaxError, RecursionError, MemoryError):
        raise FormulaError(f"{text!r} states no formula", remedy="write for example w^-3 * f2") from None
    imports = f"from exactspline.language import {', '.join(LANGUAGE.keys() - {'rational'})}\n"
    imports += "from exactspline import rational\n"
    imports += f"from exactspline.papers.line import {', '.join(used)}\n" * bool(used)
    known, errors = {f"papers.line:{name}": each for name, each in used.items()}, list[ExactSplineError]()
    common = common_kind(each.kind for each in used.values())
    for kind in [CURVE, PLANE, SPACE] if common is CURVE else [common]:
        try:
            made = formulas_of(
                f'{imports}@formula("", on="{kind.name}")\ndef line(c):\n    return {code}\n', text, known
            )
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
