"""Numbers of other libraries: read exactly, written with correct rounding."""

from __future__ import annotations

import operator
from collections.abc import Iterable

from exactspline.errors import NumberError, shown
from exactspline.interchange.numbers import finite_double
from exactspline.numbers.exact import from_float, is_float, mpq


def exact(value: object) -> mpq:
    """The exact value of a Python or numpy integer or float of any width, or of an exact number.

    >>> exact(3), exact(0.5)
    (mpq(3,1), mpq(1,2))

    Raises `NumberError` for NaN, infinities, complex numbers and objects that are not numbers.
    """
    if type(value) is int:
        return mpq(value)
    if isinstance(value, type(mpq())):
        return value
    if is_float(value):
        return from_float(value)
    try:
        return mpq(operator.index(value))  # type: ignore[arg-type]  # checked to be an integer
    except TypeError:
        raise NumberError(f"{shown(value)} is not a finite number", remedy="pass integers or floats") from None


def exact_rows(rows: Iterable[Iterable[object]]) -> list[list[mpq]]:
    """The exact values of rows of numbers."""
    return [[exact(value) for value in row] for row in rows]


def doubles(values: Iterable[mpq]) -> list[float]:
    """The correctly rounded doubles; raises `NumberError` beyond their range."""
    return [finite_double(value) for value in values]
