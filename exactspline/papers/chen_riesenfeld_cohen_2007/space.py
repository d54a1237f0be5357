"""§5: space curves."""

from exactspline.language.formula import formula
from exactspline.language.ruled import development, ruled
from exactspline.language.vector import cross, det, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import (
    D1,
    D1_D2_D3,
    D2,
    D3,
    D21,
    D1_squared,
    speed_squared,
    velocity_acceleration_jerk,
)


@formula("eq. (14)", on="space", symbol="B")
def binormal(c):
    """``γ′ × γ″``: the binormal direction, rational."""
    return cross(c.gamma.d(1), c.gamma.d(2))


@formula("eq. (14)", on="space", symbol="N")
def normal(c):
    """``(γ′ × γ″) × γ′``: the principal normal direction, rational."""
    return cross(binormal(c), c.gamma.d(1))


@formula("§5", on="space")
def binormal_squared(c):
    """``‖γ′ × γ″‖²``."""
    return norm2(binormal(c))


@formula("§5", on="space")
def D1_x_D2(c):
    """``D1 × D2``."""
    return cross(D1(c), D2(c))


@formula("§5, as eq. (8)", on="space", symbol="b")
def binormal_form(c):
    """``D1 × D2`` without its common factor w, the analogue of eq. (8)."""
    p, w = c.p, c.w
    return cross(p.d(1), p.d(2)) * w - cross(p, p.d(2)) * w.d(1) - cross(p.d(1), p) * w.d(2)


@formula("§5", on="space", symbol=r"\|b\|^2")
def binormal_form_squared(c):
    """``‖D1 × D2‖² / w²``: nonzero where the curvature is nonzero."""
    return norm2(binormal_form(c))


@formula("§5", on="space")
def D1_x_D2_x_D1(c):
    """``(D1 × D2) × D1``."""
    return cross(D1_x_D2(c), D1(c))


@formula("§5", on="space")
def D1_x_D2_squared(c):
    """``‖D1 × D2‖²``: nonzero where the curvature is nonzero."""
    return norm2(D1_x_D2(c))


@formula("eq. (15)", on="space", symbol=r"\kappa^2")
def space_curvature_squared(c):
    """Squared curvature ``‖γ′ × γ″‖² / ‖γ′‖⁶``, naive."""
    return binormal_squared(c) / speed_squared(c) ** 3


@formula("§5.1, before eq. (16)", on="space", symbol=r"\kappa N")
def curvature_vector(c):
    """``κN = (γ′ × γ″) × γ′ / ‖γ′‖⁴``."""
    return normal(c) / speed_squared(c) ** 2


@formula("definition of the curvature", on="space")
def curvature_vector_by_definition(c):
    """``γ″/‖γ′‖² − γ′ (γ′·γ″)/‖γ′‖⁴``: the derivative of the unit tangent with respect to arc length."""
    a, b, speed = c.gamma.d(1), c.gamma.d(2), speed_squared(c)
    return b / speed - a * (dot(a, b) / speed**2)


@formula("§5.1", on="space")
def curvature_vector_squared(c):
    """``‖κN‖²``."""
    return norm2(curvature_vector(c))


@formula("eq. (16)", on="space")
def radius_vector(c):
    """``κ⁻¹N = (‖γ′‖² / ‖γ′ × γ″‖²) (γ′ × γ″) × γ′``."""
    return (speed_squared(c) / binormal_squared(c)) * normal(c)


@formula("eq. (17)", on="space", symbol=r"\tau")
def torsion(c):
    """Torsion ``[γ′ γ″ γ‴] / ‖γ′ × γ″‖²``, naive."""
    return velocity_acceleration_jerk(c) / binormal_squared(c)


@formula("eq. (18)", on="space", symbol=r"\tau")
def torsion_reduced(c):
    """Torsion ``w² [D1 D2 D3] / ‖D1 × D2‖²``, with polynomials multiplied before the division."""
    return (c.w**2 * D1_D2_D3(c)) / D1_x_D2_squared(c)


@formula("§5.3", on="space")
def tangent_developable(c):
    """``γ + ζ γ′``, naive."""
    return ruled(c.gamma, c.gamma.d(1))


@formula("§5.3", on="space")
def tangent_developable_reduced(c):
    """``(p + λ D1) / w``."""
    return ruled(c.p / c.w, D1(c) / c.w)


@formula("§5.3", on="space")
def binormal_scroll(c):
    """``γ + ζ (γ′ × γ″)``, naive."""
    return ruled(c.gamma, binormal(c))


@formula("§5.3", on="space")
def binormal_scroll_reduced(c):
    """``(p + λ D1 × D2) / w``."""
    return ruled(c.p / c.w, D1_x_D2(c) / c.w)


@formula("§5.3", on="space")
def normal_scroll(c):
    """``γ + ζ (γ′ × γ″) × γ′``, naive."""
    return ruled(c.gamma, normal(c))


