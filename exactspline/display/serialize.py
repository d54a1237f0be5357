"""Features and derived objects as data: control points as exact text, roots as certified intervals."""

from __future__ import annotations

from collections.abc import Callable
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
from exactspline.display.numbers import decimal
from exactspline.display.pair_data import INTERSECTIONS, real_data
from exactspline.errors import ExactSplineError, ShapeError, a_kind, as_instance, as_integer
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.inspection import Approach, inspect_curve
from exactspline.geometry.analysis.prominence import prominences
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.curves.planarity import Plane
from exactspline.geometry.derived.derive import Derived
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpz, rational
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


def angle_data(angle: Angle | None, digits: int) -> dict[str, str] | None:
    """An angle: its cosine and sine exactly, and degrees to a given number of digits."""
    if angle is None:
        return None
    from mpmath import nstr  # loaded where there is a corner

    degrees = str(nstr(angle.degrees(digits), digits, strip_zeros=True)).removesuffix(".0")
    return {"cosine": str(angle.cosine), "sine": str(angle.sine), "degrees": degrees}


ANGLE = Form(or_null(record(cosine=TEXT, sine=TEXT, degrees=TEXT)).schema, angle_data)


def decimal_of(root: Root, digits: int) -> str:
    """A root to a given number of digits after the decimal point."""
    value = rational(root.decimal(digits + 3))
    return decimal(value, digits + len(str(mpz(abs(value)))))


def _value_of(quantity: Callable[[Nurbs, Root, Side | str], Real], curve: Nurbs, root: Root, digits: int) -> str:
    """κ or τ at a root to a given number of significant digits, 0 where it is exactly 0; at a joint the limits from
    both sides where they differ; where there is none, the reason.
    """
    facts = analyse(curve)
    joint = facts.joint(root.low) if root.at_knot else None

    def shown(side: Side | str) -> str:
        at = root if joint is None else knot_root(facts.sides(root.low)[side == Side.RIGHT])
        value = quantity(curve, at, side).rational_near(digits + 8)
        return decimal(value, digits) if value else "0"

    try:
        values = [shown(side) for side in ((Side.LEFT, Side.RIGHT) if joint is not None else (Side.RIGHT,))]
    except ExactSplineError as error:
        return str(error)
    return " | ".join(dict.fromkeys(values))


class _Place(NamedTuple):
    """A feature or a joint at a root of a curve, the joint there where there is one, and of an extremum of a coordinate
    which.
    """

    curve: Nurbs
    of: Feature | Joint
    root: Root
    joint: Joint | None = None
    coordinate: int | None = None


def _value(quantity: Callable[[Nurbs, Root, Side | str], Real]) -> Form:
    return Form(TEXT.schema, lambda at, digits: _value_of(quantity, at.curve, at.root, digits))


DECIMAL = Form(TEXT.schema, decimal_of)
_CURVATURE, _TORSION = _value(values_along.curvature), _value(values_along.torsion)
#: A feature: the parameter exactly, as an interval and to a given number of digits; κ there where γ′ ≠ 0, in space also
#: τ; and the angle of a corner.
FEATURE = record(
    kind=(one_of(FeatureKind), "of.kind"),
    parameter=(or_null(TEXT), "root.exact"),
    interval=(Form(INTERVAL.schema, lambda root, digits: INTERVAL.write(root.refine(digits), digits)), "root"),
    decimal=(DECIMAL, "root"),
    at_knot=(FLAG, "of.at_knot"),
    by_jump=(FLAG, "of.by_jump"),
    of_absolute=(Form({"enum": ["", *map(str, FeatureKind)]}, lambda kind, digits: str(kind or "")), "of.of_absolute"),
    angle=(ANGLE, lambda at: at.joint and at.joint.angle),
    curvature=(optional(_CURVATURE), lambda at: None if at.of.kind.is_singular else at),
    torsion=(optional(_TORSION), lambda at: None if at.of.kind.is_singular or at.curve.dimension < 3 else at),
    coordinate=optional(INTEGER),
)
#: A joint: its kind and order of geometric continuity, the angle of a corner, the width of a gap, and the curvatures of
#: both sides where they differ, exactly and to a given number of digits.
JOINT = record(
    kind=(one_of(JointKind), "of.kind"),
    parameter=(TEXT, "of.parameter"),
    decimal=(DECIMAL, "root"),
    at_seam=(FLAG, "of.at_seam"),
    geometric_continuity=(or_null(INTEGER), "of.order"),
    angle=(ANGLE, "of.angle"),
    gap=(or_null(TEXT), "of.gap"),
    gap_decimal=(
        or_null(Form(TEXT.schema, lambda gap, digits: decimal(gap.rational_near(digits + 8), digits))),
        "of.gap",
    ),
    curvatures=(or_null(pair_of(TEXT)), "of.curvatures"),
    curvature=(or_null(_CURVATURE), lambda at: None if at.of.curvatures is None else at),
)
#: The intervals of a piece, and a planar piece with its plane.
INTERVALS = list_of(INTERVAL, 1).of("parts")
PLANAR_PIECE = record(intervals=(INTERVALS, itemgetter(0)), plane=(TEXT, itemgetter(1)))


