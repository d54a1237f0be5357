"""A polynomial in two parameters on a patch: a form in each direction, packed into a single ``fmpz_poly``.

``P = Σ c_ij u^(m−i) vⁱ ū^(n−j) v̄ʲ / denominator`` is stored as ``Σ c_ij x^(i + S j)`` (Kronecker substitution): the
power x^S represents the second variable. The stride S is a power of two above the degree m in the first parameter; if
it is larger than the degree of a product, the product of two patches is the product of two polynomials.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

from flint import fmpz, fmpz_poly

from exactspline.numbers.exact import mpq, over_one_denominator, ratio
from exactspline.polynomials.bernstein import Form, raiser, value, without_content


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


def columns(c: fmpz_poly, stride: int, m: int) -> list[fmpz_poly]:
    """The forms in the second parameter, one per power of the first.

    >>> columns(fmpz_poly([1, 2, 3, 4]), 2, 1)
    [3*x + 1, 4*x + 2]
    """
    coefficients = c.coeffs()
    return [fmpz_poly(coefficients[i::stride]) for i in range(m + 1)]


def derivative(c: fmpz_poly, stride: int, degrees: tuple[int, int], direction: int) -> fmpz_poly:
    """``∂v − ∂u`` in one direction (0: the first parameter) of a patch of positive degree there.

    >>> derivative(fmpz_poly([1, 2, 3, 4]), 2, (1, 1), 1)  # 1 + 2x + (3 + 4x) y: the difference of two rows
    2*x + 2
    """
    (m, n), a = degrees, c.coeffs()
    a += [fmpz(0)] * (stride * (n + 1) - len(a))
    if direction:
        return fmpz_poly([(k // stride + 1) * a[k + stride] + (k // stride - n) * a[k] for k in range(stride * n)])
    places = [(k, k % stride) for k in range(stride * (n + 1))]
    return fmpz_poly([(i + 1) * a[k + 1] + (i - m) * a[k] if i < m else 0 for k, i in places])


def without_powers(c: fmpz_poly, stride: int, by: tuple[int, int]) -> fmpz_poly:
    """A patch divided by powers of ``u + v`` and ``ū + v̄``, which must divide it.

    >>> without_powers(fmpz_poly([1, 1, 1, 1]), 2, (0, 1))  # (1 + x)(1 + y)
    x + 1
    """
    for times, gap in zip(by, (1, stride), strict=True):
        if times:
            c = c // raiser(times).inflate(gap)
    return c


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


def repacked(c: fmpz_poly, old: int, new: int) -> fmpz_poly:
    """The same patch with another stride."""
    if old == new or c.degree() < old:
        return c
    return c.inflate(new) if old == 1 else packed(rows(c, old, c.degree() // old), new)


def transposed(c: fmpz_poly, stride: int, n: int, new: int) -> fmpz_poly:
    """The patch with its parameters exchanged: n is the degree in the original second parameter, `new` the stride of
    the result.
    """
    parts = [row.coeffs() for row in rows(c, stride, n)]
    height = max((len(row) for row in parts), default=0)
    return packed([fmpz_poly([row[i] if i < len(row) else 0 for row in parts]) for i in range(height)], new)


def _at_first(c: fmpz_poly, m: fmpz, degrees: tuple[int, int], stride: int, a: mpq) -> Form:
    """The form in the second parameter at the local value a of the first parameter."""
    values = [value((row, m), degrees[0], a) for row in rows(c, stride, degrees[1])]
    integers, common = over_one_denominator(values)
    return without_content((fmpz_poly(integers), fmpz(common)))


def evaluated(c: fmpz_poly, m: fmpz, degrees: tuple[int, int], stride: int, a: mpq, b: mpq) -> mpq:
    """The value at the local parameters a and b."""
    return value(_at_first(c, m, degrees, stride, a), degrees[1], b) if min(degrees) >= 0 else mpq(0)


def from_net(net: Sequence[Sequence[mpq]], stride: int) -> Form:
    """The patch with the Bézier points ``net[i][j]``."""
    m, n = len(net) - 1, len(net[0]) - 1
    scaled = [comb(m, i) * comb(n, j) * net[i][j] for j in range(n + 1) for i in range(m + 1)]
    integers, common = over_one_denominator(scaled)
    rows = [fmpz_poly(integers[k : k + m + 1]) for k in range(0, len(integers), m + 1)]
    return packed(rows, stride), fmpz(common)


def bezier_net(form: Form, degrees: tuple[int, int], stride: int) -> list[list[mpq]]:
    """The Bézier points of a patch.

    >>> bezier_net(from_net([[mpq(1), mpq(2)], [mpq(3), mpq(4)]], 2), (1, 1), 2)
    [[mpq(1,1), mpq(2,1)], [mpq(3,1), mpq(4,1)]]
    """
    (c, common), (m, n) = form, degrees
    return [[ratio(c[i + stride * j], common * comb(m, i) * comb(n, j)) for j in range(n + 1)] for i in range(m + 1)]
