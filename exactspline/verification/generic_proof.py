"""Proofs for all curves: quotients of formulas in the jet ring, reductions, degrees by the degree theorem; and
certificates that the degree of a form cannot be lowered: no common factor on any segment, and full degree.

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

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from random import Random
from typing import TYPE_CHECKING, Any, cast

from flint import fmpz_poly, nmod_poly

from exactspline.certificates import DEGREE, check_certificate
from exactspline.certificates import certificate as written
from exactspline.certificates.degrees import LABELS, is_square_free
from exactspline.errors import (
    ExactSplineError,
    FormulaError,
    ReachError,
    ReductionError,
    ShapeError,
    as_flag,
    as_integer,
)
from exactspline.geometry.derived.constructions import Construction, Variant, construction
from exactspline.geometry.derived.derive import Piece, derive
from exactspline.interchange.examples import example, example_surface
from exactspline.language.arguments import Evaluated, Operands, Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import SURFACE, TableKind
from exactspline.language.operand import Parameter
from exactspline.language.rational import Rational
from exactspline.language.ruled import joined, split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.papers import Paper, formula_of
from exactspline.polynomials.bernstein import divide_u_plus_v
from exactspline.polynomials.cost import Budget, at_its_cost, drawing_on
from exactspline.polynomials.elimination import square_free
from exactspline.polynomials.factors import factorize
from exactspline.readings.degree import Degree
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet
from exactspline.readings.taylor import DoubleTaylorReading
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import lowest_terms
from exactspline.splines.nurbs import Nurbs
from exactspline.symbolic.assumptions import Assumption, zero_free
from exactspline.symbolic.covariants import degree_at, generic_degree, truncated, without_content
from exactspline.symbolic.factorization import POLYNOMIAL, Factor, find_factor, jets_for, naming
from exactspline.symbolic.reduction import Reduction, counted_in, reduce, reduction
from exactspline.verification.evaluation import argument
from exactspline.verification.vocabulary import Name

if TYPE_CHECKING:
    from exactspline.geometry.derived.constructions import Construction


def factor_of(left: str | Formula, right: str | Formula, dimension: int, *, polynomial: bool = False) -> Factor | None:
    """Return the quotient of two formulas for all curves of this dimension, or None if the formulas are not
    proportional.

    >>> str(factor_of("f0", "f2", 2)), str(factor_of("f0", "f2", 2, polynomial=True))
    ('w⁻³', '1')

    Raises `ClaimError` when the right side vanishes identically.
    """
    dimension, polynomial = as_integer(dimension, "a dimension", 1), as_flag(polynomial, POLYNOMIAL)
    return _factor(formula_of(left), formula_of(right), dimension, polynomial, naming())


@at_its_cost
def _factor(left: Formula, right: Formula, dimension: int, polynomial: bool, names: tuple[Paper, ...]) -> Factor | None:
    c = jets_for((left, right), dimension, polynomial=polynomial)
    return find_factor(left(c), right(c))


def harmful(factor: Factor, assumed: Iterable[Assumption]) -> tuple[list[Name], tuple[Name, ...]]:
    """The names of the irreducible parts of a factor that may have zeros, and those of the assumptions that exclude
    zeros of the others.
    """
    assumed, names, used = list(assumed), list[Name](), list[Name]()
    for (name, polynomial), _ in factor.powers:
        reason = zero_free(Jet(factor.ring, polynomial), assumed)
        if reason is None:
            names.append(Name(name))
        elif reason.name not in used:
            used.append(Name(reason.name))
    return names, tuple(used)


#: Curves and surfaces on which few formulas vanish, by the dimension and by w = 1.
SHOWN = {
    **{(2, False): "rational_cubic_s", (2, True): "cubic_s"},
    **{(3, False): "rational_space_cubic", (3, True): "twisted_cubic"},
}
SHOWN_SURFACES = {False: "rational_biquadratic", True: "bicubic"}


@at_its_cost
def vanishes(formula: Formula, dimension: int, polynomial: bool) -> bool:
    """Whether a formula is zero for all arguments of its kind. A formula that is not zero is usually recognized on one
    example.

    >>> vanishes(formula_of("D1"), 2, True), vanishes(formula_of("D21"), 2, True)
    (False, True)
    """
    shown = _shown(formula, dimension, polynomial)
    if shown is not None and any(not x.is_zero for x in split(joined(formula(shown)))[0]):
        return False
    jets = jets_for((formula,), dimension, polynomial=polynomial)
    return all(x.is_zero for x in split(joined(formula(jets)))[0])


def _shown(formula: Formula, dimension: int, polynomial: bool) -> Evaluated | None:
    """One argument of the kind of a formula; None for kinds without an example."""
    kind = formula.kind
    if kind is SURFACE:
        surface = example_surface(SHOWN_SURFACES[polynomial])
        reading = DoubleTaylorReading(surface, mpq(1, 3), mpq(2, 5), order_of(formula, dimension) + 1)
        return reading.argument(kind, dimension, polynomial=polynomial)
    if not kind.made_of_a_curve or isinstance(kind, TableKind) or kind.adjoins_roots:
        return None
    return argument(kind.name, example(SHOWN[dimension, polynomial])).argument


@cache
def transposed(formula: Formula) -> Formula:
    """A formula of two curves with the curves exchanged, so that its degree in s̄ is that of this one in s."""
    return Formula(lambda c: formula.function(Pair(c.second, c.first)), formula.source, formula.kind, formula.symbol)


def reduction_of(formula: Formula, dimension: int, polynomial: bool, parameter: Parameter | None = None) -> Reduction:
    """The reduction of a formula, computed once; its degrees are counted in the given parameter."""
    reduction = cached_reduction(formula, dimension, polynomial, naming())
    if isinstance(reduction, ExactSplineError):
        raise reduction
    return reduction if parameter is None else counted_in(reduction, formula, parameter)


@cache
def cached_reduction(
    formula: Formula, dimension: int, polynomial: bool, names: tuple[Paper, ...]
) -> Reduction | ExactSplineError:
    """The reduction of a formula, computed once, with its own budget: it does not depend on earlier computations of a
    claim.
    """
    try:
        with drawing_on(Budget()):
            return reduce(formula, dimension=dimension, polynomial=polynomial)
    except (
        FormulaError,
        ReachError,
    ) as error:  # for a formula that is too large this is only known after a long computation
        return error


def degree_in_table_1(formula: Formula) -> Degree:
    """The degree of a row of Table 1."""
    return cast(Degree, formula(table_1_degrees()).degree)


def table_1_degrees() -> Operands:
    """Return the degrees of the operands of the paper's Table 1."""
    one, two = [[Degree.named(name) for _ in range(5)] for name in ("d1", "d2")]
    return Operands(p1=one[0], w1=one[1], v1=Vector(*one[2:]), p2=two[0], w2=two[1], v2=Vector(*two[2:]))


