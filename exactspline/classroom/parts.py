"""What an exercise is written in: prose and formulas, printed as text, LaTeX or HTML by `exactspline.display`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from exactspline.classroom.triangles import Triangle
from exactspline.numbers.exact import mpq

Point: TypeAlias = tuple[mpq, ...]


@dataclass(frozen=True)
class Polynomial:
    """A polynomial in t by its coefficients, the constant one first."""

    coefficients: tuple[mpq, ...]


#: A number, a point, or a polynomial.
Value: TypeAlias = mpq | Point | Polynomial


@dataclass(frozen=True)
class Math:
    """``name = value``, or the values in a row with commas between them; without values the name alone, without a name
    the values alone. The part of a name after an underscore is its index.
    """

    name: str = ""
    values: tuple[Value, ...] = ()


#: What is said in a row.
Part: TypeAlias = str | Math | Triangle
