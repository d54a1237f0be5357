"""``inspect``: the features of a curve, or of a surface."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.cli.common import (
    Read,
    also_in_their_planes,
    answer_about_curves,
    answer_about_surfaces,
    check_approximate,
    check_distance,
    distinguish,
    each_read,
    read_curves,
    reading_of,
    refuse_with_ask,
    see_that_coq_can_name,
    tell_written,
    with_distance,
    write_theorems,
)
from exactspline.cli.output import Exit, OptionsError, Output, printing, ticking

if TYPE_CHECKING:
    from exactspline.geometry.analysis.inspection import Report
    from exactspline.interchange.records import Reading
    from exactspline.splines.nurbs import Nurbs


@printing
def inspect(
    out: Output,
    curve: list[str],
    ask: list[str] | None = None,
    digits: int = 12,
    epsilon: str = "",
    stability: bool = False,
    plot: str = "",
    surfaces: bool = False,
    approximate: str = "",
    coordinates: bool = False,
    with_all: bool = False,
    region: str = "",
    certificates: bool = False,
    certificate: str = "",
    emit_coq: str = "",
) -> None:
    """Find the corners, cusps, inflections, curvature extrema and torsion zeros of curves in the plane or in space,
    certified and to any number of digits. For a surface, find the sign of the Gaussian curvature, the parabolic curves,
    the umbilics and the poles. For a map of the plane, find the sign of the Jacobian determinant.
    """
    from exactspline.cli.common import surfaces_among

    check_approximate(approximate)
    for_curves: dict[str, str | bool] = {
        "--coordinates": coordinates,
        "--stability": stability,
        "--certificate": certificate,
        "--emit-coq": emit_coq,
    }
    if ask:
        refuse_with_ask(for_curves | {"--plot": plot, "--all": with_all})
        near = with_distance(ask, epsilon, ())
        if epsilon and near == ask:
            remedy = "it is for those that end in _within, such as features_within"
            raise OptionsError(f"--epsilon and --ask {ask[0]}", remedy=remedy)
        ask = near
    elif certificates:
        raise OptionsError("--certificates without --ask", remedy="add --ask QUESTION, or write --certificate FILE")
    elif region:
        raise OptionsError("--region without --ask", remedy="add --ask area, moments or contains:1,2")
    read, good = each_read(curve, lambda name: (name, reading_of(name, approximate)))
    if with_surfaces := surfaces_among(read, requested=surfaces):
        if len(with_surfaces) < len(read):
            raise OptionsError("surfaces and curves", remedy="inspect them one after the other")
        for_curves |= {"--approximate": approximate, "--certificates": certificates, "--region": region}
        _inspect_surfaces(out, with_surfaces, ask, for_curves, digits, plot, epsilon, good, with_all)
    elif ask:
        answer_about_curves(out, read_curves(read, good), ask, digits, certificates=certificates, region=region)
    else:
        from exactspline.geometry.curves.planarity import in_the_plane

        found, good = read_curves(read, good)
        _see_that_they_fit(found, epsilon, emit_coq)
        if emit_coq and found:
            write_theorems(emit_coq, found[0].curve)
        inspected = [
            _inspected(replace(each, curve=c), digits, coordinates, epsilon, stability, with_all)
            for each in found
            for c in also_in_their_planes([in_the_plane(each.curve)])
        ]
        _give(out, inspected, [each.curve for each in found], certificate, plot, ", ".join(curve))
        if not good:
            raise Exit(2)


def _inspect_surfaces(
    out: Output,
    read: Sequence[tuple[str, Reading]],
    ask: list[str] | None,
    for_curves: Mapping[str, str | bool],
    digits: int,
    plot: str,
    epsilon: str,
    good: bool,
    with_all: bool,
) -> None:
    """Inspect the surfaces in the readings; `for_curves` are the options that are only for curves."""
    from exactspline.cli.common import inspect_surfaces, surfaces_in

    own = [surface for pair in read for surface in surfaces_in(*pair)]
    if refused := next((option for option, value in for_curves.items() if value), ""):
        raise OptionsError(f"{refused} and a surface", remedy=f"omit {refused}: it is only for curves")
    if ask:
        answer_about_surfaces(out, own, ask, digits, good=good)
        return
    check_distance(epsilon)
    inspect_surfaces(out, own, digits, plot, epsilon, good=good, with_all=with_all)


def _see_that_they_fit(found: Sequence[Read], epsilon: str, emit_coq: str) -> None:
    """Refuse options for curves that cannot be given together."""
    if emit_coq and len(found) > 1:
        raise OptionsError("--emit-coq and several curves", remedy="write one file per curve")
    if emit_coq:
        see_that_coq_can_name(emit_coq)
    check_distance(epsilon)


def _give(
    out: Output, inspected: list[_Inspected], given: list[Nurbs], certificate: str, plot: str, title: str
) -> None:
    """Print and write the results, as the options ask."""
    from exactspline.display.features import feature_sheet
    from exactspline.interchange.curve_files import write_json

    if certificate:
        write_json(certificate, [proof for each in inspected for proof in _proofs(each.report.curve)])
        tell_written(certificate)
    if plot and inspected:
        _draw([each.report for each in inspected], given, plot, title)
        tell_written(plot)
    out.give(
        "inspect",
        _rows(inspected),
        (feature_sheet(each.report, each.digits) for each in inspected),
        lambda: _print_all(out, inspected),
        by="curve",
    )


def _rows(inspected: list[_Inspected]) -> Iterator[dict[str, Any]]:
    """The results as data, each row with its own key."""
    yield from distinguish([each.data() for each in inspected])


def _print_all(out: Output, inspected: list[_Inspected]) -> None:
    from exactspline.display import console
    from exactspline.display.features import print_features, report_sheets, words_of

    words = list[str]()
    for i, each in enumerate(inspected):
        if i:
            console.console().print()
        tables = report_sheets(each.report, each.digits)
        print_features(each.report, tables)
        words += words_of(each.report, tables)
    if inspected and not out.quiet:
        in_space = any(each.report.curve.dimension == 3 for each in inspected)
        console.legend(console.console(), ["κ", *["τ"] * in_space, *words])


class _Inspected(NamedTuple):
    """A curve that was read, the report about it, and the number of digits to print."""

    read: Read
    report: Report
    digits: int

    def data(self) -> dict[str, object]:
        """The curve and its report as data."""
        from exactspline.display.answer_forms import report_data

        c = self.report.curve
        with ticking("refining", self.features) as tick:
            return (
                {"key": f"{c.name} in R{c.dimension}"} | self.read.data() | report_data(self.report, self.digits, tick)
            )

    @property
    def features(self) -> int:
        """The number of its features."""
        from exactspline.roots.answers import Places

        return sum(len(answer) for answer in self.report.answers.values() if isinstance(answer, Places))


def _inspected(read: Read, digits: int, coordinates: bool, epsilon: str, stability: bool, with_all: bool) -> _Inspected:
    """A curve with the report that the options ask for."""
    from exactspline.geometry.analysis.inspection import Report, inspect_curve
    from exactspline.numbers.exact import text
    from exactspline.splines.precision import WRITTEN, distance

    found = inspect_curve(read.curve).curve
    within = distance(epsilon, read.curve) if epsilon else None
    written = text(within) if within is not None and epsilon == WRITTEN else epsilon
    return _Inspected(read, Report(found, written, within, stability, coordinates, with_all), digits)


def _proofs(curve: Nurbs) -> list[dict[str, object]]:
    """The certificates of the zeros of every function of the curve that was solved."""
    from exactspline.geometry.analysis.inspection import solved

    return [
        {"curve": curve.name, "function": name, "certificate": zero_set.certificate()}
        for name, _, _, zero_set in solved(curve)
    ]


def _draw(reports: list[Report], given: list[Nurbs], path: str, title: str) -> None:
    """Draw one curve next to the functions whose zeros were computed, or several curves in one picture."""
    from exactspline.display.plot.canvas import save
    from exactspline.display.plot.functions import features_figure, inspect_figure
    from exactspline.geometry.analysis.inspection import solved

    if len({c.dimension for c in given}) > 1:
        raise OptionsError("--plot and curves of the plane and of space", remedy="draw them separately")
    if len(given) > 1:
        # curves of a file that lie in a coordinate plane are drawn there
        flat = [each.curve for each in reports if each.curve.dimension == 2]
        save(features_figure(flat if len(flat) == len(given) else given, title), path)
        return
    report = reports[0]
    panels = [(title, f, zero_set) for _, title, f, zero_set in solved(report.curve)[:2]]
    save(inspect_figure(report.curve, panels, stability=report.with_stability), path)
