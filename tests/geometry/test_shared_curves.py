"""Real curves that others made, where their folder is at hand (EXACTSPLINE_CURVES, or ../shared/curves beside the
checkout).
"""

import os
from pathlib import Path

import pytest

from exactspline import check_certificate, claims, derive, read
from exactspline.errors import ShapeError
from exactspline.geometry.curves.planarity import with_plane_curves
from exactspline.geometry.derived.constructions import constructions_for
from exactspline.splines.lowest_terms import true_degree
from exactspline.verification.generic_proof import certificate, symbolic_minimum
from exactspline.verification.ledger import audit
from tests.support.sampled import sample

FOLDER = Path(os.environ.get("EXACTSPLINE_CURVES", Path(__file__).resolve().parents[3] / "shared" / "curves"))
FILES = sorted(FOLDER.glob("*.json")) if FOLDER.is_dir() else []
needs_curves = pytest.mark.skipif(not FILES, reason="no folder of real curves at hand")


@needs_curves
@pytest.mark.parametrize("file", sample(FILES, 5), ids=lambda f: f.stem)
def test_every_claim_on_real_curves(file):
    curve = read(file).curve
    rows = list(audit(claims(), with_plane_curves([curve])))
    assert rows
    assert [(row.id, row.statement, row.verdict, str(row.witness)) for row in rows if not row.as_recorded] == []
    assert {row.id for row in rows} >= ({"C4.1a", "C4.1b"} if curve.dimension == 2 else {"C3d"})


@needs_curves
@pytest.mark.parametrize("file", sample(FILES, 12, seed=2), ids=lambda f: f.stem)
def test_no_real_curve_exceeds_the_proved_degree_and_every_minimal_form_has_a_certificate(file):
    curve = read(file).curve
    for made in constructions_for(curve.dimension):
        proved = symbolic_minimum(made, made.dimension, polynomial=curve.polynomial).at({"d": max(curve.degree, 3)})
        try:
            attained = max(true_degree(piece.value) for piece in derive(made.name, curve).pieces)
        except ShapeError:
            continue
        assert attained <= proved
        if attained >= 0:
            assert check_certificate(certificate(made.name, curve))["degree"] == attained
