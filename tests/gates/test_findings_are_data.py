"""Law 3: a decision is data, a sentence is printed last. A finding has no text but names (nothing reads a sentence:
`test_gates`).
"""

import typing
from dataclasses import dataclass, fields, is_dataclass, replace
from enum import Enum
from pathlib import Path

import exactspline
from exactspline.display.evidence import worded, words
from exactspline.display.ledger import found, row_data, witness
from exactspline.errors import ExactSplineError
from exactspline.extras.teaching import differences
from exactspline.extras.teaching.answers import Finding as StudentFinding
from exactspline.interchange.examples import example, example_names
from exactspline.numbers.exact import mpq
from exactspline.papers import papers
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.reals.real import Real
from exactspline.symbolic.assumptions import Assumption
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence, phrases
from exactspline.verification.claims import claims_in, select
from exactspline.verification.evidence import Evidence, ExactQuotient, Phrase, Said, WrongDegree
from exactspline.verification.judges import Sympy, agreed, second_opinion
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import Row, audit, decide
from exactspline.verification.questions import Proof
from exactspline.verification.verdict import CONTRADICTION, PROVED, REFUTED, UNDECIDED, VERIFIED, Finding
from exactspline.verification.vocabulary import Name, Reason

ROOT = Path(exactspline.__file__).parent

# ---- types

#: Objects of algebra, and errors, which bring their own words.
OBJECTS = (Factor, Degree, Jet, Assumption, Proof, ExactSplineError, type(mpq()), Real, bool, int, type(None))
#: What can be said, of claims and of answers.
PHRASES = [each for module in (phrases, differences) for each in vars(module).values() if isinstance(each, Phrase)]


def texts(kind, place="", seen=None):
    """The places at which a type has a text that is not a name."""
    seen = set() if seen is None else seen
    if kind is Name or kind is Ellipsis or kind in seen:
        return
    if arguments := typing.get_args(kind):
        for each in arguments:
            yield from texts(each, place, seen)
    elif issubclass(kind, Enum) or issubclass(kind, OBJECTS):
        return
    elif kind is Said:
        seen.add(kind)
        for phrase in PHRASES:
            hints = typing.get_type_hints(phrase.words)
            for name in hints.keys() - {"return"}:
                yield from texts(hints[name], f"{phrase.words.__name__}.{name}", seen)
    elif kind is Evidence:
        seen.add(kind)
        for each in kind.__subclasses__():
            yield from texts(each, each.__name__, seen)
    elif is_dataclass(kind):
        seen.add(kind)
        hints = typing.get_type_hints(kind)
        for each in fields(kind):
            yield from texts(hints[each.name], f"{kind.__name__}.{each.name}", seen)
    else:
        yield place


def test_a_finding_and_all_its_evidence_have_no_text_but_names():
    seen = set()
    assert list(texts(Finding, seen=seen)) == []
    assert {each for each in Evidence.__subclasses__() if not issubclass(each, Enum)} <= seen


def test_what_is_wrong_in_an_answer_has_no_text_but_names():
    """Passed before: the findings on answers of students were sentences."""
    seen = set()
    assert list(texts(StudentFinding, seen=seen)) == []
    assert Said in seen


@dataclass
class Planted:
    """A witness with a sentence."""

    at: mpq
    why: str


@dataclass
class Deeper:
    """A witness with sentences where they are not seen at once."""

    pairs: tuple[tuple[Name, str], ...]
    inner: Planted | None


@Phrase
def planted(name: Name, why: str) -> str:
    """A phrase about a sentence."""
    return f"{name}: {why}"


def test_the_walk_over_types_finds_a_planted_text(monkeypatch):
    assert list(texts(Planted)) == ["Planted.why"]
    assert list(texts(Deeper)) == ["Deeper.pairs", "Planted.why"]
    monkeypatch.setattr("tests.gates.test_findings_are_data.PHRASES", [planted])
    assert list(texts(Said)) == ["planted.why"]


