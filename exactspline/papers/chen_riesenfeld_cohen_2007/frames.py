"""§4.3 and §5: unit vectors and curvatures, over the roots σ = ‖γ′‖ and ρ = ‖γ′ × γ″‖.

The argument is a `exactspline.language.adjoined_root.FramedCurve`: a curve with ``sigma`` and, in space, ``rho``.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, join, norm2, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f0
from exactspline.papers.chen_riesenfeld_cohen_2007.space import binormal, normal, rectifying_developable, torsion


@formula("eq. (7)", on="framed")
def speed(c):
    """``‖γ′‖``."""
    return c.sigma


@formula("eq. (13)", on="framed space")
def binormal_length(c):
    """``‖γ′ × γ″‖``."""
    return c.rho


@formula("eq. (13)", on="framed", symbol=r"\mathbf{T}")
def unit_tangent(c):
    """``γ′ / ‖γ′‖``."""
    return c.gamma.d(1) / c.sigma


@formula("eq. (13)", on="framed space", symbol=r"\mathbf{B}")
def unit_binormal(c):
    """``γ′ × γ″ / ‖γ′ × γ″‖``."""
    return binormal(c) / c.rho


@formula("eq. (13)", on="framed space", symbol=r"\mathbf{N}")
def unit_normal(c):
    """``(γ′ × γ″) × γ′ / (‖γ′ × γ″‖ ‖γ′‖)``."""
    return normal(c) / (c.rho * c.sigma)


@formula("eq. (13)", on="framed space")
def unit_normal_by_product(c):
    """``B × T``."""
    return cross(unit_binormal(c), unit_tangent(c))


@formula("eq. (13)", on="framed space")
def frame_products(c):
    """The scalar products and the determinant of T, N, B, minus those of an orthonormal, right-handed basis."""
    t, n, b = unit_tangent(c), unit_normal(c), unit_binormal(c)
    lengths = [norm2(v) - 1 for v in (t, n, b)]
    return join(*lengths, dot(t, n), dot(n, b), dot(b, t), det(t, n, b) - 1)


@formula("eq. (15)", on="framed space", symbol=r"\kappa")
def curvature_in_space(c):
    """``‖γ′ × γ″‖ / ‖γ′‖³``."""
    return c.rho / c.sigma**3


@formula("eq. (16)", on="framed space")
def normal_by_curvature(c):
    """``N / κ``."""
    return unit_normal(c) / curvature_in_space(c)


@formula("Frenet equations", on="framed")
def unit_tangent_derivative(c):
    """``T′``."""
    return unit_tangent(c).d(1)


@formula("Frenet equations", on="framed space")
def unit_normal_derivative(c):
    """``N′``."""
    return unit_normal(c).d(1)


@formula("Frenet equations", on="framed space")
def unit_binormal_derivative(c):
    """``B′``."""
    return unit_binormal(c).d(1)


@formula("Frenet equations", on="framed space")
def turn_of_normal(c):
    """``τ B − κ T``: the derivative of N with respect to arc length."""
    return unit_binormal(c) * torsion(c) - unit_tangent(c) * curvature_in_space(c)


@formula("§5.4", on="framed space")
def rectifying_direction(c):
    """``τ T + κ B``."""
    return unit_tangent(c) * torsion(c) + unit_binormal(c) * curvature_in_space(c)


@formula("§5.4", on="framed space")
def rectifying_generator(c):
    """The generator of the rectifying developable."""
    return rectifying_developable(c).generator


@formula("§5.5", on="framed space")
def radius_derivative_along_binormal(c):
    """``(1/κ)′ B``."""
    return unit_binormal(c) * (1 / curvature_in_space(c)).d(1)


@formula("§4.3", on="framed plane", symbol=r"\mathbf{N}")
def unit_normal_in_plane(c):
    """``γ′⊥ / ‖γ′⊥‖``."""
    return perp(c.gamma.d(1)) / c.sigma


@formula("§4.1", on="framed plane", symbol=r"\kappa")
def signed_curvature(c):
    """``[γ′ γ″] / ‖γ′‖³``."""
    return f0(c) / c.sigma**3


@formula("§4.2", on="framed plane")
def signed_curvature_derivative(c):
    """``κ′``."""
    return signed_curvature(c).d(1)


@formula("eq. (12)", on="framed plane")
def evolute_by_unit_normal(c):
    """``γ + N/κ``."""
    return c.gamma + unit_normal_in_plane(c) / signed_curvature(c)
