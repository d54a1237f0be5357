"""Umbilics: where the two principal curvatures are equal, and every direction is a principal direction.

They are the common zeros of the three coefficients A, B, C of the lines of curvature where the surface has a tangent
plane. Since ``A G − B F + C E = 0``, two of them suffice: A and B where E > 0, B and C where G > 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from exactspline.geometry.surface.borders import EDGES, Edge, along, common_along, is_inside, roots_along
from exactspline.geometry.surface.common_factor import common_factor, divided, square_free, without_powers
from exactspline.geometry.surface.forms import Patch, Reduced, SurfaceForms, on_patch, sides_of
from exactspline.geometry.surface.places import InnerZero, Place
from exactspline.geometry.surface.remaining import place_at, remaining_zeros
from exactspline.geometry.surface.signs import Sign, sign_on_patch
from exactspline.geometry.surface.singular import SingularPoints, singular_points
from exactspline.geometry.surface.zero_curve import ZeroCurve
from exactspline.numbers.intervals import Box
from exactspline.polynomials.common_zeros import Zero, are_one, isolate, same
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, over
from exactspline.roots.common_zeros import CommonZero

#: Refinement limit (bits) for deciding whether a zero is an umbilic.
BITS = 400
#: Bits to which a point is refined to show that it is not on a curve.
FAR = 64
#: Digits of a point at which the kind of an umbilic is read off.
KIND_DIGITS = 40


class UmbilicKind(StrEnum):
    """How the lines of curvature turn on a loop around an umbilic: by half a turn in its sense, or against it
    (a star).
    """

    POSITIVE = "lemon or monstar"
    NEGATIVE = "star"
    MULTIPLE = "multiple"
    UNKNOWN = "of unknown kind"


@dataclass(frozen=True)
class Umbilic:
    """One umbilic: where it is, and its kind: of index ½, of index −½, or a multiple zero of the equations.

    `one_sided` means that it is an umbilic only of some of the patches that meet there.
    """

    place: Place
    kind: UmbilicKind
    one_sided: bool = False


@dataclass(frozen=True)
class UmbilicsOfPatch:
    """The umbilics of one closed patch.

    `everywhere`: all points of the patch; `edges`: the edges consisting of umbilics; `curve`: the zeros of a common
    factor of the equations, where these are not only isolated points; `undecided`: boxes of parameters in which there
    may be more.
    """

    umbilics: tuple[Umbilic, ...] = ()
    everywhere: bool = False
    edges: tuple[Edge, ...] = ()
    curve: ZeroCurve | None = field(default=None, compare=False)
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
    given = [f for f in own if f is not None]
    if not given:
        return UmbilicsOfPatch(everywhere=True)
    search = _Search(forms, patch, own, singular)
    edges, on_edges = search.on_edges()
    inside, curve, undecided = search.inside()
    if curve is not None:
        on_edges = [one for one in on_edges if not search.crosses_border(curve, one.place)]
    return UmbilicsOfPatch((*on_edges, *inside), False, edges, curve, undecided)


class _Search:
    """The equations of one patch."""

    def __init__(
        self, forms: SurfaceForms, patch: Patch, own: Sequence[Reduced | None], singular: SingularPoints
    ) -> None:
        self.forms, self.patch, self.own, self.singular = forms, patch, own, singular
        self.sides = sides_of(forms.surface, patch)
        area = on_patch(forms.area, patch)
        assert area is not None
        self.area = area
        # which of the four edges have no tangent planes
        self.poles = singular.edges
        # singular points at which the equations vanish though common factors are divided out
        self.known = list(singular.zeros)

    def on_edges(self) -> tuple[tuple[Edge, ...], list[Umbilic]]:
        """Edges of umbilics, and the single ones on the other edges."""
        given = [f.whole for f in self.own if f is not None]
        edges, umbilics = [], list[Umbilic]()
        for edge in EDGES:
            if edge in self.poles:
                continue
            common = common_along(given, edge, self.sides)
            if not common:
                edges.append(edge)
                continue
            area = along(self.area.whole, edge, self.sides)
            for root in roots_along(common, edge, self.sides):
                if root.is_root_of(area):
                    continue
                place = Place((self.patch,), None, *edge.place(self.sides, root))
                if not any(same_place(place, one.place) for one in umbilics):
                    umbilics.append(Umbilic(place, self._kind(place.box(30))))
        return tuple(edges), [one for one in umbilics if not any(self._is_on(edge, one.place) for edge in edges)]

    def _is_on(self, edge: Edge, place: Place) -> bool:
        """Whether a point lies on an edge."""
        return bool((place.u, place.v)[edge.direction] == edge.value(self.sides))

    def inside(self) -> tuple[list[Umbilic], ZeroCurve | None, tuple[Box, ...]]:
        """The umbilics inside, a curve of them, and what could not be decided."""
        given = {k: f.form for k, f in enumerate(self.own) if f is not None}
        if self.singular.factor is not None:
            given = {k: without_powers(f, self.singular.factor) for k, f in given.items()}
        factor = common_factor(list(given.values()))
        if factor is not None:
            given = {k: divided(f, factor) for k, f in given.items()}
        for f in (self.singular.factor, factor):
            if f is not None:
                self.known = [zero for zero in self.known if f.part(zero.refine(FAR)).sign in (1, -1)]
        umbilics, undecided = self._without_factor(given)
        sign = None if factor is None else sign_on_patch(factor).sign
        curve = None
        if factor is not None and sign not in (Sign.POSITIVE, Sign.NEGATIVE):
            curve = ZeroCurve(square_free(factor))
            lone, rest = self._at_isolated_zeros(curve.single_points, umbilics)
            umbilics += lone
            undecided += [*curve.undecided, *rest]
            curve = curve if curve.has_branches or sign is Sign.BOTH else None
        return umbilics, curve, tuple(self.sides.part(box) for box in undecided)

    def crosses_border(self, curve: ZeroCurve, place: Place) -> bool:
        """Whether a curve of umbilics goes through a point of an edge, across it: that point is not a single one."""
        for edge in EDGES:
            own, other = (place.u, place.v)[edge.direction], (place.u, place.v)[1 - edge.direction]
            if own == edge.value(self.sides):
                p = along(curve.form, edge, self.sides)
                if any(root == other and root.sign_change for root in roots_along(p, edge, self.sides)):
                    return True
        return False

    def _at_isolated_zeros(
        self, points: Sequence[Zero], umbilics: Sequence[Umbilic]
    ) -> tuple[list[Umbilic], list[Box]]:
        """New umbilics among the isolated zeros of a common factor, and boxes of undecided ones."""
        additional, undecided = list[Umbilic](), list[Box]()
        for zero in points:
            equal = [self._is_at(zero, one.place) for one in umbilics]
            equal += [are_one(zero, point) for point in self.singular.zeros]
            if any(equal):
                continue
            if None in equal or self.area.form.part(zero.refine(BITS)).sign != 1:
                undecided.append(zero.box)
            else:
                additional.append(Umbilic(Place((self.patch,), InnerZero(zero, self.sides)), UmbilicKind.MULTIPLE))
        return additional, undecided

    def _is_at(self, zero: Zero, place: Place) -> bool | None:
        """Whether a zero is at the place of an umbilic; None where the refinement limit is reached."""
        if place.inner is not None:
            return are_one(zero, place.inner.zero)
        if place.exact is None or zero.exact is None:
            return None
        return InnerZero(zero, self.sides).exact == place.exact

    def _without_factor(self, given: dict[int, PatchForm]) -> tuple[list[Umbilic], list[Box]]:
        """The umbilics inside and undecided boxes of the patch, from equations without a common factor."""
        if any(f.sign is not None for f in given.values()):
            return [], []
        best: tuple[list[Umbilic], tuple[Box, ...]] | None = None
        for pair in ((0, 1), (1, 2), (0, 2)):
            if not given.keys() >= set(pair) or (pair == (0, 2) and 1 in given):
                continue
            inner, rest = self._with_pair(given, pair)
            if best is None or len(rest) < len(best[1]):
                best = inner, rest
            if not rest:
                break
        assert best is not None, "a single form is its common factor"
        umbilics, undecided = self._by_elimination(list(given.values()), best[1], best[0])
        return [*best[0], *umbilics], undecided

    def _with_pair(self, given: dict[int, PatchForm], pair: tuple[int, int]) -> tuple[list[Umbilic], tuple[Box, ...]]:
        """The umbilics inside by two equations, and boxes of the patch that are undecided."""
        first, second = (given[k] for k in pair)
        degree = max(first.degree[0], second.degree[0]), max(first.degree[1], second.degree[1])
        also = [f for k, f in given.items() if k not in pair]
        zeros = isolate(first.elevated(degree), second.elevated(degree), also)
        umbilics, undecided = [], list(zeros.undecided)
        for zero in zeros.zeros:
            inside = is_inside(zero, self.sides)
            verdict = self._is_umbilic(zero) if inside else inside
            if verdict is None:
                undecided.append(zero.box)
            elif verdict:
                place = Place((self.patch,), InnerZero(zero, self.sides))
                umbilics.append(Umbilic(place, self._kind(self.sides.part(zero.refine(40)))))
        return umbilics, tuple(undecided)

    def _is_umbilic(self, zero: Zero) -> bool | None:
        """Whether the surface has a tangent plane at a zero of two of the equations inside.

        Then E > 0 and G > 0, and the third equation follows by ``E C − F B + G A = 0``: the pair A, C is used only
        where B is identically zero.
        """
        if any(same(point, zero) for point in self.known):
            return False
        bits = 8
        while bits <= BITS:
            if self.area.form.part(zero.refine(bits)).sign == 1:
                return True
            bits *= 2
        return None

    def _kind(self, box: Box) -> UmbilicKind:
        """Half the sign of the Jacobian of A and B is the index where E > 0; of B and C where G > 0."""
        local = self.sides.local(box)
        for first, second, k in ((0, 1, 0), (1, 2, 1)):
            f, g = self.own[first], self.own[second]
            if f is None or g is None or self.forms.lengths[k].patch_form(*self.patch).part(local).sign != 1:
                continue
            sign = jacobian_sign(f.whole, g.whole, local)
            if sign:
                return UmbilicKind.POSITIVE if sign > 0 else UmbilicKind.NEGATIVE
        return UmbilicKind.UNKNOWN

    def _by_elimination(
        self, given: list[PatchForm], boxes: Sequence[Box], known: Sequence[Umbilic]
    ) -> tuple[list[Umbilic], list[Box]]:
        """New umbilics in undecided boxes, and the boxes for which elimination is out of reach."""
        certain = [one.place.inner.zero for one in known if one.place.inner is not None]
        found = remaining_zeros(given, boxes, self.sides, certain)
        area = over(self.area.form, self.sides)
        umbilics = []
        for zero in found.zeros:
            if not zero.is_zero_of(area):
                place = place_at(zero, self.patch)
                umbilics.append(Umbilic(place, self._kind_at(zero, place)))
        return umbilics, found.undecided

    def _kind_at(self, zero: CommonZero, place: Place) -> UmbilicKind:
        """Multiple where the Jacobians of both pairs vanish."""
        a, b, c = (over(f.whole, self.sides) if f is not None else S * 0 for f in self.own)
        jacobians = [f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0) for f, g in ((a, b), (b, c))]
        if all(zero.is_zero_of(p) for p in jacobians):
            return UmbilicKind.MULTIPLE
        return self._kind(place.box(KIND_DIGITS))


def jacobian_sign(f: PatchForm, g: PatchForm, box: Box) -> int:
    """The sign of the Jacobian determinant on a box where its range excludes 0, otherwise 0."""
    (a, b), (c, d) = ([h.derivative(i).part(box).range for i in (0, 1)] for h in (f, g))
    first = [x * y for x in a for y in d]
    second = [x * y for x in b for y in c]
    if min(first) > max(second):
        return 1
    return -1 if max(first) < min(second) else 0


def same_place(one: Place, other: Place) -> bool:
    """Whether two points on borders have the same parameters."""
    return bool(one.inner is None and other.inner is None and one.u == other.u and one.v == other.v)
