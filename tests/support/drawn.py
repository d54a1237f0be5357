"""Curves, pairs of curves, surfaces and maps of the plane at random, of which there is much to tell: half of the curves
closed, with cusps, corners, straight and circular pieces; their coordinates from small integers to doubles.
"""

from functools import partial

from gmpy2 import mpq

from exactspline import Nurbs, NurbsSurface, TensorSpline, analyse, example
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.pairs.regions import Region
from exactspline.questions.entry import Of
from tests.campaigns.common_borders import FAMILIES, drawn
from tests.support.changes import MOTIONS, from_seam, moved_curve
from tests.support.dials import DIALS

#: Small numbers more often than long ones.
CHOSEN = ["small integers"] * 3 + ["thirds", "ten decimals", "doubles"]
CLOSED = {2: ["ellipse", "circle"], 3: []}
OPEN = {
    2: ["rational_cubic", "cubic_s", "cusp", "jump", "straight_between_arcs", "six_segment_cubic"],
    3: ["rational_space_cubic", "twisted_cubic", "planar_in_space", "flat_point"],
}


def point(number, dimension, random):
    """A point with coordinates of a dial."""
    return tuple(number(random) for _ in range(dimension))


def weights(count, random):
    """All 1, or small positive integers."""
    return [mpq(random.randint(1, 3)) if w else mpq(1) for w in [random.random() < 0.4] * count]


def some_points(count, number, dimension, random):
    """Points, now and then one of them twice, or three on a line."""
    points = [point(number, dimension, random) for _ in range(count)]
    if count > 2 and random.random() < 0.3:
        k = random.randrange(count - 1)
        points[k + 1] = points[k]
    elif count > 2 and random.random() < 0.3:
        k = random.randrange(count - 2)
        points[k + 1] = tuple((x + y) / 2 for x, y in zip(points[k], points[k + 2], strict=True))
    return points


def open_curve(number, dimension, random):
    """A curve of one to three segments, its inner knots of any multiplicity."""
    degree, segments = random.choice([(1, 3), (2, 1), (2, 2), (2, 3), (3, 1), (3, 2)])
    inner = [mpq(t) for t in range(1, segments) for _ in range(random.randint(1, degree))]
    knots = [mpq(0)] * (degree + 1) + inner + [mpq(segments)] * (degree + 1)
    count = len(knots) - degree - 1
    return Nurbs(degree, knots, some_points(count, number, dimension, random), weights(count, random))


def periodic(number, dimension, random):
    """A closed curve over uniform knots that are not clamped, smooth at its seam."""
    degree, count = random.choice([(2, 3), (2, 4), (3, 4)])
    points, own = some_points(count, number, dimension, random), weights(count, random)
    points, own = [*points, *points[:degree]], [*own, *own[:degree]]
    return Nurbs(degree, [mpq(t) for t in range(count + 2 * degree + 1)], points, own)


def chain(number, dimension, random):
    """A closed chain of Bézier curves, with corners."""
    degree, segments = random.choice([(1, 4), (2, 2), (2, 3), (3, 1), (3, 2)])
    count = degree * segments
    points, own = some_points(count, number, dimension, random), weights(count, random)
    knots = [mpq(0), *[mpq(t) for t in range(segments + 1) for _ in range(degree)], mpq(segments)]
    return Nurbs(degree, knots, [*points, points[0]], [*own, own[0]])


def smooth_loop(number, dimension, random):
    """A closed Bézier curve with one tangent at its ends, where its curvature jumps."""
    start, middle = point(number, dimension, random), [point(number, dimension, random) for _ in range(2)]
    step = point(number, dimension, random)
    ends = [[x + sign * d for x, d in zip(start, step, strict=True)] for sign in (1, -1)]
    points = [start, ends[0], *middle, ends[1], start]
    return Nurbs(5, [mpq(0)] * 6 + [mpq(1)] * 6, points)


