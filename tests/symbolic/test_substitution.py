"""Jets on curves: what a polynomial in symbols is where splines stand for them."""

import pytest
from gmpy2 import mpq

from exactspline import example, formula_of
from exactspline.language.kinds import CURVE
from exactspline.readings import JetReading
from exactspline.readings.differential_order import order_of
from exactspline.symbolic.substitution import substitute


@pytest.mark.parametrize("name", ["f2", "vertices_lifted", "D1_squared", "g2"])
def test_a_jet_on_a_curve_is_the_formula_there(name):
    curve = example("rational_cubic")
    f = formula_of(name)
    jet = f(JetReading(order_of(f, 2)).argument(CURVE, 2))
    assert substitute(jet, curve) == f(curve)


def test_a_jet_with_constants_on_a_curve():
    curve, c = example("rational_cubic"), JetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    p, q, v = *curve.p, curve.w
    for jet, expected in (
        (x * x * x + 2 * x + 1, p * p * p + 2 * p + 1),
        (x * x + y * w - 3, p * p + q * v - 3),
        (5 - x * x * w + x * y, 5 - p * p * v + p * q),
        (x * y * y + x * x * y + y, p * q * q + p * p * q + q),
        (w.constant(4), v.constant(4)),
        (x - x, v.constant(0)),
        (x.d(1) * y + 2, p.d(1) * q + 2),
    ):
        assert substitute(jet, curve) == expected


def test_a_jet_with_fractions_for_coefficients_on_a_curve():
    curve, c = example("rational_cubic"), JetReading(1).argument(CURVE, 2)
    x, y, w = *c.p, c.w
    p, q, v = *curve.p, curve.w
    for jet, expected in (
        (x * y * mpq(2, 3) - w * w * mpq(5, 4), p * q * mpq(2, 3) - v * v * mpq(5, 4)),
        (x * mpq(1, 7), p * mpq(1, 7)),
        (w.constant(mpq(3, 5)), v.constant(mpq(3, 5))),
        (x.d(1) * mpq(1, 6) + mpq(1, 4), p.d(1) * mpq(1, 6) + mpq(1, 4)),
        (x * 6 + y * 4, p * 6 + q * 4),
    ):
        assert substitute(jet, curve) == expected
