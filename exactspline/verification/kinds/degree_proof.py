"""Degrees for all curves and all d: by Table 1, at infinity, and by the degree theorem."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain, product
from types import MappingProxyType
from typing import Any

from exactspline.errors import FormulaError
from exactspline.language.choices import Counting, Parameter
from exactspline.language.formula import Formula
from exactspline.language.parts import split
from exactspline.readings.degree import Degree, DegreeReading, equal_from, parse_degree
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet, JetReading
from exactspline.readings.leading_terms import generic_true_degree
from exactspline.symbolic.covariants import degree_at, generic_degree, graded, true_degree, truncated, without_content
from exactspline.symbolic.reduction import Reduction
from exactspline.verification.claim import Claim
from exactspline.verification.evidence import DegreeFound, Fact, Found, WrongDegree
from exactspline.verification.generic_degree import joined_degree
from exactspline.verification.generic_proof import degree_in_table_1, reduction_of, transposed, vanishes
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, ContradictionError, Finding, vacuous
from exactspline.verification.vocabulary import ArgumentKind, Measure, Name, Relation


class DegreeStatement(Claim):
    """The decided statement: the fields of `exactspline.verification.kinds.degree.DegreeClaim`."""

    formula: Name
    claimed: str
    measure: Measure
    relation: Relation
    parameter: Parameter
    counting: Counting
    least_d: int


#: No exceptional d.
NONE_LOWER: Mapping[int, int] = MappingProxyType({})
#: The number of values of each of several degrees tried for a witness.
UNEQUAL = 12


def decide(claim: DegreeStatement, dimension: int, polynomial: bool) -> Finding:
    """The finding on the degree of a claim for every d from its least one upwards."""
    formula = claim.find(claim.formula)
    zero = claim.curve != ArgumentKind.TABLE and vanishes(formula, dimension, polynomial)
    if claim.measure == Measure.NOMINAL:
        return held_against(claim, DegreeFound(_nominal(claim, dimension, polynomial), as_written=zero))
    if zero:
        return vacuous(Fact.VANISHES)
    if claim.parameter == Parameter.SECOND:
        formula = transposed(formula)
    if claim.measure == Measure.TRUE:
        computed, lower = agreed_degree(formula, dimension, polynomial, _counted(claim))
        return held_against(claim, DegreeFound(computed), lower)
    reduction = reduction_of(formula, dimension, polynomial, _counted(claim))
    part = reduction.main
    if claim.measure == Measure.HEIGHT:
        height = part.true.j if part.true else -1
        return held_against(claim, DegreeFound(Degree.number(height)))
    if claim.measure == Measure.REDUCED:
        lower = (
            dict(part.true.lower)
            if part.true
            else lower_degrees([j for j in part.reduced if not j.is_zero], part.parameter)
        )
        return held_against(claim, DegreeFound(part.generic, _grading(part.true)), lower, part.cancelled)
    return _lowest(claim, reduction)


def _counted(claim: DegreeStatement) -> Parameter:
    """The parameter in which the degree is counted; for two exchanged curves it is the first."""
    return Parameter.FIRST if claim.parameter == Parameter.SECOND else claim.parameter


def _grading(true: Any) -> tuple[int, int, int] | None:
    return (int(true.k), int(true.m), int(true.j)) if true else None


def _nominal(claim: DegreeStatement, dimension: int, polynomial: bool) -> Degree:
    formula = claim.find(claim.formula)
    if claim.curve == ArgumentKind.TABLE:
        return degree_in_table_1(formula)
    return DegreeReading("d", claim.parameter, claim.counting).count(formula, dimension, polynomial=polynomial)


def agreed_degree(
    formula: Formula, dimension: int, polynomial: bool, parameter: Parameter
) -> tuple[Degree, dict[int, int]]:
    """The true degree on the generic curve, at infinity and by the degree theorem: two readings that must agree."""
    value = formula(JetReading(order_of(formula, dimension)).argument(formula.kind, dimension, polynomial=polynomial))
    jets, denominator = split(value)
    if denominator is not None:
        raise FormulaError(f"{formula.name} is a quotient", remedy='its degree is that in "lowest terms"')
    jets = [jet for jet in jets if not jet.is_zero]
    if not jets:
        return Degree.number(-1), {}
    computed = generic_degree(jets, parameter)
    at_infinity = generic_true_degree(formula, dimension, polynomial=polynomial, parameter=parameter)
    if computed != at_infinity:
        raise ContradictionError(
            f"{formula.name} has true degree {at_infinity} at infinity, {computed} by the degree theorem",
            remedy="one of the readings is wrong: report this",
        )
    return computed, lower_degrees(jets, parameter)


def lower_degrees(jets: Sequence[Jet], parameter: Parameter = Parameter.FIRST) -> dict[int, int]:
    """The d at which the degree on the generic curve differs from the one for symbolic d, with the degree there: a
    lower one, or −1 where everything is 0.
    """
    if not jets:
        return {}
    generic = generic_degree(jets, parameter)
    parts = [part for jet in jets for part in graded(jet, parameter)]
    suspects = {d for part in parts for d, _ in true_degree(part, parameter).lower}
    degrees = {d: degree_at(jets, d, parameter) for d in sorted(suspects)}
    return {d: n for d, n in degrees.items() if n != generic.at(dict.fromkeys(generic.names, d))}


def _lowest(claim: DegreeStatement, reduction: Reduction) -> Finding:
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
    claim: DegreeStatement, found: DegreeFound, lower: Mapping[int, int] = NONE_LOWER, factor: Found | None = None
) -> Finding:
    """A computed degree compared with the claimed one, for every d from the least one upwards; with all exceptions."""
    computed, claimed = found.degree, parse_degree(claim.claimed)
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
    wrong: dict[str, int] | None
    if failing:
        n, wrong = lower[failing[0]], dict.fromkeys(names, failing[0])
    else:
        wrong = _first_failure(claim, computed, claimed, names)
        n = 0 if wrong is None else computed.at(wrong)
    if wrong is None:
        return Finding(UNDECIDED, found, factor, Fact.NO_COUNTEREXAMPLE)
    at = tuple((Name(name), d) for name, d in sorted(wrong.items()))
    return Finding(REFUTED, found, factor, WrongDegree(n, claimed.at(wrong), claim.relation, at))


def _agree_before(
    start: int, claim: DegreeStatement, computed: Degree, claimed: Degree, exceptions: Mapping[int, int]
) -> bool:
    """Whether the relation holds between the least d and the d from which it always holds, except for exceptions: the
    last d before that must be an exception, so that it is small. For operands of several degrees exceptions are known
    only where these are equal, so that none is allowed.
    """
    if len(computed.names | claimed.names) > 1:
        return start <= claim.least_d
    return all(
        d in exceptions or claim.relation.holds(_at(computed, d), _at(claimed, d))
        for d in range(start - 1, claim.least_d - 1, -1)
    )


def _first_failure(
    claim: DegreeStatement, computed: Degree, claimed: Degree, names: frozenset[str]
) -> dict[str, int] | None:
    """The degrees at which the relation fails: equal ones from max(3, least d) upwards, then those below it, then
    unequal ones; None where it holds at all of these.
    """
    first = max(3, claim.least_d)
    equal: Iterable[dict[str, int]] = (
        dict.fromkeys(names, d) for d in (*range(first, first + 1001), *range(claim.least_d, first))
    )
    least = range(claim.least_d, claim.least_d + UNEQUAL)
    unequal = (dict(zip(sorted(names), each, strict=True)) for each in product(least, repeat=len(names)))
    tried = chain(equal, unequal if len(names) > 1 else ())
    return next((d for d in tried if not claim.relation.holds(computed.at(d), claimed.at(d))), None)


def _at(degree: Degree, d: int) -> int:
    value: int = degree.at(dict.fromkeys(degree.names, d))
    return value
