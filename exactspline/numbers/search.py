"""A search by parts, such as boxes or intervals, where smaller parts take the place of those that are not decided."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import repeat
from typing import Generic, TypeVar

T = TypeVar("T")


class Search(Generic[T]):
    """The parts of a whole, one after another. Smaller parts take the place of a part that is `split`: they come last
    or, if the search is `depth_first`, next. Parts that are not decided and not split any more are `open`.

    >>> search = Search([(0, 16)])  # where is the square 40?
    >>> for low, high in search:
    ...     middle = (low + high) // 2
    ...     if low**2 < 40 < high**2:
    ...         search.split([(low, middle), (middle, high)] if search.depth < 4 else None)
    >>> search.open, search.seen
    ([(6, 7)], 9)
    """

    def __init__(self, start: Iterable[T], *, depth_first: bool = False) -> None:
        self._todo, self._depth_first = deque(zip(start, repeat(0))), depth_first
        #: The number of parts looked at so far, and how often a part has been split to obtain the present one.
        self.seen, self.depth = 0, 0
        self.open: list[T] = []

    def __iter__(self) -> Iterator[T]:
        while self._todo:
            self._part, self.depth = self._todo.popleft()
            self.seen += 1
            yield self._part

    def split(self, parts: Sequence[T] | None) -> None:
        """Look at these parts in place of the present one, or leave it open."""
        if parts is None:
            self.open.append(self._part)
        elif self._depth_first:
            self._todo.extendleft(zip(reversed(parts), repeat(self.depth + 1)))
        else:
            self._todo.extend(zip(parts, repeat(self.depth + 1)))
