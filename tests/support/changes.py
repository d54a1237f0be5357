"""What can be done to a curve, to two curves or to a surface without changing what there is to tell of it, each with
where parameters and points go: made of knots and control points alone, so that the library is not trusted for it.
"""

from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from random import Random

from gmpy2 import mpq

from exactspline import BSpline, Nurbs, NurbsSurface, analyse
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.pairs.regions import Region
from exactspline.questions.entry import Of
from tests.support.images import BothImages, Image, Motion, Way

#: How near a knot is put to what was found.
NEAR = mpq(1, 2**300)
#: On surfaces, where numbers of 300 bits put common zeros out of reach.
NEAR_ON_SURFACES = mpq(1, 2**30)
SAME = Way()


# ---- along one parameter


@dataclass(frozen=True)
class Rows:
    """Homogeneous control points, each a row of any length, over knots."""

    degree: int
    knots: tuple[mpq, ...]
    points: tuple[tuple[mpq, ...], ...]

    @property
    def domain(self):
        """Where the rows are a basis."""
        return self.knots[self.degree], self.knots[-self.degree - 1]

    @property
    def breaks(self):
        """The different knots in the domain."""
        a, b = self.domain
        return sorted({t for t in self.knots if a <= t <= b})

    def column_wise(self, change):
        """Every column as a spline, changed."""
        changed = [change(BSpline(self.degree, list(self.knots), list(c))) for c in zip(*self.points, strict=True)]
        degree = max(f.degree for f in changed)
        columns = [f.elevate_degree(degree - f.degree) if f.degree < degree else f for f in changed]
        points = tuple(zip(*[f.control_points for f in columns], strict=True))
        return Rows(degree, tuple(columns[0].knots), points)


def inserted(rows, t):
    """A knot inserted by Boehm's algorithm, inside the domain."""
    knots, points, n = rows.knots, rows.points, rows.degree
    j = max(i for i, u in enumerate(knots) if u <= t)
    made = []
    for i in range(len(points) + 1):
        if i <= j - n:
            made.append(points[i])
        elif i > j:
            made.append(points[i - 1])
        else:
            width = knots[i + n] - knots[i]
            share = (t - knots[i]) / width if width else mpq(0)
            made.append(tuple((1 - share) * x + share * y for x, y in zip(points[i - 1], points[i], strict=True)))
    return Rows(n, tuple(sorted([*knots, t])), tuple(made))


def knot_at(rows, t):
    """A knot inserted where there is room for one."""
    a, b = rows.domain
    full = a < t < b and rows.knots.count(t) < rows.degree
    return (inserted(rows, t), SAME) if full else None


def knot_far(rows, random):
    """A knot inserted anywhere."""
    a, b = random.choice(list(pairwise(rows.breaks)))
    return knot_at(rows, a + (b - a) * mpq(random.randint(1, 30), 31))


def elevated(rows, random):
    """Written with a degree more."""
    return rows.column_wise(lambda f: f.elevate_degree(1)), SAME


def constant_weights(rows, random):
    """All weights times one constant, which may be negative."""
    c = mpq(random.choice([-1, 1]) * random.randint(1, 9), random.choice([1, 3, 7]))
    return Rows(rows.degree, rows.knots, tuple(tuple(x * c for x in row) for row in rows.points)), SAME


def common_factor(rows, random):
    """All coordinates times one linear polynomial that is positive on the domain."""
    a, b = rows.domain
    ends = [mpq(random.randint(1, 5)) for _ in range(2)]
    factor = BSpline(1, [a, a, b, b], ends)
    return rows.column_wise(lambda f: f * factor), SAME


def affine(rows, random):
    """Another affine parameter, in the same direction."""
    c, d = mpq(random.randint(1, 9), random.randint(1, 9)), mpq(random.randint(-9, 9))
    return Rows(rows.degree, tuple(c * t + d for t in rows.knots), rows.points), Way(
        lambda t: c * t + d, slopes=lambda t: (c, mpq(0))
    )


def moebius(rows, random):
    """The parameter ``u = (t − a) / (1 + k (t − a))``, increasing over all knots: of the homogeneous blossom each
    argument t leaves a factor ``1 + k (t − a)`` below.
    """
    low, high = rows.knots[0], rows.knots[-1]
    k = mpq(random.choice([-1, 1, 2]), 3) / (high - low)

    def below(t):
        return 1 + k * (t - low)

    def to(t):
        return (t - low) / below(t)

    points = []
    for i, row in enumerate(rows.points):
        factor = mpq(1)
        for t in rows.knots[i + 1 : i + rows.degree + 1]:
            factor /= below(t)
        points.append(tuple(x * factor for x in row))

    def slopes(t):
        return 1 / below(t) ** 2, -2 * k / below(t) ** 3

    return Rows(rows.degree, tuple(map(to, rows.knots)), tuple(points)), Way(to, slopes=slopes)


