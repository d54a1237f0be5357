"""The proofs that the common zeros of functions of two parameters are complete, and that the zeros of one function and
their topology are complete and right, as JSON data for `exactspline.certificates`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import combinations, pairwise, product
from math import lcm
from operator import attrgetter
from typing import Any

from flint import fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.borders import EDGES
from exactspline.bivariate.common_zeros import Column, CommonZero, Projection, projected
from exactspline.bivariate.singular_points import Cell, Crossing, singular_cells
from exactspline.bivariate.zero_curve import BOXES as BOXES_ON_PATCH
from exactspline.bivariate.zero_curve import grid, is_small, zeros_on_line
from exactspline.bivariate.zero_lines import line_factor
from exactspline.certificates import COMMON_ZEROS, ZERO_CURVES
from exactspline.certificates import certificate as written
from exactspline.certificates.common_zeros import CROSSED, EDGE, ELIMINATED, FIRST, POINT, SECOND
from exactspline.certificates.zero_curves import ACROSS, BRANCHES, NODE, SIGN
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, scalar, text, to_fmpq
from exactspline.numbers.intervals import UNIT, Box, Interval
from exactspline.numbers.once import cached_property
from exactspline.numbers.search import Search
from exactspline.polynomials.certified_boxes import mean_slopes
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import divided_out, factorize_square_free, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.patch_forms import PatchForm, Sized, halved, jacobian_sign
from exactspline.polynomials.two_parameters import (
    S,
    T,
    as_form,
    as_polynomial,
    jacobian,
    lifted,
    polynomial_of,
    rows_of,
)
from exactspline.reals.real import real
from exactspline.roots.of_polynomials import Place, as_splines, enclosing
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at
from exactspline.roots.zero_set import ZeroSet, isolation_data, zeros
from exactspline.splines.tensor import TensorSpline

#: The sizes of regions (bits) that are tried, and the largest number of boxes.
BITS, BOXES = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256), 20_000
#: The largest product of the degrees of two functions whose multiple zeros are proved (a few seconds to check).
DEGREES = 150
#: The bits of the smaller coefficient of a combination of two functions: the first number, in a region with its own
#: bits added; on boxes the second number, too, if the first does not suffice.
SHORT, LONG = 16, 64
REMEDY = "ask for the points; they are exact also without a certificate"

#: A zero of two functions, and the patches on which it was found.
Found = tuple[Place, Iterable[tuple[int, int]]]


def common_zeros_certificate(functions: Sequence[TensorSpline], found: Sequence[Found]) -> dict[str, object]:
    """The certificate of all common zeros of functions on the same mesh, given these zeros and the patches on which
    they lie.

    Raises `ReachError` if there are too many boxes, or if the degrees are too high.
    """

    def proved(patch: tuple[int, int]) -> dict[str, Any]:
        forms = [f.patch_form(*patch) for f in functions]
        degree = max(f.degree[0] for f in forms), max(f.degree[1] for f in forms)
        raised = [form.elevated(degree) for form in forms]
        nets = [[[str(x) for x in row] for row in form.matrix.tolist()] for form in raised]
        return {"functions": nets} | proof_on_patch(raised, patch, functions[0].patch(*patch), found)

    return written(COMMON_ZEROS, on_each_patch(functions[0], proved))


def on_each_patch(function: TensorSpline, proved: Callable[[tuple[int, int]], dict[str, object]]) -> dict[str, object]:
    """The knots in both directions, and the proof for each patch between them, with the indices of the patch."""
    first, second = (range(len(mesh)) for mesh in function.meshes)
    return {
        "knots": [[text(t) for t in mesh.breaks] for mesh in function.meshes],
        "patches": [{"patch": list(patch)} | proved(patch) for patch in product(first, second)],
    }


def proof_on_patch(
    forms: Sequence[PatchForm], patch: tuple[int, int], sides: Box, found: Iterable[Found]
) -> dict[str, object]:
    """The proof that the zeros found on a patch are all common zeros there of forms of one degree.

    Raises `ReachError` if there are too many boxes, or if the degrees are too high.
    """
    zeros = [_ZeroOnPatch(forms, sides, place) for place, own in found if patch in own]
    regions = [zero.region(bits) for zero, bits in zip(zeros, _sizes(zeros), strict=True)]
    return {
        "zeros": [zero.data(region) for zero, region in zip(zeros, regions, strict=True)],
        "boxes": list(_boxes(forms, regions)),
    }


def _sizes(zeros: Sequence[_ZeroOnPatch]) -> list[int]:
    """For each zero the size of the largest suitable region that does not meet the other regions."""
    sizes = [zero.serving(0) for zero in zeros]
    for i, j in combinations(range(len(zeros)), 2):
        while zeros[i].region(sizes[i]).meets(zeros[j].region(sizes[j])):
            for k in (i, j):
                sizes[k] = zeros[k].serving(sizes[k])
    return sizes


@dataclass
class _ZeroOnPatch:
    """A zero on a patch, in the parameters of its unit square."""

    forms: Sequence[PatchForm]
    sides: Box
    place: Place

    @cached_property
    def simple(self) -> tuple[int, int] | None:
        """Two of the functions whose Jacobian is regular here, if the zero can be proved by these two; otherwise
        None.
        """
        if len(self.forms) > 2 and self.exact is None and self.edge is None:
            return None
        polynomials = self.polynomials
        for i, j in combinations(range(len(self.forms)), 2):
            determinant = jacobian(polynomials[i], polynomials[j])
            if determinant and not vanish_at([determinant], *self.local.place):
                return i, j
        return None

    @cached_property
    def local(self) -> CommonZero:
        """The zero in the unit square."""
        return CommonZero(UNIT, CommonZero.at(self.sides, self.place).local)

    @cached_property
    def polynomials(self) -> list[fmpz_mpoly]:
        """The functions, in the parameters of the unit square."""
        return [polynomial_of(f) for f in self.forms]

    @cached_property
    def eliminated(self) -> tuple[Projection, list[list[int]], fmpz_poly]:
        """The projection of a zero that is not simple, the pair of combinations with this common zero, and the other
        factors of their resultant.
        """
        polynomials, k = self.polynomials, 0
        if greatest_common_divisor(polynomials).total_degree() > 0:
            raise ReachError("a certificate of a multiple zero of functions with a common factor", remedy=REMEDY)
        while True:
            pair = [[1] + [0] * (len(polynomials) - 1), [0] + [k**i for i in range(len(polynomials) - 1)]]
            first, second = (sum((c * p for c, p in zip(row, polynomials, strict=True)), S * 0) for row in pair)
            if second and greatest_common_divisor([first, second]).total_degree() == 0:
                break
            k += 1
        if first.total_degree() * second.total_degree() > DEGREES:
            raise ReachError("a certificate of a multiple zero of functions of these degrees", remedy=REMEDY)
        found = projected(self.local, first, second)
        rows = [rows_of(p.compose(T, S - found.slope * T)) for p in (first, second)]
        return found, pair, divided_out(resultant(*rows), found.minimal)

    @cached_property
    def exact(self) -> tuple[mpq, ...] | None:
        """Both parameters if they are rational, otherwise None."""
        known = [x.exact if isinstance(x, Root) else x for x in self.place]
        local = [side.local(x) for side, x in zip(self.sides, known, strict=True) if x is not None]
        return tuple(local) if len(local) == len(known) else None

    @cached_property
    def edge(self) -> tuple[int, int] | None:
        """The edge on which the zero lies, by a direction and an end; None for a zero inside."""
        return next(((k, end) for k, end in EDGES if self.place[k] == self.sides[k][end]), None)

    def region(self, bits: int) -> Box:
        """A box around the zero, about ``2^(1−bits)`` wide, in the square."""
        width, digits = mpq(1, 1 << bits), bits // 3 + 2
        around = []
        for side, x in zip(self.sides, self.place, strict=True):
            more = len(str(int(max(mpq(1), 1 / side.width))))
            middle = side.local(enclosing(x, digits + more).middle)
            middle = mpq((middle / width + mpq(1, 2)) // 1) * width  # few digits
            around.append(Interval(max(mpq(0), middle - width), min(mpq(1), middle + width)))
        return Box(*around)

    def combinations(self, region: Box) -> list[list[int]]:
        """Combinations that are nearly multiples of the distances in both parameters."""
        assert self.simple is not None
        i, j = self.simple
        bits = SHORT + int(1 / region.first.width).bit_length()
        rows = _preconditioning(self.forms[i].part(region), self.forms[j].part(region), bits)
        return [_of_two(row, i, j, len(self.forms)) for row in rows]

    def _pair(self, region: Box) -> list[PatchForm]:
        parts = [f.part(region) for f in self.forms]
        return [_combination(parts, row) for row in self.combinations(region)]

    def serving(self, last: int) -> int:
        """The size of the largest suitable region that is smaller than the last one."""
        for bits in BITS:
            if bits > last and self.serves(bits):
                return bits
        raise ReachError(f"a certificate of a common zero in a region of less than {BITS[-1]} bits", remedy=REMEDY)

    def serves(self, bits: int) -> bool:
        """Whether a region has at most one zero, and the existence of this zero can be proved in it."""
        region = self.region(bits)
        if self.simple is None:
            return self.is_alone(region)
        pair = self._pair(region)
        if not jacobian_sign(*pair):
            return False
        return self.exact is not None or self.edge is not None or self._is_crossed(pair)

    def is_alone(self, region: Box) -> bool:
        """Whether the resultant has no other root in the projection of a region."""
        found, _, rest = self.eliminated
        side = _projected_side(region, found.slope)
        return bool(on_interval(rest, side).sign) and (
            found.minimal.degree() == 1 or _has_one_root(found.minimal, side)
        )

    def _is_crossed(self, pair: Sequence[PatchForm]) -> bool:
        signs = [[_sign(form.edge(k, end)) for end in (0, 1)] for k, form in enumerate(pair)]
        return all(one * other == -1 for one, other in signs)

    def data(self, region: Box) -> dict[str, object]:
        """The region, the combinations, and the proof of existence."""
        data: dict[str, object] = {"region": [[text(x) for x in side] for side in region]}
        if self.simple is None:
            return data | {"by": ELIMINATED} | self.by_elimination(region)
        data["combinations"] = [[str(x) for x in row] for row in self.combinations(region)]
        if self.exact is not None:
            return data | {"by": POINT, "point": [text(x) for x in self.exact]}
        return data | ({"by": CROSSED} if self.edge is None else {"by": EDGE, "edge": list(self.edge)})

    def by_elimination(self, region: Box) -> dict[str, object]:
        """The proof in a region in which the zero `is_alone`."""
        found, pair, _ = self.eliminated
        above, bottom = found.s.numer(), found.s.denom()
        return {
            "slope": str(found.slope),
            "minimal": [str(c) for c in found.minimal.coeffs()],
            "above": [str(c) for c in above.coeffs()],
            "below": str(bottom),
            "pair": [[str(c) for c in row] for row in pair],
            "power": found.power,
            "at": [text(x) for x in self._at(region, found)],
        }

    def _at(self, region: Box, found: Projection) -> Interval:
        """An interval of z on which it is proved that the zero is in its region."""
        minimal = found.minimal
        if minimal.degree() == 1:
            return Interval.point(mpq(-int(minimal[0]), int(minimal[1])))
        side, heights = _projected_side(region, found.slope), [found.s, fmpq_poly([0, 1]) - found.s * found.slope]
        while not all(map(_is_between, heights, region, [side, side])):
            low, high = side
            middle = (low + high) / 2
            first, value = (minimal(to_fmpq(x)) for x in (low, middle))
            side = Interval(low, middle) if first * value < 0 else Interval(middle, high)
        return side


def _projected_side(region: Box, slope: int) -> Interval:
    """The values of ``t + slope s`` on a box."""
    low, high = (t + slope * s for s, t in zip(*region, strict=True))
    return Interval(low, high)


def on_interval(p: fmpz_poly, side: Interval) -> PatchForm:
    """A polynomial in one variable on an interval."""
    return as_form(lifted(p, 0)).part(Box(side, UNIT.second))


def _has_one_root(p: fmpz_poly, side: Interval) -> bool:
    """Whether a polynomial certainly has one root in an interval, by Descartes' rule."""
    values = [x for x in on_interval(p, side).entries if x]
    return (
        sum((a > 0) != (b > 0) for a, b in pairwise(values)) == 1 and p(to_fmpq(side.low)) * p(to_fmpq(side.high)) < 0
    )


