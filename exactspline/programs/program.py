"""Programs of formulas: compiled once for a kind of argument, its degrees and its widths, and run on any such argument.

Terms that depend on one parameter are computed segment by segment; for two curves only the other terms are computed
patch by patch.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeVar, cast

from flint import fmpz, fmpz_poly

from exactspline.errors import FormulaError
from exactspline.language.arguments import Curve, Evaluated, Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import CurveKind, Kind, PairKind, TableKind
from exactspline.language.operand import Operand
from exactspline.language.provenance import is_alone, within
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.once import cached_property
from exactspline.polynomials.tensor_bernstein import stride_for
from exactspline.programs.denominators import ONE
from exactspline.programs.instructions import Instructions, Output, Run, compiled, needed
from exactspline.programs.reading import ProgramReading, Signature
from exactspline.programs.term import Term
from exactspline.splines.bspline import BSpline, from_parts
from exactspline.splines.knots import Mesh
from exactspline.splines.lowest_terms import SplineValue
from exactspline.splines.tensor import TensorSpline, make
from exactspline.splines.tensor_patches import Degrees, spread

# ---- the input


class Given(NamedTuple):
    """An argument, its splines in the order of its kind's symbols, the mesh of every parameter, and the signature.

    `stride` is the packing stride for the first of two parameters (see `exactspline.polynomials.tensor_bernstein`).
    """

    argument: Evaluated
    splines: tuple[BSpline, ...]
    meshes: tuple[Mesh, ...]
    signature: Signature
    stride: int = 1


def operands_of(kind: Kind, argument: Evaluated, *, true_degree: bool = False) -> Given | None:
    """The splines of an argument for formulas of a kind, read in the spline reading or at their true degree.

    None if there is no program: for adjoined roots or constants; for splines over different breakpoints, or computed
    from one another (then naive semantics sees more structure than the kind declares; the true degree does not depend
    on this structure); for a polynomial curve whose denominator is not 1; and for two curves one of which is polynomial
    or has segments of a width other than 1.
    """
    if type(kind) is CurveKind:
        if kind.constants or not isinstance(argument, Curve) or (kind.with_point and argument.point is None):
            return None
    elif type(kind) is PairKind:
        return _of_pair(kind, argument) if isinstance(argument, Pair) and not true_degree else None
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
    groups = (0,) * len(splines) if shared else _groups(splines)
    degrees = tuple([f.degree for f in splines])
    signature = Signature(kind, dimension, polynomial, degrees, groups, mesh.unit, true_degree)
    return Given(argument, splines, (mesh,), signature)


def _groups(splines: Sequence[BSpline]) -> tuple[int, ...]:
    """For every spline the first spline with the same denominators."""
    return tuple([next(j for j, g in enumerate(splines) if g.denominators == f.denominators) for f in splines])


def _of_pair(kind: PairKind, pair: Pair[Any]) -> Given | None:
    """The splines of two rational curves with segments of width 1, beginning with the splines of the first curve."""
    own: list[tuple[BSpline, ...]] = []
    stride = 1
    for which, curve in enumerate((pair.first, pair.second)):
        tensors = (*curve.p, curve.w)
        if curve.polynomial or not all(type(f) is TensorSpline and _is_alone(f, which) for f in tensors):
            return None
        own.append(tuple(f.profile[1] for f in tensors))
        stride = max(stride, *[f.stride for f in tensors])
    meshes = pair.first.w.meshes
    splines = (*own[0], *own[1])
    independent = len({is_alone(f.provenance) for f in splines}) == len(splines)
    of_meshes = all(f.mesh is meshes[which] for which in (0, 1) for f in own[which])
    if not (independent and of_meshes and all(mesh.unit for mesh in meshes)):
        return None
    groups = (*_groups(own[0]), *[len(own[0]) + k for k in _groups(own[1])])
    signature = Signature(kind, pair.dimension, False, tuple([f.degree for f in splines]), groups, unit_widths=True)
    return Given(pair, splines, meshes, signature, stride)


def _is_alone(f: TensorSpline, which: int) -> bool:
    """Whether a spline depends on only one of two parameters and was not computed from others."""
    return f.profile is not None and f.profile[0] == which and is_alone(f.provenance) is not None


@lru_cache(None)
def _functions(kind: Kind, dimension: int, polynomial: bool) -> int:
    """The number of operands that are functions; the constants follow them."""
    return sum(bool(symbol.parameters) for symbol in kind.symbols(dimension, polynomial=polynomial))


def _is_one(w: BSpline) -> bool:
    return w.degree == 0 and all(c.is_one() for c in w.numerators) and all(m == 1 for m in w.denominators)


@lru_cache(None)
def _places(kind: Kind, dimension: int, polynomial: bool) -> tuple[tuple[str, int | None], ...]:
    """The position of each symbol of a kind among an argument's operands."""
    count = len(kind.symbols(dimension, polynomial=polynomial))
    signature = Signature(kind, dimension, polynomial, (0,) * count, (0,) * count, unit_widths=True)
    found: dict[int, tuple[str, int | None]] = {}
    named: Mapping[str, Any] = ProgramReading(signature).of_signature().operands()
    for name, operand in named.items():
        parts = list(enumerate(operand)) if isinstance(operand, Vector) else [(None, operand)]
        for index, term in parts:
            if term.orders[-1] < 0:
                found[term.orders.index(0)] = name, index
    return tuple(found[k] for k in range(count))


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
    """A formula as instructions, and the way in which its value is assembled from their results.

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
        return cast(SplineValue, _rebuilt(self.value, iter(splines)))

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
        """The number of instructions of a given name that are executed per segment."""
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

    Raises `FormulaError` if there is none (see `operands_of` and `program_of`).
    """
    given = operands_of(formula.kind, argument)
    if given is None:
        problem = f"{formula.name} as a program on a {type(argument).__name__}"
        raise FormulaError(problem, remedy="a curve, or operands of Table 1, over one list of breakpoints")
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
    """The value of a formula on one curve. A program is compiled after it has been requested for `WORTH_IT` segments.
    Until then the formula is evaluated in the spline reading, with the same result.
    """
    key = formula, given.signature
    program = _programs.get(key)
    if program is None:
        asked = _segments_asked[key] = _segments_asked.get(key, 0) + len(given.meshes[0])
        if asked < WORTH_IT:
            return cast(SplineValue, formula(given.argument))
        program = _programs[key] = program_of(formula, given.signature)
    return program.on(given)


def evaluated(formula: Formula, argument: Evaluated) -> SplineValue:
    """The value of a formula: by its program if there is one, otherwise in the spline reading.

    >>> from exactspline.papers import find
    >>> from exactspline.interchange.examples import example
    >>> evaluated(find("curvature_squared"), example("circle"))(0)
    mpq(1,1)
    """
    given = operands_of(formula.kind, argument)
    program = None if given is None else _program_if_any(formula, given.signature)
    if given is None or program is None:
        return cast(SplineValue, formula(argument))
    return program.on(given)


@lru_cache(1024)
def _program_if_any(formula: Formula, signature: Signature) -> Program | None:
    try:
        return program_of(formula, signature)
    except FormulaError:
        return None
