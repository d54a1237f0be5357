"""Plane vectors as complex numbers ``a₁ + a₂ i``, in the reading of their components.

The real part is ``a[0]``, the imaginary part ``a[1]``; ``perp(a)`` is ``i a`` and ``norm2(a)`` is ``a ā``.
"""

from __future__ import annotations

from typing import Any, overload

from exactspline.language.operand import C
from exactspline.language.rational import Rational
from exactspline.language.vector import F, S, Vector, expect_vector, join, norm2


def complex_product(a: Vector[S], b: Vector[S]) -> Vector[S]:
    """Return the product ``a b`` of two plane vectors as complex numbers, a plane vector.

    >>> from exactspline.language.vector import Vector
    >>> complex_product(Vector(1, 2), Vector(3, 4))
    Vector(-5, 10)
    """
    expect_vector(a)
    expect_vector(b)
    return join(a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0])


def conjugate(a: Vector[S]) -> Vector[S]:
    """Return ``ā``, the plane vector reflected in the first axis.

    >>> from exactspline.language.vector import Vector
    >>> conjugate(Vector(1, 2))
    Vector(1, -2)
    """
    expect_vector(a)
    return join(a[0], -a[1])


@overload
def complex_quotient(a: Vector[F], b: Vector[F]) -> Vector[F]:
    """Return a vector if the components can be divided."""


@overload
def complex_quotient(a: Vector[C], b: Vector[C]) -> Rational[C]:
    """Return a quotient if the components cannot be divided."""


def complex_quotient(a: Vector[S], b: Vector[S]) -> object:
    """Return the complex quotient ``a / b = a b̄ / (b b̄)``, whose denominator is the squared length of b.

    >>> from exactspline.language.kinds import PLANE
    >>> from exactspline.readings.jet import RationalJetReading
    >>> c = RationalJetReading(1).argument(PLANE, 2)
    >>> complex_quotient(complex_product(c.p, c.p.d(1)), c.p) == c.p.d(1)
    True
    """
    numerator: Any = complex_product(a, conjugate(b))
    return numerator / norm2(b)
