"""The true bisector of a point and a plane curve: the points as far from the point as from the *whole* curve (Farouki
and Johnstone 1994).

A point B is on it when the circle around B through the point Q has no point of the curve inside:
``‖γ(u) − Q‖² − 2 (B − Q)·(γ(u) − Q) ≥ 0`` for all u. For the untrimmed bisector B(s), and for the line of points as far
from Q as from a corner of the curve, that is a family of polynomials in u; where its members are non-negative can only
change at a parameter at which one of them has a double zero or a zero at an end, or at which B is infinite. These
parameters are isolated, and one exact decision is made between each two.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import StrEnum
from functools import partial
from itertools import pairwise
from math import lcm
from typing import Any

from flint import fmpz, fmpz_mpoly, fmpz_poly

from exactspline.errors import ShapeError
from exactspline.exact import Number, mpq, ratio, rational, text
from exactspline.geometry.bisector.certain_parts import Part, holds_certainly, keeps_sign, possible_parts
from exactspline.geometry.bisector.discriminants import discriminant
from exactspline.geometry.bisector.missing import AROUND, STILL, THROUGH
from exactspline.geometry.bisector.point_and_curve import exact_point
from exactspline.geometry.features import joints, singular_points
from exactspline.geometry.kinds import JointKind
from exactspline.language.arguments import Curve
from exactspline.language.choices import Side
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, norm2, perp
from exactspline.papers import find
from exactspline.roots.root import Root, between
from exactspline.roots.zero_set import zeros
from exactspline.splines import tensor_bernstein
from exactspline.splines.bernstein import ONE, bezier, is_nonnegative
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import common_factor, lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor_lowest_terms import CONTEXT, as_mpoly, as_packed

#: So many segments near the point, and as many from all over the curve, are asked first whether an arc is on the true
#: bisector at all.
NEAREST = 6
#: An exact parameter: rational, or a certified root.
Parameter = mpq | Root


class PieceKind(StrEnum):
    """What a piece has for its feet."""

    ARC = "arc"
    END_POINT = "end point"
    CORNER = "corner"


@dataclass(frozen=True)
class TrimmedPiece:
    """A piece of the true bisector over [low, high] of its own parameter.

    ``kind`` is ``arc`` (its parameter is that of the curve, B has its foot at γ(s)), ``end point`` or ``corner`` (a
    piece of a straight line: its foot is the point of the curve at ``foot``; its parameter runs over [−1, 1], the
    middle of Q and the foot at 0, infinite at −1 and 1). ``value`` is a `Rational` over the whole segment or line.
    """

    kind: PieceKind
    low: Parameter
    high: Parameter
    value: Rational[BSpline]
    foot: mpq | None = None

    def __call__(self, t: Any) -> tuple[mpq, ...]:
        """The point at a parameter of the piece; `ShapeError` outside it, `ZeroDivisionError` at an end that is
        infinite.
        """
        t = rational(t)
        if not self.low <= t <= self.high:
            raise ShapeError(f"{text(t)} is outside this piece", remedy="stay between low and high")
        point: tuple[mpq, ...] = self.value(t)
        return point

    def restricted(self) -> Rational[BSpline] | None:
        """The piece as a quotient over [low, high] alone; None where an end is irrational."""
        low, high = (_rational(t) for t in (self.low, self.high))
        if low is None or high is None:
            return None
        value = self.value
        if (low, high) == value.denominator.domain:
            return value
        top = Vector(*[x.restrict(low, high) for x in value.vector])
        return Rational(top, value.denominator.restrict(low, high))


def _rational(t: Parameter) -> mpq | None:
    if not isinstance(t, Root):
        return t
    t.minimal_polynomial()
    return t.exact


@dataclass(frozen=True)
class TrimmedBisector:
    """The true bisector in pieces; ``missing`` tells of segments without an arc, and of corners without a line, with
    the reason.
    """

    pieces: tuple[TrimmedPiece, ...]
    missing: tuple[str, ...]

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

    Raises `ShapeError` for a curve that is not in the plane or not in one piece, and for a point on the curve.
    """
    q = exact_point(curve, point, 2)
    for joint in joints(curve):
        if joint.kind is JointKind.GAP:
            raise ShapeError(f"the curve jumps at the parameter {text(joint.parameter)}", remedy="split it there")
    c = _around(curve, q)
    _refuse_point_on(c)
    conditions = _Conditions(c)
    pieces, missing = [], []
    for i, (a, b) in enumerate(pairwise(curve.breakpoints)):
        arc = _arc(c, i)
        if isinstance(arc, str):
            missing.append(f"[{text(a)}, {text(b)}]: {arc}")
            continue
        forms, value = arc
        moved = Rational(value.numerator + Vector(*[value.denominator * x for x in q]), value.denominator)
        for low, high in conditions.kept(*forms, (a, b), i):
            pieces.append(TrimmedPiece(PieceKind.ARC, low, high, moved))
    for kind, t in _corners(curve, missing):
        pieces += _line_pieces(conditions, c, q, kind, t)
    return TrimmedBisector(tuple(pieces), tuple(missing))


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

    The reason instead where there is none, or but a point: where that is on the true bisector, pieces beside it end
    there.
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