def _is_between(p: fmpq_poly, bounds: Interval, side: Interval) -> bool:
    """Whether a polynomial is certainly between two numbers on an interval."""
    below, above = ((p - to_fmpq(bounds.low)).numer(), (p - to_fmpq(bounds.high)).numer())
    return bool(on_interval(below, side).range[0] >= 0 and on_interval(above, side).range[1] <= 0)


def _of_two(row: Sequence[int], i: int, j: int, count: int) -> list[int]:
    """A combination of two functions as a combination of all functions."""
    found = [0] * count
    found[i], found[j] = row
    return found


def _combination(forms: Sequence[PatchForm], coefficients: Sequence[int]) -> PatchForm:
    return PatchForm(scalar([form.matrix for form in forms], coefficients))


def _short(a: Any, b: Any, bits: int) -> list[int]:
    """Two integers in nearly the same ratio, the smaller one of few bits."""
    shift = max(0, min(int(x).bit_length() for x in (a or b, b or a)) - bits)
    return [int(a) >> shift, int(b) >> shift]


def _sign(values: Sequence[Any]) -> int:
    return 1 if min(values) > 0 else -1 if max(values) < 0 else 0


def _boxes(forms: Sequence[PatchForm], regions: Sequence[Box]) -> Iterator[object]:
    """The cuts of boxes, the regions, and the combinations with one sign."""
    search = Search([Sized(UNIT, list(forms))], depth_first=True)
    for part in search:
        if search.seen > BOXES:
            raise ReachError(f"a certificate of more than {BOXES} boxes", remedy=REMEDY)
        k = next((k for k, region in enumerate(regions) if region.contains(part.box)), None)
        if k is not None:
            yield k
            continue
        excluded = next((row for row in _candidates(part.forms) if _combination(part.forms, row).sign), None)
        if excluded is not None:
            yield [str(x) for x in excluded]
            continue
        yield FIRST if part.box.first.width >= part.box.second.width else SECOND
        search.split(halved(part))


