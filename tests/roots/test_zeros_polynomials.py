"""Hard polynomials: counts against an independent Sturm sequence, values against independent tools, 1000 digits against
exact signs.
"""

import itertools
from functools import reduce

import mpmath
import pytest
from flint import fmpq_poly, fmpz_poly
from gmpy2 import mpq, mpz

from exactspline import BSpline, Root, check_certificate, zeros
from exactspline.numbers.exact import to_fmpq

X = fmpz_poly([0, 1])


def spline(p, a=0, b=1):
    """The polynomial as a spline on [a, b]."""
    t = BSpline.identity(a, b)
    return reduce(lambda f, c: f * t + int(c), reversed(p.coeffs()), 0 * t)


def sturm(p, a, b):
    """Number of distinct zeros in (a, b], by Sturm's theorem over the rationals."""
    chain = [fmpq_poly(p), fmpq_poly(p.derivative())]
    while chain[-1].degree() > 0:
        chain.append(-(chain[-2] % chain[-1]))
    counts = []
    for t in (a, b):
        signs = [q(to_fmpq(mpq(t))) > 0 for q in chain if q(to_fmpq(mpq(t))) != 0]
        counts.append(sum(x != y for x, y in itertools.pairwise(signs)))
    return counts[0] - counts[1]


def product(roots):
    return reduce(lambda p, r: p * (X * int(mpq(r).denominator) - int(mpq(r).numerator)), roots, fmpz_poly([1]))


def signs_differ(p, low, high):
    return (p(to_fmpq(low)) > 0) != (p(to_fmpq(high)) > 0) and p(to_fmpq(low)) != 0 and p(to_fmpq(high)) != 0


def mignotte(n, a):
    """Two roots of ``xⁿ − 2(ax − 1)²`` about ``a^(−(n + 2)/2)`` apart."""
    return X**n - 2 * (a * X - 1) ** 2


WILKINSON = product(range(1, 21))
CHEBYSHEV = fmpz_poly.chebyshev_t(100)
HARD = {
    "wilkinson": (WILKINSON, 0, 21, 20),
    "wilkinson disturbed": (2**23 * WILKINSON - X**19, 0, 21, 10),
    "mignotte": (mignotte(18, 2**20), 0, 1, 2),
    "chebyshev": (CHEBYSHEV, -1, 1, 100),
    "multiplicity 20": ((3 * X - 1) ** 20 * (X**2 + X - 1), 0, 1, 2),
    "two of high multiplicity": ((X**2 + X - 1) ** 7 * (7 * X - 3) ** 5 * (2 * X - 1) ** 4 * (X**2 + 1) ** 3, 0, 1, 3),
    "double complex pair": ((X**2 - X + 1) ** 2 * (3 * X - 1), 0, 1, 1),
    "near-double pair off the axis": ((3 * X - 1) ** 2 * 10**80 + 1, 0, 1, 0),
}


@pytest.mark.parametrize("name", HARD)
def test_count_agrees_with_sturm(name):
    p, a, b, count = HARD[name]
    found = zeros(spline(p, a, b))
    # Sturm counts (a, b]
    assert sturm(p, a, b) == count - (p(int(a)) == 0)
    assert len(found) == count
    assert check_certificate(found.certificate(), sturm=p.degree() < 50)["roots"] == count


def test_mignotte_roots_are_apart_by_less_than_2_to_minus_200():
    pair = zeros(spline(mignotte(18, 2**20))).roots[:2]
    low, high = (root.refine(100) for root in pair)
    assert low[1] < high[0]
    assert high[1] - low[0] < mpq(1, 2**197)
    assert high[0] - low[1] > mpq(1, 2**203)
    assert pair[0] < pair[1]
    assert pair[0] != pair[1]


def test_wilkinson_roots_are_exact():
    found = zeros(spline(WILKINSON, 0, 21))
    assert all(root == k for root, k in zip(found, range(1, 21), strict=True))
    assert [root.minimal_polynomial() for root in found] == [[-k, 1] for k in range(1, 21)]
    assert [root.exact for root in found] == list(range(1, 21))


