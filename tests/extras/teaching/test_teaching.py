"""Exercises: twenty a topic, solved by the checker; wrong answers of every kind are caught."""

import json
import re
import shlex
from fractions import Fraction
from functools import cache
from math import comb
from pathlib import Path
from xml.etree import ElementTree

import pytest
from gmpy2 import mpq

from exactspline import ExactSplineError, Nurbs, example, rational, write
from exactspline.extras.teaching import exercise
from tests.support.command import invoke

COUNT = 20
#: The largest integer in a task and in an answer.
LARGEST = 30
TOPICS = (
    "evaluation",
    "derivative",
    "insertion",
    "elevation",
    "subdivision",
    "product",
    "power",
    "bezier",
    "continuity",
    "support",
    "hull",
    "inflections",
    "curvature",
    "osculating",
    "circle",
    "weight",
)
topics = pytest.mark.parametrize("topic", TOPICS)


@cache
def sheet(topic):
    return [exercise(topic, seed) for seed in range(COUNT)]


def listed(*arguments):
    """The rows of a command of teaching."""
    return json.loads(invoke("teach", *arguments, "--json").stdout)["rows"]


@topics
def test_the_checker_solves_every_exercise_and_the_answers_are_small(topic):
    tasks = [row["task"] for row in listed("exercise", topic, "--count", COUNT)]
    for made, task in zip(sheet(topic), tasks, strict=True):
        assert made.answer.check(made.answer.written).right
        asked = re.sub(r"\^\d+", "", task)
        told = made.answer.written.rpartition(",")[0] if topic in ("osculating", "circle") else made.answer.written
        assert all(int(number) <= LARGEST for number in re.findall(r"\d+", asked + told))
    assert len({*tasks}) >= COUNT * 3 / 4
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
            if parts[i] != parts[i + 1] and made.topic != "inflections":
                yield ", ".join([*parts[:i], parts[i + 1], parts[i], *parts[i + 2 :]])
    yield ", ".join(
        [*([] if written in ("no", "none") else parts), parts[0] if "t" in written or "(" in written else "7"]
    )


@cache
def hint_of(topic):
    wrong = next(wrong_answers(exercise(topic, 1)))
    told = invoke("teach", "check", "--topic", topic, "--seed", 1, "--hint", "--text", wrong).output
    return " ".join(told.split("hint:")[1].split())


def test_every_topic_has_a_hint_of_its_own():
    assert len({*map(hint_of, TOPICS)}) == len(TOPICS)


@topics
def test_nothing_is_told_before_it_is_asked_for(topic):
    """Before: a wrong answer was met with the right one."""
    asked = ("teach", "check", "--topic", topic, "--seed", 2, "--text")
    made = exercise(topic, 2)
    for wrong in wrong_answers(made):
        if made.answer.written == wrong or made.answer.check(wrong):
            continue
        # the right values, as they are told where they are asked for
        said = map(str, made.answer.check(wrong).differences)
        right = {f" is {value}" for each in said for value in re.findall(r" is (.*), not ", each)}
        told = invoke(*asked, wrong).output
        assert told.startswith("wrong")
        assert not any(each in told for each in right)
        assert hint_of(topic) in " ".join(invoke(*asked, wrong, "--hint").output.split())
        shown = " ".join(invoke(*asked, wrong, "--show").output.split())
        assert listed("exercise", topic, "--seed", 2, "--solutions")[0]["solution"].rstrip(":") in shown


def test_a_sheet_of_several_topics_has_headings_and_lines_for_name_date_and_answers():
    asked = ("exercise", "circle", "power", "--count", 2)
    several = invoke("teach", *asked).stdout
    about = {row["key"]: row["about"] for row in listed("exercise")}
    assert [line for line in several.splitlines() if line in about.values()] == [about["circle"], about["power"]]
    assert several.count("[") >= 4
    form = "no, or centre x, centre y, radius²", "no, or centre $x$, centre $y$, radius$^{2}$"
    for option, each in zip(("--html", "--latex"), form, strict=True):
        written = invoke("teach", *asked, option).stdout
        assert all(word in written for word in ("Name:", "Date:", each))


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
            with pytest.raises(ExactSplineError):
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
    rows = [part.values for part in made.task if hasattr(part, "values")]
    return [[tuple(map(Fraction, map(str, v))) if isinstance(v, tuple) else Fraction(str(v)) for v in r] for r in rows]


