"""Exercises, each with task, answer and solution; and how topics generate exercises from a seed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random

from exactspline.extras.teaching.answers import Answer
from exactspline.extras.teaching.parts import Math, Part, Point
from exactspline.numbers.exact import mpq, over_one_denominator
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


def points_of(curve: Nurbs | BSpline) -> Math:
    """The list of control points."""
    if isinstance(curve, BSpline):
        return Math("", curve.control_points)
    return Math("", tuple(tuple(point) for point in curve.control_points))


def knots_of(curve: Nurbs | BSpline) -> Math:
    """The list of knots."""
    return Math("", curve.knots.knots)


def given_curve(curve: Nurbs | BSpline, what: str = "curve") -> tuple[Part, ...]:
    """The beginning of a task: a curve or a function with its knots and control points."""
    begin = f"A B-spline {what} of degree {curve.degree} has the knots "
    return (begin, knots_of(curve), " and the control points ", points_of(curve))


def given_bezier(curve: Nurbs) -> tuple[Part, ...]:
    """The beginning of a task: a Bézier curve with its control points."""
    return (f"A Bézier curve of degree {curve.degree} over [0, 1] has the control points ", points_of(curve))


def bezier_curve(points: Sequence[Point]) -> Nurbs:
    """The Bézier curve over [0, 1] with these control points."""
    degree = len(points) - 1
    return Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), points)


def drawn_points(rng: Random, many: int, dimension: int = 2, size: int = 4) -> list[Point]:
    """Points with small integer coordinates."""
    return [tuple(mpq(rng.randint(-size, size)) for _ in range(dimension)) for _ in range(many)]


def cleared(points: Sequence[Point], made: Iterable[Point]) -> list[Point] | None:
    """The points times the least integer for which the points `made` from them (linearly) have integer coordinates;
    None if they become large, or if neighbours coincide.
    """
    numbers = [x for row in made for x in row]
    _, factor = over_one_denominator(numbers)
    largest = max(abs(x) for x in [*numbers, *[x for row in points for x in row]])
    if factor * largest > LARGEST or any(a == b for a, b in pairwise(points)):
        return None
    return [tuple(factor * x for x in row) for row in points]


def small(values: Iterable[mpq]) -> bool:
    """Whether all are integers of about two digits."""
    return all(x.denominator == 1 and abs(x) <= LARGEST for x in values)
