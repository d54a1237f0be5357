"""§4: plane curves."""

from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, norm2, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D1, D2, D3, D21, D1_squared, speed_squared


@formula("§4.1", on="plane", symbol="f_0")
def f0(c):
    """Numerator of the curvature: ``[γ′ γ″]``, naive."""
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("§4.1, Remark 3.1", on="plane", symbol="f_1")
def f1(c):
    """``[D1 D2]``, which vanishes with the curvature."""
    return det(D1(c), D2(c))


@formula("eq. (8)", on="plane")
def f1_expanded(c):
    """``[D1 D2]`` expanded, as printed in eq. (8)."""
    p, w = c.p, c.w
    return det(p.d(1), p.d(2)) * w**2 - det(p, p.d(2)) * (w.d(1) * w) - det(p.d(1), p) * (w * w.d(2))


@formula("eq. (8)", on="plane", symbol="f_2")
def f2(c):
    """Zero-curvature form of a rational plane curve: eq. (8) without its common factor w."""
    p, w = c.p, c.w
    return det(p.d(1), p.d(2)) * w - det(p, p.d(2)) * w.d(1) - det(p.d(1), p) * w.d(2)


@formula("eq. (9)", on="plane", symbol=r"\kappa^2")
def curvature_squared(c):
    """Squared curvature ``[γ′ γ″]² / ‖γ′‖⁶``, naive."""
    return f0(c) ** 2 / speed_squared(c) ** 3


@formula("§4.2, squaring approach", on="plane", symbol=r"(\kappa^2)'")
def curvature_squared_derivative(c):
    """Derivative of the squared curvature by the quotient rule."""
    return curvature_squared(c).d(1)


@formula("§4.2, squaring approach", on="plane")
def curvature_squared_derivative_numerator(c):
    """Numerator ``p′w − pw′`` of (κ²)′ for ``κ² = p/w``, ``p = [γ′ γ″]²``, ``w = ‖γ′‖⁶``, before it is raised."""
    p, w = f0(c) ** 2, speed_squared(c) ** 3
    return p.d(1) * w - p * w.d(1)


@formula("§4.2", on="plane")
def curvature_derivative_numerator(c):
    """``κ′ ‖γ′‖⁵`` from ``κ = f0 (‖γ′‖²)^(−3/2)`` by the chain rule."""
    return f0(c).d(1) * speed_squared(c) - f0(c) * speed_squared(c).d(1) * 3 / 2


@formula("eq. (10)", on="plane")
def g0_term_1(c):
    """First term of g0."""
    return speed_squared(c) * det(c.gamma.d(1), c.gamma.d(3))


@formula("eq. (10)", on="plane")
def g0_term_2(c):
    """Second term of g0."""
    return 3 * dot(c.gamma.d(1), c.gamma.d(2)) * f0(c)


@formula("eq. (10)", on="plane", symbol="g_0")
def g0(c):
    """Numerator of κ′ over ‖γ′‖⁵, the direct approach, naive."""
    return g0_term_1(c) - g0_term_2(c)


@formula("§4.2", on="plane", symbol="g_1")
def g1(c):
    """g0 with the derivatives replaced by eq. (5), as printed."""
    speed, kappa = D1_squared(c), f1(c)
    stretch = 2 * c.w.d(1) / c.w
    return (
        det(D1(c), D3(c)) * speed + det(D1(c), D21(c)) * speed + stretch * kappa * speed - 3 * dot(D1(c), D2(c)) * kappa
    )


@formula("eq. (11)", on="plane")
def g2_term_1(c):
    """First term of g2."""
    return det(D1(c), D3(c)) * D1_squared(c) * c.w


@formula("eq. (11)", on="plane")
def g2_term_2(c):
    """Second term of g2."""
    return det(D1(c), D21(c)) * D1_squared(c) * c.w


@formula("eq. (11)", on="plane")
def g2_term_3(c):
    """Third term of g2."""
    return 2 * c.w.d(1) * f1(c) * D1_squared(c)


@formula("eq. (11)", on="plane")
def g2_term_4(c):
    """Fourth term of g2."""
    return 3 * dot(D1(c), D2(c)) * f1(c) * c.w


@formula("eq. (11)", on="plane", symbol="g_2")
def g2(c):
    """Critical-curvature form of a rational plane curve."""
    return g2_term_1(c) + g2_term_2(c) + g2_term_3(c) - g2_term_4(c)


@formula("§4.2", on="plane")
def f0_g0(c):
    """``f0 g0``: vanishes where the curvature or its derivative does."""
    return f0(c) * g0(c)


@formula("§4.3, next to eq. (12)", on="plane")
def curvature_radius_squared(c):
    """``1/κ²``."""
    return 1 / curvature_squared(c)


@formula("eq. (12)", on="plane", symbol="E")
def evolute(c):
    """Evolute ``γ + (‖γ′‖²/[γ′ γ″]) γ′⊥``, naive."""
    return c.gamma + (speed_squared(c) / f0(c)) * perp(c.gamma.d(1))


@formula("§4.3, below eq. (12)", on="plane", symbol="E")
def evolute_reduced(c):
    """Evolute as one quotient of polynomials in D1 and D2."""
    return (c.p * (f1(c) * c.w) + perp(D1(c)) * D1_squared(c)) / (f1(c) * c.w**2)


@formula("§4.3, footnote b", on="plane", symbol="E")
def evolute_by_frenet(c):
    """``γ + (1/κ)N`` with the normal of the Frenet frame and its κ: ``γ + κN/κ²``, where κN is the derivative of the
    unit tangent with respect to arc length.
    """
    a, b, speed = c.gamma.d(1), c.gamma.d(2), speed_squared(c)
    return c.gamma + (b / speed - a * (dot(a, b) / speed**2)) / curvature_squared(c)


@formula("definition of the evolute", on="plane")
def evolute_contact_1(c):
    """``(E − γ)·γ′``: zero if the circle around E has contact of first order."""
    return dot(evolute(c) - c.gamma, c.gamma.d(1))


@formula("definition of the evolute", on="plane")
def evolute_contact_2(c):
    """``(E − γ)·γ″ − ‖γ′‖²``: zero if the circle around E has contact of second order."""
    return dot(evolute(c) - c.gamma, c.gamma.d(2)) - speed_squared(c)


@formula("eq. (7)", on="plane")
def curvature_of_osculating_circle(c):
    """``κ² ‖E − γ‖² − 1``: zero when |κ| is the reciprocal of the radius of the osculating circle."""
    return curvature_squared(c) * norm2(evolute(c) - c.gamma) - 1
