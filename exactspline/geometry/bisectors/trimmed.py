"""The true bisector of a point and a plane curve: the points as far from the point as from the *whole* curve (Farouki
and Johnstone 1994).

A point B is on the true bisector when no point of the curve is inside the circle around B through Q: ``‖γ(u) − Q‖² − 2
(B − Q)·(γ(u) − Q) ≥ 0`` for all u. For the untrimmed bisector B(s), and for the line of points as far from Q as from a
corner of the curve, this condition is a family of polynomials in u.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from itertools import pairwise
from typing import Any

from flint import fmpz_mpoly, fmpz_poly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.common import AROUND, STILL, THROUGH, Bisector, parts_where, within
from exactspline.geometry.bisectors.point_and_curve import exact_point
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.kinds import FeatureKind, JointKind
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, norm2, perp
from exactspline.numbers.exact import Number, mpq, over_one_denominator, text
from exactspline.numbers.intervals import UNIT, Box, Interval, Side, joined
from exactspline.numbers.search import Search
from exactspline.one_line import one_line, short_text
from exactspline.papers import find
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, halves, over_common_denominator, restrict, value
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.polynomials.elimination import discriminant, resultant
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import is_nonnegative
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import in_one, rows_of
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, real
from exactspline.roots.of_polynomials import Parameter, check_isolation, distinct
from exactspline.roots.root import Root
from exactspline.roots.values import exact_place, sign_at, value_at
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import CONTEXT, as_mpoly, as_packed, common_factor, lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

# ---- conditions
# For B(s) = (x, y)/e the condition of a segment a/w of the curve (moved so that Q is the origin) is that the quotient
# `(e ‖a(u)‖² − 2 w (x, y)·a(u))/e` is negative for no u. Bernstein coefficients on boxes decide most cases; the rest
# are decided exactly: whether the members of such a family are non-negative can only change at a parameter at which a
# member has a double zero or a zero at an end, or at which B is infinite.


#: The largest number of segments that are tested first to see whether an arc is on the true bisector at all.
ASKED_FIRST = 24


@dataclass(frozen=True)
class _Family:
    """The condition that one segment of the curve puts on B(s): a form in u for every s. The form is stored as a packed
    polynomial, and by rows for the powers of u.

    On the segment with the foot of B every member is a square times `rest`.
    """

    whole: fmpz_poly
    stride: int
    rows: list[fmpz_poly]
    below: fmpz_poly
    rest: tuple[list[fmpz_poly], int] | None

    def certain(self, e: fmpz_poly, n: int, parts: list[Interval]) -> bool:
        """Whether the condition certainly holds on all of the given parts."""
        if _of_one_sign(self.below, self.whole) or all(_holds_certainly(self.rows, e, n, part) for part in parts):
            return True
        if self.rest is None:
            return False
        rows, degree = self.rest
        return all(_holds_certainly(rows, e, n, part, degree) for part in parts)

    def of_certain_sign(self, n: int, parts: list[Interval]) -> bool:
        """Whether the family certainly has one sign on each of the given parts, whatever the sign of e: then the
        condition changes only at zeros of e.
        """
        rows, m = (self.rows, n) if self.rest is None else self.rest
        return all(_keeps_sign(rows, m, part, 1) or _keeps_sign(rows, m, part, -1) for part in parts)


def _without_foot(whole: fmpz_poly, stride: int, n: int, degree: int) -> tuple[list[fmpz_poly], int] | None:
    """The rows of a family of these degrees in s and u, divided by ``(u − s)²``, and their degree in s; None where ``(u
    − s)²`` is not a factor.
    """
    z, u = CONTEXT.gens()
    quotient, rest = divmod(as_mpoly(whole, stride), (z - u) ** 2)
    if rest or not quotient:
        return None
    return tensor_bernstein.rows(as_packed(quotient, stride), stride, degree - 2), n - 2


class Conditions:
    """``‖a(u)‖²`` and ``2 w(u) a(u)`` on all segments, for a = γw around the origin."""

    def __init__(self, c: Curve[BSpline]) -> None:
        square, twice = norm2(c.p), [x * c.w * 2 for x in c.p]
        self.degree = square.degree
        self.rows = []
        for forms in zip(square.forms, *[x.elevated_to(square).forms for x in twice], strict=True):
            self.rows.append(over_common_denominator(forms)[0])

        #: Arcs that are not on the true bisector usually fail where the curve comes close to Q, or on both sides of Q.
        starts = [Vector(*[x(t) / c.w(t) for x in c.p]) for t in c.w.breakpoints[:-1]]
        #: ``‖a‖²`` and a at the beginning of every segment.
        self.starts = [(norm2(x), *x) for x in starts]

    def _most_against(self, forms: list[fmpz_poly], n: int, t: mpq) -> int:
        """The segment whose start point most strongly violates the condition for B(t), t the local parameter."""
        x, y, e = (value((form, ONE), n, t) for form in forms)
        if not e:
            return 0
        x, y = 2 * x / e, 2 * y / e
        margins = [square - x * a - y * b for square, a, b in self.starts]
        return margins.index(min(margins))

    def kept(
        self, forms: list[fmpz_poly], n: int, segment: tuple[mpq, mpq], own: int | None = None
    ) -> list[tuple[Parameter, Parameter]]:
        """The closed intervals on which B = (x, y)/e of degree n, given on one segment by integer forms, satisfies the
        condition; they are split where B is infinite. `own` is the segment of the curve with the foot of B, at the same
        parameter.

        First, parts of the segment on which a condition certainly fails are excluded, then conditions that certainly
        hold on the rest. Where two excluded parts meet, a condition fails, so that the point is not part of the result.
        """
        e, build = forms[2], self._builder(forms, n, own)
        asked = {self._most_against(forms, n, mpq(k, 8)) for k in (1, 3, 5, 7)}
        first: dict[int, _Family] = {}
        while True:
            first |= {j: build(j) for j in asked}
            open_parts = _possible_parts([family.rows for family in first.values()], e, n)
            if not open_parts:
                return []
            asked = {self._most_against(forms, n, (low + high) / 2) for low, high in open_parts} - first.keys()
            if not asked or len(first) > ASKED_FIRST:
                break
        unclear = {}
        for j in range(len(self.rows)):
            family = first.get(j) or build(j)
            if not family.certain(e, n, open_parts):
                unclear[j] = family
        open_parts = _possible_parts([family.rows for family in (first | unclear).values()], e, n)
        a, b = segment
        intervals: list[tuple[Parameter, Parameter]] = [(a + (b - a) * x, a + (b - a) * y) for x, y in open_parts]
        for family in unclear.values():
            if not intervals:
                break
            if family.certain(e, n, open_parts):
                continue
            if family.of_certain_sign(n, open_parts):
                candidates: list[Parameter] = [t for ends in intervals for t in ends if a < t < b]
            else:
                candidates = [*_candidates(as_mpoly(family.whole, family.stride), segment)]
            poles, holds = _roots(e, segment), partial(self._holds, family.rows, e, n, segment)
            cuts = [a, *distinct([*candidates, *poles]), b]
            intervals = _intersection(intervals, parts_where(holds, cuts, apart=poles))
        return intervals

    def _builder(self, forms: list[fmpz_poly], n: int, own: int | None) -> Callable[[int], _Family]:
        """The maker of the family of a segment; `own` is the segment with the foot of B."""
        x, y, e = forms
        stride = tensor_bernstein.stride_for(n)

        def build(j: int) -> _Family:
            square, cx, cy = (form.inflate(stride) for form in self.rows[j])
            whole = e * square - x * cx - y * cy
            rows = tensor_bernstein.rows(whole, stride, self.degree)
            return _Family(whole, stride, rows, e, _without_foot(whole, stride, n, self.degree) if j == own else None)

        return build

    def _holds(self, rows: list[fmpz_poly], e: fmpz_poly, n: int, segment: tuple[mpq, mpq], t: mpq) -> bool:
        """Whether the member at an inner parameter is non-negative, exactly."""
        a, b = segment
        z = (t - a) / (b - t)
        top, bottom = int(z.numerator), int(z.denominator)
        powers = [top**k * bottom ** (n - k) for k in range(n + 1)]

        def at(row: fmpz_poly) -> Any:
            return sum((x * powers[k] for k, x in enumerate(row.coeffs())), 0)

        member = fmpz_poly([at(row) for row in rows])
        return is_nonnegative(member if at(e) > 0 else -member, self.degree)


def _of_one_sign(e: fmpz_poly, family: fmpz_poly) -> bool:
    """Whether the coefficients alone show that the family divided by e is non-negative everywhere, and that e has no
    inner zero.
    """
    return any(all(x * sign >= 0 for f in (e, family) for x in f.coeffs()) for sign in (1, -1))


def _candidates(family: fmpz_mpoly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner parameters at which the number of sign changes of a member can differ from that of its neighbours.

    Raises `ReachError` if they would take too long.
    """
    if not family:
        return []
    factors = factorize_square_free(family).powers
    candidates: list[Root] = []
    for p, multiplicity in factors:
        if p.degrees()[1] == 0:
            candidates += _roots(in_one(p, 0), segment)
        elif multiplicity % 2:
            candidates += _boundary_parameters(p, segment)
    odd = [p for p, multiplicity in factors if multiplicity % 2 and p.degrees()[1] > 0]
    for i, p in enumerate(odd):
        for other in odd[:i]:
            candidates += _roots(resultant(rows_of(p), rows_of(other)), segment)
    return candidates