def test_chebyshev_values():
    found = zeros(spline(CHEBYSHEV, -1, 1))
    with mpmath.workdps(60):
        expected = sorted(mpmath.cos((2 * k - 1) * mpmath.pi / 200) for k in range(1, 101))
        assert all(abs(root.mpf(50) - x) < mpmath.mpf(10) ** -50 for root, x in zip(found, expected, strict=True))


def test_multiplicities_and_signs():
    p, a, b, _ = HARD["multiplicity 20"]
    first, second = zeros(spline(p, a, b))
    assert (first.multiplicity, first.sign_change, first.signs, first.exact) == (20, False, (-1, -1), mpq(1, 3))
    assert (second.multiplicity, second.sign_change, second.signs) == (1, True, (-1, 1))
    found = zeros(spline(*HARD["two of high multiplicity"][:3]))
    assert [(root.multiplicity, root.signs) for root in found] == [(5, (1, -1)), (4, (-1, -1)), (7, (-1, 1))]


@pytest.mark.parametrize("name", ["wilkinson disturbed", "mignotte", "multiplicity 20", "two of high multiplicity"])
def test_thousand_digits_by_exact_signs(name):
    p, a, b, _ = HARD[name]
    for root in zeros(spline(p, a, b)):
        low, high = root.refine(1000)
        assert high - low <= mpq(1, mpz(10) ** 1000)
        q = fmpz_poly(root.polynomial)
        assert q(to_fmpq(low)) == 0 if low == high else signs_differ(q, low, high)
        if root.multiplicity % 2 and low < high:
            assert signs_differ(p, low, high)


@pytest.mark.parametrize("seed", range(4))
def test_values_against_mpmath_and_flint(seed):
    n = 6 + 4 * seed
    p = fmpz_poly([(7919 * (i + seed + 1) ** 5) % 20011 - 10000 for i in range(n + 1)])
    found = zeros(spline(p, -2, 2))
    with mpmath.workdps(60):
        everywhere = mpmath.polyroots([int(x) for x in reversed(p.coeffs())], maxsteps=500, extraprec=500)
        expected = sorted(z.real for z in everywhere if abs(z.imag) < mpmath.mpf(10) ** -40 and -2 < z.real < 2)
        assert len(found) == len(expected)
        assert all(abs(root.mpf(40) - x) < mpmath.mpf(10) ** -40 for root, x in zip(found, expected, strict=True))
    real = sorted((z.real for z, _ in p.complex_roots() if z.imag == 0 and abs(z.real) < 2), key=float)
    assert len(real) == len(found)
    assert all(float(x) == pytest.approx(float(root.mpf(20)), abs=1e-12) for root, x in zip(found, real, strict=True))


def test_million_digit_coefficients():
    big = 10**1_000_000
    # roots near 1/3 and 2/3, moved by 10^-1000000
    p = (3 * X - 1) * (3 * X - 2) * big + 1
    found = zeros(spline(p))
    assert [(root.multiplicity, root.signs) for root in found] == [(1, (1, -1)), (1, (-1, 1))]
    first, second = found
    assert first > mpq(1, 3)
    assert second < mpq(2, 3)
    low, high = first.refine(50)
    assert high - low < mpq(1, 10**50)
    assert low < mpq(1, 3) + mpq(1, 10**50)


def test_roots_at_the_ends_and_in_the_middle_are_rational():
    f = spline(X**3 * (X - 1) ** 2 * (2 * X - 1) * (4 * X - 3) ** 2 * (X**2 + X - 1))
    found = zeros(f)
    assert [(root.exact, root.left_multiplicity, root.right_multiplicity) for root in found] == [
        (0, None, 3), (mpq(1, 2), 1, 1), (None, 1, 1), (mpq(3, 4), 2, 2), (1, 2, None)
    ]  # fmt: skip
    assert [root.at_knot for root in found] == [True, False, False, False, True]
    assert [root.sign_change for root in found] == [False, True, True, False, False]


def test_refinement_reaches_dyadic_roots_from_wide_intervals():
    # 3/8 and 5/8 are isolated by one sign change long before they are midpoints
    found = zeros(spline((8 * X - 3) * (8 * X - 5) * (X**2 + 7)))
    assert all(isinstance(root, Root) for root in found)
    for root, t in zip(found, (mpq(3, 8), mpq(5, 8)), strict=True):
        low, high = root.refine(100)
        assert low <= t <= high
        assert root == t
