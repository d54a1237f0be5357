"""Mutants of formulas, judged by Coq: each formula that occurs in a theorem is changed once in its definition (a sign,
an index, a factor), and the theorem must be rejected.

``python -m workshop.mutation.kernel`` judges all formulas that are not in the record,
``workshop/mutation/kernel.json``, and adds them; without that file it starts from the beginning. With names of formulas
as arguments, it judges these without recording. It needs Coq's ``coqc``.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import Any, NamedTuple

from exactspline.errors import FormulaError
from exactspline.extras.coq.emission import ROOT, Stated, claims_header, library
from exactspline.extras.coq.formulas import Formulas, body, calls, surface
from exactspline.language.formula import Formula
from exactspline.papers import Paper, find, papers
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Derivation, Node
from exactspline.verification.claim import Claim
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.notation import factor_parts
from exactspline.verification.vocabulary import Verdict

RECORD = Path(__file__).parent / "kernel.json"
#: How many theorems may accept a change before it counts as undetected; how many changes are tried (a doubled factor
#: that vanishes still vanishes); and the time limit for each in seconds.
THEOREMS, CHANGES, SECONDS = 4, 6, 120
#: The factor of a doubled term.
SCALED = (
    *(Operation.TIMES, Operation.DOT, Operation.NUMBER, Operation.OVER, Operation.LEAF, Operation.NAMED),
    *(Operation.GENERATOR, Operation.DIRECTRIX),
)


class Change(NamedTuple):
    """A change: its kind, and the tree of the formula with it."""

    kind: str
    tree: Node


def changes(tree: Node) -> Iterator[Change]:
    """The trees that differ from this one in one place; formulas that are called are not entered."""
    for node in _own(tree):
        for kind, other in _changed(node):
            yield Change(kind, _with(tree, node, other))


def _own(tree: Node) -> Iterator[Node]:
    yield tree
    if tree.op is not Operation.NAMED:
        for each in tree.args:
            yield from _own(each)


def _changed(node: Node) -> Iterator[tuple[str, Node]]:
    if node.op in (Operation.PLUS, Operation.MINUS):
        other = Operation.MINUS if node.op is Operation.PLUS else Operation.PLUS
        yield "sign", Node(other, node.args, vector=node.is_vector)
    elif node.op is Operation.NEGATIVE:
        yield "sign", node.args[0]
    elif node.op is Operation.CROSS:
        yield "sign", Node(node.op, node.args[::-1], vector=True)
    elif node.op is Operation.COMPONENT and not node.is_vector:
        yield "index", node.args[0][1 - node.value if node.value < 2 else 0]
    elif node.op is Operation.DERIVATIVE:
        order, by = node.value
        yield "index", Node(node.op, node.args, Derivation(order + 1, by), vector=node.is_vector)
    elif surface(node):
        yield "index", Node(Operation.RULED, (node.generator, node.directrix))
    elif node.op in SCALED:
        yield "factor", node * 2
    if node.op in (Operation.LEAF, Operation.NAMED) and not surface(node):
        yield "index", node.d(1)


def _with(tree: Node, place: Node, other: Node) -> Node:
    if tree is place:
        return other
    if tree.op is Operation.NAMED or not tree.args:
        return tree
    return Node(tree.op, tuple(_with(each, place, other) for each in tree.args), tree.value, vector=tree.is_vector)


@cache
def reached(formula: Formula) -> frozenset[Formula]:
    """A formula and all that it calls, directly or not."""
    formulas = {formula}
    for dimension in formula.kind.dimensions:
        for called in calls(body(formula, dimension)):
            formulas |= reached(called)
    return frozenset(formulas)


def named_in(claim: Claim) -> list[Formula]:
    """The formulas that a theorem of a claim names."""
    names = list(claim.named)
    if isinstance(claim, Identity):
        names += [name for name, _ in factor_parts(claim.factor) if name[0].isalpha() and name not in ("w", "W")]
    return [claim.find(name) for name in names] + [find(a.formula) for a in claim.assumes if a.formula]


class Bench:
    """The compiled library, and the theorems by the formulas that they reach."""

    def __init__(self, room: Path) -> None:
        self.room = room
        made = library()
        made.write(room)
        for name in made.files:
            if not name.startswith("claims/") and name != "Answers":
                assert self.accepts(f"{name}.v"), name
        self.formulas = Formulas(papers())
        self.controlled: set[tuple[str, str]] = set()
        self.theorems = [each for own in made.theorems.values() for each in own if not each.reason]
        stated = ((each.name, named_in(each.claim)) for each in self.theorems)
        self.extent = {name: frozenset[Formula]().union(*map(reached, named)) for name, named in stated}

    def accepts(self, file: str) -> bool:
        """Whether Coq accepts a file."""
        command = ["coqc", "-q", "-w", "none", "-R", ".", ROOT, file]
        return subprocess.run(command, cwd=self.room, capture_output=True, timeout=SECONDS, check=False).returncode == 0

    def speaking(self, formula: Formula) -> list[Stated]:
        """The theorems that reach a formula: first those that name it, and among these the short ones."""
        theorems = [each for each in self.theorems if formula in self.extent[each.name]]

        def rank(each: Stated) -> tuple[bool, bool, bool, int]:
            refuted = each.claim.expected == Verdict.REFUTED
            far = each.claim.paper != self.formulas.owner[formula].name
            return refuted, formula not in named_in(each.claim), far, len(each.text)

        return sorted(theorems, key=rank)

    def still_accepted(self, theorem: Stated, formula: Formula, instead: Node | None) -> bool:
        """Whether a theorem is accepted with another tree in place of that of a formula."""
        (self.room / "Tried.v").write_text(self._text(theorem, formula, instead), encoding="utf-8")
        return self.accepts("Tried.v")

    def control(self, theorem: Stated, formula: Formula) -> None:
        """Check, once per paper, that a theorem is accepted when the formulas are in modules and nothing is changed."""
        controlled = theorem.claim.paper, self.formulas.owner[formula].name
        if controlled not in self.controlled:
            assert self.still_accepted(theorem, formula, None), theorem.name
            self.controlled.add(controlled)

    def _text(self, theorem: Stated, formula: Formula, instead: Node | None) -> str:
        """The theorem, preceded by the formulas of all papers from the formula's to the theorem's, as modules."""
        changed = self.formulas.owner[formula]
        paper_of_theorem = next(paper for paper in papers() if paper.name == theorem.claim.paper)
        modules = []
        for paper in self.formulas.papers:
            if changed in _needs(paper) and paper in _needs(paper_of_theorem):
                text = self.formulas.definitions(paper)
                if paper is changed and instead is not None:
                    before = self.formulas.definition(formula, paper)
                    assert text.count(before) == 1, formula.name
                    text = text.replace(before, self.formulas.definition(formula, paper, instead))
                definitions = text[text.index("Section Formulas.") :]
                modules.append(f"Module {paper.name}.\n{definitions}End {paper.name}.\n")
        header = claims_header(paper_of_theorem.name, theorem.text)
        required = "".join(f"From {ROOT}.formulas Require {paper.name}.\n" for paper in _needs(paper_of_theorem))
        return "\n".join([header, required, *modules, f"Import {paper_of_theorem.name}.", theorem.text])


def _needs(paper: Paper) -> list[Paper]:
    papers_needed = [paper]
    for used in paper.uses:
        papers_needed += [each for each in _needs(used) if each not in papers_needed]
    return papers_needed


def judged(bench: Bench, formula: Formula) -> dict[str, Any]:
    """The first change of a formula after which a theorem is rejected, with that theorem, and the changes tried before,
    which theorems accept.
    """
    theorems = bench.speaking(formula)[:THEOREMS]
    bench.control(theorems[0], formula)
    all_changes = list(changes(body(formula, formula.kind.dimensions[0])))
    accepted: list[str] = []
    for change in Random(formula.name).sample(all_changes, min(CHANGES, len(all_changes))):
        try:
            refused = next((each for each in theorems if not bench.still_accepted(each, formula, change.tree)), None)
        except (FormulaError, subprocess.TimeoutExpired):
            # a derivative of something that depends on two parameters is meaningless before one of them is named; a
            # theorem that takes too long does not count as rejected
            continue
        if refused is not None:
            return {"change": change.kind, "refused": refused.name} | ({"accepted": accepted} if accepted else {})
        accepted.append(change.kind)
    return {"accepted": accepted}


def recorded() -> dict[str, Any]:
    """The record, by the names of formulas."""
    record: dict[str, Any] = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.is_file() else {}
    return record


def spoken_of(bench_formulas: Formulas, theorems: Iterable[Stated]) -> dict[str, Formula]:
    """The formulas that theorems reach, by their names in Coq."""
    reached_formulas = frozenset[Formula]().union(*[reached(f) for each in theorems for f in named_in(each.claim)])
    return {bench_formulas.named(f): f for f in bench_formulas.owner if f in reached_formulas}


def main(names: list[str]) -> int:
    """Judge the formulas named, or all that are not in the record."""
    with tempfile.TemporaryDirectory() as room:
        bench = Bench(Path(room))
        chosen = spoken_of(bench.formulas, bench.theorems)
        known = {} if names else recorded()
        results = {name: found for name, found in known.items() if name in chosen and "refused" in found}
        for name, formula in chosen.items():
            if name not in results and (not names or name in names or formula.name in names):
                results[name] = judged(bench, formula)
                print(name, results[name], flush=True)
                if not names:
                    ordered = {each: results[each] for each in chosen if each in results}
                    RECORD.write_text(json.dumps(ordered, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    unnoticed = [name for name, result in results.items() if "refused" not in result]
    print(f"{len(results)} formulas changed, {len(results) - len(unnoticed)} times a theorem was refused", *unnoticed)
    return int(bool(unnoticed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
