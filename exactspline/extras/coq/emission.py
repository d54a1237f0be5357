"""The theorems of all papers as files of Coq: a base written by hand, formulas and claims generated from the papers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path

from exactspline.atomic_write import write_text
from exactspline.errors import ClaimError, ExactSplineError, FormulaError
from exactspline.extras.coq.formulas import HEADER, THEORY, Formulas, written_for
from exactspline.extras.coq.refutations import refutation
from exactspline.extras.coq.theorems import STATED, theorem
from exactspline.language.kinds import kind_of
from exactspline.papers import Paper, papers
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.vocabulary import Extent, Verdict

#: The files written by hand: those required by the theorems about papers, one that shows that their assumptions are
#: consistent, and one for answers about one curve.
BY_HAND = (*THEORY, "Models", "Answers", "Meetings")
#: The logical name of the directory.
ROOT = "ExactSpline"


@dataclass(frozen=True)
class Stated:
    """A claim in one dimension as a theorem: its name and its text, or the reason why there is none."""

    claim: Claim
    name: str
    text: str
    reason: ExactSplineError | None = None

    @property
    def why(self) -> str:
        """The reason why there is none, as text."""
        return "" if self.reason is None else self.reason.problem


@dataclass(frozen=True)
class Library:
    """The files by name, each after those that it requires, and the theorems by file."""

    files: dict[str, str]
    theorems: dict[str, tuple[Stated, ...]]

    def write(self, directory: Path) -> None:
        """Write the files, and the list of them by which they are compiled."""
        for name, text in self.files.items():
            _write(directory / f"{name}.v", text)
        listed = "\n".join([f"-R . {ROOT}", *[f"{name}.v" for name in self.files]])
        _write(directory / "_CoqProject", f"{listed}\n")

    def of(self, claims: Iterable[Claim]) -> Library:
        """The theorems of some claims only, and the files that they require.

        Raises `ClaimError` where none of them has a theorem, with the reasons.
        """
        chosen = list(claims)
        keys = {(claim.paper, claim.key) for claim in chosen}
        files = {name: text for name, text in self.files.items() if name not in self.theorems}
        theorems: dict[str, tuple[Stated, ...]] = {}
        for name, own in self.theorems.items():
            if kept := tuple(each for each in own if (each.claim.paper, each.claim.key) in keys):
                theorems[name] = kept
                if any(each.reason is None for each in kept):
                    files[name] = _claims_file(kept[0].claim.source_paper, kept)
        known = {(each.claim.paper, each.claim.key) for own in theorems.values() for each in own}
        without = [Stated(c, "", "", why_unstated(c)) for c in chosen if (c.paper, c.key) not in known]
        if without:
            theorems[""] = tuple(without)
        made = Library(files, theorems)
        if len(made.unstated) == sum(map(len, theorems.values())):
            reasons = dict.fromkeys(f"{each.claim.key}: {each.why}" for each in made.unstated)
            raise ClaimError("no theorem", where="; ".join(list(reasons)[:3]), remedy="name an equality of a paper")
        return made

    @property
    def unstated(self) -> list[Stated]:
        """The claims of equalities that have no theorem, with the reason."""
        return [each for own in self.theorems.values() for each in own if each.reason is not None]


def _write(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as reason:
        raise ClaimError(
            f"no directory can be made here ({reason.strerror})", where=str(path.parent), remedy="name another one"
        ) from None
    write_text(path, text, ClaimError)


def theory(name: str) -> str:
    """The text of a file written by hand."""
    return resources.files(__package__).joinpath("theory", f"{name}.v").read_text(encoding="utf-8")


@cache
def library() -> Library:
    """The theorems of every paper that comes with the library."""
    formulas = Formulas(papers())
    files = {name: theory(name) for name in BY_HAND}
    files |= {f"formulas/{paper.name}": formulas.definitions(paper) for paper in formulas.papers}
    theorems: dict[str, tuple[Stated, ...]] = {}
    for paper in formulas.papers:
        for table, claims in _by_table(paper):
            theorems_of_table = tuple(each for claim in claims for each in _stated(claim, paper, formulas))
            if theorems_of_table:
                name = f"claims/{paper.name}_{table}"
                theorems[name] = theorems_of_table
                if any(each.reason is None for each in theorems_of_table):
                    files[name] = _claims_file(paper, theorems_of_table)
    return Library(files, theorems)


def _by_table(paper: Paper) -> Iterator[tuple[str, list[Claim]]]:
    """The claims of a paper by the file that contains them."""
    groups: dict[str, list[Claim]] = {}
    for table, claim in zip(paper.claim_tables(), claims_of(paper.name), strict=True):
        groups.setdefault(Path(table.place.split(",")[0]).stem, []).append(claim)
    yield from groups.items()


def _stated(claim: Claim, paper: Paper, formulas: Formulas) -> list[Stated]:
    """A claim of an equality as theorems, one per dimension: that it holds, or that it fails, depending on the recorded
    verdict.
    """
    if not isinstance(claim, STATED) or claim.on == Extent.CURVE:
        return []
    kind = kind_of(claim.curve)
    if not written_for(kind):
        return [Stated(claim, "", "", FormulaError(f"arguments of the kind {kind.name!r} are not written"))]
    make = refutation if claim.expected == Verdict.REFUTED else theorem
    theorems = []
    for dimension in kind.dimensions:
        try:
            text = make(claim, dimension, lambda formula: formulas.named(formula, paper))
        except ExactSplineError as error:
            theorems.append(Stated(claim, "", "", error))
            continue
        match = re.search(r"^Theorem (\S+)", text, re.MULTILINE)
        assert match is not None
        theorems.append(Stated(claim, match[1], text))
    return theorems


def _claims_file(paper: Paper, theorems: Iterable[Stated]) -> str:
    """The file of the theorems of one table of claims."""
    texts = [each.text for each in theorems if each.reason is None]
    return "\n".join([claims_header(paper.name, "".join(texts)), *texts])


def claims_header(name: str, text: str) -> str:
    """The header of a file with theorems about a paper, derived from their text."""
    own = next(each for each in papers() if each.name == name)
    used = [each for each in papers() if each is not own and f"{each.name}." in text]
    others = [f"From {ROOT}.formulas Require {each.name}." for each in used]
    return "\n".join(
        [
            HEADER.format(title=own.title, about="its claims"),
            "Require Import ZArith List.",
            f"From {ROOT} Require Import {' '.join(THEORY)}.",
            *others,
            f"From {ROOT}.formulas Require Import {own.name}.",
            "Import ListNotations.",
            "Local Open Scope formula_scope.",
            "",
        ]
    )


def why_unstated(claim: Claim) -> ExactSplineError:
    """Why a claim has no theorem."""
    if not isinstance(claim, STATED):
        return FormulaError(f"claims of the kind {claim.kind!r} are not equalities")
    foreign = not claim.source_paper.package
    return FormulaError("formulas of users' folders are not written in Coq" if foreign else "it has none")


def emit(directory: Path, claims: Iterable[Claim] | None = None) -> Library:
    """Write theorems into a directory: those of these claims, by default of all papers."""
    made = library() if claims is None else library().of(claims)
    made.write(directory)
    return made
