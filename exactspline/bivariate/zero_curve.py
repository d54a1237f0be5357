"""The zeros of a form on a patch: their exact topology, by boxes in which the curve is a graph.

A box is finished when the form, or one of its derivatives, has one sign on the box. With a derivative of one sign the
curve meets every line of this direction at most once, and signs at rational points decide which of its zeros on the
border of the box are joined. Zeros on borders of boxes are roots of polynomials in one parameter. Where branches cross
or a point is isolated no such box exists: there the critical point is certified in a separate cell, and shown to be of
one of these two kinds.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import pairwise, starmap
from operator import itemgetter
from typing import NamedTuple

from flint import fmpz

from exactspline.bivariate.borders import EDGES
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.singular_points import Cell, Crossing, singular_cells
from exactspline.bivariate.zero_lines import rational_lines
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.numbers.search import Search
from exactspline.one_line import OneLine
from exactspline.polynomials.bernstein import ONE, from_integers
from exactspline.polynomials.patch_forms import PatchForm, Sized, clusters, halved, rounded
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Place
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

#: The limits of the halvings of a box (half of them for each side) and of the number of boxes, beyond which the
#: remaining boxes are reported as undecided.
DEPTH, BOXES = 60, 4000
#: The first cuts of the square, which avoid lines on which the zeros of a symmetric surface would lie.
FIRST_CUTS = tuple(mpq(a, b) for a, b in ((29, 61), (31, 67), (37, 79), (41, 89), (43, 97), (47, 101), (53, 109)))
#: The number of half branches at a point where two branches cross.
BRANCHES = 4
#: The precision (bits) of points of a curve for drawing.
DRAWN_BITS = 24


class Shape(StrEnum):
    """The shape of a connected part of the zeros on a closed patch."""

    LOOP = "closed loop"
    ARC = "arc from border to border"
    CROSSED = "branches that cross"
    POINT = "single point"
    #: All of the arc is on the curve, but the arc continues in undecided boxes.
    OPEN = "arc into an undecided box"
    #: The arc ends where patches meet without continuous curvature.
    BROKEN = "arc that ends where patches meet"


@dataclass(frozen=True, repr=False)
class Vertex(OneLine):
    """A zero on a line of the subdivision, on which x (direction 0) or y is `value`. The vertex is given by its `index`
    among the zeros on the line or, if both coordinates are rational, by x and y and the index −1.
    """

    direction: int
    value: mpq
    index: int
    other: mpq | None = None


@dataclass(frozen=True, repr=False)
class Arc(OneLine):
    """A piece of the curve in a box in which the curve is a graph over the coordinate other than `direction`."""

    first: Vertex
    last: Vertex
    box: Box
    direction: int
    low: mpq | Root
    high: mpq | Root


@dataclass(frozen=True, repr=False)
class Part(OneLine):
    """A connected part of the zeros: its shape, and the arcs of which it consists."""

    shape: Shape
    arcs: tuple[Arc, ...] = ()
    #: The certified singular points of the part, as boxes.
    cells: tuple[Box, ...] = ()
    #: The points of the part on lines of the subdivision, including the border of the patch.
    vertices: tuple[Vertex, ...] = field(default=(), repr=False)
    #: The certified point, if the part is a single point inside.
    zero: CommonZero | None = field(default=None, repr=False, compare=False)
    #: The singular points at which branches meet.
    joints: tuple[Joint, ...] = field(default=(), repr=False, compare=False)

    @property
    def ends(self) -> Counter[Vertex]:
        """The number of pieces of the curve that end at each point."""
        return _ends(self.arcs, self.joints)


class Joint(NamedTuple):
    """A singular point in a box, and the places where its branches leave the box; `corner` is the point itself if it is
    on the border of the square.
    """

    box: Box
    zero: CommonZero
    ends: list[Vertex]
    corner: Vertex | None = None

    @property
    def vertices(self) -> list[Vertex]:
        """All points of the joint on lines of the subdivision."""
        return self.ends if self.corner is None else [*self.ends, self.corner]

    @property
    def crossed(self) -> bool:
        """Whether more than two branches meet."""
        return len(self.ends) > 2

    @property
    def links(self) -> list[tuple[Vertex, Vertex]]:
        """The pairs of points that are joined."""
        if self.corner is not None:
            return [(self.corner, vertex) for vertex in self.ends]
        return [] if self.crossed else [(self.ends[0], self.ends[1])]


class Begun(NamedTuple):
    """A subdivision that has been begun: boxes, with the form on each, that contain all zeros except those in `cells`
    around singular points and those in boxes in which the curve is not resolved.
    """

    boxes: Sequence[Sized]
    cells: Sequence[Cell] = ()
    unresolved: Sequence[Box] = ()


class ZeroCurve(OneLine):
    """All zeros of a form on the closed unit square; `known` are certified points at which it is known to be singular.
    A subdivision that has been `begun` is continued, and no singular points are searched for.

    >>> circle = PatchForm.of_net([[5, -3, 5], [-3, -11, -3], [5, -3, 5]])  # a circle around the middle
    >>> [part.shape.value for part in ZeroCurve(circle).parts]
    ['closed loop']
    """

    def __init__(self, form: PatchForm, known: Sequence[CommonZero] = (), begun: Begun | None = None) -> None:
        self.form, self._known, self._begun = form, tuple(known), begun
        #: Boxes in which the curve is not resolved.
        self.undecided: list[Box] = []
        self._lines: dict[tuple[int, mpq], list[Root]] = {}
        #: The order in which they are found is kept, so that answers do not depend on hashes.
        self._vertices: dict[Vertex, None] = {}
        self._arcs: list[Arc] = []
        self._crossings: list[Joint] = []
        self._points: list[Cell] = []
        self._subdivide(begun or self._beginning())

    def __reduce__(self) -> tuple[object, ...]:
        return ZeroCurve, (self.form, self._known, self._begun)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ZeroCurve) and bool(self.form.matrix == other.form.matrix)

    def __hash__(self) -> int:
        return hash((self.form.degree, *map(int, self.form.corners)))

    # ---- the subdivision

    def _beginning(self) -> Begun:
        cells = singular_cells(self.form, self._known)
        done = [cell.box for cell in cells]
        return Begun([Sized(box, [rounded(self.form, box)]) for box in grid(self.form, done)], cells)

    def _subdivide(self, begun: Begun) -> None:
        done = [*(cell.box for cell in begun.cells), *begun.unresolved]
        self.undecided += begun.unresolved
        for cell in begun.cells:
            if cell.crossing is Crossing.OTHER:
                self._branches(cell)
                continue
            ends = list(dict.fromkeys(self._on_border(cell.box)))
            if cell.crossing is Crossing.POINT:
                self._points.append(cell)
            elif len(ends) == BRANCHES:  # a side along which the form vanishes would have two more vertices at its ends
                self._crossings.append(Joint(cell.box, cell.zero, ends))
            else:
                self.undecided.append(cell.box)
        search, boxes = Search(begun.boxes), 0
        for part in search:
            own = part.forms[0]
            if own.sign is not None or any(box.contains(part.box) for box in done):
                continue
            if any(box.overlaps(part.box) for box in done):
                search.split(halved(part))
                continue
            boxes += 1
            direction = own.monotonic
            on_a_line = direction is not None and self._vanishes_around(part.box)
            if direction is not None and not on_a_line:
                self._graph(part.box, direction)
            else:
                allowed = not on_a_line and not is_small(part.box, self.form) and boxes <= BOXES
                search.split(halved(part, own.steeper) if allowed else None)
        self.undecided += [part.box for part in search.open]

    def _branches(self, cell: Cell) -> None:
        """Record the branches that leave a singular point, or that there are no branches."""
        ends = [vertex for x in cell.ends for vertex, _ in self._zeros_on(0, x, cell.box.second)]
        corner = self._on_edge(cell.zero.place)
        if ends:
            self._crossings.append(Joint(cell.box, cell.zero, ends, corner))
        elif corner is None:
            self._points.append(cell)
        else:
            self._vertices[corner] = None

    def _on_edge(self, place: Place) -> Vertex | None:
        """A zero on the border of the square as a vertex; None for a zero inside."""
        direction = next((k for k in (0, 1) if place[k] in (0, 1)), None)
        if direction is None:
            return None
        value = mpq(int(place[direction] == 1))
        return next(vertex for vertex, t in self._zeros_on(direction, value, UNIT.second) if t == place[1 - direction])

    def _vanishes_around(self, box: Box) -> bool:
        """Whether the form vanishes along a whole side of a box: its zeros there are not isolated points."""
        return any(not any(self._along(direction, box[direction][end])) for direction, end in EDGES)

    def _graph(self, box: Box, direction: int) -> None:
        """Record the curve in a box in which it meets every line of the direction at most once."""
        (a, b), (c, d) = box[direction], box[1 - direction]
        events: dict[Vertex, mpq | Root] = {}
        for value in (a, b):
            events.update(self._zeros_on(direction, value, box[1 - direction]))
        for value in (c, d):
            events.update({vertex: value for vertex, _ in self._zeros_on(1 - direction, value, box[direction])})
        self._vertices.update(dict.fromkeys(events))
        for (first, low), (last, high) in pairwise(sorted(events.items(), key=itemgetter(1))):
            middle = between(low, high)
            ends = [self._value(direction, x, middle) for x in (a, b)]
            if min(ends) < 0 < max(ends):
                self._arcs.append(Arc(first, last, box, direction, low, high))

    def _value(self, direction: int, x: mpq, y: mpq) -> mpq:
        return self.form.value(x, y) if direction == 0 else self.form.value(y, x)

    def _along(self, direction: int, value: mpq) -> list[fmpz]:
        """The Bernstein coefficients on a line across the whole square."""
        return self.form.on_line(direction, value)

    def _line(self, direction: int, value: mpq) -> list[Root]:
        """The zeros on a line across the whole square, in order."""
        key = direction, value
        if key not in self._lines:
            self._lines[key] = [*zeros_on_line(self.form, direction, value)]
        return self._lines[key]

    def _zeros_on(self, direction: int, value: mpq, side: Interval) -> Iterator[tuple[Vertex, mpq | Root]]:
        """The vertices on a part of a line, with the coordinate along it."""
        for k, root in enumerate(self._line(direction, value)):
            if not side[0] <= root <= side[1]:
                continue
            if root.exact is None:
                yield Vertex(direction, value, k), root
            else:
                # the vertex may be the corner of another box, and on a line of the other direction
                x, y = (value, root.exact) if direction == 0 else (root.exact, value)
                yield Vertex(0, x, -1, y), root.exact

    def _on_border(self, box: Box) -> Iterator[Vertex]:
        for direction, end in EDGES:
            yield from (v for v, _ in self._zeros_on(direction, box[direction][end], box[1 - direction]))

    # ---- the answer

    @property
    def complete(self) -> bool:
        """Whether no box is undecided."""
        return not self.undecided

    @property
    def has_branches(self) -> bool:
        """Whether the resolved zeros include pieces of curves."""
        return bool(self._arcs or self._crossings)

    @property
    def single_points(self) -> tuple[CommonZero, ...]:
        """The certified zeros inside with no other zero around them."""
        return tuple(cell.zero for cell in self._points)

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """The connected parts of the resolved zeros; a part that continues in undecided boxes is listed as far as it is
        resolved.

        A part that does not meet an undecided box is complete: all zeros on the borders of boxes are known.
        """
        joined = _Joined(self._vertices)
        for arc in self._arcs:
            joined.join(arc.first, arc.last)
        for joint in self._crossings:
            for one, other in pairwise(joint.vertices):
                joined.join(one, other)
        groups: dict[Vertex, list[Arc]] = {}
        members: dict[Vertex, list[Vertex]] = {}
        for vertex in joined.parents:
            groups.setdefault(joined.root(vertex), [])
            members.setdefault(joined.root(vertex), []).append(vertex)
        for arc in self._arcs:
            groups[joined.root(arc.first)].append(arc)
        crossings: dict[Vertex, list[Joint]] = {}
        for joint in self._crossings:
            crossings.setdefault(joined.root(joint.ends[0]), []).append(joint)
        parts = []
        for group, arcs in groups.items():
            crossed = crossings.get(group, [])
            shape = _shape(arcs, crossed)
            if self.undecided and any(self._is_open_at(vertex) for vertex in members[group]):
                if not arcs and not crossed:
                    continue  # the part is covered by the undecided box
                shape = Shape.OPEN
            boxes = tuple(joint.box for joint in crossed)
            parts.append(Part(shape, tuple(_in_order(arcs)), boxes, tuple(members[group]), joints=tuple(crossed)))
        return (*parts, *(Part(Shape.POINT, (), (cell.box,), (), cell.zero) for cell in self._points))

    def _is_open_at(self, vertex: Vertex) -> bool:
        """Whether a vertex is on an undecided box."""
        spot = self.place(vertex)

        def is_in(box: Box) -> bool:
            return all(low <= t <= high for t, (low, high) in zip(spot, box, strict=True))

        return any(is_in(hull) and any(map(is_in, own)) for hull, own in self._clusters)

    @cached_property
    def _clusters(self) -> list[tuple[Box, list[Box]]]:
        return clusters(self.undecided)

    def place(self, vertex: Vertex) -> Place:
        """Both coordinates of a zero on a line of the subdivision."""
        own = self._line(vertex.direction, vertex.value)[vertex.index] if vertex.other is None else vertex.other
        return (vertex.value, own) if vertex.direction == 0 else (own, vertex.value)

    def points(self, arc: Arc, count: int = 4) -> list[tuple[mpq, mpq]]:
        """Points near an arc, for pictures: this many steps, with points computed to `DRAWN_BITS` bits."""
        low = arc.low.refine(8)[1] if isinstance(arc.low, Root) else arc.low
        high = arc.high.refine(8)[0] if isinstance(arc.high, Root) else arc.high
        points = []
        for k in range(count + 1):
            y = mpq(low + (high - low) * mpq(k, count))
            a, b = arc.box[arc.direction]
            start, end = (self._value(arc.direction, x, y) for x in (a, b))
            for _ in range(DRAWN_BITS):
                middle = (a + b) / 2
                value = self._value(arc.direction, middle, y)
                a, b = (middle, b) if value * (start or -end) > 0 else (a, middle)
            x = mpq((a + b) / 2)
            points.append((x, y) if arc.direction == 0 else (y, x))
        return points


@dataclass
class _Joined:
    """The sets of vertices that belong together."""

    vertices: Iterable[Vertex]
    parents: dict[Vertex, Vertex] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.parents = {vertex: vertex for vertex in self.vertices}

    def root(self, vertex: Vertex) -> Vertex:
        """The representative of all vertices joined with a vertex."""
        self.parents.setdefault(vertex, vertex)
        while self.parents[vertex] != vertex:
            vertex = self.parents[vertex]
        return vertex

    def join(self, one: Vertex, other: Vertex) -> None:
        """Join the sets of two vertices."""
        self.parents[self.root(one)] = self.root(other)


def zeros_on_line(form: PatchForm, direction: int, value: mpq) -> ZeroSet:
    """The zeros of a form on a line across the whole square."""
    edge = form.on_line(direction, value)
    return zeros(BSpline.from_forms(len(edge) - 1, Mesh([mpq(0), mpq(1)]), (), [(from_integers(edge), ONE)]))


def grid(form: PatchForm, cells: Sequence[Box]) -> Iterator[Box]:
    """The boxes of the square cut along the borders of cells, and once more."""
    cuts = []
    for k in (0, 1):
        ends = {mpq(0), mpq(1), *(end for cell in cells for end in cell[k])}
        first = _first_cut(rational_lines(form, k))
        if not any(cell[k][0] <= first <= cell[k][1] for cell in cells):
            ends.add(first)
        cuts.append(list(starmap(Interval, pairwise(sorted(ends)))))
    return (Box(side, other) for side in cuts[0] for other in cuts[1])


def is_small(box: Box, form: PatchForm) -> bool:
    """Whether a box is not halved any more: both sides are short, and shorter where the coefficients of the form on the
    patch differ in size, as on narrow patches.
    """
    sizes = [int(x).bit_length() for x in form.entries if x]
    return max(side.width for side in box) <= mpq(1, 1 << DEPTH // 2 + max(sizes) - min(sizes))


def _first_cut(lines: Sequence[mpq]) -> mpq:
    """A value at which to cut, such that halving both parts never cuts along a line of zeros."""

    def met(cut: mpq, line: mpq) -> bool:
        place = line / cut if line < cut else (line - cut) / (1 - cut)
        return int(place.denominator).bit_count() == 1

    return next((cut for cut in FIRST_CUTS if not any(met(cut, line) for line in lines)), FIRST_CUTS[0])


def _ends(arcs: Sequence[Arc], joints: Sequence[Joint]) -> Counter[Vertex]:
    ends = Counter(vertex for arc in arcs for vertex in (arc.first, arc.last))
    ends.update(vertex for joint in joints for pair in joint.links for vertex in pair)
    return ends


def _shape(arcs: Sequence[Arc], joints: Sequence[Joint]) -> Shape:
    if any(joint.crossed for joint in joints):
        return Shape.CROSSED
    ends = _ends(arcs, joints)
    if not ends:
        return Shape.POINT
    return Shape.LOOP if all(count == 2 for count in ends.values()) else Shape.ARC


def _in_order(arcs: Sequence[Arc]) -> Iterator[Arc]:
    """The arcs of a part, each beginning where an earlier one ends, as long as the way is unique."""
    remaining = list(arcs)
    ends = Counter(vertex for arc in arcs for vertex in (arc.first, arc.last))
    while remaining:
        start = next((i for i, arc in enumerate(remaining) if 1 in (ends[arc.first], ends[arc.last])), 0)
        arc = remaining.pop(start)
        at = arc.first if ends[arc.last] == 1 and ends[arc.first] != 1 else arc.last
        yield arc
        while (
            i := next((i for i, other in enumerate(remaining) if at in (other.first, other.last)), None)
        ) is not None:
            arc = remaining.pop(i)
            at = arc.last if arc.first == at else arc.first
            yield arc
