"""How patches meet along knot lines and seams: torn apart, in a crease, with a common tangent plane, with common
curvatures.

Along a common edge both sides have the same derivatives with respect to its parameter. The two sides have a common
tangent plane where their normals n⁻ and n⁺ have the same direction; then the second fundamental forms agree if one
argument is the direction of the edge, so that they agree completely where the mean curvatures do. With the lifted forms
``H = w h/(2 ‖n‖³)``, and ``n⁺ = λ n⁻`` for some λ > 0, this is ``w⁺ h⁺ (n⁻)³ = w⁻ h⁻ (n⁺)³`` in any coordinate of n
that is not zero: identities of polynomials along the edge.

Source: Pegna and Wolter, Geometrical criteria to guarantee curvature continuity of blend surfaces, 1992.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import count, pairwise, starmap

from exactspline.bivariate.borders import Patch
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.geometry.surfaces.singular import line_points
from exactspline.language.vector import Vector, cross, dot
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine
from exactspline.reals.real import Real
from exactspline.roots.root import Root
from exactspline.roots.values import sign_at
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline

#: The kind of a special point of a crease, or of an edge with one tangent plane, by the sign of the scalar product of
#: the normals, which are parallel there.
SPECIAL = {1: "one tangent plane", -1: "fold", 0: "no tangent plane"}


class SurfaceJointKind(StrEnum):
    """How two patches meet along their common edge, from the least smooth to the smoothest."""

    #: The sides are different curves.
    TORN = "torn"
    #: The tangent planes differ, except at single points.
    CREASE = "crease"
    #: The tangent planes agree, but the surface turns back, on the whole edge or on a part of the edge.
    FOLD = "fold"
    #: At least one side has no tangent plane along the edge.
    SINGULAR = "no tangent plane"
    #: The tangent planes agree, but the curvatures differ, except at single points.
    CURVATURE_JUMP = "jump of the curvature"
    CONTINUOUS = "continuous curvature"


#: The order of geometric continuity of each kind: −1 for a torn joint, 2 for an order of 2 or higher.
ORDERS: dict[SurfaceJointKind, int | None] = dict(zip(SurfaceJointKind, (-1, 0, 0, None, 1, 2), strict=True))


@dataclass(frozen=True, repr=False)
class SurfaceJoint(OneLine):
    """A part of a knot line inside the domain, or of the seam of a closed surface (`value` is the start of the domain
    then): ``across`` has this `value`, the other parameter runs over the `interval`. `angle` is the angle between the
    normals along a crease if it is constant.
    """

    across: Along
    value: mpq
    interval: Interval
    kind: SurfaceJointKind
    at_seam: bool = False
    angle: Angle | None = None

    @property
    def order(self) -> int | None:
        """The order of geometric continuity: −1 where the surface is torn, 2 for 2 or higher; None where a side has no
        tangent plane.
        """
        return ORDERS[self.kind]


def joints(
    forms: SurfaceForms, closed: Sequence[Along], across: Sequence[Along] = tuple(Along)
) -> tuple[SurfaceJoint, ...]:
    """The knot lines inside the domain, and the seams in the parameters in which a surface is closed; neighbouring
    edges with equal properties are joined. With `across`, only the joints across this parameter.

    >>> from exactspline import NurbsSurface
    >>> net = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)], [(1, 0, 1), (1, 1, 1)]]
    >>> bent = NurbsSurface((1, 1), [0, 0, 1, 2, 2], [0, 0, 1, 1], net)
    >>> [(one.kind.value, one.order, str(one.value), one.angle.degrees(5)) for one in joints(SurfaceForms(bent), [])]
    [('crease', 0, '1', mpf('90.0'))]
    """
    merged: list[SurfaceJoint] = []
    for one in _edges(forms, closed, across):
        last = merged[-1] if merged else None
        if last and replace(last, interval=one.interval) == one:  # the next edge on the same line
            merged[-1] = replace(one, interval=Interval(last.interval.low, one.interval.high))
        else:
            merged.append(one)
    return tuple(merged)


def _edges(forms: SurfaceForms, closed: Sequence[Along], parameters: Sequence[Along]) -> Iterator[SurfaceJoint]:
    """The joints of all pairs of neighbouring patches."""
    surface = forms.surface
    for across in parameters:
        k = across.direction
        pairs = list(pairwise(range(surface.patches[k])))
        if across in closed:
            pairs.insert(0, (surface.patches[k] - 1, 0))
        for i, j in pairs:
            for other, interval in enumerate(starmap(Interval, pairwise(surface.meshes[1 - k].breaks))):
                before, behind = ((i, other), (j, other)) if k == 0 else ((other, i), (other, j))
                kind, angle = _Meeting(forms, before, behind, k).kind_and_angle()
                yield SurfaceJoint(across, surface.meshes[k].breaks[j], interval, kind, j == 0, angle)


def special_places(forms: SurfaceForms) -> Iterator[tuple[Real, str]]:
    """The points of the first knot line across u, by v, at which the two tangent planes agree, and the points without a
    tangent plane.
    """
    for j, interval in enumerate(starmap(Interval, pairwise(forms.surface.meshes[1].breaks))):
        found = _Meeting(forms, (0, j), (1, j), 0).special_places()
        yield from {interval.low + t * interval.width: kind for t, kind in found.items()}.items()


class _Meeting:
    """Two patches at their common edge: polynomials along it, over one constant denominator for both sides."""

    def __init__(self, forms: SurfaceForms, before: Patch, behind: Patch, direction: int) -> None:
        self.forms = forms
        self.sides = (before, direction, 1), (behind, direction, 0)

    def _both(self, f: TensorSpline) -> tuple[BSpline, BSpline]:
        first, last = (BSpline.bezier(line_points(f, *side)) for side in self.sides)
        return first, last

    @property
    def normals(self) -> tuple[Vector[BSpline], Vector[BSpline]]:
        """The normals of both sides, up to factors without zeros."""
        before, behind = zip(*[self._both(f) for f in self.forms.normal], strict=True)
        return Vector(*before), Vector(*behind)

    def special_places(self) -> dict[Root, str]:
        """The points of a crease at which the normals are parallel, and points at which one of them is zero; empty if
        all points of the crease are of this kind.
        """
        before, behind = self.normals
        product, parallel = dot(before, behind), cross(before, behind)
        form = product if parallel.is_zero else dot(parallel, parallel)
        return {} if form.is_zero else {t: SPECIAL[sign_at(product, t)] for t in zeros(form)}

    def kind_and_angle(self) -> tuple[SurfaceJointKind, Angle | None]:
        """The kind of joint; for a crease also the angle, where it is constant."""
        if not _fit(self.forms.surface, *self.sides):
            return SurfaceJointKind.TORN, None
        before, behind = self.normals
        if before.is_zero or behind.is_zero:
            return SurfaceJointKind.SINGULAR, None
        if not cross(before, behind).is_zero:
            return SurfaceJointKind.CREASE, _constant_angle(before, behind)
        if not _keeps_positive(dot(before, behind)):
            return SurfaceJointKind.FOLD, None
        (h, h_behind), (w, w_behind) = self._both(self.forms.minimality), self._both(self.forms.surface.w)
        n, n_behind = next(pair for pair in zip(before, behind, strict=True) if not pair[0].is_zero)
        same = w_behind * h_behind * n**3 == w * h * n_behind**3
        return (SurfaceJointKind.CONTINUOUS if same else SurfaceJointKind.CURVATURE_JUMP), None


def _fit(surface: NurbsSurface, before: tuple[Patch, int, int], behind: tuple[Patch, int, int]) -> bool:
    """Whether two edges of patches are the same function of their parameter."""
    (*p, w), (*q, v) = (
        [BSpline.bezier(line_points(f, *side)) for f in (*surface.p, surface.w)] for side in (before, behind)
    )
    return all(x * v == y * w for x, y in zip(p, q, strict=True))


def _keeps_positive(f: BSpline) -> bool:
    """Whether a polynomial that is not zero is nowhere negative on the edge."""
    return f(_apart_from_zeros(f)) > 0 and not any(root.sign_change for root in zeros(f))


def _apart_from_zeros(f: BSpline) -> mpq:
    """A rational parameter inside the edge at which a polynomial is nonzero."""
    return next(t for n in count(2) if f(t := mpq(1, n)))


def _constant_angle(before: Vector[BSpline], behind: Vector[BSpline]) -> Angle | None:
    """The angle between normals that are not parallel, if it is constant along the edge."""
    product, first, second = dot(before, behind), dot(before, before), dot(behind, behind)
    at = _apart_from_zeros(first * second)
    lengths = first * second
    if product * product * lengths(at) != lengths * product(at) ** 2 or any(r.sign_change for r in zeros(product)):
        return None
    return Angle([f(at) for f in before], [f(at) for f in behind])
