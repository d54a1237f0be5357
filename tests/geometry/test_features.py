"""Features of plane curves: counts known exactly, agreement between approaches, curvature values, degenerate input."""

import json

import mpmath
import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, Nurbs, analyse, check_certificate, claims, curvature, example
from exactspline.errors import ShapeError
from exactspline.geometry.curves.joints import curvature_of
from exactspline.papers.chen_riesenfeld_cohen_2007.figures import compare_approaches
from exactspline.verification.ledger import audit
from tests.support.bisector_oracle import bezier
from tests.support.command import invoke


def test_an_ellipse_has_four_vertices_the_seam_counted_once():
    found = analyse(example("ellipse")).curvature_extrema
    assert [(f.root.exact, f.kind, f.of_absolute) for f in found] == [
        (0, "maximum", "maximum"), (1, "minimum", "minimum"), (2, "maximum", "maximum"), (3, "minimum", "minimum")
    ]  # fmt: skip
    assert [curvature(example("ellipse"), f.root).significant(30) for f in found] == [2, mpmath.mpf(1) / 4] * 2


def test_the_vertices_of_a_skew_ellipse_are_conjugate_algebraic_numbers():
    found = analyse(example("ellipse_skew")).curvature_extrema
    assert len(found) == 4
    # opposite vertices are two segments apart
    for first, second in zip(found[:2], found[2:], strict=True):
        (a, b), (c, d) = (f.root.refine(60) for f in (first, second))
        assert a + 2 <= d
        assert c <= b + 2
    values = [curvature(example("ellipse_skew"), f.root).significant(40) for f in found]
    with mpmath.workdps(45):
        # (2x + y, x + 3y): half axes a, b with a² + b² = 15 and ab = 5; the curvatures there are a/b² and b/a²
        a2, b2 = (mpmath.mpf(15) + mpmath.sqrt(125)) / 2, (mpmath.mpf(15) - mpmath.sqrt(125)) / 2
        assert abs(values[0] - mpmath.sqrt(a2) / b2) < mpmath.mpf(10) ** -38
        assert abs(values[1] - mpmath.sqrt(b2) / a2) < mpmath.mpf(10) ** -38


def test_the_six_segment_cubic_has_what_figure_1_says():
    curve = example("six_segment_cubic")
    found = analyse(curve).curvature_extrema
    assert [f.by_jump for f in found].count(True) == 2
    assert [f.root.exact for f in found if f.by_jump] == [3, 4]
    assert len(found) == 8
    assert [f.kind for f in analyse(curve).inflections] == ["inflection"] * 2
    by_name = {row.name: row for row in compare_approaches(curve)}
    assert by_name["squaring"].extraneous == 2
    squared = analyse(curve).zero_form("critical_curvature", "squaring").zeros
    direct = analyse(curve).zero_form("critical_curvature", "direct").zeros
    assert [root for root in squared if root not in list(direct)] == [f.root for f in analyse(curve).inflections]


def test_a_circle_has_constant_curvature():
    assert [p.parts for p in analyse(example("circle")).constant_pieces] == [((0, 4),)]
    found = analyse(example("circle"))
    assert (len(found.critical_points), len(found.curvature_extrema)) == (0, 0)
    assert [p.parts for p in found.critical_points.everywhere] == [((0, 4),)]
    assert not found.inflections
    assert not found.singular_points


def test_a_cusp_is_neither_an_inflection_nor_an_extremum():
    curve = example("cusp")
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("cusp", mpq(1, 2))]
    assert len(analyse(curve).cusps) == 1
    assert not analyse(curve).inflections
    assert not analyse(curve).critical_points


def test_motion_that_stops_and_goes_on_is_no_cusp():
    """(u³, u⁴) has γ′ = 0 with the tangent kept; (u³, u³) along a line as well."""
    stops = Nurbs(4, [0] * 5 + [1] * 5, [(-1, 1), ("1/2", -1), (0, 1), ("-1/2", -1), (1, 1)])
    assert [(f.kind, f.root.exact) for f in analyse(stops).singular_points] == [("stop", mpq(1, 2))]


def test_knots_are_told_apart():
    assert analyse(example("jump")).joint(mpq(1)).kind == "gap"
    assert analyse(example("straight_between_arcs")).joint(mpq(1)).kind == "jump of the curvature"
    assert analyse(example("six_segment_cubic")).joint(mpq(3)).kind == "continuous curvature"
    corner = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
    assert analyse(corner).joint(mpq(1)).kind == "corner"
    back = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (0, 0)])
    assert analyse(back).joint(mpq(1)).kind == "corner"
    assert [p.parts for p in analyse(example("straight_between_arcs")).straight_pieces] == [((1, 2),)]


