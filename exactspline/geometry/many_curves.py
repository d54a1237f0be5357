"""Inflections and curvature extrema of thousands of plane Bézier curves given as arrays of doubles.

The forms are computed in doubles with proved bounds (`exactspline.programs.doubles`), their zeros isolated where that
is certain (`exactspline.roots.doubles`), and uncertain ones are left to exact arithmetic: every answer is that of
`exactspline.analyse` on the curve with exactly these doubles for data. This module loads numpy.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from exactspline.errors import FormulaError, NumberError, ShapeError
from exactspline.exact import from_floats, mpq
from exactspline.geometry.analysis import Analysis
from exactspline.geometry.constructions import construction
from exactspline.geometry.kinds import Feature, FeatureKind
from exactspline.language.formula import Formula
from exactspline.language.kinds import PLANE
from exactspline.papers import find
from exactspline.programs.doubles import Floats, in_doubles
from exactspline.programs.program import Program, Signature, program_of
from exactspline.programs.wronskian import wronskian_of
from exactspline.roots.doubles import Flags, Integers, Isolated, Rows, isolated, narrowed, ordinates
from exactspline.splines.nurbs import Nurbs

#: How many curves are computed at once, so that their numbers fit into the cache.
CHUNK = 4096

#: The numbers of the kinds in an array.
KINDS = (FeatureKind.INFLECTION, FeatureKind.MAXIMUM, FeatureKind.MINIMUM)


class ManyFeatures(NamedTuple):
    """Features of many curves: the number of the curve, what it is (the value of a `FeatureKind`), and an interval of
    [0, 1] with its parameter; `exact` are the numbers of the curves that were left to exact arithmetic.

    In the order of the curves; for each curve first the points with κ = 0, then those with κ′ = 0, in the order of the
    parameter.
    """

    curve: Integers
    kind: NDArray[np.str_]
    low: Floats
    high: Floats
    exact: Integers


def features_of_many(points: ArrayLike, weights: ArrayLike | None = None) -> ManyFeatures:
    """Inflections and curvature extrema of plane Bézier curves of one degree.

    `points` are doubles of the shape (curves, degree + 1, 2), `weights` of the shape (curves, degree + 1).

    >>> found = features_of_many([[(0, 0), (1, 2), (2, -2), (3, 0.5)]] * 2)
    >>> found.curve.tolist(), found.kind.tolist(), found.exact.tolist()
    ([0, 0, 0, 1, 1, 1], ['inflection', 'minimum', 'maximum', 'inflection', 'minimum', 'maximum'], [])

    Raises `ShapeError` for arrays of another shape, `NumberError` for what is not finite, `WeightError` for a curve
    whose denominator has a zero.
    """
    parts = list(features_in_parts(points, weights))
    curve, kind, low, high, exact = (np.concatenate(column) for column in zip(*parts, strict=True))
    return ManyFeatures(curve, kind, low, high, exact)


def features_in_parts(
    points: ArrayLike, weights: ArrayLike | None = None, *, at_once: int = CHUNK
) -> Iterator[ManyFeatures]:
    """The same, a part of the curves at a time, so that partial results are available."""
    p, w = _checked(points, weights)
    for start in range(0, max(len(p), 1), at_once):
        some = slice(start, start + at_once)
        found = _features(p[some], None if w is None else w[some])
        yield found._replace(curve=found.curve + start, exact=found.exact + start)


def _checked(points: ArrayLike, weights: ArrayLike | None) -> tuple[Floats, Floats | None]:
    p = np.asarray(points, dtype=float)
    if p.ndim != 3 or p.shape[1] < 2 or p.shape[2] != 2:
        raise ShapeError(f"points of the shape {p.shape}", where="points", remedy="(curves, degree + 1, 2)")
    w = None if weights is None else np.asarray(weights, dtype=float)
    if w is not None and w.shape != p.shape[:2]:
        raise ShapeError(f"weights of the shape {w.shape}", where="weights", remedy=f"{p.shape[:2]}, one a point")
    for name, array in (("points", p), ("weights", w)):
        if array is not None and not np.isfinite(array).all():
            row = int(np.argwhere(~np.isfinite(array))[0][0])
            raise NumberError("is not a finite number", where=f"{name}[{row}]", remedy="write finite numbers")
    return p, w


class _Programs(NamedTuple):
    """The programs of one degree: κ, κ′ and ‖γ′‖² up to positive factors."""

    curvature: Program
    critical: Program
    speed: Program


@cache
def _programs(degree: int, rational: bool) -> _Programs:
    count = 3 if rational else 2
    signature = Signature(PLANE, 2, not rational, (degree,) * count, (0,) * count, unit_widths=True)

    def made(formula: Formula) -> Program:
        return program_of(formula, signature)

    inflections, critical = construction("zero_curvature"), construction("critical_curvature")
    if rational:
        first, second = (wronskian_of(find(each.wronskian_of)) for each in (inflections, critical))
        return _Programs(made(first), made(second), made(find("D1_squared")))
    return _Programs(made(inflections.formula("paper")), made(critical.formula("paper")), made(find("D1_squared")))


def _features(p: Floats, w: Floats | None) -> ManyFeatures:
    """The features of the curves of one part."""
    count, degree = len(p), p.shape[1] - 1
    programs = _programs(degree, w is not None)
    left = np.zeros(count, dtype=bool)
    found: list[tuple[Integers, NDArray[np.str_], Floats, Floats, Integers]] = []
    try:
        operands = _operands(p, w)
        if w is not None:
            left |= ~(w > 0).all(axis=1)
        curvature = _solved(programs.curvature, operands, left)
        critical = _solved(programs.critical, operands, left)
        _, rests = _solved(programs.speed, operands, left)
        left[rests.row] = True
    except FormulaError:
        left[:] = True
    else:
        for which, (rows, isolating) in enumerate((curvature, critical)):
            zeros = narrowed(rows, isolating.where(~left[isolating.row]))
            kinds = np.where(zeros.before > 0, *KINDS[1:]) if which else np.full(len(zeros.row), KINDS[0])
            found.append((zeros.row, kinds, zeros.low, zeros.high, np.full(len(zeros.row), which)))
    exact = np.flatnonzero(left)
    for i in exact:
        found.append(_exactly(int(i), p[i], None if w is None else w[i]))
    curve, kind, low, high, which_form = (np.concatenate(column) for column in zip(*found, strict=True))
    order = np.lexsort((low, which_form, curve))
    return ManyFeatures(curve[order], kind[order].astype(str), low[order], high[order], exact)


def _operands(p: Floats, w: Floats | None) -> list[Floats]:
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
    smaller: Floats = np.ldexp(a, -exponents)
    return smaller


def _solved(program: Program, operands: list[Floats], left: Flags) -> tuple[Rows, Isolated]:
    """The zeros of a form; curves on which they are uncertain are skipped."""
    (form,) = in_doubles(program, operands, roundings=2)
    rows = ordinates(form.values, form.errors)
    zeros, open_ = isolated(rows)
    left |= open_
    return rows, zeros


def _exactly(i: int, p: Floats, w: Floats | None) -> tuple[Integers, NDArray[np.str_], Floats, Floats, Integers]:
    """The features of one curve in exact arithmetic."""
    degree = len(p) - 1
    knots = [0] * (degree + 1) + [1] * (degree + 1)
    weights = None if w is None else from_floats(w.tolist())
    analysis = Analysis(Nurbs(degree, knots, from_floats(p.tolist()), weights))
    lists = analysis.inflections, analysis.curvature_extrema
    features = [(which, feature) for which, own in enumerate(lists) for feature in own]
    bounds = [_bounds(feature) for _, feature in features]
    return (
        np.full(len(features), i),
        np.array([str(feature.kind) for _, feature in features], dtype=str),
        np.array([low for low, _ in bounds], dtype=float),
        np.array([high for _, high in bounds], dtype=float),
        np.array([which for which, _ in features], dtype=int),
    )


def _bounds(feature: Feature) -> tuple[float, float]:
    """Doubles on both sides of a parameter, or itself."""
    low, high = feature.root.refine(15)
    a, b = float(low), float(high)
    return a if mpq(a) <= low else float(np.nextafter(a, -1)), b if mpq(b) >= high else float(np.nextafter(b, 2))
