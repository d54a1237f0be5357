"""Many bisectors of ordinary data against an oracle that shares no code: seeded.

python -m tests.campaigns.bisectors 1000 1
python -m tests.campaigns.bisectors 1 6127 --family pairs --dial thirds      one case again

Numbers are small integers, thirds, decimals of ten digits, doubles of 17 digits, and such doubles times 1e±300. The
oracle takes curves in their power basis (de Boor's algorithm on polynomials), planes by Cramer's rule, real roots from
FLINT's isolation of complex ones, and distances from their definition; of the package it uses the numbers.
"""

import sys
import time
from itertools import product
from random import Random

from flint import arb, ctx, fmpq_poly
from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.errors import ExactSplineError
from exactspline.geometry.bisectors.trimmed import trimmed_bisector
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.roots.root import Root
from tests.support.bisector_oracle import (
    circle,
    dimension,
    divisor,
    flint,
    holds,
    mapped,
    planes,
    point_and_tangent,
    power_basis,
    spans,
)
from tests.support.dials import DIALS
from tests.support.families import SLOW, by_families
from tests.support.vectors import cross, dot

#: Per mille of the cases with one sort of numbers that may be left out or refused.
CEILING = 1
#: What is refused for good: a point on the curve has no bisector of the usual kind.
ON_THE_CURVE = "lies on the curve"


# ---- curves


def curve(number, random, dimension=3, *, doubled=True):
    """A curve of one or two segments: degrees 1 to 3, some rational, some with doubled end points."""
    degree, segments = random.choice([1, 1, 1, 2, 2, 3]), random.choice([1, 1, 1, 2])
    points = [[number(random) for _ in range(dimension)] for _ in range(degree + segments)]
    if doubled and degree > 1 and random.random() < 0.2:
        points[random.choice([1, -2])] = points[random.choice([0, -1])]
    knots = [0] * (degree + 1) + [1] * (segments - 1) + [segments] * (degree + 1)
    weights = [abs(number(random)) or 1 for _ in points] if random.random() < 0.2 and degree < 3 else None
    return Nurbs(degree, knots, points, weights)


def random_pair(number, random):
    """Two curves: of no kind, a curve and an image of it, plane curves, curves that meet."""
    first, second = curve(number, random), curve(number, random)
    shift = number(random)
    images = [
        lambda x, y, z: (x, y, -z),
        lambda x, y, z: (x, y, shift - z),
        lambda x, y, z: (y, x, z),
        lambda x, y, z: (x + shift, y, z),
        lambda x, y, z: (x, y, z),
    ]
    kind = random.choice(["any", "any", "image", "image", "plane", "meeting", "circles"])
    if kind == "image":
        second = mapped(first, random.choice(images))
    elif kind == "plane" and max(first.degree, second.degree) < 3:
        first, second = (mapped(c, lambda x, y, z: (x, y, shift)) for c in (first, second))
    elif kind == "meeting":
        start = first.control_points[0]
        second = Nurbs(second.degree, second.knots, [start, *second.control_points[1:]], second.weights)
    elif kind == "circles":
        first, second = circle(abs(number(random)) or 1, number(random), 1), circle(abs(shift) or 1, number(random), 1)
    return first, second


# ---- the oracle of two curves


def real_roots(p, side):
    """Balls around the real roots of a polynomial on a closed interval, a root near an end among them."""
    low, high = (flint(mpq(x)) for x in side)
    whole, found = p.numer(), []
    with ctx.workprec(200 + 4 * max(int(abs(x)).bit_length() for x in whole.coeffs())):
        for factor, _ in whole.factor()[1]:
            for root, _ in factor.complex_roots():
                if root.imag == 0 and not root.real < low and not root.real > high:
                    found.append(arb(root.real))
    return found


