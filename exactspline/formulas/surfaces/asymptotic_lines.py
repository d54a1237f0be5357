"""Asymptotic directions, in which the normal curvature vanishes: the roots of ``L du² + 2M du dv + N dv² = 0``.

These directions are ``(√δ − M : L)`` and ``(−√δ − M : L)`` with ``δ = M² − LN``, and also ``(N : −M ∓ √δ)``. The root
is adjoined, so that statements proved for one sign of √δ hold for the other sign.
"""

from exactspline.formulas.surfaces.curves_on_surfaces import second_form, second_form_lifted
from exactspline.formulas.surfaces.fundamental_forms import (
    E_reduced,
    F_reduced,
    G_reduced,
    L,
    M,
    N,
    S_u,
    S_uu,
    S_v,
    S_vv,
    normal,
)
from exactspline.formulas.surfaces.lifted import L_lifted, M_lifted, N_lifted, area_squared_lifted
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, join


def _with_root(c):
    """The root √δ, and the coefficients L, M, N lifted to the extension by it."""
    square = asymptotic_discriminant(c)
    root = Adjoined(square.constant(0), square.constant(1), square)
    return root, root.lifted(c.L), root.lifted(c.M), root.lifted(c.N)


def _along(L, M, N, u, v):
    """``L u² + 2M u v + N v²``."""
    return L * u * u + 2 * M * u * v + N * v * v


@formula("asymptotic lines", on="forms", symbol=r"\delta")
def asymptotic_discriminant(c):
    """``M² − LN``: two asymptotic directions where it is positive, one where it is zero, none where it is negative."""
    return c.M**2 - c.L * c.N


@formula("asymptotic lines", on="forms")
def second_form_of_asymptotic(c):
    """``II(t, t)`` for the direction ``t = (√δ − M, L)``: the part free of √δ and the coefficient of √δ."""
    root, second, mixed, last = _with_root(c)
    value = _along(second, mixed, last, root - mixed, second)
    return join(value.plain, value.rooted)


@formula("asymptotic lines", on="forms")
def second_form_of_other_asymptotic(c):
    """``II(t, t)`` for ``t = (N, −M − √δ)``, split in the same way."""
    root, second, mixed, last = _with_root(c)
    value = _along(second, mixed, last, last, -mixed - root)
    return join(value.plain, value.rooted)


@formula("asymptotic lines", on="forms")
def asymptotic_charts(c):
    """The determinant of ``(√δ − M, L)`` and ``(N, −M − √δ)``: the two directions coincide where it vanishes."""
    root, second, mixed, last = _with_root(c)
    value = (root - mixed) * (-mixed - root) - second * last
    return join(value.plain, value.rooted)


@formula("asymptotic lines", on="forms")
def asymptotic_pair_squared(c):
    """The squared determinant of ``(√δ − M, L)`` and ``(−√δ − M, L)``: zero where the two directions coincide."""
    root, second, mixed, _ = _with_root(c)
    value = (root - mixed) * second - second * (-root - mixed)
    return (value * value).plain


@formula("asymptotic lines", on="forms")
def asymptotic_pair_by_parabolic(c):
    """``−4 L² (LN − M²)``."""
    return -4 * c.L**2 * (c.L * c.N - c.M**2)


@formula("asymptotic lines", on="curve on a surface")
def second_form_times_L(c):
    """``L II``."""
    return L(c) * second_form(c)


@formula("asymptotic lines", on="curve on a surface")
def second_form_as_squares(c):
    """``(L u′ + M v′)² + (LN − M²) v′²``: zero for real directions only where ``LN ≤ M²``."""
    u, v = c.u.d(1), c.v.d(1)
    return (L(c) * u + M(c) * v) ** 2 + (L(c) * N(c) - M(c) ** 2) * v**2


@formula("asymptotic lines", on="surface")
def bending_of_u_line(c):
    """``S_v · (S_uu × S_u)``: zero where the u-line is straight."""
    return dot(S_v(c), cross(S_uu(c), S_u(c)))


@formula("asymptotic lines", on="surface")
def bending_of_v_line(c):
    """``S_u · (S_v × S_vv)``: zero where the v-line is straight, as rulings are."""
    return dot(S_u(c), cross(S_v(c), S_vv(c)))


@formula("asymptotic lines", on="curve on a surface")
def bending_off_surface(c):
    """``(γ′ × γ″) · (n × γ′)``: zero where the curve is straight."""
    return dot(cross(c.gamma.d(1), c.gamma.d(2)), cross(normal(c), c.gamma.d(1)))


@formula("asymptotic lines", on="curve on a surface")
def second_form_times_speed(c):
    """``−‖γ′‖² II``."""
    return -dot(c.gamma.d(1), c.gamma.d(1)) * second_form(c)


@formula("lifted", on="curve on a surface", symbol=r"w^4\mathrm{I}")
def first_form_lifted(c):
    """``w⁴`` times the first fundamental form along the curve."""
    return _along(E_reduced(c), F_reduced(c), G_reduced(c), c.u.d(1), c.v.d(1))


@formula("lifted", on="curve on a surface", symbol=r"w^4\mathrm{II}")
def second_form_of_lifted(c):
    """``w⁴`` times the second fundamental form along the curve, in terms of determinants of P."""
    return _along(L_lifted(c), M_lifted(c), N_lifted(c), c.u.d(1), c.v.d(1))


@formula("lifted", on="curve on a surface", symbol=r"\kappa_n^2")
def normal_curvature_squared_lifted(c):
    """``w⁶ [P P_u P_v P″]²/((w⁴ I)² ‖Π_n‖²)``."""
    return c.w**6 * second_form_lifted(c) ** 2 / (first_form_lifted(c) ** 2 * area_squared_lifted(c))
