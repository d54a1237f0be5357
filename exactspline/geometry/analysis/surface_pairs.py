"""The questions about two surfaces in space: entries of the registry of questions.

Where borders have an arc in common, the patches along the arc become patches of one surface, with the arc as a knot
line (`exactspline.geometry.surfaces.joints`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import product
from typing import NamedTuple

from exactspline.bivariate.borders import EDGES, Edge, line_of
from exactspline.errors import ReachError
from exactspline.geometry.curves.angles import degrees
from exactspline.geometry.pairs.intersections import intersections
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.geometry.surfaces.joints import SurfaceJointKind, joints, special_places
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import UNIT, Interval
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Inspected, Of, question
from exactspline.reals.real import Real
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import surface_of


class SurfacePair(Inspected):
    """Two surfaces in space.

    >>> from exactspline import example
    >>> SurfacePair(example("cylinder"), example("cone"))
    <SurfacePair of cylinder and cone>
    """

    def __init__(self, first: NurbsSurface, second: NurbsSurface) -> None:
        self.surfaces = [SurfaceForms(surface_of(each)).surface for each in (first, second)]
        super().__init__(*self.surfaces)

    @one_line
    def __repr__(self) -> str:
        return f"<SurfacePair of {' and '.join(each.name or 'a surface' for each in self.surfaces)}>"

    @question(Of.TWO_SURFACES, answered=Answered.NUMBERS, on_request=True)
    def common_borders(self) -> tuple[NamedNumbers, ...]:
        """The arcs that borders of two surfaces have in common, and how the surfaces meet there: in a crease, folded
        back, with a common tangent plane, with common curvatures.

        Each arc is given by the parameters of both borders at its ends, with the order of geometric continuity up to 2,
        and for a crease with the angle between the tangent planes, in degrees, where it is constant. Then follow the
        points of the arc at which the tangent planes of a crease agree, or the surface folds back, and the points at
        which a surface has no tangent plane. If the parameters are not linear functions of each other, only a `common
        arc` is reported, and the order is 0 or more. Borders that are points are ignored.

        >>> from exactspline import example
        >>> from exactspline.geometry.analysis.surface_pairs import SurfacePair
        >>> (found,) = SurfacePair(*example("paraboloid").split("v", 0)).common_borders
        >>> found
        <continuous curvature: first from -1, first to 1, second from -1, second to 1>
        >>> found.facts
        {'first border': 'v = 0', 'second border': 'v = 0', 'order': 2}

        Raises `ReachError` if it would take too much work to decide whether borders have an arc in common.
        """
        borders = ([x for x in (_Border(each, edge) for edge in EDGES) if not x.is_point] for each in self.surfaces)
        return tuple(row for pair in product(*borders) for row in _along(*pair))


class _Border(NamedTuple):
    """A border of a surface."""

    surface: NurbsSurface
    edge: Edge

    def __str__(self) -> str:
        return f"{'uv'[self.edge.direction]} = {text(self.edge.value(self.surface.domain))}"

    @property
    def curve(self) -> Nurbs:
        """The border as a curve."""
        return self.surface.isocurve(line_of(self.edge), self.edge.value(self.surface.domain))

    @property
    def is_point(self) -> bool:
        """Whether the border is a single point."""
        return len({*self.curve.control_points}) == 1

    def beside(self, ends: tuple[mpq, mpq], onto: Interval, *, last: bool) -> list[TensorSpline]:
        """Coordinates and denominator of the patch along a part of the border, on the unit interval times another
        interval; the border is the last line or the first line.
        """
        (k, end), (p, w) = self.edge, (self.surface.p, self.surface.w)
        across = self.surface.meshes[k].breaks[-2:] if end else self.surface.meshes[k].breaks[1::-1]
        across = across if last else across[::-1]
        parts = [f.along(k, partial(_run, across, UNIT.first)).along(1 - k, partial(_run, ends, onto)) for f in (*p, w)]
        sign = 1 if w(*(side.low for side in self.surface.domain)) > 0 else -1
        return [(f.transposed() if k else f).scaled(sign) for f in parts]


def _run(ends: Sequence[mpq], onto: Interval, f: BSpline) -> BSpline:
    """A part of a spline, traversed from one end to the other, over an interval."""
    part = f.restrict(min(ends), max(ends))
    return (part if ends[0] < ends[1] else part.reverse()).reparametrize(*onto)


#: The names of the parameters at the ends of an arc.
ENDS = ("first from", "first to", "second from", "second to")


def _common_arcs(first: _Border, second: _Border) -> list[list[Real]]:
    """The arcs that two borders have in common, by the parameters at their ends (`ENDS`), with increasing parameters of
    the first border. The arcs are found from knot to knot; neighbouring arcs with the same linear relation of the
    parameters are joined.
    """
    found, arcs = intersections(first.curve, second.curve), list[list[Real]]()
    if found.undecided:
        raise ReachError(f"whether {first} and {second} have an arc in common", remedy="restrict the surfaces")
    for one in sorted(found.everywhere, key=lambda one: min(one.first)):
        (a, b), (c, d) = (ends[:: -1 if one.reversed else 1] for ends in (one.first, one.second))
        if arcs and arcs[-1][1::2] == [a, c] and (d - c) * (a - arcs[-1][0]) == (b - a) * (c - arcs[-1][2]):
            arcs[-1][1::2] = b, d
        else:
            arcs.append([a, b, c, d])
    return arcs


def _pieces(first: _Border, second: _Border) -> list[tuple[list[Real], SurfaceForms | None]]:
    """The arcs with the patches along them. Where the parameters are not linear functions of each other, there are no
    patches, and neighbouring arcs are joined.
    """
    found = list[tuple[list[Real], SurfaceForms | None]]()
    for arc in _common_arcs(first, second):
        forms = _as_one(first, second, *(x.exact for x in arc))
        if forms and any(joint.kind is SurfaceJointKind.TORN for joint in joints(forms, [], [Along.U])):
            forms = None
        if found and not (forms or found[-1][1]) and found[-1][0][1::2] == arc[::2]:
            found[-1][0][1::2] = arc[1::2]
        else:
            found.append((arc, forms))
    return found


def _along(first: _Border, second: _Border) -> Iterator[NamedNumbers]:
    """How two surfaces meet along the arcs that their borders have in common."""
    names: dict[str, object] = {"first border": str(first), "second border": str(second)}
    for arc, forms in _pieces(first, second):
        if not forms:
            yield NamedNumbers("common arc", dict(zip(ENDS, arc, strict=True)), names | {"order": "unknown"})
            continue
        start, rate = arc[2], (arc[3] - arc[2]) / (arc[1] - arc[0])
        for joint in joints(forms, [], [Along.U]):
            ends = [Real(t) for t in joint.interval]
            values = dict(zip(ENDS, [*ends, *(start + (t - arc[0]) * rate for t in ends)], strict=True))
            values |= {} if joint.angle is None else {"angle": degrees(joint.angle)}
            yield NamedNumbers(joint.kind, values, names | {"order": "unknown" if joint.order is None else joint.order})
        for t, kind in special_places(forms):
            yield NamedNumbers(kind, {"first": t, "second": start + (t - arc[0]) * rate}, names)


def _as_one(
    first: _Border, second: _Border, a: mpq | None, b: mpq | None, c: mpq | None, d: mpq | None
) -> SurfaceForms | None:
    """The patches of two surfaces along an arc of their borders as one surface, with the arc as its only knot line
    across u; None where the ends of the arc are not rational.
    """
    if a is None or b is None or c is None or d is None:
        return None
    sides = with_common_knots(
        first.beside((a, b), Interval(a, b), last=True) + second.beside((c, d), Interval(a, b), last=False)
    )
    degree, (_, along), nets = sides[0].degree, sides[0].knots, [f.control_points for f in sides]
    across = [t for t in range(3) for _ in range(degree[0] + 1)]
    *p, w = [TensorSpline(degree, across, along, nets[k] + nets[k + 4]) for k in range(4)]
    return SurfaceForms(NurbsSurface.from_splines(p, w))
