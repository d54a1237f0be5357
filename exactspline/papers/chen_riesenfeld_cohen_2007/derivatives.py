"""§3: derivatives of a rational curve γ = p/w."""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, norm2


@formula("eq. (4)", symbol="D_1")
def D1(c):
    """``p′w − pw′``."""
    return c.p.d(1) * c.w - c.p * c.w.d(1)


@formula("eq. (4)", symbol="D_2")
def D2(c):
    """``p″w − pw″``."""
    return c.p.d(2) * c.w - c.p * c.w.d(2)


@formula("eq. (4)", symbol="D_3")
def D3(c):
    """``p‴w − pw‴``."""
    return c.p.d(3) * c.w - c.p * c.w.d(3)


@formula("eq. (4)", symbol="D_{21}")
def D21(c):
    """``p″w′ − p′w″``."""
    return c.p.d(2) * c.w.d(1) - c.p.d(1) * c.w.d(2)


@formula("§3")
def velocity(c):
    """First derivative by the quotient rule."""
    return c.gamma.d(1)


@formula("§3")
def acceleration(c):
    """Second derivative by the quotient rule, twice."""
    return c.gamma.d(2)


@formula("§3")
def jerk(c):
    """Third derivative by the quotient rule, three times."""
    return c.gamma.d(3)


@formula("§4.2, §5", symbol=r"\|\gamma'\|^2")
def speed_squared(c):
    """``‖γ′‖²``."""
    return norm2(c.gamma.d(1))


@formula("§4.2, §5", symbol=r"\|D_1\|^2")
def D1_squared(c):
    """``‖D1‖²``: nonzero where the curve is regular."""
    return norm2(D1(c))


@formula("eq. (1)")
def velocity_shared(c):
    """First derivative over w²."""
    return D1(c) / c.w**2


@formula("Remark 3.2")
def acceleration_first_term(c):
    """``D2/w²``, the first term of γ″."""
    return D2(c) / c.w**2


@formula("Remark 3.2")
def jerk_first_term(c):
    """``D3/w²``, the first term of γ‴."""
    return D3(c) / c.w**2


@formula("eq. (2)")
def acceleration_shared(c):
    """Second derivative, its terms over w³."""
    return (D2(c) * c.w - D1(c) * (2 * c.w.d(1))) / c.w**3


@formula("eq. (3)")
def jerk_shared(c):
    """Third derivative, its terms over w⁴."""
    w = c.w
    return ((D3(c) + D21(c)) * w**2 - D2(c) * (4 * w.d(1) * w) + D1(c) * (6 * w.d(1) ** 2 - 2 * w * w.d(2))) / w**4


@formula("Remark 3.1", on="space")
def D1_D2_D3(c):
    """``[D1 D2 D3]`` in space."""
    return det(D1(c), D2(c), D3(c))


@formula("§3", on="space")
def D1_D2_D21(c):
    """``[D1 D2 D21]``: zero when D21 lies in the span of D1 and D2."""
    return det(D1(c), D2(c), D21(c))


@formula("§3")
def D21_in_span(c):
    """D21 as a combination of D1 and D2."""
    return (D2(c) * c.w.d(1) - D1(c) * c.w.d(2)) / c.w


@formula("eq. (5)")
def acceleration_term_1(c):
    """The term of D1 in γ″."""
    return (2 * c.w.d(1) / c.w**3) * D1(c)


@formula("eq. (5)")
def jerk_term_21(c):
    """The term of D21 in γ‴."""
    return D21(c) / c.w**2


@formula("eq. (5)")
def jerk_term_21_1(c):
    """The part of D21/w² along D1."""
    return (c.w.d(2) / c.w**3) * D1(c)


@formula("eq. (5)")
def jerk_term_21_2(c):
    """The part of D21/w² along D2."""
    return (c.w.d(1) / c.w**3) * D2(c)


@formula("eq. (5)")
def jerk_term_2(c):
    """The term of D2 in γ‴."""
    return (4 * c.w.d(1) / c.w**3) * D2(c)


@formula("eq. (5)")
def jerk_term_1(c):
    """The term of D1 in γ‴."""
    return ((6 * c.w.d(1) ** 2 - 2 * c.w * c.w.d(2)) / c.w**4) * D1(c)


@formula("eq. (5)")
def acceleration_terms(c):
    """Second derivative as printed in the paper: a sum of terms over powers of w."""
    return acceleration_first_term(c) - acceleration_term_1(c)


@formula("eq. (5)")
def jerk_terms(c):
    """Third derivative as printed in the paper: a sum of terms over powers of w."""
    return jerk_first_term(c) + jerk_term_21(c) - jerk_term_2(c) + jerk_term_1(c)


@formula("Remark 3.2", on="plane")
def acceleration_rest_plane(c):
    """``[γ′ γ″ − D2/w²]``: zero if the rest of γ″ is parallel to γ′, in the plane."""
    return det(c.gamma.d(1), c.gamma.d(2) - acceleration_first_term(c))


@formula("Remark 3.2", on="space")
def acceleration_rest_space(c):
    """``γ′ × (γ″ − D2/w²)``: zero if the rest of γ″ is parallel to γ′, in space."""
    return cross(c.gamma.d(1), c.gamma.d(2) - acceleration_first_term(c))


@formula("Remark 3.2", on="space")
def jerk_rest(c):
    """``[γ′ γ″ γ‴ − D3/w²]``: zero when the rest of γ‴ is in the span of γ′ and γ″."""
    return det(c.gamma.d(1), c.gamma.d(2), c.gamma.d(3) - jerk_first_term(c))


@formula("§3", on="plane")
def velocity_jerk(c):
    """``[γ′ γ‴]``, naive."""
    return det(c.gamma.d(1), c.gamma.d(3))


@formula("§3", on="plane")
def D1_D3(c):
    """``[D1 D3]`` in the plane."""
    return det(D1(c), D3(c))


@formula("Remark 3.2", on="space")
def velocity_acceleration_jerk(c):
    """``[γ′ γ″ γ‴]``, naive."""
    return det(c.gamma.d(1), c.gamma.d(2), c.gamma.d(3))