def symbolic_minimum(c: Construction, dimension: int, *, polynomial: bool = False) -> Degree:
    """The true degree of the minimal form on the generic curve of degree d, for symbolic d: no curve has a higher one.

    The common factor of numerator and denominator is cancelled in the jet ring; then the degree theorem
    (`exactspline.symbolic.covariants`) gives the degree.

    >>> from exactspline.geometry.derived.constructions import construction
    >>> symbolic_minimum(construction("zero_curvature"), 2), symbolic_minimum(construction("critical_curvature"), 2)
    (3d − 6, 8d − 12)
    """
    reduced = reduction(c.lifted, dimension, polynomial)
    if c.ruled:
        return reduced.parts[0].generic_lowest.max(reduced.main.generic)
    return generic_degree(reduced.main.lowest[0]) if c.zero_set else reduced.main.generic_lowest


def lowest_degree(formula: Formula, dimension: int, *, polynomial: bool = False) -> Degree:
    """The degree of a formula in lowest terms on the generic argument of its kind, for symbolic d: an upper bound for
    every argument.

    For two curves it is the degree in the parameter of the first.

    >>> from exactspline.papers import find
    >>> lowest_degree(find("plane_bisector"), 2)
    4d − 2
    """
    return joined_degree(reduction_of(formula, dimension, polynomial))


def joined_degree(reduced: Reduction, parameter: Parameter = Parameter.FIRST) -> Degree:
    """The degree of a value in lowest terms; for a ruled surface with directrix and generator over one denominator; −1
    for a value that vanishes. A denominator 1 is not counted.
    """
    *components, denominator = reduced.joined
    top = [jet for jet in components if not jet.is_zero]
    if not top:
        return Degree.number(-1)
    return generic_degree(top if denominator.polynomial.is_constant() else [*top, denominator], parameter)


def minimum_at(c: Construction, d: int, *, polynomial: bool = False) -> int | None:
    """The true degree of the minimal form on the generic curve of one degree d, also below the order of the formula: −1
    for 0, None for 0/0.

    >>> from exactspline.geometry.derived.constructions import construction
    >>> torsion, focal_curve = construction("torsion"), construction("focal_curve")
    >>> minimum_at(torsion, 3), minimum_at(torsion, 2), minimum_at(focal_curve, 2)
    (6, -1, None)
    """
    from exactspline.geometry.derived.constructions import Variant

    reduced = reduction(c.lifted, c.dimension, polynomial)
    numerator, denominator = reduced.parts[0].lowest
    top, (bottom,) = truncated(numerator, d), truncated([denominator], d)
    if bottom.is_zero:
        return None
    if c.ruled:
        generator = truncated(reduced.main.reduced, d)
        if all(jet.is_zero for jet in generator):
            return None
        return max(degree_at(without_content([*top, bottom]), d), degree_at(without_content(generator), d))
    if all(jet.is_zero for jet in top):
        return -1
    if not c.zero_set:
        return degree_at(without_content([*top, bottom]), d)
    shared = bottom.ring.number(1) if polynomial else bottom.ring["w"] ** c.power_of_w(Variant.LIFTED)
    return degree_at(without_content([top[0], shared])[:1], d)


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
    if not 1 <= n <= LARGEST or c.degree() < n or [e for _, e in factorize(c).powers] != [1]:
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
