"""Objects as data for programs: exact numbers as text, enumerations by their values, sequences as lists."""

from __future__ import annotations

from enum import Enum
from operator import attrgetter

from exactspline.numbers.exact import mpq, text
from exactspline.splines.knots import KnotVector

Data = dict[str, object]


def plain(value: object) -> object:
    """A value of JSON.

    >>> plain((mpq(1, 2), [None, True], "x"))
    ['1/2', [None, True], 'x']
    """
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, type(mpq())):
        return text(value)
    return [plain(each) for each in value] if isinstance(value, (tuple, list, KnotVector)) else value


def picked(of: object, *names: str) -> Data:
    """Some attributes of an object; of an attribute of an attribute the last name is taken.

    >>> picked(mpq(1, 2), "numerator", "denominator")["denominator"]
    mpz(2)
    """
    return {name.rpartition(".")[2]: plain(attrgetter(name)(of)) for name in names}
