"""Checks packs of vectors again: a seeded sample of the cases, with fractions of the standard library.

What `ASKED` names is proved right by `workshop.grade.recheck`, and the doubles of the pack must be those around it; a
curvature is compared exactly. All places inside segments (singular points, zeros of curvature and torsion, critical
points) are those of a certificate of the zeros of their form, with the kind that follows from its signs. The order of
joints and the pieces are decided segment by segment. A winding number is compared with a sum of angles. Not checked are
places at knots and ends, answers that hold everywhere on a piece between points, angles and gaps of joints, of a
distance or a box more than is proved (10⁻⁸ and 10⁻⁹ of the size), and whether a curve that turns by more than half
meets itself elsewhere.
"""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial, reduce
from itertools import pairwise
from math import atan2, hypot, inf, nextafter, pi
from operator import add
from pathlib import Path
from typing import Any, NamedTuple
from zlib import crc32

from exactspline.geometry.analysis.curves import QUESTIONS, analyse
from exactspline.geometry.curves.bounds import slope
from exactspline.language.vector import Vector, triple
from exactspline.numbers.exact import mpq
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade import recheck
from workshop.grade.recheck import Curve, Jet, cartesian, crossed
from workshop.grade.runner import curve_data
from workshop.grade.truth import truth

#: Questions of a pack, and what they are called in grading.
ASKED = {
    "value": "value",
    "derivative": "first",
    "torsion": "torsion",
    "bounding_box": "box",
    "nearest": "nearest",
    "distance": "distance",
    "intersections": "meetings",
}
#: Points per segment at which the angle around a point is taken.
ANGLES = 64
#: How far points that are one may be apart, as a fraction of the largest coordinate.
APART = 2.0**-40
#: The bits to which zeros are isolated.
BITS = 50
#: Kinds of places by half the change of the sign of the form.
EXTREMA = {0: "stationary", 1: "minimum", -1: "maximum"}
TURNS = {0: "undulation", 1: "inflection", -1: "inflection"}
TWISTS = {0: "torsion touch", 1: "torsion zero", -1: "torsion zero"}


def checked(place: Path, share: float = 0.1, seed: int = 1) -> tuple[int, Counter[str], Counter[str]]:
    """Check a share of the cases of a pack; returns how many cases, and of each question how many answers were checked
    and how many there are.

    Raises `ValueError` with the case for one that is wrong.
    """
    data, chance = json.loads(place.read_text(encoding="utf-8")), random.Random(seed)
    sample = [line for line in data["cases"] if chance.random() < share]
    given = Counter(
        name for line in sample for name, answer in line["case"]["answers"].items() if answer["answer"] != "undefined"
    )
    return len(sample), Counter(name for line in sample for name in _names_checked(line)), given


def _require(condition: bool, case: dict[str, Any], flaw: str) -> None:
    if not condition:
        raise ValueError(f"{case['key']}: {flaw}")


def _of_hex(given: str) -> Fraction:
    return Fraction(float.fromhex(given))


class _Checked(NamedTuple):
    """A case of a pack: its data, the case, its curve and its partner in numbers of the standard library."""

    data: dict[str, Any]
    exact: Case
    curve: Curve
    partner: Curve

    @property
    def size(self) -> float:
        """The largest coordinate."""
        return max(abs(float(x)) for row in (*self.curve.rows, *self.partner.rows) for x in row)

    @property
    def breaks(self) -> list[Fraction]:
        """The ends of the segments."""
        curve = self.curve
        return sorted({t for t in curve.knots if curve.knots[curve.degree] <= t <= curve.knots[-curve.degree - 1]})

    def items(self, question: str) -> list[dict[str, Any]] | None:
        """The items of an answer that is none or these."""
        answer = self.data["answers"].get(question, {"answer": "undefined"})
        items: list[dict[str, Any]] = answer.get("items", [])
        return items if answer["answer"] in ("none", "these") else None

    def require(self, condition: bool, flaw: str) -> None:
        """Raise `ValueError` with the case unless a condition holds."""
        _require(condition, self.data, flaw)


