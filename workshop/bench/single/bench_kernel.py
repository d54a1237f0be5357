"""The kernel against peers: the same form arithmetic written inline over python-flint, sympy's Poly, and
fractions.Fraction.

Every benchmark is reported together with its peers on the same data in one group, so that ratios can be read off the
table. The curve's cached derivatives are dropped before every run. Control points are timed separately, since they are
computed on demand. sympy is timed with its Python polynomials: with python-flint installed it would silently delegate
to FLINT (SYMPY_GROUND_TYPES=flint times that).
"""

import os
from fractions import Fraction
from itertools import pairwise
from math import comb

os.environ.setdefault("SYMPY_GROUND_TYPES", "gmpy")

import pytest
import sympy

from exactspline import BSpline
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f2
from workshop.bench import inline
from workshop.bench.single.ground import curve, fresh

CASES = [(2, 1), (3, 1), (3, 10), (3, 100), (3, 1000), (5, 10), (10, 1), (10, 10), (10, 100)]
SLOW_PEERS = [(2, 1), (3, 1), (3, 10), (5, 10), (10, 1)]
ids = [f"degree {n}, {segments} segments" for n, segments in CASES]
slow_ids = [f"degree {n}, {segments} segments" for n, segments in SLOW_PEERS]


def inline_f2(segments, n):
    """f2 on forms, written inline over fmpz_poly: the baseline."""
    return [(inline.f2(x, y, w, n, inline.form_derivative), m * m * m) for x, y, w, m in segments]


def forms(c):
    return [(x, y, w, m) for (x, m), (y, _), (w, _) in zip(c.p[0].forms, c.p[1].forms, c.w.forms, strict=True)]


def power_basis(c):
    """The components of every segment as sympy polynomials in the local parameter: set-up, not timed."""
    t = sympy.Symbol("t")

    def poly(points):
        n = len(points) - 1
        terms = [sympy.Rational(str(b)) * comb(n, i) * t**i * (1 - t) ** (n - i) for i, b in enumerate(points)]
        return sympy.Poly(sum(terms), t, domain="QQ")

    return [
        tuple(map(poly, rows))
        for rows in zip(c.p[0].bezier_points, c.p[1].bezier_points, c.w.bezier_points, strict=True)
    ]


def sympy_f2(polys):
    return [inline.f2(x, y, w, 0, lambda p, _: p.diff()) for x, y, w in polys]


def fraction_product(a, b):
    """Product of two segments in Fractions by the Bernstein formula."""
    n, m = len(a) - 1, len(b) - 1
    product = []
    for k in range(n + m + 1):
        terms = [comb(n, i) * comb(m, k - i) * a[i] * b[k - i] for i in range(max(0, k - m), min(n, k) + 1)]
        product.append(sum(terms) / comb(n + m, k))
    return product


def fraction_f2(segments):
    def d(b):
        return [(len(b) - 1) * (q - p) for p, q in pairwise(b)]

    def minus(a, b):
        while len(a) < len(b):
            a = fraction_product(a, [Fraction(1)] * 2)
        while len(b) < len(a):
            b = fraction_product(b, [Fraction(1)] * 2)
        return [p - q for p, q in zip(a, b, strict=True)]

    def bracket(a, b):
        return minus(fraction_product(a[0], b[1]), fraction_product(a[1], b[0]))

    results = []
    for x, y, w in segments:
        p, p1, p2 = (x, y), (d(x), d(y)), (d(d(x)), d(d(y)))
        first = minus(fraction_product(bracket(p1, p2), w), fraction_product(bracket(p, p2), d(w)))
        results.append(minus(first, fraction_product(bracket(p1, p), d(d(w)))))
    return results


def as_fractions(c):
    return [
        tuple([Fraction(str(b)) for b in row] for row in rows)
        for rows in zip(c.p[0].bezier_points, c.p[1].bezier_points, c.w.bezier_points, strict=True)
    ]


@pytest.mark.parametrize("case", CASES, ids=ids)
@pytest.mark.parametrize("who", ["exactspline", "python-flint inline"])
def test_f2(benchmark, case, who):
    benchmark.group = f"f2, degree {case[0]}, {case[1]} segments"
    c = curve(*case)
    if who == "exactspline":
        result = benchmark.pedantic(f2, setup=lambda: fresh(c), rounds=200 if case[1] < 100 else 10)
        assert list(result.numerators) == [p for p, _ in inline_f2(forms(c), c.degree)]
    else:
        assert benchmark.pedantic(inline_f2, args=(forms(c), c.degree), rounds=200 if case[1] < 100 else 10)


@pytest.mark.parametrize("case", SLOW_PEERS, ids=slow_ids)
@pytest.mark.parametrize("who", ["sympy Poly", "Fraction"])
def test_f2_slow_peers(benchmark, case, who):
    benchmark.group = f"f2, degree {case[0]}, {case[1]} segments"
    c = curve(*case)
    if who == "sympy Poly":
        assert benchmark(sympy_f2, power_basis(c))
    else:
        value = f2(c)
        result = benchmark.pedantic(fraction_f2, args=(as_fractions(c),), rounds=5)
        assert [[Fraction(str(b)) for b in row] for row in value.bezier_points] == result


@pytest.mark.parametrize("case", CASES, ids=ids)
@pytest.mark.parametrize("who", ["exactspline", "python-flint inline"])
def test_product(benchmark, case, who):
    benchmark.group = f"product, degree {case[0]}, {case[1]} segments"
    x, y = curve(*case).p
    if who == "exactspline":
        assert benchmark(lambda: x * y).degree == 2 * x.degree
    else:
        pairs = list(zip(x.forms, y.forms, strict=True))
        assert benchmark(lambda: [(p * q, k * m) for (p, k), (q, m) in pairs])


@pytest.mark.parametrize("case", SLOW_PEERS, ids=slow_ids)
@pytest.mark.parametrize("who", ["sympy Poly", "Fraction"])
def test_product_slow_peers(benchmark, case, who):
    benchmark.group = f"product, degree {case[0]}, {case[1]} segments"
    c = curve(*case)
    if who == "sympy Poly":
        polys = power_basis(c)
        assert benchmark(lambda: [x * y for x, y, _ in polys])
    else:
        rows = as_fractions(c)
        assert benchmark.pedantic(lambda: [fraction_product(x, y) for x, y, _ in rows], rounds=5)


@pytest.mark.parametrize("case", CASES, ids=ids)
def test_control_points_when_asked_for(benchmark, case):
    benchmark.group = f"control points of f2, degree {case[0]}, {case[1]} segments"
    value = f2(curve(*case))

    def again():
        return BSpline.from_forms(value.degree, value.mesh, value.continuity, value.forms).control_points

    assert len(benchmark.pedantic(again, rounds=5)) == len(value.control_points)
