"""Claims of types: polynomial, rational, not rational; and of what an equation can be cited for."""

from dataclasses import replace

import pytest
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, Verdict, claims
from exactspline.errors import ClaimError
from exactspline.verification.evaluation import Evaluation
from tests.support.claims import stated

T = BSpline.identity(0, 1)


def claim(key, **fields):
    (found,) = claims(key)
    return replace(found, expected="PROVED", error="", status="ours", **fields)


def verdict(key, **fields):
    return claim(key, **fields).prove()[1].verdict


def curve(*coordinates):
    """The curve with these coordinates over [0, 1]."""
    degree = max(x.degree for x in coordinates)
    points = [f.elevate_degree(degree - f.degree).control_points for f in coordinates]
    return Nurbs(degree, [0] * (degree + 1) + [1] * (degree + 1), list(zip(*points, strict=True)))


PARABOLA = curve(T, T * T)
#: γ′ = (t² − 1, 2t), of length t² + 1.
PYTHAGOREAN = curve(T * T * T * mpq(1, 3) - T, T * T)
SPEED, ROW = "C41d-speed", "T3-T3-rational"


@pytest.mark.parametrize("row", range(1, 18))
def test_each_row_of_table_1_has_one_type(row):
    (key,) = [c.key for c in claims(f"T{row}") if c.kind == "type" and "minus" not in c.key]
    own = claim(key).claimed
    for other in ("polynomial", "rational", "not rational"):
        assert verdict(key, claimed=other) == (Verdict.PROVED if other == own else Verdict.REFUTED)


@pytest.mark.parametrize("key", [SPEED, "E13-unit_normal", "C51a-curvature_in_space", "E19-focal_third_term"])
def test_what_has_a_root_is_not_rational(key):
    assert verdict(key) == Verdict.PROVED
    assert verdict(key, claimed="rational") == verdict(key, claimed="polynomial") == Verdict.REFUTED


@pytest.mark.parametrize("key", ["C51a-normal_by_curvature", "C51a-curvature_times_unit_normal"])
def test_roots_that_cancel_leave_a_rational_function(key):
    assert verdict(key) == Verdict.PROVED
    told = claim(key, claimed="not rational").prove()[1]
    assert (told.verdict, str(told.computed)) == (Verdict.REFUTED, "rational")


def test_a_denominator_that_divides_out_is_none():
    assert verdict("C42c-g2") == Verdict.PROVED
    assert verdict("C42c-g2", claimed="rational") == Verdict.REFUTED
    assert verdict("C42k-g0", claimed="rational") == Verdict.REFUTED
    assert verdict("C42k-g0", of="rational") == Verdict.REFUTED


def test_the_speed_is_rational_on_a_pythagorean_curve_and_on_no_other():
    one = claim(SPEED)
    assert one.type_on(PARABOLA) == "not rational"
    assert one.type_on(PYTHAGOREAN) is None  # its root is rational: the reading over roots leaves it open
    assert one.examine(None, Evaluation(PARABOLA)).verdict == Verdict.VERIFIED
    assert one.examine(None, Evaluation(PYTHAGOREAN)).verdict == Verdict.UNDECIDED


def test_a_special_curve_decides_nothing_and_a_contrary_one_refutes():
    evolute = claim("E12-evolute")
    assert evolute.check(PARABOLA).verdict in (Verdict.VERIFIED, Verdict.INAPPLICABLE)
    assert claim("C41c-f0-type", claimed="rational").check(PARABOLA).verdict == Verdict.INAPPLICABLE
    assert claim("E9-curvature_squared", claimed="polynomial").check(PARABOLA).verdict == Verdict.REFUTED
    assert claim("E9-curvature_squared").check(PARABOLA).verdict == Verdict.VERIFIED


def test_zero_has_no_type():
    assert verdict("C42c-g2", formula="bracket_of_p_with_itself") == Verdict.VACUOUS


def test_types_are_of_functions_of_curves():
    with pytest.raises(ClaimError, match="types of 'surface' are not decided"):
        stated("type", source="surfaces", curve="surface", formula="E", claimed="rational")


def test_an_equation_of_plane_curves_cannot_be_cited_for_space_curves():
    wrong = claim("C55a-signed_curvature").prove()[1]
    assert (wrong.verdict, str(wrong.computed)) == (Verdict.REFUTED, "its arguments are of the kind 'framed plane'")
    assert verdict("C55a-curvature_in_space") == Verdict.PROVED
    assert verdict("C55a-signed_curvature", curve="framed plane", assumes=()) == Verdict.PROVED
    assert verdict("C55a-signed_curvature", formula="speed") == Verdict.PROVED


@pytest.mark.parametrize("one", [c for c in claims() if c.kind == "type"], ids=lambda c: c.key)
def test_no_value_is_proved_to_be_of_two_types(one):
    """A false statement near every claim: the same of another type."""
    proved = [
        each for each in ("polynomial", "rational", "not rational") if verdict(one.key, claimed=each) == Verdict.PROVED
    ]
    assert len(proved) <= 1
