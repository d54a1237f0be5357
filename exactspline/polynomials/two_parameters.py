"""Polynomials in two parameters s and t: coefficients, values in balls, forms on patches."""

from __future__ import annotations

from collections.abc import Sequence

from flint import Ordering, arb, arb_poly, fmpz, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from exactspline.numbers.exact import common_divisor, from_flint, mpq, to_fmpq
from exactspline.numbers.intervals import Box
from exactspline.polynomials.bernstein import substituted
from exactspline.polynomials.patch_forms import PatchForm, of_powers, powers_of

CONTEXT = fmpz_mpoly_ctx.get(["s", "t"], Ordering.lex)
S, T = CONTEXT.gens()


def lifted(p: fmpz_poly, variable: int) -> fmpz_mpoly:
    """A polynomial in one parameter as a polynomial in both: variable 0 is s, 1 is t."""
    return CONTEXT.from_dict({(k, 0) if variable == 0 else (0, k): x for k, x in enumerate(p.coeffs()) if x})


def in_one(p: fmpz_mpoly, variable: int) -> fmpz_poly:
    """A polynomial in both parameters that contains only one of them, as a polynomial in this parameter."""
    coefficients = {int(powers[variable]): x for powers, x in p.terms()}
    return fmpz_poly([coefficients.get(k, 0) for k in range(max(coefficients, default=-1) + 1)])


def rows_of(p: fmpz_mpoly) -> list[fmpz_poly]:
    """The coefficients, polynomials in s, of the powers of t.

    >>> rows_of(S * T + 2)
    [2, x]
    """
    rows: list[dict[int, int]] = [{} for _ in range(int(p.degrees()[1]) + 1)] if p else []
    for (i, j), x in p.terms():
        rows[int(j)][int(i)] = int(x)
    return [fmpz_poly([row.get(k, 0) for k in range(max(row, default=-1) + 1)]) for row in rows]


def at(p: fmpz_mpoly, variable: int, value: mpq) -> fmpz_poly:
    """The polynomial in the other parameter for a rational value of one parameter, up to a positive constant.

    >>> at(S * T + 2, 0, mpq(1, 2))
    x + 4
    """
    rows = rows_of(p if variable == 0 else p.compose(T, S))
    n = max((row.degree() for row in rows), default=0)
    bottom = int(value.denominator)
    numerator = fmpz_poly([int(value.numerator)])
    return fmpz_poly([substituted(row, max(n, 0), fmpz_poly([bottom]), numerator)[0] for row in rows])


def value_at(p: fmpz_mpoly, s: mpq, t: mpq) -> mpq:
    """The exact value at rational parameters, up to a positive constant that depends only on s and the degree."""
    return from_flint(at(p, 0, s)(to_fmpq(t)))


def enclosed(p: fmpz_mpoly, s: arb, t: arb) -> arb:
    """A ball that contains the values of a polynomial over two balls."""
    return arb_poly([arb_poly(row)(s) for row in rows_of(p)])(t)


def least_value(p: fmpz_mpoly, first: fmpz_poly, second: fmpz_poly) -> int:
    """A number b such that, at a root of one integer polynomial and a root of another, p is 0 or at least ``2^−b`` in
    absolute value.

    This is Liouville's inequality: the product of the absolute values of an algebraic number at all places of its field
    is 1. At the other places the number is at most the sum of the coefficients of p times powers of the Mahler
    measures, which are at most the Euclidean norms of both polynomials (Waldschmidt, Diophantine Approximation on
    Linear Algebraic Groups, 2000, §3.5).

    >>> least_value(S - T, fmpz_poly([-2, 0, 1]), fmpz_poly([-3, 0, 1]))
    16
    """
    m, n = (int(k) for k in p.degrees())
    total = sum(abs(int(x)) for x in p.coeffs())
    size = first.degree() * second.degree() * total.bit_length()
    return size + m * second.degree() * _norm_bits(first) + n * first.degree() * _norm_bits(second)


def _norm_bits(p: fmpz_poly) -> int:
    """The base 2 logarithm of the Euclidean norm of the coefficients, rounded up."""
    return (sum(int(x) ** 2 for x in p.coeffs()).bit_length() + 1) // 2


def jacobian(f: fmpz_mpoly, g: fmpz_mpoly) -> fmpz_mpoly:
    """The Jacobian determinant of two polynomials.

    >>> jacobian(S * T, S + T)
    -s + t
    """
    return f.derivative(0) * g.derivative(1) - f.derivative(1) * g.derivative(0)


def polynomial_of(form: PatchForm) -> fmpz_mpoly:
    """The form as a polynomial in both parameters."""
    return CONTEXT.from_dict({(i, j): x for i, row in enumerate(powers_of(form)) for j, x in enumerate(row) if x})


def as_polynomial(form: PatchForm) -> fmpz_mpoly:
    """The form as a primitive polynomial in both parameters, up to a positive constant."""
    p = polynomial_of(form)
    return p / common_divisor(p.coeffs()) if p else p


def over(form: PatchForm, sides: Box) -> fmpz_mpoly:
    """The polynomial of a form on a patch with these sides, in the parameters of the surface, up to a positive
    constant.

    >>> from exactspline.numbers.intervals import Interval
    >>> over(PatchForm.of_net([[-1, 0], [0, 1]]), Box(Interval(mpq(0), mpq(2)), Interval(mpq(1), mpq(2))))
    s + 2*t - 4
    """
    p = as_polynomial(form)
    degrees = [max(int(k), 0) for k in p.degrees()]
    tops, bottoms = [], []
    for variable, (low, high) in zip((S, T), sides, strict=True):
        scale = low.denominator * high.denominator
        tops.append(variable * int(scale) - int(low * scale))
        bottoms.append(int((high - low) * scale))
    raised: dict[tuple[int, ...], fmpz] = {
        (int(i), int(j)): x * bottoms[0] ** (degrees[0] - int(i)) * bottoms[1] ** (degrees[1] - int(j))
        for (i, j), x in p.terms()
    }
    return CONTEXT.from_dict(raised).compose(*tops).primitive()[1]


def as_form(p: fmpz_mpoly) -> PatchForm:
    """The form of a polynomial over the unit square, up to a positive constant.

    >>> as_form(S * T - 1).sign
    """
    return as_forms([p])[0].primitive()


def as_forms(polynomials: Sequence[fmpz_mpoly]) -> list[PatchForm]:
    """The forms of polynomials over the unit square, of the same degree and up to a common positive constant.

    >>> [form.entries for form in as_forms([S, T + 1])]
    [[0, 0, 1, 1], [1, 2, 1, 2]]
    """
    m, n = (max(0, *(int(p.degrees()[k]) for p in polynomials)) for k in (0, 1))
    found = []
    for p in polynomials:
        rows = [[fmpz(0)] * (n + 1) for _ in range(m + 1)]
        for (i, j), x in p.terms():
            rows[int(i)][int(j)] = x
        found.append(of_powers(rows))
    return found
