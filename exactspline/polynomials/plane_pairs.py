"""The common points of two plane curves on one segment each, and of a curve and itself: all of them, exactly.

The determinant F of Bézout's matrix of the first curve and a point on the second vanishes at the parameters t of the
second curve that lie on the first. Where the matrix has corank one, its adjugate shows the parameter s of the first;
at multiple points of the first curve the decision is made in the field of t. If F is zero, the curves are arcs of the
same algebraic curve, and ``s = A₀₁/A₀₀`` in lowest terms is the map from the second to the first.

Segments are those of `exactspline.polynomials.bernstein`: parameters are local, from 0 to 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import Enum
from functools import reduce

from flint import arb, arb_mat, arb_poly, ctx, fmpq_poly, fmpz_poly

from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.once import cached_property
from exactspline.polynomials import bezout
from exactspline.polynomials.bernstein import backwards, substituted
from exactspline.polynomials.bezout import Matrix, PlaneForms, across, along
from exactspline.polynomials.common_arcs import (
    Image,
    Local,
    Meeting,
    Meetings,
    RationalMap,
    Rest,
    collinear_arcs,
    common_arcs,
    lowest_terms,
)
from exactspline.polynomials.cost import REMEDY
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.factors import (
    certainly_coprime,
    divided_out,
    factorize_square_free,
    greatest_common_divisor,
)
from exactspline.polynomials.isolation import Isolation, isolate
from exactspline.polynomials.over_root import OverRoot
from exactspline.polynomials.two_parameters import S, T, lifted, rows_of
from exactspline.polynomials.zero_places import FIRST, SUSPICIOUS, Place, at, places

# ---- multiple points


class Fibre:
    """All parameters of the first curve at one point of the second, as zeros of a polynomial over the field of the
    place; parameters given by a map from the second curve to the first are not included.
    """

    def __init__(self, first: PlaneForms, second: PlaneForms, place: Place, carried: RationalMap | None = None) -> None:
        self.place = place
        self.modulus = fmpq_poly([0, 1] if place.exact is not None else place.irreducible)
        x, y, w = (self._element(form, second.degree) for form in second.forms)
        rows = [(first.x, w, first.w, x), (first.y, w, first.w, y), (first.x, y, first.y, x)]
        minors = [p for row in rows if (p := self._minor(*row))]
        common = reduce(lambda p, q: p.gcd(q), minors)
        self.at_end = max(p.degree for p in minors) < first.degree
        if carried is not None:
            common = self._without(common, carried)
        self.at_start = not common.coefficients[0]
        common = OverRoot(common.coefficients[next(i for i, c in enumerate(common.coefficients) if c) :], self.modulus)
        self.polynomial = common.radical

    @property
    def size(self) -> int:
        """The number of parameters, real and complex, each counted once."""
        return self.polynomial.degree + self.at_start + self.at_end

    def _element(self, form: fmpz_poly, n: int) -> fmpq_poly:
        t = self.place.exact
        if t is None:
            return fmpq_poly(form) % self.modulus
        return fmpq_poly([form[n] if t == 1 else form(to_fmpq(t / (1 - t)))])

    def _minor(self, p: fmpz_poly, a: fmpq_poly, q: fmpz_poly, b: fmpq_poly) -> OverRoot:
        return OverRoot([a * p[i] - b * q[i] for i in range(max(p.degree(), q.degree()) + 1)], self.modulus)

    def _without(self, common: OverRoot, carried: RationalMap) -> OverRoot:
        top, bottom = self._element(carried.top, carried.degree), self._element(carried.bottom, carried.degree)
        factor = OverRoot([-top, bottom], self.modulus)
        if factor.degree == 0:
            self.at_end = False
            return common
        return divided_out(common, factor)

    def contains(self, s: Place) -> bool:
        """Whether a parameter belongs to the fibre. All real zeros of the polynomial must be among the zeros from which
        the place was isolated.
        """
        bits = FIRST
        while (t := s.exact) is None:
            low, high = s.refine(bits)
            if low != high < 1:
                before, behind = (self._sign(end / (1 - end)) for end in (low, high))
                if before and behind:
                    return before != behind
            bits *= 2
        if t in (0, 1):
            return self.at_start if t == 0 else self.at_end
        return self._sign(t / (1 - t)) == 0

    def _sign(self, z: mpq) -> int:
        value = self.polynomial(z)
        return self.place.sign(value.numer(), value.degree())


# ---- multiplicity


def local_multiplicity(
    first: PlaneForms, second: PlaneForms, s: Place, t: Place, carried: RationalMap | None = None
) -> int:
    """The intersection multiplicity of two branches at a common point through which both curves may pass several
    times: the multiplicity of the value ``z_t + λ z_s`` as a zero of the resultant. The least multiplicity over
    sufficiently many λ is taken, because for one of them the value differs from the values of all other common zeros. A
    factor that belongs to a map from the second curve to the first is divided out.
    """
    if s.exact == 1:
        first, s = _reversed(first), at(mpq(0))
        carried = carried and RationalMap(carried.degree, carried.bottom, carried.top)
    if t.exact == 1:
        second, t = _reversed(second), at(mpq(0))
        carried = carried and RationalMap(
            carried.degree, backwards(carried.top, carried.degree), backwards(carried.bottom, carried.degree)
        )
    equations = [
        lifted(p, 0) * lifted(second.w, 1) - lifted(first.w, 0) * lifted(q, 1)
        for p, q in zip(first.forms[:2], second.forms[:2], strict=True)
    ]
    if carried is not None:
        factor = S * lifted(carried.bottom, 1) - lifted(carried.top, 1)
        equations = [divided_out(p, factor) for p in equations]
    found = list[int]()
    while True:
        slope = len(found) + 1
        eliminant = resultant(*[rows_of(p.compose(S, T - slope * S).compose(T, S)) for p in equations])
        found.append(multiplicity_of_sum(eliminant, s, t, slope))
        if found[-1] == 1 or slope > eliminant.degree():
            return min(found)


def _reversed(curve: PlaneForms) -> PlaneForms:
    return PlaneForms(curve.degree, *[backwards(form, curve.degree) for form in curve.forms])


def multiplicity_of_sum(eliminant: fmpz_poly, s: Place, t: Place, slope: int) -> int:
    """The multiplicity of the zero ``z_t + λ z_s``."""
    powers, bits = list(factorize_square_free(eliminant).powers), FIRST
    while True:
        with ctx.workprec(4 * bits):
            value = t.z(bits) + s.z(bits) * slope
            possible = [e for g, e in powers if arb_poly(g)(value).contains(0)]
        if len(possible) == 1:
            (only,) = possible
            return only
        bits *= 2


#: From this size of a matrix on, its minors are computed as polynomials only if balls do not decide their signs.
BY_BALLS = 4
#: The map ``z ↦ z``.
IDENTITY = RationalMap(1, fmpz_poly([0, 1]), fmpz_poly([1]))


class _Several(Enum):
    """The answer that there is not exactly one parameter."""

    SEVERAL = 0


SEVERAL = _Several.SEVERAL


def _first_cofactors(matrix: Matrix) -> tuple[fmpz_poly, fmpz_poly, fmpz_poly]:
    """The first row of the adjugate of a symmetric 3 × 3 matrix."""
    (_, b, c), (_, e, f), (_, _, i) = matrix
    return e * i - f * f, c * f - b * i, b * f - c * e


class Elimination:
    """A matrix of forms in t that is singular where a point of the second curve lies on the first, with the vectors of
    the parameters s of the first in its kernel.
    """

    def __init__(self, matrix: Matrix, degree: int) -> None:
        self.matrix, self.size, self.degree = matrix, len(matrix), degree

    @cached_property
    def determinant(self) -> fmpz_poly:
        """F, a form of degree ``size · degree``."""
        if self.size == 3:
            # the cofactors of this matrix are needed, too
            self.first, self.second, third = _first_cofactors(self.matrix)
            a, b, c = self.matrix[0]
            return a * self.first + b * self.second + c * third
        return bezout.determinant(self.matrix, self.degree)

    @property
    def isolation(self) -> Isolation:
        """The zeros of F, which must not be the zero form."""
        return isolate(self.determinant, self.size * self.degree)

    def cofactor(self, i: int, j: int) -> fmpz_poly:
        """An entry of the adjugate, a form of degree ``(size − 1) · degree``."""
        minor = bezout.determinant(bezout.without(self.matrix, i, j), self.degree)
        return -minor if (i + j) % 2 else minor

    @cached_property
    def first(self) -> fmpz_poly:
        """``A₀₀``, which is not zero where there is exactly one parameter s/u and this is finite."""
        return self.cofactor(0, 0)

    @cached_property
    def second(self) -> fmpz_poly:
        """``A₀₁``, which is ``A₀₀ s/u`` where there is exactly one parameter."""
        return self.cofactor(0, 1)

    @cached_property
    def last(self) -> fmpz_poly:
        """The last diagonal entry, which is not zero where there is exactly one parameter and this is not 0."""
        return self.cofactor(self.size - 1, self.size - 1)

    @cached_property
    def map(self) -> RationalMap:
        """The parameter of the first curve as a function of the parameter of the second curve, at zeros of F."""
        return RationalMap((self.size - 1) * self.degree, self.second, self.first)

    def sign(self, entry: str, place: Place) -> int:
        """The sign of an entry of the adjugate, `first`, `second` or `last`, at a place."""
        if self.size >= BY_BALLS and (sign := self._by_balls(entry, place)):
            return sign
        return place.sign(getattr(self, entry), (self.size - 1) * self.degree)

    def _by_balls(self, entry: str, place: Place) -> int:
        """The sign, if balls decide it, else 0."""
        bits = FIRST
        while bits <= SUSPICIOUS and place.exact is None:
            with ctx.workprec(4 * bits):
                if sign := sign_of(self._entry(entry, place.z(bits))):
                    return sign
            bits *= 2
        return 0

    def _entry(self, entry: str, z: arb) -> arb:
        """A ball around an entry of the adjugate."""
        last = self.size - 1
        i, j = {"first": (0, 0), "second": (0, 1), "last": (last, last)}[entry]
        minor = arb_mat([[arb_poly(x)(z) for x in row] for row in bezout.without(self.matrix, i, j)]).det()
        return -minor if (i + j) % 2 else minor

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around ``s/u`` at a place below 1; None if it is not known to be finite."""
        z = place.z(bits)
        if self.size < BY_BALLS:
            value = arb_poly(self.second)(z) / arb_poly(self.first)(z)
        else:
            value = self._entry("second", z) / self._entry("first", z)
        return value if value.is_finite() else None

    def is_simple(self, place: Place) -> bool:
        """Whether there is exactly one parameter s at a zero of F, on the segment or not."""
        return bool(self.sign("first", place) or self.sign("last", place))

    def partner(self, place: Place) -> Local | _Several | None:
        """The parameter s of a zero of F on the segment; None if it is outside the segment, and `SEVERAL` if there
        is not exactly one.
        """
        bottom = self.sign("first", place)
        if bottom:
            top = self.sign("second", place) * bottom
            return None if top < 0 else at(mpq(0)) if top == 0 else Image(place, self)
        return at(mpq(1)) if self.sign("last", place) else SEVERAL


