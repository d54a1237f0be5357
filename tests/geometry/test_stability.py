"""How far a curve may be changed until a feature vanishes."""

from functools import cache
from itertools import islice
from random import Random

import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import ShapeError
from tests.campaigns.nearby import drawn, moved

CORNER = xs.Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 0), (1, 1)])


def stability(curve):
    return xs.analyse(curve).stability


def kinds(curve):
    """How often each kind of feature occurs."""
    found = xs.analyse(curve)
    of = [*found.inflections, *found.curvature_extrema]
    return sorted(str(f.kind) for f in of) + ["corner"] * len(found.corners)


@cache
def small_curves():
    """Curves of degree 2 and 3, of which everything is found quickly, with their stability."""
    random = Random(17)
    every = (curve for curve in iter(lambda: drawn(random), None) if curve.degree <= 3 and curve.segments <= 3)
    small = (curve for curve in every if curve.polynomial or curve.segments == 1)
    return [(curve, stability(curve)) for curve in islice(small, 3)]


def test_no_change_within_the_radius_makes_a_feature_vanish():
    """A radius taken from the first distance that is refuted, or an interval without the feature, would pass."""
    random, tried = Random(7), 0
    for curve, measured in small_curves():
        for found in measured:
            if not found.radius:
                continue
            (near,) = [
                f
                for f in xs.analyse(curve).features_within(found.radius)
                if f.kind is found.kind and f.place.low <= found.place <= f.place.high
            ]
            assert near.single
            if found.kind == "corner":
                continue
            for _ in range(3):
                facts = xs.analyse(moved(curve, found.radius, random))
                points = [*facts.inflections, *facts.curvature_extrema]
                assert sum(f.kind is found.kind and f.root in near.piece for f in points) == 1
                tried += 1
    assert tried > 10


def test_a_witness_lacks_a_feature_and_is_as_near_as_it_says():
    tried = []
    for curve, measured in small_curves():
        for found in measured:
            if found.witness is None:
                continue
            pairs = zip(curve.control_points, found.witness.control_points, strict=True)
            differences = [abs(x - y) for p, q in pairs for x, y in zip(p, q, strict=True)]
            differences += [abs(a - b) for a, b in zip(curve.weights, found.witness.weights, strict=True)]
            assert max(differences) == found.gone >= found.radius
            assert found.witness.knots == curve.knots
            name = str(found.kind)
            assert kinds(found.witness).count(name) < kinds(curve).count(name)
            tried.append(name)
    assert {"inflection", "maximum"} <= set(tried)


def test_the_inflection_of_a_symmetric_cubic_and_a_corner():
    """The bounds are a factor of 6 apart here; a corner of 90° in a polyline is gone at a quarter of its legs."""
    (inflection,) = [f for f in stability(xs.example("cubic_s")) if f.kind == "inflection"]
    assert mpq(1, 8) <= inflection.radius < inflection.gone < 1
    (corner,) = stability(CORNER)
    assert corner.kind == "corner"
    assert mpq(1, 8) <= corner.radius < corner.gone == mpq(1, 4)


def test_what_every_change_destroys_has_no_radius():
    flat = xs.Nurbs(4, [0] * 5 + [1] * 5, [(mpq(k, 4), y) for k, y in enumerate((1, -1, 1, -1, 1))])
    assert all(f.kind != "undulation" for f in stability(flat))
    half = xs.example("ellipse").restrict(0, 2)
    assert {f.radius for f in stability(half)} == {0}  # at double knots, where κ may jump


def test_questions_and_errors():
    with pytest.raises(ShapeError, match="in the plane or in space"):
        stability(xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0, 0), (1, 1, 1, 1)]))


def test_a_space_curve():
    """Torsion and curvature of a quartic: radii hold for curves near it, witnesses have fewer extrema."""
    curve, random = xs.example("space_quartic"), Random(5)
    found = stability(curve)
    assert [one.kind for one in found] == [one.kind for one in xs.analyse(curve).curvature_extrema]
    for one in found:
        assert 0 < one.radius < one.gone
        near = xs.analyse(moved(curve, one.radius, random)).curvature_extrema
        assert sum(f.kind is one.kind for f in near) == sum(each.kind is one.kind for each in found)
        witness = xs.analyse(one.witness).curvature_extrema
        assert sum(f.kind is one.kind for f in witness) < sum(each.kind is one.kind for each in found)
