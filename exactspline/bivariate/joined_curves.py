"""Curves of zeros across patches: parts on neighbouring patches that end at the same point of their common border are
joined.

Where a form is continuous (K where the curvature is), it has the same zeros on the border for both patches, as roots of
two polynomials; whether two of these roots are equal is decided exactly. The two ends of a closed surface are a common
border.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator, Sequence, Set
from dataclasses import dataclass, field
from typing import NamedTuple

from exactspline.bivariate.across_borders import Place, Spot, is_in, once
from exactspline.bivariate.borders import Edge, Patch, along, roots_along
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.zero_curve import Part, Shape, Vertex, ZeroCurve
from exactspline.errors import counted
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.one_line import one_line
from exactspline.splines.surface import Along


class Piece(NamedTuple):
    """The part of a curve of zeros on one patch."""

    patch: Patch
    sides: Box
    curve: ZeroCurve
    part: Part

    def spots(self) -> Iterator[tuple[Spot, int]]:
        """The points of the part on the border of the patch, in the parameters of the surface, and the number of arcs
        that end at each.
        """
        ends = self.part.ends
        for vertex in self.part.vertices:
            if (spot := self.spot(vertex)) is not None:
                yield spot, ends[vertex]

    def spot(self, vertex: Vertex) -> Spot | None:
        """A point on the border of the patch in the parameters of the surface; None for a point inside."""
        if vertex.other is not None:
            if not {vertex.value, vertex.other} & {0, 1}:
                return None
            return self.sides.at(vertex.value, vertex.other)
        if vertex.value not in (0, 1):
            return None
        edge = Edge(vertex.direction, int(vertex.value))
        own = roots_along(along(self.curve.form, edge, self.sides), edge, self.sides)[vertex.index]
        value = edge.value(self.sides)
        return (value, own) if edge.direction == 0 else (own, value)

    @one_line
    def __repr__(self) -> str:
        return f"<{self.part.shape} on {self.sides}>"


def place_of(piece: Piece) -> Place:
    """The place of a part that is a single point."""
    if piece.part.zero is not None:
        return Place((piece.patch,), piece.part.zero.on(piece.sides))
    ((spot, _),) = piece.spots()
    return Place((piece.patch,), CommonZero.at(piece.sides, spot))


@dataclass(frozen=True, repr=False)
class ZeroComponent:
    """A connected part of the zeros of a form, with its pieces patch by patch. `met` has the number of arcs that end at
    each of its points on borders of patches; points on a seam have the first parameter.
    """

    shape: Shape
    pieces: tuple[Piece, ...]
    met: dict[Spot, int] = field(default_factory=dict, compare=False)

    @one_line
    def __repr__(self) -> str:
        return f"<{self.shape} on {counted(len(self.patches), 'patch')}>"

    @property
    def patches(self) -> tuple[Patch, ...]:
        """The patches that the component meets."""
        return tuple(dict.fromkeys(piece.patch for piece in self.pieces))

    def arcs(self, domain: Box, closed: Sequence[Along] = ()) -> list[tuple[Spot | None, Spot | None, bool]]:
        """The arcs between singular points and points on the border, by the parameters of both ends, None for an end in
        an undecided box; and whether the arc is closed and has no such points. Raises `ReachError` if computing the
        parameters of a singular point would take too long.
        """
        graph, special = _graph(self.pieces, domain, closed), dict[Hashable, Spot]()
        node: Hashable
        borders = _borders(domain, closed)
        for k, piece in enumerate(self.pieces):
            for joint in piece.part.joints:
                on_border = None if joint.corner is None else piece.spot(joint.corner)
                node = (k, joint.box) if on_border is None else _OnBorder(once(on_border, domain, closed))
                special[node] = on_border or joint.zero.on(piece.sides).place
        special |= {node: node.spot for node in graph if isinstance(node, _OnBorder) and _meets(node.spot, borders)}
        inner = {node for node, near in graph.items() if len(near) == 2 and node not in special}
        ends = [(node, way) for node, near in graph.items() if node not in inner for way in near]
        found = list[tuple[Spot | None, Spot | None, bool]]()

        def followed(node: Hashable, way: _Way) -> tuple[Hashable, _Way]:
            while node in inner:
                inner.remove(node)
                way = next(other for other in graph[node] if other is not way)
                node = _other(way, node)
            return node, way

        while ends:
            start, way = ends.pop(0)
            end = followed(_other(way, start), way)
            ends.remove(end)
            found.append((_place(start, special), _place(end[0], special), False))
        while inner:
            start = next(node for node in graph if node in inner)
            followed(start, graph[start][0])
            found.append((None, None, True))
        return found


#: A piece of a curve between two of its points.
_Way = list[Hashable]


def _other(way: _Way, node: Hashable) -> Hashable:
    return way[1] if way[0] == node else way[0]


def _place(node: Hashable, special: dict[Hashable, Spot]) -> Spot | None:
    """The parameters of a point; None for a point on the border of an undecided box."""
    return node.spot if isinstance(node, _OnBorder) else special.get(node)


class _OnBorder(NamedTuple):
    """A point on the border of a patch."""

    spot: Spot


def _graph(pieces: Sequence[Piece], domain: Box, closed: Sequence[Along]) -> dict[Hashable, list[_Way]]:
    """The points of the pieces of one curve, and the ways from each point to the next ones."""
    graph: dict[Hashable, list[_Way]] = {}
    for k, piece in enumerate(pieces):
        keys: dict[Vertex, Hashable] = {}
        for vertex in piece.part.vertices:
            spot = piece.spot(vertex)
            keys[vertex] = (k, vertex) if spot is None else _OnBorder(once(spot, domain, closed))
        ways: list[_Way] = [[keys[arc.first], keys[arc.last]] for arc in piece.part.arcs]
        for joint in piece.part.joints:
            node = (k, joint.box) if joint.corner is None else keys[joint.corner]
            ways += [[node, keys[end]] for end in joint.ends]
        for way in ways:
            for node in way:
                graph.setdefault(node, []).append(way)
    return graph


def chained(
    pieces: Sequence[Piece], domain: Box, closed: Sequence[Along], undecided: Sequence[Box] = ()
) -> tuple[ZeroComponent, ...]:
    """The pieces, joined where they meet on borders of patches; a piece that ends in an `undecided` box may continue
    there.
    """
    spots: dict[Spot, Counter[int]] = {}
    borders = _borders(domain, closed)
    for k, piece in enumerate(pieces):
        for spot, arcs in piece.spots():
            spots.setdefault(once(spot, domain, closed), Counter())[k] += arcs
    groups = list(range(len(pieces)))
    for own in spots.values():
        first, *others = (groups[k] for k in own)
        groups = [first if group in others else group for group in groups]
    unclear = {spot for spot in spots if any(is_in(spot, box, domain, closed) for box in undecided)}
    components = []
    for group in dict.fromkeys(groups):
        members = [pieces[k] for k, own in enumerate(groups) if own == group]
        met = {spot: sum(own.values()) for spot, own in spots.items() if groups[next(iter(own))] == group}
        components.append(ZeroComponent(_shape(members, met, unclear, borders), tuple(members), met))
    return tuple(components)


def _shape(
    members: Sequence[Piece], met: dict[Spot, int], unclear: Set[Spot], borders: Sequence[tuple[mpq, ...]]
) -> Shape:
    """The shape that pieces form together, by the numbers of arcs that meet at their points on borders."""
    own = {piece.part.shape for piece in members}
    if Shape.OPEN in own or not unclear.isdisjoint(met):
        return Shape.OPEN
    if Shape.CROSSED in own:
        return Shape.CROSSED
    if not any(piece.part.ends for piece in members):
        return Shape.POINT
    if max(met.values(), default=0) > 2:
        return Shape.CROSSED
    ends = [spot for spot, count in met.items() if count == 1]
    if not ends:
        return Shape.LOOP
    return Shape.ARC if all(_meets(spot, borders) for spot in ends) else Shape.BROKEN


def _borders(domain: Box, closed: Sequence[Along]) -> list[tuple[mpq, ...]]:
    """The ends of both parameters at which the surface is not closed."""
    return [() if line in closed else side for side, line in zip(domain, Along, strict=True)]


def _meets(spot: Spot, borders: Sequence[tuple[mpq, ...]]) -> bool:
    """Whether a point is on the border."""
    return any(t in side for t, side in zip(spot, borders, strict=True))
