"""The questions to libraries, and what counts as the same answer."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from exactspline.geometry.analysis.curves import QUESTIONS as OF_CURVES


class Judged(StrEnum):
    """How an answer is compared with the truth."""

    VECTOR = "vector"
    QUOTIENT = "quotient"
    CONTROL_POINTS = "control points"
    BOX = "box"
    NUMBER = "number"
    AREA = "area"
    DISTANCE = "distance"
    #: Pairs of parameters of two curves.
    PAIRS = "pairs"
    PLACES = "places"
    #: Places at regular points: knots and singular points may be named or not, and any point of a straight curve.
    REGULAR_PLACES = "regular places"


@dataclass(frozen=True)
class Asked:
    """A question: its name, its meaning, the error allowed, and how an answer is judged."""

    name: str
    meaning: str
    #: In the words of `TOLERANCES`.
    allowed: str
    judged: Judged


def _at_places(name: str, entry: str, allowed: str, judged: Judged) -> Asked:
    """A question of the registry whose answers are parameters: those at which a sign changes must be named."""
    return Asked(name, f"the parameters of {OF_CURVES[entry].meaning}", allowed, judged)


#: The unit of errors.
ULPS = (
    "16 (degree + 1) ulps of the largest coordinate of a control point, times r, the largest ratio of weights; for the "
    "k-th derivative, times rᵏ⁺¹ in place of r"
)
PLACES = (
    "every parameter at which the sign changes must be named, with an error of at most 2⁻¹⁶ of the length of the "
    "domain. Three kinds of parameters are optional: zeros without a change of sign, ends of the domain, and "
    "parameters within 2⁻⁸ of a singular point (for questions about curvature, also of a knot). A parameter is "
    "invented if no zero is near and the exact function there is above 2⁻³² of its largest Bézier point. Zeros nearer "
    "than 2⁻¹⁶ count as one"
)
STRAIGHT = "any answer is accepted where γ′ × γ″, times the length of the domain, is nowhere above 2⁻²⁰ of ‖γ′‖²"
MEETINGS = (
    "a pair must be named if the sine of the angle of the two tangents is above 2⁻²⁰ and neither another pair nor an "
    "end is within 2⁻¹⁶ of the length of the domain. The error of both parameters may be 2⁻¹⁶ of this length, or 2⁻⁸ "
    "if the two points of the named pair are at most 2⁻³² of the largest coordinate apart. A named pair is invented "
    "if its points are further apart and no true pair is near"
)
#: The words in which a tolerance is stated, and what they mean.
CHANGES, LINES, CROSSINGS = "changes of sign", "straight curves", "crossings"
TOLERANCES = {"u": ULPS, CHANGES: PLACES, LINES: STRAIGHT, CROSSINGS: MEETINGS}
QUESTIONS: dict[str, Asked] = {
    asked.name: asked
    for asked in (
        Asked("value", "the point at a parameter", "u", Judged.VECTOR),
        Asked("first", "the first derivative at a parameter", "degree / (shortest segment) times u", Judged.VECTOR),
        Asked(
            "second",
            "the second derivative at a parameter",
            "the square of degree / (shortest segment) times u",
            Judged.VECTOR,
        ),
        Asked(
            "tangent",
            "the unit tangent at a parameter",
            "the error that follows from the allowed error of γ′",
            Judged.QUOTIENT,
        ),
        Asked(
            "curvature",
            "the absolute curvature at a parameter",
            "the error that follows from the allowed errors of γ′ and γ″",
            Judged.QUOTIENT,
        ),
        Asked(
            "torsion",
            "the torsion at a parameter",
            "the error that follows from the allowed errors of γ′, γ″ and γ‴",
            Judged.QUOTIENT,
        ),
        Asked("insert", "the control points after a knot is inserted", "2u", Judged.CONTROL_POINTS),
        Asked(
            "remove",
            "the control points after a knot that was inserted exactly is removed",
            "2¹⁶ u",
            Judged.CONTROL_POINTS,
        ),
        Asked(
            "elevate",
            "the control points with the degree raised by one",
            "2¹⁶ u; if the knots differ, the curve is compared",
            Judged.CONTROL_POINTS,
        ),
        Asked("split", "the control points of the two parts", "2u", Judged.CONTROL_POINTS),
        Asked(
            "box",
            "the smallest and largest coordinates",
            "2¹⁶ u, and the enlargement that the library documents",
            Judged.BOX,
        ),
        _at_places("turns", "turning_points", CHANGES, Judged.PLACES),
        Asked("roots", "the parameters at which y = 0", CHANGES, Judged.PLACES),
        _at_places("inflections", "inflections", f"{CHANGES}; {LINES}", Judged.REGULAR_PLACES),
        _at_places("extrema", "curvature_extrema", f"{CHANGES}; {LINES}", Judged.REGULAR_PLACES),
        Asked(
            "length", "the arc length", "10⁻⁶ of the length, or the tolerance that the library documents", Judged.NUMBER
        ),
        Asked("area", "the signed area inside a closed curve", "2¹⁰ u times the largest coordinate", Judged.AREA),
        Asked(
            "nearest",
            "the distance of the curve from the first control point of a second curve",
            "2⁻²⁰ of the largest coordinate, and the error that the library documents",
            Judged.DISTANCE,
        ),
        Asked(
            "distance",
            "the distance of the curve from a second curve",
            "2⁻²⁰ of the largest coordinate",
            Judged.DISTANCE,
        ),
        Asked("meetings", "the pairs of parameters at which the curve meets a second curve", CROSSINGS, Judged.PAIRS),
    )
}
