"""What the kernel of Coq is asked and what is made of its answers; nothing is compiled here."""

import pytest

from exactspline.verification import coq_judge
from exactspline.verification.claims import all_claims
from exactspline.verification.verdict import PROVED, REFUTED


def test_what_coq_says_of_axioms():
    assert coq_judge._told("about x\nClosed under the global context\n") == "no axioms"
    said = "about x\nAxioms:\nfunctional_extensionality_dep : forall A,\n  (B : A)\nclassic\n  : forall P\n"
    assert coq_judge._told(said) == "axioms functional_extensionality_dep, classic"


def test_the_least_favourable_opinion_counts():
    said = [coq_judge.Opinion("", each) for each in ("holds", "not stated", "fails", "not accepted", coq_judge.MISSING)]
    assert coq_judge._together(said).says == "not accepted"
    assert coq_judge._together(said[:3]).says == "not stated"
    assert coq_judge._together([said[0], said[2]]).says == "holds"
    assert coq_judge._together([said[0], said[4]]).says == coq_judge.MISSING
    assert str(coq_judge.Opinion("t", "holds", "no axioms")) == "holds, no axioms"
    assert str(coq_judge.Opinion("t", "holds")) == "holds"


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
        reason = ""

        def __init__(self, name):
            self.name = name

    monkeypatch.setattr(coq_judge, "compile_file", lambda place, name: asked.append(name) or name != "Bad")
    monkeypatch.setattr(coq_judge, "_alone", lambda place, name, each: asked.append(each.name) or each.name == "c")
    monkeypatch.setattr(coq_judge, "assumptions", lambda place, name, names: dict.fromkeys(names, name))
    chosen = {"None": (), "Good": (Theorem("a"),), "Bad": (Theorem("b"), Theorem("c"))}
    found = coq_judge._compiled(Made(), chosen)
    assert asked == ["written", "Base", "Good", "Bad", "b", "c"]
    assert found == {"a": "Good", "c": "Bad_c"}


def test_what_is_asked_of_theorems_and_what_is_told(monkeypatch, tmp_path):
    asked = {}

    def coqc(place, file):
        asked[file] = (place / file).read_text(encoding="utf-8")
        return True, "about a\nClosed under the global context\nabout b\nAxioms:\nclassic : forall P, P \\/ ~ P\n"

    monkeypatch.setattr(coq_judge, "_coqc", coqc)
    told = coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"])
    assert told == {"a": "no axioms", "b": "axioms classic"}
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
        def __init__(self, claim, name, reason=""):
            self.claim, self.name, self.reason, self.text = claim, name, reason, "Theorem."

    class Made:
        def __init__(self):
            self.theorems = {
                "File": (Theorem(one, "a"), Theorem(refuted, "b"), Theorem(last, "c", "no equality")),
                "Other": (Theorem(last, "d"),),
            }

    monkeypatch.setattr(coq_judge, "library", Made)
    monkeypatch.setattr(coq_judge, "_compiled", lambda made, chosen: {"a": "no axioms", "b": "axioms x"})
    monkeypatch.setattr(coq_judge.shutil, "which", lambda name: "/bin/coqc")
    found = coq_judge.opinions([one, refuted, last])
    assert [str(found[c.paper, c.key]) for c in (one, refuted, last)] == [
        "holds, no axioms",
        "fails, axioms x",
        "not accepted",
    ]
    assert [*coq_judge.opinions([one])] == [(one.paper, one.key)]
    monkeypatch.setattr(coq_judge, "_compiled", lambda made, chosen: pytest.fail("nothing is compiled"))
    monkeypatch.setattr(coq_judge.shutil, "which", lambda name: None)
    found = coq_judge.opinions([one, last])
    assert [found[c.paper, c.key].says for c in (one, last)] == [coq_judge.MISSING, "not stated"]


def test_a_theorem_alone_is_compiled_with_what_it_requires(monkeypatch, tmp_path):
    one = next(c for c in all_claims() if c.key == "C41a-f1-f2")

    class Theorem:
        claim, name, text = one, "a", "Theorem a : True. exact I. Qed.\n"

    monkeypatch.setattr(coq_judge, "compile_file", lambda place, name: name)
    assert coq_judge._alone(tmp_path, "File", Theorem()) == "File_a"
    written = (tmp_path / "File_a.v").read_text(encoding="utf-8")
    assert written == coq_judge.claims_header(one.paper, Theorem.text) + Theorem.text
    assert written != Theorem.text
