"""Programs of formulas: made once for a kind of argument, its degrees and its widths, and run on any such argument."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from exactspline.errors import FormulaError
from exactspline.language.argument import Evaluated
from exactspline.language.arguments import Curve
from exactspline.language.formula import Formula
from exactspline.language.kinds import CurveKind, Kind, TableKind
from exactspline.language.provenance import is_alone, leaf, within
from exactspline.language.reading import Reading
from exactspline.language.vector import Vector
from exactspline.programs.compiled import Run, compiled, needed
from exactspline.programs.instructions import Instructions
from exactspline.programs.pairs import operands_of_pair, program_of_pair
from exactspline.programs.parts import rebuilt, terms_of
from exactspline.programs.term import Recorder, Term
from exactspline.programs.wronskian import TermAtTrueDegree
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.values import SplineValue


class Signature(NamedTuple):
    """What a program depends on besides its formula: everything about the argument except its numbers.

    `degrees` are those of the operands, `groups` say which of them have the same denominators on all segments;
    `true_degree` whether formulas are read at their true degree (see `exactspline.programs.wronskian`).
    """

    kind: Kind
    dimension: int
    polynomial: bool
    degrees: tuple[int, ...]
    groups: tuple[int, ...]
    unit_widths: bool
    true_degree: bool = False


class ProgramReading(Reading):
    """A record of the computation: operands are loaded, operations become instructions."""

    name = "program"
    proves = "nothing: it records the work to be done"

    def __init__(
        self, degrees: Sequence[int], groups: Sequence[int], *, unit_widths: bool, true_degree: bool = False
    ) -> None:
        self.degrees, self.groups = tuple(degrees), tuple(groups)
        self.operand: type[Term] = TermAtTrueDegree if true_degree else Term
        self.recorder = Recorder(unit_widths=unit_widths)
        #: The provenances of the operands in programs.
        self.leaves = tuple([leaf() for _ in degrees])

    def argument(self, kind: Kind, dimension: int, *, polynomial: bool = False) -> Evaluated:
        """Every operand loaded by its number."""
        symbols = kind.symbols(dimension, polynomial=polynomial)
        count = len(symbols)
        terms = {
            symbol.name: self.operand.operand(self.recorder, k, count, degree, group, own)
            for k, (symbol, degree, group, own) in enumerate(
                zip(symbols, self.degrees, self.groups, self.leaves, strict=True)
            )
        }
        one = terms[symbols[0].name].constant(1)
        return kind.argument(dimension, lambda symbol: terms[symbol.name], one, polynomial=polynomial)


class Given(NamedTuple):
    """An argument, its splines in the order of its kind's symbols, and what is known of them in advance."""

    argument: Evaluated
    splines: tuple[BSpline, ...]
    mesh: Mesh
    signature: Signature

    def values(self, formulas: tuple[Formula, ...]) -> dict[Formula, SplineValue]:
        """The values of several formulas by one program, in which what they share is computed once.

        >>> from exactspline.papers import find
        >>> from exactspline.splines.examples import example
        >>> given = operands_of(find("f2").kind, example("rational_cubic"), true_degree=True)
        >>> found = given.values((find("inflections_lifted"), find("critical_curvature_lifted")))
        >>> [f.degree for f in found.values()]
        [3, 12]
        """
        made: Any = _program_of_all(formulas, self.signature).on(self)
        return dict(zip(formulas, made, strict=True))

    def value(self, formula: Formula) -> SplineValue:
        """The value of a formula that applies to such arguments. A program is made where it pays off: once `WORTH_IT`
        segments have asked for it. Until then the formula is read as always, with the same result.
        """
        key = formula, self.signature
        program = _programs.get(key)
        if program is None:
            asked = _segments_asked[key] = _segments_asked.get(key, 0) + len(self.mesh)
            if asked < WORTH_IT:
                value: SplineValue = formula(self.argument)
                return value
            program = _programs[key] = _program(formula, self.signature)
        return program.on(self)


#: Making a program takes about as long as reading its formula on this many segments.
WORTH_IT = 12


