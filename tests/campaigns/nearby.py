"""Curves near a curve, drawn at random, against what is said of all of them:
``python -m tests.campaigns.nearby 1000``; and how much farther away than proved features vanish:
``python -m tests.campaigns.nearby --pessimism 100``.

Of the curve itself and of every curve near it, the sign of κ (in space of τ) and of κ′ at both ends of each interval
that has a certain feature is computed by its own formula in 60 digits, from control points by de Boor's algorithm; and
every feature that the curve has, found in exact arithmetic, must lie in an interval of its own kind (of an undulation:
inflection, and so on: `LISTED`), singular points, corners and whole pieces, too. In each interval with a certain
feature a curve must have that kind, once where it says so. Where curves are said to meet, Newton's method on the same
points must lead into the box; all common points, found in exact arithmetic, must lie in one. Radii of stability: no
feature may vanish on curves as far as the radius, and a curve that is given as one without the feature must have fewer
zeros by SymPy's isolation, on a polynomial from its values. The exit status is 1 where anything is different, or more
is refused, or possible only, than the ceilings allow. The last whole run: `docs/rounded-input.md`.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise
from math import inf
from random import Random
from typing import Any

from gmpy2 import mpq
from mpmath import mp, mpf
from sympy import Poly, Rational, Symbol, interpolate

from exactspline import Nurbs, analyse
from exactspline.errors import ExactSplineError
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.geometry.pairs.intersections import intersections
from exactspline.geometry.rounded.features import NearbyFeature, features_nearby
from exactspline.geometry.rounded.intersections import intersections_nearby, self_intersections_nearby
from exactspline.geometry.rounded.stability import stability
from tests.support.vectors import cross, mpf_of

SEED = 2032
#: Per mille of the curves that may be refused: no weight comes near 0 within these distances.
REFUSED = 1
#: Per cent of the features listed that may be possible only: what is nearer to vanishing than the distance drawn, which
#: may be half of the curve, all that a closed curve has at its seam, and beside doubled points.
POSSIBLE = 65
#: Curves near each curve, the first of them the curve itself.
DRAWN = 5
ZERO, TWIST = (FeatureKind.INFLECTION,), (FeatureKind.TORSION_ZERO,)
EXTREME = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM)
#: The kinds of intervals that have features of a kind, as `features_nearby` says; all others are of their own kind.
LISTED = {
    FeatureKind.UNDULATION: ZERO,
    FeatureKind.FLAT_END: ZERO,
    FeatureKind.FLAT_POINT: ZERO,
    FeatureKind.STATIONARY: EXTREME,
    FeatureKind.TORSION_TOUCH: TWIST,
    FeatureKind.TORSION_END: TWIST,
}


def drawn(random: Random, dimension: int = 2) -> Nurbs:
    """A curve of degree 2 to 5 with one to four segments, or a closed one that is smooth at its seam, polynomial or
    rational, smooth or with corners; some with doubled points, some with equal ends, in space some in a plane.
    """
    degree, inner = random.randint(dimension, 5), random.randint(0, 3)
    setting = random.choice([lambda: mpq(random.randint(-9, 9)), lambda: mpq(random.uniform(-1, 1))])
    if around := random.random() < 0.2:
        knots = list(range(inner + 2 * degree + 3))
    else:
        inside = [[t] * random.choice([1, 1, 1, degree - 1, degree]) for t in range(1, inner + 1)]
        knots = [*[0] * (degree + 1), *[t for ts in inside for t in ts], *[inner + 1] * (degree + 1)]
    count = len(knots) - degree - 1
    points = [tuple(setting() for _ in range(dimension)) for _ in range(count)]
    if dimension == 3 and random.random() < 0.2:
        points = [(x, y, x - 2 * y) for x, y, _ in points]
    weights = [mpq(random.randint(8, 24), 8) for _ in points]
    if around:
        period = inner + 2
        points, weights = ([row[k % period] for k in range(count)] for row in (points, weights))
    elif random.random() < 0.2:
        points[-1] = points[0]
    elif random.random() < 0.2:
        k = random.randrange(count - 1)
        points[k + 1] = points[k]
    return Nurbs(degree, knots, points, weights if random.random() < 0.5 else None)


def distance(random: Random) -> mpq:
    """From a half to 10⁻¹⁴."""
    return mpq(random.randint(3, 50), 100) if random.random() < 0.3 else mpq(1, 10 ** random.randint(1, 14))


def moved(curve: Nurbs, epsilon: mpq, random: Random) -> Nurbs:
    """A curve within epsilon: often at the corners of what is allowed; sometimes points that are equal stay so, so that
    a closed curve stays closed, and smooth at its seam.
    """

    def step() -> mpq:
        return epsilon * (random.choice([-1, 1]) if random.random() < 0.7 else mpq(random.randint(-99, 99), 99))

    rows = [*zip(curve.control_points, curve.weights, strict=True)]
    together, known = random.random() < 0.5, {}
    own = [
        known.setdefault(row if together else k, [step() for _ in range(curve.dimension + 1)])
        for k, row in enumerate(rows)
    ]
    points = [tuple(x + d for x, d in zip(p, each, strict=False)) for (p, _), each in zip(rows, own, strict=True)]
    weights = None if curve.polynomial else [w + each[-1] for (_, w), each in zip(rows, own, strict=True)]
    return Nurbs(curve.degree, curve.knots, points, weights)


def blossom(curve: Nurbs, t: mpq, left: bool, of: Callable[[mpq], Any] = mpf_of) -> list[list[Any]]:
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
            found.append([of(mpq(0))] * len(rows[0]))
            continue
        points = [list(point) for point in net]
        base = j - n
        for r in range(1, n + 1):
            for i in range(n, r - 1, -1):
                a, b = knots[base + i], knots[base + i + n + 1 - r]
                s = (t - a) / (b - a)
                points[i] = [(1 - s) * x + s * y for x, y in zip(points[i - 1], points[i], strict=True)]
        found.append([of(x) for x in points[n]])
        net = [
            [n * (y - x) / (knots[base + i + n + 1] - knots[base + i + 1]) for x, y in zip(p, q, strict=True)]
            for i, (p, q) in enumerate(pairwise(net))
        ]
    return found


def signs(curve: Nurbs, t: mpq, left: bool) -> tuple[int, int]:
    """The signs of κ (in space of τ) and κ′, by the quotient rule."""
    jets = derivatives(curve, t, left)
    _, first, second, third = zip(*jets, strict=True)
    if len(jets) == 3:
        bend, turn = cross(first, second), cross(first, third)
        slope = mp.fdot(bend, turn) * mp.fdot(first, first) - 3 * mp.fdot(bend, bend) * mp.fdot(first, second)
        return int(mp.sign(mp.fdot(bend, third))), int(mp.sign(slope))
    (x1, y1), (x2, y2), (x3, y3) = first, second, third
    cross_, speed = x1 * y2 - y1 * x2, x1 * x1 + y1 * y1
    slope = (x1 * y3 - y1 * x3) * speed - 3 * cross_ * (x1 * x2 + y1 * y2)
    return int(mp.sign(cross_)), int(mp.sign(slope))


def derivatives(curve: Nurbs, t: mpq, left: bool) -> list[list[mpf]]:
    """Each coordinate with its derivatives of order 1 to 3."""
    rows = blossom(curve, t, left)
    w = [row[-1] for row in rows]
    jets = []
    for axis in range(curve.dimension):
        p = [row[axis] for row in rows]
        value = [p[0] / w[0]]
        value.append((p[1] - value[0] * w[1]) / w[0])
        value.append((p[2] - 2 * value[1] * w[1] - value[0] * w[2]) / w[0])
        value.append((p[3] - 3 * value[2] * w[1] - 3 * value[1] * w[2] - value[0] * w[3]) / w[0])
        jets.append(value)
    return jets


def changes(curve: Nurbs, found: NearbyFeature) -> bool:
    """Whether the sign changes over the interval of a certain feature, from a little before it to a little behind."""
    (a, b), which = found.place, int(found.kind in EXTREME)
    before, behind = signs(curve, a, left=True)[which], signs(curve, b, left=False)[which]
    if before == 0 or behind == 0:
        return True
    return before == -behind and (which == 0 or (before == 1) == (found.kind is FeatureKind.MAXIMUM))


def wrong(near: Nurbs, said: Sequence[NearbyFeature], *, complete: bool = True) -> str:
    """What a curve near another lacks, or has that was not said where that is complete; "" for nothing."""
    for found in said:
        if found.robust and found.kind is not FeatureKind.CORNER and not changes(near, found):
            return f"no {found.kind} in {found.place}"
    facts = analyse(near)
    answers = [
        (facts.inflections, ZERO),
        (facts.critical_points, EXTREME),
        (facts.singular_points, (FeatureKind.STOP,)),
    ]
    answers += [(facts.torsion_zeros, TWIST)] if near.dimension == 3 else []
    there = [(each.kind, each.root) for answer, _ in answers for each in answer if not each.kind.is_singular]
    there += [(FeatureKind.STOP, each.root) for each in facts.singular_points]
    there += [(FeatureKind.CORNER, joint.parameter) for joint in facts.corners]
    listed = [(LISTED.get(kind, (kind,)), place, place) for kind, place in there]
    listed += [(kinds, *part) for answer, kinds in answers for piece in answer.everywhere for part in piece.parts]
    for kinds, low, high in listed if complete else ():
        if not any(found.kind in kinds and found.place.low <= low and high <= found.place.high for found in said):
            return f"{kinds[0]} from {low} to {high} is in no interval"
    for found in said:
        count = sum(kind is found.kind and found.place.low <= t <= found.place.high for kind, t in there)
        if found.robust and (count != 1 if found.single else not count):
            return f"{count} of kind {found.kind} in {found.place}"
    return ""


def answered(tally: Counter[str], of: str, what: str, ask: Callable[[], Sequence[Any]]) -> Sequence[Any] | None:
    """An answer, counted; None where it is refused."""
    try:
        said = ask()
    except ExactSplineError:
        tally["refused: weights may vanish"] += 1
        return None
    tally[of] += 1
    tally[f"robust {what}"] += sum(found.robust for found in said)
    tally[f"possible {what}"] += sum(not found.robust for found in said)
    return said


@mp.workdps(60)
def campaign(count: int, seed: int = SEED, dimension: int = 2) -> Counter[str]:
    """Random curves, each with a few near it at a random distance."""
    random, tally = Random(seed), Counter[str]()
    for _ in range(count):
        curve, epsilon = drawn(random, dimension), distance(random)
        said = answered(tally, "curves", "features", partial(features_nearby, curve, epsilon))
        for k in range(DRAWN if said is not None else 0):
            tally["curves near them"] += 1
            if what := wrong(moved(curve, epsilon, random) if k else curve, said):
                tally[
                    f"WRONG: {what}, {epsilon}, {curve!r}, {curve.knots}, {curve.control_points}, {curve.weights}"
                ] += 1
    return tally


def above_ceiling(tally: Mapping[str, int]) -> list[str]:
    """What there is more of than may be."""
    refused, possible = tally.get("refused: weights may vanish", 0), tally["possible features"]
    above = ["refused"] if 1000 * refused > REFUSED * (refused + tally["curves"]) else []
    return above + (["possible"] if 100 * possible > POSSIBLE * (possible + tally["robust features"]) else [])


def crosses_in(first: Nurbs, second: Nurbs, box: tuple[Sequence[mpq], Sequence[mpq]]) -> bool:
    """Whether Newton's method from the middle of a box leads to a common point of two plane curves in it."""
    s, t = ((mpf_of(a) + mpf_of(b)) / 2 for a, b in box)
    for _ in range(12):
        (x, y), (u, v) = (derivatives(c, exact(r), left=False) for c, r in ((first, s), (second, t)))
        step = mp.lu_solve(mp.matrix([[x[1], -u[1]], [y[1], -v[1]]]), mp.matrix([x[0] - u[0], y[0] - v[0]]))
        s, t = s - step[0], t - step[1]
    small = mpf(10) ** -45
    met = max(map(abs, step)) < small
    return met and all(mpf_of(a) - small <= r <= mpf_of(b) + small for r, (a, b) in zip((s, t), box, strict=True))


