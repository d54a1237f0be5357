"""Answers as data, as records and as tables: made from the same answer, with nothing lost on the way."""

import copy
import json
import pickle
from functools import cache

import numpy as np
import pytest

import exactspline as xs
from exactspline import Real
from exactspline.display.sheet import Sheet
from exactspline.geometry.analysis.ask import REGISTRY, asked_of, facts_about, kind_of
from exactspline.hooks import Written
from exactspline.questions.entry import Of
from tests.support.command import invoke, run

OBJECTS = {
    Of.PLANE_CURVE: "cubic_s",
    Of.SPACE_CURVE: "twisted_cubic",
    Of.SURFACE: "enneper",
    Of.PLANAR_MAP: "folded_map",
}
#: A closed polynomial curve, which has an area.
SQUARE = xs.Nurbs(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0)])
#: What the questions are asked of that these objects have no answer to, or one after seconds.
ABOUT = {"area": SQUARE, "moments": SQUARE, "umbilics_within": xs.example("paraboloid")}


@cache
def asked(of):
    """All questions and their answers, once for all tests."""
    asked = []
    for entry in REGISTRY[of].values():
        if entry.name not in ("ridges", "stability"):
            about = ABOUT[entry.name] if entry.name in ABOUT else xs.example(OBJECTS[of])
            try:
                found = asked_of(about, entry.form)
                found.answer  # noqa: B018
            except xs.ExactSplineError:
                continue
            asked.append((entry, found))
    return asked


def answer_data(entry, found):
    """An answer as JSON."""
    return xs.tables.to_dict(found.facts, entry.form, 12)["answer"]


def numbers(data):
    """The doubles of all real numbers in data, in order."""
    if isinstance(data, dict) and "double" in data:
        yield data["double"]
    elif isinstance(data, dict | list):
        for each in data.values() if isinstance(data, dict) else data:
            yield from numbers(each)


@pytest.mark.parametrize("of", OBJECTS, ids=str)
def test_json_and_records_have_the_same_numbers(of):
    """Each question: a number that JSON has is in a record, and the other way round, but for exact text."""
    seen = 0
    for entry, found in asked(of):
        data = json.loads(json.dumps(answer_data(entry, found)))
        rows = xs.tables.to_records(found.facts, entry.form)
        floats = [x for row in rows for x in row.values() if isinstance(x, float)]
        assert set(numbers(data)) <= set(floats), entry.name
        seen += len(floats)
    assert seen > 5


@pytest.mark.parametrize("of", OBJECTS, ids=str)
def test_answers_fit_the_form_that_is_published(of):
    jsonschema = pytest.importorskip("jsonschema")
    from exactspline.display.answer_forms import form_of

    for entry, found in asked(of):
        jsonschema.validate(json.loads(json.dumps(answer_data(entry, found))), form_of(entry).schema)


def test_nothing_is_told_from_something_without_numbers():
    """Passed before: the two loops of the bisector of two ellipses, which have no ends, were *there is none*."""
    circle, ellipse = xs.example("circle"), xs.example("ellipse_skew")
    rows = xs.tables.to_records((circle, ellipse), "bisector")
    assert [row["what"] for row in rows] == ["closed correspondence of parameters"] * 2
    assert xs.bisector(circle, ellipse)._repr_html_().count("closed correspondence of parameters") == 2
    assert xs.tables.to_records(xs.example("twisted_cubic"), "plane") == []
    assert "there is none" in invoke("inspect", "twisted_cubic", "--ask", "plane").stdout


def test_records_make_a_data_frame_and_dictionaries_are_json():
    found = xs.tables.to_records(xs.example("six_segment_cubic"), "curvature_extrema")
    assert len(found) == 8
    assert {"what", "parameter", "x", "y", "curvature"} <= {*found[0]}
    data = xs.tables.to_dict(xs.example("six_segment_cubic"), "curvature_extrema")
    assert [each["parameter"]["double"] for each in data["answer"]["points"]] == [each["parameter"] for each in found]
    assert json.loads(json.dumps(data)) == data


@pytest.mark.parametrize("of", OBJECTS, ids=str)
def test_an_answer_writes_itself_as_its_question_is_written(of):
    """The numbers of the answer itself are those of the question, and it is a table in a notebook; not of a list that
    is a tuple of several answers.
    """
    seen = 0
    for entry, found in asked(of):
        answer = found.answer
        if isinstance(answer, Written):
            assert json.dumps(answer.to_dict(12)) == json.dumps(answer_data(entry, found)), entry.name
            own, rows = answer.to_records(), xs.tables.to_records(found.facts, entry.form)
            assert [[*row.values()][1:] for row in own] == [[*row.values()][1:] for row in rows], entry.name
            assert isinstance(answer, Real) or "<table" in answer._repr_html_()
            seen += 1
    assert seen > 1


