"""Tangents, normals, curvature, and statements of the Primer on offsets."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, join, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import jerk, speed_squared


@formula("tangents and normals", on="plane")
def rotated_tangent(c):
    """``(−B′_y, B′_x)``: the tangent rotated by a quarter turn; normal_x and normal_y times d."""
    tangent = c.gamma.d(1)
    return join(-tangent[1], tangent[0])


@formula("tangents and normals", on="plane")
def tangent_length_squared(c):
    """``B′_x² + B′_y²``."""
    tangent = c.gamma.d(1)
    return tangent[0] ** 2 + tangent[1] ** 2


@formula("tangents and normals", on="plane")
def rotated_tangent_on_tangent(c):
    """The scalar product of the normal and the tangent: zero at a right angle."""
    return dot(rotated_tangent(c), c.gamma.d(1))


@formula("tangents and normals", on="plane")
def rotated_tangent_squared(c):
    """The squared length of the rotated tangent."""
    return norm2(rotated_tangent(c))


@formula("inflections; curvature", on="plane", symbol="C")
def curvature_function(c):
    """``C(t) = x′ y″ − y′ x″``."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return a[0] * b[1] - a[1] * b[0]


@formula("curvature", on="plane")
def primer_curvature_squared(c):
    """The square of ``(x′y″ − x″y′) / (x′² + y′²)^(3/2)``."""
    return curvature_function(c) ** 2 / tangent_length_squared(c) ** 3


@formula("curvature", on="plane")
def primer_radius_squared(c):
    """The square of ``R = 1/κ``."""
    return 1 / primer_curvature_squared(c)


@formula("offsetting", on="plane")
def tangent_length_changes(c):
    """The derivative of ``‖B′‖²``: zero if the length of the tangent were constant, as an integral from 0 to 1 is."""
    return speed_squared(c).d(1)


@formula("offsetting", on="plane")
def twice_velocity_on_acceleration(c):
    """``2 B′·B″``."""
    return 2 * dot(c.gamma.d(1), c.gamma.d(2))


@formula("derivatives")
def third_derivative(c):
    """The third derivative, according to the Primer "(meaningful)" only for curves of order four and more."""
    return jerk(c)


@formula("working with 3D normals", on="space", symbol="r")
def rotation_axis(c):
    """``b × a`` with ``a = B′`` and ``b = a + B″``: r, not normalized."""
    a = c.gamma.d(1)
    return cross(a + c.gamma.d(2), a)


@formula("working with 3D normals", on="space")
def frenet_normal_in_four_lines(c):
    """``r × a``: the normal, not normalized."""
    return cross(rotation_axis(c), c.gamma.d(1))


@formula("working with 3D normals", on="space")
def frenet_normal_across(c):
    """The scalar product of this normal and the tangent."""
    return dot(frenet_normal_in_four_lines(c), c.gamma.d(1))


@formula("rational Béziers")
def ratios_doubled(c):
    """The curve with every ratio doubled, in numerator and denominator."""
    return (c.p * 2) / (c.w * 2)


@formula("rational Béziers")
def the_curve(c):
    """The rational curve itself."""
    return c.p / c.w
