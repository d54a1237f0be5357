"""The topics and their exercises: the same seed yields the same exercise on every platform."""

from __future__ import annotations

from random import Random

from exactspline.classroom import algorithms, shapes
from exactspline.classroom.exercises import Exercise, Topic
from exactspline.errors import ExactSplineError, as_text, nearest, shown

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
