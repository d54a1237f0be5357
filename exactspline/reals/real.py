"""Exact real numbers (rational, quadratic and algebraic) with `+ − * /`, order, equality and digits.

A number is represented by the expression tree of the operations that made it, over rational numbers and roots, and by
an enclosure that is refined on demand. A polynomial with this zero is computed only for questions that enclosures
cannot decide (equality, rationality, the minimal polynomial), at a cost that is bounded beforehand
(`exactspline.polynomials.elimination`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from math import floor, prod
from operator import add, methodcaller, mul, sub, truediv
from typing import TYPE_CHECKING, Any, Self, TypeAlias, TypeVar, cast

from flint import arb, ctx, fmpq, fmpq_poly, fmpz_poly

from exactspline.errors import NumberError
from exactspline.hooks import Written
from exactspline.numbers.exact import (
    Number,
    Rounding,
    double,
    gcd,
    is_square,
    isqrt,
    lcm,
    mpq,
    mpz,
    rational,
    text,
    to_fmpq,
)
from exactspline.numbers.intervals import Interval, ball_around, ball_ends
from exactspline.numbers.once import fill
from exactspline.polynomials import elimination
from exactspline.polynomials.cost import LONGEST_LOOP, check_reach
from exactspline.polynomials.elimination import QuotientModulo, linear
from exactspline.reals.algebraic import EXACT, Algebraic

if TYPE_CHECKING:
    import sympy

#: The primes whose squares are removed from a radicand.
_PRIMES = [p for p in range(2, 1000) if all(p % q for q in range(2, int(isqrt(p)) + 1))]
_PRODUCT = prod(_PRIMES, start=mpz(1))


def square_root_parts(q: mpq) -> tuple[mpq, int]:
    """a and b with ``√q = a√b`` for a rational number q ≥ 0; b is 1 if the root is rational.

    >>> square_root_parts(mpq(9, 4)), square_root_parts(mpq(12))
    ((mpq(3,2), 1), (mpq(2,1), 3))
    """
    n = mpz(q.numerator * q.denominator)
    root, radicand = (isqrt(n), mpz(1)) if is_square(n) else _without_square_factors(n)
    return mpq(root, q.denominator), int(radicand)


def _without_square_factors(n: mpz) -> tuple[mpz, mpz]:
    """An integer n > 0 as ``r² m``, without the squares of small primes in m: r and m.

    >>> _without_square_factors(mpz(12))
    (mpz(2), mpz(3))
    """
    root = mpz(1)
    once = gcd(n, _PRODUCT)
    if (twice := gcd(once, n // once)) > 1:
        for prime in (p for p in _PRIMES if twice % p == 0):
            while n % (prime * prime) == 0:
                n, root = n // (prime * prime), root * prime
    return root, n


#: The initial values of the attributes of a number.
UNASKED = dict.fromkeys(("_closed", "_exact", "_isolating", "_minimal"))
V = TypeVar("V")
#: An operation that applies to numbers, balls and quotients of polynomials.
Operation: TypeAlias = Callable[..., object]
#: Guard bits in addition to those of the requested digits.
GUARD = 16
#: The number of bits from which the cost of an operation is counted, and the nanoseconds per bit (measured: 13, and up
#: to 50 with the refinement of roots).
LARGE, BIT = 100_000, 60


class Real(Algebraic, Written):
    """An exact real number: a rational number ``Real(number)``, a root or a value of a curve, or a result of `+ − * /`,
    `abs` or `square_root`.

    Numbers are compared by value, also with exact numbers of other libraries. Equal numbers have equal hashes.
    ``float(x)`` is the correctly rounded double.

    >>> x = square_root(2)
    >>> y = (x + 1) * (x - 1), x / 2, 1 / (x + square_root(3)), -x < 0 < abs(-x)
    >>> y[0] == 1, hash(y[0]) == hash(1), y[1], y[2], y[3], float(x)
    (True, True, <Real √2/2>, <Real 0.31783725…>, True, 1.4142135623730951)
    >>> (x + square_root(3)).minimal_polynomial(), x.decimal(30)
    ([1, 0, -10, 0, 1], '1.414213562373095048801688724210')

    Operations that require a polynomial (equality of numbers that enclosures do not separate, hash, `exact`,
    `minimal_polynomial`) raise `ReachError` if the degree of the polynomial would be too high, and `OpenError` for a
    number that is not known to be algebraic.
    """

    __slots__ = ()
    #: The operation that made the number, and its operands; a number without operands is a leaf of the tree.
    _operation: Operation
    _operands: tuple[Real, ...] = ()

    @property
    def _given(self) -> mpq | None:
        """The rational number from which this number was made; otherwise None."""
        return None

    def __new__(cls, *given: object, **named: object) -> Self:
        """``Real(number)`` is a `RationalNumber`."""
        return cast(Self, object.__new__(RationalNumber if cls is Real else cls))

    def __init__(self, value: Number) -> None:
        """A rational number."""

    def _in_terms(self) -> tuple[Real | None, fmpq_poly, fmpq_poly]:
        """A number x and two polynomials p and q such that this number is ``p(x)/q(x)``; None and constants for a
        rational number.
        """
        return self, fmpq_poly([0, 1]), fmpq_poly([1])

    def _height(self) -> int:
        """An upper bound of the base-2 logarithm of the absolute height: the polynomial of a number of degree n has a
        Mahler measure of at most ``2ⁿ ʰᵉⁱᵍʰᵗ``.
        """
        raise NotImplementedError

    def _found(self) -> Real | None:
        """The value of `in_closed_form`, decided for the first time."""
        place, top, bottom = self._in_terms()
        leaf = None if place is None or place._operands else place
        parts = elimination.integral(top, bottom)
        if leaf is not None and elimination.without_quadratic_zero(leaf._annihilator(), *parts):
            return None
        p = elimination.at_most_quadratic(self._enclosed, self._coefficient_bits(), self.is_root_of)
        return None if p is None else zero_of(p, self)

    def _coefficient_bits(self) -> int:
        """The bits of the coefficients of the polynomial of this number, if the polynomial has degree 1 or 2: no
        coefficient is larger than twice the Mahler measure.
        """
        return 2 * self._height() + 1

    def in_closed_form(self) -> Real | None:
        """Return the number as a `RationalNumber` or a `Quadratic`, or None if the number is neither."""
        if isinstance(self._exact, type(mpq())):
            return RationalNumber(self._exact)
        if self._closed is None:
            found = self._found()
            fill(self, _closed=False if found is None else found)
            if isinstance(found, RationalNumber):
                self._set_rational(found.value)
        return None if isinstance(self._closed, bool) else cast(Real, self._closed)

    def _decided(self) -> mpq | None:
        closed = self.in_closed_form()
        return closed.value if isinstance(closed, RationalNumber) else None

    @property
    def closed_form(self) -> str | None:
        """The number as text ``p/q`` or ``(a + b√c)/d``, or None if it is proved that the number has no such form.

        >>> t = square_root(2) + square_root(3)
        >>> ((t * t - 1) / 2).closed_form, (t * square_root(5 - 2 * square_root(6))).closed_form, t.closed_form
        ('2 + √6', '1', None)

        Raises `ReachError` or `OpenError` if this is not decided.
        """
        closed = self.in_closed_form()
        return None if closed is None else closed.closed_form

    def _sympy_(self) -> sympy.Expr:
        """The number as a sympy expression: a rational number, a + b√c, or an algebraic number.

        >>> import sympy
        >>> sympy.sympify(square_root("1/2")), sympy.sympify(square_root(2) + square_root(3))
        (sqrt(2)/2, CRootOf(x**4 - 10*x**2 + 1, 3))

        Raises `ReachError` or `OpenError` if the minimal polynomial cannot be computed.
        """
        import sympy

        p, below = self.minimal_polynomial(), self._isolated()[1]
        polynomial = sympy.Poly(p[::-1], sympy.Symbol("x"))
        k = polynomial.count_roots(sup=sympy.Rational(str(below))) if len(p) > 2 else 0
        return polynomial.real_roots()[k] if len(p) < 4 else sympy.CRootOf(polynomial, k)

    def is_root_of(self, polynomial: fmpz_poly) -> bool:
        """Return whether a polynomial with integer coefficients vanishes at this number."""
        place, top, bottom = self._in_terms()
        if place is None or place is self:
            return super().is_root_of(polynomial)
        n, value = polynomial.degree(), fmpq_poly([0])
        for k, coefficient in enumerate(polynomial.coeffs()):
            value += top**k * bottom ** (n - k) * coefficient
        return place.is_root_of(value.numer())

    def _with(self, operation: Operation, other: object, *, swapped: bool = False) -> Real:
        if not isinstance(other, (Real, *EXACT)):
            return cast(Real, NotImplemented)
        pair = self, real(int(other) if isinstance(other, bool) else cast("Number | Real", other))
        return _combined(operation, *(pair[::-1] if swapped else pair))

    def __add__(self, other: object) -> Real:
        return self._with(add, other)

    def __sub__(self, other: object) -> Real:
        return self._with(sub, other)

    def __mul__(self, other: object) -> Real:
        return self._with(mul, other)

    def __truediv__(self, other: object) -> Real:
        return self._with(truediv, other)

    def __radd__(self, other: object) -> Real:
        return self._with(add, other, swapped=True)

    def __rsub__(self, other: object) -> Real:
        return self._with(sub, other, swapped=True)

    def __rmul__(self, other: object) -> Real:
        return self._with(mul, other, swapped=True)

    def __rtruediv__(self, other: object) -> Real:
        return self._with(truediv, other, swapped=True)

    def __pow__(self, exponent: int) -> Real:
        """An integer power; raises `ReachError` for rational and quadratic numbers with too many digits."""
        if type(exponent) is not int:
            return NotImplemented
        if (parts := _known(self)) is not None:
            bits = max(n.bit_length() for part in parts for n in (mpq(part).numerator, mpq(part).denominator))
            cost = abs(exponent) * (bits - 1) * BIT
            check_reach(cost, lambda: f"a power of about {abs(exponent) * bits} bits", LONGEST_LOOP)
        power, base = Real(1), self if exponent >= 0 else 1 / self
        for digit in bin(abs(exponent))[2:]:
            power = power * power * base if digit == "1" else power * power
        return power

    def __divmod__(self, other: object) -> tuple[int, Real]:
        quotient = floor(self / other)
        return quotient, self - real(cast(Number, other)) * quotient

    def __rdivmod__(self, other: object) -> tuple[int, Real]:
        return divmod(real(cast(Number, other)), self)

    def __floordiv__(self, other: object) -> int:
        return divmod(self, other)[0]

    def __rfloordiv__(self, other: object) -> int:
        return divmod(other, self)[0]

    def __mod__(self, other: object) -> Real:
        return divmod(self, other)[1]

    def __rmod__(self, other: object) -> Real:
        return divmod(other, self)[1]

    @property
    def real(self) -> Real:
        """The real part: the number itself."""
        return self

    @property
    def imag(self) -> int:
        """The imaginary part: 0."""
        return 0

    def conjugate(self) -> Real:
        """Return the complex conjugate: the number itself."""
        return self

    def __neg__(self) -> Real:
        return RationalNumber(0) - self

    def __pos__(self) -> Real:
        return self

    def __abs__(self) -> Real:
        return -self if self.sign < 0 else self


class RationalNumber(Real):
    """A rational number as a `Real`."""

    __slots__ = ("value",)
    value: mpq

    def __init__(self, value: Number) -> None:
        exact = rational(value)
        fill(self, **UNASKED | {"value": exact, "_exact": exact, "_closed": self})

    def __reduce__(self) -> tuple[object, ...]:
        return RationalNumber, (self.value,)

    @property
    def _given(self) -> mpq:
        return self.value

    def _enclosed(self, digits: int) -> Interval:
        return Interval.point(self.value)

    def _annihilator(self) -> fmpz_poly:
        return linear(self.value)

    def _in_terms(self) -> tuple[Real | None, fmpq_poly, fmpq_poly]:
        return None, fmpq_poly([to_fmpq(self.value)]), fmpq_poly([1])

    def _against_number(self, t: mpq) -> int:
        return int(self.value > t) - int(self.value < t)

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """The correctly rounded double."""
        return double(self.value, rounding)

    def _height(self) -> int:
        return max(abs(self.value.numerator), self.value.denominator).bit_length()

    @property
    def closed_form(self) -> str:
        """The number as text ``p/q``."""
        return text(self.value)


class Quadratic(Real):
    """An irrational number ``a + b√c``, with rational a and b ≠ 0 and an integer c > 1 that is not a square.

    >>> x = square_root("1/8")
    >>> x, 4 * x, x**2, float(x), (1 + square_root(5)) / 2, 1 / (1 + x)
    (<Real √2/4>, <Real √2>, <Real 1/8>, 0.3535533905932738, <Real (1 + √5)/2>, <Real (8 - 2√2)/7>)
    """

    __slots__ = ("a", "b", "c")
    a: mpq
    b: mpq
    c: int

    def __init__(self, a: mpq, b: mpq, c: int) -> None:
        fill(self, **UNASKED | {"a": a, "b": b, "c": c, "_exact": False, "_closed": self})

    def __reduce__(self) -> tuple[object, ...]:
        return Quadratic, (self.a, self.b, self.c)

    def _enclosed(self, digits: int) -> Interval:
        """Multiples of ``10^−digits`` that enclose ``b√c``, shifted by a."""
        scale = mpz(10) ** digits
        root = isqrt(mpz(self.b**2 * self.c * scale**2))
        low, high = (root, root + 1) if self.b > 0 else (-root - 1, -root)
        return Interval(self.a + mpq(low, scale), self.a + mpq(high, scale))

    def _annihilator(self) -> fmpz_poly:
        return fmpq_poly([to_fmpq(self.a**2 - self.b**2 * self.c), to_fmpq(-2 * self.a), fmpq(1)]).numer()

    def _height(self) -> int:
        return self._annihilator().height_bits() // 2 + 1

    def _against_number(self, t: mpq) -> int:
        rest, square = t - self.a, self.b**2 * self.c
        if self.b > 0:
            return 1 if rest <= 0 or square > rest**2 else -1
        return -1 if rest >= 0 or square > rest**2 else 1

    @property
    def closed_form(self) -> str:
        """The number as text ``(a + b√c)/d`` with integers a, b, c and d."""
        a, b = self.a, self.b
        d = lcm(a.denominator, b.denominator)
        p, q = mpz(a * d), mpz(b * d)
        times = "" if abs(q) == 1 else str(abs(q))
        if p == 0:
            return f"{'-' if q < 0 else ''}{times}√{mpz(self.c)}" + (f"/{d}" if d != 1 else "")
        whole = f"{p} {'-' if q < 0 else '+'} {times}√{mpz(self.c)}"
        return f"({whole})/{d}" if d != 1 else whole


class Expression(Real):
    """An operation on real numbers, at least one of which is irrational."""

    __slots__ = ("_operands", "_operation", "_reached")
    _operation: Operation
    _operands: tuple[Real, ...]
    #: The narrowest enclosure computed so far; a single tuple, so that threads never see ends of different intervals.
    _reached: Interval | None
    #: More digits than for other numbers, because they cost less than the polynomial of a tree.
    suspicious_digits = 320

    def __init__(self, operation: Operation, *operands: Real) -> None:
        fill(self, _operation=operation, _operands=operands, _reached=None, **UNASKED)

    def __reduce__(self) -> tuple[object, ...]:
        return Expression, (self._operation, *self._operands)

    def _enclosed(self, digits: int) -> Interval:
        """An enclosure by FLINT's balls, with increasing precision; raises `ReachError` for numbers that are too
        large.
        """
        if isinstance(self._exact, type(mpq())):
            return Interval.point(self._exact)
        known = self._reached
        bits = max(digits, 0) * 10 // 3 + GUARD
        while known is None or known.width * mpz(10) ** max(digits, 0) > 1:
            if bits > LARGE:
                cost = len(_in_order(self, _is_leaf)) * bits * BIT
                check_reach(cost, partial("a number to {} bits".format, bits), LONGEST_LOOP)
            with ctx.workprec(bits + GUARD):
                ball = _folded(self, _is_leaf, partial(_ball, bits * 3 // 10 + 1))
            # not the ends of a wide ball, which could have more digits than fit into memory
            if ball.is_finite() and ball.rad() < 1:
                enclosure = _ends(ball, 4 * bits)
                if known is None or enclosure.width < known.width:
                    known = enclosure
                    fill(self, _reached=known)
            bits *= 2
        return known

    def _against_number(self, t: mpq) -> int:
        """The exact sign of the number minus t; if all operands except one are rational, by comparing this operand."""
        if self._operation is _root:
            return 1 if t < 0 else self._operands[0]._against_number(t * t)
        (x, y), operation = self._operands, self._operation
        if operation is mul and any(isinstance(q := z._exact, type(mpq())) and q == 0 for z in (x, y)):
            return (t < 0) - (t > 0)
        if isinstance(q := y._exact, type(mpq())):
            sign = -1 if operation in (mul, truediv) and q < 0 else 1
            return sign * x._against_number(_INVERSES[operation](t, q))
        if isinstance(q := x._exact, type(mpq())) and operation is not truediv:
            if operation is sub:
                return -y._against_number(q - t)
            return (-1 if operation is mul and q < 0 else 1) * y._against_number(_INVERSES[operation](t, q))
        return super()._against_number(t)

    def _in_terms(self) -> tuple[Real | None, fmpq_poly, fmpq_poly]:
        """The number as a rational function of the only irrational number in its tree, if there is only one."""
        places = [] if self._operation is _root else _places(self)
        if len(places) != 1:
            return super()._in_terms()
        value = _folded(self, _is_place, partial(_quotient_modulo, places[0]._annihilator()))
        return places[0], value.top, value.bottom

    def _found(self) -> Real | None:
        """The closed form, from the closed forms of the leaves, if these decide it."""
        found = _folded(self, _is_leaf, _closed_leaf, _closed)
        return super()._found() if found is None else None if isinstance(found, bool) else found

    def _height(self) -> int:
        return cast(int, _folded(self, _is_leaf, methodcaller("_height"), _height_of))

    def _annihilator(self) -> fmpz_poly:
        if self._operation is _root:
            return elimination.square_root_of(self._operands[0].irreducible_polynomial())
        place, top, bottom = self._in_terms()
        if place is not None and place is not self:
            return elimination.quotient_at(place._annihilator(), top, bottom)
        for x in _in_order(self, _is_place)[:-1]:
            x.irreducible_polynomial()
        p, q = (x.irreducible_polynomial() for x in self._operands)
        if self._operation in (add, sub):
            return elimination.sum_of(p, q if self._operation is add else elimination.negated(q))
        return elimination.product_of(p, q if self._operation is mul else elimination.inverted(q))


#: The inverses ``∘⁻¹`` of operations: comparing ``x ∘ q`` with t is comparing x with ``t ∘⁻¹ q``.
_INVERSES: dict[Operation, Callable[..., mpq]] = {add: sub, sub: add, mul: truediv, truediv: mul}


def _height_of(operation: Operation, *heights: int) -> int:
    return (heights[0] + 1) // 2 if operation is _root else sum(heights) + (operation in (add, sub))


def _closed_leaf(x: Real) -> Real | bool:
    closed = x.in_closed_form()
    return False if closed is None else closed


def _closed(operation: Operation, x: Real | bool | None, y: Real | bool | None = None) -> Real | bool | None:
    """The closed form of ``x ∘ y`` by those of x and y: False means that a number has none, None that this is not
    decided.
    """
    if operation is _root:
        # the square of a rational or quadratic number is rational or quadratic
        return square_root(x) if isinstance(x, RationalNumber) else x if isinstance(x, bool) else None
    if isinstance(x, Real) and isinstance(y, Real):
        found = _of_quadratics(operation, *cast(Any, _known(x)), *cast(Any, _known(y)))
        return False if found is None else found
    rational_one = x if isinstance(x, RationalNumber) else y if isinstance(y, RationalNumber) else None
    if rational_one is None or x is None or y is None:
        return None
    return rational_one if operation in (mul, truediv) and not rational_one.value else False


def zero_of(p: fmpz_poly, number: Real) -> Real:
    """The number as the zero of its polynomial of degree at most 2."""
    c, b, a = (mpq(int(p[k])) for k in range(3))
    if not a:
        return RationalNumber(-c / b)
    middle, root = -b / (2 * a), square_root((b * b - 4 * a * c) / (4 * a * a))
    return middle + root if number._against_number(middle) > 0 else middle - root


def _root(x: Any) -> Any:
    """The square root of a ball."""
    return x.sqrt()


def _ends(ball: arb, bits: int) -> Interval:
    """The ends of a ball, or of the interval from ``−2^−bits`` to ``2^−bits`` for a ball within it: the ends of such a
    ball could have more digits than fit into memory.
    """
    least = mpq(1, mpz(1) << bits)
    return Interval(-least, least) if abs(ball) < arb((1, -bits)) else ball_ends(ball)


def _ball(digits: int, x: Real) -> arb:
    return ball_around(*x._enclosed(digits))


def _quotient_modulo(modulus: fmpz_poly, x: Real) -> QuotientModulo:
    return QuotientModulo(modulus, *x._in_terms()[1:])


def _is_leaf(x: Real) -> bool:
    return not x._operands


def _is_place(x: Real) -> bool:
    """Whether a node of a tree is rational, or a number such that the tree is a rational function of such numbers."""
    return not x._operands or x._operation is _root


def _in_order(number: Real, is_leaf: Callable[[Real], bool]) -> list[Real]:
    """The nodes of a tree, each once and after its operands, computed without recursion."""
    ordered: dict[int, Real] = {}
    todo = [number]
    while todo:
        x = todo[-1]
        missing = [] if is_leaf(x) else [y for y in x._operands if id(y) not in ordered]
        if missing:
            todo += missing
        else:
            ordered.setdefault(id(x), todo.pop())
    return list(ordered.values())


def _folded(
    number: Real,
    is_leaf: Callable[[Real], bool],
    of_leaf: Callable[[Real], V],
    combine: Callable[..., Any] = lambda operation, *values: operation(*values),
) -> V:
    """The value of a tree: its operations applied to the values of its leaves."""
    values: dict[int, V] = {}
    for x in _in_order(number, is_leaf):
        known = (values[id(y)] for y in x._operands)
        values[id(x)] = of_leaf(x) if is_leaf(x) else cast(V, combine(x._operation, *known))
    return values[id(number)]


def _places(number: Real) -> list[Real]:
    """The irrational numbers of which a tree is a rational function."""
    places = (x._in_terms()[0] for x in _in_order(number, _is_place) if _is_place(x))
    return list({id(place): place for place in places if place is not None}.values())


def _combined(operation: Operation, x: Real, y: Real) -> Real:
    """``x ∘ y``: a rational or quadratic number if this is known immediately, otherwise a tree.

    Raises `ZeroDivisionError` for a quotient by 0.
    """
    if operation is truediv and y.sign == 0:
        raise ZeroDivisionError("a real number divided by 0")
    parts = _known(x), _known(y)
    if parts[0] is not None and parts[1] is not None:
        result = _of_quadratics(operation, *parts[0], *parts[1])
        if result is not None:
            return result
    zeros = [known is not None and not known[0] and not known[1] for known in parts]
    if operation in (mul, truediv) and any(zeros):
        return RationalNumber(0)
    if zeros[1]:
        return x
    return y if zeros[0] and operation is add else Expression(operation, x, y)


def _known(x: Real) -> tuple[mpq, mpq, int] | None:
    """a, b and c of ``a + b√c`` if x was made from these, independent of later results; c is 1 for a rational
    number.
    """
    if isinstance(x, Quadratic):
        return x.a, x.b, x.c
    return None if x._given is None else (x._given, mpq(0), 1)


def _of_quadratics(operation: Operation, a: mpq, b: mpq, c: int, e: mpq, f: mpq, g: int) -> Real | None:
    """``(a + b√c) ∘ (e + f√g)`` if it is rational or quadratic, else None."""
    if b and f and c != g:
        if not is_square(c * g):
            if a == e == 0 and operation in (mul, truediv):
                return square_root(c * g) * (b * f if operation is mul else b / (f * g))
            return None
        f = f * isqrt(mpz(c * g)) / c
    radicand = c if b else g
    if operation is add:
        return _quadratic(a + e, b + f, radicand)
    if operation is sub:
        return _quadratic(a - e, b - f, radicand)
    if operation is truediv:
        norm = e * e - f * f * radicand
        e, f = e / norm, -f / norm
    return _quadratic(a * e + b * f * radicand, a * f + b * e, radicand)


def _quadratic(a: mpq, b: mpq, c: int) -> Real:
    """``a + b√c``, where c is 1, or a non-square without square factors of small primes.

    >>> _quadratic(mpq(1), mpq(0), 5), _quadratic(mpq(1), mpq(1), 5)
    (<Real 1>, <Real 1 + √5>)
    """
    return Quadratic(a, b, int(c)) if b and c != 1 else RationalNumber(a + b)


def square_root(x: Number | Real) -> Real:
    """Return the square root of a non-negative number.

    >>> square_root("9/4"), square_root(12), square_root(1 + square_root(2))
    (<Real 3/2>, <Real 2√3>, <Real 1.553774…>)

    Raises `NumberError` for a negative number.
    """
    value = real(x)
    sign = value.sign
    if sign < 0:
        raise NumberError(f"the square root of {value}", remedy="give a number ≥ 0")
    if sign == 0:
        return RationalNumber(0)
    return Expression(_root, value) if value._given is None else _quadratic(mpq(0), *square_root_parts(value._given))


def real(value: Number | Real) -> Real:
    """Any exact number as a `Real`.

    Raises `NumberError` for anything that is not an exact number.
    """
    return value if isinstance(value, Real) else RationalNumber(value)


def between(low: Number | Real, high: Number | Real) -> mpq:
    """A rational number strictly between two numbers ``low < high``: a dyadic number with few bits.

    >>> between(0, square_root("1/2"))
    mpq(1,2)
    """
    digits, first, second = 1, real(low), real(high)
    while True:
        a, b = first._enclosed(digits)[1], second._enclosed(digits)[0]
        if a < b:
            break
        digits *= 2
    scale = 1
    while (number := mpq(int(a * scale // 1) + 1, scale)) >= b:
        scale *= 2
    return number


class Extreme(Real):
    """The maximum or minimum of several numbers, without deciding which number it is."""

    __slots__ = ("among", "side")
    among: tuple[Real, ...]
    #: 1 for the maximum, −1 for the minimum.
    side: int

    def __init__(self, side: int, among: Iterable[Real]) -> None:
        fill(self, side=side, among=tuple(among), **UNASKED)

    def __reduce__(self) -> tuple[object, ...]:
        return Extreme, (self.side, self.among)

    def _enclosed(self, digits: int) -> Interval:
        choose = max if self.side > 0 else min
        ends = [x._enclosed(digits) for x in self.among]
        return Interval(choose(low for low, _ in ends), choose(high for _, high in ends))

    def _against_number(self, t: mpq) -> int:
        signs = [x._against_number(t) for x in self.among]
        return max(signs) if self.side > 0 else min(signs)

    def _value(self) -> Real:
        return max(self.among) if self.side > 0 else min(self.among)

    def _found(self) -> Real | None:
        return self._value().in_closed_form()

    def _height(self) -> int:
        return self._value()._height()

    def _annihilator(self) -> fmpz_poly:
        return self._value()._annihilator()
