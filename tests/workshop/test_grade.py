"""Grading: cases, exact answers and their checker, verdicts; and that a library is not called wrong without proof."""

import copy
import json
import os
import select
import sys
from collections import Counter
from dataclasses import replace
from functools import cache
from pathlib import Path

import jsonschema
import pytest
from gmpy2 import mpq

import exactspline as xs
from exactspline.errors import FormulaError
from exactspline.numbers.exact import text
from exactspline.testing import FAMILIES, REPORTED, VERSION, Case, all_cases
from workshop.grade import runner
from workshop.grade.__main__ import main
from workshop.grade.adapters import LIBRARIES
from workshop.grade.adapters.common import Given, with_weights
from workshop.grade.judge import CRASHED, DECLINED, INVENTED, MISSED, OFF, RIGHT, TOLERATED, WRONG, Verdict, judged
from workshop.grade.questions import QUESTIONS, TOLERANCES
from workshop.grade.recheck import recheck
from workshop.grade.report import BEGIN, END, PICTURE, draw, page, placed, rows
from workshop.grade.runner import Judged, Report, Truths, Worker, curve_data, failures, request_data
from workshop.grade.shrink import Defect, size_of, smaller_cases
from workshop.grade.tolerance import DOCUMENTED, tolerated
from workshop.grade.truth import truth

CASES = {case.key: case for case in all_cases(7)}
SAMPLE = [c for c in CASES.values() if c.curve.degree < 5]


@cache
def told(case, question):
    """The answer as it is sent."""
    return json.dumps(truth(case, question))


def answer_of(case, question):
    return json.loads(told(case, question))


def test_there_are_five_thousand_cases_of_doubles_each_once():
    cases = list(all_cases())
    families = Counter(case.family for case in cases)
    assert len(cases) >= 5000
    assert set(families) == set(FAMILIES)
    assert len({case.key for case in cases}) == len(cases)
    for case in cases[::50]:
        numbers = [*case.curve.knots, *case.curve.weights, case.parameter]
        numbers += [x for p in case.curve.control_points for x in p]
        assert all(xs.from_floats(float(x)) == x for x in numbers)
        assert case.curve.domain[0] <= case.parameter <= case.curve.domain[1]
    assert families["named"] == len(REPORTED) >= 15
    assert all(named.link.startswith("https://github.com/") and named.note for named in REPORTED)


def test_the_near_degenerate_ones_are_near_what_they_say():
    far = {c.key: c.curve for c in all_cases() if c.family == "near"}
    assert min(abs(x) for x in far["near 40 cusp"].derivative(1, "1/2")) == 0
    assert max(abs(x) for x in far["near 40 cusp"].derivative(1, "1/2")) <= mpq(1, 2**38)
    assert 0 < abs(far["near 40 touching"]("1/2")[1]) <= mpq(1, 2**38)


@pytest.mark.parametrize("question", QUESTIONS)
def test_exact_answers_are_accepted_by_the_independent_checker(question):
    asked = 0
    for case in SAMPLE:
        answer = answer_of(case, question)
        if answer is not None:
            recheck(curve_data(case), text(case.parameter), question, answer)
            asked += 1
    assert asked >= 1


def _spoiled(answer):
    """The answer with its last number, point or zero changed a little."""
    wrong = copy.deepcopy(answer)
    if "numbers" in wrong:
        low, high = (mpq(x) + max(abs(mpq(x)), 1) / 50 for x in wrong["numbers"][-1])
        wrong["numbers"][-1] = [text(low), text(high)]
    elif "curves" in wrong:
        wrong["curves"][-1]["rows"][-1][0] = text(mpq(wrong["curves"][-1]["rows"][-1][0]) + mpq(1, 10**6))
    else:
        # a constant plus 1 would be another multiple of the same form
        segment = max(wrong["certificates"], key=lambda c: c["degree"])["segments"][-1]
        segment["coefficients"][-1] = str(int(segment["coefficients"][-1]) + 1)
    return wrong


@pytest.mark.parametrize("question", QUESTIONS)
def test_false_answers_are_not_accepted(question):
    refused = 0
    for case in SAMPLE:
        answer = answer_of(case, question)
        constant = answer and max((c.get("degree", 1) for c in answer.get("certificates", [])), default=1) == 0
        nothing = answer is not None and answer.get("numbers") == []
        if answer is not None and not constant and not nothing and (question != "length" or case.family == "integers"):
            with pytest.raises(ValueError):  # noqa: PT011  # whatever the flaw
                recheck(curve_data(case), text(case.parameter), question, _spoiled(answer))
            refused += 1
    assert refused >= 1


