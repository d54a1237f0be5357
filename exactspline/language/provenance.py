"""The provenance of an operand says how it was computed. By it, naive semantics recognizes that two denominators are
*structurally the same product*.

A provenance is a nested tuple ``(operation, provenance, …)`` with a distinct leaf for each input operand. It is cheap
to construct. Only when two denominators are compared are both brought to a canonical form, a constant times a multiset
of factors, so that neither the order nor the grouping of a product matters. Two provenances are the same if their
canonical forms are equal.
"""

from __future__ import annotations

from itertools import count
from typing import Any

from exactspline.numbers.exact import mpq

#: A leaf is an int; every other node is a tuple of an operation and its arguments.
Provenance = int | tuple[object, ...]
#: A constant, and the sorted numbers of the factors.
Canonical = tuple[mpq, tuple[int, ...]]

PRODUCT, SUM, DIFFERENCE, DERIVATIVE, MULTIPLE, WITHIN = range(6)
#: The provenance of the constant 1.
UNIT = 0
_leaves = count(UNIT + 1)


def leaf() -> Provenance:
    """The provenance of an input operand: a new leaf."""
    return next(_leaves)


def within(provenance: Provenance, leaves: tuple[tuple[Provenance, Provenance], ...]) -> Provenance:
    """A provenance in which leaves are replaced by other provenances; the substitution is made only when needed.

    >>> a, b, c = leaf(), leaf(), leaf()
    >>> same(within((PRODUCT, a, b), ((a, c), (b, c))), (PRODUCT, c, c))
    True
    """
    return WITHIN, provenance, leaves


def is_alone(provenance: Provenance) -> Provenance | None:
    """The leaf of which this is a constant multiple, or None.

    >>> a = leaf()
    >>> is_alone((MULTIPLE, a, -1)) == a, is_alone((PRODUCT, a, a)), is_alone(UNIT)
    (True, None, None)
    """
    while isinstance(provenance, tuple) and provenance[0] == MULTIPLE:
        provenance = provenance[1]  # type: ignore[assignment]  # the argument of MULTIPLE is a provenance
    return None if isinstance(provenance, tuple) or provenance == UNIT else provenance


def _put_in(provenance: Provenance, known: dict[Provenance, Provenance]) -> Provenance:
    """The provenance with its leaves replaced."""
    done: dict[int, Provenance] = {}
    todo = [provenance]
    while todo:
        node = todo[-1]
        if not isinstance(node, tuple):
            done[id(node)] = known.get(node, node)
        elif missing := [part for part in _parts(node) if id(part) not in done]:
            todo += missing
            continue
        elif node[0] == MULTIPLE:
            done[id(node)] = (MULTIPLE, done[id(node[1])], node[2])
        else:
            parts = [done[id(part)] if isinstance(part, (tuple, int)) else part for part in node[1:]]
            done[id(node)] = (node[0], *parts)
        todo.pop()
    return done[id(provenance)]


def same(first: Provenance, second: Provenance) -> bool:
    """Whether two operands were computed as the same product.

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
    opened: dict[int, Provenance] = {}
    return _canonical(first, known, numbers, opened) == _canonical(second, known, numbers, opened)


def _canonical(
    provenance: Provenance, known: dict[int, Canonical], numbers: dict[Any, int], opened: dict[int, Provenance]
) -> Canonical:
    """The canonical form; `numbers` numbers the factors of both sides of a comparison, `opened` keeps alive the objects
    whose ids are keys of `known`.
    """
    todo = [provenance]
    while todo:
        node: Any = todo[-1]
        if id(node) in known:
            todo.pop()
        elif isinstance(node, tuple) and node[0] == WITHIN:
            if id(node) not in opened:
                opened[id(node)] = _put_in(node[1], dict(node[2]))
            inside = opened[id(node)]
            if id(inside) in known:
                known[id(node)] = known[id(inside)]
            else:
                todo.append(inside)
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
    """The provenances among the arguments of a node; the others are constants and markers."""
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
