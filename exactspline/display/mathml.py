"""Exact numbers, points and names in MathML, which browsers render natively."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

from exactspline.numbers.exact import mpq, text


def number(x: mpq) -> str:
    """An exact number.

    >>> number(mpq(-1, 2))
    '<mrow><mo>−</mo><mfrac><mn>1</mn><mn>2</mn></mfrac></mrow>'
    """
    top, slash, bottom = text(abs(x)).partition("/")
    size = f"<mfrac><mn>{top}</mn><mn>{bottom}</mn></mfrac>" if slash else f"<mn>{top}</mn>"
    return f"<mrow><mo>−</mo>{size}</mrow>" if x < 0 else size


def tuple_of(parts: Iterable[str]) -> str:
    """Elements in a row between parentheses.

    >>> tuple_of([number(mpq(1)), number(mpq(2))])
    '<mrow><mo>(</mo><mn>1</mn><mo>,</mo><mn>2</mn><mo>)</mo></mrow>'
    """
    return f"<mrow><mo>(</mo>{'<mo>,</mo>'.join(parts)}<mo>)</mo></mrow>"


def name(symbol: str) -> str:
    """A name; the part after an underscore is its index.

    >>> name("d_1")
    '<msub><mi>d</mi><mn>1</mn></msub>'
    """
    letter, _, index = symbol.partition("_")
    kind = "mn" if index.isdigit() else "mi"
    main = f"<mi>{escape(letter)}</mi>"
    return f"<msub>{main}<{kind}>{escape(index)}</{kind}></msub>" if index else main


def math(inner: str, *, block: bool = False) -> str:
    """The ``math`` element around MathML."""
    return f'<math display="{"block" if block else "inline"}">{inner}</math>'


def table(rows: Sequence[Sequence[str]]) -> str:
    """Cells in rows and columns; cells may be empty."""
    lines = "".join(f"<mtr>{''.join(f'<mtd>{cell}</mtd>' for cell in row)}</mtr>" for row in rows)
    return f"<mtable>{lines}</mtable>"
