"""The generic reading: one Bézier segment of a given degree whose control points and weights are indeterminates.

The Bézier coefficients of the value of a formula are polynomials in these indeterminates; a coefficient that is not the
zero polynomial vanishes only on special curves.
"""

from __future__ import annotations

from math import comb

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from exactspline.errors import FormulaError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Reading, freely_differentiable
from exactspline.language.kinds import Kind
from exactspline.language.operand import Constant
from exactspline.language.rational import RingOperand
from exactspline.numbers.exact import rational, to_fmpq


class Generic(RingOperand):
    """Scaled Bernstein coefficients ``c_i = C(n, i) b_i``, n+1 of them."""

    __slots__ = ("coefficients", "context")
    provenance = 0

    def __init__(self, context: fmpq_mpoly_ctx, coefficients: list[fmpq_mpoly]) -> None:
        self.context, self.coefficients = context, coefficients

    @property
    def degree(self) -> int:
        """The formal degree."""
        return len(self.coefficients) - 1

    @property
    def is_zero(self) -> bool:
        """Whether the value vanishes on every curve of this degree."""
        return not any(self.coefficients)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Generic) and self.coefficients == other.coefficients

    __hash__ = None  # type: ignore[assignment]  # not hashable

    def constant(self, value: Constant) -> Generic:
        """A constant of degree 0."""
        return Generic(self.context, [self.context.constant(to_fmpq(rational(value)))])

    def elevated_to(self, other: Generic) -> Generic:
        """The same function, elevated to at least the degree of `other`."""
        by = other.degree - self.degree
        return (
            self
            if by <= 0
            else self * Generic(self.context, [self.context.constant(comb(by, i)) for i in range(by + 1)])
        )

    def _plus(self, right: Generic) -> Generic:
        a, b = self.elevated_to(right), right.elevated_to(self)
        return Generic(self.context, [x + y for x, y in zip(a.coefficients, b.coefficients, strict=True)])

    def _times(self, right: Generic) -> Generic:
        zero = self.context.constant(0)
        product = [zero] * (self.degree + right.degree + 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(right.coefficients):
                product[i + j] += x * y
        return Generic(self.context, product)

    def scaled(self, constant: Constant) -> Generic:
        """The form times an exact constant."""
        q = to_fmpq(rational(constant))
        return Generic(self.context, [q * x for x in self.coefficients])

    def _first_derivative(self, by: str | None) -> Generic:
        """The derivative with respect to the parameter of the segment."""
        self.only_parameter(by)
        c, n = self.coefficients, self.degree
        return Generic(self.context, [(i + 1) * c[i + 1] - (n - i) * c[i] for i in range(n)])


class GenericReading(Reading):
    """One Bézier segment of a given degree, whose control points and weights are indeterminates.

    >>> from exactspline.language.kinds import CURVE
    >>> c = GenericReading(2).argument(CURVE, 2)
    >>> len(c.w.d(1).coefficients), c.w.d(3).is_zero
    (2, True)
    """

    name = "generic"

    def __init__(self, degree: int) -> None:
        self.degree = degree

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """The argument as functions of the only parameter.

        Raises `FormulaError` for a kind with several parameters, or with constants.
        """
        symbols = freely_differentiable(kind, self, dimension, polynomial=polynomial)
        if len({parameter for symbol in symbols for parameter in symbol.parameters}) > 1:
            raise FormulaError(
                f"a generic segment of {kind!r}", remedy="this reading applies to functions of one parameter"
            )
        names = [f"{symbol.name}_{i}" for symbol in symbols for i in range(self.degree + 1)]
        context = fmpq_mpoly_ctx.get(names, Ordering.degrevlex)
        gens, size = context.gens(), self.degree + 1
        functions = {
            symbol.name: Generic(context, [comb(self.degree, i) * gens[k * size + i] for i in range(size)])
            for k, symbol in enumerate(symbols)
        }
        one = Generic(context, [context.constant(1)])
        return kind.argument(dimension, lambda symbol: functions[symbol.name], one, polynomial=polynomial)
