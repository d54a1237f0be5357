"""Questions about a surface whose answers are numbers at a place, and questions about a surface in space and a point, a
line or a plane: entries of the registry.
"""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.bivariate.zeros import SurfacePlaces, ZeroCurves
from exactspline.errors import DomainError
from exactspline.geometry.pairs import surface_meetings
from exactspline.geometry.pairs.surface_meetings import LineMeeting, NearestOnSurface
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.geometry.surfaces.singular import closed_along
from exactspline.numbers.exact import Number, mpq
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Fact, Inspected, Of, question, question_with
from exactspline.questions.takes import ENDS, LINE, PLACE_ON_SURFACE, PLANE, POINT_IN_SPACE, TWO_ORDERS, QuestionError
from exactspline.reals.real import Real
from exactspline.splines.surface import Along, NurbsSurface


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


class _CurvatureValues(SurfaceValues):
    """A surface in space, and the questions about its curvature at a place."""

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


def _by_axis(point: tuple[mpq, ...]) -> dict[str, Real]:
    return {axis: Real(x) for axis, x in zip("xyz", point, strict=False)}


class SurfaceMeetings(_CurvatureValues):
    """A surface in space, and the questions about the surface and a point, a line or a plane."""

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
        return surface_meetings.nearest(self.surface, point, lambda: self.closed)

    @question(Of.SURFACE, answered=Answered.NUMBERS, on_request=True)
    def bounding_box(self) -> tuple[NamedNumbers, ...]:
        """The smallest and the largest value of every coordinate of a surface.

        >>> from exactspline import analyse, example
        >>> [tuple(side.values.values()) for side in analyse(example("torus")).bounding_box]
        [(<Real -3>, <Real 3>), (<Real -3>, <Real 3>), (<Real -1>, <Real 1>)]

        Raises `ReachError` if this would take too long.
        """
        return surface_meetings.bounding_box(self.surface)

    @question_with(LINE, Of.SURFACE, answered=Answered.PLACES)
    def line_intersections(self, line: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a line, given by a point and its direction: in the order of the line.

        >>> from exactspline import analyse, example
        >>> [float(point) for point in analyse(example("sphere")).line_intersections((0, 0, 0, 1, 0, 0))]
        [-1.0, 1.0]

        Raises `QuestionError` for the direction 0.
        """
        return surface_meetings.line_meetings(self.surface, line[:3], line[3:], closed=self.closed)

    @question_with(LINE, Of.SURFACE, answered=Answered.PLACES)
    def ray_intersections(self, ray: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a ray, given by its start and its direction: the first hit first.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).ray_intersections((0, 0, 0, 1, 0, 0))
        [<zero at 0 and 1> and 1 of the line]

        Raises `QuestionError` for the direction 0, and `ShapeError` where a piece of the line is in the surface.
        """
        return surface_meetings.line_meetings(self.surface, ray[:3], ray[3:], (mpq(0), None), self.closed)

    @question_with(ENDS, Of.SURFACE, answered=Answered.PLACES)
    def segment_intersections(self, ends: tuple[mpq, ...]) -> SurfacePlaces[LineMeeting]:
        """The common points of a surface and a line segment, given by its ends; t = 0 is the first end, 1 the second.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).segment_intersections((0, 0, 0, "1/2", 0, 0))
        nowhere

        Raises `QuestionError` for one point, and `ShapeError` where a piece of the line is in the surface.
        """
        line = LINE.read((*ends[:3], *(b - a for a, b in zip(ends[:3], ends[3:], strict=True))), self)
        return surface_meetings.line_meetings(self.surface, line[:3], line[3:], (mpq(0), mpq(1)), self.closed)

    @question_with(PLANE, Of.SURFACE, answered=Answered.CURVES)
    def plane_section(self, plane: tuple[mpq, ...]) -> ZeroCurves:
        """The curves and points that a surface and a plane ax + by + cz = d have in common, in the parameters u and v.

        >>> from exactspline import analyse, example
        >>> analyse(example("torus")).plane_section((1, 0, 0, "5/2"))
        closed loop

        Raises `QuestionError` for the normal 0.
        """
        return surface_meetings.plane_section(self.surface, plane[:3], plane[3], self.closed)
