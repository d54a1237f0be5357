"""The kernel of Coq as a second verifier: the theorems are compiled, and their assumptions printed."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from pathlib import Path

from exactspline.display.forms import grouped
from exactspline.extras.coq.emission import ROOT, Library, Stated, claims_header, library, why_unstated
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim
from exactspline.verification.evidence import Fact, NoTheorem
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, Finding
from exactspline.verification.vocabulary import Name

#: Coq's answer for a theorem without assumptions.
CLOSED = "Closed under the global context"
#: The mark before every answer.
MARK = "about"
#: The time limit for one file, in seconds.
SECONDS = 600

#: The axioms of accepted theorems, by the name of the theorem.
Axioms = dict[str, tuple[Name, ...]]


class Coq:
    """The verifier that has theorems compiled by Coq's kernel: those of a given set of claims (all together, at the
    first request), or those of one claim at a time.
    """

    name, column = Name("coq"), Name("kernel")

    def __init__(self, claims: Iterable[Claim] = ()) -> None:
        self._claims = tuple(claims)
        self._found: dict[tuple[str, str], Finding] = {}

    def decide(self, claim: Claim) -> Finding:
        """The finding of the kernel; UNDECIDED, with the reason, if there is no theorem, or Coq is not installed."""
        if (claim.paper, claim.key) not in self._found:
            self._found |= findings({claim, *self._claims})
        return self._found[claim.paper, claim.key]


def findings(claims: Iterable[Claim]) -> dict[tuple[str, str], Finding]:
    """The findings of the kernel, by paper and key. A theorem states that a claim holds, or that it fails, according to
    the record; the kernel rejects a false theorem.
    """
    claims = list(claims)
    requested = {(claim.paper, claim.key) for claim in claims if claim.source_paper.package}
    # no theorem is about a user's folder
    made, installed = library() if requested else Library({}, {}), bool(shutil.which("coqc"))
    chosen = {
        name: tuple(each for each in own if (each.claim.paper, each.claim.key) in requested)
        for name, own in made.theorems.items()
    }
    # without a theorem there is nothing for which the theory would be compiled
    compiled = compiled_theorems(made, chosen) if installed and any(chosen.values()) else {}
    by_claim = grouped(
        ((each.claim.paper, each.claim.key), _finding(each, compiled, installed=installed))
        for own in chosen.values()
        for each in own
    )
    unstated = {(c.paper, c.key): [Finding(UNDECIDED, witness=NoTheorem(why_unstated(c)))] for c in claims}
    return {key: combined_findings(own) for key, own in (unstated | by_claim).items()}


def _finding(each: Stated, compiled: Axioms, *, installed: bool) -> Finding:
    """The finding that follows from one theorem."""
    if each.reason is not None:
        return Finding(UNDECIDED, witness=NoTheorem(each.reason))
    if each.name in compiled:
        verdict = REFUTED if each.claim.expected == REFUTED else PROVED
        return Finding(verdict, say.accepted_with(compiled[each.name]))
    return Finding(UNDECIDED, witness=Fact.NOT_ACCEPTED if installed else Fact.COQ_NOT_INSTALLED)


def combined_findings(own: list[Finding]) -> Finding:
    """The least favourable finding over the dimensions of one claim: an undecided one takes precedence."""

    def rank(finding: Finding) -> int:
        undecided = (Fact.NOT_ACCEPTED, None, Fact.COQ_NOT_INSTALLED)
        if finding.verdict == UNDECIDED:
            return undecided.index(finding.witness if isinstance(finding.witness, Fact) else None)
        return len(undecided) + (finding.verdict == REFUTED)

    return min(own, key=rank)


def compiled_theorems(made: Library, chosen: dict[str, tuple[Stated, ...]]) -> Axioms:
    """The axioms of the accepted theorems, by name."""
    axioms: Axioms = {}
    with tempfile.TemporaryDirectory() as room:
        place = Path(room)
        made.write(place)
        for name in made.files:
            if name in chosen and not chosen[name]:
                continue
            accepted = compile_file(place, name)
            theorems = [each for each in chosen.get(name, ()) if each.reason is None]
            if accepted:
                axioms |= assumptions(place, name, [each.name for each in theorems])
                continue
            for each in theorems:
                if _alone(place, name, each):
                    axioms |= assumptions(place, f"{name}_{each.name}", [each.name])
    return axioms


def compile_file(place: Path, name: str) -> bool:
    """Whether Coq accepts a file of a library."""
    return _coqc(place, f"{name}.v")[0]


def _alone(place: Path, name: str, theorem: Stated) -> bool:
    """Whether a single theorem of a rejected file is accepted."""
    text = claims_header(theorem.claim.paper, theorem.text) + theorem.text
    (place / f"{name}_{theorem.name}.v").write_text(text, encoding="utf-8")
    return compile_file(place, f"{name}_{theorem.name}")


def assumptions(place: Path, module: str, theorems: Iterable[str]) -> Axioms:
    """The axioms of compiled theorems of a module."""
    names = list(theorems)
    logical = f"{ROOT}.{module.replace('/', '.')}"
    asked = "".join(
        f'Goal True. idtac "{MARK} {name}". Abort.\nPrint Assumptions {logical}.{name}.\n' for name in names
    )
    ask = place / "Ask.v"
    ask.write_text(f"Require {logical}.\n{asked}", encoding="utf-8")
    accepted, said = _coqc(place, "Ask.v")
    answers = said.split(MARK)[1:] if accepted else []
    return {name: _axioms(answer) for name, answer in zip(names, answers, strict=False)}


def _axioms(answer: str) -> tuple[Name, ...]:
    """The names of axioms in an answer of Coq."""
    if CLOSED in answer:
        return ()
    return tuple(map(Name, re.findall(r"^(?!Axioms:)(\S+)(?=\s*:)", answer, re.MULTILINE)))


def _coqc(place: Path, file: str) -> tuple[bool, str]:
    try:
        command = ["coqc", "-q", "-R", ".", ROOT, file]
        run = subprocess.run(command, cwd=place, capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return False, ""
    return run.returncode == 0, run.stdout