def operands_of(kind: Kind, argument: Evaluated, *, true_degree: bool = False) -> Given | None:
    """The splines of an argument for formulas of a kind, read as they stand or at their true degree.

    None where there is no program: of two curves, of adjoined roots or constants, of splines over different breakpoints
    or made from one another (then naive semantics sees more structure than the kind declares; the true degree does
    not depend on it), and where the denominator of a polynomial curve is not 1.
    """
    if type(kind) is CurveKind:
        if kind.constants or not isinstance(argument, Curve) or (kind.with_point and argument.point is None):
            return None
    elif type(kind) is not TableKind:
        return None
    if isinstance(argument, Curve) and argument.point is None:
        polynomial, coordinates = argument.polynomial, argument.p.components
        dimension, count = len(coordinates), len(coordinates) + (not polynomial)
        splines = coordinates if polynomial else (*coordinates, argument.w)
    else:
        polynomial = bool(getattr(argument, "polynomial", False))
        dimension = getattr(argument, "dimension", kind.dimensions[-1])
        named: Mapping[str, Any] = argument.operands()
        places, count = _places(kind, dimension, polynomial), _functions(kind, dimension, polynomial)
        splines = tuple([named[name] if i is None else named[name][i] for name, i in places])
    mesh, first, shared = splines[0].mesh, splines[0].denominators, True
    for f in splines:
        if type(f) is not BSpline or (f.mesh is not mesh and f.mesh.breaks != mesh.breaks):
            return None
        shared = shared and f.denominators == first
    if isinstance(argument, Curve) and polynomial and not _is_one(argument.w):
        return None
    functions = [is_alone(f.provenance) for f in splines[:count]]
    if not true_degree and (None in functions or len(set(functions)) < len(functions)):
        return None
    groups = (0,) * len(splines)
    if not shared:
        groups = tuple([next(j for j, g in enumerate(splines) if g.denominators == f.denominators) for f in splines])
    degrees = tuple([f.degree for f in splines])
    signature = Signature(kind, dimension, polynomial, degrees, groups, mesh.unit, true_degree)
    return Given(argument, splines, mesh, signature)


@lru_cache(None)
def _functions(kind: Kind, dimension: int, polynomial: bool) -> int:
    """How many of the operands are functions; the constants come after them."""
    return sum(bool(symbol.parameters) for symbol in kind.symbols(dimension, polynomial=polynomial))


def _is_one(w: BSpline) -> bool:
    return w.degree == 0 and all(c.is_one() for c in w.polynomials) and all(m == 1 for m in w.denominators)


@lru_cache(None)
def _places(kind: Kind, dimension: int, polynomial: bool) -> tuple[tuple[str, int | None], ...]:
    """Where in an argument's operands each symbol of its kind is found."""
    count = len(kind.symbols(dimension, polynomial=polynomial))
    reading = ProgramReading([0] * count, [0] * count, unit_widths=True)
    found: dict[int, tuple[str, int | None]] = {}
    named: Mapping[str, Any] = reading.argument(kind, dimension, polynomial=polynomial).operands()
    for name, operand in named.items():
        parts = list(enumerate(operand)) if isinstance(operand, Vector) else [(None, operand)]
        for index, term in parts:
            if term.orders[-1] < 0:
                found[term.orders.index(0)] = name, index
    return tuple(found[k] for k in range(count))


