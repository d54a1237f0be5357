"""The real roots of polynomials between rational numbers, as certified zeros of splines."""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpz_poly

from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, to_fmpz
from exactspline.polynomials.bernstein import ONE, of_parameter
from exactspline.polynomials.cost import QUESTION, check_reach, height_bits
from exactspline.polynomials.factors import factorize, factorize_square_free
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

#: An exact parameter: rational, or a certified root.
Parameter = mpq | Root

#: Hundredths of a nanosecond, times the square of the degree and the bits of a form, to make it and to isolate its
#: roots.
ISOLATION = 80


def as_splines(polynomials: Sequence[fmpz_poly], a: mpq, b: mpq) -> list[BSpline]:
    """Polynomials as splines of one degree over [a, b], up to one positive constant.

    >>> [f("1/2") for f in as_splines([fmpz_poly([0, 2]), fmpz_poly([1])], mpq(0), mpq(1))]
    [mpq(1,1), mpq(1,1)]
    """
    n, mesh = max(0, *[p.degree() for p in polynomials]), Mesh([a, b])
    return [BSpline.from_forms(n, mesh, (), [(of_parameter(p, n, a, b), ONE)]) for p in polynomials]


def roots_in(p: fmpz_poly, a: mpq, b: mpq) -> list[Root]:
    """The real roots of a polynomial in [a, b], in order, each once.

    >>> [root.exact for root in roots_in(fmpz_poly([0, -1, 0, 4]), mpq(0), mpq(1))]
    [mpq(0,1), mpq(1,2)]
    """
    if not p:
        return []
    check_isolation(p, height_bits(to_fmpz(x) for end in (a, b) for x in (end.numerator, end.denominator)))
    try:
        factors = factorize(p).bases
    except ReachError:  # with irreducible factors roots are refined faster, but these have the same
        factors = factorize_square_free(p).bases
    return sorted(root for q in factors for root in zeros(as_splines([q], a, b)[0]))


def check_isolation(p: fmpz_poly, bits: int = 0) -> None:
    """`ReachError` where isolating the roots of a polynomial, between ends of this many bits, would take too long."""
    cost = p.degree() ** 2 * (height_bits(p.coeffs()) + p.degree() * (1 + bits)) * ISOLATION // 100
    check_reach(cost, lambda: f"the isolation of the roots of a polynomial of degree {p.degree()}", QUESTION)


def exactly(t: Parameter) -> Parameter:
    """The rational number itself where a root is one."""
    return t if not isinstance(t, Root) or t.exact is None else t.exact
