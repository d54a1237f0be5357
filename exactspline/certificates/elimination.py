"""Polynomials in two variables for the checkers of certificates, with only the standard library: subresultants, the
zeros of two polynomials over one root of their resultant, and enclosures of polynomials on intervals.

A polynomial in s and z is a list over the powers of s of polynomials in z, lists of coefficients, constant term first.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, gcd, lcm
from typing import Any, TypeVar

from exactspline.certificates.numbers import count, fraction, integer, require
from exactspline.certificates.zeros import Number, Zero, product_of, restricted

Polynomial = list[int]
Rows = list[Polynomial]
Coefficient = TypeVar("Coefficient")
Side = tuple[Fraction, Fraction]
#: The form of the proof that functions have a single zero in a box, with two combinations that vanish there.
SINGLE_ZERO = {
    "slope": integer,
    "minimal": [integer],
    "above": [integer],
    "below": integer,
    "pair": ([integer], [integer]),
    "power": count,
    "at": (fraction, fraction),
}
#: The limit of the bisections of an interval around a root to find a sign.
STEPS = 512


# ---- polynomials in one variable


def trimmed(p: Sequence[Coefficient]) -> list[Coefficient]:
    """The polynomial without leading zeros.

    >>> trimmed([1, 2, 0, 0])
    [1, 2]
    """
    n = len(p)
    while n and not p[n - 1]:
        n -= 1
    return list(p[:n])


def total(p: Sequence[Number], q: Sequence[Number]) -> list[Number]:
    """The sum of two polynomials.

    >>> total([1, 2], [3])
    [4, 2]
    """
    longer, other = (p, q) if len(p) >= len(q) else (q, p)
    return [x + other[i] if i < len(other) else x for i, x in enumerate(longer)]


def value_of(p: Sequence[int], x: Number) -> Number:
    """The value at a number.

    >>> value_of([1, 0, 2], 3)
    19
    """
    found = x - x
    for c in reversed(p):
        found = found * x + c
    return found


def on_interval(p: Sequence[Number], low: Fraction, high: Fraction) -> list[Fraction]:
    """The Bernstein coefficients of a polynomial on an interval, anywhere on the line.

    >>> on_interval([0, 0, 1], Fraction(0), Fraction(2))
    [Fraction(0, 1), Fraction(0, 1), Fraction(4, 1)]
    """
    powers, width = [Fraction(c) for c in p], high - low
    n = len(powers) - 1
    for i in range(n):
        for j in range(n - 1, i - 1, -1):
            powers[j] += low * powers[j + 1]
    powers = [c * width**k for k, c in enumerate(powers)]
    return [
        sum((Fraction(comb(i, k), comb(n, k)) * powers[k] for k in range(i + 1)), Fraction(0)) for i in range(n + 1)
    ]


def strict_sign(p: Sequence[Number], low: Fraction, high: Fraction) -> int:
    """The sign on an interval if all Bernstein coefficients have it, otherwise 0.

    >>> strict_sign([-5, 0, 1], Fraction(0), Fraction(2))
    -1
    """
    values = on_interval(p, low, high)
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


def sign_at_root(p: Sequence[Number], minimal: Sequence[int], low: Fraction, high: Fraction) -> int:
    """The sign at the root of another polynomial between two numbers at which this other polynomial has opposite signs,
    or at a number that is given twice; 0 if the polynomial vanishes there or nearly vanishes.

    >>> sign_at_root([-1, 1], [-2, 0, 1], Fraction(1), Fraction(2))  # √2 − 1
    1
    """
    for _ in range(STEPS):
        sign = strict_sign(p, low, high)
        if sign or low == high:
            return sign
        middle = (low + high) / 2
        if value_of(minimal, low) * value_of(minimal, middle) <= 0:
            high = middle
        if value_of(minimal, middle) * value_of(minimal, high) <= 0:
            low = middle
    return 0


def has_one_root(p: Sequence[int], low: Fraction, high: Fraction) -> bool:
    """Whether a polynomial certainly has one root in an interval, a simple one, by Descartes' rule.

    >>> has_one_root([-2, 0, 1], Fraction(1), Fraction(2))
    True
    """
    values = on_interval(p, low, high)
    return values[0] * values[-1] < 0 and sum(a * b < 0 for a, b in pairwise(x for x in values if x)) == 1


def require_only_root(p: Sequence[int], side: Side, whole: Side) -> None:
    """Raise `CertificateError` unless a polynomial without a content certainly has one root in an interval, which is in
    this part of it.
    """
    (low, high), is_linear = side, len(p) == 2
    require(len(p) > 1 and gcd(*p) == 1, "a factor that is constant or has a content")
    require(whole[0] <= low <= high <= whole[1], "a root outside the box")
    is_exact = low == high and value_of(p, low) == 0 and is_linear
    require(is_exact or (low < high and value_of(p, low) * value_of(p, high) < 0), "a place without a root")
    require(is_linear or has_one_root(p, *whole), "a factor that may have several roots")


def quotient_by(p: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """The quotient by a divisor with integer coefficients; None if there is no exact quotient.

    >>> quotient_by([-1, 0, 1], [1, 1]), quotient_by([1, 0, 1], [1, 1])
    ([-1, 1], None)
    """
    rest, found = list(p), list[int]()
    while len(rest) >= len(divisor):
        top, remainder = divmod(rest[-1], divisor[-1])
        if remainder:
            return None
        found.append(top)
        shift = len(rest) - len(divisor)
        for i, x in enumerate(divisor):
            rest[shift + i] -= top * x
        rest.pop()
    return None if any(rest) else found[::-1]


def remainder_of(p: Sequence[Fraction | int], divisor: Sequence[int]) -> list[Fraction]:
    """The remainder of a division of polynomials.

    >>> remainder_of([1, 0, 1], [1, 1])
    [Fraction(2, 1)]
    """
    rest, top = [Fraction(c) for c in p], Fraction(divisor[-1])
    while len(rest) >= len(divisor):
        factor, shift = rest[-1] / top, len(rest) - len(divisor)
        for i, x in enumerate(divisor[:-1]):
            rest[shift + i] -= factor * x
        rest.pop()
    return trimmed(rest)


# ---- polynomials in two variables


def powers_of_net(net: Sequence[Sequence[int]]) -> list[list[int]]:
    """The coefficients of ``sⁱ tʲ`` from the Bernstein coefficients on the unit square.

    >>> powers_of_net([[0, 0], [0, 1]])  # s t
    [[0, 0], [0, 1]]
    """
    columns = [_powers(row) for row in net]
    return [list(row) for row in zip(*[_powers(column) for column in zip(*columns, strict=True)], strict=True)]


def _powers(values: Sequence[int]) -> list[int]:
    differences, found = list(values), list[int]()
    n = len(values) - 1
    for k in range(n + 1):
        found.append(comb(n, k) * differences[0])
        differences = [y - x for x, y in pairwise(differences)]
    return found


def sheared(powers: Sequence[Sequence[int]], slope: int) -> Rows:
    """A polynomial in s and t as one in s and ``z = t + slope s``.

    >>> sheared([[0, 1]], 2)  # t = z − 2 s
    [[0, 1], [-2]]
    """
    rows: Rows = []
    for i, row in enumerate(powers):
        for j, x in enumerate(row):
            for k in range(j + 1 if x else 0):
                # t^j = Σ C(j, k) z^(j − k) (−slope s)^k
                while len(rows) <= i + k:
                    rows.append([])
                rows[i + k] = total(rows[i + k], [0] * (j - k) + [x * comb(j, k) * (-slope) ** k])
    return trimmed([trimmed(row) for row in rows])


def subresultant(first: Rows, second: Rows, k: int) -> Polynomial:
    """The k-th principal subresultant coefficient in s, a polynomial in z, for k = 0 the resultant: with those before
    it, it vanishes where the common divisor has a higher degree than k. By interpolation at integers.
    """
    m, n = len(first) - 1, len(second) - 1
    require(k <= min(m, n) and max(m, n) > 0, "a subresultant that does not exist")
    degrees = [max((len(row) - 1 for row in rows), default=0) for rows in (first, second)]
    points = (n - k) * degrees[0] + (m - k) * degrees[1] + 1
    values = []
    for x in range(points):
        f, g = ([value_of(row, x) for row in rows[::-1]] for rows in (first, second))
        size = m + n - 2 * k
        matrix = [[0] * i + f + [0] * (n - k - 1 - i) for i in range(n - k)]
        matrix += [[0] * i + g + [0] * (m - k - 1 - i) for i in range(m - k)]
        values.append(determinant([row[:size] for row in matrix]))
    return trimmed(through(values))


def determinant(matrix: list[list[int]]) -> int:
    """By Bareiss's algorithm: every entry is a minor, so that the divisions are exact.

    >>> determinant([[1, 2], [3, 4]])
    -2
    """
    rows, last = [list(row) for row in matrix], 1
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot] = rows[pivot], [-x for x in rows[k]]
        top = rows[k]
        for row in rows[k + 1 :]:
            row[k + 1 :] = [(top[k] * x - row[k] * y) // last for x, y in zip(row[k + 1 :], top[k + 1 :], strict=True)]
        last = top[k]
    return last


def through(values: list[int]) -> Polynomial:
    """The polynomial with these values at 0, 1, 2, …, which has integer coefficients.

    >>> through([0, 1, 4, 9])
    [0, 0, 1, 0]
    """
    differences = []
    while values:
        differences.append(values[0])
        values = [y - x for x, y in pairwise(values)]
    found: list[Fraction] = []
    for k in range(len(differences) - 1, -1, -1):
        # Newton: Δₖ + (x − k)/(k + 1) · the next term
        shifted = total([Fraction(0), *found], [-k * c for c in found])
        found = total([c / (k + 1) for c in shifted], [Fraction(differences[k])])
    return [int(c) for c in found]


# ---- the zeros over a root of the resultant


def check_single_zero(
    functions: Sequence[Sequence[Sequence[int]]], box: tuple[Side, Side], zero: Mapping[str, object]
) -> int:
    """Check that functions, given by their coefficients of ``sⁱ tʲ``, have exactly one common zero in a box, and return
    the intersection multiplicity of the `pair` of combinations there.

    In z = t + λ s the resultant of the pair has one root in all of the box, that of its factor `minimal`, with this
    multiplicity; over it the greatest common divisor is a power of s − b(z), and b solves all functions modulo that
    factor. As one of the pair has a constant leading coefficient in s, no common zero over the root is at infinity.
    """
    given: Mapping[str, Any] = zero
    slope, minimal, below = given["slope"], trimmed(given["minimal"]), given["below"]
    require(slope > 0, "a slope that is not positive")
    above = [Fraction(x, below) for x in given["above"]] if below > 0 else []
    rows = [sheared(powers, slope) for powers in functions]
    combined = [_combination(rows, row) for row in given["pair"]]
    require(all(len(p) > 1 for p in combined), "a pair without s")
    first, second = combined
    require(any(len(p[-1]) == 1 for p in combined), "zeros at infinity")
    # the root
    whole = (box[1][0] + slope * box[0][0], box[1][1] + slope * box[0][1])
    low, high = given["at"]
    require_only_root(minimal, (low, high), whole)
    require(below > 0 and len(above) < len(minimal), "a parametrization that is not reduced")
    rest, times = subresultant(first, second, 0), 0
    require(bool(rest), "a resultant that vanishes")
    while (divided := quotient_by(rest, minimal)) is not None:
        rest, times = divided, times + 1
    require(times > 0 and strict_sign(rest, *whole) != 0, "another root of the resultant")
    # the zero over it
    for p in rows:
        require(not remainder_of(composed(p, above, minimal), minimal), "a function that is not zero there")
    for x, (least, most) in ((above, box[0]), (total([Fraction(0), Fraction(1)], [-slope * c for c in above]), box[1])):
        values = on_interval(remainder_of(x, minimal) or [Fraction(0)], low, high)
        require(least <= min(values) and max(values) <= most, "a zero that may be outside its region")
    power = given["power"]
    require(power > 0, "a power that is not positive")
    for p in combined:
        require(_is_divisible(p, above, power, minimal), "a power that does not divide")
    # over the root one polynomial of the pair may have a lower degree, or vanish: only the degree of the other one is
    # known
    if power < min(len(p) - 1 for p in combined if len(p[-1]) == 1):
        leading = subresultant(first, second, power)
        require(bool(leading) and sign_at_root(leading, minimal, low, high) != 0, "another zero over the root")
    return times


def _combination(functions: Sequence[Rows], coefficients: Sequence[int]) -> Rows:
    require(len(coefficients) == len(functions), "a combination of another number of functions")
    found: Rows = []
    for c, rows in zip(coefficients, functions, strict=True):
        scaled = [[c * x for x in row] for row in rows]
        found = [
            total(found[i] if i < len(found) else [], scaled[i] if i < len(scaled) else [])
            for i in range(max(len(found), len(scaled)))
        ]
    return trimmed([trimmed(row) for row in found])


def composed(rows: Rows, above: Sequence[Fraction], minimal: Polynomial) -> list[Fraction]:
    """The value at s = b(z), modulo the factor.

    >>> composed([[0, 1], [1]], [Fraction(0), Fraction(-1)], [-2, 0, 1])  # z + s at s = −z
    []
    """
    found: list[Fraction] = []
    for row in reversed(rows):
        product = product_of(found, above) if found and above else []
        found = remainder_of(total(product, [Fraction(x) for x in row]), minimal)
    return found


def _is_divisible(rows: Rows, above: list[Fraction], power: int, minimal: Polynomial) -> bool:
    """Whether s − b(z) divides as often as that, modulo the factor, as it does where all of it vanishes."""
    given = [remainder_of(row, minimal) for row in rows]
    if not any(given):
        return True
    for _ in range(power):
        carried: list[Fraction] = []
        quotient = []
        for row in reversed(given):
            carried = remainder_of(total(product_of(carried, above) if carried and above else [], row), minimal)
            quotient.append(carried)
        if carried or len(quotient) < 2:
            return False
        given = quotient[-2::-1]
    return True


# ---- over a root


def is_free(p: Polynomial, minimal: Polynomial, side: Side, depth: int = 32) -> bool:
    """Whether a polynomial has no other zero on an interval than one of a factor."""
    while minimal and (divided := quotient_by(p, minimal)) is not None:
        p = divided
    if strict_sign(p, *side) or depth == 0:
        return strict_sign(p, *side) != 0
    middle = (side[0] + side[1]) / 2
    return all(is_free(p, [], half, depth - 1) for half in ((side[0], middle), (middle, side[1])))


def quotient_over(
    rows: Sequence[Sequence[Fraction]], factor: Sequence[Sequence[Fraction]], minimal: Polynomial
) -> list[list[Fraction]] | None:
    """The quotient of a polynomial in y by a monic polynomial, modulo the factor in x; None if there is no exact
    quotient.
    """
    rest, found = [list(row) for row in rows], list[list[Fraction]]()
    while len(rest) >= len(factor):
        top = remainder_of(rest.pop(), minimal)
        found.append(top)
        shift = len(rest) + 1 - len(factor)
        for i, row in enumerate(factor[:-1]):
            product = product_of(top, row) if top and row else []
            rest[shift + i] = remainder_of(total(rest[shift + i], [-x for x in product]), minimal)
    return None if any(remainder_of(row, minimal) for row in rest) else found[::-1]


def sign_over(rows: Sequence[Sequence[Any]], root: Side, side: Side) -> int:
    """The sign of a polynomial in x and y on a box, else 0."""
    columns = [on_interval(row or [0], *root) for row in rows]
    degree = max(map(len, columns), default=0)
    if degree == 0:
        return 0
    columns = [on_interval([*row, *[0] * (degree - len(row))], *root) for row in rows]
    values = [x for row in zip(*columns, strict=True) for x in on_interval(row, *side)]
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


def value_over(factor: Sequence[Sequence[Fraction]], at: Fraction, root: Side, minimal: Polynomial) -> int:
    """The sign of a factor at a height over the root, 0 where it vanishes."""
    rest = remainder_of(at_height(factor, at), minimal)
    if not rest:
        return 0
    sign = sign_at_root(rest, minimal, *root)
    require(sign != 0, "a sign over the root that is not proved")
    return sign


def at_height(rows: Sequence[Sequence[Any]], at: Fraction) -> list[Any]:
    """A polynomial in x and y, a list over the powers of y, at a rational y."""
    found: list[Any] = []
    for row in reversed(rows):
        found = total([c * at for c in found], row)
    return found


def integral(p: Sequence[Any]) -> Polynomial:
    """A multiple with integer coefficients."""
    numbers = [Fraction(c) for c in p]
    bottom = lcm(*(c.denominator for c in numbers))
    return trimmed([int(c * bottom) for c in numbers])


def require_place(zero: Zero, a: Fraction, b: Fraction) -> None:
    """Raise `ValueError` unless [a, b] has an isolated zero of a form, and no other one of its leaf."""
    low, high, factor, *_ = zero
    if low == high:
        require(a == b == low, "another place than that of the zero")
    elif a == b:
        require(low < a < high and restricted(factor, a, a)[0] == 0, "a place that is not the zero")
    else:
        require(low <= a < b <= high, "a place outside the leaf of the zero")
        require(changes_sign(factor, a, b), "a place without the zero")


def changes_sign(form: Polynomial, a: Fraction, b: Fraction) -> bool:
    """Whether a form has opposite signs at two parameters.

    >>> changes_sign([-1, 1], Fraction(0), Fraction(1))
    True
    """
    values = restricted(form, a, b)
    return values[0] * values[-1] < 0


def zero_at(form: Polynomial, factor: Polynomial, a: Fraction, b: Fraction) -> bool:
    """Whether a form is zero at the only zero of the factor in [a, b].

    >>> zero_at([-2, 1], [4, 0, -1], Fraction(1, 2), Fraction(1))  # at t/(1 − t) = 2
    True
    """
    if a == b:
        return restricted(form, a, b)[0] == 0
    return changes_sign(common_divisor(form, factor), a, b)


def common_divisor(p: Polynomial, q: Polynomial) -> Polynomial:
    """A greatest common divisor of two polynomials; empty if both are zero.

    >>> common_divisor([-1, 0, 1], [1, 2, 1])
    [-1, -1]
    """
    p, q = trimmed(p), trimmed(q)
    while q:
        rest = list(p)
        while len(rest) >= len(q):
            top, shift = rest[-1], len(rest) - len(q)
            rest = [x * q[-1] for x in rest]
            for i, x in enumerate(q):
                rest[shift + i] -= top * x
            rest = trimmed(rest[:-1])
        size = gcd(*rest)
        p, q = q, [x // size for x in rest]
    return p
