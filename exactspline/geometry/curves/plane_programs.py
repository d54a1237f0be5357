"""The forms of κ, κ′ and the speed of segments as a program, which runs over doubles, balls and integers; in space also
the form of τ.
"""

from __future__ import annotations

from functools import cache

from exactspline.formulas.lifted import PLANE_FORMS, SPACE_FORMS
from exactspline.language.kinds import PLANE, SPACE, CurveKind
from exactspline.programs.program import Program, program_of_all
from exactspline.programs.reading import Signature

#: The outputs of the programs: in the plane the first is κ, in space τ, and there is a fourth, ‖γ′ × γ″‖².
CURVATURE, CRITICAL, SPEED = range(3)
TORSION, BENDING = 0, 3


def _signature(kind: CurveKind, degree: int, rational: bool) -> Signature:
    """The signature of a program for segments of width 1 over common denominators, at their true degrees."""
    (dimension,) = kind.dimensions
    count = dimension + rational
    return Signature(kind, dimension, not rational, (degree,) * count, (0,) * count, unit_widths=True, true_degree=True)


@cache
def plane_program(degree: int, rational: bool) -> Program:
    """The program of one degree: κ, κ′ and ‖γ′‖² up to positive factors."""
    return program_of_all(PLANE_FORMS, _signature(PLANE, degree, rational))


@cache
def space_program(degree: int, rational: bool) -> Program:
    """The program of one degree in space: τ, κ′, ‖γ′‖² and ‖γ′ × γ″‖² up to positive factors."""
    return program_of_all(SPACE_FORMS, _signature(SPACE, degree, rational))
