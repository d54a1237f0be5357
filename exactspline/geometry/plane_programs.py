"""The forms of κ, κ′ and the speed of plane segments as a program, which runs over doubles, balls and integers."""

from __future__ import annotations

from functools import cache

from exactspline.formulas.lifted import PLANE_FORMS
from exactspline.language.kinds import PLANE
from exactspline.programs.program import Program, program_of_all
from exactspline.programs.reading import Signature

#: The outputs of the program.
CURVATURE, CRITICAL, SPEED = range(3)


def _signature(degree: int, rational: bool) -> Signature:
    """The signature of the program for segments of width 1 over common denominators, at their true degrees."""
    count = 3 if rational else 2
    return Signature(PLANE, 2, not rational, (degree,) * count, (0,) * count, unit_widths=True, true_degree=True)


@cache
def plane_program(degree: int, rational: bool) -> Program:
    """The program of one degree: κ, κ′ and ‖γ′‖² up to positive factors."""
    return program_of_all(PLANE_FORMS, _signature(degree, rational))
