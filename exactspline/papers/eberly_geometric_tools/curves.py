"""``NURBSCurve.h`` and ``FrenetFrame.h``: derivatives of rational curves, moving frames."""

from exactspline.language.formula import formula
from exactspline.language.vector import dot, join
from exactspline.papers.petrunin_zamora_barrera.space import acceleration_by_arc_length


@formula("NURBSCurve.h, Evaluate", symbol="J_1")
def jet_1(c):
    """``(X′ − w′ jet[0]) / w``."""
    return (c.p.d(1) - c.gamma * c.w.d(1)) / c.w


@formula("NURBSCurve.h, Evaluate", symbol="J_2")
def jet_2(c):
    """``(X″ − 2 w′ jet[1] − w″ jet[0]) / w``."""
    return (c.p.d(2) - jet_1(c) * (2 * c.w.d(1)) - c.gamma * c.w.d(2)) / c.w


@formula("NURBSCurve.h, Evaluate", symbol="J_3")
def jet_3(c):
    """``(X‴ − 3 w′ jet[2] − 3 w″ jet[1] − w‴ jet[0]) / w``."""
    lower = jet_2(c) * (3 * c.w.d(1)) + jet_1(c) * (3 * c.w.d(2)) + c.gamma * c.w.d(3)
    return (c.p.d(3) - lower) / c.w


@formula("FrenetFrame.h, FrenetFrame2", on="plane")
def clockwise_normal(c):
    """``Perp(tangent) = (y, −x)``, not normalized."""
    return join(c.gamma.d(1)[1], -c.gamma.d(1)[0])


@formula("Vector2.h, DotPerp", on="plane")
def dot_perp(c):
    """``Dot(jet[1], Perp(jet[2]))``: the numerator of the curvature."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return a[0] * b[1] + a[1] * -b[0]


@formula("FrenetFrame.h, FrenetFrame2", on="plane")
def bending_along_the_clockwise_normal(c):
    """``κN`` with curvature and normal as computed in the code."""
    return clockwise_normal(c) * (dot_perp(c) / dot(c.gamma.d(1), c.gamma.d(1)) ** 2)


@formula("Frenet equations", on="plane")
def tangent_by_arc_length(c):
    """The derivative of the unit tangent with respect to arc length."""
    return acceleration_by_arc_length(c)


@formula("FrenetFrame.h, FrenetFrame3", on="space")
def normal_of_the_frame(c):
    """``VDotV · A − VDotA · V``."""
    a, b = c.gamma.d(1), c.gamma.d(2)
    return b * dot(a, a) - a * dot(a, b)
