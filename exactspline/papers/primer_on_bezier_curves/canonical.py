"""The canonical form of a cubic: three control points at (0,0), (0,1), (1,1), and the classification by the fourth."""

from exactspline.language.formula import formula
from exactspline.language.vector import det, join
from exactspline.papers.primer_on_bezier_curves.control_points import (
    acceleration_at_the_end,
    bezier_1,
    bezier_2,
    bezier_3,
    bezier_4,
    velocity_at_the_end,
)


@formula("the canonical form, mapped₄", on="plane", symbol="x")
def mapped_x(c):
    """The first coordinate of the mapped fourth point, in the coordinates x₁ … y₄."""
    a, b, d, e = bezier_1(c), bezier_2(c), bezier_3(c), bezier_4(c)
    x1, y1, x2, y2, x3, y3, x4, y4 = a[0], a[1], b[0], b[1], d[0], d[1], e[0], e[1]
    above = -x1 + x4 - (-x1 + x2) * (-y1 + y4) / (-y1 + y2)
    return above / (-x1 + x3 - (-x1 + x2) * (-y1 + y3) / (-y1 + y2))


@formula("the canonical form, mapped₄", on="plane", symbol="y")
def mapped_y(c):
    """The second coordinate of the mapped fourth point, in the coordinates x₁ … y₄."""
    a, b, d, e = bezier_1(c), bezier_2(c), bezier_3(c), bezier_4(c)
    x1, y1, x2, y2, x3, y3, x4, y4 = a[0], a[1], b[0], b[1], d[0], d[1], e[0], e[1]
    above = (1 - (-y1 + y3) / (-y1 + y2)) * (-x1 + x4 - (-x1 + x2) * (-y1 + y4) / (-y1 + y2))
    return (-y1 + y4) / (-y1 + y2) + above / (-x1 + x3 - (-x1 + x2) * (-y1 + y3) / (-y1 + y2))


@formula("the canonical form", on="plane", symbol="U_2")
def moved_2(c):
    """The second point after T₁, which moves the first to the origin."""
    return bezier_2(c) - bezier_1(c)


@formula("the canonical form", on="plane", symbol="U_3")
def moved_3(c):
    """The third point after T₁."""
    return bezier_3(c) - bezier_1(c)


@formula("the canonical form", on="plane", symbol="U_4")
def moved_4(c):
    """The fourth point after T₁."""
    return bezier_4(c) - bezier_1(c)


@formula("the canonical form", on="plane", symbol="x_{43}")
def x43(c):
    """``(x₄ − x₂ y₄₂) / (x₃ − x₂ y₃₂)`` with ``y₄₂ = y₄/y₂`` and ``y₃₂ = y₃/y₂``, after the translation."""
    b, d, e = moved_2(c), moved_3(c), moved_4(c)
    return (e[0] - b[0] * (e[1] / b[1])) / (d[0] - b[0] * (d[1] / b[1]))


@formula("the canonical form", on="plane")
def y_by_x43(c):
    """``y₄₂ + x₄₃ (1 − y₃₂)``."""
    y2, y3, y4 = moved_2(c)[1], moved_3(c)[1], moved_4(c)[1]
    return y4 / y2 + x43(c) * (1 - y3 / y2)


@formula("the canonical form", on="plane", symbol="V_2")
def sheared_2(c):
    """The second point after T₂, which shears it onto ``x = 0``."""
    a, b = moved_2(c), moved_2(c)
    return join(b[0] - a[0] / a[1] * b[1], b[1])


@formula("the canonical form", on="plane", symbol="V_3")
def sheared_3(c):
    """The third point after T₂."""
    a, b = moved_2(c), moved_3(c)
    return join(b[0] - a[0] / a[1] * b[1], b[1])


@formula("the canonical form", on="plane", symbol="V_4")
def sheared_4(c):
    """The fourth point after T₂."""
    a, b = moved_2(c), moved_4(c)
    return join(b[0] - a[0] / a[1] * b[1], b[1])


@formula("the canonical form", on="plane", symbol="W_3")
def scaled_3(c):
    """The third point after T₃: its coordinates over ``V₃ₓ`` and ``V₂ᵧ``."""
    return join(sheared_3(c)[0] / sheared_3(c)[0], sheared_3(c)[1] / sheared_2(c)[1])


@formula("the canonical form", on="plane", symbol="W_4")
def scaled_4(c):
    """The fourth point after T₃."""
    return join(sheared_4(c)[0] / sheared_3(c)[0], sheared_4(c)[1] / sheared_2(c)[1])


