"""The certified filter for one curve, in the optional C extension (filter.c): it runs a program on every segment of a
curve in doubles with error masses, and finds the certain zeros of the outputs (for two curves:
`exactspline.programs.certain_pairs`). Without the extension, or if its result is not certain, exact arithmetic decides,
with the same answers. Derivation: docs/certified-filter.md.

>>> filter_curve is None or callable(filter_curve)
True
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Sequence
from ctypes import POINTER, Structure, byref, c_double, c_int, c_void_p
from functools import cache, lru_cache
from math import nan
from typing import NamedTuple

from exactspline.errors import FormulaError
from exactspline.numbers.exact import mpq
from exactspline.numbers.extension import loaded
from exactspline.programs.error_bounds import factors, known_of
from exactspline.programs.instructions import UNIT, ZERO
from exactspline.programs.program import Program
from exactspline.splines.evaluation import Forms

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
OF_SEGMENT, OF_ZERO = 3, 4
#: With more zeros than these, and this many for each segment, exact arithmetic decides.
FEW, EACH = 30, 8
#: What C says of a segment: a zero is uncertain; it is uncertain that the last output has no zeros and that the weight
#: function is positive; zeros of the first output and of another overlap. And of the knot at its start, or of the seam:
#: the first output changes its sign; the second does; the curvatures of both sides certainly differ.
UNCERTAIN, SLOW, ENTANGLED, BENDS, TURNS, DIFFERENT = 1, 2, 4, 8, 16, 32


class _Instruction(Structure):
    _fields_ = [(x, c_int) for x in ("name", "a", "b", "degree")] + [(x, c_double) for x in ("m", "n")]


class _Program(Structure):
    _fields_ = [
        *((x, c_int) for x in ("length", "outputs", "operands", "degree", "rational")),
        ("code", POINTER(_Instruction)),
        ("output", POINTER(c_int)),
        ("factors", POINTER(c_double)),
    ]


def surrounds(low: float, high: float, x: float) -> bool:
    """Whether an interval around a number is narrow.

    >>> surrounds(0.1, 0.3, 0.2)
    False
    """
    return low < x < high < low + NARROW


#: The order of the outputs of a program with known results.
ORDER = [*range(1, len(KNOWN)), 0]


@cache
def _known_program() -> _Program:
    code = (_Instruction * len(KNOWN))(*[_Instruction(NAMES[name], *rest) for name, *rest, _ in KNOWN])
    count, bounds = len(KNOWN), [2**-48, 2**-1000] * len(KNOWN)
    return _Program(count, count, 1, 2, 0, code, (c_int * count)(*ORDER), (c_double * (2 * count))(*bounds))


def _rounds(function: Callable[..., int]) -> bool:
    """Whether the double nearest to the zero of 3∂u − ∂v of the form u² + 2uv + 4v² is found."""
    zero = 4 * (len(KNOWN) - 2), 0, 2 / 3 - 2**-42, 2 / 3 + 2**-40
    given = [array("d", numbers) for numbers in ((1, 2, 4), (), zero, (0, 1), (0, 0), (0,))]
    addresses = [x.buffer_info()[0] for x in given]
    return function(byref(_known_program()), *addresses, 1, 1) == 1 and given[-1][0] == 2 / 3


def _carries_out(function: Callable[..., int]) -> bool:
    """Whether each instruction gives exactly the right ordinates at both ends for the form u² + 2uv + 4v² divided by 8,
    and the zero of 3∂u − ∂v of this form is found.
    """
    count = len(ORDER)
    data, found = array("d", [1, 2, 4, 1]), array("d", bytes(8 * (OF_SEGMENT + 5 * count + OF_ZERO)))
    if function(byref(_known_program()), data.buffer_info()[0], 1, found.buffer_info()[0], 1) != 1:
        return False
    code, segment, low, high = found[-OF_ZERO:]
    ends = list(zip(found[count + 1 : 5 * count : 4], found[count + 3 : 5 * count : 4], strict=True))
    return (
        ends == [KNOWN[k][-1] for k in ORDER]
        and (code, segment, *found[:count]) == (4 * (count - 2) + 3, 0, UNCERTAIN, *[0] * (count - 2), 1)
        and surrounds(low, high, 2 / 3)
    )


#: The function of the extension for one curve; None without the extension.
filter_curve = loaded("filter_curve", _carries_out, c_void_p, c_void_p, c_int, c_void_p, c_int)
#: The function for the doubles nearest to its zeros; None without the extension.
filter_doubles = loaded("filter_doubles", _rounds, *[c_void_p] * 7, c_int, c_int)


#: A simple zero of an output inside a segment: its segment; where it is there, from 1 to 2; its number among all zeros;
#: 2 where the output is positive before it, plus 1 where the first output, if it is another one, is positive there.
SegmentZero = tuple[int, float, int, int]


class Signs(NamedTuple):
    """The results for the outputs of a program on the segments of a curve, in an array, as filter.c writes them."""

    numbers: array[float]
    outputs: int
    #: Where the zeros begin.
    start: int

    @property
    def flags(self) -> int:
        """What is said of any segment."""
        return int(self.numbers[0])

    @property
    def of_segments(self) -> list[int]:
        """What is said of each segment."""
        return [*map(int, self.numbers[self.outputs : self.start : OF_SEGMENT + 4 * self.outputs])]

    def count(self, output: int) -> int:
        """The number of zeros of an output."""
        return int(self.numbers[1 + output])

    def positive(self, output: int, segment: int) -> bool:
        """Whether an output is positive at the start of a segment."""
        return self.numbers[self.outputs + segment * (OF_SEGMENT + 4 * self.outputs) + 1 + 4 * output] > 0

    def zeros(self, output: int) -> list[SegmentZero]:
        """The zeros of an output in the order of segments and parameters."""
        numbers = zip(*[self.numbers[self.start + k :: OF_ZERO] for k in range(OF_ZERO - 1)], strict=True)
        zeros = enumerate(numbers)
        return [(int(i), 1 + low, k, int(code) % 4) for k, (code, i, low) in zeros if code // 4 == output]

    def some(self, first: int, count: int) -> array[float]:
        """The numbers of at most this many zeros, from this one on."""
        return self.numbers[self.start + OF_ZERO * first : self.start + OF_ZERO * (first + count)]


@lru_cache(256)
def _in_c(program: Program) -> _Program | None:
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
        not program.signature.polynomial,
        code,
        (c_int * count)(*[place[i] for i in program.outputs]),
        (c_double * (2 * count))(*bounds),
    )


def signs(program: Program, forms: Forms | None, segments: int) -> Signs | None:
    """The certain signs of the outputs of a program (the last of which must have no zero) on segments, given by their
    `Forms`, which are overwritten; the last operand of a rational curve is the weight function. None without the
    extension, and for numbers that are too large for it.
    """
    prepared = _in_c(program) if filter_curve is not None else None
    if prepared is None or filter_curve is None or forms is None:
        return None
    outputs = prepared.outputs
    start, room = outputs + (OF_SEGMENT + 4 * outputs) * segments, FEW + EACH * segments
    found = array("d", [0]) * (start + OF_ZERO * room)
    count = filter_curve(byref(prepared), forms[0].buffer_info()[0], segments, found.buffer_info()[0], room)
    del found[start + OF_ZERO * max(count, 0) :]
    return None if count < 0 else Signs(found, outputs, start)


def nearest(program: Program, forms: Forms | None, zeros: array[float], ends: Sequence[mpq]) -> Sequence[float]:
    """The doubles nearest to the parameters of some zeros, given by their numbers as in `Signs`, on the segments from
    that of the first zero to that of the last one, with these ends; not a number for what is not certain.
    """
    prepared, found = _in_c(program), array("d", [nan]) * (len(zeros) // OF_ZERO)
    try:
        places = array("d", map(float, ends))
        off = array("d", [float(x - mpq(y)) for x, y in zip(ends, places, strict=True)])
    except OverflowError:
        return found
    if filter_doubles is not None and prepared is not None and forms is not None:
        addresses = [x.buffer_info()[0] for x in (*forms, zeros, places, off, found)]
        filter_doubles(byref(prepared), *addresses, len(ends) - 1, len(found))
    return found
