"""How far curves are from each other, against dense samples in doubles and what the construction knows: seeded.

python -m tests.campaigns.deviation 1000 1
python -m tests.campaigns.deviation 1 4711 --family offsets --dial doubles     one case again

The oracle shares no code with the library: points are those of de Boor's algorithm in numpy, of coordinates divided by
the largest one. From every sample of a curve the nearest sample of the other one is found, and from there the nearest
point by thirds. The samples with a bound on the length of the legs of the control polygon bound the deviation from both
sides; no sample may be farther than the upper bound, and the pair that is told must be as far apart as the lower one,
with no sample nearer. What is only written otherwise has deviation 0; of parallel curves, circles about one point and
what is shifted within itself it is known exactly, and that it is at most this number, but not a smaller one. What is
refused as out of reach is counted.
"""

import sys
from contextlib import suppress
from fractions import Fraction
from itertools import pairwise
from math import isqrt
from random import Random

import numpy as np
from gmpy2 import mpq

from exactspline import Nurbs, ask, example
from exactspline.errors import WeightError
from tests.campaigns.distance import offsets as with_offset
from tests.support.dials import DIALS
from tests.support.families import by_families

#: Samples of a segment, and what is left by doubles, of the size of the curves.
SAMPLES, CLOSE = 48, 1e-11
#: The upper bound is at most so much above the lower one.
RATIO = mpq(101, 100)
SMALLER = 1 - mpq(1, 10**15)


# ---- curves


def curve_of(number, random, dimension=2, degree=0, segments=0):
    """Some segments, polynomial or rational, of positive weights."""
    degree, segments = degree or random.randint(1, 4), segments or random.choice([1, 1, 2, 3])
    points = [tuple(number(random) for _ in range(dimension)) for _ in range(degree + segments)]
    weights = [random.randint(1, 3) for _ in points] if random.random() < 0.3 else None
    return Nurbs(degree, [0] * (degree + 1) + [*range(1, segments)] + [segments] * (degree + 1), points, weights)


def random_pairs(number, random):
    """Two curves that have nothing to do with each other."""
    dimension = random.choice([2, 2, 3])
    return [curve_of(number, random, dimension) for _ in range(2)], {}


def polylines(number, random):
    """Two of them, the second one with some of the points of the first."""
    dimension = random.choice([2, 3])
    one = curve_of(number, random, dimension, 1, random.randint(1, 6))
    points = [p for p in one.control_points if random.random() < 0.8] or [one.control_points[0]]
    points = [*points, *[tuple(number(random) for _ in range(dimension))] * (len(points) < 2)]
    other = Nurbs(1, [0, *range(len(points)), len(points) - 1], points)
    return [one, other], {}


def approximations(number, random):
    """A curve, and quadratic pieces with its ends and tangents at some of its points, as of fonts."""
    one = curve_of(number, random, 2, 3, 1)
    count = random.randint(1, 6)
    a, b = one.domain
    points = []
    for k in range(count):
        ends = [a + (b - a) * mpq(i, count) for i in (k, k + 1)]
        (p, q), rows = map(one, ends), [one.restrict(*ends).control_points[i] for i in (1, 2)]
        middle = tuple((3 * x + 3 * y - u - v) / 4 for x, y, u, v in zip(*rows, p, q, strict=True))
        points += [p, middle]
    points.append(one(b))
    knots = [0, 0, 0, *[t for k in range(1, count) for t in (k, k)], *[count] * 3]
    return [one, Nurbs(2, knots, points)], {}


def rounded(number, random):
    """A curve, and the same with control points moved by a little."""
    one = curve_of(number, random, random.choice([2, 3]))
    largest = max(abs(x) for p in one.control_points for x in p) or mpq(1)
    step = largest / 10 ** random.choice([2, 4, 6, 9])
    points = [tuple(x + step * random.randint(-3, 3) for x in p) for p in one.control_points]
    return [one, Nurbs(one.degree, list(one.knots), points, list(one.weights))], {}


def same(number, random):
    """A curve and the same one, written otherwise, or a part of it."""
    one = curve_of(number, random, random.choice([2, 2, 3]))
    a, b = one.domain
    low, high = sorted(a + (b - a) * mpq(k, 12) for k in random.sample(range(13), 2))
    other, whole = random.choice(
        [
            (one.elevate_degree(1), True),
            (one.insert_knot(low if a < low < b else (a + b) / 3), True),
            (one.reverse(), True),
            (one.restrict(low, high), False),
            (squared(one), True) if one.polynomial and one.segments == 1 else (one.reverse(), True),
        ]
    )
    known = {0: mpq(0)} if whole else {}
    return [one, other], known | {1: mpq(0)}


def squared(curve):
    """A Bézier curve run through with the parameter (t + t²)/2, by its values: of twice the degree."""
    n = 2 * curve.degree
    nodes = [mpq(k, n) for k in range(n + 1)]
    rows = [[binomial(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)] for t in nodes]
    points = solved(rows, [list(curve((t + t * t) / 2)) for t in nodes])
    return Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points)


