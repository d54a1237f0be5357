"""Claims about a single example curve: the numbers in captions, and the comparison of two forms by their condition."""

from __future__ import annotations

import re
from dataclasses import field
from itertools import pairwise
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.rational import Rational
from exactspline.language.ruled import joined, split
from exactspline.numbers.exact import mpq, point_text, text
from exactspline.numbers.intervals import Interval
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet, jump_root, zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import control_point_count, in_lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.verification import phrases as say
from exactspline.verification.claim import (
    Claim,
    TwoSided,
    claim_kind,
    example_name,
    formula_name,
    numbers,
    one_of,
    read,
)
from exactspline.verification.evaluation import Evaluation, place_between
from exactspline.verification.evidence import Conditions, Enclosure, Evidence, Fact
from exactspline.verification.verdict import REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Counter, Extent, Name, word


@claim_kind
class ExampleClaim(Claim):
    """A claim about a single example curve."""

    reading: ClassVar[Name] = Name("spline")
    of_one_curve: ClassVar[bool] = True

    on: Extent = field(default=Extent.CURVE, metadata=read(one_of(Extent)))
    example: str = field(metadata=read(example_name))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The finding on the example curve, which is the same for every case."""
        return self.prove()[1]


#: The singular of the name of a counted quantity.
SINGULAR = {"root": "roots", "cusp": "cusps", "extremum": "extrema", "control point": "control points"}


def _counts(claimed: str) -> list[tuple[int, Counter]]:
    """The numbers of a caption with their units.

    >>> [(n, str(what)) for n, what in _counts("degree 96, 388 control points")]
    [(96, 'degree'), (388, 'control points')]

    Raises `ClaimError` when it cannot be read.
    """
    numbers = []
    for part in (part.strip() for part in claimed.replace("−", "-").split(",")):
        number = re.search(r"-?\d+", part)
        if number is None:
            raise ClaimError(f"the count {part!r} has no number", where="claimed", remedy='write "degree 6"')
        what = part.replace(number[0], "", 1).strip()
        numbers.append((int(number[0]), word(Counter, SINGULAR.get(what, what), "count")))
    return numbers


def _counted_things(claim: Claim, name: str, value: str) -> str:
    """Numbers with their units."""
    _counts(value)
    return str(value)


def checked_interval(claim: Claim, name: str, value: tuple[int | str, ...]) -> tuple[mpq, ...]:
    """Two numbers, the smaller one first."""
    ends = numbers(claim, name, value)
    if len(ends) != 2 or not ends[0] < ends[1]:
        raise ClaimError(f"{point_text(ends)} is no interval", where=name, remedy='write interval = ["0", "1/2"]')
    return ends


@claim_kind
class Count(ExampleClaim):
    """The numbers in ``claimed`` are those of ``formula`` on the curve ``example``; roots also in a closed ``interval``
    of its parameters: the zeros of the value, continued where numerator and denominator vanish together. The seam of a
    closed curve is one parameter. Undecided where the value jumps from or to 0.
    """

    kind: ClassVar[str] = "count"
    value: ClassVar[str] = "$claimed"
    notation: ClassVar[str] = r"$formula: \;\text{$claimed}"

    formula: Name = field(metadata=read(formula_name))
    claimed: str = field(metadata=read(_counted_things))
    interval: tuple[mpq, ...] = field(default=(), metadata=read(checked_interval))

    def validate(self) -> None:
        """Reject an interval for a number that is not counted in an interval."""
        if self.interval and {what for _, what in _counts(self.claimed)} != {Counter.ROOTS}:
            raise ClaimError("only roots are counted in an interval", where="interval", remedy='claimed = "2 roots"')

    def part_tried(self, own: Evaluation) -> Evidence | None:
        """The part that is tried: everything for a degree as written, which is the same for all points and
        constants.
        """
        degree_alone = {what for _, what in _counts(self.claimed)} == {Counter.DEGREE}
        return None if degree_alone else super().part_tried(own)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """Only the claimed numbers are computed."""
        value = joined(self.find(self.formula)(argument))
        numerators, below = split(value)
        if below is not None and below.vanishes_somewhere:
            return vacuous(say.undefined(self.formula))
        if all(p.is_zero for p in numerators):
            return vacuous(Fact.ZERO)
        claimed = _counts(self.claimed)
        if not numerators[0].breakpoints[1:-1] and {what for _, what in claimed} & CONTINUITIES:
            return vacuous(Fact.NO_JOINT)
        numbers = [(self._counted(what, value, own), what) for _, what in claimed]
        counts_here = say.counts(tuple(numbers))
        if numbers == claimed:
            return Finding(VERIFIED, counts_here)
        return Finding(REFUTED, counts_here, witness=counts_here)

    def _counted(self, what: Counter, value: Any, own: Evaluation) -> int | None:
        """One of the numbers; None if it is infinite."""
        if what == Counter.CUSPS:
            return _cusps(self.find(self.formula), own)
        if what == Counter.ENDS:
            return extrema_at_ends(own.curve)
        numerators = split(value)[0]
        if what == Counter.DEGREE:
            return int(value.degree)
        if what == Counter.CONTROL_POINTS:
            return int(control_point_count(value))
        if what == Counter.NOMINAL_CONTINUITY:
            return int(min(min(p.continuity) for p in numerators))
        if what == Counter.TRUE_CONTINUITY:
            return int(min(p.continuity_at(t) for p in numerators for t in p.breakpoints[1:-1]))
        lowest = split(in_lowest_terms(value) if isinstance(value, Rational) else value)
        form = self.only_component(self.formula, lowest[0])
        zero_set = zeros(form, periodic=own.curve.closed)
        if what == Counter.ROOTS:
            return self._roots(zero_set)
        if (extrema := count_of_extrema(zero_set, own)) is None:
            problem = f"{self.formula!r} does not change its sign exactly where the curvature has its extrema"
            raise ClaimError(problem, where=self.key, remedy="count extrema by a formula with the sign of κ′")
        return extrema

    def _roots(self, whole: ZeroSet) -> int | None:
        """The number of roots in the interval; None if there are infinitely many."""
        form, (start, end) = whole.spline, whole.spline.domain
        low, high = self.interval or form.domain
        part = whole if (low, high) == form.domain else zeros(form.restrict(low, high))
        if part.intervals:
            return None
        for jump in whole.jumps:
            t = jump.parameter
            within = low <= t <= high or (t == start and high == end)  # the seam is reported at the start
            if within and 0 in (jump.left.value, jump.right.value):
                problem = f"{self.formula!r} jumps at the parameter {text(t)}, and on one side alone its limit is 0"
                raise ClaimError(problem, where=self.key, remedy="count in an interval without this parameter")
        return len(part)


#: The quantities counted at knots.
CONTINUITIES = {Counter.NOMINAL_CONTINUITY, Counter.TRUE_CONTINUITY}


def count_of_extrema(zero_set: ZeroSet, own: Evaluation) -> int | None:
    """The number of extrema of the curvature, if a formula with these zeros changes its sign exactly at the extrema;
    otherwise None, since the formula does not determine the extrema.
    """
    from exactspline.geometry.analysis.curves import analyse

    extrema = analyse(own.curve).curvature_extrema
    changes = [root for root in zero_set if root.sign_change]
    changes += [jump_root(jump) for jump in zero_set.jumps if jump.sign_change]
    same = len(extrema) == len(changes) and all(any(each.root == root for root in changes) for each in extrema)
    return len(extrema) if same and not zero_set.intervals else None


def extrema_at_ends(curve: Nurbs) -> int:
    """The most extrema of the curvature that lie at the ends of one segment, where κ′ changes its sign by a jump.

    >>> from exactspline.interchange.examples import example
    >>> extrema_at_ends(example("six_segment_cubic"))
    2
    """
    from exactspline.geometry.analysis.curves import analyse

    jumps = [each.root for each in analyse(curve).curvature_extrema if each.by_jump]
    return max(sum(root in ends for root in jumps) for ends in pairwise(curve.breakpoints))


def _cusps(formula: Formula, own: Evaluation) -> int:
    """The number of places where a derived curve turns back, between its poles."""
    from exactspline.geometry.curves.poles import between_poles
    from exactspline.geometry.derived.derive import derive

    derived = derive(formula, own.curve)
    if derived.missing:
        raise ClaimError(f"{formula.name!r} does not exist on all of this curve", remedy="name another curve")
    return len(between_poles(derived).reversals)


@claim_kind
class Condition(ExampleClaim, TwoSided):
    """At every zero that ``left`` and ``right`` have in common on the curve ``example``, ``left`` has the smaller
    condition number: a relative change of its Bernstein coefficients moves the zero less.
    """

    kind: ClassVar[str] = "condition"
    value: ClassVar[str] = "better at every common zero"
    notation: ClassVar[str] = r"$left \;\text{is better conditioned than}\; $right"

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding; undecided if the enclosures of two condition numbers overlap."""
        f, g = (self.only_component(n, split(self.find(n)(argument))[0]) for n in (self.left, self.right))
        ours, theirs = (zeros(form, periodic=own.curve.closed) for form in (f, g))
        pairs = [
            (root, _condition(f, root), _condition(g, other)) for root in ours for other in theirs if root == other
        ]
        whole = _share_segments(ours, theirs)
        if not pairs:
            return Finding(UNDECIDED, witness=Fact.NOT_ISOLATED) if whole else vacuous(Fact.NO_COMMON_ZERO)
        conditions = Conditions(tuple((a, b) for _, a, b in pairs))
        if all(a[1] < b[0] for _, a, b in pairs):
            return Finding(UNDECIDED, conditions, witness=Fact.NOT_ISOLATED) if whole else Finding(VERIFIED, conditions)
        for root, a, b in pairs:
            if a[0] >= b[1]:
                place = place_between(Interval(root.low, root.high))
                return Finding(REFUTED, conditions, witness=say.not_better(place))
        return Finding(UNDECIDED, conditions, witness=Fact.NOT_SEPARATED)


def _share_segments(one: ZeroSet, other: ZeroSet) -> bool:
    """Whether two splines have a common zero that is on a segment on which one of them vanishes."""
    ours, theirs = ([part for piece in each.intervals for part in piece.parts] for each in (one, other))
    return any(max(a, c) <= min(b, d) for a, b in ours for c, d in theirs) or any(
        a <= root <= b for roots, parts in ((one, theirs), (other, ours)) for root in roots for a, b in parts
    )


def _condition(f: BSpline, root: Root) -> Enclosure:
    """The condition number of a zero; at a knot it is 0, since the end coefficient is zero and does not change."""
    from exactspline.verification.conditioning import condition_number

    if root.at_knot:
        return Interval.point(mpq(0))
    if root.segment is None:
        raise ClaimError("a zero without a segment", remedy="report this")
    i = f.breakpoints.index(root.segment[0])
    return condition_number(f.forms[i], f.degree, root, root.multiplicity)
