"""Arcs that curves have in common, held against samples of their maps and coordinates."""

from itertools import combinations, product
from random import Random

import pytest
from flint import fmpq, fmpz_poly
from gmpy2 import mpq

from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import (
    Coordinate,
    Image,
    Meeting,
    RationalMap,
    Rest,
    collinear_arcs,
    common_arcs,
    compared,
    lowest_terms,
)
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.zero_places import Place, at, places

SAMPLES = [mpq(k, 97) for k in range(1, 97)]


def value(carried, t):
    """The parameter ``top/(top + bottom)`` as a number, None for infinity."""
    top, bottom = (
        sum(int(c) * t**k * (1 - t) ** (carried.degree - k) for k, c in enumerate(form.coeffs()))
        for form in (carried.top, carried.bottom)
    )
    return top / (top + bottom) if top + bottom else None


def near(place, bits=60):
    """A rational number near a parameter."""
    if isinstance(place, Image):
        return value(place.map, near(place.place, 3 * bits))
    interval = place.refine(bits)
    return (interval.low + interval.high) / 2


@pytest.mark.parametrize("below", [False, True])
def test_a_map_has_its_arcs_where_its_values_are_parameters(below):
    random, seen = Random(4), 0
    for _ in range(60):
        forms = [fmpz_poly([random.randint(-4, 4) for _ in range(random.randint(1, 4))]) for _ in range(2)]
        carried = lowest_terms(RationalMap(3, *forms)) if all(forms) else RationalMap(0, *forms)
        if not all(forms) or not carried.slope:
            continue
        found = common_arcs(carried, below=below)
        spans = [tuple(map(near, arc.second)) for arc in found.arcs]
        for t in SAMPLES:
            s = value(carried, t)
            holds = s is not None and 0 < s < 1 and (not below or s < t)
            assert sum(low < t < high for low, high in spans) == holds
        for arc, (low, high) in zip(found.arcs, spans, strict=True):
            own = [value(carried, low + (high - low) * mpq(k, 23)) for k in range(24)]
            assert own in (sorted(own), sorted(own, reverse=True))
            assert all(abs(near(x) - y) < mpq(1, 10**9) for x, y in zip(arc.first, (own[0], own[-1]), strict=True))
            assert arc.map is carried
            seen += 1
        assert not any(low < point.second.refine(60).low < high for point in found.points for low, high in spans)
    assert seen > 20


#: Forms of z = t/(1 − t), and the points: those of the map, and those with a value below the parameter.
TOUCHING = [
    ([-1, 2, -1], [1, 0, 1], [(0, mpq(1, 2))], [(0, mpq(1, 2))]),
    ([1, 0, 1], [-1, 2, -1], [(1, mpq(1, 2))], []),
    ([0, -1], [1], [(0, 0), (1, 1)], []),
    ([1], [0, -1], [(1, 0), (0, 1)], [(0, 1)]),
    ([-1, -1], [1, 0, 1], [(0, 1)], [(0, 1)]),
    ([0, -1, 2, -1], [1], [(0, 0), (0, mpq(1, 2)), (1, 1)], [(0, mpq(1, 2))]),
]


@pytest.mark.parametrize(("top", "bottom", "every", "smaller"), TOUCHING)
def test_a_value_that_is_only_touched_is_a_point(top, bottom, every, smaller):
    carried = RationalMap(max(len(top), len(bottom)) - 1, fmpz_poly(top), fmpz_poly(bottom))
    for below, expected in ((False, every), (True, smaller)):
        found = common_arcs(carried, below=below)
        assert [(point.first.exact, point.second.exact) for point in found.points] == expected
        assert not found.arcs


def test_what_is_exchanged_twice_is_the_same():
    carried = RationalMap(2, fmpz_poly([1, -2, 1]), fmpz_poly([1]))
    found = common_arcs(carried)
    found.rests.append(Rest(at(mpq(1, 3))))
    found.points.append(Meeting(at(mpq(1, 4)), at(mpq(1, 5)), 3))
    other = found.exchanged()
    assert [arc.exchanged for arc in other.arcs] == [True, True] == [not arc.exchanged for arc in found.arcs]
    assert [(arc.first, arc.second) for arc in other.arcs] == [(arc.second, arc.first) for arc in found.arcs]
    assert [rest.exchanged for rest in other.rests] == [True]
    assert [(x.second, x.first, x.multiplicity) for x in other.points] == [
        (found.points[0].first, found.points[0].second, 3)
    ]
    assert other.exchanged() == found


