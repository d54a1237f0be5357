"""What takes long to decide, decided once for all tests of a process that read it."""

from functools import cache

from exactspline.verification import errata
from exactspline.verification.errata import Erratum


@cache
def errors_in_print() -> tuple[Erratum, ...]:
    """The errors of the papers that are meant where none is named."""
    return tuple(errata.errata())


@cache
def remarks() -> tuple[Erratum, ...]:
    """The misreadings that no paper makes."""
    return tuple(errata.remarks())