def _candidates(forms: Sequence[PatchForm]) -> Iterator[list[int]]:
    """Combinations that may have one sign."""
    count = len(forms)
    yield from ([int(k == i) for k in range(count)] for i in range(count))
    for bits, (i, j) in product((SHORT, LONG), combinations(range(count), 2)):
        for row in _preconditioning(forms[i], forms[j], bits):
            yield _of_two(row, i, j, count)


def _preconditioning(f: PatchForm, g: PatchForm, bits: int) -> list[list[int]]:
    """The rows of the adjugate of the Jacobian, estimated from the corners."""
    (a, b), (c, d) = mean_slopes(f), mean_slopes(g)
    return [_short(d, -b, bits), _short(-c, a, bits)]


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
        tokens = list(self._tokens([Sized(box, [self.form.part(box)]) for box in boxes]))
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
            self.lines[key] = zeros_on_line(self.form, direction, at)
            self.places[key] = [_place(root, 1) for root in self.lines[key].roots]
        return self.lines[key]

    def _tokens(self, boxes: Sequence[Sized]) -> Iterator[object]:
        search, done = Search(boxes, depth_first=True), {cell.box: k for k, cell in enumerate(self.cells)}
        for part in search:
            own = part.forms[0]
            if part.box in done:
                yield done[part.box]
                for k in (0, 1):
                    self._separate(part.box, k)
                continue
            if own.sign is not None:
                yield SIGN
                continue
            direction = own.monotonic
            if direction is not None:
                yield ACROSS[direction]
                self._graph(part.box, direction)
                continue
            if is_small(part.box, self.form) or search.seen > BOXES_ON_PATCH:
                raise ReachError("a certificate of a singular point that is in no cell", remedy=REMEDY)
            yield (FIRST, SECOND)[own.steeper]
            search.split(halved(part, own.steeper))

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
        zero = _ZeroOnPatch(forms, Box(Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1))), cell.zero.local)
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
