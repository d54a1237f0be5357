"""What would take too long is refused beforehand, and named where an answer has a place for it."""

import pytest
from flint import fmpz_poly
from gmpy2 import mpq

from exactspline import analyse, example
from exactspline.errors import ReachError
from exactspline.extras.coq.formulas import constant_term, integer
from exactspline.geometry.analysis import surfaces as inspection
from exactspline.polynomials.factors import greatest_common_divisor


def test_a_common_divisor_of_long_integers_is_refused():
    """Before: 40 s inside one call (degree 32, a million bits) that could not be interrupted."""
    p, q = (fmpz_poly([1 << 1_300_000, *range(k, k + 32)]) for k in (1, 7))
    assert greatest_common_divisor([p, q]) == 1  # seen modulo a prime
    shared = fmpz_poly([3, 1])
    with pytest.raises(ReachError, match="the greatest common divisor of polynomials of degree 33"):
        greatest_common_divisor([p * shared, q * shared])


def test_a_patch_out_of_reach_is_open(monkeypatch):
    """Before: `ReachError` instead of the whole answer."""

    def refuse(forms, patch):
        raise ReachError("the factorization")

    monkeypatch.setattr(inspection, "inspect_patch", refuse)
    found = analyse(example("ellipsoid"))
    assert not found.complete
    assert {one.kind for one in found.patches} == {"undecided"}
    assert all(one.open_boxes == (one.sides,) for one in found.patches)


def test_constants_of_any_size_are_written_for_coq():
    """Before: `ValueError`, Python's limit of 4300 digits."""
    assert len(integer(-(10**5000))) == 5004
    assert len(constant_term(mpq(1, 10**5000))[0]) > 5000
