"""Rows of earlier runs of ``prove``, kept in one file of the user's cache directory.

A row is found again by a digest of all that it depends on: the code of this package and the versions of what it
computes with, the files of a user's paper, the claim, and the curve. Rows that were left open because of their cost,
and those of a folder whose formulas run unchecked, are decided each time.
"""

from __future__ import annotations

import pickle
import sys
from contextlib import suppress
from functools import partial
from hashlib import sha256
from importlib import resources
from importlib.metadata import PackageNotFoundError, version
from os import environ
from pathlib import Path

from exactspline.atomic_write import write_atomically
from exactspline.errors import CurveFileError
from exactspline.papers.folder import Paper, files_in
from exactspline.verification.claim import Claim
from exactspline.verification.combined import Proofs
from exactspline.verification.ledger import Row, Task
from exactspline.verification.vocabulary import Reason

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
