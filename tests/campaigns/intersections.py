"""Many pairs of plane curves against an oracle that shares no code: seeded, the result recorded.

python -m tests.campaigns.intersections --pairs 10000 --seed 1 --record campaign.json
python -m tests.campaigns.intersections --pairs 1 --seed 4711 --family tangent       one case again

The oracle eliminates by resultants in powers of the parameters and tries all pairs of complex roots
(`tests.support.elimination_oracle`), segment by segment. Beside the points, contact orders and common arcs are compared
where the family knows them. In the family `itself` a curve is met with itself.
"""

import argparse
import json
import sys
import time
from collections import Counter
from fractions import Fraction
from itertools import pairwise
from math import comb
from pathlib import Path
from random import Random

from exactspline import Nurbs
from exactspline.errors import ExactSplineError, WeightError
from exactspline.geometry.pairs.intersections import intersections, self_intersections
from tests.support.elimination_oracle import common_points

#: Parameters of the answer and of the oracle are the same below this distance.
NEAR = 1e-9
#: What is not decided, and named: no difference, but counted.
LEFT_OUT = "left out"
#: Per mille of the pairs of a family that may be left out.
CEILING = 1


# ---- curves by rows of homogeneous control points, or by several segments of one degree, each by its rows


def segments_of(given):
    return given if isinstance(given[0], list) else [given]


def curve(given):
    """The segments of a curve follow each other from 0, 1, 2, …; each begins with the last row of the one before."""
    segments = segments_of(given)
    n, count = len(segments[0]) - 1, len(segments)
    rows = [*segments[0], *[row for segment in segments[1:] for row in segment[1:]]]
    inner = [k for k in range(1, count) for _ in range(n)]
    return Nurbs.from_homogeneous(n, [0] * (n + 1) + inner + [count] * (n + 1), rows)


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
    n = degree or random.choice([1, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5])
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


def doubles(random):
    """Control points of 17 digits, of any size."""
    size = 2.0 ** random.randint(-30, 30)

    def point():
        return Fraction(random.uniform(-1, 1) * size), Fraction(random.uniform(-1, 1) * size), Fraction(1)

    first, second = ([point() for _ in range(random.randint(2, 5))] for _ in range(2))
    if random.random() < 0.3:  # weights, of 17 digits, too
        weights = [Fraction(random.uniform(0.5, 2)) for _ in first]
        first = [(x * w, y * w, w) for (x, y, _), w in zip(first, weights, strict=True)]
    return first, second, {}


def any_segments(random, degree, count):
    """Segments that follow each other, at some knots with one tangent, perhaps in the end at the beginning."""
    draw = random.choice([lambda: Fraction(random.randint(-3, 3)), lambda: number(random)])
    points = [(draw(), draw(), Fraction(1)) for _ in range(degree * count + 1)]
    if degree > 1:
        for k in range(degree, degree * count, degree):
            if random.random() < 0.5:
                points[k] = tuple((a + b) / 2 for a, b in zip(points[k - 1], points[k + 1], strict=True))
    if random.random() < 0.4:
        points[-1] = points[0]
    if random.random() < 0.3:
        points = [tuple(x * w for x in p) for p, w in zip(points, weights_that_close(random, len(points)), strict=True)]
    return [points[degree * k : degree * k + degree + 1] for k in range(count)]


def weights_that_close(random, count):
    weights = [Fraction(random.randint(1, 3)) for _ in range(count)]
    weights[-1] = weights[0]
    return weights


