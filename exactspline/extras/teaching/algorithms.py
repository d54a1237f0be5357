"""Exercises on algorithms: de Boor, derivatives, knot insertion, degree elevation, products, power basis."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from random import Random

from exactspline.extras.teaching.answers import Numbers, Points, Polynomials
from exactspline.extras.teaching.exercises import (
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
from exactspline.extras.teaching.parts import Math, Polynomial, sentence
from exactspline.extras.teaching.triangles import (
    de_boor_triangle,
    elevation_triangles,
    insertion_triangle,
    product_tables,
)
from exactspline.numbers.exact import mpq, text
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


def _knots(rng: Random, degree: int) -> list[int]:
    """Clamped knots over [0, 2] or a longer interval, with at most two interior knots."""
    breaks = [0, *sorted(rng.sample(range(1, 5), rng.randint(0, 2)))]
    return [0] * degree + breaks + [breaks[-1] + rng.randint(1, 2)] * (degree + 1)


def _curve(rng: Random, degree: int) -> Nurbs:
    knots = _knots(rng, degree)
    return Nurbs(degree, knots, drawn_points(rng, len(knots) - degree - 1))


def _inner(rng: Random, curve: Nurbs | BSpline) -> mpq:
    """A parameter inside a segment: its midpoint or a third point."""
    i = rng.randrange(len(curve.breakpoints) - 1)
    a, b = curve.breakpoints[i : i + 2]
    return a + (b - a) * mpq(rng.choice((Fraction(1, 2), Fraction(1, 3), Fraction(2, 3), Fraction(1, 2))))


def evaluation(rng: Random) -> Drawn:
    """The point of a B-spline curve by de Boor's triangle."""
    curve = _curve(rng, rng.choice((2, 3)))
    t = _inner(rng, curve)
    triangle = de_boor_triangle(curve, t)
    points = cleared(curve.control_points, [row for column in triangle.columns for row in column])
    if points is None:
        return None
    curve = Nurbs(curve.degree, curve.knots, points)
    task = (*given_curve(curve), ". Find its point at ", Math("t", (t,)), " by de Boor's algorithm.")
    return task, Numbers(("x", "y"), curve(t)), ("De Boor's triangle: ", de_boor_triangle(curve, t))


def derivative(rng: Random) -> Drawn:
    """The derivative of a curve at a parameter."""
    curve = _curve(rng, rng.choice((2, 3)))
    t = rng.choice((_inner(rng, curve), *curve.domain))
    hodograph = Nurbs.from_splines([f.d() for f in curve.p])
    made = [*hodograph.control_points, *[row for c in de_boor_triangle(hodograph, t).columns for row in c]]
    points = cleared(curve.control_points, made)
    if points is None:
        return None
    curve = Nurbs(curve.degree, curve.knots, points)
    hodograph = Nurbs.from_splines([f.d() for f in curve.p])
    task = (*given_curve(curve), ". Find its derivative at ", Math("t", (t,)), ".")
    words = (
        f"The derivative has the degree {hodograph.degree}, the knots % and the control points %. De Boor's triangle: "
    )
    solution = (*sentence(words, knots_of(hodograph), points_of(hodograph)), de_boor_triangle(hodograph, t))
    return task, Numbers(("x′", "y′"), curve.derivative(1, t)), solution


def insertion(rng: Random) -> Drawn:
    """The control points after a knot is inserted."""
    curve = _curve(rng, rng.choice((2, 3)))
    t = _inner(rng, curve)
    points = cleared(curve.control_points, insertion_triangle(curve, t).made)
    if points is None:
        return None
    curve = Nurbs(curve.degree, curve.knots, points)
    triangle = insertion_triangle(curve, t)
    finer = Nurbs(curve.degree, triangle.knots or (), triangle.made)
    task = (*given_curve(curve), ". Insert the knot ", Math("t", (t,)), ". What are all control points of the result?")
    return task, Points(finer), ("Over the knots ", knots_of(finer), " by Boehm's algorithm: ", triangle)


def elevation(rng: Random) -> Drawn:
    """The Bézier points after the degree is raised."""
    curve = bezier_curve(drawn_points(rng, rng.choice((1, 2, 3)) + 1))
    points = cleared(curve.control_points, elevation_triangles(curve)[0].columns[-1])
    if points is None:
        return None
    curve = Nurbs(curve.degree, curve.knots, points)
    task = sentence(
        f"A Bézier curve of degree {curve.degree} has the control points %. Write it as a Bézier curve of degree "
        f"{curve.degree + 1}: what are its control points?",
        points_of(curve),
    )
    (triangle,) = elevation_triangles(curve)
    return task, Points(curve.elevate_degree()), ("Neighbours are combined: ", triangle)


