"""Features and derived objects as data: control points as exact text, roots as certified intervals."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from operator import itemgetter
from typing import Any, NamedTuple

from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    TEXT,
    Form,
    list_of,
    one_of,
    optional,
    or_null,
    pair_of,
    record,
)
from exactspline.display.pair_data import INTERSECTIONS
from exactspline.display.reals import REAL, real_data
from exactspline.errors import ExactSplineError, ShapeError, a_kind, as_instance, as_integer
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.inspection import Approach, Report, inspect_curve
from exactspline.geometry.curves import balls
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.curves.planarity import Plane
from exactspline.geometry.derived.derive import Derived
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.intervals import Interval
from exactspline.numbers.sides import Side
from exactspline.questions.answers import Described
from exactspline.reals.real import Real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import Root, knot_root
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

#: An angle: its cosine and sine, and in degrees.
ANGLE = or_null(record(cosine=REAL, sine=REAL, degrees=(REAL, balls.degrees)))
#: Numbers, points and vectors by their names.
NUMBERS = Form(
    {"type": "object", "additionalProperties": list_of(REAL).schema},
    lambda values, digits: {name: list_of(REAL).write(each, digits) for name, each in values.items()},
)


class Located(NamedTuple):
    """A feature or a joint of a curve, with the joint there where there is one, and of an extremum of a coordinate
    which.
    """

    curve: Nurbs
    of: Feature | Joint
    root: Root
    joint: Joint | None = None
    coordinate: int | None = None

    def values(self, quantity: Callable[[Nurbs, Root, Side], Real]) -> list[Real]:
        """κ or τ there, or at a knot the limits from both sides where they differ; raises an `ExactSplineError` where
        there is none.
        """
        if self.joint is None:
            return [quantity(self.curve, self.root, Side.RIGHT)]
        sides = zip(analyse(self.curve).sides(self.root.low), Side, strict=True)
        left, right = (quantity(self.curve, knot_root(t), side) for t, side in sides)
        return [left] if left == right else [left, right]


def located(curve: Nurbs, of: Feature | Joint, coordinate: int | None = None) -> Located:
    """A feature or a joint with what is needed to tell it."""
    if isinstance(of, Joint):
        return Located(curve, of, knot_root(of.parameter), of)
    return Located(curve, of, of.root, analyse(curve).joint(of.root.low) if of.at_knot else None, coordinate)


def _limits(quantity: Callable[[Nurbs, Root, Side], Real]) -> Form:
    """The value of a quantity at a place, or its limits from both sides; empty where it has none."""
    form = list_of(REAL, 0, 2)

    def write(at: Located, digits: int) -> object:
        try:
            return form.write(at.values(quantity), digits)
        except ExactSplineError:
            return []

    return Form(form.schema, write)


_CURVATURE, _TORSION = _limits(values_along.curvature), _limits(values_along.torsion)
_PARAMETER = (REAL, "root")
#: A feature: its parameter; κ there where γ′ ≠ 0, in space also τ; and the angle of a corner.
FEATURE = record(
    kind=(one_of(FeatureKind), "of.kind"),
    parameter=_PARAMETER,
    at_knot=(FLAG, "of.at_knot"),
    by_jump=(FLAG, "of.by_jump"),
    of_absolute=(Form({"enum": ["", *map(str, FeatureKind)]}, lambda kind, digits: str(kind or "")), "of.of_absolute"),
    angle=(ANGLE, lambda at: at.joint and at.joint.angle),
    curvature=(optional(_CURVATURE), lambda at: None if at.of.kind.is_singular else at),
    torsion=(optional(_TORSION), lambda at: None if at.of.kind.is_singular or at.curve.dimension < 3 else at),
    coordinate=optional(INTEGER),
)
#: A joint: its kind and order of geometric continuity, the angle of a corner, the width of a gap, and the curvatures of
#: both sides where they differ.
JOINT = record(
    kind=(one_of(JointKind), "of.kind"),
    parameter=_PARAMETER,
    at_seam=(FLAG, "of.at_seam"),
    geometric_continuity=(or_null(INTEGER), "of.order"),
    angle=(ANGLE, "of.angle"),
    gap=(or_null(REAL), "of.gap"),
    curvatures=(or_null(pair_of(REAL)), "of.curvatures"),
)
#: The intervals of a piece, and a planar piece with its plane.
INTERVALS = list_of(INTERVAL, 1).of("parts")
PLANAR_PIECE = record(intervals=(INTERVALS, itemgetter(0)), plane=(TEXT, itemgetter(1)))


def inspection_data(
    curve: Nurbs, approach: Approach | str = Approach.MINIMAL, digits: int = 20, tick: Callable[[], None] = lambda: None
) -> dict[str, object]:
    """What a curve has as data, its critical points by an approach, each answer under the name of its question (see
    `answer_data`); `tick` is called after every feature.

    Raises `ExactSplineError` for what is neither a plane nor a space curve, and for an unknown approach.
    """
    digits = as_integer(digits, "a number of digits", 1)
    if not callable(tick):
        raise ShapeError(f"{a_kind(tick)}, where a function without arguments is expected", remedy="leave it out")
    return report_data(Report(inspect_curve(curve_of(curve), approach)), digits, tick)


def report_data(report: Report, digits: int, tick: Callable[[], None] = lambda: None) -> dict[str, object]:
    """What is said of a curve as data; `tick` is called after every feature."""
    curve = report.curve
    data: dict[str, object] = {"curve": curve.name, "approach": report.inspection.approach, "closed": curve.closed}
    data["digits"] = digits
    data |= {name: answer_data(curve, answer, digits, tick) for name, answer in report.answers.items()}
    if report.within is not None:
        data["epsilon"] = report.epsilon
        for name, found in (("nearby", report.nearby), ("meetings", report.meetings)):
            data[name] = [described_data(each, digits) for each in found]
    if report.with_stability:
        data["stability"] = list_of(STABLE).write(report.stable, digits)
    if report.with_coordinates:
        placed = [
            located(curve, feature, axis) for axis, places in enumerate(report.coordinate_extrema) for feature in places
        ]
        data["coordinate_extrema"] = list_of(FEATURE).write(placed, digits)
    if report.with_approaches:
        data["approaches"] = [asdict(row) for row in report.approaches]
    return data


def answer_data(curve: Nurbs, answer: object, digits: int, tick: Callable[[], None] = lambda: None) -> object:
    """The answer to a question as data: points one by one, and the intervals all of whose points are answers; joints;
    pieces, each as the list of its intervals (two where it crosses the seam of a closed curve), planar ones with their
    planes.
    """
    if isinstance(answer, Places):
        points = []
        for f in answer:
            points.append(FEATURE.write(located(curve, f), digits))
            tick()
        return {"points": points, "everywhere": list_of(INTERVALS).write(answer.everywhere, digits)}
    if isinstance(answer, Intersections):
        return INTERSECTIONS.write(answer, digits)
    if isinstance(answer, tuple):
        return [_element_data(curve, each, digits) for each in answer]
    return None if answer is None else str(answer)


def described_data(found: Described, digits: int) -> dict[str, object]:
    """A piece with what is said of it."""
    return {
        "kind": str(found.kind),
        "intervals": INTERVALS.write(found.piece, digits),
        "numbers": NUMBERS.write(found.values, digits),
        **found.facts,
    }


#: A stable feature with its prominence.
STABLE = Form(
    {}, lambda pair, digits: described_data(pair[0], digits) | {"prominence": or_null(REAL).write(pair[1], digits)}
)


def _element_data(curve: Nurbs, each: Joint | CurvePiece | Described | tuple[CurvePiece, Plane], digits: int) -> object:
    if isinstance(each, Joint):
        return JOINT.write(located(curve, each), digits)
    if isinstance(each, Described):
        return described_data(each, digits)
    return (INTERVALS if isinstance(each, CurvePiece) else PLANAR_PIECE).write(each, digits)


def derived_data(derived: Derived, curve: str) -> dict[str, object]:
    """A derived object as JSON data: control points as exact text, piece by piece.

    A quotient is given by homogeneous control points ``(w x, w y, …, w)``, a scalar one by ``(w f, w)``; it has no
    value at its poles.
    """
    derived = as_instance(derived, Derived, "a derived object", "give the result of exactspline.derive")
    return {
        "name": derived.name,
        "variant": derived.variant,
        "curve": curve,
        "layout": "directrix, generator" if derived.ruled else "",
        "pieces": [piece_data(piece.interval, piece.value) for piece in derived.pieces],
        "missing": [{"interval": [str(a), str(b)], "reason": reason.words} for (a, b), reason in derived.missing],
        "poles": [real_data(pole, 20) for pole in derived.poles],
    }


def piece_data(interval: Interval, value: BSpline | SplineVector) -> dict[str, object]:
    """A spline, a vector of them or a `Rational` over an interval, by its control points."""
    head: dict[str, object] = {"interval": [str(t) for t in interval]}
    if isinstance(value, Rational):
        numerator, denominator = value.elevated()
        components = [*(numerator if isinstance(numerator, Vector) else [numerator]), denominator]
        return head | {"kind": "rational"} | _net(components, "homogeneous_control_points")
    if isinstance(value, Vector):
        return head | {"kind": "polynomial"} | _net(list(value), "control_points")
    points = [str(b) for b in value.control_points]
    return head | {
        "kind": "function",
        "degree": value.degree,
        "knots": [str(t) for t in value.knots],
        "control_points": points,
    }


def _net(components: list[Any], field: str) -> dict[str, object]:
    """Control points of several splines over their common knots."""
    raised = with_common_knots(components)
    knots = raised[0].knots
    return {
        "degree": raised[0].degree,
        "knots": [str(t) for t in knots],
        field: [[str(x) for x in row] for row in zip(*[c.control_points for c in raised])],
    }


#: The degree and the knots of a net of control points.
NET = {
    "degree": Form({"type": ["integer", "array"], "items": INTEGER.schema}),
    "knots": Form({"type": "array", "items": {"type": ["string", "array"], "items": TEXT.schema}}),
}
#: A spline over an interval.
PIECE = Form(
    record(
        interval=INTERVAL,
        kind=Form({"enum": ["rational", "polynomial", "function"]}),
        **NET,
        homogeneous_control_points=optional(list_of(list_of(TEXT))),
        control_points=optional(Form({"type": "array", "items": {"type": ["string", "array"], "items": TEXT.schema}})),
    ).schema,
    lambda piece, digits: piece_data(*piece),
)
