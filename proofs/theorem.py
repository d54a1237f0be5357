"""How a theorem of the paper is put to the test: proved for all curves, verified on the example curves."""

from exactspline.audit import audit
from exactspline.claims import all_claims


def establish(claim_id, statement=""):
    """Every verdict on a claim (or on the one statement of it) is the one on record; returns the rows."""
    claims = [claim for claim in all_claims() if claim.id == claim_id and statement in claim.statement]
    assert claims, f"no claim {claim_id} says {statement!r}"
    rows = list(audit(claims))
    for row in rows:
        assert row.as_recorded, f"{row.id}, {row.statement}, on {row.curve or 'all curves'}: {row.verdict}, recorded {row.expected}. {row.witness}"
    return rows


def verdict_for_all(claim_id, statement=""):
    """The verdicts for all curves."""
    return [row.verdict for row in establish(claim_id, statement) if not row.curve]
