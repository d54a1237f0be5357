"""The conversion of control points to Bézier points of a span, and back; the forms of all components of a curve
together.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import accumulate
from math import comb, gcd
from operator import mul
from typing import TypeVar

from flint import fmpq, fmpq_poly, fmpz, fmpz_poly

from exactspline.numbers.exact import common_multiple, mpq, over_one_denominator, to_fmpq
from exactspline.polynomials.bernstein import ONE, Form, blossom, over_common_denominator, without_content

#: Numbers over a common denominator.
Row = tuple[list[fmpz], fmpz]
#: Control points: numbers, or linear combinations of unknown control points, the k-th of which is written x^k.
Q = TypeVar("Q", fmpq, fmpq_poly)
Z = TypeVar("Z", fmpz, fmpz_poly)


def forms_of(t: Sequence[mpq], n: int, d: Sequence[mpq | int], spans: Sequence[int]) -> Iterator[Form]:
    """The forms over the spans [t_j, t_{j+1}] of the spline of degree n with knots t and control points d.

    Knots are inserted until each has multiplicity n, from left to right: the points that remain beyond the right end of
    one span are those with which the next span begins. The numbers of a span are integers over a common denominator,
    and their common factor is divided out once per span.
    """
    knots, control_points = list(map(to_fmpq, t)), list(map(to_fmpq, d))
    row = _over_one(_at_left_end(knots, n, control_points, spans[0]))
    binomials = [fmpz(comb(n, i)) for i in range(n + 1)]
    for j, following in zip(spans, [*spans[1:], None], strict=True):
        widths, _ = _over_one([x - knots[j] for x in knots[j + 1 : j + n + 1]])
        points, ends, bottom = _inserted(row, widths)
        yield without_content((fmpz_poly([x * y for x, y in zip(points, binomials, strict=True)]), bottom))
        if following is not None:
            row = _next_row([control_points[following - r] for r in range(min(following - j, n + 1))], ends, bottom)


def _at_left_end(t: Sequence[fmpq], n: int, d: Sequence[Q], j: int) -> list[Q]:
    """The control points of the span [t_j, t_{j+1}] after its left end has been inserted up to multiplicity n."""
    a, e = t[j], list(d[j - n : j + 1])
    left = [e[-1]]
    for r in range(n):
        weights = [(a - t[i]) / (t[i + n - r] - t[i]) for i in range(j - n + r + 1, j + 1)]
        e = [(1 - x) * p + x * q for x, p, q in zip(weights, e, e[1:], strict=False)]
        left.append(e[-1])
    return left[::-1]


def _inserted(row: tuple[list[Z], fmpz], widths: list[fmpz]) -> tuple[list[Z], list[Z], fmpz]:
    """The Bézier points of a span, and the points to the right of the span, after its right end has been inserted n
    times; over a common denominator. `widths` are the distances of the following knots from the left end, in any unit.
    """
    g, bottom = row
    unit = fmpz_poly(widths).content()
    widths = [w // unit for w in widths]
    multiples: list[fmpz] = list(accumulate(widths, fmpz.lcm))
    points, ends = [g[0]], [g[-1]]
    for k in range(len(widths), 0, -1):
        factors = [multiples[k - 1] // w for w in widths[:k]]
        g = [
            p * ((w - widths[0]) * f) + q * (widths[0] * f)
            for w, f, p, q in zip(widths, factors, g, g[1:], strict=False)
        ]
        points.append(g[0])
        ends.append(g[-1])
    lift = ONE
    for s, by in zip(range(len(widths), -1, -1), [*multiples, ONE], strict=True):
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
    polynomial, least = without_content((fmpz_poly(joined[::-1]), common))
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
    """Control points over knots t, each the blossom of a segment at the n knots that follow.

    Any segment inside the support is possible; the segment with most of these knots at its ends is the cheapest.
    """
    points = []
    for i in range(len(t) - n - 1):
        inner = t[i + 1 : i + n + 1]
        segment = _cheapest(breaks, t[i], t[i + n + 1], inner)
        a, b = breaks[segment], breaks[segment + 1]
        points.append(blossom(segments[segment], [(s - a) / (b - a) for s in inner]))
    return tuple(points)


def _cheapest(breaks: Sequence[mpq], low: mpq, high: mpq, inner: Sequence[mpq]) -> int:
    first = min(max(bisect_right(breaks, low) - 1, 0), len(breaks) - 2)
    below = range(first, bisect_left(breaks, high, first, len(breaks) - 1))
    return max(below, key=lambda i: inner.count(breaks[i]) + inner.count(breaks[i + 1]), default=first)


#: The knots that affect a span as coprime integers, moved such that its left end is 0. (Integers are hashed faster than
#: fractions.)
Pattern = tuple[int, ...]
#: The weights of a pattern: for each coefficient the first control point of the span that contributes to it, and the
#: integers by which this and the following points are multiplied; the same for Bézier points; a denominator; and all
#: integers for C, none if one is too large.
Weights = tuple[list[tuple[int, tuple[int, ...]]], tuple[int, ...] | None, int, bytes]
#: The weights are computed for a pattern that occurred more often than a quarter of its degree, and for about this many
#: patterns.
PATTERNS = 4096
#: Above this degree no weights are computed.
MOST = 12
#: This many segments are computed over one denominator before each is brought to lowest terms.
TOGETHER = 16

_met: Counter[tuple[int, Pattern]] = Counter()
_weights: dict[tuple[int, Pattern], Weights] = {}
#: The weights along this many short knot vectors, by degree and knots.
ALONG = 64
_along: dict[tuple[int, tuple[mpq, ...]], list[Weights]] = {}


#: The integers of the forms of a segment, one list for every component, and their denominator.
CommonRows = tuple[Sequence[Sequence[int]], int]


def common_rows(
    t: Sequence[mpq], n: int, columns: Sequence[Sequence[mpq | int]], spans: Sequence[int]
) -> list[CommonRows]:
    """The integers of the forms over the spans [t_j, t_{j+1}] of the splines of degree n with knots t and columns of
    control points, one after the other, over their least common denominator.

    >>> from exactspline.numbers.exact import mpq
    >>> common_rows([mpq(k) for k in range(4)], 1, [[mpq(1, 2), mpq(1)], [mpq(0), mpq(2)]], [1])
    [(((1, 2), (0, 4)), 2)]
    """
    weights = _weights_along(t, n, spans) if 0 < n <= MOST else None
    if weights is None:
        each = [over_common_denominator(own) for own in zip(*[forms_of(t, n, x, spans) for x in columns], strict=True)]
        return [(tuple([tuple([int(c[k]) for k in range(n + 1)]) for c in own]), int(below)) for own, below in each]
    found: list[CommonRows] = []
    for start in range(0, len(spans), TOGETHER):
        some = spans[start : start + TOGETHER]
        first, stop = some[0] - n, some[-1] + 1
        numbers, least = over_one_denominator([x for column in columns for x in column[first:stop]])
        offsets = range(0, len(numbers), stop - first)
        for j, (rows, diagonal, bottom, _) in zip(some, weights[start : start + TOGETHER], strict=True):
            at = j - n - first
            own = [numbers[at + k : at + k + n + 1] for k in offsets]
            if diagonal:
                parts = tuple([tuple(map(mul, diagonal, points)) for points in own])
            else:
                parts = tuple([tuple([sum(map(mul, row, points[k:])) for k, row in rows]) for points in own])
            below = least * bottom
            if below != 1:
                shared = gcd(below, *[x for part in parts for x in part])
                if shared != 1:
                    parts = tuple([tuple([x // shared for x in part]) for part in parts])
                    below //= shared
            found.append((parts, below))
    return found


def packed_weights(t: Sequence[mpq], n: int, spans: Sequence[int]) -> tuple[bytes, list[int]]:
    """The weights of the spans [t_j, t_{j+1}] for C, and their denominators; no weights if they are too large for C, or
    not worthwhile (see `common_rows`).
    """
    weights = (_weights_along(t, n, spans) if 0 < n <= MOST else None) or []
    packed = [own[-1] for own in weights]
    return b"".join(packed) if all(packed) else b"", [own[2] for own in weights]


def _weights_along(t: Sequence[mpq], n: int, spans: Sequence[int]) -> list[Weights] | None:
    if len(spans) > TOGETHER:
        return _weights_of([*_patterns(t, n, spans)])
    key = n, tuple(t)
    found = _along.get(key) or _weights_of([*_patterns(t, n, spans)])
    if found is not None:
        if len(_along) >= ALONG:
            _along.clear()
        _along[key] = found
    return found


def _patterns(t: Sequence[mpq], n: int, spans: Sequence[int]) -> Iterator[tuple[int, Pattern]]:
    """The degree and the pattern of every span."""
    for start in range(0, len(spans), TOGETHER):
        some = spans[start : start + TOGETHER]
        first = some[0] - n + 1
        numbers, _ = over_one_denominator(t[first : some[-1] + n + 1])
        for j in some:
            near = numbers[j - n + 1 - first : j + n + 1 - first]
            left = near[n - 1]
            moved = [x - left for x in near]
            unit = gcd(*moved)
            yield n, tuple(moved if unit == 1 else [x // unit for x in moved])


def _weights_of(keys: Sequence[tuple[int, Pattern]]) -> list[Weights] | None:
    """The weights of patterns; None if unknown patterns have occurred too rarely, in which case their occurrences are
    counted.
    """
    made = {key: known for key in keys if (known := _weights.get(key))}
    new = [key for key in dict.fromkeys(keys) if key not in made]
    if new:
        if len(_met) > PATTERNS:
            _met.clear()
            _weights.clear()
        _met.update(keys)
        # the weights of a pattern cost about as much as the forms of (degree + 1)/4 spans
        if sum(n + 1 for n, _ in new) > 4 * len(keys) and not all(4 * _met[key] > key[0] for key in new):
            return None
        made.update((key, _weights_for(*key)) for key in new)
        _weights.update(made)
    return [made[key] for key in keys]


def _weights_for(n: int, pattern: Pattern) -> Weights:
    """The weights of a pattern, with which the control points enter into the form."""
    t = [fmpq(x, pattern[n]) for x in (pattern[0], *pattern, pattern[-1])]
    points = _at_left_end(t, n, [fmpq_poly([0] * k + [1]) for k in range(n + 1)], n)
    row = over_common_denominator([(point.numer(), point.denom()) for point in points])
    inserted, _, bottom = _inserted(row, _over_one([x - t[n] for x in t[n + 1 : 2 * n + 1]])[0])
    parts = [[comb(n, i) * int(inserted[i][k]) for k in range(n + 1)] for i in range(n + 1)]
    shared = gcd(int(bottom), *[x for part in parts for x in part])
    rows = [_trimmed([x // shared for x in part]) for part in parts]
    by_points = all(len(row) == 1 for _, row in rows)
    whole = [x // shared for part in parts for x in part]
    packed = array("Q", whole).tobytes() if max(whole) < 1 << 64 else b""
    return rows, tuple([row[0] for _, row in rows]) if by_points else None, int(bottom) // shared, packed


def _trimmed(row: list[int]) -> tuple[int, tuple[int, ...]]:
    """The index of the first number that is not 0, and the numbers from there to the last."""
    places = [k for k, x in enumerate(row) if x]
    return places[0], tuple(row[places[0] : places[-1] + 1])


# ---- knots of given smoothness


def with_smooth_knots(
    degree: int,
    breaks: Sequence[mpq],
    pieces: Sequence[Sequence[Sequence[mpq]]],
    multiplicities: Sequence[int],
    *,
    periodic: bool = False,
) -> tuple[list[mpq], list[tuple[mpq, ...]]]:
    """Knots and control points of the curve whose pieces have these Bézier points. A breakpoint of multiplicity m (the
    first one is the seam) is a knot of class C^(degree − m), whether or not the pieces agree there: each control point
    is computed from one piece. A periodic spline has the knots of the neighbouring periods beyond its ends.

    >>> line, square = [(mpq(0),), (mpq(1, 2),), (mpq(1),)], [(mpq(1),), (mpq(3, 2),), (mpq(5),)]
    >>> with_smooth_knots(2, [mpq(0), mpq(1), mpq(2)], [line, square], [1, 1])[1]
    [(mpq(0,1),), (mpq(1,2),), (mpq(3,2),), (mpq(5,1),)]
    """
    width, around = breaks[-1] - breaks[0], (degree // len(pieces) + 1) * periodic
    periods = range(-around, around + 1)
    ends = [t + i * width for i in periods for t in breaks[:-1]] + [breaks[-1] + around * width]
    counts = [*multiplicities] * len(periods) + [multiplicities[0]]
    knots = [t for t, count in zip(ends, counts, strict=True) for _ in range(count)]
    if periodic:
        knots = knots[bisect_right(knots, breaks[0]) - 1 - degree : bisect_left(knots, breaks[-1]) + degree + 1]
    else:
        full = degree + 1 - multiplicities[0]
        knots = [breaks[0]] * full + knots + [breaks[-1]] * full
    columns = zip(*[zip(*piece, strict=True) for piece in pieces], strict=True)
    points = [to_control_points(knots, degree, ends, column * len(periods)) for column in columns]
    return knots, list(zip(*points, strict=True))
