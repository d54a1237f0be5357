"""What the pages read of the ledger: all claims, with the verdicts on record."""

import json
import os
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")

from docs.site import page_data  # needs it
from docs.site.executed import KEPT
from exactspline.papers import papers
from exactspline.verification.claims import claims_in


def test_the_pages_have_every_claim_with_the_verdict_on_record(tmp_path, monkeypatch):
    """The site takes them from here, where the folder for that is named."""
    made, claims = page_data.spelled_out(), claims_in(papers())
    assert [(told["paper"], told["id"]) for told in made] == [(claim.paper, claim.id) for claim in claims]
    assert [told["verdict"] for told in made] == [str(claim.expected) for claim in claims]
    text = json.dumps(made)
    folder = Path(os.environ.get(KEPT, tmp_path))
    folder.mkdir(exist_ok=True)
    (folder / page_data.CLAIMS).write_text(text, encoding="utf-8")
    monkeypatch.setenv(KEPT, str(folder))
    assert page_data.claims() == json.loads(text)
