"""The multiple points of a curve of zeros, and of which kind they are, decided by exact signs and multiplicities.

At a double point the sign of the Hessian separates nodes and isolated points. Where it is zero, the point has the type
A_μ, and μ is the intersection multiplicity of both derivatives: for an even μ there is one branch, a cusp; for an odd μ
two branches touch, or the point is isolated.

Source: Wall, Singular Points of Plane Curves, Cambridge 2004, §2 (types), §6.3 (Milnor number).
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import reduce

from flint import ctx, fmpz_mpoly

from exactspline.bivariate import common_zeros as elimination
from exactspline.numbers.intervals import Box, sign_of_ball
from exactspline.one_line import one_line
from exactspline.polynomials.factors import factorize_square_free, greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, enclosed, over
from exactspline.reals.real import Real
from exactspline.roots.of_polynomials import Place, ball
from exactspline.roots.vanishing import vanish_at

#: The first precision (digits) at which a sign is tried.
DIGITS = 15


class PointKind(StrEnum):
    """What the zeros are near a multiple point."""

    #: Two branches with different tangents.
    NODE = "node"
    #: One branch, which turns back.
    CUSP = "cusp"
    #: Two branches with one tangent.
    TACNODE = "tacnode"
    #: No other zero of the function is near.
    ISOLATED = "isolated point"
    #: Of multiplicity three or more.
    MULTIPLE = "multiple point"
    #: At a knot, where it is of different kinds on the patches that meet, or branches of several patches meet.
    KNOT = "at a knot"


@dataclass(frozen=True)
class SingularPoint:
    """A point at which a function (without multiple factors) vanishes with both its derivatives on a patch, or at which
    more than two branches meet at knots.

    `multiplicity` is that of the point on the curve: the order of the lowest derivative that is not zero. `milnor` is
    the Milnor number of a double point: 1 for nodes, 2 for ordinary cusps, 3 for ordinary tacnodes. At knots where the
    patches have different points it is the least multiplicity (1 where it is simple on a patch), and there is no Milnor
    number. `patches` are those on which it is a zero.
    """

    first: Real
    second: Real
    kind: PointKind
    multiplicity: int
    milnor: int | None = None
    patches: tuple[tuple[int, int], ...] = field(default=(), compare=False)

    @one_line
    def __repr__(self) -> str:
        times = f", multiplicity {self.multiplicity}" if self.multiplicity > 2 else ""
        return f"<{self.kind} at {self.first.shortly()} and {self.second.shortly()}{times}>"


def singular_on_patch(
    form: PatchForm, sides: Box, single: Container[Place]
) -> Iterator[tuple[Place, PointKind, int, int | None]]:
    """The multiple points of the zeros of a form that is not zero, in the parameters of its sides: their kinds, their
    multiplicities, and the Milnor numbers of double ones. `single` are points with no other zero around them.

    Raises `ReachError` where that would take too long.

    >>> from exactspline.numbers.intervals import UNIT
    >>> from exactspline.polynomials.two_parameters import T, as_form
    >>> tacnode = as_form((2 * T - 1) ** 2 - (2 * S - 1) ** 4)
    >>> [(str(kind), k, milnor) for _, kind, k, milnor in singular_on_patch(tacnode, UNIT, ())]
    [('tacnode', 2, 3)]
    """
    powers = factorize_square_free(over(form, sides)).powers
    p = reduce(lambda f, g: f * g, [factor for factor, _ in powers], S * 0 + 1)
    slopes = [p.derivative(k) for k in (0, 1)]
    for zero in elimination.common_zeros([p, *slopes], sides) if all(slopes) else ():
        order = _order(zero, slopes)
        if order > 2:
            yield zero.place, PointKind.ISOLATED if zero.place in single else PointKind.MULTIPLE, order, None
            continue
        yield zero.place, *_double(zero, slopes, zero.place in single)


def _order(zero: elimination.CommonZero, derivatives: Sequence[fmpz_mpoly]) -> int:
    """The order of the lowest derivative that is not zero, from those of the first order, which are."""
    order = 2
    while True:
        derivatives = [derivatives[0].derivative(0), *(f.derivative(1) for f in derivatives)]
        if not vanish_at([f for f in derivatives if f], *zero.place):
            return order
        order += 1


def _double(zero: elimination.CommonZero, slopes: Sequence[fmpz_mpoly], single: bool) -> tuple[PointKind, int, int]:
    f, g = slopes
    hessian = f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0)
    if hessian and not vanish_at([hessian], *zero.place):
        return (PointKind.NODE if sign_at_point(hessian, zero) == -1 else PointKind.ISOLATED), 2, 1
    # a common factor of the derivatives is not zero here, since the function is square-free
    common = greatest_common_divisor(slopes)
    milnor = elimination.multiplicity(zero, f / common, g / common)
    if milnor % 2 == 0:
        return PointKind.CUSP, 2, milnor
    return (PointKind.ISOLATED if single else PointKind.TACNODE), 2, milnor


def sign_at_point(p: fmpz_mpoly, zero: elimination.CommonZero) -> int:
    """The sign of a polynomial that is not zero at a point."""
    digits = DIGITS
    while True:
        with ctx.workprec(8 * digits + 64):
            if sign := sign_of_ball(enclosed(p, *(ball(x, digits) for x in zero.place))):
                return sign
        digits *= 2
