"""Curves on a surface: γ(t) = S(u(t), v(t)), with derivatives by the chain rule.

Statements about fundamental forms in a direction are formulated here for every curve with that direction, so that they
can be compared with the curvature of space curves.
"""

from exactspline.formulas.surfaces.curvatures import area_squared
from exactspline.formulas.surfaces.fundamental_forms import E, F, G, L, M, N, normal
from exactspline.formulas.surfaces.lifted import projective_lift_of_surface
from exactspline.formulas.surfaces.lines_of_curvature import (
    line_coefficient_uu,
    line_coefficient_uv,
    line_coefficient_vv,
)
from exactspline.language.formula import formula
from exactspline.language.vector import det, dot


@formula("first fundamental form", on="curve on a surface", symbol=r"\mathrm{I}")
def first_form(c):
    """``E u′² + 2F u′v′ + G v′²``."""
    return E(c) * c.u.d(1) ** 2 + 2 * F(c) * c.u.d(1) * c.v.d(1) + G(c) * c.v.d(1) ** 2


@formula("second fundamental form", on="curve on a surface", symbol=r"\mathrm{II}")
def second_form(c):
    """``L u′² + 2M u′v′ + N v′²``."""
    return L(c) * c.u.d(1) ** 2 + 2 * M(c) * c.u.d(1) * c.v.d(1) + N(c) * c.v.d(1) ** 2


@formula("J. B. Meusnier 1776", on="curve on a surface")
def acceleration_on_normal(c):
    """``γ″ · n``."""
    return dot(c.gamma.d(2), normal(c))


@formula("normal curvature", on="curve on a surface", symbol=r"\kappa_n^2")
def normal_curvature_squared(c):
    """``II²/(I² (EG − F²))``, the same for all curves with the same direction."""
    return second_form(c) ** 2 / (first_form(c) ** 2 * area_squared(c))


@formula("geodesic curvature", on="curve on a surface")
def geodesic_determinant(c):
    """``[γ′ γ″ n]``: zero where the geodesic curvature vanishes."""
    return det(c.gamma.d(1), c.gamma.d(2), normal(c))


@formula("geodesic curvature", on="curve on a surface")
def geodesic_determinant_of_first_form(c):
    """``(γ′·S_u)(γ″·S_v) − (γ′·S_v)(γ″·S_u)``, each product from E, F, G and their derivatives."""
    u, v, e, f, g = c.u.d(1), c.v.d(1), E(c), F(c), G(c)
    bent_u = e.d(1, by="u") / 2 * u**2 + e.d(1, by="v") * u * v + (f.d(1, by="v") - g.d(1, by="u") / 2) * v**2
    bent_v = (f.d(1, by="u") - e.d(1, by="v") / 2) * u**2 + g.d(1, by="u") * u * v + g.d(1, by="v") / 2 * v**2
    on_u, on_v = e * c.u.d(2) + f * c.v.d(2) + bent_u, f * c.u.d(2) + g * c.v.d(2) + bent_v
    return (e * u + f * v) * on_v - (f * u + g * v) * on_u


@formula("geodesic curvature", on="curve on a surface", symbol=r"\kappa_g^2")
def geodesic_curvature_squared(c):
    """``[γ′ γ″ n]²/(I³ (EG − F²))``."""
    return geodesic_determinant(c) ** 2 / (first_form(c) ** 3 * area_squared(c))


@formula("curvature", on="curve on a surface")
def curvature_from_surface(c):
    """``κ_n² + κ_g²``."""
    return normal_curvature_squared(c) + geodesic_curvature_squared(c)


@formula("lines of curvature", on="curve on a surface")
def line_form(c):
    """``A u′² + B u′v′ + C v′²``."""
    u, v = c.u.d(1), c.v.d(1)
    return line_coefficient_uu(c) * u**2 + line_coefficient_uv(c) * u * v + line_coefficient_vv(c) * v**2


@formula("O. Rodrigues 1816", on="curve on a surface")
def turning_of_normal(c):
    """``[n n′ γ′]``: zero where the normals along the curve form a developable surface."""
    return det(normal(c), normal(c).d(1), c.gamma.d(1))


@formula("lifted", on="curve on a surface", symbol="[P\\ P_u\\ P_v\\ P'']")
def second_form_lifted(c):
    """The determinant ``[P P_u P_v P″]``: contact of the curve with the tangent plane of the surface."""
    x = projective_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2))
