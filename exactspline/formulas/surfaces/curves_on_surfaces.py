"""Curves on a surface, γ(t) = S(u(t), v(t)), with derivatives by the chain rule; and asymptotic directions, in which
the normal curvature vanishes: the roots of ``L du² + 2M du dv + N dv² = 0``.

Statements about fundamental forms in a direction are formulated here for every curve with that direction, so that they
can be compared with the curvature of space curves. Asymptotic directions are ``(√δ − M : L)`` and ``(−√δ − M : L)``
with ``δ = M² − LN``, and also ``(N : −M ∓ √δ)``. The root is adjoined, so that statements proved for one sign of √δ
hold for the other sign.
"""

from exactspline.formulas.surfaces.curvatures import (
    area_squared,
    line_coefficient_uu,
    line_coefficient_uv,
    line_coefficient_vv,
)
from exactspline.formulas.surfaces.fundamental_forms import (
    E,
    E_reduced,
    F,
    F_reduced,
    G,
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
from exactspline.formulas.surfaces.lifted import (
    L_lifted,
    M_lifted,
    N_lifted,
    area_squared_lifted,
    projective_lift_of_surface,
)
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, join


@formula("first fundamental form", on="curve on a surface", symbol=r"\mathrm{I}")
def first_form(c):
    """``E u′² + 2F u′v′ + G v′²``."""
    return E(c) * c.u.d(1) ** 2 + 2 * F(c) * c.u.d(1) * c.v.d(1) + G(c) * c.v.d(1) ** 2


@formula("second fundamental form", on="curve on a surface", symbol=r"\mathrm{II}")
def second_form(c):
    """``L u′² + 2M u′v′ + N v′²``."""
    return L(c) * c.u.d(1) ** 2 + 2 * M(c) * c.u.d(1) * c.v.d(1) + N(c) * c.v.d(1) ** 2


@formula("J. B. Meusnier 1776", on="curve on a surface")
def acceleration_on_normal(c):
    """``γ″ · n``."""
    return dot(c.gamma.d(2), normal(c))


@formula("normal curvature", on="curve on a surface", symbol=r"\kappa_n^2")
def normal_curvature_squared(c):
    """``II²/(I² (EG − F²))``, the same for all curves with the same direction."""
    return second_form(c) ** 2 / (first_form(c) ** 2 * area_squared(c))


@formula("geodesic curvature", on="curve on a surface")
def geodesic_determinant(c):
    """``[γ′ γ″ n]``: zero where the geodesic curvature vanishes."""
    return det(c.gamma.d(1), c.gamma.d(2), normal(c))


@formula("geodesic curvature", on="curve on a surface")
def geodesic_determinant_of_first_form(c):
    """``(γ′·S_u)(γ″·S_v) − (γ′·S_v)(γ″·S_u)``, each product from E, F, G and their derivatives."""
    u, v, e, f, g = c.u.d(1), c.v.d(1), E(c), F(c), G(c)
    bent_u = e.d(1, by="u") / 2 * u**2 + e.d(1, by="v") * u * v + (f.d(1, by="v") - g.d(1, by="u") / 2) * v**2
    bent_v = (f.d(1, by="u") - e.d(1, by="v") / 2) * u**2 + g.d(1, by="u") * u * v + g.d(1, by="v") / 2 * v**2
    on_u, on_v = e * c.u.d(2) + f * c.v.d(2) + bent_u, f * c.u.d(2) + g * c.v.d(2) + bent_v
    return (e * u + f * v) * on_v - (f * u + g * v) * on_u


@formula("geodesic curvature", on="curve on a surface", symbol=r"\kappa_g^2")
def geodesic_curvature_squared(c):
    """``[γ′ γ″ n]²/(I³ (EG − F²))``."""
    return geodesic_determinant(c) ** 2 / (first_form(c) ** 3 * area_squared(c))


@formula("curvature", on="curve on a surface")
def curvature_from_surface(c):
    """``κ_n² + κ_g²``."""
    return normal_curvature_squared(c) + geodesic_curvature_squared(c)


@formula("lines of curvature", on="curve on a surface")
def line_form(c):
    """``A u′² + B u′v′ + C v′²``."""
    u, v = c.u.d(1), c.v.d(1)
    return line_coefficient_uu(c) * u**2 + line_coefficient_uv(c) * u * v + line_coefficient_vv(c) * v**2


@formula("O. Rodrigues 1816", on="curve on a surface")
def turning_of_normal(c):
    """``[n n′ γ′]``: zero where the normals along the curve form a developable surface."""
    return det(normal(c), normal(c).d(1), c.gamma.d(1))


@formula("lifted", on="curve on a surface", symbol="[P\\ P_u\\ P_v\\ P'']")
def second_form_lifted(c):
    """The determinant ``[P P_u P_v P″]``: contact of the curve with the tangent plane of the surface."""
    x = projective_lift_of_surface(c)
    return det(x, x.d(1, by="u"), x.d(1, by="v"), x.d(2))


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
