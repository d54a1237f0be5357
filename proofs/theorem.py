"""How a theorem of the paper is put to the test: proved for all curves, verified on the example curves."""

from functools import cache

from exactspline.verification.claims import all_claims
from exactspline.verification.ledger import audit


@cache
def _audited(claim_id):
    return tuple(audit([claim for claim in all_claims() if claim_id in (claim.id, claim.key)]))


def establish(claim_id, statement=""):
    """Every verdict on a claim (or on the one statement of it) is the one on record; returns the rows."""
    rows = [row for row in _audited(claim_id) if statement in row.statement]
    assert rows, f"no claim {claim_id} says {statement!r}"
    for row in rows:
        assert row.as_recorded, (
            f"{row.id}, {row.statement}, on {row.curve or 'all curves'}: {row.verdict}, recorded "
            f"{row.expected}. {row.witness}"
        )
    return rows


def verdict_for_all(claim_id, statement=""):
    """The verdicts for all curves."""
    return [row.verdict for row in establish(claim_id, statement) if not row.curve]
