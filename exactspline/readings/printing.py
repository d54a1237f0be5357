"""Printers of expression trees as LaTeX and as text."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable
from enum import StrEnum
from typing import Any

from exactspline.language.arguments import GREEK, constant_text
from exactspline.language.operand import Parameter
from exactspline.numbers.exact import Number
from exactspline.polynomials.factors import superscript

# ---- operations


class Operation(StrEnum):
    """The operation of a node; products of vectors have the names of their functions."""

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
    #: A directrix with its generator; a normal with its height, brought to a common denominator.
    RULED = "ruled"
    LEVEL = "level"
    #: A part of a ruled surface that is accessed by name.
    DIRECTRIX = "directrix"
    GENERATOR = "generator"


#: Operations without arithmetic.
ATOMS = (Operation.LEAF, Operation.NUMBER, Operation.NAMED)


class Expression:
    """A node of an expression tree: an operation, its arguments, and a value (a name, a number, …)."""

    __slots__ = ("args", "is_vector", "op", "value")
    args: tuple[Expression, ...]
    is_vector: bool
    #: Depending on the operation: the name of a leaf, a number, the order of a derivative, …
    value: Any

    def __init__(
        self, op: Operation | str, args: tuple[Expression, ...] = (), value: object = None, *, vector: bool = False
    ) -> None:
        self.op, self.args, self.value, self.is_vector = Operation(op), args, value, vector


# ---- units


def without_units(n: Expression) -> Expression:
    """A tree with the same value, without sums with 0 and products with 0, 1 or −1, and with the signs of products in
    front; shared nodes stay shared.

    >>> from exactspline.readings.printing import print_text
    >>> from exactspline.readings.tree import Node
    >>> x, y = Node(Operation.LEAF, value="x"), Node(Operation.LEAF, value="y")
    >>> print_text((0 + x * (-1)) * (1 + 0 * y) + y * (-1)), print_text(2 * x - 0 * y)
    ('−x − y', '2 x')
    """
    return _Cleaned()(n)


class _Cleaned:
    """The simplified trees, by the nodes from which they are made."""

    def __init__(self) -> None:
        self.made: dict[int, Expression] = {}

    def __call__(self, n: Expression) -> Expression:
        if n.op in ATOMS:
            return n
        simplified = self.made.get(id(n))
        if simplified is None:
            args = tuple(map(self, n.args))
            same = all(a is b for a, b in zip(args, n.args, strict=True))
            simplified = n if same else Expression(n.op, args, n.value, vector=n.is_vector)
            if n.op in _RULES:
                simplified = _RULES[n.op](simplified, *args)
            self.made[id(n)] = simplified
        return simplified


def _is(n: Expression, value: int) -> bool:
    return n.op is Operation.NUMBER and n.value == value


def _number(value: Number) -> Expression:
    return Expression(Operation.NUMBER, value=value)


def _negative(n: Expression) -> Expression:
    if n.op is Operation.NUMBER:
        return _number(-n.value)
    return n.args[0] if n.op is Operation.NEGATIVE else Expression(Operation.NEGATIVE, (n,), vector=n.is_vector)


def _made(op: Operation, a: Expression, b: Expression) -> Expression:
    return Expression(op, (a, b), vector=a.is_vector or b.is_vector)


def _sum(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return b if _is(a, 0) else a
    if b.op is Operation.PLUS and b.args[0].op is Operation.NEGATIVE:
        return _made(Operation.PLUS, _made(Operation.MINUS, a, b.args[0].args[0]), b.args[1])
    return _made(Operation.MINUS, a, b.args[0]) if b.op is Operation.NEGATIVE else n


def _difference(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return _negative(b) if _is(a, 0) else a
    return n


def _product(n: Expression, a: Expression, b: Expression) -> Expression:
    if _is(a, 0) or _is(b, 0):
        return n if n.is_vector else _number(0)
    for unit, other in ((a, b), (b, a)):
        if _is(unit, 1):
            return other
        if _is(unit, -1):
            return _negative(other)
        if unit.op is Operation.NEGATIVE and other.op is not Operation.NUMBER:
            return _negative(_product(n, unit.args[0], other) if unit is a else _product(n, other, unit.args[0]))
    if b.op is Operation.NUMBER and b.value == int(b.value) and a.op is not Operation.NUMBER and not a.is_vector:
        return _in_front(b, a)
    return n if a is n.args[0] and b is n.args[1] else _made(Operation.TIMES, a, b)


def _in_front(factor: Expression, n: Expression) -> Expression:
    """A product with a number in front of its first factor."""
    if n.op is Operation.TIMES:
        return _made(Operation.TIMES, _in_front(factor, n.args[0]), n.args[1])
    return _made(Operation.TIMES, factor, n)


_RULES: dict[Operation, Callable[..., Expression]] = {
    Operation.PLUS: _sum,
    Operation.MINUS: _difference,
    Operation.TIMES: _product,
    Operation.NEGATIVE: lambda n, a: _negative(a) if a.op in (Operation.NUMBER, Operation.NEGATIVE) else n,
}


# ---- a printer


#: The parameters of surfaces: derivatives by them are written as subscripts.
SUBSCRIPTS = (Parameter.U, Parameter.V)

#: The precedence of operations; arguments of lower precedence are put in parentheses.
SUM, PRODUCT, POWER, ATOM = 1, 2, 3, 4


class _Printer(ABC):
    """A traversal of a tree; subclasses define the notation of each node."""

    def __call__(self, node: Expression) -> str:
        """The text of a tree."""
        return self.inner(without_units(node))

    def inner(self, node: Expression) -> str:
        """The text of a part of a tree."""
        return self.show(node)[0]

    def show(self, n: Expression) -> tuple[str, int]:
        """The text of a node and its precedence."""
        if n.op in ATOMS:
            return self.atom(n)
        if n.op is Operation.LEVEL:
            # bringing to a common denominator does not change the value, so that the argument is printed
            return self.show(n.args[n.value])
        if n.op in (Operation.PLUS, Operation.MINUS):
            left, right = n.args
            sign, least = (self.minus, PRODUCT) if n.op is Operation.MINUS else ("+", SUM)
            return f"{self.inner(left)} {sign} {self.at(right, least)}", SUM
        if n.op is Operation.RULED:
            return f"{self.inner(n.args[0])} + {self.ruling}{self.between}{self.at(n.args[1], PRODUCT)}", SUM
        if n.op is Operation.NEGATIVE:
            return f"{self.minus}{self.at(n.args[0], PRODUCT)}", SUM
        if n.op is Operation.TIMES:
            return self.times(n), PRODUCT
        if n.op is Operation.OVER:
            return self.quotient(*n.args)
        if n.op is Operation.POWER:
            return self.power(self.at(n.args[0], ATOM), n.value), POWER
        if n.op is Operation.DERIVATIVE:
            order, by = n.value
            if by in SUBSCRIPTS:
                inner, letters = _letters(n)
                return self.subscripted(self.at(inner, ATOM), letters), ATOM
            base = self.at(n.args[0], ATOM)
            return (self.derivative(base, order), ATOM) if by is None else (self.partial(base, order, by), PRODUCT)
        if n.op is Operation.COMPONENT:
            return self.component(self.at(n.args[0], ATOM), _index_text(n.value)), ATOM
        if n.op is Operation.JOIN:
            return self.parentheses.format(", ".join(map(self.inner, n.args))), ATOM
        return self.product(n)

    def at(self, n: Expression, least: int) -> str:
        """The text of an argument, in parentheses if its precedence is lower than `least`."""
        text, binding = self.show(n)
        return text if binding >= least else self.parentheses.format(text)

    def times(self, n: Expression) -> str:
        """A product, scalars before vectors."""
        a, b = n.args
        if (
            a.is_vector
            and not b.is_vector
            and b.op is not Operation.LEAF
            and not (b.op is Operation.DERIVATIVE and b.args[0].op is Operation.LEAF)
        ):
            a, b = b, a
        return f"{self.at(a, PRODUCT)}{self.between}{self.at(b, POWER)}"

    def product(self, n: Expression) -> tuple[str, int]:
        """A product of vectors."""
        parts = [self.at(a, POWER) for a in n.args]
        if n.op is Operation.DOT and n.args[0] is n.args[1]:
            return self.norm2.format(self.inner(n.args[0])), POWER
        if n.op is Operation.DET:
            return self.bracket.format(self.apart.join(parts)), ATOM
        if n.op is Operation.PERP:
            (turned,) = n.args
            return self.perp(self.at(turned, ATOM)), ATOM
        if n.op is Operation.GENERALIZED_CROSS:
            return self.wedge.format(", ".join(map(self.inner, n.args))), ATOM
        return (f" {self.cross} " if n.op is Operation.CROSS else f" {self.dot} ").join(parts), PRODUCT

    #: Signs: of a difference, between the factors of products of vectors, of scalars, and the parameter of a ruling.
    minus: str
    cross: str
    dot: str
    between: str
    ruling: str
    #: The brackets around a sum, around a vector whose squared length is taken, around the vectors of a determinant
    #: (and the text between these), and around those of a generalized cross product.
    parentheses: str
    norm2: str
    bracket: str
    apart: str
    wedge: str

    @abstractmethod
    def atom(self, n: Expression) -> tuple[str, int]:
        """A leaf, a number or a named formula."""

    @abstractmethod
    def quotient(self, a: Expression, b: Expression) -> tuple[str, int]:
        """A quotient."""

    @abstractmethod
    def power(self, base: str, exponent: int) -> str:
        """A power."""

    @abstractmethod
    def derivative(self, base: str, order: int) -> str:
        """A derivative."""

    @abstractmethod
    def partial(self, base: str, order: int, by: str) -> str:
        """A derivative with respect to a named parameter."""

    @abstractmethod
    def subscripted(self, base: str, letters: str) -> str:
        """A derivative of a surface with respect to parameters in this order."""

    @abstractmethod
    def component(self, base: str, index: str) -> str:
        """A component of a vector."""

    @abstractmethod
    def perp(self, text: str) -> str:
        """A vector rotated by a right angle."""


def _letters(n: Expression) -> tuple[Expression, str]:
    """The innermost operand of nested derivatives, and their parameters in the order of differentiation."""
    letters = ""
    while n.op is Operation.DERIVATIVE and n.value.by in SUBSCRIPTS:
        letters = str(n.value.by) * n.value.order + letters
        n = n.args[0]
    return n, letters


def _named_binding(n: Expression) -> int:
    """The precedence of the symbol of a named formula: a symbol that ends in a power needs parentheses before another
    power.
    """
    return POWER if "^" in n.value.symbol else ATOM


def _index_text(index: int | slice) -> str:
    """An index, or the first and last index of a slice.

    >>> _index_text(2), _index_text(slice(1, 4)), _index_text(slice(1, None)), _index_text(slice(None, 2))
    ('2', '1…3', '1…', '0…1')

    A slice that counts from the end or has a step is written as in Python.

    >>> _index_text(slice(None, -1)), _index_text(slice(0, 3, 2))
    (':-1', '0:3:2')
    """
    if not isinstance(index, slice):
        return str(index)
    start, stop = index.start or 0, index.stop
    if index.step in (None, 1) and start >= 0 and (stop is None or stop > 0):
        return f"{start}…" if stop is None else f"{start}…{stop - 1}"
    ends = ["" if end is None else str(end) for end in (index.start, stop)]
    return ":".join(ends if index.step is None else [*ends, str(index.step)])


def number(value: Number) -> tuple[str, int]:
    """A constant; fractions have the precedence of products."""
    text = str(value)
    return text, ATOM if text.isdigit() else PRODUCT


#: The notation of leaves that differs from their name.
LEAVES = {"point": "Q", "axis_x": "e_1", "axis_y": "e_2", "axis_z": "e_3", "pace": "lambda", "cut": "c"}
#: Partial derivatives of the function of an implicit curve or surface, its gradient, and a row of its Hessian.
_PARTIAL = re.compile(r"(gradient_|hessian_|)([fg])([xyz]*)")


def leaf(value: str) -> tuple[str, str, str, bool]:
    """The notation of a leaf: its nabla or nothing, its letter or name, its index, and whether it has a bar, because it
    belongs to the second of two curves.

    >>> leaf("second.p"), leaf("gamma"), leaf("p1"), leaf("lambda_2")
    (('', 'p', '', True), ('', 'gamma', '', False), ('', 'p', '1', False), ('', 'lambda', '2', False))
    >>> leaf("fxy"), leaf("gradient_g"), leaf("hessian_fx")
    (('', 'F', 'xy', False), ('∇', 'G', '', False), ('∇', 'F', 'x', False))
    """
    path, _, name = value.rpartition(".")
    name = LEAVES.get(name, name)
    partial = _PARTIAL.fullmatch(name)
    if partial and (partial[1] or partial[3]):
        return "∇" * bool(partial[1]), partial[2].upper(), partial[3], False
    stem = name.rstrip("0123456789")
    return "", stem.rstrip("_"), name[len(stem) :], path == "second"


# ---- text


_LETTERS = GREEK | {"Psi": "Ψ", "Pi": "Π", "nabla": "∇"}


class TextPrinter(_Printer):
    """``[p′ p″] w − [p p″] w′``."""

    minus, cross, dot, between, ruling = "−", "×", "·", " ", "ζ"
    parentheses, norm2, bracket, apart, wedge = "({})", "‖{}‖²", "[{}]", " ", "⋀({})"

    def atom(self, n: Expression) -> tuple[str, int]:
        """A name or a number."""
        if n.op is Operation.NUMBER:
            return number(n.value)
        if n.op is Operation.NAMED:
            return _barred(symbol_text(n.value.symbol), n.value.barred), _named_binding(n)
        nabla, name, index, barred = leaf(n.value)
        shown = constant_text(f"{name}{index}") if index.isdigit() else constant_text(name) + f"_{index}" * bool(index)
        return nabla + _barred(shown, barred), ATOM

    def quotient(self, a: Expression, b: Expression) -> tuple[str, int]:
        """``a/b``."""
        return f"{self.at(a, 2)}/{self.at(b, 3)}", 2

    def power(self, base: str, exponent: int) -> str:
        """``a²``."""
        return base + superscript(exponent)

    def derivative(self, base: str, order: int) -> str:
        """``a′``."""
        return base + ("′″‴"[order - 1] if order < 4 else f"⁽{superscript(order)}⁾")

    def partial(self, base: str, order: int, by: str) -> str:
        """``∂_s a``."""
        return f"∂_{by}{superscript(order) if order > 1 else ''} {base}"

    def subscripted(self, base: str, letters: str) -> str:
        """``a_uv``."""
        return f"{base}_{letters}"

    def component(self, base: str, index: str) -> str:
        """``a[i]``."""
        return f"{base}[{index}]"

    def perp(self, text: str) -> str:
        """``a⊥``."""
        return f"{text}⊥"


def _barred(text: str, barred: bool) -> str:
    """A bar over the first letter."""
    return f"{text[0]}\u0304{text[1:]}" if barred else text


def symbol_text(symbol: str) -> str:
    r"""A LaTeX symbol as text.

    >>> symbol_text(r"D_{21}"), symbol_text(r"\gamma''"), symbol_text("[D_1\\ D_2]")
    ('D21', 'γ″', '[D1 D2]')
    >>> symbol_text("S_{uv}"), symbol_text(r"[P\ P_u\ P_v\ P_{uu}]")
    ('S_uv', '[P P_u P_v P_uu]')
    """
    text = symbol.replace("'''", "‴").replace("''", "″").replace("'", "′").replace("\\ ", " ")
    text = text.replace(r"\times", "×").replace(r"\cdot", "·").replace(r"\perp", "⊥").replace(r"\|", "‖")
    text = re.sub(r"\\mathbf\{([A-Z])\}", lambda m: chr(ord("𝐀") + ord(m[1]) - ord("A")), text)
    text = re.sub(rf"\\({'|'.join(_LETTERS)}|bar) ?", lambda m: _LETTERS.get(m[1], ""), text)
    text = re.sub(r"\^\{?(\d+)\}?", lambda m: superscript(int(m[1])), text)
    text = re.sub(r"\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{((?:[^{}]|\{[^{}]*\})*)\}", r"\1/\2", text)
    text = re.sub(r"_\{?([uv]+)\}?", r"∂\1", text)
    return re.sub(r"\\(mathbf|mathrm|left|right)|[_{}]", "", text).replace("∂", "_")


print_text = TextPrinter()


# ---- LaTeX


class _LatexPrinter(_Printer):
    r"""``[p'\ p'']\,w - [p\ p'']\,w'``."""

    minus, cross, dot, between, ruling = "-", r"\times", r"\cdot", r"\,", r"\zeta"
    parentheses, norm2, wedge = r"\left({}\right)", r"\|{}\|^2", r"\textstyle\bigwedge({})"
    bracket, apart = "[{}]", r"\ "

    def atom(self, n: Expression) -> tuple[str, int]:
        """A name or a number."""
        if n.op is Operation.NUMBER:
            text, binding = number(n.value)
            top, slash, bottom = text.partition("/")
            return (rf"\tfrac{{{top}}}{{{bottom}}}" if slash else text), binding
        if n.op is Operation.NAMED:
            return (rf"\bar{{{n.value.symbol}}}" if n.value.barred else n.value.symbol), _named_binding(n)
        nabla, name, index, barred = leaf(n.value)
        symbol = _letter(name) + (f"_{{{index}}}" if index else "")
        return (rf"\bar{{{symbol}}}" if barred else rf"\nabla {symbol}" if nabla else symbol), ATOM

    def quotient(self, a: Expression, b: Expression) -> tuple[str, int]:
        """A fraction."""
        return rf"\frac{{{self.inner(a)}}}{{{self.inner(b)}}}", PRODUCT

    def power(self, base: str, exponent: int) -> str:
        """A power."""
        return rf"{_raisable(base)}^{{{exponent}}}"

    def derivative(self, base: str, order: int) -> str:
        """Primes."""
        return _raisable(base) + ("'" * order if order < 4 else rf"^{{({order})}}")

    def partial(self, base: str, order: int, by: str) -> str:
        """``∂ₛᵏ a``."""
        power = f"^{{{order}}}" if order > 1 else ""
        return rf"\partial_{{{by}}}{power} {base}"

    def subscripted(self, base: str, letters: str) -> str:
        """``a_{uv}``."""
        return f"{_indexable(base)}_{{{letters}}}"

    def component(self, base: str, index: str) -> str:
        """An index."""
        shown = index.replace("…", r" \ldots ")
        return rf"{_indexable(base)}_{{[{shown}]}}"

    def perp(self, text: str) -> str:
        """A vector rotated by a right angle."""
        return rf"{_raisable(text)}^\perp"


def _letter(name: str) -> str:
    r"""The name of an operand: a letter, also a Greek one, or words.

    >>> _letter("p"), _letter("delta"), _letter("half_width")
    ('p', '\\delta', '\\mathrm{half\\_width}')
    """
    if name in GREEK:
        return rf"\{name.replace('lamda', 'lambda')}"
    return name if len(name) == 1 else rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


def _indexable(base: str) -> str:
    r"""A symbol that can be given an index: in braces if it already has one, because TeX does not allow a second.

    >>> _indexable("P"), _indexable("P_2"), _indexable(r"\left(P_2 - P_1\right)")
    ('P', '{P_2}', '\\left(P_2 - P_1\\right)')
    """
    return f"{{{base}}}" if "_" in _outside(base) else base


def _raisable(base: str) -> str:
    r"""A symbol that can be given an exponent or a prime: in braces if it already has one, unless it ends in a prime.

    >>> _raisable("p'"), _raisable("p'_{[0]}"), _raisable(r"p^\perp")
    ("p'", "{p'_{[0]}}", '{p^\\perp}')
    """
    outside = _outside(base)
    return f"{{{base}}}" if "^" in outside or "'" in outside.rstrip("'") else base


def _outside(text: str) -> str:
    """The parts of a formula outside of braces, brackets and parentheses."""
    depth, kept = 0, ""
    for sign in text:
        depth -= sign in "}])"
        kept += sign if not depth else ""
        depth += sign in "{[("
    return kept


print_latex = _LatexPrinter()
