"""Operands: what every scalar of every reading has in common, declared once as protocols and once as a base class."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self, TypeVar, cast, overload

from exactspline.errors import FormulaError, shown
from exactspline.hooks import Displayed
from exactspline.numbers.exact import mpq, mpz

if TYPE_CHECKING:
    from exactspline.language.provenance import Provenance

#: The constants that may stand in a formula.
Constant = int | mpz | mpq | Fraction
CONSTANTS = (int, type(mpz()), type(mpq()), Fraction)
#: The highest order of a derivative that is computed.
MOST_DERIVATIVES = 1000


D_co = TypeVar("D_co", covariant=True)


class Scalar(Protocol):
    """What products of vectors need of a component: exact numbers have it, and so do operands."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...
    def __neg__(self) -> Self: ...


class Ring(Protocol):
    """What a formula needs of an operand: a differential ring over the exact constants."""

    @property
    def is_zero(self) -> bool:
        """Whether it vanishes identically."""

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


class Counted(Ring, Protocol):
    """What naive semantics (Table 1) needs in addition: a degree, elevation, and how the operand was made."""

    @property
    def degree(self) -> object:
        """The nominal degree: a number, two of them, or an expression."""

    @property
    def provenance(self) -> Provenance:
        """How it was made (see `exactspline.language.provenance`)."""

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether it is identically zero, if only on one segment of its domain."""

    def elevated_to(self, other: Self, /) -> Self:
        """The same thing, of at least the degree of another."""

    equals_quotients: ClassVar[bool]

    def hash_of_quotient(self, numerator: Self) -> int:
        """A hash of the quotient by this that all equal ones share."""


class Components(Protocol):
    """What an operand needs of a vector of operands."""

    def mapped(self, change: Callable[[Operand], Operand], /) -> object:
        """The vector of the images of its components."""


class Dividing(Protocol[D_co]):
    """What a vector can be divided by."""

    def dividing(self, numerator: object, /) -> D_co:
        """A vector divided by this."""


class HasDegree(Protocol[D_co]):
    """What has a degree: a number, two of them, or an expression."""

    @property
    def degree(self) -> D_co:
        """The degree."""


R = TypeVar("R", bound=Ring)
C = TypeVar("C", bound=Counted)
D = TypeVar("D")


def checked_order(order: object) -> int:
    """The order of a derivative as given by a user; `FormulaError` unless it is an int from 0 to `MOST_DERIVATIVES`."""
    if type(order) is not int or not 0 <= order <= MOST_DERIVATIVES:
        raise FormulaError(f"a derivative of order {shown(order)}", remedy=f"orders are 0, 1, 2, …, {MOST_DERIVATIVES}")
    return order


class Operand(Displayed, ABC):
    """The base of the scalars of all readings: a reading supplies what is abstract here, the rest follows.

    A reading with true quotients is a `FieldOperand`; where ``/`` makes a `Rational`, it is a
    `exactspline.language.rational.RingOperand`.
    """

    __slots__ = ()
    #: Whether it is a vector (some readings have one class for both).
    is_vector: bool = False
    #: The parameter of an operand that has only one.
    parameter: ClassVar[str] = "s"
    #: Whether an operand equals the quotients that are the same function, and its hash is that of theirs.
    equals_quotients: ClassVar[bool] = False

    @property
    def is_zero(self) -> bool:
        """Whether it vanishes identically.

        Raises `FormulaError` in a reading that cannot tell.
        """
        raise FormulaError(
            f"whether a {type(self).__name__} vanishes", remedy="ask in a reading that has values, as jets or splines"
        )

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether it is identically zero, if only on one segment of its domain."""
        return bool(self.is_zero)

    def hash_of_quotient(self, numerator: Self) -> int:
        """A hash of the quotient by this that all equal ones share; a reading may refine it."""
        return 1

    @abstractmethod
    def __add__(self, other: Self | Constant, /) -> Self: ...

    @abstractmethod
    def __mul__(self, other: Self | Constant, /) -> Self: ...

    @abstractmethod
    def scaled(self, constant: Constant, /) -> Self:
        """The operand times an exact constant."""

    @abstractmethod
    def constant(self, value: Constant, /) -> Self:
        """An exact constant in this reading."""

    @abstractmethod
    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The derivative of an order, by the only parameter or by the one that is named."""

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
        result = self
        for _ in range(exponent - 1):
            result = result * self
        return result

    def __bool__(self) -> bool:
        raise no_truth_value(self)

    def beside(self, other: object) -> Self | None:
        """Another operand of the same reading, constants converted; None for anything else."""
        if isinstance(other, type(self)):
            return other
        return self.constant(other) if isinstance(other, CONSTANTS) else None

    @abstractmethod
    def dividing(self, numerator: object) -> object:
        """`numerator`, an operand or a vector of this reading, divided by this."""

    def times_vector(self, vector: Components) -> object:
        """A vector times this: component by component."""
        return vector.mapped(lambda component: component * self)

    def only_parameter(self, by: str | None) -> None:
        """Make sure that a derivative is taken by the only parameter.

        Raises `FormulaError` for another one.
        """
        if by not in (None, self.parameter):
            raise FormulaError(
                f"a derivative by {by!r} of a function of {self.parameter!r}", remedy="name a parameter that it has"
            )


class FieldOperand(Operand):
    """An operand that can be divided by: ``/`` gives a true quotient instead of a `Rational`."""

    __slots__ = ()

    @abstractmethod
    def reciprocal(self) -> Self:
        """``1 / a``."""

    @overload
    def __truediv__(self, other: Self | Constant) -> Self: ...
    @overload
    def __truediv__(self, other: Operand) -> Operand: ...
    def __truediv__(self, other: object) -> object:
        right = self.beside(other)
        return NotImplemented if right is None else self * right.reciprocal()

    def __rtruediv__(self, other: Constant) -> Self:
        left = self.beside(other)
        return NotImplemented if left is None else left * self.reciprocal()

    def dividing(self, numerator: object) -> object:
        """`numerator` times the reciprocal."""
        return cast(Any, numerator) * self.reciprocal()


class OwnProducts(ABC):
    """A vector of its own kind, which carries out products of vectors itself: a quotient, a node of a tree."""

    __slots__ = ()

    @abstractmethod
    def multilinear(self, function: Callable[..., object], vectors: tuple[object, ...]) -> object:
        """A product of vectors, `function` of `vectors`, this one among them."""


class OwnJoining(ABC):
    """An operand that joins vectors itself."""

    __slots__ = ()

    @abstractmethod
    def joining(self, parts: tuple[object, ...]) -> object:
        """One vector of the components of all parts."""


class OwnVectors(OwnProducts, OwnJoining):
    """An operand that stands for scalars and vectors alike: joining and operations on vectors are up to it."""

    __slots__ = ()

    @abstractmethod
    def ruled(self, generator: Self) -> Self:
        """The ruled surface with this directrix."""

    @abstractmethod
    def levelled(self, height: object) -> tuple[object, object]:
        """This normal and its height brought to one denominator."""


class PartlyOrdered(ABC):
    """A degree that is not a single number: two of them have a maximum, which may be neither."""

    __slots__ = ()

    @abstractmethod
    def max(self, other: Self, /) -> Self:
        """The least degree that is not below either."""


def larger(a: D, b: D) -> D:
    """The larger of two degrees, or the least that is not below either.

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
