"""Remarks of the paper outside of its displays: circles and spheres, reasons, degrees by the last column of Table 1,
planes and lines of §6. Each formula belongs to a sentence that no display of the paper states.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, join, norm2, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.bisector import (
    bisector_determinant_symmetric,
    bisector_numerators_symmetric,
    directrix_numerators_printed,
    point_bisector_determinant_polynomial,
    point_bisector_generator,
    point_middle_normal,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import (
    D1,
    D2,
    D3,
    D21,
    D1_squared,
    acceleration_first_term,
    velocity_shared,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.frames import radius_derivative_along_binormal
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f1, f2, g2
from exactspline.papers.chen_riesenfeld_cohen_2007.space import psi, rectifying_developable_reduced


@formula("§1, circles", on="plane")
def circle_by_two_functions(c):
    """``(u² − v², 2uv)/(u² + v²)`` with the coordinates u, v of p: of degree 2 where they are linear."""
    u, v = c.p[0], c.p[1]
    return join(u * u - v * v, 2 * (u * v)) / (u * u + v * v)


@formula("§1, circles", on="plane")
def off_the_circle(c):
    """The squared distance of that point from the origin, less 1."""
    return norm2(circle_by_two_functions(c)) - 1


@formula("§1, spheres", on="space")
def sphere_by_three_functions(c):
    """``(2ut, 2vt, u² + v² − t²)/(u² + v² + t²)`` with the coordinates u, v, t of p."""
    u, v, t = c.p[0], c.p[1], c.p[2]
    below = u * u + v * v + t * t
    return join(2 * (u * t), 2 * (v * t), u * u + v * v - t * t) / below


@formula("§1, spheres", on="space")
def off_the_sphere(c):
    """The squared distance of that point from the origin, less 1."""
    return norm2(sphere_by_three_functions(c)) - 1


@formula("§2, division", on="table")
def quotient_of_a_multiple(t):
    """``(p1 p2)/p2``."""
    return (t.p1 * t.p2) / t.p2


def _raised(numerator, denominator, first):
    """Numerator and denominator of a quotient, raised to one degree: the degree of a rational in the last column of
    Table 1. `first` is a component of the numerator.
    """
    return numerator.elevated_to(denominator), denominator.elevated_to(first)


@formula("eq. (12), by the degrees of Table 1", on="plane", symbol="E")
def evolute_by_columns(c):
    """The evolute, where w = 1 by T3, T6 and T4, after each of which a rational has one degree."""
    n, m = _raised(D1_squared(c), f1(c), D1_squared(c))
    turned = perp(D1(c)) * n
    n, m = _raised(turned, m, turned[0])
    return (c.p * (m * c.w) + n) / (m * c.w**2)


@formula("eqs. (27), (28), by the degrees of Table 1", on="pair", symbol="B")
def bisector_by_columns(c):
    """The bisector as wB divided by w, polynomial in both curves: by T3 and T8, after each of which a rational has one
    degree.
    """
    numerators = bisector_numerators_symmetric(c)
    n, m = _raised(numerators, bisector_determinant_symmetric(c) * c.second.w, numerators[0])
    n, m = _raised(n, m * c.first.w, n[0])
    return n / m


@formula("eq. (34), as printed, by the degrees of Table 1", on="point", symbol=r"\delta")
def directrix_by_columns(c):
    """The directrix as wδ divided by w, by T3 and T8, after each of which a rational has one degree."""
    numerators = directrix_numerators_printed(c)
    n, m = _raised(numerators, point_bisector_determinant_polynomial(c), numerators[0])
    n, m = _raised(n, m * c.w, n[0])
    return n / m


@formula("§3, antisymmetry")
def first_components(c):
    """The first components of D1, D2, D3 and D21."""
    return join(D1(c)[0], D2(c)[0], D3(c)[0], D21(c)[0])


@formula("§3, antisymmetry")
def first_components_exchanged(c):
    """The first components of D1, D2, D3 and D21, with the first coordinate of p and w exchanged."""
    x, w = c.p[0], c.w
    first, second, third = (w.d(n) * x - w * x.d(n) for n in (1, 2, 3))
    return join(first, second, third, w.d(2) * x.d(1) - w.d(1) * x.d(2))


@formula("§3, last paragraph")
def weight(c):
    """``w``."""
    return c.w


@formula("eq. (11), Remark 3.1", on="plane")
def D1_dot_D2(c):
    """``D1 · D2``."""
    return dot(D1(c), D2(c))


@formula("eq. (11), Remark 3.1", on="plane")
def D1_D21(c):
    """``[D1 D21]``."""
    return det(D1(c), D21(c))


@formula("§4.2, squaring approach", on="plane")
def flat_and_stationary(c):
    """``f2² + g2²``: zero where the curvature and its derivative both vanish."""
    return f2(c) ** 2 + g2(c) ** 2


@formula("§4.3, last paragraph", on="plane", symbol="E")
def evolute_by_first_terms(c):
    """(12) with γ⁽ⁱ⁾ replaced by ``Di/w²``."""
    a, b = velocity_shared(c), acceleration_first_term(c)
    return c.gamma + (norm2(a) / det(a, b)) * perp(a)


@formula("§4.3, last paragraph", on="plane")
def evolute_by_D(c):
    """(12) with γ⁽ⁱ⁾ replaced by ``Di`` alone."""
    a, b = D1(c), D2(c)
    return c.gamma + (norm2(a) / det(a, b)) * perp(a)


@formula("§5.4, reduced", on="space")
def rectifying_vector_reduced(c):
    """``[D1 D2 D3]/‖D1×D2‖² D1 + D1×D2/‖D1‖²``."""
    return rectifying_developable_reduced(c).generator


@formula("§5.5", on="space")
def psi_squared(c):
    """``‖Ψ‖²``."""
    return norm2(psi(c))


@formula("§7, first sentence", on="space")
def acceleration_rest_along_acceleration(c):
    """``γ″ × (γ″ − D2/w²)``."""
    return cross(c.gamma.d(2), c.gamma.d(2) - acceleration_first_term(c))


@formula("§6.1, the plane of the middle", on="pair")
def middle_height_through_midpoint(c):
    """``(γ − γ̄)·(γ + γ̄)/2``: the height of the plane through the midpoint with normal γ − γ̄."""
    a, b = c.first.gamma, c.second.gamma
    return dot(a - b, a + b) / 2


@formula("§6.1, existence", on="pair")
def determinant_of_one_plane(c):
    """``[γ′ γ̄′ γ − γ̄]`` of two curves of the plane z = x, with the first two coordinates of γ and of γ̄."""
    a, b = c.first.gamma, c.second.gamma
    first, second, chord = (join(v[0], v[1], v[0]) for v in (a.d(1), b.d(1), a - b))
    return det(first, second, chord)


@formula("§6.1, denominators", on="pair")
def denominator_of_second_normal(c):
    """``w̄²``: the denominator of γ̄′."""
    return c.second.w**2


@formula("§6.1, denominators", on="pair")
def denominator_of_second_height(c):
    """``w̄³``: the denominator of γ̄·γ̄′."""
    return c.second.w**3


@formula("§6.1, denominators", on="pair")
def denominator_of_middle_normal(c):
    """``w w̄``: the denominator of γ − γ̄."""
    return c.first.w * c.second.w


@formula("§6.1, denominators", on="pair")
def denominator_of_middle_height(c):
    """``w² w̄²``: the denominator of the third height."""
    return c.first.w**2 * c.second.w**2


@formula("§6.1, denominators", on="pair")
def denominator_of_pair_1(c):
    """``w³ · w̄² · w w̄``: the denominator of the terms of D0 with the first height."""
    return c.first.w**3 * denominator_of_second_normal(c) * denominator_of_middle_normal(c)


@formula("§6.1, denominators", on="pair")
def denominator_of_pair_2(c):
    """``w² · w̄³ · w w̄``: the denominator of the terms of D0 with the second height."""
    return c.first.w**2 * denominator_of_second_height(c) * denominator_of_middle_normal(c)


@formula("§6.1, denominators", on="pair")
def denominator_of_pair_3(c):
    """``w² · w̄² · w² w̄²``: the denominator of the terms of D0 with the third height."""
    return c.first.w**2 * denominator_of_second_normal(c) * denominator_of_middle_height(c)


@formula("§6.2, the lines", on="point")
def generator_in_normal_plane(c):
    """``G·γ′``: zero where the generator lies in the first plane."""
    return dot(point_bisector_generator(c), c.gamma.d(1))


@formula("§6.2, the lines", on="point")
def generator_in_middle_plane(c):
    """``G·(γ − Q)``: zero where the generator lies in the second plane."""
    return dot(point_bisector_generator(c), point_middle_normal(c))


@formula("§6.2, the lines", on="point")
def generator_squared(c):
    """``‖γ′ × (γ − Q)‖²``."""
    return norm2(point_bisector_generator(c))


@formula("§6.2, parallel planes", on="space")
def generator_for_a_point_on_the_tangent(c):
    """``γ′ × (γ − Q)`` for the point ``Q = γ + xγ′`` of the tangent, x the first coordinate of p."""
    a = c.gamma.d(1)
    return cross(a, c.gamma - (c.gamma + a * c.p[0]))


@formula("§5.5, solving for ‖γ′‖", on="framed space")
def radius_derivative_along_psi(c):
    """``(1/κ)′𝐁 · Ψ``."""
    return dot(radius_derivative_along_binormal(c), psi(c))
