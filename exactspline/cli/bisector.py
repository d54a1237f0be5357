"""``bisector``: of two curves, or of a point and a curve."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.cli.common import check_output, load_curve, tell_written
from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from collections.abc import Callable

    from exactspline.display.bisector_data import Row
    from exactspline.splines.nurbs import Nurbs


class _Answer(NamedTuple):
    """The result: as data, as tables, and as a drawing."""

    data: dict[str, Any]
    rows: list[Row]
    notes: list[str]
    title: str
    draw: Callable[[], Any]


@printing
def bisector(
    out: Output,
    curve: str,
    other: str = "",
    point: str = "",
    variant: str = "",
    digits: int = 12,
    output: str = "",
    plot: str = "",
) -> None:
    """Compute the bisector of two space curves (a surface, in addition to lines, planes, single pairs and poles), of a
    point and a space curve (a ruled surface), of two plane curves (correspondences of parameters, and the boxes in
    which the corresponding points are proved nearest), or of a point and a plane curve (trimmed to equal distances).
    """
    from exactspline.display.bisector_data import bisector_sheet
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
        tell_written(output)
    if plot:
        from exactspline.display.plot.canvas import save

        save(answer.draw(), plot)
        tell_written(plot)
    if out.for_people and (output or plot):
        return
    key = f"{c.name} and {other or point}"
    sheets = [bisector_sheet(answer.rows, answer.title)]
    out.give("bisector", [{"key": key} | answer.data], sheets, lambda: _print(out, c, answer))


def _coordinates(point: str) -> list[str]:
    from exactspline.errors import ShapeError

    if not point:
        problem = "neither a second curve nor a point"
        raise ShapeError(problem, where="bisector", remedy="name a second curve, or give --point x,y[,z]")
    return [x.strip() for x in point.split(",")]


def _of_two(c: Nurbs, other: Nurbs, variant: str, digits: int) -> _Answer:
    from exactspline.display import bisector_data
    from exactspline.display.answer_forms import bisector_answer
    from exactspline.display.plot.anything import picture
    from exactspline.errors import FormulaError
    from exactspline.geometry.bisectors.plane_curves import PlaneBisector
    from exactspline.geometry.bisectors.two_curves import SurfaceVariant, curve_bisector
    from exactspline.geometry.curves.planarity import in_one_plane

    c, other = (c, other) if variant else in_one_plane(c, other)
    head, title = {"curves": [c.name, other.name]}, f"bisector of {c.name} (s) and {other.name} (t)"
    if c.dimension == other.dimension == 2:
        if variant:
            raise FormulaError(f"the variant {variant!r} of a bisector in the plane", remedy="leave the variant out")
        flat = PlaneBisector(c, other)
        data = head | bisector_answer(flat, digits) | bisector_data.feet_data(flat, digits)
        return _Answer(
            data,
            *bisector_data.of_plane_curves(flat, digits),
            title,
            partial(picture, "bisector of plane curves", flat),
        )
    found = curve_bisector(c, other, variant or SurfaceVariant.MINIMAL)
    data = head | bisector_answer(found, digits)
    rows, notes = bisector_data.of_two_curves(found, digits)
    return _Answer(data, rows, notes, f"{title}, {found.variant}", partial(picture, "bisector of curves", found))


def _of_point(c: Nurbs, point: list[str], variant: str, digits: int) -> _Answer:
    from exactspline.display import bisector_data
    from exactspline.display.answer_forms import bisector_answer
    from exactspline.display.plot.anything import picture
    from exactspline.errors import FormulaError
    from exactspline.geometry.bisectors.point_and_curve import point_bisector
    from exactspline.geometry.bisectors.trimmed import trimmed_bisector
    from exactspline.geometry.curves.planarity import in_the_plane

    c = in_the_plane(c) if len(point) == 2 else c
    head: dict[str, object] = {"name": "bisector", "curve": c.name, "point": point}
    title = f"bisector of {c.name} and the point ({', '.join(point)})"
    if c.dimension != 2:
        ruled = point_bisector(c, point, variant or "direct")
        data, title = head | bisector_answer(ruled, digits), f"{title} ({ruled.variant})"
        rows, notes = bisector_data.of_point_in_space(ruled, digits)
        return _Answer(data, rows, notes, title, partial(picture, "bisector of a point", ruled, c, point))
    if variant:
        problem = f"the variant {variant!r} of a planar bisector"
        raise FormulaError(problem, remedy="leave the variant out: it is trimmed, in lowest terms")
    found = trimmed_bisector(c, point)
    data, title = head | bisector_answer(found, digits), f"{title}, trimmed"
    rows, notes = bisector_data.of_point_in_plane(found, digits)
    return _Answer(data, rows, notes, title, partial(picture, "trimmed bisector", found, c, point))


def _print(out: Output, c: Nurbs, answer: _Answer) -> None:
    from exactspline.display import console
    from exactspline.display.bisector_data import bisector_sheet
    from exactspline.display.numbers import described

    shown, sheet = console.console(), bisector_sheet(answer.rows, described(c))
    console.lines(shown, answer.title, style="bold")
    shown.print(sheet)
    for note in answer.notes:
        console.lines(shown, note)
    if not out.quiet:
        console.legend(shown, [*sheet.columns, *sheet.tags])
