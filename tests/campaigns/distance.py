"""Many distances of two curves, near ties among them, against `nearest` and what the construction knows: seeded.

python -m tests.campaigns.distance 300 1
python -m tests.campaigns.distance 1 4711 --family ties --dial thirds       one case again

What is compared is what the documentation says: a curve that stands still is a point, whose nearest points `nearest`
knows; no point of one curve is nearer to a point of the other than the distance, and one that is exactly as near lies
on an arc or is in a pair; all pairs are at one distance, to hundreds of digits more than they were nearly tied; what
is symmetric has symmetric answers; the map of an arc carries its points to points at the distance. Where something is
left out it is counted, and more than `CEILING` per mille is a difference.
"""

import sys
from contextlib import suppress
from random import Random

from gmpy2 import mpq

from exactspline import BSpline, Nurbs, distance, example, nearest
from exactspline.errors import WeightError
from exactspline.language import Vector
from tests.support.dials import DIALS
from tests.support.families import by_families

#: Per mille of the cases of a family that may be left out.
CEILING = 1
#: What is not decided, and named: no difference, but counted.
LEFT_OUT = "left out"
#: Decimal digits in which distances are compared that are not decided exactly here.
DIGITS = 2000
#: Decimal digits by which ties are missed.
MISSED = (None, None, 5, 20, 50, 100, 250)
TURNS = [((1, 0), (0, 1)), ((mpq(3, 5), mpq(-4, 5)), (mpq(4, 5), mpq(3, 5))), ((0, -1), (1, 0))]


# ---- curves


def bezier(points, weights=None):
    n = len(points) - 1
    return Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points, weights)


def placed(curve, random, number, turn=None):
    """Turned by a rational rotation and shifted: the same for both curves of a pair if `turn` is given."""
    (a, b), (c, d) = turn or random.choice(TURNS)
    return curve.transform([[a, b, number(random)], [c, d, number(random)]])


