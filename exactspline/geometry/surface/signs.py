"""The sign of a form on a whole patch, proved by Bernstein coefficients on parts that grow smaller."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise, product, starmap

from exactspline.geometry.surface.borders import Edge, along, roots_along
from exactspline.numbers.exact import mpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved

#: Boxes and halvings before the remaining boxes are reported as undecided.
BOXES, DEPTH = 4000, 40

Point = tuple[mpq, mpq]


class Sign(StrEnum):
    """What is known of the sign of a function on a closed patch."""

    POSITIVE = "positive"
    NEGATIVE = "negative"
    BOTH = "both signs"
    #: Zero at points that are listed, otherwise of one sign.
    NOT_NEGATIVE = "positive but for single zeros"
    NOT_POSITIVE = "negative but for single zeros"
    ZERO = "zero"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Signs:
    """The sign of a form, points of the unit square at which it is positive and negative (of a form that is not zero
    at least one of them), those found where it is zero, and boxes in which it could not be decided (of a form with both
    signs: none are looked for).
    """

    sign: Sign
    positive: Point | None = None
    negative: Point | None = None
    zeros: tuple[Point, ...] = ()
    undecided: tuple[Box, ...] = ()


def sign_on_patch(form: PatchForm) -> Signs:
    """The sign of a form on the closed unit square.

    >>> sign_on_patch(PatchForm.of_net([[1, -1], [-1, 4]])).sign
    <Sign.BOTH: 'both signs'>
    >>> sign_on_patch(PatchForm.of_net([[1, 0, 0], [0, 0, 0], [0, 0, 1]])).zeros
    ((mpq(0,1), mpq(1,1)), (mpq(1,1), mpq(0,1)))

    A sign is never that of the corners alone:

    >>> found = sign_on_patch(PatchForm.of_net([[0, 1, 0], [1, 1, 1], [0, 1, 0]]))
    >>> found.sign, len(found.zeros), found.negative
    (<Sign.NOT_NEGATIVE: 'positive but for single zeros'>, 4, None)
    """
    if form.is_zero:
        return Signs(Sign.ZERO)
    told = _signs(form, [UNIT])
    if told.sign is Sign.UNDECIDED and len(boxes := _cut(form)) > 1:
        return _signs(form, boxes)
    return told


def _cut(form: PatchForm) -> list[Box]:
    """The unit square cut where the form has rational zeros on its edges: they become corners of boxes."""
    sides: list[list[Interval]] = []
    for direction in (0, 1):
        cuts = {mpq(0), mpq(1)}
        for edge in (Edge(1 - direction, end) for end in (0, 1)):
            if own := along(form, edge, UNIT):
                cuts.update(root.exact for root in roots_along(own, edge, UNIT) if root.exact is not None)
        sides.append(list(starmap(Interval, pairwise(sorted(cuts)))))
    return [Box(first, second) for first in sides[0] for second in sides[1]]


def _signs(form: PatchForm, boxes: Sequence[Box]) -> Signs:
    """The same, beginning with boxes that fill the square."""
    found = dict([_witness(form)])
    zeros: dict[Point, None] = {}
    undecided: list[Box] = []
    todo = deque(Sized(box, [form.part(box)], 0) for box in boxes)
    seen = 0
    while todo:
        part = todo.popleft()
        seen += 1
        own = part.forms[0]
        for value, place in zip(own.corners, product(*part.box), strict=True):
            if value == 0:
                zeros[place] = None
            else:
                found.setdefault(sign_of(value), place)
        sign = own.sign or _sign_but_for_corners(own)
        if sign:
            # where all corners are zeros the inside alone has it
            found.setdefault(sign, part.box.middle)
        if len(found) > 1:
            return Signs(Sign.BOTH, found[1], found[-1])
        if sign:
            continue
        if seen > BOXES or part.depth >= DEPTH:
            undecided.append(part.box)
        else:
            todo.extend(halved(part))
    positive, negative = found.get(1), found.get(-1)
    if undecided:
        return Signs(Sign.UNDECIDED, positive, negative, tuple(zeros), tuple(undecided))
    if zeros:
        sign_told = Sign.NOT_NEGATIVE if positive else Sign.NOT_POSITIVE
    else:
        sign_told = Sign.POSITIVE if positive else Sign.NEGATIVE
    return Signs(sign_told, positive, negative, tuple(sorted(zeros)))


def _witness(form: PatchForm) -> tuple[int, Point]:
    """The sign of a form that is not zero at a point inside at which it is not."""
    (m, n) = form.degree
    # a form of degrees m, n that vanishes at (m + 1)(n + 1) points of a grid is zero
    for i, j in product(range(1, m + 2), range(1, n + 2)):
        place = mpq(i, m + 2), mpq(j, n + 2)
        if value := form.value(*place):
            return sign_of(value), place
    raise AssertionError("the zero form")


def _sign_but_for_corners(form: PatchForm) -> int | None:
    """The sign that the coefficients show on the closed square but for corners that are zero; None where they do not.

    Coefficients of one sign, zeros among them, give a zero in the inside only if all are zero, and one on the open
    edge only if those of the edge are.
    """
    low, high = form.range
    if low < 0 < high or low == high == 0:
        return None
    if not all(any(form.edge(direction, end)) for direction in (0, 1) for end in (0, 1)):
        return None
    return 1 if high > 0 else -1
