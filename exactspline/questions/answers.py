"""What the answer to a question looks like: points, pieces of a curve, or both."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar, overload

from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Interval

T_co = TypeVar("T_co", covariant=True)


@dataclass(frozen=True)
class CurvePiece:
    """A piece of a curve by its parameters: one interval, or two where it runs across the seam of a closed curve.

    The parts are in the order in which the curve runs through them, all inside the domain.

    >>> print(CurvePiece(((mpq(3), mpq(4)), (mpq(0), mpq(1, 2)))))
    [3, 4] ∪ [0, 1/2]
    """

    parts: tuple[Interval, ...]

    @property
    def start(self) -> mpq:
        """The parameter at which the piece begins."""
        return self.parts[0][0]

    @property
    def end(self) -> mpq:
        """The parameter at which the piece ends: below `start` where it runs across the seam."""
        return self.parts[-1][1]

    @property
    def across_seam(self) -> bool:
        """Whether the piece runs across the seam of a closed curve."""
        return len(self.parts) > 1

    def __contains__(self, t: object) -> bool:
        return any(a <= t <= b for a, b in self.parts)  # type: ignore[operator]  # any type comparable with mpq

    def __str__(self) -> str:
        return " ∪ ".join(f"[{text(a)}, {text(b)}]" for a, b in self.parts)


@dataclass(frozen=True)
class Places(Sequence[T_co], Generic[T_co]):
    """Where on a curve something holds: at single points, in the order of the parameter; and `everywhere` on these
    pieces, whose points are not listed one by one. As a sequence it is that of its points; it is true unless the answer
    is "nowhere".

    >>> nowhere, on_a_line = Places(()), Places((), (CurvePiece(((mpq(0), mpq(1)),)),))
    >>> len(nowhere), bool(nowhere), len(on_a_line), bool(on_a_line)
    (0, False, 0, True)
    >>> on_a_line
    everywhere on [0, 1]
    """

    points: tuple[T_co, ...]
    everywhere: tuple[CurvePiece, ...] = ()

    @overload
    def __getitem__(self, index: int) -> T_co: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T_co, ...]: ...
    def __getitem__(self, index: int | slice) -> T_co | tuple[T_co, ...]:
        return self.points[index]

    def __len__(self) -> int:
        return len(self.points)

    def __iter__(self) -> Iterator[T_co]:
        return iter(self.points)

    def __bool__(self) -> bool:
        return bool(self.points or self.everywhere)

    def where(self, holds: Callable[[T_co], bool]) -> Places[T_co]:
        """The points with a property, on the same pieces."""
        return Places(tuple(filter(holds, self.points)), self.everywhere)

    def __repr__(self) -> str:
        points = ["[" + ", ".join(map(repr, self.points)) + "]"] if self.points else []
        pieces = [f"everywhere on {piece}" for piece in self.everywhere]
        return ", and ".join([*points, *pieces]) or "nowhere"
