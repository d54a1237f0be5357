"""The algebra of the checker, which is the standard library alone, held against FLINT and against values at points."""

from fractions import Fraction
from itertools import product
from math import comb, perm
from random import Random

import pytest
from flint import fmpz_mat

from exactspline.certificates.elimination import (
    at_height,
    changes_sign,
    common_divisor,
    determinant,
    has_one_root,
    integral,
    is_free,
    on_interval,
    powers_of_net,
    quotient_by,
    quotient_over,
    remainder_of,
    require_place,
    sheared,
    sign_at_root,
    sign_over,
    strict_sign,
    subresultant,
    through,
    total,
    trimmed,
    value_of,
    value_over,
    zero_at,
)
from exactspline.certificates.numbers import CertificateError
from exactspline.certificates.zero_curves import NODE, POINT, extremes, kind_by_hessian, net_product, on_line
from exactspline.certificates.zeros import product_of

SEEDS = range(60)


def polynomial(random, degree, size=6):
    return [*(random.randint(-size, size) for _ in range(degree)), random.choice([-1, 1]) * random.randint(1, size)]


def rows_of(random, degrees):
    return [polynomial(random, n) for n in degrees]


def at(rows, s, z):
    return sum(value_of(row, z) * s**i for i, row in enumerate(rows))


def times(first, second):
    found = [[0] for _ in range(len(first) + len(second) - 1)]
    for (i, p), (j, q) in product(enumerate(first), enumerate(second)):
        found[i + j] = total(found[i + j], product_of(p, q))
    return found


def from_roots(roots):
    found = [1]
    for r in roots:
        found = product_of(found, [-r.numerator, r.denominator])
    return found


def bernstein(values, x):
    n = len(values) - 1
    return sum(comb(n, i) * c * x**i * (1 - x) ** (n - i) for i, c in enumerate(values))


def of_net(net, x, y):
    return bernstein([bernstein(row, y) for row in net], x)


def net(random, m, n, size=5):
    return [[random.randint(-size, size) for _ in range(n + 1)] for _ in range(m + 1)]


def fraction(random, low=0, high=1):
    return low + (high - low) * Fraction(random.randint(0, 24), 24)


@pytest.mark.parametrize("seed", SEEDS)
def test_subresultants_tell_the_degree_of_the_common_divisor(seed):
    random = Random(seed)
    degrees = [random.randint(0, 2) for _ in range(3)]
    common, *others = (rows_of(random, [random.randint(0, 1) for _ in range(n + 1)]) for n in degrees)
    first, second = (times(common, p) for p in others)
    k, least = degrees[0], min(len(first), len(second)) - 1
    if max(len(first), len(second)) == 1:
        with pytest.raises(ValueError, match="does not exist"):
            subresultant(first, second, 0)
        return
    assert all(not subresultant(first, second, j) for j in range(k))
    # what remains has no common divisor at some height, and is a minor of Sylvester's matrix there
    found = subresultant(first, second, k)
    m, n = len(first) - 1, len(second) - 1
    assert k <= least
    for z in range(-2, 3):
        f, g = ([value_of(row, z) for row in rows[::-1]] for rows in (first, second))
        size = m + n - 2 * k
        lines = [([0] * i + f + [0] * size)[:size] for i in range(n - k)]
        lines += [([0] * i + g + [0] * size)[:size] for i in range(m - k)]
        assert value_of(found, z) == (int(fmpz_mat(lines).det()) if size else 1)
    with pytest.raises(ValueError, match="does not exist"):
        subresultant(first, second, least + 1)


@pytest.mark.parametrize("seed", SEEDS)
def test_shearing_keeps_values(seed):
    random = Random(seed)
    powers = [polynomial(random, 2) for _ in range(3)]
    slope = random.randint(1, 4)
    for s, z in product((Fraction(1, 3), Fraction(-2)), (Fraction(2, 5), Fraction(3))):
        assert at(sheared(powers, slope), s, z) == at(powers, s, z - slope * s)


