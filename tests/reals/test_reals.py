"""Real numbers: arithmetic, order, equality, hashes, polynomials and digits, held against mpmath and sympy.

The data has a dial: small integers, thirds, decimals of ten digits, doubles of 17 digits, 1e±300.
"""

import copy
import math
import operator
import pickle
import random
import time
from contextlib import suppress
from decimal import Decimal
from fractions import Fraction
from math import isqrt

import mpmath
import pytest
import sympy
from flint import arb, fmpq_poly, fmpz, fmpz_poly
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp
from mpmath.libmp import to_rational

import exactspline as xs
from exactspline import BSpline, Real, Root, square_root, zeros
from exactspline.errors import NumberError, OpenError, ReachError, ShapeError
from exactspline.numbers.exact import to_fmpq
from exactspline.numbers.intervals import Interval
from exactspline.polynomials import elimination
from exactspline.reals.algebraic import Digits
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Extreme, Quadratic, RationalNumber, between, real
from tests.support.dials import DIALS
from tests.support.vectors import mpf_of

ROOT_2, ROOT_3 = square_root(2), square_root(3)
OPERATIONS = (operator.add, operator.sub, operator.mul, operator.truediv)


def huge_or_tiny(chance):
    return DIALS[chance.choice(["doubles · 1e300", "doubles · 1e-300"])](chance)


ORDINARY = {name: DIALS[name] for name in ("small integers", "thirds", "ten decimals", "doubles")}
EVERY = ORDINARY | {"doubles · 1e±300": huge_or_tiny}


def polynomial(c, low, high):
    """The spline of one segment with these coefficients, the constant one first."""
    t = xs.BSpline.identity(low, high)
    f = t.constant(c[-1])
    for a in c[-2::-1]:
        f = f * t + a
    return f


def roots(chance, number, degree=3):
    """Roots of a polynomial with random coefficients, on the line; irrational ones mostly."""
    while True:
        c = [number(chance) for _ in range(degree)] + [mpq(chance.choice([1, 2, 3]))]
        size = 1 + max(abs(x) for x in c)
        found = xs.zeros(polynomial(c, -size, size)).roots
        if found:
            return found


def close(x, value, digits=60, known=1200):
    """Whether an enclosure holds a value that mpmath knows to many more digits."""
    low, high = x.enclosure(digits)
    assert high - low <= mpq(1, 10**digits)
    with mp.workdps(4000):
        ends = [mpf_of(t) for t in (low, high)]
        slack = abs(value) * mpmath.mpf(10) ** -known
        return ends[0] - slack <= value <= ends[1] + slack


def in_mpmath(x):
    with mp.workdps(4000):
        return mpmath.mpf(x.mpf(3900)) if not isinstance(x, mpq) else mpf_of(x)


@pytest.mark.parametrize("dial", EVERY)
@pytest.mark.parametrize("seed", range(2))
def test_arithmetic_agrees_with_mpmath(dial, seed):
    """Enclosures hold the true value, signs and doubles are right: `root + 1` was a TypeError."""
    chance = random.Random(f"{dial} {seed}")
    number = EVERY[dial]
    pool = [chance.choice(roots(chance, number)) for _ in range(3)]
    pool += [square_root(abs(number(chance)) + 1), real(number(chance)), square_root(1 + square_root(5))]
    for _ in range(12):
        a, b = chance.choice(pool), chance.choice(pool)
        operation = chance.choice(OPERATIONS)
        with mp.workdps(4000):
            x, y = in_mpmath(a), in_mpmath(b)
            if operation is operator.truediv and b == 0:
                with pytest.raises(ZeroDivisionError):
                    operation(a, b)
                continue
            true = operation(x, y)
        made = operation(a, b)
        assert close(made, true)
        with mp.workdps(4000):
            if abs(true) > mpmath.mpf(10) ** -900:
                assert made.sign == mpmath.sign(true)
                assert (made < 0) == (true < 0)
                assert (a < b) == (x < y)
        if len(pool) < 9:
            pool.append(made)


