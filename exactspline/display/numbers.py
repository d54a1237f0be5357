"""Readable exact numbers: a long fraction is shown as a decimal, or in full on request. Curves, surfaces and shapes in
one line.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_UP, Context, Decimal

from exactspline.errors import counted
from exactspline.numbers.exact import decimal_unit, mpq, rational, text
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface

_NUMBER = re.compile(r"(?<![\w/.])-?\d+/\d+(?![\w/.])|(?<![\w/.])-?\d{25,}(?![\w/.])")
#: A number with more characters than this is shown as a decimal.
LONGEST = 14
#: The significant digits of such a decimal.
DIGITS = 6


@dataclass(frozen=True)
class Numbers:
    """How exact numbers are written: long numbers as decimals (with `exact` in full), and with `digits` every number
    followed by this many digits.

    >>> Numbers()(mpq(1, 3)), Numbers(5)(mpq(1, 3)), Numbers()(mpq(1, 3**40))
    ('1/3', '1/3 ≈ 0.33333', '≈ 8.22526e-20')
    """

    digits: int = 0
    exact: bool = False

    def __call__(self, value: mpq) -> str:
        """A number as text."""
        return self.within(text(value))

    def within(self, formula: str) -> str:
        """A formula as text, with its numbers formatted.

        >>> Numbers().within("x/7 + 1/1220703125000000000")
        'x/7 + ≈ 8.192e-19'
        """
        return formula if self.exact and not self.digits else _NUMBER.sub(self._shown, formula)

    def common(self, low: mpq, high: mpq) -> str:
        """The digits on which the ends of an isolating interval agree; empty if numbers are written in full."""
        if self.exact or max(len(text(low)), len(text(high))) <= LONGEST:
            return ""
        digits = next((n for n in range(DIGITS, 1, -1) if decimal(low, n) == decimal(high, n)), 0)
        return decimal(low, digits) if digits else ""

    def _shown(self, match: re.Match[str]) -> str:
        if len(match[0]) <= LONGEST or self.exact:
            return f"{match[0]} ≈ {decimal(mpq(match[0]), self.digits)}" if self.digits else match[0]
        return f"≈ {decimal(mpq(match[0]), self.digits or DIGITS)}"


#: Every number in full.
EXACT = Numbers(exact=True)


def polynomial_text(coefficients: Sequence[mpq], variable: str = "t") -> str:
    """A polynomial in the form in which it can be typed, given by its coefficients, constant term first.

    >>> polynomial_text([mpq(1), mpq(-3), mpq(0), mpq(1, 2)])
    '1 - 3t + 1/2 t^3'
    """
    written = ""
    for i, c in enumerate(coefficients):
        if c:
            sign = ("-" if c < 0 else "") if not written else (" - " if c < 0 else " + ")
            size = "" if abs(c) == 1 and i else text(abs(c))
            gap = " " if "/" in size and i else ""
            written += sign + size + gap + ("" if not i else variable if i == 1 else f"{variable}^{i}")
    return written or "0"


def rounded_down(x: mpq, digits: int) -> mpq:
    """The largest number with this many significant decimal digits that is not above a number.

    >>> rounded_down(mpq(1, 64), 2), -rounded_down(mpq(-1, 64), 2), rounded_down(mpq(0), 2)
    (mpq(3,200), mpq(2,125), mpq(0,1))
    """
    if not x:
        return x
    unit = decimal_unit(abs(x)) / mpq(10) ** (digits - 1)
    return x // unit * unit


def decimal(value: mpq, digits: int) -> str:
    """An exact number rounded to a given number of significant digits, half away from zero; with an exponent if it is
    tiny, or has more digits before the point than are shown.

    >>> decimal(mpq(1, 3), 5), decimal(mpq(-2), 5), decimal(mpq(12345), 3), decimal(mpq(1, 3 * 10**6), 3)
    ('0.33333', '-2.0', '1.23e+4', '3.33e-7')
    """
    context = Context(digits, ROUND_HALF_UP, MIN_EMIN, MAX_EMAX)
    rounded = context.divide(Decimal(int(value.numerator)), Decimal(int(value.denominator)))
    place = rounded.adjusted() if rounded else 0
    fixed = min(-(digits // 3), -5) < place < digits
    whole, _, part = format(rounded if fixed else rounded.scaleb(-place, context), "f").partition(".")
    return f"{whole}.{part.rstrip('0') or '0'}" + ("" if fixed else f"e{place:+d}")


def decimal_milliseconds(seconds: float) -> str:
    """A time in milliseconds, to a tenth.

    >>> decimal_milliseconds(0.01234)
    '12.3'
    """
    return f"{1000 * seconds:.1f}"


def described(c: Nurbs) -> str:
    """A curve in one line. A curve with equal weights is called polynomial; directions (control vectors of weight 0)
    are counted apart from zero vectors of weight 0, which have no effect.

    >>> from exactspline import example
    >>> described(example("circle"))
    'rational, degree 2, 4 segments, 9 control points in R2'
    """
    kind = "polynomial" if c.polynomial else "rational"
    equal = " (equal weights)" if c.polynomial and any(w != 1 for w in c.weights) else ""
    segments, points = counted(c.segments, "segment"), counted(len(c.control_points), "control point")
    directions = sum(isinstance(point, Direction) for point in c.control_points)
    nothing = sum(w == 0 for w in c.weights) - directions
    remark = f", of these {counted(directions, 'direction')}" if directions else ""
    remark += f", {nothing} with the weight 0 (without effect)" if nothing else ""
    return f"{kind}{equal}, degree {c.degree}, {segments}, {points} in R{c.dimension}{remark}"


def described_surface(surface: NurbsSurface) -> str:
    """A surface in one line.

    >>> from exactspline import example
    >>> described_surface(example("torus"))
    'rational, degree 2 × 2, 4 × 4 patches, 9 × 9 control points in R3'
    """
    (m, n), (rows, columns) = surface.degree, surface.patches
    kind = "polynomial" if surface.polynomial else "rational"
    patches = "one patch" if rows * columns == 1 else f"{rows} × {columns} patches"
    net = f"{len(surface.control_points)} × {counted(len(surface.control_points[0]), 'control point')}"
    return f"{kind}, degree {m} × {n}, {patches}, {net} in R{surface.dimension}"


#: The number of digits shown for long numbers of a shape.
OF_SHAPES = 12


def shape_text(numbers: Mapping[str, Sequence[object]], within: mpq) -> str:
    """The numbers that describe a shape, and the proved distance from it, as text.

    >>> shape_text({"centre": [0, 1], "radius": ["1/2"]}, mpq(1, 1000))
    'centre (0, 1), radius 1/2, within 0.001'
    """
    words = []
    for name, values in numbers.items():
        each = [readable(str(x)) for x in values]
        words.append(f"{name} {each[0] if len(each) == 1 else '(' + ', '.join(each) + ')'}")
    near = f"within {decimal(within, 4)}" if within else "exactly"
    return ", ".join([*words, near]).replace("-", "−").replace("e−", "e-")


def readable(number: str) -> str:
    """A number of a shape: in full if that is short, otherwise as a decimal."""
    return (
        number
        if len(number) <= OF_SHAPES or "/" not in number or "√" in number
        else f"≈ {decimal(rational(number), OF_SHAPES)}"
    )
