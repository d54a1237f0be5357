"""Exact answers to the questions that libraries are asked, each with the data with which the independent checker
verifies it.

Answers are data: exact numbers as text, roots as certificates (see `exactspline.roots.zero_set`), so that they can
be stored in a file and checked again by `workshop.grade.recheck`, which shares no arithmetic with this.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from operator import add

from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.curves.bounds import coordinate_range, slope
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.values import curvature, point_at, torsion, unit
from exactspline.geometry.measures.integrals import length
from exactspline.geometry.pairs.intersections import intersections
from exactspline.geometry.pairs.nearest import nearest
from exactspline.language.vector import Vector, triple
from exactspline.numbers.exact import double, from_float, mpq, text
from exactspline.reals.real import Real, square_root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.data import Answer, ExactCurve

#: Digits after the decimal point of an interval, and more of small numbers, for these significant ones.
DIGITS, MOST, SIGNIFICANT = 30, 480, 20


def truth(case: Case, question: str) -> Answer | None:
    """The exact answer to a question about a case; None where the question does not apply.

    >>> from exactspline.testing import all_cases
    >>> case = next(c for c in all_cases() if c.key == "named geomdl-135")
    >>> truth(case, "value")
    {'numbers': [['1', '1'], ['1/2', '1/2'], ['0', '0']]}
    """
    try:
        return _ANSWERS[question](case)
    except ExactSplineError:
        return None


def _numbers(values: list[Real]) -> Answer:
    return {"numbers": [_interval(value) for value in values]}


def _interval(value: Real) -> list[str]:
    digits = DIGITS
    if value.exact is not None:
        return [text(value.exact)] * 2
    while True:
        low, high = value.enclosure(digits)
        # of a tiny number as many significant digits, as far as it is known not to be 0
        if digits >= MOST or (high - low) * 10**SIGNIFICANT <= max(abs(low), abs(high)):
            return [text(low), text(high)]
        digits *= 2


def _derivative(order: int) -> Callable[[Case], Answer]:
    return lambda case: _numbers(list(point_at(case.curve, case.parameter, order)))


def _tangent(case: Case) -> Answer:
    return _numbers(unit(facts_of(case.curve).velocity, case.parameter))


def _curvature(case: Case) -> Answer:
    value = curvature(case.curve, case.parameter)
    low, high = sorted(abs(t) for t in value.enclosure(DIGITS))
    return {"numbers": [[text(low), text(high)]]}


def _torsion(case: Case) -> Answer:
    return _numbers([torsion(case.curve, case.parameter)])


def rows(curve: Nurbs, *, weighted: bool) -> list[list[mpq]]:
    """Control points, with `weighted` followed by their weights divided by the first weight; this is used for rational
    curves and all their parts, since a part of a rational curve may have equal weights.
    """
    if not weighted:
        return [list(point) for point in curve.control_points]
    return [[*p, w / curve.weights[0]] for p, w in zip(curve.control_points, curve.weights, strict=True)]


def _curves(case: Case, *curves: Nurbs) -> Answer:
    weighted = not case.curve.polynomial
    parts: list[ExactCurve] = [
        {
            "degree": c.degree,
            "knots": [text(t) for t in c.knots],
            "rows": [[text(x) for x in row] for row in rows(c, weighted=weighted)],
        }
        for c in curves
    ]
    return {"curves": parts}


def inserted(case: Case) -> Nurbs | None:
    """The curve with one more knot, where all its numbers are doubles: the question is to remove the knot from it."""
    if case.parameter in case.curve.breakpoints:
        return None
    finer = case.curve.insert_knot(case.parameter)
    numbers = [*finer.weights, *(x for point in finer.control_points for x in point)]
    return finer if all(from_float(double(x)) == x for x in numbers) else None


def _remove(case: Case) -> Answer | None:
    return None if inserted(case) is None else _curves(case, case.curve)


def _box(case: Case) -> Answer:
    ranges = [coordinate_range(case.curve, axis) for axis in range(case.curve.dimension)]
    numbers = _numbers([end for ends in ranges for end in ends])
    return numbers | {"certificates": [_certificate(slope(case.curve, i)) for i in range(case.curve.dimension)]}


def _certificate(form: BSpline, bits: int = 20) -> dict[str, object]:
    """The certificate of a form's zeros, each isolated in a narrow interval."""
    zero_set = zeros(form)
    for root in zero_set:
        root.refine(bits)
    return zero_set.certificate()


