"""Questions about a surface whose answers are numbers at a place, and questions about a surface in space and a point, a
line or a plane: entries of the registry.

The nearest points of a surface S to a point P are at common zeros of ``(S − P)·S_u`` and ``(S − P)·S_v``, on borders,
knot lines or at corners (`exactspline.bivariate.quotients`). A line meets a surface in the points at which two planes
through the line meet the surface.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from operator import add

from exactspline.bivariate import common_zeros as elimination
from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.quotients import minima, polynomials_on, quotient_on
from exactspline.bivariate.zeros import CommonZero, SurfacePlaces, ZeroCurves, ZeroKind, common_zeros, zero_curve
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.geometry.surfaces.singular import closed_along
from exactspline.numbers.exact import Number, mpq, text
from exactspline.one_line import one_line
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import as_form
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Fact, Inspected, Of, question, question_with
from exactspline.questions.takes import ENDS, LINE, PLACE_ON_SURFACE, PLANE, POINT_IN_SPACE, TWO_ORDERS, QuestionError
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


def _parameter(zero: CommonZero, planes: Sequence[TensorSpline], top: TensorSpline, bottom: TensorSpline) -> Real:
    """The value of a quotient at a common point of two planes and a surface."""
    patch = zero.patches[0]
    forms = [p for p in polynomials_on(patch, *planes) if p]
    pair = [as_form(p / greatest_common_divisor(forms)) for p in forms]
    return quotient_on(patch, top, bottom).at(elimination.CommonZero.at(bottom.patch(*patch), zero.place), pair)


class SurfaceValues(Inspected):
    """A surface, or a map of the plane, and the questions whose answers are numbers at a place."""

    surface: NurbsSurface

    @question_with(PLACE_ON_SURFACE, Of.SURFACE, Of.PLANAR_MAP, answered=Answered.NUMBERS)
    def value(self, place: tuple[mpq, mpq]) -> tuple[NamedNumbers, ...]:
        """The point at a pair of parameters.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).value((0, 0))[0].values["z"]
        <Real -1>
        """
        return (NamedNumbers("point", _by_axis(self.surface(*place))),)

    @question_with((PLACE_ON_SURFACE, TWO_ORDERS), Of.SURFACE, Of.PLANAR_MAP, answered=Answered.NUMBERS)
    def derivative(self, place: tuple[mpq, mpq], orders: tuple[int, int]) -> tuple[NamedNumbers, ...]:
        """The derivative of orders by u and by v at a pair of parameters, inside a patch.

        >>> from exactspline import analyse, example
        >>> analyse(example("hyperbolic_paraboloid")).derivative(("1/3", "1/2"), (1, 1))[0].values
        {'x': <Real 0>, 'y': <Real 0>, 'z': <Real 1>}

        Raises `QuestionError` on a knot line inside the surface.
        """
        self._check_inside(place)
        return (NamedNumbers("derivative", _by_axis(self.surface.partial(*orders, *place))),)

    def _check_inside(self, place: tuple[mpq, mpq]) -> None:
        """Raise `QuestionError` if a knot line inside the surface passes through a place, because the derivatives of
        its sides may differ.
        """
        for t, mesh, name in zip(place, self.surface.meshes, "uv", strict=True):
            if t in mesh.breaks[1:-1]:
                problem = f"{name} = {t} is a knot, where derivatives of the two sides may differ"
                raise QuestionError(problem, remedy="ask inside a patch")


def _by_axis(point: tuple[mpq, ...]) -> dict[str, Real]:
    return {axis: Real(x) for axis, x in zip("xyz", point, strict=False)}


class SurfaceMeetings(SurfaceValues):
    """A surface in space, and the questions about its curvature at a place, and about the surface with a point, with a
    line and with a plane.
    """

    @question_with(PLACE_ON_SURFACE, Of.SURFACE, answered=Answered.NUMBERS)
    def curvature(self, place: tuple[mpq, mpq]) -> tuple[NamedNumbers, ...]:
        """The Gaussian curvature K and the mean curvature H at a pair of parameters, inside a patch.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).curvature(("1/3", "1/3"))[0].values["K"]
        <Real 1>

        Raises `QuestionError` on a knot line inside the surface, and where the surface has no tangent plane.
        """
        self._check_inside(place)
        try:
            gaussian, mean = SurfaceForms(self.surface).curvatures(*place)
        except DomainError as error:
            raise QuestionError(error.problem, remedy=error.remedy) from None
        return (NamedNumbers("curvature", {"K": gaussian, "H": mean}),)

    @Fact
    def closed(self) -> tuple[Along, ...]:
        """The parameters in which the surface is closed."""
        return tuple(along for along in Along if closed_along(self.surface, along))

    @question_with(POINT_IN_SPACE, Of.SURFACE, answered=Answered.NEAREST)
    def nearest(self, point: Iterable[Number]) -> NearestOnSurface:
        """The points of a surface that are nearest to a point.

        >>> from exactspline import analyse, example
        >>> analyse(example("cylinder")).nearest((2, 0, "1/3")).distance
        <Real 1>
        """
        chord, w = self._chord(point), self.surface.w
        squared, found = minima(reduce(add, [e * e for e in chord]), w * w, lambda: self.closed)
        return NearestOnSurface(found.points, found.everywhere, squared=squared, surface=self.surface)

    def _chord(self, point: Iterable[Number]) -> list[TensorSpline]:
        """The coordinates of ``w (S − P)`` for a point P."""
        return [x - self.surface.w.scaled(at) for x, at in zip(self.surface.p, point, strict=True)]

    @question(Of.SURFACE, answered=Answered.NUMBERS, on_request=True)
    def bounding_box(self) -> tuple[NamedNumbers, ...]:
        """The smallest and the largest value of every coordinate of a surface.

        >>> from exactspline import analyse, example
        >>> [tuple(side.values.values()) for side in analyse(example("torus")).bounding_box]
        [(<Real -3>, <Real 3>), (<Real -3>, <Real 3>), (<Real -1>, <Real 1>)]

        Raises `ReachError` if this would take too long.
        """
        p, w = self.surface.p, self.surface.w
        sign = 1 if w(*(low for low, _ in self.surface.domain)) > 0 else -1
        ends = [[minima(x.scaled(k * sign), w.scaled(sign))[0] * k for k in (1, -1)] for x in p]
        return tuple(NamedNumbers(axis, {"low": low, "high": high}) for axis, (low, high) in zip("xyz", ends))

    @question_with(LINE, Of.SURFACE, answered=Answered.PLACES)
    def line_intersections(self, line: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a line, given by a point and its direction: in the order of the line.

        >>> from exactspline import analyse, example
        >>> [float(point) for point in analyse(example("sphere")).line_intersections((0, 0, 0, 1, 0, 0))]
        [-1.0, 1.0]

        Raises `QuestionError` for the direction 0.
        """
        return self._on_line(line)

    @question_with(LINE, Of.SURFACE, answered=Answered.PLACES)
    def ray_intersections(self, ray: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a ray, given by its start and its direction: the first hit first.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).ray_intersections((0, 0, 0, 1, 0, 0))
        [<zero at 0 and 1> and 1 of the line]

        Raises `QuestionError` for the direction 0, and `ShapeError` where a piece of the line is in the surface.
        """
        return self._on_line(ray, (mpq(0), None))

    @question_with(ENDS, Of.SURFACE, answered=Answered.PLACES)
    def segment_intersections(self, ends: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a line segment, given by its ends; t = 0 is the first end, 1 the second.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).segment_intersections((0, 0, 0, "1/2", 0, 0))
        nowhere

        Raises `QuestionError` for one point, and `ShapeError` where a piece of the line is in the surface.
        """
        line = LINE.read((*ends[:3], *(b - a for a, b in zip(ends[:3], ends[3:], strict=True))), self)
        return self._on_line(line, (mpq(0), mpq(1)))

    @question_with(PLANE, Of.SURFACE, answered=Answered.CURVES)
    def plane_section(self, plane: tuple[mpq, ...]) -> ZeroCurves:
        """The curves and points that a surface and a plane ax + by + cz = d have in common, in the parameters u and v.

        >>> from exactspline import analyse, example
        >>> analyse(example("torus")).plane_section((1, 0, 0, "5/2"))
        closed loop

        Raises `QuestionError` for the normal 0.
        """
        parts = [x.scaled(n) for x, n in zip(self.surface.p, plane[:3], strict=True)]
        return zero_curve(reduce(add, parts) - self.surface.w.scaled(plane[3]), self.closed)

    def _on_line(
        self, line: tuple[mpq, ...], ends: tuple[mpq | None, mpq | None] = (None, None)
    ) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a line, or its part between two `ends`, in the order of the line; and
        `everywhere` the parts of the surface that lie on the line.

        Raises `ShapeError` for a part of a line if a piece of the line lies in the surface.
        """
        start, direction = line[:3], line[3:]
        k = max(range(3), key=lambda i: abs(direction[i]))
        chord = self._chord(start)
        planes = [chord[i].scaled(direction[k]) - chord[k].scaled(direction[i]) for i in range(3) if i != k]
        found, below = common_zeros(*planes, closed=self.closed), self.surface.w.scaled(direction[k])
        if found.everywhere and ends != (None, None):
            written = ",".join(map(text, line))
            raise ShapeError(
                "part of a line that has a piece in the surface", remedy=f"line_intersections:{written} has the piece"
            )
        # the tangent plane at a tangent line contains the line, and may be one of these two planes
        zeros = [replace(x, kind=ZeroKind.TOUCHING) if x.kind is ZeroKind.MULTIPLE else x for x in found]
        met, (low, high) = [LineMeeting(x, _parameter(x, planes, chord[k], below)) for x in zeros], ends
        kept = [x for x in met if (low is None or x.parameter >= low) and (high is None or x.parameter <= high)]
        return SurfacePlaces(tuple(sorted(kept, key=lambda one: one.parameter)), found.everywhere, found.undecided)
