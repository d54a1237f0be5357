"""Common points of random segments against resultants in powers of the parameters, and the multiplicities of branches
against the dimensions of local algebras.
"""

from fractions import Fraction
from functools import reduce
from math import comb
from operator import mul
from random import Random

import pytest
from flint import arb, fmpz_poly
from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.numbers.exact import to_fmpq
from exactspline.numbers.intervals import UNIT, Interval
from exactspline.polynomials.bezout import PlaneForms
from exactspline.polynomials.common_arcs import RationalMap
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.plane_pairs import (
    IDENTITY,
    Elimination,
    Fibre,
    elimination,
    local_multiplicity,
    meetings,
    multiplicity_of_sum,
    self_elimination,
    self_meetings,
)
from exactspline.polynomials.two_parameters import S, T, lifted
from exactspline.polynomials.zero_places import Place, at, places
from exactspline.roots.segment_forms import parameter, plane_forms
from tests.support import elimination_oracle as oracle
from tests.support.local_algebra import local_dimension


def forms(rows):
    n = len(rows) - 1
    return plane_forms(Nurbs.from_homogeneous(n, [0] * (n + 1) + [1] * (n + 1), rows), 0)


def any_rows(draw, n, size):
    weights = [Fraction(draw.choice([1, 1, 2, 3])) for _ in range(n + 1)]
    return [(draw.randint(-size, size) * w, draw.randint(-size, size) * w, w) for w in weights]


def approximate(pairs):
    return sorted((round(s, 9) + 0.0, round(t, 9) + 0.0) for s, t in pairs)


def parameters(point):
    places = (point.first, point.second)
    return tuple(float(parameter(x, side, side)) for x, side in zip(places, UNIT, strict=True))


def check_multiplicities(own, points, others):
    """At most those of both parameters as roots of the resultants; of rational ones those of local algebras."""
    for point in points:
        s, t = parameters(point)
        (other,) = [x for x in others if abs(x.s - s) < 1e-9 and abs(x.t - t) < 1e-9]
        assert 1 <= point.multiplicity <= min(other.of_s, other.of_t)
        place = [x.exact if isinstance(x, Place) else None for x in (point.first, point.second)]
        if None not in place and 1 not in place:
            z = [x / (1 - x) for x in place]
            assert point.multiplicity == local_dimension(*own, z)


def equations(first, second):
    return [
        lifted(p, 0) * lifted(second.w, 1) - lifted(first.w, 0) * lifted(q, 1)
        for p, q in zip(first.forms[:2], second.forms[:2], strict=True)
    ]


@pytest.mark.parametrize("size", [1, 2, 4, 30])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 5])
def test_common_points_are_those_of_resultants(n, size):
    """Small numbers make what is special: points at ends and on several branches, straight curves, contact."""
    draw, count = Random(f"{n} {size}"), 0
    for k in range(12):
        rows, other = any_rows(draw, n, size), any_rows(draw, draw.randint(1, 5), size)
        if k % 3 == 0:
            other[draw.choice([0, -1])] = rows[draw.choice([0, -1])]
        others, shared = oracle.common_points(rows, other)
        first, second = forms(rows), forms(other)
        found = meetings(first, second)
        assert shared or not (found.arcs or found.rests)
        if shared:
            continue
        assert approximate(map(parameters, found.points)) == approximate((x.s, x.t) for x in others)
        check_multiplicities(equations(first, second), found.points, others)
        count += len(found.points)
    assert count > 5