def of_slice(ends, s, side):
    """The parameters t with a line or a plane for their solutions for a rational s: balls, each with the kind; None
    where a curve has no tangent, "all" where every t has one.
    """
    (*p, w), (*q, v) = ends
    s = flint(s)
    a = [fmpq_poly([f.derivative()(s) * w(s) - f(s) * w.derivative()(s)]) for f in p]
    b = [f.derivative() * v - f * v.derivative() for f in q]
    if not any(a) or not any(b):
        return None
    chord = [f * w(s) - v * g(s) for f, g in zip(q, p, strict=True)]
    over, square = 2 * dot(b, chord), dot(chord, chord)
    normals = [cross(a, b), cross(a, chord), cross(b, chord)]
    numerators = [over * x + square * y for x, y in zip(cross(chord, a), normals[0], strict=True)]
    found, parallel = divisor([dot(a, cross(b, chord)), *numerators]), divisor([x for n in normals for x in n])
    if not found and parallel:
        return "all"
    places, found = [], found or divisor(chord)
    for factor in (fmpq_poly(f) for f, _ in found.numer().factor()[1] if f.degree() > 0):
        if not divisor(b) % factor:
            kind = "cusp"
        elif parallel % factor:
            kind = "line"
        else:
            kind = "nothing" if divisor(chord) % factor else "plane"
        places += [(t, kind) for t in real_roots(factor, side) if kind != "nothing"]
    return places


def near(t, place):
    """Whether a parameter of the answer is in a ball of the oracle."""
    low, high = t.refine(60) if isinstance(t, Root) else (t, t)
    return bool((arb(flint(low)) - place).contains(0) or (arb(flint(high)) - place).contains(0))


def at(equation, s):
    """An equation between s and t for one s: a polynomial in t, zero where every t solves it."""
    if equation is None:
        return fmpq_poly([])
    return sum((fmpq_poly([0] * j + [flint(x * s**i)]) for (i, j), x in equation.terms), fmpq_poly([]))


def said_of(found, sides, s):
    """The parameters t and kinds that the answer gives for the pairs of a patch with this s."""
    said = []
    for line in (x for x in found.lines if x.sides == sides):
        if not at(line.equation, s):
            return "all"
        for t in line.partners(s):
            on_root = line.over_root is not None and line.over_root.other == (s, t)[1 - line.over_root.of]
            on_piece = any(one.low <= (s, t)[one.of] <= one.high for one in line.pieces)
            if any((s, t)[one.of] in one.poles for one in line.pieces):
                continue  # said to be at infinity: this pair has no line
            if on_root or on_piece or (line.over_root is None and not line.pieces):
                said.append((t, "line"))
    for plane in (x for x in found.planes if x.sides == sides):
        if not at(plane.equation, s):
            return "all"
        said += [(t, "plane") for t in real_roots(at(plane.equation, s), sides[1])]
    return said + [(pair.t, str(pair.solutions)) for pair in found.pairs if pair.sides == sides and pair.s == s]


def polynomials_of(first, i, second, j):
    """Both curves on one knot span each: numerators and denominator."""
    return [[fmpq_poly([flint(x) for x in row]) for row in power_basis(c, k)] for c, k in ((first, i), (second, j))]


def differences(found, first, second, random):
    """What the answer says otherwise than the oracle, at random parameters and at ends of segments."""
    bad = []
    for (i, one), (j, other) in product(spans(first), spans(second)):
        ends = polynomials_of(first, i, second, j)
        for part in (mpq(random.randint(1, 58), 59), random.choice([mpq(0), mpq(1), mpq(1, 2)])):
            s, t = one[0] + (one[1] - one[0]) * part, other[0] + (other[1] - other[0]) * mpq(random.randint(1, 30), 31)
            rows = planes(point_and_tangent(first, i, s), point_and_tangent(second, j, t))
            if dimension(rows) == 0 and 0 < part < 1 and not holds(rows, found(s, t)):
                bad.append(f"not a point of the bisector at {s}, {t}")
            true, said = of_slice(ends, s, other), said_of(found, (one, other), s)
            # a pair at a knot is listed on one of the patches on both sides of it
            if found.undecided or true is None or true == said == "all" or part in (0, 1):
                continue
            if "all" in (true, said):
                bad.append(f"all of s = {s} on one side alone")
                continue
            inside = [(x, kind) for x, kind in true if not any(x.contains(flint(mpq(end))) for end in other)]
            bad += [
                f"{kind} at s = {s} is not told"
                for x, kind in inside
                if kind != "cusp" and not any(matches(t, x) and k == kind for t, k in said)
            ]
            bad += [
                f"{kind} at s = {s} is none"
                for t, kind in said
                if not any(matches(t, x) and k in (kind, "cusp") for x, k in true)
            ]
    listed = [(pair.sides, *pair.place) for pair in found.pairs]
    bad += ["one pair is told twice"] * sum(x in listed[:k] for k, x in enumerate(listed))
    return bad


