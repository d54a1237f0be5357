"""Words for evidence: the generic function that each type of evidence extends."""

from __future__ import annotations

from functools import singledispatch

from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification.evidence import Found


def worded(item: Found | None, numbers: Numbers = EXACT) -> str:
    """Evidence in words; empty where there is none.

    >>> from exactspline.numbers.exact import mpq
    >>> from exactspline.verification.evidence import At, ZeroAt
    >>> worded(ZeroAt(At(mpq(1, 3)))), worded(None)
    ('zero at the parameter 1/3', '')
    """
    return "" if item is None else words(item, numbers)


@singledispatch
def words(item: object, numbers: Numbers = EXACT) -> str:
    """One piece of evidence in words, with its numbers formatted by `numbers`."""
    raise TypeError(f"{type(item).__name__} has no words")
