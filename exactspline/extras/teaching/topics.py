"""Exercises, each with task, answer and solution, and the topics that generate them: the same seed yields the same
exercise on every platform.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from random import Random

from exactspline.errors import ExactSplineError, as_text, counted, nearest, shown
from exactspline.extras.teaching.answers import Answer, Circle, Numbers, Parameters, Points, Polynomials
from exactspline.extras.teaching.parts import Math, Part, Point, Polynomial, sentence
from exactspline.extras.teaching.triangles import (
    de_boor_triangle,
    elevation_triangles,
    insertion_triangle,
    product_tables,
)
from exactspline.formulas.derivatives import towards_centre
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.language.vector import Vector, det, norm2, perp
from exactspline.numbers.exact import is_square, mpq, over_one_denominator, text
from exactspline.papers import find
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs

#: The largest number in a task or an answer, except for squares of radii.
LARGEST = 30


@dataclass(frozen=True)
class Exercise:
    """The question, the right answer, and the solution."""

    topic: str
    seed: int
    task: tuple[Part, ...]
    answer: Answer
    solution: tuple[Part, ...]

    def __repr__(self) -> str:
        return f"<Exercise {self.topic}, seed {self.seed}>"


#: The result of one draw of a topic: task, answer and solution; or None if the numbers are not simple enough, and the
#: draw is to be repeated.
Drawn = tuple[tuple[Part, ...], Answer, tuple[Part, ...]] | None
Topic = Callable[[Random], Drawn]


def _points_of(curve: Nurbs | BSpline) -> Math:
    """The list of control points."""
    if isinstance(curve, BSpline):
        return Math("", curve.control_points)
    return Math("", tuple(tuple(point) for point in curve.control_points))


def _knots_of(curve: Nurbs | BSpline) -> Math:
    """The list of knots."""
    return Math("", curve.knots.knots)


def _given_curve(curve: Nurbs | BSpline, what: str = "curve") -> tuple[Part, ...]:
    """The beginning of a task: a curve or a function with its knots and control points."""
    begin = f"A B-spline {what} of degree {curve.degree} has the knots "
    return (begin, _knots_of(curve), " and the control points ", _points_of(curve))


def _given_bezier(curve: Nurbs) -> tuple[Part, ...]:
    """The beginning of a task: a Bézier curve with its control points."""
    return (f"A Bézier curve of degree {curve.degree} over [0, 1] has the control points ", _points_of(curve))


def _bezier_curve(points: Sequence[Point]) -> Nurbs:
    """The Bézier curve over [0, 1] with these control points."""
    degree = len(points) - 1
    return Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), points)


def _drawn_points(rng: Random, many: int, dimension: int = 2, size: int = 4) -> list[Point]:
    """Points with small integer coordinates."""
    return [tuple(mpq(rng.randint(-size, size)) for _ in range(dimension)) for _ in range(many)]


def _cleared(points: Sequence[Point], made: Iterable[Point]) -> list[Point] | None:
    """The points times the least integer for which the points `made` from them (linearly) have integer coordinates;
    None if they become large, or if neighbours coincide.
    """
    numbers = [x for row in made for x in row]
    _, factor = over_one_denominator(numbers)
    largest = max(abs(x) for x in [*numbers, *[x for row in points for x in row]])
    if factor * largest > LARGEST or any(a == b for a, b in pairwise(points)):
        return None
    return [tuple(factor * x for x in row) for row in points]


def _simple(curve: Nurbs, made: Iterable[Point]) -> Nurbs | None:
    """The curve with its control points times such a factor (see `_cleared`); None if they become large, or if
    neighbours coincide.
    """
    points = _cleared(curve.control_points, made)
    return None if points is None else Nurbs(curve.degree, curve.knots, points)


def _small(values: Iterable[mpq]) -> bool:
    """Whether all are integers of about two digits."""
    return all(x.denominator == 1 and abs(x) <= LARGEST for x in values)


#: Hints for the first step, without numbers of the answer, and how a topic is drawn, by the name of the topic.
HINTS: dict[str, str] = {}
TOPICS: dict[str, Topic] = {}


def _topic(hint: str) -> Callable[[Topic], Topic]:
    """Enter a topic under the name of the function that draws it."""

    def enter(draw: Topic) -> Topic:
        name = draw.__name__.removeprefix("_")
        TOPICS[name], HINTS[name] = draw, hint
        return draw

    return enter


# ---- algorithms


def _knots(rng: Random, degree: int) -> list[int]:
    """Clamped knots over [0, 2] or a longer interval, with at most two interior knots."""
    breaks = [0, *sorted(rng.sample(range(1, 5), rng.randint(0, 2)))]
    return [0] * degree + breaks + [breaks[-1] + rng.randint(1, 2)] * (degree + 1)


def _curve(rng: Random, degree: int) -> Nurbs:
    knots = _knots(rng, degree)
    return Nurbs(degree, knots, _drawn_points(rng, len(knots) - degree - 1))


def _inner(rng: Random, curve: Nurbs | BSpline) -> mpq:
    """A parameter inside a segment: its midpoint or a third point."""
    i = rng.randrange(len(curve.breakpoints) - 1)
    a, b = curve.breakpoints[i : i + 2]
    return a + (b - a) * mpq(rng.choice((Fraction(1, 2), Fraction(1, 3), Fraction(2, 3), Fraction(1, 2))))


@_topic(
    "The control points of the segment that contains t begin the triangle. In step k neighbours are combined "
    "with the weights (b − t)/(b − a) and (t − a)/(b − a), where [a, b] consists of degree + 1 − k intervals "
    "between neighbouring knots."
)
def _evaluation(rng: Random) -> Drawn:
    """The point of a B-spline curve by de Boor's triangle."""
    drawn = _curve(rng, rng.choice((2, 3)))
    t = _inner(rng, drawn)
    triangle = de_boor_triangle(drawn, t)
    curve = _simple(drawn, [row for column in triangle.columns for row in column])
    if curve is None:
        return None
    task = (*_given_curve(curve), ". Find its point at ", Math("t", (t,)), " by de Boor's algorithm.")
    return task, Numbers(("x", "y"), curve(t)), ("De Boor's triangle: ", de_boor_triangle(curve, t))


