"""Checks a certificate of the zeros of a spline, with only the standard library and in two ways: Descartes' rule on
every leaf, by de Casteljau's algorithm on integers, and the number of zeros of every segment by a Sturm sequence.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, gcd, lcm
from typing import Any, TypeVar

from exactspline.certificates.numbers import count, each, fraction, integer, optional, read, require, truth

#: A zero: bounds, a polynomial with this zero, its multiplicity, and the signs on both sides.
Zero = tuple[Fraction, Fraction, list[int], int, tuple[int, int]]
#: The form of the proof of the zeros of one form, and of the certificate of the zeros of a spline.
ISOLATION = {"factors": [([integer], count)], "points": [fraction], "leaves": [(fraction, fraction, count)]}
SIDES = optional(count), optional(count)
SPLINE = {
    "periodic": truth,
    "degree": count,
    "breakpoints": [fraction],
    "segments": [{"coefficients": [integer], **ISOLATION}],
    "roots": [{"low": fraction, "high": fraction, "multiplicities": SIDES, "signs": SIDES}],
    "jumps": [{"at": fraction, "signs": SIDES}],
    "intervals": [(fraction, fraction)],
}
#: The coefficients of a polynomial are all integers, or all fractions.
Number = TypeVar("Number", int, Fraction)


def check_zeros(certificate: Mapping[str, object], sturm: bool = True) -> dict[str, int]:
    """The numbers of roots, jumps and intervals that a certificate proves (see `exactspline.roots.zero_set`).

    With ``sturm=False`` the second check is skipped (it is slow for degrees above 100).
    """
    data = read(certificate, SPLINE)
    n, breaks = data["degree"], data["breakpoints"]
    require(
        all(a < b for a, b in pairwise(breaks)) and len(breaks) == len(data["segments"]) + 1 > 1,
        "breakpoints do not fit the segments",
    )

    def checked(segment: Mapping[str, Any]) -> Any:
        c = segment["coefficients"]
        # a form that vanishes on every curve may have a negative degree, and then no coefficients
        require(len(c) == max(n + 1, 0), "wrong number of coefficients")
        return _segment(c, segment, sturm) if any(c) else None

    roots, jumps, intervals = _whole(breaks, each("segments", checked, data["segments"]), data["periodic"])
    require(len(data["roots"]) == len(roots), f"{len(roots)} roots proved, another number claimed")
    for i, (claim, (low, high, where, facts)) in enumerate(zip(data["roots"], roots, strict=True)):
        a, b = claim["low"], claim["high"]
        # at an end of its leaf the polynomial may have another zero
        within = low <= a < b <= high or low < a == b < high or low == a == b == high
        require(within and (where is None or _inside(where, a, b)), f"no root in the interval of root {i}")
        require((claim["multiplicities"], claim["signs"]) == facts, f"wrong multiplicity or sign of root {i}")
    require([(jump["at"], jump["signs"]) for jump in data["jumps"]] == jumps, "wrong jumps")
    require(data["intervals"] == intervals, "wrong intervals")
    return {"roots": len(roots), "jumps": len(jumps), "intervals": len(intervals)}


def _inside(where: tuple[list[int], Fraction, Fraction], a: Fraction, b: Fraction) -> bool:
    """Whether an odd number of zeros of the polynomial is in the open interval (a, b), or the point a = b is one."""
    g, start, width = where
    values = restricted(g, (a - start) / width, (b - start) / width)
    return values[0] == 0 if a == b else _changes(values) % 2 == 1


def _whole(breaks: list[Fraction], parts: list[Any], periodic: bool) -> tuple[list[Any], list[Any], list[Any]]:
    """Roots (with the data to test an interval), jumps and intervals, from the results for the segments."""
    roots, jumps, runs, segments = list[Any](), list[Any](), list[list[int]](), len(parts)
    for i in range(segments + (not periodic)):
        left = None if i == 0 and not periodic else (parts[i - 1][1] if parts[i - 1] else (None, 0))
        right = None if i == segments else (parts[i][0] if parts[i] else (None, 0))
        if all(side[0] for side in (left, right) if side):
            facts = (left and left[0], right and right[0]), (left and left[1], right and right[1])
            roots.append((breaks[i], breaks[i], None, facts))
        elif (
            left and right and ((left[0] == 0) != (right[0] == 0) or (left[0] == right[0] == 0 and left[1] != right[1]))
        ):
            jumps.append((breaks[i], (left[1], right[1])))
        if i < segments and parts[i]:
            low, width = breaks[i], breaks[i + 1] - breaks[i]
            for a, b, g, multiplicity, signs in parts[i][2]:
                roots.append((low + width * a, low + width * b, (g, low, width), ((multiplicity,) * 2, signs)))
        elif i < segments:
            runs = [*runs[:-1], [runs[-1][0], i + 1]] if runs and runs[-1][1] == i else [*runs, [i, i + 1]]
    if periodic and len(runs) > 1 and runs[0][0] == 0 and runs[-1][1] == segments:
        runs[-1][1] += runs.pop(0)[1]
    return roots, jumps, [(breaks[a], breaks[b] if b <= segments else breaks[b - segments]) for a, b in runs]


def _segment(
    c: list[int], segment: Mapping[str, Any], sturm: bool
) -> tuple[tuple[int, int], tuple[int, int], list[Any]]:
    """The multiplicity and sign at both ends, and the zeros inside: low, high, a polynomial with this zero,
    multiplicity, signs.
    """
    start, end = (next(i for i, x in enumerate(d) if x) for d in (c, c[::-1]))
    inner = c[start : len(c) - end]
    factors = segment["factors"] or [(inner, 1)]
    # a factor that vanishes or has a power ≤ 0 could add false zeros, or hide zeros of the form
    require(all(k > 0 for _, k in factors), "a factor whose power is not positive")
    require(
        factors == [(inner, 1)]
        or (all(len(g) > 1 for g, _ in factors) and sum(k * (len(g) - 1) for g, k in factors) < len(inner)),
        "factors of degree 0, or of too high a degree together",
    )
    product, searched = [1], [1]
    for g, k in factors:
        searched = product_of(searched, g)
        for _ in range(k):
            product = product_of(product, g)
    while len(product) < len(inner):
        product = product_of(product, [1, 1])
    require(
        len(product) == len(inner)
        and product[0] != 0
        and all(x * product[0] == y * inner[0] for x, y in zip(inner, product, strict=True)),
        "the factors do not multiply to the form",
    )
    points, leaves = set(segment["points"]), segment["leaves"]
    require(all(a < b for a, b, _ in leaves), "a leaf that is empty or reversed")
    require([a for a, _, _ in leaves] + [1] == [0] + [b for _, b, _ in leaves], "the leaves do not cover the segment")
    require(points <= {a for a, _, _ in leaves if a}, "a point is not between two leaves")
    zeros = []
    for a, b, changes in leaves:
        values, local = restricted(searched, a, b), restricted(inner, a, b)
        require(_changes(values) == changes <= 1, "wrong number of sign changes on a leaf")
        require(a == 0 or (values[0] == 0) == (a in points), "a zero between two leaves that is not a point, or none")
        if a in points:
            order = next(i for i, x in enumerate(local) if x)
            zeros.append((a, a, inner, order, (_end_signs(restricted(inner, Fraction(0), a))[1], _end_signs(local)[0])))
        if changes:
            g, k = next((g, k) for g, k in factors if _changes(restricted(g, a, b)) % 2)
            zeros.append((a, b, g, k, _end_signs(local)))
    require(not sturm or sturm_count(inner) == len(zeros), "the Sturm sequence counts other zeros")
    return (start, _end_signs(inner)[0]), (end, _end_signs(inner)[1]), zeros


def product_of(p: Sequence[Number], q: Sequence[Number]) -> list[Number]:
    """The product of two nonempty polynomials.

    >>> product_of([1, 1], [1, -1])
    [1, 0, -1]
    """
    found = [p[0] * q[0] * 0] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            found[i + j] += x * y
    return found


def isolated_zeros(c: list[int], proof: Mapping[str, object]) -> list[Zero]:
    """The zeros on [0, 1] of a form that is not zero, in ascending order, as `proof` shows (an `ISOLATION`): low, high,
    a polynomial that has the zero, multiplicity, signs.
    """
    (start, first), (end, last), inner = _segment(c, proof, False)
    zeros = [(Fraction(0), Fraction(0), [0, 1], start, (0, first))] if start else []
    return [*zeros, *inner, *([(Fraction(1), Fraction(1), [1], end, (last, 0))] if end else [])]


def restricted(c: list[int], low: Fraction, high: Fraction) -> list[int]:
    """Bernstein coefficients on [low, high], up to a positive constant, of the form with integers c."""
    n = len(c) - 1
    scale = lcm(*(comb(n, i) for i in range(n + 1)))
    return values_on([x * scale // comb(n, i) for i, x in enumerate(c)], low, high)


def values_on(b: list[int], low: Fraction, high: Fraction) -> list[int]:
    """Bernstein coefficients on [low, high], up to a positive constant, from those on [0, 1].

    >>> values_on([-1, 1], Fraction(1, 2), Fraction(1))
    [0, 2]
    """
    right = halves_at(b, low)[1] if low else b
    return halves_at(right, (high - low) / (1 - low))[0] if high < 1 else right


def halves_at(b: list[int], t: Fraction) -> tuple[list[int], list[int]]:
    """Bernstein coefficients before and behind t, up to a positive constant, by de Casteljau's algorithm.

    >>> halves_at([-1, 1], Fraction(1, 4))
    ([-4, -2], [-2, 4])
    """
    p, q, n = t.numerator, t.denominator, len(b) - 1
    left, right = [], []
    for i in range(n + 1):
        left.append(b[0] * q ** (n - i))
        right.append(b[-1] * q ** (n - i))
        b = [(q - p) * x + p * y for x, y in pairwise(b)]
    return left, right[::-1]


def _end_signs(values: list[int]) -> tuple[int, int]:
    signs = [1 if x > 0 else -1 for x in values if x]
    return signs[0], signs[-1]


def _changes(values: list[int]) -> int:
    return sum(a != b for a, b in pairwise(x > 0 for x in values if x))


def sturm_count(c: list[int]) -> int:
    """The number of distinct positive zeros of ``Σ c_i zⁱ``, by a Sturm sequence of primitive remainders.

    >>> sturm_count([2, -3, 1])  # (z − 1)(z − 2)
    2
    """
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
