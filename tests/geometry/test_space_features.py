"""Features of space curves: exactly known answers, agreement with the plane, invariance under similarities and
reversal, values, the command.
"""

import json

import mpmath
import pytest
from click.testing import CliRunner
from gmpy2 import mpq
from hypothesis import assume, given

from exactspline import (
    BSpline,
    Nurbs,
    analyse,
    claims,
    curvature,
    derive,
    distance,
    example,
    examples,
    features_of_curves,
    formula_of,
    nearest,
    torsion,
)
from exactspline.cli import app
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis.inspection import inspect_curve
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.planarity import as_plane_curve, planar_pieces, plane_of
from exactspline.verification.ledger import audit
from tests.support.answers import places
from tests.support.command import invoke
from tests.support.space_curves import MIRRORED, TURNED, chained, power_curve
from tests.support.strategies import nurbs
from tests.support.vectors import mpf_of

PLANE = [name for name in examples("curves") if example(name).dimension == 2]


def test_the_twisted_cubic_has_one_vertex():
    """κ² = 4(9t⁴ + 9t² + 1)/(9t⁴ + 4t² + 1)³ decreases with t²; τ = 3/(9t⁴ + 9t² + 1) has no zero."""
    curve = power_curve([0, 1], [0, 0, 1], [0, 0, 0, 1])
    (f,) = analyse(curve).critical_points
    assert (f.kind, f.root) == ("maximum", 0)
    assert (curvature(curve, f.root).significant(20), torsion(curve, f.root).significant(20)) == (2, 3)
    assert not analyse(curve).torsion_zeros
    assert not analyse(curve).inflections


@pytest.mark.parametrize(
    ("third", "expected"),
    [
        # z‴ = 2t² − 1 and (2t² − 1)²: the torsion of (t, t², z) is a positive multiple of z‴
        ([0, 0, 0, mpq(-1, 6), 0, mpq(2, 60)], [("torsion zero", -1), ("torsion zero", 1)]),
        ([0, 0, 0, mpq(1, 6), 0, mpq(-4, 60), 0, mpq(4, 210)], [("torsion touch", -1), ("torsion touch", 1)]),
    ],
    ids=["crossing", "touching"],
)
def test_torsion_zeros_at_irrational_parameters(third, expected):
    curve = power_curve([0, 1], [0, 0, 1], third)
    found = analyse(curve).torsion_zeros
    assert [f.kind for f in found] == [kind for kind, _ in expected]
    assert all(f.root.minimal_polynomial() == [-1, 0, 2] for f in found)
    assert [1 if f.root > 0 else -1 for f in found] == [sign for _, sign in expected]
    with mpmath.workdps(60):
        s = mpmath.sqrt(mpmath.mpf(1) / 2)
        value = [mpmath.mpf(0), mpmath.mpf(0), mpmath.mpf(0)]
        for k, c in enumerate(third):
            coefficient = mpf_of(mpq(c))
            for order in range(3):
                if k >= order:
                    value[order] += coefficient * mpmath.ff(k, order) * s ** (k - order)
        first, second = [1, 2 * s, value[1]], [0, 2, value[2]]
        b = [first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2], 2]
        kappa = mpmath.sqrt(sum(x * x for x in b)) / mpmath.sqrt(sum(x * x for x in first)) ** 3
        assert abs(curvature(curve, found[1].root).significant(40) - kappa) < mpmath.mpf(10) ** -40
        assert abs(torsion(curve, found[1].root).significant(40)) < mpmath.mpf(10) ** -40


def embedded(curve, matrix):
    """A plane curve moved into space by the columns of a matrix: images of two unit vectors and of the origin."""
    points = [tuple(a * x + b * y + c for a, b, c in matrix) for x, y in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, curve.weights)


