"""Claims as theorems: the statement, and the script that proves it."""

from __future__ import annotations

import tomllib
from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import cache, singledispatch
from importlib import resources
from typing import Any, Generic, TypeVar

from exactspline.errors import FormulaError
from exactspline.extras.coq.formulas import Calling, Writer, comment, identifier, surface
from exactspline.extras.coq.proofs import Premise, Proof
from exactspline.extras.coq.settings import setting_of
from exactspline.language.arguments import Curve, embedded
from exactspline.language.formula import Formula
from exactspline.language.kinds import POINT_IN_SPACE, Kind, PairKind, kind_of
from exactspline.language.operand import FieldOperand
from exactspline.language.vector import Vector
from exactspline.numbers.exact import rational
from exactspline.papers import find
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import JetFraction
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Derivation, Node
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claim import Claim
from exactspline.verification.divisors import Evaluation, factored
from exactspline.verification.kinds.equality import Identity, IsoCurve, SameSurface, Vanishing
from exactspline.verification.notation import WEIGHTS, factor_parts
from exactspline.verification.vocabulary import Scope

Conclusion = TypeVar("Conclusion")
#: The kinds of claims that become theorems.
STATED = (Identity, Vanishing, SameSurface, IsoCurve)


def theorem(claim: Claim, dimension: int, named: Callable[[Formula], str]) -> str:
    """A claim as a theorem with its proof: about rational curves or, where it fails for these, about
    polynomial ones.
    """
    try:
        return _Theorem(claim, dimension, named).text()
    except _RationalError:
        if claim.of != Scope.POLYNOMIAL:
            raise
        return _Theorem(claim, dimension, named, polynomial=True).text()


class _RationalError(FormulaError):
    """A statement that fails on rational curves."""


def by_hand(key: str) -> list[str]:
    """The steps written by hand that finish the proof of a claim where the computation would be too large; empty for
    most.
    """
    steps = _by_hand().get(key)
    return steps["steps"].strip().splitlines() if steps else []


@cache
def _by_hand() -> dict[str, dict[str, str]]:
    return tomllib.loads(resources.files(__package__).joinpath("by_hand.toml").read_text(encoding="utf-8"))


class Statement(ABC, Generic[Conclusion]):
    """Shared by statements that hold and statements that fail: formulas as trees over the argument."""

    kind: Kind
    traced: Calling
    evaluation: Evaluation

    def called(self, formula: Formula, part: str = "first") -> Node:
        """A formula called on the argument, or on a part of it."""
        target: Any = self.traced
        if isinstance(self.kind, PairKind) and not isinstance(formula.kind, PairKind):
            target = getattr(target, part)
        node: Node = target.calls(formula)
        return node

    def assumed(self, assumption: Assumption) -> Node:
        """The expression that is assumed not to vanish; for a vector its squared length."""
        tree = self.called(find(assumption.formula), "second" if assumption.second else "first")
        return Node(Operation.DOT, (tree, tree)) if tree.is_vector else tree

    @abstractmethod
    def equal(self, left: Node, right: Node | None) -> Conclusion:
        """That two trees are equal (without a second: that the first is 0)."""

    @abstractmethod
    def one_surface(self, left: Node, right: Node) -> Conclusion:
        """That two ruled surfaces are equal."""

    @abstractmethod
    def on_surface(self, left: Node, right: Formula) -> Conclusion:
        """That a plane curve is the directrix of a ruled surface of the same curve in space."""


@singledispatch
def concluded(claim: Claim, statement: Statement[Conclusion]) -> Conclusion:
    """The conclusion of the theorem of a claim, made from its traced formulas."""
    raise FormulaError(f"claims of the kind {claim.kind!r} are not equalities", remedy="state identities")


@concluded.register
def _(claim: Identity, statement: Statement[Conclusion]) -> Conclusion:
    left, right = statement.called(claim.find(claim.left)), statement.called(claim.find(claim.right))
    return statement.equal(left, _times_factor(claim, statement, right))


@concluded.register
def _(claim: Vanishing, statement: Statement[Conclusion]) -> Conclusion:
    return statement.equal(statement.called(claim.find(claim.left)), None)


@concluded.register
def _(claim: SameSurface, statement: Statement[Conclusion]) -> Conclusion:
    return statement.one_surface(*(statement.called(claim.find(name)) for name in (claim.left, claim.right)))


@concluded.register
def _(claim: IsoCurve, statement: Statement[Conclusion]) -> Conclusion:
    return statement.on_surface(statement.called(claim.find(claim.left)), claim.find(claim.right))


