"""Other representations of the same spline, its parts, and compositions: methods of `BSpline`."""

from __future__ import annotations

from abc import abstractmethod
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Self, TypeVar

from flint import fmpz, fmpz_poly

from exactspline.errors import DomainError, KnotError, ReductionError, ShapeError, shown
from exactspline.language.provenance import Provenance
from exactspline.numbers.exact import Number, mpq, ratio, rational, text, to_fmpz
from exactspline.numbers.intervals import Interval, Side
from exactspline.one_line import short_text
from exactspline.polynomials import bernstein
from exactspline.polynomials.bernstein import Form
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.isolation import LocalZero, end_signs, is_nonnegative, isolate
from exactspline.splines.inputs import MAX_DEGREE
from exactspline.splines.knots import SMOOTH, Mesh

# ---- an operation on the polynomials of two splines


T = TypeVar("T")


def segmentwise(operation: Callable[[T, T], T], first: Sequence[T], second: Sequence[T]) -> tuple[T, ...]:
    """The results on all segments or patches; without a loop for splines with a single one, which is the usual case."""
    return (operation(first[0], second[0]),) if len(first) == 1 else tuple(map(operation, first, second))


class Refinable:
    """A piecewise polynomial, given by its forms: its other representations, its parts, and compositions."""

    __slots__ = ()

    degree: int
    mesh: Mesh
    continuity: tuple[int, ...]
    provenance: Provenance
    #: The polynomials of the forms, which are shared.
    numerators: tuple[fmpz_poly, ...]
    denominators: tuple[fmpz, ...]

    @classmethod
    @abstractmethod
    def from_forms(
        cls,
        degree: int,
        mesh: Mesh,
        continuity: tuple[int, ...],
        forms: Iterable[Form],
        provenance: Provenance | None = None,
    ) -> Self:
        """The piecewise polynomial with these forms."""

    @property
    @abstractmethod
    def forms(self) -> tuple[Form, ...]:
        """The form of every segment."""

    @property
    @abstractmethod
    def domain(self) -> Interval:
        """The interval of definition."""

    @property
    @abstractmethod
    def true_degree(self) -> int:
        """The largest degree of the polynomials of the segments."""

    @abstractmethod
    def constant(self, number: Number, /) -> Self:
        """A constant on the same domain."""

    @abstractmethod
    def d(self, order: int = 1) -> Self:
        """The derivative of the given order."""

    @abstractmethod
    def __call__(self, t: Number, side: Side | str = Side.RIGHT) -> mpq:
        """The exact value at a parameter."""

    def elevate_degree(self, by: int = 1) -> Self:
        """Return the same function with the degree raised."""
        if type(by) is not int or not 0 <= by <= MAX_DEGREE:
            remedy = f"an integer from 0 to {MAX_DEGREE} (use reduce_degree to lower a degree)"
            raise ShapeError(f"degree elevation by {shown(by)}", remedy=remedy)
        lift = bernstein.raiser(by)
        return type(self).from_forms(
            self.degree + by, self.mesh, self.continuity, [(p * lift, k) for p, k in self.forms], self.provenance
        )

    def reduce_degree(self, by: int = 1) -> Self:
        """Return the same function with a lower degree. Raises `ReductionError`, which names a segment, if this is not
        possible exactly.
        """
        if type(by) is not int or by < 0:
            raise ShapeError(
                f"degree reduction by {shown(by)}", remedy="an integer ≥ 0 (use elevate_degree to raise a degree)"
            )
        if by > self.degree:
            raise ReductionError(f"degree {self.degree} cannot be lowered by {by}", remedy=f"at most by {self.degree}")
        lower, divisor = [], bernstein.raiser(by)
        for i, (p, k) in enumerate(self.forms):
            whole, rest = divmod(p, divisor)
            if not rest:
                lower.append((whole, k))
                continue
            quotient, times = bernstein.divide_u_plus_v(p, by)
            if times < by:
                a, b = self.mesh.breaks[i : i + 2]
                raise ReductionError(
                    f"the segment [{text(a)}, {text(b)}] has true degree {self.degree - times}",
                    where=f"segment {i}",
                    remedy=f"the degree can be lowered to {self.true_degree}, not to {self.degree - by}",
                    segment=i,
                    true_degree=self.degree - times,
                )
            lower.append((quotient, k))
        n = self.degree - by
        return _without_smooth_knots(
            type(self).from_forms(n, self.mesh, tuple(min(c, n) for c in self.continuity), lower)
        )

    def insert_knot(self, t: Number, times: int = 1) -> Self:
        """The same function with one more knot (or several) at a parameter inside the domain."""
        t, lowered = insertable(self.degree, self.mesh, self.continuity, t, times)
        g = over(self, self.mesh if t in self.mesh.breaks else Mesh(sorted([*self.mesh.breaks, t])))
        return type(self).from_forms(
            self.degree, g.mesh, _replaced(g.continuity, g.mesh.breaks.index(t) - 1, lowered), g.forms
        )

    def remove_knot(self, t: Number, times: int = 1) -> Self:
        """Return the same function with a knot removed once or several times. Raises `ReductionError`, which names a
        derivative, if this derivative jumps at the knot.
        """
        t = inner(self.mesh, t)
        multiplicity = (
            max(self.degree - self.continuity[self.mesh.breaks.index(t) - 1], 0) if t in self.mesh.breaks else 0
        )
        if type(times) is not int or not 1 <= times <= multiplicity:
            problem = f"{shown(times)} of {multiplicity} knots at {text(t)} to remove"
            raise KnotError(problem, remedy="remove at least one, and no more than there are", knot=t)
        position = self.mesh.breaks.index(t) - 1
        required, have = self.continuity[position] + times, self.continuity_at(t)
        if have < min(required, self.degree):
            jump = self.d(have + 1)
            raise ReductionError(
                f"the derivative of order {have + 1} jumps at {text(t)} by {text(jump(t) - jump(t, 'left'))}",
                remedy=f"{max(have - self.continuity[position], 0)} knots can be removed there",
                knot=t,
                continuity=have,
            )
        return _without_smooth_knots(
            type(self).from_forms(self.degree, self.mesh, _replaced(self.continuity, position, required), self.forms)
        )

    def continuity_at(self, t: Number) -> int:
        """Return the order of continuity at a parameter: −1 at a jump, the degree if both sides are the same
        polynomial.

        >>> from exactspline import BSpline
        >>> BSpline(2, [0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 1, 2, 5]).continuity_at(1)
        1
        """
        t = inner(self.mesh, t)
        if t not in self.mesh.breaks:
            return self.degree
        derivative = self
        for order in range(self.degree + 1):
            if derivative(t) != derivative(t, Side.LEFT):
                return order - 1
            derivative = derivative.d()
        return self.degree

    def split(self, t: Number) -> tuple[Self, Self]:
        """Return the parts of the spline left and right of an inner parameter."""
        a, b = self.domain
        return self.restrict(a, t), self.restrict(t, b)

    def bezier_segments(self) -> list[Self]:
        """Return the segments as separate splines."""
        return [self.restrict(a, b) for a, b in pairwise(self.mesh.breaks)]

    def restrict(self, a: Number, b: Number) -> Self:
        """Return the part of the spline over [a, b]."""
        a, b = rational(a), rational(b)
        low, high = self.domain
        if not low <= a < b <= high:
            problem = f"[{text(a)}, {text(b)}] is not part of the domain [{text(low)}, {text(high)}]"
            raise DomainError(problem, remedy="give a < b inside the domain", domain=self.domain)
        first, last = self.mesh.locate(a), self.mesh.locate(b, left=True)
        mesh = Mesh([a, *self.mesh.breaks[first + 1 : last + 1], b])
        return type(self).from_forms(self.degree, mesh, self.continuity[first:last], _parts(self, mesh))

    def reverse(self) -> Self:
        """Return the reversed spline, over the same domain: ``t ↦ f(a + b − t)`` on [a, b]."""
        a, b = self.domain
        mesh = Mesh([a + b - t for t in reversed(self.mesh.breaks)])
        return type(self).from_forms(
            self.degree, mesh, self.continuity[::-1], [bernstein.reverse(p, self.degree) for p in reversed(self.forms)]
        )

    def reparametrize(self, a: Number, b: Number) -> Self:
        """Return the spline with the same control points whose knots are mapped affinely, so that the domain is
        [a, b].
        """
        a, b = rational(a), rational(b)
        if not a < b:
            raise DomainError(f"[{text(a)}, {text(b)}] is empty", remedy="give a < b (see reverse)")
        low, high = self.domain
        mesh = Mesh([a + (t - low) * (b - a) / (high - low) for t in self.mesh.breaks])
        return type(self).from_forms(self.degree, mesh, self.continuity, self.forms)

    def compose(self, inner: Self) -> Self:
        """Return the composition ``t ↦ f(inner(t))`` with this spline f, whose degree is the product of the degrees.

        Raises `DomainError` if `inner` leaves the domain of this spline, and `ReductionError` if `inner` crosses a knot
        of this spline at an irrational parameter, because the composition then has an irrational knot.
        """
        if self.degree < 0 or inner.degree < 0:
            return inner.constant(self(0) if self.degree >= 0 else 0)
        _check_range(self, inner)
        kinks = dict(zip(self.mesh.breaks[1:-1], self.continuity, strict=True))
        continuity = {t: c for knot, c in kinks.items() for t in _preimages(inner, knot)}
        for t, c in zip(inner.mesh.breaks[1:-1], inner.continuity, strict=True):
            continuity[t] = min([c, *[kinks[x] for x in (inner(t, Side.LEFT), inner(t)) if x in kinks]])
        a, b = inner.domain
        mesh = Mesh([a, *sorted(t for t in continuity if a < t < b), b])
        parts, forms, outer_forms = [], inner.forms, self.forms
        for low, high in pairwise(mesh.breaks):
            i = inner.mesh.locate(low)
            piece = bernstein.restrict(forms[i], inner.degree, inner.mesh.local(i, low), inner.mesh.local(i, high))
            j = self.mesh.locate(_typical(inner, self, low, high))
            parts.append(
                bernstein.compose(
                    outer_forms[j], self.degree, _localized(piece, inner.degree, self.mesh, j), inner.degree
                )
            )
        inside = tuple(continuity[t] for t in mesh.breaks[1:-1])
        return type(self).from_forms(self.degree * inner.degree, mesh, inside, parts)


