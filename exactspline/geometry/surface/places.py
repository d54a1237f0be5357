"""Points of a surface by their certified parameters."""

from __future__ import annotations

from dataclasses import dataclass, field

from exactspline.geometry.surface.forms import Patch
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box, Interval
from exactspline.polynomials.common_zeros import Zero
from exactspline.roots.root import Root

#: A parameter: a rational number or a certified root.
Parameter = mpq | Root


@dataclass(frozen=True)
class InnerZero:
    """A certified zero inside a patch, in the parameters of the surface."""

    zero: Zero
    sides: Box

    def box(self, digits: int) -> Box:
        """A box that contains the point, its sides at most ``10^−digits`` long."""
        longest = self.sides.longest
        return self.sides.part(self.zero.refine(int(longest * mpq(10) ** digits + 1).bit_length()))

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both parameters where they are simple rational numbers."""
        place = self.zero.exact
        return None if place is None else self.sides.at(*place)


@dataclass(frozen=True)
class Place:
    """A point of a surface by its parameters: as a certified zero inside a patch (`inner`), or by `u` and `v`, each a
    rational number or a certified root, as on borders of patches.

    `patches` are those on which it was found: on a border of patches there may be several.
    """

    patches: tuple[Patch, ...]
    inner: InnerZero | None = field(default=None, repr=False)
    u: Parameter | None = None
    v: Parameter | None = None

    @property
    def spot(self) -> tuple[Parameter, Parameter]:
        """Both parameters of a point that is not given as an inner zero."""
        assert self.u is not None
        assert self.v is not None
        return self.u, self.v

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both parameters where they are known to be rational."""
        if self.inner is not None:
            return self.inner.exact
        values = [x.exact if isinstance(x, Root) else x for x in (self.u, self.v)]
        return None if values[0] is None or values[1] is None else (values[0], values[1])

    def box(self, digits: int = 20) -> Box:
        """A box that contains the point, its sides at most ``10^−digits`` long."""
        if self.inner is not None:
            return self.inner.box(digits)
        u, v = self.spot
        return Box(enclosing(u, digits), enclosing(v, digits))

    def with_patches(self, patches: tuple[Patch, ...]) -> Place:
        """The same point, found on more patches."""
        return Place(tuple(sorted({*self.patches, *patches})), self.inner, self.u, self.v)


def enclosing(t: Parameter, digits: int) -> Interval:
    """An interval that contains a parameter, at most ``10^−digits`` long."""
    return t.refine(digits) if isinstance(t, Root) else Interval.point(t)