class _LineElimination(Elimination):
    """The elimination for a first curve of degree 1, whose matrix is its line: ``s/u = −det(p₀, Q, e)/det(p₁, Q, e)``
    for a point e that is not on the line.
    """

    def __init__(self, line: PlaneForms, other: PlaneForms) -> None:
        super().__init__(bezout.bezout_matrix(line, other), other.degree)
        start, end = line.coefficient(0), line.coefficient(1)
        normal = across(start, end)
        # the coordinates of the line itself, as a point, are not on the line
        self._forms = along(across(start, normal), other), along(across(normal, end), other)

    @cached_property
    def map(self) -> RationalMap:
        """The parameter on the line."""
        return RationalMap(self.degree, *self._forms)

    def near(self, place: Place, bits: int) -> arb | None:
        """A ball around the parameter."""
        return self.map.near(place, bits)

    def is_simple(self, place: Place) -> bool:
        """True, because a line passes once through each of its points."""
        return True

    def partner(self, place: Place) -> Local | _Several | None:
        """The parameter on the line; None if it is outside the segment."""
        top, bottom = (place.sign(form, self.degree) for form in self._forms)
        if top * bottom < 0:
            return None
        return at(mpq(0)) if top == 0 else at(mpq(1)) if bottom == 0 else Image(place, self)


