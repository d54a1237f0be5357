"""The nearest points of a surface, lines, rays, segments and planes that meet it, its bounding box, and lemons and
monstars, against de Boor's algorithm in fractions, and numpy's and scipy's searches from many starts: seeded.

python -m tests.campaigns.surface_meetings 50 1
python -m tests.campaigns.surface_meetings 1 4711 --family nearest --dial doubles     one case again

The oracle shares no code with the library. What is listed must hold to forty digits at the listed parameters; what a
search of many starts finds must be listed, and may not be nearer or farther out. Some cases are made: the point is on
the surface, at a centre of symmetry, the line is a tangent, the ray starts on the surface. Umbilics are those of
Darboux's normal form, of which the kind is known. What is refused as out of reach is counted.
"""

import sys
from itertools import pairwise, product
from random import Random

import numpy as np
from gmpy2 import mpq
from scipy.optimize import minimize

from exactspline import NurbsSurface, TensorSpline, ask
from exactspline.bivariate.zeros import ZeroKind
from exactspline.errors import ShapeError, WeightError
from tests.support.dials import DIALS
from tests.support.families import by_families
from tests.support.oracles import jet

#: Relative errors that are left by forty digits; by searches in doubles; and of places that these find.
EXACT, FOUND, NEAR = mpq(1, 10**28), 1e-9, 1e-5
#: Points along each parameter of a patch from which is searched.
STARTS, STEPS = 12, 30


# ---- surfaces


def surface_of(number, random, kind=""):
    """One to four patches, polynomial or rational; some are symmetric by x → −x and u → −u."""
    while True:
        degree = random.choice([(1, 1), (1, 2), (2, 2), (2, 2), (2, 3), (3, 3)])
        patches = [random.choice([1, 1, 2]) for _ in range(2)] if sum(degree) < 5 else [1, 1]
        knots, counts = [], []
        for n, many in zip(degree, patches, strict=True):
            inner = [mpq(k) for k in range(1, many) for _ in range(random.randint(1, n))]
            knots.append([mpq(0)] * (n + 1) + inner + [mpq(many)] * (n + 1))
            counts.append(len(knots[-1]) - n - 1)
        net = [[tuple(number(random) for _ in range(3)) for _ in range(counts[1])] for _ in range(counts[0])]
        weights = [[random.randint(1, 3) for _ in range(counts[1])] for _ in range(counts[0])]
        if kind == "symmetric":
            net = [[(x * s, y, z) for x, y, z in net[min(i, counts[0] - 1 - i)]] for i, s in signed(counts[0])]
            weights = [weights[min(i, counts[0] - 1 - i)] for i in range(counts[0])]
        try:
            made = NurbsSurface(degree, *knots, net, weights if random.random() < 0.4 else None)
        except WeightError:
            continue
        if any(net[0][0] != point for row in net for point in row):
            return made


def signed(count):
    """Row numbers with the signs of x: opposite ones for rows that are mirrored."""
    return [(i, 1 if 2 * i < count - 1 else 0 if 2 * i == count - 1 else -1) for i in range(count)]


def place_on(surface, random):
    """Simple rational parameters of a point."""
    return tuple(a + (b - a) * mpq(random.randint(0, 6), 6) for a, b in surface.domain)


# ---- the oracle


