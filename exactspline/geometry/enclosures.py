"""Curvature and torsion at a parameter or a root: exactly where they have a closed form, else enclosed by interval
arithmetic to any number of significant digits.

Whether a value is exactly zero is decided first, from the certified zeros; what is not zero is refined until its own
digits are certain, however small it is.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from gmpy2 import mpq

from exactspline.errors import FormulaError
from exactspline.geometry.analysis import analyse
from exactspline.geometry.joints import curvature_of
from exactspline.geometry.surds import Surd
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector
from exactspline.papers import find
from exactspline.readings.taylor import Series, series_curve
from exactspline.roots.root import Root
from exactspline.splines.bernstein import bezier
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

#: Enclosures of a number by rational numbers: low, high, and how precisely (in decimal digits) to compute with them.
Enclosure = Callable[[Any, mpq, mpq], Any]


def exact_curvature(curve: Nurbs, t: mpq, side: str = "right") -> Surd:
    """κ at a rational parameter as ``a√b``: with its sign in the plane, not negative in space.

    >>> from exactspline.splines.examples import example
    >>> print(exact_curvature(example("parabola"), mpq(0)))
    2/25·√5

    Raises `FormulaError` at a singular point, where κ may have a pole.
    """
    series = series_curve(curve, t, 4, side)
    x = [*series.gamma]
    point, velocity, acceleration, jerk = [tuple(s.d(k).value for s in x) for k in range(4)]
    if not any(velocity):
        raise FormulaError("the curvature at a singular point", remedy="ask for it at regular points")
    return curvature_of((point, velocity, acceleration, jerk))


def curvature_sign(curve: Nurbs, root: Root, side: str = "right") -> int:
    """The sign of κ at a root of whatever form, exactly: in space 1, or 0 where κ = 0."""
    analysis = analyse(curve)
    if not analysis.in_space:
        return analysis.sign_of("zero_curvature", root, side)
    return int(not analysis.is_flat(root) if root.exact is None else any(analysis.bend(root.exact, side)))


def curvature_value(curve: Nurbs, root: Root, digits: int, side: str = "right") -> Any:
    """κ at a root as an mpmath number that is relatively off by less than ``10^−digits``; exactly 0 where κ = 0.

    At a root that is not rational the Taylor coefficients at an enclosure of it are taken in interval arithmetic, which
    bounds the error; the enclosure is refined until the bound holds.

    >>> from exactspline.geometry.features import curvature_extrema
    >>> from exactspline.splines.examples import example
    >>> curvature_value(example("ellipse"), curvature_extrema(example("ellipse"))[0].root, 10)
    mpf('2.0')
    """
    from mpmath import mp

    if root.exact is not None:
        return exact_curvature(curve, root.exact, side).mpf(digits)
    sign = curvature_sign(curve, root, side)
    if sign == 0:
        return mp.mpf(0)
    formula = find("curvature_squared" if curve.dimension == 2 else "space_curvature_squared")

    def enclosure(iv: Any, low: mpq, high: mpq) -> Any:
        enclosed = _enclosed(iv, curve, low, high, side)
        if all(0 in x.d().value for x in enclosed.gamma):
            return None
        squared = formula(enclosed).value
        return iv.sqrt(squared) * sign if squared.a > 0 else None

    return _certified(root, digits, enclosure)


def torsion_value(curve: Nurbs, root: Root, digits: int, side: str = "right") -> Any:
    """τ at a root (where κ = 0 its limit) as an mpmath number that is relatively off by less than ``10^−digits``;
    exactly 0 where τ = 0.

    >>> from exactspline.geometry.features import critical_points
    >>> from exactspline.splines.examples import example
    >>> torsion_value(example("twisted_cubic"), critical_points(example("twisted_cubic"))[0].root, 10)
    mpf('3.0')

    Raises `FormulaError` at a singular point, where τ may have a pole.
    """
    from mpmath import mp

    analysis = analyse(curve)
    if analysis.is_singular(root):
        raise FormulaError("the torsion at a singular point", remedy="ask for it at regular points")
    tau = analysis.reduced_torsion
    if root.exact is not None:
        return Surd(tau(root.exact, side)).mpf(digits)
    if analysis.torsion_sign(root, side) == 0:
        return mp.mpf(0)

    def enclosure(iv: Any, low: mpq, high: mpq) -> Any:
        top, bottom = [_enclose(iv, f, low, high, side) for f in (tau.scalar, tau.denominator)]
        return top / bottom if bottom.a > 0 or bottom.b < 0 else None

    return _certified(root, digits, enclosure)


def _certified(root: Root, digits: int, enclosure: Enclosure) -> Any:
    """A number at a root that is not zero to so many significant digits: the root is refined until the enclosure of the
    number (None: not yet known) is narrow enough.
    """
    from mpmath import mp
    from mpmath.ctx_iv import MPIntervalContext

    # an interval context of its own: nobody else's precision is touched
    iv, precision = MPIntervalContext(), digits + 10
    while True:
        low, high = root.refine(precision)
        iv.dps = precision + 10
        value = enclosure(iv, low, high)
        if value is not None and (value.a > 0 or value.b < 0) and value.delta * 10**digits <= abs(value).a:
            with mp.workdps(precision):
                return mp.make_mpf(value.mid._mpi_[0])
        precision *= 2


def _interval(iv: Any, a: mpq, b: mpq) -> Any:
    """[a, b] in interval arithmetic."""
    ends = [iv.mpf(int(x.numerator)) / iv.mpf(int(x.denominator)) for x in (a, b)]
    return iv.mpf([ends[0].a, ends[1].b])


def _enclose(iv: Any, spline: BSpline, low: mpq, high: mpq, side: str) -> Any:
    """The values of a spline on [low, high], by de Casteljau's algorithm in interval arithmetic."""
    i = spline.mesh.locate(low, left=side == "left")
    a, b = spline.mesh.breaks[i : i + 2]
    t = _interval(iv, (low - a) / (b - a), (high - a) / (b - a))
    form = spline.polynomials[i], spline.denominators[i]
    points = [_interval(iv, x, x) for x in bezier(form, spline.degree)] or [iv.mpf(0)]
    while len(points) > 1:
        points = [(1 - t) * p + t * q for p, q in pairwise(points)]
    return points[0]


def _enclosed(iv: Any, curve: Nurbs, low: mpq, high: mpq, side: str) -> Curve:
    """The curve as a Taylor series with interval coefficients over [low, high]."""

    def series(spline: BSpline) -> Series:
        return Series([_enclose(iv, spline.d(order), low, high, side) / max(order, 1) for order in range(3)])

    return Curve(Vector(*[series(x) for x in curve.p]), series(curve.w), polynomial=curve.polynomial)


__all__ = ["curvature_sign", "curvature_value", "exact_curvature", "torsion_value"]