def binomial(n, k):
    value = 1
    for i in range(k):
        value = value * (n - i) // (i + 1)
    return value


def solved(rows, values):
    """A linear system solved, by Gauss and Jordan."""
    table = [[*row, *value] for row, value in zip(rows, values, strict=True)]
    for k in range(len(table)):
        pivot = next(i for i in range(k, len(table)) if table[i][k])
        table[k], table[pivot] = table[pivot], table[k]
        table[k] = [x / table[k][k] for x in table[k]]
        for i in range(len(table)):
            if i != k and table[i][k]:
                table[i] = [x - table[i][k] * y for x, y in zip(table[i], table[k], strict=True)]
    return [row[len(rows) :] for row in table]


def parallels(number, random):
    """Two segments of parallel lines; of equal length opposite to each other, or one opposite a part of the other."""
    (x, y), (u, v) = ((number(random), number(random)) for _ in range(2))
    u, v = (u, v) if u or v else (mpq(1), mpq(2))
    h = (number(random) or mpq(1)) / max(abs(u), abs(v))
    low, high = (mpq(0), mpq(1)) if random.random() < 0.5 else (mpq(-random.randint(0, 3)), mpq(random.randint(1, 3)))
    first = Nurbs(1, [0, 0, 1, 1], [(x, y), (x + u, y + v)])
    second = Nurbs(1, [0, 0, 1, 1], [(x + t * u - h * v, y + t * v + h * u) for t in (low, high)])
    beyond = max(-low, high - 1) ** 2
    return [first, second], {0: h * h * (u * u + v * v), 1: (h * h + beyond) * (u * u + v * v)}


def circles(number, random):
    """Two circles about one point, or of one radius and moved by less than it."""
    r, step = (abs(number(random)) or mpq(1) for _ in range(2))
    c, s = random.choice([(mpq(1), mpq(0)), (mpq(3, 5), mpq(4, 5)), (mpq(-5, 13), mpq(12, 13))])
    first = example("circle").transform([[r, 0, 0], [0, r, 0]])
    if random.random() < 0.5:
        radius = r + step
        second, distance = (
            example("circle").transform([[radius * c, -radius * s, 0], [radius * s, radius * c, 0]]),
            step,
        )
    else:
        step = min(step, r / 2)
        second, distance = first.transform([[1, 0, step * c], [0, 1, step * s]]), step
    return [first, second], {0: distance**2, 1: distance**2}


def offsets(number, random):
    """A cubic with a rational offset (a Pythagorean hodograph), and the whole of the offset, at a small distance."""
    while True:
        (first, second), _ = with_offset(random, number)
        if second.domain == first.domain:
            break
    a, b = first.domain
    (p, q), (u, v) = (first(a), second(a)), (first(b), second(b))
    squares = {sum((x - y) ** 2 for x, y in zip(*pair, strict=True)) for pair in ((p, q), (u, v))}
    return [first, second], {"at most": squares.pop()}


FAMILIES = {
    f.__name__: f for f in (random_pairs, polylines, approximations, rounded, same, parallels, circles, offsets)
}


# ---- the oracle


class Oracle:
    """A curve in doubles, its coordinates divided by a number."""

    def __init__(self, curve, size):
        self.degree, self.segments = curve.degree, curve.segments
        self.knots = [float(Fraction(str(t))) for t in curve.knots]
        self.breaks = sorted({*self.knots})
        weights = [w / max(curve.weights) for w in curve.weights]
        self.points = np.array(
            [
                [*(float(x / size) * float(w) for x in p), float(w)]
                for p, w in zip(curve.control_points, weights, strict=True)
            ]
        )
        flat = self.points[:, :-1] / self.points[:, -1:]
        legs = np.linalg.norm(np.diff(flat, axis=0), axis=1) if len(flat) > 1 else np.zeros(1)
        # ‖γ′‖ is at most n (w_max/w_min)² times the longest leg, over the length of the knots that it spans (Floater)
        ratio = float(max(weights) / min(weights)) ** 2
        spans = min(b - a for a, b in pairwise(self.breaks))
        self.speed = self.degree * ratio * float(legs.max()) / spans

    def __call__(self, t):
        """Points at parameters."""
        t = np.atleast_1d(np.asarray(t, dtype=float))
        knots, n = np.array(self.knots), self.degree
        span = np.clip(np.searchsorted(knots, t, side="right") - 1, n, len(self.points) - 1)
        rows = [self.points[span - n + k] for k in range(n + 1)]
        for r in range(1, n + 1):
            for k in range(n, r - 1, -1):
                low, high = knots[span - n + k], knots[span + 1 + k - r]
                a = ((t - low) / (high - low))[:, None]
                rows[k] = (1 - a) * rows[k - 1] + a * rows[k]
        return rows[n][:, :-1] / rows[n][:, -1:]

    def samples(self, number=SAMPLES):
        """Parameters, and the largest step between them."""
        found = [np.linspace(a, b, number, endpoint=False) for a, b in pairwise(self.breaks)]
        step = max(b - a for a, b in pairwise(self.breaks)) / number
        return np.concatenate([*found, [self.breaks[-1]]]), step


