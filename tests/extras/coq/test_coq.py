"""The theorems of Coq: all that the papers give is written, what is false does not compile, and answers
about curves are what the zero sets say.

What needs Coq is skipped without it; `EXACTSPLINE_COQ_MUTANTS=200 pytest tests/extras/coq/test_coq.py` runs as many
corrupted certificates.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from random import Random

import pytest
from flint import fmpq, fmpq_poly

from docs import ten_claims
from exactspline import Nurbs, Verdict, example, examples, formula_of, intersections, paper, write, zeros
from exactspline.display.evidence import opinion
from exactspline.errors import ClaimError, FormulaError
from exactspline.extras.coq import judge as coq_judge
from exactspline.extras.coq.answers import answers, meeting_theorem, rational_determinant, theorem_of
from exactspline.extras.coq.emission import BY_HAND, ROOT, library
from exactspline.extras.coq.formulas import THEORY, Formulas
from exactspline.extras.coq.theorems import theorem
from exactspline.papers import papers
from exactspline.verification.claims import claims_of, select
from tests.support.bisector_oracle import bezier
from tests.support.command import run
from tests.verification.test_own_paper import written
from workshop.mutation import kernel


def needs_coq(test: Callable[..., None]) -> Callable[..., None]:
    """A test of the kernel: `.ci/run` has these next to the theorems, where Coq was just installed."""
    return pytest.mark.coq(pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed")(test))


def test_all_that_the_papers_give_is_written(tmp_path: Path) -> None:
    files = library().files
    library().write(tmp_path)
    written = {str(path.relative_to(tmp_path).with_suffix("")) for path in tmp_path.rglob("*.v")}
    assert written == set(files)
    listed = (tmp_path / "_CoqProject").read_text(encoding="utf-8").split()[3:]
    assert listed == [f"{name}.v" for name in files]
    assert all((tmp_path / f"{name}.v").read_text(encoding="utf-8") == text for name, text in files.items())


def test_nothing_is_assumed_or_left_out() -> None:
    for name, text in library().files.items():
        assert not re.search(r"\b(Axiom|Parameter|Admitted|admit|Conjecture|Abort)\b", text), name
    assert not library().unstated


def test_every_refuted_claim_is_denied() -> None:
    for own in library().theorems.values():
        for each in own:
            if not each.reason:
                assert each.name.endswith("_fails") == (each.claim.expected == Verdict.REFUTED)


def compiled(place: Path, name: str) -> bool:
    """Whether Coq accepts a file."""
    run = subprocess.run(
        ["coqc", "-q", "-R", ".", ROOT, f"{name}.v"], cwd=place, capture_output=True, check=False, timeout=120
    )
    return run.returncode == 0


@cache
def _room(base: Path) -> Path:
    """The base and the formulas, compiled once, or what `proofs/check_coq` has compiled in a folder."""
    if "EXACTSPLINE_COMPILED" in os.environ:
        return Path(os.environ["EXACTSPLINE_COMPILED"])
    made = library()
    made.write(base)
    for name in made.files:
        if name in BY_HAND or name.startswith("formulas/"):
            assert compiled(base, name), name
    return base


@pytest.fixture(scope="module")
def room(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the base and the formulas are compiled."""
    return _room(tmp_path_factory.mktemp("coq"))


def accepted(place: Path, text: str) -> bool:
    """Whether Coq accepts a text."""
    (place / "Tried.v").write_text(text, encoding="utf-8")
    return compiled(place, "Tried")


@needs_coq
def test_a_false_factor_does_not_compile(room: Path) -> None:
    file = library().files["claims/chen_riesenfeld_cohen_2007_section4_1"]
    assert accepted(room, file)
    assert file.count("f0 c = number 1 / w c ^ 3 * f2 c") == 1
    assert not accepted(room, file.replace("w c ^ 3 * f2 c", "w c ^ 2 * f2 c"))


@needs_coq
def test_without_its_assumption_a_theorem_fails(room: Path) -> None:
    each = next(e for own in library().theorems.values() for e in own if e.name == "E12_evolute_contact_1")
    begin = library().files["claims/chen_riesenfeld_cohen_2007_section4_3"].split("(** ", 2)
    head = "(** " + begin[1]
    assert accepted(room, head + each.text)
    weaker = each.text.replace("  f2 c <> zero K ->\n", "").replace("Hw H1.", "Hw. assert (H1 : True) by exact I.")
    assert weaker != each.text
    assert not accepted(room, head + weaker)