S = TypeVar("S", bound=Refinable)


def aligned(f: S, g: S) -> tuple[S, S]:
    """Both splines over the union of their breakpoints; a spline without a knot at a breakpoint is smooth there."""
    mesh = f.mesh if f.mesh.breaks == g.mesh.breaks else f.mesh.union(g.mesh)
    return over(f, mesh), over(g, mesh)


def over(f: S, mesh: Mesh) -> S:
    """The spline over a finer mesh of the same domain."""
    if mesh is f.mesh or mesh.breaks == f.mesh.breaks:
        return type(f).from_forms(f.degree, mesh, f.continuity, f.forms, f.provenance)
    known = dict(zip(f.mesh.breaks[1:-1], f.continuity, strict=True))
    continuity = tuple(known.get(t, SMOOTH) for t in mesh.breaks[1:-1])
    return type(f).from_forms(f.degree, mesh, continuity, _parts(f, mesh), f.provenance)


def _parts(f: Refinable, mesh: Mesh) -> Iterator[bernstein.Form]:
    for a, b in pairwise(mesh.breaks):
        i = f.mesh.locate(a)
        form = f.numerators[i], f.denominators[i]
        yield bernstein.restrict(form, f.degree, f.mesh.local(i, a), f.mesh.local(i, b))


def _without_smooth_knots(f: S) -> S:
    """The spline with segments merged across breakpoints whose nominal continuity reaches the degree, where the knot is
    superfluous.
    """
    keep = [i for i, c in enumerate(f.continuity) if c < f.degree]
    if len(keep) == len(f.continuity):
        return f
    starts, forms = [0, *[i + 1 for i in keep]], f.forms
    breaks = [f.mesh.breaks[i] for i in starts] + [f.mesh.breaks[-1]]
    merged = [
        bernstein.restrict(forms[i], f.degree, mpq(0), f.mesh.local(i, b))
        for i, b in zip(starts, breaks[1:], strict=True)
    ]
    return type(f).from_forms(f.degree, Mesh(breaks), tuple(f.continuity[i] for i in keep), merged)


