"""Bisectors as tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from exactspline.display.bisector_data import Pairs, PairsKind, control_points, degree_of, pairs_of
from exactspline.display.reals import real_text
from exactspline.display.sheet import Sheet
from exactspline.errors import counted
from exactspline.geometry.bisectors.components import LineComponent, PairEquation, PlaneComponent, PoleCurve
from exactspline.geometry.bisectors.plane_curves import PlaneBisector
from exactspline.geometry.bisectors.point_and_curve import PointBisector
from exactspline.geometry.bisectors.trimmed import TrimmedBisector
from exactspline.geometry.bisectors.two_curves import BisectorPatch, CurveBisector
from exactspline.numbers.exact import mpq
from exactspline.one_line import short_text
from exactspline.reals.real import Real


class Row(NamedTuple):
    """One piece in the table."""

    piece: str
    where: str
    degree: str
    remark: str
    #: The equation of its pairs where it is short enough to be shown before their parameters.
    equation: PairEquation | None = None

    @property
    def parameters(self) -> str:
        """Which pairs of parameters it has."""
        return f"{self.equation.short_text}: {self.where}" if self.equation else self.where


def bisector_sheet(rows: Iterable[Row], title: str) -> Sheet:
    """The pieces of a bisector, one per row."""
    cells = [(row.piece, row.parameters, row.degree, row.remark) for row in rows]
    return Sheet("piece", "parameters", "degree", "remark", rows=cells, title=title, prose=["parameters", "remark"])


def of_two_curves(found: CurveBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The surface, lines, planes, single pairs and poles of two curves, and notes on what is missing."""
    rows = [_surface_row(patch) for patch in found.patches]
    rows += _grouped(_line_row(line, digits) for line in found.lines)
    rows += _grouped(_plane_row(plane, digits) for plane in found.planes)
    rows += [
        Row(
            str(pair.solutions),
            f"s = {real_text(pair.s, digits)}, t = {real_text(pair.t, digits)}",
            "–",
            str(pair.cause),
        )
        for pair in found.pairs
    ]
    rows += _grouped(_pole_row(pole) for pole in found.poles)
    notes = [f"no surface: {sides.shortly}: {reason}" for sides, reason in found.missing]
    return rows, notes + ([f"undecided: {what}" for what in found.undecided] or [_closing(found)])


def of_plane_curves(bisector: PlaneBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The pairs of the bisector of two plane curves, and notes on which of them are nearest."""
    rows = [Row(str(pairs.piece), _where(pairs, digits), "–", "") for pairs in pairs_of(bisector)]
    trimmed = bisector.trimmed
    kept, undecided = (counted(len(boxes), "box") for boxes in (trimmed.kept, trimmed.undecided))
    notes = [f"no point of either curve is nearer: proved in {kept} of pairs, undecided in {undecided}"]
    missing = (" × ".join(str(side) for side in sides) for sides in bisector.missing)
    return rows, notes + [f"undecided: {sides}" for sides in missing]


def _where(pairs: Pairs, digits: int) -> str:
    """Where pairs are: from one end to the other, or the ranges of both parameters."""
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
    """The pieces of the trimmed bisector of a point and a plane curve, and notes on what is missing."""
    rows = []
    for piece in found.pieces:
        ends = _interval(piece.low, piece.high, digits)
        foot = "" if piece.foot is None else f"foot at {short_text(piece.foot)}"
        rows.append(Row(str(piece.kind), ends, str(piece.value.degree), foot))
    return rows, [f"missing: {reason}" for reason in found.missing] + [f"undecided: {what}" for what in found.undecided]


def of_point_in_space(found: PointBisector, digits: int) -> tuple[list[Row], list[str]]:
    """The ruled pieces of the bisector of a point and a space curve, and notes on what is missing."""
    rows = []
    for piece in found.pieces:
        moved = f"ruling parameter {piece.moved}" if piece.moved else ""
        rows.append(Row("ruled surface", str(piece.interval), str(piece.surface.degree), moved))
    rows += [Row("singular", real_text(root, digits), "–", "the generator vanishes") for root in found.singular]
    return rows, [f"missing: {interval}: {reason}" for interval, reason in found.missing]


def _grouped(rows: Iterable[Row]) -> list[Row]:
    """Rows that differ only in their patch merged into one: those of one equation that is shown."""
    found: dict[tuple[object, ...], Row] = {}
    for i, row in enumerate(rows):
        key = (row.piece, row.equation, row.degree, row.remark) if row.equation else (i,)
        found[key] = row if key not in found else row._replace(where=f"{found[key].where}; {row.where}")
    return list(found.values())


def _closing(found: CurveBisector) -> str:
    nothing = not (found.patches or found.lines or found.planes or found.pairs)
    return "complete: there is no bisector" if nothing else "complete: nothing is undecided"


def _surface_row(patch: BisectorPatch) -> Row:
    remark = counted(control_points(patch.value), "control point")
    if max(patch.value.degree) == 0:
        point = patch.value.point(patch.sides[0][0], patch.sides[1][0])
        remark = f"one point: ({', '.join(map(short_text, point))})"
    return Row("surface", patch.sides.shortly, degree_of(patch.value), remark)


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
