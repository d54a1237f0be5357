"""Curves of geomdl: read exactly, written with correct rounding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.errors import ShapeError
from exactspline.interchange.bridges.values import doubles, exact, exact_rows, periodic
from exactspline.interchange.writing import homogeneous
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import geomdl.abstract


def from_geomdl(curve: geomdl.abstract.Curve) -> Nurbs:
    """The curve defined by exactly the numbers that geomdl stores. By default geomdl maps the knots to [0, 1], which
    rounds them: where the last control points are the first ones, the knots outside of the domain are moved so that
    the curve is closed, by at most 8 units in the last place, as its note says. For a rational curve geomdl stores
    homogeneous points (w x, w), and these are read.

    Raises `ShapeError` for a surface, a volume, and objects that are not from geomdl.
    """
    from geomdl import abstract

    if not isinstance(curve, abstract.Curve):
        raise ShapeError(
            f"a {type(curve).__name__}, where a geomdl curve is expected", remedy="give a BSpline.Curve or NURBS.Curve"
        )
    degree, points = int(curve.degree), exact_rows(curve.ctrlptsw if curve.rational else curve.ctrlpts)
    knots, note = periodic(degree, [exact(t) for t in curve.knotvector], points)
    make = Nurbs.from_homogeneous if curve.rational else Nurbs
    return make(degree, knots, points, name=str(curve.name), note=note)


def to_geomdl(curve: Nurbs) -> geomdl.abstract.Curve:
    """A geomdl curve with the correctly rounded knots and points; the knots are not normalized to [0, 1]."""
    curve = curve_of(curve)

    from geomdl import NURBS
    from geomdl import BSpline as Polynomial

    made = Polynomial.Curve(normalize_kv=False) if curve.polynomial else NURBS.Curve(normalize_kv=False)
    made.degree = curve.degree
    if curve.polynomial:
        made.ctrlpts = [doubles(point) for point in curve.control_points]
    else:
        made.ctrlptsw = [doubles(homogeneous(*each)) for each in zip(curve.control_points, curve.weights, strict=True)]
    made.knotvector = doubles(curve.knots)
    return made
