"""The precision with which the numbers of a curve were written, as a distance."""

from __future__ import annotations

from exactspline.errors import ShapeError
from exactspline.numbers.exact import Number, decimal_places, decimal_unit, mpq, rational
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.type_checks import curve_of

#: The number of decimal digits that distinguish every double from its neighbours, and the bits of a double.
DECIMALS, BITS = 17, 53


#: The word for the precision with which the numbers of a curve were written.
WRITTEN = "written"


def distance(epsilon: Number, curve: Nurbs | NurbsSurface) -> mpq:
    """A distance given as a number or, by the word `WRITTEN`, as the `written_precision`.

    Raises `ShapeError` for a distance that is not positive, `NumberError` for anything that is not a number.
    """
    if epsilon == WRITTEN:
        return written_precision(curve)
    within = rational(epsilon)
    if within <= 0:
        raise ShapeError(f"the distance {epsilon}", remedy=f"give a number above 0, such as 1e-9, or {WRITTEN}")
    return within


def written_precision(curve: Nurbs | NurbsSurface) -> mpq:
    """Half a unit in the last digit with which the coordinates and weights of a curve or a surface were written.

    All numbers are assumed to be written with as many decimal digits as the longest one. The last digit is that of the
    largest number with this many digits, or of a number with one digit less, because a final zero is not visible.
    Numbers with more than 17 digits are taken for doubles; the precision is then half a unit in the last of 53 bits.
    Fractions such as 1/3 count as exact.

    >>> arc, knots = [(1, 0), (1, 1), (0, 1)], [0, 0, 0, 1, 1, 1]
    >>> written_precision(Nurbs(2, knots, arc, [1, "0.7071", 1]))
    mpq(1,20000)
    >>> written_precision(Nurbs(2, knots, arc, [1, mpq(0.5**0.5), 1])) == mpq(1, 2**54)
    True
    >>> written_precision(Nurbs(2, knots, arc))
    mpq(1,2)
    """
    if isinstance(curve, NurbsSurface):
        rows = [point for row in curve.control_points for point in row] + list(curve.weights)
    else:
        given = curve_of(curve)
        rows = [*given.control_points, given.weights]
    digits = {abs(x): _digits(x) for row in rows for x in row if x}
    most = max(digits.values())
    if most > DECIMALS:
        largest: mpq = max(x for x, count in digits.items() if count > DECIMALS)
        unit = mpq(2) ** (largest.numerator.bit_length() - largest.denominator.bit_length())
        return (unit if unit <= largest else unit / 2) / mpq(2) ** BITS
    return decimal_unit(max(x for x, count in digits.items() if count >= most - 1)) / mpq(10) ** (most - 1) / 2


def _digits(x: mpq) -> int:
    """The number of significant decimal digits of a number; 1 if there are infinitely many."""
    places = decimal_places(x)
    return 1 if places is None else len(str(x * 10**places).rstrip("0"))
