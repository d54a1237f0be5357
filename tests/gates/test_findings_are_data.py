"""Law 3: a decision is data, a sentence is printed last. A finding has no text but names; nothing reads a sentence."""

import ast
import typing
from dataclasses import dataclass, fields, is_dataclass, replace
from enum import Enum
from pathlib import Path

import pytest

import exactspline
from exactspline.classroom.answers import Finding as StudentFinding
from exactspline.classroom.differences import Difference
from exactspline.display.evidence import worded, words
from exactspline.display.ledger import found, row_data, witness
from exactspline.errors import ExactSplineError
from exactspline.interchange.examples import example, example_names
from exactspline.numbers.exact import mpq
from exactspline.papers import papers
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet
from exactspline.symbolic.assumptions import Assumption
from exactspline.symbolic.factorization import Factor
from exactspline.verification import evidence
from exactspline.verification.claims import claims_in, select
from exactspline.verification.evidence import Evidence, ExactQuotient, JudgesDisagree, WrongDegree
from exactspline.verification.judges import Jets, Sympy, agreed, compared_rows, second_opinions
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import audit, proved
from exactspline.verification.questions import Proof
from exactspline.verification.rows import Row
from exactspline.verification.verdict import CONTRADICTION, PROVED, REFUTED, UNDECIDED, VERIFIED, Finding
from exactspline.verification.vocabulary import Name

ROOT = Path(exactspline.__file__).parent

# ---- types

#: Objects of algebra, and errors, which bring their own words.
OBJECTS = (Factor, Degree, Jet, Assumption, Proof, ExactSplineError, type(mpq()), bool, int, type(None))


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
    elif kind in (Evidence, Difference):
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
    assert {each for each in Difference.__subclasses__() if not issubclass(each, Enum)} <= seen
    assert all(map(has_words, Difference.__subclasses__()))


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


def test_the_walk_over_types_finds_a_planted_text():
    assert list(texts(Planted)) == ["Planted.why"]
    assert list(texts(Deeper)) == ["Deeper.pairs", "Planted.why"]


def test_every_kind_of_evidence_has_words():
    kinds = {each for each in vars(evidence).values() if isinstance(each, type) and issubclass(each, Evidence)}
    assert {each for each in kinds - {Evidence} if not has_words(each)} == set()
    assert not has_words(Evidence)


def has_words(kind):
    """Whether a kind of evidence has phrases, a template, or a function of its own."""
    return issubclass(kind, Enum) or bool(kind.template) or kind in words.registry.keys() - {Evidence, Difference}


# ---- no code reads a sentence

#: The parts of a finding.
FOUND = {"witness", "computed", "factor", "finding", "reason", "verdict", "evidence"}
#: What is done with texts to learn something of them.
READING = {
    *("startswith", "endswith", "find", "index", "rfind", "split", "rsplit", "partition", "rpartition", "count"),
    *("removeprefix", "removesuffix", "splitlines"),
}
PATTERNS = {"match", "fullmatch", "search", "findall", "finditer", "split"}


def sentences(tree):
    """The names of variables that hold the words of what was found."""
    return {
        target.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and is_sentence(node.value, set())
        for target in node.targets
        if isinstance(target, ast.Name)
    }


def is_sentence(node, named):
    """Whether an expression is in words what was found: a call that makes them, a text field of that name, a text with
    such a part.
    """
    if isinstance(node, ast.Name):
        return node.id in named
    if isinstance(node, ast.Attribute):
        of_claim = isinstance(node.value, ast.Name) and node.value.id in {"self", "claim"}
        return node.attr in FOUND and not of_claim  # a claim states its factor, and names a curve as witness
    if isinstance(node, ast.Subscript):
        return isinstance(node.slice, ast.Constant) and node.slice.value in FOUND
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        made = node.func.id in {"words", "worded", "opinion"}
        return made or (node.func.id in {"str", "repr", "format"} and any(is_sentence(x, named) for x in node.args))
    if isinstance(node, ast.JoinedStr):
        return any(isinstance(x, ast.FormattedValue) and is_sentence(x.value, named) for x in node.values)
    return False