@needs_coq
def test_the_kernel_says_what_a_theorem_assumes(room: Path) -> None:
    name = "claims/chen_riesenfeld_cohen_2007_section4_1"
    assert compiled(room, name)
    said = coq_judge.assumptions(room, name, ["C41a_f0_f2", "C41a_f1_f2"])
    assert said == {"C41a_f0_f2": (), "C41a_f1_f2": ()}


def test_without_coq_the_column_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    found = coq_judge.findings(select(["C4.1a"]))
    assert [opinion(each) for each in found.values()] == ["Coq is not installed"] * 2
    assert [each.verdict for each in found.values()] == ["UNDECIDED"] * 2


@pytest.mark.parametrize("name", examples("curves"))
def test_answers_are_what_the_zero_sets_say(name: str) -> None:
    curve = example(name)
    for answer in answers(curve):
        form = answer.formula(curve)
        found = zeros(form)
        for root in found.roots:
            at_end = root.low == root.high == form.domain[1] and bool(answer.stretches)
            met = [1 for a, b in answer.points if a <= root.high and root.low <= b]
            assert met or at_end, (name, root.low)
        for a, b in answer.points:
            inside = any(r.low <= b and a <= r.high for r in found.roots)
            assert inside or any(i.low <= a <= i.high for i in found.intervals), (name, a, b)


@needs_coq
@pytest.mark.parametrize("name", ["cubic_s", "straight_between_arcs"])
def test_the_theorem_about_a_curve_compiles(room: Path, name: str) -> None:
    assert accepted(room, theorem_of(example(name)))


@needs_coq
def test_one_zero_is_not_told_twice_and_the_domain_is_that_of_the_curve(room: Path) -> None:
    begin = (
        "From ExactSpline Require Import Answers. Require Import QArith List. Import ListNotations. Open Scope Q_scope."
    )
    adjacent, twice = "[(0, 1); (1, 1); (1, 2)]", "[(0, 1); (1, 1); (1, 1)]"
    for points, separated in ((adjacent, "true"), (twice, "false"), ("[(0, 2); (1, 3)]", "false")):
        assert accepted(room, f"{begin} Goal separated {points} = {separated}. reflexivity. Qed.")
    text = theorem_of(example("cubic_s"))
    assert text.count("domain this_curve = (0, 1)") == 1
    assert not accepted(room, text.replace("domain this_curve = (0, 1)", "domain this_curve = (0, 2)"))


@needs_coq
@pytest.mark.parametrize("points", [[(1, 2)] * 3, [(0, 0), (1, 1), (2, 2)], [(1, 2, 3)] * 3])
def test_degenerate_curves_have_theorems(room: Path, points: list[tuple[int, ...]]) -> None:
    text = theorem_of(Nurbs(2, [0] * 3 + [1] * 3, points))
    assert "at exactly 1 point and 1 stretch" in text
    assert accepted(room, text)


@needs_coq
def test_a_multiple_zero_has_a_witness(room: Path) -> None:
    heights = ["1/81", "-2/81", "4/81", "-8/81", "16/81"]  # (t − 1/3)⁴: y″ has a double zero that halving never meets
    curve = Nurbs(4, [0] * 5 + [1] * 5, list(enumerate(heights)))
    text = theorem_of(curve)
    assert "Multiple" in text
    assert accepted(room, text)
    assert not accepted(room, text.replace("] true 2 [", "] true 1 [").replace("] false 2 [", "] false 1 ["))


def corrupted(text: str, chance: Random) -> str:
    """A theorem about a curve with a number of its certificate or its form changed, a zero dropped, a sign turned."""
    kind = chance.randrange(4)
    statement = re.search(r"vanishes_exactly .*?\n    \[(.*?)\]\n", text, re.DOTALL)
    assert statement is not None
    if kind == 0 and statement[1]:
        points = statement[1].split("), ")
        points.pop(chance.randrange(len(points)))
        kept = "), ".join(points)
        kept = kept if not kept or kept.endswith(")") else f"{kept})"
        return text[: statement.start(1)] + kept + text[statement.end(1) :]
    begin = text.index("Definition cells_of")
    signs = list(re.finditer(r"\b(true|false)\b", text[begin : text.index("].", begin)]))
    if kind == 1 and signs:
        place = chance.choice(signs)
        turned = {"true": "false", "false": "true"}[place[1]]
        return text[: begin + place.start()] + turned + text[begin + place.end() :]
    region = text.index("_in_pieces : pieces") if kind == 2 else begin
    end = text.index("].", region)
    numbers = list(re.finditer(r"\d+", text[region:end]))
    place = chance.choice(numbers)
    at = region + place.start()
    return text[:at] + str(int(place[0]) + 1) + text[at + len(place[0]) :]


