"""Claims that a formula is identically another one, or zero."""

from __future__ import annotations

from dataclasses import field
from typing import Any, ClassVar

from exactspline.errors import ClaimError
from exactspline.language.argument import Evaluated
from exactspline.language.kinds import kind_of
from exactspline.language.parts import split
from exactspline.readings.jet import Jet, polynomial_text
from exactspline.readings.rational_jet import JetFraction
from exactspline.symbolic.factorization import jets_for, jets_with_roots
from exactspline.verification.claim import Claim, formula_name, read
from exactspline.verification.claim_factor import WEIGHTS, factor_of_text, factor_parts
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.curve_check import printed_factor, where_it_differs
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.notation import factor_latex
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED, Finding, vacuous
from exactspline.verification.vocabulary import ArgumentKind


def stated_factor(claim: Claim, name: str, value: str) -> str:
    """A factor whose names are formulas that apply to the arguments of the claim."""
    for part, _ in factor_parts(value):
        if part in WEIGHTS and claim.curve == ArgumentKind.TABLE:
            raise ClaimError("Table 1 has no denominator w", where=name, remedy="write it into the formulas")
        if part == "W" and not claim.of_pair:
            raise ClaimError("the factor speaks of a second curve", where=name, remedy='the denominator is "w"')
        if part[0].isalpha() and part not in WEIGHTS:
            formula_name(claim, name, part)
    return str(value)