@pytest.mark.parametrize("seed", SEEDS)
def test_one_root_is_one_root(seed):
    """A root on an end, a double one, two or none are not one."""
    random = Random(seed)
    roots = [fraction(random, -1, 2) for _ in range(random.randint(1, 4))]
    p = product_of(from_roots(roots), [random.choice([-3, 2])])
    low, high = sorted(random.sample([Fraction(k, 24) for k in range(25)], 2))
    inside = [r for r in roots if low <= r <= high]
    if has_one_root(p, low, high):
        assert len(inside) == 1
        assert low < inside[0] < high
    if len(roots) == 1:
        assert has_one_root(p, low, high) == (low < roots[0] < high)
    if sign := strict_sign(p, low, high):
        assert not inside
        assert sign * value_of(p, (low + high) / 2) > 0
    assert not has_one_root(from_roots([low, (low + high) / 2]), low, high)
    assert not has_one_root(from_roots([(low + high) / 2, high]), low, high)


@pytest.mark.parametrize("seed", SEEDS)
def test_values_quotients_and_signs(seed):
    random = Random(seed)
    p, q = (polynomial(random, random.randint(0, 4)) for _ in range(2))
    low, x = Fraction(random.randint(-9, 9), 5), fraction(random)
    high = low + Fraction(random.randint(1, 9), 7)
    assert bernstein(on_interval(p, low, high), x) == value_of(p, low + (high - low) * x)
    assert quotient_by(product_of(p, q), q) == p
    if len(q) > 1:
        assert quotient_by(total(product_of(p, q), [1]), q) is None
        rest = remainder_of(p, q)
        assert len(rest) < len(q)
        assert not remainder_of(total([Fraction(c) for c in p], [-c for c in rest]), q)
    assert trimmed(through([value_of(p, k) for k in range(len(p) + 2)])) == p
    matrix = [[random.choice([0, 0, 1, -2, 3]) for _ in range(4)] for _ in range(4)]
    assert determinant(matrix) == int(fmpz_mat(matrix).det())
    # at the root of 2x² − 1 between 0 and 1
    around = total(product_of([-1, 0, 2], q), [random.choice([-1, 1])])
    assert sign_at_root(around, [-1, 0, 2], Fraction(0), Fraction(1)) == (1 if around[0] + q[0] > 0 else -1)


def test_a_polynomial_has_the_sign_zero_at_its_own_root():
    assert sign_at_root([-1, 0, 2], [-1, 0, 2], Fraction(0), Fraction(1)) == 0
    assert sign_at_root([1, -2], [-1, 2], Fraction(1, 2), Fraction(1, 2)) == 0


@pytest.mark.parametrize("seed", SEEDS)
def test_nets_multiply_and_are_cut(seed):
    random = Random(seed)
    one, other = (net(random, random.randint(0, 3), random.randint(0, 3)) for _ in range(2))
    x, y = fraction(random), fraction(random)
    whole, values = net_product(one, other), of_net(one, x, y) * of_net(other, x, y)
    assert (of_net(whole, x, y) > 0) == (values > 0)
    assert (len(whole), len(whole[0])) == (len(one) + len(other) - 1, len(one[0]) + len(other[0]) - 1)
    u, v = Fraction(1, 7), Fraction(5, 6)
    assert of_net(whole, x, y) * of_net(one, u, v) * of_net(other, u, v) == of_net(whole, u, v) * values
    for direction, (a, b) in enumerate([(x, y), (y, x)]):
        line = on_line(one, direction, a)
        assert bernstein(line, b) * of_net(one, x, y) >= 0
        ends = [of_net(one, *((a, t) if direction == 0 else (t, a))) for t in (0, 1)]
        assert line[0] * ends[1] == line[-1] * ends[0]
        assert (line[0] > 0) == (ends[0] > 0)
    assert extremes([]) == (0, 0)


