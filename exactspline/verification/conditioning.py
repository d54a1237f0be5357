"""The paper's open question O1: is the computation of zeros better or worse conditioned when the denominator is
discarded?

The *condition number* of a zero x of multiplicity m of ``p = Σ b_i B_i`` on its segment (local parameter, degree n) is,
after Farouki and Rajan, ``C = (m! Σ |b_i| B_i(x) / |p⁽ᵐ⁾(x)|)^(1/m)``. The results about the forms, with proofs, are in
docs/conditioning.md.

Source: Farouki and Rajan, On the numerical condition of polynomials in Bernstein form, CAGD 4, 1987.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import factorial
from sys import float_info

from flint import fmpz, fmpz_poly

from exactspline.errors import FormulaError, counted
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.numbers.exact import from_float, iroot, mpq, mpz, text
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import ONE, Form, bezier, derivative, value
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import of_dimension

# ---- condition numbers


#: Relative width of an enclosure of a condition number.
WIDTH = mpq(1, 10**10)
#: Bits to which the ends of an enclosure are rounded, and the initial digits of the zero.
BITS, START = 64, 30
#: Digits of a zero with which a double is compared.
DIGITS = 60


def local(root: Root, digits: int = DIGITS) -> Interval:
    """An interval around a zero inside a segment, in the local parameter of the segment, of width at most
    ``10^−digits``.
    """
    assert root.segment is not None
    interval = root.refine(digits + max(0, len(str(int(1 / root.segment.width)))))
    return Interval(*map(root.segment.local, interval))


def condition_number(form: Form, n: int, root: Root, m: int) -> Interval:
    """The condition number of a zero of multiplicity m of a form of degree n, in the local parameter of its segment.

    Both ends are the number itself if the zero is rational and m = 1; otherwise they enclose the number, with a
    relative width below `WIDTH`. For m = 0 it is ``Σ |b_i| B_i(x) / |p(x)|``, the condition number of evaluating p at
    x.

    >>> from exactspline import BSpline
    >>> from exactspline.roots.zero_set import zeros
    >>> f = BSpline.bezier([-1, 3])
    >>> condition_number(f.forms[0], 1, zeros(f)[0], 1)  # (3/4 + 3/4) / 4
    Interval(3/8, 3/8)
    """
    digits = START
    while True:
        x = local(root, digits)
        top = _range((fmpz_poly([abs(c) for c in form[0].coeffs()]), form[1]), n, x)
        bottom = _range(_derivative(form, n, m), n - m, x)
        if bottom[0] > 0 or bottom[1] < 0:
            small, large = sorted(map(abs, bottom))
            low, high = factorial(m) * top[0] / large, factorial(m) * top[1] / small
            if low == high and m <= 1:
                return Interval(low, high)
            low, high = _root_below(low, max(m, 1)), 1 / _root_below(1 / high, max(m, 1))
            if high - low <= WIDTH * low:
                return Interval(low, high)
        digits *= 2


def _derivative(form: Form, n: int, m: int) -> Form:
    c = form[0]
    for k in range(m):
        c = derivative(c, fmpz(n - k))
    return c, form[1]


def _range(form: Form, n: int, x: Interval) -> Interval:
    """Bounds of a form over an interval, from bounds of its positive and of its negative terms: each term increases
    with v/u and decreases with 1/u.
    """
    low, high = x
    shrink = ((1 - high) / (1 - low)) ** n
    parts = [(fmpz_poly([max(sign * c, fmpz(0)) for c in form[0].coeffs()]), form[1]) for sign in (1, -1)]
    (up, top), (down, bottom) = ((value(part, n, low) * shrink, value(part, n, high) / shrink) for part in parts)
    return Interval(up - bottom, top - down)


def _root_below(q: mpq, m: int) -> mpq:
    """A short number just below the m-th root of a positive one."""
    shift = m * (BITS + max(0, int(1 / q).bit_length() // m + 1))
    return mpq(iroot(mpz(q * mpz(2) ** shift), m)[0], mpz(2) ** (shift // m))


def quotient(form: Form, n: int, by: Form, m: int) -> Form | None:
    """The quotient of the first form by the second one, of degree n − m, up to a constant; None if there is none.

    >>> quotient((fmpz_poly([-1, 0, 1]), ONE), 2, (fmpz_poly([-1, 1]), ONE), 1)
    (x + 1, 1)
    """
    (c, _), (b, _) = form, by
    if not c or not b or n < m:
        return None
    q, rest = divmod(c // c.content(), b // b.content())
    return None if rest or q.degree() > n - m else (q, ONE)


# ---- in double precision
#
# This is the only module of this package with floats.
#
# Floats result from exact numbers by a single rounding, and are converted back by
# `exactspline.numbers.exact.from_float`.


#: The rounding unit of double precision.
UNIT = mpq(1, 2**53)
#: The number of bisections, from brackets that shrink towards the zero; the worst result is reported.
STARTS = 3


@dataclass(frozen=True)
class Double:
    """The result of double precision for a zero: the largest error in the local parameter over all bisections that
    could be started. If none could be started, `error` is None, and the reason is given.
    """

    error: mpq | None
    reason: str = ""

    @property
    def units(self) -> mpq | None:
        """The error in units of 2⁻⁵³."""
        return None if self.error is None else self.error / UNIT


def double_precision_root(form: Form, n: int, x: mpq, bracket: Interval) -> Double:
    """The error of a zero when the Bézier points are rounded to doubles and the zero is found by bisection with de
    Casteljau's algorithm.

    `x` is the zero (or within ``10^−60`` of it), `bracket` an interval with no other zero; all in the local parameter.
    The bisection starts in the bracket and in two smaller ones. The points are scaled by one power of two, which only
    keeps them in range.

    >>> from exactspline.polynomials.bernstein import from_bezier
    >>> double_precision_root(from_bezier([mpq(-1), mpq(2)]), 1, mpq(1, 3), (mpq(0), mpq(1))).units
    mpq(1,6)
    """
    points, (low, high) = to_doubles(bezier(form, n)), bracket
    if points is None:
        return Double(None, "the coefficients span more than the range of doubles")
    parts = [mpq(j, 2 * STARTS) for j in range(STARTS)]
    starts = [(_double(low + (x - low) * part), _double(high + (x - high) * part)) for part in parts]
    errors = [abs(from_float(y) - x) for a, b in starts if (y := bisected(points, a, b)) is not None]
    return Double(max(errors)) if errors else Double(None, "no change of sign in doubles")


def to_doubles(points: list[mpq]) -> list[float] | None:
    """The points to the nearest double, the largest near 2¹⁰⁰⁰; None if a point other than zero would be less than the
    smallest normal double.
    """
    largest = max(abs(b) for b in points)
    scale = mpq(2) ** (1000 - int(largest.numerator).bit_length() + int(largest.denominator).bit_length())
    doubles = [_double(b * scale) for b in points]
    return None if any(b and abs(y) < float_info.min for b, y in zip(points, doubles, strict=True)) else doubles


def _double(q: mpq) -> float:
    """The double nearest to an exact number."""
    return int(q.numerator) / int(q.denominator)


def _de_casteljau(points: list[float], t: float) -> float:
    """The value in doubles by de Casteljau's algorithm."""
    u = 1.0 - t
    while len(points) > 1:
        points = [u * a + t * b for a, b in pairwise(points)]
    return points[0]


