"""What functions behind the methods of `BSpline` need of it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol, Self, TypeVar

from exactspline.language.provenance import Provenance
from exactspline.numbers.exact import Number, mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.sides import Side
from exactspline.polynomials.bernstein import Form
from exactspline.splines.forms import Forms
from exactspline.splines.knots import Mesh


class Piecewise(Protocol):
    """A piecewise polynomial by its forms."""

    degree: int
    mesh: Mesh
    continuity: tuple[int, ...]
    provenance: Provenance

    @classmethod
    def from_forms(
        cls,
        degree: int,
        mesh: Mesh,
        continuity: tuple[int, ...],
        forms: Iterable[Form],
        provenance: Provenance | None = None,
    ) -> Self:
        """The one with these forms."""

    @property
    def forms(self) -> Forms:
        """The form of every segment."""

    @property
    def domain(self) -> Interval:
        """The interval of definition."""

    @property
    def true_degree(self) -> int:
        """Largest degree of the polynomials themselves."""

    def constant(self, number: Number, /) -> Self:
        """A constant on the same domain."""

    def d(self, order: int = 1) -> Self:
        """The derivative of the given order."""

    def __call__(self, t: Number, side: Side | str = Side.RIGHT) -> mpq:
        """The exact value at a parameter."""


S = TypeVar("S", bound=Piecewise)