def exact(x: mpf) -> mpq:
    """The number that a float of the working precision is."""
    return mpq(int(mp.nint(x * 2**180)), 2**180)


@mp.workdps(60)
def meetings(count: int, seed: int = SEED) -> Counter[str]:
    """Pairs of random plane curves, and each of these with itself, with pairs near them at a random distance."""
    random, tally = Random(seed), Counter[str]()
    for k in range(count):
        first = drawn(random)
        second, epsilon = (first if k % 2 else drawn(random)), mpq(1, 10 ** random.randint(1, 14))
        alone, both = partial(self_intersections_nearby, first), partial(intersections_nearby, first, second)
        said = answered(tally, "pairs of curves", "common points", partial(alone if k % 2 else both, epsilon))
        for _ in range(DRAWN if said is not None else 0):
            tally["pairs near them"] += 1
            a = moved(first, epsilon, random)
            b = a if k % 2 else moved(second, epsilon, random)
            found = analyse(a).self_intersections if k % 2 else intersections(a, b)
            inside = [
                [x for x in said if x.first.low <= s <= x.first.high and x.second.low <= t <= x.second.high]
                for s, t in ((x.first, x.second) for x in found)
            ]
            if not all(inside):
                tally[f"WRONG: a common point in no box, {a!r}, {b!r}"] += 1
            for meet in said:
                if meet.robust and not crosses_in(a, b, (meet.first, meet.second)):
                    tally[f"WRONG: no common point in {meet}, {a!r}, {b!r}"] += 1
                if meet.robust and sum(meet in own for own in inside) != 1 and not found.undecided:
                    tally[f"WRONG: not one common point in {meet}, {a!r}, {b!r}"] += 1
    return tally


