"""Quotients: the 17 rows of Table 1, what is shared, what is multiplied, what is raised; all against direct
evaluation.
"""

from types import SimpleNamespace

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactspline import BSpline, formula_of
from exactspline.errors import FormulaError
from exactspline.language import Rational, Vector, cross, dot
from exactspline.readings.degree import Degree
from tests.support.strategies import DOMAINS, knot_vectors, numbers, positive_numbers

ROWS = {name: formula_of(name) for name in (f"T{i}" for i in range(1, 18))}

#: The column "carried out as": numerator and denominator, multiplied out by hand.
CARRIED_OUT = {
    "T3": lambda t: (t.p1, t.p2),
    "T4": lambda t: (t.p1 + t.p2 * t.w1, t.w1),
    "T5": lambda t: (t.p1 * t.w2 + t.p2 * t.w1, t.w1 * t.w2),
    "T6": lambda t: (t.p1 * t.p2, t.w1),
    "T7": lambda t: (t.p1 * t.p2, t.w1 * t.w2),
    "T8": lambda t: (t.p1, t.w1 * t.p2),
    "T9": lambda t: (t.p1 * t.w2, t.w1 * t.p2),
    "T12": lambda t: (cross(t.v1, t.v2), t.w1),
    "T13": lambda t: (cross(t.v1, t.v2), t.w1 * t.w2),
    "T14": lambda t: (dot(t.v1, t.v2), t.w1),
    "T15": lambda t: (dot(t.v1, t.v2), t.w1 * t.w2),
    "T17": lambda t: (t.p1.d() * t.w1 - t.p1 * t.w1.d(), t.w1 * t.w1),
}


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


#: What each row is in numbers: p1, w1, p2, w2, then v1, v2 as tuples, then the derivatives of p1 and w1.
VALUES = {
    "T1": lambda p, w, q, u, v, z, dp, dw: p + q,
    "T2": lambda p, w, q, u, v, z, dp, dw: p * q,
    "T3": lambda p, w, q, u, v, z, dp, dw: p / q,
    "T4": lambda p, w, q, u, v, z, dp, dw: p / w + q,
    "T5": lambda p, w, q, u, v, z, dp, dw: p / w + q / u,
    "T6": lambda p, w, q, u, v, z, dp, dw: p / w * q,
    "T7": lambda p, w, q, u, v, z, dp, dw: p / w * (q / u),
    "T8": lambda p, w, q, u, v, z, dp, dw: p / w / q,
    "T9": lambda p, w, q, u, v, z, dp, dw: (p / w) / (q / u),
    "T10": lambda p, w, q, u, v, z, dp, dw: _cross(v, z),
    "T11": lambda p, w, q, u, v, z, dp, dw: sum(x * y for x, y in zip(v, z, strict=True)),
    "T12": lambda p, w, q, u, v, z, dp, dw: tuple(x / w for x in _cross(v, z)),
    "T13": lambda p, w, q, u, v, z, dp, dw: tuple(x / w / u for x in _cross(v, z)),
    "T14": lambda p, w, q, u, v, z, dp, dw: sum(x / w * y for x, y in zip(v, z, strict=True)),
    "T15": lambda p, w, q, u, v, z, dp, dw: sum(x / w * (y / u) for x, y in zip(v, z, strict=True)),
    "T16": lambda p, w, q, u, v, z, dp, dw: dp,
    "T17": lambda p, w, q, u, v, z, dp, dw: (dp * w - p * dw) / w**2,
}


@st.composite
def table_operands(draw):
    """Operands of Table 1: p1, w1 and v1 of degree d1, p2, w2 and v2 of degree d2, over knots of their own; w1, w2 and
    p2 positive.
    """
    domain = draw(st.sampled_from(DOMAINS))

    def spline(n, values):
        knots = draw(knot_vectors(n, domain, 1))
        count = len(knots) - n - 1
        return BSpline(n, knots, draw(st.lists(values, min_size=count, max_size=count)))

    d1, d2 = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    named = {}
    for i, n in ((1, d1), (2, d2)):
        named[f"p{i}"] = spline(n, numbers() if i == 1 else positive_numbers())
        named[f"w{i}"] = spline(n, positive_numbers())
        named[f"v{i}"] = Vector(*[spline(n, numbers()) for _ in range(3)])
    return SimpleNamespace(**named), {"d1": d1, "d2": d2}


