"""The forms of what a curve has, feature by feature, and of curves, by their control points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from enum import StrEnum
from operator import itemgetter
from typing import Any, NamedTuple

from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    TEXT,
    Form,
    Leaf,
    list_of,
    lists,
    one_of,
    optional,
    or_null,
    pair_of,
    record,
)
from exactspline.display.reals import REAL, real_data
from exactspline.errors import ExactSplineError, as_instance
from exactspline.geometry.analysis.curve_values import axes
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves import balls
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.derived.derive import Derived
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval
from exactspline.numbers.sides import Side
from exactspline.reals.real import Real
from exactspline.roots.root import Root, knot_root
from exactspline.roots.values import evaluate, exact_place
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.control_points import Direction
from exactspline.splines.knots import KnotVector
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.nurbs import Nurbs

#: An angle: its cosine and sine, and in degrees.
ANGLE = or_null(record(cosine=REAL, sine=REAL, degrees=(REAL, balls.degrees)))


def by_name(form: Form) -> Form:
    """The form of values by their names."""

    def leaves(values: Mapping[str, Any]) -> Iterator[Leaf]:
        for name, value in values.items():
            yield from ((f"{name} {inner}".strip(), each) for inner, each in form.leaves(value))

    return Form(
        {"type": "object", "additionalProperties": form.schema},
        lambda values, digits: {name: form.write(value, digits) for name, value in values.items()},
        leaves=leaves,
    )


#: Numbers, points and vectors by their names.
NUMBERS = by_name(list_of(REAL))
#: A point by its coordinates.
POINT = replace(list_of(REAL), leaves=lambda point: zip(axes(len(point)), point, strict=True))


class Located(NamedTuple):
    """A feature or a joint of a curve, with the joint there where there is one, and of an extremum of a coordinate
    which.
    """

    curve: Nurbs
    of: Feature | Joint
    root: Root
    joint: Joint | None = None
    coordinate: int | None = None
    below_rounding: bool | None = None

    @property
    def point(self) -> tuple[mpq | Real, ...] | None:
        """The point there; None at infinity."""
        with suppress(ExactSplineError):
            return evaluate(self.curve, exact_place(self.root))
        return None

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
    facts = analyse(curve)
    joint = facts.joint(of.root.low) if of.at_knot else None
    return Located(curve, of, of.root, joint, coordinate, facts.below_rounding(of) or None)


def _limits(quantity: Callable[[Nurbs, Root, Side], Real]) -> tuple[Form, Callable[[Located], list[Real] | None]]:
    """The value of a quantity at a place, or its limits from both sides; empty where it has none."""

    def found(at: Located) -> list[Real] | None:
        if isinstance(at.of, Feature) and at.of.kind.is_singular:
            return None
        try:
            return at.values(quantity)
        except ExactSplineError:
            return []

    return optional(list_of(REAL, 0, 2)), found


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
    point=or_null(POINT),
    multiplicity=(INTEGER, "root.multiplicity"),
    curvature=_CURVATURE,
    torsion=(_TORSION[0], lambda at: None if at.curve.dimension < 3 else _TORSION[1](at)),
    coordinate=optional(INTEGER),
    below_rounding=optional(FLAG),
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
INTERVALS = replace(list_of(INTERVAL, 1).of("parts"), leaves=INTERVAL.leaves)
PLANAR_PIECE = record(intervals=(INTERVALS, itemgetter(0)), plane=(TEXT, itemgetter(1)))

#: Numbers by their names, with what they are numbers of.
NAMED_NUMBERS = record(what=TEXT, values=by_name(REAL), facts=by_name(Form({"type": ["integer", "string"]})))
NEAREST_POINT = record(parameter=REAL, distance=REAL, point=POINT)


def described_form(kinds: type[StrEnum], *facts: str) -> Form:
    """The form of a piece with what is said of it."""
    said = record(**{name: (FLAG, itemgetter(name)) for name in facts}).of("facts")
    return record(record(kind=one_of(kinds), intervals=(INTERVALS, "piece"), numbers=(NUMBERS, "values")), said)


# ---- curves and functions by their control points


class Net(NamedTuple):
    """The knots and the control points of functions over common knots: with a denominator ``w`` these are homogeneous,
    ``(w x, w y, w)``; the interval where they are a piece of something.
    """

    degree: int
    knots: KnotVector
    control_points: list[tuple[mpq, ...]]
    homogeneous: bool
    interval: Interval | None = None

    @classmethod
    def of(cls, value: SplineVector | Rational[BSpline] | BSpline, interval: Interval | None = None) -> Net:
        """The net of a function, a vector of functions, or a quotient."""
        homogeneous = isinstance(value, Rational)
        parts = [*value.elevated()] if isinstance(value, Rational) else [value]
        flat = [f for part in parts for f in (part if isinstance(part, Vector) else [part])]
        raised = with_common_knots(flat)
        points = zip(*[f.control_points for f in raised], strict=True)
        return cls(raised[0].degree, raised[0].knots, [*points], homogeneous, interval)


class ControlPoint(NamedTuple):
    """A control point of a curve, or a direction, with its weight."""

    kind: str
    point: tuple[mpq, ...]
    weight: mpq


_KNOTS = list_of(REAL)
#: Functions by their control points.
SPLINE = lists(
    interval=optional(INTERVAL), degree=INTEGER, homogeneous=FLAG, knots=_KNOTS, control_points=list_of(list_of(REAL))
)
#: A curve by its control points.
CURVE = lists(
    degree=INTEGER,
    knots=_KNOTS,
    control_points=(
        list_of(record(kind=TEXT, point=POINT, weight=REAL)),
        lambda curve: [
            ControlPoint("direction" if isinstance(point, Direction) else "control point", tuple(point), weight)
            for point, weight in zip(curve.control_points, curve.weights, strict=True)
        ],
    ),
)
#: A derived curve piece by piece; where it is missing; its poles.
DERIVED = lists(
    pieces=list_of(SPLINE.of(lambda piece: Net.of(piece.value, piece.interval))),
    missing=list_of(record(interval=(INTERVAL, itemgetter(0)), reason=(TEXT, lambda missing: missing[1].words))),
    poles=list_of(REAL),
)


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
    net = Net.of(value)
    kind = "rational" if net.homogeneous else "polynomial" if isinstance(value, Vector) else "function"
    points = [[str(x) for x in row] for row in net.control_points]
    return {
        "interval": [str(t) for t in interval],
        "kind": kind,
        "degree": net.degree,
        "knots": [str(t) for t in net.knots],
        "homogeneous_control_points" if net.homogeneous else "control_points": (
            [x for row in points for x in row] if kind == "function" else points
        ),
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
