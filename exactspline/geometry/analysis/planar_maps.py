"""Maps of a rectangle into the plane: whether the Jacobian determinant has one sign, as isogeometric analysis requires
of a parametrization.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from itertools import product

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.common_zeros import CommonZero
from exactspline.bivariate.joined_curves import ZeroComponent
from exactspline.bivariate.signs import Point, sign_on_patch
from exactspline.bivariate.zero_lines import ZeroLine
from exactspline.bivariate.zeros import CommonZero as PointOfZeros
from exactspline.bivariate.zeros import SurfacePlaces, ZeroCurves, common_zeros, zero_curve
from exactspline.errors import ShapeError
from exactspline.geometry.analysis.surface_values import SurfaceValues
from exactspline.geometry.surfaces.forms import formula, lowest, on_patch, sides_of
from exactspline.hooks import Displayed
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.one_line import one_line
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.questions.entry import Answered, Fact, Of, question
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline


class MapKind(StrEnum):
    """The proved sign of the Jacobian determinant on the whole closed rectangle."""

    POSITIVE = "orientation kept: det > 0"
    NEGATIVE = "orientation reversed: det < 0"
    FOLDED = "folded: det has both signs"
    SINGULAR = "det has zeros"
    DEGENERATE = "det vanishes on a whole patch"
    UNDECIDED = "undecided"


class MapInspection(SurfaceValues, Displayed):
    """The analysis of the sign of the Jacobian determinant of a map of the plane. The questions about a map are entries
    of the registry (`exactspline.geometry.analysis.ask`).

    >>> from exactspline import example
    >>> MapInspection(example("planar_map")).kind
    <MapKind.POSITIVE: 'orientation kept: det > 0'>
    >>> inspection = MapInspection(example("folded_map"))
    >>> inspection.kind.value, inspection.regular
    ('folded: det has both signs', False)

    Raises `ShapeError` for a surface that is not in the plane.
    """

    def __init__(self, surface: NurbsSurface) -> None:
        super().__init__(surface)
        if surface.dimension != 2:
            raise ShapeError(f"the Jacobian of a map into R{surface.dimension}", remedy="it is defined for planar maps")
        self.surface = surface

    @one_line
    def __repr__(self) -> str:
        return f"<MapInspection of {self.surface!r}>"

    @Fact
    def _determinant(self) -> TensorSpline:
        """A spline with the sign of the determinant."""
        value = formula("jacobian")(self.surface)
        if isinstance(value, Rational):
            (a, _), (c, _) = self.surface.domain
            value = value.numerator if value.denominator(a, c) > 0 else value.numerator.scaled(-1)
        assert isinstance(value, TensorSpline)
        return lowest(value)

    @Fact
    def _signs(self) -> tuple[Point | None, Point | None]:
        """A point at which the determinant is positive, and a point at which it is negative."""
        places: dict[int, Point] = {}
        rows, columns = self.surface.patches
        for patch in product(range(rows), range(columns)):
            if own := on_patch(self._determinant, patch):
                signs = sign_on_patch(own.form)
                for sign, place in ((1, signs.positive), (-1, signs.negative)):
                    if place and sign not in places:
                        sides = sides_of(self.surface, patch)
                        places[sign] = _inside(place, sign, own.whole, sides, self.surface.domain)
        return places.get(1), places.get(-1)

    @Fact
    def _zeros(self) -> ZeroCurves:
        """All zeros of the determinant."""
        return zero_curve(self._determinant)

    @question(Of.PLANAR_MAP, answered=Answered.VALUE)
    def kind(self) -> MapKind:
        """The sign of the Jacobian determinant that is proved on the whole closed rectangle.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).kind.value
        'orientation kept: det > 0'
        """
        if self.positive and self.negative:
            return MapKind.FOLDED
        found = self._zeros
        if found.everywhere:
            return MapKind.DEGENERATE
        if found.lines or found.curves or found.points:
            return MapKind.SINGULAR
        if found.undecided:
            return MapKind.UNDECIDED
        return MapKind.POSITIVE if self.positive else MapKind.NEGATIVE

    @question(Of.PLANAR_MAP, answered=Answered.POINT)
    def positive(self) -> Point | None:
        """A point at which the Jacobian determinant is positive, if one is found.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).positive is not None
        True
        """
        return self._signs[0]

    @question(Of.PLANAR_MAP, answered=Answered.POINT)
    def negative(self) -> Point | None:
        """A point at which the Jacobian determinant is negative, if one is found.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).negative is None
        True
        """
        return self._signs[1]

    @question(Of.PLANAR_MAP)
    def zeros(self) -> SurfacePlaces[Place]:
        """The isolated zeros of the Jacobian determinant.

        Each zero is listed with the patches on which the determinant vanishes there. Patches on which it vanishes
        identically are in `everywhere`.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).zeros
        nowhere
        """
        found = self._zeros
        return SurfacePlaces(self._places(found.points), found.everywhere, found.undecided)

    def _places(self, zeros: Iterable[PointOfZeros]) -> tuple[Place, ...]:
        """Zeros as points of the surface."""
        own = [(zero, sides_of(self.surface, zero.patches[0])) for zero in zeros]
        return tuple(Place(zero.patches, CommonZero.at(sides, zero.place)) for zero, sides in own)

    @question(Of.PLANAR_MAP, answered=Answered.CURVES)
    def zero_lines(self) -> tuple[ZeroLine, ...]:
        """The isoparametric lines along which the Jacobian determinant vanishes.

        >>> from exactspline import analyse, example
        >>> len(analyse(example("planar_map")).zero_lines)
        0
        """
        return self._zeros.lines

    @question(Of.PLANAR_MAP, answered=Answered.CURVES)
    def zero_curves(self) -> tuple[ZeroComponent, ...]:
        """The other curves along which the Jacobian determinant vanishes: folds, where it changes its sign.

        >>> from exactspline import analyse, example
        >>> [curve.shape.value for curve in analyse(example("folded_map")).zero_curves]
        ['arc from border to border']
        """
        return self._zeros.curves

    @question(Of.PLANAR_MAP)
    def cusps(self) -> SurfacePlaces[Place]:
        """The zeros of the Jacobian determinant at which the map is not a fold: cusps, where the kernel of the Jacobian
        is tangent to the curve of zeros, and points at which this curve is singular.

        >>> from exactspline import analyse, example
        >>> analyse(example("folded_map")).cusps
        nowhere
        """
        surface, f = self.surface, self._determinant
        if self.regular:
            return SurfacePlaces(())
        # f along the kernel of each row of the Jacobian
        along = [
            f.d(1, by="u") * (x.d(1, by="v") * surface.w - x * surface.w.d(1, by="v"))
            - f.d(1, by="v") * (x.d(1, by="u") * surface.w - x * surface.w.d(1, by="u"))
            for x in surface.p
        ]
        found = common_zeros(f, *along)
        return SurfacePlaces(self._places(found.points), found.everywhere, found.undecided)

    @property
    def regular(self) -> bool:
        """Whether the determinant is proved to have no zero on the closed rectangle (one-sided at knots)."""
        return self.kind in (MapKind.POSITIVE, MapKind.NEGATIVE)

    @property
    def undecided(self) -> tuple[Box, ...]:
        """The rectangles of parameters in which the zeros of the determinant are not decided."""
        return self._zeros.undecided

    @property
    def complete(self) -> bool:
        """Whether everything was decided."""
        return not self.undecided


def _inside(point: Point, sign: int, whole: PatchForm, sides: Box, domain: Box) -> Point:
    """A point at or near the given one at which the determinant has this sign: a factor may vanish on the border, and
    at a knot the determinant may differ from patch to patch.
    """
    (x, y), half = point, mpq(1, 2)
    place, part = point, mpq(1, 4)
    at_knot = any(
        (t == 0 and low != first) or (t == 1 and high != last)
        for t, (low, high), (first, last) in zip(point, sides, domain, strict=True)
    )
    while (at_knot and place == point) or whole.value(*place) * sign <= 0:
        place, part = (mpq(x + (half - x) * part), mpq(y + (half - y) * part)), part / 2
    return sides.at(*place)
