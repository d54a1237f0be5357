"""Real numbers known only by enclosures in FLINT's balls: angles, arc lengths."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from flint import arb, ctx, fmpz_poly

from exactspline.errors import OpenError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.numbers.once import fill
from exactspline.reals.algebraic import OPEN, Algebraic
from exactspline.reals.real import UNASKED, RationalNumber, Real


class InBalls(Real):
    """A number enclosed by ``ball(bits)``, a ball that shrinks as FLINT's precision increases. Questions that
    enclosures do not decide are passed to ``exactly()``, the same number as an algebraic number; without this function,
    comparisons raise `OpenError` if they need too many digits. Both ``ball`` and ``exactly`` are named functions, so
    that the number can be pickled.
    """

    __slots__ = ("ball", "exactly", "transcendental")
    ball: Callable[[int], arb]
    exactly: Callable[[], Real] | None
    #: Whether the number is proved to be transcendental.
    transcendental: bool

    def __init__(
        self, ball: Callable[[int], arb], exactly: Callable[[], Real] | None = None, *, transcendental: bool = False
    ) -> None:
        fill(self, ball=ball, exactly=exactly, transcendental=transcendental, **UNASKED)

    def __reduce__(self) -> tuple[object, ...]:
        return partial(InBalls, transcendental=self.transcendental), (self.ball, self.exactly)

    def _enclosed(self, digits: int) -> Interval:
        bits, width = 10 * digits // 3 + 40, mpq(1, 10**digits)
        while self.exactly is not None or (digits <= OPEN and bits < 8 * OPEN):
            with ctx.workprec(bits):
                ball = self.ball(bits)
            if ball.is_finite() and (ends := ball_ends(ball)).width <= width:
                return ends
            # the missing bits: large numbers need many bits before the point
            bits += int(ends.width / width).bit_length() + 10 if ball.is_finite() else bits
        raise OpenError(f"undecided at {digits} digits", remedy="use an enclosure")

    def _found(self) -> Real | None:
        if self.exactly is not None:
            return self.exactly().in_closed_form()
        return None if self.transcendental else super()._found()

    def _height(self) -> int:
        return self._annihilator().height_bits() if self.exactly is None else self.exactly()._height()

    def _annihilator(self) -> fmpz_poly:
        if self.exactly is None:
            raise OpenError("this number is not known to be algebraic", remedy="use an enclosure (`enclosure`)")
        return self.exactly()._annihilator()

    def _decided(self) -> mpq | None:
        return super()._decided() if self.exactly is None else self.exactly().exact


class WithAngles(InBalls):
    """``a + b π + Σ cᵢ arctan tᵢ`` with rational and quadratic numbers, proved to be transcendental. Two such numbers
    without arctangents are equal if and only if a and b are: π is transcendental.
    """

    __slots__ = ("arcs", "constant", "of_pi")
    constant: Real
    of_pi: Real
    arcs: tuple[tuple[Real, Real], ...]

    def __init__(
        self, ball: Callable[[int], arb], constant: Real, of_pi: Real, arcs: tuple[tuple[Real, Real], ...]
    ) -> None:
        super().__init__(ball, transcendental=True)
        fill(self, constant=constant, of_pi=of_pi, arcs=arcs)

    def __reduce__(self) -> tuple[object, ...]:
        return WithAngles, (self.ball, self.constant, self.of_pi, self.arcs)

    @property
    def closed_form(self) -> str:
        """``a + bπ + c arctan(t)``, without terms that are 0."""
        parts = [self.constant.closed_form or ""] if self.constant else []
        parts += [_multiple(self.of_pi, "π")] if self.of_pi else []
        parts += [_multiple(factor, f" arctan({tangent.closed_form})") for factor, tangent in self.arcs]
        return " + ".join(parts).replace("+ -", "- ")

    def _sympy_(self) -> Any:
        """The number as a sympy expression.

        >>> import sympy
        >>> from exactspline import example
        >>> sympy.sympify(example("circle").area), sympy.sympify(example("circle").length_between((0, "1/2")))
        (pi, 2*atan(1/2))
        """
        import sympy

        pairs = [(self.constant, 1), (self.of_pi, sympy.pi), *((f, sympy.atan(sympy.sympify(t))) for f, t in self.arcs)]
        return sympy.Add(*(sympy.sympify(factor) * unit for factor, unit in pairs))

    def _equals(self, other: Algebraic | mpq) -> bool:
        if isinstance(other, WithAngles):
            same = self.constant == other.constant and self.of_pi == other.of_pi and self.arcs == other.arcs
            if same or not (self.arcs or other.arcs):
                return same
        return super()._equals(other)


def _multiple(factor: Real, unit: str) -> str:
    """A multiple of π or of an angle, as text.

    >>> _multiple(RationalNumber("-3/2"), "π"), _multiple(RationalNumber(1), " arctan(2)")
    ('-3π/2', 'arctan(2)')
    """
    if not isinstance(factor, RationalNumber):
        return f"({factor.closed_form}){unit}"
    top, bottom = factor.value.numerator, factor.value.denominator
    times = {1: "", -1: "-"}.get(int(top), str(top))
    return f"{times}{unit}".lstrip().replace("- ", "-") + (f"/{bottom}" if bottom > 1 else "")
