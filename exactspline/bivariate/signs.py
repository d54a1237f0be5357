"""The sign of a form on a whole patch, proved by Bernstein coefficients on smaller and smaller parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise, product, starmap

from exactspline.bivariate.borders import Edge, along, roots_along
from exactspline.numbers.exact import mpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.numbers.search import Search
from exactspline.one_line import OneLine
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved

#: The numbers of boxes and of halvings after which the remaining boxes are reported as undecided.
BOXES, DEPTH = 4000, 80

Point = tuple[mpq, mpq]


class Sign(StrEnum):
    """The sign of a function on a closed patch, as far as it is known."""

    POSITIVE = "positive"
    NEGATIVE = "negative"
    BOTH = "both signs"
    #: Zero at the listed points, otherwise of one sign.
    NOT_NEGATIVE = "positive except at single zeros"
    NOT_POSITIVE = "negative except at single zeros"
    ZERO = "zero"
    UNDECIDED = "undecided"


@dataclass(frozen=True, repr=False)
class Signs(OneLine):
    """The sign of a form, a point of the unit square at which it is positive and one at which it is negative (at least
    one of the two exists for a nonzero form), and the zeros found.
    """

    sign: Sign
    positive: Point | None = None
    negative: Point | None = None
    zeros: tuple[Point, ...] = ()


def sign_on_patch(form: PatchForm) -> Signs:
    """The sign of a form on the closed unit square.

    >>> sign_on_patch(PatchForm.of_net([[1, -1], [-1, 4]])).sign
    <Sign.BOTH: 'both signs'>
    >>> sign_on_patch(PatchForm.of_net([[1, 0, 0], [0, 0, 0], [0, 0, 1]])).zeros
    ((mpq(0,1), mpq(1,1)), (mpq(1,1), mpq(0,1)))

    The sign at the corners alone never decides:

    >>> signs = sign_on_patch(PatchForm.of_net([[0, 1, 0], [1, 1, 1], [0, 1, 0]]))
    >>> signs.sign, len(signs.zeros), signs.negative
    (<Sign.NOT_NEGATIVE: 'positive except at single zeros'>, 4, None)
    """
    if form.is_zero:
        return Signs(Sign.ZERO)
    answer = _signs(form, [UNIT])
    if answer.sign is Sign.UNDECIDED and len(boxes := _cut(form)) > 1:
        return _signs(form, boxes)
    return answer


def _cut(form: PatchForm) -> list[Box]:
    """The unit square, cut where the form has rational zeros on its edges, so that they become corners of boxes."""
    sides: list[list[Interval]] = []
    for direction in (0, 1):
        cuts = {mpq(0), mpq(1)}
        for edge in (Edge(1 - direction, end) for end in (0, 1)):
            if own := along(form, edge, UNIT):
                cuts.update(root.exact for root in roots_along(own, edge, UNIT) if root.exact is not None)
        sides.append(list(starmap(Interval, pairwise(sorted(cuts)))))
    return [Box(first, second) for first in sides[0] for second in sides[1]]


def _signs(form: PatchForm, boxes: Sequence[Box]) -> Signs:
    """The sign of a form on the square, beginning with boxes that fill the square."""
    witnesses = dict([_witness(form)])
    zeros: dict[Point, None] = {}
    search = Search(Sized(box, [form.part(box)]) for box in boxes)
    for part in search:
        own = part.forms[0]
        for value, place in zip(own.corners, product(*part.box), strict=True):
            if value == 0:
                zeros[place] = None
            else:
                witnesses.setdefault(sign_of(value), place)
        sign = own.sign or _sign_but_for_corners(own)
        if sign:
            # where all corners are zeros, only the interior shows the sign
            witnesses.setdefault(sign, part.box.middle)
        if len(witnesses) > 1:
            return Signs(Sign.BOTH, witnesses[1], witnesses[-1])
        if not sign:
            allowed = search.seen <= BOXES and search.depth < DEPTH
            search.split(halved(part, own.steeper) if allowed else None)
    positive, negative = witnesses.get(1), witnesses.get(-1)
    if search.open:
        return Signs(Sign.UNDECIDED, positive, negative, tuple(zeros))
    shown = (Sign.NOT_NEGATIVE, Sign.NOT_POSITIVE) if zeros else (Sign.POSITIVE, Sign.NEGATIVE)
    return Signs(shown[not positive], positive, negative, tuple(sorted(zeros)))


def _witness(form: PatchForm) -> tuple[int, Point]:
    """The sign of a nonzero form at some inner point at which it does not vanish, and that point."""
    (m, n) = form.degree
    # a form of degrees m, n that vanishes at (m + 1)(n + 1) points of a grid is zero
    for i, j in product(range(1, m + 2), range(1, n + 2)):
        place = mpq(i, m + 2), mpq(j, n + 2)
        if value := form.value(*place):
            return sign_of(value), place
    raise AssertionError("the zero form")


def _sign_but_for_corners(form: PatchForm) -> int | None:
    """The sign that the coefficients prove on the closed square, except at corners that are zero; None if they prove no
    sign.

    If no two coefficients have opposite signs, the form has an inner zero only if all coefficients are zero, and a zero
    on an open edge only if all coefficients of the edge are zero.
    """
    low, high = form.range
    if low < 0 < high or low == high == 0:
        return None
    if not all(any(form.edge(direction, end)) for direction in (0, 1) for end in (0, 1)):
        return None
    return 1 if high > 0 else -1
