"""What a spline in two parameters is made of."""

from __future__ import annotations

from flint import fmpz, fmpz_poly

from exactspline.exact import mpq
from exactspline.language.provenance import Provenance
from exactspline.splines.knots import Mesh
from exactspline.splines.tensor_lines import Degrees
from exactspline.splines.tensor_univariate import Profile


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
    #: The stride of `polynomials` (see `exactspline.splines.tensor_bernstein`); results keep it while it has room,
    #: since packing anew costs more than a product.
    stride: int
    #: The packed polynomials by stride, and the denominators; those of a spline in one parameter only are made when
    #: needed.
    _packed: dict[int, tuple[fmpz_poly, ...]]
    _denominators: tuple[fmpz, ...] | None
    _points: tuple[tuple[mpq, ...], ...] | None
