"""The forms of κ, κ′ and the speed (in space of τ, too) of all curves near a curve, with one number per coordinate of a
control point for the change of the form with this coordinate, and a ball for all terms of second order.

A number that depends on the curve is written ``f + Σ sⱼ εⱼ + r`` with ``|εⱼ| ≤ 1``, where εⱼ E is added to one
coordinate of a control point, or to a weight, and r is in a ball (affine arithmetic: Comba and Stolfi, 1993). The
programs that compute a form run on polynomials with such coefficients, so that terms that cancel in a form cancel here,
too, to first order in E.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from itertools import pairwise
from math import comb
from typing import Any

from flint import arb, arb_mat, arb_poly, fmpq, fmpz

from exactspline.errors import ShapeError
from exactspline.geometry.curves.plane_programs import plane_program, space_program
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.patch_forms import restriction
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs

#: Bits of the balls.
PRECISION = 192
NOTHING = arb_poly()
#: Bits to which the zero of the form of the curve itself is sought.
CLOSE = 48
#: A part is halved only if the form changes at least this much, relative to its differences between the curves.
FLAT = 8


class _Affine:
    """A polynomial in the parameter with coefficients ``f + Σ sⱼ εⱼ + r``: with the operations that a program needs.
    Slopes that are 0 are not stored; without a remainder the computation is of first order.
    """

    __slots__ = ("remainder", "slopes", "value")

    def __init__(self, value: arb_poly, slopes: dict[int, arb_poly], remainder: arb_poly | None) -> None:
        self.value, self.slopes, self.remainder = value, slopes, remainder

    def _each(self, change: Callable[[arb_poly], arb_poly]) -> _Affine:
        slopes = {k: change(slope) for k, slope in self.slopes.items()}
        return _Affine(change(self.value), slopes, None if self.remainder is None else change(self.remainder))

    def __add__(self, other: _Affine) -> _Affine:
        remainder = None if self.remainder is None or other.remainder is None else self.remainder + other.remainder
        return _Affine(self.value + other.value, _merged(self.slopes, other.slopes), remainder)

    def __neg__(self) -> _Affine:
        return self._each(lambda p: -p)

    def __sub__(self, other: _Affine) -> _Affine:
        return self + -other

    def __mul__(self, other: Any) -> _Affine:
        if not isinstance(other, _Affine):  # an exact polynomial or an integer
            return self._each(lambda p: p * other)
        left = {k: slope * other.value for k, slope in self.slopes.items()}
        slopes = _merged(left, {k: self.value * slope for k, slope in other.slopes.items()})
        remainder = None
        if self.remainder is not None and other.remainder is not None:
            a, b = self._first_order(), other._first_order()
            remainder = (
                a * b + (self.value + a) * other.remainder + self.remainder * (other.value + b + other.remainder)
            )
        return _Affine(self.value * other.value, slopes, remainder)

    __rmul__ = __mul__

    def _first_order(self) -> arb_poly:
        """``Σ sⱼ εⱼ`` as balls."""
        length = max((slope.length() for slope in self.slopes.values()), default=0)
        radii = [sum((abs(slope[k]) for slope in self.slopes.values()), start=arb(0)) for k in range(length)]
        return arb_poly([arb(0, radius.upper()) for radius in radii])

    def derivative(self) -> _Affine:
        """The derivative by the parameter."""
        return self._each(lambda p: p.derivative())

    def left_shift(self, n: int) -> _Affine:
        """The polynomial times a power of the parameter."""
        return self._each(lambda p: p.left_shift(n))


def _merged(a: dict[int, arb_poly], b: dict[int, arb_poly]) -> dict[int, arb_poly]:
    """The sums of the slopes of two polynomials."""
    return a | {k: a[k] + slope if k in a else slope for k, slope in b.items()}


class Family:
    """The form of all curves near a curve, on a part of a segment, in the Bernstein basis: a matrix whose first row is
    the form of the curve; each other row is the change of the form when one coordinate changes by E; the last row is a
    remainder.
    """

    def __init__(self, rows: arb_mat) -> None:
        self.rows = rows

    @property
    def degree(self) -> int:
        """The degree in the parameter."""
        return self.rows.ncols() - 1

    @cached_property
    def ordinates(self) -> list[arb]:
        """The ordinates, each as a ball that contains the ordinates of all curves."""
        return _enclosed(self.rows)

    @cached_property
    def of_curve(self) -> list[arb]:
        """The ordinates of the form of the curve itself."""
        return [self.rows[0, k] for k in range(self.degree + 1)]

    @property
    def uncertain(self) -> bool:
        """Whether subdivision will hardly decide more: everywhere some of the curves have the value zero, or the curves
        differ by far more than the form of one curve changes.
        """
        change = max(self.of_curve) - min(self.of_curve)
        return all(x.contains(0) for x in self.ordinates) or all(change * FLAT < x.rad() for x in self.ordinates)

    @property
    def sign(self) -> int:
        """The common sign of all values of all curves; 0 if the ordinates do not show it."""
        return _common_sign(self.ordinates) if _common_sign(self.of_curve) else 0

    @cached_property
    def crossing(self) -> int:
        """The sign of the derivative at every zero of the forms of all curves, so that each form has at most one zero;
        0 if this is not proved. The proof is a number λ for which f′ + λ f has one sign for all curves.
        """
        if not self.degree:
            return 0
        own, differences = self.of_curve, self.rows * difference_matrix(self.degree)
        if _common_sign([b - a for a, b in pairwise(own)]) and (sign := _common_sign(_enclosed(differences))):
            return sign
        derivatives = self.rows * _derivative_matrix(self.degree)
        middle = _bernstein(self.degree, mpq(1, 2))
        values, slopes = ([float(x.mid()) for (x,) in (m * middle).table()] for m in (self.rows, derivatives))
        factor = arb(_best_factor(values, slopes))
        if not _common_sign([derivatives[0, k] + factor * x for k, x in enumerate(own)]):
            return 0
        return _common_sign(_enclosed(derivatives + self.rows * factor))

    def halves(self) -> tuple[Family, Family]:
        """The two halves."""
        low, high = (Family(self.rows * cutting(self.degree, side).transpose()) for side in UNIT.first.halves)
        return low, high

    def at(self, t: mpq) -> arb:
        """A ball that contains the values at a local parameter."""
        return _enclosed(self.rows * _bernstein(self.degree, t))[0]

    def zero_of_curve(self) -> mpq:
        """Approximately the parameter at which the form of the curve itself, which is monotonic, is zero, or nearest to
        zero.
        """
        first, last = self.of_curve[0], self.of_curve[-1]
        if not first * last < 0:
            return mpq(int(abs(last) < abs(first)))
        low, high = mpq(0), mpq(1)
        for _ in range(CLOSE):
            middle = (low + high) / 2
            (value,) = casteljau(self.of_curve, arb(to_fmpq(middle)))
            low, high = (middle, high) if value * first > 0 else (low, middle)
        return low

    def values(self, t: mpq) -> list[arb]:
        """The value of the form of the curve at a local parameter, its change when each coordinate changes by E, and
        the remainder.
        """
        return [x for (x,) in (self.rows * _bernstein(self.degree, t)).table()]


#: The remedies where weights may vanish or change their sign: for the weights of near curves, and for those of the
#: curve itself.
SMALLER = "weights that stay positive: a smaller epsilon"
INSERT = "restrict it to its domain and insert knots until all weights have one sign"


def with_positive_weights(curve: Nurbs) -> Nurbs:
    """The same curve with a positive weight function: if the weight function is negative, all weights are multiplied by
    −1.

    Raises `ShapeError` for control points that are directions, because their coordinates are not those of points.
    """
    if any(isinstance(point, Direction) for point in curve.control_points):
        raise ShapeError("curves near a curve with a direction among its control points", remedy=INSERT)
    if curve.w.numerators[0][0] > 0:
        return curve
    return Nurbs(curve.degree, curve.knots, curve.control_points, [-w for w in curve.weights], name=curve.name)


class CurvesNear:
    """The forms of the curves near a curve in the plane or in space, segment by segment.

    Raises `ShapeError` if the weight function of one of these curves may vanish.
    """

    def __init__(self, curve: Nurbs, within: mpq) -> None:
        self.curve = curve = with_positive_weights(curve)
        self.within, self.rational = within, not curve.polynomial
        self.per_point = curve.dimension + self.rational
        self._program = (plane_program if curve.dimension == 2 else space_program)(curve.degree, self.rational)
        self._known = dict[int, tuple[Any, ...]]()
        ball = arb(0, arb(to_fmpq(within)).upper())
        self._points = [[arb(to_fmpq(x)) for x in point] for point in curve.control_points]
        self._weights = [arb(to_fmpq(w)) for w in curve.weights]
        #: The control points of all curves, as balls.
        self.points = [[x + ball for x in point] for point in self._points]
        self.weights = [w + ball for w in self._weights] if self.rational else self._weights
        if self.rational and not self._positive(self.weights):
            raise ShapeError(f"curves within {within}", remedy=SMALLER if self._positive(self._weights) else INSERT)

    def _positive(self, weights: list[arb]) -> bool:
        """Whether a weight function has positive Bernstein coefficients on all segments."""
        return all(
            sum(a * w for a, w in zip(row, weights[first:], strict=False)) > 0
            for first, basis in map(self.basis, range(self.curve.segments))
            for row in zip(*basis, strict=True)
        )

    def basis(self, i: int) -> tuple[int, tuple[tuple[arb, ...], ...]]:
        """The first control point of a segment, and the ordinates of its basis functions there."""
        n, knots = self.curve.degree, self.curve.knots
        j = bisect_right(knots, self.curve.breakpoints[i]) - 1
        start, width = knots[j], knots[j + 1] - knots[j]
        return j - n, basis_ordinates(n, tuple((knots[k] - start) / width for k in range(j - n, j + n + 2)))

    def form(self, which: int, i: int) -> Family:
        """A form on a segment; for the distance 0 to first order, with the change of the form when a coordinate changes
        by 1.
        """
        found = self._forms(i)[which]
        # a form that vanishes for all curves, such as the curvature of a line, is computed without slopes
        form = found if isinstance(found, _Affine) else _Affine(arb_poly(found), {}, NOTHING)
        m, count = self._program.terms[which].degrees[0], (self.curve.degree + 1) * self.per_point
        rows = [
            form.value,
            *[form.slopes.get(k, NOTHING) for k in range(count)],
            NOTHING if form.remainder is None else form.remainder,
        ]
        binomials = [arb(comb(m, k)) for k in range(m + 1)]
        return Family(arb_mat(len(rows), m + 1, [row[k] / binomials[k] for row in rows for k in range(m + 1)]))

    def _forms(self, i: int) -> tuple[Any, ...]:
        """All forms on a segment, as of width 1."""
        if i not in self._known:
            run: Any = self._program.run  # it computes with whatever polynomials it is given
            given = [[x] for x in self._homogeneous(i)]
            self._known[i] = run(given, [[fmpz(1)]] * len(self._program.groups), [(fmpz(1), fmpz(1))])[0]
        return self._known[i]

    def _homogeneous(self, i: int) -> list[_Affine]:
        """The homogeneous coordinates of a segment."""
        n, (first, basis) = self.curve.degree, self.basis(i)
        polynomials = [arb_poly([x * comb(n, k) for k, x in enumerate(row)]) for row in basis]
        step, width = arb(to_fmpq(self.within)) if self.within else arb(1), self.per_point
        local = [(width * k, first + k, b, b * step) for k, b in enumerate(polynomials)]
        square = arb(0, (step * step).upper())
        found = []
        last = self.curve.dimension
        for c in range(last):
            value = sum((b * (self._weights[j] * self._points[j][c]) for _, j, b, _ in local), start=NOTHING)
            slopes = {k + c: moved * self._weights[j] for k, j, _, moved in local}
            second = NOTHING
            if self.rational:
                slopes |= {k + last: moved * self._points[j][c] for k, j, _, moved in local}
                # (w + ε E) (x + ε′ E) has ε ε′ E² beyond its linear part
                second = sum((b * square for *_, b, _ in local), start=NOTHING)
            found.append(_Affine(value, slopes, second if self.within else None))
        if self.rational:
            value = sum((b * self._weights[j] for _, j, b, _ in local), start=NOTHING)
            found.append(
                _Affine(value, {k + last: moved for k, _, _, moved in local}, NOTHING if self.within else None)
            )
        return found


class Settled:
    """Boxes in which each of many objects has exactly one point, each within a larger box in which the object has no
    other point.
    """

    def __init__(self) -> None:
        self.places, self.around = list[Box](), list[Box]()

    def contains(self, box: Box) -> bool:
        """Whether all points in a box are known."""
        return any(known.contains(box) for known in self.around)

    def add(self, place: Box, around: Box) -> bool:
        """Add a box, unless its points are known already; False if neither is certain."""
        overlapping = [k for k, known in enumerate(self.places) if known.meets(place)]
        if any(not self.around[k].contains(place) for k in overlapping):
            return False
        if not overlapping:
            self.places.append(place)
            self.around.append(around)
        return True


def _common_sign(balls: Sequence[arb]) -> int:
    """The common sign of all numbers; 0 if there is none, or if there are no numbers."""
    return 1 if balls and all(x > 0 for x in balls) else -1 if balls and all(x < 0 for x in balls) else 0


def _enclosed(rows: arb_mat) -> list[arb]:
    """For each column a ball: the first entry with the sum of the other entries as its radius."""
    own, *changes = rows.table()
    radii = [sum((abs(x) for x in column), start=arb(0)) for column in zip(*changes, strict=True)]
    return [x + arb(0, radius.upper()) for x, radius in zip(own, radii, strict=True)]


@cache
def basis_ordinates(n: int, knots: tuple[mpq, ...]) -> tuple[tuple[arb, ...], ...]:
    """The ordinates of the basis functions on the segment [0, 1]."""
    units = [[int(i == k) for i in range(n + 1)] for k in range(n + 1)]
    return tuple(tuple(arb(to_fmpq(x)) for x in BSpline(n, knots, unit).bezier_points[0]) for unit in units)


def _best_factor(values: Sequence[float], slopes: Sequence[float]) -> float:
    """The number λ for which ``|a₀ + λ b₀| / Σ|aⱼ + λ bⱼ|`` is largest, for slopes a and values b; this is a number at
    which a summand vanishes, or 0.
    """

    def share(factor: float) -> float:
        own, *others = (abs(a + factor * b) for a, b in zip(slopes, values, strict=True))
        return own / total if (total := sum(others)) else own

    return max([values[0] * 0, *[-a / b for a, b in zip(slopes[1:], values[1:], strict=True) if b]], key=share)


@cache
def _derivative_matrix(n: int) -> arb_mat:
    """The matrix that gives the ordinates of the derivative, of the same degree."""
    # the derivative has the ordinates n Δ; elevated, the k-th is their mean with the weights k and n − k
    weights = [{k - 1: -k, k: 2 * k - n, k + 1: n - k} for k in range(n + 1)]
    return arb_mat([[column.get(j, 0) for column in weights] for j in range(n + 1)])


@cache
def difference_matrix(n: int) -> arb_mat:
    """The matrix that gives the differences of neighbouring ordinates."""
    return arb_mat(n + 1, n, [int(i == k + 1) - int(i == k) for i in range(n + 1) for k in range(n)])


@lru_cache(256)
def cutting(n: int, side: Interval) -> arb_mat:
    """The matrix that gives the ordinates on an interval."""
    matrix, bottom = restriction(n, *side)
    return arb_mat(n + 1, n + 1, [arb(fmpq(x, bottom)) for x in matrix.entries()])


def casteljau(row: list[arb], t: arb, count: int = 1) -> list[arb]:
    """The last ordinates, this many, of de Casteljau's algorithm."""
    while len(row) > count:
        row = [a + (b - a) * t for a, b in pairwise(row)]
    return row


def _bernstein(n: int, t: mpq) -> arb_mat:
    """The Bernstein polynomials at a parameter, as a column."""
    s, r = arb(to_fmpq(t)), arb(to_fmpq(1 - t))
    return arb_mat(n + 1, 1, [comb(n, k) * s**k * r ** (n - k) for k in range(n + 1)])
