"""Multiple common zeros at rational points: proved to be isolated by blowing them up.

Around such a point put ``x = s, y = s m`` and ``x = s m, y = s``: each polynomial is a power of s times another one. If
the others have no common zero for s and m between −1 and 1 the point is the only one in a square.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpz_mpoly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.common_zeros import SIMPLE, simplest
from exactspline.polynomials.patch_forms import PatchForm, Sized, clusters, halved
from exactspline.polynomials.two_parameters import CONTEXT, S, T, as_form, as_polynomial

#: The limit of boxes in the search for a common zero, and how often the square around the point is halved.
BOXES, TRIES = 2000, 4
#: The square of both charts.
CHART = Box(Interval(mpq(-1), mpq(1)), Interval(mpq(-1), mpq(1)))


class Multiple(NamedTuple):
    """A common zero, and a box around it that holds no other one."""

    place: tuple[mpq, mpq]
    box: Box

    def explains(self, box: Box) -> bool:
        """Whether another box therefore contains no other common zero."""
        return self.box.contains(box)


def multiple_zero(forms: Sequence[PatchForm], boxes: Sequence[Box]) -> Multiple | None:
    """A simple rational common zero near the first of the boxes, alone in a box that contains all boxes next to that
    one; None where none is found.

    >>> forms = [PatchForm.of_net([[1, -1], [-1, 1]])]  # (1 − 2x)(1 − 2y), zero on two lines
    >>> side = Interval(mpq(3, 8), mpq(5, 8))
    >>> multiple_zero(forms, [Box(side, side)])
    >>> forms.append(PatchForm.of_net([[0, -1, 0], [1, 0, 1], [0, -1, 0]]))  # 2x (1 − x) − 2y (1 − y)
    >>> multiple_zero(forms, [Box(side, side)]).place
    (mpq(1,2), mpq(1,2))
    """
    hull = next(hull for hull, own in clusters(boxes) if boxes[0] in own)
    place = simplest(*hull[0]), simplest(*hull[1])
    if max(x.denominator for x in place) > SIMPLE or any(f.value(*place) != 0 for f in forms):
        return None
    radius = max(mpq(1, 1 << 10), *[abs(end - x) for side, x in zip(hull, place, strict=True) for end in side])
    for _ in range(TRIES):
        first, second = (side.grown(radius) for side in Box.point(*place))
        square = Box(first, second)
        parts = [f.part(square) for f in forms]
        if all(_without_common_zero([chart(p, k) for p in parts]) for k in (0, 1)):
            return Multiple(place, square)
        radius *= 2
    return None


def chart(form: PatchForm, which: int) -> PatchForm:
    """A form around the middle of its square in one of the charts, without its power of s."""
    p = as_polynomial(form)
    m, n = (max(int(k), 0) for k in p.degrees())
    # x = (1 + X)/2 and y = (1 + Y)/2, times a power of 2
    scaled = CONTEXT.from_dict({(i, j): x << int(m - i + n - j) for (i, j), x in p.terms()})
    around: fmpz_mpoly = scaled.compose(1 + S, 1 + T)
    blown = around.compose(S, S * T) if which == 0 else around.compose(S * T, S)
    power = min((int(i) for (i, _), _ in blown.terms()), default=0)
    lowered = CONTEXT.from_dict({(int(i) - power, int(j)): x for (i, j), x in blown.terms()})
    return as_form(lowered).part(CHART)


def _without_common_zero(forms: Sequence[PatchForm]) -> bool:
    """Whether forms certainly have no common zero on the closed unit square."""
    todo = deque([Sized(UNIT, list(forms), 0)])
    for _ in range(BOXES):
        if not todo:
            return True
        part = todo.popleft()
        if not any(f.sign for f in part.forms):
            todo.extend(halved(part))
    return False
