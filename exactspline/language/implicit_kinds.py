"""Implicit curves and surfaces: the partial derivatives of F along a curve that lies in F = 0.

Since the curve lies there, ``∇F·γ′ = 0``, so that its derivative is a multiple of a vector orthogonal to ∇F, and the
chain rule gives the derivatives of all the partial derivatives: ``(F_x)′ = F_xx x′ + F_xy y′``. With that every formula
of curves can be compared with one in ∇F and the Hessian of F.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations_with_replacement
from typing import Any

from exactspline.errors import FormulaError
from exactspline.language.arguments import PARAMETERS, Accompanied, Curve, Evaluated, T, vector_of
from exactspline.language.kind import Kind, Rule, Symbol
from exactspline.language.vector import S, Vector, cross

#: Partial derivatives are known up to this order.
ORDER = 3
#: The free operands and their notation: the speed factor of a curve, and the normal of the cutting plane of a surface.
FREE = {"pace": "λ", "cutx": "c₁", "cuty": "c₂", "cutz": "c₃"}


class ImplicitKind(Kind):
    """A curve in the zero set of one or two functions of the coordinates.

    Formulas may name ``fx``, ``fxy``, … (letters in alphabetical order), ``gradient_f``, the rows ``hessian_fx``,
    ``hessian_fy``, … and everything that a curve has (with w = 1). The velocity of the curve has a free factor or
    direction: it is ``pace`` times (−F_y, F_x) in the plane, ``pace`` times ∇F × ∇G on the intersection of two
    surfaces, and ∇F × ``cut`` with an arbitrary vector ``cut`` on a single surface.

    >>> from exactspline.language.vector import det, dot
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(2).argument(IMPLICIT, 2)
    >>> dot(c.gradient_f, c.gamma.d(1)).is_zero
    True
    >>> bent = Vector(dot(c.hessian_fx, c.gamma.d(1)), dot(c.hessian_fy, c.gamma.d(1)))
    >>> (dot(c.gamma.d(1), bent) + dot(c.gradient_f, c.gamma.d(2))).is_zero
    True
    """

    made_of_a_curve = False

    def __init__(self, name: str, dimension: int, functions: str) -> None:
        self.name, self.dimensions, self.functions = name, (dimension,), functions
        self.axes = "xyz"[:dimension]
        self.partials = {f: _partials(f, self.axes) for f in functions}
        self.free = ("cutx", "cuty", "cutz") if dimension == 3 and functions == "f" else ("pace",)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates, free operands, partial derivatives."""
        s = PARAMETERS[:1]
        free = [Symbol(name, FREE[name], s, "") for name in self.free]
        partials = [Symbol(name, f"{f.upper()}_{name[1:]}", s, "") for f in self.functions for name in self.partials[f]]
        return (*[Symbol(x, x, s, "") for x in self.axes], *free, *partials)

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of a curve, and the additional operands."""
        vectors: dict[str, bool] = {"p": True, "w": False, "gamma": True} | {f"axis_{x}": True for x in self.axes}
        for f in self.functions:
            vectors |= dict.fromkeys(self.partials[f], False) | {f"gradient_{f}": True}
            vectors |= {f"hessian_{f}{x}": True for x in self.axes}
        return vectors | ({"cut": True} if len(self.free) > 1 else {"pace": False})

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivative of the curve, and the chain rule for the partial derivatives."""
        made: dict[str, Rule] = {x: self._along(i) for i, x in enumerate(self.axes)}
        for f in self.functions:
            made |= {name: self._chained(name) for name in self.partials[f]}
        return made

    def _along(self, i: int) -> Rule:
        return lambda named: self.velocity(named)[i]

    def _chained(self, name: str) -> Rule:
        def rule(named: Mapping[str, Any]) -> Any:
            if len(name) > ORDER:
                raise FormulaError(
                    f"a derivative of the partial derivative {name}", remedy=f"they are available up to order {ORDER}"
                )
            velocity = self.velocity(named)
            terms = [named[_sorted(name + x)] * velocity[i] for i, x in enumerate(self.axes)]
            total = terms[0]
            for term in terms[1:]:
                total = total + term
            return total

        return rule

    def velocity(self, named: Mapping[str, S]) -> Vector[S]:
        """The derivative of the curve."""
        gradients = [vector_of(named, *[f + x for x in self.axes]) for f in self.functions]
        if len(self.free) > 1:
            return cross(gradients[0], vector_of(named, *self.free))
        along = Vector(-gradients[0][1], gradients[0][0]) if len(self.axes) == 2 else cross(*gradients)
        return along.mapped(lambda x: x * named["pace"])

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of the other kind apply; those for curves of this dimension do."""
        return other is self or (
            dimension in self.dimensions and other.name in ("curve", ("plane", "space")[dimension - 2])
        )

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve with the partial derivatives along it."""
        curve = Curve(vector_of(named, *self.axes), one, polynomial=True)
        additional = {name: value for name, value in named.items() if name not in self.axes}
        return Accompanied(curve, additional, self._made)

    def _made(self, named: Mapping[str, Any]) -> dict[str, Any]:
        made = {}
        for f in self.functions:
            made[f"gradient_{f}"] = vector_of(named, *[f + x for x in self.axes])
            for x in self.axes:
                made[f"hessian_{f}{x}"] = vector_of(named, *[_sorted(f + x + y) for y in self.axes])
        return made | ({"cut": vector_of(named, *self.free)} if len(self.free) > 1 else {})


def _partials(f: str, axes: str) -> tuple[str, ...]:
    return tuple(f + "".join(each) for n in range(1, ORDER + 1) for each in combinations_with_replacement(axes, n))


def _sorted(name: str) -> str:
    """The name of a partial derivative; the order of differentiation does not matter."""
    return name[0] + "".join(sorted(name[1:]))


IMPLICIT = ImplicitKind("implicit", 2, "f")
IMPLICIT_SURFACE = ImplicitKind("implicit surface", 3, "f")
INTERSECTION = ImplicitKind("intersection", 3, "fg")
