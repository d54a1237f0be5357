"""A curve, a surface or a shape in one line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from exactspline.display.numbers import decimal
from exactspline.errors import counted
from exactspline.numbers.exact import mpq, rational
from exactspline.splines.control_points import Direction
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface


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
DIGITS = 12


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
        if len(number) <= DIGITS or "/" not in number or "√" in number
        else f"≈ {decimal(rational(number), DIGITS)}"
    )
