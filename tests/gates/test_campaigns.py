"""What a campaign compares is a sentence of the documentation."""

from pathlib import Path

import pytest

from tests.campaigns import common_zeros, derivatives, false_claims, one_curve, surfaces, zero_sets

DOCS = Path(__file__).parents[2] / "docs"


@pytest.mark.parametrize(
    ("page", "sentences"),
    [
        ("inspecting-surfaces.md", [*surfaces.COMPARED, *surfaces.KNOTTED]),
        ("two-parameters.md", [*common_zeros.COMPARED]),
        ("what-is-trusted.md", [*false_claims.COMPARED]),
        ("your-own-paper.md", [*zero_sets.COMPARED, *derivatives.COMPARED, *one_curve.COMPARED]),
    ],
)
def test_the_sentences_that_campaigns_judge_are_those_of_the_documentation(page, sentences):
    """No campaign said which sentence it judges; umbilics and curves across knots were judged by none."""
    text = " ".join((DOCS / page).read_text(encoding="utf8").split())
    assert [each for each in sentences if each not in text] == []
