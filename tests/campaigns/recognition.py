"""Arcs of lines, circles and conics, and patches of planes, spheres, cylinders, cones and tori, rounded and disturbed,
against distances computed without the library: ``python -m tests.campaigns.recognition 1000``.

Every curve is drawn from a family by a seed. Of everything that is recognized, the distance is measured at many points
of the piece; that the bound is not far too large is measured, too. That the piece does not turn back is looked at for
lines and around a centre, not for parabolas; distances from points of the arc to the piece are not measured. Arcs
that were moved by a tenth of epsilon must be recognized; arcs that no shape of their kind fits within epsilon, by a
search of its own, must not. The exit status is 1 where anything is different. The result of the last whole run stands
in `docs/rounded-input.md`.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Sequence
from itertools import combinations, pairwise, product
from math import dist, hypot
from random import Random

from gmpy2 import mpq
from mpmath import mp, mpf

from exactspline import Nurbs, NurbsSurface, example
from exactspline.geometry.recognition.patches import RecognizedPart, recognized_surface
from exactspline.geometry.recognition.pieces import RecognizedPiece, recognized
from exactspline.geometry.recognition.shapes import Circle, Line
from tests.support.vectors import cross, dot, mpf_of

SEED = 2031
#: Points of a piece at which distances are measured.
POINTS = 40
#: Distances are measured on one arc of this many.
EVERY = 10
EPSILON = mpq(1, 10**6)


def rounded(x: mpq, digits: int) -> mpq:
    """A number with a number of decimals."""
    unit = mpq(1, 10**digits)
    return (x / unit + mpq(1, 2)) // 1 * unit


def placed(random: Random, rows: list[list[mpq]]) -> list[list[mpq]]:
    """Homogeneous points of the plane turned, scaled and moved by rational numbers."""
    m, n = random.randint(1, 9), random.randint(1, 9)
    c, s = mpq(m * m - n * n, m * m + n * n), mpq(2 * m * n, m * m + n * n)
    scale, dx, dy = mpq(random.randint(1, 40), 8), mpq(random.randint(-40, 40), 7), mpq(random.randint(-40, 40), 9)
    return [[scale * (c * x - s * y) + dx * w, scale * (s * x + c * y) + dy * w, w] for x, y, w in rows]


def circle_rows(random: Random) -> list[list[mpq]]:
    """An arc of the unit circle of degree 2: (1 − t², 2t, 1 + t²) on a random interval."""
    a = mpq(random.randint(-12, 8), 8)
    b = a + mpq(random.randint(2, 10), 8)
    return [[1 - a * a, 2 * a, 1 + a * a], [1 - a * b, a + b, 1 + a * b], [1 - b * b, 2 * b, 1 + b * b]]


def ellipse_rows(random: Random) -> list[list[mpq]]:
    """An arc of an ellipse that is no circle."""
    stretch = mpq(random.randint(9, 24), 8)
    return [[x * stretch, y, w] for x, y, w in circle_rows(random)]


def hyperbola_rows(random: Random) -> list[list[mpq]]:
    """An arc of x y = 1, at t from a to b: (t², 1, t)."""
    a = mpq(random.randint(2, 12), 8)
    b = a + mpq(random.randint(2, 8), 8)
    return [[a * a, mpq(1), a], [a * b, mpq(1), (a + b) / 2], [b * b, mpq(1), b]]


def parabola_rows(random: Random) -> list[list[mpq]]:
    """An arc of y = x²."""
    a = mpq(random.randint(-12, 8), 8)
    b = a + mpq(random.randint(2, 8), 8)
    return [[a, a * a, mpq(1)], [(a + b) / 2, a * b, mpq(1)], [b, b * b, mpq(1)]]


def line_rows(random: Random) -> list[list[mpq]]:
    """A segment of the x axis, at a speed that varies."""
    return [[mpq(-1), mpq(0), mpq(1)], [mpq(random.randint(-3, 3), 8), mpq(0), mpq(1)], [mpq(1), mpq(0), mpq(1)]]


FAMILIES = {
    "line": line_rows,
    "circle": circle_rows,
    "ellipse": ellipse_rows,
    "parabola": parabola_rows,
    "hyperbola": hyperbola_rows,
}


def arc(family: str, random: Random) -> Nurbs:
    """An exact arc of degree 2 or 3, in one to three segments."""
    rows = placed(random, FAMILIES[family](random))
    curve = Nurbs.from_homogeneous(2, [0, 0, 0, 1, 1, 1], rows)
    if random.random() < 0.5:
        curve = curve.elevate_degree()
    for _ in range(random.randint(0, 2)):
        curve = curve.insert_knot(mpq(random.randint(1, 15), 16))
    return curve


def moved(curve: Nurbs, by: mpq, random: Random) -> Nurbs:
    """The curve with every coordinate changed by at most a number."""
    points = [tuple(x + by * mpq(random.randint(-1000, 1000), 1000) for x in p) for p in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, curve.weights)


def as_written(curve: Nurbs, digits: int) -> Nurbs:
    """The curve with coordinates and weights of a number of decimals."""
    points = [tuple(rounded(x, digits) for x in p) for p in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, [rounded(w, digits) for w in curve.weights])


# ---- distances, without the library


def number(x: object) -> mpf:
    """An exact number, or one that prints itself, in the working precision."""
    if hasattr(x, "numerator"):
        return mpf_of(x)
    return mpf(str(x.decimal(40)))


def distance(shape: object, point: tuple[mpf, ...]) -> mpf:
    """From a point to a line, a circle in the plane, or a conic (by Newton's method on the nearest point)."""
    x, y = point
    if isinstance(shape, Line):
        (a, b), (u, v) = (tuple(map(number, pair)) for pair in (shape.point, shape.direction))
        return abs((x - a) * v - (y - b) * u) / mp.hypot(u, v)
    if isinstance(shape, Circle):
        a, b = map(number, shape.centre)
        return abs(mp.hypot(x - a, y - b) - mp.sqrt(number(shape.radius_squared)))
    largest = max(abs(k) for row in shape.matrix for k in row)
    (a, b, d), (_, c, e), (_, _, f) = [[number(k / largest) for k in row] for row in shape.matrix]
    u, v, k = x, y, mpf(0)
    for _ in range(60):
        g, h = 2 * (a * u + b * v + d), 2 * (b * u + c * v + e)
        value = a * u * u + 2 * b * u * v + c * v * v + 2 * d * u + 2 * e * v + f
        system = mp.matrix([[1 + 2 * k * a, 2 * k * b, g], [2 * k * b, 1 + 2 * k * c, h], [g, h, 0]])
        step = mp.lu_solve(system, -mp.matrix([u - x + k * g, v - y + k * h, value]))
        u, v, k = u + step[0], v + step[1], k + step[2]
        if max(map(abs, step)) < mpf(10) ** -45:
            break
    return mp.hypot(u - x, v - y)


def points_of(curve: Nurbs, a: mpq, b: mpq, count: int = POINTS) -> list[tuple[mpf, ...]]:
    """Points of a piece, by de Boor's algorithm on homogeneous points."""
    return [tuple(map(number, curve(a + (b - a) * mpq(i, count)))) for i in range(count + 1)]


def wrong(curve: Nurbs, epsilon: mpq, pieces: Sequence[RecognizedPiece], count: int = POINTS) -> str:
    """What is wrong with the pieces that are recognized of a curve, "" for nothing."""
    for found in pieces:
        ((a, b),) = found.piece.parts
        within = number(found.within)
        far = max(distance(found.shape, p) for p in points_of(curve, a, b, count))
        if found.within > epsilon:
            return f"a bound above epsilon: {found.within}"
        if far > within + mpf(10) ** -35:
            return f"{far} away from {found.shape}, not {within}"
        if far * 5 < within:
            return f"{within} proved where {far} was measured"
        if not goes_on(found.shape, points_of(curve, a, b, count)):
            return f"it turns back along {found.shape}, or runs over a part of it twice"
    return ""


def goes_on(shape: object, points: list[tuple[mpf, ...]]) -> bool:
    """Whether points come one after the other along a line, or around the centre, in one turn at most."""
    if isinstance(shape, Line):
        u, v = map(number, shape.direction)
        along = [x * u + y * v for x, y in points]
    elif shape.centre is None:
        return True
    else:
        a, b = map(number, shape.centre)
        angles = [mp.atan2(y - b, x - a) for x, y in points]
        turns = [(after - before + mp.pi) % (2 * mp.pi) - mp.pi for before, after in pairwise(angles)]
        along = [mp.fsum(turns[:k]) for k in range(len(points))]
    ordered = along in (sorted(along), sorted(along, reverse=True))
    return ordered and (isinstance(shape, Line) or abs(along[-1]) < 2 * mp.pi + mpf(10) ** -20)


def fits(curve: Nurbs, epsilon: mpq) -> bool:
    """Whether a circle or a line comes within twice epsilon of points of a curve: in doubles, whose errors are far
    smaller. The centre is sought on a shrinking grid around that of the circle through three points.
    """
    points = [tuple(map(float, point)) for point in points_of(curve, *curve.domain, 24)]
    limit = 2 * float(epsilon)
    (x1, y1), (x2, y2), (x3, y3) = points[0], points[12], points[24]
    chord = hypot(x3 - x1, y3 - y1)
    if max(abs((x - x1) * (y3 - y1) - (y - y1) * (x3 - x1)) for x, y in points) < 2 * limit * chord:
        return True
    straight = 2 * ((x2 - x1) * (y3 - y1) - (y2 - y1) * (x3 - x1))
    if not straight:
        return False
    s2, s3 = (x2 - x1) ** 2 + (y2 - y1) ** 2, (x3 - x1) ** 2 + (y3 - y1) ** 2
    a, b = x1 + ((y3 - y1) * s2 - (y2 - y1) * s3) / straight, y1 + ((x2 - x1) * s3 - (x3 - x1) * s2) / straight

    def spread(u: float, v: float) -> float:
        radii = [hypot(x - u, y - v) for x, y in points]
        return (max(radii) - min(radii)) / 2

    best, step = spread(a, b), hypot(a - x1, b - y1) / 8
    for _ in range(300):
        around = [(a + step * i, b + step * j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        value, place = min((spread(*p), p) for p in around)
        a, b, best, step = (*place, value, step) if value < best else (a, b, best, step / 2)
    return best < limit


@mp.workdps(50)
def campaign(count: int, seed: int = SEED) -> Counter[str]:
    """A number of curves of each kind; what was found, by kind, and what is wrong."""
    random, found = Random(seed), Counter[str]()
    for i in range(count):
        family = list(FAMILIES)[i % len(FAMILIES)]
        exact = arc(family, random)
        pieces = recognized(exact, EPSILON)
        found["exact arcs"] += 1
        simpler = len(pieces) == 1 and pieces[0].shape.kind in ("line", "circle")
        if len(pieces) != 1 or not (simpler or (pieces[0].exact and pieces[0].shape.kind == family)):
            found[f"WRONG: an exact {family} is {pieces}"] += 1
        near = moved(exact, EPSILON / 10 / 2, random)
        pieces = recognized(near, EPSILON)
        found["arcs moved by a tenth of epsilon"] += 1
        if len(pieces) != 1 or pieces[0].kind not in (family, "line", "circle"):
            found[f"WRONG: a moved {family} is {pieces}"] += 1
        for curve in (near, as_written(exact, 12)) if i % EVERY == 0 else ():
            found["curves measured"] += 1
            if what := wrong(curve, EPSILON, recognized(curve, EPSILON)):
                found[f"WRONG: {what}"] += 1
        far = moved(exact, 10 * EPSILON, random)
        pieces = recognized(far, EPSILON)
        shapes = {piece.shape.kind.value for piece in pieces if piece.piece.parts[0] == far.domain}
        if shapes & {"line", "circle"} and not fits(far, EPSILON):
            found[f"WRONG: {shapes} fits although none does"] += 1
        if what := wrong(far, EPSILON, pieces, 16):
            found[f"WRONG: {what}"] += 1
        found["arcs moved by 10 epsilon"] += 1
        found["of these recognized and measured"] += bool(pieces)
        for _ in range(10):
            degree = random.randint(3, 5)
            net = [(mpq(random.randint(-99, 99), 8), mpq(random.randint(-99, 99), 8)) for _ in range(degree + 1)]
            found["random curves"] += 1
            curve = Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), net)
            pieces = recognized(curve, EPSILON)
            found["random curves that are a shape"] += bool(pieces)  # a cubic of degree 2, in one of about 10⁵
            if what := wrong(curve, EPSILON, pieces):
                found[f"WRONG: {what}"] += 1
    return found


# ---- in space


def turned(random: Random, columns: int = 3) -> list[list[mpq]]:
    """A rotation by a random quaternion, a scale, and a translation."""
    a, b, c, d = (random.randint(-5, 5) or 1 for _ in range(4))
    n = mpq(a * a + b * b + c * c + d * d)
    rows = [
        [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ]
    scale = mpq(random.randint(1, 40), 8)
    return [[scale * x / n for x in row[:columns]] + [mpq(random.randint(-40, 40), 7)] for row in rows]


def in_space(curve: Nurbs, random: Random) -> Nurbs:
    """A plane curve in a plane of space."""
    points = [(*p, mpq(0)) for p in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, curve.weights).transform(turned(random))


def patch(kind: str, random: Random) -> NurbsSurface:
    """A part of an exact surface."""
    if kind == "plane":
        net = [[(mpq(i), mpq(j), mpq(0)) for j in range(3)] for i in range(3)]
        weights = [[mpq(random.randint(8, 16), 8) for _ in range(3)] for _ in range(3)]
        return NurbsSurface((2, 2), [0] * 3 + [1] * 3, [0] * 3 + [1] * 3, net, weights).transform(turned(random))
    whole = example(kind)
    sides = []
    for low, high in whole.domain:
        a, b = sorted(random.sample(range(17), 2))
        sides.append((low + (high - low) * mpq(a, 16), low + (high - low) * mpq(b, 16)))
    return whole.restrict(*sides).transform(turned(random))


def moved_surface(surface: NurbsSurface, by: mpq, random: Random) -> NurbsSurface:
    """The surface with every coordinate changed by at most a number."""
    net = [
        [tuple(x + by * mpq(random.randint(-1000, 1000), 1000) for x in p) for p in row]
        for row in surface.control_points
    ]
    return NurbsSurface(surface.degree, *surface.knots, net, surface.weights)


def far_from(shape: object, point: tuple[mpf, ...]) -> mpf:
    """The distance of a point from a plane, a sphere, a cylinder, a double cone or a torus."""
    n = {name: [number(x) for x in values] for name, values in shape.numbers.items()}
    if shape.kind == "plane":
        return abs(mp.fdot(n["normal"], point) - n["offset"][0]) / mp.norm(n["normal"])
    start = n.get("centre") or n.get("point") or n["apex"]
    offset = [x - a for x, a in zip(point, start, strict=True)]
    whole = mp.norm(offset)
    if shape.kind == "sphere":
        return abs(whole - n["radius"][0])
    along = mp.fdot(offset, n["axis"]) / mp.norm(n["axis"])
    rho = mp.sqrt(abs(whole * whole - along * along))
    if shape.kind == "cylinder":
        return abs(rho - n["radius"][0])
    if shape.kind == "cone":
        angle = mp.atan(n["tan"][0])
        return abs(rho * mp.cos(angle) - abs(along) * mp.sin(angle))
    major, minor = n["radii"]
    return abs(mp.hypot(rho - major, along) - minor)


def wrong_surface(surface: NurbsSurface, found: Sequence[RecognizedPart], kind: str) -> str:
    """What is wrong with what is recognized of a surface that is nearly of a kind, "" for nothing."""
    if not found or not found[0].whole:
        return f"a moved {kind} is {[str(part.kind) for part in found]}"
    (part,) = found
    (a, b), (c, d) = surface.domain
    places = [(a + (b - a) * mpq(i, 12), c + (d - c) * mpq(j, 12)) for i in range(13) for j in range(13)]
    far = max(far_from(part.shape, tuple(map(number, surface(*place)))) for place in places)
    if far > number(part.within) + mpf(10) ** -35:
        return f"{far} away from {part.shape}, not {part.within}"
    if part.once and layers(surface, part.shape) != 1:
        return f"{layers(surface, part.shape)} layers of {part.shape}"
    return f"{part.within} proved where {far} was measured" if far * 6 < number(part.within) else ""


def layers(surface: NurbsSurface, shape: object, count: int = 6) -> int:
    """How many triangles of nearest points on a shape lie over one of some of these points, at most: of a grid of
    parameters, seen along the normal of the shape.
    """
    n = {name: [float(number(x)) for x in values] for name, values in shape.numbers.items()}

    def foot(place: tuple[mpq, mpq]) -> tuple[list[float], list[float]]:
        """The nearest point, and the normal there."""
        point = [float(x) for x in surface(*place)]
        if shape.kind == "plane":
            away = (dot(n["normal"], point) - n["offset"][0]) / dot(n["normal"], n["normal"])
            return [x - away * a for x, a in zip(point, n["normal"], strict=True)], n["normal"]
        start = n.get("centre") or n.get("point") or n["apex"]
        offset = [x - a for x, a in zip(point, start, strict=True)]
        if shape.kind == "sphere":
            scale = n["radius"][0] / hypot(*offset)
            return [a + scale * x for a, x in zip(start, offset, strict=True)], offset
        size = hypot(*n["axis"])
        axis = [x / size for x in n["axis"]]
        along = dot(offset, axis)
        radial = [x - along * a for x, a in zip(offset, axis, strict=True)]
        rho = hypot(*radial)
        out = [x / rho for x in radial]
        if shape.kind == "cylinder":
            r, z, normal = n["radius"][0], along, (1.0, 0.0)
        elif shape.kind == "cone":
            c, s = 1 / hypot(1, n["tan"][0]), n["tan"][0] / hypot(1, n["tan"][0])
            s = s if along > 0 else -s
            t = (rho * abs(s) + abs(along) * c) * (1 if along > 0 else -1)
            r, z, normal = t * s, t * c, (c, -s)
        else:
            major, minor = n["radii"]
            far = hypot(rho - major, along)
            normal = ((rho - major) / far, along / far)
            r, z = major + minor * normal[0], minor * normal[1]
        step, direction = ([a * x + b * y for x, y in zip(out, axis, strict=True)] for a, b in ((r, z), normal))
        return [a + x for a, x in zip(start, step, strict=True)], direction

    sides = surface.domain
    grid = [[foot(sides.at(mpq(i, count), mpq(j, count))) for j in range(count + 1)] for i in range(count + 1)]
    triangles = []
    for i, j in product(range(count), repeat=2):
        a, b, c, d = grid[i][j], grid[i + 1][j], grid[i][j + 1], grid[i + 1][j + 1]
        for corners in ((a, b, c), (b, c, d)):
            triangles.append((corners, 1.1 * max(dist(p, q) for (p, _), (q, _) in combinations(corners, 2))))
    most = 0
    for i, j in product(range(count), repeat=2):
        at, normal = foot(sides.at((i + mpq(1, 3)) / count, (j + mpq(1, 5)) / count))
        smallest = min(range(3), key=lambda k: abs(normal[k]))
        e = cross(normal, [float(k == smallest) for k in range(3)])
        frame = e, cross(normal, e)
        over = 0
        for triangle, size in triangles:
            near = max(dist(p, at) for p, _ in triangle) < size
            if near and all(dot(m, normal) > 0 for _, m in triangle):
                flat = [[dot([x - y for x, y in zip(p, at, strict=True)], f) for f in frame] for p, _ in triangle]
                turns = [flat[k - 1][0] * flat[k][1] - flat[k - 1][1] * flat[k][0] for k in range(3)]
                over += min(turns) > 0 or max(turns) < 0
        most = max(most, over)
    return most


@mp.workdps(50)
def in_space_campaign(count: int, seed: int = SEED) -> Counter[str]:
    """Surfaces, exact and moved by a tenth of epsilon, and others; plane curves in space."""
    random, found = Random(seed), Counter[str]()
    for i in range(count):
        kind = ("plane", "sphere", "cylinder", "cone", "torus")[i % 5]
        exact = patch(kind, random)
        parts = recognized_surface(exact, EPSILON)
        found["exact patches"] += 1
        if len(parts) != 1 or not parts[0].whole or not (parts[0].exact and parts[0].kind == kind):
            found[f"WRONG: an exact {kind} is {[(str(part.shape), part.exact) for part in parts]}"] += 1
        found["of these injective"] += bool(parts) and parts[0].once
        found["patches moved by a tenth of epsilon"] += 1
        near_exact = moved_surface(exact, EPSILON / 20, random)
        parts = recognized_surface(near_exact, EPSILON)
        found["of those injective"] += any(part.once for part in parts)
        if what := wrong_surface(near_exact, parts, kind):
            found[f"WRONG: {what}"] += 1
        net = [[tuple(mpq(random.randint(-99, 99), 8) for _ in range(3)) for _ in range(3)] for _ in range(3)]
        found["random surfaces"] += 1
        if recognized_surface(NurbsSurface((2, 2), [0] * 3 + [1] * 3, [0] * 3 + [1] * 3, net), EPSILON):
            found["WRONG: a random surface is a shape"] += 1
        family = list(FAMILIES)[i % len(FAMILIES)]
        near = moved(in_space(arc(family, random), random), EPSILON / 20, random)
        pieces = recognized(near, EPSILON)
        found["arcs in space moved by a tenth of epsilon"] += 1
        if len(pieces) != 1 or pieces[0].kind not in (family, "line", "circle"):
            found[f"WRONG: a moved {family} in space is {[str(piece.shape) for piece in pieces]}"] += 1
    return found


def main() -> int:
    """Run the campaign and print what was found."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else SEED
    found = campaign(count, seed) + in_space_campaign(count // 10, seed)
    for what, count in sorted(found.items()):
        print(f"{count:8} {what}")
    return any(count for what, count in found.items() if what.startswith("WRONG"))


if __name__ == "__main__":
    sys.exit(main())
