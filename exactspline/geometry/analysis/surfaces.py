"""The features of a surface, patch by patch and as a whole: the sign of K, parabolic curves, umbilics, degeneracies."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum

from exactspline.bivariate.across_borders import Place, Sides, single_places, together
from exactspline.bivariate.borders import EDGES, Edge, Patch, vanishes_at
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.joined_curves import Piece, ZeroComponent, chained, place_of
from exactspline.bivariate.signs import Sign, Signs, sign_on_patch
from exactspline.bivariate.zero_curve import Part, Shape, ZeroCurve
from exactspline.bivariate.zero_lines import LinesOfPatch, ZeroLine, odd_part, square_free, without_lines, zero_lines
from exactspline.bivariate.zeros import SurfacePart, SurfacePlaces
from exactspline.errors import ReachError
from exactspline.geometry.analysis.surface_values import SurfaceMeetings
from exactspline.geometry.recognition.patches import RecognizedPart, recognized_surface
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.umbilics import NearbyUmbilic, umbilics_nearby
from exactspline.geometry.surfaces.forms import Reduced, SurfaceForms, constant_curvature, on_patch, sides_of
from exactspline.geometry.surfaces.joints import SurfaceJoint, joints
from exactspline.geometry.surfaces.ridges import Ridges, ridges_of_surface
from exactspline.geometry.surfaces.singular import Line, Pole, SingularPoints, is_point, pole_at, singular_points
from exactspline.geometry.surfaces.umbilics import Umbilic, UmbilicsOfPatch, merged_umbilic, umbilics_of_patch
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.one_line import OneLine, one_line
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import as_polynomial
from exactspline.questions.entry import Answered, Fact, Of, question, question_with
from exactspline.questions.takes import WITHIN
from exactspline.roots.of_polynomials import Parameter
from exactspline.splines.surface import Along, NurbsSurface


class PatchKind(StrEnum):
    """The proved sign of the Gaussian curvature on a whole patch, except on edges that are listed."""

    PLANAR = "planar"
    DEVELOPABLE = "developable"
    SPHERICAL = "spherical"
    ELLIPTIC = "elliptic"
    HYPERBOLIC = "hyperbolic"
    #: K has both signs.
    MIXED = "elliptic and hyperbolic"
    #: K has one sign except at parabolic points, where it is zero without changing its sign.
    ELLIPTIC_BUT = "elliptic except at parabolic points"
    HYPERBOLIC_BUT = "hyperbolic except at parabolic points"
    UNDECIDED = "undecided"
    CURVE = "a curve"
    POINT = "a point"


_BY_SIGN = {
    Sign.POSITIVE: PatchKind.ELLIPTIC,
    Sign.NEGATIVE: PatchKind.HYPERBOLIC,
    Sign.BOTH: PatchKind.MIXED,
    Sign.NOT_NEGATIVE: PatchKind.ELLIPTIC_BUT,
    Sign.NOT_POSITIVE: PatchKind.HYPERBOLIC_BUT,
    Sign.UNDECIDED: PatchKind.UNDECIDED,
}


#: The digits of a point that is compared with a line.
DIGITS = 20

_STRICT = {PatchKind.ELLIPTIC_BUT: PatchKind.ELLIPTIC, PatchKind.HYPERBOLIC_BUT: PatchKind.HYPERBOLIC}


@dataclass(frozen=True, repr=False)
class PatchInspection(OneLine):
    """The features of one patch."""

    patch: Patch
    sides: Box
    kind: PatchKind
    #: Whether H vanishes everywhere.
    minimal: bool
    #: The square of the radius of a sphere.
    radius_squared: mpq | None
    signs: Signs | None
    singular: SingularPoints
    umbilics: UmbilicsOfPatch
    #: The Gaussian curvature, if it is constant.
    curvature: mpq | None = None
    #: Edges along which K vanishes, and isoparametric lines inside.
    parabolic_edges: tuple[Edge, ...] = ()
    parabolic_lines: tuple[tuple[Along, Parameter], ...] = ()
    #: The connected parts of the other zeros of K; points without a tangent plane are not among them.
    parabolic: tuple[Part, ...] = ()
    curve: ZeroCurve | None = field(default=None, repr=False, compare=False)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The parts of the zeros of K, each with its patch."""
        return tuple(Piece(self.patch, self.sides, self.curve, part) for part in self.parabolic if self.curve)

    @property
    def flat(self) -> bool:
        """Whether K vanishes everywhere."""
        return self.kind in (PatchKind.PLANAR, PatchKind.DEVELOPABLE)

    @property
    def lines(self) -> LinesOfPatch:
        """The lines along which K vanishes."""
        return LinesOfPatch(self.patch, self.sides, self.parabolic_edges, self.parabolic_lines, self.flat)

    @property
    def open_boxes(self) -> tuple[Box, ...]:
        """Rectangles of parameters in which something could not be decided."""
        own = self._open_curve
        boxes = (*self.singular.undecided, *self.umbilics.undecided, *own)
        return tuple(dict.fromkeys(boxes)) or ((self.sides,) if self.kind is PatchKind.UNDECIDED else ())

    @property
    def open_signs(self) -> tuple[Box, ...]:
        """Rectangles of parameters in which the sign of K could not be decided."""
        return self._open_curve or ((self.sides,) if self.kind is PatchKind.UNDECIDED else ())

    @property
    def _open_curve(self) -> tuple[Box, ...]:
        return () if self.curve is None else tuple(self.sides.part(box) for box in self.curve.undecided)

    @property
    def complete(self) -> bool:
        """Whether everything about the patch was decided."""
        return not self.open_boxes