@pytest.mark.parametrize("dial", ORDINARY)
@pytest.mark.parametrize("seed", range(2))
def test_minimal_polynomials_vanish_and_are_irreducible(dial, seed):
    """A polynomial of too high a degree, or of another number, would be told."""
    chance = random.Random(f"{dial} {seed} minimal")
    a, b = (chance.choice(roots(chance, EVERY[dial], degree)) for degree in (2, 3))
    for made in (a + b, a * b, a - b, a * a + 1, b / (b * b + 1), square_root(b * b + 2), -a, abs(b)):
        p = made.minimal_polynomial()
        assert len(fmpz_poly(p).factor()[1]) == 1
        assert p[-1] > 0
        assert fmpz_poly(p).content() == 1
        with mp.workdps(4000):
            x = in_mpmath(made)
            terms = [c * x**k for k, c in enumerate(p)]
            assert abs(sum(terms)) <= max(map(abs, terms)) * mpmath.mpf(10) ** -1300
        assert (made.exact is not None) == (len(p) == 2)
        assert made.is_root_of(fmpz_poly(p) * fmpz_poly([1, 1, 5]))
        assert not made.is_root_of(fmpz_poly(p) + 1)


@pytest.mark.parametrize("seed", range(6))
def test_minimal_polynomials_agree_with_sympy(seed):
    chance = random.Random(seed)
    p, q = chance.choice([2, 3, 5, 6, 7]), chance.choice([2, 3, 5, 6, 7, 8])
    ours = {2: square_root(p), 3: square_root(q)}
    theirs = {2: sympy.sqrt(p), 3: sympy.sqrt(q)}
    s = sympy.Symbol("s")
    for make in (
        lambda r: r[2] + r[3],
        lambda r: r[2] * r[3] + 1,
        lambda r: (r[2] + 1) / (r[3] + 2),
        lambda r: (r[2] - r[3]) * r[3] - 1,
    ):
        expected = sympy.Poly(sympy.minimal_polynomial(make(theirs), s), s).clear_denoms()[1].all_coeffs()[::-1]
        assert make(ours).minimal_polynomial() == [int(c) for c in expected]


def same_numbers():
    t = xs.BSpline.identity(0, 2)
    wide = xs.BSpline.identity(-5, mpq(1000, 7))
    root = xs.zeros(t * t - 2).roots[0]
    cube = xs.zeros(t**3 - 2).roots[0]
    return {
        "√2": [
            ROOT_2,
            root,
            next(r for r in xs.zeros((wide * wide - 2) * (wide**3 - 5)) if 0 < r < mpq(3, 2)),
            ROOT_3 - (ROOT_3 - ROOT_2),
            (ROOT_2 + ROOT_3) * (ROOT_3 - ROOT_2) * ROOT_2,
            2 / root,
            root**3 / 2,
            square_root(square_root(4) * 1),
            square_root(root * root),
            square_root(3 + 2 * root) - 1,
            0 - (-root),
        ],
        "2": [
            Real(2),
            root * root,
            ROOT_2 * root,
            cube**3,
            cube * cube * xs.zeros(t**3 - 2).roots[0],
            square_root(root + 2) ** 2 - root,
            (root + 1) * (root - 1) + 1,
            Extreme(1, [root, Real(2)]),
        ],
        "0": [Real(0), root - root, ROOT_2 + ROOT_3 - square_root(5 + 2 * square_root(6)), cube - 1 * cube, 0 * cube],
        "nested": [square_root(5 + 2 * square_root(6)), ROOT_2 + ROOT_3, ROOT_3 + root, 1 / (ROOT_3 - ROOT_2)],
        "1/3": [Real("1/3"), Real(Fraction(1, 3)), root / (3 * root), xs.zeros(3 * t - 1).roots[0], 1 / (cube**3 + 1)],
    }


@pytest.mark.parametrize("name", same_numbers())
def test_equal_numbers_are_equal_and_have_one_hash(name):
    numbers = same_numbers()
    group = numbers[name]
    for x in group:
        for y in group:
            assert x == y
            assert not x < y
            assert x <= y
        for other in numbers:
            if other != name:
                assert all(x != y for y in numbers[other])
    assert len({hash(x) for x in group}) == 1
    assert len(set(group)) == 1


