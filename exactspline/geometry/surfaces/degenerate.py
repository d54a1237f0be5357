"""Degenerate control nets: edges without tangent planes (poles), patches that are curves or points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from exactspline.bivariate.borders import EDGES, Edge, Patch, line_of
from exactspline.geometry.surfaces.forms import SurfaceForms, sides_of
from exactspline.geometry.surfaces.singular import Line
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Interval
from exactspline.one_line import OneLine
from exactspline.splines.bspline import BSpline
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline


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
