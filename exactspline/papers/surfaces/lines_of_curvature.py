"""Lines of curvature: ``A du² + B du dv + C dv² = 0``; umbilics, where all three coefficients vanish."""

from exactspline.language.formula import formula
from exactspline.papers.surfaces.fundamental_forms import E, F, G, L, M, N


@formula("lines of curvature", on="surface", symbol="A")
def line_coefficient_uu(c):
    """``EM − FL``, the coefficient of du²."""
    return E(c) * M(c) - F(c) * L(c)


@formula("lines of curvature", on="surface", symbol="B")
def line_coefficient_uv(c):
    """``EN − GL``, the coefficient of du dv."""
    return E(c) * N(c) - G(c) * L(c)


@formula("lines of curvature", on="surface", symbol="C")
def line_coefficient_vv(c):
    """``FN − GM``, the coefficient of dv²."""
    return F(c) * N(c) - G(c) * M(c)
