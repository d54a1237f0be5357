"""The jet reading: the curve is indeterminate, its derivatives are the variables x, x′, x″, …, w, w′, ….

The value of a formula is a differential polynomial over the rationals. If two of them are equal, the formulas agree for
every curve of every degree, so that an equality here is a proof for all curves. A polynomial homogeneous of degree k
and of weight m (number of primes) has nominal B-spline degree ``kd − m``.

The same curve with another parameter t is read with ``ρ = ds/dt``: derivatives are ``d/dt = ρ d/ds``. ρ is an
independent function, so that statements proved in this reading hold for every change of parameter.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any, cast

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from flint.utils.flint_exceptions import DomainError

from exactspline.errors import FormulaError, VanishingDivisorError, counted
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Reading
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant, FieldOperand, Parameter, refuse_letter
from exactspline.language.provenance import DERIVATIVE, DIFFERENCE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, leaf
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import Number, from_flint, mpq, rational, to_fmpq
from exactspline.one_line import OneLine, one_line
from exactspline.polynomials.factors import bounded_product, greatest_common_divisor, superscript

PRIMES = ("", "′", "″", "‴")
#: The largest number of indeterminates: every term stores an exponent for each, and FLINT ends the process if it lacks
#: memory.
MOST_VARIABLES = 4000


#: The terms of a polynomial: exponents, numerator and denominator of each.
Terms = tuple[tuple[tuple[int, ...], int, int], ...]


def terms_of(polynomial: fmpq_mpoly) -> Terms:
    """The terms as integers, because FLINT's polynomials cannot be pickled."""
    return tuple((tuple(map(int, exponents)), int(c.p), int(c.q)) for exponents, c in polynomial.to_dict().items())


