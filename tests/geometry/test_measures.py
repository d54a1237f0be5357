"""Lengths, parameters at lengths and at coordinates, areas and centroids: a part of the campaign against mpmath, what
is decided, and what is refused.
"""

import pickle
from itertools import pairwise
from math import comb, hypot

import pytest
from gmpy2 import mpq
from mpmath import fp

from exactspline import Nurbs, analyse, ask, circle, example
from exactspline.errors import DomainError, OpenError, ShapeError
from exactspline.geometry.measures import integrals
from exactspline.geometry.pairs.regions import Region
from exactspline.questions import takes
from tests.campaigns import measures as campaign
from tests.support.dials import ALWAYS
from tests.support.sampled import FULL

LINE = Nurbs(1, [0, 0, 1, 1], [(0, 0), (3, 4)])
PARABOLA = Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)])
#: Half of the unit disc.
HALF = Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (0, 0), (1, 0)],
             [1, 1, 2, 2, 4, 4, 4])  # fmt: skip


@pytest.mark.parametrize("family", campaign.FAMILIES)
@pytest.mark.parametrize("dial", ALWAYS)
def test_a_part_of_the_campaign(family, dial):
    found = [campaign.differs(family, dial, seed) for seed in range(7, 27 if FULL else 8)]
    assert {*found} <= {"", campaign.UNJUDGED, campaign.OPEN}
    assert "" in found or family == "arcs"


def test_the_campaign_notices_a_false_answer(monkeypatch):
    monkeypatch.setattr(campaign, "speed", lambda point, velocity: abs(velocity[0]))
    assert any("length" in campaign.differs("splines", "small integers", seed) for seed in range(7, 10))


def test_a_circle_is_decided():
    facts, other = analyse(circle((1, 2), 3)), analyse(circle((0, 0), 3))
    assert (str(facts.area), str(facts.length)) == ("9π", "6π")
    assert facts.area == other.area
    assert facts.area != analyse(example("circle")).area
    assert facts.area.exact is None
    assert pickle.loads(pickle.dumps(facts.area)) == facts.area
    assert [x.exact for x in facts.centroid[0].values.values()] == [1, 2]
    assert ask(example("ellipse"), "area").closed_form == "2π"


def test_arcs_of_circles():
    facts = analyse(HALF)
    assert [str(facts.area), str(facts.length), str(facts.moments(1)[2].values["moment"])] == ["π/2", "2 + π", "2/3"]
    assert facts.length_between((0, "1/3")).closed_form == "2 arctan(1/3)"
    low = analyse(HALF.transform([[2, 0, 0], [0, "1/3", 0]]))
    assert low.area.closed_form == "π/3"
    with pytest.raises(OpenError):
        _ = low.length.closed_form


@pytest.mark.parametrize("weights", [None, (1, 2, 1, 5)], ids=["polynomial", "rational"])
@pytest.mark.parametrize("near", ["1e-2", "1e-30"])
def test_quadrature_and_integration_agree(monkeypatch, weights, near):
    """Also where the speed nearly vanishes; FLINT's integration is used where zeros cannot be told apart."""
    curve, digits = Nurbs(3, [0] * 4 + [1] * 4, [(0, 0), (1, 1), (near, 1), (1, 0)], weights), []
    for _ in range(2):
        digits.append(integrals.length(curve).decimal(40))
        monkeypatch.setattr(integrals, "separate", lambda p: False)
    assert digits[0] == digits[1]
    assert abs(fp.quad(lambda t: speed(curve, t), fp.linspace(0, 1, 101)) - float(digits[0])) < 1e-9


def speed(curve, t):
    """In doubles, from Bernstein polynomials and their derivatives."""
    points = [(*(float(w * x) for x in p), float(w)) for p, w in zip(curve.control_points, curve.weights, strict=True)]
    values = [sum(comb(3, k) * t**k * (1 - t) ** (3 - k) * p[i] for k, p in enumerate(points)) for i in range(3)]
    slopes = [
        sum(3 * comb(2, k) * t**k * (1 - t) ** (2 - k) * (q[i] - p[i]) for k, (p, q) in enumerate(pairwise(points)))
        for i in range(3)
    ]
    x, y, w = values
    return hypot(*((d * w - slopes[2] * c) / w**2 for c, d in zip((x, y), slopes, strict=False)))


