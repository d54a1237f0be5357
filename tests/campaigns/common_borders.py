"""How two surfaces meet along common borders, against points, tangent planes and curvatures in fractions: seeded.

python -m tests.campaigns.common_borders 30 1
python -m tests.campaigns.common_borders 1 4711 --family bent --dial doubles     one case again

The oracle shares no code with the library: points and derivatives are those of de Boor's algorithm and of differences
of control points, in fractions. At samples of an arc that is reported, the points of both surfaces must be equal, the
normals parallel or not, of one direction or of opposite ones, and the curvatures equal or not, as reported; what is
reported of single points must hold to forty digits, and where the determinant of both normals and the tangent changes
its sign between samples, a point must be reported. Pairs of borders of equal parametrization are known from the
construction. Some second surfaces are run through in other directions, of higher degree, or have other weights.
"""

import sys
from itertools import pairwise, product
from random import Random

from gmpy2 import mpq
from mpmath import mp, mpf

from exactspline import ask
from exactspline.errors import WeightError
from tests.campaigns.surface_meetings import homogeneous, near
from tests.support.changes import surface_from, transposed
from tests.support.dials import DIALS
from tests.support.families import by_families
from tests.support.oracles import jet
from tests.support.vectors import cross, dot, mpf_of

#: Samples of an arc, and relative errors that are left by forty digits.
SAMPLES, EXACT = 24, mpq(1, 10**26)


# ---- surfaces


def first_surface(number, random):
    """One to four patches, polynomial or rational, as homogeneous control points."""
    degree, patches = (
        (random.choice([1, 2, 2, 3]), random.choice([1, 2, 2, 3])),
        [random.choice([1, 1, 2]) for _ in "uv"],
    )
    knots, counts = [], []
    for n, many in zip(degree, patches, strict=True):
        inner = [mpq(k) for k in range(1, many) for _ in range(random.randint(1, n))]
        knots.append([mpq(0)] * (n + 1) + inner + [mpq(many)] * (n + 1))
        counts.append(len(knots[-1]) - n - 1)
    rational = random.random() < 0.4
    return degree, knots, [[random_point(number, random, rational) for _ in range(counts[1])] for _ in range(counts[0])]


def random_point(number, random, rational):
    """A homogeneous control point."""
    w = mpq(random.randint(1, 3) if rational else 1)
    return (*(number(random) * w for _ in range(3)), w)


def made(degree, knots, net):
    """The surface."""
    return surface_from(tuple(degree), knots, net)


def with_rows(number, random, near_rows):
    """A surface, and one over [0, 1] in u that has its last row as the first one, and then these."""
    degree, knots, net = first_surface(number, random)
    rows = [net[-1], *near_rows(net, random)]
    n = len(rows) - 1
    return made(degree, knots, net), made((n, degree[1]), ([mpq(0)] * (n + 1) + [mpq(1)] * (n + 1), knots[1]), rows)


def other_row(number, random, row):
    """A row of random points over the weights of this one."""
    return [(*(number(random) * p[3] for _ in range(3)), p[3]) for p in row]


def cut(number, random):
    """One surface cut inside."""
    whole = made(*first_surface(number, random))
    a, b = whole.domain[0]
    return whole.split("u", a + (b - a) * mpq(random.randint(1, 6), 7))


def bent(number, random):
    """The border alone in common."""
    return with_rows(number, random, lambda net, random: [other_row(number, random, net[-1])])


def goes_on(factor, number, random):
    """The next row at a multiple of the last step, so that there is one tangent plane."""

    def rows(net, random):
        k = mpq(random.randint(1, 4), random.randint(1, 4)) * factor
        own = [tuple(y + k * (y - x) for x, y in zip(p, q, strict=True)) for p, q in zip(*net[-2:], strict=True)]
        more = [other_row(number, random, net[-1])] * random.randint(0, 1)
        if not all(p[3] > 0 for p in own):
            raise WeightError("again")
        return [own, *more]

    return with_rows(number, random, rows)


def smooth(number, random):
    """One tangent plane."""
    return goes_on(1, number, random)


def folded(number, random):
    """One tangent plane, and back."""
    return goes_on(mpq(-1, 5), number, random)


