"""The ledger: the verdicts on claims, for all curves and on single curves; and rows of earlier runs of ``prove``, kept
in one file of the user's cache directory.

A row is found again by a digest of all that it depends on: the code of this package and the versions of what it
computes with, the files of a user's paper, the claim, and the curve. Rows that were left open because of their cost,
and those of a folder whose formulas run unchecked, are decided each time.
"""

from __future__ import annotations

import pickle
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from hashlib import sha256
from importlib import resources
from importlib.metadata import PackageNotFoundError, version
from os import environ
from pathlib import Path
from time import perf_counter

from exactspline.atomic_write import write_atomically
from exactspline.errors import CurveFileError, ExactSplineError, ReachError, as_instance
from exactspline.hooks import Displayed
from exactspline.interchange.examples import example, example_names
from exactspline.language.kinds import kind_of
from exactspline.one_line import one_line
from exactspline.papers.folder import Paper, files_in
from exactspline.polynomials.cost import within_seconds
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.symbolic.factorization import named_by
from exactspline.verification.claim import Claim
from exactspline.verification.claims import expect_claim
from exactspline.verification.combined import Proofs, fitting, proofs_of_this_run
from exactspline.verification.decision import table_1_splines
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import DegreeHere, Evidence, Found
from exactspline.verification.paper_curves import one_patch_surfaces, own_curves
from exactspline.verification.verdict import (
    CONTRADICTION,
    INAPPLICABLE,
    NOT_ASKED,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    VERIFIED,
    Finding,
    compared,
    undecided,
)
from exactspline.verification.vocabulary import ArgumentKind, Name, Reason, Status, Verdict

# ---- rows


#: The name that stands for all curves.
ALL_CURVES = Name("")


