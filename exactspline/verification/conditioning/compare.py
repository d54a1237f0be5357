"""The forms of a zero-set construction compared, zero by zero."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from exactspline.errors import FormulaError, ShapeError, counted
from exactspline.geometry.derived.constructions import Variant, construction
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Interval
from exactspline.polynomials.bernstein import Form, value
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.conditioning.condition_number import DIGITS, condition_number, local, quotient
from exactspline.verification.conditioning.double_precision import Double, double_precision_root


@dataclass(frozen=True)
class FormAtRoot:
    """One form at one zero: its degree, the multiplicity, an enclosure of the condition number (a point when it is
    exact).

    `growth` encloses K of the theorem for the factor by which the form exceeds the minimal one: ``C ≤ K^(1/m)
    C_minimal``; None where the factor vanishes too or is not a polynomial. `one_sign` says that its Bernstein
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
    """All zeros of a construction inside the segments of a curve, the extraneous zeros of a form, and what was not
    compared, in words.
    """

    curve: str
    construction: str
    roots: tuple[RootConditions, ...]
    extraneous: dict[str, tuple[Root, ...]]
    skipped: tuple[str, ...]

    @property
    def verdicts(self) -> dict[str, str]:
        """For each form, at how many zeros the reduced (minimal) form is worse or better conditioned than it."""
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
    if curve.dimension != 2:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this needs a curve in the plane")
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
