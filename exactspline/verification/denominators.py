"""The denominators of formulas, and the nonvanishing polynomials of which they are products."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

from flint import fmpq_mpoly

from exactspline.language.operand import CONSTANTS
from exactspline.language.vector import Vector
from exactspline.numbers.exact import content, from_flint, mpq, sign, to_fmpq
from exactspline.polynomials.factors import Factored, Factorization, factorize
from exactspline.readings.jet import JetFraction
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node, applied


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
        known: JetFraction | Vector[JetFraction] = self._known[id(node)]
        return known

    def divide_by(self, node: Node) -> None:
        """Count the value of a tree, and the denominators in it, as denominators."""
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
    multiple: fmpq_mpoly = polynomial * to_fmpq(sign(coefficients[0]) / content(coefficients))
    return multiple