def test_the_zeros_of_another_form_prove_nothing():
    """A right certificate about another function is refused: roots of x for roots of y."""
    case = CASES["integers 1"]
    swapped = Case("swapped", "test", case.curve.transform([[0, 1], [1, 0]]), case.parameter)
    with pytest.raises(ValueError, match="form"):
        recheck(curve_data(case), text(case.parameter), "roots", answer_of(swapped, "roots"))


def test_what_is_not_certified_is_not_judged(monkeypatch, tmp_path):
    case = CASES["integers 1"]
    truths = Truths(tmp_path / "truths.jsonl.gz")
    assert set(truths.of(case, ["value", "roots"])) == {"value", "roots"}
    truths.save()
    kept = Truths(tmp_path / "truths.jsonl.gz")
    assert kept.known == json.loads(json.dumps(truths.known))
    for answers in kept.known.values():
        answers["value"] = _spoiled(answers["value"])
    assert set(kept.of(case, ["value", "roots"])) == {"roots"}
    assert kept.uncertified == [(case.key, "value", "another derivative")]
    again = Truths(tmp_path / "truths.jsonl.gz")
    monkeypatch.setattr("workshop.grade.runner.truth", lambda *_: pytest.fail("it was kept"))
    assert set(again.of(case, ["value", "roots"])) == {"value", "roots"}


def exact_reply(case, question, answer):
    """What a perfect library would say in doubles."""
    if "numbers" in answer:
        numbers = [float(mpq(low)) for low, _ in answer["numbers"]]
        pairs = [list(pair) for pair in zip(numbers[::2], numbers[1::2], strict=False)]
        return pairs if question == "meetings" else numbers
    if "curves" in answer:
        return [[float(mpq(x)) for x in row] for part in answer["curves"] for row in part["rows"]]
    return [[float(mpq(r["low"])) for r in c["roots"]] for c in answer["certificates"]]


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_perfect_library_is_right_and_a_bad_one_is_not(question):
    for case in SAMPLE:
        answer = answer_of(case, question)
        if answer is None:
            continue
        reply = exact_reply(case, question, answer)
        assert judged(case, question, answer, {"answer": reply}).outcome == RIGHT, case.key
        assert judged(case, question, answer, {"raised": "KeyError"}).outcome == CRASHED
        assert judged(case, question, answer, {"declined": "no"}).outcome == DECLINED
        if question == "meetings":
            continue
        for nothing in (None, [], {}, "text", [None]):
            assert judged(case, question, answer, {"answer": nothing}).outcome == OFF
        if "certificates" in answer and "numbers" not in answer:
            continue
        size = max(1, *(abs(x) for p in case.curve.control_points for x in p))
        wrong = copy.deepcopy(reply)
        if isinstance(wrong[-1], list):
            wrong[-1][0] += float(size) / 100
        else:
            wrong[-1] += float(size) + 1
        assert judged(case, question, answer, {"answer": wrong}).outcome == OFF
        lost = (
            [[float("nan")] * len(row) for row in reply] if isinstance(reply[0], list) else [float("nan")] * len(reply)
        )
        assert judged(case, question, answer, {"answer": lost}).outcome == OFF


def case_of(points, key="here"):
    n = len(points)
    return Case(key, "test", xs.Nurbs(n - 1, [0] * n + [1] * n, points), mpq(1, 2))


def outcome(points, question, parameters):
    case = case_of(points)
    return judged(case, question, answer_of(case, question), {"answer": [parameters]}).outcome


def test_places_are_named_missed_and_invented():
    crossing = [(0, -1), (1, 1)]
    assert outcome(crossing, "roots", [0.5]) == RIGHT
    assert outcome(crossing, "roots", [0.5 + 2.0**-17]) == RIGHT
    assert outcome(crossing, "roots", [0.5 + 2.0**-13]) == MISSED
    assert outcome(crossing, "roots", []) == MISSED
    assert outcome(crossing, "roots", [0.5, 0.7]) == INVENTED
    assert outcome(crossing, "roots", [0.5, 1.5]) == INVENTED
    assert outcome(crossing, "roots", [0.5, 0.5]) == RIGHT
    touching = [(0, 1), (1, -1), (2, 1)]
    for answer in ([], [0.5], [0.5, 0.5], [0.4999999, 0.5000001]):
        assert outcome(touching, "roots", answer) == RIGHT
    assert outcome(touching, "roots", [0.4]) == INVENTED
    threefold = [(0, -1), (1, 1), (2, -1), (3, 1)]
    assert outcome(threefold, "roots", [0.5 + 2.0**-13]) == RIGHT
    assert outcome(threefold, "roots", [0.52]) == MISSED
    at_end = [(0, 0), (1, 1)]
    for answer in ([], [0.0], [2.0**-22]):
        assert outcome(at_end, "roots", answer) == RIGHT


