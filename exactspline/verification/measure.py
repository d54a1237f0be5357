"""The degrees and the number of control points of a formula on one curve."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.errors import as_integer
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, PLANE, SPACE
from exactspline.language.parts import joined
from exactspline.papers import all_formulas, known_as
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.splines.expected import curve_of
from exactspline.splines.lowest_terms import control_point_count, true_degree_or_none
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True)
class Measure:
    """The cost of one formula on one curve.

    ``nominal`` symbolic in d, ``represented`` and ``true`` as numbers (−1 for what vanishes identically; no true degree
    where a denominator vanishes on a whole segment), ``control_points`` of the representation.
    """

    formula: str
    nominal: Degree
    represented: int
    true: int | None
    control_points: int


def measure(formula: Formula, curve: Nurbs) -> Measure:
    """The degrees and the number of control points of a formula on a curve.

    >>> from exactspline.splines.examples import example
    >>> from exactspline.papers import find
    >>> measure(find("f2"), example("ellipse"))
    Measure(formula='f2', nominal=3d − 3, represented=3, true=0, control_points=16)
    """
    formula, curve = expect_formula(formula), curve_of(curve)
    value = joined(formula(curve))
    nominal = formula(DegreeReading().argument(CURVE, curve.dimension, polynomial=curve.polynomial)).degree
    return Measure(known_as(formula), nominal, value.degree, true_degree_or_none(value), control_point_count(value))


def speaks_of(formula: Formula, dimension: int) -> bool:
    """Whether a formula applies to curves of this dimension alone."""
    return formula.kind in {2: (PLANE, CURVE), 3: (SPACE, CURVE)}.get(dimension, (CURVE,))


def measurable(dimension: int) -> list[Formula]:
    """The formulas that apply to curves of this dimension."""
    n = as_integer(dimension, "a dimension", 1)
    return [formula for formula in all_formulas().values() if speaks_of(formula, n)]
