"""``bisector``: of two curves, or of a point and a curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from exactspline.cli.common import CURVE_HELP, check_output, described, load_curve, tell_how_surfaces_are_drawn
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument, Option

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from exactspline.display.sheet import Sheet
    from exactspline.geometry.bisector.components import LineComponent, PairEquation, PlaneComponent, PoleCurve
    from exactspline.geometry.bisector.two_curves import BisectorPatch, CurveBisector
    from exactspline.splines.nurbs import Nurbs


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


class Answer(NamedTuple):
    """The result: as data, as tables, and as a drawing."""

    data: dict[str, Any]
    rows: list[Row]
    title: str
    notes: list[str]
    draw: Callable[[], Any]


@printing
def bisector(
    out: Output,
    curve: Annotated[str, Argument(help=CURVE_HELP)],
    other: Annotated[str, Argument(help="A second curve in space; or give a point.")] = "",
    point: Annotated[str, Option("--point", metavar="POINT", help='A point, "1,1/2" or "0,0,2".')] = "",
    variant: Annotated[
        str,
        Option(
            "--variant",
            metavar="VARIANT",
            help=(
                "Two curves: naive, levelled, paper, symmetric, minimal. Point and space curve: naive, "
                "explicit, direct."
            ),
        ),
    ] = "",
    digits: Annotated[
        int, Option("--digits", metavar="N", min=1, max=100_000, help="Digits of irrational parameters and lines.")
    ] = 20,
    output: Annotated[
        str, Option("--output", "-o", metavar="FILE", help="Write the pieces as exact control points (JSON).")
    ] = "",
    plot: Annotated[str, Option("--plot", metavar="FILE", help="Draw it into a file that ends in .svg or .png.")] = "",
) -> None:
    """Bisector of two space curves (its surface, and the lines, planes, single pairs and poles beside it), of a point
    and a space curve (ruled), or, trimmed to equal distances, of a point and a plane curve.
    """
    from exactspline.errors import ShapeError
    from exactspline.interchange.curve_files import write_json

    if other and point:
        raise ShapeError(
            "both a second curve and a point", where="bisector", remedy="name a second curve, or give --point"
        )
    check_output(output, curve, other)
    check_output(plot, curve, other)
    c = load_curve(curve)
    answer = (
        _of_two(c, load_curve(other), variant, digits) if other else _of_point(c, _coordinates(point), variant, digits)
    )
    if output:
        write_json(output, answer.data)
    if plot:
        from exactspline.display.plot.canvas import save

        drawn = answer.draw()
        save(drawn, plot)
        if drawn.name == "3d":
            tell_how_surfaces_are_drawn()
    if out.for_people and (output or plot):
        return
    key = f"{c.name} and {other or point}"
    out.give("bisector", lambda: [{"key": key} | answer.data], lambda: [_sheet(answer)], lambda: _print(c, answer))


def _coordinates(point: str) -> list[str]:
    from exactspline.errors import ShapeError

    if not point:
        raise ShapeError(
            "neither a second curve nor a point",
            where="bisector",
            remedy="name a second curve, or give --point x,y[,z]",
        )
    return [x.strip() for x in point.split(",")]


# ---- two curves


def _of_two(c: Nurbs, other: Nurbs, variant: str, digits: int) -> Answer:
    from exactspline.display.bisector_data import curve_bisector_data, shown
    from exactspline.display.plot.bisectors import plot_curve_bisector
    from exactspline.geometry.bisector.two_curves import SurfaceVariant, curve_bisector

    found = curve_bisector(c, other, variant or SurfaceVariant.MINIMAL)
    rows = [_surface_row(patch) for patch in found.patches]
    rows += _grouped(_line_row(line, digits) for line in found.lines)
    rows += _grouped(_plane_row(plane, digits) for plane in found.planes)
    rows += [
        Row(str(pair.solutions), f"s = {shown(pair.s, digits)}, t = {shown(pair.t, digits)}", "–", str(pair.cause))
        for pair in found.pairs
    ]
    rows += _grouped(_pole_row(pole) for pole in found.poles)
    notes = [f"no surface: {sides.shortly}: {reason}" for sides, reason in found.missing]
    notes += [f"left out: {what}" for what in found.left_out] or [_closing(found)]
    data = {"curves": [c.name, other.name]} | curve_bisector_data(found, digits)
    title = f"bisector of {c.name} (s) and {other.name} (t), {found.variant}"
    return Answer(data, rows, title, notes, lambda: plot_curve_bisector(found))


def _grouped(rows: Iterable[Row]) -> list[Row]:
    """Rows that differ only in their patch merged into one: those of one equation that is shown."""
    found: dict[tuple[object, ...], Row] = {}
    for i, row in enumerate(rows):
        key = (row.piece, row.equation, row.degree, row.remark) if row.equation else (i,)
        found[key] = row if key not in found else row._replace(where=f"{found[key].where}; {row.where}")
    return list(found.values())


def _closing(found: CurveBisector) -> str:
    nothing = not (found.patches or found.lines or found.planes or found.pairs)
    return "complete: there is no bisector" if nothing else "complete: nothing is left out"


def _surface_row(patch: BisectorPatch) -> Row:
    from exactspline.display.bisector_data import counted, degree_of
    from exactspline.numbers.exact import short_text

    remark = f"{counted(patch.value)} control points"
    if max(patch.value.degree) == 0:
        point = patch.value.point(patch.sides[0][0], patch.sides[1][0])
        remark = f"one point: ({', '.join(map(short_text, point))})"
    return Row("surface", patch.sides.shortly, degree_of(patch.value), remark)


def _line_row(line: LineComponent, digits: int) -> Row:
    from exactspline.display.bisector_data import shown

    degrees = {piece.surface.degree for piece in line.pieces}
    if line.pieces:
        where = "; ".join(f"{'st'[x.of]} in [{shown(x.low, digits)}, {shown(x.high, digits)}]" for x in line.pieces)
    elif line.over_root is not None:
        own = line.over_root
        degrees = {own.degree}
        where = f"{'ts'[own.of]} = {shown(own.other, digits)}; {'st'[own.of]} in {own.interval.shortly}"
    else:
        where = f"{len(line.real.branches)} branches"
    where, short = _pairs(line.equation, line.sides, where)
    return Row("lines", where, ", ".join(map(str, degrees)) or "–", str(line.cause), short)


def _plane_row(plane: PlaneComponent, digits: int) -> Row:
    from exactspline.display.bisector_data import shown

    where = "; ".join(f"{'st'[plane.of]} in [{shown(a, digits)}, {shown(b, digits)}]" for a, b in plane.intervals)
    kind = "planes" if plane.equation is not None and plane.fixed is None else str(plane.solutions)
    where, short = _pairs(plane.equation, plane.sides, where)
    return Row(kind, where, "–", str(plane.cause), short)


def _pole_row(pole: PoleCurve) -> Row:
    certain = "the surface is at infinity" if pole.certain else "the surface is at infinity, if there are such pairs"
    where, short = _pairs(pole.equation, pole.sides, "")
    return Row("poles", where, "–", certain, short)


def _pairs(equation: PairEquation | None, sides: Any, where: str) -> tuple[str, PairEquation | None]:
    """The pairs of an equation on a patch as text, and the equation if it is short enough to stand before them."""
    if equation is None:
        return f"all of {sides.shortly}", None
    where = where or sides.shortly
    return (where, equation) if equation.is_short else (f"{equation.short_text}: {where}", None)


# ---- a point and a curve


def _of_point(c: Nurbs, point: list[str], variant: str, digits: int) -> Answer:
    from exactspline.errors import FormulaError

    title = f"bisector of {c.name} and the point ({', '.join(point)})"
    if c.dimension != 2:
        return _ruled(c, point, variant, digits, title)
    if variant:
        raise FormulaError(
            f"the variant {variant!r} of a planar bisector",
            remedy="leave the variant out: it is trimmed, in lowest terms",
        )
    return _trimmed(c, point, digits, title)


def _trimmed(c: Nurbs, point: list[str], digits: int, title: str) -> Answer:
    from exactspline.display.bisector_data import shown, trimmed_data
    from exactspline.display.plot.bisectors import plot_trimmed_bisector
    from exactspline.geometry.bisector.trimmed import trimmed_bisector
    from exactspline.numbers.exact import short_text

    found = trimmed_bisector(c, point)
    data = {"name": "bisector", "curve": c.name, "point": point} | trimmed_data(found, digits)
    rows = [
        Row(
            str(piece.kind),
            f"[{shown(piece.low, digits)}, {shown(piece.high, digits)}]",
            str(piece.value.degree),
            "" if piece.foot is None else f"foot at {short_text(piece.foot)}",
        )
        for piece in found.pieces
    ]
    notes = [f"missing: {reason}" for reason in found.missing] + [f"left out: {what}" for what in found.left_out]
    return Answer(data, rows, f"{title}, trimmed", notes, lambda: plot_trimmed_bisector(found, c, point))


def _ruled(c: Nurbs, point: list[str], variant: str, digits: int, title: str) -> Answer:
    from exactspline.display.bisector_data import point_bisector_data, shown
    from exactspline.display.plot.bisectors import plot_point_bisector
    from exactspline.geometry.bisector.point_and_curve import point_bisector

    found = point_bisector(c, point, variant or "direct")
    rows = [
        Row(
            "ruled surface",
            piece.interval.shortly,
            str(piece.surface.degree),
            f"ruling parameter {piece.moved}" if piece.moved else "",
        )
        for piece in found.pieces
    ]
    rows += [Row("singular", shown(root, digits), "–", "the generator vanishes") for root in found.singular]
    notes = [f"missing: {interval.shortly}: {reason}" for interval, reason in found.missing]
    data = {"name": "bisector", "curve": c.name, "point": point} | point_bisector_data(found, digits)
    return Answer(data, rows, f"{title} ({found.variant})", notes, lambda: plot_point_bisector(found, c, point))


def _sheet(answer: Answer) -> Sheet:
    from exactspline.display.sheet import Sheet

    made = Sheet("piece", "parameters", "degree", "remark", title=answer.title, prose=["parameters", "remark"])
    for row in answer.rows:
        made.add_row(row.piece, row.parameters, row.degree, row.remark)
    return made


def _print(c: Nurbs, answer: Answer) -> None:
    from exactspline.display import console

    shown, made = console.console(), _sheet(answer)
    console.lines(shown, made.title, style="bold")
    made.title = described(c)
    shown.print(made)
    for note in answer.notes:
        console.lines(shown, note)