def perturbed(number, random):
    """One tangent plane but for one control point of the second row."""
    first, second = smooth(number, random)
    net = homogeneous(second)
    j, k = random.randrange(len(net[1])), random.randrange(3)
    point = list(net[1][j])
    point[k] += number(random)
    net[1][j] = tuple(point)
    return first, made(second.degree, second.knots, net)


def apart(number, random):
    """Nothing in common, or a corner."""
    first, second = (made(*first_surface(number, random)) for _ in range(2))
    return first, second


def flipped(surface, k):
    """One parameter run through the other way."""
    net, knots = homogeneous(surface), list(surface.knots)
    a, b = surface.domain[k]
    knots[k] = [a + b - t for t in reversed(knots[k])]
    return made(surface.degree, knots, net[::-1] if k == 0 else [row[::-1] for row in net])


def scaled(surface, factor):
    """The homogeneous control points of each column multiplied by a number: the same surface, for powers of a number by
    parameters that are no linear functions of the old ones.
    """
    net = [[tuple(x * factor(j) for x in p) for j, p in enumerate(row)] for row in homogeneous(surface)]
    return made(surface.degree, surface.knots, net)


def written_otherwise(surface, random):
    """The same surface by other parameters, degrees or factors."""
    for k in range(2):
        if random.random() < 0.5:
            surface = flipped(surface, k)
    if random.random() < 0.4:
        surface = surface.elevate_degree(*random.choice([(1, 0), (0, 1), (1, 1)]))
    if random.random() < 0.3:
        surface = surface.insert_knot(
            "v", sum(surface.domain[1]) * mpq(random.randint(1, 6), 14) + surface.domain[1].low
        )
    if random.random() < 0.3:
        factor = random.choice([-2, mpq(1, 3)])
        surface = scaled(surface, lambda j: factor)
    if random.random() < 0.1 and surface.patches[1] == 1 and len(surface.knots[1]) == 2 * surface.degree[1] + 2:
        surface = scaled(surface, lambda j: mpq(3, 2) ** j)
    return transposed(surface) if random.random() < 0.4 else surface


# ---- the oracle


class Oracle:
    """A surface by its control points alone."""

    def __init__(self, surface):
        self.knots, self.degree = [list(own) for own in surface.knots], tuple(surface.degree)
        self.net = homogeneous(surface)
        self.domain = [(own[n], own[-n - 1]) for own, n in zip(self.knots, self.degree, strict=True)]

    def partials(self, place, order):
        """The derivatives up to an order of coordinates and weight together, by their orders."""
        rows = [jet(self.knots[1], self.degree[1], row, place[1], order) for row in self.net]
        columns = zip(*rows, strict=True)
        along = [jet(self.knots[0], self.degree[0], c, place[0], order) for c in columns]
        return {(i, j): along[j][i] for i in range(order + 1) for j in range(order + 1)}

    def jet(self, place):
        """S, S_u, S_v, S_uu, S_uv, S_vv by the quotient rule."""
        found, partials = {}, self.partials(place, 2)
        for i, j in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]:
            value = partials[i, j]
            for (a, b), (times, k) in {(0, 0): ((i, j), 1), (1, 0): ((i - 1, j), i), (0, 1): ((i, j - 1), j)}.items():
                if times != (0, 0) and min(times) >= 0 and (a, b) in found and (a, b) != (i, j):
                    w = partials[times][3]
                    value = [x - k * w * y for x, y in zip(value[:3], found[a, b], strict=True)]
            found[i, j] = [x / partials[0, 0][3] for x in value[:3]]
        return found

    def beside(self, edge, t, *, out, sign):
        """The point of a border at a parameter, the normal of the derivative across it and that along it, and what the
        mean curvature is with this normal, all in fractions; across it out of the surface, or into it.
        """
        k, end = edge
        place = [t, t]
        place[k] = self.domain[k][end]
        jet = self.jet(place)
        way = 1 if (end == 1) == out else -1
        first, second = ((1, 0), (0, 1)) if k == 0 else ((0, 1), (1, 0))
        across, along = [way * x for x in jet[first]], [sign * x for x in jet[second]]
        normal = cross(across, along)
        bends = [dot(normal, jet[orders]) for orders in ((2, 0), (1, 1), (0, 2))]
        e, f, g = dot(jet[1, 0], jet[1, 0]), dot(jet[1, 0], jet[0, 1]), dot(jet[0, 1], jet[0, 1])
        return jet[0, 0], normal, along, e * bends[2] - 2 * f * bends[1] + g * bends[0]

    def point(self, edge, t):
        """A point of a border."""
        place = [t, t]
        place[edge[0]] = self.domain[edge[0]][edge[1]]
        *p, w = self.partials(place, 0)[0, 0]
        return [x / w for x in p]


