"""Formulas as Unicode text."""

from __future__ import annotations

import re

from exactspline.language.kind import GREEK, constant_text
from exactspline.polynomials.factors import superscript
from exactspline.readings.expression import Expression, Operation
from exactspline.readings.printing.printer import ATOM, Printer, leaf, named_binding, number

_LETTERS = GREEK | {"Psi": "Ψ", "Pi": "Π", "nabla": "∇"}


class TextPrinter(Printer):
    """``[p′ p″] w − [p p″] w′``."""

    minus, cross, dot, between, ruling = "−", "×", "·", " ", "ζ"
    parentheses, norm2, bracket, apart, wedge = "({})", "‖{}‖²", "[{}]", " ", "⋀({})"

    def atom(self, n: Expression) -> tuple[str, int]:
        """A name or a number."""
        if n.op is Operation.NUMBER:
            return number(n.value)
        if n.op is Operation.NAMED:
            return _barred(symbol_text(n.value.symbol), n.value.barred), named_binding(n)
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
