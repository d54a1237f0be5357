"""Patches on which the Gaussian curvature is constant."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, islice, product

from exactspline.bivariate.borders import Patch
from exactspline.geometry.surfaces.forms import SurfaceForms, sides_of
from exactspline.numbers.exact import mpq

#: The number of points at which K is compared first, and the denominator of their coordinates.
POINTS, FIRST = 4, 7


def constant_curvature(forms: SurfaceForms, patch: Patch) -> mpq | None:
    """The Gaussian curvature of a patch where it is the same at all its points; None where it is not, and on patches
    that are curves or points.

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
    """K at some points inside a patch with a tangent plane; there are none only where no point has a tangent plane."""
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