def matches(t, ball):
    return bool((t - ball).contains(0)) if isinstance(t, arb) else near(t, ball)


# ---- the oracle of trimming


def foot_of_circle(point, velocity, q):
    """The centre of the circle through Q that touches the curve there; None where it is at infinity."""
    (x, y), (a, b) = point, velocity
    dx, dy = q[0] - x, q[1] - y
    below = 2 * (-b * dx + a * dy)
    return None if below == 0 else (x - b * (dx * dx + dy * dy) / below, y + a * (dx * dx + dy * dy) / below)


def nothing_inside(c, q, centre):
    """Whether no point of the curve is inside the circle through Q: ‖γ − Q‖² ≥ 2 (B − Q)·(γ − Q)."""
    bx, by = centre[0] - q[0], centre[1] - q[1]
    for k, (a, b) in spans(c):
        px, py, w = (fmpq_poly([flint(x) for x in row]) for row in power_basis(c, k))
        x, y = px - w * flint(q[0]), py - w * flint(q[1])
        f = x * x + y * y - 2 * w * (x * flint(bx) + y * flint(by))
        if not f:
            continue
        odd = [p for p, e in f.numer().factor()[1] if e % 2 and p.degree() > 0]
        low, high = flint(mpq(a)), flint(mpq(b))
        if any(low < x < high for p in odd for x in real_roots(fmpq_poly(p), (a, b))):
            return False
        values = [f(low + (high - low) * flint(mpq(i, f.degree() + 2))) for i in range(f.degree() + 3)]
        if any(value < 0 for value in values):
            return False
    return True


def trimming_differences(found, c, q, random):
    """Random parameters are kept exactly where the circle around B through Q is empty."""
    bad = []
    if found.undecided:
        return bad
    for k, (a, b) in spans(c):
        for _ in range(4):
            s = a + (b - a) * mpq(random.randint(1, 10**6 - 1), 10**6)
            point, velocity = point_and_tangent(c, k, s)
            centre = foot_of_circle(point, velocity, q) if any(velocity) else None
            if centre is None:
                continue
            kept = [arc for arc in found.arcs if arc.low <= s <= arc.high]
            if bool(kept) != nothing_inside(c, q, centre):
                bad.append(f"kept at {s}: {bool(kept)}")
            bad += [f"another point at {s}" for arc in kept if arc(s) != centre]
    return bad


# ---- the run


def pairs(number, random):
    """The bisector of two curves, and what it says otherwise than the oracle."""
    first, second = random_pair(number, random)
    found = curve_bisector(first, second)
    return found, lambda: differences(found, first, second, random)


def trimmings(number, random):
    """The trimmed bisector of a point and a plane curve, and the same."""
    c, q = curve(number, random, 2), (number(random), number(random))
    found = trimmed_bisector(c, q)
    return found, lambda: trimming_differences(found, c, q, random)


FAMILIES = {family.__name__: family for family in (pairs, trimmings)}


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    start = time.process_time()
    try:
        found, compare = FAMILIES[family](DIALS[dial], Random(f"{family} {seed} {dial}"))
    except ExactSplineError as error:
        return "" if ON_THE_CURVE in str(error) else type(error).__name__
    seconds = time.process_time() - start
    if wrong := compare() + [f"{seconds:.1f} s"] * (seconds > SLOW and not found.undecided):
        return "; ".join(wrong)
    return "left out" if found.undecided else ""


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:], ceiling=CEILING))
