"""The language over numbers and over splines: vectors and their products against sympy, quotients against direct
evaluation.
"""

import pytest
import sympy
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactspline import BSpline
from exactspline.errors import FormulaError, ShapeError
from exactspline.language import Vector, cross, det, dot, generalized_cross, norm2, perp, triple, wronskian
from exactspline.language.arguments import Curve
from exactspline.language.kinds import CURVE
from exactspline.readings import DegreeReading, JetReading, series_curve
from exactspline.readings.degree import Degree
from exactspline.readings.tree import TreeReading
from tests.support.strategies import numbers, splines_on_one_domain, vectors


def number_vectors(count, dimension):
    return st.lists(
        st.lists(numbers(), min_size=dimension, max_size=dimension).map(lambda x: Vector(*x)),
        min_size=count,
        max_size=count,
    )


def sympy_det(rows):
    matrix = sympy.Matrix(
        [[sympy.Rational(int(mpq(x).numerator), int(mpq(x).denominator)) for x in row] for row in rows]
    )
    value = matrix.det(method="berkowitz")
    return mpq(int(value.p), int(value.q))


# ---- products of vectors


@given(st.integers(2, 5).flatmap(lambda n: number_vectors(n, n)))
def test_det_is_the_determinant(rows):
    assert det(*rows) == sympy_det(rows)
    assert det(rows[1], rows[0], *rows[2:]) == -det(*rows)
    assert det(rows[0], rows[0], *rows[2:]) == 0


@given(st.integers(2, 5).flatmap(lambda n: number_vectors(n, n)))
def test_generalized_cross_is_orthogonal_and_completes_the_determinant(rows):
    *first, last = rows
    normal = generalized_cross(*first)
    assert [dot(normal, row) for row in first] == [0] * len(first)
    assert dot(normal, last) == sympy_det(rows) == det(*rows)
    assert det(*first, normal) == norm2(normal)


@given(number_vectors(3, 3))
def test_products_in_space(rows):
    a, b, c = rows
    assert triple(a, b, c) == dot(cross(a, b), c) == dot(a, cross(b, c))
    assert cross(a, b) == -cross(b, a) == generalized_cross(a, b)
    assert cross(a, cross(b, c)) == b * dot(a, c) - c * dot(a, b)
    assert norm2(cross(a, b)) == norm2(a) * norm2(b) - dot(a, b) * dot(a, b)


@given(number_vectors(2, 2))
def test_signs_in_the_plane(rows):
    a, b = rows
    assert perp(a) == Vector(-a[1], a[0]) == generalized_cross(a)
    assert det(a, b) == dot(perp(a), b) == a[0] * b[1] - a[1] * b[0]
    assert det(a, perp(a)) == norm2(a) == dot(a, a)
    assert perp(perp(a)) == -a


def test_orientation_by_examples():
    east, north = Vector(1, 0), Vector(0, 1)
    assert perp(east) == north
    assert det(east, north) == 1
    assert cross(Vector(1, 0, 0), Vector(0, 1, 0)) == Vector(0, 0, 1)
    assert cross(Vector(0, 1, 0), Vector(0, 0, 1)) == Vector(1, 0, 0)
    assert generalized_cross(Vector(1, 0, 0, 0), Vector(0, 1, 0, 0), Vector(0, 0, 1, 0)) == Vector(0, 0, 0, 1)


@given(vectors(3), st.sampled_from([mpq(2), mpq(-1, 3), mpq(0)]))
def test_vectors_of_splines(v, c):
    t = v[0].domain[0] + (v[0].domain[1] - v[0].domain[0]) / 7
    here = [x(t) for x in v]
    assert [x(t) for x in v + v.d()] == [x + y.d()(t) for x, y in zip(here, v, strict=True)]
    assert [x(t) for x in c * v - v / 3] == [(c - mpq(1, 3)) * x for x in here]
    assert [x(t) for x in v * v[1]] == [x * here[1] for x in here]
    assert dot(v, v)(t) == sum(x * x for x in here)
    assert dot(v, v).d() == 2 * dot(v, v.d())
    assert cross(v, v.d()).d() == cross(v, v.d(2))
    assert det(v, v.d(), v.d(2)).d() == det(v, v.d(), v.d(3))
    assert v.degree == max(x.degree for x in v)
    assert v.d(0) == v
    assert (v - v).is_zero


@given(splines_on_one_domain(2, low=0, high=3), st.lists(st.integers(-3, 3).map(mpq), min_size=4, max_size=4))
def test_wronskian_vanishes_for_dependent_functions(fs, c):
    f, g = fs
    assert wronskian(Vector(f, g)) == f * g.d() - g * f.d()
    assert wronskian(Vector(f, g, c[0] * f + c[1] * g)).is_zero
    assert wronskian(Vector(f, c[0] * f)).is_zero
    assert wronskian(Vector(f, g, f * g, c[0] * f + c[1] * g + c[2] * f * g)).is_zero


def test_wronskian_of_independent_functions():
    t = BSpline.identity(0, 1)
    one = t.constant(1)
    assert wronskian(Vector(one, t, t * t)) == t.constant(2)
    assert wronskian(Vector(one, t, t**2, t**3)) == t.constant(12)


def test_wrong_dimensions_are_told():
    plane, space = Vector(1, 2), Vector(1, 2, 3)
    for wrong in (
        lambda: plane + space,
        lambda: plane - space,
        lambda: dot(plane, space),
        lambda: cross(plane, plane),
        lambda: cross(space, plane),
        lambda: perp(space),
        lambda: det(plane),
        lambda: det(plane, plane, plane),
        lambda: det(space, space),
        lambda: generalized_cross(plane, space),
        generalized_cross,
        lambda: plane * plane,
        lambda: (plane / BSpline.bezier([1])) * plane,
    ):
        with pytest.raises(ShapeError):
            wrong()


# ---- operands are not truth values, no power but by counting


def operands():
    t = BSpline.identity(1, 2)
    curve = Curve(Vector(t, t), t)
    return [
        t,
        t / t,
        Vector(t, t),
        Vector(t, t) / t,
        JetReading(1).argument(CURVE, 2).w,
        DegreeReading().argument(CURVE, 2).w,
        series_curve(curve, 1, 2).w,
        TreeReading().argument(CURVE, 3).w,
        TreeReading().argument(CURVE, 3).p,
    ]


@pytest.mark.parametrize("x", operands(), ids=lambda x: type(x).__name__)
def test_formulas_cannot_branch(x):
    with pytest.raises(FormulaError, match="truth value"):
        bool(x)
    with pytest.raises(FormulaError, match="truth value"):
        _ = x and 1
    with pytest.raises(FormulaError, match="truth value"):
        _ = not x


@pytest.mark.parametrize("exponent", [0, -1, "2", 1.0, mpq(2)], ids=repr)
def test_powers_are_positive_integers(exponent):
    with pytest.raises(FormulaError, match="exponent"):
        BSpline.identity(0, 1) ** exponent


def test_readings_do_not_mix():
    t = BSpline.identity(0, 1)
    for other in (JetReading(1).argument(CURVE, 2).w, Degree.named("d")):
        for wrong in (lambda x: t + x, lambda x: t - x, lambda x: t * x, lambda x: x + t, lambda x: x * t):
            with pytest.raises((TypeError, FormulaError)):
                wrong(other)
