"""The converse: points that a stranger finds with two equal critical distances lie on what the answer says.

The oracle runs Newton's method on a random line for both feet and the point, in floats and then at sixty digits; it
knows the curves by their power basis alone.
"""

from itertools import product
from random import Random

import mpmath
import pytest
from gmpy2 import mpq

from exactspline import Root
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.language import Rational
from tests.support.bisector_answers import of_family, of_random_pair, random_pair
from tests.support.bisector_oracle import FAMILIES, bezier, power_basis, spans
from tests.support.sampled import FULL, sample
from tests.support.vectors import dot, mpf_of

with mpmath.workdps(60):
    NEAR = mpmath.mpf(10) ** -25
    SMALL = mpmath.mpf(10) ** -45


@pytest.fixture(autouse=True)
def sixty_digits():
    with mpmath.workdps(60):
        yield


# ---- the oracle


def derivatives(rows, t, number):
    """γ, γ′ and γ″ in floats or in mpmath's numbers, from w γ = p."""
    taylor = []
    for row in rows:
        values = [number(0)] * 3
        for c in reversed(row):
            values = [values[0] * t + c, values[1] * t + values[0], values[2] * t + values[1]]
        taylor.append([values[0], values[1], 2 * values[2]])
    *tops, (w, w1, w2) = taylor
    gamma = [p / w for p, _, _ in tops]
    first = [(p1 - g * w1) / w for (_, p1, _), g in zip(tops, gamma, strict=True)]
    return gamma, first, [(p2 - 2 * g1 * w1 - g * w2) / w for (_, _, p2), g, g1 in zip(tops, gamma, first, strict=True)]


def equations(one, other, line, x, number):
    """Both feet critical, both distances equal, at s, t and the place on the line; and the matrix of derivatives."""
    s, t, u = x
    origin, way = line
    b = [p + u * q for p, q in zip(origin, way, strict=True)]
    (g, g1, g2), (h, h1, h2) = derivatives(one, s, number), derivatives(other, t, number)
    to_g, to_h = ([p - q for p, q in zip(b, foot, strict=True)] for foot in (g, h))
    zero = number(0)
    value = [dot(g1, to_g), dot(h1, to_h), (dot(to_g, to_g) - dot(to_h, to_h)) / 2]
    matrix = [
        [dot(g2, to_g) - dot(g1, g1), zero, dot(g1, way)],
        [zero, dot(h2, to_h) - dot(h1, h1), dot(h1, way)],
        [-dot(g1, to_g), dot(h1, to_h), dot(to_g, way) - dot(to_h, way)],
    ]
    return value, matrix, b


