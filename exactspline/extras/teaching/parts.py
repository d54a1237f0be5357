"""The parts of the text of an exercise: prose and formulas, printed as text, LaTeX or HTML by `exactspline.display`."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

from exactspline.extras.teaching.triangles import Triangle
from exactspline.numbers.exact import mpq
from exactspline.one_line import OneLine

Point: TypeAlias = tuple[mpq, ...]


@dataclass(frozen=True, repr=False)
class Polynomial(OneLine):
    """A polynomial in t, given by its coefficients, the constant term first."""

    coefficients: tuple[mpq, ...]


#: A number, a point, or a polynomial.
Value: TypeAlias = mpq | Point | Polynomial


@dataclass(frozen=True, repr=False)
class Math(OneLine):
    """``name = value``, or a list of values separated by commas; without values only the name, without a name only the
    values. The part of a name after an underscore is its index.
    """

    name: str = ""
    values: tuple[Value, ...] = ()


#: A sequence of prose and formulas.
Part: TypeAlias = str | Math | Triangle


def sentence(words: str, *parts: Math) -> tuple[str | Math, ...]:
    """Prose and formulas in turn: each ``%`` of the prose stands for the next formula.

    >>> sentence("% has the end %.", Math("t"), Math("b"))
    (<Math t>, ' has the end ', <Math b>, '.')
    """
    first, *others = words.split("%")
    rest: Iterable[str | Math] = chain.from_iterable(zip(parts, others, strict=True))
    return tuple(part for part in (first, *rest) if part)
