"""The multiple points of a curve of zeros and their kinds, decided by exact signs and multiplicities.

At a double point the sign of the Hessian distinguishes nodes from isolated points. Where the Hessian is zero, the point
has the type A_μ, and μ is the intersection multiplicity of both derivatives: for an even μ there is one branch, a cusp;
for an odd μ two branches touch, or the point is isolated.

Source: Wall, Singular Points of Plane Curves, Cambridge 2004, §2 (types), §6.3 (Milnor number).
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import reduce
from typing import NamedTuple

from flint import fmpz_mpoly, fmpz_poly

from exactspline.bivariate import common_zeros as elimination
from exactspline.bivariate.common_zeros import Column, CommonZero, zeros_of
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, joined
from exactspline.one_line import one_line
from exactspline.polynomials.cost import bounded
from exactspline.polynomials.elimination import discriminant
from exactspline.polynomials.factors import factorize_square_free, greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm, rounded
from exactspline.polynomials.two_parameters import S, as_polynomial, at, enclosed, jacobian, over, rows_of
from exactspline.reals.real import Real, real
from exactspline.roots.of_polynomials import Parameter, Place, ball, enclosing, exactly, roots_in, sign_of_number
from exactspline.roots.vanishing import vanish_at

# ---- cells
# At a node or a single point with a regular Hessian the cell is a box on which the Hessian keeps its kind. Around any
# other singular point, such as a cusp, a tacnode or a point on the border, the cell is a box that the curve leaves only
# through the left and the right side, and in which it has no vertical tangent except at the point itself. Then every
# zero on these two sides is the end of one branch from the point, and the box contains no other zeros.
#
# Source: Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves,
# Theoretical Computer Science 2013.


#: The bits of the cells that are tried where the Hessian is regular.
CELL_BITS = (6, 8, 10, 14, 20, 30, 44)
#: The sizes of other boxes that are tried: bits across the curve and along it, the widest first, since branches that
#: touch are close to each other at the sides of a narrow box. The last sizes are for patches that are themselves
#: narrow.
SIZES = sorted(((m, n) for m in (*range(2, 20), 32, 64) for n in (*range(m, 40), 100, 200, 400, 800)), key=sum)


class Crossing(StrEnum):
    """The form of the curve near a singular point."""

    POINT = "single point"
    NODE = "two branches that cross"
    #: The branches leave the cell through the left and the right side.
    OTHER = "branches to the left and to the right"


class Cell(NamedTuple):
    """A box with one singular point, and the form of the curve in the box."""

    box: Box
    crossing: Crossing
    zero: CommonZero

    @property
    def ends(self) -> list[mpq]:
        """The abscissas of the sides through which branches may leave."""
        return [x for x in self.box.first if x != self.zero.s]


def singular_cells(form: PatchForm, known: Sequence[CommonZero] = ()) -> list[Cell]:
    """The singular points on the closed unit square of the zeros of a square-free form, each in a cell, except points
    for which elimination takes too much work and points on a line on which the form vanishes. The points `known` are
    singular.

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
    """Cells of the size that suits most points."""
    best = list[Cell]()
    for bits in CELL_BITS if singular else ():
        tried = _cells(form, singular, bits)
        if len(tried) > len(best):
            best = tried
        if len(best) == len(singular):
            break
    return best


def _cells(form: PatchForm, singular: Sequence[CommonZero], bits: int) -> list[Cell]:
    """Cells of about this many bits around the singular points for which this size is small enough."""
    margin, places = mpq(1, 1 << bits), [zero.refine(2 * bits) for zero in singular]
    sides = [joined(place[k].grown(margin) for place in places) for k in (0, 1)]
    by_box: dict[Box, CommonZero] = {}
    for zero, place in zip(singular, places, strict=True):
        first, second = (next(side for side in own if side.contains(place[k])) for k, own in enumerate(sides))
        by_box[Box(first, second)] = zero
    kinds = [(box, kind_on(form, box) if box.is_inside(UNIT) else None, zero) for box, zero in by_box.items()]
    return [Cell(box, kind, zero) for box, kind, zero in kinds if kind is not None]


def kind_on(form: PatchForm, box: Box) -> Crossing | None:
    """The form of the curve in a box around a singular point; None if the Hessian does not have the same kind on the
    whole box.

    If it has, the box contains no other critical point: by the mean value theorem, or because the form is strictly
    convex in one parameter and strictly concave in the other.

    If the Hessian is definite, the form is convex or concave, and has no other zero. If the Hessian is indefinite, all
    critical points in the box are saddles, so that the box contains no loop of zeros, inside which there would be an
    extremum. Four half branches leave the point; if there are only four zeros on the border, these are the ends of the
    branches, and the box contains no other zeros.
    """
    own = rounded(form, box)
    second = {(i, j): own.derivative(i).derivative(j) for i, j in ((0, 0), (0, 1), (1, 1))}
    (a, b), (c, d), (e, f) = (second[key].range for key in ((0, 0), (0, 1), (1, 1)))
    products = [x * y for x in (a, b) for y in (e, f)]
    squares = [c * c, d * d] + [c * 0] * (c <= 0 <= d)
    if min(products) > max(squares):
        return Crossing.POINT
    return Crossing.NODE if max(products) < min(squares) else None