def _names_checked(line: dict[str, Any]) -> Iterator[str]:
    """The questions whose answers were checked."""
    case = line["case"]
    body = json.dumps(case, ensure_ascii=True, separators=(",", ":"))
    _require(f"{crc32(body.encode()):08x}" == line["digest"], case, "another digest")
    made, knots = [], case["exact"]["knots"]
    for given in (case, case["partner"]):
        curve = _curve(case["degree"], {"knots": knots} | given["exact"], Fraction)
        doubles = _curve(case["degree"], {"knots": case["doubles"]["knots"]} | given["doubles"], _of_hex)
        _require(curve == doubles, case, "text and doubles differ")
        made.append(curve)
    given = case["exact"]
    exact = Case(
        case["key"], "", Nurbs(case["degree"], knots, given["points"], given["weights"]),
        mpq(case["parameter"]["exact"]), dial=case["dial"]["sign"] * case["dial"]["k"] if case["dial"] else 0,
    )  # fmt: skip
    own = _Checked(case, exact, *made)
    yield from _numbers_checked(own)
    checks = (_curvature, _pieces, _joints, _pairs, _nearest_points, _winding)
    for check in checks:
        yield from check(own)
    yield from _places_checked(own)


def _numbers_checked(own: _Checked) -> Iterator[str]:
    """What is proved by `recheck`."""
    data = curve_data(own.exact)
    own.require([list(map(Fraction, row)) for row in data["partner"]] == own.partner.rows, "another partner")
    for question, asked in ASKED.items():
        items = own.items(question)
        answer = None if items is None else truth(own.exact, asked)
        if items is None or answer is None:
            continue
        try:
            recheck.recheck(data, own.data["parameter"]["exact"], asked, answer)
        except ValueError as error:
            own.require(asked == "distance" and "not decided" in str(error), f"{question}: {error}")
            continue
        numbers = list(_NUMBERS[question](items))
        own.require(len(numbers) == len(answer["numbers"]), f"{question}: another number of numbers")
        ends = [[Fraction(end) for end in each] for each in answer["numbers"]]
        own.require(all(map(_rounds, numbers, ends)), f"{question}: another number")
        yield question


def _curvature(own: _Checked) -> Iterator[str]:
    """By the square, exactly; signed in the plane."""
    if not (items := own.items("curvature")):
        return
    x = cartesian(own.curve, Fraction(own.data["parameter"]["exact"]))
    across = crossed(x)
    square = sum(b * b for b in across) / sum(c[1] * c[1] for c in x) ** 3
    exact = square if len(across) > 1 or across[0] > 0 else -square
    below, nearest, above = (_of_hex(each) for each in items[0]["curvature"])
    middle = (below + above) / 2
    own.require(below * abs(below) <= exact <= above * abs(above), "another curvature")
    own.require(float(above) in (float(below), nextafter(float(below), inf)), "curvature: no neighbours")
    side = above if exact > middle * abs(middle) else below
    own.require(nearest == side or exact == middle * abs(middle), "curvature: not the nearest double")
    yield "curvature"


# ---- places


def _speed(curve: Nurbs) -> BSpline:
    """``w⁴ ‖γ′‖²``."""
    return reduce(add, [f * f for f in (slope(curve, axis) for axis in range(curve.dimension))])


def _bent(curve: Nurbs) -> BSpline:
    """``w⁶ ‖γ′ × γ″‖²`` of a space curve."""
    rows = [[f.d(k) for k in range(3)] for f in (*curve.p, curve.w)]
    minors = [triple(Vector(*rows[i]), Vector(*rows[j]), Vector(*rows[3])) for i, j in ((1, 2), (2, 0), (0, 1))]
    squared: BSpline = reduce(add, [f * f for f in minors])
    return squared


def _dot(p: list[Fraction], q: list[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(p, q, strict=True)), start=Fraction(0))


def _form(of: Callable[[Jet], Fraction], power: int) -> Callable[[Curve, Fraction], Fraction]:
    """A function of the derivatives times a power of the weight."""
    return lambda curve, t: of(cartesian(curve, t)) * recheck.jets(curve, t, terms=1)[-1][0] ** power


def _change(x: Jet) -> Fraction:
    """Of the sign of ``κ′``, in space of ``(κ²)′``."""
    v, a, j = ([c[k] for c in x] for k in (1, 2, 3))
    across = crossed(x)
    # the sign is part of κ in the plane
    way = across if len(x) == 3 else [Fraction(1)]
    return _dot(way, crossed([[p, p, q] for p, q in zip(v, j, strict=True)])) * _dot(v, v) - 3 * _dot(
        way, across
    ) * _dot(v, a)


