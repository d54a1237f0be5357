"""Degenerate control nets: edges without tangent planes (poles), patches that are curves or points."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from exactspline.bivariate.borders import EDGES, Edge, Patch, line_of
from exactspline.geometry.surfaces.forms import SurfaceForms, on_patch, sides_of
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline


class Gap(StrEnum):
    """The limit of the difference of the principal curvatures towards a pole, except in single directions."""

    #: It vanishes: an umbilic, where the surface is smooth there.
    NONE = "umbilic in the limit"
    FINITE = "no umbilic"
    INFINITE = "the curvatures grow without bound"


@dataclass(frozen=True)
class Pole:
    """An isoparametric line along which a surface has no tangent plane: ``along`` runs over the `interval`, the other
    parameter is `value`. `point` is its image where that is a single point, None where it is a curve; `gap` describes
    the principal curvatures near it.
    """

    along: Along
    value: mpq
    interval: Interval
    point: tuple[mpq, ...] | None
    gap: Gap


def pole_at(forms: SurfaceForms, patch: Patch, edge: Edge) -> Pole:
    """The pole on an edge of a patch."""
    surface, sides = forms.surface, sides_of(forms.surface, patch)
    value = edge.value(sides)
    return Pole(
        line_of(edge), value, sides[1 - edge.direction], point_of(surface, patch, edge), _gap(forms, patch, edge)
    )


def _gap(forms: SurfaceForms, patch: Patch, edge: Edge) -> Gap:
    """The square of the difference is umbilicity over the third power of ``EG − F²``: compared by the orders of their
    zeros.
    """
    own, area = on_patch(forms.umbilicity, patch), on_patch(forms.area, patch)
    if own is None or area is None:
        return Gap.NONE
    at = EDGES.index(edge)
    order = own.borders[at] - 3 * area.borders[at]
    return Gap.FINITE if order == 0 else Gap.NONE if order > 0 else Gap.INFINITE


def point_of(surface: NurbsSurface, patch: Patch, edge: Edge) -> tuple[mpq, ...] | None:
    """The point to which an edge of a patch is contracted; None where the edge is a curve."""
    nets = [edge_points(f, patch, edge) for f in (*surface.p, surface.w)]
    *p, w = [[mpq(x) for x in net] for net in nets]
    if surface.polynomial:
        w = [w[0]] * len(p[0])
    first = tuple(x[0] / w[0] for x in p)
    constant = all(x == at * y for at, net in zip(first, p, strict=True) for x, y in zip(net, w, strict=True))
    return first if constant else None


def edge_points(f: TensorSpline, patch: Patch, edge: Edge) -> list[mpq]:
    """The Bézier points of a spline along an edge of a patch."""
    net = f.bezier_net(*patch)
    if edge.direction == 0:
        return net[-1 if edge.end else 0]
    return [row[-1 if edge.end else 0] for row in net]


def is_point(surface: NurbsSurface, patch: Patch) -> bool:
    """Whether a patch is a single point."""
    nets = [[x for row in f.bezier_net(*patch) for x in row] for f in surface.p]
    weights = [x for row in surface.w.bezier_net(*patch) for x in row]
    if surface.polynomial:
        return all(x == net[0] for net in nets for x in net)
    return all(x * weights[0] == net[0] * w for net in nets for x, w in zip(net, weights, strict=True))


def closed_along(surface: NurbsSurface, along: Along) -> bool:
    """Whether the first and the last isoparametric line across a parameter are the same curve."""
    (a, b), other = surface.domain[along.direction], Along.V if along is Along.U else Along.U
    return surface.isocurve(other, a) == surface.isocurve(other, b)
