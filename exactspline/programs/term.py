"""The operand of the program reading: results of operations are recorded, with their degrees and denominators."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd
from operator import add
from typing import Any, Self

from exactspline.errors import FormulaError
from exactspline.language.operand import CONSTANTS, Constant
from exactspline.language.provenance import DERIVATIVE, DIFFERENCE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, same
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import mpq, rational
from exactspline.programs.denominators import ONE, Denominator, OfOperand, WidthNumerator
from exactspline.programs.instructions import UNIT as ONE_POLYNOMIAL
from exactspline.programs.instructions import ZERO, Instructions, Multiplier
from exactspline.splines.knots import SMOOTH

#: The order of the derivative of each operand (−1: none), constants last.
Orders = tuple[int, ...]


class Recorder:
    """The record of a formula being traced: instructions, and multipliers that depend on the segments.

    `parameters` gives for every operand the parameter on which it depends.
    """

    def __init__(self, parameters: Sequence[str], *, unit_widths: bool) -> None:
        self.parameters = tuple(parameters)
        #: All parameters, in order.
        self.all = tuple(dict.fromkeys(parameters))
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

    `degrees` has one number per parameter. A term in one parameter only is computed segment by segment, and `axis` is
    its index, 0 for a constant; a term in several is ``number · node / below`` on every patch, and `axis` is None.

    `orders` are, operand by operand, the orders of the derivatives it was made from (−1: none), the constants last:
    continuity drops by them.

    Raises `FormulaError` for operations not supported on patches: sums of unequal degrees or denominators, derivatives.
    """

    __slots__ = ("axis", "below", "degrees", "node", "number", "orders", "provenance", "raised", "recorder", "widths")

    def __init__(
        self,
        recorder: Recorder,
        node: int,
        degrees: tuple[int, ...],
        orders: Orders,
        below: Denominator,
        provenance: Provenance,
        axis: int | None = 0,
        number: int = 1,
        widths: int = 0,
        raised: int = 0,
    ) -> None:
        self.recorder, self.node, self.degrees, self.orders, self.below = recorder, node, degrees, orders, below
        self.provenance, self.axis, self.number, self.widths = provenance, axis, number, widths
        self.raised = raised

    @classmethod
    def operand(cls, recorder: Recorder, k: int, degree: int, group: int, provenance: Provenance) -> Self:
        """The k-th operand, with the denominators of a group of them."""
        orders = tuple(0 if i == k else -1 for i in range(len(recorder.parameters) + 1))
        axis = recorder.all.index(recorder.parameters[k])
        degrees = tuple(degree if i == axis else 0 for i in range(len(recorder.all)))
        below = Denominator.of(OfOperand(group))
        node = recorder.instructions.load(k, degree) if degree >= 0 else ZERO
        return cls(recorder, node, degrees, orders, below, provenance, axis)

    def constant(self, value: Constant) -> Self:
        """An exact constant."""
        q = rational(value)
        orders = (*[-1] * (len(self.orders) - 1), 0)
        number, below = int(q.numerator), Denominator(int(q.denominator))
        node, degrees = ONE_POLYNOMIAL if number else ZERO, (0,) * len(self.degrees)
        return type(self)(self.recorder, node, degrees, orders, below, (MULTIPLE, UNIT, q), number=number)

    @property
    def degree(self) -> int:
        """The degree in the one parameter on which it depends.

        Raises `FormulaError` if there are several parameters.
        """
        return self.degrees[self._only()]

    def _only(self) -> int:
        if self.axis is None:
            raise _outside("a degree or a derivative of a term in several parameters")
        return self.axis

    @property
    def is_number(self) -> bool:
        """Whether the term is a constant."""
        return max(self.orders[:-1]) < 0 and not any(self.degrees)

    @property
    def value(self) -> mpq:
        """The number of a constant term."""
        return mpq(0 if self.node == ZERO else self.number, self.below.constant)

    @property
    def is_zero(self) -> bool:
        """Whether the term vanishes on every curve of the kind. Raises `FormulaError` for a term of which this cannot
        be known in advance.
        """
        if self.node == ZERO:
            return True
        raise FormulaError("whether a term of a program vanishes", remedy="run the program and test its result")

    def __eq__(self, other: object) -> bool:
        """Whether two terms were computed in the same way."""
        return isinstance(other, Term) and same(self.provenance, other.provenance)

    def __hash__(self) -> int:
        return hash((self.node, self.degrees))

    def _with(self, **changed: Any) -> Self:
        fields = {name: getattr(self, name) for name in Term.__slots__} | changed
        return type(self)(**fields)

    def _of_degree(self, degree: int) -> tuple[int, ...]:
        """The degrees, with another degree in the only parameter."""
        only = self._only()
        return tuple(degree if i == only else n for i, n in enumerate(self.degrees))

    def _common_axis(self, other: Term) -> int | None:
        """The one parameter on which two terms depend; None if they depend on several."""
        if self.axis == other.axis or other.is_number:
            return self.axis
        return other.axis if self.is_number else None

    # ---- sums

    def __add__(self, other: object) -> Self:
        right = self.coerced(other)
        return NotImplemented if right is None else self._sum(right, 1, SUM)

    def __sub__(self, other: object) -> Self:
        right = self.coerced(other)
        return NotImplemented if right is None else self._sum(right, -1, DIFFERENCE)

    def _sum(self, other: Self, sign: int, name: int) -> Self:
        axis = self._common_axis(other)
        below = self.below.common(other.below)
        degrees = tuple(map(max, self.degrees, other.degrees))
        a, b = self._over(below, degrees, axis), other._over(below, degrees, axis)._with_number(sign)
        known = {
            "orders": tuple(map(max, self.orders, other.orders)),
            "provenance": (name, self.provenance, other.provenance),
        }
        if ZERO in (a.node, b.node):
            return (b if a.node == ZERO else a)._with(**known)
        raised, widths = min(a.raised, b.raised), min(a.widths, b.widths)
        first, second = a._down_to(raised, widths), b._down_to(raised, widths)
        parts = (first.node, first.number), (second.node, second.number)
        node, number = _multiple_of_sum(self.recorder.instructions, *parts)
        return first._with(node=node, number=number, **known)

    def _with_number(self, factor: int) -> Self:
        return self if factor == 1 else self._with(number=self.number * factor)

    def _over(self, below: Denominator, degrees: tuple[int, ...], axis: int | None) -> Self:
        """The same term over a multiple of the denominator, of degrees at least as high, in one parameter or on
        patches.
        """
        if axis is None:
            return self._on_patches_over(below, degrees)
        if axis == self.axis and degrees == self.degrees and below is self.below:
            return self
        known: dict[str, Any] = {"below": below, "degrees": degrees, "axis": axis}
        if self.node == ZERO:
            return self._with(raised=0, **known)
        node, number = self.node, self.number
        if below.powers == self.below.powers:
            number *= below.constant // self.below.constant
        else:
            node = self.recorder.instructions.lifted(node, self.recorder.multiplier((below, self.below)))
        raised = self.raised + degrees[axis] - self.degrees[axis]
        return self._with(node=node, number=number, raised=raised, **known)

    def _on_patches_over(self, below: Denominator, degrees: tuple[int, ...]) -> Self:
        if self.degrees != degrees or self.below.powers != below.powers:
            raise _outside("a sum of unequal degrees or denominators on patches")
        return self._on_patches()._with(number=self.number * (below.constant // self.below.constant), below=below)

    def _down_to(self, raised: int, widths: int) -> Self:
        """The same term with these powers of ``u + v`` and of the denominator of the width kept apart, and all other
        powers multiplied in.
        """
        if (self.raised, self.widths) == (raised, widths):
            return self
        code = self.recorder.instructions
        node = code.raised(self.node, self.raised - raised)
        if self.widths > widths:
            node = code.lifted(node, self.recorder.multiplier(self.widths - widths))
        return self._with(node=node, raised=raised, widths=widths)

    def _on_patches(self) -> Self:
        """The term as one that is computed on every patch."""
        if self.axis is None:
            return self
        if self.node == ZERO:
            return self._with(axis=None, raised=0, widths=0)
        known = self._down_to(0, 0)
        node = known.node if self.is_number else self.recorder.instructions.spread(known.node, self.axis)
        return known._with(node=node, axis=None)

    # ---- products

    def __mul__(self, other: object) -> Self:
        if isinstance(other, CONSTANTS):
            return self.scaled(other)
        if not isinstance(other, Term):
            return NotImplemented
        axis = self._common_axis(other)
        a, b = (self, other) if axis is not None else (self._on_patches(), other._on_patches())
        nothing = ZERO in (a.node, b.node)
        return type(self)(
            self.recorder,
            ZERO if nothing else self.recorder.instructions.times(a.node, b.node),
            tuple(map(add, a.degrees, b.degrees)),
            tuple(map(max, a.orders, b.orders)),
            a.below * b.below,
            (PRODUCT, a.provenance, b.provenance),
            axis,
            a.number * b.number,
            a.widths + b.widths,
            a.raised + b.raised,
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
        """The derivative of an order, with respect to the only parameter."""
        if by is not None and by != self.recorder.all[self._only()]:
            raise FormulaError(
                f"a derivative with respect to {by!r} in a program", remedy="name the parameter on which it depends"
            )
        result = self
        for _ in range(order):
            result = result._derived()
        return result

    def _derived(self) -> Self:
        known: dict[str, Any] = {
            "degrees": self._of_degree(self.degree - 1),
            "orders": tuple(k + 1 if k >= 0 else k for k in self.orders),
            "provenance": (DERIVATIVE, self.provenance),
        }
        if self.degree <= 0:
            return self._with(node=ZERO, raised=0, widths=0, below=ONE, number=1, **known)
        node, raised = ZERO, 0
        if self.node != ZERO and self.degree > self.raised:
            node, raised = self.recorder.instructions.derived("derive", self.node), self.raised
        unit = self.recorder.unit_widths
        below = self.below if unit else self.below * Denominator.of(WidthNumerator())
        return self._with(node=node, raised=raised, below=below, widths=self.widths + (not unit), **known)

    def elevated_to(self, other: Term) -> Self:
        """The same term, with degrees at least as high as those of another term."""
        degrees = tuple(map(max, self.degrees, other.degrees))
        if self.degrees == degrees:
            return self
        only = self._only()
        if degrees != self._of_degree(degrees[only]):
            raise _outside("a higher degree in another parameter")
        return self._over(self.below, degrees, only)

    def partials(self, degree: int, order: int) -> list[Self]:
        """``∂u^(order−i) ∂vⁱ`` for i = 0 … order, of the term as a form of at least its degree."""
        level = [self._over(self.below, self._of_degree(degree), self._only())]
        for _ in range(order):
            level = [level[0]._partial("du"), *[term._partial("dv") for term in level]]
        return level

    def _partial(self, name: str) -> Self:
        """The derivative by u or v, or the quotient by u; `name` is that of the instruction."""
        term = self if self.node == ZERO else self._down_to(0, self.widths)
        node = ZERO if term.node == ZERO else term.recorder.instructions.derived(name, term.node)
        return term._with(node=node, degrees=self._of_degree(self.degree - 1))

    def by_v(self) -> Self:
        """``∂v``: a part of the derivative of the function."""
        return self._partial("dv")

    def over_u(self) -> Self:
        """The term divided by u, if the form is a multiple of u: the same integers, of a degree one lower."""
        return self._partial("over_u")

    def per_width(self, weight: int, dropped: int) -> Self:
        """The term over a power of the segment's width, its continuity lowered by `dropped`."""
        orders = tuple(k + dropped if k >= 0 else k for k in self.orders)
        if self.recorder.unit_widths:
            return self._with(orders=orders)
        below = self.below * Denominator(1, ((WidthNumerator(), weight),))
        return self._with(below=below, widths=self.widths + weight, orders=orders)

    def over(self, below: Denominator) -> Self:
        """The term over one more denominator."""
        return self._with(below=self.below * below)

    # ---- output

    def output(self) -> int:
        """The instruction that makes the polynomial over `below`."""
        if self.axis is not None and len(self.degrees) > 1:
            raise _outside("a value on patches in one parameter only")
        if self.node == ZERO:
            return ZERO
        return self.recorder.instructions.scaled(self._down_to(0, 0).node, self.number)

    def continuity_of(self, operands: Sequence[tuple[int, ...]], inner: int, axis: int = 0) -> tuple[int, ...]:
        """The continuity at the inner breakpoints of a parameter, computed from that of all operands."""
        found, name = (SMOOTH,) * inner, self.recorder.all[axis]
        for continuity, order, own in zip(operands, self.orders, self.recorder.parameters, strict=False):
            if order >= 0 and own == name:
                found = tuple([min(most, max(c - order, -1)) for most, c in zip(found, continuity, strict=True)])
        return found


def _outside(what: str) -> FormulaError:
    return FormulaError(what, remedy="read the formula as splines")


def _multiple_of_sum(code: Instructions, first: tuple[int, int], second: tuple[int, int]) -> tuple[int, int]:
    """A sum of multiples of the results of two instructions, as a multiple of one result; a zero among them
    is skipped.
    """
    (a, m), (b, n) = first, second
    if ZERO in (a, b):
        return second if a == ZERO else first
    if code.same(a, b):
        return (a, m + n) if m + n else (ZERO, 1)
    if a > b:
        a, m, b, n = b, n, a, m
    common = gcd(m, n) * (1 if m > 0 else -1)
    return code.sum(a, m // common, b, n // common), common