@_topic(
    "The derivative has the degree one lower, and its control points are the differences of neighbours times "
    "the degree, divided by the difference of the knots; then de Boor's triangle."
)
def _derivative(rng: Random) -> Drawn:
    """The derivative of a curve at a parameter."""
    drawn = _curve(rng, rng.choice((2, 3)))
    t = rng.choice((_inner(rng, drawn), *drawn.domain))
    hodograph = Nurbs.from_splines([f.d() for f in drawn.p])
    made = [*hodograph.control_points, *[row for c in de_boor_triangle(hodograph, t).columns for row in c]]
    curve = _simple(drawn, made)
    if curve is None:
        return None
    hodograph = Nurbs.from_splines([f.d() for f in curve.p])
    task = (*_given_curve(curve), ". Find its derivative at ", Math("t", (t,)), ".")
    words = (
        f"The derivative has the degree {hodograph.degree}, the knots % and the control points %. De Boor's triangle: "
    )
    solution = (*sentence(words, _knots_of(hodograph), _points_of(hodograph)), de_boor_triangle(hodograph, t))
    return task, Numbers(("x′", "y′"), curve.derivative(1, t)), solution


@_topic(
    "The control points far from t stay. Each new one lies between two old neighbours: it is the first step of "
    "de Boor's triangle at t."
)
def _insertion(rng: Random) -> Drawn:
    """The control points after a knot is inserted."""
    drawn = _curve(rng, rng.choice((2, 3)))
    t = _inner(rng, drawn)
    curve = _simple(drawn, insertion_triangle(drawn, t).made)
    if curve is None:
        return None
    triangle = insertion_triangle(curve, t)
    finer = Nurbs(curve.degree, triangle.knots or (), triangle.made)
    task = (*_given_curve(curve), ". Insert the knot ", Math("t", (t,)), ". What are all control points of the result?")
    return task, Points(finer), ("Over the knots ", _knots_of(finer), " by Boehm's algorithm: ", triangle)


@_topic(
    "The ends stay. From degree n to n + 1 the new point i is i/(n + 1) times the old point i − 1 plus 1 − "
    "i/(n + 1) times the old point i."
)
def _elevation(rng: Random) -> Drawn:
    """The Bézier points after the degree is raised."""
    drawn = _bezier_curve(_drawn_points(rng, rng.choice((1, 2, 3)) + 1))
    curve = _simple(drawn, elevation_triangles(drawn)[0].columns[-1])
    if curve is None:
        return None
    task = sentence(
        f"A Bézier curve of degree {curve.degree} has the control points %. Write it as a Bézier curve of degree "
        f"{curve.degree + 1}: what are its control points?",
        _points_of(curve),
    )
    (triangle,) = elevation_triangles(curve)
    return task, Points(curve.elevate_degree()), ("Neighbours are combined: ", triangle)