@dataclass(frozen=True)
class _Family:
    """The condition of one segment of the curve on B(s): a form in u for every s, packed, and its rows by powers of u.

    On the segment that B has its foot on every member is a square times what `rest` holds.
    """

    whole: fmpz_poly
    stride: int
    rows: list[fmpz_poly]
    below: fmpz_poly
    rest: tuple[list[fmpz_poly], int] | None

    def certain(self, e: fmpz_poly, n: int, parts: list[Part]) -> bool:
        """Whether it holds certainly all over some parts."""
        if _of_one_sign(self.below, self.whole) or all(holds_certainly(self.rows, e, n, part) for part in parts):
            return True
        if self.rest is None:
            return False
        rows, degree = self.rest
        return all(holds_certainly(rows, e, n, part, degree) for part in parts)

    def of_certain_sign(self, n: int, parts: list[Part]) -> bool:
        """Whether it certainly has one sign on each of some parts, whatever that of e: the condition then changes where
        e has a zero.
        """
        rows, m = (self.rows, n) if self.rest is None else self.rest
        return all(keeps_sign(rows, m, part, 1) or keeps_sign(rows, m, part, -1) for part in parts)


def _borders(parts: list[Part], segment: tuple[mpq, mpq]) -> list[Parameter]:
    """The ends of parts of a segment by the parameter of the curve, those of the segment left out."""
    a, b = segment
    return [a + (b - a) * t for part in parts for t in part if 0 < t < 1]


def _without_foot(whole: fmpz_poly, stride: int, n: int, degree: int) -> tuple[list[fmpz_poly], int] | None:
    """The rows of a family of these degrees in s and u over ``(u − s)²``, and their degree in s; None where that does
    not divide it.
    """
    z, u = CONTEXT.gens()
    quotient, rest = divmod(as_mpoly(whole, stride), (z - u) ** 2)
    if rest or not quotient:
        return None
    return tensor_bernstein.rows(as_packed(quotient, stride), stride, degree - 2), n - 2


