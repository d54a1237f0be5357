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
from exactspline.language.kinds import CurveKind, Kind, PairKind, Symbol, TableKind
from exactspline.numbers.exact import from_flint
from exactspline.readings.jet import JetRing
from exactspline.readings.rational_jet import JetFraction
from exactspline.verification.coq.terms import integer


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
        plain = "plane" if self.dimension == 2 else "space"
        return f"polynomial_{plain}" if self.polynomial else f"{plain}{beside}"

    @property
    def quantifier(self) -> str:
        """The quantifier of the theorem."""
        words = {
            "plane": "every_plane_curve",
            "space": "every_space_curve",
            "plane_point": "every_plane_curve_with_point",
            "space_point": "every_space_curve_with_point",
            "plane_with": f"every_plane_curve_with {len(self.constants)}",
            "space_with": f"every_space_curve_with {len(self.constants)}",
            "polynomial_plane": "every_polynomial_plane_curve",
            "polynomial_space": "every_polynomial_space_curve",
            "pair": "every_two_curves",
            "table": "every_table",
        }
        return words[self.shape]

    @property
    def opening(self) -> str:
        """The first step of a proof, before the variables are introduced."""
        return "unfold every_table" if self.shape == "table" else f"apply {self.shape}_by_position"

    @property
    def weights(self) -> tuple[str, ...]:
        """The denominators, which have no zeros."""
        names = {"pair": ("w", "W"), "table": ("w1", "w2")}.get(self.shape, ("w",))
        return () if self.polynomial else names

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
