"""All kinds of arguments. To add a kind, write a class (here or in a neighbouring file) and add an entry to `KINDS`;
readings construct arguments from its declarations.
"""

from __future__ import annotations

import copyreg
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from itertools import combinations_with_replacement
from typing import Any, cast

from exactspline.errors import FormulaError, nearest
from exactspline.language.adjoined_root import framed
from exactspline.language.arguments import (
    BARRED,
    COORDINATES,
    PARAMETERS,
    POINT,
    Accompanied,
    Curve,
    Evaluated,
    Kind,
    Operands,
    Pair,
    Rule,
    Symbol,
    T,
    constant_text,
    constants_of,
    vector_of,
)
from exactspline.language.surface_kind import CURVE_ON_SURFACE, FORMS, PLANAR_MAP, SURFACE
from exactspline.language.vector import S, Vector, cross

# ---- a curve given by its hodograph
#
# R. T. Farouki, T. Sakkalis, Pythagorean hodographs, IBM Journal of Research and Development 34 (1990): every
# polynomial plane curve whose speed is a polynomial is of this form.


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


# ---- implicit curves and surfaces
# The curve lies in the zero set, so that `∇F·γ′ = 0`: its derivative is a multiple of a vector orthogonal to ∇F. The
# chain rule gives the derivatives of all partial derivatives, `(F_x)′ = F_xx x′ + F_xy y′`. Thus every formula of
# curves can be compared with a formula in ∇F and the Hessian of F.


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


__all__ = ["CURVE_ON_SURFACE", "FORMS", "PLANAR_MAP", "SURFACE", "Kind", "Rule", "Symbol", "constant_text"]

_SUBSCRIPTS = str.maketrans("xyzuvst", "₁₂₃₄₅₆₇")
#: Names that constants must not have: those of operands, and everything else that formulas may name.
RESERVED = {*COORDINATES, *BARRED, "w", "W", "p", "d", "gamma", "point", "first", "second", "polynomial", "dimension"}
RESERVED |= {"additional", "made", "degree", "provenance", "ring", "generator", "directrix"}
#: The maximal length of the name of a constant.
LETTERS = 30


class CurveKind(Kind):
    """A curve, in any dimension or in a fixed one; together with a point if `with_point` is set, and with `constants`,
    such as the distance of an offset or the parameters of a family.
    """

    def __init__(
        self, name: str, dimensions: tuple[int, ...], *, with_point: bool = False, constants: tuple[str, ...] = ()
    ) -> None:
        self.name, self.dimensions, self.with_point, self.constants = name, dimensions, with_point, constants

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Coordinates, denominator, the coordinates of the point, and the constants."""
        point = [Symbol(POINT[i], "Q" + x.translate(_SUBSCRIPTS), ()) for i, x in enumerate(COORDINATES[:dimension])]
        functions = _functions(COORDINATES, "w", dimension, 0, polynomial)
        return (*functions, *(point if self.with_point else ()), *constants_of(self))

    def names(self, dimension: int) -> dict[str, bool]:
        """Numerator, denominator, the curve itself, the axes, the point and the constants."""
        axes = dict.fromkeys(("axis_x", "axis_y", "axis_z")[:dimension], True)
        additional = ({"point": True} if self.with_point else {}) | dict.fromkeys(self.constants, False)
        return {"p": True, "w": False, "gamma": True} | axes | additional

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve."""
        point = Vector(*[named[name] for name in POINT[:dimension]]) if self.with_point else None
        plain = _curve(named, COORDINATES[:dimension], "w", one, point)
        return Accompanied(plain, {name: named[name] for name in self.constants}) if self.constants else plain


class PairKind(Kind):
    """Two curves in space or in the plane, the first a function of s, the second of s̄."""

    def __init__(self, name: str, curve: CurveKind) -> None:
        self.name, self.curve, self.dimensions = name, curve, curve.dimensions

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands of the first curve, then those of the second."""
        first = _functions(COORDINATES, "w", dimension, 0, polynomial)
        return (*first, *_functions(BARRED, "W", dimension, 1, polynomial))

    def names(self, dimension: int) -> dict[str, bool]:
        """No names except those of the parts."""
        return {}

    @property
    def parts(self) -> dict[str, Kind]:
        """The two curves."""
        return {"first": self.curve, "second": self.curve}

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The pair."""
        first = _curve(named, COORDINATES[:dimension], "w", one)
        return Pair(first, _curve(named, BARRED[:dimension], "W", one))


