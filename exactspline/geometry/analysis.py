"""One curve, one analysis: everything known of a curve is read from one lazy object that belongs to it. `analyse` makes
it at the first call and keeps it with the curve. Each fact is computed when it is first needed and then kept; several
threads may share it. An analysis is not part of the curve's value: it is not copied, pickled or compared.
"""

from __future__ import annotations

from threading import Lock

from exactspline.errors import ShapeError
from exactspline.geometry import plane_features, space_features
from exactspline.geometry.constructions import Variant
from exactspline.geometry.facts import Fact
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import CurvePiece, Feature, FeatureKind
from exactspline.geometry.planarity import Plane, planar_pieces, plane_of
from exactspline.geometry.space_features import SpaceFacts
from exactspline.splines.nurbs import Nurbs

_LOCK = Lock()


class Analysis(SpaceFacts):
    """Everything that can be computed of one curve in the plane or in space (see `exactspline.geometry.features` for
    what each list holds).

    >>> from exactspline.splines.examples import example
    >>> found = analyse(example("ellipse"))
    >>> [f.kind.value for f in found.curvature_extrema], found.inflections, found.corners
    (['maximum', 'minimum', 'maximum', 'minimum'], (), [])
    """

    @property
    def in_space(self) -> bool:
        """Whether it is a space curve; `ShapeError` when it is neither in the plane nor in space."""
        self.check_dimension()
        return self.curve.dimension == 3

    @property
    def critical_form(self) -> str:
        """The construction whose zeros are the critical points of the curvature."""
        return "space_critical_curvature" if self.in_space else "critical_curvature"

    @Fact
    def inflections(self) -> tuple[Feature, ...]:
        """The zeros of the curvature at regular points."""
        return tuple(space_features.flat_points(self) if self.in_space else plane_features.inflections(self))

    def critical_points(self, variant: Variant | str = Variant.MINIMAL) -> tuple[Feature, ...]:
        """The extrema of the curvature and the points where κ′ = 0 without one, from the form of a variant."""

        def compute() -> tuple[Feature, ...]:
            module = space_features if self.in_space else plane_features
            return tuple(module.critical_points(self, variant))

        return self.once(("critical points", variant), compute)

    @property
    def curvature_extrema(self) -> list[Feature]:
        """The extrema of the curvature."""
        return [f for f in self.critical_points() if f.kind is not FeatureKind.STATIONARY]

    @Fact
    def torsion_zeros(self) -> tuple[Feature, ...]:
        """The zeros of the torsion at regular points; `ShapeError` for a plane curve."""
        if not self.in_space:
            raise ShapeError("the torsion of a curve in R2", remedy="this needs a curve in space")
        return tuple(space_features.torsion_zeros(self))

    @property
    def corners(self) -> list[Joint]:
        """The joints at which the tangent turns."""
        return [joint for joint in self.joints if joint.angle is not None]

    @Fact
    def straight_pieces(self) -> tuple[CurvePiece, ...]:
        """The pieces on which the curve is straight."""
        return tuple(space_features.straight_pieces(self) if self.in_space else plane_features.straight_pieces(self))

    @Fact
    def constant_pieces(self) -> tuple[CurvePiece, ...]:
        """The pieces on which the curvature is constant."""
        return tuple(space_features.constant_pieces(self) if self.in_space else plane_features.constant_pieces(self))

    @Fact
    def planar_pieces(self) -> tuple[tuple[CurvePiece, Plane], ...]:
        """The pieces of a space curve that lie in one plane without being straight, and their planes."""
        return tuple(planar_pieces(self.curve)) if self.in_space and not self._twists_everywhere else ()

    @Fact
    def plane(self) -> Plane | None:
        """The plane of a space curve that has one."""
        return plane_of(self.curve) if self.in_space and not any(self._twist.polynomials) else None


def analyse(curve: Nurbs) -> Analysis:
    """The analysis of a curve: made once, kept with the curve.

    >>> from exactspline.splines.examples import example
    >>> curve = example("cusp")
    >>> analyse(curve) is analyse(curve), [f.kind.value for f in analyse(curve).singular_points]
    (True, ['cusp'])
    """
    with _LOCK:
        if curve._analysis is None:
            object.__setattr__(curve, "_analysis", Analysis(curve))
        found = curve._analysis
    assert isinstance(found, Analysis)
    return found
