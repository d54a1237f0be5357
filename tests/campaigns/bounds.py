"""Largest speed, curvature, torsion and derivative of the curvature, where the curvature is above a number, and how
ends meet, against mpmath with 60 digits: seeded.

python -m tests.campaigns.bounds 200 1
python -m tests.campaigns.bounds 1 4711 --family junctions --dial doubles     one case again

The oracle shares no code with the library: points and derivatives are those of de Boor's algorithm in fractions, the
derivative of the curvature is a difference quotient. A largest value must be that of the function where it is said to
be attained, no sample may be above it, nor the best one after a search between its neighbours. Pairs of ends have
the order that they were made with. What is refused as out of reach is counted.
"""

import sys
from itertools import pairwise
from random import Random

from gmpy2 import mpq
from mpmath import mp, mpf

from exactspline import Nurbs, ask
from exactspline.errors import WeightError
from tests.support.dials import DIALS
from tests.support.families import by_families
from tests.support.oracles import jet
from tests.support.vectors import cross, dot, mpf_of

#: Relative errors that are left by 60 digits, and by difference quotients of this width.
with mp.workdps(60):
    CLOSE, WIDTH = mpf(10) ** -22, mpf(10) ** -15
SAMPLES = 16
LARGEST = ("largest_speed", "largest_curvature", "largest_curvature_derivative", "largest_torsion")


# ---- curves


