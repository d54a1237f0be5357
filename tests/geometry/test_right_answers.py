"""Answers that were once wrong: each as the example that showed it, against what is true."""

import json

import mpmath
import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, analyse, curvature, torsion
from exactspline.geometry.curves import values as values_along
from exactspline.papers.chen_riesenfeld_cohen_2007.figures import compare_approaches
from exactspline.tables import curvature_function
from tests.support.command import invoke
from tests.support.space_curves import power_curve
from tests.support.vectors import mpf_of


@pytest.mark.parametrize("sign", [1, -1])
def test_both_ways_to_the_curvature_agree_with_its_definition(sign):
    """Of the cubic with hodograph (1 + 2it)², by κ = [γ′ γ″]/‖γ′‖³, whatever the weights."""
    cubic = power_curve([0, 1, 0, mpq(-4, 3)], [0, 0, 2], domain=(0, 1))
    for order in (1, -1):
        points = cubic.control_points[::order]
        curve = Nurbs(3, cubic.knots, points, [sign] * 3 + [sign])
        rational = Nurbs.from_homogeneous(4, [0] * 5 + [1] * 5, elevated_with(points, [mpq(sign), mpq(3 * sign)]))
        (piece,) = curvature_function(rational)
        for t in (mpq(0), mpq(1, 3), mpq(2, 5)):
            v, a = (
                [tuple(x.d(k)(t) for x in cubic.p) for k in (1, 2)]
                if order == 1
                else [tuple((-1) ** k * x.d(k)(1 - t) for x in cubic.p) for k in (1, 2)]
            )
            true = (v[0] * a[1] - v[1] * a[0]) / (1 + 4 * (t if order == 1 else 1 - t) ** 2) ** 3
            assert values_along.curvature(curve, t) == values_along.curvature(rational, t) == true
            assert piece.radicand == 1
            assert piece.value(t) == true


def test_the_curvature_of_a_curve_that_turns_back_changes_its_sign():
    """Passed before: κ has one sign where γ′ = 0 cancels; of t ↦ γ(t²) that of a single sample, wrong on one side."""
    there, back = (
        power_curve([0, 0, 0, 1, *[0] * 5, mpq(-4, 3)], [*[0] * 6, 2]),
        power_curve([0, 0, 1, 0, 0, 0, mpq(-4, 3)], [*[0] * 4, 2]),
    )
    (piece,) = curvature_function(back)
    assert piece.value is None
    assert "turns back" in piece.reason
    assert values_along.curvature(back, mpq(1, 2)) == -values_along.curvature(back, mpq(-1, 2)) != 0
    (piece,) = curvature_function(there)
    assert all(piece.value(t) == values_along.curvature(there, t) != 0 for t in (mpq(-1, 2), mpq(1, 3)))


def elevated_with(points, weights):
    """Homogeneous points of a polynomial cubic times a linear function with these Bézier points."""
    w = BSpline.bezier(weights)
    rows = [BSpline.bezier([p[i] for p in points]) * w for i in range(2)] + [w.elevate_degree(3)]
    return list(zip(*[row.control_points for row in rows], strict=True))


def absolute_cube():
    """y = |t|³ on [−1, 1] as a cubic spline."""
    points = [(-1, 1), (mpq(-2, 3), 0), (mpq(-1, 3), 0), (0, 0), (mpq(1, 3), 0), (mpq(2, 3), 0), (1, 1)]
    return Nurbs(3, [-1] * 4 + [0] * 3 + [1] * 4, points)


def test_squaring_loses_no_extremum_where_the_curvature_vanishes_at_a_knot():
    """κ = 6|t|/(1 + 9t⁴)^(3/2) is least at 0, where κ′ jumps from −6 to 6, and greatest where 45 t⁴ = 1."""
    curve = absolute_cube()
    for t in (mpq(-1, 2), mpq(1, 3)):
        assert curve(t) == (t, abs(t) ** 3)
    found = analyse(curve).critical_points
    assert [(f.kind, f.of_absolute, f.by_jump) for f in found] == [
        ("maximum", "maximum", False), ("minimum", "minimum", True), ("maximum", "maximum", False)
    ]  # fmt: skip
    assert found[1].root == 0
    assert found[2].root.minimal_polynomial() == [-1, 0, 0, 0, 45]
    assert [(row.extraneous, row.missing) for row in compare_approaches(curve)] == [(0, 0)] * 5


def test_an_approach_that_loses_extrema_is_told():
    """The count of what is missing is not zero by convention: a form with the zero at the knot alone misses two, one
    with zeros of its own has extraneous ones.
    """
    curve = absolute_cube()
    analysis, t = analyse(curve), BSpline.identity(-1, 1)
    for form, counts in ((t, (0, 2)), (t - mpq(1, 7), (1, 3)), (t.constant(1), (0, 3))):
        analysis._known["critical_curvature", "squaring"] = analysis.solved(lambda form=form: form)
        by_name = {row.name: (row.extraneous, row.missing) for row in compare_approaches(curve)}
        assert by_name["squaring"] == counts
        assert by_name["direct"] == (0, 0)