def reversed_rows(rows, random):
    """Run through the other way."""
    a, b = rows.domain
    knots = tuple(a + b - t for t in reversed(rows.knots))
    return Rows(rows.degree, knots, rows.points[::-1]), Way(lambda t: a + b - t, True, lambda t: (mpq(-1), mpq(0)))


#: What is done to one parameter of a curve or a surface, by its name.
ALONG = {
    "knot far away": knot_far,
    "degree": elevated,
    "constant weight": constant_weights,
    "common factor": common_factor,
    "affine": affine,
    "moebius": moebius,
    "reversed": reversed_rows,
}


# ---- curves


def rows_of(curve):
    """The homogeneous control points of a curve."""
    points = [(*(x * w for x in p), w) for p, w in zip(curve.control_points, curve.weights, strict=True)]
    return Rows(curve.degree, tuple(curve.knots), tuple(points))


def curve_from(rows):
    """The curve; None where a weight vanishes."""
    if not all(row[-1] for row in rows.points):
        return None
    points = [tuple(x / row[-1] for x in row[:-1]) for row in rows.points]
    return Nurbs(rows.degree, list(rows.knots), points, [row[-1] for row in rows.points])


def of_curve(change):
    """A change of rows as one of a curve."""

    def changed(curve, random):
        found = change(rows_of(curve), random)
        other = found and curve_from(found[0])
        return other and (other, Image((found[1], found[1])))

    return changed


def found_on(curve, names=("inflections", "critical_points")):
    """Rational parameters inside the domain at which something was found."""
    facts, (a, b) = analyse(curve), curve.domain
    roots = [f.root.exact for name in names for f in getattr(facts, name)]
    return sorted({t for t in roots if t is not None and a < t < b})


def knot_on_what_was_found(curve, random):
    """A knot at an inflection or an extremum, or once more at a knot."""
    places = [*found_on(curve), *curve.breakpoints[1:-1]]
    return places and of_curve(lambda rows, random: knot_at(rows, random.choice(places)))(curve, random)


def knot_on_a_singular_point(curve, random):
    """A knot where γ′ = 0 inside of a segment."""
    places = [t for t in found_on(curve, ("singular_points",)) if t not in curve.breakpoints]
    return places and of_curve(lambda rows, random: knot_at(rows, random.choice(places)))(curve, random)


def knot_near_what_was_found(curve, random):
    """A knot next to a feature or a knot."""
    (a, b), (low, high) = curve.domain, min(pairwise(curve.breakpoints), key=lambda ends: ends[1] - ends[0])
    places = [*found_on(curve), *found_on(curve, ("singular_points",)), *curve.breakpoints]
    t = random.choice(places)
    step = NEAR * (high - low)
    beside = t + step if t == a else t - step if t == b else t + random.choice([-step, step])
    return of_curve(lambda rows, random: knot_at(rows, beside))(curve, random)


def other_seam(curve, random):
    """A closed curve from another point on: a knot, or between knots."""
    if not curve.closed:
        return None
    a, b = curve.domain
    places = [*curve.breakpoints[1:-1], a + (b - a) * mpq(random.randint(1, 30), 31)]
    return from_seam(curve, random.choice(places))


def from_seam(curve, t):
    """A closed curve from a parameter on; what comes before it follows the end."""
    a, b = curve.domain
    before, behind = map(rows_of, curve.split(t))
    n = curve.degree
    knots = (*behind.knots, *[u + b - a for u in before.knots[n + 1 :]])
    other = curve_from(Rows(n, knots, (*behind.points, *before.points)))
    way = Way(lambda u: u + b - a if u < t else u, before=lambda u: u + b - a if u <= t else u)
    return other and (other, Image((way, way)))


# ---- motions


#: Cosines and sines of rational rotations of the plane.
TURNS = [(mpq(3, 5), mpq(4, 5)), (mpq(-5, 13), mpq(12, 13)), (mpq(20, 29), mpq(-21, 29)), (mpq(0), mpq(1))]


def rotation(dimension, random):
    """A rational rotation and a translation."""
    c, s = random.choice(TURNS[: 3 if dimension == 2 else 4])
    plane = [[c, -s], [s, c]]
    matrix = plane if dimension == 2 else rotation_in_space(random)
    shift = tuple(mpq(random.randint(-9, 9), random.choice([1, 2, 7])) for _ in range(dimension))
    return Motion(tuple(map(tuple, matrix)), shift)


