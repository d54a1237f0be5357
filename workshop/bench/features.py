"""Inflections and curvature extrema of 400 random plane curves, ours proved, and by Open CASCADE; many curves given as
arrays; many segments and their memory; a trimmed bisector.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from exactspline.batch.corpus import Family
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.splines.nurbs import Nurbs
from workshop.bench import alone
from workshop.bench.inputs import MIXED
from workshop.bench.row import OURS, Options, Row, Timed, best, bounded, compared, installed, missing

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

FEATURES = "features"
OCC = "Open CASCADE"
FOUND = "inflections and extrema of a curve, mean of 400"
MADE = "construction of a curve from exact numbers, mean of 400"
FROM_DOUBLES = "construction of a curve from doubles, mean of 400"
FROM_TEXT = "construction of a curve from decimals as text, mean of 400"
BOTH = "construction of a curve and its inflections and extrema, mean of 400"
PLACED = "inflections and extrema of a curve, their kinds and parameters as doubles, mean of 400"
FIRST = "first use: how much longer 400 curves take in a new process than later"
TOGETHER = "inflections and extrema of a curve of the same 400, given at once"
#: The limit on the processor time of a case in a process of its own, in seconds.
LONG = 60
#: The number of cubic segments of the batch; 10⁵ in a full run.
SOME, ALL = 5_000, 100_000
#: Degree, knots, control points and weights (None for all 1) in doubles.
Floats = tuple[int, list[float], list[tuple[float, ...]], list[float] | None]


def feature_rows(options: Options) -> Iterator[Row]:
    """The rows of this section."""
    curves = [MIXED.curve(i) for i in range(MIXED.count)]
    yield from _one_by_one(curves)
    yield from _together(curves)
    for kind in ("", "rational "):
        yield from _batch(ALL if options.full else SOME, kind)


def _together(curves: Sequence[Nurbs]) -> Iterator[Row]:
    """The same curves all together, through the filter."""
    if not installed("numpy"):
        yield missing(FEATURES, TOGETHER, "numpy")
        return
    from exactspline.geometry.analysis.many_curves import features_of_curves

    features = features_of_curves(_again(curves))
    timed: dict[str, Timed] = {OURS: (features_of_curves, lambda: _again(curves))}  # type: ignore[dict-item]  # as made
    took = best(timed)[OURS] / len(curves)
    note = f"{_kinds(features.kind)}; {len(features.exact)} curves decided by exact arithmetic"
    yield Row(FEATURES, TOGETHER, OURS, took, "ms", note=note)


def _kinds(kind: NDArray[numpy.str_]) -> str:
    bends = int((kind == str(FeatureKind.INFLECTION)).sum())
    return f"{bends} inflections, {len(kind) - bends} extrema"


def _batch(count: int, kind: str) -> Iterator[Row]:
    """Cubic segments given as arrays, through the filter; Open CASCADE gets them one by one."""
    case = f"inflections and extrema of a {kind}cubic segment of a batch, {count} curves"
    if not installed("numpy"):
        yield missing(FEATURES, case, "numpy")
        return
    import numpy

    from exactspline.geometry.analysis.many_curves import features_of_curves

    words = f"degree=3 count={count} seed=2 rational={'yes' if kind else 'no'}"
    data = [_floats(c) for c in map(Family.parsed(words).curve, range(count))]

    def arrays() -> tuple[NDArray[numpy.float64], NDArray[numpy.float64] | None]:
        points = numpy.array([each[2] for each in data])
        return points, numpy.array([each[3] or [1] * 4 for each in data], dtype=float) if kind else None

    given = arrays()
    features = features_of_curves(*given)
    note = f"{_kinds(features.kind)}; {len(features.exact)} curves decided by exact arithmetic"
    timed: dict[str, Timed] = {OURS: (lambda _: features_of_curves(*given), lambda: None)}
    making: dict[str, Timed] = {OURS: (lambda _: arrays(), lambda: None)}
    theirs = _compared_with_occ(data, timed, making)
    took = {who: value / count for who, value in best(timed).items()}
    yield bounded(FEATURES, case, took[OURS], "ms", Fraction(1, 20), note)
    yield from _theirs(case, took, theirs, {OCC: Fraction(1)})
    making_took = {who: value / count for who, value in best(making).items()}
    yield from compared(FEATURES, f"construction of a {kind}cubic segment, {count} curves", making_took, {})


def _again(curves: Sequence[Nurbs]) -> list[Nurbs]:
    return [Nurbs(c.degree, c.knots, c.control_points, c.weights) for c in curves]


def _solved(curves: Any) -> tuple[int, int]:
    return sum(len(analyse(c).inflections) for c in curves), sum(len(analyse(c).curvature_extrema) for c in curves)


def _placed(curves: Any) -> list[tuple[FeatureKind, float]]:
    return [
        (f.kind, float(f.root))
        for facts in map(analyse, curves)
        for f in (*facts.inflections, *facts.curvature_extrema)
    ]


def _one_by_one(curves: Sequence[Nurbs]) -> Iterator[Row]:
    """How many there are, as Open CASCADE is asked for the number and the kinds; with construction; with parameters;
    and in a new process.
    """
    count, data = len(curves), [_floats(c) for c in curves]
    first = alone.run("first use", count, LONG).seconds
    ours = _solved(_again(curves))
    timed: dict[str, Timed] = {OURS: (_solved, lambda: _again(curves))}
    making: dict[str, Timed] = {OURS: (lambda _: _again(curves), lambda: None)}
    theirs = _compared_with_occ(data, timed, making)
    both: dict[str, Timed] = {OURS: (lambda _: _solved(_again(curves)), lambda: None)}
    placed: dict[str, Timed] = {OURS: (_placed, timed[OURS][1])}
    written = [(n, [*map(str, t)], [[*map(str, p)] for p in d], [str(x) for x in w or []]) for n, t, d, w in data]
    given: dict[str, Timed] = {OURS: (lambda _: [Nurbs.from_floats(*each) for each in data], lambda: None)}
    texts: dict[str, Timed] = {OURS: (lambda _: [Nurbs(n, t, d, w or None) for n, t, d, w in written], lambda: None)}
    if theirs is not None:
        both[OCC] = lambda _: _solved_by_occ([_in_occ(*each) for each in data]), lambda: None
        placed[OCC] = _placed_by_occ, timed[OCC][1]
        given[OCC] = making[OCC]
    took = {who: value / count for who, value in best(timed).items()}
    note = f"{ours[0]} inflections, {ours[1]} extrema"
    yield bounded(FEATURES, FOUND, took[OURS], "ms", Fraction(6, 10), note)
    yield from _theirs(FOUND, took, theirs, {OCC: Fraction(1)})
    for case, each, limits in (
        (BOTH, both, {OCC: Fraction(1)}),
        (PLACED, placed, {OCC: Fraction(2)}),
        (MADE, making, {}),
        (FROM_DOUBLES, given, {}),
        (FROM_TEXT, texts, {}),
    ):
        yield from compared(FEATURES, case, {who: value / count for who, value in best(each).items()}, limits)
    yield bounded(FEATURES, FIRST, None if first is None else 1000 * first - count * took[OURS], "ms", 20)


def _compared_with_occ(
    data: Sequence[Floats], timed: dict[str, Timed], making: dict[str, Timed]
) -> tuple[int, int] | None:
    """Open CASCADE on the same curves, where it is installed, and what it finds."""
    if not installed(OCC):
        return None
    timed[OCC] = _solved_by_occ, lambda: [_in_occ(*each) for each in data]
    making[OCC] = lambda _: [_in_occ(*each) for each in data], lambda: None
    return _solved_by_occ([_in_occ(*each) for each in data])


def _theirs(
    case: str, took: dict[str, float], theirs: tuple[int, int] | None, limits: dict[str, Fraction]
) -> Iterator[Row]:
    if theirs is None:
        yield missing(FEATURES, case, OCC)
        return
    for row in list(compared(FEATURES, case, took, limits))[1:]:
        yield replace(row, note=f"{theirs[0]} inflections, {theirs[1]} extrema")


def _floats(c: Nurbs) -> Floats:
    weights = None if c.polynomial else [float(w) for w in c.weights]
    return c.degree, [*map(float, c.knots)], [tuple(map(float, p)) for p in c.control_points], weights


def _in_occ(degree: int, knots: list[float], points: list[tuple[float, ...]], weights: list[float] | None) -> Any:
    from OCP.collections import Array1_double, Array1_gp_Pnt2d, Array1_int
    from OCP.Geom2d import Geom2d_BSplineCurve
    from OCP.gp import gp_Pnt2d

    from workshop.grade.adapters.open_cascade import array

    distinct = list(dict.fromkeys(knots))
    poles = array(Array1_gp_Pnt2d, [gp_Pnt2d(*p) for p in points])
    knot_data = array(Array1_double, distinct), array(Array1_int, [knots.count(t) for t in distinct]), degree
    if weights is None:
        return Geom2d_BSplineCurve(poles, *knot_data)
    return Geom2d_BSplineCurve(poles, array(Array1_double, weights), *knot_data)


def _solved_by_occ(curves: Any) -> tuple[int, int]:
    from OCP.GeomLProp import GeomLProp_CurAndInf2d
    from OCP.LProp import LProp_CIType

    bends = extrema = 0
    for c in curves:
        solver = GeomLProp_CurAndInf2d()
        solver.Perform(c)
        for i in range(1, solver.NbPoints() + 1):
            if solver.Type(i) == LProp_CIType.LProp_Inflection:
                bends += 1
            else:
                extrema += 1
    return bends, extrema


def _placed_by_occ(curves: Any) -> list[tuple[object, float]]:
    from OCP.GeomLProp import GeomLProp_CurAndInf2d

    found = []
    for c in curves:
        solver = GeomLProp_CurAndInf2d()
        solver.Perform(c)
        found += [(solver.Type(i), solver.Parameter(i)) for i in range(1, solver.NbPoints() + 1)]
    return found


LINEAR = "linear"
#: The number of segments of the spline whose inspection is written.
WRITTEN = 1_000
#: What is kept of a segment, and how much of it in kB.
KEPT = (
    ("read", "a cubic spline of {count} segments, read: memory per segment", Fraction(3, 2)),
    ("analyse", "a cubic spline of {count} segments, its inflections and extrema listed: memory per segment", 5),
    ("inspect", "a cubic spline of {count} segments, all questions asked: memory per segment", 5),
)


def linear_rows(options: Options) -> Iterator[Row]:
    """Cases whose time must not grow faster than the number of segments, each in a separate process."""
    for count in (100, 1_000, 10_000, 100_000):
        took = alone.run("inspect", count, options.limit)
        each = None if took.seconds is None else 1000 * took.seconds / count
        case = f"inspection of a cubic spline of {count} segments, a segment"
        yield bounded(LINEAR, case, each, "ms", Fraction(3, 10), took.note)
    took = alone.run("write", WRITTEN, options.limit)
    for value, factor, unit, limit in ((took.seconds, 1000, "ms", Fraction(6, 10)), (took.megabytes, 1024, "kB", 3)):
        each = None if value is None else factor * value / WRITTEN
        case = f"inspection of a cubic spline of {WRITTEN} segments written as data, {unit} a segment"
        yield bounded(LINEAR, case, each, unit, limit, took.note)
    count = 100_000 if options.full else 10_000
    for name, memory_case, kilobytes in KEPT:
        took = alone.run(name, count, 10 * options.limit)
        kept = None if took.megabytes is None else 1024 * took.megabytes / count
        yield bounded(LINEAR, memory_case.format(count=count), kept, "kB", kilobytes, took.note)
    for name, case, most in (
        ("trim", "bisector of a point and a 500-segment plane cubic, trimmed", 10),
        ("trim rational", "bisector of a point and a rational curve of degree 5, 10 segments, trimmed", 5),
    ):
        took = alone.run(name, 0, options.limit)
        yield bounded(LINEAR, case, took.seconds, "s", most, took.note)
