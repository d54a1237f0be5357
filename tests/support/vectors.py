"""Vectors and numbers without the toolkit, for oracles: tuples and lists of any numbers."""

from mpmath import mpf


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turn(a, b):
    """The determinant of two vectors of the plane."""
    return a[0] * b[1] - a[1] * b[0]


def mpf_of(x):
    """A rational number in the working precision."""
    return mpf(int(x.numerator)) / int(x.denominator)
