"""Real numbers known only by enclosures in FLINT's balls: angles, arc lengths."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from flint import arb, ctx, fmpz_poly

from exactspline.errors import OpenError
from exactspline.numbers.exact import mpq
from exactspline.numbers.immutable import fill
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.reals.algebraic import OPEN
from exactspline.reals.real import UNASKED, Real


class InBalls(Real):
    """A number enclosed by ``ball(bits)``, a ball that shrinks as FLINT's precision increases. What enclosures do not
    decide is asked of ``exactly()``, the same number as an algebraic one; without it, comparisons raise `OpenError` if
    they need too many digits. Both are named functions, so that the number can be pickled.
    """

    __slots__ = ("ball", "exactly", "transcendental")
    ball: Callable[[int], arb]
    exactly: Callable[[], Real] | None
    #: Whether the number is proved to be transcendental.
    transcendental: bool
    #: As for expressions: more digits cost less than a polynomial.
    _suspicious = 320

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
            bits *= 2
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
