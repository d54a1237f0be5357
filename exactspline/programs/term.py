"""The operand of the program reading: results of operations are recorded, with what is known of them in advance."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd
from typing import Any, Self

from exactspline.errors import FormulaError
from exactspline.language.operand import CONSTANTS, Constant
from exactspline.language.provenance import DERIVATIVE, DIFFERENCE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, same
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import mpq, rational
from exactspline.programs.compiled import Multiplier
from exactspline.programs.denominators import ONE, Denominator, OfOperand, WidthNumerator
from exactspline.programs.instructions import UNIT as ONE_POLYNOMIAL
from exactspline.programs.instructions import ZERO, Instructions
from exactspline.splines.knots import SMOOTH

#: Operand by operand the order of its derivative (−1: none), constants last.
Orders = tuple[int, ...]


class Recorder:
    """What is recorded while a formula is traced: instructions, and multipliers that depend on the segments."""

    def __init__(self, *, unit_widths: bool) -> None:
        self.instructions = Instructions()
        self.multipliers: list[Multiplier] = []
        self.unit_widths = unit_widths

    def multiplier(self, kind: Multiplier) -> int:
        """The number of a multiplier."""
        if kind not in self.multipliers:
            self.multipliers.append(kind)
        return self.multipliers.index(kind)


class Term(RingOperand):
    """``number · bᵏ (u + v)ᵉ · node / below``, with b the denominator of the segment's width.

    `orders` are, operand by operand, the orders of the derivatives it was made from (−1: none), the constants last:
    continuity drops by them.
    """

    __slots__ = ("below", "degree", "node", "number", "orders", "provenance", "raised", "recorder", "widths")

    def __init__(
        self,
        recorder: Recorder,
        node: int,
        degree: int,
        orders: tuple[int, ...],
        below: Denominator,
        provenance: Provenance,
        number: int = 1,
        widths: int = 0,
        raised: int = 0,
    ) -> None:
        self.recorder, self.node, self.degree, self.orders, self.below = recorder, node, degree, orders, below
        self.provenance, self.number, self.widths, self.raised = provenance, number, widths, raised

    @classmethod
    def operand(cls, recorder: Recorder, k: int, count: int, degree: int, group: int, provenance: Provenance) -> Self:
        """The k-th of this many operands, with the denominators of a group of them."""
        orders = tuple(0 if i == k else -1 for i in range(count + 1))
        below = Denominator.of(OfOperand(group))
        node = recorder.instructions.load(k, degree) if degree >= 0 else ZERO
        return cls(recorder, node, degree, orders, below, provenance)

    def constant(self, value: Constant) -> Self:
        """An exact constant."""
        q = rational(value)
        orders = (*[-1] * (len(self.orders) - 1), 0)
        number, below = int(q.numerator), Denominator(int(q.denominator))
        node = ONE_POLYNOMIAL if number else ZERO
        return type(self)(self.recorder, node, 0, orders, below, (MULTIPLE, UNIT, q), number)

    @property
    def is_number(self) -> bool:
        """Whether it is a constant."""
        return self.degree == 0 and max(self.orders[:-1]) < 0

    @property
    def value(self) -> mpq:
        """The number that a constant is."""
        return mpq(0 if self.node == ZERO else self.number, self.below.constant)

    @property
    def is_zero(self) -> bool:
        """Whether it vanishes on every curve of the kind; whether others vanish cannot be known in advance.

        Raises `FormulaError` for these.
        """
        if self.node == ZERO:
            return True
        raise FormulaError("whether a term of a program vanishes", remedy="run the program and ask what it returns")

    def __eq__(self, other: object) -> bool:
        """Whether both were made in the same way."""
        return isinstance(other, Term) and same(self.provenance, other.provenance)

    def __hash__(self) -> int:
        return hash((self.node, self.degree))

    def _with(self, **changed: Any) -> Self:
        fields = {name: getattr(self, name) for name in Term.__slots__} | changed
        return type(self)(**fields)

    # ---- sums

    def __add__(self, other: object) -> Self:
        right = self.beside(other)
        return NotImplemented if right is None else self._sum(right, 1, SUM)

    def __sub__(self, other: object) -> Self:
        right = self.beside(other)
        return NotImplemented if right is None else self._sum(right, -1, DIFFERENCE)

    def _sum(self, other: Self, sign: int, name: int) -> Self:
        degree, below = max(self.degree, other.degree), self.below.common(other.below)
        a, b = self._over(below, degree), other._over(below, degree)._with_number(sign)
        orders = tuple(map(max, self.orders, other.orders))
        provenance = (name, self.provenance, other.provenance)
        if ZERO in (a.node, b.node):
            return (b if a.node == ZERO else a)._with(orders=orders, provenance=provenance)
        raised, widths = min(a.raised, b.raised), min(a.widths, b.widths)
        first, second = a._down_to(raised, widths), b._down_to(raised, widths)
        parts = (first.node, first.number), (second.node, second.number)
        node, number = multiple_of_sum(self.recorder.instructions, *parts)
        return first._with(node=node, number=number, orders=orders, provenance=provenance)

    def _with_number(self, factor: int) -> Self:
        return self if factor == 1 else self._with(number=self.number * factor)

    def _over(self, below: Denominator, degree: int) -> Self:
        """Over a multiple of the denominator, of a degree at least as high."""
        if self.node == ZERO:
            return self._with(below=below, degree=degree, raised=0)
        node, number = self.node, self.number
        if below.powers == self.below.powers:
            number *= below.constant // self.below.constant
        else:
            node = self.recorder.instructions.lifted(node, self.recorder.multiplier((below, self.below)))
        raised = self.raised + degree - self.degree
        return self._with(node=node, number=number, below=below, degree=degree, raised=raised)

    def _down_to(self, raised: int, widths: int) -> Self:
        """With this many powers of ``u + v`` and of the width's denominator kept apart and the others multiplied in."""
        code = self.recorder.instructions
        node = code.raised(self.node, self.raised - raised)
        if self.widths > widths:
            node = code.lifted(node, self.recorder.multiplier(self.widths - widths))
        return self._with(node=node, raised=raised, widths=widths)

    # ---- products

    def __mul__(self, other: object) -> Self:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if not isinstance(other, Term):
            return NotImplemented
        nothing = ZERO in (self.node, other.node)
        return type(self)(
            self.recorder,
            ZERO if nothing else self.recorder.instructions.times(self.node, other.node),
            self.degree + other.degree,
            tuple(map(max, self.orders, other.orders)),
            self.below * other.below,
            (PRODUCT, self.provenance, other.provenance),
            self.number * other.number,
            self.widths + other.widths,
            self.raised + other.raised,
        )

    def scaled(self, constant: Constant) -> Self:
        """The term times an exact constant."""
        q = rational(constant)
        number = self.number * int(q.numerator)
        return self._with(
            node=self.node if number else ZERO,
            number=number or 1,
            below=self.below * Denominator(int(q.denominator)),
            provenance=(MULTIPLE, self.provenance, constant if type(constant) is int else q),
        )

    # ---- derivatives and degrees

    def d(self, order: int = 1, *, by: str | None = None) -> Self:
        """The derivative of an order."""
        self.only_parameter(by)
        result = self
        for _ in range(order):
            result = result._derived()
        return result

    def _derived(self) -> Self:
        orders = tuple(k + 1 if k >= 0 else k for k in self.orders)
        provenance = (DERIVATIVE, self.provenance)
        if self.degree <= 0:
            gone = self._with(node=ZERO, degree=self.degree - 1, raised=0, widths=0, below=ONE, number=1)
            return gone._with(orders=orders, provenance=provenance)
        node, raised = ZERO, 0
        if self.node != ZERO and self.degree > self.raised:
            node, raised = self.recorder.instructions.derived("derive", self.node), self.raised
        unit = self.recorder.unit_widths
        below = self.below if unit else self.below * Denominator.of(WidthNumerator())
        widths = self.widths + (not unit)
        derived = self._with(node=node, raised=raised, degree=self.degree - 1, below=below, widths=widths)
        return derived._with(orders=orders, provenance=provenance)

    def elevated_to(self, other: Term) -> Self:
        """The same term, at least of the degree of another."""
        if self.degree >= other.degree:
            return self
        raised = 0 if self.node == ZERO else self.raised + other.degree - self.degree
        return self._with(degree=other.degree, raised=raised)

    def partials(self, degree: int, order: int) -> list[Self]:
        """``∂u^(order−i) ∂vⁱ`` for i = 0 … order, of the term as a form of a degree at least its own."""
        level = [self._over(self.below, degree)]
        for _ in range(order):
            level = [level[0]._partial("du"), *[term._partial("dv") for term in level]]
        return level

    def _partial(self, name: str) -> Self:
        term = self if self.node == ZERO else self._down_to(0, self.widths)
        node = ZERO if term.node == ZERO else term.recorder.instructions.derived(name, term.node)
        return term._with(node=node, degree=self.degree - 1)

    def by_v(self) -> Self:
        """``∂v``: not the derivative of the function, but a part of it."""
        return self._partial("dv")

    def over_u(self) -> Self:
        """Divided by u, where the form is a multiple of it: the same integers, of a degree one lower."""
        term = self if self.node == ZERO else self._down_to(0, self.widths)
        node = ZERO if term.node == ZERO else term.recorder.instructions.derived("over_u", term.node)
        return term._with(node=node, degree=self.degree - 1)

    def per_width(self, weight: int, dropped: int) -> Self:
        """The term over this many powers of the segment's width, its continuity lowered by as many."""
        orders = tuple(k + dropped if k >= 0 else k for k in self.orders)
        if self.recorder.unit_widths:
            return self._with(orders=orders)
        below = self.below * Denominator(1, ((WidthNumerator(), weight),))
        return self._with(below=below, widths=self.widths + weight, orders=orders)

    def over(self, below: Denominator) -> Self:
        """The term over one more denominator."""
        return self._with(below=self.below * below)

    # ---- what comes out

    def output(self) -> int:
        """The instruction that makes the polynomial over `below`."""
        if self.node == ZERO:
            return ZERO
        code = self.recorder.instructions
        return code.scaled(self._down_to(0, 0).node, self.number)

    def continuity_of(self, operands: Sequence[tuple[int, ...]], inner: int) -> tuple[int, ...]:
        """The continuity at the inner breakpoints, from that of the operands."""
        return continuity_from(self.orders, operands, inner)


def continuity_from(orders: Orders, operands: Sequence[tuple[int, ...]], inner: int) -> tuple[int, ...]:
    """The continuity at this many inner breakpoints of what was made from derivatives of operands of these orders."""
    if not inner:
        return ()
    known = [*operands, (SMOOTH,) * inner]
    dropped = [[max(c - k, -1) for c in own] for own, k in zip(known, orders, strict=True) if k >= 0]
    return tuple(map(min, *dropped)) if len(dropped) > 1 else tuple(dropped[0])


def multiple_of_sum(code: Instructions, first: tuple[int, int], second: tuple[int, int]) -> tuple[int, int]:
    """A sum of multiples of what two instructions make, as a multiple of one; zero among them adds nothing."""
    (a, m), (b, n) = first, second
    if ZERO in (a, b):
        return second if a == ZERO else first
    if code.same(a, b):
        return (a, m + n) if m + n else (ZERO, 1)
    if a > b:
        a, m, b, n = b, n, a, m
    common = gcd(m, n) * (1 if m > 0 else -1)
    return code.sum(a, m // common, b, n // common), common
