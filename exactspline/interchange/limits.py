"""Limits on input files; a file that exceeds them is rejected."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from exactspline.numbers.exact import mpq
from exactspline.one_line import OneLine

#: What can be done about a file beyond them.
LARGER = "divide the file, or read it in Python with limits=Limits(…)"


@dataclass(frozen=True, repr=False)
class Limits(OneLine):
    """Limits on an input file; to raise them, call `read(…, limits=Limits(megabytes=200))`.

    `digits` limits the characters of one number, `exponent` its power of ten, `depth` the nesting of brackets and
    elements, `objects` the number of entities, points and numbers in a file, `work` the cost of converting one curve to
    Bézier segments (see `work`; 10⁸ is about two seconds), `seconds` the processor time of a library that reads the
    file in another process (``3dm``), for every megabyte begun.
    """

    megabytes: int = 32
    digits: int = 1_200
    exponent: int = 400
    depth: int = 60
    degree: int = 100
    objects: int = 2_000_000
    work: int = 50_000_000
    seconds: int = 2


def work(degree: int, knots: Sequence[mpq], numbers: int) -> int:
    """An estimate of the cost of converting a spline to Bézier segments: the number of knots to be inserted, times the
    fourth power of the order, times the length of the numbers in machine words.

    >>> work(3, [mpq(t) for t in (0, 0, 0, 0, 1, 1, 1, 1)], 53)
    1
    """
    if len(knots) < 2 * degree + 2:
        return 1
    inner = knots[degree : len(knots) - degree]
    missing = sum(max(degree - len(list(same)), 0) for _, same in groupby(inner[1:-1]))
    missing += sum(max(degree + 1 - sum(t == end for t in knots), 0) for end in (inner[0], inner[-1]))
    return max(missing * (degree + 1) ** 4 * max(numbers, 53) // 53, 1)
