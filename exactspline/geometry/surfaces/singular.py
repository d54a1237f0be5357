"""Points at which a surface has no tangent plane: isolated and certified inside patches, listed along their borders.
Degenerate control nets: edges without tangent planes (poles), patches that are curves or points.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import partial, reduce
from typing import NamedTuple

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.borders import EDGES, Edge, Patch, along, line_of, roots_along
from exactspline.bivariate.common_zeros import CommonZero, zeros_of
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.bivariate.zero_lines import common_factor, divided, rational_lines, square_free, without_powers
from exactspline.errors import ReachError
from exactspline.geometry.surfaces.forms import SurfaceForms, on_patch, sides_of
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.one_line import OneLine
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.splines.bspline import BSpline
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline

#: The bits of a box around an undecided point.
FAR = 64


class Line(NamedTuple):
    """An isoparametric line on a patch: the parameter of this direction (0: u) has this value."""

    direction: int
    value: mpq


@dataclass(frozen=True, repr=False)
class ZerosOfFactor(OneLine):
    """The zeros of a common factor on a patch, if it has any: `whole` are all zeros, `lines` the isoparametric lines
    among them at rational parameters, and `curve` the other zeros, if they are more than single points; `factors` are
    the factors that vanish on lines and curve.
    """

    whole: ZeroCurve | None = None
    lines: tuple[Line, ...] = ()
    curve: ZeroCurve | None = None
    factors: tuple[PatchForm, ...] = ()

    @classmethod
    def of(cls, factor: PatchForm | None, sides: Box) -> ZerosOfFactor:
        """The zeros of a factor."""
        whole, rest = _curve_of(factor)
        if whole is None:
            return cls()
        found = [(k, x) for k in (0, 1) for x in rational_lines(whole.form, k) if 0 < x < 1]
        factors = [whole.form]
        for k, x in found:
            ends = int(-x.numerator), int(x.denominator - x.numerator)
            factors.append(PatchForm.of_net([ends] if k else [[end] for end in ends]))
            factors[0] = divided(factors[0], factors[-1])
        rest = _curve_of(factors[0])[1] if found else rest
        lines = tuple(Line(k, sides[k].at(x)) for k, x in found)
        return cls(whole, lines, rest, tuple(f for f in factors if any(f.degree)))

    @property
    def along_curve(self) -> bool:
        """Whether there are lines or a curve."""
        return bool(self.lines or self.curve)

    def without(self, form: PatchForm, *, even: bool = False) -> PatchForm:
        """A form divided by the factors as often as possible; with `even`, by their squares."""
        return reduce(partial(without_powers, even=even), self.factors, form)

    def with_single_points(
        self, found: Sequence[CommonZero], known: Sequence[CommonZero] = ()
    ) -> tuple[list[CommonZero], list[Box]]:
        """The points found inside that are not zeros of the factor, and the single zeros of the factor that are not
        `known` already; and the undecided boxes.
        """
        if (curve := self.whole) is None:
            return list(found), []
        kept, undecided = list[CommonZero](), list(curve.undecided)
        for zero in (*found, *curve.single_points):
            try:
                if not (zero.is_zero_of(curve.form) if zero in found else any(zero.is_at(other) for other in known)):
                    kept.append(zero)
            except ReachError:
                undecided.append(zero.refine(FAR))
        return kept, undecided


#: The zeros of a constant.
NONE = ZerosOfFactor()


def _curve_of(factor: PatchForm | None) -> tuple[ZeroCurve | None, ZeroCurve | None]:
    """The zeros of a factor, if it has any; and the same zeros again if they are more than single points, otherwise
    None.
    """
    sign = Sign.POSITIVE if factor is None else sign_on_patch(factor).sign
    if factor is None or sign in (Sign.POSITIVE, Sign.NEGATIVE):
        return None, None
    curve = ZeroCurve(square_free(factor))
    return curve, curve if curve.has_branches or sign is Sign.BOTH else None


@dataclass(frozen=True, repr=False)
class SingularPoints(OneLine):
    """The zeros of the normal of a patch. The normal vanishes everywhere if `degenerate`, and along whole `edges`.
    `places` are single zeros inside, and zeros on the border, at which curves of this or another patch may end.
    `of_factor` are the zeros of a common factor of the coordinates, which form lines and curves; `undecided` are boxes
    of parameters.
    """

    degenerate: bool = False
    edges: tuple[Edge, ...] = ()
    places: tuple[Place, ...] = ()
    undecided: tuple[Box, ...] = ()
    of_factor: ZerosOfFactor = NONE

    @property
    def inside(self) -> list[CommonZero]:
        """The places inside the patch."""
        return [place.zero for place in self.places if place.is_inside]

    @property
    def regular(self) -> bool:
        """Whether there are no singular points except along edges."""
        return not (self.degenerate or self.places or self.undecided or self.of_factor.along_curve)


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
        return SingularPoints(edges=edges, places=tuple(places))
    normal = [None if own is None else own.form for own in (on_patch(f, patch) for f in forms.normal)]
    factor = common_factor([f for f in normal if f is not None])
    if factor is not None:
        normal = [None if f is None else divided(f, factor) for f in normal]
    of_factor = ZerosOfFactor.of(factor, sides)
    # the scalar products of the normal with both tangents are zero
    tangents = [[f.patch_form(*patch) for f in pair] for pair in zip(*forms.tangents, strict=True)]
    given = [(f, e) for f, e in zip(normal, tangents, strict=True) if f is not None]
    found = zeros_of([f for f, _ in given], sides, cofactors=[e for _, e in given])
    inside, rest = of_factor.with_single_points([zero for zero in found.zeros if zero.is_inside])
    places += [Place((patch,), zero.on(sides)) for zero in inside]
    undecided = tuple(map(sides.part, (*found.undecided, *rest)))
    return SingularPoints(False, edges, tuple(places), undecided, of_factor)


class Gap(StrEnum):
    """The limit of the difference of the principal curvatures towards a pole, in all except finitely many
    directions.
    """

    #: The limit is zero: the pole is an umbilic if the surface is smooth there.
    NONE = "umbilic in the limit"
    FINITE = "no umbilic"
    INFINITE = "the curvatures grow without bound"


@dataclass(frozen=True, repr=False)
class Pole(OneLine):
    """An isoparametric line along which a surface has no tangent plane: ``along`` runs over the `interval`, the other
    parameter is `value`. `point` is the image of the line if this is a single point, None if it is a curve; `gap`
    describes the principal curvatures near the pole.
    """

    along: Along
    value: mpq
    interval: Interval
    point: tuple[mpq, ...] | None
    gap: Gap


def pole_at(forms: SurfaceForms, patch: Patch, line: Line) -> Pole:
    """The pole on an isoparametric line of a patch; the line may be an edge."""
    (k, value), sides = line, sides_of(forms.surface, patch)
    at = patch, k, sides[k].local(value)
    return Pole(line_of(Edge(k, 0)), value, sides[1 - k], point_of(forms.surface, *at), _gap(forms, *at))


def _gap(forms: SurfaceForms, patch: Patch, direction: int, x: mpq) -> Gap:
    """The gap at a line. The squared difference is umbilicity over the third power of ``EG − F²``: the orders of the
    zeros of both are compared, on a part of the patch of which the line is an edge.
    """
    box, at = UNIT.with_side(direction, Interval(x if x < 1 else mpq(0), mpq(1))), EDGES.index(Edge(direction, x == 1))
    own, area = (f.patch_form(*patch).part(box) for f in (forms.umbilicity, forms.area))
    if own.is_zero or area.is_zero:
        return Gap.NONE
    order = own.without_border()[1][at] - 3 * area.without_border()[1][at]
    return Gap.FINITE if order == 0 else Gap.NONE if order > 0 else Gap.INFINITE


def point_of(surface: NurbsSurface, patch: Patch, direction: int, x: mpq) -> tuple[mpq, ...] | None:
    """The point to which a line of a patch at a local parameter is contracted; None where the line is a curve."""
    return _common_point(surface, [line_points(f, patch, direction, x) for f in (*surface.p, surface.w)])


def line_points(f: TensorSpline, patch: Patch, direction: int, x: mpq | int) -> list[mpq]:
    """The Bézier points of a spline along the line of a patch at a local parameter."""
    net = f.bezier_net(*patch)
    return [BSpline.bezier(row)(x) for row in (net if direction else zip(*net, strict=True))]


def is_point(surface: NurbsSurface, patch: Patch) -> bool:
    """Whether a patch is a single point."""
    nets = [[x for row in f.bezier_net(*patch) for x in row] for f in (*surface.p, surface.w)]
    return _common_point(surface, nets) is not None


def _common_point(surface: NurbsSurface, nets: Sequence[list[mpq]]) -> tuple[mpq, ...] | None:
    """The common point of homogeneous points given by coordinates and weights; None if they are different points."""
    *p, w = nets
    if surface.polynomial:
        w = [w[0]] * len(p[0])
    first = tuple(x[0] / w[0] for x in p)
    constant = all(x == at * y for at, net in zip(first, p, strict=True) for x, y in zip(net, w, strict=True))
    return first if constant else None


def closed_along(surface: NurbsSurface, along: Along) -> bool:
    """Whether the first and the last isoparametric line across a parameter are the same curve."""
    (a, b), other = surface.domain[along.direction], Along.V if along is Along.U else Along.U
    ends = [(t, surface.domain[1 - along.direction].low)[:: -1 if along.direction else 1] for t in (a, b)]
    # two points exclude most surfaces that are not closed
    return surface(*ends[0]) == surface(*ends[1]) and surface.isocurve(other, a) == surface.isocurve(other, b)