@claim_kind
class Identity(Claim):
    """``left = factor · right``."""

    kind: ClassVar[str] = "identity"
    of_frames: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))
    right: str = field(metadata=read(formula_name))
    factor: str = field(default="1", metadata=read(stated_factor))

    def validate(self) -> None:
        """Refuse a formula compared with itself."""
        if self.left == self.right:
            raise ClaimError("both sides are one formula", where="right", remedy="name another one")

    @property
    def claims(self) -> str:
        """The factor."""
        return self.factor

    @property
    def latex(self) -> str:
        """Left side, factor, right side."""
        return f"{self.symbol(self.left)} = {factor_latex(self.factor, self.find)}{self.symbol(self.right)}"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left = factor · right`` as differential polynomials."""
        left, right = self.find(self.left), self.find(self.right)
        if kind_of(self.curve).adjoins_roots:
            return self._over_roots(dimension, polynomial)
        c = jets_for((left, right), dimension, polynomial=polynomial)
        if all(x.is_zero for side in (left, right) for x in split(side(c))[0]):
            return vacuous(self.factor)
        if all(x.is_zero for x in split(right(c))[0]):
            return Finding(REFUTED, self.factor, "not proportional", "", "the right side vanishes, the left does not")
        factor = factor_of(left, right, dimension, polynomial=polynomial)
        if factor is None:
            witness = self.refuted_on_examples().witness or "the jet polynomials are not proportional"
            return Finding(REFUTED, self.factor, "not proportional", "", witness)
        order = jets_for((left, right, *self._factors()), dimension, polynomial=polynomial)
        top: Any
        bottom: Any
        top, bottom = factor_of_text(self.factor, order, self.find)
        if bottom.is_zero:
            return Finding(REFUTED, self.factor, str(factor), str(factor), "the factor is divided by zero")
        if top.is_zero and all(x.is_zero for x in split(left(c))[0]):
            return vacuous(self.factor)
        stated, found = top / bottom, factor.fraction()
        if self._same(stated, found):
            return Finding(PROVED, self.factor, str(factor), str(factor))
        return Finding(REFUTED, self.factor, str(factor), str(factor), f"the exact quotient is {factor}")

    def _over_roots(self, dimension: int, polynomial: bool) -> Finding:
        """The same where a quotient is not a product of polynomials: component by component."""
        left, right = self.find(self.left), self.find(self.right)
        formulas = (left, right, *self._factors())
        c = jets_with_roots(formulas, self.factor, dimension, polynomial=polynomial)
        ps, qs = split(left(c))[0], split(right(c))[0]
        top, bottom = factor_of_text(self.factor, c, self.find)
        if all(x.is_zero for x in ps) and (top.is_zero or all(x.is_zero for x in qs)):
            return vacuous(self.factor)
        if bottom.is_zero:
            return Finding(REFUTED, self.factor, "1/0", "", "the factor is divided by zero")
        if len(ps) != len(qs):
            return Finding(REFUTED, self.factor, f"{len(ps)} components, and {len(qs)}")
        for i, (p, q) in enumerate(zip(ps, qs, strict=True)):
            if not (p * bottom - q * top).is_zero:
                return Finding(REFUTED, self.factor, "not identical", "", f"component {i + 1} differs")
        return Finding(PROVED, self.factor, self.factor, self.factor)

    def _factors(self) -> list[Any]:
        return [self.find(name) for name, _ in factor_parts(self.factor) if name[0].isalpha() and name not in WEIGHTS]

    def _same(self, stated: Any, found: tuple[Any, Any]) -> bool:
        ring = stated.ring
        top, bottom = (_over(ring, part) for part in found)
        return bool(stated == JetFraction(ring, top, bottom))

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """``left · (denominators) = factor · right · (denominators)``, multiplied out on the spline."""
        (ps, k), (qs, m) = (split(self.find(name)(argument)) for name in (self.left, self.right))
        assert isinstance(argument, Evaluated)  # operands of Table 1 have no factors
        if len(ps) != len(qs):
            return Finding(
                REFUTED, self.factor, f"{len(ps)} components, and {len(qs)}", witness="not as many components"
            )
        top: Any
        bottom: Any
        top, bottom = factor_of_text(self.factor, argument, self.find)
        factor = printed_factor(self.factor, argument)
        if all(x.is_zero for x in ps) and (top.is_zero or all(x.is_zero for x in qs)):
            return vacuous(self.factor, factor=factor)
        if not all(_numerator(bottom).polynomials) or not all(_denominator(top, bottom)):
            return vacuous(self.factor, "the factor does not exist on all of this curve: 1/0", factor)
        ((right,), a), ((left,), b) = split(top), split(bottom)
        left = left if a is None else left * a
        right = right if b is None else right * b
        left = left if m is None else left * m
        right = right if k is None else right * k
        for p, q in zip(ps, qs, strict=True):
            difference = p * left - q * right
            if not difference.is_zero:
                return Finding(
                    REFUTED, self.factor, "not identical", factor, f"the sides differ {where_it_differs(difference)}"
                )
        return Finding(VERIFIED, self.factor, factor, factor)


def _numerator(value: Any) -> Any:
    return split(value)[0][0]


def _denominator(*values: Any) -> list[Any]:
    return [p for value in values if (below := split(value)[1]) is not None for p in below.polynomials]


def _over(ring: Any, polynomial: Any) -> Any:
    """A polynomial of a ring with fewer derivatives, in this one."""
    if polynomial.context() is ring.context:
        return polynomial
    names, own = list(polynomial.context().names()), list(ring.context.names())
    place = [own.index(name) for name in names]
    terms = {}
    for exponents, c in polynomial.terms():
        raised = [0] * len(own)
        for i, e in zip(place, exponents, strict=True):
            raised[i] = int(e)
        terms[tuple(raised)] = c
    return ring.context.from_dict(terms)


@claim_kind
class Vanishing(Claim):
    """``left`` is identically zero."""

    kind: ClassVar[str] = "vanishing"
    of_frames: ClassVar[bool] = True

    left: str = field(metadata=read(formula_name))

    @property
    def claims(self) -> str:
        """Zero."""
        return "0"

    @property
    def latex(self) -> str:
        """The formula is zero."""
        return rf"{self.symbol(self.left)} \equiv 0"

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """``left`` is the zero polynomial."""
        formula = self.find(self.left)
        roots = kind_of(self.curve).adjoins_roots
        jets = jets_with_roots((formula,), "1", dimension, polynomial=polynomial) if roots else None
        components = split(formula(jets or jets_for((formula,), dimension, polynomial=polynomial)))[0]
        rest = next((c for c in components if not c.is_zero), None)
        if rest is None:
            return Finding(PROVED, "0", "0")
        if roots:
            return Finding(REFUTED, "0", "not zero", witness=f"component {components.index(rest) + 1} is not zero")
        witness = self.refuted_on_examples().witness or "the jet polynomial is not zero"
        return Finding(REFUTED, "0", polynomial_text(Jet(rest.ring, rest.top), 3), witness=witness)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """All components are the zero spline."""
        for p in split(self.find(self.left)(argument))[0]:
            if not p.is_zero:
                return Finding(REFUTED, "0", "not zero", witness=f"it differs from 0 {where_it_differs(p)}")
        return Finding(VERIFIED, "0", "0")
