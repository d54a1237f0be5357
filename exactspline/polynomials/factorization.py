"""Products of powers, for polynomials of any type."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Generic, Protocol, Self, TypeVar

from exactspline.one_line import OneLine


class _Multiplicative(Protocol):
    """Objects with products and powers."""

    def __mul__(self, other: Self, /) -> Self: ...
    def __pow__(self, exponent: int, /) -> Self: ...


_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

P = TypeVar("P")
Q = TypeVar("Q")
M = TypeVar("M", bound=_Multiplicative)
#: Polynomials that are divided with a remainder.
D = TypeVar("D", bound=Any)


def superscript(number: int) -> str:
    """A number as an exponent.

    >>> superscript(-12)
    '⁻¹²'
    """
    return str(number).translate(_SUPERSCRIPTS)


def power_text(base: str, exponent: int) -> str:
    """A power in mathematical notation.

    >>> power_text("w", 8), power_text("‖D1‖²", 3), power_text("w", 1)
    ('w⁸', '(‖D1‖²)³', 'w')
    """
    if exponent == 1:
        return base
    inner = f"({base})" if base[-1] in superscript(1234567890) else base
    return inner + superscript(exponent)


@dataclass(frozen=True, repr=False)
class Factorization(OneLine, Generic[P]):
    """``Π baseᵉ`` with distinct bases and non-zero exponents; bases with negative exponents are in the denominator.

    A constant factor, if any, is stored separately. Bases are compared, never hashed (FLINT's polynomials are not
    hashable).

    >>> a, b = Factorization([("x", 2), ("y", 1)]), Factorization([("y", 2), ("z", 1)])
    >>> print(a * b, a.shared(b), a.without(a.shared(b)))
    x² y³ z y x²
    """

    powers: tuple[tuple[P, int], ...] = ()

    def __init__(self, powers: Iterable[tuple[P, int]] = ()) -> None:
        object.__setattr__(self, "powers", tuple((base, e) for base, e in powers if e))

    def __iter__(self) -> Iterator[tuple[P, int]]:
        return iter(self.powers)

    def __len__(self) -> int:
        return len(self.powers)

    def __str__(self) -> str:
        return " ".join(power_text(str(base), e) for base, e in self.powers) or "1"

    def exponent(self, base: P) -> int:
        """The exponent of a base, 0 if it does not occur."""
        return next((e for other, e in self.powers if other == base), 0)

    def __mul__(self, other: Factorization[P]) -> Factorization[P]:
        merged = list(self.powers)
        for base, e in other.powers:
            i = next((i for i, (mine, _) in enumerate(merged) if mine == base), None)
            if i is None:
                merged.append((base, e))
            else:
                merged[i] = (base, merged[i][1] + e)
        return Factorization(merged)

    def __pow__(self, exponent: int) -> Factorization[P]:
        return Factorization((base, e * exponent) for base, e in self.powers)

    def shared(self, other: Factorization[P]) -> Factorization[P]:
        """The common part: each base with the smaller of its two exponents, which is 0 if it does not occur.

        >>> print(Factorization([("x", 2), ("y", -1)]).shared(Factorization([("x", 1)])))
        x y⁻¹
        """
        mine = [(base, min(e, other.exponent(base))) for base, e in self.powers]
        return Factorization([*mine, *[(base, min(e, 0)) for base, e in other.powers if not self.exponent(base)]])

    def without(self, part: Factorization[P]) -> Factorization[P]:
        """The quotient by another factorization."""
        return self * part**-1

    def mapped(self, function: Callable[[P], Q]) -> Factorization[Q]:
        """The factorization with every base replaced by its image under a function."""
        return Factorization((function(base), e) for base, e in self.powers)

    @property
    def above(self) -> Factorization[P]:
        """The part with positive exponents."""
        return Factorization((base, e) for base, e in self.powers if e > 0)

    @property
    def below(self) -> Factorization[P]:
        """The part with negative exponents."""
        return Factorization((base, e) for base, e in self.powers if e < 0)


def multiplied(factorization: Factorization[M], one: M) -> M:
    """The expanded product; no exponent may be negative.

    >>> multiplied(Factorization([(2, 3), (5, 1)]), 1)
    40
    """
    result = one
    for base, e in factorization:
        result = result * base**e
    return result


def divided_out(p: D, factor: D) -> D:
    """A polynomial divided by a factor, not a constant, as often as this divides it; 0 for 0.

    >>> from flint import fmpz_poly
    >>> divided_out(fmpz_poly([0, 0, 1, 1]), fmpz_poly([0, 1]))
    x + 1
    """
    while p:
        quotient, rest = divmod(p, factor)
        if rest:
            break
        p = quotient
    return p
