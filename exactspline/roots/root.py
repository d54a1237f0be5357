"""Certified roots: their place, multiplicity and signs, digits to any precision, and exact comparison."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import isnan, nan
from typing import Any, Protocol, cast

from flint import arb, ctx, fmpz_poly

from exactspline.errors import NumberError, ShapeError, shown
from exactspline.hooks import Displayed
from exactspline.numbers.exact import Rounding, mpq, mpz, rational, to_fmpq
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.numbers.once import cached_property, fill, setters
from exactspline.polynomials.bernstein import in_parameter
from exactspline.polynomials.elimination import ONE, X, linear, primitive, without_quadratic_zero
from exactspline.polynomials.isolation import LocalPolynomial, LocalZero, Zero
from exactspline.polynomials.zero_places import enclosures, sign_at
from exactspline.reals.algebraic import PRECISION
from exactspline.reals.real import UNASKED, RationalNumber, Real, zero_of

#: More bits than an interval certified in doubles has, so that a part of it has other ends, or is a small ball.
INSIDE = 72


class _LazyForm(Protocol):
    """A form on a segment, computed when first needed."""

    @property
    def form(self) -> LocalPolynomial:
        """The form, which is not zero at the ends."""

    @property
    def inner(self) -> list[LocalZero]:
        """The zeros of the form inside the segment, by exact arithmetic."""


class InDoubles:
    """A local parameter t of a segment in an interval of doubles: the only common point, or the only zero, there."""

    def __init__(self, interval: Sequence[float], near: Sequence[float] = (), side: Interval | None = None) -> None:
        #: A double near the parameter, the difference from it, a bound of the error of the difference, and the double
        #: nearest to the parameter on a segment over the interval `side`, if these are known.
        self.interval, self.near, self.side = interval, near, side

    @property
    def low(self) -> mpq:
        """The lower end of the interval, as for a `LocalZero`."""
        return mpq(self.interval[0])

    @property
    def high(self) -> mpq:
        """The upper end of the interval, as for a `LocalZero`."""
        return mpq(self.interval[1])

    def balls(self) -> Iterator[arb]:
        """Ever smaller balls around the parameter, at FLINT's current precision."""
        low, high = map(arb, self.interval)
        yield arb(self.near[0]) + arb(*self.near[1:3]) if self.near else low.union(high)

    def nearest(self, side: Interval | None, rounding: str) -> float:
        """The double nearest to the parameter on a segment over an interval, if it is known and asked for; else not a
        number.
        """
        return self.near[3] if self.near and side is self.side and rounding == Rounding.NEAREST else nan

    def part(self, bits: int) -> Interval | None:
        """A part of the interval, at most ``2^−bits`` wide, with the parameter strictly inside; None if balls do not
        decide it.
        """
        with ctx.workprec(PRECISION):
            for t in self.balls():
                if t.rad() < arb((1, -bits - 2)):
                    return ball_ends(t).grown(mpq(1, 1 << (bits + 2))).inside(Interval(self.low, self.high))
        return None


