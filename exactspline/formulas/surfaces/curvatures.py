"""Gaussian, mean and principal curvatures of a rational surface, by their definitions; lines of curvature,
``A du² + B du dv + C dv² = 0``, and umbilics, where all three coefficients vanish.

Since the normal has length ``√(EG − F²)``, the Gaussian curvature is ``(LN − M²)/(EG − F²)²`` and the mean curvature is
``(EN − 2FM + GL)/(2 (EG − F²)^(3/2))``, whose square is rational.
"""

from exactspline.formulas.surfaces.by_forms import (
    area_of_forms,
    line_uu_of_forms,
    line_uv_of_forms,
    line_vv_of_forms,
    minimality_of_forms,
    parabolic_of_forms,
    ridge_cubic,
    ridges_of_forms,
    stationary_by_u,
    umbilicity_of_forms,
)
from exactspline.formulas.surfaces.fundamental_forms import (
    E,
    E_reduced,
    F,
    F_reduced,
    G,
    G_reduced,
    L,
    L_reduced,
    M,
    M_reduced,
    N,
    N_reduced,
    S_u,
    S_v,
    normal,
)
from exactspline.language.arguments import Operands
from exactspline.language.formula import formula
from exactspline.language.vector import det, join


def reduced_forms(c):
    """``w⁴`` times the first and ``w⁷`` times the second fundamental form, from the numerators of derivatives."""
    first = {"E": E_reduced(c), "F": F_reduced(c), "G": G_reduced(c)}
    return Operands(**first, L=L_reduced(c), M=M_reduced(c), N=N_reduced(c))


def forms(c):
    """The two fundamental forms of a surface, by their coefficients."""
    return Operands(E=E(c), F=F(c), G=G(c), L=L(c), M=M(c), N=N(c))


@formula("first fundamental form", on="surface")
def area_squared(c):
    """``EG − F²``, the square of the area element."""
    return area_of_forms(Operands(E=E(c), F=F(c), G=G(c)))


@formula("Gaussian curvature", on="surface")
def parabolic(c):
    """``LN − M²``: positive at elliptic points, negative at hyperbolic ones, zero on the parabolic curve."""
    return parabolic_of_forms(forms(c))


@formula("Gaussian curvature", on="surface", symbol="K")
def gaussian_curvature(c):
    """``(LN − M²)/(EG − F²)²``."""
    return parabolic(c) / area_squared(c) ** 2


@formula("mean curvature", on="surface")
def minimality(c):
    """``EN − 2FM + GL``: zero on minimal surfaces."""
    return minimality_of_forms(forms(c))


@formula("mean curvature", on="surface", symbol="H^2")
def mean_curvature_squared(c):
    """``(EN − 2FM + GL)²/(4 (EG − F²)³)``."""
    return minimality(c) ** 2 / (4 * area_squared(c) ** 3)


@formula("principal curvatures", on="surface")
def umbilicity(c):
    """``(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)``: never negative, zero at the umbilics."""
    return umbilicity_of_forms(forms(c))


@formula("reduced", on="surface")
def area_squared_reduced(c):
    """``w⁸ (EG − F²)``."""
    return area_of_forms(Operands(E=E_reduced(c), F=F_reduced(c), G=G_reduced(c)))


@formula("reduced", on="surface")
def parabolic_reduced(c):
    """``w¹⁴ (LN − M²)``."""
    return parabolic_of_forms(reduced_forms(c))


@formula("reduced", on="surface")
def minimality_reduced(c):
    """``w¹¹ (EN − 2FM + GL)``."""
    return minimality_of_forms(reduced_forms(c))


@formula("reduced", on="surface", symbol="K")
def gaussian_curvature_reduced(c):
    """``w² · w¹⁴ (LN − M²)/(w⁸ (EG − F²))²``."""
    return parabolic_reduced(c) * c.w**2 / area_squared_reduced(c) ** 2


@formula("reduced", on="surface", symbol="H^2")
def mean_curvature_squared_reduced(c):
    """``w² (w¹¹ (EN − 2FM + GL))²/(4 (w⁸ (EG − F²))³)``."""
    return minimality_reduced(c) ** 2 * c.w**2 / (4 * area_squared_reduced(c) ** 3)