class SurfaceInspection(SurfaceMeetings, Displayed):
    """The analysis of a surface in space: the sign of the Gaussian curvature on every patch, its parabolic curves, all
    its umbilics, poles, singular points, creases and jumps of the curvature along knots, certified. The questions about
    a surface are entries of the registry (`exactspline.geometry.analysis.ask`); each question is answered when it is
    first asked.

    >>> from exactspline import example
    >>> found = SurfaceInspection(example("hyperbolic_paraboloid"))
    >>> found.umbilics, found.singular_points, found.complete
    (nowhere, nowhere, True)
    >>> found = SurfaceInspection(example("ellipsoid"))
    >>> [kind.value for kind in found.kinds], len(found.umbilics), found.complete
    (['elliptic'], 4, True)

    Raises `ShapeError` for a surface that is not in space.
    """

    def __init__(self, surface: NurbsSurface) -> None:
        super().__init__(surface)
        self.surface = surface
        self._forms = SurfaceForms(surface)

    @one_line
    def __repr__(self) -> str:
        return f"<SurfaceInspection of {self.surface!r}>"

    @question(Of.SURFACE, answered=Answered.PATCHES)
    def patches(self) -> tuple[PatchInspection, ...]:
        """The proved sign of the Gaussian curvature on every patch, and its value where it is constant.

        >>> from exactspline import analyse, example
        >>> [one.kind.value for one in analyse(example("hyperbolic_paraboloid")).patches]
        ['hyperbolic']
        """
        return tuple(_in_reach(self._forms, patch) for patch in self._forms.patches)

    @question(Of.SURFACE)
    def umbilics(self) -> SurfacePlaces[Umbilic]:
        """The points with a tangent plane at which the two principal curvatures are equal.

        Each umbilic is listed once, also where patches or the two ends of a closed surface meet. Spheres, planes and
        curves of umbilics are in `everywhere`.

        >>> from exactspline import analyse, example
        >>> umbilics = analyse(example("ellipsoid")).umbilics
        >>> len(umbilics), umbilics.everywhere, umbilics[0].kind.value
        (4, (), 'lemon')
        """
        everywhere = _parts((one, one.umbilics, one.umbilics.everywhere) for one in self.patches)
        found = {id(one.place): one for patch in self.patches for one in patch.umbilics.umbilics}
        groups = self._single([one.place for one in found.values()], _edges(everywhere), self.umbilic_curves)
        whole = [one.sides for one in self.patches if one.umbilics.everywhere]
        points = tuple(
            merged_umbilic([found[id(place)] for place in own], whole, self.surface.domain, self.closed)
            for own in groups
        )
        return SurfacePlaces(points, everywhere, _boxes(one.umbilics.undecided for one in self.patches))

    @question(Of.SURFACE, answered=Answered.CURVES)
    def parabolic_lines(self) -> tuple[ZeroLine, ...]:
        """The isoparametric lines along which the Gaussian curvature vanishes, on patches that are not developable.

        >>> from exactspline import analyse, example
        >>> lines = analyse(example("torus")).parabolic_lines
        >>> [(line.along.value, str(line.value)) for line in lines]
        [('u', '1'), ('u', '3')]
        """
        lines = [one.lines for one in self.patches]
        return zero_lines(self.surface.patches, self.surface.domain, lines, self.closed, beside_flat=True)

    @question(Of.SURFACE, answered=Answered.CURVES)
    def parabolic_curves(self) -> tuple[ZeroComponent, ...]:
        """The other curves along which the Gaussian curvature vanishes, on patches that are not developable.

        Each curve is followed across borders of patches where K vanishes on both sides.

        >>> from exactspline import analyse, example
        >>> [curve.shape.value for curve in analyse(example("bicubic")).parabolic_curves]
        ['arc from border to border', 'arc from border to border', 'arc from border to border', 'closed loop']
        """
        return tuple(curve for curve in self._zeros_of_curvature if curve.shape is not Shape.POINT)

    @question(Of.SURFACE)
    def parabolic_points(self) -> SurfacePlaces[Place]:
        """The isolated zeros of the Gaussian curvature.

        Developable patches and planes are in `everywhere`.

        >>> from exactspline import analyse, example
        >>> analyse(example("paraboloid")).parabolic_points
        nowhere
        >>> analyse(example("developable")).parabolic_points.points
        ()
        """
        single = [curve for curve in self._zeros_of_curvature if curve.shape is Shape.POINT]
        flat = tuple(SurfacePart(one.patch, one.sides) for one in self.patches if one.flat)
        parts = [part.sides for part in flat] + [line.box for line in self.parabolic_lines]
        groups = self._single([place_of(piece) for curve in single for piece in curve.pieces], parts)
        return SurfacePlaces(tuple(map(together, groups)), flat, _boxes(one.open_signs for one in self.patches))

    @question(Of.SURFACE)
    def singular_points(self) -> SurfacePlaces[Place]:
        """The points without a tangent plane.

        A point on a border of patches or on a seam is listed once. Patches that are curves or points, poles and
        singular curves are in `everywhere`.

        >>> from exactspline import analyse, example
        >>> [place.exact for place in analyse(example("cross_cap")).singular_points]
        [(mpq(0,1), mpq(0,1))]
        """
        everywhere = _parts((one, one.singular, one.singular.degenerate) for one in self.patches)
        places = [place for one in self.patches for place in one.singular.places]
        groups = self._single(places, _edges(everywhere), self.singular_curves)
        undecided = _boxes(one.singular.undecided for one in self.patches)
        return SurfacePlaces(tuple(map(together, groups)), everywhere, undecided)

    @question(Of.SURFACE, answered=Answered.CURVES)
    def umbilic_curves(self) -> tuple[ZeroComponent, ...]:
        """The curves of umbilics inside patches, each followed across borders of patches.

        >>> from exactspline import analyse, example
        >>> analyse(example("torus")).umbilic_curves
        ()
        """
        return self._chained([(one, one.umbilics.of_factor.curve, one.umbilics.undecided) for one in self.patches])

    @question(Of.SURFACE, answered=Answered.CURVES, on_request=True)
    def ridges(self) -> Ridges:
        """The points at which a principal curvature is stationary along its own line of curvature.

        The answer consists of curves, isoparametric lines, and patches on which a principal curvature is constant along
        all its lines. Around umbilics the curves are resolved only for low degrees, and the work is limited to about a
        minute: rectangles that are not resolved are `undecided`.

        >>> from exactspline import analyse, example
        >>> saddle = analyse(example("hyperbolic_paraboloid")).ridges
        >>> saddle, len(saddle.curves[0].arcs(((0, 1), (0, 1))))
        (branches that cross, 4)
        >>> {curvatures for _, curvatures in analyse(example("torus")).ridges.stationary}
        {2}

        Source: Cazals, Faugère, Pouget and Rouillier, The implicit structure of ridges of a smooth parametric surface,
        Computer Aided Geometric Design 2006.
        """
        return ridges_of_surface(self._forms, [(one.singular, one.umbilics) for one in self.patches], self.closed)

    @question(Of.SURFACE, answered=Answered.CURVES)
    def singular_curves(self) -> tuple[ZeroComponent, ...]:
        """The curves inside patches along which there is no tangent plane, each followed across borders of patches.

        >>> from exactspline import analyse, example
        >>> analyse(example("torus")).singular_curves
        ()
        """
        return self._chained([(one, one.singular.of_factor.curve, one.singular.undecided) for one in self.patches])

    def _chained(
        self, curves: Sequence[tuple[PatchInspection, ZeroCurve | None, tuple[Box, ...]]]
    ) -> tuple[ZeroComponent, ...]:
        """Curves of zeros on patches, joined across their borders, without single points."""
        pieces = [Piece(one.patch, one.sides, curve, part) for one, curve, _ in curves if curve for part in curve.parts]
        components = chained(pieces, self.surface.domain, self.closed, _boxes(boxes for *_, boxes in curves))
        return tuple(curve for curve in components if curve.shape is not Shape.POINT)

    def _single(
        self, places: Sequence[Place], parts: Sequence[Sides], curves: Sequence[ZeroComponent] = ()
    ) -> list[list[Place]]:
        """The places that are neither in closed parts nor on curves; places of the same point are merged."""
        on_curves = {spot for curve in curves for spot, arcs in curve.met.items() if arcs}
        return single_places(places, parts, on_curves, self.surface.domain, self.closed)

    @question(Of.SURFACE, answered=Answered.CURVES)
    def poles(self) -> tuple[Pole, ...]:
        """The isoparametric lines along which the surface has no tangent plane, on borders of patches and inside.

        >>> from exactspline import analyse, example
        >>> len(analyse(example("torus")).poles)
        0
        """
        lines = [(one.patch, line) for one in self.patches for line in lines_of(one.singular, one.sides)]
        return tuple(dict.fromkeys(pole_at(self._forms, patch, line) for patch, line in lines))

    @question(Of.SURFACE, answered=Answered.JOINTS)
    def joints(self) -> tuple[SurfaceJoint, ...]:
        """How patches meet along knot lines and seams: kind, order of geometric continuity, angle of a crease.

        >>> from exactspline import analyse, example
        >>> {joint.order for joint in analyse(example("sphere")).joints}
        {2}
        """
        return joints(self._forms, self.closed)

    @question(Of.SURFACE, answered=Answered.SHAPES)
    def shapes(self) -> tuple[RecognizedPart, ...]:
        """The patches that are planes, spheres, cylinders, cones or tori, exactly or within 10⁻⁹ of the surface's size.

        See `exactspline.geometry.recognition.patches.recognized_surface`.

        >>> from exactspline import analyse, example
        >>> [(str(found.shape), found.exact) for found in analyse(example("cone")).shapes]
        [('cone: apex (0, 0, 2), axis (0, 0, 1), tan 1/2', True)]
        """
        return recognized_surface(self.surface)

    @Fact
    def rounding(self) -> mpq:
        """The proved distance of a surface from a sphere, if it is at most 10⁻⁹ of the size of the surface; 0 for any
        other surface, and for an exact sphere.

        >>> from exactspline import analyse, example
        >>> analyse(example("sphere")).rounding
        mpq(0,1)
        """
        return next((part.within for part in self.shapes if part.kind is ShapeKind.SPHERE and part.whole), mpq(0))

    @Fact
    def umbilics_below_rounding(self) -> tuple[Umbilic, ...]:
        """The umbilics that may come from the rounded numbers of a sphere: it is not proved that all surfaces within
        the distance `rounding` have them.

        >>> from exactspline import analyse, example
        >>> analyse(example("ellipsoid")).umbilics_below_rounding
        ()
        """
        if not self.rounding:
            return ()
        robust = [near.sides for near in self.umbilics_within(self.rounding) if near.robust]
        return tuple(
            found
            for found in self.umbilics
            if not any(all(a <= t <= b for t, (a, b) in zip(found.place.spot, box, strict=True)) for box in robust)
        )

    @question_with(WITHIN, Of.SURFACE, answered=Answered.SHAPES, nearby=True)
    def shapes_within(self, epsilon: Number) -> tuple[RecognizedPart, ...]:
        """The patches that are planes, spheres, cylinders, cones or tori within this distance.

        >>> from exactspline import analyse, example
        >>> [found.shape.kind.value for found in analyse(example("torus")).shapes_within("1/1000")]
        ['torus']

        Raises `ShapeError` for a distance that is not positive.
        """
        return recognized_surface(self.surface, epsilon)

    @question_with(WITHIN, Of.SURFACE, answered=Answered.PATCHES, nearby=True)
    def umbilics_within(self, epsilon: Number) -> tuple[NearbyUmbilic, ...]:
        """The umbilics of all surfaces whose control points and weights differ by at most this number, and those that
        only some of them may have.

        See `exactspline.geometry.rounded.umbilics.umbilics_nearby`.

        >>> from exactspline import analyse, example
        >>> analyse(example("hyperbolic_paraboloid")).umbilics_within("1/1000000")
        ()

        Raises `ShapeError` for a distance that is not positive.
        """
        return umbilics_nearby(self.surface, epsilon)

    @Fact
    def _zeros_of_curvature(self) -> tuple[ZeroComponent, ...]:
        """The zeros of K that are not on lines, joined across borders of patches."""
        pieces = [piece for one in self.patches for piece in one.pieces]
        return chained(pieces, self.surface.domain, self.closed, _boxes(one.open_signs for one in self.patches))

    @property
    def kinds(self) -> tuple[PatchKind, ...]:
        """The kinds of the patches, each once."""
        return tuple(dict.fromkeys(one.kind for one in self.patches))

    @property
    def umbilic_everywhere(self) -> bool:
        """Whether every point is an umbilic."""
        return all(one.umbilics.everywhere for one in self.patches)

    @property
    def constant_curvature(self) -> mpq | None:
        """The Gaussian curvature, if it is constant on the whole surface."""
        values = {one.curvature for one in self.patches if one.kind not in (PatchKind.CURVE, PatchKind.POINT)}
        return values.pop() if len(values) == 1 else None

    @property
    def minimal(self) -> bool:
        """Whether the mean curvature vanishes everywhere."""
        return all(one.minimal for one in self.patches)

    @property
    def complete(self) -> bool:
        """Whether everything was decided."""
        return all(one.complete for one in self.patches)


