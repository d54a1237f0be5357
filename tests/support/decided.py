"""What takes long to decide, decided once for all tests of a process that read it."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from functools import cache, partial
from unittest import mock

from exactspline import claims
from exactspline.display import tables
from exactspline.verification import degree_tables, statement
from exactspline.verification.combined import Proofs, computed_once
from exactspline.verification.ledger import Row, audit
from exactspline.verification.statement import Erratum


@cache
def proofs() -> Proofs:
    """The proofs of the claims of all papers, by an engine in which no test has changed anything."""
    return Proofs()


def handed_on() -> Callable[[], AbstractContextManager[None]]:
    """A context for another process, in which no claim is decided that was so in this one."""
    return partial(computed_once, proofs())


MEASURED = degree_tables.generic_table


@cache
def generic_rows(*, polynomial: bool) -> list[degree_tables.GenericRow]:
    """The rows of the generic table of degrees."""
    return [call() for call in MEASURED(polynomial=polynomial)]


def generic_table(*, polynomial: bool = False) -> list[Callable[[], degree_tables.GenericRow]]:
    """The generic table of degrees, measured once."""
    return [partial(rows.__getitem__, i) for rows in (generic_rows(polynomial=polynomial),) for i in range(len(rows))]


@contextmanager
def decided_once() -> Iterator[None]:
    """A context in which no claim is decided, and no generic degree measured, that was so in another one."""
    generic = [mock.patch.object(each, "generic_table", generic_table) for each in (degree_tables, tables)]
    with computed_once(proofs()), generic[0], generic[1]:
        yield


@cache
def ledger(source: str) -> tuple[Row, ...]:
    """The rows of a paper: every claim for all curves, and on every example of which it speaks."""
    with decided_once():
        return tuple(audit(claims(paper=source)))


@cache
def errors_in_print() -> tuple[Erratum, ...]:
    """The errors of the papers that are meant where none is named."""
    with decided_once():
        return tuple(statement.errata())


@cache
def remarks() -> tuple[Erratum, ...]:
    """The misreadings that no paper makes."""
    with decided_once():
        return tuple(statement.remarks())
