"""Points of a surface by their certified parameters."""

from __future__ import annotations

from dataclasses import dataclass, field

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.one_line import OneLine
from exactspline.roots.of_polynomials import Parameter


@dataclass(frozen=True, repr=False)
class Place(OneLine):
    """A point of a surface by its parameters. `patches` are those on which it was found: on a border of patches there
    may be several.
    """

    patches: tuple[Patch, ...] = field(repr=False)
    zero: CommonZero

    @property
    def is_inside(self) -> bool:
        """Whether it is inside its patch, and on no border."""
        return self.zero.is_inside

    @property
    def spot(self) -> tuple[Parameter, Parameter]:
        """Both parameters. Raises `ReachError` where it would take too long to compute those of a point inside."""
        return self.zero.place

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both parameters where they are known to be rational."""
        return self.zero.exact

    def box(self, digits: int = 20) -> Box:
        """A box that contains the point, its sides at most ``10^−digits`` long."""
        return self.zero.box(digits)

    def with_patches(self, patches: tuple[Patch, ...]) -> Place:
        """The same point, found on more patches."""
        return Place(tuple(sorted({*self.patches, *patches})), self.zero)
