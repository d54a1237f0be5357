"""The proof that the zeros of a function of two parameters and their topology are complete and right, as JSON data for
`exactspline.certificates`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from itertools import pairwise
from math import lcm
from operator import attrgetter
from typing import Any

from flint import fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.common_zeros import Column
from exactspline.bivariate.common_zeros_certificate import (
    BITS,
    DEGREES,
    REMEDY,
    ZeroOnPatch,
    on_each_patch,
    on_interval,
)
from exactspline.bivariate.singular_points import Cell, Crossing, singular_cells
from exactspline.bivariate.zero_curve import BOXES, grid, is_small
from exactspline.bivariate.zero_lines import line_factor
from exactspline.certificates import ZERO_CURVES
from exactspline.certificates import certificate as written
from exactspline.certificates.common_zeros import FIRST, SECOND
from exactspline.certificates.zero_curves import ACROSS, BRANCHES, NODE, POINT, SIGN
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Box, Interval
from exactspline.polynomials.bernstein import ONE, from_integers
from exactspline.polynomials.factors import divided_out, factorize_square_free
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved
from exactspline.polynomials.two_parameters import S, T, as_form, as_polynomial, lifted
from exactspline.reals.real import real
from exactspline.roots.of_polynomials import as_splines, enclosing
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.roots.zero_set import ZeroSet, isolation_data, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor import TensorSpline

KINDS = {Crossing.NODE: NODE, Crossing.POINT: POINT, Crossing.OTHER: BRANCHES}


def zero_curve_certificate(function: TensorSpline) -> dict[str, object]:
    """The certificate of all zeros of a function.

    Raises `ReachError` if the function vanishes on a whole patch, if there are too many boxes, or if a singular point
    is not proved.
    """
    return written(ZERO_CURVES, on_each_patch(function, lambda patch: _patch(function.patch_form(*patch))))


def _patch(form: PatchForm) -> dict[str, Any]:
    if form.is_zero:
        raise ReachError("a certificate of a function that vanishes on a patch", remedy=REMEDY)
    factors, curves, lines = list[dict[str, object]](), list[fmpz_mpoly](), [fmpz_poly([1]), fmpz_poly([1])]
    for factor, power in factorize_square_free(as_polynomial(form)).powers:
        p = factor
        for k in (0, 1):
            if (line := line_factor(as_form(factor), k)).degree() > 0:
                p, lines[k] = p / lifted(line, k), lines[k] * line
                found = zeros(as_splines([line], mpq(0), mpq(1))[0])
                factors.append({"net": _net(as_form(lifted(line, k))), "power": power, "isolation": _isolation(found)})
        if p.total_degree() > 0:
            factors.append({"net": _net(as_form(p)), "power": power})
            curves.append(p)
    rest = as_form(reduce(lambda p, q: p * q, curves, S * 0 + 1))
    return {"function": _net(form), "factors": factors} | _Subdivision(rest, lines).data()


def _net(form: PatchForm) -> list[list[str]]:
    return [[str(x) for x in row] for row in form.matrix.tolist()]


def _isolation(found: ZeroSet) -> dict[str, object]:
    (isolation,) = found.isolations
    assert isolation is not None, "the form does not vanish"
    return isolation_data(isolation)


def _texts(rows: Iterable[Iterable[mpq]]) -> list[list[str]]:
    return [[text(x) for x in row] for row in rows]


class _Subdivision:
    """The boxes of a square-free form without lines of zeros, and whether its single points are on other lines, which
    are given by a polynomial in each parameter.
    """

    def __init__(self, form: PatchForm, others: Sequence[fmpz_poly]) -> None:
        self.form, self.others, self.lines = form, others, dict[tuple[int, mpq], ZeroSet]()
        self.places: dict[tuple[int, mpq], list[Interval]] = {}
        self.cells = singular_cells(form)

    def data(self) -> dict[str, Any]:
        """Cuts, boxes, singular points, and the zeros on all lines that were needed."""
        boxes = list(grid(self.form, [cell.box for cell in self.cells]))
        cuts = [sorted({end for box in boxes for end in box[k]}) for k in (0, 1)]
        tokens = list(self._tokens([Sized(box, [self.form.part(box)], 0) for box in boxes]))
        cells = [self._cell(cell) for cell in self.cells]
        return {
            "cuts": _texts(cuts),
            "boxes": tokens,
            "cells": cells,
            "zeros": [
                [k, text(x), {"isolation": _isolation(self._line(k, x)), "places": _texts(places)}]
                for (k, x), places in self.places.items()
            ],
        }

    def _line(self, direction: int, at: mpq) -> ZeroSet:
        """The zeros on a line across the whole square."""
        key = direction, at
        if key not in self.lines:
            edge = self.form.on_line(direction, at)
            spline = BSpline.from_forms(len(edge) - 1, Mesh([mpq(0), mpq(1)]), (), [(from_integers(edge), ONE)])
            self.lines[key] = zeros(spline)
            self.places[key] = [_place(root, 1) for root in self.lines[key].roots]
        return self.lines[key]

    def _tokens(self, boxes: Sequence[Sized]) -> Iterator[object]:
        todo, done, count = list(boxes[::-1]), {cell.box: k for k, cell in enumerate(self.cells)}, 0
        while todo:
            part, count = todo.pop(), count + 1
            own = part.forms[0]
            if part.box in done:
                yield done[part.box]
                for k in (0, 1):
                    self._separate(part.box, k)
                continue
            if own.sign is not None:
                yield SIGN
                continue
            direction = next((k for k in (0, 1) if own.derivative(k).sign), None)
            if direction is not None:
                yield ACROSS[direction]
                self._graph(part.box, direction)
                continue
            if is_small(part.box, self.form) or count > BOXES:
                raise ReachError("a certificate of a singular point that is in no cell", remedy=REMEDY)
            yield (FIRST, SECOND)[own.steeper]
            todo += reversed(halved(part, own.steeper))

    def _separate(self, box: Box, direction: int) -> list[tuple[tuple[int, mpq], int]]:
        """Refine the zeros on the sides of one direction until it is clear which of them are on the box, and return
        these.
        """
        found = list[tuple[tuple[int, mpq], int]]()
        low, high = box[1 - direction]
        for at in box[direction]:
            roots, key = self._line(direction, at).roots, (direction, at)
            for k, root in enumerate(roots):
                place, digits = self.places[key][k], 1
                while place.low < place.high and any(place.low <= end <= place.high for end in (low, high)):
                    place, digits = min(place, _place(root, digits), key=attrgetter("width")), 2 * digits
                self.places[key][k] = place
                if low <= place.low and place.high <= high:
                    found.append((key, k))
        return found

    def _graph(self, box: Box, direction: int) -> None:
        """Refine the zeros on the sides of a box until their order along the border is clear."""
        self._separate(box, 1 - direction)
        own, digits = self._separate(box, direction), 1
        while True:
            if all(one.high < other.low for one, other in pairwise(sorted(self.places[key][k] for key, k in own))):
                return
            digits *= 2
            for key, k in own:
                own_place = self.places[key][k], _place(self.lines[key].roots[k], digits)
                self.places[key][k] = min(own_place, key=attrgetter("width"))

    # ---- singular points

    def _cell(self, cell: Cell) -> dict[str, Any]:
        data: dict[str, Any] = {"box": _texts(cell.box), "kind": KINDS[cell.crossing]}
        if cell.crossing is Crossing.OTHER:
            return data | self._branches(cell)
        forms = [self.form, *(self.form.derivative(k) for k in (0, 1))]
        zero = ZeroOnPatch(forms, Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1))), cell.zero.local)
        for bits in BITS:
            region = zero.region(bits)
            if cell.box.contains(region) and zero.is_alone(region) and self._is_clear(region, cell):
                return data | {"region": _texts(region), "zero": zero.by_elimination(region)}
        raise ReachError(f"a certificate of a singular point in a region of {BITS[-1]} bits", remedy=REMEDY)

    def _is_clear(self, region: Box, cell: Cell) -> bool:
        """Whether the lines that do not run through a singular point do not meet its region."""
        return all(
            vanish_at([lifted(p, k)], *cell.zero.local) or on_interval(p, side).sign
            for k, (p, side) in enumerate(zip(self.others, region, strict=True))
        )

    def _branches(self, cell: Cell) -> dict[str, Any]:
        """The data over the coordinate x of the point: the factor in y with this zero, and its power."""
        p, (x, y) = as_polynomial(self.form), cell.zero.local
        if int(p.degrees()[1]) * (2 * int(p.degrees()[0]) + int(p.degrees()[1])) > DEGREES:
            raise ReachError("a certificate of a singular point of a function of this degree", remedy=REMEDY)
        minimal = fmpz_poly(real(x).minimal_polynomial())
        whole = OverRoot.of(p, fmpq_poly(minimal))
        factor, power = _part_at(whole, cell, lifted(self.others[1], 1))
        others = divided_out(whole, factor), factor.derivative
        region, digits = Box(enclosing(x, 1), enclosing(y, 1)), 1
        while not (
            cell.box.contains(region)
            and all(_sign_over(f, region.first, cell.box.second) for f in others)
            and self._is_clear(region, cell)
        ):
            digits *= 2
            if digits > BITS[-1]:
                raise ReachError("a certificate of a singular point with another zero close to it", remedy=REMEDY)
            region = Box(enclosing(x, digits), enclosing(y, digits))
        bottom = _denominator(factor)
        return {
            "minimal": [str(c) for c in minimal.coeffs()],
            "region": _texts(region),
            "factor": [[str(c) for c in (row * bottom).numer().coeffs()] for row in factor.coefficients],
            "below": str(bottom),
            "power": power,
        }


def _place(root: Root, digits: int) -> Interval:
    return Interval.point(root.exact) if root.exact is not None else root.refine(digits)


def _sign_over(p: OverRoot, at: Interval, side: Interval) -> int | None:
    """The sign of a polynomial over a root on a box, if its Bernstein coefficients have the same sign."""
    bottom = _denominator(p)
    whole = sum((lifted((row * bottom).numer(), 0) * T**j for j, row in enumerate(p.coefficients)), S * 0)
    return as_form(whole).part(Box(at, side)).sign


def _denominator(p: OverRoot) -> int:
    return lcm(*(int(c.denom()) for c in p.coefficients))


def _part_at(p: OverRoot, cell: Cell, lines: fmpz_mpoly) -> tuple[OverRoot, int]:
    """The multiplicity of the point of a cell, and the monic polynomial whose zeros are the zeros of this multiplicity;
    the point is the only one of these on the second side of the cell. If one of the lines runs through the point, only
    zeros on lines are included.
    """
    on_line = OverRoot.of(lines, p.modulus) if vanish_at([lines], *cell.zero.local) else OverRoot([], p.modulus)
    common, power = p.gcd(p.derivative), 1
    rest = p // common
    while True:
        following = rest.gcd(common)
        part = rest // following
        signs = [Column(fmpz_poly([]), part, 0).sign(cell.zero.local[0], end) for end in cell.box.second]
        if part.degree > 0 and signs[0] * signs[1] <= 0:
            return part.gcd(on_line), power
        rest, common, power = following, common // following, power + 1