def _edges(parts: Iterable[SurfacePart]) -> list[Sides]:
    """The parts that are edges."""
    return [part.sides for part in parts if not all(side.width for side in part.sides)]


def lines_of(found: SingularPoints | UmbilicsOfPatch, sides: Box) -> list[Line]:
    """The edges of a patch, and the lines inside the patch, all of whose points are singular or umbilics."""
    return [*(Line(edge.direction, edge.value(sides)) for edge in found.edges), *found.of_factor.lines]


def _parts(found: Iterable[tuple[PatchInspection, SingularPoints | UmbilicsOfPatch, bool]]) -> tuple[SurfacePart, ...]:
    """The patches that are singular or umbilic as a whole, the lines, and a part for each patch with a curve of such
    points.
    """
    parts = list[SurfacePart]()
    for one, own, whole in found:
        boxes = [one.sides] * whole + [one.sides.with_side(k, Interval.point(x)) for k, x in lines_of(own, one.sides)]
        parts += [SurfacePart(one.patch, box) for box in boxes]
        parts += [SurfacePart(one.patch, one.sides, along_curve=True)] * (own.of_factor.curve is not None)
    return tuple(parts)


def _boxes(groups: Iterable[tuple[Box, ...]]) -> tuple[Box, ...]:
    """The boxes of all patches, each once."""
    return tuple(dict.fromkeys(box for boxes in groups for box in boxes))


