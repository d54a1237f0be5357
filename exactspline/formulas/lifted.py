"""Curves from their two lifts, by Wronskians and generalized cross products.

``P = (w, p)`` is the curve in projective space: points, lines and planes are linear in it. ``X = (‖p‖², w p, w²)`` is
the curve in the space of the conformal (sphere) model: the point lies on the sphere ``a ‖x‖² + b·x + c = 0`` where
``(a, b, c)·X = 0``, and the centre is ``−b/(2a)``. A sphere of n-point contact is orthogonal to X and its first n−1
derivatives, so it is their generalized cross product. On a polynomial curve w is 1.
"""

from exactspline.language.formula import formula
from exactspline.language.ruled import ruled
from exactspline.language.vector import cross, det, dot, generalized_cross, join, norm2
from exactspline.language.wronskians import logarithmic_numerator, osculating, wronskian, wronskians


@formula("projective lift", symbol="P")
def projective_lift(c):
    """``(w, p)``; w first, so that the signs of Wronskians are those of ``[γ′ γ″]`` and ``[γ′ γ″ γ‴]``."""
    return join(c.w, c.p)


@formula("conformal lift", symbol="X")
def conformal_lift(c):
    """``(‖p‖², w p, w²)``."""
    return join(norm2(c.p), c.p * c.w, c.w**2)


@formula("lifted", symbol="D_1")
def tangent_lifted(c):
    """``w p′ − w′ p``, the Wronskians of w and each coordinate: the D1 of the paper, ``w² γ′``."""
    return wronskians(c.w, c.p)


@formula("lifted", symbol=r"\|D_1\|^2")
def tangent_lifted_squared(c):
    """``w⁴ ‖γ′‖²``: nonzero where the curve is regular."""
    return norm2(tangent_lifted(c))


@formula("lifted", on="plane")
def inflections_lifted(c):
    """The Wronskian of P: zero where the tangent meets the curve to third order."""
    return wronskian(projective_lift(c), 3)


@formula("lifted", on="plane")
def curvature_squared_lifted(c):
    """Squared curvature in terms of the Wronskian of P."""
    return (inflections_lifted(c) * c.w**3) ** 2 / tangent_lifted_squared(c) ** 3


@formula("lifted", on="plane")
def vertices_lifted(c):
    """The Wronskian of X: zero where a circle meets the curve to fourth order, that is, where κ′ is zero."""
    return wronskian(conformal_lift(c), 4)


@formula("lifted", on="plane", symbol=r"J_\kappa")
def critical_curvature_lifted(c):
    """The numerator of the logarithmic derivative of ``κ²``: equivalent to the Wronskian of X, with a third of
    the products.
    """
    return logarithmic_numerator((inflections_lifted(c), 2), (tangent_lifted_squared(c), -3), (c.w, 6))


#: κ, κ′ and ‖γ′‖² of a plane curve up to positive factors: the zeros of these forms give the features of the curve.
PLANE_FORMS = (inflections_lifted, critical_curvature_lifted, tangent_lifted_squared)


@formula("lifted", on="plane", symbol="S")
def osculating_circle(c):
    """The circle through three consecutive points of the curve, given by ``(a, b, c)``: ``a ‖x‖² + b·x + c = 0``."""
    return osculating(conformal_lift(c), 3)


@formula("lifted", on="plane", symbol="E")
def evolute_lifted(c):
    """The centre of the osculating circle."""
    circle = osculating_circle(c)
    return -circle[1:3] / (2 * circle[0])


@formula("lifted", on="space")
def torsion_zeros_lifted(c):
    """The Wronskian of P: zero where the osculating plane meets the curve to fourth order."""
    return wronskian(projective_lift(c), 4)


@formula("lifted", on="space", symbol=r"\Pi")
def osculating_plane(c):
    """The plane through three consecutive points of the curve: its normal, after its first coordinate, is ``w³ γ′
    × γ″``.
    """
    return osculating(projective_lift(c), 3)


@formula("lifted", on="space", symbol="b")
def binormal_lifted(c):
    """The normal of the osculating plane."""
    return osculating_plane(c)[1:4]


