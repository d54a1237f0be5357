"""The place of an isolated zero of a form on its segment, and exact signs of other forms there.

Balls around the zero decide nearly every sign; what is open after `SUSPICIOUS` bits is decided by a greatest common
divisor.
"""

from __future__ import annotations

from flint import arb, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.numbers.exact import mpq, ratio, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval, sign_of_ball
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.isolation import Isolation, LocalPolynomial, LocalZero, Zero, end_signs
from exactspline.polynomials.refinement import enclosures, sign_at

#: The first precision (bits) of a place, and the one after which a value is suspected to be zero.
FIRST, SUSPICIOUS = 40, 200


class Place:
    """A parameter in [0, 1]: a rational number, or an isolated zero, whose interval shrinks when it is refined.

    >>> from exactspline.polynomials.isolation import isolate
    >>> (zero,) = isolate(fmpz_poly([1, 0, -2]), 2).inner  # z = v/u = √(1/2)
    >>> place = Place(zero)
    >>> place.sign(fmpz_poly([-1, 0, 2]), 2), place.sign(fmpz_poly([-5, 7]), 1)
    (0, -1)
    """

    __slots__ = ("_ball", "_irreducible", "bits", "interval", "zero")

    def __init__(self, zero: Zero) -> None:
        self.zero, self.interval, self.bits = zero, Interval(zero.low, zero.high), 0
        self._irreducible: fmpz_poly | None = None
        self._ball: tuple[int, arb] | None = None

    @property
    def exact(self) -> mpq | None:
        """The rational parameter if it is known to be rational."""
        low, high = self.interval
        return low if low == high else None

    @property
    def multiplicity(self) -> int:
        """The multiplicity of the zero."""
        return self.zero.multiplicity

    def refine(self, bits: int) -> Interval:
        """An interval that contains the parameter strictly inside, at most ``2^−bits`` wide; a point if it is
        rational and known.
        """
        low, high = self.interval
        if low != high and bits > self.bits:
            for interval in enclosures(self.zero.changing[0], low, high, self.zero.changing[1], bits):
                self.interval = interval
            self.bits = bits
        return self.interval

    def sign(self, c: fmpz_poly, n: int) -> int:
        """The exact sign of a form of degree n."""
        if not c:
            return 0
        bits = max(FIRST, self.bits)
        while True:
            low, high = self.refine(bits)
            if low == high:
                return sign_of(c[n]) if low == 1 else sign_at(c, low)
            with ctx.workprec(2 * bits):
                if sign := sign_of_ball(arb_poly(c)(self.z(bits))):
                    return sign
            if bits >= SUSPICIOUS and self._is_zero_of(c):
                return 0
            bits *= 2

    def z(self, bits: int) -> arb:
        """A ball around ``z = t/(1 − t)``, for a parameter below 1; FLINT's precision is the caller's."""
        low, high = self.refine(bits)
        if self._ball is None or self._ball[0] != bits:
            while high == 1:
                bits *= 2
                low, high = self.refine(bits)
            first, last = low / (1 - low), high / (1 - high)
            self._ball = bits, arb(to_fmpq(first)).union(arb(to_fmpq(last)))
        return self._ball[1]

    def _is_zero_of(self, c: fmpz_poly) -> bool:
        common = greatest_common_divisor([self.zero.factor.polynomial, c])
        if common.degree() < 1:
            return False
        before, behind = end_signs(common, *self.interval)
        return before != behind

    @property
    def rational(self) -> mpq | None:
        """The parameter if it is rational, else None."""
        if self.exact is None and not self.zero.factor.without_rational_zero:
            p = self.irreducible
            if p.degree() == 1:
                self.interval = Interval.point(ratio(p[0], p[0] - p[1]))
        return self.exact

    @property
    def irreducible(self) -> fmpz_poly:
        """The irreducible polynomial in ``z = t/(1 − t)`` with this zero, for an inner parameter.

        Raises `ReachError` if the factorization would take too long.
        """
        if self._irreducible is None:
            low, high = self.refine(FIRST)
            if low == high:
                z = to_fmpq(low / (1 - low))
                self._irreducible = fmpz_poly([-z.p, z.q])
            else:
                self._irreducible = next(
                    f for f in factorize(self.zero.factor.polynomial).bases if len(set(end_signs(f, low, high))) == 2
                )
        return self._irreducible

    def sign_of_element(self, x: fmpq_poly) -> int:
        """The sign of a polynomial in ``z = t/(1 − t)`` with rational coefficients, for a parameter below 1."""
        return self.sign(x.numer(), x.degree())


def places(isolation: Isolation) -> list[Place]:
    """The places of all zeros of a form, the ends of the segment included, in ascending order."""
    found = [Place(zero) for zero in isolation.inner]
    if isolation.at_left:
        found.insert(0, at(mpq(0), isolation.at_left))
    if isolation.at_right:
        found.append(at(mpq(1), isolation.at_right))
    return found


def at(t: mpq, multiplicity: int = 0) -> Place:
    """A rational parameter as a place, with its multiplicity as a zero where it is one.

    >>> at(mpq(1), 2).sign(fmpz_poly([1, -1]), 1)
    -1
    """
    return Place(LocalZero(t, t, multiplicity, (0, 0), LocalPolynomial(fmpz_poly([])), 0))
