"""The forms of all components of a curve together: on a span they are the control points that count there times a
matrix that depends on the knots around it alone, up to an affine map of the parameter.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import lru_cache, reduce

from flint import fmpz, fmpz_mat, fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.polynomials.bernstein import ONE
from exactspline.splines.blossom import forms_of

#: The knots that count on a span, from 0 at its left end to 1 at its right end.
Pattern = tuple[mpq, ...]
#: A matrix is made for a pattern that was met this many times as its degree, and for this many patterns.
PATTERNS = 4096
#: Above this degree there are no matrices.
MOST = 12

_met: Counter[tuple[int, Pattern]] = Counter()


def common_forms(
    t: Sequence[mpq], n: int, columns: Sequence[Sequence[mpq]], spans: Sequence[int]
) -> list[tuple[list[fmpz_poly], fmpz]] | None:
    """The forms over the spans [t_j, t_{j+1}] of the splines of degree n with knots t and columns of control points,
    one after the other, over their least common denominator. None where knots around spans differ so much that it is
    not worth a matrix each.

    >>> from exactspline.numbers.exact import mpq
    >>> for _ in range(4):
    ...     found = common_forms([mpq(k) for k in range(4)], 1, [[mpq(1, 2), mpq(1)], [mpq(0), mpq(2)]], [1])
    >>> found
    [([2*x + 1, 4*x], 2)]
    """
    if not 0 < n <= MOST:
        return None
    patterns = [_pattern(t, n, j) for j in spans]
    if not _worth_it(n, patterns):
        return None
    rows = list(zip(*columns, strict=True))
    found = []
    for j, pattern in zip(spans, patterns, strict=True):
        numbers, below = _over_one([x for row in rows[j - n : j + 1] for x in row])
        matrix, bottom = _matrix(n, pattern)
        products = (matrix * fmpz_mat(n + 1, len(columns), numbers)).entries()
        below = below * bottom
        common = fmpz_poly(products).content().gcd(below)
        if common != 1:
            products, below = [x // common for x in products], below // common
        found.append(([fmpz_poly(products[k :: len(columns)]) for k in range(len(columns))], below))
    return found


def _pattern(t: Sequence[mpq], n: int, j: int) -> Pattern:
    a, h = t[j], t[j + 1] - t[j]
    near = t[j - n + 1 : j + n + 1]
    if h == 1:
        return tuple([x - a for x in near])
    return tuple([(x - a) / h for x in near])


def _worth_it(n: int, patterns: Sequence[Pattern]) -> bool:
    """Whether there are matrices for all patterns; if not, these have been met once more."""
    if all(_met[n, pattern] > n for pattern in patterns):
        return True
    if len(_met) > PATTERNS:
        _met.clear()
    _met.update((n, pattern) for pattern in patterns)
    return all(_met[n, pattern] > n for pattern in patterns)


@lru_cache(PATTERNS)
def _matrix(n: int, pattern: Pattern) -> tuple[fmpz_mat, fmpz]:
    """The matrix of a pattern over a denominator: its columns are the forms of the control points 0, …, 1, …, 0."""
    t = [pattern[0], *pattern, pattern[-1]]
    columns = []
    for k in range(n + 1):
        ((form, below),) = forms_of(t, n, [mpq(i == k) for i in range(n + 1)], [n])
        columns.append(([form[i] for i in range(n + 1)], below))
    common = reduce(fmpz.lcm, [below for _, below in columns], ONE)
    rows = [[column[i] * (common // below) for column, below in columns] for i in range(n + 1)]
    return fmpz_mat(rows), common


def _over_one(values: Sequence[mpq]) -> tuple[list[int], fmpz]:
    below = {x.denominator for x in values}
    if below == {1}:
        return [int(x.numerator) for x in values], ONE
    common = reduce(fmpz.lcm, [fmpz(int(m)) for m in below], ONE)
    whole = int(common)
    return [int(x.numerator) * (whole // int(x.denominator)) for x in values], common
