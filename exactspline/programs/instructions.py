"""The instructions of a straight-line program: operations on integer polynomials, each recorded once.

A polynomial is a form of a segment in the scaled Bernstein basis (see `exactspline.polynomials.bernstein`), so that the
product is a convolution and raising the degree is multiplication by ``u + v``. Every instruction is linear in each of
its arguments.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, cast

from flint import fmpz, fmpz_poly

from exactspline.polynomials.bernstein import U_PLUS_V, raiser
from exactspline.programs.denominators import Denominator

#: The constant polynomial 1 in place of an argument, and zero in place of an output.
UNIT, ZERO = -1, -2


class Instruction(NamedTuple):
    """One operation, its arguments (numbers of earlier instructions), and its integers.

    ======== ============ ===================================================
    load     (k)          operand k
    mul      a b          a·b
    sum      a b (m, n)   m·a + n·b
    raise    a (e)        a·(u + v)ᵉ
    derive   a (n)        (∂v − ∂u)a of degree n
    du, dv   a (n)        ∂u a, ∂v a of degree n
    over_u   a (n)        a/u of degree n, a multiple of u
    scale    a (m)        m·a
    lift     a (k)        a times the k-th multiplier of the segment
    spread   a (i)        a, of the i-th parameter alone, on every patch
    ======== ============ ===================================================

    Only products, sums and multiples of spread polynomials are formed.
    """

    name: str
    arguments: tuple[int, ...] = ()
    numbers: tuple[int, ...] = ()


class Instructions:
    """The instructions of a program under construction: an operation on the same arguments is recorded once.

    >>> code = Instructions()
    >>> x, y = code.load(0, 2), code.load(1, 2)
    >>> code.times(x, y) == code.times(y, x), code.degrees[code.times(x, y)], len(code.listed)
    (True, 4, 3)
    """

    def __init__(self) -> None:
        self.listed: list[Instruction] = []
        #: The formal degree of the result of each instruction.
        self.degrees: list[int] = []
        self._known: dict[Instruction, int] = {}
        #: The factors of products, nested products flattened.
        self._factors: dict[int, Counter[int]] = {}

    def _put(self, instruction: Instruction, degree: int) -> int:
        if instruction not in self._known:
            self._known[instruction] = len(self.listed)
            self.listed.append(instruction)
            self.degrees.append(degree)
        return self._known[instruction]

    def degree(self, a: int) -> int:
        """The formal degree of an argument."""
        return 0 if a == UNIT else self.degrees[a]

    def load(self, k: int, degree: int) -> int:
        """An operand."""
        return self._put(Instruction("load", (), (k,)), degree)

    def times(self, a: int, b: int) -> int:
        """The product."""
        if UNIT in (a, b):
            return max(a, b)
        made = self._put(Instruction("mul", (min(a, b), max(a, b))), self.degrees[a] + self.degrees[b])
        self._factors[made] = self._taken_apart(a) + self._taken_apart(b)
        return made

    def _taken_apart(self, a: int) -> Counter[int]:
        return self._factors.get(a, Counter([a]))

    def same(self, a: int, b: int) -> bool:
        """Whether two arguments are products of the same factors.

        >>> code = Instructions()
        >>> x, y, z = (code.load(k, 1) for k in range(3))
        >>> code.same(code.times(code.times(x, y), z), code.times(x, code.times(z, y)))
        True
        """
        return a == b or self._taken_apart(a) == self._taken_apart(b)

    def _product(self, factors: Counter[int]) -> int:
        made = UNIT
        for a in sorted(factors.elements()):
            made = self.times(made, a)
        return made

    def sum(self, a: int, m: int, b: int, n: int) -> int:
        """``m a + n b`` of two different arguments of the same degree, a common factor factored out."""
        common = self._taken_apart(a) & self._taken_apart(b)
        if common:
            first, second = (self._product(self._taken_apart(x) - common) for x in (a, b))
            return self.times(self.sum(first, m, second, n), self._product(common))
        if a > b:
            a, m, b, n = b, n, a, m
        return self._put(Instruction("sum", (a, b), (m, n)), self.degree(a))

    def raised(self, a: int, e: int) -> int:
        """The argument with the degree raised."""
        return a if e == 0 else self._put(Instruction("raise", (a,), (e,)), self.degree(a) + e)

    def derived(self, name: str, a: int) -> int:
        """A derivative of an argument of positive degree, or its quotient by u; the operation is given by its name."""
        n = self.degree(a)
        return self._put(Instruction(name, (a,), (n,)), n - 1)

    def scaled(self, a: int, m: int) -> int:
        """A multiple."""
        return a if m == 1 else self._put(Instruction("scale", (a,), (m,)), self.degree(a))

    def spread(self, a: int, parameter: int) -> int:
        """A polynomial in one parameter, on every patch."""
        return self._put(Instruction("spread", (a,), (parameter,)), 0)

    def lifted(self, a: int, k: int) -> int:
        """The argument times a multiplier of the segment."""
        return self._put(Instruction("lift", (a,), (k,)), self.degree(a))


# ---- compiled


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

    `given` are the instructions whose polynomials are the arguments of the function, None for an unused argument.

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
    return cast(Run, constants["run"])


def _multiplier(multiplier: Multiplier) -> str:
    """A multiplier as Python code."""
    if isinstance(multiplier, int):
        return f"bottom ** {multiplier}"
    whole, part = multiplier
    return f"({whole.text}) // ({part.text})"


def needed(listed: Sequence[Instruction], outputs: Sequence[int], given: Sequence[int | None] = ()) -> set[int]:
    """The instructions on which the outputs depend, except the given instructions."""
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
