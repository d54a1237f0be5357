"""Curves near a curve, drawn at random, against what is said of all of them:
``python -m tests.campaigns.nearby 1000``; and how much farther away than proved features vanish:
``python -m tests.campaigns.nearby --pessimism 100``.

Of every curve near it, the sign of κ and of κ′ at both ends of each interval that has a certain feature is computed by
its own formula in 60 digits, from control points by de Boor's algorithm; and every feature that the curve has, found in
exact arithmetic, must lie in an interval that was listed. The exit status is 1 where anything is different, or where
more is refused, or possible only, than the ceilings allow. The result
of the last whole run stands in `docs/as-meant.md`.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import inf
from random import Random

from gmpy2 import mpq
from mpmath import mp, mpf

from exactspline import Nurbs, analyse
from exactspline.errors import ExactSplineError
from exactspline.geometry.kinds import FeatureKind
from exactspline.geometry.nearby import NearbyFeature, features_nearby
from exactspline.geometry.stability import stability

SEED = 2032
#: Per mille of the curves that may be refused: no weight comes near 0 within these distances.
REFUSED = 1
#: Per cent of the features listed that may be possible only: what is nearer to vanishing than the distance drawn, which
#: may be a tenth of the curve.
POSSIBLE = 35
#: Curves near each curve.
DRAWN = 4
ZERO = (FeatureKind.INFLECTION, FeatureKind.UNDULATION)
EXTREME = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM, FeatureKind.STATIONARY)


def drawn(random: Random) -> Nurbs:
    """A curve of degree 2 to 5 with one to four segments, polynomial or rational, smooth or with corners."""
    degree, inner = random.randint(2, 5), random.randint(0, 3)
    knots = [0] * (degree + 1)
    for t in range(1, inner + 1):
        knots += [t] * random.choice([1, 1, 1, degree - 1, degree])
    knots += [inner + 1] * (degree + 1)
    setting = random.choice([lambda: mpq(random.randint(-9, 9)), lambda: mpq(random.uniform(-1, 1))])
    points = [(setting(), setting()) for _ in range(len(knots) - degree - 1)]
    weights = [mpq(random.randint(8, 24), 8) for _ in points] if random.random() < 0.5 else None
    return Nurbs(degree, knots, points, weights)


def moved(curve: Nurbs, epsilon: mpq, random: Random) -> Nurbs:
    """A curve within epsilon: often at the corners of what is allowed."""

    def step() -> mpq:
        return epsilon * (random.choice([-1, 1]) if random.random() < 0.7 else mpq(random.randint(-99, 99), 99))

    points = [tuple(x + step() for x in p) for p in curve.control_points]
    weights = None if curve.polynomial else [w + step() for w in curve.weights]
    return Nurbs(curve.degree, curve.knots, points, weights)


def blossom(curve: Nurbs, t: mpq, left: bool) -> list[list[mpf]]:
    """Derivatives of order 0 to 3 of the homogeneous coordinates, by de Boor's algorithm on differences."""
    d, knots = curve.degree, list(curve.knots)
    j = max(i for i in range(d, len(knots) - d - 1) if (knots[i] < t if left else knots[i] <= t) or i == d)
    while knots[j] == knots[j + 1]:
        j += 1
    rows = [[*(x * w for x in p), w] for p, w in zip(curve.control_points, curve.weights, strict=True)]
    net, found = rows[j - d : j + 1], []
    for order in range(4):
        n = d - order
        if n < 0:
            found.append([mpf(0)] * 3)
            continue
        points = [list(point) for point in net]
        base = j - n
        for r in range(1, n + 1):
            for i in range(n, r - 1, -1):
                a, b = knots[base + i], knots[base + i + n + 1 - r]
                s = (t - a) / (b - a)
                points[i] = [(1 - s) * x + s * y for x, y in zip(points[i - 1], points[i], strict=True)]
        found.append([mpf(int(x.numerator)) / int(x.denominator) for x in points[n]])
        net = [
            [n * (y - x) / (knots[base + i + n + 1] - knots[base + i + 1]) for x, y in zip(p, q, strict=True)]
            for i, (p, q) in enumerate(pairwise(net))
        ]
    return found


def signs(curve: Nurbs, t: mpq, left: bool) -> tuple[int, int]:
    """The signs of κ and κ′, by the quotient rule."""
    rows = blossom(curve, t, left)
    w = [row[2] for row in rows]
    jets = []
    for axis in (0, 1):
        p = [row[axis] for row in rows]
        value = [p[0] / w[0]]
        value.append((p[1] - value[0] * w[1]) / w[0])
        value.append((p[2] - 2 * value[1] * w[1] - value[0] * w[2]) / w[0])
        value.append((p[3] - 3 * value[2] * w[1] - 3 * value[1] * w[2] - value[0] * w[3]) / w[0])
        jets.append(value)
    (_, x1, x2, x3), (_, y1, y2, y3) = jets
    cross, speed = x1 * y2 - y1 * x2, x1 * x1 + y1 * y1
    slope = (x1 * y3 - y1 * x3) * speed - 3 * cross * (x1 * x2 + y1 * y2)
    return int(mp.sign(cross)), int(mp.sign(slope))