def bisected(points: list[float], low: float, high: float) -> float | None:
    """The result of a bisection, which ends at neighbouring doubles or at a zero; None without a change of sign."""
    first, last = _de_casteljau(points, low), _de_casteljau(points, high)
    if first == 0 or last == 0 or (first > 0) == (last > 0):
        return None
    while low < (middle := (low + high) / 2) < high:
        value = _de_casteljau(points, middle)
        if value == 0:
            return middle
        low, high = (middle, high) if (value > 0) == (first > 0) else (low, middle)
    return low


# ---- the forms of a construction compared


@dataclass(frozen=True)
class FormAtRoot:
    """One form at one zero: its degree, the multiplicity, an enclosure of the condition number (a point when it is
    exact).

    `growth` encloses K of the theorem for the factor by which the form exceeds the minimal one: ``C ≤ K^(1/m)
    C_minimal``; None if the factor vanishes too or is not a polynomial. `one_sign` says that its Bernstein
    coefficients have one sign, which proves ``C ≤ C_minimal``.
    """

    form: str
    degree: int
    multiplicity: int
    condition: Interval
    growth: Interval | None
    one_sign: bool
    double: Double | None


@dataclass(frozen=True)
class RootConditions:
    """A zero of the minimal form inside a segment, and the data of every form there."""

    root: Root
    forms: tuple[FormAtRoot, ...]

    def __getitem__(self, form: str) -> FormAtRoot:
        return next(f for f in self.forms if f.form == form)

    def compare(self, form: str) -> int:
        """1 when the minimal form is worse conditioned than the form, −1 when it is better, 0 when the enclosures do
        not separate them.
        """
        (a, b), (c, d) = self[Variant.MINIMAL].condition, self[form].condition
        return int(a > d) - int(b < c)

    def ratio(self, form: str) -> mpq:
        """Condition number of the minimal form divided by that of the form, from the middles of the enclosures."""
        (low, high), (first, last) = self[Variant.MINIMAL].condition, self[form].condition
        return (low + high) / (first + last)


@dataclass(frozen=True)
class Conditioning:
    """All zeros of a construction inside the segments of a curve, the extraneous zeros of a form, and the omitted
    zeros, in words.
    """

    curve: str
    construction: str
    roots: tuple[RootConditions, ...]
    extraneous: dict[str, tuple[Root, ...]]
    skipped: tuple[str, ...]

    @property
    def verdicts(self) -> dict[str, str]:
        """For each form, the numbers of zeros at which the reduced (minimal) form is worse or better conditioned."""
        forms = [f.form for row in self.roots[:1] for f in row.forms if f.form != Variant.MINIMAL]
        return {form: self._verdict(form) for form in forms}

    def _verdict(self, form: str) -> str:
        signs = [row.compare(form) for row in self.roots]
        proved = sum(row[form].one_sign and row[form].growth is not None for row in self.roots)
        of = f"of {counted(len(signs), 'zero')}"
        tail = f"; by the theorem it cannot be better at {proved}" if proved else ""
        return f"the reduced form is worse conditioned at {signs.count(1)} {of}, better at {signs.count(-1)}{tail}"


