"""The features of a curve as tables."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import cast

from exactspline.display import console
from exactspline.display.forms import DIGITS, READABLE, Located, closed_form_data, located, real_text
from exactspline.display.numbers import decimal, described, readable, rounded_down, shape_text
from exactspline.display.sheet import Sheet
from exactspline.errors import ExactSplineError, counted
from exactspline.geometry.analysis.curves import QUESTIONS, questions_about
from exactspline.geometry.analysis.inspection import Report
from exactspline.geometry.curves import angles
from exactspline.geometry.curves import values as values_along
from exactspline.geometry.curves.angles import Angle
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature, FeatureKind, JointKind, kind_name
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.geometry.rounded.features import NearbyFeature
from exactspline.geometry.rounded.intersections import NearbyMeeting
from exactspline.geometry.rounded.stability import StableFeature
from exactspline.numbers.exact import decimal_unit, mpq, text
from exactspline.numbers.intervals import Interval, Side
from exactspline.questions.entry import Answered
from exactspline.reals.real import Real
from exactspline.roots.answers import CurvePiece
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs

#: Words in remarks that are explained below the table.
REMARKS = (
    "maximum of |κ|",
    "minimum of |κ|",
    "by a jump of κ′",
    "by a jump of κN",
    "by a jump of κ",
    "by a jump of τ",
    "at the seam",
    "turns by",
)


def feature_sheet(report: Report, digits: int = DIGITS) -> Sheet:
    """The features of a curve, one per row; a parameter is shown exactly if that is short. Features that a circle has
    only because its numbers are rounded (`Analysis.below_rounding`) are one row, unless the report lists all.
    """
    c = report.curve
    closed = ", closed" if c.closed else ""
    columns = ("what", "parameter", "curvature", *["torsion"] * (c.dimension == 3), "remark")
    title = f"{c.name}: {described(c)}{closed}"
    made = Sheet(*columns, title=title, name=c.name, prose=["remark"], lists=columns[1:-1])
    for kind, where, values, remark in _rows(report, digits):
        made.add_row(kind, where, *(values + [""] * 2)[: len(columns) - 3], remark)
    return made


#: A row of the table: the kind, the place, curvature and torsion, and the remark.
_Row = tuple[str, str, list[str], str]


def _rows(report: Report, digits: int) -> Iterator[_Row]:
    c, facts = report.curve, report.analysis
    found = [f for name in _asked(c, Answered.PLACES) for f in report.places(name)]
    shown = [f for f in found if report.with_all or not facts.below_rounding(f)]
    shapes: list[_Row] = [
        (str(each.kind), _piece_text(each.piece, digits), [], shape_text(each.shape.numbers, each.within))
        for each in report.shapes
        # exact lines are among the straight pieces
        if each.kind is not ShapeKind.LINE or each.within
    ]
    if below := len(found) - len(shown):
        yield from shapes
        why = f"not of all curves within {decimal(facts.rounding, 4)}; --all lists them"
        yield f"{counted(below, 'feature')} below the rounding", "", [], why
    yield from (_feature_row(located(c, f), digits) for f in shown)
    for axis, places in zip("xyz", report.coordinate_extrema, strict=False):
        for f in places:
            curvature = [_values(located(c, f), values_along.curvature, digits)]
            yield f"{f.kind} of {axis}", real_text(f.root, digits), curvature, "at a knot" * f.at_knot
    for joint in report.joints:
        # singular joints are among the singular points
        if joint.kind in (JointKind.GAP, JointKind.CORNER, JointKind.TURN, JointKind.CURVATURE_JUMP):
            both = [] if joint.curvatures is None else [" | ".join(real_text(x, digits) for x in joint.curvatures)]
            yield str(joint.kind), real_text(joint.parameter, digits), both, _remark(joint, digits)
    for name in _asked(c, Answered.PAIRS):
        yield from _own_intersections(cast(Intersections, report.answers[name]), digits)
    for name in _asked(c, Answered.PIECES):
        for piece in report.pieces(name):
            yield QUESTIONS[name].about.of_piece, _piece_text(piece, digits), [], ""
    yield from [] if below else shapes
    for piece, plane in report.analysis.planar_pieces:
        yield QUESTIONS["planar_pieces"].about.of_piece, _piece_text(piece, digits), [], f"in the plane {plane}"


def _piece_text(piece: CurvePiece, digits: int) -> str:
    return " ∪ ".join(f"[{real_text(a, digits)}, {real_text(b, digits)}]" for a, b in piece.parts)


def _feature_row(at: Located, digits: int) -> _Row:
    f, in_space = at.of, at.curve.dimension == 3
    assert isinstance(f, Feature)  # it is no joint
    absolute = f"{f.of_absolute} of |κ|" if f.of_absolute and not in_space else ""
    jumps = f", by a jump of {_jumping(f.kind, in_space)}" if f.by_jump else ""
    at_knot = f"at a knot{jumps}" if f.at_knot or jumps else ""
    turn = _turn(at.joint.angle, digits) if at.joint else ""
    quantities = (values_along.curvature, values_along.torsion)[: at.curve.dimension - 1]
    values = [] if f.kind.is_singular else [_values(at, quantity, digits) for quantity in quantities]
    return kind_name(f.kind), real_text(at.root, digits), values, " ".join(filter(None, (absolute, at_knot, turn)))


def _values(at: Located, quantity: Callable[[Nurbs, Root, Side], Real], digits: int) -> str:
    """The value of a quantity, or at a knot the limits from both sides if they differ, or the reason why it has
    none.
    """
    try:
        return " | ".join(real_text(x, digits) for x in at.values(quantity))
    except ExactSplineError as error:
        return str(error)


def _own_intersections(found: Intersections, digits: int) -> Iterator[_Row]:
    for point in found:
        both = " and ".join(real_text(x, digits) for x in (point.first, point.second))
        yield "self-intersection", both, [], str(point.kind)
    for what in found.undecided:
        yield "not decided", "", [], f"self-intersections: {what}"
    for arc in found.everywhere:
        ends = (", ".join(real_text(x, digits) for x in side) for side in (arc.first, arc.second))
        yield "runs over itself", " and ".join(f"[{each}]" for each in ends), [], "reversed" * arc.reversed


def _jumping(kind: FeatureKind, in_space: bool) -> str:
    """The quantity that changes its sign at a feature of a kind."""
    if kind in (FeatureKind.MAXIMUM, FeatureKind.MINIMUM):
        return "κ′"
    return "τ" if kind is FeatureKind.TORSION_ZERO else "κN" if in_space else "κ"


def words_of(report: Report, tables: Sequence[Sheet]) -> list[str]:
    """The words in the tables of a curve (the first one is that of its features) and in the lines below them, for the
    glossary.
    """
    words = [word for table in tables for word in (*table.columns[1:], *table.tags)]
    remarks = [row[-1] for row in tables[0].rows]
    # κ is not κ′, nor κN
    words += [word for word in REMARKS if any(re.search(rf"{re.escape(word)}(?![′N])", each) for each in remarks)]
    orders = {joint.order for joint in report.joints if joint.order is not None and joint.order >= 0}
    return words + [f"G{order}" for order in sorted(orders)]


def _asked(c: Nurbs, answered: Answered) -> list[str]:
    """The questions about a curve whose answers consist of the same kind of things and are shown."""
    shown = {name: entry.about for name, entry in questions_about(c).items()}
    return [name for name, about in shown.items() if about.answered == answered and about.reported]


def report_sheets(report: Report, digits: int = DIGITS) -> list[Sheet]:
    """The table of features, and the tables below it; a table of common points only if there are any."""
    below = []
    if report.within is not None:
        below = [_nearby_sheet(report), *[_meetings_sheet(report)] * bool(report.meetings)]
    if report.with_stability:
        below.append(_stability_sheet(report))
    return [feature_sheet(report, digits), *below]


def print_features(report: Report, tables: Sequence[Sheet]) -> None:
    """Print the tables, the numbers of joints, and the plane of a curve."""
    out, c, (made, *below) = console.console(), report.curve, tables
    if made.rows:
        out.print(made)
    else:
        nothing = ", ".join("no " + name.replace("_", " ") for name in ("corners", *_asked(c, Answered.PLACES)))
        console.lines(out, f"{c.name}: {nothing}")
    if report.joints:
        console.lines(out, _continuity(report.joints))
    if plane := report.answers.get("plane"):
        reason = "it has no torsion, no focal curve and no osculating spheres"
        console.lines(out, f"{c.name} lies in the plane {plane}: {reason}")
    for sheet in below:
        out.print()
        out.print(sheet)


def _turn(angle: Angle | None, digits: int) -> str:
    """The angle by which the tangent turns, as text."""
    if angle is None:
        return ""
    exact = [closed_form_data(x)["exact"] for x in (angle.cosine, angle.sine)]
    is_short = all(isinstance(x, str) and len(x) <= READABLE for x in exact)
    exactly = f" (cos = {exact[0]}, sin = {exact[1]})" if is_short else ""
    return f"turns by {real_text(angles.degrees(angle), digits)}°{exactly}".replace("-", "−")


def _remark(joint: Joint, digits: int) -> str:
    """The gap, the angle and the order of a joint, as text."""
    parts = [
        "at the seam" if joint.at_seam else "at a knot",
        _turn(joint.angle, digits),
        f"{real_text(joint.gap, digits)} wide" if joint.gap is not None else "",
        f"G{joint.order}" if joint.order is not None and joint.order >= 0 else "",
    ]
    return ", ".join(filter(None, parts)).replace("-", "−")


def _nearby_sheet(report: Report) -> Sheet:
    """The features that all curves within ε of a curve have, and those that some of them may have."""
    title = f"All curves within {readable(report.epsilon)} of {report.curve.name}"
    made = Sheet("what", "each has", "between", "and", title=title, heads=2)
    for found in sorted(report.nearby, key=_order):
        number = ("exactly one" if found.single else "at least one") if found.robust else "possibly some"
        made.add_row(kind_name(found.kind), number, *ends_text(found.place))
    return made


def _meetings_sheet(report: Report) -> Sheet:
    """The places where all curves within ε of a curve meet themselves, and where some of them may."""
    title = f"All curves within {readable(report.epsilon)} of {report.curve.name} and themselves"
    return common_points_sheet(report.meetings, title)


def common_points_sheet(meetings: Iterable[NearbyMeeting], title: str) -> Sheet:
    """The common points of all pairs of curves within ε of two curves, and those that some of these pairs may have."""
    made = Sheet("common points", "s between", "and", "t between", "and", title=title, heads=1)
    for found in meetings:
        number = "exactly one" if found.robust else "possibly some"
        made.add_row(number, *ends_text(found.first), *ends_text(found.second))
    return made


def _stability_sheet(report: Report) -> Sheet:
    """The changes of a curve up to which its features persist, and changes that destroy them."""
    title = f"Stability of the features of {report.curve.name}"
    columns = ("what", "at", "stable up to", "destroyed by", "ratio", "prominence")
    made = Sheet(*columns, title=title, heads=1, numbers=["stable up to"])
    for found, prominence in sorted(report.stable, key=lambda pair: _order(pair[0])):
        # stability for a distance is stability for smaller ones; a change that destroys a feature is within larger ones
        certain = decimal(rounded_down(found.radius, 4), 4) if found.radius else "not proved"
        gone = "not known" if found.gone is None else decimal(-rounded_down(-found.gone, 4), 4)
        times = f"{round(float(found.gone / found.radius))} ×" if found.gone and found.radius else ""
        least = "" if prominence is None else f"{prominence.double():.4g}"
        made.add_row(kind_name(found.kind), real_text(found.place), certain, gone, times, least)
    return made


def _order(found: NearbyFeature | StableFeature) -> int:
    """The place of a kind in the order of the first table: inflections, extrema of the curvature, corners."""
    extrema = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM, FeatureKind.STATIONARY)
    return 2 if found.kind is FeatureKind.CORNER else int(found.kind in extrema)


def ends_text(interval: Interval) -> tuple[str, str]:
    """The ends of an interval, rounded outwards to a few digits.

    >>> ends_text(Interval(mpq(1, 7), mpq(1, 7))), ends_text(Interval(mpq(1000000, 3000001), mpq(1000001, 3000000)))
    (('1/7', '1/7'), ('0.333333222222', '0.333333666667'))
    """
    a, b = interval
    low, high = text(a), text(b)
    if max(len(low), len(high)) <= DIGITS:
        return low, high
    unit = decimal_unit(max(abs(a), abs(b))) / mpq(10) ** (DIGITS - 1)
    return decimal(a // unit * unit, DIGITS), decimal(-(-b // unit) * unit, DIGITS)


def _continuity(joints: Iterable[Joint]) -> str:
    """The numbers of joints by order of geometric continuity."""
    orders = [joint.order for joint in joints]
    names = {-1: "with a gap", 0: "G0", 1: "G1", 2: "G2", 3: "G3 or higher", None: "singular, without an order"}
    counted = [f"{orders.count(order)} {name}" for order, name in names.items() if order in orders]
    return f"joints: {', '.join(counted)}"
