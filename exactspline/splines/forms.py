"""An operation on the polynomials of two splines."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

T = TypeVar("T")


def segmentwise(operation: Callable[[T, T], T], first: Sequence[T], second: Sequence[T]) -> tuple[T, ...]:
    """The results on all segments or patches; on a single one, as most splines have, without a loop."""
    return (operation(first[0], second[0]),) if len(first) == 1 else tuple(map(operation, first, second))