def self_elimination(curve: PlaneForms) -> Elimination:
    """The elimination for a curve of degree 2 or more and itself, without the pairs of equal parameters."""
    return Elimination(bezout.self_matrix(curve), curve.degree - 2)


def elimination(first: PlaneForms, second: PlaneForms) -> Elimination:
    """The elimination of the parameter of the first curve."""
    if first.degree == 1:
        return _LineElimination(first, second)
    return Elimination(bezout.bezout_matrix(first, second), second.degree)


def meetings(first: PlaneForms, second: PlaneForms) -> Meetings:
    """All common points and arcs of two segments.

    >>> parabola = PlaneForms(2, fmpz_poly([0, 1, 1]), fmpz_poly([0, 0, 1]), fmpz_poly([1, 2, 1]))
    >>> line = PlaneForms(1, fmpz_poly([0, 1]), fmpz_poly([0, 1]), fmpz_poly([1, 1]))
    >>> found = meetings(line, parabola)  # y = x
    >>> [(point.first.exact, point.second.exact, point.multiplicity) for point in found.points]
    [(mpq(0,1), mpq(0,1), 1), (mpq(1,1), mpq(1,1), 1)]

    Raises `ReachError` if this would take too long.
    """
    return _meetings(second, first).exchanged() if first.degree > second.degree else _meetings(first, second)