def test_numbers_of_other_libraries():
    half = Real("1/2")
    for other in (mpq(1, 2), Fraction(1, 2)):
        assert half == other
        assert other == half
        assert hash(half) == hash(other)
        assert {other: 1}[half] == 1
        assert other < ROOT_2
        assert other < ROOT_2
    for two in (2, mpz(2), fmpz(2), mpq(2), Fraction(2)):
        assert two == ROOT_2 * ROOT_2
        for operation in OPERATIONS:
            for made in (operation(ROOT_2 + ROOT_3, two), operation(two, ROOT_2 + ROOT_3)):
                assert isinstance(made, Real)
            with mp.workdps(100):
                assert close(operation(two, ROOT_2), operation(mpmath.mpf(2), in_mpmath(ROOT_2)), 60, 90)
    assert Real(2) == fmpz(2)
    assert Real(Decimal("0.5")) == half
    for never in (0.5, "1/2", None, 1j):
        assert half != never
        assert (half == never) is False
        for operation in OPERATIONS:
            with pytest.raises(TypeError):
                operation(half, never)
    with pytest.raises(TypeError):
        half < 0.25  # noqa: B015
    with pytest.raises(NumberError):
        Real(0.5)
    with pytest.raises(NumberError):
        real("√2")


@pytest.mark.parametrize("digits", [20, 50, 300, 1000])
def test_numbers_that_agree_to_many_digits_are_told_apart(digits):
    """Equal to a given number of digits and different: a number of correct digits would call them equal."""
    tiny = mpq(1, 10**digits)
    for x in (ROOT_2, ROOT_2 + ROOT_3, square_root(1 + ROOT_2), xs.zeros(xs.BSpline.bezier([-1, -1, 1])).roots[0]):
        near = x + tiny
        assert near != x
        assert x < near
        assert near - x == tiny
        assert near - tiny == x
        assert (near - x).exact == tiny
        assert hash(near - tiny) == hash(x)


def test_signs_zero_and_truth():
    assert [(ROOT_2 - t).sign for t in (1, mpq(1414, 1000), mpq(15, 10))] == [1, 1, -1]
    zero = ROOT_2 + ROOT_3 - square_root(5 + 2 * square_root(6))
    assert zero.sign == 0
    assert not zero
    assert zero.exact == 0
    assert float(zero) == 0
    assert ROOT_2
    assert abs(-ROOT_2) == ROOT_2 == +ROOT_2
    for made in (lambda: 1 / zero, lambda: ROOT_2 / zero, lambda: ROOT_2 / 0, lambda: zero**-1):
        with pytest.raises(ZeroDivisionError):
            made()
    with pytest.raises(NumberError, match="square root"):
        square_root(ROOT_2 - 2)
    assert square_root(zero) == 0
    assert ROOT_2**0 == 1
    assert (ROOT_2 + ROOT_3) * (5 + 2 * square_root(6)) == (ROOT_2 + ROOT_3) ** 3
    assert (ROOT_2 + ROOT_3) ** -1 == ROOT_3 - ROOT_2


def high(degree, seed):
    """An irrational number of a degree."""
    chance = random.Random(seed)
    while True:
        f = polynomial([*(chance.randint(-9, 9) for _ in range(degree)), 1], 0, 1)
        if found := [r for r in xs.zeros(f) if r.exact is None and len(r.minimal_polynomial()) == degree + 1]:
            return found[0]


def test_what_would_take_too_high_a_degree_is_refused_by_name():
    """Degrees 20 and 20 have sums of degree 400: digits and order have no bound, equality says that it has one; that no
    polynomial of degree 2 has such a zero is decided without theirs.
    """
    a, b = high(20, 1), high(20, 2)
    total = a + b
    with mp.workdps(4000):
        assert close(total, in_mpmath(a) + in_mpmath(b), 200)
    assert total > a
    assert total - b > a - mpq(1, 10**50)
    assert float(total) == float(in_mpmath(total))
    assert (total.exact, total.closed_form, hash(total)) == (None, None, hash(b + a))
    for question in (total.minimal_polynomial, lambda: total - b == a):
        started = time.perf_counter()
        with pytest.raises(ReachError) as refused:
            question()
        assert time.perf_counter() - started < 20
        assert "degree 400" in str(refused.value)
    assert (a + 1).minimal_polynomial() == fmpz_poly(a.minimal_polynomial())(fmpz_poly([-1, 1])).coeffs()
    assert len((a * a).minimal_polynomial()) == 21, "what is computed from one root has its degree"


