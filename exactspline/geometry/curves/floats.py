"""Correctly rounded doubles of exact values: one number, or rows of them in one call."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import inf, isfinite, isnan, nan
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, cast, overload

from exactspline.errors import NumberError, as_items
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.values import (
    curvature,
    in_plane_or_space,
    is_singular,
    point_at,
    segment_at,
    signed_square,
)
from exactspline.language.operand import checked_order
from exactspline.numbers.exact import (
    DEEPEST,
    Number,
    Rounding,
    checked_rounding,
    double,
    double_root,
    from_float,
    is_float,
    mpq,
)
from exactspline.numbers.sides import Side
from exactspline.reals.real import Real, real
from exactspline.roots.values import exact_place
from exactspline.splines.inputs import checked_side
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs

#: Values with a correctly rounded double; a feature stands for its parameter.
Exact: TypeAlias = Number | Real | Feature


# text is one number here, though for a type checker it is a sequence of texts
@overload
def floats(values: Exact, rounding: str = ...) -> float:  # type: ignore[overload-overlap]  # see above
    """The correctly rounded double of a number."""


@overload
def floats(values: Iterable[Exact], rounding: str = ...) -> list[float]:  # type: ignore[overload-overlap]  # likewise
    """Those of the numbers in a sequence."""


@overload
def floats(values: Iterable[Iterable[Exact]], rounding: str = ...) -> list[list[float]]:
    """Those of the numbers in rows."""


def floats(
    values: Exact | Iterable[Exact] | Iterable[Iterable[Exact]], rounding: str = Rounding.NEAREST
) -> float | list[float] | list[list[float]]:
    """The correctly rounded double (``nearest``, ``down`` or ``up``) of a number, of the parameter
    of a feature; of every number in a sequence or in rows: knots, control points, zeros, features.

    >>> from exactspline import analyse, example
    >>> curve = example("cubic_s")
    >>> floats(analyse(example("cusp")).cusps), floats(curve.control_points[1]), floats(mpq(1, 10), "up") - 0.1
    ([0.5], [1.0, 2.0], 0.0)

    Raises `NumberError` for anything that is not an exact number, `OverflowError` beyond the largest double.
    """
    return cast("float | list[float] | list[list[float]]", _doubles(values, rounding, DEEPEST))


def _doubles(values: object, rounding: str, depth: int) -> object:
    """The doubles of numbers in sequences nested to some depth."""
    if isinstance(values, Feature):
        return values.root.double(rounding)
    if isinstance(values, Iterable) and not isinstance(values, str):
        if depth == 0:
            raise NumberError(
                f"lists nested more than {DEEPEST} levels deep", remedy="give a list of numbers, or of rows"
            )
        return [_doubles(value, rounding, depth - 1) for value in as_items(values, "numbers")]
    return real(cast(Number, values)).double(rounding)


def at_floats(
    curve: Nurbs,
    ts: Iterable[float | Number | Real],
    *,
    order: int = 0,
    rounding: str = Rounding.NEAREST,
    side: str = "right",
) -> list[tuple[float, ...]]:
    """The points (of `order` k: the k-th derivatives) at many parameters, every coordinate the correctly rounded
    double: ``nearest``, ``down`` or ``up``, beyond the largest as IEEE 754 rounds: infinite, or towards zero the
    largest. A float among the parameters counts with its binary value; where that is outside the domain, the double
    nearest to an end is this end.

    >>> from exactspline import example
    >>> at_floats(example("circle"), [0.5, "1/3"])
    [(0.6, 0.8), (0.8, 0.6)]
    >>> at_floats(example("circle"), [0.1], order=2, rounding="down")
    [(-3.7658897739592607, -1.160825816921463)]

    Raises `FormulaError` for a negative order, `DomainError` outside the domain.
    """
    curve, order, rounding = curve_of(curve), checked_order(order), checked_rounding(rounding)
    found = []
    for place in [place_of(t, curve) for t in as_items(ts, "parameters")]:
        point: Sequence[mpq | Real] = (
            point_at(curve, place, order, side) if isinstance(place, Real) else curve.derivative(order, place, side)
        )
        found.append(tuple([_rounded(x, rounding) for x in point]))
    return found


class Curvatures(NamedTuple):
    """Curvatures as doubles, NaN at the parameters where γ′ = 0, whose indices are `singular`."""

    values: list[float]
    singular: list[int]


def curvature_floats(
    curve: Nurbs, ts: Iterable[float | Number | Real], rounding: str = Rounding.NEAREST, side: Side | str = Side.RIGHT
) -> Curvatures:
    """The curvatures at many parameters, each the correctly rounded double: ``nearest``, ``down`` or ``up``. A float
    among the parameters counts with its binary value. Where γ′ = 0 the value is NaN, and the index is reported.

    >>> from exactspline import example
    >>> curvature_floats(example("circle"), [0.5, "1/3"]).values
    [1.0, 1.0]
    >>> values, singular = curvature_floats(example("cusp"), [0, 0.5])
    >>> values, singular
    ([-0.039283710065919304, nan], [1])

    Raises `DomainError` outside the domain, `ShapeError` unless in the plane or in space.
    """
    curve, left, values = in_plane_or_space(curve), checked_side(side), list[float]()
    rounding = checked_rounding(rounding)
    for place in (place_of(t, curve) for t in as_items(ts, "parameters")):
        if not isinstance(place, Real):
            sign, top, bottom = signed_square(curve, place, left=left)
            values.append(_rounded_root(sign, top, bottom, rounding) if bottom else nan)
        elif is_singular(curve, segment_at(curve, place, side), place, side):
            values.append(nan)
        else:
            values.append(_rounded(curvature(curve, place, side), rounding))
    return Curvatures(values, [i for i, value in enumerate(values) if isnan(value)])


def _rounded(x: mpq | Real, rounding: str) -> float:
    """The double as IEEE 754 rounds, also beyond the largest: one overflow does not end the others."""
    try:
        return x.double(rounding) if isinstance(x, Real) else double(x, rounding)
    except OverflowError:
        return inf if x > 0 else -inf


def _rounded_root(sign: int, top: int, bottom: int, rounding: str) -> float:
    try:
        return double_root(sign, top, bottom, rounding)
    except OverflowError:
        return sign * inf


def place_of(t: float | Number | Real, curve: Nurbs) -> mpq | Real:
    """A parameter of a curve. A float counts with its binary value; where that is outside the domain, the double
    nearest to an end is this end.
    """
    if not is_float(t):
        return exact_place(cast(Number | Real, t))
    low, high = curve.domain
    value = from_float(t)
    if low <= value <= high:
        return value
    for end, outside in ((low, value < low), (high, value > high)):
        nearest = _rounded(end, Rounding.NEAREST)
        if outside and isfinite(nearest) and value == from_float(nearest):
            return end
    return value
