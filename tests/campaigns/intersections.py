"""Many pairs of plane curves against an oracle that shares no code: seeded, the result recorded.

python -m tests.campaigns.intersections --pairs 10000 --seed 1 --record campaign.json
python -m tests.campaigns.intersections --pairs 1 --seed 4711 --family tangent       one case again

The oracle eliminates by resultants in powers of the parameters and tries all pairs of complex roots
(`tests.support.elimination_oracle`). Beside the points, contact orders and common arcs are compared where the family
knows them.
"""

import argparse
import json
import sys
import time
from collections import Counter
from fractions import Fraction
from math import comb
from pathlib import Path
from random import Random

from exactspline import Nurbs
from exactspline.errors import ExactSplineError, WeightError
from exactspline.geometry.intersections import intersections
from tests.support.elimination_oracle import common_points

#: Parameters of the answer and of the oracle are the same below this distance.
NEAR = 1e-9
#: What is not decided, and named: no difference, but counted.
LEFT_OUT = "left out"
#: Per mille of the pairs of a family that may be left out.
CEILING = 1


# ---- curves by rows of homogeneous control points


def curve(rows):
    n = len(rows) - 1
    return Nurbs.from_homogeneous(n, [0] * (n + 1) + [1] * (n + 1), rows)


def bezier_rows(polynomials):
    """Homogeneous rows from the coefficients of x, y, w in powers of the parameter."""
    n = max(map(len, polynomials)) - 1
    padded = [[*map(Fraction, p), *[Fraction(0)] * (n + 1 - len(p))] for p in polynomials]
    return [
        tuple(sum(Fraction(comb(i, j), comb(n, j)) * p[j] for j in range(i + 1)) for p in padded) for i in range(n + 1)
    ]


def mapped(rows, matrix):
    return [tuple(sum(a * x for a, x in zip(line, row, strict=True)) for line in matrix) for row in rows]


def affine(random):
    """A random affine map with a determinant that is not 0."""
    while True:
        a, b, c, d = (Fraction(random.randint(-5, 5)) for _ in range(4))
        if a * d != b * c:
            e, f = (Fraction(random.randint(-5, 5)) for _ in range(2))
            return [(a, b, e), (c, d, f), (0, 0, 1)]


def reparametrised(rows, random, *, rational):
    """The curve over a part of its parameters, perhaps reversed, by a Möbius map: rows, and the map of [0, 1]."""
    n = len(rows) - 1
    a, b = sorted(random.sample([Fraction(k, 8) for k in range(-2, 11)], 2))
    if random.random() < 0.5:
        a, b = b, a
    m = Fraction(random.randint(1, 4), random.randint(1, 4)) if rational else Fraction(1)
    # s = ((1 − t) a + t m b)/((1 − t) + t m)
    numerator, denominator = [a, m * b - a], [Fraction(1), m - 1]
    columns = []
    for k in range(3):
        total = [Fraction(0)]
        for i, row in enumerate(rows):
            term = [row[k] * comb(n, i)]
            for _ in range(i):
                term = multiplied(term, numerator)
            for _ in range(n - i):
                term = multiplied(term, [x - y for x, y in zip(denominator, numerator, strict=True)])
            total = added(total, term)
        columns.append(total)
    return bezier_rows(columns), (a, b)


def multiplied(p, q):
    product = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            product[i + j] += x * y
    return product


def added(p, q):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


# ---- families: two curves by rows, and what is known of them


def number(random):
    kind = random.choice(["small", "small", "integer", "double", "decimal"])
    if kind == "small":
        return Fraction(random.randint(-2, 2))
    if kind == "integer":
        return Fraction(random.randint(-100, 100))
    return Fraction(random.uniform(-1, 1)) if kind == "double" else Fraction(random.randint(-9999, 9999), 1000)


def any_rows(random, degree=None):
    n = degree or random.choice([1, 2, 2, 3, 3, 3, 4])
    kind = random.choice(["small", "one", "one"])
    weights = [Fraction(random.randint(1, 4)) if random.random() < 0.3 else Fraction(1) for _ in range(n + 1)]
    draw = (lambda r: Fraction(r.randint(-2, 2))) if kind == "small" else number
    return [(draw(random) * w, draw(random) * w, w) for w in weights]


def of_no_kind(random):
    return any_rows(random), any_rows(random), {}


