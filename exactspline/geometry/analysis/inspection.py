"""Everything that `inspect` shows of a curve, read from its analysis."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import cast

from exactspline.errors import DomainError
from exactspline.geometry.analysis.curves import Analysis, analyse, questions_about
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, JointKind
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.curves.values import curvature
from exactspline.geometry.derived.constructions import Variant
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.rounded.features import NearbyFeature
from exactspline.geometry.rounded.intersections import NearbyMeeting
from exactspline.geometry.rounded.stability import StableFeature
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Side
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import in_plane_or_space

# ---- prominence


def _prominences(curve: Nurbs) -> tuple[tuple[Feature, Real | None], ...]:
    """The extrema of the curvature of a curve, each with half of the smaller difference between κ there and at its
    neighbours. Neighbours are the extrema on both sides (in space also points with κ = 0), knots at which the tangent
    or κ jumps, and the ends of the domain.

    Every continuous function that differs from κ by less than this number has such an extremum between the neighbours;
    some function that differs by this number does not. The number is None if κ has a pole at both neighbours.

    >>> from exactspline import example
    >>> [(found.kind.value, str(least)) for found, least in _prominences(example("ellipse"))][:2]
    [('maximum', '7/8'), ('minimum', '7/8')]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    given = in_plane_or_space(curve, "prominences of a curve")
    facts = analyse(given)
    ends = [*map(real, given.domain), *[real(x.parameter) for x in facts.joints if x.kind is not JointKind.CONTINUOUS]]
    extrema = facts.curvature_extrema
    flat = facts.inflections if facts.in_space else ()
    places = sorted([*ends, *[found.root for found in (*extrema, *flat)]])
    return tuple((found, _half_of_the_step(given, found.root, places)) for found in extrema)


def _half_of_the_step(curve: Nurbs, place: Real, places: list[Real]) -> Real | None:
    before, behind = [t for t in places if t < place], [t for t in places if t > place]
    own, steps = curvature(curve, place), list[Real]()
    for end, side in ((before[-1:], Side.RIGHT), (behind[:1], Side.LEFT)):
        with suppress(DomainError):
            steps += [abs(own - curvature(curve, t, side)) for t in end]
    return min(steps) / 2 if steps else None


@dataclass(frozen=True, repr=False)
class Report(OneLine):
    """The report on a curve: the answers to all questions that belong in a report and, on request, the features of all
    curves within a distance (`epsilon` as written, `within` as a number), the stability of features, and the extrema of
    coordinates.
    """

    curve: Nurbs
    epsilon: str = ""
    within: mpq | None = None
    with_stability: bool = False
    with_coordinates: bool = False
    with_all: bool = False

    @property
    def analysis(self) -> Analysis:
        """The analysis stored with the curve."""
        return analyse(self.curve)

    @cached_property
    def answers(self) -> dict[str, object]:
        """The answers by the names of their questions; with a distance, shapes are those within the distance."""
        entries = {name: entry for name, entry in questions_about(self.curve).items() if entry.about.reported}
        near = {} if self.within is None else {"shapes": self.analysis.shapes_within(self.within)}
        return {name: entry.answer(self.analysis) for name, entry in entries.items()} | near

    def places(self, name: str) -> Places[Feature]:
        """The answer to a question that is answered by places."""
        return cast(Places[Feature], self.answers[name])

    def pieces(self, name: str) -> tuple[CurvePiece, ...]:
        """The answer to a question that is answered by pieces."""
        return cast(tuple[CurvePiece, ...], self.answers[name])

    @property
    def shapes(self) -> tuple[RecognizedPiece, ...]:
        """The pieces that are lines, circles or conics."""
        return cast(tuple[RecognizedPiece, ...], self.answers["shapes"])

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints of the curve."""
        return self.analysis.joints

    @property
    def nearby(self) -> tuple[NearbyFeature, ...]:
        """The features of all curves within the distance, and others that only some of them may have."""
        return () if self.within is None else self.analysis.features_within(self.within)

    @property
    def meetings(self) -> tuple[NearbyMeeting, ...]:
        """The self-intersections of all curves within the distance, and others that only some of them may have."""
        return () if self.within is None else self.analysis.self_intersections_within(self.within)

    @cached_property
    def stable(self) -> tuple[tuple[StableFeature, Real | None], ...]:
        """The stability of features, with the prominence of each extremum of the curvature."""
        if not self.with_stability:
            return ()
        least: dict[Real, Real | None] = {found.root: x for found, x in _prominences(self.curve)}
        return tuple((found, least.get(found.place)) for found in self.analysis.stability)

    @property
    def coordinate_extrema(self) -> tuple[Places[Feature], ...]:
        """The extrema of each coordinate."""
        return tuple(map(self.analysis.turning_points, range(self.curve.dimension * self.with_coordinates)))


def inspect_curve(curve: Nurbs) -> Report:
    """The features of a curve in the plane or in space.

    >>> from exactspline.interchange.examples import example
    >>> [len(inspect_curve(example(name)).places("critical_points")) for name in ("ellipse", "rational_space_cubic")]
    [4, 2]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    analyse(curve).check_dimension()
    return Report(in_the_plane(curve))


#: The equations that are solved, in the words of the table of features.
SOLVED = {
    "zero_curvature": "κ = 0",
    "critical_curvature": "κ′ = 0",
    "space_critical_curvature": "κ′ = 0",
    "zero_torsion": "τ = 0",
}


def solved(curve: Nurbs) -> list[tuple[str, str, BSpline, ZeroSet]]:
    """The functions that an inspection solves: names, titles, functions and their zeros.

    >>> from exactspline.interchange.examples import example
    >>> [name for name, *_ in solved(example("twisted_cubic"))]
    ['zero_torsion', 'space_critical_curvature', 'zero_curvature']
    """
    analysis = analyse(curve)
    first = ("zero_torsion", Variant.PAPER) if analysis.in_space else ("zero_curvature", Variant.MINIMAL)
    rows = []
    for name, variant in (first, (analysis.critical_form, Variant.MINIMAL)):
        form = analysis.zero_form(name, variant)
        rows.append((name, SOLVED[name], form.form, form.zeros))
    if analysis.in_space:
        rows.append(("zero_curvature", "common factor of γ′ × γ″", analysis.bending.form, analysis.bending.zeros))
    return rows
