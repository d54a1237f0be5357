"""Exercises on control points and shape: support, convex hull, inflections, curvature, circles, weights."""

from __future__ import annotations

from random import Random

from exactspline.errors import counted
from exactspline.extras.teaching.answers import Circle, Numbers, Parameters
from exactspline.extras.teaching.exercises import (
    LARGEST,
    Drawn,
    bezier_curve,
    cleared,
    drawn_points,
    given_bezier,
    given_curve,
    knots_of,
    points_of,
    small,
)
from exactspline.extras.teaching.parts import Math, Point, sentence
from exactspline.extras.teaching.triangles import de_boor_triangle
from exactspline.formulas.derivatives import towards_centre
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.language.vector import Vector, det
from exactspline.numbers.exact import is_square, mpq, text
from exactspline.papers import find
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


def _function(rng: Random) -> BSpline:
    """A function of degree 2 or 3 over simple and double integer knots."""
    degree, breaks = rng.choice((2, 3)), [0]
    for _ in range(rng.randint(3, 5)):
        breaks.append(breaks[-1] + rng.randint(1, 2))
    inner = [t for t in breaks[1:-1] for _ in range(rng.choice((1, 1, 2)))]
    knots = [0] * (degree + 1) + inner + [breaks[-1]] * (degree + 1)
    return BSpline(degree, knots, [x for (x,) in drawn_points(rng, len(knots) - degree - 1, 1, 9)])


def support(rng: Random) -> Drawn:
    """The interval on which a control point has influence."""
    f = _function(rng)
    i = rng.randrange(len(f.control_points))
    basis = BSpline(f.degree, f.knots, [int(k == i) for k in range(len(f.control_points))])
    touched = [k for k, (c, _) in enumerate(basis.forms) if c]
    low, high = f.breakpoints[touched[0]], f.breakpoints[touched[-1] + 1]
    task = sentence(
        f"A B-spline function of degree {f.degree} has the knots % and "
        f"{counted(len(f.control_points), 'control point')}, counted from 0. On which interval does it change when "
        f"control point {i} is changed? Give its two ends.",
        knots_of(f),
    )
    solution = (
        f"The basis function number {i} begins at the knot number {i} and ends at the knot number {i} + "
        f"{f.degree} + 1, knots counted from 0: [{text(low)}, {text(high)}].",
    )
    return task, Numbers(("the left end", "the right end"), (low, high)), solution


def hull(rng: Random) -> Drawn:
    """The bounds that control points imply for a function."""
    f = _function(rng)
    k = rng.randrange(len(f.breakpoints) - 1)
    a, b = f.breakpoints[k : k + 2]
    active = [x for (x,) in de_boor_triangle(f, (a + b) / 2).columns[0]]
    if len(set(active)) < len(active) or (min(f.control_points), max(f.control_points)) == (min(active), max(active)):
        return None
    task = (
        *given_curve(f, "function"),
        f". Which bounds on [{text(a)}, {text(b)}] follow from its control points? Give the best lower and upper "
        "bound.",
    )
    influence = f"On this interval only {counted(len(active), 'control point')} have influence"
    solution = sentence(
        f"{influence}, %, and the value is a mean of them with positive weights.", Math("", tuple(active))
    )
    return task, Numbers(("the lower bound", "the upper bound"), (min(active), max(active))), solution


def inflections(rng: Random) -> Drawn:
    """The inflections of a cubic."""
    curve = bezier_curve(drawn_points(rng, 4, size=6))
    bend = find("f0")(curve)
    # most draws have irrational inflections, which is detected cheaply before the features are computed
    if not _square_discriminant(bend) or analyse(curve).singular_points:
        return None
    inflections_found = [f for f in analyse(curve).inflections if f.kind is FeatureKind.INFLECTION]
    parameters = tuple(f.root.exact for f in inflections_found if f.root.exact is not None)
    if not inflections_found or len(parameters) < len(inflections_found) or any(t.denominator > 6 for t in parameters):
        return None
    task = sentence(
        "A cubic Bézier curve over [0, 1] has the control points %. At which parameters inside (0, 1) does it have an "
        "inflection, where the curvature changes sign?",
        points_of(curve),
    )
    values = tuple(Math(f"f({text(t)})", (bend(t),)) for t in parameters)
    reduced = bend.reduce_degree(bend.degree - bend.true_degree)
    words = (
        f"% has the true degree {reduced.degree} and the Bézier points %; its interior zeros at which it changes sign: "
    )
    solution = sentence(words + "% " * len(values), Math("f = x′y″ − y′x″"), points_of(reduced), *values)
    return task, Parameters(parameters), solution


def _square_discriminant(f: BSpline) -> bool:
    """Whether a function of one segment and true degree 1 or 2 has rational zeros."""
    degree = f.true_degree
    if degree < 1:
        return False
    a, b, c = [*f.reduce_degree(f.degree - degree).control_points, mpq(0)][:3] if degree == 2 else (mpq(0),) * 3
    square = b * b - a * c
    return degree == 1 or (square >= 0 and is_square(square.numerator) and is_square(square.denominator))


#: Vectors of rational length.
DIRECTIONS = ((1, 0), (0, 1), (3, 4), (4, 3), (-3, 4), (4, -3), (2, 0), (0, -2), (-1, 0), (-4, -3))


def _with_rational_speed(rng: Random) -> tuple[Nurbs, mpq]:
    """A Bézier curve and the parameter of one of its ends, where the length of γ′ is rational."""
    degree, at_end = rng.choice((2, 3)), rng.random() < 1 / 2
    first, *rest = drawn_points(rng, degree)
    points = [first, tuple(x + d for x, d in zip(first, rng.choice(DIRECTIONS), strict=True)), *rest]
    return bezier_curve(points[::-1] if at_end else points), mpq(at_end)


