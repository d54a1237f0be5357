"""From control points to Bézier points of a span, and back; the forms of all components of a curve together."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import accumulate
from math import comb

from flint import fmpq, fmpz, fmpz_mat, fmpz_poly

from exactspline.numbers.exact import common_multiple, mpq, over_one_denominator, to_fmpq
from exactspline.polynomials.bernstein import ONE, Form, blossom, over_common_denominator, primitive

#: Numbers over one denominator.
Row = tuple[list[fmpz], fmpz]


def forms_of(t: Sequence[mpq], n: int, d: Sequence[mpq], spans: Sequence[int]) -> Iterator[Form]:
    """The forms over the spans [t_j, t_{j+1}] of the spline of degree n with knots t and control points d.

    Knots are inserted until each has multiplicity n, from left to right: the points that remain beyond the right end of
    one span are those with which the next span begins. The numbers of a span are integers over one denominator, and
    their common factor is divided out once per span.
    """
    knots, control_points = list(map(to_fmpq, t)), list(map(to_fmpq, d))
    row = _over_one(_at_left_end(knots, n, control_points, spans[0]))
    binomials = [fmpz(comb(n, i)) for i in range(n + 1)]
    for j, following in zip(spans, [*spans[1:], None], strict=True):
        widths, _ = _over_one([x - knots[j] for x in knots[j + 1 : j + n + 1]])
        points, ends, bottom = _inserted(row, widths)
        yield primitive((fmpz_poly([x * y for x, y in zip(points, binomials, strict=True)]), bottom))
        if following is not None:
            row = _next_row([control_points[following - r] for r in range(min(following - j, n + 1))], ends, bottom)


def _at_left_end(t: Sequence[fmpq], n: int, d: Sequence[fmpq], j: int) -> list[fmpq]:
    """The control points of the span [t_j, t_{j+1}] after its left end was inserted until it has multiplicity n."""
    a, e = t[j], list(d[j - n : j + 1])
    left = [e[-1]]
    for r in range(n):
        weights = [(a - t[i]) / (t[i + n - r] - t[i]) for i in range(j - n + r + 1, j + 1)]
        e = [(1 - x) * p + x * q for x, p, q in zip(weights, e, e[1:], strict=False)]
        left.append(e[-1])
    return left[::-1]


def _inserted(row: Row, widths: list[fmpz]) -> tuple[list[fmpz], list[fmpz], fmpz]:
    """The Bézier points of a span, and the points to the right of it, after its right end was inserted n times; over
    one denominator. `widths` are the distances of the knots that follow from the left end, in any unit.
    """
    g, bottom = row
    unit = fmpz_poly(widths).content()
    widths = [w // unit for w in widths]
    common = list(accumulate(widths, fmpz.lcm))
    points, ends = [g[0]], [g[-1]]
    for k in range(len(widths), 0, -1):
        factors = [common[k - 1] // w for w in widths[:k]]
        g = [
            p * ((w - widths[0]) * f) + q * (widths[0] * f)
            for w, f, p, q in zip(widths, factors, g, g[1:], strict=False)
        ]
        points.append(g[0])
        ends.append(g[-1])
    lift = ONE
    for s, by in zip(range(len(widths), -1, -1), [*common, ONE], strict=True):
        points[s], ends[s], lift = points[s] * lift, ends[s] * lift, lift * by
    return points, ends, bottom * lift


def _next_row(own: list[fmpq], ends: list[fmpz], bottom: fmpz) -> Row:
    """The start of the next span: as many of its control points as the multiplicity of its left end, then the points
    that remain from the previous span.
    """
    mine, below = _over_one(own)
    common = bottom.lcm(below)
    kept = ends[: max(len(ends) - len(mine), 0)]
    joined = [x * (common // below) for x in mine] + [x * (common // bottom) for x in kept]
    polynomial, least = primitive((fmpz_poly(joined[::-1]), common))
    return [polynomial[i] for i in range(len(joined))], least


def _over_one(values: Sequence[fmpq]) -> Row:
    below = [x.q for x in values]
    bottom = common_multiple(below)
    if bottom == 1:
        return [x.p for x in values], bottom
    return [x.p * (bottom // m) for x, m in zip(values, below, strict=True)], bottom


def to_control_points(
    t: Sequence[mpq], n: int, breaks: Sequence[mpq], segments: Sequence[Sequence[mpq]]
) -> tuple[mpq, ...]:
    """Control points over clamped knots t, each the blossom of a segment at the n knots that follow.

    Any segment inside the support is possible; the one with most of those knots at its ends is the cheapest.
    """
    points = []
    for i in range(len(t) - n - 1):
        inner = t[i + 1 : i + n + 1]
        segment = _cheapest(breaks, t[i], t[i + n + 1], inner)
        a, b = breaks[segment], breaks[segment + 1]
        points.append(blossom(segments[segment], [(s - a) / (b - a) for s in inner]))
    return tuple(points)


def _cheapest(breaks: Sequence[mpq], low: mpq, high: mpq, inner: Sequence[mpq]) -> int:
    first = bisect_right(breaks, low) - 1
    best, best_count = first, -1
    for segment in range(first, len(breaks) - 1):
        if breaks[segment] >= high:
            break
        count = inner.count(breaks[segment]) + inner.count(breaks[segment + 1])
        if count > best_count:
            best, best_count = segment, count
    return best


#: The knots that affect a span, scaled such that its left end is 0 and its right end is 1.
Pattern = tuple[mpq, ...]
#: A matrix is computed for a pattern that occurred this many times its degree, and for at most this many patterns.
PATTERNS = 4096
#: Above this degree there are no matrices.
MOST = 12

_met: Counter[tuple[int, Pattern]] = Counter()


def common_forms(
    t: Sequence[mpq], n: int, columns: Sequence[Sequence[mpq]], spans: Sequence[int]
) -> list[tuple[list[fmpz_poly], fmpz]] | None:
    """The forms over the spans [t_j, t_{j+1}] of the splines of degree n with knots t and columns of control points,
    one after the other, over their least common denominator. None where the knots around spans differ so much that a
    matrix for each is not worthwhile.

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
        numbers, least = over_one_denominator([x for row in rows[j - n : j + 1] for x in row])
        matrix, bottom = _matrix(n, pattern)
        product = fmpz_poly((matrix * fmpz_mat(n + 1, len(columns), numbers)).entries())
        whole, below = primitive((product, fmpz(least) * bottom))
        products = whole.coeffs()
        found.append(([fmpz_poly(products[k :: len(columns)]) for k in range(len(columns))], below))
    return found


def _pattern(t: Sequence[mpq], n: int, j: int) -> Pattern:
    a, h = t[j], t[j + 1] - t[j]
    near = t[j - n + 1 : j + n + 1]
    if h == 1:
        return tuple([x - a for x in near])
    return tuple([(x - a) / h for x in near])


def _worth_it(n: int, patterns: Sequence[Pattern]) -> bool:
    """Whether there are matrices for all patterns; if not, their occurrences are counted."""
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
    columns: list[Form] = []
    for k in range(n + 1):
        ((form, below),) = forms_of(t, n, [mpq(i == k) for i in range(n + 1)], [n])
        columns.append((form, below))
    polynomials, common = over_common_denominator(columns)
    return fmpz_mat([[c[i] for c in polynomials] for i in range(n + 1)]), common
