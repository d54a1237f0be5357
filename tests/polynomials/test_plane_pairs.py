"""Bézout's matrix and its adjugate: determinants by three ways, fibres of multiple points, arcs of one curve."""

import random
from fractions import Fraction

import pytest
from flint import fmpq, fmpz, fmpz_poly
from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.errors import ReachError
from exactspline.numbers.exact import to_fmpq
from exactspline.polynomials import bezout
from exactspline.polynomials.bezout import PlaneForms, bezout_matrix, determinant, self_matrix
from exactspline.polynomials.common_arcs import RationalMap, common_arcs
from exactspline.polynomials.isolation import isolate
from exactspline.polynomials.plane_pairs import Fibre, meetings, self_meetings
from exactspline.polynomials.zero_places import Place, at, places
from exactspline.roots.segment_forms import plane_forms


def bezier(*points):
    n = len(points) - 1
    return plane_forms(Nurbs(n, [0] * (n + 1) + [1] * (n + 1), points), 0)


def random_forms(seed, n):
    draw = random.Random(seed)
    return bezier(*[(draw.randint(-50, 50), draw.randint(-50, 50)) for _ in range(n + 1)])


def leibniz(matrix):
    """The determinant by its first row."""
    if not matrix:
        return fmpz_poly([1])
    total = fmpz_poly([])
    for j, x in enumerate(matrix[0]):
        total += x * leibniz(bezout.without(matrix, 0, j)) * (-1 if j % 2 else 1)
    return total


@pytest.mark.parametrize(("size", "degree"), [(1, 3), (2, 3), (3, 2), (4, 2), (5, 4), (6, 2), (7, 1)])
def test_determinants_by_all_ways_are_that_of_leibniz(size, degree):
    draw = random.Random(size)
    matrix = [
        [fmpz_poly([draw.randint(-(2**60), 2**60) for _ in range(degree + 1)]) for _ in range(size)]
        for _ in range(size)
    ]
    assert determinant(matrix, degree) == leibniz(matrix)


def test_a_determinant_that_vanishes_is_zero():
    row = [fmpz_poly([1, 2]), fmpz_poly([3]), fmpz_poly([0, 1]), fmpz_poly([1])]
    assert not determinant([row, row, row[::-1], row], 1)
    assert not determinant([row + row] * 8, 1)


@pytest.mark.parametrize("degree", [1, 2, 3, 4, 5, 6])
def test_the_vectors_of_a_parameter_are_in_the_kernel_where_the_point_is_on_the_curve(degree):
    curve = random_forms(degree, degree)
    z = 3
    point = PlaneForms(0, *[fmpz_poly([f(z)]) for f in curve.forms])
    matrix = bezout_matrix(curve, point)
    vector = [fmpz(z) ** k for k in range(degree)]
    assert all(sum(x(0) * v for x, v in zip(row, vector, strict=True)) == 0 for row in matrix)


def test_the_matrix_of_a_curve_and_itself_is_singular_at_its_node():
    u = [Fraction(-3, 2), Fraction(3)]  # node at u = ±1: t = 1/6 and 5/6
    x = [u[0] ** 2 - 1, 2 * u[0] * u[1], u[1] ** 2]
    y = [u[0] * x[0], u[0] * x[1] + u[1] * x[0], u[0] * x[2] + u[1] * x[1], u[1] * x[2]]
    points = [
        tuple(
            sum(Fraction(_binomial(i, j), _binomial(3, j)) * p[j] for j in range(min(i, len(p) - 1) + 1))
            for p in (x, y)
        )
        for i in range(4)
    ]
    curve = bezier(*points)
    f = determinant(self_matrix(curve), 1)
    assert [f(fmpz(1)) == 0, (5 * fmpz_poly([0, 1]) - 1) * (fmpz_poly([0, 1]) - 5) * f[2] == 5 * f] == [False, True]
    (found,) = self_meetings(curve).points
    assert found.second.multiplicity == found.multiplicity == 1


def _binomial(n, k):
    from math import comb

    return comb(n, k)


