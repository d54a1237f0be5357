"""Singular points of the zero curve of a form by elimination: any of them, also cusps, tacnodes, and on the border.

Around each a box is found in which the curve leaves through the sides left and right alone, and has no vertical tangent
but at that point: there every zero on these two sides is the end of one branch from the point, and nothing else is in
the box.

Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
Theoretical Computer Science 2013.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor
from typing import NamedTuple

from flint import fmpz_mpoly

from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.polynomials.common_zeros import Zero
from exactspline.polynomials.cost import Budget, drawing_on
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import as_polynomial, at, rows_of
from exactspline.roots.common_zeros import Column, CommonZero, common_zeros
from exactspline.roots.of_polynomials import Parameter, exactly, roots_in
from exactspline.roots.root import Root

#: The sizes of boxes that are tried: bits across the curve and along it, the widest first, since branches that touch
#: are near each other at the sides of a narrow one.
SIZES = [*sorted(((m, n) for m in range(2, 20) for n in range(m, 40)), key=sum), (32, 64), (64, 200)]


class ExactZero(Zero):
    """A common zero by elimination, with what can be asked of one that is certified by boxes."""

    __slots__ = ("common",)

    def __init__(self, forms: tuple[PatchForm, PatchForm], region: Box, common: CommonZero) -> None:
        super().__init__(forms, region)
        self.common = common

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both coordinates where they are rational."""
        s, t = self.common.place
        return None if isinstance(s, Root) or isinstance(t, Root) else (s, t)

    def refine(self, bits: int) -> Box:
        """A box that contains the zero, with sides of length at most ``2^−bits``."""
        self._box = self.common.box(bits * 30103 // 100000 + 1)
        return self._box


class ExactCell(NamedTuple):
    """A box with one singular point, whose branches leave through the sides left and right."""

    box: Box
    zero: ExactZero

    @property
    def ends(self) -> list[mpq]:
        """The abscissas of the sides through which branches may leave."""
        return [x for x in self.box.first if x != self.zero.common.s]


def exact_cells(form: PatchForm) -> list[ExactCell]:
    """All singular points on the closed unit square of the zeros of a square-free form, each in a cell; none where
    elimination is out of reach, or the form vanishes on a whole line through one of them.

    >>> from exactspline.polynomials.two_parameters import S, T, as_form
    >>> [cell.zero.exact for cell in exact_cells(as_form((2 * S - 1) ** 3 - (2 * T - 1) ** 2))]
    [(mpq(1,2), mpq(1,2))]
    """
    f = as_polynomial(form)
    if min(form.degree) == 0 or int(f.degrees()[1]) < 2:
        return []
    try:
        with drawing_on(Budget()):
            points = common_zeros([f, f.derivative(0), f.derivative(1)], UNIT)
            return _Cells(form, f, points).found() if points else []
    except ReachError:
        return []


class _Cells:
    """The cells of the singular points of one form."""

    def __init__(self, form: PatchForm, f: fmpz_mpoly, points: Sequence[CommonZero]) -> None:
        self.form, self.f, self.points = form, f, points
        # all values s above which the curve has a multiple point or a vertical tangent
        critical = [exactly(s) for s in roots_in(discriminant(rows_of(f)), *UNIT.first)]
        # all values t of zeros above singular points
        heights: list[Parameter] = []
        for point in _once(points):
            column = Column.of([f], point.fibre.minimal)
            own = [t for t in column.candidates(UNIT.second) if column.contains(point.s, t)]
            heights = _different([*heights, *own])
        #: In each direction the coordinates of the points, and of each the numbers that must not be in its interval.
        self.apart = [
            [(x, [y for y in own if y != x]) for x in _different(point.place[k] for point in points)]
            for k, own in enumerate((critical, heights))
        ]

    def found(self) -> list[ExactCell]:
        """The cells of the first size that serves for all points."""
        for bits in SIZES:
            cells = list(self._of_size(*bits))
            if len(cells) == len(self.points):
                return cells
        return []

    def _of_size(self, across: int, along: int) -> Iterator[ExactCell]:
        # points with a number in common share an interval: their cells are cells of one grid
        sides, heights = (
            [(x, _around(x, others, bits)) for x, others in own]
            for own, bits in zip(self.apart, (along, across), strict=True)
        )
        for point in self.points:
            first = next(side for s, side in sides if s == point.s)
            second = next(side for t, side in heights if t == point.t)
            if not (first and second and all(self._is_free(first, end, point) for end in second)):
                return
            box = Box(first, second)
            yield ExactCell(box, ExactZero((self.form, self.form.derivative(1)), box, point))

    def _is_free(self, side: Interval, t: mpq, point: CommonZero) -> bool:
        """Whether the curve does not meet a side of a box, or only in the singular point."""
        if point.t != t:
            return self.form.part(Box(side, Interval.point(t))).sign in (1, -1)
        own = at(self.f, 1, t)
        return bool(own) and [exactly(s) for s in roots_in(own, *side)] == [point.s]


def _once(points: Sequence[CommonZero]) -> Iterator[CommonZero]:
    """One point for each value of s."""
    return (point for k, point in enumerate(points) if k == 0 or points[k - 1].s != point.s)


def _different(numbers: Iterable[Parameter]) -> list[Parameter]:
    found: list[Parameter] = []
    for x in numbers:
        if x not in found:
            found.append(x)
    return found


def _around(t: Parameter, others: Sequence[Parameter], bits: int) -> Interval | None:
    """An interval around a number that has none of the others in it or next to it; its end is an end of the unit
    interval only where that is the number itself.
    """
    width = mpq(1, 1 << bits)
    near, far = t.refine(bits // 3 + 1) if isinstance(t, Root) else Interval.point(t)
    # sides with few digits: those of the interval of a root may have thousands
    low, high = (width * floor(near / width), width * ceil(far / width))
    wide = Interval(low - 3 * width, high + 3 * width)
    if any(wide.low <= x <= wide.high for x in others):
        return None
    if any(wide.low <= end <= wide.high and t != end for end in UNIT.first):
        return None
    return Interval(max(mpq(0), low - width), min(mpq(1), high + width))


__all__ = ["ExactCell", "ExactZero", "exact_cells"]
