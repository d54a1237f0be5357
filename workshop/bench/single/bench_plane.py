"""From a curve to g2 and to the naive (κ²)′, against the same computation in raw python-flint and the same formulas
over sympy's polynomials.
"""

import os

os.environ.setdefault("SYMPY_GROUND_TYPES", "gmpy")

import pytest

from exactspline.papers.chen_riesenfeld_cohen_2007.plane import curvature_squared_derivative, g2
from workshop.bench import inline as inline_forms
from workshop.bench.inline import U_PLUS_V
from workshop.bench.inline import form_derivative as d
from workshop.bench.peers import sympy_arguments
from workshop.bench.single.ground import curve, fresh

DEGREES = range(2, 7)


def inline_squaring(x, y, w, n, d):
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


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("who", ["exactspline", "python-flint inline", "sympy Poly"])
@pytest.mark.parametrize("what", ["g2", "(κ²)′"])
def test_pipeline(benchmark, what, degree, who):
    benchmark.group = f"{what}, rational Bézier curve of degree {degree}"
    formula, inline = (g2, inline_forms.g2) if what == "g2" else (curvature_squared_derivative, inline_squaring)
    c = curve(degree)
    forms = [spline.numerators[0] for spline in (*c.p, c.w)]
    if who == "exactspline":
        value = benchmark.pedantic(formula, setup=lambda: fresh(c), rounds=100)
        numerator = value if what == "g2" else value.numerator
        assert numerator.numerators[0] == inline(*forms, degree, d)
    elif who == "python-flint inline":
        assert benchmark.pedantic(inline, args=(*forms, degree, d), rounds=100)
    else:
        (peer,) = sympy_arguments(c)
        value = benchmark.pedantic(lambda: formula(type(peer)(peer.p, peer.w)), rounds=3)
        assert value is not None
