"""The polynomials of a spline: an operation on those of two splines, and their copies for reading, since FLINT's
polynomials can be changed in place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from operator import eq
from typing import TypeVar, overload

from flint import fmpz_poly

from exactspline.one_line import one_line

T = TypeVar("T")


def segmentwise(operation: Callable[[T, T], T], first: Sequence[T], second: Sequence[T]) -> tuple[T, ...]:
    """The results on all segments or patches; on a single one, as most splines have, without a loop."""
    return (operation(first[0], second[0]),) if len(first) == 1 else tuple(map(operation, first, second))


class Polynomials(Sequence[fmpz_poly]):
    """The polynomials of a spline, segment by segment; each is copied on access.

    >>> from exactspline import BSpline
    >>> f = BSpline.bezier([1, 2])
    >>> p = f.polynomials[0]
    >>> p[0] = 7
    >>> f(0), f.polynomials[0]
    (mpq(1,1), 2*x + 1)
    """

    __slots__ = ("_own",)

    def __init__(self, own: tuple[fmpz_poly, ...]) -> None:
        self._own = own

    def __len__(self) -> int:
        return len(self._own)

    @overload
    def __getitem__(self, index: int) -> fmpz_poly: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[fmpz_poly, ...]: ...
    def __getitem__(self, index: int | slice) -> fmpz_poly | tuple[fmpz_poly, ...]:
        return tuple(map(fmpz_poly, self._own[index])) if isinstance(index, slice) else fmpz_poly(self._own[index])

    def __iter__(self) -> Iterator[fmpz_poly]:
        return map(fmpz_poly, self._own)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and len(other) == len(self) and all(map(eq, self, other))

    __hash__ = None  # type: ignore[assignment]  # Python's way to say: not hashable

    @one_line
    def __repr__(self) -> str:
        return repr(tuple(self))
