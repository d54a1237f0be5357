"""The quantified argument of a theorem: the argument of its formulas, as a term and as jets in the position γ instead
of the numerators p = w γ, in which naive formulas are short.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from flint import fmpq_mpoly

from exactspline.errors import FormulaError
from exactspline.exact import mpq
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, POINT
from exactspline.language.kinds import CurveKind, Kind, PairKind, Symbol, TableKind
from exactspline.readings.jet import JetRing
from exactspline.readings.rational_jet import JetFraction
from exactspline.verification.coq.terms import integer


@dataclass(frozen=True)
class Setting:
    """A kind of argument in a dimension, with derivatives up to an order."""

    kind: Kind
    dimension: int
    order: int

    @cached_property
    def ring(self) -> JetRing:
        """The jets of positions, denominators and constants."""
        return JetRing(self.kind, self.dimension, self.order)

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """The functions, then the constants."""
        return self.kind.symbols(self.dimension)

    @property
    def has_point(self) -> bool:
        """Whether a point is beside the curve."""
        return isinstance(self.kind, CurveKind) and self.kind.with_point

    @property
    def shape(self) -> str:
        """Its name in the base: ``plane``, ``space_point``, ``pair``, ``table``."""
        if isinstance(self.kind, PairKind):
            return "pair"
        if isinstance(self.kind, TableKind):
            return "table"
        return ("plane" if self.dimension == 2 else "space") + ("_point" if self.has_point else "")

    @property
    def quantifier(self) -> str:
        """The quantifier of the theorem."""
        return {
            "plane": "every_plane_curve",
            "space": "every_space_curve",
            "plane_point": "every_plane_curve_with_point",
            "space_point": "every_space_curve_with_point",
            "pair": "every_two_curves",
            "table": "every_table",
        }[self.shape]

    @property
    def weights(self) -> tuple[str, ...]:
        """The denominators, which have no zero."""
        return {"pair": ("w", "W"), "table": ("w1", "w2")}.get(self.shape, ("w",))

    @cached_property
    def argument(self) -> Evaluated:
        """The argument in the fraction reading, its numerators w γ."""
        one = self.ring.context.constant(1)
        return self.kind.argument(self.dimension, self._operand, JetFraction(self.ring, one, one))

    def _operand(self, symbol: Symbol) -> JetFraction:
        weight = "w" if symbol.name in COORDINATES else "W" if symbol.name in BARRED else ""
        if weight and symbol.name != weight and self.shape != "table":
            product: JetFraction = self._jet(symbol.name) * self._jet(weight)
            return product
        return self._jet(symbol.name)

    def _jet(self, name: str) -> JetFraction:
        return JetFraction(self.ring, self.ring[name].polynomial, self.ring.context.constant(1))

    def position(self, name: str, order: int = 0) -> int:
        """The number of a variable in the list of jets."""
        functions = [symbol.name for symbol in self.symbols if symbol.parameters]
        if name in functions:
            return functions.index(name) * (self.order + 1) + order + 1
        constants = [symbol.name for symbol in self.symbols if not symbol.parameters]
        return len(functions) * (self.order + 1) + constants.index(name) + 1

    def _place(self, i: int) -> int:
        """The number of the i-th variable of the ring."""
        name, orders = self.ring.variables[i]
        return self.position(name, sum(orders))

    def named(self, name: str) -> str:
        """The variable of a proof for an operand."""
        if self.has_point and name in POINT[: self.dimension]:
            return f"q{POINT.index(name) + 1}"
        return f"{name}_"

    @property
    def introduced(self) -> list[str]:
        """The variables of a proof, and the hypotheses about them, in the order of the quantifier."""
        names = [self.named(symbol.name) for symbol in self.symbols]
        constants = [f"H{self.named(symbol.name)}" for symbol in self.symbols if not symbol.parameters]
        return [*names, *constants, *[f"H{weight}" for weight in self.weights]]

    @property
    def jets(self) -> str:
        """The list of jets."""
        parts = []
        for symbol in self.symbols:
            if symbol.parameters:
                parameter = "s" if symbol.parameters == PARAMETERS[:1] else "s_bar"
                parts.append(f"jets {parameter} {self.order} {self.named(symbol.name)}")
        constants = [self.named(symbol.name) for symbol in self.symbols if not symbol.parameters]
        return " ++ ".join([*parts, *([f"[{'; '.join(constants)}]"] if constants else [])])

    @property
    def rules(self) -> str:
        """What the derivatives of the jets are."""
        chains = {str(parameter): list[str]() for parameter in PARAMETERS}
        for symbol in self.symbols:
            if symbol.parameters:
                chains[symbol.parameters[0]].append(f"chain {self.position(symbol.name)} {self.order}")
        constants = [str(self.position(symbol.name)) for symbol in self.symbols if not symbol.parameters]
        if constants:
            chains[PARAMETERS[0]].append(f"constants [{'; '.join(constants)}]%positive")
        first, second = (" ++ ".join(chains[parameter]) or "[]" for parameter in PARAMETERS)
        return f"of_parameters ({first}) ({second})"

    @property
    def deep(self) -> str:
        """The argument as expressions."""

        def variables(names: str) -> str:
            return "[" + "; ".join(f"var {self.position(name)}" for name in names) + "]"

        n = self.dimension
        if self.shape == "table":
            vectors = [[f"var {self.position(f'v{j}_{i}')}" for j in range(n)] for i in "12"]
            one, two = ([f"(var {self.position(f'{x}{i}')})" for x in "pw"] for i in "12")
            return f"Table {' '.join(one)} [{'; '.join(vectors[0])}] {' '.join(two)} [{'; '.join(vectors[1])}]"
        first = f"homogeneous s {variables(COORDINATES[:n])} (var {self.position('w')})"
        if self.shape == "pair":
            second = f"homogeneous s_bar {variables(BARRED[:n])} (var {self.position('W')})"
            return f"Pair ({first} []) ({second} [])"
        return f"{first} {variables(POINT[:n]) if self.has_point else '[]'}"

    def expression(self, polynomial: fmpq_mpoly) -> str:
        """A polynomial with integer coefficients as an expression."""
        terms = []
        for exponents, coefficient in polynomial.terms():
            c = mpq(int(coefficient.p), int(coefficient.q))
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
