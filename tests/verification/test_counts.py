"""What is counted: one definition, and the same numbers wherever they stand."""

import json
import re
from pathlib import Path

import pytest

from docs.counts import PAGE, written
from docs.ten_claims import CLAIMS
from exactspline import Verdict, claims, decide, paper
from exactspline.display.ledger import closing, headline, summary
from exactspline.papers import default_papers, papers
from exactspline.tables import errata
from exactspline.verification.claims import claims_in
from exactspline.verification.ledger import Counts, count_statements, recorded_counts
from exactspline.verification.statement import remarks
from tests.support.command import new_paper
from tests.support.decided import decided_once, errors_in_print, proofs

ROOT = Path(__file__).parents[2]
PAPER = "chen_riesenfeld_cohen_2007"
WORDS = {"two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10}
COUNTED = re.compile(rf"\b(\d[\d,]*|{'|'.join(WORDS)})\s+(?:[a-z]+ )?(statements|claims|errors)\b", re.IGNORECASE)


def test_statements_of_a_status_are_counted_by_verdict_and_errors_by_name():
    first, second, third = claims()[:3]
    assert {claim.status for claim in (first, second, third)} == {"printed"}
    found = count_statements([(first, Verdict.REFUTED), (second, Verdict.PROVED), (third, Verdict.UNDECIDED)])
    assert found["printed"] == Counts(3, 1, 1, 1)
    assert Counts(10, 6, 3, 1).neither == 1
    assert found["printed"].neither == 1
    assert found["meant"] == found["ours"] == Counts(0, 0, 0, 0)


def test_two_refuted_statements_of_one_error_are_one_error_and_unrecorded_ones_are_one_each():
    joined = [claim for claim in claims() if claim.error == "ruling-parameter"]
    assert count_statements((claim, Verdict.REFUTED) for claim in joined)["printed"].errors == 1
    alone = [claim for claim in claims() if not claim.error and claim.status == "printed"][:3]
    assert count_statements((claim, Verdict.REFUTED) for claim in alone)["printed"].errors == 3


def test_the_ledger_the_errata_and_the_record_count_alike():
    rows = [decide(claim, proofs()) for claim in claims()]
    decided = count_statements((row.claim, row.verdict) for row in rows)
    assert decided == recorded_counts(claims())
    printed = decided["printed"]
    assert printed.errors == len(errors_in_print())
    assert printed.refuted == sum(len(error.statements) for error in errors_in_print())
    head = f"{printed.refuted} statements of the paper refuted ({printed.errors} errors"
    assert headline(rows).startswith(head)
    assert f"; {printed.hold} hold; " in headline(rows)
    assert summary(decided).startswith(f"{printed.statements} statements of the paper: {printed.hold} hold, ")
    assert closing(rows).startswith(f"{sum(each.statements for each in decided.values())} rows of ")


@pytest.mark.parametrize("source", [source.name for source in papers() if source not in default_papers()])
def test_the_errors_of_each_source_are_counted_in_its_errata(source):
    with decided_once():
        found = list(errata([paper(source)]))
    printed = recorded_counts(claims(paper=source))["printed"]
    assert len(found) == printed.errors
    assert sum(len(error.statements) for error in found) == printed.refuted


OWN = """
[[claim]]
id = "{id}"
kind = "invariance"
{place}statement = "under similarities ‖γ′‖² is multiplied by the scale"
formula = "speed_squared"
under = "similarity"
weight = 1
"""


def test_what_fails_unrecorded_is_an_error_each_and_a_remark_where_no_source_says_it(tmp_path):
    """Before, several such statements were one error in `prove`, and those beyond the paper were errors of it."""
    folder = new_paper(tmp_path / "mine")
    with (folder / "claims.toml").open("a", encoding="utf-8") as file:
        for number, place in enumerate(('place = "eq. (7)"\n', 'place = "eq. (8)"\n', "")):
            file.write(OWN.format(id=f"8{number}", place=place))
    source = paper(folder)
    rows = [decide(claim) for claim in claims(paper=source)]
    assert (
        headline(rows)
        == "2 statements of the paper refuted (2 errors, 2 rows); 4 hold; none is undecided for all curves; "
        "1 conjecture not in the paper fails"
    )
    assert [error.id for error in errata([source])] == ["80", "81"]
    assert [remark.id for remark in remarks([source])] == ["82"]


def test_the_page_has_the_definitions_and_the_numbers():
    assert written() in PAGE.read_text(encoding="utf-8")


def pages():
    """The pages that speak of what is counted: their names and texts."""
    for file in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        yield file.name, file.read_text(encoding="utf-8")
    for file in sorted((ROOT / "notebooks").glob("*.ipynb")):
        cells = json.loads(file.read_text(encoding="utf-8"))["cells"]
        yield file.name, "\n\n".join("".join(c["source"]) for c in cells if c["cell_type"] == "markdown")


def test_numbers_of_statements_in_the_pages_are_those_that_are_counted():
    """A page that counts statements, claims or errors otherwise is listed here with what it counts, or fails."""
    printed = recorded_counts(claims(paper=PAPER))["printed"]
    primer = recorded_counts(claims(paper="primer_on_bezier_curves"))["printed"]
    expected = {
        ("mutation.md", "statements"): printed.statements,
        ("ten-claims.md", "claims"): sum(map(len, CLAIMS.values())),
        ("what-is-trusted.md", "claims"): sum(map(len, CLAIMS.values())),
        ("15_primer_on_bezier_curves.ipynb", "statements"): primer.refuted,
    }
    found = {
        (name, match[2].lower()): WORDS.get(match[1].lower()) or int(match[1].replace(",", ""))
        for name, text in pages()
        for match in COUNTED.finditer(text)
    }
    assert found == expected


def test_the_page_of_sources_lists_every_error():
    """Those that are marked as remarks are said by no source."""
    part = (ROOT / "docs" / "sources.md").read_text(encoding="utf-8").split("## Their errors")[1].split("\n## ")[0]
    listed = re.findall(r"^    - (.*(?:\n      .*)*)", part, re.MULTILINE)
    others = [source for source in papers() if source not in default_papers()]
    errors = recorded_counts(claims_in(others))["printed"].errors
    assert len([each for each in listed if "(a remark" not in each]) == errors
