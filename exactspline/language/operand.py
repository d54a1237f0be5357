"""Operands: the common interface of the scalars of all readings, as protocols and as a base class."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from enum import StrEnum
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self, TypeVar, cast, overload

from exactspline.errors import FormulaError, shown
from exactspline.hooks import Displayed
from exactspline.numbers.exact import mpq, mpz

if TYPE_CHECKING:
    from exactspline.language.provenance import Provenance


# ---- what users choose from


class Parameter(StrEnum):
    """A parameter: of a curve or the first of two curves; of the second curve; the two parameters of a surface."""

    FIRST = "s"
    SECOND = "s̄"
    U = "u"
    V = "v"


class Counting(StrEnum):
    """How nominal degrees are counted: as in Table 1, or part by part, as in (24)."""

    TABLE_1 = "Table 1"
    PART_BY_PART = "part by part"


#: The constants that may occur in a formula.
Constant = int | mpz | mpq | Fraction
CONSTANTS = (int, type(mpz()), type(mpq()), Fraction)
#: The highest order of a derivative that can be requested.
MOST_DERIVATIVES = 1000
#: The largest exponent of a power, which is multiplied factor by factor.
MOST_POWER = 10_000


D_co = TypeVar("D_co", covariant=True)


class Scalar(Protocol):
    """The operations that products of vectors require of a component; exact numbers and operands have them."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __neg__(self) -> Self: ...


class _Ring(Protocol):
    """The operations that a formula requires of an operand: those of a differential ring over the exact constants."""

    @property
    def is_zero(self) -> bool:
        """Whether the operand vanishes identically."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __neg__(self) -> Self: ...

    def scaled(self, constant: Constant, /) -> Self:
        """The operand times an exact constant."""

    def constant(self, value: Constant, /) -> Self:
        """An exact constant of the ring."""

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The derivative of an order, by the only parameter or by the one that is named."""


