"""The parts of the text of an exercise: prose and formulas, printed as text, LaTeX or HTML by `exactspline.display`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from exactspline.extras.teaching.triangles import Triangle
from exactspline.numbers.exact import mpq

Point: TypeAlias = tuple[mpq, ...]


@dataclass(frozen=True)
class Polynomial:
    """A polynomial in t, given by its coefficients, the constant term first."""

    coefficients: tuple[mpq, ...]


#: A number, a point, or a polynomial.
Value: TypeAlias = mpq | Point | Polynomial


@dataclass(frozen=True)
class Math:
    """``name = value``, or a list of values separated by commas; without values only the name, without a name only the
    values. The part of a name after an underscore is its index.
    """

    name: str = ""
    values: tuple[Value, ...] = ()


#: A sequence of prose and formulas.
Part: TypeAlias = str | Math | Triangle
