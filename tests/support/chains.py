"""Closed chains of lines, circular arcs, conics and Pythagorean-hodograph cubics that know by construction where they
are straight, circular and have corners; the oracle of `tests/geometry/test_chains.py`.

Nothing here is shared with the toolkit but the class of curves: pieces are homogeneous Bézier points, and how they meet
is told by mpmath from one-sided derivatives by arc length, at sixty digits.
"""

from dataclasses import dataclass
from math import comb

import mpmath
from gmpy2 import mpq

from exactspline import Nurbs
from tests.support.vectors import dot, mpf_of, turn

DIGITS = 60
EQUAL = mpmath.mpf(10) ** -40


def vector(a, b):
    return tuple(y - x for x, y in zip(a, b, strict=True))


def add(a, b, scale=1):
    return tuple(x + scale * y for x, y in zip(a, b, strict=True))


def times(a, b):
    """The product of complex numbers."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


@dataclass(frozen=True)
class Piece:
    """A Bézier piece by Cartesian points and weights, what it is, and for arcs the circle it is part of."""

    kind: str
    points: tuple
    weights: tuple

    @property
    def homogeneous(self):
        return [(*(x * w for x in p), w) for p, w in zip(self.points, self.weights, strict=True)]

    @property
    def reversed(self):
        return Piece(self.kind, self.points[::-1], self.weights[::-1])

    def split(self, t):
        """Both parts at a parameter, by de Casteljau's algorithm."""
        rows, left, right = [self.homogeneous], [], []
        while rows[-1]:
            left.append(rows[-1][0])
            right.append(rows[-1][-1])
            rows.append([add(a, vector(a, b), t) for a, b in zip(rows[-1], rows[-1][1:], strict=False)])
        return [
            Piece(self.kind, tuple(tuple(x / w for x in p) for *p, w in part), tuple(w for *_, w in part))
            for part in (left, right[::-1])
        ]

    def contact(self):
        """Point, unit tangent, and the next two derivatives by arc length at the start, at `DIGITS` digits."""
        rows, n = self.homogeneous, len(self.points) - 1
        taylor, scale = [], mpq(1)
        for k in range(4):
            difference = [
                sum((-1) ** (k - j) * comb(k, j) * rows[j][i] for j in range(k + 1)) if k <= n else mpq(0)
                for i in range(len(rows[0]))
            ]
            taylor.append([x * comb(n, k) * scale for x in difference])
        p, w = [row[:-1] for row in taylor], [row[-1] for row in taylor]
        gamma = []
        for k in range(4):
            known = [sum(w[k - j] * gamma[j][i] for j in range(k)) for i in range(len(p[0]))]
            gamma.append([(a - b) / w[0] for a, b in zip(p[k], known, strict=True)])
        factorials = (1, 1, 2, 6)
        point, v, a, j = [[mpf_of(x * f) for x in row] for row, f in zip(gamma, factorials, strict=True)]
        speed = mpmath.sqrt(dot(v, v))
        tangent = [x / speed for x in v]
        along = dot(a, tangent)
        second = [(x - along * t) / speed**2 for x, t in zip(a, tangent, strict=True)]
        # by the chain rule: γ‴ = s′³ γ_sss + 3 s′ s″ γ_ss + s‴ γ_s, and what is along γ_s follows from the rest
        rest = [(x - 3 * speed * along * y) / speed**3 for x, y in zip(j, second, strict=True)]
        across = [x - dot(rest, tangent) * t for x, t in zip(rest, tangent, strict=True)]
        return point, tangent, second, across


def line(start, direction, length):
    return Piece("line", (start, add(start, direction, length)), (mpq(1), mpq(1)))


def arc(start, direction, reach, slope):
    """The arc that turns by 2 arctan(slope), its tangents of the length reach·|direction|."""
    middle = add(start, direction, reach)
    half = times((mpq(1), slope), (mpq(1), slope))
    end = add(middle, times(direction, half), reach / (1 + slope**2))
    return Piece("arc", (start, middle, end), (mpq(1), mpq(1), 1 + slope**2))


