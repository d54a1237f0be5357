"""A polynomial in two parameters on a patch: a form in each direction, packed into a single ``fmpz_poly``.

``P = Σ c_ij u^(m−i) vⁱ ū^(n−j) v̄ʲ / denominator`` is stored as ``Σ c_ij x^(i + S j)`` (Kronecker substitution): the
power x^S represents the second variable. The stride S is a power of two above the degree m in the first parameter; if
it is larger than the degree of a product, the product of two patches is the product of two polynomials.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpz, fmpz_poly


def stride_for(degree: int) -> int:
    """The smallest stride for a degree in the first parameter.

    >>> [stride_for(m) for m in (0, 1, 3, 4)]
    [1, 2, 4, 8]
    """
    return 1 << max(degree, 0).bit_length()


def rows(c: fmpz_poly, stride: int, n: int) -> list[fmpz_poly]:
    """The forms in the first parameter, one per power of the second.

    >>> rows(fmpz_poly([1, 2, 3, 4]), 2, 1)
    [2*x + 1, 4*x + 3]
    """
    coefficients = c.coeffs()
    return [fmpz_poly(coefficients[j * stride : (j + 1) * stride]) for j in range(n + 1)]


def packed(parts: Sequence[fmpz_poly], stride: int) -> fmpz_poly:
    """The patch with these rows.

    >>> packed([fmpz_poly([1, 2]), fmpz_poly([3, 4])], 4)
    4*x^5 + 3*x^4 + 2*x + 1
    """
    coefficients: list[fmpz] = []
    for row in parts:
        row_coefficients = row.coeffs()
        coefficients += row_coefficients
        coefficients += [fmpz(0)] * (stride - len(row_coefficients))
    return fmpz_poly(coefficients)
