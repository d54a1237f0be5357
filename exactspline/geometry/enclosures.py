"""Curvature and torsion at a root to so many significant digits, as mpmath numbers.

Whether a value is exactly zero is decided first; otherwise it is enclosed until its leading digits are certain, however
small it is.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from exactspline.exact import mpq, mpz
from exactspline.geometry.analysis import analyse
from exactspline.geometry.values_along import curvature, torsion
from exactspline.language.choices import Side
from exactspline.roots.enclosure import Enclosure
from exactspline.roots.root import Root
from exactspline.splines.surd import Surd, significant

if TYPE_CHECKING:
    from mpmath import mpf

    from exactspline.splines.nurbs import Nurbs


def curvature_sign(curve: Nurbs, root: Root, side: Side | str = Side.RIGHT) -> int:
    """The sign of κ at a root of any form, exactly: in space 1, or 0 where κ = 0."""
    analysis = analyse(curve)
    if not analysis.in_space:
        return analysis.sign_of("zero_curvature", root, side)
    return int(not analysis.is_flat(root) if root.exact is None else any(analysis.bend(root.exact, side)))


def curvature_value(curve: Nurbs, root: Root, digits: int, side: Side | str = Side.RIGHT) -> mpf:
    """κ at a root as an mpmath number that is off by a relative error below ``10^−digits``; exactly 0 where κ = 0.

    >>> from exactspline import curvature_extrema, load
    >>> curvature_value(load("ellipse"), curvature_extrema(load("ellipse"))[0].root, 10)
    mpf('2.0')

    Raises `DomainError` at a singular point, where κ may have a pole.
    """
    return _certain(lambda wanted: curvature(curve, root, digits=wanted, side=side), digits)


def torsion_value(curve: Nurbs, root: Root, digits: int, side: Side | str = Side.RIGHT) -> mpf:
    """τ at a root (where κ = 0 its limit) as an mpmath number that is off by a relative error below ``10^−digits``;
    exactly 0 where τ = 0.

    >>> from exactspline import load
    >>> from exactspline.geometry.features import critical_points
    >>> torsion_value(load("twisted_cubic"), critical_points(load("twisted_cubic"))[0].root, 10)
    mpf('3.0')

    Raises `DomainError` at a singular point and where κ = 0 and τ has a pole.
    """
    return _certain(lambda wanted: torsion(curve, root, digits=wanted, side=side), digits)


def _certain(value: Callable[[int], mpq | Surd | Enclosure], digits: int) -> Any:
    """A quantity computed to more and more digits after the point until the required significant ones are certain."""
    wanted = digits + 2
    while True:
        found = value(wanted)
        if not isinstance(found, Enclosure):
            return significant(found, digits)
        least = min(abs(found.low), abs(found.high))
        if found.low * found.high > 0 and (found.high - found.low) * mpz(10) ** digits <= least:
            return significant(found.middle, digits)
        wanted *= 2
