"""The common parts of several commands: their options, the functions that read curves and surfaces, the output of
``inspect`` for surfaces, and the exact answers of ``--ask``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from exactspline.cli.output import Exit, OptionsError, Output, is_quiet, leave_out, ticking, to_stderr
from exactspline.errors import ClaimError, CurveFileError, ExactSplineError, NumberError, command_name, counted
from exactspline.hooks import named
from exactspline.numbers.exact import rational

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.analysis.ask import About
    from exactspline.geometry.analysis.pairs import CurvePair
    from exactspline.geometry.analysis.surface_pairs import SurfacePair
    from exactspline.geometry.analysis.surfaces import SurfaceInspection
    from exactspline.interchange.records import Reading
    from exactspline.questions.entry import Of
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface
    from exactspline.verification.claim import Claim

#: The most digits of the certified intervals of an answer.
DIGITS = 1000
#: The objects of a question, each with data that name it.
_Asked = Sequence[tuple[Mapping[str, object], "About"]]


def refuse_with_ask(options: Mapping[str, object], what: str = "--ask") -> None:
    """Refuse an option that has no effect together with a question, or together with `what`."""
    if refused := next((option for option, value in options.items() if value), ""):
        raise OptionsError(f"{refused} and {what}", remedy=f"give {refused} in a command without {what}")


def answer_about_curves(
    out: Output, found: tuple[list[Read], bool], asked: list[str], digits: int, *, certificates: bool, region: str
) -> None:
    """Answer questions about curves. `found` are the curves, and whether all of them could be read; with the rule of a
    `region`, the questions are about the region that the curves bound together.
    """
    from exactspline.geometry.pairs.regions import Region
    from exactspline.questions.entry import ALL_CURVES, Of

    read, good = found
    given: _Asked = [({"curve": x.curve.name} | x.data(), x.curve) for x in read]
    if region and given:
        bounded = Region([x.curve for x in read], region)
        given = [({"curve": f"region of {counted(len(given), 'curve')}, {region}"}, bounded)]
    _answer(out, given, asked, digits, (Of.REGION,) if region else ALL_CURVES, certificates=certificates, good=good)


def answer_about_pair(out: Output, pair: CurvePair | SurfacePair, asked: list[str], digits: int) -> None:
    """Answer questions about two curves, or two surfaces."""
    from exactspline.geometry.analysis.ask import kind_of
    from exactspline.geometry.analysis.pairs import CurvePair

    of = {"curve": pair.curves} if isinstance(pair, CurvePair) else {"surface": pair.surfaces}
    given = {what: " and ".join(each.name for each in both) for what, both in of.items()}
    _answer(out, [(given, pair)], asked, digits, (kind_of(pair),))


def answer_about_surfaces(
    out: Output, surfaces: Sequence[NurbsSurface], asked: list[str], digits: int, *, good: bool
) -> None:
    """Answer questions about surfaces and maps of the plane; `good` is whether all could be read."""
    from exactspline.questions.entry import Of

    _answer(out, [({"surface": x.name}, x) for x in surfaces], asked, digits, (Of.SURFACE, Of.PLANAR_MAP), good=good)


def _answer(
    out: Output,
    given: _Asked,
    asked: list[str],
    digits: int,
    kinds: Iterable[Of],
    *,
    certificates: bool = False,
    good: bool = True,
) -> None:
    """Print the answers: exact values, certified intervals, correctly rounded doubles."""
    from exactspline.display.answer_forms import answer_data, answer_sheet, records
    from exactspline.display.sheet import Sheet
    from exactspline.errors import ExactSplineError
    from exactspline.geometry.analysis.ask import asked_of, check_question, facts_about

    for question in asked:
        check_question(question, *kinds)
    if digits > DIGITS:
        raise OptionsError(f"--digits {digits}", remedy=f"answers have at most {DIGITS}")
    rows: list[dict[str, Any]] = []
    sheets: list[Sheet] = []
    for of, about in given:
        facts, name = facts_about(about), next(iter(of.values()))
        for question in asked:
            title = f"{name}: {question}"
            row = {"key": title, **of, "question": question, "answer": None, "certificates": [], "error": ""}
            try:
                found = asked_of(facts, question)
                if out.format == "json" or out.strict:
                    row["answer"] = answer_data(found, digits)
                    row["certificates"] = [proof.certificate() for proof in found.proofs if certificates]
                if out.format != "json":
                    sheets.append(answer_sheet(title, records(found), digits))
            except ExactSplineError as error:
                row["error"] = str(error)
                refused = [("no answer", "", str(error), "")]
                columns = ("what", "name", "value", "double")
                sheets.append(Sheet(*columns, rows=refused, title=title, name=title, prose=["value"]))
            rows.append(row)
    out.give("answers", distinguish(rows), sheets, by="answer")
    if not good or any(row["error"] for row in rows):
        raise Exit(2)


G = TypeVar("G")
V = TypeVar("V")
C = TypeVar("C", "Nurbs", "NurbsSurface")


def claims_of_papers(names: Sequence[str] | None, trust: bool) -> tuple[Claim, ...]:
    """The claims of papers, given by name or folder; of the default papers where none is given."""
    from exactspline.papers import named_papers
    from exactspline.verification.claims import claims_in, claims_of

    sources = named_papers(names or [], trust=trust, partly=True)
    for source in sources:
        if not claims_of(source):
            raise ClaimError("states no claims", where=source.name, remedy="write them into claims.toml: [[claim]]")
    return claims_in(sources)


def load_curve(name: str, reading: Reading | None = None) -> Nurbs:
    """The one curve that a name, a file or standard input (``-``) means, or that `reading` holds, if it is given."""
    return only_one(_curves_in(name, reading or reading_of(name))[0], "curve", name)


def only_one(found: Sequence[C], what: str, name: str, options: str = "") -> C:
    """The only curve or surface (`what`) of a file; the error for several says how `convert` extracts one."""
    if len(found) > 1:
        names = ", ".join(each.name for each in found[:8]) + (", …" if len(found) > 8 else "")
        raise CurveFileError(
            f"{counted(len(found), what)}, where one is expected",
            where=name,
            remedy=f"take one: {command_name()} convert {name} one.json {options}--only NAME, of {names}",
        )
    return found[0]


@dataclass(frozen=True)
class Read:
    """A curve that was read: the name that was given for its file, its number in the file, and the curve."""

    source: str
    index: int
    curve: Nurbs

    def data(self) -> dict[str, object]:
        """Which curve it is, as data."""
        from exactspline.interchange.curve_files import curve_digest

        return {"source": self.source, "index": self.index, "digest": curve_digest(self.curve)}


def loaded(names: Iterable[str]) -> tuple[list[Nurbs], bool]:
    """The curves that can be read, and whether all could (see `read_curves`)."""
    found, good = read_curves(*each_read(names, lambda name: (name, reading_of(name))))
    return [each.curve for each in found], good


def read_curves(given: Iterable[tuple[str, Reading]], good: bool) -> tuple[list[Read], bool]:
    """The curves in readings, which are given with their names, and whether all could be read."""
    found, all_good = each_read(given, lambda pair: (pair[0], *_curves_in(*pair)))
    curves = [Read(name, index, curve) for name, own, _ in found for index, curve in enumerate(own)]
    return curves, good and all_good and all(complete for *_, complete in found)


def each_read(names: Iterable[G], read: Callable[[G], V]) -> tuple[list[V], bool]:
    """The results of `read` for all names for which it succeeds, and whether it succeeded for all; each error is
    reported on standard error.
    """
    found, good = list[V](), True
    for name in names:
        try:
            found.append(read(name))
        except ExactSplineError as error:
            to_stderr(f"error: {error}")
            good = False
    return found, good


def distinguish(rows: list[dict[str, object]]) -> list[dict[str, object]]:
    """The rows, with different keys: where several curves have one name, their keys say in which file each was read;
    keys that are still equal are numbered.
    """
    times = Counter(row["key"] for row in rows)
    for row in rows:
        if times[row["key"]] > 1 and "source" in row:
            row["key"] = f"{row['key']} ({row['source']}, curve {row['index']})"
    seen = Counter[object]()
    for row in rows:
        seen[row["key"]] += 1
        if (time := seen[row["key"]]) > 1:
            row["key"] = f"{row['key']}, {time}"
    return rows


def reading_of(name: str, approximate: str = "") -> Reading:
    """The reading of a name, of a file in any format, or of standard input (``-``)."""
    from exactspline.interchange.examples import example, examples
    from exactspline.interchange.records import NamedCurve, Reading
    from exactspline.splines.nurbs import Nurbs

    if name in examples() and not Path(name).exists():  # without the readers of all formats
        made = example(name)
        if isinstance(made, Nurbs):
            return Reading("json", (NamedCurve(name, made),))
        return Reading("json", (), surfaces=(made,))
    from exactspline.interchange.files import read

    with ticking(f"reading {name}", 1):
        return read(name, approximate=approximate or None)


def _curves_in(name: str, reading: Reading) -> tuple[list[Nurbs], bool]:
    """The curves in a reading, and whether all could be read; whatever is skipped is named on standard error. Notes are
    printed, too, except that of a single curve in our own JSON, since it stands in the file itself.
    """
    if reading.surfaces and not (reading.curves or reading.skipped):
        problem = f"holds {counted(len(reading.surfaces), 'surface')}, where a curve is expected"
        raise CurveFileError(problem, where=name, remedy=f"`{command_name()} inspect` reads surfaces")
    tell_skipped(reading, name)
    if reading.format != "json" or len(reading.curves) > 1:
        tell_notes(reading)
    if not reading.curves:
        what = "nothing that is a curve" if reading.skipped or reading.surfaces else "no curves"
        raise CurveFileError(f"holds {what}", where=name, remedy="name a file of curves")
    return [named.curve for named in reading.curves], reading.complete


def tell_notes(reading: Reading, *, curves: bool = True) -> None:
    """Print the notes of a reader on standard error, each once, with the curve or the number of curves it is about;
    `curves` says whether curves are taken.
    """
    if is_quiet():
        return
    for note in reading.notes:
        to_stderr(f"note: {note}")
    about: dict[str, list[str]] = {}
    for each in reading.curves if curves else ():
        for note in each.notes:
            about.setdefault(note, []).append(each.name)
    for note, names in about.items():
        which = names[0] if len(names) == 1 else counted(len(names), "curve")
        to_stderr(f"note: {which}: {note}")


def tell_skipped(reading: Reading, name: str, *, surfaces: bool = True) -> None:
    """Print on standard error the entities of a file that its reader skipped, with their places; `surfaces` says
    whether surfaces are skipped, too.
    """
    source = "standard input" if name == "-" else name
    if reading.surfaces and surfaces:
        leave_out()
        number = counted(len(reading.surfaces), "surface")
        to_stderr(f"skipped: {source}: {number}: --surfaces takes these instead")
    if reading.skipped:
        leave_out()
    places: dict[tuple[str, str], list[str]] = {}
    for skipped in reading.skipped:
        places.setdefault((skipped.what, skipped.why), []).append(skipped.where)
    for (what, why), found in places.items():
        to_stderr(f"skipped: {source}: {_placed(what, found)}: {why}")


#: The number of places that are named of entities that are skipped for one reason.
NAMED = 3


def _placed(what: str, places: list[str]) -> str:
    """The kind of skipped entities, with their places in the file."""
    first = ", ".join(filter(None, places[:NAMED])) + (", …" if len(places) > NAMED else "")
    if len(places) == 1:
        return first if first.startswith(what) else f"{what} ({first})" if first else what
    return f"{what} ({len(places)} times: {first})"


def tell_written(path: str) -> None:
    """Say on standard error which file was written."""
    if path and not is_quiet():
        to_stderr(f"written: {path}")


def also_in_their_planes(curves: list[Nurbs]) -> list[Nurbs]:
    """The curves, each space curve in a coordinate plane followed by itself as a plane curve."""
    if all(c.dimension != 3 for c in curves):
        return list(curves)
    from exactspline.geometry.curves.planarity import with_plane_curves

    return with_plane_curves(curves)


def check_output(output: str, *inputs: str) -> None:
    """Raise `CurveFileError` when an output is one of the files that are read."""
    for name in inputs:
        if output and name and Path(output).exists() and Path(name).exists() and Path(output).samefile(name):
            raise CurveFileError("is the curve that is read", where=output, remedy="write to another file")


def check_distance(epsilon: str) -> None:
    """See that an option --epsilon, if it is given, is a distance."""
    from exactspline.splines.precision import WRITTEN

    if epsilon not in ("", WRITTEN):
        _see_that_it_is_positive("--epsilon", epsilon, f", or {WRITTEN}")


def with_distance(asked: Sequence[str], epsilon: str, usual: Sequence[str], *, of_pair: bool = False) -> list[str]:
    """Questions, with the distance of an option --epsilon for those that need one and have none; where none does, the
    usual ones of these, too.
    """
    if not epsilon:
        return list(asked)
    from exactspline.geometry.analysis.ask import REGISTRY
    from exactspline.questions.entry import Of

    check_distance(epsilon)
    nearby = {name: of for of, entries in REGISTRY.items() for name, entry in entries.items() if entry.about.nearby}
    if not any(each.partition(":")[0] in nearby for each in asked):
        asked = [*asked, *usual]

    def complete(each: str) -> str:
        name, _, argument = each.partition(":")
        parts = argument.split(",") if argument else []
        lacks = name in nearby and len(parts) == (nearby[name] is Of.TWO_CURVES and not of_pair)
        return f"{name}:{','.join([*parts, epsilon])}" if lacks else each

    return list(map(complete, asked))


def check_approximate(within: str) -> None:
    """See that an option --approximate, if it is given, is a distance."""
    if within:
        _see_that_it_is_positive("--approximate", within)


def _see_that_it_is_positive(option: str, given: str, otherwise: str = "") -> None:
    try:
        number = rational(given)
    except NumberError as error:
        raise error.at(option) from None
    if number <= 0:
        raise OptionsError(f"{option} {given}", remedy=f"give a number above 0, such as 1e-9{otherwise}")


#: The module that writes theorems for Coq about curves; it is imported only if theorems are requested.
THEOREMS = "exactspline.extras.coq.command"


def see_that_coq_can_name(path: str) -> None:
    """See that a file has a name that Coq accepts as that of a module."""
    named(f"{THEOREMS}:see_that_coq_can_name")(path)


def write_theorems(path: str, *curves: Nurbs) -> None:
    """The theorems about a curve, or about the common points of two, in a file."""
    named(f"{THEOREMS}:write_theorems")(path, *curves)
    tell_written(path)


def surfaces_among(readings: Sequence[tuple[str, Reading]], *, requested: bool) -> list[tuple[str, Reading]]:
    """The readings of files that hold surfaces and no curves; if surfaces are requested, also of files with both."""
    return [(name, each) for name, each in readings if each.surfaces and (requested or not each.curves)]


def read_surfaces(name: str) -> Sequence[NurbsSurface]:
    """The surfaces that a name means: an example, or the surfaces of a file in any format or of standard input.
    Whatever else the file holds is named on standard error.
    """
    reading = reading_of(name)
    if not reading.surfaces:
        tell_skipped(reading, name)
        raise CurveFileError("holds no surface", where=name, remedy="name a file of surfaces")
    return surfaces_in(name, reading, "not a surface")


def read_surface(name: str) -> NurbsSurface:
    """The one surface that a name, a file or standard input means."""
    return only_one(read_surfaces(name), "surface", name, "--surfaces ")


def surfaces_in(name: str, reading: Reading, why: str = "without --surfaces these are taken") -> Sequence[NurbsSurface]:
    """The surfaces of a file; whatever else the file holds is named on standard error."""
    if reading.curves:
        leave_out()
        to_stderr(f"skipped: {name}: {counted(len(reading.curves), 'curve')}: {why}")
    tell_skipped(reading, name, surfaces=False)
    tell_notes(reading, curves=False)
    return reading.surfaces


def inspect_surfaces(
    out: Output,
    surfaces: Sequence[NurbsSurface],
    digits: int,
    plot: str,
    epsilon: str,
    *,
    good: bool,
    with_all: bool = False,
) -> None:
    """Print the features of surfaces; a surface that fails is reported, and the others are inspected. `good` is whether
    all could be read.
    """
    if plot and len(surfaces) > 1:
        raise OptionsError("--plot and several surfaces", remedy="draw them one by one")
    inspected, all_good = each_read(surfaces, lambda surface: _inspected(surface, digits, plot, epsilon, with_all))
    good = good and all_good
    out.give(
        "inspect surface",
        [{"key": str(data["surface"])} | data for data, _ in inspected],
        [sheets[0] for _, sheets in inspected],
        lambda: out.show([sheet for _, sheets in inspected for sheet in sheets]),
        by="surface",
    )
    if not good:
        raise Exit(2)


def _inspected(
    surface: NurbsSurface, digits: int, plot: str, epsilon: str, with_all: bool
) -> tuple[dict[str, object], list[Sheet]]:
    """The features of a surface as data and as tables, and the picture where one is requested."""
    from exactspline.display.answer_forms import FORMS, FORMS_BESIDE, surface_inspection_data
    from exactspline.display.forms import list_of
    from exactspline.display.surface_data import map_sheet, nearby_umbilics_sheet, surface_sheet
    from exactspline.geometry.analysis.planar_maps import MapInspection
    from exactspline.geometry.analysis.surfaces import SurfaceInspection
    from exactspline.geometry.recognition.patches import RecognizedPart

    if surface.dimension == 2:
        if plot:
            raise OptionsError("--plot and a map of the plane", remedy="omit --plot: only surfaces in space are drawn")
        sign = MapInspection(surface)
        return surface_inspection_data(sign, digits), [map_sheet(sign)]
    found = SurfaceInspection(surface)
    if plot:
        _drawn(found, plot)
    data = surface_inspection_data(found, digits)
    if not epsilon:
        return data, [surface_sheet(found, digits, with_all=with_all)]
    shapes, umbilics = found.shapes_within(epsilon), found.umbilics_within(epsilon)
    data |= {"shapes": list_of(FORMS[RecognizedPart]).write(shapes, digits), "epsilon": epsilon}
    data["umbilics_within"] = FORMS_BESIDE["inspect surface"]["umbilics_within"].write(umbilics, digits)
    sheets = [surface_sheet(found, digits, shapes, with_all=with_all)]
    if umbilics:
        sheets.append(nearby_umbilics_sheet(umbilics, f"All surfaces within {epsilon} of {surface.name}"))
    return data, sheets


def _drawn(found: SurfaceInspection, plot: str) -> None:
    """Write a picture, or an interactive page, of an inspected surface."""
    from exactspline.atomic_write import write_text
    from exactspline.display.plot.anything import picture
    from exactspline.display.plot.canvas import PlotError, save

    if plot.lower().endswith(".html"):
        write_text(plot, picture("page of an inspected surface", found), PlotError)
    else:
        save(picture("inspected surface", found), plot)
    tell_written(plot)
