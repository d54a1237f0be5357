"""The questions that the oracle answers, each with the function that answers it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import TypeAlias

from exactspline.batch import oracle_features as features
from exactspline.batch import oracle_shapes as shapes
from exactspline.batch import oracle_values as values
from exactspline.batch.oracle_answers import Item, Question
from exactspline.geometry.analysis import QUESTIONS as QUESTIONS_ABOUT_CURVES
from exactspline.questions.entry import Entry
from exactspline.splines.nurbs import Nurbs

#: Items and certificates.
Found: TypeAlias = tuple[Iterable[Item], Iterable[dict[str, object]]]


@dataclass(frozen=True)
class Kind:
    """A kind of question: its syntax, its meaning, and the function that answers it."""

    asked: str
    meaning: str
    answer: Callable[[Nurbs, Question], Found]


def _of_registry(entry: Entry) -> Kind:
    """A question of the registry: an argument follows after a colon."""
    asked = f"{entry.name}:{entry.about.argument}" if entry.about.argument else entry.name
    return Kind(asked, entry.meaning, partial(features.answered, entry))


#: The kinds by their names.
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
        *map(_of_registry, QUESTIONS_ABOUT_CURVES.values()),
        Kind("bounding_box", "the smallest and largest value of every coordinate", features.bounding_box),
        Kind("area", "the signed area inside a closed polynomial plane curve", shapes.area),
        Kind("moments:K", "its moments ∬ xⁱ yʲ with i + j ≤ K (by default 2)", shapes.moments),
        Kind("length", "the arc length", shapes.length),
    )
}
