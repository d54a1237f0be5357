"""The JSON exchanged between the grader, the processes of the libraries and the file of exact answers."""

from __future__ import annotations

from typing import NotRequired, TypedDict

#: Control points, one row each.
Rows = list[list[float]]


class GivenData(TypedDict):
    """A curve as it is passed to a library; `finer` is the curve from which a knot is to be removed, `partner` and
    `point` are for questions about two curves, or a curve and a point.
    """

    degree: int
    knots: list[float]
    points: Rows
    weights: list[float] | None
    t: float
    finer: NotRequired[GivenData | None]
    partner: NotRequired[GivenData]
    point: NotRequired[list[float]]


class Request(TypedDict):
    """A request to a library's process."""

    given: GivenData
    questions: list[str]


class Reply(TypedDict, total=False):
    """The reply to a question: an answer of any kind, a refusal, an exception, or that none came in time."""

    answer: object
    declined: str
    raised: str
    late: str


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
    """A curve as it is passed to the independent checker: exact text, homogeneous control points; those of
    the partner, which has the same knots.
    """

    rational: bool
    partner: list[list[str]]


class Answer(TypedDict, total=False):
    """An exact answer: intervals of numbers, curves, certificates of zero sets."""

    numbers: list[list[str]]
    curves: list[ExactCurve]
    certificates: list[dict[str, object]]
