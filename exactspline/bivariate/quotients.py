"""The values of a quotient of polynomials in two parameters at exact places: exact numbers that are cheap to
enclose.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial, reduce
from itertools import pairwise
from typing import NamedTuple, TypeVar

from flint import arb, fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.borders import Patch
from exactspline.bivariate.common_zeros import Column, CommonZero, common_zeros, projected, zeros_of
from exactspline.numbers.exact import lcm, mpq, rational, to_fmpq, to_fmpz
from exactspline.numbers.intervals import UNIT, Box, ball_around
from exactspline.numbers.once import cached_property
from exactspline.polynomials import two_parameters
from exactspline.polynomials.bernstein import over_common_denominator
from exactspline.polynomials.factors import factorize, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.patch_forms import PatchForm, powers_of
from exactspline.polynomials.two_parameters import CONTEXT, S, T, as_form, as_polynomial, at, enclosed, in_one, rows_of
from exactspline.polynomials.zero_places import FIRST
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, between
from exactspline.roots.of_polynomials import Parameter, Place, as_splines, distinct, exactly, roots_in
from exactspline.roots.root import Root
from exactspline.roots.values import value_at
from exactspline.splines.tensor import TensorSpline

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
    forms = [PatchForm.of_net([[int(x * scale) for x in row] for row in net]) for net in nets]
    rows = [enumerate(powers_of(form)) for form in forms]
    return [CONTEXT.from_dict({(i, j): x for i, row in own for j, x in enumerate(row) if x}) for own in rows]


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