def _feature_data(curve: Nurbs, f: Feature, digits: int, coordinate: int | None = None) -> dict[str, object]:
    joint = analyse(curve).joint(f.root.low) if f.at_knot else None
    data: dict[str, object] = FEATURE.write(_Place(curve, f, f.root, joint, coordinate), digits)
    return data


def inspection_data(
    curve: Nurbs, approach: Approach | str = Approach.MINIMAL, digits: int = 20, tick: Callable[[], None] = lambda: None
) -> dict[str, object]:
    """What a curve has as data, its critical points by an approach, each answer under the name of its question (see
    `answer_data`); `tick` is called after every feature.

    Raises `ExactSplineError` for what is neither a plane nor a space curve, and for an unknown approach.
    """
    curve, digits = curve_of(curve), as_integer(digits, "a number of digits", 1)
    if not callable(tick):
        raise ShapeError(f"{a_kind(tick)}, where a function without arguments is expected", remedy="leave it out")
    found = inspect_curve(curve, approach)
    data: dict[str, Any] = {"curve": curve.name, "approach": found.approach, "closed": curve.closed, "digits": digits}
    return data | {name: answer_data(curve, answer, digits, tick) for name, answer in found.answers.items()}


def answer_data(curve: Nurbs, answer: object, digits: int, tick: Callable[[], None] = lambda: None) -> object:
    """The answer to a question as data: points one by one, and the intervals all of whose points are answers; joints;
    pieces, each as the list of its intervals (two where it crosses the seam of a closed curve), planar ones with their
    planes.
    """
    if isinstance(answer, Places):
        points = []
        for f in answer:
            points.append(_feature_data(curve, f, digits))
            tick()
        return {"points": points, "everywhere": list_of(INTERVALS).write(answer.everywhere, digits)}
    if isinstance(answer, Intersections):
        return INTERSECTIONS.write(answer, digits)
    if isinstance(answer, tuple):
        return [_element_data(curve, each, digits) for each in answer]
    return None if answer is None else str(answer)


#: Numbers, points and vectors by their names.
NUMBERS = Form(
    {"type": "object", "additionalProperties": list_of(TEXT).schema},
    lambda values, digits: {name: [str(x) for x in each] for name, each in values.items()},
)


def described_data(found: Described) -> dict[str, object]:
    """A piece with what is said of it: numbers exactly where they are known in closed form."""
    return {
        "kind": str(found.kind),
        "intervals": INTERVALS.write(found.piece, 0),
        "numbers": NUMBERS.write(found.values, 0),
        **found.facts,
    }


def stability_data(curve: Nurbs) -> list[dict[str, object]]:
    """The stability of the features of a curve, with the prominences of the extrema of κ to four digits."""
    least: dict[Real, Real | None] = {found.root: x for found, x in prominences(curve)}
    return [
        described_data(found) | {"prominence": None if (x := least.get(found.place)) is None else f"{x.double():.4g}"}
        for found in analyse(curve).stability
    ]


def _element_data(curve: Nurbs, each: Joint | CurvePiece | Described | tuple[CurvePiece, Plane], digits: int) -> object:
    if isinstance(each, Joint):
        return JOINT.write(_Place(curve, each, knot_root(each.parameter)), digits)
    if isinstance(each, Described):
        return described_data(each)
    return (INTERVALS if isinstance(each, CurvePiece) else PLANAR_PIECE).write(each, digits)


def coordinate_extrema_data(curve: Nurbs, digits: int) -> list[dict[str, object]]:
    """The extrema of coordinates, as data."""
    return [
        _feature_data(curve, f, digits, axis)
        for axis in range(curve.dimension)
        for f in analyse(curve).turning_points(axis)
    ]


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
