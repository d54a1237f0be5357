"""Operations that all spline libraries offer: points, a knot inserted; and many curvatures. Ours are exact."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from exactspline.geometry.analysis.floats import floats
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from workshop.bench.inputs import curve
from workshop.bench.row import OURS, Options, Row, Timed, best, bounded, compared, installed, missing

SPLINES = "splines"
POINTS = 50
#: How many times the time of scipy points, points as doubles and a knot may take.
MOST = (15, 20, 10)
#: The number of curvatures.
MANY = 10_000
PEERS = ("scipy", "geomdl", "pynurbs")


def spline_rows(options: Options) -> Iterator[Row]:
    """Points on a rational cubic of ten segments, each time a new curve, and the insertion of one knot."""
    c = curve(3, 10)
    places = [Fraction(10 * i, POINTS) for i in range(POINTS)]
    exact, doubles = [mpq(t.numerator, t.denominator) for t in places], [*map(float, places)]

    def new() -> Nurbs:
        return Nurbs(c.degree, c.knots, c.control_points, c.weights)

    new().floats(doubles)  # what is imported for it is not its time
    ours: dict[str, Timed] = {
        f"{POINTS} points of a rational cubic, 10 segments": (
            lambda made: made.points_at(exact),  # type: ignore[attr-defined]  # a curve
            new,
        ),
        f"{POINTS} points of a rational cubic, 10 segments, as doubles": (
            lambda made: made.floats(doubles),  # type: ignore[attr-defined]  # a curve
            new,
        ),
        "a knot inserted, rational cubic, 10 segments": (
            lambda made: made.insert_knot(mpq(1, 3)),  # type: ignore[attr-defined]  # a curve
            new,
        ),
    }
    for number, ((case, our_case), most) in enumerate(zip(ours.items(), MOST, strict=True)):
        timed, absent = {OURS: our_case}, []
        for who in PEERS:
            if not installed(who):
                absent.append(who)
            elif made := THEIRS[who](c, places)[number // 2]:
                timed[who] = made
        yield from compared(SPLINES, case, best(timed), {"scipy": Fraction(most)})
        yield from (missing(SPLINES, case, who) for who in absent)
    one, parameters = curve(3), [i / MANY for i in range(MANY + 1)]
    took = best({OURS: (lambda _: floats(one, parameters, of="curvature"), lambda: None)})[OURS] / 1000
    yield bounded(SPLINES, f"{MANY:,} curvatures of a rational cubic, correctly rounded", took, "s", Fraction(1, 2))


Pair = tuple[Timed | None, Timed | None]


def _homogeneous(c: Nurbs) -> list[list[float]]:
    return [[*(float(x * w) for x in p), float(w)] for p, w in zip(c.control_points, c.weights, strict=True)]


def _full_knots(c: Nurbs) -> list[Fraction]:
    return [Fraction(int(t.numerator), int(t.denominator)) for t in c.knots]


def _with_scipy(c: Nurbs, places: list[Fraction]) -> Pair:
    import numpy
    from scipy.interpolate import BSpline, insert

    knots, net, t = (
        numpy.array([*map(float, c.knots)]),
        numpy.array(_homogeneous(c)),
        numpy.array([*map(float, places)]),
    )
    made = BSpline(knots, net, c.degree)

    def points(_: object) -> object:
        homogeneous = made(t)
        return homogeneous[:, :-1] / homogeneous[:, -1:]

    columns = [numpy.concatenate([column, numpy.zeros(c.degree + 1)]) for column in net.T]
    return (points, lambda: None), (
        lambda _: [insert(1 / 3, (knots, column, c.degree)) for column in columns],
        lambda: None,
    )


def _with_geomdl(c: Nurbs, places: list[Fraction]) -> Pair:
    from geomdl import NURBS, operations

    def made() -> Any:
        curve = NURBS.Curve()
        curve.degree = c.degree
        curve.ctrlptsw = _homogeneous(c)
        curve.knotvector = [*map(float, c.knots)]
        return curve

    kept, t = made(), [float(x) / 10 for x in places]
    top = kept.knotvector[-1]
    return (lambda _: kept.evaluate_list([top * x for x in t]), lambda: None), (
        lambda each: operations.insert_knot(each, [top / 30], [1]),
        made,
    )


def _with_pynurbs(c: Nurbs, places: list[Fraction]) -> Pair:
    import numpy
    import pynurbs

    def made() -> Any:
        points = numpy.array([[Fraction(str(x)) for x in p] for p in c.control_points], dtype=object)
        curve = pynurbs.Curve(pynurbs.KnotVector(_full_knots(c)), list(points))
        curve.weights = [Fraction(str(w)) for w in c.weights]
        return curve

    kept = made()
    return (lambda _: kept.eval(places), lambda: None), (lambda each: each.knot_insert([Fraction(1, 3)]), made)


THEIRS: dict[str, Callable[[Nurbs, list[Fraction]], Pair]] = {
    "scipy": _with_scipy,
    "geomdl": _with_geomdl,
    "pynurbs": _with_pynurbs,
}
