"""What one question answers says something about what another one answers."""

from random import Random

import pytest

import exactspline as xs
from exactspline import Nurbs, analyse
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.curves.kinds import FeatureKind
from exactspline.questions.entry import Of
from tests.laws.test_matrix import SEED
from tests.support.changes import OF_CURVES
from tests.support.drawn import DRAWN
from tests.support.matrix import ask, questions

CURVES = [Of.PLANE_CURVE, Of.SPACE_CURVE]
#: By how much control points may differ, in what all curves near by have.
EPSILON = "1/1000000"


def drawn(of, name, count=4):
    """Some curves of today."""
    return [DRAWN[of](Random(f"{SEED} {name} {i}")) for i in range(count)]


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_the_distance_of_a_curve_that_is_a_point_is_that_of_its_nearest_points(of):
    for curve in drawn(of, "distance"):
        point = (1, -2, 3)[: curve.dimension]
        alone = Nurbs(1, [0, 0, 1, 1], [point, point])
        nearest = analyse(curve).nearest(point)
        squared = CurvePair(curve, alone).distance.squared
        if nearest:
            assert squared == nearest[0].squared, SEED
        assert {x.parameter for x in nearest} <= {x.first for x in CurvePair(curve, alone).distance.pairs}, SEED


def lies_in(root, pieces):
    """Whether a parameter is in one of some pieces."""
    return any(any(low <= root <= high for low, high in piece.parts) for piece in pieces)


def missing(curve, nearby):
    """What a curve has and a list of what curves near by may have has not: inflections in the plane, zeros of the
    torsion in space, extrema.
    """
    facts = analyse(curve)
    listed = [*(facts.torsion_zeros if curve.dimension == 3 else facts.inflections), *facts.curvature_extrema]
    kinds = (FeatureKind.INFLECTION, FeatureKind.TORSION_ZERO, FeatureKind.MAXIMUM, FeatureKind.MINIMUM)
    own = [x for x in listed if x.kind in kinds]
    return [x for x in own if not lies_in(x.root, [y.piece for y in nearby if y.kind is x.kind])]


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_what_a_curve_has_is_listed_of_all_curves_near_by(of):
    for curve in drawn(of, "within"):
        nearby = within(curve, "features_within")
        assert nearby is None or not missing(curve, nearby), (SEED, curve.control_points)
        cusps = within(curve, "cusps_within")
        for point in () if cusps is None else analyse(curve).singular_points:
            assert lies_in(point.root, [x.piece for x in cusps]), (SEED, curve.control_points)


def within(curve, name):
    """What is listed, None where it is refused."""
    try:
        return getattr(analyse(curve), name)(EPSILON)
    except ExactSplineError:
        return None


def test_what_two_curves_have_in_common_is_listed_of_all_near_by():
    for i in range(4):
        pair = DRAWN[Of.TWO_CURVES](Random(f"{SEED} meetings {i}"))
        try:
            nearby = pair.intersections_within(EPSILON)
        except ExactSplineError:
            continue
        for point in pair.intersections:
            assert any(
                x.first.low <= point.first <= x.first.high and x.second.low <= point.second <= x.second.high
                for x in nearby
            ), (SEED, i)


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_what_is_certain_of_more_curves_is_listed_of_fewer(of):
    """With a knot more there are more curves near by: what all of those have, these have."""
    for curve in drawn(of, "refined"):
        found = OF_CURVES["knot far away"](curve, Random(SEED))
        coarse = within(curve, "features_within")
        fine = within(found[0], "features_within") if found else None
        if coarse is None or fine is None:
            continue
        for feature in [x for x in fine if x.robust]:
            ((low, high),) = feature.piece.parts
            same = [x.piece for x in coarse if x.kind is feature.kind]
            assert any(a <= high and low <= b for piece in same for a, b in piece.parts), (SEED, feature)


@pytest.mark.parametrize("of", CURVES, ids=str)
def test_surplus_words_are_refused(of):
    """An argument of a question that takes none, and a parameter of one about the whole curve."""
    curve = DRAWN[of](Random(f"{SEED} surplus"))
    for entry in questions(of, dear=True):
        argument, place = entry.about.argument, entry.about.place
        surplus = [] if place else [f"{entry.form}@1/2"]
        surplus += [] if argument else [f"{entry.name}:1{'@' * bool(place)}{place}"]
        for text in surplus:
            with pytest.raises(ExactSplineError):
                xs.ask(curve, text)


def test_corners_cusps_and_extrema_are_among_what_they_are_part_of():
    for of in CURVES:
        for curve in drawn(of, "parts"):
            for entry in questions(of):
                if entry.about.part_of:
                    whole = ask(curve, entry.about.part_of)
                    assert all(x in whole for x in ask(curve, entry.name)), (SEED, entry.name)
