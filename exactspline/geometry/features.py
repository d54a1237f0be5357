"""Points and pieces of interest of a curve, in the plane or in space: the user's interface. The curve is asked for its
dimension; everything is read from its analysis, so that nothing is computed twice.

All parameters are certified roots. A point where γ′ = 0 is a singular point and nothing else. On a closed curve the
seam is a knot like any other and counts once, at the start of the domain; no parameter is outside the domain.
"""

from __future__ import annotations

from exactspline.geometry.analysis import analyse
from exactspline.geometry.constructions import Variant
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import CurvePiece, Feature, FeatureKind
from exactspline.splines.nurbs import Nurbs

__all__ = [
    "constant_pieces",
    "corners",
    "critical_points",
    "curvature_extrema",
    "cusps",
    "inflections",
    "joints",
    "singular_points",
    "straight_pieces",
    "torsion_zeros",
]


def inflections(curve: Nurbs) -> list[Feature]:
    """The zeros of the curvature at regular points.

    ``inflection``: its sign changes, in space the direction of κN is reversed; ``undulation``: it is kept; ``flat
    end``: the domain ends there; ``flat point``: at a knot of a space curve, the osculating planes of the two sides
    differ. At a knot with one tangent the curvature may change its sign by a jump (`by_jump`). Straight pieces are not
    listed here.

    >>> from exactspline.splines.examples import example
    >>> [f.kind.value for f in inflections(example("six_segment_cubic"))]
    ['inflection', 'inflection']
    >>> [(f.kind.value, f.root.exact) for f in inflections(example("flat_point"))]
    [('inflection', mpq(1,2))]

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    return list(analyse(curve).inflections)


def curvature_extrema(curve: Nurbs) -> list[Feature]:
    """The extrema of the curvature (in space except those with κ = 0): inside segments, and at knots where κ is
    continuous and κ′ changes its sign, with or without a jump.

    >>> from exactspline.splines.examples import example
    >>> found = curvature_extrema(example("six_segment_cubic"))
    >>> len(found), sum(f.by_jump for f in found)
    (8, 2)
    >>> [f.kind.value for f in curvature_extrema(example("rational_space_cubic"))]
    ['maximum', 'minimum']

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    return analyse(curve).curvature_extrema


def critical_points(curve: Nurbs, variant: Variant | str = Variant.MINIMAL) -> list[Feature]:
    """The extrema of the curvature and the points where κ′ = 0 without an extremum (``stationary``), from the form of a
    variant.

    >>> from exactspline.splines.examples import example
    >>> len(critical_points(example("ellipse"), "direct"))
    4
    """
    return list(analyse(curve).critical_points(variant))


def singular_points(curve: Nurbs) -> list[Feature]:
    """The points where γ′ = 0.

    ``cusp``, ``stop`` or ``corner``: the direction of the curve is reversed, kept, or turned by another angle;
    ``rest``: an end of an interval on which the curve stands still; ``singular end``: the domain ends there.

    >>> from exactspline.splines.examples import example
    >>> [(f.kind.value, f.root.exact) for f in singular_points(example("cusp"))]
    [('cusp', mpq(1,2))]
    """
    return list(analyse(curve).singular_points)


def cusps(curve: Nurbs) -> list[Feature]:
    """The singular points at which the direction of the curve is reversed.

    >>> from exactspline.splines.examples import example
    >>> len(cusps(example("cusp"))), len(cusps(example("cubic_s")))
    (1, 0)
    """
    return [f for f in singular_points(curve) if f.kind is FeatureKind.CUSP]


def joints(curve: Nurbs) -> list[Joint]:
    """How the curve continues at every knot inside its domain and at the seam of a closed curve: kind, order of
    geometric continuity, the angle of a corner, the width of a gap, the curvatures of both sides where they differ.

    >>> from exactspline.splines.examples import example
    >>> [(joint.parameter, joint.order) for joint in joints(example("straight_between_arcs"))]
    [(mpq(1,1), 1), (mpq(2,1), 1)]
    """
    return list(analyse(curve).joints)


def corners(curve: Nurbs) -> list[Joint]:
    """The joints at which the direction of the tangent jumps, whether or not γ′ = 0 there, each with its angle.

    >>> from exactspline import Nurbs
    >>> square = Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)])
    >>> [(joint.parameter, joint.angle.degrees(5)) for joint in corners(square)][:2]
    [(mpq(0,1), mpf('90.0')), (mpq(1,1), mpf('90.0'))]
    """
    return analyse(curve).corners


def torsion_zeros(curve: Nurbs) -> list[Feature]:
    """The zeros of the torsion of a space curve at regular points.

    ``torsion zero``: τ changes its sign; ``torsion touch``: it does not; ``torsion end``: the domain ends there. At a
    knot with one osculating plane the sign may change by a jump. Planar pieces are not listed here.

    >>> from exactspline.splines.examples import example
    >>> torsion_zeros(example("space_quartic"))
    []

    Raises `ShapeError` for a curve that is not in space.
    """
    return list(analyse(curve).torsion_zeros)


def straight_pieces(curve: Nurbs) -> list[CurvePiece]:
    """The pieces on which the curve is straight: cut at corners and where it stands still, continuing across the seam
    of a closed curve where that is smooth.

    >>> from exactspline.splines.examples import example
    >>> [str(piece) for piece in straight_pieces(example("straight_between_arcs"))]
    ['[1, 2]']
    """
    return list(analyse(curve).straight_pieces)


def constant_pieces(curve: Nurbs) -> list[CurvePiece]:
    """The pieces on which the curvature is constant: circular arcs and straight pieces, in space also other curves;
    cut where the curvature or the tangent jumps.

    >>> from exactspline.splines.examples import example
    >>> [str(piece) for piece in constant_pieces(example("circle"))]
    ['[0, 4]']
    """
    return list(analyse(curve).constant_pieces)
