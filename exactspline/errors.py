"""One family of exceptions, each carrying its data.

Every message says what was wrong, where, and what would be right; programs find these three in the attributes
``problem``, ``where`` and ``remedy``, and any further details from ``data``.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable
from contextlib import suppress
from enum import StrEnum
from functools import lru_cache
from operator import index
from os import PathLike
from typing import SupportsIndex, TypeVar

T = TypeVar("T")


class ExactSplineError(ValueError):
    """The base class of all errors that bad input can cause.

    >>> print(KnotError("knots decrease", where="knots[3]", remedy="sort them", knot="1/2"))
    knots[3]: knots decrease; sort them
    """

    def __init__(self, problem: str, *, where: str = "", remedy: str = "", **data: object) -> None:
        self.problem, self.where, self.remedy, self.data = problem, where, remedy, data
        message = problem if isinstance(problem, str) else shown(problem)
        super().__init__((f"{where}: " if where else "") + message + (f"; {remedy}" if remedy else ""))

    def at(self, place: str) -> ExactSplineError:
        """Return the same error with a place (a file or a field that only the caller knows) before its own place.

        >>> print(NumberError("not a number", where="[2]").at("weights"))
        weights[2]: not a number
        """
        where = place + self.where if self.where.startswith("[") or not self.where else f"{place}: {self.where}"
        return type(self)(self.problem, where=where, remedy=self.remedy, **self.data)

    def moved(self, old: str, new: str) -> ExactSplineError:
        """Return the same error with another name for its place: the row or the argument, which only the caller knows.

        >>> print(NumberError("not a number", where="knots[2]").moved("knots", "knots_u"))
        knots_u[2]: not a number
        """
        return type(self)(self.problem, where=self.where.replace(old, new, 1), remedy=self.remedy, **self.data)


def shown(value: object, limit: int = 40) -> str:
    """A value as an error message shows it: short, and never itself an error (Python refuses to print integers of
    thousands of digits).

    >>> shown("one"), shown(10**5000)
    ("'one'", 'an int too long to print')
    """
    try:
        text = repr(str(value) if isinstance(value, StrEnum) else value).replace("\n", " ")
    except (ValueError, RecursionError):
        return f"{a_kind(value)} too long to print"
    return text if len(text) <= limit else f"{text[:limit]}…"


def written(value: object) -> str:
    """A value as text; if Python refuses to print the value, a description of it.

    >>> written("one"), written(10**5000)
    ('one', 'an int too long to print')
    """
    try:
        return str(value)
    except (ValueError, RecursionError):
        return shown(value)


def counted(n: int, what: str) -> str:
    """A number with the noun that it counts, such as `2 errors`.

    >>> counted(1, "error"), counted(2, "error"), counted(3, "stretch"), counted(0, "entry")
    ('1 error', '2 errors', '3 stretches', '0 entries')
    """
    if n != 1:
        ends = (("ch", "ches"), ("s", "ses"), ("x", "xes"), ("ry", "ries"), ("ty", "ties"))
        one, many = next(((one, many) for one, many in ends if what.endswith(one)), ("", "s"))
        what = what.removesuffix(one) + many
    return f"{written(n)} {what}"


def command_name() -> str:
    """The name of the command: ``exactspline``, or the name given by the script that called it (``./run``)."""
    return os.environ.get("EXACTSPLINE_COMMAND") or "exactspline"


def nearest(name: str, known: Iterable[str], *, listed_by: str = "") -> str:
    """The remedy for an unknown name: the three nearest known names, and the command that lists all.

    >>> nearest("evolut", ["evolute", "torsion", "focal_curve", "f2"])
    'the nearest are evolute, torsion, focal_curve'
    >>> nearest("C9", ["C8"], listed_by="show")
    'the nearest is C8; `exactspline show` lists all'
    """

    if not isinstance(name, str):  # an object of any type may have been given as a name
        return "names are text" + (f"; `{command_name()} {listed_by}` lists all" if listed_by else "")
    near = _likest(name.lower(), list(dict.fromkeys(known)))
    hint = f"the nearest {'is' if len(near) == 1 else 'are'} {', '.join(near)}" if near else "there are none"
    return hint + (f"; `{command_name()} {listed_by}` lists all" if listed_by else "")


def _likest(name: str, known: list[str]) -> list[str]:
    """The three names most like a name, the most similar first. A mistyped name mostly has the right first letter.
    The similarity of two names is bounded by the letters that they share, which is cheap to count: only names whose
    bound is not below the best found are compared.
    """
    from difflib import SequenceMatcher

    own, found = _letters(name), list[tuple[float, int]]()
    for bound, i in sorted((_bound(name, own, each.lower()), i) for i, each in enumerate(known)):
        if len(found) >= 3 and bound > sorted(found)[2][0]:
            break
        other = known[i].lower()
        found.append((-5 * SequenceMatcher(None, name, other).ratio() - (name[:1] == other[:1]), i))
    return [known[i] for _, i in sorted(found)[:3]]


def _bound(name: str, own: Counter[str], other: str) -> float:
    """A lower bound of the negated similarity of two names."""
    if not name and not other:
        return -6
    theirs = _letters(other)
    shared = sum(min(n, theirs[letter]) for letter, n in own.items())
    return -10 * shared / (len(name) + len(other)) - (name[:1] == other[:1])


@lru_cache(maxsize=4096)
def _letters(name: str) -> Counter[str]:
    return Counter(name)


class NumberError(ExactSplineError):
    """A value that is not an exact rational number."""


class OpenError(ExactSplineError):
    """A question about a real number that is not decided by the digits computed."""


class KnotError(ExactSplineError):
    """Knots that decrease, are too many at one place, or leave an empty domain."""


class ShapeError(ExactSplineError):
    """Wrong counts or dimensions of control points, weights or vectors."""


class DomainError(ExactSplineError):
    """A parameter outside the domain, or two operands over different domains."""


class ReductionError(ExactSplineError):
    """A degree that cannot be lowered, a knot that cannot be removed, a composition that cannot be formed exactly."""


class WeightError(ExactSplineError):
    """A denominator with a zero on the domain; ``data['witness']`` is the parameter or an interval around it."""


class FormulaError(ExactSplineError):
    """An operation that formulas must not use, or a formula that does not fit its operands."""


class InapplicableError(FormulaError):
    """A reading that does not apply to a kind of argument."""


class VanishingDivisorError(FormulaError):
    """A division by an expression that vanishes identically."""


class ClaimError(ExactSplineError):
    """A claim file that cannot be read, or a claim id that does not exist."""


class ReachError(ExactSplineError):
    """A computation whose cost is known beforehand to be beyond the bound for a call that cannot be interrupted;
    ``data['seconds']`` is the estimate.
    """


class CurveFileError(ExactSplineError):
    """A curve file that is missing, too large or not JSON, or lacks a field."""


# ---- the argument of a public function, or the error that says what it takes


def as_text(given: object, what: str) -> str:
    """The text itself; raises `ShapeError` for anything else.

    >>> as_text(3, "the name of a curve")
    Traceback (most recent call last):
    exactspline.errors.ShapeError: an int, where the name of a curve is expected; give a text
    """
    if isinstance(given, str):
        return given
    raise ShapeError(f"{a_kind(given)}, where {what} is expected", remedy="give a text")


def as_path(given: object) -> str:
    """The path of a file, given as text or as an object with a path; raises `ShapeError` for anything else."""
    path = given.__fspath__() if isinstance(given, PathLike) else given
    return as_text(path, "the path of a file")


def as_items(given: Iterable[T], what: str) -> Iterable[T]:
    """The sequence itself; raises `ShapeError` for a text and for anything that is not a sequence."""
    if not isinstance(given, str | bytes):
        with suppress(TypeError):  # an array without dimensions only seems to be a sequence
            iter(given)
            return given
    raise ShapeError(f"{a_kind(given)}, where {what} are expected", remedy="give a list")


def as_integer(given: SupportsIndex, what: str, least: int = 0, most: int = 10**6) -> int:
    """The integer, of Python or of another library; raises `ShapeError` for anything else, and for an integer below
    `least` or above `most`.

    >>> as_integer(1.5, "a dimension", 1)
    Traceback (most recent call last):
    exactspline.errors.ShapeError: 1.5, where a dimension is expected; give an integer from 1 to 1000000
    """
    with suppress(TypeError):
        if not isinstance(given, bool) and least <= index(given) <= most:
            return index(given)
    raise ShapeError(f"{shown(given)}, where {what} is expected", remedy=f"give an integer from {least} to {most}")


def as_flag(given: object, what: str) -> bool:
    """The choice itself; raises `ShapeError` for anything except True and False.

    >>> as_flag("no", "whether the ends are one knot")
    Traceback (most recent call last):
    exactspline.errors.ShapeError: 'no', where it is asked whether the ends are one knot; give True or False
    """
    if isinstance(given, bool):
        return given
    raise ShapeError(f"{shown(given)}, where it is asked {what}", remedy="give True or False")


def as_texts(given: Iterable[str], what: str, one: str) -> list[str]:
    """The texts of a sequence; raises `ShapeError` for anything else, and for a single text.

    >>> as_texts("f2", "names of formulas", "the name of a formula")
    Traceback (most recent call last):
    exactspline.errors.ShapeError: a str, where names of formulas are expected; give a list
    """
    return [as_text(each, one) for each in as_items(given, what)]


def as_instance(given: object, kind: type[T], what: str, remedy: str) -> T:
    """The object itself; raises `ShapeError` for an object of another class, and names its pieces if it has some.

    >>> as_instance("f2", list, "a list of formulas", "write [f2]")
    Traceback (most recent call last):
    exactspline.errors.ShapeError: a str, where a list of formulas is expected; write [f2]
    """
    if isinstance(given, kind):
        return given
    pieces = "; take the value of one of its pieces" if hasattr(given, "pieces") else ""
    raise ShapeError(f"{a_kind(given)}, where {what} is expected", remedy=remedy + pieces)


def a_kind(given: object) -> str:
    """The class of something, with its article.

    >>> a_kind(3), a_kind("3")
    ('an int', 'a str')
    """
    name = type(given).__name__
    return f"a{'n' * (name[:1] in 'aeiouAEIO')} {name}"
