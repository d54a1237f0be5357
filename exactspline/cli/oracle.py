"""``oracle``: exact answers about curves, for those who compute in doubles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from exactspline.cli.common import CURVE_HELP, Read, distinguish, read_curves
from exactspline.cli.output import OptionsError, Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def oracle(
    out: Output,
    curve: Annotated[list[str] | None, typer.Argument(metavar="CURVE", help=CURVE_HELP)] = None,
    ask: Annotated[
        list[str] | None,
        typer.Option(
            "--ask", metavar="QUESTION", help="value@1/2, derivative:2@0, inflections, …; may be repeated (see --list)."
        ),
    ] = None,
    digits: Annotated[
        int, typer.Option("--digits", metavar="N", min=1, max=1000, help="Digits of the certified intervals.")
    ] = 30,
    certificates: Annotated[
        bool, typer.Option("--certificates", help="Put the certificates of the zero sets into the JSON.")
    ] = False,
    questions: Annotated[bool, typer.Option("--list", help="List the questions.")] = False,
) -> None:
    """Answer questions about curves: the exact value, a certified interval, the correctly rounded double."""
    if questions:
        _list(out)
        return
    if not ask or not curve:
        raise OptionsError("nothing is asked", remedy="name a curve and --ask QUESTION, or see --list")
    given, good = read_curves(curve)
    rows = [_answered(read, asked, digits, certificates) for read in given for asked in ask]
    distinguish(rows)
    out.give("oracle", lambda: rows, lambda: [_sheet(row, digits) for row in rows], by="answer")
    if not good or any(row["error"] for row in rows):
        raise typer.Exit(2)


def _answered(read: Read, asked: str, digits: int, certificates: bool) -> dict[str, Any]:
    from exactspline.batch.oracle import oracle as ask_oracle
    from exactspline.batch.oracle import question_of
    from exactspline.batch.oracle_answers import answer_data
    from exactspline.errors import ExactSplineError

    c = read.curve
    row: dict[str, Any] = {"key": f"{c.name}: {asked}", "curve": c.name} | read.data()
    question_of(asked)
    try:
        data = answer_data(ask_oracle(c, asked), digits)
    except ExactSplineError as error:
        return row | {"question": asked, "items": [], "certificates": [], "error": str(error)}
    return row | data | {"certificates": data["certificates"] if certificates else [], "error": ""}


def _sheet(row: dict[str, Any], digits: int) -> Sheet:
    """An answer, one number per row."""
    from exactspline.display.sheet import Sheet

    made = Sheet("what", "name", "value", "double", title=row["key"], name=row["key"], prose=["value"])
    for item in row["items"]:
        for name, number in item["values"].items():
            exact = number["exact"] if number["exact"] is not None else _between(number, digits)
            made.add_row(item["what"], name, exact, "–" if number["double"] is None else repr(number["double"]))
        for name, fact in item["facts"].items():
            made.add_row(item["what"], name.replace("_", " "), _shown(fact), "")
    if row["error"]:
        made.add_row("no answer", "", row["error"], "")
    elif not row["items"]:
        made.add_row("nothing", "", "there is none", "")
    return made


def _between(number: dict[str, Any], digits: int) -> str:
    """An irrational number: the decimals that its certified interval makes certain, and dots."""
    from exactspline.numbers.exact import rational
    from exactspline.numbers.intervals import Interval, certain

    return certain(Interval(rational(number["low"]), rational(number["high"])), digits)


def _shown(fact: object) -> str:
    if isinstance(fact, bool):
        return "yes" if fact else "no"
    return " ".join(map(str, fact)) if isinstance(fact, list) else "–" if fact is None else str(fact)


def _list(out: Output) -> None:
    from exactspline.batch.oracle_questions import QUESTIONS
    from exactspline.display.sheet import Sheet

    rows = [{"key": name, "asked": kind.asked, "meaning": kind.meaning} for name, kind in QUESTIONS.items()]

    def sheets() -> list[Sheet]:
        made = Sheet("question", "meaning", prose=["meaning"])
        for kind in QUESTIONS.values():
            made.add_row(kind.asked, kind.meaning)
        return [made]

    out.give("questions", lambda: rows, sheets)
