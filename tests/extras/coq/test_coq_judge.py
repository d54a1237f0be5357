"""What the kernel of Coq is asked and what is made of its answers; nothing is compiled here."""

from types import SimpleNamespace

import pytest

from exactspline import Verdict, claims
from exactspline.display.evidence import opinion
from exactspline.errors import FormulaError
from exactspline.extras.coq import judge as coq_judge
from exactspline.verification import phrases as say
from exactspline.verification.evidence import Fact, NoTheorem
from exactspline.verification.verdict import Finding


def test_the_least_favourable_opinion_counts():
    missing, refused = (
        Finding(Verdict.UNDECIDED, witness=fact) for fact in (Fact.COQ_NOT_INSTALLED, Fact.NOT_ACCEPTED)
    )
    unstated = Finding(Verdict.UNDECIDED, witness=NoTheorem(FormulaError("no")))
    holds, fails = (Finding(verdict, say.accepted_with(())) for verdict in (Verdict.PROVED, Verdict.REFUTED))
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
    assert opinion(Finding(Verdict.PROVED, say.accepted_with(("x", "y")))) == "holds, axioms x, y"


def test_what_coq_is_asked_to_compile(monkeypatch):
    """A file of which no theorem is chosen is not compiled; of one that is not accepted every theorem is tried alone,
    with what it requires; what others are built on is compiled anyhow.
    """
    asked, one = [], next(c for c in claims() if c.key == "C41a-f1-f2")

    class Made:
        files = ("Base", "None", "Good", "Bad")

        def write(self, place):
            asked.append("written")

    class Theorem:
        claim, reason, text = one, None, "Theorem a : True. exact I. Qed.\n"

        def __init__(self, name):
            self.name = name

    def compile_file(place, name):
        asked.append(name)
        if name in ("Bad_b", "Bad_c"):
            alone = (place / f"{name}.v").read_text(encoding="utf-8")
            assert alone == coq_judge.claims_header(one.paper, Theorem.text) + Theorem.text != Theorem.text
        return name not in ("Bad", "Bad_b")

    monkeypatch.setattr(coq_judge, "compile_file", compile_file)
    monkeypatch.setattr(coq_judge, "assumptions", lambda place, name, names: dict.fromkeys(names, name))
    chosen = {"None": (), "Good": (Theorem("a"),), "Bad": (Theorem("b"), Theorem("c"))}
    found = coq_judge.compiled_theorems(Made(), chosen)
    assert asked == ["written", "Base", "Good", "Bad", "Bad_b", "Bad_c"]
    assert found == {"a": "Good", "c": "Bad_c"}


def test_what_is_asked_of_theorems_and_what_is_told(monkeypatch, tmp_path):
    asked = {}

    said = "about a\nClosed under the global context\nabout b\nAxioms:\n"
    said += "functional_extensionality_dep : forall A,\n  (B : A)\nclassic\n  : forall P\n"

    def coqc(command, *, cwd, **options):
        asked[command[-1]] = (cwd / command[-1]).read_text(encoding="utf-8")
        return SimpleNamespace(returncode=0, stdout=said)

    monkeypatch.setattr(coq_judge.subprocess, "run", coqc)
    told = coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"])
    assert told == {"a": (), "b": ("functional_extensionality_dep", "classic")}
    text = asked["Ask.v"]
    assert text.startswith(f"Require {coq_judge.ROOT}.papers.one.\n")
    for name in "ab":
        assert f'idtac "about {name}"' in text
        assert f"Print Assumptions {coq_judge.ROOT}.papers.one.{name}.\n" in text
    refused = SimpleNamespace(returncode=1, stdout=said)
    monkeypatch.setattr(coq_judge.subprocess, "run", lambda *command, **options: refused)
    assert coq_judge.assumptions(tmp_path, "papers/one", ["a", "b"]) == {}


def test_opinions_of_the_kernel(monkeypatch):
    one, refuted = (next(c for c in claims() if c.expected == v) for v in (Verdict.PROVED, Verdict.REFUTED))
    last = next(c for c in claims() if c not in (one, refuted))

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
