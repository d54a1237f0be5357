"""Parts of a curve's domain, and curves of the dimension that a construction needs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise, starmap
from typing import TypeVar

from exactspline.errors import ShapeError
from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval, joined
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.nurbs import Nurbs

C = TypeVar("C", bound=Curve[BSpline])


def part(curve: Nurbs, a: mpq, b: mpq) -> Curve[BSpline]:
    """The curve over [a, b], as operands for formulas."""
    whole = curve.domain == (a, b)
    restricted = Curve(
        curve.p if whole else Vector(*[x.restrict(a, b) for x in curve.p]),
        curve.w if whole else curve.w.restrict(a, b),
        polynomial=curve.polynomial,
    )
    restricted.domain = (a, b)  # type: ignore[attr-defined]  # a plain curve is given its domain, a Nurbs has one
    return restricted


def segments(curve: Curve[BSpline]) -> Iterator[tuple[Interval, Curve[BSpline]]]:
    """The segments of a curve one by one, as operands for formulas, in time linear in their number."""
    breaks = curve.w.breakpoints

    def only(f: BSpline, i: int, mesh: Mesh) -> BSpline:
        return BSpline.from_forms(f.degree, mesh, (), [(f.numerators[i], f.denominators[i])])

    for i, interval in enumerate(starmap(Interval, pairwise(breaks))):
        mesh = Mesh(interval)
        p = Vector(*[only(x, i, mesh) for x in curve.p])
        yield interval, Curve(p, only(curve.w, i, mesh), polynomial=curve.polynomial)


def intervals_where(breaks: Sequence[mpq], holds: Sequence[bool]) -> list[Interval]:
    """The maximal intervals made of segments on which something holds."""
    return joined(interval for interval, here in zip(pairwise(breaks), holds, strict=True) if here)


def plane(curve: C) -> C:
    """The curve itself if it is in the plane; raises `ShapeError` otherwise."""
    if curve.dimension != 2:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this needs a curve in the plane")
    return curve


def space(curve: C) -> C:
    """The curve itself if it is in space; raises `ShapeError` otherwise."""
    if curve.dimension != 3:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this needs a curve in space")
    return curve
