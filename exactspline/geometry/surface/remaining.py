"""What boxes do not decide: multiple zeros, zeros on borders of boxes, and whether another form vanishes there too.

Elimination finds all common zeros in the boxes, in the parameters of the surface.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from exactspline.errors import ReachError
from exactspline.geometry.surface.forms import Patch
from exactspline.geometry.surface.places import Place
from exactspline.numbers.intervals import Box
from exactspline.polynomials.common_zeros import Zero
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import over
from exactspline.roots.common_zeros import CommonZero, common_zeros


class Remaining(NamedTuple):
    """The zeros in boxes that were undecided, and the boxes for which elimination is out of reach."""

    zeros: list[CommonZero]
    undecided: list[Box]


def remaining_zeros(
    forms: Sequence[PatchForm], boxes: Sequence[Box], sides: Box, known: Sequence[Zero] = ()
) -> Remaining:
    """The common zeros of forms without a common factor strictly inside a patch with these sides, in boxes of the unit
    square; without those that are already `known`, all of two of these forms.
    """
    if not boxes:
        return Remaining([], [])
    try:
        with drawing_on(Budget()):
            found = common_zeros([over(f, sides) for f in forms], sides, [sides.part(box) for box in boxes])
    except ReachError:
        return Remaining([], list(boxes))
    inside = [zero for zero in found if all(a < t < b for t, (a, b) in zip(zero.place, sides, strict=True))]
    return Remaining([zero for zero in inside if not any(is_one(zero, other, sides) for other in known)], [])


def is_one(zero: CommonZero, known: Zero, sides: Box) -> bool:
    """Whether a common zero of the forms of another, certified one is that one."""
    digits = 8
    while True:
        box = sides.local(zero.box(digits))
        if known.region.contains(box):
            return True
        if not box.meets(known.box):
            return False
        known.refine(2 * digits)
        digits *= 2


def place_at(zero: CommonZero, patch: Patch) -> Place:
    """The zero as a point of a patch."""
    return Place((patch,), None, *zero.place)


__all__ = ["Remaining", "is_one", "place_at", "remaining_zeros"]
