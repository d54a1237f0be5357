"""Limits on files from outside, which are refused beyond them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from exactspline.numbers.exact import mpq


@dataclass(frozen=True)
class Limits:
    """Bounds on a file; raise them by `read(…, limits=Limits(megabytes=200))`.

    `digits` bounds the characters of one number, `exponent` its power of ten, `depth` how deep brackets and elements
    may be nested, `objects` how many entities, points and numbers a file may hold, `work` the cost of turning one curve
    into Bézier segments (see `work`; 10⁸ is about two seconds).
    """

    megabytes: int = 32
    digits: int = 1_200
    exponent: int = 400
    depth: int = 60
    degree: int = 100
    objects: int = 2_000_000
    work: int = 50_000_000


def work(degree: int, knots: Sequence[mpq], numbers: int) -> int:
    """An estimate of the cost of turning a spline into Bézier segments: the knots to be inserted, times the fourth
    power of the order, times the length of the numbers in words.

    >>> work(3, [mpq(t) for t in (0, 0, 0, 0, 1, 1, 1, 1)], 53)
    1
    """
    if len(knots) < 2 * degree + 2:
        return 1
    inner = knots[degree : len(knots) - degree]
    missing = sum(max(degree - len(list(same)), 0) for _, same in groupby(inner[1:-1]))
    missing += sum(max(degree + 1 - sum(t == end for t in knots), 0) for end in (inner[0], inner[-1]))
    return max(missing * (degree + 1) ** 4 * max(numbers, 53) // 53, 1)
