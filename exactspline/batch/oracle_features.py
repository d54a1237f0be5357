"""Features for the oracle: inflections, extrema, cusps, corners, joints, and the bounding box of a curve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

from exactspline.batch.oracle_answers import Item, Question, QuestionError
from exactspline.batch.oracle_values import axes
from exactspline.errors import DomainError, ShapeError
from exactspline.geometry.analysis import analyse
from exactspline.geometry.balls import degrees
from exactspline.geometry.extent import coordinate_range, slope_zeros, turning_points
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import Feature, FeatureKind
from exactspline.geometry.values_along import curvature_at, point_at
from exactspline.roots.enclosure import exact_place
from exactspline.roots.real import Real
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.nurbs import Nurbs

Found = tuple[Iterable[Item], Iterable[dict[str, object]]]


def _points(curve: Nurbs, features: Sequence[Feature], found: ZeroSet) -> Found:
    """Features with their parameter, point, and curvature where it exists."""
    return [_point(curve, f) for f in features], (found.certificate(),)


def _point(curve: Nurbs, feature: Feature) -> Item:
    place = exact_place(feature.root)
    values = {"parameter": Real.of(feature.root)} | dict(zip(axes(curve), point_at(curve, place), strict=True))
    with suppress(DomainError, ShapeError):
        values["curvature"] = curvature_at(curve, place)
    facts = {"at_knot": feature.at_knot, "by_jump": feature.by_jump, "multiplicity": feature.root.multiplicity}
    return Item(str(feature.kind), values, facts)


def inflections(curve: Nurbs, question: Question) -> Found:
    """The zeros of the curvature at regular points."""
    facts = analyse(curve)
    form = facts.bending if facts.in_space else facts.zero_form("zero_curvature")
    return _points(curve, facts.inflections, form.zeros)


def extrema(curve: Nurbs, question: Question) -> Found:
    """The extrema of the curvature."""
    facts = analyse(curve)
    return _points(curve, facts.curvature_extrema, facts.zero_form(facts.critical_form).zeros)


def torsion_zeros(curve: Nurbs, question: Question) -> Found:
    """The zeros of the torsion."""
    facts = analyse(curve)
    found = facts.torsion_zeros
    return _points(curve, found, facts.zero_form("zero_torsion", "paper").zeros)


def singular(curve: Nurbs, question: Question) -> Found:
    """The points with γ′ = 0."""
    facts = analyse(curve)
    return _points(curve, facts.singular_points, facts.speed.zeros)


def cusps(curve: Nurbs, question: Question) -> Found:
    """The singular points at which the direction is reversed."""
    facts = analyse(curve)
    return _points(curve, [f for f in facts.singular_points if f.kind is FeatureKind.CUSP], facts.speed.zeros)


def joints(curve: Nurbs, question: Question) -> Found:
    """All joints."""
    return [_joint(joint) for joint in analyse(curve).joints], ()


def corners(curve: Nurbs, question: Question) -> Found:
    """The joints at which the tangent turns."""
    return [_joint(joint) for joint in analyse(curve).corners], ()


def _joint(joint: Joint) -> Item:
    values = {"parameter": Real.of(joint.parameter)}
    if joint.angle is not None:
        values |= {"degrees": degrees(joint.angle)}
        values |= {"cosine": Real.of(joint.angle.cosine), "sine": Real.of(joint.angle.sine)}
    if joint.gap is not None:
        values["gap"] = Real.of(joint.gap)
    if joint.curvatures is not None:
        values |= dict(zip(("curvature_before", "curvature_behind"), map(Real.of, joint.curvatures), strict=True))
    return Item(str(joint.kind), values, {"geometric_continuity": joint.order, "at_seam": joint.at_seam})


def turns(curve: Nurbs, question: Question) -> Found:
    """The extrema of a coordinate."""
    axis = question.number(0)
    if axis >= curve.dimension:
        raise QuestionError(f"the coordinate {axis} of a curve in R{curve.dimension}", remedy="0 is x, 1 is y, 2 is z")
    return _points(curve, turning_points(curve, axis), slope_zeros(curve, axis))


def bounding_box(curve: Nurbs, question: Question) -> Found:
    """The smallest and largest value of every coordinate."""
    items = [
        Item(axis, dict(zip(("low", "high"), coordinate_range(curve, i), strict=True)))
        for i, axis in enumerate(axes(curve))
    ]
    return items, [slope_zeros(curve, i).certificate() for i in range(curve.dimension)]