@dataclass(frozen=True)
class Row(Displayed):
    """A line of the ledger: the finding of a check of a claim, for all curves (``curve`` is empty) or on one.

    ``reading`` is the evaluation mode in which the claim was decided, ``beside`` are the operands in addition to the
    curve, ``expected`` are the verdicts that agree with the record, and ``second`` is the finding of a second verifier,
    if one was asked.
    """

    claim: Claim
    reading: Name
    curve: Name
    finding: Finding
    expected: tuple[Verdict, ...]
    seconds: float
    beside: Evidence | None = None
    second: Finding | None = None

    @one_line
    def __repr__(self) -> str:
        return f"<Row {self.claim.key}: {self.finding.verdict}>"

    @property
    def id(self) -> str:
        """The id of the claim."""
        return self.claim.id

    @property
    def key(self) -> str:
        """The key of the claim."""
        return self.claim.key

    @property
    def paper(self) -> str:
        """The paper of the claim."""
        return self.claim.paper

    @property
    def status(self) -> Status:
        """Whether the statement is printed, corrected, or ours."""
        return self.claim.status

    @property
    def statement(self) -> str:
        """The statement, with a mark where the paper prints another one."""
        return self.claim.statement + (" (corrected)" if self.status == Status.MEANT else "")

    @property
    def claimed(self) -> str:
        """The claimed value; on one curve as a number."""
        here = self.computed
        return here.relation.bound(here.claimed) if isinstance(here, DegreeHere) else self.claim.claims

    @property
    def verdict(self) -> Verdict:
        """The verdict."""
        return self.finding.verdict

    @property
    def computed(self) -> Found | None:
        """The computed value."""
        return self.finding.computed

    @property
    def factor(self) -> Found | None:
        """The factor between two sides."""
        return self.finding.factor

    @property
    def witness(self) -> Evidence | None:
        """The place where the claim fails, or the reason why nothing was decided."""
        return self.finding.witness

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the recorded one."""
        return self.verdict in self.expected

    @property
    def out_of_reach(self) -> bool:
        """Whether the claim, or the finding of a second verifier, is undecided because of its cost."""
        return any(each and each.reason == Reason.COST for each in (self.finding, self.second))

    @property
    def differs(self) -> bool:
        """Whether the verdict of the row, or that of a second verifier, contradicts the record. UNDECIDED because of
        the cost and NOT ASKED do not contradict it.
        """
        second = self.second.verdict if self.second else UNDECIDED
        opposed = second in (PROVED, REFUTED) and (second == REFUTED) != (REFUTED in self.expected)
        return opposed or not (self.as_recorded or self.refused or self.finding.reason == Reason.COST)

    @property
    def refused(self) -> bool:
        """Whether the claim could not be asked, though its author meant it to be."""
        return self.verdict == NOT_ASKED and not self.as_recorded


def _row(
    claim: Claim,
    reading: Name,
    finding: Finding,
    seconds: float,
    *,
    curve: Name = ALL_CURVES,
    beside: Evidence | None = None,
    is_example: bool = False,
) -> Row:
    """A finding compared with the record. The record is about all curves. On one curve a claim that holds must be
    VERIFIED, unless it is vacuous there, which is recorded for the example curves; one that fails in general may well
    hold there.
    """
    expected = _expected(claim, curve, finding, is_example) if curve else (claim.expected,)
    return Row(claim, reading, curve, finding, expected, seconds, beside)


def _expected(claim: Claim, curve: Name, finding: Finding, is_example: bool) -> tuple[Verdict, ...]:
    if finding.verdict == INAPPLICABLE:
        return (INAPPLICABLE,)
    if finding.reason in (Reason.LEFT, Reason.SAMPLED):
        return (UNDECIDED,)
    if (finding.verdict == VACUOUS and not is_example) or (is_example and curve in claim.vacuous):
        return (VACUOUS,)
    return (VERIFIED,) if claim.expected in (PROVED, VERIFIED) else (REFUTED, VERIFIED)


@dataclass(frozen=True)
class Counts:
    """The number of statements of one status, the numbers of those that hold and of those that are refuted, and the
    number of errors.
    """

    statements: int
    hold: int
    refuted: int
    errors: int

    @property
    def neither(self) -> int:
        """The number of statements that neither hold nor are refuted."""
        return self.statements - self.hold - self.refuted


def count_statements(decided: Iterable[tuple[Claim, Verdict]]) -> dict[Status, Counts]:
    """The counts by status of claims with their verdicts for all curves.

    >>> from exactspline.verification.claims import select
    >>> count_statements((claim, claim.expected) for claim in select(["C4.2b"]))[Status.PRINTED]
    Counts(statements=2, hold=1, refuted=1, errors=1)
    """
    pairs = list(decided)
    return {status: _counts([pair for pair in pairs if pair[0].status == status]) for status in Status}


def recorded_counts(claims: Iterable[Claim]) -> dict[Status, Counts]:
    """The counts by status of the verdicts on record."""
    return count_statements((claim, claim.expected) for claim in claims)


def _counts(decided: list[tuple[Claim, Verdict]]) -> Counts:
    fails = [claim for claim, verdict in decided if verdict == REFUTED]
    holds = sum(verdict in (PROVED, VERIFIED) for _, verdict in decided)
    return Counts(len(decided), holds, len(fails), len({(claim.paper, error_of(claim)) for claim in fails}))


def error_of(claim: Claim) -> str:
    """The error to which a refuted statement belongs; a statement without a recorded error is an error of its own."""
    return claim.error or claim.key


UNNAMED = Name("(unnamed curve)")
TABLE = Name("splines of degrees 2 and 3 over different knots")
#: The evaluation mode of checks on one curve.
SPLINE = Name("spline")
Task = Callable[[], Row]
#: What becomes of a check of a claim on a curve (None: for all curves), given the proofs of the run.
Around = Callable[[Claim, object, Task, Proofs], Task]


def audit(claims: Iterable[Claim], curves: Iterable[Nurbs | NurbsSurface] | None = None) -> Iterator[Row]:
    """The rows of the ledger.

    Without curves, every claim is decided for all curves, and then checked on every example curve to which it applies.
    With curves or surfaces, claims are checked on these.

    >>> from exactspline.verification.claims import select
    >>> [(str(row.reading), str(row.verdict)) for row in audit(select(["C4.1a"]), [example("circle")])]
    [('spline', 'VERIFIED'), ('spline', 'VERIFIED')]

    A claim that is proved for all curves and fails on one of them is a CONTRADICTION there.
    """
    yield from settled([task() for task in tasks(claims, curves)])


def settled(rows: Sequence[Row]) -> list[Row]:
    """The rows of a run, where a proof for all curves that a single curve contradicts is not counted as a proof."""
    contradicted = {(row.paper, row.key): row.witness for row in rows if row.verdict == CONTRADICTION}
    return [
        replace(row, finding=replace(row.finding, verdict=CONTRADICTION, witness=contradicted[row.paper, row.key]))
        if row.verdict == PROVED and (row.paper, row.key) in contradicted
        else row
        for row in rows
    ]


def tasks(
    claims: Iterable[Claim],
    curves: Iterable[Nurbs | NurbsSurface] | None = None,
    limit: int | None = None,
    around: Around = lambda claim, on, task, proofs: task,
) -> list[Task]:
    """The checks as calls that return a row each, so that progress can be shown; a row that takes more than `limit`
    seconds of processor time is undecided. Each run evaluates curves with its own objects, so that runs in several
    threads can share curves. `around` may replace each check by another one.
    """
    chosen, proofs = list(claims), proofs_of_this_run()
    calls: list[Task] = []
    if curves is None:
        calls += [around(claim, None, partial(decide, claim, proofs, limit), proofs) for claim in chosen]
        if of_table := [claim for claim in chosen if claim.curve == ArgumentKind.TABLE]:
            table = Evaluation(table_1_splines())
            checks = [partial(checked, claim, table, TABLE, proofs, limit) for claim in of_table]
            calls += [around(claim, TABLE, check, proofs) for claim, check in zip(of_table, checks, strict=True)]
        evaluations: dict[int, Evaluation] = {}
        for name in dict.fromkeys(claim.paper for claim in chosen):
            own = [claim for claim in chosen if claim.paper == name]
            tried: list[Nurbs | NurbsSurface] = [*_curves_of(own[0].source_paper)]
            if any(kind_of(claim.curve).made_of_a_surface for claim in own):
                tried += one_patch_surfaces()
            calls += _on_curves(own, tried, proofs, evaluations, limit, around)
        return calls
    return _on_curves(chosen, curves, proofs, {}, limit, around)


def _curves_of(source: Paper) -> list[Nurbs]:
    """The curves on which a paper is checked: the curves in its folder, or the examples if there are none."""
    return list(own_curves(source).values()) or [example(name) for name in example_names()]


def _on_curves(
    claims: Iterable[Claim],
    curves: Iterable[Nurbs | NurbsSurface],
    proofs: Proofs,
    evaluations: dict[int, Evaluation],
    limit: int | None,
    around: Around,
) -> list[Task]:
    """The checks of claims, curve by curve; formulas are evaluated once per curve, for all papers."""
    calls: list[Task] = []
    for curve in curves:
        own = evaluations.setdefault(id(curve), Evaluation(curve))
        calls += [
            around(claim, curve, partial(checked, claim, own, Name(own.curve.name) or UNNAMED, proofs, limit), proofs)
            for claim in claims
            if claim.applies_to(curve.dimension, curve.polynomial, surface=isinstance(curve, NurbsSurface))
        ]
    return calls


def decide(claim: Claim, proofs: Proofs | None = None, limit: int | None = None) -> Row:
    """Decide a claim for all curves. The claim is undecided if the decision takes more than `limit` seconds of
    processor time.
    """
    start = perf_counter()
    made = as_instance(proofs_of_this_run() if proofs is None else proofs, Proofs, "proofs", "leave them out")
    try:
        with within_seconds(limit):
            reading, finding = made[expect_claim(claim)]
    except ReachError as error:
        reading, finding = claim.reading, undecided(error)
    return _row(claim, reading, finding, perf_counter() - start)


def checked(claim: Claim, own: Evaluation, name: Name, proofs: Proofs, limit: int | None = None) -> Row:
    """A claim checked on one curve; undecided if that takes more than `limit` seconds of processor time."""
    start = perf_counter()
    try:
        with within_seconds(limit), named_by(claim.source_paper):
            finding = _found_on(claim, own, proofs)
    except ExactSplineError as error:
        finding = undecided(error)
    is_example = bool(claim.source_paper.package) and name in example_names() and own.curve is example(name)
    beside, seconds = claim.beside(own), perf_counter() - start
    return _row(claim, SPLINE, finding, seconds, curve=name, beside=beside, is_example=is_example)


def _found_on(claim: Claim, own: Evaluation, proofs: Proofs) -> Finding:
    """The finding on one curve. A claim that is refuted there must not be proved for all curves: the finding is
    compared with a proof from this run; if there is none, and the claim is not recorded as refuted, a proof is
    computed.
    """
    finding = fitting(claim, partial(claim.check, own, lambda: proofs[claim]))
    if finding.verdict == REFUTED and (claim in proofs or claim.expected != REFUTED):
        return compared(proofs[claim][1], finding)
    return finding


#: What the package computes with.
LIBRARIES = ("python-flint", "gmpy2", "sympy", "mpmath", "numpy")
#: The most rows that are kept, the newest ones.
MOST = 200_000


def cache_file() -> Path | None:
    """The file of the rows: in the folder that the environment variable ``EXACTSPLINE_CACHE`` names, by default where
    the system keeps what programs may lose; None where the variable is ``none``.
    """
    named = environ.get("EXACTSPLINE_CACHE")
    if sys.platform == "win32":
        folder = Path(environ.get("LOCALAPPDATA") or Path("~", "AppData", "Local").expanduser())
    elif sys.platform == "darwin":
        folder = Path("~", "Library", "Caches").expanduser()
    else:
        folder = Path(environ.get("XDG_CACHE_HOME") or Path("~", ".cache").expanduser())
    return None if named == "none" else Path(named or folder / "exactspline") / "rows"


def digest_of_code() -> bytes:
    """A digest of all files of the package, of the interpreter, and of the versions of what it computes with."""
    digest = sha256(f"{sys.version} {[*map(_version, LIBRARIES)]} {environ.get('EXACTSPLINE_EXTENSION')}".encode())
    for name, file in sorted(files_in(resources.files("exactspline"))):
        digest.update(f"\0{name}\0".encode() + sha256(file.read_bytes()).digest())
    return digest.digest()


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return ""


class Memory:
    """The rows of a file, and the new ones of a run; `found` are how many of the rows of the run were in the file."""

    def __init__(self, place: Path | None) -> None:
        self.place, self.found, self._code = place, 0, digest_of_code() if place else b""
        self._rows: dict[bytes, bytes] = {}
        self._papers: dict[Paper, str] = {}
        self._curves: dict[int, tuple[object, str]] = {}
        try:
            content = place.read_bytes() if place else b""
        except OSError:
            content = b""
        # nothing is read of a damaged file, nor of one that other code has written
        if content[:32] == self._seal(content[32:]):
            self._rows = pickle.loads(content[32:])
        self._known = len(self._rows)

    def _seal(self, data: bytes) -> bytes:
        return sha256(self._code + data).digest()

    def around(self, claim: Claim, on: object, task: Task, proofs: Proofs) -> Task:
        """A check that is carried out unless its row is known; the check itself where there is no file, and for a paper
        whose formulas run unchecked.
        """
        remembered = self.place and not _is_unchecked(claim.source_paper)
        return partial(self._row, claim, on, task, proofs) if remembered else task

    def _row(self, claim: Claim, on: object, task: Task, proofs: Proofs) -> Row:
        key = self._key(claim, on)
        if key in self._rows:
            self.found += 1
            row = Row(claim, *pickle.loads(self._rows[key]))
            if on is None:
                proofs.take(claim, (row.reading, row.finding))
            return row
        row = task()
        if row.finding.reason != Reason.COST:
            with suppress(pickle.PicklingError, TypeError, AttributeError):
                kept = row.reading, row.curve, row.finding, row.expected, row.seconds, row.beside
                self._rows[key] = pickle.dumps(kept)
        return row

    def _key(self, claim: Claim, on: object) -> bytes:
        """A digest of the claim, of the files that define it, and of the curve."""
        paper = claim.source_paper
        if paper not in self._papers:
            self._papers[paper] = _files(paper)
        if id(on) not in self._curves:
            self._curves[id(on)] = on, sha256(pickle.dumps(on)).hexdigest()
        return sha256(repr((self._papers[paper], claim.key, self._curves[id(on)][1])).encode()).digest()

    def save(self) -> None:
        """Write the file, where there are new rows and no file that they depend on was changed during the run; a folder
        in which nothing can be written is left alone.
        """
        new = len(self._rows) > self._known and all(_files(paper) == was for paper, was in self._papers.items())
        if self.place and new and digest_of_code() == self._code:
            data = pickle.dumps(dict([*self._rows.items()][-MOST:]))
            with suppress(OSError, CurveFileError):
                self.place.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
                write_atomically(self.place, lambda stream: stream.write(self._seal(data) + data))


def _files(paper: Paper) -> str:
    """The files of a paper and of those that it uses; those of the library are part of the code."""
    return repr((paper.name, [] if paper.package else paper.digests(), [*map(_files, paper.uses)]))


def _is_unchecked(paper: Paper) -> bool:
    """Whether formulas of a paper, or of one that it uses, may read what is in none of its files."""
    return paper.trusted or any(map(_is_unchecked, paper.uses))
