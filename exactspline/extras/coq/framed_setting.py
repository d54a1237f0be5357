"""Curves with the roots of their frames: σ = ‖γ′‖ and, in space, ρ = ‖γ′ × γ″‖.

Each root follows its inverse in the list of variables; its derivative follows from its square by Leibniz' rule.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import cast

from exactspline.errors import FormulaError
from exactspline.extras.coq.settings import (
    HodographSetting,
    ImplicitSetting,
    Setting,
    Spelling,
    SurfaceCurveSetting,
    SurfaceSetting,
)
from exactspline.extras.coq.terms import leaves
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import COORDINATES, Evaluated, Operands, T
from exactspline.language.kinds import CurveKind, FramedKind, HodographKind, ImplicitKind, Kind, Symbol
from exactspline.language.surface_kind import FormsKind, SurfaceCurveKind, SurfaceKind
from exactspline.language.vector import Vector, cross, norm2
from exactspline.numbers.once import cached_property
from exactspline.readings.expression import Operation
from exactspline.readings.jet import Jet, JetRing
from exactspline.readings.rational_jet import JetFraction
from exactspline.readings.tree import Node, nodes

#: The roots of a frame, the innermost last.
ROOTS = ("sigma", "rho")


def setting_of(kind: Kind, dimension: int, order: int, *, polynomial: bool, trees: Iterable[Node]) -> Setting:
    """The setting of a kind of argument, for formulas with these trees."""
    if isinstance(kind, FramedKind):
        given = list(trees)
        used = tuple(root for root in ROOTS if any(root in leaves(tree) for tree in given))
        return _FramedSetting(kind, dimension, order, roots=used, differentiates_roots=any(map(_differentiates, given)))
    return SETTINGS.get(type(kind), Setting)(kind, dimension, order, polynomial)


#: The settings of kinds that are not those of curves.
SETTINGS: dict[type[Kind], type[Setting]] = {
    HodographKind: HodographSetting,
    ImplicitKind: ImplicitSetting,
    SurfaceKind: SurfaceSetting,
    SurfaceCurveKind: SurfaceCurveSetting,
    FormsKind: SurfaceSetting,
}


def _differentiates(tree: Node) -> bool:
    """Whether a derivative of a root occurs."""
    return any(node.op is Operation.DERIVATIVE and set(ROOTS) & leaves(node) for node in nodes(tree))


class _Rooted(CurveKind):
    """A curve with its roots as symbols, so that they are variables of the ring."""

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """Those of the curve, and the roots."""
        return (*super().symbols(dimension, polynomial=polynomial), *(Symbol(name, name, ()) for name in ROOTS))

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The operands by name."""
        return Operands(**named)