@pytest.mark.parametrize(("e", "reply", "expected"), [
    # an inflection of a curve that is at most 10⁻⁹ from a straight line may be there or not, in both directions
    (mpq(1, 2**31), [], TOLERATED),
    # of one that is further away every such curve has it
    (mpq(1, 2**8), [], MISSED),
    # no curve within 10⁻⁷ has one there
    (mpq(1, 2**8), [2 / 3, 0.2], INVENTED),
])  # fmt: skip
def test_what_a_library_documents_is_a_class_of_its_own(e, reply, expected):
    """Judged as missed before, although the library documents that it does not tell such curves apart."""
    case = case_of([(0, 0), (1, 1 + e), (2, 2), (3, 3)])
    answer = answer_of(case, "inflections")
    missing = Verdict(MISSED, missed=(mpq(2, 3),)) if not reply else Verdict(INVENTED, invented=(mpq(1, 5),))
    assert tolerated("Open CASCADE", case, "inflections", missing, answer).outcome == expected
    # of a library that documents nothing nothing is tolerated
    assert tolerated("scipy", case, "inflections", missing, answer) == missing
    assert tolerated("Open CASCADE", case, "roots", missing, answer) == missing


def test_an_extremum_smaller_than_what_is_documented():
    """At a cusp that is rounded with a radius of 10⁻¹¹ the extremum may be missed, and named 10⁻⁸ beside it."""
    case = next(case for case in all_cases() if case.key == "near 16 cusp −")
    answer = answer_of(case, "extrema")
    assert tolerated("Open CASCADE", case, "extrema", Verdict(MISSED, missed=(mpq(1, 2),)), answer).outcome == TOLERATED
    for t, outcome in ((mpq(1, 2) + mpq(1, 10**5), TOLERATED), (mpq(3, 4), INVENTED)):
        beside = Verdict(MISSED, missed=(mpq(1, 2),), invented=(t,))
        found = tolerated("Open CASCADE", case, "extrema", beside, answer)
        assert (found.outcome, found.missed) == (outcome, ())
        assert "missed" not in found.note


@pytest.mark.parametrize(("e", "missed", "invented", "expected"), [
    # y = 257/256, and 2⁻¹⁰ nearer: s³ − 3Qs + 2R is above and below 10⁻¹⁰
    (mpq(1, 2**8), (mpq("0.473"),), (), TOLERATED),
    (mpq(1, 2**8), (mpq("0.473"),), (mpq(1, 2),), TOLERATED),
    (mpq(1, 2**8), (), (mpq("0.6"),), INVENTED),
    (mpq(1, 2**4), (mpq("0.4"),), (), MISSED),
])  # fmt: skip
def test_threefold_roots_are_documented_by_fonttools(e, missed, invented, expected):
    """Judged as missed before, although the examples of ``solveCubic`` say that such roots are taken for one."""
    case = case_of([(0, -1), (1, 1 + e), (2, -1 - e), (3, 1)])
    verdict = Verdict(MISSED if missed else INVENTED, missed=missed, invented=invented)
    assert tolerated("fontTools", case, "roots", verdict, {}).outcome == expected
    assert tolerated("bezier", case, "roots", verdict, {}) == verdict


def test_a_part_with_equal_weights_is_a_part_of_a_rational_curve():
    curve = xs.Nurbs(2, [0, 0, 0, 1, 1, 2, 2, 2], [(0, 0), (1, 2), (3, 1), (4, 0), (5, 3)], [1, 1, 1, 2, 1])
    case = Case("example", "example", curve, mpq(1))
    answer = answer_of(case, "split")
    assert [len(row) for part in answer["curves"] for row in part["rows"]] == [3] * 6
    recheck(curve_data(case), "1", "split", answer)


