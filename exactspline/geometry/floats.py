"""Correctly rounded doubles of exact values: one number, or rows of them in one call."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf, isfinite
from typing import TYPE_CHECKING, TypeAlias, cast, overload

from exactspline.errors import NumberError, as_items
from exactspline.geometry.kinds import Feature
from exactspline.geometry.values_along import point_at
from exactspline.language.operand import checked_order
from exactspline.numbers.exact import DEEPEST, Number, Rounding, from_float, is_float, mpq
from exactspline.reals.real import Real, real
from exactspline.roots.values import exact_place
from exactspline.splines.expected import curve_of

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs

#: Values with a correctly rounded double; a feature stands for its parameter.
Exact: TypeAlias = Number | Real | Feature


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
    double: ``nearest``, ``down`` or ``up``, infinite beyond the largest. A float among the parameters counts with its
    binary value; where that is outside the domain, the double nearest to an end is this end.

    >>> from exactspline import example
    >>> at_floats(example("circle"), [0.5, "1/3"])
    [(0.6, 0.8), (0.8, 0.6)]
    >>> at_floats(example("circle"), [0.1], order=2, rounding="down")
    [(-3.7658897739592607, -1.160825816921463)]

    Raises `FormulaError` for a negative order, `DomainError` outside the domain.
    """
    curve, order = curve_of(curve), checked_order(order)
    return [
        tuple(_rounded(x, rounding) for x in point_at(curve, place_of(t, curve), order, side))
        for t in as_items(ts, "parameters")
    ]


def _rounded(x: Real, rounding: str) -> float:
    """The double as IEEE 754 rounds, infinite beyond the largest: one overflow does not end the others."""
    try:
        return x.double(rounding)
    except OverflowError:
        return inf if x.sign > 0 else -inf


def place_of(t: float | Number | Real, curve: Nurbs) -> mpq | Real:
    """A parameter of a curve. A float counts with its binary value; where that is outside the domain, the double
    nearest to an end is this end.
    """
    if not is_float(t):
        return exact_place(cast(Number | Real, t))
    low, high = curve.domain
    value = from_float(t)
    for end, outside in ((low, value < low), (high, value > high)):
        nearest = _rounded(Real(end), Rounding.NEAREST)
        if outside and isfinite(nearest) and value == from_float(nearest):
            return end
    return value
