"""Lines of derivations, as printed, that contain square roots: §5.4 and §5.5, over σ = ‖γ′‖ and ρ = ‖γ′ × γ″‖."""

from exactspline.language.formula import formula
from exactspline.language.ruled import ruled
from exactspline.language.vector import cross, dot, perp
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import velocity_acceleration_jerk
from exactspline.papers.chen_riesenfeld_cohen_2007.frames import (
    binormal_length,
    curvature_in_space,
    radius_derivative_along_binormal,
    signed_curvature,
    speed,
    unit_binormal,
    unit_normal,
    unit_tangent,
)
from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f0
from exactspline.papers.chen_riesenfeld_cohen_2007.space import (
    binormal,
    binormal_squared,
    focal_curve,
    normal,
    psi,
    radius_vector,
    torsion,
)


@formula("§1", on="framed space")
def tangent_developable_by_unit_tangent(c):
    """``γ + ζT`` with the unit tangent T."""
    return ruled(c.gamma, unit_tangent(c))


@formula("§4.3, next to eq. (12)", on="framed plane")
def inverted_curvature(c):
    """``‖γ′‖³/[γ′ γ″]``, which is printed as κ."""
    return c.sigma**3 / f0(c)


@formula("§4.3, next to eq. (12)", on="framed plane")
def signed_radius(c):
    """``1/κ``, with the sign of κ."""
    return 1 / signed_curvature(c)


@formula("§4.3, first line of eq. (12)", on="framed plane")
def evolute_line_of_12(c):
    """``γ + (‖γ′‖³/[γ′ γ″]) γ′⊥/‖γ′⊥‖``, with ‖γ′⊥‖ = ‖γ′‖."""
    return c.gamma + (c.sigma**3 / f0(c)) * (perp(c.gamma.d(1)) / c.sigma)


@formula("§5.1, κN, second line", on="framed space")
def curvature_vector_line_2(c):
    """``(‖γ′×γ″‖/‖γ′‖³) (γ′×γ″)×γ′/(‖γ′×γ″‖ ‖γ′‖)``."""
    return (c.rho / c.sigma**3) * (normal(c) / (c.rho * c.sigma))


@formula("§5.1, κ⁻¹N, second line", on="framed space")
def radius_vector_line_2(c):
    """``(‖γ′‖³/‖γ′×γ″‖) (γ′×γ″)×γ′/(‖γ′×γ″‖ ‖γ′‖)``."""
    return (c.sigma**3 / c.rho) * (normal(c) / (c.rho * c.sigma))


@formula("§5.4, first line", on="framed space")
def rectifying_direction_line_1(c):
    """``τ γ′/‖γ′‖ + (‖γ′×γ″‖/‖γ′‖³) γ′×γ″/‖γ′×γ″‖``."""
    turning = velocity_acceleration_jerk(c) / binormal_squared(c)
    return (c.gamma.d(1) / c.sigma) * turning + (c.rho / c.sigma**3) * (binormal(c) / c.rho)


@formula("§5.4, second line", on="framed space")
def rectifying_direction_line_2(c):
    """``(1/‖γ′‖)(τ γ′ + γ′×γ″/‖γ′‖²)``."""
    turning = velocity_acceleration_jerk(c) / binormal_squared(c)
    return (c.gamma.d(1) * turning + binormal(c) / c.sigma**2) / c.sigma


@formula("§5.5", on="framed space")
def jerk_along_binormal(c):
    """``(γ′ × γ″)·(γ′ × γ‴)``."""
    return dot(binormal(c), cross(c.gamma.d(1), c.gamma.d(3)))


@formula("§5.5, first line", on="framed space")
def radius_derivative_line_1(c):
    """``(‖γ′‖³/‖γ′×γ″‖)′ γ′×γ″/‖γ′×γ″‖``."""
    return (c.sigma**3 / c.rho).d(1) * (binormal(c) / c.rho)


@formula("§5.5, second line", on="framed space")
def radius_derivative_line_2(c):
    """``(1/κ)′B`` by the quotient rule."""
    sigma, rho = c.sigma, c.rho
    top = 3 * sigma**2 * sigma.d(1) * rho - rho.d(1) * sigma**3
    return (top / rho**2) * (binormal(c) / rho)


