"""Lines of curvature: ``A du² + B du dv + C dv² = 0``; umbilics, where all three coefficients vanish."""

from exactspline.formulas.surfaces.by_forms import line_uu_of_forms, line_uv_of_forms, line_vv_of_forms
from exactspline.formulas.surfaces.curvatures import forms, reduced_forms
from exactspline.formulas.surfaces.fundamental_forms import S_u, S_v, normal
from exactspline.language.formula import formula
from exactspline.language.vector import det


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
