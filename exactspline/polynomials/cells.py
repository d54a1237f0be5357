"""Decomposition of an interval into cells that show where a polynomial vanishes, each with the data for one of three
lemmas: Bernstein coefficients of one sign (no zero), opposite signs at the ends (a zero), a derivative with Bernstein
coefficients of one sign (at most one zero).

The cells are the input of the proofs in ``extras/coq/theory/Answers.v``; a multiple zero has a witness: a factor
of which it is a simple zero, and a cofactor without zeros.
"""

from __future__ import annotations

from dataclasses import dataclass
from operator import itemgetter

from flint import fmpq, fmpq_poly, fmpz_poly

from exactspline.errors import DomainError
from exactspline.numbers.exact import mpq, text, to_fmpq
from exactspline.polynomials.bernstein import of_parameter
from exactspline.polynomials.factors import factorize_square_free

#: The maximal number of bisections of an interval.
DEPTH = 400


@dataclass(frozen=True)
class Cell:
    """An interval in the interior of which a polynomial has no zero (`sign` is its sign), is identically 0 (`sign` is
    None), or has one zero (`one`) and `sign` is its sign to the left of it.

    For a multiple zero, the polynomial is ``factor^power · rest``, where the zero is simple in `factor`, and `rest` has
    no zero and the sign `rest_sign`; `sign` is the sign of the factor to the left.
    """

    low: mpq
    high: mpq
    sign: bool | None
    one: bool = False
    factor: fmpq_poly | None = None
    power: int = 1
    rest: fmpq_poly | None = None
    rest_sign: bool = True


def cells_of(polynomial: fmpq_poly, low: mpq, high: mpq) -> list[Cell]:
    """The cells of a polynomial between two points.

    >>> [(str(c.low), str(c.high), c.sign, c.one) for c in cells_of(fmpq_poly([-1, 0, 2]), mpq(0), mpq(1))]
    [('0', '1', False, True)]
    >>> [c.one for c in cells_of(fmpq_poly([1, 0, -4, 0, 4]), mpq(0), mpq(1))]
    [True]

    Raises `DomainError` if bisection does not terminate.
    """
    if not polynomial:
        return [Cell(low, high, None)]
    powers = sorted(factorize_square_free(polynomial.numer()).powers, key=itemgetter(1))
    multiple = [(fmpq_poly(f) / f.leading_coefficient(), e) for f, e in powers if e > 1]
    cells: list[Cell] = []
    todo = [(low, high, 0)]
    while todo:
        a, b, depth = todo.pop()
        cell = _cell(polynomial, multiple, a, b)
        if cell is not None:
            cells.append(cell)
            continue
        if depth == DEPTH:
            raise DomainError("bisection does not terminate", where=f"[{text(a)}, {text(b)}]", remedy="report this")
        middle = (a + b) / 2
        todo += [(middle, b, depth + 1), (a, middle, depth + 1)]
    return cells


def bernstein_signs(polynomial: fmpq_poly, low: mpq, high: mpq) -> tuple[bool, bool]:
    """Whether no Bernstein coefficient on an interval is negative, and whether none is positive."""
    n = polynomial.degree()
    c = of_parameter(polynomial.numer(), n, low, high) if n >= 0 else fmpz_poly()
    return all(x >= 0 for x in c.coeffs()), all(x <= 0 for x in c.coeffs())


def _cell(f: fmpq_poly, multiple: list[tuple[fmpq_poly, int]], a: mpq, b: mpq) -> Cell | None:
    if (sign := _one_sign(f, a, b)) is not None:
        return Cell(a, b, sign)
    if (sign := _one_zero(f, a, b)) is not None:
        return Cell(a, b, sign, one=True)
    for g, power in multiple:
        if (sign := _one_zero(g, a, b)) is not None:
            rest = f // g**power
            rest_sign = _one_sign(rest, a, b)
            if rest_sign is not None and _at(rest, a) and _at(rest, b):
                return Cell(a, b, sign, one=True, factor=g, power=power, rest=rest, rest_sign=rest_sign)
    return None


def _one_sign(f: fmpq_poly, a: mpq, b: mpq) -> bool | None:
    """The sign in the interior, if it follows from the Bernstein coefficients, else None."""
    not_negative, not_positive = bernstein_signs(f, a, b)
    return None if not_negative == not_positive else not_negative


def _one_zero(f: fmpq_poly, a: mpq, b: mpq) -> bool | None:
    """The sign to the left of the only zero in the interior, if this follows from the ends and the derivative, else
    None.
    """
    at_low, at_high = _at(f, a), _at(f, b)
    if at_low == 0 or at_high == 0 or (at_low > 0) == (at_high > 0):
        return None
    rising = _one_sign(f.derivative(), a, b)
    return None if rising is None or rising == bool(at_low > 0) else bool(at_low > 0)


def _at(f: fmpq_poly, t: mpq) -> fmpq:
    return f(to_fmpq(t))
