"""The common points of two plane curves: of 300 pairs of cubics, new and kept ones, counted and as doubles; of two
splines of 200 segments. And the winding numbers of a closed spline. Open CASCADE computes in doubles and proves
nothing; how many points it finds is in the remark.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.pairs.intersections import intersections
from exactspline.numbers.exact import from_float
from exactspline.splines.nurbs import Nurbs
from workshop.bench.row import OURS, Options, Row, Timed, best, bounded, compared, installed, missing

PAIRS = "pairs"
OCC = "Open CASCADE"
#: How many cubics are intersected, each with the next one; the segments of two long splines; and those of a closed one,
#: with the points whose winding number is asked.
CUBICS, LONG, CLOSED, POINTS = 300, 200, 256, 50
#: What Open CASCADE takes for one point, in doubles.
CONFUSION = 1e-7
Floats = list[tuple[float, float]]


def pair_rows(options: Options) -> Iterator[Row]:
    """The rows of this section."""
    random = Random(1)
    cubics = [[(random.uniform(0, 10), random.uniform(0, 10)) for _ in range(4)] for _ in range(CUBICS + 1)]
    new = f"common points of two new cubics{{}}, mean of {CUBICS}"
    yield from _cubics(new, cubics, {"": Fraction(60, 1000), " as doubles": Fraction(150, 1000)}, kept=False)
    kept = f"common points of two cubics used before{{}}, mean of {CUBICS}"
    yield from _cubics(kept, cubics, {"": Fraction(6, 1000), " as doubles": Fraction(30, 1000)}, kept=True)
    paths: list[Floats] = [
        [(float(k), random.uniform(-3, 3)) for k in range(LONG + 3)],
        [(k + random.random(), random.uniform(-3, 3)) for k in range(LONG + 3)],
    ]
    long = f"common points of two cubic splines of {LONG} segments each, as doubles"
    yield from _compared(long, paths, _placed, 1)
    yield from _winding(random)


def _cubics(case: str, cubics: Sequence[Floats], most: dict[str, Fraction], *, kept: bool) -> Iterator[Row]:
    """Each cubic with the next one: how many points they have, and their parameters."""
    for words, limit in most.items():
        call = _placed if words else _found
        for row in _compared(case.format(words), cubics, call, CUBICS, kept=kept):
            if row.peer == OURS and row.value is not None:
                yield bounded(PAIRS, row.case, row.value, "ms", limit, row.note)
            else:
                yield row


def _compared(case: str, paths: Sequence[Floats], call: Any, count: int, *, kept: bool = False) -> Iterator[Row]:
    """Each curve with the next one; where they are `kept`, the same objects each time."""
    ours = [_curve(path) for path in paths]
    timed: dict[str, Timed] = {OURS: (call, (lambda: ours) if kept else lambda: [_curve(path) for path in paths])}
    found = {OURS: _found(ours)}
    if installed(OCC):
        theirs = [_in_occ(path) for path in paths]
        timed[OCC] = (_found_by_occ, (lambda: theirs) if kept else lambda: [_in_occ(path) for path in paths])
        found[OCC] = _found_by_occ(theirs)
    took = {who: value / count for who, value in best(timed).items()}
    for row in compared(PAIRS, case, took, {}):
        yield replace(row, note=f"{found[row.peer]} points")
    if OCC not in took:
        yield missing(PAIRS, case, OCC)


def _winding(random: Random) -> Iterator[Row]:
    """How often a closed spline that was used before goes around a point."""
    ends = [(random.uniform(-9, 9), random.uniform(-9, 9)) for _ in range(CLOSED + 2)]
    loop = analyse(_curve([*ends, ends[0]]))
    places = [[from_float(random.uniform(-9, 9)) for _ in range(2)] for _ in range(POINTS)]
    timed: dict[str, Timed] = {OURS: (lambda _: [loop.winding_number(place) for place in places], lambda: None)}
    case = f"winding number of a closed cubic spline of {CLOSED} segments, mean of {POINTS} points"
    yield bounded(PAIRS, case, best(timed)[OURS] / POINTS, "ms", Fraction(5, 100))


def _curve(path: Floats) -> Nurbs:
    segments = len(path) - 3
    knots = [0] * 3 + list(range(segments + 1)) + [segments] * 3
    return Nurbs(3, knots, [[from_float(x) for x in p] for p in path])


def _found(curves: Any) -> int:
    return sum(len(intersections(a, b)) for a, b in pairwise(curves))


def _placed(curves: Any) -> list[tuple[float, float]]:
    return [(float(m.first), float(m.second)) for a, b in pairwise(curves) for m in intersections(a, b)]


def _in_occ(path: Floats) -> Any:
    from OCP.collections import Array1_double, Array1_gp_Pnt2d, Array1_int
    from OCP.Geom2d import Geom2d_BSplineCurve
    from OCP.Geom2dAdaptor import Geom2dAdaptor_Curve
    from OCP.gp import gp_Pnt2d

    from workshop.grade.adapters.open_cascade import array

    segments = len(path) - 3
    poles = array(Array1_gp_Pnt2d, [gp_Pnt2d(*p) for p in path])
    knots = array(Array1_double, [float(k) for k in range(segments + 1)])
    times = array(Array1_int, [4, *[1] * (segments - 1), 4])
    return Geom2dAdaptor_Curve(Geom2d_BSplineCurve(poles, knots, times, 3))


def _found_by_occ(curves: Any) -> int:
    from OCP.Geom2dInt import Geom2dInt_GInter

    return sum(Geom2dInt_GInter(a, b, CONFUSION, CONFUSION).NbPoints() for a, b in pairwise(curves))