def _in_reach(forms: SurfaceForms, patch: Patch) -> PatchInspection:
    """The features of one patch; if a factorization would take too long, the whole patch is undecided."""
    try:
        return inspect_patch(forms, patch)
    except ReachError:
        sides = sides_of(forms.surface, patch)
        unknown = SingularPoints(undecided=(sides,))
        umbilics = UmbilicsOfPatch(undecided=(sides,))
        return PatchInspection(patch, sides, PatchKind.UNDECIDED, False, None, None, unknown, umbilics)


def inspect_patch(forms: SurfaceForms, patch: Patch) -> PatchInspection:
    """The features of one patch (see `SurfaceInspection`)."""
    surface, sides = forms.surface, sides_of(forms.surface, patch)
    singular = singular_points(forms, patch)
    if singular.degenerate:
        kind = PatchKind.POINT if is_point(surface, patch) else PatchKind.CURVE
        return PatchInspection(patch, sides, kind, False, None, None, singular, UmbilicsOfPatch())
    umbilics = umbilics_of_patch(forms, patch, singular)
    minimal = on_patch(forms.minimality, patch) is None
    own, curvature = on_patch(forms.parabolic, patch), constant_curvature(forms, patch)
    if own is None:
        kind = PatchKind.PLANAR if all(on_patch(f, patch) is None for f in forms.second) else PatchKind.DEVELOPABLE
        return PatchInspection(patch, sides, kind, minimal, None, None, singular, umbilics, curvature)
    if umbilics.everywhere:
        assert curvature, "a surface all of whose points are umbilics is a plane or a sphere"
        kind = PatchKind.SPHERICAL
        return PatchInspection(patch, sides, kind, minimal, 1 / curvature, None, singular, umbilics, curvature)
    edges = tuple(edge for edge, times in zip(EDGES, own.borders, strict=True) if times and edge not in singular.edges)
    form = singular.of_factor.without(own.form, even=True)
    signs = sign_on_patch(form)
    inspection = PatchInspection(
        patch, sides, _BY_SIGN[signs.sign], minimal, None, signs, singular, umbilics, curvature, edges
    )
    if signs.sign not in (Sign.POSITIVE, Sign.NEGATIVE):
        inspection = _with_zeros(inspection, own, form, on_patch(forms.area, patch))
    # the remaining case: its only zeros are points without a tangent plane
    zeros = inspection.parabolic or inspection.parabolic_lines
    bare = inspection.kind in _STRICT and inspection.complete and not zeros
    return replace(inspection, kind=_STRICT[inspection.kind]) if bare else inspection