class Oracle:
    """A surface by its control points alone."""

    def __init__(self, surface):
        self.degree = surface.degree
        self.knots = [list(own) for own in surface.knots]
        self.net = homogeneous(surface)
        self.size = max(abs(x / p[3]) for row in self.net for p in row for x in p[:3]) or mpq(1)
        floats = [[[float(x / self.size) for x in p[:3]] + [float(p[3])] for p in row] for row in self.net]
        self.floats = np.array(floats)
        self.knots_in_doubles = [np.array([float(t) for t in own]) for own in self.knots]
        self.domain = [(own[0], own[-1]) for own in self.knots_in_doubles]

    def homogeneous(self, u, v):
        """De Boor's algorithm in rational numbers."""
        rows = [jet(self.knots[1], self.degree[1], row, v, 0)[0] for row in self.net]
        return jet(self.knots[0], self.degree[0], rows, u, 0)[0]

    def __call__(self, u, v):
        *p, w = self.homogeneous(u, v)
        return [x / w for x in p]

    def basis(self, k, t, order):
        """The basis functions, or their derivatives, at doubles."""
        n, knots = self.degree[k], self.knots_in_doubles[k]
        t = np.clip(t, knots[0], knots[-1])
        span = np.minimum(np.searchsorted(knots, t, side="right") - 1, len(knots) - n - 2)[:, None]
        own = (span == np.arange(len(knots) - 1)).astype(float)
        for degree in range(1, n + 1):
            last = own
            own = np.zeros((len(t), len(knots) - 1 - degree))
            for i in range(len(knots) - 1 - degree):
                for j, sign in ((i, 1), (i + 1, -1)):
                    width = knots[j + degree] - knots[j]
                    if width > 0:
                        rises = (t - knots[j]) / width if sign > 0 else (knots[j + degree] - t) / width
                        own[:, i] += last[:, j] * (sign * degree / width if order and degree == n else rises)
        return own

    def at(self, u, v):
        """Points and both derivatives at arrays of doubles, the surface scaled to size 1."""
        parts = []
        for orders in ((0, 0), (1, 0), (0, 1)):
            first, second = (self.basis(k, t, order) for k, (t, order) in enumerate(zip((u, v), orders, strict=True)))
            parts.append(np.einsum("ki,kj,ijc->kc", first, second, self.floats))
        p, a, b = parts
        w = p[:, 3:]
        s = p[:, :3] / w
        return s, (a[:, :3] - s * a[:, 3:]) / w, (b[:, :3] - s * b[:, 3:]) / w

    def starts(self, many):
        """Points of a grid on every patch."""
        sides = [
            np.unique(np.concatenate([np.linspace(a, b, many) for a, b in pairwise(sorted({*own}))]))
            for own in self.knots_in_doubles
        ]
        u, v = np.meshgrid(*sides, indexing="ij")
        return u.ravel(), v.ravel()

    def least(self, value, slope):
        """The least value of a function of points that a search from many starts finds, and where."""
        u, v = self.starts(STARTS)
        values = value(self.at(u, v)[0])
        best = (values.min(), (u[values.argmin()], v[values.argmin()]))
        for k in np.argsort(values)[:5]:

            def both(place):
                s, a, b = self.at(place[:1], place[1:])
                along = slope(s)
                return value(s)[0], np.array([(along * a).sum(), (along * b).sum()])

            found = minimize(both, [u[k], v[k]], jac=True, bounds=self.domain, method="L-BFGS-B", tol=1e-14)
            best = min(best, (found.fun, tuple(found.x)), key=lambda pair: pair[0])
        # the search stops early at knots, where second derivatives jump
        low, high = np.array(self.domain, dtype=float).T
        steps = np.array([(a, b) for a in range(-2, 3) for b in range(-2, 3)])
        for halved in range(40):
            places = np.clip(best[1] + steps * (high - low) / 2 ** (halved + 6), low, high)
            values = value(self.at(*places.T)[0])
            best = min(best, (values.min(), tuple(places[values.argmin()])), key=lambda pair: pair[0])
        return best

    def meetings(self, start, direction):
        """Parameters to which Newton's method converges that are on a line, in doubles, from many starts."""
        k = int(np.argmax(np.abs(direction)))
        others = [i for i in range(3) if i != k]
        u, v = self.starts(STARTS)
        low, high = zip(*self.domain, strict=True)

        def planes(s):
            chord = s - (start if s.ndim == 2 and len(s) == len(u) and offset else 0)
            return np.stack([chord[:, i] * direction[k] - chord[:, k] * direction[i] for i in others], axis=1)

        offset = False
        for _ in range(STEPS):
            s, a, b = self.at(u, v)
            offset = False
            f, fu, fv = planes(s - start), planes(a), planes(b)
            det = fu[:, 0] * fv[:, 1] - fu[:, 1] * fv[:, 0]
            det = np.where(np.abs(det) < 1e-300, 1e-300, det)
            u = np.clip(u - (f[:, 0] * fv[:, 1] - f[:, 1] * fv[:, 0]) / det, low[0], high[0])
            v = np.clip(v - (fu[:, 0] * f[:, 1] - fu[:, 1] * f[:, 0]) / det, low[1], high[1])
        s, a, b = self.at(u, v)
        f, fu, fv = planes(s - start), planes(a), planes(b)
        det = np.abs(fu[:, 0] * fv[:, 1] - fu[:, 1] * fv[:, 0])
        good = (np.abs(f).max(axis=1) < 1e-12 * np.abs(direction).max()) & (det > 1e-6 * np.abs(direction).max() ** 2)
        found = []
        for place in zip(u[good], v[good], strict=True):
            if not any(max(abs(x - y) for x, y in zip(place, other, strict=True)) < NEAR for other in found):
                found.append(place)
        return found


