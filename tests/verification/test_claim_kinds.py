"""Every kind of claim on curves made for it, where what it must say is known."""

from dataclasses import replace

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, Verdict, decide, example, formula_of, paper, write
from exactspline.errors import ClaimError
from exactspline.readings import DegreeReading, parse_degree
from exactspline.verification.claims import all_claims, claims_of
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import DegreeFound
from exactspline.verification.kinds.degree import held_against
from exactspline.verification.ledger import audit
from exactspline.verification.statement import check, degree_of_cubic, dimension_of, sides
from tests.support.claims import claim
from tests.verification.test_own_paper import plane_formulas, written

T = BSpline.identity(0, 1)


def on(one, curve):
    return one.check(Evaluation(curve))


def curve(x, y, *more):
    """The curve with these coordinates over [0, 1]."""
    degree = max(x.degree, y.degree, *[z.degree for z in more])
    points = [f.elevate_degree(degree - f.degree).control_points for f in (x, y, *more)]
    return Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), list(zip(*points, strict=True)))


PARABOLA = curve(T, T * T)
#: γ′ = (t² − 1, 2t), of length t² + 1.
PYTHAGOREAN = curve(T * T * T * mpq(1, 3) - T, T * T)
LINE = curve(T, 2 * T)


def two_pieces():
    """A Pythagorean cubic, and from its end a parabola."""
    first = PYTHAGOREAN.control_points
    x, y = first[-1]
    second = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 3)]
    return Nurbs(3, [0] * 4 + [1] * 3 + [2] * 4, [*first, *second[1:]])


# ---- squares


def test_squares_are_counted_segment_by_segment():
    one = claim("C41d-curvature_squared-speed_squared")
    told = "speed_squared is a square up to a constant on {} segments"
    assert str(on(one, PYTHAGOREAN).computed) == told.format("1 of 1")
    assert str(on(one, PARABOLA).computed) == told.format("0 of 1")
    assert str(on(one, two_pieces()).computed) == told.format("1 of 2")
    assert on(one, LINE).verdict == Verdict.VACUOUS
    assert on(one, PARABOLA).verdict == Verdict.VERIFIED


def test_what_is_a_square_where_the_other_is_not_is_named():
    """On a parabola [γ′ γ″] = 2 is a square up to a constant, ‖γ′‖² = 1 + 4t² is not."""
    wrong = claim("N3-f2-speed_squared")
    found = on(wrong, PARABOLA)
    assert (found.verdict, str(found.witness)) == (Verdict.REFUTED, "on segment 0 one is a square and the other is not")
    assert on(replace(wrong, formula="speed_squared", right="f2"), PARABOLA).verdict == Verdict.REFUTED
    assert on(replace(wrong, formula="f2", right="f0"), PARABOLA).verdict == Verdict.VERIFIED
    (_, proof) = wrong.prove()
    assert proof.verdict == Verdict.REFUTED
    assert proof.witness is not None
    for pair in (("f2", "f2"),):
        with pytest.raises(ClaimError, match="both sides are one formula"):
            replace(wrong, formula=pair[0], right=pair[1])


# ---- coefficients, numbers


def test_the_first_coefficient_that_vanishes_is_named():
    """D1 of (t, t²) is (1, 2t), with the coefficients (1, 0), (1, 2); of a curve that stands first it is 0."""
    one = claim("C3f-D1")
    assert on(one, PARABOLA).verdict == Verdict.VERIFIED
    still = curve(T * T, T * T * T)
    found = on(one, still)
    assert (found.verdict, str(found.witness)) == (Verdict.REFUTED, "coefficient 0 of D1 on [0, 1] is 0")
    assert on(one, Nurbs(1, [0, 0, 1, 1], [(1, 1), (1, 1)])).verdict == Verdict.VACUOUS
    generic = claim("C3f-D1-generic").prove()[1]
    assert str(generic.computed).startswith("none vanishes for any d ≥ 1")


@pytest.mark.parametrize(
    ("key", "computed"),
    [
        ("Fig2-g2", "degree 12, 52 control points"),
        ("Fig3-evolute", "degree 26, 108 control points"),
        ("Fig1-g0", "degree 6, 42 control points"),
    ],
)
def test_numbers_are_told_with_what_they_count(key, computed):
    row = decide(claim(key))
    assert str(row.computed) == computed
    assert (row.witness is None) == (row.verdict == Verdict.VERIFIED)


@pytest.mark.parametrize(
    "one", [c for c in all_claims() if c.kind in ("count", "condition") and "point" not in c.curve], ids=lambda c: c.key
)
def test_examples_must_be_curves_of_which_the_claim_speaks(one):
    other = "twisted_cubic" if one.dimensions == (2,) else "circle"
    with pytest.raises(ClaimError, match="not a curve to which the claim applies"):
        replace(one, example=other, curve="plane" if other == "twisted_cubic" else "space")
    rational = not one.curve_named(one.example).polynomial
    with pytest.raises(ClaimError, match="not a curve to which the claim applies"):
        replace(one, of="polynomial" if rational else "rational")
    replace(one, of="rational" if rational else "polynomial")


