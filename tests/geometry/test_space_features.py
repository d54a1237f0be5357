"""Features of space curves: exactly known answers, agreement with the plane, invariance under similarities and
reversal, values, the command.
"""

import json

import mpmath
import pytest
from gmpy2 import mpq
from hypothesis import assume, given

from exactspline import Nurbs
from exactspline.errors import DomainError, FormulaError, ShapeError
from exactspline.geometry.analysis import analyse
from exactspline.geometry.inspection import Approach, compare_approaches, inspect_curve
from exactspline.geometry.kinds import JointKind
from exactspline.geometry.values_along import curvature, torsion
from exactspline.interchange.examples import example, example_names
from exactspline.papers import find
from tests.geometry.test_shared_curves import FILES, read_curve
from tests.support.command import invoke
from tests.support.space_curves import MIRRORED, TURNED, moved, power_curve
from tests.support.strategies import nurbs

SPACE = [name for name in example_names() if example(name).dimension == 3]
PLANE = [name for name in example_names() if example(name).dimension == 2]


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
            coefficient = mpmath.mpf(int(mpq(c).numerator)) / int(mpq(c).denominator)
            for order in range(3):
                if k >= order:
                    value[order] += coefficient * mpmath.ff(k, order) * s ** (k - order)
        first, second = [1, 2 * s, value[1]], [0, 2, value[2]]
        b = [first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2], 2]
        kappa = mpmath.sqrt(sum(x * x for x in b)) / mpmath.sqrt(sum(x * x for x in first)) ** 3
        assert abs(curvature(curve, found[1].root).significant(40) - kappa) < mpmath.mpf(10) ** -40
        assert abs(torsion(curve, found[1].root).significant(40)) < mpmath.mpf(10) ** -40


def embedded(curve, matrix):
    """A plane curve moved into space by two columns of a matrix."""
    points = [tuple(row[0] * x + row[1] * y for row in matrix) for x, y in curve.control_points]
    return Nurbs(curve.degree, curve.knots, points, curve.weights)


@pytest.mark.parametrize("matrix", [[[1, 0], [0, 1], [0, 0]], [[2, -1], [2, 2], [-1, 2]]], ids=["z = 0", "tilted"])
@pytest.mark.parametrize("name", PLANE)
def test_a_plane_curve_in_space_has_the_features_it_has_in_the_plane(name, matrix):
    curve = example(name)
    in_space = embedded(curve, matrix)
    skipped = [joint.parameter for joint in analyse(curve).joints if joint.kind is JointKind.CURVATURE_JUMP]
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


def check_agreement(curve):
    rows = {row.name: row for row in compare_approaches(curve)}
    assert not any(row.missing for row in rows.values())
    found = [[(f.kind, f.root) for f in inspect_curve(curve, approach).critical_points] for approach in Approach]
    assert all(one == found[0] for one in found)
    assert (
        curve.degree < 3
        or rows["minimal"].degree <= rows["reduced"].degree <= rows["direct"].degree <= rows["squaring"].degree
    )


@pytest.mark.parametrize("name", SPACE)
def test_all_approaches_agree_on_the_example_curves(name):
    check_agreement(example(name))


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_all_approaches_agree_on_real_curves(file):
    curve = read_curve(file)
    if curve.dimension == 3:
        check_agreement(curve)


@pytest.mark.parametrize(
    "name", ["rational_space_cubic", "rational_space_cubic_spline", "helix_like", "space_quartic", "flat_point"]
)
def test_curvature_is_extremal_where_it_says_so(name):
    """Exactly: κ² on both sides of an extremum, at rational parameters nearby, is beyond none."""
    curve = example(name)
    kappa = find("space_curvature_squared")(curve)
    a, b = curve.domain
    found = [f for f in analyse(curve).critical_points if f.kind != "stationary"]
    assert found
    for f in found:
        low, high = f.root.refine(12)
        h = mpq(1, 1000)
        if not a < low - h or not high + h < b:
            continue
        for t in (low - h, high + h):
            assert (kappa(t) < kappa((low + high) / 2)) == (f.kind == "maximum")


@given(nurbs(dimension=3, low=1, high=4))
def test_reflections_turn_the_sign_of_the_torsion(curve):
    mirrored = moved(curve, MIRRORED)
    turned, kept = find("D1_D2_D3")(mirrored), find("D1_D2_D3")(curve)
    assert turned == kept * -27
    assert [(f.root, f.root.signs) for f in analyse(mirrored).torsion_zeros] == [
        (f.root, tuple(None if s is None else -s for s in f.root.signs)) for f in analyse(curve).torsion_zeros
    ]


@given(nurbs(dimension=3, low=3, high=3, most=0))
def test_torsion_has_the_signs_that_its_zeros_tell(curve):
    """Between neighbouring zeros τ, evaluated exactly, has one sign: that of the zeros beside it."""
    tau = find("torsion_reduced")(curve)
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
    with pytest.raises(FormulaError, match="squaring, direct, reduced, lifted, minimal"):
        inspect_curve(example("twisted_cubic"), "best")
    cusp = power_curve([0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 0, 1])
    (singular,) = analyse(cusp).singular_points
    with pytest.raises(DomainError, match="γ′ = 0"):
        torsion(cusp, singular.root).significant(10)
    four = Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)])
    with pytest.raises(ShapeError, match="plane"):
        inspect_curve(four)


def test_inspect_prints_curvature_and_torsion(monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    result = invoke("inspect", "flat_point", "--digits", 30, "--approach", "all")
    assert result.exit_code == 0
    assert "torsion" in result.output
    assert "Approaches to critical curvature" in result.output
    data = json.loads(invoke("inspect", "flat_point", "--json").output)["rows"][0]
    (flat,) = data["inflections"]["points"]
    assert (flat["kind"], flat["parameter"], flat["curvature"], flat["torsion"]) == ("inflection", "1/2", "0", "2.0")
    assert data["torsion_zeros"]["points"] == []
