"""Which claims have which theorems: every equality that holds one that says so, every one that fails one that denies
it, and, where the ledger says what holds instead, that too. None assumes what cannot be.
"""

from __future__ import annotations

from dataclasses import replace

import pytest

from exactspline import Verdict, claims, formula_of
from exactspline.errors import FormulaError
from exactspline.extras.coq.emission import Stated, library
from exactspline.extras.coq.theorems import STATED, theorem
from exactspline.language.kinds import kind_of
from exactspline.papers import papers
from exactspline.symbolic.assumptions import Assumption

#: Failures whose correction is no equality, with what it is instead: another claim, or a sentence alone.
CORRECTED_OTHERWISE = {"PB1d-third_derivative": ["count"], "C62f-tilted_plane_bisector_slope": []}
CLAIMS = [claim for paper in papers() for claim in claims(paper=paper.name)]
EQUALITIES = [claim for claim in CLAIMS if isinstance(claim, STATED)]
REFUTED = [claim for claim in EQUALITIES if claim.expected == Verdict.REFUTED]


def theorems(claim) -> list[Stated]:
    """The theorems of a claim, one per dimension."""
    found = (each for own in library().theorems.values() for each in own if not each.reason)
    return [each for each in found if (each.claim.paper, each.claim.key) == (claim.paper, claim.key)]


def held(claim) -> bool:
    """Whether there are theorems that a claim holds, in every dimension."""
    found = theorems(claim)
    return len(found) == len(kind_of(claim.curve).dimensions) and not any(x.name.endswith("_fails") for x in found)


def test_every_equality_has_theorems_in_every_dimension() -> None:
    assert len(EQUALITIES) > 350
    for claim in EQUALITIES:
        names = [each.name for each in theorems(claim)]
        assert len(names) == len(kind_of(claim.curve).dimensions), claim.key
        assert all(name.endswith("_fails") == (claim in REFUTED) for name in names), claim.key


@pytest.mark.parametrize("claim", REFUTED, ids=lambda claim: claim.key)
def test_what_holds_instead_of_a_failure_is_a_theorem(claim) -> None:
    if not claim.error:  # a control, that fails on purpose: what is compared obeys another equality
        sides = {claim.find(name) for name in claim.named}
        assert claim.status == "ours"
        assert any(held(each) and sides & {each.find(name) for name in each.named} for each in EQUALITIES)
        return
    together = [each for each in CLAIMS if (each.paper, each.error) == (claim.paper, claim.error)]
    meant = [each for each in together if each.status == "meant" and each.expected != Verdict.REFUTED]
    if claim.key in CORRECTED_OTHERWISE:
        assert [each.kind for each in meant] == CORRECTED_OTHERWISE[claim.key]
    else:
        assert any(held(each) for each in meant if isinstance(each, STATED))


def test_what_cannot_be_assumed_is_refused() -> None:
    claim = next(each for each in EQUALITIES if each.key == "C3d-velocity_acceleration_jerk-D1_D2_D3")
    assert "speed_squared c <> zero K" in assuming(claim, "speed_squared")
    with pytest.raises(FormulaError, match="it assumes that 0 is not 0"):
        assuming(claim, "D1_D2_D21")


def assuming(claim, name: str) -> str:
    """The theorem of a claim in space that assumes of a formula that it is not zero."""
    assumption = Assumption(name, name, name, name, formula_of(name), ("space",), formula=name)
    return theorem(replace(claim, assumes=(assumption,)), 3, lambda formula: formula.name)
