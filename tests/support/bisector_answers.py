"""Bisectors of pairs of curves that several tests hold against oracles of their own, each computed once."""

from functools import cache
from random import Random

from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.geometry.bisectors.two_curves import curve_bisector
from tests.support.bisector_oracle import FAMILIES, mapped
from tests.support.dials import factors


@cache
def of_family(name, *, exchanged=False):
    """The bisector of the two curves of a family."""
    first, second = FAMILIES[name]
    return curve_bisector(second, first) if exchanged else curve_bisector(first, second)


@cache
def of_random_pair(seed, number=None, *, exchanged=False):
    """The bisector of the two curves of `random_pair`."""
    first, second = random_pair(seed, number)
    return curve_bisector(second, first) if exchanged else curve_bisector(first, second)


def random_pair(seed, number=None):
    """Two curves with control points among few small integers, times a number of a dial on each axis: straight, plane,
    cusped, standing, copies, mirror images.
    """
    random = Random(seed)
    scales = [1, 1, 1] if number is None else factors(number, random, 3)

    def curve():
        degree, segments, size = random.choice([1, 1, 2, 2, 3]), random.choice([1, 1, 2]), random.choice([1, 1, 2])
        points = [[mpq(random.randint(-size, size)) for _ in range(3)] for _ in range(degree + segments)]
        zeros_from = random.choice([3, 3, 2, 1])
        points = [[x if k < zeros_from else mpq(0) for k, x in enumerate(p)] for p in points]
        points = [[x * scale for x, scale in zip(p, scales, strict=True)] for p in points]
        sign = random.choice([1, 1, -1])
        weights = [sign * random.choice([1, 1, 2, 3]) for _ in points] if random.random() < 0.4 else None
        knots = [0] * (degree + 1) + [1] * (segments - 1) + [segments] * (degree + 1)
        return Nurbs(degree, knots, points, weights)

    first, second = curve(), curve()
    maps = [
        lambda x, y, z: (x, y, z),
        lambda x, y, z: (y, x, z),
        lambda x, y, z: (x, y, 1 - z),
        lambda x, y, z: (x + 1, y, z),
    ]
    return (first, mapped(first, random.choice(maps))) if random.random() < 0.3 else (first, second)
