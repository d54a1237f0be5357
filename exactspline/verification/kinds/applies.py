"""Claims that a formula applies to a kind of argument, as implied by the citation of an equation."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.language.kinds import kind_of
from exactspline.verification.claim import Claim, any_formula, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation, Handed
from exactspline.verification.evidence import Fact, SpeaksOf, SpeaksOfAnother
from exactspline.verification.verdict import PROVED, REFUTED, Finding
from exactspline.verification.vocabulary import Name


@claim_kind
class Applies(Claim):
    """The equation of ``formula`` applies to such arguments, so that it can be evaluated where it is cited for them. A
    determinant of two vectors, for example, requires vectors in the plane.
    """

    kind: ClassVar[str] = "applies"
    value: ClassVar[str] = "it applies"
    notation: ClassVar[str] = r"$formula \;\text{exists for arguments of the kind $curve}"
    of_frames: ClassVar[bool] = True

    formula: str = field(metadata=read(any_formula))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """Decided by the operands that the formula needs, and the dimension in which its products are defined."""
        own, asked = self.find(self.formula).kind, kind_of(self.curve)
        if asked.takes(own, dimension):
            return Finding(PROVED, Fact.APPLIES)
        witness = SpeaksOfAnother(Name(self.formula), Name(own.name), Name(asked.name))
        return Finding(REFUTED, SpeaksOf(Name(own.name)), witness=witness)

    def examine(self, argument: Handed, own: Evaluation) -> Finding:
        """The same for every curve."""
        return self.prove()[1]
