"""What takes long to decide, decided once for all tests of a process that read it."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

from exactspline.verification import errata
from exactspline.verification.combined import Proofs, computed_once
from exactspline.verification.errata import Erratum


@cache
def proofs() -> Proofs:
    """The proofs of the claims of all papers, by an engine in which no test has changed anything."""
    return Proofs()


@contextmanager
def decided_once() -> Iterator[None]:
    """A context in which no claim is decided that was decided in another one."""
    with computed_once(proofs()):
        yield


@cache
def errors_in_print() -> tuple[Erratum, ...]:
    """The errors of the papers that are meant where none is named."""
    with decided_once():
        return tuple(errata.errata())


@cache
def remarks() -> tuple[Erratum, ...]:
    """The misreadings that no paper makes."""
    with decided_once():
        return tuple(errata.remarks())
