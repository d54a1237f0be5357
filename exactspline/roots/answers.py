"""The places at which something holds: points, pieces of a curve, or both."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Generic, Self, TypeVar, overload

from exactspline.hooks import Written
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine, one_line, short_text
from exactspline.reals.real import real

T_co = TypeVar("T_co", covariant=True)
W = TypeVar("W")


class OneNumber(OneLine):
    """An object with one number (its parameter, unless `_number` names another attribute), which `float` returns as a
    correctly rounded double.

    >>> from exactspline import distance, example
    >>> float(distance(example("circle"), example("ellipse")))
    0.0
    """

    _number = "parameter"

    def __float__(self) -> float:
        return real(getattr(self, self._number)).double()


@dataclass(frozen=True, repr=False)
class CurvePiece(OneLine):
    """A piece of a curve by its parameters: one interval, or two intervals if the piece runs across the seam of a
    closed curve.

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
        """The parameter at which the piece ends; it is below `start` if the piece runs across the seam."""
        return self.parts[-1][1]

    @property
    def across_seam(self) -> bool:
        """Whether the piece runs across the seam of a closed curve."""
        return len(self.parts) > 1

    def __contains__(self, t: object) -> bool:
        return any(a <= t <= b for a, b in self.parts)  # type: ignore[operator]  # any type comparable with mpq

    @one_line
    def __str__(self) -> str:
        return " ∪ ".join(f"[{short_text(a)}, {short_text(b)}]" for a, b in self.parts)


@dataclass(frozen=True, repr=False)
class Answer(Sequence[T_co], Written, Generic[T_co, W]):
    """The places at which something holds: single points, and the parts `everywhere`, whose points are not listed one
    by one. An answer is a sequence of its points; it is true unless the answer is "nowhere".

    >>> from exactspline import example
    >>> example("cubic_s").inflections.to_records()[0]["parameter"]
    0.5
    """

    points: tuple[T_co, ...]
    everywhere: tuple[W, ...] = ()

    @classmethod
    def late(
        cls, count: int, make: Callable[[], tuple[T_co, ...]], everywhere: tuple[W, ...] = (), **fields: object
    ) -> Self:
        """An answer with this many points, which are made when first needed; `fields` are the other fields.

        >>> found = Places.late(2, lambda: ("first", "second"))
        >>> len(found), found == Places(("first", "second"))
        (2, True)
        """
        answer = object.__new__(cls)
        vars(answer).update(fields, everywhere=everywhere, _late=(count, make))
        return answer

    def __getattr__(self, name: str) -> tuple[T_co, ...]:
        kept = vars(self)
        if name != "points" or "_late" not in kept:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        points: tuple[T_co, ...] = kept["_late"][1]()
        kept["points"] = points
        return points

    def __getstate__(self) -> dict[str, object]:
        kept = {"points": self.points} | vars(self)
        kept.pop("_late", None)
        return kept

    @overload
    def __getitem__(self, index: int) -> T_co: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T_co, ...]: ...
    def __getitem__(self, index: int | slice) -> T_co | tuple[T_co, ...]:
        return self.points[index]

    def __len__(self) -> int:
        kept = vars(self)
        return len(kept["points"]) if "points" in kept else int(kept["_late"][0])

    def __iter__(self) -> Iterator[T_co]:
        return iter(self.points)

    def __bool__(self) -> bool:
        return bool(len(self) or self.everywhere)

    def __call__(self) -> Self:
        """The answer itself: ``curve.inflections()`` is ``curve.inflections``."""
        return self

    def where(self, holds: Callable[[T_co], bool]) -> Self:
        """The answer with only those points that have a property, and the same parts."""
        found = replace(self, points=tuple(filter(holds, self.points)))
        return found if self.asked is None else found.asked_with(*self.asked)

    @property
    def asked(self) -> tuple[str, Callable[[], object]] | None:
        """The question whose answer this is, and a function that makes the object of the question again; None if it is
        unknown.
        """
        return vars(self).get("_asked")

    def asked_with(self, question: str, again: Callable[[], object]) -> Self:
        """This answer, which stores the first question that it answers, but no reference to an object that stores the
        answer.
        """
        vars(self).setdefault("_asked", (question, again))
        return self

    @one_line
    def __repr__(self) -> str:
        return ", and ".join(self._parts()) or "nowhere"

    def _parts(self) -> list[str]:
        points = ["[" + ", ".join(map(repr, self.points)) + "]"] if self.points else []
        return points + [f"everywhere on {part}" for part in self.everywhere]


class Places(Answer[T_co, CurvePiece]):
    """The places on a curve at which something holds: points in the order of the parameter, and pieces `everywhere`.

    >>> nowhere, on_a_line = Places(()), Places((), (CurvePiece(((mpq(0), mpq(1)),)),))
    >>> len(nowhere), bool(nowhere), len(on_a_line), bool(on_a_line)
    (0, False, 0, True)
    >>> on_a_line
    everywhere on [0, 1]
    """
