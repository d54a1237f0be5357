"""Questions about a curve whose answers are named numbers, or other control points of the curve: entries of the
registry.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeAlias

from exactspline.geometry.curves import bounds, values
from exactspline.geometry.curves.bounds import coordinate_range, slope_zeros
from exactspline.geometry.curves.features import SpaceFacts
from exactspline.geometry.derived.derive import Derived, derive
from exactspline.geometry.measures import integrals
from exactspline.geometry.measures.integrals import centroid, moment, named_moments, number
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, cross
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Side
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import ALL_CURVES, CURVES, Answered, Of, question, question_with, questions_of
from exactspline.questions.takes import (
    BOUND,
    INTEGER,
    LENGTH,
    PLACE,
    PLACES,
    TWO_COORDINATES,
    TWO_PLACES,
    OnCurve,
    QuestionError,
)
from exactspline.reals.real import Real, real
from exactspline.roots.answers import Places
from exactspline.roots.values import exact_place
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs, changed

Parameters: TypeAlias = tuple[OnCurve, ...]
#: The largest number of segments times the square of the degree to which a degree is raised (a few seconds).
MOST_ELEVATED = 1_000_000


def _slopes(facts: SpaceFacts) -> tuple[ZeroSet, ...]:
    return tuple(slope_zeros(facts.curve, i) for i in range(facts.curve.dimension))


class CurveValues(SpaceFacts):
    """The facts of one curve, and the questions about it whose answers are numbers or control points."""

    def parameters_of(self, name: str) -> tuple[mpq | Real, ...] | None:
        """The parameters of the knots, or of the places that answer a question; None for any other name.

        Raises `QuestionError` if a whole piece is part of the answer.
        """
        if name == "knots":
            return self.breaks
        entry = questions_of(type(self)).get(name)
        if entry is None or entry.about.answered != Answered.PLACES or entry.about.takes:
            return None
        places = entry.answer(self)
        assert isinstance(places, Places)  # by the type of its answer
        if places.everywhere:
            remedy = "name parameters there, as in value@1/2"
            raise QuestionError(f"{name} fill all of {places.everywhere[0]}", remedy=remedy)
        return tuple(exact_place(feature.root) for feature in places)

    @question_with(PLACES, *ALL_CURVES, answered=Answered.NUMBERS)
    def value(self, places: Parameters) -> tuple[NamedNumbers, ...]:
        """The point at a parameter; ``1/2-`` is the limit from the left, and ``1/2`` at a knot is the limit from the
        right.

        >>> from exactspline import analyse, example
        >>> [point.values for point in analyse(example("circle")).value("1/2")]
        [{'parameter': <Real 1/2>, 'x': <Real 3/5>, 'y': <Real 4/5>}]
        >>> [point.values["y"] for point in analyse(example("jump")).value("1-,1+")]
        [<Real 0>, <Real 1>]
        """
        return _at("point", places, lambda t, side: coordinates(self.curve, t, side=side))

    @question_with((PLACES, INTEGER), *ALL_CURVES, answered=Answered.NUMBERS)
    def derivative(self, places: Parameters, order: int = 1) -> tuple[NamedNumbers, ...]:
        """The derivative of an order (by default 1) at a parameter.

        >>> from exactspline import analyse, example
        >>> analyse(example("cubic_s")).derivative(0, 4)[0].values["y"]
        <Real 0>
        """
        return _at("derivative", places, lambda t, side: coordinates(self.curve, t, order, side))

    @question_with(PLACES, *CURVES, answered=Answered.NUMBERS)
    def curvature(self, places: Parameters) -> tuple[NamedNumbers, ...]:
        """The curvature at a parameter: signed in the plane, not negative in space.

        >>> from exactspline import analyse, example
        >>> analyse(example("circle")).curvature("1/2")[0].values["curvature"]
        <Real 1>
        """
        return _at("curvature", places, lambda t, side: {"curvature": values.curvature(self.curve, t, side)})

    @question_with(PLACES, *CURVES, answered=Answered.NUMBERS)
    def curvature_derivative(self, places: Parameters) -> tuple[NamedNumbers, ...]:
        """The derivative of the curvature by arc length at a parameter, in the plane that of the signed curvature.

        In space, where κ = 0, the derivative is the limit from the side.

        >>> from exactspline import analyse, example
        >>> analyse(example("cubic_s")).curvature_derivative("1/2")[0].values["curvature derivative"]
        <Real 2/3>
        """
        name = "curvature derivative"
        return _at(name, places, lambda t, side: {name: bounds.derivative_by_arc_length(self, t, side)})

    @question_with(PLACES, Of.SPACE_CURVE, answered=Answered.NUMBERS)
    def torsion(self, places: Parameters) -> tuple[NamedNumbers, ...]:
        """The torsion of a space curve at a parameter.

        >>> from exactspline import analyse, example
        >>> analyse(example("twisted_cubic")).torsion(0)[0].values["torsion"]
        <Real 3>
        """
        return _at("torsion", places, lambda t, side: {"torsion": values.torsion(self.curve, t, side)})

    @question_with(PLACES, *CURVES, answered=Answered.NUMBERS)
    def frame(self, places: Parameters) -> tuple[NamedNumbers, ...]:
        """The unit tangent and normal at a parameter, in space also the binormal.

        The normal is to the left of a plane curve, towards the centre of curvature in space.

        >>> from exactspline import analyse, example
        >>> analyse(example("circle")).frame(0)[0].values["Ny"]
        <Real 0>
        """
        tangent = self.velocity
        if self.curve.dimension == 2:
            vectors = {"T": tangent, "N": Vector(-tangent[1], tangent[0])}
        else:
            vectors = {"T": tangent, "N": Vector(*cross(self.binormal, tangent)), "B": self.binormal}

        def frame(t: mpq | Real, side: Side) -> dict[str, Real]:
            return {
                f"{name}{axis}": x
                for name, vector in vectors.items()
                for axis, x in zip(axes(self.curve.dimension), values.unit(vector, t, name, side), strict=True)
            }

        return _at("frame", places, frame)

    @question_with((PLACE, INTEGER), *ALL_CURVES, answered=Answered.SPLINES)
    def insert(self, place: mpq, times: int = 1) -> Nurbs:
        """The curve with a knot inserted, by default once.

        >>> from exactspline import analyse, example
        >>> len(analyse(example("cubic_s")).insert("1/2").control_points)
        5
        """
        return self.curve.insert_knot(place, times)

    @question_with((PLACE, INTEGER), *ALL_CURVES, answered=Answered.SPLINES)
    def remove(self, place: mpq, times: int = 1) -> Nurbs:
        """The curve with a knot removed, by default once.

        >>> from exactspline import analyse, example
        >>> curve = example("cubic_s")
        >>> analyse(curve.insert_knot("1/2")).remove("1/2") == curve
        True

        Raises `ReductionError` if removing the knot changes the curve.
        """
        return changed(self.curve, lambda f: f.remove_knot(place, times))

    @question_with(INTEGER, *ALL_CURVES, answered=Answered.SPLINES)
    def elevate(self, times: int = 1) -> Nurbs:
        """The curve with the degree raised, by default by 1.

        >>> from exactspline import analyse, example
        >>> analyse(example("cubic_s")).elevate(2).degree
        5
        """
        if self.curve.segments * (self.curve.degree + times) ** 2 > MOST_ELEVATED:
            raise QuestionError(f"the degree raised by {times}", remedy="ask for less, or for parts of the curve")
        return self.curve.elevate_degree(times)

    @question_with(PLACE, *ALL_CURVES, answered=Answered.SPLINES)
    def split(self, place: mpq) -> tuple[Nurbs, Nurbs]:
        """The parts of the curve before and after a parameter.

        >>> from exactspline import analyse, example
        >>> [part.domain for part in analyse(example("circle")).split(1)]
        [Interval(0, 1), Interval(1, 4)]
        """
        return self.curve.split(place)

    @question_with(TWO_COORDINATES, *ALL_CURVES, answered=Answered.SPLINES)
    def product(self, coordinates: tuple[int, int]) -> BSpline | Rational[BSpline]:
        """The product of two coordinates (0 is x).

        >>> from exactspline import analyse, example
        >>> analyse(example("cubic_s")).product("01").degree
        6
        """
        i, j = coordinates
        top = self.curve.p[i] * self.curve.p[j]
        return top if self.curve.polynomial else Rational(top, self.curve.w * self.curve.w)

    @question(Of.PLANE_CURVE, answered=Answered.SPLINES, on_request=True)
    def evolute(self) -> Derived:
        """The evolute, piece by piece, and its poles.

        >>> from exactspline import analyse, example
        >>> len(analyse(example("ellipse")).evolute.poles)
        0
        """
        return derive("evolute", self.curve)

    @question(*ALL_CURVES, answered=Answered.NUMBERS, proof=_slopes, on_request=True)
    def bounding_box(self) -> tuple[NamedNumbers, ...]:
        """The smallest and the largest value of every coordinate.

        >>> from exactspline import analyse, example
        >>> [(side.what, *side.values.values()) for side in analyse(example("circle")).bounding_box]
        [('x', <Real -1>, <Real 1>), ('y', <Real -1>, <Real 1>)]
        """
        ranges = [(axis, *coordinate_range(self.curve, i)) for i, axis in enumerate(axes(self.curve.dimension))]
        return tuple(NamedNumbers(axis, {"low": low, "high": high}) for axis, low, high in ranges)

    @question(*CURVES, answered=Answered.NUMBERS, on_request=True)
    def largest_speed(self) -> tuple[NamedNumbers, ...]:
        """The largest ‖γ′‖, and where it is attained.

        >>> from exactspline import Nurbs, analyse
        >>> analyse(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])).largest_speed
        (<largest speed: parameter 0, speed 2√2>, <largest speed: parameter 1, speed 2√2>)
        """
        return bounds.largest(self, bounds.SPEED)

    @question(*CURVES, answered=Answered.NUMBERS, on_request=True)
    def largest_curvature(self) -> tuple[NamedNumbers, ...]:
        """The largest |κ|, and where it is attained; or the parameters near which it is not bounded.

        Limits from both sides of a knot count, and so do limits at points with γ′ = 0, if they exist.

        >>> from exactspline import analyse, example
        >>> [(str(x.values["curvature"]), x.values["parameter"]) for x in analyse(example("ellipse")).largest_curvature]
        [('2', <Real 0>), ('2', <Real 2>)]
        >>> analyse(example("cusp")).largest_curvature
        (<unbounded near: parameter 1/2>,)
        """
        return bounds.largest(self, bounds.CURVATURE)

    @question(*CURVES, answered=Answered.NUMBERS, on_request=True)
    def largest_curvature_derivative(self) -> tuple[NamedNumbers, ...]:
        """The largest |dκ/ds| between jumps of κ, and where it is attained; or the parameters near which it is not
        bounded.

        >>> from exactspline import analyse, example
        >>> analyse(example("circle")).largest_curvature_derivative
        (<largest curvature derivative on a piece: curvature derivative 0, start 0, end 4>,)
        """
        return bounds.largest(self, bounds.CURVATURE_DERIVATIVE)

    @question(Of.SPACE_CURVE, answered=Answered.NUMBERS, on_request=True)
    def largest_torsion(self) -> tuple[NamedNumbers, ...]:
        """The largest |τ| outside straight pieces, and where it is attained; or the parameters near which it is not
        bounded.

        >>> from exactspline import analyse, example
        >>> analyse(example("twisted_cubic")).largest_torsion
        (<largest torsion: parameter 0, torsion 3>,)
        """
        return bounds.largest(self, bounds.TORSION)

    @question_with(BOUND, *CURVES, answered=Answered.NUMBERS)
    def curvature_at_most(self, bound: Number) -> tuple[NamedNumbers, ...]:
        """Whether |κ| is at most a number on the whole curve, and the parts on which it is larger.

        The end of a part across the seam of a closed curve is below its start.

        >>> from exactspline import analyse, example
        >>> [x.facts for x in analyse(example("ellipse")).curvature_at_most(2)]
        [{'holds': 'yes'}]
        >>> analyse(example("ellipse")).curvature_at_most("1/4")
        (<curvature bound: bound 1/4>, <above: start 1, end 3>, <above: start 3, end 1>)

        Raises `ShapeError` for a negative number.
        """
        return bounds.parts_above(self, rational(bound))

    @question(Of.PLANE_CURVE, answered=Answered.VALUE, on_request=True)
    def area(self) -> Real:
        """The signed area inside a closed curve: positive where it runs counterclockwise.

        The area is in closed form for polynomial curves and for arcs of circles and ellipses.

        >>> from exactspline import Nurbs, analyse, example
        >>> analyse(Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (0, 1), (0, 0)])).area
        <Real 1/2>
        >>> analyse(example("circle")).area, analyse(example("ellipse")).area
        (<Real π>, <Real 2π>)

        Raises `ShapeError` for a curve that is not closed.
        """
        return number(moment(self, 0, 0))

    @question_with(INTEGER, Of.PLANE_CURVE, answered=Answered.NUMBERS)
    def moments(self, order: int = 2) -> tuple[NamedNumbers, ...]:
        """The moments ∬ xⁱ yʲ inside a closed curve with i + j up to an order, by default 2.

        >>> from exactspline import Nurbs, analyse
        >>> triangle = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (0, 1), (0, 0)])
        >>> [found.values["moment"] for found in analyse(triangle).moments(1)]
        [<Real 1/2>, <Real 1/6>, <Real 1/6>]

        Raises `ShapeError` for a curve that is not closed, and `QuestionError` for an order above 8.
        """
        return named_moments(partial(moment, self), order)

    @question(Of.PLANE_CURVE, answered=Answered.NUMBERS, on_request=True)
    def centroid(self) -> tuple[NamedNumbers, ...]:
        """The centroid of the region inside a closed curve.

        >>> from exactspline import Nurbs, analyse
        >>> analyse(Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (0, 1), (0, 0)])).centroid
        (<centroid: x 1/3, y 1/3>,)

        Raises `ShapeError` for a curve that is not closed, and `DomainError` where the area is 0.
        """
        return centroid(partial(moment, self))

    @question(*ALL_CURVES, answered=Answered.VALUE, on_request=True)
    def length(self) -> Real:
        """The arc length.

        The length is in closed form if the speed is a polynomial, and for circular arcs.

        >>> from exactspline import Nurbs, analyse, example
        >>> analyse(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])).length, analyse(example("circle")).length
        (<Real 5>, <Real 2π>)
        """
        return integrals.length(self.curve)

    @question_with(TWO_PLACES, *ALL_CURVES, answered=Answered.VALUE)
    def length_between(self, ends: tuple[mpq | Real, mpq | Real]) -> Real:
        """The arc length between two parameters.

        >>> from exactspline import analyse, example
        >>> analyse(example("circle")).length_between((0, 1))
        <Real π/2>

        Raises `DomainError` outside the domain.
        """
        return integrals.length_between(self.curve, *ends)

    @question_with(LENGTH, *ALL_CURVES, answered=Answered.VALUE)
    def at_length(self, distance: mpq) -> Real:
        """The parameter at an arc length from the start.

        >>> from exactspline import Nurbs, analyse
        >>> analyse(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])).at_length(2)
        <Real 2/5>

        Raises `DomainError` for a negative length and for a length greater than that of the curve.
        """
        return integrals.at_length(self.curve, distance)

    @question_with(INTEGER, *ALL_CURVES, answered=Answered.NUMBERS)
    def equally_spaced(self, parts: int) -> tuple[NamedNumbers, ...]:
        """The parameters that divide the curve into parts of the same arc length, both ends included.

        >>> from exactspline import Nurbs, analyse
        >>> [found.values["parameter"] for found in analyse(Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])).equally_spaced(2)]
        [<Real 0>, <Real 1/2>, <Real 1>]

        Raises `QuestionError` for 0 parts.
        """
        return tuple(NamedNumbers("point", {"parameter": t}) for t in integrals.equally_spaced(self.curve, parts))


def axes(n: int) -> list[str]:
    """The names of the coordinates.

    >>> axes(2)
    ['x', 'y']
    """
    return list("xyz"[:n]) if n <= 3 else [f"x{i}" for i in range(1, n + 1)]


def coordinates(curve: Nurbs, t: mpq | Real, order: int = 0, side: Side = Side.RIGHT) -> dict[str, Real]:
    """A point or a derivative of a curve, by the names of the coordinates.

    >>> from exactspline import example
    >>> coordinates(example("circle"), exact_place(1))
    {'x': <Real 0>, 'y': <Real 1>}
    """
    return dict(zip(axes(curve.dimension), values.point_at(curve, t, order, side), strict=True))


def _at(
    what: str, places: Parameters, values_at: Callable[[mpq | Real, Side], dict[str, Real]]
) -> tuple[NamedNumbers, ...]:
    """Numbers at each parameter, with the side of the limit if a side was given."""
    sides = [(t, side or Side.RIGHT, {"side": str(side)} if side else {}) for t, side in places]
    return tuple(NamedNumbers(what, {"parameter": real(t)} | values_at(t, side), facts) for t, side, facts in sides)