def ending_on_itself(rows, t):
    """The curve with another last point: the one at t."""
    n = len(rows) - 1
    before = [(comb(n, i) * t**i * (1 - t) ** (n - i), row) for i, row in enumerate(rows[:-1])]
    return [*rows[:-1], tuple(sum(b * row[k] for b, row in before) / (1 - t**n) for k in range(3))]


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_crossings_of_a_curve_with_itself_are_those_of_resultants(n):
    draw, count = Random(n), 0
    for k in range(60):
        rows = any_rows(draw, n, (1, 3, 9)[k % 3])
        if k % 4 == 0:
            rows[-1] = rows[0]
        elif k % 4 == 1:
            rows = ending_on_itself(rows, Fraction(draw.randint(1, 3), 4))[:: draw.choice([1, -1])]
        x, y, w = oracle.powers(rows)
        lift = oracle._lifted
        minors = [lift(p, 0) * lift(q, 1) - lift(q, 0) * lift(p, 1) for p, q in ((x, w), (y, w), (x, y))]
        others, shared = oracle.solutions([e / (oracle.S - oracle.T) for e in minors])
        found = self_meetings(forms(rows))
        if shared:
            continue
        assert not found.arcs
        below = [point for point in others if point.s < point.t - 1e-9]
        assert approximate(map(parameters, found.points)) == approximate((x.s, x.t) for x in below)
        curve = forms(rows)
        check_multiplicities([p / (S - T) for p in equations(curve, curve)], found.points, below)
        count += len(found.points)
    assert (count > 3) == (n > 2)


def through(draw, n, numbers, along=None):
    """A plane curve, in forms of degree n, that passes through the origin at these values of z; at the first of them
    perhaps in a given direction.
    """
    common = product([fmpz_poly([-int(z.numerator), int(z.denominator)]) for z in numbers])
    cofactors = [fmpz_poly([draw.randint(-3, 3) for _ in range(n + 1 - len(numbers))]) for _ in range(2)]
    if along is not None:
        z = numbers[0]
        cofactors = [a + fmpz_poly([-int(z.numerator), int(z.denominator)]) for a in along]
    return PlaneForms(n, *[common * p for p in cofactors], fmpz_poly([draw.randint(1, 4) for _ in range(n + 1)]))


def product(factors):
    return reduce(mul, factors, fmpz_poly([1]))


def direction(curve, z):
    """That of the branch that passes through the origin at a value of z."""
    slopes = [f.derivative()(to_fmpq(z)) * int(z.denominator) ** curve.degree for f in curve.forms[:2]]
    return [fmpz_poly([int(x.p)]) for x in slopes]


def of_z(z):
    return at(z / (1 + z), 1)


def backwards(curve):
    return PlaneForms(
        curve.degree, *[fmpz_poly([f[curve.degree - k] for k in range(curve.degree + 1)]) for f in curve.forms]
    )


@pytest.mark.parametrize("seed", range(12))
def test_multiplicities_of_branches_are_those_of_local_algebras(seed):
    """At points through which both pass twice; at the ends, too, where z is 0 or infinite."""
    draw = Random(seed)
    a, b = mpq(draw.randint(1, 3), 2), mpq(draw.randint(0, 2))
    first = through(draw, 3, [a, mpq(0)])
    second = through(draw, 3, [b, mpq(5)], direction(first, a) if seed % 3 == 0 else None)
    f, g = equations(first, second)
    if not f or not g or f.gcd(g).total_degree() > 0:
        pytest.skip("arcs of one curve")
    for s in (a, mpq(0)):
        for t in (b, mpq(5)):
            expected = local_dimension(f, g, (s, t))
            assert local_multiplicity(first, second, of_z(s), of_z(t)) == expected
            if s == 0:
                assert local_multiplicity(backwards(first), second, at(mpq(1), 1), of_z(t)) == expected
            if t == 0:
                assert local_multiplicity(first, backwards(second), of_z(s), at(mpq(1), 1)) == expected


@pytest.mark.parametrize("seed", range(8))
def test_multiplicities_of_a_curve_and_itself(seed):
    """Without the factor that vanishes where both parameters are one; of the curve and of the curve reversed."""
    draw = Random(seed)
    z = [mpq(0), mpq(1), mpq(draw.randint(3, 5), 2)]
    curve = through(draw, 4, z)
    f, g = (p / (S - T) for p in equations(curve, curve))
    if f.gcd(g).total_degree() > 0:
        pytest.skip("it runs over an arc twice")
    inverse = RationalMap(1, fmpz_poly([1]), fmpz_poly([0, 1]))
    for s, t in ((0, 1), (1, 2), (2, 0), (0, 2)):
        expected = local_dimension(f, g, (z[s], z[t]))
        assert local_multiplicity(curve, curve, of_z(z[s]), of_z(z[t]), IDENTITY) == expected
        if s == 0:
            at_end = local_multiplicity(backwards(curve), curve, at(mpq(1), 1), of_z(z[t]), inverse)
            assert at_end == expected
        if t == 0:
            at_end = local_multiplicity(curve, backwards(curve), of_z(z[s]), at(mpq(1), 1), inverse)
            assert at_end == expected
    fibre = Fibre(curve, curve, of_z(z[1]), IDENTITY)
    assert fibre.size == 2
    assert [fibre.contains(of_z(x)) for x in z] == [True, False, True]


