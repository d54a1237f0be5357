"""The values of a quotient of polynomials in two parameters at exact places: exact numbers that are cheap to enclose.
The least value of a quotient on a rectangle, and where it is taken: inside, on edges, at corners, along curves.

Inside a patch the least value is taken at common zeros of both derivatives; those with a value above a known value are
not computed. Along the zeros of a common factor of the derivatives the value is constant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial, reduce
from itertools import pairwise
from typing import NamedTuple, TypeVar

from flint import arb, fmpq_poly, fmpz, fmpz_mat, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.across_borders import Place as SurfacePlace
from exactspline.bivariate.across_borders import Spot, single_places, together
from exactspline.bivariate.borders import EDGES, Patch, along
from exactspline.bivariate.common_zeros import Column, CommonZero, common_zeros, projected, zeros_of
from exactspline.bivariate.zeros import SurfacePart, SurfacePlaces, budget_for, patches_of
from exactspline.errors import ReachError
from exactspline.numbers.exact import lcm, mpq, rational, to_fmpq, to_fmpz
from exactspline.numbers.intervals import UNIT, Box, Interval, ball_around
from exactspline.numbers.once import cached_property
from exactspline.polynomials import two_parameters
from exactspline.polynomials.bernstein import over_common_denominator
from exactspline.polynomials.certified_boxes import only_zero_in
from exactspline.polynomials.cost import drawing_on
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.patch_forms import PatchForm, jets, not_positive_part
from exactspline.polynomials.two_parameters import (
    CONTEXT,
    S,
    T,
    as_form,
    as_polynomial,
    at,
    enclosed,
    in_one,
    polynomial_of,
    rows_of,
)
from exactspline.polynomials.zero_places import FIRST
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, between
from exactspline.roots.of_polynomials import Parameter, Place, as_splines, distinct, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.values import value_at
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline, aligned

# ---- monotone arcs
# The square is cut at the parameter s of every zero on its border and of every zero at which a derivative vanishes.
# Between two cuts the zeros are graphs; rational lines near a cut show at which zero over the cut each graph ends.


class MonotoneArc(NamedTuple):
    """An arc of zeros: its ends, and a point of the arc with one rational parameter."""

    start: Place
    end: Place
    inner: Place


def _monotone_arcs(p: fmpz_mpoly) -> tuple[list[MonotoneArc], list[CommonZero]]:
    """The zeros of an irreducible polynomial: the arcs between points of the border and zeros at which a derivative
    vanishes; and these zeros, including single points. A polynomial in one parameter vanishes along whole lines.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> ((arc,), turning) = _monotone_arcs(2 * S * S - T)
    >>> arc.start, arc.end[0].minimal_polynomial(), arc.end[1], turning
    ((mpq(0,1), mpq(0,1)), [-1, 0, 2], mpq(1,1), [<common zero near 0.000000 and 0.000000>])
    >>> _monotone_arcs((2 * S - 1) ** 2 + (3 * T - 1) ** 2)
    ([], [<common zero near 0.500000 and 0.333333>])

    Raises `ReachError` if this would take too long.
    """
    for k in (0, 1):
        if p.degrees()[1 - k] == 0:
            roots = [exactly(x) for x in roots_in(in_one(p, k), *UNIT[k])]
            ends = [[(x, y) if k == 0 else (y, x) for y in UNIT[1 - k]] for x in roots]
            return [MonotoneArc(start, end, start) for start, end in ends], []
    turning = common_zeros([p, p.derivative(0) * p.derivative(1)], UNIT)
    marks = [*border_pairs(p, UNIT), *(zero.place for zero in turning)]
    cuts = distinct([mpq(0), mpq(1), *(s for s, _ in marks)])
    fibres = [_fibre(p, s) for s in cuts]
    found, open_arcs = list[MonotoneArc](), dict[int, MonotoneArc]()
    for (low, before), (high, behind) in pairwise(zip(cuts, fibres, strict=True)):
        s = between(low, high)
        graphs = [exactly(t) for t in roots_in(at(p, 0, s), *UNIT.second)]
        going_on = dict[int, MonotoneArc]()
        for a, b, t in zip(_ends(p, before, low, high), _ends(p, behind, high, low), graphs, strict=True):
            arc = MonotoneArc(open_arcs[a].start if a in open_arcs else (low, before[a]), (high, behind[b]), (s, t))
            if arc.end in marks:
                found.append(arc)
            else:
                going_on[b] = arc
        open_arcs = going_on
    return found, turning


def _fibre(p: fmpz_mpoly, s: Parameter) -> list[Parameter]:
    """All t in [0, 1] of zeros over a number s, in ascending order."""
    if not isinstance(s, Root):
        return [exactly(t) for t in roots_in(at(p, 0, s), *UNIT.second)]
    column = Column.of([p], fmpz_poly(s.minimal_polynomial()))
    return [t for t in column.candidates if column.contains(s, t)]


def _ends(p: fmpz_mpoly, fibre: Sequence[Parameter], near: Parameter, far: Parameter) -> Iterator[int]:
    """For each graph between two cuts, in ascending order, the number of the zero over the near cut at which it ends.
    This number is read on a line so close to the cut that no graph between the line and the cut crosses a height
    between two of these zeros.
    """
    heights = [between(a, b) for a, b in pairwise(fibre)]
    crossed = [s for t in heights for s in roots_in(at(p, 1, t), *UNIT.first)]
    if near < far:
        line = between(near, min([far, *(s for s in crossed if s > near)]))
    else:
        line = between(max([far, *(s for s in crossed if s < near)]), near)
    return (sum(height < t for height in heights) for t in roots_in(at(p, 0, line), *UNIT.second))


def border_pairs(p: fmpz_mpoly, sides: Box) -> list[Place]:
    """The zeros on the border of a rectangle, each once.

    >>> from exactspline.polynomials.two_parameters import S, T
    >>> border_pairs(S - T, UNIT)
    [(mpq(0,1), mpq(0,1)), (mpq(1,1), mpq(1,1))]
    """
    pairs: list[Place] = []
    for variable in (0, 1):
        for value in sides[variable]:
            for root in roots_in(at(p, variable, value), *sides[1 - variable]):
                place = (value, exactly(root)) if variable == 0 else (exactly(root), value)
                if place not in pairs:
                    pairs.append(place)
    return pairs


V = TypeVar("V")
#: The first number of digits of values, and the number of further digits that are compared, once the values are
#: bounded, before it is decided exactly whether they are equal.
BOUND, TIED = 12, 800
#: The critical points of a quotient, each with two forms of which it is a common zero; the arcs on which the quotient
#: is constant, each with the irreducible polynomial that vanishes there; and the boxes in which there may be more. All
#: are in local parameters.
Critical = tuple[list[tuple[CommonZero, list[PatchForm]]], list[tuple[fmpz_mpoly, MonotoneArc]], list[Box]]


class Quotient:
    """A quotient of polynomials in the local parameters of a patch with these sides, its denominator positive there."""

    def __init__(self, top: fmpz_mpoly, bottom: fmpz_mpoly, sides: Box) -> None:
        self.top, self.bottom, self.sides = top, bottom, sides
        self._lines = dict[tuple[int, mpq], list[fmpq_poly]]()

    @cached_property
    def slopes(self) -> list[fmpz_mpoly]:
        """Both derivatives, up to positive factors."""
        return [self.top.derivative(k) * self.bottom - self.top * self.bottom.derivative(k) for k in (0, 1)]

    def __reduce__(self) -> tuple[object, ...]:
        terms = [{(int(i), int(j)): int(x) for (i, j), x in p.terms()} for p in (self.top, self.bottom)]
        return _quotient_of, (*terms, self.sides)

    @cached_property
    def forms(self) -> list[PatchForm]:
        """Numerator and denominator as forms, up to one positive constant."""
        return two_parameters.as_forms([self.top, self.bottom])

    @cached_property
    def slope_forms(self) -> list[PatchForm]:
        """Both derivatives as forms, up to positive factors."""
        if self.bottom.is_constant():
            return [self.forms[0].derivative(k) for k in (0, 1)]
        return [as_form(p) for p in self.slopes]

    def above(self, bound: mpq) -> fmpz_mpoly:
        """A polynomial that is positive where the value is above a bound."""
        return self.top * to_fmpz(bound.denominator) - self.bottom * to_fmpz(bound.numerator)

    def excess(self, bound: mpq) -> PatchForm:
        """The polynomial `above` as a form on the patch."""
        top, bottom = (form.matrix for form in self.forms)
        return PatchForm(top * to_fmpz(bound.denominator) - bottom * to_fmpz(bound.numerator)).primitive()

    def value(self, s: Parameter, t: Parameter) -> Real:
        """The value at two parameters, one of which is rational."""
        k, known, other = (0, s, t) if not isinstance(s, Root) else (1, t, s)
        assert not isinstance(known, Root)
        if (k, known) not in self._lines:
            x = to_fmpq(known)
            rows = [rows_of(p if k == 0 else p.compose(T, S)) for p in (self.top, self.bottom)]
            self._lines[k, known] = [fmpq_poly([row(x) for row in own]) for own in rows]
        top, bottom = self._lines[k, known]
        if not isinstance(other, Root):
            return Real(rational(top(to_fmpq(other)) / bottom(to_fmpq(other))))
        return _in_one_parameter(top, bottom, mpq(1), other)

    def at(self, zero: CommonZero, pair: Sequence[PatchForm] = ()) -> Real:
        """The value at a common zero of two forms without a common factor, enclosed by boxes and computed exactly on
        demand. The forms may be omitted if the zero is isolated by them.
        """
        place = zero.isolated.exact if zero.isolated else zero.local
        if place is not None and not all(isinstance(x, Root) for x in place):
            return self.value(*place)
        local, pair = zero.on(UNIT), pair or (zero.isolated.forms if zero.isolated else ())
        return InBalls(partial(_near, self, local), partial(_exactly, self, local, tuple(pair)) if pair else None)

    @cached_property
    def shared(self) -> fmpz_mpoly:
        """The common factor of both derivatives."""
        return greatest_common_divisor(self.slopes)

    @cached_property
    def coprime(self) -> list[PatchForm]:
        """The derivatives that are not zero without their common factor."""
        if self.shared.total_degree() == 0 and all(self.slopes):
            return self.slope_forms
        return [as_form(p / self.shared) for p in self.slopes if p]

    def critical(self, bound: mpq) -> Critical:
        """The points inside the patch at which both derivatives, not both identically zero, vanish, unless the value is
        above a bound. Raises `ReachError` if this would take too long.
        """
        rest, factor = self.coprime, as_form(self.shared)
        found = zeros_of(rest, not_positive=[self.excess(bound)])
        points = [(zero, rest) for zero in found.zeros if zero.is_inside and not zero.is_zero_of(factor)]
        arcs = list[tuple[fmpz_mpoly, MonotoneArc]]()
        for base in factorize(self.shared).bases:
            if as_form(base).sign is None:
                own, turning = _monotone_arcs(base)
                pair = [as_form(base), as_form(base.derivative(0) * base.derivative(1))]
                points += [(zero, pair) for zero in turning if zero.is_inside]
                arcs += [(base, arc) for arc in own]
        return points, arcs, found.undecided


def _quotient_of(top: dict[tuple[int, ...], int], bottom: dict[tuple[int, ...], int], sides: Box) -> Quotient:
    """The unpickled quotient."""
    return Quotient(CONTEXT.from_dict(top), CONTEXT.from_dict(bottom), sides)


def quotient_on(patch: Patch, top: TensorSpline, bottom: TensorSpline) -> Quotient:
    """A quotient of functions on a patch; the denominator must be positive.

    >>> t = TensorSpline((1, 1), [0, 0, 2, 2], [0, 0, 1, 1], [[0, 0], [1, 1]])
    >>> quotient_on((0, 0), t, t + 1).value(mpq(1, 2), mpq(1, 2))
    <Real 1/3>
    """
    above, below = polynomials_on(patch, top, bottom)
    return Quotient(above, below, top.patch(*patch))


def polynomials_on(patch: Patch, *functions: TensorSpline) -> list[fmpz_mpoly]:
    """Functions on a patch as polynomials in its local parameters, up to one positive constant."""
    nets = [f.bezier_net(*patch) if min(f.degree) >= 0 else [[mpq(0)]] for f in functions]
    scale = lcm(*[x.denominator for net in nets for row in net for x in row])
    return [polynomial_of(PatchForm.of_net([[int(x * scale) for x in row] for row in net])) for net in nets]


def keep_least(found: list[tuple[Real, V]], digits: int) -> None:
    """Keep in a list only the items with the least number, decided exactly: by increasing numbers of digits, beginning
    with this one, and finally by algebra. Raises `ReachError` if this would take too long; then all items that may have
    the least number are kept.

    >>> found = [(Real(2), "first"), (Real(1), "second"), (Real(1), "third")]
    >>> keep_least(found, 5)
    >>> found
    [(<Real 1>, 'second'), (<Real 1>, 'third')]
    """
    more = 0
    while len(found) > 1 and more <= TIED:
        bounds = [number.enclosure(digits + more) for number, _ in found]
        limit = min(high for _, high in bounds)
        found[:] = [one for one, (low, _) in zip(found, bounds, strict=True) if low <= limit]
        more += more + BOUND
    smallest = min(number for number, _ in found)
    found[:] = [one for one in found if one[0] == smallest]


def _near(of: Quotient, zero: CommonZero, bits: int) -> arb:
    s, t = (ball_around(*side) for side in zero.refine(bits))
    return enclosed(of.top, s, t) / enclosed(of.bottom, s, t)


def _exactly(of: Quotient, zero: CommonZero, pair: Sequence[PatchForm]) -> Real:
    """The value as a function of a number ``z = t + λ s`` whose field contains both parameters."""
    slope, minimal, _, s, _ = projected(zero, *map(as_polynomial, pair))
    modulus, high = fmpq_poly(minimal), mpq(1 + slope)
    sheared = [OverRoot.of(p.compose(T, S - slope * T), modulus) for p in (of.top, of.bottom)]
    top, bottom = (reduce(lambda x, c: (x * s + c) % modulus, reversed(p.coefficients), fmpq_poly([])) for p in sheared)
    roots, bits = roots_in(minimal, mpq(0), high, whole=True), FIRST
    while len(roots) > 1:
        (a, b), (c, d) = zero.refine(bits)
        roots, bits = [z for z in roots if c + slope * a <= z <= d + slope * b], 2 * bits
    return _in_one_parameter(top, bottom, high, exactly(roots[0]))


def _in_one_parameter(top: fmpq_poly, bottom: fmpq_poly, high: mpq, place: Parameter) -> Real:
    """The value of a quotient at a number in [0, high]."""
    whole = over_common_denominator([(f.numer(), f.denom()) for f in (top, bottom)])[0]
    above, below = as_splines(whole, mpq(0), high)
    return value_at(above, below, place)


#: Newton's steps, and the unit of the parameters; the bits of a bound; and how often a part of a patch is narrowed.
NEWTON, ONE, SHORT, LEVELS = 9, 1 << 128, 90, 6

#: A value, and the place where it is taken: a point, or a part all of whose points have the value.
Found = tuple[Real, SurfacePlace | SurfacePart]


def minima(
    top: TensorSpline, bottom: TensorSpline, closed: Callable[[], Sequence[Along]] = tuple
) -> tuple[Real, SurfacePlaces[SurfacePlace]]:
    """The least value of a quotient with a positive denominator, and where it is taken; at knots the limits from all
    sides count as values. `closed` answers in which parameters the two ends are identified.

    >>> knots = [0, 0, 0, 1, 1, 1]
    >>> f = TensorSpline((2, 2), knots, knots, [[2, 0, 2], [0, -2, 0], [2, 0, 2]])  # (2s − 1)² + (2t − 1)²
    >>> value, places = minima(f + 3, f.constant(1))
    >>> value, places[0].exact
    (<Real 3>, (mpq(1,2), mpq(1,2)))

    Raises `ReachError` if this would take too long.
    """
    (f, g), ends = aligned(top, bottom), set[Spot]()
    with drawing_on(budget_for(f)):
        given = [(patch, quotient_on(patch, f, g)) for patch, _ in patches_of(f)]
        corners = [zip(*[form.corners for form in x.forms], strict=True) for _, x in given]
        bound = min(_short(mpq(int(p)) / int(w)) for own in corners for p, w in own)
        lowest = [(patch, x, _descended(x, excess)) for patch, x in given if (excess := x.excess(bound)).sign != 1]
        bound = min(bound, *(_short(value) for _, _, (value, _) in lowest))
        near = [(patch, x, e, at) for patch, x, (_, at) in lowest if (e := x.excess(bound)).sign != 1]
        found = [one for patch, x, excess, _ in near for one in _on_border(patch, x, excess)]
        for patch, x, excess, place in near:
            zeros = _only(x, excess, place)
            whole = _inside(patch, x, bound, ends) if zeros is None and any(x.slopes) else ()
            found += [*whole, *((x.at(zero), SurfacePlace((patch,), zero.on(x.sides))) for zero in zeros or ())]
        keep_least(found, BOUND)
    parts = dict.fromkeys(part for _, part in found if isinstance(part, SurfacePart))
    places, boxes = [x for _, x in found if isinstance(x, SurfacePlace)], [x.sides for x in parts if not x.along_curve]
    groups = single_places(places, boxes, ends, f.domain, () if all(x.is_inside for x in places) else closed())
    return found[0][0], SurfacePlaces(tuple(map(together, groups)), tuple(parts))


def _short(value: mpq) -> mpq:
    """A number of few digits that is not below another one."""
    scale = mpq(2) ** (SHORT + value.denominator.bit_length() - value.numerator.bit_length())
    return mpq(-(-value * scale // 1)) / scale


def _descended(f: Quotient, excess: PatchForm) -> tuple[mpq, list[mpq]]:
    """A value of a quotient, and where: often nearly the least one, by Newton's method on the square from the least of
    its coefficients.
    """
    start = excess.entries.index(excess.range[0])
    place = [ONE * k // max(n, 1) for k, n in zip(divmod(start, excess.degree[1] + 1), excess.degree, strict=True)]
    found = list[tuple[mpq, list[int]]]()
    for _ in range(NEWTON):
        jet, ((w, wt, wtt), (ws, wst, _), (wss, *_)) = jets(f.forms, place, ONE)
        (v, vt, vtt), (vs, vst, _), (vss, *_) = jet
        found.append((mpq(int(v)) / int(w), place))
        slopes, mixed, crossed = [vs * w - v * ws, vt * w - v * wt], vst * w - v * wst, vs * wt - vt * ws
        rows = [[vss * w - v * wss, mixed + crossed], [mixed - crossed, vtt * w - v * wtt]]
        for k in (0, 1):
            if (place[k] == 0 and slopes[k] > 0) or (place[k] == ONE and slopes[k] < 0):
                slopes[k], rows[k] = fmpz(0), [fmpz(k == 0), fmpz(k == 1)]
        (a, b), (c, d) = rows
        if (determinant := a * d - b * c) <= 0 or place in [at for _, at in found[:-1]]:
            break
        steps = b * slopes[1] - d * slopes[0], c * slopes[0] - a * slopes[1]
        place = [min(max(x + int(ONE * y // determinant), 0), ONE) for x, y in zip(place, steps, strict=True)]
    value, place = min(found)
    return value, [mpq(x, ONE) for x in place]


def _line(patch: Patch, sides: Box, direction: int, local: mpq) -> SurfacePart:
    """A line of a patch at a local parameter."""
    return SurfacePart(patch, sides.with_side(direction, Interval.point(sides[direction].at(local))))


def _on_border(patch: Patch, f: Quotient, excess: PatchForm) -> Iterator[Found]:
    """The points of edges at which a quotient may be least, and edges and patches on which it is constant, if the value
    is at most a bound.
    """
    whole = SurfacePart(patch, f.sides)
    rows = ((edge, excess.edge(*edge)) for edge in EDGES)
    kept = [(edge, not_positive_part(PatchForm(fmpz_mat(1, len(row), row)))) for edge, row in rows]
    for edge, (low, high) in ((edge, box.second) for edge, box in kept if box):
        slope = along(f.slope_forms[1 - edge.direction], edge, UNIT)
        part = _line(patch, f.sides, edge.direction, mpq(edge.end)) if any(f.slopes) else whole
        places = distinct([*(x for x in UNIT.first if low <= x <= high), *roots_in(slope, low, high)])
        for local in [edge.place(UNIT, t) for t in places]:
            yield f.value(*local), SurfacePlace((patch,), CommonZero(f.sides, local)) if slope else part


def _inside(patch: Patch, f: Quotient, bound: mpq, ends: set[Spot]) -> Iterator[Found]:
    """The points inside a patch at which a quotient may be least, and curves on which it is constant; the end points of
    these curves are added to `ends`.
    """
    points, arcs, undecided = f.critical(bound)
    if undecided:
        raise ReachError(f"the least value over {f.sides.shortly}", remedy="take a part of the surface (restrict)")
    met = {place for _, arc in arcs for place in (arc.start, arc.end)}
    ends |= {CommonZero(f.sides, place).place for place in met}
    for _, arc in arcs:
        lines = [(k, x) for k, x in enumerate(arc.start) if x == arc.end[k] and not isinstance(x, Root)]
        parts = [_line(patch, f.sides, k, x) for k, x in lines] or [SurfacePart(patch, f.sides, along_curve=True)]
        yield f.value(*arc.inner), parts[0]
    for zero, pair in points:
        if not arcs or zero.local not in met:
            yield f.at(zero, pair), SurfacePlace((patch,), zero.on(f.sides))


def _only(f: Quotient, excess: PatchForm, near: Sequence[mpq]) -> list[CommonZero] | None:
    """The critical point inside of a patch, near a given point, whose value is not above the bound, where boxes show
    that there is at most one; None where they do not.
    """
    box, factor = UNIT, as_form(f.shared)
    for _ in range(LEVELS if all(f.slopes) else 0):
        if (kept := not_positive_part(excess.part(box))) is None:
            return []
        box = box.part(kept)
        if factor.part(box).sign is None:
            continue
        if any(form.part(box).sign for form in f.coprime):
            return []
        if (isolated := only_zero_in(f.coprime, box, near)) is not None:
            return [CommonZero(UNIT, isolated=isolated)] if isolated.box.is_inside(UNIT) else None
    return None