def test_a_long_expression_needs_no_deep_recursion():
    x = ROOT_2 + ROOT_3
    total = x
    for _ in range(300):
        total = total + x
    with mp.workdps(4000):
        assert close(total, 301 * in_mpmath(x))
    assert total.minimal_polynomial() == (301 * x).minimal_polynomial()
    assert total == 301 * x
    t = xs.zeros(xs.BSpline.bezier([-1, -1, 1])).roots[0]
    chain = t
    for k in range(1200):
        chain = chain + t if k % 2 else chain - t
    assert chain == t
    assert hash(chain) == hash(t)


@pytest.mark.parametrize("x", [ROOT_2, ROOT_2 + ROOT_3, Real("2/3"), square_root(1 + ROOT_2), 1 - ROOT_3, Real(0)])
def test_only_a_number_of_digits_is_one(x):
    low, high = x.enclosure(30)
    assert low <= x <= high
    for question in (x.enclosure, x.decimal, x.mpf, x.significant, x.__round__):
        for digits in (1.5, -1, True, "3", 10**9):
            with pytest.raises(ShapeError, match="a number of digits"):
                question(digits)


ZEROS = [
    ROOT_2 + ROOT_3 - square_root(5 + 2 * square_root(6)),
    (ROOT_2 + ROOT_3) ** 2 - 5 - 2 * square_root(6),
    (1 + square_root(5)) * ROOT_3 / 2 - square_root((9 + 3 * square_root(5)) / 2),
]


@pytest.mark.parametrize("zero", ZEROS, ids=range(len(ZEROS)))
def test_a_number_that_is_0_is_written_0(zero):
    """Was printed as 3.41…e-471, and its double was −0.0."""
    assert (str(zero), repr(zero), zero.shortly()) == ("0", "<Real 0>", "0")
    assert math.copysign(1, float(zero)) == 1
    assert str(zero + mpq(1, 10**500)) == "1.0e-500…"
    assert str(zero - mpq(1, 10**500)) == "-1.0e-500…"


@pytest.mark.parametrize("x", [ROOT_2, -ROOT_2, ROOT_2 + ROOT_3, -ROOT_2 - ROOT_3, Real("-7/2"), Real(3), *ZEROS])
def test_integers_and_decimals_of_a_number(x):
    """`int(root)` and `round(root, 2)` were TypeErrors."""
    with mp.workdps(60):
        value = mpmath.mpf(x.mpf(50))
        assert int(x) == math.trunc(x) == int(value)
    for digits in (0, 1, 2, 20):
        rounded = round(x, digits)
        assert type(rounded) is type(mpq())
        assert abs(x - rounded) <= mpq(1, 2 * 10**digits)
        assert (rounded * 10**digits).denominator == 1
    assert (round(Real("1/8"), 2), round(Real("3/8"), 2)) == (mpq(3, 25), mpq(19, 50)), "ties to even"


@pytest.mark.parametrize(
    ("first", "question"),
    [
        ("large", lambda x: x < 10),
        ("large", lambda x: float(1 / (1 + x))),
        ("small", lambda x: x == 1),
        ("small", repr),
        ("small", lambda x: x.decimal(3)),
    ],
)
def test_no_number_is_too_large_or_too_small_to_be_asked(first, question):
    """Was a MemoryError for numbers of 2⁶⁰ digits; these have 2⁹⁰."""
    a, b = high(2, 3), high(2, 4)
    x = abs(a) + abs(b) + 2 if first == "large" else (abs(a) - abs(b)) / (abs(a) + abs(b))
    for _ in range(90):
        x = x * x
    started = time.process_time()
    with suppress(ReachError):
        question(x)
    assert time.process_time() - started < 60


@pytest.mark.parametrize(("degree", "power"), [(3, 1000), (5, 10_000), (12, 1000), (30, 1000)])
def test_the_polynomial_of_a_power_has_a_bound(degree, power):
    """Before, two minutes for the 10000th power of a number of degree 5 in one call that could not be interrupted."""
    x, started = high(degree, degree) ** power, time.process_time()
    with suppress(ReachError):
        assert len(x.minimal_polynomial()) <= degree + 1
    assert time.process_time() - started < 60