def tangent(random):
    """Two graphs that differ by ``c (t − t₀)ᵏ``."""
    k, n = random.randint(2, 6), random.randint(1, 3)
    t0 = Fraction(random.randint(1, 7), 8)
    f = [Fraction(random.randint(-4, 4)) for _ in range(n + 1)]
    power = [Fraction(random.choice([-3, -1, 1, 2]))]
    for _ in range(k):
        power = multiplied(power, [-t0, Fraction(1)])
    matrix = affine(random)
    first, second = (mapped(bezier_rows([[0, 1], g, [1]]), matrix) for g in (f, added(f, power)))
    return first, second, {"multiplicity": (t0, k)}


def nearly_touching(random):
    """A graph and its tangent, moved by a power of two to one side or the other."""
    t0, power = Fraction(random.randint(1, 7), 8), random.randint(20, 90)
    shift = Fraction(random.choice([-1, 1]), 1 << power)
    first = bezier_rows([[0, 1], [t0 * t0, -2 * t0, 1], [1]])
    second = bezier_rows([[0, 1], [shift], [1]])
    matrix = affine(random)
    return mapped(first, matrix), mapped(second, matrix), {"count": 2 if shift > 0 else 0}


def through_ends(random):
    """The second curve begins or ends at an end or an inner point of the first, or has its tangent there."""
    first, second = any_rows(random), any_rows(random)
    n = len(first) - 1
    t = random.choice([Fraction(0), Fraction(1), Fraction(1, 2), Fraction(1, 3)])
    point = tuple(sum(comb(n, i) * t**i * (1 - t) ** (n - i) * row[k] for i, row in enumerate(first)) for k in range(3))
    at = random.choice([0, -1])
    second[at] = point
    if len(second) > 2 and t == 0 and random.random() < 0.4:
        second[1 if at == 0 else -2] = tuple(a + 2 * b for a, b in zip(first[0], first[1], strict=True))
    return first, second, {}


def overlapping(random):
    """The same curve over other parameters, polynomial or by a Möbius map."""
    while True:
        first = any_rows(random, random.choice([1, 2, 3, 3, 4]))
        second, (a, b) = reparametrised(first, random, rational=random.random() < 0.5)
        try:
            curve(second)
        except WeightError:  # a pole of the first curve, outside its segment
            continue
        return first, second, {"arc": (a, b)}


def through_a_node(random):
    """A cubic with a node (or a cusp) at the origin, and a curve through the origin, perhaps along a branch."""
    a = Fraction(random.choice([0, 1, 1, 2]), 2)
    # x = u² − a², y = u (u² − a²) with u = 3 t − 3/2
    u = [Fraction(-3, 2), Fraction(3)]
    x = added(multiplied(u, u), [-a * a])
    first = bezier_rows([x, multiplied(u, x), [1]])
    t0 = Fraction(random.randint(0, 4), 4)
    line = [-t0, Fraction(1)]
    p, q = ([Fraction(random.randint(-3, 3)) for _ in range(random.randint(1, 3))] for _ in range(2))
    if random.random() < 0.4:
        q = multiplied(p, [a])  # along the branch y = a x
        q = added(q, multiplied(line, [Fraction(random.randint(-2, 2))]))
    second = bezier_rows([multiplied(line, p), multiplied(line, q), [1]])
    matrix = affine(random)
    return mapped(first, matrix), mapped(second, matrix), {}


def circles(random):
    """Arcs of circles, among them coaxial, tangent, concentric and equal ones."""
    arcs = []
    for _ in range(2):
        r, x = Fraction(random.randint(1, 3)), Fraction(random.randint(-3, 3))
        # x + r (1 − u²)/(1 + u²), 2 r u/(1 + u²) with u from α to β
        alpha, beta = sorted(random.sample([Fraction(k, 2) for k in range(-5, 6)], 2))
        u = [alpha, beta - alpha]
        square = multiplied(u, u)
        w = added([Fraction(1)], square)
        arcs.append(
            bezier_rows(
                [
                    added([x * c for c in w], [r * c for c in added([Fraction(1)], [-c for c in square])]),
                    [2 * r * c for c in u],
                    w,
                ]
            )
        )
    return arcs[0], arcs[1], {}


def elevated(random):
    """A curve of no kind with its degree raised, against another."""
    first, second = any_rows(random, random.choice([1, 2])), any_rows(random)
    n = len(first) - 1
    raised = [
        tuple(
            Fraction(i, n + 1) * (first[i - 1][k] if i else 0)
            + (1 - Fraction(i, n + 1)) * (first[i][k] if i <= n else 0)
            for k in range(3)
        )
        for i in range(n + 2)
    ]
    return raised, second, {}


FAMILIES = {
    family.__name__: family
    for family in (of_no_kind, tangent, nearly_touching, through_ends, overlapping, through_a_node, circles, elevated)
}


