"""Everything that `inspect` shows of a curve, read from its analysis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

from exactspline.geometry.analysis.curves import Analysis, analyse, questions_about
from exactspline.geometry.analysis.prominence import prominences
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.planarity import in_the_plane
from exactspline.geometry.derived.constructions import Variant
from exactspline.geometry.recognition.pieces import RecognizedPiece
from exactspline.geometry.rounded.features import NearbyFeature
from exactspline.geometry.rounded.intersections import NearbyMeeting
from exactspline.geometry.rounded.stability import StableFeature
from exactspline.numbers.exact import mpq
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine
from exactspline.reals.real import Real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True, repr=False)
class Report(OneLine):
    """What is said of a curve: the answers to all questions that belong into a report, and what else is asked for: all
    that curves within a distance have (`epsilon` as it is written, `within` as a number), how stable features are, and
    the extrema of coordinates.
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
        """The answers by the names of their questions; shapes within the distance where one is given."""
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
        """The joints."""
        return self.analysis.joints

    @property
    def nearby(self) -> tuple[NearbyFeature, ...]:
        """What all curves within the distance have, and what some of them may have."""
        return () if self.within is None else self.analysis.features_within(self.within)

    @property
    def meetings(self) -> tuple[NearbyMeeting, ...]:
        """Where all curves within the distance meet themselves, and where some of them may."""
        return () if self.within is None else self.analysis.self_intersections_within(self.within)

    @cached_property
    def stable(self) -> tuple[tuple[StableFeature, Real | None], ...]:
        """The stability of features, with the prominence of each extremum of the curvature."""
        if not self.with_stability:
            return ()
        least: dict[Real, Real | None] = {found.root: x for found, x in prominences(self.curve)}
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


#: What is solved, in the words of the table of features.
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
