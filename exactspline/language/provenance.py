"""How an operand was made: what lets naive semantics see that two denominators are *structurally the same product*.

Every operand carries a recipe, a nested tuple ``(operation, recipe, recipe)`` with a leaf of its own for what comes
from outside. Making one costs next to nothing; only where two denominators meet is it boiled down to a number modulo a
Mersenne prime: a product to the product of its factors' numbers (so that neither their order nor their grouping
matters), anything else to a hash. Equal numbers are taken for equal structure only where the values agree too, so a
collision can never make a sum wrong.
"""

from __future__ import annotations

from itertools import count
from typing import Any

PRIME = (1 << 61) - 1
_leaves = count(1)

#: A leaf is an int; everything else a tuple of the operation and what it was applied to.
Recipe = Any

PRODUCT, SUM, DIFFERENCE, DERIVATIVE, MULTIPLE = range(5)


def leaf() -> Recipe:
    """The recipe of an operand that comes from outside."""
    return next(_leaves)


def number(recipe: Recipe) -> int:
    """The recipe boiled down.

    >>> a, b, c = leaf(), leaf(), leaf()
    >>> number((PRODUCT, (PRODUCT, a, b), c)) == number((PRODUCT, b, (PRODUCT, c, a)))
    True
    >>> number((SUM, a, b)) == number((SUM, b, a))
    False
    """
    known: dict[int, int] = {}
    todo = [recipe]
    while todo:
        r = todo[-1]
        if id(r) in known:
            todo.pop()
        elif not isinstance(r, tuple):
            known[id(r)] = hash((r,)) % PRIME
        else:
            missing = [part for part in r[1:] if isinstance(part, (tuple, int)) and id(part) not in known]
            if missing:
                todo += missing
                continue
            known[id(r)] = _boiled(r, known)
    return known[id(recipe)]


def _boiled(r: tuple[Any, ...], known: dict[int, int]) -> int:
    parts = [known.get(id(part), 0) for part in r[1:]]
    if r[0] == PRODUCT:
        return parts[0] * parts[1] % PRIME
    if r[0] == MULTIPLE:
        return parts[0] * hash(r[2]) % PRIME
    return hash((r[0], *parts)) % PRIME
