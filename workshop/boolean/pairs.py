"""Pairs of paths that all but coincide, with a dial: small integers, and the same moved by 2⁻ᵏ."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

#: The exponents k, and the largest coordinate.
EXPONENTS, LARGEST = (4, 6, 8, 10, 12, 16, 20), 10


@dataclass(frozen=True)
class Pair:
    """Two paths, as path data, and the dial."""

    first: str
    second: str
    exponent: int


def pairs(count: int, seed: int = 1) -> Iterator[Pair]:
    """This many pairs, the same for the same seed: closed paths of two to four cubics, every second moved up.

    >>> next(pairs(1)).exponent
    4
    """
    chance = random.Random(f"boolean {seed}")
    for number in range(count):
        corners = 3 * chance.randint(2, 4)
        points = [(Fraction(chance.randint(0, LARGEST)), Fraction(chance.randint(0, LARGEST))) for _ in range(corners)]
        k = EXPONENTS[number % len(EXPONENTS)]
        step = Fraction(1, 1 << k)
        moved = [(x, y + step) if number % 2 else (x + step, y) for x, y in points]
        yield Pair(_closed(points), _closed(moved), k)


def _closed(points: list[tuple[Fraction, Fraction]]) -> str:
    """Path data of the closed path with these control points."""
    texts = [" ".join(repr(float(c)).removesuffix(".0") for c in point) for point in [*points, points[0]]]
    segments = [f"C{' '.join(texts[i : i + 3])}" for i in range(1, len(texts), 3)]
    return f"M{texts[0]}{''.join(segments)}Z"
