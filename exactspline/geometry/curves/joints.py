"""How the segments of a curve meet: derivatives at both ends of every segment, kinds of joints, and the order of
geometric continuity.

The order is decided without arc length: two sides agree to order r where a change of parameter with rational
derivatives β₁ > 0, β₂, β₃ maps the derivatives of the left side to those of the right side. The decision is therefore
exact, and the same in every dimension.

Source: Barsky and DeRose, Geometric continuity of parametric curves, IEEE CG&A 1989.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

from flint import fmpz

from exactspline.formulas.derivatives import squared_bending, turning_rate
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.curves.kinds import JointKind
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector, norm2
from exactspline.numbers.exact import mpq, ratio, scalar
from exactspline.numbers.intervals import Side
from exactspline.one_line import short_text
from exactspline.reals.real import Real, square_root
from exactspline.roots.answers import OneNumber
from exactspline.splines.bspline import BSpline
from exactspline.splines.evaluation import quotient_derivatives

N = TypeVar("N", mpq, fmpz)
Point = tuple[mpq, ...]
#: A point of the curve and its first three derivatives by the parameter, from one side.
Jet = tuple[Point, Point, Point, Point]

#: The number of derivatives in a jet, and the highest order of continuity that is reported.
ORDER = 3


@dataclass(frozen=True)
class Joint(OneNumber):
    """A knot inside the domain, or the seam of a closed curve (at the start of the domain), and how the two sides meet.

    `order` is the order of geometric continuity: −1 for a gap, 3 for an order of at least 3; None where the curve is
    constant or only the direction of its tangent is known (a singular joint without a corner). `angle` is the angle by
    which the tangent turns, None where it does not. `gap` is the distance of the two sides, None where they meet.
    `curvatures` are κ on both sides where the tangent is continuous and κN is not. ``float(joint)`` is the parameter as
    a double.

    >>> from exactspline import analyse, example
    >>> joint = analyse(example("circle")).joints[1]
    >>> joint, float(joint)
    (<Joint at 1: continuous curvature>, 1.0)
    """

    parameter: mpq
    kind: JointKind
    order: int | None
    at_seam: bool = False
    angle: Angle | None = None
    gap: Real | None = None
    curvatures: tuple[Real, Real] | None = None

    def __repr__(self) -> str:
        return f"<Joint at {short_text(self.parameter)}: {self.kind}>"

    @property
    def tangent_continuous(self) -> bool:
        """Whether γ′ ≠ 0 on both sides, with the same direction."""
        return self.kind in (JointKind.TURN, JointKind.CURVATURE_JUMP, JointKind.CONTINUOUS)

    @property
    def same_curvature(self) -> bool:
        """Whether tangent and curvature are continuous: κ with its sign in the plane, κ ≥ 0 in space."""
        return self.tangent_continuous if self.curvatures is None else self.curvatures[0] == self.curvatures[1]


class Ends:
    """The jets of a curve at both ends of every segment."""

    def __init__(self, curve: Curve[BSpline]) -> None:
        self.curve = curve
        self._p = [[x.d(k) for k in range(ORDER + 1)] for x in curve.p]
        self._w = [] if curve.polynomial else [curve.w.d(k) for k in range(ORDER + 1)]

    def jet(self, segment: int, side: Side | str) -> Jet:
        """The jet at the right end of a segment (``left``: on the left of a knot) or at its left end."""
        rows = [[_end(f, segment, side) for f in x] for x in self._p]
        if self._w:
            below = [_end(f, segment, side) for f in self._w]
            rows = [quotient_derivatives(row, below) for row in rows]
        first, second, third, fourth = zip(*rows, strict=True)
        return first, second, third, fourth


def end_direction(curve: Curve[BSpline], segment: int, side: Side | str) -> tuple[fmpz, ...]:
    """A positive multiple of γ′ at the right end of a segment (``left``: on the left of a knot) or at its left end,
    without derivatives: by the two Bézier points P, Q there and their weights, ``w_P (w_Q Q) − w_Q (w_P P)``. The
    components of the curve have the same degree and denominators.
    """
    n = fmpz(curve.p[0].degree)
    if not n:
        return (n,) * len(curve.p)
    rows = [_last_two(x, segment, n, side) for x in curve.p]
    if curve.polynomial:
        return tuple([q - p for p, q in rows])
    v, w = _last_two(curve.w, segment, n, side)
    return tuple([v * q - w * p for p, q in rows])


def _last_two(x: BSpline, segment: int, n: fmpz, side: Side | str) -> tuple[fmpz, fmpz]:
    """The last (or first) two Bézier ordinates of a form, n times over its denominator."""
    c, degree = x.numerators[segment], x.degree
    return (c[degree - 1], n * c[degree]) if side == Side.LEFT else (n * c[0], c[1])


def _end(f: BSpline, segment: int, side: Side | str) -> mpq:
    """The value of a spline at an end of a segment."""
    if f.degree < 0:
        return mpq(0)
    return ratio(f.numerators[segment][f.degree if side == Side.LEFT else 0], f.denominators[segment])


def same_direction(a: Sequence[N], b: Sequence[N]) -> bool:
    """Whether two nonzero vectors have the same direction (exactly: a·b > 0 and (a·b)² = ‖a‖²‖b‖²).

    >>> same_direction((1, 2), (2, 4)), same_direction((1, 2), (-1, -2))
    (True, False)
    """
    product = scalar(a, b)
    return bool(product > 0 and product * product == scalar(a, a) * scalar(b, b))


def limit_direction(v: Vector[BSpline], t: mpq, side: Side | str) -> Point:
    """The limit direction of a vector at a parameter from one side; zeros if the vector vanishes on that whole side.

    >>> s = BSpline.identity(-1, 1)
    >>> limit_direction(Vector(s, s * s), mpq(0), "left")
    (mpq(-1,1), mpq(0,1))
    """
    for order in range(v.degree + 1):
        values = tuple(c.d(order)(t, side) for c in v)
        if any(values):
            return tuple(-x for x in values) if side == Side.LEFT and order % 2 else values
    return (mpq(0),) * len(v)


def geometric_order(left: Jet, right: Jet) -> int:
    """The order of geometric continuity of two sides, from −1 to 3; γ′ ≠ 0 on both.

    >>> line, arc = [((0, 0), (1, 0), (0, k), (0, 0)) for k in (0, 1)]
    >>> geometric_order(line, line), geometric_order(line, arc)
    (3, 1)
    """
    a, b = left, right
    if a[0] != b[0]:
        return -1
    if not same_direction(a[1], b[1]):
        return 0
    length = scalar(a[1], a[1])
    first = mpq(scalar(a[1], b[1])) / length
    rest = [y - first * first * x for x, y in zip(a[2], b[2], strict=True)]
    second = scalar(rest, a[1]) / length
    if any(r != second * x for r, x in zip(rest, a[1], strict=True)):
        return 1
    rest = [
        z - first * first * first * y - mpq(3) * first * second * x for x, y, z in zip(a[2], a[3], b[3], strict=True)
    ]
    third = scalar(rest, a[1]) / length
    return 2 if any(r != third * x for r, x in zip(rest, a[1], strict=True)) else 3


def order_of(left: Jet, right: Jet, angle: Angle | None) -> int | None:
    """The order of geometric continuity of two sides, at most one of which has γ′ = 0; None if only their directions
    agree.
    """
    if left[0] != right[0] or (any(left[1]) and any(right[1])):
        return geometric_order(left, right)
    return None if angle is None else 0


def distance(a: Point, b: Point) -> Real:
    """The distance between two points."""
    difference = [x - y for x, y in zip(a, b, strict=True)]
    return square_root(scalar(difference, difference))


def curvature_of(jet: Jet) -> Real:
    """κ from a jet with γ′ ≠ 0: with its sign in the plane, not negative in space.

    >>> print(curvature_of(((0, 0), (1, 1), (0, 1), (0, 0))))
    √2/4
    """
    first, second = (Vector(*map(mpq, part)) for part in jet[1:3])
    if len(first) == 2:
        rate: mpq = turning_rate(first, second)
        return square_root(norm2(first)) * rate
    return square_root(squared_bending(first, second))


def turned(left: Point, right: Point) -> Angle | None:
    """The angle between two directions; None if they agree or one of them is zero."""
    if not any(left) or not any(right) or same_direction(left, right):
        return None
    return Angle(left, right)
