"""A program in doubles, for thousands of segments together, with a proved bound on the rounding error of each number.

Every number has a *mass*: the value of the same program with every operand replaced by its absolute value and every
difference by a sum. A number that has gone through at most K roundings differs from the exact one by at most ``K ·
ROUNDING`` masses, plus the loss by underflow. Derivation: docs/certified-filter.md.

This is the only module of `programs` that loads numpy.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

import numpy as np

from exactspline.errors import FormulaError
from exactspline.polynomials.doubles import ROUNDING, UNDERFLOW, Bounded, Floats
from exactspline.programs.compiled import needed
from exactspline.programs.instructions import UNIT, ZERO, Instruction
from exactspline.programs.program import Program

#: A factor that covers the rounding of the bounds themselves and the quadratic terms of (1 + ROUNDING)^K, for K below
#: 2^40.
SLACK = 1.0625
#: The largest number of bits of a number or a loss (in units of `UNDERFLOW`) in a program for doubles.
RANGE = 400


@dataclass(frozen=True)
class Known:
    """What is known about an instruction in advance: its number of roundings and, for operands of at most 1 in the
    Bernstein basis, bounds on its mass and on its loss by underflow.
    """

    roundings: int
    mass: int
    lost: int


def operands_known(degree: int, roundings: int) -> Known:
    """An operand of at most 1, whose coefficients in the scaled basis were rounded this many times."""
    largest = comb(degree, degree // 2)
    return Known(roundings, largest, 4 * largest)


def foreseen(listed: Sequence[Instruction], degrees: Sequence[int], operands: Sequence[Known]) -> list[Known]:
    """What is known about every instruction.

    >>> load = [Instruction("load", (), (0,)), Instruction("load", (), (1,)), Instruction("mul", (0, 1))]
    >>> foreseen(load, [1, 2, 3], [operands_known(1, 2), operands_known(2, 2)])[2].roundings
    6
    """
    known: list[Known] = []
    for i, (name, arguments, numbers) in enumerate(listed):
        if name == "load":
            known.append(operands[numbers[0]])
            continue
        if any(abs(number) >> 53 for number in numbers):
            raise FormulaError(f"the integer {max(map(abs, numbers))} in doubles", remedy="use exact arithmetic")
        first = Known(0, 1, 0) if arguments[0] == UNIT else known[arguments[0]]
        degree = 0 if arguments[0] == UNIT else degrees[arguments[0]]
        if name == "mul":
            second = known[arguments[1]]
            terms = min(degree, degrees[arguments[1]]) + 1
            mass = terms * first.mass * second.mass
            lost = terms * (first.lost * (second.mass + 1) + second.lost * (first.mass + 1) + 2)
            known.append(Known(first.roundings + second.roundings + terms, mass, 2 * lost))
        elif name == "sum":
            second = Known(0, 1, 0) if arguments[1] == UNIT else known[arguments[1]]
            m, n = map(abs, numbers)
            mass, lost = m * first.mass + n * second.mass, m * first.lost + n * second.lost + 3
            known.append(Known(max(first.roundings, second.roundings) + 2, mass, 2 * lost))
        elif name == "raise":
            terms = min(degree, numbers[0]) + 1
            factor = terms * comb(numbers[0], numbers[0] // 2)
            lost = factor * (first.lost + 2)
            known.append(Known(first.roundings + terms, factor * first.mass, 2 * lost))
        elif name in ("derive", "du", "dv", "scale"):
            factor = abs(numbers[0]) * (2 if name == "derive" else 1)
            known.append(Known(first.roundings + 2, factor * first.mass, 2 * (factor * first.lost + 3)))
        elif name == "over_u":
            known.append(first)
        else:
            raise FormulaError(
                f"instruction {i}, {name}, in doubles", remedy="segments of width 1 over common denominators"
            )
    return known


def in_doubles(program: Program, operands: Sequence[Floats], roundings: int) -> list[Bounded]:
    """The outputs of a program on many segments of width 1, from the scaled coefficients of its operands, one row per
    segment; each was rounded this many times, and no Bézier ordinate is larger than 1.

    Raises `FormulaError` where numbers could exceed the range of doubles, and for programs with multipliers.
    """
    listed, degrees = program.instructions.listed, program.instructions.degrees
    known = foreseen(listed, degrees, [operands_known(degree, roundings) for degree in program.signature.degrees])
    used = sorted(needed(listed, program.outputs))
    if any(max(known[i].mass, known[i].lost).bit_length() > RANGE for i in used):
        raise FormulaError("a program whose numbers exceed the range of doubles", remedy="use exact arithmetic")
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
    lost = SLACK * float(known.lost) * UNDERFLOW
    return Bounded(values, masses * (SLACK * known.roundings * ROUNDING) + lost)


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
