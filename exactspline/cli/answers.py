"""``--ask``: exact answers about curves, surfaces and pairs of curves, for those who compute in doubles."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from exactspline.cli.common import Read, distinguish
from exactspline.cli.output import OptionsError, Output
from exactspline.cli.parameters import Exit
from exactspline.errors import counted

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet
    from exactspline.geometry.analysis.ask import About
    from exactspline.geometry.analysis.pairs import CurvePair
    from exactspline.geometry.analysis.surface_pairs import SurfacePair
    from exactspline.questions.entry import Of
    from exactspline.splines.surface import NurbsSurface

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
    from exactspline.display.records import answer_data, answer_sheet, records
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
