"""The umbilics of all surfaces near a given surface, and those that only some of them may have.

Umbilics are common zeros of the coefficients A and B of the lines of curvature. The values and gradients of A and B on
a rectangle of parameters, for all surfaces whose control points and weights differ by at most epsilon, are enclosed by
Taylor series with balls for coefficients, from control points of all derivatives with balls for coordinates. A value
other than zero shows that no surface has an umbilic there; if Krawczyk's operator maps a rectangle into itself, each
surface has exactly one umbilic there.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto
from functools import reduce
from itertools import product
from math import factorial, prod
from typing import Any, cast

from flint import arb, arb_mat, ctx

from exactspline.errors import ShapeError
from exactspline.formulas.surfaces.by_forms import line_uu_of_forms, line_uv_of_forms
from exactspline.formulas.surfaces.lifted import area_squared_lifted, lifted_forms
from exactspline.geometry.rounded.forms import (
    INSERT,
    PRECISION,
    SMALLER,
    Settled,
    basis_ordinates,
    cutting,
    difference_matrix,
)
from exactspline.numbers.exact import Number, mpq, scalar, to_fmpq
from exactspline.numbers.intervals import UNIT, Box, Interval, ball_around, ball_ends
from exactspline.numbers.search import Search
from exactspline.one_line import OneLine
from exactspline.polynomials.patch_forms import clusters
from exactspline.readings.taylor import DoubleSeries
from exactspline.splines.knots import KnotVector
from exactspline.splines.precision import distance
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.type_checks import surface_of

#: The number of rectangles examined, and the least number on each patch; the remaining rectangles are reported as not
#: robust.
MOST, MOST_OF_A_PATCH = 440, 10
#: A rectangle is not halved if the change of a form on it is at most this many times its difference between surfaces.
SPREAD = 8
#: The number of derivatives: two for the forms, and one for their gradients.
TERMS = 4
#: The number of times that a rectangle with an umbilic is narrowed.
STEPS = 6
#: The narrowest rectangle, in bits of the patch.
NARROWEST = 60


@dataclass(frozen=True, repr=False)
class NearbyUmbilic(OneLine):
    """An umbilic of the surfaces near a given surface, in a rectangle of parameters.

    ``robust``: each of these surfaces has exactly one umbilic there. Otherwise some may have any number of umbilics
    there, and others none.
    """

    sides: Box
    robust: bool


def umbilics_nearby(surface: NurbsSurface, epsilon: Number) -> tuple[NearbyUmbilic, ...]:
    """The umbilics of all surfaces near a given surface, and those that only some of them may have. A surface is near
    if its control points and, for a rational surface, weights differ by at most epsilon. An umbilic on a border of
    patches is never robust.

    >>> from exactspline import example
    >>> umbilics_nearby(example("hyperbolic_paraboloid"), "1/1000000")
    ()

    Raises `ShapeError` for a surface that is not in space, for an epsilon that is not positive, and if a weight of a
    near surface may vanish.
    """
    given = surface_of(surface)
    if given.dimension != 3:
        raise ShapeError(f"umbilics in R{given.dimension}", remedy="this needs a surface in space")
    rows, columns = given.patches
    with ctx.workprec(PRECISION):
        near = _SurfacesNear(given, distance(epsilon, given))
        found = [x for i in range(rows) for j in range(columns) for x in _Search(near, (i, j)).found()]
    robust = [x for x in found if x.robust]
    joined = [NearbyUmbilic(box, robust=False) for box, _ in clusters([x.sides for x in found if not x.robust])]
    return tuple(sorted([*robust, *joined], key=lambda each: each.sides))


class _Balls(DoubleSeries):
    """A series with balls for coefficients."""

    __slots__ = ()

    @staticmethod
    def number(value: Any) -> Any:
        """A constant, converted to a ball."""
        return value if isinstance(value, arb) else arb(to_fmpq(mpq(value)))

    @property
    def ball(self) -> arb:
        """A ball that contains the values."""
        return cast(arb, self.value)

    @property
    def gradient(self) -> list[arb]:
        """The derivatives with respect to both parameters."""
        return [cast(Any, self.coefficients).get(place, arb(0)) for place in ((1, 0), (0, 1))]


class _SurfacesNear:
    """The control points of all surfaces near a surface, with balls for coordinates."""

    def __init__(self, surface: NurbsSurface, within: mpq) -> None:
        self.surface = surface
        ball = arb(0, arb(to_fmpq(within)).upper())
        sign = -1 if surface.weights[0][0] < 0 else 1  # multiplying all weights by −1 does not change the surface
        own = [[_Balls.number(sign * w) for w in row] for row in surface.weights]
        weights = own if surface.polynomial else [[w + ball for w in row] for row in own]
        if not all(w > 0 for row in weights for w in row):
            keeps = all(w > 0 for row in own for w in row)
            raise ShapeError(f"surfaces within {within}", remedy=SMALLER if keeps else INSERT)
        points = [
            [
                [(_Balls.number(p[c]) + ball) * w for p, w in zip(*rows, strict=True)]
                for rows in zip(surface.control_points, weights, strict=True)
            ]
            for c in range(3)
        ]
        self.nets = [*points, weights]

    def patch(self, i: int, j: int) -> tuple[Box, list[dict[tuple[int, int], arb_mat]]]:
        """The parameters of a patch and the control nets of each homogeneous coordinate with its derivatives."""
        sides = self.surface.w.patch(i, j)
        cuts, bases = zip(
            *(
                _of_segment(knots, n, side.low)
                for knots, n, side in zip(self.surface.knots, self.surface.degree, sides, strict=True)
            ),
            strict=True,
        )
        left, right = bases[0].transpose(), bases[1]
        found = []
        for net in self.nets:
            cut = arb_mat([row[cuts[1]] for row in net[cuts[0]]])
            found.append(dict(_derivatives(left * cut * right)))
        return sides, found


def _of_segment(knots: KnotVector, n: int, start: mpq) -> tuple[slice, arb_mat]:
    """The control points of a segment, and the ordinates of their basis functions on it."""
    j = bisect_right(knots, start) - 1
    width = knots[j + 1] - knots[j]
    local = tuple((knots[k] - knots[j]) / width for k in range(j - n, j + n + 2))
    return slice(j - n, j + 1), arb_mat([list(row) for row in basis_ordinates(n, local)])


def _derivatives(net: arb_mat) -> Iterator[tuple[tuple[int, int], arb_mat]]:
    """The nets of all partial derivatives that are needed, by their orders."""
    m, n = net.nrows() - 1, net.ncols() - 1
    for i in range(min(m + 1, TERMS)):
        for j in range(min(n + 1, TERMS - i)):
            yield (i, j), _differences(m, i) * net * _differences(n, j).transpose()


def _differences(n: int, order: int) -> arb_mat:
    """The matrix of the derivative of an order of ordinates in the Bernstein basis."""
    steps = [difference_matrix(n - k).transpose() * (n - k) for k in range(order)]
    return reduce(lambda made, step: step * made, steps, arb_mat(n + 1, n + 1, 1))


class _State(Enum):
    """The state of a rectangle of parameters."""

    #: No surface has an umbilic there, or each has a single one, which is robust.
    SETTLED = auto()
    #: Smaller parts may be decided.
    OPEN = auto()
    #: Some surfaces may have umbilics there, and smaller parts would not be decided.
    LEFT = auto()


class _Search:
    """The umbilics on one patch, in local parameters from 0 to 1."""

    def __init__(self, near: _SurfacesNear, patch: tuple[int, int]) -> None:
        self.surface = near.surface
        self.sides, self.nets = near.patch(*patch)
        self.most = MOST // prod(near.surface.patches) + MOST_OF_A_PATCH
        self.settled = Settled()

    def found(self) -> Iterator[NearbyUmbilic]:
        """All umbilics, in the parameters of the surface."""
        open_boxes = self._possible()
        for boxes, robust in ((self.settled.places, True), (open_boxes, False)):
            yield from (NearbyUmbilic(self.sides.part(box), robust) for box in boxes)

    def _possible(self) -> list[Box]:
        """Rectangles outside which there are only robust umbilics."""
        search = Search([UNIT])
        for box in search:
            if not self.settled.contains(box):
                allowed = search.seen <= self.most and search.depth <= NARROWEST
                state = self._decided(box) if allowed else _State.LEFT
                if state is not _State.SETTLED:
                    search.split(box.halves(search.depth % 2) if state is _State.OPEN else None)
        return search.open

    def _decided(self, box: Box) -> _State:
        """The state of a rectangle; an umbilic found to be robust is added to the settled ones."""
        if not all(f.ball.contains(0) for f in self._forms(box, TERMS - 1)):
            return _State.SETTLED
        here, around = self._forms(_point(box)), self._forms(box)
        gap = [ball_around(-side.width / 2, side.width / 2) for side in box]
        values = [f.ball for f in here]
        if all(v.contains(0) for v in values) and self._may_have_one_at_each_corner(box):
            return _State.LEFT
        slopes = [f.gradient for f in around]
        enclosed = [v + scalar(g, gap) for v, g in zip(values, slopes, strict=True)]
        if not all(x.contains(0) for x in enclosed):
            return _State.SETTLED
        (a, b), (c, d) = slopes
        if not (a * d - b * c).contains(0) and self._settles(box, [f.gradient for f in here]):
            return _State.SETTLED
        blurred = all(
            v.contains(0) and SPREAD * v.rad() >= scalar([abs(x) for x in g], [abs(x).upper() for x in gap]).mid()
            for v, g in zip(values, slopes, strict=True)
        )
        return _State.LEFT if blurred else _State.OPEN

    def _may_have_one_at_each_corner(self, box: Box) -> bool:
        """Whether no smaller part could be decided, as on a sphere."""
        corners = (Box.point(u, v) for u, v in product(*box))
        return all(f.ball.contains(0) for corner in corners for f in self._forms(corner, TERMS - 1))

    def _settles(self, box: Box, slopes: list[list[arb]]) -> bool:
        """Whether each surface has exactly one umbilic in a rectangle around this one."""
        (a, b), (c, d) = ([x.mid() for x in row] for row in slopes)
        determinant = a * d - b * c
        inverse = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
        around = Box(
            *(Interval(max(side.low - side.width, mpq(0)), min(side.high + side.width, mpq(1))) for side in box)
        )
        place = self._krawczyk(around, inverse)
        if place is None or not place.is_inside(around) or not self._is_regular(around):
            return False
        for _ in range(STEPS):
            image = self._krawczyk(place, inverse)
            if image is None or not image.is_inside(place):
                break
            place = image
        return self.settled.add(place, around)

    def _krawczyk(self, box: Box, inverse: list[list[arb]]) -> Box | None:
        """The image of a rectangle under Krawczyk's operator. The image contains the zeros of all surfaces in the
        rectangle; if the image is inside the rectangle, each surface has exactly one zero.
        """
        here, around = self._forms(_point(box)), self._forms(box)
        values, slopes = [f.ball for f in here], [f.gradient for f in around]
        sides = []
        for k, (row, side) in enumerate(zip(inverse, box, strict=True)):
            half = [ball_around(-other.width / 2, other.width / 2) for other in box]
            rest = [int(k == m) - scalar(row, [g[m] for g in slopes]) for m in (0, 1)]
            image = arb(to_fmpq(side.middle)) - scalar(row, values) + scalar(rest, half)
            if not image.is_finite():
                return None
            sides.append(ball_ends(image))
        return Box(*sides)

    def _is_regular(self, box: Box) -> bool:
        """Whether all surfaces have a tangent plane, and S_u ≠ 0, on a rectangle."""
        argument = self._argument(box, TERMS - 1)
        return bool(area_squared_lifted(argument).value > 0 and lifted_forms(argument).E.value > 0)

    def _forms(self, box: Box, terms: int = TERMS) -> tuple[_Balls, _Balls]:
        """A and B on a rectangle, with their gradients."""
        forms = lifted_forms(self._argument(box, terms))
        return line_uu_of_forms(forms), line_uv_of_forms(forms)

    def _argument(self, box: Box, terms: int) -> Any:
        """The surfaces as series: each coefficient with its values on the whole rectangle."""
        series = iter([_series(nets, box, terms) for nets in self.nets])
        return cast(Any, self.surface.mapped(lambda _: next(series)))


def _series(nets: dict[tuple[int, int], arb_mat], box: Box, terms: int) -> _Balls:
    """The series of a coordinate, from the nets of its derivatives."""
    found = {}
    for (i, j), net in nets.items():
        if i + j < terms:
            left, right = cutting(net.nrows() - 1, box.first), cutting(net.ncols() - 1, box.second)
            values: list[arb] = (left * net * right.transpose()).entries()
            found[i, j] = reduce(arb.union, values) / (factorial(i) * factorial(j))
    return _Balls(cast(Any, found), terms)


def _point(box: Box) -> Box:
    return Box.point(*box.middle)