def curvature(rng: Random) -> Drawn:
    """The curvature at an end of a Bézier curve."""
    curve, t = _with_rational_speed(rng)
    value = values_along.curvature(curve, t).exact
    if not value or max(value.denominator, abs(value.numerator)) > LARGEST:
        return None
    task = (*given_bezier(curve), ". Find its curvature at ", Math("t", (t,)), ", positive where it turns left.")
    solution = sentence(
        "The derivatives there are % and %; their determinant over the third power of the length of the first is %.",
        *(Math("", (curve.derivative(order, t),)) for order in (1, 2)),
        Math("κ", (value,)),
    )
    return task, Numbers(("κ",), (value,)), solution


def _centre(curve: Nurbs, t: mpq) -> Point | None:
    """The centre of curvature; None if there is none."""
    first, second = (Vector(*curve.derivative(k, t)) for k in (1, 2))
    if not det(first, second):
        return None
    centre = Vector(*curve(t)) + towards_centre(first, second)
    return centre[0], centre[1]


def osculating(rng: Random) -> Drawn:
    """The osculating circle at a point, a point of the evolute."""
    curve = bezier_curve(drawn_points(rng, rng.choice((2, 3)) + 1))
    t = mpq(rng.choice((0, 1)))
    centre = _centre(curve, t) if any(curve.derivative(1, t)) else None
    if centre is None or not small(centre):
        return None
    square = sum(((a - b) ** 2 for a, b in zip(centre, curve(t), strict=True)), mpq(0))
    words = ". Find the osculating circle at %: the coordinates of its centre and the square of its radius."
    task = (*given_bezier(curve), *sentence(words, Math("t", (t,))))
    solution = sentence(
        "With the derivatives % and % at the point % the centre is %, a point of the evolute.",
        *(Math("", (at,)) for at in (curve.derivative(1, t), curve.derivative(2, t), curve(t), centre)),
    )
    return task, Numbers(("centre x", "centre y", "radius²"), (*centre, square)), solution


def circle(rng: Random) -> Drawn:
    """Whether a rational quadratic is an arc of a circle."""
    chord, height, side = rng.choice(((3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13)))
    w = mpq(chord, side) if rng.random() < 1 / 2 else rng.choice((mpq(1), mpq(height, side), mpq(2), mpq(1, 2)))
    x, y = rng.randint(-3, 3), rng.randint(-3, 3)
    if rng.random() < 1 / 2:
        points = [(x - chord, y), (x, y + height), (x + chord, y)]
    else:
        points = [(x, y - chord), (x - height, y), (x, y + chord)]
    curve = Nurbs(2, [0, 0, 0, 1, 1, 1], points, [1, w, 1])
    answer, solution = _circle_of(curve)
    if not all(v.denominator <= 16 for v in answer.values):
        return None
    task = sentence(
        "A rational Bézier curve of degree 2 has the control points % with the weights %. Is it an arc of a circle? If "
        "so, give the centre and the square of the radius.",
        points_of(curve),
        Math("", curve.weights),
    )
    return task, answer, solution


def _circle_of(curve: Nurbs) -> tuple[Circle, tuple[str | Math, ...]]:
    """Whether ``‖p − c w‖² = r² w²``, decided as an identity of splines; c is the centre of curvature at 0."""
    centre = _centre(curve, mpq(0))
    if centre is None:
        return Circle(()), ("It is straight.",)
    square = sum(((a - b) ** 2 for a, b in zip(centre, curve(0), strict=True)), mpq(0))
    from_centre = [f - curve.w.scaled(c) for f, c in zip(curve.p, centre, strict=True)]
    rest = from_centre[0] ** 2 + from_centre[1] ** 2 - (curve.w**2).scaled(square)
    begin = ("The osculating circle at t = 0 has the centre ", Math("", (centre,)), " and ", Math("r²", (square,)))
    if rest.is_zero:
        return Circle((*centre, square)), (*begin, "; all other points lie on it too.")
    other = next(t for t in (mpq(1, 2), mpq(1, 3), mpq(1), mpq(1, 4), mpq(1, 5)) if rest(t))
    return Circle(()), (*begin, "; the point ", Math("", (curve(other),)), f" at t = {text(other)} is not on it.")


def weight(rng: Random) -> Drawn:
    """The weight for which a conic passes through a point."""
    w = mpq(rng.choice((1, 2, 3, 4)), rng.choice((1, 1, 2, 3)))
    points = drawn_points(rng, 3)
    knots = [0, 0, 0, 1, 1, 1]
    first = cleared(points, [Nurbs(2, knots, points, [1, w, 1])("1/2")])
    if first is None:
        return None
    a, m, b = (x for x, _ in first)
    if 2 * m == a + b:
        return None
    curve = Nurbs(2, knots, first, [1, w, 1])
    place = curve("1/2")
    task = sentence(
        "A rational Bézier curve of degree 2 has the control points % with the weights 1, w, 1. For which w is its "
        "point at % the point %?",
        *(points_of(curve), Math("t", (mpq(1, 2),)), Math("", (place,))),
    )
    s = place[0]
    # s (1 + w) = (a + b)/2 + w m
    weight_value = ((a + b) / 2 - s) / (s - m)
    words = "At t = 1/2 the curve has x = %, where (% + 2w·% + %) / (2 + 2w) has to be; so %."
    solution = sentence(words, *(Math("", (x,)) for x in (s, a, m, b)), Math("w", (weight_value,)))
    return task, Numbers(("w",), (weight_value,)), solution
