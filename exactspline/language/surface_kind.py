"""Surfaces: three functions of the parameters u and v over a common denominator, S = p/w."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, Generic

from exactspline.language.arguments import COORDINATES, Evaluated, Kind, Operands, Symbol, T, U
from exactspline.language.operand import Parameter
from exactspline.language.vector import Vector

#: The parameters of a surface.
BOTH = (Parameter.U, Parameter.V)


class Surface(Evaluated, Generic[T]):
    """A surface as named operands of one reading, functions of u and v.

    ``p`` the vector of numerators, ``w`` the denominator, ``S`` the surface itself: the `Rational` ``p/w``, or ``p``
    when it is polynomial (then ``w`` is the constant of degree 0). Derivatives name their parameter: ``S.d(1,
    by="u")``.

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
        """The number of coordinates."""
        return len(self.p)

    def operands(self) -> dict[str, T]:
        """Return coordinates and denominator by name."""
        return dict(zip(COORDINATES, self.p, strict=False)) | {"w": self.w}

    def copied(self) -> Surface[T]:
        """Return a new surface with the same operands."""
        return Surface(self.p, self.w, polynomial=self.polynomial)

    def mapped(self, change: Callable[[T], U]) -> Surface[U]:
        """Return the surface with `change` applied to every operand."""
        return Surface(self.p.mapped(change), change(self.w), polynomial=self.polynomial)


class SurfaceKind(Kind):
    """A surface in space, or a map of the plane."""

    made_of_a_curve = False
    made_of_a_surface = True
    counted = BOTH

    def __init__(self, name: str, dimension: int) -> None:
        self.name, self.dimensions = name, (dimension,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates and denominator."""
        return tuple(Symbol(name, name, BOTH) for name in [*COORDINATES[:dimension], *([] if polynomial else ["w"])])

    def names(self, dimension: int) -> dict[str, bool]:
        """Numerator, denominator, and the surface itself."""
        return {"p": True, "w": False, "S": True}

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The surface."""
        p = Vector(*[named[name] for name in COORDINATES[:dimension]])
        return Surface(p, named.get("w", one), polynomial="w" not in named)


SURFACE, PLANAR_MAP = SurfaceKind("surface", 3), SurfaceKind("planar map", 2)


class _SurfaceCurve(Surface[T], Generic[T]):
    """A curve on a surface: ``gamma`` is S at the parameters ``u`` and ``v``, two functions of the curve's parameter.

    Derivatives with respect to u and v are those of the surface; derivatives that name no parameter are taken along the
    curve, by the chain rule.

    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(CURVE_ON_SURFACE, 3, polynomial=True)
    >>> c.gamma.d(1)[0], c.S.d(1, by="u")[0]
    (u′·x_u + v′·x_v, x_u)
    """

    u: T
    v: T

    def __init__(self, p: Vector[T], w: T, u: T, v: T, *, polynomial: bool = False) -> None:
        super().__init__(p, w, polynomial=polynomial)
        self.u, self.v, self.gamma = u, v, self.S

    def operands(self) -> dict[str, T]:
        """The operands of the surface, and the parameters."""
        return super().operands() | {"u": self.u, "v": self.v}

    def copied(self) -> _SurfaceCurve[T]:
        """A new curve with the same operands."""
        return _SurfaceCurve(self.p, self.w, self.u, self.v, polynomial=self.polynomial)

    def mapped(self, change: Callable[[T], U]) -> _SurfaceCurve[U]:
        """The curve with `change` applied to every operand."""
        w, u, v = change(self.w), change(self.u), change(self.v)
        return _SurfaceCurve(self.p.mapped(change), w, u, v, polynomial=self.polynomial)


class SurfaceCurveKind(Kind):
    """A surface and a curve on it."""

    name = "curve on a surface"
    dimensions = (3,)
    made_of_a_curve = False
    composed = MappingProxyType({Parameter.U: "u", Parameter.V: "v"})

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates and denominator of the surface, and the parameters of the curve on it."""
        surface = [*COORDINATES[:dimension], *([] if polynomial else ["w"])]
        along = [Symbol(name, name, (Parameter.FIRST,), "") for name in self.composed.values()]
        return (*along, *[Symbol(name, name, BOTH, "") for name in surface])

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of a surface and of a curve, and the parameters."""
        return {"p": True, "w": False, "S": True, "gamma": True, "u": False, "v": False}

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of the other kind apply; those for surfaces and for space curves do."""
        return other is self or other.name in ("surface", "curve", "space")

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve on the surface."""
        p = Vector(*[named[name] for name in COORDINATES[:dimension]])
        return _SurfaceCurve(p, named.get("w", one), named["u"], named["v"], polynomial="w" not in named)


class FormsKind(Kind):
    """The six coefficients of two quadratic forms, as independent functions of u and v: E, F, G of the first and L, M,
    N of the second fundamental form of an arbitrary surface.

    An identity in these coefficients alone holds for every surface, and is short. To apply it to a surface, pass its
    coefficients: ``Operands(E=…, F=…, …)``. There is also a function ``w``, for forms that have a denominator.

    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(FORMS, 3)
    >>> (c.E * c.G - c.F * c.F).d(1, by="u")
    −2·F·F_u + E_u·G + E·G_u
    """

    name = "forms"
    dimensions = (3,)
    made_of_a_curve = False
    counted = ()

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The six coefficients and w, all of the same degree."""
        return tuple(Symbol(name, name, BOTH) for name in "EFGLMNw")

    def names(self, dimension: int) -> dict[str, bool]:
        """The six coefficients and w."""
        return dict.fromkeys("EFGLMNw", False)

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The coefficients by name."""
        return Operands(**named)


FORMS, CURVE_ON_SURFACE = FormsKind(), SurfaceCurveKind()