def conic(points, weight):
    """The conic through three control points; an arc or a line where it is one."""
    a, b = vector(points[0], points[1]), vector(points[1], points[2])
    if turn(a, b) == 0:
        return None
    cosine_squared = dot(a, vector(points[0], points[2])) ** 2 / dot(a, a) / dot(*[vector(points[0], points[2])] * 2)
    circular = dot(a, a) == dot(b, b) and weight * cosine_squared == 1
    return Piece("arc" if circular else "conic", tuple(points), (mpq(1), mpq(1), weight))


def pythagorean(start, direction, factor):
    """The cubic with hodograph direction·(1 − t + factor·t)²."""
    points = [start]
    for step in ((mpq(1), mpq(0)), factor, times(factor, factor)):
        points.append(add(points[-1], times(direction, step), mpq(1, 3)))
    return Piece("ph", tuple(points), (mpq(1),) * 4)


UNITS = [(mpq(a, c), mpq(b, c)) for a, b, c in ((0, 1, 1), (3, 4, 5), (-3, 4, 5), (-1, 0, 1), (5, -12, 13), (0, -1, 1))]


def pick(random, low=1, high=6):
    return mpq(random.randint(low, high), random.randint(1, 4))


def closed_chain(random, most=6):
    """A random closed chain in the plane, its pieces in order."""
    start = point = (mpq(random.randint(-3, 3)), mpq(random.randint(-3, 3)))
    # of an arc that ends here: the length of its tangents over that of the direction, and its slope
    direction, bent, found = (pick(random), pick(random)), None, []
    for _ in range(random.randint(1, most)):
        kind = random.choice(["line", "arc", "same arc", "conic", "ph", *["matched conic"] * (4 if bent else 0)])
        if random.random() < 0.4:
            direction, bent = times(direction, random.choice(UNITS)), None
        if kind.endswith("arc"):
            slope, reach = pick(random) * random.choice([1, -1]) / 2, pick(random)
            if kind == "same arc" and bent:
                slope = abs(slope) * (1 if bent[1] > 0 else -1)
                reach = bent[0] * slope / bent[1]
            piece, bent = arc(point, direction, reach, slope), (reach, slope)
            half = times((mpq(1), slope), (mpq(1), slope))
            direction = tuple(x / (1 + slope**2) for x in times(direction, half))
        else:
            piece = other_piece(random, kind, point, direction, bent)
            direction, bent = vector(*piece.points[-2:]), None
        found.append(piece)
        point = piece.points[-1]
    if point != start:
        found.append(closing(random, found, point, start))
    return found


def other_piece(random, kind, point, direction, bent):
    """A line, a Pythagorean cubic or a conic from a point in a direction; a matched conic goes on with the curvature of
    the arc before it.
    """
    if kind == "line":
        return line(point, direction, pick(random))
    if kind == "ph":
        return pythagorean(point, direction, (pick(random, -4), pick(random) * random.choice([1, -1])))
    reach, weight, side = pick(random), pick(random), (-direction[1], direction[0])
    middle = add(point, direction, reach)
    end = add(add(middle, direction, pick(random, -3)), side, pick(random) * random.choice([1, -1]))
    if kind == "matched conic" and bent:
        end = end if (height := turn(direction, vector(point, end))) * bent[1] > 0 else add(point, vector(end, point))
        weight = abs(2 * bent[1] * reach**2 * dot(direction, direction) / bent[0] / height)
    return conic((point, middle, end), weight)


