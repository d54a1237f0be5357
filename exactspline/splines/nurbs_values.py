"""The values of a curve at a rational parameter, exactly: derivatives, tangent, normal."""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

from exactspline.errors import DomainError, ShapeError
from exactspline.formulas.derivatives import across
from exactspline.hooks import FunctionsOutside
from exactspline.language.operand import checked_order
from exactspline.language.vector import Vector, norm2, perp
from exactspline.numbers.exact import Number, mpq, rational, text
from exactspline.numbers.sides import Side
from exactspline.reals.real import Real, square_root
from exactspline.splines.bspline import BSpline


def quotient_derivatives(above: Sequence[mpq], below: Sequence[mpq]) -> list[mpq]:
    """The derivatives of p/w from those of p and w: p = w · (p/w), differentiated by Leibniz's rule.

    >>> quotient_derivatives([mpq(1), mpq(0), mpq(0)], [mpq(1), mpq(1), mpq(0)])
    [mpq(1,1), mpq(-1,1), mpq(2,1)]
    """
    found: list[mpq] = []
    for k, value in enumerate(above):
        rest = value - sum((comb(k, j) * below[k - j] * earlier for j, earlier in enumerate(found)), mpq(0))
        found.append(rest / below[0])
    return found


class ValuesAlong(FunctionsOutside):
    """The methods of a `Nurbs` that take a parameter."""

    __slots__ = ()
    p: Vector[BSpline]
    w: BSpline
    dimension: int

    def derivative(self, order: int, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """The derivative of the given order at a rational parameter, exactly; at a knot the one from the `side`.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.derivative(1, 0), arc.derivative(2, 0)
        ((mpq(0,1), mpq(2,1)), (mpq(-4,1), mpq(0,1)))

        Raises `FormulaError` for a negative order, `DomainError` outside the domain.
        """
        order, t = checked_order(order), rational(t)
        below, *rows = [[f.d(k)(t, side) for k in range(order + 1)] for f in (self.w, *self.p)]
        return tuple(quotient_derivatives(row, below)[order] for row in rows)

    def tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """γ′ at a rational parameter (see `unit_tangent`).

        >>> from exactspline import Nurbs
        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).tangent(0)
        (mpq(1,1), mpq(2,1))
        """
        return self.derivative(1, t, side)

    def unit_tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
        """γ′/‖γ′‖ at a rational parameter, exactly.

        >>> from exactspline import Nurbs
        >>> [str(x) for x in Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).unit_tangent(0)]
        ['√5/5', '2√5/5']

        Raises `DomainError` where γ′ = 0.
        """
        return _normalized(self.tangent(t, side), f"γ′ = 0 at the parameter {text(rational(t))}")

    def normal(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Real, ...]:
        """The unit normal at a rational parameter, exactly: in the plane γ′⊥/‖γ′‖, to the left of the curve; in space
        the principal normal, towards the centre of curvature.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.normal("1/2")
        (<Real -3/5>, <Real -4/5>)

        Raises `DomainError` where γ′ = 0, in space also where κ = 0, and `ShapeError` in other dimensions.
        """
        where = f"at the parameter {text(rational(t))}"
        first = self.tangent(t, side)
        if self.dimension == 2:
            return _normalized(perp(Vector(*first)).components, f"γ′ = 0 {where}")
        if self.dimension != 3:
            raise ShapeError(f"the normal of a curve in R{self.dimension}", remedy="it is defined in plane and space")
        bent = across(Vector(*first), Vector(*self.derivative(2, t, side)))
        return _normalized(bent.components, f"γ′ × γ″ = 0 {where}")


def _normalized(v: tuple[mpq, ...], problem: str) -> tuple[Real, ...]:
    length = norm2(Vector(*v))
    if not length:
        raise DomainError(problem, remedy="choose another parameter")
    inverse = square_root(1 / length)
    return tuple(x * inverse for x in v)
