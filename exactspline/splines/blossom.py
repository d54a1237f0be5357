"""From control points to Bézier points of a span, and back."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from exactspline.exact import mpq
from exactspline.splines.bernstein import blossom


def of_span(t: Sequence[mpq], n: int, d: Sequence[mpq], j: int) -> list[mpq]:
    """Bézier points over the span [t_j, t_{j+1}] of the spline of degree n with knots t and control points d.

    Two triangles of knot insertion: first the knots left of the span become its left end, then those right of it its
    right end.
    """
    a, b = t[j], t[j + 1]
    e = list(d[j - n : j + 1])
    left = [e[-1]]
    for r in range(n):
        indices = range(j - n + r + 1, j + 1)
        weights = [(a - t[i]) / (t[i + n - r] - t[i]) for i in indices]
        e = [(1 - x) * p + x * q for x, p, q in zip(weights, e, e[1:], strict=False)]
        left.append(e[-1])
    g = left[::-1]
    points = [g[0]]
    for s in range(n):
        weights = [(b - a) / (t[j + k - s] - a) for k in range(s + 1, n + 1)]
        g = [(1 - x) * p + x * q for x, p, q in zip(weights, g, g[1:], strict=False)]
        points.append(g[0])
    return points


def to_control_points(
    t: Sequence[mpq], n: int, breaks: Sequence[mpq], segments: Sequence[Sequence[mpq]]
) -> tuple[mpq, ...]:
    """Control points over clamped knots t, each the blossom of a segment at the n knots that follow.

    Any segment inside the support will do; the one with most of those knots at its ends is the cheapest.
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
