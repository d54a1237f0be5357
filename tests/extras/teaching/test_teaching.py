"""Exercises: twenty a topic, solved by the checker; wrong answers of every kind are caught."""

import json
import re
import shlex
from fractions import Fraction
from functools import cache, partial
from math import comb
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner
from gmpy2 import mpq

from exactspline import Nurbs, example, rational
from exactspline.cli import app
from exactspline.extras.teaching import exercise
from exactspline.extras.teaching.answers import (
    AnswerError,
    Circle,
    Parameters,
    Points,
    Polynomials,
    numbers,
    points,
    polynomials,
)
from exactspline.extras.teaching.comparison import compare_curves, compare_formulas
from exactspline.extras.teaching.differences import (
    Invented,
    Missing,
    OtherDimension,
    OtherDomain,
    OtherNumber,
    OtherPoint,
    OtherValue,
    Wrong,
)
from exactspline.extras.teaching.display.exercises import html_page, latex_document, plain, text_lines
from exactspline.extras.teaching.exercises import LARGEST
from exactspline.extras.teaching.parts import Math
from exactspline.extras.teaching.topics import HINTS, TOPICS, TopicError, about, exercises
from exactspline.interchange.curve_files import curve_data
from exactspline.numbers.exact import point_text
from exactspline.papers import find
from tests.support.command import invoke

COUNT = 20
sheet = cache(partial(exercises, seed=0, count=COUNT))
topics = pytest.mark.parametrize("topic", TOPICS)


@topics
def test_the_checker_solves_every_exercise_and_the_answers_are_small(topic):
    for made in sheet(topic):
        assert made.answer.check(made.answer.written).right
        asked = re.sub(r"\^\d+", "", plain(made.task))
        told = made.answer.written.rpartition(",")[0] if topic in ("osculating", "circle") else made.answer.written
        assert all(int(number) <= LARGEST for number in re.findall(r"\d+", asked + told))
    assert len({plain(made.task) for made in sheet(topic)}) >= COUNT * 3 / 4
    assert sheet(topic)[7] == exercise(topic, 7)


def numbers_in(written):
    """Where the numbers of an answer stand; exponents are none of them."""
    return [m.span() for m in re.finditer(r"-?\d+(?:/\d+)?", written) if written[: m.start()][-1:] != "^"]


def wrong_answers(made):
    """Every number another one, its sign turned, one number left out, one too many, two exchanged."""
    written = made.answer.written
    for a, b in numbers_in(written):
        yield f"{written[:a]}{rational(written[a:b]) + 1}{written[b:]}"
        yield f"{written[:a]}{rational(written[a:b]) - mpq(1, 3)}{written[b:]}"
        if rational(written[a:b]):
            yield f"{written[:a]}{-rational(written[a:b])}{written[b:]}"
    parts = re.findall(r"\([^()]*, [^()]*\)", written) or written.split(", ")
    if len(parts) > 1:
        yield ", ".join(parts[:-1])
        for i in range(len(parts) - 1):
            if parts[i] != parts[i + 1] and not isinstance(made.answer, Parameters):
                yield ", ".join([*parts[:i], parts[i + 1], parts[i], *parts[i + 2 :]])
    yield ", ".join(
        [*([] if written in ("no", "none") else parts), parts[0] if "t" in written or "(" in written else "7"]
    )


@topics
def test_nothing_is_told_before_it_is_asked_for(topic):
    """Before: a wrong answer was met with the right one."""
    asked = ("teach", "check", "--topic", topic, "--seed", 2, "--text")
    made = exercise(topic, 2)
    for wrong in wrong_answers(made):
        if made.answer.written == wrong or made.answer.check(wrong):
            continue
        differences = made.answer.check(wrong).differences
        right = {f" is {point_text(each.right)}" for each in differences if isinstance(each, OtherPoint)}
        right |= {f" is {each.right}," for each in differences if isinstance(each, OtherNumber)}
        told = invoke(*asked, wrong).output
        assert told.startswith("wrong")
        assert not any(each in told for each in right)
        assert HINTS[topic][:30] in " ".join(invoke(*asked, wrong, "--hint").output.split())
        assert plain(made.answer.parts) in " ".join(invoke(*asked, wrong, "--show").output.split())


