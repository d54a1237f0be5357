"""Cubic Bézier curves in terms of control points, and quantities that the Primer derives from them.

The control points are those of the cubic over an interval of length 1 that begins at the parameter of the formula. They
are values of the blossom, so that a statement about "x₁ … y₄" is a statement about derivatives at this parameter.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, join, norm2


@formula("derivatives", symbol="P_1")
def bezier_1(c):
    """First control point: the curve itself."""
    return c.p


@formula("derivatives", symbol="P_2")
def bezier_2(c):
    """Second control point, ``p + p′/3``."""
    return c.p + c.p.d(1) / 3


@formula("derivatives", symbol="P_3")
def bezier_3(c):
    """Third control point, ``p + 2p′/3 + p″/6``."""
    return c.p + c.p.d(1) * 2 / 3 + c.p.d(2) / 6


@formula("derivatives", symbol="P_4")
def bezier_4(c):
    """Fourth control point, ``p + p′ + p″/2 + p‴/6``: the end of a cubic."""
    return c.p + c.p.d(1) + c.p.d(2) / 2 + c.p.d(3) / 6


@formula("derivatives", symbol="A'")
def derivative_weight_1(c):
    """``3 (B − A)``."""
    return 3 * (bezier_2(c) - bezier_1(c))


@formula("derivatives", symbol="B'")
def derivative_weight_2(c):
    """``3 (C − B)``."""
    return 3 * (bezier_3(c) - bezier_2(c))


@formula("derivatives", symbol="C'")
def derivative_weight_3(c):
    """``3 (D − C)``."""
    return 3 * (bezier_4(c) - bezier_3(c))


@formula("derivatives", symbol="A''")
def second_derivative_weight_1(c):
    """``2 (B′ − A′)``."""
    return 2 * (derivative_weight_2(c) - derivative_weight_1(c))


@formula("derivatives", symbol="B''")
def second_derivative_weight_2(c):
    """``2 (C′ − B′)``."""
    return 2 * (derivative_weight_3(c) - derivative_weight_2(c))


@formula("derivatives", symbol="A'''")
def third_derivative_weight(c):
    """``1 (B″ − A″)``."""
    return second_derivative_weight_2(c) - second_derivative_weight_1(c)


@formula("derivatives")
def velocity_at_the_end(c):
    """The derivative of a cubic where its control points end, ``p′ + p″ + p‴/2``."""
    return c.p.d(1) + c.p.d(2) + c.p.d(3) / 2


@formula("derivatives")
def acceleration_at_the_end(c):
    """The second derivative of a cubic where its control points end, ``p″ + p‴``."""
    return c.p.d(2) + c.p.d(3)


@formula("extremities")
def extremities_a(c):
    """``3 (−p₁ + 3p₂ − 3p₃ + p₄)``: the coefficient of t² in the derivative of a cubic."""
    return 3 * (-bezier_1(c) + 3 * bezier_2(c) - 3 * bezier_3(c) + bezier_4(c))


@formula("extremities")
def extremities_a_by_v(c):
    """``v₁ − 2v₂ + v₃``."""
    return derivative_weight_1(c) - 2 * derivative_weight_2(c) + derivative_weight_3(c)


@formula("extremities")
def extremities_b(c):
    """``6 (p₁ − 2p₂ + p₃)``: the coefficient of t."""
    return 6 * (bezier_1(c) - 2 * bezier_2(c) + bezier_3(c))


@formula("reordering", symbol="Q_2")
def quadratic_2(c):
    """The middle control point of a quadratic curve, ``p + p′/2``."""
    return c.p + c.p.d(1) / 2


@formula("reordering", symbol="Q_3")
def quadratic_3(c):
    """The last control point of a quadratic curve, ``p + p′ + p″/2``."""
    return c.p + c.p.d(1) + c.p.d(2) / 2


@formula("reordering")
def elevated_2(c):
    """``1/3 start + 2/3 control``."""
    return bezier_1(c) / 3 + quadratic_2(c) * 2 / 3


@formula("reordering")
def elevated_3(c):
    """``2/3 control + 1/3 end``."""
    return quadratic_2(c) * 2 / 3 + quadratic_3(c) / 3


@formula("inflections", on="plane")
def turning(c):
    """``[p′ p‴]``: the derivative of ``[p′ p″]``."""
    return det(c.p.d(1), c.p.d(3))


@formula("inflections", on="plane")
def second_turning(c):
    """``[p″ p‴]``: the second derivative of ``[p′ p″]`` for a cubic."""
    return det(c.p.d(2), c.p.d(3))


@formula("inflections, the full formula", on="plane")
def inflection_coefficient_2(c):
    """The coefficient of t² in C(t), printed as ten terms."""
    a, b, d, e = bezier_1(c), bezier_2(c), bezier_3(c), bezier_4(c)
    x1, y1, x2, y2, x3, y3, x4, y4 = a[0], a[1], b[0], b[1], d[0], d[1], e[0], e[1]
    first = -18 * x2 * y1 + 36 * x3 * y1 - 18 * x4 * y1 + 18 * x1 * y2 - 54 * x3 * y2
    second = 36 * x4 * y2 - 36 * x1 * y3 + 54 * x2 * y3 - 18 * x4 * y3 + 18 * x1 * y4
    return first + second - 36 * x2 * y4 + 18 * x3 * y4


@formula("inflections, the full formula", on="plane")
def inflection_coefficient_1(c):
    """The coefficient of t in C(t)."""
    a, b, d, e = bezier_1(c), bezier_2(c), bezier_3(c), bezier_4(c)
    x1, y1, x2, y2, x3, y3, x4, y4 = a[0], a[1], b[0], b[1], d[0], d[1], e[0], e[1]
    first = 36 * x2 * y1 - 54 * x3 * y1 + 18 * x4 * y1 - 36 * x1 * y2
    return first + 54 * x3 * y2 - 18 * x4 * y2 + 54 * x1 * y3 - 54 * x2 * y3 - 18 * x1 * y4 + 18 * x2 * y4


@formula("inflections, the full formula", on="plane")
def inflection_coefficient_0(c):
    """The constant coefficient of C(t)."""
    a, b, d = bezier_1(c), bezier_2(c), bezier_3(c)
    x1, y1, x2, y2, x3, y3 = a[0], a[1], b[0], b[1], d[0], d[1]
    return -18 * x2 * y1 + 18 * x3 * y1 + 18 * x1 * y2 - 18 * x3 * y2 - 18 * x1 * y3 + 18 * x2 * y3


@formula("inflections", on="plane", symbol="h")
def chord(c):
    """The vector from the first control point to the last, with which the curve is aligned."""
    return bezier_4(c) - bezier_1(c)


@formula("inflections", on="plane", symbol=r"\|h\|^2")
def chord_squared(c):
    """The squared length of the chord."""
    return norm2(chord(c))


@formula("inflections, aligned", on="plane", symbol="A_2")
def aligned_2(c):
    """The second control point after aligning, scaled by the length of the chord."""
    return join(dot(chord(c), bezier_2(c) - bezier_1(c)), det(chord(c), bezier_2(c) - bezier_1(c)))


@formula("inflections, aligned", on="plane", symbol="A_3")
def aligned_3(c):
    """The third control point after aligning, scaled in the same way."""
    return join(dot(chord(c), bezier_3(c) - bezier_1(c)), det(chord(c), bezier_3(c) - bezier_1(c)))


@formula("inflections, aligned", on="plane")
def aligned_t2_printed(c):
    """``3x₃y₂ + 2x₄y₂ + 3x₂y₃ − x₄y₃``: the coefficient of t² as first printed."""
    b, d, x4 = aligned_2(c), aligned_3(c), chord_squared(c)
    x2, y2, x3, y3 = b[0], b[1], d[0], d[1]
    return 3 * x3 * y2 + 2 * x4 * y2 + 3 * x2 * y3 - x4 * y3


@formula("inflections, aligned", on="plane", symbol="X")
def aligned_t2(c):
    """``−3a + 2b + 3c − d``: the coefficient of t² as printed next."""
    b, d, x4 = aligned_2(c), aligned_3(c), chord_squared(c)
    x2, y2, x3, y3 = b[0], b[1], d[0], d[1]
    return -3 * (x3 * y2) + 2 * (x4 * y2) + 3 * (x2 * y3) - x4 * y3


@formula("inflections, aligned", on="plane")
def aligned_t2_slip(c):
    """The error of the coefficient as first printed."""
    return aligned_t2_printed(c) - aligned_t2(c)


@formula("inflections, aligned", on="plane")
def first_term_twice(c):
    """``2 · 3x₃y₂``: the error caused by a wrong sign of the first term."""
    return 6 * aligned_3(c)[0] * aligned_2(c)[1]


@formula("inflections, aligned", on="plane", symbol="Y")
def aligned_t1(c):
    """``3a − b − 3c``: the coefficient of t."""
    b, d, x4 = aligned_2(c), aligned_3(c), chord_squared(c)
    x2, y2, x3, y3 = b[0], b[1], d[0], d[1]
    return 3 * (x3 * y2) - x4 * y2 - 3 * (x2 * y3)


@formula("inflections, aligned", on="plane", symbol="Z")
def aligned_t0(c):
    """``c − a``: the constant coefficient."""
    b, d = aligned_2(c), aligned_3(c)
    return b[0] * d[1] - d[0] * b[1]


@formula("inflections", on="plane")
def inflection_discriminant(c):
    """``y² − 4xz``: the discriminant of C(t)."""
    return aligned_t1(c) ** 2 - 4 * aligned_t2(c) * aligned_t0(c)
