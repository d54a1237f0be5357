"""The analysis of a curve: an object that belongs to the curve and answers all questions about it. `analyse` makes it
at the first call and stores it with the curve. Each fact is computed when first needed and then stored; several threads
may share an analysis. An analysis is not part of the value of the curve: it is not compared, and a copied or pickled
curve has no analysis. A pickled analysis is restored as a new analysis of its curve.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, overload

from exactspline.errors import ShapeError
from exactspline.geometry.analysis.curve_values import CurveValues
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.curves import features
from exactspline.geometry.curves.bounds import slope_zeros, value_zeros
from exactspline.geometry.curves.facts import ZeroForm, kept_by, located
from exactspline.geometry.curves.joints import curvature_of
from exactspline.geometry.curves.kinds import Feature, FeatureKind
from exactspline.geometry.curves.planarity import Plane, in_common_plane, in_the_plane, planar_pieces, plane_of
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.geometry.filter.certain import Certain, certain
from exactspline.geometry.pairs.intersections import Intersections, self_intersections
from exactspline.geometry.pairs.nearest import Nearest, nearest
from exactspline.geometry.pairs.winding import winding_number
from exactspline.geometry.recognition.pieces import RecognizedPiece, recognized, small_distance
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.features import NearbyFeature, features_nearby, singular_points_nearby
from exactspline.geometry.rounded.intersections import NearbyMeeting, self_intersections_nearby
from exactspline.geometry.rounded.stability import StableFeature, stability
from exactspline.hooks import Displayed, FunctionsOutside
from exactspline.language.rational import Rational
from exactspline.numbers.exact import Number, mpq, rational
from exactspline.numbers.intervals import Side
from exactspline.one_line import one_line
from exactspline.questions.answers import NamedNumbers
from exactspline.questions.entry import (
    CURVES,
    Answered,
    Entry,
    Fact,
    Of,
    Remembers,
    question,
    question_with,
    questions_of,
)
from exactspline.questions.takes import COORDINATE, COORDINATE_VALUE, DISTANCE, POINT, WITHIN
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import knot_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    from exactspline.geometry.analysis.planar_maps import MapInspection
    from exactspline.geometry.analysis.surfaces import SurfaceInspection


class Analysis(CurveValues, Displayed, FunctionsOutside):
    """Everything that can be computed of one curve in the plane or in space. The questions about a curve are the
    entries of the registry (`exactspline.questions.entry.questions_of`).

    All parameters are certified roots. A point where γ′ = 0 is reported as a singular point only. On a closed curve the
    seam is a knot like any other and counts once, at the start of the domain; no parameter is outside the domain.

    >>> from exactspline.interchange.examples import example
    >>> found = analyse(example("ellipse"))
    >>> [f.kind.value for f in found.curvature_extrema], found.inflections, found.corners
    (['maximum', 'minimum', 'maximum', 'minimum'], nowhere, ())
    """

    def __init__(self, curve: Nurbs, known: Remembers | None = None, in_space: Nurbs | None = None) -> None:
        super().__init__(curve, known)
        #: The curve as given, possibly in the plane z = 0 of space, where the analysis is about the plane curve.
        self.given = curve if in_space is None else in_space

    def __reduce__(self) -> tuple[object, ...]:
        return analyse, (self.given,)

    def asked_as(self, of: tuple[Of, ...]) -> Analysis:
        """The analysis that answers a question about these kinds of objects: for a curve in the plane z = 0 that of the
        space curve, if the question is about space curves only.
        """
        return self if self.given is self.curve or Of.PLANE_CURVE in of else _analysis(self.given)

    @one_line
    def __repr__(self) -> str:
        return f"<Analysis of {self.curve!r}>"

    def with_coordinate(self, axis: int | mpq) -> Nurbs:
        """The curve with this coordinate: the curve as given in space if the plane curve does not have the
        coordinate.
        """
        return self.curve if axis < self.curve.dimension else self.given

    @property
    def in_space(self) -> bool:
        """Whether the curve is a space curve; raises `ShapeError` if it is neither in the plane nor in space."""
        self.check_dimension()
        return self.curve.dimension == 3

    @property
    def critical_form(self) -> str:
        """The construction whose zeros are the critical points of the curvature."""
        return "space_critical_curvature" if self.in_space else "critical_curvature"

    @question(*CURVES, proof=lambda facts: (facts.flatness.zeros,))
    def inflections(self) -> Places[Feature]:
        """The zeros of the curvature at regular points.

        ``inflection``: the sign changes (in space: the direction of κN is reversed); ``undulation``: the sign does not
        change; ``flat end``: the domain ends there; ``flat point``: at a knot of a space curve, the osculating planes
        of the two sides differ. At a knot with one tangent the curvature may change its sign by a jump (`by_jump`).
        Straight pieces are in `everywhere`.

        >>> from exactspline import Nurbs, example
        >>> [f.kind.value for f in analyse(example("six_segment_cubic")).inflections]
        ['inflection', 'inflection']
        >>> [(f.kind.value, f.root.exact) for f in analyse(example("flat_point")).inflections]
        [('inflection', mpq(1,2))]
        >>> analyse(Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])).inflections
        everywhere on [0, 1]

        Raises `ShapeError` for a curve that is neither in the plane nor in space.
        """
        if self._certain is not None:
            return self._certain.inflections
        self.check_dimension()
        return Places(tuple(features.flat_points(self)), self.straight_pieces)

    @Fact
    def _certain(self) -> Certain | None:
        """The zeros of κ and κ′ decided without exact arithmetic."""
        return None if self.in_space else certain(self)

    @property
    def decided_in_doubles(self) -> bool | None:
        """Whether the certified filter decided the zeros of κ and of κ′; None if the filter was not used."""
        return self._certain is not None if "_certain" in self._known else None

    @question(*CURVES, proof=lambda facts: (facts.zero_form(facts.critical_form).zeros,))
    def critical_points(self) -> Places[Feature]:
        """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``).

        Pieces of constant curvature are in `everywhere`.

        >>> from exactspline import example
        >>> len(analyse(example("ellipse")).critical_points), analyse(example("circle")).critical_points
        (4, everywhere on [0, 4])
        """
        if self._certain is not None:
            return self._certain.critical_points
        self.check_dimension()
        return Places(tuple(features.critical_points(self)), self.constant_pieces)

    @question(*CURVES, part_of="critical_points", proof=lambda facts: (facts.zero_form(facts.critical_form).zeros,))
    def curvature_extrema(self) -> Places[Feature]:
        """The extrema of the curvature (in space except those with κ = 0).

        Extrema are inside segments, or at knots where κ is continuous and κ′ changes its sign, with or without a jump.
        Pieces of constant curvature are in `everywhere`.

        >>> from exactspline import example
        >>> found = analyse(example("six_segment_cubic")).curvature_extrema
        >>> len(found), sum(f.by_jump for f in found)
        (8, 2)
        >>> [f.kind.value for f in analyse(example("rational_space_cubic")).curvature_extrema]
        ['maximum', 'minimum']

        Raises `ShapeError` for a curve that is neither in the plane nor in space.
        """
        if self._certain is not None and self._certain.only_extrema:
            return self.critical_points
        return self.critical_points.where(lambda f: f.kind is not FeatureKind.STATIONARY)

    @question(Of.SPACE_CURVE, proof=lambda facts: (facts.zero_form("zero_torsion", Variant.PAPER).zeros,))
    def torsion_zeros(self) -> Places[Feature]:
        """The zeros of the torsion at regular points.

        ``torsion zero``: τ changes its sign; ``torsion touch``: it keeps its sign; ``torsion end``: the domain ends
        there. At a knot with one osculating plane the sign may change by a jump. Planar pieces are in `everywhere`.

        >>> from exactspline import example
        >>> analyse(example("space_quartic")).torsion_zeros
        nowhere

        Raises `ShapeError` for a curve that is not in space.
        """
        if not self.in_space:
            raise ShapeError("the torsion of a curve in R2", remedy="this needs a curve in space")
        return Places(tuple(features.torsion_zeros(self)), tuple(piece for piece, _ in self.planar_pieces))

    @question(*CURVES, answered=Answered.PIECES, of_piece="straight")
    def straight_pieces(self) -> tuple[CurvePiece, ...]:
        """The pieces on which the curve is straight.

        The pieces are cut at corners and where the curve is constant, and continue across the seam of a closed curve if
        the seam is smooth.

        >>> from exactspline import example
        >>> [str(piece) for piece in analyse(example("straight_between_arcs")).straight_pieces]
        ['[1, 2]']
        """
        return tuple(self.pieces_where_zero(self.flatness)) if self._certain is None else self._certain.straight

    @question(*CURVES, answered=Answered.PIECES, of_piece="κ′ ≡ 0")
    def constant_pieces(self) -> tuple[CurvePiece, ...]:
        """The pieces on which the curvature is constant.

        These are circular arcs and straight pieces, in space also other curves; they are cut where the curvature or the
        tangent jumps.

        >>> from exactspline import example
        >>> [str(piece) for piece in analyse(example("circle")).constant_pieces]
        ['[0, 4]']
        """
        if self._certain is not None:
            return self._certain.straight
        return tuple(self.pieces_where_zero(self.zero_form(self.critical_form)))

    @question(Of.PLANE_CURVE, Of.PLANAR_CURVE, answered=Answered.PAIRS)
    def self_intersections(self) -> Intersections:
        """The points through which a plane curve passes more than once.

        >>> from exactspline import Nurbs
        >>> analyse(Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])).self_intersections
        [<crossing at (2 - √3)/4 and (2 + √3)/4>]
        """
        return self_intersections(self.curve)

    @question_with(POINT, *CURVES, answered=Answered.NEAREST)
    def nearest(self, point: Sequence[Number]) -> Nearest:
        """The points of the curve that are nearest to a point, given by its coordinates.

        >>> from exactspline import example
        >>> analyse(example("circle")).nearest((0, 3))
        [<nearest point at 1: distance 2>]

        Raises `ShapeError` for a point of another dimension.
        """
        return nearest(self.given, point)

    @question_with(POINT, *CURVES, answered=Answered.SOLUTIONS)
    def bisector(self, point: Sequence[Number]) -> Bisector:
        """The points equally far from the curve and a point: in the plane by the least distance from the curve, in
        space by distances along its normals.

        >>> from exactspline import Nurbs
        >>> analyse(Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])).bisector((0, 2)).pieces[0]
        <TrimmedPiece: arc>

        Raises `ShapeError` for a point on the curve and for a point of another dimension.
        """
        from exactspline.geometry.bisectors.any_pair import bisector  # loads as much as the rest

        return bisector(self.with_coordinate(len(point) - 1), point)

    @question_with(POINT, Of.PLANE_CURVE, Of.PLANAR_CURVE, answered=Answered.VALUE)
    def winding_number(self, point: Sequence[Number]) -> int:
        """How often a closed plane curve winds around a point, counterclockwise; in another plane of space as seen from
        the tip of the normal whose first nonzero coordinate is positive.

        >>> from exactspline import example
        >>> analyse(example("circle")).winding_number(("1/2", "1/3"))
        1

        Raises `DomainError` for a point on the curve, and `ShapeError` for a curve that is not closed.
        """
        return winding_number(self.curve, point)

    @question(Of.SPACE_CURVE, answered=Answered.PLANAR_PIECES, of_piece="planar, τ ≡ 0")
    def planar_pieces(self) -> tuple[tuple[CurvePiece, Plane], ...]:
        """The pieces of a space curve that lie in one plane without being straight, and their planes."""
        return tuple(planar_pieces(self.curve)) if self.in_space and not all(self._twist.numerators) else ()

    @question(Of.SPACE_CURVE, answered=Answered.PLANE)
    def plane(self) -> Plane | None:
        """The plane of a planar space curve."""
        return plane_of(self.curve) if self.in_space and not any(self._twist.numerators) else None

    @question(*CURVES, answered=Answered.DESCRIBED)
    def shapes(self) -> tuple[RecognizedPiece, ...]:
        """The pieces that are lines, circles or conics, exactly or within 10⁻⁹ of the curve's size.

        See `exactspline.geometry.recognition.pieces.recognized`.

        >>> from exactspline import example
        >>> [(str(found.shape), found.exact) for found in analyse(example("ellipse")).shapes]
        [('ellipse: centre (0, 0), half axes (2, 1)', True)]
        """
        return recognized(self.curve)

    @Fact
    def rounding(self) -> mpq:
        """10⁻⁹ of the size of a curve that is within this distance of a circle, but not on it; 0 for any other curve.

        >>> from exactspline import Nurbs, example
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.70710678118654752", 1])
        >>> [analyse(curve).rounding for curve in (arc, example("circle"))]
        [mpq(1,1000000000), mpq(0,1)]
        """
        circles = [found for found in self.shapes if found.kind is ShapeKind.CIRCLE]
        widths = (b - a for found in circles for a, b in found.piece.parts)
        is_whole = len(circles) == 1 and sum(widths, mpq(0)) == self.curve.domain.width
        return small_distance(self.curve) if is_whole and circles[0].within else mpq(0)

    def below_rounding(self, feature: Feature) -> bool:
        """Whether an inflection or an extremum of κ may come from the rounded numbers of a circle: the curve is within
        the distance `rounding` of a circle, and it is not proved that all curves within this distance have the feature.
        """
        if not self.rounding or feature.kind.is_singular:
            return False
        robust = [near for near in self.features_within(self.rounding) if near.robust]
        return not any(near.kind is feature.kind and feature.root in near.piece for near in robust)

    @question_with(WITHIN, *CURVES, answered=Answered.DESCRIBED, nearby=True)
    def shapes_within(self, epsilon: Number) -> tuple[RecognizedPiece, ...]:
        """The pieces that are lines, circles or conics within this distance.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.7071", 1])
        >>> [str(found.shape.kind) for found in analyse(arc).shapes_within("1/10000")]
        ['circle']

        Raises `ShapeError` for a distance that is not positive.
        """
        return recognized(self.curve, epsilon)

    @question_with(WITHIN, *CURVES, answered=Answered.DESCRIBED, nearby=True)
    def features_within(self, epsilon: Number) -> tuple[NearbyFeature, ...]:
        """The features of all curves whose control points and weights differ by at most this number, and features that
        only some of them may have.

        See `exactspline.geometry.rounded.features.features_nearby`.

        >>> from exactspline import example
        >>> found = analyse(example("cubic_s")).features_within("1e-9")
        >>> [(feature.kind.value, feature.robust, feature.single) for feature in found]
        [('minimum', True, True), ('inflection', True, True), ('maximum', True, True)]

        Raises `ShapeError` for a curve that is neither in the plane nor in space, and for a distance that is not
        positive.
        """
        return features_nearby(self.curve, epsilon)

    @question_with(WITHIN, *CURVES, answered=Answered.DESCRIBED, nearby=True)
    def self_intersections_within(self, epsilon: Number) -> tuple[NearbyMeeting, ...]:
        """The self-intersections of all curves whose control points and weights differ by at most this number, and
        those that only some of them may have.

        See `exactspline.geometry.rounded.intersections.self_intersections_nearby`.

        >>> from exactspline import Nurbs
        >>> loop = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 2), (-2, 2), (1, 0)])
        >>> [found.robust for found in analyse(loop).self_intersections_within("1e-6")]
        [True]

        Raises `ShapeError` like `features_within`.
        """
        return self_intersections_nearby(self.curve, epsilon)

    @question_with(WITHIN, *CURVES, answered=Answered.DESCRIBED, nearby=True)
    def cusps_within(self, epsilon: Number) -> tuple[NearbyFeature, ...]:
        """The intervals outside which no curve whose control points and weights differ by at most this number has a
        cusp or another singular point.

        See `exactspline.geometry.rounded.features.singular_points_nearby`.

        >>> from exactspline import example
        >>> len(analyse(example("cusp")).cusps_within("1/1000")), analyse(example("circle")).cusps_within("1/1000")
        (1, ())

        Raises `ShapeError` like `features_within`.
        """
        return singular_points_nearby(self.curve, epsilon)

    @question(*CURVES, answered=Answered.DESCRIBED, on_request=True)
    def stability(self) -> tuple[StableFeature, ...]:
        """Inflections (in space: zeros of the torsion), extrema of the curvature and corners, and how far control
        points and weights may be changed before one of these features vanishes.

        See `exactspline.geometry.rounded.stability.stability`.

        >>> from exactspline import example
        >>> [(found.kind.value, found.radius < found.gone) for found in analyse(example("cubic_s")).stability]
        [('minimum', True), ('inflection', True), ('maximum', True)]

        Raises `ShapeError` for a curve that is neither in the plane nor in space.
        """
        return stability(self.curve)

    @question_with(COORDINATE, *CURVES, proof=lambda facts, axis: (slope_zeros(facts.with_coordinate(axis), axis),))
    def turning_points(self, axis: int) -> Places[Feature]:
        """The extrema of a coordinate (0 is x): where it changes from increasing to decreasing or back.

        Type designers put points at these places. Pieces on which the coordinate is constant are in `everywhere`.

        >>> from exactspline import example
        >>> [(f.kind.value, f.root.exact) for f in analyse(example("circle")).turning_points(1)]
        [('maximum', mpq(1,1)), ('minimum', mpq(3,1))]

        Raises `ShapeError` for a coordinate that the curve does not have.
        """
        points, name = [], f"coordinate {axis}"
        solved = slope_zeros(self.with_coordinate(axis), axis)
        for root, by_jump in located(solved):
            left, right = root.signs
            if left and right and left != right:
                kind = FeatureKind.MAXIMUM if left > 0 else FeatureKind.MINIMUM
                points.append(Feature(kind, root, name, by_jump))
        return Places(tuple(points), tuple(CurvePiece(each.parts) for each in solved.intervals))

    @question_with(COORDINATE_VALUE, *CURVES, proof=lambda facts, at: (value_zeros(facts.with_coordinate(at[0]), *at),))
    def at_coordinate(self, at: tuple[mpq, mpq]) -> Places[Feature]:
        """The parameters at which a coordinate (0 is x) has a given value.

        ``level crossing``: the coordinate crosses the value, also by a jump; ``level touch``: it does not cross the
        value, or the domain ends there. Pieces on which the coordinate has the value are in `everywhere`.

        >>> from exactspline import analyse, example
        >>> [(f.kind.value, f.root.shortly()) for f in analyse(example("circle")).at_coordinate((0, "1/2"))]
        [('level crossing', '√3/3'), ('level crossing', '(12 - √3)/3')]

        Raises `ShapeError` for a coordinate that the curve does not have.
        """
        solved, kinds = value_zeros(self.with_coordinate(at[0]), *at), (FeatureKind.TOUCH, FeatureKind.CROSSING)
        name = f"coordinate {at[0]}"
        points = (Feature(kinds[root.sign_change], root, name, by_jump) for root, by_jump in located(solved))
        return Places(tuple(points), tuple(CurvePiece(each.parts) for each in solved.intervals))

    @question_with(DISTANCE, Of.PLANE_CURVE, answered=Answered.PAIRS)
    def offset_self_intersections(self, distance: Number) -> Intersections:
        """The points through which the offset curve at a signed distance (positive to the left) passes more than once,
        by the parameters of the curve.

        >>> from exactspline import Nurbs
        >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-2, 4), (0, -4), (2, 4)])  # y = x²
        >>> analyse(parabola).offset_self_intersections(1)
        [<crossing at (4 - √3)/8 and (4 + √3)/8>]

        See `exactspline.self_intersections`, which is limited in the same way.

        Raises `ShapeError` for a space curve.
        """
        from exactspline.geometry.pairs.offsets import self_intersections

        return self_intersections(self.curve, offset=distance)

    @question_with(DISTANCE, Of.PLANE_CURVE, answered=Answered.NUMBERS)
    def offset_parts(self, distance: Number) -> tuple[NamedNumbers, ...]:
        """The parts of the offset of a simple closed curve, at a signed distance (positive to the left), to which no
        point of the curve is nearer than this distance.

        The parts are given by the corresponding parts of the curve, and as arcs about corners. There is no part if and
        only if no point on this side is farther from the curve than the distance: the offset is then empty, or consists
        of single points.

        >>> from exactspline import Nurbs
        >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
        >>> analyse(square).offset_parts(1)[0], analyse(square).offset_parts(3)
        (<part: start 1/4, end 3/4>, ())

        Raises `ShapeError` for a curve that is not closed or meets itself, and `ReachError` where parts of the offset
        may coincide or be single points.
        """
        from exactspline.geometry.pairs.offsets import offset_parts

        return offset_parts(self.curve, rational(distance))

    @question_with(DISTANCE, Of.PLANE_CURVE, proof=lambda facts, distance: (facts.offset_form(distance).zeros,))
    def offset_cusps(self, distance: Number) -> Places[Feature]:
        """The parameters of the cusps of the offset curve at a signed distance d (positive to the left): κ = 1/d.

        ``cusp``: 1 − dκ, the ratio of the offset's speed to the curve's, changes its sign; ``stop``: the ratio is 0
        without changing its sign. At a knot where κ jumps, 1 − dκ may vanish on one side alone, or change its sign
        without a zero (`by_jump`). Circular arcs whose offset is their centre are in `everywhere`.

        >>> from exactspline import example
        >>> [(f.kind.value, round(float(f.root), 3)) for f in analyse(example("ellipse")).offset_cusps(1)]
        [('cusp', 0.233), ('cusp', 1.767), ('cusp', 2.233), ('cusp', 3.767)]
        >>> analyse(example("circle")).offset_cusps(1), analyse(example("circle")).offset_cusps(-1)
        (everywhere on [0, 4], nowhere)

        Raises `ShapeError` for a space curve and for the distance 0. Source: Farouki and Neff, Analytic properties of
        plane offset curves, CAGD 1990.
        """
        d, form = rational(distance), self.offset_form(distance)
        side = 1 if d > 0 else -1
        points = []
        for root, _ in self.regular_pairs([(root, False) for root in form.zeros]):
            joint = self.joint(root.low) if root.at_knot else None
            smooth = joint is None or (joint.tangent_continuous and joint.curvatures is None)
            if smooth and self.sign_of("zero_curvature", root) == side:
                kind = FeatureKind.CUSP if root.sign_change else FeatureKind.STOP
                points.append(Feature(kind, root, "offset"))
        for joint in self.joints:
            if joint.curvatures is not None:
                at_knot = [(1 - d * curvature).sign for curvature in joint.curvatures]
                before, behind = (
                    sign or self._sign_next_to(form, d, joint.parameter, side)
                    for sign, side in zip(at_knot, Side, strict=True)
                )
                if before * behind < 0 or (before * behind and 0 in at_knot):
                    kind = FeatureKind.CUSP if before != behind else FeatureKind.STOP
                    points.append(Feature(kind, knot_root(joint.parameter), "offset", by_jump=True))
        points.sort(key=lambda feature: feature.root)
        bend = self.zero_form("zero_curvature")
        pieces = [x for x in self.pieces_where_zero(form) if bend.sign_at(knot_root(x.start)) == side]
        return Places(tuple(points), tuple(pieces))

    def _sign_next_to(self, form: ZeroForm, d: mpq, t: mpq, side: Side) -> int:
        """The sign of 1 − dκ just left or right of a breakpoint, 0 where it vanishes on the whole segment: the same at
        every parameter between the breakpoint and the nearest zero or singular point.
        """
        breaks = self.curve.breakpoints
        i = (breaks.index(t) - (side is Side.LEFT)) % (len(breaks) - 1)
        a, b = breaks[i], breaks[i + 1]
        if form.zeros.isolations[i] is None:
            return 0
        near, far = (b, a) if side is Side.LEFT else (a, b)
        place = (near + far) / 2
        inner = [root for root in (*form.zeros, *self.speed.zeros) if root.segment == (a, b)]
        while any((root <= place) != (side is Side.LEFT) or root == place for root in inner):
            place = (near + place) / 2
        point, velocity, second, third = (self.curve.derivative(k, place) for k in range(4))
        return (1 - d * curvature_of((point, velocity, second, third))).sign

    def offset_form(self, distance: Number) -> ZeroForm:
        """d²κ² − 1 without its denominator, and its zeros."""
        d = rational(distance)
        if self.in_space or not d:
            raise ShapeError("the offset of a curve", remedy="this needs a plane curve, and a distance that is not 0")

        def form() -> BSpline:
            squared = construction("curvature_squared").on(self.operands, Variant.MINIMAL, self.value_of)
            assert isinstance(squared, Rational)
            return squared.scalar * (d * d) - squared.denominator

        return self.once(("offset", d), lambda: self.solved(form))

    @property
    def flatness(self) -> ZeroForm:
        """The form whose zeros are those of the curvature, and its zeros."""
        return self.bending if self.in_space else self.zero_form("zero_curvature")


@overload
def analyse(given: Nurbs) -> Analysis:
    """Everything that can be computed of a curve."""


@overload
def analyse(given: NurbsSurface) -> SurfaceInspection | MapInspection:
    """Everything that can be computed of a surface, or of a map of a rectangle into the plane."""


def analyse(given: Nurbs | NurbsSurface) -> Analysis | SurfaceInspection | MapInspection:
    """Return the analysis of a curve, of a surface in space, or of a map of a rectangle into the plane: an object that
    answers each question when it is first asked. The analysis of a curve is stored with the curve.

    >>> from exactspline.interchange.examples import example
    >>> curve = example("cusp")
    >>> analyse(curve) is analyse(curve), [f.kind.value for f in analyse(curve).singular_points]
    (True, ['cusp'])
    >>> analyse(example("ellipsoid"))
    <SurfaceInspection of <NurbsSurface ellipsoid: rational, degree 2 × 2, 9 × 5 control points in R3>>

    A space curve in the plane z = 0, as in files of drawings, is treated as a plane curve in questions about plane
    curves.

    Raises `ShapeError` for anything else, and for a surface that is neither in space nor in the plane.
    """
    if isinstance(given, NurbsSurface):
        from exactspline.geometry.analysis.planar_maps import MapInspection
        from exactspline.geometry.analysis.surfaces import SurfaceInspection

        return MapInspection(given) if given.dimension == 2 else SurfaceInspection(given)
    curve = curve_of(given)
    flat = in_the_plane(curve)
    if flat is curve:
        return _analysis(curve)
    return kept_by(flat).reader(lambda kept: Analysis(flat, kept, curve), "in space")


def _analysis(curve: Nurbs) -> Analysis:
    return kept_by(curve).reader(lambda kept: Analysis(curve, kept))


#: The registry of the questions about curves, by name.
QUESTIONS: dict[str, Entry] = questions_of(Analysis)


def questions_about(curve: Nurbs) -> dict[str, Entry]:
    """The questions that can be asked of a curve.

    >>> from exactspline.interchange.examples import example
    >>> ["torsion_zeros" in questions_about(example(name)) for name in ("circle", "twisted_cubic")]
    [False, True]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    of = {kind_of_curve(curve), kind_of_curve(in_the_plane(curve))}
    analyse(curve).check_dimension()
    if Of.PLANE_CURVE not in of and in_common_plane(curve):
        of.add(Of.PLANAR_CURVE)
    return {name: entry for name, entry in QUESTIONS.items() if of & {*entry.about.of}}


def kind_of_curve(curve: Nurbs) -> Of:
    """The kind of a curve: in the plane, in space or in another dimension.

    >>> from exactspline.interchange.examples import example
    >>> str(kind_of_curve(example("circle")))
    'plane curve'
    """
    return {2: Of.PLANE_CURVE, 3: Of.SPACE_CURVE}.get(curve.dimension, Of.CURVE)
