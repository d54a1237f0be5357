"""Vectors of operands, and the products of vectors."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from typing import Any, Generic, ParamSpec, TypeVar, cast, overload

from exactspline.errors import FormulaError, ShapeError, a_kind, counted
from exactspline.hooks import Displayed
from exactspline.language.operand import (
    CONSTANTS,
    Constant,
    D,
    Dividing,
    FieldOperand,
    HasDegree,
    Operand,
    OwnJoining,
    OwnProducts,
    R,
    Scalar,
    checked_order,
    larger,
    no_truth_value,
)
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Side
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import one_line

T = TypeVar("T")
T_co = TypeVar("T_co", covariant=True)
U = TypeVar("U")
S = TypeVar("S", bound=Scalar)
F = TypeVar("F", bound=FieldOperand)
#: Representations that implement products themselves: a quotient, a node of a tree.
Q = TypeVar("Q", bound=OwnProducts)
P = ParamSpec("P")


class Vector(Immutable, Displayed, Generic[T_co]):
    """A tuple of scalar operands of one type.

    >>> a, b = Vector(1, 2), Vector(mpq(1, 2), 0)
    >>> a + b, 2 * a, dot(a, b), det(a, b)
    (Vector(mpq(3,2), 2), Vector(2, 4), mpq(1,2), mpq(-1,1))
    """

    __slots__ = ("_derivatives", "components")
    is_vector = True
    components: tuple[T_co, ...]

    _derivatives: dict[str | None, Vector[T_co]]

    def __init__(self, *components: T_co) -> None:
        #: First derivatives by parameter, cached on first use.
        fill(self, components=components, _derivatives={})

    def __reduce__(self) -> tuple[object, ...]:
        return Vector, self.components

    def __len__(self) -> int:
        return len(self.components)

    def __iter__(self) -> Iterator[T_co]:
        return iter(self.components)

    @overload
    def __getitem__(self, index: int) -> T_co: ...
    @overload
    def __getitem__(self, index: slice) -> Vector[T_co]: ...
    def __getitem__(self, index: int | slice) -> T_co | Vector[T_co]:
        """Return a component, or the vector of the components in a slice."""
        return Vector(*self.components[index]) if isinstance(index, slice) else self.components[index]

    def __call__(self, *place: Number, **side: Side | str) -> tuple[mpq, ...]:
        """Return the values of components that are functions, at one or two parameters."""
        functions: tuple[Any, ...] = self.components
        return tuple(a(*place, **side) for a in functions)

    @one_line
    def __repr__(self) -> str:
        return f"Vector({', '.join(map(repr, self.components))})"

    def __eq__(self, other: object) -> bool:
        return self.components == other.components if isinstance(other, Vector) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.components)

    def __bool__(self) -> bool:
        raise no_truth_value(self)

    def mapped(self, change: Callable[[T_co], U]) -> Vector[U]:
        """Return the vector of the images of its components.

        >>> Vector(1, 2).mapped(lambda x: x + 1)
        Vector(2, 3)
        """
        return Vector(*[change(component) for component in self.components])

    def __add__(self: Vector[S], other: Vector[S]) -> Vector[S]:
        if not isinstance(other, Vector):
            return NotImplemented
        _same_length(self, other)
        return Vector(*[a + b for a, b in zip(self.components, other.components, strict=True)])

    def __sub__(self: Vector[S], other: Vector[S]) -> Vector[S]:
        if not isinstance(other, Vector):
            return NotImplemented
        _same_length(self, other)
        return Vector(*[a - b for a, b in zip(self.components, other.components, strict=True)])

    def __neg__(self: Vector[S]) -> Vector[S]:
        return Vector(*[-a for a in self.components])

    @overload
    def __mul__(self, scalar: Q) -> Q: ...
    @overload
    def __mul__(self: Vector[S], scalar: S) -> Vector[S]: ...
    @overload
    def __mul__(self, scalar: Constant) -> Vector[T_co]: ...
    def __mul__(self, scalar: object) -> object:
        if isinstance(scalar, Operand):
            return scalar.times_vector(cast("Vector[Operand]", self))
        if isinstance(scalar, Vector):
            raise ShapeError("a product of two vectors with *", remedy="write dot, cross or det")
        return self.scaled(scalar) if isinstance(scalar, CONSTANTS) else NotImplemented

    __rmul__ = __mul__

    @overload
    def __truediv__(self, scalar: Constant) -> Vector[T_co]: ...
    @overload
    def __truediv__(self: Vector[F], scalar: F) -> Vector[F]: ...
    @overload
    def __truediv__(self, scalar: Dividing[U]) -> U: ...
    def __truediv__(self, scalar: object) -> object:
        if isinstance(scalar, CONSTANTS):
            return self.scaled(1 / mpq(scalar))
        return scalar.dividing(cast("Vector[Operand]", self)) if isinstance(scalar, Operand) else NotImplemented

    def d(self: Vector[R], order: int = 1, *, by: str | None = None) -> Vector[R]:
        """Return the derivative of the given order, component by component.

        Raises `FormulaError` for a negative order.
        """
        result = self
        for _ in range(checked_order(order)):
            known = result._derivatives
            if by not in known:
                if any(isinstance(a, CONSTANTS) for a in result.components):
                    raise FormulaError("the derivative of a vector of numbers", remedy="give functions: splines, jets")
                known[by] = Vector(*[a.d(1, by=by) for a in result.components])
            result = known[by]
        return result

    def scaled(self, constant: Constant) -> Vector[T_co]:
        """Return the vector times an exact constant."""
        components: tuple[Any, ...] = self.components
        return Vector(*[a * constant for a in components])

    def elevated_to(self, other: object) -> Vector[T_co]:
        """Return the same vector, every component elevated to at least the degree of `other`."""
        components: tuple[Any, ...] = self.components
        return Vector(*[a.elevated_to(other) for a in components])

    @property
    def degree(self: Vector[HasDegree[D]]) -> D:
        """The largest degree of the components: a number, a pair of numbers, or a symbolic degree."""
        degree = self.components[0].degree
        for a in self.components[1:]:
            degree = larger(degree, a.degree)
        return degree

    @property
    def is_zero(self) -> bool:
        """Whether every component is identically zero."""
        components: tuple[Any, ...] = self.components
        return all(a.is_zero for a in components)


def _same_length(a: Vector[Any], b: Vector[Any]) -> None:
    if len(a) != len(b):
        raise ShapeError(
            f"vectors of {len(a)} and {counted(len(b), 'component')}", remedy="use vectors of the same dimension"
        )


def expect_vector(given: object) -> None:
    """Raise `ShapeError` for anything but a vector of a reading."""
    if not getattr(given, "is_vector", False):
        raise ShapeError(f"{a_kind(given)}, where a vector is expected", remedy="give a Vector, such as curve.p")


def _multilinear(function: Callable[P, T]) -> Callable[P, T]:
    """Let a reading intercept products of vectors: a quotient multiplies the denominators, a tree records a node."""

    def product(*vectors: P.args, **no: P.kwargs) -> T:  # documented by `function`
        for vector in vectors:
            if type(vector) is not Vector and isinstance(vector, OwnProducts):
                return cast(T, vector.multilinear(product, vectors))
            expect_vector(vector)
        last: Any = vectors[-1] if vectors else Vector()
        if any(getattr(x, "is_long", False) for x in last.components):
            return _of_proportions(function, vectors)
        return function(*vectors, **no)

    product.__name__ = product.__qualname__ = function.__name__
    product.__doc__, product.__module__ = function.__doc__, function.__module__
    product.__wrapped__ = function  # type: ignore[attr-defined]  # for `inspect.signature`
    return product


def _of_proportions(function: Callable[..., T], vectors: Sequence[Any]) -> T:
    """A product of a vector v with long components and its derivatives. With v = P u, where P is a component of v, it
    is computed from u, in which common factors have cancelled: ``[v v′ v″] = P³ [u u′ u″]``, ``v·v = P² u·u``.
    """
    first, n = vectors[0], len(vectors)
    chain = [first]
    while len(chain) < n:
        chain.append(first if function.__name__ == "dot" else getattr(chain[-1], "_derivatives", {}).get(None))
    pivot = next((x for x in first.components if not (isinstance(x, CONSTANTS) or x.is_zero)), None)
    if pivot is None or len(first) < 2 or any(a is not b for a, b in zip(chain, vectors, strict=True)):
        return function(*vectors)
    parts = Vector(*[x / pivot for x in first.components])
    short = function(*[parts if function.__name__ == "dot" else parts.d(k) for k in range(n)])
    for _ in range(n):
        short = short * pivot
    return short


@_multilinear
def dot(a: Vector[S], b: Vector[S]) -> S:
    """Return the scalar product of two vectors of the same dimension (rows T11, T14, T15 of the paper's Table 1).

    >>> dot(Vector(1, 2, 3), Vector(4, 5, 6))
    32

    Raises `ShapeError` if the dimensions differ.
    """
    _same_length(a, b)
    first, *rest = [x * y for x, y in zip(a.components, b.components, strict=True)]
    for product in rest:
        first = first + product
    return first


def norm2(a: Vector[S]) -> S:
    """Return the squared length ``a·a``.

    >>> norm2(Vector(3, 4))
    25
    """
    return dot(a, a)


@_multilinear
def perp(a: Vector[S]) -> Vector[S]:
    """Return the plane vector rotated by a right angle to the left, ``(-a_y, a_x)``.

    >>> perp(Vector(1, 2))
    Vector(-2, 1)
    """
    if len(a) != 2:
        raise ShapeError(f"perp of a vector of {counted(len(a), 'component')}", remedy="it is defined in the plane")
    return Vector(-a[1], a[0])


@_multilinear
def cross(a: Vector[S], b: Vector[S]) -> Vector[S]:
    """Return the cross product of two vectors in space (rows T10, T12, T13 of the paper's Table 1).

    >>> cross(Vector(1, 0, 0), Vector(0, 1, 0))
    Vector(0, 0, 1)
    """
    if not len(a) == len(b) == 3:
        raise ShapeError(
            f"cross product of vectors of {len(a)} and {counted(len(b), 'component')}", remedy="it is defined in space"
        )
    (a0, a1, a2), (b0, b1, b2) = a.components, b.components
    return Vector(a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0)


@_multilinear
def det(*rows: Vector[S]) -> S:
    """Return the determinant of n vectors in Rⁿ, such as ``[a b]`` or the triple scalar product ``[a b c]``.

    For three vectors this is a cross product followed by a dot product, as counted in the paper, and for more vectors a
    Laplace expansion with shared minors.

    >>> det(Vector(1, 0), Vector(0, 1)), det(Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1))
    (1, 1)
    """
    n = len(rows)
    if n == 2 and len(rows[0].components) == len(rows[1].components) == 2:
        (a0, a1), (b0, b1) = rows[0].components, rows[1].components
        return a0 * b1 - a1 * b0
    if n < 3 or any(len(row) != n for row in rows):
        problem = f"determinant of {n} vectors of {sorted({len(row) for row in rows})} components"
        raise ShapeError(problem, remedy="pass n ≥ 2 vectors of n components")
    return dot(cross(rows[0], rows[1]), rows[2]) if n == 3 else dot(generalized_cross(*rows[:-1]), rows[-1])


#: Triple scalar product ``[a b c]``: the determinant of three vectors.
triple = det


@_multilinear
def generalized_cross(*rows: Vector[S]) -> Vector[S]:
    """Return the vector orthogonal to n−1 vectors a, …, z of Rⁿ such that ``det(a, …, z, x) = generalized_cross(a, …,
    z)·x`` for every vector x.

    In space this is the cross product; in the plane it is `perp` up to the sign required by the determinant.

    >>> generalized_cross(Vector(1, 0, 0, 0), Vector(0, 1, 0, 0), Vector(0, 0, 1, 0))
    Vector(0, 0, 0, 1)
    """
    n = len(rows) + 1
    if n < 2 or any(len(row) != n for row in rows):
        raise ShapeError(f"generalized cross product of {n - 1} vectors", remedy=f"each must have {n} components")
    minors: dict[tuple[int, ...], S] = {(j,): rows[0][j] for j in range(n)}
    for size in range(2, n):
        minors = {columns: _expand(minors, rows[size - 1], columns) for columns in combinations(range(n), size)}
    cofactors = []
    for j in range(n):
        minor = minors[tuple(k for k in range(n) if k != j)]
        cofactors.append(-minor if (n - 1 + j) % 2 else minor)
    return Vector(*cofactors)


def _expand(minors: dict[tuple[int, ...], S], row: Vector[S], columns: tuple[int, ...]) -> S:
    """Laplace expansion of the minor in `columns` along its last row."""
    last = len(columns) - 1
    total: S | None = None
    for i, column in enumerate(columns):
        term = minors[columns[:i] + columns[i + 1 :]] * row[column]
        signed = -term if (last + i) % 2 else term
        total = signed if total is None else total + signed
    assert total is not None
    return total


def join(*parts: Vector[S] | S | Constant) -> Vector[S]:
    """Return one vector with the components of all parts, which are vectors, scalars and constants.

    >>> join(Vector(1, 2), 3)
    Vector(1, 2, 3)
    """
    for part in parts:
        if not isinstance(part, (Operand, Vector, OwnJoining, *CONSTANTS)):
            raise FormulaError(f"{a_kind(part)} in a vector", remedy="join vectors, operands of formulas and numbers")
    joiner: object = next((part for part in parts if isinstance(part, OwnJoining)), None)
    if isinstance(joiner, OwnJoining):
        return cast("Vector[S]", joiner.joining(parts))
    operand: Any = next((part for part in parts if not isinstance(part, CONSTANTS)), None)
    if operand is None:
        return Vector(*cast("tuple[S, ...]", parts))
    scalar = operand[0] if isinstance(operand, Vector) else operand
    components: list[Any] = []
    for part in parts:
        made: Any = scalar.constant(part) if isinstance(part, CONSTANTS) and not isinstance(scalar, CONSTANTS) else part
        components += made.components if isinstance(made, Vector) else [made]
    return Vector(*components)