@formula("lifted", on="space")
def binormal_lifted_squared(c):
    """``‖Π‖²`` for the normal Π of the osculating plane."""
    return norm2(binormal_lifted(c))


@formula("lifted", on="space", symbol=r"\tau")
def torsion_lifted(c):
    """Torsion: the Wronskian of P over the squared length of the binormal."""
    return (torsion_zeros_lifted(c) * c.w**2) / binormal_lifted_squared(c)


@formula("lifted", on="space", symbol=r"\kappa^2")
def space_curvature_squared_lifted(c):
    """Squared curvature from the binormal of the osculating plane."""
    return (binormal_lifted_squared(c) * c.w**6) / tangent_lifted_squared(c) ** 3


@formula("lifted", on="space", symbol=r"J_\kappa")
def space_critical_curvature_lifted(c):
    """The numerator of the logarithmic derivative of ``κ²``: the Jacobian of the two covariants whose quotient is κ²,
    without common factors.
    """
    return logarithmic_numerator((binormal_lifted_squared(c), 1), (tangent_lifted_squared(c), -3), (c.w, 6))


#: τ, κ′, ‖γ′‖² and ‖γ′ × γ″‖² of a space curve up to positive factors.
SPACE_FORMS = (torsion_zeros_lifted, space_critical_curvature_lifted, tangent_lifted_squared, binormal_lifted_squared)


@formula("lifted", on="space", symbol="S")
def osculating_sphere(c):
    """The sphere through four consecutive points of the curve."""
    return osculating(conformal_lift(c), 4)


@formula("lifted", on="space", symbol="F")
def focal_curve_lifted(c):
    """The centre of the osculating sphere."""
    sphere = osculating_sphere(c)
    return -sphere[1:4] / (2 * sphere[0])


@formula("lifted", on="space", symbol="S")
def circle_sphere(c):
    """The sphere through three consecutive points with its centre in their plane, orthogonal to ``(2 Π_0, −Π, 0)``."""
    x, plane = conformal_lift(c), osculating_plane(c)
    return generalized_cross(x, x.d(1), x.d(2), join(2 * plane[0], -plane[1:4], 0))


@formula("lifted", on="space", symbol="E")
def circle_centre_lifted(c):
    """The centre of the osculating circle of a space curve."""
    sphere = circle_sphere(c)
    return -sphere[1:4] / (2 * sphere[0])


@formula("lifted", on="space")
def normal_lifted(c):
    """The principal normal direction: orthogonal to the tangent, in the osculating plane."""
    return cross(binormal_lifted(c), tangent_lifted(c))


@formula("lifted", on="space")
def rectifying_generator_lifted(c):
    """The direction of ``τT + κB`` without denominators."""
    b = binormal_lifted(c)
    return tangent_lifted(c) * (torsion_zeros_lifted(c) * tangent_lifted_squared(c)) + b * (
        c.w * binormal_lifted_squared(c)
    )


@formula("definition of a developable", on="space")
def rectifying_development(c):
    """``[D1 G G′] / ‖G‖²`` for the generator G without denominators: zero if the surface is developable."""
    generator = rectifying_generator_lifted(c)
    return det(tangent_lifted(c), generator, generator.d(1)) / norm2(generator)


@formula("lifted", on="space")
def tangent_developable_lifted(c):
    """``p/w + λ D1``."""
    return ruled(c.gamma, tangent_lifted(c))


@formula("lifted", on="space")
def binormal_scroll_lifted(c):
    """``p/w + λ Π``: rulings along the normal of the osculating plane."""
    return ruled(c.gamma, binormal_lifted(c))


@formula("lifted", on="space")
def normal_scroll_lifted(c):
    """Rulings through ``p/w`` along the principal normal."""
    return ruled(c.gamma, normal_lifted(c))


@formula("lifted", on="space")
def rectifying_developable_lifted(c):
    """Rulings through ``p/w`` in the direction of ``τT + κB``."""
    return ruled(c.gamma, rectifying_generator_lifted(c))


@formula("lifted", on="space")
def focal_surface_lifted(c):
    """Rulings through the centre of the osculating circle, along the normal of the osculating plane."""
    return ruled(circle_centre_lifted(c), binormal_lifted(c))