@_topic("De Casteljau's triangle at t: the first points of its columns.")
def _subdivision(rng: Random) -> Drawn:
    """The Bézier points of the first part of a subdivided curve."""
    drawn = _bezier_curve(_drawn_points(rng, rng.choice((2, 3)) + 1))
    t = _inner(rng, drawn)
    curve = _simple(drawn, [row for c in de_boor_triangle(drawn, t).columns for row in c])
    if curve is None:
        return None
    first, _ = curve.split(t)
    asked = sentence(". It is cut at %. What are the control points of its first part?", Math("t", (t,)))
    return (
        (*_given_bezier(curve), *asked),
        Points(first),
        ("The upper edge of de Casteljau's triangle: ", de_boor_triangle(curve, t)),
    )


@_topic(
    "Multiply the points by binomial coefficients, multiply the two lists as polynomials, and divide by the "
    "binomial coefficients of the sum of the degrees."
)
def _product(rng: Random) -> Drawn:
    """The Bézier points of the product of two functions."""
    f, g = (BSpline.bezier([x for (x,) in _drawn_points(rng, n + 1, 1)]) for n in rng.choice(((1, 1), (1, 2), (2, 2))))
    points = _cleared([(x,) for x in f.control_points], [(x,) for x in (f * g).control_points])
    if points is None or g.is_zero or any(x == y for x, y in pairwise(g.control_points)):
        return None
    f = BSpline.bezier([x for (x,) in points])
    task = sentence(
        f"The function f has the degree {f.degree} and the Bézier points %, the function g the degree {g.degree} and "
        "the Bézier points %. Find the Bézier points of the product fg.",
        *map(_points_of, (f, g)),
    )
    (table,) = product_tables(f, g)
    solution = sentence(
        "The points times binomial coefficients are % and %; the sums of the diagonals of their table are %, which are "
        f"divided by the binomial coefficients of degree {f.degree + g.degree}.",
        *(Math("", numbers) for numbers in (table.left, table.right, table.sums)),
    )
    return task, Points(f * g), solution


def _coefficients(f: BSpline) -> tuple[mpq, ...]:
    """The coefficients of the powers of t, from the derivatives at 0, without trailing zeros."""
    coefficients, factorial, g = [], 1, f
    for k in range(f.degree + 1):
        factorial *= max(k, 1)
        coefficients.append(g(0) / factorial)
        g = g.d()
    while coefficients and not coefficients[-1]:
        coefficients.pop()
    return tuple(coefficients)


@_topic(
    "The constant term is the first point; the next coefficient is the degree times the first difference; the "
    "coefficient of t² takes the second difference and the binomial coefficient."
)
def _power(rng: Random) -> Drawn:
    """Conversion from Bézier points to powers of t."""
    curve = _bezier_curve(_drawn_points(rng, rng.choice((2, 3)) + 1))
    made = tuple(_coefficients(f) for f in curve.p)
    if not all(_small(c) and len(c) > 1 for c in made):
        return None
    task = (*_given_bezier(curve), ". Write x(t) and y(t) in powers of t.")
    columns = list(zip(*curve.control_points, strict=True))
    solution = tuple(
        part
        for name, column, c in zip(("x", "y"), columns, made, strict=True)
        for part in ("From ", Math("", column), f" comes {name}(t) = ", Math("", (Polynomial(c),)), ". ")
    )
    return task, Polynomials(("x(t)", "y(t)"), tuple(map(Polynomial, made))), solution


@_topic(
    "Divide the coefficient of t to the power k by the binomial coefficient: these are the differences of "
    "order k at the first point."
)
def _bezier(rng: Random) -> Drawn:
    """Conversion from powers of t to Bézier points."""
    curve = _bezier_curve(_drawn_points(rng, rng.choice((2, 3)) + 1))
    made = tuple(_coefficients(f) for f in curve.p)
    if not all(_small(c) and len(c) > 1 for c in made) or max(map(len, made)) != curve.degree + 1:
        return None
    words = f"A curve is given by % and %. Find its Bézier points of degree {curve.degree} over [0, 1]."
    task = sentence(words, *(Math(name, (Polynomial(c),)) for name, c in zip(("x(t)", "y(t)"), made, strict=True)))
    solution = sentence(
        "The coefficient of t to the power k, divided by the binomial coefficient, is the k-th difference of the "
        "Bézier points, which are therefore %.",
        _points_of(curve),
    )
    return task, Points(curve), solution