def degree_operands():
    d1, d2 = (lambda: Degree.named("d1")), (lambda: Degree.named("d2"))
    return SimpleNamespace(p1=d1(), w1=d1(), p2=d2(), w2=d2(), v1=Vector(d1(), d1(), d1()), v2=Vector(d2(), d2(), d2()))


def called(x, t):
    return tuple(a(t) for a in x) if isinstance(x, Vector) else x(t)


def assert_row(row, t, degrees):
    """One row of the table on one set of operands: degrees, numerator and denominator as carried out, and values."""
    result, counted = ROWS[row](t), ROWS[row](degree_operands())
    assert result.degree == counted.degree.at(degrees)
    if isinstance(result, Rational):
        numerator, denominator = CARRIED_OUT[row](t)
        assert result.numerator == numerator
        assert result.denominator == denominator
        assert result.numerator.degree == counted.numerator.degree.at(degrees)
        assert result.denominator.degree == counted.denominator.degree.at(degrees) == denominator.degree
        assert max(x.degree for x in result.elevated()) == min(x.degree for x in result.elevated()) == result.degree
    a, b = t.w1.domain
    for x in [a, b, *[a + (b - a) * mpq(k, 13) for k in (1, 5, 12)]]:
        at = [called(o, x) for o in (t.p1, t.w1, t.p2, t.w2, t.v1, t.v2, t.p1.d(), t.w1.d())]
        assert called(result, x) == VALUES[row](*at)


@settings(max_examples=15)
@given(table_operands())
def test_table_1(operands):
    for row in ROWS:
        assert_row(row, *operands)


def test_the_degree_column_of_table_1():
    column = {name: ROWS[name](degree_operands()).degree for name in ROWS}
    expected = dict.fromkeys(ROWS, "d1 + d2") | {
        "T1": "max(d2, d1)",
        "T3": "max(d2, d1)",
        "T16": "d1 − 1",
        "T17": "2d1",
    }
    assert {name: repr(degree) for name, degree in column.items()} == expected


# ---- quotients: what is shared, what is multiplied, what is raised


def materials():
    t = BSpline.identity(0, 2)
    return t + 1, t * t + 2, t * t - 3, t * t * t + 1


def test_quotients_over_one_denominator_share_it():
    w, p, q, _ = materials()
    for r in (
        p / w + q / w,
        p / w - q / w,
        p / (w * w) + q / (w * w),
        p / w**2 + q / (w * w),
        (p / w).d() + (q / w).d(),
        (p / w).d() + q / w**2,
        (p / w) / w + (q / w) * (1 / w),
        sum([q / w, q / w], p / w),
        p / (2 * w) + q / (2 * w),
    ):
        single = r.denominator.degree
        assert single == (1 if r.denominator in (w, 2 * w) else 2)
        assert r.denominator in (w, w * w, 2 * w)
    assert (p / w + q / w).numerator == p + q
    assert ((p / w).d(2) - (q / w).d(2)).denominator == w**4


def test_degrees_share_what_splines_share():
    d, w = Degree.named("d"), Degree.named("d")
    for r, counted in (
        (d / w.d() + d / w.d(), "(d, d − 1)"),
        (d / (w * d) + d / (d * w), "(d, 2d)"),
        (d / w + d / Degree.named("d"), "(2d, 2d)"),
        ((d / w).d() + (w / w).d(), "(2d, 2d)"),
    ):
        assert repr((r.numerator, r.denominator)) == counted


