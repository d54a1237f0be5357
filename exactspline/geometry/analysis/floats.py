"""Correctly rounded doubles: of exact numbers, and of curves, functions and surfaces at many parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import partial
from math import inf, isfinite, nan
from typing import TYPE_CHECKING, Any, TypeAlias, cast, overload

from exactspline.errors import DomainError, NumberError, ShapeError, a_kind, as_items, counted, shown
from exactspline.formulas.derivatives import across
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.values import (
    curvature,
    in_plane_or_space,
    point_at,
    segment_at,
    signed_square,
    torsion,
    unit,
)
from exactspline.geometry.derived.derive import space
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.language.operand import checked_order
from exactspline.language.vector import Vector, perp
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
    rational,
)
from exactspline.numbers.intervals import Interval, Side
from exactspline.reals.real import Real, real
from exactspline.roots.values import evaluate, exact_place
from exactspline.splines.bspline import BSpline
from exactspline.splines.inputs import checked_side
from exactspline.splines.nurbs import Nurbs, derivative_splines
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import of_file
from exactspline.words import Word, choice

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: Values with a correctly rounded double; the value of a feature is its parameter.
Exact: TypeAlias = Number | Real | Feature
#: The objects that are evaluated at parameters.
Evaluated: TypeAlias = Nurbs | BSpline | NurbsSurface | TensorSpline
#: The order of a derivative: a number, or one number for each of two parameters.
Orders: TypeAlias = int | tuple[int, int]


class Quantity(Word):
    """The quantities at parameters: the first six are defined for curves; points, normals and the last two for
    surfaces.
    """

    POINT = "point"
    TANGENT = "tangent"
    UNIT_TANGENT = "unit_tangent"
    NORMAL = "normal"
    CURVATURE = "curvature"
    TORSION = "torsion"
    GAUSSIAN_CURVATURE = "gaussian_curvature"
    MEAN_CURVATURE = "mean_curvature"


SCALARS_OF_SURFACES = (Quantity.GAUSSIAN_CURVATURE, Quantity.MEAN_CURVATURE)
#: What is evaluated at parameters of these types all together.
PLAIN, RATIOS = (Quantity.POINT, 0, Rounding.NEAREST), {float, int, type(mpq())}
SCALARS = (Quantity.CURVATURE, Quantity.TORSION, *SCALARS_OF_SURFACES)


# a text is one number here, but for a type checker it is a sequence of texts
@overload
def floats(values: Exact, *, rounding: str = ...) -> float:  # type: ignore[overload-overlap]  # see above
    """The correctly rounded double of a number."""


@overload
def floats(values: Iterable[Exact], *, rounding: str = ...) -> list[float]:  # type: ignore[overload-overlap]  # likewise
    """The correctly rounded doubles of the numbers in a sequence."""


@overload
def floats(values: Iterable[Iterable[Exact]], *, rounding: str = ...) -> list[list[float]]:
    """The correctly rounded doubles of the numbers in rows."""


@overload
def floats(
    values: Evaluated, *parameters: object, of: str = ..., order: Orders = ..., rounding: str = ..., side: str = ...
) -> NDArray[np.float64]:
    """The correctly rounded doubles of a curve, a function or a surface at parameters."""


def floats(
    values: Exact | Iterable[Exact] | Iterable[Iterable[Exact]] | Evaluated,
    *parameters: object,
    of: str = Quantity.POINT,
    order: Orders = 0,
    rounding: str = Rounding.NEAREST,
    side: str = Side.RIGHT,
) -> float | list[float] | list[list[float]] | NDArray[np.float64]:
    """Return the correctly rounded doubles of numbers, or of a curve, a function or a surface at parameters, which may
    be doubles. `rounding` is ``nearest``, ``down`` or ``up``. ``curve.floats(ts)`` is ``floats(curve, ts)``.

    The result for a number, or for a feature (its parameter), is a double; for a sequence (knots, zeros) or for rows
    (control points), a list of doubles or of lists:

    >>> from exactspline import analyse, example
    >>> curve = example("cubic_s")
    >>> floats(analyse(example("cusp")).cusps), floats(curve.control_points[1]), floats(mpq(1, 10), rounding="up") - 0.1
    ([0.5], [1.0, 2.0], 0.0)

    For a curve at parameters `ts` (for a surface `us`, `vs`, which are broadcast) the result is an array of the same
    shape, with one more axis for vectors. The array contains the points, the derivatives of an `order` (for a surface a
    pair), or the quantity `of`: ``tangent``, ``unit_tangent``, ``normal``, ``curvature``, ``torsion``; for a surface
    ``normal``, ``gaussian_curvature``, ``mean_curvature``. The array contains NaN where the quantity is not defined. A
    double as a parameter means its exact binary value; if this value is outside the domain, the double nearest to an
    end means the end. Numbers beyond the largest double are rounded as in IEEE 754.

    >>> circle = example("circle")
    >>> circle.floats([0.5, "1/3"]).tolist(), circle.floats(0.5, of="curvature").tolist()
    ([[0.6, 0.8], [0.8, 0.6]], 1.0)
    >>> circle.floats([0.1], order=2, rounding="down").tolist()
    [[-3.7658897739592607, -1.160825816921463]]
    >>> example("cusp").floats([0, 0.5], of="curvature").tolist()
    [-0.039283710065919304, nan]
    >>> example("sphere").floats([[0.25], [0.5]], [0.25, 0.5, 0.75], of="gaussian_curvature").shape
    (2, 3)

    Raises `NumberError` for anything that is not a number, `DomainError` outside the domain, `ShapeError` if the object
    does not have the quantity, `OverflowError` for a number beyond the largest double.
    """
    given: object = of_file(values)
    if isinstance(given, Evaluated):
        if not parameters:
            raise ShapeError(f"{a_kind(given)} without parameters", remedy="write curve.floats(ts)")
        quantity = choice(Quantity, of, "quantity", raised=ShapeError)
        if order and quantity is not Quantity.POINT:
            raise ShapeError(f"a derivative of the {quantity}", remedy="an order is that of a derivative of the curve")
        limit = Side.LEFT if checked_side(side) else Side.RIGHT
        return _values(given, parameters, quantity, order, checked_rounding(rounding), limit)
    if parameters:
        raise ShapeError(f"parameters of {a_kind(given)}", remedy="write curve.floats(ts)")
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


def _values(
    given: Evaluated, parameters: Sequence[object], of: Quantity, order: Orders, rounding: Rounding, side: Side
) -> NDArray[np.float64]:
    """The doubles at parameters, as an array of their shape, with one more axis where they are vectors."""
    import numpy as np

    count = 2 if isinstance(given, NurbsSurface | TensorSpline) else 1
    if len(parameters) != count:
        remedy = f"write .floats({'us, vs' if count == 2 else 'ts'})"
        raise ShapeError(f"{counted(len(parameters), 'row')} of parameters", remedy=remedy)
    grids = np.broadcast_arrays(*[np.asarray(_listed(ts), dtype=object) for ts in parameters])
    if isinstance(given, NurbsSurface | TensorSpline):
        if side is Side.LEFT:
            raise ShapeError("a left side of a surface", remedy="on knot lines limits are those from inside u+, v+")
        rows = _of_surface(given, grids, of, order, rounding)
    else:
        ts, n = grids[0].ravel().tolist(), checked_order(cast(int, order))
        if isinstance(given, Nurbs) and (of, n, rounding) == PLAIN and RATIOS.issuperset(map(type, ts)):
            # other parameters, and coordinates beyond the largest double, go the other way
            with suppress(DomainError, ValueError, OverflowError):
                points = given.evaluation.doubles(ts, left=side is Side.LEFT)
                return np.array(points).reshape((*grids[0].shape, given.dimension))
        rows = _of_curve(given, [_place_of(t, given.domain) for t in ts], of, n, rounding, side)
    vectors = isinstance(given, Nurbs | NurbsSurface) and of not in SCALARS
    axes = (given.dimension,) if isinstance(given, Nurbs | NurbsSurface) and vectors else ()
    return np.array(rows, dtype=float).reshape((*grids[0].shape, *axes))


def _listed(ts: object) -> object:
    """Parameters as numpy reads them: a set of zeros, or any other iterable that is not a list, as a list."""
    return list(ts) if isinstance(ts, Iterable) and not isinstance(ts, str) and not hasattr(ts, "dtype") else ts


def _of_curve(
    given: Nurbs | BSpline, places: Sequence[mpq | Real], of: Quantity, order: int, rounding: Rounding, side: Side
) -> list[list[float]]:
    """The doubles of one quantity of a curve, or of a function, at its parameters."""
    if isinstance(given, BSpline):
        if of is not Quantity.POINT:
            raise ShapeError(f"the {of} of a function", remedy="exactspline.graph(f) is the curve that it draws")
        derived = given.d(order)
        return [[_rounded(evaluate(derived, place, side=side), rounding)] for place in places]
    if of in SCALARS_OF_SURFACES:
        raise ShapeError(f"the {of} of a curve", remedy="there are curvature and torsion")
    for place in places:
        segment_at(given, place, side)
    if of is Quantity.CURVATURE:
        plane, left = in_plane_or_space(given), side is Side.LEFT
        return [[_curvature(plane, place, rounding, side, left=left)] for place in places]
    if of is Quantity.POINT and not order and not any(isinstance(place, Real) for place in places):
        points = given.evaluation.points(cast("Sequence[mpq]", places), left=side is Side.LEFT)
        return [[_rounded(x, rounding) for x in point] for point in points]
    size = 1 if of in SCALARS else given.dimension
    return [_defined(partial(_vector, given, t, of, order, side), size, rounding) for t in places]


def _direction_at(curve: Nurbs, place: mpq | Real, side: Side | str = Side.RIGHT, *, normal: bool) -> tuple[Real, ...]:
    """The unit tangent, or the unit normal, at a rational parameter or an irrational root.

    >>> from exactspline import example, zeros
    >>> circle = example("circle")
    >>> [x.double() for x in _direction_at(circle, zeros(circle.p[0] - circle.p[1])[0], normal=True)]
    [-0.7071067811865476, -0.7071067811865476]
    """
    if not isinstance(place, Real):
        return curve.normal(place, side) if normal else curve.unit_tangent(place, side)
    first = Vector(*derivative_splines(curve, 1)[0])
    if not normal:
        return tuple(unit(first, place, "the tangent"))
    if curve.dimension == 2:
        return tuple(unit(perp(first), place, "the normal"))
    # the second derivative contains one more power of w in its denominator
    second = Vector(*[x * curve.w for x in derivative_splines(space(curve), 2)[0]])
    return tuple(unit(across(first, second), place, "the normal"))


def _vector(curve: Nurbs, place: mpq | Real, of: Quantity, order: int, side: Side) -> Sequence[mpq | Real]:
    if of is Quantity.TORSION:
        return [torsion(curve, place, side)]
    if of in (Quantity.NORMAL, Quantity.UNIT_TANGENT):
        return _direction_at(curve, place, side, normal=of is Quantity.NORMAL)
    order = 1 if of is Quantity.TANGENT else order
    return point_at(curve, place, order, side) if isinstance(place, Real) else curve.derivative(order, place, side)


def _defined(value: Callable[[], Sequence[mpq | Real]], size: int, rounding: Rounding) -> list[float]:
    """The doubles of a vector, NaN where the vector is not defined; its parameter is in the domain."""
    try:
        return [_rounded(x, rounding) for x in value()]
    except DomainError:
        return [nan] * size


def _curvature(curve: Nurbs, place: mpq | Real, rounding: Rounding, side: Side, *, left: bool) -> float:
    """The curvature at a parameter, NaN where γ′ = 0."""
    if not isinstance(place, Real):
        sign, top, bottom = signed_square(curve, place, left=left)
        return _rounded_root(sign, top, bottom, rounding) if bottom else nan
    return _defined(lambda: [curvature(curve, place, side)], 1, rounding)[0]


def _of_surface(
    given: NurbsSurface | TensorSpline, grids: Sequence[Any], of: Quantity, order: Orders, rounding: Rounding
) -> list[list[float]]:
    """The doubles of one quantity of a surface, or of a function of two parameters."""
    places = [
        tuple(rational(cast(mpq, _place_of(t, side))) for t, side in zip(place, given.domain, strict=True))
        for place in zip(*[grid.flat for grid in grids], strict=True)
    ]
    pair = order if isinstance(order, tuple) else (order, order)
    if len(pair) != 2 or (order and not isinstance(order, tuple)):
        raise ShapeError(f"the order {shown(order)} of a derivative by u and v", remedy="write order=(1, 0)")
    i, j = map(checked_order, pair)
    if isinstance(given, TensorSpline):
        if of is not Quantity.POINT:
            raise ShapeError(f"the {of} of a function", remedy="a surface is exactspline.NurbsSurface(…)")
        derived = given.partial(i, j)
        return [[_rounded(derived(u, v), rounding)] for u, v in places]
    if of is Quantity.POINT:
        return [[_rounded(x, rounding) for x in given.partial(i, j, u, v)] for u, v in places]
    if of is Quantity.NORMAL:
        return [_defined(partial(given.normal, u, v), 3, rounding) for u, v in places]
    if of not in SCALARS_OF_SURFACES:
        raise ShapeError(f"the {of} of a surface", remedy=f"there are point, normal, {', '.join(SCALARS_OF_SURFACES)}")
    forms, which = SurfaceForms(given), SCALARS_OF_SURFACES.index(of)
    return [[_defined(partial(forms.curvatures, u, v), 2, rounding)[which]] for u, v in places]


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


def _place_of(t: object, domain: Interval) -> mpq | Real:
    """A parameter in a domain. A float means its exact binary value; if this is outside the domain, the double nearest
    to an end means this end.
    """
    if isinstance(t, Feature):
        t = t.root
    if not is_float(t):
        return exact_place(cast(Number | Real, t))
    value, (low, high) = from_float(t), domain
    if low <= value <= high:
        return value
    end = low if value < low else high
    nearest = _rounded(end, Rounding.NEAREST)
    return end if isfinite(nearest) and value == from_float(nearest) else value
