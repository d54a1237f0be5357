"""Real curves that others made, where their folder is at hand (EXACTSPLINE_CURVES, or ../shared/curves beside the checkout)."""

import os
from pathlib import Path

import pytest

from exactspline.audit import audit
from exactspline.claims import all_claims
from exactspline.curves import read_curve
from exactspline.planar import with_plane_curves

FOLDER = Path(os.environ.get("EXACTSPLINE_CURVES", Path(__file__).resolve().parents[2] / "shared" / "curves"))
FILES = sorted(FOLDER.glob("*.json")) if FOLDER.is_dir() else []
needs_curves = pytest.mark.skipif(not FILES, reason="no folder of real curves at hand")


@needs_curves
@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_every_claim_on_every_real_curve(file):
    curve = read_curve(file)
    rows = list(audit(all_claims(), with_plane_curves([curve])))
    assert rows
    assert [(row.id, row.statement, row.verdict, row.witness) for row in rows if not row.as_recorded] == []
    assert {row.id for row in rows} >= ({"C4.1a", "C4.1b"} if curve.dimension == 2 else {"C3d"})
