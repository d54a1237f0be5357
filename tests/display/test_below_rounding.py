"""What only rounded numbers add to a circle or a sphere is one row, and no feature that stays is in it."""

import json

import pytest

import exactspline as xs
from tests.support.command import invoke

#: Circles whose weights are rounded square roots, and one that is exact.
ROUNDED = xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, "0.70710678118654752", 1], name="rounded")


@pytest.fixture
def written(tmp_path):
    def write(curve):
        xs.write([curve], tmp_path / "curve.json")
        return str(tmp_path / "curve.json")

    return write


def test_a_quarter_of_a_circle_in_decimals(written):
    """An extremum of the curvature before, above the row *circle*."""
    file = written(ROUNDED)
    rows = [line.split() for line in invoke("inspect", file, "--csv").output.splitlines()[1:]]
    assert "circle" in rows[0][0]
    assert "1 feature below the rounding" in " ".join(rows[1])
    assert "minimum" in invoke("inspect", file, "--all", "--csv").output.splitlines()[1]
    (row,) = json.loads(invoke("inspect", file, "--json").output)["rows"]
    assert [point["below_rounding"] for point in row["critical_points"]["points"]] == [True]


@pytest.mark.parametrize("change", ["1/1000", "1e-7"])
def test_a_feature_that_all_curves_near_it_have_is_listed(change, written):
    """It would be hidden if every curve near a circle were taken for one."""
    moved = xs.Nurbs(
        2, [0, 0, 0, 1, 1, 1], [(1, 0), (1, 1), (0, 1)], [1, xs.rational("0.70710678") + xs.rational(change), 1]
    )
    facts = xs.analyse(moved)
    assert not any(map(facts.below_rounding, facts.critical_points))
    assert "below the rounding" not in invoke("inspect", written(moved)).output


def test_no_other_curve_is_a_circle():
    for name in xs.examples("curves"):
        facts = xs.analyse(xs.example(name))
        if facts.curve.dimension in (2, 3):
            assert not facts.rounding, name


def test_a_sphere_in_doubles_has_no_umbilics_to_be_listed():
    """Twenty before; the decimals are those of a sphere of radius 1."""
    sphere = xs.example("sphere")
    points = [[list(point) for point in row] for row in sphere.control_points]
    points[3][1][0] += xs.rational("1e-17")
    facts = xs.analyse(xs.NurbsSurface(sphere.degree, *sphere.knots, points, sphere.weights))
    assert 0 < facts.rounding < xs.rational("1e-16")
    assert len(facts.umbilics_below_rounding) == len(facts.umbilics) > 0
    assert xs.analyse(sphere).umbilics_below_rounding == ()
