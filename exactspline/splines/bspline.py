"""The public piecewise polynomial: exact B-splines and the primitive operations of §2 of the paper (Chen, Riesenfeld
and Cohen 2007).

A `BSpline` is immutable. The knots and control points are exact (``gmpy2.mpq``); for a computed spline they are
computed when first needed and then stored. Internally it is a list of forms (see `exactspline.polynomials.bernstein`),
one per segment, with the nominal degree and the nominal continuity at every interior breakpoint.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from operator import add as plus
from operator import mul as times
from operator import sub as minus
from typing import ClassVar

from flint import fmpq_poly, fmpz, fmpz_poly

from exactspline.errors import ShapeError, as_items, counted
from exactspline.hooks import FunctionsOutside
from exactspline.language.operand import CONSTANTS, Constant, checked_order
from exactspline.language.provenance import DERIVATIVE, DIFFERENCE, MULTIPLE, PRODUCT, SUM, UNIT, Provenance, leaf
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import Number, mpq, rational, text, to_fmpz
from exactspline.numbers.intervals import Interval, Side
from exactspline.numbers.once import Immutable, fill, setters
from exactspline.one_line import LONGEST
from exactspline.polynomials.bernstein import (
    ONE,
    Form,
    bezier,
    common_denominators,
    derivative,
    in_parameter,
    raiser,
    true_degree,
    value,
)
from exactspline.polynomials.cost import LONGEST_LOOP, check_reach, height_bits
from exactspline.splines import blossom
from exactspline.splines.inputs import checked_degree, checked_side, exact_row
from exactspline.splines.knots import SMOOTH, KnotVector, Mesh, clamped, mesh_of
from exactspline.splines.refinement import Refinable, aligned, segmentwise

#: The degree from which the cost of a product is estimated, and its nanoseconds per bit (measured: 1 to 4 for degrees
#: 300 to 20,000).
LONG, BIT = 256, 4


class BSpline(Immutable, Refinable, RingOperand, FunctionsOutside):
    """A scalar piecewise polynomial of a given degree over given knots, with exact control points.

    `knots` are given with full multiplicities, clamped or not. An interior multiplicity is at most degree + 1; at a
    knot of this multiplicity the spline may jump. The domain is ``[t_n, t_{N−n}]`` for the degree n and the knots t_0 …
    t_N. Parameters and values are exact numbers, read by `exactspline.numbers.exact.rational`.

    >>> f = BSpline(2, [0, 0, 0, 1, 2, 2, 2], [0, 1, 0, "1/2"])
    >>> f(1), (f * f).degree, f.d().control_points
    (mpq(1,2), 4, (mpq(2,1), mpq(-1,1), mpq(1,1)))

    Raises `ShapeError`, `KnotError` or `NumberError` with the place of the error.
    """

    __slots__ = (
        "_derivative",
        "_knots",
        "_points",
        "continuity",
        "degree",
        "denominators",
        "mesh",
        "numerators",
        "provenance",
    )
    equals_quotients: ClassVar[bool] = True
    degree: int
    mesh: Mesh
    continuity: tuple[int, ...]
    #: The integer polynomials of the forms, over `denominators`. They are shared and must not be changed.
    numerators: tuple[fmpz_poly, ...]
    denominators: tuple[fmpz, ...]
    provenance: Provenance
    # set when they are computed
    _derivative: BSpline
    _knots: KnotVector
    _points: tuple[mpq, ...] | None

    def __init__(self, degree: int, knots: Iterable[Number], control_points: Iterable[Number]) -> None:
        degree = checked_degree(degree)
        vector = knots if isinstance(knots, KnotVector) else KnotVector(knots)
        vector.check(degree)
        points = _exact_numbers(control_points)
        vector.check_count(degree, len(points))
        mesh, continuity, spans = mesh_of(vector, degree)
        numerators, denominators = zip(*blossom.forms_of(vector.knots, degree, points, spans), strict=True)
        fill(self, degree=degree, mesh=mesh, continuity=continuity, numerators=numerators, denominators=denominators)
        fill(self, provenance=leaf(), _knots=vector, _points=points)

    @classmethod
    def from_forms(
        cls,
        degree: int,
        mesh: Mesh,
        continuity: tuple[int, ...],
        forms: Iterable[Form],
        provenance: Provenance | None = None,
        knots: KnotVector | None = None,
        points: tuple[mpq, ...] | None = None,
    ) -> BSpline:
        """Return the spline with these forms (the polynomials of the segments), and with knots and control points if
        these are known. The forms must not be changed afterwards; the caller is responsible for the continuity.
        """
        polynomials, denominators = zip(*forms, strict=True)
        provenance = leaf() if provenance is None else provenance
        return from_parts(degree, mesh, continuity, polynomials, denominators, provenance, knots, points)

    def _known(self) -> tuple[KnotVector | None, tuple[mpq, ...] | None]:
        """The knots and the control points, as far as they are known."""
        return getattr(self, "_knots", None), getattr(self, "_points", None)

    @classmethod
    def bezier(cls, points: Sequence[Number], a: Number = 0, b: Number = 1) -> BSpline:
        """Return the polynomial with these Bézier points over [a, b].

        >>> BSpline.bezier([0, 0, 1])("1/2")
        mpq(1,4)
        """
        points = list(points)
        return cls(len(points) - 1, [*[a] * len(points), *[b] * len(points)], points)

    @classmethod
    def identity(cls, a: Number, b: Number) -> BSpline:
        """Return the function t ↦ t on [a, b].

        >>> BSpline.identity(0, 2)("1/3")
        mpq(1,3)
        """
        return cls.bezier([a, b], a, b)

    # ---- representation

    @property
    def polynomials(self) -> tuple[fmpq_poly, ...]:
        """The polynomial of every segment, in the parameter.

        >>> BSpline(1, [0, 0, 1, 3, 3], [1, 2, 0]).polynomials
        (x + 1, (-1)*x + 3)
        """
        return tuple(in_powers(self, i) for i in range(len(self.mesh)))

    @property
    def forms(self) -> tuple[Form, ...]:
        """The form of every segment: a copy of its polynomial, over a denominator."""
        return tuple(zip(map(fmpz_poly, self.numerators), self.denominators, strict=True))

    @property
    def knots(self) -> KnotVector:
        """The knots as given, or the clamped knots of a computed spline."""
        known: KnotVector | None = getattr(self, "_knots", None)
        if known is None:
            known = clamped(self.mesh, self.continuity, self.degree)
            fill(self, _knots=known)
        return known

    @property
    def control_points(self) -> tuple[mpq, ...]:
        """The control points over `knots`."""
        points: tuple[mpq, ...] | None = getattr(self, "_points", None)
        if points is None:
            known = (self.knots.knots, self.degree, self.mesh.breaks, self.bezier_points)
            points = blossom.to_control_points(*known) if self.degree >= 0 else ()
            fill(self, _points=points)
        return points

    @property
    def segments(self) -> int:
        """The number of polynomial segments."""
        return len(self.mesh)

    @property
    def bezier_points(self) -> tuple[tuple[mpq, ...], ...]:
        """The Bézier points of every segment.

        >>> BSpline(1, [0, 0, 1, 3, 3], [1, 2, 0]).bezier_points
        ((mpq(1,1), mpq(2,1)), (mpq(2,1), mpq(0,1)))
        """
        return tuple(tuple(bezier(form, self.degree)) for form in zip(self.numerators, self.denominators, strict=True))

    @property
    def domain(self) -> Interval:
        """The interval of definition."""
        return self.mesh.domain

    @property
    def breakpoints(self) -> tuple[mpq, ...]:
        """The distinct knots of the domain, ends included."""
        return self.mesh.breaks

    def __repr__(self) -> str:
        knots = ", ".join(map(text, self.knots))
        points = ", ".join(map(text, self.control_points))
        written = f"BSpline({self.degree}, [{knots}], [{points}])"
        return written if len(written) <= LONGEST else f"<BSpline: {self._described}>"

    @property
    def _described(self) -> str:
        """The degree and the size as text."""
        sizes = counted(len(self.control_points), "control point"), counted(len(self.mesh), "segment")
        return f"degree {self.degree}, {sizes[0]} on {self.domain}, {sizes[1]}"

    def __reduce__(self) -> tuple[object, ...]:
        forms = tuple(
            (tuple(map(int, c.coeffs())), int(m)) for c, m in zip(self.numerators, self.denominators, strict=True)
        )
        return _restored, (self.degree, self.mesh, self.continuity, forms, *self._known())

    def same_representation(self, other: BSpline) -> bool:
        """Return whether degree, knots and control points agree (`==` tests only whether the functions agree)."""
        return self.degree == other.degree and self.knots == other.knots and self.control_points == other.control_points

    # ---- arithmetic

    def constant(self, number: Number) -> BSpline:
        """Return the constant spline of degree 0 on this domain."""
        q, segments = rational(number), len(self.mesh)
        c, m = fmpz_poly([int(q.numerator)]), to_fmpz(q.denominator)
        return from_parts(
            0, self.mesh, (SMOOTH,) * (segments - 1), (c,) * segments, (m,) * segments, (MULTIPLE, UNIT, q)
        )

    def __add__(self, other: BSpline | Constant) -> BSpline:
        return self._sum(other, plus, SUM)

    def __sub__(self, other: BSpline | Constant) -> BSpline:
        return self._sum(other, minus, DIFFERENCE)

    def _sum(self, other: object, operation: Callable[[fmpz_poly, fmpz_poly], fmpz_poly], name: int) -> BSpline:
        if type(other) is not BSpline:
            if not isinstance(other, CONSTANTS):
                refused: BSpline = NotImplemented
                return refused
            other = self.constant(other)
        a, b = (self, other) if self.mesh is other.mesh else aligned(self, other)
        n, p, q = a.degree, a.numerators, b.numerators
        if n != b.degree and n + b.degree > LONG:
            _check_reach(a if n < b.degree else b, abs(n - b.degree), abs(n - b.degree))
        if n < b.degree:
            n, lift = b.degree, raiser(b.degree - n)
            p = tuple([c * lift for c in p])
        elif n > b.degree:
            lift = raiser(n - b.degree)
            q = tuple([c * lift for c in q])
        denominators = a.denominators
        if denominators != b.denominators:
            p, q, denominators = common_denominators(p, denominators, q, b.denominators)
        continuity = a.continuity if a.continuity == b.continuity else tuple(map(min, a.continuity, b.continuity))
        return from_parts(
            n, a.mesh, continuity, segmentwise(operation, p, q), denominators, (name, self.provenance, other.provenance)
        )

    def __mul__(self, other: BSpline | Constant) -> BSpline:
        if type(other) is not BSpline:
            return self.scaled(other) if isinstance(other, CONSTANTS) else NotImplemented
        a, b = (self, other) if self.mesh is other.mesh else aligned(self, other)
        if a.degree + b.degree > LONG:
            _check_reach(a, b.degree, height_bits(b.numerators))
        return from_parts(
            a.degree + b.degree,
            a.mesh,
            a.continuity if a.continuity == b.continuity else tuple(map(min, a.continuity, b.continuity)),
            segmentwise(times, a.numerators, b.numerators),
            segmentwise(times, a.denominators, b.denominators),
            (PRODUCT, self.provenance, other.provenance),
        )

    def scaled(self, constant: Number) -> BSpline:
        """Return the spline times an exact constant."""
        q = constant if type(constant) is int else rational(constant)
        provenance = (MULTIPLE, self.provenance, q)
        if type(q) is int:
            top, denominators = fmpz(q), self.denominators
        else:
            top, bottom = to_fmpz(q.numerator), to_fmpz(q.denominator)
            denominators = self.denominators if bottom == 1 else tuple([m * bottom for m in self.denominators])
        polynomials = tuple([c * top for c in self.numerators])
        return from_parts(self.degree, self.mesh, self.continuity, polynomials, denominators, provenance)

    def d(self, order: int = 1, *, by: str | None = None) -> BSpline:
        """Return the derivative of the given order.

        The formal degree decreases by one with each derivative, also below 0 (the spline is then zero and has no
        control points). The continuity decreases, too, but not below −1.

        >>> BSpline.bezier([0, 0, 1]).d(2).control_points
        (mpq(2,1),)
        """
        self.only_parameter(by)
        order = checked_order(order)
        result = self
        for _ in range(order):
            derivative: BSpline | None = getattr(result, "_derivative", None)
            if derivative is None:
                derivative = _differentiated(result)
                fill(result, _derivative=derivative)
            result = derivative
        return result

    def integral(self) -> BSpline:
        """Return the continuous antiderivative that is 0 at the start of the domain; its degree is higher by one.

        >>> f = BSpline(1, [0, 0, 1, 3, 3], [2, 0, 4])
        >>> f.integral().d() == f, f.integral()(0), f.integral()(3)
        (True, mpq(0,1), mpq(5,1))
        """
        degree, reached, points = self.degree + 1, mpq(0), list[mpq]()
        for piece in self.bezier_segments():
            (a, b), values = piece.domain, [reached]
            for point in piece.control_points:
                values.append(values[-1] + point * (b - a) / degree)
            points += values
            reached = values[-1]
        return BSpline(degree, [t for t in self.breakpoints for _ in range(degree + 1)], points)

    def integrate(self, a: Number, b: Number) -> mpq:
        """Return the integral from `a` to `b`.

        >>> BSpline(1, [0, 0, 1, 3, 3], [2, 0, 4]).integrate(1, 3)
        mpq(4,1)
        """
        antiderivative = self.integral()
        return antiderivative(b) - antiderivative(a)

    def elevated_to(self, other: BSpline) -> BSpline:
        """Return the same function, with at least the degree of `other`."""
        return self if self.degree >= other.degree else self.elevate_degree(other.degree - self.degree)

    # ---- the function

    def __call__(self, t: Number, side: Side | str = Side.RIGHT) -> mpq:
        """Return the exact value at a parameter. At a jump this is the limit from the right (from the left at the end
        of the domain), or from the given `side`.

        Raises `DomainError` outside the domain.
        """
        t = rational(t)
        i = self.mesh.locate(t, left=checked_side(side))
        return value((self.numerators[i], self.denominators[i]), self.degree, self.mesh.local(i, t))

    @property
    def is_zero(self) -> bool:
        """Whether the function is identically zero."""
        return not any(self.numerators)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same function on the same domain, whatever their knots and degrees."""
        if not isinstance(other, BSpline):
            return NotImplemented
        return self is other or (self.domain == other.domain and (self - other).is_zero)

    def __hash__(self) -> int:
        """The hash of the quotients that equal this function."""
        return hash((*self.domain, *map(self, self._places)))

    @property
    def _places(self) -> list[mpq]:
        a, b = self.domain
        return [a + (b - a) * mpq(i, 5) for i in range(5)]

    @property
    def vanishes_somewhere(self) -> bool:
        """Whether the function is identically zero on at least one segment."""
        return not all(self.numerators)

    def hash_of_quotient(self, numerator: BSpline) -> int:
        """Return a hash of the limits of the quotient at fixed parameters, the same for equal quotients."""
        return hash((*self.domain, *[_limit(numerator, self, t) for t in self._places]))

    @property
    def true_degree(self) -> int:
        """The largest degree of the polynomials of the segments (−1 for the zero function).

        >>> BSpline.bezier([0, 1, 2, 3]).true_degree
        1
        """
        return max(true_degree(form, self.degree) for form in zip(self.numerators, self.denominators, strict=True))

    # ---- other representations and parts

    def insert_knot(self, t: Number, times: int = 1) -> BSpline:
        """Return the same function with one or several additional knots inside the domain, or at an end that is not
        clamped.

        >>> BSpline(1, [0, 1, 2, 3], [4, 6]).insert_knot(1).knots
        KnotVector(0, 1, 1, 2, 3)

        Raises the errors of `Nurbs.insert_knot`.
        """
        if not self.knots.has_room_at_end(self.degree, t := rational(t), times):
            return super().insert_knot(t, times)
        known = self.provenance, self.knots.insert(t, times)
        return BSpline.from_forms(self.degree, self.mesh, self.continuity, self.forms, *known)