def test_zeros_on_a_whole_segment_have_no_condition_number(tmp_path):
    """Passed before: "no zero in common" of forms that vanish on one segment; VERIFIED for the other zeros alone."""
    bodies = {"bend": "det(c.gamma.d(1), c.gamma.d(2))", "longer": "det(c.gamma.d(1), c.gamma.d(2)) * c.p[0]"}
    written(tmp_path / "paper", plane_formulas(**bodies), [])
    (tmp_path / "paper" / "curves").mkdir()
    points = [(1, 0), (2, 0), (3, 0), (4, 0), (5, 2), (6, -3), (7, 1)]
    bent = Nurbs(3, [0] * 4 + [1] * 3 + [2] * 4, points)
    write(bent, tmp_path / "paper" / "curves" / "bent.json")
    given = {"curve": "plane", "statement": "said", "kind": "condition", "of": "polynomial"}
    sides = [("bend", "longer"), ("longer", "bend")]
    claims = [
        given | {"id": f"K{k}{name}", "example": name, "left": left, "right": right}
        for name in ("straight_between_arcs", "bent")
        for k, (left, right) in enumerate(sides)
    ]
    written(tmp_path / "paper", plane_formulas(**bodies), claims)
    found = [one.prove()[1] for one in claims_of(paper(tmp_path / "paper"))]
    assert [one.verdict for one in found[:2]] == [Verdict.UNDECIDED] * 2
    assert str(found[0].witness).startswith("a side vanishes on a whole segment")
    assert sorted(one.verdict for one in found[2:]) == [Verdict.REFUTED, Verdict.UNDECIDED]


# ---- existence


def test_what_is_rational_is_told_with_its_degree():
    one = claim("N9-torsion")
    cubic = example("twisted_cubic")
    found = on(one, cubic)
    value = formula_of("torsion")(cubic)
    assert found.verdict == Verdict.REFUTED
    assert str(found.computed) == f"rational of degree {value.degree}"
    assert str(found.witness) == "torsion is a quotient of polynomials in the curve, and is torsion_by_frenet"


def test_any_formula_does_not_refute_that_something_is_not_rational():
    """Passed before: "the torsion is not rational" was refuted by D1, by f2, by whatever formula was named."""
    one = claim("N9-torsion")
    for other in ("D1", "velocity_acceleration_jerk", "binormal_squared"):
        wrong = replace(one, formula=other)
        assert wrong.prove()[1].verdict == Verdict.UNDECIDED
        assert on(wrong, example("twisted_cubic")).verdict == Verdict.UNDECIDED
    with pytest.raises(ClaimError, match="given as its own definition"):
        replace(one, definition="torsion")


def test_what_is_rational_is_nothing_on_a_line():
    one = claim("N9-torsion")
    line = curve(T, T, T)
    assert on(one, line).verdict == Verdict.INAPPLICABLE


# ---- degrees


def test_sizes_are_degrees_at_three_and_sides_are_read_in_the_dimension_of_the_claim():
    one = claim("C42c-g2-g1")
    assert degree_of_cubic("g2", one) == 9 * 3 - 6
    assert degree_of_cubic("g1", one) == DegreeReading().of(formula_of("g1"), 2).degree.at({"d": 3})
    assert dimension_of(formula_of("g2"), one) == 2
    assert dimension_of(formula_of("D1"), claim("C52a-torsion-torsion_reduced")) == 3
    assert [side.role for side in sides(claim("C41a-f1-f2"))] == ["naive", "reduced"]
    assert [side.role for side in sides(claim("C41b-f0-f1-f2"))] == ["naive", "formula", "reduced"]
    assert [side.name for side in sides(claim("C41b-f0-f1-f2"))] == ["f0", "f1", "f2"]
    polynomial = replace(one, of="polynomial")
    assert degree_of_cubic("g2", polynomial) == DegreeReading().of(formula_of("g2"), 2, polynomial=True).degree.at(
        {"d": 3}
    )


@pytest.mark.parametrize(
    ("computed", "claimed", "verdict"),
    [("max(d1 + d2, d2 + 2)", "d1 + d2", Verdict.REFUTED), ("d1 + d2", "d1 + d2", Verdict.PROVED)],
)
def test_an_exception_for_equal_degrees_says_nothing_about_unequal_ones(computed, claimed, verdict):
    # at d1 = d2 = 1 the degree is lower than computed; at d1 = 1, d2 = 5 the first one is 7, not 6
    one = replace(claim("T7-degree"), claimed=claimed)
    assert one.least_d == 1
    assert held_against(one, DegreeFound(parse_degree(computed)), {1: 2}).verdict == verdict


def test_checks_are_python_that_runs(capsys):
    """Two or three lines each, of every kind; what they print is what is told."""
    printed = {}
    for one in all_claims():
        if one.status == "printed" and one.expected == Verdict.REFUTED and one.kind not in printed:
            lines = check(one)
            assert len(lines) in (2, 3)
            exec("\n".join(lines), {})
            printed[one.kind] = capsys.readouterr().out.strip()
    assert all(printed.values())
    assert "identity" in printed


# ---- rows


def test_rows_tell_what_was_asked_of_whom():
    (row,) = audit([claim("C41a-f1-f2")], [PARABOLA])
    assert (row.reading, row.curve, row.verdict) == ("spline", "(unnamed curve)", Verdict.VERIFIED)
    assert str(row.factor) == "w = 1 (polynomial: w = 1)"
    assert row.expected == (Verdict.VERIFIED,)
    assert row.as_recorded
    (flat,) = audit([claim("C41a-f1-f2")], [LINE])
    assert flat.verdict == Verdict.VACUOUS
    assert flat.as_recorded
    meant = next(c for c in all_claims() if c.status == "meant")
    assert decide(meant).statement == f"{meant.statement} (corrected)"
    printed = claim("C41a-f1-f2")
    assert decide(printed).statement == printed.statement
    assert decide(printed).expected == ("PROVED",)
    refuted = claim("N3-f2-speed_squared")
    (row,) = audit([refuted], [PARABOLA])
    assert row.expected == (Verdict.REFUTED, Verdict.VERIFIED)