class LazyRoot(InDoubles):
    """A simple zero inside a segment, the only one in an interval of doubles, with the attributes of a `LocalZero`,
    which are computed when first needed. `number` is its number among the zeros of the form.
    """

    multiplicity = 1

    def __init__(
        self,
        form: _LazyForm,
        number: int,
        before: int,
        interval: Sequence[float],
        near: Sequence[float] = (),
        side: Interval | None = None,
    ) -> None:
        super().__init__(interval, near, side)
        self.form, self.number, self.before, self.signs = form, number, before, (before, -before)
        #: The smallest ball that is known.
        self._found: arb | None = None

    def balls(self) -> Iterator[arb]:
        """Ever smaller balls around the zero. From a ball X around ``z = t/(1 − t)`` with the midpoint m a step of the
        interval Newton method makes the ball ``N = m − f(m)/f′(X)``, which contains every zero in X. If N is inside X,
        there is exactly one zero, so that the first step proves again what was decided in doubles.

        Source: Neumaier, Interval Methods for Systems of Equations, 1990.
        """
        (t,) = super().balls()
        z = 1 / (1 - t) - 1 if self._found is None else self._found
        yield z / (1 + z)
        while z.contains_interior(found := self._closer(z)) and 2 * found.rad() < z.rad():
            self._found = z = found
            yield z / (1 + z)

    def _closer(self, ball: arb) -> arb:
        middle, form = ball.mid(), self.form.form
        rise = form.slope(ball)
        return middle - form.polynomial(middle) / rise if self.before * rise < 0 else arb.nan()

    @cached_property
    def ball(self) -> arb | None:
        """A small ball around ``z = t/(1 − t)`` for its local parameter t; None where balls do not shrink."""
        with ctx.workprec(PRECISION):
            return next((t / (1 - t) for t in self.balls() if t.rad() < arb((1, -INSIDE))), None)

    @cached_property
    def exactly(self) -> LocalZero:
        """The zero in exact arithmetic; a rational zero is the zero of its linear polynomial."""
        zero = self.form.inner[self.number]
        if zero.signs != self.signs:
            raise AssertionError(f"a change of sign {zero.signs} where {self.signs} was certain in doubles")
        if zero.low < zero.high:
            return zero
        p, q = int(zero.low.numerator), int(zero.low.denominator)
        return LocalZero(mpq(0), mpq(1), 1, zero.signs, LocalPolynomial(fmpz_poly([-p, q - p])), -1)

    @property
    def changing(self) -> tuple[LocalPolynomial, int]:
        """A polynomial that changes its sign at the zero, as for a `LocalZero`. This is the form itself, without a new
        isolation of the zero, if the form is linear or the zero is certainly irrational.
        """
        form = self.form.form
        whole = form.polynomial.degree() == 1 or form.without_rational_zero
        return (form, self.before) if whole else self.exactly.changing

    @property
    def factor(self) -> LocalPolynomial:
        """A factor of the form with this zero, as for a `LocalZero`."""
        return self.exactly.factor

    def __reduce__(self) -> tuple[object, ...]:
        return LocalZero, tuple(self.exactly)


