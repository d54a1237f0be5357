"""Certificates that the degree of a form cannot be lowered: no common factor on any segment, and full degree.

A quotient is certified segment by segment: modulo a prime, polynomial multiples of the components of numerator and
denominator add up to 1, so that they have no common factor, and one of them has full degree at the right end. The form
of a zero set is divided by its multiple factors, and certified to have its full degree in the parameter, no multiple
factor and no common factor with w. No polynomial of a lower degree has the same zeros if the form has a zero and is
`irreducible` modulo some prime: then every polynomial over ℚ that vanishes at one of its zeros is a multiple of the
form. In other cases a factor without a zero on the segment might be omitted. `exactspline.certificates` checks the data
with the standard library alone. It checks the forms, and not that they belong to the construction, the curve and the
intervals named.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random
from typing import Any

from flint import fmpz_poly, nmod_poly

from exactspline.certificates import DEGREE, check_certificate
from exactspline.certificates import certificate as written
from exactspline.certificates.degrees import LABELS, is_square_free
from exactspline.errors import ReductionError, ShapeError
from exactspline.geometry.derived.constructions import Construction, Variant, construction
from exactspline.geometry.derived.derive import Piece, derive
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.polynomials.bernstein import divide_u_plus_v
from exactspline.polynomials.elimination import square_free
from exactspline.polynomials.factors import factorize
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.generic_proof import minimum_at

#: Primes near 2⁶¹ for common factors; small ones for irreducibility, where the residue must be irreducible by chance.
LARGE_PRIMES = (2305843009213693951, 2305843009213693921, 2305843009213693907, 2305843009213693723)
SMALL_PRIMES = tuple(p for p in range(101, 2000) if all(p % q for q in range(2, 45)))
#: Beyond this degree no prime of irreducibility is searched for.
LARGEST = 60


def certificate(name: str, curve: Nurbs) -> dict[str, object]:
    """The certificate of a construction on a curve, as JSON data.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.certificates import check_certificate
    >>> check_certificate(certificate("evolute", example("circle")))
    {'degree': 0, 'construction checked': False, 'curve checked': False, 'intervals checked': False}
    >>> check_certificate(certificate("critical_curvature", example("ellipse_skew")))["irreducible"]
    True

    Raises `ShapeError` if the object does not exist or vanishes, `ReductionError` should the proof fail.
    """
    made, derived = construction(name), derive(name, curve, Variant.MINIMAL)
    found = [each for piece in derived.pieces for each in _segments(made, piece, curve)]
    if not found:
        raise ShapeError(f"{name} vanishes identically", remedy="there is nothing to certify")
    kind = "zero set" if made.zero_set else "quotient"
    labels = {"construction": name, "curve": curve.name, "intervals": [list(map(text, span)) for span, _ in found]}
    return written(DEGREE, {LABELS: labels, "kind": kind, "segments": [segment for _, segment in found]})


def _segments(made: Construction, piece: Piece, curve: Nurbs) -> list[tuple[tuple[mpq, mpq], dict[str, Any]]]:
    """The intervals on which the object does not vanish, each with its part of the proof."""
    value = piece.value
    if not made.zero_set:
        if not isinstance(value, Rational):
            value = _over_one(list(value) if isinstance(value, Vector) else [value])
        if value.is_zero and not value.is_vector:
            return []
        spans = pairwise(value.denominator.breakpoints)
        return [(span, _segment(forms, n)) for span, (forms, n) in zip(spans, lowest_terms(value), strict=True)]
    segments = []
    for (a, b), (c, _) in zip(pairwise(value.breakpoints), value.forms, strict=True):
        if c:
            # a zero at the right end is a factor, too, and lowers the degree of the polynomial in u/v
            simple, at_end = square_free(c), c.degree() < value.degree
            lowest, _ = divide_u_plus_v(simple, simple.degree())
            n, weight = lowest.degree() + at_end, curve.w.restrict(a, b)
            w, _ = divide_u_plus_v(weight.numerators[0], weight.degree)
            irreducible = {"irreducible modulo": _irreducible(lowest, n)}
            segments.append(((a, b), _segment([lowest], n, w) | irreducible))
    return segments


def _over_one(components: list[Any]) -> Rational[BSpline]:
    """A polynomial vector as a quotient, its components over one mesh."""
    components = with_common_knots(components)
    return Rational(Vector(*components), components[0].constant(1))


def _coefficients(c: fmpz_poly, n: int) -> list[str]:
    return [str(c[i]) for i in range(n + 1)]


def _segment(forms: list[fmpz_poly], n: int, w: fmpz_poly | None = None) -> dict[str, Any]:
    """One segment: forms of degree n without a common factor, for a zero set together with the weight."""
    weights = [] if w is None else [w]
    degrees = [*[n] * len(forms), *[c.degree() for c in weights]]
    prime, cofactors = bezout_combination([*forms, *weights], degrees, simple=w is not None)
    segment = {"degree": n, "forms": [_coefficients(c, n) for c in forms]}
    weight = {} if w is None else {"weight": _coefficients(w, w.degree())}
    return segment | weight | {"prime": prime, "cofactors": cofactors}


def bezout_combination(
    forms: Sequence[fmpz_poly], degrees: Sequence[int], *, simple: bool = False
) -> tuple[int, list[list[str]]]:
    """A prime, and polynomials modulo it whose products with the forms add up to 1; the prime divides no leading
    coefficient of a form of full degree, and with `simple` the first form is square-free modulo the prime.
    """
    for p in LARGE_PRIMES:
        if all(int(c[n]) % p == 0 for c, n in zip(forms, degrees, strict=True)):
            continue
        reduced = [nmod_poly(c.coeffs(), p) for c in forms]
        if simple and not is_square_free([int(forms[0][i]) for i in range(degrees[0] + 1)], p):
            continue
        common, cofactors = reduced[0], [nmod_poly([1], p)]
        for other in reduced[1:]:
            common, s, t = common.xgcd(other)
            cofactors = [*[a * s for a in cofactors], t]
        if common.degree() == 0:
            unit = nmod_poly([1], p) // common
            return p, [[str(x) for x in (a * unit).coeffs()] for a in cofactors]
    raise ReductionError("no prime shows that there is no common factor", remedy="the form is not in lowest terms")


def _irreducible(c: fmpz_poly, n: int) -> int | None:
    """A prime modulo which the form is irreducible and of full degree, or None."""
    if not 1 <= n <= LARGEST or c.degree() < n:
        return None
    if [e for _, e in factorize(c).powers] != [1]:
        return None
    for p in SMALL_PRIMES:
        if int(c[n]) % p and [e for _, e in factorize(nmod_poly(c.coeffs(), p)).powers] == [1]:
            return p
    return None


def witness(dimension: int, degree: int, *, polynomial: bool = False) -> Nurbs:
    """A Bézier curve without coincidences in its data: integers from a generator with a fixed seed.

    >>> witness(2, 3).degree
    3
    """
    numbers = Random(17 * degree + dimension)
    points = [[numbers.randint(-50, 50) for _ in range(dimension)] for _ in range(degree + 1)]
    weights = None if polynomial else [numbers.randint(1, 30) for _ in points]
    kind = "polynomial" if polynomial else "rational"
    return Nurbs(
        degree,
        [0] * (degree + 1) + [1] * (degree + 1),
        points,
        weights,
        name=f"witness: {kind}, degree {degree}, in R{dimension}",
    )


@dataclass(frozen=True)
class Attained:
    """Whether the proved degree of a construction is attained at a degree d, with the certificate; both are None if the
    object does not exist.
    """

    construction: str
    polynomial: bool
    d: int
    proved: int | None
    attained: int | None
    certificate: dict[str, Any] | None

    @property
    def agrees(self) -> bool:
        """Whether the proved and the attained degree agree."""
        return self.proved == self.attained


def attained(name: str, d: int, *, polynomial: bool = False) -> Attained:
    """The degree of a construction on the witness of degree d, compared with the degree theorem.

    >>> result = attained("critical_curvature", 2)
    >>> result.proved, result.attained, result.certificate["segments"][0]["irreducible modulo"] is not None
    (4, 4, True)
    """
    made = construction(name)
    proved = minimum_at(made, d, polynomial=polynomial)
    try:
        data = certificate(name, witness(made.dimension, d, polynomial=polynomial))
    except ShapeError:
        return Attained(name, polynomial, d, proved if proved is not None and proved >= 0 else None, None, None)
    return Attained(name, polynomial, d, proved, check_certificate(data)["degree"], data)
