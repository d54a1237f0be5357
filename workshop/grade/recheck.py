"""Checks exact answers with an independent computation of every number by the standard library; of exactspline only
the checker of certificates is used.

The curve is evaluated by the recursion of Cox and de Boor on truncated Taylor series. Curves with other control points
are compared with the given one at as many parameters as determine a rational function of their degree; likewise the
form behind a zero set is compared with the function of which it must be a positive multiple on every segment.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb, factorial, hypot, isqrt, lcm
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.certificates import check_certificate

if TYPE_CHECKING:
    from workshop.grade.data import Answer, CurveData, ExactCurve

#: Terms of a Taylor series: value and three derivatives.
TERMS = 4
#: Up to this degree zeros are also counted by a Sturm sequence.
STURM = 6
#: The number of chords whose sum is compared with a length.
CHORDS = 24
#: How much nearer parts of two curves may be, as a fraction of the largest coordinate, and the pairs of parts compared.
CLOSER, PAIRS = 1e-8, 20_000
Jet = list[list[Fraction]]
Side = tuple[Fraction, Fraction]


class Curve(NamedTuple):
    """A curve as numbers, with homogeneous control points."""

    degree: int
    knots: list[Fraction]
    rows: list[list[Fraction]]
    rational: bool
    partner: list[list[Fraction]]


#: A function for the value of a form of a curve at a parameter.
Form = Callable[[Curve, Fraction], Fraction]


def recheck(curve: CurveData, parameter: str, question: str, answer: Answer) -> None:
    """Raise ValueError unless the answer to a question about a curve is proved right.

    `curve` has degree, knots, rows of homogeneous control points, whether it is rational, and the rows of its partner;
    all numbers as text.
    """
    rows, partner = _numbers(curve["rows"]), _numbers(curve["partner"])
    numbers = Curve(curve["degree"], list(map(Fraction, curve["knots"])), rows, curve["rational"], partner)
    _CHECKS[question](numbers, Fraction(parameter), question, answer)


def _numbers(rows: list[list[str]]) -> list[list[Fraction]]:
    return [list(map(Fraction, row)) for row in rows]


def _require(condition: bool, flaw: str) -> None:
    if not condition:
        raise ValueError(flaw)


# ---- evaluation


def jets(curve: Curve, t: Fraction, left: bool = False, terms: int = TERMS) -> Jet:
    """The Taylor coefficients of the homogeneous coordinates at a parameter, by integers over common denominators."""
    degree, rows = curve.degree, curve.rows
    j = _span(curve, t, left)
    unit = lcm(t.denominator, *(k.denominator for k in curve.knots[j - degree + 1 : j + degree + 1]))
    size = lcm(*(x.denominator for row in rows[j - degree : j + 1] for x in row))
    place, knots = _times(t, unit), [_times(k, unit) for k in curve.knots[j - degree : j + degree + 1]]
    points = [[[_times(x, size), *[0] * (terms - 1)] for x in row] for row in rows[j - degree : j + 1]]
    for r in range(1, degree + 1):
        widths = [knots[1 + degree + i - r] - knots[i] for i in range(degree + 1)]
        shared = lcm(*widths[r:])
        size *= shared
        for i in range(degree, r - 1, -1):
            factor = shared // widths[i]
            before, behind = factor * (place - knots[i]), factor * (knots[1 + degree + i - r] - place)
            points[i] = [
                [
                    behind * old[k] + before * new[k] + (factor * unit * (new[k - 1] - old[k - 1]) if k else 0)
                    for k in range(terms)
                ]
                for old, new in zip(points[i - 1], points[i], strict=True)
            ]
    return [[Fraction(x, size) for x in series] for series in points[degree]]


def _span(curve: Curve, t: Fraction, left: bool) -> int:
    """The index of the last knot of the segment of a parameter that is not behind it."""
    degree, knots = curve.degree, curve.knots
    spans = [j for j in range(degree, len(knots) - degree - 1) if knots[j] < knots[j + 1]]
    inside = [j for j in spans if (knots[j] < t <= knots[j + 1] if left else knots[j] <= t < knots[j + 1])]
    return inside[0] if inside else spans[-1] if t >= knots[spans[-1] + 1] else spans[0]


def _times(x: Fraction, whole: int) -> int:
    """The product with a multiple of the denominator."""
    return x.numerator * (whole // x.denominator)


def cartesian(curve: Curve, t: Fraction, left: bool = False, terms: int = TERMS) -> Jet:
    """Value and derivatives of every coordinate."""
    *tops, w = jets(curve, t, left, terms)
    coordinates = []
    for p in tops:
        series: list[Fraction] = []
        for k in range(terms):
            series.append((p[k] - sum(w[i] * series[k - i] for i in range(1, k + 1))) / w[0])
        coordinates.append([c * factorial(k) for k, c in enumerate(series)])
    return coordinates


# ---- numbers


def _is(interval: list[str], value: Fraction) -> bool:
    return Fraction(interval[0]) <= value <= Fraction(interval[1])


def _is_root(interval: list[str], square: Fraction, sign: int = 1) -> bool:
    """Whether ``± √square`` is in an interval that is narrow enough to identify it."""
    low, high = sorted(sign * Fraction(x) for x in interval)
    narrow = high - low <= Fraction(1, 10**30) + abs(high) / 10**15
    return narrow and max(low, Fraction(0)) ** 2 <= square <= high**2 and high >= 0


def _derivatives(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    order = ("value", "first", "second").index(question)
    values = [x[order] for x in cartesian(curve, t)]
    _require(len(values) == len(answer["numbers"]), "another dimension")
    _require(all(map(_is, answer["numbers"], values)), "another derivative")


def _tangent(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    velocity = [x[1] for x in cartesian(curve, t)]
    length = sum((x * x for x in velocity), start=Fraction(0))
    signs = [(x > 0) - (x < 0) for x in velocity]
    for interval, x, sign in zip(answer["numbers"], velocity, signs, strict=True):
        _require(_is_root(interval, x * x / length, sign or 1), "another tangent")


def crossed(x: Jet) -> list[Fraction]:
    """``γ′ × γ″``: one number in the plane."""
    v, a = ([c[k] for c in x] for k in (1, 2))
    if len(x) == 2:
        return [v[0] * a[1] - v[1] * a[0]]
    return [v[1] * a[2] - v[2] * a[1], v[2] * a[0] - v[0] * a[2], v[0] * a[1] - v[1] * a[0]]


def _curvature(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    x = cartesian(curve, t)
    square = sum((b * b for b in crossed(x)), start=Fraction(0)) / sum(c[1] * c[1] for c in x) ** 3
    _require(_is_root(answer["numbers"][0], square), "another curvature")


def _torsion(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    x = cartesian(curve, t)
    bend = crossed(x)
    value = sum((b * c[3] for b, c in zip(bend, x, strict=True)), start=Fraction(0)) / sum(b * b for b in bend)
    _require(_is(answer["numbers"][0], value), "another torsion")


# ---- curves with other control points


def _parsed(part: ExactCurve, rational: bool) -> Curve:
    rows = _numbers(part["rows"])
    lifted = [[*(x * row[-1] for x in row[:-1]), row[-1]] if rational else [*row, Fraction(1)] for row in rows]
    return Curve(part["degree"], list(map(Fraction, part["knots"])), lifted, rational, [])


def _domain(curve: Curve) -> list[Fraction]:
    n, knots = curve.degree, curve.knots
    return sorted({t for t in knots if knots[n] <= t <= knots[-n - 1]})


def _same_curve(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    parts = [_parsed(part, curve.rational) for part in answer["curves"]]
    domain = _domain(curve)
    ends = [_domain(part) for part in parts]
    _require(ends[0][0] == domain[0] and ends[-1][-1] == domain[-1], "another domain")
    _require(all(a[-1] == b[0] == t for a, b in pairwise(ends)), "the parts do not meet at the parameter")
    count = {"insert": len(curve.knots) + 1, "remove": len(curve.knots), "elevate": 0, "split": 0}[question]
    _require(not count or len(parts[0].knots) == count, "a wrong number of knots")
    for part in parts:
        _require(len(part.rows) == len(part.knots) - part.degree - 1, "a wrong number of control points")
        for a, b in pairwise(_domain(part)):
            # two quotients of degree n agree where their cross products of degree 2n do at 2n + 1 parameters
            n = part.degree + curve.degree + 1
            for s in (a + (b - a) * Fraction(2 * k + 1, 2 * n) for k in range(n)):
                _require(_point(part, s) == _point(curve, s), "another curve")


def _point(curve: Curve, t: Fraction) -> list[Fraction]:
    *tops, w = (x[0] for x in jets(curve, t, terms=1))
    return [p / w for p in tops]


# ---- zeros


def proved(certified: dict[str, object], curve: Curve, form: Form, degree: int) -> None:
    """Check that the certificate is right, and that its form is a positive multiple of the given form on every
    segment.
    """
    certificate: dict[str, Any] = certified  # its contents are what is checked
    check_certificate(certified, sturm=certificate["degree"] <= STURM)
    breaks = list(map(Fraction, certificate["breakpoints"]))
    _require(breaks == _domain(curve), "other breakpoints")
    for segment, (a, b) in zip(certificate["segments"], pairwise(breaks), strict=True):
        c = list(map(int, segment["coefficients"]))
        n, ratios = max(degree, len(c) - 1) + 1, set()
        for k in range(n):
            u = Fraction(2 * k + 1, 2 * n)
            value, claimed = form(curve, a + (b - a) * u), at(c, u)
            _require((value == 0) == (claimed == 0), "another form")
            if value:
                ratios.add(claimed / value)
        _require(len(ratios) <= 1 and all(r > 0 for r in ratios), "another form")


def at(c: Sequence[Fraction | int], u: Any) -> Any:
    """``Σ c_i (1 − u)ⁿ⁻ⁱ uⁱ``."""
    top, bottom = u.numerator, u.denominator
    value, power = c[0], 1
    for x in c[1:]:
        power *= top
        value = value * (bottom - top) + x * power
    # of the type of u
    return (u - u + value) / bottom ** (len(c) - 1)


def _slope(axis: int) -> Form:
    def form(curve: Curve, t: Fraction) -> Fraction:
        *tops, w = jets(curve, t, terms=2)
        return tops[axis][1] * w[0] - tops[axis][0] * w[1]

    return form


def _height(curve: Curve, t: Fraction) -> Fraction:
    return jets(curve, t, terms=1)[1][0]


def _turning(curve: Curve, t: Fraction) -> Fraction:
    w = jets(curve, t, terms=1)[-1][0]
    return crossed(cartesian(curve, t, terms=3))[0] * w**3


def _change(curve: Curve, t: Fraction) -> Fraction:
    x, y = cartesian(curve, t)
    speed, along = x[1] * x[1] + y[1] * y[1], x[1] * x[2] + y[1] * y[2]
    return (x[1] * y[3] - y[1] * x[3]) * speed - 3 * (x[1] * y[2] - y[1] * x[2]) * along


def _places(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    dimension, n = len(curve.rows[0]) - 1, curve.degree
    forms: dict[str, list[tuple[Form, int]]] = {
        "turns": [(_slope(axis), 2 * n) for axis in range(dimension)],
        "roots": [(_height, n)],
        "inflections": [(_turning, 3 * n)],
        "extrema": [(_change, 4 * n)],
    }
    for certificate, (form, degree) in zip(answer["certificates"], forms[question], strict=True):
        proved(certificate, curve, form, degree)


def _box(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    n = curve.degree
    for axis, certificate in enumerate(answer["certificates"]):
        proved(certificate, curve, _slope(axis), 2 * n)
        values = [cartesian(curve, s, left, 1)[axis][0] for s in _domain(curve) for left in (False, True)]
        roots: Any = certificate["roots"]  # proved just now
        for root in roots:
            low, high = Fraction(root["low"]), Fraction(root["high"])
            values += [cartesian(curve, s, terms=1)[axis][0] for s in (low, high)]
        slack = Fraction(1, 10**9) * (1 + max(map(abs, values)))
        for interval, value in zip(answer["numbers"][2 * axis : 2 * axis + 2], (min(values), max(values)), strict=True):
            low, high = map(Fraction, interval)
            # the slope vanishes there: the uncertainty from the root's interval is of second order
            _require(low - slack <= value <= high + slack and high - low <= slack, "another box")


# ---- measures


def _length(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    """Chords are shorter than the arc; with twice as many the deficit falls to a quarter, or more slowly."""
    low, high = map(Fraction, answer["numbers"][0])
    sums = []
    for chords in (CHORDS, 2 * CHORDS):
        total = Fraction(0)
        for a, b in pairwise(_domain(curve)):
            points = [_point(curve, a + (b - a) * Fraction(k, chords)) for k in range(chords + 1)]
            total += sum((_distance(p, q) for p, q in pairwise(points)), start=Fraction(0))
        sums.append(total)
    _require(sums[1] <= high + Fraction(1, 10**9), "shorter than its chords")
    _require(low <= sums[1] + 4 * (sums[1] - sums[0]) + Fraction(1, 10**9), "much longer than its chords")


def _distance(p: list[Fraction], q: list[Fraction]) -> Fraction:
    """The distance, rounded down to a multiple of 10⁻¹²."""
    square = sum(((x - y) ** 2 for x, y in zip(p, q, strict=True)), start=Fraction(0))
    return Fraction(isqrt(int(square * 10**24)), 10**12)


def _area(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    """``∮ x dy``, the integrand interpolated at as many parameters as determine it."""
    n, total = 2 * curve.degree, Fraction(0)
    nodes = [Fraction(2 * k + 1, 2 * n) for k in range(n)]
    weights = [_integral_of_lagrange(nodes, k) for k in range(n)]
    for a, b in pairwise(_domain(curve)):
        for u, share in zip(nodes, weights, strict=True):
            x, y = cartesian(curve, a + (b - a) * u, terms=2)
            total += share * (b - a) * x[0] * y[1]
    _require(_is(answer["numbers"][0], total), "another area")


def _integral_of_lagrange(nodes: list[Fraction], k: int) -> Fraction:
    powers = [Fraction(1)]
    for i, node in enumerate(nodes):
        if i != k:
            d = nodes[k] - node
            powers = [
                (powers[j - 1] if j else 0) / d - (powers[j] * node if j < len(powers) else 0) / d
                for j in range(len(powers) + 1)
            ]
    return sum((c / (j + 1) for j, c in enumerate(powers)), start=Fraction(0))


# ---- a curve and a point, two curves


def _nearest(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    *tops, w = curve.partner[0]
    point = [x / w for x in tops]

    def slope(curve: Curve, t: Fraction) -> Fraction:
        *tops, w = jets(curve, t, terms=2)
        chords = [[p[k] - x * w[k] for k in (0, 1)] for p, x in zip(tops, point, strict=True)]
        # (top/w²)′ w³ with the top Σ chord²
        return sum((2 * e[0] * (e[1] * w[0] - e[0] * w[1]) for e in chords), start=Fraction(0))

    [certificate] = answer["certificates"]
    proved(certificate, curve, slope, 3 * curve.degree)
    roots: Any = certificate["roots"]  # proved just now
    places = [*_domain(curve), *(Fraction(root["low"]) for root in roots)]
    least = min(
        _distance([x[0] for x in cartesian(curve, s, left, 1)], point) for s in places for left in (False, True)
    )
    low, high = map(Fraction, answer["numbers"][0])
    # the certificate's intervals are narrower than 2⁻⁵⁰
    slack = Fraction(1, 10**9) * (1 + max(abs(x) for row in (*curve.rows, *curve.partner) for x in row))
    _require(low - slack <= least <= high + slack and high - low <= slack, "another distance")


def _separation(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    """A pair of points is at the distance, and no parts of the curves are nearer: their control polygons lie between
    parallel lines or planes further apart, after enough bisections. In doubles, whose errors are far below `CLOSER`.
    """
    certified: Any = answer["certificates"][0]["pair"]  # what is checked
    (low, high), *places = ([Fraction(end) for end in each] for each in (answer["numbers"][0], *certified))
    other = curve._replace(rows=curve.partner)
    gap = _distance(*(_point(c, (a + b) / 2) for c, (a, b) in zip((curve, other), places, strict=True)))
    slack = CLOSER * float(max(abs(x) for row in (*curve.rows, *curve.partner) for x in row))
    _require(low - Fraction(slack) <= gap <= high + Fraction(slack), "a pair at another distance")
    todo, left = [(p, q) for p in bezier_points(curve) for q in bezier_points(other)], PAIRS
    while todo:
        p, q = todo.pop()
        if _gap(p, q) < float(low) - slack:
            left -= 1
            _require(left > 0, "not decided whether parts of the curves are nearer")
            todo += [(a, q) for a in _halves(p)] if _size(p) > _size(q) else [(p, b) for b in _halves(q)]


def bezier_points(curve: Curve) -> list[list[list[float]]]:
    """The homogeneous Bézier points of every segment."""
    n, found = curve.degree, []
    for a, b in pairwise(_domain(curve)):
        powers = [[x * (b - a) ** k for k, x in enumerate(p)] for p in jets(curve, a, terms=n + 1)]
        rows = [
            [float(sum(Fraction(comb(i, k), comb(n, k)) * p[k] for k in range(i + 1))) for p in powers]
            for i in range(n + 1)
        ]
        found.append(rows)
    return found


def _halves(points: list[list[float]]) -> tuple[list[list[float]], list[list[float]]]:
    """The Bézier points of the halves, by de Casteljau."""
    first, last, row = [points[0]], [points[-1]], points
    while len(row) > 1:
        row = [[(x + y) / 2 for x, y in zip(p, q, strict=True)] for p, q in pairwise(row)]
        first.append(row[0])
        last.append(row[-1])
    return first, last[::-1]


def _size(points: list[list[float]]) -> float:
    return sum(hypot(*(x - y for x, y in zip(p, q, strict=True))) for p, q in pairwise(points))


def _gap(p: list[list[float]], q: list[list[float]]) -> float:
    """A lower bound of the distance of two parts; 0 where a weight is not positive."""
    if min(row[-1] for row in (*p, *q)) <= 0:
        return 0
    p, q = ([[x / row[-1] for x in row[:-1]] for row in rows] for rows in (p, q))
    across = [sum(each) / len(q) - sum(own) / len(p) for own, each in zip(zip(*p), zip(*q), strict=True)]
    best = 0.0
    for part in ((), p, q):
        along = [b - a for a, b in zip(part[0], part[-1], strict=True)] if part else across
        # across, and what of it is at right angles to a chord
        share = sum(x * y for x, y in zip(across, along, strict=True)) / (sum(x * x for x in along) or 1) if part else 0
        normal = [x - share * y for x, y in zip(across, along, strict=True)]
        length = hypot(*normal)
        if length:
            near, far = ([sum(x * y for x, y in zip(row, normal, strict=True)) for row in rows] for rows in (p, q))
            best = max(best, (min(far) - max(near)) / length)
    return best


def _meetings(curve: Curve, t: Fraction, question: str, answer: Answer) -> None:
    """The pairs of parameters are those that the certificate proves, and each is of one point."""
    [certified] = answer["certificates"]
    certificate: dict[str, Any] = certified  # its contents are what is checked
    check_certificate(certified)
    curves, ends = (curve, curve._replace(rows=curve.partner)), _domain(curve)
    for name, each in zip(("first", "second"), curves, strict=True):
        _require(len(certificate[name]) == len(ends) - 1, "another number of segments")
        for segment, (a, b) in zip(certificate[name], pairwise(ends), strict=True):
            _same_forms([_form(segment[axis]) for axis in "xyw"], each, a, b)
    pairs = [answer["numbers"][i : i + 2] for i in range(0, len(answer["numbers"]), 2)]
    named = [[(Fraction(low), Fraction(high)) for low, high in pair] for pair in pairs]
    for first, second in named:
        gap = _distance(*(_point(c, (low + high) / 2) for c, (low, high) in zip(curves, (first, second), strict=True)))
        _require(gap <= Fraction(1, 10**9) * max(abs(x) for row in curve.rows for x in row), "points that are apart")
    proved = [place for pair in certificate["pairs"] for place in _places_of(pair, ends)]
    found = [[k for k, region in enumerate(proved) if _agree(both, region, ends)] for both in named]
    _require(all(found), "a common point is invented")
    of_each = [k for own in found for k in own]
    _require({*of_each} == {*range(len(proved))}, "a common point is missing")
    if len(ends) == 2:
        # a single pair of segments has each of its common points once, and the seam of a closed curve is one point
        once = all(len(own) == 1 or _at_seam(both, ends) for own, both in zip(found, named, strict=True))
        _require(once and len(of_each) == len(proved), "another number of common points")


def _form(points: list[str]) -> list[int]:
    """The form ``Σ c_i (1 − u)ⁿ⁻ⁱ uⁱ`` with these Bézier points."""
    return [comb(len(points) - 1, i) * int(x) for i, x in enumerate(points)]


def _at_seam(both: list[Side], ends: list[Fraction]) -> bool:
    return any(low == high and low in (ends[0], ends[-1]) for low, high in both)


def _same_forms(forms: list[list[int]], curve: Curve, a: Fraction, b: Fraction) -> None:
    ratios = set()
    for k in range(curve.degree + 1):
        u = Fraction(2 * k + 1, 2 * curve.degree + 2)
        homogeneous = jets(curve, a + (b - a) * u, terms=1)
        for form, (x,) in zip(forms, homogeneous, strict=True):
            claimed = at(form, u)
            _require((x == 0) == (claimed == 0), "another curve")
            ratios |= {claimed / x} if x else set()
    _require(len(ratios) == 1 and min(ratios) > 0, "another curve")


def _places_of(pair: dict[str, Any], ends: list[Fraction]) -> list[list[Side]]:
    """The intervals of both parameters around each common point of two segments."""
    sides = [ends[k : k + 2] for k in pair["segments"]]
    return [
        [
            (a + (b - a) * Fraction(low), a + (b - a) * Fraction(high))
            for (low, high), (a, b) in zip(zero["region"], sides, strict=True)
        ]
        for zero in pair["zeros"]
    ]


def _agree(both: list[Side], region: list[Side], ends: list[Fraction]) -> bool:
    return all(_overlap(place, side, ends) for place, side in zip(both, region, strict=True))


def _overlap(place: Side, region: Side, ends: list[Fraction]) -> bool:
    """Whether an interval has a point of another one, the seam of a closed curve being one point."""
    if place[0] <= region[1] and region[0] <= place[1]:
        return True
    return _at_seam([place], ends) and any(region[0] <= end <= region[1] for end in (ends[0], ends[-1]))


_CHECKS: dict[str, Callable[[Curve, Fraction, str, Answer], None]] = {
    **dict.fromkeys(("value", "first", "second"), _derivatives),
    "tangent": _tangent,
    "curvature": _curvature,
    "torsion": _torsion,
    **dict.fromkeys(("insert", "remove", "elevate", "split"), _same_curve),
    "box": _box,
    **dict.fromkeys(("turns", "roots", "inflections", "extrema"), _places),
    "length": _length,
    "area": _area,
    "nearest": _nearest,
    "distance": _separation,
    "meetings": _meetings,
}
