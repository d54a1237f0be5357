"""Checks packs of vectors again: a seeded sample of the cases, with fractions of the standard library.

The exact answers to `ASKED` are proved right by `workshop.grade.recheck`, and the doubles of the pack must be those
around them. That there are no further inflections is shown by a certificate. Not checked are the other questions, and
of a distance that is not 0 only that its pair is at it, not that no other pair is nearer.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise
from math import atan2, hypot, inf, nextafter, pi
from pathlib import Path
from typing import Any
from zlib import crc32

from exactspline.certificates import check_certificate
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.recheck import Curve, cartesian, recheck
from workshop.grade.runner import curve_data
from workshop.grade.truth import truth

#: Questions of a pack, and what they are called in grading.
ASKED = {"value": "value", "derivative": "first", "nearest": "nearest", "intersections": "meetings"}
#: Points per segment at which the angle around a point is taken.
ANGLES = 64


def checked(place: Path, share: float = 0.1, seed: int = 1) -> tuple[int, int]:
    """Check a share of the cases of a pack; returns how many cases and how many answers were checked.

    Raises `ValueError` with the case for one that is wrong.
    """
    data, chance = json.loads(place.read_text(encoding="utf-8")), random.Random(seed)
    sample = [line for line in data["cases"] if chance.random() < share]
    return len(sample), sum(_answers_checked(line) for line in sample)


def _require(condition: bool, case: dict[str, Any], flaw: str) -> None:
    if not condition:
        raise ValueError(f"{case['key']}: {flaw}")


def _of_hex(given: str) -> Fraction:
    return Fraction(float.fromhex(given))


def _answers_checked(line: dict[str, Any]) -> int:
    case = line["case"]
    body = json.dumps(case, ensure_ascii=True, separators=(",", ":"))
    _require(f"{crc32(body.encode()):08x}" == line["digest"], case, "another digest")
    made, knots = [], case["exact"]["knots"]
    for given in (case, case["partner"]):
        curve = _curve(case["degree"], {"knots": knots} | given["exact"], Fraction)
        doubles = _curve(case["degree"], {"knots": case["doubles"]["knots"]} | given["doubles"], _of_hex)
        _require(curve == doubles, case, "text and doubles differ")
        made.append(curve)
    [curve, partner] = made
    given = case["exact"]
    exact = Case(
        case["key"], "", Nurbs(case["degree"], knots, given["points"], given["weights"]),
        mpq(case["parameter"]["exact"]), dial=case["dial"]["sign"] * case["dial"]["k"] if case["dial"] else 0,
    )  # fmt: skip
    data = curve_data(exact)
    _require([list(map(Fraction, row)) for row in data["partner"]] == partner.rows, case, "another partner")
    count = 0
    for question, asked in (
        ("value", "value"),
        ("derivative", "first"),
        ("nearest", "nearest"),
        ("intersections", "meetings"),
    ):
        claimed = case["answers"][question]
        if claimed["answer"] in ("undefined", "all"):
            continue
        answer = truth(exact, asked)
        if answer is not None:
            recheck(data, case["parameter"]["exact"], asked, answer)
            numbers = list(_NUMBERS[question](claimed["items"]))
            _require(len(numbers) == len(answer["numbers"]), case, f"{question}: another number of numbers")
            fits = all(
                _rounds(each, *map(Fraction, ends)) for each, ends in zip(numbers, answer["numbers"], strict=True)
            )
            _require(fits, case, f"{question}: another number")
            count += 1
    count += _distance(case, curve, partner)
    return count + (
        _inflections(case, exact, curve) + _winding(case, curve, partner) if exact.curve.dimension == 2 else 0
    )


def _coordinates(items: list[dict[str, Any]]) -> Iterator[list[str] | None]:
    [item] = items
    return (item[axis] for axis in "xyz" if axis in item)


#: The numbers of an answer in the order of those of the exact one.
_NUMBERS: dict[str, Callable[[list[dict[str, Any]]], Iterator[list[str] | None]]] = {
    "value": _coordinates,
    "derivative": _coordinates,
    # all of them are at the least distance
    "nearest": lambda items: (item["distance"] for item in items[:1]),
    "intersections": lambda items: (item[name] for item in items for name in ("parameter", "other parameter")),
}


def _rounds(given: list[str] | None, low: Fraction, high: Fraction) -> bool:
    """Whether three doubles are those below, nearest to and above a number in an interval."""
    if given is None:
        return True
    below, nearest, above = (float.fromhex(each) for each in given)
    neighbours = below == above or above == nextafter(below, inf)
    return Fraction(below) <= low and high <= Fraction(above) and neighbours and nearest in (float(low), float(high))


def _distance(case: dict[str, Any], curve: Curve, partner: Curve) -> int:
    """Each pair is as far apart as is claimed, which is 0 where the curves meet."""
    answer, meet = case["answers"]["distance"], case["answers"]["intersections"]["answer"]
    for item in answer.get("items", ()):
        if item["what"] != "pair":
            continue
        places = [_of_hex(item[name][1]) for name in ("parameter", "other parameter")]
        points = [[x[0] for x in cartesian(c, t, terms=1)] for c, t in zip((curve, partner), places, strict=True)]
        apart, claimed = (
            hypot(*(float(x - y) for x, y in zip(*points, strict=True))),
            float.fromhex(item["distance"][1]),
        )
        size = max(abs(float(x)) for row in (*curve.rows, *partner.rows) for x in row)
        _require(abs(apart - claimed) <= 2.0**-40 * size, case, "a pair that is not at the distance")
        _require(meet == "undefined" or (claimed == 0) == (meet != "none"), case, "another distance")
    return int("items" in answer)


def _winding(case: dict[str, Any], curve: Curve, partner: Curve) -> int:
    """The winding number as a sum of angles in doubles."""
    answer = case["answers"]["winding_number"]
    if answer["answer"] != "these":
        return 0
    x, y = (float(c / partner.rows[0][-1]) for c in partner.rows[0][:-1])
    breaks = sorted({t for t in curve.knots if curve.knots[curve.degree] <= t <= curve.knots[-curve.degree - 1]})
    places = [a + (b - a) * Fraction(k, ANGLES) for a, b in pairwise(breaks) for k in range(ANGLES)]
    rays = [[float(c[0]) - d for c, d in zip(cartesian(curve, t, terms=1), (x, y), strict=True)] for t in places]
    turns = [atan2(a * d - b * c, a * c + b * d) for (a, b), (c, d) in pairwise([*rays, rays[0]])]
    if max(map(abs, turns)) > 2:
        return 0  # too near the curve for these points
    claimed = float.fromhex(answer["items"][0]["value"][1])
    _require(abs(sum(turns) / (2 * pi) - claimed) < 2.0**-20, case, "another winding number")
    return 1


def _inflections(case: dict[str, Any], exact: Case, curve: Curve) -> int:
    """Each answer is a certified zero, and each certified zero with a change of sign at a regular point an answer."""
    answer = case["answers"]["inflections"]
    if answer["answer"] in ("undefined", "all"):
        return 0
    certified = truth(exact, "inflections")
    if certified is None:
        return 0
    [certificate] = certified["certificates"]
    check_certificate(certificate)
    roots: Any = certificate["roots"]
    ends = [
        tuple(_of_hex(x) for x in item["parameter"][::2]) for item in answer["items"] if not item["facts"]["by_jump"]
    ]
    for root in roots:
        low, high, (before, behind) = Fraction(root["low"]), Fraction(root["high"]), root["signs"]
        if before is None or behind is None:
            continue  # at an end of the domain
        if low < high:
            _require((_sign(curve, low), _sign(curve, high, left=True)) == (before, behind), case, "another sign")
        if before * behind < 0 and not _may_be_missing(curve, low, high):
            _require(any(a <= high and low <= b for a, b in ends), case, f"an inflection in [{low}, {high}] is missing")
    for a, b in ends:
        near = [root for root in roots if a <= Fraction(root["high"]) and Fraction(root["low"]) <= b]
        _require(bool(near), case, f"an inflection at {float(a)} is invented")
    return 1


def _may_be_missing(curve: Curve, low: Fraction, high: Fraction) -> bool:
    """Whether a zero is at a knot or where γ′ = 0: there is no inflection then, or one by other rules."""
    if any(low <= t <= high for t in curve.knots):
        return True
    return low == high and not any(x[1] for x in cartesian(curve, low))


def _sign(curve: Curve, t: Fraction, left: bool = False) -> int:
    """The sign of ``[γ′ γ″]``."""
    (_, x1, x2, _), (_, y1, y2, _) = cartesian(curve, t, left)
    bend = x1 * y2 - y1 * x2
    return (bend > 0) - (bend < 0)


def _curve(degree: int, given: dict[str, Any], number: Callable[[str], Fraction]) -> Curve:
    """A curve by numbers of the standard library."""
    weights = [number(w) for w in given["weights"]]
    points = [[number(x) for x in point] for point in given["points"]]
    # a control point of weight zero is a direction
    rows = [[*(x * (w or 1) for x in point), w] for point, w in zip(points, weights, strict=True)]
    return Curve(degree, [number(t) for t in given["knots"]], rows, True, [])
