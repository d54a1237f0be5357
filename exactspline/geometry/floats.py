"""Correctly rounded doubles of exact values: one number, or rows of them in one call; behind
`exactspline.Nurbs.at_floats`, `curvature_floats` and `torsion_floats`.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, TypeAlias, cast, overload

from exactspline.errors import FormulaError
from exactspline.exact import Number, Rounding, from_float, is_float, mpq
from exactspline.geometry.kinds import Feature
from exactspline.geometry.values_along import curvature_at, point_at, torsion_at
from exactspline.roots.enclosure import exact_place
from exactspline.roots.real import Real, real
from exactspline.roots.root import Root
from exactspline.splines.surd import Surd

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs

#: Values with a correctly rounded double; a feature stands for its parameter.
Exact: TypeAlias = Number | Surd | Root | Real | Feature


# text is one number here, though for a type checker it is a sequence of texts
@overload
def floats(values: Exact, rounding: str = ...) -> float: ...  # type: ignore[overload-overlap]  # see above
@overload
def floats(values: Iterable[Exact], rounding: str = ...) -> list[float]: ...  # type: ignore[overload-overlap]  # likewise
@overload
def floats(values: Iterable[Iterable[Exact]], rounding: str = ...) -> list[list[float]]: ...
def floats(
    values: Exact | Iterable[Exact] | Iterable[Iterable[Exact]], rounding: str = Rounding.NEAREST
) -> float | list[float] | list[list[float]]:
    """The correctly rounded double (``nearest``, ``down`` or ``up``) of a number, a `Root`, a `Surd`, of the parameter
    of a feature; of every number in a sequence or in rows: knots, control points, zeros, inflections.

    >>> from exactspline import example, inflections
    >>> curve = example("cubic_s")
    >>> floats(inflections(curve)), floats(curve.control_points[1]), floats(mpq(1, 10), "up") - 0.1
    ([0.5], [1.0, 2.0], 0.0)

    Raises `NumberError` for anything that is not an exact number, `OverflowError` beyond the largest double.
    """
    if isinstance(values, Feature):
        return Real.of(values.root).double(rounding)
    if isinstance(values, Iterable) and not isinstance(values, str):
        return [floats(value, rounding) for value in values]  # type: ignore[return-value]  # all numbers, or all rows
    return real(values).double(rounding)


def at_floats(
    curve: Nurbs,
    ts: Iterable[float | Number | Root],
    *,
    order: int = 0,
    rounding: str = Rounding.NEAREST,
    side: str = "right",
) -> list[tuple[float, ...]]:
    """Points or derivatives at many parameters (see `exactspline.Nurbs.at_floats`)."""
    if type(order) is not int or order < 0:
        raise FormulaError(f"a derivative of order {order!r}", remedy="orders are 0, 1, 2, …")
    return [tuple(x.double(rounding) for x in point_at(curve, place_of(t), order, side)) for t in ts]


def curvature_floats(
    curve: Nurbs, ts: Iterable[float | Number | Root], *, rounding: str = Rounding.NEAREST, side: str = "right"
) -> list[float]:
    """The curvature at many parameters (see `exactspline.Nurbs.curvature_floats`)."""
    return [curvature_at(curve, place_of(t), side).double(rounding) for t in ts]


def torsion_floats(
    curve: Nurbs, ts: Iterable[float | Number | Root], *, rounding: str = Rounding.NEAREST, side: str = "right"
) -> list[float]:
    """The torsion at many parameters (see `exactspline.Nurbs.torsion_floats`)."""
    return [torsion_at(curve, place_of(t), side).double(rounding) for t in ts]


def place_of(t: float | Number | Root) -> mpq | Root:
    """A parameter; a float counts with its binary value."""
    return from_float(t) if is_float(t) else exact_place(cast(Number | Root, t))
