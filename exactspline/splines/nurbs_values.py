"""The values of a curve at a parameter: point, derivatives, tangent, normal, curvature, torsion; exactly at rational
parameters, to any number of digits at certified roots.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import comb
from typing import TYPE_CHECKING

from exactspline.errors import DomainError, FormulaError, ShapeError
from exactspline.exact import Number, Rounding, mpq, rational, text
from exactspline.language.choices import Side
from exactspline.language.services import service
from exactspline.language.vector import Vector, dot
from exactspline.splines.surd import Surd, square_root

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactspline.roots.enclosure import Enclosure
    from exactspline.roots.root import Root
    from exactspline.splines.bspline import BSpline

#: An exact value: a rational number, or ``a√b``.
Exact = mpq | Surd


class ValuesAlong:
    """The methods of a `Nurbs` that take a parameter."""

    __slots__ = ()
    p: Vector[BSpline]
    w: BSpline
    dimension: int

    def at(self, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT) -> tuple[mpq | Enclosure, ...]:
        """The point at a parameter: exact at a rational one, enclosed to so many digits behind the point at an
        irrational `Root`.

        >>> from exactspline import Nurbs, zeros
        >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
        >>> parabola.at("1/2")
        (mpq(1,2), mpq(1,4))
        >>> parabola.at(zeros(parabola.p[1].scaled(2) - 1).roots[0], digits=8)  # y = 1/2
        (<Enclosure 0.70710678…>, <Enclosure 0.5…>)

        Raises `DomainError` outside the domain.
        """
        return service("at")(self, t, digits=digits, side=side)

    def derivative(self, order: int, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """The derivative of the given order at a rational parameter, exactly; at a knot the one from the `side`.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.derivative(1, 0), arc.derivative(2, 0)
        ((mpq(0,1), mpq(2,1)), (mpq(-4,1), mpq(0,1)))

        Raises `FormulaError` for a negative order, `DomainError` outside the domain.
        """
        if type(order) is not int or order < 0:
            raise FormulaError(f"a derivative of order {order!r}", remedy="orders are 0, 1, 2, …")
        t = rational(t)
        weights = [self.w.d(k)(t, side) for k in range(order + 1)]
        found: list[tuple[mpq, ...]] = []
        for k in range(order + 1):
            # (wγ)⁽ᵏ⁾ = p⁽ᵏ⁾ by Leibniz' rule
            row = [x.d(k)(t, side) for x in self.p]
            for i in range(1, k + 1):
                factor = comb(k, i) * weights[i]
                row = [x - factor * y for x, y in zip(row, found[k - i], strict=True)]
            found.append(tuple(x / weights[0] for x in row))
        return found[order]

    def tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[mpq, ...]:
        """γ′ at a rational parameter (see `unit_tangent`).

        >>> from exactspline import Nurbs
        >>> Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).tangent(0)
        (mpq(1,1), mpq(2,1))
        """
        return self.derivative(1, t, side)

    def unit_tangent(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Exact, ...]:
        """γ′/‖γ′‖ at a rational parameter, exactly.

        >>> from exactspline import Nurbs
        >>> [str(x) for x in Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 2)]).unit_tangent(0)]
        ['√5/5', '2√5/5']

        Raises `DomainError` where γ′ = 0.
        """
        return _normalized(self.tangent(t, side), f"γ′ = 0 at the parameter {text(rational(t))}")

    def normal(self, t: Number, side: Side | str = Side.RIGHT) -> tuple[Exact, ...]:
        """The unit normal at a rational parameter, exactly: in the plane γ′⊥/‖γ′‖, to the left of the curve; in space
        the principal normal, towards the centre of curvature.

        >>> from exactspline import Nurbs
        >>> arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], weights=[1, 1, 2])
        >>> arc.normal("1/2")
        (mpq(-3,5), mpq(-4,5))

        Raises `DomainError` where γ′ = 0, in space also where κ = 0, and `ShapeError` in other dimensions.
        """
        where = f"at the parameter {text(rational(t))}"
        first = self.tangent(t, side)
        if self.dimension == 2:
            return _normalized((-first[1], first[0]), f"γ′ = 0 {where}")
        if self.dimension != 3:
            raise ShapeError(f"the normal of a curve in R{self.dimension}", remedy="it is defined in plane and space")
        second = self.derivative(2, t, side)
        length, along = dot(Vector(*first), Vector(*first)), dot(Vector(*first), Vector(*second))
        bent = tuple(length * b - along * a for a, b in zip(first, second, strict=True))
        return _normalized(bent, f"γ′ × γ″ = 0 {where}")

    def curvature(self, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT) -> Exact | Enclosure:
        """The curvature: in the plane signed (positive where the curve turns left), in space not negative. Exact at a
        rational parameter, enclosed to so many digits behind the point at an irrational `Root`.

        >>> from exactspline import Nurbs
        >>> parabola = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), ("1/2", 0), (1, 1)])
        >>> parabola.curvature(0), str(parabola.curvature("1/2"))
        (mpq(2,1), '√2/2')

        Raises `DomainError` where γ′ = 0 and outside the domain, `ShapeError` unless in the plane or in space.
        """
        return service("curvature")(self, t, digits=digits, side=side)

    def torsion(self, t: Number | Root, *, digits: int = 15, side: Side | str = Side.RIGHT) -> mpq | Enclosure:
        """The torsion of a space curve (its limit where κ = 0), positive for a right-handed helix. Exact at a rational
        parameter, enclosed to so many digits behind the point at an irrational `Root`.

        >>> from exactspline import example
        >>> example("twisted_cubic").torsion(0)
        mpq(3,1)

        Raises `DomainError` where γ′ = 0 or the torsion has a pole, `ShapeError` unless the curve is in space and not
        straight there.
        """
        return service("torsion")(self, t, digits=digits, side=side)

    def at_floats(
        self,
        ts: Iterable[float | Number | Root],
        *,
        order: int = 0,
        rounding: str = Rounding.NEAREST,
        side: str = "right",
    ) -> list[tuple[float, ...]]:
        """The points (of `order` k: the k-th derivatives) at many parameters, every coordinate the correctly rounded
        double: ``nearest``, ``down`` or ``up``. A float among the parameters counts with its binary value.

        >>> from exactspline import example
        >>> example("circle").at_floats([0.5, "1/3"])
        [(0.6, 0.8), (0.8, 0.6)]
        >>> example("circle").at_floats([0.1], order=2, rounding="down")
        [(-3.7658897739592607, -1.160825816921463)]

        Raises what `at` and `derivative` raise, and `OverflowError` beyond the largest double.
        """
        return service("at_floats")(self, ts, order=order, rounding=rounding, side=side)

    def curvature_floats(
        self, ts: Iterable[float | Number | Root], *, rounding: str = Rounding.NEAREST, side: str = "right"
    ) -> list[float]:
        """`curvature` at many parameters as correctly rounded doubles.

        >>> from exactspline import example
        >>> example("cubic_s").curvature_floats([0, 0.5, 0.75])
        [-0.35777087639996635, 0.0, 1.82615058850886]
        """
        return service("curvature_floats")(self, ts, rounding=rounding, side=side)

    def torsion_floats(
        self, ts: Iterable[float | Number | Root], *, rounding: str = Rounding.NEAREST, side: str = "right"
    ) -> list[float]:
        """`torsion` at many parameters as correctly rounded doubles.

        >>> from exactspline import example
        >>> example("twisted_cubic").torsion_floats([0, 0.1])
        [3.0, 2.7500229168576404]
        """
        return service("torsion_floats")(self, ts, rounding=rounding, side=side)

    def plot(self, ax: Axes | None = None, **how: object) -> Axes:
        """The curve with its control polygon in matplotlib's axes (None: those of a new figure), which are returned;
        `how` as for `exactspline.display.plot.plot_curve`.

        >>> from exactspline import example
        >>> example("circle").plot().get_aspect()
        1.0
        """
        return service("plot")(self, ax, **how)


def _normalized(v: tuple[mpq, ...], problem: str) -> tuple[Exact, ...]:
    length = dot(Vector(*v), Vector(*v))
    if not length:
        raise DomainError(problem, remedy="choose another parameter")
    inverse = square_root(1 / length)
    return tuple(x * inverse for x in v)
