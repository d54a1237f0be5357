"""The common points of two segments in space: the common points of their projections to a plane at which the third
coordinates agree, too.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import fmpz_mat, fmpz_poly

from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.bernstein import ONE, substituted, value
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Arc, Image, Local, Meeting, Meetings, RationalMap
from exactspline.polynomials.cost import REMEDY
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.plane_pairs import meetings, meetings_of_point
from exactspline.polynomials.zero_places import Place
from exactspline.roots.segment_forms import parameter
from exactspline.roots.values import exact_place, value_at
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

#: Projections that are tried in turn: the first plane coordinate is ``x + a z``, the second ``y + b z``.
SHEARS = ((0, 0), (1, -1), (2, 3), (-3, 5), (7, -4))
NAUGHT = fmpz_poly([])


class SpaceForms(NamedTuple):
    """A space curve on one segment: the integers of the four forms ``x, y, z, w``, which have the same degree."""

    degree: int
    x: fmpz_poly
    y: fmpz_poly
    z: fmpz_poly
    w: fmpz_poly

    def sheared(self, a: int, b: int) -> PlaneForms:
        """The projection along ``(−a, −b, 1)``."""
        return PlaneForms(self.degree, self.x + self.z * a, self.y + self.z * b, self.w)

    def in_lowest_terms(self) -> SpaceForms:
        """The curve without common factors of the four forms; it has degree 0 if it is a single point."""
        common = greatest_common_divisor(list(self[1:]))
        forms = [form // common for form in self[1:]]
        return SpaceForms(max(form.degree() for form in forms), *forms)


def space_meetings(first: SpaceForms, second: SpaceForms) -> Meetings:
    """All common points and arcs of two segments in space; the multiplicities are not determined.

    >>> x, one = fmpz_poly([0, 1]), fmpz_poly([1, 1])
    >>> axis = SpaceForms(1, x, NAUGHT, NAUGHT, one)
    >>> [len(space_meetings(axis, SpaceForms(1, NAUGHT, x, z, one)).points) for z in (NAUGHT, one)]
    [1, 0]

    Raises `ReachError` if this would take too long.
    """
    projections = []
    for shear in SHEARS:
        found = meetings(first.sheared(*shear), second.sheared(*shear))
        if not found.arcs and not found.rests:
            return _agreeing(found, first, second)
        if not found.rests:
            projections.append((found, shear))
    first, second = first.in_lowest_terms(), second.in_lowest_terms()
    if first.degree == 0:
        return meetings_of_point(_minors(first, second), second.degree)
    if second.degree == 0:
        return meetings_of_point(_minors(second, first), first.degree).exchanged()
    for found, shear in reversed(projections):
        if all(_agrees_along(arc, first, second) for arc in found.arcs) or _is_one_to_one(shear, first, second):
            return _agreeing(found, first, second)
    raise ReachError("two curves in space with one projection, of which one turns back", remedy=REMEDY)


def _agreeing(projected: Meetings, first: SpaceForms, second: SpaceForms) -> Meetings:
    """The arcs, and the common points at which the third coordinates agree, too."""
    points = [p for p in projected.points if _agrees(p, first, second)]
    return Meetings([Meeting(p.first, p.second, None) for p in points], projected.arcs)


def _minors(point: SpaceForms, curve: SpaceForms) -> list[fmpz_poly]:
    """Polynomials that vanish where a curve passes through a point, which is given as a curve of degree 0."""
    pairs = (point.x, curve.x), (point.y, curve.y), (point.z, curve.z)
    return [moving * point.w - curve.w * fixed for fixed, moving in pairs]


def _is_one_to_one(shear: tuple[int, int], first: SpaceForms, second: SpaceForms) -> bool:
    """Whether a projection is injective on two curves because both lie in a plane on which the projection is
    injective.
    """
    rows = [[form[i] for form in forms] for n, *forms in (first, second) for i in range(n + 1)]
    a, b = shear
    return int(fmpz_mat([*rows, [-a, -b, 1, 0]]).rank()) > int(fmpz_mat(rows).rank())


def _agrees(point: Meeting, first: SpaceForms, second: SpaceForms) -> bool:
    """Whether the third coordinates of a common point of the projections are equal."""
    if isinstance(point.second, Image):
        return _agrees(point.exchanged(), second, first)
    s, t = point.first, point.second
    if isinstance(s, Image):
        return s.place.sign(*_difference(s.map, first, second)) == 0
    if s.exact is not None and t.exact is not None:
        return _third(first, s) == _third(second, t)
    return _real_third(first, s) == _real_third(second, t)


def _difference(carried: RationalMap, first: SpaceForms, second: SpaceForms) -> tuple[fmpz_poly, int]:
    """The difference of the third coordinates, times the weights, as a form in the parameter of the second curve."""
    z, w = (substituted(form, first.degree, carried.bottom, carried.top) for form in (first.z, first.w))
    return z * second.w - w * second.z, first.degree * carried.degree + second.degree


def _third(curve: SpaceForms, place: Place) -> mpq:
    t = place.exact
    assert t is not None, "the caller has asked"
    z, w = (value((form, ONE), curve.degree, t) for form in (curve.z, curve.w))
    return z / w


def _real_third(curve: SpaceForms, place: Local) -> object:
    mesh = Mesh(UNIT.first)
    z, w = (BSpline.from_forms(curve.degree, mesh, (), [(form, ONE)]) for form in (curve.z, curve.w))
    return value_at(z, w, exact_place(parameter(place, UNIT.first, UNIT.first)))


def _agrees_along(arc: Arc, first: SpaceForms, second: SpaceForms) -> bool:
    """Whether the third coordinates are equal along an arc of the projections."""
    if arc.map is None:
        return False
    one, other = (second, first) if arc.exchanged else (first, second)
    return not _difference(arc.map, one, other)[0]
