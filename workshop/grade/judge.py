"""Whether a library's answer agrees with the exact one, within the tolerance for answers in doubles (see
`questions`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import isfinite, ulp
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.numbers.exact import double, from_float, mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.data import Answer, Reply
from workshop.grade.questions import QUESTIONS, Judged
from workshop.grade.recheck import at
from workshop.grade.truth import bend, rows

RIGHT, OFF, MISSED, INVENTED, CRASHED = "right", "wrong value", "missed", "invented", "crashed"
#: A library reports that it has no answer, which is not wrong.
DECLINED = "declined"
#: No reply within the limit, which is not wrong either.
LATE = "timed out"
#: Missed or invented within what the library documents (`workshop.grade.tolerance`).
TOLERATED = "tolerated"
OUTCOMES = (RIGHT, OFF, MISSED, INVENTED, CRASHED, DECLINED, LATE, TOLERATED)
WRONG = (OFF, MISSED, INVENTED, CRASHED)
#: The distance within which parameters count as one place, as a fraction of the domain; and the fraction of its size
#: below which a form counts as zero.
PLACE, ZERO = mpq(1, 1 << 16), mpq(1, 1 << 32)
#: The largest distance of a parameter from a place where the form is below `ZERO`.
NEAR = mpq(1, 1 << 8)
#: A curve counts as straight when γ′ × γ″ is below this fraction of ‖γ′‖² divided by the length of the domain.
STRAIGHT = mpq(1, 1 << 20)
#: The error of a distance, as a fraction of the largest coordinate; and the least sine of two directions that cross.
APART = mpq(1, 1 << 20)
#: The factor of the tolerance for control points that require divisions.
DIVIDED = 1 << 16
#: The relative error allowed for a length.
LENGTH = mpq(1, 10**6)


@dataclass(frozen=True)
class Verdict:
    """The verdict on an answer: right, off by a number of ulps, or something else, explained in words where
    necessary; the places that were missed, and those that were invented.
    """

    outcome: str
    ulps: float = 0
    note: str = ""
    missed: tuple[mpq, ...] = ()
    invented: tuple[mpq, ...] = ()


@dataclass(frozen=True)
class _Size:
    """The scale of errors of a curve: the unit in the last place of its largest coordinate, and factors."""

    unit: mpq
    coordinate: mpq
    ratio: mpq
    speed: mpq
    times: int

    @classmethod
    def of(cls, curve: Nurbs) -> _Size:
        largest = max([abs(x) for p in curve.control_points for x in p], default=mpq(0)) or mpq(1)
        shortest = min(b - a for a, b in pairwise(curve.breakpoints))
        ratio = max(curve.weights) / min(curve.weights)
        return cls(from_float(ulp(double(largest))), largest, ratio, curve.degree / shortest, 16 * (curve.degree + 1))

    def allowed(self, order: int = 0) -> mpq:
        """The error allowed to a point or a derivative."""
        return self.times * self.unit * self.ratio ** (order + 1) * self.speed**order

    def ulps(self, error: mpq, order: int = 0) -> float:
        """An error in units in the last place of the largest expected value of such a number."""
        return double(error / (self.unit * self.speed**order))


def judged(case: Case, question: str, truth: Answer, reply: Reply) -> Verdict:
    """The verdict on a library's reply to a question about a case, given the exact answer."""
    if "declined" in reply:
        return Verdict(DECLINED, note=reply["declined"])
    if "late" in reply:
        return Verdict(LATE, note=reply["late"])
    if "raised" in reply:
        return Verdict(CRASHED, note=reply["raised"])
    try:
        return _JUDGES[QUESTIONS[question].judged](case, question, truth, reply["answer"])
    except (TypeError, ValueError, KeyError, IndexError, ExactSplineError) as error:
        return Verdict(OFF, note=f"not an answer of the requested kind: {error}")


def _middles(truth: Answer) -> list[mpq]:
    return [(mpq(low) + mpq(high)) / 2 for low, high in truth["numbers"]]


def _errors(exact: Sequence[mpq], given: Sequence[float]) -> list[mpq] | None:
    """The absolute errors, None where a number is NaN or missing."""
    values = [float(x) for x in given]
    if len(values) != len(exact):
        raise ValueError(f"{len(values)} numbers instead of {len(exact)}")
    if not all(map(isfinite, values)):
        return None
    return [abs(from_float(x) - y) for x, y in zip(values, exact, strict=True)]


_NAN = Verdict(OFF, float("inf"), "not a finite number")


