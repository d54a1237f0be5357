"""Discriminants and resultants of polynomials in two variables, by values at whole numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from flint import fmpz, fmpz_poly

from exactspline.exact import mpz


def discriminant(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The discriminant by u of ``Σ rows[j](z) uʲ``, of degree m > 1 in u.

    It is a form of degree 2m − 2 in the rows, so that its degree in z is bounded; its values at sufficiently many
    successive whole numbers, at which the leading row does not vanish, determine it.

    >>> discriminant([fmpz_poly([0, 1]), fmpz_poly([3]), fmpz_poly([1, 1])])
    (-4)*x^2 + (-4)*x + 9
    """
    bound = (2 * len(rows) - 4) * max(row.degree() for row in rows)
    start = _start(rows[-1], bound + 1)
    values = [_at(rows, k).discriminant() for k in range(start, start + bound + 1)]
    return _through_whole(values, start)


def resultant(first: Sequence[fmpz_poly], second: Sequence[fmpz_poly]) -> fmpz_poly:
    """The resultant by u of two such sums of degrees m and n in u: a form of degree n in the rows of the first and m in
    those of the second.

    >>> resultant([fmpz_poly([0, 1]), fmpz_poly([1])], [fmpz_poly([-2]), fmpz_poly([]), fmpz_poly([1])])
    x^2 + (-2)
    """
    m, n = len(first) - 1, len(second) - 1
    bound = n * max(row.degree() for row in first) + m * max(row.degree() for row in second)
    start = _start(first[-1] * second[-1], bound + 1)
    values = [_at(first, k).resultant(_at(second, k)) for k in range(start, start + bound + 1)]
    return _through_whole(values, start)


def _at(rows: Sequence[fmpz_poly], k: int) -> fmpz_poly:
    return fmpz_poly([row(k) for row in rows])


def _through_whole(values: Sequence[fmpz], start: int) -> fmpz_poly:
    """The polynomial with these values from a whole number on."""
    return through([mpz(int(value)) for value in values])(fmpz_poly([-start, 1]))


def _start(leading: fmpz_poly, count: int) -> int:
    """The first of so many successive whole numbers at which a polynomial does not vanish, not far from 0."""
    start = k = -(count // 2)
    while k < start + count:
        if leading(k) == 0:
            start = k + 1
        k += 1
    return start


def through(values: Sequence[mpz]) -> fmpz_poly:
    """The polynomial with these values at 0, 1, 2, …, of a degree below their number, with whole coefficients: by
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
    # Horner's rule in x, x − 1, …, everything over the factorial of the last step, which divides out again
    total, scale = fmpz_poly([]), mpz(1)
    for k in range(len(values) - 1, -1, -1):
        total = total * fmpz_poly([-k, 1]) + fmpz_poly([fmpz(int(differences[k] * scale))])
        scale *= max(k, 1)
    return total // fmpz(int(factorial))