@pytest.mark.parametrize(
    "matrix", [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[2, -1, 0], [2, 2, 0], [-1, 2, 0]]], ids=["z = 1", "tilted"]
)
@pytest.mark.parametrize("name", PLANE)
def test_a_plane_curve_in_space_has_the_features_it_has_in_the_plane(name, matrix):
    curve = example(name)
    in_space = embedded(curve, matrix)
    skipped = [joint.parameter for joint in analyse(curve).joints if joint.kind == "jump of the curvature"]
    expected = [
        (f.of_absolute or f.kind, f.root)
        for f in analyse(curve).critical_points
        if f.root not in skipped and curvature(curve, f.root).sign
    ]
    assert [(f.kind, f.root) for f in analyse(in_space).critical_points if f.root not in skipped] == expected
    assert [(f.kind, f.root) for f in analyse(in_space).inflections] == [
        (f.kind, f.root) for f in analyse(curve).inflections
    ]
    assert analyse(in_space).torsion_zeros.points == ()


def test_a_curve_in_the_plane_z_0_is_a_plane_curve_to_every_question():
    """Refused before: area and winding number; unsigned before: the curvature."""
    flat = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (3, 3), (-2, 3), (1, 0)])
    curve = embedded(flat, [[1, 0, 0], [0, 1, 0], [0, 0, 0]])
    found, expected = analyse(curve), analyse(flat)
    assert found.self_intersections == expected.self_intersections != ()
    for name in ("inflections", "critical_points"):
        assert [(f.kind, f.root) for f in getattr(found, name)] == [(f.kind, f.root) for f in getattr(expected, name)]
    assert curvature(curve, "1/3") == curvature(flat, "1/3") > 0 > curvature(flat.reverse(), "1/3")
    closed = embedded(example("circle"), [[1, 0, 0], [0, 1, 0], [0, 0, 0]])
    assert analyse(closed).winding_number((0, "1/3")) == 1
    # what only space curves have is told, too
    assert str(found.plane) == "z = 0"
    assert len(found.torsion_zeros.everywhere) == 1
    assert found.nearest((0, 0, 7))[0].distance == 7
    # through functions that take several curves, or a curve and a point; refused before
    line = Nurbs(1, [0, 0, 1, 1], [(0, 5), (1, 5)])
    assert distance(curve, line) == distance(flat, line)
    assert nearest(curve, (0, 0))[0].distance == nearest(flat, (0, 0))[0].distance
    assert features_of_curves([curve]).kind.tolist() == features_of_curves([flat]).kind.tolist() != []
    # before and after other questions, and of the plane curve itself
    assert analyse(analyse(curve).curve) is not analyse(curve)
    assert analyse(curve) is analyse(curve) is found


@given(nurbs(dimension=3, low=1, high=4))
def test_reflections_turn_the_sign_of_the_torsion(curve):
    mirrored = curve.transform(MIRRORED)
    turned, kept = formula_of("D1_D2_D3")(mirrored), formula_of("D1_D2_D3")(curve)
    assert turned == kept * -27
    assert [(f.root, f.root.signs) for f in analyse(mirrored).torsion_zeros] == [
        (f.root, tuple(None if s is None else -s for s in f.root.signs)) for f in analyse(curve).torsion_zeros
    ]


@given(nurbs(dimension=3, low=3, high=3, most=0))
def test_torsion_has_the_signs_that_its_zeros_tell(curve):
    """Between neighbouring zeros τ, evaluated exactly, has one sign: that of the zeros beside it."""
    tau = formula_of("torsion_reduced")(curve)
    assume(not tau.is_zero and not analyse(curve).inflections and not analyse(curve).singular_points)
    a, b = curve.domain
    found = [f for f in analyse(curve).torsion_zeros if a < f.root < b]
    ends = [a, *[x for f in found for x in f.root.refine(40)], b]
    for i, f in enumerate(found):
        low, high = (ends[2 * i] + ends[2 * i + 1]) / 2, (ends[2 * i + 2] + ends[2 * i + 3]) / 2
        assert [(tau(t) > 0) - (tau(t) < 0) for t in (low, high)] == list(f.root.signs)