@_topic("Compare the values of both sides, then the first derivatives, and so on, until two differ.")
def _continuity(rng: Random) -> Drawn:
    """The smoothness of a function at a knot."""
    degree = rng.choice((2, 3))
    smooth, multiplicity = rng.randint(0, degree + 1), rng.randint(1, degree + 1)
    multiplicity = max(smooth, multiplicity)
    knots = [0] * (degree + 1) + [1] * smooth + [2] * (degree + 1)
    f = BSpline(degree, knots, [x for (x,) in _drawn_points(rng, len(knots) - degree - 1, 1)])
    f = f.insert_knot(1, multiplicity - smooth) if multiplicity > smooth else f
    factor = max(int(x.denominator) for x in f.control_points)
    if factor > 4 or f.true_degree < degree:
        return None
    f = f.scaled(factor)
    if not _small(f.control_points):
        return None
    asked = sentence(
        ". How many times is it continuously differentiable at %? (−1 if it jumps, "
        f"{degree} if it is the same polynomial on both sides.)",
        Math("t", (mpq(1),)),
    )
    order = f.continuity_at(1)
    solution: list[str] = []
    for k in range(min(order + 1, degree) + 1):
        g = f.d(k)
        sides = f"{text(g(1, 'left'))} from the left and {text(g(1))} from the right"
        solution.append(f"{'The value' if not k else f'The derivative of order {k}'} is {sides}. ")
    return (*_given_curve(f, "function"), *asked), Numbers(("the order",), (mpq(order),)), tuple(solution)


# ---- shapes


def _function(rng: Random) -> BSpline:
    """A function of degree 2 or 3 over simple and double integer knots."""
    degree, breaks = rng.choice((2, 3)), [0]
    for _ in range(rng.randint(3, 5)):
        breaks.append(breaks[-1] + rng.randint(1, 2))
    inner = [t for t in breaks[1:-1] for _ in range(rng.choice((1, 1, 2)))]
    knots = [0] * (degree + 1) + inner + [breaks[-1]] * (degree + 1)
    return BSpline(degree, knots, [x for (x,) in _drawn_points(rng, len(knots) - degree - 1, 1, 9)])


@_topic("The basis function of control point i begins at knot i and ends degree + 1 knots later.")
def _support(rng: Random) -> Drawn:
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
        _knots_of(f),
    )
    solution = (
        f"The basis function number {i} begins at the knot number {i} and ends at the knot number {i} + "
        f"{f.degree} + 1, knots counted from 0: [{text(low)}, {text(high)}].",
    )
    return task, Numbers(("the left end", "the right end"), (low, high)), solution


@_topic("Which control points have influence on this interval? There are degree + 1 of them.")
def _hull(rng: Random) -> Drawn:
    """The bounds that control points imply for a function."""
    f = _function(rng)
    k = rng.randrange(len(f.breakpoints) - 1)
    a, b = f.breakpoints[k : k + 2]
    active = [x for (x,) in de_boor_triangle(f, (a + b) / 2).columns[0]]
    if len(set(active)) < len(active) or (min(f.control_points), max(f.control_points)) == (min(active), max(active)):
        return None
    task = (
        *_given_curve(f, "function"),
        f". Which bounds on [{text(a)}, {text(b)}] follow from its control points? Give the best lower and upper "
        "bound.",
    )
    influence = f"On this interval only {counted(len(active), 'control point')} have influence"
    solution = sentence(
        f"{influence}, %, and the value is a mean of them with positive weights.", Math("", tuple(active))
    )
    return task, Numbers(("the lower bound", "the upper bound"), (min(active), max(active))), solution


@_topic("Where does x′y″ − y′x″ change its sign? For a cubic it has at most the degree 2.")
def _inflections(rng: Random) -> Drawn:
    """The inflections of a cubic."""
    curve = _bezier_curve(_drawn_points(rng, 4, size=6))
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
        _points_of(curve),
    )
    values = tuple(Math(f"f({text(t)})", (bend(t),)) for t in parameters)
    reduced = bend.reduce_degree(bend.degree - bend.true_degree)
    words = (
        f"% has the true degree {reduced.degree} and the Bézier points %; its interior zeros at which it changes sign: "
    )
    solution = sentence(words + "% " * len(values), Math("f = x′y″ − y′x″"), _points_of(reduced), *values)
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
    first, *rest = _drawn_points(rng, degree)
    points = [first, tuple(x + d for x, d in zip(first, rng.choice(DIRECTIONS), strict=True)), *rest]
    return _bezier_curve(points[::-1] if at_end else points), mpq(at_end)


