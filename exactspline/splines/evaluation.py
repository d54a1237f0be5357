"""Points and derivatives of a curve at parameters, as quotients of integers: only the control points around a parameter
are processed, by Horner's rule in the scaled Bernstein basis. Many points together are computed by the optional
extension in C (filter.c), as the same quotients; and so are doubles near the integers of the forms.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from functools import cache
from itertools import chain
from math import comb, gcd, isnan
from operator import mul, sub, truediv
from typing import TypeAlias, cast

from exactspline.numbers.exact import lcm, mpq, over_one_denominator
from exactspline.numbers.once import cached_property
from exactspline.splines.blossom import CommonRows, common_rows, packed_weights
from exactspline.splines.control_points import Direction, Point, lifted
from exactspline.splines.knots import KnotVector, mesh_of

#: The ends of a segment as integers over a positive integer, this integer, and for every numerator and the denominator
#: there the coefficients of its derivatives, the last first.
Segment = tuple[int, int, int, list[list[list[int]]]]
#: As many parameters are brought over one denominator. C computes at least this many points together, on a curve with
#: at most this number of control points for each.
TOGETHER, SEVERAL, PER_POINT = 256, 4, 16
#: In C: the bits of a limb, the most limbs of a number, the most bits of a parameter.
LIMB, LIMBS, PLACE = 64, 64, 62
#: The forms of this many segments are computed from control points over one denominator.
RUN = 512
#: Doubles near the integers of the forms of segments, each moved so that it begins at the origin, and the differences:
#: for each component, segment and coefficient, and then for the denominators of the segments (see filter.c).
Forms: TypeAlias = "tuple[array[float], array[float]]"
#: The first control point of each segment; the weights with which control points enter into the forms; the numbers of
#: all control points, component by component, and their denominator; the denominators of the weights; the bits of the
#: largest number.
_Run: TypeAlias = "tuple[list[int], bytes, list[int], int, list[int], int]"


def quotient_derivatives(above: Sequence[mpq], below: Sequence[mpq]) -> list[mpq]:
    """The derivatives of p/w from those of p and w: p = w · (p/w), differentiated by Leibniz's rule.

    >>> quotient_derivatives([mpq(1), mpq(0), mpq(0)], [mpq(1), mpq(1), mpq(0)])
    [mpq(1,1), mpq(-1,1), mpq(2,1)]
    """
    found: list[mpq] = []
    for k, value in enumerate(above):
        rest = value - sum((comb(k, j) * below[k - j] * earlier for j, earlier in enumerate(found)), mpq(0))
        found.append(rest / below[0])
    return found


class Evaluation:
    """A curve as quotients of integer polynomials on every segment, which are made when first needed; without weights
    the curve is polynomial.

    >>> line = Evaluation(KnotVector([0, 0, 1, 1]), 1, [(mpq(0), mpq(1)), (mpq(4), mpq(2))], None)
    >>> line.points([mpq(1, 2), mpq(1, 4)]), line.jet(mpq(1, 2), 1)
    ([(mpq(2,1), mpq(3,2)), (mpq(1,1), mpq(5,4))], [(mpq(2,1), mpq(3,2)), (mpq(4,1), mpq(1,1))])
    """

    def __init__(self, knots: KnotVector, degree: int, points: Sequence[Point], weights: Sequence[mpq] | None) -> None:
        self.knots, self.degree, self.control_points, self.weights = knots, degree, points, weights
        self.mesh, _, self.spans = mesh_of(knots, degree)
        self._segments: dict[tuple[int, int], Segment] = {}
        self._size = len(points[0]) + (weights is not None)
        self._kept: tuple[tuple[int, int], _Run] | None = None

    def points(self, ts: Sequence[mpq], *, left: bool = False) -> list[tuple[mpq, ...]]:
        """The points at exact parameters, at a breakpoint the limits from the right, or from the left.

        Raises `DomainError` outside the domain.
        """
        found: list[tuple[mpq, ...]] = []
        for start in range(0, len(ts), TOGETHER):
            *numerators, below = self._quotients(ts[start : start + TOGETHER], left)
            found += zip(*[map(mpq, row, below) for row in numerators], strict=True)
        return found

    def doubles(self, ts: Sequence[float | mpq], *, left: bool = False) -> list[tuple[float, ...]]:
        """The doubles nearest to the coordinates of the points at parameters, of which doubles mean their exact values.

        >>> Evaluation(KnotVector([0, 0, 1, 1]), 1, [(mpq(0), mpq(1)), (mpq(4), mpq(2))], None).doubles([0.1, 1])
        [(0.4, 1.1), (4.0, 2.0)]

        Raises the errors of `points`, `ValueError` for NaN, `OverflowError` for infinities and coordinates beyond the
        largest double.
        """
        found: list[tuple[float, ...]] = []
        for start in range(0, len(ts), TOGETHER):
            ratios = [cast(float, t).as_integer_ratio() for t in ts[start : start + TOGETHER]]
            q = int(lcm(*{d for _, d in ratios}))
            found += zip(*self._nearest([int(a * (q // d)) for a, d in ratios], q, left), strict=True)
        return found

    def _quotients(self, ts: Sequence[mpq], left: bool) -> list[Sequence[int]]:
        """The numerators of each coordinate of the points at parameters, and their denominators."""
        made, count = self._together(_in_c("curve_points"), *over_one_denominator(ts), left, near=False), len(ts)
        if made is None:
            return [*zip(*[[x for x, *_ in self.numbers(t, 0, left=left)] for t in ts], strict=True)]
        numbers = _decoded(*made[:2])
        return [numbers[k : k + count] for k in range(0, len(numbers), count)]

    def _nearest(self, places: Sequence[int], q: int, left: bool) -> list[Sequence[float]]:
        """The doubles nearest to each coordinate of these points."""
        made, count = self._together(_in_c("curve_points"), places, q, left, near=True), len(places)
        if made is None:
            *numerators, below = self._quotients([mpq(a, q) for a in places], left)
            return [[(x if w > 0 else -x) / abs(w) for x, w in zip(row, below, strict=True)] for row in numerators]
        found, width, near = made
        for k in [k for k, x in enumerate(near) if isnan(x)]:
            top, bottom = (found[i * width : (i + 1) * width] for i in (k, len(near) + k % count))
            near[k] = truediv(*_decoded(top + bottom, width))
        return [near[k : k + count] for k in range(0, len(near), count)]

    def jet(self, t: mpq, order: int, *, left: bool = False) -> list[tuple[mpq, ...]]:
        """The point and the derivatives to an order at an exact parameter, at a breakpoint from the right or the left.

        Raises `DomainError` outside the domain.
        """
        *numerators, below = self.numbers(t, order, left=left)
        w = [*map(mpq, below)]
        return list(zip(*[quotient_derivatives([*map(mpq, row)], w) for row in numerators], strict=True))

    def numbers(self, t: mpq, order: int, *, left: bool = False) -> list[list[int]]:
        """The values and the derivatives to an order of the numerators and then of the denominator, as integers up to a
        common positive factor.

        >>> square = [(mpq(0), mpq(0)), (mpq(1, 2), mpq(0)), (mpq(1), mpq(1))]
        >>> Evaluation(KnotVector([0, 0, 0, 1, 1, 1]), 2, square, None).numbers(mpq(1, 2), 1)
        [[2, 4], [1, 4], [4, 0]]

        Raises `DomainError` outside the domain.
        """
        low, high, unit, slopes = self._on(self.mesh.locate(t, left=left), order)
        a, q = int(t.numerator), int(t.denominator)
        u, v, scale = high * q - a * unit, a * unit - low * q, unit * q
        powers = [u**k for k in range(1, self.degree + 1)]
        return [[_by_horner(row, powers, v) * scale**k for k, row in enumerate(rows)] for rows in slopes]

    def _on(self, i: int, order: int) -> Segment:
        """A segment, with the derivatives to an order: those of the form ∂v − ∂u."""
        key = i, order
        if key not in self._segments:
            n, slopes, (rows, below) = self.degree, list[list[list[int]]](), self.rows[i]
            if self.weights is None:
                rows = [*rows, [below * comb(n, k) for k in range(n + 1)]]
            shared = gcd(*[x for row in rows for x in row])
            for row in rows:
                slopes.append([[x // shared for x in reversed(row)]])
                for degree in range(n, n - order, -1):
                    c = slopes[-1][-1]
                    slopes[-1].append([(degree - k) * c[k] - (k + 1) * c[k + 1] for k in range(degree)] or [0])
            (low, high), unit = over_one_denominator(self.mesh.breaks[i : i + 2])
            self._segments[key] = low, high, unit, slopes
        return self._segments[key]

    @property
    def columns(self) -> list[tuple[mpq, ...]]:
        """The control points of the numerators and, with weights, of the denominator."""
        points, weights = self.control_points, self.weights
        rows = points if weights is None else [(*lifted(x, w), w) for x, w in zip(points, weights, strict=True)]
        return list(zip(*rows, strict=True))

    @cached_property
    def rows(self) -> list[CommonRows]:
        """The integers of the forms on every segment: of the numerators and, with weights, of the denominator."""
        return common_rows(self.knots.knots, self.degree, self.columns, self.spans)

    def _over_one(self, first: int, last: int) -> tuple[list[int], int]:
        """The integers of all components of some control points, one component after the other, and their denominator.

        >>> line = Evaluation(KnotVector([0, 0, 1, 1]), 1, [(mpq(0), mpq(1, 2)), (mpq(4), mpq(2))], [mpq(3), mpq(1)])
        >>> line._over_one(0, 2)
        ([0, 8, 3, 4, 6, 2], 2)
        """
        points, count = self.control_points[first:last], len(self.control_points[0])
        numbers, below = over_one_denominator([x for point in points for x in point])
        columns = [numbers[k::count] for k in range(count)]
        if self.weights is not None:
            weights, unit = over_one_denominator(self.weights[first:last])
            factors = [unit if type(point) is Direction else w for point, w in zip(points, weights, strict=True)]
            columns = [*[[*map(mul, column, factors)] for column in columns], [w * below for w in weights]]
            below *= unit
        return [*chain.from_iterable(columns)], below

    # ---- in C

    def forms(self, first: int, stop: int) -> Forms | None:
        """The integers of the forms on some segments in doubles; None without the extension, and for numbers that are
        too large for it.
        """
        n, rational, count = self.degree, self.weights is not None, stop - first
        near, function = array("d", bytes(8 * self._size * (n + 1) * count + 8 * count)), _in_c("curve_forms", _is_near)
        rest = array("d", near)
        for start in range(0, count, RUN):
            ends = first + start, min(first + start + RUN, stop)
            firsts, weights, numbers, unit, below, bits = self._for_c(*ends) or self._of_rows(*ends)
            limbs = (bits + bits * rational + 1) // LIMB + 1
            if function is None or limbs > LIMBS:
                return None
            points = _encoded([*numbers, *(unit * x for x in below)], limbs)
            sizes = n, self._size, limbs, len(numbers) // self._size, len(firsts), rational, count, *firsts, start
            function(array("q", sizes).tobytes(), weights, points, near.buffer_info()[0], rest.buffer_info()[0])
        return near, rest

    def _for_c(self, first: int, stop: int) -> _Run | None:
        """What C is given for some segments, the last of which are kept; None if there are no weights."""
        if self._kept is None or self._kept[0] != (first, stop):
            n, spans = self.degree, self.spans[first:stop]
            low, high, firsts = spans[0] - n, spans[-1] + 1, [j - spans[0] for j in spans]
            weights, below = packed_weights(self.knots.knots[low : high + n + 1], n, [j + n for j in firsts])
            if not weights:
                return None
            numbers, unit = self._over_one(low, high)
            bits = max(unit, *map(abs, numbers)).bit_length() + max(below).bit_length() + n
            self._kept = (first, stop), (firsts, weights, numbers, unit, below, bits)
        return self._kept[1]

    def _of_rows(self, first: int, stop: int) -> _Run:
        """The same, from integers of forms as if they were control points."""
        rows, width = self.rows[first:stop], self.degree + 1
        weights = array("Q", [i == j for i in range(width) for j in range(width)]).tobytes() * len(rows)
        numbers = [*chain.from_iterable(chain.from_iterable(zip(*[own for own, _ in rows], strict=True)))]
        below = [m for _, m in rows]
        bits = max(*below, *map(abs, numbers)).bit_length() + self.degree
        return [*range(0, width * len(rows), width)], weights, numbers, 1, below, bits

    @cached_property
    def _breaks(self) -> tuple[list[int], int]:
        """The breakpoints over an integer, and this integer."""
        return over_one_denominator(self.mesh.breaks)

    def _together(
        self, function: Callable[..., int] | None, places: Sequence[int], q: int, left: bool, *, near: bool
    ) -> tuple[bytes, int, list[float]] | None:
        """The numerators and the denominators of points, the bytes that one takes, and the doubles nearest to the
        quotients, NaN where they are not certain; None where C cannot compute them.
        """
        count, at, n, segments = len(self.control_points), len(places), self.degree, len(self.spans)
        if function is None or at < SEVERAL or count > PER_POINT * at or q.bit_length() > PLACE:
            return None
        run, (breaks, unit) = self._for_c(0, segments), self._breaks
        if run is None:
            return None
        _, weights, numbers, below, _, bits = run
        numbers = numbers + [below] * (count if self.weights is None else 0)
        common, components = int(lcm(unit, q)), len(numbers) // count
        breaks = [x * (common // unit) for x in breaks]
        places = places if common == q else [x * (common // q) for x in places]
        limbs = (bits + n * max(map(sub, breaks[1:], breaks)).bit_length()) // LIMB + 1
        inside = breaks[0] <= min(places) <= max(places) <= breaks[-1] < 1 << PLACE and breaks[0] > -1 << PLACE
        if not inside or limbs > LIMBS:
            return None
        sizes = n, components, limbs, count, segments, left, at, *[j - n for j in self.spans], *breaks, *places
        given, doubles, width = array("q", sizes), array("d", bytes(8 * (components - 1) * at)), 8 * limbs
        found = array("q", bytes(width * (components * (at + n + 1) + 1)))
        room = doubles.buffer_info()[0] if near else None
        function(given.buffer_info()[0], weights, _encoded(numbers, limbs), found.buffer_info()[0], room)
        return found[: components * at * limbs].tobytes(), width, doubles.tolist()


def _by_horner(row: Sequence[int], powers: Sequence[int], v: int) -> int:
    """The value of a form at u and v, from its coefficients, the last first, and the powers of u."""
    value = row[0]
    for c, power in zip(row[1:], powers, strict=False):
        value = value * v + c * power
    return value


def _encoded(numbers: Sequence[int], limbs: int) -> bytes:
    """The numbers for C."""
    if limbs == 1:
        return array("q", numbers).tobytes()
    return b"".join([x.to_bytes(LIMB // 8 * limbs, "little", signed=True) for x in numbers])


def _decoded(numbers: bytes, width: int) -> list[int]:
    """The numbers, each of which takes some bytes."""
    if width == LIMB // 8:
        return array("q", numbers).tolist()
    return [int.from_bytes(numbers[k : k + width], "little", signed=True) for k in range(0, len(numbers), width)]


def _is_right(function: Callable[..., int]) -> bool:
    """Whether C finds large numbers, quotients on either side of 0, and that one is between two doubles."""
    line = Evaluation(KnotVector([0, 0, 1, 1]), 1, [(mpq(-(2**70)),), (mpq(2**53 + 1),)], [mpq(3), mpq(2)])
    numbers, below = [-3 * 2**71, 2**54 - 3 * 2**70 + 2, 2**55 + 4, 2**55 + 4], [6, 5, 4, 4]
    found = line._together(function, [0, 1, 2, 2], 2, left=False, near=True)
    if found is None or _decoded(*found[:2]) != numbers + below:
        return False
    return found[2][:2] == [-(2**70), numbers[1] / 5] and all(map(isnan, found[2][2:]))


def _is_near(function: Callable[..., int]) -> bool:
    """Whether C finds the first bits of large numbers and of differences."""
    near, rest = array("d", bytes(40)), array("d", bytes(40))
    given, rooms = array("q", (1, 2, 3, 2, 1, 1, 1, 0, 0)), [x.buffer_info()[0] for x in (near, rest)]
    numbers = _encoded([2**70, 5, -3, 2**53 + 1, 7], 3)
    found = function(given.tobytes(), array("Q", (1, 0, 0, 1)).tobytes(), numbers, *rooms)
    known = [0, -(2**119), 9 / 16, -3 * 2**49, -21 / 16], [0, -(2**66), 0, -3 / 16, 0]
    return found == 1 and ([*near], [*rest]) == known


@cache
def _in_c(name: str, right: Callable[[Callable[..., int]], bool] = _is_right) -> Callable[..., int] | None:
    """A function of the extension, if it is right for a curve with large and small numbers."""
    from ctypes import c_void_p

    from exactspline.numbers.extension import loaded

    return loaded(name, right, *[c_void_p] * 5)