def conditioning(curve: Nurbs, name: str = "critical_curvature", *, doubles: bool = True) -> Conditioning:
    """The condition of every zero of a zero-set construction in every form. The zeros of the minimal form strictly
    inside a segment are compared; a zero at a knot, a jump or an interval of zeros is listed in `skipped`. With
    `doubles` the error of double precision is measured too.

    >>> from exactspline.interchange.examples import example
    >>> result = conditioning(example("rational_cubic_s"), "zero_curvature", doubles=False)
    >>> [(str(f.form), f.degree, f.one_sign) for f in result.roots[0].forms], result.roots[0].compare("naive")
    ([('naive', 18, True), ('paper', 6, True), ('minimal', 3, True)], 1)

    Raises `FormulaError` for a construction that is not a zero set, `ShapeError` for a curve that is not in the plane.
    """
    made = construction(name)
    if not made.zero_set:
        raise FormulaError(f"{name} is not a zero set", remedy="choose zero_curvature or critical_curvature")
    of_dimension(curve, "this needs a curve in the plane", 2)
    splines = {form: made.form_on(curve, form) for form in (*made.unlifted, Variant.MINIMAL)}
    zeros_by_form = {form: zeros(f) for form, f in splines.items()}
    minimal = zeros_by_form[Variant.MINIMAL]
    inside = [root for root in minimal if not root.at_knot]
    rows = []
    tried = {form: _in_doubles(f, inside, zeros_by_form[form]) if doubles else {} for form, f in splines.items()}
    for root in inside:
        # a rational zero becomes exact, and so does its condition number
        root.minimal_polynomial()
        same = {form: next(r for r in among if r == root) for form, among in zeros_by_form.items()}
        forms = [
            _at_root(form, f, splines[Variant.MINIMAL], root, same[form].multiplicity, tried[form].get(root))
            for form, f in splines.items()
        ]
        rows.append(RootConditions(root, tuple(forms)))
    extraneous = {
        form: tuple(r for r in among if not r.at_knot and r not in inside) for form, among in zeros_by_form.items()
    }
    skipped = [f"the zero at the knot {text(r.low)} (condition number 0 in every form)" for r in minimal if r.at_knot]
    skipped += [f"the jump at the knot {text(j.parameter)}" for j in minimal.jumps]
    skipped += [
        f"[{text(a)}, {text(b)}], where the form vanishes identically" for s in minimal.intervals for a, b in s.parts
    ]
    return Conditioning(
        curve.name, made.name, tuple(rows), {form: rs for form, rs in extraneous.items() if rs}, tuple(skipped)
    )


def _at_root(
    form: str, f: BSpline, minimal: BSpline, root: Root, multiplicity: int, double: Double | None
) -> FormAtRoot:
    """One form at a zero; `double` is the result of double precision, where it was tried."""
    i = segment_with(f, root)
    own, n = f.forms[i], f.degree
    factor = quotient(own, n, minimal.forms[i], minimal.degree)
    growth, one_sign = None, False
    if factor is not None:
        one_sign = len({c > 0 for c in factor[0].coeffs() if c != 0}) == 1
        if multiplicity == root.multiplicity:
            growth = Interval.point(mpq(1)) if one_sign else condition_number(factor, n - minimal.degree, root, 0)
    return FormAtRoot(form, n, multiplicity, condition_number(own, n, root, multiplicity), growth, one_sign, double)


def _in_doubles(f: BSpline, roots: Sequence[Root], among: ZeroSet) -> dict[Root, Double]:
    """The results of double precision for zeros of a form; `among` are all its zeros."""
    doubles: dict[Root, Double] = {}
    for root in roots:
        form = f.forms[segment_with(f, root)]
        doubles[root] = double_precision_root(form, f.degree, local(root)[0], bracket(form, f.degree, root, among))
    return doubles


def segment_with(f: BSpline, root: Root) -> int:
    """The number of the segment on which a zero is."""
    assert root.segment is not None
    return f.breakpoints.index(root.segment[0])


def bracket(form: Form, n: int, root: Root, among: ZeroSet) -> Interval:
    """An interval of the local parameter that contains this zero of the form and no other, reaching halfway to the
    adjacent zeros or to the ends of the segment.
    """
    assert root.segment is not None
    x, _ = local(root)
    others = [root.segment.local(r.refine(DIGITS).low) for r in among if r != root]
    ends = [mpq(end) if value(form, n, mpq(end)) else (x + end) / 2 for end in (0, 1)]
    low = max([ends[0], *[(x + y) / 2 for y in others if 0 <= y < x]])
    return Interval(low, min([ends[1], *[(x + y) / 2 for y in others if x < y <= 1]]))