def reads(tree):
    """The lines on which a program learns something from the words of what was found."""
    named = sentences(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            of = node.func.value
            pattern = isinstance(of, ast.Name) and of.id == "re" and node.func.attr in PATTERNS
            compiled = node.func.attr in PATTERNS and any(is_sentence(x, named) for x in node.args)
            if (node.func.attr in READING and is_sentence(of, named)) or (
                (pattern or compiled) and any(is_sentence(x, named) for x in node.args)
            ):
                yield node.lineno
        if isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
            membership = any(isinstance(op, ast.In | ast.NotIn) for op in node.ops)
            of_text = any(isinstance(x, ast.Constant) and isinstance(x.value, str) and x.value for x in sides)
            equal = any(isinstance(op, ast.Eq | ast.NotEq) for op in node.ops)
            if (membership and is_sentence(node.comparators[0], named)) or (
                equal and of_text and any(is_sentence(x, named) for x in sides)
            ):
                yield node.lineno
        if isinstance(node, ast.Subscript) and is_sentence(node.value, named) and isinstance(node.slice, ast.Slice):
            yield node.lineno
        if isinstance(node, ast.Match) and is_sentence(node.subject, named):
            cases = [case.pattern for case in node.cases]
            if any(isinstance(x, ast.MatchValue) and isinstance(x.value, ast.Constant) for x in cases):
                yield node.lineno


def test_no_module_reads_the_words_of_a_finding():
    read = [
        f"{path.relative_to(ROOT)}:{line}"
        for path in ROOT.rglob("*.py")
        for line in reads(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert read == []


@pytest.mark.parametrize(
    "planted",
    [
        'row.witness.startswith("the exact quotient is")',
        're.fullmatch(r"-?\\d+, not -?\\d+", row.witness)',
        "PATTERN.match(str(row.witness))",
        '"not proportional" in finding.computed',
        'finding.factor == "1"',
        'told = worded(row.witness)\nif told.endswith("1/0"): pass',
        'told = f"{row.witness}"\nif "1/0" in told: pass',
        'row["witness"].partition(": ")',
        "str(finding.witness)[:5]",
        'match found.computed:\n    case "0 = 0":\n        pass',
        'words(x).split(", not ")',
        'row.verdict != "PROVED"',
    ],
)
def test_a_planted_decision_by_a_sentence_is_found(planted):
    assert list(reads(ast.parse(planted)))


@pytest.mark.parametrize(
    "harmless",
    [
        "row.witness is Fact.NOT_SO",
        "isinstance(row.witness, ExactQuotient)",
        "row.verdict == REFUTED",
        'f"{row.witness}"',
    ],
)
def test_what_reads_no_sentence_is_not_found(harmless):
    assert not list(reads(ast.parse(harmless)))


# ---- what tables leave out follows from types


def test_what_a_row_says_already_is_not_said_again():
    one = select(["C4.1a"])[0]
    false = proved(replace(one, factor="w^2"))
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
        truth = Jets().decide(claim).verdict
        return Finding({PROVED: REFUTED, REFUTED: PROVED}.get(truth, truth))


def test_a_judge_that_lies_is_a_contradiction():
    right = select(["C4.1a"])[0]
    wrong = replace(right, factor="w^2", expected="REFUTED", status="ours", error="")
    rows = [task() for task in second_opinions(Liar(), [right, wrong])]
    assert [row.verdict for row in rows] == [CONTRADICTION] * 2
    assert not any(row.as_recorded for row in rows)
    assert [(row.witness.proved, row.witness.refuted) for row in rows] == [("jet", "liar"), ("liar", "jet")]
    rows = compared_rows(list(audit([right], None)), Liar())
    assert {row.verdict for row in rows if not row.curve} == {CONTRADICTION}
    assert VERIFIED in {row.verdict for row in rows if row.curve}
    assert isinstance(rows[0].witness, JudgesDisagree)


def test_judges_that_agree_or_do_not_decide_change_nothing():
    one, two = Name("one"), Name("two")
    for own in (PROVED, REFUTED, UNDECIDED):
        for other in (own, UNDECIDED):
            assert agreed(Finding(own), one, Finding(other), two).verdict == own
    chosen = [claim for claim in select(["C4.1a", "C3c"]) if isinstance(claim, Identity)]
    assert [task().verdict for task in second_opinions(Sympy(), chosen)] == [claim.expected for claim in chosen]


def test_the_same_statement_is_decided_in_every_reading():
    """One `decide` for jets, sympy and splines: the verdicts of an equality agree wherever it says something."""
    claims = [claim for claim in claims_in(papers()) if claim.equality is not None and claim.expected == PROVED]
    assert len(claims) > 60
    kinds = {type(claim.equality).__name__ for claim in claims}
    assert kinds == {"Equation", "Zero", "OneRuledSurface", "DirectrixOf"}
