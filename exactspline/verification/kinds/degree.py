"""Claims of degrees, equalities and bounds, for all degrees d: by Table 1, at infinity, and by the degree theorem."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from functools import cache
from itertools import chain, product
from types import MappingProxyType
from typing import Any, ClassVar

from exactspline.errors import ClaimError, FormulaError
from exactspline.language.arguments import Evaluated, Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import HodographKind, Kind, kind_of
from exactspline.language.operand import Counting, Parameter
from exactspline.language.ruled import RuledSurface, joined, split
from exactspline.language.surface_kind import Surface
from exactspline.readings.degree import Degree, DegreeReading, equal_from, parse_degree
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet, JetReading
from exactspline.readings.leading_terms import generic_true_degree
from exactspline.splines.lowest_terms import surface_in_lowest_terms
from exactspline.splines.lowest_terms import true_degree as true_degree_of_splines
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_patches import Degrees
from exactspline.symbolic.covariants import degree_at, generic_degree, graded, true_degree, truncated, without_content
from exactspline.symbolic.reduction import Reduction
from exactspline.verification.claim import Claim, claim_kind, count_from, formula_name, one_of, read
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import DegreeFound, DegreeHere, Evidence, Fact, Found, WrongDegree
from exactspline.verification.generic_proof import degree_in_table_1, joined_degree, reduction_of, transposed, vanishes
from exactspline.verification.notation import degree_latex
from exactspline.verification.verdict import (
    PROVED,
    REFUTED,
    UNDECIDED,
    VERIFIED,
    ContradictionError,
    Finding,
    inapplicable,
    sampled,
    vacuous,
)
from exactspline.verification.vocabulary import ArgumentKind, Extent, Measure, Name, Relation, Scope


def _degree_text(claim: Claim, name: str, value: str) -> str:
    """A degree in d, or in d1 and d2 for Table 1."""
    names = _degree_names(kind_of(claim.curve))
    if unknown := parse_degree(value).names - names:
        problem = f"the degree {value!r} contains {sorted(unknown)[0]!r}"
        written = f"write it in {' and '.join(sorted(names))}" if names else f"{claim.curve!r} has no degrees"
        raise ClaimError(problem, where=name, remedy=written)
    return str(value)


@cache
def _degree_names(kind: Kind) -> frozenset[str]:
    """The names of the degrees of operands; a curve given by its hodograph is of degree n."""
    symbols = [s for s in kind.symbols(kind.dimensions[0]) if s.degree]
    own = {"n"} if isinstance(kind, HodographKind) else set[str]()
    return frozenset(own).union(*[parse_degree(s.degree_in(p)).names for s in symbols for p in s.parameters])


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
class DegreeClaim(Claim):
    """The degree of ``formula`` is ``claimed``, or at most or at least that, for every d ≥ ``least_d``.

    The ``measure`` is ``nominal`` (Table 1), ``true`` (of a polynomial on the generic curve), ``lowest terms`` (of the
    value; for a ruled surface, of directrix and generator over one denominator), ``reduced`` (of the result of
    `exactspline.symbolic.reduction`; for a ruled surface of its generator, whose length is free) or ``height`` (0 for a
    covariant). For two curves it is the degree in the ``parameter`` s or s̄. All except the nominal degree are degrees
    on the generic curve: on a single curve they are bounds. A curve given by its hodograph is of degree n = 2d + e + 1,
    where u and v are of degree d and h is of degree e.
    """

    kind: ClassVar[str] = "degree"

    formula: Name = field(metadata=read(formula_name))
    claimed: str = field(metadata=read(_degree_text))
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
            problem = f"there is no parameter {self.parameter} of the kind {self.curve!r}"
            raise ClaimError(problem, where="parameter", remedy=f"write {' or '.join(map(repr, map(str, known)))}")
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

    def applies_to(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """Whether the claim applies to single curves: counts by another rule, heights, and lower bounds for the generic
        curve do not.
        """
        silent = (
            self.counting == Counting.PART_BY_PART
            or self.measure == Measure.HEIGHT
            or (self.measure.is_generic and self.relation == Relation.AT_LEAST)
        )
        return not silent and super().applies_to(dimension, polynomial, surface=surface)

    def for_all(self) -> tuple[Name, Finding]:
        """Decide the claim for all curves, in the evaluation mode of the measure."""
        reading = {Measure.NOMINAL: "degree", Measure.TRUE: "infinity"}.get(self.measure, "covariant")
        return Name(reading), super().for_all()[1]

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The finding for symbolic d."""
        return replace(_decide(self, dimension, polynomial), relation=self.relation)

    def part_tried(self, own: Evaluation) -> Evidence | None:
        """The part that is tried: everything for a nominal degree, which is the same on every segment, with any point
        and any constants.
        """
        return None if self.measure == Measure.NOMINAL else super().part_tried(own)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The degree of the given splines. A curve with a higher degree refutes a claim about the generic one; a curve
        with a lower degree may be special, and decides nothing.
        """
        if self._has_too_few_derivatives(argument):
            return inapplicable(Fact.TOO_FEW_DERIVATIVES, relation=self.relation)
        claimed = self._claimed(argument)
        computed = self._computed(argument)
        if computed < 0 and self.measure.is_generic:
            return vacuous(DegreeHere(None, claimed, self.relation))
        here = DegreeHere(computed, claimed, self.relation)
        special = self.on == Extent.ALL and self.measure.is_generic and self.relation == Relation.EQUAL
        if special and computed < claimed:
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
            named = each.degree_in(self.parameter)
            named = named if named.isidentifier() else "n"
            values[named] = max(self._own(known[each.name].degree), values.get(named, 0))
        return degree.at({name: values[name] for name in degree.names})

    def in_free_degrees(self, polynomial: bool) -> Degree:
        """The claimed degree in terms of the free degrees of the operands: n, the degree of a curve given by its
        hodograph, is that of an integral, and e is 0 if h = 1.
        """
        degree, kind = parse_degree(self.claimed), kind_of(self.curve)
        if isinstance(kind, HodographKind):
            degree = degree.where("n", parse_degree(kind.symbols(2)[0].degree))
            degree = degree.where("e", Degree.number(0)) if polynomial else degree
        return degree

    def _has_too_few_derivatives(self, argument: Any) -> bool:
        """Whether the degree is counted on a patch of lower degree than the formula has derivatives."""
        if self.measure != Measure.NOMINAL or not isinstance(argument, Surface):
            return False
        return any(min(f.degree) < order_of(self.find(self.formula), argument.dimension) for f in argument.p)

    def _computed(self, argument: Evaluated) -> int:
        if self.measure == Measure.REDUCED:
            return max(self._own(p.true_degree) for p in split(self._reduced(argument))[0])
        value = self.find(self.formula)(argument)
        if self.measure == Measure.NOMINAL:
            return self._own(value.degree)
        if self.measure == Measure.TRUE:
            components, denominator = split(value)
            if denominator is not None:
                raise _quotient_has_none(self.formula)
            return max(self._own(p.true_degree) for p in components)
        return self._lowest(joined(value) if isinstance(value, RuledSurface) else value)

    def _reduced(self, argument: Any) -> Any:
        pair = isinstance(argument, Pair)
        polynomial = argument.first.polynomial if pair else argument.polynomial
        if pair and self.parameter == Parameter.SECOND:
            swapped = transposed(self.find(self.formula))
            return reduction_of(swapped, argument.dimension, polynomial).main.on(Pair(argument.second, argument.first))
        return reduction_of(self.find(self.formula), argument.dimension, polynomial).main.on(argument)

    def _own(self, degree: Any) -> int:
        """The degree in the parameter that is counted."""
        if isinstance(degree, Degrees):
            return int(degree.s if self.parameter in (Parameter.FIRST, Parameter.U) else degree.t)
        return int(degree)

    def _lowest(self, value: Any) -> int:
        """The degree in lowest terms; for a value in two parameters the degree on the whole rectangle, since more may
        cancel at single values of the other parameter.
        """
        components, denominator = split(value)
        if not isinstance(components[0], TensorSpline):
            return true_degree_of_splines(value)
        if all(x.is_zero for x in components):
            return -1
        if denominator is not None:
            components, denominator = split(surface_in_lowest_terms(value))
        parts = components if denominator is None else [*components, denominator]
        return max(self._own(x.true_degree) for x in parts)


#: The empty set of exceptional d.
NONE_LOWER: Mapping[int, int] = MappingProxyType({})
#: The number of values of each of several degrees tried for a witness.
UNEQUAL = 12


def _decide(claim: DegreeClaim, dimension: int, polynomial: bool) -> Finding:
    """The finding on the degree of a claim for every d from its least one upwards."""
    formula = claim.find(claim.formula)
    zero = vanishes(formula, dimension, polynomial)
    if claim.measure == Measure.NOMINAL:
        nominal = DegreeFound(_nominal(claim, dimension, polynomial), as_written=zero)
        return held_against(claim, nominal, polynomial=polynomial)
    if zero:
        return vacuous(Fact.ZERO)
    if claim.parameter == Parameter.SECOND:
        formula = transposed(formula)
    if claim.measure == Measure.TRUE:
        computed, lower = agreed_degree(formula, dimension, polynomial, _counted(claim))
        return held_against(claim, DegreeFound(computed), lower)
    reduction = reduction_of(formula, dimension, polynomial, _counted(claim))
    part = reduction.main
    if claim.measure == Measure.HEIGHT:
        if part.true is None:
            raise FormulaError(
                f"{formula.name} is not homogeneous: its height is not computed", remedy="claim those of its parts"
            )
        return held_against(claim, DegreeFound(Degree.number(part.true.j)))
    if claim.measure == Measure.REDUCED:
        lower = (
            dict(part.true.lower)
            if part.true
            else lower_degrees([j for j in part.reduced if not j.is_zero], part.parameter)
        )
        return held_against(claim, DegreeFound(part.generic, _grading(part.true)), lower, part.cancelled)
    return _lowest(claim, reduction)


def _counted(claim: DegreeClaim) -> Parameter:
    """The parameter in which the degree is counted; for two exchanged curves it is the first."""
    return Parameter.FIRST if claim.parameter == Parameter.SECOND else claim.parameter


def _grading(true: Any) -> tuple[int, int, int] | None:
    return (int(true.k), int(true.m), int(true.j)) if true else None


def _nominal(claim: DegreeClaim, dimension: int, polynomial: bool) -> Degree:
    formula = claim.find(claim.formula)
    if claim.curve == ArgumentKind.TABLE:
        return degree_in_table_1(formula)
    return DegreeReading("d", claim.parameter, claim.counting).count(formula, dimension, polynomial=polynomial)


def agreed_degree(
    formula: Formula, dimension: int, polynomial: bool, parameter: Parameter
) -> tuple[Degree, dict[int, int]]:
    """The true degree on the generic curve, at infinity and by the degree theorem: two computations that must agree."""
    value = formula(JetReading(order_of(formula, dimension)).argument(formula.kind, dimension, polynomial=polynomial))
    jets, denominator = split(value)
    if denominator is not None:
        raise _quotient_has_none(formula.name)
    jets = [jet for jet in jets if not jet.is_zero]
    if not jets:
        return Degree.number(-1), {}
    computed = generic_degree(jets, parameter)
    at_infinity = generic_true_degree(formula, dimension, polynomial=polynomial, parameter=parameter)
    if computed != at_infinity:
        problem = f"{formula.name} has true degree {at_infinity} at infinity, {computed} by the degree theorem"
        raise ContradictionError(problem, remedy="one of the readings is wrong: report this")
    return computed, lower_degrees(jets, parameter)


def _quotient_has_none(name: str) -> FormulaError:
    """A quotient of polynomials has no true degree."""
    return FormulaError(f"{name} is a quotient", remedy='its degree is that in "lowest terms"')


def lower_degrees(jets: Sequence[Jet], parameter: Parameter = Parameter.FIRST) -> dict[int, int]:
    """The numbers d for which the degree on the generic curve differs from the degree for symbolic d, each with its
    degree, which is lower, or −1 if the value is 0.
    """
    if not jets:
        return {}
    generic = generic_degree(jets, parameter)
    parts = [part for jet in jets for part in graded(jet, parameter)]
    suspects = {d for part in parts for d, _ in true_degree(part, parameter).lower}
    degrees = {d: degree_at(jets, d, parameter) for d in sorted(suspects)}
    return {d: n for d, n in degrees.items() if n != generic.at(dict.fromkeys(generic.names, d))}


def _lowest(claim: DegreeClaim, reduction: Reduction) -> Finding:
    """The value in lowest terms; for a ruled surface, directrix and generator over one denominator."""
    parameter = _counted(claim)
    computed = reduction.main.generic_lowest if len(reduction.parts) == 1 else joined_degree(reduction, parameter)
    order = max(part.core[0].ring.order for part in reduction.parts)
    jets = [jet for jet in reduction.joined if not jet.is_zero]
    lower = lower_degrees(jets, parameter)
    for d in range(claim.least_d, order):
        *tops, bottom = truncated(reduction.joined, d, parameter)
        cut = [jet for jet in (*tops, bottom) if not jet.is_zero]
        vanishes = all(jet.is_zero for jet in tops)
        n = -1 if vanishes else degree_at(without_content(cut), d, parameter)
        if n != computed.at(dict.fromkeys(computed.names, d)):
            lower[d] = n
    return held_against(claim, DegreeFound(computed), lower, reduction.main.cancelled)


def held_against(
    claim: DegreeClaim,
    found: DegreeFound,
    lower: Mapping[int, int] = NONE_LOWER,
    factor: Found | None = None,
    *,
    polynomial: bool = False,
) -> Finding:
    """A computed degree compared with the claimed one, for every d from the least one upwards; with all exceptions."""
    computed, claimed = found.degree, claim.in_free_degrees(polynomial)
    larger = computed.max(claimed)
    agree = {
        Relation.EQUAL: (computed, claimed),
        Relation.AT_MOST: (larger, claimed),
        Relation.AT_LEAST: (larger, computed),
    }[claim.relation]
    start = equal_from(*agree)
    gone = tuple(sorted(d for d, n in lower.items() if n > _at(computed, d)))
    rest = tuple(sorted(lower.keys() - set(gone)))
    found = replace(found, start=1 if start is None else start, lower=rest, zero=gone)
    names = computed.names | claimed.names
    vanishing_is_less = claim.relation == Relation.AT_MOST
    failing = [
        d
        for d in sorted(lower)
        if d >= claim.least_d
        and not (lower[d] < 0 and vanishing_is_less)
        and not claim.relation.holds(lower[d], _at(claimed, d))
    ]
    if start is not None and not failing and _agree_before(start, claim, computed, claimed, lower):
        return Finding(PROVED, found, factor)
    # the degree for symbolic d first: it says more than an exceptional d
    wrong = _first_failure(claim, computed, claimed, names, lower)
    n = 0 if wrong is None else computed.at(wrong)
    if wrong is None and failing:
        n, wrong = lower[failing[0]], dict.fromkeys(names, failing[0])
    if wrong is None:
        return Finding(UNDECIDED, found, factor, Fact.NO_COUNTEREXAMPLE)
    at = tuple((Name(name), d) for name, d in sorted(wrong.items()))
    return Finding(REFUTED, found, factor, WrongDegree(n, claimed.at(wrong), claim.relation, at))


def _agree_before(
    start: int, claim: DegreeClaim, computed: Degree, claimed: Degree, exceptions: Mapping[int, int]
) -> bool:
    """Whether the relation holds between the least d and the d from which it always holds, apart from the exceptions.
    The last d before that must be an exception, so that it is small. For operands of several degrees, exceptions are
    known only if the degrees are equal, so that no exception is allowed.
    """
    if len(computed.names | claimed.names) > 1:
        return start <= claim.least_d
    return all(
        d in exceptions or claim.relation.holds(_at(computed, d), _at(claimed, d))
        for d in range(start - 1, claim.least_d - 1, -1)
    )


def _first_failure(
    claim: DegreeClaim, computed: Degree, claimed: Degree, names: frozenset[str], exceptions: Mapping[int, int]
) -> dict[str, int] | None:
    """The degrees at which the relation fails, apart from the exceptions: first equal degrees from max(3, least d)
    upwards, then equal ones below, then unequal ones. None if the relation holds at all of these.
    """
    first = max(3, claim.least_d)
    equal: Iterable[dict[str, int]] = (
        dict.fromkeys(names, d)
        for d in (*range(first, first + 1001), *range(claim.least_d, first))
        if d not in exceptions
    )
    least = range(claim.least_d, claim.least_d + UNEQUAL)
    unequal = (dict(zip(sorted(names), each, strict=True)) for each in product(least, repeat=len(names)))
    tried = chain(equal, unequal if len(names) > 1 else ())
    return next((d for d in tried if not claim.relation.holds(computed.at(d), claimed.at(d))), None)


def _at(degree: Degree, d: int) -> int:
    return degree.at(dict.fromkeys(degree.names, d))
