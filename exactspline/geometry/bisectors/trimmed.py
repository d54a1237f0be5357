"""The true bisector of a point and a plane curve: the points as far from the point as from the *whole* curve (Farouki
and Johnstone 1994).

A point B is on it when no point of the curve is inside the circle around B through Q: ``‖γ(u) − Q‖² − 2 (B − Q)·(γ(u) −
Q) ≥ 0`` for all u. For the untrimmed bisector B(s), and for the line of points as far from Q as from a corner of the
curve, that is a family of polynomials in u (see `exactspline.geometry.bisectors.conditions`).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise
from typing import Any

from flint import fmpz_poly

from exactspline.errors import ReachError, ShapeError
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.conditions import Conditions
from exactspline.geometry.bisectors.missing import AROUND, STILL, THROUGH
from exactspline.geometry.bisectors.point_and_curve import exact_point
from exactspline.geometry.curves.facts import facts_of
from exactspline.geometry.curves.kinds import FeatureKind, JointKind
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector, perp
from exactspline.numbers.exact import Number, mpq, over_one_denominator, rational, text
from exactspline.numbers.sides import Side
from exactspline.one_line import one_line, short_text
from exactspline.papers import find
from exactspline.polynomials.bernstein import ONE
from exactspline.polynomials.cost import PATCH, QUESTION, Budget, drawing_on
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, real
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.root import Root
from exactspline.roots.values import exact_place, sign_at, value_at
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import common_factor, lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of


class PieceKind(StrEnum):
    """Where the feet of a piece lie."""

    ARC = "arc"
    END_POINT = "end point"
    CORNER = "corner"


@dataclass(frozen=True)
class TrimmedPiece:
    """A piece of the true bisector over [low, high] of its parameter.

    ``kind`` is ``arc`` (its parameter is that of the curve, B has its foot at γ(s)), ``end point`` or ``corner`` (a
    piece of a straight line: its foot is the point of the curve at ``foot``; its parameter runs over [−1, 1], the
    middle of Q and the foot at 0, infinite at −1 and 1). ``value`` is a `Rational` over the whole segment or line.
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
        """The point at a parameter of the piece; raises `ShapeError` outside it, `ZeroDivisionError` at an end at
        infinity.
        """
        t = rational(t)
        if not self.low <= t <= self.high:
            raise ShapeError(f"{short_text(t)} is outside this piece", remedy="stay between low and high")
        return self.value.point(t)

    @property
    def described(self) -> NamedNumbers:
        """The points of both ends, without one at infinity, then the parameters, and that of the foot."""
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
    reason. ``undecided`` names what would have taken too long; where it is empty the answer is complete.
    """

    pieces: tuple[TrimmedPiece, ...]
    missing: tuple[str, ...]
    undecided: tuple[str, ...] = ()

    @property
    def items(self) -> tuple[NamedNumbers, ...]:
        """Its pieces."""
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

    The work on the whole answer is bounded as for the bisector of two curves.

    Raises `ShapeError` for a curve that is not in the plane or not in one piece, and for a point on the curve.
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

    Where there is none, or only a point, the reason as text; where that point is on the true bisector, neighbouring
    pieces end there.
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
    ones are added to `missing`.
    """
    a, b = curve.domain
    has_ends = (
        not curve.closed or find("D1")(curve).is_zero
    )  # a curve that is a single point is closed, and consists of ends
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
    """Both halves of the line with one value of the denominator in the middle, so that the splines are continuous
    there.
    """
    (left, right) = halves
    a, b = left[2][1], right[2][0]
    return [[form * b for form in left], [form * a for form in right]]