@needs_coq
def test_corrupted_certificates_never_compile(room: Path) -> None:
    chance = Random(16)
    names = [name for name in examples("curves") if example(name).dimension == 2]
    for _ in range(int(os.environ.get("EXACTSPLINE_COQ_MUTANTS", "4"))):
        text = theorem_of(example(chance.choice(names)))
        broken = corrupted(text, chance)
        assert broken != text
        assert not accepted(room, broken), broken


def test_from_the_command_line(tmp_path: Path) -> None:
    file = tmp_path / "cubic.v"
    assert run("inspect", "cubic_s", "--digits", "1", "--emit-coq", file).returncode == 0
    assert file.read_text(encoding="utf-8") == theorem_of(example("cubic_s"))
    told = run("coq", tmp_path / "all")
    assert told.returncode == 0
    assert f"in {len(library().files)} files" in told.stdout
    assert (tmp_path / "all" / "Base.v").is_file()
    for name, better in (("3dm_x.v", "curve_3dm_x.v"), ("a-b.v", "a_b.v"), ("x.txt", "x_txt.v")):
        refused = run("inspect", "cubic_s", "--emit-coq", tmp_path / name)
        assert refused.returncode == 2
        assert f"write --emit-coq {tmp_path / better}" in " ".join(refused.stderr.split())
    for folder in ("/", "."):
        refused = run("inspect", "cubic_s", "--emit-coq", folder)
        assert refused.returncode == 2
        assert refused.stderr.startswith("error: ")
    both = tmp_path / "both.json"
    write([example("cubic_s"), example("circle")], both)
    # of a file with two curves the first alone was written, without a word
    for curves in (("cubic_s", "circle"), (both,)):
        refused = run("inspect", *curves, "--emit-coq", file)
        assert refused.returncode == 2
        assert "one file per curve" in refused.stderr


def test_formulas_that_lean_on_each_other_keep_their_names() -> None:
    text = library().files["formulas/chen_riesenfeld_cohen_2007"]
    assert "Definition evolute (c : curve A) : list A :=" in text
    assert formula_of("evolute").source in text


def test_the_page_of_ten_claims_says_what_is_so() -> None:
    claims = ten_claims.chosen()
    assert len(claims) == 10
    told = ten_claims.page({claim.key: ten_claims.expected(claim) for claim in claims})
    assert ten_claims.PAGE.read_text(encoding="utf-8") == told, "run python -m docs.ten_claims"


def test_a_theorem_is_refused_for_every_change_of_a_formula_on_record() -> None:
    made = library()
    theorems = [each for own in made.theorems.values() for each in own if not each.reason]
    record = kernel.recorded()
    assert set(record) <= set(kernel.spoken_of(Formulas(papers()), theorems))
    assert {found["refused"] for found in record.values()} <= {each.name for each in theorems}


# ---- two curves


#: Two crossings 0.012 apart; a point where two curves touch; one at rational parameters; one of
#: a circle; one on a line parallel to an axis; none.
PAIRS = [
    (bezier((2, 8), (2, 3), (3, 0), (2, 5)), bezier((2, 2), (8, 8), (5, 8), (10, 8)), 2),
    (bezier((0, 0), ("1/2", 0), (1, 1)), bezier((0, "-1/4"), (1, "3/4")), 1),
    (bezier((0, 0), (1, 1)), bezier((0, 1), (1, 0)), 1),
    (Nurbs(2, [0] * 3 + [1] * 3, [(1, 0), (1, 1), (0, 1)], [1, 1, 2]), bezier((0, "1/3"), (2, "1/2")), 1),
    (bezier((0, "1/2"), (1, "1/2")), bezier((0, 0), ("1/2", 0), (1, 1)), 1),
    (bezier((0, 0), (1, 1)), bezier((0, 1), (1, 2), (2, 4)), 0),
]


@pytest.mark.parametrize(("first", "second", "count"), PAIRS)
def test_a_theorem_about_two_curves_has_a_box_for_each_point(first: Nurbs, second: Nurbs, count: int) -> None:
    text = meeting_theorem(first, second)
    found = intersections(first, second)
    assert len(found) == count
    assert f"meet at exactly {count} point" in text
    told = re.search(r"hold_exactly .*?\[(.*)\]\.\n", text, re.DOTALL)
    assert told is not None
    numbers = [Fraction(x.replace(" # ", "/")) for x in re.findall(r"-?\d+(?: # \d+)?", told[1])]
    boxes = [numbers[k : k + 4] for k in range(0, len(numbers), 4)]
    for (a, b, c, d), point in zip(boxes, sorted(found, key=lambda point: point.second), strict=True):
        assert a <= point.first <= b
        assert c <= point.second <= d