class _Theorem(Statement[tuple[str, list[str]]]):
    def __init__(
        self, claim: Claim, dimension: int, named: Callable[[Formula], str], *, polynomial: bool = False
    ) -> None:
        self.claim, self.dimension = claim, dimension
        self.kind = kind = kind_of(claim.curve)
        formulas = [claim.find(name) for name in claim.named]
        if isinstance(claim, Identity):
            names = [name for name, _ in factor_parts(claim.factor) if name[0].isalpha() and name not in WEIGHTS]
            formulas += [claim.find(name) for name in names]
        formulas += [find(a.formula) for a in claim.assumes if a.formula]
        order = max(order_of(formula, dimension if dimension in formula.kind.dimensions else 3) for formula in formulas)
        self.traced = Calling(kind, dimension)
        trees = (self.called(formula) for formula in formulas)
        self.setting = setting_of(kind, dimension, order, polynomial=polynomial, trees=trees)
        self.writer = Writer(named)
        self.evaluation = Evaluation(self.setting.argument, self.setting.flat)
        self.name = identifier(claim.key) + (f"_in_dimension_{dimension}" if len(kind.dimensions) > 1 else "")
        premises = [self._premise(i, a) for i, a in enumerate(a for a in claim.assumes if a.formula)]
        self.proof = Proof(self.setting, self.name, premises, self.evaluation, self.writer)
        if self.setting.differentiates_roots:
            self.proof.prime(2)

    def _premise(self, i: int, assumption: Assumption) -> Premise:
        node = self.assumed(assumption)
        return Premise(f"H{i + 1}", node, self.setting.flat(self.evaluation(node)))

    def text(self) -> str:
        """Statement and proof."""
        conclusion, closing = concluded(self.claim, self)
        proof = self.proof
        if any(h.value.is_zero for h in (*proof.premises, *proof.existing)):
            raise FormulaError("it assumes that 0 is not 0", remedy="drop that assumption")
        premises = [f"{self.writer.at(h.node, 1)} <> zero K" for h in proof.premises]
        premises += [f"number {p} <> zero K" for p in proof.primes]
        premises += [f"{self.writer.at(h.node, 1)} <> zero K" for h in proof.existing]
        hypotheses = [
            *[h.name for h in proof.premises],
            *[f"P{p}" for p in proof.primes],
            *[h.name for h in proof.existing],
        ]
        introduced = " ".join(["K", *self.setting.spelling.introduced, *hypotheses])
        lines = [*proof.script(), *closing]
        first = f"{self.setting.opening}; intros {introduced}."
        said = " ->\n  ".join([*premises, conclusion])
        return (
            f"(** {comment(self.claim.id)}, {comment(self.claim.source)}. *)\n"
            f"Theorem {self.name} : {self.setting.quantifier} (fun K c =>\n  {said}).\n"
            f"Proof.\n  {first}\n  " + "\n  ".join(lines) + "\nQed.\n"
        )

    def equal(self, left: Node, right: Node | None) -> tuple[str, list[str]]:
        """The statement that two trees are equal, and the steps that finish its proof once the atoms are known."""
        if surface(left) and right is not None:
            return self._same_parts(left, right)
        value = self.evaluation(left)
        components = len(value) if isinstance(value, Vector) else 0
        if not self._holds(value, right):
            raise _RationalError("it fails on rational curves", remedy="theorems are about these")
        self.proof.met()
        if components:
            zero, deep_zero = ("[" + "; ".join([word] * components) + "]" for word in ("zero K", "num 0"))
        else:
            zero, deep_zero = "zero K", "num 0"
        stated_right = zero if right is None else self.writer(right)
        deep_right = deep_zero if right is None else self.writer(right)
        statement = f"{self.writer(left)} = {stated_right}"
        if steps := by_hand(self.claim.key):
            return statement, steps
        return statement, [*self.checked("E", left, deep_right, bool(components)), "vm_cast_no_check E."]

    def _holds(self, value: Any, right: Node | None) -> bool:
        """Whether a value equals that of another tree (without one: zero), on rational curves."""
        if right is None:
            return bool(value.is_zero)
        other = self.evaluation(right)
        pairs = [(value, other)] if not isinstance(other, Vector) else zip(value, other, strict=True)
        return all(bool((a - b).is_zero) if isinstance(a, FieldOperand) else bool(a == b) for a, b in pairs)

    def _same_parts(self, left: Node, right: Node) -> tuple[str, list[str]]:
        """The statement that two ruled surfaces have the same directrix and the same generator."""
        pairs = [(left.directrix, right.directrix), (left.generator, right.generator)]
        for pair in pairs:
            for node in pair:
                self.evaluation(node)
        self.proof.met()
        steps = [
            step
            for name, (a, b) in zip(("E1", "E2"), pairs, strict=True)
            for step in self.checked(name, a, self.writer(b), True)
        ]
        statement = " /\\ ".join(f"{self.writer(a)} = {self.writer(b)}" for a, b in pairs)
        return statement, [*steps, "vm_cast_no_check (conj E1 E2)."]

    def one_surface(self, left: Node, right: Node) -> tuple[str, list[str]]:
        """The statement that two ruled surfaces are equal, and the steps that finish its proof."""
        (d, g), (e, h) = ((side.directrix, side.generator) for side in (left, right))
        for node in (d, g, e, h):
            self.evaluation(node)
        self.proof.met()
        zeros = "[num 0; num 0; num 0]"
        witnesses = [self._witness(own, other) for own, other in ((g, h), (h, g))]
        steps = [
            *self.checked("E1", Node(Operation.CROSS, (g, h), vector=True), zeros, True),
            *self.checked("E2", Node(Operation.CROSS, (g, e - d), vector=True), zeros, True),
        ]
        for i, (own, other) in enumerate(witnesses):
            product = Node(Operation.DOT, (own, other))
            steps.append(f"assert (U{i + 1} : value K l ({self.writer(product)} : expr) <> zero K).")
            steps.append("{ apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }")
        exists = [
            f"(ex_intro _ (map (value K l) {self.writer.at(other, 5)}) (conj eq_refl U{i + 1}))"
            for i, (_, other) in enumerate(witnesses)
        ]
        values = " ".join(f"(map (value K l) {self.writer.at(node, 5)})" for node in (d, g, e, h))
        lengths = " ".join(["eq_refl"] * 4)
        steps.append(f"vm_cast_no_check (one_surface K {values} {lengths}\n    {exists[0]}\n    {exists[1]} E1 E2).")
        return f"same_surface ({self.writer(left)}) ({self.writer(right)})", steps

    def _witness(self, generator: Node, other: Node) -> tuple[Node, Node]:
        """A vector whose scalar product with a generator is a product of nonvanishing factors."""
        gamma = Node(Operation.LEAF, value="gamma", vector=True)
        first, second = (Node(Operation.DERIVATIVE, (gamma,), Derivation(k), vector=True) for k in (1, 2))
        binormal = Node(Operation.CROSS, (first, second), vector=True)
        candidates = [Node(Operation.LEAF, value=f"axis_{x}", vector=True) for x in "zxy"] + [generator, other, first]
        if self.setting.order > 1:
            candidates.append(binormal)
        for candidate in candidates:
            value = self.evaluation(Node(Operation.DOT, (generator, candidate)))
            if not isinstance(value, JetFraction) or value.is_zero:
                continue
            parts = factored(value)
            if all(self.proof.follows(p) for p, _ in parts.powers):
                self.proof.recognize(parts)
                return generator, candidate
        raise FormulaError("nothing shows that a generator does not vanish", remedy="assume that it does not")

    def on_surface(self, left: Node, right: Formula) -> tuple[str, list[str]]:
        """The statement that a plane curve is the directrix of a ruled surface of the same curve in space."""
        directrix = Calling(POINT_IN_SPACE, 3).calls(right).directrix
        argument = self.setting.argument
        assert isinstance(argument, Curve)  # such a claim is about a plane curve
        in_space = Evaluation(embedded(argument))
        in_space(directrix)
        self.evaluation(left)
        self.evaluation.denominators += in_space.denominators
        self.proof.met()
        writer = Writer(self.writer.named, "(embedded c)")
        steps = [
            f"assert (E : map (value K l) ({self.writer(left)} ++ [number 0] : list expr)%formula\n"
            f"    = map (value K l) ({writer(directrix)} : list expr)%formula).",
            "{ apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }",
            "vm_cast_no_check E.",
        ]
        return f"{self.writer(left)} ++ [zero K] = {writer(directrix)}", steps

    def checked(self, name: str, left: Node, deep_right: str, vector: bool) -> list[str]:
        """The steps that prove that two expressions have the same value."""
        lemma = "one_vector" if vector else "one_value"
        kind = "list expr" if vector else "expr"
        a, b = f"({self.writer(left)} : {kind})%formula", f"({deep_right} : {kind})%formula"
        value = "map (value K l)" if vector else "value K l"
        return [
            f"assert ({name} : {value} {a} = {value} {b}).",
            f"{{ apply ({lemma} K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }}",
        ]


def _times_factor(claim: Identity, theorem: Statement[Conclusion], right: Node) -> Node:
    """The right side with its factor."""
    above: Node | None = None
    below: Node | None = None
    for name, exponent in factor_parts(claim.factor):
        if name == "1":
            continue
        base = _part(claim, theorem, name)
        power = base ** abs(exponent) if abs(exponent) > 1 else base
        if exponent > 0:
            above = power if above is None else above * power
        else:
            below = power if below is None else below * power
    if above is None and below is None:
        return right
    if below is not None:
        above = (above if above is not None else Node(Operation.NUMBER, value=1)) / below
    product: Node = above * right
    return product


def _part(claim: Identity, theorem: Statement[Conclusion], name: str) -> Node:
    pair = isinstance(theorem.kind, PairKind)
    if name in WEIGHTS:
        return Node(Operation.LEAF, value={"w": "first.w", "W": "second.w"}[name] if pair else "w")
    return theorem.called(claim.find(name)) if name[0].isalpha() else Node(Operation.NUMBER, value=rational(name))