def test_neither_order_nor_grouping_of_factors_matters():
    a, b, c, p = materials()
    for r in (
        p / (a * b) + p / (b * a),
        p / (a * b * c) + p / (a * (c * b)),
        p / a / b + p / b / a,
        p / a / (b * c) + (p / (c * a)) / b,
    ):
        assert r.denominator in (a * b, a * b * c)
        assert r.numerator == 2 * p


def test_all_other_denominators_are_multiplied():
    w, p, q, _ = materials()
    twin = BSpline(w.degree, w.knots, w.control_points)
    for r, denominator in (
        (p / w + q / w**2, w**3),
        (p / w + q / twin, w * w),
        (p / w + q / (w + 0), w * w),
        (p / w + q / (2 * w), 2 * w * w),
        (p / (w + p) + q / (p + w), (w + p) ** 2),
        (p / w.d() + q / w, w.d() * w),
        ((p / w).d() + q / w, w**3),
    ):
        assert r.denominator == denominator
        assert r.denominator.degree == (3 if denominator == w**3 else denominator.degree)


def test_nothing_is_cancelled():
    w, p, q, _ = materials()
    assert ((w / w).numerator, (w / w).denominator) == (w, w)
    assert ((p / w) * w).numerator == p * w
    assert ((p / w) * w).denominator == w
    assert ((p / w) / (q / w)).numerator == p * w
    assert ((p / w) / (q / w)).denominator == w * q
    assert (p / w - p / w).is_zero
    assert (p / w - p / w).denominator == w
    assert (1 / (p / w)).numerator == w
    assert (p * (w / q)).numerator == p * w
    assert (p / (w / q)).numerator == p * q
    assert (p / (w / q)).denominator == w


def test_quotients_and_constants_and_vectors():
    w, p, q, _ = materials()
    r, v = p / w, Vector(p, q)
    x = mpq(1, 3)
    here = p(x) / w(x)
    for found, expected in (
        (r + 1, here + 1),
        (1 - r, 1 - here),
        (2 * r, 2 * here),
        (r / 2, here / 2),
        (2 / r, 2 / here),
        (q - r, q(x) - here),
        (q + r, q(x) + here),
        (q * r, q(x) * here),
        (r**3, here**3),
        (-r, -here),
    ):
        assert found(x) == expected
    for found, factor in (
        (v * r, here),
        (r * v, here),
        (v / w, 1 / w(x)),
        (v / r, 1 / here),
        ((v / w) * q, q(x) / w(x)),
        (q * (v / w), q(x) / w(x)),
    ):
        assert found(x) == (p(x) * factor, q(x) * factor)
    assert (v + v / w)(x) == (p(x) * (1 + 1 / w(x)), q(x) * (1 + 1 / w(x)))
    assert (v - v / w)(x) == (p(x) * (1 - 1 / w(x)), q(x) * (1 - 1 / w(x)))
    assert (v / w)[1](x) == q(x) / w(x)
    assert len(v / w) == 2
    for wrong in (lambda: p / (v / w), lambda: r / (v / w)):
        with pytest.raises(FormulaError, match="vector"):
            wrong()
    with pytest.raises(TypeError):
        r + 0.5


@settings(max_examples=10)
@given(table_operands(), st.integers(1, 2))
def test_derivatives_of_quotients_by_differences_of_products(operands, order):
    """r w = p, differentiated: r′ w + r w′ = p′ and r″ w + 2 r′ w′ + r w″ = p″, as numbers."""
    t, _ = operands
    r = t.p1 / t.w1
    a, b = t.w1.domain
    for x in (a, a + (b - a) * mpq(3, 11), b):
        w, dw, ddw = (t.w1.d(k)(x) for k in range(3))
        left = r.d()(x) * w + r(x) * dw if order == 1 else r.d(2)(x) * w + 2 * r.d()(x) * dw + r(x) * ddw
        assert left == t.p1.d(order)(x)


def test_a_pole_is_a_division_by_zero():
    t = BSpline.identity(-1, 1)
    with pytest.raises(ZeroDivisionError):
        (1 / t)(0)
    assert (1 / t)("1/2") == 2
