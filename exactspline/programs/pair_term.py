"""The operand of the program reading on two curves: what depends on one of them is a term of its own program, what
depends on both is computed patch by patch, the second parameter a power of the first.
"""

from __future__ import annotations

from typing import Any

from exactspline.errors import FormulaError
from exactspline.language.operand import CONSTANTS, Constant
from exactspline.language.provenance import DIFFERENCE, MULTIPLE, PRODUCT, SUM, Provenance, same
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import mpq, rational
from exactspline.programs.denominators import Denominator
from exactspline.programs.instructions import ZERO, Instructions
from exactspline.programs.term import Orders, Term, multiple_of_sum
from exactspline.splines.tensor import DIRECTION
from exactspline.splines.tensor_parts import Degrees


class Patches:
    """What is written down for every patch: instructions, and what they load from the programs of the curves."""

    def __init__(self) -> None:
        self.instructions = Instructions()
        #: Which curve, and the instruction of its program.
        self.loads: list[tuple[int, int]] = []

    def load(self, which: int, node: int) -> int:
        """What an instruction of a curve's program makes, on a patch."""
        if (which, node) not in self.loads:
            self.loads.append((which, node))
        return self.instructions.load(self.loads.index((which, node)), 0)


class PairTerm(RingOperand):
    """``number · node / below`` on every patch; `own` where it depends on one curve only: which, and its term.

    `orders` are those of a `Term`, of the operands of either curve.

    Raises `FormulaError` for what is not computed in programs: sums of unequal degrees, derivatives of what depends on
    both.
    """

    __slots__ = ("below", "degree", "node", "number", "orders", "own", "patches", "provenance")

    def __init__(
        self,
        patches: Patches,
        own: tuple[int, Term] | None,
        node: int,
        number: int,
        degree: Degrees,
        orders: tuple[Orders, Orders],
        below: Denominator,
        provenance: Provenance,
    ) -> None:
        self.patches, self.own, self.node, self.number, self.degree = patches, own, node, number, degree
        self.orders, self.below, self.provenance = orders, below, provenance

    @classmethod
    def of(cls, patches: Patches, which: int, term: Term) -> PairTerm:
        """What depends on one curve only."""
        degree = Degrees(0, term.degree) if which else Degrees(term.degree, 0)
        constant = (*[-1] * (len(term.orders) - 1), 0)
        orders = (constant, term.orders) if which else (term.orders, constant)
        return cls(patches, (which, term), ZERO, 1, degree, orders, term.below, term.provenance)

    def constant(self, value: Constant) -> PairTerm:
        """An exact constant, told of the first curve."""
        some = self.own[1] if self.own else self._outside("a constant beside what depends on both curves")
        return PairTerm.of(self.patches, self.own[0] if self.own else 0, some.constant(value))

    @staticmethod
    def _outside(what: str) -> Any:
        raise FormulaError(what, remedy="read it as splines")

    def _on_patches(self) -> PairTerm:
        """As something that is computed on every patch."""
        if self.own is None:
            return self
        which, term = self.own
        node = ZERO if term.node == ZERO else self.patches.load(which, term._with(number=1).output())
        fields = self.degree, self.orders, term.below, self.provenance
        return PairTerm(self.patches, None, node, term.number, *fields)

    def _beside(self, other: PairTerm) -> tuple[int, Term, Term] | None:
        """Both as terms of one curve, where they are; a constant is one of either."""
        if self.own is None or other.own is None:
            return None
        (i, a), (j, b) = self.own, other.own
        if i == j:
            return i, a, b
        if a.is_number:
            return j, b.constant(a.value), b
        return (i, a, a.constant(b.value)) if b.is_number else None

    @property
    def is_zero(self) -> bool:
        """Whether it vanishes on every pair of curves; others may, which nobody knows beforehand.

        Raises `FormulaError` for these.
        """
        if (self.own[1].node if self.own else self.node) == ZERO:
            return True
        raise FormulaError("whether a term of a program vanishes", remedy="run the program and ask what it returns")

    def __eq__(self, other: object) -> bool:
        """Whether both were made in the same way."""
        return isinstance(other, PairTerm) and same(self.provenance, other.provenance)

    def __hash__(self) -> int:
        return hash((self.node, self.degree))

    def __add__(self, other: object) -> PairTerm:
        right = self.beside(other)
        return NotImplemented if right is None else self._sum(right, 1, SUM)

    def __sub__(self, other: object) -> PairTerm:
        right = self.beside(other)
        return NotImplemented if right is None else self._sum(right, -1, DIFFERENCE)

    def _sum(self, other: PairTerm, sign: int, name: int) -> PairTerm:
        if (alone := self._beside(other)) is not None:
            which, first, second = alone
            return PairTerm.of(self.patches, which, first + second if sign > 0 else first - second)
        a, b = self._on_patches(), other._on_patches()
        below = a.below.common(b.below)
        if a.degree != b.degree or {a.below.powers, b.below.powers} != {below.powers}:
            self._outside("a sum of unequal degrees or denominators")
        m, n = (x.number * (below.constant // x.below.constant) for x in (a, b))
        node, number = multiple_of_sum(self.patches.instructions, (a.node, m), (b.node, n * sign))
        provenance = name, self.provenance, other.provenance
        return PairTerm(self.patches, None, node, number, a.degree, _merged(a, b), below, provenance)

    def __mul__(self, other: object) -> PairTerm:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if not isinstance(other, PairTerm):
            return NotImplemented
        if (alone := self._beside(other)) is not None:
            which, first, second = alone
            return PairTerm.of(self.patches, which, first * second)
        a, b = self._on_patches(), other._on_patches()
        nothing = ZERO in (a.node, b.node)
        node = ZERO if nothing else self.patches.instructions.times(a.node, b.node)
        degree = Degrees(a.degree.s + b.degree.s, a.degree.t + b.degree.t)
        provenance = PRODUCT, self.provenance, other.provenance
        below, number = a.below * b.below, a.number * b.number
        return PairTerm(self.patches, None, node, number, degree, _merged(a, b), below, provenance)

    def scaled(self, constant: Constant) -> PairTerm:
        """The term times an exact constant."""
        if self.own is not None:
            return PairTerm.of(self.patches, self.own[0], self.own[1].scaled(constant))
        q = rational(constant)
        number = self.number * int(q.numerator)
        below, node = self.below * Denominator(int(q.denominator)), self.node if number else ZERO
        provenance = MULTIPLE, self.provenance, constant if type(constant) is int else mpq(q)
        return PairTerm(self.patches, None, node, number or 1, self.degree, self.orders, below, provenance)

    def d(self, order: int = 1, *, by: str | None = None) -> PairTerm:
        """The derivative of an order of what depends on one curve only, by its parameter."""
        directions: dict[str, int] = {str(name): which for name, which in DIRECTION.items()}
        if self.own is None or (by is not None and directions.get(by) != self.own[0]):
            self._outside("a derivative of what depends on both curves, or by the parameter of the other")
        assert self.own is not None
        return PairTerm.of(self.patches, self.own[0], self.own[1].d(order))

    def elevated_to(self, other: PairTerm) -> PairTerm:
        """The same term, of which the degree is that of another already."""
        if self.degree.max(other.degree) != self.degree:
            self._outside("a higher degree")
        return self

    def output(self) -> int:
        """The instruction that makes the polynomial over `below`."""
        if self.own is not None:
            self._outside("a value that depends on one curve only")
        return ZERO if self.node == ZERO else self.patches.instructions.scaled(self.node, self.number)


def _merged(a: PairTerm, b: PairTerm) -> tuple[Orders, Orders]:
    first, second = (tuple(map(max, x, y)) for x, y in zip(a.orders, b.orders, strict=True))
    return first, second
