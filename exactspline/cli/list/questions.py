"""``list questions``: what `inspect --ask` answers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.cli.output import Output, printing

if TYPE_CHECKING:
    from exactspline.display.sheet import Sheet


@printing
def questions(out: Output) -> None:
    """List the questions that inspect --ask answers."""
    from exactspline.batch.oracle_questions import QUESTIONS
    from exactspline.display.sheet import Sheet

    rows = [{"key": name, "asked": kind.asked, "meaning": kind.meaning} for name, kind in QUESTIONS.items()]

    def sheets() -> list[Sheet]:
        made = Sheet("question", "meaning", prose=["meaning"])
        for kind in QUESTIONS.values():
            made.add_row(kind.asked, kind.meaning)
        return [made]

    out.give("questions", lambda: rows, sheets)