def stadium(number, dimension, random, seam=None):
    """A closed chain of straight pieces and quarters of circles, its seam at any knot; turned."""
    end = 2 * mpq(random.randint(1, 3))
    outline = [(0, 0), (end / 2, 0), (end, 0), (end + 1, 0), (end + 1, 1), (end + 1, 2), (end, 2)]
    outline += [(end / 2, 2), (0, 2), (-1, 2), (-1, 1), (-1, 0), (0, 0)]
    points = [(mpq(x), mpq(y), mpq(0))[:dimension] for x, y in outline]
    own = [2 if k in (4, 10) else 1 for k in range(13)]
    curve = Nurbs(2, [mpq(0), *[mpq(t) for t in range(7) for _ in range(2)], mpq(6)], points, own)
    seen = from_seam(curve, mpq(seam or random.randint(1, 5)))[0]
    return moved_curve(seen, MOTIONS["rotated"](dimension, random))


def round_loop(random, seam=None):
    """A stadium with its seam where a quarter of a circle begins or ends, and the centres of both."""
    made = stadium(None, 2, random, seam or random.choice([1, 3, 4]))
    return made, list(dict.fromkeys(x.shape.centre for x in analyse(made).shapes if hasattr(x.shape, "centre")))


def known_curve(names, number, dimension, random):
    """An example, moved."""
    curve = example(random.choice(names))
    return moved_curve(curve, MOTIONS["rotated"](dimension, random))


def curve(dimension, random):
    """A curve; half of them are closed."""
    number = DIALS[random.choice(CHOSEN)]
    if random.random() < 0.5:
        kinds = [
            periodic,
            periodic,
            chain,
            smooth_loop,
            stadium,
            *[partial(known_curve, names) for names in [CLOSED[dimension]] if names],
        ]
    else:
        kinds = [open_curve, open_curve, open_curve, partial(known_curve, OPEN[dimension])]
    made = random.choice(kinds)(number, dimension, random)
    # in the plane z = 0 it would be a plane curve to some questions, and not to these after a motion
    return curve(dimension, random) if dimension == 3 and not any(p[2] for p in made.control_points) else made


def pair(random):
    """Two curves of one dimension; now and then the second has a part of the first, or is parallel to it."""
    dimension = random.choice([2, 2, 3])
    first = curve(dimension, random)
    kind = random.random()
    if kind < 0.2:
        a, b = first.domain
        second = first.restrict(a + (b - a) / 4, a + (b - a) * mpq(2, 3))
    elif kind < 0.3:
        second = moved_curve(first, MOTIONS["mirrored"](dimension, random))
    else:
        second = curve(dimension, random)
    return CurvePair(first, second)


def light_pair(random):
    """Two curves of small integers, of degree 1 or 2: open ones, rings, closed chains with corners, circles."""
    dimension = random.choice([2, 2, 2, 3])
    return CurvePair(*(light_curve(dimension, random) for _ in range(2)))


def light_curve(dimension, random):
    """One of them."""
    if dimension == 2 and random.random() < 0.25:
        return moved_curve(example("circle"), MOTIONS["rotated"](2, random))
    degree, count, closed = random.choice([(1, 2, False), (1, 3, True), (2, 2, False), (2, 2, True), (2, 3, True)])
    points = [point(DIALS["small integers"], dimension, random) for _ in range(count)]
    if degree == 2 and closed and count == 3:
        return Nurbs(2, [mpq(t) for t in range(8)], [*points, *points[:2]])
    points = [*points, points[0] if closed else point(DIALS["small integers"], dimension, random)]
    if degree == 1:
        return Nurbs(1, [0, *range(count + 1), count], points)
    return Nurbs(2, [0, 0, 0, 1, 1, 1], points)


def surface(random):
    """A patch of small degree, or one of the examples of which there is something to tell."""
    kind = random.random()
    if kind < 0.4:
        return example(random.choice(SURFACES))
    if kind < 0.6:
        return graph(random)
    return net(random, 3, random.choice([(1, 1), (1, 2), (2, 1)]))


SURFACES = ["hyperbolic_paraboloid", "monkey_saddle", "cylinder", "cone", "sphere", "cross_cap"]


