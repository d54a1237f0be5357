"""Claims of degrees: equalities and bounds, nominal and true, for all degrees d."""

from __future__ import annotations

from dataclasses import field, replace
from functools import cache
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.arguments import Pair
from exactspline.language.choices import Counting, Parameter
from exactspline.language.kinds import Kind, kind_of
from exactspline.language.parts import joined, split
from exactspline.language.ruled import RuledSurface
from exactspline.language.surface_kind import Surface
from exactspline.readings.degree import parse_degree
from exactspline.readings.differential_order import order_of
from exactspline.splines.lowest_terms import true_degree
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_lowest_terms import in_lowest_terms
from exactspline.splines.tensor_patches import Degrees
from exactspline.verification.claim import Claim, count_from, formula_name, one_of, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import DegreeHere, Evidence, Fact, WrongDegree, ZeroHere
from exactspline.verification.generic_proof import reduction_of, transposed
from exactspline.verification.kinds.degree_proof import DegreeStatement, decide
from exactspline.verification.notation import degree_latex
from exactspline.verification.verdict import REFUTED, VERIFIED, Finding, inapplicable, sampled, vacuous
from exactspline.verification.vocabulary import ArgumentKind, Measure, Name, Relation, Scope


def degree_text(claim: Claim, name: str, value: str) -> str:
    """A degree in d, or in d1 and d2 for Table 1."""
    names = _degree_names(kind_of(claim.curve))
    if unknown := parse_degree(value).names - names:
        raise ClaimError(
            f"the degree {value!r} contains {sorted(unknown)[0]!r}",
            where=name,
            remedy=f"write it in {' and '.join(sorted(names))}",
        )
    return str(value)


@cache
def _degree_names(kind: Kind) -> frozenset[str]:
    """The names of the degrees of operands."""
    symbols = [s for s in kind.symbols(kind.dimensions[0]) if s.degree]
    return frozenset().union(*[parse_degree(s.degree_in(p)).names for s in symbols for p in s.parameters])


#: The measured degree, as LaTeX.
MEASURES = {
    Measure.NOMINAL: r"\deg",
    Measure.TRUE: r"\deg_{\mathrm{true}}",
    Measure.LOWEST_TERMS: r"\deg_{\mathrm{lowest\ terms}}",
    Measure.REDUCED: r"\deg_{\mathrm{reduced}}",
    Measure.HEIGHT: r"\mathrm{height}",
}
#: Relations in LaTeX.
RELATIONS = {Relation.EQUAL: "=", Relation.AT_MOST: r"\le", Relation.AT_LEAST: r"\ge"}