@pytest.mark.parametrize(("scale", "knots"), [(1, [0] * 4 + [1] * 4), (10**6, [3] * 4 + [3 + 10**4] * 4)])
def test_straight_is_what_a_tolerance_may_overlook_in_any_unit(scale, knots):
    missed = {}
    for bits in (12, 16, 24, 26, 40):
        points = [(0, 0), (scale, scale * (1 - mpq(1, 2**bits))), (2 * scale, 2 * scale), (3 * scale, 3 * scale)]
        case = Case("example", "example", xs.Nurbs(3, knots, points), mpq(knots[0]))
        missed[bits] = judged(case, "inflections", answer_of(case, "inflections"), {"answer": [[]]}).outcome
    assert missed == {12: MISSED, 16: MISSED, 24: RIGHT, 26: RIGHT, 40: RIGHT}


@pytest.mark.parametrize(("reply", "expected"), [
    ([[0.5, 0.5]], RIGHT),
    ([[0.5, 0.5], [0.5, 0.5 + 2.0**-17]], RIGHT),
    ([], MISSED),
    ([[0.5, 0.51]], MISSED),
    ([[0.5, 0.5], [0.25, 0.25]], INVENTED),
    ([[0.5, 0.5], [0.5, 1.5]], INVENTED),
    ([[float("nan"), 0.5]], OFF),
    ([["0.5"]], OFF),
    (None, OFF),
])  # fmt: skip
def test_pairs_of_parameters_are_named_missed_and_invented(reply, expected):
    """A cubic and its partner, of the control points 1, 3, 0, 2, meet in the middle of both alone."""
    case = case_of([(0, 0), (1, 1), (2, -1), (3, 0)])
    answer = answer_of(case, "meetings")
    assert [[mpq(x) for x in ends] for ends in answer["numbers"]] == [[mpq(1, 2)] * 2] * 2
    assert judged(case, "meetings", answer, {"answer": reply}).outcome == expected


@pytest.mark.parametrize(("library", "expected"), [("Open CASCADE", TOLERATED), ("bezier", INVENTED)])
def test_a_pair_of_points_that_a_library_takes_for_one(library, expected):
    """Curves 4·10⁻⁸ apart: a pair of their points is one that Open CASCADE documents to be no different."""
    k, reply = 26, {"answer": [[0.25, 0.25]]}
    case = replace(case_of([(0, 0), (1, 1), (2, 2), (3, 4)]), dial=k)
    answer = answer_of(case, "meetings")
    assert answer["numbers"] == []
    verdict = judged(case, "meetings", answer, reply)
    assert verdict.outcome == INVENTED
    assert tolerated(library, case, "meetings", verdict, answer, reply["answer"]).outcome == expected


def test_two_zeros_that_a_tolerance_cannot_tell_apart_are_one_place():
    def apart(k):
        e = mpq(1, 1 << (2 * k))
        return [(0, 1 - e), (1, -1 - e), (2, 1 - e)]

    assert outcome(apart(8), "roots", []) == MISSED
    assert outcome(apart(24), "roots", []) == RIGHT
    assert outcome(apart(24), "roots", [0.5]) == RIGHT


def test_a_curve_given_to_a_library_is_the_curve_of_the_case():
    for case in SAMPLE[::5]:
        given = Given.of(json.loads(json.dumps(request_data(case))))
        assert xs.Nurbs.from_floats(given.degree, given.knots, given.points, given.weights) == case.curve
        if given.finer:
            finer = xs.Nurbs.from_floats(given.finer.degree, given.finer.knots, given.finer.points, given.finer.weights)
            assert finer == case.curve
            assert len(finer.knots) == len(case.curve.knots) + 1
    assert with_weights([[1, 2], [3, 4]], [2, 1]) == [[1.0, 2.0, 1.0], [3.0, 4.0, 0.5]]


def test_smaller_examples_are_smaller():
    case = CASES["integers 3"]
    whole = Judged(case, "value", judged(case, "value", answer_of(case, "value"), {"raised": "x"}))
    for curve, t in smaller_cases(case):
        smaller = Judged(Case("", "", curve, t), "value", whole.verdict)
        assert t != case.parameter or size_of(smaller) < size_of(whole)