class TableKind(Kind):
    """The operands of Table 1 of the paper: polynomials p1, p2, denominators w1, w2 and vectors v1, v2, all of one
    parameter.
    """

    name = "table"
    dimensions = (3,)

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The operands of index 1, then those of index 2, vectors by their components."""
        names = [(f"{x}{i}", f"d{i}") for i in "12" for x in ("p", "w", *(f"v{j}_" for j in range(dimension)))]
        return tuple(Symbol(name, name, PARAMETERS[:1], degree) for name, degree in names)

    def names(self, dimension: int) -> dict[str, bool]:
        """The scalars and vectors with index 1 and 2."""
        return {f"{x}{i}": x == "v" for i in "12" for x in "pwv"}

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The operands by name."""
        scalars = {name: x for name, x in named.items() if "_" not in name}
        vectors = {f"v{i}": Vector(*[named[f"v{j}_{i}"] for j in range(dimension)]) for i in "12"}
        return Operands(**scalars, **vectors)


class FramedKind(CurveKind):
    """A curve with the roots σ = ‖γ′‖ and, in space, ρ = ‖γ′ × γ″‖ adjoined, for readings with division.

    >>> FRAMED_SPACE.takes(SPACE, 3), FRAMED_SPACE.takes(POINT_IN_SPACE, 3), SPACE.takes(FRAMED_SPACE, 3)
    (True, False, False)
    """

    adjoins_roots = True

    @property
    def without_roots(self) -> CurveKind:
        """The kind of the curve alone."""
        plain = CURVE if len(self.dimensions) > 1 else PLANE if self.dimensions == (2,) else SPACE
        return cast(CurveKind, with_constants(plain, self.constants))

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of a curve, and the roots."""
        return super().names(dimension) | {"sigma": False} | ({"rho": False} if dimension == 3 else {})

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The curve with its roots."""
        curve: Any = super().of_operands(named, dimension, one)
        return framed(curve)


def _functions(names: str, w: str, dimension: int, which: int, polynomial: bool) -> tuple[Symbol, ...]:
    """The functions of one curve: numerators, and the denominator of a rational one."""
    bar = "\u0304" if which else ""
    letters = [*names[:dimension], *([] if polynomial else [w])]
    return tuple(Symbol(name, name.lower() + bar, (PARAMETERS[which],)) for name in letters)


def _curve(named: Mapping[str, Any], names: str, w: str, one: Any, point: Vector[Any] | None = None) -> Curve[Any]:
    return Curve(Vector(*[named[name] for name in names]), named.get(w, one), polynomial=w not in named, point=point)


CURVE, PLANE, SPACE = CurveKind("curve", (2, 3)), CurveKind("plane", (2,)), CurveKind("space", (3,))
PLANE_POINT, POINT_IN_SPACE = CurveKind("plane point", (2,), with_point=True), CurveKind("point", (3,), with_point=True)
PAIR, PLANE_PAIR = PairKind("pair", SPACE), PairKind("plane pair", PLANE)
TABLE, FRAMED = TableKind(), FramedKind("framed", (2, 3))
FRAMED_PLANE, FRAMED_SPACE = FramedKind("framed plane", (2,)), FramedKind("framed space", (3,))
#: The kinds by their names.
KINDS: dict[str, Kind] = {
    kind.name: kind
    for kind in (
        *(CURVE, PLANE, SPACE, TABLE, PAIR, PLANE_PAIR, POINT_IN_SPACE, PLANE_POINT),
        *(FRAMED, FRAMED_PLANE, FRAMED_SPACE),
        *(HODOGRAPH, IMPLICIT, IMPLICIT_SURFACE, INTERSECTION),
        *(SURFACE, PLANAR_MAP, FORMS, CURVE_ON_SURFACE),
    )
}


