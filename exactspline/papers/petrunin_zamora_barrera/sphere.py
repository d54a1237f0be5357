"""Spherical curves: plane curves mapped to the unit sphere by stereographic projection."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, join, norm2


@formula("section Spherical curves", on="plane", symbol="S")
def spherical_curve(c):
    """``(2x, 2y, x² + y² − 1) / (x² + y² + 1)``: a curve on the unit sphere."""
    return join(c.p * (2 * c.w), norm2(c.p) - c.w**2) / (norm2(c.p) + c.w**2)


@formula("section Spherical curves", on="plane")
def spherical_distance(c):
    """``|S|² − 1``."""
    return norm2(spherical_curve(c)) - 1


@formula("ex:spherical-frenet, tau", on="plane")
def spherical_tangent_on_radius(c):
    """``⟨S′, S⟩``."""
    return dot(spherical_curve(c).d(1), spherical_curve(c))


@formula("ex:spherical-frenet, nu", on="plane")
def spherical_acceleration(c):
    """The second derivative of S with respect to arc length."""
    a, b = spherical_curve(c).d(1), spherical_curve(c).d(2)
    return (b * norm2(a) - a * dot(a, b)) / norm2(a) ** 2


@formula("ex:spherical-frenet, nu", on="plane")
def spherical_normal_on_radius(c):
    """``κ⟨N, S⟩ + 1``: zero if ``⟨N, S⟩ = −1/κ``."""
    return dot(spherical_acceleration(c), spherical_curve(c)) + 1


@formula("ex:curvature-of-spherical-curve", on="plane")
def spherical_curvature_excess(c):
    """``κ² − 1``."""
    return norm2(spherical_acceleration(c)) - 1


@formula("ex:curvature-of-spherical-curve", on="plane")
def spherical_speed_squared(c):
    """``|S′|²``."""
    return norm2(spherical_curve(c).d(1))


@formula("ex:curvature-of-spherical-curve", on="plane")
def geodesic_bending(c):
    """``[S S′ S″] S′``, with length ``|[S S′ S″]| |S′|``."""
    s = spherical_curve(c)
    return s.d(1) * det(s, s.d(1), s.d(2))


@formula("ex:spherical-frenet, tau", on="plane")
def spherical_frame_sum(c):
    """``⟨N, S⟩² + ⟨B, S⟩² − 1`` times κ²."""
    s, k = spherical_curve(c), spherical_acceleration(c)
    b = cross(s.d(1), k)
    return dot(k, s) ** 2 + dot(b, s) ** 2 / norm2(s.d(1)) - norm2(k)
