"""The divisors in the formulas of a claim that may vanish under its assumptions.

Where a divisor vanishes, the statement does not apply, since the quotient does not exist. Formulas over the roots of a
frame are omitted: their divisors are those of the frame, and their claims make assumptions about the frame.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache
from typing import Any, cast

from flint import fmpq_mpoly

from exactspline.errors import ExactSplineError, FormulaError, ReachError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.kinds import Kind
from exactspline.language.operand import CONSTANTS
from exactspline.language.vector import Vector
from exactspline.numbers.exact import content, from_flint, mpq, sign, to_fmpq
from exactspline.polynomials.factors import Factored, Factorization, factorize
from exactspline.readings.jet import JetFraction
from exactspline.readings.printing import Operation, print_text
from exactspline.readings.tree import Node, applied, nodes, trace
from exactspline.symbolic.assumptions import assumption
from exactspline.symbolic.factorization import jets_for
from exactspline.verification.claim import Claim

# ---- denominators


class Evaluation:
    """The values of trees in the fraction reading, and the denominators that occur, each once, with its first node.

    `flat` converts a value to a fraction of the ring.
    """

    def __init__(self, argument: object, flat: Callable[[object], object] = lambda value: value) -> None:
        self.argument, self.flat = argument, flat
        self.denominators: list[tuple[Node, JetFraction | mpq]] = []
        self._known: dict[int, Any] = {}
        self._kept: list[Node] = []

    def __call__(self, node: Node) -> JetFraction | Vector[JetFraction]:
        """The value of a tree."""
        if id(node) not in self._known:
            self._kept.append(node)  # so that its id is not reused
            self._known[id(node)] = self._value(node, [self(each) for each in node.args])
        return cast("JetFraction | Vector[JetFraction]", self._known[id(node)])

    def divide_by(self, node: Node) -> None:
        """Count the value of a tree as a denominator, together with the denominators in the tree."""
        self._met(node, self(node))

    def _value(self, node: Node, values: list[Any]) -> Any:
        if node.op is Operation.NAMED:
            return values[0]
        if node.op in (Operation.DIRECTRIX, Operation.GENERATOR):
            return getattr(values[0], node.op)
        if node.op is Operation.NUMBER and mpq(node.value).denominator != 1:
            self._met(node, mpq(mpq(node.value).denominator))
        if node.op is Operation.OVER:
            self._met(node.args[1], values[1])
        return applied(node, values, self.argument)

    def _met(self, node: Node, value: Any) -> None:
        found = mpq(value) if isinstance(value, CONSTANTS) else cast(JetFraction, self.flat(value))
        if not any(type(found) is type(each) and found == each for _, each in self.denominators):
            self.denominators.append((node, found))


def factored(value: JetFraction | mpq) -> Factored[fmpq_mpoly]:
    """A denominator as a constant times powers of primitive irreducible polynomials, negative powers for its
    denominator.
    """
    if not isinstance(value, JetFraction):
        return Factored(mpq(value), Factorization())
    constant, powers = mpq(1), list[tuple[fmpq_mpoly, int]]()
    for polynomial, power in ((value.top, 1), (value.bottom, -1)):
        leading, factors = factorize(polynomial)
        constant *= from_flint(leading) ** power
        for factor, exponent in factors:
            plain = _primitive_multiple(factor)
            ratio = from_flint(factor.leading_coefficient()) / from_flint(plain.leading_coefficient())
            constant *= ratio ** (exponent * power)
            powers.append((plain, exponent * power))
    return Factored(constant, Factorization(powers))


def _primitive_multiple(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """The multiple with coprime integer coefficients, the first one positive."""
    coefficients = [from_flint(c) for c in polynomial.coeffs()]
    return polynomial * to_fmpq(sign(coefficients[0]) / content(coefficients))


#: The denominators of curves and of the operands of Table 1 of the paper: none of them has zeros.
WEIGHTS = ("w", "W", "w1", "w2")


def divisors(claim: Claim) -> tuple[str, ...]:
    """Texts of these divisors, in the order of their occurrence.

    >>> from exactspline.verification.claims import select
    >>> [divisors(claim) for claim in select(["T8", "C4.1a"])]
    [('p₂',), ('p₂', 'w₁ p₂'), ('p₂',), (), ()]
    """
    formulas = [claim.find(name) for name in claim.named]
    texts = dict.fromkeys(text for formula in formulas for n in claim.dimensions for text in _of(formula, n, claim))
    return tuple(texts)


def _of(formula: Formula, dimension: int, claim: Claim) -> Iterator[str]:
    if formula.kind.adjoins_roots or dimension not in formula.kind.dimensions:
        return
    argument, denominators = _denominators(formula, dimension)
    known = list(_known(claim, formula.kind, argument))
    for node, factors in denominators:
        if factors is None or not all(_divides(p, known) for p in factors):
            known += factors or []
            yield print_text(node)


@cache
def _denominators(formula: Formula, dimension: int) -> tuple[Evaluated, list[tuple[Node, list[fmpq_mpoly] | None]]]:
    """The divisors of a formula, each with its irreducible factors in the ring of the argument; None if the formula is
    too large to be multiplied out.
    """
    argument, below = jets_for([formula], dimension), list(divided_by(trace(formula, dimension)))
    evaluation = Evaluation(argument)
    try:
        for node in reversed(below):
            evaluation.divide_by(node)
    except (FormulaError, ReachError):
        return argument, [(node, None) for node in below]
    return argument, [(node, factored(value).bases) for node, value in evaluation.denominators]


def divided_by(tree: Node) -> Iterator[Node]:
    """The divisors in a tree, except numbers."""
    for node in nodes(tree):
        if node.op is Operation.OVER and node.args[1].op is not Operation.NUMBER:
            yield node.args[1]


def _known(claim: Claim, kind: Kind, argument: Evaluated) -> Iterator[fmpq_mpoly]:
    """The polynomials that do not vanish: the weights and those in the assumptions."""
    for each in argument.together():
        operands = each.operands()
        for name in WEIGHTS if {"x", "p1"} & operands.keys() else ():  # where w is a denominator, not any function
            if isinstance(value := operands.get(name), JetFraction):
                yield value.top
    for assumed in [own for each in claim.assumes for own in (each, *map(assumption, each.implies))]:
        # a polynomial with more derivatives than the formula cannot be a divisor
        with suppress(ExactSplineError):
            if assumed.applies_to(kind):
                yield assumed.polynomial(argument).top


def _divides(polynomial: fmpq_mpoly, known: list[fmpq_mpoly]) -> bool:
    return any(not divmod(each, polynomial)[1] for each in known)
