"""Derived objects on degenerate input: a clear answer each."""

import pytest
from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.errors import FormulaError, ShapeError
from exactspline.geometry.constructions import Absence, Variant
from exactspline.geometry.curvature import curvature_function
from exactspline.geometry.derived import derive
from exactspline.interchange.examples import example
from exactspline.papers import find


def test_circle_has_constant_curvature():
    assert find("g2")(example("circle")).is_zero
    assert all(
        piece.value(piece.interval[0]) == 1 and piece.radicand == 1 for piece in curvature_function(example("circle"))
    )


@pytest.mark.parametrize("name", ["straight_line", "straight_cubic"])
def test_a_straight_line_has_no_evolute(name):
    assert all(piece.value.is_zero for piece in curvature_function(example(name)))
    with pytest.raises(ShapeError, match="straight"):
        derive("evolute", example(name))


def test_a_curve_with_one_straight_segment_has_an_evolute_on_the_others():
    evolute = derive("evolute", example("straight_between_arcs"))
    assert [piece.interval for piece in evolute.pieces] == [(0, 1), (2, 3)]
    assert evolute.missing == (((mpq(1), mpq(2)), Absence.STRAIGHT),)
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
        assert "not on [1, 2]: the curve is straight" in row.text
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
    speed = find("speed_squared")(curve)
    (piece,) = curvature_function(curve)
    assert piece.value is not None
    for t in (mpq(0), mpq(1, 3), mpq(1)):
        value = piece.value(t)
        f = find("f2")(curve)(t)
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