def test_curvature_that_changes_its_sign_by_a_jump():
    """Two arcs of opposite bend with a common tangent: an inflection at the knot, no extremum."""
    curve = Nurbs(2, [0, 0, 0, 1, 2, 2, 2], [(0, 0), (1, 1), (3, -1), (4, 0)])
    (f,) = analyse(curve).inflections
    assert (f.kind, f.root.exact, f.by_jump) == ("inflection", 1, True)
    assert not [f for f in analyse(curve).curvature_extrema if f.root == 1]


def test_the_curvature_may_vanish_at_its_own_extremum():
    """(t, t⁴) has κ = κ′ = 0 at 0; so has a sextic at an irrational parameter: the value there is exactly 0."""
    flat = Nurbs(4, [0] * 5 + [1] * 5, [(-1, 1), ("-1/2", -1), (0, 1), ("1/2", -1), (1, 1)])
    f = next(f for f in analyse(flat).curvature_extrema if f.root == mpq(1, 2))
    assert (f.root.exact, f.kind, f.of_absolute) == (mpq(1, 2), "minimum", "minimum")
    assert curvature(flat, f.root).significant(20) == 0
    t = BSpline.bezier([-2, 2])
    bend = (t * t - 2) ** 2  # y″ with double zeros at ±√2
    y = t.elevate_degree(5) * 0 + integral(integral(bend))
    curve = Nurbs(6, [0] * 7 + [1] * 7, list(zip(t.elevate_degree(5).control_points, y.control_points, strict=True)))
    flats = [f for f in analyse(curve).curvature_extrema if curvature(curve, f.root).significant(15) == 0]
    assert [f.kind for f in flats] == ["minimum", "minimum"]
    assert [f.kind for f in analyse(curve).inflections] == ["undulation", "undulation"]


def integral(f):
    """An antiderivative on [0, 1], by its Bézier points."""
    sums = [mpq(0)]
    for b in f.control_points:
        sums.append(sums[-1] + b / (f.degree + 1))
    return BSpline.bezier(sums)


def test_inspect_prints_what_it_found(monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    result = invoke("inspect", "ellipse_skew", "--digits", 50)
    assert result.exit_code == 0
    assert "0.5575365158350514101328250749125074194749956954805" in result.output
    data = json.loads(invoke("inspect", "six_segment_cubic", "--json").output)["rows"][0]
    assert [f["kind"] for f in data["inflections"]["points"]] == ["inflection"] * 2
    assert "κ′ ≡ 0" in invoke("inspect", "circle").output


def test_a_thousand_digits_enclose_the_root(monkeypatch):
    data = json.loads(invoke("inspect", "rational_cubic", "--digits", 1000, "--json").output)["rows"][0]
    low, high = (mpq(data["critical_points"]["points"][0]["parameter"][end]) for end in ("low", "high"))
    assert 0 < high - low <= mpq(1, 10**1000)
    f = analyse(example("rational_cubic")).zero_form("critical_curvature", "paper").form
    assert f(low) * f(high) < 0


@pytest.mark.parametrize(
    ("name", "functions"),
    [
        ("rational_quartic", ["critical_curvature", "zero_curvature"]),
        ("space_quartic", ["space_critical_curvature", "zero_curvature", "zero_torsion"]),
    ],
)
def test_certificates_are_written_and_checked(name, functions, tmp_path):
    file = tmp_path / "certificate.json"
    assert invoke("inspect", name, "--certificate", file).exit_code == 0
    written = json.loads(file.read_text())
    assert sorted(part["function"] for part in written) == functions
    for part in written:
        check_certificate(part["certificate"])
    written[1]["certificate"]["segments"][0]["coefficients"][0] = "1" + "0" * 40
    with pytest.raises(ValueError, match=r"."):
        check_certificate(written[1]["certificate"])


def test_what_cannot_be_inspected_says_why():
    four = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)])
    for asked in ("inflections", "curvature_extrema", "straight_pieces", "constant_pieces", "corners"):
        with pytest.raises(ShapeError, match="in the plane or in space"):
            getattr(analyse(four), asked)


@given(st.tuples(*[st.integers(-5, 5)] * 6), st.integers(1, 4), st.integers(-3, 3))
def test_curvature_is_that_of_the_plane_and_of_space_whatever_the_speed(jet, k, m):
    """κ = ‖γ′ × γ″‖/‖γ′‖³; with γ(kt + mt²) for γ(t) it stays the same."""
    first, second = jet[:3], jet[3:]
    if not any(first):
        return
    faster = [k * x for x in first], [k * k * y + 2 * m * x for x, y in zip(first, second, strict=True)]
    at = (0, 0, 0)
    assert curvature_of((at, *faster, at)) == curvature_of((at, first, second, at))
    (a, b, c), (d, e, f) = first, second
    across = (b * f - c * e) ** 2 + (c * d - a * f) ** 2 + (a * e - b * d) ** 2
    assert curvature_of((at, first, second, at)) ** 2 == mpq(across, (a * a + b * b + c * c) ** 3)
    if a or b:
        flat = curvature_of((at[:2], first[:2], second[:2], at[:2]))
        assert flat**2 == curvature_of((at, (a, b, 0), (d, e, 0), at)) ** 2
        assert (flat > 0, flat < 0) == (a * e > b * d, a * e < b * d)