@pytest.mark.parametrize("seed", range(300))
def test_the_kind_of_a_singular_point_is_that_of_all_hessians(seed):
    random = Random(seed)
    a, b, c = (random.randint(-3, 3) for _ in range(3))
    m, n, noise = (2, 2, 0) if seed % 2 else (random.randint(1, 3), random.randint(1, 3), 6)
    given = [
        [8 * (a * i * i + 2 * b * i * j + c * j * j) + random.randint(-noise, noise) for j in range(n + 1)]
        for i in range(m + 1)
    ]
    kind = kind_by_hessian(given)
    for x, y in product((Fraction(0), Fraction(1, 3), Fraction(1)), repeat=2):
        determinants = hessian(given, x, y)
        assert kind != POINT or determinants > 0
        assert kind != NODE or determinants < 0
    if not noise:
        assert kind == (POINT if a * c > 4 * b * b else NODE if a * c < 4 * b * b else "")


def hessian(given, x, y):
    """The determinant of the second derivatives."""
    powers = powers_of_net(given)
    xx, xy, yy = (
        sum(
            perm(i, di) * perm(j, dj) * c * x ** max(i - di, 0) * y ** max(j - dj, 0)
            for i, row in enumerate(powers)
            for j, c in enumerate(row)
        )
        for di, dj in ((2, 0), (1, 1), (0, 2))
    )
    return xx * yy - xy * xy


@pytest.mark.parametrize("seed", SEEDS)
def test_an_interval_free_of_other_zeros(seed):
    random = Random(seed)
    minimal = [-1, 0, 2]
    roots = [fraction(random, -1, 2) for _ in range(random.randint(0, 2))]
    # a factor that is positive, but whose Bernstein coefficients have both signs on the whole interval
    p = product_of(from_roots(roots), [17, -64, 64])
    p = product_of(p, minimal) if random.randint(0, 1) else p
    within = [r for r in roots if 0 <= r <= 1]
    free = is_free(p, minimal, (Fraction(0), Fraction(1)))
    assert free == (not within)
    assert not is_free(minimal, [], (Fraction(0), Fraction(1)))


@pytest.mark.parametrize("seed", SEEDS)
def test_polynomials_over_a_root(seed):
    """Over √(1/2): values, signs on a box and quotients."""
    random = Random(seed)
    minimal, root = [-1, 0, 2], (Fraction(7, 10), Fraction(71, 100))
    rows = rows_of(random, [random.randint(0, 1) for _ in range(random.randint(1, 3))])
    factor = [[Fraction(random.randint(-3, 3)), Fraction(random.randint(-3, 3))], [Fraction(1)]]
    whole = times(rows, factor)
    assert [trimmed(row) for row in quotient_over(whole, factor, minimal)] == [
        trimmed(remainder_of(r, minimal)) for r in rows
    ]
    if any(remainder_of(total(whole[0], [1]), minimal)):
        assert quotient_over([total(whole[0], [1]), *whole[1:]], factor, minimal) is None
    side = tuple(sorted(random.sample([Fraction(k, 6) for k in range(-6, 7)], 2)))
    sign = sign_over(rows, root, side)
    points = list(product((*root, sum(root) / 2), (*side, sum(side) / 2)))
    values = [sum(value_of(row, x) * y**j for j, row in enumerate(rows)) for x, y in points]
    assert not sign or all(sign * each > 0 for each in values)
    assert sign_over([[], [0, 1]], root, (Fraction(1, 2), Fraction(1))) == 1
    assert sign_over([[-1], [], [0, 1]], root, (Fraction(0), Fraction(1))) == -1
    assert sign_over([], root, side) == 0
    height = Fraction(random.randint(-4, 4), 3)
    flat = at_height(factor, height)
    x = Fraction(5, 9)
    assert value_of(flat, x) == value_of(factor[0], x) + height
    assert (value_over(factor, height, root, minimal) == 0) == (not any(flat))
    scaled = integral(flat)
    assert all(isinstance(c, int) for c in scaled)
    assert all(c * value_of(flat, Fraction(1)) == d * value_of(scaled, 1) for c, d in zip(scaled, flat, strict=False))


# ---- places of zeros of forms Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ, which vanish where the polynomial does at t/(1 − t)


#: A form with the zeros t = 1/2 and 3/4, and leaves that have one of them inside and the other at an end.
TWO_ZEROS = [3, -4, 1]
FIRST, SECOND, WIDE = ("0", "3/4"), ("1/2", "1"), ("0", "5/8")


