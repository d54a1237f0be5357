"""The quantified argument of a theorem: the argument of its formulas, as a term, and as jets of the position γ instead
of the numerators p = w γ; naive formulas are short in these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from flint import fmpq_mpoly

from exactspline.errors import FormulaError
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, POINT
from exactspline.language.choices import Parameter
from exactspline.language.implicit_kinds import ImplicitKind
from exactspline.language.kinds import CurveKind, Kind, PairKind, Symbol, TableKind
from exactspline.numbers.exact import from_flint
from exactspline.readings.jet import JetRing
from exactspline.readings.rational_jet import JetFraction
from exactspline.verification.coq.terms import integer

PLAIN = ("plane", "space")
#: What follows ``every_`` in the name of a quantifier, where it is not the shape.
QUANTIFIERS = {
    **{"plane": "plane_curve", "plane_point": "plane_curve_with_point", "plane_with": "plane_curve_with"},
    **{"space": "space_curve", "space_point": "space_curve_with_point", "space_with": "space_curve_with"},
    **{"polynomial_plane": "polynomial_plane_curve", "polynomial_space": "polynomial_space_curve"},
    **{"framed_plane": "framed_plane_curve", "framed_space": "framed_space_curve"},
    "pair": "two_curves",
}
#: The denominators by the shape; by default w alone.
WEIGHTS = {
    **{"pair": ("w", "W"), "table": ("w1", "w2")},
    **dict.fromkeys(("hodograph", "implicit_curve", "implicit_surface", "two_forms"), ()),
}


@dataclass(frozen=True)
class Setting:
    """A kind of argument in a dimension, with derivatives up to an order; `polynomial` where the denominator is 1."""

    kind: Kind
    dimension: int
    order: int
    polynomial: bool = False

    @cached_property
    def ring(self) -> JetRing:
        """The jets of positions, denominators and constants."""
        return JetRing(self.kind, self.dimension, self.order, polynomial=self.polynomial)

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """The functions, then the constants."""
        return self.kind.symbols(self.dimension, polynomial=self.polynomial)

    @property
    def has_point(self) -> bool:
        """Whether the argument includes a point."""
        return isinstance(self.kind, CurveKind) and self.kind.with_point

    @property
    def constants(self) -> tuple[str, ...]:
        """The constants that accompany the curve."""
        return self.kind.constants if isinstance(self.kind, CurveKind) else ()

    @property
    def shape(self) -> str:
        """Its name in the base: ``plane``, ``space_point``, ``pair``, ``table``.

        Raises `FormulaError` for a kind of argument without a name in the base.
        """
        if isinstance(self.kind, PairKind):
            return "pair"
        if isinstance(self.kind, TableKind):
            return "table"
        beside = "_point" if self.has_point else "_with" if self.constants else ""
        if (self.has_point and self.constants) or (self.polynomial and beside):
            raise FormulaError(f"no quantifier over the kind {self.kind.name!r}", remedy="add one to the base")
        plain = PLAIN[self.dimension - 2]
        return f"polynomial_{plain}" if self.polynomial else f"{plain}{beside}"

    @property
    def quantifier(self) -> str:
        """The quantifier of the theorem."""
        counted = f" {len(self.constants)}" if self.constants else ""
        return f"every_{QUANTIFIERS.get(self.shape, self.shape)}{counted}"

    @property
    def opening(self) -> str:
        """The first step of a proof, before the variables are introduced."""
        unfolded = self.shape in ("table", "two_forms")
        return f"unfold every_{self.shape}" if unfolded else f"apply {self.shape}_by_position"

    @property
    def weights(self) -> tuple[str, ...]:
        """The denominators, which have no zeros."""
        return () if self.polynomial else WEIGHTS.get(self.shape, ("w",))

    @property
    def roots(self) -> tuple[str, ...]:
        """The square roots in addition to the jets."""
        return ()

    @property
    def differentiates_roots(self) -> bool:
        """Whether derivatives of roots occur."""
        return False

    @cached_property
    def argument(self) -> Evaluated:
        """The argument in the fraction reading, its numerators w γ."""
        one = self.ring.context.constant(1)
        made = JetFraction(self.ring, one, one)
        return self.kind.argument(self.dimension, self._operand, made, polynomial=self.polynomial)

    def flat(self, value: object) -> object:
        """A value as a fraction of the ring."""
        return value

    def _operand(self, symbol: Symbol) -> JetFraction:
        weight = "w" if symbol.name in COORDINATES else "W" if symbol.name in BARRED else ""
        if weight and symbol.name != weight and self.shape != "table" and weight in self.weights:
            product: JetFraction = self._jet(symbol.name) * self._jet(weight)
            return product
        return self._jet(symbol.name)

    def _jet(self, name: str) -> JetFraction:
        return JetFraction(self.ring, self.ring[name].polynomial, self.ring.context.constant(1))

    def position(self, name: str, order: int = 0) -> int:
        """The number of a variable in the list of jets."""
        return self._place(self.ring.index[name, (order,)])

    def _place(self, i: int) -> int:
        """The number of the i-th variable of the ring."""
        return i + 1

    def named(self, name: str) -> str:
        """The variable of a proof for an operand."""
        if self.has_point and name in POINT[: self.dimension]:
            return f"q{POINT.index(name) + 1}"
        return f"{name}_"

    @property
    def introduced(self) -> list[str]:
        """The variables of a proof, and the hypotheses about them, in the order of the quantifier."""
        weights = [f"H{weight}" for weight in self.weights]
        if self.constants:
            functions = [self.named(symbol.name) for symbol in self.symbols if symbol.parameters]
            return [*functions, *weights, *[x for name in self.constants for x in (f"{name}_", f"H{name}_")]]
        names = [self.named(symbol.name) for symbol in self.symbols]
        constants = [f"H{self.named(symbol.name)}" for symbol in self.symbols if not symbol.parameters]
        return [*names, *constants, *weights]

    @property
    def jets(self) -> str:
        """The list of jets."""
        rest = [self.named(name) for name in (*self.ring.rules, *self.ring.constants)]
        parts = []
        for symbol in self.symbols:
            if symbol.parameters and symbol.name not in self.ring.rules:
                parameter = "s" if symbol.parameters == PARAMETERS[:1] else "s_bar"
                parts.append(f"jets {parameter} {self.order} {self.named(symbol.name)}")
        return " ++ ".join([*parts, *([f"[{'; '.join(rest)}]"] if rest else [])])

    @property
    def own_rules(self) -> list[str]:
        """The rules other than those of jets and constants, for the first parameter."""
        return []

    @property
    def rules(self) -> str:
        """The rules for the derivatives of the jets."""
        chains = {str(parameter): list[str]() for parameter in PARAMETERS}
        for symbol in self.symbols:
            if symbol.parameters and symbol.name not in self.ring.rules:
                chains[symbol.parameters[0]].append(f"chain {self.position(symbol.name)} {self.order}")
        constants = [str(self.position(symbol.name)) for symbol in self.symbols if not symbol.parameters]
        if constants:
            chains[PARAMETERS[0]].append(f"constants [{'; '.join(constants)}]%positive")
        if own := self.own_rules:
            chains[PARAMETERS[0]].append(f"[{'; '.join(own)}]%formula")
        first, second = (" ++ ".join(chains[parameter]) or "[]" for parameter in PARAMETERS)
        return f"of_parameters ({first}) ({second})"

    def preamble(self, premises: Sequence[tuple[str, str, object]]) -> list[str]:
        """The steps that define the variables of the checker; premises are given by name, term and value."""
        return [
            f"pose (l := {self.jets}).",
            f"pose (r := {self.rules}).",
            "assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.",
            "pose (roots := [] : list expr).",
            "assert (Q : roots_hold K l roots) by exact I.",
        ]

    def variable(self, name: str, order: int = 0) -> str:
        """A variable of the checker."""
        return f"var {self.position(name, order)}"

    def variables(self, names: Sequence[str]) -> str:
        """A list of variables of the checker."""
        return "[" + "; ".join(map(self.variable, names)) + "]"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        n = self.dimension
        if self.shape == "table":
            vectors = [self.variables([f"v{j}_{i}" for j in range(n)]) for i in "12"]
            one, two = ([f"({self.variable(f'{x}{i}')})" for x in "pw"] for i in "12")
            return f"Table {' '.join(one)} {vectors[0]} {' '.join(two)} {vectors[1]}"
        weight = "number 1" if self.polynomial else self.variable("w")
        first = f"homogeneous s {self.variables(COORDINATES[:n])} ({weight})"
        if self.shape == "pair":
            second = f"homogeneous s_bar {self.variables(BARRED[:n])} ({self.variable('W')})"
            return f"Pair ({first} []) ({second} [])"
        curve = f"{first} {self.variables(POINT[:n]) if self.has_point else '[]'}"
        return f"Accompanied ({curve}) {self.variables(self.constants)}" if self.constants else curve

    def expression(self, polynomial: fmpq_mpoly) -> str:
        """A polynomial with integer coefficients as an expression."""
        terms = []
        for exponents, coefficient in polynomial.terms():
            c = from_flint(coefficient)
            if c.denominator != 1:
                raise FormulaError(f"the coefficient {c}", remedy="multiply the denominators out")
            factors = [
                f"var {self._place(i)}" + (f" ^ {int(e)}" if e > 1 else "") for i, e in enumerate(exponents) if e
            ]
            if abs(c) != 1 or not factors:
                factors.insert(0, f"num {integer(abs(int(c)))}")
            terms.append(("- " if c < 0 else "+ ") + " * ".join(factors))
        text = " ".join(terms) or "+ num 0"
        return text.removeprefix("+ ") if text.startswith("+") else f"num 0 {text}"


@dataclass(frozen=True)
class HodographSetting(Setting):
    """A polynomial plane curve with γ′ = (u² − v², 2uv) h; a polynomial one has h = 1."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "primitive_hodograph" if self.polynomial else "hodograph"

    @property
    def introduced(self) -> list[str]:
        """The curve, then the functions that define its derivatives."""
        return [*[self.named(symbol.name) for symbol in self.symbols], "Hx", "Hy"]

    @property
    def _factor(self) -> str:
        return "number 1" if self.polynomial else self.variable("h")

    @property
    def own_rules(self) -> list[str]:
        """The derivatives of the coordinates."""
        x, y = self.position("x"), self.position("y")
        u, v = self.variable("u"), self.variable("v")
        return [
            f"({x}%positive, ({u} * {u} - {v} * {v}) * {self._factor})",
            f"({y}%positive, ({u} * {v} + {u} * {v}) * {self._factor})",
        ]

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        beside = f"[{self.variable('u')}; {self.variable('v')}; {self._factor}]"
        return f"Accompanied (homogeneous s {self.variables('xy')} (number 1) []) {beside}"


