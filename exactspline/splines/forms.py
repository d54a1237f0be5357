"""The polynomials of a spline, for reading: since FLINT's polynomials can be changed in place, every returned one is a
copy.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import eq
from typing import overload

from flint import fmpz_poly


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

    def __repr__(self) -> str:
        return repr(tuple(self))
