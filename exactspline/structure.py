"""How an operand was made, in one number.

Naive semantics must see that two denominators are *structurally the same product*, whether or not one Python object holds both. Every operand
therefore carries a tag modulo a Mersenne prime: a leaf gets one of its own, a product the product of the tags (so that neither order nor grouping of the
factors matters), any other operation a hash of the operation and the tags. Equal tags are taken for equal structure only where the values agree too, so a
collision can never make a sum wrong.
"""

from __future__ import annotations

from itertools import count

PRIME = (1 << 61) - 1
_leaves = count(1)

SUM, DIFFERENCE, DERIVATIVE = 1, 2, 3


def leaf() -> int:
    """The tag of an operand that comes from outside."""
    return hash((0, next(_leaves))) % PRIME


def product(a: int, b: int) -> int:
    """The tag of a product.

    >>> product(product(3, 5), 7) == product(7, product(5, 3))
    True
    """
    return a * b % PRIME


def total(operation: int, a: int, b: int) -> int:
    """The tag of a sum, a difference, or (with the order as `b`) a derivative."""
    return hash((operation, a, b)) % PRIME


def scaled(a: int, constant: object) -> int:
    """The tag of a multiple."""
    return a * hash(constant) % PRIME
