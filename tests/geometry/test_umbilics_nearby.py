"""Umbilics of all surfaces near a surface."""

from random import Random

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import ShapeError
from tests.campaigns.recognition import moved_surface


def umbilics_within(surface, epsilon):
    return xs.analyse(surface).umbilics_within(epsilon)


def test_surfaces_near_a_surface_have_what_is_certain_and_no_more_than_is_possible():
    """The umbilics of other surfaces, found exactly by elimination: a rectangle for the surface itself alone would pass
    for neither.
    """
    surface, epsilon = xs.example("biquadratic"), mpq(1, 10**6)
    said = umbilics_within(surface, epsilon)
    assert any(found.robust for found in said)
    for seed in range(2):
        own = [one.place.box(20) for one in xs.analyse(moved_surface(surface, epsilon, Random(seed))).umbilics]
        assert all(any(found.sides.contains(box) for found in said) for box in own)
        for found in said:
            assert not found.robust or sum(found.sides.contains(box) for box in own) == 1


def test_where_every_point_is_one_none_is_certain():
    plane = xs.NurbsSurface((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    for surface in (plane, xs.example("sphere")):  # the sphere took 20 s
        (found,) = umbilics_within(surface, "1e-6")
        assert not found.robust
        assert found.sides == surface.domain


def test_questions_and_errors():
    saddle = xs.example("hyperbolic_paraboloid")
    assert umbilics_within(saddle, "1e-6") == ()
    with pytest.raises(ShapeError, match="above 0"):
        umbilics_within(saddle, 0)
    with pytest.raises(ShapeError, match="smaller epsilon"):
        umbilics_within(xs.example("sphere"), 2)