def solved(matrix, value):
    """Cramer's rule; None for a singular matrix."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    below = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    if not below:
        return None
    x, y, z = value
    return [
        (x * (e * i - f * h) - b * (y * i - f * z) + c * (y * h - e * z)) / below,
        (a * (y * i - f * z) - x * (d * i - f * g) + c * (d * z - y * g)) / below,
        (a * (e * z - y * h) - b * (d * z - y * g) + x * (d * h - e * g)) / below,
    ]


def newton(curves, line, start, steps, number):
    x = [number(c) for c in start]
    rows = [[[number(int(c.numerator)) / int(c.denominator) for c in row] for row in one] for one in curves]
    way = [[number(int(c.numerator)) / int(c.denominator) for c in v] for v in line]
    for _ in range(steps):
        try:
            value, matrix, b = equations(*rows, way, x, number)
            step = solved(matrix, value)
        except (ZeroDivisionError, OverflowError):
            return None
        if step is None or max(map(abs, x)) > 1000:
            return None
        x = [c - d for c, d in zip(x, step, strict=True)]
    return x, b, max(map(abs, step))


def points(curves, sides, random, tries):
    """Points with two equal critical distances on random lines: parameters and point, each at sixty digits."""
    for _ in range(tries):
        line = [[mpq(random.randint(-12, 12), 4) for _ in range(3)] for _ in range(2)]
        start = [*(float(a) + random.random() * float(b - a) for a, b in sides), random.uniform(-2, 2)]
        rough = newton(curves, line, start, 25, float)
        if rough is None or not rough[2] < 1e-8:
            continue
        found = newton(curves, line, rough[0], 5, mpmath.mpf)
        if found is None or found[2] > SMALL:
            continue
        (s, t, _), b, _ = found
        if all(number(low) + NEAR < x < number(high) - NEAR for x, (low, high) in zip((s, t), sides, strict=True)):
            yield s, t, b


# ---- what the answer says of them


def exact(x):
    return mpq(str(mpmath.nstr(x, 58)))


def near(b, point, scale=1):
    return max(abs(x - number(p)) for x, p in zip(b, point, strict=True)) < NEAR * scale


def on_line(b, point, direction):
    way = [x - number(p) for x, p in zip(b, point, strict=True)]
    d = [number(x) for x in direction]
    across = [way[1] * d[2] - way[2] * d[1], way[2] * d[0] - way[0] * d[2], way[0] * d[1] - way[1] * d[0]]
    return dot(across, across) < NEAR * dot(d, d)


def number(x):
    """A rational, or what has digits already."""
    return x if isinstance(x, mpmath.mpf) else mpf_of(x)


def digits(ball):
    return mpmath.mpf(ball.mid().str(50, radius=False))


def equation_holds(equation, s, t):
    return equation is None or abs(number(equation(s, t))) < NEAR


def of_surface(found, sides, s, t, b):
    patches = [patch for patch in found.patches if inside(patch.sides, sides)]
    for patch in patches:
        try:
            return near(b, patch.value(s, t))
        except ZeroDivisionError:
            return False
    return False


def inside(outer, inner):
    return all(a <= c and d <= b for (a, b), (c, d) in zip(outer, inner, strict=True))


def of_line(line, s, t, b):
    if not equation_holds(line.equation, s, t):
        return False
    if not line.pieces:
        enclosed = line.line(s, t)
        return on_line(b, *[[digits(x) for x in v] for v in (enclosed.point, enclosed.direction)])
    for one in line.pieces:
        own, other = (s, t) if one.of == 0 else (t, s)
        expected = one.other(own) if isinstance(one.other, Rational) else one.other
        if expected is not None and abs(number(expected) - number(other)) > NEAR:
            continue
        try:
            ends = [one.surface.at(z)(own) for z in (0, 1)]
        except ZeroDivisionError:
            continue
        if on_line(b, ends[0], [q - p for p, q in zip(*ends, strict=True)]):
            return True
    return False


def of_plane(plane, s, t):
    return plane.solutions in ("plane", "all of space") and equation_holds(plane.equation, s, t)


def explained(found, sides, s, t, b):
    s, t = exact(s), exact(t)
    return (
        of_surface(found, sides, s, t, b)
        or any(of_line(line, s, t, b) for line in found.lines if line.sides == sides)
        or any(of_plane(plane, s, t) for plane in found.planes if plane.sides == sides)
        or any(at(pair, s, t) for pair in found.pairs if pair.sides == sides)
    )


def at(pair, s, t):
    """Of a single pair no more than its place: a random line meets its plane, never its line."""
    return pair.solutions != "line" and all(
        abs(number(x.refine(40)[0] if isinstance(x, Root) else x) - number(y)) < NEAR
        for x, y in zip(pair.place, (s, t), strict=True)
    )


# ---- the tests


def unexplained(answer, first, second, seed, tries):
    """How many points were found, and those of which the answer says nothing."""
    random = Random(seed)
    assert answer.undecided == ()
    number_found, left = 0, []
    for (i, one), (j, other) in product(spans(first), spans(second)):
        curves = power_basis(first, i), power_basis(second, j)
        for s, t, b in points(curves, (one, other), random, tries):
            number_found += 1
            if not explained(answer, (one, other), s, t, b):
                left.append((float(s), float(t), [float(x) for x in b]))
    return number_found, left


#: Families on which a line through space meets no point at all, or none by Newton's method: every pair is singular.
WITHOUT = {
    *("a circle and itself", "parallel lines that meet in one normal plane", "parallel lines apart", "one line"),
    *("a point and a cubic", "a point and a line through it", "two points", "one point"),
}


@pytest.mark.parametrize("name", sample([name for name in FAMILIES if name not in WITHOUT], 12))
def test_points_of_families_lie_on_a_piece(name):
    count, left = unexplained(of_family(name), *FAMILIES[name], 1, 30)
    assert not left
    assert count


@pytest.mark.parametrize("seed", range(40 if FULL else 12))
def test_points_of_random_curves_lie_on_a_piece(seed):
    assert not unexplained(of_random_pair(seed), *random_pair(seed), seed, 6)[1]


@pytest.mark.parametrize("seed", range(4))
def test_points_of_generic_curves_lie_on_a_piece(seed):
    """Cubics, and with weights of which one may be zero."""
    random = Random(seed)

    def curve():
        control_points = [[mpq(random.randint(-9, 9), 4) for _ in range(3)] for _ in range(4)]
        weights = [1, random.choice([0, 2]), random.randint(1, 3), 1] if seed % 2 else None
        return bezier(*control_points, weights=weights)

    pair = curve(), curve()
    count, left = unexplained(curve_bisector(*pair), *pair, seed, 25)
    assert not left
    assert count


@pytest.mark.parametrize(
    "name", ["coaxial circles", "a cubic and its mirror image", "crossing lines", "parabolas in one plane"]
)
def test_a_point_beside_is_told_from_one_that_lies_on_a_piece(name):
    first, second = FAMILIES[name]
    answer, random = of_family(name), Random(3)
    (i, one), (j, other) = next(iter(spans(first))), next(iter(spans(second)))
    s, t, b = next(points((power_basis(first, i), power_basis(second, j)), (one, other), random, 200))
    assert explained(answer, (one, other), s, t, b)
    beside = [x + mpmath.mpf(10) ** -9 * k for x, k in zip(b, (1, 2, 4), strict=True)]
    assert not explained(answer, (one, other), s, t, beside)
