"""``ImplicitSurface3.h``: the surface F(x, y, z) = 0, with L the length of its gradient DF.

The directions a = γ′ and b = DF × a are orthogonal and tangent to the surface; ``|b|² = L²|a|²``.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, join, norm2, triple

PLACE = "ImplicitSurface3.h, GetPrincipalInformation"


@formula(PLACE, on="implicit surface")
def length_squared(c):
    """``L²``."""
    return norm2(c.gradient_f)


@formula(PLACE, on="implicit surface")
def hessian_on_gradient(c):
    """``D²F DF``."""
    g = c.gradient_f
    return join(dot(c.hessian_fx, g), dot(c.hessian_fy, g), dot(c.hessian_fz, g))


@formula(PLACE, on="implicit surface")
def mean_in_the_comment(c):
    """``2L³`` times ``0.5 [trace(D²F)/L − (DFᵀ D²F DF)/L³]``."""
    trace = c.fxx + c.fyy + c.fzz
    return trace * length_squared(c) - dot(c.gradient_f, hessian_on_gradient(c))


@formula(PLACE, on="implicit surface")
def mean_in_the_code(c):
    """``2L³`` times ``meanCurv``."""
    xx, yy, zz = c.fx * c.fx, c.fy * c.fy, c.fz * c.fz
    mixed = c.fxy * (c.fx * c.fy) + c.fxz * (c.fx * c.fz) + c.fyz * (c.fy * c.fz)
    return c.fxx * (yy + zz) + c.fyy * (xx + zz) + c.fzz * (xx + yy) - 2 * mixed


@formula(PLACE, on="implicit surface")
def adjugate_1(c):
    """The first row of ``adj(D²F)`` according to the comment."""
    return join(c.fyy * c.fzz - c.fyz * c.fyz, c.fyz * c.fxz - c.fxy * c.fzz, c.fxy * c.fyz - c.fxz * c.fyy)


@formula(PLACE, on="implicit surface")
def adjugate_2(c):
    """The second row."""
    return join(c.fyz * c.fxz - c.fxy * c.fzz, c.fxx * c.fzz - c.fxz * c.fxz, c.fxy * c.fxz - c.fxx * c.fyz)


@formula(PLACE, on="implicit surface")
def adjugate_3(c):
    """The third row."""
    return join(c.fxy * c.fyz - c.fxz * c.fyy, c.fxy * c.fxz - c.fxx * c.fyz, c.fxx * c.fyy - c.fxy * c.fxy)


@formula("Hessian matrix", on="implicit surface")
def minors_1(c):
    """The first row of the adjugate by cross products of rows."""
    return cross(c.hessian_fy, c.hessian_fz)


@formula("Hessian matrix", on="implicit surface")
def minors_2(c):
    """The second row."""
    return cross(c.hessian_fz, c.hessian_fx)


@formula("Hessian matrix", on="implicit surface")
def minors_3(c):
    """The third row."""
    return cross(c.hessian_fx, c.hessian_fy)


@formula(PLACE, on="implicit surface")
def gauss_in_the_comment(c):
    """``L⁴`` times ``[DFᵀ adj(D²F) DF]/L⁴``."""
    g = c.gradient_f
    return c.fx * dot(adjugate_1(c), g) + c.fy * dot(adjugate_2(c), g) + c.fz * dot(adjugate_3(c), g)


@formula(PLACE, on="implicit surface")
def gauss_in_the_code(c):
    """``L⁴`` times ``gaussCurv``."""
    xx, yy, zz = c.fx * c.fx, c.fy * c.fy, c.fz * c.fz
    xy, xz, yz = c.fx * c.fy, c.fx * c.fz, c.fy * c.fz
    plain = xx * (c.fyy * c.fzz - c.fyz * c.fyz) + yy * (c.fxx * c.fzz - c.fxz * c.fxz)
    first = xy * (c.fxz * c.fyz - c.fxy * c.fzz) + xz * (c.fxy * c.fyz - c.fxz * c.fyy)
    return plain + zz * (c.fxx * c.fyy - c.fxy * c.fxy) + 2 * (first + yz * (c.fxy * c.fxz - c.fxx * c.fyz))


@formula("second fundamental form", on="implicit surface", symbol="b")
def across(c):
    """``b = DF × γ′``: tangent to the surface and orthogonal to the curve."""
    return cross(c.gradient_f, c.gamma.d(1))


@formula("second fundamental form", on="implicit surface")
def right_handed(c):
    """``[DF γ′ b]``: DF, γ′ and b are a right-handed frame where it is positive."""
    return triple(c.gradient_f, c.gamma.d(1), across(c))


def _form(c, u, v):
    """``uᵀ D²F v``."""
    return dot(u, join(dot(c.hessian_fx, v), dot(c.hessian_fy, v), dot(c.hessian_fz, v)))


@formula("second fundamental form", on="implicit surface")
def form_along(c):
    """``aᵀ D²F a`` for a = γ′."""
    return _form(c, c.gamma.d(1), c.gamma.d(1))


@formula("second fundamental form", on="implicit surface")
def form_across(c):
    """``bᵀ D²F b``."""
    return _form(c, across(c), across(c))


@formula("second fundamental form", on="implicit surface")
def form_mixed(c):
    """``aᵀ D²F b``."""
    return _form(c, c.gamma.d(1), across(c))


@formula("second fundamental form", on="implicit surface")
def height_over_the_surface(c):
    """``−DF·γ″``: the normal curvature of γ times ``−L ‖γ′‖²``."""
    return -dot(c.gradient_f, c.gamma.d(2))


@formula("Euler's theorem", on="implicit surface")
def sum_of_the_form(c):
    """``L² aᵀD²Fa + bᵀD²Fb``: the sum of two orthogonal normal curvatures times ``L³‖γ′‖²``."""
    return form_along(c) * length_squared(c) + form_across(c)


@formula("Theorema egregium", on="implicit surface")
def determinant_of_the_form(c):
    """``(aᵀD²Fa)(bᵀD²Fb) − (aᵀD²Fb)²``."""
    return form_along(c) * form_across(c) - form_mixed(c) ** 2


@formula(PLACE, on="implicit surface", symbol="m_0")
def shape_row_0(c):
    """``L³ (m00, m01, m02)``: the sum of the terms of the code over one power of L."""
    n = length_squared(c)
    weights = join(c.fx * c.fx - n, c.fx * c.fy, c.fx * c.fz)
    return join(dot(weights, c.hessian_fx), dot(weights, c.hessian_fy), dot(weights, c.hessian_fz))


@formula(PLACE, on="implicit surface", symbol="m_1")
def shape_row_1(c):
    """``L³ (m10, m11, m12)``."""
    n = length_squared(c)
    weights = join(c.fy * c.fx, c.fy * c.fy - n, c.fy * c.fz)
    return join(dot(weights, c.hessian_fx), dot(weights, c.hessian_fy), dot(weights, c.hessian_fz))


@formula(PLACE, on="implicit surface", symbol="m_2")
def shape_row_2(c):
    """``L³ (m20, m21, m22)``."""
    n = length_squared(c)
    weights = join(c.fz * c.fx, c.fz * c.fy, c.fz * c.fz - n)
    return join(dot(weights, c.hessian_fx), dot(weights, c.hessian_fy), dot(weights, c.hessian_fz))


@formula(PLACE, on="implicit surface")
def gradient_on_shape(c):
    """``DFᵀ m``: zero, so that m has the eigenvalue 0."""
    return shape_row_0(c) * c.fx + shape_row_1(c) * c.fy + shape_row_2(c) * c.fz


@formula(PLACE, on="implicit surface")
def trace_of_shape(c):
    """``L³`` times the trace of m."""
    return shape_row_0(c)[0] + shape_row_1(c)[1] + shape_row_2(c)[2]


@formula(PLACE, on="implicit surface")
def minors_of_shape(c):
    """``L⁶`` times the sum of the principal minors of m."""
    a, b, e = shape_row_0(c), shape_row_1(c), shape_row_2(c)
    return a[0] * b[1] - a[1] * b[0] + a[0] * e[2] - a[2] * e[0] + b[1] * e[2] - b[2] * e[1]


@formula(PLACE, on="implicit surface")
def principal_discriminant(c):
    """``4L⁶ (meanCurv² − gaussCurv)``: the radicand for the principal curvatures."""
    return mean_in_the_code(c) ** 2 - 4 * length_squared(c) * gauss_in_the_code(c)


@formula("Euler's theorem", on="implicit surface")
def form_difference(c):
    """``L² aᵀD²Fa − bᵀD²Fb``: the difference of the two normal curvatures, times ``L³‖γ′‖²``."""
    return form_along(c) * length_squared(c) - form_across(c)


@formula("Euler's theorem", on="implicit surface")
def form_mixed_on_gradient(c):
    """``2 (aᵀD²Fb) DF``, with length ``2L |aᵀD²Fb|``."""
    return c.gradient_f * (2 * form_mixed(c))
