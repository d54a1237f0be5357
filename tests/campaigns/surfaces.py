"""Random surfaces against an oracle that shares no code with the library: ``python -m tests.campaigns.surfaces 1000``.

Every surface is drawn from a family, by a seed, at a setting of the dial from small integers to 17-digit doubles and
1e±300. Each comparison stands beside the sentence of `docs/inspecting-surfaces.md` that it judges (`COMPARED`), and its
first lines name the cases around which it steps. Surfaces that are undecided are counted for each family, with a
ceiling; one that takes longer than `LIMIT` is named. The exit status is 1 where anything is different or slow, or a
family is above its ceiling.

``python -m tests.campaigns.surfaces 1000 0 knots`` inserts knots instead, also through what was found, and compares
all answers with those before, as the matrix does: no oracle there.

The results of the last whole runs are in `docs/inspecting-surfaces.md`.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from fractions import Fraction
from itertools import product
from random import Random

from gmpy2 import mpq

from exactspline import NurbsSurface, TensorSpline, analyse
from exactspline.geometry.analysis.surfaces import PatchKind, SurfaceInspection
from exactspline.questions.entry import Of
from tests.support.matrix import Counts, Letter, compared, questions
from tests.support.squares import parameters
from tests.support.surface_oracle import forms, gaussian_curvature, jets
from tests.support.vectors import cross

SEED = 2027
#: Seconds for one surface before it is named.
LIMIT = 10
#: Points on each side of a patch at which K is compared; the corners are among them.
GRID = 6
DIAL = ("integers", "thirds", "decimals", "doubles", "huge", "tiny")


def number(random: Random, setting: str) -> mpq:
    """A number between about −1 and 1, times the size of the setting."""
    whole = random.randint(-9, 9)
    if setting == "integers":
        return mpq(whole)
    if setting == "thirds":
        return mpq(random.randint(-27, 27), 3)
    if setting == "decimals":
        return mpq(random.randint(-(10**10), 10**10), 10**10)
    drawn = mpq(random.uniform(-1, 1))
    return drawn * {"doubles": 1, "huge": mpq(1e300), "tiny": mpq(1e-300)}[setting]


# ---- families: functions of a source of randomness and a setting


def net(random: Random, setting: str) -> NurbsSurface:
    """A biquadratic net."""
    rows = [[[number(random, setting) for _ in range(3)] for _ in range(3)] for _ in range(3)]
    return NurbsSurface((2, 2), [0] * 3 + [1] * 3, [0] * 3 + [1] * 3, rows)


def weighted(random: Random, setting: str) -> NurbsSurface:
    """A rational bilinear-quadratic net."""
    rows = [[[number(random, setting) for _ in range(3)] for _ in range(3)] for _ in range(2)]
    weights = [[random.randint(1, 9) for _ in range(3)] for _ in range(2)]
    return NurbsSurface((1, 2), [0, 0, 1, 1], [0] * 3 + [1] * 3, rows, weights)


def _size(setting: str) -> mpq:
    return {"huge": mpq(1e300), "tiny": mpq(1e-300)}.get(setting, mpq(1))


def _graph(height: TensorSpline, setting: str) -> NurbsSurface:
    """A graph, all of it times the size of the setting."""
    u, v = parameters()
    size = _size(setting)
    return NurbsSurface.from_splines([u * size, v * size, height * size])


def _small(random: Random, setting: str) -> mpq:
    """A number for a coefficient, of a size next to 1."""
    return number(random, setting) / _size(setting) or mpq(1)


def translation(random: Random, setting: str) -> NurbsSurface:
    """z = f(u) + g(v): K vanishes on lines in both directions, which cross."""
    u, v = parameters()
    c = [_small(random, setting) for _ in range(6)]
    f, g = (t * t * a + t * t * t * b + t * t * t * t * d for t, a, b, d in ((u, *c[:3]), (v, *c[3:])))
    return _graph(f + g, setting)


def even(random: Random, setting: str) -> NurbsSurface:
    """z = (u − a)⁴ b + v² c: K vanishes twice on a line, at a rational place that is a corner, a knot or any."""
    u, v = parameters()
    a = random.choice([mpq(0), mpq(1), mpq(1, 2), mpq(29, 61), abs(_small(random, setting)) % 1])
    s = (u - a) * (u - a)
    surface = _graph(s * s * _small(random, setting) + v * v * _small(random, setting), setting)
    return surface.insert_knot("u", a) if random.random() < 0.5 and 0 < a < 1 else surface


def corners(random: Random, setting: str) -> NurbsSurface:
    """K vanishes at corners alone or nearly: z = a(u) b + a(v) c + bump d."""
    u, v = parameters()
    b, c, d = (_small(random, setting) for _ in range(3))
    first, second = (t * t * t * mpq(1, 6) - t * t * t * t * mpq(1, 12) for t in (u, v))
    bump = u * (1 - u) * v * (1 - v)
    return _graph(first * b + second * c + bump * bump * (d / 99), setting)


def irrational(random: Random, setting: str) -> NurbsSurface:
    """z = h(2u² − 1, v): K vanishes on lines at irrational places, once or twice."""
    u, v = parameters()
    a = mpq(random.randint(1, 4), random.choice((2, 3)))
    power = random.choice((1, 2))
    second = {1: u * u * u * u * (a / 12) - u * u * mpq(1, 2), 2: None}[power]
    if second is None:  # the integral of (a u² − 1)²
        t = u * u
        second = t * t * t * (a * a / 30) - t * t * (a / 6) + t * mpq(1, 2)
    return _graph(second * _small(random, setting) + v * v * _small(random, setting), setting)


def creased(random: Random, setting: str) -> NurbsSurface:
    """Two or four biquadratic patches with knots of full multiplicity, less one or less two."""
    knots = [0] * 3 + [1] * random.choice((1, 2)) + [2] * 3
    rows = [[[number(random, setting) for _ in range(3)] for _ in range(3)] for _ in range(len(knots) - 3)]
    if random.random() < 0.5:
        rows = [
            [(i * _size(setting), j * _size(setting), p[2]) for j, p in enumerate(row)] for i, row in enumerate(rows)
        ]
    return NurbsSurface((2, 2), knots, [0] * 3 + [1] * 3, rows)


def flat(random: Random, setting: str) -> NurbsSurface:
    """Cylinders, planes, and patches of both next to others: forms that vanish identically."""
    size = _size(setting)
    heights = [[number(random, setting)] * 3 for _ in range(3)] + [[number(random, setting) for _ in range(3)]]
    rows = [[(i * size, j * size, z) for j, z in enumerate(row)] for i, row in enumerate(heights)]
    return NurbsSurface((1, 2), [0, 0, 1, 2, 3, 3], [0] * 3 + [1] * 3, rows)


def umbilic_curve(random: Random, setting: str) -> NurbsSurface:
    """z = p³ q or p⁴ for a line or a parabola p, often through corners: curves of umbilics, of parabolic points."""
    u, v = parameters()
    p = random.choice([u - v, u + v - 1, u * u - v, v * 2 - u, u + v - mpq(random.randint(1, 5), 3), u * u + v - 1])
    q = random.choice([p, u * 0 + 1, u + v - 1, u - mpq(1, 2), v * v + 1])
    return _graph(p * p * p * q * _small(random, setting), setting)


def singular_curve(random: Random, setting: str) -> NurbsSurface:
    """(u, p²/2, ∫ p p_v q dv) or alike: no tangent plane along p = 0, a line through corners or the middle."""
    u, v = parameters()
    a, size = _small(random, setting), _size(setting)
    p = random.choice([v - u, u + v - 1, v - mpq(1, 2), v * 2 - u])
    q = random.choice([p * p * a, p * a + 1, p * (u - mpq(1, 2)) + p * p])
    return NurbsSurface.from_splines([u * size, p * p * size, p * p * q * size])


FAMILIES = (net, weighted, translation, even, corners, irrational, creased, flat)
#: Those whose knots are inserted.
WITH_CURVES = (*FAMILIES, umbilic_curve, singular_curve)
#: Per mille of the surfaces of a family that may be incomplete.
CEILING, CEILINGS = 1, {corners.__name__: 0}


# ---- what is held against the oracle


def contradictions(surface: NurbsSurface) -> tuple[list[str], bool]:
    """Where an inspection and the oracle differ, and whether the inspection is complete."""
    found = analyse(surface)
    return [each for compare in COMPARED.values() for each in compare(found)], found.complete


def wrong_signs(found: SurfaceInspection) -> list[str]:
    """K at inner points of every patch. Steps around points without a tangent plane, around mixed and undecided
    patches, and around zeros of K on a listed line; parabolic curves and points are compared by their kinds alone.
    """
    told = []
    for one in found.patches:
        allowed = ALLOWED.get(one.kind)
        if allowed is None:
            continue
        (a, b), (c, d) = one.sides
        seen = set()
        for i, j in product(range(1, GRID), repeat=2):
            u, v = a + (b - a) * mpq(2 * i - 1, 2 * GRID - 1), c + (d - c) * mpq(2 * j - 1, 2 * GRID - 1)
            k = gaussian_curvature(found.surface, *map(_fraction, (u, v)))
            if k is None:
                continue
            sign = (k > 0) - (k < 0)
            seen.add(sign)
            listed = any(_is_on(line, u, v) for line in found.parabolic_lines)
            if sign not in allowed and not (sign == 0 and listed):
                told.append(f"{one.kind.value} at {u}, {v}, where K has the sign {sign}")
        if one.kind in NEEDED and one.parabolic_lines == () and one.signs is not None and seen == {0}:
            told.append(f"{one.kind.value}, but K vanishes everywhere")
    return told


def wrong_lines(found: SurfaceInspection) -> list[str]:
    """K at one point of every line. Steps around lines at irrational values, and seen from one side."""
    told = []
    for line in found.parabolic_lines:
        (low, high), value = line.interval, line.value
        if not line.one_sided and isinstance(value, type(mpq(0))):
            t = low + (high - low) * mpq(3, 7)
            k = gaussian_curvature(
                found.surface, *map(_fraction, (t, value) if line.along.value == "u" else (value, t))
            )
            if k not in (0, None):
                told.append(f"a parabolic line {line} on which K is not zero")
    return told


def _is_on(line: object, u: mpq, v: mpq) -> bool:
    return (v if line.along.value == "u" else u) == line.value


ALLOWED = {
    PatchKind.PLANAR: {0},
    PatchKind.DEVELOPABLE: {0},
    PatchKind.SPHERICAL: {1},
    PatchKind.ELLIPTIC: {1},
    PatchKind.HYPERBOLIC: {-1},
    PatchKind.ELLIPTIC_BUT: {0, 1},
    PatchKind.HYPERBOLIC_BUT: {0, -1},
}
NEEDED = (PatchKind.ELLIPTIC_BUT, PatchKind.HYPERBOLIC_BUT)


def wrong_joints(found: SurfaceInspection) -> list[str]:
    """Normals and mean curvatures of the two sides of joints, each cut out, at one point, at four where they agree
    better than is listed. Steps around seams, and around points without a tangent plane.
    """
    told = []
    surface = found.surface
    for joint in found.joints:
        if joint.at_seam:
            continue
        k = joint.across.direction
        low, high = joint.interval
        t = low + (high - low) * mpq(4, 11)
        order = _order(surface, k, joint.value, t)
        if joint.order is not None and order is not None and order < joint.order:
            told.append(f"{joint.kind.value} at {joint.value}, where the sides agree to order {order}")
        if joint.order is not None and order is not None and joint.order < 2 and order > joint.order:
            others = [low + (high - low) * mpq(x, 13) for x in (2, 7, 9)]
            if all((_order(surface, k, joint.value, x) or 0) > joint.order for x in others):
                told.append(f"{joint.kind.value} at {joint.value}, where the sides agree to order {order}")
    return told


def _order(surface: NurbsSurface, k: int, value: mpq, t: mpq) -> int | None:
    """To which order the two sides of a knot line agree at a point of it."""
    (a, b), (c, d) = surface.domain
    if k == 0:
        halves = surface.restrict((a, value), (c, d)), surface.restrict((value, b), (c, d))
    else:
        halves = surface.restrict((a, b), (c, value)), surface.restrict((a, b), (value, d))
    place = tuple(map(_fraction, (value, t) if k == 0 else (t, value)))
    if halves[0](*place) != halves[1](*place):
        return -1
    first, second = (forms(half, *place) for half in halves)
    normals = [_normal(half, place) for half in halves]
    areas = [e * g - f * f for e, f, g, *_ in (first, second)]
    if 0 in areas:
        return None
    product = sum(x * y for x, y in zip(*normals, strict=True))
    if product <= 0 or product**2 != areas[0] * areas[1]:
        return 0
    # H = h/(2 A^{3/2}): signs and squares
    h = [e * n - 2 * f * m + g * ll for e, f, g, ll, m, n in (first, second)]
    same = h[0] ** 2 * areas[1] ** 3 == h[1] ** 2 * areas[0] ** 3 and (h[0] > 0) == (h[1] > 0)
    return 2 if same else 1


def _normal(surface: NurbsSurface, place: tuple[Fraction, Fraction]) -> list[Fraction]:
    own = jets(surface, *place)
    return cross(*([x.c[k] for x in own] for k in ((1, 0), (0, 1))))


def _fraction(x: object) -> Fraction:
    return Fraction(int(x.numerator), int(x.denominator))


#: What is compared, by the sentence of the documentation that it judges.
COMPARED = {
    "**The sign of K** follows from Bernstein coefficients on smaller and smaller parts of the patch.": wrong_signs,
    "Lines of constant u or v on which K vanishes are listed as parabolic lines, whether or not they are knot lines.": (
        wrong_lines
    ),
    "The two patches at a joint are compared by polynomials along the common edge.": wrong_joints,
}


# ---- what is held against what was found before knots were inserted

#: The sentences of the documentation that are judged so.
KNOTTED = (
    "an umbilic on a curve or line of umbilics is not listed as a single point",
    "parts on two patches that end at the same point of a common border or seam are joined;",
)


def differences(surface: NurbsSurface, random: Random) -> tuple[list[str], bool]:
    """The questions that are answered otherwise with knots, one of them through what was found, as the matrix tells."""
    counts, names = Counts(), ("knot on what was found", "knot far away")
    letters = tuple(Letter(name, random.randrange(1 << 30)) for name in names)
    for entry in questions(Of.SURFACE):
        compared(surface, entry, letters, random, counts)
    return [str(failure) for failure in counts.failures], True


def run(count: int, seed: int = SEED, start: int = 0, *, knots: bool = False) -> dict[str, Counter[str]]:
    """This many surfaces; what was found of each family, with differences and slow ones printed."""
    table: dict[str, Counter[str]] = {}
    for k in range(start, start + count):
        families = WITH_CURVES if knots else FAMILIES
        family, setting = families[k % len(families)], DIAL[k // len(families) % len(DIAL)]
        random = Random(f"{seed} {k}")
        surface = family(random, setting)
        before = time.process_time()
        told, complete = differences(surface, random) if knots else contradictions(surface)
        seconds = time.process_time() - before
        own = table.setdefault(family.__name__, Counter())
        own["surfaces"] += 1
        own["incomplete"] += not complete
        own["different"] += bool(told)
        own["slow"] += seconds > LIMIT
        if told or seconds > LIMIT:
            print(f"{k} {family.__name__} {setting}: {seconds:.1f} s {'; '.join(told)[:200]}", flush=True)
    return table


def is_good(name: str, counts: Counter[str]) -> bool:
    """Whether nothing of a family is different or slow, and no more of it incomplete than may be."""
    allowed = CEILINGS.get(name, CEILING) * counts["surfaces"]
    return not counts["different"] and not counts["slow"] and 1000 * counts["incomplete"] <= allowed


if __name__ == "__main__":
    arguments = [int(x) for x in sys.argv[1:3]]
    begun, knots = time.process_time(), sys.argv[3:] == ["knots"]
    table = run(arguments[0] if arguments else 1000, start=arguments[1] if len(arguments) > 1 else 0, knots=knots)
    for name, counts in table.items():
        print(f"{name:12}", ", ".join(f"{what} {n}" for what, n in counts.items()))
    print(f"{time.process_time() - begun:.0f} s of CPU time, seed {SEED}")
    sys.exit(not all(is_good(name, counts) for name, counts in table.items()))
