"""Naive semantics: quotients on which every operation is computed as in Table 1, without cancellation.

Two rationals whose denominators are structurally the same product (see `exactspline.language.provenance`) share it when
added; all others are cross-multiplied.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, Protocol, Self, TypeGuard, TypeVar, cast, overload

from exactspline.errors import DomainError, FormulaError
from exactspline.language.operand import (
    CONSTANTS,
    Components,
    Constant,
    Counted,
    D,
    D_co,
    HasDegree,
    Operand,
    OwnJoining,
    OwnProducts,
    OwnVectors,
    checked_order,
    larger,
)
from exactspline.language.provenance import same
from exactspline.language.vector import S, Vector, cross, perp
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Side
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import one_line

T = TypeVar("T", bound=Counted)

#: The largest number of factors of the denominator of a derivative: every differentiation doubles it.
MOST_FACTORS = 1024


class _Product(Generic[T]):
    """A denominator: a product of operands, expanded on first use; `factors` are the original operands."""

    __slots__ = ("_value", "factors", "parts")

    def __init__(self, *parts: T, factors: tuple[T, ...] | None = None) -> None:
        self.parts: tuple[T, ...] = parts
        self.factors: tuple[T, ...] = parts if factors is None else factors
        self._value: T | None = None

    def __mul__(self, other: _Product[T]) -> _Product[T]:
        return _Product(*self.unexpanded(), *other.unexpanded(), factors=self.factors + other.factors)

    def missing(self, other: _Product[T]) -> list[T]:
        """The factors of another product that this one lacks, with multiplicity."""
        rest = list(self.factors)
        lacking = []
        for factor in other.factors:
            index = next((i for i, present in enumerate(rest) if _agree(present, factor)), None)
            if index is None:
                lacking.append(factor)
            else:
                rest.pop(index)
        return lacking

    def unexpanded(self) -> tuple[T, ...]:
        """The factors that must be multiplied to obtain the value of the product."""
        return self.parts if self._value is None else (self._value,)

    def same(self, other: _Product[T]) -> bool:
        """Whether two denominators are structurally the same product."""
        return self is other or _agree(self.value, other.value)

    @property
    def value(self) -> T:
        """The expanded product."""
        if self._value is None:
            value = self.parts[0]
            for part in self.parts[1:]:
                value = value * part
            self._value = value
        return self._value


def _agree(a: Any, b: Any) -> bool:
    """Whether two factors have equal degree (checked first, because it is cheap), equal structure and equal value."""
    return a is b or bool(a.degree == b.degree and same(a.provenance, b.provenance) and a == b)


class _HasParts(Protocol[D_co]):
    """An object whose numerator and denominator have degrees of the same type."""

    @property
    def numerator(self) -> HasDegree[D_co]: ...
    @property
    def denominator(self) -> HasDegree[D_co]: ...


class Rational(Immutable, Operand, OwnProducts, OwnJoining, Generic[T]):
    """A quotient ``numerator / denominator`` of operands of one type: the numerator is a scalar or a `Vector`, the
    denominator is a scalar.

    Numerator and denominator have separate degrees; `degree` is the larger degree. Only the quotient rule elevates the
    numerator to the degree of the denominator. No factor is ever cancelled.

    >>> from exactspline import BSpline
    >>> t = BSpline.identity(0, 1)
    >>> r = (t + 1) / (t + 2)
    >>> r.d().degree, r.d()(0)
    (2, mpq(1,4))
    """

    __slots__ = ("numerator", "product")
    numerator: T | Vector[T]
    product: _Product[T]

    def __init__(self, numerator: T | Vector[T], denominator: T | _Product[T], *further: T) -> None:
        product = denominator if isinstance(denominator, _Product) else _Product(denominator, *further)
        fill(self, numerator=numerator, product=product)

    def __reduce__(self) -> tuple[object, ...]:
        return Rational, (self.numerator, self.product)

    @property
    def denominator(self) -> T:
        """The denominator, multiplied out."""
        return self.product.value

    @property
    def is_vector(self) -> bool:  # type: ignore[override]  # elsewhere an attribute of the class, here of the object
        """Whether the numerator is a vector."""
        return isinstance(self.numerator, Vector)

    @property
    def degree(self: _HasParts[D]) -> D:
        """The larger of the degrees of numerator and denominator."""
        return larger(self.numerator.degree, self.denominator.degree)

    @property
    def is_zero(self) -> bool:
        """Whether the numerator is identically zero."""
        return bool(self.numerator.is_zero)

    @property
    def vector(self) -> Vector[T]:
        """The numerator of a vector quotient.

        Raises `FormulaError` for a scalar quotient.
        """
        if isinstance(self.numerator, Vector):
            return self.numerator
        raise FormulaError("a scalar quotient was used as a vector", remedy="take components of vectors only")

    @property
    def scalar(self) -> T:
        """The numerator of a scalar quotient.

        Raises `FormulaError` for a vector quotient.
        """
        if isinstance(self.numerator, Vector):
            raise FormulaError("division by a vector", remedy="divide by a scalar")
        return self.numerator

    def with_numerator(self, change: Callable[[Vector[T]], Vector[T]]) -> Rational[T]:
        """Return the vector quotient with another numerator over the same denominator."""
        return Rational(change(self.vector), self.product)

    def __len__(self) -> int:
        return len(self.vector)

    def __getitem__(self, index: int) -> Rational[T]:
        return Rational(self.vector[index], self.product)

    @one_line
    def __repr__(self) -> str:
        return f"Rational({self.numerator!r}, {self.denominator!r})"

    def __call__(self, *place: Number, **side: Side | str) -> mpq | tuple[mpq, ...]:
        """Return the value at one or two parameters: an exact number, or a tuple of exact numbers for a vector. If a
        side is given, the value is the limit from this side. Raises `ZeroDivisionError` at a pole.
        """
        return self.point(*place, **side) if self.is_vector else self.number(*place, **side)

    def point(self, *place: Number, **side: Side | str) -> tuple[mpq, ...]:
        """Return the value of a vector quotient.

        Raises `FormulaError` for a scalar quotient, `ZeroDivisionError` at a pole.
        """
        functions: Any = self.vector
        denominator: Any = self.denominator
        w = denominator(*place, **side)
        return tuple(a(*place, **side) / w for a in functions)

    def number(self, *place: Number, **side: Side | str) -> mpq:
        """Return the value of a scalar quotient.

        Raises `FormulaError` for a vector, `ZeroDivisionError` at a pole.
        """
        numerator: Any = self.scalar
        denominator: Any = self.denominator
        return cast(mpq, numerator(*place, **side) / denominator(*place, **side))

    def __eq__(self, other: object) -> bool:
        """Whether two quotients are the same function, decided by cross-multiplication, so that common factors do not
        matter.

        If a denominator vanishes identically, even if only on one segment, the quotient is not a function and equals
        nothing, not even itself. A quotient equals a spline (or vector of splines) that is the same function.

        >>> from exactspline import BSpline
        >>> t = BSpline.identity(0, 1)
        >>> t * t / t == t / 1, t * t / t == (t * t * t) / (t * t), (t - t) / (t - t) == t / (t + 1)
        (True, True, False)
        """
        if isinstance(other, Rational):
            if self.is_vector != other.is_vector:
                return NotImplemented
            numerator, denominator = other.numerator, other.denominator
            if denominator.vanishes_somewhere:
                return False
        elif self._can_be(other):
            numerator, denominator = other, self.denominator.constant(1)
        else:
            return NotImplemented
        if self.denominator.vanishes_somewhere:
            return False
        try:
            return bool(self.numerator * denominator == numerator * self.denominator)
        except DomainError:  # functions over different domains
            return False

    def _can_be(self, other: object) -> TypeGuard[Any]:
        """Whether an object that is not a quotient is a scalar or vector of the same reading."""
        parts = other.components if isinstance(other, Vector) else (other,)
        operand_type = type(self.denominator)
        return (
            operand_type.equals_quotients
            and self.is_vector == isinstance(other, Vector)
            and all(isinstance(part, operand_type) for part in parts)
        )

    def __hash__(self) -> int:
        if self.is_vector:  # the hash of the vector of the components, since the quotient is equal to that vector
            return hash(tuple(self[i] for i in range(len(self))))
        return self.denominator.hash_of_quotient(self.scalar)

    def __add__(self, other: object) -> Rational[T]:
        """The sum by rows T4 and T5 of Table 1."""
        p: Any = self.numerator
        if not isinstance(other, Rational):
            return Rational(p + self.denominator * cast(Any, other), self.product) if _fits(other) else NotImplemented
        if self.product.same(other.product):
            return Rational(p + other.numerator, self.product)
        return Rational(p * other.denominator + other.numerator * self.denominator, self.product * other.product)

    def scaled(self, constant: Constant) -> Rational[T]:
        """Return the quotient times an exact constant."""
        return Rational(self.numerator.scaled(constant), self.product)

    def constant(self, value: Constant) -> Rational[T]:
        """Return an exact constant as a quotient with the denominator 1."""
        one = self.denominator.constant(1)
        return Rational(one.scaled(value), one)

    def __mul__(self, other: object) -> Rational[T]:
        """The product by rows T6 and T7 of Table 1."""
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if isinstance(other, Rational):
            return Rational(_times(self.numerator, other.numerator), self.product * other.product)
        return Rational(_times(self.numerator, other), self.product) if _fits(other) else NotImplemented

    def __truediv__(self, other: object) -> Rational[T]:
        """The quotient by rows T8 and T9 of Table 1."""
        if isinstance(other, CONSTANTS):
            return self.scaled(1 / mpq(other))
        if isinstance(other, Rational):
            return Rational(self.numerator * other.denominator, self.product * _Product(other.scalar))
        if not isinstance(other, Operand):
            return NotImplemented
        factor: Any = other
        return Rational(self.numerator, self.product * _Product(factor))

    def dividing(self, numerator: object) -> Rational[T]:
        """Return the quotient of `numerator`, an operand or a vector that is not a quotient, by this quotient."""
        top: Any = numerator
        return Rational(top * self.denominator, self.scalar)

    def times_vector(self, vector: Components) -> Rational[T]:
        """Return the product with a vector as one quotient."""
        untyped: Any = vector
        return Rational(untyped * self.scalar, self.product)

    def __rtruediv__(self, other: object) -> Rational[T]:
        if isinstance(other, CONSTANTS):
            other = self.denominator.constant(other)
        return self.dividing(cast(Operand, other)) if _fits(other) else NotImplemented

    def d(self, order: int = 1, *, by: str | None = None) -> Rational[T]:
        """Return the derivative of the given order, by `order` applications of the quotient rule ``(p'w - p w') / (w
        w)`` (row T17 of the paper's Table 1).

        No factor is cancelled, so that the degree of the denominator doubles each time. Raises `FormulaError` if the
        denominator would be a product of more than `MOST_FACTORS` factors.
        """
        result = self
        factors = len(self.product.factors) << min(checked_order(order), MOST_FACTORS.bit_length())
        if factors > MOST_FACTORS:
            raise FormulaError(
                f"a derivative of order {order} whose denominator is a product of more than {MOST_FACTORS} factors",
                remedy="every derivative squares the denominator: take lower orders, or derivatives of its parts",
            )
        for _ in range(order):
            p: Any = result.numerator
            w = result.denominator
            product = _Product(w, w, factors=result.product.factors * 2)
            result = Rational((p.d(1, by=by) * w - p * w.d(1, by=by)).elevated_to(product.value), product)
        return result

    def levelled(self, other: object) -> tuple[Rational[T], Rational[T]]:
        """Return this quotient and another value, both expanded to a common denominator."""
        if not isinstance(other, Rational):
            return self, Rational(cast(Any, other) * self.denominator, self.product)
        mine, its = self.product.missing(other.product), other.product.missing(self.product)
        shared = (
            _Product(*self.product.unexpanded(), *mine, factors=(*self.product.factors, *mine))
            if mine
            else self.product
        )
        return Rational(_all_times(self.numerator, mine), shared), Rational(_all_times(other.numerator, its), shared)

    def multilinear(self, function: Callable[..., object], vectors: tuple[object, ...]) -> Rational[T]:
        """Return a multilinear product of vectors: the product of the numerators divided by the product of the
        denominators.
        """
        numerators = [v.numerator if isinstance(v, Rational) else v for v in vectors]
        first, *rest = [v.product for v in vectors if isinstance(v, Rational)]
        for product in rest:
            first = first * product
        return Rational(function(*numerators), first)

    def joining(self, parts: tuple[object, ...]) -> Rational[T]:
        """Return one quotient with the components of all parts and a common denominator."""
        one = self.denominator.constant(1)
        first, *rest = [one.scaled(part) if isinstance(part, CONSTANTS) else part for part in parts]
        joined, product = _components(first), first.product if isinstance(first, Rational) else _Product(one)
        for part in rest:
            denominator = part.product if isinstance(part, Rational) else _Product(one)
            if not isinstance(part, Rational):
                joined += [a * product.value for a in _components(part)]
            elif denominator.same(product):
                joined += _components(part)
            else:
                joined = [a * denominator.value for a in joined] + [a * product.value for a in _components(part)]
                product = product * denominator
        return Rational(Vector(*joined), product)

    def elevated(self) -> tuple[T | Vector[T], T]:
        """Return the numerator and the denominator elevated to the same degree, as required for the control points and
        weights of a NURBS.
        """
        w = highest = self.denominator
        for x in self.numerator if isinstance(self.numerator, Vector) else [self.numerator]:
            highest = highest.elevated_to(x)
        return self.numerator.elevated_to(highest), w.elevated_to(highest)

    def elevated_to(self, other: T) -> Rational[T]:  # type: ignore[override]  # a numerator has the degree of an operand
        """Return the same quotient, with the numerator elevated to at least the degree of `other`."""
        return Rational(self.numerator.elevated_to(other), self.product)


class RingOperand(Operand):
    """An operand without true quotients: division by it returns a `Rational`, which is row T3 of Table 1."""

    __slots__ = ()

    @overload
    def __truediv__(self, other: Constant) -> Self: ...
    @overload
    def __truediv__(self: T, other: T) -> Rational[T]: ...
    @overload
    def __truediv__(self, other: Operand) -> Operand: ...
    def __truediv__(self, other: object) -> object:
        if isinstance(other, CONSTANTS):
            return self.scaled(1 / mpq(other))
        return other.dividing(self) if isinstance(other, Operand) else NotImplemented

    def dividing(self: T, numerator: object) -> Rational[T]:
        """Return the quotient of `numerator`, an operand or a vector of operands, by this operand."""
        return Rational(cast("T | Vector[T]", numerator), self)


def _components(value: Any) -> list[Any]:
    """The components of a vector, or a scalar as the only component; for a quotient, those of its numerator."""
    value = value.numerator if isinstance(value, Rational) else value
    return list(value) if isinstance(value, Vector) else [value]


def _fits(other: object) -> bool:
    return isinstance(other, (Operand, Vector, *CONSTANTS))


def _all_times(a: Any, factors: list[Any]) -> Any:
    return a * _Product(*factors).value if factors else a


def _times(a: Any, b: Any) -> Any:
    return b * a if isinstance(b, Vector) else a * b


# ---- linear systems


def cramer(*rows: tuple[Vector[S], S]) -> Vector[S]:
    """The numerators of Cramer's rule, eq. (23) of the paper, as one vector: divided by the determinant of the normals,
    they are the point B with ``normal · B = height`` for each row.

    Each row is a pair of a normal and a height: three planes in space, or two lines in the plane.

    >>> from exactspline.language import Vector
    >>> cramer((Vector(1, 0, 0), 5), (Vector(0, 2, 0), 6), (Vector(0, 0, 1), 7))
    Vector(10, 6, 14)
    """
    if len(rows) == 2:
        (a, h), (b, k) = rows
        return perp(a) * k - perp(b) * h
    (a, h), (b, k), (c, m) = rows
    return cross(b, c) * h + cross(c, a) * k + cross(a, b) * m


def level(normal: Vector[S], height: S) -> tuple[Vector[S], S]:
    """A row of a linear system brought to a common denominator: the step that §6 of the paper takes before it applies
    Cramer's rule.

    Values that are not quotients are returned unchanged.
    """
    given: tuple[object, object] = (normal, height)
    if isinstance(given[0], (Rational, OwnVectors)):
        given = given[0].levelled(height)
    elif isinstance(given[1], Rational):
        second, first = given[1].levelled(normal)
        given = first, second
    return cast("tuple[Vector[S], S]", given)
