"""Bisectors as data: control nets as exact text, ends of pieces as certified roots."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import StrEnum
from operator import itemgetter
from typing import Any, NamedTuple, cast

from flint import arb

from exactspline.display.forms import (
    FLAG,
    INTEGER,
    INTERVAL,
    NAMED_NUMBERS,
    REAL,
    SPLINE,
    TEXT,
    Data,
    Form,
    Net,
    list_of,
    one_of,
    optional,
    or_null,
    pair_of,
    plain,
    real_data,
    real_text,
    record,
)
from exactspline.display.sheet import Sheet
from exactspline.errors import ReachError, counted
from exactspline.geometry.bisectors.components import (
    Branch,
    Cause,
    Correspondence,
    LineComponent,
    PairEquation,
    PlaneComponent,
    PoleCurve,
    SinglePair,
    Solutions,
)
from exactspline.geometry.bisectors.lines import Coordinate, Flat
from exactspline.geometry.bisectors.plane_curves import PlaneBisector
from exactspline.geometry.bisectors.point_and_curve import PointBisector, RuledPiece
from exactspline.geometry.bisectors.trimmed import PieceKind, TrimmedBisector, TrimmedPiece
from exactspline.geometry.bisectors.two_curves import BisectorPatch, CurveBisector
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.one_line import short_text
from exactspline.reals.real import Real
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.tensor import TensorSpline

NAMES = "st"


def _parameter_data(t: Parameter, digits: int) -> Data:
    """A parameter as a real number; if it is irrational, also its minimal polynomial, constant term first, or a
    multiple of this polynomial that was too costly to factor.
    """
    data = real_data(t, digits)
    if not isinstance(t, Root) or t.exact is not None:
        return data
    try:
        polynomial = t.minimal_polynomial()
    except ReachError:
        polynomial = t.polynomial
    return data | {"polynomial": [text(x) for x in polynomial]}


_TEXTS, _NETS = list_of(TEXT), list_of(list_of(TEXT))
_SIDES = pair_of(INTERVAL)
PARAMETER = Form(record(REAL, record(polynomial=optional(_TEXTS))).schema, _parameter_data)
#: The degree and the knots of a net of control points.
_NET = {
    "degree": Form({"type": ["integer", "array"], "items": INTEGER.schema}),
    "knots": Form({"type": "array", "items": {"type": ["string", "array"], "items": TEXT.schema}}),
}
_LETTER = Form({"enum": [*NAMES]}, lambda of, digits: NAMES[of])


# ---- two curves


def curve_bisector_data(bisector: CurveBisector) -> Data:
    """The data of the whole bisector of two curves, in addition to those of its parts."""
    return {
        "kind": "bisector of two curves",
        "variant": str(bisector.variant),
        "missing": [{"sides": plain(sides), "reason": reason} for sides, reason in bisector.missing],
        "undecided": list(bisector.undecided),
        "complete": not bisector.undecided,
    }


def control_net(splines: list[TensorSpline]) -> Data:
    """The control nets of several splines over their common knots."""
    splines = with_common_knots(splines)
    first = splines[0]
    rows = zip(*[x.control_points for x in splines], strict=True)
    return {
        "degree": list(first.degree),
        "knots": [plain(knots) for knots in first.knots],
        "homogeneous_control_net": [plain(list(zip(*row, strict=True))) for row in rows],
    }


def _patch_net(patch: BisectorPatch, digits: int) -> Data:
    numerator, w = patch.value.elevated()
    assert isinstance(numerator, Vector)  # a surface
    return control_net([*numerator, w])


def _root_net(part: tuple[Coordinate, ...], field: str) -> Data:
    """Control points in the field of an irrational parameter: a coordinate is the list of the coefficients of the
    powers 0, 1, 2, … of the parameter.
    """
    first = part[0][0]
    rows = zip(*[zip(*[f.control_points for f in coordinate], strict=True) for coordinate in part], strict=True)
    return {"degree": first.degree, "knots": plain(first.knots), field: plain(list(rows))}


def _other_data(other: Parameter | Rational[BSpline], digits: int) -> Data:
    if not isinstance(other, Rational):
        return _parameter_data(other, digits)
    return cast(Data, SPLINE.write(Net.of(other, other.denominator.domain), digits))


def _flat_of_branch(found: tuple[LineComponent, Branch], digits: int) -> Data:
    line, branch = found
    return _flat_data(line.line(*branch.sample, digits), digits)


def _flat_of_pair(pair: SinglePair, digits: int) -> Data:
    if pair.solutions is Solutions.SPACE:
        return {}
    return _flat_data(pair.exact or pair.enclosed(digits), digits, plane=pair.solutions is Solutions.PLANE)


def _flat_data(flat: Flat[Any], digits: int, *, plane: bool = False) -> Data:
    """A point, and the direction of a line or the normal of a plane: exact text, or decimals with all digits
    correct.
    """
    return {
        "point": [_number(x, digits) for x in flat.point],
        "normal" if plane else "direction": [_number(x, digits) for x in flat.direction],
    }


def _number(x: mpq | arb, digits: int) -> str:
    return str(x.str(digits, radius=False)) if isinstance(x, arb) else text(x)


#: An equation between s and t: as text, and its integers ``[power of s, power of t, integer]``.
_EQUATION = record(
    text=(TEXT, lambda equation: f"{equation.text} = 0"),
    terms=list_of(
        Form({"type": "array", "minItems": 3, "maxItems": 3}, lambda term, digits: [*term[0], text(term[1])])
    ),
)
_BRANCH = record(low=PARAMETER, high=PARAMETER, index=INTEGER, sample=pair_of(PARAMETER))
_LIMITS = record(ends=list_of(pair_of(PARAMETER)), nodes=list_of(pair_of(PARAMETER))).of("real")
#: A piece with low, high, and the control points of directrix and generator over the whole segment.
_LINE_PIECE = record(
    parameter=(_LETTER, "of"),
    low=PARAMETER,
    high=PARAMETER,
    other=or_null(Form({"anyOf": [SPLINE.schema, PARAMETER.schema]}, _other_data)),
    directrix=(SPLINE, lambda one: Net.of(one.surface.directrix, one.surface.directrix.denominator.domain)),
    generator=(SPLINE, lambda one: Net.of(one.surface.generator.vector, one.surface.directrix.denominator.domain)),
    poles=list_of(PARAMETER),
)
_OVER_ROOT = record(
    parameter=(_LETTER, "of"),
    low=(PARAMETER, "interval.low"),
    high=(PARAMETER, "interval.high"),
    directrix=Form(
        record(**_NET, homogeneous_control_points=list_of(_NETS)).schema,
        lambda part, digits: _root_net(part, "homogeneous_control_points"),
    ),
    generator=Form(
        record(**_NET, control_points=list_of(_NETS)).schema, lambda part, digits: _root_net(part, "control_points")
    ),
    poles=or_null(list_of(PARAMETER)),
)
_BRANCH_WITH_LINE = record(
    _BRANCH.of(itemgetter(1)), Form(record(point=_TEXTS, direction=_TEXTS).schema, _flat_of_branch)
)
#: The form of a part of the bisector by its type.
FORMS: dict[type, Form] = {
    BisectorPatch: record(
        record(sides=_SIDES), Form(record(**_NET, homogeneous_control_net=list_of(_NETS)).schema, _patch_net)
    ),
    LineComponent: record(
        record(
            pairs=(one_of(Correspondence), "correspondence"),
            cause=one_of(Cause),
            sides=_SIDES,
            equation=or_null(_EQUATION),
            fixed=or_null(PARAMETER),
            over_root=or_null(_OVER_ROOT),
            pieces=list_of(_LINE_PIECE),
            branches=(list_of(_BRANCH_WITH_LINE), lambda line: [(line, branch) for branch in line.real.branches]),
        ),
        _LIMITS,
    ),
    PlaneComponent: record(
        record(
            solutions=one_of(Solutions),
            cause=one_of(Cause),
            sides=_SIDES,
            equation=or_null(_EQUATION),
            parameter=(_LETTER, "of"),
            intervals=list_of(pair_of(PARAMETER)),
            fixed=or_null(PARAMETER),
            branches=(list_of(_BRANCH), "real.branches"),
        ),
        _LIMITS,
    ),
    SinglePair: record(
        record(s=PARAMETER, t=PARAMETER, solutions=one_of(Solutions), cause=one_of(Cause), sides=_SIDES),
        Form(record(**dict.fromkeys(("point", "direction", "normal"), optional(_TEXTS))).schema, _flat_of_pair),
    ),
    PoleCurve: record(sides=_SIDES, equation=_EQUATION, certain=FLAG),
}


# ---- two plane curves


class PairsKind(StrEnum):
    """The kinds of pairs of parameters of the bisector of two plane curves."""

    ARC = "correspondence of parameters"
    LOOP = "closed correspondence of parameters"
    PAIR = "pair"
    LINE = "line of pairs"
    RECTANGLE = "rectangle of pairs"


class Pairs(NamedTuple):
    """Pairs of parameters of the bisector of two plane curves. An arc is given by its ends, and an end in an undecided
    box is None; a single pair is both ends; a line or a rectangle is given by its `sides`.
    """

    piece: PairsKind
    start: Sequence[Real | mpq] | None = None
    end: Sequence[Real | mpq] | None = None
    sides: Sequence[Sequence[Real | mpq]] | None = None


def pairs_of(bisector: PlaneBisector) -> list[Pairs]:
    """The pairs of parameters of a bisector: arcs and loops, single pairs, lines, rectangles."""
    pairs = bisector.pairs
    found = [Pairs(PairsKind.LOOP if arc.closed else PairsKind.ARC, arc.start, arc.end) for arc in pairs.arcs]
    found += [Pairs(PairsKind.PAIR, (x.first, x.second), (x.first, x.second)) for x in pairs.points]
    found += [Pairs(PairsKind.LINE, sides=line.box) for line in pairs.lines]
    return found + [Pairs(PairsKind.RECTANGLE, sides=(part.sides[0], part.sides[1])) for part in pairs.everywhere]


#: The points of the ends of the pieces of a bisector in the plane, then their parameters.
ENDS = (list_of(NAMED_NUMBERS), "items")
SIDES_MISSING = record(sides=pair_of(INTERVAL), reason=TEXT)
_END = or_null(pair_of(REAL))
PAIRS = record(piece=one_of(PairsKind), start=_END, end=_END, sides=or_null(pair_of(pair_of(REAL))))


def _plane_bisector_data(bisector: PlaneBisector, digits: int) -> Data:
    """The pairs of the bisector of two plane curves."""
    data: Data = record(pieces=(list_of(PAIRS), pairs_of), ends=ENDS).write(bisector, digits)
    missing = [{"sides": plain(sides), "reason": "the pairs are not decided"} for sides in bisector.missing]
    return {"kind": "bisector of two plane curves"} | data | {"missing": missing, "complete": not bisector.missing}


def feet_data(bisector: PlaneBisector, digits: int) -> Data:
    """The boxes of pairs of parameters in which it is proved that no point of either curve is nearer."""
    form = record(true_feet=(list_of(_SIDES), "trimmed.kept"), undecided_feet=(list_of(_SIDES), "trimmed.undecided"))
    return cast(Data, form.write(bisector, digits))


# ---- a point and a curve


def _trimmed(piece: TrimmedPiece) -> Net:
    """A piece over [low, high] if both ends are rational, otherwise over the whole segment."""
    exact = piece.restricted()
    value = piece.value if exact is None else exact
    return Net.of(value, value.denominator.domain)


#: The form of a piece of the bisector of a point and a curve, by its type.
FORMS_OF_POINT: dict[type, Form] = {
    RuledPiece: record(
        interval=INTERVAL,
        moved=TEXT,
        directrix=(SPLINE, lambda piece: Net.of(piece.surface.directrix, piece.interval)),
        generator=(SPLINE, lambda piece: Net.of(piece.surface.generator, piece.interval)),
    ),
    TrimmedPiece: record(
        record(piece=(one_of(PieceKind), "kind"), foot=optional(TEXT), low=PARAMETER, high=PARAMETER),
        SPLINE.of(_trimmed),
        # if these are given, the piece is only the part from low to high
        cut=(optional(FLAG), lambda piece: piece.restricted() is None or None),
    ),
}
#: An interval on which there is no bisector, and the reason.
MISSING = record(interval=(INTERVAL, itemgetter(0)), reason=(TEXT, itemgetter(1)))


def _point_bisector_data(bisector: PointBisector, digits: int) -> Data:
    """The pieces of the ruled bisector of a point and a curve: directrix and generator by homogeneous control
    points.
    """
    form = record(
        variant=TEXT, pieces=list_of(FORMS_OF_POINT[RuledPiece]), singular=list_of(PARAMETER), missing=list_of(MISSING)
    )
    data: Data = form.write(bisector, digits)
    return {"kind": "ruled bisector"} | data


def _trimmed_data(bisector: TrimmedBisector, digits: int) -> Data:
    """The pieces of the true bisector of a point and a plane curve."""
    pieces = list_of(FORMS_OF_POINT[TrimmedPiece])
    form = record(pieces=pieces, ends=ENDS, missing=_TEXTS, undecided=_TEXTS)
    data: Data = form.write(bisector, digits)
    return {"kind": "trimmed bisector"} | data | {"complete": not bisector.undecided}


#: The forms of bisectors that consist of one part, by their types.
WRITTEN: dict[type, Callable[[Any, int], Data]] = {
    PlaneBisector: _plane_bisector_data,
    PointBisector: _point_bisector_data,
    TrimmedBisector: _trimmed_data,
}


# ---- as text


def _degree_of(value: SplineVector | Rational[TensorSpline]) -> str:
    """The degree of a piece, as text."""
    d = value.degree
    return f"{d[0]} × {d[1]}" if isinstance(d, tuple) else str(d)


def _control_points(value: Rational[TensorSpline]) -> int:
    """The number of control points of a patch."""
    m, n = value.vector[0].elevated_to(value.denominator).control_point_counts
    return int(m * n)


# ---- as a sheet


class Row(NamedTuple):
    """One piece in the table."""

    piece: str
    where: str
    degree: str
    remark: str
    #: The equation of the pairs, if it is short enough to be shown before their parameters.
    equation: PairEquation | None = None

    @property
    def parameters(self) -> str:
        """The pairs of parameters of the piece, as text."""
        return f"{self.equation.short_text}: {self.where}" if self.equation else self.where


def bisector_sheet(rows: Iterable[Row], title: str) -> Sheet:
    """The pieces of a bisector, one per row."""
    cells = [(row.piece, row.parameters, row.degree, row.remark) for row in rows]
    return Sheet("piece", "parameters", "degree", "remark", rows=cells, title=title, prose=["parameters", "remark"])


def of_two_curves(found: CurveBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The surface, lines, planes, single pairs and poles of two curves, and notes on missing parts."""
    rows = [_surface_row(patch) for patch in found.patches]
    rows += _grouped(_line_row(line, digits) for line in found.lines)
    rows += _grouped(_plane_row(plane, digits) for plane in found.planes)
    rows += [Row(str(pair.solutions), _pair((pair.s, pair.t), digits), "–", str(pair.cause)) for pair in found.pairs]
    rows += _grouped(_pole_row(pole) for pole in found.poles)
    notes = [f"no surface: {sides.shortly}: {reason}" for sides, reason in found.missing]
    return rows, notes + ([f"undecided: {what}" for what in found.undecided] or [_closing(found)])