def test_the_page_tells_everything(tmp_path):
    case = CASES["integers 3"]
    verdict = judged(case, "value", answer_of(case, "value"), {"raised": "ValueError: no"})
    one = Judged(case, "value", verdict)
    right = Judged(case, "first", judged(case, "first", answer_of(case, "first"), {
        "answer": exact_reply(case, "first", answer_of(case, "first"))}))  # fmt: skip
    report, defect = Report("scipy", "1.0", [one, right]), Defect("scipy", "value", CRASHED, 1, one)
    written = page([report], [defect], [case, CASES["named geomdl-135"]], [("a", "box", "why")])
    assert "ValueError: no" in written
    assert "- a, box: why" in written
    assert "Of 1 answer to *value* 0 are right and 1 crashed." in written
    assert "| scipy 1.0 | 2 | 1 | 0 | 0 | 0 | 1 | 0 | 0 |" in written
    assert PICTURE in written
    assert all(each in written for each in DOCUMENTED.values())
    draw([report], str(tmp_path / "scoreboard.png"))
    assert (tmp_path / "scoreboard.png").stat().st_size > 1000
    assert "https://github.com/orbingol/NURBS-Python/issues/135" in written
    assert all(q.allowed in written for q in QUESTIONS.values())
    assert all(f"*{word}*: {meaning}" in written for word, meaning in TOLERANCES.items())
    page_there = tmp_path / "page.md"
    page_there.write_text(f"before\n{BEGIN}\nof old\n{END}\nafter\n", encoding="utf-8")
    assert placed(page_there, written) == f"before\n{written.strip()}\nafter\n"
    assert placed(tmp_path / "none.md", written) == written
    found = {row["question"]: row for row in rows([report], [defect])}
    assert (found["value"]["crashed"], found["first"]["right"]) == (1, 1)
    assert found["value"]["example"]["note"] == "ValueError: no"


def test_a_wrong_answer_can_be_tried_again():
    """Another program finds in the file what the library was given, what it replied, and what is true."""
    case = CASES["integers 1"]
    answer = answer_of(case, "value")
    replies = {"right": {"answer": exact_reply(case, "value", answer)}, "off": {"answer": [9.0, 9.0]}}
    verdicts = {name: judged(case, "value", answer, reply) for name, reply in replies.items()}
    assert [verdict.outcome for verdict in verdicts.values()] == [RIGHT, OFF]
    report = Report("x", "1", [Judged(case, "value", verdicts[name], replies[name], answer) for name in replies])
    [failure] = json.loads(json.dumps(list(failures([report]))))
    assert judged(case, failure["question"], failure["truth"], failure["reply"]) == verdicts["off"]
    assert failure["given"]["points"] == [[float(x) for x in point] for point in case.curve.control_points]


def test_the_program_prints_rows_under_its_schema(capsys, tmp_path):
    place = tmp_path / "failures.jsonl"
    assert main(["scipy", "--cases", "1", "--no-examples", "--json", "--failures", str(place)]) == 0
    wrong = [json.loads(line) for line in place.read_text(encoding="utf-8").splitlines()]
    data = json.loads(capsys.readouterr().out)
    jsonschema.validate(data, json.loads((Path(runner.__file__).parent / "schema.json").read_text(encoding="utf-8")))
    assert {row["library"] for row in data["rows"]} == {"scipy"}
    assert len(wrong) == sum(row[outcome] for row in data["rows"] for outcome in WRONG)
    assert len({row["key"] for row in data["rows"]}) == len(data["rows"]) > 5
    with pytest.raises(FormulaError, match="no library called 'scipi'"):
        main(["scipi"])


RESULTS = Path(__file__).resolve().parents[2] / "docs" / "measurements.md"


@pytest.mark.skipif(not RESULTS.exists(), reason="the documents are in the checkout only")
def test_the_page_says_what_is_asked_today():
    text = " ".join(RESULTS.read_text(encoding="utf-8").split())
    assert f"{sum(1 for _ in all_cases())} cases of version {VERSION} (" in text
    assert all(f"| {q.name} | {q.meaning} | {q.allowed} |" in text for q in QUESTIONS.values())
    assert all(named.link in text for named in REPORTED)
    assert all(f"| {library} " in text for library in LIBRARIES)


def test_what_a_process_started_ends_with_it(tmp_path):
    """Was left for good after a question that hung: thirty processes of node kept two cores busy."""
    place = tmp_path / "open while it runs"
    os.mkfifo(place)
    reading = os.open(place, os.O_RDONLY | os.O_NONBLOCK)
    code = (
        "import subprocess, sys, time; subprocess.Popen(['sleep', '600'], stdout=open(sys.argv[1], 'wb', 0));"
        'print(\'{"version": "1"}\', flush=True); time.sleep(600)'
    )
    worker = Worker("any", (sys.executable, "-c", code, str(place)))
    with pytest.raises(BlockingIOError):
        os.read(reading, 1)  # somebody could still write
    worker.close()
    assert select.select([reading], [], [], 20)[0]
    assert os.read(reading, 1) == b""
    os.close(reading)