@formula("§5.5, third line", on="framed space")
def radius_derivative_line_3(c):
    """``(1/κ)′B`` with ‖γ′×γ″‖′ inserted."""
    top = 3 * c.sigma**2 * c.sigma.d(1) - jerk_along_binormal(c) / c.rho**2 * c.sigma**3
    return (top / c.rho**2) * binormal(c)


@formula("§5.5, fourth line", on="framed space")
def radius_derivative_line_4(c):
    """``(1/κ)′B`` with ‖γ′‖ ‖γ′‖′ = γ′·γ″."""
    bend = dot(c.gamma.d(1), c.gamma.d(2))
    top = 3 * c.sigma * bend - jerk_along_binormal(c) / c.rho**2 * c.sigma**3
    return (top / c.rho**2) * binormal(c)


@formula("§5.5, fifth line", on="framed space")
def radius_derivative_line_5(c):
    """``(1/κ)′B`` over ‖γ′×γ″‖⁴."""
    bend = dot(c.gamma.d(1), c.gamma.d(2))
    return (c.sigma / c.rho**4) * (binormal(c) * (3 * bend * c.rho**2 - jerk_along_binormal(c) * c.sigma**2))


@formula("§5.5", on="framed space")
def binormal_length_derivative(c):
    """``‖γ′ × γ″‖′``."""
    return binormal_length(c).d(1)


@formula("§5.5", on="framed space")
def binormal_length_derivative_printed(c):
    """``(γ′ × γ″)·(γ′ × γ‴)/‖γ′ × γ″‖``."""
    return jerk_along_binormal(c) / c.rho


@formula("§5.5", on="framed")
def speed_times_derivative(c):
    """``‖γ′‖ ‖γ′‖′``."""
    return speed(c) * speed(c).d(1)


@formula("§5.5", on="framed")
def half_derivative_of_square(c):
    """``½ (‖γ′‖²)′``."""
    return (speed(c) ** 2).d(1) / 2


@formula("§5.5", on="framed")
def half_derivative_of_product(c):
    """``½ (γ′·γ′)′``."""
    return dot(c.gamma.d(1), c.gamma.d(1)).d(1) / 2


@formula("§5.5", on="framed")
def velocity_dot_acceleration(c):
    """``γ′·γ″``."""
    return dot(c.gamma.d(1), c.gamma.d(2))


@formula("eq. (19)", on="framed space")
def focal_third_term(c):
    """``(1/τ)(1/κ)′B``, with the derivative with respect to the parameter."""
    return radius_derivative_along_binormal(c) / torsion(c)


@formula("eq. (19)", on="framed space")
def focal_curve_by_parameter(c):
    """``γ + (1/κ)N + (1/τ)(1/κ)′B``, with the derivative with respect to the parameter."""
    return c.gamma + radius_vector(c) + focal_third_term(c)


@formula("eq. (19)", on="framed space")
def focal_third_term_by_arc_length(c):
    """``‖γ′‖ (C − γ − (1/κ)N)``, C the centre of the osculating sphere."""
    return (focal_curve(c) - c.gamma - radius_vector(c)) * c.sigma


@formula("§5.6", on="framed space")
def focal_surface_by_unit_binormal(c):
    """``γ + (1/κ)N + (1/τ)(1/κ)′B + λB`` with the unit vectors of (13)."""
    return ruled(focal_curve_by_parameter(c), unit_binormal(c))


@formula("eq. (19)", on="framed space")
def focal_curve_by_both_derivatives(c):
    """``F + (‖γ′‖ − 1)(1/τ)Ψ``, F the focal curve."""
    return focal_curve(c) + psi(c) / torsion(c) * (speed(c) - 1)


@formula("§5.6", on="framed space")
def focal_surface_directrix(c):
    """The directrix of ``γ + (1/κ)N + (1/τ)(1/κ)′B + λB``."""
    return focal_surface_by_unit_binormal(c).directrix


@formula("§5.6", on="framed space")
def focal_line_offset(c):
    """``((1/τ)(1/κ)′B) × (γ′ × γ″)``: zero if the third term is parallel to the binormal."""
    return cross(focal_third_term(c), binormal(c))


@formula("eq. (15)", on="framed space")
def curvature_times_unit_normal(c):
    """``κN``, with κ of (15) and N of (13)."""
    return unit_normal(c) * curvature_in_space(c)