# ---- comparison


def seam_once(expected, found, curves):
    """The seam of a closed curve counts once, at its start; and not where an arc in common ends at it."""

    def from_seam(pair):
        return tuple(0.0 if c.closed and x == 1 else x for c, x in zip(curves, pair, strict=True))

    ends = [from_seam(map(float, pair)) for arc in found.everywhere for pair in zip(arc.first, arc.second, strict=True)]
    merged = {}
    for e in expected:
        s, t = from_seam((e.s, e.t))
        at_seam = any(c.closed and x in (0, 1) for c, x in zip(curves, (e.s, e.t), strict=True))
        if not (at_seam and any(abs(s - x) < NEAR and abs(t - y) < NEAR for x, y in ends)):
            merged.setdefault((s, t), e._replace(s=s, t=t))
    return sorted(merged.values())


def difference(first, second, known):
    """What is wrong with the answer for two curves, "" if nothing is, and how many points it has."""
    curves = curve(first), curve(second)
    found = intersections(*curves)
    if found.left_out:
        return LEFT_OUT, 0
    expected, shared = common_points(first, second)
    expected = seam_once(expected, found, curves)
    ours = sorted((float(p.first), float(p.second), p.multiplicity) for p in found if p.multiplicity is not None)
    same = len(ours) == len(expected) and all(
        abs(e.s - s) < NEAR and abs(e.t - t) < NEAR and times <= min(e.of_s, e.of_t)
        for e, (s, t, times) in zip(expected, ours, strict=True)
    )
    if not same:
        return f"points: {ours} instead of {expected}", len(ours)
    if found.everywhere and not shared:
        return f"arcs {found.everywhere} without a common component", len(ours)
    if "multiplicity" in known:
        t0, times = known["multiplicity"]
        at = [p.multiplicity for p in found if p.first == t0 and p.second == t0]
        if at != [times]:
            return f"multiplicity {at} instead of {times} at {t0}", len(ours)
    if "count" in known and len(found) != known["count"]:
        return f"{len(found)} points instead of {known['count']}", len(ours)
    if "arc" in known and (wrong := _arc_is_wrong(found, *known["arc"])):
        return wrong, len(ours)
    return "", len(ours)


def _arc_is_wrong(found, a, b):
    """The second curve is the first from parameter a to parameter b."""
    low, high = max(min(a, b), Fraction(0)), min(max(a, b), Fraction(1))
    covered = [sorted(map(float, arc.first)) for arc in found.everywhere]
    # an arc of a straight curve that turns back is in pieces
    whole = covered and min(s for s, _ in covered) < low + NEAR and max(t for _, t in covered) > high - NEAR
    if low >= high or whole:
        return ""
    return f"arcs {found.everywhere}, where the second is the first from {a} to {b}"


def campaign(pairs, seed, family=""):
    """Run it: the counts, and the cases that differ."""
    counts, left_out, wrong, slow, points, began = Counter(), Counter(), [], 0.0, 0, time.process_time()
    names = [family] if family else list(FAMILIES)
    for number_of_case in range(seed, seed + pairs):
        random = Random(number_of_case)
        name = random.choice(names)
        first, second, known = FAMILIES[name](random)
        start = time.process_time()
        try:
            told, count = difference(first, second, known)
        except ExactSplineError as error:
            told, count = f"{type(error).__name__}: {error}", 0
        slow, points = max(slow, time.process_time() - start), points + count
        counts[name] += 1
        if told == LEFT_OUT:
            left_out[name] += 1
        elif told:
            wrong.append({"seed": number_of_case, "family": name, "difference": told})
    return {
        "pairs": pairs,
        "seed": seed,
        "families": dict(counts),
        "points": points,
        "left_out": dict(left_out),
        "differences": wrong,
        "longest": round(slow, 3),
        "seconds": round(time.process_time() - began, 1),
    }


def above_ceiling(found):
    """The families of which more is left out than may be."""
    return [name for name, n in found["left_out"].items() if 1000 * n > CEILING * found["families"][name]]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pairs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--family", default="")
    parser.add_argument("--record", type=Path)
    chosen = parser.parse_args()
    found = campaign(chosen.pairs, chosen.seed, chosen.family)
    if chosen.record:
        chosen.record.write_text(json.dumps(found, indent=2, ensure_ascii=False), encoding="utf-8")
    print(json.dumps(found, indent=2, ensure_ascii=False))
    return int(bool(found["differences"] or above_ceiling(found)))


if __name__ == "__main__":
    sys.exit(main())
