"""Checks a certificate of a zero set without anything of exactspline: standard library only, its own arithmetic, two
routes.

Descartes' rule on every leaf, by de Casteljau's algorithm on integers, then the number of zeros of every segment again
by a Sturm sequence."""

from fractions import Fraction
from itertools import pairwise
from math import comb, gcd, lcm
from typing import Any


def check(certificate: dict[str, object], sturm: bool = True) -> dict[str, int]:
    """Number of roots, jumps and intervals that the certificate proves; any exception means that it proves nothing, and
    a ValueError names the flaw.

    With `sturm` false the second route is skipped (it is slow for degrees beyond 100).
    """
    told: Any = certificate
    _require(told["format"] == "exactspline zeros 1", "unknown format")
    n, breaks = told["degree"], [Fraction(t) for t in told["breakpoints"]]
    _require(
        all(a < b for a, b in pairwise(breaks)) and len(breaks) == len(told["segments"]) + 1,
        "breakpoints do not fit the segments",
    )
    parts = []
    for segment in told["segments"]:
        c = [int(x) for x in segment["coefficients"]]
        _require(len(c) == n + 1, "wrong number of coefficients")
        parts.append(_segment(c, segment, sturm) if any(c) else None)
    roots, jumps, intervals = _whole(breaks, parts, told["periodic"])
    _require(len(told["roots"]) == len(roots), f"{len(roots)} roots proved, another number claimed")
    for claim, (low, high, where, facts) in zip(told["roots"], roots, strict=True):
        a, b = Fraction(claim["low"]), Fraction(claim["high"])
        _require(low <= a <= b <= high and (where is None or _inside(where, a, b)), f"no root in [{a}, {b}]")
        _require(
            (tuple(claim["multiplicities"]), tuple(claim["signs"])) == facts,
            f"wrong multiplicity or sign at [{a}, {b}]",
        )
    _require([(Fraction(j["at"]), tuple(j["signs"])) for j in told["jumps"]] == jumps, "wrong jumps")
    _require([tuple(map(Fraction, s)) for s in told["intervals"]] == intervals, "wrong intervals")
    return {"roots": len(roots), "jumps": len(jumps), "intervals": len(intervals)}


def _require(condition: bool, flaw: str) -> None:
    if not condition:
        raise ValueError(flaw)


def _inside(where: tuple[list[int], Fraction, Fraction], a: Fraction, b: Fraction) -> bool:
    """Whether an odd number of zeros of the polynomial is in the open interval (a, b), or the point a = b is one."""
    g, start, width = where
    values = _restricted(g, (a - start) / width, (b - start) / width)
    return values[0] == 0 if a == b else _changes(values) % 2 == 1


def _whole(breaks: list[Fraction], parts: list[Any], periodic: bool) -> tuple[list[Any], list[Any], list[Any]]:
    """Roots (with a test of an interval), jumps and intervals, from what is known of every segment."""
    roots, jumps, runs, count = list[Any](), list[Any](), list[list[int]](), len(parts)
    for i in range(count + (not periodic)):
        left = None if i == 0 and not periodic else (parts[i - 1][1] if parts[i - 1] else (None, 0))
        right = None if i == count else (parts[i][0] if parts[i] else (None, 0))
        sides = [s for s in (left, right) if s]
        if all(m for m, _ in sides):
            facts = (left and left[0], right and right[0]), (left and left[1], right and right[1])
            roots.append((breaks[i], breaks[i], None, facts))
        elif (
            left and right and ((left[0] == 0) != (right[0] == 0) or (left[0] == right[0] == 0 and left[1] != right[1]))
        ):
            jumps.append((breaks[i], (left[1], right[1])))
        if i < count and parts[i]:
            low, width = breaks[i], breaks[i + 1] - breaks[i]
            for a, b, g, multiplicity, signs in parts[i][2]:
                roots.append((low + width * a, low + width * b, (g, low, width), ((multiplicity,) * 2, signs)))
        elif i < count:
            runs = [*runs[:-1], [runs[-1][0], i + 1]] if runs and runs[-1][1] == i else [*runs, [i, i + 1]]
    if periodic and len(runs) > 1 and runs[0][0] == 0 and runs[-1][1] == count:
        runs[-1][1] += runs.pop(0)[1]
    return roots, jumps, [(breaks[a], breaks[b] if b <= count else breaks[b - count]) for a, b in runs]


