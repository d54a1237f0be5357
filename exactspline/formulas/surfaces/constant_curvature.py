"""The derivatives of the Gaussian curvature: it is constant where both vanish identically.

Spheres, planes and developable surfaces have constant Gaussian curvature; whether other rational surfaces do is not
decided here.
"""

from exactspline.formulas.surfaces.by_forms import area_of_forms, parabolic_of_forms
from exactspline.language.formula import formula


def _change_of_quotient(k, a, by):
    """The numerator of the derivative of ``k/a²`` over ``a³``."""
    return a * k.d(1, by=by) - 2 * k * a.d(1, by=by)


def _change_with_weight(k, a, w, by):
    """The derivative of ``w⁴ k/a²`` divided by ``w³/a³``."""
    return w * _change_of_quotient(k, a, by) + 4 * w.d(1, by=by) * k * a


@formula("Gaussian curvature", on="forms", symbol="K")
def gaussian_of_forms(c):
    """``(LN − M²)/(EG − F²)²``."""
    return parabolic_of_forms(c) / area_of_forms(c) ** 2


@formula("Gaussian curvature", on="forms", symbol="K_u")
def gaussian_of_forms_by_u(c):
    """The derivative by u of the Gaussian curvature."""
    return gaussian_of_forms(c).d(1, by="u")


@formula("Gaussian curvature", on="forms", symbol="K_v")
def gaussian_of_forms_by_v(c):
    """The derivative by v of the Gaussian curvature."""
    return gaussian_of_forms(c).d(1, by="v")


@formula("constant curvature", on="forms")
def change_of_forms_by_u(c):
    """``a k_u − 2 k a_u`` with ``a = EG − F²`` and ``k = LN − M²``: zero exactly where K_u is."""
    return _change_of_quotient(parabolic_of_forms(c), area_of_forms(c), "u")


@formula("constant curvature", on="forms")
def change_of_forms_by_v(c):
    """``a k_v − 2 k a_v``: zero exactly where K_v is."""
    return _change_of_quotient(parabolic_of_forms(c), area_of_forms(c), "v")


@formula("constant curvature", on="forms")
def gaussian_weighted_by_u(c):
    """The derivative by u of ``w⁴ (LN − M²)/(EG − F²)²``, for the coefficients of both lifted forms."""
    return (gaussian_of_forms(c) * c.w**4).d(1, by="u")


@formula("constant curvature", on="forms")
def gaussian_weighted_by_v(c):
    """The derivative by v of ``w⁴ (LN − M²)/(EG − F²)²``, for the coefficients of both lifted forms."""
    return (gaussian_of_forms(c) * c.w**4).d(1, by="v")


@formula("constant curvature", on="forms")
def change_weighted_by_u(c):
    """``w (a k_u − 2 k a_u) + 4 w_u k a``."""
    return _change_with_weight(parabolic_of_forms(c), area_of_forms(c), c.w, "u")


@formula("constant curvature", on="forms")
def change_weighted_by_v(c):
    """``w (a k_v − 2 k a_v) + 4 w_v k a``."""
    return _change_with_weight(parabolic_of_forms(c), area_of_forms(c), c.w, "v")
