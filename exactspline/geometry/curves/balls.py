"""Angles in degrees, enclosed between rational numbers by FLINT's ball arithmetic."""

from __future__ import annotations

from functools import partial

from flint import arb

from exactspline.geometry.curves.angles import Angle
from exactspline.numbers.intervals import ball_around
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real


def degrees(angle: Angle) -> Real:
    """An angle in degrees, in (−180, 180].

    It is rational only for multiples of 30 and 45 degrees: cos² is rational, so Niven's theorem holds for twice the
    angle. Otherwise it is transcendental, by the theorem of Gelfond and Schneider: ``(−1)^(angle/180)`` is algebraic.

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