def test_a_torsion_that_vanishes_is_zero(tmp_path):
    """(u, u², u⁴) with u = t² − ½ has τ = 0 exactly where t = ±√½."""
    u = BSpline.identity(-1, 1) * BSpline.identity(-1, 1) - mpq(1, 2)
    powers = [u, u * u, u * u * u * u]
    points = zip(*[x.elevate_degree(8 - x.degree).control_points for x in powers], strict=True)
    curve = Nurbs(8, [-1] * 9 + [1] * 9, list(points))
    found = analyse(curve).torsion_zeros
    assert [f.kind for f in found] == ["torsion zero"] * 2
    for f in found:
        assert f.root.exact is None
        assert torsion(curve, f.root).significant(20) == 0
    data = json.loads(invoke("inspect", written(curve, tmp_path), "--json").output)["rows"][0]
    assert [x["exact"] for f in data["torsion_zeros"]["points"] for x in f["torsion"]] == ["0", "0"]


def written(curve, folder):
    """A file with the curve."""
    file = folder / "curve.json"
    file.write_text(
        json.dumps(
            {
                "degree": curve.degree,
                "knots": [str(t) for t in curve.knots],
                "control_points": [[str(x) for x in p] for p in curve.control_points],
            }
        )
    )
    return file


@pytest.mark.parametrize("scale", [mpq(10) ** 80, mpq(1, 10**80), mpq(1)], ids=["huge", "tiny", "as it is"])
def test_digits_of_small_curvatures_are_their_own(scale):
    """An ellipse with the half axes 2s and s at irrational vertices: κ there is 2/s and 1/(4s), whatever s."""
    from exactspline import example

    skew = example("ellipse_skew")
    scaled = Nurbs(2, skew.knots, [(x * scale, y * scale) for x, y in skew.control_points], skew.weights)
    with mpmath.workdps(60):
        size = mpf_of(scale)
        for a, b in zip(analyse(skew).curvature_extrema, analyse(scaled).curvature_extrema, strict=True):
            first, second = curvature(skew, a.root).significant(40), curvature(scaled, b.root).significant(40)
            assert a.root.exact is None
            assert abs(second * size / first - 1) < mpmath.mpf(10) ** -38


def test_a_near_cusp_of_any_size_prints_its_own_digits(tmp_path):
    """(t, t²) stretched: κ = 2h/(1 + 4h²t²)^(3/2)/s at its vertex is 2h/s."""
    for size in (0, 80):
        s, h = mpq(10) ** size, mpq(1, 10) ** 20
        curve = power_curve([0, s], [0, 0, -h * s], domain=(-1, 1))
        (f,) = analyse(curve).curvature_extrema
        data = json.loads(invoke("inspect", written(curve, tmp_path), "--json").output)["rows"][0]["critical_points"][
            "points"
        ]
        assert f.root == 0
        assert data[0]["curvature"][0]["exact"] == f"-1/{5 * 10 ** (19 + size)}"


def test_a_rest_does_not_depend_on_idle_knots():
    knots = [0, 0, 1, 2, 3, 3]
    points = [(0, 0), (1, 0), (1, 0), (2, 5)]
    plain = Nurbs(1, knots, points)
    idle = Nurbs(1, [0, 0, 1, mpq(4, 3), mpq(3, 2), 2, 3, 3], [*points[:2], (1, 0), (1, 0), *points[2:]])
    for curve in (plain, idle):
        assert [(f.kind, f.root.exact) for f in analyse(curve).singular_points] == [("rest", 1), ("rest", 2)]
        assert [str(piece) for piece in analyse(curve).standing_pieces] == ["[1, 2]"]
        assert [str(piece) for piece in analyse(curve).straight_pieces] == ["[0, 1]", "[2, 3]"]
    assert [joint.kind for joint in analyse(idle).joints][1:3] == ["standing still"] * 2


def test_standing_still_across_the_seam():
    triangle = [(0, 0), (0, 0), (1, 0), (0, 1), (0, 0), (0, 0)]
    found = analyse(Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 5], triangle))
    assert [str(piece) for piece in found.standing_pieces] == ["[4, 5] ∪ [0, 1]"]
    assert [(f.kind, f.root.exact) for f in found.singular_points] == [("rest", 1), ("rest", 4)]
    point = analyse(Nurbs(1, [0, 0, 1, 2, 2], [(3, 4)] * 3))
    assert [str(piece) for piece in point.standing_pieces] == ["[0, 2]"]
    assert [*point.singular_points, *point.straight_pieces, *point.corners] == []


def test_the_sign_of_the_curvature_at_roots_of_other_forms():
    """Held against the value at a nearby parameter, and against the definition at knots."""
    from exactspline import example, examples

    for name in examples("curves"):
        curve = example(name)
        if curve.dimension != 2:
            continue
        for f in (*analyse(curve).curvature_extrema, *analyse(curve).inflections):
            if f.root.at_knot:
                continue
            low, high = f.root.refine(25)
            value = values_along.curvature(curve, (low + high) / 2)
            sign = curvature(curve, f.root).sign
            assert sign == (0 if abs(value) < mpq(1, 10**15) else (value > 0) - (value < 0))
