"""Forms of data. A form contains the way in which an object is written for programs, the JSON Schema of this text, and
the numbers and words, with their names, for tables and data frames. The forms of single features of a curve, and of
curves by their control points, are here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import Enum, StrEnum
from operator import attrgetter, itemgetter
from typing import Any, NamedTuple, TypeVar, cast

from exactspline.display.numbers import decimal
from exactspline.errors import ExactSplineError, OpenError, ReachError, as_instance
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
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Interval, Side
from exactspline.reals.real import Real, real
from exactspline.roots.root import Root, knot_root
from exactspline.roots.values import evaluate, exact_place
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.control_points import Direction
from exactspline.splines.knots import KnotVector
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.nurbs import Nurbs

# ---- data


Data = dict[str, object]
K = TypeVar("K")
V = TypeVar("V")


def plain(value: object) -> object:
    """A value of JSON.

    >>> plain((mpq(1, 2), [None, True], "x"))
    ['1/2', [None, True], 'x']
    """
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, type(mpq())):
        return text(value)
    return [plain(each) for each in value] if isinstance(value, (tuple, list, KnotVector)) else value


def grouped(pairs: Iterable[tuple[K, V]]) -> dict[K, list[V]]:
    """The second parts of pairs, by their first parts.

    >>> grouped([("arc", 1), ("pair", 2), ("arc", 3)])
    {'arc': [1, 3], 'pair': [2]}
    """
    groups: dict[K, list[V]] = {}
    for key, value in pairs:
        groups.setdefault(key, []).append(value)
    return groups


def picked(of: object, *names: str) -> Data:
    """Some attributes of an object by name; ``a.b`` is given as ``b``.

    >>> picked(mpq(1, 2), "numerator", "denominator")["denominator"]
    mpz(2)
    """
    return {name.rpartition(".")[2]: plain(attrgetter(name)(of)) for name in names}


Schema = dict[str, object]
#: The way in which a value is found in an object: the path of an attribute, or a function.
Source = str | Callable[..., object]
#: A number or a word with its name.
Leaf = tuple[str, object]


@dataclass(frozen=True)
class Form:
    """The form of a value: its ``schema``, and the function ``write``, which takes the value and the number of digits
    of irrational numbers. A field of an ``optional`` form is omitted from an object if its value is None.

    ``leaves`` yields the numbers and words of a value with their names; by default the value itself without a name.
    ``elements`` yields the elements of a list, or of an object of lists (`lists`): the name of the list, the form of
    its elements, and the element. With ``divided``, an object of lists is divided into its elements even if it is an
    element itself.
    """

    schema: Schema
    write: Callable[[Any, int], Any] = lambda value, digits: plain(value)
    optional: bool = False
    leaves: Callable[[Any], Iterable[Leaf]] = lambda value: () if value is None else (("", value),)
    elements: Callable[[Any], Iterable[tuple[str, Form, Any]]] | None = None
    divided: bool = False

    def of(self, source: Source) -> Form:
        """The form of an object of which only one value is written: `source` finds the value in the object."""
        take = attrgetter(source) if isinstance(source, str) else source
        elements = self.elements
        return replace(
            self,
            write=lambda of, digits: self.write(take(of), digits),
            leaves=lambda of: self.leaves(take(of)),
            elements=elements and (lambda of: elements(take(of))),
        )


def _exactly(value: object, digits: int) -> str:
    return text(value) if isinstance(value, int | type(mpq())) else str(value)


def word(value: object) -> str:
    """A value other than a number, as text.

    >>> word(True), word((1, 2))
    ('yes', '(1, 2)')
    """
    return ("yes" if value else "no") if isinstance(value, bool) else str(value)


TEXT = Form({"type": "string"}, _exactly)
FLAG = Form({"type": "boolean"})
INTEGER = Form({"type": "integer"})


def list_of(form: Form, least: int = 0, most: int | None = None) -> Form:
    """The form of a list.

    >>> list_of(TEXT).write((mpq(1, 2), 3), 20)
    ['1/2', '3']
    """
    schema: Schema = {"type": "array", "items": form.schema, "minItems": least}

    def leaves(x: Iterable[Any]) -> Iterator[Leaf]:
        each = [[*form.leaves(one)] for one in x]
        if any(name or isinstance(value, Real | type(mpq())) for one in each for name, value in one):
            for i, one in enumerate(each, 1):
                yield from ((f"{i} {name}".strip() if len(each) > 1 else name, value) for name, value in one)
        elif each:
            yield "", f"({', '.join(word(value) for one in each for _, value in one)})"

    return Form(
        schema | ({} if most is None else {"maxItems": most}),
        lambda x, digits: [form.write(each, digits) for each in x],
        leaves=leaves,
        elements=lambda x: (("", form, each) for each in x),
    )


def pair_of(form: Form) -> Form:
    """The form of a list of two."""
    return list_of(form, 2, 2)


def or_null(form: Form) -> Form:
    """The form of a value that may be None."""
    return replace(
        form,
        schema={"anyOf": [form.schema, {"type": "null"}]},
        write=lambda x, digits: None if x is None else form.write(x, digits),
        leaves=lambda x: () if x is None else form.leaves(x),
        elements=None,
    )


def optional(form: Form) -> Form:
    """The form of a field that is omitted if its value is None."""
    return replace(or_null(form), schema=form.schema, optional=True)


def one_of(kinds: type[Enum]) -> Form:
    """The form of a member of an enumeration."""
    return Form({"enum": [kind.value for kind in kinds]})


def record(*parts: Form, **fields: Form | tuple[Form, Source]) -> Form:
    """The form of an object with the fields of other forms and with the given fields. The value of a field is the
    attribute of its name, unless a source is given.

    >>> form = record(size=(INTEGER, "numerator"), denominator=TEXT)
    >>> form.write(mpq(1, 2), 20), form.schema["required"]
    ({'size': mpz(1), 'denominator': '2'}, ['size', 'denominator'])
    >>> dict(form.leaves(mpq(1, 2)))
    {'size': mpz(1), 'denominator': mpz(2)}
    """
    found = {name: field if isinstance(field, tuple) else (field, name) for name, field in fields.items()}
    forms = {name: form.of(source) for name, (form, source) in found.items()}
    properties: Schema = {}
    required: list[str] = []
    for part in parts:
        properties |= cast(Schema, part.schema["properties"])
        required += cast("list[str]", part.schema["required"])
    properties |= {name: form.schema for name, form in forms.items()}
    required += [name for name, form in forms.items() if not form.optional]

    def write(of: Any, digits: int) -> Data:
        data: Data = {}
        for part in parts:
            data |= part.write(of, digits)
        for name, form in forms.items():
            value = form.write(of, digits)
            if value is not None or not form.optional:
                data[name] = value
        return data

    def leaves(of: Any) -> Iterator[Leaf]:
        for part in parts:
            yield from part.leaves(of)
        for name, form in forms.items():
            # the names 1 and 2 of the parts of a pair need the name of the pair, cosine and sine do not
            yield from (
                (inner if inner[:1].isalpha() else f"{name} {inner}".strip(), x) for inner, x in form.leaves(of)
            )

    return Form(
        {"type": "object", "required": required, "additionalProperties": False, "properties": properties},
        write,
        leaves=leaves,
    )


def lists(**fields: Form | tuple[Form, Source]) -> Form:
    """The form of an object with lists, and with further fields about them.

    >>> form = lists(factors=(list_of(TEXT), lambda n: [2, 3]), value=(INTEGER, lambda n: n))
    >>> [(name, each) for name, _, each in form.elements(6)]
    [('', 6), ('factors', 2), ('factors', 3)]
    """
    found = {name: field if isinstance(field, tuple) else (field, name) for name, field in fields.items()}
    forms = {name: form.of(source) for name, (form, source) in found.items()}
    beside = record(**{name: fields[name] for name, form in forms.items() if form.elements is None})

    def elements(of: Any) -> Iterator[tuple[str, Form, Any]]:
        if beside.schema["properties"]:
            yield "", beside, of
        for name, form in forms.items():
            for _, element, each in form.elements(of) if form.elements else ():
                yield name, element, each

    return replace(record(**fields), elements=elements, divided=True)


INTERVAL = Form(pair_of(TEXT).schema, pair_of(TEXT).write)
#: A rectangle of parameters.
BOX = record(u=(INTERVAL, "first"), v=(INTERVAL, "second"))


# ---- real numbers


#: Characters of an exact number that a table shows.
READABLE = 14
#: Digits of a number in a table.
DIGITS = 12


def real_data(x: Real | mpq, digits: int) -> Data:
    """A number: its closed form, two rational bounds, and the correctly rounded double. The closed form is given for a
    rational number, for ``a + b√c``, and for known multiples of π and angles; it is null if the number is proved to be
    neither rational nor ``a + b√c``, with ``open`` if that is not decided. The double is null for a number that is too
    large, or whose enclosures do not determine it.

    >>> real_data(mpq(1, 3), 20)
    {'exact': '1/3', 'low': '1/3', 'high': '1/3', 'double': 0.3333333333333333}
    """
    number = real(x)
    # the closed form first: a number that turns out to be rational has equal bounds
    form, (low, high) = closed_form_data(number), number.around(digits + 1)
    return {**form, "low": text(low), "high": text(high), "double": double_of(number)}


def double_of(x: Real) -> float | None:
    """The correctly rounded double; None for a number that is too large, or whose enclosures do not determine it.

    >>> double_of(Real("1/3")), double_of(Real(10) ** 400)
    (0.3333333333333333, None)
    """
    try:
        return x.double()
    except (ExactSplineError, OverflowError):
        return None


def closed_form_data(x: Real) -> Data:
    """The closed form of a number, null if it is proved to have none; with ``open`` if that is not decided.

    >>> from exactspline.reals.real import square_root
    >>> closed_form_data(square_root(8)), closed_form_data(square_root(2) + square_root(3))
    ({'exact': '2√2'}, {'exact': None})
    """
    try:
        return {"exact": x.closed_form}
    except (ReachError, OpenError):
        return {"exact": None, "open": True}


#: A real number.
REAL = Form(
    record(
        exact=or_null(TEXT), open=optional(FLAG), low=TEXT, high=TEXT, double=or_null(Form({"type": "number"}))
    ).schema,
    real_data,
)


def real_text(x: Real | mpq, digits: int = DIGITS) -> str:
    """A number in a table: in closed form if that is short, otherwise to this many significant digits.

    >>> from exactspline.reals.real import square_root
    >>> real_text(mpq(1, 3)), real_text(square_root(2) + square_root(3), 5)
    ('1/3', '3.1463')
    """
    number = real(x)
    exact = closed_form_data(number)["exact"]
    if isinstance(exact, str) and len(exact) <= max(READABLE, digits + 2):
        return exact
    value = number.rational_near(digits + 8)
    return decimal(value, digits) if value else "0"


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
    return cast(Data, head | DERIVED.write(derived, 20))