# ---- all other singular points


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
        #: For each direction the coordinates of the points, each with the numbers that must not be in its interval.
        self.apart = [
            [(x, [y for y in own if y != x]) for x in _different(point.place[k] for point in points)]
            for k, own in enumerate((critical, heights))
        ]

    def found(self) -> list[Cell]:
        """The cells of the first size that is suitable for all points."""
        for bits in SIZES:
            cells = list(self._of_size(*bits))
            if len(cells) == len(self.points):
                return cells
        return []

    def _of_size(self, across: int, along: int) -> Iterator[Cell]:
        # points with a common coordinate share an interval: their cells belong to the same grid
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
        """Whether the curve does not meet a side of a box, or meets it only in the singular point."""
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
    """An interval around a number that contains none of the other numbers, and does not end at one; an end of the unit
    interval is an end of this interval only if it is the number itself.
    """
    width = mpq(1, 1 << bits)
    # sides with few digits, because the ends of the interval of a root may have thousands
    near = enclosing(t, bits // 3 + 1).outward(width)
    wide = near.grown(3 * width)
    if any(wide.low <= x <= wide.high for x in others):
        return None
    if any(wide.low <= end <= wide.high and t != end for end in UNIT.first):
        return None
    return near.grown(width).inside(UNIT.first)


class PointKind(StrEnum):
    """The kind of a multiple point."""

    #: Two branches with different tangents.
    NODE = "node"
    #: One branch, which turns back.
    CUSP = "cusp"
    #: Two branches with a common tangent.
    TACNODE = "tacnode"
    #: An isolated point: no other zero of the function is near.
    ISOLATED = "isolated point"
    #: A point of multiplicity three or more.
    MULTIPLE = "multiple point"
    #: A point at a knot that has different kinds on the patches that meet, or where branches of several patches meet.
    KNOT = "at a knot"


@dataclass(frozen=True)
class SingularPoint:
    """A point at which a function (without multiple factors) vanishes with both its derivatives on a patch, or at which
    more than two branches meet at knots.

    `multiplicity` is the multiplicity of the point on the curve: the order of the lowest derivative that is not zero.
    `milnor` is the Milnor number of a double point: 1 for nodes, 2 for ordinary cusps, 3 for ordinary tacnodes. If the
    point has different multiplicities on the patches at a knot, `multiplicity` is the least one (1 if the point is
    simple on a patch), and there is no Milnor number. `patches` are the patches on which the point is a zero.
    """

    first: Real
    second: Real
    kind: PointKind
    multiplicity: int
    milnor: int | None = None
    patches: tuple[tuple[int, int], ...] = field(default=(), compare=False)

    @one_line
    def __repr__(self) -> str:
        times = f", multiplicity {self.multiplicity}" if self.multiplicity > 2 else ""
        return f"<{self.kind} at {self.first.shortly()} and {self.second.shortly()}{times}>"


def singular_on_patch(
    form: PatchForm, sides: Box, single: Container[Place]
) -> Iterator[tuple[Place, PointKind, int, int | None]]:
    """The multiple points of the zeros of a form that is not zero, in the parameters of its sides: their kinds, their
    multiplicities, and the Milnor numbers of double points. `single` are points with no other zero around them.

    Raises `ReachError` if this would take too long.

    >>> from exactspline.numbers.intervals import UNIT
    >>> from exactspline.polynomials.two_parameters import T, as_form
    >>> tacnode = as_form((2 * T - 1) ** 2 - (2 * S - 1) ** 4)
    >>> [(str(kind), k, milnor) for _, kind, k, milnor in singular_on_patch(tacnode, UNIT, ())]
    [('tacnode', 2, 3)]
    """
    powers = factorize_square_free(over(form, sides)).powers
    p = reduce(lambda f, g: f * g, [factor for factor, _ in powers], S * 0 + 1)
    slopes = [p.derivative(k) for k in (0, 1)]
    for zero in elimination.common_zeros([p, *slopes], sides) if all(slopes) else ():
        order = _order(zero, slopes)
        if order > 2:
            yield zero.place, PointKind.ISOLATED if zero.place in single else PointKind.MULTIPLE, order, None
            continue
        yield zero.place, *_double(zero, slopes, zero.place in single)


def _order(zero: elimination.CommonZero, derivatives: Sequence[fmpz_mpoly]) -> int:
    """The order of the lowest derivative that is not zero, given the derivatives of the first order, which are zero."""
    order = 2
    while True:
        derivatives = [derivatives[0].derivative(0), *(f.derivative(1) for f in derivatives)]
        if not vanish_at([f for f in derivatives if f], *zero.place):
            return order
        order += 1


def _double(zero: elimination.CommonZero, slopes: Sequence[fmpz_mpoly], single: bool) -> tuple[PointKind, int, int]:
    f, g = slopes
    hessian = jacobian(f, g)
    if hessian and not vanish_at([hessian], *zero.place):
        return (PointKind.NODE if sign_at_point(hessian, zero) == -1 else PointKind.ISOLATED), 2, 1
    # a common factor of the derivatives is not zero here, since the function is square-free
    common = greatest_common_divisor(slopes)
    milnor = elimination.multiplicity(zero, f / common, g / common)
    if milnor % 2 == 0:
        return PointKind.CUSP, 2, milnor
    return (PointKind.ISOLATED if single else PointKind.TACNODE), 2, milnor


def sign_at_point(p: fmpz_mpoly, zero: elimination.CommonZero) -> int:
    """The sign at a point of a polynomial that is not zero there."""
    return sign_of_number(lambda digits: enclosed(p, *(ball(x, digits) for x in zero.place)))