@given(st.integers(1, 9), st.integers(1, 60))
def test_right_angles_are_whole_numbers_of_degrees(k, digits):

    def turned(x, y):
        joints = analyse(Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1 + x, y)])).joints
        return next(joint for joint in joints if joint.parameter == 1).angle.degrees(digits)

    assert [turned(*other) for other in ((0, k), (-k, 0), (0, -k))] == [90, 180, -90]
    assert (-1 < turned(k, mpq(1, 100)) < 90) is True


def test_a_singular_seam_is_counted_once():
    curve = bezier((0, 0), (0, 0), (3, 0), (1, 4), (0, 0), (0, 0))
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("corner", 0)]


def test_a_curve_that_starts_from_rest_is_singular_there():
    curve = bezier((0, 0), (0, 0), (1, 1), (2, 0))
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("singular end", 0)]
    assert not [f for f in analyse(curve).inflections if f.root == 0]
    assert not [f for f in analyse(curve).critical_points if f.root == 0]


def test_squaring_keeps_an_extremum_where_the_curvature_vanishes():
    """y = x⁴: κ = κ′ = 0 at 0, a minimum; y = x³: κ = 0 there but κ′ is not."""
    quartic = bezier((-1, 1), ("-1/2", -1), (0, 1), ("1/2", -1), (1, 1))
    cubic = bezier((-1, -1), ("-1/3", 1), ("1/3", -1), (1, 1))
    assert ("minimum", mpq(1, 2)) in [(f.kind, f.root.exact) for f in analyse(quartic).critical_points]
    assert not [f for f in analyse(cubic).critical_points if f.root == mpq(1, 2)]
    added = {row.name: row.extraneous for row in compare_approaches(cubic)}
    assert (added["squaring"], added["direct"]) == (1, 0)
    assert not any(row.extraneous or row.missing for row in compare_approaches(quartic))


@pytest.mark.parametrize(
    ("knots", "points"),
    [
        ([0] * 4 + [1] * 4 + [2] * 4, [(0, 0), (0, 1), (1, 1), (2, 1), (12, 0), (13, 0), (14, 0), (14, 5)]),
        ([0] * 4 + [1] * 3 + [2] * 4, [(0, 0), (0, 1), (1, 1), (2, 1), (2, 0), (2, -1), (3, -1)]),
    ],
    ids=["gap", "corner"],
)
def test_a_gap_or_a_corner_is_no_inflection(knots, points):
    assert not [f for f in analyse(Nurbs(3, knots, points)).inflections if f.root == 1]


def test_a_rest_is_no_cusp():
    curve = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0), (1, 0), (1, 0), (2, 0)])
    assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("rest", 1), ("rest", 2)]


def test_pieces_end_at_corners_and_where_the_curvature_jumps():
    bent = Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])
    assert [p.parts for p in analyse(bent).straight_pieces] == [((0, 1),), ((1, 2),)]
    arcs = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(1, 0), (1, 1), (0, 1), (-2, 1), (-2, -1)], weights=[1, 1, 2, 2, 4])
    assert [p.parts for p in analyse(arcs).constant_pieces] == [((0, 1),), ((1, 2),)]
    assert not analyse(arcs).curvature_extrema.points


#: Of what these claims speak exists on straight and planar curves, too: nothing is divided by κ or τ.
EXIST_ALL_THE_SAME = {"C43a-velocity_turned-velocity_turned_by_D1", "C54a-darboux_development", "E19-radius_vector"}


@pytest.mark.parametrize(
    ("name", "ids"),
    [
        ("straight_line", ["C4.3a", "E7", "E12"]),
        ("planar_in_space", ["E19", "C5.5b"]),
        ("space_line", ["C5.5c", "C5.4a"]),
    ],
)
def test_what_does_not_exist_is_not_verified(name, ids):
    """x/0 = y/0 is not a success, however true after multiplication."""
    rows = [
        row
        for row in audit(claims(*ids), [example(name)])
        if row.status != "ours" and row.key not in EXIST_ALL_THE_SAME
    ]
    assert rows
    assert {row.verdict for row in rows if row.claim.kind != "degree"} <= {"VACUOUS", "INAPPLICABLE"}
    assert all(row.as_recorded for row in rows)


def test_unnamed_curves_are_judged_like_named_ones():
    rows = list(audit(claims("C4.1"), [bezier((0, 0), (1, 2), (3, 1), weights=[1, 2, 1])]))
    assert all(row.as_recorded for row in rows)
    line = list(audit(claims("C3b"), [bezier((0, 0), (1, 2), weights=[1, 2])]))
    assert all(row.as_recorded for row in line)
