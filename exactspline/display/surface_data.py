"""The features of a surface, as data and as a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import prod
from operator import itemgetter
from typing import Any

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.borders import Patch
from exactspline.bivariate.joined_curves import Piece, ZeroComponent
from exactspline.bivariate.zero_curve import Shape
from exactspline.bivariate.zero_lines import ZeroLine
from exactspline.bivariate.zeros import ZeroCurves, ZeroKind, ZeroPlace
from exactspline.display.bisector_data import PARAMETER, control_net
from exactspline.display.features import ends_text
from exactspline.display.forms import (
    ANGLE,
    BOX,
    FLAG,
    INTEGER,
    INTERVAL,
    NUMBERS,
    POINT,
    REAL,
    TEXT,
    Data,
    Form,
    grouped,
    list_of,
    lists,
    one_of,
    or_null,
    pair_of,
    real_text,
    record,
)
from exactspline.display.numbers import decimal, described_surface, shape_text
from exactspline.display.sheet import Sheet
from exactspline.errors import FormulaError, ReachError, counted
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surface_values import LineMeeting, NearestOnSurface
from exactspline.geometry.analysis.surfaces import PatchInspection, PatchKind, SurfaceInspection
from exactspline.geometry.curves import angles
from exactspline.geometry.recognition.patches import RecognizedPart
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.umbilics import NearbyUmbilic
from exactspline.geometry.surfaces.forms import lowest
from exactspline.geometry.surfaces.joints import SurfaceJoint, SurfaceJointKind
from exactspline.geometry.surfaces.ridges import NoDirections, Ridges
from exactspline.geometry.surfaces.singular import Gap, Pole
from exactspline.geometry.surfaces.umbilics import HALF, Umbilic, UmbilicKind
from exactspline.language.formula import Formula
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.numbers.intervals import Box, Interval, hull, joined
from exactspline.polynomials.patch_forms import clusters
from exactspline.reals.real import Real
from exactspline.roots.of_polynomials import Parameter, enclosing
from exactspline.splines.lowest_terms import surface_in_lowest_terms
from exactspline.splines.surface import Along, NurbsSurface
from exactspline.splines.tensor import TensorSpline

#: The common properties of poles along one line.
_PoleKey = tuple[Along, mpq, tuple[mpq, ...] | None, Gap]
#: The index of an umbilic by its kind.
INDEX = {UmbilicKind.NEGATIVE: "-1/2"} | dict.fromkeys(HALF, "1/2")
#: Digits of boxes around points on borders.
DIGITS_OF_BOXES = 6
#: Digits of angles in the table.
DIGITS_OF_ANGLES = 10
#: The description of a patch of a kind.
CURVATURE = {
    PatchKind.ELLIPTIC: "K > 0",
    PatchKind.HYPERBOLIC: "K < 0",
    PatchKind.MIXED: "K has both signs",
    PatchKind.ELLIPTIC_BUT: "K ≥ 0",
    PatchKind.HYPERBOLIC_BUT: "K ≤ 0",
    PatchKind.DEVELOPABLE: "K = 0",
    PatchKind.PLANAR: "K = H = 0",
    PatchKind.CURVE: "no tangent planes",
    PatchKind.POINT: "no tangent planes",
    PatchKind.UNDECIDED: "the sign of K is not decided everywhere",
}


#: Joints of this order of geometric continuity or higher have no row in the table.
SMOOTH = 2
#: Appended to the title of a table when something is undecided.
INCOMPLETE = " – incomplete: see the rows that are undecided"


# ---- data


def _place_data(place: Place, digits: int) -> Data:
    try:
        return {name: PARAMETER.write(t, digits) for name, t in zip("uv", place.spot, strict=True)}
    except ReachError:  # the enclosures contain them in any case
        return {name: REAL.write(t, digits) for name, t in _numbers(place)}


def _numbers(place: Place) -> Iterator[tuple[str, Real]]:
    return zip("uv", place.zero.numbers, strict=True)


def _decimal_between(low: mpq, high: mpq, digits: int) -> str:
    """A decimal between two numbers, with a given number of digits after the point.

    >>> _decimal_between(mpq(1, 3), mpq(1, 3), 4), _decimal_between(mpq(-1, 2), mpq(-1, 2), 3)
    ('0.3333', '-0.5')
    """
    middle = (low + high) / 2
    whole = int((abs(middle) * mpq(10) ** digits + mpq(1, 2)) // 1)
    before, behind = divmod(whole, 10**digits)
    tail = str(behind).rjust(digits, "0").rstrip("0") if digits else ""
    return ("-" if middle < 0 and whole else "") + str(before) + (f".{tail}" if tail else "")


def _hull(piece: Piece) -> Box:
    """A box around the part of a curve on one patch, in the parameters of the surface."""
    boxes = [*(arc.box for arc in piece.part.arcs), *piece.part.cells]
    if boxes:
        return piece.sides.part(hull(boxes))
    spots = [Box(*(enclosing(t, DIGITS_OF_BOXES) for t in spot)) for spot, _ in piece.spots()]
    return hull(spots) if spots else piece.sides


_PATCH = pair_of(INTEGER)
_PATCHES = record(patches=replace(list_of(_PATCH), leaves=lambda found: [("", ", ".join(map(str, found)))]))
_SIDES = BOX.of("sides")
#: A part of a surface all of whose points belong to an answer.
_PART = record(record(patch=_PATCH), _SIDES)
_PLACE = record(Form(record(u=PARAMETER, v=PARAMETER).schema, _place_data, leaves=_numbers), _PATCHES)
_LINE = record(along=one_of(Along), value=PARAMETER, interval=INTERVAL, closed=FLAG, one_sided=FLAG)
_CURVE = record(
    _PATCHES, record(shape=one_of(Shape)), BOX.of(lambda curve: hull(_hull(piece) for piece in curve.pieces))
)
#: Places other than points: the parts of patches all of whose points belong to the answer, and boxes in which something
#: is undecided.
_REST = {"everywhere": list_of(record(_PART, along_curve=FLAG)), "undecided": list_of(BOX)}
_KINDS = {"kind": or_null(one_of(ZeroKind)), "multiplicity": or_null(INTEGER), "where": one_of(ZeroPlace)}
_ZERO = record(u=(REAL, "first"), v=(REAL, "second"), **_KINDS)
#: The form of an answer about a surface, or of one of its elements, by its type.
FORMS: dict[type, Form] = {
    PatchInspection: record(
        _PART,
        kind=one_of(PatchKind),
        minimal=FLAG,
        curvature=or_null(TEXT),
        radius_squared=or_null(TEXT),
        umbilic_everywhere=(FLAG, "umbilics.everywhere"),
        singular_curve=(FLAG, "singular.of_factor.along_curve"),
        curve_of_umbilics=(FLAG, lambda one: one.umbilics.of_factor.along_curve or bool(one.umbilics.edges)),
        undecided=(list_of(BOX), "open_boxes"),
    ),
    Umbilic: record(
        _PLACE.of("place"),
        kind=one_of(UmbilicKind),
        index=(or_null(TEXT), lambda umbilic: INDEX.get(umbilic.kind)),
        one_sided=FLAG,
    ),
    Place: _PLACE,
    RecognizedPart: record(
        record(kind=one_of(ShapeKind)), _PATCHES, whole=FLAG, once=FLAG, numbers=(NUMBERS, "values")
    ),
    NearbyUmbilic: record(_SIDES, robust=FLAG),
    LineMeeting: record(_ZERO.of("zero"), parameter=REAL),
    NearestOnSurface: lists(points=list_of(_PLACE), feet=list_of(POINT), distance=or_null(REAL), **_REST),
    ZeroCurves: lists(lines=list_of(_LINE), curves=list_of(_CURVE), points=list_of(_ZERO), **_REST),
    ZeroLine: _LINE,
    ZeroComponent: _CURVE,
    Pole: record(along=one_of(Along), value=TEXT, interval=INTERVAL, point=or_null(list_of(TEXT)), gap=one_of(Gap)),
    SurfaceJoint: record(
        across=one_of(Along),
        value=TEXT,
        interval=INTERVAL,
        at_seam=FLAG,
        kind=one_of(SurfaceJointKind),
        geometric_continuity=(or_null(INTEGER), "order"),
        angle=ANGLE,
    ),
    Ridges: lists(
        curves=list_of(_CURVE),
        lines=list_of(_LINE),
        everywhere=(list_of(record(_PART.of(itemgetter(0)), curvatures=(INTEGER, itemgetter(1)))), "stationary"),
        undecided=list_of(record(_SIDES, umbilics=INTEGER, singular_points=(INTEGER, "singular"))),
        excluded=list_of(record(_PART.of(itemgetter(0)), kind=(one_of(NoDirections), itemgetter(1)))),
    ),
}


def places_on_surface(element: Form) -> Form:
    """The form of places on a surface: single points, parts of patches all of whose points belong to the answer, and
    boxes in which something is undecided.
    """
    return lists(points=list_of(element), **_REST)


def _extent_of(curve: ZeroComponent) -> Iterator[str]:
    """The approximate extent of a curve."""
    return (_near(side, 2) for side in hull(_extent(piece) for piece in curve.pieces))


def _of_curve(curve: ZeroComponent) -> str:
    return curve.shape.value + (f", across {counted(len(curve.patches), 'patch')}" if len(curve.patches) > 1 else "")


def _extent(piece: Piece) -> Box:
    """The approximate extent of a part of a curve: the hull of points on it."""
    if not piece.part.arcs:
        return _hull(piece)
    points = [point for arc in piece.part.arcs for point in piece.curve.points(arc)]
    return piece.sides.part(hull(Box.point(x, y) for x, y in points))


# ---- the value of a formula


def surface_value_data(formula: Formula, surface: NurbsSurface, name: str) -> Data:
    """The value of a formula on a surface, exactly: a quotient in lowest terms by homogeneous control points ``(w f,
    w)``, a polynomial by its control points.

    >>> from exactspline import example
    >>> from exactspline.papers import find
    >>> data = surface_value_data(find("surfaces:gaussian_curvature"), example("sphere"), "sphere")
    >>> data["degree"], data["homogeneous_control_net"][0][0]
    ([0, 0], ['1', '1'])

    Raises `FormulaError` for a formula that is not about such a surface.
    """
    if surface.dimension not in formula.kind.dimensions or formula.kind.name not in ("surface", "planar map"):
        problem = f"{formula.name} of a surface in R{surface.dimension}"
        raise FormulaError(problem, remedy=f"it is defined for a {formula.kind.name} in R{formula.kind.dimensions[0]}")
    value = surface.remembering().calls(formula)
    if isinstance(value, Rational):
        reduced = surface_in_lowest_terms(value)
        top, bottom = reduced.numerator, reduced.denominator
        splines: list[TensorSpline] = [*(top if isinstance(top, Vector) else [top]), bottom]
        layout = "quotient"
    else:
        parts: list[Any] = list(value) if isinstance(value, Vector) else [value]
        splines = [lowest(f) for f in parts]
        layout = "polynomial"
    return {"name": formula.name, "surface": name, "layout": layout} | control_net(splines)


# ---- a table


def nearby_umbilics_sheet(found: Sequence[NearbyUmbilic], title: str) -> Sheet:
    """The umbilics that all surfaces within ε of a surface have, and those that some of them may have."""
    made = Sheet("umbilics", "u between", "and", "v between", "and", title=title, heads=1)
    for umbilic in found:
        ends = [x for side in umbilic.sides for x in ends_text(side)]
        made.add_row("exactly one" if umbilic.robust else "possibly some", *ends)
    return made


#: The words of a table for the injectivity of the projection to a shape.
COVERED = {True: "injective projection", False: "injectivity not shown"}


def surface_sheet(
    inspection: SurfaceInspection,
    digits: int,
    shapes: Sequence[RecognizedPart] | None = None,
    *,
    with_all: bool = False,
) -> Sheet:
    """The features of a surface, one per row. Its shapes are those within 10⁻⁹ of its size unless others are given.
    Umbilics that a sphere has only because its numbers are rounded are one row, unless all are listed.
    """
    surface = inspection.surface
    closed = f", closed in {' and '.join(along.value for along in inspection.closed)}" if inspection.closed else ""
    title = f"{surface.name}: {described_surface(surface)}{closed}{'' if inspection.complete else INCOMPLETE}"
    made = Sheet("what", "u", "v", "remark", title=title, name=surface.name, prose=["remark"], heads=1)
    for kind, box, remark in _regions(inspection):
        made.add_row(kind, *(str(side) for side in box), remark)
    for part in inspection.shapes if shapes is None else shapes:
        for box in _together(_together(sorted([surface.w.patch(*patch) for patch in part.patches]), 0), 1):
            remark = f"{shape_text(part.shape.numbers, part.within)}, {COVERED[part.once]}"
            made.add_row(str(part.kind), *(str(side) for side in box), remark)
    for line in inspection.parabolic_lines:
        note = ", ".join(["closed"] * line.closed + ["seen from one side only"] * line.one_sided)
        made.add_row("parabolic line", *_line(line.along, line.value, line.interval, digits), note)
    for curve in inspection.parabolic_curves:
        made.add_row("parabolic curve", *_extent_of(curve), _of_curve(curve))
    for place in inspection.parabolic_points:
        made.add_row("parabolic point", *_parameters(place, digits), "K = 0 at this point only")
    below = () if with_all else inspection.umbilics_below_rounding
    if below:
        what = f"{counted(len(below), 'umbilic')} below the rounding"
        why = f"not of all surfaces within {decimal(inspection.rounding, 4)}; --all lists them"
        made.add_row(what, "", "", why)
    for umbilic in [each for each in inspection.umbilics if each not in below]:
        made.add_row("umbilic", *_parameters(umbilic.place, digits), _of_umbilic(umbilic))
    for curve in inspection.umbilic_curves:
        made.add_row("umbilic curve", *_extent_of(curve), _of_curve(curve))
    for place in inspection.singular_points:
        made.add_row("singular point", *_parameters(place, digits), "no tangent plane")
    for curve in inspection.singular_curves:
        made.add_row("singular curve", *_extent_of(curve), f"no tangent plane, {_of_curve(curve)}")
    for (along, value, point, gap), intervals in _poles(inspection):
        note = f"the point ({', '.join(text(x) for x in point)})" if point else "no tangent planes along a curve"
        at = f"{note}, {gap.value}"
        for interval in intervals:
            made.add_row("pole" if point else "singular line", *_line(along, value, interval), at)
    for joint in inspection.joints:
        if joint.order is not None and joint.order < SMOOTH:
            along = Along.V if joint.across is Along.U else Along.U
            made.add_row(joint.kind.value, *_line(along, joint.value, joint.interval), _of_joint(joint))
    _add_open_boxes(made, [box for one in inspection.patches for box in one.open_boxes])
    return made


def _regions(inspection: SurfaceInspection) -> Iterator[tuple[str, Box, str]]:
    """The kinds of patches, each with the rectangle that its patches fill; if they fill no rectangle, patch by
    patch.
    """
    groups = grouped(((one.kind.value, _of_patch(one)), one.sides) for one in inspection.patches)
    for (kind, remark), boxes in groups.items():
        for box in _together(_together(sorted(boxes), 0), 1):
            yield kind, box, remark


def _together(boxes: Sequence[Box], direction: int) -> list[Box]:
    """Boxes with neighbours along a direction joined."""
    joined_boxes: list[Box] = []
    for box in sorted(boxes, key=lambda b: (b[1 - direction], b[direction])):
        last = joined_boxes[-1] if joined_boxes else None
        if last and last[1 - direction] == box[1 - direction] and last[direction][1] == box[direction][0]:
            joined_boxes[-1] = box.with_side(direction, Interval(last[direction].low, box[direction].high))
        else:
            joined_boxes.append(box)
    return joined_boxes


def _of_patch(one: PatchInspection) -> str:
    """The description of a patch."""
    parts = [CURVATURE.get(one.kind, "")]
    if one.curvature:
        parts = [f"K = {text(one.curvature)}" + ("" if one.radius_squared else " everywhere")]
    if one.radius_squared:
        parts.append("every point is an umbilic")
    if one.minimal and one.kind is not PatchKind.PLANAR:
        parts.append("H = 0")
    if one.umbilics.of_factor.along_curve or one.umbilics.edges:
        parts.append("umbilics along a curve")
    if one.singular.of_factor.along_curve:
        parts.append("no tangent planes along a curve")
    return ", ".join(filter(None, parts))


def _of_umbilic(umbilic: Umbilic) -> str:
    index = INDEX.get(umbilic.kind)
    parts = [
        umbilic.kind.value + (f" (index {index.replace('1/2', '½').replace('-', '−')})" if index else ""),
        f"on the border of {counted(len(umbilic.place.patches), 'patch')}" if len(umbilic.place.patches) > 1 else "",
        "seen from some patches only" if umbilic.one_sided else "",
    ]
    return ", ".join(filter(None, parts))


def _of_joint(joint: SurfaceJoint) -> str:
    """The description of a joint."""
    degrees = "" if joint.angle is None else real_text(angles.degrees(joint.angle), DIGITS_OF_ANGLES)
    parts = [
        "at the seam" if joint.at_seam else "at a knot",
        "the surface turns back" if joint.kind is SurfaceJointKind.FOLD else "",
        f"the tangent plane turns by {degrees}°" if degrees else "",
        f"G{joint.order}" if joint.order is not None and joint.order >= 0 else "the sides are different curves",
    ]
    return ", ".join(filter(None, parts))


def _add_open_boxes(made: Sheet, boxes: Sequence[Box]) -> None:
    """Add the boxes in which something is undecided; boxes that touch share a row."""
    for box, cluster in clusters(boxes):
        remark = (
            "not decided here"
            if len(cluster) == 1
            else f"not decided in {counted(len(cluster), 'box')}, which --json lists"
        )
        made.add_row("undecided", *(_near(side, DIGITS_OF_BOXES) for side in box), remark)


def _poles(inspection: SurfaceInspection) -> Iterator[tuple[_PoleKey, list[Interval]]]:
    """Poles along one line, grouped by point."""
    groups = grouped(((pole.along, pole.value, pole.point, pole.gap), pole.interval) for pole in inspection.poles)
    yield from ((key, joined(intervals)) for key, intervals in groups.items())


def _parameters(place: Place, digits: int) -> Iterator[str]:
    return (real_text(t, digits) for t in place.zero.numbers)


def _line(along: Along, value: Parameter, interval: Interval, digits: int = 0) -> tuple[str, str]:
    at = real_text(value, digits)
    return (str(interval), at) if along is Along.U else (at, str(interval))


def _near(side: Interval, digits: int = 4) -> str:
    """An interval by decimals, rounded."""
    a, b = (_decimal_between(x, x, digits) for x in side)
    return f"≈ {a}" if a == b else f"≈ [{a}, {b}]"


# ---- maps of the plane


def map_sheet(inspection: MapInspection) -> Sheet:
    """The sign of a Jacobian determinant as a table, with points that prove it."""
    surface = inspection.surface
    title = f"{surface.name}: {described_surface(surface)}{'' if inspection.complete else INCOMPLETE}"
    made = Sheet("what", "u", "v", "remark", title=title, name=surface.name, prose=["remark"], heads=1)
    made.add_row("map", *(str(side) for side in surface.domain), inspection.kind.value)
    for place, remark in ((inspection.positive, "det > 0"), (inspection.negative, "det < 0")):
        if place and not inspection.regular:
            made.add_row("point", *(text(x) for x in place), remark)
    for zero in inspection.zeros:
        sides = (
            len(zero.patches),
            prod(int(t in mesh.breaks[1:-1]) + 1 for t, mesh in zip(zero.spot, surface.meshes, strict=True)),
        )
        seen = "" if sides[0] == sides[1] else f" as seen from {_patches(zero.patches)}"
        made.add_row("point", *_parameters(zero, DIGITS_OF_BOXES), f"det = 0{seen}")
    for line in inspection.zero_lines:
        note = ", as seen from one side" if line.one_sided else ""
        made.add_row("zero line", *_line(line.along, line.value, line.interval, DIGITS_OF_BOXES), f"det = 0{note}")
    for curve in inspection.zero_curves:
        made.add_row("zero curve", *_extent_of(curve), f"det = 0, {_of_curve(curve)}")
    if not inspection.regular:
        for cusp in inspection.cusps:
            made.add_row("cusp", *_parameters(cusp, DIGITS_OF_BOXES), "det = 0, not a fold")
    _add_open_boxes(made, inspection.undecided)
    return made


def _patches(patches: Sequence[Patch]) -> str:
    return ("patch " if len(patches) == 1 else "patches ") + " and ".join(f"{i}, {j}" for i, j in patches)
