"""Inflections and extrema of the curvature of 400 random plane curves, ours proved, and by Open CASCADE; many curves
given as arrays; many segments; a bisector trimmed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from exactspline.batch.bench import alone
from exactspline.batch.bench.inputs import MIXED
from exactspline.batch.bench.row import OURS, Options, Row, best, bounded, compared, installed, missing
from exactspline.batch.families import Family
from exactspline.geometry.features import curvature_extrema, inflections
from exactspline.splines.nurbs import Nurbs

FEATURES = "features"
OCC = "Open CASCADE"
FOUND = "inflections and extrema of a curve, mean of 400"
MADE = "construction of a curve, mean of 400"
BATCH = "inflections and extrema of a cubic segment of a batch"
#: Cubic segments of the batch; the issue's 10⁵ where all is asked for.
SOME, ALL = 2_000, 100_000


def feature_rows(options: Options) -> Iterator[Row]:
    """All of it."""
    curves = [MIXED.curve(i) for i in range(MIXED.count)]
    yield from _of(FEATURES, curves, FOUND, MADE, Fraction(6, 10), None)
    count = ALL if options.full else SOME
    batch = Family.parsed(f"degree=3 count={count} seed=2")
    segments = [batch.curve(i) for i in range(count)]
    case = f"{BATCH}, {count} curves"
    yield from _of(FEATURES, segments, case, f"construction of a cubic segment, {count} curves", Fraction(1, 20), 1)


def _again(curves: Sequence[Nurbs]) -> list[Nurbs]:
    return [Nurbs(c.degree, c.knots, c.control_points, c.weights) for c in curves]


def _solved(curves: Any) -> tuple[int, int]:
    return sum(len(inflections(c)) for c in curves), sum(len(curvature_extrema(c)) for c in curves)


def _of(
    section: str, curves: Sequence[Nurbs], found: str, made: str, most: Fraction, ratio: int | None
) -> Iterator[Row]:
    count = len(curves)
    ours, theirs = _solved(_again(curves)), None
    timed = {OURS: (_solved, lambda: _again(curves))}
    making = {OURS: (lambda _: _again(curves), lambda: None)}
    if installed(OCC):
        data = [_floats(c) for c in curves]
        theirs = _solved_by_occ([_in_occ(*each) for each in data])
        timed[OCC] = _solved_by_occ, lambda: [_in_occ(*each) for each in data]
        making[OCC] = lambda _: [_in_occ(*each) for each in data], lambda: None
    took = {who: value / count for who, value in best(timed).items()}
    note = f"{ours[0]} inflections, {ours[1]} extrema"
    yield bounded(section, found, took[OURS], "ms", most, note)
    if theirs is not None:
        limits = {} if ratio is None else {OCC: Fraction(ratio)}
        rows = list(compared(section, found, took, limits))[1:]
        yield from (_noted(row, f"{theirs[0]} inflections, {theirs[1]} extrema") for row in rows)
    else:
        yield missing(section, found, OCC)
    yield from compared(section, made, {who: value / count for who, value in best(making).items()}, {})


def _noted(row: Row, note: str) -> Row:
    from dataclasses import replace

    return replace(row, note=note)


Floats = tuple[int, list[float], list[tuple[float, ...]], list[float] | None]


def _floats(c: Nurbs) -> Floats:
    weights = None if c.polynomial else [float(w) for w in c.weights]
    return c.degree, [*map(float, c.knots)], [tuple(map(float, p)) for p in c.control_points], weights


def _in_occ(degree: int, knots: list[float], points: list[tuple[float, ...]], weights: list[float] | None) -> Any:
    from OCP.collections import Array1_double, Array1_gp_Pnt2d, Array1_int
    from OCP.Geom2d import Geom2d_BSplineCurve
    from OCP.gp import gp_Pnt2d

    def array(kind: Any, values: Sequence[Any]) -> Any:
        made = kind(1, len(values))
        for i, value in enumerate(values, 1):
            made.SetValue(i, value)
        return made

    distinct = list(dict.fromkeys(knots))
    poles = array(Array1_gp_Pnt2d, [gp_Pnt2d(*p) for p in points])
    told = array(Array1_double, distinct), array(Array1_int, [knots.count(t) for t in distinct]), degree
    if weights is None:
        return Geom2d_BSplineCurve(poles, *told)
    return Geom2d_BSplineCurve(poles, array(Array1_double, weights), *told)


def _solved_by_occ(curves: Any) -> tuple[int, int]:
    from OCP.GeomLProp import GeomLProp_CurAndInf2d
    from OCP.LProp import LProp_CIType

    bends = extrema = 0
    for c in curves:
        found = GeomLProp_CurAndInf2d()
        found.Perform(c)
        for i in range(1, found.NbPoints() + 1):
            if found.Type(i) == LProp_CIType.LProp_Inflection:
                bends += 1
            else:
                extrema += 1
    return bends, extrema


LINEAR = "linear"


def linear_rows(options: Options) -> Iterator[Row]:
    """What must grow no faster than the number of segments, each case in a process of its own."""
    for count in (100, 1_000, 10_000, 100_000):
        took = alone.run("inspect", count, options.limit)
        each = None if took.seconds is None else 1000 * took.seconds / count
        told = f"inspection of a cubic spline of {count} segments, a segment"
        yield bounded(LINEAR, told, each, "ms", Fraction(3, 10), took.note)
    for name, told, most in (
        ("trim", "bisector of a point and a 500-segment plane cubic, trimmed", 10),
        ("trim rational", "bisector of a point and a rational curve of degree 5, 10 segments, trimmed", 5),
    ):
        took = alone.run(name, 0, options.limit)
        yield bounded(LINEAR, told, took.seconds, "s", most, took.note)


def memory_rows(options: Options) -> Iterator[Row]:
    """The resident size that a sweep needs at most must not grow with its corpus."""
    few, many = (alone.run("sweep", count, options.limit) for count in (500, 5_000))
    if few.megabytes is None or many.megabytes is None:
        yield Row("memory", "a sweep", OURS, None, "MB", note=few.note or many.note)
        return
    yield Row("memory", "largest size of a sweep of 500 cubics", OURS, few.megabytes, "MB")
    grown = many.megabytes - few.megabytes
    yield bounded("memory", "growth from 500 cubics to 5,000", grown, "MB", 5)
    for degree in (3, 6):
        took = alone.run("bisector", degree, options.limit)
        told = f"bisector surface of two rational curves of degree {degree}, 4 × 4 segments"
        yield Row("memory", told, OURS, took.megabytes, "MB", note=took.note)
