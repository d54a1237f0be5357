"""Shared by several benchmarks: random curves from a fixed seed, a fresh start for every round.

The inline code over bare polynomials is in `workshop.bench.inline`.
"""

import random

from exactspline import Nurbs


def curve(degree, segments=1, dimension=2):
    numbers = random.Random(1)
    points = [tuple(numbers.randint(-1000, 1000) for _ in range(dimension)) for _ in range(degree + segments)]
    weights = [numbers.randint(1, 20) for _ in points]
    return Nurbs(degree, [0] * degree + list(range(segments + 1)) + [segments] * degree, points, weights)


def fresh(c):
    """The curve constructed anew: the whole computation is timed, without memoized values."""
    return (Nurbs(c.degree, c.knots, c.control_points, c.weights),), {}