def with_constants(kind: Kind, names: Iterable[str]) -> Kind | None:
    """The kind with additional constants; None for a kind without constants, and if operands of the kind have these
    names.

    >>> with_constants(PLANE, ["delta"]), with_constants(FRAMED_PLANE, ["sigma"]), with_constants(TABLE, ["r"])
    (<kind plane with delta>, None, None)
    """
    constants = {*names} - {*kind.constants}
    if not constants:
        return kind
    if not isinstance(kind, (CurveKind, HodographKind)) or constants & {*kind.names(3)}:
        return None
    return _with_constants(KINDS[kind.name.partition(" with ")[0]], tuple(sorted({*constants, *kind.constants})))


@cache
def _with_constants(kind: Kind, constants: tuple[str, ...]) -> Kind:
    """One object per kind, so that kinds can be compared."""
    made: Kind = object.__new__(type(kind))
    vars(made).update(vars(kind), name=f"{kind.name} with {', '.join(constants)}", constants=constants)
    return made


def common_kind(kinds: Iterable[Kind]) -> Kind:
    """The kind of argument on which formulas of all these kinds can be evaluated, in their common dimensions: the one
    with the most operands, together with the constants of all.

    >>> common_kind([PLANE, PLANE_POINT]), common_kind([CURVE, SPACE])
    (<kind plane point>, <kind curve>)
    >>> common_kind([kind_of("plane with delta"), CURVE, kind_of("plane with r")])
    <kind plane with delta, r>
    >>> common_kind([kind_of("surface"), SPACE])
    <kind curve on a surface>

    Raises `FormulaError` if there is none, for example because the function h of a hodograph is not a constant called
    h.
    """
    given = list(kinds)
    special = [kind for kind in given if not any(kind is k for k in (CURVE, PLANE, SPACE))]
    if not special:
        return CURVE
    constants = {name for kind in special for name in kind.constants}
    others = [kind for kind in special if type(kind) is not CurveKind]
    if others:
        known = (with_constants(kind, constants) for kind in (*others, *KINDS.values()))
        takes_all = (kind for kind in known if kind and all(kind.takes(k, n) for k in given for n in kind.dimensions))
        common = next(takes_all, None)
        if common is None:
            problem = f"formulas of the kinds {', '.join(dict.fromkeys(repr(kind.name) for kind in given))}"
            raise FormulaError(problem, remedy="name formulas of one kind of argument")
        return common
    first = next((kind for kind in special if getattr(kind, "with_point", False)), special[0])
    return with_constants(first, constants) or first


def kind_of(name: str) -> Kind:
    """The kind with this name; ``with`` adds constants to a kind of curve.

    >>> kind_of("plane").dimensions, kind_of("space with r, h").names(3)["r"]
    ((2,), False)

    Raises `FormulaError`, with the nearest known names, for an unknown one.
    """
    if name in KINDS:
        return KINDS[name]
    plain, separator, constants = name.partition(" with ")
    if plain not in KINDS:
        raise FormulaError(f"there is no kind of argument called {name!r}", remedy=nearest(plain, KINDS))
    kind = KINDS[plain]
    if not separator:
        return kind
    accompanied = with_constants(kind, _constants(constants))
    if accompanied is None:
        raise FormulaError(
            f"the constants {constants} for {plain!r}",
            remedy="only curves have constants, with names that no operand has: 'plane with delta'",
        )
    return accompanied


def _constants(text: str) -> Sequence[str]:
    """The names of constants in a comma-separated list."""
    names = [name.strip() for name in text.split(",")]
    for name in names:
        plain = name.isidentifier() and name.isascii() and len(name) <= LETTERS and not hasattr(Accompanied, name)
        if not plain or name.startswith(("_", "axis_")) or name in RESERVED:
            raise FormulaError(
                f"{name!r} is not the name of a constant", remedy="write for example 'plane with delta, r'"
            )
    return names


for _kind in KINDS.values():
    # pickled by name, since kinds are compared by identity
    copyreg.pickle(type(_kind), lambda kind: (kind_of, (kind.name,)))
