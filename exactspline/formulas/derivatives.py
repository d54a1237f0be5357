"""Invariants of a curve at a point, as functions of its first two derivatives: two vectors of numbers or any operands.

The formulas for curves at the end of this module are the same functions of γ′ and γ″.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, norm2, perp


def turning_rate(first, second):
    """``[γ′ γ″]/‖γ′‖⁴``: signed curvature over speed, in the plane.

    >>> from exactspline import rational
    >>> from exactspline.language import Vector
    >>> turning_rate(Vector(rational(0), rational(2)), Vector(rational(-4), rational(0)))
    mpq(1,2)
    """
    return det(first, second) / norm2(first) ** 2


def squared_bending(first, second):
    """``‖γ′ × γ″‖²/‖γ′‖⁶``: squared curvature in space.

    >>> from exactspline import rational
    >>> from exactspline.language import Vector
    >>> squared_bending(Vector(rational(0), rational(2), rational(0)), Vector(rational(-4), rational(0), rational(0)))
    mpq(1,1)
    """
    return norm2(cross(first, second)) / norm2(first) ** 3


def towards_centre(first, second):
    """``(‖γ′‖²/[γ′ γ″]) γ′⊥``: the vector from a point of a plane curve to its centre of curvature.

    >>> from exactspline import rational
    >>> from exactspline.language import Vector
    >>> towards_centre(Vector(rational(0), rational(2)), Vector(rational(-4), rational(0)))
    Vector(mpq(-1,1), mpq(0,1))
    """
    return perp(first) * (norm2(first) / det(first, second))


def across(first, second):
    """``(γ′ × γ″) × γ′``: the direction of the principal normal in space.

    >>> from exactspline.language import Vector
    >>> across(Vector(0, 2, 0), Vector(-4, 1, 0))
    Vector(-16, 0, 0)
    """
    return cross(cross(first, second), first)


@formula("curvature at a point", on="plane")
def curvature_over_speed(c):
    """``κ/‖γ′‖``."""
    return turning_rate(c.gamma.d(1), c.gamma.d(2))


@formula("curvature at a point", on="space")
def curvature_squared_at_a_point(c):
    """``κ²``."""
    return squared_bending(c.gamma.d(1), c.gamma.d(2))


@formula("curvature at a point", on="plane")
def centre_of_curvature(c):
    """The centre of curvature: ``γ + (‖γ′‖²/[γ′ γ″]) γ′⊥``."""
    return c.gamma + towards_centre(c.gamma.d(1), c.gamma.d(2))


@formula("curvature at a point", on="space")
def principal_normal(c):
    """``(γ′ × γ″) × γ′``."""
    return across(c.gamma.d(1), c.gamma.d(2))
