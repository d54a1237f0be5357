"""One family of exceptions, each carrying its data.

Every message says what was wrong, where, and what would be right; programs read the same three from the attributes
``problem``, ``where`` and ``remedy``, and whatever else the error knows from ``data``.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import SequenceMatcher
from typing import Any


class ExactSplineError(ValueError):
    """Base of all errors that bad input can cause.

    >>> print(KnotError("knots decrease", where="knots[3]", remedy="sort them", knot="1/2"))
    knots[3]: knots decrease; sort them
    """

    def __init__(self, problem: str, *, where: str = "", remedy: str = "", **data: Any) -> None:
        self.problem, self.where, self.remedy, self.data = problem, where, remedy, data
        super().__init__((f"{where}: " if where else "") + problem + (f"; {remedy}" if remedy else ""))

    def at(self, place: str) -> ExactSplineError:
        """The same error, its place prefixed: used where an outer room knows the file or the field.

        >>> print(NumberError("not a number", where="[2]").at("weights"))
        weights[2]: not a number
        """
        where = place + self.where if self.where.startswith("[") or not self.where else f"{place}: {self.where}"
        return type(self)(self.problem, where=where, remedy=self.remedy, **self.data)


def shown(value: object, limit: int = 40) -> str:
    """A value as an error message shows it: short, and never a failure of its own (integers of thousands of digits
    refuse to be printed).

    >>> shown("one"), shown(10**5000)
    ("'one'", 'an int too long to print')
    """
    try:
        text = repr(value)
    except ValueError:
        return (
            f"an {type(value).__name__} too long to print"
            if type(value) is int
            else f"a {type(value).__name__} too long to print"
        )
    return text if len(text) <= limit else f"{text[:limit]}…"


def nearest(name: str, known: Iterable[str], *, listed_by: str = "") -> str:
    """What would be right instead of a name that nobody knows: the three nearest that there are, and what lists all.

    >>> nearest("evolut", ["evolute", "torsion", "focal_curve", "f2"])
    'the nearest are evolute, torsion, focal_curve'
    >>> nearest("C9", ["C8"], listed_by="exactspline show")
    'the nearest is C8; `exactspline show` lists all'
    """

    def likeness(other: str) -> float:
        a, b = name.lower(), other.lower()
        # who mistypes a name mostly gets its first letter right
        return 5 * SequenceMatcher(None, a, b).ratio() + (a[:1] == b[:1])

    near = sorted(known, key=likeness, reverse=True)[:3]
    told = f"the nearest {'is' if len(near) == 1 else 'are'} {', '.join(near)}" if near else "there are none"
    return told + (f"; `{listed_by}` lists all" if listed_by else "")


class NumberError(ExactSplineError):
    """A value that is not an exact rational number."""


class KnotError(ExactSplineError):
    """Knots that decrease, are too many at one place, or leave an empty domain."""


class ShapeError(ExactSplineError):
    """Wrong counts or dimensions of control points, weights or vectors."""


class DomainError(ExactSplineError):
    """A parameter outside the domain, or two operands over different domains."""


class ReductionError(ExactSplineError):
    """A degree, a knot or a composition that cannot be reduced or formed exactly."""


class WeightError(ExactSplineError):
    """A denominator with a zero on the domain; ``data['witness']`` is the parameter or an interval around it."""


class FormulaError(ExactSplineError):
    """An operation that formulas must not use, or a formula that does not fit its operands."""


class InapplicableError(FormulaError):
    """A reading that says nothing of arguments of a kind."""


class ClaimError(ExactSplineError):
    """A claim file that cannot be read, or a claim id that does not exist."""


class CurveFileError(ExactSplineError):
    """A curve file that is missing, too large, not JSON, or lacks a field."""