def nearest_of(other, points, number=SAMPLES):
    """The distances of points from samples of a curve, and from the nearest points between their neighbours, also at
    both ends, which may be one point.
    """
    parameters, step = other.samples(number)
    apart = np.linalg.norm(points[:, None, :] - other(parameters)[None, :, :], axis=2)
    refined = apart.min(axis=1)
    for near in (parameters[apart.argmin(axis=1)], *(np.full(len(points), parameters[k]) for k in (0, -1))):
        low, high = (np.clip(near + way * step, parameters[0], parameters[-1]) for way in (-1, 1))
        for _ in range(60):
            a, b = low + (high - low) / 3, high - (high - low) / 3
            nearer = np.linalg.norm(points - other(a), axis=1) < np.linalg.norm(points - other(b), axis=1)
            low, high = np.where(nearer, low, a), np.where(nearer, b, high)
        refined = np.minimum(refined, np.linalg.norm(points - other(low), axis=1))
    return apart.min(axis=1), refined


def scaled(x, size):
    """A real number divided by the size, as a double."""
    return float(x.rational_near(20) / size)


def differs_way(curves, found, k, size):
    """What is wrong with the bounds of one direction."""
    one, other = (Oracle(curve, size) for curve in (curves[k], curves[1 - k]))
    low, high = (scaled(found.values[name], size) for name in ("low", "high"))
    if found.values["high"] > RATIO * found.values["low"]:
        return f"{found}: wider than a hundredth"
    parameters, step = one.samples()
    at_samples, refined = nearest_of(other, one(parameters))
    own, others = (one.speed * step / 2, other.speed * other.samples()[1] / 2)
    if not at_samples.max() - others - CLOSE <= high or not low <= at_samples.max() + own + CLOSE:
        return f"{found}: between {at_samples.max() - others} and {at_samples.max() + own}"
    far = parameters[refined > high + CLOSE]
    # the nearest of more samples: between the few another part of the curve may have been nearest
    if len(far) and (again := nearest_of(other, one(far), 40 * SAMPLES)[1]).max() > high + CLOSE:
        return f"{found}: {again.max()} at {far[again.argmax()]}"
    names = "at", "nearest"
    places = [float(found.values[name].rational_near(25)) for name in names]
    point, foot = one(places[0]), other(places[1])
    if not np.isclose(float(np.linalg.norm(point - foot)), low, rtol=0, atol=10 * CLOSE):
        return f"{found}: the pair is {np.linalg.norm(point - foot)} apart, not {low}"
    if nearest_of(other, point)[1][0] < low - CLOSE:
        return f"{found}: a point is nearer"
    return ""


def differs_within(curves, answer, known, random):
    """What is wrong with yes and no."""
    bounds = [mpq(random.randint(1, 30), 10)]
    for found in answer:
        low, high = (found.values[name].rational_near(12) for name in ("low", "high"))
        bounds += [low * mpq(9, 10), high * mpq(11, 10)]
    for bound in random.sample(bounds, 2):
        told = ask(tuple(curves), f"deviation_within:{bound}")
        for one, found in zip(told, answer, strict=True):
            holds = one.facts["holds"] == "yes"
            if (holds and found.values["low"] > bound) or (not holds and found.values["high"] <= bound):
                return f"within {bound}: {one}, but {found}"
    for k in (0, 1):
        if k in known and known[k] and not all(tied(curves, k, known[k], answer)):
            return f"√{known[k]} is not decided to be the bound"
    return ""


def tied(curves, k, square, answer):
    """Whether a bound that is attained is told as such, where its root is rational, and lies in the interval."""
    found = answer[k]
    yield found.values["low"] * found.values["low"] <= square <= found.values["high"] * found.values["high"]
    yield not not_within(curves, k, square)
    yield not_within(curves, k, square * SMALLER**2) is not False


def not_within(curves, k, square):
    """Whether a deviation is said to be above the root of a number; None where this is irrational."""
    bound = mpq(isqrt(int(square.numerator)), isqrt(int(square.denominator)))
    return ask(tuple(curves), f"deviation_within:{bound}")[k].facts["holds"] == "no" if bound**2 == square else None


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    random, number = Random(f"{family} {dial} {seed}"), DIALS[dial]
    while True:
        with suppress(WeightError):
            curves, known = FAMILIES[family](number, random)
            break
    answer = ask(tuple(curves), "deviation")
    if "at most" in known:
        known, square = {}, known["at most"]
        if answer[1].values["low"] * answer[1].values["low"] > square or not_within(curves, 1, square):
            return f"{answer[1]}: above √{square}"
    size = max(abs(x) for curve in curves for p in curve.control_points for x in p) or mpq(1)
    for k, found in enumerate(answer):
        if known.get(k) == 0 and (found.values["low"].sign or found.values["high"].sign):
            return f"{found}: not 0"
        if wrong := "" if known.get(k) == 0 else differs_way(curves, found, k, size):
            return wrong
    return differs_within(curves, answer, known, random)


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:], in_turn=True))
