"""The instructions of a straight-line program: operations on integer polynomials, each recorded once.

A polynomial is a form of a segment in the scaled Bernstein basis (see `exactspline.polynomials.bernstein`), so that the
product is a convolution and raising the degree is multiplication by ``u + v``. Every instruction is linear in each of
its arguments.
"""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

#: The constant polynomial 1 in place of an argument, and zero in place of an output.
UNIT, ZERO = -1, -2


class Instruction(NamedTuple):
    """One operation, its arguments (numbers of earlier instructions), and its integers.

    ======== ============ ===================================================
    load     (k)          operand k
    mul      a b          a·b
    sum      a b (m, n)   m·a + n·b
    raise    a (e)        a·(u + v)ᵉ
    derive   a (n)        (∂v − ∂u)a of degree n
    du, dv   a (n)        ∂u a, ∂v a of degree n
    over_u   a (n)        a/u of degree n, a multiple of u
    scale    a (m)        m·a
    lift     a (k)        a times the k-th multiplier of the segment
    spread   a (i)        a, of the i-th parameter alone, on every patch
    ======== ============ ===================================================

    Only products, sums and multiples of spread polynomials are formed.
    """

    name: str
    arguments: tuple[int, ...] = ()
    numbers: tuple[int, ...] = ()


class Instructions:
    """The instructions of a program under construction: an operation on the same arguments is recorded once.

    >>> code = Instructions()
    >>> x, y = code.load(0, 2), code.load(1, 2)
    >>> code.times(x, y) == code.times(y, x), code.degrees[code.times(x, y)], len(code.listed)
    (True, 4, 3)
    """

    def __init__(self) -> None:
        self.listed: list[Instruction] = []
        #: The formal degree of the result of each instruction.
        self.degrees: list[int] = []
        self._known: dict[Instruction, int] = {}
        #: The factors of products, nested products flattened.
        self._factors: dict[int, Counter[int]] = {}

    def _put(self, instruction: Instruction, degree: int) -> int:
        if instruction not in self._known:
            self._known[instruction] = len(self.listed)
            self.listed.append(instruction)
            self.degrees.append(degree)
        return self._known[instruction]

    def degree(self, a: int) -> int:
        """The formal degree of an argument."""
        return 0 if a == UNIT else self.degrees[a]

    def load(self, k: int, degree: int) -> int:
        """An operand."""
        return self._put(Instruction("load", (), (k,)), degree)

    def times(self, a: int, b: int) -> int:
        """The product."""
        if UNIT in (a, b):
            return max(a, b)
        made = self._put(Instruction("mul", (min(a, b), max(a, b))), self.degrees[a] + self.degrees[b])
        self._factors[made] = self._taken_apart(a) + self._taken_apart(b)
        return made

    def _taken_apart(self, a: int) -> Counter[int]:
        return self._factors.get(a, Counter([a]))

    def same(self, a: int, b: int) -> bool:
        """Whether two arguments are products of the same factors.

        >>> code = Instructions()
        >>> x, y, z = (code.load(k, 1) for k in range(3))
        >>> code.same(code.times(code.times(x, y), z), code.times(x, code.times(z, y)))
        True
        """
        return a == b or self._taken_apart(a) == self._taken_apart(b)

    def _product(self, factors: Counter[int]) -> int:
        made = UNIT
        for a in sorted(factors.elements()):
            made = self.times(made, a)
        return made

    def sum(self, a: int, m: int, b: int, n: int) -> int:
        """``m a + n b`` of two different arguments of the same degree, a common factor factored out."""
        common = self._taken_apart(a) & self._taken_apart(b)
        if common:
            first, second = (self._product(self._taken_apart(x) - common) for x in (a, b))
            return self.times(self.sum(first, m, second, n), self._product(common))
        if a > b:
            a, m, b, n = b, n, a, m
        return self._put(Instruction("sum", (a, b), (m, n)), self.degree(a))

    def raised(self, a: int, e: int) -> int:
        """The argument with the degree raised."""
        return a if e == 0 else self._put(Instruction("raise", (a,), (e,)), self.degree(a) + e)

    def derived(self, name: str, a: int) -> int:
        """A derivative or the quotient by u, given by its name, of an argument of positive degree."""
        n = self.degree(a)
        return self._put(Instruction(name, (a,), (n,)), n - 1)

    def scaled(self, a: int, m: int) -> int:
        """A multiple."""
        return a if m == 1 else self._put(Instruction("scale", (a,), (m,)), self.degree(a))

    def spread(self, a: int, parameter: int) -> int:
        """A polynomial in one parameter, on every patch."""
        return self._put(Instruction("spread", (a,), (parameter,)), 0)

    def lifted(self, a: int, k: int) -> int:
        """The argument times a multiplier of the segment."""
        return self._put(Instruction("lift", (a,), (k,)), self.degree(a))
