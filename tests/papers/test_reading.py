"""Every span of the paper is read, and every claim stands in the spans that are said to make it."""

import re

import pytest

from exactspline import claims
from reading.cutter import spans, squeezed
from reading.readings import READINGS, ROOT, TEXT, decided, needs_reason, readings, runs, spans_of_text, table
from reading.second import READ as READ_AGAIN
from reading.second import drawn, second_readings, undecided

CLAIMS = {claim.key: claim for claim in claims(paper="chen_riesenfeld_cohen_2007")}
READ = readings()
FURNITURE = set(table()["furniture"]["words"])
at_hand = pytest.mark.skipif(not TEXT.exists(), reason="the text of the paper is not part of the repository")
CUT = {"header": "HEAD", "begins": "Keywords", "table_page": 3, "table_row": r"(\S+) is (\w+)"}


# ---- the cutter


def test_sentences_displays_headings_footnotes_and_captions_are_cut():
    text = """front
HEAD
A running title 1
1. A heading
Let γγγ = ppp/w. By Eq. (5), it is of degree
3d − 1. Then
γ′γ′γ′ =ppp
w2(1)
= 0,
which ends.
Fig. 1. A picture
(a) one thing (b) Another thing
aThis is a footnote.
HEAD
A running title 2
"""
    found = [(span.page, span.order, span.text) for span in spans(text, CUT)]
    assert found[:3] == [(0, 1, "front"), (1, 1, "HEAD"), (1, 2, "A running title 1")]
    assert [words for page, order, words in found if page == 1 and order > 2] == [
        "1. A heading",
        "Let γγγ = ppp/w.",
        "By Eq. (5), it is of degree 3d − 1.",
        "Then",
        "γ′γ′γ′ =ppp w2(1)",
        "= 0,",
        "which ends.",
        "Fig. 1. A picture",
        "(a) one thing",
        "(b) Another thing",
        "aThis is a footnote.",
    ]


def test_a_digest_knows_letters_and_not_lines():
    one, other = (spans(f"HEAD\nrun\n{words}", CUT)[-1] for words in ("of a poly-\nnomial.", "of a polynomial."))
    assert one.digest == other.digest
    assert one.digest != spans("HEAD\nrun\nof two polynomials.", CUT)[-1].digest


def test_cells_and_entries_are_cut():
    pages = ["", "a", "b", "c\nTable\naaa is big bbb is small", "d\nReferences\n1. A. One, 1990.2. B. Two,\n1991."]
    text = "\nHEAD\n".join(pages)
    found = [span.text for span in spans(text, CUT) if span.page > 2]
    entries = ["HEAD", "d", "References", "1. A. One, 1990.", "2. B. Two, 1991."]
    assert found == ["HEAD", "c", "Table", "aaa", "big", "bbb", "small", *entries]


# ---- the table


def test_every_span_is_read_and_every_key_is_that_of_a_claim():
    assert len(READ) > 600
    for one in READ:
        assert set(one.read) <= {*READINGS, "reason", "slip"}, one.place
        assert any(name in one.read for name in READINGS), one.place
        assert all(key in CLAIMS for key in one.claims), one.place
        assert not ("nothing" in one.read and one.claims), one.place
        assert one.claims or "claims" not in one.read, one.place
        assert "nothing" in one.read or "reason" not in one.read, one.place


def test_what_is_printed_is_named_by_a_span():
    named = {key for one in READ for key in one.claims}
    left_out = [key for key, claim in CLAIMS.items() if claim.status != "ours" and key not in named]
    assert left_out == []


@at_hand
def test_no_span_of_the_text_is_without_a_reading():
    text = [(span.page, span.order, span.digest, span.begins) for span in spans_of_text()]
    assert text == [(one.page, one.order, one.digest, one.begins) for one in READ]


