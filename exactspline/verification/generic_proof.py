"""Proofs for all curves: quotients of formulas in the jet ring, reductions, degrees by the degree theorem."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING

from exactspline.errors import ExactSplineError, FormulaError, ReachError, as_flag, as_integer
from exactspline.interchange.examples import example, example_surface
from exactspline.language.arguments import Evaluated, Operands, Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import SURFACE, TableKind
from exactspline.language.operand import Parameter
from exactspline.language.ruled import joined, split
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.papers import Paper, formula_of
from exactspline.polynomials.cost import Budget, at_its_cost, drawing_on
from exactspline.readings.degree import Degree
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet
from exactspline.readings.taylor import DoubleTaylorReading
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
    degree: Degree = formula(table_1_degrees()).degree
    return degree


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
