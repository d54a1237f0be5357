"""Claims of contact: the order to which a curve or surface attached to a curve at a point meets it there."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError
from exactspline.exact import mpq, text
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS
from exactspline.language.parts import split
from exactspline.readings.differential_order import order_of
from exactspline.readings.rational_jet import JetFraction, RationalJetReading
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.verification.check_arguments import beginning
from exactspline.verification.claim import Claim, count_from, formula_name, one_of, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.verdict import OUTSIDE, PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Relation

#: Why a curve of higher contact decides nothing about the generic one.
HIGHER_HERE = "the contact is of a higher order on it, as it may be on special curves"
#: The denominators of the two curves.
BAR = dict(zip((*BARRED, "W"), (*COORDINATES, "w"), strict=True))


#: The largest order.
LARGEST_ORDER = 12


def order_of_contact(claim: Claim, name: str, value: object) -> int:
    """An order of contact."""
    order = count_from(0)(claim, name, value)
    if order > LARGEST_ORDER:
        raise ClaimError(f"contact of order {order}", where=name, remedy=f"orders up to {LARGEST_ORDER} are decided")
    return order


@claim_kind
class Contact(Claim):
    """The object attached to the curve at the parameter s has contact of ``order`` n with it there. The ``formula``
    vanishes where the point at s̄ lies on the object attached at s (in the osculating circle: its squared distance from
    the centre less the squared radius). It is one of two curves; both are this one. At s̄ = s its value and its
    derivatives by s̄ up to order n vanish, and for the relation ``=`` the next one does not on the generic curve.
    """

    kind: ClassVar[str] = "contact"

    formula: str = field(metadata=read(formula_name))
    order: int = field(metadata=read(order_of_contact))
    relation: Relation = field(default=Relation.EQUAL, metadata=read(one_of(Relation)))

    def validate(self) -> None:
        """Refuse claims that are not about two curves, and upper bounds, which special curves exceed."""
        if not self.of_pair:
            raise ClaimError(
                "contact is claimed of two points of a curve", where="curve", remedy='"pair" or "plane pair"'
            )
        if self.relation == Relation.AT_MOST:
            raise ClaimError("special curves have a higher contact", where="relation", remedy='write "=" or "≥"')

    @property
    def claims(self) -> str:
        """The order."""
        return f"{'≥ ' if self.relation == Relation.AT_LEAST else ''}{self.order}"

    @property
    def relation_claimed(self) -> Relation:
        """The relation of the claim."""
        return self.relation

    @property
    def latex(self) -> str:
        """The name and the order."""
        return rf"{self.symbol(self.formula)}\;\text{{has contact of order}}\;{self.claims}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The derivatives as differential polynomials of one curve, which both are."""
        formula = self.find(self.formula)
        ring = RationalJetReading(order_of(formula, dimension) + self.order + 1)
        value = _components(formula(ring.argument(formula.kind, dimension, polynomial=polynomial)))
        if all(x.is_zero for x in value):
            return vacuous(self.claims)
        for n in range(self.order + 1):
            if any(not on_diagonal(x).is_zero for x in value):
                found = f"{n - 1}" if n else "none: it does not pass through the point"
                return Finding(REFUTED, self.claims, found, witness=self.refuted_on_examples().witness or told(n))
            value = [x.d(1, by=PARAMETERS[1]) for x in value]
        if self.relation == Relation.EQUAL and all(on_diagonal(x).is_zero for x in value):
            higher = f"at least {self.order + 1}"
            return Finding(REFUTED, self.claims, higher, witness=f"{told(self.order + 1, '= 0')} on every curve")
        return Finding(PROVED, self.claims, self.claims)

    def beside(self, own: Evaluation) -> str:
        """A claim of all curves is tried on the first segment."""
        return ", first segment"

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """On the first segment of the curve, at more parameters than the derivatives can have zeros."""
        curve: Nurbs = own.curve
        formula, piece = self.find(self.formula), beginning(curve)
        value = formula(surface_pair(piece, piece))
        numerators, below = split(value)
        if all(x.is_zero for x in numerators):
            return vacuous(self.claims)
        if below is not None and all(below(t, t) == 0 for t in _parameters(below)):
            return vacuous(self.claims, "it does not exist where the points meet: 1/0")
        higher = True
        for f in numerators:
            for t in _parameters(f):
                along = f.at_s(t)
                for n in range(self.order + 1):
                    if along(t):
                        return Finding(REFUTED, self.claims, "less", witness=f"{told(n)} at the parameter {text(t)}")
                    along = along.d()
                higher = higher and not along(t)
        if higher and self.relation == Relation.EQUAL:
            return Finding(UNDECIDED, self.claims, f"at least {self.order + 1}", witness=OUTSIDE + HIGHER_HERE)
        return Finding(VERIFIED, self.claims, self.claims)


def told(n: int, what: str = "≠ 0") -> str:
    """That the n-th derivative vanishes, or does not."""
    return f"the derivative of order {n} by s̄ is {what} at s̄ = s" if n else f"the value is {what} at s̄ = s"


def on_diagonal(value: JetFraction) -> JetFraction:
    """A quotient of jets of two curves where they are one, at one parameter.

    Raises `FormulaError` where its denominator vanishes there.
    """
    ring = value.ring
    images = [ring.gens[ring.index[BAR.get(name, name), order]] for name, order in ring.variables]
    top, bottom = (p.compose(*images, ctx=ring.context) for p in (value.top, value.bottom))
    if not bottom:
        raise FormulaError("a denominator vanishes where the points meet", remedy="multiply the formula by it")
    return JetFraction(ring, top, bottom)


def _components(value: Any) -> list[Any]:
    return split(value)[0]


def _parameters(f: TensorSpline) -> list[mpq]:
    """More inner parameters than the diagonal has zeros, if it has not all."""
    (a, b), _ = f.domain
    n = int(f.degree.s) + int(f.degree.t) + 1
    return [a + (b - a) * mpq(i, n + 1) for i in range(1, n + 1)]
