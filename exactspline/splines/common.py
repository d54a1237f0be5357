"""Splines brought to one representation: over the same breakpoints, of one degree and continuity."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from exactspline.splines.bernstein import rescaled
from exactspline.splines.bspline import BSpline
from exactspline.splines.tensor import TensorSpline


def with_common_knots(splines: Iterable[BSpline]) -> list[BSpline]:
    """The same functions over one knot vector: all breakpoints, the highest degree, the lowest continuity at each knot.

    Their control points then belong together: coordinates, or coordinates and weights.

    >>> t = BSpline.identity(0, 1)
    >>> [f.control_points for f in with_common_knots([t, t * t])]
    [(mpq(0,1), mpq(1,2), mpq(1,1)), (mpq(0,1), mpq(0,1), mpq(1,1))]

    Raises `DomainError` when their domains differ.
    """
    splines = list(splines)
    common = splines[0] * 0
    for f in splines[1:]:
        common = common + f * 0
    return [f + common for f in splines]


def with_common_nets(splines: Iterable[TensorSpline]) -> list[TensorSpline]:
    """As `with_common_knots`, of splines in two parameters."""
    splines = list(splines)
    common = splines[0] * 0
    for f in splines[1:]:
        common = common + f * 0
    return [f + common for f in splines]


def with_common_denominators(splines: Sequence[BSpline]) -> list[BSpline]:
    """The components of one curve over one mesh and, segment by segment, over one denominator, so that sums stay
    cheap; their knots and control points as they are.
    """
    first = splines[0]
    columns = []
    for forms in zip(*[f.forms for f in splines], strict=True):
        common = forms[0][1]
        for _, m in forms[1:]:
            common = common * (m // common.gcd(m))
        columns.append([rescaled(form, common) for form in forms])
    return [f.over_forms(first.mesh, forms) for f, forms in zip(splines, zip(*columns, strict=True), strict=True)]
