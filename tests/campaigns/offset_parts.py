"""The true parts of offsets of simple closed curves against dense samples in doubles: seeded.

python -m tests.campaigns.offset_parts 500 1
python -m tests.campaigns.offset_parts 1 4711 --family arcs --dial doubles     one case again

The oracle shares no code with the library: points are those of de Boor's algorithm in numpy, of coordinates divided by
the largest one, normals are differences of them. At samples of the curve, and of circles about its corners, the
distance of the offset's point from the curve is that from many of its points, and from there by thirds: inside a part
that is found it is d, elsewhere it is less. Where there is no part, no point of a grid on that side is farther than d;
otherwise one beside a part is. What is refused is counted.
"""

import sys
from contextlib import suppress
from math import cos, pi, sin
from random import Random

import numpy as np
from gmpy2 import mpq

from exactspline import Nurbs, ask, example
from exactspline.errors import ReachError, ShapeError, WeightError
from tests.campaigns.deviation import Oracle, nearest_of
from tests.support.dials import DIALS
from tests.support.families import by_families

#: Samples of a segment; what is left by doubles and thirds; how near ends of parts nothing is compared.
SAMPLES, CLOSE, BESIDE = 24, 1e-7, 1e-3


# ---- curves


def directions(random, count):
    """Rational points near the unit circle, in order."""
    angles = sorted(random.uniform(0, 2 * pi) for _ in range(count))
    return [(mpq(round(1000 * cos(a)), 1000), mpq(round(1000 * sin(a)), 1000)) for a in angles]


def star(number, random, count):
    """Corners of a polygon around the origin, mostly simple."""
    found = []
    for x, y in directions(random, count):
        r = abs(number(random)) or mpq(1)
        found.append((x * r, y * r))
    return found


def polygons(number, random):
    points = star(number, random, random.randint(3, 7))
    n = len(points)
    return Nurbs(1, [0, *range(n + 1), n], [*points, points[0]])


def arcs(number, random):
    """A polygon, some of whose sides are arcs of circles: the middle point on the bisector, its weight the cosine."""
    points = star(number, random, random.randint(2, 5))
    n, own, weights = len(points), [points[0]], [mpq(1)]
    for (a, b), (c, d) in zip(points, [*points[1:], points[0]], strict=True):
        h = random.choice([mpq(0), mpq(0), mpq(1, 4), mpq(1, 3), mpq(-1, 4), mpq(-1, 2)])
        # the tangents meet at the height 2 h/(1 − h²) of half the side, where h = tan of a quarter of the angle
        up = h / (1 - h * h)
        own += [((a + c) / 2 - up * (b - d), (b + d) / 2 + up * (a - c)), (c, d)]
        weights += [(1 - h * h) / (1 + h * h), mpq(1)]
    knots = [0, 0, 0, *[t for k in range(1, n) for t in (k, k)], n, n, n]
    return Nurbs(2, knots, own, weights)


def smooth(number, random):
    """An ellipse, or quadratic pieces between the middles of the sides of a polygon."""
    if random.random() < 0.4:
        a, b = (abs(number(random)) or mpq(1) for _ in range(2))
        return example("circle").transform([[a, 0, number(random)], [number(random) * 0, b, 0]])
    points = star(number, random, random.randint(3, 6))
    n, own = len(points), []
    middles = [
        tuple((x + y) / 2 for x, y in zip(p, q, strict=True))
        for p, q in zip(points, [*points[1:], points[0]], strict=True)
    ]
    for middle, corner in zip(middles, [*points[1:], points[0]], strict=True):
        own += [middle, corner]
    knots = [0, 0, 0, *[t for k in range(1, n) for t in (k, k)], n, n, n]
    return Nurbs(2, knots, [*own, middles[0]])


FAMILIES = {family.__name__: family for family in (polygons, arcs, smooth)}


# ---- comparison


def inside(t, parts, width):
    """Whether a parameter is in parts; None near an end."""
    if any(abs(t - x) < width for part in parts for x in part):
        return None
    return any(a < t < b if a < b else t > a or t < b for a, b in parts)


def normals(oracle, t, step):
    """Unit normals to the left, by differences."""
    v = oracle(t + step) - oracle(t - step)
    n = np.stack([-v[:, 1], v[:, 0]], axis=1)
    return n / np.linalg.norm(n, axis=1)[:, None]


def margins(oracle, points, d):
    """By how much points are farther from the curve than d, with many samples."""
    return nearest_of(oracle, points, 400)[1] - abs(d)


