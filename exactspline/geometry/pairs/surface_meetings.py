"""A surface with a point, a line, a plane: the nearest points, the common points, the section; and its bounding box.

The nearest points of a surface S to a point P are at common zeros of ``(S − P)·S_u`` and ``(S − P)·S_v``, on borders,
knot lines or at corners (`exactspline.bivariate.quotients`). A line meets a surface in the points at which two planes
through the line meet the surface.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from operator import add

from exactspline.bivariate import common_zeros as elimination
from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.quotients import minima, polynomials_on, quotient_on
from exactspline.bivariate.zeros import CommonZero, SurfacePlaces, ZeroCurves, ZeroKind, common_zeros, zero_curve
from exactspline.errors import ShapeError
from exactspline.geometry.pairs.distance import Point
from exactspline.numbers.exact import Number, mpq, text
from exactspline.one_line import one_line
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import as_form
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, square_root
from exactspline.roots.answers import OneNumber
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline


@dataclass(frozen=True, repr=False)
class NearestOnSurface(SurfacePlaces[Place], OneNumber):
    """All points of a surface at the least distance from a point: single points, and patches, edges, lines and curves
    all of whose points have this distance.
    """

    _number = "distance"
    squared: Real = field(kw_only=True)
    surface: NurbsSurface = field(kw_only=True, compare=False)

    @property
    def distance(self) -> Real:
        """The distance, exactly."""
        return square_root(self.squared)

    @property
    def feet(self) -> tuple[tuple[Real, ...], ...]:
        """The coordinates of the single points."""
        p, w = self.surface.p, self.surface.w
        return tuple(tuple(quotient_on(at.patches[0], x, w).at(at.zero) for x in p) for at in self.points)

    def _parts(self) -> list[str]:
        return [f"distance {self.distance.shortly()}", *super()._parts()]


@dataclass(frozen=True)
class LineMeeting(OneNumber):
    """A common point of a line and a surface: its parameters u and v, and the parameter of the line. The point is
    `touching` where the line is tangent to the surface, and at points without a tangent plane.
    """

    zero: CommonZero
    parameter: Real = field(compare=False)

    @one_line
    def __repr__(self) -> str:
        return f"{self.zero!r} and {self.parameter.shortly()} of the line"


def nearest(
    surface: NurbsSurface, point: Iterable[Number], closed: Callable[[], Sequence[Along]] = tuple
) -> NearestOnSurface:
    """The points of a surface that are nearest to a point; `closed` answers in which parameters it is closed.

    >>> from exactspline import example
    >>> found = nearest(example("hyperbolic_paraboloid"), (mpq(0), mpq(0), mpq(3)))
    >>> found.distance, [place.exact for place in found]
    (<Real √6>, [(mpq(-1,1), mpq(-1,1)), (mpq(1,1), mpq(1,1))])
    """
    chord = _from(surface, point)
    squared, found = minima(reduce(add, [e * e for e in chord]), surface.w * surface.w, closed)
    return NearestOnSurface(found.points, found.everywhere, squared=squared, surface=surface)


def _from(surface: NurbsSurface, point: Iterable[Number]) -> list[TensorSpline]:
    """The coordinates of ``w (S − P)``."""
    return [x - surface.w.scaled(at) for x, at in zip(surface.p, point, strict=True)]


def bounding_box(surface: NurbsSurface) -> tuple[NamedNumbers, ...]:
    """The smallest and the largest value of every coordinate. Raises `ReachError` if this would take too long.

    >>> from exactspline import example
    >>> bounding_box(example("torus"))[2].values
    {'low': <Real -1>, 'high': <Real 1>}
    """
    sign = 1 if surface.w(*(low for low, _ in surface.domain)) > 0 else -1
    ends = [[minima(x.scaled(k * sign), surface.w.scaled(sign))[0] * k for k in (1, -1)] for x in surface.p]
    return tuple(NamedNumbers(axis, {"low": low, "high": high}) for axis, (low, high) in zip("xyz", ends, strict=False))


def plane_section(surface: NurbsSurface, normal: Point, offset: mpq, closed: Sequence[Along] = ()) -> ZeroCurves:
    """The common points of a surface and the plane of the points X with ``normal · X = offset``.

    >>> from exactspline import example
    >>> plane_section(example("torus"), (mpq(0), mpq(0), mpq(1)), mpq(0), tuple(Along))
    a line, a line
    """
    parts = [x.scaled(n) for x, n in zip(surface.p, normal, strict=True)]
    return zero_curve(reduce(add, parts) - surface.w.scaled(offset), closed)


def line_meetings(
    surface: NurbsSurface,
    start: Point,
    direction: Point,
    ends: tuple[mpq | None, mpq | None] = (None, None),
    closed: Sequence[Along] = (),
) -> SurfacePlaces[LineMeeting]:
    """The common points of a surface and the line ``start + t direction``, or its part with t between two `ends`,
    in the order of t; and `everywhere` the parts of the surface that lie on the line.

    >>> from exactspline import example
    >>> line_meetings(example("sphere"), (mpq(0), mpq(0), mpq(0)), (mpq(1), mpq(0), mpq(0)), (mpq(0), None), [Along.U])
    [<zero at 0 and 1> and 1 of the line]

    Raises `ShapeError` for a part of a line if a piece of the line lies in the surface.
    """
    k = max(range(3), key=lambda i: abs(direction[i]))
    chord = _from(surface, start)
    planes = [chord[i].scaled(direction[k]) - chord[k].scaled(direction[i]) for i in range(3) if i != k]
    found, below, (low, high) = common_zeros(*planes, closed=closed), surface.w.scaled(direction[k]), ends
    if found.everywhere and ends != (None, None):
        line = ",".join(map(text, (*start, *direction)))
        raise ShapeError(
            "part of a line that has a piece in the surface", remedy=f"line_intersections:{line} has the piece"
        )
    # the tangent plane at a tangent line contains the line, and may be one of these two planes
    zeros = [replace(x, kind=ZeroKind.TOUCHING) if x.kind is ZeroKind.MULTIPLE else x for x in found]
    met = [LineMeeting(x, _parameter(x, planes, chord[k], below)) for x in zeros]
    kept = [x for x in met if (low is None or x.parameter >= low) and (high is None or x.parameter <= high)]
    return SurfacePlaces(tuple(sorted(kept, key=lambda one: one.parameter)), found.everywhere, found.undecided)


def _parameter(zero: CommonZero, planes: Sequence[TensorSpline], top: TensorSpline, bottom: TensorSpline) -> Real:
    """The value of a quotient at a common point of two planes and a surface."""
    patch = zero.patches[0]
    forms = [p for p in polynomials_on(patch, *planes) if p]
    pair = [as_form(p / greatest_common_divisor(forms)) for p in forms]
    return quotient_on(patch, top, bottom).at(elimination.CommonZero.at(bottom.patch(*patch), zero.place), pair)