class Counted(_Ring, Protocol):
    """The additional operations required by naive semantics (Table 1): a degree, elevation, and provenance."""

    @property
    def degree(self) -> object:
        """The nominal degree: a number, a pair of numbers, or an expression."""

    @property
    def provenance(self) -> Provenance:
        """How the operand was computed (see `exactspline.language.provenance`)."""

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether the operand is identically zero on at least one segment."""

    def elevated_to(self, other: Self, /) -> Self:
        """The same function, elevated to at least the degree of another operand."""

    equals_quotients: ClassVar[bool]

    def hash_of_quotient(self, numerator: Self) -> int:
        """A hash of the quotient by this operand, the same for equal quotients."""


class Components(Protocol):
    """The operations that an operand requires of a vector of operands."""

    def mapped(self, change: Callable[[Operand], Operand], /) -> object:
        """The vector of the images of its components."""


class Dividing(Protocol[D_co]):
    """An object by which a vector can be divided."""

    def dividing(self, numerator: object, /) -> D_co:
        """A vector divided by this."""


class HasDegree(Protocol[D_co]):
    """An object with a degree: a number, a pair of numbers, or an expression."""

    @property
    def degree(self) -> D_co:
        """The degree."""


R = TypeVar("R", bound=_Ring)
C = TypeVar("C", bound=Counted)
D = TypeVar("D")


def checked_order(order: object) -> int:
    """The order of a derivative as given by a user; raises `FormulaError` unless it is an int from 0 to
    `MOST_DERIVATIVES`.
    """
    if type(order) is not int or not 0 <= order <= MOST_DERIVATIVES:
        raise FormulaError(f"a derivative of order {shown(order)}", remedy=f"orders are 0, 1, 2, …, {MOST_DERIVATIVES}")
    return order


class Operand(Displayed, ABC):
    """The base class of the scalars of all readings: a reading implements the abstract methods, the rest follows.

    A reading with true quotients is a `FieldOperand`; where ``/`` makes a `Rational`, it is a
    `exactspline.language.rational.RingOperand`.
    """

    __slots__ = ()
    #: Whether the operand is a vector (some readings use one class for scalars and vectors).
    is_vector: bool = False
    #: The parameter of an operand with only one parameter.
    parameter: ClassVar[str] = "s"
    #: Whether an operand equals, and has the same hash as, quotients that represent the same function.
    equals_quotients: ClassVar[bool] = False

    @property
    def is_zero(self) -> bool:
        """Whether the operand vanishes identically. Raises `FormulaError` if this cannot be decided."""
        problem = f"whether a {type(self).__name__} vanishes cannot be decided"
        raise FormulaError(problem, remedy="use a reading that has values, such as jets or splines")

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether the operand is identically zero on at least one segment."""
        return bool(self.is_zero)

    def hash_of_quotient(self, numerator: Self) -> int:
        """Return a hash of the quotient of `numerator` by this operand; equal quotients have the same hash."""
        return 1

    def __add__(self, other: Self | Constant, /) -> Self:
        right = self.coerced(other)
        return NotImplemented if right is None else self._plus(right)

    def __mul__(self, other: Self | Constant, /) -> Self:
        right = self.coerced(other)
        return NotImplemented if right is None else self._times(right)

    def _plus(self, right: Self) -> Self:
        """The sum with an operand of the same reading; a reading implements this method or ``+`` itself."""
        raise NotImplementedError

    def _times(self, right: Self) -> Self:
        """The product with an operand of the same reading; a reading implements this method or ``*`` itself."""
        raise NotImplementedError

    @abstractmethod
    def scaled(self, constant: Constant, /) -> Self:
        """Return the operand times an exact constant."""

    def elevated_to(self, other: Self, /) -> Self:
        """Return the same function, of at least the degree of `other` if operands have degrees."""
        return self

    @abstractmethod
    def constant(self, value: Constant, /) -> Self:
        """Return an exact constant as an operand."""

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """Return the derivative of an order, by the only parameter or by the parameter `by`."""
        result = self
        for _ in range(order):
            result = result._first_derivative(by)
        return result

    def _first_derivative(self, by: str | None) -> Self:
        """The first derivative; a reading implements this method or `d` itself."""
        raise NotImplementedError

    def __neg__(self) -> Self:
        return self.scaled(-1)

    def __sub__(self, other: Self | Constant) -> Self:
        return self + (-other)

    def __rsub__(self, other: Constant) -> Self:
        return (-self).__add__(other)

    def __radd__(self, other: Constant) -> Self:
        return self.__add__(other)

    def __rmul__(self, other: Constant) -> Self:
        return self.__mul__(other)

    @overload
    def __truediv__(self, other: Constant) -> Self: ...
    @overload
    def __truediv__(self, other: Operand) -> Operand: ...
    @abstractmethod
    def __truediv__(self, other: object) -> object: ...

    def __rtruediv__(self, other: Constant) -> Operand:
        return self.constant(other) / self if isinstance(other, CONSTANTS) else NotImplemented

    def __pow__(self, exponent: int) -> Self:
        if not isinstance(exponent, int) or exponent < 1:
            raise FormulaError(f"a power with exponent {exponent!r}", remedy="use a positive integer")
        if exponent > MOST_POWER:
            raise FormulaError(
                f"a power with exponent {exponent}", remedy=f"at most {MOST_POWER} factors are multiplied"
            )
        result = self
        for _ in range(exponent - 1):
            result = result * self
        return result

    def __bool__(self) -> bool:
        raise no_truth_value(self)

    def coerced(self, other: object) -> Self | None:
        """Return an operand of the same type unchanged, a constant as an operand, and None for anything else."""
        if isinstance(other, type(self)):
            return other
        return self.constant(other) if isinstance(other, CONSTANTS) else None

    @abstractmethod
    def dividing(self, numerator: object) -> object:
        """Return the quotient of `numerator`, an operand or a vector of operands, by this operand."""

    def times_vector(self, vector: Components) -> object:
        """Return the product with a vector, component by component."""
        return vector.mapped(lambda component: component * self)

    def only_parameter(self, by: str | None) -> None:
        """Check that a derivative of this function is taken with respect to its only parameter.

        Raises `FormulaError` for another parameter.
        """
        if by not in (None, self.parameter):
            problem = f"a derivative with respect to {by!r} of a function of {self.parameter!r}"
            raise FormulaError(problem, remedy="name a parameter of the function")