def subdivision(rng: Random) -> Drawn:
    """The Bézier points of the first part of a subdivided curve."""
    curve = bezier_curve(drawn_points(rng, rng.choice((2, 3)) + 1))
    t = _inner(rng, curve)
    points = cleared(curve.control_points, [row for c in de_boor_triangle(curve, t).columns for row in c])
    if points is None:
        return None
    curve = Nurbs(curve.degree, curve.knots, points)
    first, _ = curve.split(t)
    asked = sentence(". It is cut at %. What are the control points of its first part?", Math("t", (t,)))
    return (
        (*given_bezier(curve), *asked),
        Points(first),
        ("The upper edge of de Casteljau's triangle: ", de_boor_triangle(curve, t)),
    )


def product(rng: Random) -> Drawn:
    """The Bézier points of the product of two functions."""
    f, g = (BSpline.bezier([x for (x,) in drawn_points(rng, n + 1, 1)]) for n in rng.choice(((1, 1), (1, 2), (2, 2))))
    points = cleared([(x,) for x in f.control_points], [(x,) for x in (f * g).control_points])
    if points is None or g.is_zero or any(x == y for x, y in pairwise(g.control_points)):
        return None
    f = BSpline.bezier([x for (x,) in points])
    task = sentence(
        f"The function f has the degree {f.degree} and the Bézier points %, the function g the degree {g.degree} and "
        "the Bézier points %. Find the Bézier points of the product fg.",
        *map(points_of, (f, g)),
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


def power(rng: Random) -> Drawn:
    """Conversion from Bézier points to powers of t."""
    curve = bezier_curve(drawn_points(rng, rng.choice((2, 3)) + 1))
    made = tuple(_coefficients(f) for f in curve.p)
    if not all(small(c) and len(c) > 1 for c in made):
        return None
    task = (*given_bezier(curve), ". Write x(t) and y(t) in powers of t.")
    columns = list(zip(*curve.control_points, strict=True))
    solution = tuple(
        part
        for name, column, c in zip(("x", "y"), columns, made, strict=True)
        for part in ("From ", Math("", column), f" comes {name}(t) = ", Math("", (Polynomial(c),)), ". ")
    )
    return task, Polynomials(("x(t)", "y(t)"), tuple(map(Polynomial, made))), solution


def bezier(rng: Random) -> Drawn:
    """Conversion from powers of t to Bézier points."""
    curve = bezier_curve(drawn_points(rng, rng.choice((2, 3)) + 1))
    made = tuple(_coefficients(f) for f in curve.p)
    if not all(small(c) and len(c) > 1 for c in made) or max(map(len, made)) != curve.degree + 1:
        return None
    words = f"A curve is given by % and %. Find its Bézier points of degree {curve.degree} over [0, 1]."
    task = sentence(words, *(Math(name, (Polynomial(c),)) for name, c in zip(("x(t)", "y(t)"), made, strict=True)))
    solution = sentence(
        "The coefficient of t to the power k, divided by the binomial coefficient, is the k-th difference of the "
        "Bézier points, which are therefore %.",
        points_of(curve),
    )
    return task, Points(curve), solution


def continuity(rng: Random) -> Drawn:
    """The smoothness of a function at a knot."""
    degree = rng.choice((2, 3))
    smooth, multiplicity = rng.randint(0, degree + 1), rng.randint(1, degree + 1)
    multiplicity = max(smooth, multiplicity)
    knots = [0] * (degree + 1) + [1] * smooth + [2] * (degree + 1)
    f = BSpline(degree, knots, [x for (x,) in drawn_points(rng, len(knots) - degree - 1, 1)])
    f = f.insert_knot(1, multiplicity - smooth) if multiplicity > smooth else f
    factor = max(int(x.denominator) for x in f.control_points)
    if factor > 4 or f.true_degree < degree:
        return None
    f = f.scaled(factor)
    if not small(f.control_points):
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
    return (*given_curve(f, "function"), *asked), Numbers(("the order",), (mpq(order),)), tuple(solution)
