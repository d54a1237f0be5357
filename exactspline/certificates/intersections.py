"""Checks a certificate of the common points of two plane curves, with only the standard library.

For every pair of segments the certificate either names a coordinate in which their control points are apart, or the
zeros of the determinant F of Bézout's matrix, which is computed here from the control points, and whether the parameter
of the first curve is on its segment. Where an entry of the adjugate is not zero, the matrix has corank one, and there
is exactly one such parameter; its place follows from the signs of two entries.

A segment consists of the integers of three forms ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ``: the coordinates times the weight, and the
weight.
"""

from collections.abc import Mapping
from fractions import Fraction
from math import gcd
from typing import Any

from exactspline.certificates.elimination import determinant, through, value_of
from exactspline.certificates.numbers import (
    count,
    each,
    fraction,
    integer,
    read,
    require,
    require_each_once,
    text,
    truth,
)
from exactspline.certificates.zeros import ISOLATION, Zero, isolated_zeros, restricted

Polynomial = list[int]
SEGMENT = {"x": [integer], "y": [integer], "w": [integer]}
APART = {"apart": {"axis": count, "at": fraction}}
ELIMINATED = {"exchanged": truth, "elimination": ISOLATION, "zeros": [{"low": fraction, "high": fraction, "s": text}]}
INSIDE, OUTSIDE, START, END = "inside", "outside", "start", "end"


def check_intersections(certificate: Mapping[str, object]) -> dict[str, int]:
    """The number of common points that a certificate proves, one for each pair of segments that has it."""
    data = read(certificate, {"first": [SEGMENT], "second": [SEGMENT], "pairs": [_pair]})
    curves = [each(name, _segment, data[name]) for name in ("first", "second")]
    require(all(curves), "a curve without segments")
    require_each_once([pair["segments"] for pair in data["pairs"]], curves, "not every pair of segments once")
    return {"points": sum(each("pairs", lambda pair: _checked(curves, pair), data["pairs"]))}


def _pair(given: Any) -> dict[str, Any]:
    """Two segments, and what proves their common points."""
    return {**read(given, {"segments": (count, count)}), **read(given, APART if "apart" in given else ELIMINATED)}


def _segment(given: Mapping[str, Any]) -> list[Polynomial]:
    forms = [given[name] for name in ("x", "y", "w")]
    require(len({len(form) for form in forms}) == 1 and len(forms[0]) > 1, "forms of different degrees, or of degree 0")
    require(all(x > 0 for x in forms[2]), "a weight that is not positive")
    return forms


def _checked(curves: list[list[list[Polynomial]]], pair: Mapping[str, Any]) -> int:
    """The number of common points of two segments."""
    first, second = (curve[i] for curve, i in zip(curves, pair["segments"], strict=True))
    if "apart" in pair:
        axis, at = pair["apart"]["axis"], pair["apart"]["at"]
        require(axis in (0, 1), "an axis that is not one of the plane")
        sides = [{_side(x, w, at) for x, w in zip(curve[axis], curve[2], strict=True)} for curve in (first, second)]
        require(sides in ([{-1}, {1}], [{1}, {-1}]), "control points that are not apart")
        return 0
    one, other = (second, first) if pair["exchanged"] else (first, second)
    matrix = _bezout(one, other)
    size, degree = len(matrix), len(other[0]) - 1
    form = polynomial_determinant(matrix)
    require(any(form), "the determinant vanishes: arcs in common are not proved")
    entries = _line_entries(one, other) if size == 1 else _entries(matrix)
    zeros = isolated_zeros(_padded(form, size * degree), pair["elimination"])
    claims = pair["zeros"]
    require(len(claims) == len(zeros), f"{len(zeros)} zeros of the determinant, another number claimed")
    return sum(_on_segment(claim, zero, entries) for claim, zero in zip(claims, zeros, strict=True))


def _side(x: int, w: int, at: Fraction) -> int:
    value = x * at.denominator - at.numerator * w
    return (value > 0) - (value < 0)


# ---- Bézout's matrix


def _bezout(curve: list[Polynomial], point: list[Polynomial]) -> list[list[Polynomial]]:
    """The coefficients of ``det(Q, P(σ), P(s))/(s − σ)``, polynomials in the parameter of Q."""
    m = len(curve[0]) - 1
    points = list(zip(*curve, strict=True))
    matrix = [[[0] * len(point[0]) for _ in range(m)] for _ in range(m)]
    for i in range(m + 1):
        for j in range(i + 1, m + 1):
            line = _along(_across(points[i], points[j]), point)
            # (σⁱ sʲ − σʲ sⁱ)/(s − σ) = Σ σ^(i + r) s^(j − 1 − r)
            for r in range(j - i):
                matrix[i + r][j - 1 - r] = [a + b for a, b in zip(matrix[i + r][j - 1 - r], line, strict=True)]
    return matrix


def _across(a: tuple[int, ...], b: tuple[int, ...]) -> tuple[int, int, int]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _along(line: tuple[int, ...], curve: list[Polynomial]) -> Polynomial:
    return [sum(a * x for a, x in zip(line, row, strict=True)) for row in zip(*curve, strict=True)]