# ---- comparison


def edge_of(surface, words):
    """The border that is named: the number of its parameter, and at which end."""
    letter, value = words.split(" = ")
    k = "uv".index(letter)
    return k, [mpq(x) for x in surface.domain[k]].index(mpq(value))


def differs_pair(surfaces, *, nothing):
    """What is wrong with the answer about two surfaces, "" where nothing is; they may have `nothing` in common."""
    found = ask(surfaces, "common_borders")
    if not found and not nothing:
        return "nothing is reported"
    oracles = [Oracle(surface) for surface in surfaces]
    arcs, points = {}, {}
    for row in found:
        edges = tuple(
            edge_of(s, row.facts[f"{name} border"]) for s, name in zip(surfaces, ("first", "second"), strict=True)
        )
        (arcs if "order" in row.facts else points).setdefault(edges, []).append(row)
    for edges, rows in arcs.items():
        for row in rows:
            if wrong := differs_arc(oracles, edges, row, points.get(edges, [])):
                return f"{row}, {row.facts}: {wrong}"
    if set(points) - set(arcs):
        return "points without an arc"
    borders = list(product((0, 1), (0, 1)))
    for edges in product(borders, borders):
        if same_border(oracles, edges) and edges not in arcs:
            return f"the borders {edges} are not reported"
        if edges in arcs and same_border(oracles, edges):
            a, b = surfaces[0].domain[1 - edges[0][0]]
            ends = sorted((x.values["first from"].exact, x.values["first to"].exact) for x in arcs[edges])
            if ends[0][0] != a or ends[-1][1] != b or any(x[1] != y[0] for x, y in pairwise(ends)):
                return f"not the whole border {edges}: {ends}"
    return ""


def same_border(oracles, edges):
    """Whether two borders are one curve, with parameters that are linear functions of each other."""
    (one, other), (first, second) = oracles, edges
    (a, b), (c, d) = (each.domain[1 - edge[0]] for each, edge in zip(oracles, edges, strict=True))
    parts = [mpq(k, 19) for k in range(20)]
    points = [one.point(first, a + (b - a) * x) for x in parts]
    if all(point == points[0] for point in points):
        return False
    return any(
        all(p == other.point(second, start + (stop - start) * x) for x, p in zip(parts, points, strict=True))
        for start, stop in ((c, d), (d, c))
    )