class _Conditions:
    """``‖a(u)‖²`` and ``2 w(u) a(u)`` on all segments, for a = γw around the origin."""

    def __init__(self, c: Curve[BSpline]) -> None:
        square, twice = norm2(c.p), [x * c.w * 2 for x in c.p]
        self.degree, self._w = square.degree, c.w
        self.rows = []
        for forms in zip(square.forms, *[x.elevated_to(square).forms for x in twice], strict=True):
            common = ONE
            for _, m in forms:
                common = common.lcm(m)
            self.rows.append([form * (common // m) for form, m in forms])

        #: What is not on the true bisector mostly fails where the curve comes near Q, or on both sides of Q.
        count = len(self.rows)
        self.nearest = {
            *sorted(range(count), key=self._closeness)[:NEAREST],
            *(k * count // NEAREST for k in range(NEAREST)),
        }

    def _closeness(self, j: int) -> mpq:
        """The least Bézier ordinate of ``‖a‖²`` over the largest of w²: cheap, and no more than an order."""
        (square, *_), w = self.rows[j], self._w.polynomials[j]
        m = ratio(ONE, self._w.denominators[j])
        largest = max(abs(x) for x in bezier((w, ONE), self._w.degree)) * m
        return min(bezier((square, ONE), self.degree)) / (largest * largest)

    def kept(
        self, forms: list[fmpz_poly], n: int, segment: tuple[mpq, mpq], own: int | None = None
    ) -> list[tuple[Parameter, Parameter]]:
        """Where B = (x, y)/e of degree n, given on one segment by integer forms, meets the condition: closed intervals,
        split where B is infinite. `own` is the segment of the curve that B has its foot on, at the same parameter.

        Parts of the segment on which one condition fails certainly are set aside first, and conditions that hold
        certainly on the rest. At a border between both a condition fails, so that it is none of the latter.
        """
        e, build = forms[2], self._builder(forms, n, own)
        first = {j: build(j) for j in {*self.nearest, *([] if own is None else [own])}}
        open_parts = possible_parts([family.rows for family in first.values()], e, n)
        if not open_parts:
            return []
        unclear = {}
        for j in range(len(self.rows)):
            family = first.get(j) or build(j)
            if not family.certain(e, n, open_parts):
                unclear[j] = family
        open_parts = possible_parts([family.rows for family in (first | unclear).values()], e, n)
        found: list[tuple[Parameter, Parameter]] = [segment] if open_parts else []
        for family in unclear.values():
            if not found:
                break
            if family.certain(e, n, open_parts):
                continue
            if family.of_certain_sign(n, open_parts):
                candidates: list[Parameter] = _borders(open_parts, segment)
            else:
                candidates = [*_candidates(as_mpoly(family.whole, family.stride), segment)]
            holds = partial(self._holds, family.rows, e, n, segment)
            found = _intersection(found, _cells(candidates, _roots(e, segment), segment, holds))
        return _on_parts(found, open_parts, segment)

    def _builder(self, forms: list[fmpz_poly], n: int, own: int | None) -> Callable[[int], _Family]:
        """What makes the family of a segment; `own` is that on which B has its foot."""
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


def _on_parts(
    found: list[tuple[Parameter, Parameter]], parts: list[Part], segment: tuple[mpq, mpq]
) -> list[tuple[Parameter, Parameter]]:
    """The intervals that are not in a part that was set aside; none is in both."""
    a, b = segment
    kept = []
    for low, high in found:
        middle = (between(low, high) - a) / (b - a)
        if any(first <= middle <= last for first, last in parts):
            kept.append((low, high))
    return kept


def _of_one_sign(e: fmpz_poly, family: fmpz_poly) -> bool:
    """Whether the coefficients alone show that the family is non-negative over e everywhere, and e without an inner
    zero.
    """
    return any(all(x * sign >= 0 for f in (e, family) for x in f.coeffs()) for sign in (1, -1))


def _candidates(family: fmpz_mpoly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner parameters at which the number of sign changes of a member can differ from that of its neighbours."""
    if not family:
        return []
    _, factors = family.factor_squarefree()
    found: list[Root] = []
    for p, multiplicity in factors:
        if p.degrees()[1] == 0:
            found += _roots(_in_z(p), segment)
        elif multiplicity % 2:
            found += _boundary_parameters(p, segment)
    odd = [p for p, multiplicity in factors if multiplicity % 2 and p.degrees()[1] > 0]
    for i, p in enumerate(odd):
        for other in odd[:i]:
            found += _roots(_in_z(p.resultant(other, 1)), segment)
    return found


def _boundary_parameters(p: fmpz_mpoly, segment: tuple[mpq, mpq]) -> list[Root]:
    """Where a square-free factor has a double zero, or one at an end: discriminant, first and last coefficient."""
    by_power: dict[int, dict[int, fmpz]] = {}
    for (i, j), x in p.terms():
        by_power.setdefault(int(j), {})[int(i)] = x
    rows = [_polynomial(by_power.get(j, {})) for j in range(max(by_power) + 1)]
    ends = [rows[min(by_power)], rows[-1]]
    conditions = [*ends, discriminant(rows)] if len(rows) > 2 else ends
    return [root for q in conditions for root in _roots(q, segment)]


def _polynomial(terms: dict[int, fmpz]) -> fmpz_poly:
    return fmpz_poly([terms.get(i, fmpz(0)) for i in range(max(terms, default=-1) + 1)])


def _in_z(p: fmpz_mpoly) -> fmpz_poly:
    coefficients = [fmpz(0)] * (int(p.degrees()[0]) + 1) if p else []
    for (i, _), x in p.terms():
        coefficients[int(i)] = x
    return fmpz_poly(coefficients)


def _roots(c: fmpz_poly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner roots of a polynomial in the local z of a segment: of its square-free factors one by one, for
    discriminants have many of them.
    """
    mesh = Mesh(list(segment))
    factors = [p for p, _ in c.factor_squarefree()[1] if p.degree() > 0] if c else []
    return [
        root
        for p in factors
        for root in zeros(BSpline.from_forms(p.degree(), mesh, (), [(p, ONE)]))
        if not root.at_knot
    ]


def _cells(
    candidates: list[Parameter], poles: list[Root], segment: tuple[mpq, mpq], holds: Callable[[mpq], bool]
) -> list[tuple[Parameter, Parameter]]:
    """The closed intervals between candidates on which the condition holds; neighbours are one, unless B is infinite
    between them.
    """
    a, b = segment
    found: list[tuple[Parameter, Parameter]] = []
    ends: list[Parameter] = [a, *_distinct([*candidates, *poles]), b]
    for low, high in pairwise(ends):
        if holds(between(low, high)):
            if found and found[-1][1] == low and not any(low == pole for pole in poles):
                found[-1] = (found[-1][0], high)
            else:
                found.append((low, high))
    return found


def _distinct(roots: list[Parameter]) -> list[Parameter]:
    distinct: list[Parameter] = []
    for root in sorted(roots):
        if not distinct or distinct[-1] != root:
            distinct.append(root)
    return distinct


def _intersection(
    one: list[tuple[Parameter, Parameter]], other: list[tuple[Parameter, Parameter]]
) -> list[tuple[Parameter, Parameter]]:
    """The common parts of two lists of intervals that are more than a point."""
    found = []
    for a, b in one:
        for c, d in other:
            low: Parameter = a if c <= a else c
            high: Parameter = b if b <= d else d
            if low < high:
                found.append((low, high))
    return found


def _corners(curve: Nurbs, missing: list[str]) -> list[tuple[PieceKind, mpq]]:
    """The ends of an open curve, its corners and its singular points, by their parameters, each point once; irrational
    ones are named as missing.
    """
    a, b = curve.domain
    has_ends = not curve.closed or find("D1")(curve).is_zero  # a curve that is one point is closed, and all end
    found = [(PieceKind.END_POINT, a), (PieceKind.END_POINT, b)] if has_ends else []
    found += [(PieceKind.CORNER, joint.parameter) for joint in joints(curve) if joint.kind is JointKind.CORNER]
    for feature in singular_points(curve):
        feature.root.minimal_polynomial()
        if feature.root.exact is None:
            missing.append(
                f"the line that belongs to the singular point at {feature.root!r}: its coordinates are irrational"
            )
        elif feature.kind != "singular end":
            found.append((PieceKind.CORNER, feature.root.exact))
    points: dict[Any, tuple[PieceKind, mpq]] = {}
    for kind, t in found:
        points.setdefault(curve(t), (kind, t))
    return list(points.values())


def _line_pieces(
    conditions: _Conditions, c: Curve[BSpline], q: tuple[mpq, ...], kind: PieceKind, t: mpq
) -> list[TrimmedPiece]:
    """The kept part of the line of points as far from the origin as from the point of the curve at t."""
    w = c.w(t)
    foot = Vector(*[x(t) / w for x in c.p])
    across, middle = perp(foot), Vector(*[x / 2 for x in foot])
    mesh, kept, halves = Mesh([mpq(-1), mpq(0), mpq(1)]), [], []
    for side, segment in ((-1, (mpq(-1), mpq(0))), (1, (mpq(0), mpq(1)))):
        ends = [(m, side * x) if side > 0 else (side * x, m) for m, x in zip(middle, across, strict=True)]
        scale = lcm(*[int(x.denominator) for end in ends for x in end])
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
    """Both halves of the line with one value of the denominator in the middle, so that the splines are continuous
    there.
    """
    (left, right) = halves
    a, b = left[2][1], right[2][0]
    return [[form * b for form in left], [form * a for form in right]]
