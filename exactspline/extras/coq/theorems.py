"""Claims as theorems: the statement, and the script that proves it, with the polynomials that do not vanish, the
reasons why, and the checks that imply an equality.
"""

from __future__ import annotations

import tomllib
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, singledispatch
from importlib import resources
from typing import Any, Generic, TypeVar, cast

from flint import fmpq_mpoly

from exactspline.errors import FormulaError
from exactspline.extras.coq.formulas import Calling, Writer, comment, identifier, surface
from exactspline.extras.coq.settings import Setting, setting_of
from exactspline.language.arguments import Curve, embedded
from exactspline.language.formula import Formula
from exactspline.language.kinds import POINT_IN_SPACE, Kind, PairKind, kind_of
from exactspline.language.operand import FieldOperand
from exactspline.language.vector import Vector
from exactspline.numbers.exact import from_flint, mpq, over_one_denominator, rational
from exactspline.papers import find
from exactspline.polynomials.factors import Factored, Factorization, prime_factors
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet, JetFraction
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Derivation, Node
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.claim import Claim
from exactspline.verification.divisors import Evaluation, factored
from exactspline.verification.kinds.equality import Identity, IsoCurve, SameSurface, Vanishing
from exactspline.verification.notation import WEIGHTS, factor_parts
from exactspline.verification.vocabulary import Scope

#: A denominator with more terms is not factored.
LARGE = 100
#: A polynomial that does not vanish, or a prime number.
Atom = fmpq_mpoly | int


@dataclass(frozen=True)
class _Premise:
    """An assumption of a theorem: a tree that is not zero, and its value."""

    name: str
    node: Node
    value: Any


def _base(node: Node) -> tuple[Node, int]:
    """The base and the exponent of a tree that is a power; the base vanishes where the tree does."""
    power = 1
    while node.op is Operation.POWER and node.value > 0:
        node, power = node.args[0], power * node.value
    return node, power


@dataclass(kw_only=True)
class Nonzero:
    """Polynomials and prime numbers that do not vanish, and the products of them that occur, by their exponents in
    numerator and denominator.
    """

    atoms: list[Atom] = field(default_factory=list)
    known: list[tuple[tuple[int, ...], tuple[int, ...]]] = field(default_factory=list)

    def recognize(self, value: Factored[fmpq_mpoly]) -> None:
        """Register a product, and its factors, for the checker."""
        constant = ((value.constant.numerator, 1), (value.constant.denominator, -1))
        primes = [(p, sign * e) for number, sign in constant for p, e in prime_factors(int(number)).items()]
        for atom, _ in (*primes, *value.powers):
            if self.place(atom) is None:
                self.meet(atom)
        above, below = [0] * len(self.atoms), [0] * len(self.atoms)
        for atom, e in (*primes, *value.powers):
            if (place := self.place(atom)) is None:
                raise FormulaError("it divides by something that may vanish", remedy="assume that it does not")
            above[place] += max(e, 0)
            below[place] += max(-e, 0)
        entry = tuple(above), tuple(below)
        if entry not in self.known:
            self.known.append(entry)

    def place(self, atom: Atom) -> int | None:
        """The position of an atom; None for an unknown atom."""
        same = (i for i, each in enumerate(self.atoms) if isinstance(each, int) is isinstance(atom, int))
        return next((i for i in same if self.atoms[i] == atom), None)

    def meet(self, atom: Atom) -> None:
        """Add an atom."""
        self.atoms.append(atom)

    @property
    def known_list(self) -> str:
        """The products known to the checker."""
        pairs = [f"([{'; '.join(map(str, a))}], [{'; '.join(map(str, b))}])" for a, b in self.known]
        return f"[{'; '.join(pairs)}] : list (list nat * list nat)"


