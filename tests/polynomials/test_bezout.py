"""Bézout's matrices, held against the forms that define them, expanded by FLINT in all parameters at once."""

from random import Random

import pytest
from flint import Ordering, fmpz, fmpz_mpoly_ctx, fmpz_poly

from exactspline.errors import ReachError
from exactspline.polynomials import bezout
from exactspline.polynomials.bezout import (
    PlaneForms,
    along,
    bezout_matrix,
    determinant,
    minors,
    self_matrix,
    straight_line,
)

#: The parameter of the moving point, and two of the curve.
CONTEXT = fmpz_mpoly_ctx.get(["t", "a", "b"], Ordering.lex)
T, A, B = CONTEXT.gens()


def drawn(random, degree, size=9):
    return PlaneForms(degree, *(fmpz_poly([random.randint(-size, size) for _ in range(degree + 1)]) for _ in range(3)))


def points(curve, variable):
    return [sum((variable**k * c for k, c in enumerate(f.coeffs())), T * 0) for f in curve.forms]


def triple(p, q, r):
    """The determinant of three points."""
    return sum((p[i] * (q[(i + 1) % 3] * r[(i + 2) % 3] - q[(i + 2) % 3] * r[(i + 1) % 3]) for i in range(3)), T * 0)


def as_function(matrix):
    """``Σ m_ij aⁱ bʲ``."""
    entries = ((x, i, j) for i, row in enumerate(matrix) for j, x in enumerate(row))
    return sum((A**i * B**j * T**k * c for x, i, j in entries for k, c in enumerate(x.coeffs())), T * 0)


@pytest.mark.parametrize("degree", range(1, 7))
def test_a_matrix_is_the_quotient_by_the_difference_of_the_parameters(degree):
    random = Random(degree)
    for size in range(4):
        curve, point = drawn(random, degree), drawn(random, size)
        matrix = bezout_matrix(curve, point)
        assert as_function(matrix) * (B - A) == triple(points(point, T), points(curve, A), points(curve, B))
        assert matrix == [list(column) for column in zip(*matrix, strict=True)]
    matrix = self_matrix(curve)
    own = points(curve, T), points(curve, A), points(curve, B)
    assert as_function(matrix) * (B - A) * (A - T) * (B - T) == triple(*own)
    assert len(matrix) == degree - 1


def test_a_determinant_fits_where_it_is_packed():
    """Entries of one sign with many terms: the largest coefficients that there are for their height."""
    assert determinant([], 3) == 1
    for size in (4, 5):
        for degree in (0, 1, 60):
            for bits in range(1, 12):
                x = fmpz_poly([(1 << bits) - 1] * (degree + 1))
                zero = fmpz_poly([])
                matrix = [[x if i == j else zero for i in range(size)] for j in range(size)]
                assert determinant(matrix, degree) == x**size
                # Hadamard's matrix, and that with a border of which the rest has its determinant
                signs = [
                    [(-1) ** (i & j).bit_count() if max(i, j) < 4 else int(i == j) for i in range(size)]
                    for j in range(size)
                ]
                assert determinant([[x * s for s in row] for row in signs], degree) == x**size * 16
                assert determinant([[-x * s for s in row] for row in signs], degree) == (-x) ** size * 16


def test_a_determinant_that_would_take_too_long_is_refused(monkeypatch):
    monkeypatch.setattr(bezout, "LONGEST_LOOP", 10**6)
    for size in (4, 7):
        row = [fmpz_poly([1 << 500] * 30)] * size
        with pytest.raises(ReachError, match=rf"{size} × {size} forms of degree 29 with numbers of 501 bits"):
            determinant([row] * size, 29)
        assert determinant([[fmpz_poly([int(i == j)]) for i in range(size)] for j in range(size)], 0) == 1


def test_a_point_on_a_curve_has_no_minors():
    random = Random(1)
    for _ in range(20):
        curve, z = drawn(random, 3), random.randint(-3, 3)
        at = [f(fmpz(z)) for f in curve.forms]
        on = minors(PlaneForms(0, *(fmpz_poly([x * 2]) for x in at)), curve)
        assert all(f(fmpz(z)) == 0 for f in on)
        other = PlaneForms(0, *(fmpz_poly([x + k]) for k, x in enumerate(at)))
        there = [f(fmpz(z)) for f in minors(other, curve)]
        x, y, w = at
        assert there == [x * (w + 2) - w * x, y * (w + 2) - w * (y + 1), x * (y + 1) - y * x]


@pytest.mark.parametrize("shift", range(4))
def test_a_straight_line_is_found_wherever_the_coefficients_vanish(shift):
    """Points ``f a + g b`` on the line through a and b, of which the first coefficients may be zero or alike."""
    random, a, b = Random(shift), (3, -1, 2), (1, 4, 1)
    for factors in ([1, 2, 5], [0, 2, 3], [0, 0, 7], [4, 4, 5]):
        f = fmpz_poly(factors).left_shift(shift)
        g = fmpz_poly([random.randint(1, 5)] * 2).left_shift(shift)
        curve = PlaneForms(2 + shift, *(f * x + g * y for x, y in zip(a, b, strict=True)))
        line = straight_line(curve)
        assert line is not None
        assert any(line)
        assert not along(line, curve)
        bent = PlaneForms(2 + shift, curve.x, curve.y, curve.w + fmpz_poly([0] * (shift + 1) + [100]))
        assert straight_line(bent) is None
        assert not bent.is_straight
        fixed = PlaneForms(2 + shift, *(f * x for x in a))
        assert straight_line(fixed) == (0, 0, 0)
        assert fixed.is_straight