def homogeneous(surface):
    """Its homogeneous control points."""
    return [
        [(*(x * w for x in p), w) for p, w in zip(*rows, strict=True)]
        for rows in zip(surface.control_points, surface.weights, strict=True)
    ]


# ---- comparison


def near(number, digits=45):
    """A rational number near a real one, absolutely."""
    return number.enclosure(digits).middle


def doubles(vector, size):
    """Numbers over the size of a surface, as doubles."""
    return np.array([float(x / size) for x in vector])


def listed(*vectors):
    """Numbers as text."""
    return ",".join(str(x) for vector in vectors for x in vector)


def inside(part, u, v):
    """Whether parameters are in a part of a surface, or near."""
    return all(float(a) - NEAR <= t <= float(b) + NEAR for t, (a, b) in zip((u, v), part.sides, strict=True))


def differs_nearest(number, random):
    """What is wrong with the nearest points, "" where nothing is."""
    kind = random.choice(["", "", "symmetric", "on it"])
    surface = surface_of(number, random, kind)
    oracle, point = Oracle(surface), tuple(number(random) for _ in range(3))
    if kind == "symmetric":
        point = (mpq(0), *point[1:])
    if kind == "on it":
        point = surface(*place_on(surface, random))
    found = ask(surface, f"nearest:{listed(point)}")
    # the digits are relative to the size of the surface
    squared = near(found.squared * (1 / oracle.size**2))
    places = [tuple(near(x) for x in place.zero.numbers) for place in found]
    corners = [
        (u, v) for part in found.everywhere if not part.along_curve for u in part.sides[0] for v in part.sides[1]
    ]
    for u, v in [*places, *corners]:
        here = sum(((x - y) / oracle.size) ** 2 for x, y in zip(oracle(u, v), point, strict=True))
        if abs(here - squared) > EXACT:
            return f"{float(here)} at {float(u)}, {float(v)}, not {float(squared)}"
    for foot, (u, v) in zip(found.feet, places, strict=True):
        for x, y in zip(foot, oracle(u, v), strict=True):
            if abs(near(x * (1 / oracle.size)) - y / oracle.size) > EXACT:
                return "the foot is not at the parameters"
    goal = doubles(point, oracle.size)
    least, where = oracle.least(lambda s: ((s - goal) ** 2).sum(axis=1), lambda s: 2 * (s - goal))
    if least < float(squared) - FOUND * (1 + float(squared)):
        return f"{least} at {where}, below {float(squared)}"
    if kind == "symmetric" and not found.everywhere:
        total = sum(surface.domain[0])
        missing = [p for p in places if not any(abs(total - p[0] - q[0]) + abs(p[1] - q[1]) < EXACT for q in places)]
        if missing:
            return f"the mirror image of {[float(x) for x in missing[0]]} is not listed"
    return ""


def some_line(surface, number, random, kind):
    """A point and a direction, so made that the line is of this kind."""
    if not kind:
        return [tuple(number(random) for _ in range(3)) for _ in range(2)]
    place = tuple(a + (b - a) * mpq(random.randint(1, 4), 5) for a, b in surface.domain)
    first, second = surface.partial(1, 0, *place), surface.partial(0, 1, *place)
    s, t = mpq(random.randint(-3, 3)), mpq(random.choice([-2, -1, 1]))
    tangent = tuple(s * x + t * y for x, y in zip(first, second, strict=True))
    return surface(*place), tangent if kind == "tangent" else tuple(number(random) for _ in range(3)), place