def test_digits_shown():
    """`mpf(60)` showed 15 digits."""
    root = xs.zeros(xs.BSpline.bezier([-1, -1, 1])).roots[0]
    shown = root.mpf(60)
    assert repr(shown) == f"mpf('{root.decimal(60).rstrip('0')}')"
    assert str(shown) == root.decimal(60).rstrip("0")
    assert isinstance(shown, mpmath.mpf)
    assert mp.dps == 15
    assert str(shown + 0) == "0.707106781186548"
    for other in (pickle.loads(pickle.dumps(shown)), copy.copy(shown)):
        assert other == shown
        assert str(other) == str(shown)
    assert str(square_root("1/8").significant(20)) == "0.3535533905932737622"
    assert str(Real(2).mpf(40)) == "2.0"
    assert str((ROOT_2 - ROOT_2 * (1 - mpq(1, 10**50))).significant(10)) == "1.414213562e-50"
    assert (Real(0).decimal(3), Real("-2/3").decimal(0), (-ROOT_2).decimal(12)) == ("0.000", "-1", "-1.414213562373")
    assert (str(ROOT_2 + 1), repr(ROOT_3 / -4), str(ROOT_2 + ROOT_3)) == ("1 + √2", "<Real -√3/4>", "3.14626436994197…")


@pytest.mark.parametrize("way", ["nearest", "down", "up"])
@pytest.mark.parametrize("dial", EVERY)
def test_doubles_are_correctly_rounded(dial, way):
    chance = random.Random(f"{dial} doubles")
    ways = {"nearest": "n", "down": "f", "up": "c"}
    for _ in range(4):
        a, b = (chance.choice(roots(chance, EVERY[dial])) for _ in range(2))
        for made in (a + b, a * b, a - 1, abs(a)):
            with mp.workdps(4000):
                true = in_mpmath(made if made.exact is None else made.exact)
                if not mpmath.mpf("1e-290") < abs(true) < mpmath.mpf("1e300"):
                    continue
            expected = mpmath.libmp.to_float(true._mpf_, rnd=ways[way])
            assert made.double(way) == expected


@pytest.mark.parametrize("x", [ROOT_2, ROOT_2 + ROOT_3, ROOT_2 * (ROOT_2 + ROOT_3) - square_root(6), Real("7/2")])
def test_integers_near_a_number(x):
    for k in (-3, 0, 4):
        for y in (x + k, -x + k, x * 10**20):
            value = y.exact if y.exact is not None else y.enclosure(60).middle
            assert (math.floor(y), math.ceil(y), round(y)) == (
                math.floor(Fraction(value)),
                math.ceil(Fraction(value)),
                round(Fraction(value)),
            )


def test_largest_and_smallest():
    among = [ROOT_2, ROOT_3, ROOT_2 + mpq(1, 10**40), Real(1)]
    assert Extreme(1, among) == ROOT_3
    assert Extreme(-1, among) == 1
    assert Extreme(1, [among[0], among[2]]).minimal_polynomial() == among[2].minimal_polynomial()


# ---- polynomials


