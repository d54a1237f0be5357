"""Singular points of the zero curve of a form, where both its derivatives vanish with it, each in a cell.

At a node or a single point with a regular Hessian the cell is a box on which the Hessian keeps its kind. Around any
other one, also cusps, tacnodes, and points on the border, it is a box that the curve leaves through the sides left and
right alone, in which it has no vertical tangent but at that point: there every zero on these two sides is the end of
one branch from the point, and nothing else is in the box.

Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
Theoretical Computer Science 2013.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from enum import StrEnum
from math import ceil, floor
from typing import NamedTuple

from flint import fmpz_poly

from exactspline.bivariate.common_zeros import Column, CommonZero, zeros_of
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, joined
from exactspline.polynomials.cost import bounded
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.patch_forms import PatchForm, rounded
from exactspline.polynomials.two_parameters import as_polynomial, at, rows_of
from exactspline.reals.real import real
from exactspline.roots.of_polynomials import Parameter, enclosing, exactly, roots_in

#: Bits of the cells that are tried where the Hessian is regular.
CELL_BITS = (6, 8, 10, 14, 20, 30, 44)
#: The sizes of other boxes that are tried: bits across the curve and along it, the widest first, since branches that
#: touch are near each other at the sides of a narrow one; on narrow patches very narrow ones are wide.
SIZES = sorted(((m, n) for m in (*range(2, 20), 32, 64) for n in (*range(m, 40), 100, 200, 400, 800)), key=sum)


class Crossing(StrEnum):
    """What the zeros are near a singular point."""

    POINT = "single point"
    NODE = "two branches that cross"
    #: Its branches leave the cell through the sides left and right.
    OTHER = "branches to the left and to the right"


class Cell(NamedTuple):
    """A box with one singular point, and what the zeros in it are."""

    box: Box
    crossing: Crossing
    zero: CommonZero

    @property
    def ends(self) -> list[mpq]:
        """The abscissas of the sides through which branches may leave."""
        return [x for x in self.box.first if x != self.zero.s]


def singular_cells(form: PatchForm, known: Sequence[CommonZero] = ()) -> list[Cell]:
    """The singular points on the closed unit square of the zeros of a square-free form, each in a cell; not those for
    which elimination is out of reach, or on a line on which the form vanishes. The points `known` are singular.

    >>> from exactspline.polynomials.two_parameters import S, T, as_form
    >>> [(cell.zero.exact, cell.crossing.name) for cell in singular_cells(as_form((2 * S - 1) ** 3 - (2 * T - 1) ** 2))]
    [((mpq(1,2), mpq(1,2)), 'OTHER')]
    """
    slopes = [form.derivative(k) for k in (0, 1)]
    if any(f.is_zero for f in slopes):
        return []
    found = zeros_of([form, *slopes], known=known)
    regular = _regular_cells(form, [zero for zero in found.zeros if zero.is_inside])
    if len(regular) == len(found.zeros) or found.undecided or rows_of(as_polynomial(form))[2:] == []:
        return regular
    try:
        with bounded():
            return _Cells(form, found.zeros).found() or regular
    except ReachError:
        return regular


# ---- where the Hessian is regular


def _regular_cells(form: PatchForm, singular: list[CommonZero]) -> list[Cell]:
    """Cells of the size for which most points have one."""
    best = list[Cell]()
    for bits in CELL_BITS if singular else ():
        tried = _cells(form, singular, bits)
        if len(tried) > len(best):
            best = tried
        if len(best) == len(singular):
            break
    return best


def _cells(form: PatchForm, singular: Sequence[CommonZero], bits: int) -> list[Cell]:
    """Cells of about this many bits around the singular points for which this size suffices."""
    margin, places = mpq(1, 1 << bits), [zero.refine(2 * bits) for zero in singular]
    sides = [joined(place[k].grown(margin) for place in places) for k in (0, 1)]
    by_box: dict[Box, CommonZero] = {}
    for zero, place in zip(singular, places, strict=True):
        first, second = (next(side for side in own if side.contains(place[k])) for k, own in enumerate(sides))
        by_box[Box(first, second)] = zero
    kinds = [(box, kind_on(form, box) if box.is_inside(UNIT) else None, zero) for box, zero in by_box.items()]
    return [Cell(box, kind, zero) for box, kind, zero in kinds if kind is not None]


def kind_on(form: PatchForm, box: Box) -> Crossing | None:
    """What the zeros in a box around a singular point are; None where its Hessian has no one kind on all of it.

    Where it has, the box has no other critical point: by the mean value theorem, or since the form is strictly convex
    in one parameter and strictly concave in the other.

    Where it is definite the form is convex or concave, and has no other zero. Where it is indefinite all critical
    points in the box are saddles, so that no loop of zeros is in it, which would be around an extremum. Four half
    branches leave the point; if there are only four zeros on the border, they are their ends, and nothing else is in
    the box.
    """
    own = rounded(form, box)
    second = {(i, j): own.derivative(i).derivative(j) for i, j in ((0, 0), (0, 1), (1, 1))}
    (a, b), (c, d), (e, f) = (second[key].range for key in ((0, 0), (0, 1), (1, 1)))
    products = [x * y for x in (a, b) for y in (e, f)]
    squares = [c * c, d * d] + [c * 0] * (c <= 0 <= d)
    if min(products) > max(squares):
        return Crossing.POINT
    return Crossing.NODE if max(products) < min(squares) else None


# ---- any other singular point


class _Cells:
    """The cells of the singular points of one form."""

    def __init__(self, form: PatchForm, points: Sequence[CommonZero]) -> None:
        self.form, self.f, self.points = form, (f := as_polynomial(form)), points
        # all values s above which the curve has a multiple point or a vertical tangent
        critical = [exactly(s) for s in roots_in(discriminant(rows_of(f)), *UNIT.first)]
        # all values t of zeros above singular points
        heights: list[Parameter] = []
        for s in _different(point.s for point in points):
            column = Column.of([f], fmpz_poly(real(s).minimal_polynomial()))
            heights = _different([*heights, *(t for t in column.candidates if column.contains(s, t))])
        #: In each direction the coordinates of the points, and of each the numbers that must not be in its interval.
        self.apart = [
            [(x, [y for y in own if y != x]) for x in _different(point.place[k] for point in points)]
            for k, own in enumerate((critical, heights))
        ]

    def found(self) -> list[Cell]:
        """The cells of the first size that serves for all points."""
        for bits in SIZES:
            cells = list(self._of_size(*bits))
            if len(cells) == len(self.points):
                return cells
        return []

    def _of_size(self, across: int, along: int) -> Iterator[Cell]:
        # points with a number in common share an interval: their cells are cells of one grid
        sides, heights = (
            [(x, interval_around(x, others, bits)) for x, others in own]
            for own, bits in zip(self.apart, (along, across), strict=True)
        )
        for point in self.points:
            first = next(side for s, side in sides if s == point.s)
            second = next(side for t, side in heights if t == point.t)
            if not (first and second and all(self._is_free(first, end, point) for end in second)):
                return
            yield Cell(Box(first, second), Crossing.OTHER, point)

    def _is_free(self, side: Interval, t: mpq, point: CommonZero) -> bool:
        """Whether the curve does not meet a side of a box, or only in the singular point."""
        if point.t != t:
            return self.form.part(Box(side, Interval.point(t))).sign in (1, -1)
        own = at(self.f, 1, t)
        return bool(own) and [exactly(s) for s in roots_in(own, *side)] == [point.s]


def _different(numbers: Iterable[Parameter]) -> list[Parameter]:
    found: list[Parameter] = []
    for x in numbers:
        if x not in found:
            found.append(x)
    return found


def interval_around(t: Parameter, others: Sequence[Parameter], bits: int) -> Interval | None:
    """An interval around a number that has none of the others in it or next to it; its end is an end of the unit
    interval only where that is the number itself.
    """
    width = mpq(1, 1 << bits)
    near, far = enclosing(t, bits // 3 + 1)
    # sides with few digits: those of the interval of a root may have thousands
    low, high = (width * floor(near / width), width * ceil(far / width))
    wide = Interval(low - 3 * width, high + 3 * width)
    if any(wide.low <= x <= wide.high for x in others):
        return None
    if any(wide.low <= end <= wide.high and t != end for end in UNIT.first):
        return None
    return Interval(max(mpq(0), low - width), min(mpq(1), high + width))
