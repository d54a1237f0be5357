"""Claims that two formulas are squares, up to constants, on the same curves."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.language.parts import split
from exactspline.polynomials.bernstein import is_square_class
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.components import only_component
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import Fact, OddPowers, Quotients, SquareOnSegment, Squares
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Name


@claim_kind
class SquareClass(Claim):
    """On every curve ``formula`` is a square up to constants exactly where ``right`` is."""

    kind: ClassVar[str] = "square class"
    value: ClassVar[str] = "a square"
    notation: ClassVar[str] = r"$formula \,/\, $right \;\text{is a square up to a constant}"
    sides: ClassVar[tuple[str, ...]] = ("formula", "right")
    of_one_curve: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formula: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The quotient of the two is a square times a constant: every irreducible factor occurs an even number of
        times. The product of a square up to constants and such a quotient is again a square up to constants.
        """
        formula, right = self.find(self.formula), self.find(self.right)
        c = jets_for((formula, right), dimension, polynomial=polynomial)
        if any(only_component(self, f.name, split(f(c))[0]).is_zero for f in (formula, right)):
            return vacuous()
        factor = factor_of(formula, right, dimension, polynomial=polynomial)
        odd = () if factor is None else tuple(Name(base.name) for base, e in factor.powers if e % 2)
        quotient = Quotients(self.formula, ((self.right, factor),))
        if factor is not None and not odd:
            return Finding(PROVED, Fact.SQUARE, quotient)
        difference = Fact.NOT_PROPORTIONAL if factor is None else OddPowers(odd)
        refuted = self.refuted_on_examples()
        verdict = REFUTED if refuted.verdict == REFUTED else UNDECIDED
        return Finding(verdict, difference, quotient, refuted.witness or difference)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """On every segment both are squares up to a constant, or neither is; a segment where one is 0 is skipped."""
        (n, m), (p, q) = [
            (only_component(self, name, numerators), w)
            for name in (self.formula, self.right)
            for numerators, w in [split(self.find(name)(argument))]
        ]
        left, right = (n if m is None else n * m), (p if q is None else p * q)
        pairs = {
            i: (is_square_class(a, left.degree), is_square_class(b, right.degree))
            for i, (a, b) in enumerate(zip(left.polynomials, right.polynomials, strict=True))
            if a and b
        }
        if not pairs:
            return vacuous()
        for i, (a, b) in pairs.items():
            if a != b:
                return Finding(REFUTED, Fact.DIFFERENT, witness=SquareOnSegment(i))
        squares, whole = sum(b for _, b in pairs.values()), len(left.polynomials)
        return Finding(VERIFIED, Squares(self.right, squares, whole, whole - len(pairs)))
