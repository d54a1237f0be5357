"""The forms of inflections and extrema of many segments in doubles, and where they vanish: what is certain of that, and
which segments are left to exact arithmetic. This module loads numpy.

Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from exactspline.errors import FormulaError
from exactspline.geometry.constructions import construction
from exactspline.language.formula import Formula
from exactspline.language.kinds import PLANE
from exactspline.papers import find
from exactspline.polynomials.doubles import Flags, Isolated, Rows, isolated, narrowed, ordinates, without_zeros
from exactspline.programs.doubles import Floats, in_doubles
from exactspline.programs.invariants import slope, turning
from exactspline.programs.program import Program, Signature, program_of
from exactspline.programs.wronskian import wronskian_of

#: How many segments are computed at once, so that their numbers fit into the cache.
AT_ONCE = 4096


class Form(NamedTuple):
    """A form on many segments: its ordinates, and its zeros on the segments on which they are certain."""

    rows: Rows
    zeros: Isolated


class Filtered(NamedTuple):
    """κ and κ′ up to positive factors on many segments, and the segments of which something is not certain: a sign that
    decides a zero, or that γ′ has none.
    """

    curvature: Form
    critical: Form
    open: Flags


class _Programs(NamedTuple):
    """The programs of one degree: κ, κ′ and ‖γ′‖² up to positive factors."""

    curvature: Program
    critical: Program
    speed: Program


def _signature(degree: int, rational: bool) -> Signature:
    """What programs of segments of width 1 over common denominators depend on."""
    count = 3 if rational else 2
    return Signature(PLANE, 2, not rational, (degree,) * count, (0,) * count, unit_widths=True)


@cache
def _programs(degree: int, rational: bool) -> _Programs:
    def made(formula: Formula) -> Program:
        return program_of(formula, _signature(degree, rational))

    inflections, critical = construction("zero_curvature"), construction("critical_curvature")
    if rational:
        first, second = (wronskian_of(find(each.wronskian_of)) for each in (inflections, critical))
        return _Programs(made(first), made(second), made(find("D1_squared")))
    return _Programs(made(inflections.formula("paper")), made(critical.formula("paper")), made(find("D1_squared")))


@cache
def programs_at_true_degree(degree: int, rational: bool) -> tuple[Program, Program]:
    """The programs of the forms of κ and κ′ without factors that vanish nowhere, which `analyse` solves."""
    return tuple([program_of(each, _signature(degree, rational)) for each in (turning, slope)])  # type: ignore[return-value]  # two


def filtered(degree: int, operands: list[Floats], *, narrow: bool = True) -> Filtered | None:
    """What is certain of segments of one degree, from the scaled coefficients of their components and, for rational
    ones, of their weight functions, that were rounded twice at most; no Bézier ordinate is larger than 1. The intervals
    of zeros are made narrow on request. None where doubles cannot hold the forms.

    >>> done = filtered(3, [np.array([[0.0, 1, 2, 1]]) / 4, np.array([[0.0, 3, -3, 1]]) / 4])
    >>> done.curvature.zeros.row.tolist(), done.open.tolist()
    ([0], [False])
    """
    programs = _programs(degree, len(operands) == 3)
    left = np.zeros(len(operands[0]), dtype=bool)
    if len(operands) == 3:
        left |= ~(operands[2] > 0).all(axis=1)
    try:
        left |= ~without_zeros(_rows(programs.speed, operands))
        solved = [_solved(program, operands, left) for program in (programs.curvature, programs.critical)]
    except FormulaError:
        return None
    curvature, critical = (Form(rows, zeros.where(~left[zeros.row])) for rows, zeros in solved)
    if narrow:
        curvature, critical = (Form(rows, narrowed(rows, zeros)) for rows, zeros in (curvature, critical))
    return Filtered(curvature, critical, left)


def _solved(program: Program, operands: list[Floats], left: Flags) -> Form:
    """The zeros of a form; segments on which they are not certain are added to those that are left."""
    rows = _rows(program, operands)
    zeros, open_ = isolated(rows)
    left |= open_
    return Form(rows, zeros)


def _rows(program: Program, operands: list[Floats]) -> Rows:
    """The ordinates of a form."""
    (form,) = in_doubles(program, operands, roundings=2)
    return ordinates(form.values, form.errors)
