"""Claims of contact: the order of contact of a curve with a curve or surface that is attached to it at a point."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError, VanishingDivisorError
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, Evaluated
from exactspline.language.formula import Formula
from exactspline.language.ruled import split
from exactspline.polynomials.cost import at_its_cost
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import JetFraction, RationalJetReading
from exactspline.verification import phrases as say
from exactspline.verification.claim import Claim, claim_kind, count_from, formula_name, one_of, read
from exactspline.verification.evaluation import Evaluation, at_equal_parameters, equated, on_segments
from exactspline.verification.evidence import Evidence, Fact
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, inapplicable, vacuous
from exactspline.verification.vocabulary import Name, Relation

#: The denominators of the two curves.
BAR = dict(zip((*BARRED, "W"), (*COORDINATES, "w"), strict=True))
#: The largest order.
LARGEST_ORDER = 12


def _order_of_contact(claim: Claim, name: str, value: object) -> int:
    """An order of contact."""
    order = count_from(0)(claim, name, value)
    if order > LARGEST_ORDER:
        raise ClaimError(f"contact of order {order}", where=name, remedy=f"orders up to {LARGEST_ORDER} are decided")
    return order


@claim_kind
class Contact(Claim):
    """The object attached to the curve at the parameter s has contact of ``order`` n with it there. The ``formula``
    vanishes where the point at s̄ lies on the object attached at s (in the osculating circle: its squared distance from
    the centre less the squared radius). It is a formula of two curves, both of which are this curve. At s̄ = s its
    value and its derivatives with respect to s̄ up to order n vanish, and for the relation ``=`` the next derivative
    does not vanish on the generic curve.
    """

    kind: ClassVar[str] = "contact"
    notation: ClassVar[str] = r"$formula\;\text{has contact of order}\;$claims"
    tries_all: ClassVar[bool] = True
    evaluated_first: ClassVar[bool] = False

    formula: Name = field(metadata=read(formula_name))
    order: int = field(metadata=read(_order_of_contact))
    relation: Relation = field(default=Relation.EQUAL, metadata=read(one_of(Relation)))

    def validate(self) -> None:
        """Reject claims that are not about two curves, and upper bounds, which special curves exceed."""
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

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The derivatives as differential polynomials of a single curve in place of both."""
        formula = self.find(self.formula)
        ring = RationalJetReading(order_of(formula, dimension) + self.order + 1)
        value = split(formula(ring.argument(formula.kind, dimension, polynomial=polynomial)))[0]
        if all(x.is_zero for x in value):
            return vacuous()
        if _is_singular(formula, dimension, polynomial):
            return Finding(UNDECIDED, Fact.NO_CONTACT, witness=Fact.SINGULAR_CONTACT)
        order_found = self._order(value, _on_diagonal)
        if order_found is None:
            return Finding(PROVED, say.contact(self.order, self.relation))
        if order_found > self.order:
            return Finding(REFUTED, say.at_least(order_found), witness=say.derivative_vanishes(order_found))
        witness = self.refuted_on_examples().witness or say.derivative_remains(order_found, None)
        return Finding(REFUTED, say.contact(order_found - 1, Relation.EQUAL), witness=witness)

    def _order(self, value: list[Any], on_diagonal: Diagonal) -> int | None:
        """None if the contact is as claimed; otherwise the order of the derivative that contradicts it: a derivative up
        to the claimed order that does not vanish, or the next derivative if that vanishes, too.
        """
        for n in range(self.order + 1):
            if any(not on_diagonal(x).is_zero for x in value):
                return n
            value = [x.d(1, by=PARAMETERS[1]) for x in value]
        higher = self.relation == Relation.EQUAL and all(on_diagonal(x).is_zero for x in value)
        return self.order + 1 if higher else None

    def beside(self, own: Evaluation) -> Evidence:
        """The second curve, which is the given curve itself."""
        return Fact.WITH_ITSELF

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The derivatives as polynomials in the two parameters, on every segment."""
        formula, curve = self.find(self.formula), own.curve
        if _is_singular(formula, curve.dimension, curve.polynomial):
            return Finding(UNDECIDED, Fact.NO_CONTACT, witness=Fact.SINGULAR_CONTACT)
        order, found, higher = order_of(formula, curve.dimension), None, 0
        whole = list(on_segments(formula.kind, curve, order, same=True))
        for segment in whole:
            try:
                value = split(formula(segment.argument))[0]
                found = self._order(value, at_equal_parameters)
            except VanishingDivisorError:
                return vacuous(say.undefined_there(segment.interval))
            if all(x.is_zero for x in value):
                return vacuous(say.zero_on(segment.interval))
            if found is not None and found <= self.order:
                for _ in range(found):
                    value = [x.d(1, by=PARAMETERS[1]) for x in value]
                rest = next(x for x in map(at_equal_parameters, value) if not x.is_zero)
                return Finding(REFUTED, Fact.LESS_CONTACT, witness=say.derivative_remains(found, segment.place(rest)))
            higher += found is not None
        if higher == len(whole):
            return inapplicable(Fact.HIGHER_CONTACT_HERE, say.at_least(self.order + 1))
        return Finding(VERIFIED, say.contact(self.order, self.relation))


#: The value of a quotient of both parameters where they are equal.
Diagonal = Callable[[JetFraction], JetFraction]


def _on_diagonal(value: JetFraction) -> JetFraction:
    """A quotient of jets of two curves, evaluated where both are the same curve at the same parameter.

    Raises `FormulaError` if its denominator vanishes there.
    """
    return equated(value, BAR)


@at_its_cost
def _is_singular(formula: Formula, dimension: int, polynomial: bool) -> bool:
    """Whether the equations ``value = 0`` for the point at s̄ have fewer independent gradients where the points meet
    than elsewhere: there is no tangent there, so that contact is not defined. Any formula times ``‖γ(s̄) − γ(s)‖²``
    vanishes there to second order.

    Raises `FormulaError` if the value depends on derivatives at s̄: it is not the equation of an object.
    """
    reading = RationalJetReading(order_of(formula, dimension))
    value = split(formula(reading.argument(formula.kind, dimension, polynomial=polynomial)))[0]
    ring = value[0].ring
    second = {name: order for name, order in ring.variables if name in BAR}
    for x in value:
        used = [ring.variables[i] for p in (x.top, x.bottom) for i, n in enumerate(p.degrees()) if int(n)]
        if any(name in BAR and order != (0,) for name, order in used):
            raise FormulaError(
                "the formula contains derivatives of the second curve", remedy="contact is that of the point at s̄"
            )
    names = [name for name in BARRED[:dimension] if name in second]
    rows = [[partial_derivative(x, ring.index[name, (0,)]) for name in names] for x in value]
    met = [[_on_diagonal(entry) for entry in row] for row in rows]
    return rank_of(met) < rank_of(rows)


def partial_derivative(x: JetFraction, i: int) -> JetFraction:
    """The derivative with respect to one variable, up to the square of the denominator."""
    top, bottom = (JetFraction(x.ring, p, x.ring.context.constant(1)) for p in (x.top, x.bottom))
    d_top, d_bottom = (JetFraction(x.ring, p.derivative(i), x.ring.context.constant(1)) for p in (x.top, x.bottom))
    return d_top * bottom - top * d_bottom


def rank_of(rows: list[list[JetFraction]]) -> int:
    """The rank of a matrix, by elimination."""
    rows, rank = [list(row) for row in rows], 0
    for column in range(len(rows[0])):
        pivot = next((i for i in range(rank, len(rows)) if not rows[i][column].is_zero), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        for i in range(rank + 1, len(rows)):
            k, m = rows[i][column], rows[rank][column]
            rows[i] = [a * m - b * k for a, b in zip(rows[i], rows[rank], strict=True)]
        rank += 1
    return rank
