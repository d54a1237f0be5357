"""Alternative expressions with which claims compare formulas of the paper, so that an error in either is detected."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.bisector import (
    point_bisector_determinant_polynomial,
    point_bisector_direct_x,
    point_bisector_direct_y,
    point_bisector_directrix_polynomial,
    point_bisector_directrix_printed,
    point_bisector_generator_polynomial,
    point_bisector_polynomial,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D1, D1_D3, D2, D21, jerk_term_21_1, jerk_term_21_2
from exactspline.papers.chen_riesenfeld_cohen_2007.space import binormal, psi, rectifying_developable


@formula("Remark 3.2, last display")
def jerk_term_21_parts(c):
    """``(w′/w³) D2 − (w″/w³) D1``: D21/w² by its parts along D2 and D1."""
    return jerk_term_21_2(c) - jerk_term_21_1(c)


@formula("eq. (5)", on="plane")
def velocity_jerk_by_terms(c):
    """``[γ′ γ‴]`` with γ‴ by eq. (5): the terms remaining next to [D1 D3]."""
    return (D1_D3(c) + det(D1(c), D21(c))) / c.w**4 - (4 * c.w.d(1) / c.w**5) * det(D1(c), D2(c))


@formula("§5.5", on="space")
def psi_along_binormal(c):
    """``Ψ·(γ′ × γ″)``."""
    return dot(psi(c), binormal(c))


@formula("definition of a geodesic", on="space")
def rectifying_surface_normal(c):
    """``γ′ × G``: the normal of the rectifying developable with generator G, along γ."""
    return cross(c.gamma.d(1), rectifying_developable(c).generator)


@formula("eq. (34), as printed", on="point")
def point_bisector_misprint(c):
    """The error of the directrix with the height as printed."""
    return point_bisector_directrix_printed(c) - point_bisector_directrix_polynomial(c)


@formula("eq. (34), as printed", on="point")
def point_bisector_misprint_by_height(c):
    """The error of the directrix with the height as printed, from the difference ``½(w² − w)‖Q‖²`` of the heights."""
    along = cross(D1(c), point_bisector_generator_polynomial(c))
    return along * ((c.w - 1) * norm2(c.point)) / (2 * point_bisector_determinant_polynomial(c))


@formula("eq. (34)", on="point")
def generator_of_34(c):
    """The generator of the polynomial form of the point/curve bisector."""
    return point_bisector_polynomial(c).generator


@formula("§6.2, direct approach", on="point")
def direct_x_of_directrix(c):
    """The first component of the directrix of the direct form in which it is the ruling parameter."""
    return dot(c.axis_x, point_bisector_direct_x(c).directrix)


@formula("§6.2, direct approach", on="point")
def direct_y_of_directrix(c):
    """The second component of the directrix of the direct form in which it is the ruling parameter."""
    return dot(c.axis_y, point_bisector_direct_y(c).directrix)


@formula("§6.2, direct approach", on="point")
def generator_x(c):
    """The first component of ``D1 × (p − wQ)``."""
    return point_bisector_generator_polynomial(c)[0]


@formula("§6.2, direct approach", on="point")
def generator_y(c):
    """The second component of ``D1 × (p − wQ)``."""
    return point_bisector_generator_polynomial(c)[1]


@formula("eq. (31)", on="point")
def through_point_height_by_determinant(c):
    """``[Q γ′ γ]``, which equals ``Q·(γ′ × (γ − Q))``."""
    return det(c.point, c.gamma.d(1), c.gamma)
