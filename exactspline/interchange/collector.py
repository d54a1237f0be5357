"""Collects the curves of a file: a curve that cannot be built is listed as skipped, and reading continues."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from itertools import cycle, islice
from typing import Any, NamedTuple, TypeVar

from exactspline.errors import CurveFileError, ExactSplineError, ShapeError, counted, nearest
from exactspline.interchange.format import homogeneous
from exactspline.interchange.numbers import decimal
from exactspline.interchange.records import LARGER, NamedCurve, Reading, Skipped, Source, work
from exactspline.interchange.segments import Point, Segment, distance_text, joined_segments, moved
from exactspline.numbers.exact import mpq
from exactspline.splines.control_points import projected
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

# ---- periods


P = TypeVar("P")


class Whole(NamedTuple):
    """A full knot vector, the number of control points by which those of a file are to be continued, and notes."""

    knots: Sequence[mpq]
    more: int = 0
    notes: tuple[str, ...] = ()

    def continued(self, entries: Sequence[P]) -> list[P]:
        """The control points, or the weights, of the whole curve: the first are repeated."""
        return [*entries, *islice(cycle(entries), self.more)]


def whole(degree: int, knots: Sequence[mpq], count: int, periodic: bool = False) -> Whole:
    """The full knot vector of a curve of which a file lists some knots and `count` control points.

    A closed curve may be listed by one period, the first and the last knot e times each: count + e knots. Or all its
    knots are listed, and repeated control points are omitted. All other data are unchanged.

    >>> whole(3, [mpq(t) for t in range(5)], 4)  # doctest: +ELLIPSIS
    Whole(knots=[mpq(-3,1), ..., mpq(7,1)], more=3, notes=('periodic, listed by one period: ...',))
    >>> knots, more, _ = whole(2, [mpq(t) for t in range(-2, 6)], 3)
    >>> [int(t) for t in knots], more
    ([-2, -1, 0, 1, 2, 3, 4, 5], 2)
    """
    ends, lacking = len(knots) - count, len(knots) - count - degree - 1
    if lacking == 0 and periodic and knots[0] == knots[degree]:
        return Whole(knots, 0, ("flagged periodic, but its knots are clamped: read as written",))
    if count and 1 <= ends <= degree and _are_ends(knots, ends):
        return _unrolled(knots, count, degree + 1 - ends)
    if 1 <= lacking <= degree and (periodic or len({b - a for a, b in zip(knots, knots[count:], strict=False)}) == 1):
        return Whole(knots, lacking, (f"periodic: its first {lacking} control points are repeated",))
    return Whole(knots)


def _are_ends(knots: Sequence[mpq], times: int) -> bool:
    """Whether the first and the last knot differ and have exactly this multiplicity."""
    ends = [sum(t == end for t in knots) for end in (knots[0], knots[-1])]
    return knots[0] < knots[-1] and ends == [times, times]


def _unrolled(knots: Sequence[mpq], count: int, more: int) -> Whole:
    period, found = knots[-1] - knots[0], list(knots)
    for _ in range(more):
        found = [found[count - 1] - period, *found, found[len(found) - count] + period]
    remark = f"periodic, listed by one period: the knots are continued, {more} control points are repeated"
    return Whole(found, more, (remark,))


def domain(degree: int, knots: Sequence[mpq]) -> tuple[mpq, mpq]:
    """The ends of the domain; 0 and 0 for too few knots."""
    return (knots[degree], knots[-degree - 1]) if len(knots) >= 2 * degree + 2 else (mpq(0), mpq(0))


def used(ends: tuple[mpq, mpq], start: mpq, end: mpq) -> tuple[tuple[mpq, mpq] | None, list[str]]:
    """The part of a domain with these ends that an entity uses, None for all of it, and notes on it.

    >>> used((mpq(0), mpq(1)), mpq(1, 4), mpq(2))[0]
    (mpq(1,4), mpq(1,1))
    """
    low, high = max(start, ends[0]), min(end, ends[1])
    if (start, end) == ends or not ends[0] < ends[1]:
        return None, []
    asked = f"the entity uses the parameters from {start} to {end}"
    if not start < end:
        return None, [f"{asked}, which run backwards: the whole spline is read"]
    if not low < high:
        return None, [f"{asked}, which are not in the domain: the whole spline is read"]
    beyond = "" if (low, high) == (start, end) else f", of which only {ends[0]} to {ends[1]} is in the domain"
    return (low, high), [f"{asked}{beyond}"]


Points = Sequence[Sequence[mpq]]
#: The remedy for an entity of a kind that a reader does not know.
UNREAD = "not read; write it as a spline"
EQUAL = "written as rational, but its weights are equal: a polynomial curve"
T = TypeVar("T")


def _net(entries: Sequence[T], counts: tuple[int, int], u_fastest: bool) -> list[list[T]]:
    """Entries in rows along u."""
    m, n = counts
    steps = (1, m) if u_fastest else (n, 1)
    return [[entries[i * steps[0] + j * steps[1]] for j in range(n)] for i in range(m)]


def _chained(curves: Sequence[Nurbs], within: mpq | None, notes: list[str]) -> tuple[int, list[mpq], list[Point]]:
    """Degree, knots and homogeneous control points of consecutive curves: each begins at the end of the previous curve,
    or so near to this end that its beginning may be moved there.
    """
    degree, knots, points = max(curve.degree for curve in curves), list[mpq](), list[Point]()
    for each in curves:
        curve = each.restrict(*each.domain).elevate_degree(degree - each.degree)
        rows = [homogeneous(*pair) for pair in zip(curve.control_points, curve.weights, strict=True)]
        end, start = projected(points[-1] if points else rows[0]), projected(rows[0])
        if end != start:
            notes.append(moved(end, start, within, "the part before"))
        factor = points[-1][-1] / rows[0][-1] if points else mpq(1)
        shift = knots[-1] - curve.domain[0] if knots else mpq(0)
        knots = [*knots[:-1], *(t + shift for t in list(curve.knots)[(degree + 1) * bool(knots) :])]
        points += [tuple(x * factor for x in row) for row in rows[bool(points) :]]
    return degree, knots, points


class Collector:
    """The curves and the skipped entities of one file."""

    def __init__(self, format_name: str, source: Source) -> None:
        self.format, self.source, self.limits = format_name, source, source.limits
        self.curves: list[NamedCurve] = []
        self.surfaces: list[NurbsSurface] = []
        self.skipped: list[Skipped] = []
        self._notes: dict[str, None] = {}
        self._objects = 0
        #: Curves by their source, and the sources of the curves that are parts of other curves.
        self._read: dict[str, Nurbs] = {}
        self._parts: set[str] = set()

    def reading(self) -> Reading:
        """The curves, surfaces, skipped entities and notes collected so far."""
        curves = tuple(each for each in self.curves if each.curve.source not in self._parts)
        return Reading(self.format, curves, tuple(self.skipped), tuple(self._notes), tuple(self.surfaces))

    def taken(self) -> Reading:
        """The curves, surfaces, skipped entities and notes collected since the last call."""
        collected = self.reading()
        self.curves, self.surfaces, self.skipped, self._notes = [], [], [], {}
        return collected

    def skip(self, what: str, where: str, why: str = UNREAD, *, curve: bool = True) -> None:
        """Record an entity that is not read; `curve` states whether a curve is missing as a result."""
        self.count(1)
        self.skipped.append(Skipped(what, where, why, curve, (len(self.curves), len(self.surfaces))))

    @contextmanager
    def skipping(self, what: str, where: str, *, curve: bool = True, damaged: str = "") -> Iterator[None]:
        """Record an entity as not read if reading it fails, also if another library fails on `damaged` data."""
        try:
            yield
        except ExactSplineError as error:
            self.skip(what, where, str(error), curve=curve)
        except Exception as error:
            if not damaged:
                raise
            self.skip(what, where, f"{damaged} ({type(error).__name__})", curve=curve)

    def see_that_part_exists(self, names: Collection[str]) -> None:
        """Raise `CurveFileError` if the requested part has none of these names."""
        if (part := self.source.part) and part not in names:
            remedy = nearest(part, filter(None, names))
            raise CurveFileError(f"{self.format}: there is no part {part[:40]!r}", remedy=remedy)

    def note(self, text: str) -> None:
        """Record a note that applies to all curves of the file; repetitions are dropped."""
        self._notes[text] = None

    def unit(self, name: str) -> None:
        """Note the unit of length of the file, if it has one."""
        if name:
            self.note(f"lengths in {name}: read as written")

    def room(self, objects: int) -> None:
        """Raise `ShapeError` if this many further objects would exceed the limit; called before they are built."""
        if self._objects + objects > self.limits.objects:
            self.count(objects)

    def count(self, objects: int) -> None:
        """Count objects; raises `ShapeError` when there are more than the limits allow."""
        self._objects += objects
        if objects < 0 or self._objects > self.limits.objects:
            raise ShapeError(f"more than {self.limits.objects} objects", remedy=LARGER)

    def numbers(self, texts: Sequence[str]) -> list[mpq]:
        """Decimals, counted before they are read."""
        self.count(len(texts))
        return [decimal(text, self.limits) for text in texts]

    def add_segments(
        self, what: str, where: str, segments: Sequence[Segment], name: str = "", notes: Sequence[str] = ()
    ) -> None:
        """Build the curve made of segments; it is polynomial if all weights are 1."""
        self._add_homogeneous(what, where, *joined_segments(segments), name, notes)

    def _add_homogeneous(
        self, what: str, where: str, degree: int, knots: list[mpq], points: Points, name: str, notes: Sequence[str]
    ) -> None:
        rational = any(point[-1] != 1 for point in points)
        rows = points if rational else [point[:-1] for point in points]
        self.add(what, where, degree, knots, rows, homogeneous=rational, name=name, notes=notes)

    def add(
        self,
        what: str,
        where: str,
        degree: int,
        knots: Sequence[mpq],
        points: Points,
        weights: Sequence[mpq] | None = None,
        *,
        homogeneous: bool = False,
        flagged: Collection[str] = (),
        name: str = "",
        notes: Sequence[str] = (),
        within: tuple[mpq, mpq] | None = None,
    ) -> None:
        """Build one curve (see `built`); data that do not define one are recorded as skipped, with the reason."""
        with self.skipping(what, where):
            more: dict[str, Any] = {"homogeneous": homogeneous, "flagged": flagged, "name": name, "notes": notes}
            self.take(self.built(where, degree, knots, points, weights, **more), within)

    def built(
        self,
        where: str,
        degree: int,
        knots: Sequence[mpq],
        points: Points,
        weights: Sequence[mpq] | None = None,
        *,
        homogeneous: bool = False,
        flagged: Collection[str] = (),
        name: str = "",
        notes: Sequence[str] = (),
    ) -> NamedCurve:
        """A curve with its notes; `points` are Cartesian, or (w x, w y, …, w) when `homogeneous`. The data may be
        listed as in `whole`. The property `flagged`, periodic or closed, is compared with the data.
        """
        self.count(len(points) + len(knots))
        self._check_degree(degree)
        full = whole(degree, knots, len(points), "periodic" in flagged)
        self.room(full.more)
        points, knots = full.continued(points), full.knots
        weights = None if weights is None else full.continued(weights)
        self._check(degree, knots, points, weights or ())
        name, source = name or f"{self.format} {len(self.curves) + 1}", f"{self.source.name} {where}".strip()
        if homogeneous:
            curve = Nurbs.from_homogeneous(degree, knots, points, name=name, source=source)
        else:
            curve = Nurbs(degree, knots, points, weights=weights, name=name, source=source)
        remarks = [*notes, *full.notes]
        if "closed" in flagged and not curve.closed:
            ends = zip(curve(curve.domain[0]), curve(curve.domain[1], "left"), strict=True)
            apart = distance_text([a - b for a, b in ends])
            remarks.append(f"flagged closed, but its ends are {apart} apart: read as written")
        if curve.polynomial and (homogeneous or weights is not None):
            remarks.append(EQUAL)
        return NamedCurve(name, curve, tuple(remarks))

    def take(self, made: NamedCurve, within: tuple[mpq, mpq] | None = None, *notes: str) -> None:
        """Add a curve, or the part of it that the file uses."""
        curve = made.curve if within in (None, made.curve.domain) else made.curve.restrict(*within)
        if (curve.name, curve.source) != (made.name, made.curve.source):
            data = curve.degree, curve.knots, curve.control_points, curve.weights
            curve = Nurbs(*data, name=made.name, source=made.curve.source)
        self._read[curve.source] = curve
        self.curves.append(NamedCurve(made.name, curve, tuple(dict.fromkeys([*made.notes, *notes]))))

    def join(self, what: str, where: str, parts: Sequence[tuple[str, bool]], name: str = "") -> None:
        """Replace the curves that were read at these places, some of them reversed, by one curve that runs through all
        of them, over their parameters one after another. If that is impossible, a note says so, and the curves are
        kept.
        """
        sources, count = [f"{self.source.name} {place}".strip() for place, _ in parts], len(self.curves)
        found = [self._read[source] for source in sources if source in self._read]
        notes = [f"made of {counted(len(parts), 'curve')}"]
        try:
            if len(found) < len(parts) or len({curve.dimension for curve in found}) != 1:
                raise ShapeError("a part that is not read, or in another dimension", remedy="write it as a spline")
            turned = [x if forwards else x.reverse() for x, (_, forwards) in zip(found, parts, strict=True)]
            chain = _chained(turned, self.source.within, notes)
        except ShapeError as error:
            self.skip(what, where, f"its parts are read as separate curves: {error}", curve=False)
        else:
            self._add_homogeneous(what, where, *chain, name, notes)
            self._parts.update(sources if len(self.curves) > count else ())

    def add_surface(
        self,
        what: str,
        where: str,
        degree: tuple[int, int],
        knots: tuple[Sequence[mpq], Sequence[mpq]],
        points: Points,
        weights: Sequence[mpq] | None = None,
        *,
        homogeneous: bool = False,
        u_fastest: bool = True,
        name: str = "",
        notes: Sequence[str] = (),
        within: tuple[tuple[mpq, mpq], tuple[mpq, mpq]] | None = None,
    ) -> None:
        """Build one surface of control points in the order of the file, along u first or along v first; otherwise as
        `add`.
        """
        self.count(len(points) + sum(map(len, knots)))
        rows = list(points)
        if homogeneous:
            weights, rows = [row[-1] for row in rows], [projected(row) for row in rows]
        counts = self._check_net(degree, knots, rows, weights or ())
        plain = None if weights is None else _net(weights, counts, u_fastest)
        net, source = _net(rows, counts, u_fastest), f"{self.source.name} {where}".strip()
        name = name or f"{self.format} surface {len(self.surfaces) + 1}"
        surface = NurbsSurface(degree, *knots, net, plain, name=name, source=source)
        self.surfaces.append(surface if within in (None, surface.domain) else surface.restrict(*within))
        for note in notes:
            self.note(f"{where}: {note}")

    def add_spline(
        self,
        what: str,
        where: str,
        degrees: Sequence[int],
        knots: Sequence[Sequence[mpq]],
        points: Points,
        weights: Sequence[mpq] | None = None,
        *,
        homogeneous: bool = False,
        u_fastest: bool = True,
        flagged: Collection[str] = (),
        name: str = "",
        notes: Sequence[str] = (),
    ) -> None:
        """Build one curve or one surface, by the number of its parameters."""
        more: dict[str, Any] = {"homogeneous": homogeneous, "name": name, "notes": notes}
        if len(degrees) == 1:
            self.add(what, where, degrees[0], knots[0], points, weights, flagged=flagged, **more)
        else:
            sides = (degrees[0], degrees[1]), (knots[0], knots[1])
            self.add_surface(what, where, *sides, points, weights, u_fastest=u_fastest, **more)

    def _check_net(
        self, degree: tuple[int, int], knots: Sequence[Sequence[mpq]], points: Points, weights: Sequence[mpq]
    ) -> tuple[int, int]:
        """The numbers of control points along u and v; `ShapeError` for other numbers, or too many."""
        m, n = (len(vector) - d - 1 for vector, d in zip(knots, degree, strict=True))
        if min(m, n) < 1 or m * n != len(points):
            problem = f"{counted(len(points), 'control point')} for {m} × {n}"
            raise ShapeError(problem, where="control_points", remedy="give as many as the knots require")
        for d, vector in zip(degree, knots, strict=True):
            self._check(d, vector, [*points[: len(vector) - d - 1]], weights)
        return m, n

    def keep(self, curve: Nurbs, notes: Sequence[str] = (), *, rational: bool = False) -> None:
        """Take a curve that has been built, written as rational or not.

        Raises `ShapeError` for one beyond the limits.
        """
        self._check(curve.degree, curve.knots.knots, curve.control_points, curve.weights)
        remarks = [*notes, EQUAL] if curve.polynomial and rational else notes
        self.take(NamedCurve(curve.name, curve, tuple(remarks)))

    def _check_degree(self, degree: int) -> None:
        if not 0 <= degree <= self.limits.degree:
            raise ShapeError(f"degree {degree}", where="degree", remedy=f"at most {self.limits.degree} is read")

    def _check(self, degree: int, knots: Sequence[mpq], points: Points, weights: Sequence[mpq]) -> None:
        self._check_degree(degree)
        if not points or len(knots) != len(points) + degree + 1:
            problem = f"{counted(len(points), 'control point')} for {counted(len(knots), 'knot')} of degree {degree}"
            remedy = f"there must be {max(len(knots) - degree - 1, 0)} (knots − degree − 1)"
            if len(knots) == len(points) + degree - 1:
                remedy = "as openNURBS writes them, without the first and the last: repeat both"
            raise ShapeError(problem, where="control_points", remedy=remedy)
        numbers = [*knots, *weights, *(x for row in points for x in row)]
        longest = max(x.numerator.bit_length() + x.denominator.bit_length() for x in numbers)
        if work(degree, knots, longest) > self.limits.work:
            problem = f"degree {degree}, {counted(len(points), 'control point')}, {longest} bits: too much work"
            raise ShapeError(problem, remedy=LARGER)
