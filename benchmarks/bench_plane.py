"""From a curve to g2 and to the naive (κ²)′, against the same computation in raw python-flint and the same formulas
over sympy's polynomials.
"""

import os
from math import comb

os.environ.setdefault("SYMPY_GROUND_TYPES", "gmpy")

import pytest
import sympy
from ground import U_PLUS_V, curve, d, fresh

from exactspline import Vector
from exactspline.language.arguments import Curve
from exactspline.language.operand import Operand
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import curvature_squared_derivative, g2

DEGREES = range(2, 7)


def inline_g2(x, y, w, n):
    x1, y1, w1 = d(x, n), d(y, n), d(w, n)
    x2, y2, w2 = d(x1, n - 1), d(y1, n - 1), d(w1, n - 1)
    x3, y3, w3 = d(x2, n - 2), d(y2, n - 2), d(w2, n - 2)
    ax, ay = x1 * w - x * w1, y1 * w - y * w1
    bx, by = x2 * w - x * w2, y2 * w - y * w2
    cx, cy = x3 * w - x * w3, y3 * w - y * w3
    ex, ey = x2 * w1 - x1 * w2, y2 * w1 - y1 * w2
    speed, turn = ax * ax + ay * ay, ax * by - ay * bx
    return (
        (ax * cy - ay * cx) * speed * w
        + (ax * ey - ay * ex) * speed * w
        + 2 * w1 * turn * speed
        - 3 * (ax * bx + ay * by) * turn * w
    )


def inline_squaring(x, y, w, n):
    ax, ay = d(x, n) * w - x * d(w, n), d(y, n) * w - y * d(w, n)
    m = 2 * n
    ax, ay = ax * U_PLUS_V, ay * U_PLUS_V
    square = w * w
    bx, by = d(ax, m) * square - ax * d(square, m), d(ay, m) * square - ay * d(square, m)
    bx, by = bx * U_PLUS_V, by * U_PLUS_V
    turn, turn_w = ax * by - ay * bx, square * (square * square)
    speed, speed_w = ax * ax + ay * ay, square * square
    top, bottom = (turn * turn) * (speed_w * speed_w * speed_w), (turn_w * turn_w) * (speed * speed * speed)
    return (d(top, 24 * n) * bottom - top * d(bottom, 24 * n)) * U_PLUS_V


class SympyOperand(Operand):
    """A sympy polynomial as an operand: the library's own formulas run over it."""

    __slots__ = ("poly",)
    provenance = degree = 0

    def __init__(self, poly):
        self.poly = poly

    def __add__(self, other):
        return SympyOperand(self.poly + other.poly)

    def __mul__(self, other):
        return SympyOperand(self.poly * other.poly) if isinstance(other, SympyOperand) else self.scaled(other)

    def scaled(self, constant):
        return SympyOperand(self.poly * sympy.Rational(str(constant)))

    def elevated_to(self, other):
        return self

    def d(self, order=1):
        return SympyOperand(self.poly.diff((self.poly.gen, order)))


def sympy_curve(c):
    t = sympy.Symbol("t")

    def operand(points):
        n = len(points) - 1
        terms = [sympy.Rational(str(b)) * comb(n, i) * t**i * (1 - t) ** (n - i) for i, b in enumerate(points)]
        return SympyOperand(sympy.Poly(sum(terms), t, domain="QQ"))

    x, y, w = (operand(spline.segments[0]) for spline in (*c.p, c.w))
    return Curve(Vector(x, y), w)


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("who", ["exactspline", "python-flint inline", "sympy Poly"])
@pytest.mark.parametrize("what", ["g2", "(κ²)′"])
def test_pipeline(benchmark, what, degree, who):
    benchmark.group = f"{what}, rational Bézier curve of degree {degree}"
    formula, inline = (g2, inline_g2) if what == "g2" else (curvature_squared_derivative, inline_squaring)
    c = curve(degree)
    forms = [spline.polynomials[0] for spline in (*c.p, c.w)]
    if who == "exactspline":
        value = benchmark.pedantic(formula, setup=lambda: fresh(c), rounds=100)
        numerator = value if what == "g2" else value.numerator
        assert numerator.polynomials[0] == inline(*forms, degree)
    elif who == "python-flint inline":
        assert benchmark.pedantic(inline, args=(*forms, degree), rounds=100)
    else:
        peer = sympy_curve(c)
        value = benchmark.pedantic(
            lambda: formula(Curve(Vector(*[SympyOperand(x.poly) for x in peer.p]), peer.w)), rounds=3
        )
        assert value is not None
