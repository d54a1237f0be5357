"""Checks of the arguments of public functions; the error states what is expected."""

from __future__ import annotations

from typing import Any, TypeVar, cast

from exactspline.errors import ShapeError, a_kind, as_instance
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

C = TypeVar("C", bound=Curve[Any])


def of_file(given: object) -> object:
    """The curve of an object read from a file (a `NamedCurve`, or a `Reading` of one curve); anything else is returned
    unchanged.
    """
    named = hasattr(type(given), "curve") or "curve" in getattr(type(given), "__dataclass_fields__", ())
    return cast(Any, given).curve if named else given


def curve_of(given: object) -> Nurbs:
    """The curve itself, also the curve of a file; raises `ShapeError` for anything else, with a remedy for functions.

    >>> curve_of("circle")
    Traceback (most recent call last):
    exactspline.errors.ShapeError: a str, where a curve is expected; give a Nurbs, such as exactspline.example("circle")
    """
    given = given if isinstance(given, Nurbs) else of_file(given)
    if isinstance(given, Nurbs):
        return given
    if isinstance(given, BSpline):
        raise ShapeError("a function, where a curve is expected", remedy="exactspline.graph(f) is its graph")
    if isinstance(given, Rational | Vector) and given.is_vector:
        problem = f"{a_kind(given)} of splines, where a curve is expected"
        raise ShapeError(problem, remedy="Nurbs.from_splines(numerator, denominator) makes the curve of a quotient")
    return as_instance(given, Nurbs, "a curve", 'give a Nurbs, such as exactspline.example("circle")')


def of_dimension(curve: C, remedy: str, *dimensions: int, what: str = "a curve") -> C:
    """The curve itself; raises `ShapeError` with this remedy for a curve of another dimension."""
    if curve.dimension not in dimensions:
        raise ShapeError(f"{what} in R{curve.dimension}", remedy=remedy)
    return curve


def in_plane_or_space(given: object, what: str) -> Nurbs:
    """The curve of `curve_of`; raises `ShapeError` for one that is neither in the plane nor in space, where there is no
    such thing.
    """
    return of_dimension(curve_of(given), "this needs a curve in the plane or in space", 2, 3, what=what)


def spline_of(given: object) -> BSpline:
    """The spline itself; raises `ShapeError` for anything else."""
    return as_instance(given, BSpline, "a spline", "give a BSpline, for a vector one component at a time")


def surface_of(given: object) -> NurbsSurface:
    """The surface itself; raises `ShapeError` for anything else."""
    return as_instance(given, NurbsSurface, "a surface", 'give a NurbsSurface, such as exactspline.example("torus")')
