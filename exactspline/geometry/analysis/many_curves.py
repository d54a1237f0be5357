"""Inflections and curvature extrema of thousands of plane curves, as arrays: of Bézier curves given as arrays of
doubles, and of curves of any degrees and numbers of segments.

For Bézier curves the forms are computed in doubles with proved bounds (`exactspline.programs.doubles`), their zeros are
isolated where doubles certify them (`exactspline.polynomials.doubles`). Every answer equals that of
`exactspline.analyse` for the curve with exactly these doubles as data. All other curves, and Bézier curves with equal
ends, are passed to `analyse` one by one. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain, islice
from math import comb
from types import MappingProxyType
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from exactspline.errors import ExactSplineError, FormulaError, NumberError, ShapeError, as_items
from exactspline.geometry.analysis.curves import Analysis
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.curves.plane_programs import plane_program
from exactspline.numbers.exact import Rounding, double, from_floats, is_float, mpq, rational
from exactspline.polynomials.doubles import (
    Bounded,
    Flags,
    Floats,
    Integers,
    Isolated,
    isolated,
    narrowed,
    ordinates,
    without_zeros,
)
from exactspline.programs.doubles import in_doubles
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

#: The number of segments that are computed together, so that their numbers fit into the cache.
AT_ONCE = 4096


class Form(NamedTuple):
    """A form on many segments: its ordinates, and its zeros on the segments where they are certified."""

    rows: Bounded
    zeros: Isolated


class _Filtered(NamedTuple):
    """κ and κ′ up to positive factors on many segments, and ‖γ′‖²; the segments that are not certified: on the `open`
    ones a sign that decides a zero is uncertain, on the `slow` ones it is uncertain that γ′ has no zero and all weights
    are positive.
    """

    curvature: Form
    critical: Form
    speed: Bounded
    open: Flags
    slow: Flags


def filtered(degree: int, operands: list[Floats]) -> _Filtered | None:
    """The certified results for segments of one degree, from the scaled coefficients of their components and, for
    rational segments, of their weight functions, rounded at most twice; no Bézier ordinate is larger than 1. None where
    the forms exceed the range of doubles.

    >>> done = filtered(3, [np.array([[0.0, 1, 2, 1]]) / 4, np.array([[0.0, 3, -3, 1]]) / 4])
    >>> done.curvature.zeros.row.tolist(), done.open.tolist()
    ([0], [False])
    """
    slow, undecided = np.zeros((2, len(operands[0])), dtype=bool)
    if len(operands) == 3:
        slow |= ~(operands[2] > 0).all(axis=1)
    try:
        forms = in_doubles(plane_program(degree, len(operands) == 3), operands, roundings=2)
    except FormulaError:
        return None
    *rows, speed = (ordinates(*form) for form in forms)
    slow |= ~without_zeros(speed)
    solved = [_solved(form, undecided) for form in rows]
    left = undecided | slow
    curvature, critical = (Form(rows, narrowed(rows, zeros.where(~left[zeros.row]))) for rows, zeros in solved)
    return _Filtered(curvature, critical, speed, undecided, slow)


def _solved(rows: Bounded, undecided: Flags) -> Form:
    """The zeros of a form; segments on which they are not certified are added to the undecided ones."""
    zeros, open_ = isolated(rows)
    undecided |= open_
    return Form(rows, zeros)


#: The codes of the kinds in an array.
KINDS = (FeatureKind.INFLECTION, FeatureKind.MAXIMUM, FeatureKind.MINIMUM)
#: All integers up to this one are doubles.
WHOLE = 2**53
#: The bits of a double without its sign, and those of the smallest normal double, read as integers.
SIZE, LEAST = 2**63 - 1, 2**52
TINY = mpq(1, 2**1022)
#: The width up to which an interval is not refined, and the digits to which wider intervals are refined.
NARROW, DIGITS = mpq(1, 10**9), 15
#: The rows of one or many curves: the index of the curve, the kinds, both bounds, and the index of the form that
#: vanishes.
Found = tuple[Integers, NDArray[np.str_], Floats, Floats, Integers]


class ManyFeatures(NamedTuple):
    """Features of many curves: the index of the curve, the kind of the feature (the value of a `FeatureKind`), and an
    interval that contains its parameter; `exact` are the indices of the curves that were decided in exact arithmetic,
    `refused` has the reasons why other curves have no features.

    The features are in the order of the curves; for each curve first the points with κ = 0, then those with κ′ = 0, in
    the order of the parameter.
    """

    curve: Integers
    kind: NDArray[np.str_]
    low: Floats
    high: Floats
    exact: Integers
    refused: Mapping[int, ExactSplineError] = MappingProxyType({})

    def __eq__(self, other: object) -> bool:
        """Whether all rows, and the reasons for refused curves, are the same."""
        if not isinstance(other, ManyFeatures):
            return NotImplemented
        reasons = [{i: (type(error), str(error)) for i, error in each.refused.items()} for each in (self, other)]
        return reasons[0] == reasons[1] and all(map(np.array_equal, self[:5], other[:5]))

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        raise TypeError("the features of many curves are arrays, which have no hash")

    def __reduce__(self) -> tuple[object, ...]:
        return _restored, (*self[:5], dict(self.refused))  # a read-only mapping cannot be pickled


def _restored(
    curve: Integers, kind: NDArray[np.str_], low: Floats, high: Floats, exact: Integers, refused: dict[int, Any]
) -> ManyFeatures:
    """The unpickled features."""
    return ManyFeatures(curve, kind, low, high, exact, MappingProxyType(refused))


def features_of_curves(curves: Iterable[Nurbs] | ArrayLike, weights: ArrayLike | None = None) -> ManyFeatures:
    """Return the inflections and curvature extrema of plane curves of any degrees. Bézier curves of the same degree may
    also be given as arrays of doubles: points of the shape (curves, degree + 1, 2), and `weights` of the shape (curves,
    degree + 1).

    A curve is refused if it is not in the plane, if a number is not finite or not a double, or if the denominator of
    the curve has a zero; the other curves are computed.

    >>> from exactspline import example
    >>> features = features_of_curves([example("six_segment_cubic"), example("cubic_s")] * 2)
    >>> np.bincount(features.curve).tolist(), len(features.refused)
    ([10, 3, 10, 3], 0)
    >>> features = features_of_curves([[(0, 0), (1, 2), (2, -2), (3, 0.5)]] * 2)
    >>> features.curve.tolist(), features.kind.tolist(), features.exact.tolist()
    ([0, 0, 0, 1, 1, 1], ['inflection', 'minimum', 'maximum', 'inflection', 'minimum', 'maximum'], [])
    >>> list(features_of_curves([[(0, 0), (1, float("nan"))], [(0, 0), (1, 1)]]).refused.values())
    [NumberError('points[0]: is not a finite number; write finite numbers')]

    Raises `ShapeError` for arrays of another shape, `NumberError` for arrays that do not contain numbers.
    """
    if isinstance(curves, np.ndarray):
        return _concatenated(list(features_in_parts(curves, weights)))
    source = iter(as_items(cast("Iterable[Nurbs]", curves), "curves"))
    first = next(source, None)
    if isinstance(first, Sequence) and not isinstance(first, str):
        return _concatenated(list(features_in_parts([first, *source], weights)))
    parts = list(curve_features_in_parts(() if first is None else chain([first], source)))
    return _concatenated(parts) if parts else _in_order([], np.zeros(0, dtype=int), {})


def curve_features_in_parts(curves: Iterable[Nurbs], *, at_once: int = AT_ONCE) -> Iterator[ManyFeatures]:
    """The features of curves as from `features_of_curves`, for this many curves at a time, so that partial results are
    available.
    """
    source, start = iter(as_items(curves, "curves")), 0
    while some := list(islice(source, at_once)):
        yield _of_curves(some, start)
        start += len(some)


def _of_curves(curves: Sequence[Nurbs], start: int) -> ManyFeatures:
    """The features of curves that are numbered from `start`."""
    refused: dict[int, ExactSplineError] = {}
    parts, exact = _one_by_one(((i, partial(_plane, curve, i)) for i, curve in enumerate(curves, start)), refused)
    return _in_order(parts, np.array(exact, dtype=int), refused)


def _plane(curve: Nurbs, i: int) -> Nurbs:
    """The i-th curve, in the plane; raises `ShapeError` for anything else."""
    try:
        curve = in_the_plane(curve_of(curve))
        if curve.dimension != 2:
            raise ShapeError(f"a curve in {curve.dimension} dimensions", remedy="in 2")
    except ShapeError as error:
        raise ShapeError(error.problem, where=f"curves[{i}]", remedy=error.remedy) from None
    return curve


def _one_by_one(
    curves: Iterable[tuple[int, Callable[[], Nurbs]]], refused: dict[int, ExactSplineError]
) -> tuple[list[Found], list[int]]:
    """The features of curves, and which were decided in exact arithmetic; `refused` receives the reasons of others."""
    parts: list[Found] = []
    exact: list[int] = []
    for i, made in curves:
        try:
            analysis = Analysis(made())
            parts.append(_found(i, analysis))
        except ExactSplineError as error:
            refused[i] = error
            continue
        if not analysis.decided_in_doubles:
            exact.append(i)
    return parts, exact


def _concatenated(parts: list[ManyFeatures]) -> ManyFeatures:
    """Several parts (at least one) joined into one."""
    refused = {i: error for part in parts for i, error in part.refused.items()}
    curve, kind, low, high, exact = (
        np.concatenate(column) for column in zip(*(part[:5] for part in parts), strict=True)
    )
    return ManyFeatures(curve, kind, low, high, exact, MappingProxyType(refused))


def features_in_parts(
    points: ArrayLike, weights: ArrayLike | None = None, *, at_once: int = AT_ONCE
) -> Iterator[ManyFeatures]:
    """The features of Bézier curves in arrays as from `features_of_curves`, for a part of the curves at a time."""
    p, w, wrong = _checked(points, weights)
    for start in range(0, max(len(p), 1), at_once):
        some = slice(start, start + at_once)
        own = {i - start: error for i, error in wrong.items() if start <= i < start + at_once}
        features = _features(p[some], None if w is None else w[some], own)
        refused = {i + start: error for i, error in sorted(features.refused.items())}
        yield features._replace(
            curve=features.curve + start, exact=features.exact + start, refused=MappingProxyType(refused)
        )


def _checked(points: ArrayLike, weights: ArrayLike | None) -> tuple[Floats, Floats | None, dict[int, ExactSplineError]]:
    """The numbers as doubles, and the errors by curve; wrong numbers are replaced by zeros."""
    p, inexact = _doubles(points, "points")
    if p.ndim != 3 or p.shape[1] < 2 or p.shape[2] != 2:
        raise ShapeError(f"points of the shape {p.shape}", where="points", remedy="(curves, degree + 1, 2)")
    w = None
    wrong = _wrong(p, inexact, "points")
    if weights is not None:
        w, inexact = _doubles(weights, "weights")
        if w.shape != p.shape[:2]:
            raise ShapeError(f"weights of the shape {w.shape}", where="weights", remedy=f"{p.shape[:2]}, one per point")
        wrong = _wrong(w, inexact, "weights") | wrong
    if wrong:
        p = p.copy()
        p[list(wrong)] = 0
    return p, w, wrong


def _doubles(given: ArrayLike, name: str) -> tuple[Floats, Flags]:
    """Numbers as doubles, and which numbers changed their value. A masked entry of an array is not a number."""
    try:
        a = np.ma.filled(given, np.nan) if isinstance(given, np.ma.MaskedArray) else np.asarray(given)
    except (ValueError, TypeError) as error:
        raise ShapeError(f"{name} are not an array: {error}", where=name, remedy="rows of one length") from None
    if a.dtype.kind not in "fiuO":
        raise NumberError(f"{name} of the type {a.dtype}", where=name, remedy="an array of doubles")
    if a.dtype.kind == "O":
        numbers = [_double(x, name) for x in a.flat]
        flags = np.array([exact for _, exact in numbers], dtype=bool).reshape(a.shape)
        return np.array([x for x, _ in numbers], dtype=float).reshape(a.shape), ~flags
    with np.errstate(all="ignore"):
        f = a.astype(float)
        changed = np.zeros(a.shape, dtype=bool)
        if a.dtype.kind == "f" and a.dtype.itemsize > 8:
            changed = np.isfinite(a) & (f.astype(a.dtype) != a)
        elif a.dtype.kind in "iu" and a.dtype.itemsize == 8:
            for index in np.argwhere((a > WHOLE) | (f < -WHOLE)):
                place = tuple(index)
                changed[place] = int(a[place]) != int(f[place])
    return f, changed


def _double(number: object, name: str) -> tuple[float, bool]:
    """An exact number or a float as a double, and whether the conversion changed it."""
    if is_float(number):
        return float(number), True
    value = rational(number)  # type: ignore[arg-type]  # the gate refuses what is not a number
    try:
        near = float(value)
    except OverflowError:
        return 0, False
    return near, mpq(near) == value


def _wrong(a: Floats, inexact: Flags, name: str) -> dict[int, ExactSplineError]:
    """The errors in the numbers of each curve."""
    wrong: dict[int, ExactSplineError] = {}
    for bad, message, remedy in (
        (inexact, "is not a double", "write doubles, or use `analyse`"),
        (~np.isfinite(a), "is not a finite number", "write finite numbers"),
    ):
        for row in np.unique(np.nonzero(bad)[0]).tolist():
            wrong[row] = NumberError(message, where=f"{name}[{row}]", remedy=remedy)
    return wrong


def _features(p: Floats, w: Floats | None, wrong: dict[int, ExactSplineError]) -> ManyFeatures:
    """The features of the curves of one part."""
    # equal ends form a knot, at which signs may change, too
    alone = np.array(_subnormal(p).any(axis=(1, 2)) | (p[:, 0] == p[:, -1]).all(axis=1), dtype=bool)
    if w is not None:
        alone |= _subnormal(w).any(axis=1)
    features: list[Found] = []
    done = filtered(p.shape[1] - 1, scaled_operands(p, w))
    if done is None:
        alone[:] = True
    else:
        alone |= done.open | done.slow
        for which, form in enumerate((done.curvature, done.critical)):
            zeros = form.zeros.where(~alone[form.zeros.row])
            kinds = np.where(zeros.before > 0, *KINDS[1:]) if which else np.full(len(zeros.row), KINDS[0])
            features.append((zeros.row, kinds, zeros.low, zeros.high, np.full(len(zeros.row), which)))
    alone[list(wrong)] = False
    refused = dict(wrong)
    left = ((i, partial(_curve, p[i], None if w is None else w[i])) for i in np.flatnonzero(alone).tolist())
    parts, exact = _one_by_one(left, refused)
    return _in_order([*features, *parts], np.array(exact, dtype=int), refused)


def _in_order(parts: list[Found], exact: Integers, refused: Mapping[int, ExactSplineError]) -> ManyFeatures:
    """The features of curves, found in any order, in the order of the curves."""
    curve, kind, low, high, which = (np.concatenate(column) for column in zip(NONE, *parts, strict=True))
    order = np.lexsort((high, low, which, curve))
    return ManyFeatures(curve[order], kind[order].astype(str), low[order], high[order], exact, refused)


#: No features.
NONE: Found = (np.zeros(0, dtype=int), np.zeros(0, dtype=str), np.zeros(0), np.zeros(0), np.zeros(0, dtype=int))


def _subnormal(a: Floats) -> Flags:
    """Which numbers are subnormal, so that a processor may treat them as zero; decided by their bits, because a
    comparison may treat them as zero, too.
    """
    bits = np.ascontiguousarray(a).view(np.int64) & SIZE
    return (bits > 0) & (bits < LEAST)


def scaled_operands(p: Floats, w: Floats | None) -> list[Floats]:
    """The scaled coefficients of numerators (and denominators) of curves scaled down by powers of two."""
    scale = np.array([float(comb(p.shape[1] - 1, i)) for i in range(p.shape[1])])
    x = _small(p, axis=(1, 2))
    if w is None:
        return [x[:, :, 0] * scale, x[:, :, 1] * scale]
    v = _small(w, axis=(1,))
    return [x[:, :, 0] * v * scale, x[:, :, 1] * v * scale, v * scale]


def _small(a: Floats, axis: tuple[int, ...]) -> Floats:
    """Every curve's numbers times a power of two, so that none is larger than 1."""
    _, exponents = np.frexp(np.abs(a).max(axis=axis, keepdims=True))
    return cast(Floats, np.ldexp(a, -exponents))


