"""No approach to critical curvature loses a point of a curve, and there the curvature is extremal."""

import pytest
from gmpy2 import mpq

from exactspline import analyse, example, examples, formula_of, read
from exactspline.papers.chen_riesenfeld_cohen_2007.figures import compare_approaches
from tests.geometry.test_shared_curves import FILES
from tests.support.sampled import sample


def check_agreement(curve):
    rows = {row.name: row for row in compare_approaches(curve)}
    assert not any(row.missing for row in rows.values())
    if "reduced" in rows:  # in space
        degrees = [rows[name].degree for name in ("minimal", "reduced", "direct", "squaring")]
        assert curve.degree < 3 or degrees == sorted(degrees)
        return
    assert not any(rows[name].extraneous for name in ("direct", "paper"))
    own = analyse(curve)
    extra = {f.root for f in (*own.inflections, *own.singular_points)}
    true = list(own.zero_form("critical_curvature").zeros)
    assert {root for root in own.zero_form("critical_curvature", "squaring").zeros if root not in true} <= extra


@pytest.mark.parametrize("name", [name for name in examples("curves") if example(name).dimension < 4])
def test_on_the_example_curves(name):
    check_agreement(example(name))


@pytest.mark.parametrize("file", sample(FILES, 20), ids=lambda f: f.stem)
def test_on_real_curves(file):
    check_agreement(read(file).curve)


PLANE = ["rational_cubic_s", "rational_quartic", "ellipse_turned", "six_segment_cubic"]
SPACE = ["rational_space_cubic", "rational_space_cubic_spline", "helix_like", "space_quartic", "flat_point"]


@pytest.mark.parametrize("name", [*PLANE, *SPACE])
def test_curvature_is_extremal_where_it_says_so(name):
    """Exactly: κ² on both sides of an extremum of |κ|, at rational parameters nearby, is beyond none."""
    curve = example(name)
    kappa = formula_of("curvature_squared" if name in PLANE else "space_curvature_squared")(curve)
    a, b = curve.domain
    kinds = [(f.root, f.of_absolute or f.kind) for f in analyse(curve).curvature_extrema]
    assert kinds
    for root, kind in kinds:
        low, high = root.refine(12)
        h = mpq(1, 1000)
        if a < low - h and high + h < b and kind in ("maximum", "minimum"):
            centre = kappa((low + high) / 2)
            assert [kappa(t) < centre for t in (low - h, high + h)] == [kind == "maximum"] * 2