@dataclass
class _Proof(Nonzero):
    """The atoms of one theorem, the reasons why they do not vanish, and the assumptions beyond those of the claim."""

    setting: Setting
    name: str
    premises: list[_Premise]
    evaluation: Evaluation
    writer: Writer
    reasons: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    primes: list[int] = field(default_factory=list)
    existing: list[_Premise] = field(default_factory=list)

    def met(self) -> None:
        """Add all denominators that occur; one about which nothing is known is assumed not to vanish, since the claim
        divides by it.
        """
        for node, value in self.evaluation.denominators:
            parts = factored(value)
            if not isinstance(value, JetFraction) or all(self.follows(each) for each, _ in parts.powers):
                self.recognize(parts)
                continue
            base, power = _base(node)
            assumed = _Premise(f"D{len(self.existing) + 1}", base, self.setting.flat(self.evaluation(base)))
            self.existing.append(assumed)
            if assumed.value.bottom.is_one() and len(assumed.value.top) > LARGE:
                self.known.append(((*[0] * len(self.atoms), power), ()))
                self._add(assumed.value.top, f"vm_cast_no_check {assumed.name}", self.writer(base))
            else:
                for polynomial, _ in parts.powers:
                    if not self.follows(polynomial):
                        self._divides(polynomial, assumed)
                self.recognize(parts)

    def meet(self, atom: Atom) -> None:
        """Prove that a polynomial does not vanish; for a prime number, assume that it does not vanish."""
        if isinstance(atom, int):
            self.prime(atom)
        else:
            self._prove(atom)

    def prime(self, p: int) -> None:
        """Assume that a prime number does not vanish."""
        if self.place(p) is None:
            self.primes.append(p)
            self._add(p, f"exact P{p}")

    def _add(self, atom: Atom, reason: str, text: str = "") -> None:
        self.atoms.append(atom)
        self.reasons.append(reason)
        self.texts.append(text or (f"num {atom}" if isinstance(atom, int) else self.setting.expression(atom)))

    def _prove(self, polynomial: fmpq_mpoly) -> None:
        """Prove that a polynomial does not vanish: the polynomial is a denominator of a curve, or it divides a
        polynomial that is assumed not to vanish, or its zeros would be common zeros of such a polynomial and its
        derivative.
        """
        if hypothesis := self._given(polynomial):
            self._add(polynomial, f"exact {hypothesis}")
        elif not any(self._divides(polynomial, premise) for premise in self.premises):
            for premise in self.premises:
                if self._divides_with_derivative(polynomial, premise):
                    break

    def _given(self, polynomial: fmpq_mpoly) -> str | None:
        """The hypothesis that it does not vanish, if it is the denominator of a curve or a root."""
        setting = self.setting
        names = {f"H{name}": name for name in setting.weights} | {f"N{name}": name for name in setting.roots}
        return next((h for h, name in names.items() if polynomial == setting.ring[name].polynomial), None)

    def _divides(self, polynomial: fmpq_mpoly, premise: _Premise) -> bool:
        value = premise.value
        rest, remainder = divmod(value.top, polynomial)
        if remainder:
            return False
        below = factored(JetFraction(value.ring, value.ring.context.constant(1), value.bottom))
        _, scale = over_one_denominator(map(from_flint, rest.coeffs()))
        if below.powers or scale != 1:
            self.recognize(factored(JetFraction(value.ring, value.bottom * scale, value.ring.context.constant(1))))
        cofactor = self._fraction(rest * scale, value.bottom * scale)
        given = f"({self.writer(premise.node)} : expr)%formula"
        self._add(
            polynomial,
            f"apply (factor_nonzero K l r R roots Q {self._list()} known N {given} {cofactor} "
            f"{self._expression(polynomial)}); [vm_cast_no_check (eq_refl true) | vm_cast_no_check {premise.name}]",
        )
        return True

    def _divides_with_derivative(self, polynomial: fmpq_mpoly, premise: _Premise) -> bool:
        """``4 B = b S − S′ S′`` implies that S does not vanish where B does not; this applies to ‖γ′‖² and ‖γ′ × γ″‖²
        (in the plane ``[γ′ γ″]²``).
        """
        whole_factor = self._whole(polynomial, premise)
        if whole_factor is None:
            return False
        whole, power, rest, derivative = whole_factor
        self.recognize(factored(mpq(2)))
        if self.place(whole) is None:
            self._prove(whole)
        self.recognize(Factored(mpq(4), Factorization([(whole, power)])))
        left = f"(num 4 * ({self.setting.expression(whole)}) ^ {power})%formula"
        self._add(
            polynomial,
            f"apply (differential_factor_nonzero K l r R roots Q {self._list()} known N {left} "
            f"{self._expression(rest)} {self._expression(-derivative)} {self._expression(polynomial)}); "
            f"[vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q {self._list()} known N); "
            "vm_cast_no_check (eq_refl true)]",
        )
        return True

    def _whole(
        self, polynomial: fmpq_mpoly, premise: _Premise
    ) -> tuple[fmpq_mpoly, int, fmpq_mpoly, fmpq_mpoly] | None:
        """A factor B of something nonvanishing, whether B or its square is meant, and b and S′ as above."""
        derivative = self._derivative(polynomial)
        if derivative is None or not isinstance(premise.value, JetFraction):
            return None
        for whole, _ in factored(premise.value).powers:
            for power in (1, 2):
                rest, remainder = divmod(whole**power * 4 + derivative**2, polynomial)
                if not remainder and whole != polynomial:
                    return whole, power, rest, derivative
        return None

    def follows(self, polynomial: fmpq_mpoly) -> bool:
        """Whether the assumptions imply that a polynomial does not vanish."""
        if self.place(polynomial) is not None or self._given(polynomial):
            return True
        return any(
            isinstance(h.value, JetFraction)
            and (not divmod(h.value.top, polynomial)[1] or self._whole(polynomial, h) is not None)
            for h in self.premises
        )

    def _derivative(self, polynomial: fmpq_mpoly) -> fmpq_mpoly | None:
        try:
            return Jet(self.setting.ring, polynomial).d(by="s").polynomial
        except FormulaError:
            return None

    def _expression(self, polynomial: fmpq_mpoly) -> str:
        return f"({self.setting.expression(polynomial)})%formula"

    def _fraction(self, top: fmpq_mpoly, bottom: fmpq_mpoly) -> str:
        above = self.setting.expression(top)
        return f"({above})%formula" if bottom.is_one() else f"(({above}) / ({self.setting.expression(bottom)}))%formula"

    def _list(self) -> str:
        return f"(firstn {len(self.atoms)} atoms)"

    def script(self) -> list[str]:
        """The lines of the proof that the atoms do not vanish."""
        lines = [
            *self.setting.preamble([(h.name, self.writer(h.node), h.value) for h in self.premises]),
            f"pose (c := {self.setting.spelling.deep}).",
            f"pose (atoms := [{'; '.join(self.texts)}]%formula : list expr).",
            f"pose (known := {self.known_list}).",
            "assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.",
        ]
        for i, reason in enumerate(self.reasons):
            lines.append(f"assert (N{i + 1} : all_nonzero K l (firstn {i + 1} atoms)).")
            lines.append(f"{{ apply (and_nonzero K l (firstn {i} atoms) (nth {i} atoms (num 0)) N). {reason}. }}")
            lines.append(f"clear N. rename N{i + 1} into N.")
        return lines


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


def _steps_by_hand(key: str) -> list[str]:
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
        return cast(Node, target.calls(formula))

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
        self.proof = _Proof(self.setting, self.name, premises, self.evaluation, self.writer)
        if self.setting.differentiates_roots:
            self.proof.prime(2)

    def _premise(self, i: int, assumption: Assumption) -> _Premise:
        node = self.assumed(assumption)
        return _Premise(f"H{i + 1}", node, self.setting.flat(self.evaluation(node)))

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
        if steps := _steps_by_hand(self.claim.key):
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
    return above * right


def _part(claim: Identity, theorem: Statement[Conclusion], name: str) -> Node:
    pair = isinstance(theorem.kind, PairKind)
    if name in WEIGHTS:
        return Node(Operation.LEAF, value={"w": "first.w", "W": "second.w"}[name] if pair else "w")
    return theorem.called(claim.find(name)) if name[0].isalpha() else Node(Operation.NUMBER, value=rational(name))
