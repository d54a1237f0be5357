"""What is asked for most: a length to 15 digits, the nearest point of a bicubic patch, how far the quadratics of cu2qu
are from a cubic. Others compute in doubles without a bound of the error; what they miss is in the remark.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product
from math import hypot, sqrt
from random import Random
from typing import Any

from exactspline.geometry.pairs.deviation import deviation
from exactspline.numbers.exact import from_float
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from workshop.bench.row import OURS, Options, Row, Timed, best, compared, installed, missing

MEASURES = "measures"
OCC = "Open CASCADE"
#: How many curves, patches and pairs are measured.
CURVES, PATCHES, PAIRS = 40, 40, 10
#: Points of a curve that others sample, where each is projected and where they are compared with others; and those of
#: a patch in each direction, from the best of which the search begins.
PROJECTED, SAMPLED, STARTS = 1_000, 10_000, 9
#: How many times the time of Open CASCADE a length, a nearest point and a deviation may take.
MOST = (25, 25, 10)
Points = list[tuple[float, ...]]
#: What prepares an input and returns what is timed.
Way = Callable[[Any], Callable[[], float]]


def measure_rows(options: Options) -> Iterator[Row]:
    """The rows of this section."""
    random = Random(1)
    cubics: list[Any] = [[(random.uniform(0, 1000), random.uniform(0, 1000)) for _ in range(4)] for _ in range(CURVES)]
    grid = [*product(range(4), repeat=2)]
    patches: list[Any] = [
        ([(3 * i + random.random(), 3 * j + random.random(), random.uniform(-3, 3)) for i, j in grid],
         tuple(random.uniform(-2, 11) for _ in range(3)))
        for _ in range(PATCHES)
    ]  # fmt: skip
    pairs: list[Any] = [(cubic, _quadratics(cubic)) for cubic in cubics[:PAIRS]] if installed("fontTools") else []
    cases: list[tuple[str, Sequence[Any], dict[str, Way]]] = [
        (f"length of a plane cubic, mean of {CURVES}", cubics, LENGTHS),
        (f"nearest point of a bicubic patch, mean of {PATCHES}", patches, NEAREST),
        (f"how far a cubic and its quadratics by cu2qu are apart, mean of {PAIRS}", pairs, APART),
    ]
    for (case, data, ways), most in zip(cases, MOST, strict=True):
        yield from _compared(case, data, ways, Fraction(most))


def _compared(case: str, data: Sequence[Any], ways: dict[str, Way], most: Fraction) -> Iterator[Row]:
    """Each way prepares an input and returns what is timed, a function without arguments."""
    here = {who: way for who, way in ways.items() if who == OURS or installed(who)}
    timed: dict[str, Timed] = {
        who: (_each, lambda way=way: [way(one) for one in data])  # type: ignore[misc]  # the way of this turn
        for who, way in here.items()
    }
    exact = [way() for way in map(ways[OURS], data)]
    took = {who: value / max(len(data), 1) for who, value in best(timed).items()}
    for row in compared(MEASURES, case, took, {OCC: most}):
        values = [way() for way in map(here[row.peer], data)]
        errors = [abs(x - y) / y for x, y in zip(values, exact, strict=True)]
        note = f"largest relative error {max(errors):.0e}" if row.peer != OURS and errors else ""
        yield replace(row, note=note)
    yield from (missing(MEASURES, case, who) for who in ways if who not in here)


def _each(prepared: Any) -> None:
    for call in prepared:
        call()


# ---- the inputs


def _quadratics(cubic: Points) -> list[Points]:
    """The pieces that cu2qu makes, within 1."""
    from fontTools.cu2qu import curve_to_quadratic

    points = curve_to_quadratic(cubic, 1.0)
    joints = [tuple((x + y) / 2 for x, y in zip(p, q, strict=True)) for p, q in pairwise(points[1:-1])]
    ends = [points[0], *joints, points[-1]]
    return [[a, b, c] for a, b, c in zip(ends, points[1:-1], ends[1:], strict=False)]


def _curve(pieces: Sequence[Points]) -> Nurbs:
    n, count = len(pieces[0]) - 1, len(pieces)
    points = [pieces[0][0], *(p for piece in pieces for p in piece[1:])]
    knots = [0, *(t for t in range(count + 1) for _ in range(n)), count]
    return Nurbs(n, knots, [[from_float(x) for x in p] for p in points])


# ---- ours


def _our_length(cubic: Points) -> Callable[[], float]:
    curve: Any = _curve([cubic])
    return lambda: float(curve.length)


def _our_nearest(given: tuple[Points, tuple[float, ...]]) -> Callable[[], float]:
    points, point = ([[from_float(x) for x in p] for p in own] for own in (given[0], [given[1]]))
    rows, knots = [points[4 * i : 4 * i + 4] for i in range(4)], [0] * 4 + [1] * 4
    surface: Any = NurbsSurface((3, 3), knots, knots, rows)
    return lambda: float(surface.nearest(point[0]).distance)


def _our_deviation(pair: tuple[Points, list[Points]]) -> Callable[[], float]:
    curves = _curve([pair[0]]), _curve(pair[1])
    return lambda: max(float(found.values["low"]) for found in deviation(*curves))


# ---- Open CASCADE


def _occ_curve(points: Points) -> Any:
    from OCP.collections import Array1_gp_Pnt
    from OCP.Geom import Geom_BezierCurve
    from OCP.gp import gp_Pnt

    from workshop.grade.adapters.open_cascade import array

    return Geom_BezierCurve(array(Array1_gp_Pnt, [gp_Pnt(*p, 0.0) for p in points]))


def _occ_length(cubic: Points) -> Callable[[], float]:
    from OCP.GCPnts import GCPnts_AbscissaPoint
    from OCP.GeomAdaptor import GeomAdaptor_Curve

    adaptor = GeomAdaptor_Curve(_occ_curve(cubic))
    return lambda: float(GCPnts_AbscissaPoint.Length_s(adaptor, 1e-12))


def _occ_nearest(given: tuple[Points, tuple[float, ...]]) -> Callable[[], float]:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeVertex
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.collections import Array2_gp_Pnt
    from OCP.Geom import Geom_BezierSurface
    from OCP.gp import gp_Pnt

    net = Array2_gp_Pnt(1, 4, 1, 4)
    for (i, j), p in zip(product(range(1, 5), repeat=2), given[0], strict=True):
        net.SetValue(i, j, gp_Pnt(*p))
    face = BRepBuilderAPI_MakeFace(Geom_BezierSurface(net), 1e-7).Face()
    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*given[1])).Vertex()
    return lambda: float(BRepExtrema_DistShapeShape(vertex, face).Value())


def _occ_apart(pair: tuple[Points, list[Points]]) -> Callable[[], float]:
    from OCP.GeomAPI import GeomAPI_ProjectPointOnCurve

    one, other = [_occ_curve(pair[0])], [_occ_curve(piece) for piece in pair[1]]

    def farthest(curves: Sequence[Any], others: Sequence[Any]) -> float:
        count = PROJECTED // len(curves)
        points = [curve.Value(k / count) for curve in curves for k in range(count + 1)]
        return max(min(_occ_distance(GeomAPI_ProjectPointOnCurve, p, curve) for curve in others) for p in points)

    return lambda: max(farthest(one, other), farthest(other, one))


def _occ_distance(project: Callable[[Any, Any], Any], point: Any, curve: Any) -> float:
    found = project(point, curve)
    ends = [float(point.Distance(curve.Value(t))) for t in (0.0, 1.0)]
    return min([*ends, *([float(found.LowerDistance())] if found.NbPoints() else [])])


# ---- scipy


def _scipy_length(cubic: Points) -> Callable[[], float]:
    import numpy
    from scipy.integrate import quad
    from scipy.interpolate import BSpline

    velocity = BSpline(numpy.array([0.0] * 4 + [1.0] * 4), numpy.array(cubic), 3).derivative()
    return lambda: float(quad(lambda t: hypot(*velocity(t)), 0, 1, epsabs=0, epsrel=1e-13, limit=200)[0])


def _scipy_nearest(given: tuple[Points, tuple[float, ...]]) -> Callable[[], float]:
    import numpy
    from scipy.optimize import minimize

    net, point = numpy.array(given[0]).reshape(4, 4, 3), numpy.array(given[1])

    def squared(at: Any) -> float:
        s, t = (numpy.array([(1 - x) ** 3, 3 * x * (1 - x) ** 2, 3 * x * x * (1 - x), x**3]) for x in at)
        chord = numpy.einsum("i,j,ijk->k", s, t, net) - point
        return float(chord @ chord)

    def found() -> float:
        steps = [k / (STARTS - 1) for k in range(STARTS)]
        start = min(product(steps, repeat=2), key=squared)
        return sqrt(minimize(squared, start, method="L-BFGS-B", bounds=[(0, 1)] * 2).fun)

    return found


def _scipy_apart(pair: tuple[Points, list[Points]]) -> Callable[[], float]:
    import numpy
    from scipy.spatial import cKDTree

    def sampled(pieces: Sequence[Points]) -> Any:
        t = numpy.linspace(0, 1, SAMPLED // len(pieces))[:, None]
        return numpy.concatenate([_bezier(numpy.array(piece), t) for piece in pieces])

    def found() -> float:
        one, other = sampled([pair[0]]), sampled(pair[1])
        return float(max(cKDTree(b).query(a)[0].max() for a, b in ((one, other), (other, one))))

    return found


def _bezier(points: Any, t: Any) -> Any:
    while len(points) > 1:
        points = [(1 - t) * p + t * q for p, q in pairwise(points)]
    return points[0]


# ---- kurbopy


def _kurbo_curve(points: Points) -> Any:
    import kurbopy

    kind = kurbopy.CubicBez if len(points) == 4 else kurbopy.QuadBez
    return kind(*[kurbopy.Point(*p) for p in points])


def _kurbo_length(cubic: Points) -> Callable[[], float]:
    curve = _kurbo_curve(cubic)
    return lambda: float(curve.arclen(1e-12))


def _kurbo_apart(pair: tuple[Points, list[Points]]) -> Callable[[], float]:
    one, other = [_kurbo_curve(pair[0])], [_kurbo_curve(piece) for piece in pair[1]]

    def farthest(curves: Sequence[Any], others: Sequence[Any]) -> float:
        count = PROJECTED // len(curves)
        points = [curve.eval(k / count) for curve in curves for k in range(count + 1)]
        return sqrt(max(min(curve.nearest(p, 1e-9).get_distance_sq() for curve in others) for p in points))

    return lambda: max(farthest(one, other), farthest(other, one))


LENGTHS: dict[str, Way] = {OURS: _our_length, OCC: _occ_length, "scipy": _scipy_length, "kurbopy": _kurbo_length}
NEAREST: dict[str, Way] = {OURS: _our_nearest, OCC: _occ_nearest, "scipy": _scipy_nearest}
APART: dict[str, Way] = {OURS: _our_deviation, OCC: _occ_apart, "scipy": _scipy_apart, "kurbopy": _kurbo_apart}