def test_a_map_and_its_signs_are_those_of_points_on_the_curve():
    """``A₀₁/A₀₀`` is s/u where the second curve is a part of the first: by forms, and by balls from degree 4 on."""
    for n in (2, 3, 4, 5):
        draw = Random(n)
        first = forms(any_rows(draw, n, 9))
        eliminated = Elimination(elimination(first, first).matrix, n)
        assert not eliminated.determinant
        for place in places(elimination(first, forms(any_rows(draw, 3, 9))).isolation):
            assert eliminated.sign("second", place) == eliminated.sign("first", place) != 0
            assert eliminated.sign("last", place) != 0


@pytest.mark.parametrize(("low", "high"), [(0, 1), (2, 5), (-3, mpq(-5, 2)), (-1, mpq(1, 3))])
def test_numbers_of_images_are_values_of_maps(low, high):
    """Of enclosures, of exact values and of minimal polynomials, on segments over different intervals."""
    side, other = Interval(mpq(low), mpq(high)), Interval(mpq(3), mpq(7))
    for n in (3, 4, 5):
        draw, count = Random(n), 0
        while count < 2:
            first, second = any_rows(draw, n, 9), any_rows(draw, n, 9)
            for point in meetings(forms(first), forms(second)).points:
                here = parameter(point.first, side, other)
                local = parameter(point.first, Interval(mpq(0), mpq(1)), Interval(mpq(0), mpq(1)))
                for digits in (0, 3, 30):
                    a, b = here.enclosure(digits)
                    assert b - a <= mpq(1, 10**digits)
                    c, d = local.enclosure(digits + 9)
                    assert low + (high - low) * c <= b
                    assert low + (high - low) * d >= a
                count += 1


def test_a_part_that_ends_at_a_cusp_does_not_cross_there():
    """The end of the second curve, where the first has one parameter twice."""
    cusp = Nurbs(3, [0] * 4 + [1] * 4, [(1, 1), (0, -1), (0, 1), (1, -1)])
    whole = plane_forms(cusp, 0)
    for a, b in ((0, "1/2"), ("1/2", 1), (0, 1), ("1/3", "1/2")):
        found = meetings(whole, plane_forms(cusp.restrict(a, b), 0))
        assert (len(found.points), len(found.arcs)) == (0, 1)


def test_sums_of_parameters_with_values_close_together():
    """A mutant did not end: both factors vanish nearly at the sum, with as many bits as a first try has."""
    near = mpq(1, 3) + mpq(1, 10**40)
    factors = [fmpz_poly([-int(x.numerator), int(x.denominator)]) for x in (mpq(2, 3), 2 * near)]
    eliminant = factors[0] * factors[1] ** 2
    for z, times in ((mpq(1, 3), 1), (near, 2)):
        assert multiplicity_of_sum(eliminant, of_z(z), irrationally(z), 1) == times


def irrationally(z):
    """The same place as one that is isolated, not known to be rational."""
    (zero,) = isolate(fmpz_poly([-int(z.numerator), int(z.denominator)]), 1).inner
    return Place(zero)


@pytest.mark.parametrize("n", [3, 4, 5])
def test_a_curve_and_itself_have_no_common_end_without_a_crossing(n):
    """The forms of the matrix have degree n − 2: with more of them there were zeros at the end."""
    draw = Random(n)
    for rows in (any_rows(draw, n, 9), ending_on_itself(any_rows(draw, n, 9), Fraction(1, 3))):
        isolation = self_elimination(forms(rows)).isolation
        assert [isolation.at_left, isolation.at_right] == [0, int(rows[-1] != rows[0] and isolation.at_right > 0)]
    assert isolation.at_right == 1


