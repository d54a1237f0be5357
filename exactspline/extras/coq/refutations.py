"""Claims that fail, as theorems: an explicit curve that satisfies the assumptions but not the statement."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from exactspline.errors import ClaimError, VanishingDivisorError
from exactspline.extras.coq.explicit import ExplicitCurve, candidates, coefficients_of, polynomial_term
from exactspline.extras.coq.formulas import Calling, comment, type_of
from exactspline.extras.coq.proofs import Nonzero
from exactspline.extras.coq.terms import Writer, identifier
from exactspline.extras.coq.theorems import Statement, concluded
from exactspline.language.arguments import embedded
from exactspline.language.formula import Formula
from exactspline.language.implicit_kinds import ImplicitKind
from exactspline.language.kinds import POINT_IN_SPACE, FramedKind, Kind, kind_of
from exactspline.language.vector import Vector
from exactspline.readings.expression import Operation
from exactspline.readings.tree import Node
from exactspline.verification.claim import Claim
from exactspline.verification.denominators import Evaluation, factored
from exactspline.verification.vocabulary import Scope

#: A difference that is not zero, the negated statement, and the steps that prove it.
Difference = tuple[Node, str, str]


def refutation(claim: Claim, dimension: int, named: Callable[[Formula], str]) -> str:
    """The theorem that a claim fails.

    Raises `ClaimError` where none of the curves tried is a counterexample.
    """
    for curve in candidates(kind_of(claim.curve), dimension, polynomial=claim.of == Scope.POLYNOMIAL):
        attempt = _Attempt(claim, dimension, named, curve)
        if attempt.succeeds():
            return attempt.text()
    raise ClaimError("no explicit curve refutes it", where=claim.key, remedy="add one")


class _Attempt(Statement[Iterator[Difference]]):
    """A claim on one explicit curve."""

    def __init__(self, claim: Claim, dimension: int, named: Callable[[Formula], str], curve: ExplicitCurve) -> None:
        self.claim, self.curve, self.dimension = claim, curve, dimension
        self.kind = kind_of(claim.curve)
        self.traced = Calling(self.kind, dimension)
        self.writer = Writer(named)
        self.argument = curve.argument(self.kind)
        self.evaluation = Evaluation(self.argument)
        self.units = Nonzero()
        self.premises: list[Node] = []
        self.difference: Difference | None = None

    def succeeds(self) -> bool:
        """Whether the assumptions hold and the statement fails."""
        try:
            self.premises = [self.assumed(a) for a in self.claim.assumes if a.formula]
            if any(self.evaluation(node).is_zero for node in self.premises):
                return False
            differences: Iterator[Difference] = concluded(self.claim, self)
            self.difference = next(differences, None)
        except VanishingDivisorError:
            return False
        if self.difference is None:
            return False
        self._recognize(self.argument.w)
        for node in self.premises:
            self._recognize(self.evaluation(node))
        for _, value in self.evaluation.denominators:
            self._recognize(value)
        return True

    def _recognize(self, value: Any) -> None:
        """Add a function that is not zero."""
        self.units.recognize(factored(value))

    def equal(self, left: Node, right: Node | None) -> Iterator[Difference]:
        """The components in which two trees differ, as differences."""
        a = self.evaluation(left)
        zeros = "[" + "; ".join(["zero K"] * len(a)) + "]" if isinstance(a, Vector) else "zero K"
        said = f"{self.writer(left)} <> {zeros if right is None else self.writer(right)}"
        if not isinstance(a, Vector):
            difference = left if right is None else left - right
            if not self.evaluation(difference).is_zero:
                closing = "exact U." if right is None else "apply different; vm_cast_no_check U."
                yield difference, said, closing
            return
        for i in range(len(a)):
            difference = left[i] if right is None else left[i] - right[i]
            if not self.evaluation(difference).is_zero:
                step = difference if right is not None else left[i] - Node(Operation.NUMBER, value=0)
                self.evaluation(step)
                yield step, said, f"apply (different_vectors K {i}); vm_cast_no_check U."

    def on_surface(self, left: Node, right: Formula) -> Iterator[Difference]:
        """The components in which a plane curve is not the directrix of a surface of the same curve in space."""
        directrix = Calling(POINT_IN_SPACE, 3).calls(right).directrix
        in_space = Evaluation(embedded(self.argument))
        inside = Writer(self.writer.named, "(embedded c)")
        planar, spatial = self.evaluation(left), in_space(directrix)
        assert isinstance(planar, Vector)
        assert isinstance(spatial, Vector)
        for i in range(2):
            difference = planar[i] - spatial[i]
            if not difference.is_zero:
                self.evaluation.denominators += in_space.denominators
                self._recognize(difference)
                said = f"{self.writer(left)} ++ [zero K] <> {inside(directrix)}"
                text = f"component {i} ({self.writer(left)} ++ [number 0]) - component {i} ({inside(directrix)})"
                yield Node(Operation.LEAF, value=text), said, f"apply (different_vectors K {i}); vm_cast_no_check U."

    def one_surface(self, left: Node, right: Node) -> Iterator[Difference]:
        """The products that would vanish if two ruled surfaces were equal."""
        (d, g), (e, h) = ((side.directrix, side.generator) for side in (left, right))
        said = f"~ same_surface ({self.writer(left)}) ({self.writer(right)})"
        values = [f"(map (value K l) ({self.writer(node)}))" for node in (d, g, e, h)]
        for part, other in enumerate((h, e - d)):
            product = Node(Operation.CROSS, (g, other), vector=True)
            for i in range(3):
                if not self.evaluation(product[i]).is_zero:
                    one = f"same_surface ({values[0]}, {values[1]}) ({values[2]}, {values[3]})"
                    closing = (
                        f"intro Z. assert (Y : {one}) by vm_cast_no_check Z.\n  destruct (parallel_of_one_surface "
                        f"K {' '.join(values)} eq_refl eq_refl eq_refl eq_refl Y) as [Y1 Y2].\n  apply U. "
                        f"vm_cast_no_check (f_equal (component {i}) Y{part + 1})."
                    )
                    yield product[i], said, closing

    def text(self) -> str:
        """Statement and proof."""
        assert self.difference is not None
        difference, said, closing = self.difference
        if difference.op is not Operation.LEAF:
            self._recognize(self.evaluation(difference))
        text = difference.value if difference.op is Operation.LEAF else self.writer(difference)
        curve = self.curve.term(self.kind, "t", "number")
        holds = ["w c <> zero K", *[f"{self.writer.at(node, 1)} <> zero K" for node in self.premises]]
        keys = list(map(coefficients_of, self.units.atoms))
        atoms = [polynomial_term(key, "var 1", "num") for key in keys]
        unit = "{ apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }"
        lines = [
            "intros K t Hz Ht.",
            "pose (l := [t]).",
            "assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).",
            f"pose (atoms := [{'; '.join(atoms)}]%formula : list expr).",
            f"pose (known := {self.units.known_list}).",
            f"pose (c := ({self.curve.term(self.kind, '(var 1)', 'number')})%formula : {type_of(self.kind)[:-1]}expr).",
            "assert (N : all_nonzero K l atoms).",
            "{ repeat apply Forall_cons; try apply Forall_nil.",
        ]
        for key in keys:
            lines.append(f"  - apply (explicit_nonzero K t Hz Ht {len(key) - 1}). vm_cast_no_check (eq_refl true).")
        lines[-1] += " }"
        for i, node in enumerate(["w c", *[self.writer(node) for node in self.premises]]):
            lines += [f"assert (H{i} : value K l ({node} : expr)%formula <> zero K).", unit]
        equalities = _equalities(self.kind)
        for i, (kind, left, right, _) in enumerate(equalities):
            name, value = ("one_vector", "map (value K l)") if kind == "list expr" else ("one_value", "value K l")
            lines.append(f"assert (E{i} : {value} ({left} : {kind})%formula = {value} ({right} : {kind})%formula).")
            lines.append(
                f"{{ apply ({name} K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }}"
            )
        lines += [f"assert (U : value K l ({text} : expr)%formula <> zero K).", unit]
        lines += [f"split; [vm_cast_no_check H{i}|]." for i in range(len(holds))]
        lines += [f"split; [vm_cast_no_check E{i}|]." for i in range(len(equalities))]
        holds += [said for *_, said in equalities]
        lines.append(closing)
        conclusion = " /\\\n  ".join([*holds, said])
        several = len(self.kind.dimensions) > 1
        name = identifier(self.claim.key) + (f"_in_dimension_{self.dimension}" if several else "") + "_fails"
        return (
            f"(** {comment(self.claim.id)}, {comment(self.claim.source)}, fails. *)\n"
            f"Theorem {name} : forall (K : differential_field) (t : K),\n"
            "  characteristic_zero K -> derivative K s t = one K ->\n"
            f"  let c := {curve} in\n  {conclusion}.\n"
            "Proof.\n  " + "\n  ".join(lines) + "\nQed.\n"
        )


def _equalities(kind: Kind) -> list[tuple[str, str, str, str]]:
    """The equalities that hold for every argument of a kind and must be proved for an explicit one: a type, two terms,
    and the statement.
    """
    if isinstance(kind, FramedKind):
        velocity = "(vder s (gamma c))"
        binormal = f"(cross {velocity} (vders s 2 (gamma c)))"
        vectors = {"sigma": velocity} | ({"rho": binormal} if 3 in kind.dimensions else {})
        pairs = [(f"{root} c * {root} c", f"dot {vector} {vector}") for root, vector in vectors.items()]
        return [("expr", left, right, f"{left} = {right}") for left, right in pairs]
    if isinstance(kind, ImplicitKind):
        left, right = "vder s (gamma c)", "vmul (pace_of c) (perp (gradient_f c))"
        chained = "map (fun row => dot row (vder s (gamma c))) (hessian_f c)"
        return [
            ("list expr", left, right, f"{left} = {right}"),
            ("list expr", "vder s (gradient_f c)", chained, "chain_rule c"),
        ]
    return []
