"""Singular points of the zero curve of a form, where both its derivatives vanish with it; certified, each in a cell."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from typing import NamedTuple

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, joined
from exactspline.polynomials.common_zeros import Zero, isolate, same
from exactspline.polynomials.patch_forms import PatchForm

#: Refinement limit (bits) for deciding whether the form vanishes at a critical point.
BITS = 256
#: Bits of the cells that are tried.
CELL_BITS = (6, 8, 10, 14, 20, 30, 44)


class Crossing(StrEnum):
    """What the zeros are near a singular point at which the Hessian is regular."""

    POINT = "single point"
    NODE = "two branches that cross"


class Cell(NamedTuple):
    """A box with one singular point, and what the zeros in it are: only that point, or two branches through it."""

    box: Box
    crossing: Crossing
    zero: Zero


def singular_cells(form: PatchForm, known: Sequence[Zero] = ()) -> list[Cell]:
    """Singular points inside the unit square, each in a cell: those that are certified, not necessarily all.

    A critical point is shown to be a zero where it is rational and the form vanishes there, or where it is one of the
    points `known` to be singular. At any other one the subdivision of `ZeroCurve` does not end.

    >>> cells = singular_cells(PatchForm.of_net([[0, 2, 0], [-2, 0, -2], [0, 2, 0]]))
    >>> [cell.crossing.value for cell in cells]
    ['two branches that cross']
    """
    if min(form.degree) == 0:
        return []
    slopes = [form.derivative(k) for k in (0, 1)]
    if any(f.sign is not None for f in slopes):
        return []
    degree = (max(f.degree[0] for f in slopes), max(f.degree[1] for f in slopes))
    critical = isolate(slopes[0].elevated(degree), slopes[1].elevated(degree), [form])
    singular = [zero for zero in critical.zeros if _vanishes(form, zero, known) and zero.refine(16).is_inside(UNIT)]
    while singular:
        cells, failed = _best_cells(form, singular)
        if not failed:
            return cells
        # a point without a cell does not take the cells of the others away
        singular = [zero for zero in singular if not any(zero is other for other in failed)]
    return []


def _best_cells(form: PatchForm, singular: Sequence[Zero]) -> tuple[list[Cell], list[Zero]]:
    """Cells of the size for which most points have a cell, and the points that have none."""
    best: tuple[list[Cell], list[Zero]] | None = None
    for bits in CELL_BITS:
        tried = _cells(form, singular, bits)
        if best is None or len(tried[1]) < len(best[1]):
            best = tried
        if not best[1]:
            break
    assert best is not None
    return best


def _vanishes(form: PatchForm, zero: Zero, known: Sequence[Zero]) -> bool:
    """Whether the form is shown to vanish at a critical point."""
    if any(same(point, zero) for point in known):
        return True
    bits = 16
    while bits <= BITS:
        box = zero.refine(bits)
        if any(b < 0 or a > 1 for a, b in box) or form.part(box).sign in (1, -1):
            return False
        if zero.exact is not None:
            return form.value(*zero.exact) == 0
        bits *= 2
    return False


def _cells(form: PatchForm, singular: Sequence[Zero], bits: int) -> tuple[list[Cell], list[Zero]]:
    """Cells of about this many bits around the singular points, and the points for which this size does not suffice."""
    margin = mpq(1, 1 << bits)
    sides: list[list[Interval]] = []
    for k in (0, 1):
        sides.append(joined(zero.refine(2 * bits)[k].grown(margin) for zero in singular))
    by_box: dict[Box, list[tuple[Zero, Crossing | None]]] = {}
    for zero in singular:
        at = zero.box
        first, second = (next(side for side in own if side.contains(at[k])) for k, own in enumerate(sides))
        box = Box(first, second)
        crossing = _kind(form, box) if zero.region.contains(box) and box.is_inside(UNIT) else None
        by_box.setdefault(box, []).append((zero, crossing))
    cells, failed = list[Cell](), list[Zero]()
    for box, members in by_box.items():
        (zero, crossing), *others = members
        if crossing is None or others:
            failed += [member for member, _ in members]
        else:
            cells.append(Cell(box, crossing, zero))
    return cells, failed


def _kind(form: PatchForm, box: Box) -> Crossing | None:
    """What the zeros in a cell are, when its only critical point is one of them.

    Where the Hessian is definite on the whole cell the form is convex or concave, and has no other zero. Where it is
    indefinite four half branches leave the point; none can come back, since a loop would be around another critical
    point, so that four zeros on the border are their ends, and nothing else is in the cell.
    """
    own = form.part(box)
    second = {(i, j): own.derivative(i).derivative(j) for i, j in ((0, 0), (0, 1), (1, 1))}
    (a, b), (c, d), (e, f) = (second[key].range for key in ((0, 0), (0, 1), (1, 1)))
    products = [x * y for x in (a, b) for y in (e, f)]
    squares = [c * c, d * d] + [c * 0] * (c <= 0 <= d)
    if min(products) > max(squares) and (a > 0 or b < 0):
        return Crossing.POINT
    if max(products) < min(squares):
        return Crossing.NODE
    return None