def test_a_place_decides_a_sign_that_balls_cannot_separate():
    """√2 is told from a rational that agrees with it in 400 bits, and from a zero of another polynomial with it."""
    from math import isqrt

    from exactspline.polynomials.isolation import isolate

    (zero,) = isolate(fmpz_poly([-2, 0, 1]), 2).inner
    near = isqrt(2 << 800)
    assert [Place(zero).sign(fmpz_poly([-(near + k), 1 << 400]), 1) for k in (0, 1)] == [1, -1]
    assert Place(zero).sign(fmpz_poly([-2, 0, 1]) * fmpz_poly([-3, 1]), 3) == 0


def test_arcs_of_a_map_that_folds_are_monotone():
    # z = (z − 1)²/… folds at z = 1
    folded = RationalMap(2, fmpz_poly([1, -2, 1]), fmpz_poly([1]))
    found = common_arcs(folded)
    assert [[x.exact for x in arc.second] for arc in found.arcs] == [[0, Fraction(1, 2)], [Fraction(1, 2), 1]]


def test_curves_that_both_run_over_an_arc_twice_are_out_of_reach_by_name():
    """No false answer for two curves whose common parametrization is not computed."""
    there_and_back = bezier((0, 0), (1, 0), (1, 2), (1, 0), (0, 0))
    (arc,) = self_meetings(there_and_back).arcs
    assert [x.exact for x in arc.second] == [Fraction(1, 2), 1]
    with pytest.raises(ReachError, match="run over one arc several times"):
        meetings(there_and_back, there_and_back)


def test_two_straight_curves_of_higher_degree_on_two_lines_meet_in_all_pairs():
    fold = bezier((0, 0), (4, 0), (0, 0))  # 8 t (1 − t): 1 at two parameters
    other = bezier((1, -1), (1, 3), (1, -1))
    assert len(meetings(fold, other).points) == 4


def test_three_branches_through_one_point():
    """x = p(u), y = u p(u) with p = u (u² − 1) passes through the origin at u = −1, 0 and 1."""
    from tests.campaigns.intersections import bezier_rows, multiplied

    u = [Fraction(-3, 2), Fraction(3)]
    p = multiplied(multiplied(u, [u[0] - 1, u[1]]), [u[0] + 1, u[1]])
    rows = bezier_rows([p, multiplied(u, p), [1]])
    curve = plane_forms(Nurbs.from_homogeneous(4, [0] * 5 + [1] * 5, rows), 0)
    found = self_meetings(curve)
    assert sorted(point.multiplicity for point in found.points) == [1, 1, 1]
    line = bezier((-1, -2), (1, 2))
    at_origin = [m for m in meetings(line, curve).points if m.first.map.at(m.second)]
    assert len(at_origin) == 3
    # and half of it, reversed: each branch meets the two others once, beside the arc that both have
    part = Nurbs.from_homogeneous(4, [0] * 5 + [1] * 5, rows).restrict("1/9", "8/9")
    both = meetings(curve, plane_forms(part, 0))
    assert len(both.arcs) == 1
    assert [point.multiplicity for point in both.points] == [1] * 6


def scaled(curve, factor):
    """The same curve by forms with a common factor."""
    return PlaneForms(curve.degree + factor.degree(), *[f * factor for f in curve.forms])


def told(found):
    return (
        [point.multiplicity for point in found.points],
        [[x.refine(30) for x in (*arc.first, *arc.second)] for arc in found.arcs],
    )


CUSP = bezier((1, 1), (0, -1), (0, 1), (1, -1))
LOOP = bezier((0, 0), (4, 3), (-3, 3), (1, 0))


@pytest.mark.parametrize("curve", [CUSP, LOOP], ids=["cusp", "loop"])
def test_a_cusp_is_no_crossing_and_a_common_factor_changes_nothing(curve):
    """Would pass otherwise: a curve crosses itself at its cusp, or at a zero of a factor of its forms."""
    found = told(meetings(curve, curve))
    assert len(found[0]) == (0 if curve is CUSP else 2)
    assert len(found[1]) == 1
    factor = fmpz_poly([3, -2])
    assert told(meetings(curve, scaled(curve, factor))) == found == told(meetings(scaled(curve, factor), curve))
    assert told(meetings(scaled(curve, factor), scaled(curve, factor))) == found


