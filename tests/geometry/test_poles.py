"""Curves through infinity: poles are named, and what lies between them is found."""

from math import isclose

import pytest

from exactspline import Nurbs, analyse, derive, example
from exactspline.errors import ShapeError
from exactspline.geometry.curves.poles import between_poles


def test_the_evolute_of_figure_1_has_a_cusp_at_every_extremum_and_a_pole_at_every_inflection():
    curve = example("six_segment_cubic")
    own, facts = between_poles(derive("evolute", curve)), analyse(curve)
    assert [pole == each.root for pole, each in zip(own.poles, facts.inflections, strict=True)] == [True, True]
    assert [t == each.root for t, each in zip(own.reversals, facts.curvature_extrema, strict=True)] == [True] * 8


def test_pieces_are_the_evolute_and_meet_no_pole():
    curve = example("six_segment_cubic")
    whole = derive("evolute", curve).pieces[0].value
    own = between_poles(derive("evolute", curve))
    ends = [t for piece in own.pieces for t in piece.domain]
    assert ends == sorted(ends)
    assert (ends[0], ends[-1]) == curve.domain
    assert [(a, b) for a, b in zip(ends[1::2], ends[2::2], strict=False)] == [(a, b) for a, b in own.around]
    for piece in own.pieces:
        middle = sum(piece.domain) / 2
        assert piece(middle) == whole(middle)
    assert all(low < pole < high for (low, high), pole in zip(own.around, own.poles, strict=True))


def test_a_pole_at_an_end_of_the_domain_is_cut_off():
    # y = x³ has its inflection at the end, where the evolute leaves for infinity
    own = between_poles(derive("evolute", Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 0), (2, 0), (3, 1)])))
    assert [float(pole) for pole in own.poles] == [0.0]
    assert len(own.pieces) == 1
    assert own.pieces[0].domain[0] > 0
    # the curvature of y = x³/27 is extremal where 45 x⁴ = 729
    assert isclose(float(own.reversals[0]), (729 / 45) ** 0.25 / 3)


def test_a_curve_without_poles_is_one_piece():
    own = between_poles(derive("evolute", example("ellipse_skew")))
    assert own.poles == ()
    assert len(own.pieces) == 1
    assert len(own.reversals) == len(analyse(example("ellipse_skew")).curvature_extrema)


def test_a_cusp_at_a_knot_counts_once():
    own = between_poles(derive("evolute", example("ellipse")))
    assert len(own.reversals) == len(analyse(example("ellipse")).curvature_extrema) == 4


def test_a_space_curve_is_refused():
    with pytest.raises(ShapeError, match="not a plane curve"):
        between_poles(derive("circle_centres", example("twisted_cubic")))