@formula("the canonical form", on="plane")
def mapped_by_steps(c):
    """The fourth point after T₄, which shears by ``(1 − W₃ᵧ)/W₃ₓ``."""
    a, b = scaled_3(c), scaled_4(c)
    return join(b[0], (1 - a[1]) / a[0] * b[0] + b[1])


@formula("the canonical form", on="plane")
def mapped(c):
    """Both coordinates of the mapped fourth point."""
    return join(mapped_x(c), mapped_y(c))


@formula("the canonical form", on="plane")
def mapped_by_x43(c):
    """Both coordinates, written by means of x₄₃."""
    return join(x43(c), y_by_x43(c))


@formula("affine coordinates", on="plane")
def mapped_by_areas(c):
    """The mapped fourth point by quotients of areas: ``U₄ = α U₂ + x U₃`` is mapped to ``(x, α + x)``."""
    a, b, d = moved_2(c), moved_3(c), moved_4(c)
    return join(det(a, d) / det(a, b), (det(d, b) + det(a, d)) / det(a, b))


@formula("the canonical form", on="plane")
def sheared_2_off_axis(c):
    """The first coordinate of the second point after T₂: zero, so that it lies on ``x = 0``."""
    return sheared_2(c)[0]


@formula("the canonical form", on="plane")
def height_by_the_words(c):
    """The y coordinate of the second point, scaled by ``point2ᵧ`` as stated in the text."""
    return sheared_2(c)[1] * sheared_2(c)[1]


@formula("the canonical form", on="plane")
def height_by_the_matrix(c):
    """The y coordinate of the second point, scaled by the matrix T₃."""
    return sheared_2(c)[1] / sheared_2(c)[1]


@formula("the canonical form", on="plane")
def height_off(c):
    """The difference between this y coordinate and 1."""
    return height_by_the_matrix(c) - 1


@formula("the canonical form", on="plane")
def first_rise_squared(c):
    """``(y₂ − y₁)²``."""
    return (bezier_2(c)[1] - bezier_1(c)[1]) ** 2


@formula("the canonical form, 2", on="plane")
def cusp_edge(c):
    """``4y + x² − 2x − 3``: zero on the edge ``y = (−x² + 2x + 3)/4``."""
    x = mapped_x(c)
    return 4 * mapped_y(c) + x**2 - 2 * x - 3


@formula("the canonical form, 4", on="plane")
def start_edge(c):
    """``3y + x² − 3x``: zero on the edge ``y = (−x² + 3x)/3``."""
    x = mapped_x(c)
    return 3 * mapped_y(c) + x**2 - 3 * x


@formula("the canonical form, 3", on="plane")
def end_edge(c):
    """``(2y + x)² − 3(4x − x²)``: zero on the edge ``y = (√(3(4x − x²)) − x)/2``."""
    x = mapped_x(c)
    return (2 * mapped_y(c) + x) ** 2 - 3 * (4 * x - x**2)


@formula("the canonical form, 5", on="plane")
def single_inflection_edge(c):
    """``1 − y``: negative beyond ``y = 1``."""
    return 1 - mapped_y(c)


@formula("cusps of a cubic", on="plane")
def cusp_condition(c):
    """``[p′ p‴]² − 2 [p′ p″] [p″ p‴]``: the discriminant of ``[γ′ γ″]`` along the cubic."""
    a, b, d = c.p.d(1), c.p.d(2), c.p.d(3)
    return det(a, d) ** 2 - 2 * det(a, b) * det(b, d)


@formula("a cubic through its start", on="plane")
def start_condition(c):
    """Zero if ``p′ + p″s/2 + p‴s²/6`` vanishes for some s: the cubic passes through its start again."""
    a, b, d = c.p.d(1), c.p.d(2) / 2, c.p.d(3) / 6
    return det(a, d) ** 2 - det(a, b) * det(b, d)


@formula("a cubic through its end", on="plane")
def end_condition(c):
    """Zero if the cubic passes through its end at another parameter."""
    a, b, d = velocity_at_the_end(c), acceleration_at_the_end(c) / 2, c.p.d(3) / 6
    return det(a, d) ** 2 - det(a, b) * det(b, d)


@formula("inflections between the ends", on="plane")
def turning_at_both_ends(c):
    """``[γ′ γ″]`` at the start times ``[γ′ γ″]`` at the end: negative if the cubic has an odd number of inflections in
    between.
    """
    return det(c.p.d(1), c.p.d(2)) * det(velocity_at_the_end(c), acceleration_at_the_end(c))


@formula("the canonical form", on="plane")
def first_triangle(c):
    """Twice the area of the triangle of the first three control points."""
    return det(moved_2(c), moved_3(c))
