"""The topics and their exercises: the same seed yields the same exercise on every platform."""

from __future__ import annotations

from random import Random

from exactspline.errors import ExactSplineError, as_text, nearest, shown
from exactspline.extras.teaching import algorithms, shapes
from exactspline.extras.teaching.exercises import Exercise, Topic

TOPICS: dict[str, Topic] = {
    "evaluation": algorithms.evaluation,
    "derivative": algorithms.derivative,
    "insertion": algorithms.insertion,
    "elevation": algorithms.elevation,
    "subdivision": algorithms.subdivision,
    "product": algorithms.product,
    "power": algorithms.power,
    "bezier": algorithms.bezier,
    "continuity": algorithms.continuity,
    "support": shapes.support,
    "hull": shapes.hull,
    "inflections": shapes.inflections,
    "curvature": shapes.curvature,
    "osculating": shapes.osculating,
    "circle": shapes.circle,
    "weight": shapes.weight,
}
#: How to begin, without a number of the answer.
HINTS = {
    "evaluation": "The control points of the segment that contains t begin the triangle. In step k neighbours "
    "are combined with the weights (b − t)/(b − a) and (t − a)/(b − a), where [a, b] consists of degree + 1 − k "
    "intervals between neighbouring knots.",
    "derivative": "The derivative has the degree one lower, and its control points are the differences of neighbours "
    "times the degree, divided by the difference of the knots; then de Boor's triangle.",
    "insertion": "The control points far from t stay. Each new one lies between two old neighbours: it is the first "
    "step of de Boor's triangle at t.",
    "elevation": "The ends stay. From degree n to n + 1 the new point i is i/(n + 1) times the old point i − 1 plus "
    "1 − i/(n + 1) times the old point i.",
    "subdivision": "De Casteljau's triangle at t: the first points of its columns.",
    "product": "Multiply the points by binomial coefficients, multiply the two lists as polynomials, and divide by the "
    "binomial coefficients of the sum of the degrees.",
    "power": "The constant term is the first point; the next coefficient is the degree times the first difference; "
    "the coefficient of t² takes the second difference and the binomial coefficient.",
    "bezier": "Divide the coefficient of t to the power k by the binomial coefficient: these are the differences of "
    "order k at the first point.",
    "continuity": "Compare the values of both sides, then the first derivatives, and so on, until two differ.",
    "support": "The basis function of control point i begins at knot i and ends degree + 1 knots later.",
    "hull": "Which control points have influence on this interval? There are degree + 1 of them.",
    "inflections": "Where does x′y″ − y′x″ change its sign? For a cubic it has at most the degree 2.",
    "curvature": "κ = (x′y″ − y′x″)/(x′² + y′²)^(3/2); at an end the derivatives are differences of control points.",
    "osculating": "The centre is the point plus (x′² + y′²)/(x′y″ − y′x″) times (−y′, x′).",
    "circle": "Three points decide which circle it can be: take the ends and the middle. Then every coefficient of "
    "the equation must vanish.",
    "weight": "Put t into the quotient and multiply by the denominator: the equation for w is linear.",
}
#: The maximal number of draws for one exercise; a topic that needs a hundredth of it is already slow.
MOST_DRAWS = 100_000


class TopicError(ExactSplineError):
    """An unknown topic or an invalid seed."""


def about(topic: str) -> str:
    """A short description of a topic."""
    return str(TOPICS[topic].__doc__).rstrip(".")


def exercise(topic: str, seed: int) -> Exercise:
    """The exercise of a topic for a seed, which is an integer ≥ 0.

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