@dataclass(frozen=True)
class ImplicitSetting(Setting):
    """A curve along which a function F of the coordinates is constant, and the partial derivatives of F."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        assert isinstance(self.kind, ImplicitKind)
        if self.kind.functions != "f":
            raise FormulaError(f"no quantifier over the kind {self.kind.name!r}", remedy="add one to the base")
        return "implicit_curve" if self.dimension == 2 else "implicit_surface"

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """Coordinates, free operands, and the partial derivatives up to the second order."""
        return tuple(
            symbol for symbol in self.kind.symbols(self.dimension) if len(symbol.name) <= 3 or self._free(symbol)
        )

    def _free(self, symbol: Symbol) -> bool:
        assert isinstance(self.kind, ImplicitKind)
        return symbol.name in self.kind.free

    @property
    def _axes(self) -> str:
        return COORDINATES[: self.dimension]

    @property
    def introduced(self) -> list[str]:
        """The coordinates, the free operands, the partial derivatives; then the hypotheses about derivatives."""
        names = [self.named(symbol.name) for symbol in self.symbols]
        hypotheses = [f"H{x}" for x in self._axes] + [f"Hf{x}" for x in self._axes]
        return [*names, *(f"d{x}_" for x in self._axes), *hypotheses]

    @property
    def jets(self) -> str:
        """The jets of the free operands, then the other symbols."""
        rest = [self.named(symbol.name) for symbol in self.symbols if not self._free(symbol)]
        free = [f"jets s {self.order} {self.named(symbol.name)}" for symbol in self.symbols if self._free(symbol)]
        return " ++ ".join([*free, f"[{'; '.join(rest)}]"])

    @property
    def _velocity(self) -> list[str]:
        f = [self.variable(f"f{x}") for x in self._axes]
        if self.dimension == 2:
            pace = self.variable("pace")
            return [f"(- ({f[1]}) * {pace})", f"({f[0]} * {pace})"]
        cut = [self.variable(f"cut{x}") for x in self._axes]
        return [f"({f[i]} * {cut[j]} - {f[j]} * {cut[i]})" for i, j in ((1, 2), (2, 0), (0, 1))]

    def _second(self, x: str, y: str) -> str:
        return self.variable("f" + "".join(sorted(x + y)))

    @property
    def own_rules(self) -> list[str]:
        """The velocity of the curve, and the chain rule."""
        rules = [f"({self.position(x)}%positive, {v})" for x, v in zip(self._axes, self._velocity, strict=True)]
        for x in self._axes:
            terms = [f"{self._second(x, y)} * {v}" for y, v in zip(self._axes, self._velocity, strict=True)]
            rules.append(f"({self.position(f'f{x}')}%positive, {' + '.join(terms)})")
        return rules

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        assert isinstance(self.kind, ImplicitKind)
        rows = ["[" + "; ".join(self._second(x, y) for y in self._axes) + "]" for x in self._axes]
        gradient = self.variables([f"f{x}" for x in self._axes])
        curve = f"homogeneous s {self.variables(self._axes)} (number 1) []"
        return f"Implicit ({curve}) {self.variables(self.kind.free)} {gradient} [{'; '.join(rows)}]"


@dataclass(frozen=True)
class SurfaceSetting(Setting):
    """A rational surface in space, or a rational map of the plane, with all partial derivatives up to an order."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "planar_map" if self.dimension == 2 else "surface"

    @property
    def introduced(self) -> list[str]:
        """The functions, that derivatives commute, and that the denominator has no zero."""
        return [*[self.named(symbol.name) for symbol in self.symbols], "C", *[f"H{weight}" for weight in self.weights]]

    @property
    def jets(self) -> str:
        """The list of partial derivatives."""
        return " ++ ".join(f"partials {self.order} {self.named(symbol.name)}" for symbol in self.symbols)

    def position(self, name: str, order: int = 0) -> int:
        """The number of a function, or of its derivative with respect to u."""
        return self._place(self.ring.index[name, (order, 0)])

    @property
    def rules(self) -> str:
        """The rules for the derivatives of the jets."""
        first, second = (
            " ++ ".join(f"grid {self.position(symbol.name)} {self.order} {i}" for symbol in self.symbols)
            for i, _ in enumerate((Parameter.U, Parameter.V))
        )
        return f"of_parameters ({first}) ({second})"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        return f"Patch (homogeneous s {self.variables(COORDINATES[: self.dimension])} ({self.variable('w')}) [])"