class FieldOperand(Operand):
    """An operand of a field: ``/`` returns a true quotient instead of a `Rational`."""

    __slots__ = ()

    @abstractmethod
    def reciprocal(self) -> Self:
        """``1 / a``."""

    @overload
    def __truediv__(self, other: Self | Constant) -> Self: ...
    @overload
    def __truediv__(self, other: Operand) -> Operand: ...
    def __truediv__(self, other: object) -> object:
        right = self.coerced(other)
        return NotImplemented if right is None else self * right.reciprocal()

    def __rtruediv__(self, other: Constant) -> Self:
        left = self.coerced(other)
        return NotImplemented if left is None else left * self.reciprocal()

    def dividing(self, numerator: object) -> object:
        """`numerator` times the reciprocal."""
        return cast(Any, numerator) * self.reciprocal()


class OwnProducts(ABC):
    """A representation of vectors that implements products of vectors itself: a quotient or a node of a tree."""

    __slots__ = ()

    @abstractmethod
    def multilinear(self, function: Callable[..., object], vectors: tuple[object, ...]) -> object:
        """Return the product `function` of `vectors`, of which this is one."""


class OwnJoining(ABC):
    """An operand that implements the joining of vectors itself."""

    __slots__ = ()

    @abstractmethod
    def joining(self, parts: tuple[object, ...]) -> object:
        """Return one vector with the components of all parts."""


class OwnVectors(OwnProducts, OwnJoining):
    """An operand that represents scalars as well as vectors, and implements joining and products of vectors itself."""

    __slots__ = ()

    @abstractmethod
    def ruled(self, generator: Self) -> Self:
        """The ruled surface with this directrix."""

    @abstractmethod
    def levelled(self, height: object) -> tuple[object, object]:
        """This normal and its height brought to a common denominator."""


class PartlyOrdered(ABC):
    """A degree that is not a single number: the maximum of two such degrees may differ from both degrees."""

    __slots__ = ()

    @abstractmethod
    def max(self, other: Self, /) -> Self:
        """The least degree that bounds both."""


def larger(a: D, b: D) -> D:
    """The larger of two degrees, or the least degree that bounds both.

    >>> larger(2, 3)
    3
    """
    if isinstance(a, PartlyOrdered):
        return cast(D, a.max(cast(Any, b)))
    return a if bool(cast(Any, a) >= b) else b


def no_truth_value(value: object) -> FormulaError:
    """The error of a formula that branches."""
    return FormulaError(
        f"a {type(value).__name__} was used as a truth value",
        remedy="formulas must not branch; compare with == or use is_zero outside formulas",
    )


# ---- the parameters of which a formula takes derivatives
#
# Readings treat an operand that does not depend on a parameter as constant in it, and splines in two parameters have no
# names for their parameters. So a parameter that the argument does not have must be rejected beforehand.


class Letter(FieldOperand):
    """An operand that knows only the parameters with respect to which it may be differentiated. For a sum or a product
    these are the common parameters.

    >>> Letter(("u", "v")).d(1, by="s")
    Traceback (most recent call last):
    exactspline.errors.FormulaError: a derivative with respect to 's' of a function of u and v; write d(1, by='u')
    """

    __slots__ = ("parameters",)
    degree = provenance = 0

    def __init__(self, parameters: tuple[str, ...]) -> None:
        self.parameters = parameters

    def __add__(self, other: object) -> Letter:
        if isinstance(other, Letter):
            return Letter(tuple(each for each in self.parameters if each in other.parameters))
        return self if isinstance(other, CONSTANTS) else NotImplemented

    __mul__ = __add__

    def reciprocal(self) -> Letter:
        """The reciprocal: a function of the same parameters."""
        return self

    def scaled(self, constant: Constant) -> Letter:
        """A multiple: a function of the same parameters."""
        return self

    def constant(self, value: Constant) -> Letter:
        """A constant, taken as a function of the same parameters."""
        return self

    def d(self, order: int = 1, *, by: str | None = None) -> Letter:
        """A derivative: a function of the same parameters.

        Raises `FormulaError` for a parameter that the argument does not have.
        """
        refuse_letter(by, self.parameters)
        return self


def refuse_letter(by: str | None, parameters: tuple[str, ...]) -> None:
    """Raise `FormulaError` for a parameter that an argument does not have."""
    if by is not None and by not in parameters:
        problem = f"a derivative with respect to {str(by)!r} of a function of {' and '.join(parameters)}"
        raise FormulaError(problem, remedy=f"write d(1, by={str(parameters[0])!r})")
