"""The words on which claims rest stand in the paper, on the page that is named."""

import re

from exactspline import claims
from reading.cutter import squeezed

PRINTED = [claim for claim in claims() if claim.status == "printed"]


def test_squeezing_keeps_what_distinguishes():
    assert squeezed("polynomial B-\nspline γγγ′") == "polynomialBsplineγ′"
    assert squeezed("[γ′γ′γ′ γ′′γ′′γ′′]") == squeezed("[γ′ γ″]") != squeezed("[γ′ γ‴]")


def test_what_is_printed_is_quoted_or_carries_the_number_of_its_equation():
    unquoted = [claim for claim in PRINTED if not claim.words]
    assert all(re.search(r"eq\. \(\d+\)|Table 1", claim.place) for claim in unquoted)
    assert all(claim.place.startswith("p. ") for claim in PRINTED)
    assert len(unquoted) < len(PRINTED) / 5


def test_refuted_statements_in_print_belong_to_errors_and_every_error_says_what_is_true():
    refuted = {claim.error for claim in PRINTED if claim.expected == "REFUTED"}
    meant = {claim.error for claim in claims() if claim.status == "meant"}
    assert refuted
    # what is not an error but a remark of ours: a statement that would be false if it were said of another formula
    remarks = {claim.error for claim in claims() if claim.status == "ours" and claim.expected == "REFUTED"} - {""}
    assert refuted <= meant <= refuted | remarks
    assert not any(claim.error for claim in PRINTED if claim.expected != "REFUTED")
