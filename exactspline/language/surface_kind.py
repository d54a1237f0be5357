"""Surfaces: three functions of two parameters over a common denominator, S = p/w of u and v."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic

from exactspline.language.argument import Evaluated
from exactspline.language.arguments import COORDINATES, Operands, T, U
from exactspline.language.choices import Parameter
from exactspline.language.kind import Kind, Symbol
from exactspline.language.vector import Vector

#: The parameters of a surface.
BOTH = (Parameter.U, Parameter.V)


class Surface(Evaluated, Generic[T]):
    """A surface as named operands of one reading, functions of u and v.

    ``p`` the vector of numerators, ``w`` the denominator, ``S`` the surface itself: the `Rational` ``p/w``, or ``p``
    when it is polynomial (then ``w`` is the constant of degree 0). Derivatives are by a parameter that is named:
    ``S.d(1, by="u")``.

    >>> from exactspline.language.vector import dot
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(SURFACE, 3, polynomial=True)
    >>> dot(c.S.d(1, by="u"), c.S.d(1, by="v"))
    x_u·x_v + y_u·y_v + z_u·z_v
    """

    p: Vector[T]
    w: T
    S: Any
    polynomial: bool

    def __init__(self, p: Vector[T], w: T, *, polynomial: bool = False) -> None:
        self.p, self.w, self.polynomial = p, w, polynomial
        self.S = p if polynomial else p / w

    @property
    def dimension(self) -> int:
        """Number of coordinates."""
        return len(self.p)

    def operands(self) -> dict[str, T]:
        """Coordinates and denominator by name."""
        return dict(zip(COORDINATES, self.p, strict=False)) | {"w": self.w}

    def copied(self) -> Surface[T]:
        """The same operands in a surface of its own."""
        return Surface(self.p, self.w, polynomial=self.polynomial)

    def mapped(self, change: Callable[[T], U]) -> Surface[U]:
        """The surface with every operand changed: into another reading, or onto another domain."""
        return Surface(self.p.mapped(change), change(self.w), polynomial=self.polynomial)


class SurfaceKind(Kind):
    """A surface in space, or a map of the plane."""

    made_of_a_curve = False
    counted = BOTH

    def __init__(self, name: str, dimension: int) -> None:
        self.name, self.dimensions = name, (dimension,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates and denominator."""
        return tuple(Symbol(name, name, BOTH) for name in [*COORDINATES[:dimension], *([] if polynomial else ["w"])])

    def names(self, dimension: int) -> dict[str, bool]:
        """Numerator, denominator, and the surface itself."""
        return {"p": True, "w": False, "S": True}

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The surface."""
        named = {symbol.name: operand(symbol) for symbol in self.symbols(dimension, polynomial=polynomial)}
        return Surface(
            Vector(*[named[name] for name in COORDINATES[:dimension]]), named.get("w", one), polynomial=polynomial
        )


SURFACE, PLANAR_MAP = SurfaceKind("surface", 3), SurfaceKind("planar map", 2)


class FormsKind(Kind):
    """The six coefficients of two quadratic forms, functions of u and v: E, F, G of the first and L, M, N of the second
    fundamental form of a surface, whatever the surface.

    What is said of them alone holds for every surface, and is short. Surfaces hand over their own:
    ``Operands(E=…, F=…, …)``.

    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(FORMS, 3)
    >>> (c.E * c.G - c.F * c.F).d(1, by="u")
    G·E_u − 2·F·F_u + E·G_u
    """

    name = "forms"
    dimensions = (3,)
    made_of_a_curve = False
    counted = BOTH

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The six coefficients, which have no degrees."""
        return tuple(Symbol(name, name, BOTH, "") for name in "EFGLMN")

    def names(self, dimension: int) -> dict[str, bool]:
        """The six coefficients."""
        return dict.fromkeys("EFGLMN", False)

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The coefficients by name."""
        return Operands(**{symbol.name: operand(symbol) for symbol in self.symbols(dimension)})


FORMS = FormsKind()
