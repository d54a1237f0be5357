"""Claims about a single example curve."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from exactspline.errors import ClaimError
from exactspline.verification.claim import Claim, example_name, read
from exactspline.verification.claim_fields import claim_kind
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.verdict import Finding
from exactspline.verification.vocabulary import Name


@claim_kind
class ExampleClaim(Claim):
    """A claim about a single example curve."""

    reading: ClassVar[Name] = Name("spline")

    example: str = field(metadata=read(example_name))

    def validate(self) -> None:
        """Reject an example to which the claim does not apply."""
        curve = self.curve_named(self.example)
        if curve.dimension not in self.dimensions or curve.polynomial not in self.of.worlds:
            raise ClaimError(
                f"{self.example!r} is not a curve to which the claim applies",
                where="example",
                remedy="name another one",
            )

    def speaks_of(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """It applies to its example only."""
        return False

    def prove(self) -> tuple[Name, Finding]:
        """The finding on the example."""
        own = Evaluation(self.curve_named(self.example))
        return self.reading, self.examine(own.handed(self.curve), own)

    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The same for every case."""
        return self.prove()[1]
