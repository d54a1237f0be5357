"""The forms of κ and κ′ of many segments in doubles: the certified zeros, and the segments that must be decided in
exact arithmetic. This module loads numpy.

Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from exactspline.errors import FormulaError
from exactspline.geometry.curves.plane_programs import plane_program
from exactspline.polynomials.doubles import (
    Bounded,
    Flags,
    Floats,
    Isolated,
    isolated,
    narrowed,
    ordinates,
    without_zeros,
)
from exactspline.programs.doubles import in_doubles

#: The number of segments that are computed together, so that their numbers fit into the cache.
AT_ONCE = 4096


class Form(NamedTuple):
    """A form on many segments: its ordinates, and its zeros on the segments where they are certified."""

    rows: Bounded
    zeros: Isolated


class _Filtered(NamedTuple):
    """κ and κ′ up to positive factors on many segments, and ‖γ′‖²; the segments that are not certified: on the `open`
    ones a sign that decides a zero is uncertain, on the `slow` ones it is uncertain that γ′ has no zero and all weights
    are positive.
    """

    curvature: Form
    critical: Form
    speed: Bounded
    open: Flags
    slow: Flags


def filtered(degree: int, operands: list[Floats]) -> _Filtered | None:
    """The certified results for segments of one degree, from the scaled coefficients of their components and, for
    rational segments, of their weight functions, rounded at most twice; no Bézier ordinate is larger than 1. None where
    the forms exceed the range of doubles.

    >>> done = filtered(3, [np.array([[0.0, 1, 2, 1]]) / 4, np.array([[0.0, 3, -3, 1]]) / 4])
    >>> done.curvature.zeros.row.tolist(), done.open.tolist()
    ([0], [False])
    """
    slow, undecided = np.zeros((2, len(operands[0])), dtype=bool)
    if len(operands) == 3:
        slow |= ~(operands[2] > 0).all(axis=1)
    try:
        forms = in_doubles(plane_program(degree, len(operands) == 3), operands, roundings=2)
    except FormulaError:
        return None
    *rows, speed = (ordinates(*form) for form in forms)
    slow |= ~without_zeros(speed)
    solved = [_solved(form, undecided) for form in rows]
    left = undecided | slow
    curvature, critical = (Form(rows, narrowed(rows, zeros.where(~left[zeros.row]))) for rows, zeros in solved)
    return _Filtered(curvature, critical, speed, undecided, slow)


def _solved(rows: Bounded, undecided: Flags) -> Form:
    """The zeros of a form; segments on which they are not certified are added to the undecided ones."""
    zeros, open_ = isolated(rows)
    undecided |= open_
    return Form(rows, zeros)
