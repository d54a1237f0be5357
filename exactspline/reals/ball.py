"""Real numbers known only by enclosures in FLINT's balls: angles, arc lengths."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, ctx, fmpz_poly

from exactspline.errors import OpenError
from exactspline.numbers.exact import mpq
from exactspline.numbers.immutable import fill
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.reals.algebraic import OPEN
from exactspline.reals.real import Real


class InBalls(Real):
    """A number enclosed by ``ball(bits)``, a ball that shrinks as FLINT's precision increases; a named function, so
    that the number can be pickled. The number is not known to be algebraic, so that comparisons raise `OpenError` if
    they need too many digits.
    """

    __slots__ = ("ball",)
    ball: Callable[[int], arb]

    def __init__(self, ball: Callable[[int], arb]) -> None:
        fill(self, ball=ball, _exact=None, _isolating=None, _minimal=None)

    def __reduce__(self) -> tuple[object, ...]:
        return InBalls, (self.ball,)

    def _enclosed(self, digits: int) -> Interval:
        bits, width = 10 * digits // 3 + 40, mpq(1, 10**digits)
        while digits <= OPEN and bits < 8 * OPEN:
            with ctx.workprec(bits):
                ball = self.ball(bits)
            if ball.is_finite() and (ends := ball_ends(ball)).width <= width:
                return ends
            bits *= 2
        raise OpenError(f"undecided at {digits} digits", remedy="use an enclosure")

    def _against_number(self, t: mpq) -> int:
        digits = 20
        while True:
            low, high = self._enclosed(digits)
            if not low <= t <= high:
                return 1 if low > t else -1
            digits *= 2

    def _annihilator(self) -> fmpz_poly:
        raise OpenError("this number is not known to be algebraic", remedy="use an enclosure (`enclosure`)")
