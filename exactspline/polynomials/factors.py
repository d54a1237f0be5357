"""Factorization, greatest common divisors and products of polynomials over the integers or the rationals, in any number
of variables; also factorization modulo a prime.

A factorization by FLINT is accepted only after its product has been verified. If it may take long, for integer
polynomials in one or two variables, a proof of irreducibility modulo primes is tried first; if that fails, a call whose
cost exceeds the bound is rejected. The same holds for greatest common divisors, and for products of polynomials with
many terms.

Source: the degrees of factors modulo primes as a test of irreducibility, Knuth, The Art of Computer Programming 2,
§4.6.2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import reduce
from itertools import accumulate, islice
from typing import Any, Generic, NamedTuple, Protocol, Self, TypeVar

from flint import fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly, fmpz, fmpz_mpoly, fmpz_poly, nmod_poly

from exactspline.errors import ReachError, counted
from exactspline.numbers.exact import PRIME, common_divisor
from exactspline.one_line import OneLine
from exactspline.polynomials.cost import (
    LONGEST,
    LONGEST_LOOP,
    REMEDY,
    affords,
    check_reach,
    height_bits,
    look_at_the_time,
)

# ---- products of powers


class _Multiplicative(Protocol):
    """Objects with products and powers."""

    def __mul__(self, other: Self, /) -> Self: ...
    def __pow__(self, exponent: int, /) -> Self: ...


_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

B = TypeVar("B")
Q = TypeVar("Q")
M = TypeVar("M", bound=_Multiplicative)
#: Polynomials that are divided with a remainder.
D = TypeVar("D", bound=Any)


def superscript(number: int) -> str:
    """A number as an exponent.

    >>> superscript(-12)
    '⁻¹²'
    """
    return str(number).translate(_SUPERSCRIPTS)


def power_text(base: str, exponent: int) -> str:
    """A power in mathematical notation.

    >>> power_text("w", 8), power_text("‖D1‖²", 3), power_text("w", 1)
    ('w⁸', '(‖D1‖²)³', 'w')
    """
    if exponent == 1:
        return base
    inner = f"({base})" if base[-1] in superscript(1234567890) else base
    return inner + superscript(exponent)


@dataclass(frozen=True, repr=False)
class Factorization(OneLine, Generic[B]):
    """``Π baseᵉ`` with distinct bases and non-zero exponents; bases with negative exponents are in the denominator.

    A constant factor, if any, is stored separately. Bases are compared, never hashed (FLINT's polynomials are not
    hashable).

    >>> a, b = Factorization([("x", 2), ("y", 1)]), Factorization([("y", 2), ("z", 1)])
    >>> print(a * b, a.shared(b), a.without(a.shared(b)))
    x² y³ z y x²
    """

    powers: tuple[tuple[B, int], ...] = ()

    def __init__(self, powers: Iterable[tuple[B, int]] = ()) -> None:
        object.__setattr__(self, "powers", tuple((base, e) for base, e in powers if e))

    def __iter__(self) -> Iterator[tuple[B, int]]:
        return iter(self.powers)

    def __len__(self) -> int:
        return len(self.powers)

    def __str__(self) -> str:
        return " ".join(power_text(str(base), e) for base, e in self.powers) or "1"

    def exponent(self, base: B) -> int:
        """The exponent of a base, 0 if it does not occur."""
        return next((e for other, e in self.powers if other == base), 0)

    def __mul__(self, other: Factorization[B]) -> Factorization[B]:
        merged = list(self.powers)
        for base, e in other.powers:
            i = next((i for i, (mine, _) in enumerate(merged) if mine == base), None)
            if i is None:
                merged.append((base, e))
            else:
                merged[i] = (base, merged[i][1] + e)
        return Factorization(merged)

    def __pow__(self, exponent: int) -> Factorization[B]:
        return Factorization((base, e * exponent) for base, e in self.powers)

    def shared(self, other: Factorization[B]) -> Factorization[B]:
        """The common part: each base with the smaller of its two exponents, which is 0 if it does not occur.

        >>> print(Factorization([("x", 2), ("y", -1)]).shared(Factorization([("x", 1)])))
        x y⁻¹
        """
        mine = [(base, min(e, other.exponent(base))) for base, e in self.powers]
        return Factorization([*mine, *[(base, min(e, 0)) for base, e in other.powers if not self.exponent(base)]])

    def without(self, part: Factorization[B]) -> Factorization[B]:
        """The quotient by another factorization."""
        return self * part**-1

    def mapped(self, function: Callable[[B], Q]) -> Factorization[Q]:
        """The factorization with every base replaced by its image under a function."""
        return Factorization((function(base), e) for base, e in self.powers)

    @property
    def above(self) -> Factorization[B]:
        """The part with positive exponents."""
        return Factorization((base, e) for base, e in self.powers if e > 0)

    @property
    def below(self) -> Factorization[B]:
        """The part with negative exponents."""
        return Factorization((base, e) for base, e in self.powers if e < 0)


def multiplied(factorization: Factorization[M], one: M) -> M:
    """The expanded product; no exponent may be negative.

    >>> multiplied(Factorization([(2, 3), (5, 1)]), 1)
    40
    """
    result = one
    for base, e in factorization:
        result = result * base**e
    return result


def divided_out(p: D, factor: D) -> D:
    """A polynomial divided by a non-constant factor as often as possible; 0 for the polynomial 0.

    >>> from flint import fmpz_poly
    >>> divided_out(fmpz_poly([0, 0, 1, 1]), fmpz_poly([0, 1]))
    x + 1
    """
    while p:
        quotient, rest = divmod(p, factor)
        if rest:
            break
        p = quotient
    return p


P = TypeVar("P", fmpz_poly, nmod_poly, fmpz_mpoly, fmpq_mpoly)
G = TypeVar("G", fmpz_poly, fmpq_poly, fmpz_mpoly, fmpq_mpoly)

#: The nanoseconds per coefficient bit of a dense polynomial, in one variable and in two, measured on products of two
#: factors and on squares: for factorizations into irreducible factors (700 to 1300, and 1000 to 3700), for square-free
#: factorizations (200, and 2500), and for greatest common divisors in two variables (400).
FACTOR, SQUARE_FREE, DIVISOR = {1: 1500, 2: 4000}, {1: 250, 2: 3000}, 600
#: The nanoseconds per term in more variables, and per 1000 bits of a term (measured: 3 to 50 microseconds).
TERM = 50_000
#: Nanoseconds per term and cube of the largest degree in a variable, in more than three variables (measured: 45 to 65
#: for the sum of two powers of trinomials, of degrees 20 to 40).
TERM_DEGREE = 70
#: The nanoseconds of a greatest common divisor in many variables, per term of both polynomials: with short coefficients
#: (measured: 0.3 to 6 microseconds), and times the degree in up to four variables (measured: 0.3 to 3); and the number
#: of coefficient bits that doubles the first cost.
DIVISOR_TERM, DIVISOR_DEGREE, DIVISOR_BITS, FEW = 10_000, 4_000, 150, 4
#: Nanoseconds for a term and a variable to restrict a polynomial to a line modulo a prime.
RESTRICTED = 1000
#: Limits on the number of terms of a polynomial in many variables, and of pairs of terms in one multiplication
#: (measured: 40 to 70 nanoseconds per pair).
TERMS, PAIRS = 10**6, 3 * 10**7
#: Nanoseconds per pair of terms; products of fewer pairs are not counted.
PAIR, CHEAP = 70, 10**4
SHORTER = f"at most {TERMS} are allowed: factor the formula, or name its parts"
#: Nanoseconds per square of the degree in one variable.
SQUARE = 1200
#: The cost in nanoseconds above which images modulo primes are examined first.
WORTH_A_TRY = 200_000_000
#: Nanoseconds per square of the degree of an image modulo a small prime, to compute and to factor it (measured: 150 to
#: 500).
IMAGE = 600
#: Bits of prime factors that are found in a number of any size, and of numbers that are factored completely (measured:
#: 0.5 s for a product of two primes of 80 bits).
SMOOTH_BITS, NUMBER_BITS = 24, 160
#: The number of images tried to show that two polynomials have no common factor (about one image in 10,000 is
#: misleading).
FEW_IMAGES = 2
#: Small primes for the degrees of factors.
PRIMES = (10007, 10009, 10037, 10039, 10061, 10067, 10069, 10079, 10091, 10093, 10099, 10103)


class Factored(NamedTuple, Generic[P]):
    """``constant · Π baseᵉ`` with non-constant bases, which have coprime integer coefficients; modulo a prime they are
    monic.
    """

    constant: Any
    powers: Factorization[P]

    @property
    def bases(self) -> list[P]:
        """The factors, each once."""
        return [base for base, _ in self.powers]


def factorize(p: P) -> Factored[P]:
    """A non-zero polynomial as a constant times powers of irreducible polynomials.

    >>> x = fmpz_poly([0, 1])
    >>> constant, powers = factorize(-6 * (x - 1) ** 2 * (x**2 - 2))
    >>> constant, list(powers)
    (-6, [(x^2 + (-2), 1), (x + (-1), 2)])

    Raises `ReachError` if FLINT may take too long.
    """
    if not isinstance(p, nmod_poly):
        cost = _cost(p, FACTOR)
        if isinstance(p, fmpz_poly) and cost > WORTH_A_TRY:
            parts = factorize_square_free(p)
            return _believed(p, parts.constant, [(q, e) for base, e in parts.powers for q in _split(base)])
        if isinstance(p, fmpz_mpoly) and cost > WORTH_A_TRY and _certainly_irreducible(p):
            content = common_divisor(p.coeffs()) * (1 if p.leading_coefficient() > 0 else -1)
            return _believed(p, content, [(p / content, 1)])
        longest = LONGEST_LOOP if isinstance(p, fmpq_mpoly) else LONGEST
        check_reach(cost, lambda: f"the factorization of a polynomial {_size(p)}", longest)
    return _believed(p, *_by_flint(p))


def factorize_square_free(p: P) -> Factored[P]:
    """A non-zero polynomial as a constant times powers of coprime square-free polynomials.

    >>> x = fmpz_poly([0, 1])
    >>> list(factorize_square_free(x**2 * (x**2 - 1)).powers)
    [(x^2 + (-1), 1), (x, 2)]

    Raises `ReachError` like `factorize`.
    """
    if isinstance(p, fmpz_poly | fmpz_mpoly):
        cost = _cost(p, SQUARE_FREE)
        if cost > WORTH_A_TRY and isinstance(p, fmpz_poly) and certainly_square_free(p):
            content = p.content() if p.leading_coefficient() > 0 else -p.content()
            return _believed(p, content, [(p // content, 1)])
        check_reach(cost, lambda: f"the square-free factorization of a polynomial {_size(p)}")
    return _believed(p, *p.factor_squarefree())


def prime_factors(n: int) -> dict[int, int]:
    """The prime factors of the absolute value of a non-zero integer, with their exponents.

    >>> prime_factors(-12), prime_factors(10**15 + 37)
    ({2: 2, 3: 1}, {1000000000000037: 1})

    Raises `ReachError` if the cofactor of its small prime factors is too large.
    """
    exponents = {int(p): int(e) for p, e in fmpz(abs(n)).factor_smooth(SMOOTH_BITS)}
    rest = next((p for p in exponents if not fmpz(p).is_prime()), 1)
    if rest.bit_length() > NUMBER_BITS:
        raise ReachError(f"the prime factors of a number of {rest.bit_length()} bits", remedy=REMEDY)
    exponent = exponents.pop(rest, 0)
    exponents |= {int(p): int(e) * exponent for p, e in fmpz(rest).factor()}
    return dict(sorted(exponents.items()))


def certainly_square_free(c: fmpz_poly) -> bool:
    """Whether the polynomial has no multiple factor modulo `PRIME`, which proves that it has no multiple factor at all;
    False proves nothing.

    >>> certainly_square_free(fmpz_poly([1, -3, 1])), certainly_square_free(fmpz_poly([1, -2, 1]))
    (True, False)
    """
    image = nmod_poly(c, PRIME)
    return bool(image.degree() == c.degree() and image.gcd(image.derivative()).degree() == 0)


def greatest_common_divisor(polynomials: Iterable[G]) -> G:
    """The greatest common divisor of polynomials in any number of variables; over the rationals it is monic.

    Raises `ReachError` like `factorize`.

    >>> from flint import Ordering, fmpz_mpoly_ctx
    >>> s, t = fmpz_mpoly_ctx.get(["s", "t"], Ordering.lex).gens()
    >>> greatest_common_divisor([s * s - t * t, (s + t) ** 2])
    s + t
    """
    return reduce(_divisor_of_two, polynomials)


def certainly_coprime(p: fmpz_poly, q: fmpz_poly) -> bool:
    """Whether two polynomials have no common factor modulo a prime that keeps the degree of the first: then they have
    no common factor at all; False proves nothing.

    >>> certainly_coprime(fmpz_poly([1, 1]), fmpz_poly([2, 1])), certainly_coprime(fmpz_poly([1, 1]), fmpz_poly([2, 2]))
    (True, False)
    """
    image = nmod_poly(p, PRIME)
    return bool(image.degree() == p.degree() and image.gcd(nmod_poly(q, PRIME)).degree() == 0)


def _divisor_of_two(p: G, q: G) -> G:
    if not p or not q:
        return p.gcd(q)
    if isinstance(p, fmpq_poly):
        common = fmpq_poly(_divisor_of_two(p.numer(), q.numer()))
        return common / common.leading_coefficient()
    if isinstance(p, fmpq_mpoly):
        return _divisor_in_many(p, q)
    if isinstance(p, fmpz_poly):
        cost = _cost_of_divisor(p, q)
        if cost > WORTH_A_TRY and certainly_coprime(p, q):
            return fmpz_poly([p.content().gcd(q.content())])
    else:
        cost = max(_cost(f, {1: DIVISOR, 2: DIVISOR}) for f in (p, q))
        if cost > WORTH_A_TRY and all(_certainly_without(p, q, k) for k in (0, 1)):
            return p.context().constant(common_divisor([*p.coeffs(), *q.coeffs()]))
    check_reach(cost, lambda: f"the greatest common divisor of polynomials {_size(p)} and {_size(q)}")
    return p.gcd(q)


def _divisor_in_many(p: fmpq_mpoly, q: fmpq_mpoly) -> fmpq_mpoly:
    if len(p) == 1 or len(q) == 1:
        look_at_the_time()
        return p.gcd(q)
    first, second, terms = _degrees(p), _degrees(q), len(p) + len(q)
    cost = terms * DIVISOR_TERM * (1 + max(_bits(p), _bits(q)) // DIVISOR_BITS)
    if max(len(first), len(second)) <= FEW:
        cost += terms * max(first + second, default=0) * DIVISOR_DEGREE
    if cost > LONGEST_LOOP and _certainly_coprime_on_a_line(p, q):
        return p.context().constant(1)
    check_reach(cost, lambda: f"the greatest common divisor of polynomials {_size(p)} and {_size(q)}", LONGEST_LOOP)
    return p.gcd(q)


def bounded_product(p: fmpq_mpoly, q: fmpq_mpoly) -> fmpq_mpoly:
    """The product of two polynomials in many variables.

    Raises `ReachError` if the product is too large, or if many products together are too expensive.
    """
    pairs = len(p) * len(q)
    if pairs > PAIRS:
        raise ReachError(f"a product of {len(p)} by {counted(len(q), 'term')}", remedy=SHORTER)
    if pairs > CHEAP:
        check_reach(PAIR * pairs, lambda: f"a product of {len(p)} by {counted(len(q), 'term')}", LONGEST_LOOP)
    product: fmpq_mpoly = p * q
    if len(product) > TERMS:
        raise ReachError(f"a polynomial of {counted(len(product), 'term')}", remedy=SHORTER)
    return product


def _cost_of_divisor(p: fmpz_poly, q: fmpz_poly) -> int:
    """An estimate in nanoseconds of the cost of images modulo as many primes as a coefficient has words
    (measured: 40 s for degree 32 and 1,300,000 bits, 3 s for 400 and 67,000).
    """
    degree, words = max(p.degree(), q.degree()), 1 + max(p.height_bits(), q.height_bits()) // 62
    return words * degree * (4 * words + 10 * degree)


def _split(base: fmpz_poly) -> list[fmpz_poly]:
    """The irreducible factors of a square-free polynomial."""
    cost = _cost(base, FACTOR)
    if cost > WORTH_A_TRY and _certainly_irreducible(base):
        return [base]
    check_reach(cost, lambda: f"the factorization of a polynomial {_size(base)}")
    return [q for q, _ in base.factor()[1]]


def _by_flint(p: Any) -> Any:
    """The factors as returned by FLINT. Integer polynomials in several variables are factored over the rationals,
    because python-flint sorts integer factors by their coefficients as machine integers, and fails beyond 31 bits.
    """
    if not isinstance(p, fmpz_mpoly):
        return p.factor()
    context = p.context()
    constant, factors = fmpq_mpoly_ctx.get(context.names(), context.ordering()).from_dict(p.to_dict()).factor()
    return constant.p, [(context.from_dict({e: x.p for e, x in base.to_dict().items()}), k) for base, k in factors]


def _believed(p: P, constant: Any, factors: list[tuple[P, int]]) -> Factored[P]:
    """The factorization, after verification of its product; raises `ArithmeticError` if the product is not the
    polynomial.
    """
    factorization = Factorization((base, int(e)) for base, e in factors)
    product_of_all = multiplied(factorization, p * 0 + 1) * constant
    if product_of_all != p:
        raise ArithmeticError("the product of FLINT's factors is not the polynomial")
    return Factored(constant, factorization)


# ---- cost


def _degrees(p: fmpz_poly | fmpz_mpoly | fmpq_mpoly) -> list[int]:
    """The degrees in those variables that occur."""
    return [d for d in map(int, [p.degree()] if isinstance(p, fmpz_poly) else p.degrees()) if d > 0]


def _bits(p: fmpz_poly | fmpz_mpoly | fmpq_mpoly) -> int:
    """The number of bits of the largest coefficient of a polynomial."""
    return int(p.height_bits()) if isinstance(p, fmpz_poly) else height_bits(p.coeffs())


def _cost(p: fmpz_poly | fmpz_mpoly | fmpq_mpoly, per_bit: dict[int, int]) -> int:
    """An estimate in nanoseconds. A polynomial in one or two variables counts as dense; in more variables its terms are
    counted.
    """
    degrees, terms = _degrees(p), 1
    if not degrees:
        return 0
    if len(degrees) > 2:
        steep = TERM_DEGREE * max(degrees) ** 3 if len(degrees) > 3 else 0
        return len(p) * (TERM * (1 + _bits(p) // 1000) + steep)
    for d in degrees:
        terms *= d + 1
    cost = terms * _bits(p) * per_bit[len(degrees)]
    return cost + (SQUARE * degrees[0] ** 2 if len(degrees) == 1 else 0)


def _size(p: fmpz_poly | fmpz_mpoly | fmpq_mpoly) -> str:
    degrees = _degrees(p)
    if len(degrees) > 2:
        return f"of {counted(len(p), 'term')} in {counted(len(degrees), 'variable')}"
    return f"of degree {' × '.join(map(str, degrees))} with integers of {_bits(p)} bits"


# ---- modulo primes


def _certainly_irreducible(p: fmpz_poly | fmpz_mpoly) -> bool:
    """Whether the degrees of factors modulo primes prove that there are no two non-constant factors; False proves
    nothing.

    In one variable, the degree of a factor is a sum of degrees of factors of each image of the same degree. In two
    variables, one variable is set to a value: if every factor must have the full degree in the other variable or degree
    0, then there is only one factor, unless the coefficients, as polynomials in the first variable, have a common
    factor.
    """
    if isinstance(p, fmpz_poly):
        return _one_degree((nmod_poly([int(x % n) for x in p.coeffs()], n) for n in PRIMES), p.degree())
    if len(_degrees(p)) < 2 or p.context().nvars() != 2:
        return False
    return any(_one_degree(_images(p, k), int(p.degrees()[1 - k])) and _certainly_primitive(p, k) for k in (0, 1))


def _one_degree(images: Iterable[nmod_poly], degree: int) -> bool:
    """Whether no number strictly between 0 and the degree is a sum of factor degrees of all images of this degree."""
    possible = (1 << (degree + 1)) - 1
    for image in images:
        if not affords(IMAGE * degree**2):
            return False
        if image.degree() == degree:
            sums = 1
            for base, e in image.factor()[1]:
                for _ in range(int(e)):
                    sums |= sums << base.degree()
            possible &= sums
            if possible == 1 | (1 << degree):
                return True
    return False


def _images(p: fmpz_mpoly, variable: int) -> Iterator[nmod_poly]:
    """Polynomials in the other variable, with one variable set to a small value, modulo each prime."""
    for value, prime in enumerate(PRIMES, 2):
        yield _image(p, variable, value, prime)


def _image(p: fmpz_mpoly, variable: int, value: int, prime: int) -> nmod_poly:
    coefficients = [0] * (int(p.degrees()[1 - variable]) + 1)
    for powers, x in p.to_dict().items():
        coefficients[powers[1 - variable]] += int(x % prime) * pow(value, powers[variable], prime)
    return nmod_poly([x % prime for x in coefficients], prime)


def _certainly_primitive(p: fmpz_mpoly, variable: int) -> bool:
    """Whether the coefficients, polynomials in one variable, certainly have no common factor: their images modulo a
    prime have no common factor, and one image keeps its degree.
    """
    rows: dict[int, dict[int, int]] = {}
    for powers, x in p.to_dict().items():
        rows.setdefault(powers[1 - variable], {})[powers[variable]] = int(x % PRIMES[0])
    images = [nmod_poly([row.get(k, 0) for k in range(max(row) + 1)], PRIMES[0]) for row in rows.values()]
    kept = any(image.degree() == max(row) for image, row in zip(images, rows.values(), strict=True))
    return kept and reduce(lambda f, g: f.gcd(g), images).degree() == 0


def _certainly_coprime_on_a_line(p: fmpq_mpoly, q: fmpq_mpoly) -> bool:
    """Whether two polynomials have no common factor on a line modulo a prime on which the first polynomial, and
    therefore each of its factors, keeps its total degree; False proves nothing.
    """
    if not affords((len(p) + len(q)) * p.context().nvars() * RESTRICTED, LONGEST_LOOP):
        return False
    one, other = _on_a_line(p), _on_a_line(q)
    if one is None or other is None or one.degree() != int(p.total_degree()):
        return False
    return bool(one.gcd(other).degree() == 0)


def _on_a_line(p: fmpq_mpoly) -> nmod_poly | None:
    """The values on a line modulo `PRIME`; None where a denominator vanishes."""
    line = [nmod_poly([(7 * i * i + 3) % 1009, (5 * i * i + i + 1) % 1013], PRIME) for i in range(len(p.degrees()))]
    powers = [list(accumulate([x] * int(d), lambda f, g: f * g)) for x, d in zip(line, p.degrees(), strict=True)]
    total = nmod_poly([], PRIME)
    for exponents, c in p.to_dict().items():
        below = int(c.q) % PRIME
        if not below:
            return None
        term = nmod_poly([int(c.p) * pow(below, -1, PRIME) % PRIME], PRIME)
        for i, e in enumerate(exponents):
            if e:
                term *= powers[i][int(e) - 1]
        total += term
    return total


def _certainly_without(p: fmpz_mpoly, q: fmpz_mpoly, variable: int) -> bool:
    """Whether the greatest common divisor certainly does not depend on the other variable; False proves nothing; a few
    images usually show that it does not.
    """
    for one, other in islice(zip(_images(p, variable), _images(q, variable), strict=True), FEW_IMAGES):
        if one.degree() == int(p.degrees()[1 - variable]) and one.gcd(other).degree() == 0:
            return True
    return False