def test_a_circle_and_a_line_in_space_have_constant_curvature():
    circle = embedded(example("circle"), TURNED)
    assert [p.parts for p in analyse(circle).constant_pieces] == [(circle.domain,)]
    line = example("space_line")
    assert (
        [p.parts for p in analyse(line).straight_pieces]
        == [p.parts for p in analyse(line).constant_pieces]
        == [(line.domain,)]
    )


def test_what_is_not_known_is_refused():
    with pytest.raises(ShapeError, match="in space"):
        analyse(example("circle")).torsion_zeros  # noqa: B018
    cusp = power_curve([0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1])
    (singular,) = analyse(cusp).singular_points
    with pytest.raises(DomainError, match="γ′ = 0"):
        torsion(cusp, singular.root).significant(10)
    four = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)])
    with pytest.raises(ShapeError, match="plane"):
        inspect_curve(four)


def test_inspect_prints_curvature_and_torsion(monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    result = invoke("inspect", "flat_point", "--digits", 30)
    assert result.exit_code == 0
    assert "torsion" in result.output
    data = json.loads(invoke("inspect", "flat_point", "--json").output)["rows"][0]
    (flat,) = data["inflections"]["points"]
    told = flat["parameter"], *flat["curvature"], *flat["torsion"]
    assert (flat["kind"], *[x["exact"] for x in told]) == ("inflection", "1/2", "0", "2")
    assert data["torsion_zeros"]["points"] == []


def kinds(features):
    return [(f.kind, f.root.exact, f.by_jump) for f in features]


@pytest.mark.parametrize(
    ("coordinates", "flat", "torsion", "value"),
    [
        # (t, tᵃ, tᵇ): γ′ × γ″ has a zero of order a − 2, τ one of order b − a − 1
        ([[0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1]], "inflection", None, 2),
        ([[0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 0, 1]], "inflection", "torsion zero", 0),
        ([[0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 1]], "inflection", "torsion touch", 0),
        ([[0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 1]], "undulation", None, mpq(5, 3)),
        ([[0, 1], [0, 0, 1], [0, 0, 0, 0, 1]], None, "torsion zero", 0),
        ([[0, 1], [0, 0, 1], [0, 0, 0, 0, 0, 1]], None, "torsion touch", 0),
    ],
    ids=lambda x: str(x) if isinstance(x, (str, int)) else None,
)
@pytest.mark.parametrize("weights", ["polynomial", "rational"])
def test_where_the_curvature_vanishes_torsion_itself_decides(coordinates, flat, torsion, value, weights):
    # three times as large: a third of the torsion
    curve = power_curve(*coordinates).transform([[*row, k] for row, k in zip(TURNED, (1, 2, 3), strict=True)])
    if weights == "rational":
        # the same curve: numerators and denominator times a linear function
        w = BSpline.bezier([1, 3], -1, 1)
        rows = [x * w for x in curve.p] + [w.elevate_degree(curve.degree)]
        curve = Nurbs.from_homogeneous(
            curve.degree + 1, rows[0].knots, zip(*[row.control_points for row in rows], strict=True)
        )
    assert [(f.kind, f.root == 0) for f in analyse(curve).inflections] == ([(flat, True)] if flat else [])
    assert [(f.kind, f.root == 0) for f in analyse(curve).torsion_zeros] == ([(torsion, True)] if torsion else [])
    (root,) = [f.root for f in analyse(curve).inflections[:1]] or [f.root for f in analyse(curve).torsion_zeros]
    with mpmath.workdps(30):
        assert abs(9 * values_along.torsion(curve, root).significant(20) - int(3 * value)) < mpmath.mpf(10) ** -18
    assert (values_along.curvature(curve, root).significant(20) == 0) == (flat is not None)
    assert not [f for f in analyse(curve).critical_points if flat and f.root == 0]


@pytest.mark.parametrize(
    ("coordinates", "kind"),
    [
        ([[0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1]], "cusp"),
        ([[0, 0, 0, 1], [0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 1]], "stop"),
    ],
)
def test_a_singular_point_is_nothing_else(coordinates, kind):
    curve = power_curve(*coordinates)
    assert kinds(analyse(curve).singular_points) == [(kind, 0, False)]
    for found in (analyse(curve).inflections, analyse(curve).torsion_zeros, analyse(curve).critical_points):
        assert not [f for f in found if f.root == 0]


CUBIC = power_curve([0, 1], [0, 0, 1], [0, 0, 0, 1], domain=(-1, 0))


#: What may follow the twisted cubic at t = 0, the joint that it makes, and what happens to the torsion there.
FOLLOWERS = {
    "mirrored": ([[0, 1], [0, 0, 1], [0, 0, 0, -1]], "continuous curvature", [("torsion zero", 0, True)]),
    "more torsion": ([[0, 1], [0, 0, 1], [0, 0, 0, 5]], "continuous curvature", []),
    "touching zero on one side": ([[0, 1], [0, 0, 1], [0, 0, 0, 0, 1]], "continuous curvature", []),
    "less curvature": ([[0, 1], [0, 0, mpq(1, 2)], [0, 0, 0, 1]], "jump of the curvature", []),
    "less curvature, mirrored": (
        [[0, 1], [0, 0, mpq(1, 2)], [0, 0, 0, -1]],
        "jump of the curvature",
        [("torsion zero", 0, True)],
    ),
    "bent the other way": ([[0, 1], [0, 0, -1], [0, 0, 0, -1]], "jump of the curvature", []),
    "another osculating plane": ([[0, 1], [0, 0, 0, 1], [0, 0, 1]], "jump of the osculating plane", []),
    "planar": ([[0, 1], [0, 0, 1], [0, 0, 0, 0]], "continuous curvature", []),
    "straight": ([[0, 1], [0], [0, 0, 0, 0]], "jump of the curvature", []),
    "corner": ([[0, 1], [0, 1], [0, 0, 0, 1]], "corner", []),
    "singular": ([[0, 0, 1], [0, 0, 0, 1], [0, 0, 0, -1]], "singular", []),
    "gap": ([[0, 1], [1, 0, 1], [0, 0, 0, -1]], "gap", []),
}


@pytest.mark.parametrize("name", FOLLOWERS)
def test_joints_and_the_torsion_there(name):
    coordinates, kind, torsion = FOLLOWERS[name]
    following = power_curve(*coordinates, domain=(0, 1))
    n = max(following.degree, 3)
    curve = chained(*[raised(c, n) for c in (CUBIC, following)])
    assert analyse(curve).joint(mpq(0)).kind == kind
    assert kinds(f for f in analyse(curve).torsion_zeros if f.root == 0) == torsion


def raised(curve, degree):
    """The same Bézier curve in a higher degree."""
    components = [x.elevate_degree(degree - x.degree) for x in curve.p]
    a, b = curve.domain
    return Nurbs(
        degree, [a] * (degree + 1) + [b] * (degree + 1), list(zip(*[c.control_points for c in components], strict=True))
    )


def test_the_curvature_may_have_its_extremum_where_the_osculating_plane_jumps():
    """Two parabolas with a common vertex and tangent in perpendicular planes: κ is continuous there and greatest."""
    curve = chained(
        power_curve([0, 1], [0, 0, 1], [0], domain=(-1, 0)), power_curve([0, 1], [0], [0, 0, 1], domain=(0, 1))
    )
    assert kinds(analyse(curve).critical_points) == [("maximum", 0, False)]
    assert [str(plane) for _, plane in planar_pieces(curve)] == ["z = 0", "y = 0"]
    assert plane_of(curve) is None
    assert analyse(curve).torsion_zeros.points == ()


def test_the_principal_normal_turned_round_by_a_jump_is_an_inflection():
    curve = chained(
        power_curve([0, 1], [0, 0, 1], [0], domain=(-1, 0)), power_curve([0, 1], [0, 0, -2], [0], domain=(0, 1))
    )
    assert kinds(analyse(curve).inflections) == [("inflection", 0, True)]
    assert analyse(curve).inflections[0].of_absolute is None


def test_curvature_that_vanishes_on_both_sides_of_a_knot():
    left = power_curve([0, 1], [0, 0, 0, 1], [0], domain=(-1, 0))
    for right, kind in (
        (([0, 0, 0, 1], [0]), "inflection"),
        (([0, 0, 0, -1], [0]), "undulation"),
        (([0], [0, 0, 0, 1]), "flat point"),
    ):
        curve = chained(left, power_curve([0, 1], *right, domain=(0, 1)))
        assert kinds(analyse(curve).inflections) == [(kind, 0, False)]
        assert values_along.curvature(curve, analyse(curve).inflections[0].root).significant(20) == 0


def test_a_straight_piece_between_twisted_ones():
    ends = [
        power_curve([0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1], domain=(-1, 0)),
        power_curve([0, 1], [0], [0, 0, 0, 0, 0], domain=(0, 1)),
    ]
    third = power_curve([1, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1], domain=(0, 1))
    last = Nurbs(4, [1] * 5 + [2] * 5, third.control_points)
    curve = chained(*[raised(c, 4) for c in (*ends, last)])
    found = analyse(curve)
    assert [p.parts for p in found.straight_pieces] == [p.parts for p in found.constant_pieces] == [((0, 1),)]
    assert found.planar_pieces == ()
    assert not found.torsion_zeros
    assert found.inflections.points == ()
    derived = derive("torsion", curve)
    assert [piece.interval for piece in derived.pieces] == [(-1, 0), (1, 2)]
    assert derived.missing[0][1] == "straight"


def test_planar_stretches_share_a_straight_piece():
    arcs = [
        power_curve([0, 1], [0, 0, 1], [0], domain=(-1, 0)),
        power_curve([0, 1], [0], [0, 0, 0], domain=(0, 1)),
        power_curve([0, 1], [0], [1, -2, 1], domain=(1, 2)),
    ]
    curve = chained(*[raised(c, 2) for c in arcs])
    assert [(str(piece), str(plane)) for piece, plane in planar_pieces(curve)] == [
        ("[-1, 1]", "z = 0"),
        ("[0, 2]", "y = 0"),
    ]
    assert [p.parts for p in analyse(curve).straight_pieces] == [((0, 1),)]


@pytest.mark.parametrize(
    "points", [[(0, 0, 0), (1, 2, 3)], [(0, 0, 0), (1, 1, 1), (2, 5, 2), (0, 0, 1)]], ids=["line", "polyline"]
)
def test_degree_one(points):
    knots = [0, *range(len(points)), len(points) - 1]
    found = analyse(Nurbs(1, knots, points))
    assert [p.parts for p in found.straight_pieces] == [((i, i + 1),) for i in range(len(points) - 1)]
    assert [answer.points for answer in places(found.curve).values()] == [()] * 4


@pytest.mark.parametrize("weights", [None, [1, 2, 1], [1, 1, 3]])
def test_degree_two_is_planar(weights):
    curve = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0, 1), (1, 3, 2), (2, 0, 5)], weights)
    found = analyse(curve)
    assert [p.parts for p, _ in found.planar_pieces] == [((0, 1),)]
    assert found.torsion_zeros.points == found.inflections.points == ()
    normal, offset = found.plane.normal, found.plane.offset
    assert all(sum(a * x for a, x in zip(normal, curve(t), strict=True)) == offset for t in (0, mpq(1, 3), 1))
    with pytest.raises(ShapeError, match="segments in planes"):
        derive("focal_curve", curve)