def _segment(c: list[int], segment: dict[str, Any], sturm: bool) -> tuple[tuple[int, int], tuple[int, int], list[Any]]:
    """(multiplicity, sign) at both ends, and the zeros inside: low, high, a polynomial that has the zero, multiplicity,
    signs.
    """
    start, end = (next(i for i, x in enumerate(d) if x) for d in (c, c[::-1]))
    inner = c[start : len(c) - end]
    factors = [([int(x) for x in g], k) for g, k in segment["factors"]] or [(inner, 1)]
    product, searched = [1], [1]
    for g, k in factors:
        searched = _times(searched, g)
        for _ in range(k):
            product = _times(product, g)
    while len(product) < len(inner):
        product = _times(product, [1, 1])
    _require(
        len(product) == len(inner) and all(x * product[0] == y * inner[0] for x, y in zip(inner, product, strict=True)),
        "the factors do not multiply to the form",
    )
    points = {Fraction(t) for t in segment["points"]}
    leaves = [(Fraction(a), Fraction(b), changes) for a, b, changes in segment["leaves"]]
    _require([a for a, _, _ in leaves] + [1] == [0] + [b for _, b, _ in leaves], "the leaves do not cover the segment")
    _require(points <= {a for a, _, _ in leaves if a}, "a point is not between two leaves")
    zeros = []
    for a, b, changes in leaves:
        values, own = _restricted(searched, a, b), _restricted(inner, a, b)
        _require(_changes(values) == changes <= 1, f"wrong number of sign changes on [{a}, {b}]")
        _require(a == 0 or (values[0] == 0) == (a in points), f"a zero at {a}, or none")
        if a in points:
            order = next(i for i, x in enumerate(own) if x)
            zeros.append((a, a, inner, order, (_beside(_restricted(inner, Fraction(0), a))[1], _beside(own)[0])))
        if changes:
            g, k = next((g, k) for g, k in factors if _changes(_restricted(g, a, b)) % 2)
            zeros.append((a, b, g, k, _beside(own)))
    _require(not sturm or _sturm(inner) == len(zeros), "the Sturm sequence counts other zeros")
    return (start, _beside(inner)[0]), (end, _beside(inner)[1]), zeros


def _times(p: list[int], q: list[int]) -> list[int]:
    return [
        sum(p[j] * q[i - j] for j in range(max(0, i - len(q) + 1), min(i + 1, len(p))))
        for i in range(len(p) + len(q) - 1)
    ]


def _restricted(c: list[int], low: Fraction, high: Fraction) -> list[int]:
    """Bernstein coefficients on [low, high], up to a positive constant, of the form with integers c."""
    n = len(c) - 1
    scale = lcm(*(comb(n, i) for i in range(n + 1)))
    b = [x * scale // comb(n, i) for i, x in enumerate(c)]
    right = _casteljau(b, low)[1] if low else b
    return _casteljau(right, (high - low) / (1 - low))[0] if high < 1 else right


def _casteljau(b: list[int], t: Fraction) -> tuple[list[int], list[int]]:
    p, q, n = t.numerator, t.denominator, len(b) - 1
    left, right = [], []
    for i in range(n + 1):
        left.append(b[0] * q ** (n - i))
        right.append(b[-1] * q ** (n - i))
        b = [(q - p) * x + p * y for x, y in pairwise(b)]
    return left, right[::-1]


def _beside(values: list[int]) -> tuple[int, int]:
    signs = [1 if x > 0 else -1 for x in values if x]
    return signs[0], signs[-1]


def _changes(values: list[int]) -> int:
    return sum(a != b for a, b in pairwise(x > 0 for x in values if x))


def _sturm(c: list[int]) -> int:
    """Number of distinct positive zeros of ``Σ c_i zⁱ``, by a Sturm sequence of primitive remainders."""
    chain = [c, [i * x for i, x in enumerate(c)][1:]]
    while chain[-1]:
        p, q = list(chain[-2]), chain[-1]
        while len(p) >= len(q):
            top, lead, shift = p.pop(), q[-1], len(p) + 1 - len(q)
            p = [x * abs(lead) for x in p]
            for i, x in enumerate(q[:-1]):
                p[shift + i] -= top * x * (1 if lead > 0 else -1)
        while p and not p[-1]:
            p.pop()
        chain.append([-x // gcd(*p) for x in p])
    return _changes([p[0] for p in chain[:-1]]) - _changes([p[-1] for p in chain[:-1]])
