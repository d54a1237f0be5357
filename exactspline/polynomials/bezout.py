"""Bézout's matrix of a plane curve and a moving point, from the lines through the point that meet the curve.

A plane curve is three forms ``P = (x, y, w)`` of degree m in the parameter s. For a point Q the form
``det(Q, P(σ), P(s))`` is divisible by ``s − σ``; the coefficients of the quotient are a symmetric m × m matrix B, the
Bézoutian of two lines through Q as polynomials in s. The kernel of B is spanned by the vectors ``(u^(m−1), u^(m−2) s,
…)`` of the parameters at which P passes through Q. Hence ``F = det B`` vanishes exactly where Q lies on the curve, and
where the adjugate does not vanish there is exactly one such parameter, with ``s/u = A₀₁/A₀₀``. If Q moves along a curve
of degree n, the entries are forms of degree n in its parameter t.

If Q runs along P itself, ``s − t`` and ``σ − t`` can be divided out, too. This gives a matrix of size m − 1 that is
singular at the pairs of parameters with the same point.

Source: Sederberg, Anderson and Goldman, Implicit representation of parametric curves and surfaces, 1984; Manocha and
Demmel, Algorithms for intersecting parametric and algebraic curves I, 1994; Helmke and Fuhrmann, Bezoutians, 1989.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import prod
from typing import NamedTuple

from flint import fmpz, fmpz_mat, fmpz_poly

from exactspline.numbers.exact import mpz
from exactspline.polynomials.cost import LONGEST_LOOP, check_reach
from exactspline.polynomials.elimination import through

Matrix = list[list[fmpz_poly]]
Point3 = tuple[fmpz, fmpz, fmpz]

#: Up to this size a determinant is expanded; above this size the entries are packed into integers.
WRITTEN_OUT = 3
#: From this size on a determinant is interpolated between values.
INTERPOLATED = 6
#: The costs in hundredths of a nanosecond: of a determinant of packed entries, per bit of the result and cube of the
#: size; of one value, per bit and cube of the size; of the interpolation, per bit and value (measured: 30 to 50; 15 to
#: 25; 11 to 15).
PACKED, VALUE, INTERPOLATION = 60, 30, 15
ZERO = fmpz_poly([])


class PlaneForms(NamedTuple):
    """A plane curve on one segment: the integers of the three forms ``x, y, w`` of the same degree, over a common
    denominator.
    """

    degree: int
    x: fmpz_poly
    y: fmpz_poly
    w: fmpz_poly

    @property
    def forms(self) -> tuple[fmpz_poly, fmpz_poly, fmpz_poly]:
        """The three forms."""
        return self.x, self.y, self.w

    def coefficient(self, i: int) -> Point3:
        """The point of the coefficients of ``u^(m−i) sⁱ``."""
        return self.x[i], self.y[i], self.w[i]

    @property
    def is_straight(self) -> bool:
        """Whether all points are on one line, or the curve is a single point."""
        return straight_line(self) is not None


def across(a: Point3, b: Point3) -> Point3:
    """The line through two points, or the point on two lines; zero if they are the same."""
    (a0, a1, a2), (b0, b1, b2) = a, b
    return a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0


def along(line: Point3, curve: PlaneForms) -> fmpz_poly:
    """The form of a line at the points of a curve.

    >>> parabola = PlaneForms(2, fmpz_poly([0, 1, 1]), fmpz_poly([0, 0, 1]), fmpz_poly([1, 2, 1]))
    >>> along((fmpz(1), fmpz(-1), fmpz(0)), parabola)
    x
    """
    a, b, c = line
    return curve.x * a + curve.y * b + curve.w * c


def straight_line(curve: PlaneForms) -> Point3 | None:
    """The line that contains a curve; None if the curve is not straight, zero if it is a single point.

    >>> straight_line(PlaneForms(1, fmpz_poly([0, 1]), fmpz_poly([0, 2]), fmpz_poly([1, 1])))
    (-2, 1, 0)
    """
    points = [curve.coefficient(i) for i in range(curve.degree + 1)]
    start = next((p for p in points if any(p)), points[0])
    line = next((x for p in points if any(x := across(start, p))), across(start, start))
    return None if along(line, curve) else line


def _moving_lines(curve: PlaneForms, point: PlaneForms) -> list[list[fmpz_poly]]:
    """``D_ij = det(Q, p_i, p_j)`` for i < j, in row i: forms in the parameter of the moving point Q."""
    _, x, y, w = point
    points = [curve.coefficient(i) for i in range(curve.degree + 1)]
    rows = []
    for i, (a, b, c) in enumerate(points):
        rows.append([x * (b * f - c * e) + y * (c * d - a * f) + w * (a * e - b * d) for d, e, f in points[i + 1 :]])
    return rows


def minors(point: PlaneForms, curve: PlaneForms) -> tuple[fmpz_poly, fmpz_poly, fmpz_poly]:
    """The three minors of a point, given as a curve of degree 0, and a curve. All are zero where the curve passes
    through the point.
    """
    (a, b, c), (x, y, w) = point.coefficient(0), curve.forms
    return x * c - w * a, y * c - w * b, x * b - y * a


def bezout_matrix(curve: PlaneForms, point: PlaneForms) -> Matrix:
    """Bézout's matrix of a curve of degree m > 0 and a moving point.

    >>> parabola = PlaneForms(2, fmpz_poly([0, 1, 1]), fmpz_poly([0, 0, 1]), fmpz_poly([1, 2, 1]))
    >>> origin = PlaneForms(0, fmpz_poly([0]), fmpz_poly([0]), fmpz_poly([1]))
    >>> bezout_matrix(parabola, origin)
    [[0, 0], [0, 1]]
    """
    m, lines = curve.degree, _moving_lines(curve, point)
    matrix = [[ZERO] * m for _ in range(m)]
    for k in range(m):
        for j in range(k, m):
            # (σⁱ sʲ − σʲ sⁱ)/(s − σ) has the terms σᵏ sˡ with k + l = i + j − 1 and i ≤ k, l
            least = max(0, k + j + 1 - m)
            total = lines[least][k + j - 2 * least]
            for i in range(least + 1, k + 1):
                total = total + lines[i][k + j - 2 * i]
            matrix[k][j] = matrix[j][k] = total
    return matrix


def self_matrix(curve: PlaneForms) -> Matrix:
    """The matrix of size m − 1, with forms of degree m − 2 in t, whose kernel is spanned by the parameters s ≠ t with
    the same point as t (s = t at a cusp).

    A loop whose node has the parameters ``z`` and ``1/z`` with ``z + 1/z = 14``:

    >>> loop = PlaneForms(3, fmpz_poly([0, 9, -6, 1]), fmpz_poly([0, 9, 9]), fmpz_poly([1, 3, 3, 1]))
    >>> determinant(self_matrix(loop), 1)
    (-1296)*x^2 + 18144*x + (-1296)
    """
    rows = [_divided(row) for row in bezout_matrix(curve, curve)]
    return [_divided(column) for column in zip(*rows, strict=True)]


def _divided(row: Sequence[fmpz_poly]) -> list[fmpz_poly]:
    """The coefficients, by powers of s, of the quotient by ``s − t`` of a multiple of ``s − t``."""
    quotient, carry = [], ZERO
    for entry in reversed(row[1:]):
        carry = entry + carry.left_shift(1)
        quotient.append(carry)
    return quotient[::-1]


def determinant(matrix: Matrix, degree: int) -> fmpz_poly:
    """The determinant of a square matrix of forms of the same degree.

    Raises `ReachError` if it would take too long.

    >>> x = fmpz_poly([0, 1])
    >>> determinant([[x, fmpz_poly([1])], [fmpz_poly([1]), x]], 1)
    x^2 + (-1)
    >>> determinant([[x if i == j else fmpz_poly([i + j]) for i in range(4)] for j in range(4)], 1)
    x^4 + (-64)*x^2 + 216*x + (-144)
    """
    size = len(matrix)
    if size > WRITTEN_OUT:
        return (_interpolated if size >= INTERPOLATED else _packed)(matrix, degree)
    if size == 0:
        return fmpz_poly([1])
    if size == 1:
        ((a,),) = matrix
        return a
    if size == 2:
        (a, b), (c, d) = matrix
        return a * d - b * c
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)


def _packed(matrix: Matrix, degree: int) -> fmpz_poly:
    """The determinant by Kronecker substitution: the entries are evaluated at a power of two larger than all
    coefficients of the determinant.
    """
    size, height, bits = len(matrix), _height(matrix), _bits_of_determinant(matrix)
    width, length = (bits + 8) // 8, size * degree + 1
    _check(size**3 * length * bits * PACKED // 100, size, degree, height)
    base = fmpz(1) << (8 * width)
    return _unpacked(int(fmpz_mat([[x(base) for x in row] for row in matrix]).det()), width, length)


def _interpolated(matrix: Matrix, degree: int) -> fmpz_poly:
    """The determinant from its values at consecutive integers, in an interruptible loop."""
    size, height = len(matrix), _height(matrix)
    count = size * degree + 1
    bits = _bits_of_determinant(matrix) + size * degree * count.bit_length()
    _check(count * bits * (size**3 * VALUE + count * INTERPOLATION) // 100, size, degree, height)
    start = -(count // 2)
    values = [fmpz_mat([[x(k) for x in row] for row in matrix]).det() for k in range(start, start + count)]
    return through([mpz(int(value)) for value in values])(fmpz_poly([-start, 1]))


def _height(matrix: Matrix) -> int:
    return max(int(x.height_bits()) for row in matrix for x in row)


def _bits_of_determinant(matrix: Matrix) -> int:
    """The bits of a bound of the coefficients of the determinant: the product over all rows of the sums of their
    absolute coefficients.
    """
    return int(prod(sum(abs(int(c)) for x in row for c in x.coeffs()) for row in matrix)).bit_length()


def _check(cost: int, size: int, degree: int, bits: int) -> None:
    what = f"a determinant of {size} × {size} forms of degree {degree} with numbers of {bits} bits"
    check_reach(cost, lambda: what, LONGEST_LOOP)


def _unpacked(value: int, width: int, length: int) -> fmpz_poly:
    """The polynomial with this value at ``2^(8 width)``, whose coefficients are smaller than half of ``2^(8 width)`` in
    absolute value.
    """
    sign, rest = (-1, -value) if value < 0 else (1, value)
    data = rest.to_bytes(width * length, "little")
    half, base = 1 << (8 * width - 1), 1 << (8 * width)
    coefficients, carry = [], 0
    for k in range(length):
        digit = int.from_bytes(data[k * width : (k + 1) * width], "little") + carry
        carry = int(digit >= half)
        coefficients.append(sign * (digit - base if carry else digit))
    return fmpz_poly(coefficients)


def without(matrix: Matrix, row: int, column: int) -> Matrix:
    """The matrix without a row and a column."""
    return [[x for j, x in enumerate(r) if j != column] for i, r in enumerate(matrix) if i != row]
