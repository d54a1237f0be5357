"""The optional C extension (filter.c): it runs a program on every segment of a curve in doubles with error masses, and
finds the zeros of the outputs that are certain (for two curves: `exactspline.programs.certain_pairs`). Without it, or
where it says that something is not certain, exact arithmetic decides: the answers are the same. Derivation:
docs/certified-filter.md.

>>> filter_curve is None or callable(filter_curve)
True
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import CDLL, POINTER, Structure, byref, c_double, c_int, c_void_p
from functools import lru_cache
from os import environ
from pathlib import Path
from typing import NamedTuple

from exactspline.errors import FormulaError
from exactspline.programs.instructions import UNIT, ZERO
from exactspline.programs.masses import factors, known_of
from exactspline.programs.program import Program

#: The compiled extension, which is not a module of Python: beside this file, absent where there was no compiler; or
#: the file that this environment variable names ("none": run without it).
LIBRARY = environ.get("EXACTSPLINE_EXTENSION") or str(Path(__file__).with_name("filter.lib"))
#: The roundings of an operand: numerator, denominator (twice, for it is divided by), quotient.
ROUNDINGS = 4
#: The numbers of the instructions in C.
NAMES = {name: k for k, name in enumerate(("load", "mul", "sum", "raise", "derive", "du", "dv", "over_u", "scale"))}
#: The numbers that are returned for a segment beside four for every output, and for a zero.
OF_SEGMENT, OF_ZERO = 3, 5
#: With more zeros than this per segment, exact arithmetic decides.
FEW = 8
#: What the C function says of a segment: two bits.
OPEN = ((False, False), (True, False), (False, True), (True, True))


class _Instruction(Structure):
    _fields_ = [(x, c_int) for x in ("name", "a", "b", "degree")] + [(x, c_double) for x in ("m", "n")]


class _Program(Structure):
    _fields_ = [
        *((x, c_int) for x in ("length", "outputs", "operands", "degree", "rational")),
        ("code", POINTER(_Instruction)),
        ("output", POINTER(c_int)),
        ("factors", POINTER(c_double)),
    ]


def loaded(name: str, *arguments: type) -> Callable[..., int] | None:
    """A function of the extension; None where there is none."""
    try:
        function = getattr(CDLL(LIBRARY), name)
    except (OSError, AttributeError):
        return None
    function.argtypes, function.restype = list(arguments), c_int
    made: Callable[..., int] = function
    return made


#: The function of the extension for one curve, None where there is none.
filter_curve = loaded("filter_curve", c_void_p, c_void_p, c_int, c_void_p, c_int)


class SegmentZero(NamedTuple):
    """A simple zero of an output inside a segment: the only one in an interval of its local parameter, and the sign
    before it.
    """

    output: int
    segment: int
    low: float
    high: float
    before: int


class Signs(NamedTuple):
    """What is known of the outputs of a program on the segments of a curve: whether the zeros of an output are not
    certain, and whether it is not certain that the last output has none and the weight function is positive; of every
    output its ordinates at both ends, each followed by a bound of its error; the weight function at both ends; the
    zeros.
    """

    open: list[tuple[bool, bool]]
    ends: list[list[float]]
    weights: list[list[float]]
    zeros: list[SegmentZero]


@lru_cache(256)
def _in_c(program: Program, rational: bool) -> _Program | None:
    """A program for C; None where it cannot run there."""
    try:
        used, known = known_of(program, ROUNDINGS)
    except FormulaError:
        return None
    listed, degrees = program.instructions.listed, program.instructions.degrees
    if ZERO in program.outputs:
        return None
    place = {i: k for k, i in enumerate(used)} | {UNIT: UNIT}
    code = (_Instruction * len(used))()
    for k, i in enumerate(used):
        name, arguments, numbers = listed[i]
        a, b = ([*(place[x] for x in arguments), 0, 0])[:2] if name != "load" else (numbers[0], 0)
        m, n = ([*numbers, 0, 0])[:2]
        code[k] = _Instruction(NAMES[name], a, b, degrees[i], m, n)
    bounds = [x for i in program.outputs for x in factors(known[i])]
    count = len(program.outputs)
    return _Program(
        len(used),
        count,
        len(program.signature.degrees),
        program.signature.degrees[0],
        rational,
        code,
        (c_int * count)(*[place[i] for i in program.outputs]),
        (c_double * (2 * count))(*bounds),
    )


def signs(program: Program, rows: Sequence[tuple[Sequence[Sequence[int]], int]], *, rational: bool) -> Signs | None:
    """What is certain of the outputs of a program (the last of which must have no zero) on segments, each given by the
    integers of its operands and their denominator; where it is rational, the last operand is a weight function. None
    without the extension, and where the numbers are too large for it.
    """
    prepared = _in_c(program, rational) if filter_curve is not None else None
    if prepared is None or filter_curve is None:
        return None
    segments = len(rows)
    columns = zip(*[parts for parts, _ in rows], strict=True)
    numbers = [x for column in columns for row in column for x in row]
    try:
        data = array("d", numbers + [below for _, below in rows])
    except OverflowError:
        return None
    outputs = prepared.outputs
    stride = OF_SEGMENT + 4 * outputs
    start, room = stride * segments, FEW * segments
    found = array("d", bytes(8 * (start + OF_ZERO * room)))
    count = filter_curve(byref(prepared), data.buffer_info()[0], segments, found.buffer_info()[0], room)
    if count < 0:
        return None
    values = found[: start + OF_ZERO * count].tolist()
    made = [values[s : s + stride] for s in range(0, start, stride)]
    zeros = [
        SegmentZero(int(k), int(s), low, high, int(before))
        for k, s, low, high, before in zip(*[values[start + i :: OF_ZERO] for i in range(OF_ZERO)], strict=True)
    ]
    return Signs([OPEN[int(row[0])] for row in made], [row[1:-2] for row in made], [row[-2:] for row in made], zeros)
