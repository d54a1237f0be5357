"""The input of the benchmarks: random curves from fixed seeds, as objects of this library and as bare polynomials."""

from __future__ import annotations

from collections.abc import Iterator
from math import lcm
from random import Random

from flint import fmpz, fmpz_poly

from exactspline.batch.corpus import Family
from exactspline.splines.nurbs import Nurbs

#: The 400 plane curves: degrees 2 to 5, 1 to 4 segments, half of them rational.
MIXED = Family.parsed("degree=2-5 segments=1-4 rational=half bits=10 count=400 seed=1")


def curve(degree: int, segments: int = 1, dimension: int = 2, bits: int = 10, seed: int = 1) -> Nurbs:
    """A rational curve with uniform knots, integer control points of a given number of bits, weights from 1 to 20."""
    chance, most = Random(seed), 1 << bits
    points = [tuple(chance.randint(-most, most) for _ in range(dimension)) for _ in range(degree + segments)]
    weights = [chance.randint(1, 20) for _ in points]
    return Nurbs(degree, [0] * degree + list(range(segments + 1)) + [segments] * degree, points, weights)


def along(segments: int, dimension: int = 2) -> Nurbs:
    """A polynomial cubic spline that is monotone in x and otherwise random."""
    chance = Random(1)
    points = [[i, *(chance.randint(-9, 9) for _ in range(dimension - 1))] for i in range(segments + 3)]
    return Nurbs(3, [0] * 3 + list(range(segments + 1)) + [segments] * 3, points)


def wandering(degree: int, segments: int, *, rational: bool) -> Nurbs:
    """A plane curve that proceeds to the right."""
    chance, x, y, points = Random(1), 0, 0, []
    for _ in range(degree + segments):
        x, y = x + chance.randint(1, 9), y + chance.randint(-9, 9)
        points.append((x, y))
    weights = [chance.randint(1, 9) for _ in points] if rational else None
    return Nurbs(degree, [0] * degree + list(range(segments + 1)) + [segments] * degree, points, weights)


def forms(c: Nurbs) -> Iterator[tuple[list[fmpz_poly], int]]:
    """The components and the weight of every segment over one denominator, and the denominator."""
    for row in zip(*[spline.forms for spline in (*c.p, c.w)], strict=True):
        m = lcm(*[int(k) for _, k in row])
        yield [p * (fmpz(m) // k) for p, k in row], m
