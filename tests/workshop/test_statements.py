"""Printed statements, changed on purpose: the record is that of the draw, and a part of it is judged again."""

import sys
from collections import defaultdict
from random import Random

import pytest

from workshop.mutation.forked import forked
from workshop.mutation.statements import BEGIN, END, PAGE, VERDICTS, changes_of, drawn, entries, judge, recorded, table

RECORD = recorded()
OF_3_11 = pytest.mark.skipif(
    sys.version_info >= (3, 12), reason="recorded where comprehensions have functions, and names, of their own"
)


@OF_3_11
def test_the_record_is_that_of_the_draw():
    assert [change.name for change in drawn()] == list(RECORD)
    assert len(drawn()) >= 1000
    assert {line["verdict"] for line in RECORD.values()} <= set(VERDICTS) - {"open", "timeout", "broken"}


def test_every_statement_is_changed_in_as_many_kinds_as_there_are():
    kinds = defaultdict(set)
    for change in drawn():
        kinds[change.claim].add(change.kind)
    assert kinds.keys() == entries().keys()
    for key, own in kinds.items():
        assert len(own) == min(3, len({change.kind for change in changes_of(key)})), key


def test_numbers_types_and_degrees_never_keep_their_verdict():
    for line in RECORD.values():
        if line["kind"] in ("number", "type", "degree"):
            assert line["verdict"] in ("killed", "false before", "refused"), line["change"]


def test_the_page_has_the_table_of_the_record():
    page = PAGE.read_text(encoding="utf-8")
    assert page.split(BEGIN)[1].split(END)[0] == table(RECORD)


@OF_3_11
@pytest.mark.parametrize("verdict", ["killed", "killed by another", "equivalent", "true too", "false before"])
def test_a_part_of_the_record_is_judged_again(verdict):
    of_verdict = [change for change in drawn() if RECORD[change.name]["verdict"] == verdict]
    sample = Random(verdict).sample(of_verdict, 4)
    for change, result in forked(sample, judge, 60, 1):
        assert result["verdict"] == verdict, change.name
