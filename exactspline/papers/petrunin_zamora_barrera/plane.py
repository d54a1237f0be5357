"""Plane curves: signed curvature, osculating circles, the evolute, inversion."""

from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, norm2, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import speed_squared


@formula("chapter Signed curvature", on="plane")
def turning_left(c):
    """``⟨γ″, γ′⊥⟩`` with γ′⊥ = γ′ rotated left: the signed curvature times ``|γ′|³``."""
    return dot(c.gamma.d(2), perp(c.gamma.d(1)))


@formula("eq:tau'", on="plane")
def frenet_equation_of_the_tangent(c):
    """``γ″ − γ′ (|γ′|²)′/(2|γ′|²) − |γ′|k γ′⊥``: zero if ``T′ = kN``."""
    a, stretch = c.gamma.d(1), speed_squared(c).d(1) / (2 * speed_squared(c))
    return c.gamma.d(2) - a * stretch - perp(a) * (turning_left(c) / speed_squared(c))


@formula("eq:nu'", on="plane")
def frenet_equation_of_the_left_normal(c):
    """``n′ − n (|γ′|²)′/(2|γ′|²) + |γ′|k γ′`` for n = γ′⊥: zero if ``N′ = −kT``."""
    a, stretch = c.gamma.d(1), speed_squared(c).d(1) / (2 * speed_squared(c))
    return perp(a).d(1) - perp(a) * stretch + a * (turning_left(c) / speed_squared(c))


@formula("ex:curvature-graph", on="plane", symbol="f'")
def graph_slope(c):
    """The derivative of y with respect to x: f′ for the curve as a graph ``y = f(x)``."""
    return c.gamma.d(1)[1] / c.gamma.d(1)[0]


@formula("ex:curvature-graph", on="plane", symbol="f''")
def graph_bend(c):
    """The derivative of the slope with respect to x: f″ for the curve as a graph."""
    return graph_slope(c).d(1) / c.gamma.d(1)[0]


@formula("ex:curvature-graph", on="plane")
def curvature_squared_of_graph(c):
    """``f″² / (1 + f′²)³``."""
    return graph_bend(c) ** 2 / (1 + graph_slope(c) ** 2) ** 3


@formula("spiral lemma", on="plane")
def towards_the_centre(c):
    """``(1/k) N``: the vector from the curve to its centre of curvature."""
    return perp(c.gamma.d(1)) * (speed_squared(c) / turning_left(c))


@formula("spiral lemma", on="plane", symbol=r"\omega")
def centre_of_curvature(c):
    """``γ + (1/k) N``."""
    return c.gamma + towards_the_centre(c)


@formula("osculating circline", on="plane")
def radius_squared(c):
    """The squared distance of the centre from the curve."""
    return norm2(towards_the_centre(c))


@formula("osculating circline", on="plane")
def inverse_curvature_squared(c):
    """``1/k²``."""
    return speed_squared(c) ** 3 / turning_left(c) ** 2


@formula("spiral lemma", on="plane")
def evolute_velocity(c):
    """``(1/k)′ N``, with the derivative with respect to the parameter."""
    s, k = speed_squared(c), turning_left(c)
    return perp(c.gamma.d(1)) * (3 * s.d(1) / (2 * k) - s * k.d(1) / k**2)


@formula("spiral lemma", on="plane")
def centre_velocity(c):
    """The derivative of the centre of curvature."""
    return centre_of_curvature(c).d(1)


@formula("osculating circline", on="plane")
def circle_third_contact(c):
    """``(ω − γ)·γ‴ − 3 γ′·γ″``: zero where the contact is of third order."""
    return dot(towards_the_centre(c), c.gamma.d(3)) - 3 * dot(c.gamma.d(1), c.gamma.d(2))


@formula("supporting curves, vertex", on="plane")
def signed_curvature_derivative(c):
    """The derivative of the signed curvature, times ``|γ′|⁵``."""
    return turning_left(c).d(1) * speed_squared(c) - turning_left(c) * speed_squared(c).d(1) * 3 / 2


@formula("ex:inverse", on="plane")
def inverse_curve(c):
    """The inversion of the curve with respect to the unit circle."""
    return c.gamma / norm2(c.gamma)


@formula("ex:inverse", on="plane")
def centre_of_the_inverse(c):
    """The centre of curvature of the inverse curve."""
    a, b = inverse_curve(c).d(1), inverse_curve(c).d(2)
    return inverse_curve(c) + perp(a) * (norm2(a) / det(a, b))


@formula("ex:inverse", on="plane")
def inverse_of_the_circle(c):
    """The centre of the inversion of the osculating circle: ``ω / (|ω|² − r²)``."""
    centre = centre_of_curvature(c)
    return centre / (norm2(centre) - radius_squared(c))


@formula("ex:evolute", on="plane")
def evolute_curvature_squared(c):
    """The squared curvature of the evolute."""
    a, b = centre_of_curvature(c).d(1), centre_of_curvature(c).d(2)
    return det(a, b) ** 2 / norm2(a) ** 3


@formula("ex:evolute", on="plane")
def evolute_curvature_squared_by_frenet(c):
    """``(k³/k′)²``, with the derivative with respect to arc length."""
    return turning_left(c) ** 6 / (signed_curvature_derivative(c) ** 2 * speed_squared(c) ** 3)