def _curve(p: Floats, w: Floats | None) -> Nurbs:
    degree = len(p) - 1
    knots = [0] * (degree + 1) + [1] * (degree + 1)
    return Nurbs(degree, knots, [_exact(row) for row in p], None if w is None else _exact(w))


def _exact(row: Floats) -> list[mpq]:
    """The values of doubles; subnormal doubles are read from their bits."""
    values: list[mpq] = from_floats(row.tolist())
    for k in np.flatnonzero(_subnormal(row)).tolist():
        bits = int(row[k : k + 1].view(np.int64)[0])
        size = mpq(bits & SIZE, 2**1074)
        values[k] = -size if bits < 0 else size
    return values


def _found(i: int, analysis: Analysis) -> Found:
    """The features of one curve."""
    lists = analysis.inflections, analysis.curvature_extrema
    features = [(which, feature) for which, own in enumerate(lists) for feature in own]
    roots = [feature.root for _, feature in features]
    # the filter narrows intervals as far as doubles allow, which is enough if few digits are lost
    near = [root if root.high - root.low <= NARROW else root.refine(DIGITS) for root in roots]
    bounds = [_outside(place.low, place.high) for place in near]
    return (
        np.full(len(features), i),
        np.array([str(feature.kind) for _, feature in features], dtype=str),
        np.array([low for low, _ in bounds], dtype=float),
        np.array([high for _, high in bounds], dtype=float),
        np.array([which for which, _ in features], dtype=int),
    )


def _outside(low: mpq, high: mpq) -> tuple[float, float]:
    """The nearest doubles outside an interval that are not subnormal, whatever the rounding mode of the processor.

    >>> _outside(mpq(1, 3), mpq(1, 3)) == (1 / 3, 1 / 3 + 2.0**-54)
    True
    >>> _outside(mpq(0), mpq(1, 10**400)) == (0, 2.0**-1022)
    True

    Raises `NumberError` beyond the largest double.
    """
    low, high = (mpq(0) if 0 < low < TINY else low), (mpq(0) if -TINY < high < 0 else high)
    low, high = (-TINY if -TINY < low < 0 else low), (TINY if 0 < high < TINY else high)
    try:
        return double(low, Rounding.DOWN), double(high, Rounding.UP)
    except OverflowError:
        raise NumberError("a parameter exceeds the range of doubles", remedy="use `analyse`") from None
