"""A curve given by its hodograph: the derivative of a Pythagorean-hodograph curve is ``(u² − v², 2 u v) h``.

R. T. Farouki, T. Sakkalis, Pythagorean hodographs, IBM Journal of Research and Development 34 (1990): every polynomial
plane curve whose speed is a polynomial is of this form.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from exactspline.language.arguments import PARAMETERS, Accompanied, Curve, Evaluated, T
from exactspline.language.kind import Kind, Rule, Symbol, constants_of
from exactspline.language.vector import Vector


class HodographKind(Kind):
    """A polynomial plane curve with ``γ′ = (u² − v², 2 u v) h``, functions u and v of degree d and h of degree e.

    It is a curve with w = 1, so that formulas for curves and for plane curves apply to it. In addition it has ``u``,
    ``v``, ``h``, the ``velocity`` γ′ and the ``speed`` (u² + v²) h, whose square is γ′·γ′. If it is *polynomial*, then
    h = 1.

    >>> from exactspline.language.vector import norm2
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(2).argument(HODOGRAPH, 2)
    >>> norm2(c.gamma.d(1)) == c.speed * c.speed, c.gamma.d(2) == c.velocity.d(1)
    (True, True)
    """

    name = "hodograph"
    dimensions = (2,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The coordinates, u and v, and the common factor h."""
        s = PARAMETERS[:1]
        degree = "2d + 1" if polynomial else "2d + e + 1"
        curve = (Symbol("x", "x", s, degree), Symbol("y", "y", s, degree), Symbol("u", "u", s), Symbol("v", "v", s))
        return (*curve, *(() if polynomial else (Symbol("h", "h", s, "e"),)), *constants_of(self))

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of a curve, and the additional operands."""
        curve = {"p": True, "w": False, "gamma": True, "axis_x": True, "axis_y": True}
        own = {"u": False, "v": False, "h": False, "velocity": True, "speed": False}
        return curve | own | dict.fromkeys(self.constants, False)

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivatives of the coordinates: the hodograph."""
        return {"x": lambda named: _velocity(named)[0], "y": lambda named: _velocity(named)[1]}

    def takes(self, other: Kind, dimension: int) -> bool:
        """Whether formulas of the other kind apply; those for plane curves do."""
        alike = isinstance(other, HodographKind) or other.name.partition(" with ")[0] in ("curve", "plane")
        return dimension == 2 and alike and {*other.constants} <= {*self.constants}

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve with its hodograph."""
        return curve_of_hodograph(named, one, self.constants)


def curve_of_hodograph(named: Mapping[str, T], one: T, constants: Iterable[str] = ()) -> Accompanied[T]:
    """The argument from its named operands and constants; h is 1 if it is missing."""
    curve = Curve(Vector(named["x"], named["y"]), one, polynomial=True)
    return Accompanied(curve, {name: named.get(name, one) for name in ("u", "v", "h", *constants)}, _made)


def _velocity(named: Mapping[str, Any]) -> Vector[Any]:
    u, v = named["u"], named["v"]
    velocity = Vector(u * u - v * v, u * v + u * v)
    return velocity * named["h"] if "h" in named else velocity


def _made(named: Mapping[str, Any]) -> dict[str, Any]:
    u, v, h = named["u"], named["v"], named["h"]
    return {"velocity": _velocity(named), "speed": (u * u + v * v) * h}


HODOGRAPH = HodographKind()