@pytest.mark.parametrize("seed", range(20))
def test_polynomials_of_rational_functions_vanish_there(seed):
    chance = random.Random(seed)
    m = fmpz_poly([chance.randint(-9, 9) for _ in range(chance.randint(2, 6))] + [chance.randint(1, 9)])
    top, bottom = (
        fmpq_poly(
            [to_fmpq(mpq(chance.randint(-9, 9), chance.randint(1, 4))) for _ in range(chance.randint(1, 7))] + [1]
        )
        for _ in range(2)
    )
    found = elimination.quotient_at(m, top, bottom)
    common = m.gcd(top.numer().gcd(bottom.numer()))
    assert found.degree() <= m.degree()
    for x, _ in (m // common).complex_roots():
        above, below = top.numer()(x) * bottom.denom(), bottom.numer()(x) * top.denom()
        if not below.contains(0):
            assert found(above / below).contains(0)


def test_kinds_by_construction():
    kinds = {RationalNumber: [Real(2), ROOT_2 * ROOT_2, ROOT_2 - ROOT_2, square_root("9/4"), 0 * (ROOT_2 + ROOT_3)]}
    kinds[Quadratic] = [ROOT_2, 1 + ROOT_2, ROOT_2 * ROOT_3, ROOT_2 / ROOT_3, 1 / (1 + ROOT_2), square_root(8) + ROOT_2]
    for kind, numbers in kinds.items():
        assert [type(x) for x in numbers] == [kind] * len(numbers)
    large = 1009**2 * 3  # a square factor that is not looked for
    assert square_root(large) == 1009 * ROOT_3
    assert hash(square_root(large)) == hash(1009 * ROOT_3)
    assert square_root(large) + ROOT_3 == 1010 * ROOT_3
    assert isinstance(xs.zeros(xs.BSpline.bezier([-1, -1, 1])).roots[0], Root)


def test_a_product_with_a_hidden_zero_is_compared():
    """Before, a ZeroDivisionError once the zero was known to be one."""
    zero = ROOT_2 + ROOT_3 - square_root(5 + 2 * square_root(6))
    product = zero * (ROOT_2 + ROOT_3)
    assert hash(zero) == hash(0)
    assert (product == 0, product.sign, product < 1, product > -1, product == 1) == (True, 0, True, True, False)
    assert (2 + product).sign == 1
    assert str(product) == "0"


@pytest.mark.parametrize("x", [Real("1e-5000") * ROOT_2, 1 + Real("1e-5000") * ROOT_2, Real("1e5000") * ROOT_2])
def test_a_number_with_many_digits_is_printed(x):
    """Once a ValueError of Python, which refuses to print integers of more than 4,300 digits; then 5,000 digits."""
    assert len(x.closed_form) > 4300
    assert str(x)[0] == "1"
    assert str(x).endswith("…")
    assert len(str(x)) < 30
    assert repr(x).endswith("…>")
    assert len(repr(x)) < 30


@pytest.mark.parametrize("x", [Real(2), ROOT_2, 1 + ROOT_2, Real("1/3")])
def test_a_power_has_a_bound(x):
    """Before, `Real(2) ** 10**12` did not end."""
    with pytest.raises(ReachError, match="a power of about"):
        x**10**12
    assert (x**-3) * x**3 == 1
    assert Real(-1) ** (10**12 + 1) == -1
    assert Real(0) ** 10**12 == 0


@pytest.mark.parametrize("k", range(1, 12))
def test_a_number_between_is_strictly_between(k):
    """√2 and its decimals cut after k digits, from both sides."""
    t = BSpline.identity(0, 2)
    (root,) = zeros(t * t - 2)
    below = mpq(isqrt(2 * 100**k), 10**k)
    above = below + mpq(1, 10**k)
    assert below < between(below, root) < root < between(root, above) < above
    (other,) = zeros(t * t - (2 + mpq(1, 10**k)))
    middle = between(root, other)
    assert 2 < middle**2 < 2 + mpq(1, 10**k)
    assert bin(middle.denominator).count("1") == 1
    assert between(mpq(1), mpq(5, 4)) == mpq(9, 8)
    assert between(ROOT_2, ROOT_3) == mpq(13, 8)
    x = ROOT_2 + ROOT_3
    assert x < between(x, x + mpq(1, 10**30)) < x + mpq(1, 10**30)


@given(st.integers(1, 10**9), st.integers(0, 40), st.integers(1, 12), st.sampled_from([1, -1]), st.integers(0, 8))
def test_significant_digits_are_certain(top, power, digits, sign, shift):
    """However small the number, and wherever it lies in its enclosures, which are 10⁻ⁿ wide."""
    exact, asked = mpq(sign * top, 10**power * 7), []

    class Given(Digits):
        def _enclosed(self, n):
            asked.append(n)
            width = mpq(1, 10**n)
            return Interval(exact - width * mpq(shift, 9), exact + width * mpq(9 - shift, 9))

        def _against_number(self, t):
            return (exact > t) - (exact < t)

    told = mpq(*to_rational(Given().significant(digits)._mpf_))
    assert asked == sorted(asked)
    assert abs(told - exact) * 10**digits <= abs(exact)


def test_a_ball_is_not_told_from_what_it_may_be():
    """1/2 is neither above nor below itself; that a ball around it is 1/2 is proved where it has no radius alone."""
    half = mpq(1, 2)
    with pytest.raises(OpenError, match="undecided at"):
        InBalls(lambda bits: arb("0.5", arb((1, -bits)))) > half  # noqa: B015
    assert InBalls(lambda bits: arb("0.5")) == half
    for other, sign in ((mpq(1, 2) + mpq(1, 10**30), -1), (mpq(1, 2) - mpq(1, 10**30), 1), (mpq(0), 1), (mpq(1), -1)):
        assert (InBalls(lambda bits: arb("0.5")) - other).sign == sign
