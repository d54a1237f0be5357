"""Shared by the adapters: the curve as it is passed to a library, and the interface to a library."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any, SupportsFloat

from workshop.grade.data import GivenData, Rows, WithKnots


@dataclass
class Given:
    """A curve of doubles, Cartesian control points, and the parameter that a question is about.

    `finer` is the same curve with that parameter as an additional knot, for the question that removes it; `partner` and
    `point` are for questions about two curves, and about a curve and a point.
    """

    degree: int
    knots: list[float]
    points: Rows
    weights: list[float] | None
    t: float
    finer: Given | None = None
    partner: Given | None = None
    point: list[float] = field(default_factory=list)

    @classmethod
    def of(cls, data: GivenData) -> Given:
        """From JSON data."""
        finer, partner = data.get("finer"), data.get("partner")
        fields = data["degree"], data["knots"], data["points"], data["weights"], data["t"]
        made = {name: cls.of(each) if each else None for name, each in (("finer", finer), ("partner", partner))}
        return cls(*fields, finer=made["finer"], partner=made["partner"], point=data.get("point", []))

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.points[0])

    @property
    def is_bezier(self) -> bool:
        """Whether it is one segment on [0, 1]."""
        n = self.degree + 1
        return self.knots == [0] * n + [1] * n

    @property
    def homogeneous(self) -> Rows:
        """``(w x, …, w)``, rounded once."""
        weights = self.weights or [1] * len(self.points)
        return [[*(x * w for x in p), w] for p, w in zip(self.points, weights, strict=True)]

    @property
    def distinct(self) -> tuple[list[float], list[int]]:
        """The distinct knots and their multiplicities."""
        values = sorted(set(self.knots))
        return values, [self.knots.count(v) for v in values]


class DeclinedError(Exception):
    """A library reports that it has no answer."""


class Adapter:
    """A library: a question is a method that returns numbers, rows of control points, or a list of parameters for every
    form in question.
    """

    name = ""
    #: The installed package, where it has another name.
    package = ""

    def pair(self, given: Given, make: Callable[[Given], Any]) -> tuple[Any, Any]:
        """The curve and its partner as objects of the library."""
        assert given.partner is not None
        return make(given), make(given.partner)

    def can(self, question: str, given: Given) -> bool:
        """Whether the library claims to answer this."""
        return hasattr(self, question)

    def version(self) -> str:
        """The installed version."""
        from importlib.metadata import version

        return version(self.package or self.name)

    def ask(self, question: str, given: Given) -> object:
        """The library's answer."""
        answer: Callable[[Given], object] = getattr(self, question)
        return answer(given)


class IncreasingDegree(Adapter):
    """A library whose curves have the method ``IncreaseDegree``."""

    def _curve(self, given: Given) -> Any:
        """The curve as an object of the library."""
        raise NotImplementedError

    def _rows(self, curve: Any, given: Given) -> Rows:
        """The control points of such an object."""
        raise NotImplementedError

    def elevate(self, given: Given) -> Rows:
        """``curve.IncreaseDegree(degree + 1)``."""
        curve = self._curve(given)
        curve.IncreaseDegree(given.degree + 1)
        return self._rows(curve, given)


def floats(values: Iterable[SupportsFloat]) -> list[float]:
    """Numbers of a library as Python's."""
    return [float(x) for x in values]


def rows(values: Iterable[Iterable[SupportsFloat]]) -> Rows:
    """Rows of numbers of a library as Python's."""
    return [floats(row) for row in values]


def with_knots(points: Rows, knots: Iterable[SupportsFloat]) -> WithKnots:
    """Control points and the knots that the library chose for them."""
    return {"rows": points, "knots": floats(knots)}


def with_weights(points: Iterable[Iterable[SupportsFloat]], weights: Iterable[SupportsFloat] | None) -> Rows:
    """Control points, for a rational curve with the weights divided by the first one."""
    if weights is None:
        return rows(points)
    ws = floats(weights)
    return [[*floats(p), w / ws[0]] for p, w in zip(points, ws, strict=True)]
