"""Points found patch by patch, as points of the whole surface: each point once on borders and seams, with the patches
on which it was found, and without points on an edge, a line or a curve on which the same holds everywhere.
"""

from __future__ import annotations

from collections.abc import Container, Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import product

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.one_line import OneLine
from exactspline.roots.of_polynomials import Parameter
from exactspline.splines.surface import Along

# ---- points


@dataclass(frozen=True, repr=False)
class Place(OneLine):
    """A point of a surface by its parameters. `patches` are the patches on which it was found: on a border there may be
    several.
    """

    patches: tuple[Patch, ...] = field(repr=False)
    zero: CommonZero

    @property
    def is_inside(self) -> bool:
        """Whether the point is inside its patch, not on a border."""
        return self.zero.is_inside

    @property
    def spot(self) -> tuple[Parameter, Parameter]:
        """Both parameters of the point. Raises `ReachError` if computing them for an inner point would take too
        long.
        """
        return self.zero.place

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both parameters if they are known to be rational, otherwise None."""
        return self.zero.exact

    def box(self, digits: int = 20) -> Box:
        """A box that contains the point, its sides at most ``10^−digits`` long."""
        return self.zero.box(digits)


#: A point by its parameters.
Spot = tuple[Parameter, Parameter]
#: The ends of an interval of parameters.
Ends = tuple[Parameter, Parameter]
#: A closed rectangle of parameters, or an edge, a line.
Sides = tuple[Ends, Ends]


def single_places(
    places: Iterable[Place], parts: Sequence[Sides], curves: Container[Spot], domain: Box, closed: Sequence[Along]
) -> list[list[Place]]:
    """The places, with places of the same point merged. Points on borders of patches are omitted if they are in one of
    the `parts`, or if an arc of one of the `curves` ends there, on whatever patch.
    """
    groups: dict[Hashable, list[Place]] = {}
    for place in places:
        if place.is_inside:
            groups[id(place)] = [place]
            continue
        spot = once(place.spot, domain, closed)
        if spot not in curves and not any(is_in(spot, part, domain, closed) for part in parts):
            groups.setdefault(spot, []).append(place)
    return list(groups.values())


def together(own: Sequence[Place]) -> Place:
    """The place of one point that was found on several patches."""
    return Place(tuple(sorted({patch for place in own for patch in place.patches})), own[0].zero)


def is_in(spot: Spot, box: Sides, domain: Box, closed: Sequence[Along]) -> bool:
    """Whether a point is in a closed rectangle, with the two ends of a closed surface identified."""
    return any(within(one, box) for one in alike(spot, domain, closed))


def within(spot: Spot, box: Sides) -> bool:
    """Whether a point is in a closed rectangle."""
    return all(low <= t <= high for t, (low, high) in zip(spot, box, strict=True))


def once(spot: Spot, domain: Box, closed: Sequence[Along]) -> Spot:
    """The point, with the first parameter in place of the last one where the surface is closed."""
    u, v = (
        side[0] if line in closed and t == side[1] else t for t, side, line in zip(spot, domain, Along, strict=True)
    )
    return u, v


def alike(spot: Spot, domain: Box, closed: Sequence[Along]) -> list[Spot]:
    """All pairs of parameters of a point: each seam through the point doubles their number."""
    u, v = (
        list(side) if line in closed and (t == side[0] or t == side[1]) else [t]
        for t, side, line in zip(spot, domain, Along, strict=True)
    )
    return list(product(u, v))
