"""Instructions compiled to a Python function that runs over all segments or patches on bare polynomials."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from flint import fmpz, fmpz_poly

from exactspline.polynomials.bernstein import U_PLUS_V, raiser
from exactspline.programs.denominators import Denominator
from exactspline.programs.instructions import UNIT, ZERO, Instruction

#: A multiplier of a segment: the quotient of two denominators, or a power of the denominator of its width.
Multiplier = tuple[Denominator, Denominator] | int
#: A function that takes the given polynomials, their denominators group by group, and the widths (numerator,
#: denominator) of the segments, and returns the polynomials and the denominators of every output, segment by segment.
Run = Callable[
    [Sequence[Sequence[fmpz_poly]], Sequence[Sequence[fmpz]], Sequence[tuple[fmpz, fmpz]]],
    list[tuple[fmpz_poly | fmpz, ...]],
]


class Output(NamedTuple):
    """A result of a program: the instruction that computes its polynomial, and its denominator."""

    instruction: int
    below: Denominator


def compiled(
    listed: Sequence[Instruction],
    outputs: Sequence[Output],
    given: Sequence[int | None],
    groups: Sequence[int],
    multipliers: Sequence[Multiplier],
) -> Run:
    """The function of a program: for every segment it returns the polynomials of the outputs, then their denominators.

    `given` are the instructions whose polynomials are its arguments, None for one that is not used.

    >>> from exactspline.programs.denominators import OfOperand
    >>> load = [Instruction("load", (), (0,)), Instruction("load", (), (1,))]
    >>> below = Denominator.of(OfOperand(0))
    >>> run = compiled([*load, Instruction("mul", (0, 1))], [Output(2, below * below)], [0, 1], [0], [])
    >>> run([[fmpz_poly([1, 1])], [fmpz_poly([2, 3])]], [[fmpz(5)]], [(fmpz(1), fmpz(1))])
    [(3*x^2 + 5*x + 2, 25)]
    """
    constants: dict[str, Any] = {"one": fmpz_poly([1]), "nothing": fmpz_poly([]), "u_plus_v": U_PLUS_V, "fmpz": fmpz}
    used = needed(listed, [one.instruction for one in outputs], given)
    own = [i for i in sorted(used) if i not in given]
    lifts = dict.fromkeys(listed[i].numbers[0] for i in own if listed[i].name == "lift")
    lines = [f"m{k} = {_multiplier(multipliers[k])}" for k in lifts]
    lines += [f"t{i} = {_text(listed[i], constants)}" for i in own]
    names = [f"t{i}" if i in used else f"unused{k}" for k, i in enumerate(given)]
    names += [f"below{group}" for group in groups]
    below = {}
    for k, denominator in enumerate(dict.fromkeys(one.below for one in outputs)):
        below[denominator] = f"d{k}"
        lines.append(f"d{k} = {denominator.text}")
    values = [_name(i) if i != ZERO else "nothing" for i, _ in outputs] + [below[d] for _, d in outputs]
    defaults = ", ".join(f"{name}={name}" for name in constants)
    source = "\n".join(
        [
            f"def run(given, denominators, widths, {defaults}):",
            "    found = []",
            f"    for {', '.join(names)}, (top, bottom) in zip(*given, *denominators, widths):",
            *[f"        {line}" for line in lines],
            f"        found.append(({', '.join(values)},))",
            "    return found",
        ]
    )
    exec(compile(source, "<straight-line program>", "exec"), constants)
    run: Run = constants["run"]
    return run


def _multiplier(multiplier: Multiplier) -> str:
    """A multiplier as Python code."""
    if isinstance(multiplier, int):
        return f"bottom ** {multiplier}"
    whole, part = multiplier
    return f"({whole.text}) // ({part.text})"


def needed(listed: Sequence[Instruction], outputs: Sequence[int], given: Sequence[int | None] = ()) -> set[int]:
    """The instructions on which the outputs depend, except those that are given."""
    used = {i for i in outputs if i >= 0}
    for i in range(len(listed) - 1, -1, -1):
        if i in used and i not in given:
            used.update(a for a in listed[i].arguments if a >= 0)
    return used


def _name(a: int) -> str:
    return "one" if a == UNIT else f"t{a}"


def _text(instruction: Instruction, constants: dict[str, Any]) -> str:
    """One operation as Python code; integers are created once and bound to names."""
    name, arguments, numbers = instruction
    a = _name(arguments[0])
    if name == "mul":
        return f"{a} * {_name(arguments[1])}"
    if name == "sum":
        (m, n), b = numbers, _name(arguments[1])
        if m < 0 < n:
            return f"{_multiple(b, n, constants)} - {_multiple(a, -m, constants)}"
        return f"{_multiple(a, m, constants)} {'+' if n > 0 else '-'} {_multiple(b, abs(n), constants)}"
    if name == "raise":
        return f"{a} * {_bound('r', numbers[0], constants, raiser(numbers[0]))}"
    if name == "derive":
        return f"{a}.derivative() * u_plus_v - {_multiple(a, numbers[0], constants)}"
    if name == "du":
        return f"{_multiple(a, numbers[0], constants)} - {a}.derivative().left_shift(1)"
    if name == "dv":
        return f"{a}.derivative()"
    if name == "over_u":
        return a
    return _multiple(a, numbers[0], constants) if name == "scale" else f"{a} * m{numbers[0]}"


def _multiple(a: str, m: int, constants: dict[str, Any]) -> str:
    if m in (1, -1):
        return a if m == 1 else f"-{a}"
    return f"{_bound('n' if m > 0 else 'minus', abs(m), constants, fmpz(m))} * {a}"


def _bound(letter: str, number: int, constants: dict[str, Any], value: Any) -> str:
    name = f"{letter}{number}"
    constants[name] = value
    return name
