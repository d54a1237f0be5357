"""Strategies of hypothesis (an extra package) that draw nasty curves; every number of a curve is a double.

A failure is shrunk towards the first case of a family, the largest ε = 2⁻ᵏ and a curve that is not moved.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from exactspline.errors import CurveFileError, as_texts, nearest
from exactspline.splines.nurbs import Nurbs
from exactspline.testing.families import DIAL, FAMILIES, FURTHER, SHAPES, Row, all_cases, bezier_knots

if TYPE_CHECKING:
    from hypothesis.strategies import SearchStrategy

#: The powers of two by which curves are scaled.
SCALES = range(-20, 21)


def nasty_curves(families: Iterable[str] = (), dimension: int | None = None) -> SearchStrategy[Nurbs]:
    """Curves of the families of `exactspline.testing` (by default of all), in the plane, in space, or (by default)
    both.

    >>> from hypothesis import find
    >>> find(nasty_curves(["near"]), lambda curve: True).name
    'near 2 cusp'

    Raises `CurveFileError` for an unknown family, and if no curve has this dimension.
    """
    from hypothesis import strategies

    names = as_texts(families, "names of families", "the name of a family") or list(FAMILIES)
    for name in names:
        if name not in FAMILIES:
            raise CurveFileError(f"there is no family of curves called {name!r}", remedy=nearest(name, FAMILIES))
    by_family = {
        name: [
            case.curve
            for case in all_cases()
            if case.family == name and (dimension is None or case.curve.dimension == dimension)
        ]
        for name in names
    }
    found = [strategies.sampled_from(curves) for curves in by_family.values() if curves]
    if not found:
        raise CurveFileError(f"no curve in R{dimension} in {', '.join(names)}", remedy="take 2 or 3")
    return strategies.one_of(found)


def near_cusps() -> SearchStrategy[Nurbs]:
    """Plane cubics at a distance ε = ±2⁻ᵏ from a cubic with a cusp.

    >>> from hypothesis import find
    >>> find(near_cusps(), lambda curve: True).control_points[2]
    (mpq(1,4), mpq(1,1))
    """
    return near("cusp")


def near_double_inflections() -> SearchStrategy[Nurbs]:
    """Plane quartics at a distance ε = ±2⁻ᵏ from a quartic with a double inflection (an undulation): two inflections,
    or none.

    >>> from hypothesis import find
    >>> [len(x) for x in find(near_double_inflections(), lambda curve: True).control_points]
    [2, 2, 2, 2, 2]
    """
    return near("undulation")


def near_lines() -> SearchStrategy[Nurbs]:
    """Plane cubics at a distance ε = ±2⁻ᵏ from a straight line."""
    return near("straight")


def near(shape: str) -> SearchStrategy[Nurbs]:
    """Plane curves of one of the `SHAPES`, or of those `FURTHER`, at a distance ε = ±2⁻ᵏ from a degenerate curve;
    reflected, reversed, and scaled by a power of two, so that no number is rounded.

    Raises `CurveFileError`, with the nearest names, for an unknown name.
    """
    from hypothesis import strategies

    shapes = SHAPES | FURTHER
    if shape not in shapes:
        raise CurveFileError(f"there is no shape called {shape!r}", remedy=nearest(shape, shapes))
    flag = strategies.booleans()

    def made(k: int, negative: bool, scale: int, swapped: bool, reversed_: bool) -> Nurbs:
        points: list[Row] = shapes[shape]((-1.0 if negative else 1.0) / (1 << k))
        points = [tuple(c * 2.0**scale for c in (point[::-1] if swapped else point)) for point in points]
        points = points[::-1] if reversed_ else points
        degree = len(points) - 1
        return Nurbs.from_floats(degree, bezier_knots(degree), points, name=f"near {k} {shape}")

    scales: Any = strategies.sampled_from(sorted(SCALES, key=abs))
    return strategies.builds(made, strategies.sampled_from(DIAL), flag, scales, flag, flag)
