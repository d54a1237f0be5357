"""Derived objects on degenerate input: a clear answer each."""

from contextlib import suppress
from itertools import pairwise, product

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline, ExactSplineError, Nurbs, derive, example, formula_of
from exactspline.errors import DomainError, FormulaError, ShapeError
from exactspline.geometry.derived.derive import intervals_where
from exactspline.language import numerator
from exactspline.papers import all_formulas
from exactspline.tables import Variant, curvature_function, derived_data
from tests.support.command import run
from workshop.vectors.items import items


def test_circle_has_constant_curvature():
    assert formula_of("g2")(example("circle")).is_zero
    assert all(
        piece.value(piece.interval[0]) == 1 and piece.radicand == 1 for piece in curvature_function(example("circle"))
    )


@pytest.mark.parametrize("name", ["straight_line", "straight_cubic"])
def test_a_straight_line_has_no_evolute(name):
    assert all(piece.value.is_zero for piece in curvature_function(example(name)))
    with pytest.raises(ShapeError, match="straight"):
        derive("evolute", example(name))


@pytest.mark.parametrize("stop", [0, 1])
def test_each_part_without_an_evolute_has_its_own_reason(stop):
    """Passed before: "the curve is straight on its whole domain" where it stands still on half of it."""
    points = [(0, 0), (1, 0), (2, 0), (2, 0), (2, 0)]
    curve = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], points[:: -1 if stop else 1])
    with pytest.raises(ShapeError) as refused:
        derive("evolute", curve)
    still = f"on [{1 - stop}, {2 - stop}] the velocity vanishes identically"
    assert still in refused.value.problem
    assert f"on [{stop}, {stop + 1}] the curvature vanishes identically" in refused.value.problem
    arc = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [*points, (3, 1), (3, 2)])
    assert [reason for _, reason in derive("evolute", arc).missing] == ["straight", "still"]
    with pytest.raises(ShapeError, match="stands still") as refused:
        derive("evolute", arc)("3/2")
    assert "straight" not in str(refused.value)


def test_a_curve_with_one_straight_segment_has_an_evolute_on_the_others():
    evolute = derive("evolute", example("straight_between_arcs"))
    assert [piece.interval for piece in evolute.pieces] == [(0, 1), (2, 3)]
    assert evolute.missing == (((mpq(1), mpq(2)), "straight"),)
    assert evolute.variant is Variant.MINIMAL
    assert evolute("1/2") == derive("evolute", example("straight_between_arcs"), "naive")("1/2")
    with pytest.raises(ShapeError, match="straight"):
        evolute("3/2")


def test_degrees_of_what_exists_in_pieces_are_those_of_the_pieces():
    """No −1 and no 0 for what does not exist: the pieces, and the reason for the gap."""
    from exactspline.verification.degree_tables import construction_table

    def rows(curve):
        return [row for row in (call() for call in construction_table(curve)) if row.formula == "evolute"]

    found = derive("evolute", example("straight_between_arcs"))
    for row in rows(example("straight_between_arcs")):
        assert row.true == found.true_degree == 3
        assert row.text == found.existence
        assert "not on [1, 2]: the curvature vanishes identically" in row.text
    assert rows(example("straight_between_arcs"))[-1].control_points == found.control_points == 8
    for row in rows(example("straight_line")):
        assert (row.represented, row.true, row.control_points) == (None, None, None)
        assert "straight" in row.text


def test_cusps_and_doubled_points_are_no_obstacle():
    for name in ("cusp", "doubled_points", "jump", "unclamped"):
        for variant in ("naive", "paper", "minimal"):
            assert derive("evolute", example(name), variant).pieces
        assert derive("critical_curvature", example(name)).pieces[0].value.degree <= 5


def test_curvature_of_a_pythagorean_hodograph_is_rational():
    curve = example("ph_quintic")
    speed = formula_of("speed_squared")(curve)
    (piece,) = curvature_function(curve)
    assert piece.value is not None
    for t in (mpq(0), mpq(1, 3), mpq(1)):
        value = piece.value(t)
        f = formula_of("f2")(curve)(t)
        assert piece.radicand * value**2 * speed(t) ** 3 == f**2
        assert (value > 0) == (f > 0)


def test_curvature_with_a_square_root():
    """A circular arc of squared radius 2: κ = 1/√2."""
    arc = Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 1), (0, 2), (-1, 1)], weights=[1, 1, 2])
    (piece,) = curvature_function(arc)
    assert piece.value is not None
    assert piece.radicand * piece.value(mpq(1, 3)) ** 2 == mpq(1, 2)
    assert piece.radicand == 2


def test_names_forms_and_dimensions_are_checked():
    with pytest.raises(FormulaError, match="there is no formula called"):
        derive("involute", example("circle"))
    with pytest.raises(FormulaError, match="variants are naive, paper, lifted, minimal"):
        derive("evolute", example("circle"), "best")
    with pytest.raises(ShapeError, match="plane curve"):
        derive("evolute", example("twisted_cubic"))
    with pytest.raises(ShapeError, match="in the plane"):
        curvature_function(example("twisted_cubic"))