def forms(curve: Nurbs) -> tuple[Poly, Poly]:
    """The numerators of κ and κ′ of a plane curve of one segment, interpolated from values."""
    t = Symbol("t")
    count = 4 * curve.degree + 1
    jets = [(Rational(k, count), blossom(curve, mpq(k, count), left=False, of=_as_it_is)) for k in range(count)]

    def interpolated(values: list[object]) -> Poly:
        return Poly(interpolate([(place, value) for (place, _), value in zip(jets, values, strict=True)], t), t)

    bends, speeds, weights = [], [], []
    for _, rows in jets:
        p, first, second = ([Rational(int(x.numerator), int(x.denominator)) for x in row] for row in rows[:3])
        one, two = ([d[c] * p[2] - p[c] * d[2] for c in (0, 1)] for d in (first, second))
        bends.append(one[0] * two[1] - one[1] * two[0])
        speeds.append(one[0] ** 2 + one[1] ** 2)
        weights.append(p[2])
    bend, speed, w = map(interpolated, (bends, speeds, weights))
    slope = (bend.diff(t) * w + 2 * bend * w.diff(t)) * speed * 2 - 3 * bend * w * speed.diff(t)
    return bend, slope * w  # all weights may be negative


def _as_it_is(x: mpq) -> mpq:
    return x