def _places_checked(own: _Checked) -> Iterator[str]:
    """Inside segments the places are those of certificates, and their kinds follow from the signs of the forms."""
    curve, flat = own.exact.curve, own.exact.curve.dimension == 2
    speeds, bends = _form(lambda x: _dot([c[1] for c in x], [c[1] for c in x]), 4), _form(_squared_bend, 6)
    still = _certified(own, zeros(_speed(curve)), speeds, (2, 4))
    if still is None:
        return
    yield from _compared(own, "singular_points", still, _stop, ())
    yield from _compared(own, "cusps", still, _stop, (), only=("cusp",))
    bent = still if flat else _certified(own, zeros(_bent(curve)), bends, (4, 6))
    if bent is None:
        return
    if not flat:
        yield from _compared(own, "inflections", bent, lambda _: "", still["roots"])
    facts, apart = analyse(curve), [*still["roots"], *(() if flat else bent["roots"])]
    changes = (_form(_change, 8), (4, 8)) if flat else (_form(_change, 11), (6, 11))
    turns = (_form(lambda x: crossed(x)[0], 3), (2, 3))
    twists = (_form(lambda x: _dot(crossed(x), [c[3] for c in x]), 6), (3, 6))
    for questions, (form, degrees), kinds in (
        (("inflections",) if flat else (), turns, TURNS),
        (("critical_points", "curvature_extrema"), changes, EXTREMA),
        (("torsion_zeros",), twists, TWISTS),
    ):
        proof = QUESTIONS[questions[0]].about.proof if questions and own.items(questions[0]) is not None else None
        certificate = None if proof is None else _certified(own, *proof(facts), form, degrees)
        if certificate is None:
            continue
        for question in questions:
            only = ("maximum", "minimum") if question == "curvature_extrema" else ()
            yield from _compared(own, question, certificate, partial(_kind, kinds), apart, only=only)


def _squared_bend(x: Jet) -> Fraction:
    return _dot(crossed(x), crossed(x))