def _exact_numbers(given: Iterable[Number]) -> tuple[mpq, ...]:
    """The control points of a function; for points the error names the class of curves."""
    numbers = tuple(as_items(given, "control points"))
    if numbers and isinstance(numbers[0], Iterable) and not isinstance(numbers[0], str):
        raise ShapeError(
            "points, where a function has numbers",
            where="control_points[0]",
            remedy="a curve is exactspline.Nurbs(degree, knots, points)",
        )
    return exact_row(numbers, "control_points")


_new = object.__new__
_set_degree, _set_mesh, _set_continuity, _set_numerators, _set_denominators, _set_provenance = setters(
    BSpline, "degree", "mesh", "continuity", "numerators", "denominators", "provenance"
)


def _check_reach(a: BSpline, degree: int, bits: int) -> None:
    """Raise `ReachError` if products with a polynomial of this degree, whose coefficients have this many bits, take too
    long.
    """
    total = sum((a.degree + degree) * (p.height_bits() + bits) for p in a.numerators)
    check_reach(BIT * total, lambda: f"a spline of degree {a.degree} times one of degree {degree}", LONGEST_LOOP)


def from_parts(
    degree: int,
    mesh: Mesh,
    continuity: tuple[int, ...],
    polynomials: tuple[fmpz_poly, ...],
    denominators: tuple[fmpz, ...],
    provenance: Provenance,
    knots: KnotVector | None = None,
    points: tuple[mpq, ...] | None = None,
) -> BSpline:
    """The spline with these forms, given as polynomials and denominators, and with knots and control points if they are
    known. The spline takes ownership of them, and the caller is responsible for the continuity.
    """
    spline: BSpline = _new(BSpline)
    _set_degree(spline, degree)
    _set_mesh(spline, mesh)
    _set_continuity(spline, continuity)
    _set_numerators(spline, polynomials)
    _set_denominators(spline, denominators)
    _set_provenance(spline, provenance)
    if knots is not None:
        fill(spline, _knots=knots, _points=points)
    return spline