def rotation_in_space(random):
    """A rational rotation, by a quaternion of small integers."""
    a, b, c, d = (mpq(x) for x in random.choice([(2, 1, 0, 1), (1, 2, 3, -1), (3, -1, 1, 2)]))
    n = a * a + b * b + c * c + d * d
    rows = [
        [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
        [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
        [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ]
    return [[x / n for x in row] for row in rows]


def mirror(dimension, random):
    """One coordinate negated, or two of them exchanged."""
    rows = [[mpq(i == j) for j in range(dimension)] for i in range(dimension)]
    i = random.randrange(dimension)
    if random.random() < 0.5:
        rows[i][i] = mpq(-1)
    else:
        j = (i + 1) % dimension
        rows[i], rows[j] = rows[j], rows[i]
    return Motion(tuple(map(tuple, rows)), (mpq(0),) * dimension, turns=True)


def scaling(dimension, random):
    """Larger or smaller."""
    c = mpq(random.randint(1, 9), random.choice([2, 5, 1000]))
    rows = [[c * (i == j) for j in range(dimension)] for i in range(dimension)]
    return Motion(tuple(map(tuple, rows)), (mpq(0),) * dimension, scale=c)


MOTIONS = {"rotated": rotation, "mirrored": mirror, "scaled": scaling}


def moved_curve(curve, motion):
    """A curve with each control point moved."""
    points = [motion(p) for p in curve.control_points]
    return Nurbs(curve.degree, list(curve.knots), points, list(curve.weights))


def move_curve(kind, curve, random):
    """A curve moved by one motion."""
    motion = kind(curve.dimension, random)
    return moved_curve(curve, motion), Image(motion=motion)


OF_CURVES = {
    "knot on what was found": knot_on_what_was_found,
    "knot on a singular point": knot_on_a_singular_point,
    "knot near what was found": knot_near_what_was_found,
    **{name: of_curve(change) for name, change in ALONG.items()},
    "other seam": other_seam,
    **{name: partial(move_curve, kind) for name, kind in MOTIONS.items()},
}


# ---- two curves


def of_one(change, pair, random):
    """One of two curves written otherwise."""
    k = random.randrange(2)
    found = change(pair.curves[k], random)
    if not found:
        return None
    curve, image = found
    curves = (curve, pair.curves[1]) if k == 0 else (pair.curves[0], curve)
    ways = (image.ways[0], SAME) if k == 0 else (SAME, image.ways[0])
    return CurvePair(*curves), Image(ways)


def move_pair(kind, pair, random):
    """Both curves moved by one motion."""
    motion = kind(pair.curves[0].dimension, random)
    return CurvePair(*(moved_curve(curve, motion) for curve in pair.curves)), Image(motion=motion)


def exchanged_pair(pair, random):
    """The second curve first."""
    return CurvePair(*pair.curves[::-1]), Image(exchanged=True)


OF_PAIRS = {
    **{name: partial(of_one, change) for name, change in OF_CURVES.items() if name not in MOTIONS},
    **{name: partial(move_pair, kind) for name, kind in MOTIONS.items()},
    "exchanged": exchanged_pair,
}


# ---- bisectors of two space curves


def of_bisector(change, bisector, random):
    """The bisector of curves that are written otherwise."""
    found = change(CurvePair(*bisector.curves), random)
    return found and (CurveBisector(*found[0].curves), found[1])


#: Knots divide the patches, and so does the seam: an equation is told on each patch that its zeros may not meet.
OF_BISECTORS = {
    name: partial(of_bisector, change)
    for name, change in OF_PAIRS.items()
    if "knot" not in name and name != "other seam"
}


# ---- regions


def of_contours(change, region, random):
    """Every contour written otherwise, all in the same direction as before or all in the other one."""
    found = [change(curve, random) or (curve, Image()) for curve in region.curves]
    ways = {image.ways[0].backwards: image.ways for _, image in found}
    return (Region([curve for curve, _ in found], region.rule), Image(*ways.values())) if len(ways) == 1 else None


def move_region(kind, region, random):
    """All contours moved by one motion."""
    motion = kind(2, random)
    return Region([moved_curve(curve, motion) for curve in region.curves], region.rule), Image(motion=motion)


def other_order(region, random):
    """The contours in another order."""
    return Region(random.sample(region.curves, len(region.curves)), region.rule), Image()


OF_REGIONS = {
    **{name: partial(of_contours, change) for name, change in OF_CURVES.items() if name not in MOTIONS},
    **{name: partial(move_region, kind) for name, kind in MOTIONS.items()},
    "other order": other_order,
}


# ---- surfaces


def net_of(surface):
    """The homogeneous control points of a surface."""
    return [
        [(*(x * w for x in p), w) for p, w in zip(points, weights, strict=True)]
        for points, weights in zip(surface.control_points, surface.weights, strict=True)
    ]


def surface_from(degree, knots, net):
    """The surface; None where a weight vanishes."""
    if not all(p[-1] for row in net for p in row):
        return None
    points = [[tuple(x / p[-1] for x in p[:-1]) for p in row] for row in net]
    return NurbsSurface(degree, *map(list, knots), points, [[p[-1] for p in row] for row in net])


def transposed(surface):
    """u and v exchanged."""
    net = [list(column) for column in zip(*net_of(surface), strict=True)]
    return surface_from(surface.degree[::-1], surface.knots[::-1], net)


def exchanged_surface(surface, random):
    """u and v exchanged."""
    return transposed(surface), Image(exchanged=True)


def of_surface(change, surface, random):
    """One parameter of a surface written otherwise."""
    by_v = random.random() < 0.5
    turned = transposed(surface) if by_v else surface
    found = along_u(turned, change, random)
    if not found:
        return None
    other, way = found
    return (transposed(other), Image((SAME, way))) if by_v else (other, Image((way, SAME)))


def along_u(surface, change, random):
    """A change of the first parameter: each row of control points is one long row of numbers."""
    net = net_of(surface)
    size = len(net[0][0])
    flat = tuple(tuple(x for p in row for x in p) for row in net)
    found = change(Rows(surface.degree[0], tuple(surface.knots[0]), flat), random)
    if not found:
        return None
    rows, way = found
    made = [[row[i : i + size] for i in range(0, len(row), size)] for row in rows.points]
    other = surface_from((rows.degree, surface.degree[1]), (rows.knots, surface.knots[1]), made)
    return other and (other, way)


def move_surface(kind, surface, random):
    """A surface with each control point moved."""
    motion = kind(len(surface.control_points[0][0]), random)
    net = [[(*motion([x / p[-1] for x in p[:-1]]), p[-1]) for p in row] for row in net_of(surface)]
    net = [[(*(x * w for x in p), w) for *p, w in row] for row in net]
    return surface_from(surface.degree, surface.knots, net), Image(motion=motion)


def knot_in_the_middle(rows, random):
    """A knot at a simple fraction of a segment, where surfaces of the examples have their features."""
    a, b = random.choice(list(pairwise(rows.breaks)))
    return knot_at(rows, a + (b - a) * random.choice([mpq(1, 2), mpq(1, 3)]))


def knot_near_a_knot(rows, random):
    """A knot next to another one."""
    a, b = random.choice(list(pairwise(rows.breaks)))
    return knot_at(rows, random.choice([a + (b - a) * NEAR_ON_SURFACES, b - (b - a) * NEAR_ON_SURFACES]))


OF_SURFACES = {
    "knot on what was found": partial(of_surface, knot_in_the_middle),
    "knot near what was found": partial(of_surface, knot_near_a_knot),
    **{name: partial(of_surface, change) for name, change in ALONG.items()},
    **{name: partial(move_surface, kind) for name, kind in MOTIONS.items()},
    "exchanged": exchanged_surface,
}

# ---- two surfaces


def of_one_surface(change, pair, random):
    """One of two surfaces written otherwise."""
    k = random.randrange(2)
    found = change(pair.surfaces[k], random)
    if not found or not found[0]:
        return None
    surfaces, images = list(pair.surfaces), [Image(), Image()]
    surfaces[k], images[k] = found
    return SurfacePair(*surfaces), BothImages(tuple(images))


def move_surfaces(kind, pair, random):
    """Both surfaces moved by one motion."""
    seed = random.randrange(1 << 30)
    moved = [move_surface(kind, each, Random(seed)) for each in pair.surfaces]
    return SurfacePair(*(each for each, _ in moved)), BothImages(motion=moved[0][1].motion)


def exchanged_surfaces(pair, random):
    """The second surface first."""
    return SurfacePair(*pair.surfaces[::-1]), BothImages(exchanged=True)


OF_SURFACE_PAIRS = {
    **{f"{name} of one": partial(of_one_surface, x) for name, x in OF_SURFACES.items() if name not in MOTIONS},
    **{name: partial(move_surfaces, kind) for name, kind in MOTIONS.items()},
    "exchanged": exchanged_surfaces,
}

#: The changes of each kind of object, by their names.
CHANGES = {
    Of.PLANE_CURVE: OF_CURVES,
    Of.SPACE_CURVE: OF_CURVES,
    Of.TWO_CURVES: OF_PAIRS,
    Of.PAIR: OF_BISECTORS,
    Of.REGION: OF_REGIONS,
    Of.SURFACE: OF_SURFACES,
    Of.TWO_SURFACES: OF_SURFACE_PAIRS,
    Of.PLANAR_MAP: OF_SURFACES,
}
