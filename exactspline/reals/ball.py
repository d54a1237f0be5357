"""Real numbers known by FLINT's balls alone: angles, arc lengths."""

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
    """The number in a ball that shrinks with FLINT's precision: ``ball(bits)``, a function with a name, so that the
    number can be pickled. It is not known to be algebraic: `OpenError` where a question needs too many digits.
    """

    __slots__ = ("ball",)
    ball: Callable[[int], arb]

    def __init__(self, ball: Callable[[int], arb]) -> None:
        fill(self, ball=ball, _exact=None, _isolating=None, _minimal=None)

    def __reduce__(self) -> tuple[object, ...]:
        return InBalls, (self.ball,)

    def _enclosed(self, digits: int) -> Interval:
        bits, wanted = 10 * digits // 3 + 40, mpq(1, 10**digits)
        while digits <= OPEN and bits < 8 * OPEN:
            with ctx.workprec(bits):
                found = self.ball(bits)
            if found.is_finite() and (ends := ball_ends(found)).width <= wanted:
                return ends
            bits *= 2
        raise OpenError(f"the ball leaves the answer open at {digits} digits", remedy="ask for an enclosure")

    def _against_number(self, t: mpq) -> int:
        digits = 20
        while True:
            low, high = self._enclosed(digits)
            if not low <= t <= high:
                return 1 if low > t else -1
            digits *= 2

    def _annihilator(self) -> fmpz_poly:
        raise OpenError("this number is not known to be algebraic", remedy="ask for digits (`enclosure`)")
