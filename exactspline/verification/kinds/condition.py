"""Claims that one form of a zero-set problem is better conditioned than another, on one curve."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.language.parts import split
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.verification.claim import formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.components import only_component
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import AtKnot, Conditions, Enclosure, Fact, Isolated, NotBetter, OnExample
from exactspline.verification.example_claim import ExampleClaim
from exactspline.verification.verdict import REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Name


@claim_kind
class Condition(ExampleClaim):
    """At every zero that ``left`` and ``right`` have in common on the curve ``example``, ``left`` has the smaller
    condition number: a relative change of its Bernstein coefficients moves the zero less.
    """

    kind: ClassVar[str] = "condition"
    value: ClassVar[str] = "better at every common zero"
    notation: ClassVar[str] = r"$left \;\text{is better conditioned than}\; $right"
    sides: ClassVar[tuple[str, ...]] = ("left", "right")

    left: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """Undecided where enclosures do not separate two condition numbers."""
        f, g = (only_component(self, n, split(self.find(n)(argument))[0]) for n in (self.left, self.right))
        theirs = list(zeros(g, periodic=own.curve.closed))
        pairs = [
            (root, _condition(f, root), _condition(g, other))
            for root in zeros(f, periodic=own.curve.closed)
            for other in theirs
            if root == other
        ]
        if not pairs:
            return vacuous(Fact.NO_COMMON_ZERO)
        conditions = Conditions(tuple((a, b) for _, a, b in pairs))
        if all(a[1] < b[0] for _, a, b in pairs):
            return Finding(VERIFIED, conditions)
        for root, a, b in pairs:
            if a[0] >= b[1]:
                witness = OnExample(Name(self.example), NotBetter(place_of_root(root)))
                return Finding(REFUTED, conditions, witness=witness)
        return Finding(UNDECIDED, conditions)


def _condition(f: BSpline, root: Root) -> Enclosure:
    """The condition number of a zero; at a knot it is 0, since the end coefficient is zero and does not change."""
    from exactspline.verification.conditioning.condition_number import condition_number

    if root.at_knot:
        return Interval.point(mpq(0))
    if root.segment is None:
        raise ClaimError("a zero without a segment", remedy="report this")
    i = f.breakpoints.index(root.segment[0])
    return condition_number(f.forms[i], f.degree, root, root.multiplicity)


def place_of_root(root: Root) -> AtKnot | Isolated:
    """Where a root is, as a typed place."""
    return AtKnot(root.low) if root.at_knot else Isolated(root.low, root.high)
