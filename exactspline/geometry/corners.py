"""Where a curve has corners, and nothing else about its joints: from the integers of its forms, without derivatives and
angles.
"""

from __future__ import annotations

from typing import NamedTuple

from exactspline.exact import mpq
from exactspline.geometry.analysis import analyse
from exactspline.geometry.joints import end_direction, same_direction
from exactspline.geometry.kinds import JointKind
from exactspline.language.choices import Side
from exactspline.splines.nurbs import Nurbs


class Corner(NamedTuple):
    """A joint at which the direction of the tangent jumps."""

    parameter: mpq
    kind: JointKind


def corner_places(curve: Nurbs) -> list[Corner]:
    """The corners of a curve in the plane or in space, without their angles (see `exactspline.corners`).

    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    >>> [int(corner.parameter) for corner in corner_places(square)]
    [0, 1, 2, 3]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    facts = analyse(curve)
    facts.check_dimension()
    continuity = curve.p[0].continuity
    smooth = [curve.closed - 1, *continuity]
    found = []
    for i in range(0 if curve.closed else 1, curve.segments):
        left, right = end_direction(curve, i - 1, Side.LEFT), end_direction(curve, i, Side.RIGHT)
        if smooth[i] >= 0 and any(left) and any(right):
            if smooth[i] == 0 and not same_direction(left, right):
                found.append(Corner(curve.breakpoints[i], JointKind.CORNER))
        elif (joint := facts.joint(curve.breakpoints[i])) is not None and joint.angle is not None:
            found.append(Corner(joint.parameter, joint.kind))
    return found
