"""Numbers of other libraries: read exactly, written with correct rounding."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Sequence
from math import ulp

from exactspline.errors import NumberError, shown
from exactspline.interchange.numbers import finite_double
from exactspline.numbers.exact import double, from_float, is_float, mpq

#: A knot or a coefficient may be moved by this many units in the last place of the largest one.
MOST_ULPS = 8


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


def periodic(degree: int, knots: Sequence[mpq], points: Sequence[object]) -> tuple[Sequence[mpq], str]:
    """The knots of a curve whose last control points are its first ones, periodic where they are that up to rounding:
    those outside of the domain, by at most `MOST_ULPS`; and a note on what was moved. Other knots stay.

    >>> rounded = [mpq(t) if t > -3 else mpq(t) - mpq(1, 10**16) for t in range(-3, 9)]
    >>> knots, note = periodic(3, rounded, "abcdeabc")
    >>> knots[0], note
    (mpq(-3,1), 'closed: knots outside of the domain were moved by at most 1e-16')
    """
    count, made = len(points), list(knots)
    if not 0 < degree < count or knots[0] == knots[degree] or points[:degree] != points[count - degree :]:
        return knots, ""
    ahead, width = count - degree, knots[count] - knots[degree]
    for i in reversed(range(degree)):
        made[i] = made[i + ahead] - width
    for i in range(count + 1, len(knots)):
        made[i] = made[i - ahead] + width
    change = max(abs(a - b) for a, b in zip(made, knots, strict=True))
    if not 0 < change <= MOST_ULPS * exact(ulp(max(map(float, map(abs, knots))))):
        return knots, ""
    return made, f"closed: knots outside of the domain were moved by at most {double(change, 'up'):.3g}"