class JetRing(OneLine):
    """Polynomials in the derivatives up to `order` of the operands of a kind of argument, and in its constants.

    >>> from exactspline.language.kinds import CURVE
    >>> ring = JetRing(CURVE, 2, 2)
    >>> (ring["x"].d() * ring["w"] - ring["x"] * ring["w"].d()).d()
    x″·w − x·w″

    A function of several parameters has a variable for each partial derivative.

    >>> from exactspline.language.kinds import SURFACE
    >>> ring = JetRing(SURFACE, 3, 2)
    >>> (ring["x"].d(1, by="u") * ring["w"]).d(1, by="v")
    x_uv·w + x_u·w_v
    """

    def __init__(self, kind: Kind, dimension: int, order: int, *, polynomial: bool = False) -> None:
        self.kind, self.dimension, self.order, self.polynomial = kind, dimension, order, polynomial
        self.parameters = kind.parameters(dimension)
        self.symbols = {s.name: s for s in kind.symbols(dimension, polynomial=polynomial)}
        self.rules = {n: rule for n, rule in kind.rules(dimension).items() if n in self.symbols}
        free = [symbol for name, symbol in self.symbols.items() if symbol.parameters and name not in self.rules]
        self.constants = tuple(name for name, symbol in self.symbols.items() if not symbol.parameters)
        self.variables = [(s.name, orders) for s in free for orders in _orders_up_to(order, len(s.parameters))]
        self.variables += [(name, (0,)) for name in (*self.rules, *self.constants)]
        if len(self.variables) > MOST_VARIABLES:
            problem = f"derivatives of order {order}, {len(self.variables)} indeterminates"
            raise FormulaError(problem, remedy=f"at most {MOST_VARIABLES} are allowed: take derivatives of lower order")
        names = [name + "_".join(map(str, orders)) for name, orders in self.variables]
        self.context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        self.gens = self.context.gens()
        self.index = {variable: i for i, variable in enumerate(self.variables)}
        #: Polynomials that have occurred as repeated factors: a factor of a sum is usually one of these (see
        #: `exactspline.readings.factored_jet`).
        self.repeated: list[fmpq_mpoly] = []
        self._ruled: dict[str, fmpq_mpoly] = {}

    def __reduce__(self) -> tuple[object, ...]:
        return _ring, self._made_of

    def __eq__(self, other: object) -> bool:
        """Whether two rings consist of the same polynomials."""
        return isinstance(other, JetRing) and self._made_of == other._made_of

    def __hash__(self) -> int:
        return hash(self._made_of)

    @property
    def _made_of(self) -> tuple[Kind, int, int, bool]:
        return self.kind, self.dimension, self.order, self.polynomial

    def of_terms(self, terms: Terms) -> fmpq_mpoly:
        """The polynomial with these terms (see `terms_of`)."""
        return self.context.from_dict({e: fmpq(p, q) for e, p, q in terms})

    def __getitem__(self, name: str) -> Jet:
        parameters = 1 if name in self.rules else max(len(self.symbols[name].parameters), 1)
        return Jet(self, self.gens[self.index[name, (0,) * parameters]])

    def number(self, value: Number) -> Jet:
        """An exact constant."""
        return Jet(self, self.context.constant(to_fmpq(rational(value))), (MULTIPLE, UNIT, rational(value)))

    def derivative(self, i: int, by: str | None) -> fmpq_mpoly | None:
        """The derivative of the i-th variable: the next variable, or by the rule of the kind of argument; None if it
        does not depend on the parameter.

        Raises `FormulaError` if the ring does not contain it, and for a function of several parameters if none is
        named.
        """
        name, orders = self.variables[i]
        parameters = self.symbols[name].parameters
        if by is None and len(parameters) > 1:
            by = self._only_parameter(name, parameters)
        if not parameters or by not in (None, *parameters, *([Parameter.FIRST] if self.kind.composed else [])):
            return None
        if name in self.rules:
            if name not in self._ruled:
                self._ruled[name] = cast(Jet, self.rules[name]({each: self[each] for each in self.symbols})).polynomial
            return self._ruled[name]
        if by is None or by in parameters:
            return self._next(name, orders, 0 if by is None else parameters.index(Parameter(by)))
        terms = [(self._next(name, orders, k), self[self.kind.composed[p]].d()) for k, p in enumerate(parameters)]
        return sum((partial * pace.polynomial for partial, pace in terms), self.context.constant(0))

    def _only_parameter(self, name: str, parameters: tuple[Parameter, ...]) -> str:
        if self.kind.composed:
            return Parameter.FIRST
        problem = f"the derivative of {name}, a function of {' and '.join(parameters)}"
        raise FormulaError(problem, remedy=f"name one of them: d(1, by={str(parameters[0])!r})")

    def lowered(self, i: int, parameter: Parameter) -> int:
        """The index of the variable whose derivative with respect to the parameter is the i-th variable."""
        name, orders = self.variables[i]
        which = self.symbols[name].parameters.index(parameter)
        return self.index[name, tuple(n - 1 if k == which else n for k, n in enumerate(orders))]

    def _next(self, name: str, orders: tuple[int, ...], which: int) -> fmpq_mpoly:
        """The variable with one order increased."""
        raised = tuple(n + 1 if k == which else n for k, n in enumerate(orders))
        if (name, raised) not in self.index:
            raise FormulaError(
                f"the derivative of order {sum(raised)} of {name}", remedy=f"make the jet ring of order {sum(raised)}"
            )
        return self.gens[self.index[name, raised]]

    def primes(self, i: int) -> str:
        """The notation for the i-th variable."""
        name, orders = self.variables[i]
        symbol = self.symbols[name]
        return symbol.text + derivative_mark(symbol.parameters, orders)


def _orders_up_to(order: int, parameters: int) -> list[tuple[int, ...]]:
    """The orders of derivatives in this many parameters, up to a total order.

    >>> _orders_up_to(2, 1), _orders_up_to(1, 2)
    ([(0,), (1,), (2,)], [(0, 0), (1, 0), (0, 1)])
    """
    orders_found = (orders for orders in product(range(order, -1, -1), repeat=parameters) if sum(orders) <= order)
    return sorted(orders_found, key=sum)


def derivative_mark(parameters: Sequence[str], orders: Sequence[int]) -> str:
    """The notation for a derivative: primes, or the letters of the parameters.

    >>> derivative_mark(("s",), (2,)), derivative_mark(("u", "v"), (2, 1)), derivative_mark((), (0,))
    ('″', '_uuv', '')
    """
    if len(parameters) < 2:
        order = sum(orders)
        return PRIMES[order] if order < len(PRIMES) else f"⁽{superscript(order)}⁾"
    letters = "".join(letter * n for letter, n in zip(parameters, orders, strict=True))
    return f"_{letters}" if letters else ""


def only_grading(gradings: set[tuple[int, int]]) -> tuple[int, int]:
    """The degree and the weight that all terms of a polynomial have; raises `FormulaError` if they differ."""
    if len(gradings) != 1:
        problem = f"a polynomial with the gradings {sorted(gradings)}"
        raise FormulaError(problem, remedy="degree and weight are defined only for homogeneous polynomials")
    return gradings.pop()