def straight(points, weights=None):
    """A curve on the line y = 2x by the abscissas of its points."""
    n = len(points) - 1
    weights = weights or [1] * (n + 1)
    factor = [1]
    for k in range(n):
        factor.append(factor[-1] * (n - k) // (k + 1))
    x = fmpz_poly([a * w * c for a, w, c in zip(points, weights, factor, strict=True)])
    return PlaneForms(n, x, 2 * x, fmpz_poly([w * c for w, c in zip(weights, factor, strict=True)]))


def preimages(curve, v):
    """The parameters with a value."""
    return [near(place) for place in places(isolate(curve.x * v.q - curve.w * v.p, curve.degree))]


def coordinate(curve, t):
    return value(RationalMap(curve.degree, curve.x, curve.w - curve.x), t)


def see_arcs(found, first, second):
    """Along each arc both parameters run over all values between those at its ends, each once; all pairs are on one."""
    spans = []
    for arc in found.arcs:
        ends = [[near(place) for place in own] for own in (arc.first, arc.second)]
        values = [[coordinate(c, t) for t in own] for c, own in zip((first, second), ends, strict=True)]
        assert all(abs(x - y) < mpq(1, 10**9) for x, y in zip(*values, strict=True))
        assert ends[1] == sorted(ends[1])
        spans.append((ends, sorted(values[0])))
    for k in range(-17, 18):
        v = fmpq(k, 2) + fmpq(1, 97)
        own = [preimages(c, v) for c in (first, second)]
        pairs = list(product(*own)) if first is not second else list(combinations(own[0], 2))
        over = [ends for ends, (low, high) in spans if low < mpq(int(v.p), int(v.q)) < high]
        assert len(over) == len(pairs)
        for s, t in pairs:
            assert sum(min(a) < s < max(a) and b[0] < t < b[1] for a, b in over) == 1


@pytest.mark.parametrize("seed", range(6))
def test_arcs_of_curves_on_one_line(seed):
    random = Random(seed)
    first, second = (
        straight([random.randint(-9, 9) for _ in range(n + 1)], [random.randint(1, 3) for _ in range(n + 1)])
        for n in (3, random.choice([2, 3, 4]))
    )
    see_arcs(collinear_arcs(first, second), first, second)
    upright = [PlaneForms(c.degree, 3 * c.w, c.x, c.w) for c in (first, second)]
    see_arcs(collinear_arcs(*upright), first, second)
    for curve in (first, second, straight([-9, 9, -9, 9, -9])):
        see_arcs(collinear_arcs(curve), curve, curve)


def test_ends_that_are_on_no_arc():
    """Turning back at one value from both sides, at rational and irrational parameters, and at ends of the curves."""
    z = fmpz_poly([0, 1])
    root = [((k * z**2 - (1 + z) ** 2) ** 2, sign) for k, sign in ((2, 1), (3, -1))]  # ±(k t² − 1)²
    least, greatest = (PlaneForms(4, sign * x, 2 * sign * x, (1 + z) ** 4) for x, sign in root)
    twice = 8 * (1 + z) ** 4 + (4 * (z - 1) ** 2 - (1 + z) ** 2) ** 2  # 1/2 + (4 t − 1)² (4 t − 3)²/16
    for first, second, places_of in (
        (straight([0, 1, 0]), PlaneForms(4, twice, 2 * twice, 16 * (1 + z) ** 4), [(0.5, 0.25), (0.5, 0.75)]),
        (straight([0, 1, 0]), straight([1, 0, 1]), [(0.5, 0.5)]),
        (least, greatest, [(0.707107, 0.57735)]),
        (straight([3, 1, 4]), straight([3, 9, 9]), [(0, 0)]),
        (straight([3, 4]), straight([3, 2, 0]), [(0, 0)]),
        (straight([3, 4]), straight([0, 2, 3]), [(0, 1)]),
        (straight([4, 3]), straight([0, 2, 3]), [(1, 1)]),
        (straight([0, 2, -2, 0]), None, [(0, 1)]),
    ):
        found = collinear_arcs(first, second)
        assert [tuple(round(float(near(x)), 6) for x in (p.first, p.second)) for p in found.points] == places_of
        assert [p.multiplicity for p in found.points] == [None] * len(places_of)
    assert len(found.arcs) == 2


def test_coordinates_are_compared_exactly():
    """√2 and −√2 squared, a rational value at an irrational place, and values that differ in the 300th digit."""
    square = RationalMap(2, fmpz_poly([0, 0, 1]), fmpz_poly([1]))
    (root,) = isolate(fmpz_poly([-2, 0, 1]), 2).inner
    (fourth,) = isolate(fmpz_poly([-2, 0, 0, 0, 1]), 4).inner
    identity = RationalMap(1, fmpz_poly([0, 1]), fmpz_poly([1]))
    of_root, of_fourth = Coordinate(identity, Place(root)), Coordinate(square, Place(fourth))
    assert compared(of_root, of_fourth) == compared(of_fourth, of_root) == 0
    two = Coordinate(identity, at(mpq(2, 3), 0))
    assert compared(Coordinate(square, Place(root)), two) == compared(two, Coordinate(square, Place(root))) == 0
    for digits in (5, 40, 300):
        more = Coordinate(RationalMap(1, fmpz_poly([1, 10**digits]), fmpz_poly([10**digits])), Place(root))
        assert [compared(more, of_fourth), compared(of_fourth, more)] == [1, -1]
    # an infinite value until it is known precisely
    pole = RationalMap(1, fmpz_poly([1]), fmpz_poly([-14142135623730950488, 10**19]))
    assert compared(Coordinate(pole, Place(root)), of_root) == 1
    assert compared(of_root, Coordinate(pole, Place(root))) == -1