def test_the_parameters_of_a_point_are_counted_once():
    """The cusp is a double zero of the polynomial of parameters, the ends are zeros that it does not show."""
    assert Fibre(CUSP, CUSP, mpq_place(1, 2)).size == 1 == Fibre(CUSP, CUSP, mpq_place(1, 3)).size
    closed = bezier((0, 0), (3, 1), (1, 3), (0, 0))
    for end in (0, 1):
        fibre = Fibre(closed, closed, mpq_place(end, 1))
        assert (fibre.size, fibre.at_start, fibre.at_end) == (2, True, True)
    assert Fibre(LOOP, LOOP, mpq_place(0, 1)).size == 1 == Fibre(LOOP, LOOP, mpq_place(1, 1)).size


def mpq_place(top, bottom):
    return at(mpq(top, bottom), 1)


def test_an_end_that_lies_on_the_curve():
    """x = (t − 1)(3t − 1), y = t x: at 1/3 and at the end it is at the origin."""
    curve = bezier((1, 0), (Fraction(-1, 3), Fraction(1, 3)), (Fraction(-2, 3), Fraction(-2, 3)), (0, 0))
    (found,) = self_meetings(curve).points
    assert (found.second.exact, found.multiplicity) == (1, 1)


@pytest.mark.parametrize("seed", range(12))
def test_arcs_of_straight_curves_have_all_pairs_of_parameters(seed):
    """Of a value that both coordinates take somewhere, as many arcs as pairs of parameters; folds are irrational."""
    draw = random.Random(seed)
    # an end at 0 lowers the degree of the coordinate below that of the weight
    ends = [(0, 0)] * (seed % 2)
    curves = [
        bezier(*[(draw.randint(-9, 9), 0) for _ in range(n - len(ends))], *ends) for n in (4, draw.choice([3, 4]))
    ]
    found = meetings(*curves)

    def value(curve, place):
        bounds = place.refine(60)
        t = sum(bounds) / 2
        return None if t == 1 else curve.x(to_fmpq(t / (1 - t))) / curve.w(to_fmpq(t / (1 - t)))

    ranges = []
    for arc in found.arcs:
        for pair in zip(arc.first, arc.second, strict=True):
            one, other = (
                curve.x[curve.degree] / curve.w[curve.degree] if x is None else x
                for curve, x in zip(curves, map(value, curves, pair), strict=True)
            )
            assert abs(one - other) < fmpq(1, 10**12)
            ranges.append(one)
    for k in range(-17, 18, 2):
        v = fmpq(k, 2) + fmpq(1, 97)
        counts = [len(places(isolate(c.x * v.q - c.w * v.p, c.degree))) for c in curves]
        spans = list(zip(ranges[::2], ranges[1::2], strict=True))
        assert sum(min(span) < v < max(span) for span in spans) == counts[0] * counts[1]


def test_the_end_of_a_curve_on_the_other_one():
    first, second = bezier((0, 0), (1, 2), (2, -1), (3, 1)), bezier((2, 0), (3, 2), (3, 0), (4, 2))
    ends = [m.second for m in meetings(first, second).points if isinstance(m.first, Place) and m.first.exact == 1]
    assert [end.exact for end in ends] == [Fraction(1, 2)]


def test_a_curve_that_turns_back_at_a_third():
    """x = q, y = q² for q = (t − 1/3)²: it runs over its first third again."""
    from tests.campaigns.intersections import bezier_rows, multiplied

    q = [Fraction(1, 9), Fraction(-2, 3), Fraction(1)]
    rows = bezier_rows([q, multiplied(q, q), [1]])
    (arc,) = self_meetings(plane_forms(Nurbs.from_homogeneous(4, [0] * 5 + [1] * 5, rows), 0)).arcs
    assert [place.exact for place in arc.second] == [Fraction(1, 3), Fraction(2, 3)]
