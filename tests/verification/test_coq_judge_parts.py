"""What the kernel of Coq is asked and what is made of its answers; nothing is compiled here."""

import pytest

from exactspline.display.evidence import opinion
from exactspline.errors import FormulaError
from exactspline.verification import coq_judge
from exactspline.verification.claims import all_claims
from exactspline.verification.evidence import Fact, NoTheorem, Theorem
from exactspline.verification.verdict import PROVED, REFUTED, UNDECIDED, Finding


def test_what_coq_says_of_axioms():
    assert coq_judge._axioms("about x\nClosed under the global context\n") == ()
    said = "about x\nAxioms:\nfunctional_extensionality_dep : forall A,\n  (B : A)\nclassic\n  : forall P\n"
    assert coq_judge._axioms(said) == ("functional_extensionality_dep", "classic")


def test_the_least_favourable_opinion_counts():
    missing, refused = (Finding(UNDECIDED, witness=fact) for fact in (Fact.COQ_NOT_INSTALLED, Fact.NOT_ACCEPTED))
    unstated = Finding(UNDECIDED, witness=NoTheorem(FormulaError("no")))
    holds, fails = (Finding(verdict, Theorem("t")) for verdict in (PROVED, REFUTED))
    said = [holds, unstated, fails, refused, missing]
    assert coq_judge.combined_findings(said) is refused
    assert coq_judge.combined_findings(said[:3]) is unstated
    assert coq_judge.combined_findings([holds, fails]) is holds
    assert coq_judge.combined_findings([holds, missing]) is missing
    assert [opinion(each) for each in said] == [
        "holds, no axioms",
        "not stated, no",
        "fails, no axioms",
        "not accepted",
        "Coq is not installed",
    ]
    assert opinion(Finding(PROVED, Theorem("t", ("x", "y")))) == "holds, axioms x, y"


def test_what_coq_is_asked_to_compile(monkeypatch):
    """A file of which no theorem is chosen is not compiled; of one that is not accepted every theorem is tried alone;
    what others are built on is compiled anyhow.
    """
    asked = []

    class Made:
        files = ("Base", "None", "Good", "Bad")

        def write(self, place):
            asked.append("written")

    class Theorem:
        reason = None

        def __init__(self, name):
            self.name = name

    monkeypatch.setattr(coq_judge, "compile_file", lambda place, name: asked.append(name) or name != "Bad")
    monkeypatch.setattr(coq_judge, "_alone", lambda place, name, each: asked.append(each.name) or each.name == "c")
    monkeypatch.setattr(coq_judge, "assumptions", lambda place, name, names: dict.fromkeys(names, name))
    chosen = {"None": (), "Good": (Theorem("a"),), "Bad": (Theorem("b"), Theorem("c"))}
    found = coq_judge.compiled_theorems(Made(), chosen)
    assert asked == ["written", "Base", "Good", "Bad", "b", "c"]
    assert found == {"a": "Good", "c": "Bad_c"}


def test_what_is_asked_of_theorems_and_what_is_told(monkeypatch, tmp_path):
    asked = {}

    def coqc(place, file):
        asked[file] = (place / file).read_text(encoding="utf-8")
        return True, "about a\nClosed under the global context\nabout b\nAxioms:\nclassic : forall P, P \\/ ~ P\n"

    monkeypatch.setattr(coq_judge, "_coqc", coqc)
    told = coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"])
    assert told == {"a": (), "b": ("classic",)}
    text = asked["Ask.v"]
    assert text.startswith(f"Require {coq_judge.ROOT}.papers.one.\n")
    for name in "ab":
        assert f'idtac "about {name}"' in text
        assert f"Print Assumptions {coq_judge.ROOT}.papers.one.{name}.\n" in text
    monkeypatch.setattr(coq_judge, "_coqc", lambda place, file: (False, "about a\nClosed under the global context"))
    assert coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"]) == {}


def test_opinions_of_the_kernel(monkeypatch):
    one, refuted = (next(c for c in all_claims() if c.expected == v) for v in (PROVED, REFUTED))
    last = next(c for c in all_claims() if c not in (one, refuted))

    class Theorem:
        def __init__(self, claim, name, reason=None):
            self.claim, self.name, self.reason, self.text = claim, name, reason, "Theorem."

    class Made:
        def __init__(self):
            self.theorems = {
                "File": (Theorem(one, "a"), Theorem(refuted, "b"), Theorem(last, "c", FormulaError("no equality"))),
                "Other": (Theorem(last, "d"),),
            }

    monkeypatch.setattr(coq_judge, "library", Made)
    monkeypatch.setattr(coq_judge, "compiled_theorems", lambda made, chosen: {"a": (), "b": ("x",)})
    monkeypatch.setattr(coq_judge.shutil, "which", lambda name: "/bin/coqc")
    found = coq_judge.findings([one, refuted, last])
    assert [opinion(found[c.paper, c.key]) for c in (one, refuted, last)] == [
        "holds, no axioms",
        "fails, axioms x",
        "not accepted",
    ]
    assert [*coq_judge.findings([one])] == [(one.paper, one.key)]
    monkeypatch.setattr(coq_judge, "compiled_theorems", lambda made, chosen: pytest.fail("nothing is compiled"))
    monkeypatch.setattr(coq_judge.shutil, "which", lambda name: None)
    found = coq_judge.findings([one, last])
    assert [opinion(found[c.paper, c.key]) for c in (one, last)] == ["Coq is not installed", "not stated, no equality"]


def test_a_theorem_alone_is_compiled_with_what_it_requires(monkeypatch, tmp_path):
    one = next(c for c in all_claims() if c.key == "C41a-f1-f2")

    class Theorem:
        claim, name, text = one, "a", "Theorem a : True. exact I. Qed.\n"

    monkeypatch.setattr(coq_judge, "compile_file", lambda place, name: name)
    assert coq_judge._alone(tmp_path, "File", Theorem()) == "File_a"
    written = (tmp_path / "File_a.v").read_text(encoding="utf-8")
    assert written == coq_judge.claims_header(one.paper, Theorem.text) + Theorem.text
    assert written != Theorem.text
