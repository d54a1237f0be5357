"""The features of a curve as a table, from the data of its inspection."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from rich.console import Console

from exactspline.display import console
from exactspline.display.described import described, readable, shape_text
from exactspline.display.numbers import decimal, rounded_down
from exactspline.display.sheet import Sheet
from exactspline.geometry.analysis.curves import QUESTIONS, questions_about
from exactspline.geometry.curves.kinds import FeatureKind, JointKind, kind_name
from exactspline.geometry.recognition.shapes import ShapeKind
from exactspline.numbers.exact import decimal_unit, mpq, rational
from exactspline.questions.entry import Answered
from exactspline.splines.nurbs import Nurbs

#: Characters of an exact number that a table shows.
READABLE = 20
#: Digits of places in tables of features.
DIGITS = 12
#: What may stand in a remark and is explained below the table.
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


def feature_sheet(c: Nurbs, data: Mapping[str, object]) -> Sheet:
    """The features of a curve, one per row, from the data of its inspection."""
    closed = ", closed" if c.closed else ""
    in_space = c.dimension == 3
    columns = ("what", "parameter", "exactly", "curvature", *(("torsion",) if in_space else ()), "remark")
    made = Sheet(*columns, title=f"{c.name}: {described(c)}{closed}", name=c.name, prose=["remark"], heads=2)
    _add_rows(made, c, data)
    return made


def _add_rows(made: Sheet, c: Nurbs, data: Mapping[str, Any]) -> None:
    in_space = c.dimension == 3
    for group in _asked(c, Answered.PLACES):
        for f in data[group]["points"]:
            kind = kind_name(FeatureKind(f["kind"]))
            absolute = f"{f['of_absolute']} of |κ|" if f["of_absolute"] and not in_space else ""
            jumps = f", by a jump of {_jumping(f['kind'], in_space)}" if f["by_jump"] else ""
            at_knot = f"at a knot{jumps}" if f["at_knot"] or jumps else ""
            remark = " ".join(filter(None, (absolute, at_knot, _turn(f["angle"]))))
            values = (f.get("curvature", ""), *((f.get("torsion", ""),) if in_space else ()))
            made.add_row(kind, f["decimal"], f["parameter"] or "–", *values, remark)
    empty = ("",) * (1 if in_space else 0)
    for f in data.get("coordinate_extrema", []):
        kind, exactly = f"{f['kind']} of {'xyz'[f['coordinate']]}", f["parameter"] or "–"
        made.add_row(kind, f["decimal"], exactly, f.get("curvature", ""), *empty, "at a knot" * f["at_knot"])
    for joint in data["joints"]:
        # singular joints are among the singular points
        if joint["kind"] in (JointKind.GAP, JointKind.CORNER, JointKind.TURN, JointKind.CURVATURE_JUMP):
            made.add_row(
                joint["kind"], joint["decimal"], joint["parameter"], joint["curvature"] or "", *empty, _remark(joint)
            )
    for name in _asked(c, Answered.PAIRS):
        for point in data[name]["points"]:
            both = [" and ".join(point[k][form] or "–" for k in ("first", "second")) for form in ("decimal", "exact")]
            made.add_row("self-intersection", *both, "", *empty, point["kind"])
        for what in data[name]["left_out"]:
            made.add_row("not decided", "", "", "", *empty, f"self-intersections: {what}")
        for arc in data[name]["everywhere"]:
            both = [" and ".join(_decimals(arc[k]) for k in ("first", "second"))] * 2
            made.add_row("runs over itself", *both, "", *empty, "reversed" * arc["reversed"])
    for name in _asked(c, Answered.PIECES):
        for piece in data[name]:
            made.add_row(QUESTIONS[name].about.of_piece, *[_intervals(piece)] * 2, "", *empty, "")
    for found in data["shapes"]:
        # exact lines are among the straight pieces
        if found["kind"] != ShapeKind.LINE or found["numbers"]["within"] != ["0"]:
            made.add_row(found["kind"], *[_intervals(found["intervals"])] * 2, "", *empty, _of_shape(found))
    for piece in data.get("planar_pieces", []):
        interval, lies_in = _intervals(piece["intervals"]), f"in the plane {piece['plane']}"
        made.add_row(QUESTIONS["planar_pieces"].about.of_piece, interval, interval, "", *empty, lies_in)


def _jumping(kind: str, in_space: bool) -> str:
    """What changes its sign at a feature of a kind."""
    if kind in (FeatureKind.MAXIMUM, FeatureKind.MINIMUM):
        return "κ′"
    return "τ" if kind == FeatureKind.TORSION_ZERO else "κN" if in_space else "κ"


def words_of(c: Nurbs, data: Mapping[str, object]) -> list[str]:
    """The words of all tables of a curve, and below them, that the glossary explains."""
    made = feature_sheet(c, data)
    tables = [made, *_extra(c, data)]
    words = [word for table in tables for word in (*table.columns[1:], *table.tags)]
    remarks = [row[-1] for row in made.rows]
    # κ is not κ′, nor κN
    words += [word for word in REMARKS if any(re.search(rf"{re.escape(word)}(?![′N])", each) for each in remarks)]
    joints: Any = data["joints"]
    orders = {joint["geometric_continuity"] for joint in joints} - {None, -1}
    return words + [f"G{order}" for order in sorted(orders)]


def _decimals(ends: list[dict[str, str]]) -> str:
    return f"[{', '.join(x['exact'] or x['decimal'] for x in ends)}]"


def _asked(c: Nurbs, answered: Answered) -> list[str]:
    """The questions whose answers are shown, of those that consist of the same."""
    shown = {name: entry.about for name, entry in questions_about(c).items()}
    return [name for name, about in shown.items() if about.answered == answered and about.reported]


def print_features(c: Nurbs, data: Mapping[str, object]) -> None:
    """The table, and what is known of joints, of the plane of a curve, and of the approaches."""
    out, made = console.console(), feature_sheet(c, data)
    if made.rows:
        out.print(made)
    else:
        nothing = ", ".join("no " + name.replace("_", " ") for name in ("corners", *_asked(c, Answered.PLACES)))
        console.lines(out, f"{c.name}: {nothing}")
    _print_rest(out, c, data)


def _print_rest(out: Console, c: Nurbs, data: Mapping[str, Any]) -> None:
    """Below the table."""
    if data["joints"]:
        console.lines(out, _continuity(data["joints"]))
    if data.get("plane"):
        reason = "it has no torsion, no focal curve and no osculating spheres"
        console.lines(out, f"{c.name} lies in the plane {data['plane']}: {reason}")
    approaches = [_approaches(data["approaches"])] if "approaches" in data else []
    for sheet in [*_extra(c, data), *approaches]:
        out.print()
        out.print(sheet)


def _intervals(parts: list[list[str]]) -> str:
    return " ∪ ".join(f"[{a}, {b}]" for a, b in parts)


def _turn(angle: dict[str, str] | None) -> str:
    """By how much the tangent turns, as text."""
    if angle is None:
        return ""
    exactly = f" (cos = {angle['cosine']}, sin = {angle['sine']})" if _short(angle["cosine"], angle["sine"]) else ""
    return f"turns by {angle['degrees']}°{exactly}".replace("-", "−")


def _short(*exact: str) -> bool:
    """Whether exact numbers are short enough to be read; ``--json`` has all of them."""
    return all(len(text) <= READABLE for text in exact)


def _remark(joint: dict[str, Any]) -> str:
    """What is known of a joint, as text."""
    order = joint["geometric_continuity"]
    parts = [
        "at the seam" if joint["at_seam"] else "at a knot",
        _turn(joint["angle"]),
        f"{joint['gap'] if _short(joint['gap']) else joint['gap_decimal']} wide" if joint["gap"] else "",
        f"exactly {' | '.join(joint['curvatures'])}" if joint["curvatures"] and _short(*joint["curvatures"]) else "",
        f"G{order}" if order >= 0 else "",
    ]
    return ", ".join(filter(None, parts)).replace("-", "−")


def _of_shape(found: Mapping[str, Any]) -> str:
    """What describes a shape, and how near the curve is to it, as text."""
    (within,), *_ = found["numbers"].values()
    return shape_text({name: values for name, values in found["numbers"].items() if name != "within"}, rational(within))


def _nearby_sheet(c: Nurbs, data: Mapping[str, object]) -> Sheet:
    """What all curves near a curve have, and what some of them may have."""
    title = f"All curves within {readable(str(data['epsilon']))} of {c.name}"
    made = Sheet("what", "each has", "between", "and", title=title, heads=2)
    for found in _in_order(data["nearby"]):
        ((low, high),) = found["intervals"]
        number = ("exactly one" if found["single"] else "at least one") if found["certain"] else "perhaps some"
        made.add_row(kind_name(FeatureKind(found["kind"])), number, *ends_text(low, high))
    return made


def _meetings_sheet(c: Nurbs, data: Mapping[str, object]) -> Sheet:
    """Where all curves near a curve meet themselves, and where some of them may."""
    return common_points_sheet(
        data["meetings"], f"All curves within {readable(str(data['epsilon']))} of {c.name} and themselves"
    )


def common_points_sheet(meetings: object, title: str) -> Sheet:
    """The points that all curves near two curves have in common, and those that some of them may have, from data."""
    listed: Any = meetings
    made = Sheet("common points", "s between", "and", "t between", "and", title=title, heads=1)
    for found in listed:
        ((low, high),) = found["intervals"]
        ends = *ends_text(low, high), *ends_text(*found["numbers"]["second"])
        made.add_row("exactly one" if found["certain"] else "perhaps some", *ends)
    return made


def _stability_sheet(c: Nurbs, data: Mapping[str, object]) -> Sheet:
    """How far a curve may be changed until its features vanish."""
    title = f"{c.name} with all numbers changed by at most this"
    columns = ("what", "at", "certain up to", "gone within", "ratio", "prominence")
    made = Sheet(*columns, title=title, heads=1, numbers=["certain up to"])
    for found in _in_order(data["stability"]):
        ((low, high),) = found["intervals"]
        numbers = [rational(x) for (x,) in found["numbers"].values()]
        # what is proved of a distance is so of smaller ones, and what is gone at one, within larger ones
        radius, *gone = (decimal(s * rounded_down(s * x, 4), 4) for s, x in zip((1, -1), numbers, strict=False))
        times = f"{round(float(numbers[-1] / numbers[0]))} ×" if gone and numbers[0] else ""
        at, certain = decimal((rational(low) + rational(high)) / 2, DIGITS), radius if radius != "0" else "not proved"
        made.add_row(
            kind_name(FeatureKind(found["kind"])), at, certain, *gone or ["not known"], times, found["prominence"] or ""
        )
    return made


#: Tables below that of the features, by the part of the data that they show.
EXTRA = {"nearby": _nearby_sheet, "meetings": _meetings_sheet, "stability": _stability_sheet}


def _extra(c: Nurbs, data: Mapping[str, Any]) -> list[Sheet]:
    """The tables below that of the features; none of common points where there are none."""
    return [sheet(c, data) for name, sheet in EXTRA.items() if name in data and (data[name] or name != "meetings")]


def _in_order(found: Any) -> list[Any]:
    """Features in the order of the first table: inflections, extrema of the curvature, corners."""
    extrema = (FeatureKind.MAXIMUM, FeatureKind.MINIMUM, FeatureKind.STATIONARY)
    places = dict.fromkeys(extrema, 1) | {FeatureKind.CORNER: 2}
    return sorted(found, key=lambda each: places.get(FeatureKind(each["kind"]), 0))


def end_text(t: str) -> str:
    """An end of an interval, to as many digits as are read at a glance."""
    return t if len(t) <= DIGITS else decimal(rational(t), DIGITS)


def ends_text(low: str, high: str) -> tuple[str, str]:
    """The ends of an interval that contains something, rounded outwards to as many digits as are read at a glance.

    >>> ends_text("1/7", "1/7"), ends_text("1000000/3000001", "1000001/3000000")
    (('1/7', '1/7'), ('0.333333222222', '0.333333666667'))
    """
    if max(len(low), len(high)) <= DIGITS:
        return low, high
    a, b = rational(low), rational(high)
    unit = decimal_unit(max(abs(a), abs(b))) / mpq(10) ** (DIGITS - 1)
    return decimal(a // unit * unit, DIGITS), decimal(-(-b // unit) * unit, DIGITS)


def _continuity(joints: list[dict[str, Any]]) -> str:
    """The numbers of joints by order of geometric continuity."""
    orders = [joint["geometric_continuity"] for joint in joints]
    names = {-1: "with a gap", 0: "G0", 1: "G1", 2: "G2", 3: "G3 or higher", None: "singular, without an order"}
    counted = [f"{orders.count(order)} {name}" for order, name in names.items() if order in orders]
    return f"joints: {', '.join(counted)}"


def _approaches(rows: list[dict[str, Any]]) -> Sheet:
    numbers = ("degree", "control points", "roots", "extraneous", "missing", "seconds")
    cells = [
        (row["name"], *(row[name.replace(" ", "_")] for name in numbers[:-1]), f"{row['seconds']:.4f}") for row in rows
    ]
    return Sheet("approach", *numbers, rows=cells, title="Approaches to critical curvature", numbers=numbers)