def differs_parts(oracle, parts, d):
    """What is wrong with the parts of the curve."""
    a, b = oracle.breaks[0], oracle.breaks[-1]
    step = (b - a) / oracle.segments / SAMPLES
    t = np.concatenate([low + (np.arange(SAMPLES) + 0.5) * (high - low) / SAMPLES for low, high in oracle.pieces])
    points = oracle(t) + d * normals(oracle, t, step * 1e-5)
    for x, margin in zip(t, margins(oracle, points, d), strict=True):
        kept = inside(x, parts, BESIDE * (b - a))
        if kept and margin < -CLOSE:
            return f"{x} is not true: {margin}"
        if kept is False and margin > -1e-12 and abs(margin) < CLOSE and not near_end(oracle, x, d, step):
            return f"{x} is true: {margin}"
    return ""


def near_end(oracle, x, d, step):
    """Whether a point beside is clearly not true: the oracle does not tell this one from them."""
    t = np.array([x - step / 2, x + step / 2])
    t = np.clip(t, oracle.breaks[0] + 1e-9, oracle.breaks[-1] - 1e-9)
    return margins(oracle, oracle(t) + d * normals(oracle, t, step * 1e-5), d).min() < -CLOSE


def differs_arcs(oracle, corners, found, d, size):
    """What is wrong with the arcs about corners that turn away."""
    for t in corners:
        centre = oracle(np.array([float(t)]))[0]
        own = [
            tuple(
                np.arctan2(
                    *(
                        float(x.values[f"{end} {axis}"].rational_near(20) / size) - c
                        for axis, c in (("y", centre[1]), ("x", centre[0]))
                    )
                )
                for end in ("start", "end")
            )
            for x in found
            if x.what != "part" and x.values["corner"] == t
        ]
        angles = np.linspace(-pi, pi, 90, endpoint=False) + 0.0123
        points = centre + abs(d) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        beside = (
            winding(oracle, points) == oracle.inner if d * oracle.turn > 0 else winding(oracle, points) != oracle.inner
        )
        for angle, margin, same_side in zip(angles, margins(oracle, points, d), beside, strict=True):
            kept = inside(angle, own, 0.02)
            if kept and (margin < -CLOSE or not same_side):
                return f"the arc about {t} at {angle}: {margin}"
            if kept is False and margin > -1e-12 and same_side:
                return f"no arc about {t} at {angle}: {margin}"
    return ""


def winding(oracle, points):
    """Winding numbers by the angles of samples."""
    t, _ = oracle.samples(200)
    z = oracle(t)
    w = (z[None, :, 0] - points[:, None, 0]) + 1j * (z[None, :, 1] - points[:, None, 1])
    return np.rint(np.angle(w[:, 1:] * w[:, :-1].conj()).sum(axis=1) / 2 / pi).astype(int)


def turned(curve, random):
    """The curve, or the reversed one."""
    return curve.reverse() if random.random() < 0.5 else curve


def drawn_distance(random, size):
    """A signed distance of the size of a curve."""
    return size * mpq(random.randint(1, 20), random.choice([10, 25, 40, 100])) * random.choice([-1, 1])


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is; the name of an error where it is refused."""
    random, number = Random(f"{family} {dial} {seed}"), DIALS[dial]
    with suppress(WeightError):
        curve = turned(FAMILIES[family](number, random), random)
    size = max(abs(x) for p in curve.control_points for x in p) or mpq(1)
    d = drawn_distance(random, size)
    try:
        found = ask(curve, f"offset_parts:{d}")
    except (ShapeError, ReachError) as error:
        return type(error).__name__
    oracle = Oracle(curve, size)
    oracle.pieces = [(float(a), float(b)) for a, b in zip(curve.breakpoints, curve.breakpoints[1:], strict=False)]
    z = oracle(oracle.samples(200)[0])
    area = (z[:-1, 0] * z[1:, 1] - z[1:, 0] * z[:-1, 1]).sum()
    oracle.turn = oracle.inner = 1 if area > 0 else -1
    parts = [tuple(float(x.values[end]) for end in ("start", "end")) for x in found if x.what == "part"]
    near = float(d / size)
    if wrong := differs_parts(oracle, parts, near):
        return f"d = {d}: {wrong}"
    corners = [x.parameter for x in ask(curve, "corners")]
    if wrong := differs_arcs(oracle, corners, found, near, size):
        return f"d = {d}: {wrong}"
    grid = np.stack(np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41)), axis=-1).reshape(-1, 2)
    own = (winding(oracle, grid) == oracle.inner) == (d * oracle.turn > 0)
    if own.any() and not found and (margins(oracle, grid[own], near) > CLOSE).any():
        return f"d = {d}: not empty"
    return ""


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:], in_turn=True))