def test_a_closed_seam_is_a_knot_like_any_other():
    """A closed planar curve in space started at a vertex and elsewhere: the same extrema."""
    ellipse = example("ellipse_skew")
    curve = Nurbs(2, ellipse.knots, [(x, y, x + y) for x, y in ellipse.control_points], ellipse.weights)
    assert curve.closed
    at_vertices = Nurbs(2, ellipse.knots, [(2 * x, y, 3) for x, y in example("circle").control_points], ellipse.weights)
    assert [f.root.exact for f in analyse(at_vertices).critical_points] == [0, 1, 2, 3]
    assert len(analyse(curve).critical_points) == 4


def test_standing_still_and_starting_from_rest():
    still = Nurbs(1, [0, 0, 1, 2, 3, 3], [(0, 0, 0), (1, 0, 1), (1, 0, 1), (2, 0, 3)])
    assert [(f.kind, f.root.exact) for f in analyse(still).singular_points] == [("rest", 1), ("rest", 2)]
    assert analyse(still).singular_points
    start = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0, 0), (0, 0, 0), (1, 1, 0), (2, 0, 3)])
    assert [(f.kind, f.root.exact) for f in analyse(start).singular_points] == [("singular end", 0)]
    assert not [
        f
        for f in (*analyse(start).inflections, *analyse(start).torsion_zeros, *analyse(start).critical_points)
        if f.root == 0
    ]