def light_surface(random):
    """A surface of which questions are answered at once."""
    kind = random.random()
    if kind < 0.4:
        return example(random.choice(["hyperbolic_paraboloid", "monkey_saddle", "cross_cap"]))
    return graph(random) if kind < 0.5 else net(random, 3, (1, 1))


def graph(random):
    """z = (x − y)³, (x − y)⁴ or (x − y)² + (x − y)³ over a square: a curve of umbilics, or a parabolic one, from corner
    to corner.
    """
    x, y = (TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], rows) for rows in ([[0, 0], [1, 1]], [[0, 1], [0, 1]]))
    d = x - y
    return NurbsSurface.from_splines([x, y, random.choice([d**3, d**4, d**2 + d**3])])


def net(random, dimension, degree):
    """A patch over a net of small integers; in space not one that is a curve, on which every knot line is a joint."""
    grid = [[(mpq(i), mpq(j), mpq(0))[:dimension] for j in range(degree[1] + 1)] for i in range(degree[0] + 1)]
    points = [[tuple(x + random.randint(-1, 1) for x in p) for p in row] for row in grid]
    knots = [[mpq(0)] * (n + 1) + [mpq(1)] * (n + 1) for n in degree]
    made = NurbsSurface(degree, *knots, points)
    bare = dimension == 3 and analyse(made).kinds[0] in ("a curve", "a point")
    return net(random, dimension, degree) if bare else made


def surface_pair(random):
    """Two surfaces that have a border in common, of small degree, in every way of meeting there."""
    return SurfacePair(*drawn(random.choice(list(FAMILIES)), random.choice(CHOSEN), random.randrange(1 << 30)))


def planar_map(random):
    """A map of the unit square into the plane, regular or folded."""
    if random.random() < 0.3:
        return example(random.choice(["planar_map", "folded_map"]))
    return net(random, 2, random.choice([(1, 1), (1, 2), (2, 2)]))


def light_bisector(random):
    """The bisector of two space curves, now and then of two that meet, or of which one is the other one moved up."""
    first, second = (light_curve(3, random) for _ in range(2))
    kind = random.random()
    if kind < 0.2:
        step = [x - y for x, y in zip(second.control_points[0], first.control_points[0], strict=True)]
        second = moved_curve(second, lambda p: tuple(x - d for x, d in zip(p, step, strict=True)))
    elif kind < 0.3:
        second = moved_curve(first, lambda p: (*p[:2], p[2] + 1))
    return CurveBisector(first, second)


def region(random):
    """Convex contours with corners or smooth, a few of them circles, most of them nested or apart."""
    curves = []
    for _ in range(random.randint(1, 4)):
        size, x, y = random.choice([1, 3, 5, 8]), *(random.choice([0, 0, 0, 20, mpq(1, 3)]) for _ in range(2))
        corners = [(x + size * u, y + size * v) for u, v in [(1, 1), (-1, 1), (-1, -1), (1, -1)]]
        corners = corners[:: random.choice([1, -1])]
        kinds = [
            Nurbs(1, [0, *range(5), 4], [*corners, corners[0]]),
            Nurbs(2, list(range(9)), [*corners, *corners[:2]]),
            Nurbs(3, list(range(11)), [*corners, *corners[:3]]),
        ]
        if random.random() < 0.1:
            kinds = [moved_curve(example("circle"), lambda p, r=size, x=x, y=y: (r * p[0] + x, r * p[1] + y))]
        curves.append(random.choice(kinds))
    return Region(curves, random.choice(["nonzero", "even-odd"]))


#: What is drawn of each kind of object.
DRAWN = {
    Of.PLANE_CURVE: partial(curve, 2),
    Of.SPACE_CURVE: partial(curve, 3),
    Of.TWO_CURVES: pair,
    Of.PAIR: light_bisector,
    Of.REGION: region,
    Of.SURFACE: surface,
    Of.TWO_SURFACES: surface_pair,
    Of.PLANAR_MAP: planar_map,
}