class Jet(RingOperand):
    """A differential polynomial."""

    __slots__ = ("polynomial", "provenance", "ring")

    def __init__(self, ring: JetRing, polynomial: fmpq_mpoly, provenance: Provenance | None = None) -> None:
        self.ring, self.polynomial, self.provenance = ring, polynomial, leaf() if provenance is None else provenance

    def __reduce__(self) -> tuple[object, ...]:
        return _jet, (self.ring, terms_of(self.polynomial))

    def constant(self, value: Constant) -> Jet:
        """An exact constant of the ring."""
        return self.ring.number(value)

    def _plus(self, right: Jet) -> Jet:
        return Jet(self.ring, self.polynomial + right.polynomial, (SUM, self.provenance, right.provenance))

    def __sub__(self, other: object) -> Jet:
        right = self.coerced(other)
        if right is None:
            return NotImplemented
        return Jet(self.ring, self.polynomial - right.polynomial, (DIFFERENCE, self.provenance, right.provenance))

    def _times(self, right: Jet) -> Jet:
        product = bounded_product(self.polynomial, right.polynomial)
        return Jet(self.ring, product, (PRODUCT, self.provenance, right.provenance))

    def scaled(self, constant: Constant) -> Jet:
        """The polynomial times an exact constant."""
        return Jet(self.ring, self.polynomial * to_fmpq(rational(constant)), (MULTIPLE, self.provenance, mpq(constant)))

    def d(self, order: int = 1, *, by: str | None = None) -> Jet:
        """The total derivative, or the derivative with respect to one parameter.

        Raises `FormulaError` if the ring lacks a required variable, and for a parameter that it does not have.
        """
        ring, result, provenance = self.ring, self.polynomial, self.provenance
        refuse_letter(by, ring.parameters)
        for _ in range(order):
            total = ring.context.constant(0)
            for i, used in enumerate(result.degrees()):
                if int(used) > 0 and (derivative := ring.derivative(i, by)) is not None:
                    total += result.derivative(i) * derivative
            result, provenance = total, (DERIVATIVE, provenance)
        return Jet(ring, result, provenance)

    @property
    def degree(self) -> int:
        """Degree k in the curve."""
        return self.grading[0]

    @property
    def grading(self) -> tuple[int, int]:
        """Degree k in the functions and weight m (number of primes); raises `FormulaError` if it is not homogeneous in
        both.
        """
        orders = [sum(k) for _, k in self.ring.variables]
        functions = len(self.ring.variables) - len(self.ring.constants)
        monomials = ([int(x) for x in m] for m in self.polynomial.monoms())
        gradings = {(sum(e[:functions]), sum(x * k for x, k in zip(e, orders, strict=True))) for e in monomials}
        return only_grading(gradings)

    @property
    def is_zero(self) -> bool:
        """Whether the value is the zero polynomial, that is zero on every curve."""
        return not self.polynomial

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Jet) and self.polynomial == other.polynomial

    def __hash__(self) -> int:
        return hash(str(self.polynomial))

    @one_line
    def __repr__(self) -> str:
        return polynomial_text(self)


def polynomial_text(jet: Jet, limit: int = 12) -> str:
    """The polynomial as text, truncated after `limit` terms."""
    p, count = jet.polynomial, len(jet.polynomial)
    if not count:
        return "0"
    terms = [(p.monomial(i), p.coefficient(i)) for i in range(min(limit, count))]
    text = " ".join([_term_text(jet.ring, exponents, from_flint(c)) for exponents, c in terms]).removeprefix("+ ")
    return (text if not text.startswith("− ") else "−" + text[2:]) + (
        f" + … ({counted(count, 'term')})" if count > limit else ""
    )


def _term_text(ring: JetRing, exponents: Any, c: mpq) -> str:
    factors = [ring.primes(i) + (superscript(int(e)) if e > 1 else "") for i, e in enumerate(exponents) if e]
    if abs(c) != 1 or not factors:
        factors.insert(0, str(abs(c)))
    return ("− " if c < 0 else "+ ") + "·".join(factors)


def _ring(kind: Kind, dimension: int, order: int, polynomial: bool) -> JetRing:
    """Unpickles a ring."""
    return JetRing(kind, dimension, order, polynomial=polynomial)


def _jet(ring: JetRing, terms: Terms) -> Jet:
    """Unpickles a polynomial, with a new provenance, because numbers of leaves have no meaning in another process."""
    return Jet(ring, ring.of_terms(terms))


class IndeterminateReading(Reading):
    """A reading in which the operands, and their derivatives up to an order, are indeterminate."""

    def __init__(self, order: int) -> None:
        self.order = order


