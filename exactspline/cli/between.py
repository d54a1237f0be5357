"""``between``: what two curves have in common."""

from __future__ import annotations

from typing import Annotated, Any

from exactspline.cli.common import CURVE_HELP, Drawing, Places, check_output, load_curve, tell_written
from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument


@printing
def between(
    out: Output,
    curve: Annotated[str, Argument(help=CURVE_HELP)],
    other: Annotated[str, Argument(help="A second curve, of the same dimension.")],
    digits: Places = 12,
    plot: Drawing = "",
) -> None:
    """All points that two curves have in common, exactly, with multiplicities; the arcs along which they run together;
    or, if there are none, the pairs of points at the least distance.
    """
    from exactspline.display import console
    from exactspline.display.pair_data import pair_data, pair_sheet
    from exactspline.geometry.curve_pair import CurvePair

    check_output(plot, curve, other)
    first, second = load_curve(curve), load_curve(other)
    pair = CurvePair(first, second)
    data: Any = pair_data(pair, digits)
    if plot:
        from exactspline.display.plot.canvas import save
        from exactspline.display.plot.curve_pairs import pair_figure

        save(pair_figure(pair), plot)
        tell_written(plot)
        if out.for_people:
            return
    sheet = pair_sheet(data, f"{first.name} (s) and {second.name} (t)")

    def people() -> None:
        shown = console.console()
        shown.print(sheet)
        left_out = data["intersections"]["left_out"] or data["distance"]["left_out"]
        for what in left_out:
            console.lines(shown, f"not decided: {what}")

    row = {"key": f"{curve} and {other}", "curves": [first.name, second.name]} | data
    out.give("between", [row], [sheet], people)
