"""Programs of formulas: compiled once for a kind of argument, its degrees and its widths, and run on any such argument.

Terms that depend on one parameter are computed segment by segment; for two curves only the others are computed patch by
patch.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeVar

from flint import fmpz, fmpz_poly

from exactspline.errors import FormulaError
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.operand import Operand
from exactspline.language.provenance import within
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.once import cached_property
from exactspline.polynomials.tensor_bernstein import stride_for
from exactspline.programs.compiled import Output, Run, compiled, needed
from exactspline.programs.denominators import ONE
from exactspline.programs.inputs import Given, operands_of
from exactspline.programs.instructions import Instructions
from exactspline.programs.reading import ProgramReading, Signature
from exactspline.programs.term import Term
from exactspline.splines.bspline import BSpline, from_parts
from exactspline.splines.lowest_terms import SplineValue
from exactspline.splines.tensor import TensorSpline, make
from exactspline.splines.tensor_patches import Degrees, spread

T = TypeVar("T", bound=Operand)


def _terms_of(value: object, kind: type[T]) -> list[T]:
    """The terms of a value, or of each of several.

    Raises `FormulaError` for a value that formulas of programs do not return.
    """
    if isinstance(value, RuledSurface):
        return _terms_of(value.directrix, kind) + _terms_of(value.generator, kind)
    if isinstance(value, Rational):
        return [*_terms_of(value.numerator, kind), value.denominator]
    if isinstance(value, (Vector, tuple)):
        return [term for part in value for term in _terms_of(part, kind)]
    if isinstance(value, kind):
        return [value]
    raise FormulaError(
        f"a formula that returns a {type(value).__name__}", remedy="a scalar, a vector, a quotient or a ruled surface"
    )


def _rebuilt(value: object, splines: Iterator[Any]) -> Any:
    """The value with splines in the place of its terms."""
    if isinstance(value, RuledSurface):
        directrix = _rebuilt(value.directrix, splines)
        return RuledSurface(directrix, _rebuilt(value.generator, splines))
    if isinstance(value, Rational):
        numerator = _rebuilt(value.numerator, splines)
        return Rational(numerator, next(splines))
    if isinstance(value, Vector):
        return Vector(*[_rebuilt(part, splines) for part in value])
    if isinstance(value, tuple):
        return tuple(_rebuilt(part, splines) for part in value)
    return next(splines)


class Stage(NamedTuple):
    """The computation on the segments of one of two parameters: the function, its operands, those whose denominators it
    uses, and the instructions that transfer the results to the patches.
    """

    run: Run
    operands: tuple[int, ...]
    groups: tuple[int, ...]
    spread: tuple[int, ...]


class Program:
    """A formula as instructions, and how its value is assembled from them.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example
    >>> curve = example("rational_cubic")
    >>> program = program_for(find("f2"), curve)
    >>> program(curve).degree, program.count("mul")
    (6, 9)

    On two curves:

    >>> from exactspline.splines.tensor import surface_pair
    >>> pair = surface_pair(example("rational_space_cubic"), example("ellipse_in_space"))
    >>> chord = find("chen_riesenfeld_cohen_2007:chord")
    >>> program_for(chord, pair)(pair) == chord(pair)
    True
    """

    def __init__(self, value: object, reading: ProgramReading) -> None:
        self.signature = reading.signature
        self.instructions: Instructions = reading.recorder.instructions
        self.leaves = reading.leaves
        self.value = value
        self.terms = _terms_of(value, Term)
        self.outputs = [term.output() for term in self.terms]
        #: One operand of each group with the same denominators.
        self.groups = sorted(set(self.signature.groups))
        listed, self._multipliers = self.instructions.listed, reading.recorder.multipliers
        parameters = reading.recorder.all
        self._stages = [self._stage(reading, which) for which in range(len(parameters))] if len(parameters) > 1 else []
        loads = {one.numbers[0]: i for i, one in enumerate(listed) if one.name == "load"}
        given = [i for stage in self._stages for i in stage.spread]
        self._columns = given if self._stages else [loads.get(k) for k in range(len(self.leaves))]

    @cached_property
    def run(self) -> Run:
        """The function over all segments or patches, compiled when it is first needed."""
        outputs = [Output(i, term.below) for i, term in zip(self.outputs, self.terms, strict=True)]
        return compiled(self.instructions.listed, outputs, self._columns, self.groups, self._multipliers)

    def _stage(self, reading: ProgramReading, which: int) -> Stage:
        listed, own = self.instructions.listed, reading.recorder.all[which]
        used = sorted(needed(listed, self.outputs))
        spread = tuple([i for i in used if listed[i].name == "spread" and listed[i].numbers == (which,)])
        loads = [i for i in used if listed[i].name == "load"]
        loads = [i for i in loads if reading.recorder.parameters[listed[i].numbers[0]] == own]
        operands = tuple([listed[i].numbers[0] for i in loads])
        groups = tuple([k for k in self.groups if reading.recorder.parameters[k] == own])
        required = [Output(listed[i].arguments[0], ONE) for i in spread]
        return Stage(compiled(listed, required, loads, groups, reading.recorder.multipliers), operands, groups, spread)

    def __call__(self, argument: Evaluated) -> SplineValue:
        """The value on an argument with the program's signature, without provenance.

        Raises `FormulaError` for an argument with another signature.
        """
        given = operands_of(self.signature.kind, argument)
        if given is None or given.signature != self.signature:
            raise FormulaError(
                "an argument for which the program was not compiled", remedy="compile one with program_for"
            )
        return self.on(given)

    def on(self, given: Given) -> SplineValue:
        """The value from the splines of an argument."""
        leaves = tuple(zip(self.leaves, [f.provenance for f in given.splines], strict=True))
        splines = self._on_patches(given, leaves) if self._stages else self._on_segments(given, leaves)
        value: SplineValue = _rebuilt(self.value, iter(splines))
        return value

    def _on_segments(self, given: Given, leaves: Any) -> list[BSpline]:
        """The terms of the value in one parameter."""
        operands, mesh = given.splines, given.meshes[0]
        below = [operands[k].denominators for k in self.groups]
        columns: Any = tuple(zip(*self.run([f.numerators for f in operands], below, mesh.widths), strict=True))
        inner, count = len(mesh.widths) - 1, len(self.terms)
        continuities = [f.continuity for f in operands] if inner else ()
        return [
            from_parts(
                term.degrees[0],
                mesh,
                term.continuity_of(continuities, inner) if inner else (),
                columns[k],
                columns[count + k],
                within(term.provenance, leaves),
            )
            for k, term in enumerate(self.terms)
        ]

    def _on_patches(self, given: Given, leaves: Any) -> list[TensorSpline]:
        """The terms of the value in two parameters."""
        meshes: Any = given.meshes
        highest = max(term.degrees[0] for term in self.terms)
        stride = given.stride if highest < given.stride else stride_for(highest)
        polynomials: list[Sequence[fmpz_poly]] = []
        below: list[Sequence[fmpz]] = []
        for which, stage in enumerate(self._stages):
            own = [given.splines[k].denominators for k in stage.groups]
            made = stage.run([given.splines[k].numerators for k in stage.operands], own, meshes[which].widths)
            for column in list(zip(*made, strict=True))[: len(stage.spread)]:
                packed = tuple([c.inflate(stride) for c in column]) if which else column
                polynomials.append(spread(packed, which, meshes))
            below += [spread(m, which, meshes) for m in own]
        widths = meshes[0].widths[:1] * (len(meshes[0]) * len(meshes[1]))
        columns: Any = tuple(zip(*self.run(polynomials, below, widths), strict=True))
        count = len(self.terms)
        continuities, inner = [f.continuity for f in given.splines], [len(mesh) - 1 for mesh in meshes]
        found = []
        for k, term in enumerate(self.terms):
            s, t = (term.continuity_of(continuities, inner[i], i) for i in (0, 1))
            degrees, provenance = Degrees(*term.degrees), within(term.provenance, leaves)
            found.append(make(degrees, meshes, (s, t), stride, columns[k], columns[count + k], provenance))
        return found

    def count(self, name: str) -> int:
        """How many instructions of a given name are executed per segment."""
        used = needed(self.instructions.listed, self.outputs)
        return sum(self.instructions.listed[i].name == name for i in used)


#: All programs, and for those that do not exist yet, the number of segments on which they were requested.
_programs: dict[tuple[Formula, Signature], Program] = {}
_segments_asked: dict[tuple[Formula, Signature], int] = {}

#: Compiling a program takes about as long as evaluating its formula on this many segments.
WORTH_IT = 12


@lru_cache(1024)
def program_of(formula: Formula, signature: Signature) -> Program:
    """The program of a formula for arguments with a signature; compiled once.

    Raises `FormulaError` for a formula of two curves with operations that programs do not support on patches (see
    `Term`).
    """
    reading = ProgramReading(signature)
    return Program(formula(reading.of_signature()), reading)


@lru_cache(1024)
def program_of_all(formulas: tuple[Formula, ...], signature: Signature) -> Program:
    """One program of several formulas, which computes common subexpressions once."""
    reading = ProgramReading(signature)
    shared = reading.of_signature().remembering()
    return Program(tuple(formula(shared) for formula in formulas), reading)


def program_for(formula: Formula, argument: Evaluated) -> Program:
    """The program of a formula for arguments like this one; compiled once.

    Raises `FormulaError` where there is none (see `operands_of` and `program_of`).
    """
    given = operands_of(formula.kind, argument)
    if given is None:
        raise FormulaError(
            f"{formula.name} as a program on a {type(argument).__name__}",
            remedy="a curve, or operands of Table 1, over one list of breakpoints",
        )
    return program_of(formula, given.signature)


def values(formulas: tuple[Formula, ...], given: Given) -> dict[Formula, SplineValue]:
    """The values of several formulas by one program that computes common subexpressions once.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example
    >>> given = operands_of(find("f2").kind, example("rational_cubic"), true_degree=True)
    >>> found = values((find("tangent_lifted_squared"), find("critical_curvature_lifted")), given)
    >>> [f.degree for f in found.values()]
    [8, 12]
    """
    made: Any = program_of_all(formulas, given.signature).on(given)
    return dict(zip(formulas, made, strict=True))


def value(formula: Formula, given: Given) -> SplineValue:
    """The value of a formula on one curve. A program is compiled where it pays off: once it was requested for
    `WORTH_IT` segments. Until then the formula is evaluated in the spline reading, with the same result.
    """
    key = formula, given.signature
    program = _programs.get(key)
    if program is None:
        asked = _segments_asked[key] = _segments_asked.get(key, 0) + len(given.meshes[0])
        if asked < WORTH_IT:
            read: SplineValue = formula(given.argument)
            return read
        program = _programs[key] = program_of(formula, given.signature)
    return program.on(given)


def evaluated(formula: Formula, argument: Evaluated) -> SplineValue:
    """The value of a formula: by its program where there is one, otherwise in the spline reading.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example
    >>> evaluated(find("curvature_squared"), example("circle"))(0)
    mpq(1,1)
    """
    given = operands_of(formula.kind, argument)
    program = None if given is None else _program_if_any(formula, given.signature)
    if given is None or program is None:
        read: SplineValue = formula(argument)
        return read
    return program.on(given)


@lru_cache(1024)
def _program_if_any(formula: Formula, signature: Signature) -> Program | None:
    try:
        return program_of(formula, signature)
    except FormulaError:
        return None
