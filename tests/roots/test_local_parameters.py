"""Segments as forms, and local parameters of segments over any intervals as real numbers."""

import pickle

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, ZeroSet, square_root, zeros
from exactspline.errors import ShapeError
from exactspline.numbers.exact import to_fmpq
from exactspline.numbers.intervals import UNIT, Interval
from exactspline.polynomials.common_arcs import Image, RationalMap
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.zero_places import Place, at
from exactspline.roots.root import InDoubles
from exactspline.roots.segment_forms import (
    ImageValue,
    image_of,
    image_splines,
    parameter,
    plane_forms,
    root_at,
    segment_forms,
    segment_rows,
)

SIDES = [(0, 1), (2, 5), (-3, mpq(-5, 2)), (-1, mpq(1, 3)), (mpq(-1, 2), mpq(1, 6)), (0, 7)]


def half():
    """``z = √(1/2)``, t = √2 − 1."""
    return Place(isolate(fmpz_poly([1, 0, -2]), 2).inner[0])


@pytest.mark.parametrize(("low", "high"), SIDES)
@pytest.mark.parametrize("other", SIDES)
def test_a_value_of_a_map_is_the_number_it_is(low, high, other):
    """``2z`` and ``(z + 1)/(3 z²)`` at z = √(1/2): s is 2 − √2, and (√2 + 2)/(√2 + 5) = (8 + 3 √2)/23."""
    side, root = Interval(mpq(low), mpq(high)), square_root(2)
    for carried, local in (
        (RationalMap(1, fmpz_poly([0, 2]), fmpz_poly([1])), 2 - root),
        (RationalMap(2, fmpz_poly([1, 1]), fmpz_poly([0, 0, 3])), (8 + 3 * root) / 23),
    ):
        expected = side.low + side.width * local
        for known in (None, InDoubles((0.0, 1.0))):
            found = ImageValue(Image(half(), carried), side, Interval(*map(mpq, other)), known)
            for digits in (0, 3, 25, 120):
                a, b = found.enclosure(digits)
                assert b - a <= mpq(1, 10**digits)
                assert a <= expected <= b
            assert found.exact is None
            assert found == expected
            assert found.minimal_polynomial() == expected.minimal_polynomial()
            assert found - expected == 0


def test_what_is_known_of_a_value_is_used_where_it_suffices():
    """An interval of the local parameter, on a side that is wider or narrower than 1."""
    carried = RationalMap(1, fmpz_poly([0, 2]), fmpz_poly([1]))
    given = InDoubles((0.585, 0.587))
    known = Interval(given.low, given.high)
    narrow, wide = Interval(mpq(3), mpq(31, 10)), Interval(mpq(-10), mpq(0))
    assert ImageValue(Image(half(), carried), narrow, UNIT.first, given).enclosure(3) == narrow.part(known)
    for digits in (1, 2):
        enclosure = ImageValue(Image(half(), carried), wide, UNIT.first, given).enclosure(digits)
        assert enclosure.width <= mpq(1, 10**digits)
        assert (enclosure == wide.part(known)) == (digits == 1)


@pytest.mark.parametrize(("low", "high"), SIDES)
def test_places_on_segments(low, high):
    side = Interval(mpq(low), mpq(high))
    place = half()
    for bits in (0, 30):
        place.refine(bits)
        root = root_at(place, side)
        assert root == side.low + side.width * (square_root(2) - 1)
        assert root.low >= side.low
        assert root.high - root.low <= side.width * mpq(1, 1 << bits)
        assert (root.multiplicity, root.signs) == (1, place.zero.signs)
        assert pickle.loads(pickle.dumps(root)) == root
    for t in (mpq(0), mpq(2, 7), mpq(1)):
        assert root_at(at(t), side) == parameter(at(t), side, UNIT.first) == side.at(t)
        carried = RationalMap(2, fmpz_poly([0, 2, 3]), fmpz_poly([5, 0, 1]))
        # 2 t (1 − t) + 3 t² over that and 5 (1 − t)² + t²
        top, bottom = 2 * t * (1 - t) + 3 * t**2, 5 * (1 - t) ** 2 + t**2
        assert image_of(carried, t) == top / (top + bottom)
        assert parameter(Image(at(t), carried), side, Interval(mpq(3), mpq(8))) == side.at(top / (top + bottom))
        other = Interval(mpq(3), mpq(8))
        above, below = image_splines(carried, side, other)
        assert above.domain == below.domain == other
        assert above(other.at(t)) / below(other.at(t)) == side.at(top / (top + bottom))


def test_segments_of_curves_as_forms():
    """Of a rational and of a polynomial curve with two segments, of the degree that is needed."""
    knots = [0, 0, 0, 1, 3, 3, 3]
    weighted = [(0, 0, 1), (2, 4, 2), (3, -1, 1), (4, 4, 4)]
    points = [tuple(mpq(x) for x in row[:2]) for row in weighted]
    for curve in (Nurbs.from_homogeneous(2, knots, weighted), Nurbs(2, knots, points)):
        for raised in (curve, curve.elevate_degree(), curve.elevate_degree(2)):
            for i, (a, b) in enumerate(((0, 1), (1, 3))):
                n, whole = segment_forms(raised, i)
                assert n == 2
                forms = plane_forms(raised, i)
                assert (forms.degree, forms.x, forms.y, forms.w) == (n, *whole)
                m, rows = segment_rows(raised, i)
                assert m == raised.degree
                assert all(len(row) == m + 1 for row in rows)
                for t in (mpq(0), mpq(1, 3), mpq(4, 7)):
                    z = to_fmpq(t / (1 - t))
                    x, y, w = (form(z) for form in whole)
                    expected = tuple(map(to_fmpq, curve(a + (b - a) * t)))
                    assert (x / w, y / w) == expected
                    x, y, w = (fmpz_poly(list(map(int, row)))(z) for row in rows)
                    assert (x / w, y / w) == expected
    point = Nurbs(3, [0] * 4 + [1] * 4, [(2, 5)] * 4)
    assert segment_forms(point, 0)[0] == 0


def test_zero_sets_are_equal_where_their_zeros_are():
    one, twice = BSpline.bezier([1, -2, 1]), BSpline.bezier([3, -6, 3])
    same, other = zeros(twice), zeros(BSpline.bezier([1, -3, 1]))
    assert zeros(one) == zeros(one) == same
    assert hash(zeros(one)) == hash(same)
    assert zeros(one) != other
    assert other not in (0, (), list(other))
    with pytest.raises(ShapeError, match="isolations"):
        ZeroSet(one, False, [3])
    assert zeros(BSpline.bezier([-1, 2, -1])) != same  # the same parameters, other signs
    assert zeros(BSpline.bezier([0, 0])) != zeros(BSpline.bezier([0, 0, 1]))
