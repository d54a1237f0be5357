"""As many curves of a family as are asked for, the same for the same seed."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import replace
from itertools import count, product

from exactspline.errors import FormulaError, nearest
from exactspline.testing import Case
from exactspline.testing.families import FAMILIES, SHAPES, VERSION, bezier_knots, made

#: The exponents k of ε = ±2⁻ᵏ.
EXPONENTS = range(2, 53)
#: Exponents of the powers of two by which near-degenerate curves are scaled.
SCALES = (0, -20, 20, -3, 3)
#: How many curves a pack has of each family; of `named` there are as many as have been reported.
SIZES = {"random": 2500, "integers": 9500, "fonts": 3500, "cad": 900, "near": 4000, "named": 100}


def corpus(family: str, number: int, seed: int = VERSION) -> Iterator[Case]:
    """The first curves of a family; those of `near` and `named` are finitely many.

    >>> [case.key for case in corpus("near", 3)]
    ['near 2 cusp', 'near 2 cusp −', 'near 2 single inflection']

    Raises `FormulaError` with the nearest names.
    """
    if family not in FAMILIES:
        raise FormulaError(f"there is no family called {family!r}", remedy=nearest(family, FAMILIES))
    every = _near() if family == "near" else _drawn(family, seed)
    for _, case in zip(range(number), every, strict=False):
        yield case


def _drawn(family: str, seed: int) -> Iterator[Case]:
    """The cases of a family, then those of the next seeds."""
    for turn in count():
        chance = random.Random(f"{family} {seed + turn}")
        for case in filter(None, FAMILIES[family](chance)):
            yield replace(case, key=f"{case.key} of {seed + turn}") if turn else case
        if family == "named":
            return


def _near() -> Iterator[Case]:
    """Every shape with every ε, reflected, reversed and scaled so that no number is rounded."""
    moved = product(SCALES, (False, True), (False, True), (1, -1))
    for scale, swapped, reversed_, side in moved:
        for k, (name, shape), sign in product(EXPONENTS, SHAPES.items(), (1, -1)):
            points = [tuple(float(c) * 2.0**scale for c in point) for point in shape(sign / (1 << k))]
            points = [(side * x, y) for x, y in points]
            points = [point[::-1] for point in points] if swapped else points
            points = points[::-1] if reversed_ else points
            how = f", 2^{scale}{', swapped' * swapped}{', reversed' * reversed_}{', mirrored' * (side < 0)}"
            key = (
                f"near {k} {name}{' −' * (sign < 0)}{how if (scale, swapped, reversed_, side) != (0, 0, 0, 1) else ''}"
            )
            degree = len(points) - 1
            case = made(key, "near", degree, bezier_knots(degree), points, dial=sign * k)
            if case is not None:
                yield case
