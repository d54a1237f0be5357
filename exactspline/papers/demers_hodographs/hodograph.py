"""Plane curves with ``c′ = (u² − v², 2uv) h``: speed, normal, curvature, offset; the light cone."""

from exactspline.language.complex_numbers import complex_product
from exactspline.language.formula import formula
from exactspline.language.vector import det, dot, join, norm2, perp


@formula("phCurve, computePHCurveFromUV", on="hodograph")
def ph_curve(c):
    """The curve: the integral of its hodograph."""
    return c.p


@formula("phCurve", on="hodograph", symbol="w")
def spinor(c):
    """``w = u + iv``."""
    return join(c.u, c.v)


@formula("The plane: square the radius, double the angle", on="hodograph")
def spinor_squared(c):
    """``w²``, in complex notation."""
    return complex_product(spinor(c), spinor(c))


@formula("phCurve", on="hodograph", symbol=r"\sigma")
def ph_speed(c):
    """``σ = (u² + v²) h``."""
    return (c.u * c.u + c.v * c.v) * c.h


@formula("phCurve", on="hodograph")
def ph_speed_squared(c):
    """``σ²``."""
    return ph_speed(c) ** 2


@formula("phCurve, evaluatePHNormal", on="hodograph")
def ph_normal(c):
    """``(−2uv/(u² + v²), (u² − v²)/(u² + v²))``."""
    u, v = c.u, c.v
    return join(-2 * u * v, u * u - v * v) / (u * u + v * v)


@formula("phCurve, evaluatePHNormal", on="hodograph")
def turned_unit_tangent(c):
    """``c′/σ``, rotated left by a right angle."""
    return perp(c.gamma.d(1)) / ph_speed(c)


@formula("phCurve, computePHOffset", on="hodograph")
def ph_offset_numerator(c):
    """``(x σ − d y′, y σ + d x′)`` at the distance d = 1."""
    a, s = c.gamma.d(1), ph_speed(c)
    return join(c.p[0] * s - a[1], c.p[1] * s + a[0])


@formula("phCurve, computePHOffset", on="hodograph")
def ph_offset(c):
    """The offset at the distance 1, over the weight σ."""
    return ph_offset_numerator(c) / ph_speed(c)


@formula("phCurve, computePHOffset", on="hodograph")
def ph_offset_distance(c):
    """The squared distance of the offset from the curve, minus 1."""
    return norm2(ph_offset(c) - c.p) - 1


@formula("Parametrize by the normal", on="hodograph")
def support_gained(c):
    """The increase of the support function ``c·n`` by the offset, minus 1."""
    return dot(ph_offset(c), ph_normal(c)) - dot(c.p, ph_normal(c)) - 1


@formula("phCurve, computePHOffset", on="hodograph")
def ph_offset_velocity(c):
    """The derivative of the offset."""
    return ph_offset(c).d(1)


@formula("Divide out the scale", on="hodograph", symbol=r"\kappa")
def ph_curvature(c):
    """``[c′ c″]/σ³``."""
    return det(c.gamma.d(1), c.gamma.d(2)) / ph_speed(c) ** 3


@formula("Divide out the scale", on="hodograph")
def signed_offset_speed(c):
    """``(1 − κ) c′``: the velocity of the offset, with the signed speed ``σ(1 − εκ)`` for ε = 1."""
    return c.gamma.d(1) * (1 - ph_curvature(c))


@formula("phCurve", on="plane with delta")
def hodograph_of_three(c):
    """``c′ = w² h``, where u and v are the numerators of a plane curve and h is its denominator."""
    return complex_product(c.p, c.p) * c.w


@formula("phCurve, computePHOffset", on="plane with delta")
def offset_velocity_at_any_distance(c):
    """The derivative of the offset ``c + δ n``."""
    unit_normal = perp(complex_product(c.p, c.p)) / norm2(c.p)
    return hodograph_of_three(c) + (unit_normal * c.delta).d(1)


@formula("Divide out the scale", on="plane with delta")
def velocity_times_offset_factor(c):
    """``(1 − δκ) c′`` with ``κ = [c′ c″]/σ³``."""
    a = hodograph_of_three(c)
    return a * (1 - det(a, a.d(1)) * c.delta / (norm2(c.p) * c.w) ** 3)


@formula("curvature in complex notation", on="hodograph")
def spinor_wronskian(c):
    """``2 (u v′ − v u′) h``."""
    return 2 * det(spinor(c), spinor(c).d(1)) * c.h


@formula("Position is null. The tangent is not.", on="hodograph")
def cone_tangent(c):
    """``‖c″‖² − σ′²``: the Minkowski square of the derivative of ``(c′, σ)``."""
    return norm2(c.gamma.d(2)) - ph_speed(c).d(1) ** 2


@formula("Position is null. The tangent is not.", on="hodograph")
def cone_tangent_by_product(c):
    """``‖c′ × c″‖²/‖c′‖²``."""
    return det(c.gamma.d(1), c.gamma.d(2)) ** 2 / norm2(c.gamma.d(1))


@formula("Position is null. The tangent is not.", on="hodograph")
def cone_tangent_by_curvature(c):
    """``κ²σ⁴``."""
    return ph_curvature(c) ** 2 * ph_speed(c) ** 4


@formula("Position is null. The tangent is not.", on="hodograph")
def speed_change(c):
    """``σ σ′ − c′·c″``."""
    return ph_speed(c) * ph_speed(c).d(1) - dot(c.gamma.d(1), c.gamma.d(2))


@formula("What γ looks like, notes", on="hodograph")
def speed_less_first(c):
    """``σ − x′``."""
    return ph_speed(c) - c.gamma.d(1)[0]


@formula("What γ looks like, notes", on="hodograph")
def twice_second_squared(c):
    """``2 (Im w)²``."""
    return 2 * spinor(c)[1] ** 2


@formula("phCurve, createDefaultSpiral", on="hodograph", symbol="w_1")
def spinor_1(c):
    """The second control point of a quadratic w."""
    return spinor(c) + spinor(c).d(1) / 2


@formula("phCurve, createDefaultSpiral", on="hodograph", symbol="w_2")
def spinor_2(c):
    """The third control point of a quadratic w."""
    return spinor(c) + spinor(c).d(1) + spinor(c).d(2) / 2


@formula("phCurve, createDefaultSpiral", on="hodograph", symbol="h_1")
def hodograph_1(c):
    """``w₀·w₁``."""
    return complex_product(spinor(c), spinor_1(c))


@formula("phCurve, createDefaultSpiral", on="hodograph", symbol="h_2")
def hodograph_2(c):
    """``(2w₁² + w₀·w₂)/3``."""
    return (complex_product(spinor_1(c), spinor_1(c)) * 2 + complex_product(spinor(c), spinor_2(c))) / 3


@formula("control points of a quartic", on="hodograph")
def quartic_1(c):
    """The second control point of c′ as a quartic."""
    return c.gamma.d(1) + c.gamma.d(2) / 4


@formula("control points of a quartic", on="hodograph")
def quartic_2(c):
    """The third control point of c′ as a quartic."""
    return c.gamma.d(1) + c.gamma.d(2) / 2 + c.gamma.d(3) / 12


@formula("control points of a quintic", on="hodograph")
def quintic_step(c):
    """The step from the second to the third control point of c as a quintic, times 5."""
    return (c.gamma.d(1) * 2 / 5 + c.gamma.d(2) / 20 - c.gamma.d(1) / 5) * 5
