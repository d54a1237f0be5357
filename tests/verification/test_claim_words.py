"""Claims are read as objects: a word that is spelled wrongly is an error that names file and entry."""

import copy
from dataclasses import fields

import pytest

from exactspline import paper
from exactspline.errors import ClaimError, nearest
from exactspline.papers import Table, papers
from exactspline.verification.claims import claim_of
from exactspline.verification.kinds import KINDS
from tests.support.sampled import sample

#: What people write as they like.
FREE = {"source", "statement", "words", "place", "section", "context", "note"}
ENTRIES = [(table, source) for source in papers() for table in source.claim_tables()]


def misspelled(table):
    """The entry with one word spelled wrongly, one after the other: names of fields, and every value that is not a free
    text.
    """
    for field, value in table.entry.items():
        renamed = {(f"{name}q" if name == field else name): v for name, v in table.entry.items()}
        yield field, Table(table.place, renamed)
        if field in FREE:
            continue
        values = value if isinstance(value, list) else [value]
        for i, each in enumerate(values):
            changed = copy.deepcopy(table.entry)
            if isinstance(each, int):
                wrong = f"{each}q"
            else:
                place = {"id": 1, "factor": len(each) - 1, "claimed": len(each) - 1}.get(field, len(each))
                wrong = each[:place] + "q" + each[place:]
            if field == "key":
                yield from misspelled_key(table, each)
                continue
            changed[field] = [*values[:i], wrong, *values[i + 1 :]] if isinstance(value, list) else wrong
            yield f"{field} = {each}", Table(table.place, changed)


def misspelled_key(table, key):
    """The entry with one word of its key spelled wrongly: a letter added, a letter left out."""
    parts = key.split("-")
    for i, part in enumerate(parts):
        for wrong in (part + "q", part[:-1] + "q"):
            changed = "-".join([*parts[:i], wrong, *parts[i + 1 :]])
            yield f"key = {changed}", Table(table.place, table.entry | {"key": changed})


def refusal(table, source):
    """What is said of an entry that is refused; empty when it is read."""
    try:
        claim_of(table, source)
    except ClaimError as error:
        return str(error)
    return ""


def test_every_misspelled_word_is_an_error_that_names_file_and_entry():
    tried, passed = 0, []
    for table, source in sample(ENTRIES, 150):
        for what, wrong in misspelled(table):
            tried += 1
            told = refusal(wrong, source)
            if not (told.startswith(table.place) and ";" in told):
                passed.append((table.place, what, told))
    assert tried > 800
    assert passed == []


def test_the_nearest_names_are_offered():
    table, source = next((t, s) for t, s in ENTRIES if t.entry.get("left") == "f1")
    with pytest.raises(ClaimError, match="nearest are f1"):
        claim_of(Table(table.place, table.entry | {"left": "f1q"}), source)
    with pytest.raises(ClaimError, match="nearest are factor"):
        claim_of(Table(table.place, table.entry | {"factr": "w"}), source)
    assert nearest("REFUTD", ["PROVED", "REFUTED"]).startswith("the nearest are REFUTED")


DEGREE = {
    "id": "X1",
    "key": "X1-f2",
    "kind": "degree",
    "status": "ours",
    "source": "a test",
    "statement": "a degree",
    "curve": "plane",
    "formula": "f2",
    "claimed": "3d − 3",
}
ZERO_SET = {key: DEGREE[key] for key in ("id", "key", "status", "source", "statement", "curve")} | {
    "kind": "zero set",
    "formulas": ["f0", "f2"],
}


@pytest.mark.parametrize(
    ("entry", "changes", "told"),
    [
        (DEGREE, {"parameter": "s̄"}, "no parameter s̄"),
        (DEGREE, {"counting": "part by part", "measure": "true"}, "only nominal degrees"),
        (DEGREE, {"formula": "D1_D2_D3"}, "of the kind 'space'"),
        (DEGREE, {"claimed": "3e − 3"}, "contains 'e'"),
        (DEGREE, {"measure": "height"}, "a height is a number"),
        (DEGREE, {"least_d": 0}, "not a number ≥ 1"),
        (DEGREE, {"assumes": ["γ′×γ″"]}, "does not apply to 'plane'"),
        (DEGREE, {"status": "printed"}, "neither words nor a place"),
        (DEGREE, {"status": "printed", "words": "a", "expected": "REFUTED"}, "belongs to an error"),
        (DEGREE, {"key": "X2-f2"}, "does not begin with the id"),
        (DEGREE, {"key": "X1-f22"}, "does not occur elsewhere in the entry.*f2"),
        (DEGREE, {"key": "X1-f2-lowest_terms"}, "does not occur elsewhere in the entry"),
        (DEGREE, {"statement": 7}, "7 is not a text"),
        (ZERO_SET, {"formulas": ["f2"]}, "compared with itself"),
        (ZERO_SET, {"formulas": ["f2", "f2"]}, "compared with itself"),
        (
            ZERO_SET,
            {"kind": "square class", "curve": "pair", "formulas": None}
            | {"formula": "bisector_determinant", "right": "bisector_determinant_symmetric"},
            "are not decided",
        ),
        (
            ZERO_SET,
            {"kind": "identity", "formulas": None, "left": "f0", "right": "f2", "factor": "1/0"},
            "divided by zero",
        ),
        (ZERO_SET, {"kind": "identity", "formulas": None, "left": "f0", "right": "f0"}, "both sides are one formula"),
    ],
)
def test_combinations_that_say_nothing_are_refused(entry, changes, told):
    source = paper("lifted")
    claim_of(Table("here", entry), source)
    changed = {key: value for key, value in (entry | changes).items() if value is not None}
    with pytest.raises(ClaimError, match=told) as caught:
        claim_of(Table("there, claim 1", changed), source)
    assert str(caught.value).startswith("there, claim 1")


def test_every_kind_occurs_and_no_field_is_idle():
    used = {(table.entry.get("kind"), field) for table, _ in ENTRIES for field in table.entry}
    # for papers of others: test_claims_of_authors.py, test_not_asked.py, test_claims_on_one_curve.py
    of_authors = {"contact", "invariance", "sign", "not asked", "at", "limit", "bound", "distance"}
    fields_of_authors = {("count", "interval"), ("coefficients", "sign")}
    assert {table.entry["kind"] for table, _ in ENTRIES} | of_authors == set(KINDS)
    for name in set(KINDS) - of_authors:
        kind = KINDS[name]
        own = {f.name for f in fields(kind)} - {f.name for f in fields(KINDS["vanishing"])}
        assert all((name, field) in used | fields_of_authors for field in own), name


def test_dollars_stand_in_quotations_alone():
    """Before: LaTeX in a statement, such as a link, was typeset by notebooks, though symbols refuse it."""
    source = paper("chen_riesenfeld_cohen_2007")
    table = next(each for each in source.claim_tables() if each.entry.get("statement"))
    with pytest.raises(ClaimError, match=r"statement: '\$' in a text; write formulas as text"):
        claim_of(Table(table.place, table.entry | {"statement": r"$\href{https://example.org}{f}$"}), source)
