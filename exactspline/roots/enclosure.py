"""Values at roots: splines and quotients of splines enclosed to any number of digits, their signs exactly.

The interval of a root bounds the values there (`centred_form`), the narrower the nearer: the root is refined until the
digits asked for are certain. A sign that the bounds leave open is decided by a common divisor.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile
from typing import TYPE_CHECKING, NamedTuple

from flint import fmpz_poly

from exactspline.exact import Number, double, isqrt, lcm, mpq, mpz, rational
from exactspline.language.choices import Side
from exactspline.language.immutable import Immutable, fill
from exactspline.roots.centred_form import bounds_over
from exactspline.roots.root import Root
from exactspline.splines.bernstein import substituted

if TYPE_CHECKING:
    from exactspline.splines.bspline import BSpline
    from exactspline.splines.nurbs import Nurbs


class Bounds(NamedTuple):
    """Rational bounds of a quantity, itself between them or one of them."""

    low: mpq
    high: mpq


class Enclosure(Immutable):
    """A real number between two rational ones, `low` and `high`; it can be printed to any number of digits.

    >>> from exactspline import BSpline, zeros
    >>> half, = value_at((BSpline.bezier([0, 0, 1]),), None, zeros(BSpline.bezier([-1, -1, 1])).roots[0], digits=30)
    >>> half, str(half), half.high - half.low <= mpq(1, 10**30)
    (<Enclosure 0.5…>, '0.500000000000000000000000000000', True)
    """

    __slots__ = ("digits", "high", "low")
    low: mpq
    high: mpq
    #: Digits behind the point: it is at most ``10^−digits`` wide.
    digits: int

    def __init__(self, low: mpq, high: mpq, digits: int) -> None:
        fill(self, low=low, high=high, digits=digits)

    def __reduce__(self) -> tuple[object, ...]:
        return Enclosure, (self.low, self.high, self.digits)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same interval, which implies nothing about the numbers in it."""
        return isinstance(other, Enclosure) and (self.low, self.high) == (other.low, other.high)

    def __hash__(self) -> int:
        return hash((Enclosure, self.low, self.high))

    def __contains__(self, number: Number) -> bool:
        return bool(self.low <= rational(number) <= self.high)

    @property
    def middle(self) -> mpq:
        """The middle, off by at most half the width."""
        return (self.low + self.high) / 2

    def __float__(self) -> float:
        """The double nearest to the middle."""
        return double(self.middle)

    def __str__(self) -> str:
        """The middle to `digits` digits behind the point."""
        scaled = _nearest_integer(self.middle * mpz(10) ** self.digits)
        whole, part = divmod(abs(scaled), 10**self.digits)
        decimals = f".{part:0{self.digits}d}" if self.digits else ""
        return f"{'-' if scaled < 0 else ''}{whole}{decimals}"

    @property
    def certain(self) -> str:
        """The decimals on which both ends agree, followed by dots; where they agree on none, the two ends.

        >>> Enclosure(mpq(1, 3), mpq(3334, 10000), 6).certain, Enclosure(mpq(-1, 100), mpq(1, 100), 2).certain
        ('0.333…', '-0.01 … 0.01')
        """
        ends = [_truncated(end, self.digits) for end in (self.low, self.high)]
        agreed = len(list(takewhile(lambda pair: pair[0] == pair[1], zip(*ends, strict=False))))
        if "." not in ends[0][:agreed]:
            return " … ".join(ends)
        return ends[0] if self.low == self.high == rational(ends[0]) else f"{ends[0][:agreed]}…"

    def __repr__(self) -> str:
        shown = str(self)
        return f"<Enclosure {shown.rstrip('0').rstrip('.') if '.' in shown else shown}…>"


def _truncated(q: mpq, digits: int) -> str:
    """A number to so many digits behind the point, cut off towards zero."""
    whole, part = divmod(int(abs(q) * mpz(10) ** digits), 10**digits)
    return f"{'-' if q < 0 else ''}{whole}.{part:0{digits}d}"


