"""Lowest degrees for all curves, symbolic in d, by the degree theorem."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.language.choices import Parameter
from exactspline.language.formula import Formula
from exactspline.readings.degree import Degree
from exactspline.symbolic.covariants import degree_at, generic_degree, truncated, without_content
from exactspline.symbolic.reduction import Reduction, reduction
from exactspline.verification.generic_proof import reduction_of

if TYPE_CHECKING:
    from exactspline.geometry.constructions import Construction


def symbolic_minimum(c: Construction, dimension: int, *, polynomial: bool = False) -> Degree:
    """The true degree of the minimal form on the generic curve of degree d, for symbolic d: no curve has a higher one.

    In the jet ring numerator and denominator lose their common factor; the degree theorem
    (`exactspline.symbolic.covariants`) does the rest.

    >>> from exactspline.geometry.constructions import construction
    >>> symbolic_minimum(construction("zero_curvature"), 2), symbolic_minimum(construction("critical_curvature"), 2)
    (3d − 6, 8d − 12)
    """
    reduced = reduction(c.lifted, dimension, polynomial)
    if c.ruled:
        return reduced.parts[0].generic_lowest.max(reduced.main.generic)
    return generic_degree(reduced.main.lowest[0]) if c.zero_set else reduced.main.generic_lowest


def lowest_degree(formula: Formula, dimension: int, *, polynomial: bool = False) -> Degree:
    """The degree of a formula in lowest terms on the generic argument of its kind, for symbolic d: an upper bound on
    every one.

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

    >>> from exactspline.geometry.constructions import construction
    >>> torsion, focal_curve = construction("torsion"), construction("focal_curve")
    >>> minimum_at(torsion, 3), minimum_at(torsion, 2), minimum_at(focal_curve, 2)
    (6, -1, None)
    """
    from exactspline.geometry.constructions import Variant

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