def sign_changes(form: Poly) -> Counter[int]:
    """How often a polynomial changes its sign on ]0, 1[, by the sign before: by SymPy's isolation of real roots."""
    tally, before = Counter[int](), 0
    # also where an end is a root, which is not among these, and where roots are rational, the sign between is asked
    isolated = [interval for interval, _ in form.intervals(inf=0, sup=1, eps=Rational(1, 10**9))]
    ends = [(Rational(0), Rational(0)), *isolated, (Rational(1), Rational(1))]
    between = [(high + low) / 2 for (_, high), (low, _) in pairwise(ends)]
    for place in (Rational(0), *between, Rational(1)):
        now = 1 if (value := form.eval(place)) > 0 else -1 if value < 0 else 0
        if before and now == -before:
            tally[before] += 1
        before = now or before
    return tally


@mp.workdps(60)
def radii(count: int, seed: int = SEED) -> Counter[str]:
    """Curves as far from random ones as features are proved to be stable; and the curves without them."""
    random, tally = Random(seed), Counter[str]()
    for k in range(count):
        curve = drawn(random)
        while curve.degree > 3 or (curve.segments > 1 and k % 2):
            curve = drawn(random)
        for found in stability(curve):
            if found.radius:
                said = [
                    near
                    for near in features_nearby(curve, found.radius)
                    if near.kind is found.kind and near.place.low <= found.place <= near.place.high
                ]
                tally["features with a radius"] += 1
                tally[f"WRONG: {found} of {curve!r} is not certain"] += len(said) != 1 or not said[0].single
                for _ in range(3 * DRAWN):
                    tally["curves within a radius"] += 1
                    what = wrong(moved(curve, found.radius, random), said, complete=False)
                    tally[f"WRONG: {what}, {found} of {curve!r}"] += bool(what)
            if found.witness is not None and curve.segments == 1 and found.kind is not FeatureKind.CORNER:
                tally["curves without a feature"] += 1
                which = int(found.kind in EXTREME)
                one, other = (sign_changes(forms(c)[which]) for c in (curve, found.witness))
                if not which:
                    fewer = sum(other.values()) < sum(one.values())
                else:
                    before = 1 if found.kind is FeatureKind.MAXIMUM else -1
                    fewer = other[before] < one[before]
                tally[f"WRONG: {found} is there in {found.witness!r}"] += not fewer
    return +tally


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
    count, seed = (int(given) for given in (*sys.argv[1:], *("100", str(SEED))[len(sys.argv) - 1 :])[:2])
    found = campaign(count, seed) + campaign(count // 4, seed, dimension=3) + meetings(count, seed)
    found += radii(count // 6, seed)
    for what, count in sorted(found.items()):
        print(f"{count:8} {what}")
    above = above_ceiling(found)
    print(*[f"above its ceiling: {what}" for what in above], sep="\n", end="\n" * bool(above))
    return bool(above) or any(what.startswith("WRONG") for what in found)


if __name__ == "__main__":
    sys.exit(main())
