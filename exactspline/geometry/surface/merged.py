"""Points found patch by patch, as points of the whole surface: each once on borders and seams, with the sides from
which it was found.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import product

from exactspline.geometry.surface.places import Place
from exactspline.geometry.surface.umbilics import Umbilic, UmbilicKind, UmbilicsOfPatch
from exactspline.numbers.intervals import Box
from exactspline.roots.borders import EDGES, vanishes_at
from exactspline.roots.of_polynomials import Parameter
from exactspline.splines.surface import Along

#: A point by its parameters.
Spot = tuple[Parameter, Parameter]
#: The ends of an interval of parameters.
Ends = tuple[Parameter, Parameter]
#: The sides of a point, in u and in v, on which something lies: independent of how knots cut the patches around it.
Sectors = set[tuple[int, int]]


def merged_places(places: Iterable[Place], domain: Box, closed: Sequence[Along]) -> tuple[Place, ...]:
    """The points, each once (also on borders of patches and on seams), with all patches on which it was found."""
    return tuple(_together(own) for own in _groups(places, domain, closed))


def merged_umbilics(
    patches: Sequence[tuple[Box, UmbilicsOfPatch]], domain: Box, closed: Sequence[Along]
) -> tuple[Umbilic, ...]:
    """The umbilics of patches with these sides, each once; one-sided where not all of its sides have it, of unknown
    kind where patches say different ones (their curvatures jump there).
    """
    known = {id(one.place): (one, box) for box, own in patches for one in own.umbilics}
    umbilics = []
    for own in _groups([one.place for one, _ in known.values()], domain, closed):
        first, place = known[id(own[0])][0], _together(own)
        if not place.is_inside:
            seen = {sector for one in own for sector in _sectors(one.spot, known[id(one)][1])}
            for spot in _alike(place.spot, domain, closed):
                seen |= {sector for box, all_of in patches if _has(all_of, spot, box) for sector in _sectors(spot, box)}
            one_sided = seen != _sectors_of_surface(place.spot, domain, closed)
            kinds = {known[id(one)][0].kind for one in own}
            kind = first.kind if len(kinds) == 1 else UmbilicKind.UNKNOWN
            first = replace(first, place=place, kind=kind, one_sided=one_sided)
        umbilics.append(first)
    return tuple(umbilics)


def _groups(places: Iterable[Place], domain: Box, closed: Sequence[Along]) -> list[list[Place]]:
    """The places grouped by the points that they describe."""
    groups: list[list[Place]] = []
    for place in places:
        known = groups if not place.is_inside else []
        for own in known:
            if not own[0].is_inside and is_same(place.spot, own[0].spot, domain, closed):
                own.append(place)
                break
        else:
            groups.append([place])
    return groups


def _together(own: Sequence[Place]) -> Place:
    first, *others = own
    return first.with_patches(tuple(patch for place in others for patch in place.patches))


def is_same(one: Spot, other: Spot, domain: Box, closed: Sequence[Along]) -> bool:
    """Whether two points are equal, with the two ends of a closed surface identified."""
    return any(spot == other for spot in _alike(one, domain, closed))


def is_in(spot: Spot, box: tuple[Ends, Ends], domain: Box, closed: Sequence[Along]) -> bool:
    """Whether a point is in a closed rectangle, with the two ends of a closed surface identified."""
    return any(_within(one, box) for one in _alike(spot, domain, closed))


def _within(spot: Spot, box: tuple[Ends, Ends]) -> bool:
    return all(low <= t <= high for t, (low, high) in zip(spot, box, strict=True))


def _alike(spot: Spot, domain: Box, closed: Sequence[Along]) -> list[Spot]:
    """All pairs of parameters of a point: two for each seam that it is on."""
    u, v = (
        list(side) if line in closed and (t == side[0] or t == side[1]) else [t]
        for t, side, line in zip(spot, domain, Along, strict=True)
    )
    return list(product(u, v))


def _sectors(spot: Spot, box: Box) -> Sectors:
    """The sides of a point of a closed rectangle on which the rectangle is."""
    first, second = (
        [sign for sign, end in ((-1, low), (1, high)) if t != end] for t, (low, high) in zip(spot, box, strict=True)
    )
    return set(product(first, second))


def _sectors_of_surface(spot: Spot, domain: Box, closed: Sequence[Along]) -> Sectors:
    """The sides of a point on which the surface continues."""
    return {sector for one in _alike(spot, domain, closed) for sector in _sectors(one, domain)}


def _has(own: UmbilicsOfPatch, spot: Spot, box: Box) -> bool:
    """Whether a point of a patch lies on an edge, a curve or a whole patch of umbilics."""
    if not _within(spot, box):
        return False
    edges = [edge for edge in EDGES if spot[edge.direction] == edge.value(box)]
    if own.everywhere or any(edge in own.edges for edge in edges):
        return True
    return own.curve is not None and vanishes_at(own.curve.form, spot, box)
