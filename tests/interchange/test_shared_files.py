"""Real files that others made, where their folder is at hand: counts from independent readers, the same numbers as
taken from them by hand, and every real curve through every writer.
"""

import os
import re
from pathlib import Path

import pytest

from exactspline import read
from exactspline.errors import NumberError
from exactspline.interchange.collector import Collector
from exactspline.interchange.files import encoded
from exactspline.interchange.formats import formats
from tests.geometry.test_shared_curves import FILES, needs_curves

FOLDER = Path(os.environ.get("EXACTSPLINE_FILES", Path(__file__).resolve().parents[3] / "shared" / "files"))
needs_files = pytest.mark.skipif(not FOLDER.is_dir(), reason="no folder of real files at hand")

#: File: how many curves, of which degrees, are rational; counted by pyiges, ezdxf, rhino3dm, svgelements or by hand
#: (edges of STEP in its text).
COUNTS = {
    "as1_tc_214.stp": (126, {1, 3}, 56),
    "as_BSplHelix.brep": (6, {1, 6, 11}, 5),
    "as_CircularBSpl.brep": (2, {2, 3}, 1),
    "as_edge_deg14.brep": (1, {14}, 0),
    "as_occShoeBSplC0.brep": (3, {1, 3}, 0),
    "ezdxf_no_layouts.dxf": (2, {3}, 0),
    "gdal_neg_knot.dxf": (1, {3}, 0),
    "gdal_spline_closed.dxf": (1, {3}, 0),
    "gismo_lake_pd.xml": (4, {5}, 0),
    "gismo_quarter_circle.xml": (1, {2}, 1),
    "gotools_rational_spline_cv_2.g2": (1, {2}, 1),
    "gotools_testcurve3.g2": (1, {3}, 0),
    "igestoolbox_example.igs": (224, {1, 2, 3}, 48),
    "oce_screw.step": (41, {1, 2, 3}, 12),
    "opennurbs_v2_Flow1.3dm": (4, {1, 3}, 0),
    "opennurbs_v6_my_curves.3dm": (4, {1, 2, 3}, 2),
    "rhino_curve_geom_plate.igs": (6, {3}, 0),
    "rhino_splinecage.stp": (38, {1, 3}, 0),
    "sisl_example10_curves.g2": (16, {3}, 0),
    "skym_squircle2.dxf": (1, {2}, 1),
    "splinelib_read2.iges": (1, {3}, 0),
    "splinelib_test.itd": (2, {2}, 1),
    "Lobster.subset.otf": (15, {3}, 0),
}
LIBRARY = {".3dm": "rhino3dm", ".otf": "fontTools", ".ttf": "fontTools"}


def opened(name, **options):
    if not (FOLDER / name).is_file():
        pytest.skip("not at hand")
    if library := LIBRARY.get(Path(name).suffix):
        pytest.importorskip(library)
    return read(FOLDER / name, **options)


@needs_files
@pytest.mark.parametrize("name", COUNTS)
def test_as_many_curves_as_others_found(name, monkeypatch):
    """Before composite curves are joined of their parts."""
    monkeypatch.setattr(Collector, "join", lambda *_: None)
    curves = [named.curve for named in opened(name).curves]
    count, degrees, rational = COUNTS[name]
    assert len(curves) == count
    assert {c.degree for c in curves} == degrees
    assert sum(not c.polynomial for c in curves) == rational


@needs_files
def test_as_many_splines_and_arcs_in_a_mixed_file(monkeypatch):
    monkeypatch.setattr(Collector, "join", lambda *_: None)
    curves = opened("igesio_single_rounded_cube.iges").curves
    assert sum("126" in named.curve.source for named in curves) == 30
    arcs = [named.curve for named in curves if "entity 100" in named.curve.source]
    assert len(arcs) == 4
    assert not any(arc.polynomial for arc in arcs)


@needs_files
@pytest.mark.parametrize(("name", "exactly", "nearly", "parts"), [
    ("igesio_single_rounded_cube.iges", 11, 14, 5), ("igestoolbox_example.igs", 44, 46, 11),
])  # fmt: skip
def test_composite_curves_of_real_files(name, exactly, nearly, parts):
    """Joined exactly or within an error, and otherwise said to be read in parts."""
    for options, joined in (({}, exactly), ({"approximate": "1e-6"}, nearly)):
        found = opened(name, **options)
        made = [x for x in found.curves if "entity 102" in x.curve.source]
        left = [x for x in found.skipped if x.what == "entity 102"]
        assert (len(made), len(made) + len(left)) == (joined, nearly)
        assert all("--approximate E" in x.why and not x.curve for x in left)
        assert all(re.match(r"made of \d+ curve", x.notes[0]) for x in made)
        assert any(f"made of {parts} curves" in x.notes for x in made)


