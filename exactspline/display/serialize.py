"""The forms of single features of a curve, and of curves by their control points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from enum import StrEnum
from operator import itemgetter
from typing import Any, NamedTuple

from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    REAL,
    TEXT,
    Data,
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
from exactspline.errors import ExactSplineError, as_instance
from exactspline.geometry.analysis.curve_values import axes
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.curves import angles
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind
from exactspline.geometry.derived.derive import Derived
from exactspline.interchange.curve_files import curve_data
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Interval, Side
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
ANGLE = or_null(record(cosine=REAL, sine=REAL, degrees=(REAL, angles.degrees)))


def _by_name(form: Form) -> Form:
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
NUMBERS = _by_name(list_of(REAL))
#: A point by its coordinates.
POINT = replace(list_of(REAL), leaves=lambda point: zip(axes(len(point)), point, strict=True))


class Located(NamedTuple):
    """A feature or a joint of a curve. A feature at a joint comes with the joint, and an extremum of a coordinate with
    the number of the coordinate.
    """

    curve: Nurbs
    of: Feature | Joint
    root: Root
    joint: Joint | None = None
    coordinate: int | None = None
    below_rounding: bool | None = None

    @property
    def point(self) -> tuple[mpq | Real, ...] | None:
        """The point of the curve at the feature; None at infinity."""
        with suppress(ExactSplineError):
            return evaluate(self.curve, exact_place(self.root))
        return None

    def values(self, quantity: Callable[[Nurbs, Root, Side], Real]) -> list[Real]:
        """The value of κ or τ at the feature, or at a knot the limits from both sides if they differ. Raises an
        `ExactSplineError` if there is no value.
        """
        if self.joint is None:
            return [quantity(self.curve, self.root, Side.RIGHT)]
        sides = zip(analyse(self.curve).sides(self.root.low), Side, strict=True)
        left, right = (quantity(self.curve, knot_root(t), side) for t, side in sides)
        return [left] if left == right else [left, right]


def located(curve: Nurbs, of: Feature | Joint, coordinate: int | None = None) -> Located:
    """A feature or a joint with everything that a table shows about it."""
    if isinstance(of, Joint):
        return Located(curve, of, knot_root(of.parameter), of)
    facts = analyse(curve)
    joint = facts.joint(of.root.low) if of.at_knot else None
    return Located(curve, of, of.root, joint, coordinate, facts.below_rounding(of) or None)


def _limits(quantity: Callable[[Nurbs, Root, Side], Real]) -> tuple[Form, Callable[[Located], list[Real] | None]]:
    """The value of a quantity at a place, or its limits from both sides; empty if it has none."""

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
#: A feature: its parameter, κ (and in space τ) at the feature if γ′ ≠ 0, and the angle of a corner.
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

#: Numbers by their names, with the object that they describe.
NAMED_NUMBERS = record(what=TEXT, values=_by_name(REAL), facts=_by_name(Form({"type": ["integer", "string"]})))
NEAREST_POINT = record(parameter=REAL, distance=REAL, point=POINT)


def described_form(kinds: type[StrEnum], *facts: str) -> Form:
    """The form of a piece with its description."""
    said = record(**{name: (FLAG, itemgetter(name)) for name in facts}).of("facts")
    return record(record(kind=one_of(kinds), intervals=(INTERVALS, "piece"), numbers=(NUMBERS, "values")), said)


# ---- curves and functions by their control points


class Net(NamedTuple):
    """The knots and the control points of functions over common knots, and the interval if the functions are a piece of
    an object. Control points of a quotient are homogeneous: ``(w x, w y, …, w)``, of a scalar quotient ``(w f, w)``.
    """

    kind: str
    degree: int
    knots: KnotVector
    points: list[tuple[mpq, ...]]
    interval: Interval | None = None

    @classmethod
    def of(cls, value: SplineVector | Rational[BSpline] | BSpline, interval: Interval | None = None) -> Net:
        """The net of a function, a vector of functions, or a quotient."""
        rational = isinstance(value, Rational)
        parts = [*value.elevated()] if isinstance(value, Rational) else [value]
        flat = [f for part in parts for f in (part if isinstance(part, Vector) else [part])]
        raised = with_common_knots(flat)
        kind = "rational" if rational else "polynomial" if isinstance(value, Vector) else "function"
        points = zip(*[f.control_points for f in raised], strict=True)
        return cls(kind, raised[0].degree, raised[0].knots, [*points], interval)

    @property
    def homogeneous_control_points(self) -> list[tuple[mpq, ...]] | None:
        """The control points of a quotient, None for polynomials."""
        return self.points if self.kind == "rational" else None

    @property
    def control_points(self) -> Sequence[object] | None:
        """The control points of polynomials (numbers for a single function); None for a quotient."""
        if self.kind == "rational":
            return None
        return [x for (x,) in self.points] if self.kind == "function" else self.points


class _ControlPoint(NamedTuple):
    """A control point of a curve, or a direction, with its weight."""

    kind: str
    point: tuple[mpq, ...]
    weight: mpq


_KNOTS = list_of(TEXT)
_ROWS = list_of(_KNOTS)
_EITHER = Form({"type": "array", "items": {"type": ["string", "array"], "items": TEXT.schema}})
#: Functions by their control points, as a file of curves may have them, too.
SPLINE = replace(
    record(
        interval=optional(INTERVAL),
        kind=Form({"enum": ["rational", "polynomial", "function"]}),
        degree=INTEGER,
        knots=_KNOTS,
        homogeneous_control_points=optional(_ROWS),
        control_points=optional(_EITHER),
    ),
    elements=lists(degree=INTEGER, knots=_KNOTS, control_points=(_ROWS, "points")).elements,
    divided=True,
)
#: A curve by its control points, as in a file of curves.
CURVE = replace(
    lists(
        degree=INTEGER,
        knots=_KNOTS,
        control_points=(
            list_of(record(kind=TEXT, point=POINT, weight=REAL)),
            lambda curve: [
                _ControlPoint("direction" if isinstance(point, Direction) else "control point", tuple(point), weight)
                for point, weight in zip(curve.control_points, curve.weights, strict=True)
            ],
        ),
    ),
    schema=record(
        degree=INTEGER,
        knots=_KNOTS,
        control_points=Form({"type": "array", "items": {"anyOf": [_KNOTS.schema, record(vector=_KNOTS).schema]}}),
        **dict.fromkeys(("name", "source", "note"), optional(TEXT)),
        weights=optional(_KNOTS),
    ).schema,
    write=lambda curve, digits: curve_data(curve),
)
#: A derived curve piece by piece, with the intervals on which it is missing, and its poles.
DERIVED = lists(
    pieces=list_of(SPLINE.of(lambda piece: Net.of(piece.value, piece.interval))),
    missing=list_of(record(interval=(INTERVAL, itemgetter(0)), reason=(TEXT, lambda missing: missing[1].words))),
    poles=list_of(REAL),
)


def derived_data(derived: Derived, curve: str) -> Data:
    """Return the JSON data of a derived object: the control points of each piece, as exact text.

    A quotient is given by homogeneous control points ``(w x, w y, …, w)``, a scalar quotient by ``(w f, w)``.
    """
    derived = as_instance(derived, Derived, "a derived object", "give the result of exactspline.derive")
    layout = "directrix, generator" if derived.ruled else ""
    head = {"name": derived.name, "variant": derived.variant, "curve": curve, "layout": layout}
    data: Data = head | DERIVED.write(derived, 20)
    return data
