"""Zeros on the four edges of a patch: these are zeros of polynomials in one parameter, so that all of them are
found.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from flint import fmpz_poly

from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.polynomials.bernstein import from_integers, in_parameter
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.roots.of_polynomials import Parameter, roots_in
from exactspline.roots.root import Root
from exactspline.splines.surface import Along

#: A patch: segment i of u and segment j of v.
Patch = tuple[int, int]


class Edge(NamedTuple):
    """The edge of a patch on which one parameter (`direction` 0: u) has its first or last value (`end` 0 or 1)."""

    direction: int
    end: int

    def __repr__(self) -> str:
        return f"<Edge at the {('first', 'last')[self.end]} {'uv'[self.direction]}>"

    def value(self, sides: Box) -> mpq:
        """The value of the parameter that is constant on the edge."""
        return sides[self.direction][self.end]

    def place(self, sides: Box, other: Parameter) -> tuple[Parameter, Parameter]:
        """Both parameters of a point of the edge."""
        return (self.value(sides), other) if self.direction == 0 else (other, self.value(sides))


EDGES = tuple(Edge(direction, end) for direction, end in product((0, 1), (0, 1)))


def along(form: PatchForm, edge: Edge, sides: Box) -> fmpz_poly:
    """A form along an edge as a polynomial in the other parameter of the surface, up to a positive constant."""
    return in_parameter(from_integers(form.edge(*edge)), form.degree[1 - edge.direction], sides[1 - edge.direction])[0]


def common_along(forms: Sequence[PatchForm], edge: Edge, sides: Box) -> fmpz_poly:
    """The greatest common divisor of forms along an edge: zero if all of them vanish on the edge."""
    return greatest_common_divisor(along(f, edge, sides) for f in forms)


def roots_along(p: fmpz_poly, edge: Edge, sides: Box) -> list[Root]:
    """The roots on a closed edge of a polynomial that is not zero."""
    return roots_in(p, *sides[1 - edge.direction])


def vanishes_at(form: PatchForm, spot: tuple[Parameter, Parameter], sides: Box) -> bool:
    """Whether a form vanishes at a point of a patch that is on the border or rational."""
    u, v = (t.exact if isinstance(t, Root) else t for t in spot)
    if u is not None and v is not None:
        return bool(form.value(sides.first.local(u), sides.second.local(v)) == 0)
    edge = next(edge for edge in EDGES if spot[edge.direction] == edge.value(sides))
    other = spot[1 - edge.direction]
    assert isinstance(other, Root)
    return other.is_root_of(along(form, edge, sides))


def line_of(edge: Edge) -> Along:
    """The parameter that runs along an edge."""
    return Along.V if edge.direction == 0 else Along.U