class Root(Real, Displayed):
    """One zero of a spline: the parameter, which is an exact real number, and the place on the spline.

    Either `low` and `high` both equal the root, or the root is a simple zero of `polynomial` and the only root strictly
    between `low` and `high`. The interval shrinks when digits are needed, also for comparisons, and stays valid if the
    computation is interrupted; all other attributes are immutable.

    Roots, also of different splines, are compared exactly, by value, with each other and with exact numbers. Equal
    numbers have equal hashes. ``float(root)`` is the correctly rounded double.

    >>> from exactspline import BSpline, zeros
    >>> r, s = zeros(BSpline.bezier([1, "-1/2", "-2/3", 1], 0, 3))
    >>> r
    <Root 0.936908…: multiplicity 1, sign + to −>
    >>> r < s, r == s, 0 < r < 1, s.exact, float(r)
    (True, False, True, None, 0.936907552882186)
    """

    __slots__ = (
        "_initial",
        "_narrowest",
        "_polynomial",
        "_zero",
        "left_multiplicity",
        "right_multiplicity",
        "segment",
        "signs",
    )
    #: The current interval; a single tuple, so that threads never see ends of different intervals. None means the
    #: initial interval.
    _narrowest: Interval | None
    #: The initial interval; the spline may have other roots at its ends. None means the interval of a zero inside a
    #: segment.
    _initial: Interval | None
    _zero: Zero | None
    #: Computed on first use.
    _polynomial: fmpz_poly | None
    #: The multiplicities on the two sides, which can differ at a knot; None at an end of the domain.
    left_multiplicity: int | None
    right_multiplicity: int | None
    #: The signs of the spline just left and just right of the root; None at an end of the domain.
    signs: tuple[int | None, int | None]
    #: The segment that has the root strictly inside; None at a knot.
    segment: Interval | None

    def __init__(
        self,
        low: mpq,
        high: mpq,
        multiplicities: tuple[int | None, int | None],
        signs: tuple[int | None, int | None],
        zero: Zero | None = None,
        segment: Interval | None = None,
    ) -> None:
        first = Interval(rational(low), rational(high))
        if not (
            isinstance(multiplicities, tuple) and isinstance(signs, tuple) and len(multiplicities) == len(signs) == 2
        ):
            sides = f"{shown(multiplicities)} and {shown(signs)}"
            raise ShapeError(f"{sides} on the two sides of a root", remedy="exactspline.zeros finds roots")
        fill(
            self,
            _narrowest=None,
            _initial=first,
            _zero=zero,
            _polynomial=None,
            left_multiplicity=multiplicities[0],
            right_multiplicity=multiplicities[1],
            signs=signs,
            segment=segment,
            **UNASKED | {"_exact": first.low if first.low == first.high else None},
        )

    def __reduce__(self) -> tuple[object, ...]:
        multiplicities = self.left_multiplicity, self.right_multiplicity
        return _restored, (*self._first, multiplicities, self.signs, self._zero, self.segment, self._reached)

    # ---- what it is

    @property
    def _first(self) -> Interval:
        if self._initial is None:
            zero, segment = cast(Any, self._zero), cast(Any, self.segment)
            fill(self, _initial=segment.part(Interval(zero.low, zero.high)))
        return cast(Interval, self._initial)

    @property
    def _reached(self) -> Interval:
        return self._narrowest or self._first

    @property
    def _given(self) -> mpq | None:
        return self._first.low if self._first.low == self._first.high else None

    @property
    def low(self) -> mpq:
        """The lower end of the isolating interval."""
        return self._reached[0]

    @property
    def high(self) -> mpq:
        """The upper end of the isolating interval, which equals `low` if the root is known exactly."""
        return self._reached[1]

    @property
    def multiplicity(self) -> int:
        """The smaller of the multiplicities of the root on the two sides."""
        return min(m for m in (self.left_multiplicity, self.right_multiplicity) if m is not None)

    @property
    def sign_change(self) -> bool:
        """Whether the spline has opposite signs on the two sides of the root (False at an end of the domain)."""
        left, right = self.signs
        return left is not None and right is not None and left != right

    @property
    def at_knot(self) -> bool:
        """Whether the root is a breakpoint (or an end of the domain)."""
        return self.segment is None

    def _decided(self) -> mpq | None:
        if self._closed is False:
            return None
        if self._zero is not None and self.segment is not None and self._reached[0] < self._reached[1]:
            changing, _ = self._zero.changing
            if changing.polynomial.degree() == 1:
                c, d = changing.polynomial.coeffs()
                self._set_rational(self.segment.at(mpq(int(c), int(c - d))))
                return self.low
            if changing.without_rational_zero:
                return None
        # the denominator of a rational zero divides the leading coefficient: there is at most one such multiple
        denominator = abs(int(self._integers().leading_coefficient()))
        low, high = self._enclosed(denominator.bit_length() * 30103 // 100000 + 1)
        candidate = mpq(-((-low * denominator) // 1), denominator)
        return candidate if candidate <= high and self._against_number(candidate) == 0 else None

    def _found(self) -> Real | None:
        if self._exact is None and without_quadratic_zero(self.local_polynomial, X, ONE):
            return None
        if self.exact is not None:
            return RationalNumber(self.exact)
        p = self._integers()
        return zero_of(p, self) if p.degree() == 2 else super()._found()

    def _coefficient_bits(self) -> int:
        """A bound on the bits of the coefficients of a factor: no factor has a larger Mahler measure than the
        polynomial.
        """
        return self._measure() + 1

    def _height(self) -> int:
        """A bound on the height: the Mahler measure of the polynomial, divided by the least possible degree of the
        number.
        """
        return self._measure() // (3 if self.in_closed_form() is None else 1) + 1

    def _measure(self) -> int:
        """An upper bound of the base-2 logarithm of the Mahler measure of the polynomial."""
        p = self._integers()
        return p.height_bits() + (p.degree() + 1).bit_length() // 2 + 1

    def _integers(self) -> fmpz_poly:
        """The polynomial whose coefficients `polynomial` lists."""
        known = self._polynomial
        if known is None:
            known = self._computed_polynomial()
            fill(self, _polynomial=known)
        return known

    def _computed_polynomial(self) -> fmpz_poly:
        zero = self._zero
        if zero is None or self.segment is None or zero.low == zero.high:
            return linear(self._first[0])
        c = zero.factor.polynomial
        return primitive(in_parameter(c, c.degree(), self.segment)[0])

    @property
    def polynomial(self) -> list[int]:
        """The integer coefficients, constant term first, of a polynomial in the parameter of the spline that vanishes
        at this root.

        The polynomial is primitive with a positive leading coefficient, and the root is a simple root of it. For a root
        that is known exactly the polynomial is linear. Otherwise it is ``Σ c_i (b − t)ⁿ⁻ⁱ (t − a)ⁱ`` up to a constant,
        where [a, b] is the segment and the ``c_i`` are the integers of the form of the segment or of a square-free
        factor of the form.
        """
        return [int(x) for x in self._integers().coeffs()]

    def _annihilator(self) -> fmpz_poly:
        return self._integers()

    def _isolated(self) -> tuple[fmpz_poly, mpq, mpq]:
        low, high = self.refine(0)
        return (linear(low) if low == high else self._integers()), low, high

    # ---- where it is

    @property
    def ball(self) -> arb | None:
        """A small interval around ``z = t/(1 − t)``, where t is the local parameter of a root that was isolated in
        doubles; otherwise None.
        """
        return self._zero.ball if isinstance(self._zero, LazyRoot) else None

    @property
    def local_polynomial(self) -> fmpz_poly:
        """A polynomial with the zero ``z = t/(1 − t)``, where t is the local parameter of the root."""
        return cast(Zero, self._zero).changing[0].polynomial

    def refine(self, digits: int, progress: Callable[[int], None] | None = None) -> Interval:
        """Return an interval that contains the root and is at most ``10^−digits`` wide: ``low < root < high``, or ``low
        = high = root``.

        At the two ends the spline has the signs in `signs`: for a root of odd multiplicity, an independent proof of the
        root.

        The result of every step is stored: after an interrupt, `low` and `high` are the best interval so far, and the
        next call continues from this interval. `progress` is called after every step with the number of digits reached.
        """
        if type(digits) is not int:
            raise NumberError(f"{digits!r} digits", where="digits", remedy="an integer")
        if self._zero is None or self.segment is None:
            return self._reached
        scale = mpz(10) ** max(digits, 0)
        a, b = self.segment
        width = b - a
        bits = int(width * scale + 1).bit_length()
        lazy = self._zero if isinstance(self._zero, LazyRoot) and self._is_wide(scale) else None
        if lazy and (near := lazy.part(max(bits, INSIDE))):
            self.narrow_to(a + width * near.low, a + width * near.high)
            if progress is not None:
                progress(_digits(self.high - self.low, digits))
        while self._is_wide(scale):
            changing, before = self._zero.changing
            low, high = self._reached
            for u, v in enclosures(changing, (low - a) / width, (high - a) / width, before, bits):
                self.narrow_to(a + width * u, a + width * v)
                if progress is not None:
                    progress(_digits(width * (v - u), digits))
            bits = 2 * bits + 64
        return self._reached

    def _is_wide(self, scale: int) -> bool:
        """Whether the interval is longer than the reciprocal of a number, or shares an end with the initial
        interval.
        """
        low, high = self._reached
        return low < high and ((high - low) * scale > 1 or low == self._first[0] or high == self._first[1])

    def narrow_to(self, low: mpq, high: mpq) -> None:
        """Store an interval, unless another thread has stored a narrower interval."""
        if low == high:
            self._set_rational(low)
        elif high - low < self.high - self.low:
            fill(self, _narrowest=Interval(low, high))

    def _set_rational(self, value: mpq) -> None:
        fill(self, _exact=value, _narrowest=Interval.point(value))

    def _enclosed(self, digits: int) -> Interval:
        near = None if self._narrowest else self._at_hand()
        if near is not None and (ends := ball_ends(near)).width * mpz(10) ** max(digits, 0) <= 1:
            return ends
        return self.refine(digits)

    def _at_hand(self) -> arb | None:
        if (ball := self.ball) is None or self.segment is None:
            return None
        with ctx.workprec(PRECISION):
            return arb(to_fmpq(self.segment.low)) + arb(to_fmpq(self.segment.width)) * (ball / (1 + ball))

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """Return the correctly rounded double; this is faster for a root that was isolated in doubles."""
        known = self._zero.nearest(self.segment, rounding) if isinstance(self._zero, LazyRoot) else nan
        return super().double(rounding) if isnan(known) else known

    def __repr__(self) -> str:
        left, right = ({None: "end", 1: "+", -1: "−", 0: "0"}[s] for s in self.signs)
        sides = {m for m in (self.left_multiplicity, self.right_multiplicity) if m is not None}
        times = (
            f"multiplicity {self.multiplicity}"
            if len(sides) == 1
            else f"multiplicities {self.left_multiplicity} and {self.right_multiplicity}"
        )
        return f"<Root {self.shortly()}: {times}, sign {left} to {right}{', at a knot' if self.at_knot else ''}>"

    def moved(self, side: Interval) -> Root:
        """Return the number that has the same position in the interval `side` as this number has in [0, 1].

        >>> from exactspline import BSpline, zeros
        >>> (root,) = zeros(BSpline.bezier([-1, -1, 1]))  # 2t² − 1
        >>> root.moved(Interval(mpq(2), mpq(4))) == 2 * root + 2
        True
        """
        segment = None if self.segment is None else side.part(self.segment)
        times = self.left_multiplicity, self.right_multiplicity
        root = Root(side.at(self._first.low), side.at(self._first.high), times, self.signs, self._zero, segment)
        root.narrow_to(side.at(self.low), side.at(self.high))
        return root

    # ---- comparisons

    def _against_number(self, t: mpq) -> int:
        low, high = self._reached
        if low == high or self._zero is None or self.segment is None:
            return int(low > t) - int(low < t)
        if t <= low or t >= high:
            return 1 if t <= low else -1
        a, b = self.segment
        changing, before = self._zero.changing
        sign = sign_at(changing.polynomial, (t - a) / (b - a))
        if sign == 0:
            self._set_rational(t)
            return 0
        return 1 if sign == before else -1


def _restored(
    low: mpq, high: mpq, multiplicities: Any, signs: Any, zero: Zero | None, segment: Interval | None, reached: Interval
) -> Root:
    """The unpickled root, with its current interval."""
    root = Root(low, high, multiplicities, signs, zero, segment)
    root.narrow_to(*reached)
    return root


def _digits(width: mpq, most: int) -> int:
    """The number of decimal digits determined by an interval of this width, at most `most`."""
    if width == 0:
        return most
    return min(most, max(0, (int(1 / width).bit_length() - 1) * 30103 // 100000))


_set_zero, _set_segment, _set_signs, _set_left, _set_right = setters(
    Root, "_zero", "segment", "signs", "left_multiplicity", "right_multiplicity"
)
_unset = setters(Root, "_initial", "_narrowest", "_polynomial", *UNASKED)


def root_inside(zero: LazyRoot, segment: Interval) -> Root:
    """A zero that is isolated in doubles, on a segment over an interval, as a `Root`."""
    root = object.__new__(Root)
    _set_zero(root, zero)
    _set_segment(root, segment)
    _set_signs(root, zero.signs)
    _set_left(root, 1)
    _set_right(root, 1)
    for unset in _unset:
        unset(root, None)
    return root


def knot_root(t: mpq) -> Root:
    """A knot as a `Root`."""
    return Root(t, t, (1, 1), (0, 0))
