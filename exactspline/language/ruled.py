"""Ruled surfaces: a directrix and a generator, as formulas return them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from exactspline.language.services import Displayed
from exactspline.language.vector import Vector


class RuledSurface(Displayed):
    """``directrix + ζ generator`` in any reading: two vectors (or vector quotients) of one parameter s, and the ruling
    parameter ζ.

    >>> RuledSurface(Vector(1, 2, 3), Vector(0, 0, 1)).at(5)
    Vector(1, 2, 8)
    """

    __slots__ = ("directrix", "generator")

    def __init__(self, directrix: Any, generator: Any) -> None:
        self.directrix, self.generator = directrix, generator

    def at(self, ruling: Any) -> Any:
        """The curve of constant ruling parameter."""
        return self.directrix + self.generator * ruling

    @property
    def degree(self) -> Any:
        """Degree in s: that of directrix + ζ generator with ζ a number, under Table 1."""
        return self.joined.degree

    @property
    def joined(self) -> Any:
        """Directrix and generator side by side, as one vector of twice as many components (over one denominator where
        they are quotients).
        """
        directrix, generator = self.directrix, self.generator
        nothing = [directrix[0].constant(0)] * len(directrix)
        first = _with_numerator(directrix, lambda v: Vector(*v, *nothing))
        return first + _with_numerator(generator, lambda v: Vector(*nothing, *v))


def ruled(directrix: Any, generator: Any) -> Any:
    """The ruled surface ``directrix + ζ generator`` (in the tree reading a node).

    >>> ruled(Vector(1, 0, 0), Vector(0, 0, 1)).at(2)
    Vector(1, 0, 2)
    """
    hook = getattr(directrix, "ruled", None)
    return RuledSurface(directrix, generator) if hook is None else hook(generator)


def _with_numerator(value: Any, change: Callable[[Any], Any]) -> Any:
    """A vector, or the numerator of a vector quotient, changed."""
    return change(value) if isinstance(value, Vector) else type(value)(change(value.numerator), value.product)
