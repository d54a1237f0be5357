"""Statements that are not decided: no kind of claims expresses them, or their entry was refused."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.language.arguments import Evaluated
from exactspline.verification.claim import Claim, claim_kind, one_of, read
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import Stopped
from exactspline.verification.verdict import NOT_ASKED, Finding
from exactspline.verification.vocabulary import Name, Verdict


@claim_kind
class NotAsked(Claim):
    """A statement that is listed and not decided, for the reason ``why``. An author writes such an entry if no kind of
    claims expresses the statement (an implication, an integral). A refused entry of a user's folder becomes one, too,
    so that the other claims are decided.
    """

    kind: ClassVar[str] = "not asked"
    value: ClassVar[str] = "not asked"
    of_frames: ClassVar[bool] = True

    why: str
    expected: Verdict = field(default=NOT_ASKED, metadata=read(one_of(Verdict)))

    @property
    def latex(self) -> str:
        """Nothing is stated in formulas."""
        return r"\text{not asked}"

    def applies_to(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """To no single curve."""
        return False

    def prove(self) -> tuple[Name, Finding]:
        """Nothing is decided."""
        return self.reading, Finding(NOT_ASKED, witness=Stopped(ClaimError(self.why)))

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """Nothing is decided."""
        return self.prove()[1]

    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """Nothing is decided."""
        return self.prove()[1]
