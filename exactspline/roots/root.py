"""A certified root: where it is, how often, to any number of digits; compared exactly with other roots."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache, total_ordering
from typing import TYPE_CHECKING, Any

from flint import fmpz, fmpz_poly

from exactspline.errors import NumberError
from exactspline.exact import Number, double_between, lcm, mpq, mpz, rational, text, to_fmpq
from exactspline.language.immutable import Immutable, fill
from exactspline.language.services import Displayed
from exactspline.roots.isolation import LocalZero
from exactspline.roots.refinement import Interval, enclosures, sign_at
from exactspline.splines.bernstein import substituted

if TYPE_CHECKING:
    from mpmath import mpf

#: The types that a root is compared with, besides roots.
_EXACT = (int, Fraction, type(mpz()), type(mpq()))

#: How often two roots are compared with a number between them before digits are computed.
BISECTIONS = 5


@total_ordering
class Root(Immutable, Displayed):
    """One zero of a spline, in the spline's own parameter: a real number, known exactly.

    Either `low` = `high` is the root itself, or it is the only one strictly between them and `polynomial` has a simple
    zero there. The interval shrinks when digits are needed (also by comparisons) and stays valid when that is
    interrupted; nothing else of a root ever changes.

    Roots, also those of different splines, compare with one another and with exact numbers by value, exactly; equal
    ones, and the numbers they equal, have one hash. ``float(root)`` is the correctly rounded double.

    >>> from exactspline import BSpline, zeros
    >>> r, s = zeros(BSpline.bezier([1, "-1/2", "-2/3", 1], 0, 3))
    >>> r
    <Root 0.936908…: multiplicity 1, sign + to −>
    >>> r < s, r == s, 0 < r < 1, s.exact, float(r)
    (True, False, True, None, 0.936907552882186)
    """

    __slots__ = (
        "_first",
        "_minimal",
        "_polynomial",
        "_rational",
        "_reached",
        "_zero",
        "left_multiplicity",
        "right_multiplicity",
        "segment",
        "signs",
    )
    #: The interval reached, one tuple, so that threads see both ends of one interval.
    _reached: Interval
    #: The first interval: the spline may have other roots at its ends.
    _first: Interval
    _zero: LocalZero | None
    #: Fields computed when they are needed.
    _polynomial: fmpz_poly | None
    _minimal: fmpz_poly | None
    _rational: bool | None
    #: Multiplicity seen from either side: they can differ at a knot; None where the domain ends.
    left_multiplicity: int | None
    right_multiplicity: int | None
    #: Sign of the spline just left and just right of the root; None where the domain ends.
    signs: tuple[int | None, int | None]
    #: The segment (its ends) with the root strictly inside, None at a knot.
    segment: Interval | None

    def __init__(
        self,
        low: mpq,
        high: mpq,
        multiplicities: tuple[int | None, int | None],
        signs: tuple[int | None, int | None],
        zero: LocalZero | None = None,
        segment: Interval | None = None,
    ) -> None:
        fill(
            self,
            _reached=(low, high),
            _first=(low, high),
            _zero=zero,
            _polynomial=None,
            _minimal=None,
            _rational=None,
            left_multiplicity=multiplicities[0],
            right_multiplicity=multiplicities[1],
            signs=signs,
            segment=segment,
        )

    def __reduce__(self) -> tuple[object, ...]:
        multiplicities = self.left_multiplicity, self.right_multiplicity
        return _restored, (*self._first, multiplicities, self.signs, self._zero, self.segment, self._reached)

    # ---- what it is

    @property
    def low(self) -> mpq:
        """The lower end of the isolating interval."""
        return self._reached[0]

    @property
    def high(self) -> mpq:
        """The upper end of the isolating interval; equal to `low` when the root is known exactly."""
        return self._reached[1]

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
        """The root itself where it is rational, None where it is irrational: decided exactly, without factoring.

        The denominator of a rational root divides the leading coefficient a of `polynomial`: of the multiples of 1/a
        at most one is in an interval narrower than that.

        >>> from exactspline import BSpline, zeros
        >>> t = BSpline.identity(0, 1)
        >>> [r.exact for r in zeros((3 * t - 1) * (2 * t * t - 1))]
        [mpq(1,3), None]
        """
        if self._rational is None:
            fill(self, _rational=self._is_rational())
        return self.low if self._rational else None

    def _is_rational(self) -> bool:
        low, high = self._reached
        if low == high:
            return True
        if self._zero is not None and self._zero.factor.without_rational_zero:
            return False
        a = int(self._integers().leading_coefficient())
        low, high = self.refine(a.bit_length() * 30103 // 100000 + 1)
        if low < high:
            candidate = mpq((low * a) // 1 + 1, a)
            if candidate < high and self._against_number(candidate) == 0:
                return True
        return self.low == self.high

    def _integers(self) -> fmpz_poly:
        """The polynomial of `polynomial`."""
        known = self._polynomial
        if known is None:
            known = self._computed_polynomial()
            fill(self, _polynomial=known)
        return known

    def _computed_polynomial(self) -> fmpz_poly:
        zero = self._zero
        if zero is None or self.segment is None or zero.low == zero.high:
            return _linear(self._first[0])
        a, b = self.segment
        m = lcm(a.denominator, b.denominator)
        c = zero.factor.polynomial
        u, v = fmpz_poly([int(b * m), int(-m)]), fmpz_poly([int(-a * m), int(m)])
        p = substituted(c, c.degree(), u, v)
        return p // (p.content() if p.leading_coefficient() > 0 else -p.content())

    @property
    def polynomial(self) -> list[int]:
        """Integer coefficients, constant term first, of a polynomial in the spline's parameter with this root.

        Primitive, with positive leading coefficient; the root is a simple one of it. On the segment [a, b] it is ``Σ
        c_i (b − t)ⁿ⁻ⁱ (t − a)ⁱ`` up to a constant, where the ``c_i`` are the integers of the segment's form or of its
        square-free factor; for a root found exactly it is linear.
        """
        return [int(x) for x in self._integers().coeffs()]

    def minimal_polynomial(self) -> list[int]:
        """The irreducible integer polynomial with this root, constant term first.

        >>> from exactspline import BSpline, zeros
        >>> t = BSpline.identity(0, 1)
        >>> [r.minimal_polynomial() for r in zeros((t * t + t - 1) * (t - 2) * (3 * t - 1))]
        [[-1, 3], [-1, 1, 1]]
        """
        known = self._minimal
        if known is None:
            known = self._computed_minimal()
            fill(self, _minimal=known)
        return [int(x) for x in known.coeffs()]

    def _computed_minimal(self) -> fmpz_poly:
        low, high = self.refine(0)
        if low == high:
            return _linear(low)
        for p in _irreducible(*self._integers().coeffs()):
            if _changes_sign(p, low, high):
                if p.degree() == 1:
                    self._found(mpq(int(-p[0]), int(p[1])))
                return p if p.leading_coefficient() > 0 else -p
        raise AssertionError("a factor changes sign around every root")

    def is_root_of(self, polynomial: fmpz_poly) -> bool:
        """Whether a polynomial with integer coefficients vanishes here, exactly.

        >>> from exactspline import BSpline, zeros
        >>> root = zeros(BSpline.bezier([-1, -1, 1])).roots[0]  # 2t² = 1
        >>> root.is_root_of(fmpz_poly([0, -1, 0, 2])), root.is_root_of(fmpz_poly([-1, 1]))
        (True, False)
        """
        low, high = self.refine(0)
        if low == high:
            return _sign(polynomial, low) == 0
        # a divisor of `polynomial` has no other zero between low and high, nor at them, and this one once at most
        common = self._integers().gcd(polynomial)
        return common.degree() > 0 and _changes_sign(common, low, high)

    # ---- where it is

    def refine(self, digits: int, progress: Callable[[int], None] | None = None) -> Interval:
        """An interval with the root in it, at most ``10^−digits`` wide: ``low < root < high``, or ``low = high``, the
        root.

        The spline has its `signs` at the two ends, so that evaluating it there is a proof of its own (for a root of odd
        multiplicity).

        The work done is kept step by step: after an interrupt, `low` and `high` are the best reached, and the next call
        goes on from there. `progress` is called after every step with the number of digits reached.
        """
        if type(digits) is not int:
            raise NumberError(f"{digits!r} digits", where="digits", remedy="an integer")
        low, high = self._reached
        if self._zero is None or self.segment is None:
            return low, high
        scale = mpz(10) ** max(digits, 0)
        a, b = self.segment
        width = b - a
        bits = int(width * scale + 1).bit_length()
        while low < high and ((high - low) * scale > 1 or low == self._first[0] or high == self._first[1]):
            for u, v in enclosures(self._zero.factor, (low - a) / width, (high - a) / width, self._zero.sign, bits):
                low, high = a + width * u, a + width * v
                self._keep(low, high)
                if progress is not None:
                    progress(_digits(high - low, digits))
            bits = 2 * bits + 64
        return low, high

    def _keep(self, low: mpq, high: mpq) -> None:
        """Keep an interval, unless another thread was faster with a narrower one."""
        if high - low < self.high - self.low:
            fill(self, _reached=(low, high))

    def _found(self, value: mpq) -> None:
        fill(self, _reached=(value, value))

    def __float__(self) -> float:
        """The correctly rounded double: the nearest one, of two equally near the even one.

        Raises `OverflowError` beyond the largest.
        """
        return double_between(self.refine, self._against_number)

    def mpf(self, digits: int = 15) -> mpf:
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
        """That of the number where it is rational, otherwise that of ``⌊2⁶⁴ · root⌋``."""
        if (exact := self.exact) is not None:
            return hash(exact)
        digits = 20
        while True:
            low, high = (int((t * (1 << 64)) // 1) for t in self.refine(digits))
            if low == high:
                return hash((Root, low))
            digits *= 2

    def _against(self, other: Any) -> int:
        if not isinstance(other, Root):
            return self._against_number(mpq(other))
        if self is other:
            return 0
        if parted := self._parted(other):
            return parted
        (a, b), (c, d), digits = self._reached, other._reached, 10
        while True:
            if c == d:
                return self._against_number(c)
            if a == b:
                return -other._against_number(a)
            if b <= c or d <= a:
                return -1 if b <= c else 1
            if digits == 20 and self._same(other):
                return 0
            (a, b), (c, d), digits = self.refine(digits), other.refine(digits), 2 * digits

    def _parted(self, other: Root) -> int:
        """The order of two roots where a few signs at rational numbers between them decide it; 0 where they do not."""
        for _ in range(BISECTIONS):
            (a, b), (c, d) = self._reached, other._reached
            if a == b or c == d:
                return 0
            if b <= c or d <= a:
                return -1 if b <= c else 1
            middle = (max(a, c) + min(b, d)) / 2
            first, second = self._beside(middle), other._beside(middle)
            if first != second:
                return 1 if first > second else -1
        return 0

    def _beside(self, t: mpq) -> int:
        """The sign of the root minus a number, which then bounds it."""
        sign = self._against_number(t)
        low, high = self._reached
        if sign:
            self._keep(*((max(low, t), high) if sign > 0 else (low, min(high, t))))
        return sign

    def _against_number(self, t: mpq) -> int:
        low, high = self._reached
        if low == high or self._zero is None or self.segment is None:
            return int(low > t) - int(low < t)
        if t <= low or t >= high:
            return 1 if t <= low else -1
        a, b = self.segment
        sign = sign_at(self._zero.factor.polynomial, (t - a) / (b - a))
        if sign == 0:
            self._found(t)
            return 0
        return 1 if sign == self._zero.sign else -1

    def _same(self, other: Root) -> bool:
        """Whether two irrational roots agree: the common divisor changes sign at both, and once over both."""
        common = self._integers().gcd(other._integers())
        if common.degree() < 1:
            return False
        (a, b), (c, d) = self.refine(0), other.refine(0)
        if a == b or c == d or b <= c or d <= a:
            return False
        return (
            _changes_sign(common, a, b) and _changes_sign(common, c, d) and _changes_sign(common, min(a, c), max(b, d))
        )


def _restored(
    low: mpq,
    high: mpq,
    multiplicities: Any,
    signs: Any,
    zero: LocalZero | None,
    segment: Interval | None,
    reached: Interval,
) -> Root:
    """The unpickled root, as far as it was refined."""
    root = Root(low, high, multiplicities, signs, zero, segment)
    fill(root, _reached=reached)
    return root


def between(low: Number | Root, high: Number | Root) -> mpq:
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


@lru_cache(64)
def _irreducible(*coefficients: fmpz) -> tuple[fmpz_poly, ...]:
    """The irreducible factors of a polynomial, shared by many roots."""
    return tuple(p for p, _ in fmpz_poly(list(coefficients)).factor()[1])


def _linear(value: mpq) -> fmpz_poly:
    return fmpz_poly([int(-value.numerator), int(value.denominator)])


def _sign(p: fmpz_poly, t: mpq) -> int:
    at = p(to_fmpq(t))
    return int(at > 0) - int(at < 0)


def _changes_sign(p: fmpz_poly, low: mpq, high: mpq) -> bool:
    return _sign(p, low) * _sign(p, high) < 0


def _digits(width: mpq, most: int) -> int:
    """Decimal digits that an interval of this width determines, at most as many as asked for."""
    if width == 0:
        return most
    quotient = int(1 / width)
    return min(most, max(0, (quotient.bit_length() - 1) * 30103 // 100000))


def knot_root(t: mpq) -> Root:
    """A knot as a root."""
    return Root(t, t, (1, 1), (0, 0))
