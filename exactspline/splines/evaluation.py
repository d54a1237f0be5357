"""Points and derivatives of a curve at parameters: integer polynomials in the parameter, by Horner's rule over a common
denominator. Only the segments that contain the parameters are processed.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, repeat
from math import comb, gcd
from operator import mul

from exactspline.numbers.exact import mpq, over_one_denominator
from exactspline.polynomials.bernstein import Form, in_parameter, over_common_denominator
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

#: This many parameters are brought over a common denominator if it has at most this many bits; otherwise each parameter
#: is evaluated separately.
TOGETHER, BITS = 64, 256
#: The integer coefficients of numerators and denominator on one segment, the highest first.
Rows = list[list[int]]
#: The coefficients for numerators of the parameter; each row is given by its first number and the others.
Scaled = list[tuple[int, list[int]]]


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
    """A curve as quotients of integer polynomials in its parameter; the polynomials of a segment are made when first
    needed. All splines have the same knots and the same degree. Without a weight function the components are
    polynomials.
    """

    def __init__(self, p: Sequence[BSpline], w: BSpline | None) -> None:
        self.splines: Sequence[BSpline] = p if w is None else [*p, w]
        self.polynomial = w is None
        self._rows: dict[int, Rows] = {}
        #: The rows for parameters over the last denominator used.
        self._over: tuple[int, dict[int, Scaled]] = 1, {}
        self._slopes: dict[tuple[int, int], list[Rows]] = {}

    @property
    def mesh(self) -> Mesh:
        """The breakpoints of the curve."""
        return self.splines[0].mesh

    def points(self, ts: Sequence[mpq], *, left: bool = False) -> list[tuple[mpq, ...]]:
        """The points at exact parameters, at a breakpoint the limits from the right, or from the left.

        >>> half = BSpline.bezier([0, "1/2", 0])
        >>> Evaluation([half, half], None).points([mpq(1, 2), mpq(1, 3)])
        [(mpq(1,4), mpq(1,4)), (mpq(2,9), mpq(2,9))]

        Raises `DomainError` outside the domain.
        """
        found: list[tuple[mpq, ...]] = []
        for start in range(0, len(ts), TOGETHER):
            some = ts[start : start + TOGETHER]
            numerators, q = over_one_denominator(some)
            if q.bit_length() <= BITS:
                found += self._points(some, numerators, q, left)
            else:
                for t in some:
                    found += self._points([t], [int(t.numerator)], int(t.denominator), left)
        return found

    def _points(self, ts: Sequence[mpq], numerators: Sequence[int], q: int, left: bool) -> list[tuple[mpq, ...]]:
        """The points at parameters over the denominator q."""
        mesh, breaks, found = self.mesh, self.mesh.breaks, []
        over = self._over
        if over[0] != q:
            over = self._over = q, {}
        made, powers = over[1], [*accumulate(repeat(q, self.splines[0].degree), mul, initial=1)]
        here, rows, low, high = -1, Scaled(), breaks[0], breaks[0]
        for t, a in zip(ts, numerators, strict=True):
            if not low < t < high and (i := mesh.locate(t, left=left)) != here:
                here, low, high = i, breaks[i], breaks[i + 1]
                if i not in made:
                    made[i] = [(row[0], [*map(mul, row[1:], powers[1:])]) for row in self._rows_of(i)]
                rows = made[i]
            values = []
            for first, rest in rows:
                value = first
                for c in rest:
                    value = value * a + c
                values.append(value)
            below = values.pop()
            found.append(tuple([mpq(value, below) for value in values]))
        return found

    def jet(self, t: mpq, order: int, *, left: bool = False) -> list[tuple[mpq, ...]]:
        """The point and the derivatives to an order at an exact parameter, at a breakpoint from the right or the left.

        >>> t, square = BSpline.bezier([0, "1/2", 1]), BSpline.bezier([0, 0, 1])
        >>> Evaluation([t, square], None).jet(mpq(1, 2), 1)
        [(mpq(1,2), mpq(1,4)), (mpq(1,1), mpq(1,1))]

        Raises `DomainError` outside the domain.
        """
        *numerators, below = self.numbers(t, order, left=left)
        w = [*map(mpq, below)]
        return list(zip(*[quotient_derivatives([*map(mpq, row)], w) for row in numerators], strict=True))

    def numbers(self, t: mpq, order: int, *, left: bool = False) -> list[list[int]]:
        """The values and the derivatives to an order of the numerators and then of the denominator, as integers up to a
        common positive factor.

        >>> t, square = BSpline.bezier([0, "1/2", 1]), BSpline.bezier([0, 0, 1])
        >>> Evaluation([t, square], None).numbers(mpq(1, 2), 1)
        [[2, 4], [1, 4], [4, 0]]

        Raises `DomainError` outside the domain.
        """
        a, q = int(t.numerator), int(t.denominator)
        powers = [*accumulate(repeat(q, max(self.splines[0].degree, order)), mul, initial=1)]
        found = []
        for derivatives in self._slopes_of(self.mesh.locate(t, left=left), order):
            values = []
            for c, scale in zip(derivatives, powers, strict=False):
                value = 0
                for x, power in zip(c, powers, strict=False):
                    value = value * a + x * power
                # every derivative is a quotient by the same power of q
                values.append(value * scale)
            found.append(values)
        return found

    def _slopes_of(self, i: int, order: int) -> list[Rows]:
        """The coefficients of the derivatives to an order, for every numerator and the denominator on a segment."""
        key = i, order
        if key not in self._slopes:
            made = [[row] for row in self._rows_of(i)]
            for rows in made:
                for _ in range(order):
                    c = rows[-1]
                    rows.append([x * (len(c) - 1 - k) for k, x in enumerate(c[:-1])])
            self._slopes[key] = made
        return self._slopes[key]

    def _rows_of(self, i: int) -> Rows:
        rows = self._rows.get(i)
        if rows is None:
            rows = self._rows[i] = self._made(i)
        return rows

    def _made(self, i: int) -> Rows:
        n, ends = self.splines[0].degree, self.mesh.breaks[i : i + 2]
        forms: list[Form] = [(f.numerators[i], f.denominators[i]) for f in self.splines]
        polynomials, common = over_common_denominator(forms)
        parts = [in_parameter(c, n, ends) for c in polynomials]
        rows = [[int(c[k]) for k in range(n, -1, -1)] for c, _ in parts]
        if self.polynomial:
            rows.append([0] * n + [int(common * parts[0][1])])
        shared = gcd(*[x for row in rows for x in row])
        return [[x // shared for x in row] for row in rows]
