"""Many lengths, areas, moments and centroids, parameters at lengths and at coordinates, against mpmath: seeded.

python -m tests.campaigns.measures 50 1
python -m tests.campaigns.measures 1 4711 --family arcs --dial doubles       one case again

The oracle shares no code: segments are interpolated from values by the recursion of Cox and de Boor, moments are
integrals over dy alone, and mpmath integrates at 50 digits. Where its own estimate of the error is too large, a case is
counted and not judged; so is what the answer leaves open.
"""

import re
import sys
from fractions import Fraction
from itertools import pairwise
from random import Random

import mpmath
from gmpy2 import mpq

from exactspline import Nurbs, analyse, example
from exactspline.errors import OpenError
from tests.support.dials import DIALS
from tests.support.families import by_families

#: Digits of the oracle, and the relative difference that is one.
DIGITS, CLOSE = 50, mpmath.mpf(10) ** -22
#: The answer leaves it open; the oracle does.
OPEN, UNJUDGED = "open", "not judged"
#: The dials whose sizes a curve as a whole may have.
SCALES = {"doubles · 1e300", "doubles · 1e-300"}


# ---- curves


def weights(count, random):
    """All 1, small integers, or doubles."""
    kind = random.random()
    if kind < 0.4:
        return [mpq(1)] * count
    return [mpq(random.randint(1, 4)) if kind < 0.7 else mpq(random.uniform(0.2, 3)) for _ in range(count)]


def knots(degree, segments, random):
    """Clamped, their inner ones of any multiplicity."""
    inner = [mpq(t) for t in range(1, segments) for _ in range(random.randint(1, degree))]
    return [mpq(0)] * (degree + 1) + inner + [mpq(segments)] * (degree + 1)


def splines(random, number):
    """A curve in the plane; half of them are closed."""
    degree, segments = random.choice([(1, 3), (2, 1), (2, 3), (3, 1), (3, 2), (4, 1)])
    own = knots(degree, segments, random)
    points = [(number(random), number(random)) for _ in range(len(own) - degree - 1)]
    if random.random() < 0.5:
        points[-1] = points[0]
    return Nurbs(degree, own, points, weights(len(points), random))


def in_space(random, number):
    """A curve in space."""
    degree, segments = random.choice([(1, 2), (2, 2), (3, 1), (3, 2)])
    own = knots(degree, segments, random)
    points = [tuple(number(random) for _ in range(3)) for _ in range(len(own) - degree - 1)]
    return Nurbs(degree, own, points, weights(len(points), random))


def arcs(random, number):
    """A circle or an ellipse, whole or closed by its chord or over its centre; placed by an affine map."""
    whole = example("circle")
    points, own, degree = list(whole.control_points), list(whole.weights), 2
    count = random.choice([2, 4, 6, 8])
    points, own = points[: count + 1], own[: count + 1]
    for corner in [] if count == 8 else random.choice([[(0, 0)], []]):
        points, own = [*points, *[between(points[-1], corner), corner]], [*own, 1, 1]
    if count != 8:
        points, own = [*points, between(points[-1], points[0]), points[0]], [*own, 1, 1]
    pieces = (len(points) - 1) // 2
    made = Nurbs(degree, [0, *[t for t in range(pieces + 1) for _ in range(2)], pieces], points, own)
    a, b, c, d = (number(random) for _ in range(4))
    turn = [[a, -b], [b, a]] if random.random() < 0.6 else [[a, b], [c, d]]
    return made.transform([[*row, number(random)] for row in turn])


def between(first, second):
    return tuple((x + y) / mpq(2) for x, y in zip(first, second, strict=True))


def hodographs(random, number):
    """A polynomial curve whose speed is a polynomial: x′ = u² − v², y′ = 2uv."""
    u, v = ([number(random) for _ in range(2)] for _ in range(2))
    squares = lambda p, q: [p[0] * q[0], (p[0] * q[1] + p[1] * q[0]) / 2, p[1] * q[1]]  # noqa: E731
    rows = [[x - y for x, y in zip(squares(u, u), squares(v, v), strict=True)], [2 * x for x in squares(u, v)]]
    sums = [[sum(row[:k], mpq(0)) / 3 for k in range(4)] for row in rows]
    return Nurbs(3, [0] * 4 + [1] * 4, list(zip(*sums, strict=True)))


FAMILIES = {"splines": splines, "arcs": arcs, "in space": in_space, "hodographs": hodographs}


# ---- the oracle


def fraction(x):
    return Fraction(int(mpq(x).numerator), int(mpq(x).denominator))