@formula("projective lift of the point", on="point")
def projective_point(c):
    """``(1, Q)``."""
    return join(1, c.point)


@formula("conformal lift of the point", on="point")
def conformal_point(c):
    """``(‖Q‖², Q, 1)``."""
    return join(norm2(c.point), c.point, 1)


@formula("lifted", on="pair", symbol="S")
def bisector_sphere(c):
    """The sphere that is tangent to each of two curves at a given point."""
    x, y = conformal_lift(c.first), conformal_lift(c.second)
    return generalized_cross(x, x.d(1), y, y.d(1))


@formula("lifted", on="pair", symbol="B")
def bisector_lifted(c):
    """The centre of the sphere tangent to both curves."""
    sphere = bisector_sphere(c)
    return -sphere[1:4] / (2 * sphere[0])


@formula("lifted", on="plane point", symbol="B")
def plane_bisector_lifted(c):
    """The centre of the circle through Q that is tangent to the curve."""
    x = conformal_lift(c)
    circle = generalized_cross(x, x.d(1), conformal_point(c))
    return -circle[1:3] / (2 * circle[0])


@formula("lifted", on="point", symbol=r"\Pi")
def tangent_plane_through_point(c):
    """The plane through the tangent and Q; its normal is the direction of the line of centres of the spheres through Q
    that are tangent to the curve.
    """
    x = projective_lift(c)
    return generalized_cross(x, x.d(1), projective_point(c))


@formula("lifted", on="point")
def point_bisector_lifted(c):
    """The point/curve bisector, with the directrix in the plane of the tangent and Q."""
    x, plane = conformal_lift(c), tangent_plane_through_point(c)
    sphere = generalized_cross(x, x.d(1), conformal_point(c), join(2 * plane[0], -plane[1:4], 0))
    return ruled(-sphere[1:4] / (2 * sphere[0]), plane[1:4])


@formula("lifted", on="point")
def point_bisector_direct_lifted(c):
    """The point/curve bisector, with the directrix in the plane z = 0."""
    x = conformal_lift(c)
    sphere = generalized_cross(x, x.d(1), conformal_point(c), join(0, c.axis_z, 0))
    return ruled(-sphere[1:4] / (2 * sphere[0]), tangent_plane_through_point(c)[1:4])


@formula("lifted", on="point")
def lifted_directrix_in_tangent_plane(c):
    """``Π·(1, δ)``: zero where the directrix lies in the plane of the tangent and Q."""
    plane = tangent_plane_through_point(c)
    return plane[0] + dot(plane[1:4], point_bisector_lifted(c).directrix)


@formula("lifted", on="point")
def lifted_directrix_height(c):
    """The third component of the directrix of the direct form."""
    return dot(c.axis_z, point_bisector_direct_lifted(c).directrix)


@formula("lifted", on="plane")
def osculating_circle_coefficient(c):
    """The coefficient of ``‖x‖²`` in the osculating circle: zero where it is a line."""
    return osculating_circle(c)[0]


@formula("lifted", on="space")
def osculating_sphere_coefficient(c):
    """The coefficient of ``‖x‖²`` in the osculating sphere: zero where it is a plane."""
    return osculating_sphere(c)[0]


@formula("lifted", on="space")
def circle_sphere_coefficient(c):
    """The coefficient of ``‖x‖²`` in the sphere that has the osculating circle as a great circle."""
    return circle_sphere(c)[0]


@formula("lifted", on="pair")
def bisector_sphere_coefficient(c):
    """The coefficient of ``‖x‖²`` in the sphere tangent to two curves."""
    return bisector_sphere(c)[0]


@formula("lifted", on="point")
def point_bisector_lifted_directrix(c):
    """The directrix in the plane of the tangent and Q."""
    return point_bisector_lifted(c).directrix


@formula("lifted", on="point")
def point_bisector_lifted_generator(c):
    """The normal of the plane through the tangent and Q."""
    return point_bisector_lifted(c).generator


@formula("lifted", on="point")
def point_bisector_direct_lifted_directrix(c):
    """The directrix in the plane z = 0."""
    return point_bisector_direct_lifted(c).directrix