def test_a_parameter_close_to_the_end_belongs_to_a_fibre():
    """A mutant divided by zero: the interval of the parameter ends at 1."""
    for far in (mpq(10**14), mpq(10**30)):
        curve = through(Random(1), 3, [mpq(1), far])
        assert [Fibre(curve, curve, of_z(mpq(1))).contains(irrationally(z)) for z in (far, far + 1)] == [True, False]
        assert [irrationally(far).sign(fmpz_poly([-int(far) + k, 1]), 1) for k in (-1, 0, 1)] == [-1, 0, 1]


def test_a_parameter_whose_interval_ends_in_another_one():
    """A mutant passed: the fibre contains z = 1, at which the interval of another parameter begins or ends."""
    curve = through(Random(1), 3, [mpq(1), mpq(5)])
    for distance in (10**14, 10**40):
        for sign in (1, -1):
            both = fmpz_poly([-1, 1]) * fmpz_poly([-(distance + sign), distance])
            one, other = map(Place, isolate(both, 2).inner)
            expected = [True, False] if sign == 1 else [False, True]
            assert [Fibre(curve, curve, of_z(mpq(5))).contains(x) for x in (one, other)] == expected


@pytest.mark.parametrize("n", [3, 4, 5])
def test_entries_of_an_adjugate(n):
    """The adjugate times the matrix is the determinant; balls around its entries contain them."""
    draw = Random(n)
    first, second = forms(any_rows(draw, n, 9)), forms(any_rows(draw, 2, 9))
    eliminated = elimination(first, second)
    rows = [[eliminated.cofactor(j, i) for j in range(n)] for i in range(n)]
    for i, row in enumerate(rows):
        for j in range(n):
            total = sum((x * other[j] for x, other in zip(row, eliminated.matrix, strict=True)), fmpz_poly([]))
            assert total == (eliminated.determinant if i == j else fmpz_poly([]))
    assert [eliminated.first, eliminated.second, eliminated.last] == [rows[0][0], rows[1][0], rows[-1][-1]]
    for entry in ("first", "second", "last"):
        assert eliminated._entry(entry, arb(3)).contains(getattr(eliminated, entry)(3))


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_the_end_of_one_curve_on_another_one(n):
    """There one parameter belongs to the point, though the map is infinite; and 0 at the start, by balls, too."""
    draw = Random(n)
    rows = any_rows(draw, n, 9)
    for end, other in ((0, 1), (-1, 0)):
        for place in (Fraction(1, 3), Fraction(1, 2)):
            weight = rows[end][2]
            line = [(draw.randint(-9, 9) * weight, draw.randint(-9, 9) * weight, weight), ()]
            line[1] = tuple(a / place - b * (1 - place) / place for a, b in zip(rows[end], line[0], strict=True))
            eliminated = Elimination(elimination(forms(rows), forms(line)).matrix, 1)
            found = [x for x in places(eliminated.isolation) if x.rational == mpq(place.numerator, place.denominator)]
            assert len(found) == 1
            isolated = [Place(x.zero) for x in found]
            assert all(eliminated.is_simple(x) for x in (*found, *isolated))
            assert [eliminated.partner(x).exact for x in (*found, *isolated)] == [1 - other] * 2


def test_a_curve_of_degree_2_that_turns_back():
    (arc,) = self_meetings(forms([(0, 0, 1), (4, 0, 1), (0, 0, 1)])).arcs
    assert [place.exact for place in arc.second] == [mpq(1, 2), 1]


def test_a_sign_at_a_place_close_to_the_end():
    """A mutant did not end: the interval of the first precision ends at 1, where z is infinite."""
    (zero,) = isolate(fmpz_poly([-2 * 10**60, 0, 1]), 2).inner
    assert [Place(zero).sign(fmpz_poly([-k * 10**30, 1]), 1) for k in (1, 2)] == [1, -1]