def inner(mesh: Mesh, given: Number) -> mpq:
    """A parameter inside the domain."""
    (a, b), t = mesh.domain, rational(given)
    if not a < t < b:
        problem = f"{short_text(t)} is not inside the domain ({text(a)}, {text(b)})"
        raise DomainError(problem, remedy="choose a parameter inside the domain", parameter=t)
    return t


def insertable(degree: int, mesh: Mesh, continuities: Sequence[int], t: Number, times: int) -> tuple[mpq, int]:
    """The parameter at which knots are inserted, and the continuity that remains there."""
    t = inner(mesh, t)
    if type(times) is not int or times < 1:
        raise KnotError(f"{shown(times)} knots to insert", remedy="insert an integer of them, at least one")
    i = bisect_left(mesh.breaks, t)
    continuity = continuities[i - 1] if mesh.breaks[i] == t else SMOOTH
    lowered = min(continuity, degree) - times
    if lowered < -1:
        raise KnotError(
            f"{text(t)} would get multiplicity {degree - lowered}", remedy=f"at most degree + 1 = {degree + 1}", knot=t
        )
    return t, lowered


def _replaced(continuity: tuple[int, ...], position: int, by: int) -> tuple[int, ...]:
    return (*continuity[:position], by, *continuity[position + 1 :])


