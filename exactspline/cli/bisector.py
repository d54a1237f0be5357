"""``bisector``: of two curves, or of a point and a curve."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from exactspline.cli.common import AsJson, check_output, described, print_json


def bisector(
    curve: Annotated[str, typer.Argument(help="A curve file (JSON) or the name of an example curve.")],
    other: Annotated[str, typer.Argument(help="A second curve in space; or give a point.")] = "",
    point: Annotated[str, typer.Option("--point", help='A point, "1,1/2" or "0,0,2".')] = "",
    variant: Annotated[
        str,
        typer.Option(
            "--variant",
            help=(
                "Two curves: naive, levelled, paper, symmetric, minimal. Point and space curve: naive, "
                "explicit, direct."
            ),
        ),
    ] = "",
    digits: Annotated[
        int, typer.Option("--digits", min=1, max=100_000, help="Digits of the ends of trimmed pieces.")
    ] = 20,
    output: Annotated[
        str, typer.Option("--output", "-o", help="Write the pieces as exact control points (JSON).")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Bisector of two space curves, of a point and a space curve (ruled), or, trimmed to equal distances, of a point
    and a plane curve.
    """
    from exactspline.errors import ShapeError
    from exactspline.splines.curve_files import write_json
    from exactspline.splines.examples import load

    if other and point:
        raise ShapeError(
            "both a second curve and a point", where="bisector", remedy="name a second curve, or give --point"
        )
    check_output(output, curve, other)
    c = load(curve)
    data, rows, title = (
        _of_two(c, load(other), variant) if other else _of_point(c, _coordinates(point), variant, digits)
    )
    if output:
        write_json(output, data)
    if as_json:
        print_json(data)
    elif not output:
        _print(c, rows, title, data["missing"])


def _coordinates(point: str) -> list[str]:
    from exactspline.errors import ShapeError

    if not point:
        raise ShapeError(
            "neither a second curve nor a point",
            where="bisector",
            remedy="name a second curve, or give --point x,y[,z]",
        )
    return [x.strip() for x in point.split(",")]


def _of_two(c: Any, other: Any, variant: str) -> tuple[dict[str, Any], list[tuple[str, ...]], str]:
    from exactspline.display.serialize import counted, curve_bisector_data, degree_of
    from exactspline.exact import text
    from exactspline.geometry.bisectors import curve_bisector

    found = curve_bisector(c, other, variant or "minimal")
    rows: list[tuple[str, ...]] = []
    for patch in found.patches:
        where = " × ".join(f"[{text(a)}, {text(b)}]" for a, b in patch.sides)
        rows.append(("surface", where, degree_of(patch.value), str(counted(patch.value)), ""))
    return curve_bisector_data(found), rows, f"bisector of {c.name} and {other.name} ({found.variant})"


def _of_point(c: Any, point: list[str], variant: str, digits: int) -> tuple[dict[str, Any], list[tuple[str, ...]], str]:
    from exactspline.display.serialize import point_bisector_data, trimmed_data
    from exactspline.errors import FormulaError
    from exactspline.exact import text
    from exactspline.geometry.bisectors import point_bisector
    from exactspline.geometry.trimmed_bisector import trimmed_bisector
    from exactspline.splines.lowest_terms import control_point_count

    title = f"bisector of {c.name} and the point ({', '.join(point)})"
    if c.dimension == 2:
        if variant:
            raise FormulaError(
                f"the variant {variant!r} of a planar bisector",
                remedy="leave the variant out: it is trimmed, in lowest terms",
            )
        trimmed = trimmed_bisector(c, point)
        data = trimmed_data(trimmed, digits)
        pieces: list[tuple[str, ...]] = [
            (
                p["piece"],
                f"[{p['low']['decimal']}, {p['high']['decimal']}]",
                str(p["degree"]),
                str(len(p["homogeneous_control_points"])),
                _foot(p),
            )
            for p in data["pieces"]
        ]
        return data, pieces, f"{title}, trimmed"
    found = point_bisector(c, point, variant or "direct")
    rows: list[tuple[str, ...]] = [
        (
            "ruled surface",
            f"[{text(piece.interval[0])}, {text(piece.interval[1])}]",
            str(piece.surface.degree),
            str(control_point_count(piece.surface.joined)),
            f"ruling parameter {piece.moved}" if piece.moved else "",
        )
        for piece in found.pieces
    ]
    data = point_bisector_data(found, digits)
    rows += [("singular", root["decimal"], "–", "–", "the generator vanishes") for root in data["singular"]]
    return data, rows, f"{title} ({found.variant})"


def _foot(piece: dict[str, Any]) -> str:
    return f"foot at {piece['foot']}" if "foot" in piece else ""


def _print(c: Any, rows: list[tuple[str, ...]], title: str, missing: list[Any]) -> None:
    from exactspline.display import console

    out = console.console()
    numbers = ("degree", "control points")
    made = console.table("piece", "parameter", *numbers, "remark", title=f"{title}\n{described(c)}", right=numbers)
    for row in rows:
        made.add_row(*row)
    out.print(made)
    for gap in missing:
        out.print(f"missing: {gap if isinstance(gap, str) else _where(gap) + ': ' + gap['reason']}", markup=False)


def _where(gap: dict[str, Any]) -> str:
    """The interval or the rectangle of a gap."""
    return " × ".join(f"[{a}, {b}]" for a, b in gap.get("sides", [gap.get("interval")]))
