"""``inspect --ask``: exact answers about curves, for those who compute in doubles."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any, NamedTuple

from exactspline.cli.common import Read, distinguish
from exactspline.cli.output import OptionsError, Output
from exactspline.cli.parameters import Exit
from exactspline.display.sheet import Sheet

if TYPE_CHECKING:
    from exactspline.batch.oracle_answers import Answer
    from exactspline.geometry.analysis.pairs import CurvePair
    from exactspline.questions.answers import NamedNumbers
    from exactspline.questions.entry import Of
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface

#: The most digits of the certified intervals of an answer.
DIGITS = 1000


class _Answered(NamedTuple):
    """A question of a curve, or of two: of which, as data; the question; its answer, or why there is none."""

    of: Mapping[str, object]
    question: str
    answer: Answer | None
    error: str = ""

    def data(self, digits: int, certificates: bool) -> dict[str, Any]:
        """The answer as a row of JSON."""
        from exactspline.batch.oracle_answers import answer_data

        row: dict[str, Any] = {"key": f"{self.of['curve']}: {self.question}", **self.of, "error": self.error}
        if self.answer is None:
            return row | {"question": self.question, "items": [], "certificates": []}
        return row | answer_data(self.answer, digits) | ({} if certificates else {"certificates": []})


def refuse_with_ask(options: Mapping[str, object]) -> None:
    """See that no option is given that has no effect beside a question."""
    if refused := next((option for option, value in options.items() if value), ""):
        raise OptionsError(f"{refused} and --ask", remedy=f"give {refused} in a command without --ask")


def answer_questions(
    out: Output, found: tuple[list[Read], bool], asked: list[str], digits: int, certificates: bool
) -> None:
    """Print the answers to questions about curves, which were read, and whether all could be: the exact value, a
    certified interval, the correctly rounded double.
    """
    from exactspline.questions.entry import ALL_CURVES

    _check(asked, digits, *ALL_CURVES)
    given, good = found
    answered = [_answered(x.curve, {"curve": x.curve.name} | x.data(), each) for x, each in product(given, asked)]
    _give(out, answered, digits, certificates, good=good)


def answer_about_pair(out: Output, pair: CurvePair, asked: list[str], digits: int) -> None:
    """Print the answers to questions about two curves, in the same form."""
    from exactspline.questions.entry import Of

    _check(asked, digits, Of.TWO_CURVES)
    of = {"curve": " and ".join(curve.name for curve in pair.curves)}
    _give(out, [_answered(pair, of, question) for question in asked], digits, certificates=False, good=True)


def _give(out: Output, answered: list[_Answered], digits: int, certificates: bool, *, good: bool) -> None:
    rows = [each.data(digits, certificates) for each in answered] if out.format == "json" else []
    distinguish(rows)
    out.give("oracle", rows, (_sheet(each, digits) for each in answered), by="answer")
    if not good or any(each.error for each in answered):
        raise Exit(2)


def _answered(about: Nurbs | CurvePair, of: Mapping[str, object], question: str) -> _Answered:
    from exactspline.batch.oracle import oracle
    from exactspline.errors import ExactSplineError

    try:
        return _Answered(of, question, oracle(about, question))
    except ExactSplineError as error:
        return _Answered(of, question, None, str(error))


def _sheet(answered: _Answered, digits: int) -> Sheet:
    """An answer, one number per row: exactly where that is short, and as the nearest double."""
    from exactspline.display.reals import double_of, real_text

    title = f"{answered.of['curve']}: {answered.question}"
    made = Sheet("what", "name", "value", "double", title=title, name=title, prose=["value"])
    for item in answered.answer.items if answered.answer else ():
        ends = _ends(item)
        for name, number in item.values.items():
            double = double_of(number)
            shown = "–" if double is None else repr(double)
            made.add_row(item.what, name, ends.get(name) or real_text(number, digits), "" if name in ends else shown)
        for name, fact in item.facts.items():
            made.add_row(item.what, name.replace("_", " "), _shown(fact), "")
    if answered.error:
        made.add_row("no answer", "", answered.error, "")
    elif not made.rows:
        made.add_row("nothing", "", "there is none", "")
    return made


def _ends(item: NamedNumbers) -> dict[str, str]:
    """The ends of intervals that contain what curves near a curve have, rounded outwards; `--json` has them exactly."""
    from exactspline.display.features import ends_text
    from exactspline.numbers.intervals import Interval

    if "certain" not in item.facts:
        return {}
    pairs = [pair for pair in (("start", "end"), ("second 1", "second 2")) if pair[0] in item.values]
    own = [(pair, ends_text(Interval(*(item.values[name].around(0).low for name in pair)))) for pair in pairs]
    return {name: end for pair, ends in own for name, end in zip(pair, ends, strict=True)}


def _check(asked: Iterable[str], digits: int, *of: Of) -> None:
    """See that these are questions about such objects, and that there are not too many digits."""
    from exactspline.geometry.analysis.ask import check_question

    for question in asked:
        check_question(question, *of)
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
    from exactspline.questions.entry import Of

    _check(asked, digits, Of.SURFACE, Of.PLANAR_MAP)
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
    from exactspline.numbers.exact import rational
    from exactspline.numbers.intervals import Interval, certain

    match value:
        case {"low": low, "high": high, "exact": exact}:
            return exact or certain(Interval(rational(low), rational(high)), digits)
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


def _shown(fact: object) -> str:
    if isinstance(fact, bool):
        return "yes" if fact else "no"
    return " ".join(map(str, fact)) if isinstance(fact, list) else "–" if fact is None else str(fact)
