"""``python -m docs.counts`` writes into ``docs/concepts.md`` what a statement, a claim, a row and an error are, and how
many of them each source has. The numbers are those of the verdicts on record; tests hold the record to what is decided.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from textwrap import fill

from exactspline.display.console import glossary
from exactspline.papers import papers
from exactspline.verification.claims import claims_of
from exactspline.verification.ledger import recorded_counts
from exactspline.verification.vocabulary import Status

PAGE = Path(__file__).parent / "concepts.md"
BEGIN, END = "<!-- written by python -m docs.counts -->\n", "<!-- end of counts -->\n"
HEADS = ("source", "statements in print", "hold", "refuted", "errors", "corrected", "our own")


def definitions() -> Iterator[str]:
    """What is counted, in the words of the glossary."""
    for term, meaning in glossary()["counts"].items():
        yield fill(f"- A{'n' if term[0] in 'aeiou' else ''} **{term}** is {meaning}.", 120, subsequent_indent="  ")


def table() -> Iterator[str]:
    """The sources with their counts."""
    yield f"| {' | '.join(HEADS)} |"
    yield "|---|" + "---:|" * (len(HEADS) - 1)
    for source in papers():
        found = recorded_counts(claims_of(source))
        printed = found[Status.PRINTED]
        cells = (source.title, printed.statements, printed.hold, printed.refuted, printed.errors)
        yield f"| {' | '.join(map(str, (*cells, found[Status.MEANT].statements, found[Status.OURS].statements)))} |"


def written() -> str:
    """The part of the page between its two marks."""
    return "\n".join((*definitions(), "", *table())) + "\n"


def main() -> None:
    """Write it into the page."""
    text = PAGE.read_text(encoding="utf-8")
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    PAGE.write_text(f"{head}{BEGIN}\n{written()}\n{END}{tail}", encoding="utf-8")


if __name__ == "__main__":
    main()