def through_knots(random):
    """Curves of several segments, of which one passes through a knot of the other, at its own knot, its end or between,
    perhaps with its tangent; some knots are inserted where both neighbours are one curve.
    """
    first, second = (any_segments(random, random.randint(1, 3), random.randint(2, 3)) for _ in range(2))
    for given in (first, second):
        if random.random() < 0.3:
            given[:1] = halved(given[0])
    i, j = (random.randrange(1, len(given)) for given in (first, second))
    target, shift = first[i][0], second[j][0]
    moved = tuple(a / target[2] - b / shift[2] for a, b in zip(target[:2], shift[:2], strict=True))
    if random.random() < 0.7:  # knot upon knot
        second = [[(x + w * moved[0], y + w * moved[1], w) for x, y, w in segment] for segment in second]
    elif random.random() < 0.5:  # a line through the knot
        a, b = random.randint(-2, 2), random.randint(1, 3)
        x, y = (c / target[2] for c in target[:2])
        second = [[(x - a, y - b, Fraction(1)), (x + 2 * a, y + 2 * b, Fraction(1))]]
    return first, second, {}


def halved(rows):
    """Both halves of a segment, by de Casteljau's algorithm."""
    left, right = [rows[0]], [rows[-1]]
    while len(rows) > 1:
        rows = [tuple((a + b) / 2 for a, b in zip(p, q, strict=True)) for p, q in pairwise(rows)]
        left, right = [*left, rows[0]], [rows[-1], *right]
    return [left, right]


def itself(random):
    """A curve of one or several segments with itself."""
    kind = random.random()
    if kind < 0.5:
        given = [any_rows(random, random.choice([3, 3, 4, 4, 5]))]
    elif kind < 0.6:
        given = [through_a_node(random)[0]]
    else:
        given = any_segments(random, random.randint(1, 3), random.randint(2, 4))
    if random.random() < 0.3:
        given = [*halved(given[0]), *given[1:]]
    return given, given, {"itself": True}


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
    for family in (
        of_no_kind,
        doubles,
        tangent,
        nearly_touching,
        through_ends,
        through_knots,
        overlapping,
        through_a_node,
        circles,
        elevated,
        itself,
    )
}


# ---- comparison


def expected_points(first, second, *, alone):
    """The oracle's points of all pairs of segments, and whether two of these have a common component. With itself, a
    curve has only pairs s < t, and neighbouring segments do not meet in their common knot.
    """
    found, shared = [], False
    for i, one in enumerate(first):
        for j, other in enumerate(second):
            if alone and j < i:
                continue
            points, component = common_points(one, other)
            shared |= component
            points = [e._replace(s=i + e.s, t=j + e.t) for e in points]
            found += [e for e in points if e.s < e.t] if alone else points
    return found, shared


def at_knots_once(expected, found, curves, *, alone):
    """A point at a knot counts once, the seam of a closed curve at its start, and not where an arc in common ends."""

    def from_seam(pair):
        s, t = (0.0 if c.closed and x == c.domain.high else x for c, x in zip(curves, pair, strict=True))
        return (min(s, t), max(s, t)) if alone else (s, t)

    def near(one, other):
        return all(abs(x - y) < NEAR for x, y in zip(one, other, strict=True))

    ends = [from_seam(map(float, pair)) for arc in found.everywhere for pair in zip(arc.first, arc.second, strict=True)]
    kept = []
    for e in expected:
        pair = from_seam((e.s, e.t))
        if e.s.is_integer() or e.t.is_integer():
            if any(near(pair, end) for end in ends) or (alone and pair[0] == pair[1]):
                continue
            if (k := next((k for k, x in enumerate(kept) if near(pair, x[:2])), None)) is not None:
                kept[k] = kept[k]._replace(of_s=max(kept[k].of_s, e.of_s), of_t=max(kept[k].of_t, e.of_t))
                continue
        kept.append(e._replace(s=pair[0], t=pair[1]))
    return sorted(kept)


def difference(first, second, known):
    """What is wrong with the answer for two curves, "" if nothing is, and how many points it has."""
    alone = "itself" in known
    curves = curve(first), curve(second)
    found = self_intersections(curves[0]) if alone else intersections(*curves)
    if found.undecided:
        return LEFT_OUT, 0
    expected, shared = expected_points(segments_of(first), segments_of(second), alone=alone)
    expected = at_knots_once(expected, found, curves, alone=alone)
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
