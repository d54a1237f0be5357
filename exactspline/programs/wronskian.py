"""The lowest Wronskian of a vector (see `exactspline.splines.wronskian`) as a program."""

from __future__ import annotations

from functools import cache
from math import factorial, prod
from typing import Any, overload

from exactspline.language.formula import Formula
from exactspline.language.vector import Vector, det
from exactspline.programs.denominators import Denominator
from exactspline.programs.term import Term
from exactspline.splines import wronskian
from exactspline.splines.bspline import BSpline


def lowest_wronskian(vector: Vector[Term]) -> Term:
    """The Wronskian of terms at its true degree: the determinant of partial derivatives over a constant.

    >>> from exactspline.papers import find
    >>> from exactspline.programs.program import operands_of
    >>> from exactspline.splines.examples import example
    >>> lift = find("projective_lift")
    >>> given = operands_of(lift.kind, example("rational_cubic"))
    >>> given.value(wronskian_of(lift)).degree, given.value(find("f2")).degree
    (3, 6)
    """
    r, n = len(vector) - 1, max(term.degree for term in vector)
    if n < r:
        return vector[0].constant(0)
    columns = [term.partials(n, r) for term in vector]
    value: Term = det(*[Vector(*[column[i] for column in columns]) for i in range(r + 1)])
    constant = prod(factorial(n - i) // factorial(n - r) for i in range(r))
    return value.per_width(r * (r + 1) // 2, r).over(Denominator(constant))


@overload
def lowest(vector: Vector[Term]) -> Term: ...
@overload
def lowest(vector: Vector[BSpline]) -> BSpline: ...
def lowest(vector: Vector[Term] | Vector[BSpline]) -> Term | BSpline:
    """The lowest Wronskian of terms of a program or of splines."""
    terms: Any = vector
    return lowest_wronskian(terms) if isinstance(vector[0], Term) else wronskian.lowest_wronskian(terms)


@cache
def wronskian_of(lift: Formula) -> Formula:
    """The lowest Wronskian of the value of a formula, as a formula for the readings of programs and splines."""

    def of(c: Any) -> Any:
        return lowest(lift(c))

    of.__name__ = f"lowest Wronskian of {lift.name}"
    return Formula(of, lift.source, lift.kind, "")