def curve_of(number, random, dimension):
    """One or two segments, polynomial or rational, some of them symmetric."""
    while True:
        degree, segments = random.randint(2, 4), random.choice([1, 1, 2])
        if degree == 4 and dimension == 3:
            degree = 3
        count = degree + segments
        points = [tuple(number(random) for _ in range(dimension)) for _ in range(count)]
        weights = [random.randint(1, 3) for _ in range(count)] if random.random() < 0.3 else None
        if random.random() < 0.2:
            points = [(-points[-1 - k][0], *points[-1 - k][1:]) if k < count // 2 else p for k, p in enumerate(points)]
            weights = None if weights is None else [max(pair) for pair in zip(weights, weights[::-1], strict=True)]
        try:
            return Nurbs(degree, [0] * (degree + 1) + [1] * (segments - 1) + [segments] * (degree + 1), points, weights)
        except WeightError:
            continue


# ---- the oracle


class Oracle:
    """A curve by its control points alone."""

    def __init__(self, curve):
        self.degree, self.knots = curve.degree, list(curve.knots)
        self.points = [[w * x for x in (*p, 1)] for p, w in zip(curve.control_points, curve.weights, strict=True)]
        self.breaks = sorted({*self.knots})

    def derivatives(self, t, left):
        """The point and three derivatives at a rational number, from one side."""
        return self.divided(jet(self.knots, self.degree, self.points, t, 3, "left" if left else "right"))

    @staticmethod
    def divided(rows):
        """Derivatives of the quotients, by Leibniz's rule."""
        found = []
        for k, row in enumerate(rows):
            value = list(row[:-1])
            for j in range(1, k + 1):
                times = (1, k, k * (k - 1) // 2, 1)[min(j, k - j) if j != k else 0]
                value = [x - times * rows[j][-1] * y for x, y in zip(value, found[k - j], strict=True)]
            found.append([x / rows[0][-1] for x in value])
        return found

    def sizes(self, t, left=False):
        """Speed, signed curvature and torsion; None where they are not defined."""
        _, a, b, c = self.derivatives(t, left)
        speed = mp.sqrt(mpf_of(dot(a, a)))
        if not speed:
            return speed, None, None
        if len(a) == 2:
            return speed, mpf_of(a[0] * b[1] - a[1] * b[0]) / speed**3, None
        n = cross(a, b)
        turned = dot(n, n)
        torsion = mpf_of(dot(n, c) / turned) if turned else None
        return speed, mp.sqrt(mpf_of(turned)) / speed**3, torsion

    def size(self, name, t, left=False):
        """What a question bounds."""
        speed, curvature, torsion = self.sizes(t, left)
        if name == "largest_curvature_derivative":
            return abs(self.slope(t, left)) if speed else None
        value = {"largest_speed": speed, "largest_curvature": curvature, "largest_torsion": torsion}[name]
        return None if value is None else abs(value)

    def slope(self, t, left=False):
        """dκ/ds by a difference quotient inside the segment."""
        h = mpq(1, 10**15)
        # in space |κ| has two derivatives where it vanishes
        beside = [x for x in self.breaks if abs(x - t) < 2 * h] or not self.sizes(t)[1]
        steps = (-2 * h, -h, 0) if beside and left else (0, h, 2 * h) if beside else (-h, 0, h)
        values = [self.sizes(t + s, left=s < 0 or (left and not s))[1] for s in steps]
        if None in values:
            return mp.inf
        weights = ((1, -4, 3) if left else (-3, 4, -1)) if beside else (-1, 0, 1)
        quotient = sum(w * x for w, x in zip(weights, values, strict=True)) / (2 * WIDTH)
        return quotient / self.sizes(t, left)[0]


# ---- comparison


def digits(x):
    return mpf(x.significant(60)) if x.sign else mpf(0)


def fraction(x):
    """A rational number near a parameter."""
    return x.exact if x.exact is not None else mpq(x.decimal(55))


def samples(oracle):
    """Parameters inside the segments."""
    return [a + (b - a) * mpq(2 * k + 1, 2 * SAMPLES) for a, b in pairwise(oracle.breaks) for k in range(SAMPLES)]


def searched(f, low, high):
    """A parameter with a large value between two, by thirds."""
    for _ in range(24):
        a, b = low + (high - low) * mpq(1, 3), high - (high - low) * mpq(1, 3)
        a, b = (mpq(round(x * 10**14), 10**14) for x in (a, b))
        if (f(a) or 0) < (f(b) or 0):
            low = a
        else:
            high = b
    return low


def differs_largest(curve, name):
    """What is wrong with a largest value, "" where nothing is."""
    oracle, answer = Oracle(curve), ask(curve, name)
    places = samples(oracle)

    def size(t):
        return oracle.size(name, t)

    values = [size(t) for t in places]
    if answer and answer[0].what == "unbounded near":
        for found in answer:
            t = fraction(found.values["parameter"])
            near = max(size(min(max(t + s, oracle.breaks[0]), oracle.breaks[-1])) or 0 for s in STEPS)
            if near < 100 * sorted(x for x in values if x is not None)[len(values) // 2]:
                return f"bounded near {t}"
        return ""
    if not answer:
        return "nothing is said" if any(x is not None for x in values) else ""
    own = next(x for key, x in answer[0].values.items() if key not in ("parameter", "start", "end"))
    largest = digits(own)
    order = sorted(range(len(places)), key=lambda k: -(values[k] or 0))[:1]
    width = (oracle.breaks[1] - oracle.breaks[0]) / (2 * SAMPLES)
    best = [searched(size, max(places[k] - width, 0), min(places[k] + width, oracle.breaks[-1])) for k in order]
    for t, x in [*zip(places, values, strict=True), *((t, size(t)) for t in best)]:
        if x is not None and x > largest * (1 + CLOSE):
            return f"{mp.nstr(x, 20)} at {t}, above {mp.nstr(largest, 20)}"
    for found in answer:
        piece = [found.values[name] for name in ("start", "end") if name in found.values]
        inside = sum(piece) / 2 if piece else found.values["parameter"]
        t, left = fraction(inside), found.facts.get("side") == "left" or inside == curve.domain[1]
        # the other side of the seam is the end of the domain
        x = oracle.size(name, oracle.breaks[-1] if left and t == oracle.breaks[0] else t, left)
        if x is not None and abs(x - largest) > CLOSE * largest:
            return f"{mp.nstr(x, 20)} at {t}, which is not {mp.nstr(largest, 20)}"
    return ""


STEPS = [sign * mpq(1, 10**k) for k in (9, 12) for sign in (-1, 1)]


def differs_above(curve, random):
    """What is wrong with the parts where the curvature is above a number."""
    oracle = Oracle(curve)
    places = samples(oracle)
    values = [oracle.size("largest_curvature", t) for t in places]
    middle = sorted(x or mpf(0) for x in values)[random.randrange(len(values))]
    if not middle:
        return ""
    scale = mpq(10) ** (int(mp.floor(mp.log10(middle))) - 2)
    bound = int(middle / mpf_of(scale)) * scale
    (holds, *parts) = ask(curve, f"curvature_at_most:{bound}")
    ends = [(x.values["start"], x.values["end"]) for x in parts]
    exact = mpf_of(bound)
    for t, x in zip(places, values, strict=True):
        inside = any(a < t < b if a < b else not b <= t <= a for a, b in ends)
        if x is not None and abs(x - exact) > CLOSE * exact and inside != (x > exact):
            return f"{mp.nstr(x, 20)} at {t}, bound {bound}"
    return "" if (holds.facts["holds"] == "yes") == (not parts) else "yes and no"


def differs_slope(curve, random):
    """What is wrong with dκ/ds at a parameter."""
    oracle, t = Oracle(curve), mpq(random.randint(1, 96), 97)
    expected = oracle.slope(t)
    found = digits(ask(curve, f"curvature_derivative@{t}")[0].values["curvature derivative"])
    speed, kappa, _ = oracle.sizes(t)
    near = CLOSE * (abs(expected) + abs(kappa) / speed)
    return "" if abs(found - expected) <= near else f"{mp.nstr(found, 20)}, not {mp.nstr(expected, 20)}"


# ---- ends


def joined_pair(number, random, dimension):
    """Two Bézier curves of degree 4 that meet to an order, the second run through by another factor, one or both of
    them reversed; with that order, the parametric one, and the parameters.
    """
    own = [tuple(number(random) for _ in range(dimension)) for _ in range(5)]
    slope = [x - y for x, y in zip(own[4], own[3], strict=True)]
    if not any(slope):
        return None
    factor = random.choice([1, 1, 2, mpq(1, 3)])
    # the curve beyond its end, by de Casteljau's algorithm
    rows = [own]
    for _ in range(4):
        rows.append([[x + (1 + factor) * (y - x) for x, y in zip(p, q, strict=True)] for p, q in pairwise(rows[-1])])
    other = [row[-1] for row in rows]
    order = random.randint(-1, 3)
    if order < 3:
        shift = [number(random) or mpq(1) for _ in range(dimension)]
        if all(a * y == b * x for (a, b), (x, y) in zip(pairwise(shift), pairwise(slope), strict=True)):
            return None
        for k in range(order + 1, 5):
            other[k] = [x + y for x, y in zip(other[k], shift, strict=True)]
    parametric = min(order, 3 if factor == 1 else 0)
    curves = [Nurbs(4, [0] * 5 + [1] * 5, points) for points in (own, other)]
    if any(curve.closed for curve in curves):
        return None
    ends = [1, 0]
    for k in range(2):
        if random.random() < 0.5:
            curves[k], ends[k] = curves[k].reverse(), 1 - ends[k]
    return curves, order, parametric, ends


def differs_junction(number, random, dimension):
    """What is wrong with how two ends meet."""
    made = joined_pair(number, random, dimension)
    if made is None:
        return ""
    curves, order, parametric, ends = made
    answer = ask(tuple(curves), "junctions")
    found = next(x for x in answer if [x.values["first"], x.values["second"]] == ends)
    if (found.facts["geometric"], found.facts["parametric"]) != (order, parametric):
        return f"{found.facts}, not {order} and {parametric}"
    sides = [Oracle(curve).derivatives(mpq(t), bool(t)) for curve, t in zip(curves, ends, strict=True)]
    gap, angle, jump = measured(*sides, *ends)
    named = [digits(found.values[name]) for name in ("gap", "angle", "curvature jump")]
    for x, y, size in zip(named, (gap, angle, jump[0]), (gap, 1, jump[1]), strict=True):
        if abs(x - y) > CLOSE * (size + abs(y)):
            return f"{mp.nstr(x, 20)}, not {mp.nstr(y, 20)}"
    within = mpq(random.randint(1, 40), random.choice([1, 10, 1000]))
    limits = [gap, 2 * mp.sin(mp.radians(angle) / 2), jump[0]]
    bound = mpf_of(within)
    expected = next((k - 1 for k, x in enumerate(limits) if x > bound), 2)
    near = ask(tuple(curves), f"junctions_within:{within}")
    reported = next(x for x in near if [x.values["first"], x.values["second"]] == ends).facts["geometric"]
    return "" if reported == expected else f"within {within}: {reported}, not {expected}"


def measured(first, second, end, start):
    """Gap, angle in degrees, and the jump of the curvature vector with the size of what is subtracted."""
    signs = 1 if end else -1, -1 if start else 1
    bends = []
    for _, a, b, _ in (first, second):
        along = dot(a, b) / dot(a, a)
        bends.append([mpf_of((y - along * x) / dot(a, a)) for x, y in zip(a, b, strict=True)])
    first, second = ([[mpf_of(x) for x in row] for row in rows] for rows in (first, second))
    tangents = [[s * x / mp.sqrt(dot(r[1], r[1])) for x in r[1]] for s, r in zip(signs, (first, second), strict=True)]
    difference = [x - y for x, y in zip(*tangents, strict=True)]
    total = [x + y for x, y in zip(*tangents, strict=True)]
    angle = mp.degrees(2 * mp.atan2(mp.sqrt(dot(difference, difference)), mp.sqrt(dot(total, total))))
    jump = [x - y for x, y in zip(*bends, strict=True)]
    gap = [x - y for x, y in zip(first[0], second[0], strict=True)]
    sizes = sum(mp.sqrt(dot(b, b)) for b in bends)
    return mp.sqrt(dot(gap, gap)), angle, (mp.sqrt(dot(jump, jump)), sizes)


# ---- campaigns


@mp.workdps(60)
def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    random, number = Random(f"{family} {dial} {seed}"), DIALS[dial]
    dimension = 3 if family == "largest_torsion" else random.choice([2, 3])
    if family == "junctions":
        return differs_junction(number, random, dimension)
    curve = curve_of(number, random, dimension)
    if family in LARGEST:
        return differs_largest(curve, family)
    return {"curvature_at_most": differs_above, "curvature_derivative": differs_slope}[family](curve, random)


FAMILIES = (*LARGEST, "curvature_at_most", "curvature_derivative", "junctions")


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:]))