def test_regions_with_arcs():
    ring = Region([circle((0, 0), 2), circle((0, 0), 1)], "even-odd")
    assert str(ring.area) == "3π"
    assert [x.exact for x in ring.centroid[0].values.values()] == [0, 0]


def test_parameters_at_lengths_where_the_speed_is_a_polynomial():
    assert analyse(LINE).at_length(2).exact == mpq(2, 5)
    diagonal = Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
    assert analyse(diagonal).at_length(1).closed_form == "√2/2"
    assert [x.values["parameter"].exact for x in analyse(diagonal).equally_spaced(4)] == [mpq(k, 4) for k in range(5)]


def test_parameters_at_lengths_by_enclosures():
    t = analyse(PARABOLA).at_length(1)
    low, high = t.enclosure(200)
    assert 0 < high - low <= mpq(1, 10**200)
    lengths = [analyse(PARABOLA).length_between((0, x)) for x in (low, high)]
    assert lengths[0] <= 1 <= lengths[1]
    # at a knot, where no sign is decided
    places = [x.values["parameter"] for x in analyse(example("ellipse")).equally_spaced(4)]
    assert all(abs(t.enclosure(30).middle - k) < mpq(1, 10**29) for k, t in enumerate(places))


def test_lengths_between_roots():
    curve = example("six_segment_cubic")
    first, second = (f.root for f in analyse(curve).inflections)
    found = analyse(curve).length_between((first, second))
    assert found.decimal(20) == ask(curve, "length_between@inflections").decimal(20)
    near = [root.rational_near(30) for root in (first, second)]
    assert abs(found.enclosure(20).middle - analyse(curve).length_between(near).enclosure(20).middle) < mpq(1, 10**19)


def test_a_length_across_a_cusp_counts_both_sides():
    facts = analyse(example("cusp"))
    (cusp,) = facts.cusps
    a, b = facts.curve.domain
    sides = [facts.length_between((a, cusp.root)), facts.length_between((cusp.root, b))]
    assert abs(sum(x.enclosure(20).middle for x in sides) - facts.length.enclosure(20).middle) < mpq(1, 10**19)


def test_where_a_coordinate_has_a_value():
    facts = analyse(example("circle"))
    assert [str(f.kind) for f in facts.at_coordinate((0, "1/2"))] == ["level crossing", "level crossing"]
    assert [(str(f.kind), f.root.exact) for f in facts.at_coordinate((1, 1))] == [("level touch", 1)]
    assert not facts.at_coordinate((1, 2))
    assert analyse(Nurbs(1, [0, 0, 1, 1], [(1, 0), (1, 3)])).at_coordinate((0, 1)).everywhere
    jump = analyse(example("jump"))
    assert [f.by_jump for f in jump.at_coordinate((1, "1/2"))] == [False, False, True]


@pytest.mark.parametrize(("asked", "error", "told"), [
    ("at_length:-1", DomainError, "stay on the curve"),
    ("at_length:6", DomainError, "of the length 5"),
    ("length_between@0,2", DomainError, "outside"),
    ("length_between@0", takes.QuestionError, "two parameters"),
    ("length_between@0,1/2-", takes.QuestionError, "two parameters"),
    ("equally_spaced:0", takes.QuestionError, "one part or more"),
    ("at_coordinate:2,1", ShapeError, "the coordinate 2"),
    ("at_coordinate:0", takes.QuestionError, "0,1/2"),
    ("centroid", ShapeError, "not closed"),
])  # fmt: skip
def test_what_is_refused(asked, error, told):
    with pytest.raises(error, match=told):
        ask(LINE, asked)


def test_the_centroid_of_the_area_0():
    with pytest.raises(DomainError, match="the area 0"):
        _ = analyse(Nurbs(1, [0, 0, 1, 2, 2], [(0, 0), (1, 1), (0, 0)])).centroid
