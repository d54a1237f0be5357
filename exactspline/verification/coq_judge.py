"""The kernel of Coq as a judge: the theorems are compiled, and their assumptions printed."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from exactspline.verification.claim import Claim
from exactspline.verification.coq.emission import ROOT, Library, Stated, claims_header, library, why_unstated
from exactspline.verification.vocabulary import Verdict

#: Coq's answer for a theorem without assumptions.
CLOSED = "Closed under the global context"
#: The text of the column where Coq is not installed.
MISSING = "Coq is not installed"
#: What is said of a claim without a theorem.
NOT_STATED = "not stated"
#: The mark before every answer.
MARK = "about"
#: The time limit for one file, in seconds.
SECONDS = 600


@dataclass(frozen=True)
class Opinion:
    """The kernel's opinion on a claim: the theorem, or why there is none, and the assumptions of the theorem."""

    theorem: str
    says: str
    assumes: str = ""

    def __str__(self) -> str:
        return f"{self.says}, {self.assumes}" if self.assumes else self.says


def opinions(claims: Iterable[Claim]) -> dict[tuple[str, str], Opinion]:
    """The kernel's opinions on claims, by paper and key. Every theorem of the claims is compiled; without Coq every
    opinion says so. Claims without a theorem have an opinion that says why.
    """
    claims = list(claims)
    wanted = {(claim.paper, claim.key) for claim in claims}
    made = library()
    chosen = {
        name: tuple(each for each in own if (each.claim.paper, each.claim.key) in wanted)
        for name, own in made.theorems.items()
    }
    found: dict[tuple[str, str], list[Opinion]] = {}
    compiled = _compiled(made, chosen) if shutil.which("coqc") else {}
    for own in chosen.values():
        for each in own:
            if each.reason:
                said = Opinion("", NOT_STATED, each.reason)
            elif not shutil.which("coqc"):
                said = Opinion(each.name, MISSING)
            elif each.name in compiled:
                fails = each.claim.expected == Verdict.REFUTED
                said = Opinion(each.name, "fails" if fails else "holds", compiled[each.name])
            else:
                said = Opinion(each.name, "not accepted")
            found.setdefault((each.claim.paper, each.claim.key), []).append(said)
    unstated = {(claim.paper, claim.key): [Opinion("", NOT_STATED, why_unstated(claim))] for claim in claims}
    return {key: _together(own) for key, own in (unstated | found).items()}


def _together(own: list[Opinion]) -> Opinion:
    """The least favourable opinion of those on the dimensions of one claim."""
    order = ("not accepted", NOT_STATED, MISSING, "holds", "fails")
    return min(own, key=lambda each: order.index(each.says))


def _compiled(made: Library, chosen: dict[str, tuple[Stated, ...]]) -> dict[str, str]:
    """The assumptions of the accepted theorems, by name."""
    found: dict[str, str] = {}
    with tempfile.TemporaryDirectory() as room:
        place = Path(room)
        made.write(place)
        for name in made.files:
            if name in chosen and not chosen[name]:
                continue
            accepted = compile_file(place, name)
            theorems = [each for each in chosen.get(name, ()) if not each.reason]
            if accepted:
                found |= assumptions(place, name, [each.name for each in theorems])
                continue
            for each in theorems:
                if _alone(place, name, each):
                    found |= assumptions(place, f"{name}_{each.name}", [each.name])
    return found


def compile_file(place: Path, name: str) -> bool:
    """Whether Coq accepts a file of a library."""
    return _coqc(place, f"{name}.v")[0]


def _alone(place: Path, name: str, theorem: Stated) -> bool:
    """Whether one theorem of a file that is not accepted is accepted."""
    text = claims_header(theorem.claim.paper, theorem.text) + theorem.text
    (place / f"{name}_{theorem.name}.v").write_text(text, encoding="utf-8")
    return compile_file(place, f"{name}_{theorem.name}")


def assumptions(place: Path, module: str, theorems: Iterable[str]) -> dict[str, str]:
    """The assumptions of compiled theorems of a module, each in one line."""
    names = list(theorems)
    logical = f"{ROOT}.{module.replace('/', '.')}"
    asked = "".join(
        f'Goal True. idtac "{MARK} {name}". Abort.\nPrint Assumptions {logical}.{name}.\n' for name in names
    )
    ask = place / "Ask.v"
    ask.write_text(f"Require {logical}.\n{asked}", encoding="utf-8")
    accepted, said = _coqc(place, "Ask.v")
    answers = said.split(MARK)[1:] if accepted else []
    return {name: _told(answer) for name, answer in zip(names, answers, strict=False)}


def _told(answer: str) -> str:
    if CLOSED in answer:
        return "no axioms"
    return "axioms " + ", ".join(re.findall(r"^(?!Axioms:)(\S+)(?=\s*:)", answer, re.MULTILINE))


def _coqc(place: Path, file: str) -> tuple[bool, str]:
    try:
        run = subprocess.run(
            ["coqc", "-q", "-R", ".", ROOT, file],
            cwd=place,
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False, ""
    return run.returncode == 0, run.stdout