@dataclass(frozen=True)
class _FramedSetting(Setting):
    """A rational curve with σ and, in space, ρ."""

    @cached_property
    def ring(self) -> JetRing:
        """The jets, and the roots as variables."""
        return JetRing(_Rooted("curve with roots", self.kind.dimensions), self.dimension, self.order)

    def _place(self, i: int) -> int:
        """The number of the i-th variable of the ring in the list."""
        name, _ = self.ring.variables[i]
        return 2 * self.roots.index(name) + 2 if name in ROOTS else 2 * len(self.roots) + i + 1

    def flat(self, value: object) -> object:
        """A value in which a single product of roots occurs, as a fraction of the ring.

        Raises `FormulaError` for a sum in which several products occur.
        """
        if not isinstance(value, Adjoined):
            return value
        plain, rooted = cast(JetFraction, self.flat(value.plain)), cast(JetFraction, self.flat(value.rooted))
        if rooted.is_zero:
            return plain
        if not plain.is_zero:
            raise FormulaError("a denominator with and without a root", remedy="divide by products of roots")
        root = "rho" if isinstance(value.plain, Adjoined) else "sigma"
        return rooted * self._jet(root)

    def square(self, root: str) -> JetFraction:
        """The square of a root."""
        gamma = Vector(*[self.ring[x] for x in COORDINATES[: self.dimension]])
        total = norm2(gamma.d(1) if root == "sigma" else cross(gamma.d(1), gamma.d(2)))
        return JetFraction(self.ring, total.polynomial, self.ring.context.constant(1))

    def _square_text(self, root: str, shift: int) -> str:
        """The square of a root from its definition, with the positions of variables shifted by `shift`."""

        def vector(order: int) -> str:
            places = [shift + self.ring.index[x, (order,)] + 1 for x in COORDINATES[: self.dimension]]
            return "[" + "; ".join(f"var {i}" for i in places) + "]"

        v = vector(1) if root == "sigma" else f"(cross {vector(1)} {vector(2)})"
        return f"dot {v} {v}"

    def _half(self, root: str) -> str:
        """Half the derivative of the square of a root."""
        whole = Jet(self.ring, self.square(root).top).d().polynomial
        return self.expression(whole / 2)

    def preamble(self, premises: Sequence[tuple[str, str, object]]) -> list[str]:
        """The roots do not vanish because their squares do not; their derivatives, by Leibniz' rule."""
        bare = replace(self, roots=())
        lines = [
            f"pose (k := {self.spelling.jets}).",
            f"pose (r0 := {bare.spelling.rules}).",
            "assert (R0 : forall q, rules_hold K k q (r0 q)) by rules_by_computation.",
        ]
        for root in self.roots:
            own = self.named(root)
            lines += [
                f"assert (N{root} : {own} <> zero K).",
                f"{{ pose (c := {bare.spelling.deep}).",
                f"  apply (root_nonzero K {own} _ H{root}).",
                f"  {self._because(root, premises)} }}",
            ]
            if self.differentiates_roots:
                half, square = f"({bare._half(root)})%formula", f"({bare._square_text(root, 0)})%formula"
                lines += [
                    f"assert (S{root} : value K k (eder s {square}) = value K k (eadd {half} {half})).",
                    "{ apply (one_value K k r0 R0 [] I [] [] (Forall_nil _)). vm_cast_no_check (eq_refl true). }",
                    f"assert (D{root} := root_derivative K {own} _ (value K k {half}) H{root} N{root} P2 S{root}).",
                    f"assert (I{root} := inverse_derivative K {own} _ N{root} D{root}).",
                ]
        first = "; ".join(f"quotient K (one K) {self.named(root)}; {self.named(root)}" for root in self.roots)
        squares = "; ".join(self._square_text(root, 2 * (len(self.roots) - i - 1)) for i, root in enumerate(self.roots))
        held = "I"
        for root in reversed(self.roots):
            held = f"(conj (root_inverse K {self.named(root)} N{root}) (conj H{root} {held}))"
        return [
            *lines,
            f"pose (l := [{first}] ++ {self.spelling.jets}).",
            f"pose (r := {self.spelling.rules}).",
            "assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.",
            f"pose (roots := [{squares}]%formula : list expr).",
            f"assert (Q : roots_hold K l roots) by exact {held}.",
        ]

    def _because(self, root: str, premises: Sequence[tuple[str, str, object]]) -> str:
        """The proof that the square of a root does not vanish: it divides something that does not vanish."""
        bare, square = replace(self, roots=()), self.square(root).top
        for name, term, value in premises:
            if not isinstance(value, JetFraction) or not value.bottom.is_one():
                continue
            rest, remainder = divmod(value.top, square)
            if not remainder:
                parts = [term, bare.expression(rest), bare._square_text(root, 0)]
                e, b, a = (f"({part} : expr)%formula" for part in parts)
                return (
                    f"assert (Z : value K k {a} <> zero K).\n  "
                    f"{{ apply (factor_nonzero K k r0 R0 [] I [] [] (Forall_nil _) {e} {b} {a}); "
                    f"[vm_cast_no_check (eq_refl true) | vm_cast_no_check {name}]. }}\n  vm_cast_no_check Z."
                )
        raise FormulaError(f"nothing shows that {root} is not zero", remedy="assume that its square is not")

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """The functions."""
        return self.kind.symbols(self.dimension)

    def _spelled(self) -> Spelling:
        rules, n = list[str](), self.dimension
        for root in self.roots if self.differentiates_roots else ():  # of the roots and their inverses
            place, half = self.position(root), self._half(root)
            rules.append(f"({place}%positive, ({half}) * var {place - 1})")
            rules.append(f"({place - 1}%positive, - (({half}) * var {place - 1} ^ 3))")
        functions = [self.named(symbol.name) for symbol in self.symbols]
        bound = [] if n == 2 else ["velocity_", "binormal_"]
        roots = ROOTS[: n - 1]
        introduced = [*functions, *map(self.named, roots), "Hw", *bound, *[f"H{name}" for name in roots]]
        curve = f"homogeneous s {self.variables(COORDINATES[:n])} ({self.variable('w')}) []"
        sigma, rho = (self.variable(root) if root in self.roots else "num 0" for root in ROOTS)
        return self._by_chains(introduced, f"Framed ({curve}) ({sigma}) ({rho})", rules)
