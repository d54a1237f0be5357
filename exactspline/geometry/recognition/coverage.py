"""Whether the projection of patches to a plane, a sphere, a cylinder, a cone or a torus is injective: no point of the
shape is the nearest one to two points of the patches.

The shape has two coordinates: an angle θ around an axis (on a plane also a place along a direction) and a place η along
a meridian. The proof shows that each of three functions, written as polynomials in the parameters u and v with a margin
for the distance from a torus, has one sign:

1. ``θ_u``, so that every line of u runs around the axis without turning back;
2. the Jacobian ``θ_u η_v − θ_v η_u`` of the nearest points, which is that of ``N·n``: the parameters with the same θ
form a graph over v, and η grows along this graph; 3. ``η_v`` on the first and the last line of v, where the graph may
leave the rectangle and come back; a patch that is closed in u does not need this.

So each pair of real numbers θ and η occurs at one place only. A half-plane that is bounded by the axis and does not
meet the patches shows that no angle exceeds one turn; if the patches are closed, a single line of u (for a torus also
of v) shows this. An edge that is a single point, a pole or the apex of a cone, may be excluded.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.geometry.recognition import candidates
from exactspline.geometry.recognition.pieces import passes_its_start, signs
from exactspline.geometry.recognition.shapes import (
    Circle,
    Cone,
    Cylinder,
    Plane,
    Point,
    PointToAsk,
    Shape,
    Sphere,
    Torus,
    cross_product,
    minus,
    upper_square_root,
)
from exactspline.geometry.surfaces.forms import SurfaceForms
from exactspline.geometry.surfaces.singular import closed_along, point_of
from exactspline.language.wronskians import wronskians
from exactspline.numbers.exact import mpq, scalar, sign
from exactspline.numbers.intervals import UNIT
from exactspline.numbers.once import cached_property
from exactspline.numbers.search import Search
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved
from exactspline.roots.values import sign_at
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline

SIGNS = {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}
#: The number of boxes examined to show that patches do not meet a half-plane.
BOXES = 400
#: The places of the domain at which vectors are taken to choose an axis, and the unit of the numbers of the axis.
PLACES, UNIT_OF_AXIS = (mpq(1, 5), mpq(1, 2), mpq(4, 5)), mpq(1, 64)


def covers_once(surface: NurbsSurface, shape: Shape, within: mpq) -> bool:
    """Whether it is proved that no point of the shape is the nearest one to two points of a surface that is at most
    this far from the shape.

    >>> from exactspline import example
    >>> covers_once(example("sphere"), Sphere((mpq(0),) * 3, mpq(1)), mpq(0))
    True
    """
    if any(order < 0 for f in (*surface.p, surface.w) for orders in f.continuity for order in orders):
        return False
    both = surface, surface.transposed()
    return any(_Covering(each, chart, within).holds for each in both for chart in _charts(each, shape))


def between_poles(surface: NurbsSurface, shape: Shape) -> Shape | None:
    """A sphere with its centre moved to the line through two edges that are points, which is a possible axis of the
    surface.
    """
    if not isinstance(shape, Sphere):
        return None
    for each in (surface, surface.transposed()):
        first, last = (_pole(each, end) for end in (0, 1))
        if first is not None and last is not None and any(along := minus(last, first)):
            share = scalar(minus(shape.centre, first), along) / scalar(along, along)
            return replace(shape, centre=tuple(a + share * b for a, b in zip(first, along, strict=True)))
    return None


@dataclass(frozen=True)
class _Chart:
    """Coordinates on a shape: around an axis or, without `turns`, along the direction `axis`."""

    shape: Shape
    origin: Point
    axis: Point
    turns: bool = True


def _charts(surface: NurbsSurface, shape: Shape) -> Iterator[_Chart]:
    """The charts in which a surface may run around the axis as u grows."""
    poles = [p for end in (0, 1) if (p := _pole(surface, end)) is not None]
    if isinstance(shape, Plane):
        line = [surface(u, surface.domain.second.middle) for u in map(surface.domain.first.at, PLACES)]
        circle = None if poles else candidates.fitted_circle(line, shape)
        for centre in poles[:1] or ([] if circle is None else [circle.centre]):
            yield _Chart(shape, centre, shape.normal)
        yield _Chart(shape, shape.point, _mean(surface, lambda x, along: along, shape.point), turns=False)
    elif isinstance(shape, Sphere):
        axis = minus(poles[0], shape.centre) if poles else _mean(surface, cross_product, shape.centre)
        yield _Chart(shape, shape.centre, axis)
    elif isinstance(shape, Cone):
        middle = surface(*[side.middle for side in surface.domain])
        ahead = sign(scalar(minus(middle, shape.apex), shape.axis))
        yield _Chart(shape, shape.apex, tuple(ahead * a for a in shape.axis))
    elif isinstance(shape, Cylinder | Torus):
        yield _Chart(shape, shape.centre, shape.axis)


def _pole(surface: NurbsSurface, end: int) -> Point | None:
    """The point to which the first or the last line of u is contracted."""
    last = surface.patches[1] - 1 if end else 0
    ends = {point_of(surface, (i, last), 1, mpq(end)) for i in range(surface.patches[0])}
    return ends.pop() if len(ends) == 1 else None


def _mean(surface: NurbsSurface, of: Any, origin: Point) -> Point:
    """The sum of a vector of points and of derivatives by u, each divided by its largest component."""
    found = [mpq(0)] * 3
    for place in (surface.domain.at(u, v) for u, v in product(PLACES, repeat=2)):
        vector = of(minus(surface(*place), origin), surface.partial(1, 0, *place))
        if largest := max(map(abs, vector)):
            found = [a + x / largest for a, x in zip(found, vector, strict=True)]
    return tuple(candidates.rounded(a, UNIT_OF_AXIS) for a in found)


class _Covering:
    """The conditions on a surface and a chart that together show injectivity."""

    def __init__(self, surface: NurbsSurface, chart: _Chart, within: mpq) -> None:
        self.surface, self.chart, self.shape = surface, chart, chart.shape
        self.closed = tuple(closed_along(surface, along) for along in Along)
        self.square = scalar(chart.axis, chart.axis)
        #: The largest possible difference of ``2 R ρ`` of a torus from ``‖x‖² + R² − r²``.
        self.slack = mpq(0)
        if isinstance(chart.shape, Torus):
            self.slack = within * (2 * upper_square_root(chart.shape.minor_squared) + within)

    @property
    def holds(self) -> bool:
        """Whether all conditions are proved."""
        if not any(self.chart.axis):
            return False
        turning, growing = self._of_all([self._turn(self.x, self.forms.tangents[0])]), self._of_all(self._jacobian)
        if not turning or not growing or not self._is_on_one_half or (self.chart.turns and not self._turns_once):
            return False
        if not self.closed[0]:
            ends = [self.surface.isocurve(Along.V, u) for u in self.surface.domain.first]
            if not all(signs(f) == {turning * growing} for line in ends for f in self._growth_along(line)):
                return False
        return not isinstance(self.shape, Torus) or self._grows_once

    # ---- the forms

    @cached_property
    def forms(self) -> SurfaceForms:
        """The forms of the surface."""
        return SurfaceForms(self.surface)

    @cached_property
    def x(self) -> list[TensorSpline]:
        """The vector from the origin of the chart, times w."""
        return self._from_origin(self.surface)

    def _from_origin(self, of: Any) -> list[Any]:
        return [p - of.w * c for p, c in zip(of.p, self.chart.origin, strict=True)]

    def _turn(self, x: Sequence[Any], tangent: Iterable[Any]) -> Any:
        """The sign of the derivative of θ."""
        a = self.chart.axis
        return scalar(cross_product(x, list(tangent)), a) if self.chart.turns else scalar(tangent, a)

    @cached_property
    def _jacobian(self) -> list[TensorSpline]:
        """The functions that must be positive, and possibly others that must not be negative, where (θ, η, n) is
        right-handed.
        """
        n, x, a = self.forms.normal, self.x, self.chart.axis
        if isinstance(self.shape, Plane):
            return [scalar(n, self.shape.normal)]
        if isinstance(self.shape, Sphere):
            return [scalar(n, x)]
        radial = scalar(n, x) * self.square - scalar(x, a) * scalar(n, a)
        if isinstance(self.shape, Cone):
            return [radial, -scalar(n, a)]
        if isinstance(self.shape, Torus):
            w2 = self.surface.w * self.surface.w
            own = scalar(n, x)
            exact = own * self._twice_rho(self.surface) * self.square - w2 * radial * (2 * self.shape.major_squared)
            return [exact + own * w2 * (s * self.slack * self.square) for s in self._ways]
        return [radial]

    @property
    def _ways(self) -> tuple[int, ...]:
        """The signs of the slack."""
        return (1, -1) if self.slack else (0,)

    def _twice_rho(self, of: Any) -> Any:
        """Approximately ``2 R ρ`` times w²."""
        x = self._from_origin(of)
        return scalar(x, x) + of.w * of.w * (self.shape.major_squared - self.shape.minor_squared)  # type: ignore[attr-defined]  # of a torus

    def _growth_along(self, line: Nurbs) -> list[BSpline]:
        """Functions with the sign of the derivative of η along a curve."""
        x, tangent, a = self._from_origin(line), list(wronskians(line.w, line.p)), self.chart.axis
        along = scalar(tangent, a)
        if isinstance(self.shape, Cylinder):
            return [along]
        if isinstance(self.shape, Plane):
            if not self.chart.turns:
                return [scalar(tangent, cross_product(self.shape.normal, a))]
            return [-scalar(tangent, x)]
        if isinstance(self.shape, Cone):
            return [along, scalar(tangent, x) * self.square - scalar(x, a) * along]
        rise = along * scalar(x, x) - scalar(x, a) * scalar(tangent, x)
        if isinstance(self.shape, Sphere):
            return [rise]
        rest = along * self._twice_rho(line)
        return [rise * 2 - rest - along * line.w * line.w * (s * self.slack) for s in self._ways]

    # ---- their signs

    def _of_all(self, forms: Sequence[TensorSpline]) -> int:
        """The common sign of all forms inside all patches; 0 if there is none."""
        found = set[int]()
        for form, patch in product(forms, self.forms.patches):
            own = self._inside(form, patch)
            found.add(0 if own is None else SIGNS.get(sign_on_patch(own).sign, 0))
            if found not in ({1}, {-1}):
                return 0
        return found.pop()

    def _inside(self, form: TensorSpline, patch: Patch) -> PatchForm | None:
        """A form on a patch without its zeros on edges that are points; None if the form vanishes identically, or on
        another edge of v.
        """
        if (whole := form.patch_form(*patch)).is_zero:
            return None
        own, (*_, first, last) = whole.without_border((1,))
        at_ends = (first, 0), (last, self.surface.patches[1] - 1)
        if any(times and not (pole and patch[1] == at) for (times, at), pole in zip(at_ends, self._poles, strict=True)):
            return None
        return own

    @cached_property
    def _poles(self) -> tuple[bool, bool]:
        return _pole(self.surface, 0) is not None, _pole(self.surface, 1) is not None

    @property
    def _is_on_one_half(self) -> bool:
        """Whether the whole surface is on one side of the apex of a cone."""
        return not isinstance(self.shape, Cone) or self._of_all([scalar(self.x, self.chart.axis)]) != 0

    # ---- not more than one turn

    @property
    def _turns_once(self) -> bool:
        """Whether no angle around the axis occurs twice along a line of u or, if these lines are not closed,
        anywhere.
        """
        middle, a = [side.middle for side in self.surface.domain], self.chart.axis
        if self.closed[0]:
            line = self.surface.isocurve(Along.U, middle[1])
            height = scalar(minus(line(line.domain[0]), self.chart.origin), a) / self.square
            foot = tuple(c + height * y for c, y in zip(self.chart.origin, a, strict=True))
            return not passes_its_start(line, Circle(foot, mpq(1), a))
        start = minus(self.surface(*middle), self.chart.origin)
        away = [-y for y in cross_product(cross_product(a, start), a)]
        return self._is_off([(scalar(self.x, away), scalar(cross_product(self.x, away), a))])

    @property
    def _grows_once(self) -> bool:
        """Whether no angle along the meridians of a torus occurs twice for one θ."""
        middle = [side.middle for side in self.surface.domain]
        if not self.closed[1]:
            (x, y), (a, b) = self._meridian(PointToAsk(self.surface(*middle), mpq(1))), self._meridian(self.surface)
            w2 = self.surface.w * self.surface.w
            moved = [a + w2 * (s * self.slack) for s in self._ways]
            return self._is_off([(-(each * x + b * y), b * x - each * y) for each in moved])
        line = self.surface.isocurve(Along.V, middle[0])
        offset, start = self._from_origin(line), minus(line(line.domain[0]), self.chart.origin)
        along = scalar(start, self.chart.axis) / self.square
        ahead = scalar(offset, [x - along * y for x, y in zip(start, self.chart.axis, strict=True)])
        growth = [signs(f) for f in self._growth_along(line)]
        if signs(ahead) != {1} or any(len(own) != 1 or own != growth[0] for own in growth):
            return False
        a, b = self._meridian(line)
        return sum(root < line.domain[1] and sign_at(a, root) > 0 for root in zeros(b)) == 1

    def _meridian(self, of: Any) -> tuple[Any, Any]:
        """Approximately ``2 R (ρ − R)`` and the place along the axis, each times w² and a constant."""
        along = scalar(self._from_origin(of), self.chart.axis) * of.w
        return self._twice_rho(of) - of.w * of.w * (2 * self.shape.major_squared), along  # type: ignore[attr-defined]  # of a torus

    def _is_off(self, pairs: Sequence[tuple[TensorSpline, TensorSpline]]) -> bool:
        """Whether the patches do not meet a half-plane. Each pair of forms gives a half-plane, on which the first form
        is positive and the second is 0; one pair suffices.
        """
        flat, patches = [f for pair in pairs for f in pair], self.forms.patches
        forms = ([self._inside(f, patch) or f.patch_form(*patch) for f in flat] for patch in patches)
        search = Search(Sized(UNIT, own) for own in forms)
        for part in search:
            if search.seen > BOXES + len(patches):
                return False
            ahead, across = ({f.sign for f in part.forms[k::2]} for k in (0, 1))
            if ahead != {-1} and across not in ({1}, {-1}):
                search.split(halved(part))
        return True
