"""Common factors of forms on a patch: along their zeros the forms vanish on a whole curve."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from flint import fmpz_poly

from exactspline.numbers.exact import common_divisor, mpq, sign
from exactspline.polynomials.factors import divided_out, factorize, factorize_square_free, greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm, powers_of
from exactspline.polynomials.two_parameters import CONTEXT, as_form, as_polynomial


def common_factor(forms: Sequence[PatchForm]) -> PatchForm | None:
    """The greatest common divisor of forms that are not zero; None where it is a constant."""
    divisor = greatest_common_divisor(as_polynomial(f) for f in forms)
    return as_form(divisor) if divisor.total_degree() > 0 else None


def line_factor(form: PatchForm, direction: int) -> fmpz_poly:
    """The greatest factor of a form that depends on x (direction 0) or y alone, without a common divisor of its
    coefficients: where it vanishes, the form vanishes on a whole line.

    >>> line_factor(PatchForm.of_net([[1, -1], [-2, 2]]), 0)  # (1 − 3x)(1 − 2y)
    3*x + (-1)
    """
    rows = powers_of(form)
    columns = rows if direction else [list(column) for column in zip(*rows, strict=True)]
    found = greatest_common_divisor(fmpz_poly(column) for column in columns)
    return found // common_divisor(found.coeffs())


def rational_lines(form: PatchForm, direction: int) -> list[mpq]:
    """The rational values of x (direction 0) or y for which a form vanishes on the whole line.

    >>> rational_lines(PatchForm.of_net([[1, -1], [-2, 2]]), 1)
    [mpq(1,2)]
    """
    own = line_factor(form, direction)
    if own.degree() < 1:
        return []
    return sorted(mpq(int(-p[0]), int(p[1])) for p in factorize(own).bases if p.degree() == 1)


def divided(form: PatchForm, factor: PatchForm) -> PatchForm:
    """The quotient of a form by a factor of it."""
    quotient, rest = divmod(as_polynomial(form), as_polynomial(factor))
    assert not rest, "the factor divides"
    return as_form(quotient)


def without_powers(form: PatchForm, factor: PatchForm, *, even: bool = False) -> PatchForm:
    """A form divided by a factor as often as possible; with `even`, by the square of the factor, so that signs are
    preserved.

    >>> square = PatchForm.of_net([[4, -4, 4]])  # 4 (1 − 2y)²
    >>> without_powers(square, PatchForm.of_net([[1, -1]])).degree
    (0, 0)
    """
    q = as_polynomial(factor)
    return as_form(divided_out(as_polynomial(form), q * q if even else q))


def square_free(form: PatchForm) -> PatchForm:
    """The product of the factors that depend on a parameter, each once."""
    factors = factorize_square_free(as_polynomial(form)).powers
    return as_form(reduce(lambda p, q: p * q, [p for p, _ in factors], CONTEXT.from_dict({(0, 0): 1})))


def odd_part(form: PatchForm) -> PatchForm:
    """The form without squares of factors; it has the sign of the form wherever that is nonzero.

    >>> odd_part(PatchForm.of_net([[-1, 1, -1]])).degree  # −(1 − 2y)²
    (0, 0)
    """
    constant, factors = factorize_square_free(as_polynomial(form))
    own = CONTEXT.from_dict({(0, 0): sign(constant)})
    return as_form(reduce(lambda p, q: p * q, [p for p, times in factors if times % 2], own))
