"""scipy's `BSpline`: in exactly, out correctly rounded."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import ShapeError
from exactspline.interchange.bridges.values import doubles, exact, exact_rows
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    import scipy.interpolate


def from_scipy(spline: scipy.interpolate.BSpline) -> Nurbs | BSpline:
    """The exact curve of a vector-valued spline, the exact `BSpline` of a scalar one: every double is its binary value.

    Raises `ShapeError` for coefficients of more than two axes, and the errors of `Nurbs`.
    """
    degree, knots = int(spline.k), [exact(t) for t in spline.t]
    count = len(knots) - degree - 1
    # scipy allows more coefficients than the knots need
    coefficients = spline.c[:count]
    if coefficients.ndim == 1:
        return BSpline(degree, knots, [exact(c) for c in coefficients])
    if coefficients.ndim != 2:
        raise ShapeError(f"coefficients of shape {coefficients.shape}", remedy="a curve has one row per control point")
    return Nurbs(degree, knots, exact_rows(coefficients))


def to_scipy(curve: Nurbs | BSpline) -> scipy.interpolate.BSpline:
    """A scipy spline with the correctly rounded knots and control points.

    Raises `ShapeError` for a rational curve, for which scipy has no class.
    """
    import numpy as np
    from scipy.interpolate import BSpline as SciPyBSpline

    if isinstance(curve, BSpline):
        return SciPyBSpline(np.array(doubles(curve.knots)), np.array(doubles(curve.control_points)), curve.degree)
    if not curve.polynomial:
        raise ShapeError("a rational curve", remedy="convert the components of its p and w separately")
    points = np.array([doubles(point) for point in curve.control_points])
    return SciPyBSpline(np.array(doubles(curve.knots)), points, curve.degree)