def symmetric(random, number, degree):
    """A curve that its reflection at the axis x = 0 reverses."""
    half = [(number(random), number(random)) for _ in range((degree + 1) // 2)]
    middle = [(mpq(0), number(random))] if degree % 2 == 0 else []
    points = [*half, *middle, *((-x, y) for x, y in reversed(half))]
    weights = None
    if random.random() < 0.2:
        own = [abs(number(random)) or mpq(1) for _ in points[: len(half) + len(middle)]]
        weights = [*own, *reversed(own[: len(half)])]
    return bezier(points, weights)


def missed(random, number):
    """By how much a tie is missed: 0, or a small number."""
    digits = random.choice(MISSED)
    return mpq(0) if digits is None else (abs(number(random)) or mpq(1)) / 10**digits


def still(point, random):
    """A curve that is one point."""
    degree, segments = random.choice([1, 2]), random.choice([1, 1, 2])
    knots = [0] * (degree + 1) + [1] * (segments - 1) + [segments] * (degree + 1)
    return Nurbs(degree, knots, [point] * (degree + segments))


def points(random, number):
    """A symmetric curve and a point on its axis, or nearly; a circle and its centre; any curve and any point."""
    kind = random.random()
    if kind < 0.7:
        curve = symmetric(random, number, random.choice([2, 2, 3, 4]))
        point = missed(random, number), 2 * number(random)
    elif kind < 0.8:
        r = abs(number(random)) or mpq(1)
        curve = example("circle").transform([[r, 0, 0], [0, r, 0]]).restrict(0, random.randint(1, 4))
        point = missed(random, number), mpq(0)
    else:
        curve = bezier([(number(random), number(random)) for _ in range(random.choice([2, 3, 4]))])
        point = number(random), number(random)
    turn = random.choice(TURNS)
    seed = random.random()
    curve, other = (placed(c, Random(seed), number, turn) for c in (curve, still(point, random)))
    return (curve, other), {"point": 1}


def ties(random, number):
    """Two symmetric curves one above the other, one of them shifted sideways by a little."""
    first, second = (symmetric(random, number, random.choice([1, 2, 2, 3])) for _ in range(2))
    height = 3 * sum(abs(y) for c in (first, second) for _, y in c.control_points) + 1
    by = missed(random, number)
    return (first, second.transform([[1, 0, by], [0, 1, height]])), {} if by else {"symmetric": True}


def parallels(random, number):
    """Two parallel segments, or of degree 2 and not everywhere as fast; beside each other or not."""
    (x, y), (u, v) = ((number(random), number(random)) for _ in range(2))
    u, v = (u, v) if u or v else (mpq(1), mpq(2))
    a, b, c, d, h = (number(random) for _ in range(5))
    scale = max(abs(x) for x in (u, v))
    a, b, c, d, h = (t / scale for t in (a, b, c, d, h))
    b, d, h = (b if b != a else a + 1), (d if d != c else c + 1), h or mpq(1)
    ends = [[(x + t * u, y + t * v) for t in (a, b)], [(x + t * u - h * v, y + t * v + h * u) for t in (c, d)]]
    curves = [bezier(own) for own in ends]
    if random.random() < 0.4:
        k = random.randint(0, 1)
        (p, q), at = ends[k], abs(number(random)) / scale
        curves[k] = bezier([p, tuple(e + at * (f - e) for e, f in zip(p, q, strict=True)), q])
        return tuple(curves), {}
    low, high = max(min(a, b), min(c, d)), min(max(a, b), max(c, d))
    squared = (h * h + max(low - high, 0) ** 2) * (u * u + v * v)
    return tuple(curves), {"squared": squared, "arcs": int(low < high)}


def circles(random, number):
    """Arcs of two circles about one point, turned, in any direction; the ratio of the radii may be irrational."""
    radii = abs(number(random)) or mpq(1), abs(number(random)) or mpq(2)
    curves = []
    for r in radii if radii[0] != radii[1] else (radii[0], 2 * radii[0]):
        (a, b), (c, d) = random.choice([*TURNS, ((1, -1), (1, 1))])
        own = example("circle").transform([[a * r, b * r, 0], [c * r, d * r, 0]])
        low, high = sorted(random.sample([mpq(k, 3) for k in range(13)], 2))
        own = own if random.random() < 0.2 else own.restrict(low, high)
        curves.append(own.reverse() if random.random() < 0.5 else own)
    return tuple(curves), {}


def ellipses(random, number):
    """Two ellipses about one point with parallel axes, the second around the first."""
    a, b = (abs(number(random)) or mpq(1) for _ in range(2))
    c, d = (x + (abs(number(random)) or mpq(1)) for x in (a, b))
    curves = [example("circle").transform([[x, 0, 0], [0, y, 0]]) for x, y in ((a, b), (c, d))]
    return tuple(curves), {"reflected": True}


def offsets(random, number):
    """A cubic with a rational offset (u² − v², 2uv its derivative), and a part of the offset."""
    t = BSpline.identity(0, 1)
    (a, b), (c, d) = ((number(random), number(random)) for _ in range(2))
    u, v = t.scaled(a) + t.constant(b or mpq(1)), t.scaled(c) + t.constant(d)
    cube, square = t * t * t, t * t
    x = cube.scaled((a * a - c * c) / 3) + square.scaled(a * (b or 1) - c * d) + t.scaled((b or 1) ** 2 - d * d)
    y = cube.scaled(2 * a * c / 3) + square.scaled(a * d + (b or 1) * c) + t.scaled(2 * (b or 1) * d)
    w, r = u * u + v * v, (abs(number(random)) or mpq(1)) * (b or mpq(1)) ** 2 / 10
    first = Nurbs.from_splines(Vector(x, y), t.constant(1))
    second = Nurbs.from_splines(Vector(x * w - (u * v).scaled(2 * r), y * w + (u * u - v * v).scaled(r)), w)
    low, high = sorted(random.sample([mpq(k, 4) for k in range(5)], 2))
    return (first, second.restrict(low, high)), {}


FAMILIES = {family.__name__: family for family in (points, ties, parallels, circles, ellipses, offsets)}


# ---- comparison


def difference(curves, known, random):
    """What is wrong with the answer for two curves, "" if nothing is."""
    found = distance(*curves)
    if found.undecided:
        return LEFT_OUT
    back = distance(*curves[::-1])
    if not same(back.squared, found.squared) or len(back.pairs) != len(found.pairs):
        return f"{found} one way, {back} the other way"
    if "point" in known:
        return _as_nearest(found, *curves)
    if "squared" in known and found.squared != known["squared"]:
        return f"{found}: not √{known['squared']}"
    if "arcs" in known and len(found.everywhere) != known["arcs"]:
        return f"{found}: not {known['arcs']} arcs"
    if found.squared > 0 and (wrong := _is_least(found, curves, random) or _of_arcs(found, curves)):
        return wrong
    return _is_symmetric(found, curves, known)


def _as_nearest(found, curve, point):
    """A curve that stands still is a point."""
    near = nearest(curve, point(point.domain.low))
    if near.points and found.squared != near[0].squared:
        return f"{found}, but {near}"
    starts = [s for piece in near.everywhere for part in piece.parts for s in part]
    expected = [p.parameter for p in near.points]
    ours = [p.first for p in found.pairs if p.second == point.domain.low]
    if any(sum(t == s for s in ours) != 1 for t in expected) or any(s not in (*expected, *starts) for s in ours):
        return f"{found}, but {near}"
    arcs = [arc.first for arc in found.everywhere if arc.first[0] < arc.first[1]]
    return "" if len(arcs) == sum(len(piece.parts) for piece in near.everywhere) else f"{found}, but {near}"


def _on_arc(found, k, t):
    sides = [(arc.first, arc.second)[k] for arc in found.everywhere]
    return any(min(side) <= t <= max(side) for side in sides)


def _is_least(found, curves, random):
    """No point is nearer; one that is as near is on an arc or in a pair; those of pairs are as near as their digits."""
    for k in (0, 1):
        low, high = curves[k].domain
        own = [(p.first, p.second)[k] for p in found.pairs]
        rational = [low + (high - low) * mpq(random.randint(0, 60), 60) for _ in range(2)]
        for t in rational:
            squared = nearest(curves[1 - k], curves[k](t))
            squared = squared[0].squared if squared.points else None
            if squared is None:
                continue
            as_near = same(squared, found.squared)
            if squared.enclosure(DIGITS).high < found.squared.enclosure(DIGITS).low:
                return f"{found}: nearer from {t} of curve {k}"
            seam = [high] if curves[k].closed and low in own else []
            if (as_near and squared == found.squared) != (_on_arc(found, k, t) or t in own + seam):
                return f"{found}: {t} of curve {k} is on an arc or as near, not both"
        for t in own[:4]:
            for side in (t, low + high - t):
                x = min(max(side.enclosure(DIGITS).middle, low), high)
                beside = nearest(curves[1 - k], curves[k](x))
                if beside.points and beside[0].squared.enclosure(DIGITS).high < found.squared.enclosure(DIGITS).low:
                    return f"{found}: nearer beside {float(x)} of curve {k}"
    if not all(same(p.squared, found.squared) for p in found.pairs):
        return f"{found}: pairs at different distances"
    return ""


def same(one, other):
    """Whether two numbers are the same in as many digits."""
    return one.enclosure(DIGITS).meets(other.enclosure(DIGITS))


def _of_arcs(found, curves):
    """The map of an arc carries its points to points at the distance."""
    for arc in found.everywhere:
        if arc.numerator is None:
            continue
        ends = arc.first if arc.of_second else arc.second
        low, high = sorted(x.enclosure(20).middle for x in ends)
        for k in (1, 2, 3):
            t = low + (high - low) * mpq(k, 4)
            top, bottom = (sum(c * t**i for i, c in enumerate(p)) for p in (arc.numerator, arc.denominator))
            pair = (t, top / bottom) if arc.of_second else (top / bottom, t)
            p, q = (curve(x) for curve, x in zip(curves, pair, strict=True))
            if sum((x - y) ** 2 for x, y in zip(p, q, strict=True)) != found.squared:
                return f"{found}: another distance at {t} of {arc}"
    return ""


def _is_symmetric(found, curves, known):
    """What is symmetric has symmetric answers: points are compared in thirty digits of their greatest coordinate."""
    if "symmetric" in known and not any(curve.closed for curve in curves):
        sums = [sum(curve.domain) for curve in curves]
        pairs = [(p.first, p.second) for p in found.pairs]
        mirrored = [tuple(total - t for total, t in zip(sums, pair, strict=True)) for pair in pairs]
        if any(sum(near(pair, other) for other in pairs) != 1 for pair in mirrored):
            return f"{found}: not symmetric"
    if "reflected" in known:
        pairs = [tuple(float(t) for t in (p.first, p.second)) for p in found.pairs]
        for reflected in (lambda t: (4 - t) % 4, lambda t: (6 - t) % 4):
            images = [tuple(map(reflected, pair)) for pair in pairs]
            if not found.everywhere and any(not any(near(image, pair) for pair in pairs) for image in images):
                return f"{found}: not symmetric"
    return ""


def near(one, other):
    return all(abs(float(x) - float(y)) % 4 < 1e-9 for x, y in zip(one, other, strict=True))


# ---- the campaign


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    random = Random(f"{family} {dial} {seed}")
    while True:
        with suppress(WeightError):  # a cubic whose derivative vanishes has no offset there
            return difference(*FAMILIES[family](random, DIALS[dial]), random)


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:], ceiling=CEILING))
