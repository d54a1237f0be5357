"""Invariants of a surface in terms of the coefficients E, F, G and L, M, N of its two fundamental forms.

``L, M, N`` refer to the normal ``n = S_u × S_v``, which is not normalized: the principal curvatures are
``κ = λ/√(EG − F²)`` with the roots λ of ``(EG − F²) λ² − (EN − 2FM + GL) λ + (LN − M²) = 0``.
"""

from exactspline.language.arguments import Operands
from exactspline.language.formula import formula
from exactspline.language.vector import det, join


def along_weight(c, w):
    """The cubic form ``dw II(t, t)``."""
    w_u, w_v = w.d(1, by="u"), w.d(1, by="v")
    return join(w_u * c.L, 2 * w_u * c.M + w_v * c.L, w_u * c.N + 2 * w_v * c.M, w_v * c.N)


def extremal_along_lines(c, cubic):
    """The resultant of the lines of curvature and a cubic form."""
    a, b, d = line_uu_of_forms(c), line_uv_of_forms(c), line_vv_of_forms(c)
    return det(join(a, b, d, 0, 0), join(0, a, b, d, 0), join(0, 0, a, b, d), join(cubic, 0), join(0, cubic))


@formula("first form", on="forms")
def area_of_forms(c):
    """``EG − F²``."""
    return c.E * c.G - c.F**2


@formula("second form", on="forms")
def parabolic_of_forms(c):
    """``LN − M²``."""
    return c.L * c.N - c.M**2


@formula("both forms", on="forms")
def minimality_of_forms(c):
    """``EN − 2FM + GL``."""
    return c.E * c.N - 2 * c.F * c.M + c.G * c.L


@formula("lines of curvature", on="forms", symbol="A")
def line_uu_of_forms(c):
    """``EM − FL``."""
    return c.E * c.M - c.F * c.L


@formula("lines of curvature", on="forms", symbol="B")
def line_uv_of_forms(c):
    """``EN − GL``."""
    return c.E * c.N - c.G * c.L


@formula("lines of curvature", on="forms", symbol="C")
def line_vv_of_forms(c):
    """``FN − GM``."""
    return c.F * c.N - c.G * c.M


@formula("lines of curvature", on="forms")
def line_discriminant_of_forms(c):
    """``B² − 4AC``."""
    return line_uv_of_forms(c) ** 2 - 4 * line_uu_of_forms(c) * line_vv_of_forms(c)


@formula("lines of curvature", on="forms")
def line_relation_of_forms(c):
    """``EC − FB + GA``: the lines of curvature are orthogonal where this is zero."""
    return c.E * line_vv_of_forms(c) - c.F * line_uv_of_forms(c) + c.G * line_uu_of_forms(c)


@formula("lines of curvature", on="forms")
def line_relation_of_second_form(c):
    """``LC − MB + NA``: the lines of curvature are conjugate where this is zero."""
    return c.L * line_vv_of_forms(c) - c.M * line_uv_of_forms(c) + c.N * line_uu_of_forms(c)


@formula("principal curvatures", on="forms", symbol=r"\Delta")
def umbilicity_of_forms(c):
    """``(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)``, the discriminant of the principal curvatures."""
    return minimality_of_forms(c) ** 2 - 4 * area_of_forms(c) * parabolic_of_forms(c)


@formula("principal curvatures", on="forms")
def umbilicity_times_square(c):
    """``E² Δ``."""
    return c.E**2 * umbilicity_of_forms(c)


@formula("principal curvatures", on="forms")
def umbilicity_as_squares(c):
    """``(EB − 2FA)² + (EG − F²)(2A)²``."""
    bent = c.E * line_uv_of_forms(c) - 2 * c.F * line_uu_of_forms(c)
    return bent**2 + area_of_forms(c) * (2 * line_uu_of_forms(c)) ** 2


@formula("stationary principal curvatures", on="forms", symbol="Q_u")
def stationary_by_u(c):
    """The part of ``2 √Δ a^(5/2) κ_u`` that is free of √Δ, for ``a = EG − F²``: ``a Δ_u − 3 Δ a_u``."""
    a, delta = area_of_forms(c), umbilicity_of_forms(c)
    return a * delta.d(1, by="u") - 3 * delta * a.d(1, by="u")


@formula("stationary principal curvatures", on="forms", symbol="Q_v")
def stationary_by_v(c):
    """The part of ``2 √Δ a^(5/2) κ_v`` that is free of √Δ: ``a Δ_v − 3 Δ a_v``."""
    a, delta = area_of_forms(c), umbilicity_of_forms(c)
    return a * delta.d(1, by="v") - 3 * delta * a.d(1, by="v")


