"""Pairs of paths that nearly coincide, with a dial: small integers, and the same moved by 2⁻ᵏ."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

#: The exponents k, and the largest coordinate.
EXPONENTS, LARGEST = (4, 6, 8, 10, 12, 16, 20), 10


@dataclass(frozen=True)
class Pair:
    """A closed path of cubics with integer control points, and the same path moved by 2⁻ᵏ in x or in y.

    >>> Pair(((0, 0), (1, 2), (2, 0)), 4).second
    'M0.0625 0C1.0625 2 2.0625 0 0.0625 0Z'
    """

    points: tuple[tuple[int, int], ...]
    exponent: int
    along_y: bool = False

    @property
    def first(self) -> str:
        """The path, as path data of SVG."""
        return _closed(self.points)

    @property
    def second(self) -> str:
        """The path that is moved."""
        step = Fraction(1, 1 << self.exponent)
        return _closed([(x, y + step) if self.along_y else (x + step, y) for x, y in self.points])


def pairs(count: int, seed: int = 1) -> Iterator[Pair]:
    """This many pairs, the same for the same seed: closed paths of two to four cubics, every second moved up.

    >>> next(pairs(1)).exponent
    4
    """
    chance = random.Random(f"boolean {seed}")
    for number in range(count):
        corners = 3 * chance.randint(2, 4)
        points = tuple([(chance.randint(0, LARGEST), chance.randint(0, LARGEST)) for _ in range(corners)])
        yield Pair(points, EXPONENTS[number % len(EXPONENTS)], along_y=number % 2 == 1)


def _closed(points: Sequence[tuple[Fraction | int, Fraction | int]]) -> str:
    """Path data of the closed path with these control points."""
    texts = [" ".join(repr(float(c)).removesuffix(".0") for c in point) for point in [*points, points[0]]]
    segments = [f"C{' '.join(texts[i : i + 3])}" for i in range(1, len(texts), 3)]
    return f"M{texts[0]}{''.join(segments)}Z"
