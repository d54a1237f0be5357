"""The quantified argument of a theorem: the argument of its formulas, as a term, and as jets of the position γ instead
of the numerators p = w γ, since naive formulas are short in γ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, cast

from flint import fmpq_mpoly

from exactspline.errors import FormulaError
from exactspline.extras.coq.formulas import leaves, sum_of_products
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, POINT, Evaluated, Operands, T
from exactspline.language.kinds import (
    CurveKind,
    FramedKind,
    HodographKind,
    ImplicitKind,
    Kind,
    PairKind,
    Symbol,
    TableKind,
)
from exactspline.language.surface_kind import FormsKind, SurfaceCurveKind, SurfaceKind
from exactspline.language.vector import Vector, cross, norm2
from exactspline.numbers.exact import from_flint
from exactspline.numbers.once import cached_property
from exactspline.readings.jet import Jet, JetFraction, JetRing
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node, nodes

#: The names in the base of kinds that are not curves alone, in the plane and in space.
SHAPES: dict[type[Kind], tuple[str, str]] = {
    PairKind: ("plane_pair", "pair"),
    TableKind: ("table", "table"),
    FramedKind: ("framed_plane", "framed_space"),
    HodographKind: ("hodograph", "hodograph"),
    ImplicitKind: ("implicit_curve", "implicit_surface"),
    SurfaceKind: ("planar_map", "surface"),
    SurfaceCurveKind: ("curve_on_a_surface", "curve_on_a_surface"),
    FormsKind: ("two_forms", "two_forms"),
}
#: The text after ``every_`` in the name of a quantifier, if it is not the shape.
QUANTIFIERS = {
    **{"plane": "plane_curve", "plane_point": "plane_curve_with_point", "plane_with": "plane_curve_with"},
    **{"space": "space_curve", "space_point": "space_curve_with_point", "space_with": "space_curve_with"},
    **{"polynomial_plane": "polynomial_plane_curve", "polynomial_space": "polynomial_space_curve"},
    **{"framed_plane": "framed_plane_curve", "framed_space": "framed_space_curve"},
    **{"plane_pair": "two_plane_curves", "pair": "two_curves"},
}
#: The denominators by the shape; by default w alone.
WEIGHTS = {
    **{"plane_pair": ("w", "W"), "pair": ("w", "W"), "table": ("w1", "w2")},
    **dict.fromkeys(("hodograph", "implicit_curve", "implicit_surface", "two_forms"), ()),
}


class _Spelling(NamedTuple):
    """The notation of an argument: the variables of a proof and the hypotheses about them, in the order of the
    quantifier; the list of jets; the rules for their derivatives; the argument as expressions.
    """

    introduced: list[str]
    jets: str
    rules: str
    deep: str


@dataclass(frozen=True)
class Setting:
    """A kind of argument in a dimension, with derivatives up to an order; `polynomial` where the denominator is 1. The
    square `roots` of a frame precede the jets; `differentiates_roots` says whether derivatives of roots occur.
    """

    kind: Kind
    dimension: int
    order: int
    polynomial: bool = False
    roots: tuple[str, ...] = ()
    differentiates_roots: bool = False

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
        return self.kind.constants

    @property
    def shape(self) -> str:
        """The name of the kind in the base: ``plane``, ``space_point``, ``pair``, ``table``, …

        Raises `FormulaError` for a kind of argument without a name in the base.
        """
        plain = SHAPES.get(type(self.kind), ("plane", "space"))[self.dimension - 2]
        before = {"hodograph": "primitive_", "plane": "polynomial_", "space": "polynomial_"}.get(plain, "")
        beside = "_point" if self.has_point else "_with" if self.constants else ""
        several = isinstance(self.kind, ImplicitKind) and self.kind.functions != "f"
        several |= bool(self.constants) and type(self.kind) is not CurveKind
        if several or (self.has_point and self.constants) or (self.polynomial and (beside or not before)):
            raise FormulaError(f"no quantifier over the kind {self.kind.name!r}", remedy="add one to the base")
        return f"{before if self.polynomial else ''}{plain}{beside}"

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
            return self._jet(symbol.name) * self._jet(weight)
        return self._jet(symbol.name)

    def _jet(self, name: str) -> JetFraction:
        return JetFraction(self.ring, self.ring[name].polynomial, self.ring.context.constant(1))

    def position(self, name: str, order: int = 0) -> int:
        """The number of a variable in the list of jets, or of its derivative with respect to the first parameter."""
        parameters = 1 if name in self.ring.rules else max(len(self.ring.symbols[name].parameters), 1)
        return self._place(self.ring.index[name, (order, *[0] * (parameters - 1))])

    def _place(self, i: int) -> int:
        """The number of the i-th variable of the ring."""
        return i + 1

    def named(self, name: str) -> str:
        """The variable of a proof for an operand."""
        return name.removeprefix("_") if self.has_point and name in POINT[: self.dimension] else f"{name}_"

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
        weights, n = [f"H{weight}" for weight in self.weights], self.dimension
        if self.constants:
            functions = [self.named(symbol.name) for symbol in self.symbols if symbol.parameters]
            introduced = [*functions, *weights, *[x for name in self.constants for x in (f"{name}_", f"H{name}_")]]
        else:
            names = [self.named(symbol.name) for symbol in self.symbols]
            constants = [f"H{self.named(symbol.name)}" for symbol in self.symbols if not symbol.parameters]
            introduced = [*names, *constants, *weights]
        if self.shape == "table":
            vectors = [self.variables([f"v{j}_{i}" for j in range(n)]) for i in "12"]
            one, two = ([f"({self.variable(f'{x}{i}')})" for x in "pw"] for i in "12")
            return self._by_chains(introduced, f"Table {' '.join(one)} {vectors[0]} {' '.join(two)} {vectors[1]}")
        weight = "number 1" if self.polynomial else self.variable("w")
        first = f"homogeneous s {self.variables(COORDINATES[:n])} ({weight})"
        if isinstance(self.kind, PairKind):
            second = f"homogeneous s_bar {self.variables(BARRED[:n])} ({self.variable('W')})"
            return self._by_chains(introduced, f"Pair ({first} []) ({second} [])")
        curve = f"{first} {self.variables(POINT[:n]) if self.has_point else '[]'}"
        accompanied = f"Accompanied ({curve}) {self.variables(self.constants)}"
        return self._by_chains(introduced, accompanied if self.constants else curve)

    def _by_chains(self, introduced: list[str], deep: str, own: Sequence[str] = ()) -> _Spelling:
        """The spelling where functions have jets in one parameter; `own` are the rules that the kind adds to these."""
        free = [symbol for symbol in self.symbols if symbol.parameters and symbol.name not in self.ring.rules]
        constants = [symbol.name for symbol in self.symbols if not symbol.parameters]
        rest = [self.named(name) for name in (*self.ring.rules, *constants)]
        letters = dict(zip(PARAMETERS, ("s", "s_bar"), strict=True))
        jets = [f"jets {letters[symbol.parameters[0]]} {self.order} {self.named(symbol.name)}" for symbol in free]
        chains = {parameter: list[str]() for parameter in PARAMETERS}
        for symbol in free:
            chains[symbol.parameters[0]].append(f"chain {self.position(symbol.name)} {self.order}")
        if constants:
            chains[PARAMETERS[0]].append(f"constants [{'; '.join(str(self.position(c)) for c in constants)}]%positive")
        if own:
            chains[PARAMETERS[0]].append(f"[{'; '.join(own)}]%formula")
        first, second = (" ++ ".join(chains[parameter]) or "[]" for parameter in PARAMETERS)
        listed = [f"[{'; '.join(rest)}]"] if rest else []
        return _Spelling(introduced, " ++ ".join([*jets, *listed]), f"of_parameters ({first}) ({second})", deep)

    def preamble(self, premises: Sequence[tuple[str, str, object]]) -> list[str]:
        """The steps that define the variables of the checker; premises are given by name, term and value."""
        return [
            f"pose (l := {self.spelling.jets}).",
            f"pose (r := {self.spelling.rules}).",
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

    def expression(self, polynomial: fmpq_mpoly) -> str:
        """A polynomial with integer coefficients as an expression."""
        terms = []
        for exponents, coefficient in polynomial.terms():
            c = from_flint(coefficient)
            if c.denominator != 1:
                raise FormulaError(f"the coefficient {c}", remedy="multiply the denominators out")
            terms.append((int(c), [(f"var {self._place(i)}", int(e)) for i, e in enumerate(exponents) if e]))
        return sum_of_products(terms, "num")


class _HodographSetting(Setting):
    """A polynomial plane curve with γ′ = (u² − v², 2uv) h; a polynomial one has h = 1."""

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
        u, v = self.variable("u"), self.variable("v")
        factor = "number 1" if self.polynomial else self.variable("h")
        rules = [
            f"({self.position('x')}%positive, ({u} * {u} - {v} * {v}) * {factor})",
            f"({self.position('y')}%positive, ({u} * {v} + {u} * {v}) * {factor})",
        ]
        deep = f"Accompanied (homogeneous s {self.variables('xy')} (number 1) []) [{u}; {v}; {factor}]"
        return self._by_chains([*[self.named(symbol.name) for symbol in self.symbols], "Hx", "Hy"], deep, rules)


class _ImplicitSetting(Setting):
    """A curve along which a function F of the coordinates is constant, and the partial derivatives of F."""

    @property
    def free(self) -> tuple[str, ...]:
        """The free operands."""
        assert isinstance(self.kind, ImplicitKind)
        return self.kind.free

    @property
    def symbols(self) -> tuple[Symbol, ...]:
        """Coordinates, free operands, and the partial derivatives up to the second order."""
        known = self.kind.symbols(self.dimension)
        return tuple(symbol for symbol in known if len(symbol.name) <= 3 or symbol.name in self.free)

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
        axes = COORDINATES[: self.dimension]
        f, free = ([self.variable(name) for name in names] for names in ([f"f{x}" for x in axes], self.free))
        second = {x: [self.variable("f" + "".join(sorted(x + y))) for y in axes] for x in axes}
        if self.dimension == 2:
            velocity = [f"(- ({f[1]}) * {free[0]})", f"({f[0]} * {free[0]})"]
        else:
            velocity = [f"({f[i]} * {free[j]} - {f[j]} * {free[i]})" for i, j in ((1, 2), (2, 0), (0, 1))]
        rules = [f"({self.position(x)}%positive, {v})" for x, v in zip(axes, velocity, strict=True)]
        for x in axes:  # the chain rule
            terms = [f"{each} * {v}" for each, v in zip(second[x], velocity, strict=True)]
            rules.append(f"({self.position(f'f{x}')}%positive, {' + '.join(terms)})")
        names = [self.named(symbol.name) for symbol in self.symbols]
        hypotheses = [*(f"d{x}_" for x in axes), *(f"H{x}" for x in axes), *(f"Hf{x}" for x in axes)]
        curve = f"homogeneous s {self.variables(axes)} (number 1) []"
        rows = "; ".join(f"[{'; '.join(row)}]" for row in second.values())
        deep = f"Implicit ({curve}) [{'; '.join(free)}] [{'; '.join(f)}] [{rows}]"
        spelled = self._by_chains([*names, *hypotheses], deep, rules)
        others = [self.named(symbol.name) for symbol in self.symbols if symbol.name not in self.free]
        jets = [f"jets s {self.order} {self.named(name)}" for name in self.free]
        return spelled._replace(jets=" ++ ".join([*jets, f"[{'; '.join(others)}]"]))


class _SurfaceSetting(Setting):
    """A rational surface in space, or a rational map of the plane, or two quadratic forms in two parameters, with all
    partial derivatives up to an order.
    """

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
        names = [symbol.name for symbol in self.symbols]
        introduced = [*map(self.named, names), "C", *[f"H{weight}" for weight in self.weights]]
        jets = " ++ ".join(f"partials {self.order} {self.named(name)}" for name in names)
        by_u, by_v = (" ++ ".join(f"grid {self.position(name)} {self.order} {i}" for name in names) for i in (0, 1))
        w, own = self.variable("w"), [name for name in names if name != "w"]
        deep = f"Patch (homogeneous s {self.variables(own)} ({w}) [])"
        if isinstance(self.kind, FormsKind):
            deep = f"Accompanied (rational_curve s [] ({w}) []) {self.variables(own)}"
        return _Spelling(introduced, jets, f"of_parameters ({by_u}) ({by_v})", deep)


class _SurfaceCurveSetting(Setting):
    """A curve on a rational surface: its parameters u and v with their derivatives, and the partial derivatives of the
    surface, which are differentiated along the curve by the chain rule.
    """

    @property
    def route(self) -> tuple[str, ...]:
        """The parameters as functions along the curve."""
        return tuple(self.kind.composed.values())

    def _operand(self, symbol: Symbol) -> JetFraction:
        return self._jet(symbol.name) if symbol.name in self.route else super()._operand(symbol)

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
        coordinates = [symbol.name for symbol in self.symbols if symbol.name not in self.route]
        names = [self.named(name) for name in (*self.route, *coordinates)]
        hypotheses = ["C", *[f"F{name}" for name in coordinates], *[f"H{weight}" for weight in self.weights]]
        jets = [f"jets time {self.order} {self.named(name)}" for name in self.route]
        jets += [f"partials {self.order} {self.named(name)}" for name in coordinates]
        by_u, by_v = ([f"grid {self.position(name)} {self.order} {i}" for name in coordinates] for i in (0, 1))
        along = [f"chain {self.position(name)} {self.order}" for name in self.route]
        paces = " ".join(str(self.position(name, 1)) for name in self.route)
        along += [f"chained {self.position(name)} {self.order} {paces}" for name in coordinates]
        first, second, third = (" ++ ".join(rules) for rules in (by_u, by_v, along))
        rules = f"of_three_parameters ({first}) ({second}) ({third})"
        net = f"homogeneous time {self.variables(COORDINATES[: self.dimension])} ({self.variable('w')}) []"
        deep = f"Path (Patch ({net})) {self.variables(self.route)}"
        return _Spelling([*names, *hypotheses], " ++ ".join(jets), rules, deep)


# ---- curves with the roots of their frames
#
# Each root follows its inverse in the list of variables; its derivative follows from its square by Leibniz' rule.


#: The roots of a frame, the innermost last.
ROOTS = ("sigma", "rho")


def setting_of(kind: Kind, dimension: int, order: int, *, polynomial: bool, trees: Iterable[Node]) -> Setting:
    """The setting of a kind of argument, for formulas with these trees."""
    if isinstance(kind, FramedKind):
        given = list(trees)
        used = tuple(root for root in ROOTS if any(root in leaves(tree) for tree in given))
        return _FramedSetting(kind, dimension, order, roots=used, differentiates_roots=any(map(_differentiates, given)))
    return SETTINGS.get(type(kind), Setting)(kind, dimension, order, polynomial)


#: The settings of kinds other than curves.
SETTINGS: dict[type[Kind], type[Setting]] = {
    HodographKind: _HodographSetting,
    ImplicitKind: _ImplicitSetting,
    SurfaceKind: _SurfaceSetting,
    SurfaceCurveKind: _SurfaceCurveSetting,
    FormsKind: _SurfaceSetting,
}


def _differentiates(tree: Node) -> bool:
    """Whether a derivative of a root occurs."""
    return any(node.op is Operation.DERIVATIVE and set(ROOTS) & leaves(node) for node in nodes(tree))


class _Rooted(CurveKind):
    """A curve with its roots as symbols, so that they are variables of the ring."""

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The symbols of the curve, and the roots."""
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

    @cached_property
    def spelling(self) -> _Spelling:
        """The notation of the argument."""
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
