"""``between``: the common points of two curves, or how two surfaces meet along their borders."""

from __future__ import annotations

from collections.abc import Iterator

from exactspline.cli.common import (
    answer_about_pair,
    check_distance,
    check_output,
    load_curve,
    only_one,
    reading_of,
    refuse_with_ask,
    surfaces_among,
    surfaces_in,
    tell_written,
    with_distance,
    write_theorems,
)
from exactspline.cli.output import Output, printing


@printing
def between(
    out: Output,
    curve: str,
    other: str,
    ask: list[str] | None = None,
    digits: int = 12,
    epsilon: str = "",
    plot: str = "",
    emit_coq: str = "",
) -> None:
    """Find all common points of two curves, exactly and with multiplicities, and all common arcs. If the curves do not
    meet, find the pairs of points at the least distance. For two surfaces, find the common arcs of their borders, and
    how the surfaces meet along these arcs (common_borders).
    """
    from exactspline.display import console
    from exactspline.display.answer_forms import FORMS_BESIDE, answers_data, pair_sheet
    from exactspline.display.features import common_points_sheet
    from exactspline.geometry.analysis.pairs import CurvePair
    from exactspline.geometry.analysis.surface_pairs import SurfacePair

    refuse_with_ask({"--plot": plot, "--emit-coq": emit_coq} if ask else {})
    check_output(plot, curve, other)
    check_output(emit_coq, curve, other)
    readings = [(name, reading_of(name)) for name in (curve, other)]
    if len(found := surfaces_among(readings, requested=False)) == len(readings):
        refuse_with_ask({"--plot": plot, "--emit-coq": emit_coq, "--epsilon": epsilon}, "surfaces")
        surfaces = [only_one(surfaces_in(*each), "surface", each[0], "--surfaces ") for each in found]
        answer_about_pair(out, SurfacePair(*surfaces), ask or ["common_borders"], digits)
        return
    first, second = (load_curve(*each) for each in readings)
    if emit_coq:
        write_theorems(emit_coq, first, second)
    check_distance(epsilon)
    pair = CurvePair(first, second)
    if ask:
        answer_about_pair(out, pair, with_distance(ask, epsilon, (), of_pair=True), digits)
        return
    sheets = [pair_sheet(pair, f"{first.name} (s) and {second.name} (t)", digits)]
    if epsilon:
        title = f"All curves within {epsilon} of {first.name} (s) and of {second.name} (t)"
        sheets.append(common_points_sheet(pair.intersections_within(epsilon), title))
    if plot:
        from exactspline.display.plot.canvas import save
        from exactspline.display.plot.curves import pair_figure

        save(pair_figure(pair), plot)
        tell_written(plot)
        if out.for_people:
            return

    def people() -> None:
        shown = console.console()
        console.below_each_other(shown, sheets)
        for what in pair.intersections.undecided or pair.distance.undecided:
            console.lines(shown, f"not decided: {what}")

    def rows() -> Iterator[dict[str, object]]:
        row = {"key": f"{curve} and {other}", "curves": [first.name, second.name]} | answers_data(pair, digits)
        if epsilon:
            found = FORMS_BESIDE["between"]["meetings"].write(pair.intersections_within(epsilon), digits)
            row |= {"epsilon": epsilon, "meetings": found}
        yield row

    out.give("between", rows(), sheets[:1], people)