def test_a_sheet_of_several_topics_has_headings_and_lines_for_name_date_and_answers():
    made = [exercise("circle", 0), exercise("circle", 1), exercise("power", 0)]
    text = text_lines(made, 80, solutions=False)
    assert [line for line in text if line.startswith(("Whether", "Conversion"))] == [about("circle"), about("power")]
    asked = "no, or centre x, centre y, radius²", "no, or centre $x$, centre $y$, radius$^{2}$"
    pages = html_page(made, solutions=False), latex_document(made, solutions=False)
    for written, form in zip(pages, asked, strict=True):
        assert all(word in written for word in ("Name:", "Date:", form))
    assert invoke("teach", "exercise", "circle", "power", "--count", 2).output.count("[") >= 4


@topics
def test_a_wrong_answer_of_every_kind_is_caught(topic):
    caught = 0
    for made in sheet(topic):
        for wrong in wrong_answers(made):
            if wrong == made.answer.written:
                continue
            finding = made.answer.check(wrong)
            assert not finding, (made.answer.written, wrong)
            assert finding.differences
            caught += 1
        for unreadable in ("", "   ", "seven", "1/0", "(1, 2", "1e", "nan", "1; drop", "x = one"):
            with pytest.raises(AnswerError):
                made.answer.check(unreadable)
    assert caught >= 2 * COUNT


def basis(knots, n, i, t):
    """The recursion of Cox and de Boor, in Python's own fractions, knots before the last one."""
    if n == 0:
        return Fraction(knots[i] <= t < knots[i + 1])
    total = Fraction(0)
    if knots[i + n] > knots[i]:
        total += (t - knots[i]) / (knots[i + n] - knots[i]) * basis(knots, n - 1, i, t)
    if knots[i + n + 1] > knots[i + 1]:
        total += (knots[i + n + 1] - t) / (knots[i + n + 1] - knots[i + 1]) * basis(knots, n - 1, i + 1, t)
    return total


def lists_in(made):
    """The rows of numbers or points in a task, in order."""
    rows = [part.values for part in made.task if isinstance(part, Math)]
    return [[tuple(map(Fraction, map(str, v))) if isinstance(v, tuple) else Fraction(str(v)) for v in r] for r in rows]


def by_recursion(knots, points, t):
    n = len(knots) - len(points) - 1
    shares = [basis(knots, n, i, t) for i in range(len(points))]
    return tuple(sum(s * p[k] for s, p in zip(shares, points, strict=True)) for k in range(len(points[0])))


def test_evaluation_and_insertion_agree_with_the_recursion():
    """From the task alone, as a student reads it."""
    for made in sheet("evaluation"):
        knots, given, (t,) = lists_in(made)
        assert made.answer.check(", ".join(map(str, by_recursion(knots, given, t))))
    for made in sheet("insertion"):
        knots, given, (t,) = lists_in(made)
        found = [tuple(map(Fraction, map(str, row))) for row in points(made.answer.written, 2)]
        for place in (Fraction(1, 7), t, knots[-1] * Fraction(6, 7)):
            assert by_recursion(sorted([*knots, t]), found, place) == by_recursion(knots, given, place)


def test_bezier_points_and_powers_agree_with_bernstein():
    for topic in ("power", "bezier"):
        for made in sheet(topic):
            if topic == "power":
                (given,) = lists_in(made)
                polys = made.answer.values
            else:
                given = [tuple(map(Fraction, map(str, row))) for row in points(made.answer.written, 2)]
                polys = [part.values[0] for part in made.task if isinstance(part, Math)]
            n, t = len(given) - 1, Fraction(3, 7)
            for k, p in enumerate(polys):
                value = sum(Fraction(str(c)) * t**i for i, c in enumerate(p.coefficients))
                assert value == sum(comb(n, i) * t**i * (1 - t) ** (n - i) * b[k] for i, b in enumerate(given))


