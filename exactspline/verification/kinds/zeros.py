"""Claims about zeros and signs: that formulas have one zero set, that a value has a sign, that two formulas are squares
on the same curves.
"""

from __future__ import annotations

from dataclasses import field
from itertools import pairwise
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.arguments import Evaluated
from exactspline.language.parts import split
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq
from exactspline.polynomials.bernstein import is_square_class
from exactspline.polynomials.common_arcs import rational_between
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.isolation import is_nonnegative, isolate
from exactspline.polynomials.zero_places import Place, at
from exactspline.readings.jet import Jet
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import in_lowest_terms
from exactspline.symbolic.assumptions import zero_free
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim, formula_name, formula_names, one_of, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import common_zeros, extra_zero
from exactspline.verification.decision import SquaresAddUp
from exactspline.verification.evaluation import Evaluation, zero_of
from exactspline.verification.evidence import (
    At,
    Fact,
    HasSign,
    OddPowers,
    Quotients,
    SquareOnSegment,
    Squares,
    VanishesAlone,
    VanishesAlways,
    ZeroAt,
)
from exactspline.verification.generic_proof import factor_of, factor_of_numerators, harmful
from exactspline.verification.kinds.equality import checked_factor
from exactspline.verification.notation import factor_formulas, factor_parts
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Name, Sign, ZeroSetOf


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

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
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


def _positive_factor(claim: Claim, name: str, value: str) -> str:
    """A factor that is positive on every curve: a positive number, and even powers."""
    for part, exponent in factor_parts(value):
        if part[0] == "-" or (part[0].isalpha() and exponent % 2):
            raise ClaimError(f"the factor {value!r} has no sign", where=part, remedy="positive numbers and even powers")
    return checked_factor(claim, name, value)


@claim_kind
class SignClaim(Claim):
    """The value of ``formula`` has a ``sign`` wherever it exists: on all curves because, up to that sign, it is
    ``factor`` times the sum of the ``squares`` (for a vector, its squared length).
    """

    kind: ClassVar[str] = "sign"
    value: ClassVar[str] = "$sign"
    of_one_curve: ClassVar[bool] = True
    asks_for_zeros: ClassVar[bool] = True

    formula: Name = field(metadata=read(formula_name))
    sign: Sign = field(default=Sign.NONNEGATIVE, metadata=read(one_of(Sign)))
    squares: tuple[Name, ...] = field(default=(), metadata=read(formula_names))
    factor: str = field(default="1", metadata=read(_positive_factor))

    def validate(self) -> None:
        """Reject a factor without squares."""
        if self.factor != "1" and not self.squares:
            raise ClaimError("a factor of no squares", where="factor", remedy="name the squares")

    @property
    def latex(self) -> str:
        """The formula and its sign."""
        sign = self.claims.replace("≥", r"\ge").replace("≤", r"\le")
        return f"{self.symbol(self.formula)} {sign}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The sum of squares is the value up to the factor, as differential polynomials."""
        formula, squares = self.find(self.formula), tuple(map(self.find, self.squares))
        named = factor_formulas(self.factor, self.find)
        c: Any = jets_for((formula, *squares, *named), dimension, polynomial=polynomial)
        value = formula(c)
        if value.is_vector:
            raise ClaimError(f"{self.formula!r} is a vector", where=self.key, remedy="a vector has no sign")
        if value.is_zero:
            return vacuous()
        if squares:
            finding = SquaresAddUp(formula, squares, self.factor, self.sign.direction, self.find).decide(c)
            if finding.verdict == PROVED:
                return self._strict([square(c) for square in squares]) if self.sign.strict else finding
        refuted = self.refuted_on_examples()
        reason = Fact.OTHER_SQUARES if squares else Fact.NO_SQUARES
        return refuted if refuted.verdict == REFUTED else Finding(UNDECIDED, witness=reason)

    def _strict(self, squares: list[Any]) -> Finding:
        """One of the squares has no zeros by assumption: neither it nor a factor."""
        constant = not any(name[0].isalpha() for name, _ in factor_parts(self.factor))
        for value in squares:
            used = _zero_free(value, self.assumes)
            if used is not None and constant:
                return Finding(PROVED, Fact.SQUARES_ONE_WITHOUT_ZERO, assumptions=used)
        refuted = self.refuted_on_examples()
        return refuted if refuted.verdict == REFUTED else Finding(UNDECIDED, witness=Fact.SQUARES_MAY_VANISH)

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """Segment by segment: there is no root at which the sign changes, and one value has that sign."""
        (p, *others), below = split(self.find(self.formula)(argument))
        if others:
            raise ClaimError(f"{self.formula!r} is a vector", where=self.key, remedy="a vector has no sign")
        value = p * self.sign.direction
        value = value if below is None else value * below
        if p.is_zero:
            return vacuous(Fact.ZERO)
        for i, c in enumerate(value.numerators):
            if not is_nonnegative(c, value.degree):
                return Finding(REFUTED, Fact.OTHER_SIGN, witness=At(_negative(value, i)))
        zero = zero_of(p) if below is None else extra_zero(p, below)  # 0/0 is not a value
        if self.sign.strict and zero:
            return Finding(REFUTED, Fact.HAS_ZERO, witness=ZeroAt(zero))
        return Finding(VERIFIED, HasSign(self.sign))


def _zero_free(value: Any, assumed: Any) -> tuple[Name, ...] | None:
    """The assumptions that imply that a value (for a vector, its squared length) has no zeros; None where
    they do not.
    """
    parts = split(value)[0]
    square = parts[0] * parts[0]
    for x in parts[1:]:
        square = square + x * x
    if square.is_zero:
        return None
    used = []
    for p in factorize(square.top).bases:
        reason = zero_free(Jet(square.ring, p), assumed)
        if reason is None:
            return None
        used.append(Name(reason.name))
    return tuple(dict.fromkeys(used))


def _negative(f: BSpline, i: int) -> mpq:
    """A parameter at which a spline is negative, on a segment on which it has negative values: in the middle between
    zeros, or an end of the segment and a zero.
    """
    a, b = f.breakpoints[i : i + 2]
    places = [at(mpq(0)), *map(Place, isolate(f.numerators[i], f.degree).inner), at(mpq(1))]
    inside = (a + (b - a) * rational_between(*pair) for pair in pairwise(places))
    return next(t for t in inside if f(t) < 0)


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
        if any(self.only_component(f.name, split(f(c))[0]).is_zero for f in (formula, right)):
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

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """On every segment both are squares up to a constant, or neither is; a segment where one is 0 is skipped."""
        (n, m), (p, q) = [
            (self.only_component(name, numerators), w)
            for name in (self.formula, self.right)
            for numerators, w in [split(self.find(name)(argument))]
        ]
        left, right = (n if m is None else n * m), (p if q is None else p * q)
        pairs = {
            i: (is_square_class(a, left.degree), is_square_class(b, right.degree))
            for i, (a, b) in enumerate(zip(left.numerators, right.numerators, strict=True))
            if a and b
        }
        if not pairs:
            return vacuous()
        for i, (a, b) in pairs.items():
            if a != b:
                return Finding(REFUTED, Fact.DIFFERENT, witness=SquareOnSegment(i))
        squares, whole = sum(b for _, b in pairs.values()), len(left.numerators)
        return Finding(VERIFIED, Squares(self.right, squares, whole, whole - len(pairs)))
