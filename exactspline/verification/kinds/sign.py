"""Claims of signs: for all curves by a sum of squares, on one curve by Bernstein coefficients."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.parts import split
from exactspline.numbers.exact import mpq
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.isolation import is_nonnegative
from exactspline.readings.jet import Jet
from exactspline.splines.bspline import BSpline
from exactspline.symbolic.assumptions import zero_free
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim, formula_name, formula_names, one_of, read
from exactspline.verification.claim_factor import factor_formulas, factor_parts
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import extra_zero
from exactspline.verification.decision import SquaresAddUp
from exactspline.verification.evaluation import Evaluation, Handed, zero_of
from exactspline.verification.evidence import At, Fact, HasSign, ZeroAt
from exactspline.verification.kinds.identity import checked_factor
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import Name, Sign


def positive_factor(claim: Claim, name: str, value: str) -> str:
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
    factor: str = field(default="1", metadata=read(positive_factor))

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

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """Segment by segment: there is no root at which the sign changes, and one value has that sign."""
        (p, *others), below = split(self.find(self.formula)(argument))
        if others:
            raise ClaimError(f"{self.formula!r} is a vector", where=self.key, remedy="a vector has no sign")
        value = p * self.sign.direction
        value = value if below is None else value * below
        if p.is_zero:
            return vacuous(Fact.VANISHES)
        for i, c in enumerate(value.polynomials):
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
    """A parameter at which a spline is negative, on a segment on which it has negative values."""
    a, b = f.breakpoints[i : i + 2]
    n = f.degree + 2
    while True:
        for k in range(1, n):
            t: mpq = a + (b - a) * mpq(k, n)
            if f(t) < 0:
                return t
        n *= 2