@pytest.mark.parametrize(("leaf", "place", "flaw"), [
    (("1/2", "1/2"), ("1/2", "1/2"), None), (("1/2", "1/2"), ("3/4", "3/4"), "another place"),
    (("1/2", "1/2"), ("1/4", "3/4"), "another place"), (SECOND, ("3/4", "3/4"), None), (FIRST, ("1/2", "1/2"), None),
    (SECOND, ("1/2", "1/2"), "not the zero"), (FIRST, ("3/4", "3/4"), "not the zero"),
    (SECOND, ("5/8", "5/8"), "not the zero"), (SECOND, ("1/4", "1/4"), "not the zero"),
    (SECOND, ("5/8", "7/8"), None), (SECOND, ("5/8", "1"), None), (WIDE, ("0", "5/8"), None),
    (SECOND, ("5/8", "3/4"), "without the zero"), (SECOND, ("3/4", "7/8"), "without the zero"),
    (SECOND, ("1/2", "7/8"), "without the zero"), (SECOND, ("1/4", "7/8"), "outside the leaf"),
    (FIRST, ("1/4", "7/8"), "outside the leaf"), (SECOND, ("7/8", "5/8"), "outside the leaf"),
])  # fmt: skip
def test_a_place_has_the_zero_of_its_leaf_and_no_other(leaf, place, flaw):
    zero = (*map(Fraction, leaf), TWO_ZEROS, 1, (1, -1))
    if flaw is None:
        require_place(zero, *map(Fraction, place))
    else:
        with pytest.raises(CertificateError, match=flaw):
            require_place(zero, *map(Fraction, place))


@pytest.mark.parametrize(("form", "low", "high", "expected"), [
    ([-1, 1], 0, 1, True), ([1, -1], 0, 1, True), ([0, 1], 0, 1, False), ([1, 0], 0, 1, False), ([1, 1], 0, 1, False),
    (TWO_ZEROS, "1/4", "5/8", True), (TWO_ZEROS, "1/4", "7/8", False), ([3], 0, 1, False),
])  # fmt: skip
def test_a_form_changes_its_sign_between_two_parameters(form, low, high, expected):
    assert changes_sign(form, Fraction(low), Fraction(high)) is expected


@pytest.mark.parametrize(("form", "factor", "low", "high", "expected"), [
    ([-2, 1], [4, 0, -1], "2/3", "2/3", True), ([-2, 1], [4, 0, -1], "1/2", "1/2", False),
    ([-2, 1], [4, 0, -1], "1/2", "1", True), ([-3, 1], [4, 0, -1], "1/2", "1", False),
    # a zero in common, but not the one in the interval
    ([-5, 1], [10, -7, 1], "1/2", "3/4", False), ([-5, 1], [10, -7, 1], "3/4", "1", True),
    ([0, 0], [-2, 1], "1/2", "1", True),
])  # fmt: skip
def test_a_form_vanishes_at_the_zero_of_a_factor_that_is_in_an_interval(form, factor, low, high, expected):
    assert zero_at(form, factor, Fraction(low), Fraction(high)) is expected


@pytest.mark.parametrize(("p", "q", "expected"), [
    ([-1, 0, 0, 1], [-1, 1], [-1, 1]), ([-1, 1], [-1, 0, 0, 1], [-1, 1]), ([2, -3, 1], [3, -4, 1], [-1, 1]),
    ([1, 1], [2, 1], [1]), ([], [4, 2], [4, 2]), ([4, 2, 0], [0], [4, 2]), ([0], [], []),
    ([-6, 11, -6, 1], [4, -5, 1], [-1, 1]), ([6, 5, 1, 0], [3, 4, 1], [3, 1]),
])  # fmt: skip
def test_a_common_divisor_is_one_up_to_a_constant(p, q, expected):
    found = common_divisor(p, q)
    assert len(found) == len(expected)
    assert all(x * expected[0] == y * found[0] for x, y in zip(found, expected, strict=True))
