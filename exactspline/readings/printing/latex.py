"""Formulas as LaTeX."""

from __future__ import annotations

from exactspline.language.kind import GREEK
from exactspline.readings.expression import Expression, Operation
from exactspline.readings.printing.printer import ATOM, PRODUCT, Printer, leaf, named_binding, number


class LatexPrinter(Printer):
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
            return (rf"\bar{{{n.value.symbol}}}" if n.value.barred else n.value.symbol), named_binding(n)
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


print_latex = LatexPrinter()
