"""The readings that compile programs: operands are loaded, operations become instructions; at their true degree
Wronskians are determinants of partial derivatives.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial, prod
from typing import NamedTuple, Self

from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Reading
from exactspline.language.kinds import Kind
from exactspline.language.provenance import leaf
from exactspline.language.vector import Vector, det
from exactspline.language.wronskians import OwnWronskians, logarithmic_sum
from exactspline.programs.denominators import Denominator
from exactspline.programs.term import Recorder, Term


class _TermAtTrueDegree(Term, OwnWronskians):
    """A term whose Wronskians and logarithmic derivatives have their true degree.

    For forms of degree n in u and v, with ``A = u ∂u + v ∂v`` and ``B = ∂v − ∂u`` (the derivative, where u + v = 1),
    Euler's relation gives ``A^(r−i) Bⁱ f = (n−i)(n−i−1)…(n−r+1) f⁽ⁱ⁾``; the matrix that maps the r-th partial
    derivatives to these has a power of u + v as its determinant, which is 1. So the Wronskian is the determinant of the
    r-th partial derivatives divided by a constant: of degree (r+1)(n−r), which is ``kd − 2m``, without any polynomial
    division.

    If ``F = Π fᵉ`` is homogeneous of degree 0, ``u ∂u + v ∂v`` maps F to zero. Hence, for ``u + v = 1``, the derivative
    ``∂v − ∂u`` of F is ``∂v/u``, and the numerator of F′/F has its true degree, too.

    >>> from exactspline.papers import find
    >>> from exactspline.programs.program import operands_of
    >>> from exactspline.programs.program import program_of
    >>> from exactspline.interchange.examples import example
    >>> lifted, curve = find("critical_curvature_lifted"), example("rational_cubic")
    >>> read = [operands_of(lifted.kind, curve, true_degree=true_degree) for true_degree in (False, True)]
    >>> [program_of(lifted, given.signature).on(given).degree for given in read]
    [18, 12]
    """

    __slots__ = ()

    def wronskian(self, functions: Sequence[Self]) -> Self:
        """The determinant of partial derivatives; ``W(1, f, …) = W(f′, …)``."""
        number = next((k for k, f in enumerate(functions) if f.is_number), None)
        if number is not None:
            rest = [f.d(1) for k, f in enumerate(functions) if k != number]
            value = functions[number].value * (-1) ** number
            return (rest[0].wronskian(rest) if rest else self.constant(1)).scaled(value)
        r, n = len(functions) - 1, max(f.degree for f in functions)
        if not r:
            return functions[0]
        if n < r:
            return self.constant(0)
        columns = [f.partials(n, r) for f in functions]
        value_: Self = det(*[Vector(*[column[i] for column in columns]) for i in range(r + 1)])
        constant = prod(factorial(n - i) // factorial(n - r) for i in range(r))
        return value_.per_width(r * (r + 1) // 2, r).over(Denominator(constant))

    def logarithmic_numerator(self, powers: Sequence[tuple[Self, int]]) -> Self:
        """The numerator by ``∂v/u`` where the product is homogeneous of degree 0."""
        numbers, functions = [f.value for f, _ in powers if f.is_number], [p for p in powers if not p[0].is_number]
        if not functions or 0 in numbers:
            return self.constant(0)
        homogeneous = sum(f.degree * e for f, e in functions) == 0
        found: Self = logarithmic_sum([(f, f.by_v() if homogeneous else f.d(1), e) for f, e in functions])
        found = found.over_u().per_width(1, 1) if homogeneous else found
        return found.scaled(prod(numbers))


class Signature(NamedTuple):
    """The properties on which a program depends in addition to its formula: those of the argument except its numbers.

    `degrees` are those of the operands, each in its own parameter; `groups` identify those with the same denominators
    on all segments; `true_degree` whether formulas are read at their true degree (see
    `exactspline.programs.reading`).
    """

    kind: Kind
    dimension: int
    polynomial: bool
    degrees: tuple[int, ...]
    groups: tuple[int, ...]
    unit_widths: bool
    true_degree: bool = False

    @property
    def parameters(self) -> tuple[str, ...]:
        """The parameter of every operand; constants are counted with the first."""
        first, *_ = self.kind.parameters(self.dimension)
        symbols = self.kind.symbols(self.dimension, polynomial=self.polynomial)
        return tuple([next(iter(symbol.parameters), first) for symbol in symbols])


class ProgramReading(Reading):
    """The reading that records the computation on arguments with a signature."""

    name = "program"
    proves = "nothing: it records the work to be done"

    def __init__(self, signature: Signature) -> None:
        self.signature = signature
        self.recorder = Recorder(signature.parameters, unit_widths=signature.unit_widths)
        #: The provenances of the operands in programs.
        self.leaves = tuple([leaf() for _ in signature.degrees])

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """Every operand loaded by its number."""
        symbols = kind.symbols(dimension, polynomial=polynomial)
        operand: type[Term] = _TermAtTrueDegree if self.signature.true_degree else Term
        given = zip(symbols, self.signature.degrees, self.signature.groups, self.leaves, strict=True)
        terms = {
            symbol.name: operand.operand(self.recorder, k, degree, group, own)
            for k, (symbol, degree, group, own) in enumerate(given)
        }
        one = terms[symbols[0].name].constant(1)
        return kind.argument(dimension, lambda symbol: terms[symbol.name], one, polynomial=polynomial)

    def of_signature(self) -> Evaluated:
        """The argument of the signature's kind."""
        signature = self.signature
        return self.argument(signature.kind, signature.dimension, polynomial=signature.polynomial)
