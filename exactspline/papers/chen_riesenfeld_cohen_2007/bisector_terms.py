"""§6: the terms of the determinants, the entries of the matrices, and the displays of §6.2 as printed."""

from exactspline.language.formula import formula
from exactspline.language.rational import cramer
from exactspline.language.ruled import ruled
from exactspline.language.vector import cross, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.bisector import (
    bisector_determinant_polynomial,
    middle_height,
    middle_normal,
    normal_height,
    plane_bisector_polynomial,
    point_bisector_determinant_polynomial,
    point_bisector_directrix,
    point_bisector_directrix_levelled,
    point_bisector_directrix_polynomial,
    point_bisector_directrix_printed,
    point_bisector_generator,
    point_bisector_generator_polynomial,
    point_middle_height_polynomial,
    second_height,
    second_normal,
    through_point_height,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D1, velocity


def _rows(c):
    """The normals of the rows of (22)."""
    return velocity(c.first), second_normal(c), middle_normal(c)


def _product(rows, columns):
    """One term of a determinant: an entry of each row, from these columns."""
    i, j, k = columns
    return rows[0][i] * rows[1][j] * rows[2][k]


@formula("eq. (23), D", on="pair")
def determinant_term_1(c):
    """The term of D from the columns 0, 1, 2."""
    return _product(_rows(c), (0, 1, 2))


@formula("eq. (23), D", on="pair")
def determinant_term_2(c):
    """The term of D from the columns 1, 2, 0."""
    return _product(_rows(c), (1, 2, 0))


@formula("eq. (23), D", on="pair")
def determinant_term_3(c):
    """The term of D from the columns 2, 0, 1."""
    return _product(_rows(c), (2, 0, 1))


@formula("eq. (23), D", on="pair")
def determinant_term_4(c):
    """The term of D from the columns 0, 2, 1."""
    return _product(_rows(c), (0, 2, 1))


@formula("eq. (23), D", on="pair")
def determinant_term_5(c):
    """The term of D from the columns 1, 0, 2."""
    return _product(_rows(c), (1, 0, 2))


@formula("eq. (23), D", on="pair")
def determinant_term_6(c):
    """The term of D from the columns 2, 1, 0."""
    return _product(_rows(c), (2, 1, 0))


@formula("eq. (23), D", on="pair")
def determinant_of_six_terms(c):
    """The sum of the six terms of D, with their signs."""
    plus = determinant_term_1(c) + determinant_term_2(c) + determinant_term_3(c)
    return plus - (determinant_term_4(c) + determinant_term_5(c) + determinant_term_6(c))


@formula("eq. (25), D0", on="pair")
def numerator_term_1(c):
    """The term of D0 with the height of the first row, columns 1, 2 of the others."""
    return normal_height(c.first) * second_normal(c)[1] * middle_normal(c)[2]


@formula("eq. (25), D0", on="pair")
def numerator_term_2(c):
    """The term of D0 with the height of the first row, columns 2, 1 of the others."""
    return normal_height(c.first) * second_normal(c)[2] * middle_normal(c)[1]


@formula("eq. (25), D0", on="pair")
def numerator_term_3(c):
    """The term of D0 with the height of the second row, columns 1, 2 of the others."""
    return velocity(c.first)[1] * second_height(c) * middle_normal(c)[2]


@formula("eq. (25), D0", on="pair")
def numerator_term_4(c):
    """The term of D0 with the height of the second row, columns 2, 1 of the others."""
    return velocity(c.first)[2] * second_height(c) * middle_normal(c)[1]


@formula("eq. (25), D0", on="pair")
def numerator_term_5(c):
    """The term of D0 with the height of the third row, columns 1, 2 of the others."""
    return velocity(c.first)[1] * second_normal(c)[2] * middle_height(c)


@formula("eq. (25), D0", on="pair")
def numerator_term_6(c):
    """The term of D0 with the height of the third row, columns 2, 1 of the others."""
    return velocity(c.first)[2] * second_normal(c)[1] * middle_height(c)


@formula("eq. (23), D0", on="pair")
def numerator_first_component(c):
    """D0 by Cramer's rule for (22)."""
    first = velocity(c.first), normal_height(c.first)
    second, middle = (second_normal(c), second_height(c)), (middle_normal(c), middle_height(c))
    return cramer(first, second, middle)[0]


@formula("§6.1, the first two terms of D0", on="pair")
def numerator_pair_1(c):
    """The two terms of D0 with the height of the first row."""
    return numerator_term_1(c) - numerator_term_2(c)


@formula("§6.1, two terms of D0", on="pair")
def numerator_pair_2(c):
    """The two terms of D0 with the height of the second row."""
    return numerator_term_4(c) - numerator_term_3(c)


@formula("§6.1, the last two terms of D0", on="pair")
def numerator_pair_3(c):
    """The two terms of D0 with the height of the third row."""
    return numerator_term_5(c) - numerator_term_6(c)


@formula("eq. (25), D0", on="pair")
def numerator_of_six_terms(c):
    """The sum of the six terms of D0, with their signs."""
    return numerator_pair_1(c) + numerator_pair_2(c) + numerator_pair_3(c)


@formula("eq. (25), the denominators of its first row")
def denominator_of_velocity(c):
    """``w²``: the denominator of γ′."""
    return c.w**2


@formula("eq. (25), the denominators of its first row")
def denominator_of_height(c):
    """``w³``: the denominator of γ·γ′."""
    return c.w**3


@formula("§6.1, below eq. (29)", on="pair")
def bisector_denominator(c):
    """``Dw``: the denominator of the bisector by (27), (28)."""
    return bisector_determinant_polynomial(c) * c.first.w


@formula("§6.2, footnote c", on="point")
def foot_second_order(c):
    """``‖γ′‖² − (δ − γ)·γ″``: half of the second derivative of the squared distance from δ to γ at the foot point;
    where it is negative, the foot point is a local maximum of the distance from δ.
    """
    offset = point_bisector_directrix_polynomial(c) - c.gamma
    return norm2(c.gamma.d(1)) - dot(offset, c.gamma.d(2))


@formula("§6.2, footnote c", on="point")
def directrix_velocity_along_tangent(c):
    """``δ′·γ′``."""
    return dot(point_bisector_directrix_polynomial(c).d(1), c.gamma.d(1))


@formula("eq. (31)", on="point")
def directrix_through_point_plane(c):
    """``(δ − Q)·(γ′ × (γ − Q))``: zero when δ lies in the third plane."""
    return dot(point_bisector_directrix(c) - c.point, point_bisector_generator(c))


@formula("§6.2.1, the third plane", on="point")
def point_in_third_plane(c):
    """``Q·(γ′ × (γ − Q))`` minus the height of the third row of (31): zero if its plane passes through Q."""
    return dot(point_bisector_generator(c), c.point) - through_point_height(c)


@formula("§6.2, footnote e", on="point")
def point_bisector_by_numerator(c):
    """The surface of (31) with the generator replaced by its numerator."""
    return ruled(point_bisector_directrix_levelled(c), point_bisector_generator_polynomial(c))


@formula("eq. (34), as printed", on="point")
def point_middle_height_printed_in_full(c):
    """``½(‖p‖² − w²‖Q‖²) + ½w(w − 1)‖Q‖²``: the last height of (34) and the error of the printed one."""
    return point_middle_height_polynomial(c) + c.w * (c.w - 1) * norm2(c.point) / 2


@formula("§6.2.1, below eq. (34)", on="point")
def directrix_denominator(c):
    """The determinant of (34) times w: the denominator of the directrix."""
    return point_bisector_determinant_polynomial(c) * c.w


@formula("eq. (34), as printed", on="point")
def point_bisector_printed(c):
    """The surface of (34) with the last height as printed."""
    return ruled(point_bisector_directrix_printed(c), cross(D1(c), c.gamma - c.point))


@formula("eq. (34), as printed", on="point")
def point_bisector_printed_by_numerator(c):
    """The surface of (34) with the last height as it is printed and the numerator of its generator."""
    return ruled(point_bisector_directrix_printed(c), point_bisector_generator_polynomial(c))


@formula("§6.2.2", on="point")
def point_bisector_with_another_directrix(c):
    """The surface with the directrix ``δ + xG`` for an arbitrary function x, here the first coordinate of p."""
    generator = cross(D1(c), c.gamma - c.point)
    return ruled(point_bisector_directrix_polynomial(c) + generator * c.p[0], generator)


@formula("§6.2.2, (4), in another plane", on="plane point")
def tilted_plane_bisector_slope(c):
    """The derivative of the height of the planar bisector in a tilted plane, that of the points ``(3x/5, y, 4x/5)``."""
    return plane_bisector_polynomial(c)[0].d(1) * 4 / 5