def _with_zeros(inspection: PatchInspection, own: Reduced, form: PatchForm, area: Reduced | None) -> PatchInspection:
    """The inspection with the zeros of K, if there are or may be any, and with the sign of K if the zeros determine
    it.
    """
    assert area is not None, "the patch has tangent planes"
    singular, sides = inspection.singular, inspection.sides
    simple = square_free(singular.of_factor.without(form))
    rest, lines = without_lines(simple, sides)
    # a singular point is a critical point of the form itself, but not of the form without factors
    known = singular.inside if rest.degree == own.form.degree else []
    curve = ZeroCurve(rest, known)
    kind = inspection.kind
    if kind is PatchKind.UNDECIDED:
        kind = _BY_SIGN[_sign_by_zeros(form, curve, simple)]
    inspection = replace(inspection, kind=kind, parabolic_lines=lines, curve=curve)
    pieces = [Piece(inspection.patch, sides, curve, part) for part in curve.parts]
    parts = tuple(piece.part for piece in pieces if not _is_known(piece, inspection, area, known))
    return replace(inspection, parabolic=parts)


def _sign_by_zeros(form: PatchForm, curve: ZeroCurve, simple: PatchForm) -> Sign:
    """The sign of a form that has zeros. The sign is determined by the factors of odd power, which change sign across
    each curve on which they vanish; `curve` holds the zeros of the square-free form `simple`, except lines.
    """
    odd = odd_part(form)
    sign = sign_on_patch(odd)
    if sign.sign is not Sign.UNDECIDED:
        keeps = sign.sign is not Sign.BOTH
        return Sign.BOTH if not keeps else Sign.NOT_NEGATIVE if sign.positive else Sign.NOT_POSITIVE
    rest, lines = without_lines(odd, UNIT)
    own = curve if as_polynomial(odd) in (as_polynomial(simple), -as_polynomial(simple)) else ZeroCurve(rest)
    if lines or own.has_branches:
        return Sign.BOTH
    if not own.complete:
        return Sign.UNDECIDED
    return Sign.NOT_NEGATIVE if sign.positive else Sign.NOT_POSITIVE


def _is_known(piece: Piece, inspection: PatchInspection, area: Reduced, known: Sequence[CommonZero]) -> bool:
    """Whether a single zero of K is a point without a tangent plane, as the points `known` are, or on an edge or a line
    along which K vanishes.
    """
    if piece.part.shape is not Shape.POINT:
        return False
    place = place_of(piece)
    if any(_is_on(place, 1 - line.direction, value) for line, value in inspection.parabolic_lines):
        return True
    if place.is_inside:
        return any(point.is_in_region_of(place.zero) for point in known) or place.zero.is_zero_of(area.form)
    return vanishes_at(area.whole, place.spot, inspection.sides) or any(
        place.spot[edge.direction] == edge.value(inspection.sides) for edge in inspection.parabolic_edges
    )


def _is_on(place: Place, direction: int, value: Parameter) -> bool:
    """Whether a parameter of a point has this value."""
    low, high = place.box(DIGITS)[direction]
    return bool(low <= value <= high and place.spot[direction] == value)
