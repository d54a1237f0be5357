"""Curvatures of a rational surface, as they are defined: of Gauss, mean, normal, principal.

With the normal of length ``√(EG − F²)`` the Gaussian curvature is ``(LN − M²)/(EG − F²)²``, the mean curvature
``(EN − 2FM + GL)/(2 (EG − F²)^(3/2))``: rational is its square.
"""

from exactspline.language.formula import formula
from exactspline.papers.surfaces.fundamental_forms import E, F, G, L, M, N, area_squared


@formula("Gaussian curvature", on="surface")
def parabolic(c):
    """``LN − M²``: positive at elliptic points, negative at hyperbolic ones, zero on the parabolic curve."""
    return L(c) * N(c) - M(c) ** 2


@formula("Gaussian curvature", on="surface", symbol="K")
def gaussian_curvature(c):
    """``(LN − M²)/(EG − F²)²``."""
    return parabolic(c) / area_squared(c) ** 2


@formula("mean curvature", on="surface")
def minimality(c):
    """``EN − 2FM + GL``: zero on minimal surfaces."""
    return E(c) * N(c) - 2 * F(c) * M(c) + G(c) * L(c)


@formula("mean curvature", on="surface", symbol="H^2")
def mean_curvature_squared(c):
    """``(EN − 2FM + GL)²/(4 (EG − F²)³)``."""
    return minimality(c) ** 2 / (4 * area_squared(c) ** 3)


@formula("principal curvatures", on="surface")
def umbilicity(c):
    """``(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)``: never negative, zero at the umbilics."""
    return minimality(c) ** 2 - 4 * area_squared(c) * parabolic(c)
