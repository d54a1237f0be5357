"""Splines in two parameters that depend on one of them only: which (0 for s, 1 for t), and the spline."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TypeVar

from flint import fmpz_poly

from exactspline.polynomials.bernstein import ONE
from exactspline.splines import refinement
from exactspline.splines.bspline import BSpline
from exactspline.splines.knots import SMOOTH, Mesh

Profile = tuple[int, BSpline]
T = TypeVar("T")


def packed_segments(profile: Profile, stride: int) -> tuple[fmpz_poly, ...]:
    """The packed polynomials, one per segment."""
    direction, spline = profile
    return tuple([c.inflate(stride) for c in spline._polynomials]) if direction else spline._polynomials


def spread(values: tuple[T, ...], direction: int, meshes: tuple[Mesh, Mesh]) -> tuple[T, ...]:
    """What belongs to the segments of one direction, patch by patch, t running faster."""
    count = len(meshes[1 - direction].widths)
    if count == 1:
        return values
    return values * count if direction else tuple([x for x in values for _ in range(count)])


@cache
def smooth(segments: int) -> tuple[int, ...]:
    """Continuity across the breakpoints of what does not depend on a parameter."""
    return (SMOOTH,) * (segments - 1)


def changed_one(mesh: Mesh, change: Callable[[BSpline], BSpline]) -> BSpline:
    """The image of the constant 1 under a linear map of splines: its effect on splines that depend on the other
    parameter only.
    """
    return change(BSpline.from_forms(0, mesh, smooth(len(mesh)), [(fmpz_poly([1]), ONE)] * len(mesh)))


class NamedMeshes(tuple[Mesh, Mesh]):
    """The breakpoints in two directions whose parameters have names, as those of a surface or of two curves have."""

    letters: tuple[str, str]


def named(meshes: tuple[Mesh, Mesh], letters: tuple[str, str] | None) -> tuple[Mesh, Mesh]:
    """The meshes with the names of their parameters; as they are where there are none."""
    if letters is None:
        return meshes
    found = NamedMeshes(meshes)
    found.letters = letters
    return found


def letters_of(meshes: tuple[Mesh, Mesh]) -> tuple[str, str] | None:
    """The names of the parameters; None where they have none."""
    return meshes.letters if isinstance(meshes, NamedMeshes) else None


def replaced(meshes: tuple[Mesh, Mesh], direction: int, mesh: Mesh) -> tuple[Mesh, Mesh]:
    """The meshes with one replaced; the same tuple where it does not change, since operands are aligned by identity."""
    if mesh is meshes[direction]:
        return meshes
    return named((meshes[0], mesh) if direction else (mesh, meshes[1]), letters_of(meshes))


def exchanged(meshes: tuple[Mesh, Mesh]) -> tuple[Mesh, Mesh]:
    """The meshes in the other order."""
    letters = letters_of(meshes)
    return named((meshes[1], meshes[0]), None if letters is None else (letters[1], letters[0]))


def one_parameter(a: Profile, b: Profile) -> tuple[int, BSpline, BSpline] | None:
    """The direction and the splines of two that depend on the same parameter only; a constant depends on either."""
    (i, f), (j, g) = a, b
    if i == j:
        return i, f, g
    if _is_constant(f):
        return j, _constant_beside(g, f), g
    return (i, f, _constant_beside(f, g)) if _is_constant(g) else None


def _is_constant(f: BSpline) -> bool:
    return f.degree == 0 and all(c == SMOOTH for c in f.continuity)


def _constant_beside(f: BSpline, constant: BSpline) -> BSpline:
    return refinement.over(f.constant(constant(constant.domain[0])), f.mesh)
