"""A certified root: where it is, how often, to any number of digits; compared exactly with other roots."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cached_property, total_ordering
from typing import Any

from flint import fmpz_poly
from gmpy2 import lcm, mpq, mpz

from exactspline.errors import NumberError
from exactspline.exact import rational, text, to_fmpq
from exactspline.language.services import Displayed
from exactspline.roots.isolation import LocalZero
from exactspline.roots.refinement import enclosures, sign_at
from exactspline.splines.bernstein import substituted

#: What a root is compared with, besides roots.
_EXACT = (int, Fraction, type(mpz()), type(mpq()))


@total_ordering
class Root(Displayed):
    """One zero of a spline, in the spline's own parameter.

    Either `low` = `high` is the root itself, or it is the only one strictly between them and `polynomial` has a simple
    zero there. The interval shrinks when digits are asked for (also by comparisons), and keeps what was reached when
    that is interrupted.

    Roots, also those of different splines, compare with one another and with exact numbers by value, exactly.

    >>> from exactspline import BSpline
    >>> from exactspline.roots.zero_set import zeros
    >>> r, s = zeros(BSpline.bezier([1, "-1/2", "-2/3", 1], 0, 3))
    >>> r
    <Root 0.936908…: multiplicity 1, sign + to −>
    >>> r < s, r == s, 0 < r < 1, s.exact
    (True, False, True, None)
    """

    def __init__(
        self,
        low: mpq,
        high: mpq,
        multiplicities: tuple[int | None, int | None],
        signs: tuple[int | None, int | None],
        zero: LocalZero | None = None,
        segment: tuple[mpq, mpq] | None = None,
    ) -> None:
        #: Ends of the isolating interval; equal when the root is known exactly.
        self.low, self.high = low, high
        #: The first interval: the spline may have other roots at its ends.
        self._first = low, high
        #: Multiplicity seen from either side: they can differ at a knot; None where the domain ends.
        self.left_multiplicity, self.right_multiplicity = multiplicities
        #: Sign of the spline just left and just right of the root; None where the domain ends.
        self.signs = signs
        #: The segment (its ends) with the root strictly inside, None at a knot.
        self.segment = segment
        self._zero = zero

    # ---- what it is

    @property
    def multiplicity(self) -> int:
        """The smaller of the multiplicities seen from the two sides."""
        return min(m for m in (self.left_multiplicity, self.right_multiplicity) if m is not None)

    @property
    def sign_change(self) -> bool:
        """Whether the spline has opposite signs on the two sides (not so at an end of the domain)."""
        left, right = self.signs
        return left is not None and right is not None and left != right

    @property
    def at_knot(self) -> bool:
        """Whether the root is a breakpoint (an end of the domain included)."""
        return self.segment is None

    @property
    def exact(self) -> mpq | None:
        """The root itself where it is known to be rational (`minimal_polynomial` finds out), else None."""
        return self.low if self.low == self.high else None

    @cached_property
    def _polynomial(self) -> fmpz_poly:
        if self._zero is None or self.segment is None or self._zero.low == self._zero.high:
            return fmpz_poly([int(-self.low.numerator), int(self.low.denominator)])
        a, b = self.segment
        m = lcm(a.denominator, b.denominator)
        c = self._zero.factor.polynomial
        u, v = fmpz_poly([int(b * m), int(-m)]), fmpz_poly([int(-a * m), int(m)])
        p = substituted(c, c.degree(), u, v)
        return p // (p.content() if p.leading_coefficient() > 0 else -p.content())

    @property
    def polynomial(self) -> list[int]:
        """Integer coefficients, constant term first, of a polynomial in the spline's parameter with this root.

        Primitive, with positive leading coefficient; the root is a simple one of it. On the segment [a, b] it is ``Σ
        c_i (b − t)ⁿ⁻ⁱ (t − a)ⁱ`` up to a constant, where the ``c_i`` are the integers of the segment's form or of its
        square-free factor; for an exact root it is linear.
        """
        return [int(x) for x in self._polynomial.coeffs()]

    @cached_property
    def _minimal(self) -> fmpz_poly:
        self.refine(0)
        if self.low == self.high:
            return fmpz_poly([int(-self.low.numerator), int(self.low.denominator)])
        for p, _ in self._polynomial.factor()[1]:
            if _changes_sign(p, self.low, self.high):
                if p.degree() == 1:
                    self.low = self.high = mpq(int(-p[0]), int(p[1]))
                return p if p.leading_coefficient() > 0 else -p
        raise AssertionError("a factor changes sign around every root")

    def minimal_polynomial(self) -> list[int]:
        """The irreducible one among the integer polynomials with this root, constant term first; a rational root
        becomes `exact`.

        >>> from exactspline import BSpline
        >>> from exactspline.roots.zero_set import zeros
        >>> t = BSpline.identity(0, 1)
        >>> [r.minimal_polynomial() for r in zeros((t * t + t - 1) * (t - 2) * (3 * t - 1))]
        [[-1, 3], [-1, 1, 1]]
        """
        return [int(x) for x in self._minimal.coeffs()]

    # ---- where it is

    def refine(self, digits: int, progress: Callable[[int], None] | None = None) -> tuple[mpq, mpq]:
        """An interval with the root in it, at most ``10^−digits`` wide: ``low < root < high``, or ``low = high``, the
        root.

        The spline has its `signs` at the two ends, so that evaluating it there is a proof of its own (for a root of odd
        multiplicity).

        The work done is kept step by step: after an interrupt, `low` and `high` are the best reached, and the next call
        goes on from there. `progress` is called after every step with the number of digits reached.
        """
        if type(digits) is not int:
            raise NumberError(f"{digits!r} digits", where="digits", remedy="an integer")
        if self._zero is None or self.segment is None:
            return self.low, self.high
        scale = mpz(10) ** max(digits, 0)
        a, b = self.segment
        width = b - a
        bits = int(width * scale + 1).bit_length()
        while self.low < self.high and (
            (self.high - self.low) * scale > 1 or self.low == self._first[0] or self.high == self._first[1]
        ):
            for low, high in enclosures(
                self._zero.factor, (self.low - a) / width, (self.high - a) / width, self._zero.sign, bits
            ):
                self.low, self.high = a + width * low, a + width * high
                if progress is not None:
                    progress(_digits(self.high - self.low, digits))
            bits = 2 * bits + 64
        return self.low, self.high

    def mpf(self, digits: int = 15) -> Any:
        """The root as an ``mpmath.mpf`` that is off by at most ``10^−digits``; mpmath's own precision is not
        touched.
        """
        from mpmath import mp
        from mpmath.libmp import from_rational

        low, high = self.refine(digits + 1)
        middle = (low + high) / 2
        size = int(abs(middle)).bit_length()
        return mp.make_mpf(
            from_rational(
                int(middle.numerator), int(middle.denominator), size + (10 ** max(digits, 0)).bit_length() + 4
            )
        )

    def __repr__(self) -> str:
        from mpmath import nstr

        digits = 20
        while (
            self.low < self.high
            and digits < 400
            and (self.high - self.low) * 10**8 > min(abs(self.low), abs(self.high))
        ):
            self.refine(digits)
            digits *= 2
        where = text(self.low) if self.low == self.high else f"{nstr(self.mpf(digits), 6)}…"
        left, right = ({None: "end", 1: "+", -1: "−", 0: "0"}[s] for s in self.signs)
        sides = {m for m in (self.left_multiplicity, self.right_multiplicity) if m is not None}
        times = (
            f"multiplicity {self.multiplicity}"
            if len(sides) == 1
            else f"multiplicities {self.left_multiplicity} and {self.right_multiplicity}"
        )
        return f"<Root {where}: {times}, sign {left} to {right}{', at a knot' if self.at_knot else ''}>"

    # ---- comparisons

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Root, *_EXACT)):
            return NotImplemented
        return self._against(other) == 0

    def __lt__(self, other: object) -> bool:
        if not isinstance(other, (Root, *_EXACT)):
            return NotImplemented
        return self._against(other) < 0

    def __hash__(self) -> int:
        minimal = self._minimal
        return hash(self.exact) if minimal.degree() == 1 else hash(tuple(map(int, minimal.coeffs())))

    def _against(self, other: Any) -> int:
        if not isinstance(other, Root):
            return self._against_number(rational(other))
        if self is other:
            return 0
        if other.low == other.high:
            return self._against_number(other.low)
        if self.low == self.high:
            return -other._against_number(self.low)
        digits = 10
        while self._overlaps(other):
            self.refine(digits)
            other.refine(digits)
            if self.low == self.high or other.low == other.high:
                return self._against(other)
            if digits == 10 and self._overlaps(other) and self._same(other):
                return 0
            digits *= 2
        return -1 if self.low < other.low else 1

    def _overlaps(self, other: Root) -> bool:
        return bool(self.low < other.high and other.low < self.high)

    def _against_number(self, t: mpq) -> int:
        if self.low == self.high or self._zero is None or self.segment is None:
            return int(self.low > t) - int(self.low < t)
        if t <= self.low or t >= self.high:
            return 1 if t <= self.low else -1
        a, b = self.segment
        sign = sign_at(self._zero.factor.polynomial, (t - a) / (b - a))
        if sign == 0:
            self.low = self.high = t
            return 0
        return 1 if sign == self._zero.sign else -1

    def _same(self, other: Root) -> bool:
        """Whether two roots in overlapping intervals agree: the common divisor changes sign at both, and once over
        both.
        """
        common = self._polynomial.gcd(other._polynomial)
        if common.degree() < 1:
            return False
        self.refine(0)
        other.refine(0)
        if self.low == self.high or other.low == other.high or not self._overlaps(other):
            return False
        return (
            _changes_sign(common, self.low, self.high)
            and _changes_sign(common, other.low, other.high)
            and _changes_sign(common, min(self.low, other.low), max(self.high, other.high))
        )


def between(low: Any, high: Any) -> mpq:
    """A rational number strictly between two roots or exact numbers ``low < high``: a dyadic one of few digits.

    >>> from exactspline import BSpline
    >>> from exactspline.roots.zero_set import zeros
    >>> between(0, zeros(BSpline.bezier([-1, -1, 1])).roots[0])
    mpq(1,2)
    """
    digits = 1
    while True:
        a = low.refine(digits)[1] if isinstance(low, Root) else rational(low)
        b = high.refine(digits)[0] if isinstance(high, Root) else rational(high)
        if a < b:
            break
        digits *= 2
    scale = 1
    while (found := mpq(int(a * scale // 1) + 1, scale)) >= b:
        scale *= 2
    return found


def _sign(p: fmpz_poly, t: mpq) -> int:
    at = p(to_fmpq(t))
    return int(at > 0) - int(at < 0)


def _changes_sign(p: fmpz_poly, low: mpq, high: mpq) -> bool:
    return _sign(p, low) * _sign(p, high) < 0


def _digits(width: mpq, most: int) -> int:
    """Decimal digits that an interval of this width fixes, not more than asked for."""
    if width == 0:
        return most
    quotient = int(1 / width)
    return min(most, max(0, (quotient.bit_length() - 1) * 30103 // 100000))


def knot_root(t: mpq) -> Root:
    """A knot as a root."""
    return Root(t, t, (1, 1), (0, 0))
