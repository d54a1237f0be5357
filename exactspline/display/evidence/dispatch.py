"""Words for what was found: the function that each type of evidence extends."""

from __future__ import annotations

from functools import singledispatch

from exactspline.display.numbers import EXACT, Numbers
from exactspline.verification.evidence import Found


def worded(found: Found | None, numbers: Numbers = EXACT) -> str:
    """What was found in words; empty where nothing was.

    >>> from exactspline.numbers.exact import mpq
    >>> from exactspline.verification.evidence import At, ZeroAt
    >>> worded(ZeroAt(At(mpq(1, 3)))), worded(None)
    ('zero at the parameter 1/3', '')
    """
    return "" if found is None else words(found, numbers)


@singledispatch
def words(found: object, numbers: Numbers = EXACT) -> str:
    """One piece of evidence in words, its numbers written as `numbers` says."""
    raise TypeError(f"{type(found).__name__} has no words")