def test_circles_are_those_on_which_five_points_lie():
    said = set()
    for made in sheet("circle"):
        given, (_, w, _) = lists_in(made)
        on = []
        for t in (Fraction(0), Fraction(1, 4), Fraction(1, 2), Fraction(3, 4), Fraction(1)):
            b = [(1 - t) ** 2, 2 * t * (1 - t) * w, t * t]
            on.append(tuple(sum(s * p[k] for s, p in zip(b, given, strict=True)) / sum(b) for k in range(2)))
        # a conic that shares five points with a circle is that circle: the determinant of (x²+y², x, y, 1) vanishes
        rows = [(x * x + y * y, x, y, Fraction(1)) for x, y in on]
        flat = all(determinant([rows[i] for i in chosen]) == 0 for chosen in ((0, 1, 2, 3), (0, 1, 2, 4)))
        assert flat == bool(made.answer.values)
        said.add(flat)
        for x, y in on:
            if flat:
                cx, cy, square = (Fraction(str(v)) for v in made.answer.values)
                assert (x - cx) ** 2 + (y - cy) ** 2 == square
    assert said == {True, False}


def determinant(rows):
    if not rows:
        return Fraction(1)
    head, *rest = rows
    minors = [[row[:k] + row[k + 1 :] for row in rest] for k in range(len(head))]
    return sum((-1) ** k * head[k] * determinant(minor) for k, minor in enumerate(minors))


def test_what_differs_is_told():
    answer = Points(Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 4)]))
    found = answer.check("(0,0) (2,5)").differences
    assert found == (OtherPoint(1, (2, 4), (2, 5)), OtherValue(mpq(1), (2, 4), (2, 5)))
    assert list(map(str, found)) == [
        "control point 1 is (2, 4), not (2, 5)",
        "at t = 1 it gives (2, 5) instead of (2, 4)",
    ]
    # wrong at both ends alike, so that the witness is inside
    answer = Points(Nurbs(2, [0, 0, 0, 1, 1, 1], [(0, 0), (1, 1), (2, 0)]))
    assert answer.check("0 0\n1 3\n2 0").differences[-1] == OtherValue(mpq(1, 2), (1, mpq(1, 2)), (1, mpq(3, 2)))
    assert Parameters((mpq(1, 2),)).check("0.5")
    assert Parameters(()).check("none")
    assert Parameters((mpq(1, 2),)).check("none").differences == (Missing(mpq(1, 2)),)
    assert Parameters((mpq(1, 2),)).check("1/2, 1/3").differences == (Invented(mpq(1, 3)),)
    assert Circle(()).check("no")
    assert not Circle(()).check("0, 0, 1")
    assert not Circle((mpq(0), mpq(0), mpq(1))).check("no")


def test_polynomials_may_be_written_as_one_likes():
    right = Polynomials(("x(t)",), polynomials("1 - 3t + 2t^2"))
    for written in (
        "2t² − 3t + 1",
        "(1-t)(1-2t)",
        "(1-t)*(1 - 2*t)",
        "1-3·t+4t**2/2",
        "(t-1)^2 + t(t-1)",
        "1 + t(2t-3)",
    ):
        assert right.check(written), written
    for wrong in ("1 - 3t + 2t^3", "1 - 3t", "(1-t)(1-2t) + 1/1000000", "0", "1 - 3t + 2t^2, 0"):
        assert not right.check(wrong), wrong
    for unreadable in ("1/t", "t^t", "sin(t)", "2^-1", "t^61", "(t^60)^2", "s", "t.real", "1 if t else 2", "()"):
        with pytest.raises(AnswerError):
            right.check(unreadable)
    for hostile in ("-" * 299 + "(" * 200, "(" * 140 + "t" + ")" * 140 + "+", "((((9^60)^60)^60)^60)^60", "9^60^60"):
        with pytest.raises(AnswerError):
            polynomials(hostile)
    assert polynomials("-" * 290 + "t") == polynomials("t")
    assert numbers("[1, 0.5]") == (1, mpq(1, 2))


