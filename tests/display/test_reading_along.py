"""Sections of the paper passage by passage: every claim is read once, where it is first made; heads count them."""

import re
from collections import Counter

import pytest

from exactspline import claims, paper
from exactspline.errors import ClaimError
from exactspline.papers.passages import passages, reading_of, sections_of
from exactspline.tables import reading_along

SOURCE = paper("chen_riesenfeld_cohen_2007")
SECTIONS = list(sections_of(SOURCE))


def test_sections_are_those_of_the_headings():
    own = passages(SOURCE)
    assert [number for number in dict.fromkeys(one.section for one in own) if number] == SECTIONS
    headings = {one.section: one.begins for one in own if one.read.get("nothing") == "heading" and one.section}
    assert all(
        headings[number].split(". ")[0].startswith(number) for number in SECTIONS if number not in ("4.1", "6.2")
    )
    assert {one.page for one in own if not one.section} == {24, 25}
    assert all(one.section == "" or not one.begins.startswith("References") for one in own)


def test_every_claim_of_the_text_is_read_in_one_section():
    named = {key for one in passages(SOURCE) for key in one.claims}
    first = {}
    for one in passages(SOURCE):
        for key in one.claims:
            first.setdefault(key, one.section)
    counted = Counter(first.values())
    assert set(counted) == set(SECTIONS)
    assert sum(counted.values()) == len(named)
    printed = [claim for claim in claims(paper=SOURCE) if claim.status == "printed"]
    assert {claim.key for claim in printed} <= named


@pytest.mark.parametrize("number", ["4.3", "5.2", "7"])
def test_a_section_shows_each_of_its_claims_once_with_its_verdict(number):
    read = reading_along(f"§{number}")
    text = read._repr_html_()
    assert read.as_recorded
    assert sorted(re.findall(r'class="passage" id="([^"]+)"', text)) == sorted(read.decided)
    for key, each in read.decided.items():
        row = text.split(f'id="{key}"')[1].split('class="passage')[0]
        assert f"<b>{each.finding.verdict}</b>" in row
        assert each.claim.id in row
    printed = read.counts["printed"]
    assert (
        printed.statements
        == printed.hold + printed.refuted
        == sum(each.claim.status == "printed" for each in read.decided.values())
    )
    assert read.head.startswith(f"{printed.statements} of {printed.statements} printed statement")
    assert read.head in text


def test_what_a_passage_is_besides_claims_is_shown():
    text = reading_along("4.3")._repr_html_()
    assert "citation" in text
    assert "Refs. 30, 31" in text
    assert "definition" in text
    assert "slip" in reading_along("5.3")._repr_html_()
    assert "Passages that decide nothing: " in text


def test_a_section_that_is_not_there():
    with pytest.raises(ClaimError, match="has no section '8'"):
        reading_along("8")
    with pytest.raises(ClaimError, match="has no section"):
        reading_along("1", paper("lifted"))


def test_a_paper_without_a_reading_has_no_passages():
    assert reading_of(paper("lifted")) == {}
    assert passages(paper("lifted")) == ()
