"""Questions about a surface whose answers are numbers at a place: entries of the registry."""

from __future__ import annotations

from exactspline.errors import DomainError
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.numbers.exact import mpq
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import Answered, Inspected, Of, question_with
from exactspline.questions.takes import PLACE_ON_SURFACE, TWO_ORDERS, QuestionError
from exactspline.reals.real import Real
from exactspline.splines.surface import NurbsSurface


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


class CurvatureValues(SurfaceValues):
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
