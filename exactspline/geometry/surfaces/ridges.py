"""Ridges: where a principal curvature is stationary along its own lines of curvature.

Ridges are the zeros of the resultant of the lines of curvature ``A t_u² + B t_u t_v + C t_v²`` and a cubic form T,
whose value in a principal direction is the derivative of the principal curvature. The ridges of the two principal
curvatures usually cross transversally, where the resultant has a node; the node is proved by the signs of T in both
principal directions on the border of a box, without elimination. Around umbilics, where both directions are undefined,
and at other singular points of high degree the curve is not resolved: the boxes around these points are part of the
answer.

Source: Cazals, Faugère, Pouget and Rouillier, The implicit structure of ridges of a smooth parametric surface, Computer
Aided Geometric Design 2006.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

from flint import fmpz_mpoly

from exactspline.bivariate.borders import EDGES, Edge, Patch, along, roots_along, vanishes_at
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.joined_curves import Piece, ZeroComponent, chained, place_of
from exactspline.bivariate.quotients import polynomials_on
from exactspline.bivariate.singular_points import Cell, Crossing, kind_on
from exactspline.bivariate.zero_curve import Begun, Shape, ZeroCurve
from exactspline.bivariate.zero_lines import LinesOfPatch, ZeroLine, square_free, without_lines, zero_lines
from exactspline.bivariate.zeros import SurfacePart
from exactspline.errors import ReachError
from exactspline.geometry.surfaces.forms import Reduced, SurfaceForms, on_patch, sides_of
from exactspline.geometry.surfaces.singular import SingularPoints
from exactspline.geometry.surfaces.umbilics import UmbilicsOfPatch
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box
from exactspline.numbers.search import Search
from exactspline.one_line import OneLine, one_line
from exactspline.polynomials.certified_boxes import Isolation, isolate
from exactspline.polynomials.cost import PATCH, Budget, affords, drawing_on, height_bits
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm, Sized, clusters, halved
from exactspline.polynomials.two_parameters import as_form, as_polynomial
from exactspline.reals.real import Real, between, real, square_root
from exactspline.roots.of_polynomials import Parameter
from exactspline.splines.surface import Along

#: The product of the degrees of a form up to which all singular points of its zeros are searched for.
FEW = 64
#: The largest number of bisections of a box, after which the curve in the box is not resolved; and the bound on the
#: estimated nanoseconds of all bisections on a surface, about a minute, to which each further patch adds a little.
DEPTH, WORK = 20, 60_000_000_000
#: The cost of bisecting a form: nanoseconds per coefficient, and per coefficient and bit.
HALVING, HALVING_BITS = 4000, 5

#: Twice a direction in the plane of parameters, and the signs of the derivatives of both curvatures along their lines.
Directions = list[tuple[Real, Real]]
Signs = tuple[int, int]


class NoDirections(StrEnum):
    """The reason why a patch has no principal directions anywhere, and therefore no ridges."""

    UMBILIC = "every point is an umbilic"
    SINGULAR = "no point has a tangent plane"


@dataclass(frozen=True, repr=False)
class OpenRidges(OneLine):
    """A rectangle of parameters in which the ridges are not resolved, with the number of certified umbilics and points
    without a tangent plane in it: usually several ridges pass through these.
    """

    sides: Box
    umbilics: int = 0
    singular: int = 0


@dataclass(frozen=True)
class _RidgesOfPatch:
    """The ridges of one closed patch: `stationary` is the number of principal curvatures (none where there are no
    directions) that are constant along all their lines; the `edges`, `lines` and `pieces` of curves are ridges of the
    others.
    """

    patch: Patch
    sides: Box
    stationary: int = 0
    edges: tuple[Edge, ...] = ()
    lines: tuple[tuple[Along, Parameter], ...] = ()
    pieces: tuple[Piece, ...] = ()
    open_boxes: tuple[OpenRidges, ...] = ()


@dataclass(frozen=True, repr=False)
class Ridges:
    """All points of a surface at which a principal curvature is stationary along its own line of curvature: on
    connected `curves` (a single point among them), on isoparametric `lines`, and everywhere on the patches of
    `stationary`, each with the number of principal curvatures that are constant along all their lines.

    `undecided` are rectangles in which there may be more ridges. A ridge that ends in such a rectangle may continue
    there. `excluded` are the patches without principal directions, and therefore without ridges, with the reasons.
    """

    curves: tuple[ZeroComponent, ...] = ()
    lines: tuple[ZeroLine, ...] = ()
    stationary: tuple[tuple[SurfacePart, int], ...] = ()
    undecided: tuple[OpenRidges, ...] = ()
    excluded: tuple[tuple[SurfacePart, NoDirections], ...] = ()

    @property
    def complete(self) -> bool:
        """Whether no rectangle is undecided."""
        return not self.undecided

    def __bool__(self) -> bool:
        return any((self.curves, self.lines, self.stationary, self.undecided))

    @one_line
    def __repr__(self) -> str:
        parts = [curve.shape.value for curve in self.curves] + ["a line"] * len(self.lines)
        parts += [f"everywhere on {part}" for part, _ in self.stationary]
        parts += [f"undecided in {SurfacePart((0, 0), box.sides)}" for box in self.undecided]
        return "; ".join([", ".join(parts) or "nowhere", *(f"{why} on {part}" for part, why in self.excluded)])


class RidgeSearch:
    """The ridges of one patch, on which the surface has tangent planes, from its forms."""

    def __init__(self, forms: SurfaceForms, patch: Patch, singular: SingularPoints, umbilics: UmbilicsOfPatch) -> None:
        self.forms, self.patch, self.singular, self.umbilics = forms, patch, singular, umbilics
        self.sides = sides_of(forms.surface, patch)

    def found(self) -> _RidgesOfPatch:
        """The ridges; raises `ReachError` if none can be computed within the limit of work."""
        own, stationary = on_patch(self.forms.ridges, self.patch), 0
        if own is None:
            quadratic, cubic = (polynomials_on(self.patch, *f) for f in (self.forms.lines, self.forms.ridge_cubic))
            other = other_family(quadratic, cubic)
            if other is None:
                return _RidgesOfPatch(self.patch, self.sides, 2)
            whole, stationary = as_form(other), 1
            own = Reduced(whole, *whole.without_border())
        form = self.singular.of_factor.without(own.form)
        if self.umbilics.of_factor.along_curve:
            form = self.umbilics.of_factor.without(form)
        edges = [edge for edge, times in zip(EDGES, own.borders, strict=True) if times]
        kept = tuple(edge for edge in edges if edge not in (*self.singular.edges, *self.umbilics.edges))
        rest, lines = without_lines(_simple(form), self.sides)
        curve = self._curve(rest, None if stationary else own.whole)
        boxes = tuple(self._described(self.sides.part(box)) for box, _ in clusters(curve.undecided))
        pieces = [Piece(self.patch, self.sides, curve, part) for part in curve.parts]
        ridges = tuple(piece for piece in pieces if piece.part.shape is not Shape.POINT or self._is_ridge(piece))
        return _RidgesOfPatch(self.patch, self.sides, stationary, kept, lines, ridges, boxes)

    def _is_ridge(self, piece: Piece) -> bool:
        """Whether a single zero of the form is a point with a tangent plane and two principal curvatures."""
        place = place_of(piece)
        given = [on_patch(f, self.patch) for f in (self.forms.area, self.forms.umbilicity)]
        if place.is_inside:
            return not any(own and place.zero.is_zero_of(own.form) for own in given)
        return not any(own and vanishes_at(own.whole, place.spot, self.sides) for own in given)

    def _described(self, box: Box) -> OpenRidges:
        umbilics = sum(one.place.box().meets(box) for one in self.umbilics.umbilics)
        return OpenRidges(box, umbilics, sum(place.box().meets(box) for place in self.singular.places))

    def _curve(self, form: PatchForm, whole: PatchForm | None) -> ZeroCurve:
        """The zeros of a form; `whole` is the product of the derivatives of both curvatures, up to a positive
        function, None where one of them is constant.
        """
        if form.degree[0] * form.degree[1] <= FEW:
            return ZeroCurve(form)
        boxes, remaining = bisected(form)
        cells, unresolved = list[Cell](), list[Box]()
        for box, _ in clusters(remaining):
            node = None if whole is None else self._node(form, whole, box)
            if node is None:
                unresolved.append(box)
            else:
                cells.append(node)
        return ZeroCurve(form, begun=Begun(boxes, cells, unresolved))

    def _node(self, form: PatchForm, whole: PatchForm, box: Box) -> Cell | None:
        """A cell in which the form has one node and no zeros except on its four branches, if this is proved.

        Four simple zeros on the border, between which the signs of the derivatives of both principal curvatures take
        all four values, prove a point at which both vanish. The point is a node if the Hessian is indefinite; with four
        ends there is no second node, and the node is the only critical point.
        """
        if not box.is_inside(UNIT) or kind_on(form, box) is not Crossing.NODE:
            return None
        rest = as_form(as_polynomial(whole) / as_polynomial(form))
        signs = self._signs(box)
        if signs is None or rest.part(box).sign not in (1, -1) or not winds_once(form.part(box), box, signs):
            return None
        critical = isolate([form.derivative(0), form.derivative(1)], before=Isolation([], [box]))
        if critical.undecided or len(critical.zeros) != 1:
            return None
        return Cell(box, Crossing.NODE, CommonZero(UNIT, None, critical.zeros[0]))

    def _signs(self, box: Box) -> Callable[[mpq, mpq], Signs] | None:
        """The signs of the derivatives of both principal curvatures at rational points of a box in which the two
        directions are different and continuous; None where this is not proved.
        """
        at_umbilics = on_patch(self.forms.umbilicity, self.patch)
        if at_umbilics is None or at_umbilics.whole.part(box).sign != 1:
            return None
        a, b, c = (f.patch_form(*self.patch).part(box).sign or 0 for f in self.forms.lines)
        if not (a or b or c):
            return None

        def signs(x: mpq, y: mpq) -> Signs:
            place = self.sides.at(x, y)
            uu, uv, vv = (f(*place) for f in self.forms.lines)
            cubic = [f(*place) for f in self.forms.ridge_cubic]
            first, second = (_along(cubic, t).sign for t in principal_directions(uu, uv, vv, a, b, c))
            return first, second

        return signs


def other_family(lines: Sequence[fmpz_mpoly], cubic: Sequence[fmpz_mpoly]) -> fmpz_mpoly | None:
    """If the quadratic form ``a p² + b p q + c q²`` and a cubic form have a common linear factor, the value of the
    cubic form in the direction in which the other linear factor vanishes; None if the quadratic form divides the cubic
    form.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> other_family([S * 0, S * 0 + 1, S * 0], [S * 0, S, T, S - T])  # p q and q (s p² + t p q + (s − t) q²)
    s - t
    """
    a, b, c = lines
    if not a:
        # the direction (1, 0), and the one in which b p + c q vanishes
        shared = greatest_common_divisor([b, c])
        other = -c / shared, b / shared
        return cubic[0] or _cubic(cubic, *other) or None
    # a² times the cubic form is r p q² + t q³ modulo the quadratic one
    r = cubic[0] * (b * b - a * c) - cubic[1] * a * b + cubic[2] * a * a
    t = cubic[0] * b * c - cubic[1] * a * c + cubic[3] * a * a
    if not r and not t:
        return None
    first, second = a * t - b * r, a * r
    shared = greatest_common_divisor([first, second])
    return _cubic(cubic, first / shared, second / shared)


def _cubic(cubic: Sequence[fmpz_mpoly], p: fmpz_mpoly, q: fmpz_mpoly) -> fmpz_mpoly:
    return cubic[0] * p**3 + cubic[1] * p**2 * q + cubic[2] * p * q**2 + cubic[3] * q**3


def _along(cubic: Sequence[mpq], direction: tuple[Real, Real]) -> Real:
    p, q = direction
    return cubic[0] * p * p * p + cubic[1] * p * p * q + cubic[2] * p * q * q + cubic[3] * q * q * q


def _simple(form: PatchForm) -> PatchForm:
    """A form without multiple factors. If the factorization takes too much work, it is the form itself, whose multiple
    zeros remain undecided.
    """
    try:
        return square_free(form)
    except ReachError:
        return form


def principal_directions(uu: mpq, uv: mpq, vv: mpq, a: int, b: int, c: int) -> Directions:
    """The two principal directions at a point of a box on which the coefficients have these signs (0: unknown)."""
    root = square_root(uv * uv - 4 * uu * vv)
    if a:
        return [(root - uv, real(2 * uu)), (-root - uv, real(2 * uu))]
    if c:
        return [(real(2 * vv), root - uv), (real(2 * vv), -root - uv)]
    sum_ = -uv - b * root
    return [(sum_, real(2 * uu)), (real(2 * vv), sum_)]


def bisected(form: PatchForm) -> tuple[list[Sized], list[Box]]:
    """Boxes in which a form is monotonic in one direction, and boxes in which this is not proved; all zeros of the form
    are in these boxes.
    """
    search, boxes = Search([Sized(UNIT, [form])]), list[Sized]()
    cost = len(form.entries) * (HALVING + HALVING_BITS * (height_bits(form.entries) + DEPTH // 4 * sum(form.degree)))
    for part in search:
        own = part.forms[0]
        if own.sign is not None:
            continue
        if own.monotonic is not None:
            boxes.append(part)
        else:
            search.split(halved(part) if search.depth < DEPTH and affords(cost) else None)
    return boxes, [part.box for part in search.open]


def winds_once(own: PatchForm, box: Box, signs: Callable[[mpq, mpq], Signs]) -> bool:
    """Whether a form given on a box has four simple zeros on the border, between which a pair of signs takes all four
    values, so that exactly one sign changes at each zero.
    """
    found, count = list[Signs](), 0
    for edge in (Edge(1, 0), Edge(0, 1), Edge(1, 1), Edge(0, 0)):
        p = along(own, edge, UNIT)
        if greatest_common_divisor([p, p.derivative()]).degree() > 0:
            return False
        roots = roots_along(p, edge, UNIT)
        count += len(roots)
        middles = [between(x, y) for x, y in pairwise(roots)]
        ascending = edge in (Edge(1, 0), Edge(0, 1))
        for t in [mpq(0), *middles] if ascending else [mpq(1), *reversed(middles)]:
            end = mpq(edge.end)
            found.append(signs(*(box.at(end, t) if edge.direction == 0 else box.at(t, end))))
    different = [one for k, one in enumerate(found) if one != found[k - 1]]
    changes = sum((a == c) != (b == d) for (a, b), (c, d) in pairwise([*different, different[0]] if different else []))
    return count == len(different) == len({*different}) == changes == 4 and all(a * b for a, b in found)


def ridges_of_surface(
    forms: SurfaceForms, patches: Sequence[tuple[SingularPoints, UmbilicsOfPatch]], closed: Sequence[Along]
) -> Ridges:
    """The ridges of all patches, joined across their borders. The singular points and umbilics are given in the order
    of the patches.
    """
    surface, found, excluded = forms.surface, list[_RidgesOfPatch](), list[tuple[SurfacePart, NoDirections]]()
    with drawing_on(Budget(WORK + PATCH * (len(patches) - 1))):
        for patch, (singular, umbilics) in zip(forms.patches, patches, strict=True):
            if singular.degenerate or umbilics.everywhere:
                why = NoDirections.SINGULAR if singular.degenerate else NoDirections.UMBILIC
                excluded.append((SurfacePart(patch, sides_of(surface, patch)), why))
                continue
            try:
                found.append(RidgeSearch(forms, patch, singular, umbilics).found())
            except ReachError:
                sides = sides_of(surface, patch)
                found.append(_RidgesOfPatch(patch, sides, open_boxes=(OpenRidges(sides),)))
    undecided = tuple(box for one in found for box in one.open_boxes)
    pieces = [piece for one in found for piece in one.pieces]
    curves = chained(pieces, surface.domain, closed, [box.sides for box in undecided])
    own = [LinesOfPatch(one.patch, one.sides, one.edges, one.lines, one.stationary == 2) for one in found]
    lines = zero_lines(surface.patches, surface.domain, own, closed)
    stationary = tuple((SurfacePart(one.patch, one.sides), one.stationary) for one in found if one.stationary)
    return Ridges(curves, lines, stationary, undecided, tuple(excluded))