def test_a_curve_in_a_coordinate_plane_is_a_plane_curve_too(tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    for axis, coordinates in ((2, "xy."), (0, ".xy"), (1, "y.x")):
        flat = example("rational_cubic")
        points = [tuple({"x": x, "y": y, ".": "1/3"}[c] for c in coordinates) for x, y in flat.control_points]
        curve = Nurbs(flat.degree, flat.knots, points, flat.weights, name="flat")
        assert plane_of(curve).axis == axis
        assert as_plane_curve(curve).control_points == flat.control_points
    file = tmp_path / "flat.json"
    file.write_text(
        json.dumps(
            {"degree": 3, "knots": [0] * 4 + [1] * 4, "control_points": [[0, 0, 5], [1, 2, 5], [3, -1, 5], [4, 1, 5]]}
        )
    )
    run = CliRunner().invoke
    assert "flat in the plane z = 5" in run(app, ["inspect", str(file)]).output
    data, flat = json.loads(run(app, ["inspect", str(file), "--json"]).output)["rows"]
    assert data["plane"] == "z = 5"
    assert [f["kind"] for f in flat["inflections"]["points"]] == ["inflection"]
    assert data["inflections"] == flat["inflections"] | {"points": data["inflections"]["points"]}
    assert [f["kind"] for f in data["inflections"]["points"]] == ["inflection"]
    rows = json.loads(run(app, ["prove", "--curve", str(file), "--json"]).output)["rows"]
    assert {row["curve"] for row in rows if row["id"].startswith("C4.1")} == {"flat in the plane z = 5"}
    rows = json.loads(run(app, ["formula", "degrees", "--curve", str(file), "--json"]).output)["rows"]
    assert list(dict.fromkeys(row["curve"] for row in rows)) == ["flat", "flat in the plane z = 5"]


@pytest.mark.parametrize("name", sorted(FOLLOWERS))
def test_every_claim_is_as_recorded_on_curves_with_such_joints(name):
    following = power_curve(*FOLLOWERS[name][0], domain=(0, 1))
    curve = chained(*[raised(c, max(following.degree, 3)) for c in (CUBIC, following)])
    rows = list(audit([claim for claim in claims() if claim.curve == "space"], [curve]))
    assert rows
    assert [(row.id, row.statement, str(row.witness)) for row in rows if not row.as_recorded] == []