def basis(i, n, t, own):
    """The recursion of Cox and de Boor, in fractions."""
    if n == 0:
        return Fraction(own[i] <= t < own[i + 1])
    left = (t - own[i]) / (own[i + n] - own[i]) if own[i + n] > own[i] else Fraction(0)
    right = (own[i + n + 1] - t) / (own[i + n + 1] - own[i + 1]) if own[i + n + 1] > own[i + 1] else Fraction(0)
    return left * basis(i, n - 1, t, own) + right * basis(i + 1, n - 1, t, own)


def interpolated(xs, ys):
    """The coefficients, highest first, of the polynomial through points: Newton's differences, multiplied out."""
    table, newton = list(ys), []
    for k in range(len(xs)):
        newton.append(table[0])
        table = [(b - a) / (xs[i + k + 1] - xs[i]) for i, (a, b) in enumerate(pairwise(table))]
    found = [newton[-1]]
    for c, x in zip(newton[-2::-1], xs[len(newton) - 2 :: -1], strict=False):
        found = [a - x * b for a, b in zip([*found, Fraction(0)], [Fraction(0), *found], strict=True)]
        found[-1] += c
    return found


class Oracle:
    """Homogeneous polynomials of a curve, segment by segment, over the parameter itself."""

    def __init__(self, curve):
        own, n = [fraction(t) for t in curve.knots], curve.degree
        rows = [[*(x * w for x in p), w] for p, w in zip(curve.control_points, curve.weights, strict=True)]
        self.size = max((abs(fraction(x)) for p in curve.control_points for x in p), default=0) or Fraction(1)
        rows = [[*(fraction(x) / self.size for x in row[:-1]), fraction(row[-1])] for row in rows]
        self.pieces = []
        for a, b in [(a, b) for a, b in pairwise(own) if a < b and own[n] <= a and b <= own[-n - 1]]:
            at = [a + (b - a) * Fraction(k, n + 2) for k in range(n + 1)]
            values = [
                [sum(basis(i, n, t, own) * row[k] for i, row in enumerate(rows)) for t in at]
                for k in range(len(rows[0]))
            ]
            self.pieces.append((a, b, [interpolated(at, v) for v in values]))

    def integral(self, of, low=None, high=None, power=1):
        """An integral along the curve between two parameters, which grows with this power of the size; None where
        mpmath is not sure of it.
        """
        total, size = mpmath.mpf(0), mpmath.mpf(0)
        for a, b, polynomials in self.pieces:
            ends = [
                max(number(a), low) if low is not None else number(a),
                min(number(b), high) if high is not None else number(b),
            ]
            if ends[0] >= ends[1]:
                continue
            columns = [([number(c) for c in p], [number(c) for c in derived(p)]) for p in polynomials]
            value, error = mpmath.quad(lambda t: of(*at(columns, t)), ends, error=True, maxdegree=9)  # noqa: B023
            total, size = total + value, size + abs(value)
            if error > CLOSE / 100:
                return None
        return total * number(self.size) ** power

    def roots(self, axis, value):
        """The parameters at which a coordinate has a value, by the zeros of polynomials; None where it is constant."""
        found = []
        for a, b, polynomials in self.pieces:
            p = [x - fraction(value) / self.size * w for x, w in zip(polynomials[axis], polynomials[-1], strict=True)]
            while p and not p[0]:
                p = p[1:]
            if not p:
                return None
            zeros = mpmath.polyroots([number(c) for c in p], maxsteps=500, extraprec=400) if len(p) > 1 else []
            margin = number(b - a) * mpmath.mpf(10) ** -12
            found += [
                z.real for z in zeros if abs(z.imag) < margin and number(a) - margin <= z.real <= number(b) + margin
            ]
        return found


def number(x):
    return mpmath.mpf(x.numerator) / x.denominator


def derived(p):
    return [c * (len(p) - 1 - k) for k, c in enumerate(p[:-1])] or [Fraction(0)]


def at(columns, t):
    """Point and velocity."""
    *numerators, (w, slope) = [(mpmath.polyval(p, t), mpmath.polyval(q, t)) for p, q in columns]
    return [x / w for x, _ in numerators], [(d * w - x * slope) / w**2 for x, d in numerators]


def speed(point, velocity):
    return mpmath.sqrt(sum(x * x for x in velocity))


def moment_of(i, j):
    return lambda point, velocity: point[0] ** (i + 1) * point[1] ** j * velocity[1] / (i + 1)


# ---- what is compared


def near(x, y, scale=None):
    """Whether two numbers agree, relative to the larger one or to a scale."""
    return abs(x - y) <= CLOSE * max(abs(x), abs(y), scale or 0)


def enclosed(x, size):
    """A number as mpmath has it, with digits that go with its size."""
    digits = 30 - int(mpmath.floor(mpmath.log10(size))) if size else 30
    return number(x.enclosure(max(digits, 0)).middle)


