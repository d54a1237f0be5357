"""All common zeros of polynomials in two parameters on a rectangle: simple and multiple, irrational, and on the border.

Boxes are used first: they exclude zeros, and certify simple zeros. On the border the zeros are zeros of polynomials in
one parameter. All other cases are decided by elimination: the values s of all common zeros are roots of a resultant,
and over the field of each root s the values t are the zeros of a greatest common divisor. Nothing is decided by digits:
boxes exclude, and changes of an exact sign prove.

Source: Mourrain and Pavone, Subdivision methods for solving polynomial equations, Journal of Symbolic Computation 2009;
Berberich, Emeliyanenko, Kobel and Sagraloff, Exact symbolic-numeric computation of planar algebraic curves, Theoretical
Computer Science 2013 (the two steps of elimination: projection and fibres).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial, reduce
from itertools import pairwise
from math import floor
from typing import NamedTuple

from flint import arb, arb_poly, ctx, fmpq_poly, fmpz_mpoly, fmpz_poly

from exactspline.bivariate.borders import EDGES, common_along, roots_along
from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import UNIT, Box, Interval, ball_around, shifted
from exactspline.numbers.once import cached_property
from exactspline.one_line import OneLine, one_line
from exactspline.polynomials.certified_boxes import Isolated, isolate
from exactspline.polynomials.cost import Priced, bounded, check_reach
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import factorize, factorize_square_free, greatest_common_divisor
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.patch_forms import PatchForm, rounded
from exactspline.polynomials.two_parameters import S, T, as_form, as_polynomial, jacobian, lifted, rows_of
from exactspline.reals.ball import InBalls
from exactspline.reals.real import Real, real
from exactspline.roots.of_polynomials import Parameter, Place, ball, enclosing, exactly, roots_in, sign_of_number
from exactspline.roots.root import Root
from exactspline.roots.vanishing import vanish_at

#: The number of resultants whose common roots are taken, for more than two polynomials.
ELIMINANTS = 2
#: Nanoseconds, per square of the degree and per bit, to isolate roots on an interval as small as boxes are (measured up
#: to 11).
SUBDIVISION = 12
#: The product of the degrees of a form up to which resultants are computed before simple rational numbers are tried.
FEW = 9
#: The first precision (decimal digits) at which a sign is tried, and the precision of a number over which forms are
#: considered.
DIGITS, OVER = 15, 60
#: The bits to which a zero is refined before it is decided exactly whether another form vanishes there, or whether two
#: zeros are equal; and the bits tried where most forms do not vanish.
BITS, TRIED = 400, (10, 20, 40, 80)


class CommonZero:
    """A common zero of forms on the unit square, in the parameters of a patch with these `sides`: two real numbers,
    each rational or a certified root; if the zero is certified in a box (`isolated`), they are computed on demand.
    """

    __slots__ = ("_local", "_place", "isolated", "sides")

    def __init__(
        self, sides: Box, local: Place | None = None, isolated: Isolated | None = None, place: Place | None = None
    ) -> None:
        self.sides, self._local, self.isolated, self._place = sides, local, isolated, place

    def __reduce__(self) -> tuple[object, ...]:
        return CommonZero, (self.sides, self._local, self.isolated, self._place)

    @one_line
    def __repr__(self) -> str:
        s, t = (shifted(floor(x * 10**6 + mpq(1, 2)), 6) for x in self.box(9).middle)
        return f"<common zero near {s} and {t}>"

    @classmethod
    def at(cls, sides: Box, place: tuple[Parameter, Parameter]) -> CommonZero:
        """A point of a patch with known parameters."""
        return cls(sides, place=(exactly(place[0]), exactly(place[1])))

    def on(self, sides: Box) -> CommonZero:
        """The same point of the unit square, as a point of a patch with these sides."""
        return CommonZero(sides, self._local, self.isolated)

    @property
    def local(self) -> Place:
        """Both numbers as local parameters. Raises `ReachError` if computing them would take too long."""
        if self._local is None:
            if self._place is not None:
                inverse = [Interval(side.local(mpq(0)), side.local(mpq(1))) for side in self.sides]
                self._local = _moved(self._place, inverse)
            else:
                assert self.isolated is not None
                self._local = _numbers(self.isolated, self.isolated.forms)
                assert self._local is not None, "both forms vanish there"
        return self._local

    @property
    def place(self) -> Place:
        """Both numbers. Raises `ReachError` if computing them would take too long."""
        if self._place is None:
            self._place = _moved(self.local, self.sides)
        return self._place

    @property
    def s(self) -> Parameter:
        """The first number; the second is not computed."""
        return self._number(0)

    @property
    def t(self) -> Parameter:
        """The second number; the first is not computed."""
        return self._number(1)

    def _number(self, k: int) -> Parameter:
        if self._local is None and self._place is None and self.isolated is not None:
            own = _number(self.isolated, self.isolated.forms, k)
            assert own is not None, "both forms vanish there"
            return _moved_to(self.sides[k], own)
        return self.place[k]

    @property
    def numbers(self) -> tuple[Real, Real]:
        """Both numbers as real numbers, which are enclosed by boxes and computed exactly on demand."""
        if (exact := self.exact) is not None:
            return Real(exact[0]), Real(exact[1])
        first, second = (InBalls(partial(_ball, self, k), partial(_real, self, k)) for k in (0, 1))
        return first, second

    @property
    def exact(self) -> tuple[mpq, mpq] | None:
        """Both numbers if they are known to be rational, otherwise None."""
        if self.isolated is not None:
            found = self.isolated.exact
            return None if found is None else self.sides.at(*found)
        s, t = map(exactly, self.place)
        return None if isinstance(s, Root) or isinstance(t, Root) else (s, t)

    @property
    def is_inside(self) -> bool:
        """Whether the zero is not on the border of its patch."""
        if self.isolated is not None:
            return True
        numbers, sides = (self._local, UNIT) if self._place is None else (self._place, self.sides)
        assert numbers is not None
        return all(low < x < high for x, (low, high) in zip(numbers, sides, strict=True))

    def refine(self, bits: int) -> Box:
        """A box of local parameters that contains the zero, with sides of length at most ``2^−bits``."""
        if self.isolated is not None:
            return self.isolated.refine(bits)
        # with short ends, because the ends of the interval of a root may have thousands of digits
        near, unit = _around(self.local, bits * 30103 // 100000 + 2), mpq(1, 2 << bits)
        first, second = (side.outward(unit) if side.low < side.high else side for side in near)
        return Box(first, second)

    def box(self, digits: int) -> Box:
        """A box that contains the zero, its sides at most ``10^−digits`` long."""
        if self._place is not None:
            return _around(self._place, digits)
        return self.sides.part(self.refine(int(self.sides.longest * mpq(10) ** digits).bit_length()))

    def is_zero_of(self, form: PatchForm) -> bool:
        """Whether a form also vanishes here, decided exactly. Raises `ReachError` if this would take too long."""
        if any(rounded(form, self.refine(bits)).sign in (1, -1) for bits in TRIED):
            return False
        if self.isolated is not None and self.isolated.exact is not None:
            return bool(form.value(*self.isolated.exact) == 0)
        return vanish_at([as_polynomial(form)], *self.local)

    def sign_of(self, form: PatchForm) -> int:
        """The sign of a form here, if a box around the zero shows it; otherwise 0."""
        return next((sign for bits in (*TRIED, BITS) if (sign := rounded(form, self.refine(bits)).sign)), 0)

    def is_in_region_of(self, other: CommonZero) -> bool:
        """Whether this point is the given zero, provided that this point is a zero of the two forms that isolate the
        given zero. False is a proof for any two points.
        """
        bits = 16
        while other.isolated is not None and (box := self.refine(bits)).meets(other.refine(bits)):
            if other.isolated.region.contains(box):
                return True
            bits *= 2
        return False

    def is_at(self, other: CommonZero) -> bool:
        """Whether both are the same point of the same patch, decided exactly. Raises `ReachError` where this would take
        too long.
        """
        if not self.refine(BITS).meets(other.refine(BITS)):
            return False
        return bool(self.local[0] == other.local[0] and self.local[1] == other.local[1])


def _ball(zero: CommonZero, k: int, bits: int) -> arb:
    return ball_around(*zero.sides[k].part(zero.refine(bits)[k]))


def _real(zero: CommonZero, k: int) -> Real:
    return real(zero.t if k else zero.s)


def _around(place: Place, digits: int) -> Box:
    first, second = (enclosing(x, digits) for x in place)
    return Box(first, second)


def _moved(place: Place, sides: Sequence[Interval]) -> Place:
    """Local parameters, converted to those of a patch with these sides."""
    s, t = map(_moved_to, sides, place)
    return s, t


def _moved_to(side: Interval, x: Parameter) -> Parameter:
    return exactly(x.moved(side)) if isinstance(x, Root) else side.at(x)


class Found(NamedTuple):
    """Common zeros, and boxes of local parameters in which there may be more; `reason` is the reason for these
    boxes.
    """

    zeros: list[CommonZero]
    undecided: list[Box]
    reason: ReachError | None = None


def common_zeros(polynomials: Sequence[fmpz_mpoly], sides: Box, also: Sequence[fmpz_mpoly] = ()) -> list[CommonZero]:
    """All common zeros on a closed rectangle of polynomials without a common factor, in order. Zeros at which one of
    the polynomials `also` is certainly not zero are omitted.

    Raises `ReachError` if this would take too long.

    >>> (zero,) = common_zeros([2 * S * S - 1, (S - T) ** 2], UNIT)
    >>> zero.s == zero.t, zero.s.minimal_polynomial()
    (True, [-1, 0, 2])
    """
    forms, others = ([as_form(p).part(sides).primitive() for p in own if p] for own in (polynomials, also))
    found = zeros_of(forms, sides, also=others)
    if found.reason is not None:
        raise found.reason
    return sorted(found.zeros, key=lambda zero: zero.place)


def zeros_of(
    forms: Sequence[PatchForm],
    sides: Box = UNIT,
    *,
    cofactors: Sequence[Sequence[PatchForm]] = (),
    known: Sequence[CommonZero] = (),
    also: Sequence[PatchForm] = (),
    not_positive: Sequence[PatchForm] = (),
) -> Found:
    """All common zeros on the closed unit square of forms that are not zero and have no common factor, as points of a
    patch with these sides.

    A form vanishes where all the other forms vanish and one of its `cofactors` does not. The points `known` are common
    zeros. Zeros at which one of `also` is certainly not zero, or one of `not_positive` is certainly positive, are
    omitted.

    >>> circle = PatchForm.of_net([[-1, -1, 0], [-1, -1, 0], [0, 0, 1]])  # x² + y² − 1
    >>> zeros_of([circle, PatchForm.of_net([[0, -1], [1, 0]])]).zeros
    [<common zero near 0.707107 and 0.707107>]
    """
    if any(f.sign in (1, -1) for f in (*forms, *also)):
        return Found([], [])
    search = _Search(forms, cofactors, known, also)
    with bounded():
        return search.answer(sides, not_positive)


class _Search:
    """The common zeros of some forms."""

    def __init__(
        self,
        forms: Sequence[PatchForm],
        cofactors: Sequence[Sequence[PatchForm]],
        known: Sequence[CommonZero],
        also: Sequence[PatchForm],
    ) -> None:
        self.forms, self.known, self.also = forms, known, also
        self.cofactors = cofactors or [()] * len(forms)
        self.border = list(self._on_border())

    def answer(self, sides: Box, not_positive: Sequence[PatchForm]) -> Found:
        """The zeros, and the undecided boxes."""
        given = [*self.forms, *self.also]
        found, others, reason = isolate(given, not_positive, len(self.also)), list[CommonZero](), None
        if found.undecided:
            try:
                others = self._by_elimination(found.undecided)
                found.undecided.clear()
            except ReachError as error:
                reason = error
                found = isolate(given, not_positive, len(self.also), found)
        inside, undecided = list[CommonZero](), list(found.undecided)
        for isolated in found.zeros:
            zero = CommonZero(UNIT, None, isolated)
            try:
                if self._is_inside(isolated) and self._vanish_at(zero):
                    inside.append(zero)
            except ReachError as error:
                undecided.append(isolated.box)
                reason = error
        inside += [x for x in others if not any(x.is_in_region_of(zero) for zero in inside)]
        zeros = [zero.on(sides) for zero in (*self.border, *inside)]
        excluding = [(f, (1, -1)) for f in self.also] + [(f, (1,)) for f in not_positive]
        kept = [x for x in zeros if not any(x.sign_of(f) in signs for f, signs in excluding)]
        return Found(kept, undecided, reason if undecided else None)

    def _on_border(self) -> Iterator[CommonZero]:
        """The zeros on the border, each once."""
        seen = set[Place]()
        for edge in EDGES:
            for root in roots_along(common_along(self.forms, edge, UNIT), edge, UNIT):
                other = exactly(root)
                place = edge.place(UNIT, other)
                if isinstance(other, Root) or place not in seen:
                    seen.add(place)
                    yield CommonZero(UNIT, place)

    def _is_inside(self, zero: Isolated) -> bool:
        """Whether a certified zero may be a common zero inside; zeros on the border are known already."""
        bits, box = 16, zero.box
        while not box.is_inside(UNIT):
            if any(high < 0 or low > 1 for low, high in box):
                return False
            if any(zero.region.contains(one.refine(bits)) for one in self.border):
                return False
            if any(rounded(f, box).sign in (1, -1) for f in self.forms):
                return False
            bits, box = 2 * bits, zero.refine(bits)
        return True

    def _vanish_at(self, zero: CommonZero) -> bool:
        """Whether all forms vanish at a zero of two of them; raises `ReachError` if this would take too long."""
        isolated = zero.isolated
        assert isolated is not None
        others = [k for k in range(len(self.forms)) if k not in isolated.at]
        bits, box = 8, isolated.box
        while others and bits <= BITS:
            if any(rounded(self.forms[k], box).sign in (1, -1) for k in others):
                return False
            if any(isolated.region.contains(one.refine(bits)) for one in self.known):
                return True
            others = [k for k in others if not any(rounded(e, box).sign in (1, -1) for e in self.cofactors[k])]
            bits, box = 2 * bits, isolated.refine(bits)
        return not others or self._is_of_all(zero)

    def _is_of_all(self, zero: CommonZero) -> bool:
        """Whether all forms vanish at a zero of two of them. Then the zero is the only pair of roots, in its box, of
        the eliminants of all forms, which have a lower degree than the eliminants of the two.
        """
        assert zero.isolated is not None
        place = _numbers(zero.isolated, self.forms)
        if place is None or not vanish_at([as_polynomial(f) for f in self.forms], *place):
            return False
        zero._local = place
        return True

    # ---- elimination

    def _by_elimination(self, boxes: Sequence[Box]) -> list[CommonZero]:
        """All common zeros inside that are in one of the boxes."""
        polynomials = [as_polynomial(f) for f in self.forms]
        if greatest_common_divisor(polynomials).total_degree() > 0:
            raise ReachError("the common zeros of polynomials with a common factor", remedy="divide by it")
        found = list[CommonZero]()
        for minimal, roots in _lines(_eliminant(polynomials), [box.first for box in boxes]):
            column: Column | None = None
            for s in roots:
                sides = [
                    box.second for box in boxes if box.first.low <= s <= box.first.high and self._may_vanish(s, box)
                ]
                if not sides:
                    continue
                column = column or Column.of(polynomials, minimal)
                if any(column.may_be_in(s, side) for side in sides):
                    own = [t for t in column.candidates if any(low <= t <= high for low, high in sides)]
                    found += [CommonZero(UNIT, (s, t)) for t in own if column.contains(s, t)]
        return [zero for zero in found if zero.is_inside]

    def _may_vanish(self, s: Parameter, box: Box) -> bool:
        """Whether all forms may have a zero over a number s in a box."""
        line = Box(enclosing(s, OVER), box.second)
        return not any(rounded(f, line).sign in (1, -1) for f in (*self.forms, *self.also))


def multiplicity(zero: CommonZero, f: fmpz_mpoly, g: fmpz_mpoly) -> int:
    """The intersection multiplicity of two polynomials without a common factor at one of their zeros: as a zero of the
    resultant in ``t + λ s``, for a λ such that no other zero has the same value.

    >>> f, g = S * S - T**3, S - T * T
    >>> [multiplicity(zero, f, g) for zero in common_zeros([f, g], UNIT)]
    [3, 1]
    """
    return projected(zero, f, g).multiplicity if vanish_at([jacobian(f, g)], *zero.place) else 1


class Projection(NamedTuple):
    """A common zero of two polynomials as a root of their resultant in ``z = t + slope s``: the irreducible factor with
    the root z, and its multiplicity; s as a polynomial in z over the field of z; and the power of ``s − s(z)`` that is
    the greatest common divisor there.
    """

    slope: int
    minimal: fmpz_poly
    multiplicity: int
    s: fmpq_poly
    power: int


def projected(zero: CommonZero, f: fmpz_mpoly, g: fmpz_mpoly) -> Projection:
    """A projection of a common zero of polynomials without a common factor such that no other common zero has the same
    z.

    >>> f, g = 2 * S * S - 1, (S - T) ** 2
    >>> projected(common_zeros([f, g], UNIT)[0], f, g)
    Projection(slope=1, minimal=x^2 + (-2), multiplicity=2, s=1/2*x, power=1)

    Raises `ReachError` if this would take too long.
    """
    slope = 0
    while True:
        slope += 1
        sheared = [p.compose(T, S - slope * T) for p in (f, g)]
        rows = [rows_of(p) for p in sheared]
        if all(own[-1].degree() > 0 for own in rows) or any(len(own) == 1 for own in rows):
            continue  # zeros at infinity would be counted; the checker cannot verify a polynomial in z alone
        factor, times = _factor_at(resultant(*rows), zero, slope)
        column = Column.of(sheared, factor)
        if column.zeros.degree == 1:
            return Projection(slope, factor, times, -column.zeros.coefficients[0], column.degree)


def _factor_at(eliminant: fmpz_poly, zero: CommonZero, slope: int) -> tuple[fmpz_poly, int]:
    """The irreducible factor that vanishes at ``t + λ s``, which is a root, and its power."""
    factors, digits = list(factorize(eliminant).powers), DIGITS
    while len(factors) > 1:
        with ctx.workprec(8 * digits + 64):
            value = ball(zero.t, digits) + slope * ball(zero.s, digits)
            factors = [(p, times) for p, times in factors if arb_poly(p)(value).contains(0)]
        digits *= 2
    return factors[0]


# ---- elimination


@dataclass(frozen=True, repr=False)
class Column(OneLine):
    """The common zeros of polynomials over the roots of one irreducible polynomial: these are the zeros of a
    square-free polynomial in t over its field.
    """

    minimal: fmpz_poly
    zeros: OverRoot
    #: The degree of the greatest common divisor, whose zeros may be multiple.
    degree: int

    @classmethod
    def of(cls, polynomials: Sequence[fmpz_mpoly], minimal: fmpz_poly) -> Column:
        """The column of polynomials that do not all vanish on the line. Raises `ReachError` if this would take too
        long.
        """
        modulus = fmpq_poly(minimal)
        common = reduce(lambda p, q: p.gcd(q), [OverRoot.of(p, modulus) for p in polynomials])
        return cls(minimal, common.radical, common.degree)

    @cached_property
    def candidates(self) -> list[Parameter]:
        """The values t in [0, 1] of the zeros over any of the roots, in ascending order; their intervals do not
        meet.
        """
        if self.zeros.degree < 1:
            return []
        (parts,) = by_powers([self.zeros])
        p = sum((lifted(part, 1) * S**k for k, part in enumerate(parts)), S * 0)
        norm = resultant([fmpz_poly([x]) for x in self.minimal.coeffs()], rows_of(p.compose(T, S)))
        numbers = [exactly(t) for t in roots_in(norm, *UNIT.second)]
        for low, high in pairwise(numbers):
            digits = 2
            while enclosing(low, digits).meets(enclosing(high, digits)):
                digits *= 2
        return numbers

    def sign(self, s: Parameter, t: mpq) -> int:
        """The sign of the polynomial over one of the roots at a rational t."""
        return _sign_over(self.zeros(t), s)

    def may_be_in(self, s: Parameter, side: Interval) -> bool:
        """Whether a zero over one of the roots may be in an interval. If the sign changes there is a zero, which is
        decided without the `candidates`.
        """
        return self.zeros.degree > 1 or self.sign(s, side.low) * self.sign(s, side.high) <= 0

    def contains(self, s: Parameter, t: Parameter) -> bool:
        """Whether one of the `candidates` is a zero over one of the roots."""
        if not isinstance(t, Root):
            return self.sign(s, t) == 0
        # a zero in the interval of a candidate is the candidate, and is simple
        digits = 1
        while True:
            before, behind = (self.sign(s, end) for end in t.refine(digits))
            if before and behind:
                return before != behind
            digits *= 2


def _lines(eliminant: fmpz_poly, sides: Sequence[Interval]) -> Iterator[tuple[fmpz_poly, list[Parameter]]]:
    """The irreducible factors of a polynomial that have roots in some intervals, and these roots."""
    whole = Interval(min(side.low for side in sides), max(side.high for side in sides))

    def roots(p: fmpz_poly) -> list[Parameter]:
        cost = SUBDIVISION * p.degree() ** 2 * p.height_bits()
        check_reach(cost, lambda: f"the roots of an eliminant of degree {p.degree()} on a small interval")
        return [exactly(s) for s in roots_in(p, *whole, whole=True) if any(low <= s <= high for low, high in sides)]

    for part, _ in factorize_square_free(eliminant).powers:
        # most square-free parts have no root in the intervals, and need no further factorization
        if roots(part):
            for minimal in factorize(part).bases:
                if own := roots(minimal):
                    yield minimal, own


def _eliminant(polynomials: Sequence[fmpz_mpoly]) -> fmpz_poly:
    """A polynomial in s, not zero, that vanishes at all common zeros."""
    first, *others = sorted(polynomials, key=lambda p: (int(p.degrees()[1]), len(p)))
    rows, found = rows_of(first), list[fmpz_poly]()
    k = 0
    while len(found) < (ELIMINANTS if len(others) > 1 else 1):
        # a factor of the first polynomial divides two of the combinations only if it divides all polynomials
        combined = sum((p * k**i for i, p in enumerate(others)), S * 0)
        eliminant = _without_t(rows, rows_of(combined)) if combined else fmpz_poly([])
        if eliminant:
            found.append(eliminant)
        k += 1
    return greatest_common_divisor(found)


def _without_t(first: list[fmpz_poly], second: list[fmpz_poly]) -> fmpz_poly:
    """The resultant in t. If t does not occur in the polynomials, it is their common divisor instead, because their
    resultant would be 1.
    """
    return greatest_common_divisor([*first, *second]) if len(first) == len(second) == 1 else resultant(first, second)


@lru_cache(maxsize=64)
def _eliminants(k: int, *forms: PatchForm) -> Priced[list[fmpz_poly]]:
    """Square-free polynomials among whose roots are the numbers s (for k = 0), or t, of all isolated common zeros of
    forms.
    """
    return Priced(partial(_eliminated, k, forms))


def _eliminated(k: int, forms: Sequence[PatchForm]) -> list[fmpz_poly]:
    polynomials = [as_polynomial(f) if k == 0 else as_polynomial(f).compose(T, S) for f in forms]
    shared = greatest_common_divisor(polynomials)
    return factorize_square_free(_eliminant([p / shared for p in polynomials])).bases


def _numbers(zero: Isolated, forms: Sequence[PatchForm]) -> Place | None:
    """The two numbers of a zero certified in a box; None proves that the forms do not all vanish there."""
    s, t = (_number(zero, forms, k) for k in (0, 1))
    return None if s is None or t is None else (s, t)


def _number(zero: Isolated, forms: Sequence[PatchForm], k: int) -> Parameter | None:
    """One of the two numbers of a zero certified in a box, as a simple rational number or a root of an eliminant of the
    forms; None proves that the forms do not all vanish there.
    """
    m, n = forms[0].degree
    if (m * n > FEW or not zero.box.longest) and zero.exact is not None:
        return zero.exact[k] if all(f.value(*zero.exact) == 0 for f in forms) else None
    bits, parts = 8, _eliminants(k, *forms).value
    while len(roots := [t for p in parts for t in roots_in(p, *zero.box[k], whole=True)]) > 1:
        bits *= 2
        zero.refine(bits)
    return exactly(roots[0]) if roots else None


def _sign_over(x: fmpq_poly, s: Parameter) -> int:
    """The sign at a number of a polynomial that is reduced modulo the minimal polynomial."""
    if not x:
        return 0
    numerator = x.numer()
    if not isinstance(s, Root):
        return sign_of(numerator(to_fmpq(s)))
    return sign_of_number(lambda digits: arb_poly(numerator)(ball(s, digits)))
