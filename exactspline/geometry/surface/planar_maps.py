"""Maps of a rectangle into the plane: whether the determinant of the Jacobian keeps its sign, which isogeometric
analysis requires of a parametrization.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from itertools import product

from exactspline.errors import ShapeError
from exactspline.geometry.surface.borders import EDGES, Edge
from exactspline.geometry.surface.forms import Patch, formula, lowest, on_patch, sides_of
from exactspline.geometry.surface.merged import merged_places
from exactspline.geometry.surface.places import Place
from exactspline.geometry.surface.signs import Point, Sign, sign_on_patch
from exactspline.hooks import Displayed
from exactspline.language.rational import Rational
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.questions.answers import SurfacePart, SurfacePlaces
from exactspline.questions.entry import Answered, Fact, Inspected, Of, question
from exactspline.roots.common_zeros import CommonZero
from exactspline.splines.expected import surface_of
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline


class MapKind(StrEnum):
    """What is proved of the Jacobian determinant on the whole closed rectangle."""

    POSITIVE = "orientation kept: det > 0"
    NEGATIVE = "orientation reversed: det < 0"
    FOLDED = "folded: det has both signs"
    SINGULAR = "det has zeros"
    DEGENERATE = "det vanishes on a whole patch"
    UNDECIDED = "undecided"


class MapInspection(Inspected, Displayed):
    """Everything that can be computed of the sign of the Jacobian determinant of a map of the plane. Its questions are
    entries of the registry (`exactspline.geometry.registry`).

    Raises `ShapeError` for a surface that is not in the plane.
    """

    def __init__(self, surface: NurbsSurface) -> None:
        super().__init__(surface)
        if surface.dimension != 2:
            raise ShapeError(f"the Jacobian of a map into R{surface.dimension}", remedy="it is defined for planar maps")
        self.surface = surface

    def __repr__(self) -> str:
        return f"<MapInspection of {self.surface!r}>"

    @Fact
    def _found(self) -> _Found:
        determinant, findings = _determinant(self.surface), _Found()
        rows, columns = self.surface.patches
        for patch in product(range(rows), range(columns)):
            _add_patch(findings, determinant, patch, sides_of(self.surface, patch), self.surface.domain)
        return findings

    @question(Of.PLANAR_MAP, answered=Answered.VALUE)
    def kind(self) -> MapKind:
        """What is proved of the sign of the Jacobian determinant on the whole closed rectangle.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).kind.value
        'orientation kept: det > 0'
        """
        return self._found.kind

    @question(Of.PLANAR_MAP, answered=Answered.POINT)
    def positive(self) -> Point | None:
        """A point at which the Jacobian determinant is positive, where one is found.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).positive is not None
        True
        """
        return self._found.positive

    @question(Of.PLANAR_MAP, answered=Answered.POINT)
    def negative(self) -> Point | None:
        """A point at which the Jacobian determinant is negative, where one is found.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).negative is None
        True
        """
        return self._found.negative

    @question(Of.PLANAR_MAP)
    def zeros(self) -> SurfacePlaces[Place]:
        """The points at which the Jacobian determinant is zero.

        Each with the patches from which it vanishes there; everywhere on patches and their edges on which it vanishes.
        Zeros inside patches on which it has both signs are not computed, but reported as undecided.

        >>> from exactspline import analyse, example
        >>> analyse(example("planar_map")).zeros
        nowhere
        """
        findings = self._found
        everywhere = [SurfacePart(patch, sides_of(self.surface, patch)) for patch in findings.degenerate]
        everywhere += [SurfacePart(patch, edge.box(sides_of(self.surface, patch))) for patch, edge in findings.edges]
        places = merged_places(findings.zeros, self.surface.domain, ())
        return SurfacePlaces(places, tuple(everywhere), (*findings.mixed, *findings.undecided))

    @property
    def edges(self) -> tuple[tuple[Patch, Edge], ...]:
        """The edges of patches along which it vanishes."""
        return tuple(self._found.edges)

    @property
    def undecided(self) -> tuple[Box, ...]:
        """The boxes of parameters in which its sign is not decided."""
        return tuple(self._found.undecided)

    @property
    def regular(self) -> bool:
        """Whether the determinant is proved to have no zero on the closed rectangle (one-sided at knots)."""
        return self.kind in (MapKind.POSITIVE, MapKind.NEGATIVE)

    @property
    def complete(self) -> bool:
        """Whether everything was decided."""
        return not self.undecided


def jacobian_sign(surface: NurbsSurface) -> MapInspection:
    """The sign of the Jacobian determinant of a map of the plane, proved on every closed patch.

    >>> from exactspline import example
    >>> jacobian_sign(example("planar_map")).kind
    <MapKind.POSITIVE: 'orientation kept: det > 0'>
    >>> inspection = jacobian_sign(example("folded_map"))
    >>> inspection.kind.value, inspection.regular
    ('folded: det has both signs', False)

    Raises `ShapeError` for a surface that is not in the plane.
    """
    return MapInspection(surface_of(surface))


@dataclass
class _Found:
    """What is known patch by patch."""

    positive: Point | None = None
    negative: Point | None = None
    degenerate: list[Patch] = field(default_factory=list)
    zeros: list[Place] = field(default_factory=list)
    edges: list[tuple[Patch, Edge]] = field(default_factory=list)
    undecided: list[Box] = field(default_factory=list)
    #: The patches on which it has both signs.
    mixed: list[Box] = field(default_factory=list)

    @property
    def kind(self) -> MapKind:
        if self.positive and self.negative:
            return MapKind.FOLDED
        if self.degenerate:
            return MapKind.DEGENERATE
        if self.zeros or self.edges:
            return MapKind.SINGULAR
        if self.undecided:
            return MapKind.UNDECIDED
        return MapKind.POSITIVE if self.positive else MapKind.NEGATIVE


def _add_patch(findings: _Found, determinant: TensorSpline, patch: Patch, sides: Box, domain: Box) -> None:
    own = on_patch(determinant, patch)
    if own is None:
        findings.degenerate.append(patch)
        return
    signs = sign_on_patch(own.form)
    if signs.positive:
        findings.positive = findings.positive or _inside(signs.positive, 1, own.whole, sides, domain)
    if signs.negative:
        findings.negative = findings.negative or _inside(signs.negative, -1, own.whole, sides, domain)
    findings.zeros += [Place((patch,), CommonZero.at(sides, sides.at(*point))) for point in signs.zeros]
    findings.undecided += [sides.part(box) for box in signs.undecided]
    findings.mixed += [sides] * (signs.sign is Sign.BOTH)
    findings.edges += [(patch, edge) for edge, times in zip(EDGES, own.borders, strict=True) if times]


def _determinant(surface: NurbsSurface) -> TensorSpline:
    """A spline with the sign of the determinant."""
    value = formula("jacobian")(surface)
    if isinstance(value, Rational):
        (a, _), (c, _) = surface.domain
        value = value.numerator if value.denominator(a, c) > 0 else value.numerator.scaled(-1)
    assert isinstance(value, TensorSpline)
    return lowest(value)


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
