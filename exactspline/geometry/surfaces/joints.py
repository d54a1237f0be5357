"""How patches meet along knot lines and seams: torn, in a crease, with one tangent plane, with one curvature.

Along a common edge both sides have the same derivatives with respect to its parameter. They have one tangent plane
where their normals n⁻ and n⁺ have the same direction; then the second fundamental forms agree when one argument is the
direction of the edge, so that they agree altogether where the mean curvatures do. With the lifted forms ``H = w h/(2
‖n‖³)``, and ``n⁺ = λ n⁻`` for some λ > 0, this is ``w⁺ h⁺ (n⁻)³ = w⁻ h⁻ (n⁺)³`` in any coordinate of n that is not
zero: identities of polynomials along the edge.

Source: Pegna and Wolter, Geometrical criteria to guarantee curvature continuity of blend surfaces, 1992.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import reduce
from itertools import count, pairwise, starmap
from operator import add

from exactspline.bivariate.borders import Patch
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.surfaces.degenerate import line_points
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.one_line import OneLine
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline


class SurfaceJointKind(StrEnum):
    """How two patches meet along their common edge, from the worst to the smoothest."""

    #: The sides are different curves.
    TORN = "torn"
    #: Two tangent planes, except at single points.
    CREASE = "crease"
    #: One tangent plane, but the surface turns back, on the whole edge or on a part of it.
    FOLD = "fold"
    #: At least one side has no tangent plane along the edge.
    SINGULAR = "no tangent plane"
    #: One tangent plane, but two curvatures, except at single points.
    CURVATURE_JUMP = "jump of the curvature"
    CONTINUOUS = "continuous curvature"


#: The order of geometric continuity of each kind: −1 for none, 2 for 2 or higher.
ORDERS: dict[SurfaceJointKind, int | None] = {
    SurfaceJointKind.TORN: -1,
    SurfaceJointKind.CREASE: 0,
    SurfaceJointKind.FOLD: 0,
    SurfaceJointKind.SINGULAR: None,
    SurfaceJointKind.CURVATURE_JUMP: 1,
    SurfaceJointKind.CONTINUOUS: 2,
}


@dataclass(frozen=True, repr=False)
class SurfaceJoint(OneLine):
    """A part of a knot line inside the domain, or of the seam of a closed surface (`value` is the start of the domain
    then): ``across`` has this `value`, the other parameter runs over the `interval`. `angle` is that between the
    normals along a crease where it is the same everywhere.
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


def joints(forms: SurfaceForms, closed: Sequence[Along]) -> tuple[SurfaceJoint, ...]:
    """The knot lines inside the domain, and the seams in the parameters in which a surface is closed; neighbouring
    edges with equal properties are joined.

    >>> from exactspline import NurbsSurface
    >>> net = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)], [(1, 0, 1), (1, 1, 1)]]
    >>> bent = NurbsSurface((1, 1), [0, 0, 1, 2, 2], [0, 0, 1, 1], net)
    >>> [(one.kind.value, one.order, str(one.value), one.angle.degrees(5)) for one in joints(SurfaceForms(bent), [])]
    [('crease', 0, '1', mpf('90.0'))]
    """
    merged: list[SurfaceJoint] = []
    for one in _edges(forms, closed):
        last = merged[-1] if merged else None
        if last and replace(last, interval=one.interval) == one:  # the next on the same line
            merged[-1] = replace(one, interval=Interval(last.interval.low, one.interval.high))
        else:
            merged.append(one)
    return tuple(merged)


def _edges(forms: SurfaceForms, closed: Sequence[Along]) -> Iterator[SurfaceJoint]:
    """The joints of all pairs of neighbouring patches."""
    surface = forms.surface
    for across in Along:
        k = across.direction
        pairs = list(pairwise(range(surface.patches[k])))
        if across in closed:
            pairs.insert(0, (surface.patches[k] - 1, 0))
        for i, j in pairs:
            for other, interval in enumerate(starmap(Interval, pairwise(surface.meshes[1 - k].breaks))):
                before, behind = ((i, other), (j, other)) if k == 0 else ((other, i), (other, j))
                kind, angle = _Meeting(forms, before, behind, k).kind_and_angle()
                yield SurfaceJoint(across, surface.meshes[k].breaks[j], interval, kind, j == 0, angle)


class _Meeting:
    """Two patches at their common edge: polynomials along it, over one constant denominator for both sides."""

    def __init__(self, forms: SurfaceForms, before: Patch, behind: Patch, direction: int) -> None:
        self.forms = forms
        self.sides = (before, direction, 1), (behind, direction, 0)

    def _both(self, f: TensorSpline) -> tuple[BSpline, BSpline]:
        first, last = (BSpline.bezier(line_points(f, *side)) for side in self.sides)
        return first, last

    def kind_and_angle(self) -> tuple[SurfaceJointKind, Angle | None]:
        """The kind of joint; for a crease also the angle, where it is constant."""
        if not _fit(self.forms.surface, *self.sides):
            return SurfaceJointKind.TORN, None
        normals = [self._both(f) for f in self.forms.normal]
        before, behind = ([pair[k] for pair in normals] for k in (0, 1))
        if _is_zero(before) or _is_zero(behind):
            return SurfaceJointKind.SINGULAR, None
        if not _is_zero([before[i] * behind[j] - before[j] * behind[i] for i, j in ((0, 1), (1, 2), (2, 0))]):
            return SurfaceJointKind.CREASE, _constant_angle(before, behind)
        if not _keeps_positive(_dot(before, behind)):
            return SurfaceJointKind.FOLD, None
        (h, h_behind), (w, w_behind) = self._both(self.forms.minimality), self._both(self.forms.surface.w)
        n, n_behind = next(pair for pair in normals if not pair[0].is_zero)
        same = w_behind * h_behind * n**3 == w * h * n_behind**3
        return (SurfaceJointKind.CONTINUOUS if same else SurfaceJointKind.CURVATURE_JUMP), None


def _fit(surface: NurbsSurface, before: tuple[Patch, int, int], behind: tuple[Patch, int, int]) -> bool:
    """Whether two edges of patches are one curve, as functions of their parameter."""
    (*p, w), (*q, v) = (
        [BSpline.bezier(line_points(f, *side)) for f in (*surface.p, surface.w)] for side in (before, behind)
    )
    return all(x * v == y * w for x, y in zip(p, q, strict=True))


def _dot(a: Sequence[BSpline], b: Sequence[BSpline]) -> BSpline:
    return reduce(add, [x * y for x, y in zip(a, b, strict=True)])


def _is_zero(v: Sequence[BSpline]) -> bool:
    return all(f.is_zero for f in v)


def _keeps_positive(f: BSpline) -> bool:
    """Whether a polynomial that is not zero is nowhere negative on the edge."""
    return f(_apart_from_zeros(f)) > 0 and not any(root.sign_change for root in zeros(f))


def _apart_from_zeros(f: BSpline) -> mpq:
    """A rational parameter inside the edge at which a polynomial is nonzero."""
    return next(t for n in count(2) if f(t := mpq(1, n)))


def _constant_angle(before: Sequence[BSpline], behind: Sequence[BSpline]) -> Angle | None:
    """The angle between normals that are not parallel, where it is the same all along the edge."""
    product, first, second = _dot(before, behind), _dot(before, before), _dot(behind, behind)
    at = _apart_from_zeros(first * second)
    lengths = first * second
    if product * product * lengths(at) != lengths * product(at) ** 2 or any(r.sign_change for r in zeros(product)):
        return None
    return Angle([f(at) for f in before], [f(at) for f in behind])