def _vector(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    order, size = ("value", "first", "second").index(question), _Size.of(case.curve)
    errors = _errors(_middles(truth), answer)
    if errors is None:
        return _NAN
    worst = max(errors)
    return Verdict(RIGHT if worst <= size.allowed(order) else OFF, size.ulps(worst, order))


def _norms(case: Case) -> list[mpq]:
    """Bounds of ‖γ′‖, ‖γ″‖, ‖γ‴‖ at the parameter, by the largest component."""
    return [max(map(abs, case.curve.derivative(k, case.parameter))) for k in (1, 2, 3)]


def _quotient(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    """Tangent, curvature and torsion: quotients, to which the errors of the derivatives propagate."""
    size, (v, a, j), exact = _Size.of(case.curve), _norms(case), _middles(truth)
    errors = _errors(exact, answer)
    if errors is None:
        return _NAN
    dv, da, dj = (size.allowed(k) for k in (1, 2, 3))
    largest = max(map(abs, exact))
    if question == "tangent":
        allowed = 4 * dv / v
    elif question == "curvature":
        allowed = 4 * (dv * a + v * da) / v**3 + 8 * largest * dv / v
    else:
        x, y = (case.curve.derivative(k, case.parameter) for k in (1, 2))
        bend = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
        b = max([abs(x) for x in bend], default=mpq(0))
        triple = 6 * (dv * a * j + v * da * j + v * a * dj)
        allowed = triple / b**2 + 8 * largest * (dv * a + v * da) / b
    # for an exact zero, the unit of 1
    unit = from_float(ulp(double(largest or mpq(1))))
    worst = max(errors)
    return Verdict(RIGHT if worst <= allowed else OFF, double(worst / unit))


def _rows(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    size = _Size.of(case.curve)
    exact = [[mpq(x) for x in row] for part in truth["curves"] for row in part["rows"]]
    if isinstance(answer, dict):
        exact = _over_knots(case.curve.elevate_degree(), answer["knots"])
        if len(exact) != len(answer["rows"]):
            return _as_functions(case, size, answer)
        answer = answer["rows"]
    if len(answer) != len(exact):
        return Verdict(OFF, float("inf"), f"{len(answer)} control points instead of {len(exact)}")
    factor, worst, bad = 2 if question in ("insert", "split") else DIVIDED, mpq(0), False
    dimension = case.curve.dimension
    for right, point in zip(exact, answer, strict=True):
        errors = _errors(right, point)
        if errors is None:
            return _NAN
        # a weight is compared with the first, and counts as a coordinate of that size
        scaled = [
            *errors[:dimension],
            *(e * size.coordinate / max(right[dimension], mpq(1)) for e in errors[dimension:]),
        ]
        worst = max(worst, *scaled)
        bad = bad or max(scaled) > factor * size.allowed()
    return Verdict(OFF if bad else RIGHT, size.ulps(worst))


def _as_functions(case: Case, size: _Size, answer: Any) -> Verdict:
    """A curve over other knots compared with the exact one: its control points differ, but it may be the same
    function.
    """
    curve, rows = case.curve, answer["rows"]
    n = case.curve.dimension
    weights = None if curve.polynomial else [float(row[n]) for row in rows]
    made = Nurbs.from_floats(curve.degree + 1, answer["knots"], [list(map(float, row[:n])) for row in rows], weights)
    worst = mpq(0)
    for a, b in pairwise(curve.breakpoints):
        for k in range(2 * curve.degree + 3):
            t = a + (b - a) * mpq(k, 2 * curve.degree + 2)
            worst = max(worst, *(abs(x - y) for x, y in zip(made(t, "left"), curve(t, "left"), strict=True)))
    return Verdict(RIGHT if worst <= DIVIDED * size.allowed() else OFF, size.ulps(worst))


def _over_knots(curve: Nurbs, knots: Sequence[float]) -> list[list[mpq]]:
    """The control points over the knots that a library chose, where there are more of them: an equally valid
    representation.
    """
    values = [from_float(float(t)) for t in knots]
    for t in curve.breakpoints[1:-1]:
        more = values.count(t) - list(curve.knots).count(t)
        if more > 0 and values.count(t) <= curve.degree + 1:
            curve = curve.insert_knot(t, more)
    return rows(curve, weighted=not curve.polynomial)


def _box(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    size, exact = _Size.of(case.curve), _middles(truth)
    slack = from_float(float(answer[len(exact)])) if len(answer) > len(exact) else mpq(0)
    errors = _errors(exact, answer[: len(exact)])
    if errors is None:
        return _NAN
    worst = max(errors)
    return Verdict(RIGHT if worst <= DIVIDED * size.allowed() + slack else OFF, size.ulps(worst))


def _length(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    [exact] = _middles(truth)
    errors = _errors([exact], answer[:1])
    if errors is None:
        return _NAN
    slack = from_float(float(answer[1])) if len(answer) > 1 else mpq(0)
    unit = from_float(ulp(double(exact))) if exact else _Size.of(case.curve).unit
    allowed = max(LENGTH * exact, slack, (1 << 10) * _Size.of(case.curve).allowed())
    return Verdict(RIGHT if errors[0] <= allowed else OFF, double(errors[0] / unit))


def _area(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    size, errors = _Size.of(case.curve), _errors(_middles(truth), answer)
    if errors is None:
        return _NAN
    allowed = (1 << 10) * size.allowed() * size.coordinate
    return Verdict(RIGHT if errors[0] <= allowed else OFF, size.ulps(errors[0] / size.coordinate))


def _distance(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    [exact], size = _middles(truth), _Size.of(case.curve)
    errors = _errors([exact], answer[:1])
    if errors is None:
        return _NAN
    slack = from_float(float(answer[1])) if len(answer) > 1 else mpq(0)
    allowed = APART * size.coordinate + slack
    return Verdict(RIGHT if errors[0] <= allowed else OFF, size.ulps(errors[0]))


# ---- places


@dataclass(frozen=True)
class _Place:
    low: mpq
    high: mpq
    must: bool


class _Form:
    """A form and its zeros, as given by the certificate."""

    def __init__(self, certified: dict[str, object]) -> None:
        certificate: dict[str, Any] = certified  # data, as `exactspline.roots.zero_set` writes it
        self.breaks = [mpq(t) for t in certificate["breakpoints"]]
        self.segments = [[int(x) for x in s["coefficients"]] for s in certificate["segments"]]
        self.roots = [
            (mpq(r["low"]), mpq(r["high"]), None not in r["signs"] and r["signs"][0] != r["signs"][1])
            for r in certificate["roots"]
        ]
        self.jumps = [mpq(j["at"]) for j in certificate["jumps"]]
        self.width = self.breaks[-1] - self.breaks[0]

    def is_small(self, t: mpq) -> bool:
        """Whether the form is below `ZERO` of its largest Bézier point, on the segment of a parameter."""
        i = max(k for k, b in enumerate(self.breaks[:-1]) if b <= t or k == 0)
        a, b = self.breaks[i : i + 2]
        c = self.segments[i]
        # its integers are Bézier points times binomial coefficients, which are at most 2ⁿ
        return bool(abs(at(c, (t - a) / (b - a))) * (1 << len(c)) <= ZERO * max(map(abs, c)) * (1 << len(c)))

    def places(self, soft: Sequence[mpq]) -> list[_Place]:
        """Zeros grouped into places; a place must be named where the sign changes inside the domain."""
        groups: list[list[tuple[mpq, mpq, bool]]] = []
        for root in self.roots:
            if groups and root[0] - groups[-1][-1][1] <= PLACE * self.width:
                groups[-1].append(root)
            else:
                groups.append([root])
        places = []
        for group in groups:
            low, high = group[0][0], group[-1][1]
            changes = sum(change for _, _, change in group) % 2 == 1
            exempt = [self.breaks[0], self.breaks[-1], *self.jumps]
            spared = any(self._near(t, low, high) for t in exempt) or any(self._near(t, low, high, NEAR) for t in soft)
            places.append(_Place(low, high, changes and not spared))
        return places

    def _near(self, t: mpq, low: mpq, high: mpq, reach: mpq = PLACE) -> bool:
        return bool(low - reach * self.width <= t <= high + reach * self.width)

    def explains(self, t: mpq, places: Sequence[_Place], soft: Sequence[mpq]) -> bool:
        """Whether a parameter that a library names is not spurious."""
        if any(self._near(t, p.low, p.high) for p in places) or any(self._near(t, s, s) for s in self.jumps):
            return True
        if any(self._near(t, s, s, NEAR) for s in soft):
            return True
        a, b = self.breaks[0], self.breaks[-1]
        if self._near(t, a, a) or self._near(t, b, b):
            return True
        return bool(a <= t <= b and self.is_small(t))

    def names(self, t: mpq, place: _Place) -> bool:
        """Whether a parameter names a place: near it, or as near as the form can resolve."""
        if self._near(t, place.low, place.high):
            return True
        inside = self.breaks[0] <= t <= self.breaks[-1]
        return inside and self._near(t, place.low, place.high, NEAR) and self.is_small(t)


def _is_straight(curve: Nurbs) -> bool:
    """Whether the direction of a polynomial plane curve turns by less than the tolerance: γ′ × γ″ times the length of
    the domain nowhere exceeds a fraction of ‖γ′‖².
    """
    if not curve.polynomial:
        return False
    speed = max((abs(c) for f in curve.p for c in f.d().control_points), default=mpq(0))
    turning = max(map(abs, bend(curve).control_points), default=mpq(0))
    return turning * (curve.domain[1] - curve.domain[0]) <= STRAIGHT * speed * speed


def _regular_places(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    if _is_straight(case.curve):
        return Verdict(RIGHT, note="straight within the tolerance: any answer is right")
    soft = [root.low for root in analyse(case.curve).speed.zeros]
    return _compared(truth, answer, [*soft, *case.curve.breakpoints[1:-1]])


def _places(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    return _compared(truth, answer, [])


def _compared(truth: Answer, answer: Any, soft: list[mpq]) -> Verdict:
    """Lists of parameters against certificates of zero sets; those near a soft parameter may be named or not."""
    missed, invented = list[mpq](), list[mpq]()
    if len(answer) != len(truth["certificates"]):
        raise ValueError(f"{len(answer)} lists instead of {len(truth['certificates'])}")
    for certificate, parameters in zip(truth["certificates"], answer, strict=True):
        form = _Form(certificate)
        values = [float(t) for t in parameters]
        if not all(map(isfinite, values)):
            return _NAN
        named, places = [from_float(t) for t in values], form.places(soft)
        missed += [p.low for p in places if p.must and not any(form.names(t, p) for t in named)]
        invented += [x for x in named if not form.explains(x, places, soft)]
    outcome, first = (MISSED, missed) if missed else (INVENTED, invented)
    if not first:
        return Verdict(RIGHT)
    return Verdict(outcome, note=note_of(outcome, first), missed=tuple(missed), invented=tuple(invented))


# ---- pairs


def _pairs(case: Case, question: str, truth: Answer, answer: Any) -> Verdict:
    return pairs_compared(case, truth, answer, ZERO * _Size.of(case.curve).coordinate)


def pairs_compared(case: Case, truth: Answer, answer: Any, gap: mpq) -> Verdict:
    """Pairs of parameters against the exact ones: named where they are near one, or the points at most `gap` apart."""
    curves, middles = (case.curve, case.partner), _middles(truth)
    exact = [(middles[i], middles[i + 1]) for i in range(0, len(middles), 2)]
    values = [[float(t) for t in pair] for pair in answer]
    if not all(isfinite(t) for pair in values for t in pair):
        return _NAN
    (a, b), named = case.curve.domain, [tuple(map(from_float, pair)) for pair in values]

    def near(one: Sequence[mpq], other: Sequence[mpq], reach: mpq = PLACE) -> bool:
        return all(abs(s - t) <= reach * (b - a) for s, t in zip(one, other, strict=True))

    def within(p: Sequence[mpq], q: Sequence[mpq]) -> bool:
        return bool(sum(((x - y) ** 2 for x, y in zip(p, q, strict=True)), start=mpq(0)) <= gap * gap)

    def points(pair: Sequence[mpq]) -> list[Sequence[mpq]]:
        return [curve(t, "left") for curve, t in zip(curves, pair, strict=True)]

    def meets(pair: Sequence[mpq]) -> bool:
        return all(a <= t <= b for t in pair) and within(*points(pair))

    def names(each: Sequence[mpq], pair: Sequence[mpq]) -> bool:
        if near(pair, each):
            return True
        return meets(each) and (near(pair, each, NEAR) or all(map(within, points(pair), points(each))))

    missed = [
        pair
        for pair in exact
        if _must_be_named(curves, pair, PLACE * (b - a))
        and sum(near(pair, other) for other in exact) == 1
        and not any(names(each, pair) for each in named)
    ]
    invented = [each for each in named if not meets(each) and not any(near(pair, each) for pair in exact)]
    outcome, found = (MISSED, missed) if missed else (INVENTED, invented)
    if not found:
        return Verdict(RIGHT)
    return Verdict(outcome, note=note_of(outcome, [t for pair in found[:1] for t in pair]))


def _must_be_named(curves: tuple[Nurbs, Nurbs], pair: Sequence[mpq], reach: mpq) -> bool:
    """Whether two curves cross at an angle, away from their ends."""
    if not all(c.domain[0] + reach < t < c.domain[1] - reach for c, t in zip(curves, pair, strict=True)):
        return False
    (x, y), (u, v) = (c.derivative(1, t, "left") for c, t in zip(curves, pair, strict=True))
    return bool((x * v - y * u) ** 2 > APART**2 * (x * x + y * y) * (u * u + v * v))


def note_of(outcome: str, places: Sequence[mpq]) -> str:
    """An outcome with the first places that it is about."""
    return f"{outcome} {', '.join(f'{double(t):.6g}' for t in places[:3])}"


#: An answer of a library may be anything: one of another type raises, and counts as a wrong value.
_JUDGES: dict[Judged, Callable[[Case, str, Answer, Any], Verdict]] = {
    Judged.VECTOR: _vector,
    Judged.QUOTIENT: _quotient,
    Judged.CONTROL_POINTS: _rows,
    Judged.BOX: _box,
    Judged.NUMBER: _length,
    Judged.AREA: _area,
    Judged.DISTANCE: _distance,
    Judged.PAIRS: _pairs,
    Judged.PLACES: _places,
    Judged.REGULAR_PLACES: _regular_places,
}