def differs_line(number, random):
    """What is wrong with the points on a line, a ray and a segment."""
    kind = random.choice(["", "", "tangent", "on it"])
    surface = surface_of(number, random)
    oracle = Oracle(surface)
    start, direction, *place = some_line(surface, number, random, kind)
    if not any(direction):
        return ""
    found = ask(surface, f"line_intersections:{listed(start, direction)}")
    k = max(range(3), key=lambda i: abs(direction[i]))
    for one in found:
        u, v = near(one.zero.first), near(one.zero.second)
        t = near(one.parameter * (direction[k] / oracle.size)) * oracle.size / direction[k]
        for x, y, d in zip(oracle(u, v), start, direction, strict=True):
            if abs(x - y - t * d) / oracle.size > EXACT:
                return f"{one} is not on the line"
    if any(a.parameter > b.parameter for a, b in pairwise(found)):
        return "not in the order of the line"
    if place:
        here = [one for one in found if (one.zero.first, one.zero.second) == place[0]]
        flat = surface.degree == (1, 1) and not found.everywhere and kind == "tangent"
        if not here and not found.everywhere:
            return f"{place[0]} is not listed"
        if kind == "tangent" and here and here[0].zero.kind is ZeroKind.TRANSVERSAL and not flat:
            return f"{here[0]} is a tangent"
    way = doubles(direction, abs(direction[k]))
    for u, v in oracle.meetings(doubles(start, oracle.size), way):
        ours = [(one.zero.first.double(), one.zero.second.double()) for one in found]
        if not any(abs(x - u) + abs(y - v) < NEAR for x, y in ours) and not any(
            inside(x, u, v) for x in found.everywhere
        ):
            return f"{u}, {v} is not listed"
    return differs_parts(surface, start, direction, found)


def differs_parts(surface, start, direction, found):
    """What is wrong with a ray and a segment, given all points of the line."""
    end = [x + d for x, d in zip(start, direction, strict=True)]
    for question, high in (
        (f"ray_intersections:{listed(start, direction)}", None),
        (f"segment_intersections:{listed(start, end)}", 1),
    ):
        try:
            part = ask(surface, question)
        except ShapeError:
            if not found.everywhere:
                return f"{question} is refused"
            continue
        expected = [x for x in found if x.parameter >= 0 and (high is None or x.parameter <= high)]
        if list(part) != expected:
            return f"{question}: {part}, not {expected}"
    return ""


def differs_plane(number, random):
    """What is wrong with the section of a plane."""
    surface = surface_of(number, random)
    oracle = Oracle(surface)
    normal = tuple(mpq(random.randint(-3, 3)) for _ in range(3))
    if not any(normal):
        return ""
    through = surface(*place_on(surface, random)) if random.random() < 0.5 else tuple(number(random) for _ in range(3))
    offset = sum(x * y for x, y in zip(normal, through, strict=True))
    found = ask(surface, f"plane_section:{listed(normal, [offset])}")
    if found.everywhere:
        return ""
    runs = [[(float(u), float(v)) for u, v in run] for run in found.sampled(60)]
    runs += [[(x.first.double(), x.second.double())] for x in found.points]
    up, level = np.array([float(x) for x in normal]), float(offset / oracle.size)
    if runs:
        places = np.array([place for run in runs for place in run])
        s, a, b = oracle.at(places[:, 0], places[:, 1])
        steep = np.abs(a @ up) + np.abs(b @ up)
        if (np.abs(s @ up - level) > 1e-6 * (1 + steep)).any():
            return "a point of a curve is not in the plane"
    # where the sign changes along a line of the grid there must be a curve
    us, vs = (np.linspace(a, b, 41) for a, b in oracle.domain)
    grid = np.array([oracle.at(np.full(41, u), vs)[0] @ up - level for u in us])
    for i, j in product(range(41), range(40)):
        if grid[i, j] * grid[i, j + 1] < 0 and min(abs(grid[i, j]), abs(grid[i, j + 1])) > 1e-12:
            here = np.array([us[i], (vs[j] + vs[j + 1]) / 2])
            if all(distance(here, np.array(run)) > 2 * (vs[1] - vs[0] + us[1] - us[0]) for run in runs):
                return f"no curve near {here}"
    return ""