def closing(random, found, point, start):
    """A conic that touches both ends where there is one, else a line."""
    a, b = vector(found[-1].points[-2], point), vector(found[0].points[0], found[0].points[1])
    sine = turn(a, b)
    if sine and random.random() < 0.7:
        along, back = turn(vector(point, start), b) / sine, turn(vector(point, start), a) / sine
        if along > 0 and back < 0:
            piece = conic((point, add(point, a, along), start), pick(random))
            if piece:
                return piece
    return Piece("line", (point, start), (mpq(1), mpq(1)))


def cut_and_rotated(random, chain):
    """The same chain with idle knots and the seam somewhere else."""
    cut = []
    for piece in chain:
        cut += piece.split(mpq(random.randint(1, 3), 4)) if random.random() < 0.4 else [piece]
    first = random.randrange(len(cut))
    return cut[first:] + cut[:first]


def as_curve(random, chain, embed=tuple):
    """The chain as one curve: pieces of one degree over intervals of any width, weights changed without changing the
    shape, all of one sign.
    """
    n = max(len(piece.points) for piece in chain) - 1 + random.choice([0, 0, 1])
    sign, t, knots, rows = random.choice([1, -1]), mpq(random.randint(-2, 2)), [], []
    for piece in chain:
        scale, ratio = pick(random) * sign, mpq(random.choice([1, 1, 2, 3]), random.choice([1, 2]))
        points = [tuple(x * scale * ratio**i for x in row) for i, row in enumerate(piece.homogeneous)]
        while len(points) <= n:
            m = len(points)
            raised = [add(tuple(x * mpq(i, m) for x in points[i - 1]), points[i], mpq(m - i, m)) for i in range(1, m)]
            points = [points[0], *raised, points[-1]]
        knots += [t] * (n + 1)
        t += pick(random)
        rows += [(*embed([x / w for x in p]), w) for *p, w in points]
    rows = [(*(x * w for x in p), w) for *p, w in rows]
    return Nurbs.from_homogeneous(n, [*knots, *[t] * (n + 1)], rows)


@dataclass(frozen=True)
class Meeting:
    """How two pieces meet: the order of continuity (3: or more) and the angle in degrees."""

    order: int
    degrees: object


def meeting(left, right):
    """By the derivatives by arc length on both sides, at `DIGITS` digits."""
    with mpmath.workdps(DIGITS):
        a, b = left.reversed.contact(), right.contact()
        # seen from the other side derivatives of odd order change their sign
        a = [[-x for x in part] if k % 2 else list(part) for k, part in enumerate(a)]
        cosine = dot(a[1], b[1])
        if len(a[1]) == 2:
            degrees = mpmath.degrees(mpmath.atan2(turn(a[1], b[1]), cosine))
        else:
            sine = mpmath.sqrt(abs(1 - cosine**2))
            degrees = mpmath.degrees(mpmath.atan2(sine if sine > EQUAL else 0, cosine))
        order = -1
        for x, y in zip(a, b, strict=True):
            if max(abs(u - v) for u, v in zip(x, y, strict=True)) > EQUAL:
                break
            order += 1
        return Meeting(order, degrees if order == 0 else None)


def curvature_at(piece):
    """κ at the start, with its sign in the plane."""
    with mpmath.workdps(DIGITS):
        _, tangent, second, _ = piece.contact()
        return turn(tangent, second) if len(tangent) == 2 else mpmath.sqrt(dot(second, second))


def expected_pieces(breaks, holds, joined):
    """The maximal cyclic runs of segments as sets of intervals: walks round from every place where a run can begin."""
    count = len(holds)
    if all(holds) and all(joined):
        return [((breaks[0], breaks[-1]),)]
    found = []
    for first in range(count):
        if not holds[first] or (holds[first - 1] and joined[first]):
            continue
        last = first
        while holds[(last + 1) % count] and joined[(last + 1) % count] and last + 1 < first + count:
            last += 1
        if last < count:
            found.append(((breaks[first], breaks[last + 1]),))
        else:
            found.append(((breaks[first], breaks[-1]), (breaks[0], breaks[last + 1 - count])))
    return found
