"""The forms of κ, κ′ and the speed of plane segments as programs, which run over doubles, balls and integers."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from exactspline.formulas.lifted import PLANE_FORMS
from exactspline.language.kinds import PLANE
from exactspline.programs.program import Program, program_of
from exactspline.programs.reading import Signature


class Programs(NamedTuple):
    """The programs of one degree: κ, κ′ and ‖γ′‖² up to positive factors."""

    curvature: Program
    critical: Program
    speed: Program


def _signature(degree: int, rational: bool) -> Signature:
    """The signature of the programs for segments of width 1 over common denominators, at their true degrees."""
    count = 3 if rational else 2
    return Signature(PLANE, 2, not rational, (degree,) * count, (0,) * count, unit_widths=True, true_degree=True)


@cache
def programs(degree: int, rational: bool) -> Programs:
    """The programs of one degree."""
    signature = _signature(degree, rational)
    return Programs(*[program_of(form, signature) for form in PLANE_FORMS])
