"""The bisector of two plane curves: the zeros of a function of both parameters
(`exactspline.geometry.bisectors.plane_pair`).

Source: Elber and Kim, Bisector curves of planar rational curves, Computer-Aided Design 1998.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain, compress, product
from math import comb
from typing import NamedTuple

from flint import fmpz, fmpz_mat, fmpz_mpoly

from exactspline.bivariate.zeros import ZeroArc, ZeroCurves, zero_curve
from exactspline.errors import ReachError
from exactspline.geometry.bisectors.common import Bisector
from exactspline.geometry.bisectors.plane_pair import PlanePair, tangent
from exactspline.geometry.bisectors.system import SegmentOfCurve, piece
from exactspline.language.vector import Vector, det, dot, norm2, perp
from exactspline.numbers.exact import Number, mpq, over_one_denominator
from exactspline.numbers.intervals import UNIT, Box, Interval, Side
from exactspline.numbers.once import cached_property
from exactspline.numbers.search import Search
from exactspline.one_line import one_line
from exactspline.polynomials.patch_forms import PatchForm, rounded
from exactspline.polynomials.two_parameters import S, T, as_form, as_forms, lifted
from exactspline.questions.answers import NamedNumbers
from exactspline.reals.real import Real, real
from exactspline.roots.values import evaluate, exact_place, sign_at
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import Along
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.type_checks import curve_of, of_dimension

# ---- true pairs
# Let B be the point on the normal at γ(s) that is equally far from γ(s) and γ̄(t): at the zeros of the function of the
# bisector B is on the normal at γ̄(t), too. With the tangent a at γ(s), the chord E, the weights w, v and `D(s, u) =
# w(s) p(u) − w(u) p(s)` no point γ(u) is nearer to B than γ(s) where `|D|² v [a E] − w(u) (D·a⊥) (E·E)` has the sign of
# `[a E]` for all u. On the segment of the foot itself D has the factor u − s, and D·a⊥ its square. The coefficients of
# these forms decide this for all pairs of a box at once.
#
# Source: Elber and Kim, Bisector curves of planar rational curves, Computer-Aided Design 1998, which trims by sampling.


#: The number of bisections of a box before all other points are compared with its feet; the largest number of
#: bisections of a box, and of the parameter of the other points; and the number of boxes per segment that may be
#: compared with a segment.
FIRST, DEPTH, DEPTH_OF_OTHER, BOXES = 4, 20, 8, 6000
#: The number of equal steps in which a point that is certainly nearer than a foot is searched, twice.
STEPS = 16
#: The cost of the function of a pair of segments, in comparisons of a box with a segment; and the least number of boxes
#: of a pair that may be compared with all segments.
PAIR, SHARE = 50, 50
HALF = mpq(1, 2)


@dataclass(frozen=True)
class TruePairs:
    """The boxes in which the zeros of the function of a bisector of plane curves are pairs of true feet: all zeros in
    the boxes `kept` are, zeros in the `undecided` boxes may be, all others are not. Pairs at which a curve has no
    tangent are left out of account; a segment that is a single point is undecided.
    """

    kept: tuple[Box, ...]
    undecided: tuple[Box, ...]

    @one_line
    def __repr__(self) -> str:
        return f"<TruePairs in {len(self.kept)} boxes, undecided in {len(self.undecided)}>"


#: Intervals of the parameter of a segment, and the forms that compare its points with a foot.
Families = list[tuple[Interval, list[PatchForm]]]


class _Foot:
    """Whether no point of a curve is nearer to B than the foot on one of its segments; s is the parameter of the foot,
    t that of the foot on the other curve.
    """

    def __init__(self, curve: Sequence[SegmentOfCurve], own: int, other: SegmentOfCurve) -> None:
        self.curve, self.own = curve, own
        pair, (*p, self.w) = PlanePair(curve[own].over(0), other.over(1)), curve[own].over(0)[0]
        self.p, self.normal = Vector(*p), perp(pair.a)
        self.across, self.along = det(pair.a, pair.chord) * lifted(other.w, 1), norm2(pair.chord)
        #: Both have the same constant factor.
        self.factors = as_forms([self.across, self.along])

    @cached_property
    def against(self) -> list[PatchForm]:
        """For the middle of every segment, forms that have the opposite sign of `across` where it is nearer. The first
        form has it where B lies beyond the centre of curvature at the foot.
        """
        square, twice = (f.compose(S, S) for f in self._over_own)
        found = [as_form(square * self.across - twice * self.along)]
        for segment in self.curve:
            x, y, weight = segment.homogeneous(segment.interval.middle)
            d = Vector(self.w * x - self.p[0] * weight, self.w * y - self.p[1] * weight)
            found.append(as_form(norm2(d) * self.across - dot(d, self.normal) * self.along * weight))
        return found

    @cached_property
    def families(self) -> Families:
        """``|D|²`` and ``w(u) (D·a⊥)`` with a common constant factor, for every segment of the curve, with the
        parameter u. On the segment of the foot both are divided by ``(u − s)²``.
        """
        found = []
        for j, segment in enumerate(self.curve):
            forms = self._over_own if j == self.own else self._against_segment(segment)
            found.append((segment.interval, as_forms(forms)))
        return found

    @cached_property
    def _over_own(self) -> tuple[fmpz_mpoly, fmpz_mpoly]:
        square, twice = self._against_segment(self.curve[self.own])
        return square / (T - S) ** 2, twice / (T - S) ** 2

    def _against_segment(self, segment: SegmentOfCurve) -> tuple[fmpz_mpoly, fmpz_mpoly]:
        (*q, v), _ = segment.over(1)
        d = Vector(*[self.w * y - v * x for x, y in zip(self.p, q, strict=True)])
        return norm2(d), dot(d, self.normal) * v

    def compared(self, box: Box, families: Families) -> Families | None:
        """Those of these segments that may have a point nearer than the foot for some pairs of a box; None if for all
        pairs of the box a point is nearer.
        """
        (across, along), found = (form.part(box) for form in self.factors), Families()
        if not across.sign:
            return families
        for sides, forms in families:
            verdict = verdict_on(across.sign, across, along, forms, box.first, sides)
            if verdict is False:
                return None
            if verdict is None:
                found.append((sides, forms))
        return found


def verdict_on(
    sign: int, across: PatchForm, along: PatchForm, forms: Sequence[PatchForm], own: Interval, sides: Interval
) -> bool | None:
    """The certain sign of ``N A − C M``, for N ≥ 0 and M on ``own × sides`` and A and C each on ``own ×`` another side.
    True: it nowhere has the sign opposite to the given one. False: for some u it has the opposite sign for all other
    parameters. None: neither is certain.
    """
    whole = tuple(form.part(Box(own, sides)) for form in forms)
    sizes, search = [sign * x for x in across.range], Search([whole], depth_first=True)
    for square, twice in search:
        low = square.range[0] if square.range[0] > 0 else fmpz(0)
        if low * min(sizes) >= max(sign * x * y for x in twice.range for y in along.range):
            continue
        # for a single u this holds however often the other parameter is bisected
        fails = any(
            min(square.corners[u::2]) * min(sizes) < max(sign * x * y for x in twice.corners[u::2] for y in along.range)
            for u in (0, 1)
        )
        if fails or search.depth == DEPTH_OF_OTHER:
            break
        search.split([*zip(square.halves(1), twice.halves(1), strict=True)])
    else:
        return True
    (a, c), _ = over_one_denominator([sign * form.value(HALF, HALF) for form in (across, along)])
    in_the_middle = zip(*[form.on_line(0, HALF) for form in whole], strict=True)
    there = Interval.point(_lowest(PatchForm.of_net([[x * a - y * c for x, y in in_the_middle]]), sides))
    square, twice = (form.part(Box(own, there)) for form in forms)
    fails = square.range[1] * max(sizes) < min(sign * x * y for x in twice.range for y in along.range)
    return False if fails else None


def _lowest(form: PatchForm, sides: Interval) -> mpq:
    """About the parameter at which a form in u alone is least."""
    for _ in range(2):
        values = (form.matrix * _at_steps(form.degree[1])).entries()
        k = values.index(min(values))
        near = Interval(mpq(max(k - 1, 0), STEPS), mpq(min(k + 1, STEPS), STEPS))
        form, lowest, sides = form.part(Box(UNIT.first, near)), sides.at(mpq(k, STEPS)), Interval(*map(sides.at, near))
    return lowest


@lru_cache(maxsize=16)
def _at_steps(n: int) -> fmpz_mat:
    """The matrix to the values of a form of degree n in one parameter at equidistant points, up to one constant."""
    return fmpz_mat([[comb(n, i) * k**i * (STEPS - k) ** (n - i) for k in range(STEPS + 1)] for i in range(n + 1)])


def true_pairs(first: Nurbs, second: Nurbs) -> TruePairs:
    """The pairs of true feet of the bisector of two plane curves (see `TruePairs`). The work is limited to an amount
    per segment, shared by the pairs of segments; the boxes that are left at the limit are undecided.

    >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
    >>> found = true_pairs(line, other)
    >>> len(found.kept) > 0, found.undecided
    (True, ())
    """
    one, other = ([piece(curve, i) for i in range(curve.segments)] for curve in (first, second))
    kept, undecided, left = list[Box](), list[Box](), BOXES * (len(one) + len(other))
    pairs = list(product(range(len(one)), range(len(other))))
    for k, (i, j) in enumerate(pairs):
        share = max(left // (len(pairs) - k), SHARE * (len(one) + len(other)))
        if left <= 0 or one[i].stands_still or other[j].stands_still:
            undecided.append(Box(one[i].interval, other[j].interval))
        else:
            left -= share - _sort(one, i, other, j, share - PAIR, kept, undecided)
    return TruePairs(tuple(kept), tuple(undecided))


def _sort(
    one: Sequence[SegmentOfCurve],
    i: int,
    other: Sequence[SegmentOfCurve],
    j: int,
    left: int,
    kept: list[Box],
    undecided: list[Box],
) -> int:
    """Sort the boxes with zeros of the function of a pair of segments, and return how many comparisons of a box with a
    segment remain of those that are left.
    """
    sides = Box(one[i].interval, other[j].interval)
    function = rounded(as_form(PlanePair(one[i].over(0), other[j].over(1)).equidistant).part(sides))
    if function.sign in (1, -1):
        return left - 1
    feet = _Foot(one, i, other[j]), _Foot(other, j, one[i])
    first, second = ([foot.factors[0], *foot.against] for foot in feet)
    turned = [PatchForm(form.matrix.transpose()) for form in second]
    against = [[rounded(form.part(sides)) for form in forms] for forms in (first, turned)]
    search = Search([_Part(sides, [[function], *against], [foot.families for foot in feet])])
    for part in search:
        left -= 1 + sum(map(len, part.families))
        (function,), *rest = part.forms
        against = [_without_needless(forms) for forms in rest]
        if function.sign in (1, -1) or not all(against):
            continue
        boxes, families = [part.box, Box(part.box.second, part.box.first)], list[Families]()
        for foot, box, given in zip(feet, boxes, part.families, strict=True):
            compared = foot.compared(box, given) if search.depth >= FIRST else given
            families += [] if compared is None else [compared]
        if len(families) == 2 and not any(families):
            kept.append(part.box)
        elif len(families) == 2:
            smaller = _Part(part.box, [[function], *against], families)
            search.split(smaller.halves(search.depth % 2) if search.depth < DEPTH and left >= 0 else None)
    undecided += [part.box for part in search.open]
    return left


class _Part(NamedTuple):
    """A box, and what is still to be decided: the forms (the function, and those `against` each foot), and of both feet
    the segments that may have a nearer point.
    """

    box: Box
    forms: list[list[PatchForm]]
    families: list[Families]

    def halves(self, direction: int) -> list[_Part]:
        """The two halves of a box; a form that has a sign keeps it, and is left as it is."""
        pairs = [[(form, form) if form.sign else form.halves(direction) for form in own] for own in self.forms]
        boxes = enumerate(self.box.halves(direction))
        return [_Part(box, [[pair[k] for pair in own] for own in pairs], self.families) for k, box in boxes]


def _without_needless(forms: list[PatchForm]) -> list[PatchForm]:
    """Of forms `against` a foot, with `across` in front, those that may decide a part of the box; none if for all pairs
    of the box a point is certainly nearer.
    """
    across, *others = forms
    with_sign = {form.sign: form for form in others}
    if {1, -1} <= with_sign.keys() or (across.sign and -across.sign in with_sign):
        return []
    one_of_each = [] if across.sign else [form for sign, form in with_sign.items() if sign]
    return [across, *one_of_each, *(form for form in others if form.sign is None)]


class PlaneBisector(Bisector):
    """The points equally far from a point of each of two plane curves, on the normals of both: for the pairs (s, t) at
    which `function` vanishes. The `pairs` are these zeros, complete with their topology; the `pieces` are the arcs.

    The bisector is not trimmed: another part of a curve may be nearer, and a foot may be a point of greatest distance.
    `trimmed` has the pairs whose feet are the nearest points. Along `pairs.lines` a curve has no tangent, or all pairs
    that contain a certain point of a curve are zeros (an arc of a circle and its centre).

    >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
    >>> found = PlaneBisector(line, other)
    >>> found.pieces
    (<arc from (-1 + √2)/2 and 0 to 1 and (-2 + 3√2)/6>,)
    """

    def __init__(self, first: Nurbs, second: Nurbs) -> None:
        for curve in (curve_of(first), curve_of(second)):
            of_dimension(curve, "give curves in the plane", 2)
        self.curves = first, second

    @cached_property
    def function(self) -> TensorSpline:
        """``F(s, t) = (a·E) [E b] − [a E] (b·E)``."""
        return PlanePair.of_curves(*self.curves).equidistant

    @cached_property
    def pairs(self) -> ZeroCurves:
        """All zeros of the function; arcs continue across the seam of a closed curve unless it is a corner."""
        closed = [curve.closed and _has_one_tangent(curve, *curve.domain[::-1]) for curve in self.curves]
        return zero_curve(self.function, compress(Along, closed))

    @cached_property
    def trimmed(self) -> TruePairs:
        """The pairs of true feet, to which no point of either curve is nearer. Points whose feet are ends or corners of
        the curves are not among the pairs.

        >>> line, other = (Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0), (2, 0)], [(0, 1), (3, 4)]))
        >>> PlaneBisector(line, other).trimmed.undecided
        ()
        """
        return true_pairs(*self.curves)

    @property
    def pieces(self) -> tuple[ZeroArc, ...]:  # type: ignore[override]  # computed when it is asked for
        """The correspondences of parameters between singular points and borders."""
        return self.pairs.arcs

    @property
    def missing(self) -> tuple[Box, ...]:  # type: ignore[override]  # computed when it is asked for
        """The rectangles in which zeros are not decided."""
        return self.pairs.undecided

    def point(self, s: Number | Real, t: Number | Real) -> tuple[mpq | Real, ...]:
        """The exact point of a pair at which the function vanishes; on a common normal the midpoint. At a corner the
        limit is taken from the side from which the function vanishes; from the right if both sides do.

        Raises `ReachError` where the normals are parallel and apart, and where a curve has no tangent.
        """
        place = exact_place(s), exact_place(t)
        pairs = [PlaneBisector(*pair) for pair in product(*map(_sides, self.curves, place))]
        first, second = next((pair for pair in pairs[:-1] if pair._vanishes(*place)), pairs[-1]).curves
        p, q = evaluate(first, s), evaluate(second, t)
        a, b = ([evaluate(f, x) for f in tangent(curve)] for curve, x in ((first, s), (second, t)))
        chord = [y - x for x, y in zip(p, q, strict=True)]
        across = a[0] * b[1] - a[1] * b[0]
        if across == 0:
            if not all(any(x != 0 for x in own) for own in (a, b)):
                raise ReachError("a point where a curve has no tangent", remedy="give a pair next to it")
            if a[0] * chord[0] + a[1] * chord[1] != 0:
                raise ReachError("a point on two normals that are parallel", remedy="give a pair next to it")
            return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
        along = (b[0] * chord[0] + b[1] * chord[1]) / across
        return p[0] - along * a[1], p[1] + along * a[0]

    @property
    def items(self) -> Iterator[NamedNumbers]:
        """The correspondences of parameters and the single pairs: their end points, except points at infinity, then the
        parameters; lines and rectangles of pairs by their sides.
        """
        for arc in self.pairs.arcs:
            places = [] if arc.start is None or arc.end is None else [("start", arc.start), ("end", arc.end)]
            yield NamedNumbers(f"{'' if places else 'closed '}correspondence of parameters", self._by_name(places))
        for point in self.pairs.points:
            yield NamedNumbers("pair", self._by_name([("parameter", (point.first, point.second))]))
        boxes = [("line of pairs", line.box) for line in self.pairs.lines]
        boxes += [("rectangle of pairs", (part.sides[0], part.sides[1])) for part in self.pairs.everywhere]
        for what, box in boxes:
            ends = zip(("start", "end", "other start", "other end"), chain(*box), strict=True)
            yield NamedNumbers(what, {name: real(x) for name, x in ends})

    def _by_name(self, places: Sequence[tuple[str, tuple[Real, Real]]]) -> dict[str, Real]:
        """The points of pairs of parameters, then the pairs, as named numbers."""
        values, parameters = dict[str, Real](), dict[str, Real]()
        for name, (s, t) in places:
            with suppress(ReachError):
                values |= zip((f"{name} x", f"{name} y"), map(real, self.point(s, t)), strict=True)
            parameters |= {name: s, f"other {name}": t}
        return values | parameters

    def _vanishes(self, s: mpq | Real, t: mpq | Real) -> bool:
        """Whether the function vanishes at a pair with one rational parameter."""
        if not isinstance(t, Real):
            return sign_at(self.function.at_t(t), s) == 0
        assert not isinstance(s, Real)
        return sign_at(self.function.at_s(s), t) == 0


def _has_one_tangent(curve: Nurbs, before: mpq, behind: mpq) -> bool:
    """Whether the tangents left and right of a point are parallel (also where the curve turns back), or one of them
    does not exist. The two parameters are those of the point.
    """
    last, first = ([f(t, side) for f in tangent(curve)] for t, side in ((before, Side.LEFT), (behind, Side.RIGHT)))
    return any(first) == any(last) and first[0] * last[1] == first[1] * last[0]


def _sides(curve: Nurbs, t: mpq | Real) -> list[Nurbs]:
    """At a corner, the two parts of a curve before and behind the parameter, without parts that have no tangent there;
    elsewhere the whole curve.
    """
    low, high = curve.domain
    if isinstance(t, Real) or t not in curve.breakpoints[1:-1] or _has_one_tangent(curve, t, t):
        return [curve]
    return [part for part in (curve.restrict(t, high), curve.restrict(low, t)) if any(f(t) for f in tangent(part))]
