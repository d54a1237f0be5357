"""Angles between rational directions: exactly by cosine and sine, and to any number of digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from exactspline.exact import mpq
from exactspline.language.vector import Vector, dot
from exactspline.splines.surd import Surd, significant, square_root

if TYPE_CHECKING:
    from mpmath import mpf


@dataclass(frozen=True)
class Angle:
    """The angle between two directions by its cosine and sine, exactly; in the plane positive to the left.

    In space it is without a sign: between 0° and 180°.

    >>> angle = angle_between((mpq(1), mpq(0)), (mpq(1), mpq(-1)))
    >>> print(angle.cosine, angle.sine, angle.degrees(10))
    √2/2 -√2/2 -45.0
    """

    cosine: mpq | Surd
    sine: mpq | Surd

    def degrees(self, digits: int) -> mpf:
        """The angle in degrees, in (−180, 180], as an mpmath number to so many significant digits."""
        from mpmath import mp

        with mp.workdps(digits + 10):
            turned = mp.atan2(significant(self.sine, digits + 10), significant(self.cosine, digits + 10))
            if self.sine == 0 or self.cosine == 0:
                return mp.mpf(int(mp.nint(turned * 180 / mp.pi)))
            return +(turned * 180 / mp.pi)


def angle_between(a: Sequence[mpq], b: Sequence[mpq]) -> Angle:
    """The angle from one direction to another, neither of them zero.

    >>> angle_between((mpq(1), mpq(0), mpq(0)), (mpq(0), mpq(0), mpq(2))).sine
    mpq(1,1)
    """
    lengths = dot(Vector(*a), Vector(*a)) * dot(Vector(*b), Vector(*b))
    product = dot(Vector(*a), Vector(*b))
    sine = square_root((lengths - product * product) / lengths)
    cosine = square_root(product * product / lengths)
    to_the_right = len(a) == 2 and a[0] * b[1] < a[1] * b[0]
    return Angle(-cosine if product < 0 else cosine, -sine if to_the_right else sine)