@formula("§5.3", on="space")
def normal_scroll_reduced(c):
    """``(p + λ (D1 × D2) × D1) / w``."""
    return ruled(c.p / c.w, D1_x_D2_x_D1(c) / c.w)


@formula("§5.4", on="space")
def rectifying_developable(c):
    """``γ + λ (τ γ′ + γ′ × γ″ / ‖γ′‖²)``, naive."""
    return ruled(c.gamma, torsion(c) * c.gamma.d(1) + binormal(c) / speed_squared(c))


@formula("§5.4", on="space")
def rectifying_developable_reduced(c):
    """``γ + λ ([D1 D2 D3] D1 / ‖D1 × D2‖² + D1 × D2 / ‖D1‖²)``, with polynomials multiplied before the division."""
    return ruled(c.gamma, (D1(c) * D1_D2_D3(c)) / D1_x_D2_squared(c) + D1_x_D2(c) / D1_squared(c))


@formula("§5.4", on="space")
def rectifying_along_tangent(c):
    """``(τ γ′ + γ′ × γ″/‖γ′‖²)·γ′``: ‖γ′‖² τ when λ = ζ/‖γ′‖ (the component of ζ(τT + κB) along T is ζτ)."""
    return dot(rectifying_developable(c).generator, c.gamma.d(1))


@formula("§5.4", on="space")
def rectifying_along_binormal(c):
    """``(τ γ′ + γ′ × γ″/‖γ′‖²)·(γ′ × γ″)``: ‖γ′‖ κ ‖γ′ × γ″‖ when λ = ζ/‖γ′‖ (the component of ζ(τT + κB) along B is
    ζκ).
    """
    return dot(rectifying_developable(c).generator, binormal(c))


@formula("§5.4", on="space")
def rectifying_plane(c):
    """``(τ γ′ + γ′ × γ″/‖γ′‖²) · N``: zero when the generator lies in the rectifying plane."""
    return dot(rectifying_developable(c).generator, normal(c))


@formula("§5.5", on="space")
def psi_numerator(c):
    """``3 (γ′·γ″) ‖γ′×γ″‖² − (γ′×γ″)·(γ′×γ‴) ‖γ′‖²``."""
    a, b = c.gamma.d(1), binormal(c)
    return 3 * dot(a, c.gamma.d(2)) * binormal_squared(c) - dot(b, cross(a, c.gamma.d(3))) * speed_squared(c)


@formula("§5.5", on="space", symbol=r"\Psi")
def psi(c):
    """Ψ, with ``(1/κ)′ B = ‖γ′‖ Ψ`` for the derivative with respect to the parameter and the unit binormal B."""
    return (psi_numerator(c) / binormal_squared(c) ** 2) * binormal(c)


@formula("§5.5", on="space")
def radius_logarithmic_derivative(c):
    """``‖γ′‖² ‖γ′×γ″‖² (1/κ)′ κ`` from ``1/κ = ‖γ′‖³ / ‖γ′×γ″‖`` by the chain rule."""
    a, b = speed_squared(c), binormal_squared(c)
    return (3 * a.d(1) * b - a * b.d(1)) / 2


@formula("§5.5", on="space", symbol="E")
def osculating_circle_centre(c):
    """``γ + κ⁻¹N``: the evolute of a space curve in the sense of §5.5."""
    return c.gamma + radius_vector(c)


@formula("definition of the osculating circle", on="space")
def circle_contact_1(c):
    """``(E − γ)·γ′``: zero when the centre lies in the normal plane."""
    return dot(osculating_circle_centre(c) - c.gamma, c.gamma.d(1))


@formula("definition of the osculating circle", on="space")
def circle_contact_2(c):
    """``(E − γ)·γ″ − ‖γ′‖²``: zero if the circle has contact of second order."""
    return dot(osculating_circle_centre(c) - c.gamma, c.gamma.d(2)) - speed_squared(c)


@formula("definition of the osculating circle", on="space")
def circle_contact_3(c):
    """``(E − γ)·(γ′ × γ″)``: zero when the centre lies in the osculating plane."""
    return dot(osculating_circle_centre(c) - c.gamma, binormal(c))


@formula("§5.5, by definition", on="space")
def focal_offset(c):
    """``F − γ``: the solution of the three equations by Cramer's rule."""
    a, b, e = c.gamma.d(1), c.gamma.d(2), c.gamma.d(3)
    return (cross(e, a) * speed_squared(c) + cross(a, b) * (3 * dot(a, b))) / velocity_acceleration_jerk(c)


@formula("§5.5, by definition", on="space", symbol="F")
def focal_curve(c):
    """The centre of the osculating sphere: the solution of ``(F − γ)·γ′ = 0`` and its first two derivatives, by
    Cramer's rule.
    """
    return c.gamma + focal_offset(c)


@formula("eq. (19), derivative by arc length", on="space")
def focal_curve_by_arc_length(c):
    """``γ + κ⁻¹N + (1/τ) Ψ``: eq. (19) with the derivative ``(1/κ)′`` with respect to arc length."""
    return c.gamma + radius_vector(c) + psi(c) / torsion(c)


