"""Reads a pack of vectors: `python reader.py near.json`. The standard library of Python only."""

import json
import sys
import zlib


def de_boor(degree: int, knots: list[float], rows: list[list[float]], t: float) -> list[float]:
    """The homogeneous point at t, in doubles."""
    spans = [j for j in range(degree, len(knots) - degree - 1) if knots[j] < knots[j + 1]]
    j = next((j for j in spans if knots[j] <= t < knots[j + 1]), spans[-1])
    d = [list(rows[j - degree + i]) for i in range(degree + 1)]
    for r in range(1, degree + 1):
        for i in range(degree, r - 1, -1):
            a, b = knots[j - degree + i], knots[j + 1 + i - r]
            s = (t - a) / (b - a)
            d[i] = [(1 - s) * p + s * q for p, q in zip(d[i - 1], d[i])]
    return d[degree]


def homogeneous(given: dict) -> list[list[float]]:
    """The control points times their weights, and the weights."""
    weights = [float.fromhex(w) for w in given["weights"]]
    return [[*(float.fromhex(x) * w for x in p), w] for p, w in zip(given["points"], weights)]


def main(path: str) -> None:
    """Count cases, answers by kind, points that de Boor's recursion in doubles rounds otherwise, and the points that a
    curve and its partner have in common; `apart` those at which they differ by more than 2⁻⁴⁰ of the size.
    """
    counts = {"cases": 0, "damaged": 0, "none": 0, "these": 0, "all": 0, "undefined": 0}
    counts |= {"inexact": 0, "meetings": 0, "apart": 0}
    with open(path, encoding="utf-8") as stream:
        lines = json.load(stream)["cases"]
    for line in lines:
        case = line["case"]
        body = json.dumps(case, ensure_ascii=True, separators=(",", ":")).encode()
        counts["cases"] += 1
        counts["damaged"] += f"{zlib.crc32(body):08x}" != line["digest"]
        for answer in case["answers"].values():
            counts[answer["answer"]] += 1
        number = float.fromhex
        rows, partner = homogeneous(case["doubles"]), homogeneous(case["partner"]["doubles"])
        knots, t = [number(k) for k in case["doubles"]["knots"]], number(case["parameter"]["double"])
        *point, w = de_boor(case["degree"], knots, rows, t)
        truth = case["answers"]["value"]["items"][0]
        counts["inexact"] += any(x / w != number(truth[axis][1]) for axis, x in zip("xyz", point))
        size = max(abs(x) for row in rows for x in row)
        for item in case["answers"]["intersections"].get("items", []):
            if "parameter" in item:
                counts["meetings"] += 1
                *p, v = de_boor(case["degree"], knots, rows, number(item["parameter"][1]))
                *q, w = de_boor(case["degree"], knots, partner, number(item["other parameter"][1]))
                counts["apart"] += any(abs(x / v - y / w) > 2**-40 * size for x, y in zip(p, q))
    print(" ".join(f"{name} {count}" for name, count in counts.items()))


main(sys.argv[1])