def polynomial_determinant(matrix: list[list[Polynomial]]) -> Polynomial:
    """From its values at as many integers as it has coefficients.

    >>> polynomial_determinant([[[1, 1], [1, 0]], [[1, 0], [1, -1]]])
    [0, 0, -1]
    """
    degree = len(matrix) * (len(matrix[0][0]) - 1)
    values = [determinant([[value_of(p, x) for p in row] for row in matrix]) for x in range(degree + 1)]
    return _padded(through(values), degree)


def _padded(p: Polynomial, degree: int) -> Polynomial:
    return p + [0] * (degree + 1 - len(p))


def _entries(matrix: list[list[Polynomial]]) -> tuple[Polynomial, Polynomial, Polynomial]:
    """The entries A₀₀, A₀₁ and the last one of the adjugate."""

    def without(row: int, column: int) -> list[list[Polynomial]]:
        return [[x for j, x in enumerate(r) if j != column] for i, r in enumerate(matrix) if i != row]

    last = len(matrix) - 1
    return (
        polynomial_determinant(without(0, 0)),
        [-x for x in polynomial_determinant(without(0, 1))],
        polynomial_determinant(without(last, last)),
    )


def _line_entries(line: list[Polynomial], other: list[Polynomial]) -> tuple[Polynomial, Polynomial, Polynomial]:
    """For a segment of degree 1: u, s, and s again, as forms along the other curve."""
    start, end = zip(*line, strict=True)
    normal = _across(start, end)
    require(any(normal), "a segment that is a single point")
    top, bottom = _along(_across(start, normal), other), _along(_across(normal, end), other)
    return bottom, top, top


# ---- places


def _on_segment(claim: Mapping[str, Any], zero: Zero, entries: tuple[Polynomial, ...]) -> int:
    """Whether the parameter at a zero is on the segment: 1 or 0."""
    factor, a, b = zero[2], claim["low"], claim["high"]
    require_place(zero, a, b)
    first, second, last = entries
    where = claim["s"]
    if where == START:
        require(sign_throughout(first, a, b) != 0 and zero_at(second, factor, a, b), "the parameter is not the start")
        return 1
    if where == END:
        require(sign_throughout(last, a, b) != 0 and zero_at(first, factor, a, b), "the parameter is not the end")
        return 1
    require(where in (INSIDE, OUTSIDE), "an unknown place")
    product = sign_throughout(first, a, b) * sign_throughout(second, a, b)
    require(product == (1 if where == INSIDE else -1), "the signs do not prove where the parameter is")
    return int(where == INSIDE)


def sign_throughout(form: Polynomial, a: Fraction, b: Fraction) -> int:
    """The sign of a form on [a, b] if all its Bernstein coefficients there have one, else 0.

    >>> sign_throughout([1, 1], Fraction(0), Fraction(1, 2))
    1
    """
    values = restricted(form, a, b)[:1] if a == b else restricted(form, a, b)
    return 1 if all(x > 0 for x in values) else -1 if all(x < 0 for x in values) else 0


def require_place(zero: Zero, a: Fraction, b: Fraction) -> None:
    """Raise `ValueError` unless [a, b] has an isolated zero of a form, and no other one of its leaf."""
    low, high, factor, *_ = zero
    if low == high:
        require(a == b == low, "another place than that of the zero")
    elif a == b:
        require(low < a < high and restricted(factor, a, a)[0] == 0, "a place that is not the zero")
    else:
        require(low <= a < b <= high, "a place outside the leaf of the zero")
        require(changes_sign(factor, a, b), "a place without the zero")


def changes_sign(form: Polynomial, a: Fraction, b: Fraction) -> bool:
    """Whether a form has opposite signs at two parameters.

    >>> changes_sign([-1, 1], Fraction(0), Fraction(1))
    True
    """
    values = restricted(form, a, b)
    return values[0] * values[-1] < 0


def zero_at(form: Polynomial, factor: Polynomial, a: Fraction, b: Fraction) -> bool:
    """Whether a form is zero at the only zero of the factor in [a, b].

    >>> zero_at([-2, 1], [4, 0, -1], Fraction(1, 2), Fraction(1))  # at t/(1 − t) = 2
    True
    """
    if a == b:
        return restricted(form, a, b)[0] == 0
    common = common_divisor(form, factor)
    return len(common) > 1 and changes_sign(common, a, b)


def _trimmed(p: Polynomial) -> Polynomial:
    while p and not p[-1]:
        p = p[:-1]
    return p


def common_divisor(p: Polynomial, q: Polynomial) -> Polynomial:
    """A greatest common divisor of two polynomials; empty if both are zero.

    >>> common_divisor([-1, 0, 1], [1, 2, 1])
    [-1, -1]
    """
    p, q = _trimmed(p), _trimmed(q)
    while q:
        rest = list(p)
        while len(rest) >= len(q):
            top, shift = rest[-1], len(rest) - len(q)
            rest = [x * q[-1] for x in rest]
            for i, x in enumerate(q):
                rest[shift + i] -= top * x
            rest = _trimmed(rest[:-1])
        size = gcd(*rest) or 1
        p, q = q, [x // size for x in rest]
    return p
