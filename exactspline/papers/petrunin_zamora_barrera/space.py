"""Space curves: curvature, the Frenet frame, torsion, spheres.

Formulas printed for curves parametrized by arc length are written for any parameter: ``K = κN`` is the derivative of
the unit tangent with respect to arc length, and square roots are avoided by squaring and by the products ``κN``,
``‖γ′‖κB = γ′ × K``.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import speed_squared


@formula("chapter Curvature", symbol="K")
def acceleration_by_arc_length(c):
    """``γ″`` of the curve parametrized by arc length: ``(γ′/‖γ′‖)′/‖γ′‖``."""
    return (c.gamma.d(2) * speed_squared(c) - c.gamma.d(1) * speed_squared(c).d(1) / 2) / speed_squared(c) ** 2


@formula("Proposition \\ref{prop:a'-pertp-a''}")
def acceleration_on_velocity(c):
    """``⟨γ′, γ″⟩`` for arc length: zero if they are orthogonal."""
    return dot(acceleration_by_arc_length(c), c.gamma.d(1))


@formula("chapter Curvature")
def acceleration_squared(c):
    """``|γ″|²`` for arc length: the squared curvature."""
    return norm2(acceleration_by_arc_length(c))


@formula("ex:curvature-formulas, b", on="space")
def curvature_squared_by_product(c):
    """``|γ″ × γ′|² / |γ′|⁶``."""
    return norm2(cross(c.gamma.d(2), c.gamma.d(1))) / speed_squared(c) ** 3


@formula("ex:curvature-formulas, a")
def normal_part(c):
    """``w``: the projection of γ″ onto the plane normal to γ′."""
    return c.gamma.d(2) - c.gamma.d(1) * (dot(c.gamma.d(1), c.gamma.d(2)) / speed_squared(c))


@formula("ex:curvature-formulas, a")
def curvature_squared_by_projection(c):
    """``|w|² / |γ′|⁴``."""
    return norm2(normal_part(c)) / speed_squared(c) ** 2


@formula("eq:curvature")
def indicatrix_speed_squared(c):
    """``|T′|²`` for the tangent indicatrix ``T = γ′/|γ′|``."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return (norm2(b) * speed_squared(c) - dot(a, b) ** 2) / speed_squared(c) ** 2


@formula("chapter Torsion, Frenet frame", on="space")
def binormal_by_arc_length(c):
    """``γ′ × K``: the binormal ``B = T × N`` times ``|γ′|κ``."""
    return cross(c.gamma.d(1), acceleration_by_arc_length(c))


@formula("chapter Torsion", on="space", symbol=r"\tau")
def torsion_by_definition(c):
    """``τ = ⟨N′, B⟩`` for arc length: ``⟨K′, γ′ × K⟩ / (|γ′|²κ²)``."""
    above = dot(acceleration_by_arc_length(c).d(1), binormal_by_arc_length(c))
    return above / (speed_squared(c) * acceleration_squared(c))


@formula("ex:frenet", on="space", symbol=r"\tau")
def torsion_by_derivatives(c):
    """``⟨γ′ × γ″, γ‴⟩ / |γ′ × γ″|²``."""
    binormal = cross(c.gamma.d(1), c.gamma.d(2))
    return dot(binormal, c.gamma.d(3)) / norm2(binormal)


@formula("eq:frenet-nu", on="space")
def frenet_equation_of_the_normal(c):
    """``K′ − (κ²)′/(2κ²) K + κ²γ′ − τ γ′ × K``: zero if ``N′ = −κT + τB``."""
    k, bend = acceleration_by_arc_length(c), acceleration_squared(c)
    along = c.gamma.d(1) * bend - binormal_by_arc_length(c) * torsion_by_derivatives(c)
    return k.d(1) - k * (bend.d(1) / (2 * bend)) + along


@formula("eq:frenet-beta", on="space")
def frenet_equation_of_the_binormal(c):
    """``b′ − (|b|²)′/(2|b|²) b + |γ′|²τK`` for ``b = γ′ × K``: zero if ``B′ = −τN``."""
    b, k = binormal_by_arc_length(c), acceleration_by_arc_length(c)
    return b.d(1) - b * (norm2(b).d(1) / (2 * norm2(b))) + k * (speed_squared(c) * torsion_by_derivatives(c))


@formula("ex:lancret, b", on="space")
def lancret_vector(c):
    """``|γ′|κ (τ/κ T + B)``."""
    return c.gamma.d(1) * torsion_by_derivatives(c) + binormal_by_arc_length(c)


@formula("ex:lancret, b", on="space")
def lancret_derivative(c):
    """The derivative of ``w = τ/κ T + B`` minus ``(τ/κ)′ T``, times ``|γ′|κ``."""
    v, bend, tau = lancret_vector(c), acceleration_squared(c), torsion_by_derivatives(c)
    square = speed_squared(c) * bend
    ratio = tau.d(1) - tau * (bend.d(1) / (2 * bend))
    return v.d(1) - v * (square.d(1) / (2 * square)) - c.gamma.d(1) * ratio


@formula("section Spherical curves", on="space")
def sphere_offset_along_binormal(c):
    """``κ′/(κ²τ) B``, with the derivative with respect to arc length."""
    bend = acceleration_squared(c)
    return binormal_by_arc_length(c) * (bend.d(1) / (2 * speed_squared(c) * bend**2 * torsion_by_derivatives(c)))


@formula("section Spherical curves", on="space")
def towards_the_circle(c):
    """``(1/κ) N``: the vector from the curve to the centre of its osculating circle."""
    return acceleration_by_arc_length(c) / acceleration_squared(c)


@formula("section Spherical curves", on="space")
def sphere_centre_meant(c):
    """``γ + (1/κ)N − κ′/(κ²τ) B``."""
    return c.gamma + towards_the_circle(c) - sphere_offset_along_binormal(c)


@formula("section Spherical curves", on="space")
def sphere_radius_squared(c):
    """The squared distance of this centre from the curve."""
    return norm2(sphere_centre_meant(c) - c.gamma)


@formula("section Spherical curves, Theorem", on="space")
def spherical_identity(c):
    """``κ′² − τ²κ²(κ² − 1)`` for arc length, times ``4κ²``: zero where ``|κ′/τ| = κ√(κ² − 1)``."""
    bend = acceleration_squared(c)
    return bend.d(1) ** 2 / speed_squared(c) - 4 * torsion_by_derivatives(c) ** 2 * bend**2 * (bend - 1)


@formula("section Spherical curves, Theorem", on="space")
def off_the_unit_sphere(c):
    """The squared radius of the osculating sphere, minus 1."""
    return sphere_radius_squared(c) - 1
