"""The denominators of formulas, and the polynomials that do not vanish of which they are products."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import gcd, lcm
from typing import Any, cast

from flint import fmpq_mpoly

from exactspline.language.operand import CONSTANTS
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.polynomials.factors import factorize
from exactspline.readings.expression import Operation
from exactspline.readings.rational_jet import JetFraction
from exactspline.readings.tree import Node, applied


class Evaluation:
    """The values of trees in the fraction reading, and the denominators met, each once, with the first node.

    `flat` makes a fraction of the ring of a value.
    """

    def __init__(self, argument: object, flat: Callable[[object], object] = lambda value: value) -> None:
        self.argument, self.flat = argument, flat
        self.denominators: list[tuple[Node, JetFraction | mpq]] = []
        self._known: dict[int, Any] = {}
        self._kept: list[Node] = []

    def __call__(self, node: Node) -> JetFraction | Vector[JetFraction]:
        """The value of a tree."""
        if id(node) not in self._known:
            self._kept.append(node)  # so that its id stays its own
            self._known[id(node)] = self._value(node, [self(each) for each in node.args])
        known: JetFraction | Vector[JetFraction] = self._known[id(node)]
        return known

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


@dataclass(frozen=True)
class Factored:
    """A constant times powers of primitive irreducible polynomials; negative exponents are those of the bottom."""

    constant: mpq
    powers: tuple[tuple[fmpq_mpoly, int], ...]


def factored(value: JetFraction | mpq) -> Factored:
    """A denominator in factors."""
    if not isinstance(value, JetFraction):
        return Factored(mpq(value), ())
    constant, powers = mpq(1), list[tuple[fmpq_mpoly, int]]()
    for polynomial, sign in ((value.top, 1), (value.bottom, -1)):
        content, factors = factorize(polynomial)
        constant *= _rational(content) ** sign
        for factor, exponent in factors:
            plain = primitive(factor)
            ratio = _rational(factor.leading_coefficient()) / _rational(plain.leading_coefficient())
            constant *= ratio ** (int(exponent) * sign)
            powers.append((plain, int(exponent) * sign))
    return Factored(constant, tuple(powers))


def primitive(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """The multiple with coprime integer coefficients, the first one positive."""
    coefficients = [_rational(c) for c in polynomial.coeffs()]
    content = mpq(0)
    for c in coefficients:
        content = _gcd(content, abs(c))
    multiple: fmpq_mpoly = polynomial * to_fmpq(1 / content * (1 if coefficients[0] > 0 else -1))
    return multiple


def primes(number: int) -> dict[int, int]:
    """The prime factors of a positive number."""
    found, p = dict[int, int](), 2
    while number > 1:
        while number % p == 0:
            found[p] = found.get(p, 0) + 1
            number //= p
        p += 1
    return found


def _rational(value: Any) -> mpq:
    return mpq(int(value.p), int(value.q))


def _gcd(a: mpq, b: mpq) -> mpq:
    return mpq(gcd(int(a.numerator), int(b.numerator)), lcm(int(a.denominator), int(b.denominator)))
