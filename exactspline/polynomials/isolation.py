"""Exact isolation of the zeros of one form on its segment: Descartes' rule with subdivision.

In ``z = t/(1 − t)`` the segment is ``z ≥ 0`` and the form is ``Σ c_i zⁱ``; the sign changes of its coefficients bound
the number of zeros inside the segment and agree with it in parity. No sign change means no zero, one sign change means
one simple zero; otherwise the segment is split at the midpoint, by two Taylor shifts. The square-free part is needed
only if a depth limit is reached: then a multiple zero may be the cause, and a gcd modulo a prime usually proves that
there is none.

Source: Collins and Akritas, Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976; Lane and
Riesenfeld, Bounds on a polynomial, BIT 1981.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from operator import itemgetter
from typing import NamedTuple, Protocol

from flint import fmpq, fmpq_poly, fmpz_poly

from exactspline.errors import DomainError, ReachError
from exactspline.numbers.exact import mpq, ratio, text, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.numbers.search import Search
from exactspline.polynomials.bernstein import (
    ONE,
    ONE_PLUS_2Z,
    backwards,
    divide_u_plus_v,
    of_parameter,
    restrict,
    value,
    variations,
)
from exactspline.polynomials.elimination import without_rational_zero
from exactspline.polynomials.factors import (
    Factorization,
    certainly_square_free,
    factorize,
    factorize_square_free,
    multiplied,
)

# ---- cells
#
# The cells are the input of the proofs in `extras/coq/theory/Answers.v`; a multiple zero has a witness: a factor with
# this simple zero, and a cofactor without zeros.


#: The maximal number of bisections of an interval.
CELL_DEPTH = 400


@dataclass(frozen=True)
class Cell:
    """An interval in the interior of which a polynomial has no zero (`sign` is its sign), is identically 0 (`sign` is
    None), or has one zero (`one`) and `sign` is its sign to the left of it.

    For a multiple zero, the polynomial is ``factor^power · rest``, where the zero is simple in `factor`, and `rest` has
    no zero and the sign `rest_sign`; `sign` is the sign of the factor to the left.
    """

    low: mpq
    high: mpq
    sign: bool | None
    one: bool = False
    factor: fmpq_poly | None = None
    power: int = 1
    rest: fmpq_poly | None = None
    rest_sign: bool = True


def cells_of(polynomial: fmpq_poly, low: mpq, high: mpq) -> list[Cell]:
    """The cells of a polynomial between two points.

    >>> [(str(c.low), str(c.high), c.sign, c.one) for c in cells_of(fmpq_poly([-1, 0, 2]), mpq(0), mpq(1))]
    [('0', '1', False, True)]
    >>> [c.one for c in cells_of(fmpq_poly([1, 0, -4, 0, 4]), mpq(0), mpq(1))]
    [True]

    Raises `DomainError` if bisection does not terminate.
    """
    if not polynomial:
        return [Cell(low, high, None)]
    powers = sorted(factorize_square_free(polynomial.numer()).powers, key=itemgetter(1))
    multiple = [(fmpq_poly(f) / f.leading_coefficient(), e) for f, e in powers if e > 1]
    cells: list[Cell] = []
    search = Search([Interval(low, high)], depth_first=True)
    for a, b in search:
        cell = _cell(polynomial, multiple, a, b)
        if cell is not None:
            cells.append(cell)
            continue
        if search.depth == CELL_DEPTH:
            raise DomainError("bisection does not terminate", where=f"[{text(a)}, {text(b)}]", remedy="report this")
        search.split(Interval(a, b).halves)
    return cells


def one_sign(polynomial: fmpq_poly, low: mpq, high: mpq) -> bool | None:
    """The sign in the interior of an interval, if it follows from the Bernstein coefficients, else None.

    >>> [one_sign(fmpq_poly([-1, 2]), mpq(k, 2), mpq(k + 1, 2)) for k in (0, 1)], one_sign(fmpq_poly(), mpq(0), mpq(1))
    ([False, True], None)
    """
    n = polynomial.degree()
    coefficients = of_parameter(polynomial.numer(), n, low, high).coeffs() if n >= 0 else []
    signs = {x > 0 for x in coefficients if x}
    return signs.pop() if len(signs) == 1 else None


def _cell(f: fmpq_poly, multiple: list[tuple[fmpq_poly, int]], a: mpq, b: mpq) -> Cell | None:
    if (sign := one_sign(f, a, b)) is not None:
        return Cell(a, b, sign)
    if (sign := _one_zero(f, a, b)) is not None:
        return Cell(a, b, sign, one=True)
    for g, power in multiple:
        if (sign := _one_zero(g, a, b)) is not None:
            rest = f // g**power
            rest_sign = one_sign(rest, a, b)
            if rest_sign is not None and _at(rest, a) and _at(rest, b):
                return Cell(a, b, sign, one=True, factor=g, power=power, rest=rest, rest_sign=rest_sign)
    return None


def _one_zero(f: fmpq_poly, a: mpq, b: mpq) -> bool | None:
    """The sign to the left of the only zero in the interior, if this follows from the ends and the derivative, else
    None.
    """
    at_low, at_high = _at(f, a), _at(f, b)
    if at_low == 0 or at_high == 0 or (at_low > 0) == (at_high > 0):
        return None
    rising = one_sign(f.derivative(), a, b)
    return None if rising is None or rising == bool(at_low > 0) else bool(at_low > 0)


def _at(f: fmpq_poly, t: mpq) -> fmpq:
    return f(to_fmpq(t))


#: The depth at which multiple zeros are first suspected.
DEPTH = 10


class LocalPolynomial:
    """An integer polynomial in z, non-zero at both ends of the segment, with the polynomials for its evaluation from
    either end.

    >>> LocalPolynomial(fmpz_poly([1, -5, 6])).reversed.coeffs()
    [6, -5, 1]
    """

    def __init__(self, polynomial: fmpz_poly) -> None:
        self.polynomial = polynomial

    def __reduce__(self) -> tuple[object, ...]:
        return _local, tuple(int(x) for x in self.polynomial.coeffs())

    @cached_property
    def slope(self) -> fmpz_poly:
        """The derivative with respect to z."""
        return self.polynomial.derivative()

    @cached_property
    def reversed(self) -> fmpz_poly:
        """The polynomial in 1/z."""
        return backwards(self.polynomial, self.polynomial.degree())

    @cached_property
    def reversed_slope(self) -> fmpz_poly:
        """The derivative of the polynomial in 1/z with respect to 1/z."""
        return self.reversed.derivative()

    @cached_property
    def without_rational_zero(self) -> bool:
        """Whether it is certain that no zero is rational; False decides nothing.

        >>> [LocalPolynomial(fmpz_poly(c)).without_rational_zero for c in ([-2, 0, 1], [-4, 0, 1])]
        [True, False]
        """
        return without_rational_zero(self.polynomial)


def _local(*coefficients: int) -> LocalPolynomial:
    return LocalPolynomial(fmpz_poly(list(coefficients)))


class Zero(Protocol):
    """A zero inside a segment: a `LocalZero`, or a zero that is computed when first needed."""

    @property
    def low(self) -> mpq:
        """The lower end of the interval of the zero."""

    @property
    def high(self) -> mpq:
        """The upper end of the interval of the zero."""

    @property
    def multiplicity(self) -> int:
        """The multiplicity of the zero."""

    @property
    def signs(self) -> tuple[int, int]:
        """The signs of the form on both sides."""

    @property
    def factor(self) -> LocalPolynomial:
        """A factor with this simple zero."""

    @property
    def changing(self) -> tuple[LocalPolynomial, int]:
        """A polynomial that changes its sign at the zero, and its sign before the zero."""


class LocalZero(NamedTuple):
    """A zero strictly inside the segment, in the local parameter: it is ``low = high``, or the only zero in the open
    interval (low, high).
    """

    low: mpq
    high: mpq
    multiplicity: int
    #: Signs of the form just left and just right of the zero.
    signs: tuple[int, int]
    #: A factor of the form with this simple zero and no other in the interval (any factor with this zero if it is
    #: exact).
    factor: LocalPolynomial
    #: Sign of the factor just left of the zero (0 if it is exact).
    sign: int

    @property
    def changing(self) -> tuple[LocalPolynomial, int]:
        """A polynomial that changes its sign at the zero and nowhere else in the interval, and its sign just left of
        it.
        """
        return self.factor, self.sign


class _Leaf(NamedTuple):
    """The interval ``[k, k + 1]/2^level``, with 0 or 1 sign changes of the subdivided polynomial."""

    level: int
    k: int
    changes: int


class Isolation(NamedTuple):
    """The zeros of one form on one segment, and the leaves of the subdivision, which prove that there are no others."""

    #: Multiplicity of the zero at the left end, and at the right end (0: none).
    at_left: int
    at_right: int
    #: Signs of the form just right of the left end, and just left of the right end.
    signs: tuple[int, int]
    inner: list[LocalZero]
    leaves: list[_Leaf]
    #: The zeros exactly at midpoints, ``k/2^level``.
    points: list[tuple[int, int]]
    #: Square-free factors with their multiplicities, if they were needed; the leaves then refer to the product of the
    #: factors, each taken once.
    factors: Factorization[LocalPolynomial] | None


#: The leaves of a form whose coefficients all have the same sign.
NO_CHANGE = [_Leaf(0, 0, 0)]


def isolate(c: fmpz_poly, n: int) -> Isolation:
    """All zeros on [0, 1] of the non-zero form ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ``.

    >>> found = isolate(fmpz_poly([1, -3, 1]), 2)  # (1 − t)² − 3(1 − t)t + t²
    >>> [(str(zero.low), str(zero.high)) for zero in found.inner]
    [('0', '1/2'), ('1/2', '1')]
    """
    coefficients = c.coeffs()
    at_left = 0 if coefficients[0] else next(i for i, x in enumerate(coefficients) if x)
    at_right = n + 1 - len(coefficients)
    signs = sign_of(coefficients[at_left]), sign_of(coefficients[-1])
    positive = signs[0] > 0
    if all((x > 0) is positive for x in coefficients if x):
        return Isolation(at_left, at_right, signs, [], NO_CHANGE, [], None)
    inner, content = c.right_shift(at_left) if at_left else c, c.content()
    inner, _ = divide_u_plus_v(inner if content == 1 else inner // content, inner.degree())
    search = _Search(inner, DEPTH)
    if search.finished:
        return Isolation(at_left, at_right, signs, search.zeros(), search.leaves, search.points(), None)
    factors = Factorization((LocalPolynomial(g), int(k)) for g, k in factorize_square_free(inner).powers)
    radical = multiplied(Factorization((factor.polynomial, 1) for factor, _ in factors), fmpz_poly([1]))
    search = _Search(radical, None)
    zeros = _attributed(inner, factors, search.zeros())
    return Isolation(at_left, at_right, signs, zeros, search.leaves, search.points(), factors)


class _Search:
    """Subdivision of a polynomial that is non-zero at both ends; not `finished` if it stopped at the depth limit
    because of a multiple zero.
    """

    def __init__(self, polynomial: fmpz_poly, cap: int | None) -> None:
        self.factor, self.cap = LocalPolynomial(polynomial), cap
        self.leaves: list[_Leaf] = []
        #: Level, k, multiplicity at a point or 0 inside an interval, signs on both sides.
        self._found: list[tuple[int, int, int, tuple[int, int]]] = []
        self.finished = self._run(polynomial)

    def _run(self, polynomial: fmpz_poly) -> bool:
        todo = [(0, 0, polynomial, False)]
        while todo:
            level, k, part, flipped = todo.pop()
            changes = variations(part)
            if changes <= 1:
                self.leaves.append(_Leaf(level, k, changes))
                if changes:
                    sign = sign_of(part.leading_coefficient() if flipped else part[0])
                    self._found.append((level, k, 0, (sign, -sign)))
                continue
            if level == self.cap:
                if not certainly_square_free(polynomial):
                    return False
                self.cap = None
            other = backwards(part, part.degree())
            # the left half is stored in reverse, so that both halves begin at the midpoint
            left, right = (x(ONE_PLUS_2Z) for x in ((part, other) if flipped else (other, part)))
            level, k = level + 1, 2 * k
            if right[0] == 0:
                times = next(i for i, x in enumerate(right.coeffs()) if x)
                left, right = left.right_shift(times), right.right_shift(times)
                self._found.append((level, k + 1, times, (sign_of(left[0]), sign_of(right[0]))))
            todo += [(level, k + 1, right, False), (level, k, left, True)]
        return True

    def points(self) -> list[tuple[int, int]]:
        return [(level, k) for level, k, times, _ in self._found if times]

    def zeros(self) -> list[LocalZero]:
        result = []
        for level, k, times, signs in self._found:
            low = mpq(k, 1 << level)
            high = low if times else mpq(k + 1, 1 << level)
            result.append(
                _exact_if_linear(LocalZero(low, high, times or 1, signs, self.factor, 0 if times else signs[0]))
            )
        return sorted(result, key=lambda zero: zero.low + zero.high)


def _attributed(c: fmpz_poly, factors: Factorization[LocalPolynomial], zeros: list[LocalZero]) -> list[LocalZero]:
    """The zeros of the product of the factors, each with the factor to which it belongs, and with the signs of the form
    itself.
    """
    result = []
    for zero in zeros:
        low, high = zero.low, zero.high
        if low == high:
            factor, multiplicity = next(
                (f, k) for f, k in factors if value((f.polynomial, ONE), f.polynomial.degree(), low) == 0
            )
            signs, sign = (end_signs(c, mpq(0), low)[1], end_signs(c, low, mpq(1))[0]), 0
        else:
            # the product has one zero here, so that exactly one factor changes sign
            (factor, multiplicity), sign = next(
                (pair, first)
                for pair, (first, last) in ((p, end_signs(p[0].polynomial, low, high)) for p in factors)
                if first != last
            )
            signs = end_signs(c, low, high)
        result.append(_exact_if_linear(LocalZero(low, high, multiplicity, signs, factor, sign)))
    return result


def _exact_if_linear(zero: LocalZero) -> LocalZero:
    c = zero.factor.polynomial
    if c.degree() != 1:
        return zero
    t = ratio(c[0], c[0] - c[1])
    return zero._replace(low=t, high=t, sign=0)


def end_signs(c: fmpz_poly, low: mpq, high: mpq) -> tuple[int, int]:
    """Signs of the form with integers c (of the degree of c) just inside the ends of [low, high].

    >>> end_signs(fmpz_poly([1, -1]), mpq(1, 2), mpq(1))
    (-1, -1)
    """
    part, _ = restrict((c, ONE), c.degree(), low, high)
    signs = [sign_of(x) for x in part.coeffs() if x != 0]
    return signs[0], signs[-1]


def _rational_roots(c: fmpz_poly) -> list[mpq]:
    """The rational local parameters strictly inside the segment at which a non-zero form vanishes.

    >>> _rational_roots(fmpz_poly([-1, 1]) * fmpz_poly([-2, 0, 1]))
    [mpq(1,2)]
    """
    ratios = [ratio(-p[0], p[1]) for p in factorize(c).bases if p.degree() == 1]
    return sorted(z / (1 + z) for z in ratios if z > 0)


def zero_on_segment(c: fmpz_poly, n: int) -> Interval | None:
    """An interval in [0, 1] that contains a zero of the form (a point if the zero is rational); None if there is no
    zero.

    >>> zero_on_segment(fmpz_poly([1, -2, 3]), 2) is None
    True
    >>> zero_on_segment(fmpz_poly([1, -3, 1]), 2)
    Interval(0, 1/2)
    >>> zero_on_segment(fmpz_poly([1, -4, 4]), 2)
    Interval(1/3, 1/3)
    """
    if not c:
        return Interval(mpq(0), mpq(1))
    for end in (0, 1):
        if c[n * end] == 0:
            return Interval.point(mpq(end))
    inner = isolate(c, n).inner
    if not inner:
        return None
    interval = Interval(inner[0].low, inner[0].high)
    if interval.low < interval.high:
        with suppress(ReachError):
            exact = (t for t in _rational_roots(inner[0].factor.polynomial) if interval.low < t < interval.high)
            interval = next(map(Interval.point, exact), interval)
    return interval


def is_nonnegative(c: fmpz_poly, n: int) -> bool:
    """Whether a form of degree n is ≥ 0 on its segment: it is positive just inside both ends and does not change sign.

    >>> is_nonnegative(fmpz_poly([1, -2, 1]), 2), is_nonnegative(fmpz_poly([1, -3, 1]), 2)
    (True, False)
    """
    if not c:
        return True
    isolation = isolate(c, n)
    return isolation.signs == (1, 1) and all(zero.signs == (1, 1) for zero in isolation.inner)
