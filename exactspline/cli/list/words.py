"""``list words``: what the words and signs of the tables mean."""

from __future__ import annotations

from typing import Annotated

from exactspline.cli.output import Output, printing
from exactspline.cli.parameters import Argument


@printing
def words(
    out: Output, term: Annotated[list[str] | None, Argument(help="Words or signs; without any, all of them.")] = None
) -> None:
    """Explain the words and signs of the tables: nominal, true, minimal, k, m, j, X, P, every verdict."""
    from exactspline.display.glossary import glossary as topics
    from exactspline.display.glossary import meaning
    from exactspline.display.sheet import Sheet

    chosen = (
        [("", each, meaning(each)) for each in term]
        if term
        else [(topic, each, told) for topic, all_terms in topics().items() for each, told in all_terms.items()]
    )

    def sheet() -> list[Sheet]:
        made = Sheet("term", "meaning", prose=["meaning"])
        for _, each, told in chosen:
            made.add_row(each, told)
        return [made]

    out.give(
        "glossary", lambda: [{"key": each, "meaning": told} for _, each, told in chosen], sheet, lambda: _print(chosen)
    )


def _print(chosen: list[tuple[str, str, str]]) -> None:
    from exactspline.display import console

    out, last = console.console(), ""
    for topic, term, meaning in chosen:
        if topic != last:
            out.print(("" if not last else "\n") + topic, style="bold")
            last = topic
        console.lines(out, f"{term}: {meaning}", indent=4 if topic else 2, first=2 if topic else 0)
