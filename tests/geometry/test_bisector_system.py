"""The system of three planes over a pair of pieces: cusps, common factors, paths, and what vanishes together."""

from math import comb

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, Nurbs, zeros
from exactspline.geometry.bisectors import single_pairs, special_pairs
from exactspline.geometry.bisectors.lines import Path, along
from exactspline.geometry.bisectors.single_pairs import zeros_of_vector
from exactspline.geometry.bisectors.special_pairs import graph_intervals, runs_on
from exactspline.geometry.bisectors.system import System, piece, vanish_together
from exactspline.numbers.intervals import UNIT
from exactspline.polynomials.two_parameters import S, T
from tests.support.bisector_oracle import FAMILIES


@pytest.mark.parametrize(("meet", "expected"), [(True, "all of space"), (False, "plane"), (None, None)])
def test_cusps_have_all_of_space_only_where_they_certainly_meet(monkeypatch, meet, expected):
    monkeypatch.setattr(special_pairs, "vanish_together", lambda polynomials, s, t: meet)
    first, second = FAMILIES["two cusps in one point"]
    found = special_pairs.over_both_cusps(System(piece(first, 0), piece(second, 0)))
    assert [pair.solutions for pair in found.pairs] == ([] if expected is None else [expected])
    assert len(found.undecided) == (expected is None)


@pytest.mark.parametrize("touch", [True, False, None])
def test_curves_cross_only_where_they_certainly_do_not_touch(monkeypatch, touch):
    """Passed before: "a line of solutions" at a common point of which it is not decided whether the curves touch."""
    ends = ((1, 0, 0), (2, 1, 0)), ((0, 1, 1), (1, 2, 5))
    first, second = (Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0, 0), *own]) for own in ends)
    system = System(piece(first, 0), piece(second, 0))
    monkeypatch.setattr(single_pairs, "vanish_together", lambda polynomials, s, t: touch)
    found = single_pairs.singles(system, [], [(mpq(0), mpq(0))])
    kinds = [pair.solutions for pair in found.pairs]
    assert kinds == {True: ["plane"], False: ["line"], None: []}[touch]
    assert bool(found.undecided) == (touch is None)


def test_a_piece_has_no_factor_in_common():
    """Of (2t, t², 1 − t)/(1 + t) with numerators and denominator times 1 + t²."""
    own = [fmpz_poly(p) for p in ([0, 2], [0, 0, 1], [1, -1], [1, 1])]

    def curve(degree, factor):
        rows = [
            [sum(mpq(comb(i, k), comb(degree, k)) * int((p * factor)[k]) for k in range(i + 1)) for p in own]
            for i in range(degree + 1)
        ]
        return Nurbs.from_homogeneous(degree, [0] * (degree + 1) + [1] * (degree + 1), rows)

    plain, more = piece(curve(2, fmpz_poly([1])), 0), piece(curve(4, fmpz_poly([1, 0, 1])), 0)
    assert (plain.p, plain.w) == (own[:3], own[3])
    assert (more.p, more.w, more.tangent, more.cusps) == (plain.p, plain.w, plain.tangent, ())


def test_tangents_of_a_piece_have_no_zero_and_its_cusps_are_told():
    """Of (t², t³, 0)."""
    half = Nurbs(3, [-1] * 4 + [1] * 4, [("1", -1, 0), ("-1/3", 1, 0), ("-1/3", -1, 0), (1, 1, 0)])
    own = piece(half, 0)
    assert [f.degree() for f in own.tangent] == [0, 1, -1]
    assert own.cusps == (fmpz_poly([0, 1]),)
    assert not own.stands_still


def test_polynomials_of_one_of_two_irrational_parameters_vanish_at_that_one():
    """At s = √½ and t = √⅓."""
    (s,), (t,) = zeros(BSpline.bezier([-1, -1, 1])), zeros(BSpline.bezier([-1, -1, 2]))
    for p, expected in ((2 * S * S - 1, True), (3 * T * T - 1, True), (3 * S * S - 1, False), (2 * T * T - 1, False)):
        assert vanish_together([p], s, t) is expected
    assert vanish_together([6 * S * S * T * T - 1, 2 * S * S - 3 * T * T], s, t) is True
    assert vanish_together([6 * S * T - 1], s, t) is False


def test_where_a_vector_vanishes_the_condition_beside_it_holds():
    """(A C, B D, 0) with the condition A B, whose zeros are not all: none with C = D = 0."""
    a, b, c, d = 4 * S - 1, 4 * T - 1, 4 * S - 3, 4 * T - 3
    sides = UNIT
    places, left_out = zeros_of_vector(a * b, [a * c, b * d, S * 0], sides)
    assert ({tuple(map(mpq, p)) for p in places}, left_out) == (
        {(mpq(1, 4), mpq(1, 4)), (mpq(1, 4), mpq(3, 4)), (mpq(3, 4), mpq(1, 4))},
        (),
    )
    assert zeros_of_vector(None, [a * c, b * d, S * 0], sides)[1] == ()
    assert len(zeros_of_vector(None, [a * c, b * d, S * 0], sides)[0]) == 4


def test_a_quotient_that_touches_the_end_of_its_range_stays_inside():
    """(2t − 1)² touches 0; (2t − 1)² − 1/4 leaves [0, 1] in between; −(2t − 1)² has one parameter there."""
    unit = mpq(0), mpq(1)
    square = fmpz_poly([1, -4, 4])
    assert graph_intervals(square, fmpz_poly([1]), unit, unit) == [unit]
    assert graph_intervals(4 * square - 1, fmpz_poly([4]), unit, unit) == [(0, mpq(1, 4)), (mpq(3, 4), 1)]
    assert graph_intervals(-square, fmpz_poly([1]), unit, unit) == [(mpq(1, 2), mpq(1, 2))]


def test_polynomials_along_a_path_are_their_values_times_one_power():
    """With s = z/2 and t = (z + 1)/(z + 3), of degrees 1 and 2."""
    z = fmpz_poly([0, 1])
    first, second = along([S * T * T + 1, 3 * S - T], Path((z, fmpz_poly([2])), (z + 1, z + 3)))
    power = 2 * (z + 3) ** 2
    assert 2 * first == z * (z + 1) ** 2 * 2 + 2 * power
    assert second == 3 * z * (z + 3) ** 2 - 2 * (z + 1) * (z + 3)


@pytest.mark.parametrize("direction", [(1, 2, 3), (2, 4, 7), (-1, -2, -3), (0, 0, 1), (1, 2, 0)])
@pytest.mark.parametrize("speed", [1, 5])
def test_a_polygon_runs_on_where_its_sides_have_one_direction(direction, speed):
    """Whatever their lengths; of (−1, −2, −3) the other way it turns back on the same line."""
    first = (1, 2, 3)
    points = [(0, 0, 0), first, tuple(a + speed * b for a, b in zip(first, direction, strict=True))]
    polygon = Nurbs(1, [0, 0, 1, 2, 2], points)
    assert runs_on(polygon, mpq(1)) is (direction in (first, (-1, -2, -3)))