def _stop(root: dict[str, Any]) -> str:
    """γ′ vanishes half as often as its square, and turns round where that is odd."""
    return ("stop", "cusp")[root["multiplicities"][0] // 2 % 2]


def _kind(kinds: dict[int, str], root: dict[str, Any]) -> str:
    before, behind = root["signs"]
    return kinds[(behind - before) // 2]


def _certified(
    own: _Checked, found: ZeroSet, form: Callable[[Curve, Fraction], Fraction], degrees: tuple[int, int]
) -> dict[str, Any] | None:
    """The certificate of all zeros of a form, proved; None where it vanishes on a segment. The degree of the form is at
    most one of these times that of the curve: the first of a polynomial one, the second of a rational one.
    """
    for root in found:
        root.refine(BITS)
    certificate: dict[str, Any] = found.certificate()
    if certificate["intervals"]:
        return None
    recheck.proved(certificate, own.curve, form, degrees[not own.exact.curve.polynomial] * own.curve.degree)
    return certificate


def _compared(
    own: _Checked,
    question: str,
    certificate: dict[str, Any],
    expected: Callable[[dict[str, Any]], str],
    apart: Sequence[dict[str, Any]],
    *,
    only: tuple[str, ...] = (),
) -> Iterator[str]:
    """The items inside segments against the roots that are not among those `apart`; an empty kind stands for any."""
    items = own.items(question)
    if items is None:
        return
    named = [(tuple(map(_of_hex, item["parameter"][::2])), item) for item in items]

    def meets(root: dict[str, Any], low: Fraction, high: Fraction) -> bool:
        return Fraction(root["low"]) <= high and low <= Fraction(root["high"])

    for root in certificate["roots"]:
        if None in root["signs"] or any(meets(root, t, t) for t in own.breaks):
            continue
        if any(meets(root, Fraction(other["low"]), Fraction(other["high"])) for other in apart):
            continue
        kind = expected(root)
        if not only or kind in only:
            kinds = [item["what"] for (low, high), item in named if meets(root, low, high)]
            own.require(kind in kinds if kind else bool(kinds), f"{question}: {kind} at {root['low']} is missing")
    for (low, high), item in named:
        if not (item["facts"]["by_jump"] or item["facts"]["at_knot"]):
            near = any(meets(root, low, high) for root in certificate["roots"])
            own.require(near, f"{question}: invented at {float(low)}")
    yield question


# ---- segments


def _pieces(own: _Checked) -> Iterator[str]:
    """Whether each segment is in a piece is decided at as many parameters as determine the form."""
    n, curve = own.curve.degree, own.curve
    forms: dict[str, tuple[Callable[[Jet], Any], int]] = {
        "standing_pieces": (lambda x: any(c[1] for c in x), 2 * n),
        "straight_pieces": (lambda x: any(crossed(x)), 3 * n),
        "constant_pieces": (_change, 11 * n),
    }
    holds = {question: list[bool]() for question in forms}
    for a, b in pairwise(own.breaks):
        for question, (form, degree) in forms.items():
            places = (a + (b - a) * Fraction(2 * k + 1, 2 * degree + 2) for k in range(degree + 1))
            holds[question].append(not any(form(cartesian(curve, t)) for t in places))
    for question, found in holds.items():
        items = own.items(question)
        if items is None:
            continue
        ends = [[float.fromhex(item[name][1]) for name in ("start", "end")] for item in items]
        for k, (a, b) in enumerate(pairwise(own.breaks)):
            middle = float(a + b) / 2
            inside = any(low <= middle <= high if low < high else middle >= low or middle <= high for low, high in ends)
            still = question != "standing_pieces" and holds["standing_pieces"][k]
            own.require(still or inside == found[k], f"{question}: another piece")
        yield question


def _joints(own: _Checked) -> Iterator[str]:
    """The order of geometric continuity at every knot inside, up to 2; corners are the joints of order 0."""
    joints, corners = own.items("joints"), own.items("corners")
    if joints is None or corners is None:
        return
    for t in own.breaks[1:-1]:
        order = _order(own.curve, t)
        at = [
            [item for item in items if _of_hex(item["parameter"][0]) <= t <= _of_hex(item["parameter"][2])]
            for items in (joints, corners)
        ]
        own.require(len(at[0]) == 1, f"no joint at {t}")
        if order is not None:
            named = at[0][0]["facts"]["geometric_continuity"]
            own.require(named == order if order < 2 else named >= 2, f"a joint of another order at {t}")
            own.require(bool(at[1]) == (order == 0), f"another corner at {t}")
    yield from ("joints", "corners")


def _order(curve: Curve, t: Fraction) -> int | None:
    """−1, 0, 1 or 2 for more; None where γ′ = 0 on a side."""
    sides = [cartesian(curve, t, left) for left in (True, False)]
    (p, v, a), (q, u, b) = ([[c[k] for c in x] for k in range(3)] for x in sides)
    if p != q:
        return -1
    if not any(v) or not any(u):
        return None
    if any(crossed([[x, x, y] for x, y in zip(v, u, strict=True)])) or _dot(v, u) < 0:
        return 0
    # u is a multiple of v: the vectors of curvature, times ‖v‖²
    share = _dot(u, u) / _dot(v, v)
    first, second = ([x - _dot(d, c) / _dot(d, d) * y for x, y in zip(c, d, strict=True)] for c, d in ((a, v), (b, u)))
    return 2 if [x * share for x in first] == second else 1


# ---- pairs and points


def _pairs(own: _Checked) -> Iterator[str]:
    """The points of a pair are one, or at the distance; a curve along which a coordinate only grows does not meet
    itself.
    """
    for question, other in (("self_intersections", own.curve), ("distance", own.partner)):
        for item in own.items(question) or ():
            places = [_of_hex(item[name][1]) for name in ("parameter", "other parameter")]
            points = [cartesian(c, t, terms=1) for c, t in zip((own.curve, other), places, strict=True)]
            apart = hypot(*(float(x[0] - y[0]) for x, y in zip(*points, strict=True)))
            claimed = float.fromhex(item["distance"][1]) if "distance" in item else 0
            own.require(abs(apart - claimed) <= APART * own.size, f"{question}: a pair at another distance")
    items = own.items("self_intersections")
    if items is not None and (runs_on := _runs_on(own.curve)):
        own.require(not items, "a curve that only runs on meets itself")
    if items or (items is not None and runs_on):
        yield "self_intersections"


def _runs_on(curve: Curve) -> bool:
    """Whether the legs of the control polygon are in an open half-plane: then every line across meets it, and the
    curve, at most once.
    """
    if min(row[-1] for row in curve.rows) <= 0:
        return False
    points = [[x / row[-1] for x in row[:-1]] for row in curve.rows]
    legs = [leg for leg in ([y - x for x, y in zip(p, q, strict=True)] for p, q in pairwise(points)) if any(leg)]

    def is_first(one: list[Fraction]) -> bool:
        turns = [(one[0] * leg[1] - one[1] * leg[0], _dot(one, leg)) for leg in legs]
        return all(turn > 0 or (turn == 0 and along > 0) for turn, along in turns)

    return bool(legs) and len(legs) == len(points) - 1 and any(map(is_first, legs))


def _nearest_points(own: _Checked) -> Iterator[str]:
    """Each point that is named is at the least distance."""
    for item in own.items("nearest") or ():
        point = [float(x / own.partner.rows[0][-1]) for x in own.partner.rows[0][:-1]]
        at = cartesian(own.curve, _of_hex(item["parameter"][1]), terms=1)
        apart = hypot(*(float(x[0]) - y for x, y in zip(at, point, strict=True)))
        flaw = "a nearest point at another distance"
        own.require(abs(apart - float.fromhex(item["distance"][1])) <= APART * own.size, flaw)
    yield from ()


def _winding(own: _Checked) -> Iterator[str]:
    """The winding number as a sum of angles in doubles."""
    if not (items := own.items("winding_number")):
        return
    curve, partner = own.curve, own.partner
    x, y = (float(c / partner.rows[0][-1]) for c in partner.rows[0][:-1])
    places = [a + (b - a) * Fraction(k, ANGLES) for a, b in pairwise(own.breaks) for k in range(ANGLES)]
    rays = [[float(c[0]) - d for c, d in zip(cartesian(curve, t, terms=1), (x, y), strict=True)] for t in places]
    turns = [atan2(a * d - b * c, a * c + b * d) for (a, b), (c, d) in pairwise([*rays, rays[0]])]
    if max(map(abs, turns)) > 2:
        return  # too near the curve for these points
    claimed = float.fromhex(items[0]["value"][1])
    own.require(abs(sum(turns) / (2 * pi) - claimed) < 2.0**-20, "another winding number")
    yield "winding_number"


def _coordinates(items: list[dict[str, Any]]) -> Iterator[list[str] | None]:
    [item] = items
    return (item[axis] for axis in "xyz" if axis in item)


#: The numbers of an answer in the order of those of the exact one.
_NUMBERS: dict[str, Callable[[list[dict[str, Any]]], Iterator[list[str] | None]]] = {
    "value": _coordinates,
    "derivative": _coordinates,
    "torsion": lambda items: (item["torsion"] for item in items),
    "bounding_box": lambda items: (item[name] for item in items for name in ("low", "high")),
    # all of them are at the least distance
    "nearest": lambda items: (item["distance"] for item in items[:1]),
    "distance": lambda items: (item["distance"] for item in items[:1]),
    "intersections": lambda items: (item[name] for item in items for name in ("parameter", "other parameter")),
}


def _rounds(given: list[str] | None, ends: list[Fraction]) -> bool:
    """Whether three doubles are those below, nearest to and above a number in an interval."""
    low, high = ends
    if given is None:
        return True
    below, nearest, above = (float.fromhex(each) for each in given)
    neighbours = below == above or above == nextafter(below, inf)
    return Fraction(below) <= low and high <= Fraction(above) and neighbours and nearest in (float(low), float(high))


def _curve(degree: int, given: dict[str, Any], number: Callable[[str], Fraction]) -> Curve:
    """A curve by numbers of the standard library."""
    weights = [number(w) for w in given["weights"]]
    points = [[number(x) for x in point] for point in given["points"]]
    # a control point of weight zero is a direction
    rows = [[*(x * (w or 1) for x in point), w] for point, w in zip(points, weights, strict=True)]
    return Curve(degree, [number(t) for t in given["knots"]], rows, True, [])
