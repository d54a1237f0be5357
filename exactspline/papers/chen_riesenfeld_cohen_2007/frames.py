"""§4.3 and §5: unit vectors and curvatures, over the roots σ = ‖γ′‖ and ρ = ‖γ′ × γ″‖.

The argument is a `exactspline.language.adjoined_root.FramedCurve`: a curve with ``sigma`` and, in space, ``rho``.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f0
from exactspline.papers.chen_riesenfeld_cohen_2007.space import binormal, normal


@formula("eq. (13)", on="framed", symbol=r"\mathbf{T}")
def unit_tangent(c):
    """``γ′ / ‖γ′‖``."""
    return c.gamma.d(1) / c.sigma


@formula("eq. (13)", on="framed", symbol=r"\mathbf{B}")
def unit_binormal(c):
    """``γ′ × γ″ / ‖γ′ × γ″‖``."""
    return binormal(c) / c.rho


@formula("eq. (13)", on="framed", symbol=r"\mathbf{N}")
def unit_normal(c):
    """``(γ′ × γ″) × γ′ / (‖γ′ × γ″‖ ‖γ′‖)``."""
    return normal(c) / (c.rho * c.sigma)


@formula("eq. (13)", on="framed")
def unit_normal_by_product(c):
    """``B × T``."""
    return cross(unit_binormal(c), unit_tangent(c))


@formula("eq. (15)", on="framed", symbol=r"\kappa")
def curvature_in_space(c):
    """``‖γ′ × γ″‖ / ‖γ′‖³``."""
    return c.rho / c.sigma**3


@formula("§4.3", on="framed", symbol=r"\mathbf{N}")
def unit_normal_in_plane(c):
    """``γ′⊥ / ‖γ′⊥‖``."""
    return perp(c.gamma.d(1)) / c.sigma


@formula("§4.1", on="framed", symbol=r"\kappa")
def signed_curvature(c):
    """``[γ′ γ″] / ‖γ′‖³``."""
    return f0(c) / c.sigma**3
