"""Quantities that the code of the posts computes from the control points of cubics and quadratics."""

from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import curvature_squared
from exactspline.papers.primer_on_bezier_curves.control_points import (
    bezier_1,
    derivative_weight_1,
    extremities_a_by_v,
    quadratic_2,
    quadratic_3,
    second_derivative_weight_1,
)


@formula("CubicBez.find_offset_cusps", on="plane")
def hodograph_step(c):
    """``(d1x, d1y)``: twice the first difference of the control points of the hodograph."""
    return second_derivative_weight_1(c)


@formula("CubicBez.find_offset_cusps", on="plane")
def hodograph_bend(c):
    """``(d2x, d2y)``: the second difference of the control points of the hodograph."""
    return extremities_a_by_v(c)


@formula("CubicBez.find_offset_cusps", on="plane", symbol="c_0")
def cusp_coefficient_0(c):
    """``d1x d0y − d1y d0x``."""
    return det(hodograph_step(c), derivative_weight_1(c))


@formula("CubicBez.find_offset_cusps", on="plane", symbol="c_1")
def cusp_coefficient_1(c):
    """``2 (d2x d0y − d2y d0x)``."""
    return 2 * det(hodograph_bend(c), derivative_weight_1(c))


@formula("CubicBez.find_offset_cusps", on="plane", symbol="c_2")
def cusp_coefficient_2(c):
    """``d2x d1y − d2y d1x``."""
    return det(hodograph_bend(c), hodograph_step(c))


@formula("Cusp finding", on="plane with delta")
def cusps_on_both_sides(c):
    """``δ² [x″ x′]² − |x′|⁶``: zero at the cusps of the parallels on both sides."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return c.delta**2 * det(b, a) ** 2 - norm2(a) ** 3


@formula("Cusp finding", on="plane with delta")
def cusps_by_curvature(c):
    """``κ²δ² − 1``."""
    return curvature_squared(c) * c.delta**2 - 1


@formula("QuadBez.map_to_basic", on="plane")
def basic_direction(c):
    """``(ddx, ddy)``: twice the middle control point minus the other two."""
    return 2 * quadratic_2(c) - bezier_1(c) - quadratic_3(c)


@formula("QuadBez.map_to_basic", on="plane")
def basic_cross(c):
    """``(x2 − x0) ddy − (y2 − y0) ddx``."""
    return det(quadratic_3(c) - bezier_1(c), basic_direction(c))


@formula("QuadBez.map_to_basic", on="plane", symbol="x_0")
def basic_start(c):
    """``u0/cross``: where the curve starts on ``y = x²``."""
    return dot(quadratic_2(c) - bezier_1(c), basic_direction(c)) / basic_cross(c)


@formula("QuadBez.map_to_basic", on="plane", symbol="x_2")
def basic_end(c):
    """``u2/cross``: where the curve ends on ``y = x²``."""
    return dot(quadratic_3(c) - quadratic_2(c), basic_direction(c)) / basic_cross(c)


@formula("the axis of a parabola", on="plane")
def parabola_parameter(c):
    """``γ′·γ″ / (2 [γ′ γ″])``: zero at the vertex, x for ``(x, x²)``."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return dot(a, b) / (2 * det(a, b))


@formula("QuadBez.map_to_basic", on="plane")
def basic_scale_squared(c):
    """The square of ``scale = |cross| / (|dd| |x2 − x0|)``."""
    return basic_cross(c) ** 2 / (norm2(basic_direction(c)) * (basic_end(c) - basic_start(c)) ** 2)


@formula("Flattening quadratic Béziers", on="plane")
def basic_curvature_squared(c):
    """The square of ``κ = 2/(1 + 4x²)^(3/2)`` at x₀, divided by that of the scale."""
    return 4 / ((1 + 4 * basic_start(c) ** 2) ** 3 * basic_scale_squared(c))


@formula("Flattening quadratic Béziers", on="plane")
def basic_arc_length_squared(c):
    """The square of ``Δs = √(1 + 4x²) Δx`` at x₀, times the scale, for the Δx of one unit of the parameter."""
    step = basic_end(c) - basic_start(c)
    return (1 + 4 * basic_start(c) ** 2) * step**2 * basic_scale_squared(c)