def points(written):
    """The points of an answer."""
    return [tuple(map(Fraction, pair)) for pair in re.findall(r"\((\S+), (\S+)\)", written)]


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
        found = points(made.answer.written)
        for place in (Fraction(1, 7), t, knots[-1] * Fraction(6, 7)):
            assert by_recursion(sorted([*knots, t]), found, place) == by_recursion(knots, given, place)


def test_bezier_points_and_powers_agree_with_bernstein():
    for topic in ("power", "bezier"):
        for made in sheet(topic):
            if topic == "power":
                (given,) = lists_in(made)
                polys = made.answer.values
            else:
                given = points(made.answer.written)
                polys = [part.values[0] for part in made.task if hasattr(part, "values")]
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


@pytest.mark.parametrize(
    ("topic", "written", "told"),
    [
        ("inflections", "0.5", ()),
        ("inflections", "none", ("t = 1/2 is missing",)),
        ("inflections", "1/2, 1/3", ("t = 1/3 is not one of them",)),
        ("evaluation", "-6, -5", ("y is -7, not -5",)),
        (
            "subdivision",
            "(4, 4), (8, 9), (11, 5)",
            ("control point 1 is (8, 8), not (8, 9)", "at t = 1/4 it gives (31/4, 27/4) instead of (31/4, 25/4)"),
        ),
        (
            "subdivision",
            "(4, 4), (8, 8), (11, 6)",
            ("control point 2 is (11, 5), not (11, 6)", "at t = 1/2 it gives (11, 6) instead of (11, 5)"),
        ),
    ],
)
def test_what_differs_is_told(topic, written, told):
    assert tuple(map(str, exercise(topic, 1).answer.check(written).differences)) == told


#: The answer to this exercise is x(t) = -3 + 6t + 9t^2 - 16t^3, y(t) = 12t - 15t^2.
POWER = "-3 + 6t + 9t^2 - 16t^3, "


def test_polynomials_may_be_written_as_one_likes():
    right = exercise("power", 1).answer
    same = (
        "12t − 15t²",
        "3t(4-5t)",
        "3*t*(4 - 5*t)",
        "12·t-30t**2/2",
        "-15(t-4/5)t",
        "t(12 - 15t)",
        "-" * 240 + "(12t - 15t^2)",
    )
    for written in same:
        assert right.check(POWER + written), written
    for wrong in ("12t - 15t^3", "12t", "12t - 15t^2 + 1/1000000", "0", "12t - 15t^2, 0"):
        assert not right.check(POWER + wrong), wrong
    unreadable = ("1/t", "t^t", "sin(t)", "2^-1", "t^61", "(t^60)^2", "s", "t.real", "1 if t else 2", "()")
    hostile = ("-" * 299 + "(" * 200, "(" * 140 + "t" + ")" * 140 + "+", "((((9^60)^60)^60)^60)^60", "9^60^60")
    for written in (*unreadable, *hostile):
        with pytest.raises(ExactSplineError, match="write") as caught:
            right.check(POWER + written)
        assert caught.value.where == "answer"


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
    middle = exercise("inflections", 1).answer
    for none in ("none", "None.", "no", "∅", "{}"):
        assert [str(each) for each in middle.check(none).differences] == ["t = 1/2 is missing"]
    no_circle = next(made for seed in range(99) if not (made := exercise("circle", seed)).answer.values)
    assert no_circle.answer.check("No, it is not.")
    assert [str(no_circle.answer.check(each).differences[0]) for each in ("yes", "0, 0, 1")] == [
        "it is not a circle"
    ] * 2
    assert str(exercise("circle", 1).answer.check("no").differences[0]) == "it is a circle"  # was an empty line


@topics
def test_an_unreadable_answer_is_met_with_the_form_of_its_topic(topic):
    answer = exercise(topic, 1).answer
    with pytest.raises(ExactSplineError) as caught:
        answer.check("???")
    assert caught.value.remedy == f"write {answer.form}"


@pytest.fixture
def compared(tmp_path):
    """How a curve differs from another one, as it is told."""

    def told(given, reference):
        files = [str(tmp_path / f"{k}.json") for k in range(2)]
        for curve, file in zip((given, reference), files, strict=True):
            write(curve, file)
        result = invoke("teach", "check", files[0], "--reference", files[1], "--json")
        (row,) = json.loads(result.stdout)["rows"]
        assert result.exit_code == (0 if row["right"] else 1)
        return row["differences"]

    return told


