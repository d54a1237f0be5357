"""``ImplicitCurve2.h``: the curve F(x, y) = 0."""

from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, join, norm2


@formula("ImplicitCurve2.h, GetCurvature", on="implicit")
def implicit_curvature_numerator(c):
    """``−Fy²Fxx + 2FxFyFxy − Fx²Fyy``."""
    return -c.fy * c.fy * c.fxx + 2 * c.fx * c.fy * c.fxy - c.fx * c.fx * c.fyy


@formula("ImplicitCurve2.h, GetCurvature", on="implicit", symbol=r"\|\nabla F\|^2")
def gradient_squared(c):
    """``Fx² + Fy²``."""
    return c.fx * c.fx + c.fy * c.fy


@formula("ImplicitCurve2.h, GetCurvature", on="implicit")
def implicit_curvature_squared(c):
    """The square of the curvature."""
    return implicit_curvature_numerator(c) ** 2 / gradient_squared(c) ** 3


@formula("ImplicitCurve2.h", on="implicit", symbol=r"\lambda")
def pace_of_the_curve(c):
    """The factor of ``(−Fy, Fx)`` in the velocity of the curve."""
    return c.pace


@formula("ImplicitCurve2.h, GetFrame", on="implicit")
def implicit_tangent(c):
    """``−Perp(∇F) = (−Fy, Fx)``, not normalized: the result of ComputeOrthogonalComplement for the gradient."""
    return join(-c.fy, c.fx)


@formula("ImplicitCurve2.h, GetFrame", on="implicit")
def implicit_normal(c):
    """The gradient, not normalized."""
    return c.gradient_f


@formula("ImplicitCurve2.h, GetFrame", on="implicit")
def tangent_then_normal(c):
    """``[T N]``: positive for a right-handed pair."""
    return det(implicit_tangent(c), implicit_normal(c))


@formula("ImplicitCurve2.h, GetFrame", on="implicit")
def tangent_on_normal(c):
    """``T·N``."""
    return dot(implicit_tangent(c), implicit_normal(c))


@formula("ImplicitCurve2.h, GetFrame", on="implicit")
def tangent_off_the_curve(c):
    """``[T γ′]``: zero if T is tangent to the curve."""
    return det(implicit_tangent(c), c.gamma.d(1))


@formula("ImplicitCurve2.h, GetCurvature", on="implicit")
def implicit_bending(c):
    """``κN`` with curvature and normal as computed in the code."""
    return implicit_normal(c) * (implicit_curvature_numerator(c) / gradient_squared(c) ** 2)


@formula("ImplicitCurve2.h, GetHessian", on="implicit")
def hessian_on_the_tangent(c):
    """``Tᵀ D²F T`` for the matrix of GetHessian."""
    t = implicit_tangent(c)
    return dot(t, join(dot(c.hessian_fx, t), dot(c.hessian_fy, t)))


@formula("ImplicitCurve2.h", on="implicit")
def height_of_the_acceleration(c):
    """``∇F·γ″``."""
    return dot(c.gradient_f, c.gamma.d(2))


@formula("ImplicitCurve2.h", on="implicit")
def implicit_speed_squared(c):
    """``‖γ′‖²``."""
    return norm2(c.gamma.d(1))
