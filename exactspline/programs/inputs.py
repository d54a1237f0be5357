"""The input of programs: the splines of an argument, and what is known about them in advance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from exactspline.language.arguments import Curve, Evaluated, Pair
from exactspline.language.kinds import CurveKind, Kind, PairKind, TableKind
from exactspline.language.provenance import is_alone
from exactspline.language.vector import Vector
from exactspline.programs.reading import ProgramReading, Signature
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor import TensorSpline


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

    None where there is no program: for adjoined roots or constants, for splines over different breakpoints or computed
    from one another (then naive semantics sees more structure than the kind declares; the true degree does not depend
    on it), where the denominator of a polynomial curve is not 1, and for two curves of which one is polynomial or has
    segments of a width other than 1.
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
    """For every spline the first one with the same denominators."""
    return tuple([next(j for j, g in enumerate(splines) if g.denominators == f.denominators) for f in splines])


def _of_pair(kind: PairKind, pair: Pair[Any]) -> Given | None:
    """The splines of two rational curves with segments of width 1, those of the first before those of the second."""
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
