"""What a surface has, patch by patch and as a whole: the sign of K, parabolic curves, umbilics, degeneracies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum

from exactspline.exact import mpq
from exactspline.geometry.surface.borders import EDGES, Edge
from exactspline.geometry.surface.chains import ParabolicCurve, Piece, chained
from exactspline.geometry.surface.common_factor import odd_part, square_free, without_powers
from exactspline.geometry.surface.constant import constant_curvature
from exactspline.geometry.surface.degenerate import Jump, Pole, closed_along, is_point, jumps, line_of, pole_at
from exactspline.geometry.surface.forms import Patch, Reduced, SurfaceForms, in_parameters, on_patch, sides_of
from exactspline.geometry.surface.places import Parameter, Place
from exactspline.geometry.surface.signs import Point, Sign, Signs, sign_on_patch
from exactspline.geometry.surface.singular import SingularPoints, singular_points
from exactspline.geometry.surface.umbilics import Umbilic, UmbilicsOfPatch, same_place, umbilics_of_patch
from exactspline.geometry.surface.zero_curve import Part, Shape, ZeroCurve
from exactspline.splines.patch_forms import Box, Interval, PatchForm
from exactspline.splines.surface import Along, NurbsSurface


class PatchKind(StrEnum):
    """What is proved of the Gaussian curvature on a whole patch, except on edges that are listed."""

    PLANAR = "planar"
    DEVELOPABLE = "developable"
    SPHERICAL = "spherical"
    ELLIPTIC = "elliptic"
    HYPERBOLIC = "hyperbolic"
    #: K has both signs.
    MIXED = "elliptic and hyperbolic"
    #: K has one sign but at parabolic points, across which it does not change its sign.
    ELLIPTIC_BUT = "elliptic but for parabolic points"
    HYPERBOLIC_BUT = "hyperbolic but for parabolic points"
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


_STRICT = {PatchKind.ELLIPTIC_BUT: PatchKind.ELLIPTIC, PatchKind.HYPERBOLIC_BUT: PatchKind.HYPERBOLIC}


@dataclass(frozen=True)
class ParabolicLine:
    """An isoparametric line along which K vanishes: ``along`` runs over the `interval`, the other one is `value`.

    `one_sided` tells that it does only as seen from the patches on one side of the line.
    """

    along: Along
    value: mpq
    interval: Interval
    #: Whether the line runs through a whole period of a closed surface.
    closed: bool = False
    one_sided: bool = False


@dataclass(frozen=True)
class PatchInspection:
    """What one patch has."""

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
    #: The Gaussian curvature where it is constant.
    curvature: mpq | None = None
    #: Edges along which K vanishes, and the parts of its other zeros.
    parabolic_edges: tuple[Edge, ...] = ()
    curve: ZeroCurve | None = field(default=None, repr=False, compare=False)

    @property
    def parabolic(self) -> tuple[Part, ...]:
        """The connected parts of the zeros of K inside; singular points of the surface are none of them."""
        if self.curve is None:
            return ()
        return tuple(part for part in self.curve.parts if not self._is_singular(part))

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """The same, each with the patch it is on."""
        return tuple(Piece(self.patch, self.sides, self.curve, part) for part in self.parabolic if self.curve)

    @property
    def parabolic_points(self) -> tuple[Point, ...]:
        """The single points at which K vanishes where it has one sign otherwise, in the parameters of the surface."""
        found = () if self.signs is None or self.curve is not None else self.signs.zeros
        points = [in_parameters(((x, x), (y, y)), self.sides) for x, y in found]
        return tuple((u, v) for (u, _), (v, _) in points)

    def is_parabolic_along(self, edge: Edge) -> bool:
        """Whether K vanishes along an edge, as seen from this patch."""
        return edge in self.parabolic_edges or self.kind in (PatchKind.PLANAR, PatchKind.DEVELOPABLE)

    def _is_singular(self, part: Part) -> bool:
        return part.shape is Shape.POINT and any(
            all(q[0] <= p[0] and p[1] <= q[1] for p, q in zip(zero.box, cell, strict=True))
            for cell in part.cells
            for zero in self.singular.zeros
        )

    @property
    def complete(self) -> bool:
        """Whether everything about the patch was decided."""
        curve = self.curve is None or self.curve.complete
        return (
            curve and not (self.singular.undecided or self.umbilics.undecided) and self.kind is not PatchKind.UNDECIDED
        )


@dataclass(frozen=True)
class SurfaceInspection:
    """What a surface has."""

    surface: NurbsSurface
    patches: tuple[PatchInspection, ...]
    #: Each once, also where patches or the two ends of a closed surface meet.
    umbilics: tuple[Umbilic, ...]
    parabolic_lines: tuple[ParabolicLine, ...]
    #: Whole, across borders of patches where these are zeros of K on both sides.
    parabolic_curves: tuple[ParabolicCurve, ...]
    poles: tuple[Pole, ...]
    jumps: tuple[Jump, ...]
    #: The parameters in which it is closed.
    closed: tuple[Along, ...]

    @property
    def kinds(self) -> tuple[PatchKind, ...]:
        """The kinds of its patches, each once."""
        return tuple(dict.fromkeys(one.kind for one in self.patches))

    @property
    def umbilic_everywhere(self) -> bool:
        """Whether every point is an umbilic."""
        return all(one.umbilics.everywhere for one in self.patches)

    @property
    def curvature(self) -> mpq | None:
        """The Gaussian curvature where it is the same at all points of the surface."""
        found = {one.curvature for one in self.patches if one.kind not in (PatchKind.CURVE, PatchKind.POINT)}
        return found.pop() if len(found) == 1 else None

    @property
    def minimal(self) -> bool:
        """Whether the mean curvature vanishes everywhere."""
        return all(one.minimal for one in self.patches)

    @property
    def singular_points(self) -> tuple[Place, ...]:
        """The single points without a tangent plane; one on a border of patches once."""
        found: list[Place] = []
        for place in (place for one in self.patches for place in one.singular.places):
            if place.inner is not None or not any(same_place(place, known) for known in found):
                found.append(place)
        return tuple(found)

    @property
    def complete(self) -> bool:
        """Whether everything was decided."""
        return all(one.complete for one in self.patches)


def inspect_surface(surface: NurbsSurface) -> SurfaceInspection:
    """The sign of the Gaussian curvature on every patch of a surface in space, its parabolic curves, all its umbilics,
    poles, singular points and jumps, certified.

    >>> from exactspline import example_surface
    >>> found = inspect_surface(example_surface("ellipsoid"))
    >>> [kind.value for kind in found.kinds], len(found.umbilics), found.complete
    (['elliptic'], 4, True)
    >>> [(line.along.value, str(line.value)) for line in inspect_surface(example_surface("torus")).parabolic_lines]
    [('u', '1'), ('u', '3')]

    Raises `ShapeError` for a surface that is not in space.
    """
    forms = SurfaceForms(surface)
    patches = tuple(inspect_patch(forms, patch) for patch in forms.patches)
    closed = tuple(along for along in Along if closed_along(surface, along))
    poles = dict.fromkeys(pole_at(forms, one.patch, edge) for one in patches for edge in one.singular.edges)
    return SurfaceInspection(
        surface,
        patches,
        _merged(forms, patches, closed),
        _parabolic_lines(surface, patches, closed),
        chained([piece for one in patches for piece in one.pieces], surface.domain, closed),
        tuple(poles),
        tuple(jumps(surface)),
        closed,
    )


def inspect_patch(forms: SurfaceForms, patch: Patch) -> PatchInspection:
    """What one patch has (see `inspect_surface`)."""
    surface, sides = forms.surface, sides_of(forms.surface, patch)
    singular = singular_points(forms, patch)
    if singular.degenerate:
        kind = PatchKind.POINT if is_point(surface, patch) else PatchKind.CURVE
        return PatchInspection(patch, sides, kind, False, None, None, singular, UmbilicsOfPatch())
    umbilics = umbilics_of_patch(forms, patch, singular)
    minimal = on_patch(forms.minimality, patch) is None
    own, curvature = on_patch(forms.parabolic, patch), constant_curvature(forms, patch)
    if own is None:
        flat = all(on_patch(f, patch) is None for f in forms.second)
        kind = PatchKind.PLANAR if flat else PatchKind.DEVELOPABLE
        return PatchInspection(patch, sides, kind, minimal, None, None, singular, umbilics, curvature)
    if umbilics.everywhere:
        assert curvature, "a surface all of whose points are umbilics, and no plane, is a sphere"
        kind = PatchKind.SPHERICAL
        return PatchInspection(patch, sides, kind, minimal, 1 / curvature, None, singular, umbilics, curvature)
    edges = tuple(edge for edge, times in zip(EDGES, own.borders, strict=True) if times and edge not in singular.edges)
    kind, signs, curve = _sign_of(own, singular, forms, patch)
    found = PatchInspection(patch, sides, kind, minimal, None, signs, singular, umbilics, curvature, edges, curve)
    everything = curve is None or curve.complete
    # what is left where its only zeros are points without a tangent plane
    bare = kind in _STRICT and everything and not (found.parabolic or found.parabolic_points)
    return replace(found, kind=_STRICT[kind]) if bare else found


def _sign_of(
    own: Reduced, singular: SingularPoints, forms: SurfaceForms, patch: Patch
) -> tuple[PatchKind, Signs, ZeroCurve | None]:
    """What the sign of K makes of a patch, and the zeros of K where there are some or may be."""
    form = own.form if singular.factor is None else without_powers(own.form, singular.factor, even=True)
    signs = _of_surface(sign_on_patch(form), forms, patch)
    curve = None
    if signs.sign in (Sign.BOTH, Sign.UNDECIDED):
        bare = form if singular.factor is None else without_powers(form, singular.factor)
        simple = square_free(bare)
        # a singular point is a critical point of the form itself, not of what is left of it
        known = singular.zeros if simple.degree == own.form.degree else ()
        curve = ZeroCurve(simple, known)
    kind = _BY_SIGN[signs.sign]
    if kind is PatchKind.UNDECIDED and curve is not None and (curve.is_of_points or _keeps_sign(form)):
        kind = PatchKind.ELLIPTIC_BUT if signs.positive else PatchKind.HYPERBOLIC_BUT
    return kind, signs, curve


def _keeps_sign(form: PatchForm) -> bool:
    """Whether a form has one sign on a patch where it is not zero: its factors of odd power have."""
    return sign_on_patch(odd_part(form)).sign in (Sign.POSITIVE, Sign.NEGATIVE)


def _of_surface(signs: Signs, forms: SurfaceForms, patch: Patch) -> Signs:
    """The zeros at which there is a tangent plane, and which are not on an edge along which K vanishes anyway."""
    area, own = on_patch(forms.area, patch), on_patch(forms.parabolic, patch)
    assert area is not None
    assert own is not None
    lines = [edge for edge, times in zip(EDGES, own.borders, strict=True) if times]
    return replace(
        signs,
        zeros=tuple(
            spot
            for spot in signs.zeros
            if area.whole.value(*spot) and not any(spot[edge.direction] == edge.end for edge in lines)
        ),
    )


# ---- the surface as a whole


def _merged(forms: SurfaceForms, patches: Sequence[PatchInspection], closed: Sequence[Along]) -> tuple[Umbilic, ...]:
    """All umbilics, those on borders of patches once."""
    domain, meshes = forms.surface.domain, forms.surface.meshes
    found: list[Umbilic] = []
    for one in patches:
        for umbilic in one.umbilics.umbilics:
            place = umbilic.place
            known = None if place.inner is not None else _same(umbilic, found, closed, domain)
            if known is None:
                found.append(umbilic)
            else:
                k = found.index(known)
                found[k] = replace(known, place=known.place.with_patches(place.patches))
    return tuple(_sided(umbilic, [list(mesh.breaks) for mesh in meshes], closed) for umbilic in found)


def _same(umbilic: Umbilic, known: Sequence[Umbilic], closed: Sequence[Along], domain: Box) -> Umbilic | None:
    for other in known:
        if other.place.inner is None and all(
            _equal(getattr(umbilic.place, along.value), getattr(other.place, along.value), along in closed, side)
            for along, side in zip(Along, domain, strict=True)
        ):
            return other
    return None


def _equal(one: Parameter, other: Parameter, closed: bool, side: Interval) -> bool:
    """Whether two parameters are one, the ends of a closed direction counted as one."""
    if one == other:
        return True
    return closed and any(one == a and other == b for a, b in (side, side[::-1]))


def _sided(umbilic: Umbilic, breaks: list[list[mpq]], closed: Sequence[Along]) -> Umbilic:
    """The umbilic, marked as one-sided where not all the patches that meet there have it."""
    if umbilic.place.inner is not None:
        return umbilic
    expected = 1
    for t, own, along in zip((umbilic.place.u, umbilic.place.v), breaks, Along, strict=True):
        inner = any(t == x for x in own[1:-1])
        seam = along in closed and (t == own[0] or t == own[-1]) and len(own) > 2
        expected *= 2 if inner or seam else 1
    return replace(umbilic, one_sided=len(umbilic.place.patches) < expected)


def _parabolic_lines(
    surface: NurbsSurface, patches: Sequence[PatchInspection], closed: Sequence[Along]
) -> tuple[ParabolicLine, ...]:
    """Edges of patches on which K vanishes, neighbours as one line."""
    sides: dict[tuple[Along, mpq, bool], set[Interval]] = {}
    by_place = {one.patch: one for one in patches}
    for one in patches:
        for edge in one.parabolic_edges:
            behind = by_place.get(_behind(one.patch, edge, surface.patches, closed))
            one_sided = behind is not None and not behind.is_parabolic_along(Edge(edge.direction, 1 - edge.end))
            key = line_of(edge), edge.value(one.sides), one_sided
            sides.setdefault(key, set()).add(one.sides[1 - edge.direction])
    lines = []
    for (along, value, one_sided), intervals in sorted(sides.items()):
        joined: list[Interval] = []
        for a, b in sorted(intervals):
            if joined and joined[-1][1] == a:
                joined[-1] = joined[-1][0], b
            else:
                joined.append((a, b))
        domain = surface.domain[along.direction]
        lines += [ParabolicLine(along, value, side, along in closed and side == domain, one_sided) for side in joined]
    return _without_seam(lines, surface.domain, closed)


def _behind(patch: Patch, edge: Edge, counts: tuple[int, int], closed: Sequence[Along]) -> Patch:
    """The patch on the other side of an edge; one that does not exist at the end of a surface that is not closed."""
    place = list(patch)
    k = edge.direction
    place[k] += 1 if edge.end else -1
    if list(Along)[k] in closed:
        place[k] %= counts[k]
    return place[0], place[1]


def _without_seam(lines: list[ParabolicLine], domain: Box, closed: Sequence[Along]) -> tuple[ParabolicLine, ...]:
    """The lines, one on the seam of a closed surface once."""
    kept = []
    for line in lines:
        across = Along.V if line.along is Along.U else Along.U
        low, high = domain[across.direction]
        if across in closed and line.value == high and replace(line, value=low) in lines:
            continue
        kept.append(line)
    return tuple(kept)


__all__ = ["PatchInspection", "PatchKind", "SurfaceInspection", "inspect_patch", "inspect_surface"]