class Program:
    """A formula as instructions, and how its value is assembled from them.

    >>> from exactspline.papers import find
    >>> from exactspline.splines.examples import example
    >>> curve = example("rational_cubic")
    >>> program = program_for(find("f2"), curve)
    >>> program(curve).degree, program.count("mul")
    (6, 9)
    """

    def __init__(self, value: object, reading: ProgramReading, signature: Signature) -> None:
        self.signature = signature
        self.instructions: Instructions = reading.recorder.instructions
        self.leaves = reading.leaves
        self.value = value
        self.terms = terms_of(value, Term)
        self.outputs = [term.output() for term in self.terms]
        outputs = list(zip(self.outputs, [term.below for term in self.terms], strict=True))
        #: The operands that stand for those with the same denominators.
        self.groups = sorted(set(signature.groups))
        self.run: Run = compiled(
            self.instructions.listed, outputs, len(signature.degrees), self.groups, reading.recorder.multipliers
        )

    def __call__(self, argument: Evaluated) -> SplineValue:
        """The value on an argument with the program's signature; it has no provenance.

        Raises `FormulaError` for an argument with another one.
        """
        given = operands_of(self.signature.kind, argument)
        if given is None or given.signature != self.signature:
            raise FormulaError("an argument for which the program was not made", remedy="make one with program_for")
        return self.on(given)

    def on(self, given: Given) -> SplineValue:
        """The value from the splines of an argument."""
        splines = self.splines(given)
        made: Any = splines[0] if isinstance(self.value, Term) else rebuilt(self.value, iter(splines))
        value: SplineValue = made
        return value

    def splines(self, given: Given) -> list[BSpline]:
        """The terms of the value on the segments of an argument."""
        operands = given.splines
        below = [operands[k].denominators for k in self.groups]
        columns: Any = tuple(zip(*self.run([f._polynomials for f in operands], below, given.mesh.widths), strict=True))
        inner, count = len(given.mesh.widths) - 1, len(self.terms)
        continuities = [f.continuity for f in operands] if inner else ()
        leaves = tuple(zip(self.leaves, [f.provenance for f in operands], strict=True))
        return [
            BSpline.from_parts(
                term.degree,
                given.mesh,
                term.continuity_of(continuities, inner),
                columns[k],
                columns[count + k],
                within(term.provenance, leaves),
            )
            for k, term in enumerate(self.terms)
        ]

    def count(self, name: str) -> int:
        """How many instructions of one name are carried out on a segment."""
        used = needed(self.instructions.listed, self.outputs)
        return sum(self.instructions.listed[i].name == name for i in used)


#: All programs, and how many segments have asked for those that do not exist yet.
_programs: dict[tuple[Formula, Signature], Program] = {}
_segments_asked: dict[tuple[Formula, Signature], int] = {}


@lru_cache(1024)
def _program(formula: Formula, signature: Signature) -> Program:
    reading, argument = _read(signature)
    return Program(formula(argument), reading, signature)


@lru_cache(1024)
def _program_of_all(formulas: tuple[Formula, ...], signature: Signature) -> Program:
    reading, argument = _read(signature)
    shared = argument.remembering()
    return Program(tuple(formula(shared) for formula in formulas), reading, signature)


def _read(signature: Signature) -> tuple[ProgramReading, Evaluated]:
    reading = ProgramReading(
        signature.degrees, signature.groups, unit_widths=signature.unit_widths, true_degree=signature.true_degree
    )
    return reading, reading.argument(signature.kind, signature.dimension, polynomial=signature.polynomial)


def program_of(formula: Formula, signature: Signature) -> Program:
    """The program of a formula for arguments with a signature; made once."""
    return _program(formula, signature)


def program_for(formula: Formula, argument: Evaluated) -> Program:
    """The program of a formula for arguments like this one; made once.

    Raises `FormulaError` where there is none (see `operands_of`).
    """
    given = operands_of(formula.kind, argument)
    if given is None:
        raise FormulaError(
            f"{formula.name} as a program on a {type(argument).__name__}",
            remedy="a curve, or operands of Table 1, over one list of breakpoints",
        )
    return _program(formula, given.signature)


def evaluated(formula: Formula, argument: Evaluated) -> SplineValue:
    """The value of a formula: by its program where there is one, and otherwise in the spline reading.

    >>> from exactspline.papers import find
    >>> from exactspline.splines.examples import example
    >>> evaluated(find("curvature_squared"), example("circle"))(0)
    mpq(1,1)
    """
    given = operands_of(formula.kind, argument)
    value: SplineValue
    if given is not None:
        return _program(formula, given.signature).on(given)
    pair = operands_of_pair(formula.kind, argument)
    if pair is not None and (program := program_of_pair(formula, pair.signature)) is not None:
        made: Any = program.on(pair)
        value = made
    else:
        value = formula(argument)
    return value