@claim_kind
class DegreeClaim(DegreeStatement):
    """The degree of ``formula`` is ``claimed``, or at most or at least that, for every d ≥ ``least_d``.

    The ``measure`` is ``nominal`` (Table 1), ``true`` (of a polynomial on the generic curve), ``lowest terms`` (of the
    value; for a ruled surface, of directrix and generator over one denominator), ``reduced`` (of the result of
    `exactspline.symbolic.reduction`; for a ruled surface of its generator, whose length is free) or ``height`` (0 for a
    covariant). For two curves it is the degree in the ``parameter`` s or s̄. All except the nominal degree are degrees
    on the generic curve: on a single curve they are bounds.
    """

    kind: ClassVar[str] = "degree"

    formula: Name = field(metadata=read(formula_name))
    claimed: str = field(metadata=read(degree_text))
    measure: Measure = field(default=Measure.NOMINAL, metadata=read(one_of(Measure)))
    relation: Relation = field(default=Relation.EQUAL, metadata=read(one_of(Relation)))
    parameter: Parameter = field(default=Parameter.FIRST, metadata=read(one_of(Parameter)))
    counting: Counting = field(default=Counting.TABLE_1, metadata=read(one_of(Counting)))
    least_d: int = field(default=1, metadata=read(count_from(1)))

    def validate(self) -> None:
        """Reject combinations without meaning."""
        table = self.curve == ArgumentKind.TABLE
        kind = kind_of(self.curve)
        if self.parameter not in (known := kind.parameters(kind.dimensions[0])):
            raise ClaimError(
                f"there is no parameter {self.parameter} of the kind {self.curve!r}",
                where="parameter",
                remedy=f"write {' or '.join(map(repr, map(str, known)))}",
            )
        if self.counting == Counting.PART_BY_PART and (self.measure != Measure.NOMINAL or table):
            raise ClaimError("only nominal degrees of curves are counted", where="counting", remedy='"Table 1"')
        if table and (self.measure != Measure.NOMINAL or self.of != Scope.BOTH):
            raise ClaimError("Table 1 counts nominal degrees of any operands", where="measure", remedy='"nominal"')
        if self.measure == Measure.HEIGHT and (parse_degree(self.claimed).names or self.relation != Relation.EQUAL):
            raise ClaimError("a height is a number", where="claimed", remedy='write for example "0"')

    @property
    def claims(self) -> str:
        """The degree, with its relation."""
        return self.relation.bound(str(parse_degree(self.claimed)))

    @property
    def latex(self) -> str:
        """The degree, the relation, and the claimed degree."""
        sign = RELATIONS[self.relation]
        return rf"{MEASURES[self.measure]} {self.symbol(self.formula)} {sign} {degree_latex(self.claimed)}"

    @property
    def proof_reading(self) -> Name:
        """The reading that decides the measure."""
        return Name({Measure.NOMINAL: "degree", Measure.TRUE: "infinity"}.get(self.measure, "covariant"))

    def speaks_of(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """Counts by another rule, heights, and lower bounds for the generic curve do not apply to single curves."""
        silent = (
            self.counting == Counting.PART_BY_PART
            or self.measure == Measure.HEIGHT
            or (self.measure.is_generic and self.relation == Relation.AT_LEAST)
        )
        return not silent and super().speaks_of(dimension, polynomial, surface=surface)

    def prove(self) -> tuple[Name, Finding]:
        """The reading is that of the measure."""
        return self.proof_reading, super().prove()[1]

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """For symbolic d."""
        finding = decide(self, dimension, polynomial)
        return replace(finding, relation=self.relation)

    def part_tried(self, own: Evaluation) -> Evidence | None:
        """A nominal degree is that of every segment, with any point and any constants."""
        return None if self.measure == Measure.NOMINAL else super().part_tried(own)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The degree of the given splines. A curve with a higher degree refutes a claim about the generic one; a curve
        with a lower degree may be special, and decides nothing.
        """
        if self._has_too_few_derivatives(argument):
            return inapplicable(Fact.TOO_FEW_DERIVATIVES, relation=self.relation)
        claimed = self._claimed(argument)
        computed = self._computed(argument)
        if computed < 0 and self.measure.is_generic:
            return vacuous(ZeroHere(claimed, self.relation))
        here = DegreeHere(computed, claimed, self.relation)
        if self.measure.is_generic and self.relation == Relation.EQUAL and computed < claimed:
            return inapplicable(Fact.LOWER_DEGREE_HERE, here, self.relation)
        holds = self.relation.holds(computed, claimed)
        wrong = None if holds else WrongDegree(computed, claimed, self.relation)
        finding = Finding(VERIFIED if holds else REFUTED, here, witness=wrong, relation=self.relation)
        along_a_line = self.measure == Measure.LOWEST_TERMS and isinstance(argument, (Pair, Surface))
        return sampled(finding, Fact.ONE_LINE) if holds and along_a_line else finding

    def _claimed(self, argument: Any) -> int:
        degree = parse_degree(self.claimed)
        known, values = argument.operands(), dict[str, int]()
        if self.curve == ArgumentKind.TABLE:
            return degree.at({name: known[name.replace("d", "p")].degree for name in degree.names})
        for each in kind_of(self.curve).symbols(argument.dimension):
            if self.parameter not in each.parameters or each.name not in known:
                continue
            if (named := each.degree_in(self.parameter)).isidentifier():
                values[named] = max(self._own(known[each.name].degree), values.get(named, 0))
        return degree.at({name: values[name] for name in degree.names})

    def _has_too_few_derivatives(self, argument: Any) -> bool:
        """Whether the degree is counted on a patch of lower degree than the formula has derivatives."""
        if self.measure != Measure.NOMINAL or not isinstance(argument, Surface):
            return False
        return any(min(f.degree) < order_of(self.find(self.formula), argument.dimension) for f in argument.p)

    def _computed(self, argument: Handed) -> int:
        if self.measure == Measure.REDUCED:
            return max(self._own(p.true_degree) for p in split(self._reduced(argument))[0])
        value = self.find(self.formula)(argument)
        if self.measure == Measure.NOMINAL:
            return self._own(value.degree)
        if self.measure == Measure.TRUE:
            return max(self._own(p.true_degree) for p in split(value)[0])
        return self._lowest(joined(value) if isinstance(value, RuledSurface) else value)

    def _reduced(self, argument: Any) -> Any:
        pair = isinstance(argument, Pair)
        polynomial = argument.first.polynomial if pair else argument.polynomial
        if pair and self.parameter == Parameter.SECOND:
            swapped = transposed(self.find(self.formula))
            return reduction_of(swapped, argument.dimension, polynomial).main.on(Pair(argument.second, argument.first))
        return reduction_of(self.find(self.formula), argument.dimension, polynomial).main.on(argument)

    @property
    def _is_first(self) -> bool:
        return self.parameter in (Parameter.FIRST, Parameter.U)

    def _own(self, degree: Any) -> int:
        """The degree in the parameter that is counted."""
        if isinstance(degree, Degrees):
            return int(degree.s if self._is_first else degree.t)
        return int(degree)

    def _lowest(self, value: Any) -> int:
        """The degree in lowest terms; for a value in two parameters on the whole rectangle, since more may cancel at
        single values of the other parameter.
        """
        components, denominator = split(value)
        if not isinstance(components[0], TensorSpline):
            return true_degree(value)
        if all(x.is_zero for x in components):
            return -1
        if denominator is not None:
            components, denominator = split(in_lowest_terms(value))
        parts = components if denominator is None else [*components, denominator]
        return max(self._own(x.true_degree) for x in parts)