def distance(point, run):
    """The distance of a point from a polyline, in the plane of the parameters."""
    if len(run) == 1:
        return np.abs(run[0] - point).max()
    a, b = run[:-1], run[1:]
    way = b - a
    t = np.clip(((point - a) * way).sum(axis=1) / np.maximum((way**2).sum(axis=1), 1e-300), 0, 1)
    return np.sqrt((((a + t[:, None] * way) - point) ** 2).sum(axis=1)).min()


def differs_box(number, random):
    """What is wrong with a bounding box."""
    surface = surface_of(number, random)
    oracle = Oracle(surface)
    u, v = oracle.starts(STARTS)
    points = oracle.at(u, v)[0]
    for k, side in enumerate(ask(surface, "bounding_box")):
        for sign, end in ((1, "low"), (-1, "high")):
            ours = float(near(side.values[end] * (1 / oracle.size))) * sign
            least, where = oracle.least(
                lambda s, k=k, sign=sign: sign * s[:, k], lambda s, k=k, sign=sign: sign * np.eye(3)[k]
            )
            if min(least, (sign * points[:, k]).min()) < ours - FOUND:
                return f"{side.what}: {least} at {where}, beyond {ours}"
            if least > ours + 1e-6:
                return f"{side.what}: {ours} is not reached, {least} is"
    return ""


def differs_umbilic(number, random):
    """What is wrong with the kind of an umbilic in Darboux's normal form ``z = k/2 (x² + y²) + a/6 x³ + b/2 x y² + c/6
    y³``: lemon for a/b > (c/2b)² + 2, monstar between this and 1, star for less (Sotomayor and Gutierrez 1982).
    """
    numbers = [number(random) for _ in range(4)]
    k, a, b, c = numbers
    if not b or a == b or not k:
        return ""
    size = max(abs(x) for x in numbers)
    k, a, b, c = (x / size for x in numbers)
    lemon = (c / (2 * b)) ** 2 + 2
    kind = "star" if a / b < 1 else "lemon" if a / b > lemon else "monstar" if a / b < lemon and a != 2 * b else ""
    low = [mpq(-1, random.randint(2, 5)) for _ in range(2)]
    knots = [
        [t, t, mpq(0), mpq(1, 7), mpq(1, 7)] if random.random() < 0.3 else [t, t, mpq(1, 7), mpq(1, 7)] for t in low
    ]
    flat = [[mpq(0)] * (len(own) - 2) for own in knots]
    u, v = (
        TensorSpline(
            (1, 1),
            *knots,
            [[(knots[0][i + 1], knots[1][j + 1])[w] for j in range(len(flat[1]))] for i in range(len(flat[0]))],
        )
        for w in (0, 1)
    )
    # the plane of x and y turned, as coordinates and as parameters
    cos, sin = random.choice([(mpq(1), mpq(0)), (mpq(3, 5), mpq(4, 5)), (mpq(-5, 13), mpq(12, 13))])
    x, y = u.scaled(cos) - v.scaled(sin), u.scaled(sin) + v.scaled(cos)
    z = (
        (x * x + y * y).scaled(k / 2)
        + (x * x * x).scaled(a / 6)
        + (x * y * y).scaled(b / 2)
        + (y * y * y).scaled(c / 6)
    )
    z = z + (x * x * x * x + x * y * y * y).scaled(random.randint(-2, 2))
    w = u.scaled(random.choice([0, 1, -1])) + v.scaled(random.choice([0, 1])) + 4
    made = NurbsSurface.from_splines([x * w, y * w, z * w], w)
    kinds = [str(one.kind) for one in ask(made, "umbilics") if one.place.exact == (0, 0)]
    if not kind:
        return ""
    return "" if kinds == [kind] else f"{kinds}, not {kind} for k, a, b, c = {k}, {a}, {b}, {c}"


# ---- campaigns

FAMILIES = {
    "nearest": differs_nearest,
    "line": differs_line,
    "plane_section": differs_plane,
    "bounding_box": differs_box,
    "umbilics": differs_umbilic,
}


def differs(family, dial, seed):
    """What is wrong with one case, "" where nothing is."""
    return FAMILIES[family](DIALS[dial], Random(f"{family} {dial} {seed}"))


if __name__ == "__main__":
    sys.exit(by_families(__doc__, FAMILIES, DIALS, differs, sys.argv[1:]))
