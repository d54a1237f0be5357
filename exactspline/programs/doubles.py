"""A program in doubles, for thousands of segments together, with a proved bound on the rounding error of each number.

Every number has a *mass*: the value of the same program with every operand replaced by its absolute value and every
difference by a sum. A number that has gone through at most K roundings differs from the exact one by at most ``K ·
ROUNDING`` masses, plus the loss by underflow. Derivation: docs/certified-filter.md.

This is the only module of `programs` that loads numpy.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb

import numpy as np

from exactspline.polynomials.doubles import Bounded, Floats
from exactspline.programs.error_bounds import Known, factors, known_of
from exactspline.programs.instructions import UNIT, ZERO, Instruction
from exactspline.programs.program import Program


def in_doubles(program: Program, operands: Sequence[Floats], roundings: int) -> list[Bounded]:
    """The outputs of a program on many segments of width 1, from the scaled coefficients of its operands, one row per
    segment; each was rounded this many times, and no Bézier ordinate is larger than 1.

    Raises `FormulaError` if numbers could exceed the range of doubles, and for programs with multipliers.
    """
    listed = program.instructions.listed
    used, known = known_of(program, roundings)
    rows = len(operands[0])
    values: dict[int, Floats] = {UNIT: np.ones((rows, 1))}
    masses: dict[int, Floats] = {UNIT: values[UNIT]}
    last = {a: i for i in used for a in listed[i].arguments}
    with np.errstate(all="ignore"):
        for i in used:
            instruction = listed[i]
            if instruction.name == "load":
                values[i] = operands[instruction.numbers[0]]
                masses[i] = np.abs(values[i])
                continue
            values[i] = _carried_out(instruction, values, absolute=False)
            masses[i] = _carried_out(instruction, masses, absolute=True)
            for a in set(instruction.arguments):
                if a != UNIT and last[a] == i and a not in program.outputs:
                    del values[a], masses[a]
        return [
            bounded_by(values[i], masses[i], known[i])
            if i != ZERO
            else Bounded(np.zeros((rows, 1)), np.zeros((rows, 1)))
            for i in program.outputs
        ]


def bounded_by(values: Floats, masses: Floats, known: Known) -> Bounded:
    """Computed values with the bounds of their errors."""
    relative, lost = factors(known)
    return Bounded(values, masses * relative + lost)


def _carried_out(instruction: Instruction, known: dict[int, Floats], *, absolute: bool) -> Floats:
    """One instruction on the coefficients of all segments; `absolute` for masses, which grow with every term."""
    name, arguments, numbers = instruction
    a = known[arguments[0]]
    n = a.shape[1] - 1
    if name == "mul":
        return _convolved(a, known[arguments[1]])
    if name == "sum":
        m, k = map(abs, numbers) if absolute else numbers
        b = known[arguments[1]]
        first, second = a if m == 1 else m * a, b if abs(k) == 1 else abs(k) * b
        return first + second if k > 0 else first - second
    if name == "raise":
        e = numbers[0]
        return _convolved(np.array([[float(comb(e, j)) for j in range(e + 1)]]), a)
    if name == "scale":
        return (abs(numbers[0]) if absolute else numbers[0]) * a
    if name == "over_u":  # the last coefficient is zero before it is rounded
        return a[:, :-1]
    up, down = np.arange(1.0, n + 1), np.arange(float(n), 0, -1)
    if name == "dv":
        return up * a[:, 1:]
    if name == "du":
        return down * a[:, :-1]
    return up * a[:, 1:] + down * a[:, :-1] if absolute else up * a[:, 1:] - down * a[:, :-1]


def _convolved(a: Floats, b: Floats) -> Floats:
    """The products of the rows of two lists of polynomials, the shorter polynomial term by term."""
    if a.shape[1] > b.shape[1]:
        a, b = b, a
    product = np.zeros((max(len(a), len(b)), a.shape[1] + b.shape[1] - 1))
    for j in range(a.shape[1]):
        product[:, j : j + b.shape[1]] += a[:, j : j + 1] * b
    return product