@dataclass(frozen=True)
class FormsSetting(SurfaceSetting):
    """Two quadratic forms, functions of u and v, and a function w."""

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "two_forms"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        return f"Accompanied (rational_curve s [] ({self.variable('w')}) []) {self.variables('EFGLMN')}"


@dataclass(frozen=True)
class SurfaceCurveSetting(Setting):
    """A curve on a rational surface: its parameters u and v with their derivatives, and the partial derivatives of the
    surface, which are differentiated along the curve by the chain rule.
    """

    @property
    def shape(self) -> str:
        """Its name in the base."""
        return "curve_on_a_surface"

    @property
    def _route(self) -> tuple[str, ...]:
        return tuple(self.kind.composed.values())

    @property
    def _coordinates(self) -> tuple[str, ...]:
        return tuple(symbol.name for symbol in self.symbols if symbol.name not in self._route)

    def _operand(self, symbol: Symbol) -> JetFraction:
        return self._jet(symbol.name) if symbol.name in self._route else super()._operand(symbol)

    @property
    def introduced(self) -> list[str]:
        """The functions, that derivatives commute, the chain rule, and that the denominator has no zero."""
        names = [self.named(name) for name in (*self._route, *self._coordinates)]
        return [*names, "C", *[f"F{name}" for name in self._coordinates], *[f"H{weight}" for weight in self.weights]]

    @property
    def jets(self) -> str:
        """The derivatives of the parameters, then the partial derivatives of the surface."""
        route = [f"jets time {self.order} {self.named(name)}" for name in self._route]
        return " ++ ".join([*route, *[f"partials {self.order} {self.named(name)}" for name in self._coordinates]])

    def position(self, name: str, order: int = 0) -> int:
        """The number of a parameter or its derivative, or of a coordinate or its derivative with respect to u."""
        orders = (order,) if name in self._route else (order, 0)
        return self._place(self.ring.index[name, orders])

    @property
    def rules(self) -> str:
        """The rules for the derivatives of the jets: with respect to u, to v, and along the curve."""
        by_u, by_v = ([f"grid {self.position(name)} {self.order} {i}" for name in self._coordinates] for i in (0, 1))
        along = [f"chain {self.position(name)} {self.order}" for name in self._route]
        paces = " ".join(str(self.position(name, 1)) for name in self._route)
        along += [f"chained {self.position(name)} {self.order} {paces}" for name in self._coordinates]
        first, second, third = (" ++ ".join(rules) for rules in (by_u, by_v, along))
        return f"of_three_parameters ({first}) ({second}) ({third})"

    @property
    def deep(self) -> str:
        """The argument as expressions."""
        net = f"homogeneous time {self.variables(COORDINATES[: self.dimension])} ({self.variable('w')}) []"
        return f"Path (Patch ({net})) {self.variables(self._route)}"