def _typical(inner: Refinable, outer: Refinable, low: mpq, high: mpq) -> mpq:
    """A value of the inner spline on (low, high) that is not a knot of the outer spline, if there are such values: the
    inner spline may touch knots there but does not cross any.
    """
    values = [inner(low + (high - low) * mpq(k, inner.degree + 4)) for k in range(1, inner.degree + 4)]
    return next((x for x in values if x not in outer.mesh.breaks), values[0])


def _localized(piece: bernstein.Form, degree: int, mesh: Mesh, j: int) -> bernstein.Form:
    """The inner form in the local parameter of segment j of the outer mesh."""
    start, width = mesh.breaks[j], mesh.breaks[j + 1] - mesh.breaks[j]
    c, m = bernstein.add(piece, _constant(-start, degree))
    return c * to_fmpz(width.denominator), m * to_fmpz(width.numerator)


def _constant(value: mpq, degree: int) -> bernstein.Form:
    return int(value.numerator) * bernstein.raiser(degree), to_fmpz(value.denominator)


def _check_range(outer: Refinable, inner: Refinable) -> None:
    low, high = outer.domain
    for i, piece in enumerate(inner.forms):
        below = bernstein.add(piece, _constant(-low, inner.degree))[0]
        above = bernstein.add((-piece[0], piece[1]), _constant(high, inner.degree))[0]
        for c in (below, above):
            if not is_nonnegative(c, inner.degree):
                a, b = inner.mesh.breaks[i : i + 2]
                raise DomainError(
                    f"the inner spline leaves the outer domain [{text(low)}, {text(high)}] on [{text(a)}, {text(b)}]",
                    remedy="restrict it first",
                    segment=i,
                )


def _preimages(inner: Refinable, knot: mpq) -> list[mpq]:
    """The parameters strictly inside segments at which `inner` crosses `knot`; raises an error unless all are
    rational.
    """
    found = []
    for i, piece in enumerate(inner.forms):
        c, _ = bernstein.add(piece, _constant(-knot, inner.degree))
        if not c:
            continue
        segment = Interval(*inner.mesh.breaks[i : i + 2])
        for zero in isolate(c, inner.degree).inner:
            if zero.signs[0] != zero.signs[1]:
                found.append(segment.at(_rational(zero, knot, segment)))
    return found


def _rational(zero: LocalZero, knot: mpq, segment: Interval) -> mpq:
    """The local parameter at which a knot of the outer spline is crossed; raises an error if it is irrational."""
    if zero.low == zero.high:
        return zero.low
    own = next(q for q in factorize(zero.factor.polynomial).bases if len(set(end_signs(q, zero.low, zero.high))) > 1)
    if own.degree() == 1:
        return ratio(own[0], own[0] - own[1])
    raise ReductionError(
        f"the knot {text(knot)} of the outer spline has an irrational preimage on {segment}",
        remedy=(
            "the composition is not a spline with rational knots; split the outer spline there or approximate the "
            "inner one"
        ),
        knot=knot,
        polynomial=[int(x) for x in own.coeffs()],
    )
