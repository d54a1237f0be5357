"""Bézout's matrix and its adjugate: determinants by three ways, fibres of multiple points, arcs of one curve."""

import random
from fractions import Fraction

import pytest
from flint import fmpz, fmpz_poly

from exactspline import Nurbs
from exactspline.errors import ReachError
from exactspline.polynomials import bezout
from exactspline.polynomials.bezout import PlaneForms, bezout_matrix, determinant, self_matrix
from exactspline.polynomials.common_arcs import RationalMap, common_arcs
from exactspline.polynomials.plane_pairs import meetings, self_meetings
from exactspline.polynomials.zero_places import Place
from exactspline.roots.local_parameters import plane_forms


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
