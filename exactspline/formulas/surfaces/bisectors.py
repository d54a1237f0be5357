"""Bisectors of a surface with a point, the origin of coordinates; and of a surface with a curve, for a given point of
the curve or of the surface, which then is the origin.

The points as far from the origin as from S, on the normal of the surface there, are centres of spheres through the
origin that touch the surface. Inversion maps these spheres to planes: ``(‖p‖², w p)`` is the projective lift of the
inverse surface ``S/‖S‖²``, and its tangent plane ``(a, b)`` is the sphere ``a ‖x‖² + b·x = 0``.
"""

from exactspline.formulas.surfaces.fundamental_forms import D_u, D_v
from exactspline.formulas.surfaces.lifted import normal_lifted_of_surface
from exactspline.language.formula import formula
from exactspline.language.rational import cramer
from exactspline.language.vector import cross, det, dot, generalized_cross, join, norm2
from exactspline.language.wronskians import wronskian


@formula("definition of the bisector", on="surface", symbol="B")
def point_bisector_of_surface(c):
    """The solution of ``S_u·B = S·S_u``, ``S_v·B = S·S_v``, ``S·B = ½‖S‖²`` by Cramer's rule."""
    s, s_u, s_v = c.S, c.S.d(1, by="u"), c.S.d(1, by="v")
    return cramer((s_u, dot(s, s_u)), (s_v, dot(s, s_v)), (s, norm2(s) / 2)) / det(s_u, s_v, s)


@formula("as eqs. (27), (28) of the paper", on="surface", symbol="B")
def point_bisector_of_surface_reduced(c):
    """The solution by Cramer's rule with the rows ``D_u``, ``D_v``, p and the unknown wB."""
    rows = (D_u(c), dot(c.p, D_u(c))), (D_v(c), dot(c.p, D_v(c))), (c.p, norm2(c.p) / 2)
    return cramer(*rows) / (det(D_u(c), D_v(c), c.p) * c.w)


@formula("lifted", on="surface", symbol="Y")
def inverse_surface(c):
    """``(‖p‖², w p)``: the projective lift of the inverse surface ``S/‖S‖²``."""
    return join(norm2(c.p), c.p * c.w)


@formula("lifted", on="surface", symbol=r"\Sigma")
def tangent_sphere_through_origin(c):
    """The tangent plane of the inverse surface: the sphere ``(a, b)`` through the origin that touches the surface."""
    y = inverse_surface(c)
    return generalized_cross(y, y.d(1, by="u"), y.d(1, by="v"))


@formula("lifted", on="surface", symbol="B")
def point_bisector_of_surface_lifted(c):
    """The centre ``−b/(2a)`` of the sphere ``(a, b)`` through the origin that touches the surface."""
    sphere = tangent_sphere_through_origin(c)
    return -sphere[1:4] / (2 * sphere[0])


@formula("lifted, divided by w", on="surface")
def point_bisector_numerators(c):
    """``(p·D_u) p_v × p + (p·D_v) p × p_u + ½ ‖p‖² Π_n``: the numerators of the reduced form, divided by w."""
    p, p_u, p_v = c.p, c.p.d(1, by="u"), c.p.d(1, by="v")
    first = cross(p_v, p) * dot(p, D_u(c)) + cross(p, p_u) * dot(p, D_v(c))
    return first + normal_lifted_of_surface(c) * norm2(p) / 2


@formula("lifted, divided by w", on="surface", symbol="B")
def point_bisector_of_surface_divided(c):
    """The numerators of `point_bisector_numerators` over ``w² [p_u p_v p]``: the reduced form, with the common factor w
    of numerator and denominator cancelled.
    """
    return point_bisector_numerators(c) / (c.w**2 * det(c.p.d(1, by="u"), c.p.d(1, by="v"), c.p))


@formula("definition of the bisector", on="surface")
def point_bisector_off_normal(c):
    """``S_u·(B − S)`` and ``S_v·(B − S)``: zero where B lies on the normal of the surface."""
    offset = point_bisector_of_surface(c) - c.S
    return join(dot(c.S.d(1, by="u"), offset), dot(c.S.d(1, by="v"), offset))


@formula("definition of the bisector", on="surface")
def point_bisector_distances(c):
    """``‖B‖² − ‖B − S‖²``: zero where B is as far from the origin as from S."""
    b = point_bisector_of_surface(c)
    return norm2(b) - norm2(b - c.S)


@formula("bisector with a curve through the origin, its tangent along the x-axis", on="surface")
def curve_condition(c):
    """``B·x``: zero where the centre lies in the normal plane of the curve."""
    return point_bisector_of_surface(c)[0]


@formula("lifted", on="surface")
def curve_condition_lifted(c):
    """The x-coordinate of the numerators of the centre."""
    return point_bisector_numerators(c)[0]


@formula("bisector with a surface through the origin, its tangent plane z = 0", on="space")
def surface_condition(c):
    """``(B − γ)·γ′`` for the centre ``B = (0, 0, ‖γ‖²/(2 γ_z))`` of the sphere through γ that touches the plane z = 0
    in the origin.
    """
    velocity = c.gamma.d(1)
    return norm2(c.gamma) / (c.gamma[2] * 2) * velocity[2] - dot(c.gamma, velocity)


@formula("lifted", on="space")
def surface_condition_lifted(c):
    """The Wronskian of ``‖p‖²`` and ``w z``: two coordinates of the conformal lift."""
    return wronskian(join(norm2(c.p), c.p[2] * c.w), 2)


@formula("coordinates", on="space")
def third_coordinate(c):
    """``p_z``."""
    return c.p[2]