def changes(curve: Nurbs, found: NearbyFeature) -> bool:
    """Whether the sign changes over the interval of a certain feature, from a little before it to a little behind."""
    (a, b), which = found.place, int(found.kind in EXTREME)
    before, behind = signs(curve, a, left=True)[which], signs(curve, b, left=False)[which]
    if before == 0 or behind == 0:
        return True
    return before == -behind and (which == 0 or (before == 1) == (found.kind is FeatureKind.MAXIMUM))


def wrong(curve: Nurbs, near: Nurbs, said: Sequence[NearbyFeature]) -> str:
    """What a curve near another has that was not said, or lacks; "" for nothing."""
    for found in said:
        if found.certain and found.kind in (*ZERO, *EXTREME) and not changes(near, found):
            return f"no {found.kind} in {found.place}"
    facts = analyse(near)
    for kinds, answer in ((ZERO, facts.inflections), (EXTREME, facts.critical_points)):
        places = [found.place for found in said if found.kind in kinds or found.kind is FeatureKind.STOP]
        for feature in answer:
            low, high = feature.root.refine(20)
            if not any(low <= place.high and place.low <= high for place in places):
                return f"{feature} is in no interval"
        for found in said:
            if found.single and found.kind in kinds:
                inside = [f for f in answer if f.root >= found.place.low and f.root <= found.place.high]
                if len(inside) != 1:
                    return f"{len(inside)} zeros where one was said, in {found.place}"
    corners = [joint.parameter for joint in facts.corners]
    listed = {found.place.low: found for found in said if found.kind is FeatureKind.CORNER}
    if any(t not in listed for t in corners):
        return f"a corner that was not listed, of {corners}"
    if any(found.certain and t not in corners for t, found in listed.items()):
        return "no corner where one was said"
    return ""


def campaign(count: int, seed: int = SEED) -> Counter[str]:
    """Random curves, each with a few near it at a random distance."""
    random, tally = Random(seed), Counter[str]()
    mp.dps = 60
    for _ in range(count):
        curve, epsilon = drawn(random), mpq(1, 10 ** random.randint(1, 14))
        try:
            said = features_nearby(curve, epsilon)
        except ExactSplineError:
            tally["refused: weights may vanish"] += 1
            continue
        tally["curves"] += 1
        tally["certain features"] += sum(found.certain for found in said)
        tally["possible features"] += sum(not found.certain for found in said)
        for _ in range(DRAWN):
            tally["curves near them"] += 1
            if what := wrong(curve, moved(curve, epsilon, random), said):
                tally[f"WRONG: {what}, {curve!r}"] += 1
    return tally


def above_ceiling(tally: Mapping[str, int]) -> list[str]:
    """What there is more of than may be."""
    refused, possible = tally.get("refused: weights may vanish", 0), tally["possible features"]
    above = ["refused"] if 1000 * refused > REFUSED * (refused + tally["curves"]) else []
    return above + (["possible"] if 100 * possible > POSSIBLE * (possible + tally["certain features"]) else [])


def pessimism(count: int, seed: int = SEED) -> list[float]:
    """How much farther away than its radius a curve without the feature was found, in increasing order; infinite where
    there is a radius but no such curve. Of random curves of degree 2 and 3 with few segments.
    """
    random, found = Random(seed), list[float]()
    while count:
        curve = drawn(random)
        if curve.degree > 3:
            continue
        count -= 1
        found += [float(each.gone / each.radius) if each.gone else inf for each in stability(curve) if each.radius]
    return sorted(found)


def main() -> int:
    """Run the campaign and print what was found."""
    if sys.argv[1:2] == ["--pessimism"]:
        ratios = pessimism(int(sys.argv[2]))
        middle = [f"{ratios[len(ratios) * k // 4]:.2f}" for k in (1, 2)]
        within = [sum(ratio <= limit for ratio in ratios) for limit in (4, 16, 1000)]
        print(f"{len(ratios)} features; quartile and median {middle}; within 4, 16, 1000: {within}")
        return 0
    found = campaign(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
    for what, count in sorted(found.items()):
        print(f"{count:8} {what}")
    above = above_ceiling(found)
    print(*[f"above its ceiling: {what}" for what in above], sep="\n", end="\n" * bool(above))
    return bool(above) or any(what.startswith("WRONG") for what in found)


if __name__ == "__main__":
    sys.exit(main())