def text_value(form):
    """The value of a closed form."""
    form = re.sub(r"(\d+)(?=[√π(])|(\d+) (?=arctan)|\)(?=π)|\) (?=arctan)", lambda m: m.group(0).strip() + "*", form)
    form = re.sub(r"√(\d+)", r"sqrt(mpf(\1))", form)
    form = re.sub(r"(?<![\w(])(\d+)", r"mpf(\1)", form)
    return eval(form, {"π": mpmath.pi, "arctan": mpmath.atan, "sqrt": mpmath.sqrt, "mpf": mpmath.mpf})


def agrees(x, expected, scale=None):
    """Whether a number is what the oracle has, and so is its closed form; None where the oracle has nothing."""
    if expected is None:
        return None
    size = max(abs(expected), scale or 0)
    same = near(enclosed(x, size), expected, scale)
    try:
        form = x.closed_form
    except OpenError:
        return same
    return same and (form is None or near(text_value(form), expected, scale))


def lengths(curve, oracle, random):
    facts, (a, b) = analyse(curve), curve.domain
    total = oracle.integral(speed)
    yield "length", agrees(facts.length, total)
    if not total:
        return
    low, high = sorted(a + (b - a) * mpq(random.randint(0, 96), 97) for _ in range(2))
    if low < high:
        part = oracle.integral(speed, number(low), number(high))
        yield "length_between", agrees(facts.length_between((low, high)), part, total)
    distance = facts.length.rational_near(15) * mpq(random.randint(1, 96), 97)
    reached = oracle.integral(speed, number(a), enclosed(facts.at_length(distance), number(b - a)))
    yield "at_length", None if reached is None else near(reached, number(distance), total)
    parts = random.randint(2, 4)
    places = [found.values["parameter"] for found in facts.equally_spaced(parts)]
    k = random.randint(1, parts - 1)
    reached = oracle.integral(speed, number(a), enclosed(places[k], number(b - a)))
    yield "equally_spaced", None if reached is None else near(reached, total * k / parts, total)


def areas(curve, oracle, random):
    facts, size = analyse(curve), max(abs(number(x)) for p in curve.control_points for x in p)
    if not curve.closed or not size:
        return
    area = oracle.integral(moment_of(0, 0), power=2)
    yield "area", agrees(facts.area, area, size**2)
    found = {(x.facts["x"], x.facts["y"]): x.values["moment"] for x in facts.moments(3)}
    i, j = random.choice(list(found))
    yield "moments", agrees(found[i, j], oracle.integral(moment_of(i, j), power=i + j + 2), size ** (i + j + 2))
    firsts = [oracle.integral(moment_of(*powers), power=3) for powers in ((1, 0), (0, 1))]
    if area is not None and None not in firsts and abs(area) > size**2 / 10**6:
        (centre,) = facts.centroid
        pairs = zip(centre.values.values(), firsts, strict=True)
        yield "centroid", all(near(enclosed(x, size), first / area, size * 10**6) for x, first in pairs)


def coordinates(curve, oracle, random):
    axis, (a, b) = random.randrange(curve.dimension), curve.domain
    value = curve(a + (b - a) * mpq(random.randint(0, 8), 8))[axis] + random.choice([0, 0, 1]) * mpq(oracle.size) / 7
    found, expected = analyse(curve).at_coordinate((axis, value)), oracle.roots(axis, value)
    if expected is None:
        yield "at_coordinate", bool(found.everywhere)
        return
    places = [number(f.root.enclosure(30).middle) for f in found if not f.by_jump]
    margin = number(b - a) * mpmath.mpf(10) ** -9
    if curve.closed:
        # the seam is told once, at the start
        expected = [number(a) if abs(x - number(b)) < margin else x for x in expected]
    # each is near one of the other's
    both = all(
        any(abs(x - y) < margin for y in other) for own, other in ((places, expected), (expected, places)) for x in own
    )
    yield "at_coordinate", both and not found.everywhere


def compared(curve, random):
    """What is compared of one curve: the questions, each with True, False, or the reason why it is not judged."""
    with mpmath.workdps(DIGITS):
        oracle = Oracle(curve)
        for questions in (lengths, coordinates, *([areas] if curve.dimension == 2 else [])):
            try:
                for name, agreed in questions(curve, oracle, random):
                    yield name, UNJUDGED if agreed is None else agreed
            except OpenError:
                yield questions.__name__, OPEN


def differs(family, dial, seed):
    """The questions whose answer about one curve is wrong; what is not judged where none is."""
    random = Random(f"{family} {dial} {seed}")
    told = list(compared(FAMILIES[family](random, DIALS[dial]), random))
    wrong = [name for name, agreed in told if agreed is False]
    return ", ".join(wrong) or next((x for _, x in told if x in (OPEN, UNJUDGED)), "")


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:]))
