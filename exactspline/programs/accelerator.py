"""The optional C extension (filter.c): it runs a program on every segment of a curve in doubles with error masses, and
finds the certain zeros of the outputs (for two curves: `exactspline.programs.certain_pairs`). Without the extension, or
if its result is not certain, exact arithmetic decides, with the same answers. A library that is not byte for byte the
one compiled from the source beside this file, or that computes an instruction differently, is not used. Derivation:
docs/certified-filter.md.

>>> filter_curve is None or callable(filter_curve)
True
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import CDLL, POINTER, Structure, byref, c_double, c_int, c_void_p
from functools import cache, lru_cache
from hashlib import sha256
from itertools import chain
from os import environ
from pathlib import Path
from typing import NamedTuple

from exactspline.errors import FormulaError
from exactspline.programs.error_bounds import factors, known_of
from exactspline.programs.instructions import UNIT, ZERO
from exactspline.programs.program import Program

#: The compiled extension, which is not a Python module: a file beside this one, absent if there was no compiler, or the
#: file that this environment variable names ("none": run without the extension).
LIBRARY = environ.get("EXACTSPLINE_EXTENSION") or str(Path(__file__).with_name("filter.lib"))
SOURCE = Path(__file__).with_name("filter.c")
#: The roundings of an operand: numerator, denominator (twice, for it is divided by), quotient.
ROUNDINGS = 4
#: The numbers of the instructions in C.
NAMES = {name: k for k, name in enumerate(("load", "mul", "sum", "raise", "derive", "du", "dv", "over_u", "scale"))}
#: The right results: for each instruction its name, arguments, degree and integers, and both ends of its result. The
#: last one has the zero 2/3.
KNOWN = (
    ("load", 0, 0, 2, 0, 0, (1 / 8, 1 / 2)),
    ("mul", 0, 0, 4, 0, 0, (1 / 64, 1 / 4)),
    ("sum", 0, 0, 2, 3, -1, (1 / 4, 1)),
    ("raise", 0, 0, 3, 1, 0, (1 / 8, 1 / 2)),
    ("derive", 0, 0, 1, 2, 0, (0, 3 / 4)),
    ("over_u", 0, 0, 1, 2, 0, (1 / 8, 1 / 4)),
    ("scale", 0, 0, 2, 5, 0, (5 / 8, 5 / 2)),
    ("du", 0, 0, 1, 2, 0, (1 / 4, 1 / 4)),
    ("dv", 0, 0, 1, 2, 0, (1 / 4, 1)),
    ("sum", 7, 8, 1, 3, -1, (1 / 2, -1 / 4)),
)
#: The largest width of the interval around a known zero.
NARROW = 2**-30
#: The numbers that are returned for a segment beside four for every output, and for a zero.
OF_SEGMENT, OF_ZERO = 3, 5
#: With more zeros than this per segment, exact arithmetic decides.
FEW = 8
#: The two bits that the C function returns for a segment.
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


@cache
def _library() -> CDLL | None:
    """The extension, if it is the one that was compiled from the source beside this file. A damaged library, or one
    compiled from other source, is not loaded: it could end this process, or give wrong answers.
    """
    try:
        contents = SOURCE.read_bytes() + Path(LIBRARY).read_bytes()
        known = Path(f"{LIBRARY}.sha256").read_bytes().decode("ascii").strip()
        return CDLL(LIBRARY) if known == sha256(contents).hexdigest() else None
    except (OSError, UnicodeDecodeError):
        return None


def loaded(name: str, right: Callable[[Callable[..., int]], bool], *arguments: type) -> Callable[..., int] | None:
    """A function of the extension, if its answer in a known case is `right`; None without the extension. Without types
    of its arguments it takes bytes and arrays of ctypes as they are, which is faster.
    """
    library = _library()
    if library is None:
        return None
    function = getattr(library, name)
    function.argtypes, function.restype = list(arguments) or None, c_int
    return function if right(function) else None


def surrounds(low: float, high: float, x: float) -> bool:
    """Whether an interval around a number is narrow.

    >>> surrounds(0.1, 0.3, 0.2)
    False
    """
    return low < x < high < low + NARROW


def _carries_out(function: Callable[..., int]) -> bool:
    """Whether each instruction gives exactly the right ordinates at both ends for the form u² + 2uv + 4v² divided by 8,
    and the zero of 3∂u − ∂v of this form is found.
    """
    code = (_Instruction * len(KNOWN))(*[_Instruction(NAMES[name], *rest) for name, *rest, _ in KNOWN])
    order, bounds = [*range(1, len(KNOWN)), 0], [2**-48, 2**-1000] * len(KNOWN)
    count = len(order)
    program = _Program(count, count, 1, 2, 0, code, (c_int * count)(*order), (c_double * (2 * count))(*bounds))
    data, found = array("d", [1, 2, 4, 1]), array("d", bytes(8 * (OF_SEGMENT + 4 * count + OF_ZERO)))
    if function(byref(program), data.buffer_info()[0], 1, found.buffer_info()[0], 1) != 1:
        return False
    output, segment, low, high, before = found[-OF_ZERO:]
    ends = list(zip(found[1 : 4 * count : 4], found[3 : 4 * count : 4], strict=True))
    return (
        ends == [KNOWN[k][-1] for k in order]
        and (output, segment, before) == (count - 2, 0, 1)
        and surrounds(low, high, 2 / 3)
    )


#: The function of the extension for one curve; None without the extension.
filter_curve = loaded("filter_curve", _carries_out, c_void_p, c_void_p, c_int, c_void_p, c_int)


class SegmentZero(NamedTuple):
    """A simple zero of an output inside a segment: an interval of the local parameter that contains it and no other
    zero, and the sign before it.
    """

    output: int
    segment: int
    low: float
    high: float
    before: int


class Signs(NamedTuple):
    """The results for the outputs of a program on the segments of a curve: whether the zeros of an output are
    uncertain; whether it is uncertain that the last output has no zeros and the weight function is positive; after one
    more number the ordinates of every output at both ends, each followed by a bound of its error, and the weight
    function at both ends; and the zeros.
    """

    open: list[tuple[bool, bool]]
    ends: list[array[float]]
    zeros: list[SegmentZero]


@lru_cache(256)
def _in_c(program: Program, rational: bool) -> _Program | None:
    """A program for C; None if it cannot run in C."""
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
    """The certain signs of the outputs of a program (the last of which must have no zero) on segments, each given by
    the integers of its operands and their denominator; if `rational`, the last operand is a weight function. None
    without the extension, and for numbers that are too large for it.
    """
    prepared = _in_c(program, rational) if filter_curve is not None else None
    if prepared is None or filter_curve is None:
        return None
    segments, data = len(rows), array("d")
    try:
        for k in range(prepared.operands):
            data.extend(chain.from_iterable(parts[k] for parts, _ in rows))
        data.extend(below for _, below in rows)
    except OverflowError:
        return None
    stride = OF_SEGMENT + 4 * prepared.outputs
    start, room = stride * segments, FEW * segments
    found = array("d", [0]) * (start + OF_ZERO * room)
    count = filter_curve(byref(prepared), data.buffer_info()[0], segments, found.buffer_info()[0], room)
    if count < 0:
        return None
    end = start + OF_ZERO * count
    zeros = [
        SegmentZero(int(k), int(s), low, high, int(before))
        for k, s, low, high, before in zip(*[found[start + i : end : OF_ZERO] for i in range(OF_ZERO)], strict=True)
    ]
    made = [found[s : s + stride] for s in range(0, start, stride)]
    return Signs([OPEN[int(x)] for x in found[:start:stride]], made, zeros)
