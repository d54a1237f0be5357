"""Segments of curves as forms for `exactspline.polynomials.plane_pairs`, and local parameters of segments as real
numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb, isnan, nan
from typing import cast

from flint import ctx, fmpz, fmpz_poly

from exactspline.numbers.exact import Rounding, lcm, mpq
from exactspline.numbers.intervals import Interval, ball_ends
from exactspline.numbers.once import fill
from exactspline.polynomials.bernstein import ONE, value
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import Image, Local, RationalMap
from exactspline.polynomials.zero_places import Place
from exactspline.reals.real import UNASKED, RationalNumber, Real
from exactspline.roots.root import InDoubles, LazyRoot, Root, root_inside
from exactspline.roots.values import ValueAt
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.nurbs import Nurbs

#: Guard bits of a value.
GUARD = 16
U_PLUS_V = fmpz_poly([1, 1])


#: The degree of a segment, and the integers of the forms of its homogeneous coordinates.
SegmentForms = tuple[int, list[fmpz_poly]]
#: The degree of a segment, and the lists of these integers.
SegmentRows = tuple[int, list[Sequence[int]]]


def segment_forms(curve: Nurbs, i: int) -> SegmentForms:
    """The degree of a segment, and the integers of the forms of its homogeneous coordinates over a common denominator.

    >>> segment_forms(Nurbs(1, [0, 0, 1, 1], [(0, "1/2"), (1, 2)]).elevate_degree(), 0)
    (1, [2*x, 4*x + 1, 2*x + 2])
    """
    return forms_of(segment_rows(curve, i))


def forms_of(segment: SegmentRows) -> SegmentForms:
    """The forms of a segment in the lowest degree."""
    n, whole = segment[0], [fmpz_poly([*c]) for c in segment[1]]
    while n > 0 and all(c(-1) == 0 for c in whole):
        n, whole = n - 1, [c // U_PLUS_V for c in whole]
    return n, whole


def segment_rows(curve: Nurbs, i: int) -> SegmentRows:
    """The degree of a segment as given, and the integers of its homogeneous coordinates over a common denominator.

    >>> segment_rows(Nurbs(1, [0, 0, 1, 1], [(0, "1/2"), (1, 2)]).elevate_degree(), 0)
    (2, [(0, 2, 2), (1, 5, 4), [2, 4, 2]])
    """
    (operands, below), n = curve.rows[i], curve.degree
    return n, [*operands, [below * comb(n, k) for k in range(n + 1)]] if curve.polynomial else list(operands)


def is_point(segment: SegmentRows) -> bool:
    """Whether all control points of a segment are equal.

    >>> is_point(segment_rows(Nurbs(1, [0, 0, 1, 1], [(2, 3), (2, 3)]), 0))
    True
    """
    *rows, weights = segment[1]
    return all(x * weights[0] == row[0] * w for row in rows for x, w in zip(row, weights, strict=True))


def is_joined(before: SegmentRows, behind: SegmentRows) -> bool:
    """Whether a segment ends where another segment begins.

    >>> line = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 2), (3, 3)])
    >>> is_joined(segment_rows(line, 0), segment_rows(line, 1)), is_joined(segment_rows(line, 1), segment_rows(line, 0))
    (True, False)
    """
    return all(x[-1] * behind[1][-1][0] == y[0] * before[1][-1][-1] for x, y in zip(before[1], behind[1], strict=True))


def plane_forms(curve: Nurbs, i: int) -> PlaneForms:
    """The forms of a segment of a plane curve."""
    n, (x, y, w) = segment_forms(curve, i)
    return PlaneForms(n, x, y, w)


class ImageValue(ValueAt):
    """The value of a map between segments at an irrational parameter. The numerator and the denominator are computed
    only if enclosures do not decide a question; if the value is `known` in doubles, the image may be given by a
    function that is called if they do not decide one.

    >>> from exactspline.polynomials.isolation import isolate
    >>> place = Place(isolate(fmpz_poly([1, 0, -2]), 2).inner[0])  # z = √(1/2)
    >>> doubled = Image(place, RationalMap(1, fmpz_poly([0, 2]), fmpz_poly([1])))
    >>> x = ImageValue(doubled, Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1)))
    >>> x, x.minimal_polynomial()  # z/(1 + z) at z = √2
    (<Real 2 - √2>, [2, -4, 1])
    """

    __slots__ = ("_given_image", "_known", "_place", "_sides", "_splines")
    _given_image: Image | Callable[[], Image]
    _known: InDoubles | None
    _sides: tuple[Interval, Interval]
    _splines: tuple[BSpline, BSpline] | None
    _place: Real | None

    def __init__(
        self, image: Image | Callable[[], Image], side: Interval, other: Interval, known: InDoubles | None = None
    ) -> None:
        fill(self, _given_image=image, _known=known, _sides=(side, other), _splines=None, _place=None, **UNASKED)

    @property
    def _image(self) -> Image:
        if not isinstance(self._given_image, Image):
            fill(self, _given_image=self._given_image())
        return cast(Image, self._given_image)

    @property
    def place(self) -> Real:  # type: ignore[override]  # computed when it is needed
        """The parameter on the other curve."""
        if self._place is None:
            fill(self, _place=root_at(self._image.place, self._sides[1]))
        return cast(Real, self._place)

    def _quotient(self) -> tuple[BSpline, BSpline]:
        if self._splines is None:
            fill(self, _splines=image_splines(self._image.map, *self._sides))
        return cast("tuple[BSpline, BSpline]", self._splines)

    @property
    def top(self) -> BSpline:  # type: ignore[override]  # computed when it is needed
        """The numerator of the map."""
        return self._quotient()[0]

    @property
    def bottom(self) -> BSpline:  # type: ignore[override]  # computed when it is needed
        """The denominator of the map."""
        return self._quotient()[1]

    def _at_hand(self) -> None:
        """No ball takes no refinement."""

    def double(self, rounding: str = Rounding.NEAREST) -> float:
        """The correctly rounded double; this is faster for a common point that was found in doubles."""
        known = self._known.nearest(self._sides[0], rounding) if self._known else nan
        return super().double(rounding) if isnan(known) else known

    def _enclosed(self, digits: int) -> Interval:
        """An enclosure by balls around the entries of the adjugate."""
        side, digits = self._sides[0], max(digits, 0)
        bits, limit = digits * 10 // 3 + GUARD, mpq(1, 10**digits)
        if self._known and (known := self._known.part(int(side.width / limit + 1).bit_length())):
            return side.part(known)
        while True:
            with ctx.workprec(3 * bits):
                z = self._image.z(bits)
                if z is not None:
                    local = z / (1 + z)
                    if local.is_finite():
                        enclosure = side.part(Interval(*ball_ends(local)))
                        if enclosure.width <= limit:
                            return enclosure
            bits *= 2


def parameter(local: Local, side: Interval, other: Interval) -> Real:
    """A local parameter of a segment over `side` as a real number; if it is an image, its place is on a segment over
    `other`.

    >>> from exactspline.polynomials.zero_places import at
    >>> parameter(at(mpq(1, 2), 1), Interval(mpq(1), mpq(2)), Interval(mpq(0), mpq(1)))
    <Real 3/2>
    """
    if isinstance(local, Place):
        return root_at(local, side)
    if (t := local.place.exact) is not None:
        return RationalNumber(side.at(image_of(local.map, t)))
    return ImageValue(local, side, other)


def root_at(place: Place, side: Interval) -> Real:
    """A place on a segment over an interval."""
    if (t := place.exact) is not None:
        return RationalNumber(side.at(t))
    zero = place.zero
    if isinstance(zero, LazyRoot) and not place.bits:
        return root_inside(zero, side)
    root = Root(side.at(zero.low), side.at(zero.high), (zero.multiplicity, zero.multiplicity), zero.signs, zero, side)
    low, high = place.interval
    root.narrow_to(side.at(low), side.at(high))
    return root


def image_of(carried: RationalMap, t: mpq) -> mpq:
    """The value of a map at a rational parameter."""
    u, v = (value((form, ONE), carried.degree, t) for form in (carried.bottom, carried.top))
    return v / (u + v)


def image_splines(carried: RationalMap, side: Interval, other: Interval) -> tuple[BSpline, BSpline]:
    """Numerator and denominator of a map between segments over intervals, in the parameters of the curves."""
    scale = fmpz(int(lcm(side.low.denominator, side.high.denominator)))
    low, high = (fmpz(int(end * int(scale))) for end in side)
    mesh = Mesh(other)
    top, bottom = carried.bottom * low + carried.top * high, (carried.bottom + carried.top) * scale

    def spline(c: fmpz_poly) -> BSpline:
        return BSpline.from_forms(carried.degree, mesh, (), [(c, ONE)])

    return spline(top), spline(bottom)