@given(st.lists(st.booleans(), min_size=1, max_size=8))
def test_intervals_are_maximal(holds):
    """Neighbours are one; what is inside is exactly where it holds."""
    breaks = [mpq(k * k) for k in range(len(holds) + 1)]
    found = intervals_where(breaks, holds)
    assert all(a[1] < b[0] for a, b in pairwise(found))
    for (a, b), here in zip(pairwise(breaks), holds, strict=True):
        assert here == any(low <= a and b <= high for low, high in found)


def test_curvature_where_the_speed_is_a_polynomial_and_where_it_is_none():
    """Of (t − t³/3, t²) it is 2/(1 + t²)²; with γ′ = t (1 − t², 2t) there is a pole, and a cubic has no such speed."""
    t = BSpline.identity(-1, 1)

    def on(x, y):
        return curvature_function(Nurbs.from_splines([x, y]))[0]

    for sign in (1, -1):
        told = on(t - t**3 * mpq(1, 3), t * t * sign)
        assert [told.value(x) for x in (-1, 0, mpq(1, 2))] == [mpq(sign, 2), 2 * sign, sign * mpq(32, 25)]
        assert told.radicand == 1
    for none in (on(t**2 * mpq(1, 2) - t**4 * mpq(1, 4), t**3 * mpq(2, 3)), *curvature_function(example("cubic_s"))):
        assert (none.radicand, none.value) == (0, None)
        assert none.reason


def test_a_derived_object_has_the_values_of_its_pieces():
    curve = example("rational_cubic")
    point, number = derive("evolute", curve)(mpq(1, 3)), derive("zero_curvature", curve)(mpq(1, 3))
    assert isinstance(point, tuple)
    assert len(point) == 2
    assert number == derive("zero_curvature", curve).pieces[0].value(mpq(1, 3))


POLES = [
    ("evolute", "cubic_s", ["1/2"]), ("circle_centres", "flat_point", ["1/2"]), ("focal_curve", "flat_point", ["1/2"]),
    ("curvature_squared", "cusp", ["1/2"]), ("evolute", "six_segment_cubic", ["(-7 + √159)/2", "(31 - √321)/4"]),
    ("evolute", "circle", []), ("evolute", "cusp", []), ("torsion", "twisted_cubic", []), ("f2", "cubic_s", []),
]  # fmt: skip


@pytest.mark.parametrize(("what", "name", "expected"), POLES, ids=[f"{what} of {name}" for what, name, _ in POLES])
def test_poles_are_places_of_the_answer(what, name, expected):
    """Passed: "on [0, 1]" without an exception, and a ZeroDivisionError at 1/2."""
    for variant in ("minimal", "naive"):
        found = derive(what, example(name), variant)
        assert [pole.closed_form for pole in found.poles] == expected
        assert [pole["exact"] for pole in derived_data(found, name)["poles"]] == expected
        assert all(form in found.existence and f"at {form}" in found._repr_html_() for form in expected)
        assert ("pole" in found.existence) == ("pole" in found._repr_html_()) == bool(expected)
        for form in expected:
            if "√" not in form:
                with pytest.raises(DomainError, match=f"{what} has a pole at the parameter {form}"):
                    found(form)


def test_the_oracle_names_poles():
    told = [item for item in items(example("six_segment_cubic"), "evolute") if item.what == "pole"]
    assert [item.values["parameter"].closed_form for item in told] == POLES[4][2]


def test_where_a_form_as_written_is_0_by_0_there_is_the_value():
    """Passed: a ZeroDivisionError for the naive evolute at a cusp, where the evolute in lowest terms has a point."""
    assert derive("evolute", example("cusp"), "naive")("1/2") == derive("evolute", example("cusp"))("1/2")


@pytest.mark.parametrize("name", ["parabola", "straight_line", "space_line", "twisted_cubic"])
def test_what_vanishes_has_a_degree_and_control_points_like_any_spline(name):
    """Passed: jerk, D3, D21 of a parabola with the degree −1 and without control points, of a line with −2."""
    vanishing = 0
    for formula, variant in product(all_formulas().values(), ("minimal", "naive")):
        with suppress(ExactSplineError):  # of another dimension, or existing nowhere
            found = derive(formula, example(name), variant)
            [data] = derived_data(found, name)["pieces"]
            assert data["degree"] == found.degree >= 0
            assert data.get("control_points") or data["homogeneous_control_points"]
            vanishing += numerator(found.pieces[0].value).is_zero
    assert vanishing > 3


def test_a_derivative_that_vanishes_can_be_inspected(tmp_path):
    """Was refused: "control_points: is not a list of points"."""
    assert run("derive", "jerk", "parabola", "-o", tmp_path / "jerk.json").returncode == 0
    assert "stands still" in run("inspect", tmp_path / "jerk.json").stdout
