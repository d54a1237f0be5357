"""What the coefficients E, F, G and L, M, N of the two fundamental forms say by themselves.

All is written for ``L, M, N`` with the normal ``n = S_u × S_v``, which is not normalized: the principal curvatures are
``κ = λ/√(EG − F²)`` with the roots λ of ``(EG − F²) λ² − (EN − 2FM + GL) λ + (LN − M²) = 0``.
"""

from exactspline.language.formula import formula


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
    """``LC − MB + NA``: they are conjugate where this is zero."""
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


@formula("ridges", on="forms", symbol="U")
def ridge_rational_part(c):
    """What of ``2 √Δ (EG − F²)^(5/2)`` times the derivative of κ along its own line is free of √Δ.

    With ``λ = (h + √Δ)/(2a)``, ``h = EN − 2FM + GL`` and ``a = EG − F²``, the direction ``(2a M − (h + √Δ) F, (h + √Δ)
    E − 2a L)`` is the principal one, and ``dκ`` is proportional to ``a dΔ − 3 Δ da + √Δ (2a dh − 3h da)``.
    """
    a, h, delta = area_of_forms(c), minimality_of_forms(c), umbilicity_of_forms(c)
    along_u, along_v = 2 * a * c.M - h * c.F, h * c.E - 2 * a * c.L
    u, v = a.d(1, by="u"), a.d(1, by="v")
    plain = (delta.d(1, by="u") * a - 3 * delta * u) * along_u + (delta.d(1, by="v") * a - 3 * delta * v) * along_v
    bent_u, bent_v = 2 * a * h.d(1, by="u") - 3 * h * u, 2 * a * h.d(1, by="v") - 3 * h * v
    return plain + delta * (c.E * bent_v - c.F * bent_u)


@formula("ridges", on="forms", symbol="V")
def ridge_root_part(c):
    """The factor of √Δ in the same."""
    a, h, delta = area_of_forms(c), minimality_of_forms(c), umbilicity_of_forms(c)
    along_u, along_v = 2 * a * c.M - h * c.F, h * c.E - 2 * a * c.L
    u, v = a.d(1, by="u"), a.d(1, by="v")
    bent_u, bent_v = 2 * a * h.d(1, by="u") - 3 * h * u, 2 * a * h.d(1, by="v") - 3 * h * v
    plain = (delta.d(1, by="v") * a - 3 * delta * v) * c.E - (delta.d(1, by="u") * a - 3 * delta * u) * c.F
    return along_u * bent_u + along_v * bent_v + plain


@formula("ridges", on="forms")
def ridges_of_forms(c):
    """``U² − Δ V²``: zero on the ridges of both principal curvatures, where one is extremal along its own line."""
    return ridge_rational_part(c) ** 2 - umbilicity_of_forms(c) * ridge_root_part(c) ** 2
