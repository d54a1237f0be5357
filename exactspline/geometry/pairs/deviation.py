"""The deviation of one curve from another: bounds for the largest distance of a point of the first curve from the
second, and whether this distance is at most a given number. The deviation is not symmetric: a part of a curve does not
deviate from the whole curve, but the whole curve may deviate from the part.

Points of the first curve have certified nearest points on the second (`nearest`); their distances are lower bounds. A
piece of the first curve is within a distance D if there is an affine map from its parameters to those of a segment of
the second curve such that a polynomial, the squared distance of corresponding points minus D², is nowhere positive. The
maps tried are constant maps and those that send the ends of the piece to their nearest points. All other pieces are
halved, those with the farthest ends first. Pieces along which the curves coincide are known from the arcs in common.

If the largest distance is exactly D, the decision uses the parameters at which the number of points of a segment at the
distance D may change: between two neighbouring such parameters, either every point is within the distance or no point
is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from heapq import heappop, heappush
from itertools import pairwise, product
from operator import attrgetter

from flint import fmpq, fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.curves.planarity import check_in_one_space
from exactspline.geometry.pairs.box_tree import segments_of
from exactspline.geometry.pairs.distance import Forms
from exactspline.geometry.pairs.intersections import intersections
from exactspline.geometry.pairs.nearest import nearest
from exactspline.numbers.exact import mpq, text, to_fmpq
from exactspline.numbers.intervals import UNIT, Interval, Side, joined
from exactspline.numbers.once import cached_property
from exactspline.polynomials.cost import bounded
from exactspline.polynomials.elimination import discriminant, square_free
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.two_parameters import at, rows_of
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, between, real, square_root
from exactspline.roots.of_polynomials import distinct, roots_in
from exactspline.splines.nurbs import Nurbs

#: The ratio of the upper bound to the lower one, and a number below its square.
RATIO, SQUARED = mpq(10099, 10000), mpq(10198, 10000)
#: Halvings for each segment of both curves before a distance is decided exactly.
HALVINGS = 10
#: The digits of a rational parameter near a nearest point.
DIGITS = 64


@dataclass(frozen=True)
class Foot:
    """A parameter of a curve and the parameter of the nearest point of the other curve, with the squared distance,
    exactly and to eight digits; and places on the other curve that are tried: segments with local parameters.
    """

    at: mpq
    nearest: Real
    squared: Real
    near: mpq
    tried: list[tuple[int, mpq]]


def foot_of(curve: Nurbs, point: tuple[mpq, ...], at: mpq) -> Foot:
    """The nearest point of a curve; a rational parameter near it is tried.

    >>> from exactspline import example
    >>> foot = foot_of(example("circle"), (mpq(3), mpq(3)), mpq(0))
    >>> foot.nearest.closed_form, [(i, float(t)) for i, t in foot.tried]
    ('-1 + √2', [(0, 0.41421356237...)])
    """
    found, (low, high) = nearest(curve, point), curve.domain
    t = found.points[0].parameter if found.points else Real(found.everywhere[0].parts[0].low)
    image = min(max(t.enclosure(DIGITS).middle, low), high)
    squares = ((x - y) ** 2 for x, y in zip(curve(image), point, strict=True))
    squared = found.points[0].squared if found.points else Real(sum(squares, mpq(0)))
    images = curve.domain if curve.closed and image in curve.domain else (image,)
    sides = [Interval(*ends) for ends in pairwise(curve.breakpoints)]
    places = [(j, side.local(t)) for j, side in enumerate(sides) for t in images if side.low <= t <= side.high]
    return Foot(at, t, squared, squared.rational_near(8), places)


class _OneWay:
    """The distances of the points of a curve from another curve, and the pieces not yet shown to have squared distances
    of at most the `bound`. By default the bound is the square of a distance a hundredth larger than the largest
    distance found.
    """

    def __init__(self, curve: Nurbs, other: Nurbs, bound: mpq | None = None) -> None:
        check_in_one_space(curve, other)
        self.curves, self.bound, self.queue = (curve, other), bound, list[tuple[mpq, int, mpq, Foot, Foot]]()
        one, two = (segments_of(each).forms for each in self.curves)
        self.forms = cache(lambda i, j: Forms(one[i], two[j], UNIT))
        self.rows = cache(lambda i, j: [rows_of(p) for p in (self.forms(i, j).top, self.forms(i, j).bottom)])
        self.farthest = self._foot(curve.domain[0])
        for i, (a, b) in enumerate(pairwise(curve.breakpoints)):
            self._put(i, self._foot(a), self._foot(b, Side.LEFT))

    def _foot(self, s: mpq, side: Side = Side.RIGHT) -> Foot:
        return foot_of(self.curves[1], self.curves[0](s, side), s)

    def _put(self, i: int, start: Foot, end: Foot) -> None:
        self.farthest = max(self.farthest, start, end, key=attrgetter("near"))
        heappush(self.queue, (-max(start.near, end.near), i, start.at, start, end))

    def halvings(self) -> Iterator[Foot]:
        """Halve pieces, those with the farthest ends first; after each step yield the farthest point found."""
        yield self.farthest
        while self.queue:
            _, i, _, start, end = heappop(self.queue)
            if self._is_within(i, start, end, self.farthest.near * SQUARED if self.bound is None else self.bound):
                continue
            middle = self._foot((start.at + end.at) / 2)
            apart = start.near or middle.near or end.near
            if apart or not any(part.low <= start.at and end.at <= part.high for part in self.shared):
                self._put(i, start, middle)
                self._put(i, middle, end)
                yield self.farthest

    def _is_within(self, i: int, start: Foot, end: Foot, bound: mpq) -> bool:
        """Whether an affine map carries a piece to points within a distance."""
        side = self._side(i)
        pairs = [(j, (a, b)) for (j, a), (k, b) in product(start.tried, end.tried) if j == k]
        pairs += [(j, (a, a)) for j, a in (*start.tried, *end.tried)]
        s = _affine(side.local(start.at), side.local(end.at))
        for j, t in pairs:
            squared, weight = (_along(rows, s, _affine(*t)) for rows in self.rows(i, j))
            if _never_positive(squared - weight * to_fmpq(bound)):
                return True
        return False

    def _side(self, i: int) -> Interval:
        return Interval(*self.curves[0].breakpoints[i : i + 2])

    @cached_property
    def shared(self) -> list[Interval]:
        """The parts of the curve that lie on the other curve."""
        met = intersections(*self.curves)
        if met.undecided:
            raise ReachError(f"arcs in common: {met.undecided[0]}", remedy="take curves of lower degree")
        return joined((min(arc.first), max(arc.first)) for arc in met.everywhere)  # type: ignore[misc]  # real numbers

    def beyond(self, bound: mpq) -> Foot | None:
        """A point whose squared distance is above the bound; None where there is none."""
        for k, farthest in enumerate(self.halvings()):
            if farthest.squared > bound:
                return farthest
            if k == HALVINGS * sum(each.segments for each in self.curves):
                return next((foot for foot in self._samples(bound) if foot.squared > bound), None)
        return None

    def _samples(self, bound: mpq) -> Iterator[Foot]:
        """A point between any two neighbouring parameters at which the number of points at the distance may change, in
        the segments with undecided pieces.
        """
        for i in sorted({i for _, i, *_ in self.queue}):
            near = (self.forms(i, j) for j in range(self.curves[1].segments))
            places = (critical_places(forms.above(bound)) for forms in near if forms.excess(bound).sign != 1)
            for t in between_zeros(p for own in places for p in own):
                yield self._foot(self._side(i).at(t))


def _affine(a: mpq, b: mpq) -> fmpq_poly:
    """The map that carries −1 and 1 to two numbers."""
    return fmpq_poly([to_fmpq((a + b) / 2), to_fmpq((b - a) / 2)])


def _along(rows: Sequence[fmpz_poly], s: fmpq_poly, t: fmpq_poly) -> fmpq_poly:
    """A polynomial in two parameters, each of which is a polynomial in one variable."""
    return reduce(lambda value, row: value * t + fmpq_poly(row)(s), reversed(rows), fmpq_poly())


def _never_positive(p: fmpq_poly) -> bool:
    """Whether the coefficients show that a polynomial is not positive from −1 to 1: the sum of the constant term, the
    positive coefficients of even powers and the absolute values of the coefficients of odd powers is not positive.

    >>> _never_positive(fmpq_poly([-2, 1, 1])), _never_positive(fmpq_poly([-2, 3]))
    (True, False)
    """
    first, *rest = p.coeffs() or [fmpq(0)]
    return bool(first + sum((max(c, -c * (k % 2 == 0)) for k, c in enumerate(rest)), fmpq(0)) <= 0)


def critical_places(p: fmpz_mpoly) -> list[fmpz_poly]:
    """Square-free polynomials with the parameters s at which the number of zeros t of ``p(s, t)`` in [0, 1] may change:
    an end of the interval is a zero, or two zeros coincide.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> critical_places(T * T - S)
    [x, x + (-1), x]
    """
    slope = p.derivative(1)
    rows = rows_of(p / greatest_common_divisor([p, slope]) if slope else p)
    found = [at(p, 1, mpq(0)), at(p, 1, mpq(1)), *([discriminant(rows)] if len(rows) > 2 else [])]
    return [square_free(f) for f in found if f.degree() > 0]


def between_zeros(polynomials: Iterable[fmpz_poly]) -> Iterator[mpq]:
    """A rational number between any two neighbouring zeros of square-free polynomials in [0, 1], and one before the
    first and behind the last.

    >>> list(between_zeros([fmpz_poly([-1, 2])]))
    [mpq(1,4), mpq(3,4)]
    """
    zeros = (zero for p in polynomials for zero in roots_in(p, *UNIT.first, whole=True))
    return (between(*map(real, pair)) for pair in pairwise(distinct([*UNIT.first, *zeros])))


def deviation(first: Nurbs, second: Nurbs) -> Iterator[NamedNumbers]:
    """Bounds for the largest distance of a point of each of two curves from the other curve. The lower bound is the
    distance of the point `at` a parameter from the point at the `nearest` parameter; the upper bound is at most a
    hundredth larger. Both bounds are 0 if a curve is a part of the other curve.

    >>> from exactspline import Nurbs
    >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(-1, 1), (0, -1), (1, 1)])
    >>> for found in deviation(parabola, Nurbs(1, [0, 0, 1, 1], [(-1, 1), (1, 1)])):
    ...     print(found)
    <first from second: low 1, high 10099/10000, at 1/2, nearest 1/2>
    <second from first: low √3/2, high ...>

    Raises `ShapeError` for curves of different dimensions, and outside plane and space, and `ReachError` if it is not
    decided whether they have arcs in common.
    """
    for what, way in _ways(first, second):
        *_, farthest = way.halvings()
        high = square_root(farthest.near).rational_near(8) * RATIO
        yield NamedNumbers(what, _described("low", farthest, high=Real(high)))


def deviation_within(first: Nurbs, second: Nurbs, bound: mpq) -> Iterator[NamedNumbers]:
    """Whether all points of each of two curves are within a distance of the other curve; if not, a point that is
    farther away.

    >>> from exactspline import Nurbs
    >>> lines = [Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (1, 0)], [(0, 1), (2, 1)])]
    >>> [found.facts["holds"] for found in deviation_within(*lines, mpq(1))]
    ['yes', 'no']

    Raises `ShapeError` as `deviation` does, and for a negative distance; and `ReachError` where the decision takes too
    much work.
    """
    if bound < 0:
        raise ShapeError(f"within {text(bound)}", remedy="give a number that is not negative, such as 1/1000")
    for what, way in _ways(first, second, bound**2):
        with bounded():
            beyond = way.beyond(bound**2)
        values = {} if beyond is None else _described("distance", beyond)
        yield NamedNumbers(what, {"bound": Real(bound)} | values, {"holds": "no" if values else "yes"})


def _ways(first: Nurbs, second: Nurbs, bound: mpq | None = None) -> Iterator[tuple[str, _OneWay]]:
    yield "first from second", _OneWay(first, second, bound)
    yield "second from first", _OneWay(second, first, bound)


def _described(name: str, foot: Foot, **beside: Real) -> dict[str, Real]:
    return {name: square_root(foot.squared), **beside, "at": Real(foot.at), "nearest": foot.nearest}
