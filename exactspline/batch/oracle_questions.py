"""The questions that the oracle answers, each with the function that answers it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TypeAlias

from exactspline.batch import oracle_features as features
from exactspline.batch import oracle_shapes as shapes
from exactspline.batch import oracle_values as values
from exactspline.batch.oracle_answers import Item, Question
from exactspline.splines.nurbs import Nurbs

#: Items and certificates.
Found: TypeAlias = tuple[Iterable[Item], Iterable[dict[str, object]]]


@dataclass(frozen=True)
class Kind:
    """A kind of question: its syntax, its meaning, and the function that answers it."""

    asked: str
    meaning: str
    answer: Callable[[Nurbs, Question], Found]


#: By their names.
QUESTIONS: dict[str, Kind] = {
    kind.asked.partition("@")[0].partition(":")[0]: kind
    for kind in (
        Kind("value@T", "the point", values.value),
        Kind("derivative:K@T", "the derivative of order K (by default 1)", values.derivative),
        Kind("curvature@T", "the curvature: signed in the plane, not negative in space", values.curvature),
        Kind("torsion@T", "the torsion of a space curve", values.torsion),
        Kind("frame@T", "unit tangent and normal, in space also the binormal", values.frame),
        Kind("insert:M@T", "the control points with the knot T inserted M times (by default once)", shapes.insert),
        Kind("remove:M@T", "the control points with the knot T removed M times", shapes.remove),
        Kind("elevate:K", "the control points with the degree raised by K (by default 1)", shapes.elevate),
        Kind("split@T", "the control points of the parts before and after T", shapes.split),
        Kind("product:IJ", "the control points of the product of the coordinates I and J (0 is x)", shapes.product),
        Kind("evolute", "the control points of the evolute, piece by piece", shapes.evolute),
        Kind("inflections", "the zeros of the curvature at regular points", features.inflections),
        Kind("extrema", "the extrema of the curvature", features.extrema),
        Kind("torsion_zeros", "the zeros of the torsion", features.torsion_zeros),
        Kind("cusps", "the points with γ′ = 0 where the direction is reversed", features.cusps),
        Kind("singular", "all points with γ′ = 0", features.singular),
        Kind("corners", "the joints at which the tangent turns, with the angle", features.corners),
        Kind("joints", "all joints: kind, order of geometric continuity, angle, gap", features.joints),
        Kind("turns:I", "where the coordinate I changes from increasing to decreasing or back", features.turns),
        Kind("bounding_box", "the smallest and largest value of every coordinate", features.bounding_box),
        Kind("area", "the signed area inside a closed polynomial plane curve", shapes.area),
        Kind("moments:K", "its moments ∬ xⁱ yʲ with i + j ≤ K (by default 2)", shapes.moments),
        Kind("length", "the arc length", shapes.length),
    )
}
