"""Products of splines against two methods of others: collocation, and the blossom formula of Lee and Mørken."""

from itertools import product as pairs

import pytest
from gmpy2 import mpq
from hypothesis import given

from exactspline import BSpline
from tests.support import oracles
from tests.support.strategies import splines_on_one_domain


def assert_product(f, g):
    h = f * g
    knots, n = oracles.product_knots(f, g), f.degree + g.degree
    assert h.degree == n
    assert tuple(h.knots) == knots
    expected = oracles.collocated(
        knots, n, lambda t: oracles.value(*oracles.data(f), t) * oracles.value(*oracles.data(g), t)
    )
    assert h.control_points == expected
    assert oracles.blossomed(knots, f, g) == expected


@given(splines_on_one_domain(2, low=0, high=3))
def test_products_of_any_two_splines(fs):
    assert_product(*fs)


def with_multiplicity(n, inner, clamped):
    """A spline of degree n with the given interior multiplicities and control points that are all different."""
    outside = [0] * (n + 1) if clamped else [-k for k in range(n, -1, -1)]
    after = [3] * (n + 1) if clamped else [3 + mpq(k, 2) for k in range(n + 1)]
    knots = [*outside, *[t for t, m in inner for _ in range(m)], *after]
    return BSpline(n, knots, [mpq((7 * i * i + 3 * i + 1) % 11 - 5, 1 + i % 3) for i in range(len(knots) - n - 1)])


@pytest.mark.parametrize("clamped", [True, False], ids=["clamped", "unclamped"])
@pytest.mark.parametrize(("n", "m"), [(0, 0), (0, 2), (1, 1), (1, 2), (2, 2), (3, 1), (2, 3)])
def test_products_over_knots_of_every_multiplicity(n, m, clamped):
    for k, j in pairs(range(n + 2), range(m + 2)):
        f = with_multiplicity(n, [(1, k)], clamped)
        g = with_multiplicity(m, [(1, j), (2, 1)], not clamped)
        assert_product(f, g)
