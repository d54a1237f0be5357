"""The forms of a surface whose signs and zeros are computed, from the formulas of `exactspline.formulas.surfaces`.

Each form is evaluated on the given surface and reduced to its lowest degree; on a patch it is then a `PatchForm`,
without the factors that vanish on a border of the patch, which occur at poles.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, islice, product
from typing import NamedTuple

from exactspline.bivariate.borders import Patch
from exactspline.errors import DomainError, ShapeError
from exactspline.language.formula import Formula
from exactspline.language.ruled import numerator
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.numbers.once import cached_property
from exactspline.papers import find
from exactspline.polynomials.patch_forms import Borders, PatchForm
from exactspline.reals.real import Real, square_root
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline, aligned


class Reduced(NamedTuple):
    """A form on a patch: the form itself, the form without factors that vanish on borders, and the multiplicity of each
    of these factors.
    """

    whole: PatchForm
    form: PatchForm
    borders: Borders


def formula(name: str) -> Formula:
    """The formula about surfaces with this name."""
    return find(f"surfaces:{name}")


class SurfaceForms:
    """The forms of one surface in space, each computed once.

    >>> from exactspline import example
    >>> forms = SurfaceForms(example("torus"))
    >>> forms.parabolic.degree, forms.lines[0].is_zero
    (Degrees(s=8, t=8), True)
    """

    def __init__(self, surface: NurbsSurface) -> None:
        if surface.dimension != 3:
            raise ShapeError(
                f"the curvature of a surface in R{surface.dimension}", remedy="it is defined for surfaces in space"
            )
        self.surface = surface
        self._argument = surface.remembering()

    def scalar(self, name: str) -> TensorSpline:
        """The value of a formula, at its lowest degree."""
        value = self._argument.calls(formula(name))
        assert isinstance(value, TensorSpline)
        return lowest(value)

    def vector(self, name: str) -> Vector[TensorSpline]:
        """The value of a formula that is a vector."""
        value = self._argument.calls(formula(name))
        assert isinstance(value, Vector)
        return value.mapped(lowest)

    @cached_property
    def parabolic(self) -> TensorSpline:
        """``w⁸ (LN − M²)``, of the sign of K."""
        return self.scalar("parabolic_lifted")

    @cached_property
    def area(self) -> TensorSpline:
        """``w⁶ (EG − F²)``, zero where the surface has no tangent plane."""
        return self.scalar("area_squared_lifted")

    @cached_property
    def second(self) -> tuple[TensorSpline, TensorSpline, TensorSpline]:
        """L, M, N up to one power of w."""
        return self.scalar("L_lifted"), self.scalar("M_lifted"), self.scalar("N_lifted")

    @cached_property
    def minimality(self) -> TensorSpline:
        """``w⁸ (EN − 2FM + GL)``, zero where H is."""
        return self.scalar("minimality_lifted")

    @cached_property
    def lines(self) -> tuple[TensorSpline, TensorSpline, TensorSpline]:
        """The coefficients of the lines of curvature ``A du² + B du dv + C dv² = 0``, up to one positive factor."""
        uu, uv, vv = (self.scalar(f"line_coefficient_{which}_lifted") for which in ("uu", "uv", "vv"))
        return uu, uv, vv

    @cached_property
    def umbilicity(self) -> TensorSpline:
        """``(EN − 2FM + GL)² − 4 (EG − F²)(LN − M²)`` times a power of w."""
        value = numerator(self._argument.calls(formula("umbilicity")))
        assert isinstance(value, TensorSpline)
        return lowest(value)

    @cached_property
    def ridge_cubic(self) -> Vector[TensorSpline]:
        """The coefficients of the cubic form that is, in a principal direction, the derivative of the principal
        curvature in this direction, up to a factor without zeros.
        """
        return self.vector("ridge_cubic_lifted")

    @cached_property
    def ridges(self) -> TensorSpline:
        """The polynomial of the ridges of both principal curvatures, up to a power of w."""
        return self.scalar("ridges_lifted")

    @cached_property
    def first(self) -> tuple[TensorSpline, TensorSpline, TensorSpline]:
        """E, F, G up to one positive factor."""
        return self.scalar("E_reduced"), self.scalar("F_reduced"), self.scalar("G_reduced")

    @cached_property
    def normal(self) -> Vector[TensorSpline]:
        """The normal, up to one factor without zeros."""
        return self.vector("normal_lifted_of_surface")

    @cached_property
    def tangents(self) -> tuple[Vector[TensorSpline], Vector[TensorSpline]]:
        """``w² S_u`` and ``w² S_v``."""
        return self.vector("D_u"), self.vector("D_v")

    @cached_property
    def curvature(self) -> tuple[TensorSpline, TensorSpline]:
        """Numerator and denominator of K: ``w⁴ · w⁸ (LN − M²)`` and ``‖Π_n‖⁴``."""
        return self.parabolic * self.surface.w**4, self.area * self.area

    def curvatures(self, u: mpq, v: mpq) -> tuple[Real, Real]:
        """K and H at a pair of parameters.

        For the normal ``S_u × S_v``: ``H = w⁸ (EN − 2FM + GL) |w| √a / (2 a²)`` with ``a = w⁶ (EG − F²)``.

        >>> from exactspline import example
        >>> SurfaceForms(example("sphere")).curvatures(mpq(1, 3), mpq(1, 3))[0]
        <Real 1>

        Raises `DomainError` where there is no tangent plane.
        """
        numerator, denominator = (form(u, v) for form in self.curvature)
        if not denominator:
            raise DomainError(f"no tangent plane at {u}, {v}", remedy="see singular_points")
        mean = self.minimality(u, v) * abs(self.surface.w(u, v)) / (2 * denominator)
        return Real(numerator / denominator), square_root(self.area(u, v)) * mean

    @property
    def patches(self) -> list[Patch]:
        """All patches, v running faster."""
        rows, columns = self.surface.patches
        return list(product(range(rows), range(columns)))


def lowest(f: TensorSpline) -> TensorSpline:
    """The same function at its lowest degrees, over the same patches; the zero function unchanged.

    >>> s = TensorSpline((2, 0), [0, 0, 0, 1, 2, 2, 2], [0, 1], [[0], ["1/2"], ["3/2"], [2]])
    >>> lowest(s).degree, len(lowest(s).meshes[0])
    (Degrees(s=1, t=0), 2)
    """
    degree, true = f.degree, f.true_degree
    if degree == true or min(true) < 0:
        return f
    # a lower degree may need fewer knots, but the patches of the surface are kept
    return aligned(f.reduce_degree(degree.s - true.s, degree.t - true.t), f)[0]


def on_patch(f: TensorSpline, patch: Patch) -> Reduced | None:
    """A form on a patch; None where it vanishes identically."""
    whole = f.patch_form(*patch)
    if whole.is_zero:
        return None
    form, borders = whole.without_border()
    return Reduced(whole, form, borders)


def sides_of(surface: NurbsSurface, patch: Patch) -> Box:
    """The rectangle of parameters of a patch."""
    return surface.w.patch(*patch)


# ---- constant curvature


#: The number of points at which K is compared first, and the denominator of their coordinates.
POINTS, FIRST = 4, 7


def constant_curvature(forms: SurfaceForms, patch: Patch) -> mpq | None:
    """The Gaussian curvature of a patch if it is constant; None if it is not, and on patches that are curves or points.

    >>> from exactspline import example
    >>> constant_curvature(SurfaceForms(example("sphere")), (0, 0))
    mpq(1,1)
    >>> constant_curvature(SurfaceForms(example("torus")), (0, 0))
    """
    values = set(islice(_values(forms, patch), POINTS))
    if len(values) != 1:
        return None
    value = values.pop()
    return value if has_curvature(forms, patch, value) else None


def has_curvature(forms: SurfaceForms, patch: Patch, value: mpq) -> bool:
    """Whether K has this value at all points of a patch that have a tangent plane.

    >>> from exactspline import example
    >>> has_curvature(SurfaceForms(example("torus")), (0, 0), mpq(1, 3))
    False
    """
    numerator, denominator = forms.curvature
    return bool((numerator - denominator.scaled(value)).patch_form(*patch).is_zero)


def _values(forms: SurfaceForms, patch: Patch) -> Iterator[mpq]:
    """K at some points inside a patch that have a tangent plane; such points are always found unless no point has a
    tangent plane.
    """
    if forms.area.patch_form(*patch).is_zero:
        return
    sides = sides_of(forms.surface, patch)
    for x, y in _places():
        u, v = sides.at(x, y)
        if area := forms.area(u, v):
            yield mpq(forms.parabolic(u, v) * forms.surface.w(u, v) ** 4 / area**2)


def _places() -> Iterator[tuple[mpq, mpq]]:
    """Points of the unit square, such that no nonzero polynomial vanishes at all of them."""
    for n in count(FIRST):
        for i, j in product(range(1, n), repeat=2):
            yield mpq(i, n), mpq(j, n)