def _places(*forms: BSpline) -> Answer | None:
    """Zeros of several forms; None where one of them vanishes on a whole segment: then the question is not asked."""
    certificates = [_certificate(form) for form in forms]
    return None if any(c["intervals"] for c in certificates) else {"certificates": certificates}


def bend(curve: Nurbs) -> BSpline:
    """``w³ [γ′ γ″]`` of a plane curve."""
    p, w = curve.p, curve.w
    if curve.polynomial:
        flat: BSpline = p[0].d() * p[1].d(2) - p[1].d() * p[0].d(2)
        return flat
    a, b, c = (tuple(f.d(order) for f in (*p, w)) for order in range(3))
    form: BSpline = triple(Vector(*a), Vector(*b), Vector(*c))
    return form


def _turns(case: Case) -> Answer | None:
    return _places(*[slope(case.curve, axis) for axis in range(case.curve.dimension)])


def _roots(case: Case) -> Answer | None:
    return _places(case.curve.p[1])


def _inflections(case: Case) -> Answer | None:
    return _places(bend(case.curve)) if case.curve.dimension == 2 else None


def _extrema(case: Case) -> Answer | None:
    if case.curve.dimension != 2 or not case.curve.polynomial or case.curve.segments > 1:
        return None
    x, y = (tuple(f.d(k) for k in range(4)) for f in case.curve.p)
    speed, along = x[1] * x[1] + y[1] * y[1], x[1] * x[2] + y[1] * y[2]
    turning, jerk = x[1] * y[2] - y[1] * x[2], x[1] * y[3] - y[1] * x[3]
    return _places(jerk * speed - (turning * along).scaled(3))


def _length(case: Case) -> Answer:
    return _numbers([length(case.curve)])


def _area(case: Case) -> Answer | None:
    c = case.curve
    if c.dimension != 2 or not c.polynomial or not c.closed or c.segments < 3:
        return None
    return _numbers([analyse(c).area])


def _nearest(case: Case) -> Answer:
    """The least distance, and the zeros of the derivative of its square."""
    c, found = case.curve, nearest(case.curve, case.point)
    chords = [x - c.w.scaled(d) for x, d in zip(c.p, case.point, strict=True)]
    top = reduce(add, [x * x for x in chords])
    slope = top.d() if c.polynomial else top.d() * c.w - (top * c.w.d()).scaled(2)
    distance = _interval(found[0].distance) if found.points else _interval(square_root(_squared(c, case.point)))
    return {"numbers": [distance], "certificates": [_certificate(slope, 50)]}


def _squared(curve: Nurbs, point: Sequence[mpq]) -> Real:
    """The squared distance of the start of a curve: of one all of whose points are equally near."""
    start = curve(curve.domain.low)
    return Real(sum(((x - y) ** 2 for x, y in zip(start, point, strict=True)), start=mpq(0)))


def _distance(case: Case) -> Answer | None:
    """The least distance from the partner, certified by a pair of parameters at it."""
    found = CurvePair(case.curve, case.partner).distance
    if found.undecided:
        return None
    pair = [_interval(t) for t in (found.pairs[0].first, found.pairs[0].second)]
    return _numbers([found.value]) | {"certificates": [{"pair": pair}]}


def _meetings(case: Case) -> Answer | None:
    found = intersections(case.curve, case.partner)
    if found.undecided or found.everywhere:
        return None
    numbers = _numbers([t for pair in found for t in (pair.first, pair.second)])
    return numbers | {"certificates": [found.certificate()]}


_ANSWERS: dict[str, Callable[[Case], Answer | None]] = {
    "value": _derivative(0),
    "first": _derivative(1),
    "second": _derivative(2),
    "tangent": _tangent,
    "curvature": _curvature,
    "torsion": lambda case: _torsion(case) if case.curve.dimension == 3 else None,
    "insert": lambda case: _curves(case, case.curve.insert_knot(case.parameter)),
    "remove": _remove,
    "elevate": lambda case: _curves(case, case.curve.elevate_degree()),
    "split": lambda case: _curves(case, *case.curve.split(case.parameter)),
    "box": _box,
    "turns": _turns,
    "roots": _roots,
    "inflections": _inflections,
    "extrema": _extrema,
    "length": _length,
    "area": _area,
    "nearest": _nearest,
    "distance": _distance,
    "meetings": _meetings,
}