@pytest.mark.parametrize(
    ("topic", "written"),
    [
        ("evaluation", "x = -6, y = -7"),
        ("evaluation", "(-6, -7)"),
        ("support", "[1, 6]"),
        ("circle", "yes: centre (21/4, -3), r² = 225/16"),
        ("circle", "yes, (21/4, -3), 225/16"),
        ("subdivision", "b0 = (4, 4), b1 = (8, 8) and b2 = (11, 5)"),
        ("power", "x(t) = -3 + 6t + 9t^2 - 16t^3\ny(t) = 12t - 15t^2"),
        ("inflections", "t = 1/2"),
    ],
)
def test_an_answer_is_read_as_people_write_it(topic, written):
    """Names, brackets and `yes` were unreadable."""
    assert exercise(topic, 1).answer.check(written)


def test_no_and_none_mean_that_there_is_none():
    assert all(Parameters(()).check(each) for each in ("none", "None.", "no", "∅", "{}"))
    no_circle = next(made for seed in range(99) if not (made := exercise("circle", seed)).answer.values)
    assert no_circle.answer.check("No, it is not.")
    assert str(no_circle.answer.check("yes").differences[0]) == "it is not a circle"
    assert str(exercise("circle", 1).answer.check("no").differences[0]) == "it is a circle"  # was an empty line


@topics
def test_an_unreadable_answer_is_met_with_the_form_of_its_topic(topic):
    answer = exercise(topic, 1).answer
    with pytest.raises(AnswerError) as caught:
        answer.check("???")
    assert caught.value.remedy == f"write {answer.form}"


def test_curves_are_compared_as_functions():
    curve = example("rational_cubic")
    assert compare_curves(curve.elevate_degree().insert_knot("1/3"), curve)
    told = compare_curves(curve.reverse(), curve).differences
    assert told[0] is Wrong.REVERSED
    assert told[1] == OtherValue(mpq(0), curve(0), curve.reverse()(0))
    (domain,) = compare_curves(curve.restrict(0, "1/2"), curve).differences
    assert domain == OtherDomain(curve.domain, (0, mpq(1, 2)))
    assert str(domain) == "its domain is [0, 1/2], not [0, 1]"
    assert compare_curves(curve, example("twisted_cubic")).differences == (OtherDimension(3, 2),)


@pytest.mark.parametrize("width", [mpq(1, 10), mpq(1, 10**9)])
def test_curves_that_differ_on_a_short_segment(width):
    """Before, a parameter was looked for among all simple ones of the domain: without end on a segment of 10⁻⁹."""
    knots = [0, 0, 0, *[mpq(1, 2)] * 2, *[mpq(1, 2) + width] * 2, 1, 1, 1]
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (3, 0), (4, 0), (5, 0)]
    right = Nurbs(2, knots, points)
    point, value = compare_curves(Nurbs(2, knots, [*points[:3], (2, 2), *points[4:]]), right).differences
    assert (point.index, value.right) == (3, right(value.at))
    assert mpq(1, 2) < value.at < mpq(1, 2) + width


def test_formulas_are_compared_for_all_curves():
    given = find("f1")
    assert compare_formulas(given, find("f2"), "w")
    proof, value = compare_formulas(given, find("f2")).differences
    assert value.given != value.right
    told = str(proof), str(value)
    assert "the quotient is w" in told[0]
    left, right = re.search(r"gives (\S+) instead of (\S+)", told[1]).groups()
    assert rational(left) != rational(right)


def test_sheets_have_all_that_is_asked_and_answered():
    made = [sheet(topic)[0] for topic in TOPICS]
    lines = text_lines(made, 80, solutions=True)
    assert all(len(line) <= 80 for line in lines)
    assert "Solutions" in lines
    assert "Solutions" not in text_lines(made, 80, solutions=False)
    page = html_page(made, solutions=True)
    assert "http" not in page
    for math in re.findall(r"<math.*?</math>", page):
        ElementTree.fromstring(math)
    assert page.count("<li>") == 2 * len(TOPICS)
    document = latex_document(made, solutions=True)
    assert document.count(r"\item ") == 2 * len(TOPICS)
    bare = document.replace(r"\left(", "").replace(r"\right)", "").replace(r"\{", "").replace(r"\}", "")
    assert bare.count("{") == bare.count("}")
    assert document.count("$") % 2 == 0
    assert document.isascii() or set(re.findall(r"[^\x00-\x7f]", document)) <= {"é"}
    for name in re.findall(r"\\begin\{(\w+)\}", document):
        assert document.count(rf"\begin{{{name}}}") == document.count(rf"\end{{{name}}}")