@formula("F. Brioschi 1852, after C. F. Gauss, Disquisitiones generales circa superficies curvas, 11", on="surface")
def brioschi(c):
    """``K (EG − F²)²`` from E, F, G and their derivatives alone."""
    e, f, g = E(c), F(c), G(c)
    e_u, e_v, g_u, g_v = e.d(1, by="u"), e.d(1, by="v"), g.d(1, by="u"), g.d(1, by="v")
    f_u, f_v = f.d(1, by="u"), f.d(1, by="v")
    bent = f_u.d(1, by="v") - e_v.d(1, by="v") / 2 - g_u.d(1, by="u") / 2
    first = det(join(bent, e_u / 2, f_u - e_v / 2), join(f_v - g_u / 2, e, f), join(g_v / 2, f, g))
    second = det(join(0, e_v / 2, g_u / 2), join(e_v / 2, e, f), join(g_u / 2, f, g))
    return first - second


@formula("principal curvatures", on="surface")
def stationary_curvature(c):
    """The part of κ_u free of the root, up to a factor: ``a Δ_u − 3 Δ a_u`` with ``a = EG − F²`` and the discriminant
    Δ.
    """
    return stationary_by_u(forms(c))


@formula("ridges", on="surface", symbol="T")
def ridge_cubic_of_surface(c):
    """The cubic form of the ridges, in terms of the coefficients of both fundamental forms."""
    return ridge_cubic(forms(c))


@formula("ridges", on="surface")
def ridges(c):
    """Zero where a principal curvature is extremal along its line of curvature."""
    return ridges_of_forms(forms(c))


@formula("normals", on="surface")
def gauss_map_area(c):
    """``[n n_u n_v]``: the area factor of the Gauss map, up to powers of ``EG − F²``."""
    return det(normal(c), normal(c).d(1, by="u"), normal(c).d(1, by="v"))


@formula("normals", on="surface")
def focal_linear_coefficient(c):
    """``[n n_u S_v] + [n S_u n_v]``, the coefficient of t in ``[n (S + tn)_u (S + tn)_v]``."""
    return det(normal(c), normal(c).d(1, by="u"), S_v(c)) + det(normal(c), S_u(c), normal(c).d(1, by="v"))


@formula("normals", on="surface")
def focal_constant_coefficient(c):
    """``[n S_u S_v]``."""
    return det(normal(c), S_u(c), S_v(c))


@formula("lines of curvature", on="surface", symbol="A")
def line_coefficient_uu(c):
    """``EM − FL``, the coefficient of du²."""
    return line_uu_of_forms(forms(c))


@formula("lines of curvature", on="surface", symbol="B")
def line_coefficient_uv(c):
    """``EN − GL``, the coefficient of du dv."""
    return line_uv_of_forms(forms(c))


@formula("lines of curvature", on="surface", symbol="C")
def line_coefficient_vv(c):
    """``FN − GM``, the coefficient of dv²."""
    return line_vv_of_forms(forms(c))


@formula("O. Rodrigues 1816", on="surface")
def turning_uu(c):
    """``[n n_u S_u]``: zero where the normal turns towards the u-line, so that this is a line of curvature."""
    return det(normal(c), normal(c).d(1, by="u"), S_u(c))


@formula("O. Rodrigues 1816", on="surface")
def turning_uv(c):
    """``[n n_u S_v] + [n n_v S_u]``."""
    return det(normal(c), normal(c).d(1, by="u"), S_v(c)) + det(normal(c), normal(c).d(1, by="v"), S_u(c))


@formula("O. Rodrigues 1816", on="surface")
def turning_vv(c):
    """``[n n_v S_v]``."""
    return det(normal(c), normal(c).d(1, by="v"), S_v(c))


@formula("reduced", on="surface")
def line_coefficient_uu_reduced(c):
    """``w¹¹ (EM − FL)``."""
    return line_uu_of_forms(reduced_forms(c))


@formula("reduced", on="surface")
def line_coefficient_uv_reduced(c):
    """``w¹¹ (EN − GL)``."""
    return line_uv_of_forms(reduced_forms(c))


@formula("reduced", on="surface")
def line_coefficient_vv_reduced(c):
    """``w¹¹ (FN − GM)``."""
    return line_vv_of_forms(reduced_forms(c))
