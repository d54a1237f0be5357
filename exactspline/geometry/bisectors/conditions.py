"""Where a point that moves along a bisector is nearer to no other point of the curve: one condition per segment.

For B(s) = (x, y)/e that of a segment a/w of the curve (moved so that Q is the origin) is that the quotient ``(e ‖a(u)‖²
− 2 w (x, y)·a(u))/e`` is negative for no u. Bernstein coefficients on boxes decide most cases; the rest are decided
exactly: where members of such a family are non-negative can only change at a parameter at which one of them has a
double zero or a zero at an end, or at which B is infinite.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

from flint import fmpz_mpoly, fmpz_poly

from exactspline.language.arguments import Curve
from exactspline.language.vector import Vector, norm2
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import UNIT, Box, Interval, joined
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import ONE, halves, over_common_denominator, restrict, value
from exactspline.polynomials.elimination import discriminant, resultant
from exactspline.polynomials.factors import factorize_square_free
from exactspline.polynomials.isolation import is_nonnegative
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import in_one, rows_of
from exactspline.reals.real import between
from exactspline.roots.of_polynomials import Parameter, check_isolation, distinct
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor_lowest_terms import CONTEXT, as_mpoly, as_packed

#: How many segments at most are tested first to see whether an arc is on the true bisector at all.
ASKED_FIRST = 24


@dataclass(frozen=True)
class _Family:
    """The condition of one segment of the curve on B(s): a form in u for every s, packed, and its rows by powers of u.

    On the segment with the foot of B every member is a square times `rest`.
    """

    whole: fmpz_poly
    stride: int
    rows: list[fmpz_poly]
    below: fmpz_poly
    rest: tuple[list[fmpz_poly], int] | None

    def certain(self, e: fmpz_poly, n: int, parts: list[Interval]) -> bool:
        """Whether it certainly holds on all of the given parts."""
        if _of_one_sign(self.below, self.whole) or all(holds_certainly(self.rows, e, n, part) for part in parts):
            return True
        if self.rest is None:
            return False
        rows, degree = self.rest
        return all(holds_certainly(rows, e, n, part, degree) for part in parts)

    def of_certain_sign(self, n: int, parts: list[Interval]) -> bool:
        """Whether it certainly has one sign on each of the given parts, whatever the sign of e: the condition then
        changes only at zeros of e.
        """
        rows, m = (self.rows, n) if self.rest is None else self.rest
        return all(keeps_sign(rows, m, part, 1) or keeps_sign(rows, m, part, -1) for part in parts)


def _without_foot(whole: fmpz_poly, stride: int, n: int, degree: int) -> tuple[list[fmpz_poly], int] | None:
    """The rows of a family of these degrees in s and u over ``(u − s)²``, and their degree in s; None where that does
    not divide it.
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

        #: Arcs that are not on the true bisector mostly fail where the curve comes near Q, or on both sides of Q.
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
        """Where B = (x, y)/e of degree n, given on one segment by integer forms, meets the condition: closed intervals,
        split where B is infinite. `own` is the segment of the curve with the foot of B, at the same parameter.

        Parts of the segment on which one condition certainly fails are set aside first, and conditions that certainly
        hold on the rest. Where two such parts meet a condition fails, so that the point is not part of the result.
        """
        e, build = forms[2], self._builder(forms, n, own)
        asked = {self._most_against(forms, n, mpq(k, 8)) for k in (1, 3, 5, 7)}
        first: dict[int, _Family] = {}
        while True:
            first |= {j: build(j) for j in asked}
            open_parts = possible_parts([family.rows for family in first.values()], e, n)
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
        open_parts = possible_parts([family.rows for family in (first | unclear).values()], e, n)
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
            holds = partial(self._holds, family.rows, e, n, segment)
            intervals = _intersection(intervals, _cells_between(candidates, _roots(e, segment), segment, holds))
        return intervals

    def _builder(self, forms: list[fmpz_poly], n: int, own: int | None) -> Callable[[int], _Family]:
        """The maker of the family of a segment; `own` is the one with the foot of B."""
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
    """Whether the coefficients alone show that the family is non-negative over e everywhere, and e without an inner
    zero.
    """
    return any(all(x * sign >= 0 for f in (e, family) for x in f.coeffs()) for sign in (1, -1))


