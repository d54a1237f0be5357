"""Whether the denominator of a surface keeps its sign: decided exactly, patch by patch; a zero is reported with its
place.
"""

from __future__ import annotations

from collections import deque
from itertools import product

from exactspline.errors import WeightError
from exactspline.numbers.intervals import UNIT, Box
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved
from exactspline.splines.tensor import TensorSpline

#: Boxes on one patch before the search stops.
BOXES = 4000
#: Halvings until the box of a zero is small enough to be reported.
DEPTH = 16


def check_weight(w: TensorSpline) -> None:
    """Raise `WeightError` unless the denominator has one sign on its closed rectangle, one-sided limits at jumps too.

    The error carries a box (a point where both ends of its sides agree) with a zero in it, or one that is too small to
    be decided; either way it is the ``witness``.
    """
    sign = 0
    for i, j in product(range(len(w.meshes[0])), range(len(w.meshes[1]))):
        form = w.patch_form(i, j)
        found = _sign_or_box(form)
        if not isinstance(found, int):
            box, certain = found
            raise _zero(w.patch(i, j).part(box), certain)
        if sign and found != sign:
            place = w.patch(i, j)
            raise WeightError(
                f"the denominator w changes sign by a jump into the patch {place}",
                where="weights",
                remedy="w must keep its sign on the domain",
                witness=place,
            )
        sign = found


def _sign_or_box(form: PatchForm) -> int | tuple[Box, bool]:
    """The sign on the closed square, or a box and whether it is certain that a zero is in it."""
    sign = 0
    todo = deque([Sized(UNIT, [form], 0)])
    for _ in range(BOXES):
        if not todo:
            return sign
        part = todo.popleft()
        if place := _zero_at_corners(part):
            return place, True
        sign = 1 if part.forms[0].corners[0] > 0 else -1
        if part.forms[0].sign is None:
            todo.extend(halved(part))
    return todo[0].box, False


def _zero_at_corners(part: Sized) -> Box | None:
    """A corner of a part that is a zero, or a small box between corners of both signs, in which there is one."""
    while True:
        for value, (x, y) in zip(part.forms[0].corners, product(*part.box), strict=True):
            if value == 0:
                return Box.point(x, y)
        if not _crosses(part):
            return None
        if part.depth >= DEPTH:
            return part.box
        # a half has corners of both signs, or a zero among them
        first, second = halved(part)
        part = first if _crosses(first) or 0 in first.forms[0].corners else second


def _crosses(part: Sized) -> bool:
    """Whether the corners have both signs."""
    corners = part.forms[0].corners
    return min(corners) < 0 < max(corners)


def _zero(box: Box, certain: bool) -> WeightError:
    point = all(a == b for a, b in box)
    where = f"at {box}" if point else f"where {box}"
    problem = (
        f"the denominator w has a zero {where}"
        if certain
        else f"the denominator w could not be shown to be without a zero {where}"
    )
    return WeightError(problem, where="weights", remedy="w must keep its sign on the domain", witness=box)
