"""Umbilics: points where the two principal curvatures are equal, so that every direction is a principal direction.

Where the surface has a tangent plane, the umbilics are the common zeros of the three coefficients A, B, C of the
equation of the lines of curvature. Since ``A G − B F + C E = 0``, two coefficients suffice: A and B where E > 0, B and
C where G > 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise, product

from flint import ctx

from exactspline.bivariate.across_borders import Place, Spot, alike, together, within
from exactspline.bivariate.borders import EDGES, Edge, Patch, along, common_along, roots_along
from exactspline.bivariate.common_zeros import CommonZero, zeros_of
from exactspline.bivariate.quotients import polynomials_on
from exactspline.bivariate.zero_lines import common_factor, divided
from exactspline.errors import ReachError
from exactspline.geometry.surfaces.forms import Reduced, SurfaceForms, on_patch, sides_of
from exactspline.geometry.surfaces.singular import FAR, NONE, SingularPoints, ZerosOfFactor, singular_points
from exactspline.numbers.exact import mpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, ball_around
from exactspline.one_line import OneLine
from exactspline.polynomials.patch_forms import PatchForm, jacobian_sign, rounded
from exactspline.polynomials.two_parameters import as_form, as_polynomial, enclosed, jacobian
from exactspline.roots.of_polynomials import Parameter, exactly
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline

#: The bits of a point at which the kind of an umbilic is determined, the last for surfaces 10³⁰⁰ times as high as wide.
KIND_BITS = 20, 40, 130, 2400


class UmbilicKind(StrEnum):
    """The kind of an umbilic. On a loop around an umbilic the lines of curvature turn by half a turn, in the sense of
    the loop or in the opposite sense (a star). In the first case lines of curvature run into the umbilic in one
    direction (a lemon) or in three directions (a monstar); where two of the three directions coincide, the umbilic is
    between both kinds.

    Source: Berry and Hannay, Umbilic points on Gaussian random surfaces, Journal of Physics A 1977.
    """

    POSITIVE = "lemon or monstar"
    LEMON = "lemon"
    MONSTAR = "monstar"
    NEGATIVE = "star"
    MULTIPLE = "multiple"
    UNKNOWN = "of unknown kind"


#: The kinds of index ½.
HALF = {UmbilicKind.POSITIVE, UmbilicKind.LEMON, UmbilicKind.MONSTAR}


@dataclass(frozen=True, repr=False)
class Umbilic(OneLine):
    """One umbilic: its place and its kind, which is of index ½, of index −½, or a multiple zero of the equations.

    `one_sided` means that the point is an umbilic of only some of the patches that meet there.
    """

    place: Place
    kind: UmbilicKind
    one_sided: bool = False


@dataclass(frozen=True, repr=False)
class UmbilicsOfPatch(OneLine):
    """The umbilics of one closed patch.

    `umbilics`: single umbilics inside, and umbilics on the border, at which curves of this or another patch may end
    (`exactspline.bivariate.across_borders` distinguishes these cases); `everywhere`: all points of the patch are
    umbilics; `edges`: the edges consisting of umbilics; `of_factor`: the zeros of a common factor of the equations,
    lines and curves of umbilics inside; `undecided`: boxes of parameters in which there may be more umbilics.
    """

    umbilics: tuple[Umbilic, ...] = ()
    everywhere: bool = False
    edges: tuple[Edge, ...] = ()
    of_factor: ZerosOfFactor = NONE
    undecided: tuple[Box, ...] = ()


def umbilics_of_patch(forms: SurfaceForms, patch: Patch, singular: SingularPoints | None = None) -> UmbilicsOfPatch:
    """The umbilics of a patch, each certified.

    >>> from exactspline import example
    >>> umbilics = umbilics_of_patch(SurfaceForms(example("monkey_saddle")), (0, 0))
    >>> [(umbilic.place.exact, umbilic.kind.value) for umbilic in umbilics.umbilics], umbilics.undecided
    ([((mpq(0,1), mpq(0,1)), 'star')], ())
    """
    singular = singular_points(forms, patch) if singular is None else singular
    if singular.degenerate:
        return UmbilicsOfPatch()
    own = [on_patch(f, patch) for f in forms.lines]
    if not any(own):
        return UmbilicsOfPatch(everywhere=True)
    search = _Search(forms, patch, own, singular)
    edges, on_edges = search.on_edges()
    inside, of_factor, undecided = search.inside()
    return UmbilicsOfPatch((*on_edges, *inside), False, edges, of_factor, undecided)


class _Search:
    """The equations of one patch."""

    def __init__(
        self, forms: SurfaceForms, patch: Patch, own: Sequence[Reduced | None], singular: SingularPoints
    ) -> None:
        self.patch, self.own, self.singular = patch, own, singular
        self.sides, self.lines = sides_of(forms.surface, patch), forms.lines
        area = on_patch(forms.area, patch)
        assert area is not None
        self.area = area
        #: E, F, G.
        self.first = [f.patch_form(*patch) for f in forms.first]

    def on_edges(self) -> tuple[tuple[Edge, ...], list[Umbilic]]:
        """The edges of umbilics, and the umbilics on the other edges, at which a curve of umbilics may end."""
        given = [f.whole for f in self.own if f is not None]
        edges, places = [], dict[tuple[Parameter, Parameter], None]()
        for edge in EDGES:
            if edge in self.singular.edges:
                continue
            common = common_along(given, edge, self.sides)
            if not common:
                edges.append(edge)
                continue
            area = along(self.area.whole, edge, self.sides)
            roots = [root for root in roots_along(common, edge, self.sides) if not root.is_root_of(area)]
            places.update({edge.place(self.sides, exactly(root)): None for root in roots})
        single = [x for x in places if not any(x[edge.direction] == edge.value(self.sides) for edge in edges)]
        return tuple(edges), [self._umbilic(CommonZero.at(self.sides, place)) for place in single]

    def _umbilic(self, zero: CommonZero) -> Umbilic:
        return Umbilic(Place((self.patch,), zero), self._kind(zero))

    def inside(self) -> tuple[list[Umbilic], ZerosOfFactor, tuple[Box, ...]]:
        """The umbilics inside, the curves of umbilics, and the undecided boxes."""
        # singular points at which the equations vanish after division by common factors
        known, singular = self.singular.inside, self.singular.of_factor
        given = {k: singular.without(f.form) for k, f in enumerate(self.own) if f is not None}
        factor = common_factor(list(given.values()))
        if factor is not None:
            given = {k: divided(f, factor) for k, f in given.items()}
        for f in (*singular.factors, *([] if factor is None else [factor])):
            known = [zero for zero in known if rounded(f, zero.refine(FAR)).sign in (1, -1)]
        # A G − B F + C E = 0
        found = zeros_of(list(given.values()), self.sides, cofactors=[[self.first[2 - k]] for k in given], known=known)
        undecided = list(found.undecided)
        zeros = [zero for zero in found.zeros if zero.is_inside and self._has_tangent_plane(zero, known, undecided)]
        of_factor = ZerosOfFactor.of(factor, self.sides)
        if of_factor.whole is not None:
            zeros, rest = of_factor.with_single_points(zeros, self.singular.inside)
            undecided += rest
            zeros = [zero.on(self.sides) for zero in zeros if self._has_tangent_plane(zero, (), undecided)]
        return [self._umbilic(zero) for zero in zeros], of_factor, tuple(map(self.sides.part, undecided))

    def _has_tangent_plane(self, zero: CommonZero, known: Sequence[CommonZero], undecided: list[Box]) -> bool:
        """Whether the surface has a tangent plane at a zero of the equations; False also if this is undecided."""
        if any(point.is_in_region_of(zero) for point in known):
            return False
        try:
            return not zero.is_zero_of(self.area.form)
        except ReachError:
            undecided.append(zero.refine(FAR))
            return False

    def _kind(self, zero: CommonZero) -> UmbilicKind:
        """The kind of an umbilic: its index is half the sign of the Jacobian of A and B if E > 0, and of B and C if G >
        0. The kind is multiple if both Jacobians vanish.
        """
        lengths = self.first[0], self.first[2]
        pairs = [(f.whole, g.whole, e) for (f, g), e in zip(pairwise(self.own), lengths, strict=True) if f and g]
        for bits, (f, g, length) in product(KIND_BITS, pairs):
            around = (side.grown(mpq(1, 1 << bits)) for side in zero.refine(bits))
            box = Box(*(side.inside(whole) for side, whole in zip(around, UNIT, strict=True)))
            if rounded(length, box).sign == 1 and (sign := jacobian_sign(rounded(f, box), rounded(g, box))):
                return self._around(zero) if sign > 0 else UmbilicKind.NEGATIVE
        try:
            multiple = zero.isolated is None and all(zero.is_zero_of(_jacobian(f, g)) for f, g, _ in pairs)
        except ReachError:
            return UmbilicKind.UNKNOWN
        return UmbilicKind.MULTIPLE if multiple else UmbilicKind.UNKNOWN

    def _around(self, zero: CommonZero) -> UmbilicKind:
        """A lemon or a monstar, by the discriminant of the cubic form ``A du² + B du dv + C dv²`` with the linear parts
        of A, B, C in du, dv: its zeros are the directions of lines of curvature that run into the umbilic.
        """
        h, k = (side.width for side in self.sides)
        a, b, c = polynomials_on(self.patch, *map(TensorSpline.scaled, self.lines, (h * h, h * k, k * k)))
        cubic = a.derivative(0), a.derivative(1) + b.derivative(0), b.derivative(1) + c.derivative(0), c.derivative(1)
        for bits in KIND_BITS:
            with ctx.workprec(2 * bits + 64):
                s, t = (ball_around(*side) for side in zero.refine(bits))
                p, q, r, w = (enclosed(x, s, t) for x in cubic)
                sign = sign_of(q * r * (q * r + 18 * p * w) - 4 * (p * r * r * r + w * q * q * q) - 27 * p * w * p * w)
            if sign:
                return UmbilicKind.MONSTAR if sign > 0 else UmbilicKind.LEMON
        return UmbilicKind.POSITIVE


def _jacobian(f: PatchForm, g: PatchForm) -> PatchForm:
    """The Jacobian determinant of two forms, up to a positive constant."""
    return as_form(jacobian(as_polynomial(f), as_polynomial(g)))


#: The sides of a point, in u and in v, on which something lies; they do not depend on how knots cut the patches around
#: the point.
Sectors = set[tuple[int, int]]


def _sectors(spot: Spot, box: Box) -> Sectors:
    """The sides of a point of a closed rectangle on which the rectangle lies."""
    first, second = (
        [sign for sign, end in ((-1, low), (1, high)) if t != end] for t, (low, high) in zip(spot, box, strict=True)
    )
    return set(product(first, second))


def merged_umbilic(own: Sequence[Umbilic], whole: Sequence[Box], domain: Box, closed: Sequence[Along]) -> Umbilic:
    """One umbilic found on several patches. The umbilic is one-sided if it is not an umbilic on all sides; a patch on
    which all points are umbilics (`whole`) counts as a side on which it is. The kind is unknown if the umbilic has
    different kinds on the patches (curvatures jump there).
    """
    place, kinds = together([one.place for one in own]), {one.kind for one in own}
    if place.is_inside:
        return own[0]
    others, found = alike(place.spot, domain, closed), [(one.place.spot, one.place.zero.sides) for one in own]
    found += [(spot, box) for spot in others for box in whole if within(spot, box)]
    seen = {sector for spot, box in found for sector in _sectors(spot, box)}
    around = {sector for spot in others for sector in _sectors(spot, domain)}
    kind = UmbilicKind.POSITIVE if kinds <= HALF else UmbilicKind.UNKNOWN
    return Umbilic(place, own[0].kind if len(kinds) == 1 else kind, one_sided=seen != around)
