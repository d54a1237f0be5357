"""All points of a curve nearest to a given point, and the least distance, exactly.

A nearest point is an end, a knot, or a zero of the derivative of the squared distance at which the derivative becomes
positive. Segments whose boxes are farther away than a known point are skipped. The squared distances of the other
candidates are compared in ball arithmetic, and exactly where this does not decide.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import reduce

from flint import ctx, fmpz, fmpz_poly

from exactspline.errors import ShapeError, as_items, counted
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.pairs.box_tree import IntegerBox, Segments, segments_of, shift_for
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Number, lcm, mpq, rational
from exactspline.numbers.intervals import Interval, Side, joined
from exactspline.numbers.once import cached_property
from exactspline.polynomials.bernstein import ONE, divide_u_plus_v
from exactspline.polynomials.common_arcs import Coordinate, RationalMap
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.zero_places import FIRST, SUSPICIOUS, Place
from exactspline.polynomials.zero_places import at as at_rational
from exactspline.reals.real import Real, square_root
from exactspline.roots.answers import Answer, CurvePiece, OneNumber
from exactspline.roots.segment_forms import SegmentForms, root_at
from exactspline.roots.values import evaluate, value_at
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of


@dataclass(frozen=True)
class NearestPoint(OneNumber):
    """A point of a curve at the least distance, by its parameter; where the curve jumps, the limit from this `side`."""

    parameter: Real
    curve: Nurbs
    _found: _Candidate = field(repr=False, compare=False)
    side: Side = Side.RIGHT

    @cached_property
    def squared(self) -> Real:
        """The square of the distance, exactly."""
        return self._found.squared

    def __getstate__(self) -> dict[str, object]:
        return {"parameter": self.parameter, "curve": self.curve, "side": self.side, "squared": self.squared}

    @property
    def distance(self) -> Real:
        """The distance, exactly."""
        return square_root(self.squared)

    @property
    def point(self) -> tuple[mpq | Real, ...]:
        """The coordinates, exactly."""
        return evaluate(self.curve, self.parameter, side=self.side)

    def __repr__(self) -> str:
        return f"<nearest point at {self.parameter.shortly()}: distance {self.distance.shortly()}>"


class Nearest(Answer[NearestPoint, CurvePiece], Displayed):
    """All points of a curve at the least distance from a point, and `everywhere` the pieces at this constant distance:
    arcs of circles around the point.
    """


def nearest(curve: Nurbs, point: Iterable[Number]) -> Nearest:
    """The points of a curve that are nearest to a point: all of them, exactly.

    >>> from exactspline import Nurbs, example
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])  # y = x²
    >>> nearest(parabola, (0, 1))
    [<nearest point at (2 - √2)/4: distance √3/2>, <nearest point at (2 + √2)/4: distance √3/2>]
    >>> nearest(parabola, (0, "1/4"))
    [<nearest point at 1/2: distance 1/4>]
    >>> nearest(example("circle"), (0, 0))
    everywhere on [0, 4]

    Raises `ShapeError` for a point of another dimension.
    """
    point, flat = tuple(as_items(point, "a point")), in_the_plane(curve_of(curve))
    curve = flat if len(point) == flat.dimension else curve
    delta = exact_point(curve, point)
    own = segments_of(curve)
    found = [c for i in _near_segments(own, delta) for c in _candidates(curve, i, own.forms[i], delta)]
    least = _least(found)
    arcs = joined(c.side for c in least if c.place is None)
    low, high = curve.domain
    ends = {low if end == high and curve.closed else end for arc in arcs for end in arc}
    at_rational_parameters: dict[tuple[mpq, Side], NearestPoint] = {}
    points: list[NearestPoint] = []
    for c in least:
        if c.place is None:
            continue
        if c.place.exact is None:
            points.append(NearestPoint(c.parameter, curve, c))
            continue
        t = c.side.at(c.place.exact)
        t = low if t == high and curve.closed else t
        if t not in ends:
            side = Side.LEFT if c.place.exact == 1 and t != low and curve(t, Side.LEFT) != curve(t) else Side.RIGHT
            at_rational_parameters.setdefault((t, side), NearestPoint(Real(t), curve, c, side))
    points += at_rational_parameters.values()
    if len(points) > 1:
        points.sort(key=lambda found: found.parameter)
    return Nearest(tuple(points), over_the_seam(curve, arcs))


def over_the_seam(curve: Nurbs, arcs: list[Interval]) -> tuple[CurvePiece, ...]:
    """Arcs as pieces of a curve; on a closed curve the last and the first arc are one piece if both end at the seam.

    >>> from exactspline import example
    >>> over_the_seam(example("circle"), [Interval(mpq(0), mpq(1)), Interval(mpq(3), mpq(4))])
    (<CurvePiece [3, 4] ∪ [0, 1]>,)
    """
    low, high = curve.domain
    if curve.closed and len(arcs) > 1 and (arcs[0].low, arcs[-1].high) == (low, high):
        return *(CurvePiece((arc,)) for arc in arcs[1:-1]), CurvePiece((arcs[-1], arcs[0]))
    return tuple(CurvePiece((arc,)) for arc in arcs)


def exact_point(curve: Nurbs, point: Iterable[Number]) -> tuple[mpq, ...]:
    """The coordinates of a point; raises `ShapeError` if the dimensions of point and curve differ."""
    exact = tuple(rational(x) for x in as_items(point, "a point"))
    if len(exact) != curve_of(curve).dimension:
        raise ShapeError(f"a point with {counted(len(exact), 'coordinate')}", remedy=f"give {curve.dimension}")
    return exact


def _near_segments(segments: Segments, delta: tuple[mpq, ...]) -> list[int]:
    """The indices of the segments that may have the nearest point."""
    shift = shift_for(segments)
    scaled = [x * (1 << shift) for x in delta]
    bounds = [_bounds(box, scaled) for box in segments.boxes(shift).boxes]
    nearest_far = min((far for _, far in bounds if far is not None), default=None)
    return [i for i, (near, _) in enumerate(bounds) if nearest_far is None or near <= nearest_far]


def _bounds(box: IntegerBox, point: list[mpq]) -> tuple[mpq, mpq | None]:
    """Bounds of the squared distance between a point and the points of a box."""
    if box is None:
        return mpq(0), None
    near = far = mpq(0)
    for (low, high), x in zip(box, point, strict=True):
        near += max(low - x, x - high, mpq(0)) ** 2
        far += max(abs(low - x), abs(high - x)) ** 2
    return near, far


class _Candidate:
    """A local minimum of the distance on a segment (without a place: the whole segment, on which it is constant)."""

    def __init__(self, place: Place | None, side: Interval, squared: RationalMap) -> None:
        self.place, self.side, self.value = place, side, Coordinate(squared, place or at_rational(mpq(0)))

    @property
    def parameter(self) -> Real:
        """The parameter on the curve."""
        return Real(self.side.low) if self.place is None else root_at(self.place, self.side)

    @cached_property
    def squared(self) -> Real:
        """The squared distance."""
        if (exact := self.value.exact) is not None:
            return Real(exact)
        mesh, of = Mesh(self.side), self.value.function
        top, bottom = (BSpline.from_forms(of.degree, mesh, (), [(c, ONE)]) for c in (of.top, of.bottom))
        return value_at(top, bottom, self.parameter)


def _candidates(curve: Nurbs, i: int, segment: SegmentForms, delta: tuple[mpq, ...]) -> Iterator[_Candidate]:
    side = Interval(*curve.breakpoints[i : i + 2])
    n, (*coordinates, w) = segment
    scale = fmpz(int(reduce(lcm, [x.denominator for x in delta])))
    chord = [x * scale - w * fmpz(int(d * int(scale))) for x, d in zip(coordinates, delta, strict=True)]
    top, bottom = sum((e * e for e in chord), fmpz_poly([])), w * w * (scale * scale)
    # the derivative of top/w², times w³
    slope, times = divide_u_plus_v(top.derivative() * w - 2 * top * w.derivative(), max(3 * n - 2, 0))
    squared = RationalMap(2 * n, top, bottom)
    if not slope:
        yield _Candidate(None, side, squared)
        return
    if w[0] < 0:
        slope = -slope
    isolation = isolate(slope, 3 * n - 2 - times)
    if isolation.signs[0] > 0:
        yield _Candidate(at_rational(mpq(0)), side, squared)
    for zero in isolation.inner:
        if zero.signs == (-1, 1):
            yield _Candidate(Place(zero), side, squared)
    if isolation.signs[1] < 0:
        yield _Candidate(at_rational(mpq(1)), side, squared)


def _least(found: list[_Candidate]) -> list[_Candidate]:
    """The candidates with the least squared distance."""
    bits = FIRST
    while len(found) > 1 and bits <= SUSPICIOUS:
        with ctx.workprec(3 * bits):
            balls = [c.value.near(bits) for c in found]
            bound = min((ball.upper() for ball in balls if ball.is_finite()), default=None)
            if bound is not None:
                found = [c for c, ball in zip(found, balls, strict=True) if not ball.lower() > bound]
        bits *= 2
    if len(found) < 2:
        return found
    least = min(c.squared for c in found)
    return [c for c in found if c.squared == least]
