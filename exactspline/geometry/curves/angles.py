"""Angles between rational directions: exactly by cosine and sine, and to any number of digits."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from flint import arb

from exactspline.language.vector import Vector, dot
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import ball_around
from exactspline.numbers.once import cached_property
from exactspline.one_line import one_line
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, square_root

if TYPE_CHECKING:
    from mpmath import mpf


# ---- in balls


def degrees(angle: Angle) -> Real:
    """An angle in degrees, in (−180, 180].

    The number of degrees is rational only for multiples of 30 and 45: cos² is rational, so Niven's theorem holds for
    twice the angle. Otherwise the number is transcendental, by the theorem of Gelfond and Schneider:
    ``(−1)^(angle/180)`` is algebraic.

    >>> from exactspline.geometry.curves.angles import Angle
    >>> from exactspline.numbers.exact import mpq
    >>> degrees(Angle((mpq(1), mpq(0)), (mpq(1), mpq(1))))
    <Real 45>
    >>> degrees(Angle((mpq(1), mpq(0)), (mpq(3), mpq(4)))).double()
    53.13010235415598
    """
    if 4 * angle.cosine * angle.cosine in (0, 1, 2, 3, 4):
        return Real(round(float(_angle_ball(angle, 60).mid())))
    return InBalls(partial(_angle_ball, angle), transcendental=True)


def _angle_ball(angle: Angle, bits: int) -> arb:
    sine, cosine = (ball_around(*x.enclosure(bits * 3 // 10 + 1)) for x in (angle.sine, angle.cosine))
    return arb.atan2(sine, cosine) * 180 / arb.pi()


class Angle:
    """The angle from one nonzero rational direction to another, given exactly by its cosine and sine, which are
    computed when first needed. In the plane an angle to the left is positive.

    In space an angle is between 0° and 180°.

    >>> angle = Angle((mpq(1), mpq(0)), (mpq(1), mpq(-1)))
    >>> print(angle.cosine, angle.sine, angle.degrees(10))
    √2/2 -√2/2 -45.0
    >>> Angle((mpq(1), mpq(0), mpq(0)), (mpq(0), mpq(0), mpq(2))).sine
    <Real 1>
    """

    def __init__(self, first: Sequence[mpq], second: Sequence[mpq]) -> None:
        self._directions = Vector(*first), Vector(*second)

    @cached_property
    def cosine(self) -> Real:
        """The cosine of the angle."""
        a, b = self._directions
        product = dot(a, b)
        size = square_root(product * product / self._lengths)
        return -size if product < 0 else size

    @cached_property
    def sine(self) -> Real:
        """The sine of the angle."""
        a, b = self._directions
        size = square_root(1 - dot(a, b) ** 2 / self._lengths)
        return -size if len(a) == 2 and a[0] * b[1] < a[1] * b[0] else size

    @property
    def _lengths(self) -> mpq:
        """The product of the squared lengths of the two directions."""
        a, b = self._directions
        return dot(a, a) * dot(b, b)

    @property
    def reverses(self) -> bool:
        """Whether the second direction is opposite to the first."""
        a, b = self._directions
        product = dot(a, b)
        return bool(product < 0 and product * product == self._lengths)

    def degrees(self, digits: int) -> mpf:
        """The angle in degrees, in (−180, 180], as an mpmath number to this many significant digits."""
        return degrees(self).significant(digits)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Angle) and (self.cosine, self.sine) == (other.cosine, other.sine)

    def __hash__(self) -> int:
        return hash((self.cosine, self.sine))

    @one_line
    def __repr__(self) -> str:
        return f"<Angle: cos = {self.cosine}, sin = {self.sine}>"
