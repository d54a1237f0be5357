"""The kinds of features and joints of a curve, and the values that describe them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from exactspline.roots.answers import OneNumber
from exactspline.roots.root import Root


class FeatureKind(StrEnum):
    """The kind of a point of interest; every member equals its name as text."""

    #: γ′ = 0 and the direction of the curve is reversed, kept, or turned by another angle.
    CUSP = "cusp"
    STOP = "stop"
    CORNER = "corner"
    #: γ′ = 0 where the domain of an open curve ends.
    SINGULAR_END = "singular end"
    #: An end of an interval on which the curve is constant.
    REST = "rest"
    #: κ = 0, and its sign (in space the direction of κN) changes, is kept, or the domain ends there.
    INFLECTION = "inflection"
    UNDULATION = "undulation"
    FLAT_END = "flat end"
    #: In space, at a knot: κ = 0 and the osculating planes of the two sides differ.
    FLAT_POINT = "flat point"
    #: Extrema of κ, and κ′ = 0 without an extremum.
    MAXIMUM = "maximum"
    MINIMUM = "minimum"
    STATIONARY = "stationary"
    #: τ = 0, and its sign changes, is kept, or the domain ends there.
    TORSION_ZERO = "torsion zero"
    TORSION_TOUCH = "torsion touch"
    TORSION_END = "torsion end"
    #: A coordinate has a given value: the difference changes its sign, or keeps its sign, or the domain ends there.
    CROSSING = "level crossing"
    TOUCH = "level touch"

    @property
    def is_singular(self) -> bool:
        """Whether γ′ = 0 there, so that there is no curvature."""
        return self in _SINGULAR

    @property
    def opposite(self) -> FeatureKind:
        """Maximum for minimum and minimum for maximum."""
        return {FeatureKind.MAXIMUM: FeatureKind.MINIMUM, FeatureKind.MINIMUM: FeatureKind.MAXIMUM}[self]


_SINGULAR = (FeatureKind.CUSP, FeatureKind.STOP, FeatureKind.CORNER, FeatureKind.SINGULAR_END, FeatureKind.REST)


def kind_name(kind: FeatureKind) -> str:
    """The name of a kind of feature; for an extremum with the name of the function.

    >>> kind_name(FeatureKind.MAXIMUM), kind_name(FeatureKind.STOP), kind_name(FeatureKind.INFLECTION)
    ('maximum of κ', 'singular point, no cusp', 'inflection')
    """
    names = {FeatureKind.STATIONARY: "stationary point of κ", FeatureKind.STOP: "singular point, no cusp"}
    return f"{kind} of κ" if kind in (FeatureKind.MAXIMUM, FeatureKind.MINIMUM) else names.get(kind, str(kind))


class JointKind(StrEnum):
    """The kinds of joints at a knot, from the least smooth to the smoothest."""

    #: The two sides end in different points.
    GAP = "gap"
    #: The tangent turns by an angle, γ′ ≠ 0 on both sides.
    CORNER = "corner"
    #: γ′ = 0 on one side at least.
    SINGULAR = "singular"
    #: The curve is constant on both sides.
    STILL = "standing still"
    #: In space: one tangent, two osculating planes.
    TURN = "jump of the osculating plane"
    #: One tangent (and osculating plane), but κN jumps.
    CURVATURE_JUMP = "jump of the curvature"
    #: Tangent and curvature are continuous.
    CONTINUOUS = "continuous curvature"


@dataclass(frozen=True)
class Feature(OneNumber):
    """A point of the curve: its kind, its parameter as a certified root, and how it was detected. `by_jump` says that a
    sign changes at a knot without a zero on both sides; `of_absolute` is the kind of extremum of the absolute
    curvature, None where |κ| has no extremum. ``float(feature)`` is the parameter as a double.

    >>> from exactspline import analyse, example
    >>> found = analyse(example("cubic_s")).inflections[0]
    >>> found, float(found)
    (<inflection at 1/2>, 0.5)
    """

    _number = "root"
    kind: FeatureKind
    root: Root
    form: str
    by_jump: bool = False
    of_absolute: FeatureKind | None = None

    def __repr__(self) -> str:
        return f"<{self.kind} at {self.root.shortly()}{', by a jump' if self.by_jump else ''}>"

    @property
    def at_knot(self) -> bool:
        """Whether the parameter is a knot."""
        return self.root.at_knot