class JetReading(IndeterminateReading):
    """The reading whose operands, and their derivatives up to an order, are indeterminates (jets).

    >>> from exactspline.language.kinds import PAIR
    >>> c = JetReading(1).argument(PAIR, 3)
    >>> c.first.p[0] * c.second.w.d(1)
    x·w̄′
    """

    name = "jet"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """Return the argument in which every operand is an indeterminate. A polynomial curve has the denominator 1."""
        ring = JetRing(kind, dimension, self.order, polynomial=polynomial)
        return kind.argument(dimension, lambda symbol: ring[symbol.name], ring.number(1), polynomial=polynomial)


# ---- quotients of jets
#
# The jet reading computes by the naive algorithm; the reading of quotients computes the function itself and cancels
# common factors after every operation. This proves identities between large naive expressions without expanding them.


#: Numerators with more terms are long.
LONG = 1000


class JetFraction(FieldOperand):
    """``top / bottom`` without common factors, with monic `bottom`.

    >>> from exactspline.language.kinds import CURVE

    >>> from exactspline.readings.jet import RationalJetReading

    >>> c = RationalJetReading(1).argument(CURVE, 2)
    >>> (c.gamma[0] * c.w).top == c.p[0].top
    True
    """

    __slots__ = ("bottom", "ring", "top")
    degree = provenance = 0

    def __init__(self, ring: JetRing, top: fmpq_mpoly, bottom: fmpq_mpoly) -> None:
        self.ring, self.top, self.bottom = ring, top, bottom

    def __reduce__(self) -> tuple[object, ...]:
        return _fraction, (self.ring, terms_of(self.top), terms_of(self.bottom))

    def constant(self, value: Constant) -> JetFraction:
        """An exact constant."""
        return JetFraction(self.ring, self.ring.number(value).polynomial, self.ring.context.constant(1))

    def _plus(self, right: JetFraction) -> JetFraction:
        if self.bottom.is_one() and right.bottom.is_one():
            return JetFraction(self.ring, self.top + right.top, self.bottom)
        if self.bottom == right.bottom:
            return JetFraction(self.ring, *_without_common(self.top + right.top, self.bottom))
        if self.bottom.is_one() or right.bottom.is_one():
            # this denominator has no common factor with the other one
            top = bounded_product(self.top, right.bottom) + bounded_product(right.top, self.bottom)
            return JetFraction(self.ring, top, bounded_product(self.bottom, right.bottom))
        shared = _gcd(self.bottom, right.bottom)
        mine, its = self.bottom / shared, right.bottom / shared
        top, rest = _without_common(bounded_product(self.top, its) + bounded_product(right.top, mine), shared)
        return JetFraction(self.ring, top, bounded_product(bounded_product(mine, its), rest))

    def _times(self, right: JetFraction) -> JetFraction:
        if self.bottom.is_one() and right.bottom.is_one():
            return JetFraction(self.ring, bounded_product(self.top, right.top), self.bottom)
        if self is right:
            return JetFraction(self.ring, *(bounded_product(part, part) for part in (self.top, self.bottom)))
        first, below = _without_common(self.top, right.bottom)
        second, beneath = _without_common(right.top, self.bottom)
        return JetFraction(self.ring, bounded_product(first, second), bounded_product(beneath, below))

    def reciprocal(self) -> JetFraction:
        """``1 / a``; raises `VanishingDivisorError` for zero."""
        if not self.top:
            raise VanishingDivisorError(
                "division by an expression that vanishes identically", remedy="check the formula"
            )
        unit = self.top.leading_coefficient()
        return JetFraction(self.ring, self.bottom / unit, self.top / unit)

    def scaled(self, constant: Constant) -> JetFraction:
        """The fraction times an exact constant."""
        factor = to_fmpq(rational(constant))
        return JetFraction(self.ring, self.top * factor, self.bottom if factor else self.ring.context.constant(1))

    def _first_derivative(self, by: str | None) -> JetFraction:
        """The total derivative."""
        top, bottom = Jet(self.ring, self.top), Jet(self.ring, self.bottom)
        if self.bottom.is_one():
            return JetFraction(self.ring, top.d(by=by).polynomial, self.bottom)
        numerator = (top.d(by=by) * bottom - top * bottom.d(by=by)).polynomial
        shared = _gcd(numerator, self.bottom)
        rest = self.bottom / shared
        again = _gcd(numerator / shared, self.bottom)
        return JetFraction(self.ring, numerator / shared / again, bounded_product(rest, self.bottom / again))

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return not self.top

    @property
    def is_long(self) -> bool:
        """Whether products of such values are too long to be multiplied out one after another."""
        return len(self.top) > LONG

    def __eq__(self, other: object) -> bool:
        """Whether two values are the same quotient. Values of this reading are in lowest terms, so that equal values
        have equal representations. Different representations are still compared by cross-multiplication, unless their
        values at one point differ.
        """
        if not isinstance(other, JetFraction):
            return False
        if self.bottom == other.bottom:
            return bool(self.top == other.top)
        if self._at_a_point(other.bottom) != other._at_a_point(self.bottom):
            return False
        return bool(bounded_product(self.top, other.bottom) == bounded_product(other.top, self.bottom))

    def _at_a_point(self, factor: fmpq_mpoly) -> fmpq:
        """The numerator times a polynomial, at one point of small integers."""
        point = range(2, 2 + len(self.ring.gens))
        return self.top(*point) * factor(*point)

    __hash__ = None  # type: ignore[assignment]  # not hashable

    @one_line
    def __repr__(self) -> str:
        return f"({Jet(self.ring, self.top)!r}) / ({Jet(self.ring, self.bottom)!r})"


