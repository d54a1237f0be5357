"""What passes between the grader, the processes of the libraries and the file of exact answers, as JSON."""

from __future__ import annotations

from typing import NotRequired, TypedDict

#: Control points, a row each.
Rows = list[list[float]]


class GivenData(TypedDict):
    """A curve as a library is given it; `finer` is the curve from which a knot is to be removed."""

    degree: int
    knots: list[float]
    points: Rows
    weights: list[float] | None
    t: float
    finer: NotRequired[GivenData | None]


class Request(TypedDict):
    """What a library's process is asked."""

    given: GivenData
    questions: list[str]


class Reply(TypedDict, total=False):
    """What becomes of a question: an answer, of whatever kind the library has; that it declines; what it raises."""

    answer: object
    declined: str
    raised: str


class WithKnots(TypedDict):
    """Control points and the knots that the library chose for them."""

    rows: Rows
    knots: list[float]


class ExactCurve(TypedDict):
    """A curve as exact text, its control points as libraries have them."""

    degree: int
    knots: list[str]
    rows: list[list[str]]


class CurveData(ExactCurve):
    """A curve as the independent checker is given it: exact text, homogeneous control points."""

    rational: bool


class Answer(TypedDict, total=False):
    """An exact answer: intervals of numbers, curves, certificates of zero sets."""

    numbers: list[list[str]]
    curves: list[ExactCurve]
    certificates: list[dict[str, object]]
