"""Tests of the claims of the paper: proved for all curves, verified on the example curves."""

from exactspline.papers import default_papers
from tests.support.decided import ledger


def establish(claim_id, statement=""):
    """Check that every verdict on a claim (or on one of its statements) is the recorded one; returns the rows."""
    decided = (row for paper in default_papers() for row in ledger(paper.name))
    rows = [row for row in decided if claim_id in (row.id, row.key) and statement in row.statement]
    assert rows, f"no claim {claim_id} says {statement!r}"
    for row in rows:
        assert row.as_recorded, (
            f"{row.id}, {row.statement}, on {row.curve or 'all curves'}: {row.verdict}, recorded "
            f"{row.expected}. {row.witness}"
        )
    return rows


def verdict_for_all(claim_id, statement=""):
    """The verdicts on a claim for all curves."""
    return [row.verdict for row in establish(claim_id, statement) if not row.curve]
