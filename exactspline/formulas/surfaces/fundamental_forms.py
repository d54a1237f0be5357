"""Rational surfaces S(u, v) = p/w: derivatives, normal, the first and the second fundamental form.

The normal is not normalized, ``n = S_u × S_v``, so that L, M, N are the classical coefficients of the second
fundamental form times ``√(EG − F²)`` and everything stays rational.
"""

from exactspline.language.formula import formula
from exactspline.language.vector import cross, det, dot, join, norm2


@formula("derivatives", on="surface", symbol="S_u")
def S_u(c):
    """The derivative by u."""
    return c.S.d(1, by="u")


@formula("derivatives", on="surface", symbol="S_v")
def S_v(c):
    """The derivative by v."""
    return c.S.d(1, by="v")


@formula("derivatives", on="surface", symbol="S_{uu}")
def S_uu(c):
    """The second derivative by u."""
    return c.S.d(2, by="u")


@formula("derivatives", on="surface", symbol="S_{uv}")
def S_uv(c):
    """The mixed derivative."""
    return c.S.d(1, by="u").d(1, by="v")


@formula("derivatives", on="surface", symbol="S_{vv}")
def S_vv(c):
    """The second derivative by v."""
    return c.S.d(2, by="v")


@formula("first fundamental form", on="surface", symbol="E")
def E(c):
    """``‖S_u‖²``."""
    return norm2(S_u(c))


@formula("first fundamental form", on="surface", symbol="F")
def F(c):
    """``S_u · S_v``."""
    return dot(S_u(c), S_v(c))


@formula("first fundamental form", on="surface", symbol="G")
def G(c):
    """``‖S_v‖²``."""
    return norm2(S_v(c))


@formula("normal", on="surface", symbol="n")
def normal(c):
    """``S_u × S_v``, not normalized."""
    return cross(S_u(c), S_v(c))


@formula("second fundamental form", on="surface", symbol="L")
def L(c):
    """``S_uu · n``."""
    return dot(S_uu(c), normal(c))


@formula("second fundamental form", on="surface", symbol="M")
def M(c):
    """``S_uv · n``."""
    return dot(S_uv(c), normal(c))


@formula("second fundamental form", on="surface", symbol="N")
def N(c):
    """``S_vv · n``."""
    return dot(S_vv(c), normal(c))


@formula("reduced", on="surface", symbol="D_u")
def D_u(c):
    """``w² S_u``, the numerator of the quotient rule."""
    return c.p.d(1, by="u") * c.w - c.p * c.w.d(1, by="u")


@formula("reduced", on="surface", symbol="D_v")
def D_v(c):
    """``w² S_v``."""
    return c.p.d(1, by="v") * c.w - c.p * c.w.d(1, by="v")


@formula("reduced", on="surface", symbol="e")
def E_reduced(c):
    """``w⁴ E``."""
    return norm2(D_u(c))


@formula("reduced", on="surface", symbol="f")
def F_reduced(c):
    """``w⁴ F``."""
    return dot(D_u(c), D_v(c))


@formula("reduced", on="surface", symbol="g")
def G_reduced(c):
    """``w⁴ G``."""
    return norm2(D_v(c))


@formula("reduced", on="surface", symbol="D_{uu}")
def D_uu(c):
    """``w³ S_uu``."""
    return D_u(c).d(1, by="u") * c.w - D_u(c) * (2 * c.w.d(1, by="u"))


@formula("reduced", on="surface", symbol="D_{uv}")
def D_uv(c):
    """``w³ S_uv``."""
    return D_u(c).d(1, by="v") * c.w - D_u(c) * (2 * c.w.d(1, by="v"))


@formula("reduced", on="surface", symbol="D_{vv}")
def D_vv(c):
    """``w³ S_vv``."""
    return D_v(c).d(1, by="v") * c.w - D_v(c) * (2 * c.w.d(1, by="v"))


@formula("reduced", on="surface")
def L_reduced(c):
    """``w⁷ L``."""
    return det(D_u(c), D_v(c), D_uu(c))


@formula("reduced", on="surface")
def M_reduced(c):
    """``w⁷ M``."""
    return det(D_u(c), D_v(c), D_uv(c))


@formula("reduced", on="surface")
def N_reduced(c):
    """``w⁷ N``."""
    return det(D_u(c), D_v(c), D_vv(c))


@formula("planar maps", on="planar map", symbol="J")
def jacobian(c):
    """``[S_u S_v]``, the area factor: a planar map is locally invertible where it is not zero."""
    return det(c.S.d(1, by="u"), c.S.d(1, by="v"))


@formula("planar maps", on="planar map", symbol=r"[P\ P_u\ P_v]")
def jacobian_lifted(c):
    """``w³ [S_u S_v]``, the determinant of ``P = (w, p)``."""
    x = join(c.w, c.p)
    return det(x, x.d(1, by="u"), x.d(1, by="v"))


@formula("normal", on="surface", symbol=r"\|n\|^2")
def normal_squared(c):
    """``‖S_u × S_v‖²``."""
    return norm2(normal(c))