@needs_coq
def test_coq_accepts_all_points_of_two_curves_and_no_others(room: Path) -> None:
    """A box that is left out, told twice or elsewhere, and a curve that is another one, do not compile."""
    for first, second, _ in PAIRS[:2]:
        assert accepted(room, meeting_theorem(first, second))
    text = meeting_theorem(*PAIRS[0][:2])
    begin = text.index("Theorem the_curves_meet")
    statement = re.compile(r"\[(\(\(.*?\)\)); (\(\(.*?\)\))\]")
    one, other = next(statement.finditer(text[begin:])).groups()
    for boxes in (f"[{one}]", f"[{one}; {one}]", f"[{other}; {one}]", "[]"):
        assert not accepted(room, text[:begin] + statement.sub(boxes, text[begin:]))
    assert text.count("coordinates := [[2; 2; 3; 2]") == 1
    assert not accepted(room, text.replace("coordinates := [[2; 2; 3; 2]", "coordinates := [[2; 2; 3; 1]"))


def test_determinants_take_a_time_bounded_by_a_power_of_their_size() -> None:
    """Before, all sets of columns were gone through: without end for curves of the degrees 12 and 2."""
    size, x = 22, fmpq_poly([0, fmpq(1, 3)])
    rows = [[fmpq_poly([i + j]) if i < j else x if i == j else fmpq_poly([]) for j in range(size)] for i in range(size)]
    assert rational_determinant(rows[::-1]) == -(x**size)


def test_what_has_no_theorem_says_so(tmp_path: Path) -> None:
    loop = bezier((0, 0), (3, 3), (-2, 3), (1, 0))
    for first, second, why in (
        (loop, loop, "arcs in common"),
        (example("circle"), loop, "one segment"),
        (bezier((0, 0), (1, 0)), bezier((0, 0), (2, 0)), "parallel to an axis"),
        (bezier((0, "1/2"), (1, "1/2")), bezier(("-1/2", 0), ("-1/2", 0), ("1/2", 1)), "bisection"),
    ):
        with pytest.raises(ClaimError, match=why):
            meeting_theorem(first, second)
    for name, curve in (("one", PAIRS[1][0]), ("other", PAIRS[1][1])):
        write(curve, tmp_path / f"{name}.json")
    names = [tmp_path / "one.json", tmp_path / "other.json"]
    assert run("between", *names, "--emit-coq", tmp_path / "both.v").returncode == 0
    assert "Theorem the_curves_meet" in (tmp_path / "both.v").read_text(encoding="utf-8")
    assert run("between", *names, "--emit-coq", tmp_path / "3.v").returncode == 2


PLANE_PAIRS = """
@formula("e", on="plane pair")
def turned(c):
    return det(c.first.gamma.d(1, by="s"), c.second.gamma.d(1, by="s̄"))
@formula("e", on="plane pair")
def lifted(c):
    p, q, w, v = c.first.p, c.second.p, c.first.w, c.second.w
    return det(p.d(1, by="s") * w - p * w.d(1, by="s"), q.d(1, by="s̄") * v - q * v.d(1, by="s̄"))
"""


def theorem_about_plane_pairs(tmp_path: Path, **fields: str) -> str:
    """The theorem of a claim about formulas of two plane curves, with their definitions."""
    claim = {"id": "1", "kind": "identity", "statement": "s", "curve": "plane pair", "left": "turned"}
    own = paper(written(tmp_path / "p", PLANE_PAIRS, [claim | {"right": "lifted"} | fields]))
    formulas = Formulas((*papers(), own))
    (one,) = claims_of(own)
    text = theorem(one, 2, lambda formula: formulas.named(formula, own))
    return f"{formulas.definitions(own)}\nFrom {ROOT} Require Import {' '.join(THEORY)}.\n{text}"


@needs_coq
def test_equalities_of_two_plane_curves_have_theorems(room: Path, tmp_path: Path) -> None:
    """Written before: a theorem about two space curves, which did not compile."""
    text = theorem_about_plane_pairs(tmp_path, factor="w^-2 W^-2")
    assert "every_two_plane_curves" in text
    assert accepted(room, text)
    assert not accepted(room, text.replace("w (second c) ^ 2", "w (second c) ^ 1"))


def test_what_has_no_quantifier_has_no_theorem(tmp_path: Path) -> None:
    with pytest.raises(FormulaError, match="no quantifier over the kind 'plane pair'"):
        theorem_about_plane_pairs(tmp_path, of="polynomial")
