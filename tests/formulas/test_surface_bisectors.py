"""Bisectors of surfaces against their definition, by numbers alone."""

import pytest

from exactspline import example, formula_of
from exactspline.language import Vector, cross, det, norm2
from exactspline.language.kinds import SURFACE
from exactspline.readings.taylor import DoubleTaylorReading
from tests.formulas.test_surface_formulas import CURVED, PLACES, at, inside, partials

FORMS = ("point_bisector_of_surface", *(f"point_bisector_of_surface_{n}" for n in ("reduced", "lifted", "divided")))


def point_at(name, surface, u, v):
    """A formula whose values are points, at a point of the surface."""
    series = DoubleTaylorReading(surface.remembering(), u, v, 2).argument(SURFACE, 3)
    return Vector(*[x.value for x in formula_of(f"surfaces:{name}")(series)])


@pytest.mark.parametrize("name", CURVED)
@pytest.mark.parametrize("place", PLACES)
def test_the_centre_is_on_the_normal_and_as_far_from_the_origin_as_from_the_foot(name, place):
    surface = example(name)
    u, v = inside(surface, place)
    d = partials(surface, u, v)
    foot, a, b = d[0, 0], d[1, 0], d[0, 1]
    assert det(foot, a, b) != 0
    centres = [point_at(form, surface, u, v) for form in FORMS]
    for centre in centres:
        assert cross(centre - foot, cross(a, b)) == cross(foot, foot)
        assert norm2(centre) == norm2(centre - foot)
    assert len(set(map(tuple, centres))) == 1


def test_the_conditions_of_a_curve_vanish_together():
    surface = example("rational_biquadratic")
    for place in PLACES:
        u, v = inside(surface, place)
        d = partials(surface, u, v)
        plain, lifted = at("curve_condition", surface, u, v), at("curve_condition_lifted", surface, u, v)
        w = surface.w(u, v)
        assert lifted == plain * w**5 * det(d[1, 0], d[0, 1], d[0, 0])
        assert plain == point_at(FORMS[0], surface, u, v)[0] != 0
