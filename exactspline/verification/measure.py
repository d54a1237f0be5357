"""The degrees and the number of control points of a formula on one curve."""

from __future__ import annotations

from dataclasses import dataclass

from exactspline.errors import as_integer, counted
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, PLANE, SPACE
from exactspline.language.parts import joined
from exactspline.papers import all_formulas, known_as
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.splines.expected import curve_of
from exactspline.splines.lowest_terms import control_point_count, true_degree_or_none
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True, repr=False)
class Measure:
    """The degrees and the size of one formula on one curve.

    ``nominal`` symbolic in d, ``represented`` and ``true`` as numbers (−1 for a formula that vanishes identically; no
    true degree where a denominator vanishes on a whole segment), ``control_points`` of the representation.
    """

    formula: str
    nominal: Degree
    represented: int
    true: int | None
    control_points: int

    def __repr__(self) -> str:
        degrees = f"degree {self.nominal}, here {self.represented}, true degree {self.true}"
        return f"<Measure {self.formula}: {degrees}, {counted(self.control_points, 'control point')}>"


def measure(formula: Formula, curve: Nurbs) -> Measure:
    """The degrees and the number of control points of a formula on a curve.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> measure(find("f2"), example("ellipse"))
    <Measure f2: degree 3d − 3, here 3, true degree 0, 16 control points>
    """
    formula, curve = expect_formula(formula), curve_of(curve)
    value = joined(formula(curve))
    nominal = formula(DegreeReading().argument(CURVE, curve.dimension, polynomial=curve.polynomial)).degree
    return Measure(known_as(formula), nominal, value.degree, true_degree_or_none(value), control_point_count(value))


def speaks_of(formula: Formula, dimension: int) -> bool:
    """Whether a formula applies to single curves of this dimension."""
    return formula.kind in {2: (PLANE, CURVE), 3: (SPACE, CURVE)}.get(dimension, (CURVE,))


def measurable(dimension: int) -> list[Formula]:
    """The formulas that apply to curves of this dimension."""
    n = as_integer(dimension, "a dimension", 1)
    return [formula for formula in all_formulas().values() if speaks_of(formula, n)]