def _boundary_parameters(p: fmpz_mpoly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The parameters at which a square-free factor has a double zero, or a zero at an end: the zeros of its
    discriminant and of its first and last coefficient.
    """
    rows = rows_of(p)
    ends = [next(row for row in rows if row), rows[-1]]
    conditions = [*ends, discriminant(rows)] if len(rows) > 2 else ends
    return [root for q in conditions for root in _roots(q, segment)]


def _roots(c: fmpz_poly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner roots of a polynomial in the local z of a segment: the roots of its square-free factors one by one,
    because discriminants have many such factors.
    """
    mesh = Mesh(list(segment))
    check_isolation(c)
    factors = [p for p in factorize_square_free(c).bases if p.degree() > 0] if c else []
    return [
        root
        for p in factors
        for root in zeros(BSpline.from_forms(p.degree(), mesh, (), [(p, ONE)]))
        if not root.at_knot
    ]


def _intersection(
    one: list[tuple[Parameter, Parameter]], other: list[tuple[Parameter, Parameter]]
) -> list[tuple[Parameter, Parameter]]:
    """The common parts of two lists of intervals that are more than a point."""
    common = []
    for a, b in one:
        for c, d in other:
            low: Parameter = a if c <= a else c
            high: Parameter = b if b <= d else d
            if low < high:
                common.append((low, high))
    return common


# ---- certain answers by the signs of coefficients, ahead of the exact ones

#: The numbers of bisections of the local parameter alone, and of both parameters.
DEPTH, DEPTH_OF_BOTH = 10, 10


def _possible_parts(families: Sequence[Sequence[fmpz_poly]], e: fmpz_poly, n: int) -> list[Interval]:
    """The parts of [0, 1] on which no family certainly has the opposite sign of e at the beginning or in the middle of
    its range, with neighbouring parts joined; a part with a zero of e is included only if all families could have the
    same sign.

    >>> _possible_parts([[fmpz_poly([-1, 3])]], fmpz_poly([1, 1]), 1)
    [Interval(255/1024, 1)]
    """
    samples = [form for rows in families for form in (rows[0], _total(rows))]
    search, possible = Search([(UNIT.first, e, samples)], depth_first=True), list[Interval]()
    for interval, below, forms in search:
        sign = _sign(below, n)
        signs = {_sign(form, n) for form in forms}
        # where e has a zero, forms of both signs exclude both sides of the zero
        if -sign in signs if sign else {1, -1} <= signs:
            continue
        if search.depth == DEPTH or (sign and not any(_has_sign(form, -sign) for form in forms)):
            possible.append(interval)
            continue
        parts = [halves(form, n) for form in forms if not sign or _has_sign(form, -sign)]
        own = ([pair[k] for pair in parts] for k in (0, 1))
        search.split([*zip(interval.halves, halves(below, n), own, strict=True)])
    return joined(possible)


def _total(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The family in the middle of its range, up to a positive constant."""
    return sum(rows, start=fmpz_poly([]))


def _sign(form: fmpz_poly, n: int) -> int:
    """The strict sign of all coefficients of a form of degree n, 0 if the signs differ."""
    first = form[0]
    if first == 0 or form.degree() < n:
        return 0
    sign = 1 if first > 0 else -1
    return sign if all(x * sign > 0 for x in form.coeffs()) else 0


def _has_sign(form: fmpz_poly, sign: int) -> bool:
    return any(x * sign > 0 for x in form.coeffs())


def _holds_certainly(
    rows: Sequence[fmpz_poly], e: fmpz_poly, n: int, interval: Interval, degree: int | None = None
) -> bool:
    """Whether a family certainly has the sign of e, or is zero, on a whole part, by coefficients on smaller and smaller
    boxes.

    The rows of the family have the degree n of e, or the given degree.
    """
    sign = _sign(restrict((e, ONE), n, *interval)[0], n)
    return bool(sign) and _keeps_sign(rows, n if degree is None else degree, interval, sign)


def _keeps_sign(rows: Sequence[fmpz_poly], m: int, interval: Interval, sign: int) -> bool:
    """Whether a family of degree m in z certainly has the given sign, or is zero, on a whole part.

    >>> _keeps_sign([fmpz_poly([1, -1]), fmpz_poly([2, 1])], 1, Interval(mpq(0), mpq(1, 4)), 1)
    True
    """
    search = Search([PatchForm.of_rows(rows, m).part(Box(interval, UNIT.second))], depth_first=True)
    for form in search:
        low, high = form.range
        if (low if sign > 0 else -high) >= 0:
            continue
        if search.depth == DEPTH_OF_BOTH or any(x * sign < 0 for x in form.corners):
            return False
        search.split(form.halves(1 - search.depth % 2))
    return True


class PieceKind(StrEnum):
    """The location of the feet of a piece."""

    ARC = "arc"
    END_POINT = "end point"
    CORNER = "corner"


@dataclass(frozen=True)
class TrimmedPiece:
    """A piece of the true bisector over the interval [low, high] of its parameter.

    ``kind`` is ``arc`` (the parameter is that of the curve, and the foot of B(s) is γ(s)), ``end point`` or ``corner``.
    The last two are pieces of a straight line, whose foot is the point of the curve at ``foot``; the parameter runs
    over [−1, 1], with the midpoint of Q and the foot at 0 and infinity at −1 and 1. ``value`` is a `Rational` over the
    whole segment or line.
    """

    kind: PieceKind
    low: Parameter
    high: Parameter
    value: Rational[BSpline]
    foot: mpq | None = None

    @one_line
    def __repr__(self) -> str:
        return f"<TrimmedPiece: {self.kind}>"

    def __call__(self, t: Number) -> tuple[mpq, ...]:
        """The point at a parameter of the piece; raises `ShapeError` outside the piece, `ZeroDivisionError` at an end
        at infinity.
        """
        return self.value.point(within(t, self.low, self.high))

    @property
    def described(self) -> NamedNumbers:
        """The end points, except points at infinity, then their parameters, and the parameter of the foot."""
        ends, values = {"start": exact_place(self.low), "end": exact_place(self.high)}, dict[str, Real]()
        for name, t in ends.items():
            if sign_at(self.value.denominator, t):
                point = [value_at(f, self.value.denominator, t) for f in self.value.vector]
                values |= zip((f"{name} x", f"{name} y"), point, strict=True)
        feet = {} if self.foot is None else {"foot": Real(self.foot)}
        return NamedNumbers(str(self.kind), values | {name: real(t) for name, t in ends.items()} | feet)

    def restricted(self) -> Rational[BSpline] | None:
        """The piece as a quotient over [low, high] alone; None where an end is irrational."""
        low, high = (t.exact if isinstance(t, Root) else t for t in (self.low, self.high))
        if low is None or high is None:
            return None
        value = self.value
        if (low, high) == value.denominator.domain:
            return value
        return Rational(Vector(*[x.restrict(low, high) for x in value.vector]), value.denominator.restrict(low, high))


@dataclass(frozen=True, repr=False)
class TrimmedBisector(Bisector):
    """The true bisector in pieces; ``missing`` lists segments without an arc and corners without a line, with the
    reasons. ``undecided`` lists the parts that would have taken too long; if it is empty, the answer is complete.
    """

    pieces: tuple[TrimmedPiece, ...]
    missing: tuple[str, ...]
    undecided: tuple[str, ...] = ()

    @property
    def items(self) -> tuple[NamedNumbers, ...]:
        """The pieces as named numbers."""
        return tuple(piece.described for piece in self.pieces)

    @property
    def arcs(self) -> list[TrimmedPiece]:
        """The pieces with their feet inside the curve."""
        return [piece for piece in self.pieces if piece.kind is PieceKind.ARC]


def trimmed_bisector(curve: Nurbs, point: Iterable[Number]) -> TrimmedBisector:
    """The true bisector of a plane curve and a point.

    >>> from exactspline import Nurbs
    >>> line = Nurbs(1, [0, 0, 1, 1], [(-4, 0), (4, 0)])
    >>> [(str(piece.kind), piece.foot) for piece in trimmed_bisector(line, (0, 2)).pieces]
    [('arc', None), ('end point', mpq(0,1)), ('end point', mpq(1,1))]

    The work is limited as for the bisector of two curves.

    Raises `ShapeError` for a curve that is not in the plane or not connected, and for a point on the curve.
    """
    curve = curve_of(curve)
    q = exact_point(curve, point, 2)
    for joint in facts_of(curve).joints:
        if joint.kind is JointKind.GAP:
            raise ShapeError(f"the curve jumps at the parameter {text(joint.parameter)}", remedy="split it there")
    c = _around(curve, q)
    _refuse_point_on(c)
    with drawing_on(Budget(QUESTION + PATCH * (curve.segments - 1))):
        return _trimmed(curve, c, q)


def _trimmed(curve: Nurbs, c: Curve[BSpline], q: tuple[mpq, ...]) -> TrimmedBisector:
    """The pieces of a curve; c is the curve with Q moved to the origin."""
    conditions = Conditions(c)
    pieces, missing, undecided = list[TrimmedPiece](), list[str](), list[str]()
    for i, (a, b) in enumerate(pairwise(curve.breakpoints)):
        arc = _arc(c, i)
        if isinstance(arc, str):
            missing.append(f"[{short_text(a)}, {short_text(b)}]: {arc}")
            continue
        forms, value = arc
        moved = Rational(value.vector + Vector(*[value.denominator * x for x in q]), value.denominator)
        try:
            kept = conditions.kept(*forms, (a, b), i)
        except ReachError as error:
            undecided.append(f"the arcs with feet in [{short_text(a)}, {short_text(b)}]: {error.problem}")
            continue
        pieces += [TrimmedPiece(PieceKind.ARC, low, high, moved) for low, high in kept]
    for kind, t in _corners(curve, missing):
        try:
            pieces += _line_pieces(conditions, c, q, kind, t)
        except ReachError as error:
            undecided.append(f"the line with its foot at {short_text(t)}: {error.problem}")
    return TrimmedBisector(tuple(pieces), tuple(missing), tuple(undecided))


def _around(curve: Nurbs, q: tuple[mpq, ...]) -> Curve[BSpline]:
    """The curve with Q moved to the origin and w positive."""
    sign = 1 if curve.w(curve.domain[0]) > 0 else -1
    p = Vector(*[(x - curve.w * y).scaled(sign) for x, y in zip(curve.p, q, strict=True)])
    return Curve(p, curve.w.scaled(sign), polynomial=curve.polynomial).with_point((0, 0))


def _refuse_point_on(c: Curve[BSpline]) -> None:
    on = zeros(common_factor(c.p))
    knots = [t for t in c.w.breakpoints if any(all(x(t, side) == 0 for x in c.p) for side in Side)]
    if len(on) or knots:
        where = text(knots[0]) if knots else repr(on[0])
        raise ShapeError(
            f"the point lies on the curve, at {where}", remedy="the bisector is a part of the curve's normal there"
        )


def _arc(c: Curve[BSpline], i: int) -> tuple[tuple[list[fmpz_poly], int], Rational[BSpline]] | str:
    """The untrimmed bisector of segment i around the origin, in lowest terms: its integer forms, their degree, and the
    quotient.

    Where there is no bisector, or only a point, the reason as text; if such a point is on the true bisector,
    neighbouring pieces end there.
    """
    a, b = c.w.breakpoints[i : i + 2]
    part = c.mapped(lambda f: f.restrict(a, b))
    bisector = find("plane_bisector_polynomial")(part)
    if bisector.denominator.is_zero:
        return STILL if find("D1")(part).is_zero else THROUGH
    (forms, n) = lowest_terms(bisector)[0]
    if n == 0:
        return AROUND
    x, y, below = [BSpline.from_forms(n, Mesh([a, b]), (), [(form, ONE)]) for form in forms]
    return (forms, n), Rational(Vector(x, y), below)


def _corners(curve: Nurbs, missing: list[str]) -> list[tuple[PieceKind, mpq]]:
    """The ends of an open curve, its corners and its singular points, by their parameters, each point once; irrational
    parameters are added to `missing`.
    """
    a, b = curve.domain
    # a curve that is a single point is closed and consists of ends only
    has_ends = not curve.closed or find("D1")(curve).is_zero
    ends = [(PieceKind.END_POINT, a), (PieceKind.END_POINT, b)] if has_ends else []
    ends += [(PieceKind.CORNER, joint.parameter) for joint in facts_of(curve).joints if joint.kind is JointKind.CORNER]
    for feature in facts_of(curve).singular_points:
        if feature.root.exact is None:
            missing.append(
                f"the line that belongs to the singular point at {feature.root!r}: its coordinates are irrational"
            )
        elif feature.kind is not FeatureKind.SINGULAR_END:
            ends.append((PieceKind.CORNER, feature.root.exact))
    points: dict[Any, tuple[PieceKind, mpq]] = {}
    for kind, t in ends:
        points.setdefault(curve(t), (kind, t))
    return list(points.values())


def _line_pieces(
    conditions: Conditions, c: Curve[BSpline], q: tuple[mpq, ...], kind: PieceKind, t: mpq
) -> list[TrimmedPiece]:
    """The kept part of the line of points as far from the origin as from the point of the curve at t."""
    w = c.w(t)
    foot = Vector(*[x(t) / w for x in c.p])
    across, middle = perp(foot), Vector(*[x / 2 for x in foot])
    mesh, kept, halves = Mesh([mpq(-1), mpq(0), mpq(1)]), [], []
    for side, segment in ((-1, (mpq(-1), mpq(0))), (1, (mpq(0), mpq(1)))):
        ends = [(m, side * x) if side > 0 else (side * x, m) for m, x in zip(middle, across, strict=True)]
        _, scale = over_one_denominator([x for end in ends for x in end])
        forms = [fmpz_poly([int(x * scale) for x in end]) for end in ends]
        below = fmpz_poly([scale, 0] if side > 0 else [0, scale])
        halves.append([*forms, below])
        kept += conditions.kept([*forms, below], 1, segment)
    columns = [
        BSpline.from_forms(1, mesh, (0,), [(form, ONE) for form in column])
        for column in zip(*_same_scale(halves), strict=True)
    ]
    value = Rational(Vector(*[x + columns[2] * y for x, y in zip(columns[:2], q, strict=True)]), columns[2])
    merged: list[tuple[Parameter, Parameter]] = []
    for low, high in kept:
        if merged and merged[-1][1] == low:
            merged[-1] = (merged[-1][0], high)
        else:
            merged.append((low, high))
    return [TrimmedPiece(kind, low, high, value, t) for low, high in merged]


def _same_scale(halves: list[list[fmpz_poly]]) -> list[list[fmpz_poly]]:
    """Both halves of the line, scaled to the same value of the denominator in the middle, so that the splines are
    continuous there.
    """
    (left, right) = halves
    a, b = left[2][1], right[2][0]
    return [[form * b for form in left], [form * a for form in right]]