def _meetings(first: PlaneForms, second: PlaneForms) -> Meetings:
    if first.degree == 0:
        return meetings_of_point(bezout.minors(first, second), second.degree)
    eliminated = elimination(first, second)
    if not eliminated.determinant:
        return _degenerate(first, second)
    found = Meetings()
    for place in places(eliminated.isolation):
        partner = eliminated.partner(place)
        if partner is SEVERAL:
            if first.is_straight:
                return _with_straight(first, second)
            found.points += _found_at(first, second, place)
        elif partner is not None:
            found.points.append(Meeting(partner, place, place.multiplicity))
    return found


def _with_straight(first: PlaneForms, second: PlaneForms) -> Meetings:
    """The common points of a straight curve of higher degree and another curve that is not on the same line."""
    line = bezout.straight_line(second)
    if line is None:
        return _meetings(second, first).exchanged()
    own = bezout.straight_line(first)
    assert own is not None, "the first curve is straight"
    ours, theirs = (
        places(isolate(form, n))
        for form, n in ((along(line, first), first.degree), (along(own, second), second.degree))
    )
    return Meetings([Meeting(s, t, s.multiplicity * t.multiplicity) for t in theirs for s in ours])


def meetings_of_point(minors: Iterable[fmpz_poly], degree: int) -> Meetings:
    """The parameters at which a curve of this degree passes through a point: the common zeros of forms."""
    forms = [form for form in minors if form]
    if not forms:
        return Meetings(rests=[Rest(None)])
    common = greatest_common_divisor(forms)
    at_end = degree - max(form.degree() for form in forms)
    return Meetings(rests=[Rest(place) for place in places(isolate(common, common.degree() + at_end))])


def _found_at(first: PlaneForms, second: PlaneForms, place: Place) -> list[Meeting]:
    """The common points at a place of the second curve where the first has several parameters."""
    backward = elimination(second, first)
    fibre = Fibre(first, second, place)
    found = []
    for candidate in places(backward.isolation):
        if fibre.contains(candidate):
            if fibre.size == 1:
                multiplicity = place.multiplicity
            elif backward.is_simple(candidate):
                multiplicity = candidate.multiplicity
            else:
                multiplicity = local_multiplicity(first, second, candidate, place)
            found.append(Meeting(candidate, place, multiplicity))
    return found


# ---- where the determinant is the zero form