@_topic("κ = (x′y″ − y′x″)/(x′² + y′²)^(3/2); at an end the derivatives are differences of control points.")
def _curvature(rng: Random) -> Drawn:
    """The curvature at an end of a Bézier curve."""
    curve, t = _with_rational_speed(rng)
    value = values_along.curvature(curve, t).exact
    if not value or max(value.denominator, abs(value.numerator)) > LARGEST:
        return None
    task = (*_given_bezier(curve), ". Find its curvature at ", Math("t", (t,)), ", positive where it turns left.")
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


@_topic("The centre is the point plus (x′² + y′²)/(x′y″ − y′x″) times (−y′, x′).")
def _osculating(rng: Random) -> Drawn:
    """The osculating circle at a point, a point of the evolute."""
    curve = _bezier_curve(_drawn_points(rng, rng.choice((2, 3)) + 1))
    t = mpq(rng.choice((0, 1)))
    centre = _centre(curve, t) if any(curve.derivative(1, t)) else None
    if centre is None or not _small(centre):
        return None
    square = sum(((a - b) ** 2 for a, b in zip(centre, curve(t), strict=True)), mpq(0))
    words = ". Find the osculating circle at %: the coordinates of its centre and the square of its radius."
    task = (*_given_bezier(curve), *sentence(words, Math("t", (t,))))
    first, second = (Vector(*curve.derivative(k, t)) for k in (1, 2))
    length, area, normal = norm2(first), det(first, second), tuple(perp(first))
    solution = sentence(
        "The derivatives are % and %. The first one has the squared length % and is %, turned to the left; the "
        "determinant of both is %. The centre is % + %/% · % = %, a point of the evolute.",
        *(Math("", (x,)) for x in (tuple(first), tuple(second), length, normal, area)),
        *(Math("", (x,)) for x in (curve(t), length, area, normal, centre)),
    )
    return task, Numbers(("centre x", "centre y", "radius²"), (*centre, square)), solution


@_topic(
    "Three points decide which circle it can be: take the ends and the middle. Then every coefficient of the "
    "equation must vanish."
)
def _circle(rng: Random) -> Drawn:
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
        _points_of(curve),
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


@_topic("Put t into the quotient and multiply by the denominator: the equation for w is linear.")
def _weight(rng: Random) -> Drawn:
    """The weight for which a conic passes through a point."""
    w = mpq(rng.choice((1, 2, 3, 4)), rng.choice((1, 1, 2, 3)))
    points = _drawn_points(rng, 3)
    knots = [0, 0, 0, 1, 1, 1]
    first = _cleared(points, [Nurbs(2, knots, points, [1, w, 1])("1/2")])
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
        *(_points_of(curve), Math("t", (mpq(1, 2),)), Math("", (place,))),
    )
    s = place[0]
    # s (1 + w) = (a + b)/2 + w m
    weight_value = ((a + b) / 2 - s) / (s - m)
    words = "At t = 1/2 the curve has x = %, where (% + 2w·% + %) / (2 + 2w) has to be; so %."
    solution = sentence(words, *(Math("", (x,)) for x in (s, a, m, b)), Math("w", (weight_value,)))
    return task, Numbers(("w",), (weight_value,)), solution


#: The maximal number of draws for one exercise; a topic that needs a hundredth of it is already slow.
MOST_DRAWS = 100_000


class TopicError(ExactSplineError):
    """An unknown topic or an invalid seed."""


def about(topic: str) -> str:
    """A short description of a topic."""
    return str(TOPICS[topic].__doc__).rstrip(".")


def exercise(topic: str, seed: int) -> Exercise:
    """Return the exercise of a topic for a seed, which is an integer ≥ 0.

    >>> made = exercise("evaluation", 1)
    >>> made == exercise("evaluation", 1), bool(made.answer.check(made.answer.written))
    (True, True)

    Raises `TopicError` for an unknown topic, with the nearest known ones, and for an invalid seed.
    """
    if as_text(topic, "a topic") not in TOPICS:
        raise TopicError(
            f"there is no topic called {topic!r}", remedy=nearest(topic, TOPICS, listed_by="teach exercise")
        )
    if type(seed) is not int or seed < 0:
        raise TopicError(f"{shown(seed)} is not a seed", where="seed", remedy="an integer ≥ 0")
    rng = Random(f"{topic} {seed}")
    for _ in range(MOST_DRAWS):
        if drawn := TOPICS[topic](rng):
            return Exercise(topic, seed, *drawn)
    raise AssertionError(f"{topic} {seed}: no draw had simple numbers")


def exercises(topic: str, seed: int, count: int) -> list[Exercise]:
    """The given number of exercises, with consecutive seeds beginning at `seed`.

    >>> [each.seed for each in exercises("elevation", 3, 2)]
    [3, 4]
    """
    return [exercise(topic, seed + i) for i in range(count)]
