"""Curvatures from the two lifts of the surface: points and planes are linear in ``P = (w, p)``, spheres in ``X = (‖p‖²,
w p, w²)``.

The tangent plane is orthogonal to P, P_u and P_v, a tangent sphere to X, X_u and X_v; contact of second order is
expressed by determinants with second derivatives.
"""

from exactspline.formulas.surfaces.by_forms import (
    along_weight,
    area_of_forms,
    extremal_along_lines,
    line_uu_of_forms,
    line_uv_of_forms,
    line_vv_of_forms,
    minimality_of_forms,
    parabolic_of_forms,
    ridge_cubic,
)
from exactspline.formulas.surfaces.fundamental_forms import E_reduced, F_reduced, G_reduced
from exactspline.language.arguments import Operands
from exactspline.language.formula import formula
from exactspline.language.vector import det, generalized_cross, join, norm2


def lifted_forms(c):
    """``w⁴`` times the two fundamental forms, by their coefficients."""
    return Operands(E=E_reduced(c), F=F_reduced(c), G=G_reduced(c), L=L_lifted(c), M=M_lifted(c), N=N_lifted(c))


@formula("projective lift", on="surface", symbol="P")
def projective_lift_of_surface(c):
    """``(w, p)``; w first, so that determinants have the same sign as those of the surface."""
    return join(c.w, c.p)


@formula("conformal lift", on="surface", symbol="X")
def conformal_lift_of_surface(c):
    """``(‖p‖², w p, w²)``."""
    return join(norm2(c.p), c.p * c.w, c.w**2)


@formula("lifted", on="surface", symbol=r"\Pi")
def tangent_plane(c):
    """The plane through P, P_u, P_v: its first coordinate, then its normal, ``w³ n``."""
    x = projective_lift_of_surface(c)
    return generalized_cross(x, x.d(1, by="u"), x.d(1, by="v"))


@formula("lifted", on="surface", symbol=r"\Pi_n")
def normal_lifted_of_surface(c):
    """The normal of the tangent plane."""
    return tangent_plane(c)[1:4]


@formula("lifted", on="surface", symbol=r"[P\ P_u\ P_v\ P_{uu}]")
def L_lifted(c):
    """``w⁴ L``."""
    x = projective_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2, by="u"))


@formula("lifted", on="surface", symbol=r"[P\ P_u\ P_v\ P_{uv}]")
def M_lifted(c):
    """``w⁴ M``."""
    x = projective_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(1, by="u").d(1, by="v"))


@formula("lifted", on="surface", symbol=r"[P\ P_u\ P_v\ P_{vv}]")
def N_lifted(c):
    """``w⁴ N``."""
    x = projective_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2, by="v"))


@formula("lifted", on="surface")
def parabolic_lifted(c):
    """``w⁸ (LN − M²)`` in terms of determinants of P."""
    return parabolic_of_forms(Operands(L=L_lifted(c), M=M_lifted(c), N=N_lifted(c)))


@formula("lifted", on="surface")
def area_squared_lifted(c):
    """``w⁶ (EG − F²)``, the squared length of the normal of the tangent plane."""
    return norm2(normal_lifted_of_surface(c))


@formula("lifted", on="surface", symbol="K")
def gaussian_curvature_lifted(c):
    """Gaussian curvature from the determinants of P: ``w⁴ ([…uu][…vv] − […uv]²)/‖Π_n‖⁴``."""
    return parabolic_lifted(c) * c.w**4 / area_squared_lifted(c) ** 2


@formula("lifted", on="surface")
def minimality_lifted(c):
    """``w⁸ (EN − 2FM + GL)``."""
    return minimality_of_forms(lifted_forms(c))


@formula("lifted", on="surface", symbol="[X\\ X_u\\ X_v\\ X_{uu}\\ X_{uv}]")
def line_coefficient_uu_lifted(c):
    """``2 w¹⁰ (EM − FL)``: zero where one sphere matches both second derivatives, by uu and by uv."""
    x = conformal_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2, by="u"), x.d(1, by="u").d(1, by="v"))


@formula("lifted", on="surface", symbol="[X\\ X_u\\ X_v\\ X_{uu}\\ X_{vv}]")
def line_coefficient_uv_lifted(c):
    """``2 w¹⁰ (EN − GL)``."""
    x = conformal_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2, by="u"), x.d(2, by="v"))


@formula("lifted", on="surface", symbol="[X\\ X_u\\ X_v\\ X_{uv}\\ X_{vv}]")
def line_coefficient_vv_lifted(c):
    """``2 w¹⁰ (FN − GM)``."""
    x = conformal_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(1, by="u").d(1, by="v"), x.d(2, by="v"))


@formula("lifted", on="surface")
def line_coefficient_uu_projective(c):
    """``w⁸ (EM − FL)`` in terms of determinants of P: of lower degree than the one with X."""
    return line_uu_of_forms(lifted_forms(c))


@formula("lifted", on="surface")
def line_coefficient_uv_projective(c):
    """``w⁸ (EN − GL)``."""
    return line_uv_of_forms(lifted_forms(c))


@formula("lifted", on="surface")
def line_coefficient_vv_projective(c):
    """``w⁸ (FN − GM)``."""
    return line_vv_of_forms(lifted_forms(c))


@formula("lifted", on="surface", symbol="H^2")
def mean_curvature_squared_lifted(c):
    """Squared mean curvature from the determinants of P: ``w² (eN − 2fM + gL)²/(4 ‖Π_n‖⁶)``."""
    return minimality_lifted(c) ** 2 * c.w**2 / (4 * area_squared_lifted(c) ** 3)


@formula("lifted", on="surface")
def minimality_of_spheres(c):
    """``[I X X_u X_v Y]`` with the point at infinity ``I = (1, 0, 0, 0, 0)`` and ``Y = e X_vv − 2 f X_uv + g X_uu``."""
    x = conformal_lift_of_surface(c)[1:5]
    bent = (
        x.d(2, by="v") * E_reduced(c) - x.d(1, by="u").d(1, by="v") * (2 * F_reduced(c)) + x.d(2, by="u") * G_reduced(c)
    )
    return det(x, x.d(1, by="u"), x.d(1, by="v"), bent)


@formula("lifted", on="surface")
def focal_discriminant_lifted(c):
    """The discriminant of ``w² k σ² − h σ + ‖Π_n‖² = 0``, for ``k = w⁸ (LN − M²)`` and ``h = w⁸ (EN − 2FM + GL)``: its
    roots are the centres of curvature ``(p + σ Π_n)/w``.
    """
    return minimality_lifted(c) ** 2 - 4 * c.w**2 * area_squared_lifted(c) * parabolic_lifted(c)


@formula("lifted", on="surface")
def ridge_cubic_lifted(c):
    """``w¹²`` times the cubic form of the ridges: that of ``w⁴ I`` and ``w⁴ II``, corrected by ``4 w ‖Π_n‖² dw II``."""
    forms = lifted_forms(c)
    return ridge_cubic(forms) + along_weight(forms, c.w) * (4 * c.w * area_squared_lifted(c))


@formula("lifted", on="surface")
def ridges_lifted(c):
    """``w⁴⁸`` times the polynomial of the ridges."""
    return extremal_along_lines(lifted_forms(c), ridge_cubic_lifted(c))


@formula("lifted", on="surface")
def area_of_lifted_forms(c):
    """``EG − F²`` of ``w⁴ I``."""
    return area_of_forms(Operands(E=E_reduced(c), F=F_reduced(c), G=G_reduced(c)))