def of_plane_curves(bisector: PlaneBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The pairs of the bisector of two plane curves, and notes on the boxes in which they are proved nearest."""
    rows = [Row(str(pairs.piece), _where(pairs, digits), "–", "") for pairs in pairs_of(bisector)]
    trimmed = bisector.trimmed
    kept, undecided = (counted(len(boxes), "box") for boxes in (trimmed.kept, trimmed.undecided))
    notes = [f"no point of either curve is nearer: proved in {kept} of pairs, undecided in {undecided}"]
    missing = (" × ".join(str(side) for side in sides) for sides in bisector.missing)
    return rows, notes + [f"undecided: {sides}" for sides in missing]


def _where(pairs: Pairs, digits: int) -> str:
    """The place of pairs, as text: from one end to the other end, or the ranges of both parameters."""
    if pairs.sides:
        ends = zip("st", ([real_text(x, digits) for x in side] for side in pairs.sides), strict=True)
        return ", ".join(
            f"{name} = {low}" if low == high else f"{name} in [{low}, {high}]" for name, (low, high) in ends
        )
    if pairs.piece is PairsKind.LOOP:
        return ""
    start, end = (_pair(each, digits) for each in (pairs.start, pairs.end))
    return start if pairs.piece is PairsKind.PAIR else f"{start} to {end}"


def _interval(low: Real | mpq, high: Real | mpq, digits: int) -> str:
    return f"[{real_text(low, digits)}, {real_text(high, digits)}]"


def _pair(pair: Sequence[Real | mpq] | None, digits: int) -> str:
    if pair is None:
        return "an undecided box"
    return ", ".join(f"{name} = {real_text(x, digits)}" for name, x in zip("st", pair, strict=True))


def of_point_in_plane(found: TrimmedBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The pieces of the trimmed bisector of a point and a plane curve, and notes on missing pieces."""
    rows = []
    for piece in found.pieces:
        ends = _interval(piece.low, piece.high, digits)
        foot = "" if piece.foot is None else f"foot at {short_text(piece.foot)}"
        rows.append(Row(str(piece.kind), ends, str(piece.value.degree), foot))
    return rows, [f"missing: {reason}" for reason in found.missing] + [f"undecided: {what}" for what in found.undecided]


def of_point_in_space(found: PointBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The ruled pieces of the bisector of a point and a space curve, and notes on missing pieces."""
    rows = []
    for piece in found.pieces:
        moved = f"ruling parameter {piece.moved}" if piece.moved else ""
        rows.append(Row("ruled surface", str(piece.interval), str(piece.surface.degree), moved))
    rows += [Row("singular", real_text(root, digits), "–", "the generator vanishes") for root in found.singular]
    return rows, [f"missing: {interval}: {reason}" for interval, reason in found.missing]


def _grouped(rows: Iterable[Row]) -> list[Row]:
    """Rows of one equation, if the equation is shown and they differ only in their patch, merged into one row."""
    found: dict[tuple[object, ...], Row] = {}
    for i, row in enumerate(rows):
        key = (row.piece, row.equation, row.degree, row.remark) if row.equation else (i,)
        found[key] = row if key not in found else row._replace(where=f"{found[key].where}; {row.where}")
    return list(found.values())


def _closing(found: CurveBisector) -> str:
    nothing = not (found.patches or found.lines or found.planes or found.pairs)
    return "complete: there is no bisector" if nothing else "complete: nothing is undecided"


def _surface_row(patch: BisectorPatch) -> Row:
    remark = counted(_control_points(patch.value), "control point")
    if max(patch.value.degree) == 0:
        point = patch.value.point(patch.sides[0][0], patch.sides[1][0])
        remark = f"one point: ({', '.join(map(short_text, point))})"
    return Row("surface", patch.sides.shortly, _degree_of(patch.value), remark)


def _line_row(line: LineComponent, digits: int) -> Row:
    degrees = {piece.surface.degree for piece in line.pieces}
    if line.pieces:
        where = "; ".join(f"{'st'[x.of]} in {_interval(x.low, x.high, digits)}" for x in line.pieces)
    elif line.over_root is not None:
        own = line.over_root
        degrees = {own.degree}
        where = f"{'ts'[own.of]} = {real_text(own.other, digits)}; {'st'[own.of]} in {own.interval}"
    else:
        where = counted(len(line.real.branches), "branch")
    where, short = _pairs(line.equation, line.sides, where)
    return Row("lines", where, ", ".join(map(str, degrees)) or "–", str(line.cause), short)


def _plane_row(plane: PlaneComponent, digits: int) -> Row:
    where = "; ".join(f"{'st'[plane.of]} in {_interval(a, b, digits)}" for a, b in plane.intervals)
    kind = "planes" if plane.equation is not None and plane.fixed is None else str(plane.solutions)
    where, short = _pairs(plane.equation, plane.sides, where)
    return Row(kind, where, "–", str(plane.cause), short)


def _pole_row(pole: PoleCurve) -> Row:
    certain = "the surface is at infinity" if pole.certain else "the surface is at infinity where there are such pairs"
    where, short = _pairs(pole.equation, pole.sides, "")
    return Row("poles", where, "–", certain, short)


def _pairs(equation: PairEquation | None, sides: Any, where: str) -> tuple[str, PairEquation | None]:
    """The pairs of an equation on a patch as text, and the equation if it is short enough to stand before them."""
    if equation is None:
        return f"all of {sides.shortly}", None
    where = where or sides.shortly
    return (where, equation) if equation.is_short else (f"{equation.short_text}: {where}", None)
