"""What several benchmarks have in common: random curves from a fixed seed, a fresh start for every round, the
derivative inline over python-flint.
"""

import random

from flint import fmpz, fmpz_poly

from exactspline import Nurbs

U_PLUS_V = fmpz_poly([1, 1])


def curve(degree, segments=1, dimension=2):
    numbers = random.Random(1)
    points = [tuple(numbers.randint(-1000, 1000) for _ in range(dimension)) for _ in range(degree + segments)]
    weights = [numbers.randint(1, 20) for _ in points]
    return Nurbs(degree, [0] * degree + list(range(segments + 1)) + [segments] * degree, points, weights)


def fresh(c):
    """Drop cached derivatives: what is timed is the whole computation."""
    c.p._derivative = None
    for spline in (*c.p, c.w):
        spline._derivative = None
    return (c,), {}


def d(p, degree):
    return p.derivative() * U_PLUS_V - fmpz(degree) * p
