"""What a spline in two parameters is made of."""

from __future__ import annotations

from typing import NamedTuple

from flint import fmpz, fmpz_poly

from exactspline.language.provenance import Provenance
from exactspline.numbers.exact import mpq
from exactspline.polynomials import tensor_bernstein
from exactspline.splines.forms import Polynomials
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor_univariate import Profile, packed_segments, spread


class Degrees(NamedTuple):
    """The degrees in the two parameters."""

    s: int
    t: int

    def max(self, other: Degrees) -> Degrees:
        """The larger of two degrees in each parameter."""
        return Degrees(max(self.s, other.s), max(self.t, other.t))


#: How often the derivatives in each parameter agree at its inner knots.
Continuity = tuple[tuple[int, ...], tuple[int, ...]]
#: Degree, meshes, continuity, stride, packed polynomials and denominators.
Parts = tuple[Degrees, tuple[Mesh, Mesh], Continuity, int, tuple[fmpz_poly, ...], tuple[fmpz, ...]]


class TensorParts:
    """The fields of a spline in two parameters; filled in, it becomes a `TensorSpline`, which does not change."""

    __slots__ = (
        "_denominators",
        "_packed",
        "_points",
        "continuity",
        "degree",
        "meshes",
        "profile",
        "provenance",
        "stride",
    )

    degree: Degrees
    #: The breakpoints in each direction, and the continuity at the interior ones.
    meshes: tuple[Mesh, Mesh]
    continuity: tuple[tuple[int, ...], tuple[int, ...]]
    #: Where it depends on one parameter only: which (0 for s), and the spline.
    profile: Profile | None
    provenance: Provenance
    #: The stride of `polynomials` (see `exactspline.polynomials.tensor_bernstein`); results keep it while it has room,
    #: since packing anew costs more than a product.
    stride: int
    #: The packed polynomials by stride, and the denominators; those of a spline in one parameter only are made when
    #: needed.
    _packed: dict[int, tuple[fmpz_poly, ...]]
    _denominators: tuple[fmpz, ...] | None
    _points: tuple[tuple[mpq, ...], ...] | None

    def _at_stride(self, stride: int) -> tuple[fmpz_poly, ...]:
        """The packed polynomials of all patches, t running faster; the stride must have room for the degree."""
        found = self._packed.get(stride)
        if found is None:
            if self.profile is None:
                found = tuple(tensor_bernstein.repacked(c, self.stride, stride) for c in self._own)
            else:
                found = spread(packed_segments(self.profile, stride), self.profile[0], self.meshes)
            self._packed[stride] = found
        return found

    @property
    def polynomials(self) -> Polynomials:
        """The packed polynomials at the current stride, copies: zero where the spline is."""
        return Polynomials(self._own)

    @property
    def _own(self) -> tuple[fmpz_poly, ...]:
        return self._at_stride(self.stride)

    @property
    def denominators(self) -> tuple[fmpz, ...]:
        """Denominators patch by patch, t running faster."""
        known = self._denominators
        if known is None:
            assert self.profile is not None
            known = spread(self.profile[1].denominators, self.profile[0], self.meshes)
            object.__setattr__(self, "_denominators", known)  # a part computed lazily is kept
        return known