@at_hand
def test_every_quotation_stands_in_the_spans_that_make_the_claim():
    pairs = list(zip(READ, spans_of_text(), strict=True))
    wrong = []
    for key, claim in CLAIMS.items():
        if claim.words and claim.status != "ours":
            page = int(re.match(r"p\. (\d+)", claim.place)[1])
            words = squeezed(claim.words)
            here = [(one, span) for one, span in pairs if one.page == page]
            wrong += [key] if not any(words in letters for letters in runs(here, key)) else []
    assert wrong == []


@at_hand
def test_what_decides_nothing_says_why_where_it_has_numbers_formulas_or_words_of_statements():
    unexplained = [
        one.place
        for one, span in zip(READ, spans_of_text(), strict=True)
        if "nothing" in one.read
        and one.read["nothing"] not in FURNITURE
        and needs_reason(span.text)
        and not one.read.get("reason")
    ]
    assert unexplained == []


def test_the_rule_of_reasons_sees_each_of_its_words():
    for word in ("degree", "Rational", "zeros", "only", "cannot", "same"):
        assert needs_reason(f"it is {word}")
    assert needs_reason("κ vanishes")
    assert needs_reason("twice 2")
    assert not needs_reason("However, more is possible.")


# ---- the second reader


def test_the_second_reader_read_what_was_drawn():
    assert [(one.page, one.order, one.digest) for one in second_readings()] == [
        (one.page, one.order, one.digest) for one in drawn()
    ]
    assert 10 * len(drawn()) > len(READ)


def test_where_two_readers_differ_it_is_said_what_became_of_it():
    for one, recorded in zip(second_readings(), drawn(), strict=True):
        assert one.outcome in ("", "mended", "kept"), recorded.place
        assert bool(one.outcome) == bool(one.why), recorded.place
        assert one.read in recorded.read or one.outcome == "kept", recorded.place
        assert one.holds or one.read != "claims", recorded.place


def test_what_the_second_reader_found_false_is_refuted_by_a_claim_that_the_span_makes():
    false = [
        recorded
        for one, recorded in zip(second_readings(), drawn(), strict=True)
        if one.holds.startswith(("false", "the formula is true with λ"))
    ]
    assert len(false) == 5
    for recorded in false:
        same_place = {CLAIMS[key].id for key in recorded.claims}
        assert any("REFUTED" in CLAIMS[key].expected and CLAIMS[key].id in same_place for key in CLAIMS), recorded.place


# ---- what claims do not decide


def test_the_readme_quotes_how_many_spans_are_decided_wholly():
    claiming, wholly = decided(READ)
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    told = f"{wholly} of the {claiming} sentences, formulas and captions that claim something are decided wholly"
    assert told in readme
    assert wholly < claiming < len(READ)


def test_a_span_with_something_open_is_not_decided_wholly():
    whole = next(one for one in READ if one.claims and "open" not in one.read)
    part = next(one for one in READ if one.claims and "open" in one.read)
    no_claim = next(one for one in READ if not one.claims)
    assert decided([whole]) == (1, 1)
    assert decided([part]) == (1, 0)
    assert decided([no_claim]) == (0, 0)


def test_what_claims_did_not_decide_is_decided_now_or_said_to_be_open():
    by_place = {(one.page, one.order): one for one in READ}
    theirs = undecided()
    assert len(theirs) == len({(one.page, one.order) for one in theirs}) < READ_AGAIN
    for one in theirs:
        here = by_place[one.page, one.order]
        assert one.digest == here.digest, here.place
        assert one.decided in ("partly", "nothing"), here.place
        assert one.missing, here.place
        assert set(one.added) <= set(here.claims), here.place
        assert one.added or "open" in here.read or "slip" in here.read, here.place


def test_no_opinion_speaks_of_degrees():
    opinions = [one for one in READ if one.read.get("nothing") == "opinion"]
    assert [one.place.split(":")[0] for one in opinions] == ["p. 1, span 16", "p. 2, span 6", "p. 2, span 8"]
