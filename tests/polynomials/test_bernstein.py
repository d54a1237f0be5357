"""Forms in the scaled Bernstein basis, in one parameter and in two: their values and their edges."""

import pytest
from flint import fmpz, fmpz_poly
from gmpy2 import mpq

from exactspline.polynomials.bernstein import LONG, value
from exactspline.polynomials.patch_forms import PatchForm


def test_edges_of_a_patch_are_those_of_its_net():
    form = PatchForm.of_net([[1, 2, 3], [4, 5, 7]])
    assert form.edge(0, 0) == [1, 2, 3]
    assert form.edge(0, 1) == [4, 5, 7]
    assert form.edge(1, 0) == [1, 4]
    assert form.edge(1, 1) == [3, 7]


@pytest.mark.parametrize("n", [LONG - 1, LONG, LONG + 1, 3 * LONG])
@pytest.mark.parametrize("t", [mpq(0), mpq(1), mpq(1, 3), mpq(5, 2**40), mpq(-2, 7), mpq(9, 4)])
def test_values_of_long_forms_are_those_of_the_powers(n, t):
    c = fmpz_poly([(-1) ** i * (i * i % 11) for i in range(n - 1)])  # the last two coefficients vanish
    powers = [int(c[i]) * t**i * (1 - t) ** (n - i) for i in range(n + 1)]
    assert value((c, fmpz(6)), n, t) == sum(powers) / 6
    assert value((fmpz_poly([]), fmpz(6)), n, t) == 0