def test_every_kind_of_evidence_has_words():
    kinds = {each for each in vars(evidence).values() if isinstance(each, type) and issubclass(each, Evidence)}
    assert {each for each in kinds - {Evidence} if not has_words(each)} == set()
    assert not has_words(Evidence)


def has_words(kind):
    """Whether a kind of evidence has phrases, or a function of its own."""
    return issubclass(kind, Enum) or kind in words.registry


# ---- what tables leave out follows from types


def test_what_a_row_says_already_is_not_said_again():
    one = select(["C4.1a"])[0]
    false = decide(replace(one, factor="w^2"))
    assert false.witness == ExactQuotient(false.factor)
    assert (found(false), witness(false)) == ("f1 = w · f2", "")
    degree = next(c for c in select(["C4.1c"]) if c.kind == "degree" and c.measure == "nominal")
    curve = next(c for c in map(example, example_names()) if degree.applies_to(c.dimension, c.polynomial))
    (row,) = audit([replace(degree, claimed="99")], [curve])
    assert isinstance(row.witness, WrongDegree)
    assert (found(row), witness(row)) == (f"{row.witness.degree}, not 99", "")


def test_json_and_table_are_made_of_the_same_finding():
    for row in audit(select(["C4.2b", "C5.3"]), [example("rational_space_cubic"), example("circle")]):
        assert isinstance(row, Row)
        data = row_data(row)
        assert data["verdict"] is row.verdict
        assert (data["computed"], data["witness"]) == (worded(row.computed), worded(row.witness))


# ---- judges


class Liar:
    """A judge that says the opposite of the truth."""

    name = Name("liar")

    def decide(self, claim):
        """PROVED where the jets refute, and the other way round."""
        truth = claim.prove()[1].verdict
        return Finding({PROVED: REFUTED, REFUTED: PROVED}.get(truth, truth))


def test_a_judge_that_lies_is_a_contradiction():
    right = select(["C4.1a"])[0]
    wrong = replace(right, factor="w^2", expected="REFUTED", status="ours", error="")
    rows = [second_opinion(Liar(), decide(claim)) for claim in (right, wrong)]
    assert [row.verdict for row in rows] == [CONTRADICTION] * 2
    assert all(row.differs for row in rows)
    assert [row.witness.about[:2] for row in rows] == [("jet", "liar"), ("liar", "jet")]
    rows = [second_opinion(Liar(), row) for row in audit([right])]
    assert {row.verdict for row in rows if not row.curve} == {CONTRADICTION}
    assert VERIFIED in {row.verdict for row in rows if row.curve}
    assert rows[0].witness.phrase is phrases.judges_disagree


def test_judges_that_agree_or_do_not_decide_change_nothing():
    one, two = Name("one"), Name("two")
    for own in (PROVED, REFUTED, UNDECIDED):
        for other in (own, UNDECIDED):
            assert agreed(Finding(own), one, Finding(other), two).verdict == own
    chosen = [claim for claim in select(["C4.1a", "C3c"]) if isinstance(claim, Identity)]
    rows = [second_opinion(Sympy(), decide(claim)) for claim in chosen]
    assert [(row.verdict, row.second.verdict) for row in rows] == [(claim.expected,) * 2 for claim in chosen]
    # where the first judge decides nothing, the second one is still held against the record
    wrong = replace(chosen[0], factor="w^5")
    open_row = replace(decide(wrong), finding=Finding(UNDECIDED, reason=Reason.COST))
    assert (open_row.differs, second_opinion(Sympy(), open_row).differs) == (False, True)


def test_the_same_statement_is_decided_in_every_reading():
    """One `decide` for jets, sympy and splines: the verdicts of an equality agree wherever it says something."""
    claims = [claim for claim in claims_in(papers()) if claim.equality is not None and claim.expected == PROVED]
    assert len(claims) > 60
    kinds = {type(claim.equality).__name__ for claim in claims}
    assert kinds == {"Equation", "Zero", "OneRuledSurface", "DirectrixOf"}
