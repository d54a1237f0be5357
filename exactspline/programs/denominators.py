"""Denominators of a straight-line program, known in advance except for the numbers of each segment.

A denominator is a positive integer constant times powers of *atoms*: the denominator of an operand, the numerator of
the segment's width, and the part of a least common multiple that depends on these numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import gcd, lcm
from typing import NamedTuple


class OfOperand(NamedTuple):
    """The denominator of an operand: the same number for all operands of a group."""

    group: int


class WidthNumerator(NamedTuple):
    """The numerator of the width of the segment."""


@dataclass(frozen=True)
class _CommonMultiple:
    """The least common multiple of two denominators that have no atom in common."""

    first: Denominator
    second: Denominator


Atom = OfOperand | WidthNumerator | _CommonMultiple


@dataclass(frozen=True)
class Denominator:
    """``constant · Π atomᵉ``.

    >>> m, h = Denominator.of(OfOperand(0)), Denominator.of(WidthNumerator())
    >>> (m * h).common(m * m * h) == m * m * h, m.common(h).constant
    (True, 1)
    """

    constant: int
    powers: tuple[tuple[Atom, int], ...] = ()

    @classmethod
    def of(cls, atom: Atom) -> Denominator:
        """The denominator that consists of one atom."""
        return cls(1, ((atom, 1),))

    def __mul__(self, other: Denominator) -> Denominator:
        powers = dict(self.powers)
        for atom, e in other.powers:
            powers[atom] = powers.get(atom, 0) + e
        return Denominator(self.constant * other.constant, _in_order(powers))

    def common(self, other: Denominator) -> Denominator:
        """The least common multiple."""
        if self == other:
            return self
        mine, its = dict(self.powers), dict(other.powers)
        shared = {atom: min(e, its[atom]) for atom, e in mine.items() if atom in its}
        content = gcd(self.constant, other.constant)
        first, second = self._without(shared, content), other._without(shared, content)
        if not first.powers and not second.powers:
            return Denominator(lcm(self.constant, other.constant), self.powers)
        if first == ONE:
            return other
        if second == ONE:
            return self
        return Denominator(content, _in_order(shared)) * Denominator.of(_CommonMultiple(first, second))

    def _without(self, powers: dict[Atom, int], constant: int) -> Denominator:
        left = {atom: e - powers.get(atom, 0) for atom, e in self.powers}
        return Denominator(self.constant // constant, _in_order(left))

    @property
    def text(self) -> str:
        """The number on a segment as Python code, in terms of the names of the segment's numbers: ``below0``, … and
        ``top``, the numerator of its width.

        >>> (Denominator.of(OfOperand(0)) * Denominator.of(OfOperand(0)) * Denominator(6)).text
        'fmpz(6) * below0 * below0'
        """
        factors = [f"fmpz({self.constant})"] if self.constant != 1 or not self.powers else []
        for atom, e in self.powers:
            factors += [_text(atom)] * e if e < 4 else [f"{_text(atom)} ** {e}"]
        return " * ".join(factors)


ONE = Denominator(1)


def _in_order(powers: dict[Atom, int]) -> tuple[tuple[Atom, int], ...]:
    return tuple(sorted(((atom, e) for atom, e in powers.items() if e), key=repr))


def _text(atom: Atom) -> str:
    if isinstance(atom, OfOperand):
        return f"below{atom.group}"
    return "top" if isinstance(atom, WidthNumerator) else f"({atom.first.text}).lcm({atom.second.text})"
