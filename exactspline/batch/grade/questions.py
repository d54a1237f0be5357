"""The questions to libraries, and what counts as the same answer."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Asked:
    """A question: its name, its meaning, and the error allowed."""

    name: str
    meaning: str
    allowed: str


#: The unit of errors, said once.
ULPS = (
    "16 (degree + 1) ulps of the largest coordinate of a control point, times the largest ratio of weights (once more "
    "a derivative)"
)
PLACES = (
    "every place at which the sign changes is named at least once within 2⁻¹⁶ of the domain; a place where it does not "
    "change, an end of the domain, and whatever is within 2⁻⁸ of a singular point (where curvature is asked for, of a "
    "knot too) may be named or not; a parameter is invented where the exact function is above 2⁻³² of its largest "
    "Bézier point and no place is near; zeros nearer than 2⁻¹⁶ are one place"
)
STRAIGHT = "anything where γ′ × γ″, times the length of the domain, is nowhere above 2⁻²⁰ of ‖γ′‖²"
QUESTIONS: dict[str, Asked] = {
    asked.name: asked
    for asked in (
        Asked("value", "the point at a parameter", ULPS),
        Asked("first", "the first derivative there", f"degree / (shortest segment) times {ULPS}"),
        Asked("second", "the second derivative there", f"the square of degree / (shortest segment) times {ULPS}"),
        Asked("tangent", "the unit tangent there", "what the error allowed to γ′ makes of it"),
        Asked("curvature", "the absolute curvature there", "what the errors allowed to γ′ and γ″ make of it"),
        Asked("torsion", "the torsion there", "what the errors allowed to γ′, γ″ and γ‴ make of it"),
        Asked("insert", "the control points with a knot there", f"twice {ULPS}"),
        Asked("remove", "the control points without a knot that was inserted exactly", f"2¹⁶ times {ULPS}"),
        Asked(
            "elevate",
            "the control points with the degree raised by one",
            f"2¹⁶ times {ULPS}; over other knots, the curve itself",
        ),
        Asked("split", "the control points of the two parts", f"twice {ULPS}"),
        Asked("box", "the smallest and largest coordinates", f"2¹⁶ times {ULPS}, and what the library says it adds"),
        Asked("turns", "the parameters at which a coordinate turns", PLACES),
        Asked("roots", "the parameters at which y = 0", PLACES),
        Asked("inflections", "the parameters at which the curvature changes its sign", f"{PLACES}; {STRAIGHT}"),
        Asked("extrema", "the parameters at which the curvature is largest or smallest", f"{PLACES}; {STRAIGHT}"),
        Asked("length", "the arc length", "10⁻⁶ of it, or the tolerance that the library documents"),
        Asked("area", "the signed area inside a closed curve", f"2¹⁰ times {ULPS}, times that coordinate"),
    )
}
