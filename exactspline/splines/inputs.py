"""User input: degrees, sides and control points, read exactly or rejected with the place of the error."""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.errors import DomainError, NumberError, ShapeError, a_kind, shown
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Side
from exactspline.words import choice

#: The largest degree accepted as input; computed splines may have higher degrees.
MAX_DEGREE = 1000
#: The type of an exact number, which is not converted again.
RATIONAL = type(mpq())


def checked_degree(degree: object) -> int:
    """A degree as given by a user; raises `ShapeError` unless it is an int from 0 to `MAX_DEGREE`."""
    if isinstance(degree, Iterable) and not isinstance(degree, str):
        remedy = "write the degree, the knots, the control points (scipy has knots, coefficients, degree)"
        raise ShapeError(f"{a_kind(degree)}, where a degree is expected", where="degree", remedy=remedy)
    if type(degree) is not int or degree < 0:
        raise ShapeError(f"{shown(degree)} is not a degree", where="degree", remedy="an integer ≥ 0")
    if degree > MAX_DEGREE:
        raise ShapeError(f"degree {shown(degree)}", where="degree", remedy=f"at most {MAX_DEGREE} is accepted")
    return degree


def checked_side(side: Side | str) -> bool:
    """Whether the side is the left one; raises `DomainError` unless it is ``left`` or ``right``."""
    return side is not Side.RIGHT and choice(Side, side, "side", raised=DomainError) is Side.LEFT


def exact_row(values: Iterable[Number], place: str) -> tuple[mpq, ...]:
    """A row of exact numbers; the error names the invalid number."""
    given = tuple(values)
    try:
        return tuple([x if type(x) is RATIONAL else mpq(x) if type(x) is int else rational(x) for x in given])
    except NumberError:
        for i, value in enumerate(given):
            try:
                rational(value)
            except NumberError as error:
                raise error.at(f"{place}[{i}]") from None
        raise
