"""Exercises, each with task, answer and solution; and how topics generate exercises from a seed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random

from exactspline.classroom.answers import Answer
from exactspline.classroom.parts import Math, Part, Point
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
