"""Points at which a surface has no tangent plane: isolated and certified inside patches, listed along their borders."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.geometry.surface.borders import EDGES, Edge, along, is_inside, roots_along, vanishes_at
from exactspline.geometry.surface.common_factor import common_factor, divided, square_free
from exactspline.geometry.surface.forms import Patch, SurfaceForms, on_patch, sides_of
from exactspline.geometry.surface.places import InnerZero, Place
from exactspline.geometry.surface.remaining import is_one, place_at, remaining_zeros
from exactspline.geometry.surface.signs import Sign, sign_on_patch
from exactspline.geometry.surface.zero_curve import ZeroCurve
from exactspline.numbers.intervals import Box
from exactspline.polynomials.common_zeros import Zero, are_one, is_known, isolate, same
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import over
from exactspline.roots.common_zeros import CommonZero
from exactspline.roots.root import Root

#: Refinement limit (bits) for classifying a zero.
BITS = 400


@dataclass(frozen=True)
class SingularPoints:
    """Where the normal of a patch vanishes: `degenerate`: everywhere; along whole `edges`; `along_curve`: on a curve
    inside; at `places` inside and on the border; `undecided` are boxes of parameters. A `factor` is common to its
    coordinates.
    """

    degenerate: bool = False
    edges: tuple[Edge, ...] = ()
    places: tuple[Place, ...] = ()
    #: The certified zeros inside, in the parameters of the patch.
    zeros: tuple[Zero, ...] = ()
    undecided: tuple[Box, ...] = ()
    factor: PatchForm | None = None
    #: Whether the factor is zero on more than single points.
    along_curve: bool = False

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
        Place((patch,), None, *edge.place(sides, root))
        for edge in EDGES
        if edge not in edges
        for root in roots_along(along(area.whole, edge, sides), edge, sides)
        if not any(_is_end(root, other, sides) for other in edges if other.direction != edge.direction)
    ]
    if sign_on_patch(area.form).sign is Sign.POSITIVE:
        return SingularPoints(False, edges, tuple(places))
    normal = [None if own is None else own.form for own in (on_patch(f, patch) for f in forms.normal)]
    factor = common_factor([f for f in normal if f is not None])
    curve, along_curve = None, False
    if factor is not None:
        normal = [None if f is None else divided(f, factor) for f in normal]
        sign = sign_on_patch(factor).sign
        if sign in (Sign.POSITIVE, Sign.NEGATIVE):
            factor = None
        else:
            curve = ZeroCurve(square_free(factor))
            along_curve = curve.has_branches or sign is Sign.BOTH
    zeros, undecided = _inner(forms, patch, normal, sides)
    others, undecided = remaining_zeros([f for f in normal if f is not None], undecided, sides, zeros)
    if curve is not None:
        if along_curve:
            places = [place for place in places if not vanishes_at(curve.form, place.spot, sides)]
        for zero in curve.single_points:
            equal = [are_one(zero, known) for known in zeros]
            if None in equal:
                undecided.append(zero.box)
            elif not any(equal):
                others = [other for other in others if not _is_at(zero, other, sides)]
                zeros.append(zero)
        undecided += curve.undecided
    inner = [Place((patch,), InnerZero(zero, sides)) for zero in zeros]
    inner += [place_at(zero, patch) for zero in others]
    boxes = tuple(sides.part(box) for box in undecided)
    return SingularPoints(False, edges, (*places, *inner), tuple(zeros), boxes, factor, along_curve)


def _is_end(root: Root, edge: Edge, sides: Box) -> bool:
    """Whether a point of an edge is one of a neighbouring edge."""
    return bool(root == edge.value(sides))


def _inner(
    forms: SurfaceForms, patch: Patch, normal: list[PatchForm | None], sides: Box
) -> tuple[list[Zero], list[Box]]:
    """The zeros inside of the normal n, whose coordinates have no common factor: where two of them vanish and the third
    coordinate of S_u or S_v does not, n = 0.
    """
    if any(f is not None and f.sign in (1, -1) for f in normal):
        return [], []
    tangents = [[f.patch_form(*patch) for f in side] for side in forms.tangents]
    certain: list[Zero] = []
    rest: list[list[Box]] = []
    for k in range(3):
        first, second = (normal[i] for i in range(3) if i != k)
        third = normal[k]
        if first is None or second is None:
            continue
        degree = max(first.degree[0], second.degree[0]), max(first.degree[1], second.degree[1])
        also = [] if third is None else [third]
        zeros = isolate(first.elevated(degree), second.elevated(degree), also)
        undecided = list(zeros.undecided)
        for zero in zeros.zeros:
            if is_inside(zero, sides) is False:
                continue
            verdict = _is_singular(zero, [side[k] for side in tangents], third)
            if verdict is None:
                undecided.append(zero.box)
            elif verdict and not any(same(zero, known) for known in certain):
                certain.append(zero)
        # the region of a zero of two coordinates contains no other zero of both
        rest.append([box for box in undecided if not is_known(box, certain)])
        if not rest[-1]:
            return certain, []
    return certain, min(rest, key=len, default=[])


def _is_at(zero: Zero, other: CommonZero, sides: Box) -> bool:
    """Whether a certified zero is another point."""
    return all(other.is_zero_of(over(f, sides)) for f in zero.forms) and is_one(other, zero, sides)


def _is_singular(zero: Zero, components: list[PatchForm], third: PatchForm | None) -> bool | None:
    """Whether a zero of two components of the normal is also a zero of the third."""
    bits = 16
    while bits <= BITS:
        box = zero.refine(bits)
        if third is not None and third.part(box).sign in (1, -1):
            return False
        if third is None or any(f.part(box).sign for f in components):
            return True
        bits *= 2
    return None