@formula("stationary principal curvatures", on="forms", symbol="R_u")
def stationary_root_by_u(c):
    """The coefficient of √Δ in ``2 √Δ a^(5/2) κ_u``: ``2a h_u − 3h a_u`` with ``h = EN − 2FM + GL``, zero exactly where
    H_u is.
    """
    a, h = area_of_forms(c), minimality_of_forms(c)
    return 2 * a * h.d(1, by="u") - 3 * h * a.d(1, by="u")


@formula("stationary principal curvatures", on="forms", symbol="R_v")
def stationary_root_by_v(c):
    """The coefficient of √Δ in ``2 √Δ a^(5/2) κ_v``: ``2a h_v − 3h a_v``, zero exactly where H_v is."""
    a, h = area_of_forms(c), minimality_of_forms(c)
    return 2 * a * h.d(1, by="v") - 3 * h * a.d(1, by="v")


@formula("ridges", on="forms", symbol="U")
def ridge_rational_part(c):
    """The part free of √Δ in the derivative of κ along its line of curvature, ``(2a M − (h + √Δ) F) κ_u + ((h + √Δ) E −
    2a L) κ_v``.
    """
    a, h = area_of_forms(c), minimality_of_forms(c)
    plain = stationary_by_u(c) * (2 * a * c.M - h * c.F) + stationary_by_v(c) * (h * c.E - 2 * a * c.L)
    return plain + umbilicity_of_forms(c) * (c.E * stationary_root_by_v(c) - c.F * stationary_root_by_u(c))


@formula("ridges", on="forms", symbol="V")
def ridge_root_part(c):
    """The coefficient of √Δ in the derivative of κ along its line of curvature."""
    a, h = area_of_forms(c), minimality_of_forms(c)
    bent = stationary_root_by_u(c) * (2 * a * c.M - h * c.F) + stationary_root_by_v(c) * (h * c.E - 2 * a * c.L)
    return bent + c.E * stationary_by_v(c) - c.F * stationary_by_u(c)


@formula("ridges", on="forms")
def ridges_by_definition(c):
    """``U² − Δ V²``: zero where a principal curvature is extremal along its line of curvature (but not only there)."""
    return ridge_rational_part(c) ** 2 - umbilicity_of_forms(c) * ridge_root_part(c) ** 2


def _bent(c, by):
    """``a II_by(t, t) − a_by II(t, t)/2 − I_by(t, s)`` with ``s = a I⁻¹ II t``: the coefficients of t_u², t_u t_v, t_v²
    for a direction t.
    """
    a, a_by = area_of_forms(c), area_of_forms(c).d(1, by=by)
    e, f, g = c.E.d(1, by=by), c.F.d(1, by=by), c.G.d(1, by=by)
    uu, vv, uv, vu = c.G * c.L - c.F * c.M, c.E * c.N - c.F * c.M, c.G * c.M - c.F * c.N, c.E * c.M - c.F * c.L
    return (
        a * c.L.d(1, by=by) - a_by * c.L / 2 - e * uu - f * vu,
        2 * a * c.M.d(1, by=by) - a_by * c.M - e * uv - f * (uu + vv) - g * vu,
        a * c.N.d(1, by=by) - a_by * c.N / 2 - f * uv - g * vv,
    )


@formula("ridges", on="forms", symbol="T")
def ridge_cubic(c):
    """The cubic form ``(EG − F²) dII(t, t) − d(EG − F²) II(t, t)/2 − dI(t, s)`` in the direction t along which d is
    taken: for a principal direction it is the derivative of κ in this direction, up to a factor without zeros.

    Because of ``II t = κ I t``, the derivative of ``κ I(t, t) = II(t, t)`` contains no derivative of t; ``s`` expresses
    ``κ t`` without κ.
    """
    u, v = _bent(c, "u"), _bent(c, "v")
    return join(u[0], u[1] + v[0], u[2] + v[1], v[2])


@formula("ridges", on="forms")
def ridges_of_forms(c):
    """The resultant of the lines of curvature ``A t_u² + B t_u t_v + C t_v² = 0`` and this cubic form: zero on the
    ridges of both principal curvatures.
    """
    return extremal_along_lines(c, ridge_cubic(c))


@formula("ridges", on="forms")
def ridge_cubic_over_weight(c):
    """The cubic form for both fundamental forms divided by ``w⁴``."""
    divided = {"E": c.E, "F": c.F, "G": c.G, "L": c.L, "M": c.M, "N": c.N}
    return ridge_cubic(Operands(**{name: form / c.w**4 for name, form in divided.items()}))


@formula("ridges", on="forms")
def ridge_cubic_weighted(c):
    """``w T + 4 (EG − F²) dw II(t, t)``."""
    return ridge_cubic(c) * c.w + along_weight(c, c.w) * (4 * area_of_forms(c))
