"""Evidence for claims about types: polynomial, rational, or neither; and about the arguments of an equation."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.verification.evidence.general import Evidence
from exactspline.verification.vocabulary import Name, ValueType


@dataclass(frozen=True)
class OfType(Evidence):
    """The type of a value."""

    type: ValueType


@dataclass(frozen=True)
class TypeOnExample(Evidence):
    """The type on an example curve, or on cubic polynomials where the name is empty; `rational_everywhere` where the
    value is a quotient of polynomials on every curve.
    """

    type: ValueType
    curve: Name
    rational_everywhere: bool


@dataclass(frozen=True)
class TypeHere(Evidence):
    """The type on the given curve; `special` where it is more special than on the generic curve."""

    type: ValueType
    special: bool = False


@dataclass(frozen=True)
class SpeaksOf(Evidence):
    """The kind of argument of a formula."""

    kind: Name


@dataclass(frozen=True)
class SpeaksOfAnother(Evidence):
    """A formula, the kind of its argument, and the requested kind."""

    formula: Name
    kind: Name
    asked: Name