def differs_arc(oracles, edges, row, points):
    """What is wrong with an arc."""
    ends = [row.values[f"{name} {end}"] for name in ("first", "second") for end in ("from", "to")]
    a, b, c, d = (near(x) for x in ends)
    if row.what == "common arc":
        gaps = [a_gap for x, y in ((a, c), (b, d)) if (a_gap := gap(oracles, edges, x, y)) > EXACT]
        return "the ends are apart" if gaps else ""
    a, b, c, d = (x.exact for x in ends)
    sign = 1 if d > c else -1
    places = [near(x.values["first"]) for x in points]
    signs, parts = [], []
    for k in range(1, SAMPLES):
        t = a + (b - a) * mpq(2 * k * SAMPLES + 1, 2 * SAMPLES * SAMPLES)
        p, n, along, h = oracles[0].beside(edges[0], t, out=True, sign=1)
        q, m, _, g = oracles[1].beside(edges[1], c + (t - a) * (d - c) / (b - a), out=False, sign=sign)
        if p != q:
            return f"two points at {float(t)}"
        parallel, product_ = not any(cross(n, m)), dot(n, m)
        special = any(abs(t - x) < EXACT * (b - a) for x in places)
        if special:
            continue
        smooth = parallel and product_ > 0
        same = g * g * dot(n, n) ** 3 == h * h * dot(m, m) ** 3 and g * h >= 0
        expected = {
            "crease": not parallel,
            "fold": parallel and product_ < 0,
            "no tangent plane": not any(n) or not any(m),
            "jump of the curvature": smooth,
            "continuous curvature": smooth and same,
        }[row.what]
        if not expected:
            return f"otherwise at {float(t)}"
        signs.append((t, dot(cross(n, m), along)))
        parts.append(same)
        if "angle" in row.values:
            with mp.workdps(40):
                angle = mp.degrees(mp.acos(mpf_of(product_) / mp.sqrt(mpf_of(dot(n, n) * dot(m, m)))))
                value = near(row.values["angle"])
                if abs(angle - mpf_of(value)) > mpf(10) ** -15:
                    return f"the angle is {angle} at {float(t)}"
    if row.what == "jump of the curvature" and all(parts):
        return "the curvature does not jump"
    if row.what == "crease":
        # at a knot the tangent may jump
        rate, knots = (d - c) / (b - a), [each.knots[1 - edge[0]] for each, edge in zip(oracles, edges, strict=True)]
        jumps = [*knots[0], *[a + (s - c) / rate for s in knots[1]]]
        for (t, x), (s, y) in pairwise(signs):
            if x * y < 0 and not any(t < place < s for place in (*places, *jumps)):
                return f"no point is reported between {float(t)} and {float(s)}"
    return next(filter(None, (differs_place(oracles, edges, x, (a, b, c, d)) for x in points)), "")


def gap(oracles, edges, t, s):
    """The distance of two points of borders, by the larger coordinates."""
    p, q = (each.point(edge, x) for each, edge, x in zip(oracles, edges, (t, s), strict=True))
    return max(abs(x - y) for x, y in zip(p, q, strict=True)) / (max(map(abs, (*p, *q))) or 1)


def differs_place(oracles, edges, row, ends):
    """What is wrong with a single point."""
    a, b, c, d = ends
    t, s = near(row.values["first"]), near(row.values["second"])
    if not a - EXACT <= t <= b + EXACT:
        return ""
    if abs(c + (t - a) * (d - c) / (b - a) - s) > EXACT * abs(d - c):
        return f"{row}: not one point"
    # at a knot at which the tangents jump, on the side of the arc
    t, s = inside(t, a, b), inside(s, *sorted((c, d)))
    n = oracles[0].beside(edges[0], t, out=True, sign=1)[1]
    m = oracles[1].beside(edges[1], s, out=False, sign=1 if d > c else -1)[1]
    # by the size that normals have elsewhere
    other = oracles[0].beside(edges[0], a + (b - a) * mpq(3, 7), out=True, sign=1)[1]
    size, own = dot(n, n), dot(m, m)
    if row.what == "no tangent plane":
        return (
            "" if min(size / dot(other, other), own / dot(other, other)) < EXACT else f"{row}: there are tangent planes"
        )
    turn = cross(n, m)
    if dot(turn, turn) > EXACT * size * own:
        return f"{row}: two tangent planes"
    return "" if (dot(n, m) > 0) == (row.what == "one tangent plane") else f"{row}: the other direction"


def inside(t, a, b):
    """A parameter, at least by a tiny part of an interval away from its ends."""
    little = (b - a) / 10**45
    return min(max(t, a + little), b - little)


# ---- campaigns

FAMILIES = {"cut": cut, "bent": bent, "smooth": smooth, "folded": folded, "perturbed": perturbed, "apart": apart}


def drawn(family, dial, seed):
    """Two surfaces, written otherwise."""
    random = Random(f"{family} {dial} {seed}")
    while True:
        try:
            pair = FAMILIES[family](DIALS[dial], random)
            if None not in pair:
                pair = tuple(written_otherwise(each, random) for each in pair)
                if None not in pair:
                    return pair[:: random.choice([1, -1])]
        except WeightError:
            continue


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    surfaces = drawn(family, dial, seed)
    return differs_pair(surfaces, nothing=family == "apart")


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:]))
