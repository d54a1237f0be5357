"""Objects as LaTeX."""

from __future__ import annotations

import re
from functools import singledispatch
from typing import Any

from exactspline.display.latex_prose import in_mathematics
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE
from exactspline.language.operand import Operand
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.papers import find
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet, JetFraction, polynomial_text
from exactspline.readings.printing import print_latex
from exactspline.readings.tree import Node
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import SplineSurface
from exactspline.symbolic.factorization import Factor
from exactspline.verification.notation import spelled
from exactspline.verification.statement import Statement, telling_tree

#: Splines with more or longer control points than this are not written out.
MOST_POINTS, MOST_CHARACTERS = 12, 120
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


@singledispatch
def mathematics(x: object) -> str | None:
    """Return the LaTeX of an object without dollar signs, or None for an object that is not written as LaTeX."""
    return None


def latex(x: object) -> str | None:
    r"""Return the LaTeX of a formula (or its name), a function, a number, a claim, …, as a display formula, with line
    breaks if it is long. Return None for other objects.

    >>> latex("D1").strip("$")
    "D_1 = p'\\,w - p\\,w'"
    """
    x = find(x) if isinstance(x, str) else x
    inner = mathematics(x)
    return None if inner is None else f"$${inner}$$"


def fraction(x: mpq) -> str:
    r"""An exact number.

    >>> fraction(mpq(-1, 2))
    '-\\tfrac{1}{2}'
    """
    top, slash, bottom = text(abs(x)).partition("/")
    return ("-" if x < 0 else "") + (rf"\tfrac{{{top}}}{{{bottom}}}" if slash else top)


def _row(numbers: Any) -> str:
    return r",\ ".join(fraction(x) for x in numbers)


@mathematics.register
def _(f: BSpline) -> str | None:
    if f.degree < 0:
        return "0"
    if len(f.control_points) > MOST_POINTS or sum(len(text(b)) for b in f.control_points) > MOST_CHARACTERS:
        return None
    return rf"\left[{_row(f.control_points)}\right]_{{\,n={f.degree},\ t=({_row(f.knots.knots)})}}"


@mathematics.register(Vector)
def _(v: Vector[Operand]) -> str | None:
    parts = [fraction(x) if isinstance(x, type(mpq())) else mathematics(x) for x in v]
    return None if None in parts or not parts else r"\begin{pmatrix}" + r"\\".join(map(str, parts)) + r"\end{pmatrix}"


@mathematics.register(Rational)
def _(r: Rational[BSpline]) -> str | None:
    top, bottom = mathematics(r.numerator), mathematics(r.denominator)
    return None if top is None or bottom is None else rf"\frac{{{top}}}{{{bottom}}}"


@mathematics.register(RuledSurface)
def _(s: SplineSurface) -> str | None:
    a, b = mathematics(s.directrix), mathematics(s.generator)
    return None if a is None or b is None else rf"{a} + \zeta\,{b}"


@mathematics.register
def _(n: Node) -> str:
    return print_latex(n)


@mathematics.register
def _(f: Formula) -> str:
    body = print_latex(telling_tree(f, f.kind.dimensions[0] if f.kind is not CURVE else 3))
    return body if body == f.symbol else f"{f.symbol or spelled(f.name)} = {body}"


@mathematics.register
def _(d: Degree) -> str:
    return re.sub(r"d(\d)", r"d_\1", str(d).replace("−", "-").replace("max", r"\max"))


@mathematics.register
def _(jet: Jet) -> str:
    return unicode_latex(polynomial_text(jet))


@mathematics.register
def _(jet: JetFraction) -> str:
    top, bottom = mathematics(Jet(jet.ring, jet.top)), mathematics(Jet(jet.ring, jet.bottom))
    return str(top) if bottom == "1" else rf"\frac{{{top}}}{{{bottom}}}"


@mathematics.register
def _(factor: Factor) -> str:
    return unicode_latex(str(factor))


@mathematics.register
def _(s: Statement) -> str:
    return s.latex


@mathematics.register
def _(root: Root) -> str:
    if root.exact is not None:
        return rf"s = {fraction(root.exact)}"
    shown = re.sub(r"√(\d+)", r"\\sqrt{\1}", root.shortly())
    return f"s = {shown}".replace("…", r"\ldots")


def unicode_latex(line: str) -> str:
    r"""Output of the text printer converted to LaTeX.

    >>> unicode_latex("w¹⁶·(‖D1‖²)⁻⁴ − x′")
    "w^{16}\\,(\\|D_1\\|^{2})^{-4} - x'"
    """
    line = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda m: f"^{{{m[0].translate(_SUPERSCRIPTS)}}}", line)
    line = in_mathematics(line.replace("·", r"\,").replace("…", r"\ldots"))
    return re.sub(r"([A-Za-z])(\d+)", r"\1_\2", line)
