"""Programs on two curves: what depends on one is computed segment by segment, the rest patch by patch."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

from exactspline.errors import FormulaError
from exactspline.language.arguments import Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import Kind, PairKind
from exactspline.language.provenance import is_alone, leaf, within
from exactspline.polynomials.tensor_bernstein import stride_for
from exactspline.programs.compiled import compiled
from exactspline.programs.denominators import ONE
from exactspline.programs.pair_term import PairTerm, Patches
from exactspline.programs.parts import rebuilt, terms_of
from exactspline.programs.term import Recorder, Term, continuity_from
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor import TensorSpline, make
from exactspline.splines.tensor_univariate import spread


class PairSignature(NamedTuple):
    """What a program on two curves depends on besides its formula: of either curve the degrees of its operands, and
    which of them have the same denominators.
    """

    kind: Kind
    dimension: int
    degrees: tuple[int, ...]
    groups: tuple[int, ...]


class GivenPair(NamedTuple):
    """The splines of two rational curves with segments of width one, and what is known of them beforehand."""

    splines: tuple[tuple[BSpline, ...], tuple[BSpline, ...]]
    meshes: tuple[Mesh, Mesh]
    stride: int
    signature: PairSignature


def operands_of_pair(kind: Kind, argument: object) -> GivenPair | None:
    """The splines of a pair for formulas of a kind; None where there is no program."""
    if type(kind) is not PairKind or not isinstance(argument, Pair):
        return None
    curves = argument.first, argument.second
    own: list[tuple[BSpline, ...]] = []
    stride = 1
    for which, curve in enumerate(curves):
        tensors = (*curve.p, curve.w)
        if curve.polynomial or not all(type(f) is TensorSpline and _alone(f, which) for f in tensors):
            return None
        own.append(tuple(f.profile[1] for f in tensors))
        stride = max(stride, *[f.stride for f in tensors])
    meshes = curves[0].w.meshes
    leaves = {is_alone(f.provenance) for splines in own for f in splines}
    told_apart = len(leaves) == len(own[0]) + len(own[1])
    of_meshes = all(f.mesh is meshes[which] for which in (0, 1) for f in own[which])
    if not (told_apart and of_meshes and all(mesh.unit for mesh in meshes)):
        return None
    groups = [
        next(j for j, g in enumerate(splines) if g.denominators == f.denominators) + which * len(splines)
        for which, splines in enumerate(own)
        for f in splines
    ]
    degrees = tuple(f.degree for splines in own for f in splines)
    signature = PairSignature(kind, argument.dimension, degrees, tuple(groups))
    return GivenPair((own[0], own[1]), meshes, stride, signature)


def _alone(f: TensorSpline, which: int) -> bool:
    return f.profile is not None and f.profile[0] == which and is_alone(f.provenance) is not None


class PairProgram:
    """A formula on two curves as instructions for either and for the patches.

    >>> from exactspline.papers import find
    >>> from exactspline.splines.examples import example
    >>> from exactspline.splines.tensor import surface_pair
    >>> pair = surface_pair(example("rational_space_cubic"), example("ellipse_in_space"))
    >>> chord = find("chen_riesenfeld_cohen_2007:chord")
    >>> given = operands_of_pair(chord.kind, pair)
    >>> program_of_pair(chord, given.signature).on(given) == chord(pair)
    True
    """

    def __init__(self, formula: Formula, signature: PairSignature) -> None:
        count = len(signature.degrees) // 2
        self.patches = Patches()
        recorders = Recorder(unit_widths=True), Recorder(unit_widths=True)
        #: The provenances of the operands in the program.
        self.leaves = tuple([leaf() for _ in signature.degrees])
        symbols = signature.kind.symbols(signature.dimension)
        terms = {}
        for k, symbol in enumerate(symbols):
            which, own = divmod(k, count)
            given = signature.degrees[k], signature.groups[k], self.leaves[k]
            term = Term.operand(recorders[which], own, count, *given)
            terms[symbol.name] = PairTerm.of(self.patches, which, term)
        one = terms[symbols[0].name].constant(1)
        argument = signature.kind.argument(signature.dimension, lambda symbol: terms[symbol.name], one)
        self.value = formula(argument)
        self.terms: list[PairTerm] = terms_of(self.value, PairTerm)
        outputs = [(term.output(), term.below) for term in self.terms]
        self.groups = sorted(set(signature.groups))
        self._curves = []
        for which, recorder in enumerate(recorders):
            wanted = [(node, ONE) for i, node in self.patches.loads if i == which]
            groups = [g for g in self.groups if g // count == which]
            run = compiled(recorder.instructions.listed, wanted, count, groups, recorder.multipliers)
            self._curves.append((run, [g % count for g in groups]))
        loads = len(self.patches.loads)
        self._patch = compiled(self.patches.instructions.listed, outputs, loads, self.groups, [])

    def on(self, given: GivenPair) -> object:
        """The value from the splines of a pair."""
        highest = max(term.degree.s for term in self.terms)
        stride = given.stride if highest < given.stride else stride_for(highest)
        loaded, below, columns = [], [], []
        for which, (run, groups) in enumerate(self._curves):
            splines, mesh = given.splines[which], given.meshes[which]
            own = [splines[g].denominators for g in groups]
            made = run([f._polynomials for f in splines], own, mesh.widths)
            columns.append(iter(zip(*made, strict=True)))
            below += [spread(m, which, given.meshes) for m in own]
        for which, _ in self.patches.loads:
            polynomials: Any = next(columns[which])
            packed = tuple([c.inflate(stride) for c in polynomials]) if which else polynomials
            loaded.append(spread(packed, which, given.meshes))
        patches = len(given.meshes[0]) * len(given.meshes[1])
        found = list(zip(*self._patch(loaded, below, given.meshes[0].widths[:1] * patches), strict=True))
        leaves = tuple(zip(self.leaves, [f.provenance for own in given.splines for f in own], strict=True))
        return rebuilt(self.value, iter(self._splines(given, stride, found, leaves)))

    def _splines(self, given: GivenPair, stride: int, found: list[Any], leaves: Any) -> list[TensorSpline]:
        count = len(self.terms)
        inner = [len(mesh) - 1 for mesh in given.meshes]
        continuities = [[f.continuity for f in own] for own in given.splines]
        made = []
        for k, term in enumerate(self.terms):
            s, t = (continuity_from(term.orders[i], continuities[i], inner[i]) for i in (0, 1))
            provenance = within(term.provenance, leaves)
            made.append(make(term.degree, given.meshes, (s, t), stride, found[k], found[count + k], provenance))
        return made


@lru_cache(256)
def program_of_pair(formula: Formula, signature: PairSignature) -> PairProgram | None:
    """The program of a formula for pairs with a signature, made once; None where there is none."""
    try:
        return PairProgram(formula, signature)
    except FormulaError:
        return None
