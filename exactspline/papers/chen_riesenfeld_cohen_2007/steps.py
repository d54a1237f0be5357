"""Single lines of derivations and displays as printed: §3 to §4, and statements in words of §5 and §6."""

from exactspline.language.formula import formula
from exactspline.language.ruled import development, ruled
from exactspline.language.vector import cross, det, dot, join, norm2, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import (
    D1,
    D2,
    D3,
    D21,
    D1_squared,
    acceleration_first_term,
    jerk_first_term,
    velocity_acceleration_jerk,
    velocity_shared,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import curvature_squared, f0, f1
from exactspline.papers.chen_riesenfeld_cohen_2007.space import (
    binormal,
    focal_offset,
    normal,
    radius_vector,
    tangent_developable,
)


def _square_inverted(c):
    """``1/w²``."""
    return 1 / c.w**2


@formula("eq. (2), first line")
def acceleration_line_1(c):
    """``(p′w − pw′)′/w² + (p′w − pw′)(1/w²)′``."""
    return D1(c).d(1) / c.w**2 + D1(c) * _square_inverted(c).d(1)


@formula("eq. (2), second line")
def acceleration_line_2(c):
    """``(p″w − pw″)/w² + (p′w − pw′)(1/w²)′``."""
    return D2(c) / c.w**2 + D1(c) * _square_inverted(c).d(1)


@formula("eq. (3), first line")
def jerk_line_1(c):
    """The derivative of eq. (2), term by term."""
    once = _square_inverted(c).d(1)
    return D3(c) / c.w**2 + D21(c) / c.w**2 + D2(c) * once + D2(c) * once + D1(c) * _square_inverted(c).d(2)


@formula("eq. (3), second line")
def jerk_line_2(c):
    """The derivative of eq. (2), with two equal terms combined."""
    once = _square_inverted(c).d(1)
    return D3(c) / c.w**2 + D21(c) / c.w**2 + 2 * (D2(c) * once) + D1(c) * _square_inverted(c).d(2)


@formula("§3, [D1 D2 D21], first line", on="space")
def span_line_1(c):
    """``(p′w − w′p) × (p″w − w″p) · (p″w′ − w″p′)``."""
    p, w = c.p, c.w
    first, second = p.d(1) * w - p * w.d(1), p.d(2) * w - p * w.d(2)
    return dot(cross(first, second), p.d(2) * w.d(1) - p.d(1) * w.d(2))


@formula("§3, [D1 D2 D21], second line", on="space")
def span_bracket(c):
    """``(p′ × p″)w² − (p × p″)ww′ − (p′ × p)ww″``."""
    p, w = c.p, c.w
    return cross(p.d(1), p.d(2)) * w**2 - cross(p, p.d(2)) * (w * w.d(1)) - cross(p.d(1), p) * (w * w.d(2))


@formula("§3, [D1 D2 D21], second line", on="space")
def span_line_2(c):
    """``((p′ × p″)w² − (p × p″)ww′ − (p′ × p)ww″) · (p″w′ − w″p′)``."""
    return dot(span_bracket(c), c.p.d(2) * c.w.d(1) - c.p.d(1) * c.w.d(2))


@formula("§3, [D1 D2 D21], third line", on="space")
def span_line_3(c):
    """``−(p′ × p)·p″ ww′w″ + (p × p″)·p′ ww′w″``."""
    return -span_other_term(c) + span_term(c)


@formula("§3, [D1 D2 D21], third line", on="space")
def span_term(c):
    """``(p × p″)·p′ ww′w″``: one of the two terms of the third line."""
    p, w = c.p, c.w
    return dot(cross(p, p.d(2)), p.d(1)) * (w * w.d(1) * w.d(2))


@formula("§3, [D1 D2 D21], third line", on="space")
def span_other_term(c):
    """``(p′ × p)·p″ ww′w″``: the other term of the third line."""
    p, w = c.p, c.w
    return dot(cross(p.d(1), p), p.d(2)) * (w * w.d(1) * w.d(2))


@formula("§3, below Remark 3.1", on="plane")
def bracket(c):
    """``[a b]`` of two vectors, here p and p′."""
    return det(c.p, c.p.d(1))


@formula("§3, below Remark 3.1", on="plane")
def bracket_by_rotation(c):
    """``a⊥ · b``, where ``a⊥ = (−a_y, a_x)`` is a rotated by π/2 counter-clockwise."""
    a, b = c.p, c.p.d(1)
    return -a[1] * b[0] + a[0] * b[1]


@formula("§2", on="space")
def triple_product(c):
    """``[p p′ p″]`` as the sum of the six terms of the determinant."""
    a, b, e = c.p, c.p.d(1), c.p.d(2)
    plus = a[0] * b[1] * e[2] + a[1] * b[2] * e[0] + a[2] * b[0] * e[1]
    return plus - (a[0] * b[2] * e[1] + a[1] * b[0] * e[2] + a[2] * b[1] * e[0])


@formula("§2", on="space")
def cross_then_dot(c):
    """``(p × p′)·p″``: a cross product followed by a dot product."""
    return dot(cross(c.p, c.p.d(1)), c.p.d(2))


@formula("§3, end", on="plane")
def first_terms_1_2(c):
    """``[D1/w² D2/w²]``."""
    return det(velocity_shared(c), acceleration_first_term(c))


@formula("§3, end", on="plane")
def first_terms_1_3(c):
    """``[D1/w² D3/w²]``."""
    return det(velocity_shared(c), jerk_first_term(c))


@formula("§3, end", on="space")
def first_terms_1_2_3(c):
    """``[D1/w² D2/w² D3/w²]``."""
    return det(velocity_shared(c), acceleration_first_term(c), jerk_first_term(c))


@formula("eq. (8)", on="plane")
def bracket_of_p_with_itself(c):
    """``[p p]``."""
    return det(c.p, c.p)


@formula("eq. (8), first line", on="plane")
def f1_line_1(c):
    """``[p′w − pw′ p″w − pw″]``."""
    p, w = c.p, c.w
    return det(p.d(1) * w - p * w.d(1), p.d(2) * w - p * w.d(2))


@formula("§4.1", on="plane")
def curvature_numerator_squared(c):
    """``[γ′ γ″]²``: the numerator of κ²."""
    return f0(c) ** 2


@formula("§4.2, g0 in coordinates", on="plane")
def g0_by_coordinates(c):
    """``(x′² + y′²)(x′y‴ − x‴y′) − 3(x′x″ + y′y″)(x′y″ − x″y′)``."""
    (x1, y1), (x2, y2), (x3, y3) = ((c.gamma.d(i)[0], c.gamma.d(i)[1]) for i in (1, 2, 3))
    return (x1**2 + y1**2) * (x1 * y3 - x3 * y1) - 3 * (x1 * x2 + y1 * y2) * (x1 * y2 - x2 * y1)


@formula("§4.2, second line of g1", on="plane")
def g1_line_2(c):
    """g1 before like terms are combined."""
    speed, kappa, stretch = D1_squared(c), f1(c), c.w.d(1) / c.w
    first = det(D1(c), D3(c)) * speed + det(D1(c), D21(c)) * speed - 4 * stretch * kappa * speed
    return first - 3 * (dot(D1(c), D2(c)) * kappa - 2 * stretch * speed * kappa)


@formula("§4.3", on="plane")
def velocity_turned(c):
    """``γ′⊥``."""
    return perp(c.gamma.d(1))


@formula("§4.3, below eq. (12)", on="plane")
def velocity_turned_by_D1(c):
    """``(D1)⊥/w²``."""
    return perp(D1(c)) / c.w**2


@formula("§4.3, below Fig. 3, first line", on="plane", symbol="E")
def evolute_line_1(c):
    """``p/w + (‖D1‖²/[D1 D2]) (D1)⊥/w²``."""
    return c.p / c.w + (D1_squared(c) / f1(c)) * (perp(D1(c)) / c.w**2)


@formula("caption of Fig. 3(b)", on="plane", symbol="E")
def evolute_of_caption(c):
    """``γ + (‖D1‖²/[D1 D2]) γ′⊥``."""
    return c.gamma + (D1_squared(c) / f1(c)) * perp(c.gamma.d(1))


@formula("§5.1, in the plane", on="plane")
def curvature_vector_in_plane(c):
    """``κN = [γ′ γ″] γ′⊥/‖γ′‖⁴``."""
    return perp(c.gamma.d(1)) * f0(c) / norm2(c.gamma.d(1)) ** 2


@formula("§5.1, in the plane", on="plane")
def radius_vector_in_plane(c):
    """``κ⁻¹N = (‖γ′‖²/[γ′ γ″]) γ′⊥``."""
    return (norm2(c.gamma.d(1)) / f0(c)) * perp(c.gamma.d(1))


@formula("§5.1, in the plane", on="plane")
def curvature_vector_by_radius(c):
    """``κ² · κ⁻¹N``."""
    return radius_vector_in_plane(c) * curvature_squared(c)


@formula("eq. (14)", on="space")
def rational_basis_products(c):
    """The pairwise scalar products of T, N, B of (14)."""
    t, n, b = c.gamma.d(1), normal(c), binormal(c)
    return join(dot(t, n), dot(n, b), dot(b, t))


@formula("definition of a developable", on="space")
def tangent_development(c):
    """``[δ′ G G′]`` of the tangent developable."""
    return development(tangent_developable(c))


@formula("§5.4", on="space")
def darboux_vector(c):
    """``‖γ′‖² [γ′ γ″ γ‴] γ′ + ‖γ′×γ″‖² γ′×γ″``: the direction of ``τT + κB``, without roots and denominators."""
    a, b = c.gamma.d(1), binormal(c)
    return a * (norm2(a) * velocity_acceleration_jerk(c)) + b * norm2(b)


@formula("definition of a developable", on="space")
def darboux_development(c):
    """``[γ′ G G′]`` with the Darboux vector as G."""
    return development(ruled(c.gamma, darboux_vector(c)))


@formula("§5.6", on="space")
def focal_curve_off_focal_line(c):
    """``(F − γ − κ⁻¹N) × (γ′ × γ″)``: zero when the centre of the osculating sphere lies on the focal line."""
    return cross(focal_offset(c) - radius_vector(c), binormal(c))


@formula("eq. (20)", on="space")
def focal_surface_by_radius(c):
    """``γ + κ⁻¹N + μB`` with B of (14)."""
    return ruled(c.gamma + radius_vector(c), binormal(c))
