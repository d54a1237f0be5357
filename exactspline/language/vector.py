"""Operands, vectors of them, and the products of vectors: the first half of the language of formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from exactspline.errors import FormulaError, ShapeError
from exactspline.exact import mpq
from exactspline.language.immutable import Immutable, fill
from exactspline.language.operand import CONSTANTS, Operand, _rational
from exactspline.language.services import Displayed


class FieldOperand(Operand):
    """An operand that can be divided by: a reading with ``reciprocal`` gives true quotients instead of a `Rational`."""

    __slots__ = ()

    def __truediv__(self, other: Any) -> Any:
        right = self.beside(other)
        return NotImplemented if right is None else self * right.reciprocal()  # type: ignore[operator]

    def __rtruediv__(self, other: Any) -> Any:
        left = self.beside(other)
        return NotImplemented if left is None else left * self.reciprocal()  # type: ignore[attr-defined]

    def dividing(self, vector: Vector) -> Vector:
        """A vector divided by this."""
        inverse = self.reciprocal()  # type: ignore[attr-defined]
        return Vector(*[a * inverse for a in vector])


class Vector(Immutable, Displayed):
    """A tuple of scalar operands of one reading.

    >>> a, b = Vector(1, 2), Vector(mpq(1, 2), 0)
    >>> a + b, 2 * a, dot(a, b), det(a, b)
    (Vector(mpq(3,2), 2), Vector(2, 4), mpq(1,2), mpq(-1,1))
    """

    __slots__ = ("_derivative", "components")
    is_vector = True
    #: A reading whose vectors are of another kind supplies a method here.
    multilinear = None

    components: tuple[Any, ...]
    _derivative: Vector | None

    def __init__(self, *components: Any) -> None:
        fill(self, components=components, _derivative=None)

    def __reduce__(self) -> tuple[Any, ...]:
        return Vector, self.components

    def __len__(self) -> int:
        return len(self.components)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.components)

    def __getitem__(self, index: int | slice) -> Any:
        """A component, or the vector of those that a slice takes."""
        return Vector(*self.components[index]) if isinstance(index, slice) else self.components[index]

    def __call__(self, *place: Any, **side: str) -> tuple[Any, ...]:
        """The values of components that are functions, at a parameter (or at two)."""
        return tuple(a(*place, **side) for a in self.components)

    def __repr__(self) -> str:
        return f"Vector({', '.join(map(repr, self.components))})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Vector) and self.components == other.components

    def __hash__(self) -> int:
        return hash(self.components)

    def __bool__(self) -> bool:
        return Operand.__bool__(self)  # type: ignore[arg-type]

    def __add__(self, other: Any) -> Any:
        if not isinstance(other, Vector):
            return NotImplemented
        _same_length(self, other)
        return Vector(*[a + b for a, b in zip(self.components, other.components, strict=True)])

    def __sub__(self, other: Any) -> Any:
        if not isinstance(other, Vector):
            return NotImplemented
        _same_length(self, other)
        return Vector(*[a - b for a, b in zip(self.components, other.components, strict=True)])

    def __neg__(self) -> Vector:
        return Vector(*[-a for a in self.components])

    def __mul__(self, scalar: Any) -> Any:
        if isinstance(scalar, Operand):
            if scalar.takes_over:
                return NotImplemented
        elif isinstance(scalar, Vector):
            raise ShapeError("a product of two vectors with *", remedy="write dot, cross or det")
        elif not isinstance(scalar, CONSTANTS):
            return NotImplemented
        return Vector(*[a * scalar for a in self.components])

    __rmul__ = __mul__

    def __truediv__(self, scalar: Any) -> Any:
        if isinstance(scalar, CONSTANTS):
            return Vector(*[a / mpq(scalar) for a in self.components])
        if not isinstance(scalar, Operand) or (scalar.takes_over and not hasattr(scalar, "dividing")):
            return NotImplemented
        return scalar.dividing(self) if hasattr(scalar, "dividing") else _rational()(self, scalar)

    def d(self, order: int = 1) -> Vector:
        """The derivative of the given order, component by component."""
        if order < 0:
            raise FormulaError(f"a derivative of order {order}", remedy="orders are 0, 1, 2, …")
        result = self
        for _ in range(order):
            derivative = result._derivative
            if derivative is None:
                derivative = Vector(*[a.d(1) for a in result.components])
                fill(result, _derivative=derivative)
            result = derivative
        return result

    def scaled(self, constant: Any) -> Vector:
        """The vector times an exact constant."""
        return Vector(*[a * constant for a in self.components])

    def elevated_to(self, other: Any) -> Vector:
        """The same vector, every component at least of the degree of `other`."""
        return Vector(*[a.elevated_to(other) for a in self.components])

    @property
    def degree(self) -> Any:
        """The largest degree of the components."""
        first, *rest = self.components
        degree = first.degree
        for a in rest:
            degree = degree.max(a.degree) if hasattr(degree, "max") else max(degree, a.degree)
        return degree

    @property
    def is_zero(self) -> bool:
        """Whether every component is identically zero."""
        return all(a.is_zero for a in self.components)


def _same_length(a: Vector, b: Vector) -> None:
    if len(a) != len(b):
        raise ShapeError(f"vectors of {len(a)} and {len(b)} components", remedy="use vectors of one dimension")


def _multilinear(function: Callable[..., Any]) -> Callable[..., Any]:
    """Let a reading take a product of vectors over: a rational multiplies the denominators, a tree notes a node."""

    def product(*vectors: Any) -> Any:  # its documentation is the function's own
        for vector in vectors:
            if vector.multilinear is not None:
                return vector.multilinear(product, vectors)
        return function(*vectors)

    product.__name__ = product.__qualname__ = function.__name__
    product.__doc__, product.__module__ = function.__doc__, function.__module__
    product.__wrapped__ = function  # type: ignore[attr-defined]
    return product


@_multilinear
def dot(a: Vector, b: Vector) -> Any:
    """Scalar product of two vectors of one dimension (rows T11, T14, T15).

    >>> dot(Vector(1, 2, 3), Vector(4, 5, 6))
    32

    Raises `ShapeError` when the dimensions differ.
    """
    _same_length(a, b)
    first, *rest = [x * y for x, y in zip(a.components, b.components, strict=True)]
    for product in rest:
        first = first + product
    return first


def norm2(a: Any) -> Any:
    """Squared length ``a·a``.

    >>> norm2(Vector(3, 4))
    25
    """
    return dot(a, a)


@_multilinear
def perp(a: Vector) -> Vector:
    """The plane vector turned by a right angle to the left, ``(-a_y, a_x)``.

    >>> perp(Vector(1, 2))
    Vector(-2, 1)
    """
    if len(a) != 2:
        raise ShapeError(f"perp of a vector of {len(a)} components", remedy="it is defined in the plane")
    return Vector(-a[1], a[0])


@_multilinear
def cross(a: Vector, b: Vector) -> Vector:
    """Cross product in space (rows T10, T12, T13).

    >>> cross(Vector(1, 0, 0), Vector(0, 1, 0))
    Vector(0, 0, 1)
    """
    if not len(a) == len(b) == 3:
        raise ShapeError(
            f"cross product of vectors of {len(a)} and {len(b)} components", remedy="it is defined in space"
        )
    (a0, a1, a2), (b0, b1, b2) = a.components, b.components
    return Vector(a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0)


@_multilinear
def det(*rows: Vector) -> Any:
    """Determinant of n vectors in Rⁿ: ``[a b]``, the triple scalar product ``[a b c]``, the n-fold scalar product.

    Two vectors: ``a_x b_y - a_y b_x``. Three: a cross product followed by a dot product, as the paper counts it. More:
    Laplace expansion with shared minors.

    >>> det(Vector(1, 0), Vector(0, 1)), det(Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1))
    (1, 1)
    """
    n = len(rows)
    if n == 2 and len(rows[0].components) == len(rows[1].components) == 2:
        (a0, a1), (b0, b1) = rows[0].components, rows[1].components
        return a0 * b1 - a1 * b0
    if n < 3 or any(len(row) != n for row in rows):
        raise ShapeError(
            f"determinant of {n} vectors of {sorted({len(row) for row in rows})} components",
            remedy="pass n ≥ 2 vectors of n components",
        )
    if n == 3:
        return dot(cross(rows[0], rows[1]), rows[2])
    return dot(generalized_cross(*rows[:-1]), rows[-1])


#: Triple scalar product ``[a b c]``: the determinant of three vectors.
triple = det


@_multilinear
def generalized_cross(*rows: Vector) -> Vector:
    """The vector orthogonal to n−1 vectors of Rⁿ with ``det(a, …, z, x) = generalized_cross(a, …, z)·x`` for all x.

    In space it is the cross product; in the plane, `perp` with the sign that makes the determinant right.

    >>> generalized_cross(Vector(1, 0, 0, 0), Vector(0, 1, 0, 0), Vector(0, 0, 1, 0))
    Vector(0, 0, 0, 1)
    """
    n = len(rows) + 1
    if n < 2 or any(len(row) != n for row in rows):
        raise ShapeError(f"generalized cross product of {n - 1} vectors", remedy=f"they must have {n} components each")
    minors: dict[tuple[int, ...], Any] = {(j,): rows[0][j] for j in range(n)}
    for size in range(2, n):
        minors = {columns: _expand(minors, rows[size - 1], columns) for columns in _subsets(n, size)}
    cofactors = []
    for j in range(n):
        minor = minors[tuple(k for k in range(n) if k != j)]
        cofactors.append(-minor if (n - 1 + j) % 2 else minor)
    return Vector(*cofactors)


def _subsets(n: int, size: int) -> Iterator[tuple[int, ...]]:
    from itertools import combinations

    return combinations(range(n), size)


def _expand(minors: dict[tuple[int, ...], Any], row: Vector, columns: tuple[int, ...]) -> Any:
    """Laplace expansion of the minor in `columns` along its last row."""
    last = len(columns) - 1
    total: Any = None
    for i, column in enumerate(columns):
        term = minors[columns[:i] + columns[i + 1 :]] * row[column]
        signed = -term if (last + i) % 2 else term
        total = signed if total is None else total + signed
    return total


def join(*parts: Any) -> Any:
    """One vector of the components of all parts: vectors, scalars and constants of one reading.

    >>> join(Vector(1, 2), 3)
    Vector(1, 2, 3)
    """
    operand = next(part for part in parts if not isinstance(part, CONSTANTS))
    if hook := getattr(operand, "joining", None):
        return hook(parts)
    scalar = operand[0] if isinstance(operand, Vector) else operand
    components: list[Any] = []
    for part in parts:
        made = scalar.constant(part) if isinstance(part, CONSTANTS) and not isinstance(scalar, CONSTANTS) else part
        components += made.components if isinstance(made, Vector) else [made]
    return Vector(*components)


def wronskian(a: Any, order: int | None = None) -> Any:
    """Determinant of a vector of n components and its first n−1 derivatives.

    It vanishes identically where the components are linearly dependent functions. `order` is the number of components
    when `a` cannot tell (a node of a tree).
    """
    n = len(a) if order is None else order
    return det(a, *[a.d(k) for k in range(1, n)])
