"""Curvature and torsion at a root, enclosed by interval arithmetic to any number of digits."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from gmpy2 import mpq

from exactspline.errors import FormulaError
from exactspline.geometry import space_features
from exactspline.geometry.plane_features import curvature_sign
from exactspline.geometry.singular_points import singularities
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector
from exactspline.papers import find
from exactspline.readings.taylor import Series
from exactspline.roots.root import Root


def curvature_value(curve: Any, root: Root, digits: int, side: str = "right") -> Any:
    """κ at a root as an mpmath number that is off by less than ``10^−digits`` (relatively, where it is larger than
    one).

    The Taylor coefficients at an enclosure of the root are taken in interval arithmetic, which bounds the error; the
    enclosure is refined until the bound holds.

    >>> from exactspline.geometry.inspection import inspect_curve
    >>> from exactspline.splines.examples import example
    >>> curvature_value(example("ellipse"), inspect_curve(example("ellipse")).critical[0].root, 10)
    mpf('2.0')
    """
    from mpmath import iv, mp

    in_space = curve.dimension == 3
    sign = space_features.curvature_sign_in_space(curve, root, side) if in_space else curvature_sign(curve, root)
    if sign == 0:
        return mp.mpf(0)
    formula = find("space_curvature_squared" if in_space else "curvature_squared")

    def enclosure(low: mpq, high: mpq) -> Any:
        squared = formula(_enclosed(curve, low, high, side)).value
        return iv.sqrt(squared) * sign if squared.a > 0 else None

    return _certified(root, digits, enclosure)


def torsion_value(curve: Any, root: Root, digits: int, side: str = "right") -> Any:
    """τ at a root (where κ = 0 its limit) as an mpmath number that is off by less than ``10^−digits``, as
    `curvature_value`.

    >>> from exactspline.geometry.inspection import inspect_curve
    >>> from exactspline.splines.examples import example
    >>> torsion_value(example("twisted_cubic"), inspect_curve(example("twisted_cubic")).critical[0].root, 10)
    mpf('3.0')

    Raises `FormulaError` at a singular point, where τ may have a pole.
    """
    if any(root == f.root for f in singularities(curve)):
        raise FormulaError("the torsion at a singular point", remedy="ask for it at regular points")
    tau = space_features.torsion_in_lowest_terms(curve)

    def enclosure(low: mpq, high: mpq) -> Any:
        top, bottom = [_enclose(f, low, high, side) for f in (tau.numerator, tau.denominator)]
        return top / bottom if bottom.a > 0 or bottom.b < 0 else None

    return _certified(root, digits, enclosure)


def _certified(root: Root, digits: int, enclosure: Callable[[mpq, mpq], Any]) -> Any:
    """A quantity at a root to so many digits: the root is refined until its enclosure (None: not yet known) is narrow
    enough.
    """
    from mpmath import iv, mp

    precision = digits + 10
    while True:
        low, high = root.refine(precision)
        saved = iv.dps
        try:
            iv.dps = precision + 10
            value = enclosure(low, high)
            if value is not None and value.delta <= mp.mpf(10) ** -digits * max(1, abs(value.mid)):
                with mp.workdps(digits + 5):
                    return mp.mpf(value.mid)
        finally:
            iv.dps = saved
        precision *= 2


def _interval(a: mpq, b: mpq) -> Any:
    """[a, b] in interval arithmetic."""
    from mpmath import iv

    ends = [iv.mpf(int(x.numerator)) / iv.mpf(int(x.denominator)) for x in (a, b)]
    return iv.mpf([ends[0].a, ends[1].b])


def _enclose(spline: Any, low: mpq, high: mpq, side: str) -> Any:
    """The values of a spline on [low, high], by de Casteljau's algorithm in interval arithmetic."""
    i = spline.mesh.locate(low, left=side == "left")
    a, b = spline.mesh.breaks[i : i + 2]
    t = _interval((low - a) / (b - a), (high - a) / (b - a))
    points = [_interval(x, x) for x in spline.segments[i]] or [_interval(mpq(0), mpq(0))]
    while len(points) > 1:
        points = [(1 - t) * p + t * q for p, q in pairwise(points)]
    return points[0]


def _enclosed(curve: Any, low: mpq, high: mpq, side: str) -> Curve:
    """The curve as a Taylor series with interval coefficients over [low, high]."""

    def series(spline: Any) -> Series:
        return Series([_enclose(spline.d(order), low, high, side) / max(order, 1) for order in range(3)])

    return Curve(Vector(*[series(x) for x in curve.p]), series(curve.w), polynomial=curve.polynomial)
