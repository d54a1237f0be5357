"""How much of a campaign the tests run: a part by a seed, all of it where ``EXACTSPLINE_FULL`` is set."""

import os
from collections.abc import Sequence
from random import Random
from typing import TypeVar

T = TypeVar("T")
FULL = bool(os.environ.get("EXACTSPLINE_FULL"))


def sample(cases: Sequence[T], count: int, seed: int | str = 1) -> list[T]:
    """This many of the cases in their order, the same every time."""
    if FULL or count >= len(cases):
        return list(cases)
    return [cases[i] for i in sorted(Random(seed).sample(range(len(cases)), count))]
