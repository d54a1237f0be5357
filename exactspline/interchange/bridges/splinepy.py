"""Curves of splinepy: read exactly, written with correct rounding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import ShapeError, a_kind
from exactspline.interchange.bridges.values import doubles, exact, exact_rows, periodic
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import splinepy.spline


def from_splinepy(curve: splinepy.spline.Spline) -> Nurbs:
    """The curve defined by exactly the numbers that splinepy stores, for any of its four spline classes; the domain of
    a Bézier curve is [0, 1]. Where the last control points are the first ones, the curve is closed as by `from_geomdl`.

    Raises `ShapeError` for a surface or a volume, and for what is not a spline of splinepy.
    """
    if not isinstance(getattr(curve, "para_dim", None), int) or not hasattr(curve, "degrees"):
        raise ShapeError(f"{a_kind(curve)}, where a spline of splinepy is expected", remedy="give a splinepy.BSpline")
    if curve.para_dim != 1:
        raise ShapeError(f"a spline in {curve.para_dim} parameters", remedy="a curve has one")
    degree = int(curve.degrees[0])
    if curve.has_knot_vectors:
        knots = [exact(t) for t in curve.knot_vectors[0]]
    else:
        knots = [exact(int(i > degree)) for i in range(2 * degree + 2)]
    weights = [exact(w) for row in curve.weights for w in row] if curve.is_rational else [exact(1)] * len(curve.cps)
    points = exact_rows(curve.control_points)
    whole, note = periodic(degree, knots, [*zip(points, weights, strict=True)])
    return Nurbs(degree, whole, points, weights, note=note)


def to_splinepy(curve: Nurbs) -> splinepy.spline.Spline:
    """A splinepy ``BSpline`` or ``NURBS`` with the correctly rounded knots, points and weights."""
    curve = curve_of(curve)
    import splinepy

    points = [doubles(point) for point in curve.control_points]
    knots = [doubles(curve.knots)]
    if curve.polynomial:
        return splinepy.BSpline([curve.degree], knots, points)
    return splinepy.NURBS([curve.degree], knots, points, [[w] for w in doubles(curve.weights)])
