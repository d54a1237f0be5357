"""Points at which a surface has no tangent plane: isolated and certified inside patches, listed along their borders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from exactspline.bivariate.borders import EDGES, Edge, Patch, along, roots_along
from exactspline.bivariate.common_factor import common_factor, divided, square_free
from exactspline.bivariate.common_zeros import CommonZero, zeros_of
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.bivariate.surface_points import Place
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.errors import ReachError
from exactspline.geometry.surfaces.forms import SurfaceForms, on_patch, sides_of
from exactspline.numbers.intervals import Box
from exactspline.polynomials.patch_forms import PatchForm

#: Bits of a box around a point that is undecided.
FAR = 64


@dataclass(frozen=True)
class SingularPoints:
    """Where the normal of a patch vanishes: `degenerate`: everywhere; along whole `edges`; at `places`, single ones
    inside, and those on the border, at which curves may end, also those of other patches; at the zeros of a common
    factor of its coordinates (`curve`), which are more than single points if it is so `along_curve`; `undecided` are
    boxes of parameters.
    """

    degenerate: bool = False
    edges: tuple[Edge, ...] = ()
    places: tuple[Place, ...] = ()
    undecided: tuple[Box, ...] = ()
    curve: ZeroCurve | None = field(default=None, compare=False)
    along_curve: bool = False

    @property
    def inside(self) -> list[CommonZero]:
        """The places inside."""
        return [place.zero for place in self.places if place.is_inside]

    @property
    def regular(self) -> bool:
        """Whether there are none except along edges."""
        return not (self.degenerate or self.places or self.undecided or self.along_curve)


def singular_points(forms: SurfaceForms, patch: Patch) -> SingularPoints:
    """The singular points of a patch."""
    sides = sides_of(forms.surface, patch)
    area = on_patch(forms.area, patch)
    if area is None:
        return SingularPoints(degenerate=True)
    edges = tuple(edge for edge in EDGES if not any(area.whole.edge(*edge)))
    places = [
        Place((patch,), CommonZero.at(sides, edge.place(sides, root)))
        for edge in EDGES
        if edge not in edges
        for root in roots_along(along(area.whole, edge, sides), edge, sides)
        if not any(root == other.value(sides) for other in edges if other.direction != edge.direction)
    ]
    if sign_on_patch(area.form).sign is Sign.POSITIVE:
        return SingularPoints(False, edges, tuple(places))
    normal = [None if own is None else own.form for own in (on_patch(f, patch) for f in forms.normal)]
    factor = common_factor([f for f in normal if f is not None])
    curve, along_curve = None, False
    if factor is not None:
        normal = [None if f is None else divided(f, factor) for f in normal]
        curve, along_curve = curve_of(factor)
    # the scalar products of the normal with both tangents are zero
    tangents = [[f.patch_form(*patch) for f in pair] for pair in zip(*forms.tangents, strict=True)]
    given = [(f, e) for f, e in zip(normal, tangents, strict=True) if f is not None]
    found = zeros_of([f for f, _ in given], sides, cofactors=[e for _, e in given])
    inside, undecided = [zero for zero in found.zeros if zero.is_inside], list(found.undecided)
    if curve is not None:
        inside, rest = with_single_points(curve, inside)
        undecided += rest
    places += [Place((patch,), zero.on(sides)) for zero in inside]
    return SingularPoints(False, edges, tuple(places), tuple(sides.part(box) for box in undecided), curve, along_curve)


def curve_of(factor: PatchForm) -> tuple[ZeroCurve | None, bool]:
    """The zeros of a factor, if it has any, and whether they are more than single points."""
    sign = sign_on_patch(factor).sign
    if sign in (Sign.POSITIVE, Sign.NEGATIVE):
        return None, False
    curve = ZeroCurve(square_free(factor))
    return curve, curve.has_branches or sign is Sign.BOTH


def with_single_points(
    curve: ZeroCurve, found: Sequence[CommonZero], known: Sequence[CommonZero] = ()
) -> tuple[list[CommonZero], list[Box]]:
    """Points found inside, but for those on a curve, and the single points of it, but for those that are `known`; and
    the boxes in which something is undecided.
    """
    kept, undecided = list[CommonZero](), list(curve.undecided)
    for zero in (*found, *curve.single_points):
        try:
            if not (zero.is_zero_of(curve.form) if zero in found else any(zero.is_at(other) for other in known)):
                kept.append(zero)
        except ReachError:
            undecided.append(zero.refine(FAR))
    return kept, undecided