def in_powers(f: BSpline, i: int) -> fmpq_poly:
    """The polynomial of a segment, in the parameter of the spline.

    >>> in_powers(BSpline.bezier([0, 0, 1], 1, 3), 0)
    1/4*x^2 + (-1/2)*x + 1/4
    """
    top, factor = in_parameter(f.numerators[i], max(f.degree, 0), f.mesh.breaks[i : i + 2])
    return fmpq_poly(top) / (factor * f.denominators[i])


def _restored(
    degree: int,
    mesh: Mesh,
    continuity: tuple[int, ...],
    forms: tuple[tuple[tuple[int, ...], int], ...],
    knots: KnotVector | None,
    points: tuple[mpq, ...] | None,
) -> BSpline:
    """The unpickled spline, with a new provenance, since numbers of leaves mean nothing in another process."""
    made = [(fmpz_poly(list(c)), fmpz(m)) for c, m in forms]
    return BSpline.from_forms(degree, mesh, continuity, made, None, knots, points)


def _differentiated(f: BSpline) -> BSpline:
    n, provenance = f.degree, (DERIVATIVE, f.provenance)
    continuity = tuple([max(c - 1, -1) for c in f.continuity]) if f.continuity else ()
    if n <= 0:
        return from_parts(n - 1, f.mesh, continuity, (fmpz_poly([]),) * len(f.mesh), (ONE,) * len(f.mesh), provenance)
    order = fmpz(n)
    polynomials = tuple([derivative(c, order) for c in f.numerators])
    if f.mesh.unit:
        return from_parts(n - 1, f.mesh, continuity, polynomials, f.denominators, provenance)
    widths = f.mesh.widths
    return from_parts(
        n - 1,
        f.mesh,
        continuity,
        tuple([c * bottom for c, (_, bottom) in zip(polynomials, widths, strict=True)]),
        tuple([m * top for m, (top, _) in zip(f.denominators, widths, strict=True)]),
        provenance,
    )


def _limit(numerator: BSpline, denominator: BSpline, t: mpq) -> mpq | None:
    """The limit of a quotient at a parameter from the right; None at a pole, and where the quotient is 0/0 to the
    right.

    >>> t = BSpline.identity(0, 1)
    >>> _limit(t * t + t, t, mpq(0)), _limit(t, t * t, mpq(0))
    (mpq(1,1), None)
    """
    for _ in range(max(numerator.degree, denominator.degree, 0) + 1):
        below = denominator(t)
        if below:
            return numerator(t) / below
        if numerator(t):
            return None
        numerator, denominator = numerator.d(), denominator.d()
    return None
