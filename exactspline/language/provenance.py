"""How an operand was made: what lets naive semantics see that two denominators are *structurally the same product*.

A provenance is a nested tuple ``(operation, provenance, …)`` with a leaf of its own for what comes from outside. Making
one costs next to nothing; only where two denominators meet are both brought to a canonical form: a constant times a
multiset of factors, so that neither the order nor the grouping of a product matters. Two are the same when these forms
are equal, exactly.
"""

from __future__ import annotations

from itertools import count
from typing import Any

from exactspline.exact import mpq

#: A leaf is an int; everything else a tuple of the operation and what it was applied to.
Provenance = int | tuple[object, ...]
#: A constant, and the factors by their numbers, sorted.
Canonical = tuple[mpq, tuple[int, ...]]

PRODUCT, SUM, DIFFERENCE, DERIVATIVE, MULTIPLE = range(5)
#: The provenance of the constant 1.
UNIT = 0
_leaves = count(UNIT + 1)


def leaf() -> Provenance:
    """The provenance of an operand that comes from outside."""
    return next(_leaves)


def same(first: Provenance, second: Provenance) -> bool:
    """Whether two operands were made as the same product.

    >>> a, b, c = leaf(), leaf(), leaf()
    >>> same((PRODUCT, (PRODUCT, a, b), c), (PRODUCT, b, (PRODUCT, c, a)))
    True
    >>> same((SUM, a, b), (SUM, b, a)), same((MULTIPLE, a, -1), (MULTIPLE, a, -2))
    (False, False)
    """
    if first is second:
        return True
    known: dict[int, Canonical] = {}
    numbers: dict[Any, int] = {}
    return _canonical(first, known, numbers) == _canonical(second, known, numbers)


def _canonical(provenance: Provenance, known: dict[int, Canonical], numbers: dict[Any, int]) -> Canonical:
    """The canonical form; `numbers` numbers the factors that both sides of a comparison have."""
    todo = [provenance]
    while todo:
        node = todo[-1]
        if id(node) in known:
            todo.pop()
        elif isinstance(node, tuple):
            missing = [part for part in _parts(node) if id(part) not in known]
            if missing:
                todo += missing
            else:
                known[id(node)] = _formed(node, [known[id(part)] for part in _parts(node)], numbers)
        else:
            known[id(node)] = (mpq(1), ()) if node == UNIT else (mpq(1), (numbers.setdefault(node, len(numbers)),))
    return known[id(provenance)]


def _parts(node: tuple[Any, ...]) -> tuple[Provenance, ...]:
    """The provenances in a node; what else is in it are constants and marks."""
    return node[1:2] if node[0] == MULTIPLE else tuple(part for part in node[1:] if isinstance(part, (tuple, int)))


def _formed(node: tuple[Any, ...], parts: list[Canonical], numbers: dict[Any, int]) -> Canonical:
    if node[0] == PRODUCT:
        (a, left), (b, right) = parts
        return a * b, tuple(sorted(left + right))
    if node[0] == MULTIPLE:
        constant, factors = parts[0]
        return constant * mpq(node[2]), factors
    marks = tuple(part for part in node[1:] if not isinstance(part, (tuple, int)))
    return mpq(1), (numbers.setdefault((node[0], *parts, *marks), len(numbers)),)