PAGE = Path(__file__).parents[2] / "docs" / "teaching.md"


@pytest.mark.skipif(not PAGE.exists(), reason="the documents are in the checkout only")
def test_what_the_page_for_teachers_says_runs(tmp_path, monkeypatch):
    """Every command of the page, in a folder with the files that it names; its tables are what is printed."""
    monkeypatch.chdir(tmp_path)
    Path("answer.txt").write_text(exercise("insertion", 4).answer.written)
    Path("my-curve.json").write_text(json.dumps(curve_data(example("cubic_s").insert_knot("1/2"))))
    Path("mine.py").write_text(
        "from exactspline.language import det\n\n\ndef kappa(c):\n    return det(c.gamma.d(1), c.gamma.d(2)) * c.w**4\n"
    )
    page = PAGE.read_text(encoding="utf-8")
    lesson, rest = page.split("## Triangles of fractions")
    in_class = re.findall(r"^ *\./run (.*)$", lesson, flags=re.MULTILINE)
    taught = [CliRunner().invoke(app, shlex.split(re.split(r" > ", command)[0])) for command in in_class]
    assert [result.exit_code for result in taught] == [0, 0, 1]
    assert "hint: The control points of the segment" in taught[2].output
    commands = re.findall(r"^\./run (.*)$", rest, flags=re.MULTILINE)
    printed = []
    for command in commands:
        arguments = shlex.split(re.split(r" {3,}| > ", command)[0])
        result = CliRunner().invoke(app, arguments, env={"COLUMNS": "80"})
        assert result.exit_code == 0, (command, result.output)
        printed.append(result.output)
    assert len(commands) == 11
    shown_there = re.search(r"```\n(De Boor.*?)\n```", page, flags=re.DOTALL)[1]
    assert printed[0].startswith(shown_there)
    listed = set(re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (`.*?) \|", page, flags=re.MULTILINE))))
    assert listed == set(TOPICS)


def test_the_command_line(tmp_path):

    made = exercise("circle", 3)
    file = tmp_path / "answer.txt"
    file.write_text(made.answer.written)
    assert invoke("teach", "check", file, "--topic", "circle", "--seed", 3).exit_code == 0
    assert invoke("teach", "check", "-", "--topic", "circle", "--seed", 3, input=made.answer.written).exit_code == 0
    wrong = invoke("teach", "check", "--topic", "circle", "--seed", 3, "--text", "1, 2, 3")
    assert (wrong.exit_code, wrong.output.splitlines()[0]) == (1, "wrong")
    row = json.loads(invoke("teach", "exercise", "circle", "--seed", 3, "--solutions", "--json").stdout)["rows"][0]
    assert row["answer"] == made.answer.written
    assert "Solutions" not in invoke("teach", "exercise", "circle").output
    curve = tmp_path / "curve.json"
    curve.write_text(json.dumps(curve_data(example("cubic_s").elevate_degree())))
    assert invoke("teach", "check", curve, "--reference", "cubic_s").exit_code == 0
    assert invoke("teach", "check", curve, "--reference", "parabola").exit_code == 1
    formula = tmp_path / "mine.py"
    formula.write_text("from exactspline.language import det\n\n\ndef mine(c):\n    return det(c.p, c.p.d())\n")
    told = invoke("teach", "check", f"{formula}:mine", "--reference", "f2")
    assert told.exit_code == 1
    assert "not mine = f2" in told.output
    for arguments in (
        ["teach", "check", "--topic", "circle"],
        ["teach", "check", file],
        ["teach", "check", file, "--topic", "circle", "--reference", "cubic_s"],
        ["teach", "check", tmp_path, "--topic", "circle"],
        ["teach", "check", "--topic", "circel", "--text", "no"],
        ["teach", "check", "--topic", "circle", "--text", "perhaps"],
        ["teach", "exercise", "evaluatoin"],
        ["teach", "exercise", "circle", "--html", "--latex"],
    ):
        result = invoke(*arguments)
        assert isinstance(result.exception, ValueError), arguments
    with pytest.raises(TopicError):
        exercise("circle", -1)
