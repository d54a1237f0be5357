"""What claims divide by although nothing that they assume keeps it from vanishing: each such claim says so."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from exactspline.extras.coq.formulas import identifier
from exactspline.papers import named_papers
from exactspline.verification.claims import claims_in
from exactspline.verification.divisors import divisors

THEOREMS = Path(__file__).parents[2] / "proofs" / "coq" / "claims"


def key(start):
    return next(claim for claim in claims_in(named_papers(["all"])) if claim.key.startswith(start))


@pytest.mark.parametrize(
    ("start", "found"),
    [
        ("T8-identity", ("p₂", "w₁ p₂")),
        ("T9-identity", ("p₂/w₂", "w₁ p₂")),
        ("C54a-rectifying_development", ("‖[P P′ P″ P‴] ‖D1‖² D1 + w ‖b‖² b‖²",)),
        ("L17-focal_development", ("w² ‖D1 × D2‖²",)),
        ("C41a-f1-f2", ()),
    ],
)
def test_what_a_claim_divides_by(start, found):
    assert divisors(key(start)) == found


def test_what_is_assumed_is_not_told_again():
    claim = key("C52a-torsion-torsion_reduced")
    assert divisors(claim) == ()
    assert divisors(replace(claim, assumes=())) == ("‖B‖²", "‖D1 × D2‖²")


@pytest.mark.skipif(not THEOREMS.exists(), reason="the theorems are in the checkout only")
def test_where_theorems_have_premises_of_their_own_claims_divide_by_more_than_they_assume():
    """The writer of theorems finds by itself what it has to assume besides: premises D1, D2, …"""
    premises = {}
    for file in THEOREMS.glob("*.v"):
        for theorem in file.read_text(encoding="utf-8").split("Theorem ")[1:]:
            name, _, text = theorem.partition(" ")
            premises[name] = bool(re.search(r"intros[^.]* D1\b", text))
    assert sum(premises.values()) > 15
    alone = []
    for claim in claims_in(named_papers(["all"])):
        own = [more for name, more in premises.items() if name.partition("_in_dimension_")[0] == identifier(claim.key)]
        if any(own) and not divisors(claim):
            alone.append(claim.key)
    # Coq evaluates the whole ruled surface, of which only the directrix divides; and it is not told that where
    # [γ′ γ″ γ‴] is not zero neither is γ′
    ruled = ["C62b-generator_of_34", "L15-point_bisector_lifted_generator"]
    implied = ["PZ3a-sphere_centre_meant", "PZ3d-spherical_identity"]
    assert [key.rpartition("-")[0] for key in alone] == ruled + implied
