"""Discriminants and resultants of polynomials in two variables, by evaluation at integers and interpolation: an
interruptible loop with a cost that is bounded beforehand.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from flint import fmpz, fmpz_poly

from exactspline.numbers.exact import mpz
from exactspline.polynomials.cost import LONGEST_LOOP, check_reach, height_bits

#: Hundredths of a nanosecond for each bit of a value: times the product of the degrees to compute it, times the number
#: of values to interpolate (measured: 77 to 106, and 11 to 15); and ten-thousandths for each pair of bits, to compute a
#: value from its residues modulo many primes (measured of 5·10⁴ to 2·10⁶ bits: 1 to 18).
VALUE, INTERPOLATION, RESIDUES = 110, 15, 15


def discriminant(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The discriminant with respect to u of ``Σ rows[j](z) uʲ``, of degree m > 1 in u.

    It is a form of degree 2m − 2 in the rows, so that its degree in z is bounded; it is determined by its values at
    sufficiently many consecutive integers at which the leading row does not vanish. Raises `ReachError` if this would
    take too long.

    >>> discriminant([fmpz_poly([0, 1]), fmpz_poly([3]), fmpz_poly([1, 1])])
    (-4)*x^2 + (-4)*x + 9
    """
    m = len(rows) - 1
    degree = max(row.degree() for row in rows)
    bound = (2 * m - 2) * degree
    bits = (2 * m - 1) * (bits_of_values(rows, bound) + m.bit_length())
    _check(bound + 1, m * m, bits, f"the discriminant of a polynomial of degree {degree} × {m}")
    start = first_integer(rows[-1], bound + 1)
    return _through_whole([_at(rows, k).discriminant() for k in range(start, start + bound + 1)], start)


def resultant(first: Sequence[fmpz_poly], second: Sequence[fmpz_poly]) -> fmpz_poly:
    """The resultant with respect to u of two such sums, of degrees m and n in u: a form of degree n in the rows of the
    first and m in those of the second. Raises `ReachError` if this would take too long.

    >>> resultant([fmpz_poly([0, 1]), fmpz_poly([1])], [fmpz_poly([-2]), fmpz_poly([]), fmpz_poly([1])])
    x^2 + (-2)
    """
    m, n = len(first) - 1, len(second) - 1
    bound = n * max(row.degree() for row in first) + m * max(row.degree() for row in second)
    bits = n * bits_of_values(first, bound) + m * bits_of_values(second, bound) + (m + n) * (m + n).bit_length()
    _check(bound + 1, max(m, 1) * max(n, 1), bits, f"the resultant of degree {bound} of two polynomials")
    start = first_integer(first[-1] * second[-1], bound + 1)
    return _through_whole([_at(first, k).resultant(_at(second, k)) for k in range(start, start + bound + 1)], start)


def bits_of_values(rows: Sequence[fmpz_poly], count: int) -> int:
    """The number of bits of the values of the rows at this many consecutive integers around 0."""
    return max(height_bits(row.coeffs()) + (row.degree() + 1) * count.bit_length() for row in rows)


def _check(count: int, size: int, bits: int, what: str) -> None:
    cost = count * bits * (size * VALUE + count * INTERPOLATION + bits * RESIDUES // 100) // 100
    check_reach(cost, lambda: f"{what} with values of {bits} bits", LONGEST_LOOP)


def _at(rows: Sequence[fmpz_poly], k: int) -> fmpz_poly:
    return fmpz_poly([row(k) for row in rows])


def _through_whole(values: Sequence[fmpz], start: int) -> fmpz_poly:
    """The polynomial with these values at consecutive integers beginning at `start`."""
    return through([mpz(int(value)) for value in values])(fmpz_poly([-start, 1]))


def first_integer(leading: fmpz_poly, count: int) -> int:
    """The first of this many consecutive integers, close to 0, at which a polynomial does not vanish."""
    start = k = -(count // 2)
    while k < start + count:
        if leading(k) == 0:
            start = k + 1
        k += 1
    return start


def through(values: Sequence[mpz]) -> fmpz_poly:
    """The polynomial with these values at 0, 1, 2, …, of degree below their number and with integer coefficients, by
    Newton's forward differences.

    >>> through([mpz(1), mpz(2), mpz(5), mpz(10)])
    x^2 + 1
    """
    differences, row = [], list(values)
    factorial = mpz(1)
    for k in range(len(values)):
        differences.append(row[0])
        row = [b - a for a, b in pairwise(row)]
        factorial *= max(k, 1)
    # Horner's rule in x, x − 1, …, over a factorial as the common denominator, by which the result is divisible
    total, scale = fmpz_poly([]), mpz(1)
    for k in range(len(values) - 1, -1, -1):
        total = total * fmpz_poly([-k, 1]) + fmpz_poly([fmpz(int(differences[k] * scale))])
        scale *= max(k, 1)
    return total // fmpz(int(factorial))
