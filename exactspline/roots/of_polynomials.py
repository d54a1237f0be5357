"""The real roots of polynomials in intervals with rational ends, as certified zeros of splines."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from flint import arb, ctx, fmpz_poly

from exactspline.errors import ReachError
from exactspline.numbers.exact import mpq, to_fmpz
from exactspline.numbers.exact import sign as sign_of
from exactspline.numbers.intervals import Interval, ball_around
from exactspline.polynomials.bernstein import ONE, of_parameter
from exactspline.polynomials.cost import QUESTION, check_reach, height_bits
from exactspline.polynomials.factors import factorize, factorize_square_free
from exactspline.roots.root import Root
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh

#: An exact parameter: rational, or a certified root.
Parameter = mpq | Root
#: A pair of parameters.
Place = tuple[Parameter, Parameter]

#: The cost of making a form and isolating its roots, in hundredths of a nanosecond per square of the degree and per
#: bit.
ISOLATION = 80
#: The first precision (digits) at which a sign is tried.
DIGITS = 15


def as_splines(polynomials: Sequence[fmpz_poly], a: mpq, b: mpq) -> list[BSpline]:
    """Polynomials as splines of the same degree over [a, b], up to a common positive constant.

    >>> [f("1/2") for f in as_splines([fmpz_poly([0, 2]), fmpz_poly([1])], mpq(0), mpq(1))]
    [mpq(1,1), mpq(1,1)]
    """
    n, mesh = max(0, *[p.degree() for p in polynomials]), Mesh([a, b])
    return [BSpline.from_forms(n, mesh, (), [(of_parameter(p, n, a, b), ONE)]) for p in polynomials]


def roots_in(p: fmpz_poly, a: mpq, b: mpq, *, whole: bool = False) -> list[Root]:
    """The distinct real roots of a polynomial in [a, b], in ascending order; a `whole` polynomial, which is square-free
    or irreducible, is not factored.

    >>> [root.exact for root in roots_in(fmpz_poly([0, -1, 0, 4]), mpq(0), mpq(1))]
    [mpq(0,1), mpq(1,2)]
    """
    if not p:
        return []
    check_isolation(p, height_bits(to_fmpz(x) for end in (a, b) for x in (end.numerator, end.denominator)))
    try:
        factors = [p] if whole else factorize(p).bases
    except ReachError:  # roots are refined faster with irreducible factors, but the square-free part has the same roots
        factors = factorize_square_free(p).bases
    return sorted(root for q in factors for root in zeros(as_splines([q], a, b)[0]))


def check_isolation(p: fmpz_poly, bits: int = 0) -> None:
    """Raise `ReachError` if isolating the roots of a polynomial, between ends of this many bits, takes too long."""
    cost = p.degree() ** 2 * (height_bits(p.coeffs()) + p.degree() * (1 + bits)) * ISOLATION // 100
    check_reach(cost, lambda: f"the isolation of the roots of a polynomial of degree {p.degree()}", QUESTION)


def ball(t: Parameter, digits: int) -> arb:
    """A ball around a parameter; the caller sets FLINT's precision."""
    return ball_around(*(t.refine(digits) if isinstance(t, Root) else (t, t)))


def sign_of_number(enclosed: Callable[[int], arb]) -> int:
    """The sign of a number that is not zero, from balls around it for more and more digits of the parameters."""
    digits = DIGITS
    while True:
        with ctx.workprec(8 * digits + 64):
            if sign := sign_of(enclosed(digits)):
                return sign
        digits *= 2


def exactly(t: Parameter) -> Parameter:
    """The rational value of a parameter that is rational; any other parameter is unchanged."""
    return t if not isinstance(t, Root) or t.exact is None else t.exact


def enclosing(t: Parameter, digits: int) -> Interval:
    """An interval that contains a parameter, at most ``10^−digits`` long."""
    return t.refine(digits) if isinstance(t, Root) else Interval.point(t)


def distinct(numbers: Iterable[Parameter]) -> list[Parameter]:
    """The numbers in ascending order, each once; rational numbers are converted to rational values."""
    found: list[Parameter] = []
    for t in sorted(map(exactly, numbers)):
        if not found or found[-1] != t:
            found.append(t)
    return found
