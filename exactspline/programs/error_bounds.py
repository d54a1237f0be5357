"""Bounds for a program that runs in doubles, known in advance: the number of roundings of each number, its largest
possible mass, and the largest loss by underflow. Derivation: docs/certified-filter.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

from exactspline.errors import FormulaError
from exactspline.polynomials.roundings import ROUNDING, UNDERFLOW
from exactspline.programs.instructions import UNIT, Instruction, needed
from exactspline.programs.program import Program

#: A factor that covers the rounding of the bounds themselves and the quadratic terms of (1 + ROUNDING)^K, for K below
#: 2^40.
SLACK = 17 / 16
#: The largest number of bits of a number or a loss (in units of `UNDERFLOW`) in a program for doubles.
RANGE = 400


@dataclass(frozen=True)
class Known:
    """The bounds for an instruction: its number of roundings and, for operands of at most 1 in the Bernstein basis,
    bounds on its mass and on its loss by underflow.
    """

    roundings: int
    mass: int
    lost: int


def _operands_known(degree: int, roundings: int) -> Known:
    """An operand of at most 1, whose coefficients in the scaled basis were rounded this many times."""
    largest = comb(degree, degree // 2)
    return Known(roundings, largest, 4 * largest)


def _foreseen(listed: Sequence[Instruction], degrees: Sequence[int], operands: Sequence[Known]) -> list[Known]:
    """The bounds for every instruction.

    >>> load = [Instruction("load", (), (0,)), Instruction("load", (), (1,)), Instruction("mul", (0, 1))]
    >>> _foreseen(load, [1, 2, 3], [_operands_known(1, 2), _operands_known(2, 2)])[2].roundings
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


def known_of(program: Program, roundings: int) -> tuple[list[int], list[Known]]:
    """The instructions on which the outputs of a program depend, in order, and the bounds for all instructions, for
    operands that were rounded this many times.

    Raises `FormulaError` if numbers could exceed the range of doubles, and for programs with multipliers.
    """
    listed, degrees = program.instructions.listed, program.instructions.degrees
    known = _foreseen(listed, degrees, [_operands_known(degree, roundings) for degree in program.signature.degrees])
    used = sorted(needed(listed, program.outputs))
    if any(max(known[i].mass, known[i].lost).bit_length() > RANGE for i in used):
        raise FormulaError("a program whose numbers exceed the range of doubles", remedy="use exact arithmetic")
    return used, known


def factors(known: Known) -> tuple[float, float]:
    """Two numbers: the error of a number is at most the first one times its mass, plus the second one."""
    return SLACK * known.roundings * ROUNDING, SLACK * float(known.lost) * UNDERFLOW