def test_curves_are_compared_as_functions(compared):
    curve = example("rational_cubic")
    assert compared(curve.elevate_degree().insert_knot("1/3"), curve) == []
    first, second = compared(curve.reverse(), curve)
    assert first == "it is reversed"
    ends = [", ".join(map(str, curve(t))) for t in curve.domain[::-1]]
    assert second == "at t = 0 it gives ({}) instead of ({})".format(*ends)
    assert compared(curve.restrict(0, "1/2"), curve) == ["its domain is [0, 1/2], not [0, 1]"]
    assert compared(curve, example("twisted_cubic")) == ["it is in R2, not in R3"]


@pytest.mark.parametrize("width", [mpq(1, 10), mpq(1, 10**9)])
def test_curves_that_differ_on_a_short_segment(compared, width):
    """Before, a parameter was looked for among all simple ones of the domain: without end on a segment of 10⁻⁹."""
    knots = [0, 0, 0, *[mpq(1, 2)] * 2, *[mpq(1, 2) + width] * 2, 1, 1, 1]
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (3, 0), (4, 0), (5, 0)]
    right, other = (Nurbs(2, knots, [*points[:3], point, *points[4:]]) for point in ((2, 1), (2, 2)))
    point, value = compared(other, right)
    assert point == "control point 3 is (2, 1), not (2, 2)"
    at = rational(re.search(r"at t = (\S+) ", value)[1])
    assert mpq(1, 2) < at < mpq(1, 2) + width
    assert value.endswith(f"instead of ({', '.join(map(str, right(at)))})")


def test_sheets_have_all_that_is_asked_and_answered():
    assert [row["key"] for row in listed("exercise")] == [*TOPICS]
    asked = ("teach", "exercise", "all")
    lines = invoke(*asked, "--solutions").stdout.splitlines()
    assert all(len(line) <= 80 for line in lines)
    assert "Solutions" in lines
    assert "Solutions" not in invoke(*asked).stdout.splitlines()
    page = invoke(*asked, "--solutions", "--html").stdout
    assert "http" not in page
    for math in re.findall(r"<math.*?</math>", page):
        ElementTree.fromstring(math)
    assert page.count("<li>") == 2 * len(TOPICS)
    document = invoke(*asked, "--solutions", "--latex").stdout
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
    write(example("cubic_s").insert_knot("1/2"), "my-curve.json")
    Path("mine.py").write_text(
        "from exactspline.language import det\n\n\ndef kappa(c):\n    return det(c.gamma.d(1), c.gamma.d(2)) * c.w**4\n"
    )
    page = PAGE.read_text(encoding="utf-8")
    lesson, rest = page.split("## Triangles of fractions")
    in_class = re.findall(r"^ *\./run (.*)$", lesson, flags=re.MULTILINE)
    taught = [invoke(*shlex.split(re.split(r" > ", command)[0])) for command in in_class]
    assert [result.exit_code for result in taught] == [0, 0, 1]
    assert "hint: The control points of the segment" in taught[2].output
    commands = re.findall(r"^\./run (.*)$", rest, flags=re.MULTILINE)
    printed = []
    for command in commands:
        arguments = shlex.split(re.split(r" {3,}| > ", command)[0])
        result = invoke(*arguments, env={"COLUMNS": "80"})
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
    write(example("cubic_s").elevate_degree(), curve)
    assert invoke("teach", "check", curve, "--reference", "cubic_s").exit_code == 0
    assert invoke("teach", "check", curve, "--reference", "parabola").exit_code == 1
    formula = tmp_path / "mine.py"
    kappa = (
        "from exactspline.language import det\n\n\ndef mine(c):\n    return det(c.gamma.d(1), c.gamma.d(2)) * c.w**4\n"
    )
    formula.write_text(kappa)
    asked = ("teach", "check", f"{formula}:mine", "--reference", "f2")
    assert invoke(*asked, "--factor", "w").exit_code == 0
    told = invoke(*asked)
    assert told.exit_code == 1
    assert "not mine = f2" in told.output
    assert "the quotient is w" in told.output
    given, right = re.search(
        r"gives (\S+) instead of (\S+)", " ".join(invoke(*asked, "--show").output.split())
    ).groups()
    assert rational(given) != rational(right)
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
    with pytest.raises(ExactSplineError, match="is not a seed"):
        exercise("circle", -1)
