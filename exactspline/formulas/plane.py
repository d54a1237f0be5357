"""§4: plane curves."""

from exactspline.formulas.derivatives import D1, D2
from exactspline.language import det, formula


@formula("§4.1", curve="plane", symbol="f_0")
def f0(c):
    """Numerator of the curvature: ``[γ′ γ″]``, naive."""
    return det(c.gamma.d(1), c.gamma.d(2))


@formula("§4.1, Remark 3.1", curve="plane", symbol="f_1")
def f1(c):
    """``[D1 D2]``, which vanishes with the curvature."""
    return det(D1(c), D2(c))


@formula("eq. (8)", curve="plane")
def f1_expanded(c):
    """``[D1 D2]`` multiplied out, as eq. (8) prints it."""
    p, w = c.p, c.w
    return det(p.d(1), p.d(2)) * w**2 - det(p, p.d(2)) * (w.d(1) * w) - det(p.d(1), p) * (w * w.d(2))


@formula("eq. (8)", curve="plane", symbol="f_2")
def f2(c):
    """Zero-curvature form of a rational plane curve: eq. (8) without its common factor w."""
    p, w = c.p, c.w
    return det(p.d(1), p.d(2)) * w - det(p, p.d(2)) * w.d(1) - det(p.d(1), p) * w.d(2)