def test_what_is_chosen_of_an_answer_is_written_too_but_not_what_nobody_asked_for():
    found = xs.example("six_segment_cubic").curvature_extrema
    maxima = found.where(lambda feature: feature.kind == "maximum")
    assert [row["parameter"] for row in maxima.to_records()] == np.array(maxima, float).tolist()
    assert 0 < len(maxima) < len(found)
    for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert (again, again.to_dict()) == (found, found.to_dict())
    unasked = type(found)(found.points)
    assert unasked == found
    with pytest.raises(xs.ExactSplineError, match=r"take it from exactspline\.ask"):
        unasked.to_dict()
    assert unasked._repr_html_() is None


def test_a_question_about_an_answer_is_asked_and_not_forgotten():
    """The bisector of two space curves is an answer, of which questions are asked."""
    curves = [xs.Nurbs(1, [0, 0, 1, 1], points) for points in ([(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (0, 1, 1)])]
    found = xs.bisector(*curves)
    assert isinstance(found, Written)
    questions = [name for name in REGISTRY[Of.PAIR] if xs.tables.to_dict(found, name)["question"] == name]
    assert questions == [*REGISTRY[Of.PAIR]]
    assert xs.tables.to_dict(found)["kind"] == "bisector of two curves"
    for call in (xs.tables.to_dict, xs.tables.to_records):
        with pytest.raises(xs.ExactSplineError):
            call(xs.square_root(2), "length")


def test_every_kind_of_object_is_tried():
    assert {kind_of(facts_about(xs.example(name))) for name in OBJECTS.values()} == {*OBJECTS}


def test_a_table_keeps_its_columns_where_prose_does_not_fit():
    """Blocks of three lines before; nothing is cropped, and the prose stands below its row."""
    names = ["curve", "degree", "points", "a heading that is as wide as a cell", "note"]
    sheet = Sheet(*names, rows=[("circle", 2, 9, "1.25 | -1.5", "a note of several words " * 3)], prose=["note"])
    lines = sheet.text(60).splitlines()
    assert lines[0].split()[:3] == names[:3]
    assert lines[1] == "    note"
    assert lines[2].split() == ["circle", "2", "9", "1.25", "|", "-1.5"]
    assert " ".join(" ".join(lines[3:]).split()) == ("a note of several words " * 3).strip()
    assert max(map(len, lines)) <= 60


def test_a_cell_with_two_numbers_is_broken_between_them():
    sheet = Sheet("what", "value", rows=[("limits", "1.23456789012 | -1.23456789012")], lists=["value"])
    lines = sheet.text(24).splitlines()
    assert [line.split() for line in lines] == [
        ["what", "value"], ["limits", "1.23456789012", "|"], ["-1.23456789012"],
    ]  # fmt: skip


def test_what_is_missing_is_in_every_form():
    """Left out of tables and records before: where the curve is straight and its line passes through the point."""
    asked = xs.example("straight_between_arcs"), "bisector:1/2,2"
    (why,) = xs.tables.to_dict(*asked)["answer"]["missing"]
    assert " ".join(why.split()) in " ".join(invoke("inspect", asked[0].name, "--ask", asked[1]).stdout.split())
    assert {"what": "missing", "value": why} in xs.tables.to_records(*asked)


@pytest.mark.parametrize(
    "arguments",
    [
        ["inspect", "twisted_cubic", "--ask", "bisector:1/2,2,1"],
        ["between", "twisted_cubic", "helix_like", "--ask", "bisector"],
        ["inspect", "cusp", "--ask", "bisector:1/2,2"],
        ["inspect", "straight_between_arcs", "--ask", "bisector:1/2,2"],
    ],
)
def test_a_bisector_has_one_status_and_its_points_in_every_form(arguments):
    """Before: a surface was answered as JSON and refused as a table; points of the table were not in the JSON."""
    data, table = run(*arguments, "--json"), run(*arguments, "--csv")
    assert data.returncode == table.returncode == 0
    (row,) = json.loads(data.stdout)["rows"]
    listed = table.stdout.splitlines()[1:]
    assert listed
    assert not any("no answer" in line for line in listed)
    shown = {line.rsplit(",", 1)[1] for line in listed} - {""}
    assert shown <= {repr(x) for x in numbers(row["answer"]["ends"])} if shown else "surface" in table.stdout
