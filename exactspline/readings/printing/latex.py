"""Formulas as LaTeX."""

from __future__ import annotations

import re

from exactspline.readings.expression import Expression, Operation
from exactspline.readings.printing.printer import ATOM, PRODUCT, Printer, leaf, named_binding, number

_GREEK = {"gamma": r"\gamma", "sigma": r"\sigma", "rho": r"\rho"}


class LatexPrinter(Printer):
    r"""``[p'\ p'']\,w - [p\ p'']\,w'``."""

    minus, cross, dot, between, ruling = "-", r"\times", r"\cdot", r"\,", r"\zeta"

    def atom(self, n: Expression) -> tuple[str, int]:
        """A name or a number."""
        if n.op is Operation.NUMBER:
            text, binding = number(n.value)
            top, slash, bottom = text.partition("/")
            return (rf"\tfrac{{{top}}}{{{bottom}}}" if slash else text), binding
        if n.op is Operation.NAMED:
            return (rf"\bar{{{n.value.symbol}}}" if n.value.barred else n.value.symbol), named_binding(n)
        name, barred = leaf(n.value)
        symbol = _GREEK.get(name) or re.sub(r"(?<=[a-zA-Z])(\d+)$", r"_{\1}", name)
        return (rf"\bar{{{symbol}}}" if barred else symbol), ATOM

    def quotient(self, a: Expression, b: Expression) -> tuple[str, int]:
        """A fraction."""
        return rf"\frac{{{self.inner(a)}}}{{{self.inner(b)}}}", PRODUCT

    def power(self, base: str, exponent: int) -> str:
        """A power."""
        return rf"{base}^{{{exponent}}}"

    def derivative(self, base: str, order: int) -> str:
        """Primes."""
        return base + ("'" * order if order < 4 else rf"^{{({order})}}")

    def partial(self, base: str, order: int, by: str) -> str:
        """``∂ₛᵏ a``."""
        power = f"^{{{order}}}" if order > 1 else ""
        return rf"\partial_{{{by}}}{power} {base}"

    def subscripted(self, base: str, letters: str) -> str:
        """``a_{uv}``."""
        return f"{base}_{{{letters}}}"

    def component(self, base: str, index: str) -> str:
        """An index."""
        shown = index.replace("…", r" \ldots ")
        return rf"{base}_{{[{shown}]}}"

    def parentheses(self, text: str) -> str:
        """Parentheses that grow."""
        return rf"\left({text}\right)"

    def norm2(self, text: str) -> str:
        """A squared length."""
        return rf"\|{text}\|^2"

    def bracket(self, parts: list[str]) -> str:
        """A determinant."""
        return "[" + r"\ ".join(parts) + "]"

    def perp(self, text: str) -> str:
        """A vector rotated by a right angle."""
        return rf"{text}^\perp"

    def wedge(self, parts: list[str]) -> str:
        """A generalized cross product."""
        return rf"\textstyle\bigwedge({', '.join(parts)})"


print_latex = LatexPrinter()