@needs_files
def test_what_has_no_knots_is_named():
    assert "11 knots announced, 0 given" in opened("gdal_spline_closed.dxf").skipped[0].why
    for name in ("geomdl_CPw_Curve4.json", "geomdl_ex_curve04.cptw"):
        reading = opened(name)
        assert not reading.curves
        assert reading.skipped[0].what == "9 control points"


def shape(curve):
    """Degree, inner knots, points, relative weights: what remains where end knots were missing and z is 0."""
    weights = [w / curve.weights[0] for w in curve.weights]
    points = curve.control_points
    if curve.dimension == 3 and all(point[2] == 0 for point in points):
        points = tuple(point[:2] for point in points)
    return curve.degree, tuple(curve.knots)[1:-1], points, weights


TAKEN = {
    "3dm_flow_periodic_cubic": "opennurbs_v2_Flow1.3dm",
    "dxf_gdal_closed_cubic": "gdal_spline_closed.dxf",
    "dxf_gdal_nearly_clamped_knot": "gdal_neg_knot.dxf",
    "dxf_squircle_rational": "skym_squircle2.dxf",
    "gismo_quarter_circle": "gismo_quarter_circle.xml",
    "iges_rhino_geomplate_cubic": "rhino_curve_geom_plate.igs",
    "iges_splinelib_cubic_c0": "splinelib_read2.iges",
    "step_screw_planar_cubic": "oce_screw.step",
    "step_splinecage_cubic": "rhino_splinecage.stp",
}


@needs_files
@needs_curves
@pytest.mark.parametrize("name", TAKEN)
def test_the_same_numbers_as_taken_by_hand(name):
    by_hand = next(read(file).curve for file in FILES if file.stem == name)
    assert shape(by_hand) in [shape(named.curve) for named in opened(TAKEN[name]).curves]


@needs_files
@needs_curves
def test_control_points_alone_with_their_degree_and_knots():
    by_hand = next(read(file).curve for file in FILES if file.stem == "geomdl_circle_9cp_3digit")
    for name in ("geomdl_ex_curve04.cptw", "geomdl_CPw_Curve4.json"):
        [named] = opened(name, degree=2, knots=by_hand.knots).curves
        assert shape(named.curve)[3] == shape(by_hand)[3]
    [named] = opened("geomdl_ex_curve04.cptw", degree=2, knots=by_hand.knots).curves
    assert shape(named.curve) == shape(by_hand)


@needs_curves
@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_every_real_curve_through_every_writer(file):
    curve = read(file).curve
    held = []
    for known in formats():
        if known.write is None or known.name in ("svg", "3dm"):
            continue
        try:
            data, notes = encoded([curve], known.name)
        except NumberError:
            continue
        [named] = read(data).curves
        assert shape(named.curve) == shape(curve)
        assert tuple(named.curve.knots) == tuple(curve.knots)
        assert not notes
        held.append(known.name)
    assert "json" in held
    finite = all(
        10**1200 % x.denominator == 0
        for x in (*curve.knots, *curve.weights, *(x for point in curve.control_points for x in point))
    )
    assert not finite or len(held) == 9


def splines_of(name, kind):
    """The curves of a file that came out of one kind of entity."""
    return [named.curve for named in opened(name).curves if kind in named.curve.source]


@needs_files
@pytest.mark.parametrize("name", ["skym_squircle2.dxf", "ezdxf_no_layouts.dxf"])
def test_dxf_against_ezdxf(name):
    """ezdxf holds doubles: ours round to them."""
    ezdxf = pytest.importorskip("ezdxf")
    theirs = list(ezdxf.readfile(FOLDER / name).query("SPLINE"))
    ours = splines_of(name, "SPLINE")
    assert len(ours) == len(theirs)
    for a, b in zip(ours, theirs, strict=True):
        assert a.degree == b.dxf.degree
        assert [float(t) for t in a.knots] == list(b.knots)
        assert [tuple(map(float, p)) for p in a.control_points] == [tuple(p)[:2] for p in b.control_points]
        assert [float(w) for w in a.weights] == (list(b.weights) or [1.0] * len(a.weights))