def _fraction(ring: JetRing, top: Terms, bottom: Terms) -> JetFraction:
    """Unpickles a fraction."""
    return JetFraction(ring, ring.of_terms(top), ring.of_terms(bottom))


def _without_common(top: fmpq_mpoly, bottom: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """Two polynomials divided by their greatest common divisor."""
    if bottom.is_one():
        return top, bottom
    common = _gcd(top, bottom)
    return (top, bottom) if common.is_one() else (top / common, bottom / common)


def _gcd(a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
    """The monic greatest common divisor (of 0 and b: b made monic)."""
    return b / b.leading_coefficient() if len(a) >= len(b) and _divides(b, a) else greatest_common_divisor([a, b])


def _divides(b: fmpq_mpoly, a: fmpq_mpoly) -> bool:
    """Whether b divides a. A negative answer usually follows from the first terms, far cheaper than a gcd."""
    try:
        a / b
    except (DomainError, ZeroDivisionError):
        return False
    return True


class RationalJetReading(IndeterminateReading):
    """Arguments with indeterminate operands; quotients are in lowest terms."""

    name = "rational jet"

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument in which every operand is an indeterminate."""
        ring = JetRing(kind, dimension, self.order, polynomial=polynomial)

        def fraction(x: Jet) -> JetFraction:
            return JetFraction(ring, x.polynomial, ring.context.constant(1))

        one = fraction(ring.number(1))
        return kind.argument(dimension, lambda symbol: fraction(ring[symbol.name]), one, polynomial=polynomial)


class InOtherParameter(FieldOperand):
    """An operand of a reading with division, differentiated with respect to another parameter.

    >>> from exactspline.language.kinds import kind_of
    >>> from exactspline.readings.jet import RationalJetReading
    >>> c = RationalJetReading(2).argument(kind_of("plane with rho"), 2)
    >>> InOtherParameter(c.p[0], c.rho).d(2).value == c.p[0].d(2) * c.rho * c.rho
    True
    """

    __slots__ = ("speed", "value")
    degree = provenance = 0

    def __init__(self, value: FieldOperand, speed: FieldOperand) -> None:
        self.value, self.speed = value, speed

    def _made(self, value: FieldOperand) -> InOtherParameter:
        return InOtherParameter(value, self.speed)

    def constant(self, value: Constant) -> InOtherParameter:
        """An exact constant."""
        return self._made(self.value.constant(value))

    def _plus(self, right: InOtherParameter) -> InOtherParameter:
        return self._made(self.value + right.value)

    def _times(self, right: InOtherParameter) -> InOtherParameter:
        return self._made(self.value * right.value)

    def reciprocal(self) -> InOtherParameter:
        """``1 / a``."""
        return self._made(self.value.reciprocal())

    def scaled(self, constant: Constant) -> InOtherParameter:
        """The operand times an exact constant."""
        return self._made(self.value.scaled(constant))

    def _first_derivative(self, by: str | None) -> InOtherParameter:
        """The derivative with respect to the other parameter."""
        return self._made(self.value.d(1, by=by) * self.speed)

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve."""
        return bool(self.value.is_zero)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, InOtherParameter) and bool(self.value == other.value)

    __hash__ = None  # type: ignore[assignment]  # not hashable
