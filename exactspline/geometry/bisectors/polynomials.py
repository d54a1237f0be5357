"""Vectors of polynomials along curves and over patches, their common divisors, and whether they vanish at a pair."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from typing import Protocol, Self, TypeVar

from flint import fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError
from exactspline.language.operand import Scalar
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.vanishing import vanish_at

#: Three polynomials: a vector along a curve, or over a patch.
Three = list[fmpz_poly]
ThreeOfTwo = list[fmpz_mpoly]


class Euclidean(Scalar, Protocol):
    """A polynomial in one parameter over the integers or a field."""

    def __mul__(self, other: Self | int, /) -> Self: ...
    def __floordiv__(self, other: Self, /) -> Self: ...
    def gcd(self, other: Self, /) -> Self:
        """The greatest common divisor."""


E = TypeVar("E", bound=Euclidean)


# ---- one parameter


def common_divisor_along(polynomials: Iterable[E]) -> E:
    """The greatest common divisor of polynomials in one parameter; `ReachError` where that would take too long."""
    given = list(polynomials)
    if isinstance(given[0], fmpz_poly):
        return greatest_common_divisor(given)  # type: ignore[type-var]  # all of them are of one type
    return reduce(lambda p, q: p.gcd(q), given)


# ---- two parameters


def vanish_together(polynomials: Sequence[fmpz_mpoly], s: Parameter, t: Parameter) -> bool | None:
    """Whether polynomials vanish at a pair, decided exactly; None where that would take too long."""
    try:
        return vanish_at(polynomials, s, t)
    except ReachError:
        return None
