"""Why a bisector has no surface over a part of its parameters."""

from __future__ import annotations

from exactspline.language.vector import Vector
from exactspline.splines.bspline import BSpline

STILL = "the curve stands still here, and has no normals"
PARALLEL = "the tangents are parallel everywhere, so are the normal planes"
COPLANAR = "the curves lie in one plane, and all three planes of the system are perpendicular to it"
THROUGH = "the curve is straight here and its line passes through the point"
AROUND = "the curve is an arc here of a circle through the point, and all its normals meet in the centre"


def is_zero_on(v: Vector[BSpline], at: int) -> bool:
    """Whether a vector of splines vanishes on all of the segment or patch with this number."""
    return not any(x.numerators[at] for x in v)