def _nearest_integer(q: mpq) -> int:
    return int((2 * q + 1) // 2)


def at(
    curve: Nurbs, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT
) -> tuple[mpq | Enclosure, ...]:
    """The point of a curve at a parameter or a root (see `exactspline.Nurbs.at`)."""
    place = exact_place(t)
    if isinstance(place, Root):
        return value_at(tuple(curve.p), curve.w, place, digits)
    return curve(place, side)


def exact_place(t: Number | Root) -> mpq | Root:
    """A parameter as an exact number where it is one, otherwise the root."""
    if not isinstance(t, Root):
        return rational(t)
    return t if t.exact is None else t.exact


def value_at(top: tuple[BSpline, ...], bottom: BSpline | None, root: Root, digits: int) -> tuple[Enclosure, ...]:
    """The quotients of splines by one that is not zero there (None: the splines) at an irrational root."""

    def bounds(low: mpq, high: mpq) -> list[Bounds] | None:
        below = Bounds(mpq(1), mpq(1)) if bottom is None else values_between(bottom, low, high)
        above = [values_between(f, low, high) for f in top]
        if below is None or None in above or below.low <= 0 <= below.high:
            return None
        return [quotient(x, below) for x in above if x is not None]

    return tuple(narrowed(bounds, root, digits))


def narrowed(bounds: Callable[[mpq, mpq], list[Bounds] | None], root: Root, digits: int) -> list[Enclosure]:
    """Enclosures at most ``10^−digits`` wide: the root is refined until the bounds over its interval (None: not yet
    known) are narrow enough.
    """
    precision, wanted = digits + 5, mpq(1, mpz(10) ** (digits + 1))
    while True:
        found = bounds(*root.refine(precision))
        if found is not None and all(b.high - b.low <= 5 * wanted for b in found):
            return [Enclosure(*rounded_outwards(b, digits + 1), digits) for b in found]
        precision *= 2


def rounded_outwards(b: Bounds, digits: int) -> Bounds:
    """The nearest multiples of ``10^−digits`` below and above."""
    scale = mpz(10) ** digits
    return Bounds(mpq((b.low * scale) // 1, scale), mpq(-((-b.high * scale) // 1), scale))


def quotient(a: Bounds, b: Bounds) -> Bounds:
    """Bounds of a quotient whose denominator is not zero.

    >>> quotient(Bounds(mpq(-1), mpq(2)), Bounds(mpq(1), mpq(4)))
    Bounds(low=mpq(-1,1), high=mpq(2,1))
    """
    ends = [x / y for x in a for y in b]
    return Bounds(min(ends), max(ends))


def root_of(b: Bounds, digits: int) -> Bounds:
    """Bounds of the square root of a quantity that is not negative, multiples of ``10^−digits``.

    >>> root_of(Bounds(mpq(2), mpq(2)), 2)
    Bounds(low=mpq(141,100), high=mpq(71,50))
    """
    scale = mpz(10) ** digits
    low, high = (isqrt(mpz((max(x, mpq(0)) * scale**2) // 1)) for x in b)
    return Bounds(mpq(low, scale), mpq(high + 1, scale))


def values_between(f: BSpline, low: mpq, high: mpq) -> Bounds | None:
    """Bounds of a spline on an interval inside one of its segments; None where a knot is inside.

    >>> from exactspline import BSpline
    >>> low, high = values_between(BSpline.bezier([0, 0, 1]), mpq(1, 2), mpq(5001, 10000))
    >>> low <= mpq(1, 4), mpq(5001, 10000) ** 2 <= high, high - low < mpq(1, 5000)
    (True, True, True)
    """
    i = f.mesh.locate(low)
    if high > f.mesh.breaks[i + 1]:
        return None
    if f.degree < 0:
        return Bounds(mpq(0), mpq(0))
    return Bounds(*bounds_over(f.forms[i], f.degree, f.mesh.local(i, low), f.mesh.local(i, high)))


def sign_at(f: BSpline, t: mpq | Root, side: Side | str = Side.RIGHT) -> int:
    """The sign of a spline at a parameter or a root, exactly.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 2)
    >>> root = zeros(t * t - 2).roots[0]
    >>> sign_at(t * t * t - 2 * t, root), sign_at(t - 1, root), sign_at(2 * t - 3, root)
    (0, 1, -1)
    """
    place = exact_place(t)
    if not isinstance(place, Root):
        value = f(place, side)
        return int(value > 0) - int(value < 0)
    digits, zero = 5, None
    while True:
        low, high = place.refine(digits)
        found = values_between(f, low, high)
        if found is not None:
            if found.low > 0 or found.high < 0:
                return 1 if found.low > 0 else -1
            if zero is None:
                zero = place.is_root_of(segment_polynomial(f, f.mesh.locate(low)))
            if zero:
                return 0
        digits *= 2


def segment_polynomial(f: BSpline, i: int) -> fmpz_poly:
    """A constant times the polynomial of a segment, in the parameter of the spline, with integer coefficients.

    >>> from exactspline import BSpline
    >>> segment_polynomial(BSpline.bezier([0, 0, 1], 1, 3), 0)
    x^2 + (-2)*x + 1
    """
    a, b = f.mesh.breaks[i : i + 2]
    m = lcm(a.denominator, b.denominator)
    u, v = fmpz_poly([int(b * m), int(-m)]), fmpz_poly([int(-a * m), int(m)])
    p = substituted(f.polynomials[i], max(f.degree, 0), u, v)
    return p // p.content() if p else p
