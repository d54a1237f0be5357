"""Checks packs of vectors again. Numbers of a seeded sample of cases are recomputed with fractions of the standard
library by the recursion of de Boor; that there are no further inflections is shown by a certificate, whose checker uses
nothing but the standard library either.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from math import inf, nextafter
from pathlib import Path
from typing import Any
from zlib import crc32

from exactspline.batch.oracle import oracle
from exactspline.certificates import check_certificate
from exactspline.splines.nurbs import Nurbs

Series = list[Fraction]
#: Terms of a Taylor series: the value and two derivatives.
TERMS = 3


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
    curve = Curve(case["degree"], case["exact"], Fraction)
    _require(curve == Curve(case["degree"], case["doubles"], _of_hex), case, "text and doubles differ")
    truth, count = curve.jets(Fraction(case["parameter"]["exact"])), 0
    for question, order in (("value", 0), ("derivative", 1)):
        if case["answers"][question]["answer"] == "these":
            [item] = case["answers"][question]["items"]
            for axis, series in zip("xyz", truth, strict=False):
                _require(_rounds(item[axis], series[order]), case, f"{question}: {axis}")
            count += 1
    return count + (_inflections(case, curve) if len(truth) == 2 else 0)


def _rounds(given: list[str] | None, x: Fraction) -> bool:
    """Whether three doubles are those below, nearest to and above a number."""
    if given is None:
        return True
    below, nearest, above = (float.fromhex(each) for each in given)
    neighbours = below == above or above == nextafter(below, inf)
    return Fraction(below) <= x <= Fraction(above) and neighbours and nearest == float(x)


def _inflections(case: dict[str, Any], curve: Curve) -> int:
    """Each answer is a certified zero, and each certified zero with a change of sign at a regular point an answer."""
    answer = case["answers"]["inflections"]
    if answer["answer"] in ("undefined", "all"):
        return 0
    given = case["exact"]
    [certificate, *_] = oracle(
        Nurbs(case["degree"], given["knots"], given["points"], given["weights"]), "inflections"
    ).certificates
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
            _require((_sign(curve.bend(low)), _sign(curve.bend(high))) == (before, behind), case, "another sign")
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
    return low == high and not any(series[1] for series in curve.jets(low))


def _sign(x: Fraction) -> int:
    return (x > 0) - (x < 0)


class Curve:
    """A curve by numbers of the standard library."""

    def __init__(self, degree: int, given: dict[str, Any], number: Callable[[str], Fraction]) -> None:
        self.degree, self.knots = degree, [number(t) for t in given["knots"]]
        weights = [number(w) for w in given["weights"]]
        points = [[number(x) for x in point] for point in given["points"]]
        # a control point of weight zero is a direction
        self.rows = [[*(x * (w or 1) for x in point), w] for point, w in zip(points, weights, strict=True)]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Curve) and (self.knots, self.rows) == (other.knots, other.rows)

    __hash__ = None  # type: ignore[assignment]  # curves are compared by value

    def jets(self, t: Fraction) -> list[Series]:
        """Value and derivatives of the coordinates."""
        *tops, w = self._homogeneous(t)
        found = []
        for p in tops:
            series = Series()
            for k in range(TERMS):
                series.append((p[k] - sum(w[i] * series[k - i] for i in range(1, k + 1))) / w[0])
            found.append([series[0], series[1], 2 * series[2]])
        return found

    def bend(self, t: Fraction) -> Fraction:
        """``[γ′ γ″]``."""
        (_, x1, x2), (_, y1, y2) = self.jets(t)
        return x1 * y2 - y1 * x2

    def _homogeneous(self, t: Fraction) -> list[Series]:
        """Taylor series of the homogeneous coordinates, by de Boor's recursion on series."""
        n, knots = self.degree, self.knots
        spans = [j for j in range(n, len(knots) - n - 1) if knots[j] < knots[j + 1]]
        j = next((j for j in spans if knots[j] <= t < knots[j + 1]), spans[-1])
        points = [[[x] + [Fraction(0)] * (TERMS - 1) for x in self.rows[j - n + i]] for i in range(n + 1)]
        for r in range(1, n + 1):
            for i in range(n, r - 1, -1):
                a, b = knots[j - n + i], knots[j + 1 + i - r]
                points[i] = [
                    _mixed(old, new, (t - a) / (b - a), 1 / (b - a))
                    for old, new in zip(points[i - 1], points[i], strict=True)
                ]
        return points[n]


def _mixed(old: Series, new: Series, share: Fraction, slope: Fraction) -> Series:
    """``old + (share + slope h) (new − old)`` as a series in h."""
    step = [q - p for p, q in zip(old, new, strict=True)]
    return [p + share * step[k] + (slope * step[k - 1] if k else 0) for k, p in enumerate(old)]
