"""Parallel curves at a distance δ.

The given curve is the square root of the velocity in complex notation: ``x′ = (u² − v², 2uv)`` for ``p = (u, v)``.
Every regular plane curve has such a root, with ``|x′| = u² + v²``, so that its offset can be written without square
roots; the curves with a polynomial root are Pythagorean-hodograph curves.
"""

from exactspline.language.complex_numbers import complex_product
from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, join, norm2, perp

KIND = "plane with delta"


@formula("complex notation", on="plane", symbol="V")
def root_velocity(c):
    """``x′ = (u + iv)²``."""
    return complex_product(c.p, c.p)


@formula("complex notation", on="plane", symbol=r"\sigma")
def root_speed(c):
    """``|x′| = u² + v²``."""
    return norm2(c.p)


@formula("complex notation", on="plane")
def root_velocity_squared(c):
    """``|x′|²``."""
    return norm2(root_velocity(c))


@formula("complex notation", on="plane")
def root_speed_squared(c):
    """``(u² + v²)²``."""
    return root_speed(c) ** 2


@formula("Cusp finding", on="plane", symbol=r"\kappa")
def offset_curvature_printed(c):
    """``(x″ × x′) / |x′|³``."""
    return det(root_velocity(c).d(1), root_velocity(c)) / root_speed(c) ** 3


@formula("curvature in complex notation", on="plane")
def curvature_by_root(c):
    """``2 (u v′ − v u′) / (u² + v²)²``: positive where the curve turns left."""
    return 2 * det(c.p, c.p.d(1)) / root_speed(c) ** 2


@formula("CubicOffset.eval_offset", on=KIND)
def offset_step(c):
    """``(−s y′, s x′)`` with ``s = δ/|x′|``: the vector from the curve to its parallel curve."""
    v = root_velocity(c)
    return join(-v[1], v[0]) * (c.delta / root_speed(c))


@formula("CubicOffset.eval_offset", on=KIND)
def offset_step_derivative(c):
    """The derivative of the vector from the curve to its parallel curve."""
    return offset_step(c).d(1)


@formula("CubicOffset.eval_deriv", on=KIND)
def offset_velocity_in_code(c):
    """``(1 + (x″ × x′) δ/|x′|³) x′``."""
    v = root_velocity(c)
    return v * (1 + det(v.d(1), v) * c.delta / root_speed(c) ** 3)


@formula("the parallel curve", on=KIND)
def offset_velocity(c):
    """The derivative of the parallel curve."""
    return root_velocity(c) + offset_step(c).d(1)


@formula("Cusp finding", on=KIND)
def cusp_function(c):
    """``(x″ × x′) δ + |x′|³``."""
    v = root_velocity(c)
    return det(v.d(1), v) * c.delta + root_speed(c) ** 3


@formula("Cusp finding", on=KIND)
def velocity_less_curvature(c):
    """``(1 − κδ) x′`` for the curvature as printed: zero where it is the reciprocal of the distance."""
    return root_velocity(c) * (1 - offset_curvature_printed(c) * c.delta)


@formula("the parallel on the other side", on=KIND)
def velocities_of_both_sides(c):
    """The sum of ``(1 − κδ) x′`` and the velocity of the parallel curve, minus twice x′."""
    return velocity_less_curvature(c) + offset_velocity(c) - 2 * root_velocity(c)


@formula("Cusp finding", on=KIND)
def velocity_plus_curvature(c):
    """``(1 + κδ) x′``."""
    return root_velocity(c) * (1 + offset_curvature_printed(c) * c.delta)


@formula("the parallel curve", on=KIND)
def offset_distance_squared(c):
    """The squared distance of the parallel curve from the curve."""
    return norm2(offset_step(c))


@formula("the parallel curve", on=KIND, symbol=r"\delta")
def distance(c):
    """``δ``."""
    return c.delta


@formula("the parallel curve", on=KIND)
def distance_squared(c):
    """``δ²``."""
    return c.delta**2


@formula("the parallel curve", on=KIND)
def offset_step_on_velocity(c):
    """The scalar product of x′ and the vector to the parallel curve."""
    return dot(offset_step(c), root_velocity(c))


@formula("the parallel curve", on=KIND)
def shrinking(c):
    """``1 + κδ`` for the curvature as printed."""
    return cusp_function(c) / root_speed(c) ** 3


@formula("the parallel curve", on=KIND)
def curvature_of_the_parallel(c):
    """``(y″ × y′)/|y′|³`` for the parallel curve y, with ``|y′| = (1 + κδ)|x′|``."""
    v = offset_velocity(c)
    return det(v.d(1), v) / (shrinking(c) * root_speed(c)) ** 3


@formula("the parallel curve", on=KIND)
def curvature_over_shrinking(c):
    """``κ/(1 + κδ)``."""
    return offset_curvature_printed(c) / shrinking(c)


@formula("the parallel of a circular arc", on=KIND)
def curvature_change_of_the_parallel(c):
    """The derivative of ``κ/(1 + κδ)``."""
    return curvature_over_shrinking(c).d(1)


@formula("the parallel of a circular arc", on="plane")
def curvature_change(c):
    """The derivative of κ."""
    return offset_curvature_printed(c).d(1)


@formula("the parallel curve", on=KIND)
def radii_less_distance(c):
    """``1/κ_δ − 1/κ − δ``: zero if the centres of curvature are the same."""
    return 1 / curvature_over_shrinking(c) - 1 / offset_curvature_printed(c) - c.delta


@formula("the parallel of a Pythagorean hodograph", on=KIND)
def step_times_speed(c):
    """The vector to the parallel curve times ``u² + v²``."""
    return offset_step(c) * root_speed(c)


@formula("the parallel of a Pythagorean hodograph", on=KIND)
def step_numerator(c):
    """``δ (−2uv, u² − v²)``: a polynomial."""
    return perp(root_velocity(c)) * c.delta