def without_common_factor(curve: PlaneForms) -> PlaneForms:
    """The curve without a common factor of its three forms: its degree is the degree of the curve itself.

    >>> line = fmpz_poly([0, 1]), fmpz_poly([1]), fmpz_poly([1, 1])
    >>> raised = PlaneForms(2, *[f * fmpz_poly([1, 1]) for f in line])
    >>> without_common_factor(raised)
    PlaneForms(degree=1, x=x, y=1, w=x + 1)
    """
    if any(f and certainly_coprime(curve.w, f) for f in (curve.x, curve.y)):
        return curve
    common = greatest_common_divisor([curve.w, curve.x, curve.y])
    if common.degree() < 1:
        return curve
    return PlaneForms(curve.degree - common.degree(), *[f // common for f in curve.forms])


def _degenerate(first: PlaneForms, second: PlaneForms) -> Meetings:
    """The common points of curves whose determinant vanishes: common factors are removed first; if the determinant
    still vanishes, the curves are arcs of the same curve.
    """
    lower, other = without_common_factor(first), without_common_factor(second)
    if lower.degree < first.degree or other.degree < second.degree:
        return meetings(lower, other)
    forward = elimination(first, second)
    if forward.first:
        return _of_one_curve(first, second, forward)
    backward = elimination(second, first)
    if backward.first:
        return _of_one_curve(second, first, backward).exchanged()
    if first.is_straight:
        return collinear_arcs(first, second)
    raise ReachError("the common arcs of two curves that both run over one arc several times", remedy=REMEDY)


def _of_one_curve(first: PlaneForms, second: PlaneForms, forward: Elimination) -> Meetings:
    """The common arcs and points of two arcs of the same curve; the map of `forward` sends the parameters of the second
    to the first.
    """
    carried = lowest_terms(forward.map)
    found = common_arcs(carried)
    if first.degree > 2:
        found.points += _crossings(first, second, carried)
    return found


def _crossings(first: PlaneForms, second: PlaneForms, carried: RationalMap) -> Iterator[Meeting]:
    """The points where other branches of the first curve pass through a point of the second."""
    own = self_elimination(first)
    u, v = carried.bottom, carried.top
    matrix = [[substituted(x, own.degree, u, v) for x in row] for row in own.matrix]
    crossed = Elimination(matrix, own.degree * carried.degree)
    for place in places(crossed.isolation):
        partner = crossed.partner(place)
        if partner is SEVERAL:
            yield from _crossings_at(first, second, carried, place)
        elif partner is not None and not _is_value(partner, carried, place):
            yield Meeting(partner, place, place.multiplicity)


def _crossings_at(first: PlaneForms, second: PlaneForms, carried: RationalMap, place: Place) -> Iterator[Meeting]:
    """The crossings at a place where several other branches pass through the point."""
    fibre = Fibre(first, second, place, carried)
    for candidate in places(self_elimination(first).isolation):
        if fibre.contains(candidate):
            yield Meeting(candidate, place, local_multiplicity(first, second, candidate, place, carried))


def _is_value(partner: Local, carried: RationalMap, place: Place) -> bool:
    """Whether a parameter of the first curve is the value of a map."""
    if isinstance(partner, Place):
        return place.sign(carried.top if partner.exact == 0 else carried.bottom, carried.degree) == 0
    own = partner.map
    difference = own.top * carried.bottom - own.bottom * carried.top
    return place.sign(difference, own.degree + carried.degree) == 0


# ---- a curve and itself


def self_meetings(curve: PlaneForms) -> Meetings:
    """The pairs of parameters s < t of one segment that have the same point, and the arcs that are traversed again.

    >>> loop = PlaneForms(3, fmpz_poly([0, 9, -6, 1]), fmpz_poly([0, 9, 9]), fmpz_poly([1, 3, 3, 1]))
    >>> (point,) = self_meetings(loop).points
    >>> [float(x) for x in point.second.refine(40)], point.multiplicity
    ([0.9330127018..., 0.9330127018...], 1)

    Raises `ReachError` if this would take too long.
    """
    curve = without_common_factor(curve)
    if curve.degree < 2:
        return Meetings()
    if curve.is_straight:
        return collinear_arcs(curve)
    crossed = self_elimination(curve)
    if crossed.determinant:
        return Meetings(list(_own_crossings(curve, crossed)))
    if not crossed.first:
        raise ReachError("the arcs that a curve runs over more than twice", remedy=REMEDY)
    return common_arcs(lowest_terms(crossed.map), below=True)


def _own_crossings(curve: PlaneForms, crossed: Elimination) -> Iterator[Meeting]:
    every = places(crossed.isolation)
    for i, place in enumerate(every):
        partner = crossed.partner(place)
        if partner is SEVERAL:
            fibre = Fibre(curve, curve, place, IDENTITY)
            for s in every[:i]:
                if fibre.contains(s):
                    yield Meeting(s, place, local_multiplicity(curve, curve, s, place, IDENTITY))
        elif isinstance(partner, Image):
            excess = (crossed.second - crossed.first.left_shift(1)) * crossed.first
            if place.sign(excess, 2 * crossed.map.degree + 1) < 0:
                yield Meeting(partner, place, place.multiplicity)
        elif isinstance(partner, Place) and partner.exact == 0 != place.exact:
            yield Meeting(partner, place, place.multiplicity)