def _candidates(family: fmpz_mpoly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner parameters at which the number of sign changes of a member can differ from that of its neighbours.

    `ReachError` where they would take too long.
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
    """Where a square-free factor has a double zero, or one at an end: discriminant, first and last coefficient."""
    rows = rows_of(p)
    ends = [next(row for row in rows if row), rows[-1]]
    conditions = [*ends, discriminant(rows)] if len(rows) > 2 else ends
    return [root for q in conditions for root in _roots(q, segment)]


def _roots(c: fmpz_poly, segment: tuple[mpq, mpq]) -> list[Root]:
    """The inner roots of a polynomial in the local z of a segment: of its square-free factors one by one, for
    discriminants have many of them.
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


def _cells_between(
    candidates: list[Parameter], poles: list[Root], segment: tuple[mpq, mpq], holds: Callable[[mpq], bool]
) -> list[tuple[Parameter, Parameter]]:
    """The closed intervals between candidates on which the condition holds; neighbours are one, unless B is infinite
    between them.
    """
    a, b = segment
    intervals: list[tuple[Parameter, Parameter]] = []
    ends: list[Parameter] = [a, *distinct([*candidates, *poles]), b]
    for low, high in pairwise(ends):
        if holds(between(low, high)):
            if intervals and intervals[-1][1] == low and not any(low == pole for pole in poles):
                intervals[-1] = (intervals[-1][0], high)
            else:
                intervals.append((low, high))
    return intervals


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

#: An interval of the local parameter. How often the parameter is halved, and how often both are.
DEPTH, DEPTH_OF_BOTH = 10, 10


def possible_parts(families: Sequence[Sequence[fmpz_poly]], e: fmpz_poly, n: int) -> list[Interval]:
    """The parts of [0, 1] on which no family is certainly of the other sign than e at the beginning or in the middle
    of its range, neighbours joined; parts with a zero of e only where all families could have one sign.

    >>> possible_parts([[fmpz_poly([-1, 3])]], fmpz_poly([1, 1]), 1)
    [Interval(255/1024, 1)]
    """
    samples = [form for rows in families for form in (rows[0], _total(rows))]
    todo = [(Interval(mpq(0), mpq(1)), 0, e, samples)]
    possible: list[Interval] = []
    while todo:
        interval, depth, below, forms = todo.pop()
        sign = _sign(below, n)
        signs = {_sign(form, n) for form in forms}
        # where e has a zero, forms of both signs exclude both of its sides
        if -sign in signs if sign else {1, -1} <= signs:
            continue
        if depth == DEPTH or (sign and not any(_has_sign(form, -sign) for form in forms)):
            possible.append(interval)
            continue
        parts = [halves(form, n) for form in forms if not sign or _has_sign(form, -sign)]
        left, right = halves(below, n)
        first, second = interval.halves
        todo.append((second, depth + 1, right, [part for _, part in parts]))
        todo.append((first, depth + 1, left, [part for part, _ in parts]))
    return joined(possible)


def _total(rows: Sequence[fmpz_poly]) -> fmpz_poly:
    """The family in the middle of its range, up to a positive constant."""
    return sum(rows, start=fmpz_poly([]))


def _sign(form: fmpz_poly, n: int) -> int:
    """The strict sign of all coefficients of a form of degree n, 0 where they have none."""
    first = form[0]
    if first == 0 or form.degree() < n:
        return 0
    sign = 1 if first > 0 else -1
    return sign if all(x * sign > 0 for x in form.coeffs()) else 0


def _has_sign(form: fmpz_poly, sign: int) -> bool:
    return any(x * sign > 0 for x in form.coeffs())


def holds_certainly(
    rows: Sequence[fmpz_poly], e: fmpz_poly, n: int, interval: Interval, degree: int | None = None
) -> bool:
    """Whether a family has the sign of e, or is zero, all over a part: by coefficients on smaller and smaller boxes.

    Its rows have the degree n of e, or another degree.
    """
    sign = _sign(restrict((e, ONE), n, *interval)[0], n)
    return bool(sign) and keeps_sign(rows, n if degree is None else degree, interval, sign)


def keeps_sign(rows: Sequence[fmpz_poly], m: int, interval: Interval, sign: int) -> bool:
    """Whether a family of degree m in z has a sign, or is zero, all over a part; certainly, as above.

    >>> keeps_sign([fmpz_poly([1, -1]), fmpz_poly([2, 1])], 1, Interval(mpq(0), mpq(1, 4)), 1)
    True
    """
    todo = [(0, PatchForm.of_rows(rows, m).part(Box(interval, UNIT.second)))]
    while todo:
        depth, form = todo.pop()
        low, high = form.range
        if (low if sign > 0 else -high) >= 0:
            continue
        if depth == DEPTH_OF_BOTH or any(x * sign < 0 for x in form.corners):
            return False
        todo += [(depth + 1, half) for half in form.halves(1 - depth % 2)]
    return True
