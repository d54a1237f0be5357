"""Claims that several formulas have one zero set."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.parts import split
from exactspline.language.rational import Rational
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim, formula_names, one_of, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import common_zeros, extra_zero
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import Fact, Quotients, VanishesAlone, VanishesAlways
from exactspline.verification.generic_proof import factor_of, factor_of_numerators, harmful
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Name, ZeroSetOf


@claim_kind
class ZeroSet(Claim):
    """All of ``formulas`` have one zero set: that of their numerators without cancellation, or of their values in
    lowest terms.
    """

    kind: ClassVar[str] = "zero set"
    value: ClassVar[str] = "one zero set"
    of_one_curve: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formulas: tuple[Name, ...] = field(metadata=read(formula_names))
    measure: ZeroSetOf = field(default=ZeroSetOf.NUMERATORS, metadata=read(one_of(ZeroSetOf)))

    def validate(self) -> None:
        """Reject fewer than two formulas."""
        if len(set(self.formulas)) < 2 or len(set(self.formulas)) < len(self.formulas):
            raise ClaimError(
                "a zero set is compared with itself", where="formulas", remedy="name two formulas or more, each once"
            )

    @property
    def latex(self) -> str:
        """Zero sets that are equal."""
        return " = ".join(rf"\{{{self.symbol(name)} = 0\}}" for name in self.formulas)

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """Consecutive formulas are identical up to factors that have no zero by assumption: their values, and their
        numerators.
        """
        formulas = [self.find(name) for name in self.formulas]
        c = jets_for(formulas, dimension, polynomial=polynomial)
        zero = [name for name, f in zip(self.formulas, formulas, strict=True) if _is_zero(f(c))]
        if len(zero) == len(formulas):
            return vacuous()
        if zero:
            return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=VanishesAlways(zero[0]))
        factors = [factor_of(formulas[0], other, dimension, polynomial=polynomial) for other in formulas[1:]]
        quotients = Quotients(self.formulas[0], tuple(zip(self.formulas[1:], factors, strict=True)))
        if self.measure == ZeroSetOf.NUMERATORS and None not in factors:
            as_they_come = [
                factor_of_numerators(formulas[0], other, dimension, polynomial=polynomial) for other in formulas[1:]
            ]
            harmful_parts = [
                harmful(factor, self.assumes) for factor in (*factors, *as_they_come) if factor is not None
            ]
            if not any(bad for bad, _ in harmful_parts):
                used = tuple(dict.fromkeys(name for _, names_used in harmful_parts for name in names_used))
                return Finding(PROVED, Fact.ONE_ZERO_SET, quotients, assumptions=used)
        refuted = self.refuted_on_examples()
        if refuted.verdict == REFUTED:
            return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=refuted.witness)
        return Finding(UNDECIDED, None, quotients)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """On every segment, each numerator has no zeros after removing the other's factors."""
        values = [(name, self.find(name)(argument)) for name in self.formulas]
        if self.measure == ZeroSetOf.VALUES:
            values = [(name, _lowest(value)) for name, value in values]
        numerators = [(name, common_zeros(split(value)[0])) for name, value in values]
        if all(p.is_zero for _, p in numerators):
            return vacuous()
        first = numerators[0]
        for other in numerators[1:]:
            for (a_name, a), (b_name, b) in ((first, other), (other, first)):
                if place := extra_zero(a, b):
                    return Finding(REFUTED, Fact.DIFFERENT_ZERO_SETS, witness=VanishesAlone(a_name, place, b_name))
        return Finding(VERIFIED, Fact.ONE_ZERO_SET)


def _is_zero(value: Any) -> bool:
    return all(x.is_zero for x in split(value)[0])


def _lowest(value: Any) -> Any:
    return in_lowest_terms(value) if isinstance(value, Rational) else value
