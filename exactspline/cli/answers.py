"""``inspect --ask``: exact answers about curves, for those who compute in doubles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from exactspline.cli.common import Read, distinguish
from exactspline.cli.output import OptionsError, Output
from exactspline.cli.parameters import Exit
from exactspline.display.sheet import Sheet

if TYPE_CHECKING:
    from exactspline.geometry.analysis.pairs import CurvePair
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface

#: The most digits of the certified intervals of an answer.
DIGITS = 1000


def answer_questions(
    out: Output, found: tuple[list[Read], bool], asked: list[str], digits: int, certificates: bool
) -> None:
    """Print the answers to questions about curves, which were read, and whether all could be: the exact value, a
    certified interval, the correctly rounded double.
    """
    from exactspline.geometry.analysis.ask import check_question
    from exactspline.questions.entry import ALL_CURVES

    _check_digits(digits)
    for question in asked:
        check_question(question, *ALL_CURVES)
    given, good = found
    rows = [
        _answered(read.curve, {"curve": read.curve.name} | read.data(), question, digits, certificates)
        for read in given
        for question in asked
    ]
    distinguish(rows)
    _give(out, rows, digits, good=good)


def answer_about_pair(out: Output, pair: CurvePair, names: str, asked: list[str], digits: int) -> None:
    """Print the answers to questions about two curves, in the same form."""
    from exactspline.geometry.analysis.ask import check_question
    from exactspline.questions.entry import Of

    _check_digits(digits)
    for question in asked:
        check_question(question, Of.TWO_CURVES)
    _give(out, [_answered(pair, {"curve": names}, question, digits, False) for question in asked], digits, good=True)


def _give(out: Output, rows: list[dict[str, Any]], digits: int, *, good: bool) -> None:
    out.give("oracle", rows, (_sheet(row, digits) for row in rows), by="answer")
    if not good or any(row["error"] for row in rows):
        raise Exit(2)


def _check_digits(digits: int) -> None:
    if digits > DIGITS:
        raise OptionsError(f"--digits {digits}", remedy=f"answers have at most {DIGITS}")


def answer_about_surfaces(
    out: Output, surfaces: Sequence[NurbsSurface], asked: list[str], digits: int, *, good: bool
) -> None:
    """Print the answers to questions about surfaces, as data: the values at places, and questions of the registry.
    `good` is whether all could be read.
    """
    from exactspline.batch.surface_oracle import surface_answer
    from exactspline.errors import ExactSplineError
    from exactspline.geometry.analysis.ask import check_question
    from exactspline.questions.entry import Of

    _check_digits(digits)
    for each in asked:
        check_question(each, Of.SURFACE, Of.PLANAR_MAP)
    rows: list[dict[str, Any]] = []
    for surface in surfaces:
        for each in asked:
            row = {"key": f"{surface.name}: {each}", "surface": surface.name, "question": each}
            try:
                rows.append(row | {"answer": surface_answer(surface, each, digits), "error": ""})
            except ExactSplineError as error:
                rows.append(row | {"answer": None, "error": str(error)})
    out.give("oracle surface", rows, (_surface_sheet(row, digits) for row in rows), by="answer")
    if not good or any(row["error"] for row in rows):
        raise Exit(2)


def _surface_sheet(row: dict[str, Any], digits: int) -> Sheet:
    """An answer about a surface: one row per number, or per element."""
    made = Sheet("what", "value", "double", title=row["key"], name=row["key"], prose=["value"])
    answer = row["answer"]
    if row["error"]:
        made.add_row("no answer", row["error"], "")
    elif isinstance(answer, dict) and "values" in answer:
        for name, number in answer["values"].items():
            exact = number["exact"] or f"{number['low']} … {number['high']}"
            made.add_row(name, exact, "–" if number["double"] is None else repr(number["double"]))
    elif isinstance(answer, (list, dict)):
        one = row["question"].partition(":")[0].removesuffix("s").replace("_", " ")
        for group, elements in answer.items() if isinstance(answer, dict) else [(one, answer)]:
            for each in elements:
                made.add_row(*_element(each, group, digits), "")
        if not made.rows:
            made.add_row("nothing", "there is none", "")
    else:
        made.add_row(row["question"], _shown(answer), "")
    return made


def _element(each: object, group: str, digits: int) -> tuple[str, str]:
    """What an element of an answer is, and the rest of its data in words."""
    if not isinstance(each, dict):
        return group, _shown(each)
    kind = next((key for key in ("kind", "shape") if key in each), "")
    rest = {key: value for key, value in each.items() if key != kind and value not in (None, [])}
    return each.get(kind, group), "; ".join(f"{key.replace('_', ' ')} {_in_words(rest[key], digits)}" for key in rest)


def _in_words(value: Any, digits: int) -> str:
    """A part of the data of an element."""
    match value:
        case {"low": _, "high": _, "exact": exact}:
            return exact or _between(value, digits)
        case dict():
            return ", ".join(f"{key.replace('_', ' ')} {_in_words(each, digits)}" for key, each in value.items())
        case [{"exact": _}, *_]:
            return _in_words([_in_words(each, digits) for each in value], digits)
        case [str(low), str(high)]:
            return f"[{low}, {high}]"
        case [list(), *_]:
            return " ".join(f"({', '.join(map(str, each))})" for each in value)
        case list() if len(value) > 1:
            return f"({', '.join(map(str, value))})"
        case _:
            return _shown(value)


def _answered(
    about: Nurbs | CurvePair, head: Mapping[str, object], asked: str, digits: int, certificates: bool
) -> dict[str, Any]:
    """A row of answers; `head` says of which curve, or curves, it is."""
    from exactspline.batch.oracle import oracle as ask_oracle
    from exactspline.batch.oracle_answers import answer_data
    from exactspline.errors import ExactSplineError

    row: dict[str, Any] = {"key": f"{head['curve']}: {asked}", **head}
    try:
        data = answer_data(ask_oracle(about, asked), digits)
    except ExactSplineError as error:
        return row | {"question": asked, "items": [], "certificates": [], "error": str(error)}
    return row | data | {"certificates": data["certificates"] if certificates else [], "error": ""}


def _sheet(row: dict[str, Any], digits: int) -> Sheet:
    """An answer, one number per row."""
    made = Sheet("what", "name", "value", "double", title=row["key"], name=row["key"], prose=["value"])
    for item in row["items"]:
        ends = _ends(item)
        for name, number in item["values"].items():
            exact = number["exact"] if number["exact"] is not None else _between(number, digits)
            double = "–" if number["double"] is None else repr(number["double"])
            made.add_row(item["what"], name, ends.get(name, exact), "" if name in ends else double)
        for name, fact in item["facts"].items():
            made.add_row(item["what"], name.replace("_", " "), _shown(fact), "")
    if row["error"]:
        made.add_row("no answer", "", row["error"], "")
    elif not row["items"]:
        made.add_row("nothing", "", "there is none", "")
    return made


def _ends(item: dict[str, Any]) -> dict[str, str]:
    """The ends of intervals that contain what curves near a curve have, rounded outwards; `--json` has them exactly."""
    from exactspline.display.features import ends_text
    from exactspline.numbers.exact import rational
    from exactspline.numbers.intervals import Interval

    if "certain" not in item["facts"]:
        return {}
    pairs = [pair for pair in (("start", "end"), ("second 1", "second 2")) if pair[0] in item["values"]]
    exact = [(pair, [item["values"][name]["exact"] for name in pair]) for pair in pairs]
    own_ends = [(pair, ends_text(Interval(*map(rational, own)))) for pair, own in exact]
    return {name: end for pair, ends in own_ends for name, end in zip(pair, ends, strict=True)}


def _between(number: dict[str, Any], digits: int) -> str:
    """An irrational number: the decimals that its certified interval makes certain, and dots."""
    from exactspline.numbers.exact import rational
    from exactspline.numbers.intervals import Interval, certain

    return certain(Interval(rational(number["low"]), rational(number["high"])), digits)


def _shown(fact: object) -> str:
    if isinstance(fact, bool):
        return "yes" if fact else "no"
    return " ".join(map(str, fact)) if isinstance(fact, list) else "–" if fact is None else str(fact)
