"""The reading that compiles programs: operands are loaded, operations become instructions."""

from __future__ import annotations

from typing import NamedTuple

from exactspline.language.argument import Evaluated
from exactspline.language.kinds import Kind
from exactspline.language.provenance import leaf
from exactspline.language.reading import Reading
from exactspline.programs.term import Recorder, Term
from exactspline.programs.wronskian import TermAtTrueDegree


class Signature(NamedTuple):
    """What a program depends on in addition to its formula: everything about the argument except its numbers.

    `degrees` are those of the operands, each in its own parameter; `groups` identify those with the same denominators
    on all segments; `true_degree` whether formulas are read at their true degree (see
    `exactspline.programs.wronskian`).
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
    """A record of the computation on arguments with a signature."""

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
        operand: type[Term] = TermAtTrueDegree if self.signature.true_degree else Term
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