@formula("§5.5, reduced", on="space")
def focal_curve_reduced(c):
    """The centre of the osculating sphere in terms of D1, D2, D3."""
    w, speed, stretch = c.w, D1_squared(c), dot(D1(c), D2(c))
    first = (
        cross(D3(c), D1(c)) * (speed * w)
        + cross(D21(c), D1(c)) * (speed * w)
        + D1_x_D2(c) * (3 * stretch * w - 2 * c.w.d(1) * speed)
    )
    return (c.p * (w**2 * D1_D2_D3(c)) + first) / (w**3 * D1_D2_D3(c))


@formula("definition of the focal curve", on="space")
def focal_binormal(c):
    """``(F − γ)·(γ′ × γ″)``."""
    return dot(focal_offset(c), binormal(c))


@formula("eq. (19), derivative by arc length", on="space")
def focal_binormal_by_arc_length(c):
    """``Ψ·(γ′ × γ″)/τ``: the component of (1/τ)(1/κ)′B along γ′ × γ″, where ‖γ′ × γ″‖² is in the denominators of both Ψ
    and τ.
    """
    return psi_numerator(c) / velocity_acceleration_jerk(c)


@formula("definition of the focal curve", on="space")
def focal_contact_1(c):
    """``(F − γ)·γ′``: zero if the sphere around F has contact of first order."""
    return dot(focal_curve(c) - c.gamma, c.gamma.d(1))


@formula("definition of the focal curve", on="space")
def focal_contact_2(c):
    """``(F − γ)·γ″ − ‖γ′‖²``: zero if it has contact of second order."""
    return dot(focal_curve(c) - c.gamma, c.gamma.d(2)) - speed_squared(c)


@formula("definition of the focal curve", on="space")
def focal_contact_3(c):
    """``(F − γ)·γ‴ − 3 γ′·γ″``: zero if it has contact of third order."""
    return dot(focal_curve(c) - c.gamma, c.gamma.d(3)) - 3 * dot(c.gamma.d(1), c.gamma.d(2))


@formula("eqs. (20), (21)", on="space")
def focal_surface(c):
    """``γ + κ⁻¹N + μ γ′ × γ″``, naive."""
    return ruled(osculating_circle_centre(c), binormal(c))


@formula("§5.6", on="space")
def focal_surface_reduced(c):
    """``p/w + ‖D1‖² (D1 × D2) × D1 / (w² ‖D1 × D2‖²) + (μ/w⁴) D1 × D2``."""
    directrix = c.p / c.w + (D1_x_D2_x_D1(c) * D1_squared(c)) / (c.w**2 * D1_x_D2_squared(c))
    return ruled(directrix, D1_x_D2(c) / c.w**4)


@formula("§5.2, squaring", on="space", symbol=r"(\kappa^2)'")
def space_curvature_squared_derivative(c):
    """Derivative of the squared curvature by the quotient rule."""
    return space_curvature_squared(c).d(1)


@formula("analogue of eq. (10)", on="space")
def space_critical_curvature(c):
    """``(γ′×γ″)·(γ′×γ‴) ‖γ′‖² − 3 ‖γ′×γ″‖² (γ′·γ″)``: half of ``(κ²)′ ‖γ′‖⁸``, the direct approach in space."""
    a, b = c.gamma.d(1), binormal(c)
    return dot(b, cross(a, c.gamma.d(3))) * speed_squared(c) - 3 * binormal_squared(c) * dot(a, c.gamma.d(2))


@formula("analogue of eq. (11)", on="space")
def space_critical_curvature_reduced(c):
    """The direct approach in space in terms of D1, D2, D3."""
    w, a, b, speed = c.w, D1(c), D1_x_D2(c), D1_squared(c)
    bend = D1_x_D2_squared(c)
    jerk = dot(b, cross(a, D3(c))) + dot(b, cross(a, D21(c)))
    return jerk * speed * w + 2 * w.d(1) * bend * speed - 3 * bend * dot(a, D2(c)) * w


@formula("Frenet equations", on="space")
def torsion_by_frenet(c):
    """``−B′·N / ‖γ′‖`` for the unit vectors B and N, written with ``γ′ × γ″`` and ``(γ′ × γ″) × γ′``."""
    return -dot(binormal(c).d(1), normal(c)) / (binormal_squared(c) * speed_squared(c))


@formula("definition of a geodesic", on="space")
def rectifying_geodesic(c):
    """``[γ′ γ″ γ′ × G]``: zero when γ is a geodesic of the rectifying developable with generator G."""
    a = c.gamma.d(1)
    return det(a, c.gamma.d(2), cross(a, rectifying_developable(c).generator))


@formula("definition of a developable", on="space")
def focal_development(c):
    """``[δ′ B B′]``: zero when the focal surface is developable."""
    return development(focal_surface_reduced(c))
